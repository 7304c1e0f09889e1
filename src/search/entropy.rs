//! Finds the certificate of the two suprema of the entropy, eµ > 0: beginnings of words that bound all that
//! begin so, each with a vector.
//!
//! Untrusted. The words and edges are those of `word`, the radii are found in floats; the checker knows
//! neither.

use num_integer::Integer;

use crate::{
    certificate::{FORMAT, entropy},
    error::{Error, Result},
    monitor::Monitor,
    word::{Edge, Extent, Letter, Word},
};

/// The certificate: the roots within 10⁻⁵, and the first beginnings on each branch that bound their words.
///
/// Cost: milliseconds.
///
/// # Errors
/// The monitor's interruption; an input error if no proof is found, which would be a fault of this program.
pub fn entropy_certificate(monitor: &dyn Monitor) -> Result<String> {
    let mut text = format!("{FORMAT}\nkind {}\nstatement {}\n", entropy::KIND, entropy::STATEMENT);
    for positive in [false, true] {
        let equation = |z: f64| match positive {
            false => z + z * z + z.powi(3) - 1.0,
            true => (1.0 + z.powi(4)) * (z.powi(3) / (1.0 - z.powi(4)) + z * z / (1.0 - z.powi(3))) - 1.0,
        };
        let low = (33_334..75_000u64).rfind(|p| equation(*p as f64 / 1e5) < 0.0).unwrap_or(33_334);
        let case = Case { positive, z: (low + 1) as f64 / 1e5 };
        let fraction = |p: u64| format!("{}/{}", p / p.gcd(&100_000), 100_000 / p.gcd(&100_000));
        text += &format!("case + {}\n", if positive { "+" } else { "-" });
        text += &format!("root {} {}\n", fraction(low), fraction(low + 1));
        for first in 2.. {
            monitor.advance(0)?;
            text += &format!("first {first}\n");
            let begun = text.len();
            case.walk(first, &mut Vec::new(), &mut text)?;
            if text[begun..].starts_with("bound - ") {
                break;
            }
        }
    }
    Ok(text)
}

/// One sign of γ, and a number just above the root.
struct Case {
    positive: bool,
    z: f64,
}

impl Case {
    fn walk(&self, first: u64, word: &mut Vec<Letter>, text: &mut String) -> Result<()> {
        let infinite = |place: usize| match (self.positive, place) {
            (false, _) | (true, 1) => Letter::D,
            _ => Letter::U,
        };
        let on_path = first == 2
            && (!self.positive || word.len() >= 2)
            && word.iter().enumerate().all(|(place, letter)| *letter == infinite(place));
        if on_path && word.len() >= 6 {
            return Ok(());
        }
        let name: String = match word.is_empty() {
            true => "-".into(),
            false => word.iter().map(Letter::to_string).collect(),
        };
        let line = |what: &str, v: &[u64]| {
            let entries: Vec<String> = v.iter().map(u64::to_string).collect();
            format!("{what} {name} {}\n", entries.join(" "))
        };
        if let Some(v) = self.vector(first, word, true) {
            *text += &line("bound", &v);
            return Ok(());
        }
        let lost = || Error::input(format!("no bound of the words {name} after 1 and {first} was found"));
        if word.len() > 12 {
            return Err(lost());
        }
        if !on_path {
            let v = self.vector(first, word, false).ok_or_else(lost)?;
            *text += &line("ends", &v);
        }
        let run = word.iter().all(|letter| *letter == Letter::U).then(|| first + 1 + word.len() as u64);
        for letter in [Letter::U, Letter::D] {
            let possible = match letter {
                Letter::U => run != Some(2 * first),
                _ => run.is_none_or(|k| k > 2 * first - 2),
            };
            if possible {
                word.push(letter);
                self.walk(first, word, text)?;
                word.pop();
            }
        }
        Ok(())
    }

    /// Whole numbers v with M v < v, of all words that begin so (`begins`) or of the one that ends.
    fn vector(&self, first: u64, letters: &[Letter], begins: bool) -> Option<Vec<u64>> {
        let word = Word::of_letters(first, letters);
        let vertices = word.vertices();
        let (low, high) = (last(&word, Letter::D), last(&word, Letter::U));
        let weight = |n: u64| self.z.powi(n as i32);
        let mut weights: Vec<f64> = vertices.iter().map(|vertex| weight(vertex.period)).collect();
        if begins {
            let (a, b) = (vertices[low].period, vertices[high].period);
            weights.push(weight(a + b) / (1.0 - weight(a.min(b))));
        }
        let many = vertices.len();
        let edge = |i: usize, j: usize| {
            let pair = (i.min(j), i.max(j)) == (low.min(high), low.max(high));
            i >= many || j >= many || begins && pair || word.edge(i, j, self.positive) == Edge::Yes
        };
        let matrix: Vec<Vec<f64>> = (0..weights.len())
            .map(|i| (0..weights.len()).map(|j| if edge(i, j) { weights[j] } else { 0.0 }).collect())
            .collect();
        // v = 1 + M v has v > M v; ten times v is rounded by too little to lose that.
        let mut v = vec![1.0; weights.len()];
        for _ in 0..200_000 {
            let next: Vec<f64> =
                matrix.iter().map(|row| 1.0 + row.iter().zip(&v).map(|(m, x)| m * x).sum::<f64>()).collect();
            let step = next.iter().zip(&v).map(|(a, b)| a - b).fold(0.0, f64::max);
            v = next;
            if v.iter().any(|x| *x > 90_000.0) {
                return None;
            }
            if step < 1e-9 {
                return Some(v.iter().map(|x| (10.0 * x).round() as u64).collect());
            }
        }
        None
    }
}

/// The place of the last vertex with this letter.
fn last(word: &Word, letter: Letter) -> usize {
    debug_assert!(matches!(word.extent(), Extent::Complete { .. }));
    word.vertices().iter().rposition(|vertex| vertex.letter == letter).expect("1 is D and K is U")
}
