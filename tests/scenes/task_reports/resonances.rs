//! What is born of one impact at a resonance nθ = mπ of a linear oscillator, where Theorem 1 is silent,
//! against the paper's (77)–(81) and motions that are followed.

use std::f64::consts::PI;

use grazing_scenes::run::{GrazingReport, Judgement, RangeRow};

use super::grazing_found;

/// (65)–(67), with any damping c and angle θ = turns · π: k = (turns/2)² + c²/4.
fn paper(c: &str, turns: &str, tau: &str, keys: &str) -> (GrazingReport, String, u8) {
    grazing_found(&format!(
        "format = \"grazing-scene 3\"\ntitle = \"a resonance\"\n[parameters]\nmu = 0\nc = \"{c}\"\ns = \"{turns}\"\n\
         [system]\ndamping = \"c\"\nstiffness = \"s^2/4 + c^2/4\"\n[[stops]]\nside = \"lower\"\noffset = -1\n\
         harmonics = [{{ k = 1, cos = \"1 + mu\" }}]\nrestitution = \"{tau}\"\n[[tasks]]\nname = \"g\"\n\
         kind = \"grazing\"\nparameter = \"mu\"\nseen = false\n{}{keys}\n",
        if keys.contains("range") { "" } else { "range = false\n" }
    ))
}

/// Section 4.1: V² = ((1 + ρ)/(1 − τρ))² (2µ + µ²) at n = 3, both multipliers τρ; and so at every first
/// resonance.
#[test]
fn the_orbit_of_the_first_resonance_is_that_of_section_4_1() {
    for (n, c, tau) in
        [(3, "1/4", "1"), (3, "0", "1/2"), (2, "1/10", "4/5"), (5, "1/50", "9/10"), (4, "1/4", "0")]
    {
        let (found, shown, _) = paper(c, &format!("1/{n}"), tau, "max_period = 5\ndistance = 1e-6");
        let row =
            found.born.iter().find(|row| row.pattern == n.to_string()).unwrap_or_else(|| panic!("{shown}"));
        let number = |text: &str| match text.split_once('/') {
            Some((a, b)) => a.parse::<f64>().unwrap() / b.parse::<f64>().unwrap(),
            None => text.parse().unwrap(),
        };
        let (c, tau, mu) = (number(c), number(tau), row.found_at.unwrap());
        let rho = (-PI * c * f64::from(n)).exp();
        let speed = (1.0 + rho) / (1.0 - tau * rho) * (2.0 * mu + mu * mu).sqrt();
        assert!((row.speeds.as_ref().unwrap()[0] / speed - 1.0).abs() < 1e-9, "{n}: {row:?}");
        assert!(row.side == "mu > 0" && row.stable == Some(Judgement::Yes), "{row:?}");
        assert_eq!(row.admissible, Some(Judgement::Yes), "{row:?}");
        for multiplier in row.multipliers.as_ref().unwrap() {
            // A double eigenvalue is known to the root of rounding.
            let pair = serde_json::to_value(multiplier).unwrap();
            let off = (pair[0].as_f64().unwrap() - tau * rho).hypot(pair[1].as_f64().unwrap());
            assert!(off < 1e-6, "{n}: {multiplier:?} for {}", tau * rho);
        }
        assert!(row.reason.as_ref().unwrap().starts_with(&format!("u_{n} = 0")), "{row:?}");
    }
}

/// What is born is stable however little is lost, and its multipliers are told however small they are; of
/// numbers that are not rational nothing is known, and the report says so. A sentence says what is a theorem.
#[test]
fn the_ends_of_damping_and_numbers_that_are_not_rational() {
    let row = |c: &str, tau: &str| {
        let (found, shown, code) = paper(c, "1/3", tau, "max_period = 3");
        let row =
            found.born.iter().find(|row| row.pattern == "3").unwrap_or_else(|| panic!("{shown}")).clone();
        (row, found.in_words, code)
    };
    let (light, told, _) = row("1/100000000000000000000", "1");
    assert_eq!(light.stable, Some(Judgement::Yes), "{light:?}");
    assert!(
        told.contains("Of one impact in 3 periods u_3 = 0: that exactly one such orbit is born"),
        "{told}"
    );
    // Its arc falls so soon that it clears the stop much nearer to the touch alone.
    let (heavy, _, _) = row("4", "1");
    let why = heavy.reason.as_ref().unwrap();
    assert!(
        heavy.stable == Some(Judgement::Yes) && why.contains("e-17; so far from the touch: "),
        "{heavy:?}"
    );
    assert!(row("1/4", "0").0.reason.unwrap().ends_with(" 0"));
    let (open, told, code) = row("1/4", "sqrt(1/2)");
    assert_eq!((&*open.side, open.stable, code), ("open", None, 3), "{open:?}");
    assert!(!told.contains("u_3 = 0"), "{told}");
}

/// Nothing of one impact is born in n periods at a higher resonance, with m even or odd, nor where the
/// exceptions of the theorem are; for n = 1 it is at all.
#[test]
fn at_a_higher_resonance_nothing_is_born() {
    let has = |c: &str, turns: &str, tau: &str, n: &str| {
        let (found, shown, _) = paper(c, turns, tau, "max_period = 3");
        let row = found.born.iter().find(|row| row.pattern == n);
        assert!(row.is_none_or(|row| row.side == "mu > 0"), "{shown}");
        row.is_some()
    };
    assert!(!has("1/4", "2/3", "1", "3"));
    assert!(!has("1/4", "4/3", "1", "3"));
    assert!(!has("1/4", "3/2", "1/2", "2"));
    assert!(has("1/4", "7/3", "1", "3"));
    // τq = −1.
    assert!(!has("0", "1/3", "1", "3"));
    for turns in ["1", "2", "3"] {
        assert!(has("1/4", turns, "1/2", "1"), "{turns}");
    }
    // Beside it Theorem 1 speaks.
    let (found, _, _) = paper("1/4", "1/3 + 1/1000000", "1", "max_period = 3");
    let row = found.born.iter().find(|row| row.pattern == "3").unwrap();
    assert!(row.coefficient.is_some() && row.side == "mu < 0", "{row:?}");
}

/// From the touch on it is exactly one motion, stable, with a certificate, of one impact in n periods: at the
/// first resonance of one stop, at n = 1 for θ = π and 2π; beside it none is stable from the touch on.
#[test]
fn from_the_touch_on_it_is_proved() {
    let rows = |c: &str, turns: &str, n: u64| {
        let (found, shown, _) = paper(c, turns, "1", "max_period = 3\nrange = { effort = 5000 }");
        let of = |row: &&RangeRow| row.of == "orbit" && row.side == "beyond" && row.periods == [n];
        let rows: Vec<RangeRow> =
            found.range.unwrap_or_else(|| panic!("{shown}")).iter().filter(of).cloned().collect();
        (rows, found.certificates, shown)
    };
    for (c, turns, n, least) in
        [("1/4", "1/3", 3, 0.5), ("1/4", "1", 1, 0.5), ("1/4", "2", 1, 0.5), ("1/50", "1/5", 5, 0.05)]
    {
        let (rows, certificates, shown) = rows(c, turns, n);
        let [row] = &rows[..] else { panic!("{turns}: {shown}") };
        let end: f64 = row.end.as_ref().unwrap_or_else(|| panic!("{turns}: {shown}")).parse().unwrap();
        assert!(row.verdict == "proved" && end > least, "{turns}: {row:?}");
        let [part] = &row.stability[..] else { panic!("{row:?}") };
        assert!(
            part.word == "stable" && part.from.is_none() && Some(&part.to) == row.end.as_ref(),
            "{row:?}"
        );
        let named = certificates.iter().find(|file| Some(&file.file) == row.certificate.as_ref()).unwrap();
        let text = named.accepted.text();
        let checked = grazing_scenes::certificate::check(&mut text.as_bytes()).unwrap();
        assert_eq!((checked.kind, row.left.clone()), ("parameter", None), "{shown}");
        assert!(text.contains("kind single\n") && text.contains(&format!("\nperiods {n}\n")), "{text}");
    }
    for turns in ["1/3 + 1/30000", "2/3"] {
        let (rows, _, shown) = rows("1/4", turns, 3);
        assert!(rows.is_empty(), "{turns}: {shown}");
    }
}
