//! Proved ranges in the report of a task `grazing`: what is proved of the parameter against what is known of
//! where motions end, and every reason for which there is none.

use grazing::{
    certificate,
    number::parse_rational,
    run::{Findings, GrazingFindings, GrazingReport, Surroundings, run},
    scene::Scene,
};
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// README's machine, F the amplitude of its drive, with other stops and keys of the task.
fn asked(stops: &str, keys: &str) -> (GrazingReport, u8) {
    let text = format!(
        "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 0.5\nd = 0.1\n[system]\ndamping = \"d\"\n\
         stiffness = 0.3\nforcing = [{{ cos = \"F\" }}]\n{stops}[[tasks]]\nname = \"g\"\nkind = \"grazing\"\n\
         parameter = \"F\"\nmax_period = 1\nseen = false\n{keys}\n"
    );
    let scene = Scene::from_toml(&text, "range.toml").unwrap_or_else(|error| panic!("{error}"));
    let report = run(&scene, Surroundings::default(), &mut ()).unwrap().remove(0);
    let code = report.status.outcome().code();
    match report.findings.unwrap() {
        Findings::Grazing(found) => match *found {
            GrazingFindings::Found(found) => (*found, code),
            nothing => panic!("{nothing:?}"),
        },
        other => panic!("{other:?}"),
    }
}

fn stop(side: &str, offset: i32) -> String {
    format!("[[stops]]\nside = \"{side}\"\noffset = {offset}\nrestitution = 0.8\n")
}

fn number(text: &Option<String>) -> BigRational {
    parse_rational(text.as_ref().unwrap()).unwrap()
}

/// Before the touch at F = √½ all paths of 1, 2, 3 are motions down to √½/(1 + ν); beyond it none is born.
#[test]
fn what_is_born_is_proved_from_the_touch_to_a_number() {
    let (found, code) = asked(&stop("upper", 1), "range = { effort = 20000 }");
    assert_eq!(code, 0);
    let [before, beyond] = &found.range.unwrap()[..] else { panic!("two sides") };
    assert_eq!((beyond.side, beyond.verdict, &beyond.certificate), ("beyond", "nothing born", &None));
    assert_eq!((before.side, before.verdict, before.whole), ("before", "proved", true));
    assert_eq!(before.periods, [1, 2, 3]);
    let (touch, end, depth) = (number(&before.touch), number(&before.end), number(&before.depth));
    let float = |x: &BigRational| x.to_f64().unwrap();
    assert!((float(&touch) - 0.5f64.sqrt()).abs() < 1e-15, "{touch}");
    // Rounded inwards, to twelve digits: (1 + ν) F ≥ √½, in exact numbers.
    let one = BigRational::from_integer(1.into());
    let at = (&one + &depth) * &end;
    assert!(&at * &at >= BigRational::new(1.into(), 2.into()), "{end} {depth}");
    assert!((float(&at) / 0.5f64.sqrt() - 1.0).abs() < 3e-12, "{end} {depth}");
    assert!((0.07..0.12).contains(&float(&depth)), "{depth}");
    assert!((before.share.unwrap() - (1.0 - float(&end) / 0.5f64.sqrt())).abs() < 1e-9);
    // The certificate is of that machine: c, k and τ stand in it exactly.
    let [(file, text)] = &found.certificates[..] else { panic!("one certificate") };
    assert_eq!((file.as_str(), before.certificate.as_deref()), ("g-before.certificate", Some(file.as_str())));
    assert_eq!(certificate::check(&mut text.as_bytes()).unwrap().kind, "range");
    for line in ["damping 1/10 1/10", "stiffness 3/10 3/10", "restitution 4/5 4/5"] {
        assert!(text.lines().any(|known| known == line), "{line}\n{text}");
    }
    // The same beside a stop on the other side, and with the same work the same text.
    let (mirrored, _) = asked(&stop("lower", -1), "range = { effort = 20000 }");
    assert_eq!(mirrored.range.unwrap()[0].end, before.end);
    assert_eq!(mirrored.certificates[0].1, *text);
}

/// Not asked for, it is not there; where there is none, the report and the exit code say so.
#[test]
fn why_there_is_no_range_is_said() {
    let (found, code) = asked(&stop("upper", 1), "");
    assert_eq!((found.range, found.range_open, code), (None, None, 0));
    let (found, code) = asked(&stop("upper", 1), "range = { effort = 1 }");
    let row = &found.range.unwrap()[0];
    assert_eq!((row.verdict, code), ("undecided", 3));
    assert!(row.reason.as_ref().unwrap().contains("raise `effort`"), "{row:?}");
    assert!(found.certificates.is_empty());
    let both = stop("upper", 1) + &stop("lower", -2);
    let soft = "[[stops]]\nname = \"s\"\noffset = -1\nstiffness = 50\n";
    for (stops, why) in [(both.as_str(), "there are two"), (soft, "gives way")] {
        let (found, code) = asked(stops, "range = { effort = 2000 }");
        assert_eq!((code, &found.range), (3, &None), "{found:?}");
        let said = found.range_open.or(found.at.open).unwrap();
        assert!(said.contains(why), "{said}");
    }
}
