//! A force that is recorded once: against the closed form of each straight piece, against the same force as
//! harmonics, and what is refused.

use super::*;

/// A folder with a record, which goes when it is dropped.
fn folder(rows: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("force.csv"), format!("time,force\n{rows}")).unwrap();
    folder
}

fn scene(folder: &tempfile::TempDir, system: &str, rest: &str) -> grazing_scenes::Result<Scene> {
    let text = format!("format = \"grazing-scene 2\"\ntitle = \"recorded\"\n[system]\n{system}\n{rest}");
    Scene::from_toml(&text, folder.path().join("scene.toml").to_str().unwrap())
}

/// q″ + 2ζω q′ + ω² q = a + bt from (q, u): a particular solution that is straight, and a decaying cosine.
fn straight([zeta, omega]: [f64; 2], [a, b]: [f64; 2], [q, u]: [f64; 2], t: f64) -> [f64; 2] {
    let w = omega * (1.0 - zeta * zeta).sqrt();
    let slope = b / (omega * omega);
    let place = (a - 2.0 * zeta * b / omega) / (omega * omega);
    let (c, d) = (q - place, (u - slope + zeta * omega * (q - place)) / w);
    let (decay, (s, k)) = ((-zeta * omega * t).exp(), (w * t).sin_cos());
    let wave = decay * (c * k + d * s);
    let rate = decay * ((d * w - zeta * omega * c) * k - (c * w + zeta * omega * d) * s);
    [place + slope * t + wave, slope + rate]
}

#[test]
fn a_run_under_a_record_moves_in_closed_form_from_sample_to_sample() {
    let (zeta, omega, step) = (0.05, 7.0, 0.013);
    let force: Vec<f64> = (0..60u32).map(|i| f64::from(i * i * 37 % 101) / 20.0 - 2.0).collect();
    let rows: String =
        (0..60u32).map(|i| format!("{},{}\n", 4.0 + step * f64::from(i), force[i as usize])).collect();
    let folder = folder(&rows);
    let system = format!(
        "mass = 2\nstiffness = {}\ndamping = {}\nmeasured = {{ file = \"force.csv\", once = true }}",
        2.0 * omega * omega,
        4.0 * zeta * omega
    );
    for (more, wall) in
        [("", None), ("[[walls]]\nrow = [-1]\noffset = -0.005\nrestitution = 0.8", Some(0.005))]
    {
        let machine = scene(&folder, &system, more).unwrap().machine(&[]).unwrap();
        let length = 59.0 * step;
        assert!((machine.period - length).abs() < 1e-12);
        let simulator = simulator(&machine);
        let mut run = simulator.start(at(0.0), &[0.0], &[0.0]).unwrap();
        let (mut x, mut hits) = ([0.0; 2], 0);
        for i in 0..59usize {
            // Impacts on a piece by bisection of the closed form.
            let slope = (force[i + 1] - force[i]) / step;
            let mut left = step;
            let mut begun = 0.0;
            loop {
                let load = [(force[i] + slope * begun) / 2.0, slope / 2.0];
                let after = |t: f64| straight([zeta, omega], load, x, t);
                let grid = (1..=400).map(|k| left * f64::from(k) / 400.0);
                let beyond = grid.into_iter().find(|t| wall.is_some_and(|wall| after(*t)[0] > wall));
                let Some(mut high) = beyond else {
                    x = after(left);
                    break;
                };
                let mut low = (high - left / 400.0).max(0.0);
                for _ in 0..100 {
                    let middle = (low + high) / 2.0;
                    if after(middle)[0] > wall.unwrap() { high = middle } else { low = middle }
                }
                x = after(low);
                x[1] *= -0.8;
                hits += 1;
                (left, begun) = (left - low, begun + low);
            }
            run.finish(at(0.0).after(TAU * (i + 1) as f64 / 59.0 * (1.0 - 1e-15)));
            let state = run.state();
            let off = (state.q()[0] - x[0]).abs().max((state.u()[0] * machine.rate() - x[1]).abs() / omega);
            assert!(off < 1e-12 * (1.0 + f64::from(hits) * 10.0), "{i}: {off:e} after {hits} impacts");
        }
        assert_eq!(run.impacts(), u64::from(u32::try_from(hits).unwrap()));
        assert_eq!(wall.is_some(), hits > 0);
    }
}

/// A record of a harmonic, fine enough, moves the machine as the harmonic does, to the error of straight
/// lines; rest on a stop and formulas beside it.
#[test]
fn a_fine_record_of_a_harmonic_is_that_harmonic() {
    let folder_of = |n: u32| {
        let rows: String = (0..=n)
            .map(|i| {
                let t = f64::from(i) / f64::from(n);
                format!("{t:e},{:e}\n", 3.0 * (TAU * t).sin())
            })
            .collect();
        folder(&rows)
    };
    let body = "mass = [[1, 0], [0, 0.5]]\nstiffness = [[50, -20], [-20, 60]]\n";
    let walls = "[[walls]]\nrow = [0, -1]\noffset = -0.02\nrestitution = 0";
    for formulas in ["", "force = [\"-900*q1^3\", 0]\n"] {
        let known = scene(
            &folder_of(4),
            &format!("period = 1\n{body}{formulas}forcing = [{{ k = 1, sin = [0, 3] }}]"),
            walls,
        );
        let simulator_of = |scene: Scene| simulator(&scene.machine(&[]).unwrap());
        let end = |simulator: &Simulator| {
            let (mut rested, mut run) = (false, simulator.start(at(0.0), &[0.0; 2], &[0.0; 2]).unwrap());
            run.record(at(TAU * 0.999), |event| rested |= matches!(event, Event::Stick(_)));
            assert!(rested);
            run.state()
        };
        let known = end(&simulator_of(known.unwrap()));
        let off = |n: u32| {
            let system = format!(
                "{body}{formulas}measured = {{ file = \"force.csv\", once = true, direction = [0, 1] }}"
            );
            let found = end(&simulator_of(scene(&folder_of(n), &system, walls).unwrap()));
            apart(found.q(), known.q())
        };
        let (coarse, fine) = (off(100), off(400));
        println!("{coarse:e} {fine:e}");
        // Quartered twice: the error of straight lines is of the order of the step's square.
        assert!(fine < 1e-5 && (10.0..25.0).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
    }
}

#[test]
fn a_record_taken_once_is_for_one_run() {
    let rows: String = (0..50).map(|i| format!("{},{}\n", 0.1 * f64::from(i), i % 7)).collect();
    let folder = folder(&rows);
    let uneven = self::folder("0,1\n0.1,2\n0.2,1\n0.4,0\n0.5,0\n");
    let system = "mass = 1\nstiffness = 1\nmeasured = { file = \"force.csv\", once = true }";
    let task = |task: &str| format!("[[tasks]]\nname = \"task\"\n{task}");
    let simulate = |more: &str| task(&format!("kind = \"simulate\"\nstart = {{ q = 0 }}\n{more}"));
    let check = |folder: &tempfile::TempDir, system: &str, rest: &str| {
        let scene = scene(folder, system, rest)?;
        scene.for_task(&scene.tasks[0], &[]).map(drop)
    };
    check(&folder, system, &simulate("periods = 1")).unwrap();
    check(&folder, &format!("period = 0.5\n{system}"), &simulate("periods = 9")).unwrap();
    for (folder, system, rest, wrong) in [
        (&folder, system, simulate(""), "asks for 10 periods; the record of the force ends after 1.0"),
        (&folder, system, simulate("periods = 1\ntransient = 1"), "transient"),
        (
            &folder,
            system,
            task("kind = \"simulate\"\nstart = { q = 0, phase = 0.5 }\nperiods = 1"),
            "start.phase",
        ),
        (&folder, system, task("kind = \"section\"\nstarts = [{ q = 0 }]"), "needs a periodic force"),
        (&folder, system, task("kind = \"orbit\"\norbit = { pattern = [] }"), "needs a periodic force"),
        (&uneven, system, simulate("periods = 1"), "force.csv:5: comes 0.2 after"),
        (
            &folder,
            "mass = 1\nmeasured = { file = \"force.csv\", once = true, harmonics = 3 }",
            simulate("periods = 1"),
            "stands beside `once`",
        ),
        (
            &folder,
            "mass = 1\nfrequency = 1\nmeasured = { file = \"force.csv\" }",
            simulate("periods = 1"),
            "neither `harmonics` nor once",
        ),
        (&folder, "mass = 1", simulate("periods = 1"), "neither `frequency` nor `period`"),
    ] {
        let error = check(folder, system, &rest).unwrap_err().to_string();
        assert!(error.contains(wrong), "{system} {rest}: {error}");
    }
}

/// What the report says of the harmonics' effect on the first impact: the bound times the integral of the
/// modulus of the impulse response, in closed form; and a force of that size that always pushes the gap the
/// same way moves it by as much.
#[test]
fn what_truncation_may_do_to_the_first_impact_is_the_impulse_response_in_closed_form() {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/data/measured.toml");
    let scene = Scene::read(&path).unwrap();
    let reports =
        grazing_scenes::run::run(&scene, grazing_scenes::run::Surroundings::default(), &mut ()).unwrap();
    let report = serde_json::to_value(&reports[0]).unwrap();
    let told = |key: &str| report["measured"][key].as_f64().unwrap();
    let machine = scene.machine(&[]).unwrap();
    let simulator = simulator(&machine);
    let mut run = simulator.start(at(0.0), &[0.0], &[0.0]).unwrap();
    let Event::Impact(hit) = run.next(Time::new(5, 0.0)) else { panic!("an impact") };
    let (mass, omega, zeta): (f64, f64, f64) =
        (1.2, (90_000.0f64 / 1.2).sqrt(), 30.0 / (2.0 * (1.2f64 * 90_000.0).sqrt()));
    let (w, time) = (omega * (1.0 - zeta * zeta).sqrt(), hit.time.periods() * machine.period);
    let response = |t: f64| (-zeta * omega * t).exp() * (w * t).sin() / (mass * w);
    let steps = 1_000_000;
    let felt: f64 =
        (0..steps).map(|i| response((f64::from(i) + 0.5) * time / f64::from(steps)).abs()).sum::<f64>()
            * time
            / f64::from(steps);
    let gap = told("bound") * felt;
    println!("{gap:e} {:e}", told("gap_change"));
    assert!((told("gap_change") / gap - 1.0).abs() < 2e-3, "{gap:e} {report}");
    let late = gap / (hit.velocity.abs() * machine.rate()) / machine.period;
    assert!((told("time_change") / late - 1.0).abs() < 2e-3, "{late:e} {report}");
    // The force ±1, of the sign of the response, in pieces on which it is constant.
    let (mut x, mut now) = ([0.0; 2], 0.0);
    let half = PI / w;
    while now < time {
        // The response to come at the end of the run changes its sign when (time − t) is a multiple of π/w.
        let left = time - now;
        let turn = ((left / half * (1.0 + 1e-12)).ceil() - 1.0) * half;
        let sign = response((left + turn) / 2.0).signum();
        let step = left - turn.max(0.0);
        x = straight([zeta, omega], [sign * told("bound") / mass, 0.0], x, step);
        now += step.max(1e-12);
    }
    assert!((x[0] / gap - 1.0).abs() < 1e-5, "{} {gap}", x[0]);
}

#[test]
fn exponents_under_a_record_are_those_of_the_same_force() {
    use grazing_scenes::{
        attractor::lyapunov::exponents,
        many::section::{PlanarMachine, PlaneAxis, Start},
    };
    let rows: String = (0..101).map(|i| format!("{},5\n", 0.1 * f64::from(i))).collect();
    let folder = folder(&rows);
    let body = "period = 0.5\nmass = 2\nstiffness = 3\ndamping = 0.2\n";
    let found = [
        format!("{body}force = \"-40*q^3 - 3*u^3\"\nmeasured = {{ file = \"force.csv\", once = true }}"),
        format!("{body}force = \"5 - 40*q^3 - 3*u^3\""),
    ]
    .map(|system| {
        let machine = scene(&folder, &system, "").unwrap().machine(&[]).unwrap();
        let axes = [PlaneAxis::Place(0), PlaneAxis::Speed(0)];
        let planar = PlanarMachine::new(&machine, simulator(&machine), &axes).unwrap();
        let start = Start { t: 0.0, q: vec![0.3], u: vec![-0.5] };
        let all = exponents(&planar, &start, 2, 1, 10, &()).unwrap();
        all.iter().map(|one| one.rate).collect::<Vec<f64>>()
    });
    assert!(found[0].len() == 2 && found[0][1] < -0.02, "{found:?}");
    for (recorded, constant) in found[0].iter().zip(&found[1]) {
        assert!((recorded - constant).abs() < 1e-11, "{found:?}");
    }
}
