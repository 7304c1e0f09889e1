//! Certificates of events: what is written passes and says what is known, what is damaged is rejected unless
//! it is still true.

use crate::common;
use crate::samples::{samples, tried};
use crate::systems;

use common::damage::{damage, damaged};
use std::f64::consts::PI;

use grazing_scenes::{
    Result,
    certificate::{self, Rejection},
    motion::{Harmonic, Side, System, Wall},
    number::{Ball, Elementary, Precision, Real, Sign},
    run::{Findings, Status, Surroundings, run},
    scene::{Expression, Scene},
    search::orbit::{self, Condition, ExpectedImpact, Jet, ProvedEvent, Quotient, Verdict},
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use proptest::strategy::{Strategy, ValueTree};
use systems::{example, lower, number, proved};

/// A ball on a table that moves as p sin t, thrown back with restitution r = 3/5.
fn table<T: Real>(p: &T, context: &T::Context) -> System<T> {
    let ratio = |text: &str| T::ratio(&number(text), context);
    let motion = Harmonic { k: 1, cos: ratio("0"), sin: p.clone() };
    System {
        rate: None,
        damping: ratio("0"),
        stiffness: ratio("0"),
        cubic: ratio("0"),
        force: ratio("-1"),
        smooth: None,
        forcing: Vec::new(),
        lower: Some(Wall { offset: ratio("0"), harmonics: vec![motion], restitution: ratio("3/5") }),
        upper: None,
    }
}

/// Shaw and Holmes' oscillator, forced at the frequency p: damping 1/(10 p), stiffness 1/p².
fn one_sided<T: Real>(p: &T, context: &T::Context) -> System<T> {
    let ratio = |text: &str| T::ratio(&number(text), context);
    System {
        rate: None,
        damping: ratio("1/10") / p,
        stiffness: ratio("1") / &(p.clone() * p),
        cubic: ratio("0"),
        force: ratio("0"),
        smooth: None,
        forcing: vec![Harmonic { k: 1, cos: ratio("1"), sin: ratio("0") }],
        lower: None,
        upper: Some(Wall { offset: ratio("1/2"), harmonics: Vec::new(), restitution: ratio("4/5") }),
    }
}

/// A family of systems, over any numbers.
#[derive(Clone, Copy)]
enum Family {
    Example,
    Table,
    OneSided,
}

impl Family {
    fn at<T: Real>(self, p: &T, context: &T::Context) -> System<T> {
        match self {
            Family::Example => example(p, context),
            Family::Table => table(p, context),
            Family::OneSided => one_sided(p, context),
        }
    }
}

struct Case {
    family: Family,
    impacts: Vec<ExpectedImpact>,
    /// About where.
    parameter: f64,
    condition: Condition,
    /// Digits of the parameter, known otherwise: by mpmath (tests/data/make_oscillator.py), or in closed
    /// form.
    known: &'static str,
}

fn cases() -> Vec<Case> {
    let upper =
        |periods, phase, velocity| ExpectedImpact { side: Side::Upper, ..lower(periods, phase, velocity) };
    let grazing = |after, side, time| Condition::Grazing { after, side, time };
    let case = |family, impacts: &[ExpectedImpact], parameter, condition, known| Case {
        family,
        impacts: impacts.to_vec(),
        parameter,
        condition,
        known,
    };
    use Condition::{Flip, SaddleNode};
    use Family::{Example, OneSided, Table};
    let double = [lower(3, 0.0089, 0.014), lower(3, -0.113, 0.114)];
    vec![
        case(
            Example,
            &[lower(4, -0.41, 0.365)],
            -0.0843,
            SaddleNode,
            "-0.08433847008958920390351447963056555442772",
        ),
        case(
            Example,
            &[lower(3, -0.051, 0.063)],
            0.0055,
            Flip,
            "0.005479046221248913834406155326246098121885",
        ),
        case(
            Example,
            &double,
            0.0061,
            grazing(0, Side::Lower, 12.56),
            "0.006099928671612927934295875505827083198179",
        ),
        case(
            Example,
            &[lower(4, -0.76, 0.67)],
            -0.0244,
            grazing(0, Side::Lower, 19.7),
            "-0.02444745630583192992178081065456275254876",
        ),
        // π(1 − r)/(1 + r) = π/4, and √(π²/16 + (2(1 + r²)/(1 + r)²)²).
        case(Table, &[lower(1, 0.0, 3.93)], 0.79, SaddleNode, "0.7853981633974483096156608458198757210493"),
        case(Table, &[lower(1, 0.93, 3.93)], 1.32, Flip, "1.3212707992944084260"),
        case(OneSided, &[upper(1, 2.98, 0.94)], 2.5, Flip, "2.4953491531223987956"),
        case(OneSided, &[upper(2, 2.995, 0.819)], 4.46, Flip, "4.4628247476097578103"),
        case(
            OneSided,
            &[upper(1, -0.484, 1.88)],
            0.703,
            grazing(0, Side::Upper, 2.817),
            "0.70273288572098418507",
        ),
        case(
            OneSided,
            &[upper(2, 0.173, 0.789)],
            2.761,
            grazing(0, Side::Upper, 10.05),
            "2.7613528913660799842",
        ),
    ]
}

impl Case {
    fn prove(&self, precision: &Precision) -> ProvedEvent {
        let family = |p: &Jet| -> Result<System<Jet>> { Ok(self.family.at(p, precision)) };
        proved(orbit::event(family, &self.impacts, self.parameter, self.condition, precision).unwrap())
    }

    fn written(&self) -> (String, [String; 2]) {
        let system = self.family.at(&Quotient::parameter(), &());
        written(&system, "p", &self.prove(&Precision::new(128)))
    }

    /// The same with a force of 10⁻⁴⁰(1 + p), which version 1 cannot hold.
    fn written_long(&self) -> (String, [String; 2]) {
        let mut system = self.family.at(&Quotient::parameter(), &());
        system.force = system.force + &quotient("1e-40*(1 + p)").unwrap();
        written(&system, "p", &self.prove(&Precision::new(128)))
    }
}

/// A certificate, and the ends of the parameter that it proves.
fn written(system: &System<Quotient>, name: &str, event: &ProvedEvent) -> (String, [String; 2]) {
    let (found, ends) = orbit::event_certificate(system, name, event).unwrap();
    (found.accepted.text().to_string(), ends)
}

fn check(text: &str) -> std::result::Result<certificate::Checked, Rejection> {
    certificate::check(&mut text.as_bytes())
}

/// The known digits are right to one unit of the last: so the interval is in reach of them, and narrower than
/// 10⁻²⁰.
#[test]
fn what_is_written_passes_and_holds_the_known_value() {
    for case in cases() {
        let (text, [from, to]) = case.written();
        let checked = check(&text).unwrap();
        let periods = u64::from(case.impacts.iter().map(|impact| impact.periods).sum::<u32>());
        assert_eq!((checked.kind, checked.range), ("event", Some(periods..=periods)));
        assert_eq!(checked.detail[1], ("parameter", format!("p, from {from} to {to}")));
        let places = case.known.split_once('.').unwrap().1.len();
        let unit = number(&format!("1e-{places}"));
        let (from, to) = (number(&from), number(&to));
        assert!(from <= number(case.known) + &unit && number(case.known) - unit <= to, "{}", case.known);
        assert!(to - from < number("1e-20"), "{}", case.known);
    }
}

/// Version 2, for each kind of event: a force of 10⁻⁴⁰(1 + p) needs more digits than version 1 has.
#[test]
fn long_coefficients_are_held_in_intervals() {
    for index in [0, 1, 2, 5, 9] {
        let case = &cases()[index];
        let (text, ends) = case.written_long();
        assert!(text.starts_with("grazing-certificate 1\nkind event 2\n"));
        let checked = check(&text).unwrap();
        assert_eq!((checked.kind, checked.statement), ("event", certificate::event::STATEMENT_2));
        let [from, to] = ends.map(|end| number(&end));
        assert!(from <= number(case.known) + number("1e-19") && number(case.known) - number("1e-19") <= to);
        let force = text.lines().find(|line| line.starts_with("force ")).unwrap();
        assert!(force.contains("..") && force.contains(','), "{force}");
        assert!(checked.detail.iter().any(|(name, value)| *name == "motion" && value.contains("] p")));
    }
}

/// Without impacts: undamped with k = 1/4, q = −(4p/3) cos t answers to p cos t. It grazes a wall at −1 where
/// p = 3/4, and at −1 + (1/5)(1 + p²) sin t, which moves it, where 16p²/9 + (1 + p²)²/25 = 1.
#[test]
fn the_motion_without_impacts_grazes_where_its_formula_says() {
    let still = |p: &Jet, precision: &Precision| free(p, precision, false);
    let moving = |p: &Jet, precision: &Precision| free(p, precision, true);
    let square = (-(16.0 / 9.0 + 0.08) + ((16.0f64 / 9.0 + 0.08).powi(2) + 4.0 * 0.04 * 0.96).sqrt()) / 0.08;
    for (moves, known) in [(false, 0.75), (true, square.sqrt())] {
        let precision = Precision::new(128);
        let family = |p: &Jet| -> Result<System<Jet>> {
            Ok(if moves { moving(p, &precision) } else { still(p, &precision) })
        };
        // q − Q = −(4p/3) cos t − a sin t + 1 is least at the phase with tangent 3a/(4p).
        let a = if moves { (1.0 + known * known) / 5.0 } else { 0.0 };
        let phase = a.atan2(4.0 * known / 3.0);
        let condition = Condition::Grazing { after: 0, side: Side::Lower, time: phase + 0.01 };
        let event = proved(orbit::event(family, &[], known + 0.003, condition, &precision).unwrap());
        let system = free(&Quotient::parameter(), &(), moves);
        let (text, [from, to]) = written(&system, "p", &event);
        let (from, to) = (number(&from), number(&to));
        let within = |x: f64| from.to_f64().unwrap() - 1e-14 <= x && x <= to.to_f64().unwrap() + 1e-14;
        assert!(within(known) && &to - &from < number("1e-17"), "{from} {to}");
        if !moves {
            assert!(from <= number("3/4") && number("3/4") <= to);
        }
        let checked = check(&text).unwrap();
        assert_eq!(
            (checked.kind, checked.range, checked.statement),
            ("event", Some(1..=1), certificate::event::STATEMENT_2)
        );
        let detail = |name: &str| checked.detail.iter().find(|(known, _)| *known == name).unwrap().1.clone();
        assert_eq!(detail("pattern"), "no impact, period 1");
        assert!(detail("contact").starts_with("with the lower wall, at phase "));
        // Another wall that is crossed on the way; a version that knows no such orbit; a contact where there
        // is none.
        let (at, end) = (text.find("upper none").unwrap(), text.find("\nparameter").unwrap() + 1);
        let crossed = format!("{}upper 0.5..0.5/1..1 1..1/1..1 0\n{}", &text[..at], &text[end..]);
        assert!(
            refusal(&resealed(&crossed)).contains("is not certainly positive"),
            "{}",
            refusal(&resealed(&crossed))
        );
        assert!(refusal(&text.replace("kind event 2", "kind event")).contains("malformed"));
        assert!(refusal(&text.replace("event grazing 0", "event flip 0")).contains("must not sum to 0"));
        assert!(
            refusal(&text.replace("contact 0", "contact 1"))
                .contains("expected an impact, a number from 0 to 0")
        );
        let contact = text.lines().find(|line| line.starts_with("contact")).unwrap();
        let moved = text.replace(contact, "contact 0 lower 1");
        assert!(refusal(&moved).contains("false: Krawczyk's test"), "{}", refusal(&moved));
    }
    // With stiffness 4, undamped, cos 2t and sin 2t have the period 2π, too; and without any, every constant.
    for stiffness in ["4", "0"] {
        let precision = Precision::new(128);
        let family = |p: &Jet| -> Result<System<Jet>> {
            let system = free(p, &precision, false);
            Ok(System { stiffness: Jet::ratio(&number(stiffness), &precision), ..system })
        };
        let (amplitude, phase) = if stiffness == "4" { (3.0, PI) } else { (1.0, 0.0) };
        let condition = Condition::Grazing { after: 0, side: Side::Lower, time: phase };
        match orbit::event(family, &[], amplitude, condition, &precision) {
            Ok(Verdict::Undecided(why)) => assert!(why.contains("1 may be a multiplier"), "{why}"),
            Err(error) => assert!(error.to_string().contains("only with stiffness"), "{error}"),
            Ok(other) => panic!("{other:?}"),
        }
    }
}

/// The undamped oscillator of that test.
fn free<T: Real>(p: &T, context: &T::Context, moves: bool) -> System<T> {
    let ratio = |text: &str| T::ratio(&number(text), context);
    let motion = if moves {
        let square = (ratio("1") + &(p.clone() * p)) * &ratio("1/5");
        vec![Harmonic { k: 1, cos: ratio("0"), sin: square }]
    } else {
        Vec::new()
    };
    System {
        rate: None,
        damping: ratio("0"),
        stiffness: ratio("1/4"),
        cubic: ratio("0"),
        force: ratio("0"),
        smooth: None,
        // The response is p cos t/(1/4 − 1).
        forcing: vec![Harmonic { k: 1, cos: p.clone(), sin: ratio("0") }],
        lower: Some(Wall { offset: ratio("-1"), harmonics: motion, restitution: ratio("4/5") }),
        upper: None,
    }
}

fn refusal(text: &str) -> String {
    check(text).map_or_else(|rejection| rejection.to_string(), |checked| format!("accepted: {checked}"))
}

/// The text with the digest of its system.
fn resealed(text: &str) -> String {
    let why = refusal(text);
    let Some((_, digest)) = why.split_once("which is ") else { return text.to_string() };
    let old = text.lines().find(|line| line.starts_with("digest ")).unwrap();
    text.replace(old, &format!("digest {digest}"))
}

/// π/4 and the root, in balls by their formulas.
#[test]
fn events_of_the_ball_have_closed_forms() {
    let precision = Precision::new(200);
    let ratio = |text: &str| Ball::ratio(&number(text), &precision);
    let node = Ball::pi(&precision) * &ratio("1/4");
    let depth = ratio("17/16");
    let flip = (node.clone() * &node + &(depth.clone() * &depth)).sqrt();
    for (case, value) in cases()[4..6].iter().zip([node, flip]) {
        let (_, [from, to]) = case.written();
        let (lo, hi) = value.exact_bounds().unwrap();
        assert!(number(&from) <= lo && hi <= number(&to), "{}", case.known);
    }
}

/// Whether what an accepted certificate says is true, by the proof in balls; of the ball on a table by closed
/// formulas too. The digest holds the system, but the event, the pattern and the box may have changed.
fn is_true(text: &str, case: &Case, event: &ProvedEvent, original: &str) -> bool {
    let words = |text: &str, start: &str| -> Vec<Vec<String>> {
        let lines = text.lines().filter(|line| line.starts_with(start));
        lines.map(|line| line.split(' ').map(String::from).collect()).collect()
    };
    let parts = |text: &str| {
        let system: Vec<String> =
            text.lines().take_while(|line| !line.starts_with("parameter")).map(String::from).collect();
        let pattern: Vec<_> =
            words(text, "impact").into_iter().map(|w| (w[1].clone(), w[2].clone())).collect();
        let contact: Vec<_> =
            words(text, "contact").into_iter().map(|w| (w[1].clone(), w[2].clone())).collect();
        (system, words(text, "event "), pattern, contact)
    };
    // Every event and pattern but its own is another statement, which this test does not know to be true.
    if parts(text) != parts(original) {
        return false;
    }
    let impacts = words(text, "impact");
    let centre: Vec<BigRational> = (impacts.iter().map(|w| number(&w[3])))
        .chain(impacts.iter().map(|w| number(&w[4])))
        .chain(words(text, "parameter").iter().map(|w| number(&w[2])))
        .chain(words(text, "contact").iter().map(|w| number(&w[3])))
        .collect();
    let [radius, within] = [1, 2].map(|i| number(&words(text, "radius")[0][i]));
    let all = event.phases.iter().chain(&event.velocities).chain([&event.parameter]).chain(&event.time);
    let contains = all.zip(&centre).all(|(x, c)| {
        let (lo, hi) = x.exact_bounds().unwrap();
        c - &within <= lo && hi <= c + &within
    });
    let inside = event.centre.iter().zip(&centre).all(|(a, b)| (a - b).abs() + &radius <= event.radius);
    let float = |x: &BigRational| x.to_f64().unwrap();
    let precision = Precision::new(128);
    let family = |p: &Jet| -> Result<System<Jet>> { Ok(case.family.at(p, &precision)) };
    let guess = |at: &[f64]| {
        let mut guess = case.impacts.clone();
        let m = guess.len();
        for (i, impact) in guess.iter_mut().enumerate() {
            (impact.phase, impact.velocity) = (at[i], at[m + i]);
        }
        let condition = match case.condition {
            Condition::Grazing { after, side, .. } => Condition::Grazing { after, side, time: at[2 * m + 1] },
            other => other,
        };
        (guess, at[2 * m], condition)
    };
    let middle: Vec<f64> = centre.iter().map(float).collect();
    let again = || {
        let (guess, parameter, condition) = guess(&middle);
        let wider = &radius + number("1e-12");
        let verdict = orbit::event_in(family, &guess, parameter, condition, &wider, &precision).unwrap();
        matches!(verdict, Verdict::Proved(_))
    };
    // A box that another checker's enclosures are too wide for: Newton's method from its corners finds no
    // other event in it.
    let alone = || {
        (0..1 << middle.len()).all(|corner: u32| {
            let at = middle.iter().enumerate();
            let side = |i: usize| if corner >> i & 1 == 0 { -0.9 } else { 0.9 };
            let at: Vec<f64> = at.map(|(i, x)| x + side(i) * float(&radius)).collect();
            let (guess, parameter, condition) = guess(&at);
            let Ok(Verdict::Proved(found)) = orbit::event(family, &guess, parameter, condition, &precision)
            else {
                return true;
            };
            let places = found.phases.iter().chain(&found.velocities).chain([&found.parameter]);
            let places: Vec<f64> =
                places.chain(&found.time).map(|x| float(&x.exact_bounds().unwrap().0)).collect();
            let known: Vec<f64> = event.centre.iter().map(float).collect();
            let apart =
                |other: &[f64]| places.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            apart(&middle) > float(&radius) || apart(&known) < 1e-9
        })
    };
    // a cos t = π/4 and V = 2π/(1 + r); a saddle-node has sin t = 0, a flip a sin t = 17/16.
    let only = match case.family {
        Family::Table => {
            let node = std::f64::consts::FRAC_PI_4;
            let depth = if case.condition == Condition::Flip { 17.0 / 16.0 } else { 0.0f64 };
            let near = |t: f64, a: f64| {
                let point = [t, 5.0 * node, a];
                point.iter().zip(&centre).all(|(x, c)| (x - float(c)).abs() <= float(&radius) + 1e-12)
            };
            let half_turns = -20..20;
            let solutions = half_turns.filter(|&turns| {
                let (t, a) = (depth.atan2(node), node.hypot(depth));
                let odd = turns % 2 != 0;
                near(t + std::f64::consts::PI * f64::from(turns), if odd { -a } else { a })
            });
            solutions.count() == 1
        }
        Family::Example | Family::OneSided => true,
    };
    contains && only && (inside || again() || alone())
}

/// Whether what an accepted certificate of the motion without impacts says is true: of the still wall, 1 −
/// (4p/3) cos t grazes 0 where cos t = ±1 and p = ±3/4.
fn is_true_without_impacts(text: &str, original: &str) -> bool {
    let words = |text: &str, start: &str| -> Vec<String> {
        let line = text.lines().find(|line| line.starts_with(start)).unwrap();
        line.split(' ').map(String::from).collect()
    };
    let system = |text: &str| -> Vec<String> {
        text.lines().take_while(|line| !line.starts_with("parameter")).map(String::from).collect()
    };
    let float = |word: &String| number(word).to_f64().unwrap();
    let (contact, radius) = (words(text, "contact"), words(text, "radius"));
    let [p, t] = [float(&words(text, "parameter")[2]), float(&contact[3])];
    let near = |half: f64| {
        let touches = |k: &i32| {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            (p - 0.75 * sign).abs() <= half && (t - PI * f64::from(*k)).abs() <= half
        };
        (-50..=50).filter(touches).count()
    };
    // Doubles know the distance from 3/4 and kπ to 1e-14.
    system(text) == system(original)
        && words(text, "event ") == words(original, "event ")
        && contact[1..3] == ["0", "lower"]
        && near(float(&radius[1]) - 1e-13) <= 1
        && near(float(&radius[2]) + 1e-13) == 1
}

/// Thousands of damaged certificates; those that pass are confirmed true.
#[test]
fn damage_is_detected() {
    let mut runner = common::runner(1);
    let strategy = damage();
    let mut survive = |text: &str, rounds: usize, is_true: &dyn Fn(&str) -> bool| {
        assert!(is_true(text));
        let body = text.lines().position(|line| line.starts_with("parameter")).unwrap();
        let (mut rejected, mut unchanged, mut still_true) = (0, 0, 0);
        for round in 0..samples::<u64>(rounds as u64) {
            let damage = strategy.new_tree(&mut runner).unwrap().current();
            // Half of the time past the header, which the digest and the statement guard.
            let changed = damaged(text, if round % 2 == 0 { 0 } else { body }, &damage);
            if changed == text {
                unchanged += 1;
            } else if check(&changed).is_ok() {
                assert!(is_true(&changed), "accepted though false, after {damage:?}:\n{changed}");
                still_true += 1;
            } else {
                rejected += 1;
            }
        }
        println!("{rejected} rejected, {still_true} still true, {unchanged} unchanged");
        assert!(rejected > 4 * still_true && tried(still_true, 3));
    };
    // A saddle-node, a flip, a grazing of a double-impact orbit, a flip of the ball, a grazing with powers of
    // the parameter; of version 2 the first and the third, with a force of 10⁻⁴⁰(1 + p), which moves nothing
    // that is told apart here.
    let all = [(1, 0), (1, 1), (1, 2), (1, 5), (1, 9), (2, 0), (2, 2)];
    for (version, index) in all {
        let case = &cases()[index];
        let event = case.prove(&Precision::new(256));
        let text = if version == 1 { case.written().0 } else { case.written_long().0 };
        assert!(text.lines().nth(1) == Some(if version == 1 { "kind event" } else { "kind event 2" }));
        survive(&text, 250, &|changed| is_true(changed, case, &event, &text));
    }
    let precision = Precision::new(128);
    let family = |p: &Jet| -> Result<System<Jet>> { Ok(free(p, &precision, false)) };
    let condition = Condition::Grazing { after: 0, side: Side::Lower, time: 0.01 };
    let event = proved(orbit::event(family, &[], 0.753, condition, &precision).unwrap());
    let system = free(&Quotient::parameter(), &(), false);
    let (text, _) = written(&system, "p", &event);
    survive(&text, 250, &|changed| is_true_without_impacts(changed, &text));
}

/// A scene whose motion without impacts grazes: run as a user would, what is proved holds 3/4, and the file
/// passes.
#[test]
fn a_scene_proves_the_grazing_of_its_motion_without_impacts() {
    let text = r#"
        format = "grazing-scene 1"
        title = "a response"
        [parameters]
        p = 0.7
        [system]
        stiffness = "1/4"
        forcing = [{ k = 1, cos = "p" }]
        [[walls]]
        side = "lower"
        offset = -1
        restitution = "4/5"
        [[tasks]]
        name = "proof"
        kind = "validate"
        event = "grazing"
        parameter = "p"
        orbit = { pattern = [] }
        reach = 0.2
    "#;
    let scene = Scene::from_toml(text, "response.toml").unwrap();
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    assert_eq!(reports[0].status, Status::Done, "{:?}", reports[0].findings);
    let Some(Findings::Validate(found)) = &reports[0].findings else { panic!() };
    assert_eq!((found.proofs.len(), found.certificates.len()), (1, 1));
    let row = &found.proofs[0];
    let [from, to] = [&row.lower, &row.upper].map(|end| number(end.as_ref().unwrap()));
    assert_eq!((row.proved.verdict, row.proved.pattern.as_deref()), ("proved", Some("free 1")));
    assert!(from <= number("3/4") && number("3/4") <= to && to - from < number("1e-17"));
    let checked = check(found.certificates[0].accepted.text()).unwrap();
    assert_eq!((checked.kind, checked.statement), ("event", certificate::event::STATEMENT_2));
}

/// An expression in p and d = 1/3 as a function of p.
fn quotient(text: &str) -> Result<Quotient> {
    let names = ["p".to_string(), "d".to_string()];
    let third = BigRational::new(1.into(), 3.into());
    let values = [Quotient::parameter(), Quotient::ratio(&third, &())];
    Expression::parse(text, &names)?.evaluate(&values, &())
}

#[test]
fn expressions_become_quotients_of_polynomials() {
    for (text, above, below) in [
        ("1 + p", vec![1, 1], vec![1]),
        ("2*d/p", vec![2], vec![0, 3]),
        ("1/p^2 - d", vec![3, 0, -1], vec![0, 0, 3]),
        ("d - 1/3", vec![0], vec![1]),
        ("p - p", vec![0], vec![1]),
        ("-1/(1 - p)", vec![1], vec![-1, 1]),
        ("(p + 1)*(p - 1)/2", vec![-1, 0, 1], vec![2]),
        ("0.5*p/p", vec![0, 1], vec![0, 2]),
        ("p^64", [vec![0; 64], vec![1]].concat(), vec![1]),
    ] {
        let value = quotient(text).unwrap();
        let small = |list: &Vec<BigInt>| list.iter().map(|x| x.try_into().unwrap()).collect::<Vec<i64>>();
        assert_eq!(
            value.polynomials().map(|both| both.each_ref().map(small)),
            Some([above, below]),
            "{text}"
        );
    }
    for text in ["p^65", "1/(p+1)^40 + 1/(p+2)^40", "p*1e4000 + 1e-4000"] {
        assert!(quotient(text).is_err() || quotient(text).unwrap().polynomials().is_none(), "{text}");
    }
    assert!(quotient("1/(p - p)").unwrap_err().to_string().contains("divides by zero"));
}

#[test]
fn signs_of_quotients_are_those_of_constants_only() {
    let sign = |text: &str| quotient(text).unwrap().sign();
    assert_eq!(sign("p - p"), Some(Sign::Zero));
    assert_eq!(sign("-d"), Some(Sign::Negative));
    assert_eq!(sign("2"), Some(Sign::Positive));
    assert_eq!(sign("p^2 + 1"), None);
    assert_eq!(sign("1/p"), None);
}

/// What the form cannot hold, or the checker cannot prove, is an error in words.
#[test]
fn what_cannot_be_certified_is_an_error() {
    let case = &cases()[0];
    let event = case.prove(&Precision::new(128));
    let refused = |change: &dyn Fn(&mut System<Quotient>)| {
        let mut system = case.family.at(&Quotient::parameter(), &());
        change(&mut system);
        let error = orbit::event_certificate(&system, "mu", &event).unwrap_err();
        assert!(error.is_input());
        error.to_string()
    };
    assert!(
        refused(&|system| system.force = quotient("1e31 + p*1e-40").unwrap())
            .contains("between -2^30 and 2^30")
    );
    assert!(refused(&|system| system.force = quotient("p^17").unwrap()).contains("expected a quotient"));
    assert!(
        refused(&|system| system.force = quotient("p^60*p^60").unwrap()).contains("too large an expression")
    );
    assert!(refused(&|system| system.damping = quotient("p").unwrap()).contains("Krawczyk's test"));
    // A name that the form cannot hold is replaced.
    let system = case.family.at(&Quotient::parameter(), &());
    let (text, _) = written(&system, "µ", &event);
    assert!(text.contains("\nparameter p -0.0843"));
}

/// What is not rational is between two numbers, closer than a certificate has digits, whatever is made of it.
#[test]
fn numbers_that_are_not_rational_are_between_two() {
    let (precision, third) = (Precision::new(512), BigRational::new(1.into(), 3.into()));
    let values = [BigRational::from_integer(2.into()), third].map(|x| Ball::ratio(&x, &precision));
    let names = ["p".to_string(), "d".to_string()];
    for text in [
        "pi",
        "1/pi",
        "-pi^2/7",
        "pi - pi",
        "(1 + d)/(2*pi)^2 - 1/pi",
        "sqrt(2)*sqrt(2)",
        "exp(-pi)*d",
        "1/(3 - pi)",
        "pi/pi",
        "sqrt(d)/pi - d/sqrt(2)",
    ] {
        let [lo, hi] = quotient(text).unwrap().constant().unwrap();
        let ball = Expression::parse(text, &names).unwrap().evaluate(&values, &precision).unwrap();
        let (from, to) = ball.exact_bounds().unwrap();
        assert!(lo <= from && to <= hi && hi - lo < number("1e-60"), "{text}");
    }
    assert_eq!(quotient("1/(pi - pi)").unwrap().constant(), None);
    assert_eq!(quotient("pi*p").unwrap().constant(), None);
    assert!(quotient("sqrt(p)").unwrap_err().to_string().contains("no quotient of polynomials"));
}
