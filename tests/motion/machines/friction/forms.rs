//! Forms of one question about friction: units, signs, orders, phases, further coordinates.

use super::*;

/// Events and the state at the end; every form of a question has the same, each number times its unit.
type Told = (Vec<(&'static str, usize, f64)>, Vec<f64>, Vec<f64>);

fn asked(machine: &Machine<f64>, (phase, q, u): (f64, &[f64], &[f64])) -> Told {
    let simulator = Simulator::suited(machine, None, &[State::new(phase, q, u)]).unwrap();
    let mut all = Vec::new();
    let mut run = simulator.start(at(phase), q, u).unwrap();
    assert_eq!(run.record(at(phase).after(5.0 * TAU), |event| all.push(event)), RunEnd::Reached);
    (told(&all), run.state().q().to_vec(), run.state().u().to_vec())
}

fn times(normal: &mut NormalForce<f64>, factor: f64) {
    if let NormalForce::Given(force) = normal {
        *force *= factor;
    }
}

/// Units of length are powers of two, and signs: to the last bit.
#[test]
fn friction_in_other_units_and_mirrored_is_the_same_to_the_last_bit() {
    let base = rough_pair();
    let (q, u) = ([0.1, -0.05], [0.3, 0.2]);
    let known = asked(&base, (0.0, &q, &u));
    assert!(known.0.len() > 20, "{known:?}");
    for factor in [2f64.powi(40), 2f64.powi(-40), -1.0] {
        let mut form = base.clone();
        let (size, sign) = (factor.abs(), factor.signum());
        let Load { cos, sin, .. } = &mut form.forcing[0];
        cos.iter_mut().chain(sin).for_each(|x| *x *= factor);
        for rub in &mut form.friction {
            times(&mut rub.normal, size);
            // A row turns with the coordinates; what is along it does not.
            rub.row.iter_mut().for_each(|x| *x *= sign);
            rub.speed *= size;
            rub.harmonics.iter_mut().for_each(|h| (h.cos, h.sin) = (h.cos * size, h.sin * size));
        }
        form.stops[0].row.iter_mut().for_each(|x| *x *= sign);
        form.stops[0].wall.offset *= size;
        let found = asked(&form, (0.0, &q.map(|x| x * factor), &u.map(|x| x * factor)));
        assert_eq!(found.0, known.0, "{factor}");
        for (a, b) in found.1.iter().chain(&found.2).zip(known.1.iter().chain(&known.2)) {
            assert_eq!(*a, b * factor, "{factor}");
        }
    }
}

/// The order of rows, their signs, another phase, units of time and mass, and a further coordinate that
/// nothing couples to change roundings alone.
#[test]
fn friction_in_other_forms_is_the_same_but_for_rounding() {
    let base = rough_pair();
    let (q, u) = ([0.1, -0.05], [0.3, 0.2]);
    let known = asked(&base, (0.0, &q, &u));
    let near = |name: &str, found: &Told, place: &dyn Fn(usize) -> usize, delay: f64| {
        let mut turned: Vec<_> = found.0.iter().map(|one| (one.0, place(one.1), one.2)).collect();
        // What an impact changes at one instant is told in the order of rows.
        for i in 1..turned.len() {
            if turned[i - 1].2 == turned[i].2 && turned[i - 1].1 > turned[i].1 && turned[i - 1].0 != "impact"
            {
                turned.swap(i - 1, i);
            }
        }
        let words =
            |all: &[(&'static str, usize, f64)]| -> Vec<_> { all.iter().map(|one| (one.0, one.1)).collect() };
        assert_eq!(words(&turned), words(&known.0), "{name}");
        for (one, other) in turned.iter().zip(&known.0) {
            assert!((one.2 - delay - other.2).abs() < 1e-10, "{name}: {one:?} {other:?}");
        }
        let off = apart(&found.1, &known.1).max(apart(&found.2, &known.2));
        assert!(off < 1e-10, "{name}: {off:e}");
    };
    let same = |place: usize| place;
    let mut form = base.clone();
    form.friction.reverse();
    near("reversed", &asked(&form, (0.0, &q, &u)), &|place| [0, 2, 1][place], 0.0);
    // The row's sign is a choice, as its length is: along −2w forces are half as large, velocities twice.
    let mut form = base.clone();
    for rub in &mut form.friction {
        rub.row.iter_mut().for_each(|x| *x *= -2.0);
        times(&mut rub.normal, 0.5);
        rub.speed *= -2.0;
        rub.harmonics.iter_mut().for_each(|h| (h.cos, h.sin) = (-2.0 * h.cos, -2.0 * h.sin));
    }
    near("rows turned", &asked(&form, (0.0, &q, &u)), &same, 0.0);
    let (mut form, shift) = (base.clone(), 0.7f64);
    let turn = |k: f64, cos: &mut f64, sin: &mut f64| {
        let (s, c) = (k * shift).sin_cos();
        (*cos, *sin) = (*cos * c - *sin * s, *sin * c + *cos * s);
    };
    let Load { cos, sin, .. } = &mut form.forcing[0];
    cos.iter_mut().zip(sin).for_each(|(cos, sin)| turn(1.0, cos, sin));
    form.friction[1].harmonics.iter_mut().for_each(|h| turn(2.0, &mut h.cos, &mut h.sin));
    near("shifted", &asked(&form, (shift, &q, &u)), &same, shift);
    // A period of 3 and masses of 5: velocities are per radian on both sides.
    let (mut form, rate, mass) = (base.clone(), TAU / 3.0, 5.0);
    form.period = 3.0;
    form.mass.iter_mut().for_each(|entry| entry.2 *= mass);
    form.damping.iter_mut().for_each(|entry| entry.2 *= mass * rate);
    form.stiffness.iter_mut().for_each(|entry| entry.2 *= mass * rate * rate);
    let Load { cos, sin, .. } = &mut form.forcing[0];
    cos.iter_mut().chain(sin).for_each(|x| *x *= mass * rate * rate);
    for rub in &mut form.friction {
        times(&mut rub.normal, mass * rate * rate);
        rub.speed *= rate;
    }
    near("times and masses", &asked(&form, (0.0, &q, &u)), &same, 0.0);
    let mut form = base.clone();
    form.size = 3;
    form.mass.push((2, 2, 1.0));
    form.stiffness.push((2, 2, 30.0));
    form.damping.push((2, 2, 2.0));
    form.forcing
        .iter_mut()
        .for_each(|load| [&mut load.cos, &mut load.sin].into_iter().for_each(|all| all.push(0.0)));
    form.friction.iter_mut().for_each(|rub| rub.row.push(0.0));
    form.stops.iter_mut().for_each(|stop| stop.row.push(0.0));
    let mut found = asked(&form, (0.0, &[0.1, -0.05, 0.0], &[0.3, 0.2, 0.0]));
    found.1.truncate(2);
    found.2.truncate(2);
    near("further", &found, &same, 0.0);
}
