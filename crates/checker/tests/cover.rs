//! Certificates of kind cover: what is left open, what is printed, what is too long.

use crate::common::{COVER, answer, rejected};
use grazing_check::{Rejection, cover};

#[test]
fn what_is_written_passes_and_names_r_max() {
    let checked = answer(COVER).unwrap();
    assert_eq!((checked.kind, checked.range), ("cover", Some(3..=8)));
    let shown = checked.detail.iter().map(|(name, value)| format!("{name}: {value}")).collect::<Vec<_>>();
    assert_eq!(shown, ["r_max: 1 - 1/n^3, from 26/27 (n = 3) to 511/512 (n = 8)"]);
}

/// The cuts of (0, 1/2) for period n: the multiples of 1/(2n) and the neighbours, of denominator below n, of
/// every m/n.
fn cuts(n: u64) -> Vec<(u64, u64)> {
    let gcd = |mut a: u64, mut b: u64| {
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let mut cuts: Vec<(u64, u64)> =
        (0..=n).map(|j| (j, 2 * n)).map(|(p, q)| (p / gcd(p, q), q / gcd(p, q))).collect();
    for m in (1..=n / 2).filter(|&m| gcd(m, n) == 1) {
        // p/q with |m q − n p| = 1.
        let neighbours = (1..n).flat_map(|q| [(m * q - 1) / n, (m * q).div_ceil(n)].map(|p| (p, q)));
        cuts.extend(
            neighbours.filter(|&(p, q)| (m * q).abs_diff(n * p) == 1 && 2 * p <= q && (m > 1 || p > 0)),
        );
    }
    cuts.sort_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
    cuts.dedup();
    cuts
}

/// Everything left open, up to r_max = 1 − 2⁻⁴⁰: half a unit of area for each of 33 periods.
#[test]
fn the_open_area_is_the_sum_of_all() {
    let blocks: Vec<String> = (3..=35)
        .map(|n| {
            let cuts = cuts(n);
            let strips = cuts.len() - 1;
            let mut block = format!("n {n} 1099511627775/1099511627776 {}\n", 40 * strips);
            block += "identity region2\nidentity region4\n";
            for pair in cuts.windows(2) {
                let [(p, q), (u, v)] = [pair[0], pair[1]];
                block += &format!("strip {p}/{q} {u}/{v}\n{}\n", "O;".repeat(40));
            }
            block
        })
        .collect();
    let lines = blocks.iter().map(|block| block.lines().count() as u64).sum();
    let text = cover::header(&(3..=35), lines) + &blocks.concat();
    match answer(&text) {
        Err(Rejection::Undecided { line: 10, reason }) => {
            let area = reason.split("area ").nth(1).unwrap().split(' ').next().unwrap();
            assert!((area.parse::<f64>().unwrap() - 16.5).abs() < 1e-9, "{reason}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_line_without_end_is_refused() {
    let head = COVER.lines().take(9).map(|line| format!("{line}\n")).collect::<String>();
    let why = rejected(&(head + &"P;".repeat(1 << 24)));
    assert!(why.ends_with("malformed: the line is longer than 16777216 bytes"), "{why}");
}
