//! Motions that keep step: of systems with as many cells in a period and the same walls, in arrays of
//! numbers.
//!
//! A motion that cannot be told by the vector code (it rests, touches, presses, escapes, or bounces lower
//! than counts) is handed to the scalar engine in the state before it was looked at, and comes back at the
//! next point of the section if it is in flight there.

use super::{
    super::{
        Event, Run, Simulator,
        engine::Aloft,
        grid::{Cursor, Place, Tables},
        pieces::{LOWER, UPPER},
    },
    Numbered,
    queue::Queue,
    strike::Bounce,
    sweep::Span,
    tables::{Blocks, Shared, far, moderate, same},
    vector::{Eight, LANES},
};
use crate::motion::{Effect, EffectTally, RunEnd, Share, State, Time};
use std::sync::Arc;

/// What the motions of a group have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kind {
    pub cells: usize,
    pub half: f64,
    pub driven: bool,
    pub walls: [bool; 2],
    pub depth: f64,
    pub impact_limit: u64,
}

impl Kind {
    /// The kind of a system that the vector code can follow.
    pub fn of(simulator: &Simulator) -> Option<Kind> {
        let tables = simulator.tables().filter(moderate)?;
        let settings = &simulator.settings;
        let walls = [0, 1].map(|wall| simulator.walls.contacts[wall].is_some());
        let (depth, impact_limit) = (settings.minimum_depth, settings.impact_limit);
        let Tables { cells, half, driven, .. } = tables;
        Some(Kind { cells, half, driven, walls, depth, impact_limit })
    }
}

/// Told of each event: which motion, and what.
pub(super) type Each<'e> = Option<&'e mut dyn FnMut(usize, Event)>;

/// What one wall does to each motion of a group.
pub(super) struct Stops {
    /// ±1, as [`Side::sign`](crate::motion::Side::sign).
    pub sign: f64,
    /// τ.
    pub restitution: Vec<f64>,
    /// z′² on leaving that is surely no bounce too low to count.
    pub least: Vec<f64>,
}

pub(super) struct Group<'a> {
    pub kind: Kind,
    pub phase: f64,
    /// What callers call each motion.
    pub names: Vec<usize>,
    pub simulators: Vec<&'a Simulator>,
    pub tables: Vec<Tables<'a>>,
    places: Vec<Place>,
    pub cell: usize,
    pub from: f64,
    pub blocks: Blocks,
    pub shared: Option<Shared>,
    pub stops: [Option<Stops>; 2],
    /// The homogeneous motions about the middle of the cell.
    pub y: [Vec<Eight>; 2],
    /// Bit masks of each eight: whether the gap was open since the last contact, per wall.
    pub open: [Vec<u8>; 2],
    /// The same before the looks that are under way.
    pub was_open: [Vec<u8>; 2],
    /// Which keep step.
    pub aloft: Vec<u8>,
    pub impacts: Vec<u64>,
    /// The forcing period at the last point of the section.
    pub periods: Vec<i64>,
    /// Those that do not keep step.
    pub alone: Vec<Option<Run<'a>>>,
    pub ends: Vec<RunEnd>,
    /// Who is followed at all.
    pub followed: Vec<bool>,
    pub work: Work,
    /// Whether events are told.
    pub told: bool,
    /// Looks at all walls of a motion on a piece, and searches among them, not yet told.
    pub looks: i64,
    pub searches: i64,
    tally: Option<Arc<EffectTally>>,
}

/// What is done for some of the motions in a round.
pub(super) struct Work {
    /// To be looked at for impacts on a wall: y, from and to where.
    pub looks: [Queue<4>; 2],
    /// The same, for the next round.
    pub next: [Queue<4>; 2],
    /// A minimum between two places: y, l, z there, r, z there, a guess, the least z″.
    pub valleys: Queue<8>,
    /// A maximum between two places: y, l, z there, r, z there, a guess.
    pub tops: Queue<7>,
    /// A root between two places: y, l, r, a guess, z at l, and from where the look was.
    pub roots: Queue<7>,
    /// An impact: y, x, z, z′, z″, the rounding error of z, and from where the look was.
    pub hits: [Queue<8>; 2],
    /// What the walls make of them.
    pub bounces: Vec<Bounce>,
    /// Motions for the scalar engine: which, y, from where.
    pub strange: Vec<(usize, [f64; 2], f64)>,
    /// Where the lower wall is met, to end the search for the upper.
    pub met: Vec<f64>,
}

impl Work {
    fn new(most: usize) -> Work {
        let looks = || [Queue::new(most), Queue::new(most)];
        Work {
            looks: looks(),
            next: looks(),
            valleys: Queue::new(most),
            tops: Queue::new(most),
            roots: Queue::new(most),
            hits: [Queue::new(most), Queue::new(most)],
            bounces: Vec::new(),
            strange: Vec::new(),
            met: vec![f64::INFINITY; most],
        }
    }
}

impl<'a> Group<'a> {
    /// The group of motions of one kind; each is alone until it passes the section.
    pub fn new(kind: Kind, phase: f64, motions: Vec<Numbered<'a>>) -> Group<'a> {
        let count = motions.len();
        let simulators: Vec<&Simulator> = motions.iter().map(|motion| motion.1).collect();
        let tables: Vec<Tables> = simulators.iter().filter_map(|simulator| simulator.tables()).collect();
        let place = |simulator: &&Simulator| simulator.place(phase);
        let places: Vec<Place> = match same(&simulators) {
            true => vec![place(&simulators[0]).expect("a kind has a grid"); 1],
            false => simulators.iter().filter_map(place).collect(),
        };
        let one = same(&simulators);
        let stops = [0usize, 1].map(|wall| {
            kind.walls[wall].then(|| Stops {
                sign: simulators[0].walls.side(wall).sign(),
                restitution: simulators.iter().map(|s| s.walls.restitution(wall)).collect(),
                least: simulators.iter().map(|s| 2.0 * (kind.depth * s.walls.strongest(wall))).collect(),
            })
        });
        let eights = count.div_ceil(LANES);
        Group {
            kind,
            phase,
            names: motions.iter().map(|motion| motion.0).collect(),
            cell: places[0].cell,
            from: places[0].from,
            places,
            blocks: Blocks::new(&tables, one),
            shared: Shared::new(&tables, one),
            tables,
            stops,
            y: [vec![[0.0; LANES]; eights], vec![[0.0; LANES]; eights]],
            open: [vec![0; eights], vec![0; eights]],
            was_open: [vec![0; eights], vec![0; eights]],
            aloft: vec![0; eights],
            impacts: vec![0; count],
            periods: motions.iter().map(|motion| super::before(&motion.2, phase)).collect(),
            alone: motions.into_iter().map(|motion| Some(motion.2)).collect(),
            ends: vec![RunEnd::Reached; count],
            followed: vec![true; count],
            work: Work::new(count),
            told: false,
            looks: 0,
            searches: 0,
            tally: simulators[0].tally.clone(),
            simulators,
        }
    }

    /// Those who do not keep step on to the section by the scalar engine; then all are at it. `periods` is
    /// theirs already.
    pub fn gather(&mut self, each: &mut Each) {
        for lane in 0..self.names.len() {
            let Some(run) = &mut self.alone[lane] else { continue };
            if self.ends[lane] != RunEnd::Reached {
                continue;
            }
            let until = Time::new(self.periods[lane], self.phase);
            let name = self.names[lane];
            let end = match each {
                Some(each) => run.record(until, |event| each(name, event)),
                None => run.finish(until),
            };
            self.impacts[lane] = run.impacts();
            self.ends[lane] = end;
            let back = run.engine.aloft().filter(|aloft| {
                let Cursor { period, cell, from, .. } = aloft.cursor;
                (period, cell, from) == (until.period, self.cell, self.from)
            });
            if let (Some(Aloft { cursor, open, impacts }), RunEnd::Reached) = (back, end) {
                let (eight, bit) = (lane / LANES, lane % LANES);
                self.put(lane, cursor.y);
                for (mask, open) in self.open.iter_mut().zip(open) {
                    set(&mut mask[eight], bit, open);
                }
                self.impacts[lane] = impacts;
                self.aloft[eight] |= 1 << bit;
                self.alone[lane] = None;
            }
        }
    }

    /// The state of a motion is this from now on.
    pub fn put(&mut self, lane: usize, y: [f64; 2]) {
        for (all, y) in self.y.iter_mut().zip(y) {
            all[lane / LANES][lane % LANES] = y;
        }
    }

    /// Hands a motion to the scalar engine: it has seen everything before `from` on the cell.
    pub fn hand_over(&mut self, lane: usize, period: i64, cell: usize, y: [f64; 2], from: f64) {
        let (eight, bit) = (lane / LANES, lane % LANES);
        let open = [0, 1].map(|wall| self.open[wall][eight] >> bit & 1 == 1);
        let cursor = Cursor { period, cell, y, from };
        let aloft = Aloft { cursor, open, impacts: self.impacts[lane] };
        self.aloft[eight] &= !(1 << bit);
        self.alone[lane] = Some(self.simulators[lane].resume(aloft));
    }

    /// The same for a motion listed to be looked at on a cell: the look is not counted, as it is taken again.
    pub fn hand_back(&mut self, lane: usize, span: Span, y: [f64; 2], from: f64) {
        let row = if self.kind.driven { span.cell } else { 0 };
        let near =
            |&wall: &usize| self.kind.walls[wall] && !far(&self.tables[lane], wall, row, y, self.kind.depth);
        for wall in [LOWER, UPPER] {
            let was = self.was_open[wall][lane / LANES] >> (lane % LANES) & 1 == 1;
            set(&mut self.open[wall][lane / LANES], lane % LANES, was);
        }
        self.searches -= [LOWER, UPPER].iter().filter(|wall| near(wall)).count() as i64;
        self.looks -= 1;
        self.hand_over(lane, self.periods[lane] + span.later, span.cell, y, from);
    }

    /// The motion on the section: (q, u).
    pub fn point(&self, lane: usize) -> [f64; 2] {
        if let Some(run) = &self.alone[lane] {
            let state = run.state();
            return [state.q, state.u];
        }
        let place = &self.places[if self.places.len() == 1 { 0 } else { lane }];
        place.state([0, 1].map(|i| self.y[i][lane / LANES][lane % LANES]))
    }

    /// The same with the time there, as the scalar engine has it.
    pub fn state(&self, lane: usize) -> State {
        if let Some(run) = &self.alone[lane] {
            return State { t: run.time().phase, ..run.state() };
        }
        let ([q, u], middle) = (self.point(lane), (2 * self.cell + 1) as f64 * self.kind.half);
        let t = Time::new(self.periods[lane], middle + self.from * self.kind.half).phase;
        State { t, q, u }
    }

    /// No longer followed.
    pub fn leave(&mut self, lane: usize) {
        self.aloft[lane / LANES] &= !(1 << (lane % LANES));
        self.alone[lane] = None;
        self.followed[lane] = false;
    }

    /// The work since the last time, as the scalar engine counts it.
    pub fn tell(&mut self) {
        let (looks, searches) = (std::mem::take(&mut self.looks), std::mem::take(&mut self.searches));
        let Some(tally) = &self.tally else { return };
        let mut share = Share::of(tally);
        for (wall, effect) in [Effect::LowerGap, Effect::UpperGap].into_iter().enumerate() {
            if self.kind.walls[wall] {
                share.add(effect, looks as u64);
                share.add(Effect::Piece, looks as u64);
                share.add(Effect::Drive, if self.kind.driven { looks as u64 } else { 0 });
            }
        }
        share.add(Effect::Search, searches as u64);
    }
}

pub(super) fn set(mask: &mut u8, bit: usize, value: bool) {
    *mask = *mask & !(1 << bit) | u8::from(value) << bit;
}
