//! Beyond a touch of an overdamped oscillator: that chaos attracts, at every depth up to one, proved.
//!
//! proofs/attractor.md has the theorem. Nothing is searched for but the depth: at one depth ten formulas
//! (`constants`) give the trap and how displacements grow in it, and what they prove there they prove below.
//! The largest depth at which these still grow is found by halving, and the checker judges. Where that gives
//! nothing, as in gaps between windows, `cells` proves one depth. Not here: reports.
//!
//! ```
//! use grazing_scenes::certificate;
//! use grazing_scenes::number::parse_rational;
//! use grazing_scenes::search::attractor::{AttractorProblem, prove_attractor};
//! // The paper's oscillator with d = 3/2, w = 8 and τ = 4/5, to ν = 1/100.
//! let at = |x| -> grazing_scenes::Result<_> { Ok([parse_rational(x)?, parse_rational(x)?]) };
//! let problem = AttractorProblem {
//!     ranges: [at("3/8")?, at("1/64")?, at("4/5")?],
//!     harmonics: vec![(1, [at("1")?, at("0")?])],
//!     deepest: 0.01,
//! };
//! let proof = prove_attractor(&problem, &())?.unwrap();
//! assert_eq!((proof.depth, proof.growth > 1.32), (parse_rational("1/100")?, true));
//! assert!(certificate::check(&mut proof.accepted.text().as_bytes()).is_ok());
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod case;
mod cells;
mod constants;
#[cfg(test)]
mod numbers;
mod stop;
mod write;

use num_rational::BigRational;
use num_traits::ToPrimitive;

pub use self::{
    case::{Case, Window, case, eigenvalue, windows},
    cells::{CellsProblem, CellsProof, prove_cells},
};
use self::{
    constants::{Constants, Rates},
    stop::Stop,
};
use crate::{
    Accepted, certificate::attractor::Certificate, chaos::Term, chaos::profile::Profile, error::Result,
    monitor::Monitor, range::RangeEnd,
};

/// What is to be proved: beyond its touch an overdamped oscillator has a trap, and all in it is chaotic.
#[derive(Debug, Clone)]
pub struct AttractorProblem {
    /// The ranges of c, k, τ.
    pub ranges: [[BigRational; 2]; 3],
    /// The harmonics of the wall's motion g, their orders increasing; its top is g(0) = 1.
    pub harmonics: Vec<Term>,
    /// No depth beyond this is asked for.
    pub deepest: f64,
}

/// A proof that has passed the checker.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct AttractorProof {
    /// The certificate.
    pub certificate: Certificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
    /// The greatest ν.
    pub depth: BigRational,
    /// E: by this factor at least displacements grow from contact to contact.
    pub growth: f64,
    /// From which ν on an exponent is proved, and how large, per period.
    pub exponent: Option<(BigRational, f64)>,
    /// The start: trapped is what begins with 0 ≤ aq + q′ ≤ this.
    pub start: f64,
    /// Why it goes no further.
    pub end: RangeEnd,
}

/// The smallest depth.
const SMALLEST: f64 = 1e-9;
/// How often the depth is halved: to six digits.
const HALVINGS: u32 = 24;
/// The least growth that is looked for: what a certificate has digits for.
const LEAST: f64 = 1.0002;
/// How often a depth that the checker refuses is made smaller, and by what.
const TRIES: u32 = 6;
const SMALLER: f64 = 0.98;

/// The largest depth that is found, or why there is none: the oscillator may not be overdamped, the wall have
/// more than one top, or displacements not grow at any depth.
///
/// Cost: 25 evaluations of the formulas, each of as many exponentials as the longest return has periods, and
/// the check.
///
/// # Errors
/// An interruption; numbers of more digits than a certificate holds.
pub fn prove_attractor(
    problem: &AttractorProblem,
    monitor: &dyn Monitor,
) -> Result<std::result::Result<AttractorProof, RangeEnd>> {
    let refused = |why: &str| Ok(Err(RangeEnd::Refused(why.into())));
    let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
    let Some(rates) = Rates::of(problem.ranges.each_ref().map(|ends| ends.each_ref().map(float))) else {
        return refused("the oscillator may not be overdamped");
    };
    let profile = Profile::new(&problem.harmonics);
    let at = |depth: f64| {
        let stop = Stop::of(&profile, depth)?;
        let constants = Constants::of(&rates, &stop, depth)?;
        (constants.growth >= LEAST).then_some((stop, constants))
    };
    let asked = problem.deepest;
    let mut depth = asked;
    if at(asked).is_none() {
        let (mut lo, mut hi) = (SMALLEST, asked);
        if at(lo).is_none() {
            return refused(why_not(&rates, &profile));
        }
        for _ in 0..HALVINGS {
            let middle = (lo * hi).sqrt();
            if at(middle).is_some() { lo = middle } else { hi = middle }
        }
        depth = lo;
    }
    let mut why = String::new();
    for _ in 0..TRIES {
        monitor.advance(0)?;
        depth = crate::range::write::depth(depth);
        let Some((stop, constants)) = at(depth) else {
            depth *= SMALLER;
            continue;
        };
        let end = if depth >= asked * (1.0 - 1e-5) { RangeEnd::Asked } else { RangeEnd::Map };
        match write::proof(problem, (&rates, &stop, &constants), depth, end)? {
            Ok(proof) => return Ok(Ok(proof)),
            Err(reason) => why = reason,
        }
        depth *= SMALLER;
    }
    Ok(Err(RangeEnd::Refused(why)))
}

/// Why there is no depth.
fn why_not(rates: &Rates, profile: &Profile) -> &'static str {
    if Stop::of(profile, SMALLEST).is_none() {
        return "the stop is not seen to have one top in a period";
    }
    match rates.share() < 2.0 / 3.0 {
        true => "lambda_1 may be below 2/3, where displacements need not grow at every impact",
        false => "displacements are not seen to grow at every impact, at any depth",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_rational;

    fn problem(ranges: [[&str; 2]; 3], harmonics: &[(u64, [&str; 2])], deepest: f64) -> AttractorProblem {
        let exact = |text: &str| parse_rational(text).unwrap();
        let ranges = ranges.map(|ends| ends.map(exact));
        let harmonics =
            harmonics.iter().map(|(order, parts)| (*order, parts.map(|x| [exact(x), exact(x)]))).collect();
        AttractorProblem { ranges, harmonics, deepest }
    }

    const COSINE: &[(u64, [&str; 2])] = &[(1, ["1", "0"])];

    /// The paper's oscillator with d = 3/2, w = 8 and τ = 4/5.
    fn paper(deepest: f64) -> AttractorProblem {
        problem([["3/8"; 2], ["1/64"; 2], ["4/5"; 2]], COSINE, deepest)
    }

    /// µ = ν/(1 − ν) of the paper: what the formulas give there, and the least growth of true motions.
    #[test]
    fn depths_of_the_paper_are_proved_with_their_growth() {
        for (mu, growth, seen) in [
            (0.1, 1.0051, 1.370),
            (0.03, 1.2320, 1.7),
            (0.01, 1.3213, 1.780),
            (1e-3, 1.3998, 1.715),
            (1e-4, 1.4204, 1.72),
        ] {
            let proof = prove_attractor(&paper(mu / (1.0 + mu)), &()).unwrap().unwrap();
            assert!((proof.growth - growth).abs() < 3e-4 && proof.growth < seen, "{mu}: {}", proof.growth);
            assert_eq!(proof.end, RangeEnd::Asked);
        }
    }

    #[test]
    fn the_largest_depth_is_found() {
        let proof = prove_attractor(&paper(0.999), &()).unwrap().unwrap();
        let depth = proof.depth.to_f64().unwrap();
        assert!((0.0916..0.093).contains(&depth) && proof.end == RangeEnd::Map, "{depth}");
        assert!((1.0..1.001).contains(&proof.growth));
        // All tolerances at once, d ± 0.001, w ± 0.01 and τ ± 0.01, to µ = 0.05.
        let wide = [["2998/8010", "3002/7990"], ["10000/641601", "10000/638401"], ["79/100", "81/100"]];
        let proof = prove_attractor(&problem(wide, COSINE, 0.05 / 1.05), &()).unwrap();
        let growth = proof.unwrap().growth;
        assert!((1.127..1.14).contains(&growth), "{growth}");
    }

    #[test]
    fn walls_of_several_harmonics_are_seen() {
        let wall = &[(1, ["9/10", "1/10"]), (2, ["1/10", "-1/20"])];
        let several = problem([["3/8"; 2], ["1/64"; 2], ["4/5"; 2]], wall, 0.999);
        let proof = prove_attractor(&several, &()).unwrap().unwrap();
        assert!(
            proof.depth.to_f64().unwrap() > 0.04 && proof.certificate.setting.shown.is_some(),
            "{}",
            proof.depth
        );
        // Another top, nearly as high.
        let two = &[(1, ["1/20", "0"]), (2, ["19/20", "0"])];
        let refused =
            prove_attractor(&problem([["3/8"; 2], ["1/64"; 2], ["4/5"; 2]], two, 0.999), &()).unwrap();
        // It is proved up to where the other top comes out, at ν = 1/10.
        assert!(refused.unwrap().depth.to_f64().unwrap() < 0.1);
        let equal = &[(2, ["1", "0"])];
        let refused =
            prove_attractor(&problem([["3/8"; 2], ["1/64"; 2], ["4/5"; 2]], equal, 0.999), &()).unwrap();
        assert!(matches!(refused, Err(RangeEnd::Refused(why)) if why.contains("one top")));
    }

    #[test]
    fn what_is_not_so_has_a_reason() {
        for (ranges, reason) in [
            ([["3/5"; 2], ["1/25"; 2], ["4/5"; 2]], "2/3"),
            ([["1/10"; 2], ["1/25"; 2], ["4/5"; 2]], "overdamped"),
            ([["1/10", "1"], ["1/25"; 2], ["4/5"; 2]], "overdamped"),
        ] {
            match prove_attractor(&problem(ranges, COSINE, 0.999), &()).unwrap() {
                Err(RangeEnd::Refused(why)) => assert!(why.contains(reason), "{why}"),
                found => panic!("{found:?}"),
            }
        }
    }
}
