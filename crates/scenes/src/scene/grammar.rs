//! How an expression is written: its text as a formula.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = signed { ("*" | "/") signed }
//! signed  = [ "+" | "-" ] power
//! power   = atom [ "^" exponent ]
//! exponent = [ "+" | "-" ] digits | decimal | "(" digits "/" digits ")"
//! atom    = decimal | parameter | "pi" | function "(" sum ")" | kink | "(" sum ")"
//! function = "sqrt" | "exp" | "sin" | "cos" | "log" | "tanh"
//! kink    = ("abs" | "sign") "(" sum ")" | ("max" | "min") "(" sum "," sum ")"
//! ```
//!
//! In a force the displacement q, the velocity u and the time t are parameters, too (`force`); log, tanh,
//! kinks and powers that are not whole have no enclosures and stand only there. Such a power is above 1.
//!
//! A parameter called like a function is that parameter, and so is `pi` in the older formats. Angles are in
//! radians.
//!
//! Behind a decimal, `pi` or a parenthesis a unit may stand, where a scene has units: they are read here, and
//! gone in the text from which an expression is made (`quantity`).
//!
//! A decimal is one of the command line's number grammar (`12`, `0.375`, `1e-30`), and exact. Powers bind
//! tighter than signs: -w^2 is -(w^2).

use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::{
    error::{Error, Result},
    formula::{Formula, Function, KINKS, Operation, kink},
    number::parse_rational_within,
    quantity::{Joint, Unit, symbols},
    source::hint,
    typed::in_number,
};

/// Above this many factors and terms, powers written out, an expression is refused.
const LIMIT_SIZE: u64 = 256;
/// The same where there are kinks, both sides of each written out.
const LIMIT_KINKS: u64 = 16 * LIMIT_SIZE;
/// The most bits of a literal's or parameter's numerator and denominator.
pub(super) const LIMIT_BITS: u32 = 4096;
const LIMIT_DEPTH: u32 = 32;

/// A unit in a text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mark {
    /// Where what it stands behind begins and ends, and where the unit ends.
    pub places: [usize; 3],
    /// The number that it stands behind, if that is one.
    pub number: Option<BigRational>,
    pub unit: Unit,
}

/// A formula in names, then in the units of its text, then in whatever else a force may depend on.
pub(super) struct Marked {
    pub root: Formula,
    pub marks: Vec<Mark>,
}

/// Reads an expression that may have units in it. Where that fails: whether a unit is to blame.
pub(super) fn marked(text: &str, names: &[String]) -> std::result::Result<Marked, (Error, bool)> {
    let mut parser = Parser { text, at: 0, names, depth: 0, marks: Some(Vec::new()), blamed: false };
    let root = parser.whole();
    let blamed = parser.blamed;
    let marks = parser.marks.unwrap_or_default();
    match root {
        Ok(root) => Ok(Marked { root, marks }),
        Err(error) => Err((error, blamed || !marks.is_empty())),
    }
}

/// Reads an expression without units.
///
/// # Errors
/// An input error that says at which character what was expected, or which parameter is unknown; also
/// for more than 256 factors and terms or 32 levels of parentheses.
pub(super) fn formula(text: &str, names: &[String]) -> Result<Formula> {
    let root = Parser { text, at: 0, names, depth: 0, marks: None, blamed: false }.whole()?;
    let most = if root.chooses() { LIMIT_KINKS } else { LIMIT_SIZE };
    if root.size() > most {
        return Err(Error::input(format!(
            "has {} factors and terms, powers written out; at most {most} are allowed",
            root.size()
        )));
    }
    Ok(root)
}

struct Parser<'a> {
    text: &'a str,
    /// The bytes read.
    at: usize,
    names: &'a [String],
    depth: u32,
    /// The units found, if there may be any.
    marks: Option<Vec<Mark>>,
    /// Whether a unit, or what stands in its place, is what is wrong.
    blamed: bool,
}

impl<'a> Parser<'a> {
    fn whole(&mut self) -> Result<Formula> {
        let root = self.sum()?;
        if self.peek().is_some() {
            return Err(self.expected("an operator or the end"));
        }
        Ok(root)
    }

    /// The next character but spaces, which are passed over.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    fn position(&self, at: usize) -> usize {
        self.text[..at].chars().count() + 1
    }

    fn expected(&mut self, what: &str) -> Error {
        let found = self.peek().map_or("the end".to_string(), |c| format!("{c:?}"));
        let meant = match self.peek() {
            // In an argument list a comma is no decimal one.
            Some(c) if c == ',' && self.depth == 0 || !c.is_ascii() => in_number(self.text),
            _ => None,
        };
        let meant = meant.map_or(String::new(), |meant| format!("; {meant}"));
        Error::input(format!("expected {what} at character {}, found {found}{meant}", self.position(self.at)))
    }

    fn sum(&mut self) -> Result<Formula> {
        self.chain(Self::product, [('+', Operation::Sum), ('-', Operation::Difference)])
    }

    fn product(&mut self) -> Result<Formula> {
        self.chain(Self::signed, [('*', Operation::Product), ('/', Operation::Quotient)])
    }

    fn chain(
        &mut self,
        part: fn(&mut Self) -> Result<Formula>,
        operators: [(char, Operation); 2],
    ) -> Result<Formula> {
        let mut left = part(self)?;
        let mut parts = 1;
        while let Some((_, operation)) = operators.into_iter().find(|&(sign, _)| self.take(sign)) {
            parts += 1;
            // The tree leans left: its depth is the number of parts.
            if parts > LIMIT_SIZE {
                return Err(Error::input(format!("has more than {LIMIT_SIZE} factors or terms")));
            }
            self.peek();
            let start = self.at;
            let right = part(self)?;
            self.check_quotient(operation, &left, start)?;
            left = Formula::Binary(operation, Box::new([left, right]));
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<Formula> {
        if self.take('-') {
            return Ok(Formula::Negated(Box::new(self.power()?)));
        }
        self.take('+');
        self.power()
    }

    fn power(&mut self) -> Result<Formula> {
        let base = self.atom()?;
        if !self.take('^') {
            return Ok(base);
        }
        if let Some(exponent) = self.fraction()? {
            return Ok(Formula::Raised(Box::new(base), exponent));
        }
        let negative = self.take('-') || {
            self.take('+');
            false
        };
        self.peek();
        let digits = self.word(|c| c.is_ascii_digit());
        match digits.parse::<i32>() {
            Ok(exponent) if exponent as u64 <= LIMIT_SIZE => {
                Ok(Formula::Power(Box::new(base), if negative { -exponent } else { exponent }))
            }
            _ if digits.is_empty() => Err(self.expected("a whole number as exponent")),
            _ => Err(Error::input(format!("the exponent {digits} is above {LIMIT_SIZE}"))),
        }
    }

    /// An exponent that is no whole number; none where another kind stands, which is left unread.
    fn fraction(&mut self) -> Result<Option<BigRational>> {
        self.peek();
        let start = self.at;
        let is_part = |c: char| c.is_ascii_digit() || c == '.';
        let read = if self.take('(') {
            self.peek();
            let over = self.word(is_part);
            let under = if self.take('/') {
                self.peek();
                self.word(is_part)
            } else {
                "1"
            };
            let closed = self.take(')');
            [over, under].iter().all(|part| !part.is_empty()).then_some((over, under)).filter(|_| closed)
        } else {
            Some((self.word(is_part), "1")).filter(|known| known.0.contains('.'))
        };
        let Some((over, under)) = read else {
            self.at = start;
            return Ok(None);
        };
        let part = |text: &str| parse_rational_within(text, LIMIT_BITS).map_err(Error::from);
        let (over, under) = (part(over)?, part(under)?);
        let place = self.position(start);
        if under.is_zero() {
            return Err(Error::input(format!("the exponent at character {place} divides by zero")));
        }
        let exponent = over / under;
        let most = BigRational::from_integer(LIMIT_SIZE.into());
        if exponent <= BigRational::one() || exponent > most {
            return Err(Error::input(format!(
                "the exponent {exponent} at character {place} is not above 1, or above {LIMIT_SIZE}: write x^1.5 as it is, \
                 x^0.5 as sqrt(x) where x stays positive, x^-1.5 as 1/x^1.5, a whole power without a point"
            )));
        }
        if exponent.is_integer() {
            return Err(Error::input(format!(
                "the exponent at character {place} is whole: write it as {exponent}, without a point or parentheses"
            )));
        }
        Ok(Some(exponent))
    }

    fn atom(&mut self) -> Result<Formula> {
        let first = self.peek();
        let start = self.at;
        let atom = match first {
            Some('(') => self.parenthesis(),
            Some(c) if c.is_ascii_digit() || c == '.' => self.decimal(),
            Some(c) if starts_name(c) => self.parameter(),
            _ => Err(self.expected("a number, a parameter or \"(\"")),
        }?;
        if self.marks.is_some() && (first == Some('(') || matches!(atom, Formula::Number(_) | Formula::Pi)) {
            return self.with_unit(start, atom);
        }
        Ok(atom)
    }

    /// What was read from `start` on, times the unit that follows, if one does.
    fn with_unit(&mut self, start: usize, atom: Formula) -> Result<Formula> {
        let (end, names) = (self.at, self.names);
        let is_name = |word: &str| names.iter().any(|name| name == word);
        let next = self.text[end..].trim_start();
        let at = self.text.len() - next.len();
        let word = match next.chars().next() {
            Some(c) if starts_name(c) => &next[..next.find(|c| !continues_name(c)).unwrap_or(next.len())],
            Some(c @ ('%' | '°')) => &next[..c.len_utf8()],
            _ => return Ok(atom),
        };
        let Some((unit, read)) = Unit::begin(next, &|word, joint| joint != Joint::Tight && is_name(word))
        else {
            self.blamed = true;
            let (place, before) = (self.position(at), &self.text[start..end]);
            return Err(Error::input(if is_name(word) {
                let also =
                    Unit::symbol(word).map_or("", |_| ", or rename the parameter if the unit is meant");
                format!("{word} at character {place} is a parameter: write {before}*{word}{also}")
            } else {
                let near = hint(word, symbols());
                format!(
                    "there is no unit {word:?}, at character {place}; {near}; a product is {before}*{word}"
                )
            }));
        };
        self.at = at + read;
        let number = if let Formula::Number(value) = &atom { Some(value.clone()) } else { None };
        let marks = self.marks.get_or_insert_default();
        marks.push(Mark { places: [start, end, self.at], number, unit });
        let place = names.len() + marks.len() - 1;
        Ok(Formula::Binary(Operation::Product, Box::new([atom, Formula::Variable(place)])))
    }

    /// Refuses 1/2 mm, which is half a millimetre to the eye and 1/(2 mm) to the grammar; the divisor begins
    /// at `start` and has just been read.
    fn check_quotient(&self, operation: Operation, left: &Formula, start: usize) -> Result<()> {
        let last = self.marks.as_ref().and_then(|marks| marks.last());
        let Some(Mark { places: [from, to, end], number: Some(_), unit }) = last else { return Ok(()) };
        if operation != Operation::Quotient || *from != start || *end != self.at || left.mentions(&|_| true) {
            return Ok(());
        }
        let (by, place) = (&self.text[*from..*to], self.position(start));
        Err(Error::input(format!(
            "…/{by} {unit}, at character {place}, is read in two ways: write (…/{by}) {unit}, or …/({by} {unit})",
            unit = unit.text
        )))
    }

    fn parenthesis(&mut self) -> Result<Formula> {
        self.depth += 1;
        if self.depth > LIMIT_DEPTH {
            return Err(Error::input(format!("has more than {LIMIT_DEPTH} levels of parentheses")));
        }
        self.at += 1;
        let inner = self.sum()?;
        if !self.take(')') {
            return Err(self.expected("an operator or \")\""));
        }
        self.depth -= 1;
        Ok(inner)
    }

    fn decimal(&mut self) -> Result<Formula> {
        let start = self.at;
        self.word(|c| c.is_ascii_digit() || c == '.');
        // An exponent only if a digit follows: in 2*e the e is a parameter.
        let rest = self.text[self.at..].strip_prefix(['e', 'E']);
        if let Some(tail) = rest.map(|rest| rest.strip_prefix(['+', '-']).unwrap_or(rest))
            && tail.starts_with(|c: char| c.is_ascii_digit())
        {
            self.at = self.text.len() - tail.len();
            self.word(|c| c.is_ascii_digit());
        }
        let value = parse_rational_within(&self.text[start..self.at], LIMIT_BITS).map_err(|error| {
            Error::from(error).context(format_args!("at character {}", self.position(start)))
        })?;
        Ok(Formula::Number(value))
    }

    fn parameter(&mut self) -> Result<Formula> {
        let start = self.at;
        let name = self.word(continues_name);
        if let Some(index) = self.names.iter().position(|known| known == name) {
            return Ok(Formula::Variable(index));
        }
        if name == "pi" {
            return Ok(Formula::Pi);
        }
        if let Some((_, function)) = Function::ALL.into_iter().find(|known| known.0 == name) {
            if self.peek() != Some('(') {
                return Err(self.expected("\"(\""));
            }
            return Ok(Formula::Call(function, Box::new(self.parenthesis()?)));
        }
        if let Some((_, count)) = KINKS.into_iter().find(|known| known.0 == name) {
            return self.kink(start, count);
        }
        if self.marks.is_some() && is_variable(name) {
            return Ok(Formula::Variable(usize::MAX));
        }
        let hint = hint(name, self.names.iter().map(String::as_str));
        let is_state = matches!(name.trim_end_matches(|c: char| c.is_ascii_digit()), "q" | "u" | "t");
        let hint = match in_number(name) {
            Some(meant) => meant,
            None if Unit::symbol(name).is_some() => {
                format!(
                    "{hint}; as a unit {name} stands behind a number, or behind a space, * or / after another unit"
                )
            }
            None if is_state => format!("{hint}; q, u and t stand only in `force`"),
            None => hint,
        };
        Err(Error::input(format!("unknown parameter {name:?} at character {}; {hint}", self.position(start))))
    }

    /// A function with kinks of so many arguments, its name, which begins at `start`, being read.
    fn kink(&mut self, start: usize, count: usize) -> Result<Formula> {
        let name = &self.text[start..self.at];
        if !self.take('(') {
            return Err(self.expected("\"(\""));
        }
        self.depth += 1;
        if self.depth > LIMIT_DEPTH {
            return Err(Error::input(format!("has more than {LIMIT_DEPTH} levels of parentheses")));
        }
        let mut arguments = vec![self.sum()?];
        while arguments.len() < count {
            if !self.take(',') {
                return Err(self.expected(&format!("an operator or \",\", as {name} has {count} arguments,")));
            }
            arguments.push(self.sum()?);
        }
        if !self.take(')') {
            return Err(self.expected("an operator or \")\""));
        }
        self.depth -= 1;
        let text = &self.text[start..self.at];
        let made = kink(name, text, arguments).ok_or_else(|| self.expected("a function"))?;
        // Each side of a kink has its arguments: what is nested grows threefold on each level.
        if made.size() > LIMIT_KINKS {
            return Err(Error::input(format!(
                "has {} factors and terms in {text}, both sides of all kinks written out; at most {LIMIT_KINKS} are allowed",
                made.size()
            )));
        }
        Ok(made)
    }

    fn word(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let rest = &self.text[self.at..];
        let end = rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }
}

fn starts_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn continues_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether a force, a law of a stop or a restitution may depend on what is called so.
fn is_variable(name: &str) -> bool {
    let bare = name.trim_end_matches(|c: char| c.is_ascii_digit());
    matches!(bare, "q" | "u") || matches!(name, "t" | "d" | "v")
}

/// Whether an expression can name a parameter so.
pub(super) fn is_name(text: &str) -> bool {
    text.starts_with(starts_name) && text.chars().all(continues_name)
}

/// A number short enough for expressions of it to be short.
pub(super) fn checked(value: BigRational) -> Result<BigRational> {
    let bits = value.numer().bits().max(value.denom().bits());
    if bits > LIMIT_BITS.into() {
        return Err(Error::input(format!(
            "has {bits} bits in its numerator or denominator; at most {LIMIT_BITS} are allowed"
        )));
    }
    Ok(value)
}
