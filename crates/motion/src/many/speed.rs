//! Restitution as a rational function of the speed of an impact.

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::Serialize;

use crate::error::{Error, Result};

/// τ(v) = N(v)/D(v), v ≥ 0 being the speed of the impact.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpeedLaw<T> {
    /// As it was written, without spaces.
    pub text: String,
    /// The coefficients of N, from the constant one on.
    pub over: Vec<T>,
    /// Those of D.
    pub under: Vec<T>,
}

impl<T> SpeedLaw<T> {
    /// The same law with every coefficient converted.
    ///
    /// # Errors
    /// The first error of `convert`.
    pub fn try_map<U, E>(
        &self,
        convert: &mut impl FnMut(&T) -> std::result::Result<U, E>,
    ) -> std::result::Result<SpeedLaw<U>, E> {
        let mut list = |all: &[T]| all.iter().map(&mut *convert).collect::<std::result::Result<_, E>>();
        Ok(SpeedLaw { text: self.text.clone(), over: list(&self.over)?, under: list(&self.under)? })
    }
}

impl SpeedLaw<f64> {
    /// τ and dτ/dv.
    pub fn at(&self, v: f64) -> [f64; 2] {
        let ([n, n1], [d, d1]) = (value(&self.over, v), value(&self.under, v));
        let tau = n / d;
        [tau, (n1 - tau * d1) / d]
    }

    /// The derivative of τ in a parameter in which the coefficients change at the rates `slope`.
    pub(crate) fn slope(&self, slope: &SpeedLaw<f64>, v: f64) -> f64 {
        let ([n, _], [d, _]) = (value(&self.over, v), value(&self.under, v));
        let ([change, _], [lower, _]) = (value(&slope.over, v), value(&slope.under, v));
        (change - n / d * lower) / d
    }

    /// The same law of a speed in another unit, of which there are `rate` in the old one.
    #[must_use]
    pub(crate) fn scaled(&self, rate: f64) -> SpeedLaw<f64> {
        let powers = |all: &[f64]| (0i32..).zip(all).map(|(i, c)| c * rate.powi(i)).collect();
        SpeedLaw { text: self.text.clone(), over: powers(&self.over), under: powers(&self.under) }
    }

    /// What [`scaled`](Self::scaled) changes by while the coefficients change at the rates `slope` and the
    /// rate at `faster`.
    #[must_use]
    pub(crate) fn scaled_slope(&self, slope: &SpeedLaw<f64>, rate: f64, faster: f64) -> SpeedLaw<f64> {
        let powers = |all: &[f64], slopes: &[f64]| {
            let one = |(i, (c, slope)): (i32, (&f64, &f64))| {
                let turned = if i == 0 { 0.0 } else { f64::from(i) * c * rate.powi(i - 1) * faster };
                slope * rate.powi(i) + turned
            };
            (0i32..).zip(all.iter().zip(slopes)).map(one).collect()
        };
        SpeedLaw {
            text: self.text.clone(),
            over: powers(&self.over, &slope.over),
            under: powers(&self.under, &slope.under),
        }
    }

    /// Refuses a law with a pole or a negative value at a speed v ≥ 0; decided exactly, the coefficients
    /// being what they are in floats.
    ///
    /// # Errors
    /// Such a law, with a place; more than 8 powers of v.
    pub(crate) fn check(&self) -> Result<()> {
        let (over, under) = (exact(&self.over)?, exact(&self.under)?);
        if under.iter().all(Zero::is_zero) {
            return Err(Error::input("restitution: divides by zero"));
        }
        let sign = |p: &[BigRational], turned: bool| -> Vec<BigRational> {
            p.iter().map(|c| if turned { -c } else { c.clone() }).collect()
        };
        let turned = under.iter().find(|c| !c.is_zero()).is_some_and(Signed::is_negative);
        let (over, under) = (sign(&over, turned), sign(&under, turned));
        if let Some(v) = not_positive(&under) {
            return Err(Error::input(format!(
                "restitution = {}: has a pole at the speed v = {v}",
                self.text
            )));
        }
        if let Some(v) = negative(&over) {
            return Err(Error::input(format!(
                "restitution = {}: is negative at the speed v = {v}; a restitution is at least 0",
                self.text
            )));
        }
        Ok(())
    }

    /// A speed at which it is above 1.
    pub fn above_one(&self) -> Option<f64> {
        let (over, under) = (exact(&self.over).ok()?, exact(&self.under).ok()?);
        let turned = under.iter().find(|c| !c.is_zero()).is_some_and(Signed::is_negative);
        let zero = BigRational::zero();
        let get = |p: &[BigRational], i: usize| p.get(i).cloned().unwrap_or_else(|| zero.clone());
        let less = |i: usize| {
            let difference = get(&under, i) - get(&over, i);
            if turned { -difference } else { difference }
        };
        negative(&(0..over.len().max(under.len())).map(less).collect::<Vec<_>>())
    }
}

/// Most powers of v.
pub const MOST: usize = 8;

fn exact(all: &[f64]) -> Result<Vec<BigRational>> {
    if all.len() > MOST + 1 {
        return Err(Error::input(format!("restitution: has powers of v above {MOST}")));
    }
    let one = |c: &f64| {
        BigRational::from_float(*c)
            .ok_or_else(|| Error::input("restitution: has a coefficient that is not finite"))
    };
    all.iter().map(one).collect()
}

fn value(all: &[f64], v: f64) -> [f64; 2] {
    all.iter().rev().fold([0.0, 0.0], |[p, slope], c| [p * v + c, slope * v + p])
}

fn exactly(all: &[BigRational], v: &BigRational) -> BigRational {
    all.iter().rev().fold(BigRational::zero(), |sum, c| sum * v + c)
}

/// A v ≥ 0 at which a polynomial is negative, if there is one.
fn negative(p: &[BigRational]) -> Option<f64> {
    if p.iter().all(|c| !c.is_negative()) {
        return None;
    }
    between(p).into_iter().find(|v| exactly(p, v).is_negative()).map(|v| rounded(&v))
}

/// A v ≥ 0 at which a polynomial, positive just above 0, is not.
fn not_positive(p: &[BigRational]) -> Option<f64> {
    if p.first().is_some_and(Zero::is_zero) {
        return Some(0.0);
    }
    if p.iter().all(|c| !c.is_negative()) {
        return None;
    }
    roots(p)
        .into_iter()
        .next()
        .map(|[low, high]| rounded(&((low + high) / BigRational::from_integer(2.into()))))
}

fn rounded(v: &BigRational) -> f64 {
    num_traits::ToPrimitive::to_f64(v).unwrap_or(f64::MAX)
}

/// 0 and places between the roots above 0 and beyond them: every sign that the polynomial has on an interval.
fn between(p: &[BigRational]) -> Vec<BigRational> {
    let two = BigRational::from_integer(2.into());
    let all = roots(p);
    let mut places = vec![BigRational::zero()];
    let mut last = BigRational::zero();
    for [low, high] in &all {
        places.push((&last + low) / &two);
        last = high.clone();
    }
    places.push(last + BigRational::from_integer(1.into()));
    places
}

/// Intervals (low, high], narrow, with one root above 0 each, ascending; their lower ends are no roots. By
/// Sturm's theorem.
fn roots(p: &[BigRational]) -> Vec<[BigRational; 2]> {
    let p: Vec<BigRational> = p.iter().skip_while(|c| c.is_zero()).cloned().collect();
    let mut chain = sturm(&p);
    if let Some(common) = chain.last().filter(|common| common.len() > 1) {
        // Each root once.
        chain = sturm(&divided(&chain[0], common)[0]);
    }
    let p = chain.first().cloned().unwrap_or_default();
    let Some(leading) = chain.first().and_then(|p| p.last()) else { return Vec::new() };
    let one = BigRational::from_integer(1.into());
    let size = |c: &BigRational| (c / leading).abs();
    let bound = chain[0].iter().map(size).fold(one.clone(), |most, c| if c > most { c } else { most }) + one;
    let count = |low: &BigRational, high: &BigRational| changes(&chain, low) - changes(&chain, high);
    let two = BigRational::from_integer(2.into());
    let (mut found, mut open) = (Vec::new(), vec![([BigRational::zero(), bound], 0)]);
    while let Some(([low, high], depth)) = open.pop() {
        let roots = count(&low, &high);
        if roots == 0 {
            continue;
        }
        // Lower ends of signs found are no roots: an interval that begins at one is halved on.
        if roots == 1 && depth > 60 && !(exactly(&p, &low).is_zero() && depth < 120) {
            found.push([low, high]);
            continue;
        }
        let middle = (&low + &high) / &two;
        open.push(([middle.clone(), high], depth + 1));
        open.push(([low, middle], depth + 1));
    }
    found
}

/// How often the signs of Sturm's sequence change at v.
fn changes(chain: &[Vec<BigRational>], v: &BigRational) -> i32 {
    let signs: Vec<bool> =
        chain.iter().map(|p| exactly(p, v)).filter(|x| !x.is_zero()).map(|x| x.is_positive()).collect();
    signs.windows(2).map(|two| i32::from(two[0] != two[1])).sum()
}

/// Sturm's sequence: distinct roots are counted, multiple ones once.
fn sturm(p: &[BigRational]) -> Vec<Vec<BigRational>> {
    let trimmed = |mut p: Vec<BigRational>| {
        while p.last().is_some_and(Zero::is_zero) {
            p.pop();
        }
        p
    };
    let first = trimmed(p.to_vec());
    let slope =
        (1i64..).zip(first.iter().skip(1)).map(|(i, c)| c * BigRational::from_integer(i.into())).collect();
    let mut chain = vec![first, trimmed(slope)];
    while let [.., a, b] = &chain[..] {
        if b.is_empty() {
            chain.pop();
            break;
        }
        let [_, rest] = divided(a, b);
        let next = trimmed(rest.into_iter().map(|c| -c).collect());
        chain.push(next);
    }
    chain
}

/// Quotient and rest.
fn divided(a: &[BigRational], b: &[BigRational]) -> [Vec<BigRational>; 2] {
    let (mut rest, mut quotient) =
        (a.to_vec(), vec![BigRational::zero(); (a.len() + 1).saturating_sub(b.len())]);
    while rest.len() >= b.len() {
        let (shift, factor) = (rest.len() - b.len(), &rest[rest.len() - 1] / &b[b.len() - 1]);
        for (i, c) in b.iter().enumerate() {
            rest[shift + i] -= &factor * c;
        }
        rest.pop();
        quotient[shift] = factor;
    }
    [quotient, rest]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(over: &[f64], under: &[f64]) -> SpeedLaw<f64> {
        SpeedLaw { text: "law".into(), over: over.to_vec(), under: under.to_vec() }
    }

    #[test]
    fn laws_are_refused_where_they_are_negative_or_infinite() {
        for (over, under, wrong) in [
            (&[1.0][..], &[1.0, 0.5][..], None),
            (&[-1.0], &[-1.0, -0.5], None),
            // (v − 1)² touches 0 and 2 − v passes through it; (v − 1)(v − 1.001) dips below it.
            (&[1.0, -2.0, 1.0], &[1.0], None),
            (&[2.0, -1.0], &[1.0], Some("negative")),
            (&[1.001, -2.001, 1.0], &[1.0], Some("negative at the speed v = 1.00")),
            (&[1.0], &[2.0, -1.0], Some("pole at the speed v = 2")),
            (&[1.0], &[1.0, -2.0, 1.0], Some("pole at the speed v = 1")),
            (&[1.0], &[0.0, 1.0], Some("pole at the speed v = 0")),
            (&[1.0], &[1.0, 1.0], None),
            (&[1.0], &[1.0, -1.0, 1.0], None),
            (&[0.5], &[0.0, 0.0], Some("divides by zero")),
            (&[0.0, 0.5, -0.1, 0.01], &[1.0], None),
        ] {
            let found = law(over, under).check().map_err(|error| error.to_string());
            match (wrong, &found) {
                (None, Ok(())) => {}
                (Some(part), Err(text)) if text.contains(part) => {}
                _ => panic!("{over:?}/{under:?}: {found:?}"),
            }
        }
        assert_eq!(law(&[1.0], &[1.0, 0.5]).above_one(), None);
        assert!(law(&[0.5, 0.1], &[1.0]).above_one().is_some_and(|v| v > 5.0));
        assert!(law(&[0.9, 0.9], &[1.0, 0.0, 1.0]).above_one().is_some_and(|v| 0.9 + 0.9 * v > 1.0 + v * v));
    }
}
