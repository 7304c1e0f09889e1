//! Text with mathematics in it: which letters are italic, raised or lowered, and how wide it is.

use crate::printable::is_printable;

/// Where a run of letters stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// On the base line.
    Base,
    /// Below it, small.
    Sub,
    /// Above it, small.
    Super,
}

impl Level {
    /// The size of its letters, in those of the base line.
    pub fn scale(self) -> f64 {
        if self == Level::Base { 1.0 } else { 0.72 }
    }

    /// How far below the base line it stands, in sizes of type.
    pub fn drop(self) -> f64 {
        match self {
            Level::Base => 0.0,
            Level::Sub => 0.22,
            Level::Super => -0.36,
        }
    }
}

/// Letters of one kind.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LetterRun {
    pub text: String,
    pub level: Level,
    pub italic: bool,
}

/// A line of text.
///
/// Made from a `str`, the letters of Unicode for indices and exponents (a₁, λⁿ), `_{…}` and `^{…}` are
/// lowered and raised, and a letter that stands alone (q, a₁, eµ) is a symbol, in italics. [`Words::plain`]
/// changes nothing: for names that come from a reader.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Words(pub Vec<LetterRun>);

impl From<&str> for Words {
    fn from(text: &str) -> Words {
        Words::maths(text)
    }
}

impl From<String> for Words {
    fn from(text: String) -> Words {
        Words::maths(&text)
    }
}

/// A letter of Unicode that is lowered or raised, as the one that it is.
fn shifted(c: char) -> Option<(char, Level)> {
    const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉₊₋ₙₖᵢⱼₘ";
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿᵏⁱʲᵐ";
    const PLAIN: &str = "0123456789+−nkijm";
    let find = |list: &str| list.chars().position(|known| known == c);
    let at = |index: usize| PLAIN.chars().nth(index).unwrap_or(c);
    let lowered = find(LOWERED).map(|index| (at(index), Level::Sub));
    lowered.or_else(|| find(RAISED).map(|index| (at(index), Level::Super)))
}

fn is_greek(c: char) -> bool {
    matches!(c, 'α'..='ω' | 'µ')
}

impl Words {
    /// Text as it is, but for what is no letter.
    pub fn plain(text: &str) -> Words {
        let shown = |c| if is_printable(c) { c } else { '\u{fffd}' };
        Words(vec![LetterRun { text: text.chars().map(shown).collect(), level: Level::Base, italic: false }])
    }

    fn maths(text: &str) -> Words {
        // Each letter with its level: the letters of braces are all lowered or raised.
        let mut letters: Vec<(char, Level)> = Vec::new();
        let mut rest = text.chars().peekable();
        let mut within = None;
        while let Some(c) = rest.next() {
            let braced = |level, rest: &mut std::iter::Peekable<_>| {
                (rest.peek() == Some(&'{')).then(|| {
                    rest.next();
                    level
                })
            };
            match c {
                '_' | '^' if within.is_none() => {
                    let level = if c == '_' { Level::Sub } else { Level::Super };
                    within = braced(level, &mut rest);
                    if within.is_none() {
                        letters.push((c, Level::Base));
                    }
                }
                '}' if within.is_some() => within = None,
                _ => match within {
                    Some(level) => letters.push((c, level)),
                    None => letters.push(shifted(c).unwrap_or((c, Level::Base))),
                },
            }
        }
        let latin = |index: Option<usize>, level: Level| {
            let other = index.and_then(|index| letters.get(index));
            other.is_some_and(|&(c, of)| of == level && c.is_alphabetic() && !is_greek(c))
        };
        let mut runs: Vec<LetterRun> = Vec::new();
        for (index, &(c, level)) in letters.iter().enumerate() {
            let alone = !latin(index.checked_sub(1), level) && !latin(Some(index + 1), level);
            let italic = is_greek(c) || (c.is_ascii_alphabetic() && alone);
            match runs.last_mut() {
                Some(run) if run.level == level && run.italic == italic => run.text.push(c),
                _ => runs.push(LetterRun { text: c.into(), level, italic }),
            }
        }
        Words(runs)
    }

    /// The width in points at a size of type, about: in DejaVu Sans Condensed, which other faces are close
    /// to.
    pub fn width(&self, size: f64) -> f64 {
        let run = |run: &LetterRun| run.level.scale() * run.text.chars().map(advance).sum::<f64>();
        size * self.0.iter().map(run).sum::<f64>()
    }
}

/// The width of a letter, in sizes of type.
fn advance(c: char) -> f64 {
    // From ' ' to '~', in thousandths.
    const ASCII: [u16; 95] = [
        286, 360, 414, 754, 572, 855, 702, 247, 351, 351, 450, 754, 286, 325, 286, 303, 572, 572, 572, 572,
        572, 572, 572, 572, 572, 572, 303, 303, 754, 754, 754, 478, 900, 615, 617, 628, 693, 568, 518, 697,
        677, 265, 265, 590, 501, 776, 673, 708, 542, 708, 625, 571, 549, 659, 615, 890, 616, 549, 616, 351,
        303, 351, 754, 450, 450, 551, 571, 495, 571, 554, 316, 571, 570, 250, 250, 521, 250, 876, 570, 550,
        571, 571, 370, 469, 353, 570, 532, 736, 532, 532, 472, 572, 303, 572, 754,
    ];
    let known = (c as usize).checked_sub(32).and_then(|index| ASCII.get(index));
    match c {
        '′' => 0.204,
        '−' | '±' | '∓' | '≤' | '≥' | '≠' | '≈' | '→' | '∞' => 0.754,
        '·' => 0.286,
        _ => known.map_or(0.57, |&width| f64::from(width) / 1000.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> String {
        let run = |run: &LetterRun| {
            let text = if run.italic { format!("/{}/", run.text) } else { run.text.clone() };
            match run.level {
                Level::Base => text,
                Level::Sub => format!("_{text}"),
                Level::Super => format!("^{text}"),
            }
        };
        Words::from(text).0.iter().map(run).collect()
    }

    #[test]
    fn symbols_are_italic_and_words_are_not() {
        assert_eq!(shown("b_{n,k} = 0, 3 ≤ n"), "/b/_/n/_,_/k/ = 0, 3 ≤ /n/");
        assert_eq!(shown("u − Q₁′"), "/u/ − /Q/_1′");
        assert_eq!(shown("q − (Q₁ − offset)"), "/q/ − (/Q/_1 − offset)");
        assert_eq!(shown("eµ, γ: (−,+)"), "/eµ/, /γ/: (−,+)");
        assert_eq!(shown("λⁿ r³ 10⁻¹²"), "/λ//^/n/ /r/^3 10^−12".replace("//^", "/^"));
        assert_eq!(shown("no impact"), "no impact");
        assert_eq!(shown("drive_2"), "drive_2");
    }

    #[test]
    fn names_of_readers_stay_as_they_are() {
        assert_eq!(Words::plain("a_{1}").0.len(), 1);
        assert!(Words::plain("iii").width(10.0) < Words::plain("mmm").width(10.0));
    }
}
