//! The theory at one point, as on the command line: exact numbers, values with their signs, which orbits
//! exist; and small certificates, found here so that the checker has something to prove.
//!
//! A place is given by two exact numbers as text: `plane`, the trace a₁ and the determinant a₂, or `polar`,
//! the modulus r and the angle s, over a turn, of complex eigenvalues.

use std::collections::HashMap;

use grazing_scenes::{
    certificate::cover::check_block,
    existence::{Existence, Resonance, large_eigenvalue_sign, up_to},
    local::{Answer as SignAnswer, Forward, Ladder, Plane, Point, Polar, Quantity, Region},
    num_rational::BigRational,
    number::{Precision, Sign, ball_digits, parse_rational},
    pattern::{Entry, Graph, Map, PatternExistence, Patterns},
    search::{
        ProofMethod,
        cover::{Cover, CoverOptions, certificate, cover as search_cover},
        prove_theorem2, write_theorem2,
    },
};
use num_traits::{Signed, ToPrimitive};
use serde_json::{Value, json};

use crate::answer::{self, Answer, Fault};

/// The largest period that `classify` and `evaluate` list, and that a certificate made here has; more takes
/// longer than a user of a page waits.
const MOST: u64 = 10_000;

/// The largest period of a cover.
const MOST_COVERED: u64 = 64;

/// The largest period of Theorem 2.
const MOST_PROVED: u64 = 400;

/// The largest period of an impact pattern; there are 2^P/P patterns of period P.
const MOST_PATTERN: u64 = 14;

/// The precision of printed digits, in bits.
const BITS: std::ops::RangeInclusive<u32> = 16..=4096;

/// An exact number as the command line takes it, such as `3/8+2^-200`: `{"exact": "P/Q", "value": x}`, where
/// x is the nearest double.
pub fn number(text: &str) -> String {
    answer::json(exact("number", text).map(|exact| {
        let value = exact.to_f64();
        json!({ "exact": exact.to_string(), "value": value })
    }))
}

/// Which orbits with one impact exist at a place, for the periods 1 to `max_n`: the rows of `grazing classify
/// --format json`, with the region in words, whether time was reversed (a₂ > 1), and what is born at
/// resonances.
pub fn classify(place: &str, x: &str, y: &str, max_n: u32) -> String {
    answer::json(classified(place, x, y, max_n.into()))
}

fn classified(place: &str, x: &str, y: &str, max_n: u64) -> Answer {
    if !(1..=MOST).contains(&max_n) {
        return Err(Fault::new(format!("periods 1 to {max_n}: the last is from 1 to {MOST}")).of("max_n"));
    }
    let [_, second] = names(place)?;
    let [x, y] = numbers(place, x, y)?;
    let made = if place == "plane" { Forward::plane(x, y) } else { Forward::polar(x, y) };
    let forward = made.map_err(|error| Fault::from(error).of(second))?;
    let ladder = Ladder::default();
    let found = up_to(&ladder, &forward.point, max_n, || Ok(()))?;
    let rows: Vec<Value> = (1..).zip(found).flat_map(|(n, existence)| rows(&forward, n, existence)).collect();
    let resonances: Vec<_> =
        Resonance::up_to(&forward.point, max_n).into_iter().filter(|(_, kind)| kind.is_some()).collect();
    Ok(json!({
        "region": describe(forward.region),
        "reversed": forward.reversed,
        "rows": rows,
        "resonances": Resonance::in_words(&resonances),
    }))
}

/// One row per case of an orbit, or one that says why there is none.
fn rows(place: &Forward, n: u64, existence: Existence) -> Vec<Value> {
    let name = existence.name();
    let [positive, negative, zero] = existence.indices().map(|k| k.map(|k| place.index(n, k)));
    let resonance = Resonance::at(&place.point, n);
    let row = |emu: Option<i8>, gamma: Option<i8>, eigenvalue: Option<i8>| {
        json!({
            "n": n, "existence": name, "sign_emu": emu, "sign_gamma": gamma, "large_eigenvalue": eigenvalue,
            "positive_k": positive, "negative_k": negative, "zero_k": zero,
            "resonance": resonance.map(Resonance::name),
        })
    };
    let cases = existence.cases(n);
    if cases.is_empty() {
        return vec![row(None, None, None)];
    }
    let of = |case| large_eigenvalue_sign(place.region, n, case);
    cases
        .into_iter()
        .map(|case| row(Some(case.sign_emu()), Some(case.sign_gamma()), Some(of(case))))
        .collect()
}

/// A region in words.
fn describe(region: Region) -> &'static str {
    match region {
        Region::One => "Region 1: 0 < λ₂ < 1 < λ₁",
        Region::Two => "Region 2: eigenvalues in (0, 1)",
        Region::Three => "Region 3: complex eigenvalues",
        Region::Four => "Region 4: eigenvalues in (−1, 0)",
        Region::Five => "Region 5: λ₂ < −1 < λ₁ < 0",
        Region::Line => "On a line |a₁| = a₂ + 1: an eigenvalue 1 or −1",
    }
}

/// b_{n,k}, all of them where `k` is 0, and c_n at a place: the values of `grazing evaluate --format json`.
pub fn evaluate(place: &str, x: &str, y: &str, n: u32, k: u32, bits: u32) -> String {
    answer::json(evaluated(place, x, y, n.into(), k.into(), bits))
}

fn evaluated(place: &str, x: &str, y: &str, n: u64, k: u64, bits: u32) -> Answer {
    if n == 0 || (k == 0 && n > MOST) {
        let fault = format!("n = {n}: at least 1, and where all k are listed at most {MOST}");
        return Err(Fault::new(fault).of("n"));
    }
    if k >= n && k > 0 {
        return Err(Fault::new(format!("k = {k} is outside 1 <= k < n = {n}")).of("k"));
    }
    if !BITS.contains(&bits) {
        let fault = format!("{bits} bits: from {} to {}", BITS.start(), BITS.end());
        return Err(Fault::new(fault).of("bits"));
    }
    let [x, y] = numbers(place, x, y)?;
    let point = point(place, x, y)?;
    let range = if k > 0 { k..k + 1 } else { 1..n };
    let (ladder, precision) = (Ladder::default(), Precision::new(bits));
    let value = |quantity| {
        let decision = ladder.sign(&point, quantity);
        let digits = if decision.answer == SignAnswer::Sign(Sign::Zero) {
            Some("0".to_string())
        } else {
            let ball = point.evaluate_closely(quantity, &precision);
            ball.and_then(|ball| ball_digits(&ball, bits * 3 / 10))
        };
        json!({ "name": quantity, "sign": decision.answer, "decided_by": decision.rung, "value": digits })
    };
    let values: Vec<Value> =
        range.map(|k| Quantity::B { n, k }).chain([Quantity::C { n }]).map(value).collect();
    Ok(json!({ "n": n, "values": values }))
}

/// Which impact patterns of period up to `max_period` have an orbit at (a₁, a₂), for that sign of γ: rows as
/// of `grazing existence` for the map A = [[a₁, 1], [−a₂, 0]], B = [0, ±1], C = [1, 0], e = 1.
pub fn existence(a1: &str, a2: &str, gamma_positive: bool, max_period: u32) -> String {
    answer::json(patterns(a1, a2, gamma_positive, max_period.into()))
}

fn patterns(a1: &str, a2: &str, gamma_positive: bool, max_period: u64) -> Answer {
    if !(1..=MOST_PATTERN).contains(&max_period) {
        let fault = format!("periods up to {max_period}: the last is from 1 to {MOST_PATTERN}");
        return Err(Fault::new(fault).of("max_period"));
    }
    let [a1, a2] = numbers("plane", a1, a2)?;
    let entry = |x: BigRational| Entry::between(x.clone(), x);
    let whole = |x: i32| entry(BigRational::from_integer(x.into()));
    let map = Map::new(
        vec![vec![entry(a1)?, whole(1)?], vec![entry(-a2)?, whole(0)?]],
        vec![whole(0)?, whole(if gamma_positive { 1 } else { -1 })?],
        vec![whole(1)?, whole(0)?],
        whole(1)?,
        None,
    )?;
    let graph = Graph::new(&map, max_period, false)?;
    let row = |pattern: grazing_scenes::pattern::Pattern| {
        let report = graph.judge(pattern.periods());
        let verdict = match (report.plus, report.minus) {
            (PatternExistence::Orbit, _) => "emu>0",
            (_, PatternExistence::Orbit) => "emu<0",
            (PatternExistence::NoOrbit, PatternExistence::NoOrbit) => "neither",
            _ => "undecided",
        };
        json!({
            "pattern": pattern.to_string(),
            "period": pattern.period(),
            "impacts": pattern.periods().len(),
            "verdict": verdict,
            "sign_emu": report.side().map(|positive| if positive { 1 } else { -1 }),
            "reason": report.reason.map(|reason| reason.to_string()),
        })
    };
    let rows: Vec<Value> = (1..=max_period).flat_map(Patterns::of_period).map(row).collect();
    Ok(json!({ "rows": rows }))
}

/// Conjecture 1 for the periods `first` to `last`, r ≤ `r_max` (1 − 1/n³ where it is empty): the tallies of
/// `grazing cover`, and the certificate where every period is proved.
pub fn cover(first: u32, last: u32, r_max: &str) -> String {
    answer::json(covered(first.into(), last.into(), r_max))
}

fn covered(first: u64, last: u64, r_max: &str) -> Answer {
    if first < 3 || first > last || last > MOST_COVERED {
        let fault = format!("periods {first} to {last}: from 3 up to {MOST_COVERED} in the page");
        return Err(Fault::new(fault).of("last"));
    }
    let mut options = CoverOptions::new(first..=last);
    if !r_max.trim().is_empty() {
        options.r_max = Some(exact("r_max", r_max)?);
    }
    let covers = search_cover(&options, HashMap::new(), &(), &|_, _| Ok(()))?;
    let blocks: Vec<Option<String>> = covers.iter().map(Cover::block).collect();
    let verdict = |cover: &Cover, block: &Option<String>| match (&cover.refuted, block) {
        (Some(_), _) => "refuted",
        (None, Some(block)) if check_block(cover.n, block.as_bytes(), 0).is_ok() => "proved",
        _ => "undecided",
    };
    let verdicts: Vec<&str> =
        covers.iter().zip(&blocks).map(|(cover, block)| verdict(cover, block)).collect();
    let periods = covers.iter().zip(&verdicts).map(|(cover, verdict)| {
        let tally = cover.tally();
        json!({
            "n": cover.n, "verdict": verdict, "r_max": cover.r_max.to_string(), "areas": tally.areas,
            "leaves": tally.leaves(), "none": tally.none, "orbit": tally.orbit, "edge": tally.edge,
            "depth": tally.depth, "open": tally.open.len(),
            "witness": cover.refuted.as_ref().map(ToString::to_string),
        })
    });
    let periods: Vec<Value> = periods.collect();
    let proved = verdicts.iter().all(|&verdict| verdict == "proved");
    let blocks: Option<Vec<String>> = blocks.into_iter().collect();
    let text = blocks.filter(|_| proved).map(|blocks| certificate(&options.periods, &blocks));
    Ok(json!({ "periods": periods, "certificate": text }))
}

/// Theorem 2 for the periods `first` to `last`: its certificate, as of `grazing verify --certificate`.
pub fn theorem2(first: u32, last: u32) -> String {
    answer::json(proved(first.into(), last.into()))
}

fn proved(first: u64, last: u64) -> Answer {
    if first < 1 || first > last || last > MOST_PROVED {
        let fault = format!("periods {first} to {last}: from 1 up to {MOST_PROVED} in the page");
        return Err(Fault::new(fault).of("last"));
    }
    let proof = prove_theorem2(first..=last, ProofMethod::Exact, &())?;
    let mut text = Vec::new();
    write_theorem2(first..=last, &proof, &mut text, &())?;
    Ok(json!({ "certificate": String::from_utf8_lossy(&text) }))
}

/// An exact number, the argument `key`.
fn exact(key: &str, text: &str) -> Answer<BigRational> {
    parse_rational(text.trim()).map_err(|error| Fault::from(grazing_scenes::Error::from(error)).of(key))
}

/// The names of a place's numbers.
fn names(place: &str) -> Answer<[&'static str; 2]> {
    match place {
        "plane" => Ok(["a1", "a2"]),
        "polar" => Ok(["r", "s"]),
        _ => Err(Fault::new(format!("{place:?}: a place is \"plane\" or \"polar\"")).of("place")),
    }
}

fn numbers(place: &str, x: &str, y: &str) -> Answer<[BigRational; 2]> {
    let [first, second] = names(place)?;
    let (x, y) = (exact(first, x)?, exact(second, y)?);
    let (name, value) = if place == "plane" { (second, &y) } else { (first, &x) };
    if !value.is_positive() {
        return Err(Fault::new(format!("{name} = {value}: it is above 0")).of(name));
    }
    Ok([x, y])
}

fn point(place: &str, x: BigRational, y: BigRational) -> Answer<Point> {
    let names = names(place)?;
    let made = if place == "plane" {
        Plane::new(x, y).map(Point::Plane)
    } else {
        Polar::new(x, y).map(Point::Polar)
    };
    made.map_err(|error| Fault::from(error).of(names[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: String) -> Value {
        serde_json::from_str(&text).unwrap()
    }

    /// The trusted checker accepts what is made here, and for the periods asked for.
    #[test]
    fn certificates_pass_the_checker() {
        for (made, kind) in [(theorem2(2, 9), "theorem2"), (cover(3, 6, ""), "cover")] {
            let text = of(made)["certificate"].as_str().unwrap().to_string();
            assert_eq!(grazing_check::check(&mut text.as_bytes()).unwrap().kind, kind);
        }
    }

    /// Every way to be wrong names the argument, and none panics.
    #[test]
    fn faults_name_their_argument() {
        for (answer, key) in [
            (number("1/0"), "number"),
            (classify("polar", "1", "1/2", 3), "s"),
            (classify("polar", "x", "1/3", 3), "r"),
            (classify("polar", "0", "1/3", 3), "r"),
            (classify("plane", "1", "0", 3), "a2"),
            (classify("sphere", "1", "1", 3), "place"),
            (classify("plane", "1", "1", 0), "max_n"),
            (evaluate("plane", "1", "1/2", 0, 0, 64), "n"),
            (evaluate("plane", "1", "1/2", 4, 4, 64), "k"),
            (evaluate("plane", "1", "1/2", u32::MAX, 0, 64), "n"),
            (evaluate("plane", "1", "1/2", 4, 0, 1), "bits"),
            (existence("1", "1/2", true, 99), "max_period"),
            (cover(2, 5, ""), "last"),
            (cover(3, 4, "one"), "r_max"),
            (theorem2(5, 4), "last"),
        ] {
            assert_eq!(of(answer)["error"]["key"], key);
        }
    }

    /// Time reversed, b_{n,k} becomes b_{n,n−k}: (a₁, a₂) and (a₁/a₂, 1/a₂) have the same orbits.
    #[test]
    fn reversed_time_has_the_same_orbits() {
        let (there, back) = (of(classify("plane", "-3/2", "3/2", 9)), of(classify("plane", "-1", "2/3", 9)));
        assert_eq!([&there["reversed"], &back["reversed"]], [true, false]);
        let rows = [&there, &back].map(|found| found["rows"].as_array().unwrap());
        assert_eq!(rows[0].len(), rows[1].len());
        for (there, back) in rows[0].iter().zip(rows[1]) {
            assert_eq!([&there["existence"], &there["sign_emu"]], [&back["existence"], &back["sign_emu"]]);
            for key in ["positive_k", "negative_k", "zero_k"] {
                let (n, k) = (there["n"].as_u64(), there[key].as_u64());
                assert_eq!(k.map(|k| n.unwrap() - k), back[key].as_u64());
            }
        }
    }
}
