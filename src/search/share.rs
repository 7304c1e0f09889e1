//! Certificates of shares, kind `share`: a box of parameters is halved until a statement is certain on a
//! cell, and the checker, whose enclosures are its own and wider, proves it there.

use std::{
    collections::VecDeque,
    fmt::{self, Write as _},
};

use num_rational::BigRational;
use num_traits::{One, Signed, pow};

use super::Certified;
use crate::{
    certificate::{self, Rejection, share as form},
    error::{Error, Result},
    monitor::Monitor,
    number::parse_integer,
    tolerance::{CaseSigns, Leaf, ParameterBox, Statement},
    word::Letter,
};

/// The most digits of a number in such a certificate.
const DIGITS: usize = 15;

/// What a certificate is to prove of a share.
///
/// ```
/// use grazing::search::ShareStatement;
/// for text in ["period + 3", "word - 4 1D 2D", "chaos +", "chaos + -"] {
///     assert_eq!(ShareStatement::parse(text)?.to_string(), text);
/// }
/// assert!(ShareStatement::parse("period + 65").unwrap_err().is_input());
/// # Ok::<(), grazing::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ShareStatement {
    /// Period n can occur between impacts.
    Period {
        /// Whether eµ > 0.
        positive: bool,
        /// n, at most 64.
        n: u64,
    },
    /// Of the periods up to a last one these occur, and no others.
    Word {
        /// Whether eµ > 0.
        positive: bool,
        /// The last, at most 64.
        last: u64,
        /// In order of the periods.
        letters: Vec<(u64, Letter)>,
    },
    /// Chaos is born.
    Chaos {
        /// Whether eµ > 0.
        positive: bool,
        /// Whether γ > 0; none of machines, which have their own.
        gamma: Option<bool>,
    },
}

impl ShareStatement {
    /// Reads a statement as the certificate has it: `period E N`, `word E N W …` with W as in 2U, or `chaos
    /// E` with the sign of γ, if it is free; E is the sign of eµ, + or -.
    ///
    /// # Errors
    /// An input error for any other text.
    pub fn parse(text: &str) -> Result<ShareStatement> {
        let wrong = || {
            Error::input(format!(
                "{text:?}: expected \"period + 3\", \"word + 5 1D 2U 3U\", \"chaos +\" of machines or \"chaos + -\" \
                 with a sign of gamma; the first sign is that of e*mu, periods are at most {}",
                form::MOST
            ))
        };
        let sign = |word: &str| match word {
            "+" => Ok(true),
            "-" => Ok(false),
            _ => Err(wrong()),
        };
        let period = |word: &str| {
            parse_integer::<u64>(word).ok().filter(|n| (1..=form::MOST).contains(n)).ok_or_else(wrong)
        };
        let words: Vec<&str> = text.split_whitespace().collect();
        match words[..] {
            ["period", emu, n] => Ok(ShareStatement::Period { positive: sign(emu)?, n: period(n)? }),
            ["chaos", emu] => Ok(ShareStatement::Chaos { positive: sign(emu)?, gamma: None }),
            ["chaos", emu, gamma] => {
                Ok(ShareStatement::Chaos { positive: sign(emu)?, gamma: Some(sign(gamma)?) })
            }
            ["word", emu, last, ref listed @ ..] => {
                let last = period(last)?;
                let mut letters = Vec::new();
                for word in listed {
                    let upper = word.ends_with('U');
                    let n = period(word.strip_suffix(['U', 'D']).ok_or_else(wrong)?)?;
                    let before = letters.last().map_or(0, |(n, _)| *n);
                    if n <= before || n > last {
                        return Err(wrong());
                    }
                    letters.push((n, if upper { Letter::U } else { Letter::D }));
                }
                Ok(ShareStatement::Word { positive: sign(emu)?, last, letters })
            }
            _ => Err(wrong()),
        }
    }

    /// Whether it holds at all points of a cell, or at none.
    fn holds(&self, leaf: &Leaf) -> Option<bool> {
        match self {
            ShareStatement::Period { positive, n } => {
                leaf.holds(Statement::Period { positive: *positive, n: *n })
            }
            ShareStatement::Chaos { positive, gamma } => {
                leaf.holds(CaseSigns { positive: *positive, gamma: *gamma }.chaos())
            }
            ShareStatement::Word { positive, last, letters } => {
                let mut certain = true;
                for n in 1..=*last {
                    let listed = letters.iter().find(|(listed, _)| *listed == n).map(|(_, letter)| *letter);
                    match leaf.letter(*positive, n) {
                        None | Some(Some(Letter::Either)) => certain = false,
                        Some(found) if found != listed => return Some(false),
                        Some(_) => {}
                    }
                }
                certain.then_some(true)
            }
        }
    }
}

impl fmt::Display for ShareStatement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = |positive: bool| if positive { '+' } else { '-' };
        match self {
            ShareStatement::Period { positive, n } => write!(f, "period {} {n}", sign(*positive)),
            ShareStatement::Chaos { positive, gamma } => {
                write!(f, "chaos {}", sign(*positive))?;
                gamma.map_or(Ok(()), |gamma| write!(f, " {}", sign(gamma)))
            }
            ShareStatement::Word { positive, last, letters } => {
                write!(f, "word {} {last}", sign(*positive))?;
                let letter = |letter| if letter == Letter::U { 'U' } else { 'D' };
                letters.iter().try_for_each(|(n, of)| write!(f, " {n}{}", letter(*of)))
            }
        }
    }
}

/// A part of the box.
struct Node {
    /// Its ways from the box: across which parameter, and whether to the upper half.
    way: Vec<(usize, bool)>,
    /// What was proved of it.
    holds: Option<bool>,
    /// Its halves, across which parameter.
    cut: Option<(usize, [usize; 2])>,
}

/// A certificate of the share of a box in which something holds, already checked.
///
/// The largest part of which nothing is proved is halved, until `cells` parts were looked at. Cost:
/// O(`cells`) parts, each with the signs of two words and a check of its own.
///
/// # Errors
/// An input error for a statement that does not go with the box, or a box whose ends have too many digits;
/// the monitor's interruption, or one asked for by `stop`.
///
/// ```
/// use grazing::{
///     certificate,
///     number::parse_rational,
///     search::{Certified, ShareStatement, certify_share},
///     tolerance::ParameterBox,
/// };
/// let q = |text| parse_rational(text);
/// let of = ParameterBox::machine([q("0.6")?, q("0.61")?], [q("0.09")?, q("0.11")?])?;
/// let statement = ShareStatement::parse("chaos +")?;
/// let found = certify_share(&of, &statement, 100, &(), &mut || false)?;
/// let Certified::Text(text) = found else { panic!("{found:?}") };
/// assert!(text.contains("\nshare 1/1 1/1\n"));
/// assert_eq!(certificate::check(&mut text.as_bytes()).unwrap().kind, "share");
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn certify_share(
    of: &ParameterBox,
    statement: &ShareStatement,
    cells: u64,
    monitor: &dyn Monitor,
    stop: &mut dyn FnMut() -> bool,
) -> Result<Certified> {
    if let ShareStatement::Chaos { gamma, .. } = statement
        && gamma.is_some() == of.has_gamma()
    {
        let why = match gamma {
            Some(_) => "a machine has its own gamma: leave out the second sign",
            None => "the sign of gamma is free here: give it as a second sign, as in \"chaos + -\"",
        };
        return Err(Error::input(format!("\"{statement}\": {why}")));
    }
    let head = head(of, statement)?;
    let mut nodes = vec![Node { way: Vec::new(), holds: None, cut: None }];
    let mut next = VecDeque::from([(0, of.clone(), None)]);
    let mut looked = 0;
    while let Some((at, cell, known)) = next.pop_front() {
        if looked == cells {
            break;
        }
        monitor.advance(1)?;
        looked += 1;
        let way = &nodes[at].way;
        let claim = match known {
            Some(claim) => Some(claim),
            None => statement.holds(&Leaf::new(cell.clone(), 0)?.0),
        };
        if let Some(claim) = claim
            && is_proved(&head, way, claim, stop)?
        {
            nodes[at].holds = Some(claim);
            continue;
        }
        let Some(axis) = cell.longer().filter(|_| way.len() < form::DEEPEST as usize) else { continue };
        let halves = [false, true].map(|upper| [way.as_slice(), &[(axis, upper)]].concat());
        let first = nodes.len();
        nodes[at].cut = Some((axis, [first, first + 1]));
        for (i, (way, half)) in halves.into_iter().zip(cell.halves(axis)).enumerate() {
            nodes.push(Node { way, holds: None, cut: None });
            next.push_back((first + i, half, claim));
        }
    }
    let mut shares = [BigRational::from_integer(0.into()), BigRational::one()];
    for node in &nodes {
        let part = pow(BigRational::new(1.into(), 2.into()), node.way.len());
        match node.holds {
            Some(true) => shares[0] += part,
            Some(false) => shares[1] -= part,
            None => {}
        }
    }
    let mut tree = String::new();
    write_tree(&nodes, 0, &mut tree);
    if tree == "?\n" {
        let reason = format!("on none of {looked} cells is it certain; --cells {} may do", 4 * cells);
        return Ok(Certified::Undecided(reason));
    }
    let text = format!("{head}share {}\n{tree}", shares.map(|x| fraction(&x)).join(" "));
    match certificate::check_until(&mut text.as_bytes(), stop) {
        Ok(_) => Ok(Certified::Text(text)),
        Err(Rejection::Interrupted { .. }) => Err(interrupted()),
        Err(rejection) => Ok(Certified::Undecided(format!("the checker says {rejection}"))),
    }
}

fn interrupted() -> Error {
    Error::interrupted("interrupted before the certificate was checked")
}

fn fraction(x: &BigRational) -> String {
    format!("{}/{}", x.numer(), x.denom())
}

/// The lines before the shares.
fn head(of: &ParameterBox, statement: &ShareStatement) -> Result<String> {
    let Some(name) = of.coordinates_name() else {
        let why = "a certificate of a share is of machines by frequency and damping ratio, of r and s, or of a1 \
                   and a2, not of functions of other parameters";
        return Err(Error::input(why));
    };
    let ends: Vec<&BigRational> = of.bounds().iter().flatten().collect();
    for x in &ends {
        if [x.numer().abs(), x.denom().clone()].iter().any(|part| part.to_string().len() > DIGITS) {
            return Err(Error::input(format!(
                "{x}: a certificate of a share holds numbers with at most {DIGITS} digits in numerator and \
                 denominator; give the ends of the box with fewer"
            )));
        }
    }
    let ends: Vec<String> = ends.into_iter().map(fraction).collect();
    let (format, kind, what) = (certificate::FORMAT, form::KIND, form::STATEMENT);
    let ends = ends.join(" ");
    Ok(format!("{format}\nkind {kind}\nstatement {what}\nbox {name} {ends}\nholds {statement}\n"))
}

/// Whether the checker proves the claim for one part, of a certificate that claims nothing else.
fn is_proved(head: &str, way: &[(usize, bool)], claim: bool, stop: &mut dyn FnMut() -> bool) -> Result<bool> {
    let whole = 1u64 << way.len();
    let shares = if claim { format!("1/{whole} 1/1") } else { format!("0/1 {}/{whole}", whole - 1) };
    let mut text = format!("{head}share {shares}\n");
    let mut after = 0;
    for (axis, upper) in way {
        let _ = writeln!(text, "{}", axis + 1);
        if *upper { text += "?\n" } else { after += 1 }
    }
    text += if claim { "+\n" } else { "-\n" };
    text += &"?\n".repeat(after);
    match certificate::check_until(&mut text.as_bytes(), stop) {
        Ok(_) => Ok(true),
        Err(Rejection::Interrupted { .. }) => Err(interrupted()),
        Err(_) => Ok(false),
    }
}

/// A part and its halves, those left out of which nothing is claimed.
fn write_tree(nodes: &[Node], at: usize, text: &mut String) {
    let node = &nodes[at];
    let begin = text.len();
    match (node.holds, node.cut) {
        (Some(holds), _) => *text += if holds { "+\n" } else { "-\n" },
        (None, None) => *text += "?\n",
        (None, Some((axis, halves))) => {
            let _ = writeln!(text, "{}", axis + 1);
            halves.into_iter().for_each(|half| write_tree(nodes, half, text));
            if text[begin..].ends_with("\n?\n?\n") && text[begin..].len() == 6 {
                text.replace_range(begin.., "?\n");
            }
        }
    }
}
