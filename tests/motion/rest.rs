//! Periodic motions that rest on a stop: against a second solver of free flight and chatter, both engines
//! against each other, and against where long simulations end.

use std::f64::consts::TAU;

use grazing_scenes::{
    run::{Findings, Job, Judgement, RestFindings, SimulationFindings, Surroundings, TaskReport, run_task},
    scene::Scene,
};

use crate::samples::samples;

mod several;

pub struct Random(pub u64);

impl Random {
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// q″ = f − c q′ − k q + F cos t above a wall at −1 + G sin t + H sin 2t, with the law of impact v → −τ v.
#[derive(Debug, Clone, Copy)]
struct Shaken {
    damping: f64,
    stiffness: f64,
    force: f64,
    drive: f64,
    shake: f64,
    /// Of the wall's second harmonic.
    second: f64,
    tau: f64,
}

impl Shaken {
    fn text(&self, engine: &str, task: &str) -> String {
        let Shaken { damping, stiffness, force, drive, shake, second, tau } = self;
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = \"{engine}\"\n[parameters]\nx = 1\ntau = {tau}\n[system]\ndamping = {damping}\nstiffness = {stiffness}\nforce = {force}\nforcing = [{{ cos = \
             {drive} }}]\n[[stops]]\nside = \"lower\"\noffset = -1\nharmonics = [{{ sin = {shake} }}, {{ k = 2, sin = {second} }}]\nrestitution = \
             \"tau\"\n[[tasks]]\nname = \"r\"\n{task}\n"
        )
    }

    fn wall(&self, t: f64) -> [f64; 3] {
        let ((sin, cos), (twice, turn)) = (t.sin_cos(), (2.0 * t).sin_cos());
        let (one, two) = (self.shake, self.second);
        [one * sin + two * twice - 1.0, one * cos + 2.0 * two * turn, -one * sin - 4.0 * two * twice]
    }

    /// z″ of what rests on the wall.
    fn bend(&self, t: f64) -> f64 {
        let [q, u, a] = self.wall(t);
        self.force - self.damping * u - self.stiffness * q + self.drive * t.cos() - a
    }

    /// The free motion, in closed form.
    fn free(&self, [t, q, u]: [f64; 3], time: f64) -> [f64; 2] {
        let (c, k) = (self.damping, self.stiffness);
        // The forced part: f/k, and (k − 1, c) turned.
        let size = (k - 1.0).powi(2) + c * c;
        let (a, b) = (self.drive * (k - 1.0) / size, self.drive * c / size);
        let forced = |t: f64| {
            let (sin, cos) = t.sin_cos();
            [self.force / k + a * cos + b * sin, b * cos - a * sin]
        };
        let [start, end] = [forced(t), forced(t + time)];
        let (x, v) = (q - start[0], u - start[1]);
        let omega = (k - c * c / 4.0).sqrt();
        let (sin, cos) = (omega * time).sin_cos();
        let (decay, rate) = ((-c / 2.0 * time).exp(), (v + c / 2.0 * x) / omega);
        let place = decay * (x * cos + rate * sin);
        let speed = decay * ((omega * rate - c / 2.0 * x) * cos - (omega * x + c / 2.0 * rate) * sin);
        [place + end[0], speed + end[1]]
    }

    /// Where the wall lets go, in radians.
    fn releases(&self) -> Vec<f64> {
        let step = TAU / 5000.0;
        let starts = (0..5000).map(|i| (f64::from(i) + 0.3) * step);
        let found = starts.filter(|&t| self.bend(t) < 0.0 && self.bend(t + step) >= 0.0);
        found
            .map(|t| {
                let (mut lo, mut hi) = (t, t + step);
                for _ in 0..60 {
                    let middle = (lo + hi) / 2.0;
                    if self.bend(middle) < 0.0 { lo = middle } else { hi = middle }
                }
                lo.rem_euclid(TAU)
            })
            .collect()
    }

    /// From a release: when it is let go next, when the rest before that begins, the greatest speed; none if
    /// that is not within so many periods. Not to be told where bounces fade just as the wall lets go.
    fn flight(&self, release: f64, releases: &[f64], periods: f64) -> Result<Option<[f64; 3]>, &'static str> {
        let [q, u, _] = self.wall(release);
        let (mut at, mut fastest) = ([release, q, u], 0.0f64);
        let mut first = true;
        while at[0] < release + TAU * periods {
            let gap = |s: f64| self.free(at, s)[0] - self.wall(at[0] + s)[0];
            let leaving = at[2] - self.wall(at[0])[1];
            let press = -self.bend(at[0]);
            // A bounce takes some 2 w/g; what leaves from rest falls back later.
            let bounce = if press > 0.0 { 2.0 * leaving / press } else { 1.0 };
            let step = if first { 1e-3 } else { (0.05 * bounce).clamp(1e-9, 1e-3) };
            let mut s = step;
            while gap(s) > 0.0 {
                s += step.max(1e-3 * s).min(1e-3);
                if s > TAU * periods {
                    return Ok(None);
                }
            }
            let (mut lo, mut hi) = ((s - step.max(1e-3 * s).min(1e-3)).max(0.0), s);
            for _ in 0..70 {
                let middle = (lo + hi) / 2.0;
                if gap(middle) > 0.0 { lo = middle } else { hi = middle }
            }
            let [_, u] = self.free(at, lo);
            let t = at[0] + lo;
            let [place, rate, _] = self.wall(t);
            let speed = rate - u;
            fastest = fastest.max(speed);
            at = [t, place, rate + self.tau * speed];
            first = false;
            let press = -self.bend(t);
            // Its last bounces as a geometric series.
            let last = 2.0 * self.tau * speed / press;
            if press > 0.0 && last < 3e-6 {
                let rest = t + last / (1.0 - self.tau);
                if self.bend(rest) >= 0.0 {
                    return Err("bounces fade where it lets go");
                }
                let next = releases.iter().map(|x| x + TAU * ((rest - x) / TAU).ceil());
                return Ok(next.min_by(f64::total_cmp).map(|next| [next, rest, fastest]));
            }
            if press <= 0.0 && speed < 1e-7 {
                return Err("a touch where it lets go");
            }
        }
        Ok(None)
    }
}

fn run(text: &str) -> TaskReport {
    let scene = Scene::from_toml(text, "rest.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
    run_task(&job, &mut ())
}

fn found(text: &str) -> RestFindings {
    let report = run(text);
    match report.findings {
        Some(Findings::Rest(found)) => *found,
        other => panic!("{other:?} {:?}", report.status),
    }
}

fn near(a: f64, b: f64, most: f64) {
    let turn = (a - b + 0.5).rem_euclid(1.0) - 0.5;
    assert!(turn.abs() < most, "{a} {b}");
}

const TASK: &str = "kind = \"rest\"\nperiods = 40";

/// Random machines of both engines: each release, each flight, each orbit.
#[test]
fn rests_are_those_of_a_second_solver() {
    let mut random = Random(40);
    let mut between = |lo: f64, hi: f64| lo + (hi - lo) * random.uniform();
    let (mut flights, mut open, mut orbits, mut several, mut twice) = (0, 0, 0, 0, 0);
    let draws: u64 = samples(50);
    for draw in 0..draws {
        // Underdamped: the closed form is.
        let stiffness = between(0.005, 0.4);
        let machine = Shaken {
            damping: between(0.05, 0.9) * 2.0 * f64::sqrt(stiffness),
            stiffness,
            force: between(-2.0, -0.5),
            drive: between(0.0, 1.5),
            shake: between(0.3, 4.0),
            second: if draw % 2 == 0 { 0.0 } else { between(-1.0, 1.0) },
            tau: between(0.0, 0.6),
        };
        let releases = machine.releases();
        for engine in ["one", "many"] {
            let found = found(&machine.text(engine, TASK));
            assert_eq!(found.releases.len(), releases.len(), "{machine:?}");
            for row in &found.releases {
                let at = releases.iter().min_by(|a, b| {
                    let apart = |x: &f64| (x / TAU - row.phase).abs();
                    apart(a).total_cmp(&apart(b))
                });
                let at = *at.unwrap();
                near(at / TAU, row.phase, 1e-12);
                match machine.flight(at, &releases, 39.5) {
                    Err(_) => open += 1,
                    Ok(Some([next, ..])) => {
                        let after = row.after.unwrap_or_else(|| panic!("{machine:?} {row:?}"));
                        assert!((after - (next - at) / TAU).abs() < 1e-9, "{machine:?} {row:?}");
                        near(row.next_phase.unwrap(), next / TAU, 1e-9);
                        flights += 1;
                    }
                    Ok(None) => assert!(row.after.is_none_or(|after| after > 39.0), "{machine:?} {row:?}"),
                }
            }
            for orbit in &found.orbits {
                let fastest = orbit.released.iter().zip(0..).map(|(phase, i)| {
                    let [next, rest, fastest] =
                        machine.flight(phase * TAU, &releases, 60.0).unwrap().unwrap();
                    let after = (i + 1) % orbit.released.len();
                    near(orbit.released[after], next / TAU, 1e-9);
                    near(orbit.rested[after], rest / TAU, 1e-7);
                    fastest
                });
                let fastest = fastest.fold(0.0, f64::max);
                assert!((orbit.fastest - fastest).abs() < 1e-7, "{machine:?} {orbit:?} {fastest}");
                assert_eq!(orbit.stable, Judgement::Yes);
                orbits += 1;
                several += u64::from(orbit.period > 1);
                twice += u64::from(orbit.released.len() > 1);
            }
        }
    }
    println!(
        "{flights} flights, {open} open, {orbits} orbits, {several} of several periods, {twice} with several rests"
    );
    assert!(
        open * 50 < flights
            && flights >= draws
            && orbits >= draws
            && (draws < 200 || several >= draws / 40)
            && twice >= draws / 20,
        "{flights} {orbits} {several} {twice}"
    );
}

/// Where a motion that has an orbit with a rest ends, the orbit is listed: as many impacts and rests.
#[test]
fn simulations_that_rest_end_on_a_listed_orbit() {
    let machine =
        Shaken { damping: 0.2, stiffness: 0.1, force: -1.0, drive: 0.3, shake: 1.6, second: 0.0, tau: 0.4 };
    for engine in ["one", "many"] {
        let listed = found(&machine.text(engine, TASK));
        let [orbit] = &listed.orbits[..] else { panic!("{listed:?}") };
        for q in [-0.9, 0.0, 1.0, 3.0] {
            let periods = 60 * orbit.period;
            let task = format!(
                "kind = \"simulate\"\nstart = {{ phase = 0.25, q = {} }}\ntransient = 100\nperiods = {periods}",
                q + 2.0
            );
            let report = run(&machine.text(engine, &task));
            let Some(Findings::Simulation(end)) = report.findings else { panic!("{:?}", report.status) };
            let end: SimulationFindings = *end;
            let json = serde_json::to_value(&end).unwrap();
            assert_eq!(json["rests"], 60 * orbit.released.len(), "{q}");
            assert_eq!(json["impacts"], 60 * orbit.impacts, "{q}");
        }
    }
}

/// Lengths, the period and the upper side: the same phases, and speeds in their unit.
#[test]
fn rests_do_not_change_with_the_form_of_the_scene() {
    let machine =
        Shaken { damping: 0.2, stiffness: 0.1, force: -1.0, drive: 0.3, shake: 1.6, second: 0.0, tau: 0.4 };
    let text = machine.text("many", TASK);
    let one = found(&text);
    assert!(!one.orbits.is_empty());
    let upper = text
        .replace("force = -1", "force = 1")
        .replace("cos = 0.3", "cos = -0.3")
        .replace("lower", "upper")
        .replace("offset = -1", "offset = 1")
        .replace("sin = 1.6", "sin = -1.6");
    let large = text
        .replace("force = -1", "force = -1024")
        .replace("cos = 0.3", "cos = 307.2")
        .replace("offset = -1", "offset = -1024")
        .replace("sin = 1.6", "sin = 1638.4");
    let slow = text.replace("[system]\n", "[system]\nperiod = \"4*pi\"\n");
    let slow = slow.replace("damping = 0.2", "damping = 0.1").replace("stiffness = 0.1", "stiffness = 0.025");
    let slow = slow.replace("force = -1", "force = -0.25").replace("cos = 0.3", "cos = 0.075");
    for (form, speed) in [(upper, 1.0), (large, 1024.0), (slow, 0.5)] {
        let other = found(&form);
        assert_eq!(other.orbits.len(), one.orbits.len());
        for (a, b) in one.orbits.iter().zip(&other.orbits) {
            assert_eq!((a.period, a.impacts, a.stable), (b.period, b.impacts, b.stable));
            for (x, y) in a.released.iter().chain(&a.rested).zip(b.released.iter().chain(&b.rested)) {
                near(*x, *y, 1e-9);
            }
            assert!((a.fastest * speed - b.fastest).abs() < 1e-9 * b.fastest, "{a:?} {b:?}");
        }
    }
}

/// A wall that moves a thousand times in the scene's period: in a thousandth of it all is as with one that
/// moves once.
#[test]
fn fast_walls_let_go_as_slow_ones_do() {
    let mut slow = None;
    for k in [1, 250, 1000] {
        for engine in ["one", "many"] {
            let shake = 1.2 / f64::from(k * k);
            let text = format!(
                "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = \"{engine}\"\n[system]\nforce = \
                 -1\n[[stops]]\nside = \"lower\"\noffset = 0\nharmonics = [{{ k = {k}, sin = {shake:e} \
                 }}]\nrestitution = 0.5\n[[tasks]]\nname = \"r\"\n{TASK}\n"
            );
            let found = found(&text);
            assert_eq!(found.releases.len(), k as usize);
            for (i, row) in (0..).zip(&found.releases) {
                let phase = ((1.0 / 1.2f64).asin() / TAU + f64::from(i)) / f64::from(k);
                near(row.phase, phase, 1e-9 / f64::from(k));
                near(row.next_phase.unwrap(), phase + 1.0 / f64::from(k), 1e-9);
                assert!((row.after.unwrap() * f64::from(k) - 1.0).abs() < 1e-6, "{row:?}");
            }
            let [orbit] = &found.orbits[..] else { panic!("{:?}", found.orbits) };
            assert_eq!((orbit.period, orbit.released.len()), (1, k as usize));
            let slow = *slow.get_or_insert(orbit.resting);
            assert!((orbit.resting - slow).abs() < 1e-5, "{k} {engine}: {} {slow}", orbit.resting);
        }
    }
}

/// What does not rest, what rests for ever, and what is never let go.
#[test]
fn where_nothing_rests_periodically_why_is_said() {
    let still =
        Shaken { damping: 0.2, stiffness: 0.1, force: -1.0, drive: 0.0, shake: 0.5, second: 0.0, tau: 0.5 };
    let lifted = Shaken { force: 3.0, ..still };
    let bounces = Shaken { shake: 2.3, second: 0.0, tau: 1.0, ..still };
    // The force of contact just falls to 0, and grows again.
    let held = Shaken { damping: 0.0, stiffness: 0.0, shake: 1.0, ..still };
    for engine in ["one", "many"] {
        let found = found(&still.text(engine, TASK));
        let [row] = &found.orbits[..] else { panic!("{found:?}") };
        assert_eq!(
            (row.held.join(" "), row.period, row.resting, row.stable),
            ("lower".into(), 1, 1.0, Judgement::Yes)
        );
        // The wall at phase 0.
        assert!((row.q[0] + 1.0).abs() < 1e-15 && (row.u[0] - 0.5).abs() < 1e-15, "{row:?}");
    }
    for (machine, why) in [
        (lifted, "nothing rests: no stop presses at any phase"),
        (held, "it is not let go there"),
        (bounces, "it does not come to rest within 40 periods"),
    ] {
        let report = run(&machine.text("one", TASK));
        let said = report.to_string();
        assert!(said.contains(why), "{said}");
        assert_eq!(report.status.outcome().code(), 3);
    }
    // Over a parameter, each value by itself.
    let task = "kind = \"rest\"\nperiods = 40\nparameter = \"tau\"\nvalues = [0.3, 1]";
    let found = found(&bounces.text("one", task));
    assert!(found.orbits.iter().all(|row| row.value == Some(0.3)) && !found.orbits.is_empty());
    assert_eq!(found.releases.iter().filter(|row| row.value == Some(1.0)).count(), bounces.releases().len());
}

#[test]
fn what_cannot_rest_so_is_refused_by_name() {
    let machine =
        Shaken { damping: 0.2, stiffness: 0.1, force: -1.0, drive: 0.3, shake: 2.3, second: 0.0, tau: 0.4 };
    let text = machine.text("many", TASK);
    let many = text.replace("periods = 40", "starts = 0");
    let long = text.replace("periods = 40", "longest = 101");
    let soft = text.replace("restitution = \"tau\"", "stiffness = 100");
    let alone = text.replace("periods = 40", "parameter = \"tau\"");
    let none = text.replace("periods = 40", "periods = 0");
    for (text, why) in [
        (&many, "starts = 0"),
        (&long, "longest = 101"),
        (&soft, "needs a rigid stop to rest on"),
        (&alone, "parameter and values belong together"),
        (&none, "periods"),
    ] {
        let error = Scene::from_toml(text, "rest.toml").unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    }
}
