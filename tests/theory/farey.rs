//! Farey fractions: every route against a plainer one.

use crate::common;

use grazing::farey::{
    Gap, Ranker, Sequence, Turn, Walk, bracket, from_path, kth, neighbours, next, path, previous, rank,
};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use proptest::prelude::*;

type Q = Ratio<u64>;

/// All fractions in [0, 1] with denominator at most `order`, by listing and sorting.
fn listed(order: u64) -> Vec<Q> {
    let mut all: Vec<Q> = (1..=order)
        .flat_map(|q| (0..=q).filter(move |p| p.gcd(&q) == 1).map(move |p| Ratio::new_raw(p, q)))
        .collect();
    all.sort();
    all
}

fn big(x: &Q) -> Ratio<BigInt> {
    Ratio::new(BigInt::from(*x.numer()), BigInt::from(*x.denom()))
}

fn zero_to_one() -> (Q, Q) {
    (Ratio::new_raw(0, 1), Ratio::new_raw(1, 1))
}

prop_compose! {
    /// A fraction in [0, 1] with a denominator up to `most`.
    fn fraction(most: u64)(q in 1..=most)(p in 0..=q, q in Just(q)) -> Q {
        Ratio::new(p, q)
    }
}

#[test]
fn sequence_and_walk_list_every_fraction_in_order() {
    for order in 1..=80 {
        let (zero, one) = zero_to_one();
        let expected = listed(order);
        let sequence: Vec<Q> = Sequence::new(order, &zero, &one).unwrap().collect();
        assert_eq!(sequence, expected, "F_{order}");
        let walk: Vec<Q> = Walk::new(order, &zero, &one).unwrap().collect();
        assert_eq!(walk, expected, "walk of F_{order}");
    }
}

#[test]
fn negative_ranges_and_the_ends_of_a_type() {
    let range = (Ratio::new(-3i64, 2), Ratio::new(1, 3));
    let terms: Vec<_> = Sequence::new(3, &range.0, &range.1).unwrap().map(|x| x.to_string()).collect();
    assert_eq!(terms, ["-3/2", "-4/3", "-1", "-2/3", "-1/2", "-1/3", "0", "1/3"]);
    assert_eq!(previous(&Ratio::new(0i64, 1), &7).unwrap(), Ratio::new(-1, 7));
    assert!(previous(&Ratio::new(0u64, 1), &7).unwrap_err().is_overflow());
    // Orders up to half the type's range work; above it, an error and no wrap.
    let half = u64::MAX / 4;
    assert_eq!(next(&Ratio::new(0, 1), &half).unwrap(), Ratio::new(1, half));
    assert!(next(&Ratio::new(0, 1), &u64::MAX).unwrap_err().is_overflow());
    assert!(bracket(&Ratio::new(u64::MAX, 2), &10).unwrap_err().is_overflow());
    assert!(bracket(&Ratio::new(1u64, 2), &0).unwrap_err().is_input());
    let last = neighbours(&Ratio::new(u64::MAX - 1, u64::MAX)).unwrap();
    assert_eq!(last.left, Ratio::new(u64::MAX - 2, u64::MAX - 1));
    assert_eq!(last.right, Ratio::new(1, 1));
    let mediant = Gap { left: Ratio::new_raw(1, u64::MAX), right: Ratio::new_raw(1, 2) }.mediant();
    assert_eq!(mediant, None);
    assert!(from_path(&[(Turn::Right, u64::MAX)]).unwrap_err().is_overflow());
    assert!(neighbours(&Ratio::new(4, 2)).unwrap_err().is_input());
    assert!(Walk::new(0, &zero_to_one().0, &zero_to_one().1).unwrap_err().is_input());
    assert!(Walk::new(5, &zero_to_one().0, &Ratio::new(3, 2)).unwrap_err().is_input());
}

#[test]
fn the_largest_walk_stays_exact() {
    // At the largest order allowed, around fractions of every kind, against big integers.
    let order = Walk::MAX_ORDER;
    for start in [Ratio::new(0, 1), Ratio::new(1, 2), Ratio::new(355, 1130), Ratio::new(order - 5, order)] {
        let walk = Walk::new(order, &start, &Ratio::new(1, 1)).unwrap();
        let plain =
            Sequence::new(BigInt::from(order), &big(&start), &Ratio::new(1.into(), 1.into())).unwrap();
        for (fast, slow) in walk.zip(plain).take(3000) {
            assert_eq!((BigInt::from(*fast.numer()), BigInt::from(*fast.denom())), slow.into_raw());
        }
    }
}

#[test]
fn tree_walks_visit_the_same_nodes_with_their_parents() {
    let order = 40;
    let mut breadth: Vec<_> = Gap::<u64>::half().breadth_first(order).collect();
    let in_order: Vec<_> = Gap::<u64>::half().in_order(order).collect();
    let depth_first_denominators: Vec<u64> = breadth.iter().take(3).map(|(x, _)| *x.denom()).collect();
    assert_eq!(depth_first_denominators, [3, 4, 5]);
    breadth.sort_by_key(|a| a.0);
    assert_eq!(breadth, in_order);
    let inner: Vec<Q> = in_order.iter().map(|(x, _)| *x).collect();
    let expected: Vec<Q> =
        listed(order).into_iter().filter(|x| *x > Ratio::new(0, 1) && *x < Ratio::new(1, 2)).collect();
    assert_eq!(inner, expected);
    for (x, gap) in in_order {
        let parents = neighbours(&x).unwrap();
        assert_eq!((parents.left, parents.right), (gap.left, gap.right), "{x}");
    }
    assert_eq!(Gap { left: Ratio::new(1, 3), right: Ratio::new(1, 2) }.in_order(4).count(), 0);
}

#[test]
fn rank_and_kth_agree_with_a_list() {
    for order in [1, 2, 3, 10, 97, 256] {
        let ranker = Ranker::new(order).unwrap();
        let all = listed(order);
        assert_eq!(ranker.last_index() + 1, all.len() as u128);
        for (index, x) in all.iter().enumerate() {
            assert_eq!(ranker.rank(x).unwrap(), index as u128, "{x} in F_{order}");
            assert_eq!(ranker.kth(index as u128).unwrap(), *x, "F_{order}");
        }
        assert!(ranker.kth(all.len() as u128).unwrap_err().is_input());
        assert!(ranker.rank(&Ratio::new(5, 4)).unwrap_err().is_input());
    }
    assert!(rank(&Ratio::new(1, 2), 0).unwrap_err().is_input());
    assert!(kth(0, Ranker::MAX_ORDER + 1).unwrap_err().is_input());
    // The number of terms of F_N for N = 10⁶, known from published tables of the totient summatory function.
    assert_eq!(rank(&Ratio::new(1, 1), 1_000_000).unwrap(), 303_963_552_392);
}

proptest! {
    #![proptest_config(common::config())]

    #[test]
    fn neighbours_have_determinant_one(x in fraction(u64::MAX)) {
        prop_assume!(*x.denom() > 1);
        let found = neighbours(&x).unwrap();
        let (m, n) = (i128::from(*x.numer()), i128::from(*x.denom()));
        let part = |y: &Q| (i128::from(*y.numer()), i128::from(*y.denom()));
        let ((p, q), (p1, q1)) = (part(&found.left), part(&found.right));
        prop_assert_eq!((p + p1, q + q1), (m, n));
        prop_assert!(q > 0 && q1 > 0);
        // 2¹²⁸ wraps, but to 1 only if the determinant is 1: it lies between 0 and n.
        prop_assert_eq!((m.wrapping_mul(q)).wrapping_sub(p.wrapping_mul(n)), 1);
        let wide = neighbours(&big(&x)).unwrap();
        prop_assert_eq!((wide.left, wide.right), (big(&found.left), big(&found.right)));
    }

    #[test]
    fn path_leads_to_its_fraction(x in fraction(u64::MAX)) {
        prop_assume!(*x.numer() > 0);
        let runs = path(&x).unwrap();
        prop_assert_eq!(from_path(&runs).unwrap(), x);
        prop_assert!(runs.windows(2).all(|pair| pair[0].0 != pair[1].0));
        prop_assert!(runs.iter().all(|(_, run)| *run > 0));
    }

    #[test]
    fn bracket_encloses_by_neighbours(x in fraction(1 << 40), order in 1u64..1 << 20) {
        let (left, right) = bracket(&x, &order).unwrap();
        prop_assert!(left <= x && x < right);
        prop_assert!(*left.denom() <= order && *right.denom() <= order);
        prop_assert_eq!(right.numer() * left.denom() - left.numer() * right.denom(), 1);
        prop_assert!(left.denom() + right.denom() > order);
        let back = previous(&right, &order).unwrap();
        prop_assert_eq!(back, left);
        let wide = bracket(&big(&x), &BigInt::from(order)).unwrap();
        prop_assert_eq!(wide, (big(&left), big(&right)));
    }

    #[test]
    fn both_ends_meet(order in 1u64..60, a in fraction(50), b in fraction(50), turns in prop::collection::vec(any::<bool>(), 0..2000)) {
        let expected: Vec<Q> = listed(order).into_iter().filter(|x| a <= *x && *x <= b).collect();
        let mut walk = Walk::new(order, &a, &b).unwrap();
        let mut sequence = Sequence::new(order, &a, &b).unwrap();
        let (mut front, mut back) = (Vec::new(), Vec::new());
        for turn in turns.into_iter().chain(std::iter::repeat(true)) {
            let (fast, slow) = if turn { (walk.next(), sequence.next()) } else { (walk.next_back(), sequence.next_back()) };
            prop_assert_eq!(fast, slow);
            let Some(x) = fast else { break };
            if turn { front.push(x) } else { back.push(x) }
        }
        prop_assert!(walk.next().is_none() && walk.next_back().is_none());
        prop_assert!(sequence.next().is_none() && sequence.next_back().is_none());
        front.extend(back.into_iter().rev());
        prop_assert_eq!(front, expected);
    }

    #[test]
    fn rank_and_kth_are_inverse(order in 1u64..100_000, x in fraction(1 << 30)) {
        let ranker = Ranker::new(order).unwrap();
        let index = ranker.rank(&x).unwrap();
        let term = ranker.kth(index).unwrap();
        prop_assert_eq!(term, bracket(&x, &order).unwrap().0);
        prop_assert_eq!(ranker.rank(&term).unwrap(), index);
    }
}
