//! The linear response of a machine to its drive over a parameter: its harmonics, and where modes resonate.
//!
//! The machine is linear here: without contact and friction, forces that are formulas linearised at rest.
//! Peaks are found in `peaks`.

use crate::{
    error::{Error, Result},
    many::{
        LinearEquations, LinearFlow, Machine, Periodic, RealMatrix, RealVector, Slope, grazing::free::minima,
        smooth::Smooth,
    },
    motion::{Series, System, Wall},
};

/// A machine at a value of a parameter, and the derivatives of its coefficients.
pub type AtValue<'f> = &'f dyn Fn(f64) -> Result<[Machine<f64>; 2]>;

/// The linear response at a value.
pub struct FreeResponse {
    /// Each coordinate, then the gap of each stop, with its derivative in the parameter.
    motions: Vec<[Series; 2]>,
    /// How many of them are coordinates.
    points: usize,
    /// Whether a mode without stiffness leaves open about what they move: here 0.
    floats: bool,
}

/// Halvings of the interval in which a mode resonates.
const HALVINGS: u32 = 40;
/// The step of differences, relative to the parameter: their error goes with its fourth power.
const STEP: f64 = 1e-3;

impl Machine<f64> {
    /// An oscillator of one degree of freedom as a machine with these names for its stops, lower before
    /// upper; `unit` 0 makes derivatives of coefficients of derivatives.
    pub fn of_oscillator(system: &System<f64>, stops: [&str; 2], unit: f64) -> Machine<f64> {
        let one = |x: f64| vec![(0, 0, x)];
        let load =
            |h: &crate::motion::Harmonic<f64>| super::Load { k: h.k, cos: vec![h.cos], sin: vec![h.sin] };
        let stop = |(name, sign, wall): (&str, f64, &Option<Wall<f64>>)| {
            let wall = wall.as_ref()?;
            let turned = |x: &f64| Ok::<_, std::convert::Infallible>(sign * x);
            let moved = wall.try_map(&mut { turned }).unwrap_or_else(|never| match never {});
            let wall = Wall { restitution: wall.restitution, ..moved };
            Some(super::Stop { name: name.into(), row: vec![sign * unit], wall, law: super::StopLaw::Newton })
        };
        let walls = [(stops[0], 1.0, &system.lower), (stops[1], -1.0, &system.upper)];
        Machine {
            size: 1,
            period: std::f64::consts::TAU * unit,
            mass: one(unit),
            damping: one(system.damping),
            damping_ratio: Vec::new(),
            stiffness: one(system.stiffness),
            shapes: Vec::new(),
            force: vec![system.force],
            forcing: system.forcing.iter().map(load).collect(),
            smooth: system.smooth.iter().map(|force| Some(force.clone())).collect(),
            record: None,
            stops: walls.into_iter().filter_map(stop).collect(),
            friction: Vec::new(),
        }
    }
}

/// The linear equations at a value. Of formulas forces have up to 16 harmonics.
fn linear(family: AtValue, value: f64) -> Result<(Machine<f64>, Machine<f64>, LinearEquations)> {
    let [machine, slope] = family(value)?;
    let mut equations = machine.equations()?;
    if let Some(smooth) = Smooth::new(&machine)? {
        // The forcing's own harmonics are known better than by looks.
        let none = Periodic::constant(RealVector::zeros(machine.size));
        let given = std::mem::replace(&mut equations.force, none);
        equations = smooth.linearised(&equations);
        equations.force.mean += given.mean;
        given.harmonics.iter().for_each(|(k, cos, sin)| equations.force.add(*k, cos, sin));
    }
    Ok((machine, slope, equations))
}

/// The derivatives of the linear equations.
fn slopes(family: AtValue, value: f64, machine: &Machine<f64>, slope: &Machine<f64>) -> Result<Slope> {
    let own = Slope::new(machine, slope)?;
    if !machine.is_smooth() {
        return Ok(own);
    }
    let step = STEP * if value == 0.0 { 1.0 } else { value.abs() };
    // f′ ≈ (8 (f₁ − f₋₁) − (f₂ − f₋₂))/12h.
    let n = machine.size;
    let (mut damping, mut stiffness) = (RealMatrix::zeros(n, n), RealMatrix::zeros(n, n));
    let mut force = Periodic::constant(RealVector::zeros(n));
    for (i, factor) in [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)] {
        let (weight, at) = (factor / (12.0 * step), linear(family, value + i * step)?.2);
        damping += &at.damping * weight;
        stiffness += &at.stiffness * weight;
        force.mean.axpy(weight, &at.force.mean, 1.0);
        for (k, cos, sin) in &at.force.harmonics {
            force.add(*k, &(cos * weight), &(sin * weight));
        }
    }
    Ok(Slope { damping, stiffness, force, ..own })
}

impl FreeResponse {
    /// The response at a value; none where there is no unique one, at a resonance without damping.
    ///
    /// # Errors
    /// Those of the machine at the value.
    pub fn at(family: AtValue, value: f64) -> Result<Option<FreeResponse>> {
        let (machine, slope, equations) = linear(family, value)?;
        let slopes = slopes(family, value, &machine, &slope)?;
        let known = equations.response();
        let floats = known.is_err();
        let Ok(motion) = known.or_else(|_| equations.response_about_0()) else { return Ok(None) };
        let drift = match floats {
            true => equations.slope_about_0(&motion, &slopes),
            false => equations.response_slope(&motion, &slopes),
        };
        let Ok(drift) = drift else { return Ok(None) };
        let still = Series::ZERO;
        let of = |row: &RealVector, row_slope: &RealVector, place: &Series, place_slope: &Series| {
            let here = Series::combination(&[(1.0, &motion.series(row)?), (-1.0, place)]);
            let parts = [(1.0, &motion.series(row_slope)?), (1.0, &drift.series(row)?), (-1.0, place_slope)];
            Ok::<_, Error>([here, Series::combination(&parts)])
        };
        let (n, points) = (machine.size, machine.points());
        let row = |shapes: &[Vec<f64>], i: usize, alone: f64| match shapes.get(i) {
            Some(shape) => RealVector::from_column_slice(shape),
            None => RealVector::from_fn(n, |j, _| if i == j { alone } else { 0.0 }),
        };
        let coordinates = (0..points)
            .map(|i| of(&row(&machine.shapes, i, 1.0), &row(&slope.shapes, i, 0.0), &still, &still));
        let contacts = machine.contacts()?;
        let gaps = contacts.iter().zip(&slopes.stops);
        let gaps = gaps.map(|(contact, (row, place))| of(&contact.row, row, &contact.position, place));
        let motions = coordinates.chain(gaps).collect::<Result<_>>()?;
        Ok(Some(FreeResponse { motions, points, floats }))
    }

    /// The coefficients of a harmonic's cosine and sine, of each coordinate and gap.
    pub fn harmonics(&self, k: u32) -> Vec<[f64; 2]> {
        self.motions.iter().map(|motion| harmonic(&motion[0], k)).collect()
    }

    /// The derivative of the square of its amplitude, and the size of its terms.
    pub(super) fn climb(&self, place: usize, k: u32) -> (f64, f64) {
        let [[a, b], [c, d]] = self.motions[place].each_ref().map(|series| harmonic(series, k));
        (2.0 * (a * c + b * d), 2.0 * ((a * c).abs() + (b * d).abs()))
    }

    /// The least and the greatest of each coordinate and gap.
    pub fn extents(&self) -> Vec<[f64; 2]> {
        let least = |z: &Series| minima(z).into_iter().map(|found| found.1).fold(z.at(0.0)[0], f64::min);
        let one = |[z, _]: &[Series; 2]| [least(z), -least(&Series::combination(&[(-1.0, z)]))];
        self.motions.iter().map(one).collect()
    }

    /// Whether a mode without stiffness leaves open about what the displacements move: then about 0, and gaps
    /// are not known.
    pub fn floats(&self) -> bool {
        self.floats
    }

    /// How many displacements there are, coordinates and gaps.
    pub(super) fn places(&self) -> usize {
        self.motions.len()
    }

    /// How many of the displacements are coordinates; the others are gaps.
    pub fn points(&self) -> usize {
        self.points
    }
}

fn harmonic(series: &Series, k: u32) -> [f64; 2] {
    series.harmonics().iter().find(|known| known.k == k).map_or([0.0; 2], |known| [known.cos, known.sin])
}

/// The natural frequencies of the linear machine, as multiples of the drive's, with damping ratios,
/// ascending; none where its modes are not known.
pub(crate) fn modes(family: AtValue, value: f64) -> Result<Vec<(f64, f64)>> {
    Ok(LinearFlow::new(linear(family, value)?.2).map(|flow| flow.frequencies()).unwrap_or_default())
}

/// Values at and beside each at which a mode resonates with a harmonic, within those given, which ascend.
pub(super) fn near_resonances(
    family: AtValue,
    values: &[f64],
    ks: &[u32],
    check: &mut dyn FnMut() -> Result<()>,
) -> Result<Vec<f64>> {
    let mut found = Vec::new();
    let mut before: Option<(f64, Vec<(f64, f64)>)> = None;
    for &value in values {
        check()?;
        let here = modes(family, value)?;
        if let Some((last, known)) = before.as_ref().filter(|(_, known)| known.len() == here.len()) {
            let pairs = ks.iter().flat_map(|&k| (0..here.len()).map(move |j| (f64::from(k), j)));
            for (k, j) in pairs.filter(|&(k, j)| (known[j].0 > k) != (here[j].0 > k)) {
                let (mut low, mut high) = (*last, value);
                for _ in 0..HALVINGS {
                    let middle = low + (high - low) / 2.0;
                    let above = modes(family, middle)?.get(j).is_some_and(|mode| mode.0 > k);
                    *(if above == (known[j].0 > k) { &mut low } else { &mut high }) = middle;
                }
                // Half the width of a resonance, in the parameter.
                let steepness = (known[j].0 - here[j].0).abs() / (value - last);
                let half = here[j].1.abs().max(1e-9) * k / steepness;
                let beside = [-4.0, -1.0, -0.5, 0.5, 1.0, 4.0].map(|x| low + x * half);
                found.extend(
                    beside.into_iter().filter(|x| (values[0]..=values[values.len() - 1]).contains(x)),
                );
            }
        }
        before = Some((value, here));
    }
    Ok(found)
}

/// Whether the parameter is the drive's frequency, or a multiple of it, at these values: the period is as its
/// inverse; or, of a drive of one period, natural frequencies are, and damping ratios do not change.
pub fn is_frequency(family: AtValue, values: [f64; 3]) -> Result<bool> {
    let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(b.abs());
    let periods = values.map(|value| family(value).map(|[machine, _]| machine.period));
    let [first, middle, last] = periods;
    let periods = [first?, middle?, last?];
    let all = |of: &dyn Fn(usize) -> f64| same(of(0), of(1)) && same(of(0), of(2));
    if all(&|i| periods[i] * values[i]) {
        return Ok(true);
    }
    if !all(&|i| periods[i]) {
        return Ok(false);
    }
    let [first, middle, last] = values.map(|value| modes(family, value));
    let modes = [first?, middle?, last?];
    let count = modes[0].len();
    let fits = |j: usize| {
        // An undamped mode's ratio is rounding.
        let ratio = |i: usize| if modes[i][j].1.abs() < 1e-12 { 0.0 } else { modes[i][j].1 };
        all(&|i| modes[i][j].0 * values[i]) && all(&ratio)
    };
    Ok(count > 0 && modes.iter().all(|known| known.len() == count) && (0..count).all(fits))
}
