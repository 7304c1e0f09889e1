//! The three charts of the Plane panel, and a view of one: a rectangle around an exact centre.
//!
//! A point of region 3 is λ = r e^{2πis}. Every chart can be left exactly: (a₁, a₂) and (r, s) are the
//! point's own coordinates, and of the disc's x + iy = λ they are a₁ = 2x, a₂ = x² + y². What is drawn is
//! relative to the centre: the difference is enclosed by balls of as many bits as the view is deep, and only
//! then rounded to an `f64`, so that a pixel of 10⁻¹⁵ or 10⁻⁶⁰ is as sharp as one of 10⁻³.

use grazing_scenes::{
    Error, Result,
    local::Forward,
    num_bigint::BigInt,
    num_rational::BigRational,
    number::{Angle, Ball, Circular, Precision, Real, parse_rational},
};
use num_traits::ToPrimitive;
use serde_json::Value as Json;

/// How a point is placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Chart {
    /// a₁ to the right, a₂ upwards.
    Plane,
    /// λ, upper half: re λ to the right, im λ upwards.
    Disc,
    /// s to the right, r upwards.
    Strip,
}

impl Chart {
    fn named(name: &str) -> Result<Chart> {
        match name {
            "plane" => Ok(Chart::Plane),
            "disc" => Ok(Chart::Disc),
            "strip" => Ok(Chart::Strip),
            _ => Err(Error::input(format!("chart {name:?}: plane, disc or strip"))),
        }
    }

    /// The point of the theory at a place, exact.
    ///
    /// # Errors
    /// An input error where there is none: a₂ ≤ 0, y ≤ 0, r ≤ 0 or s outside 0 < s < ½.
    pub fn point(self, x: &BigRational, y: &BigRational) -> Result<Forward> {
        let zero = integer(0);
        if *y <= zero {
            let name = ["a2", "im λ", "r"][self as usize];
            return Err(Error::input(format!("{name} = {y}: it is above 0")));
        }
        let (a1, a2) = match self {
            Chart::Plane => (x.clone(), y.clone()),
            Chart::Disc => (x * integer(2), x * x + y * y),
            Chart::Strip => return Forward::polar(y.clone(), x.clone()),
        };
        Forward::plane(a1, a2)
    }
}

pub fn integer(value: i64) -> BigRational {
    BigRational::from_integer(BigInt::from(value))
}

pub fn ratio(numerator: u64, denominator: u64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// A dyadic fraction near x, with about `bits` bits.
pub fn short(x: &BigRational, bits: u64) -> BigRational {
    let length = x.numer().bits() as i64 - x.denom().bits() as i64;
    let shift = bits as i64 - length;
    let two = BigInt::from(2);
    if shift <= 0 {
        return x.round();
    }
    let scale = two.pow(shift as u32);
    BigRational::new((x * &scale).round().to_integer(), scale)
}

/// The nearest `f64`, of long fractions too: a difference of two thousand-bit numbers is one.
pub fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

/// A view of a chart.
#[derive(Debug, Clone)]
pub struct View {
    pub chart: Chart,
    pub x: BigRational,
    pub y: BigRational,
    pub width: f64,
    pub height: f64,
    /// The sizes of a pixel.
    pub pixel: [f64; 2],
    /// A lower bound of s, and an upper one, over what is seen.
    pub s: [BigRational; 2],
    /// An upper bound of r² over what is seen.
    pub top: BigRational,
    precision: Precision,
}

impl View {
    /// The view that a request asks for.
    ///
    /// # Errors
    /// An input error for a key that is missing or out of range.
    pub fn new(request: &Json) -> Result<View> {
        let text = |key: &str| {
            let missing = || Error::input(format!("{key}: missing from the request, or not text"));
            request[key].as_str().ok_or_else(missing)
        };
        let size = |key: &str| {
            let bad = || Error::input(format!("{key}: a number above 0 is wanted"));
            request[key].as_f64().filter(|x| x.is_finite() && *x >= 1e-300 && *x <= 1e12).ok_or_else(bad)
        };
        let chart = Chart::named(text("chart")?)?;
        let (x, y) = (parse_rational(text("x")?)?, parse_rational(text("y")?)?);
        let (width, height) = (size("width")?, size("height")?);
        let pixel = [width / size("pixels_x")?, height / size("pixels_y")?];
        let depth = -pixel[0].min(pixel[1]).log2();
        let precision = Precision::new(96 + depth.clamp(0.0, 1100.0) as u32);
        let mut view = View {
            chart,
            x,
            y,
            width,
            height,
            pixel,
            s: [integer(0), ratio(1, 2)],
            top: integer(1),
            precision,
        };
        view.bound();
        Ok(view)
    }

    fn half(&self) -> [BigRational; 2] {
        [self.width, self.height]
            .map(|size| BigRational::from_float(size / 2.0).unwrap_or_else(|| integer(1)))
    }

    /// Finds the bounds of s and r. Those of s need not be sharp: they only say what is worth computing, and
    /// have a margin.
    fn bound(&mut self) {
        let [w, h] = self.half();
        let (left, right, low, high) = (&self.x - &w, &self.x + &w, &self.y - &h, &self.y + &h);
        let square = |x: &BigRational| x * x;
        self.top = match self.chart {
            Chart::Plane => high.clone(),
            Chart::Disc => square(&left).max(square(&right)) + square(&high).max(square(&low)),
            Chart::Strip => square(&high),
        };
        let ends = match self.chart {
            Chart::Strip => Some([left, right]),
            _ if low <= integer(0) => None,
            _ => {
                let corners = [(&left, &low), (&left, &high), (&right, &low), (&right, &high)];
                let angles = corners.map(|(x, y)| self.angle(x, y));
                let least = angles.iter().min().cloned();
                least.zip(angles.iter().max().cloned()).map(|(least, most)| [least, most])
            }
        };
        if let Some([least, most]) = ends {
            let margin = (&most - &least) / integer(20);
            self.s = [(least - &margin).max(integer(0)), (most + margin).min(ratio(1, 2))];
        }
    }

    /// s at a place with y > 0, to far below a pixel.
    fn angle(&self, x: &BigRational, y: &BigRational) -> BigRational {
        let (x, y) = match self.chart {
            Chart::Disc => (x.clone(), y.clone()),
            _ => {
                // 2 im λ = √(4a₂ − a₁²).
                let square = y * integer(4) - x * x;
                if square <= integer(0) {
                    return if *x > integer(0) { integer(0) } else { ratio(1, 2) };
                }
                (x.clone(), root(&square, u64::from(self.precision.bits())))
            }
        };
        turn_of(&x, &y, self.precision.bits())
    }

    /// Bits of a fraction that is to be told from its neighbours at the pixel's size.
    pub fn bits(&self) -> u64 {
        u64::from(self.precision.bits())
    }

    /// Where (r, s) lies, relative to the centre.
    pub fn place(&self, s: &BigRational, r: &BigRational) -> [f64; 2] {
        let context = &self.precision;
        let middle = |ball: Ball| {
            ball.exact_bounds().map_or(f64::NAN, |(lower, upper)| float(&((lower + upper) / integer(2))))
        };
        let ball = |x: &BigRational| Ball::ratio(x, context);
        let angle = || Angle::new(&(s * integer(2)));
        match self.chart {
            Chart::Strip => [float(&(s - &self.x)), float(&(r - &self.y))],
            Chart::Plane => [
                middle(Ball::cos(&angle(), context) * &ball(&(r * integer(2))) - &ball(&self.x)),
                float(&(r * r - &self.y)),
            ],
            Chart::Disc => [
                middle(Ball::cos(&angle(), context) * &ball(r) - &ball(&self.x)),
                middle(Ball::sin(&angle(), context) * &ball(r) - &ball(&self.y)),
            ],
        }
    }

    /// Where (a₁, a₂) lies in the chart of these, relative to the centre.
    pub fn plane(&self, a1: &BigRational, a2: &BigRational) -> [f64; 2] {
        [float(&(a1 - &self.x)), float(&(a2 - &self.y))]
    }

    /// The values of r seen, with a margin, within 0 ≤ r ≤ 1: bounds in floats where they need not be sharp,
    /// exact where a chart has them.
    pub fn radii(&self) -> [BigRational; 2] {
        let [_, h] = self.half();
        let margin = &h / integer(10);
        let (low, high) = (&self.y - &h - &margin, &self.y + &h + &margin);
        let within = |x: BigRational| x.max(integer(0)).min(integer(1));
        match self.chart {
            Chart::Strip => [within(low), within(high)],
            Chart::Plane => [low, high].map(|a2| {
                let a2 = within(a2);
                within(if a2 == integer(1) { a2 } else { root(&a2, self.bits()) })
            }),
            Chart::Disc => [integer(0), integer(1)],
        }
    }

    /// Whether two places lie on one side of what is seen, so that nothing between them is.
    pub fn beside(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let [w, h] = [0.55 * self.width, 0.55 * self.height];
        [(0, w), (1, h)]
            .into_iter()
            .any(|(i, size)| (a[i] > size && b[i] > size) || (a[i] < -size && b[i] < -size))
    }

    /// How far the middle of a curve's piece lies from its chord, in pixels.
    pub fn bend(&self, a: [f64; 2], middle: [f64; 2], b: [f64; 2]) -> f64 {
        let pixels = |p: [f64; 2]| [p[0] / self.pixel[0], p[1] / self.pixel[1]];
        let ([ax, ay], [mx, my], [bx, by]) = (pixels(a), pixels(middle), pixels(b));
        let (dx, dy) = (bx - ax, by - ay);
        let length = dx.hypot(dy);
        if length < 1e-9 {
            (mx - ax).hypot(my - ay)
        } else {
            ((mx - ax) * dy - (my - ay) * dx).abs() / length
        }
    }
}

/// The angle of x + iy in turns, y > 0, to about so many bits: a guess, made better by the angle that is left
/// after x + iy was turned back.
pub fn turn_of(x: &BigRational, y: &BigRational, bits: u32) -> BigRational {
    let size = float(x).hypot(float(y)).max(1e-300);
    let turn =
        |angle: f64| BigRational::from_float(angle / std::f64::consts::TAU).unwrap_or_else(|| integer(0));
    let mut s = turn(float(y).atan2(float(x)));
    let context = Precision::new(bits + 32);
    for _ in 0..bits / 48 + 1 {
        let angle = Angle::new(&(&s * integer(2)));
        let off = Ball::ratio(x, &context) * &Ball::sin(&angle, &context)
            - &(Ball::ratio(y, &context) * &Ball::cos(&angle, &context));
        let Some((lower, upper)) = off.exact_bounds() else { break };
        let step = (float(&((lower + upper) / integer(2))) / size).clamp(-1.0, 1.0).asin();
        s -= turn(step);
        if step.abs() < 1e-280 {
            break;
        }
    }
    s
}

/// √x for x > 0, to so many bits.
pub fn root(x: &BigRational, bits: u64) -> BigRational {
    // √(p/q) = √(pq·4^k)/(q·2^k).
    let product: BigInt = (x.numer() * x.denom()) << (2 * bits);
    BigRational::new(product.sqrt(), x.denom() << bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn view(chart: &str, x: &str, y: &str, size: f64) -> View {
        View::new(&json!({"chart": chart, "x": x, "y": y, "width": size, "height": size, "pixels_x": 500, "pixels_y": 500}))
            .unwrap()
    }

    #[test]
    fn floats_of_long_fractions() {
        for (text, value) in
            [("3/8", 0.375), ("-1e-30", -1e-30), ("1/3", 1.0 / 3.0), ("0", 0.0), ("-7", -7.0)]
        {
            assert!((float(&parse_rational(text).unwrap()) - value).abs() <= 1e-15 * value.abs(), "{text}");
        }
        let tiny = parse_rational("3/8+2^-900").unwrap() - ratio(3, 8);
        assert_eq!(float(&tiny), 2f64.powi(-900));
        let long = parse_rational("1/3+2^-2000").unwrap();
        assert!((float(&long) - 1.0 / 3.0).abs() < 1e-16);
    }

    /// The bounds of s hold every point that is seen, at every depth.
    #[test]
    fn bounds_hold_what_is_seen() {
        for size in [1e-2, 1e-9, 1e-12, 1e-40] {
            let view = view("strip", "3/10+2^-70", "1-2^-20", size);
            let centre = view.place(&view.x.clone(), &view.y.clone());
            assert_eq!(centre, [0.0, 0.0]);
            // The same place in the other charts, as their centre.
            for chart in ["plane", "disc"] {
                let (s, r) = (&view.x, &view.y);
                let context = Precision::new(400);
                let angle = Angle::new(&(s * integer(2)));
                let middle = |ball: Ball| {
                    let (lower, upper) = ball.exact_bounds().unwrap();
                    short(&((lower + upper) / integer(2)), 300)
                };
                let x = middle(Ball::cos(&angle, &context) * &Ball::ratio(r, &context));
                let y = middle(Ball::sin(&angle, &context) * &Ball::ratio(r, &context));
                let (x, y) = if chart == "plane" { (x * integer(2), r * r) } else { (x, y) };
                let deep = self::view(chart, &x.to_string(), &y.to_string(), size);
                let [u, v] = deep.place(s, r);
                assert!(u.abs() < 1e-9 * size && v.abs() < 1e-9 * size, "{chart} {size} {u} {v}");
                assert!(deep.s[0] < *s && *s < deep.s[1], "{chart} {size}");
                let width = float(&(&deep.s[1] - &deep.s[0]));
                assert!(width < size && width > size / 50.0, "{chart} {size} {width}");
                assert!(deep.top > r * r);
            }
        }
    }

    #[test]
    fn requests_that_are_wrong_are_refused() {
        let good = json!({"chart": "disc", "x": "0", "y": "1/2", "width": 1, "height": 1, "pixels_x": 9, "pixels_y": 9});
        assert!(View::new(&good).is_ok());
        for (key, value) in [
            ("chart", json!("x")),
            ("x", json!("1/0")),
            ("y", json!(3)),
            ("width", json!(0)),
            ("height", json!("1")),
        ] {
            let mut bad = good.clone();
            bad[key] = value;
            assert!(View::new(&bad).unwrap_err().is_input(), "{key}");
        }
        assert!(Chart::Strip.point(&ratio(1, 2), &ratio(1, 2)).is_err());
        assert!(Chart::Plane.point(&ratio(1, 2), &integer(0)).is_err());
    }
}
