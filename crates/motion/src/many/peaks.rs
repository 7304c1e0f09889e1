//! Peaks of a linear response over a parameter, and their half-power points.
//!
//! A harmonic a cos kt + b sin kt of a displacement or a gap has the amplitude A = √(a² + b²), and its climb
//! d(A²)/dp = 2 (aa′ + bb′) has no error but rounding's (of formulas a′ and b′ are differences, to some
//! 10⁻¹⁰). So a peak is a zero of it, where it falls, between two neighbouring floats. It is looked for
//! between neighbouring samples: the given values; at each resonance of a mode (|λ| = k) that is seen between
//! two of these the instants of parameter half a bandwidth, one and four away from it; and the ends of
//! *pieces*, into which these are halved until every climb has at most one zero in each.
//!
//! Over the frequency a climb is a rational function, so its Chebyshev series on a piece falls off
//! geometrically once the piece is shorter than the way to the poles, which are the modes. With the
//! coefficients c₀ to c₁₁ from as many points, and what is beyond them estimated by the last two, a climb has
//! no zero where |c₀| is more than all others together, and at most one where that holds of its derivative.
//! What the estimate does not see is a pole beside a piece that resonates between no two of the given values,
//! as a mode that comes and goes within one step of a parameter which is not the frequency.

use std::f64::consts::PI;

use crate::{
    error::Result,
    many::resonance::{AtValue, FreeResponse, modes, near_resonances},
    rounding::SUM,
};

/// A peak of a harmonic's amplitude.
#[derive(Debug, Clone, PartialEq)]
pub struct Peak {
    /// Which coordinate or gap.
    pub place: usize,
    /// Where it is.
    pub value: f64,
    /// How high; none where nothing damps the mode that resonates.
    pub harmonic: Option<[f64; 2]>,
    /// Where the amplitude is 1/√2 of it, before and after; none for a reason.
    pub half: std::result::Result<[f64; 2], &'static str>,
    /// The natural frequency, as a multiple of the drive's, and damping ratio of the mode that is nearest.
    pub mode: Option<[f64; 2]>,
}

/// A damping ratio up to which a mode counts as undamped.
const UNDAMPED: f64 = 1e-13;
/// Coefficients of a climb on a piece.
const POINTS: usize = 12;
/// How often a piece is halved, and pieces at most.
const DEEP: u32 = 40;
const MOST: u32 = 10_000;
/// A climb so small beside its terms is rounding's, of differences too.
const ROUNDED: f64 = 1e-9;
/// A value at which the response is known: the square of each amplitude, and its derivative.
struct Sample {
    value: f64,
    squares: Vec<[f64; 2]>,
}

/// The peaks of a harmonic, by coordinate or gap and then by value, and whether these are all: if not, a
/// climb is not resolved somewhere, as where the parameter makes it jump. `values` ascend. Cost: a response
/// per value, some 200 per peak and 12 per piece, of which there are some ten per mode and more the less it
/// is damped, each O(n³) for n coordinates.
///
/// # Errors
/// Those of [`FreeResponse::at`].
pub fn peaks(
    family: AtValue,
    values: &[f64],
    k: u32,
    check: &mut dyn FnMut() -> Result<()>,
) -> Result<(Vec<Peak>, bool)> {
    let sample = |value: f64| -> Result<Option<Sample>> {
        let Some(found) = FreeResponse::at(family, value)? else { return Ok(None) };
        let square = |(place, [a, b]): (usize, [f64; 2])| [a * a + b * b, found.climb(place, k).0];
        Ok(Some(Sample { value, squares: found.harmonics(k).into_iter().enumerate().map(square).collect() }))
    };
    let mut ends = near_resonances(family, values, &[k], check)?;
    ends.extend([values[0], values[values.len() - 1]]);
    ends.sort_by(f64::total_cmp);
    let mut climbs = |value: f64| {
        check()?;
        let found = FreeResponse::at(family, value)?;
        let all = |found: FreeResponse| (0..found.places()).map(|place| found.climb(place, k)).collect();
        Ok(found.map(all))
    };
    let (mut all, mut left) = ([values, &ends].concat(), MOST);
    for pair in ends.windows(2) {
        cut([pair[0], pair[1]], DEEP, &mut left, &mut climbs, &mut all)?;
    }
    let resolved = left > 0;
    all.sort_by(f64::total_cmp);
    all.dedup();
    let mut samples = Vec::new();
    for value in all {
        check()?;
        samples.extend(sample(value)?);
    }
    let Some(first) = samples.first() else { return Ok((Vec::new(), resolved)) };
    let mut found = Vec::new();
    for place in 0..first.squares.len() {
        // What rounding leaves of a displacement that the drive does not move has no peaks.
        let most = samples.iter().map(|sample| sample.squares[place][0]).fold(0.0, f64::max);
        let whole = samples.iter().flat_map(|sample| &sample.squares).map(|x| x[0]).fold(0.0, f64::max);
        if most <= SUM * SUM * whole {
            continue;
        }
        for i in 1..samples.len() {
            let [before, after] = [&samples[i - 1], &samples[i]].map(|sample| sample.squares[place][1]);
            if !(before > 0.0 && after <= 0.0) {
                continue;
            }
            check()?;
            let climbs = |value: f64| Ok(sample(value)?.map(|found| found.squares[place][1]));
            let value = turn([samples[i - 1].value, samples[i].value], climbs)?;
            let mode = nearest(&modes(family, value)?, k);
            let response = FreeResponse::at(family, value)?;
            let damped = mode.is_none_or(|[_, ratio]| ratio.abs() > UNDAMPED);
            let harmonic = response.filter(|_| damped).map(|found| found.harmonics(k)[place]);
            let square = |value: f64| Ok(sample(value)?.map(|found| found.squares[place]));
            let half = match harmonic {
                None => Err("undamped"),
                Some([a, b]) => half_power((value, (a * a + b * b) / 2.0), &samples, square)?,
            };
            found.push(Peak { place, value, harmonic, half, mode });
        }
    }
    Ok((found, resolved))
}

/// What a climb is at a value, and its terms, for each place; none where there is no response.
type Climbs = Option<Vec<(f64, f64)>>;

/// Adds ends of pieces within which every climb has one zero at most.
fn cut(
    [from, to]: [f64; 2],
    deep: u32,
    left: &mut u32,
    climbs: &mut dyn FnMut(f64) -> Result<Climbs>,
    ends: &mut Vec<f64>,
) -> Result<()> {
    let middle = from + (to - from) / 2.0;
    if deep == 0 || *left == 0 || middle <= from || middle >= to {
        return Ok(());
    }
    *left -= 1;
    let looks: Vec<Climbs> =
        (0..POINTS).map(|j| climbs(middle + (to - from) / 2.0 * angle(j).cos())).collect::<Result<_>>()?;
    let known: Vec<_> = looks.iter().flatten().collect();
    let settled = |places: usize| (0..places).all(|place| turns_once(&known, place));
    if known.is_empty() || known.len() == POINTS && settled(known[0].len()) {
        return Ok(());
    }
    cut([from, middle], deep - 1, left, climbs, ends)?;
    ends.push(middle);
    cut([middle, to], deep - 1, left, climbs, ends)
}

/// arccos of a point of Chebyshev's.
fn angle(j: usize) -> f64 {
    PI * (j as f64 + 0.5) / POINTS as f64
}

/// Whether a climb has one zero at most on a piece, or is nothing but rounding there.
fn turns_once(looks: &[&Vec<(f64, f64)>], place: usize) -> bool {
    let term = |i: usize, j: usize| looks[j][place].0 * (i as f64 * angle(j)).cos();
    let mut c: Vec<f64> =
        (0..POINTS).map(|i| 2.0 / POINTS as f64 * (0..POINTS).map(|j| term(i, j)).sum::<f64>()).collect();
    c[0] /= 2.0;
    let whole = looks.iter().copied().flatten().map(|look| look.1).fold(0.0, f64::max);
    let own = looks.iter().map(|look| look[place].1).fold(0.0, f64::max);
    if c.iter().map(|c| c.abs()).sum::<f64>() <= ROUNDED * own + SUM * SUM * whole {
        return true;
    }
    // Of a series that halves from term to term, twice the last two are more than what is missing, and n²
    // times as much more than what is missing of the derivative.
    let rest = 2.0 * (c[POINTS - 2].abs() + c[POINTS - 1].abs());
    let mut slope = vec![0.0; POINTS + 1];
    for i in (1..POINTS).rev() {
        slope[i - 1] = slope.get(i + 1).unwrap_or(&0.0) + 2.0 * i as f64 * c[i];
    }
    slope[0] /= 2.0;
    let leads = |c: &[f64], rest: f64| c[0].abs() > rest + c[1..].iter().map(|c| c.abs()).sum::<f64>();
    leads(&c, rest) || leads(&slope, rest * (POINTS * POINTS) as f64)
}

/// The mode whose frequency is nearest to the harmonic's.
fn nearest(modes: &[(f64, f64)], k: u32) -> Option<[f64; 2]> {
    let off = |mode: &&(f64, f64)| (mode.0 - f64::from(k)).abs();
    modes.iter().min_by(|a, b| off(a).total_cmp(&off(b))).map(|mode| [mode.0, mode.1])
}

/// Where a derivative that is known between two values, positive at the first and not at the last, turns: the
/// float at which or before which it does. Where there is no response, there.
fn turn([mut low, mut high]: [f64; 2], climb: impl Fn(f64) -> Result<Option<f64>>) -> Result<f64> {
    loop {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            return Ok(high);
        }
        match climb(middle)? {
            None => return Ok(middle),
            Some(climb) if climb > 0.0 => low = middle,
            Some(_) => high = middle,
        }
    }
}

/// Where the square of an amplitude falls to `level` on either side of its peak, between its neighbouring
/// troughs.
fn half_power(
    (peak, level): (f64, f64),
    samples: &[Sample],
    square: impl Fn(f64) -> Result<Option<[f64; 2]>>,
) -> Result<std::result::Result<[f64; 2], &'static str>> {
    let after: Vec<f64> = samples.iter().map(|sample| sample.value).filter(|value| *value > peak).collect();
    let before: Vec<f64> =
        samples.iter().rev().map(|sample| sample.value).filter(|value| *value < peak).collect();
    let mut ends = [0.0; 2];
    for (end, (sign, walk)) in ends.iter_mut().zip([(-1.0, before), (1.0, after)]) {
        let mut inside = peak;
        let mut found = Err("beyond the range");
        for value in walk {
            let Some([here, climb]) = square(value)? else { break };
            if here <= level {
                found = Ok([inside, value]);
                break;
            }
            if sign * climb > 0.0 {
                // It rises again: the trough is between.
                let fall = |x: f64| Ok(square(x)?.map(|[_, climb]| -sign * climb));
                let trough = between([inside, value], &fall)?;
                let deep = square(trough)?.is_some_and(|[here, _]| here <= level);
                found = if deep { Ok([inside, trough]) } else { Err("overlaps with another") };
                break;
            }
            inside = value;
        }
        match found {
            Err(why) => return Ok(Err(why)),
            Ok(bracket) => *end = between(bracket, &|x| Ok(square(x)?.map(|[here, _]| here - level)))?,
        }
    }
    Ok(Ok(ends))
}

/// Where what is positive at the first of two values and not at the last turns; they may descend.
fn between([mut from, mut to]: [f64; 2], of: &dyn Fn(f64) -> Result<Option<f64>>) -> Result<f64> {
    loop {
        let middle = from + (to - from) / 2.0;
        if middle == from || middle == to {
            return Ok(to);
        }
        match of(middle)? {
            Some(x) if x > 0.0 => from = middle,
            _ => to = middle,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pieces' ends of a climb, and how many zeros a thousand looks at it see.
    fn cuts(climb: impl Fn(f64) -> f64) -> (Vec<f64>, usize) {
        let mut ends = vec![0.0, 1.0];
        let mut climbs = |x: f64| Ok(Some(vec![(climb(x), climb(x).abs() + 1e-3)]));
        let mut left = MOST;
        cut([0.0, 1.0], DEEP, &mut left, &mut climbs, &mut ends).unwrap();
        assert!(left > 0);
        ends.sort_by(f64::total_cmp);
        let changes = ends.windows(2).filter(|pair| (climb(pair[0]) > 0.0) != (climb(pair[1]) > 0.0));
        let seen = changes.count();
        (ends, seen)
    }

    /// Two zeros 2e-5 apart, five of a cosine, none beside a pole that is close: each zero in a piece of its
    /// own.
    #[test]
    fn pieces_separate_zeros() {
        let (ends, seen) = cuts(|x| (x - 0.61803) * (x - 0.61805));
        assert_eq!((seen, ends.len() < 60), (2, true), "{ends:?}");
        assert_eq!(cuts(|x| (5.0 * PI * x).cos()).1, 5);
        let (ends, seen) = cuts(|x| 1.0 / ((x - 0.3) * (x - 0.3) + 1e-8));
        assert_eq!((seen, ends.len() < 80), (0, true), "{ends:?}");
        let shallow = |x: f64| (x - 0.5) * (x - 0.5) + 1e-9;
        assert_eq!(cuts(shallow).1, 0);
        assert_eq!(cuts(|x| shallow(x) - 2e-9).1, 2);
    }

    #[test]
    fn what_rounding_leaves_is_not_cut() {
        assert_eq!(cuts(|x| 1e-13 * (1e9 * x).sin()).0, [0.0, 1.0]);
    }
}
