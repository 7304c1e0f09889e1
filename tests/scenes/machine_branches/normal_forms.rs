//! Which way bifurcations of machines go: against the one-degree code, against a script that takes the
//! Poincaré map by differences in 60 digits (`tests/data/make_machine_normal_forms.py`), and cusps and
//! generalised flips where closed formulas and another method have them.

use std::f64::consts::{PI, TAU};

use grazing_scenes::{
    continuation::{Bifurcation, Degeneracy, Derivatives, Direction, Options},
    many::{
        branch::{Branch, Events, Plane},
        orbit::{Itinerary, Strike},
    },
    motion::Side,
    one::orbit::return_map,
    scene::{Scene, SceneFamily},
};
use serde_json::Value;

use super::{ALONE, near, number, run, task};

/// The length, as machines count it, of the critical direction of the one-degree code, which has length 1 in
/// (t, V), at an event of the paper's oscillator.
pub fn length(row: &Value, periods: u32, multiplier: f64) -> f64 {
    let scene = Scene::from_toml(ALONE, "alone").unwrap();
    let oscillator = SceneFamily::new(&scene, "mu").unwrap();
    let oscillator = grazing_scenes::one::orbit::Family::at(&oscillator, number(&row["parameter"])).unwrap();
    let z = [TAU * number(&row["phases"][0]), number(&row["speeds"][0])];
    let pattern = grazing_scenes::one::orbit::Itinerary::at(Side::Lower, &[periods]).unwrap();
    let a = Derivatives::of(&return_map(&oscillator, &pattern, &z).unwrap()).linear();
    let q = [a[0][1], multiplier - a[0][0]];
    q[0].hypot(q[1] / z[1]) / q[0].hypot(q[1])
}

/// The coefficient and the side of an event of the script's.
pub fn known(machine: &str, event: &str) -> (f64, f64) {
    let text = include_str!("../../data/machine_normal_forms.csv");
    let start = format!("{machine},{event},");
    let row = text.lines().find_map(|line| line.strip_prefix(&start)).unwrap_or_else(|| panic!("{start}"));
    let (coefficient, side) = row.split_once(',').unwrap();
    (coefficient.parse().unwrap(), side.parse().unwrap())
}

/// What a row says against the script's coefficient.
pub fn agrees(row: &Value, machine: &str, event: &str) {
    let (coefficient, side) = known(machine, event);
    near(number(&row["coefficient"]), coefficient, 1e-5 * coefficient.abs());
    let want = match event {
        "saddle-node" if side > 0.0 => "above",
        "saddle-node" => "below",
        "flip" if coefficient > 0.0 => "supercritical",
        "neimark-sacker" if coefficient < 0.0 => "supercritical",
        _ => "subcritical",
    };
    assert_eq!(row["criticality"], want, "{row}");
}

/// With one coordinate the map keeps areas where λ₁λ₂ = 1: no closed curve is born.
#[test]
fn with_one_coordinate_neimark_sacker_points_are_degenerate() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "format = \"grazing-scene 2\"\ntitle = \"a ball in air\"\n[parameters]\nr = 1.2\n[system]\n\
                 period = \"2*pi\"\nmass = 1\ndamping = \"1/10\"\nforce = -1\n[[walls]]\nname = \"table\"\noffset = 0\n\
                 harmonics = [{ sin = \"3/5\" }]\nrestitution = \"r\"\n";
    let (c, r): (f64, f64) = (0.1, 1.2);
    let e = (-TAU * c).exp();
    let w = TAU / (1.0 - e) * (1.0 + r * e) / (1.0 + r) - 1.0 / c;
    let phase = (0.36 - w * w).sqrt().atan2(w) / TAU;
    let keys = format!(
        "event = \"neimark-sacker\"\nparameter = \"r\"\nreach = 0.5\norbit = {{ pattern = [1], start = [{phase}, {}] }}",
        TAU / (1.0 + r)
    );
    let (report, code, error) = run(scene, &[task("ns", "event", &keys)], folder.path());
    assert_eq!(code, 0, "{error}{report}");
    let found = &report["tasks"][0]["found"][0];
    near(number(&found["parameter"]), (PI * c).exp(), 1e-11);
    assert_eq!(found["criticality"], "degenerate", "{found}");
    near(number(&found["coefficient"]), 0.0, 1e-11);
}

/// A ball under gravity 1 on a table with restitution 3/5, alone, or as the sum of two coordinates whose
/// difference oscillates for itself.
fn ball(parameters: &str, harmonics: &str, alone: bool) -> Scene {
    let system = if alone {
        "mass = 1\nforce = -1"
    } else {
        "mass = [[2, 0], [0, 2]]\ndamping = [[0.1, -0.1], [-0.1, 0.1]]\nstiffness = [[0.3, -0.3], [-0.3, 0.3]]\n\
         force = [-1, -1]"
    };
    let row = if alone { "[1]" } else { "[1, 1]" };
    let text = format!(
        "format = \"grazing-scene 2\"\ntitle = \"a ball\"\n[parameters]\n{parameters}\n[system]\nperiod = \"2*pi\"\n{system}\n\
         [[walls]]\nname = \"table\"\nrow = {row}\noffset = 0\nharmonics = [{harmonics}]\nrestitution = \"3/5\""
    );
    Scene::from_toml(&text, "ball").unwrap()
}

/// The curve of a bifurcation of the orbit with one impact every period, at time t, in two parameters.
fn curve(
    scene: &Scene,
    event: Bifurcation,
    names: [&str; 2],
    ranges: [(f64, f64); 2],
    t: f64,
    at: [f64; 2],
) -> Branch {
    let machine = |[x, y]: [f64; 2]| scene.machine(&[(names[0], x), (names[1], y)]);
    let here = machine(at).unwrap();
    let [place, speed, _] = here.contacts().unwrap()[0].position.at(t);
    let (n, arrival) = (here.size, TAU / 1.6);
    let mut z = vec![place / n as f64; n];
    z.extend(vec![(speed + 0.6 * arrival) / n as f64; n]);
    z.extend([t, arrival]);
    let plane = Plane::new(&machine, at, None, None).unwrap();
    let pattern = Itinerary::new(vec![Strike { place: 0, periods: 1 }]).unwrap();
    let events = Events { plane: &plane, itinerary: pattern, event: Some(event), ranges, levels: &[] };
    let options = Options::default();
    let place = events.start(&z, at, &options).unwrap();
    Branch::follow(&events, &place, Direction::Both, &options).unwrap()
}

/// Exactly these degeneracies of one kind and no others, in any order.
fn expect(branch: &Branch, what: Degeneracy, wanted: &[[f64; 2]], tolerance: f64) {
    let found: Vec<_> =
        branch.points.iter().filter_map(|point| Some((point.degeneracy?, &point.parameters))).collect();
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for at in wanted {
        let there = |(label, place): &(Degeneracy, &Vec<f64>)| {
            *label == what && (0..2).all(|i| (place[i] - at[i]).abs() <= tolerance)
        };
        assert!(found.iter().any(there), "{what:?} at {at:?}: {found:?}");
    }
    assert!(branch.points.iter().all(|point| point.event.is_none()), "{:?}", branch.labels());
}

/// The table A sin t − B cos t + sin(2t)/4, as in `tests/motion/codimension_two.rs`: a cusp where three
/// derivatives vanish.
#[test]
fn a_cusp_of_a_machine_is_where_three_derivatives_of_the_table_say() {
    let (d, w) = (0.5, PI * 0.4 / 1.6);
    let folds = |t: f64| {
        let (along, across) = (w - d * (2.0 * t).cos(), 2.0 * d * (2.0 * t).sin());
        [along * t.cos() - across * t.sin(), along * t.sin() + across * t.cos()]
    };
    let cusp = (-w / (3.0 * d)).acos() / 2.0;
    let ranges = [(-2.0, 2.0), (0.5, 3.0)];
    let inside = |at: &[f64; 2]| (0..2).all(|i| (ranges[i].0..ranges[i].1).contains(&at[i]));
    let wanted: Vec<_> = [cusp, PI - cusp].map(folds).into_iter().filter(inside).collect();
    assert!(!wanted.is_empty());
    for alone in [true, false] {
        let scene = ball("A = 1\nB = 1", "{ sin = \"A\", cos = \"-B\" }, { k = 2, sin = \"1/4\" }", alone);
        let from = cusp + 0.3;
        let found = curve(&scene, Bifurcation::SaddleNode, ["A", "B"], ranges, from, folds(from));
        expect(&found, Degeneracy::Cusp, &wanted, 1e-7);
    }
}

/// The table a sin t + E (sin 3t + cos 3t); the places are those of `tests/motion/codimension_two.rs`, from
/// the doubled orbit's equations in 40 digits.
#[test]
fn generalised_flips_of_a_machine_are_where_the_doubled_orbit_turns_round() {
    let (w, s) = (PI * 0.4 / 1.6, 2.0 * 1.36 / 2.56f64);
    let wanted = [
        [1.480_180_585_700_640_5, 0.023_317_617_020_929_43],
        [1.656_215_406_539_152, 0.046_937_949_767_730_29],
        [1.949_367_016_477_912_7, 0.072_720_671_181_560_34],
    ];
    for alone in [true, false] {
        let scene = ball("a = 1.3\nE = 0.001", "{ sin = \"a\" }, { k = 3, sin = \"E\", cos = \"E\" }", alone);
        let ranges = [(1.0, 2.4), (0.0, 0.1)];
        let found = curve(&scene, Bifurcation::Flip, ["a", "E"], ranges, s.atan2(w), [s.hypot(w), 0.0]);
        expect(&found, Degeneracy::GeneralisedFlip, &wanted, 1e-8);
    }
}
