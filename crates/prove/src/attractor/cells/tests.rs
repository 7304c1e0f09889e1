//! In gaps weights are found; in windows, and below 1/4, none.

use num_bigint::BigInt;

use super::*;
use crate::number::parse_rational;

fn at(text: &str) -> [BigRational; 2] {
    [0, 1].map(|_| parse_rational(text).unwrap())
}

/// The same number twice, to 14 places.
fn twice(x: f64) -> [BigRational; 2] {
    let scale = 10i64.pow(14);
    [0, 1].map(|_| BigRational::new(BigInt::from((x * scale as f64).round() as i64), BigInt::from(scale)))
}

/// Of a cosine with these eigenvalues of a period, τ = 4/5, at a depth.
fn problem([slow, fast]: [f64; 2], depth: f64) -> CellsProblem {
    let [a, b] = [slow, fast].map(|x: f64| -x.ln() / std::f64::consts::TAU);
    let harmonics = vec![(1, [at("1"), at("0")])];
    CellsProblem { ranges: [twice(a + b), twice(a * b), at("4/5")], harmonics, depths: twice(depth) }
}

/// Forty depths are a period of the windows, which is λ₁². Where a stable orbit is, none of them is proved.
#[test]
fn gaps_close_and_windows_do_not() {
    for (slow, depth, gaps, windows) in [
        (0.57, 1e-3, vec![0, 9, 17], vec![19, 30, 38]),
        (0.57, 1e-9, vec![0, 6, 28, 39], vec![8, 20]),
        (0.42, 1e-6, vec![30, 33], vec![5, 20, 36]),
        (0.30, 1e-9, vec![16], vec![10, 20, 30]),
        (0.2, 1e-3, vec![], vec![0, 10, 20, 30]),
    ] {
        for (i, is_gap) in gaps.iter().map(|i| (i, true)).chain(windows.iter().map(|i| (i, false))) {
            let depth = depth * f64::powf(slow * slow, f64::from(*i) / 40.0);
            match prove_cells(&problem([slow, 0.005], depth), &()).unwrap() {
                Ok(proof) => {
                    assert!(is_gap && proof.growth > 1.0 && proof.rate > 0.0, "{slow} {depth}: {proof:?}");
                    assert!(proof.accepted.text().len() < 20_000, "{}", proof.accepted.text().len());
                }
                Err(why) => assert!(!is_gap && why == RangeEnd::Map, "{slow} {depth}: {why:?}"),
            }
        }
    }
}

/// Three cells prove more of the paper's oscillator than the formulas do, which reach 1.32.
#[test]
fn few_cells_are_enough_where_all_impacts_grow() {
    let of = |c: &str, k: &str, depths: [&str; 2]| CellsProblem {
        ranges: [at(c), at(k), at("4/5")],
        harmonics: vec![(1, [at("1"), at("0")])],
        depths: depths.map(|x| parse_rational(x).unwrap()),
    };
    let proof = prove_from(&of("3/8", "1/64", ["1/101", "1/100"]), (3, 0), &()).unwrap().unwrap();
    assert!(proof.certificate.cells.len() == 3 && proof.growth > 1.75, "{proof:?}");
    // The sample of the checker, in a gap.
    let proof = prove_from(&of("3/5", "1/25", ["1/127", "1/126"]), (16, 0), &()).unwrap().unwrap();
    assert_eq!(proof.accepted.text(), include_str!("../../../../checker/tests/data/attractor-cells.txt"));
}

/// Where returns are late there are as many cells as a check of bounded work looks at.
#[test]
fn the_checks_work_is_bounded() {
    for (slow, fast) in [(0.92, 0.7), (0.955, 0.7)] {
        let proof = prove_cells(&problem([slow, fast], 0.01), &()).unwrap().unwrap();
        let (cells, last) = (proof.certificate.cells.len() as u64, proof.certificate.last);
        assert!(cells * last <= WORK && proof.growth > 1.0, "{cells} {last}");
    }
}

#[test]
fn what_is_not_so_has_a_reason() {
    let of = |c: &str, harmonics: &[(u64, [&str; 2])], depth: &str| CellsProblem {
        ranges: [at(c), at("1/25"), at("4/5")],
        harmonics: harmonics.iter().map(|(order, parts)| (*order, parts.map(at))).collect(),
        depths: at(depth),
    };
    let cosine: &[(u64, [&str; 2])] = &[(1, ["1", "0"])];
    for (problem, reason) in [
        (of("1/10", cosine, "1/100"), "overdamped"),
        (of("3/5", &[(2, ["1", "0"])], "1/100"), "one top"),
        (of("3/5", cosine, "3/4"), "no trap"),
    ] {
        match prove_cells(&problem, &()).unwrap() {
            Err(RangeEnd::Refused(why)) => assert!(why.contains(reason), "{why}"),
            found => panic!("{reason}: {found:?}"),
        }
    }
}
