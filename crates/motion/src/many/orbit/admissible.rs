//! What tells an orbit from another solution of the equations: impacts that come in, and no other contact.
//!
//! Twice, by routes that know nothing of each other: the simulator follows each leg, with its promise to find
//! every contact deeper than the minimum depth; and the least minimum of all gaps, as a number that passes
//! through 0 where a stop is grazed, is found by the rule of the one-degree code.

use std::{
    f64::consts::{PI, TAU},
    fmt,
};

use super::{StopEquations, leg::LegPiece, rubbing::Turn, turned};
use crate::{
    error::{Error, Result},
    many::{
        LinearFlow, RealVector, State,
        contact::StopContact,
        simulate::{Event, Run, Simulator, Stage, seen},
    },
    motion::{RunEnd, Series, Time, minimum::Gap, minimum_within},
    rounding::PHASE,
};

/// A local minimum of a gap between impacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Minimum {
    /// The stop.
    pub stop: usize,
    /// The impact whose leg it is on, from 0; 0 for an orbit without impacts.
    pub leg: usize,
    /// Radians of the forcing since that leg began.
    pub after: f64,
    /// The phase, in [0, 2π].
    pub phase: f64,
    /// The gap, in the scene's unit; negative behind the stop.
    pub gap: f64,
    /// Its second derivative there, per radian squared.
    pub acceleration: f64,
}

/// How an orbit touches the stops that give way.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Touches {
    /// The least or greatest gap to one, of those between which it changes one way, that is nearest to 0:
    /// there contact without speed begins or ends.
    pub nearest: Option<Minimum>,
    /// Of each stop, how often contact begins, and whether there is any.
    pub(crate) contacts: Vec<(usize, bool)>,
}

/// How often contact begins at each stop, once round, and whether there is any.
fn begins(pieces: &[Vec<(bool, bool)>]) -> Vec<(usize, bool)> {
    let stops = pieces.first().map_or(0, Vec::len);
    let before = |i: usize| &pieces[(i + pieces.len() - 1) % pieces.len()];
    let each = |stop: usize| {
        let begun = |i: &usize| pieces[*i][stop] == (true, true) && !before(*i)[stop].0;
        ((0..pieces.len()).filter(begun).count(), pieces.iter().any(|piece| piece[stop].0))
    };
    (0..stops).map(each).collect()
}

/// Which extremes of which gaps are looked for: gaps to rigid stops, which are not negative, or to those that
/// give way; minima, or with the sign turned maxima.
#[derive(Clone, Copy)]
struct Sought {
    soft: bool,
    sign: f64,
}

impl Sought {
    const MINIMA: Sought = Sought { soft: false, sign: 1.0 };
    const TOUCHES: [Sought; 2] = [Sought { soft: true, sign: 1.0 }, Sought { soft: true, sign: -1.0 }];

    fn is_of(self, contact: &StopContact) -> bool {
        contact.soft.is_some() == self.soft
    }

    fn turned(self, gap: [f64; 3]) -> [f64; 3] {
        gap.map(|x| self.sign * x)
    }

    fn found(self, minimum: Minimum) -> Minimum {
        let Minimum { gap, acceleration, .. } = minimum;
        Minimum { gap: self.sign * gap, acceleration: self.sign * acceleration, ..minimum }
    }
}

/// Whether a solution is an orbit.
#[derive(Debug, Clone, PartialEq)]
pub enum Admissibility {
    /// Every impact comes in, and on the legs between them the simulator finds no other contact.
    Admissible,
    /// Rounding decides: why.
    Marginal(Obstacle),
    /// It is not: why.
    No(Obstacle),
}

/// What is in the way of an orbit.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Obstacle {
    /// This impact, from 0, has V ≤ 0.
    Outgoing(usize),
    /// On the leg after impact `leg` (0 for an orbit without impacts) the stop is met, after this time.
    Met {
        /// The leg.
        leg: usize,
        /// The stop's name.
        stop: String,
        /// Radians of the forcing since the leg began.
        after: f64,
    },
    /// On that leg, that stop is touched without impact.
    Touched {
        /// The leg.
        leg: usize,
        /// The stop's name.
        stop: String,
    },
    /// At this impact, from 0, several stops are met at one instant.
    Together(usize),
    /// The simulator did not follow this leg, from 0, to its end.
    Lost(usize),
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Obstacle::Outgoing(i) => write!(f, "impact {} does not come in", i + 1),
            Obstacle::Met { leg, stop, after } => {
                write!(f, "meets stop {stop} {:.6} periods into leg {}", after / TAU, leg + 1)
            }
            Obstacle::Touched { leg, stop } => {
                write!(f, "touches stop {stop} on leg {}, to rounding", leg + 1)
            }
            Obstacle::Together(i) => {
                write!(f, "impact {} meets several stops at one instant", i + 1)
            }
            Obstacle::Lost(leg) => write!(f, "leg {} could not be followed to its end", leg + 1),
        }
    }
}

impl StopEquations<'_> {
    /// Each leg by the simulator, from the state just after its impact up to the next.
    pub fn admissibility(&self, z: &[f64], simulator: &Simulator) -> Result<Admissibility> {
        let (mut state, times, speeds) = self.begun(z)?;
        let m = times.len();
        let name = |stop: usize| self.contacts.all()[stop].name.clone();
        if let Some(i) = speeds.iter().position(|speed| speed.is_nan() || *speed <= 0.0) {
            return Ok(Admissibility::No(Obstacle::Outgoing(i)));
        }
        let mut marginal = None;
        for leg in 0..m.max(1) {
            let next = if m == 0 { 0 } else { (leg + 1) % m };
            let duration = match m {
                0 => TAU * f64::from(self.pattern.periods()),
                _ => self.duration(&times, leg)?,
            };
            let begin = Time::new(0, state.t);
            let mut run = match simulator.start(begin, state.q.as_slice(), state.u.as_slice()) {
                Ok(run) => run,
                Err(_) if m == 0 => {
                    let behind = |c: &StopContact| c.soft.is_none() && c.gap(&state)[0] < 0.0;
                    let stop = self.contacts.all().iter().position(behind);
                    let stop = name(stop.unwrap_or(0));
                    return Ok(Admissibility::No(Obstacle::Met { leg, stop, after: 0.0 }));
                }
                Err(error) => return Err(error),
            };
            let (decided, touched) = self.watched(&mut run, (leg, next), begin, duration);
            if let Some(found) = decided {
                return Ok(found);
            }
            marginal = touched.or(marginal);
            // Another stop at the instant of the impact.
            if m > 0 {
                let end = self.between.after(&state, duration)?;
                let depth = simulator.settings().minimum_depth;
                let (stop, all) = (self.pattern.strikes()[next].place, self.contacts.all());
                let rigid = |other: usize| all[other].soft.is_none();
                if (0..all.len())
                    .any(|other| other != stop && rigid(other) && all[other].gap(&end)[0] <= depth)
                {
                    return Ok(Admissibility::Marginal(Obstacle::Together(next)));
                }
            }
            if m > 0 {
                state = self.between.after(&state, duration)?;
                state.t = turned(times[next]);
                state.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
            }
        }
        Ok(marginal.map_or(Admissibility::Admissible, Admissibility::Marginal))
    }

    /// A leg followed by a run of the simulator: what is decided by a contact that is not its own, and where
    /// a stop is touched.
    fn watched(
        &self,
        run: &mut Run,
        (leg, next): (usize, usize),
        begin: Time,
        duration: f64,
    ) -> (Option<Admissibility>, Option<Obstacle>) {
        let m = self.pattern.strikes().len();
        let name = |stop: usize| self.contacts.all()[stop].name.clone();
        let mut marginal = None;
        // What the legs' own impacts look like to the simulator: at an end of the leg, at the stop that
        // is hit there. Slow ones it does not see, as they are not as deep as the minimum depth; that
        // they are there is in the equations.
        let own = |stop: usize, after: f64| {
            let at = |i: usize| m > 0 && self.pattern.strikes()[i].place == stop;
            (at(leg) && after <= CLOSE) || (at(next) && duration - after <= CLOSE)
        };
        let until = begin.after(duration);
        loop {
            match run.next(until) {
                Event::Tangency(touch) if self.contacts.all()[touch.place].soft.is_some() => {}
                Event::Tangency(touch) if own(touch.place, touch.time.since(begin)) => {}
                Event::Tangency(touch) => {
                    marginal = Some(Obstacle::Touched { leg, stop: name(touch.place) });
                }
                Event::Impact(impact) => {
                    let after = impact.time.since(begin);
                    if !(m > 0 && impact.place == self.pattern.strikes()[next].place)
                        || duration - after > CLOSE
                    {
                        let stop = name(impact.place);
                        return (Some(Admissibility::No(Obstacle::Met { leg, stop, after })), marginal);
                    }
                    if impact.shock.together > 1 {
                        return (Some(Admissibility::Marginal(Obstacle::Together(next))), marginal);
                    }
                    return (None, marginal);
                }
                // Friction that sticks is no rest on a stop.
                Event::Stick(stick) if stick.place >= self.contacts.all().len() => {}
                Event::Stick(stick) => {
                    let (stop, after) = (name(stick.place), stick.time.since(begin));
                    return (Some(Admissibility::No(Obstacle::Met { leg, stop, after })), marginal);
                }
                Event::Touch(_) | Event::Release(_) | Event::Reversal(_) | Event::Kink(_) => {}
                Event::End(RunEnd::Reached) => return (None, marginal),
                Event::End(_) => {
                    return (Some(Admissibility::Marginal(Obstacle::Lost(leg))), marginal);
                }
            }
        }
    }

    /// The least of the gaps' local minima between impacts, and how stops that give way are touched.
    ///
    /// A cell is a sixteenth of the fastest period among forces, stops and the modes that still move a gap
    /// (but there are no more than 10⁶ on a leg); within one z″ is taken to change sign once at most. Cost:
    /// O(n) for each cell and stop.
    ///
    /// # Errors
    /// Legs that do not follow one another.
    pub fn extremes(&self, z: &[f64]) -> Result<(Option<Minimum>, Touches)> {
        let (mut state, times, speeds) = self.begun(z)?;
        let m = times.len();
        let mut least: Option<Minimum> = None;
        let mut nearest: Option<Minimum> = None;
        let mut contacts = Vec::new();
        let gives_way = self.contacts.all().iter().any(|contact| contact.soft.is_some());
        for leg in 0..m.max(1) {
            // Without impacts a little more than the period: a minimum at its ends counts too.
            let duration = match m {
                0 => TAU * f64::from(self.pattern.periods()) + 0.01,
                _ => self.duration(&times, leg)?,
            };
            let mut begun = 0.0;
            for piece in self.between.pieces(&state, duration)?.0 {
                let mut lower = |found: Minimum| {
                    if least.is_none_or(|least| found.gap < least.gap) {
                        least = Some(found);
                    }
                };
                self.extremes_of(&piece, (leg, begun, duration, Sought::MINIMA), &mut lower)?;
                if gives_way {
                    let mut nearer = |found: Minimum| {
                        if nearest.is_none_or(|nearest| found.gap.abs() < nearest.gap.abs()) {
                            nearest = Some(found);
                        }
                    };
                    for sought in Sought::TOUCHES {
                        self.extremes_of(&piece, (leg, begun, duration, sought), &mut nearer)?;
                    }
                    // What is beyond the period was there at its beginning.
                    if m > 0 || begun < TAU * f64::from(self.pattern.periods()) {
                        contacts.push(self.contact_at(&piece));
                    }
                }
                begun += piece.duration;
            }
            if m > 0 {
                let next = (leg + 1) % m;
                state = self.between.after(&state, duration)?;
                state.t = turned(times[next]);
                state.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
            }
        }
        Ok((least, Touches { nearest, contacts: begins(&contacts) }))
    }

    /// Of each stop, whether it pushes on a piece, and whether that can have begun there by a touch: deep in
    /// contact damping makes it push again.
    fn contact_at(&self, piece: &LegPiece) -> Vec<(bool, bool)> {
        let all = self.contacts.all().iter().enumerate();
        let touched = |contact: &StopContact| contact.gap(&piece.start)[0] >= -STILL * self.scale;
        // A stage has those with a law, too.
        let pushing = piece.stage.as_ref().map_or(&piece.pushing, |stage| &stage.pushing);
        all.map(|(stop, contact)| (pushing.contains(&stop), touched(contact))).collect()
    }

    fn extremes_of(
        &self,
        piece: &LegPiece,
        place: (usize, f64, f64, Sought),
        each: &mut impl FnMut(Minimum),
    ) -> Result<()> {
        match &piece.stage {
            Some(stage) if stage.smooth.is_some() => self.minima_by_steps(stage, piece, place, each)?,
            Some(stage) if stage.holds.stuck().next().is_some() => {
                self.minima_where_it_sticks(stage, piece, place, each);
            }
            _ => self.minima(piece, place, each)?,
        }
        if let Some(turn) = &piece.turn {
            let (leg, begun, whole, sought) = place;
            self.minima_where_it_turns(turn, (leg, begun + piece.duration, whole, sought), each);
        }
        Ok(())
    }

    /// Where forces are formulas: on each step of the motion z″ is taken to change sign once at most.
    fn minima_by_steps(
        &self,
        stage: &Stage,
        piece: &LegPiece,
        (leg, before, whole, sought): (usize, f64, f64, Sought),
        each: &mut impl FnMut(Minimum),
    ) -> Result<()> {
        let Some(smooth) = &stage.smooth else { return Ok(()) };
        let watched: Vec<(usize, &StopContact)> =
            self.contacts.all().iter().enumerate().filter(|known| sought.is_of(known.1)).collect();
        let impacts = !self.pattern.strikes().is_empty();
        let mut ends: Vec<Option<[f64; 3]>> = vec![None; watched.len()];
        let (mut time, mut state, mut begun) = (Time::new(0, piece.start.t), piece.start.clone(), 0.0);
        while begun < piece.duration {
            let leap = smooth.leap(time, &state);
            if leap.over().is_some() {
                return Err(Error::input("a leg could not be followed to its end"));
            }
            let last = ((piece.duration - begun) / leap.h).min(1.0);
            for ((stop, contact), end) in watched.iter().zip(&mut ends) {
                let (polynomial, _) = seen(&leap, &contact.gap_watch(1.0));
                let gap = |x: f64| {
                    let [z, slope, bend] = Gap::new(&polynomial, 0.0, false).at(x);
                    sought.turned([z, slope / leap.h, bend / (leap.h * leap.h)])
                };
                let b = gap(last);
                let a = end.replace(b).unwrap_or_else(|| gap(0.0));
                let width = last * leap.h;
                let Some(x) = minimum_within(|x| gap(x / leap.h), a, b, width) else { continue };
                let ([gap, _, acceleration], after) = (gap(x / leap.h), before + begun + x);
                if !impacts || after.min(whole - after) > PHASE || gap.abs() > PHASE * PHASE * self.scale {
                    let phase = turned(leap.start.phase + x);
                    each(sought.found(Minimum { stop: *stop, leg, after, phase, gap, acceleration }));
                }
            }
            begun = if last < 1.0 { piece.duration } else { begun + leap.h };
            (time, state) = (leap.time(1.0), leap.state(1.0));
        }
        Ok(())
    }

    /// Where friction changes, a gap whose rate is 0 there has a minimum between two pieces.
    fn minima_where_it_turns(
        &self,
        turn: &Turn,
        (leg, after, whole, sought): (usize, f64, f64, Sought),
        each: &mut impl FnMut(Minimum),
    ) {
        let impacts = !self.pattern.strikes().is_empty();
        for (stop, contact) in self.contacts.all().iter().enumerate().filter(|known| sought.is_of(known.1)) {
            let [gap, rate] = contact.gap(&turn.at);
            let still = rate.abs() <= STILL * self.scale;
            let bends = turn.bends().map(|bend| contact.row.dot(&bend) - contact.position.at(turn.at.t)[2]);
            let [gap, bends @ ..] = sought.turned([gap, bends[0], bends[1]]);
            let own = impacts && after.min(whole - after) <= PHASE && gap.abs() <= PHASE * PHASE * self.scale;
            if still && bends[0] > 0.0 && bends[1] >= 0.0 && !own {
                let (phase, acceleration) = (turned(turn.at.t), bends[1]);
                each(sought.found(Minimum { stop, leg, after, phase, gap, acceleration }));
            }
        }
    }

    /// Where something sticks: from the states at the ends of cells.
    fn minima_where_it_sticks(
        &self,
        stage: &Stage,
        piece: &LegPiece,
        (leg, before, whole, sought): (usize, f64, f64, Sought),
        each: &mut impl FnMut(Minimum),
    ) {
        let now = Time::new(0, piece.start.t);
        let order = stage.equations.force.order().max(self.order()).max(1);
        let fastest = stage.flow.rates().into_iter().fold(f64::from(order), f64::max);
        let cells = (piece.duration / (PI / 8.0 / fastest).max(1e-6 * piece.duration)).ceil();
        let impacts = !self.pattern.strikes().is_empty();
        for (stop, contact) in self.contacts.all().iter().enumerate().filter(|known| sought.is_of(known.1)) {
            let seen = |after: f64| {
                let state = State { t: now.after(after).phase, ..stage.after(now, &piece.start, after) };
                let [gap, rate] = contact.gap(&state);
                let bend = stage.acceleration(Time::new(0, state.t), &state);
                sought.turned([gap, rate, contact.row.dot(&bend) - contact.position.at(state.t)[2]])
            };
            let width = piece.duration / cells;
            let mut a = seen(0.0);
            for cell in 0..cells as u64 {
                let begun = cell as f64 * width;
                let b = seen(begun + width);
                if let Some(x) = minimum_within(|x| seen(begun + x), a, b, width) {
                    let ([gap, _, acceleration], own) = (seen(begun + x), begun + x);
                    let after = before + own;
                    if !impacts || after.min(whole - after) > PHASE || gap.abs() > PHASE * PHASE * self.scale
                    {
                        let phase = turned(now.after(own).phase);
                        each(sought.found(Minimum { stop, leg, after, phase, gap, acceleration }));
                    }
                }
                a = b;
            }
        }
    }

    fn minima(
        &self,
        piece: &LegPiece,
        (leg, before, whole, sought): (usize, f64, f64, Sought),
        each: &mut impl FnMut(Minimum),
    ) -> Result<()> {
        let (flow, from, duration) = (&piece.flow, &piece.start, piece.duration);
        let equations = flow.equations();
        let own = |stop: &usize| sought.is_of(&self.contacts.all()[*stop]);
        let watched: Vec<usize> = (0..self.contacts.all().len()).filter(own).collect();
        if watched.is_empty() {
            return Ok(());
        }
        let sights = self.sights(flow, &watched)?;
        let rates = flow.rates();
        let pairs = flow.pairs().is_some();
        let slowest = equations.force.order().max(self.order()).max(1);
        // The fastest rate of a motion that a gap feels.
        let fastest = |y: &RealVector| {
            let felt = |i: usize| {
                let [a, b] = [2 * i, 2 * i + 1];
                let size = y[a].abs().max(y[b].abs()) * (1.0f64).max(1.0 / rates[i].max(f64::MIN_POSITIVE));
                sights.iter().any(|sight| {
                    let seen = sight.rows[0][a].abs().max(sight.rows[0][b].abs());
                    seen * size > 1e-13 * self.scale
                })
            };
            let all = rates.iter().enumerate().filter(|(i, _)| !pairs || felt(*i));
            all.map(|(_, rate)| *rate).fold(f64::from(slowest), f64::max)
        };
        let (mut y, mut t, mut begun) = (flow.split(from), from.t, 0.0);
        if t >= TAU {
            t = 0.0;
            y = flow.split(&State { t, ..from.clone() });
        }
        let impacts = !self.pattern.strikes().is_empty();
        // The end of a cell is the beginning of the next, to the bit: no minimum falls between them, not even
        // where a period ends.
        let mut ends: Vec<Option<[f64; 3]>> = vec![None; sights.len()];
        while begun < duration {
            let width = (PI / 8.0 / fastest(&y)).max(1e-6 * duration).min(duration - begun).min(TAU - t);
            let motion = |x: f64| {
                let mut at = y.clone();
                flow.advance(&mut at, x);
                at + flow.particular((t + x).min(TAU))
            };
            let (first, last) = (motion(0.0), motion(width));
            for (i, (&stop, sight)) in watched.iter().zip(&sights).enumerate() {
                let seen = |motion: &RealVector, x: f64| sought.turned(sight.gap(motion, t + x));
                let b = seen(&last, width);
                let a = ends[i].replace(b).unwrap_or_else(|| seen(&first, 0.0));
                let Some(x) = minimum_within(|x| seen(&motion(x), x), a, b, width) else { continue };
                let ([gap, _, acceleration], after) = (seen(&motion(x), x), before + begun + x);
                // A leg that begins or ends without speed has a minimum there, which rounding may bring
                // inside.
                if !impacts || after.min(whole - after) > PHASE || gap.abs() > PHASE * PHASE * self.scale {
                    let phase = turned(t + x);
                    each(sought.found(Minimum { stop, leg, after, phase, gap, acceleration }));
                }
            }
            flow.advance(&mut y, width);
            (t, begun) = (t + width, begun + width);
            if t >= TAU {
                y += flow.step();
                t = 0.0;
            }
        }
        Ok(())
    }

    /// The gaps of these stops as the flow sees them.
    fn sights(&self, flow: &LinearFlow, stops: &[usize]) -> Result<Vec<Sight<'_>>> {
        let (equations, zero) = (flow.equations(), RealVector::zeros(self.size()));
        let sight = |&stop: &usize| {
            let (contact, push) = (&self.contacts.all()[stop], self.contacts.push(stop));
            let (places, rates) = (-equations.stiffness.tr_mul(push), -equations.damping.tr_mul(push));
            Ok(Sight {
                rows: [
                    flow.seen(&contact.row, &zero),
                    flow.seen(&zero, &contact.row),
                    flow.seen(&places, &rates),
                ],
                force: equations.force.series(push)?,
                position: &contact.position,
            })
        };
        stops.iter().map(sight).collect()
    }

    /// The highest harmonic of the stops' motions.
    fn order(&self) -> u32 {
        self.contacts.all().iter().map(|contact| contact.position.order()).max().unwrap_or(0)
    }
}

/// A gap and its derivatives in the flow's own coordinates.
struct Sight<'c> {
    /// Of z, z′ and z″, but for the force and the stop's place.
    rows: [RealVector; 3],
    /// w M⁻¹ f.
    force: Series,
    position: &'c Series,
}

impl Sight<'_> {
    /// (z, z′, z″).
    fn gap(&self, motion: &RealVector, t: f64) -> [f64; 3] {
        let ([place, speed, bend], [force, ..]) = (self.position.at(t), self.force.at(t));
        let [z, rate, turn] = self.rows.each_ref().map(|row| row.dot(motion));
        [z - place, rate - speed, turn + force - bend]
    }
}

/// A gap's rate below this part of the unit of speeds is rounding's where friction has stopped it.
const STILL: f64 = 1e-9;

/// A contact that the simulator sees this near an end of a leg, at the stop hit there, is that impact.
const CLOSE: f64 = 1e-5;
