//! Orbits and grazing where forces are formulas: the same machine by modes, differences of the second
//! integrator's map of a period.

use grazing_scenes::{
    continuation::{LocalMap, PatternFamily},
    many::{State, branch::Patterns, orbit::find_from},
    scene::MachineSceneFamily,
};

use super::{second::Motion, *};

fn scene(body: &str) -> Scene {
    let text = format!(
        "format = \"grazing-scene 2\"\ntitle = \"formulas\"\n[parameters]\np = 0.1\n{body}\n\
         [[walls]]\nname = \"rigid\"\nrow = [\"0.1 + 0.3*p\", -1]\noffset = \"-0.8 + 0.3*p\"\nrestitution = \"0.8 - p\"\n"
    );
    Scene::from_toml(&text, "formulas.toml").unwrap_or_else(|error| panic!("{error}"))
}

const SOFT: &str = "[[walls]]\nname = \"soft\"\nrow = [\"-1 + 0.2*p\", 0.8]\noffset = \"-0.2 + 0.1*p\"\n\
                    stiffness = \"9 + 3*p\"\ndamping = \"0.8 + 0.5*p\"\nharmonics = [{ k = 1, cos = \"0.05 + 0.1*p\" }]";

/// A machine by modes and the same by formulas; everything changes with the parameter.
fn both(more: &str) -> [Scene; 2] {
    let head = "[system]\nperiod = \"5 + 0.7*p\"\nmass = [[\"2 + 0.3*p\", 0.3], [0.3, \"0.5 + 0.2*p\"]]\n";
    let modal = "stiffness = [[\"3 + p\", -1], [\"-1 + p\", 2]]\ndamping = [[\"0.4 + 0.1*p\", -0.05], [-0.05, 0.3]]\n\
                 forcing = [{ k = 1, cos = [\"1.5 + 0.3*p\", -0.6] }]";
    let formulas = "stiffness = [[1, 0], [0, 0]]\n\
                    force = [\"-(2 + p)*q1 + q2 - (0.4 + 0.1*p)*u1 + 0.05*u2 + (1.5 + 0.3*p)*cos(t)\", \
                    \"-(-1 + p)*q1 - 2*q2 + 0.05*u1 - 0.3*u2 - 0.6*cos(t) + 0*exp(q1)\"]";
    [format!("{head}{modal}\n{more}"), format!("{head}{formulas}\n{more}")].map(|text| scene(&text))
}

/// Residuals, Jacobians and derivatives in the parameter, through soft stops and rigid ones.
#[test]
fn equations_by_formulas_are_those_by_modes() {
    for more in ["", SOFT] {
        let scenes = both(more);
        let stop = usize::from(!more.is_empty());
        let struck = Itinerary::new(vec![Strike { place: stop, periods: 1 }]).unwrap();
        let free = Itinerary::free(2).unwrap();
        for (pattern, z) in
            [(free, vec![0.1, -0.3, 0.5, -0.4]), (struck, vec![0.1, -0.3, 0.5, -0.4, 0.7, 0.6])]
        {
            let [modal, smooth] = scenes.each_ref().map(|scene| {
                let family = MachineSceneFamily::new(scene, "p").unwrap();
                assert_eq!(family.at(0.2).unwrap().0.is_smooth(), scene == &scenes[1]);
                // One unit of lengths for both.
                let known = MachineSceneFamily::new(&scenes[0], "p").unwrap();
                let unit = |family: &MachineSceneFamily| simulator(&family.at(0.2).unwrap().0).scale();
                let ratio = unit(&known) / unit(&family);
                assert!((ratio - 1.0).abs() < 1e-9, "{ratio}");
                Patterns::new(&family, 0.2, None).unwrap().equations(0.2, &pattern, &z).unwrap()
            });
            let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-10 * (1.0 + a.abs()), "{a} {b}");
            for i in 0..z.len() {
                near(modal.residual[i], smooth.residual[i]);
                near(modal.slope[i], smooth.slope[i]);
                (0..z.len()).for_each(|j| near(modal.jacobian[i][j], smooth.jacobian[i][j]));
            }
        }
    }
}

/// Orbits found from the same start, their multipliers and least gaps; grazing, its local map.
#[test]
fn orbits_and_grazings_by_formulas_are_those_by_modes() {
    let scenes = both("");
    let pattern = Itinerary::new(vec![Strike { place: 0, periods: 1 }]).unwrap();
    let [modal, smooth] = scenes.each_ref().map(|scene| simulator(&scene.machine(&[("p", 0.3)]).unwrap()));
    let starts = (0..40u32).map(|i| [f64::from(i % 8) * 0.8, 0.2 + 0.3 * f64::from(i / 8)]);
    let a = starts
        .filter_map(|start| find(&modal, &pattern, &start).ok())
        .find(|orbit| orbit.impacts[0].speed > 0.1)
        .expect("an orbit");
    let b = find(&smooth, &pattern, &[a.impacts[0].time, a.impacts[0].speed]).unwrap();
    let near =
        |a: f64, b: f64, what: &str| assert!((a - b).abs() < 1e-9 * (1.0 + a.abs()), "{what}: {a} {b}");
    a.z.iter().zip(&b.z).for_each(|(a, b)| near(*a, *b, "z"));
    for (a, b) in a.multipliers.iter().zip(&b.multipliers) {
        near(a.0, b.0, "multiplier");
        near(a.1.abs(), b.1.abs(), "multiplier");
    }
    assert_eq!(format!("{:?}", a.admissibility), format!("{:?}", b.admissibility));
    assert_eq!(a.least.is_some(), b.least.is_some());
    if let (Some(a), Some(b)) = (a.least, b.least) {
        near(a.gap, b.gap, "least gap");
    }
    let [modal, smooth] = scenes.each_ref().map(|scene| MachineSceneFamily::new(scene, "p").unwrap());
    let a = graze(&modal, -0.5, 2.0);
    let b = graze(&smooth, a.parameter - 0.001, 0.02);
    println!("{} {}, phases {} {}", a.parameter, b.parameter, a.at.phase, b.at.phase);
    near(a.parameter, b.parameter, "parameter");
    near(a.at.phase, b.at.phase, "phase");
    let entries = |map: &LocalMap| [map.a.concat(), map.b.clone(), map.c.clone()].concat();
    entries(&a.map).into_iter().zip(entries(&b.map)).for_each(|(a, b)| near(a, b, "map"));
    for (x, y) in
        [(a.map.e, b.map.e), (a.map.acceleration, b.map.acceleration), (a.map.rate_drift, b.map.rate_drift)]
    {
        near(x, y, "e, a_G or the drift");
    }
}

fn duffing(_: f64, q: &[f64], _: &[f64]) -> Vec<f64> {
    let between = 0.8 * (q[1] - q[0]).powi(3);
    vec![between - 0.5 * q[0].powi(3), -between - 0.3 * q[1].sin()]
}

fn pair(force: f64, offset: f64) -> Scene {
    let text = format!(
        "format = \"grazing-scene 2\"\ntitle = \"pair\"\n[parameters]\nF = {force}\n[system]\nperiod = \"2*pi\"\n\
         mass = [[1, 0.1], [0.1, 0.4]]\nstiffness = [[1.2, -0.4], [-0.4, 0.4]]\n\
         damping = [[0.3, -0.1], [-0.1, 0.2]]\n\
         force = [\"0.8*(q2 - q1)^3 - 0.5*q1^3\", \"-0.8*(q2 - q1)^3 - 0.3*sin(q2)\"]\n\
         forcing = [{{ k = 1, cos = [\"F\", 0.1], sin = [0, 0] }}]\n\
         [[walls]]\nrow = [0, -1]\noffset = {offset}\nrestitution = 0.6"
    );
    Scene::from_toml(&text, "pair.toml").unwrap_or_else(|error| panic!("{error}"))
}

/// The second integrator's map of periods of a machine, from phase 0.
fn mapped(machine: &Machine<f64>, x: &[f64], periods: u32) -> (Vec<f64>, usize) {
    let mut motion = Motion::new(machine, &x[..2], &x[2..]);
    motion.load = Some(duffing);
    let hits = motion.follow(TAU * f64::from(periods));
    ([motion.q, motion.u].concat(), hits.len())
}

fn differences(machine: &Machine<f64>, x: &[f64], periods: u32) -> RealMatrix {
    let h = 1e-5;
    let column = |j: usize| {
        let moved = |h: f64| {
            let mut x = x.to_vec();
            x[j] += h;
            RealVector::from_vec(mapped(machine, &x, periods).0)
        };
        (moved(h) - moved(-h)) / (2.0 * h)
    };
    RealMatrix::from_columns(&(0..4).map(column).collect::<Vec<_>>())
}

#[test]
fn multipliers_of_a_coupled_duffing_pair_are_those_of_differences() {
    let machine = pair(1.4, -0.6).machine(&[]).unwrap();
    let simulator = simulator(&machine);
    let mut run = simulator.start(Time::new(0, 0.0), &[0.0; 2], &[0.0; 2]).unwrap();
    run.finish(Time::new(500, 0.0));
    let (before, mut hits, mut after) = (run.state(), Vec::new(), None);
    let period = (1..=8)
        .find(|&period: &i64| {
            run.record(Time::new(500 + period, 0.0), |event| {
                if let grazing_scenes::many::simulate::Event::Impact(hit) = event {
                    hits.push((hit.time, -hit.velocity));
                }
            });
            apart(run.state().q(), before.q()) < 1e-8
        })
        .expect("periodic");
    assert!(!hits.is_empty());
    let mut again = simulator.start(Time::new(0, 0.0), before.q(), before.u()).unwrap();
    while after.is_none() {
        if let grazing_scenes::many::simulate::Event::Impact(_) = again.next(Time::new(period, 0.0)) {
            after = Some(again.state());
        }
    }
    let strikes = (0..hits.len()).map(|i| {
        let next = hits.get(i + 1).map_or(hits[0].0.period + period, |next| next.0.period);
        Strike { place: 0, periods: (next - hits[i].0.period) as u32 }
    });
    let pattern = Itinerary::new(strikes.collect()).unwrap();
    let start: Vec<f64> = hits.iter().flat_map(|(time, speed)| [time.phase, *speed]).collect();
    let orbit = find_from(&simulator, &pattern, &start, after.as_ref()).unwrap();
    assert_eq!(orbit.admissibility, Admissibility::Admissible);
    let x: Vec<f64> = before.q().iter().chain(before.u()).copied().collect();
    let (back, count) = mapped(&machine, &x, period as u32);
    assert_eq!(count, hits.len());
    let off = x.iter().zip(&back).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-7, "{off:e}");
    let known = differences(&machine, &x, period as u32);
    let trace: f64 = orbit.multipliers.iter().map(|x| x.0).sum();
    let product =
        orbit.multipliers.iter().fold((1.0, 0.0), |(a, b), (c, d)| (a * c - b * d, a * d + b * c)).0;
    println!(
        "period {period}, {count} impacts: {:?}, {} {}",
        orbit.multipliers,
        known.trace(),
        known.determinant()
    );
    assert!((trace - known.trace()).abs() < 1e-6, "{trace} {}", known.trace());
    assert!((product - known.determinant()).abs() < 1e-6);
}

/// Where the motion without impacts grazes: the second integrator's motion from there returns and touches;
/// its monodromy is that of differences, and the least gap opens at the rate e.
#[test]
fn a_coupled_duffing_pair_grazes_where_its_own_motion_touches() {
    let scene = pair(0.1, -1.5);
    let family = MachineSceneFamily::new(&scene, "F").unwrap();
    let found = graze(&family, 0.413, 0.02);
    let least = |force: f64| {
        let (machine, slope) = family.at(force).unwrap();
        FreeMotion::new(&machine, &slope).unwrap().least().unwrap().gap
    };
    let (h, at) = (1e-5, found.parameter);
    let e = (least(at + h) - least(at - h)) / (2.0 * h);
    println!("F = {at}, gap {:e}, e = {} {e}", found.at.gap, found.map.e);
    assert!((e - found.map.e).abs() < 1e-6 * (1.0 + e.abs()));
    // The motion at the phase of grazing as one from phase 0: the second integrator begins there.
    let (mut machine, slope) = family.at(at).unwrap();
    let motion = FreeMotion::new(&machine, &slope).unwrap();
    let state: State = motion.motion().state(0.0);
    machine.stops.clear();
    let x: Vec<f64> = [state.q(), state.u()].concat();
    let (back, _) = mapped(&machine, &x, 1);
    let off = x.iter().zip(&back).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-11, "{off:e}");
    let known = differences(&machine, &x, 1);
    let trace = found.map.trace();
    assert!((known.trace() - trace).abs() < 1e-7, "{} {trace}", known.trace());
    assert!((known.determinant() - found.map.determinant).abs() < 1e-7);
    let mut touching = Motion::new(&machine, &x[..2], &x[2..]);
    touching.load = Some(duffing);
    touching.follow(found.at.phase);
    assert!((touching.q[1] - 1.5).abs() < 1e-10, "{}", touching.q[1]);
    assert!(touching.u[1].abs() < 1e-9, "{}", touching.u[1]);
}
