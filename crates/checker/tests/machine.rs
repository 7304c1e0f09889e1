//! Certificates of kind machine-orbit: the example worked by hand, and rules that random damage hardly ever
//! touches.

use crate::common::{answer, rejected, resealed, with};

/// The ball on the moving table, restitution 1/2.
const BALL: &str = include_str!("data/machine-ball.txt");
/// Two masses on springs, the first with a stop, driven at 8 Hz.
const MASSES: &str = include_str!("data/machine-masses.txt");

/// The other solution of cos t = π/6, with the signs of its derivatives.
fn other() -> String {
    let text = with(BALL, "impact", "impact 1 1 -1.0197267436954502 -1.7039299541846926 -3.141592653589793");
    let text = with(&text, "row 0 -0.093405", "row 0 0.093405 -0.195626");
    with(&text, "row 1 -0.097813", "row 1 0.097813 -0.204859")
}

#[test]
fn the_example_worked_by_hand_is_proved() {
    let checked = answer(BALL).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("machine-orbit", Some(1..=1)));
    let detail = |name: &str| checked.detail.iter().find(|(known, _)| *known == name).unwrap().1.as_str();
    assert_eq!(detail("stops"), "1: q1 >= 2 sin t, restitution 0.5");
    assert_eq!(detail("pattern"), "1 impact in 1 period, and in no fewer: stop 1, next after 1");
    // D = 1/16 and T = τ² + ... : of the two orbits one has a multiplier beyond 1.
    let claimed = |text: &str, claim: &str| answer(&with(text, "orbit", &format!("orbit 1 {claim}"))).is_ok();
    assert!(claimed(BALL, "unstable") && !claimed(BALL, "stable"));
    assert!(answer(&other()).is_ok(), "{}", rejected(&other()));
    // By hand: P = [[−τ, 0], [−(τ z₋″ + z₊″)/V, −τ]] and a flight [[1, 2π], [0, 1]], z″ = −1 + a sin t:
    // T = −2τ − 2π(1 + τ) z″/V with V = 2π/(1 + τ), D = τ².
    let trace = |sine: f64| -1.0 - 2.25 * (-1.0 + 2.0 * sine);
    let determinant = 0.25f64;
    let phase = (std::f64::consts::PI / 6.0).acos();
    for (text, sine) in [(BALL.to_string(), phase.sin()), (other(), -phase.sin())] {
        let stable = determinant < 1.0 && trace(sine).abs() < 1.0 + determinant;
        assert_eq!(claimed(&text, "stable"), stable, "{sine}");
        assert_eq!(claimed(&text, "unstable"), !stable, "{sine}");
    }
}

/// The orbit twice round, with a preconditioner for the doubled equations: not an orbit of period 2.
#[test]
fn an_orbit_listed_twice_is_refused() {
    let head: Vec<&str> = BALL.lines().take_while(|line| !line.starts_with("orbit")).collect();
    let tail: Vec<&str> = BALL.lines().skip_while(|line| !line.starts_with("flight")).collect();
    let impact = BALL.lines().find(|line| line.starts_with("impact")).unwrap();
    let middle = include_str!("data/machine-ball-twice.txt");
    let text = format!(
        "{}\norbit 2 open\nscales 1 1\n{impact}\n{impact}\nradius 0.0001 0.00000000000001\n{middle}{}\n{}\n",
        head.join("\n"),
        tail.join("\n"),
        tail.join("\n")
    );
    let why = rejected(&text);
    assert!(why.contains("false: the orbit may repeat itself after 1 of its 2 impacts"), "{why}");
}

#[test]
fn what_is_false_is_refused_for_its_reason() {
    let sealed = |start: &str, line: &str| resealed(&with(BALL, start, line));
    let krawczyk = "false: Krawczyk's test does not map the box into itself";
    let cases = [
        (with(BALL, "mass", "mass 2..2"), "line 4: false: the digest is not that of the machine"),
        (sealed("period", "period 6.283..6.284"), krawczyk),
        (sealed("period", "period 0..6"), "false: the period is not certainly positive"),
        (sealed("mass", "mass -1..-1"), "false: the mass matrix is not certainly positive definite"),
        (sealed("mass", "mass 0..1"), "false: the mass matrix is not certainly positive definite"),
        (sealed("damping", "damping 0.001..0.001"), krawczyk),
        (sealed("stiffness", "stiffness 0.001..0.001"), krawczyk),
        (sealed("force", "force -1.0001..-1.0001"), krawczyk),
        (sealed("forcing", "forcing 1\nharmonic 3 0.001..0.001 0..0"), krawczyk),
        (sealed("direction", "direction 0..0"), "false: the row of stop 1 may be zero"),
        (sealed("direction", "direction 1.001..1.001"), krawczyk),
        (sealed("stop ", "stop 0..0 0.51..0.51 1"), krawczyk),
        (sealed("stop ", "stop 0..0 -0.5..0.5 1"), "malformed: a restitution is at least 0"),
        // Resonance of the free ball with nothing: k ≥ 1 and no stiffness; with stiffness 1 it is at k = 1.
        (
            resealed(&with(
                &with(BALL, "stiffness", "stiffness 1..1"),
                "forcing",
                "forcing 1\nharmonic 1 1..1 0..0",
            )),
            "false: harmonic 1 of the forcing may be in undamped resonance",
        ),
        // Another stop, which the flight would cross, or which touches at the impact.
        (
            sealed("stops", "stops 2\nstop -3..-3 0.5..0.5 0\ndirection -1..-1")
                .replace("impact 1", "impact 2"),
            "the gap to stop 1 on piece",
        ),
        (
            sealed("stops", "stops 2\nstop 0..0 0.5..0.5 1\ndirection 1..1\nharmonic 1 0..0 2..2"),
            "the gap to stop 2 on piece 1 of flight 1 is not certainly positive",
        ),
        (with(BALL, "impact", "impact 1 1 1.0197 1.7039 -3.1416"), krawczyk),
        (
            with(BALL, "impact", "impact 1 2 1.0197267436954502 1.7039299541846926 -3.141592653589793"),
            krawczyk,
        ),
        (with(BALL, "radius", "radius 1 0.00000000000001"), krawczyk),
        (with(BALL, "radius", "radius 0.01 0.01"), "false: the smaller radius must be positive"),
        (with(BALL, "radius", "radius 0.01 -0.01"), "false: the smaller radius must be positive"),
        (with(BALL, "scales", "scales 0.0000000001 1"), krawczyk),
        (with(BALL, "row", "row 0 0 0"), krawczyk),
        (with(BALL, "until 6.4", "until 6.28"), "false: the pieces of flight 1 stop before its end"),
        (with(BALL, "until 2", "until 0.5"), "false: the pieces of flight 1 do not follow one another"),
        (
            with(&with(&with(BALL, "flight", "flight 7"), "until 5.8", ""), "until 6.4", "until 9"),
            "is not certainly positive",
        ),
    ];
    for (text, expected) in cases {
        let why = rejected(&text);
        assert!(why.contains(expected), "{why}, expected {expected}");
    }
}

/// A machine whose second coordinate nothing couples to the stop: every rule for several coordinates.
#[test]
fn two_masses_are_proved_for_all_of_their_intervals() {
    let checked = answer(MASSES).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("machine-orbit", Some(1..=1)));
    assert_eq!(checked.detail[0], ("stability", "stable".to_string()));
    let sealed = |start: &str, line: &str| resealed(&with(MASSES, start, line));
    // M, C, K and forces have a common unit, of which nothing depends.
    assert!(answer(&sealed("unit", "unit -7")).is_ok());
    let within = |text: &str| with(text, "radius", "radius 0.02 0.001");
    assert!(answer(&within(&sealed("stiffness 3200", "stiffness 3199.999..3200.001 -200..-200"))).is_ok());
    for (start, line) in [
        ("stiffness 3200", "stiffness 3200..3200 -201..-201"),
        ("stiffness -200", "stiffness -201..-201 200..200"),
        ("damping 12", "damping 12..12 -2.1..-2.1"),
        ("mass 0..0", "mass 0.01..0.01 0.5..0.5"),
        ("direction", "direction 1..1 0.01..0.01"),
        ("force ", "force 0..0 0.1..0.1"),
    ] {
        let why = rejected(&sealed(start, line));
        assert!(why.contains("false: Krawczyk's test does not map"), "{line}: {why}");
    }
    assert!(rejected(&sealed("mass 0..0", "mass 2..2 2..2")).contains("not certainly positive definite"));
    assert!(
        rejected(&with(MASSES, "orbit", "orbit 1 unstable")).contains("false: the orbit is not certainly")
    );
}

#[test]
fn the_form_is_held_to() {
    let cases = [
        ("coordinates", "coordinates 0", "malformed: a machine has at least one coordinate"),
        (
            "coordinates",
            "coordinates 9",
            "malformed: expected the number of coordinates, a number from 0 to 8",
        ),
        ("coordinates", "coordinates 2", "malformed: expected a line \"mass …\""),
        ("unit", "unit 100", "malformed: expected a whole number from -99 to 99"),
        ("unit", "unit -0", "malformed: expected a whole number from -99 to 99"),
        ("unit", "unit +1", "malformed: expected a whole number from -99 to 99"),
        ("mass", "mass 1", "malformed: expected LOWER..UPPER"),
        ("mass", "mass 1..1 1..1", "malformed: unexpected words at the end of the line"),
        ("stops", "stops 17", "malformed: expected the number of stops, a number from 0 to 16"),
        ("harmonic", "harmonic 0 1..1 1..1", "malformed: k counts from 1"),
        ("orbit", "orbit 29 open", "malformed: expected the number of impacts, a number from 0 to 28"),
        ("orbit", "orbit 0 open", "malformed: the periods of an orbit must not sum to 0"),
        ("orbit", "orbit 1 maybe", "malformed: expected stable, unstable or open"),
        ("scales", "scales 1 0", "malformed: scales are above 0"),
        ("scales", "scales 1 -1", "malformed: scales are above 0"),
        ("impact", "impact 0 1 1 1 1", "malformed: stops are counted from 1"),
        ("impact", "impact 2 1 1 1 1", "malformed: expected a stop, a number from 0 to 1"),
        ("impact", "impact 1 0 1 1 1", "malformed: the periods of an orbit must not sum to 0"),
        ("row", "row 1 2", "malformed: expected a decimal, found the end of the line"),
        ("flight", "flight 0", "malformed: a flight has at least one piece"),
        // 7 (8 · 20000 + 20) + 3 (4 · 20000 + 12).
        (
            "flight",
            "flight 20000",
            "malformed: the check would take up to 1360176 exponentials, more than 1000000",
        ),
    ];
    for (start, line, expected) in cases {
        let why = rejected(&with(BALL, start, line));
        assert!(why.contains(expected), "{line}: {why}");
    }
    assert!(rejected(&(BALL.to_string() + "\n")).contains("malformed: the file goes on"));
    let long = format!("scales {}", "1 ".repeat(2500));
    assert!(rejected(&with(BALL, "scales", &long)).contains("longer than 4000 bytes"));
}
