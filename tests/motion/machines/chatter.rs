//! Joint chatter: two masses that fall on one another and on the ground bounce on all stops at once, ever
//! lower, until they rest.

use super::{second::numbers, *};
use crate::samples::samples;

/// Every impact that is told of arrives, also where several stops are hit at one instant, and what they take
/// is what is lost.
#[test]
fn impacts_in_joint_chatter_arrive_and_take_what_is_lost() {
    let trials: u32 = samples(40);
    let mut random = numbers(2_862_933_555_777_941_757);
    let (mut together, mut rests) = (0, 0);
    for trial in 0..trials {
        let mut between = |low: f64, high: f64| random(low, high);
        let (first, second) = (between(0.3, 3.0), between(0.3, 3.0));
        let mut pair = machine(&[&[first, 0.0], &[0.0, second]], &[], &[]);
        pair.force = vec![-between(0.2, 3.0), -between(0.2, 3.0)];
        pair.stops = vec![
            stop(&[1.0, 0.0], 0.0, between(0.1, 0.8)),
            stop(&[-1.0, 1.0], 0.0, between(0.1, 0.8)),
            stop(&[between(-0.5, 0.5), 1.0], 0.0, between(0.1, 0.8)),
        ];
        let (low, high) = (between(0.1, 0.5), between(0.6, 1.2));
        let settings = Settings { minimum_depth: 1e-9, ..Settings::default() };
        let simulator = Simulator::new(&pair, &settings).unwrap();
        let (q, u) = ([low, high], [between(-0.5, 0.5), between(-0.5, 0.5)]);
        let energy = |q: &[f64], u: &[f64]| {
            let moving = 0.5 * (first * u[0] * u[0] + second * u[1] * u[1]);
            moving - pair.force[0] * q[0] - pair.force[1] * q[1]
        };
        let mut run = simulator.start(at(0.0), &q, &u).unwrap();
        let mut taken = 0.0;
        let end = run.record(at(4.0 * TAU), |event| match event {
            Event::Impact(impact) => {
                assert!(impact.velocity <= 0.0, "{trial}: {impact:?}");
                taken += impact.shock.energy;
                together += u32::from(impact.shock.together > 1);
            }
            Event::Stick(_) => rests += 1,
            _ => {}
        });
        assert_eq!(end, RunEnd::Reached, "{trial}");
        let state = run.state();
        let lost = energy(&q, &u) - energy(state.q(), state.u());
        assert!((lost - taken).abs() < 1e-7, "{trial}: lost {lost}, taken {taken}");
    }
    println!("{trials} machines, {together} impacts of several stops, {rests} rests");
    assert!(together > 0 && rests > 0, "{together} {rests}");
}
