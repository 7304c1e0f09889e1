//! Motions thousands of times as fast as the forcing, against the closed form looked at densely.

use std::f64::consts::TAU;

use grazing_scenes::{
    many::{
        Load, Machine, State, Stop, StopLaw,
        simulate::{Event, Settings, Simulator},
    },
    motion::{Time, Wall},
};

use super::{at, machine, stop};

/// Modes of these frequencies, all seen by one stop alike.
fn modes(frequencies: &[f64], ratio: f64, offset: f64) -> Machine<f64> {
    let n = frequencies.len();
    let diagonal = |f: &dyn Fn(f64) -> f64| -> Vec<(usize, usize, f64)> {
        frequencies.iter().enumerate().map(|(i, &w)| (i, i, f(w))).collect()
    };
    let row: Vec<f64> = (0..n).map(|i| if i % 2 == 0 { 1.0 } else { -1.0 }).collect();
    let wall = Wall { offset, harmonics: vec![], restitution: 0.7 };
    Machine {
        size: n,
        mass: diagonal(&|_| 1.0),
        damping: diagonal(&|w| 2.0 * ratio * w),
        stiffness: diagonal(&|w| w * w),
        forcing: vec![Load { k: 1, cos: row.clone(), sin: vec![] }],
        stops: vec![Stop { name: "stop".into(), row, wall, law: StopLaw::Newton }],
        ..machine(&[&[1.0]], &[&[0.0]], &[&[0.0]])
    }
}

/// Between its impacts the gap of the closed form is looked at ten times in a radian of the fastest mode: it
/// is never negative, it is 0 at every impact, and Newton's law holds there.
#[test]
fn fast_modes_pass_no_impact_over() {
    for (name, frequencies, ratio) in
        [("damped", vec![1.3, 240.0, 9000.0], 0.01), ("undamped", vec![1.3, 40.0, 1200.0, 14000.0], 0.0)]
    {
        let fastest = frequencies.iter().copied().fold(0.0, f64::max);
        let machine = modes(&frequencies, ratio, -0.1);
        let settings = Settings { minimum_depth: 1e-11, ..Settings::default() };
        let simulator = Simulator::new(&machine, &settings).unwrap();
        let n = machine.size;
        // From rest a tenth away, at a speed at which it hits soon.
        let mut u = vec![0.0; n];
        u[0] = -1.0;
        let mut run = simulator.start(at(0.0), &vec![0.0; n], &u).unwrap();
        let (contact, mut impacts) = (&simulator.contacts().all()[0], 0);
        let (mut state, mut now) = (run.state(), run.time());
        let until = at(0.35);
        loop {
            let event = run.next(until);
            let then = event.time().unwrap_or(run.time());
            let duration = then.since(now);
            let looks = (10.0 * fastest * duration).ceil().max(1.0) as usize;
            let (step, mut y, mut t) = (duration / looks as f64, simulator.flow().split(&state), state.t);
            let mut least = f64::INFINITY;
            for _ in 0..looks - 1 {
                simulator.flow().advance(&mut y, step);
                t += step;
                let [gap, _] = contact.gap(&simulator.flow().join(t, &y));
                least = least.min(gap);
            }
            assert!(least > -1e-10, "{name}: behind the stop by {least:e} before {then:?}");
            let arrival = simulator.flow().after(&state, duration);
            match event {
                Event::Impact(hit) => {
                    impacts += 1;
                    let ([gap, rate], [_, after]) = (contact.gap(&arrival), contact.gap(&run.state()));
                    assert!(gap.abs() < 1e-10, "{name}: {gap:e}");
                    assert!(
                        (rate - hit.velocity).abs() < 1e-7 * (1.0 + rate.abs()),
                        "{name}: {rate} {hit:?}"
                    );
                    assert!((after + 0.7 * rate).abs() < 1e-7 * (1.0 + rate.abs()), "{name}: {after} {rate}");
                }
                Event::End(_) => break,
                _ => {}
            }
            (state, now) = (run.state(), run.time());
        }
        println!("{name}: {impacts} impacts");
        assert!(impacts > 2, "{name}: {impacts} impacts");
    }
}

/// The 60 lowest modes of a cantilever, the fastest 20,000 times as fast as the forcing: it bounces, and
/// comes to rest on its stop. (The bench has 200.)
#[test]
fn sixty_modes_of_a_beam_are_followed() {
    let frequencies: Vec<f64> = (1..=60).map(|k| 1.5 * f64::from(2 * k - 1).powi(2)).collect();
    let machine = modes(&frequencies, 0.01, -0.2);
    let simulator =
        Simulator::new(&machine, &Settings { minimum_depth: 1e-10, ..Settings::default() }).unwrap();
    let zero = vec![0.0; 60];
    let mut run = simulator.start(at(0.0), &zero, &zero).unwrap();
    let mut impacts = 0;
    let contact = &simulator.contacts().all()[0];
    for part in 1..=16 {
        let until = Time::new(0, TAU * f64::from(part) / 32.0);
        run.record(until, |event| impacts += usize::from(matches!(event, Event::Impact(_))));
        assert!(run.failure().is_none());
        let state = run.state();
        let [gap, _] = contact.gap(&State::new(until.phase, state.q(), state.u()));
        assert!(gap > -1e-9, "{gap:e}");
    }
    println!("{impacts} impacts in half a period");
    assert!(impacts > 1);
}

/// What floats cannot tell apart, and what has no modes, is refused in one sentence.
#[test]
fn motions_beyond_the_grid_are_refused() {
    let refused =
        |machine: &Machine<f64>| Simulator::new(machine, &Settings::default()).unwrap_err().to_string();
    let error = refused(&modes(&[1.3, 1e13], 0.01, -0.1));
    assert!(error.contains("at most 9e10 times") && !error.contains("keep"), "{error}");
    // Defective: critically damped, coupled by a force that does no work back.
    let mut defective =
        machine(&[&[1.0, 0.0], &[0.0, 1.0]], &[&[4e4, 0.0], &[0.0, 4e4]], &[&[4e8, 1.0], &[0.0, 4e8]]);
    defective.stops = vec![stop(&[1.0, 0.0], -1.0, 0.5)];
    let error = refused(&defective);
    assert!(error.contains("matrix exponential"), "{error}");
}
