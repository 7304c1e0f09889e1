//! The windows and gaps beyond a touch of the paper's oscillator with d = 3/2 and w = 5, so that λ₁ = 0.62:
//! what is proved of which depths, and where motions hit, for the picture of both.

use std::f64::consts::PI;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::{
    certificate::single::Word,
    error::{Error, Result},
    monitor::Monitor,
    motion::Time,
    number::parse_rational,
    one::simulate::{Event, Settings, Simulator},
    scene::Scene,
    search::{
        attractor::{CellsProblem, prove_cells},
        chaos::Term,
        range::{RangeEffort, SingleProblem, prove_single},
    },
};

/// What is proved of all µ between two, the less first.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// Between which µ = ν/(1 − ν).
    pub between: [f64; 2],
    /// What.
    pub what: Proved,
}

/// What is proved of motions near the touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Proved {
    /// An orbit of one impact in so many periods is stable.
    Stable(u64),
    /// Motions are trapped where none that is periodic is stable, and displacements times weights grow by
    /// so much at every impact.
    Chaos(f64),
    /// Nothing.
    Open,
}

/// Impacts of a motion: µ, and |V|/√ν to four places.
pub type Hit = [f64; 2];

/// Periods of the orbit of the first window.
const FIRST: u64 = 7;
/// The least and the greatest number of windows.
const WINDOWS: [u64; 2] = [1, 9];
/// A stretch of a gap is so long at first, as a logarithm, and is halved while nothing is proved of it, to
/// this.
const LONGEST: f64 = 0.04;
const SHORTEST: f64 = 0.002;
/// Fractions of depths have so many places.
const PLACES: u32 = 12;
/// At how many µ for each window motions are followed, for how many periods until they hit, and for how many
/// more for each period of its orbit.
const VALUES: u64 = 48;
const SETTLED: i64 = 5000;
const SEEN: i64 = 32;

/// λ₁ of the oscillator.
#[must_use]
pub fn eigenvalue() -> f64 {
    // a = (d − √(d² − 1))/w.
    (-2.0 * PI * (1.5 - 1.25f64.sqrt()) / 5.0).exp()
}

fn exact(text: &str) -> Result<[BigRational; 2]> {
    Ok(parse_rational(text).map(|x| [x.clone(), x])?)
}

/// c, k and τ, and the wall.
fn oscillator() -> Result<([[BigRational; 2]; 3], Vec<Term>)> {
    Ok(([exact("3/5")?, exact("1/25")?, exact("4/5")?], vec![(1, [exact("1")?, exact("0")?])]))
}

fn depth(x: f64) -> BigRational {
    let scale = 10f64.powi(PLACES as i32);
    BigRational::new(BigInt::from((x * scale).round() as i64), BigInt::from(10).pow(PLACES))
}

fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

/// That all of it is proved between two depths, which lie as near as digits of floats.
fn stretch(depths: [&BigRational; 2], what: Proved) -> Stretch {
    let [least, greatest] = depths.map(|depth| float(depth) / (1.0 - float(depth)));
    Stretch { between: [least * (1.0 + 1e-12), greatest * (1.0 - 1e-12)], what }
}

/// So many windows, each with the gap below it, the deepest first, and impacts of motions there. Cost: some
/// ten seconds for each window.
///
/// # Errors
/// An input error for no windows or more than nine; the monitor's.
pub fn gaps(windows: u64, monitor: &dyn Monitor) -> Result<(Vec<Stretch>, Vec<Hit>)> {
    let [least, most] = WINDOWS;
    if !(least..=most).contains(&windows) {
        return Err(Error::input(format!(
            "N = {windows}: this figure shows N windows, with N from {least} to {most}"
        )));
    }
    let (mut all, mut hits) = (Vec::new(), Vec::new());
    let mut window = stable(FIRST, monitor)?;
    for periods in FIRST..FIRST + windows {
        let next = stable(periods + 1, monitor)?;
        let [from, to] = &window;
        all.push(stretch([from, to], Proved::Stable(periods)));
        let parts = (float(from) / float(&next[1])).ln() / LONGEST;
        let parts = parts.ceil().max(1.0) as u32;
        let mut ends = vec![from.clone()];
        ends.extend((1..parts).map(|i| depth(float(from) * (-f64::from(i) * LONGEST).exp())));
        ends.push(next[1].clone());
        for two in ends.windows(2) {
            chaos([&two[1], &two[0]], &mut all, monitor)?;
        }
        let last = [float(to), float(&next[1])].map(f64::ln);
        for i in 0..VALUES {
            let place = (i as f64 + 0.5) / VALUES as f64;
            hits.extend(seen((last[0] + place * (last[1] - last[0])).exp(), periods, monitor)?);
        }
        window = next;
    }
    Ok((all, hits))
}

/// Between which depths the orbit of one impact is proved stable.
fn stable(periods: u64, monitor: &dyn Monitor) -> Result<[BigRational; 2]> {
    let (ranges, harmonics) = oscillator()?;
    let deepest = 0.06 * eigenvalue().powi(2 * (periods as i32 - FIRST as i32));
    let problem = SingleProblem { mirrored: false, ranges, behind: true, harmonics, periods, deepest };
    let none = || Error::input(format!("no orbit of period {periods} is proved"));
    let parts = prove_single(&problem, &RangeEffort::new(200_000), monitor)?.map_err(|_| none())?.parts;
    let place = parts.iter().position(|(_, word)| *word == Word::Stable).ok_or_else(none)?;
    let from = place.checked_sub(1).map(|before| parts[before].0.clone()).ok_or_else(none)?;
    Ok([from, parts[place].0.clone()])
}

/// What is proved between two depths, in stretches.
fn chaos(depths: [&BigRational; 2], all: &mut Vec<Stretch>, monitor: &dyn Monitor) -> Result<()> {
    monitor.advance(1)?;
    let (ranges, harmonics) = oscillator()?;
    let problem = CellsProblem { ranges, harmonics, depths: depths.map(Clone::clone) };
    let [least, greatest] = depths.map(float);
    let what = match prove_cells(&problem, monitor)? {
        Ok(proof) => Proved::Chaos(proof.growth),
        Err(_) if (greatest / least).ln() < 2.0 * SHORTEST => Proved::Open,
        Err(_) => {
            let middle = depth((least * greatest).sqrt());
            chaos([&middle, depths[1]], all, monitor)?;
            return chaos([depths[0], &middle], all, monitor);
        }
    };
    all.push(stretch(depths, what));
    Ok(())
}

/// Where a motion hits, once it has settled.
fn seen(depth: f64, periods: u64, monitor: &dyn Monitor) -> Result<Vec<Hit>> {
    monitor.advance(0)?;
    let top = 1.0 / (1.0 - depth);
    let scene = format!(
        "format = \"grazing-scene 3\"\ntitle = \"overdamped\"\n[system]\ndamping = \"3/5\"\nstiffness = \"1/25\"\n\
         [[stops]]\nside = \"lower\"\noffset = -1\nharmonics = [{{ cos = {top:?} }}]\nrestitution = \"4/5\"\n"
    );
    let system = Scene::from_toml(&scene, "overdamped.toml")?.plain(&[])?;
    let simulator = Simulator::new(&system, &Settings::default())?;
    let mut run = simulator.start(Time::new(0, 0.0), 1.0, 0.0)?;
    let mut hits: Vec<Hit> = Vec::new();
    let last = SETTLED + SEEN * periods as i64;
    while let Event::Impact(impact) = run.next(Time::new(last, 0.0)) {
        if impact.time.period >= SETTLED {
            let speed = impact.velocity.abs() / top / depth.sqrt();
            let hit = [top - 1.0, (1e4 * speed).round() / 1e4];
            if !hits.contains(&hit) {
                hits.push(hit);
            }
        }
    }
    Ok(hits)
}
