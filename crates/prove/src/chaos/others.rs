//! Whether there are other orbits near, as far as floats tell: the conditions of proofs/chaos.md, "No
//! others", for a neighbourhood of the grazing.

use super::{
    float,
    map::{Cell, Flow, Impact},
    search::{Attempt, Closed},
    span::Span,
};
use crate::certificate::chaos::{Complete, Decimal};

/// The longest legs, the most rounds and the most evaluations of a leg that are tried.
const LONGEST: u64 = 24;
const ROUNDS: u64 = 12;
const MOST: u64 = 200_000;

/// How much larger than that of the boxes the strengths of the neighbourhood are, until one fails.
const LARGER: [f64; 9] = [1.03, 1.1, 1.25, 1.5, 1.8, 2.5, 4.0, 8.0, 16.0];

/// The velocities after and before of legs of n periods, n from 1; none if there are no such legs.
type Known = Vec<Option<[Span; 2]>>;

impl Attempt<'_> {
    /// Cells and a neighbourhood for boxes that close: these cells, or the depth cut finer, in which boxes
    /// that close stay so.
    pub fn complete(&self, closed: &Closed) -> Option<([u64; 5], Option<Complete>)> {
        (0..4).find_map(|finer| {
            let mut cuts = closed.cells;
            let wide = self.problem.ranges[4][0] < self.problem.ranges[4][1];
            cuts[4] <<= if wide { finer } else { 0 };
            let attempt =
                Attempt::new(self.problem, cuts, closed.parts.clone()).filter(|_| wide || finer == 0)?;
            let complete = attempt.neighbourhood(&closed.boxes, closed.window)?;
            Some((cuts, Some(complete)))
        })
    }

    /// The largest neighbourhood tried in which all orbits are those of the boxes.
    pub fn neighbourhood(&self, boxes: &[[Span; 2]], window: f64) -> Option<Complete> {
        let letters = &self.problem.letters;
        let distinct = (1..letters.len()).all(|n| !letters[..n].contains(&letters[n]));
        let still = self.problem.ranges[2].iter().all(num_traits::Zero::is_zero);
        if !(self.problem.behind && still && distinct) {
            return None;
        }
        let longest =
            self.cells.iter().map(|(cell, _)| longest(cell)).try_fold(1, |most, m| Some(m?.max(most)))?;
        let strengths = self.cells.iter().flat_map(|(cell, _)| {
            let pairs =
                self.problem.next.iter().enumerate().flat_map(|(m, next)| next.iter().map(move |&n| (m, n)));
            pairs.map(|(m, n)| cell.strength(boxes[n][0], boxes[m][1]).magnitude())
        });
        let least = strengths.fold(0.0, f64::max);
        let claim = |larger: f64, parts: u64| {
            let places = (2 - (least * larger).log10().floor() as i32).clamp(0, 6);
            let digits = (least * larger * 10f64.powi(places)).ceil() as i64;
            let strength = shorter(Decimal { digits: digits.into(), places: places as u32 });
            let cost = self.cells.len() as u64 * parts * parts * longest.pow(3);
            let claim = Complete { strength, longest, parts, rounds: ROUNDS.min(MOST / cost) };
            let taken = self.alone(boxes, window, &claim).ok()?;
            Some(Complete { rounds: claim.rounds.min(taken + 2), ..claim })
        };
        let (parts, first) = [2, 4].into_iter().find_map(|parts| Some((parts, claim(LARGER[0], parts)?)))?;
        Some(LARGER[1..].iter().map_while(|&larger| claim(larger, parts)).last().unwrap_or(first))
    }

    /// After how many rounds a claim is seen to hold in all cells, or why it is not.
    pub fn alone(&self, boxes: &[[Span; 2]], window: f64, claim: &Complete) -> Result<u64, String> {
        let mut most = 0;
        // The last cell is the widest wall: it fails first.
        for (cell, _) in self.cells.iter().rev() {
            if longest(cell).is_none_or(|longest| longest > claim.longest) {
                return Err("a leg may be too long".into());
            }
            let strength = float(claim.strength);
            let all = cell.impact(Span::new(-strength, strength)).ok_or("a phase is not bounded")?;
            if all.phase.magnitude() >= window {
                return Err("a phase may leave the window".into());
            }
            if !cell.meets_once(&all) {
                return Err("there may be two contacts in one window".into());
            }
            let turns: Vec<Flow> = (0..=claim.longest).map(|n| cell.turned(n)).collect();
            let narrow =
                Narrowing { cell, turns, strength: Span::new(-strength, strength), parts: claim.parts };
            most = most.max(self.rounds(&narrow, boxes, claim)?);
        }
        Ok(most)
    }

    fn rounds(&self, narrow: &Narrowing, boxes: &[[Span; 2]], claim: &Complete) -> Result<u64, String> {
        let mut known: Known = vec![Some([Span::WHOLE; 2]); claim.longest as usize];
        for round in 1..=claim.rounds {
            let next = narrow.round(&known, round == 1).ok_or("a phase is not bounded")?;
            let same = known.iter().flatten().flatten().zip(next.iter().flatten().flatten());
            let settled = known.iter().flatten().count() == next.iter().flatten().count()
                && same.into_iter().all(|(old, new)| old.width() - new.width() <= 1e-3 * new.width());
            known = next;
            match self.left(narrow, &known, boxes) {
                None => return Ok(round),
                Some(why) if settled => return Err(why),
                Some(_) => {}
            }
        }
        Err("the rounds do not suffice".into())
    }

    fn left(&self, narrow: &Narrowing, known: &Known, boxes: &[[Span; 2]]) -> Option<String> {
        let place = |n: usize| self.problem.letters.iter().position(|&periods| periods == n as u64 + 1);
        for (n, spans) in known.iter().enumerate() {
            let Some(spans) = spans else { continue };
            let fits = place(n).is_some_and(|v| (0..2).all(|i| spans[i].is_in(boxes[v][i])));
            if !fits {
                return Some(format!("legs of {} periods may be elsewhere", n + 1));
            }
        }
        let count = known.len();
        let mut pairs = (0..count).flat_map(|m| (0..count).map(move |n| (m, n)));
        let wrong = pairs.find(|&(m, n)| match (place(m), place(n)) {
            (Some(u), Some(v)) => {
                !self.problem.next[u].contains(&v) && narrow.strength(known, m, n).is_some()
            }
            _ => false,
        });
        wrong.map(|(m, n)| format!("a leg of {} periods may follow one of {}", n + 1, m + 1))
    }
}

/// 314 with two places is 3.14, 310 is 3.1.
fn shorter(mut x: Decimal) -> Decimal {
    while x.places > 0 && x.digits % 10 == 0 {
        x = Decimal { digits: x.digits / 10, places: x.places - 1 };
    }
    x
}

/// The most periods of a leg that begins and ends above 0: y₀, y₁, … > 0 with yₖ₊₁/yₖ = trace −
/// determinant/(yₖ/yₖ₋₁).
fn longest(cell: &Cell) -> Option<u64> {
    let [trace, determinant] = cell.invariants();
    let mut ratio = trace.hi;
    for longest in 2..=LONGEST {
        if ratio < 0.0 {
            return Some(longest);
        }
        ratio = trace.hi - determinant.lo / ratio;
    }
    None
}

/// What a round needs.
struct Narrowing<'a> {
    cell: &'a Cell,
    turns: Vec<Flow>,
    strength: Span,
    parts: u64,
}

impl Narrowing<'_> {
    /// The strengths of impacts between legs of m + 1 and n + 1 periods.
    fn strength(&self, known: &Known, m: usize, n: usize) -> Option<Span> {
        let ([after, _], [_, before]) = (known[n]?, known[m]?);
        (after.hi >= before.lo).then(|| self.cell.strength(after, before).common(self.strength))?
    }

    fn round(&self, known: &Known, first: bool) -> Option<Known> {
        let count = known.len();
        let mut impacts: Vec<Vec<[Impact; 2]>> = Vec::new();
        for (m, n) in (0..count).flat_map(|m| (0..count).map(move |n| (m, n))) {
            let Some(s) = self.strength(known, m, n) else {
                impacts.push(Vec::new());
                continue;
            };
            let cut = |i| {
                let s = s.part(i, self.parts);
                Some([self.cell.impact(s)?, self.cell.impact(Span::point(s.middle()))?])
            };
            impacts.push((0..self.parts).map(cut).collect::<Option<_>>()?);
        }
        let others = if first { 1 } else { count };
        let narrow = (0..count).map(|n| {
            let triples = (0..others).flat_map(|m| (0..others).map(move |k| (m, k)));
            let legs = triples.flat_map(|(m, k)| {
                let (from, to) = (&impacts[m * count + n], &impacts[n * count + k]);
                from.iter()
                    .flat_map(move |from| to.iter().map(move |to| self.leg(known, [m, n, k], from, to)))
            });
            legs.flatten().reduce(|one, other| [one[0].hull(other[0]), one[1].hull(other[1])])
        });
        Some(narrow.collect())
    }

    fn leg(
        &self,
        known: &Known,
        [m, n, k]: [usize; 3],
        from: &[Impact; 2],
        to: &[Impact; 2],
    ) -> Option<[Span; 2]> {
        let ([own, end], [_, before], [after, _]) = (known[n]?, known[m]?, known[k]?);
        let leg = self.cell.leg(self.turns[n + 1], n as u64 + 1, [&from[0], &to[0]], [&from[1], &to[1]]);
        let (s, t) = (from[0].s, to[0].s);
        let [one, other] = self.cell.shares;
        let a = leg.after.common(own)?.common(Span::new(s.lo / 2.0, f64::INFINITY))?;
        let p = leg.before.common(end)?.common(Span::new(f64::NEG_INFINITY, t.hi / 2.0))?;
        let a = a.common((s - other * before).over(one))?;
        let p = p.common((t - one * after).over(other))?;
        let above = (1..=n).all(|turns| self.cell.at_turn(self.turns[turns], &from[0], a).hi >= 1.0);
        above.then_some([a, p])
    }
}
