//! What a task `grazing` tells an engineer: in words, how hard it hits, what changes it. Against closed forms
//! of a driven mass beside a stop, by both engines.

use grazing_scenes::{
    many::elements::Short,
    run::{GrazingReport, InfluenceRow, Mark, Sentence},
};

use super::grazing_found;
use crate::samples::one_in;

/// m q″ + c q′ + k q = F cos wt below a stop at `gap`; `more` are further keys of the task.
pub(super) fn driven(engine: &str, more: &str) -> String {
    let system = match engine {
        "one" => "mass = \"m*w^2\"\ndamping = \"c*w\"\nstiffness = \"k\"",
        _ => "period = \"2*pi/w\"\nmass = \"m\"\ndamping = \"c\"\nstiffness = \"k\"",
    };
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = {engine:?}\n[parameters]\nF = 0.9\nm = 2\nc = 0.3\n\
         k = 0.6\nw = 1.1\ngap = 0.7\ntau = 0.8\nz = 0\n[system]\n{system}\nforcing = [{{ cos = \"F + z\" }}]\n\
         [[stops]]\nname = \"stop\"\nrow = [-1]\noffset = \"-gap\"\nrestitution = \"tau\"\n[[tasks]]\nname = \"it\"\n\
         kind = \"grazing\"\nparameter = \"F\"\nrange = false\n{more}"
    )
}

/// Where it touches: F = gap |k − m w² + i c w|.
fn touch([m, c, k, w, gap]: [f64; 5]) -> f64 {
    gap * (k - m * w * w).hypot(c * w)
}

const VALUES: [f64; 5] = [2.0, 0.3, 0.6, 1.1, 0.7];

fn of<'r>(found: &'r GrazingReport, name: &str) -> &'r InfluenceRow {
    let rows = found.influence.as_ref().unwrap();
    rows.iter().find(|row| row.parameter == name).unwrap()
}

#[test]
fn the_touch_moves_with_each_parameter_as_its_formula_says() {
    let [m, c, k, w, _] = VALUES;
    let (spring, square) = (k - m * w * w, (k - m * w * w).powi(2) + (c * w).powi(2));
    // The logarithmic derivatives of the formula: per cent for one per cent.
    let expected = [
        ("w", (c * c * w * w - 2.0 * m * w * w * spring) / square),
        ("m", -m * w * w * spring / square),
        ("gap", 1.0),
        ("k", k * spring / square),
        ("c", (c * w).powi(2) / square),
        ("tau", 0.0),
    ];
    for engine in ["one", "many"] {
        let (found, shown, code) = grazing_found(&driven(engine, "sensitivity = true\nseen = false\n"));
        assert_eq!(code, 0, "{shown}");
        let at = found.at.parameter;
        assert!((at / touch(VALUES) - 1.0).abs() < 1e-12, "{engine}: {at}");
        for (name, percent) in expected {
            let row = of(&found, name);
            let (own, change) = (row.percent.unwrap(), row.change.unwrap());
            assert!((own - percent).abs() < 2e-7, "{engine} {name}: {own}, not {percent}");
            assert!((change - own * at / 100.0).abs() < 1e-12 && row.reason.is_none(), "{row:?}");
            // With a tenth less of it and a tenth more.
            let names = ["m", "c", "k", "w", "gap"];
            let with = |part: f64| {
                let one = |(value, of): (f64, &str)| if of == name { part * value } else { value };
                let there: Vec<f64> = VALUES.into_iter().zip(names).map(one).collect();
                touch(there.try_into().unwrap())
            };
            for (found, part) in [(row.less, 0.9), (row.more, 1.1)] {
                let found = found.unwrap();
                assert!((found / with(part) - 1.0).abs() < 1e-9, "{engine} {name} {part}: {found}");
            }
        }
        let order: Vec<&str> =
            found.influence.as_ref().unwrap().iter().map(|row| row.parameter.as_str()).collect();
        assert_eq!(order, ["w", "m", "gap", "k", "c", "tau", "z"], "{engine}");
        let zero = of(&found, "z");
        assert!(zero.change.is_none() && zero.reason.as_deref().unwrap().contains("it is 0"), "{zero:?}");
        assert!(shown.contains("moves the touch most by: w (+2."), "{shown}");
        let [less, more] = [0.9, 1.1].map(|part| Short(touch([2.0, 0.3, 0.6, 1.1 * part, 0.7])));
        let far = format!("; F = {less} with ten less, F = {more} with ten more), m (");
        assert!(shown.contains(&far) && zero.less.is_none(), "{far}: {shown}");
    }
}

/// By hand: the touch at 1 % more, of which the derivative is the part of first order.
#[test]
fn one_per_cent_more_moves_the_touch_by_about_that() {
    let (found, ..) = grazing_found(&driven("one", "sensitivity = true\nseen = false\n"));
    for (place, name) in ["m", "c", "k", "w", "gap"].into_iter().enumerate() {
        let mut more = VALUES;
        more[place] *= 1.01;
        let (own, by_hand) = (of(&found, name).change.unwrap(), touch(more) - touch(VALUES));
        assert!((own - by_hand).abs() < 0.03 * own.abs(), "{name}: {own}, {by_hand}");
    }
}

#[test]
fn nothing_is_found_again_unless_it_is_asked_for() {
    let (found, shown, _) = grazing_found(&driven("one", "seen = false\n"));
    assert!(found.influence.is_none() && found.hits.is_none() && !shown.contains("influence"), "{shown}");
}

/// A stop that a little more of a parameter puts behind another: the touch is another one.
#[test]
fn another_stop_that_is_touched_first_is_said() {
    for engine in ["one", "many"] {
        let text = driven(engine, "sensitivity = true\nseen = false\n");
        let other =
            "[[stops]]\nname = \"other\"\nrow = [1]\noffset = \"-gap*1.00001\"\nrestitution = 0.5\n[[tasks]]";
        let (found, shown, _) = grazing_found(
            &text
                .replace("[[tasks]]", other)
                .replace("\"-gap\"", "\"-g2\"")
                .replace("z = 0\n", "z = 0\ng2 = 0.7\n"),
        );
        let row = of(&found, "g2");
        let why = row.reason.as_deref().unwrap_or_else(|| panic!("{shown}"));
        assert!(row.change.is_none() && why.contains("stop other is touched first"), "{engine}: {why}");
    }
}

/// At a touch at 0, as of the paper's oscillator, there is a change but no per cent.
#[test]
fn a_touch_at_zero_has_no_per_cent() {
    let text = driven("one", "sensitivity = true\nseen = false\nset = { F = -0.1 }\n");
    let shifted = text.replace("cos = \"F + z\"", "cos = \"F + gap*1.85\"");
    let (found, shown, _) = grazing_found(&shifted.replace("F = 0.9", "F = 0.1"));
    let gap = of(&found, "gap");
    assert!(gap.change.is_some(), "{shown}");
    let still = driven("one", "sensitivity = true\nseen = false\n")
        .replace("cos = \"F + z\"", "cos = \"gap*(k - m*w^2)*(1 + F)\", sin = \"gap*c*w*(1 + F)\"")
        .replace("F = 0.9", "F = -0.2");
    let (found, shown, _) = grazing_found(&still);
    assert!(found.at.parameter.abs() < 1e-9, "{shown}");
    let gap = of(&found, "gap");
    assert!(gap.percent.is_none() && gap.change.unwrap().abs() < 1e-9, "{gap:?}");
    assert!(gap.reason.as_deref().unwrap().contains("no per cent"), "{gap:?}");
}

/// Beyond the touch the mass hits the stop once in a period: m (1 + τ) V is the impulse, ½ m (1 − τ²) V² the
/// energy; and the sentences have these numbers.
#[test]
fn how_hard_it_hits_is_told_with_what_is_seen() {
    for engine in ["one", "many"] {
        // README's machine in other units: what is seen beyond is periodic.
        let text = driven(engine, "").replace("c = 0.3", "c = 0.22").replace("k = 0.6", "k = 0.726");
        let (found, shown, _) = grazing_found(&text);
        let seen = found.seen.as_ref().unwrap_or_else(|| panic!("{shown}"));
        let beyond = seen.iter().find(|row| row.place == "beyond").unwrap();
        let hits = found.hits.as_ref().unwrap();
        let hit = hits.iter().find(|row| row.place == "beyond").unwrap_or_else(|| panic!("{shown}"));
        assert_eq!(
            (hit.stop.as_deref(), &hit.reason, hit.value),
            (Some("stop"), &None, beyond.value),
            "{shown}"
        );
        let speed = hit.fastest.unwrap();
        // Velocities of `one` are per radian, and its mass is m w².
        let mass = if engine == "one" { 2.0 * 1.1 * 1.1 } else { 2.0 };
        assert!((speed / beyond.speed.unwrap() - 1.0).abs() < 1e-6, "{engine}: {hit:?} {beyond:?}");
        assert!((hit.strongest.unwrap() / (mass * 1.8 * speed) - 1.0).abs() < 1e-9, "{hit:?}");
        let energy = 0.5 * mass * (1.0 - 0.64) * speed * speed;
        assert!((hit.dissipated.unwrap() / energy - 1.0).abs() < 1e-9, "{hit:?}");
        assert_eq!((hit.impacts, hit.periods), (Some(1), 1), "{shown}");
        let words = &found.in_words;
        assert!(words.starts_with(&format!("At F = {} ", Short(found.at.parameter))), "{words}");
        for part in
            ["the motion without impacts touches stop stop", "Just beyond, at F = ", "is hit with a speed"]
        {
            assert!(words.contains(part), "{part}: {words}");
        }
        // Each on a line of its own under its mark; what was followed is never called located.
        for Sentence { mark, text, .. } in &found.sentences {
            let root = ["At F = ", "Chaos is born for ", "One per cent more ", "That near the touch "]
                .iter()
                .any(|begin| text.starts_with(begin));
            assert_eq!(*mark, if root { Mark::Located } else { Mark::Seen }, "{text}");
            assert!(shown.contains(&format!("\n  {:<16} {text}", mark.to_string())), "{text}: {shown}");
        }
        // Of an oscillator the theorem is about its equation.
        assert_eq!(words.contains("is a theorem about this equation"), engine == "one", "{words}");
        let joined: Vec<&str> = found.sentences.iter().map(|sentence| &*sentence.text).collect();
        assert_eq!(joined.join(" "), *words);
    }
}

/// Theorem 1 is proved of linear equations with any stops, and of others with one.
#[test]
fn the_theorem_is_named_where_it_is_about_the_equation() {
    let linear = driven("one", "seen = false\n");
    let cubic = linear.replace("stiffness = \"k\"\n", "stiffness = \"k\"\ncubic = 0.001\n");
    let far = "[[stops]]\nname = \"far\"\nrow = [1]\noffset = -50\nrestitution = 0.5\n[[tasks]]";
    let with_far = |text: &str| text.replacen("[[tasks]]", far, 1);
    for (text, named) in
        [(linear.clone(), true), (with_far(&linear), true), (cubic.clone(), true), (with_far(&cubic), false)]
    {
        let (found, shown, _) = grazing_found(&text);
        assert_eq!(found.in_words.contains("is a theorem about this equation"), named, "{text}{shown}");
    }
}

/// In metres, seconds and kilograms and in millimetres, milliseconds and grams the sentences are the same.
#[test]
fn sentences_are_in_si_units_where_the_scene_says_its_own() {
    let text = driven("many", "").replace("c = 0.3", "c = 0.22").replace("k = 0.6", "k = 0.726");
    let with = |text: &str, units: &str| {
        grazing_found(&text.replace("[system]", &format!("[units]\n{units}\n[system]")))
    };
    let (metres, ..) = with(&text, "length = \"m\"\ntime = \"s\"\nmass = \"kg\"");
    // A newton is one gram times one millimetre over a millisecond squared.
    let other = [
        ("m = 2", "m = 2000"),
        ("k = 0.726", "k = 0.000726"),
        ("w = 1.1", "w = 0.0011"),
        ("gap = 0.7", "gap = 700"),
    ];
    let small = other.iter().fold(text.clone(), |text, (from, to)| text.replace(from, to));
    let (small, ..) = with(&small, "length = \"mm\"\ntime = \"ms\"\nmass = \"g\"");
    assert_eq!(small.in_words, metres.in_words);
    let hit = |found: &GrazingReport| found.hits.as_ref().unwrap()[0].clone();
    assert!((hit(&small).fastest.unwrap() / hit(&metres).fastest.unwrap() - 1.0).abs() < 1e-6);
    let speed = Short(hit(&metres).fastest.unwrap()).to_string();
    for part in [&format!("speed of up to {speed} m/s"), " N s", " J in a period", " s after its beginning"] {
        assert!(metres.in_words.contains(part), "{part}: {}", metres.in_words);
    }
    let (without, ..) = grazing_found(&text);
    assert!(!without.in_words.contains("m/s"), "{}", without.in_words);
    let wrong = text.replace("[system]", "[units]\nlength = \"km\"\n[system]");
    let error = grazing_scenes::scene::Scene::from_toml(&wrong, "wrong.toml").unwrap_err().to_string();
    assert!(error.contains("units.length") && error.contains("\"mm\""), "{error}");
}

/// A task that does not say how far finds the touch from a thousandth of it on, in any unit of time.
#[test]
fn a_touch_is_found_from_far() {
    let wanted = touch(VALUES);
    for engine in ["one", "many"] {
        // Where it is beyond, the engine `many` says where to begin.
        let beyond: &[f64] = if engine == "one" { &[1.001, 1.7, 40.0, 1e3] } else { &[] };
        for part in [1e-3, 0.03, 0.3, 0.999].iter().chain(beyond).step_by(one_in(3)) {
            let from = |scene: String| scene.replacen("F = 0.9", &format!("F = {:?}", part * wanted), 1);
            let (found, ..) = grazing_found(&from(driven(engine, "")));
            assert!((found.at.parameter / wanted - 1.0).abs() < 1e-11, "{engine} from {part}: {found:?}");
            // The machine's own clock, by the engine for one coordinate.
            let (found, ..) = grazing_found(&from(driven("many", "")).replacen("engine = \"many\"", "", 1));
            assert!((found.at.parameter / wanted - 1.0).abs() < 1e-11, "from {part}: {found:?}");
        }
    }
}

/// What is small beside a drive of 10³⁰⁰ is not small at the touch.
#[test]
fn what_is_seen_at_a_touch_does_not_depend_on_how_far_it_was_looked_from() {
    let at = |force: &str| {
        let text =
            driven("one", "max_period = 1\n").replace("c = 0.3", "c = 0.22").replace("k = 0.6", "k = 0.726");
        let (found, ..) = grazing_found(&text.replacen("F = 0.9", &format!("F = {force}"), 1));
        let seen = found.seen.unwrap();
        seen.into_iter().map(|row| (row.place, row.what, row.motion)).collect::<Vec<_>>()
    };
    let near = at("0.9");
    assert!(near.iter().any(|row| row.1 == "jumps"), "{near:?}");
    for force in ["1e300", "1e6", "0", "1e-300"] {
        assert_eq!(at(force), near, "from {force}");
    }
}
