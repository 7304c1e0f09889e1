//! A machine in contact with some of its stops, or with none, sliding or sticking where there is friction,
//! with tables of everything that is watched on it.
//!
//! What is watched is a function z(t) of time along the motion: a gap; the force of a stop that is rested on
//! or that gives way, in the unit of gaps; where there is friction, the velocity of what slides, per radian,
//! and by how much what sticks could hold more. It is the sum of a known function (of p and of the stops'
//! motion) and of a functional on the homogeneous y, about whose time steps everything is in tables.
//!
//! # Cells
//!
//! The period is cut into cells, on levels: on each level they are half as wide as on the level above. On the
//! finest a cell is at most 1/R wide, R the largest rate of any pair, of forcing and of stops, so that z is a
//! polynomial of 16 terms in x ∈ [−1, 1]: what is left out is below 2⁻¹⁶/16! < 10⁻¹⁸ of the amplitude. On the
//! coarsest, forcing, stops and p still are such polynomials, but not the fast pairs. What of z does not
//! depend on y is in a table for each cell, down to the level of at most [`TABLED`] cells; below, it is the
//! polynomial of the tabled cell, seen on a part of it. So fast modes need no memory, and time only where
//! they are looked at.
//!
//! # The bound
//!
//! On each level a head (c₀, c₁, c₂, tail) with |z(x) − c₀ − c₁x − c₂x²| ≤ tail for |x| ≤ 1 is four
//! functionals on y and |y|:
//!
//! - of a pair with rate ≤ 1/(cell's width), the Taylor coefficients, and as tail Σ_{k≥3} |c_k|, entry by
//!   entry of y;
//! - of a faster pair, c₀ = c₁ = c₂ = 0 and as tail a bound on sup |g E(s)| over the cell, entry by entry
//!   (`Pair::supremum`).
//!
//! Where the head says that z is above the minimum depth on a whole cell, the cell is passed over, else its
//! halves are looked at, and on the finest level the polynomial is searched. So no minimum below −depth is
//! passed over, and a fast mode costs only where its amplitude can still move z to the stop. Rounding is in
//! the tail: 10⁻¹⁴ of all that was added up.

use std::f64::consts::{PI, TAU};

use super::{
    holds::{Holds, SoftStops, What},
    smooth::SmoothStage,
};
use crate::{
    error::{Error, Result},
    many::{
        Grip, LinearEquations, LinearFlow, RealMatrix, RealVector, State,
        algebra::stacked,
        brace::Brace,
        contact::{Contacts, Watch},
        equations::HeldRows,
        smooth::{Smooth, SwitchOf},
    },
    motion::{
        Series, Time,
        minimum::{Head, ROUNDING, head},
    },
};

/// Coefficients of a polynomial.
pub(super) const TERMS: usize = 16;

/// On levels with more cells nothing is in tables of one row per cell.
const TABLED: usize = 1 << 13;

/// Of a motion that needs tables on all levels, more cells than this are refused: some 10 MB for each thing
/// watched.
const MOST_TABLED: f64 = 65536.0;

/// Finer grids than this are refused: places in a cell could not be told apart in floats.
const MOST_CELLS: f64 = 1.1e12;

/// Numbers side by side.
const LANES: usize = 4;

#[derive(Debug)]
pub(crate) struct Stage {
    pub holds: Holds,
    /// How many independent rows stick.
    stuck: usize,
    /// What bounds the forces of what sticks.
    pub braces: Vec<Brace>,
    /// The friction that would slide, but goes with what is held.
    still: Vec<usize>,
    /// The soft stops that push, ascending.
    pub pushing: Vec<usize>,
    /// The equations with the forces of soft stops, not resting on any other.
    pub equations: LinearEquations,
    /// Where forces are formulas, that of the machine linearised at rest.
    pub flow: LinearFlow,
    /// Where forces are formulas, how it moves; then nothing is in tables.
    pub smooth: Option<SmoothStage>,
    /// From the stage's own coordinates, the columns b_j, back:
    /// [`Constrained`](crate::many::equations::Constrained).
    reduced: Option<(RealMatrix, RealMatrix, RealMatrix)>,
    positions: Vec<Series>,
    /// The velocities of the surfaces on which it sticks.
    surfaces: Vec<Series>,
    pub watched: Vec<What>,
    /// Each as a functional on y, and its known part but for p.
    watches: Vec<(RealVector, Series)>,
    /// From coarse to fine.
    pub levels: Vec<Level>,
    /// Of the finest level, for each thing watched: 16 functionals on y, one after the other.
    rows: Vec<Vec<f64>>,
    /// The finest level with tables for each cell.
    tabled: usize,
    /// Of that level, for each thing watched and each cell.
    drive: Vec<Vec<[f64; TERMS]>>,
    /// Entries of y, filled up to a multiple of 4.
    padded: usize,
}

/// Cells of one width.
#[derive(Debug)]
pub(crate) struct Level {
    pub half: f64,
    step: Step,
    /// For each thing watched, four functionals by fours of y: c₀, c₁, c₂ on y and the tail on |y|.
    heads: Vec<Vec<[f64; 4 * LANES]>>,
    /// For each thing watched and each cell; empty on levels without tables.
    drive: Vec<Vec<Head>>,
}

/// From a cell's beginning to its end.
#[derive(Debug)]
enum Step {
    /// y_i ↦ own_i y_i + other_i y_{i^1}, by fours.
    Pairs(Vec<[f64; 2 * LANES]>),
    Whole(RealMatrix),
}

impl Stage {
    /// Rigid stops are not watched if the motion is to pass through them.
    ///
    /// # Errors
    /// Dependent rows among the stops rested on; motions too fast for the grid.
    pub fn new(
        equations: &LinearEquations,
        contacts: &Contacts,
        holds: &Holds,
        through: bool,
        formulas: Option<&Smooth>,
    ) -> Result<Stage> {
        let Holds { resting, soft, grips, below } = holds;
        let whole = formulas;
        let mode = formulas.filter(|all| !all.switches().is_empty()).map(|all| all.in_mode(below, grips));
        let formulas = mode.as_ref().or(formulas);
        let (all, rubs) = (contacts.all(), contacts.rubs());
        let watched = |j: usize| !(resting.contains(&j) || through && all[j].soft.is_none());
        let leaning = soft.pushing.iter().map(|&j| (&all[j], contacts.along(j, grips)));
        let pushed = equations.pushed_along(leaning);
        let dragged = pushed.dragged(rubs.iter().zip(grips.iter().map(|grip| grip.sign())));
        let equations = &dragged;
        let mut watches: Vec<(What, Watch)> = Vec::new();
        let own = |j: &usize| all[*j].force.is_none();
        for (j, contact) in all.iter().enumerate().filter(|(j, _)| watched(*j) && own(j)) {
            if soft.pushing.contains(&j) {
                watches.push((What::Push(j), contact.push_watch(1.0)));
            } else if soft.behind.contains(&j) {
                watches.push((What::Pull(j), contact.push_watch(-1.0)));
                watches.push((What::Rise(j), contact.gap_watch(-1.0)));
            } else {
                watches.push((What::Gap(j), contact.gap_watch(1.0)));
            }
        }
        let rows = holds.rows(contacts);
        let slides = |j: &usize| grips[*j].slides();
        let still: Vec<usize> =
            (0..grips.len()).filter(slides).filter(|&j| contacts.follows(j, &rows)).collect();
        for (j, (rub, grip)) in rubs.iter().zip(grips).enumerate() {
            if grip.slides() && !still.contains(&j) {
                watches.push((What::Slide(j), rub.rate_watch(grip.sign())));
            }
        }
        for &k in formulas.map_or(&[][..], Smooth::reached) {
            watches.push((What::Kink(k), Watch::constant(equations.size(), 0.0)));
        }
        let (mut reduced, mut positions) = (None, Vec::new());
        let mut smooth = None;
        let stuck = holds.held(contacts);
        let braces = contacts.braces(&holds.stuck().collect::<Vec<_>>())?;
        // Where forces are formulas the linear flow carries no motion: it tells the scales and the modes of
        // one.
        let linearised = whole.map(|formulas| formulas.linearised(equations));
        let flow = if rows.is_empty() {
            if let Some(formulas) = formulas {
                smooth =
                    Some(SmoothStage::new((formulas, below), equations, contacts, &watches, grips, None)?);
            }
            LinearFlow::new(linearised.unwrap_or_else(|| equations.clone()))?
        } else {
            let forces = contacts.forces(equations, &rows, grips)?;
            let rested = resting.iter().zip(&forces);
            watches.extend(rested.map(|(j, watch)| (What::Force(*j), watch.clone())));
            for (i, brace) in braces.iter().enumerate() {
                let bound = |side: Grip| (What::Hold(i, side), holds.bound(contacts, &forces, brace, side));
                watches.extend([Grip::Forward, Grip::Backward].map(bound));
            }
            let leans = contacts.leans(&rows, grips);
            let along = || {
                let columns: Vec<RealVector> = rows.iter().map(|&row| contacts.along(row, grips)).collect();
                RealMatrix::from_columns(&columns)
            };
            let held = HeldRows {
                along: leans.then(along),
                stops: resting.iter().map(|&j| contacts.held_row(j)).collect(),
                stuck: stuck.iter().map(|&j| (&rubs[j].row, rubs[j].velocity())).collect(),
            };
            let mut constrained = equations.constrained(&held)?;
            if let (Some(formulas), Some(linearised)) = (formulas, linearised) {
                let held = linearised.constrained(&held)?;
                let both = Some((&rows[..], &forces[..], &constrained, &braces[..]));
                smooth =
                    Some(SmoothStage::new((formulas, below), equations, contacts, &watches, grips, both)?);
                constrained.equations = held.equations;
            }
            positions = resting.iter().map(|&j| all[j].position.clone()).collect();
            reduced = Some((constrained.free, constrained.lift, constrained.down));
            LinearFlow::new(constrained.equations)?
        };
        let surfaces: Vec<Series> = stuck.iter().map(|&j| rubs[j].velocity()).collect();
        let mut stage = Stage {
            holds: holds.clone(),
            stuck: surfaces.len(),
            braces,
            still,
            pushing: pushing(soft, formulas, below),
            equations: equations.clone(),
            padded: flow.dimension().next_multiple_of(LANES),
            flow,
            smooth,
            reduced,
            positions,
            surfaces,
            watched: watches.iter().map(|known| known.0).collect(),
            watches: Vec::new(),
            levels: Vec::new(),
            rows: Vec::new(),
            drive: Vec::new(),
            tabled: 0,
        };
        if stage.smooth.is_some() {
            return Ok(stage);
        }
        // What is watched is written on the flow's coordinates, so the stage must be there first.
        let watches = watches.iter().map(|(_, watch)| stage.reduce(watch)).collect::<Vec<_>>();
        stage.fill(&watches)?;
        stage.watches = watches;
        Ok(stage)
    }

    /// What is watched as a functional on y, and its known part but for p.
    fn reduce(&self, watch: &Watch) -> (RealVector, Series) {
        let Some((free, lift, _)) = &self.reduced else {
            return (self.flow.seen(&watch.places, &watch.rates), watch.given.clone());
        };
        let g = self.flow.seen(&free.tr_mul(&watch.places), &free.tr_mul(&watch.rates));
        let speeds: Vec<Series> = self.positions.iter().map(Series::derivative).collect();
        let mut parts = vec![(1.0, &watch.given)];
        for (j, (place, speed)) in self.positions.iter().zip(&speeds).enumerate() {
            parts.push((lift.column(j).dot(&watch.places), place));
            parts.push((lift.column(j).dot(&watch.rates), speed));
        }
        (g, Series::combination(&parts))
    }

    fn fill(&mut self, watches: &[(RealVector, Series)]) -> Result<()> {
        let rates = self.flow.rates();
        let order = self.flow.equations().force.order();
        let order = watches.iter().map(|known| known.1.order()).fold(order, u32::max);
        // What p contains besides the forcing's frequencies: responses from rest in every period.
        let parts = watches.iter().map(|(g, _)| self.flow.drive(g)).collect::<Result<Vec<_>>>()?;
        let whole = self.flow.pairs().is_none();
        let secular = |i: usize| whole || self.flow.step().rows(2 * i, 2).amax() != 0.0;
        let slow =
            (0..rates.len()).filter(|&i| secular(i)).map(|i| rates[i]).fold(f64::from(order), f64::max);
        let fast = rates.iter().copied().fold(slow, f64::max);
        let coarse = (TAU * slow).ceil().max(8.0);
        if coarse.is_nan() || coarse > MOST_TABLED {
            let most = MOST_TABLED / TAU;
            return Err(Error::input(format!(
                "a motion without stiffness, or near resonance, is damped {slow:.1e} times as fast as the forcing; at most \
                 {most:.0} times can be followed: leave that part out"
            )));
        }
        let depth = (TAU * fast / coarse).log2().ceil().max(0.0);
        if depth.is_nan() || coarse * depth.exp2() > MOST_CELLS {
            let most = MOST_CELLS / TAU / 2.0;
            return Err(Error::input(format!(
                "the fastest motion has {fast:.1e} times the forcing's frequency; at most {most:.0e} times can be followed: \
                 leave such stiff parts out of `stiffness`, or such modes out of `modes`"
            )));
        }
        let (coarse, depth) = (coarse as usize, depth as usize);
        self.tabled = (0..=depth).rev().find(|level| coarse << level <= TABLED).unwrap_or(0);
        let known: Vec<Series> = watches
            .iter()
            .zip(&parts)
            .map(|((_, given), (periodic, _))| Series::combination(&[(1.0, given), (1.0, periodic)]))
            .collect();
        let resonant = parts.iter().any(|(_, rest)| rest.amax() != 0.0);
        for level in 0..=depth {
            let half = PI / (coarse as f64 * (level as f64).exp2());
            let heads = watches.iter().map(|(g, _)| self.heads(g, half, level == depth)).collect();
            let mut drive: Vec<Vec<Head>> = vec![Vec::new(); watches.len()];
            let mut polynomials: Vec<Vec<[f64; TERMS]>> = vec![Vec::new(); watches.len()];
            let cells = if level <= self.tabled { coarse << level } else { 0 };
            for cell in 0..cells {
                let t = (2 * cell + 1) as f64 * half;
                let particular = if resonant { self.flow.expand(t, half, TERMS) } else { Vec::new() };
                for (i, ((_, rest), given)) in parts.iter().zip(&known).enumerate() {
                    let mut polynomial = [0.0; TERMS];
                    if resonant {
                        polynomial = std::array::from_fn(|k| rest.dot(&particular[k]));
                    }
                    given.add_taylor(1.0, t, half, &mut polynomial);
                    drive[i].push(head(&polynomial));
                    if level == self.tabled {
                        polynomials[i].push(polynomial);
                    }
                }
            }
            self.levels.push(Level { half, step: self.step(2.0 * half), heads, drive });
            if level == self.tabled {
                self.drive = polynomials;
            }
            if level == depth {
                self.rows = watches.iter().map(|(g, _)| self.functionals(g, half)).collect();
            }
        }
        Ok(())
    }

    /// What of z does not depend on y, on a cell of a level at or below that of the tables.
    fn driven(&self, level: usize, watch: usize, cell: usize) -> [f64; TERMS] {
        let finer = level - self.tabled;
        let whole = &self.drive[watch][cell >> finer];
        if finer == 0 {
            return *whole;
        }
        // x ↦ middle + x/2^finer of the tabled cell.
        let scale = (-(finer as f64)).exp2();
        let part = cell & ((1 << finer) - 1);
        let middle = (2 * part + 1) as f64 * scale - 1.0;
        let mut shifted = *whole;
        for i in 0..TERMS {
            for k in (i..TERMS - 1).rev() {
                shifted[k] += middle * shifted[k + 1];
            }
        }
        let mut power = 1.0;
        for coefficient in &mut shifted {
            *coefficient *= power;
            power *= scale;
        }
        shifted
    }

    /// The Taylor coefficients of x ↦ g E(half (1 + x)), as functionals on y at a cell's beginning.
    fn taylor(&self, g: &RealVector, half: f64) -> Vec<RealVector> {
        let mut first = g.clone();
        self.flow.pull(&mut first, half);
        let mut all = vec![first];
        for k in 1..TERMS {
            let next = self.flow.generate_row(&all[k - 1]) * (half / k as f64);
            all.push(next);
        }
        all
    }

    fn functionals(&self, g: &RealVector, half: f64) -> Vec<f64> {
        let mut rows = vec![0.0; TERMS * self.padded];
        for (k, row) in self.taylor(g, half).iter().enumerate() {
            rows[k * self.padded..][..row.len()].copy_from_slice(row.as_slice());
        }
        rows
    }

    /// The head's functionals for cells of this width, the finest or not.
    fn heads(&self, g: &RealVector, half: f64, finest: bool) -> Vec<[f64; 4 * LANES]> {
        let n = g.len();
        let mut rows = [(); 4].map(|()| vec![0.0; self.padded]);
        let (taylor, slope) = (self.taylor(g, half), self.flow.generate_row(g));
        let (rates, pairs) = (self.flow.rates(), self.flow.pairs());
        for i in 0..n {
            match &pairs {
                Some(pairs) if !finest && rates[i / 2] * half > 0.5 => {
                    rows[3][i] = pairs[i / 2].supremum(g[i], slope[i], 2.0 * half) * (1.0 + ROUNDING);
                }
                _ => {
                    for k in 0..3 {
                        rows[k][i] = taylor[k][i];
                        rows[3][i] += ROUNDING * taylor[k][i].abs();
                    }
                    rows[3][i] += taylor[3..].iter().map(|row| row[i].abs()).sum::<f64>();
                }
            }
        }
        (0..self.padded / LANES)
            .map(|part| std::array::from_fn(|i| rows[i / LANES][part * LANES + i % LANES]))
            .collect()
    }

    fn step(&self, width: f64) -> Step {
        if self.flow.pairs().is_none() {
            return Step::Whole(self.flow.matrix(width));
        }
        let n = self.flow.dimension();
        // Column by column of all pairs at once: even entries, then odd ones.
        let mut columns = [0, 1].map(|odd| {
            let mut y = RealVector::from_fn(n, |i, _| f64::from(u8::from(i % 2 == odd)));
            self.flow.advance(&mut y, width);
            y
        });
        for (i, pair) in self.flow.pairs().into_iter().flatten().enumerate() {
            let [[a, _], [_, d]] = pair.generator();
            let entries =
                [columns[0][2 * i], columns[1][2 * i], columns[0][2 * i + 1], columns[1][2 * i + 1]];
            let [a, b, c, d] = of_determinant(entries, ((a + d) * width).exp());
            (columns[0][2 * i], columns[1][2 * i]) = (a, b);
            (columns[0][2 * i + 1], columns[1][2 * i + 1]) = (c, d);
        }
        let entry = |i: usize, j: usize| if i < n { columns[j % 2][i] } else { 0.0 };
        let part = |part: usize| {
            std::array::from_fn(|k| {
                let i = part * LANES + k % LANES;
                if k < LANES { entry(i, i) } else { entry(i, i + 1) }
            })
        };
        Step::Pairs((0..self.padded / LANES).map(part).collect())
    }

    /// The finest level.
    pub fn finest(&self) -> &Level {
        &self.levels[self.levels.len() - 1]
    }

    /// Cells in a period on the finest level.
    pub fn cells(&self) -> usize {
        (PI / self.finest().half).round() as usize
    }

    /// z on a cell of a level, as far as it can be had cheaply.
    #[inline]
    pub fn head(&self, level: usize, watch: usize, cell: usize, y: &[f64]) -> Head {
        let table = &self.levels[level];
        let mut sums = [[0.0; LANES]; 4];
        for (rows, y) in table.heads[watch].iter().zip(y.chunks_exact(LANES)) {
            for i in 0..LANES {
                sums[0][i] += rows[i] * y[i];
                sums[1][i] += rows[LANES + i] * y[i];
                sums[2][i] += rows[2 * LANES + i] * y[i];
                sums[3][i] += rows[3 * LANES + i] * y[i].abs();
            }
        }
        let drive = match table.drive[watch].get(cell) {
            Some(drive) => *drive,
            None => head(&self.driven(level, watch, cell)),
        };
        std::array::from_fn(|k| drive[k] + ((sums[k][0] + sums[k][1]) + (sums[k][2] + sums[k][3])))
    }

    /// z on a cell of the finest level, and the sum of the moduli of what c₀ was added up from.
    pub fn polynomial(&self, watch: usize, cell: usize, y: &[f64]) -> ([f64; TERMS], f64) {
        let mut polynomial = self.driven(self.levels.len() - 1, watch, cell);
        let driven = polynomial[0];
        let rows = &self.rows[watch];
        for (k, coefficient) in polynomial.iter_mut().enumerate() {
            *coefficient += dot(&rows[k * self.padded..][..self.padded], y);
        }
        let size = rows[..self.padded].iter().zip(y).map(|(a, b)| (a * b).abs()).sum::<f64>();
        (polynomial, size + driven.abs())
    }

    /// What y adds to dz/dx at x on a cell of the finest level.
    pub fn slope(&self, watch: usize, x: f64, y: &[f64]) -> f64 {
        let rows = &self.rows[watch];
        let term = |k: usize| dot(&rows[k * self.padded..][..self.padded], y);
        (1..TERMS).rev().fold(0.0, |sum, k| sum * x + k as f64 * term(k))
    }

    /// y from a cell's beginning to its end.
    #[inline]
    pub fn turn(&self, level: usize, y: &mut [f64]) {
        match &self.levels[level].step {
            Step::Pairs(parts) => {
                for (part, y) in parts.iter().zip(y.chunks_exact_mut(LANES)) {
                    let old = [y[0], y[1], y[2], y[3]];
                    let other = [y[1], y[0], y[3], y[2]];
                    for i in 0..LANES {
                        y[i] = part[i] * old[i] + part[LANES + i] * other[i];
                    }
                }
            }
            Step::Whole(matrix) => {
                let n = matrix.nrows();
                let next = matrix * RealVector::from_column_slice(&y[..n]);
                y[..n].copy_from_slice(next.as_slice());
            }
        }
    }

    /// The forces of the stops rested on, as the accelerations that they prevent, at t in [0, 2π].
    pub fn forces(&self, t: f64, y: &RealVector) -> Vec<f64> {
        let whole = y + self.flow.particular(t);
        let all = self.watched.iter().zip(&self.watches);
        let forces = all.filter(|(what, _)| matches!(what, What::Force(_)));
        forces.map(|(_, (g, given))| g.dot(&whole) + given.at(t)[0]).collect()
    }

    /// How it moves at each row with friction, with what goes with what is held as what sticks, whichever of
    /// them holds it.
    pub fn grips(&self) -> Vec<Grip> {
        let one = |(j, grip): (usize, &Grip)| if self.still.contains(&j) { Grip::Stuck } else { *grip };
        self.holds.grips.iter().enumerate().map(one).collect()
    }

    /// The force of a stop that is rested on or gives way, at a state; 0 of any other.
    pub fn pressing(&self, contacts: &Contacts, stop: usize, time: Time, state: &State) -> f64 {
        if let Some(i) = self.holds.resting.iter().position(|&known| known == stop) {
            let all = match &self.smooth {
                Some(smooth) => smooth.forces(time, state),
                None => self.forces(state.t, &self.split(state)),
            };
            return all[i] / contacts.mobility(stop);
        }
        let contact = &contacts.all()[stop];
        let pushing = self.holds.soft.pushing.contains(&stop);
        contact.soft.filter(|_| pushing).map_or(0.0, |soft| soft.force(contact.gap(state)))
    }

    /// y as the tables want it.
    pub fn padded(&self, y: &RealVector) -> Vec<f64> {
        let mut all = y.as_slice().to_vec();
        all.resize(self.padded, 0.0);
        all
    }

    /// y as the flow wants it.
    pub fn vector(&self, y: &[f64]) -> RealVector {
        RealVector::from_column_slice(&y[..self.flow.dimension()])
    }

    /// y of the machine's own state.
    pub fn split(&self, state: &State) -> RealVector {
        match &self.reduced {
            None => self.flow.split(state),
            Some(_) => self.flow.split(&self.lowered(state)),
        }
    }

    /// The machine's own state of y.
    pub fn join(&self, t: f64, y: &RealVector) -> State {
        self.raised(self.flow.join(t, y))
    }

    /// The machine's own state after `duration` ≥ 0 of motion in this stage from a state at `time`, over as
    /// many periods as that takes.
    pub fn after(&self, time: Time, state: &State, duration: f64) -> State {
        if let Some(smooth) = &self.smooth {
            return smooth.after(time, state, duration);
        }
        self.raised(self.flow.after(&self.lowered(state), duration))
    }

    /// A state without what rounding has moved it by off what holds it.
    pub fn kept(&self, state: &State) -> State {
        self.raised(self.lowered(state))
    }

    /// z″ of a stop's gap, or v′ at a row with friction, without the forces of what is rested on or sticks.
    pub fn bend(&self, contacts: &Contacts, row: usize, time: Time, state: &State) -> f64 {
        contacts.felt_along(row, &self.unheld(time, state), state.t)
    }

    /// q″ without the forces of what is rested on or sticks.
    pub fn unheld(&self, time: Time, state: &State) -> RealVector {
        match &self.smooth {
            None => self.equations.acceleration(state.t, &state.q, &state.u),
            Some(smooth) => smooth.unheld(time, state),
        }
    }

    /// q″ of the machine in this stage.
    pub fn acceleration(&self, time: Time, state: &State) -> RealVector {
        if let Some(smooth) = &self.smooth {
            return smooth.acceleration(time, state);
        }
        let own = self.lowered(state);
        let bend = self.flow.equations().acceleration(own.t, &own.q, &own.u);
        let Some((free, lift, _)) = &self.reduced else { return bend };
        let mut sum = free * bend;
        for (j, position) in self.positions.iter().enumerate() {
            sum.axpy(position.at(state.t)[2], &lift.column(j), 1.0);
        }
        sum
    }

    /// The state of the stage's own coordinates.
    fn lowered(&self, state: &State) -> State {
        match &self.reduced {
            None => state.clone(),
            Some((_, _, down)) => {
                let mut u = down * &state.u;
                for (i, surface) in (u.len() - self.stuck..).zip(&self.surfaces) {
                    u[i] = surface.at(state.t)[0];
                }
                State { t: state.t, q: down * &state.q, u }
            }
        }
    }

    /// Of what is watched on friction the derivatives by q, by q′ and by the time, at a state.
    ///
    /// # Errors
    /// None in practice: of [`Contacts::forces`].
    pub fn slopes(&self, contacts: &Contacts, what: What, state: &State) -> Result<(RealVector, f64)> {
        if let Some(smooth) = &self.smooth
            && let Some(watch) = self.watched.iter().position(|known| *known == what)
        {
            return Ok(smooth.slopes(watch, state));
        }
        let seen = match what {
            What::Slide(j) => contacts.rubs()[j].rate_watch(self.holds.grips[j].sign()),
            What::Hold(i, side) => {
                let rows = self.holds.rows(contacts);
                let forces = contacts.forces(&self.equations, &rows, &self.holds.grips)?;
                self.holds.bound(contacts, &forces, &self.braces[i], side)
            }
            _ => return Ok((RealVector::zeros(2 * state.q.len()), 0.0)),
        };
        Ok((stacked(&seen.places, &seen.rates), seen.given.at(state.t)[1]))
    }

    /// How many directions a motion beside this one can leave it in.
    pub fn rank(&self) -> usize {
        self.flow.dimension() - self.stuck
    }

    /// A vector (δq, δq′) of the stage's own coordinates: where it sticks, velocities have no change.
    pub fn lowered_vector(&self, q: &RealVector, u: &RealVector) -> (RealVector, RealVector) {
        let Some((_, _, down)) = &self.reduced else { return (q.clone(), u.clone()) };
        let mut u = down * u;
        let n = u.len();
        u.rows_mut(n - self.stuck, self.stuck).fill(0.0);
        (down * q, u)
    }

    /// From the stage's own coordinates to the machine's, of changes.
    pub fn outward(&self) -> Option<&RealMatrix> {
        self.reduced.as_ref().map(|known| &known.0)
    }

    /// The machine's own state of one of the stage's own coordinates.
    fn raised(&self, state: State) -> State {
        let Some((free, lift, _)) = &self.reduced else { return state };
        let (mut q, mut u) = (free * &state.q, free * &state.u);
        for (j, position) in self.positions.iter().enumerate() {
            let [place, speed, _] = position.at(state.t);
            q.axpy(place, &lift.column(j), 1.0);
            u.axpy(speed, &lift.column(j), 1.0);
        }
        State { t: state.t, q, u }
    }
}

/// The soft stops that push where these switches are negative: those with laws among them.
fn pushing(soft: &SoftStops, formulas: Option<&Smooth>, below: &[usize]) -> Vec<usize> {
    let mut all = soft.pushing.clone();
    for &k in formulas.map_or(&[][..], Smooth::reached).iter().filter(|k| !below.contains(k)) {
        // That a switch of the force is looked at says that there is contact.
        if let Some(SwitchOf::Push(stop)) = formulas.map(|formulas| formulas.switches()[k].of) {
            all.push(stop);
        }
    }
    all.sort_unstable();
    all
}

/// The matrix [[a, b], [c, d]], each entry moved by at most one place of its last digit, whose determinant is
/// nearest to `wanted`. The same matrix is applied in every cell: with entries just rounded, an undamped
/// motion would gain or lose some 10⁻¹⁶ of itself each time.
fn of_determinant(entries: [f64; 4], wanted: f64) -> [f64; 4] {
    let off = |[a, b, c, d]: [f64; 4]| {
        let (p, q) = (a * d, b * c);
        let (p_low, q_low) = (a.mul_add(d, -p), b.mul_add(c, -q));
        // p − wanted − q, each difference with what its rounding leaves.
        let difference = |x: f64, y: f64| {
            let z = x - y;
            let back = z - x;
            (z, (x - (z - back)) - (y + back))
        };
        let (first, low) = difference(p, wanted);
        let (second, lower) = difference(first, q);
        (second + (low + lower + (p_low - q_low))).abs()
    };
    let near = |x: f64| if x == 0.0 { [x, x, x] } else { [x, x.next_down(), x.next_up()] };
    let [a, b, c, d] = entries.map(near);
    let mut best = (off(entries), entries);
    for a in a {
        for b in b {
            for c in c {
                for d in d {
                    let here = off([a, b, c, d]);
                    if here < best.0 {
                        best = (here, [a, b, c, d]);
                    }
                }
            }
        }
    }
    best.1
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    for (a, b) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for i in 0..LANES {
            sums[i] += a[i] * b[i];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
