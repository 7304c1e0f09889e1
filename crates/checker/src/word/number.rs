//! Exact fractions as a certificate writes them, in fixed point; and cos 2πs.

use std::cmp::Ordering;

use super::integer::Integer;

/// The most digits of a numerator or denominator.
pub(super) const DIGITS: usize = 100;

/// A fraction p/q in lowest terms, q > 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Rational {
    pub p: Integer,
    pub q: Integer,
}

impl Rational {
    /// Reads `-?P/Q` in lowest terms with Q > 0, P and Q without leading zeros and of at most [`DIGITS`]
    /// digits; zero is `0/1`.
    pub fn read(text: &str) -> Option<Rational> {
        let (p, q) = text.split_once('/')?;
        let (negative, p) = p.strip_prefix('-').map_or((false, p), |p| (true, p));
        let plain = |x: &str| x.len() <= DIGITS && (x == "0" || !x.starts_with('0'));
        let (p, q) = (Integer::read(p).filter(|_| plain(p))?, Integer::read(q).filter(|_| plain(q))?);
        if q.is_zero() || (negative && p.is_zero()) {
            return None;
        }
        let (mut a, mut b) = (p.clone(), q.clone());
        while !b.is_zero() {
            let rest = a.divided(&b).1;
            (a, b) = (b, rest);
        }
        (a == Integer::from(1)).then(|| Rational { p: if negative { -&p } else { p }, q })
    }

    pub fn whole(value: u64) -> Rational {
        Rational { p: Integer::from(value), q: Integer::from(1) }
    }

    /// units/2^bits, units below 2⁶⁴ in magnitude; not in lowest terms.
    pub fn binary(units: i128, bits: usize) -> Rational {
        let p = Integer::from(u64::try_from(units.unsigned_abs()).expect("below 2^64"));
        Rational { p: if units < 0 { -&p } else { p }, q: Integer::power_of_two(bits) }
    }

    pub fn compared(&self, other: &Rational) -> Ordering {
        (&self.p * &other.q).compared(&(&other.p * &self.q))
    }

    pub fn plus(&self, other: &Rational) -> Rational {
        Rational { p: &(&self.p * &other.q) + &(&other.p * &self.q), q: &self.q * &other.q }
    }

    pub fn times(&self, other: &Rational) -> Rational {
        Rational { p: &self.p * &other.p, q: &self.q * &other.q }
    }

    pub fn negated(&self) -> Rational {
        Rational { p: -&self.p, q: self.q.clone() }
    }

    pub fn is_positive(&self) -> bool {
        self.p.sign() == Ordering::Greater
    }

    /// ⌊self · 2^`bits`⌋.
    pub fn floor(&self, bits: usize) -> Integer {
        let (quotient, rest) = self.p.magnitude().shifted_up(bits).divided(&self.q);
        match self.p.sign() {
            Ordering::Less if rest.is_zero() => -&quotient,
            Ordering::Less => -&(&quotient + &Integer::from(1)),
            _ => quotient,
        }
    }

    /// ⌈self · 2^`bits`⌉.
    pub fn ceiling(&self, bits: usize) -> Integer {
        -&self.negated().floor(bits)
    }
}

/// Bits beyond those asked for.
const GUARD: usize = 64;

/// A number within one unit, 2^−`bits`, of 2 r cos 2πs, for 0 < r ≤ 1, 0 < s < ½ and `bits` ≤ 4096.
///
/// In units of 2^−(`bits` + 64): π is off by less than 20 · 2 · 1000 < 2¹⁶ (Machin's formula, fewer than 1000
/// terms each, a term off by less than 2), 2πs by less than 2¹⁷, and with it its cosine. In the series of cos
/// x, x² < 10.3, the term t_k is followed by t_{k+1} = t_k x²/((2k+1)(2k+2)). With E_k the error of t_k,
/// E_{k+1} < (10.3 E_k + |t_k|)/((2k+1)(2k+2)) + 2, E_0 = 0 and |t_k| < 5.2: E_1 < 3, E_2 < 5, and less than
/// 5 from there on. Fewer than 2¹¹ terms are summed, in all off by less than 2¹⁴; what is left out alternates
/// and falls, below 6 units. So the cosine is off by less than 2¹⁸, and 2 r cos 2πs by 2¹⁹ and one more: far
/// less than 2⁶⁴.
pub(super) fn trace(r: &Rational, s: &Rational, bits: usize) -> Integer {
    let w = bits + GUARD;
    let small = Integer::from;
    let x = (&(&pi(w) * &small(2)) * &s.p).divided(&s.q).0;
    let square = (&x * &x).shifted_down(w);
    let (mut sum, mut term) = (Integer::power_of_two(w), Integer::power_of_two(w));
    let mut k = 0;
    while k < 6 || !term.is_zero() {
        term = (&term * &square).shifted_down(w).divided(&small((k + 1) * (k + 2))).0;
        k += 2;
        sum = if k % 4 == 2 { &sum - &term } else { &sum + &term };
    }
    let product = &(&sum * &small(2)) * &r.p;
    let (quotient, _) = product.magnitude().divided(&r.q);
    let value = if product.sign() == Ordering::Less { -&quotient } else { quotient };
    value.shifted_down(GUARD)
}

/// π = 16 arctan 1/5 − 4 arctan 1/239 in units of 2^−`bits`.
fn pi(bits: usize) -> Integer {
    let arctan = |q: u64| {
        let mut power = Integer::power_of_two(bits).divided(&Integer::from(q)).0;
        let (mut sum, mut k) = (Integer::zero(), 1u64);
        while !power.is_zero() {
            let term = power.divided(&Integer::from(k)).0;
            sum = if k % 4 == 1 { &sum + &term } else { &sum - &term };
            power = power.divided(&Integer::from(q * q)).0;
            k += 2;
        }
        sum
    };
    &(&arctan(5) * &Integer::from(16)) - &(&arctan(239) * &Integer::from(4))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rational(text: &str) -> Rational {
        Rational::read(text).unwrap()
    }

    #[test]
    fn a_number_has_one_form() {
        for good in ["0/1", "1/1", "-1/3", "7/2", "-10/9"] {
            assert!(Rational::read(good).is_some(), "{good}");
        }
        for bad in
            ["", "1", "/", "1/", "/1", "-0/1", "0/2", "2/4", "1/0", "+1/2", "01/2", "1/02", "1/-2", "--1/2"]
        {
            assert!(Rational::read(bad).is_none(), "{bad}");
        }
        assert!(Rational::read(&format!("1/{}", "9".repeat(DIGITS))).is_some());
        assert!(Rational::read(&format!("1/{}", "9".repeat(DIGITS + 1))).is_none());
    }

    #[test]
    fn fixed_point_rounds_as_it_says() {
        for (text, floor, ceiling) in [("7/2", 14u64, 14), ("1/3", 1, 2), ("0/1", 0, 0)] {
            let x = rational(text);
            assert_eq!((x.floor(2), x.ceiling(2)), (Integer::from(floor), Integer::from(ceiling)));
            let y = x.negated();
            assert_eq!((y.floor(2), y.ceiling(2)), (-&Integer::from(ceiling), -&Integer::from(floor)));
        }
    }

    /// 2 cos 2πs for the s where it is rational or a root of x² = 2, 3, x² + x = 1.
    #[test]
    fn cosines_are_right_to_a_unit() {
        let one = rational("1/1");
        for bits in [64, 96, 480] {
            let unit = Integer::from(1);
            let near = |s: &str, value: &Integer| {
                let difference = &trace(&one, &rational(s), bits) - value;
                assert!(difference.magnitude().compared(&unit) != Ordering::Greater, "s = {s}, {bits} bits");
            };
            near("1/4", &Integer::zero());
            near("1/6", &Integer::power_of_two(bits));
            near("1/3", &-&Integer::power_of_two(bits));
            // x² against the whole number, to within 2|x| units and one.
            for (s, square) in [("1/8", 2u64), ("1/12", 3)] {
                let x = trace(&one, &rational(s), bits);
                let error = &(&x * &x) - &Integer::from(square).shifted_up(2 * bits);
                assert!(error.bits() <= bits + 3, "s = {s}");
            }
            let x = trace(&one, &rational("1/5"), bits);
            let error = &(&(&x * &x) + &x.shifted_up(bits)) - &Integer::power_of_two(2 * bits);
            assert!(error.bits() <= bits + 3);
            // Near the end of the range, 2 − 2⁻¹⁹⁴ or so, and with r < 1.
            if bits < 128 {
                near("1/1000000000000000000000000000000", &Integer::power_of_two(bits + 1));
            }
            let half = trace(&rational("1/2"), &rational("1/6"), bits);
            assert!(
                (&half - &Integer::power_of_two(bits - 1)).magnitude().compared(&unit) != Ordering::Greater
            );
        }
    }
}
