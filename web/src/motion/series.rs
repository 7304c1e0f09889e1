//! One motion as it is drawn: a quantity and its rate over time, walls, and what happened at them.

use std::f64::consts::TAU;

use grazing_scenes::{
    Result,
    motion::Time,
    run::{Keeper, SeriesOf, SeriesPoint, SeriesStop, StopEvent},
};
use serde_json::{Value, json};

/// What is drawn: a coordinate, or the gap to a stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Seen {
    /// The displacement of this coordinate, from 0; of one alone, its stops too.
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

/// Takes the points of a motion and its events, in the order of time.
#[derive(Debug)]
pub struct Series {
    seen: Seen,
    stops: Vec<SeriesStop>,
    names: Vec<String>,
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
    /// Nothing yet, of a motion of which `seen` is drawn.
    pub fn new(seen: Seen) -> Series {
        Series {
            seen,
            stops: Vec::new(),
            names: Vec::new(),
            positions: Vec::new(),
            times: Vec::new(),
            places: Vec::new(),
            rates: Vec::new(),
            sampled: Vec::new(),
            strikes: Vec::new(),
            last: Vec::new(),
        }
    }

    fn point(&mut self, time: f64, place: f64, rate: f64) {
        self.times.push(time);
        self.places.push(place);
        self.rates.push(rate);
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
    fn begin(&mut self, of: &SeriesOf) -> Result<()> {
        let walls = match self.seen {
            Seen::Gap(_) => 1,
            Seen::Coordinate(_) => of.stops.iter().filter(|stop| stop.along.is_some()).count(),
        };
        (self.stops, self.names, self.positions) = (of.stops.clone(), of.places(), vec![Vec::new(); walls]);
        Ok(())
    }

    fn sample(&mut self, sample: &SeriesPoint) -> Result<()> {
        let time = sample.time.periods();
        self.last = sample.q.iter().chain(sample.u).copied().collect();
        let (place, rate) = match self.seen {
            Seen::Gap(stop) => match sample.gaps.get(stop) {
                Some(&[gap, rate]) => (gap, rate),
                None => return Ok(()),
            },
            Seen::Coordinate(i) => match sample.q.get(i).zip(sample.u.get(i)) {
                Some((&q, &u)) => (q, u),
                None => return Ok(()),
            },
        };
        self.point(time, place, rate);
        self.sampled.push(time);
        for (i, row) in self.positions.iter_mut().enumerate() {
            row.push(match self.seen {
                Seen::Gap(_) => 0.0,
                Seen::Coordinate(_) => place - sample.gaps[i][0] / self.stops[i].along.unwrap_or(1.0),
            });
        }
        Ok(())
    }

    fn event(&mut self, event: &StopEvent) -> Result<()> {
        let (time, along) = (event.time.periods(), self.stops.get(event.stop).and_then(|stop| stop.along));
        // Of a coordinate among several nothing is known here but that there was an impact.
        let drawn = match (self.seen, event.place, along) {
            (Seen::Gap(stop), ..) if stop == event.stop => Some(([0.0; 2], 1.0)),
            (Seen::Coordinate(_), Some(place), Some(along)) => Some((place, along)),
            _ => None,
        };
        let at = drawn.map_or_else(|| self.places.last().copied().unwrap_or(f64::NAN), |([at, _], _)| at);
        if let (Some(([_, speed], along)), Some(velocity)) = (drawn, event.velocity) {
            self.point(time, at, speed + velocity / along);
            match event.leaving {
                Some(leaving) => self.point(time, at, speed + leaving / along),
                // The velocity after it depends on all stops that took part: the curve begins anew.
                None if event.event == "impact" => self.point(time, f64::NAN, f64::NAN),
                None => {}
            }
        }
        let (kind, wall) = (event.event, self.names[event.stop].clone());
        let speed = event.velocity.map(|velocity| -velocity);
        self.strikes.push(Strike { kind, time: event.time, wall, at, speed });
        Ok(())
    }
}
