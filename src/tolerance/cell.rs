//! Signs of u_n and b_{n,k} on a cell, in the cell's own parameters: b_{n,k} by its `expansion`, u_n by the
//! range of s.
//!
//! For a machine, with κ = √(1−ζ²), r = exp(−2πζρ) and θ = ±2πκρ + const in the parameters (ρ, ζ), the slopes
//! of r and θ = 2πs are
//!
//! ```text
//! r: −2πζ r̂, −2πρ(c) r̂        θ: ±2πκ, ∓2πρ(c) ζ/κ       r̂, ζ and κ anywhere on the cell
//! ```
//!
//! All of it in intervals of floats; e^x, sin, cos and √ by balls, once per cell.

use std::cell::Cell as Kept;

use num_rational::BigRational;
use num_traits::One;

use super::{
    expansion::{Expansion, F, float, hull, most, short, whole, widest},
    oscillator::{self, Functions},
    parameters::{Coordinates, ParameterBox},
};
use crate::{
    local::{Answer, Polar, Rung, SignDecision},
    number::{Angle, Ball, Circular, Elementary, Precision, Real, Sign},
    word::{Extent, Realm, Rectangle, Signs},
};

/// The largest index of a sign.
pub(super) const LONGEST: u64 = 512;

/// The same on rectangles of (a₁, a₂).
const PLANE_LONGEST: u64 = 96;

pub(super) const BITS: u32 = 96;

/// A box whose words are asked for on the whole of it.
#[derive(Debug)]
pub(super) struct Cell {
    image: Image,
    /// Whether γ > 0, where the box says so at all its points.
    pub gamma: Option<bool>,
    /// Which parameter the last open sign varies with most.
    axis: Kept<usize>,
}

/// What is known of the image of a cell.
#[derive(Debug)]
pub(super) enum Image {
    /// Complex eigenvalues, or those that border on them.
    Polar {
        turn: Turn,
        expansion: Option<Box<Expansion>>,
    },
    Plane(Box<Rectangle>),
    /// Real eigenvalues in (0, 1).
    Two,
}

/// The angle as a fraction of a turn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turn {
    s: F,
    /// Whether s = 0 is among its values, or region 2, where u_n > 0.
    at_zero: bool,
    /// Whether s = ½ is.
    at_half: bool,
    /// Which parameter it varies with most.
    axis: usize,
}

impl Cell {
    pub fn new(of: &ParameterBox) -> Cell {
        let wider = of.wide_axis(0);
        let (image, gamma) = match &of.coordinates {
            Coordinates::Machine => machine(of.bounds()),
            Coordinates::Oscillator(Functions(functions)) => oscillator::image(&**functions, of),
            Coordinates::Polar => (polar(of.bounds()), None),
            Coordinates::Plane => {
                let [a1, a2] = of.bounds().clone();
                let wide = |[lower, upper]: &[BigRational; 2]| upper - lower;
                let axis = usize::from(wide(&a2) > wide(&a1));
                // The bounds were checked when the box was made.
                let image = Rectangle::reaching(a1, a2, PLANE_LONGEST)
                    .map_or(nothing(axis), |rectangle| Image::Plane(Box::new(rectangle)));
                return Cell { image, gamma: None, axis: Kept::new(axis) };
            }
        };
        Cell { image, gamma, axis: Kept::new(wider) }
    }

    /// The parameter to cut across so that what was open last becomes certain soonest.
    pub fn axis(&self) -> usize {
        self.axis.get()
    }

    pub fn realm(&self) -> Realm {
        match &self.image {
            Image::Polar { .. } => Realm::Inside,
            Image::Plane(rectangle) => rectangle.realm(),
            Image::Two => Realm::Two,
        }
    }

    /// The angle, of complex eigenvalues and those that border on them.
    pub fn turn(&self) -> Option<Turn> {
        match &self.image {
            Image::Polar { turn, .. } => Some(*turn),
            _ => None,
        }
    }

    /// The sign of u_n at all points.
    pub fn u(&self, n: u64) -> Option<Sign> {
        let (turn, axis) = match &self.image {
            Image::Polar { turn, .. } => (turn, turn.axis),
            Image::Plane(rectangle) => return rectangle.u(n),
            Image::Two => return Some(Sign::Positive),
        };
        let found = turn.sign(n);
        if found.is_none() {
            self.axis.set(axis);
        }
        found
    }

    /// The sign of b_{n,k} at all points.
    pub fn b(&self, n: u64, k: u64) -> Option<Sign> {
        Some(self.u(n)? * self.numerator(n, k)?)
    }

    /// The sign of N_{n,k} at all points.
    pub fn numerator(&self, n: u64, k: u64) -> Option<Sign> {
        match &self.image {
            Image::Polar { expansion: Some(expansion), .. } if n <= LONGEST => {
                let found = expansion.sign(n, k);
                if let Err(axis) = found {
                    self.axis.set(axis);
                }
                found.ok()
            }
            Image::Polar { turn, .. } => {
                self.axis.set(turn.axis);
                None
            }
            Image::Plane(rectangle) => rectangle.numerator(n, k),
            Image::Two => None,
        }
    }
}

impl Cell {
    /// Whether period n occurs, of which `lower` and `upper` are the parents, for eµ > 0, if that is the same
    /// at all points. By S3 the upper parent decides above s, where u_n < 0, and the lower one below it;
    /// where u_n = 0 it does not.
    pub fn occurs(&self, n: u64, lower: u64, upper: u64) -> Option<bool> {
        match self.u(n) {
            Some(Sign::Negative) => Some(self.numerator(n, upper)? == Sign::Negative),
            Some(_) => Some(self.numerator(n, lower)? == Sign::Positive),
            None => {
                let absent = self.numerator(n, upper) == Some(Sign::Positive)
                    && self.numerator(n, lower) == Some(Sign::Negative);
                absent.then_some(false)
            }
        }
    }
}

/// The most candidates for the period that decides about chaos on one cell.
const CANDIDATES: u64 = 6;

impl Cell {
    /// Whether chaos is born for eµ > 0 and this sign of γ, if that is the same at all points, by one period
    /// that depends on s alone: W6 in region 3 (`proofs/words.md`, section 9). Where that period is not the
    /// same at all points, each that it may be has to say the same on all of the cell.
    ///
    /// γ < 0: chaos is born iff a second lower period occurs, n = ⌊1/s⌋ + 1: iff N_{n,1} > 0. γ > 0: a second
    /// upper one, K + 1 with K = ⌊1/(2s)⌋ + 1 where s ≤ ¼, and n = 2m + 1, m/n the least above s, elsewhere:
    /// iff N_{K+1,K} < 0, N_{n,2} < 0.
    pub fn chaos_ahead(&self, gamma_is_positive: bool) -> Option<bool> {
        let Image::Polar { turn: Turn { s, .. }, expansion: Some(expansion) } = &self.image else {
            return None;
        };
        let one = F::integer(1, &());
        // Both ends of a floor of a fraction that falls or rises with s.
        let floors = |x: F| {
            let [least, most] = [x.lo().floor(), x.hi().floor()];
            (least >= 0.0 && most < LONGEST as f64).then_some([least as u64, most as u64])
        };
        let mut candidates = Vec::new();
        if gamma_is_positive {
            let quarter = 0.25;
            if s.lo() <= quarter {
                let up_to = F::from_bounds(s.lo(), s.hi().min(quarter));
                let [least, most] = floors(one / &(F::integer(2, &()) * &up_to))?;
                candidates.extend((least..=most.min(least + CANDIDATES)).map(|j| (j + 2, j + 1)));
            }
            if s.hi() > quarter {
                // m/(2m+1) > s iff m > s/(1 − 2s).
                let from = F::from_bounds(s.lo().max(quarter), s.hi());
                let [least, most] = floors(from / &(one - &(F::integer(2, &()) * &from)))?;
                candidates.extend((least..=most.min(least + CANDIDATES)).map(|j| (2 * j + 3, 2)));
            }
        } else {
            let [least, most] = floors(one / s)?;
            candidates.extend((least..=most.min(least + CANDIDATES)).map(|j| (j + 1, 1)));
        }
        let wanted = if gamma_is_positive { Sign::Negative } else { Sign::Positive };
        let mut found = None;
        for (n, k) in candidates.iter().copied().take(CANDIDATES as usize + 1) {
            let chaos = expansion.sign(n, k).ok()? == wanted;
            if found.is_some_and(|known| known != chaos) {
                return None;
            }
            found = Some(chaos);
        }
        found.filter(|_| candidates.len() <= CANDIDATES as usize)
    }

    /// The same for eµ < 0 and complex eigenvalues. The periods are those with 2ns < 1, all with the letter
    /// D: for γ < 0 none follows itself, for γ > 0 all do, and a second one occurs iff 4s < 1.
    pub fn chaos_behind(&self, gamma_is_positive: bool) -> Option<bool> {
        let Image::Polar { turn, .. } = &self.image else { return None };
        if gamma_is_positive { Some(turn.sign(2)? == Sign::Positive) } else { Some(false) }
    }
}

/// An image of which nothing is known.
pub(super) fn nothing(axis: usize) -> Image {
    let s = F::from_bounds(0.0, 0.5);
    Image::Polar { turn: Turn { s, at_zero: true, at_half: true, axis }, expansion: None }
}

impl Turn {
    /// The sign of sin 2πns, and in the limit at 0 and ½ of u_n.
    pub fn sign(&self, n: u64) -> Option<Sign> {
        let x = whole(2) * &F::ratio(&BigRational::from_integer(n.into()), &()) * &self.s;
        let half_turns = n as f64 - 1.0;
        let whole = if self.at_half { half_turns } else { x.lo().floor() };
        let above = x.lo() > whole || (self.at_zero && whole == 0.0);
        let below = x.hi() < whole + 1.0 || self.at_half;
        (above && below).then(|| if whole % 2.0 == 0.0 { Sign::Positive } else { Sign::Negative })
    }
}

/// The half width, rounded up, and the middle.
fn half_and_middle(bounds: &[[BigRational; 2]; 2]) -> [(F, BigRational); 2] {
    let two = BigRational::from_integer(2.into());
    bounds.each_ref().map(|side| (half_width(side), (&side[0] + &side[1]) / &two))
}

/// Rounded up.
pub(super) fn half_width([lower, upper]: &[BigRational; 2]) -> F {
    most(float(&((upper - lower) / BigRational::from_integer(2.into()))))
}

fn polar(bounds: &[[BigRational; 2]; 2]) -> Image {
    let [(hr, r), (hs, s)] = half_and_middle(bounds);
    let angle = Angle::new(&(&s + &s));
    let two_pi = short(&Ball::pi(&Precision::new(BITS))) * &F::integer(2, &());
    let (zero, one) = (F::integer(0, &()), F::integer(1, &()));
    let at = [F::sin(&angle, &()), F::cos(&angle, &()), float(&r)];
    let expansion =
        Expansion::new(vec![hr, hs], vec![[one, zero], [zero, two_pi]], at, most(float(&bounds[0][1])));
    let turn =
        Turn { s: hull(float(&bounds[1][0]), float(&bounds[1][1])), at_zero: false, at_half: false, axis: 1 };
    Image::Polar { turn, expansion: Some(Box::new(expansion)) }
}

/// The image of a machine's box, and whether γ > 0 on all of it.
fn machine(bounds: &[[BigRational; 2]; 2]) -> (Image, Option<bool>) {
    let one = BigRational::one();
    let [[least_ratio, most_ratio], [least_damping, most_damping]] = bounds;
    if least_damping >= &one {
        return (Image::Two, Some(true));
    }
    let precision = Precision::new(BITS);
    let exact = |x: &BigRational| Ball::ratio(x, &precision);
    let kappa = |zeta: &BigRational| exact(&(&one - zeta * zeta)).sqrt();
    let real_too = most_damping >= &one;
    let (most_kappa, least_kappa) =
        (kappa(least_damping), if real_too { Ball::integer(0, &precision) } else { kappa(most_damping) });
    // σ, in half turns.
    let half_turns = |ratio: &BigRational, kappa: &Ball| short(&(exact(&(ratio + ratio)) * kappa));
    let x = hull(half_turns(least_ratio, &least_kappa), half_turns(most_ratio, &most_kappa));
    let band = x.lo().floor();
    let inside = x.lo() > band && x.hi() < band + 1.0;
    let [(h0, ratio), (h1, damping)] = half_and_middle(bounds);
    if real_too || !inside {
        // γ > 0 up to half a turn, and where the eigenvalues are real.
        let gamma = (real_too && x.hi() < 1.0).then_some(true);
        return (at_border(x, band, real_too, usize::from(real_too)), gamma);
    }
    let two_pi = short(&Ball::pi(&precision)) * &F::integer(2, &());
    let decay = |ratio: &BigRational, damping: &BigRational| {
        (-(Ball::pi(&precision) * &exact(&(ratio * damping * BigRational::from_integer(2.into())))))
            .exp(&precision)
    };
    let radius = hull(short(&decay(most_ratio, most_damping)), short(&decay(least_ratio, least_damping)));
    let zeta = hull(float(least_damping), float(most_damping));
    let kappas = hull(short(&least_kappa), short(&most_kappa));
    let turned = two_pi * &float(&ratio);
    let slope =
        [[-(two_pi * &zeta * &radius), two_pi * &kappas], [-(turned * &radius), -(turned * &zeta / &kappas)]];
    let angle = Ball::pi(&precision) * &exact(&(&ratio + &ratio)) * &kappa(&damping);
    let at = At { angle, radius: decay(&ratio, &damping) };
    let half = vec![h0, h1];
    let axis = widest(slope.iter().map(|slope| slope[1]), &half);
    complex(half, x, band, slope.to_vec(), &at, radius, axis)
}

/// The middle of a cell.
pub(super) struct At {
    /// 2πσ.
    pub angle: Ball,
    /// r.
    pub radius: Ball,
}

/// A cell that lies between one multiple of ½ of σ and the next: σ in half turns, the lower multiple, the
/// slopes of r and of 2πσ in each parameter, the middle, r anywhere, and the parameter that σ varies with
/// most; and whether γ > 0.
pub(super) fn complex(
    half: Vec<F>,
    half_turns: F,
    band: f64,
    mut slope: Vec<[F; 2]>,
    at: &At,
    radius: F,
    axis: usize,
) -> (Image, Option<bool>) {
    let odd = band % 2.0 == 1.0;
    let by_half = F::from_bounds(0.5, 0.5) * &half_turns;
    let s = if odd {
        F::from_bounds((band + 1.0) / 2.0, (band + 1.0) / 2.0) - &by_half
    } else {
        by_half - &F::from_bounds(band / 2.0, band / 2.0)
    };
    let (sine, cosine) = at.angle.sin_cos(&Precision::new(BITS));
    let sine = if odd { -sine } else { sine };
    if odd {
        slope.iter_mut().for_each(|[_, angle]| *angle = -*angle);
    }
    let at = [short(&sine), short(&cosine), short(&at.radius)];
    let expansion = Expansion::new(half, slope, at, most(radius));
    let turn = Turn { s, at_zero: false, at_half: false, axis };
    (Image::Polar { turn, expansion: Some(Box::new(expansion)) }, Some(!odd))
}

/// Where σ may be a multiple of ½: between one multiple, or region 2, and as far as it reaches.
pub(super) fn at_border(x: F, band: f64, real_too: bool, axis: usize) -> Image {
    if real_too {
        if x.hi() >= 1.0 {
            return nothing(axis);
        }
        let s = F::from_bounds(0.0, x.hi() / 2.0);
        return Image::Polar { turn: Turn { s, at_zero: true, at_half: false, axis }, expansion: None };
    }
    let border = if x.lo() > band { band + 1.0 } else { band };
    if x.lo() <= border - 1.0 || x.hi() >= border + 1.0 {
        return nothing(axis);
    }
    // Differences of floats of one size are exact.
    let away = (border - x.lo()).max(x.hi() - border).next_up() / 2.0;
    let at_half = border % 2.0 == 1.0;
    let s = if at_half { F::from_bounds((0.5 - away).next_down(), 0.5) } else { F::from_bounds(0.0, away) };
    Image::Polar { turn: Turn { s, at_zero: !at_half, at_half, axis }, expansion: None }
}

impl Signs for Cell {
    /// Up to [`LONGEST`] only: near s = 0 the first period that is open may be any, and would be looked for.
    fn side(&self, n: u64) -> Result<Sign, Rung> {
        let asked = n <= LONGEST || matches!(self.image, Image::Two);
        if asked { self.u(n).ok_or(Rung::Exact) } else { Err(Rung::Exact) }
    }

    fn deciding(&self, n: u64, k: u64) -> SignDecision {
        decision(self.b(n, k))
    }

    fn absent(&self, n: u64, lower: u64, upper: u64) -> bool {
        self.occurs(n, lower, upper) == Some(false)
    }

    fn open(&self, next: u64, _: Rung) -> Extent {
        Extent::Straddled { next }
    }

    fn on_circle(&self) -> bool {
        false
    }

    fn polar(&self) -> Option<&Polar> {
        None
    }
}

pub(super) fn decision(sign: Option<Sign>) -> SignDecision {
    SignDecision { answer: sign.map_or(Answer::Undecided, Answer::Sign), rung: Rung::Exact }
}
