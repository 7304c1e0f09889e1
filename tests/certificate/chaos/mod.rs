//! Chaos proved: against Newton's method, the simulator, the word theorem, and damaged certificates.

use crate::common;
use crate::samples::samples;
mod damage;
mod edges;
mod entropy;
mod mirrored;
mod walls;

use std::f64::consts::TAU;

use grazing_scenes::{
    motion::{Side, Time},
    one::{
        orbit::{Itinerary, Oscillator, Strike, find},
        simulate::{Event, Settings, Simulator},
    },
    run::{ChaosFindings, Findings, Job, Status, Surroundings, run_task},
    scene::Scene,
    search::chaos::LetterGraph,
};

const EXAMPLE: &str = include_str!("../../../examples/scenes/nordmark-2001-chaos.toml");

/// What a task of the example with other keys finds.
fn found(task: &str) -> (ChaosFindings, Status) {
    let head = EXAMPLE.split("\n[[tasks]]").next().unwrap();
    let text = format!("{head}\n[[tasks]]\nname = \"x\"\nkind = \"chaos\"\n{task}\n");
    let scene = Scene::from_toml(&text, "test").unwrap();
    let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
    let report = run_task(&job, &mut ());
    match report.findings {
        Some(Findings::Chaos(found)) => (*found, report.status),
        other => panic!("{other:?} {:?}", report.status),
    }
}

fn proved(task: &str) -> ChaosFindings {
    let (found, status) = found(task);
    assert_eq!(status, Status::Done, "{found:?}");
    found
}

const FIGURE_10: &str = "parameter = \"mu\"\nfrom = 0\nto = 0.003";
const ALWAYS: &str = "alphabet = [1, 2]\nparameter = \"mu\"\nfrom = 0";

#[test]
fn the_paper_is_chaotic_where_it_says_so() {
    let found = proved(FIGURE_10);
    assert_eq!((found.alphabet.clone(), found.full), (vec![1, 2, 3], true));
    // The word theorem's entropy, root of z + z² + z³ = 1.
    assert_eq!(found.entropy.as_deref(), Some("0.6093778634"));
    assert!(found.contraction.unwrap() < 0.95);
    // Completeness in a neighbourhood that holds all of the boxes' impacts.
    let strongest = found.letters.iter().map(|row| row.after[1] - row.before[0]).fold(0.0, f64::max);
    assert!(found.complete.unwrap() > strongest, "{found:?}");
    let found = proved(ALWAYS);
    assert_eq!(found.depth, [0.0, 1.0]);
    // For small µ letter 3 is a neighbour of these boxes, for large µ other orbits are.
    assert_eq!(found.complete, None);
    let golden = (0.5 * (1.0 + 5f64.sqrt())).ln();
    assert!((found.entropy.unwrap().parse::<f64>().unwrap() - golden).abs() < 1e-9);
}

/// Where it cannot be so, nothing is proved, and no more is said.
#[test]
fn negative_controls_stay_undecided() {
    for task in [
        // Beyond µ* ≈ 0.0049 a speed of {1, 2, 3} reaches 0.
        "alphabet = [1, 2, 3]\nset = { mu = 0.006 }",
        // Before the grazing only the full shift over {4} and 1 is born.
        "alphabet = [1, 2]\nset = { mu = -0.001 }",
        "parameter = \"mu\"\nfrom = -0.001\nto = 0",
        // u_2 = 0.
        "alphabet = [1, 2]\nset = { d = 0.6, w = 3.2, mu = 0.001 }",
    ] {
        let (found, status) = found(task);
        assert!(matches!(status, Status::Undecided { .. }), "{task}: {found:?}");
        assert!(!found.proved && found.proof.is_none() && found.letters.is_empty());
        assert!(status.reason().unwrap().contains("does not rule out chaos"));
    }
}

/// Each pattern's orbit as Newton's method finds it; it is admissible and lies in the boxes of its letters.
fn confirm(found: &ChaosFindings, mu: f64, pattern: &[u64]) -> Vec<(f64, f64)> {
    let scene = Scene::from_toml(EXAMPLE, "test").unwrap();
    let system = scene.plain(&[("mu", mu)]).unwrap();
    let (scale, depth, m) = (1.0 + mu, mu / (1.0 + mu), pattern.len());
    let letter = |i: usize| found.letters.iter().find(|row| row.periods == pattern[i % m]).unwrap();
    let middle = |range: [f64; 2]| 0.5 * (range[0] + range[1]);
    let start = (0..m).flat_map(|i| {
        let (after, before) = (middle(letter(i).after), middle(letter(i + m - 1).before));
        [-(0.5 * depth * (after + before)).asin(), 0.5 * depth * scale * (after - before)]
    });
    let strikes = pattern.iter().map(|&n| Strike { place: Side::Lower, periods: n as u32 }).collect();
    let oscillator = Oscillator::new(system, 1e-13).unwrap();
    let orbit = find(&oscillator, &Itinerary::new(strikes).unwrap(), start.collect()).unwrap();
    assert!(orbit.admissibility.is_admissible(), "{pattern:?}");
    let impacts: Vec<(f64, f64)> = orbit.z.chunks(2).map(|z| (z[0], z[1])).collect();
    for (i, &(t, speed)) in impacts.iter().enumerate() {
        // Relative speeds V and τV = V, and the wall's velocity −(1 + µ) sin t, in units of µ.
        let (wall, relative) = (-t.sin() / depth, speed / (depth * scale));
        let (after, before) = (wall + relative, wall - relative);
        let ([a, b], [c, d]) = (letter(i).after, letter(i + m - 1).before);
        assert!(a < after && after < b && c < before && before < d, "{pattern:?} {i}: {after} {before}");
    }
    impacts
}

/// All primitive patterns over {1, 2, 3} with at most five impacts, one of each class of rotations: 80.
#[test]
fn newton_finds_all_short_patterns_in_the_boxes() {
    let found = proved(FIGURE_10);
    let mut count = 0;
    for m in 1..=5 {
        for code in 0..3u64.pow(m) {
            let pattern: Vec<u64> = (0..m).map(|i| 1 + code / 3u64.pow(i) % 3).collect();
            let rotations = || (1..m as usize).map(|r| [&pattern[r..], &pattern[..r]].concat());
            if rotations().all(|other| pattern < other) {
                count += 1;
                confirm(&found, 0.003, &pattern);
            }
        }
    }
    assert_eq!(count, 80);
}

/// Completeness against Newton's method: patterns with the periods 4 and 5 have no orbit all of whose impacts
/// are near.
#[test]
fn newton_finds_no_orbit_of_another_period_near() {
    let strength = proved(FIGURE_10).complete.unwrap();
    let (mu, depth) = (0.003, 3.0 / 1003.0);
    let system = Scene::from_toml(EXAMPLE, "test").unwrap().plain(&[("mu", mu)]).unwrap();
    let oscillator = Oscillator::new(system, 1e-13).unwrap();
    let (mut solved, mut far) = (0, 0);
    for m in 1..=2 {
        for code in 0..5u32.pow(m) {
            let pattern: Vec<u32> = (0..m).map(|i| 1 + code / 5u32.pow(i) % 5).collect();
            if pattern.iter().all(|&n| n < 4) {
                continue;
            }
            // From starts all over the neighbourhood.
            for (start, speed) in [(0.0, 1.0), (-1.0, 1.0), (1.0, 1.0), (-0.5, 10.0), (0.5, 10.0)] {
                let strikes = pattern.iter().map(|&periods| Strike { place: Side::Lower, periods }).collect();
                let z = pattern.iter().flat_map(|_| [start * depth * strength / 2.0, speed * mu]).collect();
                let Ok(orbit) = find(&oscillator, &Itinerary::new(strikes).unwrap(), z) else { continue };
                solved += 1;
                if orbit.admissibility.is_admissible() {
                    let away = |z: &[f64]| z[0].cos() <= 0.0 || z[0].sin().abs() > depth * strength / 2.0;
                    assert!(orbit.z.chunks(2).any(away), "{pattern:?}: {:?}", orbit.z);
                    far += 1;
                }
            }
        }
    }
    assert!(solved > 20, "{solved} solved, {far} of them admissible and far");
}

/// Random words of 50 letters; GRAZING_SAMPLES times as many. The simulator, begun after each impact, meets
/// the next where Newton's method has it.
#[test]
fn the_simulator_confirms_every_leg_of_random_words() {
    let found = proved(FIGURE_10);
    let trials: u64 = samples(3);
    let mut state = 7u64;
    let mut letter = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        1 + (state >> 33) % 3
    };
    for trial in 0..trials {
        let mu = 0.003 / (1 << (trial % 4)) as f64;
        let word: Vec<u64> = (0..50).map(|_| letter()).collect();
        let impacts = confirm(&found, mu, &word);
        let system = Scene::from_toml(EXAMPLE, "test").unwrap().plain(&[("mu", mu)]).unwrap();
        let simulator = Simulator::new(&system, &Settings::default()).unwrap();
        for (i, &(t, speed)) in impacts.iter().enumerate() {
            let (next, arriving) = impacts[(i + 1) % 50];
            let start = Time::new(0, t.rem_euclid(TAU));
            let (place, velocity) = ((1.0 + mu) * t.cos() - 1.0, -(1.0 + mu) * t.sin() + speed);
            let mut run = simulator.start(start, place + 1e-15, velocity).unwrap();
            let Event::Impact(impact) = run.next(Time::new(8, 0.0)) else { panic!("no impact") };
            let turns = if t < 0.0 { 1.0 } else { 0.0 };
            let at = TAU * (impact.time.period as f64 - turns) + impact.time.phase;
            let expected = TAU * word[i] as f64 + next;
            assert!((at - expected).abs() < 1e-7, "leg {i} of {word:?}: {at} {expected}");
            assert!((impact.velocity + arriving).abs() < 1e-7);
        }
    }
}

/// The graph born at the grazing has the letters and the entropy of the word theorem.
#[test]
fn gamma_below_zero_has_the_graph_of_the_word_theorem() {
    let found = proved("set = { d = 0.0266, w = 1.587 }\nparameter = \"mu\"\nfrom = -0.001\nto = 0");
    assert_eq!((found.alphabet.clone(), found.full), (vec![1, 2, 3], false));
    // `grazing word --r 0.9 --s 0.37`: 0.528048909513011.
    assert!(found.entropy.unwrap().starts_with("0.528048909"));
    assert!(found.range.ends_with("mu < 0"), "{}", found.range);
}

#[test]
fn histories_cells_and_restitution_close() {
    let found = proved("alphabet = [1, 2, 3]\nset = { mu = 0.0038 }\nhistory = [3, 3]");
    assert_eq!((found.letters.len(), found.full), (12, true));
    assert_eq!(found.entropy.as_deref(), Some("0.6093778634"));
    let found =
        proved("alphabet = [1, 2, 3]\nparameter = \"mu\"\nfrom = 0.0042\nto = 0.0044\nhistory = [3, 16]");
    assert_eq!((found.letters.len(), found.full), (51, true));
    assert_eq!(found.entropy.as_deref(), Some("0.6093778634"));
    proved(&format!("{ALWAYS}\nto = 1\ncell = {{ d = [0.598, 0.602], w = [4.89, 4.91] }}"));
    proved(&format!("{ALWAYS}\nset = {{ tau = 0.9 }}"));
    proved(&format!("{ALWAYS}\nset = {{ tau = 0.7 }}"));
}

#[test]
fn a_bouncing_ball_is_chaotic() {
    let text = r#"
        format = "grazing-scene 1"
        title = "a ball"
        [parameters]
        g = 0.1
        [system]
        force = "-g"
        [[walls]]
        side = "lower"
        offset = 3
        harmonics = [{ k = 1, sin = 1 }]
        restitution = "1/2"
        [[tasks]]
        name = "ball"
        kind = "chaos"
        alphabet = [1, 2]
        parameter = "g"
        from = 0.1
        to = 0.102
    "#;
    let scene = Scene::from_toml(text, "test").unwrap();
    let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
    assert_eq!(run_task(&job, &mut ()).status, Status::Done);
}

/// What the normal form does not cover is an error with its reason, not a verdict.
#[test]
fn what_is_not_covered_is_said() {
    let head = "format = \"grazing-scene 1\"\ntitle = \"x\"\n[parameters]\nmu = 0.1\n";
    let wall = "[[walls]]\nside = \"lower\"\noffset = -1\nrestitution = 1\nharmonics = [{ k = 1, cos = \"1 + mu\" }]\n";
    let task = "[[tasks]]\nname = \"x\"\nkind = \"chaos\"\nalphabet = [1, 2]\n";
    for (system, walls, keys, reason) in [
        ("stiffness = 1", "", "", "no wall"),
        ("stiffness = 1\ncubic = 1", wall, "", "linear"),
        ("damping = 1", wall, "", "without a spring"),
        ("stiffness = 1\nforcing = [{ cos = 1 }]", wall, "", "resonance"),
        ("stiffness = 4\nforcing = [{ k = 2, cos = 1 }]", wall, "", "resonance"),
        (
            "stiffness = 2",
            &format!("{wall}[[walls]]\nside = \"upper\"\noffset = 1\nrestitution = 1\n"),
            "",
            "side must say which wall is met",
        ),
        ("stiffness = 2", wall, "side = \"upper\"", "is no wall of the scene; there are lower"),
        ("stiffness = 2", wall, "parameter = \"mu\"\nfrom = -0.1\nto = 0.1", "grazes"),
        ("stiffness = 2", wall, "parameter = \"mu\"\nfrom = 0.1\nto = 0.05", "above from"),
        ("stiffness = 2", wall, "cell = { mu = [0.1, 0.2] }", "only damping"),
        ("stiffness = 2", wall, "cell = { mu = [0.2, 0.1] }", "increase"),
        ("stiffness = 2", wall, "follow = [[1]]", "one list per period"),
        (
            "stiffness = 2",
            &wall.replace("restitution = 1", "restitution = 0"),
            "",
            "restitution must be positive",
        ),
        ("stiffness = 2", &wall.replace("\"1 + mu\"", "0"), "", "must move"),
    ] {
        let text = format!("{head}[system]\n{system}\n{walls}{task}{keys}\n");
        let error = match Scene::from_toml(&text, "test") {
            Err(error) => error.to_string(),
            Ok(scene) => match Job::new(&scene, &scene.tasks[0], Surroundings::default()) {
                Err(error) => error.to_string(),
                Ok(_) => panic!("accepted: {keys} {system}"),
            },
        };
        assert!(error.contains(reason), "{reason}: {error}");
    }
}

/// A slower oscillator has more letters.
#[test]
fn six_letters_close_at_w_10() {
    let found = proved("alphabet = [1, 2, 3, 4, 5, 6]\nset = { w = 10, mu = 0.03 }");
    assert!(found.full && found.letters.len() == 6);
    // 1/z with z + … + z⁶ = 1.
    let rate: f64 = found.growth.unwrap().parse().unwrap();
    let sum: f64 = (1..=6).map(|n| rate.powi(-n)).sum();
    assert!((sum - 1.0).abs() < 1e-8);
    assert!(found.complete.is_some());
}

#[test]
fn histories_tell_the_same_words() {
    let graph = LetterGraph::full(&[1, 2, 3]);
    let deep = graph.with_history(3, 4);
    assert_eq!(deep.letters.len(), 15);
    assert!((deep.growth().0 - graph.growth().0).abs() < 1e-9);
}
