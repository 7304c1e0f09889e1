//! Kind `word-by-theorem`: the signs that the word theorem asks for, one per step, and the pattern graph that
//! it gives.

use std::cmp::Ordering;

use super::{
    super::{Proved, header, lines::Lines},
    BETWEEN, LETTERS, LONGEST, Rejection, STATEMENT_BY_THEOREM,
    number::Rational,
    text::{self, Desk, Word},
};

/// Checks everything after the kind line.
pub(in super::super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    header::expect_statement(lines, STATEMENT_BY_THEOREM)?;
    let desk = Desk::read(lines)?;
    let region = text::value(desk.lines, "region", BETWEEN)?;
    let inside = match region {
        BETWEEN => desk.signs.place().is_in_three_or_four(),
        _ => desk.signs.place().region() == Some(region),
    };
    if !inside {
        return Err(desk.lines.false_claim(match region {
            BETWEEN => "not all of the set lies in regions 3 and 4".to_string(),
            _ => format!("not all of the set lies in region {region}"),
        }));
    }
    desk.words_to_end(|desk, positive| match (region, positive) {
        (3 | 4 | BETWEEN, true) => path(desk, region),
        (3 | BETWEEN, false) => below(desk),
        _ => one_letter(desk, region, positive),
    })
}

/// Regions 1, 2 and 5, and eµ < 0 in region 4: every period with one letter, or 1 alone.
fn one_letter(desk: &mut Desk, region: u64, positive: bool) -> Result<Word, Rejection> {
    let (all, upper) = match (region, positive) {
        (1, _) => (positive, true),
        (2, _) => (!positive, false),
        _ => (positive && region == 5, false),
    };
    let letter = if upper { "U" } else { "D" };
    let wanted = format!("{} {letter}", if all { "all" } else { "one" });
    let line = desk.lines.expect("what occurs")?;
    desk.lines.form(line == wanted, format_args!("in region {region} this line is {wanted:?}"))?;
    let rest = if all { "and so is every period" } else { "no other period occurs" };
    Ok(Word { positive, letters: vec![(1, upper)], last: 1, rest: rest.into() })
}

/// Region 3, eµ < 0: the n with 2ns < 1. In region 4 u_2 < 0, and period 1 is the only one.
fn below(desk: &mut Desk) -> Result<Word, Rejection> {
    let last = text::value(desk.lines, "below", LETTERS)?;
    desk.lines.form(last > 0, "period 1 occurs")?;
    ahead(desk, last + 1)?;
    (1..=last).try_for_each(|n| desk.u_is(n, Ordering::Greater))?;
    if desk.signs.u(last as usize + 1) != Some(Ordering::Less) {
        desk.vanishes(last + 1)?;
    }
    let letters = (1..=last).map(|n| (n, false)).collect();
    Ok(Word { positive: false, letters, last, rest: "no other period occurs".into() })
}

/// Makes the signs of u up to n known.
fn ahead(desk: &mut Desk, n: u64) -> Result<(), Rejection> {
    desk.charge(desk.signs.reach_cost(n as usize) + n * desk.signs.sign_cost(n as usize))?;
    desk.signs.reach(n as usize);
    Ok(())
}

/// A period that occurs, at m/n.
#[derive(Clone, Copy)]
struct Vertex {
    m: u64,
    n: u64,
    upper: bool,
}

/// How a word ends.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    /// The next period does not occur, and the last pair has its edge from D to U only.
    Next,
    /// It does not occur, but nothing is said of the edges of the last pair.
    Silent,
    /// It is open whether it occurs.
    Open,
}

/// Region 3 and 4, eµ > 0: the path.
fn path(desk: &mut Desk, region: u64) -> Result<Word, Rejection> {
    let first = if region == 4 { 2 } else { first(desk)? };
    let mut word = vec![Vertex { m: 0, n: 1, upper: false }, Vertex { m: 1, n: first, upper: true }];
    // Indices of the last D and the last U.
    let (mut lower, mut upper) = (0, 1);
    let (end, rest) = loop {
        let (a, b) = (word[lower], word[upper]);
        let (m, n) = (a.m + b.m, a.n + b.n);
        let words = desk.words("the next step")?;
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        if words == ["open"] {
            break (End::Open, format!("further periods are {n} or later on the path"));
        }
        let [name @ ("step" | "end"), number, letter] = words[..] else {
            return Err(desk.lines.malformed(
                "expected \"step N U\", \"step N D\", \"end N U\", \"end N D\", \"end N 0\" or \"open\"",
            ));
        };
        let holds = n <= LONGEST && (word.len() as u64) < LETTERS;
        desk.lines.form(
            holds,
            format_args!("at most {LETTERS} letters and periods to {LONGEST}: end with \"open\""),
        )?;
        if desk.period(number, LONGEST)? != n {
            return Err(desk
                .lines
                .malformed(format!("the mediant of {} and {} has the period {n}", a.n, b.n)));
        }
        ahead(desk, n)?;
        if (name, letter) == ("end", "0") {
            desk.vanishes(n)?;
            let [_, most] = desk.signs.place().a2();
            let inside = most.compared(&Rational::whole(1)) == Ordering::Less;
            break (if inside { End::Next } else { End::Silent }, "no other period occurs".into());
        }
        let is_upper = desk.is_upper(letter)?;
        let side = if is_upper { Ordering::Less } else { Ordering::Greater };
        desk.u_is(n, side)?;
        // b_{n,k} has the sign of N_{n,k} u_n.
        let k = if is_upper { b.n } else { a.n };
        let (wanted, sign) = if name == "step" { (side, ">") } else { (side.reverse(), "<") };
        let holds = desk.signs.numerator(n as usize, k as usize) == Some(wanted);
        desk.lines.claim(holds, format_args!("b_{{{n},{k}}} is not certainly {sign} 0"))?;
        if name == "end" {
            break (End::Next, "no other period occurs".into());
        }
        if is_upper {
            upper = word.len()
        } else {
            lower = word.len()
        }
        word.push(Vertex { m, n, upper: is_upper });
    };
    for i in 0..word.len() {
        let marks: String = (0..word.len()).map(|j| mark(&word, (lower, upper), end, i, j)).collect();
        let line = desk.lines.expect("what may follow the next period")?;
        let wanted = format!("follows {} {marks}", word[i].n);
        desk.lines.claim(line == wanted, format_args!("by the theorem this line is {wanted:?}"))?;
    }
    let last = word.iter().map(|vertex| vertex.n).max().unwrap_or(1);
    let letters = word.iter().map(|vertex| (vertex.n, vertex.upper)).collect();
    Ok(Word { positive: true, letters, last, rest })
}

/// The first K with u_K < 0: 2 in region 4, and in region 3 the least with 2Ks > 1. As s < ½, 2ns passes 1
/// before it reaches 2, so that u_n ≤ 0 at the first n with 2ns ≥ 1.
fn first(desk: &mut Desk) -> Result<u64, Rejection> {
    let first = text::value(desk.lines, "first", LONGEST)?;
    desk.lines.form(first >= 2, "the first period with 2ns > 1 is at least 2")?;
    ahead(desk, first)?;
    for n in 1..first {
        let sign = desk.signs.u(n as usize);
        if sign == Some(Ordering::Greater) {
            continue;
        }
        desk.lines.claim(n + 1 == first && sign.is_none(), format_args!("u_{n} is not certainly > 0"))?;
        desk.vanishes(n)?;
    }
    desk.u_is(first, Ordering::Less)?;
    Ok(first)
}

/// Whether p_j > q_i for the vertices i and j, by the theorem (its table is in the head of `mod.rs`); `last`
/// are the last D and the last U.
fn mark(word: &[Vertex], last: (usize, usize), end: End, i: usize, j: usize) -> char {
    let (from, to) = (word[i], word[j]);
    let both = |yes| if yes { '+' } else { '-' };
    if from.upper == to.upper {
        return both(from.upper);
    }
    let (d, u) = if from.upper { (j, i) } else { (i, j) };
    if (d, u) == last {
        return match end {
            End::Next => both(!from.upper),
            End::Silent | End::Open => '?',
        };
    }
    let (a, b) = (word[d], word[u]);
    if b.m * a.n == a.m * b.n + 1 {
        // Neighbours but not the last: their mediant comes after both, at the first place that lies between
        // them.
        let mediant = word.iter().find(|vertex| (vertex.m, vertex.n) == (a.m + b.m, a.n + b.n));
        return mediant.map_or('?', |vertex| both(vertex.upper));
    }
    both(d > u)
}
