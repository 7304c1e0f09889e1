//! Two walls that are each other's mirror images, both met: against Newton's method, the simulator, counted
//! words, and what must be refused.

use crate::samples::samples;
use std::{
    collections::HashSet,
    f64::consts::{FRAC_PI_2, PI, TAU},
};

use grazing_scenes::{
    certificate,
    motion::{Side, Time},
    one::{
        orbit::{Itinerary, Oscillator, Strike, find},
        simulate::{Event, Settings, Simulator},
    },
    run::{ChaosFindings, Findings, Job, Status, Surroundings, run_task},
    scene::Scene,
};

pub(super) const STOPS: &str = include_str!("../../../examples/scenes/two-stops-chaos.toml");
const BOX: &str = include_str!("../../../examples/scenes/shaken-box-chaos.toml");

/// What a task of a scene comes to.
fn outcome(text: &str, name: &str) -> Result<(ChaosFindings, Status), String> {
    let scene = Scene::from_toml(text, "test").map_err(|error| error.to_string())?;
    let task = scene.tasks.iter().find(|task| task.name == name).unwrap();
    let job = Job::new(&scene, task, Surroundings::default()).map_err(|error| error.to_string())?;
    let report = run_task(&job, &mut ());
    match report.findings {
        Some(Findings::Chaos(found)) => Ok((*found, report.status)),
        _ => Err(report.status.reason().unwrap_or_default().to_string()),
    }
}

pub(super) fn proved(text: &str, name: &str) -> ChaosFindings {
    let (found, status) = outcome(text, name).unwrap();
    assert_eq!(status, Status::Done, "{found:?}");
    assert!(found.half && found.ceiling.is_none());
    certificate::check(&mut found.proof.as_ref().unwrap().accepted.text().as_bytes()).unwrap();
    found
}

/// Twice the logarithm of 1/z, z the root of a sum of powers equal to 1.
fn entropy(letters: &[i32]) -> f64 {
    let (mut lo, mut hi) = (0.0, 1.0);
    for _ in 0..60 {
        let z: f64 = 0.5 * (lo + hi);
        if letters.iter().map(|&n| z.powi(n)).sum::<f64>() < 1.0 { lo = z } else { hi = z }
    }
    -2.0 * hi.ln()
}

#[test]
fn the_examples_close_with_the_entropy_per_period() {
    for (text, name, letters, complete) in [
        (STOPS, "touched", &[1, 2, 3][..], true),
        (STOPS, "farther", &[1, 2], false),
        (BOX, "rattle", &[1, 3, 5], false),
        (BOX, "wide", &[1, 3], false),
    ] {
        let found = proved(text, name);
        let periods: Vec<u64> = letters.iter().map(|&n| n as u64).collect();
        assert_eq!((found.alphabet.clone(), found.full), (periods, true), "{name}");
        let stated: f64 = found.entropy.unwrap().parse().unwrap();
        assert!((stated - entropy(letters)).abs() < 1e-9, "{name}: {stated}");
        assert_eq!(found.complete.is_some(), complete, "{name}");
    }
    // The paper's oscillator with a wall above, before the touch. After a leg of 1 or 3/2 periods none of 1
    // follows: det(I − M(z)) = 0.
    let found = proved(STOPS, "before");
    assert_eq!((found.alphabet.clone(), found.full), (vec![1, 2, 3], false));
    let z = (-0.5 * found.entropy.unwrap().parse::<f64>().unwrap()).exp();
    // M has the rows (z, z², z³), (z, 0, z³), (z, 0, z³).
    let determinant = (1.0 - z) * (1.0 - z.powi(3)) - z * z * z - z.powi(4);
    assert!(determinant.abs() < 1e-9, "{determinant}");
}

/// An impact of the fixed stops: its wall, its time after the last impact, V before, and V after.
struct Met {
    side: Side,
    time: f64,
    speed: f64,
}

/// The orbit of a word of half periods between the fixed stops, at an amplitude, as Newton's method finds it:
/// admissible, and in the boxes of its letters. A word of odd length in half periods is taken twice: its
/// orbit is its own mirror image.
fn confirm(found: &ChaosFindings, mu: f64, word: &[u64]) -> Vec<Met> {
    let scene = Scene::from_toml(STOPS, "test").unwrap();
    let system = scene.plain(&[("mu", mu)]).unwrap();
    let (depth, tau) = (mu / (1.0 + mu), 0.8);
    let odd = word.iter().sum::<u64>() % 2 == 1;
    let word = if odd { word.repeat(2) } else { word.to_vec() };
    let m = word.len();
    let letter = |i: usize| found.letters.iter().find(|row| row.periods == word[i % m]).unwrap();
    let middle = |range: [f64; 2]| 0.5 * (range[0] + range[1]);
    let (mut strikes, mut start) = (Vec::new(), Vec::new());
    // The upper stop is nearest the motion without stops at 0, the lower one at π.
    let mut lower = true;
    let mut sides = Vec::new();
    for (i, &halves) in word.iter().enumerate() {
        sides.push(lower);
        let (after, before) = (middle(letter(i).after), middle(letter(i + m - 1).before));
        let strength = 2.0 * (after + tau * before) / (1.0 + tau);
        start.push(if lower { PI } else { 0.0 } - (0.5 * depth * strength).asin());
        start.push(mu * (after - before) / (1.0 + tau));
        let from_lower = u64::from(lower && halves % 2 == 1);
        let periods = (halves / 2 + from_lower) as u32;
        strikes.push(Strike { place: if lower { Side::Lower } else { Side::Upper }, periods });
        lower ^= halves % 2 == 1;
    }
    let oscillator = Oscillator::new(system, 1e-13).unwrap();
    let orbit = find(&oscillator, &Itinerary::new(strikes).unwrap(), start).unwrap();
    assert!(orbit.admissibility.is_admissible(), "{word:?}");
    for (i, z) in orbit.z.chunks(2).enumerate() {
        // Relative to (1 + µ) cos t, mirrored at the upper stop, in units of µ.
        let sign = if sides[i] { 1.0 } else { -1.0 };
        let still = sign * (1.0 + mu) * z[0].sin();
        let (after, before) = ((tau * z[1] + still) / mu, (-z[1] + still) / mu);
        let ([a, b], [c, d]) = (letter(i).after, letter(i + m - 1).before);
        assert!(a < after && after < b && c < before && before < d, "{word:?} {i}: {after} {before}");
    }
    let impacts = orbit.z.chunks(2).zip(&sides);
    impacts
        .map(|(z, &lower)| Met {
            side: if lower { Side::Lower } else { Side::Upper },
            time: z[0],
            speed: z[1],
        })
        .collect()
}

/// All primitive words over {1/2, 1, 3/2} of at most four letters, one of each class of rotations, have their
/// orbits in the boxes, with the walls that they say: 32 = 3 + 3 + 8 + 18.
#[test]
fn newton_finds_all_short_words_at_both_walls() {
    let found = proved(STOPS, "touched");
    let mut count = 0;
    for m in 1..=4 {
        for code in 0..3u64.pow(m) {
            let word: Vec<u64> = (0..m).map(|i| 1 + code / 3u64.pow(i) % 3).collect();
            let rotations = || (1..m as usize).map(|r| [&word[r..], &word[..r]].concat());
            if rotations().all(|other| word < other) {
                count += 1;
                confirm(&found, 0.002, &word);
            }
        }
    }
    assert_eq!(count, 32);
}

/// Random words of 50 letters; GRAZING_SAMPLES times as many. The simulator, begun after each impact, meets
/// the next at the wall and time where Newton's method has it, and none of both walls before.
#[test]
fn the_simulator_confirms_random_words_with_their_walls() {
    let found = proved(STOPS, "touched");
    let trials: u64 = samples(3);
    let mut state = 11u64;
    let mut letter = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        1 + (state >> 33) % 3
    };
    let mut met = HashSet::new();
    for trial in 0..trials {
        let mu = 0.002 / (1 << (trial % 4)) as f64;
        let word: Vec<u64> = (0..50).map(|_| letter()).collect();
        let impacts = confirm(&found, mu, &word);
        let system = Scene::from_toml(STOPS, "test").unwrap().plain(&[("mu", mu)]).unwrap();
        let simulator = Simulator::new(&system, &Settings::default()).unwrap();
        for (i, from) in impacts.iter().enumerate() {
            let to = &impacts[(i + 1) % impacts.len()];
            let phase = from.time.rem_euclid(TAU);
            let sign = if from.side == Side::Lower { 1.0 } else { -1.0 };
            let start = Time::new(0, phase);
            let mut run = simulator.start(start, sign * (1e-15 - 1.0), sign * 0.8 * from.speed).unwrap();
            let Event::Impact(impact) = run.next(Time::new(8, 0.0)) else { panic!("no impact") };
            // A leg of h half periods, each impact off the middle of its own window.
            let off = |met: &Met| met.time - if met.side == Side::Lower { PI } else { 0.0 };
            let expected = PI * word[i % 50] as f64 + off(to) - off(from);
            let elapsed = TAU * impact.time.period as f64 + impact.time.phase - phase;
            assert!((elapsed - expected).abs() < 1e-7, "leg {i} of {word:?}: {elapsed} {expected}");
            let same = word[i % 50].is_multiple_of(2);
            assert_eq!((impact.place, from.side == to.side), (to.side, same), "leg {i}");
            assert!((impact.velocity + to.speed).abs() < 1e-7);
            met.insert((from.side, word[i % 50]));
        }
    }
    assert_eq!(met.len(), 6);
}

/// How often which stop is met in each half period from π/2 on, and the end, for the start at x of a line.
fn shot(simulator: &Simulator, mu: f64, x: f64, halves: usize) -> (f64, [f64; 2], Vec<[u8; 2]>) {
    let mut word = vec![[0; 2]; halves];
    // Off the motion without stops, (1 + µ) cos t, which is at 0 with the velocity −(1 + µ).
    let mut run = simulator.start(Time::new(0, FRAC_PI_2), 8.0 * mu * x, -(1.0 + mu) - 8.0 * mu * x).unwrap();
    let end = FRAC_PI_2 + PI * halves as f64;
    let time = |time: Time| TAU * time.period as f64 + time.phase;
    run.record(Time::new((end / TAU).floor() as i64, end.rem_euclid(TAU)), |event| {
        if let Event::Impact(impact) = event {
            let window = ((time(impact.time) - FRAC_PI_2) / PI) as usize;
            word[window.min(halves - 1)][usize::from(impact.place == Side::Upper)] += 1;
        }
    });
    let state = run.state();
    (x, [state.q / mu, state.u / mu], word)
}

/// Words of half periods, by which stop is met, as the simulator finds them from a line of states: at least
/// as many as the proof says, and up to three half periods all of the shift, at alternate stops.
#[test]
fn simulated_motions_between_stops_have_the_entropy_that_is_proved() {
    let proved: f64 = proved(STOPS, "touched").entropy.unwrap().parse().unwrap();
    let mu = 0.001;
    let system = Scene::from_toml(STOPS, "test").unwrap().plain(&[("mu", mu)]).unwrap();
    let simulator = Simulator::new(&system, &Settings::default()).unwrap();
    for halves in 1..=4usize {
        let mut found = HashSet::new();
        let mut open: Vec<_> =
            (0..=100).map(|i| shot(&simulator, mu, 1.0 - f64::from(i) / 50.0, halves)).collect();
        // The last two are neighbours on the line.
        while let [.., next, last] = &open[..] {
            let distance = (next.1[0] - last.1[0]).hypot(next.1[1] - last.1[1]);
            if distance > 0.5 && next.0 - last.0 > 1e-15 {
                let middle = shot(&simulator, mu, 0.5 * (next.0 + last.0), halves);
                open.insert(open.len() - 1, middle);
            } else {
                found.extend(open.pop().map(|shot| shot.2));
            }
        }
        found.extend(open.pop().map(|shot| shot.2));
        // The window about π is the lower stop's; {1/2, 1, 3/2} leaves no three windows out in a row.
        let near = |word: &&Vec<[u8; 2]>| {
            let one = |(j, met): (usize, &[u8; 2])| met[j % 2] < 2 && met[(j + 1) % 2] == 0;
            word.iter().enumerate().all(one) && !word.windows(3).any(|w| w == [[0, 0]; 3])
        };
        let near = found.iter().filter(near).count();
        let estimate = (found.len() as f64).ln() / (0.5 * halves as f64);
        println!("{halves} half periods: {} words, {near} of the shift, estimate {estimate:.4}", found.len());
        assert!(estimate >= proved, "{halves}: {estimate} < {proved}");
        if halves < 4 {
            assert_eq!(near, [2, 4, 7][halves - 1], "{found:?}");
        }
    }
}

/// The scene's walls, forcing and task replaced.
fn scene(system: &str, [lower, upper]: [&str; 2], task: &str) -> String {
    format!(
        "format = \"grazing-scene 1\"\ntitle = \"x\"\n[parameters]\nmu = 0.001\ntau = 0.8\n[system]\n{system}\n\
         [[walls]]\nside = \"lower\"\n{lower}\n[[walls]]\nside = \"upper\"\n{upper}\n\
         [[tasks]]\nname = \"x\"\nkind = \"chaos\"\n{task}\n"
    )
}

const SPRING: &str = "damping = \"1/8\"\nstiffness = \"25/16\"";
const PAIR: [&str; 2] = [
    "offset = -1\nrestitution = \"tau\"\nharmonics = [{ cos = 1.001 }]",
    "offset = 1\nrestitution = \"tau\"\nharmonics = [{ cos = 1.001 }]",
];

/// What is missing of the symmetry is said.
#[test]
fn walls_that_are_no_mirror_images_are_refused() {
    let task = "alphabet = [\"1/2\", 1]";
    let with = |old: &str, new: &str| PAIR[1].replace(old, new);
    let even = format!("{SPRING}\nforcing = [{{ k = 2, cos = 0.1 }}]");
    let odd = format!("{SPRING}\nforcing = [{{ k = 3, cos = 0.0001 }}]");
    let force = format!("{SPRING}\nforce = 0.01");
    let cell = format!("{task}\ncell = {{ tau = [0.79, 0.81] }}");
    for (system, upper, task, reason) in [
        (SPRING, with("tau", "tau/2"), task, "restitutions differ"),
        (SPRING, with("offset = 1", "offset = 1.1"), task, "means are not at the same distance"),
        (&force, PAIR[1].into(), task, "means are not at the same distance"),
        (SPRING, with("1.001", "1.002"), task, "harmonic 1 of the upper one"),
        (SPRING, with("cos = 1.001", "cos = -0.5"), task, "harmonic 1 of the upper one"),
        (SPRING, with("{ cos = 1.001 }", "{ cos = 1.001 }, { k = 2, sin = 0.1 }"), task, "harmonic 2"),
        (&even, PAIR[1].into(), task, "harmonic 2 of the upper one"),
        ("force = -0.1", PAIR[1].into(), task, "constant force that no spring balances"),
        (SPRING, with("\"tau\"", "0.8"), &cell, "the same expression"),
        (SPRING, PAIR[1].into(), "alphabet = [\"1/3\", 1]", "whole or half number"),
        (SPRING, PAIR[1].into(), "alphabet = [0, \"1/2\"]", "increasing"),
        (SPRING, PAIR[1].into(), "alphabet = [\"1/2\", 1]\nside = \"lower\"", "half periods"),
        (SPRING, PAIR[1].into(), "side = \"lower\"\nhistory = [\"1/2\", 2]", "half periods"),
        (SPRING, PAIR[1].into(), "alphabet = [1, 2]\nhistory = [1, \"3/2\"]", "history"),
        (SPRING, PAIR[1].into(), "alphabet = [\"1/2\", 1]\nfollow = [[1], [\"3/2\"]]", "follow"),
    ] {
        let error = outcome(&scene(system, [PAIR[0], &upper], task), "x").map(|_| ()).unwrap_err();
        assert!(error.contains(reason), "{reason}: {error}");
    }
    // An odd harmonic more of the forcing leaves the symmetry; so does a wall that moves twice as fast, in
    // its own time.
    let found = proved(&scene(&odd, PAIR, task), "x");
    assert!(found.oscillator.contains("cos 3t"), "{}", found.oscillator);
    let fast = PAIR.map(|wall| wall.replace("{ cos", "{ k = 2, cos"));
    let doubled = "damping = \"1/4\"\nstiffness = \"25/4\"";
    let twice = proved(&scene(doubled, [&fast[0], &fast[1]], task), "x");
    let once = proved(&scene(SPRING, PAIR, task), "x");
    assert_eq!((twice.proof, twice.depth), (once.proof, once.depth));
}

/// Nothing is proved where it cannot be so.
#[test]
fn negative_controls_between_walls_stay_undecided() {
    let wide = PAIR.map(|wall| wall.replace("1.001", "1.4"));
    let few = PAIR.map(|wall| wall.replace("1.001", "0.99"));
    for (walls, task) in [
        // Walls far beyond the touch.
        ([&wide[0][..], &wide[1]], "alphabet = [\"1/2\", 1]"),
        // Before the touch this oscillator has other letters.
        ([&few[0], &few[1]], "alphabet = [\"1/2\", 1]"),
        // The paper's one-walled letters would pass through the wall above.
        (PAIR, "alphabet = [2, 3]"),
    ] {
        let (found, status) = outcome(&scene(SPRING, walls, task), "x").unwrap();
        assert!(matches!(status, Status::Undecided { .. }), "{task}: {found:?}");
        assert!(!found.proved && found.proof.is_none() && found.letters.is_empty());
        assert!(status.reason().unwrap().contains("does not rule out chaos"));
    }
}
