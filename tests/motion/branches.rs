//! Branches: continuation against closed formulas, events, switching, two parameters, restarts; crisis;
//! diagrams.

use std::{
    cell::Cell,
    f64::consts::TAU,
    fs,
    io::Write,
    sync::{
        Mutex,
        atomic::{AtomicU64, Ordering},
    },
};

use grazing_scenes::{
    Error, Monitor, Result,
    attractor::{
        detection::Detection,
        diagram::{self, DiagramPlan, Look},
    },
    continuation::{
        Bifurcation, Corrector, Curve, CurveEnd, CurvePoint, Direction, Equations, Followed, Options, follow,
    },
    motion::{Harmonic, Side, State, System, Wall},
    one::{
        attractor::{
            attracting,
            crisis::{CrisisSearch as Search, crisis},
        },
        branch::{Branch, Events, Orbits, Patterns, Plane, read_label, record},
        orbit::{Family, Itinerary, Oscillator, SingleImpact, search},
        simulate::{Settings, Simulator},
    },
    scene::{Scene, SceneFamily},
};

fn nordmark(w: &str) -> Scene {
    let text = include_str!("../../examples/scenes/nordmark-2001.toml");
    Scene::from_toml(&text.replace("w = 4.9", &format!("w = {w}")), "test").unwrap()
}

fn family(scene: &Scene) -> SceneFamily<'_> {
    SceneFamily::new(scene, "mu").unwrap()
}

/// Its orbits, lengths measured by the motion's size at the scene's own µ.
fn patterns<'a>(family: &'a SceneFamily) -> Patterns<'a> {
    Patterns::new(family, family.value()).unwrap()
}

/// The curve of single-impact orbits of period n.
fn single<'a>(patterns: &'a Patterns<'a>, n: u32, range: (f64, f64)) -> Orbits<'a> {
    Orbits::over(patterns, Itinerary::at(Side::Lower, &[n]).unwrap(), range)
}

/// The branch through the exact orbit of the larger or smaller speed at µ.
fn branch(orbits: &Orbits, mu: f64, larger: bool, direction: Direction, options: &Options) -> Branch {
    let oscillator = orbits.family.family().at(mu).unwrap();
    let exact = SingleImpact::new(oscillator.system(), Side::Lower, orbits.itinerary.periods()).unwrap();
    let speeds = exact.speeds();
    let speed = speeds[if larger { speeds.len() - 1 } else { 0 }];
    let start = orbits.start(vec![exact.phase(speed), speed], mu, options).unwrap();
    Branch::follow(orbits, &start, direction, options).unwrap()
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} and {b} differ by {:e}", a - b);
}

/// The circle x² + y² = 1 with the monitors x and y − 2/3.
struct Circle(Cell<u32>);

impl Curve for Circle {
    fn equations(&self, u: &[f64]) -> Result<Equations> {
        self.0.set(self.0.get() + 1);
        Ok(Equations {
            residual: vec![u[0] * u[0] + u[1] * u[1] - 1.0],
            jacobian: vec![vec![2.0 * u[0], 2.0 * u[1]]],
        })
    }
}

impl Followed for Circle {
    type View = ();

    fn view(&self, _: &CurvePoint) -> Result<()> {
        Ok(())
    }

    fn monitors(&self, place: &CurvePoint, (): &()) -> Vec<Option<f64>> {
        vec![Some(place.u[0]), Some(place.u[1] - 2.0 / 3.0)]
    }

    fn holds(&self, (): &()) -> bool {
        true
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        vec![(0, -2.0, 2.0)]
    }
}

#[test]
fn a_circle_is_followed_through_its_folds_and_closes() {
    let corrector = Corrector { tolerance: 1e-12, steps: 8 };
    for most_step in [0.05, 0.1, 0.15] {
        let circle = Circle(Cell::new(0));
        let start = corrector.correct(&circle, &[0.6, 0.8], &[0.8, -0.6]).unwrap();
        let options = Options { most_step, ..Options::default() };
        let (steps, end) = follow(&circle, start, &options).unwrap();
        assert_eq!(end, CurveEnd::Closed);
        for step in &steps {
            near(step.place.u[0].hypot(step.place.u[1]), 1.0, 1e-14);
            near(
                step.place.tangent[0] * step.place.u[0] + step.place.tangent[1] * step.place.u[1],
                0.0,
                1e-14,
            );
        }
        let events: Vec<(usize, f64, f64)> =
            steps.iter().filter_map(|s| Some((s.event?, s.place.u[0], s.place.u[1]))).collect();
        let x = (5.0f64 / 9.0).sqrt();
        let want = [(1, x, 2.0 / 3.0), (0, 0.0, -1.0), (1, -x, 2.0 / 3.0), (0, 0.0, 1.0)];
        assert_eq!(events.len(), want.len(), "{events:?}");
        for (found, want) in events.iter().zip(&want) {
            assert_eq!(found.0, want.0);
            near(found.1, want.1, 1e-14);
            near(found.2, want.2, 1e-14);
        }
        near(steps.last().unwrap().length, TAU, 0.2);
    }
}

/// The line y = 0 with a monitor that falls steeply, turns within 0.07 below 0, and rises half as fast.
struct Valley;

impl Curve for Valley {
    fn equations(&self, u: &[f64]) -> Result<Equations> {
        Ok(Equations { residual: vec![u[1]], jacobian: vec![vec![0.0, 1.0]] })
    }
}

impl Followed for Valley {
    type View = ();

    fn view(&self, _: &CurvePoint) -> Result<()> {
        Ok(())
    }

    fn monitors(&self, place: &CurvePoint, (): &()) -> Vec<Option<f64>> {
        let x = place.u[0];
        vec![Some((9.0 * x * x + 4e-4).sqrt() - x - 0.1)]
    }

    fn holds(&self, (): &()) -> bool {
        true
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        vec![(0, -2.0, 2.0)]
    }
}

/// Wherever points lie, and either way: where the next step leads steeply down, and where the one before did.
#[test]
fn two_events_within_a_step_are_seen() {
    let corrector = Corrector { tolerance: 1e-12, steps: 8 };
    for i in 0..20 {
        for way in [1.0, -1.0] {
            let place = corrector.correct(&Valley, &[-way - 0.005 * f64::from(i), 0.0], &[way, 0.0]).unwrap();
            let place = if place.tangent[0] * way < 0.0 {
                CurvePoint { tangent: vec![way, 0.0], ..place }
            } else {
                place
            };
            let options = Options { step: 0.1, ..Options::default() };
            let (steps, end) = follow(&Valley, place, &options).unwrap();
            assert_eq!(end, CurveEnd::Bound);
            let events: Vec<f64> = steps.iter().filter(|s| s.event.is_some()).map(|s| s.place.u[0]).collect();
            // (9x² + 4e-4) = (x + 0.1)²: 8x² - 0.2x - 0.0096 = 0.
            let [low, high] = [-1.0, 1.0].map(|sign| (0.2 + sign * (0.04f64 + 32.0 * 0.0096).sqrt()) / 16.0);
            let want = if way > 0.0 { [low, high] } else { [high, low] };
            assert_eq!(events.len(), 2, "{i} {way}: {events:?}");
            near(events[0], want[0], 1e-14);
            near(events[1], want[1], 1e-14);
        }
    }
}

#[test]
fn saddle_node_and_flip_agree_with_the_closed_formulas() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let options = Options::default();
    for (n, mu, event) in [(4, -0.05, Bifurcation::SaddleNode), (3, 0.003, Bifurcation::Flip)] {
        let patterns = patterns(&family);
        let orbits = single(&patterns, n, (-0.1, 0.01));
        let found = branch(&orbits, mu, false, Direction::Both, &options);
        let exact = SingleImpact::new(family.at(0.0).unwrap().system(), Side::Lower, n).unwrap();
        let speed = if event == Bifurcation::Flip { exact.flip() } else { exact.fold() }.unwrap();
        let at = found.labelled(&format!("{} 1", event.name())).unwrap();
        near(at.parameters[0], exact.amplitude_at(speed) - 1.0, 1e-13);
        near(at.orbit.z[1], speed, if event == Bifurcation::Flip { 1e-13 } else { 1e-10 });
        for point in &found.points {
            assert!(point.orbit.residual < 1e-14, "{:e}", point.orbit.residual);
            near(exact.amplitude_at(point.orbit.z[1]) - 1.0, point.parameters[0], 1e-14);
        }
    }
}

/// The paper's numbers (section 4.2) with the digits that it leaves out, which `critical` and the proofs give
/// as well.
#[test]
fn the_branches_of_figure_6_have_the_papers_labels() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let options = Options::default();
    let four = branch(&single(&patterns(&family), 4, (-0.1, 0.01)), -0.05, true, Direction::Both, &options);
    near(four.labelled("saddle-node 1").unwrap().parameters[0], -0.084_338_470_089_59, 1e-13);
    near(four.labelled("grazing 1").unwrap().parameters[0], -0.024_447_456_305_83, 1e-13);
    near(four.labelled("fade 1").unwrap().parameters[0], 0.0, 1e-14);
    assert_eq!(four.ends, [CurveEnd::Fails, CurveEnd::Fails]);
    // Between the saddle-node and the grazing it is stable, and nowhere else.
    let events = four.labels();
    let length = |label: &str| events.iter().find(|(name, _)| *name == label).unwrap().1.length;
    let (fold, graze) = (length("saddle-node 1"), length("grazing 1"));
    for point in four.points.iter().filter(|point| point.event.is_none()) {
        let inside = (point.length - fold) * (point.length - graze) < 0.0;
        assert_eq!(point.orbit.multipliers.is_stable(), inside);
        assert!(point.orbit.admissibility.is_admissible());
    }
    let patterns = patterns(&family);
    let orbits = single(&patterns, 3, (-0.1, 0.01));
    let three = branch(&orbits, 0.003, false, Direction::Both, &options);
    let flip = three.labelled("flip 1").unwrap();
    near(flip.parameters[0], 0.005_479_046_221_249, 1e-13);
    let (born, place) = orbits.switch(Bifurcation::Flip, &flip.place).unwrap();
    let six = Branch::follow(&born, &place, Direction::Forward, &options).unwrap();
    assert_eq!(six.itinerary.to_string(), "3,3");
    let end = six.labelled("grazing 1").unwrap();
    near(end.parameters[0], 0.006_099_928_671_613, 1e-13);
    near(end.orbit.multipliers.values()[0].0, 2.153_342_692_392, 1e-9);
    // Subcritical: unstable, on the side where period 3 is stable.
    for point in &six.points[1..] {
        assert!(point.parameters[0] > flip.parameters[0] && !point.orbit.multipliers.is_stable());
    }
    // The other half of the new branch is the same orbits a period later.
    let other = Branch::follow(&born, &place, Direction::Backward, &options).unwrap();
    let other = other.labelled("grazing 1").unwrap();
    near(other.parameters[0], end.parameters[0], 1e-13);
    near(other.orbit.z[1], end.orbit.z[3], 1e-10);
}

#[test]
fn events_do_not_depend_on_the_step() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let places = |options: &Options| -> Vec<(String, f64)> {
        let four =
            branch(&single(&patterns(&family), 4, (-0.1, 0.01)), -0.05, true, Direction::Both, options);
        four.labels().into_iter().map(|(label, point)| (label.to_string(), point.parameters[0])).collect()
    };
    let reference = places(&Options::default());
    assert_eq!(reference.len(), 3);
    for most_step in [0.3, 0.03, 0.01] {
        let found = places(&Options { most_step, turn: 0.3, ..Options::default() });
        assert_eq!(found.len(), reference.len());
        for (a, b) in found.iter().zip(&reference) {
            assert_eq!(a.0, b.0);
            near(a.1, b.1, 1e-13);
        }
    }
}

#[test]
fn a_branch_followed_both_ways_meets_itself() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let options = Options { most_step: 0.03, ..Options::default() };
    let patterns = patterns(&family);
    let orbits = single(&patterns, 4, (-0.1, 0.01));
    let there = branch(&orbits, -0.05, false, Direction::Backward, &options);
    let far = there.labelled("grazing 1").unwrap();
    // Back from where it ended, past the start to the other end.
    let back =
        Branch::follow(&orbits, &far.place, Direction::Forward, &Options { points: 4000, ..options.clone() });
    let back = back.unwrap();
    near(
        back.labelled("saddle-node 1").unwrap().parameters[0],
        there.labelled("saddle-node 1").unwrap().parameters[0],
        1e-13,
    );
    let start = there.points.last().unwrap();
    assert!(back.passes(&start.orbit, start.parameters[0]));
    // And an orbit off the branch is not on it.
    let mut moved = start.orbit.clone();
    moved.z[1] += 0.01;
    assert!(!back.passes(&moved, start.parameters[0]));
}

#[test]
fn a_forbidden_excursion_ends_a_branch_or_flags_it() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let patterns = patterns(&family);
    let orbits = single(&patterns, 4, (-0.1, 0.01));
    let beyond = Options { beyond: true, ..Options::default() };
    let all = branch(&orbits, -0.05, true, Direction::Both, &beyond);
    assert_eq!(all.ends, [CurveEnd::Bound, CurveEnd::Bound]);
    let grazing = all.labelled("grazing 1").unwrap();
    near(grazing.parameters[0], -0.024_447_456_305_83, 1e-13);
    let flagged = all.points.iter().filter(|p| p.event.is_none() && !p.orbit.admissibility.is_admissible());
    assert!(flagged.clone().count() > 5);
    for point in flagged {
        assert!(point.length / grazing.length > 1.0 || point.orbit.z[1] <= 0.0, "{point:?}");
    }
    assert!(all.points.iter().all(|point| point.orbit.residual < 1e-13));
}

#[test]
fn at_the_resonance_both_multipliers_are_tau_r_cubed() {
    // With w = 4.8, E_3 is −r³ times the identity (section 4.1), so trace and determinant do not vary, for
    // any restitution.
    for tau in ["1", "0.5"] {
        let text = include_str!("../../examples/scenes/nordmark-2001.toml");
        let scene = Scene::from_toml(
            &text.replace("w = 4.9", "w = 4.8").replace("tau = 1", &format!("tau = {tau}")),
            "test",
        );
        let scene = scene.unwrap();
        let family = family(&scene);
        let found = branch(
            &single(&patterns(&family), 3, (0.0, 0.05)),
            0.01,
            false,
            Direction::Both,
            &Options::default(),
        );
        let tau: f64 = tau.parse().unwrap();
        let expected = tau * (-0.75 * std::f64::consts::PI).exp();
        assert!(found.points.len() > 5);
        for point in found.points.iter().filter(|point| point.event.is_none()) {
            // A double root: half the digits.
            near(point.orbit.multipliers.trace, 2.0 * expected, 1e-9);
            near(point.orbit.multipliers.determinant, expected * expected, 1e-13);
            for (re, im) in point.orbit.multipliers.values() {
                near((re - expected).hypot(im), 0.0, 1e-4);
            }
        }
        // It leaves the bifurcation like √µ: V² / µ tends to a constant.
        let ratio = |point: &&grazing_scenes::one::branch::BranchOrbit| {
            point.orbit.z[1].powi(2) / point.parameters[0]
        };
        let small: Vec<f64> =
            found.points.iter().filter(|p| p.parameters[0] > 1e-6).take(2).map(|p| ratio(&p)).collect();
        assert!((small[0] / small[1] - 1.0).abs() < 0.1, "{small:?}");
    }
}

/// The stable windows of period 4n with n + 1 impacts (section 4.2): they begin at a subcritical flip and end
/// by grazing.
#[test]
fn windows_of_periods_28_32_and_36() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let detection = Detection { phase: TAU / 2.0, transient: 20_000, longest: 80, ..Detection::default() };
    let start = State { t: TAU / 2.0, q: 2.6, u: 0.31 };
    let mut lengths = Vec::new();
    for (n, inside, ends) in [
        (7, -0.024_34, [-0.024_416_198_307_25, -0.024_272_274_147_74]),
        (8, -0.024_435, [-0.024_442_722_637_99, -0.024_425_632_889_05]),
        (9, -0.024_445, [-0.024_446_655_663_23, -0.024_443_936_935_25]),
    ] {
        let oscillator = family.at(inside).unwrap();
        let orbit = attracting(&oscillator, start, &detection, &Settings::default(), &()).unwrap();
        assert_eq!((orbit.itinerary.periods(), orbit.itinerary.strikes().len()), (4 * n, n as usize + 1));
        assert!(orbit.multipliers.is_stable());
        let patterns = patterns(&family);
        let orbits = Orbits::over(&patterns, orbit.itinerary.clone(), (-0.0247, -0.0232));
        let options = Options::default();
        let place = orbits.start(orbit.z, inside, &options).unwrap();
        let found = Branch::follow(&orbits, &place, Direction::Both, &options).unwrap();
        near(found.labelled("flip 1").unwrap().parameters[0], ends[0], 1e-13);
        near(found.labelled("grazing 1").unwrap().parameters[0], ends[1], 1e-13);
        near(found.labelled("fade 1").unwrap().parameters[0], -0.024_447_456_305_83, 1e-12);
        lengths.push(ends[1] - ends[0]);
    }
    // λ₁² = 0.42408² = 0.1798 in the limit.
    assert!(lengths[1] / lengths[0] < lengths[2] / lengths[1] && lengths[2] / lengths[1] < 0.1798);
}

#[test]
fn the_crisis_does_not_depend_on_where_the_manifold_is_entered() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let itinerary = Itinerary::at(Side::Lower, &[4]).unwrap();
    let at = |mu: f64| family.at(mu).unwrap();
    let exact = SingleImpact::new(at(-0.0226).system(), Side::Lower, 4).unwrap();
    let speed = exact.speeds()[0];
    let values: Vec<f64> = [(1e-4, TAU / 2.0), (1e-5, TAU / 2.0), (1e-6, 0.6 * TAU)]
        .into_iter()
        .map(|(offset, phase)| {
            let search = Search {
                itinerary: &itinerary,
                start: vec![exact.phase(speed), speed],
                phase,
                images: 2,
                offset,
                bracket: (-0.023, -0.0222),
                settings: &Settings::default(),
            };
            crisis(&family, &search).unwrap().parameter
        })
        .collect();
    near(values[0], -0.022_577_863_524, 1e-13);
    near(values[1], values[0], 1e-13);
    near(values[2], values[0], 1e-13);
}

#[test]
fn a_flip_followed_in_two_parameters_agrees_with_the_formula_and_ends_at_the_resonance() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let options = Options::default();
    let three = branch(&single(&patterns(&family), 3, (-0.1, 0.01)), 0.003, false, Direction::Both, &options);
    let flip = three.labelled("flip 1").unwrap();
    let plane = |[mu, w]: [f64; 2]| Oscillator::new(scene.plain(&[("mu", mu), ("w", w)])?, 1e-13);
    let plane = Plane::new(&plane, [0.0, 4.9]).unwrap();
    let events = Events {
        plane: &plane,
        itinerary: three.itinerary.clone(),
        event: Some(Bifurcation::Flip),
        ranges: [(-0.05, 0.05), (4.7, 5.1)],
        levels: &[],
    };
    let place = events.start(&flip.orbit.z, [flip.parameters[0], 4.9], &options).unwrap();
    let found = Branch::follow(&events, &place, Direction::Both, &options).unwrap();
    assert!(found.points.len() > 10);
    for point in &found.points {
        let system = scene.plain(&[("mu", 0.0), ("w", point.parameters[1])]).unwrap();
        let exact = SingleImpact::new(&system, Side::Lower, 3).unwrap();
        let Some(speed) = exact.flip() else { continue };
        near(point.parameters[0], exact.amplitude_at(speed) - 1.0, 1e-11);
    }
    let end = found.labels().into_iter().find(|(_, p)| (p.parameters[1] - 4.8).abs() < 1e-9);
    near(end.expect("the resonance").1.parameters[0], 0.0, 1e-12);
}

#[test]
fn a_restart_from_a_label_goes_on_as_if_never_ended() {
    let scene = nordmark("4.9");
    let family = family(&scene);
    let options = Options::default();
    let patterns = patterns(&family);
    let orbits = single(&patterns, 4, (-0.1, 0.01));
    let all = branch(&orbits, -0.05, false, Direction::Both, &options);
    let text = record(&all, &["mu"]).to_string();
    for label in ["saddle-node 1", "grazing 1"] {
        let label = read_label(&text, label).unwrap();
        let place = orbits.restart(&label, &options).unwrap();
        let again = Branch::follow(&orbits, &place, Direction::Both, &options).unwrap();
        near(again.labelled("fade 1").unwrap().parameters[0], 0.0, 1e-13);
        near(place.u[1] * all.points[0].orbit.unit, label.z[1], 1e-12);
    }
    let error = read_label(&text, "flip 7").unwrap_err().to_string();
    assert!(error.contains("saddle-node 1") && error.contains("flip 7"), "{error}");
    assert!(read_label("{}", "flip 1").unwrap_err().is_input());
    assert!(read_label(&text.replace("grazing-branch 2", "grazing-branch 9"), "grazing 1").is_err());
}

/// Where (1−λ) of the half period's map is zero, from the closed form of the symmetric orbit (computed
/// apart).
const CROSSING: f64 = 1.447_647_959_418_031_6;

/// Two walls that mirror each other: the symmetric orbit that meets both loses its symmetry where another
/// branch crosses.
#[test]
fn branches_that_cross_are_labelled_and_switched() {
    let oscillator = |force: f64| -> Result<Oscillator> {
        let wall = |offset| Some(Wall { offset, harmonics: Vec::new(), restitution: 0.8 });
        let make = |size: f64, walls: bool| System {
            damping: if walls { 0.1 } else { 0.0 },
            stiffness: if walls { 2.0 } else { 0.0 },
            forcing: vec![Harmonic { k: 1, cos: size, sin: 0.0 }],
            lower: if walls { wall(-1.0) } else { None },
            upper: if walls { wall(1.0) } else { None },
            ..System::default()
        };
        let mut slope = make(1.0, false);
        slope.lower = Some(Wall { offset: 0.0, harmonics: Vec::new(), restitution: 0.0 });
        slope.upper.clone_from(&slope.lower);
        Oscillator::with_slope(make(force, true), &slope, 1e-13)
    };
    use grazing_scenes::one::orbit::Strike;
    let itinerary = Itinerary::new(vec![
        Strike { place: Side::Lower, periods: 0 },
        Strike { place: Side::Upper, periods: 1 },
    ])
    .unwrap();
    let found = search(&oscillator(2.0).unwrap(), &itinerary, 300, 2.0);
    let start = found.iter().find(|orbit| orbit.admissibility.is_admissible()).expect("a symmetric orbit");
    let patterns = Patterns::new(&oscillator, 2.0).unwrap();
    let orbits = Orbits::over(&patterns, itinerary, (0.5, 4.0));
    let options = Options::default();
    let place = orbits.start(start.z.clone(), 2.0, &options).unwrap();
    let branch = Branch::follow(&orbits, &place, Direction::Both, &options).unwrap();
    for point in &branch.points {
        near(point.orbit.z[1], point.orbit.z[3], 1e-9);
    }
    let crossing = branch.labelled("crossing 1").unwrap();
    near(crossing.parameters[0], CROSSING, 1e-13);
    near(crossing.orbit.multipliers.values()[0].0, 1.0, 1e-7);
    // The other branch, both ways from where it crosses: each half the mirror image of the other.
    let (born, place) = orbits.switch(Bifurcation::Crossing, &crossing.place).unwrap();
    let halves = [Direction::Forward, Direction::Backward].map(|way| {
        let half = Branch::follow(&born, &place, way, &options).unwrap();
        let points =
            if way == Direction::Forward { half.points } else { half.points.into_iter().rev().collect() };
        points.into_iter().skip(1).take(3).collect::<Vec<_>>()
    });
    for (a, b) in halves[0].iter().zip(&halves[1]) {
        assert!((a.orbit.z[1] - a.orbit.z[3]).abs() > 1e-3);
        near(a.orbit.z[1], b.orbit.z[3], 1e-8);
        near(a.parameters[0], b.parameters[0], 1e-8);
    }
}

fn plan(values: usize) -> DiagramPlan {
    DiagramPlan {
        values: (0..values).map(|i| -0.0245 + 3e-6 * i as f64).collect(),
        starts: vec![State { t: TAU / 2.0, q: 2.6, u: 0.31 }, State { t: TAU / 2.0, q: 0.1, u: 0.0 }],
        look: Look { phase: TAU / 2.0, transient: 4000, points: 120, longest: 60 },
        every: 4,
    }
}

/// Keeps what it is told.
#[derive(Default)]
struct Notes(Mutex<Vec<String>>);

impl Monitor for Notes {
    fn note(&self, what: &str) {
        self.0.lock().unwrap().push(what.to_string());
    }

    fn advance(&self, _: u64) -> Result<()> {
        Ok(())
    }
}

/// Interrupts after some values.
struct Until(AtomicU64);

impl Monitor for Until {
    fn advance(&self, units: u64) -> Result<()> {
        let left = self.0.fetch_sub(units, Ordering::Relaxed);
        if left <= units { Err(Error::interrupted("enough")) } else { Ok(()) }
    }
}

#[test]
fn a_resumed_diagram_is_the_uninterrupted_one() {
    let scene = nordmark("4.9");
    let system = |mu| Simulator::new(&scene.plain(&[("mu", mu)])?, &Settings::default());
    let plan = plan(130);
    let whole = diagram::sweep(&plan, system, "test", None, &()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("checkpoint.json");
    // On one thread what is kept does not depend on who comes first.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let until = Until(AtomicU64::new(100));
    let stopped = pool.install(|| diagram::sweep(&plan, system, "test", Some(&file), &until));
    assert!(stopped.unwrap_err().is_interrupted());
    assert!(file.exists());
    // What is in the checkpoint is not done again.
    let count = AtomicU64::new(0);
    let counted = |mu| {
        count.fetch_add(1, Ordering::Relaxed);
        system(mu)
    };
    // A last line cut off by a sudden end is dropped, and said.
    fs::OpenOptions::new().append(true).open(&file).unwrap().write_all(b"0123456789abcdef {\"val").unwrap();
    let notes = Notes::default();
    let resumed = diagram::sweep(&plan, counted, "test", Some(&file), &notes).unwrap();
    let notes = notes.0.into_inner().unwrap();
    assert!(
        matches!(&notes[..], [note] if note.contains("checkpoint.json: dropped the last line")),
        "{notes:?}"
    );
    assert_eq!(resumed, whole);
    assert!((1..=66).contains(&count.load(Ordering::Relaxed)), "{count:?}");
    let refused = diagram::sweep(&plan, system, "another", Some(&file), &()).unwrap_err();
    assert!(refused.is_input() && refused.to_string().contains("another run"), "{refused}");
    // Both attractors are found at every value, and the windows of period 4 and 28 among them.
    assert!(whole.iter().all(|slice| slice.motions.len() == 2));
    assert_eq!(diagram::coexisting(&whole).count(), whole.len());
    let windows = diagram::windows(&whole);
    let has = |period, impacts| windows.iter().any(|w| (w.period, w.impacts) == (period, impacts));
    assert!(has(1, 0) && has(4, 1) && has(28, 8), "{windows:?}");
    let wide = windows.iter().find(|w| w.period == 28 && w.values > 20).unwrap();
    assert!(wide.from > -0.024_416_2 && wide.to < -0.024_272_2, "{wide:?}");
}

#[test]
fn options_are_checked_and_agree_with_their_keys() {
    let bad = [
        (Options { step: 0.0, ..Options::default() }, "step = 0"),
        (Options { most_step: 1e-3, ..Options::default() }, "most_step = 0.001"),
        (Options { turn: 2.0, ..Options::default() }, "turn = 2"),
        (Options { newton: 1, ..Options::default() }, "newton = 1"),
        (Options { tolerance: f64::NAN, ..Options::default() }, "tolerance = NaN"),
        (Options { points: 0, ..Options::default() }, "points = 0"),
    ];
    for (options, message) in bad {
        let error = options.checked().unwrap_err();
        assert!(error.is_input() && error.to_string().starts_with(message), "{error}");
    }
    let text = include_str!("../../examples/scenes/nordmark-2001.toml");
    let scene = Scene::from_toml(text, "test").unwrap();
    let task = scene.tasks.iter().find(|task| task.name == "flip").unwrap();
    match &task.kind {
        grazing_scenes::scene::Kind::BranchTask(task) => assert_eq!(task.options, Options::default()),
        other => panic!("{other:?}"),
    }
}
