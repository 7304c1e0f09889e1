//! Ranges over tolerances: where machines of the box touch and how deep they are against exact numbers, the
//! orbits that are proved against Newton's method at machines drawn at random, and what is not covered.

use grazing_scenes::{
    certificate,
    internals::random::Random,
    number::parse_rational,
    run::{CertificateFile, Findings, GrazingReport, Judgement, RangeRow, Surroundings, run},
    scene::Scene,
};
use num_rational::BigRational;

use super::grazing_found as found;
use crate::samples::one_in;

type Q = BigRational;

fn q(text: &str) -> Q {
    parse_rational(text).unwrap_or_else(|error| panic!("{error}"))
}

/// A machine: its parameters with their values, its equation and stop, the task's parameter, the tolerances,
/// and R = C²/A² as a function of its parameters' values.
struct Machine {
    parameters: &'static [(&'static str, &'static str)],
    system: &'static str,
    varied: &'static str,
    tolerance: &'static str,
    ratio: fn(Values) -> Q,
}

/// The values of parameters by their names.
type Values<'a> = &'a dyn Fn(&str) -> Q;

const MACHINES: [Machine; 4] = [
    Machine {
        parameters: &[("F", "0.5"), ("d", "0.1"), ("s", "0.3"), ("tau", "0.8")],
        system: "[system]\ndamping = \"d\"\nstiffness = \"s\"\nforcing = [{ cos = \"F\" }]\n\
                 [[stops]]\nside = \"upper\"\noffset = 1\nrestitution = \"tau\"\n",
        varied: "F",
        tolerance: "s = \"0.3%\", d = \"3%\", tau = 0.01",
        ratio: |of| {
            let detuning = of("s") - q("1");
            (&detuning * &detuning + of("d") * of("d")) / (of("F") * of("F"))
        },
    },
    // The mass moves all there is; a constant force, and a gap that is not known exactly.
    Machine {
        parameters: &[
            ("F", "1"),
            ("m", "2"),
            ("d", "0.2"),
            ("s", "0.6"),
            ("w", "0.1"),
            ("g", "1"),
            ("tau", "0.8"),
        ],
        system: "[system]\nmass = \"m\"\ndamping = \"d\"\nstiffness = \"s\"\nforce = \"w\"\n\
                 forcing = [{ cos = \"F\" }]\n[[stops]]\nside = \"upper\"\noffset = \"g\"\nrestitution = \"tau\"\n",
        varied: "F",
        tolerance: "m = [1.99, 2.02], g = 0.001",
        ratio: |of| {
            let mean = of("g") - of("w") / of("s");
            let detuning = of("s") - of("m");
            &mean * &mean * (&detuning * &detuning + of("d") * of("d")) / (of("F") * of("F"))
        },
    },
    // The gap is the parameter, beyond which the touch comes from above; the stop and the mass both move.
    Machine {
        parameters: &[("gap", "1.2"), ("d", "0.1"), ("s", "0.3"), ("a", "0.2")],
        system: "[system]\ndamping = \"d\"\nstiffness = \"s\"\nforcing = [{ cos = 0.7 }]\n\
                 [[stops]]\nside = \"lower\"\noffset = \"-gap\"\nharmonics = [{ k = 1, sin = \"a\" }]\nrestitution = 0.8\n",
        varied: "gap",
        tolerance: "d = \"3%\", a = [0.199, 0.201]",
        ratio: |of| {
            let detuning = of("s") - q("1");
            let under = &detuning * &detuning + of("d") * of("d");
            let cosine = &detuning * q("0.7") / &under;
            let sine = of("a") - of("d") * q("0.7") / under;
            of("gap") * of("gap") / (&cosine * &cosine + &sine * &sine)
        },
    },
    // The paper's oscillator touches at µ = 0, whatever its damping.
    Machine {
        parameters: &[("mu", "-0.05"), ("d", "0.6")],
        system: "[system]\ndamping = \"2*d/4.9\"\nstiffness = \"1/4.9^2\"\n\
                 [[stops]]\nside = \"lower\"\noffset = -1\nharmonics = [{ k = 1, cos = \"1 + mu\" }]\nrestitution = 1\n",
        varied: "mu",
        tolerance: "d = \"1%\"",
        ratio: |of| {
            let one = q("1");
            let amplitude = &one + of("mu");
            one / (&amplitude * &amplitude)
        },
    },
];

fn text(machine: &Machine, value: &dyn Fn(&str) -> String, task: &str) -> String {
    let parameters = machine.parameters.iter().map(|(name, _)| format!("{name} = \"{}\"\n", value(name)));
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\n{}{}[[tasks]]\nname = \"g\"\n{task}\n",
        parameters.collect::<String>(),
        machine.system
    )
}

fn as_given(machine: &Machine) -> impl Fn(&str) -> String {
    |name| machine.parameters.iter().find(|one| one.0 == name).unwrap().1.to_string()
}

fn asked(machine: &Machine, tolerance: &str, effort: u32) -> (GrazingReport, String, u8) {
    let task = format!(
        "kind = \"grazing\"\nparameter = \"{}\"\nmax_period = 4\nseen = false\nrange = {{ effort = {effort} }}\n\
         tolerance = {{ {tolerance} }}",
        machine.varied
    );
    found(&text(machine, &as_given(machine), &task))
}

/// A machine of the box, at a value of the task's parameter.
fn drawn(
    machine: &Machine,
    report: &GrazingReport,
    random: &mut Random,
    varied: Option<Q>,
) -> Vec<(String, Q)> {
    let boxed = &report.tolerance.as_ref().unwrap().parameters;
    let value = |(name, value): &(&str, &str)| {
        let known = boxed.iter().find(|one| one.name == *name);
        let found = match (&varied, known) {
            (Some(varied), _) if *name == machine.varied => varied.clone(),
            (_, Some(one)) => {
                let [lower, upper] = [&one.lower, &one.upper].map(|end| q(end));
                // Corners are where all depends on it.
                let part = match random.bits() >> 62 {
                    0 => q("0"),
                    1 => q("1"),
                    _ => Q::new((random.bits() >> 40).into(), (1u64 << 24).into()),
                };
                &lower + (&upper - &lower) * part
            }
            (_, None) => q(value),
        };
        (name.to_string(), found)
    };
    machine.parameters.iter().map(value).collect()
}

fn ratio(machine: &Machine, values: &[(String, Q)]) -> Q {
    (machine.ratio)(&|name| values.iter().find(|one| one.0 == name).unwrap().1.clone())
}

/// R = 1 is a touch, R > 1 before it; ν ≤ depth is R ≤ (1 + depth)² or R ≥ (1 − depth)².
fn depths_hold(machine: &Machine, report: &GrazingReport, row: &RangeRow, random: &mut Random) {
    let one = q("1");
    let depth = q(row.depth.as_ref().unwrap());
    let touches = row.touches.as_ref().unwrap().each_ref().map(|end| q(end));
    let end = row.end.as_ref().map(|end| q(end));
    let before = row.side == "before";
    let passed = |r: &Q| if before { *r > one } else { *r < one };
    for _ in 0..60 {
        let mut at = |p: &Q| ratio(machine, &drawn(machine, report, random, Some(p.clone())));
        let ends = touches.each_ref().map(&mut at);
        // One end is on this side of every touch, the other on the other.
        let all_at_once = ends.iter().all(|end| *end == one);
        assert!(all_at_once || passed(&ends[0]) != passed(&ends[1]), "{row:?}");
        let Some(end) = &end else { continue };
        let near = if *end > touches[1] { 1 } else { 0 };
        let one_touch = touches[0] == touches[1];
        assert!(one_touch || passed(&ends[near]) && !passed(&ends[1 - near]), "{row:?}");
        for part in 0..=if one_touch { 3 } else { 4 } {
            let p = end + (&touches[near] - end) * Q::new(part.into(), 4.into());
            let r = at(&p);
            let root = if before { &one + &depth } else { &one - &depth };
            assert!(
                passed(&r) && if before { r <= &root * &root } else { r >= &root * &root },
                "{row:?} {p}"
            );
        }
    }
}

#[test]
fn every_machine_of_a_box_touches_where_it_is_said_and_is_no_deeper() {
    let mut random = Random(11);
    for machine in MACHINES.iter().step_by(one_in(4)) {
        let (report, shown, _) = asked(machine, machine.tolerance, 5_000);
        let rows = report.range.as_ref().unwrap_or_else(|| panic!("{shown}"));
        let proved: Vec<&RangeRow> = rows.iter().filter(|row| row.depth.is_some()).collect();
        assert!(proved.len() > 1 && proved.iter().any(|row| row.end.is_some()), "{shown}");
        proved.iter().for_each(|row| depths_hold(machine, &report, row, &mut random));
        // Each certificate is of all machines: its ranges of c, k and τ are no points.
        for CertificateFile { file, accepted } in &report.certificates {
            let text = accepted.text();
            certificate::check(&mut text.as_bytes()).unwrap_or_else(|error| panic!("{file}: {error}"));
            let line = text.lines().find(|line| line.starts_with("damping ")).unwrap();
            let [lo, hi] = [1, 2].map(|i| q(line.split(' ').nth(i).unwrap()));
            assert!(lo < hi, "{line}");
        }
        assert_eq!(report.certificates.len(), proved.len());
        let shown = shown.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(shown.contains("which is at mu = 0, to the depth"), machine.varied == "mu", "{shown}");
    }
}

/// Orbits with the patterns that are born, at machines drawn at random and values within the range of all of
/// them: Newton's method finds each, and it is admissible.
#[test]
fn orbits_that_are_proved_of_all_machines_are_found_at_each() {
    let mut random = Random(5);
    let machine = &MACHINES[0];
    let (report, shown, code) = asked(machine, machine.tolerance, 120_000);
    assert_eq!(code, 0, "{shown}");
    let rows = report.range.as_ref().unwrap();
    let mut count = 0;
    for row in rows.iter().filter(|row| row.side == "before" && row.end.is_some()) {
        let patterns: Vec<&str> = match row.of {
            "orbit" => report
                .born
                .iter()
                .map(|born| born.pattern.as_str())
                .filter(|p| *p == row.periods[0].to_string())
                .collect(),
            _ => {
                let within = |pattern: &str| {
                    pattern.split(',').all(|n| row.periods.contains(&n.trim().parse().unwrap()))
                };
                report
                    .born
                    .iter()
                    .filter(|born| born.side.contains('<'))
                    .map(|born| born.pattern.as_str())
                    .filter(|p| within(p))
                    .collect()
            }
        };
        assert!(!patterns.is_empty(), "{row:?} {shown}");
        let [near, end] = [&row.touches.as_ref().unwrap()[0], row.end.as_ref().unwrap()].map(|end| q(end));
        for pattern in patterns.iter().take(3) {
            for part in [2, 15] {
                let force = &end + (&near - &end) * Q::new(part.into(), 20.into());
                let values = drawn(machine, &report, &mut random, Some(force));
                let value = |name: &str| values.iter().find(|one| one.0 == name).unwrap().1.to_string();
                let speed = 1.0;
                let task = format!("kind = \"orbit\"\norbit = {{ pattern = [{pattern}], speed = {speed} }}");
                let scene = Scene::from_toml(&text(machine, &value, &task), "o.toml").unwrap();
                let orbits = run(&scene, Surroundings::default(), &mut ()).unwrap().remove(0);
                let Some(Findings::Orbit(found)) = orbits.findings else { panic!("{orbits}") };
                assert!(
                    found.orbits.iter().any(|orbit| orbit.orbit.admissible == Judgement::Yes),
                    "{pattern} {values:?}"
                );
                count += 1;
            }
        }
    }
    assert!(count > 10, "{count}");
}

/// Beyond the touch of the paper's oscillator, with a restitution of 0.8, the orbit of one impact in three
/// periods is unstable, then stable: so it is at machines drawn at random, where all of them are told to be.
#[test]
fn parts_of_a_range_are_stable_at_every_machine() {
    let mut random = Random(3);
    let machine = &Machine {
        system: "[system]\ndamping = \"2*d/4.9\"\nstiffness = \"1/4.9^2\"\n[[stops]]\nside = \"lower\"\noffset = -1\n\
                 harmonics = [{ k = 1, cos = \"1 + mu\" }]\nrestitution = 0.8\n",
        ..MACHINES[3]
    };
    let (report, shown, _) = asked(machine, machine.tolerance, 40_000);
    let rows = report.range.as_ref().unwrap();
    let row =
        rows.iter().find(|row| row.side == "beyond" && row.of == "orbit" && row.periods == [3]).unwrap();
    let [unstable, stable] = &row.stability[..] else { panic!("{shown}") };
    assert_eq!((unstable.word, stable.word), ("unstable", "stable"));
    let begins = q(stable.from.as_ref().unwrap());
    assert!(q(&unstable.to) < begins && begins < q(&stable.to), "{shown}");
    let parts = [(q("0"), q(&unstable.to), Judgement::No), (begins, q(&stable.to), Judgement::Yes)];
    for (from, to, expected) in parts {
        for part in [1, 9, 20] {
            let mu = &from + (&to - &from) * Q::new(part.into(), 20.into());
            // Far beyond the touch the orbit is one among many.
            let mu = mu.min(q("1/20"));
            let values = drawn(machine, &report, &mut random, Some(mu));
            let value = |name: &str| values.iter().find(|one| one.0 == name).unwrap().1.to_string();
            let scene = text(machine, &value, "kind = \"orbit\"\norbit = { pattern = [3] }");
            let scene = Scene::from_toml(&scene, "o.toml").unwrap();
            let orbits = run(&scene, Surroundings::default(), &mut ()).unwrap().remove(0);
            let Some(Findings::Orbit(found)) = &orbits.findings else { panic!("{orbits}") };
            let admissible = found.orbits.iter().filter(|row| row.orbit.admissible == Judgement::Yes);
            assert!(admissible.clone().any(|row| row.orbit.stable == expected), "{values:?} {orbits}");
        }
    }
}

/// Where machines touch so far apart that no value is near the touch of all, depths are proved none the less.
#[test]
fn without_a_common_value_the_depth_is_told() {
    let (report, shown, _) = asked(&MACHINES[0], "s = \"3%\"", 9_000);
    let rows = report.range.unwrap();
    let row =
        rows.iter().find(|row| row.depth.is_some() && row.end.is_none()).unwrap_or_else(|| panic!("{shown}"));
    assert!(row.touches.is_some() && row.touch.is_none() && row.certificate.is_some(), "{shown}");
    let shown = shown.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(shown.contains("which no F has for all of them: every path of the graph"), "{shown}");
}

#[test]
fn what_ranges_over_tolerances_do_not_cover_is_said() {
    let usual = || {
        text(
            &MACHINES[0],
            &as_given(&MACHINES[0]),
            "kind = \"grazing\"\nparameter = \"F\"\nmax_period = 1\nseen = false\nrange = { effort = 2000 }\ntolerance = { s = \"1%\" }",
        )
    };
    let third =
        usual().replace("forcing = [{ cos = \"F\" }]", "forcing = [{ cos = \"F\" }, { k = 3, cos = 0.01 }]");
    let own =
        usual().replace("damping = \"d\"", "damping = \"d + F/100\"").replace("s = \"1%\"", "F = \"1%\"");
    let turns = usual()
        .replace("damping = \"d\"", "damping = \"1/10\"")
        .replace("offset = 1", "offset = \"1 + (d - 0.1)^2\"")
        .replace("s = \"1%\"", "d = 0.01");
    let sticks = usual().replace("tau = \"0.8\"", "tau = \"0\"");
    let gamma = usual().replace("s = \"1%\"", "s = [0.24, 0.32]");
    for (text, why) in [
        (&third, "one harmonic, k = 1"),
        (&own, "the task's own parameter, F, changes neither"),
        (&sticks, "a restitution above 0"),
    ] {
        let (report, shown, code) = found(text);
        assert!(code == 3 && report.range.is_none(), "{shown}");
        let said = report.range_open.unwrap();
        assert!(said.contains(why), "{said}");
    }
    for (text, why) in [(&turns, "it is not shown where all machines"), (&gamma, "gamma has not one sign")] {
        let (report, shown, code) = found(text);
        let rows = report.range.unwrap();
        assert!(code == 3 && rows.iter().all(|row| row.end.is_none()), "{shown}");
        assert!(rows.iter().any(|row| row.reason.as_ref().is_some_and(|said| said.contains(why))), "{shown}");
    }
}
