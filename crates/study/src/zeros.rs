//! Points at a given distance from where a sign changes or a form degenerates: as near as one likes, or
//! exactly there.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::{
    error::Result,
    local::{Plane, Point, Polar, Quantity},
    monitor::Monitor,
    number::{Ball, Plain, Precision, Real, Sign},
    random::Random,
};

/// A quantity at a point.
#[derive(Debug, Clone)]
pub struct NearZero {
    /// Where.
    pub point: Point,
    /// What.
    pub quantity: Quantity,
}

/// What is approached.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ZeroFamily {
    /// r = 1, s → m/k: b_{n,k} = 0.
    CircleZero,
    /// r = 1, s → m/(2n), m odd: u_n = 0.
    CirclePole,
    /// r = 1, s → m/g, where g divides k and n − k: b_{n,k} → 0 from one side, and u_n = 0 there.
    CircleDoubleZero,
    /// 1 − r → 0 at s = m/k, a zero of b_{n,k} on r = 1.
    RadiusToOne,
    /// r < 1, s → a zero of b_{n,k}, which is no fraction.
    DampedZero,
    /// n about 10⁹, 1 − r = 2⁻³⁰, s → a zero of b_{n,k}.
    HugePeriod,
    /// a₂ < 1, complex eigenvalues, a₁ → a zero of b_{n,k}.
    ComplexZero,
    /// a₂ < 1, complex eigenvalues, a₁ → a zero of u_n.
    ComplexPole,
    /// a₂ < 1, negative eigenvalues, a₁ → a zero of b_{n,n−2}, n odd.
    RealZero,
    /// a₁² → 4a₂.
    EqualEigenvalues,
    /// a₁ → 1 + a₂: c_n = 0.
    FactorZero,
}

/// All of them, in the order of the tables.
pub const ZERO_FAMILIES: [ZeroFamily; 11] = [
    ZeroFamily::CircleZero,
    ZeroFamily::CirclePole,
    ZeroFamily::CircleDoubleZero,
    ZeroFamily::RadiusToOne,
    ZeroFamily::DampedZero,
    ZeroFamily::HugePeriod,
    ZeroFamily::ComplexZero,
    ZeroFamily::ComplexPole,
    ZeroFamily::RealZero,
    ZeroFamily::EqualEigenvalues,
    ZeroFamily::FactorZero,
];

/// A place that is approached along one parameter.
#[derive(Debug, Clone)]
pub struct Approached {
    family: ZeroFamily,
    quantity: Quantity,
    /// r or a₂.
    fixed: BigRational,
    /// s or a₁ there: exact, or a fraction within 2⁻³⁷⁰⁰ of it, relatively.
    place: BigRational,
    /// Whether `place` is exact.
    exact: bool,
    /// From which side.
    above: bool,
}

impl ZeroFamily {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            ZeroFamily::CircleZero => "zero on r = 1",
            ZeroFamily::CirclePole => "pole on r = 1",
            ZeroFamily::CircleDoubleZero => "double zero on r = 1",
            ZeroFamily::RadiusToOne => "r -> 1 at zeros",
            ZeroFamily::DampedZero => "zero at r < 1",
            ZeroFamily::HugePeriod => "zero at huge n",
            ZeroFamily::ComplexZero => "zero at complex eigenvalues",
            ZeroFamily::ComplexPole => "pole at complex eigenvalues",
            ZeroFamily::RealZero => "zero at real eigenvalues",
            ZeroFamily::EqualEigenvalues => "equal eigenvalues",
            ZeroFamily::FactorZero => "c_n -> 0",
        }
    }

    /// `count` places, from alternating sides: the same list at every call, a shorter one the start of a
    /// longer one.
    ///
    /// Cost: for zeros that are no fractions a few dozen values in balls of 4096 bits each.
    ///
    /// # Errors
    /// The monitor's interruption, which it is asked for between places.
    pub fn places(self, count: usize, monitor: &dyn Monitor) -> Result<Vec<Approached>> {
        let mut random = Random(0x5157 + self as u64);
        let mut places: Vec<Approached> = Vec::new();
        while places.len() < count {
            monitor.advance(0)?;
            let above = places.len().is_multiple_of(2);
            places.extend(self.place(&mut random).map(|(quantity, fixed, place, exact)| Approached {
                family: self,
                quantity,
                fixed,
                place,
                exact,
                above,
            }));
        }
        Ok(places)
    }

    /// The next place, with r or a₂ before it; `None` if the choice has none.
    fn place(self, random: &mut Random) -> Option<(Quantity, BigRational, BigRational, bool)> {
        let n = random.within(5, 40);
        let k = random.within(1, n - 1);
        let b = Quantity::B { n, k };
        let damped = ratio(random.within(500, 990), 1000);
        match self {
            ZeroFamily::CircleZero | ZeroFamily::RadiusToOne => {
                let s = ratio(random.within(1, k), 2 * k + 1);
                let place = ratio((s * BigInt::from(k)).round().to_integer().try_into().ok()?, k);
                let simple = !on_grid(&place, n - k) && !on_grid(&place, 2 * n);
                (inside(&place) && simple).then(|| (b, ratio(1, 1), place, true))
            }
            ZeroFamily::CirclePole => {
                let place = ratio(2 * random.below(n / 2) + 1, 2 * n);
                let pole = inside(&place) && !on_grid(&place, k) && !on_grid(&place, n - k);
                pole.then(|| (b, ratio(1, 1), place, true))
            }
            ZeroFamily::CircleDoubleZero => {
                let g = n.gcd(&k);
                let place = ratio(random.within(1, g), g);
                // b_{n,k} is of one sign on both sides, u_n is not 0.
                (inside(&place) && !on_grid(&(place.clone() * BigInt::from(2)), 1))
                    .then(|| (b, ratio(1, 1), place, true))
            }
            ZeroFamily::DampedZero => {
                let start = ratio(random.within(1, 440), 1000);
                let zero =
                    Line { family: self, quantity: b, fixed: &damped }.zero(&start, &ratio(1, 20 * n))?;
                Some((b, damped, zero, false))
            }
            ZeroFamily::HugePeriod => {
                let n = 1_000_000_000 - random.below(1000);
                let b = Quantity::B { n, k: n / 2 - random.below(1000) };
                let r = ratio((1 << 30) - 1, 1 << 30);
                let start = ratio(random.within(1, 440), 1001);
                let zero = Line { family: self, quantity: b, fixed: &r }.zero(&start, &ratio(1, 20 * n))?;
                Some((b, r, zero, false))
            }
            ZeroFamily::ComplexZero => {
                // 2√a₂ > 1.
                let start = ratio(random.within(0, 1200), 1000) - ratio(7, 10);
                let line = Line { family: self, quantity: b, fixed: &damped };
                Some((b, damped.clone(), line.zero(&start, &ratio(1, 20 * n))?, false))
            }
            ZeroFamily::ComplexPole => {
                let start = ratio(random.within(0, 1200), 1000) - ratio(7, 10);
                let line = Line { family: self, quantity: b, fixed: &damped };
                Some((b, damped.clone(), line.zero(&start, &ratio(1, 20 * n))?, false))
            }
            ZeroFamily::RealZero => {
                let n = 2 * random.within(2, 12) + 1;
                let b = Quantity::B { n, k: n - 2 };
                // a₁ from −(1 + a₂) to −2√a₂, of which √a₂ = x/1000 is a fraction: the width is (1 − x)².
                let x = ratio(random.within(300, 900), 1000);
                let a2 = &x * &x;
                let width = (ratio(1, 1) - &x) * (ratio(1, 1) - &x);
                let start = -(ratio(1, 1) + &a2) + &width * ratio(1, 1000);
                let zero = Line { family: self, quantity: b, fixed: &a2 }
                    .zero(&start, &(width / BigInt::from(50)))?;
                Some((b, a2, zero, false))
            }
            ZeroFamily::EqualEigenvalues => {
                let x = ratio(random.within(300, 990), 1000);
                let sign = if random.coin() { 2 } else { -2 };
                let (a1, a2) = (&x * BigInt::from(sign), &x * &x);
                Some((b, a2, a1, true))
            }
            ZeroFamily::FactorZero => {
                let a1 = ratio(1, 1) + &damped;
                Some((Quantity::C { n }, damped, a1, true))
            }
        }
    }
}

impl Approached {
    /// The point at a relative distance 10^−`digits`, within a hundredth, from the place, or at the place
    /// itself; `None` where it would lie outside the family's region or where u_n = 0, or the place is no
    /// fraction.
    ///
    /// Along s or a₁; in [`ZeroFamily::RadiusToOne`] the distance is 1 − r.
    pub fn at(&self, digits: Option<u32>) -> Option<NearZero> {
        let step = match digits {
            Some(digits) => BigRational::new(1.into(), BigInt::from(10).pow(digits)),
            None if self.exact => BigRational::zero(),
            None => return None,
        };
        let side = if self.above { step.clone() } else { -step.clone() };
        let mut moved = &self.place * (ratio(1, 1) + side);
        if let (Some(digits), false) = (digits, self.exact) {
            // No more digits than the distance needs: long inputs would cost time of their own.
            let unit = BigInt::from(10).pow(digits + 4);
            moved = BigRational::new((moved * &unit).round().to_integer(), unit);
        }
        let point = match self.family {
            ZeroFamily::RadiusToOne => polar(ratio(1, 1) - step, self.place.clone())?,
            // From c_n's zero into region 2, not out of it.
            ZeroFamily::FactorZero => plane(&self.place * (ratio(1, 1) - step), self.fixed.clone())?,
            ZeroFamily::CircleZero
            | ZeroFamily::CirclePole
            | ZeroFamily::CircleDoubleZero
            | ZeroFamily::DampedZero
            | ZeroFamily::HugePeriod => polar(self.fixed.clone(), moved)?,
            _ => plane(moved, self.fixed.clone())?,
        };
        // A distance away from one place may be at another one, where u_n = 0 and there is no sign.
        let singular = match &point {
            Point::Polar(polar) => polar.is_singular(self.quantity.period()),
            Point::Plane(plane) => plane.is_singular(self.quantity.period()),
        };
        (digits.is_none() || !singular).then_some(NearZero { point, quantity: self.quantity })
    }
}

/// b_{n,k} (or u_n) along s or a₁.
struct Line<'a> {
    family: ZeroFamily,
    quantity: Quantity,
    fixed: &'a BigRational,
}

/// Bits of the balls in which a zero is refined.
const REFINED: u32 = 4096;

impl Line<'_> {
    fn point(&self, at: &BigRational) -> Option<Point> {
        match self.family {
            ZeroFamily::DampedZero | ZeroFamily::HugePeriod => polar(self.fixed.clone(), at.clone()),
            _ => plane(at.clone(), self.fixed.clone()),
        }
    }

    fn value<T: crate::number::Circular>(&self, at: &BigRational, context: &T::Context) -> Option<T> {
        let point = self.point(at)?;
        match (self.family, &point) {
            (ZeroFamily::ComplexPole, Point::Plane(plane)) => Some(plane.u(self.quantity.period(), context)),
            _ => point.evaluate(self.quantity, context),
        }
    }

    /// The sign of the numerator of b_{n,k}, or of u_n: it changes at zeros alone.
    fn sign(&self, at: &BigRational) -> Option<Sign> {
        let value = self.value::<Plain>(at, &())?.sign()?;
        let (n, point) = (self.quantity.period(), self.point(at)?);
        Some(match (self.family, &point) {
            (ZeroFamily::ComplexPole, _) => value,
            (_, Point::Polar(polar)) => value * polar.u_sign(n),
            (_, Point::Plane(plane)) => value * plane.u::<Plain>(n, &()).sign()?,
        })
    }

    /// The first zero from `start` on, sought in forty steps, as a fraction with 3800 bits right.
    fn zero(&self, start: &BigRational, step: &BigRational) -> Option<BigRational> {
        let grid = |i: u32| start + step * BigInt::from(i);
        let first = (0..40).find(|&i| {
            let signs = (self.sign(&grid(i)), self.sign(&grid(i + 1)));
            matches!(signs, (Some(a), Some(b)) if a != b)
        })?;
        let (mut low, mut high) = (grid(first), grid(first + 1));
        let left = self.sign(&low)?;
        for _ in 0..24 {
            let middle = (&low + &high) / BigInt::from(2);
            if self.sign(&middle)? == left { low = middle } else { high = middle }
        }
        // The secant method, which doubles the digits in about one and a half steps.
        let precision = Precision::new(REFINED);
        let value = |at: &BigRational| {
            let (lo, hi) = self.value::<Ball>(at, &precision)?.exact_bounds()?;
            Some(rounded(&((lo + hi) / BigInt::from(2))))
        };
        let (mut f, mut g) = (value(&low)?, value(&high)?);
        for _ in 0..40 {
            let slope = (&g - &f) / (&high - &low);
            if slope.is_zero() {
                return None;
            }
            let next = rounded(&(&high - &g / slope));
            (low, f) = (high, g);
            let change = (&next - &low).abs() / next.abs();
            high = next;
            if change < BigRational::new(1.into(), BigInt::from(1) << 3700u32) {
                return Some(high);
            }
            g = value(&high)?;
        }
        None
    }
}

/// Cut to 4096 bits after the point, and never less than 4096 in all.
fn rounded(x: &BigRational) -> BigRational {
    let scale = BigInt::from(1) << (REFINED as u64 + x.denom().bits().saturating_sub(x.numer().bits()));
    BigRational::new((x * &scale).round().to_integer(), scale)
}

fn polar(r: BigRational, s: BigRational) -> Option<Point> {
    Polar::new(r, s).ok().map(Point::Polar)
}

fn plane(a1: BigRational, a2: BigRational) -> Option<Point> {
    Plane::new(a1, a2).ok().map(Point::Plane)
}

fn inside(s: &BigRational) -> bool {
    s.is_positive() && *s < ratio(9, 20)
}

/// Whether x is a multiple of 1/j.
fn on_grid(x: &BigRational, j: u64) -> bool {
    (x * BigInt::from(j)).is_integer()
}

fn ratio(p: u64, q: u64) -> BigRational {
    BigRational::new(p.into(), q.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::local::{Answer, Ladder};

    /// However near, all bits but 16; a ball of a fixed length loses them all where more than twice its
    /// length would be needed.
    #[test]
    fn close_evaluations_lose_few_bits() {
        let (short, long) = (Precision::new(128), Precision::new(4096));
        let mut lost_otherwise = 0;
        for family in ZERO_FAMILIES {
            for place in family.places(2, &()).unwrap() {
                for at in [1, 18, 60, 300].iter().filter_map(|&digits| place.at(Some(digits))) {
                    let Some(ball) = at.point.evaluate_closely(at.quantity, &short) else { continue };
                    assert!(
                        ball.certain_bits().is_none_or(|bits| bits >= 112),
                        "{family:?}: {ball:?} {at:?}"
                    );
                    let truth = at.point.evaluate::<Ball>(at.quantity, &long).unwrap();
                    assert_eq!((truth - &ball).sign().filter(|&sign| sign != Sign::Zero), None, "{at:?}");
                    let plain = at.point.evaluate::<Ball>(at.quantity, &short).unwrap();
                    lost_otherwise += u32::from(plain.certain_bits().is_some_and(|bits| bits < 112));
                }
            }
        }
        assert!(lost_otherwise > 10, "{lost_otherwise}");
    }

    /// Each place is what its family says: the sign changes there, or not, at every distance, and there it is
    /// zero or the quantity singular.
    #[test]
    fn signs_change_where_they_should() {
        let ladder = Ladder::default();
        let sign = |at: &NearZero| match ladder.sign(&at.point, at.quantity).answer {
            Answer::Sign(sign) => sign,
            other => panic!("{at:?}: {other:?}"),
        };
        for family in ZERO_FAMILIES {
            for place in family.places(2, &()).unwrap() {
                let sides = |digits| {
                    let one = |above| Approached { above, ..place.clone() }.at(Some(digits)).unwrap();
                    (sign(&one(false)), sign(&one(true)))
                };
                for digits in [6 + if family == ZeroFamily::HugePeriod { 10 } else { 0 }, 1000] {
                    let (below, above) = sides(digits);
                    let changes = match family {
                        ZeroFamily::CircleDoubleZero
                        | ZeroFamily::EqualEigenvalues
                        | ZeroFamily::RadiusToOne
                        | ZeroFamily::FactorZero => below == above,
                        _ => below != above && below != Sign::Zero,
                    };
                    assert!(changes, "{family:?} {digits}: {place:?}");
                }
                let there = place.at(None);
                assert_eq!(there.is_some(), place.exact);
                let Some(there) = there else { continue };
                let answer = ladder.sign(&there.point, there.quantity).answer;
                let expected = match family {
                    // Where b_{n,k} has a double zero, u_n = 0: only its limit is 0.
                    ZeroFamily::CirclePole | ZeroFamily::CircleDoubleZero => answer == Answer::Singular,
                    ZeroFamily::EqualEigenvalues => {
                        !matches!(answer, Answer::Undecided | Answer::Sign(Sign::Zero))
                    }
                    _ => answer == Answer::Sign(Sign::Zero),
                };
                assert!(expected, "{family:?}: {answer:?} at {place:?}");
            }
        }
    }
}
