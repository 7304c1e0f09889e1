//! Boxes of parameters, checked once.

use std::f64::consts::{PI, TAU};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero, pow};

use super::{oscillator::Functions, tube::Tube};
use crate::{
    error::{Error, Result},
    monitor::Monitor,
    word::{Rectangle, Word},
};

/// What the two parameters of a box are.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Coordinates {
    /// Natural frequency over that of the drive, and damping ratio.
    Machine,
    /// r and s.
    Polar,
    /// a₁ and a₂.
    Plane,
    /// Those of which damping and stiffness are functions, two or more.
    Oscillator(Functions),
}

/// All points with two parameters between bounds, both included; or with more, of which damping and stiffness
/// are functions.
///
/// ```
/// use grazing::{number::parse_rational, tolerance::ParameterBox};
/// let bounds = [parse_rational("0.98")?, parse_rational("0.99")?];
/// assert!(ParameterBox::polar(bounds.clone(), [parse_rational("0.2")?, parse_rational("0.21")?]).is_ok());
/// assert!(ParameterBox::polar(bounds.clone(), bounds).unwrap_err().is_input());
/// # Ok::<(), grazing::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterBox {
    pub(super) coordinates: Coordinates,
    /// The bounds of every parameter, at least two.
    pub(super) sides: Vec<[BigRational; 2]>,
}

impl ParameterBox {
    /// A linear machine of one degree of freedom that touches its stop once per period of the drive:
    /// `ratio` = ω₀/Ω, its undamped natural frequency over that of the drive, and `damping` = ζ.
    ///
    /// a₂ = r² with r = exp(−2πζω₀/Ω); the eigenvalues turn by σ = √(1−ζ²) ω₀/Ω per period if ζ < 1, s is the
    /// distance of σ to the nearest integer, and sign γ = sign sin 2πσ (72)–(74).
    ///
    /// # Errors
    /// An input error unless 0 < `ratio` ≤ 1000, 0 ≤ `damping` ≤ 1000, lower ends first.
    pub fn machine(ratio: [BigRational; 2], damping: [BigRational; 2]) -> Result<ParameterBox> {
        let most = BigRational::from_integer(1000.into());
        let both = |x: &[BigRational; 2]| x[1] <= most;
        if !ratio[0].is_positive() || !both(&ratio) {
            return Err(Error::input(format!(
                "natural over drive frequency from {} to {}: above 0 and at most 1000",
                ratio[0], ratio[1]
            )));
        }
        if damping[0].is_negative() || !both(&damping) {
            return Err(Error::input(format!(
                "damping ratio from {} to {}: from 0 to 1000",
                damping[0], damping[1]
            )));
        }
        ParameterBox::ordered(Coordinates::Machine, vec![ratio, damping])
    }

    /// Modulus and angle of complex eigenvalues.
    ///
    /// # Errors
    /// An input error unless 0 < r ≤ 1 and 0 < s < ½, lower ends first.
    pub fn polar(r: [BigRational; 2], s: [BigRational; 2]) -> Result<ParameterBox> {
        if !r[0].is_positive() || r[1] > BigRational::one() {
            return Err(Error::input(format!(
                "r from {} to {}: a box lies in 0 < r <= 1 (for r > 1 reverse time: 1/r and s)",
                r[0], r[1]
            )));
        }
        if !s[0].is_positive() || &s[1] + &s[1] >= BigRational::one() {
            return Err(Error::input(format!("s from {} to {}: a box lies in 0 < s < 1/2", s[0], s[1])));
        }
        ParameterBox::ordered(Coordinates::Polar, vec![r, s])
    }

    /// Trace and determinant.
    ///
    /// # Errors
    /// An input error unless 0 < a₂ ≤ 1, lower ends first.
    pub fn plane(a1: [BigRational; 2], a2: [BigRational; 2]) -> Result<ParameterBox> {
        Rectangle::reaching(a1.clone(), a2.clone(), 2)?;
        ParameterBox::ordered(Coordinates::Plane, vec![a1, a2])
    }

    /// With two parameters or more.
    pub(super) fn ordered(coordinates: Coordinates, sides: Vec<[BigRational; 2]>) -> Result<ParameterBox> {
        match sides.iter().find(|[lower, upper]| lower > upper) {
            Some([lower, upper]) => {
                Err(Error::input(format!("from {lower} to {upper}: the lower end comes first")))
            }
            None => Ok(ParameterBox { coordinates, sides }),
        }
    }

    /// The bounds of every parameter, in their order.
    pub fn sides(&self) -> impl Iterator<Item = &[BigRational; 2]> {
        self.sides.iter()
    }

    /// A parameter that is not known exactly, this one if it is not; the first, if all are.
    pub(super) fn wide_axis(&self, axis: usize) -> usize {
        let is_wide = |axis: &usize| !is_flat(&self.sides[*axis]);
        std::iter::once(axis).chain(0..self.sides.len()).find(is_wide).unwrap_or(0)
    }

    /// The bounds of the first two parameters.
    pub fn bounds(&self) -> &[[BigRational; 2]; 2] {
        self.sides.first_chunk().expect("two parameters or more")
    }

    /// a₁ and a₂ where the parameters have these values, in floats: for pictures. NaN where damping or
    /// stiffness are not defined. A third parameter, and more, are in their middle.
    pub fn in_plane(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        match &self.coordinates {
            Coordinates::Plane => [x, y],
            Coordinates::Polar => [2.0 * x * (TAU * y).cos(), x * x],
            Coordinates::Oscillator(Functions(of)) => {
                let point = BigRational::from_float(x).zip(BigRational::from_float(y));
                let rest = self.sides[2..].iter().map(middle);
                let at = |(x, y)| of.at(&[x, y].into_iter().chain(rest).collect::<Vec<_>>()).ok();
                let found = point.and_then(at);
                let [c, k] = found.map_or([f64::NAN; 2], |both| both.map(|x| x.to_f64().unwrap_or(f64::NAN)));
                let (decay, square) = ((-c * PI).exp(), k - 0.25 * c * c);
                let swing = TAU * square.abs().sqrt();
                [2.0 * decay * if square > 0.0 { swing.cos() } else { swing.cosh() }, decay * decay]
            }
            Coordinates::Machine => {
                let (decay, swing) = (TAU * x * y, TAU * x * (1.0 - y * y).abs().sqrt());
                let a1 = match y < 1.0 {
                    true => 2.0 * (-decay).exp() * swing.cos(),
                    false => (swing - decay).exp() + (-swing - decay).exp(),
                };
                [a1, (-2.0 * decay).exp()]
            }
        }
    }

    /// The middle, of the first two parameters.
    pub fn centre(&self) -> [BigRational; 2] {
        self.bounds().each_ref().map(middle)
    }

    /// The middle, of all.
    pub(super) fn middle(&self) -> Vec<BigRational> {
        self.sides().map(middle).collect()
    }

    /// A point of it near its middle, each parameter in as few decimals as one has; the middle itself if 30
    /// are too few.
    pub fn short_point(&self) -> Vec<BigRational> {
        let one = |side: &[BigRational; 2]| {
            let middle = middle(side);
            let least = (&side[0] + &middle) / BigRational::from_integer(2.into());
            let rounded = |places: usize| {
                let scale = BigRational::from_integer(pow(BigInt::from(10), places));
                (&middle * &scale).floor() / scale
            };
            (0..=30).map(rounded).find(|x| *x >= least).unwrap_or_else(|| middle.clone())
        };
        self.sides().map(one).collect()
    }

    /// The name of its coordinates, as a certificate has it; none where damping and stiffness are functions.
    pub(crate) fn coordinates_name(&self) -> Option<&'static str> {
        match self.coordinates {
            Coordinates::Machine => Some("machine"),
            Coordinates::Polar => Some("polar"),
            Coordinates::Plane => Some("plane"),
            Coordinates::Oscillator(_) => None,
        }
    }

    /// The parameter along which its image in the plane is longer, by floats at the middles of its sides;
    /// none of a point.
    pub(crate) fn longer(&self) -> Option<usize> {
        let float = |x: &BigRational| x.to_f64().unwrap_or(0.0);
        let middle = self.centre().each_ref().map(float);
        let length = |i: usize| {
            let [from, to] = self.sides[i].each_ref().map(|end| {
                let mut at = middle;
                at[i] = float(end);
                self.in_plane(at)
            });
            (to[0] - from[0]).abs() + (to[1] - from[1]).abs()
        };
        match self.bounds().each_ref().map(is_flat) {
            [true, true] => None,
            [true, false] => Some(1),
            [false, true] => Some(0),
            [false, false] => Some(usize::from(length(1) > length(0))),
        }
    }

    /// Whether it is one point.
    pub fn is_point(&self) -> bool {
        self.sides().all(is_flat)
    }

    /// The two halves, cut across one parameter.
    pub(crate) fn halves(&self, axis: usize) -> [ParameterBox; 2] {
        let middle = middle(&self.sides[axis]);
        [1, 0].map(|end| {
            let mut half = self.clone();
            half.sides[axis][end] = middle.clone();
            half
        })
    }

    /// The word that all points have in common, of at most `limit` letters, as
    /// [`Word::in_rectangle`](crate::word::Word::in_rectangle) has it for (a₁, a₂).
    ///
    /// Cost: each of its O(`limit`) signs is asked on the cells of one partition, at most
    /// 4096 of them.
    ///
    /// # Errors
    /// An input error if `limit` is not in 1..=[`MAX_LETTERS`](crate::word::MAX_LETTERS); the monitor's
    /// interruption.
    pub fn word(&self, positive: bool, limit: usize, monitor: &dyn Monitor) -> Result<Word> {
        let tube = Tube::new(self);
        Word::of_set(&tube, tube.realm(), positive, limit, monitor)
    }

    /// The sign of γ at every point of a machine's box, if it is certain that there is one. `None` for other
    /// boxes, in which γ is free.
    pub fn gamma_is_positive(&self) -> Option<bool> {
        Tube::new(self).gamma()
    }

    /// Whether γ is a function of the parameters.
    pub fn has_gamma(&self) -> bool {
        matches!(self.coordinates, Coordinates::Machine | Coordinates::Oscillator(_))
    }
}

fn middle([lower, upper]: &[BigRational; 2]) -> BigRational {
    (lower + upper) / BigRational::from_integer(2.into())
}

/// Whether nothing lies between.
pub(super) fn is_flat([lower, upper]: &[BigRational; 2]) -> bool {
    (upper - lower).is_zero()
}
