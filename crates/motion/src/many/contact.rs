//! Stops in floats: gaps, Newton's impact law for any number of them at one instant, the forces of those
//! rested on.
//!
//! With W the rows of the stops involved and D = W M⁻¹ Wᵀ, impulses Λ ≥ 0 change the gaps' rates from w⁻ to
//! w⁺ = w⁻ + D Λ. Newton's law for all at once:
//!
//!   w⁺ + τ min(w⁻, 0) ≥ 0,  Λ ≥ 0,  and for each stop one of the two is 0,
//!
//! a linear complementarity problem. D is symmetric and positive semidefinite, and positive definite unless
//! rows are dependent: then the problem has exactly one solution, and otherwise one w⁺. The velocities change
//! by M⁻¹WᵀΛ. Friction under a given normal force takes no part: its forces are bounded, and an impact takes
//! no time. Its rows are here because what sticks is held as what rests on a stop is. Where the normal force
//! is a stop's, friction acts with it (`lean`). For one stop it is w⁺ = −τ w⁻. For several it is a
//! choice: hits in quick succession, in whatever order, may end otherwise. `ImpactLaw::order_matters` says
//! whether they would.

use super::{Grip, LinearEquations, RealMatrix, RealVector, Rub, SpeedLaw, State, push::StopForce};
use crate::{
    error::{Error, Result},
    motion::{Series, flow::GAUSS},
};

/// A stop seen from the machine: the gap z = row·q − position(t) is positive away from it.
#[derive(Debug, Clone, PartialEq)]
pub struct StopContact {
    /// What it is called.
    pub name: String,
    /// w.
    pub row: RealVector,
    /// Where it stands.
    pub position: Series,
    /// τ ≥ 0; where it depends on the speed, its limit at 0.
    pub restitution: f64,
    /// τ as a function of the speed, per radian of the forcing, if it is one.
    pub law: Option<SpeedLaw<f64>>,
    /// What it does instead, if it is soft; where its force is a formula, without stiffness and damping.
    pub soft: Option<SoftContact>,
    /// Its force, if that is a formula.
    pub(crate) force: Option<StopForce>,
}

/// The force −(`stiffness` z + `damping` z′) of a soft stop where z < 0, unless it would pull.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoftContact {
    /// Force per displacement, above 0.
    pub stiffness: f64,
    /// Force per velocity, velocities being per radian of the forcing; at least 0.
    pub damping: f64,
}

impl SoftContact {
    /// The force at z and z′, which may be negative: then there is none.
    pub(crate) fn force(&self, [gap, rate]: [f64; 2]) -> f64 {
        -(self.stiffness * gap + self.damping * rate)
    }

    /// The force that is 1 where it is watched, so that what is watched has the unit of gaps: −z of a stop
    /// without damping, −z′ of one without stiffness.
    pub(crate) fn unit(&self) -> f64 {
        self.stiffness.max(self.damping)
    }
}

impl StopContact {
    /// z and z′.
    pub fn gap(&self, at: &State) -> [f64; 2] {
        let [place, speed, _] = self.position.at(at.t);
        [self.row.dot(&at.q) - place, self.row.dot(&at.u) - speed]
    }

    /// The force of a stop that gives way, at z and z′; it may be negative: then there is none.
    pub(crate) fn push_at(&self, gap: [f64; 2]) -> f64 {
        match (&self.force, self.soft) {
            (Some(force), _) => force.at(gap),
            (None, Some(soft)) => soft.force(gap),
            (None, None) => 0.0,
        }
    }

    /// What a stop that gives way keeps at z where it is let go of: its work at rest on the way there. One
    /// without damping is open then; a formula's power that is not whole is made smoother by s².
    pub(crate) fn kept(&self, gap: f64) -> f64 {
        let closed = gap < 0.0 && (self.force.is_some() || self.soft.is_some_and(|soft| soft.damping > 0.0));
        let at = |s: f64| 2.0 * s * gap * self.push_at([s * s * gap, 0.0]).max(0.0);
        let parts = (0..4).flat_map(|i| GAUSS.map(|(x, weight)| weight * at((f64::from(i) + x) / 4.0)));
        if closed { -parts.sum::<f64>() / 4.0 } else { 0.0 }
    }

    /// τ at an impact of speed V; for V < 0 that at 0.
    pub fn restitution_at(&self, speed: f64) -> f64 {
        self.law.as_ref().map_or(self.restitution, |law| law.at(speed.max(0.0))[0])
    }

    /// The derivative of V⁺ = τ(V) V by V.
    pub(crate) fn restitution_slope(&self, speed: f64) -> f64 {
        self.law.as_ref().map_or(self.restitution, |law| {
            let v = speed.max(0.0);
            let [tau, slope] = law.at(v);
            tau + v * slope
        })
    }

    /// z times a sign.
    pub(super) fn gap_watch(&self, sign: f64) -> Watch {
        let given = Series::combination(&[(-sign, &self.position)]);
        // Times 1 changes no bit.
        Watch { places: &self.row * sign, rates: RealVector::zeros(self.row.len()), given }
    }

    /// The force of a soft stop over its unit, times a sign; 0 of a rigid one.
    pub(super) fn push_watch(&self, sign: f64) -> Watch {
        let soft = self.soft.unwrap_or(SoftContact { stiffness: 0.0, damping: 0.0 });
        let unit = if self.soft.is_some() { sign / soft.unit() } else { 0.0 };
        let (place, rate) = (soft.stiffness * unit, soft.damping * unit);
        Watch {
            places: &self.row * -place,
            rates: &self.row * -rate,
            given: Series::combination(&[(place, &self.position), (rate, &self.position.derivative())]),
        }
    }
}

/// All stops of a machine and its rows with friction, and how an impulse at one is felt at the others. Rows
/// are numbered: the stops first, then friction.
#[derive(Debug, Clone)]
pub struct Contacts {
    all: Vec<StopContact>,
    rubs: Vec<Rub>,
    /// M⁻¹wᵀ of each: the velocities that an impulse of 1 there gives.
    pushes: Vec<RealVector>,
    /// D for all of them.
    coupling: RealMatrix,
}

/// What happened at an instant.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ImpactLaw {
    /// The impulses, one for each stop asked about.
    pub impulses: Vec<f64>,
    /// The change of velocity.
    pub change: RealVector,
    /// Whether impacts one after the other, in some order, would have ended with other velocities.
    pub order_matters: bool,
}

/// Why what is held cannot be.
pub(super) const DEPENDENT: &str = "what is rested on or sticks has dependent rows";

/// Something to be watched on a system: a·q + b·q′ + given(t).
#[derive(Debug, Clone)]
pub(crate) struct Watch {
    /// a.
    pub places: RealVector,
    /// b.
    pub rates: RealVector,
    /// The known part.
    pub given: Series,
}

impl Watch {
    /// Nothing but a constant, of n coordinates.
    pub(crate) fn constant(n: usize, value: f64) -> Watch {
        Watch { places: RealVector::zeros(n), rates: RealVector::zeros(n), given: Series::constant(value) }
    }

    /// `most` less this times a sign.
    pub(super) fn below(&self, most: f64, sign: f64) -> Watch {
        let given = Series::combination(&[(1.0, &Series::constant(most)), (-sign, &self.given)]);
        Watch { places: &self.places * -sign, rates: &self.rates * -sign, given }
    }

    /// This and another one times a factor.
    pub(super) fn with(&self, factor: f64, other: &Watch) -> Watch {
        let given = Series::combination(&[(1.0, &self.given), (factor, &other.given)]);
        Watch {
            places: &self.places + &other.places * factor,
            rates: &self.rates + &other.rates * factor,
            given,
        }
    }
}

/// Most stops at one instant for which all choices of those that act are tried.
pub(super) const MOST_TRIED: usize = 12;

impl Contacts {
    /// The stops of a machine with these equations.
    pub(crate) fn new(equations: &LinearEquations, all: Vec<StopContact>, rubs: Vec<Rub>) -> Contacts {
        let rows: Vec<&RealVector> =
            all.iter().map(|contact| &contact.row).chain(rubs.iter().map(|rub| &rub.row)).collect();
        let pushes: Vec<RealVector> = rows.iter().map(|row| equations.accelerate(row)).collect();
        let coupling = RealMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i].dot(&pushes[j]));
        let coupling = (&coupling + coupling.transpose()) * 0.5;
        Contacts { all, rubs, pushes, coupling }
    }

    /// The friction.
    pub(crate) fn rubs(&self) -> &[Rub] {
        &self.rubs
    }

    /// The number of the row of friction j.
    pub(crate) fn rub_row(&self, j: usize) -> usize {
        self.all.len() + j
    }

    /// w of a row, and where it is held: where a stop stands; of friction the surface's motion but for its
    /// constant velocity and for where it holds, neither of which is felt.
    pub(crate) fn held_row(&self, row: usize) -> (&RealVector, &Series) {
        match self.all.get(row) {
            Some(contact) => (&contact.row, &contact.position),
            None => {
                let rub = &self.rubs[row - self.all.len()];
                (&rub.row, &rub.motion)
            }
        }
    }

    /// What a machine of these accelerations and without the row's force is accelerated by along it.
    pub(super) fn felt_along(&self, row: usize, acceleration: &RealVector, t: f64) -> f64 {
        let (along, place) = self.held_row(row);
        along.dot(acceleration) - place.at(t)[2]
    }

    /// All of them.
    pub fn all(&self) -> &[StopContact] {
        &self.all
    }

    /// M⁻¹wᵀ.
    pub fn push(&self, stop: usize) -> &RealVector {
        &self.pushes[stop]
    }

    /// w M⁻¹ wᵀ: 1 over the mass that the stop feels.
    pub fn mobility(&self, stop: usize) -> f64 {
        self.coupling[(stop, stop)]
    }

    /// An entry of D.
    pub(super) fn coupled(&self, row: usize, other: usize) -> f64 {
        self.coupling[(row, other)]
    }

    /// D among some of them.
    pub(super) fn among(&self, stops: &[usize]) -> RealMatrix {
        RealMatrix::from_fn(stops.len(), stops.len(), |i, j| self.coupling[(stops[i], stops[j])])
    }

    /// The change of velocity by impulses at some of them.
    pub(super) fn change(&self, stops: &[usize], impulses: &[f64]) -> RealVector {
        let mut sum = RealVector::zeros(self.pushes.first().map_or(0, |push| push.len()));
        for (&stop, &impulse) in stops.iter().zip(impulses) {
            sum.axpy(impulse, &self.pushes[stop], 1.0);
        }
        sum
    }

    /// Newton's law for the stops touched, the rates of whose gaps are `rates`, without friction. Cost: O(2^m
    /// m³) for m ≤ 12 stops.
    ///
    /// # Errors
    /// More than 12 stops with dependent rows for which no solution was found.
    pub(crate) fn impact(&self, stops: &[usize], rates: &[f64]) -> Result<ImpactLaw> {
        if let ([stop], [rate]) = (stops, rates) {
            let factor = 1.0 + self.all[*stop].restitution_at(-rate);
            let impulse = -factor * rate.min(0.0) / self.mobility(*stop);
            let change = &self.pushes[*stop] * impulse;
            return Ok(ImpactLaw { impulses: vec![impulse], change, order_matters: false });
        }
        let coupling = self.among(stops);
        let impulses = complementary(&coupling, &self.bounced(stops, rates))?;
        let after =
            RealVector::from_column_slice(rates) + &coupling * RealVector::from_column_slice(&impulses);
        let scale = rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
        let order_matters = (0..stops.len()).any(|first| {
            let hit = |i: usize, rate: f64| {
                let factor = 1.0 + self.all[stops[i]].restitution_at(-rate);
                let impulse = -factor * rate / coupling[(i, i)];
                Some(coupling.column(i) * impulse)
            };
            in_turn(rates, first, hit).is_none_or(|ended| (ended - &after).amax() > 1e-9 * scale)
        });
        Ok(ImpactLaw { change: self.change(stops, &impulses), impulses, order_matters })
    }

    /// w⁻ + τ min(w⁻, 0) of each of them: what Newton's law asks not to be negative with the impulses.
    pub(super) fn bounced(&self, stops: &[usize], rates: &[f64]) -> RealVector {
        let goal = |i: usize| rates[i] + self.all[stops[i]].restitution_at(-rates[i]) * rates[i].min(0.0);
        RealVector::from_fn(stops.len(), |i, _| goal(i))
    }

    /// Which of the stops, all touched without velocity, press, and how hard, `accelerations` being z″ of
    /// each without their forces and without that of what slides on them.
    ///
    /// # Errors
    /// As [`impact`](Self::impact); a [`paradox`](Self::paradox).
    pub(super) fn pressing(
        &self,
        stops: &[usize],
        accelerations: &[f64],
        grips: &[Grip],
    ) -> Result<Vec<f64>> {
        let coupling = self.among_along(stops, stops, grips);
        let b = RealVector::from_column_slice(accelerations);
        self.loads(stops, grips, (&coupling, &b))?.ok_or_else(|| self.paradox(stops))
    }

    /// The forces of the rows that are held, stops rested on and what sticks, each as the acceleration that
    /// it prevents, λ_j D_jj, of the machine's own state.
    ///
    /// # Errors
    /// Dependent rows.
    pub(super) fn forces(
        &self,
        equations: &LinearEquations,
        stops: &[usize],
        grips: &[Grip],
    ) -> Result<Vec<Watch>> {
        // λ = D⁻¹(W M⁻¹(K q + C q′ − f) + Q″), D with what leans.
        let one = |(weights, felt): (Vec<f64>, RealVector)| {
            let mut parts = vec![(-1.0, equations.force.series(&felt)?)];
            for (weight, &stop) in weights.iter().zip(stops) {
                parts.push((*weight, self.held_row(stop).1.derivative().derivative()));
            }
            let parts: Vec<(f64, &Series)> = parts.iter().map(|(factor, series)| (*factor, series)).collect();
            Ok(Watch {
                places: equations.stiffness.tr_mul(&felt),
                rates: equations.damping.tr_mul(&felt),
                given: Series::combination(&parts),
            })
        };
        self.felt(stops, grips)?.into_iter().map(one).collect()
    }

    /// For each of the rows that are held, weights a and v = M⁻¹Σ a_j w_jᵀ: under a force f its own, as an
    /// acceleration, is Σ a_j Q_j″ − v·f.
    ///
    /// # Errors
    /// Dependent rows.
    pub(super) fn felt(&self, stops: &[usize], grips: &[Grip]) -> Result<Vec<(Vec<f64>, RealVector)>> {
        let inverse = self.among_along(stops, stops, grips).try_inverse();
        let inverse = inverse.ok_or_else(|| Error::input(DEPENDENT))?;
        let one = |i: usize| {
            let own = self.mobility(stops[i]);
            let weights: Vec<f64> = (0..stops.len()).map(|j| own * inverse[(i, j)]).collect();
            let felt = self.change(stops, &weights);
            (weights, felt)
        };
        Ok((0..stops.len()).map(one).collect())
    }
}

/// The rates after impacts one by one, beginning with `first`; none if they do not end. `hit` says what the
/// impact at a place and of a rate below 0 changes all rates by.
pub(super) fn in_turn(
    rates: &[f64],
    first: usize,
    mut hit: impl FnMut(usize, f64) -> Option<RealVector>,
) -> Option<RealVector> {
    let mut now = RealVector::from_column_slice(rates);
    let (m, tiny) = (rates.len(), 1e-13 * now.amax());
    for turn in 0..200 * m {
        if now.iter().all(|rate| *rate >= -tiny) {
            return Some(now);
        }
        let i = (first + turn) % m;
        if now[i] < 0.0 {
            now += hit(i, now[i])?;
        }
    }
    None
}

/// Λ ≥ 0 with DΛ + b ≥ 0 and, for each entry, one of the two 0. Up to 12 entries all choices of those that
/// act are tried, fewest first, so that dependent rows do no harm; beyond, by sweeps (projected
/// Gauss–Seidel).
pub(super) fn complementary(coupling: &RealMatrix, b: &RealVector) -> Result<Vec<f64>> {
    let m = b.len();
    if b.iter().all(|x| *x >= 0.0) {
        return Ok(vec![0.0; m]);
    }
    if m > MOST_TRIED {
        return swept(coupling, b);
    }
    tried(coupling, b).map_or_else(|| swept(coupling, b), Ok)
}

/// The same by trying all choices, of a coupling that need not be symmetric; none if there is no answer.
pub(super) fn tried(coupling: &RealMatrix, b: &RealVector) -> Option<Vec<f64>> {
    let (m, scale) = (b.len(), b.amax());
    if b.iter().all(|x| *x >= 0.0) {
        return Some(vec![0.0; m]);
    }
    let mut choices: Vec<u32> = (1..1 << m).collect();
    choices.sort_by_key(|choice| choice.count_ones());
    for choice in choices {
        let acting: Vec<usize> = (0..m).filter(|i| choice >> i & 1 == 1).collect();
        let inner = RealMatrix::from_fn(acting.len(), acting.len(), |i, j| coupling[(acting[i], acting[j])]);
        let right = RealVector::from_fn(acting.len(), |i, _| -b[acting[i]]);
        let Some(found) = inner.lu().solve(&right) else { continue };
        if found.iter().any(|x| x.is_nan() || *x < 0.0) {
            continue;
        }
        let mut impulses = RealVector::zeros(m);
        for (value, &i) in found.iter().zip(&acting) {
            impulses[i] = *value;
        }
        let left = coupling * &impulses + b;
        if left.iter().all(|x| *x >= -1e-11 * scale) {
            return Some(impulses.iter().copied().collect());
        }
    }
    None
}

fn swept(coupling: &RealMatrix, b: &RealVector) -> Result<Vec<f64>> {
    let (m, scale) = (b.len(), b.amax());
    let mut x = RealVector::zeros(m);
    for _ in 0..100_000 {
        let mut moved = 0.0f64;
        for i in 0..m {
            let left = b[i] + coupling.row(i).tr_dot(&x);
            let next = (x[i] - left / coupling[(i, i)]).max(0.0);
            moved = moved.max((next - x[i]).abs() * coupling[(i, i)]);
            x[i] = next;
        }
        if moved <= 1e-14 * scale {
            return Ok(x.iter().copied().collect());
        }
    }
    Err(Error::input(
        "the impulses of many stops hit at one instant were not found: their rows are too nearly dependent",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contacts(mass: &[f64], rows: &[&[f64]], restitution: f64) -> Contacts {
        let n = mass.len();
        let zero = RealMatrix::zeros(n, n);
        let mass = RealMatrix::from_diagonal(&RealVector::from_column_slice(mass));
        let force = super::super::Periodic::constant(RealVector::zeros(n));
        let equations = LinearEquations::new(mass, zero.clone(), zero, force).unwrap();
        let contact = |row: &&[f64]| StopContact {
            name: String::new(),
            row: RealVector::from_column_slice(row),
            position: Series::ZERO,
            restitution,
            law: None,
            soft: None,
            force: None,
        };
        Contacts::new(&equations, rows.iter().map(contact).collect(), Vec::new())
    }

    /// Two masses that meet keep momentum and turn their relative velocity.
    #[test]
    fn two_masses_keep_their_momentum() {
        let contacts = contacts(&[2.0, 0.5], &[&[-1.0, 1.0]], 0.7);
        let before = RealVector::from_column_slice(&[1.0, -2.0]);
        let law = contacts.impact(&[0], &[-3.0]).unwrap();
        let after = &before + &law.change;
        assert!((2.0 * after[0] + 0.5 * after[1] - 1.0).abs() < 1e-15);
        assert!((after[1] - after[0] - 0.7 * 3.0).abs() < 1e-15);
    }

    /// A mass in a right-angled corner turns each velocity for itself, in any order; in an acute corner the
    /// order matters.
    #[test]
    fn corners_depend_on_the_order_where_their_walls_are_not_orthogonal() {
        let square = contacts(&[1.0, 1.0], &[&[1.0, 0.0], &[0.0, 1.0]], 0.5);
        let law = square.impact(&[0, 1], &[-1.0, -2.0]).unwrap();
        assert!(!law.order_matters);
        assert_eq!(law.impulses, [1.5, 3.0]);
        let acute = contacts(&[1.0, 1.0], &[&[1.0, 0.0], &[-0.8, 0.6]], 0.5);
        assert!(acute.impact(&[0, 1], &[-1.0, -2.0]).unwrap().order_matters);
    }

    /// The same stop twice: one solution of many, the same velocities.
    #[test]
    fn dependent_rows_have_a_solution() {
        let twice = contacts(&[1.0], &[&[1.0], &[1.0], &[2.0]], 0.5);
        let law = twice.impact(&[0, 1, 2], &[-1.0, -1.0, -2.0]).unwrap();
        assert!((law.change[0] - 1.5).abs() < 1e-12, "{law:?}");
    }

    /// Newton's cradle: the law for all at once shares the impulse; one by one the last ball flies.
    #[test]
    fn a_cradle_depends_on_the_order() {
        let cradle = contacts(&[1.0; 3], &[&[-1.0, 1.0, 0.0], &[0.0, -1.0, 1.0]], 1.0);
        let law = cradle.impact(&[0, 1], &[-1.0, 0.0]).unwrap();
        assert!(law.order_matters);
        let after = RealVector::from_column_slice(&[1.0, 0.0, 0.0]) + &law.change;
        assert!((after.sum() - 1.0).abs() < 1e-15);
        for (one, next) in [(0, 1), (1, 2)] {
            assert!(after[next] - after[one] >= -1e-15);
        }
    }
}
