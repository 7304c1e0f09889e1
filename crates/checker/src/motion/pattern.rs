//! What patterns of impacts have in common, of whatever state: that an orbit does not repeat itself, and that
//! the gaps are followed piece by piece to the end of each flight.

use super::{Fault, Interval, text::Decimal};
use crate::rejection::{GoOn, claim, ensure};

/// 2πn.
pub(crate) fn turns(n: u64) -> Interval {
    Interval::integer(n) * (Interval::PI + Interval::PI)
}

/// Whether no number of one interval is one of the other.
pub(crate) fn apart(a: Interval, b: Interval) -> bool {
    (a - b).is_positive() || (b - a).is_positive()
}

/// No smaller whole number of periods is one of the orbit. If one were, it would hold d of the m impacts, d a
/// divisor of m, and every impact would come back d impacts later: the same but for its phase (`same` of two
/// says whether that may be), d/m of all periods later. For each such d some impact does not.
///
/// # Errors
/// Says after how many impacts the orbit may repeat itself.
pub(crate) fn least_period(
    impacts: &[(u64, Interval)],
    same: impl Fn(usize, usize) -> bool,
) -> Result<(), String> {
    let m = impacts.len();
    let total: u64 = impacts.iter().map(|(periods, _)| periods).sum();
    for d in (1..m).filter(|&d| m.is_multiple_of(d) && (total * d as u64).is_multiple_of(m as u64)) {
        let shift = turns(total * d as u64 / m as u64);
        let comes_back = |i: usize| {
            let j = (i + d) % m;
            let between: u64 = (i..i + d).map(|l| impacts[l % m].0).sum();
            same(i, j) && !apart(turns(between) + impacts[j].1 - impacts[i].1, shift)
        };
        let holds = !(0..m).all(comes_back);
        ensure(holds, format_args!("the orbit may repeat itself after {d} of its {m} impacts"))?;
    }
    Ok(())
}

/// Goes through the pieces of the flight with this number, which end at the times `ends`, from its start to
/// its end or beyond. `doubtful` names a gap that is not shown to be positive from one time to another,
/// knowing whether that is the first piece and whether it is the last.
///
/// # Errors
/// A false claim, where there is such a gap or the pieces do not hold the flight.
pub(crate) fn follow(
    flight: usize,
    duration: Interval,
    ends: &[Decimal],
    go_on: GoOn,
    doubtful: impl Fn(Interval, Interval, [bool; 2]) -> Option<String>,
) -> Result<(), Fault> {
    let last = ends.len() - 1;
    claim(duration.is_positive(), format_args!("flight {flight} does not certainly last"))?;
    let holds = duration.is_up_to(ends[last].enclosed());
    claim(holds, format_args!("the pieces of flight {flight} stop before its end"))?;
    let mut from = Interval::ZERO;
    for (index, to) in ends.iter().map(|end| end.enclosed()).enumerate() {
        go_on()?;
        let holds = (to - from).is_positive();
        claim(holds, format_args!("the pieces of flight {flight} do not follow one another"))?;
        if let Some(gap) = doubtful(from, to, [index == 0, index == last]) {
            let piece = index + 1;
            return Err(Fault::False(format!(
                "{gap} on piece {piece} of flight {flight} is not certainly positive"
            )));
        }
        from = to;
    }
    Ok(())
}
