//! The topological entropy of a relation, enclosed: log 1/z per forcing period, z the least positive root of
//! det(I − M(z)).

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::{ClosedWalks, Edge, Extent, Relation, Word, alike};
use crate::error::Result;
use crate::number::{Ball, FloatInterval, Precision, Real, Sign};

/// The exponential growth rate of the number of patterns with their period, per forcing period.
#[derive(Debug, Clone)]
pub enum Entropy {
    /// There is no closed walk: no pattern exists.
    Empty,
    /// The closed walks do not branch: patterns exist, but their number stays bounded.
    Zero,
    /// log 1/z > 0.
    Positive {
        /// Bounds of z with denominators that are powers of 2; equal if z is one itself.
        z: (BigRational, BigRational),
        /// An enclosure of log 1/z.
        rate: Ball,
    },
}

impl ClosedWalks {
    /// The entropy, z within 2^−`bits` if the rungs up to 4·`bits` + 128 bits suffice, else as near as they
    /// do.
    ///
    /// z is bracketed by pivots: I − M(z) with M ≥ 0 is a nonsingular M-matrix, that is z below the least
    /// root, iff elimination without exchanges meets positive pivots only. No point tried is a root: det(I −
    /// M) and its leading minors are integer polynomials with constant term 1, whose rational roots are ±1/q,
    /// and the points tried are odd/2^b, odd ≥ 3. Cost: O(C³) operations for each of `bits` steps, C classes.
    pub fn entropy(&self, bits: u32) -> Entropy {
        let reach = self.reach();
        let core: Vec<usize> = (0..reach.len()).filter(|&a| reach[a][a]).collect();
        if core.is_empty() {
            return Entropy::Empty;
        }
        let branches = |&a: &usize| {
            let out = core.iter().filter(|&&b| self.follows[a][b] && reach[b][a]);
            out.map(|&b| self.classes[b].len()).sum::<usize>() > 1
        };
        if !core.iter().any(branches) {
            return Entropy::Zero;
        }
        // At most one walk for each composition of n: z ≥ ½, and > ½ since the periods are finitely many.
        let half = BigRational::new(1.into(), 2.into());
        let (mut lo, mut hi) = (half.clone(), BigRational::one());
        for _ in 0..bits {
            let middle = (&lo + &hi) * &half;
            let below = self.below_root(&core, &FloatInterval::ratio(&middle, &()), &()).or_else(|| {
                [128, bits + 128, 4 * bits + 128].iter().find_map(|&bits| {
                    let precision = Precision::new(bits);
                    self.below_root(&core, &Ball::ratio(&middle, &precision), &precision)
                })
            });
            match below {
                Some(true) => lo = middle,
                Some(false) => hi = middle,
                None => break,
            }
        }
        let rate = logarithm(&Ball::between(&hi.recip(), &lo.recip(), &Precision::new(bits + 64)), bits + 64);
        Entropy::Positive { z: (lo, hi), rate }
    }

    /// `reach[a][b]`: some walk leads from class a to class b.
    fn reach(&self) -> Vec<Vec<bool>> {
        let mut reach = self.follows.clone();
        for k in 0..reach.len() {
            let through = reach[k].clone();
            for row in reach.iter_mut().filter(|row| row[k]) {
                row.iter_mut().zip(&through).for_each(|(entry, &more)| *entry |= more);
            }
        }
        reach
    }

    /// Whether z lies below the least root for the classes of `core`, if the rung can tell.
    fn below_root<T: Real>(&self, core: &[usize], z: &T, context: &T::Context) -> Option<bool> {
        let weight =
            |class: &[u64]| class.iter().fold(T::integer(0, context), |sum, &n| sum + &power(z, n, context));
        let weights: Vec<T> = core.iter().map(|&b| weight(&self.classes[b])).collect();
        let entry = |(a, i): (usize, usize), (b, j): (usize, usize)| {
            let one = T::integer(i32::from(i == j), context);
            if self.follows[a][b] { one - &weights[j] } else { one }
        };
        let index = || core.iter().copied().zip(0..);
        let mut rows: Vec<Vec<T>> =
            index().map(|row| index().map(|column| entry(row, column)).collect()).collect();
        for k in 0..rows.len() {
            match rows[k][k].sign() {
                Some(Sign::Positive) => {}
                Some(_) => return Some(false),
                None => return None,
            }
            let (head, tail) = rows.split_at_mut(k + 1);
            let pivot = &head[k];
            for row in tail {
                let factor = row[k].clone() / &pivot[k];
                for (entry, above) in row[k + 1..].iter_mut().zip(&pivot[k + 1..]) {
                    *entry = entry.clone() - &(factor.clone() * above);
                }
            }
        }
        Some(true)
    }
}

/// z^n by squaring.
pub(super) fn power<T: Real>(z: &T, mut n: u64, context: &T::Context) -> T {
    let (mut result, mut square) = (T::integer(1, context), z.clone());
    while n > 0 {
        if n & 1 == 1 {
            result = result * &square;
        }
        n >>= 1;
        if n > 0 {
            square = square.clone() * &square;
        }
    }
    result
}

/// log w for an enclosed w in [1, 2], or little beyond: 2 Σ t^{2k+1}/(2k+1), t = (w − 1)/(w + 1) ≤ 0.34. The
/// terms from k = m on add up to less than t^{2m+1}.
fn logarithm(w: &Ball, bits: u32) -> Ball {
    let precision = Precision::new(bits + 32);
    let one = Ball::integer(1, &precision);
    let t = (w.clone() - &one) / &(w.clone() + &one);
    let square = t.clone() * &t;
    let mut term = t.clone();
    let mut sum = Ball::integer(0, &precision);
    // 0.34² < 2⁻³.
    let terms = bits.div_ceil(3) + 1;
    for k in 0..terms {
        sum = sum
            + &(term.clone() / &Ball::ratio(&BigRational::from_integer(BigInt::from(2 * k + 1)), &precision));
        term = term * &square;
    }
    // 1/(2k+1)/(1 − t²) < 1 for k ≥ 1: the rest is below the next power.
    let next = term.exact_bounds().map_or_else(BigRational::one, |(_, hi)| hi);
    let rest = Ball::between(&BigRational::from_integer(0.into()), &next, &precision);
    let sum = sum + &rest;
    sum.clone() + &sum
}

impl Entropy {
    /// The entropy of a word's case, for a sign of γ, and whether it is only a lower bound: where the word
    /// may go on, or an edge is open. Over all periods it is log 2 or nothing; on a₁ = −(a₂ + 1), over the
    /// odd ones and 2, log 1.839286… or nothing, as a lower bound. Cost: as
    /// [`ClosedWalks::entropy`], and V² edges.
    ///
    /// # Errors
    /// An input error for words of more than [`MAX_RELATION`](super::MAX_RELATION) letters.
    pub fn of(word: &Word, gamma_positive: bool, bits: u32) -> Result<(Entropy, bool)> {
        if word.is_endless() {
            let sigma = word.is_positive() == gamma_positive;
            // On the line even periods may add to it.
            let at_least = word.extent() == Extent::Odd;
            if alike(word.vertices()[0].letter, sigma) != Edge::Yes {
                return Ok((Entropy::Empty, at_least));
            }
            if at_least {
                // With S = z/(1 − z²) for the odd periods, and 2 between them: S(1 + z²) = 1, which is z + z²
                // + z³ = 1.
                let same = ClosedWalks::from_edges(&[1, 2, 3], &vec![vec![true; 3]; 3]);
                return Ok((same.entropy(bits), at_least));
            }
            // Σ zⁿ = 1 over all n ≥ 1: z = ½.
            let half = BigRational::new(1.into(), 2.into());
            let two = Ball::integer(2, &Precision::new(bits + 64));
            let rate = logarithm(&two, bits + 64);
            return Ok((Entropy::Positive { z: (half.clone(), half), rate }, false));
        }
        let relation = Relation::new(word, gamma_positive, false, u64::MAX)?;
        Ok((ClosedWalks::new(&relation).entropy(bits), !relation.is_whole() || relation.is_open()))
    }

    /// The entropy as bounds with denominators that are powers of 2, 0 where patterns do not branch; `None`
    /// if no pattern exists.
    pub fn bounds(&self) -> Option<(BigRational, BigRational)> {
        let zero = || BigRational::from_integer(0.into());
        match self {
            Entropy::Empty => None,
            Entropy::Zero => Some((zero(), zero())),
            Entropy::Positive { rate, .. } => rate.exact_bounds(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Elementary;

    fn digits(periods: &[u64], follows: &[Vec<bool>]) -> f64 {
        match ClosedWalks::from_edges(periods, follows).entropy(100) {
            Entropy::Positive { z, rate } => {
                // Two routes: exp of the enclosure of log 1/z meets that of 1/z.
                let precision = Precision::new(200);
                let back = rate.exp(&precision).exact_bounds().unwrap();
                assert!(back.0 <= z.0.recip() && z.1.recip() <= back.1);
                let (lo, hi) = rate.exact_bounds().unwrap();
                assert!(&hi - &lo < BigRational::new(1.into(), BigInt::from(1) << 95));
                num_traits::ToPrimitive::to_f64(&lo).unwrap()
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn known_entropies_come_out() {
        let full = |n: usize| vec![vec![true; n]; n];
        let golden = ((1.0 + 5f64.sqrt()) / 2.0).ln();
        assert!((digits(&[1, 2], &full(2)) - golden).abs() < 1e-15);
        // z + z² + z³ = 1: the tribonacci constant.
        assert!((digits(&[1, 2, 3], &full(3)) - 1.839_286_755_214_161f64.ln()).abs() < 1e-15);
        // No 2 after a 2: periods 1 and (1, 2) = 3 freely combined, z + z³ = 1, the supergolden ratio.
        let follows = [vec![true, true], vec![true, false]];
        assert!((digits(&[1, 2], &follows) - 1.465_571_231_876_768f64.ln()).abs() < 1e-15);
    }

    #[test]
    fn what_does_not_branch_has_no_entropy() {
        let none = ClosedWalks::from_edges(&[1, 2], &[vec![false, true], vec![false, false]]);
        assert!(matches!(none.entropy(60), Entropy::Empty));
        let cycle = ClosedWalks::from_edges(&[1, 2], &[vec![false, true], vec![true, false]]);
        assert!(matches!(cycle.entropy(60), Entropy::Zero));
        // Two loops and a way from one to the other, but not back.
        let there = ClosedWalks::from_edges(&[1, 2], &[vec![true, true], vec![false, true]]);
        assert!(matches!(there.entropy(60), Entropy::Zero));
    }
}
