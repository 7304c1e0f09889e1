//! Quantities of a scene: a text with units becomes the text with bare numbers, in the scene's units, that
//! says the same. It is what all else reads, so that a scene with units is the scene without them, to the
//! last bit. What is a mass and what a force is checked on the way (`dimension`, `wanted`).

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero, pow};

use super::{
    dimension::{Measured, power_of_pi},
    expression::Expression,
    grammar::{Mark, marked},
};
use crate::{
    error::{Error, Result},
    quantity::{Dimension, Unit, exact_text},
};

/// Metres, seconds and kilograms in the scene's units of length, time and mass.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scale {
    /// Length, time and mass.
    sizes: [BigRational; 3],
    /// Their symbols.
    symbols: [&'static str; 3],
}

impl Scale {
    /// That of a scene with these units of length, time and mass, else of SI.
    pub(super) fn new(units: Option<[&'static str; 3]>) -> Scale {
        let symbols = units.unwrap_or(["m", "s", "kg"]);
        let size = |symbol: &str| Unit::symbol(symbol).map_or_else(BigRational::one, |unit| unit.size);
        Scale { sizes: symbols.map(size), symbols }
    }

    /// The scene's unit of a dimension in SI units.
    fn of(&self, dimension: Dimension) -> BigRational {
        let powers = [dimension.length, dimension.time, dimension.mass];
        self.sizes.iter().zip(powers).fold(BigRational::one(), |product, (size, n)| {
            let power = pow(size.clone(), n.unsigned_abs() as usize);
            if n < 0 { product / power } else { product * power }
        })
    }

    /// A unit in the scene's units, without its power of π.
    fn size(&self, unit: &Unit) -> BigRational {
        &unit.size / self.of(unit.dimension)
    }

    /// The scene's unit of a dimension, by a name of its own where it has one; empty for plain numbers.
    pub(super) fn name(&self, dimension: Dimension) -> String {
        const NAMED: [&str; 13] =
            ["N", "mN", "uN", "kN", "N/m", "N/mm", "N s/m", "N s/mm", "N s", "mN s", "Hz", "J", "mJ"];
        let wanted = self.of(dimension);
        let named = NAMED.into_iter().filter_map(Unit::parse);
        let mut named = named.filter(|unit| unit.dimension == dimension && unit.size == wanted);
        if let Some(unit) = named.next() {
            return unit.text;
        }
        let powers = [dimension.mass, dimension.length, dimension.time];
        let [length, time, mass] = self.symbols;
        let part = |sign: i32| -> Vec<String> {
            let each = [mass, length, time].into_iter().zip(powers).filter(|known| known.1 * sign > 0);
            each.map(
                |(symbol, n)| if n.abs() == 1 { symbol.to_string() } else { format!("{symbol}^{}", n.abs()) },
            )
            .collect()
        };
        let turns = dimension.angle == 1 && dimension.length == 0 && dimension.mass == 0;
        match (part(1).join(" "), part(-1)) {
            (over, under) if under.is_empty() => {
                if turns {
                    "rad".into()
                } else {
                    over
                }
            }
            (over, under) => {
                let none = if turns { "rad" } else { "1" };
                format!("{}/{}", if over.is_empty() { none } else { &over }, under.join("/"))
            }
        }
    }
}

/// A unit in which a reader wrote a parameter; of several in one expression it is the scene's own.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenUnit {
    /// As it was written.
    pub text: String,
    /// How many of the scene's units it is.
    pub size: BigRational,
    /// What it is a unit of.
    pub dimension: Dimension,
    /// The scene's own unit for that.
    pub own: String,
}

impl WrittenUnit {
    /// A value in the scene's units, in this one.
    pub fn of(&self, value: f64) -> f64 {
        value / self.size.to_f64().unwrap_or(f64::NAN)
    }
}

/// A text in bare numbers of the scene, and what it is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bare {
    pub text: String,
    pub measured: Measured,
    /// The unit that it is written in, if it has any.
    pub unit: Option<WrittenUnit>,
    /// Whether it has a unit that is not that of a plain number or an angle.
    pub scaled: bool,
    /// The power of π that is written as a factor of it, if that can be told.
    pub pi: Option<i32>,
    /// Whether π stands in the number before a unit.
    pub pi_inside: bool,
}

/// What is known of the parameters of a scene.
pub(super) type Kinds = BTreeMap<String, Dimension>;

/// A text with units, or with parameters that have them, in bare numbers; none for any other text.
///
/// # Errors
/// For a unit that is not known, and for sums of what does not go together.
pub(super) fn bare(text: &str, names: &[String], (scale, kinds): (&Scale, &Kinds)) -> Result<Option<Bare>> {
    let has_kinds = mentions(text, kinds) && names.iter().any(|name| kinds.contains_key(name));
    if !(has_kinds || may_have_unit(text)) {
        return Ok(None);
    }
    let found = match marked(text, names) {
        Ok(found) => found,
        // It is read again, without units, and told then.
        Err((_, false)) => return Ok(None),
        Err((error, true)) => return Err(error),
    };
    let variable = |place: usize| match (names.get(place), place.checked_sub(names.len())) {
        (Some(name), _) => kinds.get(name).map_or(Measured::Any, |dimension| Measured::Known(*dimension)),
        (None, Some(mark)) => {
            found.marks.get(mark).map_or(Measured::Any, |mark| Measured::Known(mark.unit.dimension))
        }
        (None, None) => Measured::Any,
    };
    let measured = Measured::of(&found.root, &variable)?;
    let unit = match measured {
        Measured::Known(dimension) => Some({
            let own = scale.name(dimension);
            let (text, size) = match &found.marks[..] {
                [Mark { unit, .. }] if unit.pi == 0 && unit.dimension == dimension => {
                    (unit.text.clone(), scale.size(unit))
                }
                _ => (own.clone(), BigRational::one()),
            };
            WrittenUnit { text, size, dimension, own }
        }),
        _ => None,
    };
    let is_scaled = |mark: &Mark| !mark.unit.dimension.is_like(Dimension::ONE);
    Ok(Some(Bare {
        text: rewritten(text, &found.marks, scale),
        measured,
        unit,
        scaled: found.marks.iter().any(is_scaled),
        pi: power_of_pi(&found.root),
        pi_inside: found.marks.iter().any(|mark| text[mark.places[0]..mark.places[1]].contains("pi")),
    }))
}

/// Whether a text has units that are known.
pub(super) fn has_units(text: &str, names: &[String]) -> bool {
    may_have_unit(text) && marked(text, names).is_ok_and(|found| !found.marks.is_empty())
}

/// Whether a letter, % or ° stands behind a number or a parenthesis.
fn may_have_unit(text: &str) -> bool {
    let all: Vec<char> = text.chars().collect();
    let follows = |i: usize| {
        let before = all[..i].iter().rposition(|c| !c.is_whitespace());
        let Some(before) = before else { return false };
        let ends = match all[before] {
            ')' | '.' => true,
            // The digits of a name are no number.
            c if c.is_ascii_digit() => {
                let first = all[..=before].iter().rposition(|c| !c.is_ascii_digit() && *c != '.');
                first.is_none_or(|first| !all[first].is_alphabetic() && all[first] != '_') || before + 1 < i
            }
            'i' => before > 0 && all[before - 1] == 'p' && before + 1 < i,
            _ => false,
        };
        let exponent = matches!(all[i], 'e' | 'E')
            && all.get(i + 1).is_some_and(|c| {
                c.is_ascii_digit()
                    || (matches!(c, '+' | '-') && all.get(i + 2).is_some_and(char::is_ascii_digit))
            });
        ends && !exponent
    };
    (1..all.len()).any(|i| (all[i].is_alphabetic() || matches!(all[i], '%' | '°')) && follows(i))
}

/// Whether a parameter with a dimension may stand in a text.
fn mentions(text: &str, kinds: &Kinds) -> bool {
    kinds.keys().any(|name| text.contains(name.as_str()))
}

/// A path in a scene without its places in lists.
pub(super) fn without_places(path: &str) -> String {
    let (mut all, mut inside) = (String::new(), false);
    for c in path.chars() {
        match c {
            '[' => inside = true,
            ']' => inside = false,
            c if !inside => all.push(c),
            _ => {}
        }
    }
    all
}

/// Whether a key counts cycles, so that angles per time are turned into these.
pub(super) fn counts_cycles(path: &str) -> bool {
    matches!(&without_places(path)[..], "system.frequency" | "system.modes.frequencies")
}

/// The text with each unit multiplied out.
fn rewritten(text: &str, marks: &[Mark], scale: &Scale) -> String {
    let mut edits: Vec<(usize, usize, String)> = Vec::new();
    for Mark { places: [start, end, last], number, unit } in marks {
        let (size, pi) = (scale.size(unit), power_text(unit.pi));
        let plain = size.is_one() && pi.is_empty();
        match number {
            _ if plain => edits.push((*end, *last, String::new())),
            Some(number) if pi.is_empty() || number.is_zero() => {
                edits.push((*start, *last, exact_text(&(number * size))));
            }
            _ => {
                edits.push((*start, *start, "(".to_string()));
                edits.push((*end, *last, format!("*{}{pi})", exact_text(&size))));
            }
        }
    }
    edits.sort_by_key(|edit| (edit.0, edit.1));
    let (mut all, mut at) = (String::new(), 0);
    for (from, to, with) in edits {
        all += &text[at..from];
        all += &with;
        at = to;
    }
    all + &text[at..]
}

fn power_text(pi: i32) -> String {
    match pi {
        0 => String::new(),
        1 => "*pi".to_string(),
        n => format!("*pi^{n}"),
    }
}

impl Bare {
    /// The exact value of a quantity without parameters.
    ///
    /// # Errors
    /// For one that is not rational.
    pub(super) fn value(&self) -> Result<BigRational> {
        Expression::parse(&self.text, &[])?.evaluate(&[], &())
    }

    /// Turns what is given per time as an angle into cycles, for a key that counts these.
    ///
    /// # Errors
    /// Where it cannot be told whether π in it has done so already.
    pub(super) fn in_cycles(&mut self) -> Result<()> {
        match (self.measured, self.pi) {
            (Measured::Known(dimension), Some(0 | 1)) if dimension.angle == 1 => {
                self.text = format!("({})/(2*pi)", self.text);
            }
            (Measured::Known(dimension), pi)
                if dimension.angle != 0 && (pi != Some(-1) || self.pi_inside) =>
            {
                let why = "mixes angles and cycles: write it in Hz, as w/(2*pi) for an angular frequency w";
                return Err(Error::input(why));
            }
            _ => {}
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text_of(text: &str, names: &[&str]) -> String {
        let names: Vec<String> = names.iter().map(|name| (*name).to_string()).collect();
        let found = bare(text, &names, (&Scale::new(None), &Kinds::new()));
        found.map_or_else(|error| error.to_string(), |bare| bare.map_or("none".into(), |bare| bare.text))
    }

    #[test]
    fn units_are_multiplied_out() {
        for (text, expected) in [
            ("2 kg", "2"),
            ("10 mm", "0.01"),
            ("0.8 N/mm", "800"),
            ("2 %", "0.02"),
            ("2*pi*3 Hz", "2*pi*3"),
            ("2*pi/(3 Hz)", "2*pi/(3)"),
            ("90 deg", "(90*(1/180)*pi)"),
            ("(a + 1 mm) cm", "((a + 0.001)*0.01)"),
            ("1/(2 rpm)", "1/((1/30))"),
            ("-5 um^2", "-0.000000000005"),
            ("a*5 mm/a", "a*0.005/a"),
            ("2e3 mm", "2"),
            ("sin(30 deg)*a", "sin((30*(1/180)*pi))*a"),
            ("2*e1 + b2*x", "none"),
            ("1e-3*a", "none"),
            ("2 a", "a at character 3 is a parameter: write 2*a"),
        ] {
            assert_eq!(text_of(text, &["a"]), expected, "{text}");
        }
        assert!(text_of("1/2 mm", &[]).contains("is read in two ways"));
        assert!(
            text_of("8 hz", &[]).contains("there is no unit \"hz\", at character 3; the nearest is \"Hz\"")
        );
        assert!(text_of("2 m", &["m"]).contains("is a parameter: write 2*m, or rename"));
    }

    #[test]
    fn a_scale_names_its_units() {
        let name = |length, time, mass| Scale::new(None).name(Dimension::of(length, time, mass));
        assert_eq!([name(1, -2, 1), name(1, -1, 0), name(0, 0, 0)], ["N", "m/s", ""]);
        assert_eq!([name(0, -1, 0), name(2, 0, 1)], ["Hz", "kg m^2"]);
        let turning = |time| Scale::new(None).name(Dimension::ANGLE.times(Dimension::of(0, time, 0)));
        assert_eq!([turning(0), turning(-1), turning(-2)], ["rad", "rad/s", "rad/s^2"]);
    }
}
