//! Certificates of words, kinds `word` and `word-by-theorem`: what to prove is read off the words that were
//! found; the checker proves it.

use std::fmt::Write as _;

use num_rational::BigRational;

use crate::{
    certificate::{self, Rejection, word as form},
    error::{Error, Result},
    local::{Answer, Ladder, Point, Quantity, Region},
    number::Sign,
    word::{Edge, Extent, Letter, Realm, Rectangle, Word},
};

/// What a certificate speaks of.
#[derive(Debug, Clone, Copy)]
pub enum WordPlace<'a> {
    /// A point with 0 < a₂ ≤ 1.
    Point(&'a Point),
    /// All points of a rectangle.
    Rectangle(&'a Rectangle),
}

/// How much a certificate of a word takes from the word theorem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WordCertificate {
    /// Nothing: every period up to a last one and every edge has its own signs.
    BySigns {
        /// The last period where the word goes on for ever, or further than it was followed.
        last: u64,
    },
    /// One sign a step; all periods and edges are then the theorem's.
    ByTheorem,
}

/// What came of a certificate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Certified {
    /// Its text, which the checker has proved.
    Text(String),
    /// Nothing that the checker proves was found; why.
    Undecided(String),
}

/// The certificate of words found at a place, for one sign of eµ or both, eµ > 0 first; already checked, with
/// the checker's verdict.
///
/// Bits grow from 64 to 4096 until the checker is content. Cost: that of the check, which the kind's
/// documentation has, for each precision tried.
///
/// # Errors
/// An input error where nothing can be certified: on the lines |a₁| = 1 + a₂, and for numbers of more than
/// 100 digits; an interruption, asked for by `stop`.
///
/// ```
/// use grazing::{
///     certificate,
///     local::{Ladder, Plane, Point},
///     number::parse_rational,
///     search::{Certified, WordCertificate, WordPlace, certify_word},
///     word::Word,
/// };
/// let point = Point::Plane(Plane::new(parse_rational("-1/4")?, parse_rational("1/2")?)?);
/// let word = Word::at(&Ladder::default(), &point, true, 100, &())?;
/// let kind = WordCertificate::ByTheorem;
/// let found = certify_word(WordPlace::Point(&point), &[&word], kind, &mut || false)?;
/// let Certified::Text(text) = found else { panic!("{found:?}") };
/// assert_eq!(certificate::check(&mut text.as_bytes()).unwrap().kind, "word-by-theorem");
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn certify_word(
    place: WordPlace,
    words: &[&Word],
    kind: WordCertificate,
    stop: &mut dyn FnMut() -> bool,
) -> Result<Certified> {
    let (at, region) = head(place)?;
    if words.iter().any(|word| matches!(word.extent(), Extent::Line | Extent::Odd)) {
        return Err(Error::input(
            "on a line |a1| = a2 + 1, where some c_n is 0, a certificate holds nothing beyond period 1",
        ));
    }
    let mut body = String::new();
    for word in words {
        let _ = writeln!(body, "word {}", if word.is_positive() { '+' } else { '-' });
        let told = match kind {
            WordCertificate::BySigns { last } => by_signs(place, word, last, &mut body),
            WordCertificate::ByTheorem => by_theorem(place, region, word, &mut body),
        };
        if let Err(reason) = told {
            return Ok(Certified::Undecided(reason));
        }
    }
    let (name, statement, region) = match kind {
        WordCertificate::BySigns { .. } => (form::KIND, form::STATEMENT, String::new()),
        WordCertificate::ByTheorem => {
            (form::KIND_BY_THEOREM, form::STATEMENT_BY_THEOREM, format!("region {}\n", region.number()))
        }
    };
    let mut reason = String::new();
    for bits in [64, 128, 256, 512, 1024, 2048, 4096] {
        let format = certificate::FORMAT;
        let text = format!("{format}\nkind {name}\nstatement {statement}\n{at}\nbits {bits}\n{region}{body}");
        match certificate::check_until(&mut text.as_bytes(), stop) {
            Ok(_) => return Ok(Certified::Text(text)),
            Err(Rejection::Interrupted { .. }) => {
                return Err(Error::interrupted("interrupted before the certificate was checked"));
            }
            Err(rejection) => reason = rejection.to_string(),
        }
    }
    Ok(Certified::Undecided(format!("with 4096 bits the checker says {reason}")))
}

/// Where a set lies, as a certificate by the theorem has it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    /// In one region.
    Region(Region),
    /// In regions 3 and 4, or 2 and 3, between the lines |a₁| = a₂ + 1.
    Inside,
    /// On or across such a line.
    Across,
}

impl Place {
    fn number(self) -> u64 {
        match self {
            Place::Region(Region::One) => 1,
            Place::Region(Region::Two) => 2,
            Place::Region(Region::Three) => 3,
            Place::Region(Region::Four) => 4,
            Place::Region(Region::Five) => 5,
            Place::Inside | Place::Across | Place::Region(Region::Line) => form::BETWEEN,
        }
    }
}

/// The line of the set, and where it lies.
fn head(place: WordPlace) -> Result<(String, Place)> {
    let short = |numbers: &[&BigRational]| -> Result<String> {
        for x in numbers {
            if [x.numer(), x.denom()].iter().any(|part| part.magnitude().to_string().len() > 100) {
                return Err(Error::input(
                    "a certificate holds numbers with at most 100 digits in numerator and denominator",
                ));
            }
        }
        Ok(numbers.iter().map(|x| format!("{}/{}", x.numer(), x.denom())).collect::<Vec<_>>().join(" "))
    };
    Ok(match place {
        WordPlace::Point(Point::Plane(plane)) => {
            (format!("at plane {}", short(&[plane.a1(), plane.a2()])?), Place::Region(plane.region()))
        }
        WordPlace::Point(Point::Polar(polar)) => {
            (format!("at polar {}", short(&[polar.r(), polar.s()])?), Place::Region(Region::Three))
        }
        WordPlace::Rectangle(rectangle) => {
            let ([a, b], [c, d]) = (rectangle.a1(), rectangle.a2());
            let region = match (rectangle.region(), rectangle.realm()) {
                (Some(region), _) => Place::Region(region),
                (None, Realm::Inside) => Place::Inside,
                (None, _) => Place::Across,
            };
            (format!("at box {}", short(&[a, b, c, d])?), region)
        }
    })
}

fn b(place: WordPlace, ladder: &Ladder, n: u64, k: u64) -> Option<Sign> {
    match place {
        WordPlace::Rectangle(rectangle) => rectangle.b(n, k),
        WordPlace::Point(point) => match ladder.sign(point, Quantity::B { n, k }).answer {
            Answer::Sign(sign) if sign != Sign::Zero => Some(sign),
            _ => None,
        },
    }
}

fn vanishes(place: WordPlace, ladder: &Ladder, n: u64) -> bool {
    match place {
        WordPlace::Rectangle(_) => false,
        WordPlace::Point(point) => ladder.u_sign(point, n).answer == Answer::Sign(Sign::Zero),
    }
}

/// The body of a word in kind `word`, up to the word's last mediant or `last`; or why there is none.
fn by_signs(place: WordPlace, word: &Word, last: u64, body: &mut String) -> std::result::Result<(), String> {
    let vertices = word.up_to(form::MOST);
    let longest = vertices.iter().map(|vertex| vertex.period).max().unwrap_or(1);
    let wanted = match word.extent() {
        Extent::All => last,
        Extent::Complete { next: Some(next) } => next,
        Extent::Complete { next: None } if longest > 1 => longest + 1,
        Extent::Complete { next: None } => last,
        // Whether it occurs is not known, or it lies on a boundary; the periods before it are.
        Extent::Boundary { next, .. } | Extent::Undecided { next, .. } | Extent::Straddled { next } => next,
        Extent::Cut | Extent::Odd | Extent::Line => longest,
    };
    let ladder = Ladder::default();
    let against = if word.is_positive() { Sign::Negative } else { Sign::Positive };
    let mut lines = Vec::new();
    for n in 1..=wanted.min(form::MOST) {
        let vertex = vertices.iter().find(|vertex| vertex.period == n);
        let line = match vertex {
            // On a rectangle a later b may be open where the deciding one is not.
            Some(vertex) => (vertex.letter != Letter::Either && told(place, n))
                .then(|| format!("occurs {n} {}", vertex.letter)),
            None if vanishes(place, &ladder, n) => Some(format!("singular {n}")),
            None => {
                let k = (1..n).find(|&k| b(place, &ladder, n, k) == Some(against));
                k.map(|k| format!("absent {n} {k}"))
            }
        };
        match line {
            Some(line) => lines.push(line),
            None => break,
        }
    }
    if lines.is_empty() {
        return Err("the letter of period 1 is not certain on all of the box".into());
    }
    let _ = writeln!(body, "last {}", lines.len());
    for line in &lines {
        let _ = writeln!(body, "{line}");
    }
    // The occurring periods in order; an edge is looked up by the places in the word.
    let mut places: Vec<(u64, usize)> =
        vertices.iter().enumerate().map(|(place, vertex)| (vertex.period, place)).collect();
    places.retain(|&(n, _)| n <= lines.len() as u64);
    places.sort_unstable();
    let all = word.is_endless();
    for &(i, from) in &places {
        let mark = |&(j, to): &(u64, usize)| {
            let edge = if all { word.edge(0, 0, true) } else { word.edge(from, to, true) };
            let open =
                matches!(place, WordPlace::Rectangle(rectangle) if rectangle.numerator(i + j, i).is_none());
            match edge {
                Edge::Yes if !open => '+',
                Edge::No if !open => '-',
                _ => '?',
            }
        };
        let _ = writeln!(body, "follows {i} {}", places.iter().map(mark).collect::<String>());
    }
    Ok(())
}

/// Whether everything that `occurs n` says is certain: at a point it is, where a word is right.
fn told(place: WordPlace, n: u64) -> bool {
    match place {
        WordPlace::Point(_) => true,
        WordPlace::Rectangle(rectangle) => {
            (1..n).all(|k| rectangle.b(n, k).is_some()) && rectangle.numerator(2 * n, n).is_some()
        }
    }
}

/// The body of a word in kind `word-by-theorem`; or why there is none.
fn by_theorem(
    place: WordPlace,
    region: Place,
    word: &Word,
    body: &mut String,
) -> std::result::Result<(), String> {
    let all = word.vertices();
    if region == Place::Across {
        return Err("the box meets a line |a1| = a2 + 1, and the word theorem speaks of either side".into());
    }
    let counted = matches!(region, Place::Region(Region::Three) | Place::Inside);
    if !(word.is_positive() && (counted || region == Place::Region(Region::Four))) {
        let line = match (word.extent(), counted) {
            (Extent::All, _) => format!("all {}", all[0].letter),
            (Extent::Complete { .. }, true) if all.len() as u64 <= form::LETTERS => {
                format!("below {}", all.len())
            }
            (_, true) => {
                return Err(format!(
                    "the word for e*mu < 0 is not whole, or has more than {} letters",
                    form::LETTERS
                ));
            }
            _ => format!("one {}", all[0].letter),
        };
        let _ = writeln!(body, "{line}");
        return Ok(());
    }
    let kept =
        all.iter().take_while(|vertex| vertex.period <= form::LONGEST).count().min(form::LETTERS as usize);
    if kept < 2 {
        return Err(format!(
            "the word for e*mu > 0 is not known beyond its first letter, or goes on beyond period {}",
            form::LONGEST
        ));
    }
    if counted {
        let _ = writeln!(body, "first {}", all[1].period);
    }
    for vertex in &all[2..kept] {
        let _ = writeln!(body, "step {} {}", vertex.period, vertex.letter);
    }
    let end = match word.extent() {
        Extent::Complete { next: Some(next) } | Extent::Boundary { next, deciding: None }
            if kept == all.len() && next <= form::LONGEST =>
        {
            side(place, next).map(|side| format!("end {next} {side}"))
        }
        _ => None,
    };
    // With an open end the last pair of letters says nothing.
    let word = if end.is_some() { word.clone() } else { word.shortened(kept) };
    let _ = writeln!(body, "{}", end.as_deref().unwrap_or("open"));
    for (i, vertex) in word.vertices().iter().enumerate() {
        let mark = |j| match word.edge(i, j, true) {
            Edge::Yes => '+',
            Edge::No => '-',
            Edge::Open => '?',
        };
        let _ = writeln!(body, "follows {} {}", vertex.period, (0..kept).map(mark).collect::<String>());
    }
    Ok(())
}

/// The letter of the side of u_n, or 0.
fn side(place: WordPlace, n: u64) -> Option<char> {
    let sign = match place {
        WordPlace::Rectangle(rectangle) => rectangle.u(n)?,
        WordPlace::Point(point) => match Ladder::default().u_sign(point, n).answer {
            Answer::Sign(sign) => sign,
            _ => return None,
        },
    };
    Some(match sign {
        Sign::Negative => 'U',
        Sign::Positive => 'D',
        Sign::Zero => '0',
    })
}
