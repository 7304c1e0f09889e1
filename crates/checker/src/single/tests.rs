//! That the cost bounds the exponentials, and that the derivatives along the curve are its own.

use super::{Interval, curve::Curve, proof, text::read};
use crate::{lines::Lines, touch::flow::EXPONENTIALS};

const SINGLE_1: &str = include_str!("../../tests/data/single-1.txt");
const SINGLE_2: &str = include_str!("../../tests/data/single-2.txt");
const SINGLE_3: &str = include_str!("../../tests/data/single-3.txt");

const SINGLE_MIRRORED_2: &str = include_str!("../../tests/data/single-mirrored-2.txt");
const SINGLE_MIRRORED_3: &str = include_str!("../../tests/data/single-mirrored-3.txt");

fn certificate(text: &str) -> super::Certificate {
    let mirrored = text.contains("kind single 2\n");
    let text: String = text.lines().skip(2).map(|line| format!("{line}\n")).collect();
    read(&mut Lines::after(0, &mut text.as_bytes(), &mut || false), mirrored)
        .unwrap_or_else(|why| panic!("{why}"))
}

/// No check takes more exponentials than its cost, and what has no share to spare takes a sixth of it or
/// more.
#[test]
fn the_cost_bounds_the_exponentials() {
    let mirrored = [SINGLE_MIRRORED_2, SINGLE_MIRRORED_3];
    let more = SINGLE_2.replace("pieces 48", "pieces 200");
    for text in [SINGLE_1, SINGLE_2, SINGLE_3, &more].into_iter().chain(mirrored) {
        let certificate = certificate(text);
        EXPONENTIALS.set(0);
        let proved = proof::run(&certificate, &mut || Ok(()));
        let (taken, cost) = (EXPONENTIALS.get(), certificate.cost());
        assert!(proved.is_ok() && taken <= cost && 8 * taken >= cost, "{taken} of {cost}: {proved:?}");
    }
}

/// S1 asks about the derivative of the depth: it is that of `depth`, by differences.
#[test]
fn the_depth_moves_as_s1_says() {
    for text in [SINGLE_1, SINGLE_2, SINGLE_3, SINGLE_MIRRORED_2, SINGLE_MIRRORED_3] {
        let curve = Curve::new(&certificate(text)).unwrap_or_else(|why| panic!("{why:?}"));
        let (h, t) = (Interval::ratio(1, 1 << 14), curve.direction * Interval::ratio(1, 10));
        let shape = curve.wall.at(t);
        let slope = curve.slope(&shape);
        let difference = (curve.depth(t + h) - curve.depth(t - h)).over(h + h) * curve.direction;
        let apart = (slope - difference).magnitude();
        assert!(apart.is_below(Interval::ratio(1, 100_000)), "{slope:?} {difference:?}");
        assert!(slope.is_positive());
    }
}
