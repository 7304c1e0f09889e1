//! Ranges from a touch on, found and proved, against what is known of where they end.

use grazing_scenes::{
    certificate,
    motion::{Harmonic, Side, System, Wall},
    number::{Real, parse_rational},
    search::{
        chaos::{LetterGraph, RationalFunction, Term},
        range::{
            NothingProblem, RangeEffort, RangeEnd, RangeProblem, RangeProof, TouchSide, Touching, born,
            prove, prove_alone, prove_nothing,
        },
    },
};
use num_rational::BigRational;
use num_traits::ToPrimitive;

fn at(x: &str) -> [BigRational; 2] {
    let x = parse_rational(x).unwrap();
    [x.clone(), x]
}

/// g = cos t.
fn cosine() -> Vec<Term> {
    vec![(1, [at("1"), at("0")])]
}

fn problem(parameters: [&str; 3], behind: bool, graph: LetterGraph, deepest: f64) -> RangeProblem {
    RangeProblem { mirrored: false, ranges: parameters.map(at), behind, harmonics: cosine(), graph, deepest }
}

/// README's machine and the paper's oscillator: c, k, τ.
const README: [&str; 3] = ["1/10", "3/10", "4/5"];
const PAPER: [&str; 3] = ["12/49", "100/2401", "1"];

fn range(problem: &RangeProblem, effort: u64) -> Result<RangeProof, RangeEnd> {
    let found = prove(problem, &RangeEffort::new(effort), &()).unwrap();
    if let Ok(proof) = &found {
        let checked = certificate::check(&mut proof.accepted.text().as_bytes()).unwrap();
        assert_eq!(checked.kind, "range");
        println!("{} cells, nu = {}, {:?}", proof.certificate.cells.len(), proof.depth, proof.end);
    }
    found
}

fn depth(problem: &RangeProblem, effort: u64) -> f64 {
    range(problem, effort).unwrap().depth.to_f64().unwrap()
}

/// The depth at which the curve of one impact per period folds: the greatest of −sin t (tan(t/2) − 2/κ), with
/// κ = s at the touch but for its sign.
fn fold([c, k, tau]: [f64; 3]) -> f64 {
    let (time, omega) = (std::f64::consts::TAU, (k - c * c / 4.0).sqrt());
    let decay = (-c * time / 2.0).exp();
    let b = decay * (omega * time).sin() / omega;
    let a = decay * (omega * time).cos() + c / 2.0 * b;
    let alpha = (1.0 - a) / b;
    let kappa = 2.0 * (alpha + tau * (-k * b + (a - c * b) * alpha)) / (1.0 + tau);
    let depth = |i: i32| {
        let t = f64::from(i) * -1e-4;
        -t.sin() * ((t / 2.0).tan() - 2.0 / kappa)
    };
    (1..12_000).map(depth).fold(0.0, f64::max)
}

#[test]
fn one_orbit_is_followed_towards_its_fold() {
    let proved = depth(&problem(README, false, LetterGraph::full(&[1]), 4.0), 60_000);
    let end = fold([0.1, 0.3, 0.8]);
    assert!(0.9 * end < proved && proved < end, "{proved} of {end}");
}

/// What is not born is not proved: 2 periods, slow before the touch, through the wall beyond it; and 1.
#[test]
fn what_is_not_born_has_no_range() {
    for (behind, letter, reason) in [(false, 2, "(E3)"), (true, 2, "(H4)"), (true, 1, "(E3)")] {
        let end = range(&problem(README, behind, LetterGraph::full(&[letter]), 1.0), 20_000).unwrap_err();
        let RangeEnd::Refused(why) = end else { panic!("{letter}: {end:?}") };
        assert!(why.contains(reason), "{letter}: {why}");
    }
}

/// The graphs of the word theorem, with their ranges.
#[test]
fn the_whole_graph_is_proved() {
    let ranges = |parameters: [&str; 3], behind| {
        let [c, k, _] = parameters.map(|x| parse_rational(x).unwrap());
        born(false, [&c, &k], behind, 30, &()).unwrap().unwrap()
    };
    let before = ranges(README, false);
    // 2 may follow 1 and 3, and neither itself nor be followed by itself.
    let graph = LetterGraph { letters: vec![1, 2, 3], next: vec![vec![0, 1, 2], vec![0, 2], vec![0, 2]] };
    assert_eq!(before.graph, Some(graph));
    assert!(before.whole);
    let proved = depth(&problem(README, false, before.graph.unwrap(), 4.0), 60_000);
    assert!((0.07..0.12).contains(&proved), "{proved}");
    assert_eq!(ranges(README, true).graph, None);
    let beyond = ranges(PAPER, true);
    assert_eq!(beyond.graph, Some(LetterGraph::full(&[1, 2, 3])));
    // docs/chaos.md: at about µ = 0.0049 a speed reaches 0; boxes of velocities end at µ = 0.0034.
    let proved = depth(&problem(PAPER, true, beyond.graph.unwrap(), 1.0), 60_000);
    let mu = proved / (1.0 - proved);
    assert!((0.0033..0.0049).contains(&mu), "{mu}");
    // And {1, 2} for every µ that is asked for.
    let two = problem(PAPER, true, LetterGraph::full(&[1, 2]), 0.999);
    let proof = range(&two, 10_000).unwrap();
    assert_eq!((proof.depth, proof.end), (parse_rational("999/1000").unwrap(), RangeEnd::Asked));
}

/// Beyond its touch the paper's oscillator has no other motions near, as far as {1, 2, 3} is proved; beside
/// {1, 2} alone there are, farther off; and before a touch nothing is claimed.
#[test]
fn what_is_born_is_all_that_is_near() {
    let alone = |problem: &RangeProblem| {
        let proof = range(problem, 20_000).unwrap();
        let found = prove_alone(problem, proof.clone(), &RangeEffort::new(200_000), &()).unwrap();
        assert_eq!(
            (found.depth, certificate::check(&mut found.accepted.text().as_bytes()).unwrap().kind),
            (proof.depth, "range")
        );
        (found.alone, found.accepted.text().to_string())
    };
    let all = problem(PAPER, true, LetterGraph::full(&[1, 2, 3]), 1.0);
    let (depth, text) = alone(&all);
    assert_eq!(depth, Some(range(&all, 20_000).unwrap().depth));
    assert!(!text.contains("others no") && text.contains("kind range 2\n"), "{text}");
    // Impacts between legs of 1 and 3 periods have |s| > 15: of the motions over {1, 2} it is said how near.
    let (_, text) = alone(&problem(PAPER, true, LetterGraph::full(&[1, 2]), 0.01));
    let near: Vec<f64> = text
        .lines()
        .filter_map(|line| line.strip_prefix("others ")?.split(' ').next()?.parse().ok())
        .collect();
    assert!(!near.is_empty() && near.iter().all(|&s| s < 15.0), "{near:?}");
    let (depth, _) = alone(&problem(README, false, LetterGraph::full(&[1]), 0.01));
    assert_eq!(depth, None);
}

/// README's machine is left by every motion at any amplitude beyond its touch, and by the sooner the fewer
/// rounds; where something is born that is not claimed.
#[test]
fn where_nothing_is_born_no_motion_stays() {
    let asked = |parameters: [&str; 3], deepest: f64| {
        let problem =
            NothingProblem { mirrored: false, ranges: parameters.map(at), harmonics: cosine(), deepest };
        prove_nothing(&problem, &RangeEffort::new(100_000), &()).unwrap()
    };
    let proof = asked(README, 0.999).unwrap();
    assert_eq!(
        (proof.depth, proof.periods, proof.end),
        (parse_rational("999/1000").unwrap(), 18, RangeEnd::Asked)
    );
    assert!(0.05 < proof.slope && proof.slope < 0.5, "{}", proof.slope);
    assert_eq!(certificate::check(&mut proof.accepted.text().as_bytes()).unwrap().kind, "nothing");
    // A range of parameters, and an end before what could be.
    let wide = NothingProblem {
        mirrored: false,
        ranges: [
            [at("99/1000")[0].clone(), at("1/10")[0].clone()],
            at("3/10"),
            [at("1/2")[0].clone(), at("9/10")[0].clone()],
        ],
        harmonics: cosine(),
        deepest: 0.25,
    };
    assert_eq!(
        prove_nothing(&wide, &RangeEffort::new(100_000), &()).unwrap().unwrap().depth,
        parse_rational("1/4").unwrap()
    );
    let why = asked(PAPER, 0.5).unwrap_err();
    assert!(matches!(&why, RangeEnd::Refused(why) if why.contains("(T)")), "{why:?}");
    // Without a second swing no leg's length is bounded.
    assert_eq!(asked(["3", "1/10", "4/5"], 0.5).unwrap_err(), RangeEnd::Unbounded);
    assert_eq!(prove_nothing(&wide, &RangeEffort::new(1), &()).unwrap().unwrap_err(), RangeEnd::Work);
}

/// A wall of two harmonics, and a graph that is not connected: 3 may follow 1, but not 1 follow 3.
#[test]
fn other_walls_and_graphs_have_ranges() {
    let graph = LetterGraph { letters: vec![1, 3], next: vec![vec![0, 1], vec![1]] };
    let mut problem = problem(README, false, graph, 0.01);
    assert_eq!(range(&problem, 20_000).unwrap().end, RangeEnd::Asked);
    problem.harmonics = vec![(1, [at("9/10"), at("1/10")]), (2, [at("1/10"), at("-1/20")])];
    problem.graph = LetterGraph::full(&[1]);
    let proof = range(&problem, 20_000).unwrap();
    assert_eq!(proof.end, RangeEnd::Asked);
    // The same work gives the same certificate.
    assert_eq!(range(&problem, 20_000).unwrap().accepted, proof.accepted);
}

/// README's machine, F being the amplitude of its forcing, with its stop at 1, or at 1 + F² if `bent`.
fn machine(amplitude: &RationalFunction, bent: bool) -> grazing_scenes::Result<System<RationalFunction>> {
    let number = |x: &str| RationalFunction::ratio(&parse_rational(x).unwrap(), &());
    let offset = if bent { number("1") + &(amplitude.clone() * amplitude) } else { number("1") };
    Ok(System {
        rate: None,
        damping: number("1/10"),
        stiffness: number("3/10"),
        cubic: number("0"),
        force: number("0"),
        forcing: vec![Harmonic { k: 1, cos: amplitude.clone(), sin: number("0") }],
        smooth: None,
        lower: None,
        upper: Some(Wall { offset, harmonics: Vec::new(), restitution: number("4/5") }),
    })
}

/// F/√½ is the amplitude at the stop: F = √½/(1 + ν) before the touch and √½/(1 − ν) beyond it.
#[test]
fn a_depth_is_an_amplitude_of_the_forcing() {
    let float = |x: &BigRational| x.to_f64().unwrap();
    let [start, unit, depth] = ["0.707", "0.01", "1/10"].map(|x| parse_rational(x).unwrap());
    let straight = |amplitude: &RationalFunction| machine(amplitude, false);
    for (behind, end) in [(false, 0.5f64.sqrt() / 1.1), (true, 0.5f64.sqrt() / 0.9)] {
        let touch = TouchSide::of(&straight, None, [&start, &unit], behind).unwrap().unwrap();
        let found = touch.range(&straight, &depth).unwrap().unwrap();
        let [lo, hi] = found.touch.each_ref().map(float);
        assert!(lo <= 0.5f64.sqrt() && 0.5f64.sqrt() <= hi && hi - lo < 1e-12, "{lo} {hi}");
        // Rounded inwards.
        let inside = if behind { float(&found.end) <= end } else { float(&found.end) >= end };
        assert!(inside && (float(&found.end) - end).abs() < 1e-9, "{} {end}", float(&found.end));
    }
    let all =
        Touching::of(&straight(&RationalFunction::ratio(&start, &())).unwrap(), Some(Side::Upper)).unwrap();
    assert_eq!(all.parameters, ["1/10", "3/10", "4/5"].map(at));
    // The stop at 1 + F² is above the amplitude √2 F for every F: no touch.
    let bent = |amplitude: &RationalFunction| machine(amplitude, true);
    assert!(TouchSide::of(&bent, None, [&start, &unit], true).unwrap().is_none());
}
