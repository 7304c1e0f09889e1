//! Tolerances of scenes in the report of a task `grazing`: what is said of all machines against machines one
//! by one, the same machines asked for otherwise, and every reason for which nothing is said.

use std::sync::Arc;

use grazing_scenes::{
    internals::random::Random,
    number::{Ball, Elementary, Precision, Real, parse_rational},
    run::{Findings, GrazingFindings, GrazingReport, Judgement, Surroundings, ToleranceReport, run},
    scene::Scene,
    tolerance::{Coefficients, ParameterBox, Partition, Sloped, Spread, Statement},
    word::{Entropy, Rectangle, Word},
};
use num_rational::BigRational;
use num_traits::Signed;

use super::grazing_found as found;
use crate::samples::{one_in, samples};

type Q = BigRational;

fn q(text: &str) -> Q {
    parse_rational(text).unwrap()
}

/// A machine with these parameters, damping and stiffness, the amplitude of its drive F, beside a stop at 1.
fn text(parameters: &str, damping: &str, stiffness: &str, keys: &str) -> String {
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 0.1\n{parameters}\n[system]\n\
         damping = \"{damping}\"\nstiffness = \"{stiffness}\"\nforcing = [{{ cos = \"F\" }}]\n\
         [[stops]]\nside = \"upper\"\noffset = 1\nrestitution = 0.8\n[[tasks]]\nname = \"g\"\nkind = \"grazing\"\n\
         parameter = \"F\"\nmax_period = 1\nreach = 1000\nseen = false\n{keys}\n"
    )
}

/// Both words at a machine: a₁, a₂ and so the words of a small rectangle; and whether γ > 0. None where even
/// that is open.
fn at(c: &Q, k: &Q) -> Option<([Word; 2], bool)> {
    let precision = Precision::new(256);
    let exact = |x: &Q| Ball::ratio(x, &precision);
    let pi = Ball::pi(&precision);
    let square = k - c * c / q("4");
    let decay = (-(pi.clone() * &exact(c))).exp(&precision);
    let (cosine, gamma) = if square > q("0") {
        let turn = pi * &Ball::integer(2, &precision) * &exact(&square).sqrt();
        let (sine, cosine) = turn.sin_cos(&precision);
        (cosine, sine.sign()? == grazing_scenes::number::Sign::Positive)
    } else {
        let x = (pi * &Ball::integer(2, &precision) * &exact(&-square).sqrt()).exp(&precision);
        ((x.clone() + &(Ball::integer(1, &precision) / &x)) / &Ball::integer(2, &precision), true)
    };
    let ends = |x: Ball| x.exact_bounds().map(|(lo, hi)| [lo, hi]);
    let a1 = ends(Ball::integer(2, &precision) * &decay * &cosine)?;
    let rectangle = Rectangle::new(a1, ends(decay.clone() * &decay)?).ok()?;
    let words = [true, false].map(|positive| Word::in_rectangle(&rectangle, positive, 200, &()).unwrap());
    words.iter().all(Word::is_whole).then_some((words, gamma))
}

/// Of one machine what is said of all of them; how often chaos is born on either side.
fn agrees(report: &ToleranceReport, c: &Q, k: &Q, born: &mut [u64; 2]) -> bool {
    let Some((words, gamma)) = at(c, k) else { return false };
    assert!(report.sign_gamma.is_none_or(|sign| (sign > 0) == gamma));
    for (i, (side, word)) in report.sides.iter().zip(&words).enumerate() {
        let letters = word.letters();
        assert!(letters.starts_with(&side.word), "{letters} {side:?}");
        assert!(!side.whole || letters == side.word, "{letters} {side:?}");
        let chaos = matches!(Entropy::of(word, gamma, 64).unwrap().0, Entropy::Positive { .. });
        assert!(side.chaos != "everywhere" || chaos, "{c} {k} {side:?}");
        assert!(side.chaos != "nowhere" || !chaos, "{c} {k} {side:?}");
        born[i] += u64::from(chaos);
    }
    true
}

fn at_random(random: &mut Random, [lo, hi]: &[Q; 2]) -> Q {
    lo + (hi - lo) * Q::new((random.bits() >> 32).into(), (1u64 << 32).into())
}

/// A parameter, its value and its tolerance.
type Parameter = (&'static str, &'static str, &'static str);

/// Damping and stiffness as functions of parameters.
type Machine = (&'static str, &'static str, &'static [Parameter], fn(&[Q]) -> [Q; 2]);

const MACHINES: [Machine; 8] = [
    ("c", "k", &[("c", "0.1", "\"20%\""), ("k", "0.3", "\"2%\"")], |p| [p[0].clone(), p[1].clone()]),
    ("c", "k", &[("c", "0.05", "\"±20 %\""), ("k", "1.5129", "0.02")], |p| [p[0].clone(), p[1].clone()]),
    ("2*z*w", "w^2", &[("z", "0.02", "\"20%\""), ("w", "1.23", "\"1%\"")], |p| {
        [Q::from_integer(2.into()) * &p[0] * &p[1], &p[1] * &p[1]]
    }),
    // Both move with the mass; the parameters in the other order than their places in a formula.
    ("0.05/m", "s/m", &[("s", "6", "\"0.1\""), ("m", "2", "[1.9, 2.05]")], |p| {
        [q("0.05") / &p[1], &p[0] / &p[1]]
    }),
    // A line of machines, whose parameter is not linear; real eigenvalues at one end.
    ("0.4 + p^2/(1 + p)", "0.3 - p/10", &[("p", "1", "[0.2, 1.5]"), ("x", "7", "1")], |all| {
        let (one, p) = (q("1"), &all[0]);
        [q("0.4") + p * p / (&one + p), q("0.3") - p / q("10")]
    }),
    // γ changes its sign with k = ¼ + c²/4.
    ("c", "k", &[("c", "0.01", "[0.01, 0.03]"), ("k", "0.262", "[0.23, 0.27]")], |p| {
        [p[0].clone(), p[1].clone()]
    }),
    // Mass, spring and damper, each up to a tolerance; and four.
    ("d/m", "s/m", &[("d", "0.1", "\"20%\""), ("m", "2", "\"1%\""), ("s", "3.0258", "\"1%\"")], |p| {
        [&p[0] / &p[1], &p[2] / &p[1]]
    }),
    (
        "d*n/m",
        "s*n/m",
        &[("n", "2", "[2, 2]"), ("m", "4", "\"0.5%\""), ("s", "3.0258", "\"1%\""), ("d", "0.1", "\"20%\"")],
        |p| [&p[3] * &p[0] / &p[1], &p[2] * &p[0] / &p[1]],
    ),
];

fn report_of((damping, stiffness, parameters, _): &Machine) -> (ToleranceReport, String, u8) {
    let values: Vec<String> = parameters.iter().map(|(name, value, _)| format!("{name} = {value}")).collect();
    let tolerances: Vec<String> = parameters.iter().map(|(name, _, by)| format!("{name} = {by}")).collect();
    let keys = format!("tolerance = {{ {} }}", tolerances.join(", "));
    let (report, shown, code) = found(&text(&values.join("\n"), damping, stiffness, &keys));
    assert_eq!(report.tolerance_open, None);
    (report.tolerance.unwrap(), shown, code)
}

fn bounds(report: &ToleranceReport) -> Vec<[Q; 2]> {
    report.parameters.iter().map(|one| [q(&one.lower), q(&one.upper)]).collect()
}

/// 150 machines at random in each box, and those that are named with chaos and without.
#[test]
fn machines_one_by_one_do_not_contradict_what_is_said_of_all() {
    let mut random = Random(7);
    for machine in MACHINES.iter().step_by(one_in(3)) {
        let (report, shown, code) = report_of(machine);
        // Where γ may be 0 it is open what is born.
        let open = report.sides.iter().any(|side| side.chaos == "open");
        assert_eq!((code, open), if report.sign_gamma.is_none() { (3, true) } else { (0, false) }, "{shown}");
        let (all, mut born, mut count) = (bounds(&report), [0, 0], 0);
        let drawn: u32 = samples(12);
        for _ in 0..drawn {
            let point: Vec<Q> = all.iter().map(|side| at_random(&mut random, side)).collect();
            let [c, k] = machine.3(&point);
            count += u64::from(agrees(&report, &c, &k, &mut born));
        }
        assert!(20 * count > 19 * u64::from(drawn), "{count}");
        for (side, born) in report.sides.iter().zip(born) {
            let [least, most] =
                side.share.each_ref().map(|end| num_traits::ToPrimitive::to_f64(&q(end)).unwrap());
            // Four standard deviations of as many, and more.
            let (counted, off) = (born as f64 / count as f64, 2.1 / f64::from(drawn).sqrt());
            assert!(least - off < counted && counted < most + off, "{side:?} {counted}");
            // Cells of a space of more parameters are wider.
            let wide = if machine.2.len() > 2 { 0.1 } else { 0.02 };
            assert!(least <= most && (open || most - least < wide), "{side:?}");
            for (point, chaos) in [(&side.with, true), (&side.without, false)] {
                let Some(point) = point else { continue };
                let value = |i: usize| {
                    let (name, value, _) = machine.2[i];
                    let found = point.iter().find(|one| one.name == name);
                    q(found.map_or(value, |one| &one.value))
                };
                let [c, k] = machine.3(&(0..machine.2.len()).map(value).collect::<Vec<_>>());
                let (words, gamma) = at(&c, &k).unwrap();
                let word = &words[usize::from(side.sign_emu < 0)];
                let found = matches!(Entropy::of(word, gamma, 64).unwrap().0, Entropy::Positive { .. });
                assert_eq!(found, chaos, "{side:?}");
            }
        }
    }
}

/// c = d/m and k = s/m of mass, spring and damper.
#[derive(Debug)]
struct Parts;

impl Coefficients for Parts {
    fn at(&self, point: &[Q]) -> grazing_scenes::Result<[Q; 2]> {
        Ok([&point[2] / &point[0], &point[1] / &point[0]])
    }

    fn over(&self, cell: &[Sloped]) -> grazing_scenes::Result<[Sloped; 2]> {
        Ok([cell[2] / &cell[0], cell[1] / &cell[0]])
    }
}

/// What is certain on a cell of three parameters is so at a machine of it at random, and together the cells
/// are the box.
#[test]
fn cells_of_three_parameters_do_not_contradict_their_machines() {
    let sides = [["1.98", "2.02"], ["2.99", "3.06"], ["0.08", "0.12"]].map(|side| side.map(q));
    let of = ParameterBox::oscillator(Arc::new(Parts), &sides).unwrap();
    let partition = Partition::new(&of, 3000, &()).unwrap();
    let (mut random, mut told, mut whole) = (Random(3), [0, 0], q("0"));
    for (i, leaf) in partition.leaves().iter().enumerate() {
        let size = |of: &ParameterBox| of.sides().fold(q("1"), |size, [lo, hi]| size * (hi - lo));
        assert_eq!(size(&leaf.cell) * Q::from_integer((1u64 << leaf.depth).into()), size(&of));
        whole += size(&leaf.cell);
        if i % 4 > 0 {
            continue;
        }
        let point: Vec<Q> = leaf.cell.sides().map(|side| at_random(&mut random, side)).collect();
        let [c, k] = Parts.at(&point).unwrap();
        let Some((words, gamma)) = at(&c, &k) else { continue };
        assert!(leaf.gamma.is_none_or(|sign| sign == gamma));
        for (positive, word) in [true, false].into_iter().zip(&words) {
            let known = leaf.word(positive);
            assert!(word.letters().starts_with(&known.letters()), "{point:?} {leaf:?}");
            assert!(!known.is_whole() || word.letters() == known.letters(), "{point:?} {leaf:?}");
            let Some(holds) = leaf.holds(Statement::ChaosAt { positive }) else { continue };
            let chaos = matches!(Entropy::of(word, gamma, 64).unwrap().0, Entropy::Positive { .. });
            assert_eq!(holds, chaos, "{point:?} {leaf:?}");
            told[usize::from(chaos)] += 1;
        }
    }
    assert_eq!(whole, sides.iter().fold(q("1"), |size, [lo, hi]| size * (hi - lo)));
    assert!(told.iter().all(|count| *count > 50), "{told:?}");
    let share = partition.share(Statement::ChaosAt { positive: true });
    assert!(share.spread() == Spread::Differs && &share.upper - &share.lower < q("0.15"), "{share:?}");
    // A point has all three.
    assert_eq!(share.with.unwrap().len(), 3);
    let bad = [sides[0].clone(), sides[1].clone(), [q("1"), q("0")]];
    assert!(ParameterBox::oscillator(Arc::new(Parts), &bad).unwrap_err().is_input());
    let negative = [sides[0].clone(), sides[1].clone(), [q("-1"), q("1")]];
    let why = ParameterBox::oscillator(Arc::new(Parts), &negative).unwrap_err().to_string();
    assert!(why.contains("the damping is -"), "{why}");
}

/// The machine of docs/measured.md by its own parameters: the same shares as of frequency and damping ratio.
#[test]
fn a_scene_has_the_shares_of_the_same_machines_elsewhere() {
    let (report, shown, _) = report_of(&MACHINES[2]);
    let half = |value: &str, by: &str| [q(value) - q(by), q(value) + q(by)];
    let of = ParameterBox::machine(half("1.23", "0.0123"), half("0.02", "0.004")).unwrap();
    let share = Partition::new(&of, 2000, &()).unwrap().share(Statement::ChaosAt { positive: true });
    let [least, most] = report.sides[0].share.each_ref().map(|end| q(end));
    assert!(share.lower <= most && least <= share.upper, "{:?}", report.sides);
    let far = q("0.01");
    assert!(&most - &least < far && &share.upper - &share.lower < far);
    assert_eq!((report.sides[0].chaos, report.sides[1].chaos), ("differs", "everywhere"));
    assert_eq!(of.word(true, 100, &()).unwrap().letters(), report.sides[0].word);
    assert_eq!(
        Partition::new(&of, 2000, &()).unwrap().share(Statement::ChaosAt { positive: false }).spread(),
        Spread::Everywhere
    );
    for line in ["0.016 <= z <= 0.024, 1.2177 <= w <= 1.2423", "beyond the touch born in all of them"] {
        assert!(shown.split_whitespace().collect::<Vec<_>>().join(" ").contains(line), "{line}\n{shown}");
    }
}

/// Of a box that is one machine the words are those of the task itself.
#[test]
fn without_width_it_is_the_machine_itself() {
    let (report, _, code) = found(&text("c = 0.1\nk = 0.3", "c", "k", "tolerance = { c = 0, F = \"10%\" }"));
    let tolerance = report.tolerance.unwrap();
    let moves: Vec<(&str, bool)> =
        tolerance.parameters.iter().map(|one| (one.name.as_str(), one.moves)).collect();
    assert_eq!((code, moves), (0, vec![("F", false), ("c", true)]));
    let [before, beyond] = report.chaos.as_ref().unwrap().as_slice() else { panic!("two sides") };
    for (row, side) in [before, beyond].into_iter().zip(&tolerance.sides) {
        assert_eq!((row.sign_emu, row.chaos), (side.sign_emu, Some(side.chaos == "everywhere")));
        assert_eq!((&row.periods, true), (&side.periods, side.whole));
    }
    assert_eq!((tolerance.settled.as_str(), &tolerance.open), ("1.000000", &None));
}

/// Where the task's own parameter moves damping and stiffness its tolerance is about the touch.
#[test]
fn the_tasks_own_parameter_has_its_tolerance_about_the_touch() {
    let of = |keys: &str| {
        text("k = 0.3", "0.1", "k", keys)
            .replace("F = 0.1", "F = 0.5")
            .replace("reach = 1000\n", "")
            .replace("parameter = \"F\"", "parameter = \"k\"")
    };
    let (report, shown, code) = found(&of("tolerance = { k = \"1%\" }"));
    assert_eq!(code, 0, "{shown}");
    let [lower, upper] = &bounds(&report.tolerance.unwrap())[0];
    let middle = num_traits::ToPrimitive::to_f64(&((lower + upper) / q("2"))).unwrap();
    assert!((middle - report.at.parameter).abs() < 1e-10 && (middle - 0.3).abs() > 0.1, "{middle} {shown}");
    for (keys, why) in [
        ("tolerance = { F = \"1%\" }", "damping or stiffness change with k, the task's own parameter"),
        ("tolerance = { k = [0.29, 0.31] }", "the touch is not at a value of k within its tolerance"),
    ] {
        let (report, _, code) = found(&of(keys));
        let said = report.tolerance_open.unwrap();
        assert!(code == 3 && report.tolerance.is_none() && said.contains(why), "{said}");
    }
}

#[test]
fn why_nothing_is_said_of_tolerances_is_said() {
    let all = "c = 0.1\nk = 0.3\nm = 1";
    let usual = text(all, "c/m", "k/m", "tolerance = { c = \"1%\", k = \"1%\" }");
    let both =
        usual.replace("[[tasks]]", "[[stops]]\nside = \"lower\"\noffset = -3\nrestitution = 0.8\n[[tasks]]");
    let cubic = usual.replace("forcing =", "cubic = 0.01\nforcing =");
    let root = usual.replace("\"k/m\"", "\"sqrt(k^2)/m\"");
    let falling = usual.replace("\"c/m\"", "\"(c - 0.1)/m\"");
    let soft = usual.replace("restitution = 0.8", "stiffness = 50");
    // The paper's orbit of period 4, which touches with its impact.
    let pattern = format!(
        "{}[[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \"mu\"\norbit = {{ pattern = [4] }}\n\
         reach = 3\nmax_period = 1\nseen = false\ntolerance = {{ d = \"1%\" }}\n",
        crate::proved_ranges::nordmark()
    );
    for (text, why) in [
        (&both, "machines with one stop; there are two"),
        (&cubic, "linear machines"),
        (&root, "sqrt(…) is irrational"),
        (&falling, "the damping is -"),
        (&soft, "the local theory does not apply"),
        (&pattern, "another orbit does"),
    ] {
        let scene = Scene::from_toml(text, "t.toml").unwrap_or_else(|error| panic!("{error}"));
        let report = run(&scene, Surroundings::default(), &mut ()).unwrap().remove(0);
        assert_eq!(report.status.outcome().code(), 3, "{report}");
        let Some(Findings::Grazing(found)) = report.findings else { panic!("{report}") };
        let GrazingFindings::Found(found) = *found else { panic!("{text}: {found:?}") };
        let said = found.tolerance_open.unwrap();
        assert!(said.contains(why), "{said}");
    }
    // Without tolerances nothing is said.
    let (found, _, code) = found(&text(all, "c/m", "k/m", ""));
    assert_eq!((found.tolerance, found.tolerance_open, code), (None, None, 0));
}

#[test]
fn tolerances_that_say_nothing_are_refused_where_they_stand() {
    let error = |keys: &str| {
        let text = text("c = 0.1\nk = 0.3\nz = 0", "c", "k", keys);
        Scene::from_toml(&text, "t.toml").unwrap_err().to_string()
    };
    for (keys, why) in [
        ("tolerance = { kk = \"1%\" }", "t.toml:23: tasks[1].tolerance: unknown key \"kk\""),
        ("tolerance = { c = \"x%\" }", "tasks[1].tolerance.c = \"x%\""),
        ("tolerance = { c = \"-1%\" }", "is below 0"),
        ("tolerance = { c = -0.1 }", "is below 0"),
        ("tolerance = { c = [0.2, 0.1] }", "the least value comes first"),
        ("tolerance = { c = [0.1] }", "write \"2%\" of its value"),
        ("tolerance = { c = [0.2, 0.3] }", "does not hold the parameter's value, 1/10"),
        ("tolerance = { z = \"1%\" }", "is a part of 0"),
        ("tolerance = 3", "is not a table"),
    ] {
        let said = error(keys);
        assert!(said.contains(why), "{keys}: {said}");
    }
    assert!(
        error("tolerance = { kk = \"1%\" }").contains("F, c, k, z"),
        "{}",
        error("tolerance = { kk = \"1%\" }")
    );
}

/// Numbers of many digits are exact in JSON and short in words: inwards those of the box, of which all is
/// told, outwards those of a cell.
#[test]
fn long_and_tiny_numbers_are_short_in_words() {
    let (narrow, shown, _) =
        found(&text("c = 0.1\nk = 0.3", "c", "k", "tolerance = { k = \"1e-200%\", c = \"20%\" }"));
    let parameters = narrow.tolerance.unwrap().parameters;
    assert!(parameters[1].lower.len() > 200 && q(&parameters[1].lower) < q("0.3"), "{parameters:?}");
    assert!(shown.contains("0.3 <= k <= 0.3,"), "{shown}");
    // The same machines, their parameters counted in units of 10^-30.
    let keys = "tolerance = { k = \"2%\", c = \"20%\" }";
    let (tiny, shown, _) = found(&text("c = 0.1e-30\nk = 0.3e-30", "10^30*c", "10^30*k", keys));
    let (own, own_shown, _) = found(&text("c = 0.1\nk = 0.3", "c", "k", keys));
    let [tiny, own] = [tiny, own].map(|report| report.tolerance.unwrap());
    assert_eq!(tiny.sides.map(|side| (side.word, side.share)), own.sides.map(|side| (side.word, side.share)));
    let ends = |open: &str| -> Vec<Q> {
        let place = open.split(" at ").nth(1).unwrap();
        place.split(", ").flat_map(|one| one.split(" <= ").step_by(2).map(q).collect::<Vec<_>>()).collect()
    };
    let [there, here] = [tiny.open.unwrap(), own.open.unwrap()].map(|open| ends(&open));
    assert_eq!(there.len(), 4, "{shown}");
    for (there, here) in there.iter().zip(&here) {
        let scaled = there * q("1e30");
        assert!((&scaled - here).abs() < q("1e-12"), "{shown} {own_shown}");
    }
}

/// What docs/measured.md says of the scene of docs/my-machine.md.
#[test]
fn the_page_has_the_shares_of_its_scene() {
    let page = include_str!("../../../docs/measured.md").split_whitespace().collect::<Vec<_>>().join(" ");
    let scene = include_str!("../../../docs/my-machine.md");
    let scene = scene.split("```toml\n").nth(1).unwrap().split("```").next().unwrap();
    let scene = scene
        .replace("damping = \"1/10\"", "damping = \"d\"")
        .replace("stiffness = \"3/10\"", "stiffness = \"s\"");
    let scene = scene.replace("[parameters]", "[parameters]\ns = 0.3\nd = 0.1").replacen(
        "parameter = \"F\"",
        "parameter = \"F\"\nseen = false\nTOLERANCE",
        1,
    );
    let of = |tolerance: &str| found(&scene.replace("TOLERANCE", tolerance));
    let asked = "tolerance = { s = \"2%\", d = 0.02 }";
    assert!(page.contains(asked));
    let chaos = |(report, shown, code): (GrazingReport, String, u8)| {
        let sides = report.tolerance.unwrap().sides.map(|side| side.chaos);
        (sides, code, shown.split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let (sides, code, _) = chaos(of(asked));
    assert_eq!((sides, code), (["everywhere", "nowhere"], 0));
    let (sides, code, shown) = chaos(of("tolerance = { s = \"20%\", d = 0.05 }"));
    assert_eq!((sides, code), (["differs", "open"], 3));
    assert!(
        shown.contains("in 89.27 % to 89.97 %")
            && page.contains("with 20 % and 0.05 before it in 89.27 % to 89.97 %"),
        "{shown}"
    );
}

/// A box across s = 1/6 says of which machines the orbit of one impact in 3 periods is born beyond the touch,
/// with machines on both sides, of which Theorem 1 says so; and what is born on the line, as its own task
/// does. For γ < 0 none is on either side.
#[test]
fn a_box_across_a_resonance_says_what_holds_on_both_sides_and_on_it() {
    let of = |k: &str, keys: &str| {
        let (report, shown, _) = found(
            &text(&format!("k = \"{k}\""), "1/4", "k", keys).replace("max_period = 1\n", "max_period = 3\n"),
        );
        (report, shown)
    };
    let born = |k: &str| {
        let (report, shown) = of(k, "");
        let row = report.born.iter().find(|row| row.pattern == "3");
        row.map(|row| (row.side.contains(" > "), row.stable, shown))
    };
    let (resonant, negative) = ("25/576", "409/576");
    let (report, shown) = of(resonant, "tolerance = { k = \"1%\" }");
    let told = report.tolerance.unwrap();
    let [row] = &told.resonances[..] else { panic!("{shown}") };
    let [below, above] = [&row.below, &row.above].map(|point| point.as_ref().unwrap()[0].value.clone());
    assert!(row.period == 3 && q(&below) < q(resonant) && q(&above) > q(resonant), "{row:?}");
    let [least, most] = row.share.each_ref().map(|end| q(end));
    assert!(least <= q("1/2") && q("1/2") <= most && most - least < q("1/50"), "{row:?}");
    for part in [
        " for 4",
        "so at k = ",
        "u_n = 0 at s = 1/(2n), n = 3: s < 1/6 for ",
        "stable, both multipliers tau r^n",
    ] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    // Beyond the touch the drive is larger.
    for (k, beyond) in [(below.as_str(), true), (resonant, true), (above.as_str(), false)] {
        let (larger, stable, shown) = born(k).unwrap();
        assert!(larger == beyond && (stable == Some(Judgement::Yes)) == (k == resonant), "{k}: {shown}");
    }
    let (report, shown) = of(negative, "tolerance = { k = \"1%\" }");
    let told = report.tolerance.unwrap();
    assert!(told.sign_gamma == Some(-1) && told.resonances.iter().any(|row| row.period == 3), "{shown}");
    assert!(
        shown.contains("of one impact in n periods no orbit is born, where s = 1/(2n) or next to it"),
        "{shown}"
    );
    for k in [negative, "41/58", "71/100"] {
        assert!(born(k).is_none(), "{k}");
    }
    let (report, _) = of("1/20", "tolerance = { k = \"1%\" }");
    assert_eq!(report.tolerance.unwrap().resonances, []);
}
