//! One motion as it is drawn: a quantity and its rate over time, walls, and what happened at them.

use std::f64::consts::TAU;

use grazing::{
    Result,
    many::{Machine, MachineState, contact::StopContact},
    motion::{Contact, Event, Side, State, Time},
    run::{Job, Keeper, Model},
};
use serde_json::{Value, json};

/// What of a machine is drawn: a coordinate, or the gap to a stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Seen {
    /// The displacement of this coordinate, from 0.
    Coordinate(usize),
    /// The gap of this stop, from 0.
    Gap(usize),
}

/// An impact, or what else happened at a wall.
#[derive(Debug, Clone, PartialEq)]
pub struct Strike {
    /// "impact", "tangency", "touch", "stick" or "release".
    pub kind: &'static str,
    /// When.
    pub time: Time,
    /// The wall's side, or the stop's name.
    pub wall: String,
    /// The drawn quantity there.
    pub at: f64,
    /// The incoming relative speed of an impact, in the scene's units.
    pub speed: Option<f64>,
}

/// Takes the points of a motion, oscillator or machine, and its events, in the order of time.
#[derive(Debug)]
pub struct Series {
    seen: Option<Seen>,
    walls: Vec<Contact>,
    stops: Vec<StopContact>,
    machine: Option<Machine<f64>>,
    /// Times in forcing periods, the quantity, its rate; at an impact there are two points, before and after.
    pub times: Vec<f64>,
    /// The quantity.
    pub places: Vec<f64>,
    /// Its rate.
    pub rates: Vec<f64>,
    /// For each wall, where it is at every sample.
    pub positions: Vec<Vec<f64>>,
    /// When the walls were looked at.
    pub sampled: Vec<f64>,
    /// What happened.
    pub strikes: Vec<Strike>,
    /// Where the motion is last.
    pub last: Vec<f64>,
}

impl Series {
    /// Nothing yet, of the job's motion; of a machine, `seen` is drawn.
    ///
    /// # Errors
    /// Those of the machine's stops.
    pub fn new(job: &Job, seen: Seen) -> Result<Series> {
        let (walls, stops, machine) = match &job.model {
            Model::Oscillator(system) => (Contact::of(system)?, Vec::new(), None),
            Model::Machine(machine) => (Vec::new(), machine.contacts()?, Some(machine.clone())),
        };
        let rows = if machine.is_some() { usize::from(matches!(seen, Seen::Gap(_))) } else { walls.len() };
        Ok(Series {
            seen: machine.is_some().then_some(seen),
            positions: vec![Vec::new(); rows],
            walls,
            stops,
            machine,
            times: Vec::new(),
            places: Vec::new(),
            rates: Vec::new(),
            sampled: Vec::new(),
            strikes: Vec::new(),
            last: Vec::new(),
        })
    }

    fn point(&mut self, time: f64, place: f64, rate: f64) {
        self.times.push(time);
        self.places.push(place);
        self.rates.push(rate);
    }

    /// Velocities per unit of time are this many times those per radian of the forcing.
    fn rate(&self) -> f64 {
        self.machine.as_ref().map_or(1.0, Machine::rate)
    }

    /// The impacts, contacts with stops that give way among them.
    pub fn impacts(&self) -> impl Iterator<Item = &Strike> {
        self.strikes.iter().filter(|strike| matches!(strike.kind, "impact" | "touch"))
    }

    /// As the page draws it.
    pub fn json(&self) -> Value {
        let strikes: Vec<Value> = self
            .strikes
            .iter()
            .map(|strike| {
                json!({
                    "kind": strike.kind,
                    "time": strike.time.periods(),
                    "phase": strike.time.phase / TAU,
                    "wall": strike.wall,
                    "at": strike.at,
                    "speed": strike.speed,
                })
            })
            .collect();
        json!({
            "times": self.times,
            "places": self.places,
            "rates": self.rates,
            "sampled": self.sampled,
            "walls": self.positions,
            "strikes": strikes,
        })
    }
}

impl Keeper for Series {
    fn sample(&mut self, time: Time, state: State) -> Result<()> {
        self.point(time.periods(), state.q, state.u);
        self.sampled.push(time.periods());
        for (row, wall) in self.positions.iter_mut().zip(&self.walls) {
            row.push(wall.position.at(time.phase)[0]);
        }
        self.last = vec![state.q, state.u];
        Ok(())
    }

    fn event(&mut self, event: &Event<Side>) -> Result<()> {
        let Some((time, side)) = event.at() else { return Ok(()) };
        let Some(wall) = self.walls.iter().find(|wall| wall.side == side) else { return Ok(()) };
        let [at, slope, _] = wall.position.at(time.phase);
        let (kind, speed) = (event.word(), event.velocity().map(|velocity| -velocity));
        if let Some(speed) = speed {
            let (sign, restitution) = (side.sign(), wall.restitution);
            self.point(time.periods(), at, slope - sign * speed);
            self.point(time.periods(), at, slope + sign * restitution * speed);
        }
        self.strikes.push(Strike { kind, time, wall: side.name().into(), at, speed });
        Ok(())
    }

    fn machine_sample(&mut self, time: Time, state: &MachineState) -> Result<()> {
        let Some(machine) = &self.machine else { return Ok(()) };
        let rate = machine.rate();
        let (q, u) = (machine.seen(&state.q), machine.seen(&state.u) * rate);
        let here = match self.seen {
            Some(Seen::Gap(stop)) => self.stops.get(stop).map(|stop| {
                let [gap, slope] = stop.gap(&MachineState { t: time.phase, ..state.clone() });
                [gap, slope * rate]
            }),
            Some(Seen::Coordinate(i)) => q.get(i).zip(u.get(i)).map(|(&q, &u)| [q, u]),
            None => None,
        };
        self.last = q.iter().chain(&u).copied().collect();
        if let Some([place, slope]) = here {
            self.point(time.periods(), place, slope);
            self.sampled.push(time.periods());
            for row in &mut self.positions {
                row.push(0.0);
            }
        }
        Ok(())
    }

    fn machine_event(&mut self, event: &Event<usize>) -> Result<()> {
        let Some((time, stop)) = event.at() else { return Ok(()) };
        let rate = self.rate();
        let (kind, velocity) = (event.word(), event.velocity());
        // Of the motion itself nothing is known here but the gap of this stop.
        let drawn = self.seen == Some(Seen::Gap(stop));
        let at = if drawn { 0.0 } else { self.places.last().copied().unwrap_or(f64::NAN) };
        if let (true, Some(velocity)) = (drawn, velocity) {
            self.point(time.periods(), 0.0, velocity * rate);
            if kind == "impact" {
                // The velocity after it depends on all stops that took part: the curve begins anew.
                self.point(time.periods(), f64::NAN, f64::NAN);
            }
        }
        let wall = self.stops[stop].name.clone();
        let speed = velocity.map(|velocity| -velocity * rate);
        self.strikes.push(Strike { kind, time, wall, at, speed });
        Ok(())
    }
}
