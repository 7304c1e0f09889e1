//! Kind `word`: everything by its own sign; of the word theorem nothing is used.

use std::cmp::Ordering;

use super::{
    super::{Proved, header, lines::Lines},
    MOST, Rejection, STATEMENT,
    text::{self, Desk, Word},
};

/// Checks everything after the kind line.
pub(in super::super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    header::expect_statement(lines, STATEMENT)?;
    Desk::read(lines)?.words_to_end(word)
}

fn word(desk: &mut Desk, positive: bool) -> Result<Word, Rejection> {
    let last = text::value(desk.lines, "last", MOST)?;
    desk.lines.form(last > 0, "the last period is at least 1")?;
    desk.charge(desk.signs.reach_cost(2 * last as usize))?;
    desk.signs.reach(2 * last as usize);
    let mut letters = Vec::new();
    for n in 1..=last {
        let words = desk.words("what is true of the next period")?;
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let (name, number, argument) = match words[..] {
            [name @ ("occurs" | "absent"), number, argument] => (name, number, argument),
            [name @ "singular", number] => (name, number, ""),
            _ => {
                let form = "expected \"occurs N U\", \"occurs N D\", \"absent N K\" or \"singular N\"";
                return Err(desk.lines.malformed(form));
            }
        };
        desk.lines
            .form(desk.period(number, MOST)? == n, format_args!("the periods come in order: expected {n}"))?;
        match name {
            "occurs" => letters.push((n, occurs(desk, n, argument, positive)?)),
            "absent" => {
                let k = desk.period(argument, n.saturating_sub(1))?;
                let unit = desk.signs.sign_cost(n as usize);
                desk.charge(unit)?;
                b(desk, n, k, !positive)?;
            }
            _ => desk.vanishes(n)?,
        }
    }
    for &(i, _) in &letters {
        row(desk, i, &letters)?;
    }
    Ok(Word { positive, letters, last, rest: format!("decided for 1 to {last}") })
}

/// Whether `order` is what a positive or a negative number has.
fn agrees(order: Option<Ordering>, positive: bool) -> bool {
    order == Some(if positive { Ordering::Greater } else { Ordering::Less })
}

/// Checks that b_{n,k} has this sign.
fn b(desk: &Desk, n: u64, k: u64, positive: bool) -> Result<(), Rejection> {
    let sign = desk.signs.u(n as usize).zip(desk.signs.numerator(n as usize, k as usize));
    if agrees(sign.map(|(u, numerator)| product(u, numerator)), positive) {
        return Ok(());
    }
    let sign = if positive { ">" } else { "<" };
    Err(desk.lines.false_claim(format!("b_{{{n},{k}}} is not certainly {sign} 0")))
}

fn product(a: Ordering, b: Ordering) -> Ordering {
    if a == b { Ordering::Greater } else { Ordering::Less }
}

/// Checks a period that occurs, and returns whether its letter is U.
fn occurs(desk: &mut Desk, n: u64, letter: &str, positive: bool) -> Result<bool, Rejection> {
    let upper = desk.is_upper(letter)?;
    let unit = desk.signs.sign_cost(2 * n as usize);
    desk.charge(n * unit)?;
    desk.lines
        .claim(desk.signs.u(n as usize).is_some(), format_args!("u_{n} is not certainly different from 0"))?;
    for k in 1..n {
        b(desk, n, k, positive)?;
    }
    // c_n = N_{2n,n}/u_n².
    if !agrees(desk.signs.numerator(2 * n as usize, n as usize), upper) {
        let sign = if upper { ">" } else { "<" };
        return Err(desk.lines.false_claim(format!("c_{n} is not certainly {sign} 0")));
    }
    Ok(upper)
}

/// Checks the marks of the periods that may follow i.
fn row(desk: &mut Desk, i: u64, letters: &[(u64, bool)]) -> Result<(), Rejection> {
    let words = desk.words("what may follow the next period")?;
    let marks = match &words[..] {
        [name, number, marks] if name == "follows" && number == &i.to_string() => marks.as_bytes(),
        _ => return Err(desk.lines.malformed(format!("expected a line \"follows {i} MARKS\""))),
    };
    let holds = marks.len() == letters.len() && marks.iter().all(|mark| b"+-?".contains(mark));
    desk.lines.form(holds, format_args!("expected {} marks +, - or ?", letters.len()))?;
    for (&mark, &(j, _)) in marks.iter().zip(letters) {
        if mark == b'?' {
            continue;
        }
        let unit = desk.signs.sign_cost((i + j) as usize);
        desk.charge(unit)?;
        // p_j − q_i = N_{i+j,i}/(u_i u_j).
        let (i, j) = (i as usize, j as usize);
        let parts = (desk.signs.numerator(i + j, i), desk.signs.u(i), desk.signs.u(j));
        let sign = match parts {
            (Some(numerator), Some(u), Some(v)) => Some(product(numerator, product(u, v))),
            _ => None,
        };
        if !agrees(sign, mark == b'+') {
            let sign = if mark == b'+' { ">" } else { "<" };
            return Err(desk.lines.false_claim(format!("p_{j} - q_{i} is not certainly {sign} 0")));
        }
    }
    Ok(())
}
