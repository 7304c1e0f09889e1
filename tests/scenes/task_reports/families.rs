//! Backbone curves of several coordinates: against elliptic integrals where motions are in line, a second
//! solver where they are not, and where they end.

use std::f64::consts::TAU;

use grazing_scenes::run::{BackboneRow, Findings, ResponseFindings};

use super::{
    backbones::agm,
    responses::{found, reports, task},
};
use crate::tasks::near;

fn rows<'f>(found: &'f ResponseFindings, mode: usize, coordinate: &str) -> Vec<&'f BackboneRow> {
    let all = found.backbone.as_ref().unwrap().iter();
    all.filter(|row| row.mode == mode && row.coordinate == coordinate).collect()
}

/// What a row of the ends says: mode, coordinate, value, swing, why.
fn ends(found: &ResponseFindings) -> Vec<(usize, String, f64, Option<f64>, &'static str)> {
    let all = found.backbone_ends.as_ref().unwrap().iter();
    all.map(|end| (end.mode, end.coordinate.clone(), end.value, end.swing, end.why)).collect()
}

/// Two equal masses on equal springs, coupled, the drive at half of the frequency that is asked for; damping
/// and drive by formulas, too, which leave no trace.
fn pair(mass: f64, force: &str, more: &str) -> String {
    format!(
        "[parameters]\nf = 0.25\n[system]\nfrequency = \"f\"\nmass = [[{mass:?}, 0], [0, {mass:?}]]\n\
         stiffness = [[1.5, -0.5], [-0.5, 1.5]]\ndamping = [[0.1, 0], [0, 0.1]]\n\
         force = [\"-q1^3 - 0.2*q1^2*u1\", \"{force} + sin(t)\"]\nforcing = [{{ k = 2, cos = [0.1, 0] }}]\n{}",
        task("f", [0.15, 0.4], 5, &format!("backbone = true\nseen = false\n{more}"))
    )
}

/// In line and against one another each moves as on a spring of its own, k = 1 or 2 and q³: by Gauss's mean.
/// The energy is that of both springs.
#[test]
fn equal_masses_move_as_jacobis_cosine() {
    for (mass, harmonic) in [(1.0, 1), (4.0, 2)] {
        let found = found(&pair(mass, "-q2^3", &format!("harmonic = {harmonic}")));
        for (mode, stiffness) in [(1, 1.0f64), (2, 2.0)] {
            let [one, two] = ["q1", "q2"].map(|name| rows(&found, mode, name));
            assert!(one.len() > 20 && one.len() == two.len());
            for (one, two) in one.into_iter().zip(two) {
                let a = one.swing;
                let whole = stiffness + a * a;
                let rate = (whole / mass).sqrt() * agm(1.0, (1.0 - a * a / (2.0 * whole)).sqrt());
                near(f64::from(harmonic) * TAU * one.value, rate, 1e-8);
                near(two.swing, a, 1e-7);
                near(one.energy.unwrap(), stiffness * a * a + a.powi(4) / 2.0, 1e-6 * (a * a).max(1e-2));
                assert_eq!((one.value, one.energy), (two.value, two.energy));
            }
            let natural = (stiffness / mass).sqrt() / TAU / f64::from(harmonic);
            let inside = (0.15..0.4).contains(&natural);
            let told: Vec<_> =
                ends(&found).into_iter().filter(|end| end.0 == mode && end.1 == "q1").collect();
            assert_eq!(told.len(), 2, "{told:?}");
            assert_eq!((told[0].4, told[1].4), (if inside { "natural frequency" } else { "range" }, "range"));
            near(told[0].2, if inside { natural } else { 0.15 }, 1e-9);
            near(told[1].2, 0.4, 1e-12);
        }
    }
}

/// In radians of the drive, where its frequency stands in the coefficients, the families are the same; where
/// it does not stand in all of them it is no frequency.
#[test]
fn a_family_is_the_same_in_radians_of_the_drive() {
    let radians = |cubic: &str| {
        let scene = format!(
            "[parameters]\nw = 1.5\n[system]\nmass = [[1, 0], [0, 1]]\n\
             stiffness = [[\"1.5/w^2\", \"-0.5/w^2\"], [\"-0.5/w^2\", \"1.5/w^2\"]]\n\
             force = [\"-q1^3/w^2\", \"{cubic}\"]\nforcing = [{{ k = 2, cos = [0.1, 0] }}]\n"
        );
        let task = task("w", [0.15 * TAU, 0.4 * TAU], 5, "backbone = true\nseen = false\nharmonic = 2");
        reports(&format!("{scene}{task}")).unwrap().remove(0)
    };
    let seconds = found(&pair(1.0, "-0.3*q2^3", "harmonic = 2"));
    let report = radians("-0.3*q2^3/w^2");
    let Some(Findings::Response(other)) = &report.findings else { panic!("{report}") };
    for mode in [1, 2] {
        for name in ["q1", "q2"] {
            let [one, two] = [&seconds, other].map(|found| rows(found, mode, name));
            assert_eq!(one.len(), two.len());
            for (one, two) in one.iter().zip(two) {
                near(one.value * TAU, two.value, 1e-9);
                near(one.swing, two.swing, 1e-9);
            }
        }
    }
    let report = radians("-0.3*q2^3").to_string();
    assert!(report.contains("w changes more of the forces than that"), "{report}");
}

/// Forces that are odd: from where both turn back at once, the motion by another solver is back after the
/// period.
#[test]
fn unequal_springs_have_vibrations_that_come_back() {
    let found = found(&pair(1.0, "-0.3*q2^3 - 0.1*q2^5", ""));
    let force = |q: [f64; 2]| {
        [
            -1.5 * q[0] + 0.5 * q[1] - q[0].powi(3),
            0.5 * q[0] - 1.5 * q[1] - 0.3 * q[1].powi(3) - 0.1 * q[1].powi(5),
        ]
    };
    let after = |start: [f64; 2], time: f64| {
        let (steps, mut x) = (4000, [start[0], start[1], 0.0, 0.0]);
        let h = time / f64::from(steps);
        let rate = |x: [f64; 4]| {
            let f = force([x[0], x[1]]);
            [x[2], x[3], f[0], f[1]]
        };
        let moved = |x: [f64; 4], k: [f64; 4], h: f64| [0, 1, 2, 3].map(|i| x[i] + h * k[i]);
        for _ in 0..steps {
            let a = rate(x);
            let b = rate(moved(x, a, h / 2.0));
            let c = rate(moved(x, b, h / 2.0));
            let d = rate(moved(x, c, h));
            x = [0, 1, 2, 3].map(|i| x[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        x
    };
    for mode in [1, 2] {
        let pairs = rows(&found, mode, "q1").into_iter().zip(rows(&found, mode, "q2"));
        let mut largest = 0.0f64;
        for (one, two) in pairs.step_by(4) {
            let start = [one.swing, if mode == 1 { two.swing } else { -two.swing }];
            let end = after(start, 1.0 / one.value);
            let off = (0..2).map(|i| (end[i] - start[i]).abs().max(end[i + 2].abs())).fold(0.0, f64::max);
            assert!(off < 1e-6 * (1.0 + start[0].abs()), "{mode} {one:?} {two:?} {off:e}");
            largest = largest.max(one.swing.min(two.swing));
        }
        assert!(largest > 0.1);
    }
}

/// A second spring beyond a gap makes it lean; at the rigid stop it ends.
#[test]
fn a_family_ends_where_it_meets_a_rigid_stop() {
    let scene = "[parameters]\nf = 0.25\n[system]\nfrequency = \"f\"\nmass = [[1, 0], [0, 1]]\n\
                 stiffness = [[1.5, -0.5], [-0.5, 1.5]]\n\
                 [[stops]]\nname = \"soft\"\nrow = [-1, 0]\noffset = -0.5\nstiffness = 4\n\
                 [[stops]]\nname = \"rigid\"\nrow = [0, -1]\noffset = -0.8\nrestitution = 0.5\n";
    let found = found(&format!("{scene}{}", task("f", [0.15, 0.4], 5, "backbone = true\nseen = false")));
    for mode in [1, 2] {
        let told: Vec<_> = ends(&found).into_iter().filter(|end| end.0 == mode && end.1 == "q2").collect();
        let last = rows(&found, mode, "q2").into_iter().next_back().unwrap();
        assert_eq!((told[0].4, told[1].4), ("natural frequency", "stop"), "{told:?}");
        assert_eq!((told[1].2, told[1].3), (last.value, Some(last.swing)));
        assert!(last.value > told[0].2 + 1e-3, "{last:?}");
    }
    // A mode that the second spring does not reach is told, too: the masses are apart.
    let apart = scene.replace("-0.5", "0").replace("offset = 0\nstiffness", "offset = -0.5\nstiffness");
    let apart = apart.replace("[0, 1.5]]", "[0, 1.9]]");
    let alone =
        self::found(&format!("{apart}{}", task("f", [0.15, 0.4], 5, "backbone = true\nseen = false")));
    let told: Vec<_> =
        ends(&alone).into_iter().filter(|end| end.1 == "q1").map(|end| (end.0, end.4)).collect();
    assert_eq!(told, [(1, "natural frequency"), (1, "largest swings"), (2, "linear")]);
    near(ends(&alone).last().unwrap().2, 1.9f64.sqrt() / TAU, 1e-9);
    // Half a cosine on either spring, as large ones have it; the energy is that of both.
    let slow = (0.5 / 1.5f64.sqrt() + 0.5 / 5.5f64.sqrt()) * TAU;
    let largest =
        alone.backbone_ends.as_ref().unwrap().iter().find(|end| end.why == "largest swings").unwrap();
    assert!((largest.value * slow - 1.0).abs() < 1e-3 && largest.swing.is_none(), "{largest:?}");
    for row in rows(&alone, 1, "q1").iter().filter(|row| row.swing > 1.0) {
        // 1.5 a² = 1.5 b² + 4 (b − 0.5)² from one end to the other, a + b being twice the swing.
        let whole = 2.0 * row.swing;
        let energy = |b: f64| 0.75 * b * b + 2.0 * (b - 0.5) * (b - 0.5);
        let (mut low, mut high) = (0.5, whole);
        for _ in 0..100 {
            let middle = f64::midpoint(low, high);
            let below = energy(middle) < 0.75 * (whole - middle) * (whole - middle);
            *(if below { &mut low } else { &mut high }) = middle;
        }
        near(row.energy.unwrap() / energy(low), 1.0, 1e-8);
    }
    // Nothing leans without it, and of another parameter it is not told.
    let linear = scene.replace("stiffness = 4\n", "restitution = 1\n");
    let text = format!("{linear}{}", task("f", [0.15, 0.4], 5, "backbone = true\nseen = false"));
    let report = reports(&text).unwrap().remove(0).to_string();
    assert!(report.contains("nothing found") && report.contains("linear springs"), "{report}");
    let other = scene.replace("f = 0.25\n", "f = 0.25\nm = 1\n").replace("[[1, 0]", "[[\"m\", 0]");
    let text = format!("{other}{}", task("m", [1.0, 2.0], 5, "backbone = true\nseen = false"));
    let report = reports(&text).unwrap().remove(0).to_string();
    assert!(report.contains("it is over the drive's frequency"), "{report}");
    let turned = scene.replace("stiffness = [[", "damping = [[0, 1], [-1, 0]]\nstiffness = [[");
    let error = reports(&format!("{turned}{}", task("f", [0.15, 0.4], 5, "backbone = true"))).unwrap_err();
    assert!(error.to_string().contains("gyroscopic"), "{error}");
}
