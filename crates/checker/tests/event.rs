//! Certificates of kind event: what they say, and rules that random damage hardly ever touches.

use crate::common::{FLIP, GRAZING, SADDLE_NODE, answer, rejected, resealed, with};

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(SADDLE_NODE).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("event", Some(4..=4)));
    let expected = "\
proved, event of 4 periods
  event: saddle-node: a multiplier is 1, and mu turns, nondegenerate
  parameter: mu, from -0.084338470089589203903614 to -0.084338470089589203903414
  pattern: 1 impact in 4 periods, and in no fewer: lower wall, next after 4
  phases: -0.413645678404526674926701
  speeds: 0.368148836555663321892304
  box: the only event of this kind and pattern with all of these and mu within 0.05 of the listed values; its own are within 0.0000000000000000000001
  motion: q'' = -12/49 q' - 100/2401 q
  lower wall: -1 + (1 + mu) cos t, restitution 1
  upper wall: none
  digest: c9d30249a363c9e90b35e9504ba88bb55872960b1c13aa4361fc6fc82948eef4";
    assert_eq!(checked.to_string(), expected);
    let detail = |text: &str, name: &str| {
        let checked = answer(text).unwrap();
        checked.detail.into_iter().find(|(known, _)| *known == name).unwrap().1
    };
    assert!(detail(FLIP, "event").starts_with("flip: a multiplier is -1, "));
    assert_eq!(
        detail(FLIP, "parameter"),
        "mu, from 0.005479046221248913834306 to 0.005479046221248913834506"
    );
    assert!(detail(GRAZING, "event").starts_with("grazing: the lower wall is touched"));
    assert_eq!(detail(GRAZING, "contact"), "with the lower wall, 12.558922727389710130641076 after impact 2");
    // The ends of the interval are exact, whatever their digits.
    let wide = with(SADDLE_NODE, "radius", "radius 0.05 0.001");
    assert_eq!(
        detail(&wide, "parameter"),
        "mu, from -0.085338470089589203903514 to -0.083338470089589203903514"
    );
    let moved = with(&wide, "parameter", "parameter long_NAME_7 -0.084");
    assert_eq!(detail(&moved, "parameter"), "long_NAME_7, from -0.085 to -0.083");
}

/// The saddle-node of period 4 twice round, with a preconditioner for the doubled equations.
#[test]
fn an_event_of_an_orbit_listed_twice_is_refused() {
    let rows = "row 0.67172093 0.29134797 -0.68086238 0.60504095 -0.17418088\n\
        row -0.68086238 0.60504095 0.67172093 0.29134797 -0.17418088\n\
        row -0.74251985 -0.28361769 0.4095347 0.45118199 0.14607862\n\
        row 0.4095347 0.45118199 -0.74251985 -0.28361769 0.14607862\n\
        row -0.43500362 -0.10048755 -0.43500362 -0.10048755 0";
    let impact = "impact lower 4 -0.413645678404526674926701 0.368148836555663321892304";
    let flight: String =
        SADDLE_NODE.lines().skip_while(|line| !line.starts_with("flight")).collect::<Vec<_>>().join("\n");
    let text = with(SADDLE_NODE, "event", "event saddle-node 2");
    let text = with(&text, "radius", "radius 0.0001 0.000000000000000001");
    let text = with(&text, "row", rows);
    let text = with(&text, "row -0.332985148", "");
    let text = with(&text, "row -0.870007234", "");
    let text = with(&text, "impact", &format!("{impact}\n{impact}")) + &flight + "\n";
    let why = rejected(&text);
    assert!(why.contains("false: the orbit may repeat itself after 1 of its 2 impacts"), "{why}");
}

#[test]
fn another_event_or_contact_is_none() {
    let cases = [
        // Neither does the saddle-node flip nor the flip meet.
        (with(SADDLE_NODE, "event", "event flip 1"), "false: Krawczyk's test does not map"),
        (with(FLIP, "event", "event saddle-node 1"), "false: Krawczyk's test does not map"),
        (with(FLIP, "event", "event grazing 1"), "malformed: expected a line \"contact …\""),
        (with(GRAZING, "event", "event flip 2"), "malformed: expected a line \"radius …\""),
        (with(FLIP, "event", "event fold 1"), "malformed: expected saddle-node, flip or grazing"),
        (with(FLIP, "event", "event flip 0"), "malformed: the periods of an orbit must not sum to 0"),
        (with(FLIP, "event", "event flip 25"), "malformed: expected the number of impacts"),
        (with(FLIP, "impact", "impact upper 3 0.1 0.1"), "malformed: there is no upper wall"),
        (with(GRAZING, "contact", "contact 0 lower 12.5"), "malformed: impacts are counted from 1"),
        (
            with(GRAZING, "contact", "contact 3 lower 12.5"),
            "malformed: expected an impact, a number from 0 to 2",
        ),
        (with(GRAZING, "contact", "contact 2 upper 12.5"), "malformed: there is no upper wall"),
        (with(GRAZING, "contact", "contact 2 wall 12.5"), "malformed: expected lower or upper"),
        (
            with(GRAZING, "contact", "contact 1 lower 12.558922727389710130641076"),
            "false: Krawczyk's test does not map",
        ),
        (with(GRAZING, "contact", "contact 2 lower 12.5"), "false: Krawczyk's test does not map"),
        (with(SADDLE_NODE, "parameter", "parameter mu 0.084"), "false: Krawczyk's test does not map"),
    ];
    for (text, expected) in cases {
        let why = rejected(&text);
        assert!(why.contains(expected), "{why}, expected {expected}");
    }
    // The contact must lie in the interior of one piece, certainly, on all of which the gap bends away from
    // the wall.
    let first = GRAZING.rfind("\nuntil 12.7\n").unwrap();
    let (before, after) = (&GRAZING[..first], &GRAZING[first + "\nuntil 12.7\n".len()..]);
    let why = rejected(&format!("{before}\nuntil 12.558922727389710130641076\n{after}"));
    assert!(why.contains("is not certainly positive"), "{why}");
    let flight = GRAZING.rfind("\nflight ").unwrap() + 1;
    let ends: Vec<&str> = GRAZING[flight..].lines().skip(1).collect();
    let few: Vec<&str> = ends.iter().copied().filter(|end| !("until 11".."until 15").contains(end)).collect();
    let few = format!("{}flight {}\n{}\n", &GRAZING[..flight], few.len(), few.join("\n"));
    assert!(few.lines().count() < GRAZING.lines().count() - 9);
    assert!(rejected(&few).contains("is not certainly positive"), "{}", rejected(&few));
}

/// The flight's formula goes on before its start and after its end, with tangencies that no orbit has. Their
/// numbers are by Newton's method from formulas of its own.
#[test]
fn a_contact_outside_its_flight_is_none() {
    let before = [
        "-0.349833330219330607 0.314559186130962953",
        "parameter mu -0.082471007645187722",
        "contact 1 lower -1.549735182033756153",
        "row -0.014021 0.702684 0.381584 0\nrow -0.277928 0.339373 -0.321326 0\n\
         row -0.872604 -0.160187 0.022372 0\nrow -0.050676 -1.099068 -2.244927 -2.198137",
    ];
    let after = [
        "-0.435505713144437256 0.386484903481875475",
        "parameter mu -0.084119646998618153",
        "contact 1 lower 31.832943447919817004",
        "row -5.1219 -0.593531 5.374826 0\nrow 3.939514 1.413315 -4.509809 0\n\
         row -0.767652 -0.189138 -0.107627 0\nrow 4.926304 0.546396 -5.164824 1.092792",
    ];
    for [impact, parameter, contact, rows] in [before, after] {
        let text = with(SADDLE_NODE, "event", "event grazing 1");
        let text = with(&text, "parameter", parameter);
        let text = with(&text, "impact", &format!("impact lower 4 {impact}\n{contact}"));
        let text = with(&text, "row -0.332985148", "");
        let text = with(&text, "row -0.870007234", "");
        let text = with(&text, "row", rows);
        let why = rejected(&with(&text, "radius", "radius 0.0000001 0.0000000000001"));
        assert!(why.contains("false: the contact is not certainly during flight 1"), "{why}");
    }
}

/// What the system's lines say is what is proved: every change of them is seen, resealed or not.
#[test]
fn coefficients_are_evaluated_as_written() {
    for (start, line) in [
        ("damping", "damping 12,1/49"),
        ("stiffness", "stiffness 100,0,1/2401"),
        ("force", "force 0,1/1000"),
        ("lower", "lower -1/1 1000,1/1000 1"),
        ("harmonic", "harmonic 1 1,2/1 0/1"),
        ("harmonic", "harmonic 1 1,1,1/1 0/1"),
        ("harmonic", "harmonic 1 1/1,1 0/1"),
        ("harmonic", "harmonic 1 1,1/1 0,1/1"),
        ("harmonic", "harmonic 2 1,1/1 0/1"),
    ] {
        for text in [SADDLE_NODE, FLIP, GRAZING] {
            let changed = with(text, start, line);
            assert!(rejected(&changed).contains("false: the digest is not that of the system"), "{line}");
            let why = rejected(&resealed(&changed));
            assert!(why.contains("false: Krawczyk's test does not map"), "{line}: {why}");
        }
    }
    // The same function in other words: (1 + p) is also (1 + p)(2 + p)/(2 + p), and passes.
    let same = resealed(&with(SADDLE_NODE, "harmonic", "harmonic 1 2,3,1/2,1 0/1"));
    assert!(answer(&same).is_ok(), "{}", rejected(&same));
    // A pole in the box, a resonance in it, and a restitution that may be negative.
    let pole = resealed(&with(SADDLE_NODE, "force", "force 1/843384700,10000000000"));
    assert!(rejected(&pole).contains("false: "), "{}", rejected(&pole));
    let resonant = with(&with(SADDLE_NODE, "damping", "damping 0/1"), "stiffness", "stiffness 1/1");
    let resonant = resealed(&with(&resonant, "forcing", "forcing 1\nharmonic 1 1/1 0/1"));
    assert!(rejected(&resonant).contains("false: harmonic 1 of the forcing is in undamped resonance"));
    let why = rejected(&resealed(&with(SADDLE_NODE, "lower", "lower -1/1 -1/1 1")));
    assert!(why.contains("malformed: a restitution is at least 0"), "{why}");
    // τ = 1 + 0 p needs no more; τ = (p + p₀)… is positive at one end of the interval only.
    let wide = with(SADDLE_NODE, "upper", "upper 50/1 843383,10000000/10000000 0");
    let why = rejected(&resealed(&with(&wide, "radius", "radius 0.05 0.001")));
    assert!(why.contains("false: a restitution is not certainly at least 0"), "{why}");
}

#[test]
fn quotients_have_one_form() {
    let most = format!("harmonic 1 {}1/1 0/1", "0,".repeat(17));
    for bad in [
        "harmonic 1 2,2/2 0/1",
        "harmonic 1 1,1,0/1 0/1",
        "harmonic 1 -1,-1/-1 0/1",
        "harmonic 1 1,1/1,0 0/1",
        "harmonic 1 1,1/0 0/1",
        "harmonic 1 1,1 0/1",
        "harmonic 1 1,,1/1 0/1",
        "harmonic 1 ,1/1 0/1",
        "harmonic 1 1,+1/1 0/1",
        "harmonic 1 1,-0/1 0/1",
        "harmonic 1 1,01/1 0/1",
        "harmonic 1 1.5,1/1 0/1",
        "harmonic 1 1073741824/1 0/1",
        "harmonic 1 1,10000000000000000000000000000000000/1 0/1",
        &most,
    ] {
        let why = rejected(&with(SADDLE_NODE, "harmonic", bad));
        assert!(why.contains("line 10: malformed: expected a quotient P0,P1,.../Q0,Q1,..."), "{bad}: {why}");
    }
}

#[test]
fn names_and_intervals_have_limits() {
    let long = "x".repeat(33);
    for name in ["", "7", "a-b", "ä", "a.b", &long] {
        let why = rejected(&with(SADDLE_NODE, "parameter", &format!("parameter {name} -0.08")));
        assert!(
            why.contains("line 12: malformed: expected a name of at most 32 letters, digits and _"),
            "{why}"
        );
    }
    let why = rejected(&with(SADDLE_NODE, "parameter", "parameter mu 1073741824"));
    assert!(
        why.contains("malformed: expected a decimal of at most 34 digits between -2^30 and 2^30"),
        "{why}"
    );
    // P ± W are said with all their digits, or not at all.
    let text = with(SADDLE_NODE, "parameter", "parameter mu 12345678.12345678");
    let text = with(&text, "radius", "radius 0.05 0.0000000000000000000000000001");
    let why = rejected(&text);
    assert!(why.contains("line 12: malformed: P - W and P + W have more than 34 digits"), "{why}");
}

/// What takes hours is refused before it begins.
#[test]
fn the_work_is_bounded() {
    let nothing = "harmonic 7 0/1 0/1\n".repeat(999) + "harmonic 8 0/1 0/1";
    let many = resealed(&with(SADDLE_NODE, "forcing", &format!("forcing 1000\n{nothing}")));
    // (1 + 2·1001)(4·64 + 6·17).
    let why = rejected(&with(&many, "flight", "flight 200"));
    assert!(
        why.contains("malformed: the check would take up to 1806706 exponentials, more than 1000000"),
        "{why}"
    );
    assert!(rejected(&with(SADDLE_NODE, "flight", "flight 600000")).contains("exponentials, more than"));
}

#[test]
fn boxes_are_claims() {
    for (line, expected) in [
        ("radius 1 0.0000000000000000000001", "false: Krawczyk's test does not map"),
        ("radius 0.05 0.000000000000000000000000001", "false: Krawczyk's test does not map"),
        ("radius 0.001 0.002", "false: the smaller radius must be positive and at most"),
        ("radius 0.05 0", "false: the smaller radius must be positive and at most"),
        ("radius 0.05 -0.001", "false: the smaller radius must be positive and at most"),
        ("radius 1073741823 1073741823", "false: Krawczyk's test does not map"),
    ] {
        for text in [SADDLE_NODE, FLIP, GRAZING] {
            let why = rejected(&with(text, "radius", line));
            assert!(why.contains(expected), "{line}: {why}");
        }
    }
    let zeros = with(SADDLE_NODE, "row", "row 0 0 0");
    assert!(
        rejected(&zeros).contains("false: Krawczyk's test does not map the box into itself in unknown 1")
    );
    assert!(rejected(&with(SADDLE_NODE, "row", "row 0 0")).contains("malformed: expected a decimal"));
    assert!(rejected(&(SADDLE_NODE.to_string() + "\n")).contains("malformed: the file goes on"));
}

/// The saddle-node with its coefficients' numbers in intervals.
#[test]
fn numbers_in_coefficients_may_be_intervals() {
    let text = with(SADDLE_NODE, "kind", "kind event 2");
    let text = with(&text, "statement", &format!("statement {}", grazing_check::event::STATEMENT_2));
    let text = with(&text, "damping", "damping 12..12/49..49");
    let text = with(&text, "stiffness", "stiffness 100..100/2401..2401");
    let text = with(&text, "force", "force 0..0/1..1");
    let text = with(&text, "lower", "lower -1..-1/1..1 1..1/1..1 1");
    let with_harmonic =
        |harmonic: &str| resealed(&with(&text, "harmonic", &format!("harmonic 1 {harmonic} 0..0/1..1")));
    let exact = with_harmonic("1..1,1..1/1..1");
    let checked = answer(&exact).unwrap_or_else(|why| panic!("{why}"));
    assert_eq!((checked.kind, checked.statement), ("event", grazing_check::event::STATEMENT_2));
    assert!(checked.detail.iter().any(|line| line.1 == "-1 + (1 + mu) cos t, restitution 1"));
    let wide = with(&with_harmonic("1..1,0.9999..1.0001/1..1"), "radius", "radius 0.05 0.001");
    assert!(answer(&wide).is_ok(), "{}", rejected(&wide));
    assert!(rejected(&with_harmonic("1..1,0.99..1.01/1..1")).contains("false: Krawczyk's test does not map"));
    assert!(rejected(&with_harmonic("1..1,1..1/-1..1")).contains("false: "));
    for bad in ["1..1,1..1", "1,1/1", "1..1,,1..1/1..1", "1..1/", "2..1/1..1"] {
        assert!(rejected(&with_harmonic(bad)).contains("line 10: malformed: expected"), "{bad}");
    }
    let most = format!("{}1..1/1..1", "0..0,".repeat(17));
    assert!(rejected(&with_harmonic(&most)).contains("a polynomial has at most 17 coefficients"));
    let why = rejected(&resealed(&with(&exact, "lower", "lower -1..-1/1..1 -1..-1/1..1 1")));
    assert!(why.contains("malformed: a restitution is at least 0"), "{why}");
}
