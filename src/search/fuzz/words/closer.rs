//! A point that a sweep leaves open: the same two routes with every sign from balls, which lie closer than
//! `f64` can.
//!
//! - *Definition*: the periods that occur by the records of f_j = Im λʲ/(1 − Re λʲ), which may follow which
//!   by (64), as in `sweep`.
//! - *Word*: sides by integers, and the deciding b by the sign of u_n (Im λⁿ − r²ᵏ Im λⁿ⁻ᵏ − Im λᵏ).
//!
//! The powers of λ are products of balls; everything is an enclosure by construction, so no bound is proved
//! here.

use num_rational::BigRational;

use super::sweep::{Swept, against, path};
use crate::number::{Angle, Ball, Circular, Precision, Real, Sign};

/// Compares the two routes at r = `r`/2⁵³, s = `s`/2⁵⁴, s odd, over the periods up to `last`. Cost: O(last)
/// products of balls and one comparison for each pair of periods that occur.
pub(super) fn compare(r: u64, s: u64, last: usize, precision: &Precision) -> Swept {
    let mut powers = Powers::new(r, s, precision);
    let Some((found, decided, whole)) = records(&mut powers, s, last) else { return Swept::Open };
    if decided == 0 {
        return Swept::Differ;
    }
    let mut word = Vec::new();
    let ended = path(s, last, &mut word, |n, k| powers.deciding(n, k));
    let Some(ended) = ended else { return Swept::Open };
    let quotients: Option<Vec<(Ball, Ball)>> = found.iter().map(|&n| powers.quotients(n)).collect();
    let Some(quotients) = quotients else { return Swept::Open };
    against(&word, &found, (decided, whole, ended), |i, j| {
        (quotients[j].0.clone() - &quotients[i].1).sign().map(|sign| sign == Sign::Positive)
    })
}

/// λʲ and rʲ for j = 0, 1, …, as far as they were asked for.
struct Powers<'a> {
    precision: &'a Precision,
    /// λ = a + ib.
    a: Ball,
    b: Ball,
    r: Ball,
    /// Re λʲ, Im λʲ, rʲ.
    known: Vec<(Ball, Ball, Ball)>,
}

impl<'a> Powers<'a> {
    fn new(r: u64, s: u64, precision: &'a Precision) -> Self {
        let angle = Angle::new(&BigRational::new_raw(s.into(), (1u64 << 53).into()));
        let r = Ball::ratio(&BigRational::new_raw(r.into(), (1u64 << 53).into()), precision);
        let (a, b) = (Ball::cos(&angle, precision) * &r, Ball::sin(&angle, precision) * &r);
        let (zero, one) = (Ball::integer(0, precision), Ball::integer(1, precision));
        Powers { precision, a, b, r, known: vec![(one.clone(), zero, one)] }
    }

    fn at(&mut self, j: usize) -> &(Ball, Ball, Ball) {
        while self.known.len() <= j {
            let (x, y, size) = &self.known[self.known.len() - 1];
            let next = (
                x.clone() * &self.a - &(y.clone() * &self.b),
                x.clone() * &self.b + &(y.clone() * &self.a),
                size.clone() * &self.r,
            );
            self.known.push(next);
        }
        &self.known[j]
    }

    fn one(&self) -> Ball {
        Ball::integer(1, self.precision)
    }

    /// f_j, of the sign that counts; 1 − Re λʲ > 0.
    fn tangent(&mut self, j: usize) -> Ball {
        let one = self.one();
        let (x, y, _) = self.at(j);
        y.clone() / &(one - x)
    }

    /// Im λⁿ − r²ᵏ Im λⁿ⁻ᵏ − Im λᵏ, of the sign of u_n b_{n,k}.
    fn deciding(&mut self, n: usize, k: usize) -> Option<Sign> {
        let whole = self.at(n).1.clone();
        let (_, part, size) = self.known[k].clone();
        (whole - &(size.clone() * &size * &self.known[n - k].1) - &part).sign()
    }

    /// p_n and q_n; `None` if Im λⁿ may be 0.
    fn quotients(&mut self, n: usize) -> Option<(Ball, Ball)> {
        let next = self.at(n + 1).1.clone();
        let (first, (_, here, size), before) = (&self.known[1], &self.known[n], &self.known[n - 1]);
        here.sign()?;
        let p = (next - &first.1) / here;
        let square = first.2.clone() * &first.2;
        let q = (size.clone() * size * &first.1 + &(square * &before.1)) / here;
        Some((p, q))
    }
}

/// The periods that occur for eµ > 0, by records; how far it came, and whether no later one occurs. `None`
/// where a sign is not certain; (…, 0, …) if those for eµ < 0 are not the n with 2ns < 1.
fn records(powers: &mut Powers<'_>, s: u64, last: usize) -> Option<(Vec<usize>, usize, bool)> {
    let mut found = vec![1];
    let mut highest = powers.tangent(1);
    let mut lowest = highest.clone();
    for n in 2..=last {
        let here = powers.tangent(n);
        let high = (here.clone() - &highest).sign()? == Sign::Positive;
        let low = (here.clone() - &lowest).sign()? == Sign::Negative;
        let below = (n as u64) * s < 1 << 53;
        if high || low {
            let positive = (powers.at(n).1.sign()? == Sign::Positive) == high;
            if positive == below {
                return Some((found, 0, false));
            }
            if positive {
                found.push(n);
            }
            if high { highest = here } else { lowest = here }
        } else if below {
            return Some((found, 0, false));
        }
        // Later ones lie within ±rⁿ/(1 − rⁿ): no record once that is below both extremes.
        let size = powers.at(n).2.clone();
        let rest = powers.one() - &size;
        let within = |extreme: Ball| (extreme * &rest - &size).sign() == Some(Sign::Positive);
        if within(highest.clone()) && within(-lowest.clone()) {
            return Some((found, n, true));
        }
    }
    Some((found, last, false))
}

#[cfg(test)]
mod tests {
    use super::{
        super::{angle, modulus, sweep::WordSweep},
        *,
    };
    use crate::random::Random;

    /// Where a sweep decides, balls say the same of as many pairs; where it does not, they nearly always
    /// decide.
    #[test]
    fn closer_agrees_with_sweeps() {
        let (mut random, precision) = (Random::of_unit(5, 0), Precision::new(192));
        let mut sweep = WordSweep::new(48);
        let (mut agreed, mut open, mut still) = (0, 0, 0);
        for _ in 0..400 {
            let (family, s) = angle(&mut random);
            sweep.turn(s);
            for _ in 0..4 {
                let r = modulus(&mut random, family);
                let found = compare(r, s, 48, &precision);
                match sweep.compare(r) {
                    Swept::Agree(pairs) => {
                        // A ball sees ends of words that a bound leaves out, never fewer pairs.
                        assert!(matches!(found, Swept::Agree(more) if more >= pairs), "{r} {s}: {found:?}");
                        agreed += 1;
                    }
                    Swept::Open => {
                        assert_ne!(found, Swept::Differ, "{r} {s}");
                        open += 1;
                        still += usize::from(found == Swept::Open);
                    }
                    Swept::Differ => panic!("{r} {s}"),
                }
            }
        }
        assert!(agreed > 1000 && open > 5 && still <= open / 20, "{agreed} {open} {still}");
    }

    /// A sign turned on one route is noticed: the first deciding sign is taken for its opposite.
    #[test]
    fn a_turned_sign_differs() {
        // r = 0.9, s = 0.37: the word is DUD, of periods 1, 2 and 3.
        let (r, s) = ((0.9 * (1u64 << 53) as f64) as u64, (0.37 * (1u64 << 54) as f64) as u64 | 1);
        let precision = Precision::new(128);
        let mut powers = Powers::new(r, s, &precision);
        let (found, decided, whole) = records(&mut powers, s, 48).unwrap();
        assert_eq!((&found[..], whole), (&[1, 2, 3][..], true));
        for turned in [false, true] {
            let mut word = Vec::new();
            let mut first = true;
            let ended = path(s, 48, &mut word, |n, k| {
                let sign = powers.deciding(n, k)?;
                let turn = std::mem::take(&mut first) && turned;
                Some(sign.negated_if(turn))
            });
            let swept = against(&word, &found, (decided, whole, ended.unwrap()), |i, j| {
                let [(p, _), (_, q)] = [powers.quotients(found[j])?, powers.quotients(found[i])?];
                (p - &q).sign().map(|sign| sign == Sign::Positive)
            });
            assert_eq!(swept, if turned { Swept::Differ } else { Swept::Agree(9) });
        }
    }
}
