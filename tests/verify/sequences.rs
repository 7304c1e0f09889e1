//! `grazing sequence`: whole sequences by a second route, and what users get wrong.

use std::{collections::BTreeSet, path::Path};

use crate::process::{onto_full_disk, run, unread};
use grazing::{
    existence::by_definition,
    local::{Ladder, Plane, Point, Polar},
    pattern::Patterns,
    word::{Edge, Relation, Word},
};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::{BigRational, Ratio};

/// The terms that the command lists, from its first n.
fn listed(name: &str, last: u64) -> Vec<(u64, BigInt)> {
    let (code, out, err) = run(&format!("sequence {name} {last}"), Path::new("."));
    assert_eq!((code, err.as_str()), (0, ""), "{name}");
    let term = |line: &str| {
        let (n, term) = line.split_once(' ').unwrap();
        (n.parse().unwrap(), term.parse().unwrap())
    };
    let all: Vec<(u64, BigInt)> = out.lines().map(term).collect();
    let first = all[0].0;
    assert!((first..=last).eq(all.iter().map(|term| term.0)), "{name}: a line for each n");
    all
}

/// Whether the command lists f(n) for every n up to `last`.
fn is(name: &str, last: u64, f: impl Fn(u64) -> BigInt) {
    for (n, term) in listed(name, last) {
        assert_eq!(term, f(n), "{name}, n = {n}");
    }
}

fn word(s: Ratio<u64>, positive: bool, letters: usize) -> Word {
    let s = BigRational::new((*s.numer()).into(), (*s.denom()).into());
    let polar = Polar::new(BigRational::from_integer(1.into()), s).unwrap();
    Word::at(&Ladder::default(), &Point::Polar(polar), positive, letters, &()).unwrap()
}

/// The fractions in (0, ½) with denominators up to `last`, and a point between each two neighbours and
/// beside the ends.
fn fractions_and_between(last: u64) -> Vec<Ratio<u64>> {
    let mut ends: BTreeSet<Ratio<u64>> =
        (1..=last).flat_map(|q| (0..=q / 2).map(move |p| Ratio::new(p, q))).collect();
    ends.insert(Ratio::new(1, 2));
    let ends: Vec<_> = ends.into_iter().collect();
    let middle = |a: &Ratio<u64>, b: &Ratio<u64>| Ratio::new(a.numer() + b.numer(), a.denom() + b.denom());
    let mut all = vec![middle(&ends[0], &ends[1])];
    for pair in ends[1..].windows(2) {
        all.extend([pair[0], middle(&pair[0], &pair[1])]);
    }
    all
}

#[test]
fn intervals_are_one_more_than_units() {
    is("intervals", 3000, |n| BigInt::from((1..n).filter(|k| k.gcd(&n) == 1).count() + 1));
}

/// The sum of fractions, term by term.
#[test]
fn measures_are_sums_of_unit_fractions() {
    let sum = |n: u64| -> BigRational {
        let terms = (1..n).filter(|k| k.gcd(&n) == 1);
        terms.map(|k| BigRational::new(1.into(), (n * k).into())).sum()
    };
    is("measure-numerator", 300, |n| sum(n).numer().clone());
    is("measure-denominator", 300, |n| sum(n).denom().clone());
}

/// Maximal runs of points of r = 1 at which the pattern exists by the words there: between neighbours of
/// order 2n nothing changes.
#[test]
fn patterns_of_two_impacts_are_counted_along_the_circle() {
    const LAST: u64 = 11;
    let points = fractions_and_between(2 * LAST);
    let mut counts = vec![0u64; LAST as usize + 1];
    for (positive, gamma) in [(true, true), (true, false), (false, true), (false, false)] {
        let relations: Vec<Relation> = points
            .iter()
            .map(|s| Relation::new(&word(*s, positive, 60), gamma, false, LAST).unwrap())
            .collect();
        for n in 3..=LAST {
            for i in 1..=(n - 1) / 2 {
                let exists: Vec<bool> =
                    relations.iter().map(|relation| relation.pattern(&[i, n - i]) == Edge::Yes).collect();
                let begins = |k: usize| exists[k] && (k == 0 || !exists[k - 1]);
                counts[n as usize] += (0..exists.len()).filter(|&k| begins(k)).count() as u64;
            }
        }
    }
    is("two-impacts", LAST, |n| counts[n as usize].into());
}

#[test]
fn patterns_are_those_that_can_be_listed() {
    is("patterns", 16, |n| Patterns::of_period(n).count().into());
    is("primitive-patterns", 16, |n| Patterns::of_period(n).filter(|p| p.is_primitive()).count().into());
}

/// The beginnings of the words at many points of r = 1.
#[test]
fn words_are_those_that_occur() {
    let all: Vec<String> =
        fractions_and_between(120).into_iter().map(|s| word(s, true, 6).letters()).collect();
    is("words", 6, |n| {
        let beginnings: BTreeSet<&str> = all.iter().filter_map(|word| word.get(..n as usize)).collect();
        beginnings.len().into()
    });
}

/// The areas that go on below every tip, counted as the runs of points with an orbit along a line a₂ = 0.7,
/// by the definition: all signs of b_{n,k} at each point. Runs are short in region 4, where they begin at a₁
/// = −(a₂ + 1), and next to region 2, so the points crowd there. The other areas, of which the intervals
/// give the number, have a tip.
#[test]
fn areas_without_a_tip_are_met_by_a_line_below_all_tips() {
    const LAST: u64 = 32;
    let number = |p: i64, q: i64| BigRational::new(p.into(), q.into());
    let near = (2..50).rev().map(|j| number(1, 1 << j));
    let far = (26..325).map(|i| number(i, 100)).chain((3250..3400).map(|i| number(i, 1000)));
    let ladder = Ladder::default();
    let mut runs = vec![0u64; LAST as usize + 1];
    let mut inside = vec![false; LAST as usize + 1];
    for offset in near.chain(far) {
        let point = Point::Plane(Plane::new(number(-17, 10) + offset, number(7, 10)).unwrap());
        for n in 3..=LAST {
            let at = n as usize;
            let here = by_definition(&ladder, &point, n).cases(n).iter().any(|case| case.sign_emu() > 0);
            runs[at] += u64::from(here && !inside[at]);
            inside[at] = here;
        }
    }
    let areas = listed("intervals", LAST);
    // All but the first interval, 0 < s < 1/(2n), which has no deciding k.
    is("tips", LAST, |n| &areas[n as usize - 3].1 - 1 - BigInt::from(runs[n as usize]));
}

#[test]
fn what_is_wrong_is_said() {
    for (arguments, says) in [
        ("sequence foo 10", "[possible values: intervals"),
        ("sequence tips", "<N>"),
        ("sequence intervals 0", "N = 0: this sequence is listed for N from 3 to 100000"),
        ("sequence words 21", "from 2 to 20"),
        ("sequence patterns 2.5", "not a whole number"),
        ("sequence patterns 1e30", "too large"),
        ("intervals --measure 0", "a period is at least 1"),
        ("intervals --measure 5..=3", "the range is reversed: write 3..=5"),
        ("intervals --measure 5..3", "5..3 is reversed: write 3..=5"),
        ("intervals --measure 99999999999999999999999", "too large for a period"),
        ("word --returns --r 0 --s 1/3", "r = 0: the modulus is above 0"),
        ("word --returns --r 1/2 --s 1/2", "s = 1/2 is outside 0 < s < 1/2"),
        ("word --returns --a1 2 --a2 1", "complex eigenvalues"),
        ("word --returns --a1 0.1..=0.2 --a2 1", "--returns is asked at one point"),
    ] {
        let (code, out, err) = run(arguments, Path::new("."));
        assert!(code == 2 && out.is_empty() && err.contains(says), "{arguments}: {code}, {err}");
    }
    let cut = "word --returns --r 2 --s 0.3 --letters 1";
    let (code, _, err) = run(cut, Path::new("."));
    assert!(code == 3 && err.contains("more than 1 letters: give a greater --letters"), "{err}");
    // r = 3, and a point where an image lies on the line itself.
    for arguments in ["word --returns --r 3 --s 1/3", "word --returns --a1 -1 --a2 9/4"] {
        assert_eq!(run(arguments, Path::new(".")).0, 0, "{arguments}");
    }
    for arguments in
        ["sequence intervals 50000", "intervals --measure 3..=3000", "word --returns --r 1 --s 0.3001"]
    {
        assert_eq!(unread(arguments, Path::new(".")), (0, String::new()), "{arguments}, unread");
        let (code, err) = onto_full_disk(arguments, Path::new("."));
        assert!(code == 2 && err.contains("No space left"), "{arguments}, on a full disk: {err}");
    }
}
