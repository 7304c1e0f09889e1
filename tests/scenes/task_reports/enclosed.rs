//! The touch of a linear machine between two values of the parameter: the ends, as the report has them,
//! against its formula in exact fractions, and against another solver.

use grazing_base::random::Random;
use grazing_number::parse_rational;
use num_rational::BigRational;
use num_traits::Signed;

use super::{grazing_found, touches::driven};
use crate::samples::samples;

/// gap² ((k − m w²)² + (c w)²) − F²: 0 at a touch, of one sign on each side.
fn formula([force, m, c, k, w, gap]: &[BigRational; 6]) -> BigRational {
    let (spring, damper) = (k - m * w * w, c * w);
    gap * gap * (&spring * &spring + &damper * &damper) - force * force
}

const NAMES: [&str; 6] = ["F", "m", "c", "k", "w", "gap"];

#[test]
fn the_ends_are_on_either_side_of_the_touch_exactly() {
    let mut random = Random(59);
    let mut drawn = |least: u64, most: u64| (least + random.bits() % (most - least)) as f64 / 1000.0;
    let mut enclosed = 0;
    for number in 0..samples::<u64>(3) {
        let values = [
            drawn(10, 3000),
            drawn(200, 4000),
            drawn(1, 900),
            drawn(100, 4000),
            drawn(300, 2500),
            drawn(100, 2000),
        ];
        for engine in ["one", "many"] {
            for (place, name) in NAMES.into_iter().enumerate() {
                let mut text = driven(engine, "seen = false\nmax_period = 1\n")
                    .replace("parameter = \"F\"", &format!("parameter = {name:?}"));
                for ((name, own), value) in
                    NAMES.iter().zip(["0.9", "2", "0.3", "0.6", "1.1", "0.7"]).zip(values)
                {
                    text = text.replacen(&format!("\n{name} = {own}\n"), &format!("\n{name} = {value}\n"), 1);
                }
                // Not each parameter brings each machine to its stop.
                let Some((found, shown)) = attempt(&text) else { continue };
                let ends =
                    found.touch.unwrap_or_else(|| panic!("{number} {engine} {name} {values:?} {shown}"));
                let at = |end: &String| {
                    let mut exact = values.map(|value| parse_rational(&value.to_string()).unwrap());
                    exact[place] = parse_rational(end).unwrap();
                    formula(&exact)
                };
                let [low, high] = ends.each_ref().map(at);
                assert!((&low * &high).is_negative(), "{number} {engine} {name} {ends:?} {values:?}");
                let [low, high] = ends.each_ref().map(|end| end.parse::<f64>().unwrap());
                let parameter = found.at.parameter;
                assert!(low < parameter && parameter < high, "{ends:?} {parameter:?}");
                assert!(high - low < 1e-9 * parameter.abs(), "{number} {engine} {name} {ends:?}");
                assert!(shown.contains("touch            enclosed, between"), "{shown}");
                enclosed += 1;
            }
        }
    }
    assert!(enclosed > 10, "{enclosed}");
}

/// A report, where there is a touch.
fn attempt(text: &str) -> Option<(grazing_scenes::run::GrazingReport, String)> {
    let scene = grazing_scenes::scene::Scene::from_toml(text, "t.toml").unwrap();
    let report = grazing_scenes::run::run(&scene, grazing_scenes::run::Surroundings::default(), &mut ())
        .unwrap()
        .remove(0);
    let shown = report.to_string();
    match report.findings {
        Some(grazing_scenes::run::Findings::Grazing(found)) => match *found {
            grazing_scenes::run::GrazingFindings::Found(found) => Some((*found, shown)),
            grazing_scenes::run::GrazingFindings::Nothing { .. } => None,
        },
        _ => panic!("{shown}"),
    }
}

/// Where a touch is not enclosed the report says why, and that it is located.
#[test]
fn what_is_not_linear_is_located() {
    let one = driven("one", "seen = false\nmax_period = 1\n");
    let many = driven("many", "seen = false\nmax_period = 1\n");
    let cases = [
        (one.replace("stiffness = \"k\"", "stiffness = \"k\"\ncubic = 0.01"), "of a linear motion"),
        (many.replace("damping = \"c\"\n", "damping_ratio = [0.1]\n"), "by ratios of modes"),
    ];
    for (text, why) in cases {
        let (found, shown, code) = grazing_found(&text);
        assert_eq!((found.touch, code), (None, 0), "{shown}");
        let said = found.touch_open.unwrap();
        assert!(said.contains(why) && shown.contains("touch            located, not enclosed: "), "{shown}");
    }
}

/// Of two coordinates with resonances beside the drive, of shapes and of a stop that moves: the ends hold
/// what floats come to, by either sign of e.
#[test]
fn machines_of_several_coordinates_have_ends() {
    let text = "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 0.5\nw = 1.3\n[system]\nperiod = \"2*pi/w\"\n\
                mass = [[1, 0], [0, 2]]\ndamping = [[0.02, -0.01], [-0.01, 0.03]]\nstiffness = [[2, -1], [-1, 3]]\n\
                forcing = [{ cos = [\"F\", 0] }, { k = 3, sin = [0, \"F/3\"] }]\n[[stops]]\nname = \"a\"\nrow = [-1, 1]\noffset = -1\n\
                harmonics = [{ k = 2, cos = 0.1 }]\nrestitution = 0.8\n[[stops]]\nname = \"b\"\nrow = [1, 0.5]\noffset = -2\n\
                restitution = 0.5\n[[tasks]]\nname = \"it\"\nkind = \"grazing\"\nparameter = \"P\"\nseen = false\nmax_period = 1\n";
    for parameter in ["F", "w"] {
        let (found, shown, _) = grazing_found(&text.replace("\"P\"", &format!("{parameter:?}")));
        let ends = found.touch.unwrap_or_else(|| panic!("{shown}"));
        let [low, high] = ends.each_ref().map(|end| end.parse::<f64>().unwrap());
        assert!(
            low < found.at.parameter && found.at.parameter < high && high - low < 1e-10,
            "{ends:?} {shown}"
        );
    }
}
