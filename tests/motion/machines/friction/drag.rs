//! Dry friction beside forces with kinks, which turn where what slides does: counts and times against the
//! second solver.

use std::collections::BTreeMap;

use super::{super::*, in_a_row, numbers, rough::Rough, scene, told};
use crate::samples::samples;

/// The drag on each coordinate, over |u| u.
const DRAG: [f64; 2] = [0.5, 0.25];

fn dragged(u: &[f64]) -> Vec<f64> {
    u.iter().zip(DRAG).map(|(u, drag)| -drag * u.abs() * u).collect()
}

/// Random machines of one or two coordinates with quadratic drag and one or two rough rows, some on belts:
/// every stick, release and reversal, its time, and how often each velocity turns.
#[test]
fn random_machines_with_drag_stick_as_often_as_a_second_solver_says() {
    let trials: u32 = samples(2);
    let mut random = numbers(6_364_136_223_846_793_005);
    let mut words: BTreeMap<&str, u32> = BTreeMap::new();
    let mut kinks = 0;
    for trial in 0..trials {
        let mut between = |low: f64, high: f64| random(low, high);
        let n = 1 + trial as usize % 2;
        let [k, l, m] = [between(0.5, 5.0), between(0.5, 2.0), between(0.5, 2.0)];
        let matrices = in_a_row(n, [k, l, m]);
        let drag: Vec<String> =
            (0..n).map(|i| format!("\"-{}*abs(u{})*u{}\"", DRAG[i], i + 1, i + 1)).collect();
        let cos: Vec<f64> = (0..n).map(|_| between(0.5, 2.0)).collect();
        let system = format!(
            "period = \"2*pi\"\n{matrices}force = [{}]\nforcing = [{{ cos = {cos:?} }}]\n",
            drag.join(", ")
        );
        let rub = |row: &[f64], most: f64, speed: f64, more: f64| {
            format!(
                "[[friction]]\nrow = {row:?}\nnormal = 1\ncoefficient = {most:?}\nstatic_coefficient = {:?}\nspeed = {speed:?}\n",
                most * more
            )
        };
        let speed = if trial % 5 == 4 { between(-0.3, 0.3) } else { 0.0 };
        let more = if trial % 3 == 2 { between(1.0, 1.5) } else { 1.0 };
        let first: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i == 0))).collect();
        let mut rubs = rub(&first, between(0.1, 0.9), speed, more);
        if n == 2 && trial % 4 == 3 {
            rubs += &rub(&[0.0, 1.0], between(0.1, 0.5), 0.0, more);
        }
        let rough = scene(&system, &rubs).machine(&[]).unwrap();
        let simulator = simulator(&rough);
        let (q, u): (Vec<f64>, Vec<f64>) = (0..n).map(|_| (between(-0.3, 0.3), between(-0.5, 0.5))).unzip();
        let until = 4.0 * TAU;
        let all = events(&simulator, (at(0.0), &q, &u), at(until));
        let found = told(&all);
        let mut other = Rough::new(&rough, &q, &u);
        other.load = |_, u| dragged(u);
        other.decide(None);
        let expected = other.follow(until);
        let names =
            |all: &[(&'static str, usize, f64)]| all.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>();
        assert_eq!(names(&found), names(&expected), "{trial}: {all:?}\n{expected:?}\n{system}{rubs}");
        for (one, known) in found.iter().zip(&expected) {
            // The other solver steps over kinks of the coordinate that nothing rubs on.
            assert!((one.2 - known.2).abs() < 1e-6, "{trial}: {one:?} {known:?}");
            *words.entry(one.0).or_default() += 1;
        }
        let crossed = all.iter().filter(|event| matches!(event, Event::Kink(_))).count();
        assert_eq!(crossed, other.turns.iter().sum::<usize>(), "{trial}: {:?}", other.turns);
        kinks += crossed;
    }
    println!("{trials} machines, {words:?}, {kinks} kinks");
    assert!(["stick", "release", "reversal"].iter().all(|word| words.contains_key(word)), "{words:?}");
}
