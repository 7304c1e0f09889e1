//! Exponents of two that cannot overflow: stored within ±2⁶², computed exactly in 128 bits.
//!
//! Nothing adds or subtracts a stored exponent. It is made [`wide`](Exponent::wide), every sum of a few of
//! these and of lengths in bits is exact, and [`Exponent::fit`], the only way back, says what does not fit.

/// The largest stored exponent.
const LIMIT: i128 = 1 << 62;

/// A stored exponent: −2⁶² ≤ e ≤ 2⁶².
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Exponent(i64);

/// On which side an exponent lies outside what is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Misfit {
    /// Below −2⁶²: the number is smaller than any that can be written.
    Below,
    /// Above 2⁶².
    Above,
}

impl Exponent {
    pub const LOWEST: Exponent = Exponent(-LIMIT as i64);
    pub const ZERO: Exponent = Exponent(0);

    /// The exponent, if it can be stored.
    pub fn fit(e: i128) -> Result<Exponent, Misfit> {
        match e {
            _ if e < -LIMIT => Err(Misfit::Below),
            _ if e > LIMIT => Err(Misfit::Above),
            _ => Ok(Exponent(e as i64)),
        }
    }

    /// The exponent as a number to compute with.
    pub fn wide(self) -> i128 {
        self.0.into()
    }
}
