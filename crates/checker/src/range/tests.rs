//! The derivatives by the depth against differences, how gaps are carried, and the cost.

use super::{
    Interval,
    legs::leg,
    others::Room,
    proof,
    text::{Certificate, Fraction, read},
};
use crate::{
    lines::Lines,
    touch::{carry::carried, flow::EXPONENTIALS, legs::Cell, wall::Wall},
};

const RANGE_1: &str = include_str!("../../tests/data/range-1.txt");
const RANGE_12: &str = include_str!("../../tests/data/range-12.txt");
const RANGE_ALONE: &str = include_str!("../../tests/data/range-alone.txt");
const RANGE_BEFORE: &str = include_str!("../../tests/data/range-before.txt");
const RANGE_13: &str = include_str!("../../tests/data/range-13.txt");
const RANGE_MIRRORED: &str = include_str!("../../tests/data/range-mirrored.txt");
const RANGE_MIRRORED_BEYOND: &str = include_str!("../../tests/data/range-mirrored-beyond.txt");

fn ratio(p: i128, q: i128) -> Interval {
    Interval::ratio(p, q)
}

/// Each part of what is claimed of other motions is in its words: without damping, on the other side, with a
/// second wall, in another window, of another strength they are others.
#[test]
fn which_motions_are_excluded_is_said_in_full() {
    let read = |text: &str| {
        let text = text.lines().skip(2).collect::<Vec<_>>().join("\n") + "\n";
        read(&mut Lines::after(0, &mut text.as_bytes(), &mut || false), 2).unwrap()
    };
    let own = read(RANGE_BEFORE);
    let (depth, among) = own.among().unwrap();
    let said = among.to_string();
    assert!(
        said.starts_with("every bounded motion that meets the wall and has no last impact, only within "),
        "{said}"
    );
    let mut changed = [(); 6].map(|()| own.clone());
    changed[0].ranges[0][0] = Fraction::ZERO;
    changed[1].behind = true;
    changed[2].mirrored = true;
    changed[3].window = own.cells[0].edges[0].weight;
    changed[4].cells[0].others.as_mut().unwrap().strength = own.window;
    (changed[5].behind, changed[5].ranges[0][0]) = (true, Fraction::ZERO);
    let mut all: Vec<String> = changed.iter().map(|one| one.among().unwrap().1.to_string()).collect();
    assert!(
        all[0].contains("at arbitrarily early and late times") && !all[1].contains("last impact"),
        "{all:?}"
    );
    assert!(all[5].starts_with("every motion that meets the wall at arbitrarily early"), "{all:?}");
    all.push(said);
    all.sort();
    all.dedup();
    assert_eq!(all.len(), 7, "{all:?}");
    // Of two certificates it is what both exclude; and it ends with the cells that exclude others.
    let [less, more] = [&changed[4], &own].map(|one| one.among().unwrap().1);
    assert_eq!([less.and(more), more.and(less)], [less, less]);
    assert_eq!(depth, own.cells[0].depth);
    let mut several = read(RANGE_ALONE);
    assert!(several.cells.len() > 1 && several.among().unwrap().0 != several.cells[0].depth);
    several.cells[1].others = None;
    assert_eq!(several.among().unwrap().0, several.cells[0].depth);
    several.cells[0].others = None;
    assert!(several.among().is_none());
}

/// With a wall of two harmonics and damping, a and p move with s, s′ and ν as their derivatives say.
#[test]
fn legs_move_with_strengths_and_depths() {
    let harmonics = vec![(1, [ratio(7, 6), ratio(1, 5)]), (2, [ratio(-1, 6), ratio(-1, 10)])];
    let wall = Wall::new(harmonics, ratio(1, 2), 16, &mut || Ok(())).unwrap_or_else(|why| panic!("{why:?}"));
    let (h, zero) = (ratio(1, 1 << 14), Interval::ZERO);
    let point = [ratio(1, 2), ratio(-1, 3), ratio(1, 10)];
    let at = |[s, last, depth]: [Interval; 3]| {
        let parameters = [ratio(1, 10), ratio(3, 10), zero, ratio(4, 5), depth];
        let cell = Cell::new(false, parameters, Interval::ONE, &wall);
        let impacts = [s, last].map(|s| cell.impact(s).unwrap_or_else(|| panic!("a phase")));
        let ends = [&impacts[0], &impacts[1]];
        leg([&cell, &cell], cell.turned(2), 2, ends, ends)
    };
    let here = at(point);
    for i in 0..3 {
        let moved = |by: Interval| {
            let mut there = point;
            there[i] = there[i] + by;
            at(there).middle
        };
        let (right, left) = (moved(h), moved(-h));
        for (j, slope) in [here.after_slopes[i], here.before_slopes[i]].into_iter().enumerate() {
            let difference = (right[j] - left[j]).over(h + h);
            // Of this wall (1 − g)/g′² is known as a range only.
            let width = (slope - slope.middle()).magnitude();
            assert!(width.is_below(ratio(1, 50)), "{i} {j}: {slope:?}");
            let near = slope.widened(ratio(1, 100_000)).common(difference);
            assert!(near.is_some(), "{i} {j}: {difference:?} {slope:?}");
            assert!(ratio(1, 100).is_below(slope.magnitude()), "{i} {j}: {slope:?}");
        }
    }
}

/// Where only the bend is known the gap is carried from where its slope is known.
#[test]
fn gaps_are_carried_by_what_is_known() {
    let piece = |c: char| (c == 'm', c == 'c', c == 'o');
    let pieces = |text: &str| carried(true, text.chars().map(piece));
    // From an end where the gap is not 0, but not known to be positive either.
    for (text, expected) in [("", 0), ("m", 0), ("c", 0), ("om", 2), ("oc", 1), ("omcc", 4), ("occ", 1)] {
        assert_eq!(carried(false, text.chars().map(piece)), expected, "{text}");
    }
    for (text, expected) in [
        ("", 0),
        ("ccmo", 4),
        // Of an open piece's end the slope is not known: the next may be convex and go down.
        ("oc", 1),
        ("oo", 2),
        ("omc", 3),
        ("ccoc", 3),
        ("c-c", 1),
        ("-", 0),
    ] {
        assert_eq!(pieces(text), expected, "{text}");
    }
}

/// No check takes more exponentials than its cost with what is counted meanwhile, and what has no share to
/// spare takes a third of it or more.
#[test]
fn the_cost_bounds_the_exponentials() {
    let many: Vec<String> = (2..=40).map(|j| format!("harmonic {j} 0/1 0/1 0/1 0/1")).collect();
    let many = format!("harmonics 40\nharmonic 1 1/1 1/1 0/1 0/1\n{}", many.join("\n"));
    let plain = "harmonics 1\nharmonic 1 1/1 1/1 0/1 0/1";
    let cases = [
        (RANGE_1.to_string(), 12),
        (RANGE_12.to_string(), 6),
        (RANGE_13.to_string(), 4),
        (RANGE_ALONE.to_string(), 30),
        (RANGE_BEFORE.to_string(), 120),
        (RANGE_MIRRORED.to_string(), 12),
        (RANGE_MIRRORED_BEYOND.to_string(), 30),
        (RANGE_13.replace("pieces 32", "pieces 1000"), 2),
        (RANGE_13.replace(" 1 0\nedge", " 9 0\nedge"), 6),
        (RANGE_13.replace(plain, &many).replace("3/100", "1/100"), 4),
    ];
    for (text, share) in cases {
        let second = text.contains("\nothers ");
        let version = 1 + u8::from(second) + 2 * u8::from(text.contains(" half periods "));
        let text: String = text.lines().skip(2).map(|line| format!("{line}\n")).collect();
        let certificate: Certificate =
            read(&mut Lines::after(0, &mut text.as_bytes(), &mut || false), version)
                .unwrap_or_else(|why| panic!("{why}"));
        EXPONENTIALS.set(0);
        let (mut room, all) = (Room::new(), 0..certificate.cells.len());
        let proved = proof::cells(&certificate, all, &mut room, &mut || Ok(()));
        let counted = Room::new().left() - room.left();
        let (taken, cost) = (EXPONENTIALS.get(), certificate.cost() + counted);
        assert!(taken <= cost && (proved.is_err() || taken * share >= cost), "{taken} of {cost}: {proved:?}");
    }
}
