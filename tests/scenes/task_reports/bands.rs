//! The bands over drive and touch, against a solver of its own: from no start a motion hits for ever before
//! the first end.

use std::f64::consts::TAU;

use grazing_base::random::Random;
use grazing_scenes::{
    run::{Surroundings, run},
    scene::Scene,
};

use super::grazing_found;
use crate::samples::samples;

/// q″ + c q′ + k q = F cos t below a stop at 1 with restitution τ.
#[derive(Debug, Clone, Copy)]
struct Driven {
    c: f64,
    k: f64,
    restitution: f64,
}

impl Driven {
    fn scene(self, force: f64) -> String {
        let Driven { c, k, restitution } = self;
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = {force:?}\n[system]\ndamping = {c:?}\n\
             stiffness = {k:?}\nforcing = [{{ cos = \"F\" }}]\n[[stops]]\nname = \"stop\"\nside = \"upper\"\noffset = 1\n\
             restitution = {restitution:?}\n[[tasks]]\nname = \"it\"\nkind = \"grazing\"\nparameter = \"F\"\nmax_period = 1\n\
             range = false\n"
        )
    }

    /// (q, v) after a time from (q, v) at t: the motion in closed form.
    fn flow(self, force: f64, t: f64, [q, v]: [f64; 2], after: f64) -> [f64; 2] {
        let (half, turn) = (self.c / 2.0, (self.k - self.c * self.c / 4.0).sqrt());
        let size = (self.k - 1.0).powi(2) + self.c * self.c;
        let forced = |t: f64| {
            let (a, b) = (force * (self.k - 1.0) / size, force * self.c / size);
            [a * t.cos() + b * t.sin(), b * t.cos() - a * t.sin()]
        };
        let [from, to] = [forced(t), forced(t + after)];
        let (x, y) = (q - from[0], (v - from[1] + half * (q - from[0])) / turn);
        let (sin, cos) = (turn * after).sin_cos();
        let left = (-half * after).exp();
        let [here, speed] = [left * (x * cos + y * sin), left * (y * cos - x * sin) * turn];
        [to[0] + here, to[1] + speed - half * here]
    }

    /// How often it hits in the last 50 of so many periods: in steps, with halving to an impact, and held on
    /// the stop while the force presses.
    fn hits(self, force: f64, mut state: [f64; 2], periods: u32) -> u32 {
        const STEPS: u32 = 128;
        let (mut count, step) = (0, TAU / f64::from(STEPS));
        for i in 0..periods * STEPS {
            let (mut t, end) = (f64::from(i % STEPS) * step, f64::from(i % STEPS + 1) * step);
            while t < end {
                if state[0] >= 1.0 - 1e-12 && state[1].abs() < 1e-6 && force * t.cos() > self.k {
                    (state, t) = ([1.0, 0.0], end);
                    continue;
                }
                let next = self.flow(force, t, state, end - t);
                if next[0] <= 1.0 {
                    (state, t) = (next, end);
                    continue;
                }
                let (mut free, mut behind) = (0.0, end - t);
                for _ in 0..50 {
                    let middle = f64::midpoint(free, behind);
                    *(if self.flow(force, t, state, middle)[0] > 1.0 { &mut behind } else { &mut free }) =
                        middle;
                }
                let at = self.flow(force, t, state, free);
                state = [1.0 - 1e-13, -self.restitution * at[1].abs()];
                t += free.max(1e-9);
                count += u32::from(i >= (periods - 50) * STEPS);
            }
        }
        count
    }
}

#[test]
fn below_the_first_end_no_motion_of_a_second_solver_hits_for_ever() {
    let mut random = Random(3);
    let mut between =
        |low: f64, high: f64| low + (high - low) * (random.bits() >> 11) as f64 / (1u64 << 53) as f64;
    let (mut lower, mut wrong) = (0, Vec::new());
    for number in 0..samples::<u64>(2) {
        let machine = Driven { c: between(0.05, 0.4), k: between(0.1, 4.0), restitution: between(0.4, 0.9) };
        let touch = (machine.k - 1.0).hypot(machine.c);
        let (found, shown, _) = grazing_found(&machine.scene(between(0.1, 2.0) * touch));
        assert!((found.at.parameter / touch - 1.0).abs() < 1e-13, "{shown}");
        let bands = found.bands.unwrap_or_else(|| panic!("{machine:?} {shown}"));
        let first = &bands[0];
        // What is swept back and hits no more has left.
        let back = found.seen.unwrap().into_iter().find(|row| row.place == "back");
        assert!(back.is_none_or(|row| (row.what == "stays") == row.speed.is_some()), "{machine:?} {shown}");
        lower += u32::from(bands.len() == 3);
        assert!(first.band == "free" && bands.last().unwrap().least == Some(found.at.parameter), "{shown}");
        let end = first.most.unwrap();
        for part in [0.6, 0.9, 0.995] {
            for start in 0..samples::<u32>(20).min(67) {
                let state = if start == 0 { [0.0, 0.0] } else { [between(-6.0, 1.0), between(-6.0, 6.0)] };
                // A chaotic transient may be long.
                let hits = machine.hits(part * end, state, 400);
                if hits > 0 && machine.hits(part * end, state, 10_000) > 0 {
                    wrong.push(format!(
                        "{number} {machine:?} touch {touch} end {end} at {} from {state:?}: {hits}",
                        part * end
                    ));
                    break;
                }
            }
        }
        // Just above a lower end, one does.
        if bands.len() == 3 {
            let some = (0..400).any(|_| {
                machine.hits(f64::midpoint(end, touch), [between(-6.0, 1.0), between(-6.0, 6.0)], 200) > 0
            });
            assert!(some, "{number} {machine:?} {shown}");
        }
    }
    println!("{lower} have a band in which it depends\n{}", wrong.join("\n"));
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// README's machine: from rest it hits from a value in the band where it depends; what is proved stands there
/// with `prove = true` alone, and names a value at which there is a certificate of an orbit with an impact.
#[test]
fn a_band_says_from_where_on_rest_hits_and_what_is_proved() {
    let machine = Driven { c: 0.1, k: 0.3, restitution: 0.8 };
    for prove in [false, true] {
        let scene = machine.scene(0.5) + &format!("prove = {prove}\n");
        let (found, shown, code) = grazing_found(&scene);
        let [free, depends, hits] = &found.bands.unwrap()[..] else { panic!("{shown}") };
        let rest = found.seen.unwrap().into_iter().find(|row| row.place == "rest").unwrap();
        assert_eq!(
            (depends.from_rest, free.from_rest, hits.from_rest),
            (Some(rest.value), None, None),
            "{shown}"
        );
        assert_eq!(
            [&depends.least_by, &depends.most_by].map(|by| by.as_deref()),
            [Some("seen"), Some("enclosed")]
        );
        assert!(
            found.in_words.contains("begun: from rest, at q = 0, it is seen to hit for ever from F = 0.604"),
            "{shown}"
        );
        assert!(!found.in_words.contains("Begun at rest") && code == 0, "{shown}");
        let said = found.in_words.contains("on, and at F = 0.604476 a motion that does is proved; beyond");
        let proved = [free, depends, hits].map(|band| band.proved_at);
        if !prove {
            assert_eq!((proved, said), ([None; 3], false), "{shown}");
            continue;
        }
        assert_eq!((proved[0], proved[1], said), (None, Some(rest.value), true), "{shown}");
        let rows = found.proofs.unwrap().rows;
        for (at, place) in [(proved[1], "rest"), (proved[2], "beyond")] {
            let row = rows.iter().find(|row| row.seen == place).unwrap();
            assert_eq!((Some(row.value), row.proved.pattern.as_deref()), (at, Some("1")), "{shown}");
            assert!(row.proved.certificate.is_some(), "{shown}");
        }
    }
}

/// The force of README's machine as one formula: what is seen, the bands and the touch are those of its
/// coefficients.
#[test]
fn a_linear_force_is_linear_as_a_formula_too() {
    let machine = Driven { c: 0.1, k: 0.3, restitution: 0.8 };
    for engine in ["one", "many"] {
        let written =
            machine.scene(0.5).replace("[parameters]", &format!("engine = {engine:?}\n[parameters]"));
        let (head, tail) = written.split_once("damping").unwrap();
        let (_, tail) = tail.split_once("[[stops]]").unwrap();
        let formula = format!("{head}force = \"-u/10 - 3/10*q + F*cos(t)\"\n[[stops]]{tail}");
        let [own, expected] = [&formula, &written].map(|text| grazing_found(text).0);
        assert_eq!((own.seen_open, &own.touch), (None, &expected.touch), "{engine}");
        assert_eq!((&own.bands, &own.seen), (&expected.bands, &expected.seen), "{engine}");
        assert!(own.bands.is_some() && own.touch.is_some(), "{engine}");
    }
}

/// Overdamped, all that is born is beyond the touch, where the motion stays near: an orbit that attracts is
/// seen, and chaos is born.
#[test]
fn what_is_born_and_what_is_seen_are_told_apart() {
    let machine = Driven { c: 3.0, k: 1.0, restitution: 0.8 };
    let (found, shown, _) = grazing_found(&machine.scene(0.5));
    let beyond = found.seen.unwrap().into_iter().find(|row| row.place == "beyond").unwrap();
    assert_eq!(
        (beyond.what.as_str(), beyond.motion.as_deref()),
        ("stays", Some("period 2, 1 impact")),
        "{shown}"
    );
    let said = "Chaos is born for F > 3, of entropy 0.693147 per period. Born and seen are different sets: what is born \
                exists, most of it unstable; what is seen attracts.";
    assert!(found.in_words.contains(said), "{shown}");
    // Of γ > 0 it may be born on either side.
    let both = Driven { c: 0.03, k: 0.029_125, restitution: 0.8 };
    let (found, shown, _) = grazing_found(&both.scene(0.5));
    let of: Vec<&str> = found.chaos.iter().flatten().filter_map(|row| row.entropy.as_deref()).collect();
    assert_eq!(found.chaos.iter().flatten().filter(|row| row.chaos == Some(true)).count(), 2, "{shown}");
    let (_, said) = found.in_words.split_once("Chaos is born for F ").unwrap();
    let (said, _) = said.split_once(" per period").unwrap();
    assert!(said.contains("< ") && said.contains(", and for F > ") && of.len() == 2, "{said}");
    let (unseen, shown, _) = grazing_found(&(machine.scene(0.5) + "seen = false\n"));
    assert!(!unseen.in_words.contains("Born and seen"), "{shown}");
}

/// Asked from an orbit that is not there, a search says where orbits with impacts are: of an overdamped
/// machine on one side of the touch alone.
#[test]
fn where_no_orbit_is_to_begin_with_the_touch_is_told() {
    let of = |c: f64, kind: &str| {
        let text = Driven { c, k: 1.0, restitution: 0.8 }.scene(0.5);
        let text = text
            .replace("kind = \"grazing\"", kind)
            .replace("max_period = 1\nrange = false", "orbit = { pattern = [1] }");
        let scene = Scene::from_toml(&text, "t.toml").unwrap();
        run(&scene, Surroundings::default(), &mut ()).unwrap().remove(0).to_string()
    };
    for kind in ["kind = \"grazing\"", "kind = \"event\"\nevent = \"flip\""] {
        let shown = of(3.0, kind);
        let touch = "no admissible orbit to begin with at F = 0.5; the motion without impacts touches stop stop at F = 3, \
                     where orbits with impacts are born";
        let side = ": of this overdamped machine all of them for F > 3\n";
        assert!(shown.contains(&format!("{touch}{side}")), "{shown}");
        let shown = of(1.5, kind);
        assert!(shown.contains("F = 1.5, where orbits with impacts are born\n"), "{shown}");
    }
}

/// With a spring that hardens a second motion may be clear of the stop beyond the touch of the first: nothing
/// is said of all motions there.
#[test]
fn of_forces_that_are_not_linear_no_bands_are_told() {
    let machine = Driven { c: 0.1, k: 0.3, restitution: 0.8 };
    let linear = machine.scene(0.5).replace("max_period = 1\n", "max_period = 1\nseen = true\n");
    let cubic = linear.replace("forcing =", "cubic = 0.01\nforcing =");
    for (scene, expected) in [(linear, true), (cubic, false)] {
        let (found, shown, _) = grazing_found(&scene);
        assert!(found.seen.is_some(), "{shown}");
        assert_eq!(
            (found.bands.is_some(), found.in_words.contains("it always hits")),
            (expected, expected),
            "{shown}"
        );
    }
}
