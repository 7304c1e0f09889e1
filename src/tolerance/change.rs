//! What decides: how far one parameter may go before a statement changes.
//!
//! An [`Excursion`] leads one parameter from a point outwards, the other one staying where it is, or anywhere
//! within the box. Cells of that way are halved, the nearest open one first. So a statement is certainly the
//! same on all of the way up to the near end of the first cell on which that stays open, and it has certainly
//! changed on the first cell on which it is something else.

use std::{cmp::Reverse, collections::BinaryHeap};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::{
    parameters::{Coordinates, ParameterBox},
    partition::{Leaf, Statement},
};
use crate::{
    error::{Error, Result},
    monitor::Monitor,
};

/// A cell is not halved when it is less than this part of the way, 2^−`FINEST`.
const FINEST: usize = 34;

/// The same where the other parameter is anywhere in the box, and changes come one after the other.
const FINEST_WHOLE: usize = 18;

/// What is wider than so many of the finest cells is said to be open.
const CLEAR: u32 = 16;

/// Where a statement first changes, as one parameter moves away from where it is.
#[derive(Debug, Clone)]
pub struct Change {
    /// What the statement is at the point: it holds, or it does not.
    pub holds: bool,
    /// It is the same up to this value of the parameter.
    pub before: BigRational,
    /// At this value it has changed; none if no such value was found.
    pub by: Option<BigRational>,
    /// The last cell on which it is the same.
    pub until: Leaf,
    /// A cell on which it has changed.
    pub after: Option<Leaf>,
    /// Whether γ > 0 there, if that is what changed.
    pub turns: Option<bool>,
    /// Whether `before` and `by` are not close: something between them is open.
    pub open: bool,
}

/// The way of one parameter away from a point.
#[derive(Debug)]
pub struct Excursion {
    axis: usize,
    rises: bool,
    from: Leaf,
    end: BigRational,
    finest: [BigRational; 2],
    nodes: Vec<Node>,
    limit: u64,
}

#[derive(Debug)]
struct Node {
    leaf: Leaf,
    /// Across which parameter there is hope.
    axis: Option<usize>,
    halves: Option<[usize; 2]>,
}

/// Which way to go.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Toward {
    /// The parameter that moves: 0 or 1.
    pub axis: usize,
    /// Whether it becomes larger.
    pub rises: bool,
    /// Whether the other parameter is anywhere within the box, not at the point alone.
    pub whole: bool,
}

impl Excursion {
    /// Away from a point of a box, as far as [`reach`](ParameterBox::reach) says, with at most `limit` cells
    /// for all that is asked of it.
    ///
    /// # Errors
    /// An input error if the point is not in the box.
    pub fn new(of: &ParameterBox, from: &[BigRational; 2], to: Toward, limit: u64) -> Result<Excursion> {
        let Toward { axis, rises, whole } = to;
        if (0..2).any(|i| from[i] < of.sides[i][0] || of.sides[i][1] < from[i]) {
            return Err(Error::input(format!("the point {}, {} is not in the box", from[0], from[1])));
        }
        if of.sides.len() > 2 {
            return Err(Error::input("one parameter goes alone where a box has two, not more"));
        }
        let cell =
            |bounds: [_; 2]| ParameterBox { coordinates: of.coordinates.clone(), sides: bounds.into() };
        let at = |i: usize| [from[i].clone(), from[i].clone()];
        let end = of.reach(axis, &from[axis])[usize::from(rises)].clone();
        let along = if rises { [from[axis].clone(), end.clone()] } else { [end.clone(), from[axis].clone()] };
        let across = if whole { of.sides[1 - axis].clone() } else { at(1 - axis) };
        let bounds = if axis == 0 { [along, across] } else { [across, along] };
        let part =
            BigRational::new(BigInt::one(), BigInt::one() << if whole { FINEST_WHOLE } else { FINEST });
        let finest = bounds.each_ref().map(|[lower, upper]| (upper - lower) * &part);
        let (from, _) = Leaf::new(cell([at(0), at(1)]), 0)?;
        let mut way = Excursion { axis, rises, from, end, finest, nodes: Vec::new(), limit };
        way.push(cell(bounds))?;
        Ok(way)
    }

    /// What is certain at the point that it begins at.
    pub fn from(&self) -> &Leaf {
        &self.from
    }

    /// Where the parameter is at that point.
    pub fn start(&self) -> &BigRational {
        &self.from.cell.sides[self.axis][0]
    }

    /// How many cells were looked at.
    pub fn cells(&self) -> u64 {
        self.nodes.len() as u64
    }

    /// How far it leads.
    pub fn end(&self) -> &BigRational {
        &self.end
    }

    fn push(&mut self, cell: ParameterBox) -> Result<usize> {
        let (leaf, axis) = Leaf::new(cell, 0)?;
        self.nodes.push(Node { leaf, axis, halves: None });
        Ok(self.nodes.len() - 1)
    }

    /// How far from the point a cell begins.
    fn distance(&self, id: usize) -> BigRational {
        let [lower, upper] = &self.nodes[id].leaf.cell.sides[self.axis];
        let start = self.start();
        if self.rises { lower - start } else { start - upper }
    }

    fn place(&self, distance: &BigRational) -> BigRational {
        let start = self.start();
        if self.rises { start + distance } else { start - distance }
    }

    /// The halves of a cell, if there is hope of them, and they are neither too small nor too many.
    fn halves(&mut self, id: usize, monitor: &dyn Monitor) -> Result<Option<[usize; 2]>> {
        let node = &self.nodes[id];
        if node.halves.is_some() {
            return Ok(node.halves);
        }
        let Some(hope) = node.axis.filter(|_| self.nodes.len() as u64 + 2 <= self.limit) else {
            return Ok(None);
        };
        let cell = &node.leaf.cell;
        let can = |axis: &usize| {
            let [lower, upper] = &cell.sides[*axis];
            upper - lower > self.finest[*axis]
        };
        let Some(axis) = [hope, 1 - hope].into_iter().find(can) else { return Ok(None) };
        let [lower, upper] = cell.halves(axis);
        monitor.advance(2)?;
        let both = [self.push(lower)?, self.push(upper)?];
        self.nodes[id].halves = Some(both);
        Ok(Some(both))
    }

    /// Where a statement first changes on this way; none if it is open at the point itself. What is said of a
    /// machine's own γ changes where γ does.
    ///
    /// Cost: some 70 cells per change that is passed closely, each as one of [`Partition`](super::Partition);
    /// cells are kept from one statement to the next. `monitor` is told of every cell.
    ///
    /// # Errors
    /// The monitor's interruption.
    pub fn first(&mut self, statement: Statement, monitor: &dyn Monitor) -> Result<Option<Change>> {
        let Some(holds) = self.from.holds(statement) else { return Ok(None) };
        let own = matches!(statement, Statement::ChaosAt { .. } | Statement::OrbitAt { .. });
        let gamma = self.from.gamma.filter(|_| own);
        let same = |leaf: &Leaf| match (gamma, leaf.gamma) {
            (Some(at), Some(there)) if at != there => Some(false),
            _ => Some(leaf.holds(statement)? == holds),
        };
        let mut queue = BinaryHeap::from([Reverse((BigRational::zero(), 0))]);
        let (mut open, mut found, mut until) = (None, None, None);
        while let Some(Reverse((distance, id))) = queue.pop() {
            match same(&self.nodes[id].leaf) {
                Some(true) if open.is_none() => until = Some(id),
                Some(true) => {}
                Some(false) => {
                    found = Some((distance, id));
                    break;
                }
                None => match self.halves(id, monitor)? {
                    Some(halves) => queue.extend(halves.map(|half| Reverse((self.distance(half), half)))),
                    None => {
                        open.get_or_insert(distance);
                    }
                },
            }
        }
        let by = found.as_ref().map(|(distance, _)| distance);
        let close = &self.finest[self.axis] * BigRational::from_integer(CLEAR.into());
        let is_open = match (&open, by) {
            (Some(open), Some(by)) => by - open > close,
            (open, _) => open.is_some(),
        };
        let before = open.as_ref().or(by).map_or_else(|| self.end.clone(), |distance| self.place(distance));
        let leaf = |id: usize| &self.nodes[id].leaf;
        let after = found.as_ref().map(|(_, id)| leaf(*id));
        Ok(Some(Change {
            holds,
            before,
            by: by.map(|distance| self.place(distance)),
            until: until.map_or(&self.from, leaf).clone(),
            turns: after.and_then(|leaf| leaf.gamma).filter(|there| gamma.is_some_and(|at| at != *there)),
            after: after.cloned(),
            open: is_open,
        }))
    }
}

impl ParameterBox {
    /// How far an [`Excursion`] leads from a value of one parameter, down and up: to half of it and twice it
    /// within the theory's bounds, of the damping ratio from 0 to 0.99, and by 1 of a₁; where damping and
    /// stiffness are functions, to the ends of the box.
    pub fn reach(&self, axis: usize, from: &BigRational) -> [BigRational; 2] {
        let q = |p: i64, d: i64| BigRational::new(p.into(), d.into());
        let (half, twice) = (from * q(1, 2), from * q(2, 1));
        match (&self.coordinates, axis) {
            (Coordinates::Machine, 1) if *from < q(99, 100) => [BigRational::zero(), q(99, 100)],
            (Coordinates::Machine, _) => [half, twice.min(q(1000, 1))],
            (Coordinates::Polar, 1) => [half, twice.min((from + q(1, 2)) * q(1, 2))],
            (Coordinates::Plane, 0) => [from - q(1, 1), from + q(1, 1)],
            (Coordinates::Polar | Coordinates::Plane, _) => [half, twice.min(q(1, 1))],
            // What lies beyond the box was not looked at.
            (Coordinates::Oscillator(_), _) => self.sides[axis].clone(),
        }
    }
}
