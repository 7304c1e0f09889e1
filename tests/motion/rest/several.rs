//! Several coordinates: orbits with rests against those of one coordinate, and against a second solver of
//! flight, chatter and rest, which shares no code with `src`.

use crate::samples::samples;
use std::f64::consts::TAU;

use grazing_scenes::{
    many::simulate::{Event, Simulator},
    motion::{RunEnd, Time},
    run::{Findings, Judgement, RestFindings, RestOrbitRow},
    scene::Scene,
};

use super::{Random, Shaken, found, near, run};
use crate::machines::second::dot;

/// M q″ + C q′ + K q = f + F cos t above a stop w q ≥ −1 + G sin t.
#[derive(Debug, Clone)]
struct Table {
    mass: Vec<Vec<f64>>,
    damping: Vec<Vec<f64>>,
    stiffness: Vec<Vec<f64>>,
    force: Vec<f64>,
    drive: Vec<f64>,
    row: Vec<f64>,
    shake: f64,
    tau: f64,
}

/// The same as z′ = A z of z = (q, q′, 1, cos t, sin t), in flight and at rest, and the gap as seen of z.
struct Flow {
    free: Vec<Vec<f64>>,
    held: Vec<Vec<f64>>,
    gap: Vec<f64>,
    /// w A², the gap's second derivative in flight.
    bend: Vec<f64>,
    /// What an impulse at the stop changes z by, the gap's rate by 1.
    push: Vec<f64>,
    tau: f64,
}

impl Table {
    fn drawn(random: &mut Random, n: usize, wild: bool) -> Table {
        let mut between = |lo: f64, hi: f64| lo + (hi - lo) * random.uniform();
        let mut symmetric = |lo: f64, hi: f64, off: f64| -> Vec<Vec<f64>> {
            let mut all = vec![vec![0.0; n]; n];
            let pairs = (0..n).flat_map(|i| (0..=i).map(move |j| (i, j)));
            for (i, j) in pairs {
                let x = if i == j { between(lo, hi) } else { between(-off, off) };
                (all[i][j], all[j][i]) = (x, x);
            }
            all
        };
        let (mass, damping) = (symmetric(0.7, 1.5, 0.2), symmetric(0.02, if wild { 0.1 } else { 0.6 }, 0.01));
        let stiffness = symmetric(
            if wild { 0.1 } else { 0.4 },
            if wild { 3.0 } else { 1.2 },
            if wild { 0.05 } else { 0.15 },
        );
        let mut vector = |lo: f64, hi: f64| -> Vec<f64> { (0..n).map(|_| between(lo, hi)).collect() };
        let (drive, row) = (vector(-0.3, 0.3), vector(0.3, 1.0));
        let push = between(-3.0, -0.8);
        let force = row.iter().map(|w| w * push).collect();
        Table {
            mass,
            damping,
            stiffness,
            force,
            drive,
            row,
            shake: between(0.8, 3.0),
            tau: between(0.1, 0.6),
        }
    }

    fn text(&self, task: &str) -> String {
        let Table { mass, damping, stiffness, force, drive, row, shake, tau } = self;
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[system]\nmass = {mass:?}\ndamping = {damping:?}\n\
             stiffness = {stiffness:?}\nforce = {force:?}\nforcing = [{{ cos = {drive:?} }}]\n[[stops]]\n\
             name = \"table\"\nrow = {row:?}\noffset = -1\nharmonics = [{{ sin = {shake} }}]\n\
             restitution = {tau}\n[[tasks]]\nname = \"r\"\n{task}\n"
        )
    }

    /// x with M x = y.
    fn accelerated(&self, y: &[f64]) -> Vec<f64> {
        let n = y.len();
        let mut all: Vec<Vec<f64>> =
            self.mass.iter().zip(y).map(|(row, y)| row.iter().copied().chain([*y]).collect()).collect();
        for k in 0..n {
            for i in 0..n {
                if i != k {
                    let (part, known) = (all[i][k] / all[k][k], all[k].clone());
                    all[i].iter_mut().zip(known).for_each(|(x, y)| *x -= part * y);
                }
            }
        }
        (0..n).map(|i| all[i][n] / all[i][i]).collect()
    }

    fn flow(&self) -> Flow {
        let n = self.row.len();
        let d = 2 * n + 3;
        let mut free = vec![vec![0.0; d]; d];
        let column = |of: &dyn Fn(usize) -> f64| self.accelerated(&(0..n).map(of).collect::<Vec<_>>());
        for j in 0..d {
            let bent = match j {
                j if j < n => column(&|i| -self.stiffness[i][j]),
                j if j < 2 * n => column(&|i| -self.damping[i][j - n]),
                j if j == 2 * n => column(&|i| self.force[i]),
                j if j == 2 * n + 1 => column(&|i| self.drive[i]),
                _ => vec![0.0; n],
            };
            bent.iter().zip(&mut free[n..]).for_each(|(x, row)| row[j] = *x);
        }
        (0..n).for_each(|i| free[i][n + i] = 1.0);
        (free[2 * n + 1][2 * n + 2], free[2 * n + 2][2 * n + 1]) = (-1.0, 1.0);
        let mut gap = self.row.clone();
        gap.resize(d, 0.0);
        (gap[2 * n], gap[2 * n + 2]) = (1.0, -self.shake);
        let before =
            |w: &[f64]| -> Vec<f64> { (0..d).map(|j| (0..d).map(|i| w[i] * free[i][j]).sum()).collect() };
        let bend = before(&before(&gap));
        let own = self.accelerated(&self.row);
        let size = dot(&self.row, &own);
        let mut push = vec![0.0; d];
        (0..n).for_each(|i| push[n + i] = own[i] / size);
        let held = (0..d).map(|i| (0..d).map(|j| free[i][j] - push[i] * bend[j]).collect()).collect();
        Flow { free, held, gap, bend, push, tau: self.tau }
    }
}

/// What was on the way.
struct Followed {
    z: Vec<f64>,
    impacts: u64,
    /// Begin and release of each.
    rests: Vec<[f64; 2]>,
    /// The time of the first impact.
    first: f64,
}

/// Of a Taylor series.
const TERMS: usize = 24;
const STEP: f64 = 0.1;

impl Flow {
    fn begin(&self, t: f64, x: &[f64]) -> Vec<f64> {
        x.iter().copied().chain([1.0, t.cos(), t.sin()]).collect()
    }

    /// Follows from z for a time. None where bounces fade just as the stop lets go.
    fn follow(&self, from: &[f64], time: f64) -> Option<Followed> {
        let (mut z, mut gone, mut impacts, mut rests, mut first) = (from.to_vec(), 0.0, 0, Vec::new(), time);
        let mut begun: Option<f64> = None;
        let mut bounce = f64::INFINITY;
        for _ in 0..5000 {
            let left = time - gone;
            if left <= 1e-13 {
                return Some(Followed { z, impacts, rests, first });
            }
            let (matrix, falls, sign) = match begun {
                Some(_) => (&self.held, &self.bend, -1.0),
                None => (&self.free, &self.gap, 1.0),
            };
            let mut terms = vec![z.clone()];
            for k in 1..TERMS {
                let next = matrix.iter().map(|row| dot(row, &terms[k - 1]) / k as f64).collect();
                terms.push(next);
            }
            let seen: Vec<f64> = terms.iter().map(|term| sign * dot(falls, term)).collect();
            let at = |s: f64| seen.iter().rev().fold(0.0, |sum, c| sum * s + c);
            let most = STEP.min(left);
            let (mut lo, mut hi) = (0.0, (0.05 * bounce).min(most / 64.0));
            while hi < most && at(hi) >= 0.0 {
                lo = hi;
                hi = (hi + (0.05 * bounce).max(0.02 * hi).min(most / 64.0)).min(most);
            }
            let ends = at(hi) < 0.0;
            for _ in 0..if ends { 80 } else { 0 } {
                let middle = 0.5 * (lo + hi);
                if at(middle) >= 0.0 { lo = middle } else { hi = middle }
            }
            let s = if ends { lo } else { hi };
            z = (0..z.len()).map(|i| terms.iter().rev().fold(0.0, |sum, term| sum * s + term[i])).collect();
            gone += s;
            bounce = f64::INFINITY;
            if !ends {
                continue;
            }
            if let Some(begin) = begun.take() {
                rests.push([begin, gone]);
                // On beyond the instant at which the force is 0.
                bounce = 1e-2;
                continue;
            }
            let rate: f64 = (0..z.len()).map(|i| self.gap[i] * dot(&self.free[i], &z)).sum();
            let (press, fast) = (-dot(&self.bend, &z), (-rate).max(0.0));
            let last = 2.0 * self.tau * fast / press;
            let rested = press > 0.0 && last < 3e-6;
            if !rested && fast <= 1e-9 {
                return None;
            }
            let factor = if rested { 1.0 } else { 1.0 + self.tau };
            (0..z.len()).for_each(|i| z[i] += factor * fast * self.push[i]);
            (impacts, first) = (impacts + 1, first.min(gone));
            bounce = if press > 0.0 { last } else { f64::INFINITY };
            if rested {
                (begun, bounce) = (Some(gone + last / (1.0 - self.tau)), f64::INFINITY);
            }
        }
        None
    }
}

const SEARCHED: &str = "kind = \"rest\"\nperiods = 60\nstarts = 8\nlongest = 3";

fn size(x: &[f64]) -> f64 {
    x.iter().fold(1.0, |most: f64, x| most.max(x.abs()))
}

/// Σ λ and Σ λ² of the multipliers that are shown.
fn traces(row: &RestOrbitRow) -> [f64; 2] {
    let all: Vec<(f64, f64)> =
        serde_json::from_value(serde_json::to_value(&row.multipliers).unwrap()).unwrap();
    all.into_iter().fold([0.0; 2], |[a, b], (re, im)| [a + re, b + re * re - im * im])
}

/// Each orbit of random machines: the second solver comes back to where it began, after the same rests, and
/// its differences have the same multipliers.
#[test]
fn orbits_of_several_coordinates_are_those_of_a_second_solver() {
    let mut random = Random(41);
    let (mut orbits, mut worst, mut apart, mut unstable, mut several, mut open) =
        (0, 0.0f64, 0.0f64, 0, 0, 0);
    let draws: i32 = samples(12);
    for draw in 0..draws {
        let machine = Table::drawn(&mut random, 2 + draw as usize % 2, draw % 4 > 1);
        let found: RestFindings = match run(&machine.text(SEARCHED)).findings {
            Some(Findings::Rest(found)) => *found,
            other => panic!("{other:?}"),
        };
        let flow = machine.flow();
        assert!(!found.complete && found.releases.is_empty());
        for row in &found.orbits {
            if row.stable == Judgement::Marginal || !row.held.is_empty() {
                continue;
            }
            let time = TAU * row.period as f64;
            let start = TAU * row.released[0];
            let x = [&row.q[..], &row.u[..]].concat();
            let begin = flow.begin(start, &x);
            // In the middle of a flight all states beside are free.
            let half = 0.5 * flow.follow(&begin, time).unwrap().first;
            let (start, begin) = (start + half, flow.follow(&begin, half).unwrap().z);
            let Followed { z: end, impacts, rests, .. } = flow.follow(&begin, time).unwrap();
            let back = end.iter().zip(&begin).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            worst = worst.max(back / size(&x));
            assert!(back < 1e-9 * size(&x), "{machine:?} {row:?} {back}");
            assert_eq!(rests.len(), row.released.len(), "{machine:?} {row:?}");
            // Its last bounces are left out at another height.
            assert!(
                impacts.abs_diff(row.impacts) <= 10 * rests.len() as u64,
                "{machine:?} {row:?} {impacts}"
            );
            for (i, [rested, released]) in rests.iter().enumerate() {
                let i = (i + 1) % rests.len();
                near(row.released[i], (start + released) / TAU, 1e-7);
                near(row.rested[i], (start + rested) / TAU, 1e-7);
            }
            let (d, step) = (x.len(), 1e-5);
            let column = |j: usize| -> Option<Vec<f64>> {
                let end = |step: f64| {
                    let mut from = begin.clone();
                    from[j] += step;
                    flow.follow(&from, time).map(|end| end.z)
                };
                Some(end(step)?.iter().zip(&end(-step)?).map(|(a, b)| (a - b) / (2.0 * step)).collect())
            };
            let Some(slope) = (0..d).map(column).collect::<Option<Vec<Vec<f64>>>>() else {
                open += 1;
                continue;
            };
            let trace: f64 = (0..d).map(|i| slope[i][i]).sum();
            let square: f64 = (0..d)
                .flat_map(|i| (0..d).map(move |j| (i, j)))
                .map(|(i, j)| slope[i][j] * slope[j][i])
                .sum();
            let [one, two] = traces(row);
            let large = slope.iter().flatten().fold(1.0, |most: f64, x| most.max(x.abs()));
            let off = ((trace - one).abs() / large).max((square - two).abs() / (large * large));
            apart = apart.max(off);
            orbits += 1;
            unstable += usize::from(row.stable == Judgement::No);
            several += usize::from(row.period > 1);
        }
    }
    println!(
        "{orbits} orbits, {open} open, {unstable} unstable, {several} of several periods, back to {worst:e}, multipliers to {apart:e}"
    );
    assert!(orbits * 3 >= draws && open * 20 <= orbits && apart < 1e-5, "{orbits} {open} {apart}");
}

/// The scene of an oscillator that rests beside another that knows nothing of it, in coordinates
/// q = (x + y, x/2 − y): the orbits of the one, with the multipliers of the other.
fn beside(machine: &Shaken, [damping, stiffness]: [f64; 2], task: &str) -> String {
    let Shaken { damping: c, stiffness: k, force, drive, shake, second, tau } = machine;
    // x = (2 q₁ + 2 q₂)/3, y = (q₁ − 2 q₂)/3.
    let (x, y) = ([2.0 / 3.0, 2.0 / 3.0], [1.0 / 3.0, -2.0 / 3.0]);
    let form = |a: f64, b: f64| -> Vec<Vec<f64>> {
        (0..2).map(|i| (0..2).map(|j| a * x[i] * x[j] + b * y[i] * y[j]).collect()).collect()
    };
    let along = |a: f64, b: f64| -> Vec<f64> { (0..2).map(|i| a * x[i] + b * y[i]).collect() };
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"t\"\n[system]\nmass = {:?}\ndamping = {:?}\nstiffness = {:?}\n\
         force = {:?}\nforcing = [{{ cos = {:?} }}]\n[[stops]]\nname = \"lower\"\nrow = {x:?}\noffset = -1\n\
         harmonics = [{{ sin = {shake} }}, {{ k = 2, sin = {second} }}]\nrestitution = {tau}\n[[tasks]]\n\
         name = \"r\"\n{task}\n",
        form(1.0, 1.0),
        form(*c, damping),
        form(*k, stiffness),
        along(*force, 0.0),
        along(*drive, 0.7),
    )
}

#[test]
fn an_oscillator_beside_one_that_rests_takes_no_part() {
    let mut random = Random(42);
    let mut between = |lo: f64, hi: f64| lo + (hi - lo) * random.uniform();
    let (mut all, mut longer) = (0, 0);
    let draws: u32 = samples(5);
    for _ in 0..draws {
        let machine = Shaken {
            damping: between(0.05, 0.4),
            stiffness: between(0.05, 0.4),
            force: between(-2.0, -0.5),
            drive: between(0.0, 0.5),
            shake: between(0.8, 3.0),
            second: between(-0.3, 0.3),
            tau: between(0.1, 0.6),
        };
        let [damping, stiffness] = [between(0.05, 0.3), between(0.5, 3.0)];
        let one = found(&machine.text("many", "kind = \"rest\"\nperiods = 40"));
        assert!(one.complete);
        let known: Vec<&RestOrbitRow> = one.orbits.iter().filter(|row| row.period <= 4).collect();
        let two = run(&beside(&machine, [damping, stiffness], "kind = \"rest\"\nperiods = 100"));
        let two = match two.findings {
            Some(Findings::Rest(found)) => *found,
            other => panic!("{other:?}"),
        };
        let held = |row: &&RestOrbitRow| !row.held.is_empty();
        assert_eq!(two.orbits.iter().filter(held).count(), one.orbits.iter().filter(held).count());
        assert_eq!(two.orbits.len(), known.len(), "{machine:?}\n{two:?}\n{one:?}");
        for a in known {
            let at = |row: &RestOrbitRow| row.released.first().copied().unwrap_or(-1.0);
            let apart = |b: &&RestOrbitRow| (at(b) - at(a)).abs();
            let b = two
                .orbits
                .iter()
                .filter(|b| b.period == a.period)
                .min_by(|b, c| apart(b).total_cmp(&apart(c)));
            let b = b.unwrap_or_else(|| panic!("{a:?} {two:?}"));
            let turned = |all: &[f64]| {
                let first = (0..all.len()).min_by(|&i, &j| all[i].total_cmp(&all[j])).unwrap_or(0);
                [&all[first..], &all[..first]].concat()
            };
            for (x, y) in turned(&a.released).iter().zip(&turned(&b.released)) {
                near(*x, *y, 1e-9);
            }
            for (x, y) in turned(&a.rested).iter().zip(&turned(&b.rested)) {
                near(*x, *y, 1e-7);
            }
            assert!(a.resting - b.resting < 1e-7 && (a.fastest - b.fastest).abs() < 1e-8, "{a:?} {b:?}");
            // e^{λT} of y″ + d y′ + s y.
            let time = TAU * a.period as f64;
            let decay = (-0.5 * damping * time).exp();
            let turn = (stiffness - 0.25 * damping * damping).sqrt() * time;
            let [sum, squares] = traces(b);
            assert!((sum - 2.0 * decay * turn.cos()).abs() < 1e-9, "{b:?} {decay}");
            assert!((squares - 2.0 * decay * decay * (2.0 * turn).cos()).abs() < 1e-9, "{b:?}");
            assert_eq!((b.stable, b.multipliers.len()), (Judgement::Yes, 4));
            (all, longer) = (all + 1, longer + usize::from(a.period > 1));
        }
    }
    println!("{all} orbits, {longer} of several periods");
    assert!(2 * all > draws && (draws < 12 || 3 * all >= 2 * draws), "{all}");
}

/// Of what rests for ever, what the stop leaves free is an oscillator.
#[test]
fn what_rests_for_ever_is_an_orbit_of_what_is_left_free() {
    let machine = Table {
        mass: vec![vec![1.0, 0.0], vec![0.0, 0.5]],
        damping: vec![vec![0.1, 0.0], vec![0.0, 0.05]],
        stiffness: vec![vec![1.0, -0.2], vec![-0.2, 0.3]],
        force: vec![-4.0, 0.0],
        drive: vec![0.0, 0.2],
        row: vec![1.0, 0.0],
        shake: 0.0,
        tau: 0.5,
    };
    let report = run(&machine.text(SEARCHED));
    let text = report.to_string();
    let Some(Findings::Rest(found)) = report.findings else { panic!("{text}") };
    let [row] = &found.orbits[..] else { panic!("{text}") };
    assert_eq!((row.held.join(" "), row.resting, row.period), ("table".into(), 1.0, 1));
    assert!(row.stops.is_empty() && row.released.is_empty() && row.impacts == 0, "{row:?}");
    assert!(text.contains("complete         no, those that the search found"), "{text}");
    // q₂″/2 + q₂′/20 + 3 q₂/10 = −1/5 + cos t/5, with q₁ = −1.
    let size: f64 = (0.3f64 - 0.5).powi(2) + 0.05f64.powi(2);
    let [cos, sin] = [0.2 * (0.3 - 0.5) / size, 0.2 * 0.05 / size];
    assert!((row.q[1] - (-2.0 / 3.0 + cos)).abs() < 1e-9 && (row.u[1] - sin).abs() < 1e-9, "{row:?}");
    assert!((row.q[0] + 1.0).abs() < 1e-9 && row.u[0].abs() < 1e-9, "{row:?}");
    let (decay, turn) = ((-0.05 * TAU).exp(), (0.6f64 - 0.0025).sqrt() * TAU);
    let [sum, squares] = traces(row);
    assert!((sum - 2.0 * decay * turn.cos()).abs() < 1e-9, "{row:?}");
    assert!((squares - 2.0 * decay * decay * (2.0 * turn).cos()).abs() < 1e-9, "{row:?}");
}

/// Unit of length, phase, order of coordinates, and a motion beside another that it hits.
#[test]
fn a_search_finds_the_same_in_every_form() {
    let machine = Table {
        mass: vec![vec![1.0, 0.0], vec![0.0, 0.5]],
        damping: vec![vec![0.2, -0.05], vec![-0.05, 0.1]],
        stiffness: vec![vec![0.6, -0.5], vec![-0.5, 0.8]],
        force: vec![-1.0, 0.0],
        drive: vec![0.3, 0.1],
        row: vec![1.0, 0.0],
        shake: 1.2,
        tau: 0.4,
    };
    let text = machine.text(SEARCHED);
    let one = found(&text);
    let [known] = &one.orbits[..] else { panic!("{one:?}") };
    let scaled = |x: f64| format!("{}", x * 1000.0);
    let large = text
        .replace("force = [-1.0, 0.0]", &format!("force = [{}, 0]", scaled(-1.0)))
        .replace("cos = [0.3, 0.1]", "cos = [300, 100]")
        .replace("offset = -1", "offset = -1000")
        .replace("sin = 1.2", "sin = 1200");
    let later =
        text.replace("cos = [0.3, 0.1]", "sin = [0.3, 0.1]").replace("{ sin = 1.2 }", "{ cos = -1.2 }");
    let turned = Table {
        mass: vec![vec![0.5, 0.0], vec![0.0, 1.0]],
        damping: vec![vec![0.1, -0.05], vec![-0.05, 0.2]],
        stiffness: vec![vec![0.8, -0.5], vec![-0.5, 0.6]],
        force: vec![0.0, -1.0],
        drive: vec![0.1, 0.3],
        row: vec![0.0, 1.0],
        ..machine
    };
    for (form, unit, shift) in [(large, 1000.0, 0.0), (later, 1.0, 0.25), (turned.text(SEARCHED), 1.0, 0.0)] {
        let other = found(&form);
        let [row] = &other.orbits[..] else { panic!("{other:?}") };
        near(row.released[0], known.released[0] + shift, 1e-9);
        near(row.rested[0], known.rested[0] + shift, 1e-7);
        assert!((row.fastest / unit - known.fastest).abs() < 1e-9, "{row:?} {known:?}");
        for (a, b) in traces(row).iter().zip(traces(known)) {
            assert!((a - b).abs() < 1e-9, "{row:?} {known:?}");
        }
    }
}

#[test]
fn a_search_that_finds_nothing_says_how_far_it_looked() {
    let machine = Table {
        mass: vec![vec![1.0, 0.0], vec![0.0, 1.0]],
        damping: vec![vec![0.2, 0.0], vec![0.0, 0.2]],
        stiffness: vec![vec![0.5, -0.1], vec![-0.1, 0.7]],
        force: vec![3.0, 0.0],
        drive: vec![0.1, 0.0],
        row: vec![1.0, 0.0],
        shake: 0.1,
        tau: 0.5,
    };
    let report = run(&machine.text(SEARCHED));
    let text = report.to_string();
    assert_eq!(report.status.outcome().code(), 3, "{text}");
    assert!(text.contains("of 8 motions followed for 60 periods 0 came to a rest that ended"), "{text}");
    assert!(text.contains("there may be others: raise starts or longest"), "{text}");
}

/// Among dry friction, with a normal force that is given or the stop's: the orbit is one of the simulator,
/// and its multipliers are those of differences.
#[test]
fn orbits_that_rest_and_rub_have_the_multipliers_of_differences() {
    let mut random = Random(43);
    let (mut orbits, mut sticks, mut low, mut apart) = (0, 0, 0, 0.0f64);
    let draws: usize = samples(10);
    for draw in 0..draws {
        let machine = Table::drawn(&mut random, 2, false);
        let mut between = |lo: f64, hi: f64| lo + (hi - lo) * random.uniform();
        let row = [between(-1.0, 1.0), between(0.3, 1.0)];
        let (normal, coefficient) = (between(0.3, 1.0), between(0.1, 0.5));
        let given = if draw % 2 == 0 { format!("normal = {normal}") } else { "stop = \"table\"".into() };
        let friction = format!(
            "[[friction]]\nname = \"rubbing\"\nrow = {row:?}\n{given}\ncoefficient = {coefficient}\n[[tasks]]"
        );
        let text = machine.text(SEARCHED).replace("[[tasks]]", &friction);
        let found = match run(&text).findings {
            Some(Findings::Rest(found)) => *found,
            other => panic!("{other:?}"),
        };
        assert!(!found.complete);
        let scene = Scene::from_toml(&text, "rub.toml").unwrap();
        let simulator = Simulator::suited(&scene.machine(&[]).unwrap(), None, &[]).unwrap();
        for row in &found.orbits {
            if row.stable == Judgement::Marginal || !row.held.is_empty() {
                continue;
            }
            let (n, mut t) = (row.period as i64, TAU * row.released[0]);
            let after = |x: &[f64], t: f64, until: Time| {
                let mut run = simulator.start(Time::new(0, t), &x[..2], &x[2..]).unwrap();
                let end = run.finish(until);
                assert_eq!((end, run.failure().is_none()), (RunEnd::Reached, true));
                [run.state().q(), run.state().u()].concat()
            };
            // Into the flight after the release.
            let mut x = [&row.q[..], &row.u[..]].concat();
            let mut run = simulator.start(Time::new(0, t), &x[..2], &x[2..]).unwrap();
            let end = Time::new(n, t);
            let flight = loop {
                let event = run.next(end);
                let gone = run.time().since(Time::new(0, t));
                if gone > 1e-3 || matches!(event, Event::End(_)) {
                    break gone;
                }
            };
            x = after(&x, t, Time::new(0, t + 0.5 * flight));
            t += 0.5 * flight;
            let back = after(&x, t, Time::new(n, t));
            let off = back.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9 * size(&x), "{text}\n{row:?} {off}");
            // Nothing beside it is to lie behind the stop.
            if dot(&machine.row, &x[..2]) + 1.0 - machine.shake * t.sin() < 1e-3 {
                low += 1;
                continue;
            }
            let differences = |h: f64| -> [f64; 2] {
                let column = |j: usize| -> Vec<f64> {
                    let moved = |h: f64| {
                        let mut x = x.clone();
                        x[j] += h;
                        after(&x, t, Time::new(n, t))
                    };
                    moved(h).iter().zip(moved(-h)).map(|(a, b)| (a - b) / (2.0 * h)).collect()
                };
                let slope: Vec<Vec<f64>> = (0..4).map(column).collect();
                let pair = |i: usize, j: usize| slope[i][j] * slope[j][i];
                let square = (0..4).map(|i| (0..4).map(|j| pair(i, j)).sum::<f64>()).sum();
                [(0..4).map(|i| slope[i][i]).sum(), square]
            };
            let own = traces(row);
            // The bounces that are left out make steps of 10⁻¹⁰ in the map, and long steps lead past changes.
            let off = [1e-4, 1e-5, 1e-6].map(|h| {
                let other = differences(h);
                (own[0] - other[0]).abs().max((own[1] - other[1]).abs())
            });
            let least = off.into_iter().fold(f64::INFINITY, f64::min);
            apart = apart.max(least);
            assert!(least < 1e-5, "{text}\n{row:?} {off:?}");
            orbits += 1;
            let mut run = simulator.start(Time::new(0, t), &x[..2], &x[2..]).unwrap();
            let mut stuck = 0;
            run.record(Time::new(n, t), |event| {
                stuck += usize::from(matches!(event, Event::Stick(stick) if stick.place > 0));
            });
            sticks += usize::from(stuck > 0);
        }
    }
    println!("{orbits} orbits, {sticks} that stick, {low} with a low flight, multipliers to {apart:e}");
    assert!(orbits * 10 >= draws && low * 4 <= orbits, "{orbits} {low}");
    assert!(draws < 30 || sticks > 0, "some stick on their way");
}

/// Beside one that runs away nothing attracts: the orbit is found, and that motions were lost is said.
#[test]
fn motions_that_a_search_loses_are_told_of() {
    let machine =
        Shaken { damping: 0.2, stiffness: 0.1, force: -1.0, drive: 0.3, shake: 1.6, second: 0.0, tau: 0.4 };
    let [known] = &found(&machine.text("many", super::TASK)).orbits[..] else { panic!("one orbit") };
    let report = run(&beside(&machine, [0.1, -1.0], "kind = \"rest\"\nperiods = 200"));
    let text = report.to_string();
    let Some(Findings::Rest(found)) = report.findings else { panic!("{text}") };
    let [row] = &found.orbits[..] else { panic!("{text}") };
    near(row.released[0], known.released[0], 1e-9);
    assert_eq!((row.stable, row.impacts), (Judgement::No, known.impacts));
    // e^{λT} with λ² + λ/10 − 1 = 0.
    let large = (0.5 * TAU * (4.01f64.sqrt() - 0.1)).exp();
    let small = (-0.5 * TAU * (4.01f64.sqrt() + 0.1)).exp();
    assert!((traces(row)[0] / (large + small) - 1.0).abs() < 1e-9, "{row:?}");
    assert!(
        text.contains("16 motions were not followed to their end; the first: it ended when it left"),
        "{text}"
    );
}
