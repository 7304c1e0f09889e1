//! Proofs of an orbit over a range of a parameter: cell after cell along its branch.
//!
//! In a cell the orbit is looked for near a line, the tangent of the branch at the cell's middle. Balls find
//! the line, how far from it the orbit may be, the pieces of its flights and where its multipliers are; the
//! checker judges each cell. What is proved is what it accepts as a whole.

use std::f64::consts::TAU;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero, pow};

use super::{
    ExpectedImpact, Jet, Quotient, Units, Verdict, admissible,
    krawczyk::{self, Preconditioner, rounded},
    linear::Linear,
    solution::{equations, stability, start},
    write::{claim, converted, decimal, lists, range_quotient, side},
};
use crate::{
    Accepted,
    certificate::{
        branch::{Cell, Certificate, Line, Strike, cell_holds},
        orbit::{Claim, Decimal},
    },
    error::{Error, Result},
    monitor::Monitor,
    motion::System,
    number::{Ball, Precision, Real},
};

/// An orbit of a family of oscillators, and the range of the parameter over which it is to be proved.
pub struct BranchProblem<'a> {
    /// The oscillator at a value of the parameter.
    pub family: &'a dyn Fn(&Jet) -> Result<System<Jet>>,
    /// The same as a function of it.
    pub system: &'a System<Quotient>,
    /// What the parameter is called.
    pub name: &'a str,
    /// About where the impacts are at [`BranchProblem::at`].
    pub impacts: &'a [ExpectedImpact],
    /// A value of the range.
    pub at: BigRational,
    /// The range's ends.
    pub over: [BigRational; 2],
    /// Of the balls.
    pub precision: Precision,
}

/// A proof that has passed the checker.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ProvedBranch {
    /// The certificate.
    pub certificate: Certificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
    /// Why it goes no further, down and up; none where all is proved that was asked for.
    pub ends: [Option<String>; 2],
    units: Units,
}

impl ProvedBranch {
    /// Whether approximate impacts at a value of the parameter are within the box in which the orbit that is
    /// proved there is the only one, as nearly as floats tell.
    #[must_use]
    pub fn holds(&self, impacts: &[ExpectedImpact], parameter: f64) -> bool {
        let (impacts, parameter) = (self.units.impacts(impacts), self.units.about(parameter));
        let near = |cell: &Cell| {
            let [from, to] = cell.parameter.map(float);
            let away = parameter - f64::midpoint(from, to);
            let room = float(cell.radius);
            let within = |(line, impact): (&Line, &ExpectedImpact)| {
                let [phase, velocity] = line.rates.map(|rate| float(rate) * away);
                let late = impact.phase - float(line.phase) - phase;
                let fast = impact.velocity - float(line.velocity) - velocity;
                (late - TAU * (late / TAU).round()).abs() <= room + ROUNDING
                    && fast.abs() <= room + ROUNDING * float(line.velocity).abs()
            };
            (from..=to).contains(&parameter)
                && cell.lines.len() == impacts.len()
                && cell.lines.iter().zip(&impacts).all(within)
        };
        self.certificate.cells.iter().any(near)
    }

    /// The range by what is claimed of stability, its ends exact values of the parameter.
    #[must_use]
    pub fn parts(&self) -> Vec<(Claim, [String; 2])> {
        let parts = self.certificate.parts().into_iter();
        parts.map(|(claim, ends)| (claim, ends.map(|end| self.units.said(end)))).collect()
    }
}

/// About a decimal.
fn float(x: Decimal) -> f64 {
    x.digits as f64 / 10f64.powi(x.places as i32)
}

/// What an approximation may be off: in radians, and of its speeds.
const ROUNDING: f64 = 1e-9;

/// The first cell is such a part of the range, and no cell is smaller than the second.
const FIRST: i64 = 8;
const LEAST: i64 = 1 << 20;
/// A cell of which it is not known whether the orbit is stable is at most such a part of the range.
const OPEN: i64 = 2048;
/// The orbits are looked for within so many times what balls say: the checker's enclosures are wider, where
/// damping and stiffness move.
const ROOMS: [i64; 3] = [2, 8, 32];
/// The most cells.
const CELLS: usize = 2000;
/// The most decimals of an end that is no decimal, and those of the shortest range.
const PLACES: u32 = 20;
const SHORTEST: usize = 15;
/// The checker's numbers are below this.
const FAR: i64 = 1 << 30;
/// Decimals of rates.
const RATE: u32 = 12;

/// The orbit over the largest part of the range that is found, up and down from where it is given; or why
/// there is none.
///
/// An end of the range that is no decimal is rounded inwards. Where the family is not defined the range ends,
/// too. Cost: for each cell that is tried O(m³) operations of m impacts, and the checker.
///
/// # Errors
/// An input error: the value is not in the range; an interruption.
pub fn branch(problem: &BranchProblem, monitor: &dyn Monitor) -> Result<Verdict<ProvedBranch>> {
    let units = match Units::along(
        problem.family,
        problem.impacts.iter().map(|impact| impact.side),
        &problem.at,
        &problem.precision,
    ) {
        Ok(units) => units,
        Err(why) => return Ok(Verdict::Undecided(why.to_string())),
    };
    let problem = &BranchProblem {
        family: &units.family(problem.family, &problem.precision),
        system: &units.function(problem.system),
        name: problem.name,
        impacts: &units.impacts(problem.impacts),
        at: units.parameter(&problem.at),
        over: [units.parameter(&problem.over[0]), units.parameter(&problem.over[1])],
        precision: problem.precision.clone(),
    };
    let [least, greatest] = &problem.over;
    if !(*least <= problem.at && problem.at <= *greatest && least < greatest) {
        return Err(Error::input(
            "the range of the parameter must hold the value at which the orbit is known",
        ));
    }
    if greatest - least < BigRational::new(1.into(), pow(BigInt::from(10), SHORTEST)) {
        return Ok(Verdict::Undecided(format!(
            "the range is shorter than 10^-{SHORTEST}: give a longer one"
        )));
    }
    if [least, greatest].iter().any(|end| end.abs() >= BigRational::from_integer(FAR.into())) {
        let why = "the parameter is not below 2^30 of its units, where the checker's numbers end: take a shorter range";
        return Ok(Verdict::Undecided(why.into()));
    }
    let mut search = match Search::new(problem, units) {
        Ok(search) => search,
        Err(why) => return Ok(Verdict::Undecided(why.to_string())),
    };
    let mut ends = [None, None];
    for way in [Way::Up, Way::Down] {
        ends[way as usize] = search.follow(way, monitor)?;
    }
    if search.certificate.cells.is_empty() {
        return Ok(Verdict::Undecided(ends.into_iter().flatten().next().unwrap_or_default()));
    }
    let accepted = match Accepted::new(search.certificate.to_string()) {
        Ok(accepted) => accepted,
        Err(why) => {
            return Ok(Verdict::Undecided(format!("the checker does not accept the branch: {why}")));
        }
    };
    Ok(Verdict::Proved(ProvedBranch { certificate: search.certificate, accepted, ends, units }))
}

/// Which way the parameter goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Down,
    Up,
}

/// The middle of a cell's line, with its rates.
#[derive(Debug, Clone)]
struct Tangent {
    at: BigRational,
    point: Vec<BigRational>,
    rates: Vec<BigRational>,
}

struct Search<'a> {
    problem: &'a BranchProblem<'a>,
    /// Without cells, and with those that are found.
    head: Certificate,
    certificate: Certificate,
    /// The range's ends and the value that the first cells share, decimals; the last tangents, down and up.
    over: [BigRational; 2],
    seam: BigRational,
    last: [Tangent; 2],
    /// Which of [`ROOMS`] and of the radii the last cell had: the next is tried with these first.
    room: usize,
    radius: usize,
}

impl<'a> Search<'a> {
    fn new(problem: &'a BranchProblem<'a>, units: Units) -> Result<Search<'a>> {
        let strike =
            |impact: &ExpectedImpact| Strike { side: side(impact.side), periods: impact.periods.into() };
        let name = if problem.name.is_ascii() && problem.name.len() <= 32 { problem.name } else { "p" };
        let head = Certificate {
            system: converted(units, problem.system, &range_quotient)?,
            name: name.into(),
            strikes: problem.impacts.iter().map(strike).collect(),
            cells: Vec::new(),
        };
        let point: Option<Vec<BigRational>> =
            start(problem.impacts).into_iter().map(BigRational::from_float).collect();
        let point = point.ok_or_else(|| Error::input("an orbit has finite phases and speeds"))?;
        let rates = vec![BigRational::zero(); point.len()];
        let tangent = Tangent { at: problem.at.clone(), point, rates };
        let over = [Way::Down, Way::Up].map(|way| inwards(&problem.over[way as usize], way));
        let near =
            if decimal(&problem.at).is_ok() { problem.at.clone() } else { rounded(&problem.at, PLACES) };
        let seam = near.clamp(over[0].clone(), over[1].clone());
        let last = [tangent.clone(), tangent];
        Ok(Search { problem, certificate: head.clone(), head, over, seam, last, room: 0, radius: 0 })
    }

    /// Cell after cell one way; why there is no next one before the range's end.
    fn follow(&mut self, way: Way, monitor: &dyn Monitor) -> Result<Option<String>> {
        let all = &self.over[1] - &self.over[0];
        let part = |n: i64| &all / BigInt::from(n);
        let end = self.over[way as usize].clone();
        let (mut from, mut step) = (self.seam.clone(), part(FIRST));
        loop {
            monitor.advance(0)?;
            if (way == Way::Up && from >= end) || (way == Way::Down && from <= end) {
                return Ok(None);
            }
            if self.certificate.cells.len() >= CELLS {
                return Ok(Some("there would be too many cells".into()));
            }
            let to = beyond(&from, &step, &end, way);
            let ends = if way == Way::Up { [&from, &to] } else { [&to, &from] };
            let found = match self.cell(ends, way) {
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => Err(error.to_string()),
                Ok(found) => found,
            };
            let why = match found {
                Ok((cell, _)) if cell.claim == Claim::Open && step > part(OPEN) => None,
                Ok((cell, tangent)) => match self.added(cell, way) {
                    Ok(()) => {
                        self.last[way as usize] = tangent;
                        step = (&to - &from).abs() * BigInt::from(3) / BigInt::from(2);
                        from = to;
                        continue;
                    }
                    Err(why) => Some(why),
                },
                Err(why) => Some(why),
            };
            step = (&to - &from).abs() / BigInt::from(2);
            if step < part(LEAST) {
                return Ok(why);
            }
        }
    }

    /// Whether the checker accepts a cell beside the ones there are; then it is added.
    fn added(&mut self, cell: Cell, way: Way) -> std::result::Result<(), String> {
        let cells = &mut self.certificate.cells;
        let (place, judged) = match way {
            Way::Up => (cells.len(), cells.len()),
            Way::Down => (0, usize::from(!cells.is_empty())),
        };
        cells.insert(place, cell);
        let holds = cell_holds(&self.certificate, judged, &mut || false);
        if holds.is_err() {
            self.certificate.cells.remove(place);
        }
        holds
    }

    /// A cell that the checker accepts by itself, with the widest box of those tried; or why there is none.
    fn cell(
        &mut self,
        [from, to]: [&BigRational; 2],
        way: Way,
    ) -> Result<std::result::Result<(Cell, Tangent), String>> {
        let middle = (from + to) / BigInt::from(2);
        let Some((tangent, inverse)) = self.tangent(&middle, &self.last[way as usize])? else {
            return Ok(Err("Newton's method finds no orbit".into()));
        };
        let half = (to - from) / BigInt::from(2);
        let Some(far) = self.far(&tangent, &inverse, [from, to], &half)? else {
            return Ok(Err("nothing is known of the equations".into()));
        };
        let first = self.room;
        let rooms = std::iter::once(first).chain((0..ROOMS.len()).filter(|&room| room != first));
        let mut last = Err(String::new());
        for room in rooms {
            let within = two_digits(&far * BigInt::from(ROOMS[room]) + krawczyk::near());
            last = self.about(&tangent, &inverse, [from, to], &within)?;
            if last.is_ok() {
                self.room = room;
                break;
            }
        }
        Ok(last.map(|cell| (cell, tangent)))
    }

    /// A cell whose orbits are within this of its line.
    fn about(
        &mut self,
        tangent: &Tangent,
        inverse: &Preconditioner,
        [from, to]: [&BigRational; 2],
        within: &BigRational,
    ) -> Result<std::result::Result<Cell, String>> {
        let (precision, half) = (&self.problem.precision, (to - from) / BigInt::from(2));
        // A little more, for the checker to tell them apart.
        let radius = within * BigRational::new(11.into(), 10.into());
        let m = self.problem.impacts.len();
        let line = |i: usize| {
            Ok(Line {
                phase: decimal(&tangent.point[i])?,
                velocity: decimal(&tangent.point[m + i])?,
                rates: [decimal(&tangent.rates[i])?, decimal(&tangent.rates[m + i])?],
            })
        };
        let cell = Cell {
            parameter: [decimal(from)?, decimal(to)?],
            claim: Claim::Open,
            lines: (0..m).map(line).collect::<Result<_>>()?,
            radius: decimal(&radius)?,
            within: decimal(within)?,
            inverse: lists(inverse)?,
            flights: Vec::new(),
        };
        let cell = match self.widest(cell, &radius)? {
            Ok(cell) => cell,
            Err(why) => return Ok(Err(why)),
        };
        let parameter = Jet::constant(Ball::between(from, to, precision));
        let linear = Linear::enclosed((self.problem.family)(&parameter)?, precision)?;
        let equations = equations(&linear, self.problem.impacts)?;
        let around = |(y, rate): (&BigRational, &BigRational)| {
            let far = rate.abs() * &half + within;
            Jet::constant(Ball::between(&(y - &far), &(y + &far), precision))
        };
        let unknowns: Vec<Jet> = tangent.point.iter().zip(&tangent.rates).map(around).collect();
        let flights = match admissible::prove(&equations, &unknowns, None)? {
            Verdict::Proved(pieces) => lists(&pieces)?,
            Verdict::Refuted(why) | Verdict::Undecided(why) => return Ok(Err(why)),
        };
        let (trace, determinant) = equations.multipliers(&unknowns)?;
        let claim = claim(stability(&trace.value, &determinant.value, precision));
        Ok(Ok(Cell { claim, flights, ..cell }))
    }

    /// The cell, which has no flights yet, with the largest box, 1/2, 1/5, 1/10, …, about its line in which
    /// the checker finds the solution to be the only one, from that of the last cell on; or why it finds
    /// none.
    fn widest(&mut self, cell: Cell, least: &BigRational) -> Result<std::result::Result<Cell, String>> {
        let mut alone = Certificate { cells: vec![cell], ..self.head.clone() };
        let narrow = alone.cells[0].radius;
        // That the flights are missing is found after the solution.
        let mut solved = |radius: Decimal| {
            alone.cells[0].radius = radius;
            match cell_holds(&alone, 0, &mut || false) {
                Err(why) if why.contains("Krawczyk") => Err(why),
                _ => Ok(radius),
            }
        };
        let radii = krawczyk::radii().take_while(|radius| radius > least).map(|radius| decimal(&radius));
        let radii = radii.collect::<Result<Vec<_>>>()?;
        // Of a longer or shorter list than the last cell's.
        self.radius = self.radius.min(radii.len().saturating_sub(1));
        let widest = (self.radius..radii.len()).find(|&i| solved(radii[i]).is_ok());
        let found = match widest {
            Some(mut i) => {
                while i > 0 && i <= self.radius && solved(radii[i - 1]).is_ok() {
                    (i, self.radius) = (i - 1, i - 1);
                }
                self.radius = i;
                Ok(radii[i])
            }
            None => solved(narrow),
        };
        let cell = alone.cells.remove(0);
        Ok(found
            .map(|radius| Cell { radius, ..cell })
            .map_err(|why| why.trim_start_matches("cell 1 of 1: ").into()))
    }

    /// The solution at a value of the parameter, how it moves with it, and a preconditioner.
    fn tangent(&self, at: &BigRational, last: &Tangent) -> Result<Option<(Tangent, Preconditioner)>> {
        let precision = &self.problem.precision;
        let linear = Linear::enclosed((self.problem.family)(&Jet::ratio(at, precision))?, precision)?;
        let pattern = equations(&linear, self.problem.impacts)?;
        let away = at - &last.at;
        let guess = last.point.iter().zip(&last.rates).map(|(y, rate)| (y + rate * &away).to_f64());
        let Some(guess) = guess.collect::<Option<Vec<f64>>>() else { return Ok(None) };
        let map = |unknowns: &[Jet]| pattern.residual(unknowns);
        let Some((point, inverse)) = krawczyk::newton(&map, &guess, precision)? else { return Ok(None) };
        let still: Vec<Jet> = point.iter().map(|y| Jet::ratio(y, precision)).collect();
        let moved = self.slopes(&still, Jet::variable(Ball::ratio(at, precision), 0, 1, precision))?;
        let middles: Option<Vec<BigRational>> = moved.iter().map(krawczyk::middle).collect();
        let Some(moved) = middles else { return Ok(None) };
        let rate = |row: &Vec<BigRational>| {
            let sum: BigRational = row.iter().zip(&moved).map(|(c, f)| c * f).sum();
            rounded(&-sum, RATE)
        };
        let rates = inverse.iter().map(rate).collect();
        Ok(Some((Tangent { at: at.clone(), point, rates }, inverse)))
    }

    /// The derivatives of the equations by the one variable in these numbers.
    fn slopes(&self, unknowns: &[Jet], parameter: Jet) -> Result<Vec<Ball>> {
        let precision = &self.problem.precision;
        let linear = Linear::enclosed((self.problem.family)(&parameter)?, precision)?;
        let values = equations(&linear, self.problem.impacts)?.residual(unknowns)?;
        let zero = Ball::integer(0, precision);
        Ok(values.into_iter().map(|value| value.slopes.into_iter().next().unwrap_or(zero.clone())).collect())
    }

    /// About how far from the line the solutions are at most.
    fn far(
        &self,
        tangent: &Tangent,
        inverse: &Preconditioner,
        [from, to]: [&BigRational; 2],
        half: &BigRational,
    ) -> Result<Option<BigRational>> {
        let precision = &self.problem.precision;
        let along = |(y, rate): (&BigRational, &BigRational)| Jet {
            value: Ball::between(&(y - rate.abs() * half), &(y + rate.abs() * half), precision),
            slopes: vec![Ball::ratio(rate, precision)],
        };
        let unknowns: Vec<Jet> = tangent.point.iter().zip(&tangent.rates).map(along).collect();
        let parameter =
            Jet { value: Ball::between(from, to, precision), slopes: vec![Ball::integer(1, precision)] };
        let slopes = self.slopes(&unknowns, parameter)?;
        let mut most = BigRational::zero();
        for row in inverse {
            let terms = row.iter().zip(&slopes).map(|(c, slope)| Ball::ratio(c, precision) * slope);
            let sum = terms.fold(Ball::integer(0, precision), |sum, term| sum + &term);
            let Some((lo, hi)) = sum.exact_bounds() else { return Ok(None) };
            most = most.max(lo.abs().max(hi.abs()) * half);
        }
        Ok(Some(most))
    }
}

/// A number below 10 upwards, to two digits.
fn two_digits(x: BigRational) -> BigRational {
    let places = (0..30).find(|&places| &x * pow(BigInt::from(10), places) >= BigInt::from(10).into());
    let scale = pow(BigInt::from(10), places.unwrap_or(30));
    (x * &scale).ceil() / scale
}

/// The decimal next to an end of the range, inwards.
fn inwards(end: &BigRational, way: Way) -> BigRational {
    if decimal(end).is_ok() {
        return end.clone();
    }
    let scale = BigRational::from_integer(pow(BigInt::from(10), PLACES as usize));
    let scaled = end * &scale;
    (if way == Way::Up { scaled.floor() } else { scaled.ceil() }) / scale
}

/// A step further, not beyond the end: a decimal of about three digits of the step.
fn beyond(from: &BigRational, step: &BigRational, end: &BigRational, way: Way) -> BigRational {
    let hundred = BigRational::from_integer(100.into());
    let scale = (0..30).map(|places| BigRational::from_integer(pow(BigInt::from(10), places)));
    let scale = scale.clone().find(|scale| step * scale >= hundred).unwrap_or_else(|| hundred.clone());
    match way {
        Way::Up => ((from + step) * &scale).floor().max((from * &scale).floor() + BigInt::from(1)) / &scale,
        Way::Down => ((from - step) * &scale).ceil().min((from * &scale).ceil() - BigInt::from(1)) / &scale,
    }
    .clamp(end.min(from).clone(), end.max(from).clone())
}
