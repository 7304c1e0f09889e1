//! The lines that both kinds have: the set, the precision, and which period may follow which.

use std::cmp::Ordering;

use super::{
    super::{Proved, lines::Lines},
    Rejection,
    number::Rational,
    set::{Place, Signs},
};
use crate::rejection::ensure;

/// The products of two 32-bit digits that a check may take, about.
const WORK: u64 = 4_000_000_000;

/// The set with its signs, and the work that is left.
pub(super) struct Desk<'a, 'b> {
    pub lines: &'a mut Lines<'b>,
    pub signs: Signs,
    /// The set in words.
    pub shown: (&'static str, String),
    left: u64,
}

impl<'a, 'b> Desk<'a, 'b> {
    /// Reads the lines `at` and `bits`.
    pub fn read(lines: &'a mut Lines<'b>) -> Result<Self, Rejection> {
        let line = lines.expect("a line \"at …\"")?;
        let place = place(&line).map_err(|reason| lines.malformed(reason))?;
        let bits = value(lines, "bits", 4096)?;
        lines.form(bits >= 64 && bits.is_multiple_of(32), "the bits are a multiple of 32 from 64 to 4096")?;
        let signs = Signs::new(place, bits as usize).map_err(|reason| lines.false_claim(reason))?;
        let shown = shown(signs.place(), &line);
        Ok(Desk { lines, signs, shown, left: WORK })
    }

    /// Reads the words, each by `word`, to the end of the file: all that is proved.
    pub fn words_to_end(
        mut self,
        word: impl Fn(&mut Self, bool) -> Result<Word, Rejection>,
    ) -> Result<Proved, Rejection> {
        let mut words: Vec<Word> = Vec::new();
        while let Some(positive) = next_word(self.lines, &words)? {
            words.push(word(&mut self, positive)?);
        }
        let last = words.iter().map(|word| word.last).min().unwrap_or(1);
        let detail = [self.shown].into_iter().chain(words.iter().map(Word::detail)).collect();
        Ok(Proved::plain(Some(1..=last), detail))
    }

    /// Whether a letter is U.
    pub fn is_upper(&self, letter: &str) -> Result<bool, Rejection> {
        self.lines.form(["U", "D"].contains(&letter), "expected the letter U or D")?;
        Ok(letter == "U")
    }

    /// The sign of u_n must certainly be this.
    pub fn u_is(&self, n: u64, wanted: Ordering) -> Result<(), Rejection> {
        let sign = if wanted == Ordering::Greater { ">" } else { "<" };
        let holds = self.signs.u(n as usize) == Some(wanted);
        self.lines.claim(holds, format_args!("u_{n} is not certainly {sign} 0"))
    }

    /// Takes `cost` off the work that is left, before it is done.
    pub fn charge(&mut self, cost: u64) -> Result<(), Rejection> {
        self.lines.go_on().map_err(|fault| self.lines.rejection(fault))?;
        match self.left.checked_sub(cost) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => {
                Err(self.lines.malformed(format!("the check would take more than {WORK} products of digits")))
            }
        }
    }

    /// A line of these words.
    pub fn words(&mut self, what: &str) -> Result<Vec<String>, Rejection> {
        let line = self.lines.expect(what)?;
        Ok(line.split(' ').map(str::to_string).collect())
    }

    /// A period from 1 to `most`.
    pub fn period(&self, word: &str, most: u64) -> Result<u64, Rejection> {
        super::super::lines::number(word, most)
            .filter(|&n| n > 0)
            .ok_or_else(|| self.lines.malformed(format!("expected a period, a number from 1 to {most}")))
    }

    /// Whether u_n = 0, charged.
    pub fn vanishes(&mut self, n: u64) -> Result<(), Rejection> {
        self.charge(self.signs.exact_cost(n as usize))?;
        if self.signs.u_vanishes(n as usize) {
            return Ok(());
        }
        Err(self.lines.false_claim(format!("u_{n} is not certainly 0")))
    }
}

/// A line of a name and one number.
pub(super) fn value(lines: &mut Lines, name: &str, most: u64) -> Result<u64, Rejection> {
    lines.line(name, |words| words.number(&format!("the number after {name}"), most))
}

fn place(line: &str) -> Result<Place, String> {
    let words: Vec<&str> = line.split(' ').collect();
    let form = || {
        "expected \"at plane A1 A2\", \"at polar R S\" or \"at box LO HI LO HI\", fractions P/Q in lowest terms".to_string()
    };
    let [at, kind, numbers @ ..] = &words[..] else { return Err(form()) };
    let numbers: Option<Vec<Rational>> = numbers.iter().map(|word| Rational::read(word)).collect();
    let place = match (*at, *kind, numbers.as_deref()) {
        ("at", "plane", Some([a1, a2])) => Place::Plane(a1.clone(), a2.clone()),
        ("at", "polar", Some([r, s])) => {
            let half = Rational::whole(2).times(s).compared(&Rational::whole(1)) == Ordering::Less;
            let holds = s.is_positive() && half && r.is_positive();
            ensure(holds, "the point must have 0 < r <= 1 and 0 < s < 1/2")?;
            Place::Polar(r.clone(), s.clone())
        }
        ("at", "box", Some([a, b, c, d])) => {
            let holds = a.compared(b) != Ordering::Greater && c.compared(d) != Ordering::Greater;
            ensure(holds, "the ends of an interval are in the wrong order")?;
            Place::Box([a, b, c, d].map(Clone::clone))
        }
        _ => return Err(form()),
    };
    let [least, most] = place.a2();
    let holds = least.is_positive() && most.compared(&Rational::whole(1)) != Ordering::Greater;
    ensure(holds, "a2 must lie in 0 < a2 <= 1 (for a2 > 1 reverse time: a1/a2 and 1/a2)")?;
    Ok(place)
}

/// A word's sign of eµ, `word +` before `word -`, each at most once; `None` at the end of the file.
fn next_word(lines: &mut Lines, known: &[Word]) -> Result<Option<bool>, Rejection> {
    let positive = match lines.next()?.as_deref() {
        None if known.is_empty() => {
            return Err(lines.malformed("the file ends where a line \"word …\" should stand"));
        }
        None => return Ok(None),
        Some("word +") => true,
        Some("word -") => false,
        Some(_) => return Err(lines.malformed("expected a line \"word +\" or \"word -\", or the end")),
    };
    match known {
        [] => Ok(Some(positive)),
        [Word { positive: true, .. }] if !positive => Ok(Some(positive)),
        _ => Err(lines.malformed("a word for each sign of e mu at most, + before -")),
    }
}

/// What is proved of one word.
pub(super) struct Word {
    pub positive: bool,
    /// The periods and whether their letter is U.
    pub letters: Vec<(u64, bool)>,
    /// The periods decided are 1 to this.
    pub last: u64,
    /// What is said of other periods.
    pub rest: String,
}

impl Word {
    /// In words.
    pub fn detail(&self) -> (&'static str, String) {
        let list = |wanted: &dyn Fn(bool) -> bool| {
            let periods = self.letters.iter().filter(|(_, upper)| wanted(*upper));
            let text: Vec<String> = periods.map(|(n, _)| n.to_string()).collect();
            if text.is_empty() { "none".to_string() } else { text.join(", ") }
        };
        let word: String = self.letters.iter().map(|&(_, upper)| if upper { 'U' } else { 'D' }).collect();
        // A period follows itself for sign γ = sign eµ if its letter is U, else for the other sign.
        let loops = |gamma: bool| list(&|upper| upper == (gamma == self.positive));
        let name = if self.positive { "e mu > 0" } else { "e mu < 0" };
        let text = format!(
            "word {word}, periods {}; {}; with one impact: {} (gamma > 0), {} (gamma < 0)",
            list(&|_| true),
            self.rest,
            loops(true),
            loops(false)
        );
        (name, text)
    }
}

/// The set in words.
fn shown(place: &Place, line: &str) -> (&'static str, String) {
    let numbers: Vec<&str> = line.split(' ').skip(2).collect();
    match place {
        Place::Plane(..) => ("point", format!("a1 = {}, a2 = {}", numbers[0], numbers[1])),
        Place::Polar(..) => ("point", format!("r = {}, s = {}", numbers[0], numbers[1])),
        Place::Box(_) => {
            ("box", format!("{} <= a1 <= {}, {} <= a2 <= {}", numbers[0], numbers[1], numbers[2], numbers[3]))
        }
    }
}
