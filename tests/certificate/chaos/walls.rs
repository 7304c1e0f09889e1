//! Walls of several harmonics, oscillators with one normal form, two walls.

use std::f64::consts::PI;

use grazing_scenes::{
    motion::{Harmonic, Side, System},
    one::orbit::{Itinerary, Oscillator, Strike, find},
    run::{ChaosFindings, Findings, Job, Surroundings, run_task},
    scene::Scene,
};

/// A forced oscillator with a fixed stop, above, with preload, is the paper's in other words.
#[test]
fn equivalent_oscillators_have_one_normal_form() {
    let depth = |system: &str, wall: &str| {
        let text = format!(
            "format = \"grazing-scene 1\"\ntitle = \"x\"\n[system]\ndamping = \"12/49\"\nstiffness = \"100/2401\"\n{system}\n\
             [[walls]]\nrestitution = 1\n{wall}\n[[tasks]]\nname = \"x\"\nkind = \"chaos\"\nalphabet = [1, 2]\n"
        );
        let scene = Scene::from_toml(&text, "test").unwrap();
        let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
        let Some(Findings::Chaos(found)) = run_task(&job, &mut ()).findings else { panic!() };
        assert!(found.proved);
        (found.depth, found.proof.unwrap().accepted.text().to_string())
    };
    let (expected, text) = depth("", "side = \"lower\"\noffset = \"-1000/1003\"\nharmonics = [{ cos = 1 }]");
    assert!((expected[0] - 3.0 / 1003.0).abs() < 1e-15);
    let (above, same) = depth("", "side = \"upper\"\noffset = \"1000/1003\"\nharmonics = [{ sin = 1 }]");
    assert_eq!((above, same), (expected, text.clone()));
    let (loaded, same) = depth(
        "force = \"100/2401\"",
        "side = \"lower\"\noffset = \"1 - 1000/1003\"\nharmonics = [{ cos = 1 }]",
    );
    assert_eq!((loaded, same), (expected, text));
    // x = q + cos t has this forcing, and a fixed stop.
    let forced = "forcing = [{ cos = \"1 - 100/2401\", sin = \"12/49\" }]";
    let (forced, _) = depth(forced, "side = \"lower\"\noffset = \"-1000/1003\"\nharmonics = []");
    assert!((forced[0] - expected[0]).abs() < 1e-11 && (forced[1] - expected[1]).abs() < 1e-11);
}

/// The paper's oscillator with other walls.
fn with_walls(walls: &str, task: &str) -> (Scene, ChaosFindings) {
    let text = format!(
        "format = \"grazing-scene 1\"\ntitle = \"x\"\n[parameters]\nmu = 0.003\n[system]\ndamping = \"12/49\"\n\
         stiffness = \"100/2401\"\n{walls}\n[[tasks]]\nname = \"x\"\nkind = \"chaos\"\n{task}\n"
    );
    let scene = Scene::from_toml(&text, "test").unwrap();
    let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
    let report = run_task(&job, &mut ());
    let Some(Findings::Chaos(found)) = report.findings else { panic!("{:?}", report.status) };
    (scene, *found)
}

fn place(system: &System<f64>, t: f64) -> f64 {
    let wall = system.lower.as_ref().unwrap();
    let one = |h: &Harmonic<f64>| {
        let angle = f64::from(h.k) * t;
        h.cos * angle.cos() + h.sin * angle.sin()
    };
    wall.offset + wall.harmonics.iter().map(one).sum::<f64>()
}

/// Newton's method, which knows nothing of tops and normal forms, finds the orbits of walls of several
/// harmonics in the boxes.
#[test]
fn walls_of_three_harmonics_have_their_orbits_in_the_boxes() {
    for (motion, shift) in [
        ("{ cos = 1 }, { k = 2, cos = 0.05 }, { k = 3, cos = -0.01 }", 0.0),
        ("{ cos = -1 }, { k = 2, cos = 0.04 }", PI),
        (
            "{ cos = 1, sin = 0.1 }, { k = 2, cos = 0.05, sin = -0.04 }, { k = 3, cos = -0.01, sin = 0.02 }",
            0.0,
        ),
    ] {
        let wall = |offset: &str| {
            format!("[[walls]]\nside = \"lower\"\noffset = {offset}\nrestitution = 1\nharmonics = [{motion}]")
        };
        // The top is found by looking; then the wall is put so that it rises 0.004 above the place of rest.
        let (scene, _) = with_walls(&wall("-1"), "alphabet = [1, 2]");
        let system = scene.plain(&[]).unwrap();
        let phases = (0..=200_000).map(|i| shift - 0.5 + f64::from(i) * 5e-6);
        let top = phases.max_by(|&a, &b| place(&system, a).total_cmp(&place(&system, b))).unwrap();
        let offset = format!("{:.9}", 0.004 - (place(&system, top) + 1.0));
        let (scene, found) = with_walls(&wall(&offset), "alphabet = [1, 2]");
        assert!(found.proved && found.complete.is_some(), "{found:?}");
        let system = scene.plain(&[]).unwrap();
        let unit = place(&system, top);
        let speed = |t: f64| (place(&system, t + 1e-6) - place(&system, t - 1e-6)) / 2e-6;
        let oscillator = Oscillator::new(scene.plain(&[]).unwrap(), 1e-13).unwrap();
        for pattern in [&[1u32][..], &[2], &[1, 2], &[1, 1, 2], &[1, 2, 2], &[1, 1, 2, 2]] {
            let letter = |i: usize| {
                let periods = u64::from(pattern[i % pattern.len()]);
                found.letters.iter().find(|row| row.periods == periods).unwrap()
            };
            let strikes = pattern.iter().map(|&periods| Strike { place: Side::Lower, periods }).collect();
            let start = pattern.iter().flat_map(|_| [top, 0.4 * unit]).collect();
            let orbit = find(&oscillator, &Itinerary::new(strikes).unwrap(), start).unwrap();
            assert!(orbit.admissibility.is_admissible(), "{pattern:?}");
            for (i, z) in orbit.z.chunks(2).enumerate() {
                let (after, before) = ((speed(z[0]) + z[1]) / unit, (speed(z[0]) - z[1]) / unit);
                let ([a, b], [c, d]) = (letter(i).after, letter(i + pattern.len() - 1).before);
                // The speed is a difference quotient, and the unit known to 1e-9.
                assert!(a - 1e-5 < after && after < b + 1e-5, "{pattern:?}: {after} {a} {b}");
                assert!(c - 1e-5 < before && before < d + 1e-5, "{pattern:?}: {before} {c} {d}");
            }
        }
    }
}

/// A wall that moves twice per forcing period is one that moves once in half the time.
#[test]
fn a_wall_of_the_second_harmonic_alone_is_plain() {
    let text = |k: u32| {
        let (damping, stiffness) = (f64::from(k) * 0.25, f64::from(k * k) * 0.0625);
        let text = format!(
            "format = \"grazing-scene 1\"\ntitle = \"x\"\n[system]\ndamping = {damping}\nstiffness = {stiffness}\n\
             [[walls]]\nside = \"lower\"\noffset = -1\nrestitution = 1\nharmonics = [{{ k = {k}, sin = 1.001 }}]\n\
             [[tasks]]\nname = \"x\"\nkind = \"chaos\"\nalphabet = [1, 2]\n"
        );
        let scene = Scene::from_toml(&text, "test").unwrap();
        let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
        let Some(Findings::Chaos(found)) = run_task(&job, &mut ()).findings else { panic!() };
        (found.oscillator, found.letters, found.failures)
    };
    assert_eq!(text(1), text(2));
}

/// The second wall is shown to be out of reach, or nothing is proved.
#[test]
fn of_two_walls_the_other_is_out_of_reach() {
    let walls = |offset: &str| {
        format!(
            "[[walls]]\nside = \"lower\"\noffset = -1\nrestitution = 1\nharmonics = [{{ cos = \"1 + mu\" }}]\n\
             [[walls]]\nside = \"upper\"\nrestitution = 1\noffset = {offset}\nharmonics = [{{ k = 3, sin = 0.01 }}]"
        )
    };
    let task = "alphabet = [1, 2, 3]\nside = \"lower\"";
    let (_, found) = with_walls(&walls("0.35"), task);
    let (reach, ceiling) = (found.reach.unwrap(), found.ceiling.unwrap());
    // (0.35 − 0.01)/µ.
    assert!(found.proved && (ceiling - 0.34 / 0.003).abs() < 1e-9 && reach < ceiling);
    let (_, found) = with_walls(&walls("0.2"), task);
    assert!(!found.proved && found.proof.is_none() && found.letters.is_empty());
    assert!(found.failures[0].reason.contains("the other wall may be met"), "{found:?}");
}

/// A ball between a table and a ceiling, wherever the origin is: between two impacts two periods apart it
/// rises by f T²/8 = f π²/2 · 4 ≈ 1.97 above the place of the first, which is at most 1 above the table's
/// mean.
#[test]
fn a_ceiling_is_measured_from_the_table() {
    let task = "alphabet = [1, 2]\nside = \"lower\"";
    let found = |table: f64, above: f64| {
        let text = format!(
            "format = \"grazing-scene 1\"\ntitle = \"x\"\n[system]\nforce = \"-0.1\"\n\
             [[walls]]\nside = \"lower\"\noffset = {table}\nrestitution = \"1/2\"\nharmonics = [{{ sin = 1 }}]\n\
             [[walls]]\nside = \"upper\"\noffset = {}\nrestitution = 1\n\
             [[tasks]]\nname = \"x\"\nkind = \"chaos\"\n{task}\n",
            table + above
        );
        let scene = Scene::from_toml(&text, "test").unwrap();
        let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
        let Some(Findings::Chaos(found)) = run_task(&job, &mut ()).findings else { panic!() };
        *found
    };
    for table in [0.0, 8.0, -8.0] {
        let (low, high) = (found(table, 2.5), found(table, 4.0));
        assert_eq!((low.proved, high.proved), (false, true), "{table}");
        assert!(low.failures[0].reason.contains("the other wall may be met"), "{low:?}");
        assert!((high.ceiling.unwrap() - 4.0).abs() < 1e-9);
    }
}

/// A still stop under a forcing of two harmonics with sines: what is seen from the motion without the stop is
/// a wall of two. Newton's method, on the oscillator as it is given, has its orbits at the phases of those
/// boxes, and the certificate is that of the wall that moves.
#[test]
fn a_forcing_of_several_harmonics_is_a_wall_of_several() {
    // x = q + cos t + (cos 2t)/20 + (sin 2t)/25 for c = 12/49, k = 100/2401.
    let (c, k) = (12.0 / 49.0, 100.0 / 2401.0);
    let forced = |j: f64, a: f64, b: f64| {
        let (cos, sin) = ((k - j * j) * a + c * j * b, (k - j * j) * b - c * j * a);
        format!("{{ k = {j}, cos = {cos:.15}, sin = {sin:.15} }}")
    };
    let forcing = format!("forcing = [{}, {}]\n", forced(1.0, 1.0, 0.0), forced(2.0, 0.05, 0.04));
    let still = |offset: f64| {
        format!("{forcing}[[walls]]\nside = \"lower\"\noffset = {offset:.9}\nrestitution = 1\nharmonics = []")
    };
    let moving = |offset: f64| {
        format!(
            "[[walls]]\nside = \"lower\"\noffset = {offset:.9}\nrestitution = 1\n\
             harmonics = [{{ cos = -1 }}, {{ k = 2, cos = -0.05, sin = -0.04 }}]"
        )
    };
    let response = |t: f64| t.cos() + 0.05 * (2.0 * t).cos() + 0.04 * (2.0 * t).sin();
    let phases = (0..=1_000_000).map(|i| PI - 0.5 + f64::from(i) * 1e-6);
    let lowest = phases.min_by(|&a, &b| response(a).total_cmp(&response(b))).unwrap();
    let (unit, offset) = (-response(lowest), response(lowest) + 0.004);
    let task = "alphabet = [1, 2]";
    let (scene, found) = with_walls(&still(offset), task);
    assert!(found.proved && found.complete.is_some(), "{found:?}");
    let (_, same) = with_walls(&moving(offset), task);
    assert!((found.depth[0] - 0.004 / unit).abs() < 1e-8 && (found.depth[0] - same.depth[0]).abs() < 1e-12);
    for (one, other) in found.letters.iter().zip(&same.letters) {
        let ends = |row: &grazing_scenes::run::LetterRow| [row.after, row.before].concat();
        assert!(ends(one).iter().zip(ends(other)).all(|(a, b)| (a - b).abs() < 1e-6), "{one:?} {other:?}");
    }
    let oscillator = Oscillator::new(scene.plain(&[]).unwrap(), 1e-13).unwrap();
    let speed = |t: f64| -t.sin() - 0.1 * (2.0 * t).sin() + 0.08 * (2.0 * t).cos();
    for pattern in [&[1u32][..], &[2], &[1, 2], &[1, 1, 2]] {
        let strikes = pattern.iter().map(|&periods| Strike { place: Side::Lower, periods }).collect();
        let start = pattern.iter().flat_map(|_| [lowest, 0.002]).collect();
        let orbit = find(&oscillator, &Itinerary::new(strikes).unwrap(), start).unwrap();
        assert!(orbit.admissibility.is_admissible(), "{pattern:?}");
        for (i, z) in orbit.z.chunks(2).enumerate() {
            // Relative to the motion without the stop, in units of ν: −x₀′ ± V, over νH = 0.004.
            let (after, before) = ((z[1] - speed(z[0])) / 0.004, (-z[1] - speed(z[0])) / 0.004);
            let letter = |i: usize| {
                let periods = u64::from(pattern[i % pattern.len()]);
                found.letters.iter().find(|row| row.periods == periods).unwrap()
            };
            let ([a, b], [c, d]) = (letter(i).after, letter(i + pattern.len() - 1).before);
            assert!(a < after && after < b && c < before && before < d, "{pattern:?} {after} {before}");
        }
    }
}
