//! That the cost bounds the exponentials, and that the derivatives along the curve are its own.

use super::{Interval, curve::Curve, proof, text::read};
use crate::{lines::Lines, touch::flow::EXPONENTIALS};

const SINGLE_1: &str = include_str!("../../tests/data/single-1.txt");
const SINGLE_2: &str = include_str!("../../tests/data/single-2.txt");
const SINGLE_3: &str = include_str!("../../tests/data/single-3.txt");

const SINGLE_RESONANCE: &str = include_str!("../../tests/data/single-resonance.txt");
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
    for text in [SINGLE_1, SINGLE_2, SINGLE_3, SINGLE_RESONANCE, &more].into_iter().chain(mirrored) {
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
    for text in [SINGLE_1, SINGLE_2, SINGLE_3, SINGLE_RESONANCE, SINGLE_MIRRORED_2, SINGLE_MIRRORED_3] {
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

/// A resonance is nθ = mπ exactly, of half periods nω = m: of single numbers, in whole numbers.
#[test]
fn a_resonance_is_exact() {
    let at = |[c, k]: [(i128, i128); 2], periods, mirrored| {
        let [c, k] = [c, k].map(|(p, q)| super::Fraction { p, q });
        let ranges = [[c; 2], [k; 2], [super::Fraction::ZERO; 2]];
        super::Certificate { ranges, periods, mirrored, ..certificate(SINGLE_1) }.is_resonant()
    };
    let paper = [(1, 4), (25, 576)];
    let found: Vec<u64> = (1..=9).filter(|&n| at(paper, n, false)).collect();
    assert_eq!(found, [3, 6, 9]);
    // ω = 1/6: no half period before the sixth.
    let found: Vec<u64> = (1..=12).filter(|&n| at(paper, n, true)).collect();
    assert_eq!(found, [6, 12]);
    // 4k = c², and less: no angle. c < 0 is as c > 0.
    for (numbers, expected) in [
        ([(2, 1), (1, 1)], false),
        ([(3, 1), (1, 1)], false),
        ([(0, 1), (0, 1)], false),
        ([(0, 1), (-1, 4)], false),
        ([(0, 1), (1, 4)], true),
        ([(-1, 4), (17, 64)], true),
        // nω = 3/8.
        ([(1, 4), (5, 32)], false),
        ([(1, 4), (9, 32)], false),
        ([(1, 4), (17_000_001, 64_000_000)], false),
        // What does not fit is not seen, and no number runs over.
        ([(1, 999_999_999_999_989), (999_999_999_999_999, 1)], false),
        ([(999_999_999_999_999, 1), (999_999_999_999_999, 999_999_999_999_989)], false),
    ] {
        assert_eq!(at(numbers, 1, false), expected, "{numbers:?}");
    }
    let wide = certificate(&SINGLE_RESONANCE.replace("stiffness 25/576 25/576", "stiffness 25/576 1/23"));
    assert!(certificate(SINGLE_RESONANCE).is_resonant() && !wide.is_resonant());
}
