//! Machines drawn with what smooth ones lack: dry friction, given its normal force or under a stop's, kinks
//! of forces, stops with a law, wear.
//!
//! The parameter F multiplies the forcing, mu the first friction, w the frequency. The stop is where seven
//! tenths of the response without friction just reach. A machine with friction is in format 3, as older
//! formats have none.

use super::{Matrix, Plan, Random, Response, placed, tasks};

/// The scene that is drawn with a seed.
pub fn with_effects(seed: u64) -> String {
    let mut random = Random(seed ^ 0x05ee_0fef_fec7);
    random.next();
    format!("title = \"drawn with seed {seed}, with effects\"\n{}", machine(&mut random))
}

/// A chain of masses from the ground: mass, damping and stiffness.
fn chain(random: &mut Random, n: usize) -> [Matrix; 3] {
    let zero = || vec![vec![0.0; n]; n];
    let [mut mass, mut damping, mut stiffness] = [zero(), zero(), zero()];
    for i in 0..n {
        mass[i][i] = random.number(0.5, 2.0);
        let (c, k) = (random.number(0.0625, 0.375), random.number(0.5, 4.0));
        for (matrix, x) in [(&mut damping, c), (&mut stiffness, k)] {
            matrix[i][i] += x;
            if i > 0 {
                matrix[i - 1][i - 1] += x;
                (matrix[i][i - 1], matrix[i - 1][i]) = (-x, -x);
            }
        }
    }
    [mass, damping, stiffness]
}

/// A row with these entries, all others 0.
fn row(n: usize, entries: &[(usize, f64)]) -> Vec<f64> {
    let mut row = vec![0.0; n];
    entries.iter().for_each(|&(i, x)| row[i] += x);
    row
}

/// A force of a coordinate that has kinks or jumps, on a motion of this size.
fn kinked(random: &mut Random, i: usize, size: f64) -> String {
    let (q, u) = (format!("q{i}"), format!("u{i}"));
    let (a, k) = (placed(size * random.number(0.0, 0.5)), random.number(0.125, 1.0));
    match random.below(9) {
        0 => format!("-{k}*max({q} - {a}, 0)"),
        1 => format!("-{k}*min({q} + {a}, 0)"),
        2 => format!("-{}*abs({q})*{q}", k / size),
        3 => format!("-{}*abs({u})*{u}", k / 4.0),
        4 => format!("{k}*max(-{q} - {a}, 0)^1.5"),
        5 => format!("-{k}*max({q} - {a}, 0)^(3/2)"),
        6 => format!("-{}*sign({q} - {a})", k / 8.0),
        7 => format!("-{}*max({u}, 0)", k / 4.0),
        _ => format!("{}*F*max(cos(t + 1), {})", k / 4.0, random.number(-0.5, 0.5)),
    }
}

/// What the stop does, and whether it is rigid, whether by a constant, and whether a formula.
fn stop_keys(random: &mut Random, on_stop: bool) -> (String, [bool; 3]) {
    let (k, c) = (random.number(8.0, 64.0), random.number(0.0, 0.5));
    // Friction does not follow a law of the force.
    match random.below(if on_stop { 7 } else { 10 }) {
        0..=3 => (format!("restitution = {}\n", random.number(0.0, 0.875)), [true, true, false]),
        4 => ("restitution = \"0.75/(1 + v/2)\"\n".into(), [true, false, false]),
        5 | 6 => (format!("stiffness = {k}\ndamping = {c}\n"), [false, false, false]),
        7 => (format!("law = \"{k}*d^1.5*(1 + {c}*v)\"\n"), [false, false, true]),
        8 => (format!("law = \"{k}*d*(1 + {c}*v)\"\n"), [false, false, true]),
        _ => (format!("law = \"{k}*d + {}*max(d - 0.0625, 0) + {c}*v\"\n", k / 2.0), [false, false, true]),
    }
}

/// What rubs: tables, of rows that are not the stop's.
fn friction(random: &mut Random, n: usize, (on_stop, size): (bool, f64)) -> String {
    let mut all = String::new();
    let count = if n > 1 && random.chance(35) { 2 } else { 1 };
    for i in 0..count {
        let of_stop = on_stop && i == 0;
        let row = match (n, i) {
            (1, _) => row(1, &[(0, 1.0)]),
            (_, 0) => row(n, &[(0, 1.0)]),
            _ if random.chance(50) => row(n, &[(0, -1.0), (1, 1.0)]),
            _ => row(n, &[(n - 1, 1.0)]),
        };
        let normal = random.number(0.25, 2.0);
        let normal = if of_stop { "stop = \"stop\"".into() } else { format!("normal = {normal}") };
        let (coefficient, larger) = match i {
            0 => ("\"mu\"".to_string(), "\"1.5*mu\"".to_string()),
            _ => {
                let mu = random.number(0.03125, 0.1875);
                (format!("{mu}"), format!("{}", 1.25 * mu))
            }
        };
        all += &format!("[[friction]]\nrow = {row:?}\n{normal}\ncoefficient = {coefficient}\n");
        if random.chance(50) {
            all += &format!("name = \"rubbing {i}\"\n");
        }
        if random.chance(40) {
            all += &format!("static_coefficient = {larger}\n");
        }
        if random.chance(30) {
            all += &format!("speed = {}\n", random.number(-0.5, 0.5) * size);
        }
        if random.chance(25) {
            let [cos, sin] = [0, 1].map(|_| random.number(-0.25, 0.25) * size);
            all += &format!("harmonics = [{{ k = 1, cos = {cos} }}, {{ k = 2, sin = {sin} }}]\n");
        }
    }
    all
}

/// What rests, on a stop that does not give way.
const RESTS: &str = "[[tasks]]\nname = \"rests\"\nkind = \"rest\"\nperiods = 40\nstarts = 4\nlongest = 2\n";

fn machine(random: &mut Random) -> String {
    let n = 1 + random.below(3) as usize;
    let [mass, damping, stiffness] = chain(random, n);
    let [rubs, kinks, stands] = [70, 35, 85].map(|percent| random.chance(percent));
    let on_stop = rubs && stands && n > 1 && random.chance(50);
    // What presses on the stop.
    let pressed = if random.chance(if on_stop { 60 } else { 20 }) { random.number(0.25, 1.5) } else { 0.0 };
    let mut response = Response { terms: Vec::new() };
    let force =
        |i: usize, x: f64| -> Vec<[f64; 2]> { row(n, &[(i, x)]).into_iter().map(|x| [x, 0.0]).collect() };
    response.add((&mass, &damping, &stiffness), 1.0, &force(0, 1.0));
    response.add((&mass, &damping, &stiffness), 0.0, &force(n - 1, pressed));
    let mut against = row(n, &[(n - 1, 1.0)]);
    if n > 1 && random.chance(30) {
        against[n - 2] = -1.0;
    }
    let reach = placed(0.7 * response.greatest(&against));
    let size = reach.abs().max(0.125);
    let (keys, [rigid, newton, law]) = stop_keys(random, on_stop);
    let wear = if random.chance(50) { "wear = 0.015625\n" } else { "" };
    let stops = if rubs { "stops" } else { "walls" };
    let moves = match random.chance(20) {
        true => format!("harmonics = [{{ k = 1, sin = {} }}]\n", size / 8.0),
        false => String::new(),
    };
    let stop = match stands {
        true => format!(
            "[[{stops}]]\nname = \"stop\"\nrow = {:?}\noffset = {}\n{keys}{wear}{moves}",
            against.iter().map(|x| 0.0 - x).collect::<Vec<_>>(),
            -reach
        ),
        false => String::new(),
    };
    // Something is left to draw.
    let kinks = kinks || !rubs && (!stands || !law);
    let place = random.below(n as u64) as usize;
    let forces: Vec<String> = (0..n)
        .map(|i| {
            let constant = if i + 1 == n { pressed } else { 0.0 };
            match kinks && i == place {
                true => format!("\"{constant} + {}\"", kinked(random, i + 1, size)),
                false => format!("{constant}"),
            }
        })
        .collect();
    let forces = match kinks || pressed > 0.0 {
        true => format!("force = [{}]\n", forces.join(", ")),
        false => String::new(),
    };
    let friction = if rubs { friction(random, n, (on_stop, size)) } else { String::new() };
    let cosines: Vec<&str> = (0..n).map(|i| if i == 0 { "\"F\"" } else { "0" }).collect();
    let plan = Plan {
        size,
        coordinates: n,
        soft: stands && !rigid,
        linear: !kinks && newton,
        walls: None,
        free: !stands,
        response: true,
    };
    let (format, mu) = (if rubs { 3 } else { 2 }, random.number(0.03125, 0.1875));
    // How many impacts a chatter has goes with the depth, which without a key is told in the form's own
    // radians.
    let depth = size / (1u64 << 36) as f64;
    format!(
        "format = \"grazing-scene {format}\"\n[accuracy]\nminimum_depth = {depth:?}\n[parameters]\nF = 1\nmu = {mu}\nw = 1\n[system]\nperiod = \"2*pi/w\"\n\
         mass = {mass:?}\ndamping = {damping:?}\nstiffness = {stiffness:?}\n{forces}forcing = [{{ cos = [{}] }}]\n\
         {stop}{friction}{}{}",
        cosines.join(", "),
        tasks(random, &plan),
        if stands && rigid { RESTS } else { "" }
    )
}
