//! Rows with friction that depend on one another: what they hold, they hold together.

use grazing_scenes::many::{Friction, Load};

use super::{super::*, friction, told};

/// What happens from rest at these displacements up to a time, by word, row and time, and the state there.
fn followed(machine: &Machine<f64>, q: &[f64], until: f64) -> (Vec<(&'static str, usize, f64)>, State) {
    let simulator = simulator(machine);
    let mut run = simulator.start(at(0.0), q, &vec![0.0; q.len()]).unwrap();
    let mut all = Vec::new();
    assert_eq!(run.record(at(until), |event| all.push(event)), RunEnd::Reached);
    (told(&all), run.state())
}

/// Jaws on one coordinate are one row: forces, and bounds of static friction, add up, whatever the sizes and
/// signs of the rows are.
#[test]
fn rows_on_one_coordinate_are_one_row() {
    let mass = |rows: &[(f64, f64, [f64; 2])]| {
        let mut mass = machine(&[&[1.0]], &[&[0.02]], &[&[2.5]]);
        mass.forcing = vec![Load { k: 1, cos: vec![3.0], sin: vec![0.0] }];
        let rub = |&(row, normal, both): &(f64, f64, [f64; 2])| friction(&[row], normal, both);
        mass.friction = rows.iter().map(rub).collect();
        mass
    };
    let jaws = mass(&[(1.0, 5.0, [0.1, 0.3]), (-2.0, 2.5, [0.1, 0.2]), (0.5, 10.0, [0.0, 0.2])]);
    let one = mass(&[(1.0, 10.0, [0.1, 0.35])]);
    let [several, single] = [&jaws, &one].map(|machine| followed(machine, &[2.0], 20.0 * TAU));
    assert!(single.0.len() > 50, "{}", single.0.len());
    for row in 0..3 {
        let own: Vec<_> = several.0.iter().filter(|one| one.1 == row).collect();
        assert_eq!(own.len(), single.0.len());
        for (a, b) in own.iter().zip(&single.0) {
            assert!(a.0 == b.0 && (a.2 - b.2).abs() < 1e-9, "{a:?} {b:?}");
        }
    }
    assert!((several.1.q()[0] - single.1.q()[0]).abs() < 1e-9);
}

/// Two masses on the ground, that hold up to F₁ and F₂, and on each other, up to F₃: pulled by f₁ and f₂ they
/// stick as long as |f₁| ≤ F₁ + F₃, |f₂| ≤ F₂ + F₃ and |f₁ + f₂| ≤ F₁ + F₂. Where the last is the first to
/// fail they slide together.
#[test]
fn masses_on_the_ground_and_on_each_other_stick_as_long_as_forces_can_be_shared() {
    let [first, second, third] = [1.0, 0.7, 0.4];
    // The amplitudes of f = a sin t, the bound that fails, and what slides.
    for (pulls, of, most, slides) in [
        ([3.0, -1.0], [1.0, 0.0], first + third, vec![0, 2]),
        ([-3.0, 1.0], [1.0, 0.0], first + third, vec![0, 2]),
        ([0.5, -3.0], [0.0, 1.0], second + third, vec![1, 2]),
        ([2.0, 1.8], [1.0, 1.0], first + second, vec![0, 1]),
    ] {
        let rows: [(&[f64], f64); 3] = [(&[1.0, 0.0], first), (&[0.0, 1.0], second), (&[1.0, -1.0], third)];
        let mut masses = machine(&[&[1.0, 0.2], &[0.2, 0.5]], &[], &[]);
        masses.forcing = vec![Load { k: 1, cos: vec![0.0; 2], sin: pulls.to_vec() }];
        let rub = |&(row, most): &(&[f64], f64)| friction(row, 1.0, [most / 2.0, most]);
        masses.friction = rows.iter().map(rub).collect::<Vec<Friction<f64>>>();
        let pull: f64 = pulls[0] * of[0] + pulls[1] * of[1];
        let time = (most / pull.abs()).asin();
        let (found, end) = followed(&masses, &[0.0; 2], time + 0.01);
        let expected: Vec<_> = slides.iter().map(|&row| ("release", row, time)).collect();
        assert_eq!(found.len(), expected.len(), "{pulls:?}: {found:?}");
        for (a, b) in found.iter().zip(&expected) {
            assert!(a.0 == b.0 && a.1 == b.1 && (a.2 - b.2).abs() < 1e-12, "{a:?} {b:?}");
        }
        // The other row sticks on, and what slides goes where it is pulled.
        let stuck = (0..3).find(|row| !slides.contains(row)).unwrap();
        let (row, u) = (rows[stuck].0, end.u());
        let goes = of[0] * u[0] + of[1] * u[1];
        assert!((row[0] * u[0] + row[1] * u[1]).abs() < 1e-15 && goes * pull > 1e-4, "{pulls:?}: {u:?}");
    }
}
