//! The decision's pieces by the plainest search for the same witnesses: every sign from the formulas, at
//! every cut anew, and all k tried where no guess is right.

use grazing::{
    existence::{Approach, Case, Piece, Reason, Signs, decide},
    farey,
};
use num_integer::Integer;
use num_rational::Ratio;

/// The pieces of period `n`. Cost: O(n²).
fn plain(n: u64) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let (mut at, mut witnesses) = (Ratio::new_raw(0, 1), [None; 2]);
    while at != Ratio::new_raw(1, 2) {
        let before = witnesses;
        witnesses = found(n, &at, before);
        if *at.numer() > 0 {
            let sides = [before, witnesses];
            pieces.push(Piece::Point { at, reason: reason(n, &at, sides) });
        }
        let mut cuts = vec![2 * n];
        if let [Some(positive), Some(negative)] = witnesses {
            cuts.extend([positive, n - positive, negative, n - negative]);
            let right = next(&at, cuts);
            pieces.push(Piece::Stretch { left: at, right, positive, negative });
            at = right;
            continue;
        }
        cuts.extend(1..n);
        let right = next(&at, cuts);
        let c = Signs::new(n, &at, Approach::JustRight).c() > 0;
        let cases = if n == 1 { vec![true, false] } else { vec![witnesses[0].is_some()] };
        pieces.extend(cases.into_iter().map(|b| Piece::Orbit {
            left: at,
            right,
            case: Case::from_signs(b, c),
        }));
        at = right;
    }
    pieces
}

/// The first multiple of any 1/j after a point.
fn next(at: &Ratio<u64>, cuts: Vec<u64>) -> Ratio<u64> {
    cuts.into_iter().map(|j| Ratio::new(j * at.numer() / at.denom() + 1, j)).min().unwrap()
}

/// A k with b > 0 just right of a point and one with b < 0: those known, or guesses, or the first.
fn found(n: u64, at: &Ratio<u64>, known: [Option<u64>; 2]) -> [Option<u64>; 2] {
    let (p, q) = (*at.numer(), *at.denom());
    let m = (2 * n * p / q).div_ceil(2);
    let near = match farey::neighbours(&Ratio::new(m, n)) {
        Ok(pair) if m.gcd(&n) == 1 => [*pair.left.denom(), *pair.right.denom()],
        _ => [n / m.gcd(&n); 2],
    };
    let guesses = [(q + p) / (2 * p).max(1), near[0], near[1]];
    let signs = Signs::new(n, at, Approach::JustRight);
    [0, 1].map(|which| {
        let all = known[which].into_iter().chain(guesses).chain(1..n).filter(|&k| k < n);
        all.into_iter().find(|&k| signs.b(k) == [1, -1][which])
    })
}

fn reason(n: u64, at: &Ratio<u64>, sides: [[Option<u64>; 2]; 2]) -> Reason {
    let signs = Signs::new(n, at, Approach::At);
    if signs.singular() {
        return Reason::Singular;
    }
    let witness = |which: usize| {
        let all = sides.iter().filter_map(|side| side[which]).chain(1..n);
        all.into_iter().find(|&k| signs.b(k) == [1, -1][which])
    };
    let stretches = sides.iter().flatten().all(Option::is_some);
    match [witness(0), witness(1)] {
        [Some(positive), Some(negative)] if stretches => Reason::Excluded { positive, negative },
        _ => Reason::Boundary(*at.denom()),
    }
}

/// The same pieces, and so the same certificates to the byte.
#[test]
fn a_sweep_finds_the_pieces_of_the_plain_search() {
    for n in (1..=130).chain([144, 180, 199, 210, 243, 256, 257]) {
        assert_eq!(decide(n).unwrap().pieces, plain(n), "n = {n}");
    }
}
