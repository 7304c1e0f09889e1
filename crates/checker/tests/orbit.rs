//! Certificates of kind orbit: rules that random damage hardly ever touches.

use crate::common::{ORBIT_4, ORBIT_6, answer, rejected, resealed, with};

const IMPACT: &str = "impact lower 4 -0.143958325278224890315982 0.136325003032466663408355";

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(ORBIT_4).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("orbit", Some(4..=4)));
    let expected = "\
proved, orbit of 4 periods
  stability: unstable
  pattern: 1 impact in 4 periods, and in no fewer: lower wall, next after 4
  phases: -0.143958325278224890315982
  speeds: 0.136325003032466663408355
  box: the only orbit of this pattern whose phases and speeds are all within 0.2 of these; its own are within 0.000000000000000001
  motion: q'' = -12/49 q' - 100/2401 q
  lower wall: -1 + 19/20 cos t, restitution 1
  upper wall: none
  digest: 8ff3296ee97e2e6716c08f3f3e068eed41c8e338d5b68e41aebedf4de995c288";
    assert_eq!(checked.to_string(), expected);
    assert_eq!(answer(ORBIT_6).unwrap().range, Some(6..=6));
}

/// The orbit of period 4 twice round, with a preconditioner for the doubled equations: not an orbit of
/// period 8.
#[test]
fn an_orbit_listed_twice_is_refused() {
    let rows = "row 2.60226462 0.19208311 0.83502371 0.60194405\nrow 0.83502371 0.60194405 2.60226462 0.19208311\n\
        row -2.44900507 -0.18009486 -0.77436437 0.43350592\nrow -0.77436437 0.43350592 -2.44900507 -0.18009486";
    let flight: String =
        ORBIT_4.lines().skip_while(|line| !line.starts_with("flight")).collect::<Vec<_>>().join("\n");
    let text = with(ORBIT_4, "orbit", "orbit 2 unstable");
    let text = with(&text, "radius", "radius 0.0001 0.000000000000000001");
    let text = with(&text, "row", rows);
    let text = with(&text, "row -3.223369438", "");
    let text = with(&text, "impact", &format!("{IMPACT}\n{IMPACT}")) + &flight + "\n";
    let why = rejected(&text);
    assert!(why.contains("false: the orbit may repeat itself after 1 of its 2 impacts"), "{why}");
    // The same with other words for the second impact: a whole turn later, a period less before it and one
    // more after it.
    let later = "impact lower 3 -0.143958325278224890315982 0.136325003032466663408355\n\
        impact lower 5 6.139226981901361586609304 0.136325003032466663408355";
    let text = with(&with(&text, "impact", later), IMPACT, "");
    let why = rejected(&text);
    assert!(why.contains("false: the orbit may repeat itself after 1 of its 2 impacts"), "{why}");
}

/// Every number has one form; a sign is read once.
#[test]
fn decimals_have_one_form() {
    for bad in [
        "--5.599",
        "+5.599",
        "-+5.599",
        "5.5990",
        "05.599",
        ".599",
        "5.",
        "-0",
        "-0.0",
        "0.0",
        "-",
        "",
        "5.5.9",
        "5e1",
        "1/2",
        "5.-599",
        "0x5",
        "٣",
        "0.000000000000000000000000000000000001",
        "10000000000000000000000000000000000",
    ] {
        for line in [format!("impact lower 4 {bad} 0.1"), format!("impact lower 4 0.1 {bad}")] {
            let why = rejected(&with(ORBIT_4, "impact", &line));
            assert!(why.contains("line 13: malformed: expected a decimal"), "{bad}: {why}");
        }
        let why = rejected(&with(ORBIT_4, "until", &format!("until {bad}")));
        assert!(why.contains("malformed: expected a decimal"), "{bad}: {why}");
    }
    for bad in
        ["--12/49", "-0/1", "+12/49", "012/49", "12/-49", "12/0", "24/98", "12.5/49", "12", "/49", "12/"]
    {
        let why = rejected(&with(ORBIT_4, "damping", &format!("damping {bad}")));
        assert!(why.contains("line 5: malformed: expected a fraction"), "{bad}: {why}");
    }
    // The mirror image of a phase that was read with both its signs is not accepted either.
    let positive = ORBIT_4.replace("-0.1439583", "--0.1439583");
    assert!(rejected(&positive).contains("malformed"));
}

/// Beyond 2³⁰ the checker's intervals end, and nothing overflows.
#[test]
fn numbers_out_of_range_are_named() {
    for line in
        ["impact lower 4 2000000000 0.6", "impact lower 4 -1073741824 0.6", "impact lower 4 0.6 1073741824"]
    {
        let why = rejected(&with(ORBIT_4, "impact", line));
        assert!(
            why.contains("malformed: expected a decimal of at most 34 digits between -2^30 and 2^30"),
            "{why}"
        );
    }
    for line in ["impact lower 4 1073741823.9 0.6", "impact lower 4 0.6 1073741823"] {
        assert!(rejected(&with(ORBIT_4, "impact", line)).contains("false: Krawczyk's test does not map"));
    }
    let why = rejected(&resealed(&with(ORBIT_4, "damping", "damping 1073741824/1")));
    assert!(why.contains("line 5: malformed: expected a fraction p/q"), "{why}");
    let why = rejected(&resealed(&with(ORBIT_4, "stiffness", "stiffness 1073741823/1")));
    assert!(why.contains("false: Krawczyk's test does not map"), "{why}");
    let why = rejected(&with(ORBIT_4, "radius", "radius 1073741823 1073741823"));
    assert!(why.contains("false: Krawczyk's test does not map"), "{why}");
}

/// Harmonics up to the thousandth, and the reasons why one cannot be answered.
#[test]
fn every_harmonic_that_may_be_written_can_be_checked() {
    let forced = |harmonics: &str, count: u32| {
        resealed(&with(ORBIT_4, "forcing", &format!("forcing {count}\n{harmonics}")))
    };
    for k in [0, 1, 181, 182, 1000] {
        let harmonic = format!("harmonic {k} 1/100000000000000000000000 -1/100000000000000000000000");
        let checked = answer(&forced(&harmonic, 1));
        assert!(checked.is_ok(), "k = {k}: {}", checked.unwrap_err());
    }
    let undamped = |stiffness: &str, k: u32| {
        let text = with(ORBIT_4, "damping", "damping 0/1");
        let text = with(&text, "stiffness", &format!("stiffness {stiffness}"));
        rejected(&resealed(&with(&text, "forcing", &format!("forcing 1\nharmonic {k} 1/1 0/1"))))
    };
    assert!(undamped("1000000/1", 1000).ends_with("harmonic 1000 of the forcing is in undamped resonance"));
    assert!(undamped("33124/1", 182).ends_with("harmonic 182 of the forcing is in undamped resonance"));
    assert!(undamped("0/1", 0).contains("harmonic 0 of the forcing is a constant"));
    assert!(
        undamped("1000000000/1", 1)
            .contains("harmonic 1 of the forcing meets a stiffness or damping too large")
    );
}

/// What takes hours is refused before it begins.
#[test]
fn the_work_is_bounded() {
    let nothing = "harmonic 7 0/1 0/1\n".repeat(999) + "harmonic 8 0/1 0/1";
    let many = resealed(&with(ORBIT_4, "forcing", &format!("forcing 1000\n{nothing}")));
    assert!(
        rejected(&with(&many, "flight", "flight 2000")).contains("malformed: the check would take up to 16")
    );
    assert!(rejected(&with(ORBIT_4, "flight", "flight 600000")).contains("exponentials, more than 1000000"));
    assert!(rejected(&with(ORBIT_4, "flight", "flight 1000001")).contains("expected the number of pieces"));
}

/// The orbit of period 4 with its coefficients in intervals, 12/49 and 100/2401 among them.
fn in_intervals() -> String {
    let text = with(ORBIT_4, "kind", "kind orbit 2");
    let text = with(&text, "statement", &format!("statement {}", grazing_check::orbit::STATEMENT_2));
    let text = with(
        &text,
        "damping",
        "damping 0.24489795918367346938775510204081..0.24489795918367346938775510204082",
    );
    let text = with(&text, "stiffness", "stiffness 0.04164931278633902540608..0.04164931278633902540609");
    let text = with(&text, "force", "force 0..0");
    let text = with(&text, "lower", "lower -1..-1 1..1 1");
    resealed(&with(&text, "harmonic", "harmonic 1 0.95..0.95 0..0"))
}

#[test]
fn coefficients_may_be_intervals() {
    let checked = answer(&in_intervals()).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("orbit", Some(4..=4)));
    let detail = |name: &str| checked.detail.iter().find(|(known, _)| *known == name).unwrap().1.as_str();
    assert_eq!(
        detail("motion"),
        "q'' = -[0.24489795918367346938775510204081, 0.24489795918367346938775510204082] q' \
         - [0.04164931278633902540608, 0.04164931278633902540609] q"
    );
    assert_eq!(detail("lower wall"), "-1 + 0.95 cos t, restitution 1");
    // Another number of the interval's is another oscillator, for which it is proved as well; one outside is
    // not.
    for line in ["stiffness 0.041649312..0.041649313", "stiffness 0.04..0.042", "stiffness 0.05..0.05"] {
        let why = rejected(&resealed(&with(&in_intervals(), "stiffness", line)));
        assert!(why.contains("false: Krawczyk's test does not map"), "{line}: {why}");
    }
    let wide = with(&in_intervals(), "stiffness", "stiffness 0.0416493..0.0416494");
    assert!(answer(&resealed(&with(&wide, "radius", "radius 0.1 0.01"))).is_ok());
}

#[test]
fn intervals_have_one_form() {
    for bad in [
        "1/2",
        "0.5",
        "0.5..",
        "..0.5",
        "0.5.0.6",
        "0.6..0.5",
        "0.5...6",
        "0.5..0.60",
        "-0..0",
        "1..1..1",
        "0..1073741824",
        "0.1..0.10000000000000000000000000000000000001",
        "-0.5..-0.6",
        "0.5..-0.5",
        "1.5..1.25",
    ] {
        let why = rejected(&with(&in_intervals(), "force", &format!("force {bad}")));
        assert!(why.contains("line 7: malformed: expected LOWER..UPPER"), "{bad}: {why}");
    }
    let why = rejected(&with(&in_intervals(), "lower", "lower -1..-1 -0.1..1 1"));
    assert!(why.contains("malformed: a restitution is at least 0"), "{why}");
    for line in ["kind orbit 1", "kind orbit 4", "kind orbit  2", "kind theorem2 2", "kind orbit 2 "] {
        assert!(
            rejected(&with(ORBIT_4, "kind", line))
                .contains("line 2: malformed: expected a line \"kind theorem2\"")
        );
    }
}
