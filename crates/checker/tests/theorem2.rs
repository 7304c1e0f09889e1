//! Certificates of kind theorem2: rules that random damage hardly ever touches.

use crate::common::{THEOREM2, answer, rejected};
use grazing_check::theorem2::header;

/// A certificate of one period with these lines.
fn block(n: u64, lines: &[&str]) -> String {
    let head = header(&(n..=n), lines.len() as u64 + 1);
    format!("{head}n {n} {}\n{}\n", lines.len(), lines.join("\n"))
}

#[test]
fn what_is_written_passes() {
    let checked = answer(THEOREM2).unwrap();
    assert_eq!((checked.kind, checked.range, checked.lines), ("theorem2", Some(1..=14), 344));
}

/// u_1 = 1 is never 0.
#[test]
fn period_1_is_two_orbit_lines_and_nothing_else() {
    let (first, second) = ("orbit 0/1 1/2 + -", "orbit 0/1 1/2 - +");
    assert!(answer(&block(1, &[first, second])).is_ok());
    for point in ["point 1/2 singular", "point 0/1 singular"] {
        for lines in [[first, point, second], [point, first, second], [first, second, point]] {
            let why = rejected(&block(1, &lines));
            assert!(why.ends_with("false: the block of n = 1 is two orbit lines"), "{why}");
        }
    }
    for lines in [&[first][..], &[second, first], &[first, first], &[first, second, second], &[]] {
        rejected(&block(1, lines));
    }
}

/// The points are those of the open interval (0, 1/2).
#[test]
fn no_line_speaks_of_the_ends() {
    let two = ["orbit 0/1 1/4 - +", "point 1/4 singular", "orbit 1/4 1/2 + +"];
    assert!(answer(&block(2, &two)).is_ok());
    let why = rejected(&block(2, &[two[0], two[1], two[2], "point 1/2 singular"]));
    assert!(why.contains("line 10: false: the lines must tile (0, 1/2)"), "{why}");
    let why = rejected(&block(2, &[two[0], two[1], "orbit 1/4 3/4 + +"]));
    assert!(why.contains("line 9: false: the lines must tile (0, 1/2)"), "{why}");
    let why = rejected(&block(2, &["point 0/1 singular", two[0], two[1], two[2]]));
    assert!(why.contains("line 7: false: the lines must tile (0, 1/2)"), "{why}");
}

/// n = 200,000 is the last period, and what is asked of the numbers there fits.
#[test]
fn the_largest_period_is_checked_without_overflow() {
    let n = 200_000;
    let first = ["orbit 0/1 1/400000 - +", "point 1/400000 singular", "stretch 1/400000 199999/400000 1 2"];
    let why = rejected(&block(n, &first));
    assert!(why.contains("line 9: false: u_200000 = 0 at a multiple of 1/400000"), "{why}");
    let why = rejected(&block(n + 1, &first));
    assert!(why.contains("a number from 0 to 200000"), "{why}");
}

/// Every point of the sample where some b is 0 and two others have opposite signs, taken for a boundary.
#[test]
fn a_zero_among_opposite_signs_is_no_boundary() {
    let (mut n, mut tried) = (0, 0);
    for line in THEOREM2.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        if words[0] == "n" {
            n = words[1].parse().unwrap();
        }
        let ("point", Some(&"excluded")) = (words[0], words.get(2)) else { continue };
        let q: u64 = words[1].split_once('/').unwrap().1.parse().unwrap();
        if q < n {
            let block = format!("\nn {n} ");
            let start = THEOREM2.find(&block).unwrap();
            let boundary = format!("point {} boundary {q}", words[1]);
            let damaged = THEOREM2[start..].replacen(line, &boundary, 1);
            let why = rejected(&format!("{}{damaged}", &THEOREM2[..start]));
            assert!(why.contains("two b of strictly opposite sign"), "{boundary} of n = {n}: {why}");
            tried += 1;
        }
    }
    assert!(tried >= 20, "{tried}");
}
