//! The checker's arithmetic against known digits and rational numbers; its derivatives against differences.

use super::{
    Interval, proof,
    text::{Certificate, read},
    words::detail,
};
use crate::{
    lines::Lines,
    touch::{
        flow::{EXPONENTIALS, Flow, circle},
        near::ends,
        wall::Wall,
    },
};

fn ratio(p: i128, q: i128) -> Interval {
    Interval::ratio(p, q)
}

/// Whether the interval holds p/10¹⁵ and is at most `width`/10¹⁵ wide.
fn is(x: Interval, p: i128, width: i128) -> bool {
    let (least, most) = (ratio(p - width, 1_000_000_000_000_000), ratio(p + width, 1_000_000_000_000_000));
    least.is_up_to(x) && x.is_up_to(most) && x.hull(ratio(p, 1_000_000_000_000_000)) == x
}

#[test]
fn products_and_quotients_round_outwards() {
    for p in -9i128..=9 {
        for r in [-1003i128, -7, -1, 1, 3, 123] {
            let (x, y) = (ratio(p, 9), ratio(r, 7));
            let exact = ratio(p * r, 63);
            let product = x * y;
            assert!(
                product.hull(exact) == product || (product - exact).magnitude().magnitude_bits() < Some(20)
            );
            let quotient = x.over(y) * y - x;
            assert!((-quotient.magnitude()).is_up_to(Interval::ZERO) && quotient.magnitude_bits() < Some(24));
            let sum = (x + y) - x - y;
            assert!(!sum.is_positive() && !(-sum).is_positive());
        }
    }
    // What is below a unit lies between 0 and 1 of them.
    let unit = ratio(1, 1 << 48);
    for small in [unit * unit, unit.over(ratio(3, 1))] {
        assert_eq!((small, -small), (Interval::ZERO.hull(unit), (-unit).hull(Interval::ZERO)));
    }
    assert_eq!(-unit * unit, (-unit).hull(Interval::ZERO));
    let unknown = Interval::ONE.over(ratio(1, 3) - ratio(1, 3));
    for x in [
        unknown + Interval::ONE,
        unknown * Interval::ZERO,
        -unknown,
        unknown.over(Interval::ONE),
        unknown.half(),
    ] {
        assert_eq!(x, Interval::WHOLE);
    }
    let huge = ratio(30_000, 1);
    assert_eq!((huge + huge, huge * huge), (Interval::WHOLE, Interval::WHOLE));
    assert!(
        !Interval::WHOLE.is_up_to(huge) && !huge.is_below(Interval::WHOLE) && !Interval::WHOLE.is_positive()
    );
}

#[test]
fn parts_leave_nothing_out() {
    let whole = ratio(-1, 3).hull(ratio(5, 7));
    for n in 1..20 {
        let parts: Vec<_> = (0..n).map(|i| whole.part(i, n)).collect();
        assert_eq!((parts[0].least(), parts[n as usize - 1].greatest()), (whole.least(), whole.greatest()));
        assert!(parts.windows(2).all(|pair| !pair[0].greatest().is_below(pair[1].least())));
    }
}

#[test]
fn elementary_functions_have_known_digits() {
    let (cos, sin) = circle(Interval::ONE);
    assert!(is(cos, 540_302_305_868_140, 4000) && is(sin, 841_470_984_807_897, 4000));
    let wall = Wall::new(vec![(1, [Interval::ONE, Interval::ZERO])], ratio(6, 5), 16, &mut || Ok(()))
        .unwrap_or_else(|why| panic!("{why:?}"));
    for (p, q, digits) in [
        (1, 2, 523_598_775_598_299),
        (-9, 10, -1_119_769_514_998_634),
        (1, 1000, 1_000_000_166_667),
        (0, 1, 0),
    ] {
        assert!(wall.phase(ratio(p, q)).is_some_and(|phase| is(phase, digits, 60_000)), "{p}/{q}");
    }
    // exp(−t), t exp(−t): c = 2, k = 1 is (d/dt + 1)² q = 0.
    let e = Flow { damping: ratio(2, 1), stiffness: Interval::ONE }.exp(ratio(3, 1));
    assert!(is(e.b, 149_361_205_103_592, 40_000_000));
    assert!(is(e.a, 4 * 49_787_068_367_864, 40_000_000));
    // The circle at π, where the sine changes its sign.
    let (cos, sin) = circle(Interval::PI);
    assert!(is(cos, -1_000_000_000_000_000, 4000) && is(sin, 0, 4000));
    assert!(circle(Interval::PI.least()).1.magnitude().magnitude_bits() < Some(14));
}

/// g = (4 cos t − cos 2t)/3 + (2 sin t − sin 2t)/10: its bend is 0 at 0, so no window holds; half as much of
/// the second harmonic is a wall.
#[test]
fn walls_of_two_harmonics_have_their_slope_and_bend() {
    let wall = |p: i128, q: i128, b: i128| {
        let harmonics = vec![(1, [ratio(p, q), ratio(2 * b, 10)]), (2, [ratio(q - p, q), ratio(-b, 10)])];
        Wall::new(harmonics, ratio(1, 2), 16, &mut || Ok(()))
    };
    assert!(wall(4, 3, 1).is_err());
    let wall = wall(7, 6, 1).unwrap_or_else(|why| panic!("{why:?}"));
    for y in [1, -1, 3] {
        let y = ratio(y, 100);
        let phase = wall.phase(y).unwrap_or_else(|| panic!("a phase"));
        let shape = wall.at(phase);
        assert!((shape.slope - y).magnitude().magnitude_bits() < Some(20));
        // (1 − g)/g′² by the mean value theorem, against the quotient itself.
        let quotient = shape.drop.over(y.squared());
        assert!(wall.bends(phase)[1].common(quotient).is_some());
        assert!((quotient - wall.bends(phase)[1].middle()).magnitude().is_below(ratio(1, 10)));
    }
    // Differences of 1 − g and of g′.
    let (h, t) = (ratio(1, 1 << 16), ratio(1, 5));
    let (left, here, right) = (wall.at(t - h), wall.at(t), wall.at(t + h));
    for (difference, derivative) in
        [(right.drop - left.drop, here.slope), (right.slope - left.slope, here.bend)]
    {
        let error = difference.over(h + h) - derivative;
        assert!(error.magnitude().is_below(ratio(1, 1_000_000)));
    }
}

/// By hand: the trace 1 and the determinant 4 have r₁ = 1 and r₂ = 1 − 4; 5 and 4 have the root 4 above 1, so
/// that no ratio falls below it. What is not bounded ends no leg.
#[test]
fn only_a_bounded_ratio_ends_a_leg() {
    let [one, four] = [ratio(1, 1), ratio(4, 1)];
    assert!(ends([one, four], 3) && !ends([one, four], 2));
    assert!(ends([-one, four], 2) && !ends([-one, four], 1));
    assert!(!ends([four + one, four], 1000));
    for unknown in [[Interval::WHOLE, four], [one, Interval::WHOLE], [one, -four], [one, Interval::ZERO]] {
        assert!(!ends(unknown, 1000), "{unknown:?}");
    }
}

/// The lines after the kind line, with others in place of the first that begin so; what there may be of them.
fn certificate(text: &str, mirrored: bool, changes: &[(&str, &str)]) -> Certificate {
    let lines = text.lines().skip(2).map(|line| {
        let change = changes.iter().find(|(start, _)| line.starts_with(start));
        change.map_or(line, |(_, lines)| lines)
    });
    let text = lines.collect::<Vec<_>>().join("\n");
    read(&mut Lines::after(0, &mut text.as_bytes(), &mut || false), mirrored)
        .unwrap_or_else(|why| panic!("{changes:?}: {why}"))
}

const CHAOS_12: &str = include_str!("../../tests/data/chaos-12.txt");
const CHAOS_123: &str = include_str!("../../tests/data/chaos-123.txt");
const MIRRORED: &str = include_str!("../../tests/data/chaos-mirrored.txt");

/// No check takes more exponentials than its cost, and what has no share to spare takes a third of it or
/// more; the legs of `complete` and impacts of few steps take less.
#[test]
fn the_cost_bounds_the_exponentials() {
    // Of many harmonics, so that each phase takes all that it may.
    let many: Vec<String> = (2..=40).map(|j| format!("harmonic {j} 0/1 0/1 0/1 0/1")).collect();
    let many = format!("harmonic 1 1/1 1/1 0/1 0/1\n{}", many.join("\n"));
    let shallow = ("depth", "depth 0/1 1/100");
    type Changes<'a> = &'a [(&'a str, &'a str)];
    let cases: [(&str, bool, Changes, u64); 9] = [
        (CHAOS_12, false, &[], 5),
        (CHAOS_12, false, &[("pieces", "pieces 1000")], 2),
        (CHAOS_12, false, &[("cells", "cells 1 1 1 1 7")], 5),
        (CHAOS_12, false, &[shallow, ("harmonics", "harmonics 40"), ("harmonic ", &many)], 3),
        (CHAOS_123, false, &[], 12),
        (CHAOS_123, false, &[("complete", "complete 48.3 4 5 9")], 25),
        (CHAOS_123, false, &[("complete", "complete 48.3 4 2 1")], 12),
        (CHAOS_123, false, &[("complete", "complete no")], 12),
        (MIRRORED, true, &[], 15),
    ];
    for (text, mirrored, changes, share) in cases {
        let certificate = certificate(text, mirrored, changes);
        EXPONENTIALS.set(0);
        // What fails has taken less.
        let proved = proof::run(&certificate, &mut Lines::after(0, &mut &b""[..], &mut || false)).is_ok();
        let (taken, cost) = (EXPONENTIALS.get(), certificate.cost());
        assert!(taken <= cost && (!proved || taken * share >= cost), "{changes:?}: {taken} of {cost}");
    }
}

/// Without damping or without a spring a bounded motion may be free for ever: of those nothing is said.
#[test]
fn what_is_said_of_others_is_what_is_proved() {
    let said = |damping: &str, stiffness: &str| {
        let changes = [("complete", "complete 2 4 2 7"), ("damping", damping), ("stiffness", stiffness)];
        let certificate = certificate(CHAOS_12, false, &changes);
        let (_, others) = detail(&certificate).into_iter().find(|(name, _)| *name == "others").unwrap();
        others
    };
    let (damped, free) = ("every bounded motion", "every motion that meets the wall at arbitrarily early");
    for (damping, stiffness, expected) in [
        ("damping 12/49 12/49", "stiffness 100/2401 100/2401", damped),
        ("damping 0/1 12/49", "stiffness 100/2401 100/2401", free),
        ("damping 12/49 12/49", "stiffness 0/1 100/2401", free),
        ("damping -12/49 12/49", "stiffness 100/2401 100/2401", free),
    ] {
        let others = said(damping, stiffness);
        assert!(others.contains(expected), "{damping}, {stiffness}: {others}");
    }
}
