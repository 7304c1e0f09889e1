//! Integers of any size, with just the operations that the signs need; schoolbook throughout.

use std::{
    cmp::Ordering,
    ops::{Add, Mul, Neg, Sub},
};

/// An integer: sign and magnitude.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Integer {
    /// Never true of zero.
    negative: bool,
    /// The magnitude in base 2³², the least digit first; the last one is not 0.
    digits: Vec<u32>,
}

impl Integer {
    fn new(negative: bool, mut digits: Vec<u32>) -> Integer {
        while digits.last() == Some(&0) {
            digits.pop();
        }
        Integer { negative: negative && !digits.is_empty(), digits }
    }

    pub fn zero() -> Integer {
        Integer::new(false, Vec::new())
    }

    pub fn power_of_two(exponent: usize) -> Integer {
        Integer::from(1).shifted_up(exponent)
    }

    /// Reads decimal digits, at least one and nothing else.
    pub fn read(text: &str) -> Option<Integer> {
        if text.is_empty() {
            return None;
        }
        let ten = Integer::from(10);
        text.chars().try_fold(Integer::zero(), |sum, digit| {
            Some(&(&sum * &ten) + &Integer::from(u64::from(digit.to_digit(10)?)))
        })
    }

    /// −1, 0 or 1 times 1, as an order against 0.
    pub fn sign(&self) -> Ordering {
        match (self.negative, self.digits.is_empty()) {
            (_, true) => Ordering::Equal,
            (true, _) => Ordering::Less,
            (false, _) => Ordering::Greater,
        }
    }

    pub fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    pub fn magnitude(&self) -> Integer {
        Integer { negative: false, digits: self.digits.clone() }
    }

    /// The least b with |self| < 2^b.
    pub fn bits(&self) -> usize {
        self.digits.last().map_or(0, |last| 32 * self.digits.len() - last.leading_zeros() as usize)
    }

    /// self · 2^`by`.
    pub fn shifted_up(&self, by: usize) -> Integer {
        let mut digits = vec![0; by / 32];
        let mut carry = 0u64;
        for &digit in &self.digits {
            carry |= u64::from(digit) << (by % 32);
            digits.push(carry as u32);
            carry >>= 32;
        }
        digits.push(carry as u32);
        Integer::new(self.negative, digits)
    }

    /// ⌊self/2^`by`⌋.
    pub fn shifted_down(&self, by: usize) -> Integer {
        let (whole, part) = (by / 32, by % 32);
        let digit = |i: usize| u64::from(self.digits.get(i).copied().unwrap_or(0));
        let kept =
            (whole..self.digits.len()).map(|i| ((digit(i) | digit(i + 1) << 32) >> part) as u32).collect();
        let quotient = Integer::new(self.negative, kept);
        // Towards zero so far; a negative number that lost something is one lower.
        if self.negative && quotient.shifted_up(by) != *self {
            &quotient - &Integer::from(1)
        } else {
            quotient
        }
    }

    /// The quotient, rounded down, and the remainder of this number ≥ 0 by `divisor` > 0, bit by bit.
    pub fn divided(&self, divisor: &Integer) -> (Integer, Integer) {
        assert!(!self.negative && divisor.sign() == Ordering::Greater, "a division of natural numbers");
        let (mut quotient, mut rest) = (Integer::zero(), self.clone());
        for place in (0..=(self.bits() + 1).saturating_sub(divisor.bits())).rev() {
            let part = divisor.shifted_up(place);
            if rest.compared(&part) != Ordering::Less {
                rest = &rest - &part;
                quotient = &quotient + &Integer::power_of_two(place);
            }
        }
        (quotient, rest)
    }

    /// Self against other.
    pub fn compared(&self, other: &Integer) -> Ordering {
        match (self.negative, other.negative) {
            (false, true) => Ordering::Greater,
            (true, false) => Ordering::Less,
            (false, false) => magnitudes(&self.digits, &other.digits),
            (true, true) => magnitudes(&other.digits, &self.digits),
        }
    }
}

fn magnitudes(a: &[u32], b: &[u32]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

fn sum(a: &[u32], b: &[u32]) -> Vec<u32> {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut digits = Vec::with_capacity(long.len() + 1);
    let mut carry = 0u64;
    for (i, &digit) in long.iter().enumerate() {
        carry += u64::from(digit) + u64::from(short.get(i).copied().unwrap_or(0));
        digits.push(carry as u32);
        carry >>= 32;
    }
    digits.push(carry as u32);
    digits
}

/// a − b for a ≥ b.
fn difference(a: &[u32], b: &[u32]) -> Vec<u32> {
    let mut borrow = 0i64;
    let digit = |(i, &digit): (usize, &u32)| {
        let value = i64::from(digit) - i64::from(b.get(i).copied().unwrap_or(0)) - borrow;
        borrow = i64::from(value < 0);
        (value + (borrow << 32)) as u32
    };
    a.iter().enumerate().map(digit).collect()
}

impl Add for &Integer {
    type Output = Integer;

    fn add(self, other: &Integer) -> Integer {
        if self.negative == other.negative {
            return Integer::new(self.negative, sum(&self.digits, &other.digits));
        }
        match magnitudes(&self.digits, &other.digits) {
            Ordering::Less => Integer::new(other.negative, difference(&other.digits, &self.digits)),
            _ => Integer::new(self.negative, difference(&self.digits, &other.digits)),
        }
    }
}

impl Neg for &Integer {
    type Output = Integer;

    fn neg(self) -> Integer {
        Integer::new(!self.negative, self.digits.clone())
    }
}

impl Sub for &Integer {
    type Output = Integer;

    fn sub(self, other: &Integer) -> Integer {
        self + &-other
    }
}

impl Mul for &Integer {
    type Output = Integer;

    fn mul(self, other: &Integer) -> Integer {
        let mut digits = vec![0u32; self.digits.len() + other.digits.len()];
        for (i, &a) in self.digits.iter().enumerate() {
            // a b + c + d < 2⁶⁴ for digits.
            let mut carry = 0u64;
            for (place, &b) in digits[i..].iter_mut().zip(&other.digits) {
                carry += u64::from(a) * u64::from(b) + u64::from(*place);
                *place = carry as u32;
                carry >>= 32;
            }
            digits[i + other.digits.len()] = carry as u32;
        }
        Integer::new(self.negative != other.negative, digits)
    }
}

impl From<u64> for Integer {
    fn from(value: u64) -> Integer {
        Integer::new(false, vec![value as u32, (value >> 32) as u32])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn big(value: i128) -> Integer {
        let digits = (0..4).map(|i| (value.unsigned_abs() >> (32 * i)) as u32).collect();
        Integer::new(value < 0, digits)
    }

    /// All pairs of numbers about powers of 2³², where carries and borrows run.
    #[test]
    fn operations_agree_with_128_bits() {
        let near = [0i128, 1, 2, 3, 1 << 31, (1 << 32) - 1, 1 << 32, (1 << 33) + 5, (1 << 61) - 1, 1 << 62];
        let numbers: Vec<i128> = near.iter().flat_map(|&x| [x, -x, x - 1, 1 - x]).collect();
        for &a in &numbers {
            assert_eq!(big(a).sign(), a.cmp(&0));
            assert_eq!(-&big(a), big(-a));
            assert_eq!(big(a).bits(), 128 - a.unsigned_abs().leading_zeros() as usize);
            for by in [0, 1, 5, 31, 32, 33, 60, 64, 200] {
                let down = if by < 127 { a >> by } else { a >> 127 };
                assert_eq!(big(a).shifted_down(by), big(down), "{a} >> {by}");
                assert_eq!(big(a).shifted_up(by).shifted_down(by), big(a), "{a} << {by}");
            }
            for &b in &numbers {
                assert_eq!(&big(a) + &big(b), big(a + b), "{a} + {b}");
                assert_eq!(&big(a) - &big(b), big(a - b), "{a} - {b}");
                assert_eq!(&big(a) * &big(b), big(a * b), "{a} * {b}");
                assert_eq!(big(a).compared(&big(b)), a.cmp(&b), "{a} against {b}");
                if a >= 0 && b > 0 {
                    assert_eq!(big(a).divided(&big(b)), (big(a / b), big(a % b)), "{a} / {b}");
                }
            }
        }
    }

    #[test]
    fn decimals_are_read() {
        assert_eq!(Integer::read("0"), Some(Integer::zero()));
        assert_eq!(Integer::read("18446744073709551616"), Some(big(1 << 64)));
        for bad in ["", "-1", "1.5", "x", "٣"] {
            assert_eq!(Integer::read(bad), None, "{bad}");
        }
    }
}
