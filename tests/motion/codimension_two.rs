//! Bifurcations of codimension two and the criticality of those of codimension one, on balls that bounce on a
//! table: at places from closed formulas or from another method, and by what simulated motions do on both
//! sides.
//!
//! A ball under gravity 1 with drag c, bouncing with restitution r on a table y(t), meets it once a period 2π
//! where y′(t) = W, with trace 1 + r²E − κ(1+r)² S of its Poincaré map: E = e^{−2πc}, κ = (1−E)/2πc, S =
//! −y″(t), W = (2π/(1−E))(1+rE)/(1+r) − 1/c, or for c = 0 κ = 1, W = π(1−r)/(1+r). Its determinant is r²E.

use std::f64::consts::{PI, TAU};

use grazing_scenes::{
    continuation::{
        Bifurcation, Criticality, CurveEnd, DOUBLE, Degeneracy, Direction, NormalForm, Options, Root, Sense,
    },
    motion::{Side, Time},
    one::{
        branch::{Branch, Events, Orbits, Patterns, Plane},
        orbit::{Family, Itinerary, Orbit, Oscillator, Strike, describe, find},
        simulate::{Event, Settings, Simulator},
    },
    scene::{Scene, SceneFamily},
};

/// A ball; the table's harmonics as TOML, the parameters with their values.
fn ball(parameters: &str, damping: &str, harmonics: &str, restitution: &str) -> Scene {
    let text = format!(
        "format = \"grazing-scene 1\"\ntitle = \"a ball\"\n[parameters]\n{parameters}\n[system]\ndamping = {damping}\n\
         force = -1\n[[walls]]\nside = \"lower\"\noffset = 0\nharmonics = [{harmonics}]\nrestitution = {restitution}"
    );
    Scene::from_toml(&text, "ball").unwrap()
}

/// A ball with drag c = 1/10.
fn in_air() -> Scene {
    ball("a = 0.6\nr = 1.2", "\"1/10\"", "{ sin = \"a\" }", "\"r\"")
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} and {b} differ by {:e}", a - b);
}

fn one_impact(periods: u32) -> Itinerary {
    Itinerary::at(Side::Lower, &[periods]).unwrap()
}

/// The curve of one bifurcation from an orbit at it, over two parameters.
fn curve(
    scene: &Scene,
    event: Bifurcation,
    names: [&str; 2],
    ranges: [(f64, f64); 2],
    z: &[f64],
    at: [f64; 2],
) -> Branch {
    let plane = |[x, y]: [f64; 2]| Oscillator::new(scene.plain(&[(names[0], x), (names[1], y)])?, 1e-13);
    let plane = Plane::new(&plane, at).unwrap();
    let events = Events { plane: &plane, itinerary: one_impact(1), event: Some(event), ranges, levels: &[] };
    let options = Options::default();
    let place = events.start(z, at, &options).unwrap();
    Branch::follow(&events, &place, Direction::Both, &options).unwrap()
}

/// The labels of codimension two with both parameters.
fn degenerate(branch: &Branch) -> Vec<(Degeneracy, [f64; 2])> {
    let points = branch.points.iter();
    points.filter_map(|point| Some((point.degeneracy?, [point.parameters[0], point.parameters[1]]))).collect()
}

/// Exactly these degeneracies, in any order, at these parameters.
fn expect(branch: &Branch, wanted: &[(Degeneracy, [f64; 2])], tolerance: f64) {
    let found = degenerate(branch);
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (what, at) in wanted {
        let there = |(label, place): &(Degeneracy, [f64; 2])| {
            label == what && (0..2).all(|i| (place[i] - at[i]).abs() <= tolerance)
        };
        assert!(found.iter().any(there), "{what:?} at {at:?}: {found:?}");
    }
    // Nothing else is labelled: no second name for the same thing.
    assert!(branch.points.iter().all(|point| point.event.is_none()), "{:?}", branch.labels());
}

/// E, κ, W of the ball in air at restitution r.
fn drag(r: f64) -> [f64; 3] {
    let c = 0.1;
    let e = (-TAU * c).exp();
    [e, (1.0 - e) / (TAU * c), TAU / (1.0 - e) * (1.0 + r * e) / (1.0 + r) - 1.0 / c]
}

/// Where S and W put the orbit of the ball in air: t in (0, 2π), V, and a.
fn orbit_in_air(r: f64, s: f64) -> (Vec<f64>, f64) {
    let [_, _, w] = drag(r);
    let t = s.atan2(w);
    (vec![t, TAU / (1.0 + r)], s.hypot(w))
}

/// Areas are kept where r²e^{−2πc} = 1: there lie all Neimark–Sacker points, and on them the resonances.
#[test]
fn neimark_sacker_points_and_their_resonances_are_where_areas_are_kept() {
    let scene = in_air();
    let r = (0.1 * PI).exp();
    let family = SceneFamily::new(&scene, "r").unwrap();
    let patterns = Patterns::new(&family, family.value()).unwrap();
    let orbits = Orbits::over(&patterns, one_impact(1), (0.9, 1.6));
    let options = Options::default();
    let [_, kappa, w] = drag(1.2);
    let start = (0.6f64 * 0.6 - w * w).sqrt();
    let (z, a) = orbit_in_air(1.2, start);
    near(a, 0.6, 1e-14);
    let place = orbits.start(z, 1.2, &options).unwrap();
    let branch = Branch::follow(&orbits, &place, Direction::Both, &options).unwrap();
    let labels = branch.labels();
    assert_eq!(labels.len(), 1, "{labels:?}");
    let (label, point) = &labels[0];
    assert_eq!(*label, "neimark-sacker 1");
    near(point.parameters[0], r, 1e-14);
    // The coefficient is zero, as the theory says that it always is.
    let form = NormalForm::at(&family.at(r).unwrap(), &point.orbit, Bifurcation::Torus).unwrap();
    assert_eq!(form.kind, Sense::Degenerate);
    near(form.coefficient, 0.0, 1e-13);
    assert!(kappa < 1.0);
    // Followed in a the curve ends on both sides in a double multiplier.
    let along = curve(
        &scene,
        Bifurcation::Torus,
        ["r", "a"],
        [(0.9, 1.6), (0.05, 2.0)],
        &point.orbit.z,
        [point.parameters[0], 0.6],
    );
    let [_, kappa, _] = drag(r);
    let at = |trace: f64| {
        let s = (2.0 - trace) / (kappa * (1.0 + r).powi(2));
        [r, orbit_in_air(r, s).1]
    };
    let wanted = [
        (Degeneracy::Resonance1, at(2.0)),
        (Degeneracy::Resonance4, at(0.0)),
        (Degeneracy::Resonance3, at(-1.0)),
        (Degeneracy::Resonance2, at(-2.0)),
    ];
    expect(&along, &wanted, 1e-12);
    // Beyond them multipliers are real: no Neimark–Sacker points.
    assert!(along.points.iter().all(|point| point.orbit.multipliers.trace.abs() < 2.0 + 1e-9));
}

#[test]
fn resonances_lie_on_the_curves_of_saddle_nodes_and_of_flips() {
    let scene = in_air();
    let r = (0.1 * PI).exp();
    // Saddle-nodes: S = 0. Flips: κ(1+r)² S = 2(1 + r²E).
    let (z, a) = orbit_in_air(1.25, 0.0);
    let folds = curve(&scene, Bifurcation::SaddleNode, ["r", "a"], [(1.22, 1.6), (0.0, 2.0)], &z, [1.25, a]);
    expect(&folds, &[(Degeneracy::Resonance1, [r, orbit_in_air(r, 0.0).1])], 1e-12);
    let flip = |r: f64| {
        let [e, kappa, _] = drag(r);
        orbit_in_air(r, 2.0 * (1.0 + r * r * e) / (kappa * (1.0 + r).powi(2)))
    };
    let (z, a) = flip(1.25);
    let flips = curve(&scene, Bifurcation::Flip, ["r", "a"], [(1.22, 1.6), (0.0, 2.0)], &z, [1.25, a]);
    expect(&flips, &[(Degeneracy::Resonance2, [r, flip(r).1])], 1e-12);
    // Every point of either curve is where the formulas say.
    for point in &folds.points {
        near(point.parameters[1], orbit_in_air(point.parameters[0], 0.0).1, 1e-11);
    }
    for point in &flips.points {
        near(point.parameters[1], flip(point.parameters[0]).1, 1e-11);
    }
}

/// The table A sin t − B cos t + sin(2t)/4: orbits where y′ = W, saddle-nodes where y″ = 0 too, a cusp where
/// y‴ = 0 as well. From y‴ + y′ = −3/2 cos 2t it follows that cos 2t = −2W/3, and then A and B.
#[test]
fn a_cusp_is_where_three_derivatives_of_the_table_say() {
    let scene =
        ball("A = 1\nB = 1", "0", "{ sin = \"A\", cos = \"-B\" }, { k = 2, sin = \"1/4\" }", "\"3/5\"");
    let (d, r) = (0.5, 0.6);
    let w = PI * (1.0 - r) / (1.0 + r);
    // y′ = A cos t + B sin t + d cos 2t; of the parameters at which t is a saddle-node.
    let folds = |t: f64| {
        let (along, across) = (w - d * (2.0 * t).cos(), 2.0 * d * (2.0 * t).sin());
        // A cos t + B sin t and −A sin t + B cos t.
        [along * t.cos() - across * t.sin(), along * t.sin() + across * t.cos()]
    };
    let cusp = (-w / (3.0 * d)).acos() / 2.0;
    let from = cusp + 0.3;
    let ranges = [(-2.0, 2.0), (0.5, 3.0)];
    let z = [from, TAU / (1.0 + r)];
    let found = curve(&scene, Bifurcation::SaddleNode, ["A", "B"], ranges, &z, folds(from));
    for point in &found.points {
        let want = folds(point.orbit.z[0]);
        near(point.parameters[0], want[0], 1e-11);
        near(point.parameters[1], want[1], 1e-11);
    }
    let cusps: Vec<[f64; 2]> = [cusp, PI - cusp].map(folds).to_vec();
    let inside = |at: &[f64; 2]| (0..2).all(|i| (ranges[i].0..ranges[i].1).contains(&at[i]));
    let wanted: Vec<_> = cusps.into_iter().filter(inside).map(|at| (Degeneracy::Cusp, at)).collect();
    assert!(!wanted.is_empty());
    expect(&found, &wanted, 1e-7);
}

/// The table a sin t + E (sin 3t + cos 3t). Where the doubled orbit turns round from larger to smaller a was
/// computed apart: its equations solved in 40 digits at a small difference of its two flights, and the second
/// derivative of a by that difference brought to zero.
#[test]
fn generalised_flips_are_where_the_doubled_orbit_turns_round() {
    let scene =
        ball("a = 1.3\nE = 0.001", "0", "{ sin = \"a\" }, { k = 3, sin = \"E\", cos = \"E\" }", "\"3/5\"");
    let r: f64 = 0.6;
    let w = PI * (1.0 - r) / (1.0 + r);
    let s = 2.0 * (1.0 + r * r) / (1.0 + r).powi(2);
    let z = [s.atan2(w), TAU / (1.0 + r)];
    let found = curve(&scene, Bifurcation::Flip, ["a", "E"], [(1.0, 2.4), (0.0, 0.1)], &z, [s.hypot(w), 0.0]);
    let wanted = [
        [1.480_180_585_700_640_5, 0.023_317_617_020_929_43],
        [1.656_215_406_539_152, 0.046_937_949_767_730_29],
        [1.949_367_016_477_912_7, 0.072_720_671_181_560_34],
    ];
    expect(&found, &wanted.map(|at| (Degeneracy::GeneralisedFlip, at)), 1e-8);
}

/// The incoming speeds of the last impacts of a motion that starts at an impact at time t with speed V.
fn speeds(oscillator: &Oscillator, start: [f64; 2], impacts: usize) -> Vec<f64> {
    let simulator = Simulator::new(oscillator.system(), &Settings::default()).unwrap();
    let wall = simulator.contact(Side::Lower).unwrap();
    let [q, u, _] = wall.position.at(start[0]);
    let mut run = simulator.start(Time::new(0, start[0]), q, u + wall.restitution * start[1]).unwrap();
    let mut found = Vec::new();
    while found.len() < impacts {
        match run.next(Time::new(i64::MAX / 4, 0.0)) {
            Event::Impact(impact) => found.push(-impact.velocity),
            // It came to rest, and nothing else will happen.
            Event::End(_) => break,
            _ => {}
        }
    }
    found
}

/// An orbit of one impact a period and its bifurcation in a parameter.
fn at_bifurcation<'f>(
    family: &SceneFamily<'f>,
    start: Vec<f64>,
    value: f64,
    what: Bifurcation,
) -> (Orbit, NormalForm) {
    let oscillator = family.at(value).unwrap();
    let orbit = find(&oscillator, &one_impact(1), start).unwrap();
    assert!(what.is_at(&orbit));
    let form = NormalForm::at(&oscillator, &orbit, what).unwrap();
    (orbit, form)
}

/// A saddle-node with its orbits above: a motion beside it stays there above, and leaves below.
#[test]
fn a_saddle_node_has_its_orbits_where_motions_stay() {
    let scene = ball("a = 1", "0", "{ sin = \"a\" }", "\"3/5\"");
    let family = SceneFamily::new(&scene, "a").unwrap();
    let r = 0.6;
    let fold = PI * (1.0 - r) / (1.0 + r);
    let z = vec![0.0, TAU / (1.0 + r)];
    let oscillator = family.at(fold).unwrap();
    let orbit =
        describe(&oscillator, &one_impact(1), Root { z: z.clone(), residual: 0.0, steps: 0 }).unwrap();
    let form = NormalForm::at(&oscillator, &orbit, Bifurcation::SaddleNode).unwrap();
    assert_eq!(form.kind, Sense::Above);
    // The node has sin t > 0: S = √(a² − W²) there.
    let kept = |a: f64| {
        let seen = speeds(&family.at(a).unwrap(), [0.02, z[1]], 3000);
        seen.len() == 3000 && seen.iter().all(|speed| (speed - z[1]).abs() < 0.3)
    };
    assert!(kept(fold + 1e-3) && !kept(fold - 1e-3));
}

/// A supercritical flip: beyond it motions settle on the doubled orbit, whose size is what the coefficient
/// says; before it on the single one.
#[test]
fn a_supercritical_flip_gives_birth_to_what_motions_settle_on() {
    let scene = ball("a = 1", "0", "{ sin = \"a\" }", "\"3/5\"");
    let family = SceneFamily::new(&scene, "a").unwrap();
    let r: f64 = 0.6;
    let (fold, s) = (PI * (1.0 - r) / (1.0 + r), 2.0 * (1.0 + r * r) / (1.0 + r).powi(2));
    let flip = fold.hypot(s);
    let (orbit, form) =
        at_bifurcation(&family, vec![s.atan2(fold), TAU / (1.0 + r)], flip, Bifurcation::Flip);
    assert_eq!(form.kind, Sense::Born(Criticality::Supercritical));
    let last = |a: f64| {
        let seen = speeds(&family.at(a).unwrap(), [orbit.z[0] + 0.01, orbit.z[1]], 20_000);
        [seen[seen.len() - 2], seen[seen.len() - 1]]
    };
    let [x, y] = last(flip - 2e-3);
    near(x, y, 1e-9);
    // −(1 + λ₁) = b ξ², λ₁ moving at the rate −(1+r)² (a/S)/(1 − r²) per a; ξ is along the critical direction
    // of (t, V).
    let rate = (1.0 + r).powi(2) * flip / s / (1.0 - r * r);
    let delta = 1e-4;
    let size = (rate * delta / form.coefficient).sqrt();
    let [x, y] = last(flip + delta);
    // The critical direction: (A + 1) q = 0 with A's first row ((1 − 2πS/V), 2πr/V) for c = 0.
    let v = TAU / (1.0 + r);
    let [down, across] = [2.0 - TAU * s / v, TAU * r / v];
    let part = down.abs() / down.hypot(across);
    near((x - y).abs() / 2.0, size * part, 0.02 * size * part);
}

/// A subcritical flip: beyond it motions leave however near they start; before it they leave once they start
/// beyond the doubled orbit.
#[test]
fn beyond_a_subcritical_flip_motions_leave() {
    // Beyond the first generalised flip of the test above.
    let scene =
        ball("a = 1.3\nE = 0.035", "0", "{ sin = \"a\" }, { k = 3, sin = \"E\", cos = \"E\" }", "\"3/5\"");
    let family = SceneFamily::new(&scene, "a").unwrap();
    let (a, e, r) = (1.566, 0.035, 0.6f64);
    // y′ = W and y″ = −S by Newton's method in t and a.
    let w = PI * (1.0 - r) / (1.0 + r);
    let s = 2.0 * (1.0 + r * r) / (1.0 + r).powi(2);
    let (mut t, mut a) = (0.945f64, a);
    for _ in 0..50 {
        let (sin3, cos3) = (3.0 * t).sin_cos();
        let first = a * t.cos() + 3.0 * e * (cos3 - sin3) - w;
        let second = -a * t.sin() - 9.0 * e * (sin3 + cos3) + s;
        let third = -a * t.cos() - 27.0 * e * (cos3 - sin3);
        // [y″, cos t; y‴, −sin t] (dt, da) = (first, second)
        let det = -(second - s) * t.sin() - third * t.cos();
        let dt = (-first * t.sin() - second * t.cos()) / det;
        let da = ((second - s) * second - third * first) / det;
        (t, a) = (t - dt, a - da);
    }
    let (orbit, form) = at_bifurcation(&family, vec![t, TAU / (1.0 + r)], a, Bifurcation::Flip);
    assert_eq!(form.kind, Sense::Born(Criticality::Subcritical));
    let far = |a: f64, offset: f64| {
        let seen = speeds(&family.at(a).unwrap(), [orbit.z[0] + offset, orbit.z[1]], 20_000);
        let last = &seen[seen.len() - 200..];
        last.iter().fold(0.0f64, |most, speed| most.max((speed - orbit.z[1]).abs()))
    };
    // Beyond, motions end at the same distance however near the flip is: nothing grows out of the orbit.
    let [farther, nearer] = [1e-3, 5e-4].map(|beyond| far(a + beyond, 1e-6));
    assert!(farther > 0.2 && (nearer / farther - 1.0).abs() < 0.05, "{farther} {nearer}");
    // Before, they come back from close by, and leave from beyond the doubled orbit, which is unstable.
    assert!(far(a - 1e-4, 0.02) < 1e-4 && far(a - 1e-4, 0.1) > 0.2);
}

/// Motions wind in or out at all amplitudes alike: the speeds' deviation changes by √det a period, near the
/// orbit and farther off.
#[test]
fn at_a_neimark_sacker_point_no_circle_is_born() {
    let scene = in_air();
    let family = SceneFamily::new(&scene, "r").unwrap();
    for (r, inward) in [((0.1 * PI).exp() - 1e-3, true), ((0.1 * PI).exp() + 1e-3, false)] {
        let [e, _, w] = drag(r);
        let (z, _) = orbit_in_air(r, (0.36 - w * w).sqrt());
        for offset in [1e-4, 1e-2] {
            let seen = speeds(&family.at(r).unwrap(), [z[0] + offset, z[1]], 1000);
            let size = |part: &[f64]| part.iter().fold(0.0f64, |most, speed| most.max((speed - z[1]).abs()));
            let (first, last) = (size(&seen[..100]), size(&seen[900..]));
            let rate = (last / first).ln() / 900.0;
            near(rate, (r * r * e).ln() / 2.0, 5e-5);
            assert_eq!(rate < 0.0, inward);
        }
    }
}

/// Where nothing is lost both multipliers reach −1 together: a coefficient there would be a quotient by zero.
#[test]
fn at_a_double_multiplier_there_is_no_coefficient() {
    let scene = ball("a = 1", "0", "{ sin = \"a\" }", "1");
    let family = SceneFamily::new(&scene, "a").unwrap();
    let orbit = find(&family.at(1.0).unwrap(), &one_impact(1), vec![PI / 2.0, PI]).unwrap();
    assert!(Bifurcation::Flip.is_at(&orbit));
    assert_eq!(NormalForm::at(&family.at(1.0).unwrap(), &orbit, Bifurcation::Flip), Err(DOUBLE));
}

/// Two walls that mirror each other: the pitchfork of the symmetric orbit in the damping. The places were
/// computed apart, with 30 digits: the closed-form motion from wall to wall, its multiplier −1 by differences
/// of 10⁻¹².
#[test]
fn pitchforks_of_symmetric_orbits_are_followed_in_two_parameters() {
    let text = "format = \"grazing-scene 1\"\ntitle = \"two walls\"\n[parameters]\nD = 1.5\nc = 0.1\n[system]\n\
        damping = \"c\"\nstiffness = \"1/4\"\nforcing = [{ cos = 1 }]\n\
        [[walls]]\nside = \"lower\"\noffset = \"-D\"\nrestitution = \"7/10\"\n\
        [[walls]]\nside = \"upper\"\noffset = \"D\"\nrestitution = \"7/10\"\n";
    let scene = Scene::from_toml(text, "test").unwrap();
    let strike = |side, periods| Strike { place: side, periods };
    let itinerary = Itinerary::new(vec![strike(Side::Upper, 0), strike(Side::Lower, 1)]).unwrap();
    let plane = |[d, c]: [f64; 2]| Oscillator::new(scene.plain(&[("D", d), ("c", c)])?, 1e-13);
    let plane = Plane::new(&plane, [1.0, 0.1]).unwrap();
    let events = |plane, itinerary| Events {
        plane,
        itinerary,
        event: Some(Bifurcation::Crossing),
        ranges: [(0.3, 4.0), (0.05, 0.2)],
        levels: &[],
    };
    let options = Options::default();
    let (t, v, d) = (0.273_038_442_398_711_34, 1.428_129_548_930_853_5, 1.177_166_961_538_611);
    let pitchforks = events(&plane, itinerary.clone());
    let place = pitchforks.start(&[t, v, t + PI, v], [d, 0.1], &options).unwrap();
    let found = Branch::follow(&pitchforks, &place, Direction::Both, &options).unwrap();
    let ends = [&found.points[0], &found.points[found.points.len() - 1]];
    assert_eq!(found.ends, [CurveEnd::Bound, CurveEnd::Bound]);
    let wanted = [
        (0.05, [0.225_110_009_701_173_7, 1.478_045_721_121_866_7], 1.228_988_697_716_136_7),
        (0.2, [0.351_637_009_564_887_75, 1.318_958_948_833_225_3], 1.060_664_657_854_511_2),
    ];
    for (point, (c, z, d)) in ends.into_iter().zip(wanted) {
        near(point.parameters[1], c, 0.0);
        near(point.parameters[0], d, 1e-12);
        (0..2).for_each(|i| near(point.orbit.z[i], z[i], 1e-12));
        near(point.orbit.multipliers.fold(), 0.0, 1e-12);
    }
    // Without the symmetry crossings are isolated points, and the reason is given.
    let lopsided = |[d, c]: [f64; 2]| {
        let mut system = scene.plain(&[("D", d), ("c", c)])?;
        system.force = 1e-6;
        Oscillator::new(system, 1e-13)
    };
    let lopsided = Plane::new(&lopsided, [1.0, 0.1]).unwrap();
    let error = events(&lopsided, itinerary).start(&[t, v, t + PI, v], [d, 0.1], &options).unwrap_err();
    assert!(error.is_input() && error.to_string().contains("only as pitchforks"), "{error}");
}
