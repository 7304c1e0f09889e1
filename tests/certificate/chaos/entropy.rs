//! The proved entropy against simulated orbits.

use crate::samples::samples;
use std::{collections::HashSet, f64::consts::PI};

use grazing_scenes::{
    motion::Time,
    one::{
        attractor::lyapunov,
        simulate::{Event, Settings, Simulator},
    },
    scene::Scene,
};

use super::{EXAMPLE, FIGURE_10, proved};

const MU: f64 = 0.003;

fn simulator() -> Simulator {
    let system = Scene::from_toml(EXAMPLE, "test").unwrap().plain(&[("mu", MU)]).unwrap();
    Simulator::new(&system, &Settings::default()).unwrap()
}

/// How often the wall is met in each period from t = π on, and the end, for the start at x of a line of
/// states.
struct Shot {
    x: f64,
    end: [f64; 2],
    word: Vec<u8>,
}

fn shot(simulator: &Simulator, x: f64, periods: usize) -> Shot {
    let mut word = vec![0; periods];
    let mut run = simulator.start(Time::new(0, PI), 12.0 * MU * x, 40.0 * MU * x).unwrap();
    run.record(Time::new(periods as i64, PI), |event| {
        if let Event::Impact(impact) = event {
            let late = impact.time.phase >= PI;
            word[(impact.time.period - i64::from(!late)) as usize] += 1;
        }
    });
    let state = run.state();
    Shot { x, end: [state.q / MU / 5.0, state.u / MU], word }
}

/// The words of so many periods of all orbits from the line, as far as ends `apart` show them.
fn words(simulator: &Simulator, periods: usize, apart: f64) -> HashSet<Vec<u8>> {
    let mut found = HashSet::new();
    let mut open: Vec<Shot> =
        (0..=200).map(|i| shot(simulator, 1.0 - f64::from(i) / 100.0, periods)).collect();
    // The last two are neighbours on the line.
    while let [.., next, last] = &open[..] {
        let distance = (next.end[0] - last.end[0]).hypot(next.end[1] - last.end[1]);
        if distance > apart && next.x - last.x > 1e-15 {
            let middle = shot(simulator, 0.5 * (next.x + last.x), periods);
            open.insert(open.len() - 1, middle);
        } else {
            found.extend(open.pop().map(|shot| shot.word));
        }
    }
    found.extend(open.pop().map(|shot| shot.word));
    found
}

/// The topological entropy counts all orbits. Simulated from a line of states, cut so finely that the ends
/// are close, they have at least as many words as the proof says. Up to four periods all of the shift are
/// among them: those in which the wall is met at most once per period, and not missed three times in a row.
/// (11111 takes less of the line than floats can tell.)
///
/// One long orbit does not show it: on the attractor legs of one and two periods are rare, and its largest
/// Lyapunov exponent is a lower bound of the entropy only.
#[test]
fn simulated_orbits_have_the_entropy_that_is_proved() {
    let proved: f64 = proved(FIGURE_10).entropy.unwrap().parse().unwrap();
    let simulator = simulator();
    let most = 6 + samples::<u64>(1).ilog2() as usize;
    for periods in 1..=most {
        let found = words(&simulator, periods, 0.1);
        let estimate = (found.len() as f64).ln() / periods as f64;
        let near = |word: &Vec<u8>| word.iter().all(|&n| n < 2) && !word.windows(3).any(|w| w == [0, 0, 0]);
        let near = found.iter().filter(|word| near(word)).count();
        println!("{periods} periods: {} words, {near} of the shift, estimate {estimate:.4}", found.len());
        // Words of 0 and 1 without 000.
        let mut all = [1, 2, 4];
        (0..periods - 1).for_each(|_| all = [all[1], all[2], all.iter().sum()]);
        assert!(near == all[1] || (periods > 4 && near < all[1]));
        assert!(estimate >= proved, "{periods} periods: {estimate}");
    }
    let mut run = simulator.start(Time::new(0, PI), 0.0, 0.01).unwrap();
    // Legs by their periods, from 1 on; those of more than four are counted with four.
    let (mut legs, mut last) = ([0; 4], None);
    run.record(Time::new(20_000, PI), |event| {
        if let Event::Impact(impact) = event {
            let period = impact.time.period - i64::from(impact.time.phase < PI);
            if let Some(last) = last.replace(period) {
                legs[(period - last - 1).clamp(0, 3) as usize] += 1;
            }
        }
    });
    println!("legs of 1, 2, 3 and 4 periods on the attractor: {legs:?}");
    assert!(legs[0] + legs[1] > 0 && 50 * (legs[0] + legs[1]) < legs[2] + legs[3]);
    let time = Time::new(0, PI);
    let exponent = lyapunov(&simulator, time, [0.0, 0.01], 100, 20_000, &()).unwrap();
    let rate = 2.0 * PI * exponent.rate;
    println!("Lyapunov exponent {rate:.4} per period");
    assert!(0.05 < rate && rate < proved, "{rate}");
}
