//! Units and what they are units of: `mm`, `N/mm`, `kg m/s^2`, `rad/s`, `%`, each exact in metres, seconds,
//! kilograms and radians. What a command or a scene reads behind a number is read here, and nowhere else.
//!
//! ```text
//! unit  = power { ( "/" | "*" | "·" | spaces ) power }
//! power = symbol [ "^" [ "-" ] digits | "²" | "³" ]
//! ```
//!
//! A divisor is the one power behind its "/": N/m/s is N/(m s). A degree is π/180 radians, so a unit has a
//! power of π beside its rational size.

use std::fmt;

use num_rational::BigRational;
use num_traits::{One, Signed, pow};

/// What a quantity is, as powers of length, time, mass and angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dimension {
    /// The power of length.
    pub length: i32,
    /// The power of time.
    pub time: i32,
    /// The power of mass.
    pub mass: i32,
    /// The power of angle, which is no dimension but tells rad/s from Hz.
    pub angle: i32,
}

/// Names of dimensions, which are told apart by length, time and mass.
const NAMES: [(&str, [i32; 3]); 17] = [
    ("a plain number", [0, 0, 0]),
    ("a length", [1, 0, 0]),
    ("a time", [0, 1, 0]),
    ("a mass", [0, 0, 1]),
    ("a frequency", [0, -1, 0]),
    ("a speed", [1, -1, 0]),
    ("an acceleration", [1, -2, 0]),
    ("a force", [1, -2, 1]),
    ("a stiffness", [0, -2, 1]),
    ("a damping", [0, -1, 1]),
    ("an impulse", [1, -1, 1]),
    ("an energy or a torque", [2, -2, 1]),
    ("a power", [2, -3, 1]),
    ("a moment of inertia", [2, 0, 1]),
    ("a damping of a rotation", [2, -1, 1]),
    ("a stiffness per length squared", [-2, -2, 1]),
    ("a volume", [3, 0, 0]),
];

impl Dimension {
    /// That of plain numbers.
    pub const ONE: Dimension = Dimension::of(0, 0, 0);
    /// That of angles.
    pub const ANGLE: Dimension = Dimension { angle: 1, ..Dimension::ONE };

    /// The dimension with these powers of length, time and mass.
    pub const fn of(length: i32, time: i32, mass: i32) -> Dimension {
        Dimension { length, time, mass, angle: 0 }
    }

    /// That of a product.
    #[must_use]
    pub fn times(self, other: Dimension) -> Dimension {
        let sum = |x: i32, y: i32| x.saturating_add(y);
        Dimension {
            length: sum(self.length, other.length),
            time: sum(self.time, other.time),
            mass: sum(self.mass, other.mass),
            angle: sum(self.angle, other.angle),
        }
    }

    /// That of a power.
    #[must_use]
    pub fn power(self, n: i32) -> Dimension {
        let by = |x: i32| x.saturating_mul(n);
        Dimension { length: by(self.length), time: by(self.time), mass: by(self.mass), angle: by(self.angle) }
    }

    /// Whether the two are of one kind, whatever angles are in them.
    pub fn is_like(self, other: Dimension) -> bool {
        Dimension { angle: 0, ..self } == Dimension { angle: 0, ..other }
    }
}

/// `a mass`; what has no name, as `length^2 time^-1`.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let powers = [self.length, self.time, self.mass];
        if self.angle != 0 && self.is_like(Dimension::ONE) {
            return write!(f, "an angle");
        }
        if self.angle == 1 && powers == [0, -1, 0] {
            return write!(f, "an angular frequency");
        }
        if let Some((name, _)) = NAMES.iter().find(|known| known.1 == powers) {
            return write!(f, "{name}");
        }
        let each = ["length", "time", "mass"].iter().zip(powers).filter(|known| known.1 != 0);
        let each = each.map(|(name, n)| if n == 1 { (*name).to_string() } else { format!("{name}^{n}") });
        write!(f, "{}", each.collect::<Vec<_>>().join(" "))
    }
}

/// A unit: size · π^pi in metres, seconds, kilograms and radians.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unit {
    /// As it is written.
    pub text: String,
    /// The rational factor.
    pub size: BigRational,
    /// The power of π.
    pub pi: i32,
    /// What it is a unit of.
    pub dimension: Dimension,
}

/// A symbol: how large as (numerator, denominator), a power of π, length, time, mass, angle.
type Symbol = (&'static str, (u64, u64), i32, [i32; 4]);

const L: [i32; 4] = [1, 0, 0, 0];
const T: [i32; 4] = [0, 1, 0, 0];
const M: [i32; 4] = [0, 0, 1, 0];
const ANGLE: [i32; 4] = [0, 0, 0, 1];
const PER_TIME: [i32; 4] = [0, -1, 0, 0];
const FORCE: [i32; 4] = [1, -2, 1, 0];
const IMPULSE: [i32; 4] = [1, -1, 1, 0];
const ENERGY: [i32; 4] = [2, -2, 1, 0];
const POWER: [i32; 4] = [2, -3, 1, 0];

const SYMBOLS: [Symbol; 45] = [
    ("m", (1, 1), 0, L),
    ("km", (1000, 1), 0, L),
    ("cm", (1, 100), 0, L),
    ("mm", (1, 1000), 0, L),
    ("um", (1, 1_000_000), 0, L),
    ("nm", (1, 1_000_000_000), 0, L),
    ("in", (127, 5000), 0, L),
    ("s", (1, 1), 0, T),
    ("ms", (1, 1000), 0, T),
    ("us", (1, 1_000_000), 0, T),
    ("min", (60, 1), 0, T),
    ("kg", (1, 1), 0, M),
    ("g", (1, 1000), 0, M),
    ("mg", (1, 1_000_000), 0, M),
    ("t", (1000, 1), 0, M),
    ("N", (1, 1), 0, FORCE),
    ("mN", (1, 1000), 0, FORCE),
    ("uN", (1, 1_000_000), 0, FORCE),
    ("kN", (1000, 1), 0, FORCE),
    ("MN", (1_000_000, 1), 0, FORCE),
    ("Hz", (1, 1), 0, PER_TIME),
    ("mHz", (1, 1000), 0, PER_TIME),
    ("kHz", (1000, 1), 0, PER_TIME),
    ("MHz", (1_000_000, 1), 0, PER_TIME),
    ("rpm", (1, 60), 0, PER_TIME),
    ("rad", (1, 1), 0, ANGLE),
    ("mrad", (1, 1000), 0, ANGLE),
    ("deg", (1, 180), 1, ANGLE),
    ("°", (1, 180), 1, ANGLE),
    ("%", (1, 100), 0, [0; 4]),
    ("Ns", (1, 1), 0, IMPULSE),
    ("mNs", (1, 1000), 0, IMPULSE),
    ("kNs", (1000, 1), 0, IMPULSE),
    ("Nm", (1, 1), 0, ENERGY),
    ("mNm", (1, 1000), 0, ENERGY),
    ("Nmm", (1, 1000), 0, ENERGY),
    ("kNm", (1000, 1), 0, ENERGY),
    ("J", (1, 1), 0, ENERGY),
    ("mJ", (1, 1000), 0, ENERGY),
    ("uJ", (1, 1_000_000), 0, ENERGY),
    ("kJ", (1000, 1), 0, ENERGY),
    ("W", (1, 1), 0, POWER),
    ("mW", (1, 1000), 0, POWER),
    ("kW", (1000, 1), 0, POWER),
    ("MW", (1_000_000, 1), 0, POWER),
];

/// The symbols of all units, which may be multiplied, divided and raised to whole powers.
pub fn symbols() -> impl Iterator<Item = &'static str> + Clone {
    SYMBOLS.iter().map(|known| known.0)
}

/// The highest power of a unit.
const MOST: u32 = 12;

/// What a symbol stands behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Joint {
    /// A number: it is the first.
    Number,
    /// A "/" or "·" without spaces, which nothing but a unit has.
    Tight,
    /// Anything else.
    Loose,
}

/// The letters that a symbol may be made of, at the beginning of a text: both signs for micro are one.
fn word(text: &str) -> &str {
    match text.chars().next() {
        Some(mark @ ('%' | '°')) => &text[..mark.len_utf8()],
        _ => &text[..text.find(|c: char| !c.is_alphabetic()).unwrap_or(text.len())],
    }
}

impl Unit {
    /// The plain number 1.
    pub fn one() -> Unit {
        Unit { text: String::new(), size: BigRational::one(), pi: 0, dimension: Dimension::ONE }
    }

    /// The unit of one symbol; µ in both of its characters is u.
    pub fn symbol(text: &str) -> Option<Unit> {
        let plain = text.replace(['\u{b5}', '\u{3bc}'], "u");
        let known = SYMBOLS.iter().find(|known| known.0 == plain)?;
        let (_, (over, under), pi, [length, time, mass, angle]) = *known;
        Some(Unit {
            text: text.to_string(),
            size: BigRational::new(over.into(), under.into()),
            pi,
            dimension: Dimension { length, time, mass, angle },
        })
    }

    /// A unit that is the whole text, spaces around it left out.
    ///
    /// ```
    /// use grazing_base::quantity::Unit;
    /// let unit = Unit::parse("N s/mm").unwrap();
    /// assert_eq!((unit.size.to_string(), unit.dimension.to_string()), ("1000".into(), "a damping".into()));
    /// assert!(Unit::parse("N/").is_none() && Unit::parse("hz").is_none());
    /// ```
    pub fn parse(text: &str) -> Option<Unit> {
        let text = text.trim();
        let (unit, read) = Unit::begin(text, &|_, _| false)?;
        (read == text.len()).then_some(unit)
    }

    /// The longest unit with which a text begins, and how many bytes it takes. A symbol that is `taken` for
    /// something else ends it.
    pub fn begin(text: &str, taken: &dyn Fn(&str, Joint) -> bool) -> Option<(Unit, usize)> {
        let (mut unit, mut at) = power(text, Joint::Number, taken)?;
        loop {
            let rest = &text[at..];
            let inner = rest.trim_start();
            let mut spaces = inner.len() < rest.len();
            let sign = inner.chars().next().filter(|c| matches!(c, '/' | '*' | '·' | '⋅'));
            let next = inner[sign.map_or(0, char::len_utf8)..].trim_start();
            spaces |= sign.is_some_and(|sign| inner.len() - sign.len_utf8() > next.len());
            let joint = match sign {
                Some('*') => Joint::Loose,
                Some(_) if !spaces => Joint::Tight,
                None if !spaces => break,
                _ => Joint::Loose,
            };
            let Some((factor, read)) = power(next, joint, taken) else { break };
            let way = if sign == Some('/') { -1 } else { 1 };
            unit = unit.times(&factor.raised(way));
            at = text.len() - next.len() + read;
        }
        unit.text = text[..at].to_string();
        Some((unit, at))
    }

    /// A product, without a text of its own.
    #[must_use]
    pub fn times(&self, other: &Unit) -> Unit {
        Unit {
            text: String::new(),
            size: &self.size * &other.size,
            pi: self.pi.saturating_add(other.pi),
            dimension: self.dimension.times(other.dimension),
        }
    }

    /// A power, without a text of its own.
    #[must_use]
    pub fn raised(&self, n: i32) -> Unit {
        let size = pow(self.size.clone(), n.unsigned_abs() as usize);
        Unit {
            text: String::new(),
            size: if n.is_negative() { size.recip() } else { size },
            pi: self.pi.saturating_mul(n),
            dimension: self.dimension.power(n),
        }
    }
}

/// A symbol with its exponent at the beginning of a text, and the bytes read.
fn power(text: &str, joint: Joint, taken: &dyn Fn(&str, Joint) -> bool) -> Option<(Unit, usize)> {
    let symbol = word(text);
    let unit = Unit::symbol(symbol).filter(|_| !taken(symbol, joint))?;
    let rest = &text[symbol.len()..];
    if let Some(n) =
        [("²", 2), ("³", 3)].into_iter().find_map(|(sign, n)| rest.starts_with(sign).then_some(n))
    {
        return Some((unit.raised(n), symbol.len() + '²'.len_utf8()));
    }
    let Some(exponent) = rest.strip_prefix('^') else {
        // A name goes on with digits: m2 is no unit.
        return (!rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
            .then_some((unit, symbol.len()));
    };
    let bare = exponent.strip_prefix('-');
    let digits = bare.unwrap_or(exponent);
    let count = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    let n = digits[..count].parse::<u32>().ok().filter(|n| *n <= MOST)? as i32;
    let read = text.len() - digits.len() + count;
    Some((unit.raised(if bare.is_some() { -n } else { n }), read))
}

/// An exact number as text: in decimals where it has few, else as a fraction in parentheses.
pub fn exact_text(value: &BigRational) -> String {
    const DIGITS: usize = 18;
    let (mut scaled, mut places) = (value.clone(), 0);
    while !scaled.is_integer() && places <= DIGITS {
        scaled *= BigRational::from_integer(10.into());
        places += 1;
    }
    let digits = scaled.numer().abs().to_string();
    let sign = if value.is_negative() { "-" } else { "" };
    if !scaled.is_integer() || digits.len() > 2 * DIGITS {
        return format!("({value})");
    }
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, part) = digits.split_at(digits.len() - places);
    if part.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_their_sizes_and_dimensions() {
        for (text, size, dimension) in [
            ("mm", "1/1000", "a length"),
            ("\u{b5}m", "1/1000000", "a length"),
            ("\u{3bc}N", "1/1000000", "a force"),
            ("in", "127/5000", "a length"),
            ("N/mm", "1000", "a stiffness"),
            ("MN/m", "1000000", "a stiffness"),
            ("N/um", "1000000", "a stiffness"),
            ("N s/m", "1", "a damping"),
            ("N·s/m", "1", "a damping"),
            ("N*s/mm", "1000", "a damping"),
            ("Ns/m", "1", "a damping"),
            ("kg/s", "1", "a damping"),
            ("kg m/s^2", "1", "a force"),
            ("t mm/s²", "1", "a force"),
            ("N/m^3", "1", "a stiffness per length squared"),
            ("m s^-1", "1", "a speed"),
            ("rpm", "1/60", "a frequency"),
            ("rad/s", "1", "an angular frequency"),
            ("deg", "1/180", "an angle"),
            ("%", "1/100", "a plain number"),
            ("mm^2/s^3", "1/1000000", "length^2 time^-3"),
        ] {
            let unit = Unit::parse(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!((unit.size.to_string(), unit.dimension.to_string()), (size.into(), dimension.into()));
        }
        for text in ["", "N/", "hz", "m2", "m^", "m^99", "/s", "N//m", "kilo", "m m2", "N-m", "1"] {
            assert_eq!(Unit::parse(text), None, "{text}");
        }
    }

    #[test]
    fn what_is_taken_ends_a_unit() {
        let taken = |word: &str, joint: Joint| word == "m" && joint != Joint::Tight;
        let read = |text: &str| Unit::begin(text, &taken).map(|(unit, read)| (unit.text, read));
        assert_eq!(read("N/m + 1"), Some(("N/m".to_string(), 3)));
        assert_eq!(read("N*m"), Some(("N".to_string(), 1)));
        assert_eq!(read("N / m"), Some(("N".to_string(), 1)));
        assert_eq!(read("m"), None);
        assert_eq!(read("N s/w"), Some(("N s".to_string(), 3)));
    }

    #[test]
    fn exact_texts_are_decimals_where_they_end() {
        for (over, under, text) in
            [(1, 8, "0.125"), (-3, 1000, "-0.003"), (800, 1, "800"), (1, 3, "(1/3)"), (12345, 100, "123.45")]
        {
            assert_eq!(exact_text(&BigRational::new(over.into(), under.into())), text);
        }
    }
}
