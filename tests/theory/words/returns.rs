//! Return times against the map itself, in exact fractions: points of every piece of the line are followed
//! until they are beyond it.

use std::cmp::Ordering;

use grazing::local::{Forward, Ladder, Region};
use grazing::word::{Letter, ReturnKind, Returns, Word, place};
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;

use super::{Q, config, q, u};

/// The first n ≤ `last` with x₁ < −1 after n steps from (−1, p).
fn first_return(a1: &Q, a2: &Q, p: &Q, last: u64) -> Option<u64> {
    let (mut x, mut y) = (-Q::one(), p.clone());
    (1..=last).find(|_| {
        let next = a1 * &x + &y;
        y = -a2 * &x;
        x = next;
        x < -Q::one()
    })
}

/// The pieces of the line at (a₁, a₂), a₂ > 0 and complex eigenvalues.
fn returns(a1: &Q, a2: &Q) -> (Returns, Forward) {
    let forward = Forward::plane(a1.clone(), a2.clone()).unwrap();
    let word = Word::at(&Ladder::default(), &forward.point, true, 12, &()).unwrap();
    let found = Returns::new(&word, forward.region, a2.cmp(&Q::one())).unwrap();
    (found, forward)
}

/// Points of every piece, its ends among them, return when it says.
fn check(a1: &Q, a2: &Q) {
    let (returns, forward) = returns(a1, a2);
    let times = returns.times();
    assert!(times.windows(2).all(|pair| pair[0] < pair[1]), "{times:?}");
    let longest = times.last().copied().unwrap_or(0).min(60);
    let u = u(a1, a2, longest as usize + 2);
    // p_n, by its definition.
    let end = |n: u64| (&u[n as usize + 1] - Q::one()) / &u[n as usize];
    let pieces = returns.pieces();
    let mut before: Option<Q> = None;
    for (index, piece) in pieces.iter().enumerate() {
        if [piece.time, piece.ends[0], piece.ends[1]].into_iter().flatten().any(|n| n > longest) {
            return;
        }
        let [left, right] = piece.ends.map(|n| n.map(end));
        for n in piece.ends.into_iter().flatten() {
            let (lower, upper) = place(&forward.point, forward.reversed, n).unwrap().exact_bounds().unwrap();
            assert!(lower <= end(n) && end(n) <= upper && (&upper - &lower) < q(1, 1_000_000_000), "p_{n}");
        }
        // No gap between pieces, but where the word was cut.
        if before.is_some() && returns.is_whole() {
            assert_eq!(left, before, "{a1} {a2}: piece {index}");
        }
        before = right.clone();
        let upper_side = piece.kind == ReturnKind::Period(Letter::U);
        let points = match (left, right) {
            (None, Some(b)) => vec![&b - q(100, 1), &b - q(1, 1_000_000)],
            (Some(a), None) => vec![&a + q(1, 1_000_000), &a + q(100, 1)],
            (Some(a), Some(b)) => {
                assert!(
                    a < b || piece.kind == ReturnKind::Left || !returns.is_whole(),
                    "{a1} {a2}: {piece:?}"
                );
                let mut points = vec![(&a + &b) * q(1, 2), (&a * q(999, 1) + &b) * q(1, 1000)];
                // Ends belong to the piece that lies towards the middle.
                match piece.kind {
                    ReturnKind::Period(Letter::D) => points.push(a),
                    ReturnKind::Period(_) => points.push(b),
                    // Of the next node one end may be the point that is left.
                    ReturnKind::Next => {}
                    _ => points.extend([a, b]),
                }
                points
            }
            (None, None) => panic!("{piece:?}"),
        };
        for p in points {
            // Those that never return are followed for twice as long as all others need.
            let found = first_return(a1, a2, &p, 2 * longest + 2);
            assert_eq!(found, piece.time, "{a1} {a2}: p = {p} in {piece:?}, upper {upper_side}");
        }
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn points_return_as_the_pieces_say(a1 in -999i64..1000, root in 1i64..3000) {
        // a₂ = (root/1000)², |a₁| < 2 root/1000.
        check(&(q(a1, 1000) * q(2 * root, 1000)), &(q(root, 1000) * q(root, 1000)));
    }

    #[test]
    fn points_return_near_the_circle(a1 in -199i64..200, small in 1i64..400, inside in any::<bool>()) {
        let a2 = if inside { Q::one() - q(small, 10_000) } else { Q::one() + q(small, 10_000) };
        let a1 = q(a1, 100);
        prop_assume!(&a1 * &a1 < &a2 * q(4, 1));
        check(&a1, &a2);
    }
}

/// Im λⁿ = 0 at s = 1/4, 1/6, 1/3, on the circle and off it; ties.
#[test]
fn points_return_where_something_vanishes() {
    for r in [q(1, 2), q(9, 10), q(99, 100), q(1, 1), q(101, 100), q(3, 2), q(3, 1)] {
        for c in [q(0, 1), q(1, 2), q(-1, 2)] {
            check(&(&r * c * q(2, 1)), &(&r * &r));
        }
    }
    // b_{3,1} = 0 on a₁ = −1; at a₂ > 1 one point is left after 3, and returns at 3 + 2.
    for a2 in [q(1, 2), q(2, 3), q(9, 10), q(99, 100)] {
        let (a1, above) = (-Q::one() / &a2, a2.recip());
        let (found, _) = returns(&a1, &above);
        assert!(found.pieces().iter().any(|piece| piece.kind == ReturnKind::Left), "{a2}: {found:?}");
        assert_eq!(found.times(), [1, 2, 3, 5]);
        check(&a1, &above);
        check(&-Q::one(), &a2);
    }
}

/// V(r) = V(1/r), and above 1 one time more.
#[test]
fn inside_and_outside_the_circle_share_their_times() {
    let mut longer = 0;
    for (a1, root) in (-19..20).flat_map(|a1| (1..20).map(move |root| (q(a1, 10), q(root, 20)))) {
        let (inside, outside) = (&root * &root, (&root * &root).recip());
        let (below, _) = returns(&(&a1 * &root), &inside);
        let (above, _) = returns(&(&a1 / &root), &outside);
        if below.is_whole() {
            let (few, many) = (below.times(), above.times());
            assert_eq!(many[..few.len()], few, "{a1} {root}");
            assert!(many.len() > few.len(), "{a1} {root}");
            longer += 1;
        }
    }
    assert!(longer > 500, "{longer}");
}

#[test]
fn return_times_need_complex_eigenvalues() {
    let forward = Forward::plane(q(5, 2), BigRational::one()).unwrap();
    assert_ne!(forward.region, Region::Three);
    let word = Word::at(&Ladder::default(), &forward.point, true, 12, &()).unwrap();
    assert!(Returns::new(&word, forward.region, Ordering::Equal).unwrap_err().is_input());
    let inside = Forward::plane(Q::zero(), q(1, 2)).unwrap();
    let word = Word::at(&Ladder::default(), &inside.point, false, 12, &()).unwrap();
    assert!(Returns::new(&word, inside.region, Ordering::Less).unwrap_err().is_input());
}
