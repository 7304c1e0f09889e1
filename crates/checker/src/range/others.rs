//! That there are no other motions near at a cell's depths: C1 and C2, of bounded ones before the touch, and
//! after some rounds of C3 (`near`) the impacts that are left are the edges'. What is known of their
//! strengths then is narrowed by F, as between cells (`link`), until it lies in the edges' ranges. So the
//! motion solves the equations of a path of the graph there, and they have one solution.
//!
//! How many legs C3 leaves is not known before, so what it costs is counted while it is done (`Room`).

use super::{
    COST, Fault, Interval,
    cost::{BOTH, LEG},
    link,
    problem::Problem,
    text::{Alone, Others},
    work::{Graph, Numbers},
};
use crate::{
    rejection::{GoOn, claim},
    touch::{
        flow::Matrix,
        legs::Known,
        near::{Near, anything},
    },
};

/// What C3 and the rounds of F may still cost, in exponentials.
pub(super) struct Room(u64);

impl Room {
    /// Of a whole check.
    pub fn new() -> Room {
        Room(COST)
    }

    /// What is left.
    #[cfg(test)]
    pub fn left(&self) -> u64 {
        self.0
    }

    fn take(&mut self, cost: u64) -> Result<(), Fault> {
        let reason = || format!("that there are no others costs more than {COST} exponentials (C)");
        self.0 = self.0.checked_sub(cost).ok_or_else(|| Fault::False(reason()))?;
        Ok(())
    }
}

/// Proves it at some depths, with these numbers of the edges.
pub(super) fn none(
    problem: &Problem,
    depths: Interval,
    numbers: &[Numbers],
    (alone, others): (&Alone, &Others),
    room: &mut Room,
    go_on: GoOn,
) -> Result<(), Fault> {
    let (graph, cell) = (&problem.graph, problem.cell(depths));
    let periods = &graph.periods;
    let holds = (1..periods.len()).all(|n| !periods[..n].contains(&periods[n]));
    claim(holds, "letters of one period are told apart by more than that (C)")?;
    let strength = others.strength.enclosed();
    let below = |own: &Numbers| own.ends.all().magnitude().is_below(strength);
    claim(numbers.iter().all(below), "a strength of an edge is not below S (C)")?;
    let turns: Vec<Matrix> = (0..=alone.longest).map(|n| cell.turned(n)).collect();
    let near =
        Near { cell: &cell, turns: &turns, strengths: (-strength).hull(strength), parts: others.parts };
    let mut known = if problem.is_behind() {
        near.bounded(alone.longest)?;
        anything(alone.longest)
    } else {
        near.settled(alone.longest)?
    };
    // A leg, with the gaps between, or an impact.
    let each = (LEG + alone.longest).max(BOTH * problem.harmonics());
    let counted: GoOn = &mut || room.take(each).and_then(|()| go_on());
    let mut left = String::new();
    for round in 0..alone.rounds {
        let before = known;
        known = near.narrowed(&before, round == 0, counted)?;
        match impacts(graph, &near, &known, numbers) {
            Ok(sets) => {
                let steps = [others.parts, alone.rounds];
                if link::within(problem, depths, sets, [numbers; 2], steps, counted)? {
                    return Ok(());
                }
                left = "there may be other impacts between the letters (C)".into();
            }
            Err(reason) => left = reason,
        }
        if round > 0 && known == before {
            break;
        }
    }
    Err(Fault::False(left))
}

/// The strengths that are left at each edge, or an impact that may be no edge's. Where none are left at an
/// edge its own range stands for them.
fn impacts(graph: &Graph, near: &Near, known: &Known, numbers: &[Numbers]) -> Result<Vec<Interval>, String> {
    let place = |n: usize| graph.periods.iter().position(|&periods| periods == n as u64 + 1);
    let mut sets: Vec<Interval> = numbers.iter().map(|own| own.ends.all()).collect();
    for (m, n) in (0..known.len()).flat_map(|m| (0..known.len()).map(move |n| (m, n))) {
        let Some(s) = near.between(known, m, n) else { continue };
        let edge =
            place(m).zip(place(n)).and_then(|(u, v)| graph.edges.iter().position(|edge| *edge == [u, v]));
        let Some(edge) = edge else {
            return Err(format!(
                "there may be an impact between legs of {} and {} periods (C)",
                m + 1,
                n + 1
            ));
        };
        sets[edge] = s;
    }
    Ok(sets)
}
