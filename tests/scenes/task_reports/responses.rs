//! Frequency responses: against closed forms of one and two coordinates, Den Hartog's absorber and friction
//! oscillator, a saddle-node found otherwise, and the balance of impulses.

use std::{
    f64::consts::{PI, TAU},
    path::Path,
};

use grazing_scenes::{
    Result,
    run::{Findings, ResponseFindings, ResponseRow, Surroundings, TaskReport, run},
    scene::Scene,
};
use nalgebra::{Complex, Matrix2, Vector2};
use serde_json::Value;

use crate::tasks::{near, number};

type C = Complex<f64>;

pub(super) fn reports(text: &str) -> Result<Vec<TaskReport>> {
    let text = format!("format = \"grazing-scene 3\"\ntitle = \"t\"\n{text}");
    run(&Scene::from_toml(&text, "scene.toml")?, Surroundings::default(), &mut ())
}

/// What the first task of a scene found.
pub(super) fn found(text: &str) -> ResponseFindings {
    let report = reports(text).unwrap().remove(0);
    match report.findings {
        Some(Findings::Response(found)) => *found,
        _ => panic!("{report}"),
    }
}

pub(super) fn task(parameter: &str, [from, to]: [f64; 2], count: u32, more: &str) -> String {
    format!(
        "[[tasks]]\nname = \"it\"\nkind = \"response\"\nparameter = \"{parameter}\"\nrange = [{from:?}, {to:?}]\n\
         count = {count}\n{more}\n"
    )
}

/// The rows of one way and one coordinate.
fn rows<'f>(found: &'f ResponseFindings, way: &str, of: &str) -> Vec<&'f ResponseRow> {
    found.rows.iter().filter(|row| row.way == way && row.coordinate == of).collect()
}

/// Whether two lags are the same but for whole turns.
fn same_lag(one: Option<f64>, other: f64, tolerance: f64) {
    let off = one.unwrap() - other;
    assert!((off - off.round()).abs() < tolerance, "{one:?} and {other}");
}

/// z = a − ib, the harmonic being the real part of z e^{ikt}.
fn z(row: &ResponseRow) -> C {
    Complex::from_polar(row.amplitude, -TAU * row.lag.unwrap_or(0.0))
}

/// A mass of 2 kg on a spring of 400 N/m, in hertz, by either engine; and the same in radians of the drive:
/// with radians in the unit of its frequency.
fn one_mass(damping: f64, more: &str) -> [(String, f64); 3] {
    let seconds = format!(
        "[parameters]\nf = 1\n[system]\nfrequency = \"f\"\nmass = 2\ndamping = {damping}\nstiffness = 400\n\
         forcing = [{{ cos = 5 }}]\n{more}"
    );
    let radians = format!(
        "[parameters]\nf = 1\n[system]\ndamping = \"{damping}/(2*f)\"\nstiffness = \"200/f^2\"\n\
         forcing = [{{ cos = \"5/(2*f^2)\" }}]\n{more}"
    );
    [(format!("engine = \"many\"\n{seconds}"), TAU), (seconds, TAU), (radians, 1.0)]
}

#[test]
fn one_mass_has_its_closed_response_its_peak_and_its_half_power_points() {
    let own = 200f64.sqrt();
    for damping in [0.4, 3.0, 11.0] {
        let ratio = damping / (2.0 * 2.0 * own);
        // Peak, half-power points and height over the natural frequency and F/k.
        let peak = (1.0 - 2.0 * ratio * ratio).sqrt();
        let high = 1.0 / (2.0 * ratio * (1.0 - ratio * ratio).sqrt());
        let around = 2.0 * ratio * (1.0 - ratio * ratio).sqrt();
        for (scene, unit) in one_mass(damping, "") {
            let range = [0.3 * own / unit, 2.5 * own / unit];
            let found = found(&format!("{scene}{}", task("f", range, 41, "")));
            assert!(found.is_frequency && found.sweep.is_none() && found.resonant.is_empty());
            let all = rows(&found, "linear", "q");
            assert_eq!(all.len(), 41);
            for row in all {
                let r = row.value * unit / own;
                let exact = Complex::new(5.0 / 400.0, 0.0) / Complex::new(1.0 - r * r, 2.0 * ratio * r);
                assert!((z(row) - exact).norm() < 1e-13 * exact.norm(), "{row:?} {exact}");
                near(row.swing, row.amplitude, 1e-15);
            }
            let [row] = &found.peaks[..] else { panic!("{:?}", found.peaks) };
            near(row.value * unit / own, peak, 1e-12);
            near(row.amplitude.unwrap(), 5.0 / 400.0 * high, 1e-14 * high);
            same_lag(row.lag, (2.0 * ratio * peak).atan2(1.0 - peak * peak) / TAU, 1e-10);
            let middle = 1.0 - 2.0 * ratio * ratio;
            near(row.lower.unwrap() * unit / own, (middle - around).sqrt(), 1e-12);
            near(row.upper.unwrap() * unit / own, (middle + around).sqrt(), 1e-12);
            near(row.half_power_ratio.unwrap(), around / (2.0 * middle), 1e-12);
            near(row.damping_ratio.unwrap(), ratio, 1e-13);
            assert_eq!(row.open, None);
        }
    }
}

/// A motion is told to tend to an orbit long before it comes there: its swings are those of the orbit,
/// however short the transient is.
#[test]
fn swings_are_those_of_the_orbit_and_not_of_a_motion_on_its_way() {
    for (scene, unit) in one_mass(0.4, "") {
        let task = task("f", [5.0 / unit, 45.0 / unit], 5, "seen = true\ntransient = 5");
        let found = found(&format!("{scene}{task}"));
        assert_eq!(found.not_settled, [0.0; 0]);
        let linear = rows(&found, "linear", "q");
        for way in ["up", "down"] {
            let seen = rows(&found, way, "q");
            assert_eq!(seen.len(), 5);
            for row in seen {
                let exact = linear.iter().find(|known| known.value == row.value).unwrap();
                assert!((z(row) - z(exact)).norm() < 1e-10 * exact.amplitude, "{row:?} {exact:?}");
                near(row.swing, exact.swing, 1e-8);
            }
        }
    }
}

/// Without damping friction bounds a resonance if 4F of it is more than πP of the drive; else the motion
/// grows for ever, and has no swing.
#[test]
fn what_grows_at_a_resonance_is_not_settled() {
    let scene = |most: f64| {
        let friction = format!("[[friction]]\nnormal = {most}\ncoefficient = 1\n");
        let text = "[parameters]\nf = 1\n[system]\nfrequency = \"f\"\nmass = 1\nstiffness = \"(2*pi*10)^2\"\n\
                    forcing = [{ cos = 1 }]\n";
        found(&format!("{text}{friction}{}", task("f", [9.0, 11.0], 5, "sweep = \"up\"")))
    };
    let grows = scene(0.5);
    assert_eq!((&grows.resonant[..], &grows.not_settled[..]), (&[10.0][..], &[10.0][..]));
    let swings: Vec<f64> = rows(&grows, "up", "q").iter().map(|row| row.value).collect();
    assert_eq!(swings, [9.0, 9.5, 10.5, 11.0]);
    let bounded = scene(0.9);
    assert_eq!((rows(&bounded, "up", "q").len(), &bounded.not_settled[..]), (5, &[][..]));
}

/// Without damping there is no height; where half of the power is beyond the range, no width; and a parameter
/// that is not the drive's frequency gives no damping.
#[test]
fn what_has_no_half_power_points_is_told_so() {
    let own = 200f64.sqrt();
    for (scene, unit) in one_mass(0.0, "") {
        let found = found(&format!("{scene}{}", task("f", [0.5 * own / unit, 1.7 * own / unit], 8, "")));
        let [row] = &found.peaks[..] else { panic!("{:?}", found.peaks) };
        near(row.value * unit / own, 1.0, 1e-9);
        assert_eq!((row.amplitude, row.lower, row.open), (None, None, Some("undamped")));
    }
    let [(scene, _), ..] = one_mass(3.0, "");
    let found = found(&format!("{scene}{}", task("f", [2.1, 2.3], 9, "")));
    assert_eq!((found.peaks.len(), found.peaks[0].open), (1, Some("beyond the range")), "{found:?}");
    let other = format!(
        "[parameters]\nk = 4\n[system]\ndamping = 0.1\nstiffness = \"k\"\nforcing = [{{ cos = 1 }}]\n{}",
        task("k", [0.5, 2.0], 21, "")
    );
    let found = self::found(&other);
    let [row] = &found.peaks[..] else { panic!("{:?}", found.peaks) };
    assert!(!found.is_frequency && row.half_power_ratio.is_none());
    // 1/√((k − 1)² + c²): at k = 1, half of its square at 1 ± c.
    near(row.value, 1.0, 1e-14);
    near(row.lower.unwrap(), 0.9, 1e-14);
    near(row.upper.unwrap(), 1.1, 1e-14);
}

/// At a value at which an undamped mode resonates there is no response, nor a row.
#[test]
fn a_value_at_resonance_without_damping_has_no_row() {
    let scene = format!(
        "[parameters]\nk = 4\n[system]\nstiffness = \"k\"\nforcing = [{{ cos = 1 }}]\n{}",
        task("k", [0.5, 1.5], 5, "seen = false")
    );
    let found = found(&scene);
    assert_eq!(found.resonant, [1.0]);
    assert_eq!(rows(&found, "linear", "q").len(), 4);
}

/// Two masses of which the damping mixes the modes, two harmonics, a gap: against the linear system, solved
/// here, and against many looks at its sum.
#[test]
fn two_masses_answer_as_the_complex_system_does() {
    let scene = format!(
        "[parameters]\nf = 8\n[system]\nfrequency = \"f\"\nmass = [[2, 0], [0, 0.5]]\ndamping = [[12, -2], [-2, 2]]\n\
         stiffness = [[3200, -200], [-200, 200]]\nforce = [1, 0]\n\
         forcing = [{{ cos = [12, 1], sin = [0, 3] }}, {{ k = 3, sin = [5, 0] }}]\n\
         [[stops]]\nname = \"between\"\nrow = [-1, 1]\noffset = -1\nharmonics = [{{ sin = 0.001 }}]\nrestitution = 0.8\n{}",
        task("f", [1.0, 9.0], 33, "")
    );
    let found = found(&scene);
    let i = Complex::new(0.0, 1.0);
    let solved = |f: f64, k: f64, force: [C; 2]| -> Vector2<C> {
        let w = TAU * f * k;
        let of = |m: f64, c: f64, s: f64| Complex::new(s - w * w * m, w * c);
        let [own, across, other] = [of(2.0, 12.0, 3200.0), of(0.0, -2.0, -200.0), of(0.5, 2.0, 200.0)];
        Matrix2::new(own, across, across, other).lu().solve(&Vector2::new(force[0], force[1])).unwrap()
    };
    for (row, (other, gap)) in rows(&found, "linear", "q1")
        .iter()
        .zip(rows(&found, "linear", "q2").iter().zip(&rows(&found, "linear", "gap between")))
    {
        let first = solved(row.value, 1.0, [Complex::new(12.0, 0.0), Complex::new(1.0, -3.0)]);
        let third = solved(row.value, 3.0, [-5.0 * i, Complex::new(0.0, 0.0)]);
        for (row, exact) in [
            (*row, [first[0], third[0]]),
            (*other, [first[1], third[1]]),
            (*gap, [first[1] - first[0] + 0.001 * i, third[1] - third[0]]),
        ] {
            assert!((z(row) - exact[0]).norm() < 1e-13 * exact[0].norm(), "{row:?} {exact:?}");
            let at = |t: f64| (exact[0] * (i * t).exp()).re + (exact[1] * (3.0 * i * t).exp()).re;
            let all = (0..20_000).map(|j| at(f64::from(j) * TAU / 20_000.0));
            let (low, high) = all.fold((0.0f64, 0.0f64), |(low, high), q| (low.min(q), high.max(q)));
            near(row.swing, (high - low) / 2.0, 1e-6 * high);
        }
    }
    assert!(found.contact.is_empty() && found.sweep.is_none());
}

/// The primary mass of an absorber without damping of its own has two frequencies at which it answers alike
/// whatever the absorber's damping is (Den Hartog).
#[test]
fn den_hartogs_fixed_points_are_fixed() {
    let (mass, tuning): (f64, f64) = (0.05, 0.93);
    let square = tuning * tuning;
    let middle = (1.0 + square * (1.0 + mass)) / (2.0 + mass);
    let root = (middle * middle - 2.0 * square / (2.0 + mass)).sqrt();
    let points = [(middle - root).sqrt(), (middle + root).sqrt()];
    for damping in [0.0, 0.01, 0.03, 0.1, 2.0] {
        let scene = format!(
            "[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\nmass = {{ diagonal = [1, {mass:?}] }}\n\
             damping = [[{damping:?}, -{damping:?}], [-{damping:?}, {damping:?}]]\n\
             stiffness = [[{:?}, -{:?}], [-{:?}, {:?}]]\nforcing = [{{ cos = [1, 0] }}]\n{}",
            1.0 + mass * square,
            mass * square,
            mass * square,
            mass * square,
            task("w", points, 3, "")
        );
        let found = found(&scene);
        let all = rows(&found, "linear", "q1");
        for (row, point) in [(all[0], points[0]), (all[2], points[1])] {
            near(row.amplitude, 1.0 / (1.0 - point * point * (1.0 + mass)).abs(), 1e-12);
        }
    }
}

/// A mode so weakly damped that no value is near it is found by its resonance; two modes close to each other
/// overlap.
#[test]
fn narrow_peaks_are_found_and_peaks_that_overlap_have_no_width() {
    let scene = |detuned: f64, damping: f64| {
        let apart = 1.0 + detuned;
        format!(
            "[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\nmass = {{ diagonal = [1, 1] }}\n\
             damping = {{ diagonal = [{damping:?}, {damping:?}] }}\nstiffness = [[1, 0], [0, {apart:?}]]\n\
             forcing = [{{ cos = [1, 1] }}]\n[[stops]]\nname = \"sum\"\nrow = [1, -1]\noffset = -1e9\nrestitution = 1\n{}",
            task("w", [0.5, 1.5], 4, "")
        )
    };
    let narrow = found(&scene(0.3, 1e-6));
    for (name, at) in [("q1", 1.0), ("q2", 1.3f64.sqrt())] {
        let own: Vec<_> = narrow.peaks.iter().filter(|row| row.coordinate == name).collect();
        assert_eq!(own.len(), 1, "{:?}", narrow.peaks);
        near(own[0].value, at, 1e-11);
        near(own[0].half_power_ratio.unwrap(), own[0].damping_ratio.unwrap(), 1e-11);
    }
    assert_eq!(narrow.peaks.iter().filter(|row| row.coordinate == "gap sum").count(), 2);
    let close = found(&scene(0.1, 0.045));
    let sum: Vec<_> = close.peaks.iter().filter(|row| row.coordinate == "gap sum").collect();
    assert!(!sum.is_empty() && sum.iter().all(|row| row.damping_ratio.is_some()), "{:?}", close.peaks);
    let two = found(&scene(0.1, 0.03));
    let overlaps = two.peaks.iter().filter(|row| row.open == Some("overlaps with another"));
    assert_eq!(overlaps.count(), 2, "{:?}", two.peaks);
}

/// A chain of four masses, drawn: masses, dampers to the ground, springs (the first to the ground) and drive.
struct Chain {
    mass: [f64; 4],
    damping: [f64; 4],
    springs: [f64; 4],
    drive: [C; 4],
}

impl Chain {
    fn drawn(seed: u32) -> Chain {
        let mut state = seed;
        let mut draw = |from: f64, to: f64| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let part = f64::from(state >> 8) / f64::from(1 << 24);
            ((from + (to - from) * part) * 1e4).round() / 1e4
        };
        Chain {
            mass: [(); 4].map(|()| draw(1.0, 3.0)),
            damping: [(); 4].map(|()| draw(0.05, 0.15)),
            springs: [(); 4].map(|()| draw(1.0, 4.0)),
            drive: [(); 4].map(|()| Complex::new(draw(-1.5, 1.5), -draw(-1.5, 1.5))),
        }
    }

    fn stiffness(&self, i: usize) -> f64 {
        self.springs[i] + self.springs.get(i + 1).unwrap_or(&0.0)
    }

    fn scene(&self) -> String {
        let part = |of: fn(&C) -> f64| self.drive.each_ref().map(of);
        let row = |i: usize| {
            [0, 1, 2, 3].map(|j: usize| match i.abs_diff(j) {
                0 => self.stiffness(i),
                1 => -self.springs[i.max(j)],
                _ => 0.0,
            })
        };
        format!(
            "[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\nmass = {{ diagonal = {:?} }}\ndamping = {{ diagonal = {:?} }}\n\
             stiffness = {:?}\nforcing = [{{ cos = {:?}, sin = {:?} }}]\n",
            self.mass,
            self.damping,
            [0, 1, 2, 3].map(row),
            part(|z| z.re),
            part(|z| -z.im)
        )
    }

    /// The squares of the amplitudes, by elimination from the last mass on.
    fn squares(&self, w: f64) -> [f64; 4] {
        let own = |i: usize| Complex::new(self.stiffness(i) - w * w * self.mass[i], w * self.damping[i]);
        let (mut left, mut right) = ([0, 1, 2, 3].map(own), self.drive);
        for i in (0..3).rev() {
            let factor = self.springs[i + 1] / left[i + 1];
            left[i] -= factor * self.springs[i + 1];
            let more = factor * right[i + 1];
            right[i] += more;
        }
        let mut z = [Complex::new(0.0, 0.0); 4];
        for i in 0..4 {
            let before = if i == 0 { Complex::new(0.0, 0.0) } else { z[i - 1] * self.springs[i] };
            z[i] = (right[i] + before) / left[i];
        }
        z.map(|z| z.norm_sqr())
    }
}

/// Peaks that are no mode's are found however few values are looked at: those that many looks at the closed
/// form see, and no others.
#[test]
fn all_peaks_are_found_whatever_the_count() {
    let looks: Vec<f64> = (0..=4000).map(|i| 0.1 + f64::from(i) * 3.9 / 4000.0).collect();
    let mut all = 0;
    for seed in 0..10 {
        let chain = Chain::drawn(seed);
        let squares: Vec<[f64; 4]> = looks.iter().map(|w| chain.squares(*w)).collect();
        for count in [3, 12, 60] {
            let found = found(&format!("{}{}", chain.scene(), task("w", [0.1, 4.0], count, "")));
            for i in 0..4 {
                let own: Vec<f64> = found
                    .peaks
                    .iter()
                    .filter(|row| row.coordinate == format!("q{}", i + 1))
                    .map(|row| row.value)
                    .collect();
                for &at in &own {
                    let here = chain.squares(at)[i];
                    assert!(
                        [1.0 - 1e-6, 1.0 + 1e-6].iter().all(|x| chain.squares(at * x)[i] < here),
                        "{seed} {at}"
                    );
                }
                for (x, three) in looks.windows(3).zip(squares.windows(3)) {
                    if three[1][i] > three[0][i] && three[1][i] >= three[2][i] {
                        let near = own.iter().filter(|at| (x[0]..=x[2]).contains(at)).count();
                        assert_eq!(near, 1, "{seed}, {count} values: q{} near {}, of {own:?}", i + 1, x[1]);
                        all += 1;
                    }
                }
            }
        }
    }
    assert!(all > 250, "{all}");
}

/// Where a hardening spring jumps: at the saddle-nodes of its branch.
#[test]
fn a_duffing_oscillator_jumps_at_its_saddle_nodes() {
    let system = "[parameters]\nw = 1\n[system]\ndamping = \"0.1/w\"\nstiffness = \"1/w^2\"\ncubic = \"0.2/w^2\"\n\
                  forcing = [{ cos = \"0.3/w^2\" }]\n\
                  [[stops]]\nside = \"lower\"\noffset = -100\nrestitution = 1\n";
    let branch = "[[tasks]]\nname = \"branch\"\nkind = \"branch\"\nparameter = \"w\"\nrange = [0.8, 2]\n\
                  starts = [{ at = 0.9, attractor = { q = 0 } }]\n";
    let text = format!("{system}{}{branch}", task("w", [0.9, 1.9], 51, ""));
    let all = reports(&text).unwrap();
    let Some(Findings::Response(found)) = &all[0].findings else { panic!("{}", all[0]) };
    // The linear response is that without the cube, and the parameter the drive's frequency.
    let peak = found.peaks.first().unwrap();
    near(peak.value, (1.0 - 0.005f64).sqrt(), 1e-12);
    near(peak.half_power_ratio.unwrap(), 0.05 * (1.0 - 0.0025f64).sqrt() / (1.0 - 0.005), 1e-12);
    assert!(found.is_frequency);
    let branch = serde_json::to_value(&all[1]).unwrap();
    let labels = branch["labels"].as_array().unwrap();
    let folds = labels.iter().filter(|row| row["label"].as_str().unwrap_or("").starts_with("saddle-node"));
    let mut folds: Vec<f64> = folds.map(|row| number(&row["parameters"][0])).collect();
    folds.sort_by(f64::total_cmp);
    assert_eq!(folds.len(), 2, "{branch}");
    let sweep = found.sweep.as_ref().unwrap();
    assert_eq!(sweep.jumps.len(), 2, "{:?}", sweep.jumps);
    for (jump, fold) in sweep.jumps.iter().zip([folds[1], folds[0]]) {
        assert!((jump.left - fold).abs() < 1e-9 && jump.ends == "saddle-node", "{jump:?} {folds:?}");
    }
    assert!(sweep.hysteresis.as_ref().is_some_and(|rows| rows.len() == 1));
    // Between them the two ways differ, outside they do not.
    for (up, down) in rows(found, "up", "q").iter().zip(rows(found, "down", "q").iter().rev()) {
        let inside = folds[0] + 0.01 < up.value && up.value < folds[1] - 0.01;
        let outside = up.value < folds[0] - 0.01 || up.value > folds[1] + 0.01;
        assert!(
            (!inside || up.swing > 1.2 * down.swing) && (!outside || (up.swing - down.swing).abs() < 1e-6)
        );
    }
    // The largest swing is seen on the way up, just before it jumps.
    let highest = &found.highest.as_ref().unwrap()[0];
    assert!(highest.way == "up" && (0.0..0.0201).contains(&(folds[1] - highest.value)), "{highest:?}");
    assert!(rows(found, "up", "q").iter().all(|row| row.swing <= highest.swing), "{highest:?}");
    // Both jumps are of one branch, whose unstable orbits lie between the others.
    let [stretch] = &found.unstable.as_ref().unwrap()[..] else { panic!("{:?}", found.unstable) };
    assert!((stretch.from - folds[1]).abs() < 1e-9 && (stretch.to - folds[0]).abs() < 1e-9, "{stretch:?}");
    for row in rows(found, "unstable", "q") {
        let seen = |way| {
            let near = |a: &&&ResponseRow, b: &&&ResponseRow| {
                (a.value - row.value).abs().total_cmp(&(b.value - row.value).abs())
            };
            rows(found, way, "q").iter().min_by(near).unwrap().swing
        };
        let inside = folds[0] + 0.02 < row.value && row.value < folds[1] - 0.02;
        assert!(!inside || seen("down") < row.swing && row.swing < seen("up"), "{row:?}");
    }
}

/// A mass that hits a stop once a period: (s − k² + ikc) z = f + (1/π) Σ Δu e^{−ikt}, with impacts of the
/// orbit that Newton's method finds. By both engines; the linear response is in contact there.
#[test]
fn an_impacting_motion_has_the_harmonics_that_its_impulses_give_it() {
    for engine in ["one", "many"] {
        for k in [1, 2, 3] {
            let system = format!(
                "engine = \"{engine}\"\n[parameters]\nF = 0.8\n[system]\ndamping = \"1/10\"\nstiffness = \"3/10\"\n\
                 forcing = [{{ cos = \"F\" }}, {{ k = 2, sin = 0.01 }}, {{ k = 3, sin = 0.01 }}]\n\
                 [[stops]]\nside = \"upper\"\noffset = 1\nrestitution = 0.8\n"
            );
            let orbit = "[[tasks]]\nname = \"orbit\"\nkind = \"orbit\"\nparameter = \"F\"\nvalues = [0.8, 0.9, 1]\n\
                         orbit = { pattern = [1] }\n";
            let more = format!("harmonic = {k}\ntransient = 400\nsweep = \"down\"");
            let all = reports(&format!("{system}{}{orbit}", task("F", [0.8, 1.0], 3, &more))).unwrap();
            let Some(Findings::Response(found)) = &all[0].findings else { panic!("{}", all[0]) };
            assert_eq!((found.contact.len(), found.contact[0].values), (1, 3));
            let orbits = serde_json::to_value(&all[1]).unwrap();
            let seen = rows(found, "down", "q");
            assert_eq!(seen.len(), 3);
            for row in seen {
                assert_eq!((row.period, row.impacts), (Some(1), Some(1)));
                let stable = |orbit: &&Value| {
                    (number(&orbit["value"]) - row.value).abs() < 1e-9 && orbit["stable"] == Value::Bool(true)
                };
                let orbit = orbits["orbits"].as_array().unwrap().iter().find(stable).unwrap();
                let (phase, speed) = (number(&orbit["phases"][0]), number(&orbit["speeds"][0]));
                let k = f64::from(k);
                let jump = -1.8 * speed / PI * Complex::from_polar(1.0, -k * TAU * phase);
                let force = match k {
                    1.0 => Complex::new(row.value, 0.0),
                    _ => Complex::new(0.0, -0.01),
                };
                let exact = (force + jump) / Complex::new(0.3 - k * k, 0.1 * k);
                assert!((z(row) - exact).norm() < 1e-9, "{engine} {k}: {row:?} {exact}");
                // Its greatest displacement is the stop's, its gap turns it over.
                let gap =
                    rows(found, "down", "gap upper").into_iter().find(|gap| gap.value == row.value).unwrap();
                near(gap.swing, row.swing, 1e-12);
                same_lag(gap.lag, row.lag.unwrap() + 0.5, 1e-9);
            }
        }
    }
}

/// Den Hartog's amplitude of a mass on a spring with Coulomb friction that does not stick.
#[test]
fn a_mass_that_rubs_swings_as_far_as_den_hartog_says() {
    let scene = format!(
        "[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\nmass = 1\nstiffness = 1\nforcing = [{{ cos = 1 }}]\n\
         [[friction]]\nnormal = 1\ncoefficient = 0.2\n{}",
        task("w", [1.2, 1.6], 3, "transient = 1000\nseen = true")
    );
    let found = found(&scene);
    for way in ["up", "down"] {
        let all = rows(&found, way, "q");
        assert_eq!(all.len(), 3);
        for row in all {
            let ratio = row.value;
            let free = 1.0 / (1.0 - ratio * ratio);
            let turned = (PI / ratio).sin() / (ratio * (1.0 + (PI / ratio).cos()));
            near(row.swing, (free * free - 0.04 * turned * turned).sqrt(), 1e-6);
        }
    }
}

/// The same question in other units, with its signs turned, its stops exchanged, its drive a quarter of a
/// period later; asked of either engine.
#[test]
fn forms_of_a_response_agree() {
    ["one", "many"].into_iter().for_each(forms_agree);
}

fn forms_agree(engine: &str) {
    let scene = |[mass, length]: [f64; 2], sign: f64, drive: &str, swapped: bool| {
        let force = mass * length;
        let stop = |name: &str, side: f64| {
            format!(
                "[[stops]]\nname = \"{name}\"\nrow = [{:?}]\noffset = {:?}\nrestitution = 0.7\n",
                sign * side,
                -1.2 * length
            )
        };
        let stops = [stop("right", -1.0), stop("left", 1.0)];
        let stops = if swapped { [&stops[1], &stops[0]] } else { [&stops[0], &stops[1]] };
        format!(
            "engine = {engine:?}\n[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\nmass = {mass:?}\ndamping = {:?}\n\
             stiffness = {mass:?}\n\
             force = {:?}\nforcing = [{{ {drive} = {:?} }}]\n{}{}{}",
            0.1 * mass,
            0.1 * force * sign,
            force * sign,
            stops[0],
            stops[1],
            task("w", [0.5, 1.5], 6, "sweep = \"up\"")
        )
    };
    let base = found(&scene([1.0, 1.0], 1.0, "cos", false));
    assert!(!base.contact.is_empty() && base.sweep.is_some());
    let forms = [
        ("units", [4.0, 0.25], 1.0, "cos", false, 0.0),
        ("mirrored", [1.0, 1.0], -1.0, "cos", false, 0.5),
        ("order", [1.0, 1.0], 1.0, "cos", true, 0.0),
        ("later", [1.0, 1.0], 1.0, "sin", false, 0.25),
    ];
    for (name, units, sign, drive, swapped, later) in forms {
        let form = found(&scene(units, sign, drive, swapped));
        // Where along a branch its orbits are depends on what a length is measured by; its ends do not.
        let stretches = form.unstable.iter().flatten().zip(base.unstable.iter().flatten());
        for (other, row) in stretches {
            assert_eq!((&other.begins, &other.ends, other.period), (&row.begins, &row.ends, row.period));
            near(other.from, row.from, 1e-7);
            near(other.to, row.to, 1e-7);
        }
        let count = |found: &ResponseFindings| found.unstable.as_ref().map(Vec::len);
        assert_eq!(count(&form), count(&base));
        let looked_at =
            |found: &ResponseFindings| found.rows.iter().filter(|row| row.stretch.is_none()).count();
        assert_eq!(looked_at(&form), looked_at(&base));
        for row in base.rows.iter().filter(|row| row.stretch.is_none()) {
            let same = |other: &&ResponseRow| {
                (other.way, other.value, &other.coordinate) == (row.way, row.value, &row.coordinate)
            };
            let other = form.rows.iter().find(same).unwrap();
            assert_eq!(other.period, row.period, "{name}: {row:?} {other:?}");
            if row.period.is_none() || drive == "sin" && row.way == "up" && row.period != Some(1) {
                continue;
            }
            near(other.swing / units[1], row.swing, 1e-7);
            near(other.amplitude / units[1], row.amplitude, 1e-7);
            let turned = if row.coordinate == "q" { later } else { later % 0.5 };
            same_lag(other.lag, row.lag.unwrap() + turned, 1e-7);
            assert_eq!(other.stop, row.stop);
        }
    }
}

#[test]
fn what_a_response_does_not_take_is_refused() {
    let still = "[parameters]\nk = 1\n[system]\nstiffness = \"k\"\ndamping = 1\n";
    let driven =
        "[parameters]\nk = 1\n[system]\nstiffness = \"k\"\ndamping = 1\nforcing = [{ k = 2, cos = 1 }]\n";
    for (text, part) in [
        (format!("{still}{}", task("k", [1.0, 2.0], 5, "")), "no drive"),
        (format!("{driven}{}", task("k", [1.0, 2.0], 5, "")), "is not in the drive, which has 2"),
        (format!("{driven}{}", task("k", [2.0, 1.0], 5, "harmonic = 2")), "the smaller first"),
        (format!("{driven}{}", task("k", [1.0, 2.0], 2, "harmonic = 2")), "outside 3 to"),
        (format!("{driven}{}", task("p", [1.0, 2.0], 5, "harmonic = 2")), "\"p\""),
    ] {
        let error = reports(&text).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("scene.toml:"), "{error}");
    }
    assert_eq!(found(&format!("{driven}{}", task("k", [1.0, 5.0], 5, "harmonic = 2"))).harmonic, 2);
    let moved = "[parameters]\nk = 1\n[system]\nstiffness = \"k\"\ndamping = 1\n[[stops]]\nside = \"lower\"\noffset = -3\n\
                 harmonics = [{ cos = 1 }]\nrestitution = 0.5\n";
    let found = found(&format!("{moved}{}", task("k", [1.0, 2.0], 5, "")));
    let gap = rows(&found, "linear", "gap lower")[0];
    near(gap.amplitude, 1.0, 1e-15);
    same_lag(gap.lag, 0.5, 1e-12);
    assert_eq!(rows(&found, "linear", "q")[0].lag, None);
}

/// A formula is linearised at rest: a pendulum as a spring of its own weight.
#[test]
fn a_formula_is_linearised_at_rest() {
    for engine in ["one", "many"] {
        let scene = format!(
            "engine = \"{engine}\"\n[parameters]\nw = 1\n[system]\nforce = \"-0.05/w*u - sin(q)/w^2 + 0.01*cos(t)/w^2\"\n{}",
            task("w", [0.5, 1.5], 21, "seen = false")
        );
        let found = found(&scene);
        let [row] = &found.peaks[..] else { panic!("{:?}", found.peaks) };
        near(row.value, (1.0 - 0.05 * 0.05 / 2.0f64).sqrt(), 1e-9);
        near(row.lower.unwrap(), (1.0 - 0.00125 - 0.05 * (1.0 - 0.000625f64).sqrt()).sqrt(), 1e-9);
        assert!(found.is_frequency);
        for row in rows(&found, "linear", "q") {
            let exact = 0.01 / Complex::new(1.0 - row.value * row.value, 0.05 * row.value);
            assert!((z(row) - exact).norm() < 1e-13, "{row:?} {exact}");
        }
    }
}

/// Two masses on a spring, free in space: the force moves their relative coordinate as one mass, wherever
/// they are. Pushed by a constant force they stay nowhere.
#[test]
fn a_machine_that_floats_has_its_harmonics() {
    let scene = |force: &str| {
        format!(
            "[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\nmass = {{ diagonal = [1, 3] }}\n\
             damping = [[0.2, -0.2], [-0.2, 0.2]]\nstiffness = [[2, -2], [-2, 2]]\nforce = {force}\n\
             forcing = [{{ cos = [1, 0] }}]\n[[stops]]\nname = \"near\"\nrow = [-1, 1]\noffset = -50\nrestitution = 1\n{}",
            task("w", [0.5, 3.0], 11, "seen = false")
        )
    };
    for force in ["[0, 0]", "[0.3, -0.3]"] {
        let found = found(&scene(force));
        assert_eq!((found.floating.len(), found.resonant.len(), found.contact.len()), (11, 0, 0));
        for row in rows(&found, "linear", "gap near") {
            // The reduced mass is 3/4, and three quarters of the force are felt.
            let w = row.value;
            let exact = -0.75 / Complex::new(2.0 - 0.75 * w * w, 0.2 * w);
            assert!((z(row) - exact).norm() < 1e-12 * exact.norm(), "{row:?} {exact}");
        }
        assert_eq!(found.peaks.iter().filter(|row| row.coordinate == "gap near").count(), 1);
    }
    let pushed = found(&scene("[0.3, 0]"));
    assert_eq!((pushed.resonant.len(), pushed.rows.len()), (11, 0));
}

/// What a formula does not say of the drive is not looked for at a few phases: harmonic 50, too.
#[test]
fn forcing_beside_a_formula_keeps_its_harmonics() {
    let scene = format!(
        "engine = \"many\"\n[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\nmass = 1\nforce = \"-sin(q) + 0.2*sin(t)\"\n\
         damping = 0.1\nforcing = [{{ cos = 0.3 }}, {{ k = 50, sin = 2 }}]\n{}",
        task("w", [0.01, 0.05], 5, "harmonic = 50\nseen = false")
    );
    let fast = found(&scene);
    let slow = found(&scene.replace("harmonic = 50", "harmonic = 1"));
    for (fast, slow) in rows(&fast, "linear", "q").iter().zip(rows(&slow, "linear", "q")) {
        for (row, k, force) in [(*fast, 50.0, Complex::new(0.0, -2.0)), (slow, 1.0, Complex::new(0.3, -0.2))]
        {
            let w = row.value * k;
            let exact = force / Complex::new(1.0 - w * w, 0.1 * w);
            assert!((z(row) - exact).norm() < 1e-13 * exact.norm(), "{row:?} {exact}");
        }
    }
}

/// The example's rotor: its whirls by the quadratic of the closed form, ω² ∓ γΩω = k/Id, its motion from a
/// tilt as their sum, its answer to its own drive, and its only critical speed.
#[test]
fn a_gyroscopic_rotor_whirls_as_its_quadratic_says() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let text = std::fs::read_to_string(root.join("examples/machines/overhung-rotor.toml")).unwrap();
    let (across, along, stiffness, damping, askew): (f64, f64, f64, f64, f64) =
        (0.02, 0.012, 800.0, 0.4, 0.0005);
    let whirls = |speed: f64| {
        let half = along / across * speed / 2.0;
        let root = half.hypot((stiffness / across).sqrt());
        [root - half, root + half]
    };
    let scene = Scene::from_toml(&text, "scene.toml").unwrap();
    let all = run(&scene, Surroundings::default(), &mut ()).unwrap();
    let Some(Findings::Response(found)) = &all[1].findings else { panic!("{}", all[1]) };
    assert!(found.is_frequency);
    for (name, later) in [("q1", 0.0), ("q2", 0.25)] {
        let all = rows(found, "linear", name);
        assert_eq!(all.len(), 121);
        for row in all {
            let speed = TAU * row.value;
            let apart = (across - along) * speed * speed;
            let exact = askew * apart / Complex::new(stiffness - apart, damping * speed);
            assert!((z(row) * Complex::from_polar(1.0, TAU * later) - exact).norm() < 1e-13 * exact.norm());
        }
        // d/dx of x²/((k − ax)² + c²x), x = Ω².
        let apart = across - along;
        let peak = 2.0 * stiffness * stiffness / (2.0 * stiffness * apart - damping * damping);
        let own: Vec<_> = found.peaks.iter().filter(|row| row.coordinate == name).collect();
        assert_eq!(own.len(), 1, "{:?}", found.peaks);
        near(own[0].value, peak.sqrt() / TAU, 1e-11);
    }
    // Without damping and drive.
    let cut = text.find("[[stops]]").unwrap();
    let free = text[..cut].replace("c = 0.4", "c = 0").replace("chi = 0.0005", "chi = 0");
    for speed in [0.0, 7.0, 45.0, 300.0] {
        // A rotor that stands still has a period, too.
        let here =
            free.replace("f = 45 ", &format!("f = {speed:?} ")).replace("frequency = \"f\"", "period = 0.01");
        let task =
            "[[tasks]]\nname = \"it\"\nkind = \"simulate\"\nstart = { q = [1, 0] }\nduration = 0.0237\n";
        let report = run(
            &Scene::from_toml(&format!("{here}{task}"), "scene.toml").unwrap(),
            Surroundings::default(),
            &mut (),
        );
        let found = serde_json::to_value(report.unwrap().remove(0)).unwrap();
        let [slow, fast] = whirls(TAU * speed);
        let modes = found["modes"].as_array().unwrap();
        for (mode, exact) in modes.iter().zip([slow, fast]) {
            near(number(&mode["frequency"]), exact / TAU, 1e-12 * exact);
            near(number(&mode["damping_ratio"]), 0.0, 1e-12);
        }
        // From z = 1 at rest, with z = q₁ + iq₂: forwards and backwards with these parts.
        let turn = |rate: f64| Complex::from_polar(1.0, rate * 0.0237);
        let exact = (turn(fast) * slow + turn(-slow) * fast) / (slow + fast);
        near(number(&found["q"][0]), exact.re, 1e-11);
        near(number(&found["q"][1]), exact.im, 1e-11);
    }
}
