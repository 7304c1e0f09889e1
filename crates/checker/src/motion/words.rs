//! What certificates about oscillators speak of, in words.

use std::fmt::{self, Write};

use super::text::{Fraction, Harmonic, Impact, System, Units, Wall};

/// A coefficient in words.
pub(crate) trait Spoken {
    /// Whether a minus stands before it.
    fn is_negative(&self) -> bool;

    /// What stands after the sign; `parameter` is the parameter's name.
    fn magnitude(&self, parameter: &str) -> String;
}

impl Spoken for Fraction {
    fn is_negative(&self) -> bool {
        self.p < 0
    }

    /// p/q, or p if q is 1.
    fn magnitude(&self, _: &str) -> String {
        let p = self.p.unsigned_abs();
        if self.q == 1 { p.to_string() } else { format!("{p}/{}", self.q) }
    }
}

/// A list, one item for each impact.
pub(crate) fn list<T, S: fmt::Display>(all: &[T], one: impl Fn(&T) -> S) -> String {
    all.iter().map(|x| one(x).to_string()).collect::<Vec<_>>().join(", ")
}

/// A pattern of impacts, of each where it is and after how many periods the next one comes.
pub(crate) fn pattern(impacts: &[(String, u64)]) -> String {
    let plural = |count: u64| if count == 1 { "" } else { "s" };
    let (count, periods) = (impacts.len() as u64, impacts.iter().map(|impact| impact.1).sum());
    let each: Vec<_> = impacts.iter().map(|(place, next)| format!("{place}, next after {next}")).collect();
    format!(
        "{count} impact{} in {periods} period{}, and in no fewer: {}",
        plural(count),
        plural(periods),
        each.join("; ")
    )
}

/// That of an oscillator.
pub(crate) fn walls(impacts: &[Impact]) -> String {
    let one = |impact: &Impact| (format!("{} wall", impact.side), impact.periods);
    pattern(&impacts.iter().map(one).collect::<Vec<_>>())
}

/// The unit of a parameter, after its values.
pub(crate) fn unit(units: Units) -> String {
    if units.parameter == 0 { String::new() } else { format!(", in units of 10^{}", units.parameter) }
}

/// The unit of lengths if it is not 1, the oscillator, its walls and its digest.
pub(crate) fn system<C: Spoken>(
    system: &System<C>,
    digest: String,
    parameter: &str,
) -> Vec<(&'static str, String)> {
    let Units { lengths, .. } = system.units;
    let units = format!("lengths, speeds, forces and walls are listed in units of 10^{lengths}");
    let units = (lengths != 0).then_some(("units", units));
    let [damping, stiffness] = [(&system.damping, "q'"), (&system.stiffness, "q")]
        .map(|(coefficient, what)| (!coefficient.is_negative(), coefficient, what.to_string()));
    let force = (system.force.is_negative(), &system.force, String::new());
    let terms: Vec<_> = [damping, stiffness, force].into_iter().chain(waves(&system.forcing)).collect();
    let oscillator = [
        ("motion", format!("q'' = {}", sum(&terms, parameter))),
        ("lower wall", wall(&system.lower, parameter)),
        ("upper wall", wall(&system.upper, parameter)),
        ("digest", digest),
    ];
    units.into_iter().chain(oscillator).collect()
}

fn wall<C: Spoken>(wall: &Option<Wall<C>>, parameter: &str) -> String {
    let Some(wall) = wall else { return "none".into() };
    let place = place(&wall.offset, &wall.harmonics, parameter);
    format!("{place}, restitution {}", alone(&wall.restitution, parameter))
}

/// A coefficient with its sign.
pub(crate) fn alone<C: Spoken>(coefficient: &C, parameter: &str) -> String {
    sum(&[(coefficient.is_negative(), coefficient, String::new())], parameter)
}

/// Where a wall or a stop is.
pub(crate) fn place<C: Spoken>(offset: &C, harmonics: &[Harmonic<C>], parameter: &str) -> String {
    let offset = (offset.is_negative(), offset, String::new());
    let terms: Vec<_> = [offset].into_iter().chain(waves(harmonics)).collect();
    sum(&terms, parameter)
}

/// A term of a sum: whether a minus stands before it, its coefficient, and what that is a multiple of.
pub(crate) type Term<'a, C> = (bool, &'a C, String);

fn waves<C: Spoken>(harmonics: &[Harmonic<C>]) -> Vec<Term<'_, C>> {
    let angle = |k: u64| if k == 1 { "t".to_string() } else { format!("{k}t") };
    harmonics
        .iter()
        .flat_map(|h| [(&h.cos, format!("cos {}", angle(h.k))), (&h.sin, format!("sin {}", angle(h.k)))])
        .map(|(coefficient, what)| (coefficient.is_negative(), coefficient, what))
        .collect()
}

/// A sum without its terms that are 0.
pub(crate) fn sum<C: Spoken>(terms: &[Term<C>], parameter: &str) -> String {
    let mut text = String::new();
    for (negative, coefficient, what) in terms {
        let size = coefficient.magnitude(parameter);
        if size == "0" {
            continue;
        }
        let sign = match (text.is_empty(), negative) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let factor = match (what.is_empty(), size.as_str()) {
            (true, size) => size.to_string(),
            (false, "1") => what.clone(),
            (false, size) => format!("{size} {what}"),
        };
        write!(text, "{sign}{factor}").expect("writing to a String cannot fail");
    }
    if text.is_empty() { "0".into() } else { text }
}

impl Spoken for i128 {
    fn is_negative(&self) -> bool {
        *self < 0
    }

    fn magnitude(&self, _: &str) -> String {
        self.unsigned_abs().to_string()
    }
}

/// A polynomial, in parentheses if it has several terms.
pub(crate) fn polynomial<C: Spoken>(list: &[C], parameter: &str) -> String {
    let power = |power: usize| match power {
        0 => String::new(),
        1 => parameter.to_string(),
        power => format!("{parameter}^{power}"),
    };
    let terms: Vec<_> = list.iter().enumerate().map(|(i, x)| (x.is_negative(), x, power(i))).collect();
    let text = sum(&terms, parameter);
    if list.iter().filter(|x| x.magnitude("") != "0").count() > 1 { format!("({text})") } else { text }
}

/// What stands over a polynomial, and that; 0 over any.
pub(crate) fn quotient<C: Spoken>(above: String, denominator: &[C], parameter: &str) -> String {
    let below = polynomial(denominator, parameter);
    match denominator.len() {
        _ if above == "0" => above,
        1 if below == "1" => above,
        1 => format!("{above}/{below}"),
        _ if below.starts_with('(') => format!("{above}/{below}"),
        // Else 1/2 p would be read as (1/2) p.
        _ => format!("{above}/({below})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_read_as_one_writes_them() {
        let terms = |list: &[(i128, i128, &str)]| {
            let fractions: Vec<_> =
                list.iter().map(|&(p, q, what)| (Fraction { p, q }, what.to_string())).collect();
            let terms: Vec<_> = fractions.iter().map(|(x, what)| (x.p < 0, x, what.clone())).collect();
            sum(&terms, "")
        };
        assert_eq!(
            terms(&[(-1, 10, "q'"), (-1, 1, "q"), (0, 1, ""), (24, 25, "cos t")]),
            "-1/10 q' - q + 24/25 cos t"
        );
        assert_eq!(terms(&[(2, 1, ""), (-3, 2, "sin 2t")]), "2 - 3/2 sin 2t");
        assert_eq!(terms(&[(0, 1, "q")]), "0");
    }
}
