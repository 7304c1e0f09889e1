//! Following a curve: step control, events between points, and why it ended.

use std::{
    cell::RefCell,
    f64::consts::{PI, TAU},
};

use super::{
    Bifurcation, Options,
    between::{cubic, root},
    curve::{Corrector, Curve, CurvePoint, difference, dot, norm},
};
use crate::error::{Error, Result};

/// A curve that is looked at along the way.
pub trait Followed: Curve {
    /// What is known of a point.
    type View;

    /// Looks at a point.
    ///
    /// # Errors
    /// An input error where that is not possible; the step is then halved.
    fn view(&self, place: &CurvePoint) -> Result<Self::View>;

    /// Functions along the curve, as many at every point: where one changes sign is an event. `None` where
    /// one is not defined.
    fn monitors(&self, place: &CurvePoint, view: &Self::View) -> Vec<Option<f64>>;

    /// One of them. A curve that has it without the view does not look at the point.
    ///
    /// # Errors
    /// As [`view`](Self::view).
    fn monitor(&self, which: usize, place: &CurvePoint) -> Result<Option<f64>> {
        Ok(self.monitors(place, &self.view(place)?)[which])
    }

    /// Whether the point is what the curve is followed for. Where that changes, a monitor changes sign.
    fn holds(&self, view: &Self::View) -> bool;

    /// Whether two neighbouring points are so far apart that a monitor may have had two zeros between them:
    /// the step is then halved, down to the least one.
    fn leaps(&self, _before: &Self::View, _after: &Self::View) -> bool {
        false
    }

    /// Whether something happens between two points that no function's zero tells.
    fn differs(&self, _before: &Self::View, _after: &Self::View) -> bool {
        false
    }

    /// Whether the curve may have a corner between two points.
    fn bends(&self, _before: &Self::View, _after: &Self::View) -> bool {
        false
    }

    /// What differs, of two points next to one another: the number of an event.
    fn changed(&self, _before: &Self::View, _after: &Self::View) -> usize {
        0
    }

    /// The unknowns that have bounds, with them.
    fn bounds(&self) -> Vec<(usize, f64, f64)>;

    /// Whether an unknown is a time in radians of the forcing: all of them moved by one number of whole
    /// periods are the same point.
    fn is_time(&self, _unknown: usize) -> bool {
        false
    }

    /// Whether what the curve is followed for comes again beyond an event, in opposite order; `beside` are
    /// points before and after it.
    fn repeats(&self, _event: &CurvePoint, _beside: [&CurvePoint; 2]) -> bool {
        false
    }

    /// The event that a monitor's zero is, its point as exactly as it can be had; none if it is a pole or
    /// nothing happens there.
    ///
    /// # Errors
    /// An input error where the point cannot be looked at.
    fn settle(&self, monitor: usize, place: CurvePoint, view: Self::View) -> Result<Settled<Self::View>> {
        Ok(Some((monitor, place, view)))
    }
}

/// An event: the number of its monitor, the point, what is known of it.
pub(crate) type Settled<V> = Option<(usize, CurvePoint, V)>;

/// A point that the curve was followed through.
#[derive(Debug, Clone)]
pub struct Step<V> {
    /// The point.
    pub place: CurvePoint,
    /// What is known of it.
    pub view: V,
    /// The number of the monitor that is zero here.
    pub event: Option<usize>,
    /// The curve's length from the start, along chords.
    pub length: f64,
}

/// Why a curve was followed no further.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum CurveEnd {
    /// An unknown is at its bound.
    Bound,
    /// The curve is no longer what it was followed for.
    Fails,
    /// It is back where it started.
    Closed,
    /// Beyond it the same orbits come again, each a number of periods later: the end of a doubled branch at
    /// its flip.
    Repeats,
    /// As many points as were allowed.
    Points,
    /// It starts there.
    Start,
    /// What was looked for is there.
    Found,
    /// As far as was asked for.
    Reach,
    /// On a curve of grazings: an impact of the orbits loses its speed at these parameters, by extrapolation.
    Fades(Vec<f64>),
    /// Even the shortest step could not be taken.
    Lost(String),
}

/// The points from `start` on in the direction of its tangent, the start first, and why there are no more.
/// Where a monitor comes so near to zero that it would be past it at the pace of the next step or of the one
/// before, steps are shortened, to a part of `most_step`: within so short a step two events of one monitor
/// may go unseen.
///
/// # Errors
/// An input error if the start itself cannot be looked at.
pub fn follow<C: Followed>(
    curve: &C,
    start: CurvePoint,
    options: &Options,
) -> Result<(Vec<Step<C::View>>, CurveEnd)> {
    follow_until(curve, start, options, |_| None)
}

/// The same, ended after the first point for which `stop` gives a reason.
///
/// # Errors
/// As [`follow`].
pub(crate) fn follow_until<C: Followed>(
    curve: &C,
    start: CurvePoint,
    options: &Options,
    stop: impl Fn(&Step<C::View>) -> Option<CurveEnd>,
) -> Result<(Vec<Step<C::View>>, CurveEnd)> {
    let view = curve.view(&start)?;
    let origin = start.clone();
    let mut walk = Walk { curve, corrector: options.corrector(), options, behind: None, back: None };
    let mut steps = vec![Step { place: start, view, event: None, length: 0.0 }];
    let (mut h, mut points, mut first) = (options.step, 1u32, FirstStep::Shorter);
    let (mut before, mut last) = (0, 0);
    loop {
        if points == options.points {
            return Ok((steps, CurveEnd::Points));
        }
        let here = steps.last().unwrap_or_else(|| unreachable!("the start is there"));
        let (new, next, end) = match walk.advance(here, h) {
            Ok(found) => found,
            Err(error) => match (points == 1).then(|| first.after(h, options)).flatten() {
                Some(other) => {
                    h = other;
                    continue;
                }
                None if points > 1 && h / 2.0 >= options.least_step => {
                    h /= 2.0;
                    continue;
                }
                None => return Ok((steps, CurveEnd::Lost(error.to_string()))),
            },
        };
        if let Some(shorter) = walk.back.take() {
            steps.truncate(before + 1);
            (h, points, last, walk.behind) = (shorter, points - 1, before, None);
            continue;
        }
        // A start inside the step just made, and close to the curve there: the curve is closed.
        if let Some(Step { place: to, .. }) = new.last()
            && points > 2
        {
            let from = &here.place;
            let origin = beside(curve, &origin.u, &from.u);
            let ahead = dot(&difference(&origin, &from.u), &from.tangent);
            if ahead > 0.0
                && dot(&difference(&to.u, &origin), &from.tangent) >= 0.0
                && let Ok(there) = walk.corrector.step(curve, from, ahead)
                && norm(&difference(&there.u, &origin)) < 1e-6 * (1.0 + norm(&origin))
            {
                return Ok((steps, CurveEnd::Closed));
            }
        }
        for step in new {
            let stopped = stop(&step);
            steps.push(step);
            if let Some(end) = stopped {
                return Ok((steps, end));
            }
        }
        points += 1;
        (before, last) = (last, steps.len() - 1);
        if let Some(end) = end {
            return Ok((steps, end));
        }
        h = next;
    }
}

/// The point u with its times moved by the number of whole periods that brings it nearest to another.
fn beside(curve: &impl Followed, u: &[f64], other: &[f64]) -> Vec<f64> {
    let apart: Vec<f64> =
        (0..u.len()).filter(|i| curve.is_time(*i)).map(|i| (other[i] - u[i]) / TAU).collect();
    let turns = (apart.iter().sum::<f64>() / apart.len().max(1) as f64).round();
    let moved = |(i, u): (usize, &f64)| if curve.is_time(i) { u + TAU * turns } else { *u };
    u.iter().enumerate().map(moved).collect()
}

/// Lengths to try for a first step. Where the start is a point at which curves cross, a shorter step comes
/// nearer to the singular point: then longer ones are tried too.
enum FirstStep {
    Shorter,
    Longer,
}

impl FirstStep {
    /// The length to try after h failed.
    fn after(&mut self, h: f64, options: &Options) -> Option<f64> {
        match self {
            FirstStep::Shorter if h / 2.0 >= options.least_step => Some(h / 2.0),
            FirstStep::Shorter => {
                *self = FirstStep::Longer;
                Some(2.0 * options.step).filter(|h| *h <= options.most_step)
            }
            FirstStep::Longer => Some(2.0 * h).filter(|h| *h <= options.most_step),
        }
    }
}

struct Walk<'a, C> {
    curve: &'a C,
    corrector: Corrector,
    options: &'a Options,
    /// What the step before began with.
    behind: Option<Behind>,
    /// The length to try where the step before has to be taken again.
    back: Option<f64>,
}

/// The monitors at a point before the one that is stepped from, and how far behind that is.
type Behind = (f64, Vec<Option<f64>>);

/// What monitors tell of a step.
struct Zeros {
    /// How far, which, where.
    found: Vec<(f64, usize, CurvePoint)>,
    /// Where it begins, seen from its end.
    behind: Behind,
    /// Their values at its end.
    after: Vec<Option<f64>>,
}

/// The new points of a step, the length to try next, and the end if it came.
type Advance<V> = (Vec<Step<V>>, f64, Option<CurveEnd>);

impl<C: Followed> Walk<'_, C> {
    fn advance(&mut self, here: &Step<C::View>, h: f64) -> Result<Advance<C::View>> {
        self.back = None;
        let ahead: Vec<f64> = here.place.u.iter().zip(&here.place.tangent).map(|(u, t)| u + h * t).collect();
        let bounds = self.curve.bounds();
        let leads_out = |u: &[f64]| {
            let beyond = |&(unknown, low, high): &(usize, f64, f64)| {
                let (before, after) = (here.place.u[unknown], u[unknown]);
                (before <= low && after < before) || (before >= high && after > before)
            };
            bounds.iter().any(beyond)
        };
        if leads_out(&ahead) {
            // It starts at the bound.
            return Ok((vec![], h, Some(CurveEnd::Bound)));
        }
        let (reach, place, end) = match self.corrector.step(self.curve, &here.place, h) {
            Ok(place) if leads_out(&place.u) => return Ok((vec![], h, Some(CurveEnd::Bound))),
            Ok(place) => match self.at_bound(here, &place.u)? {
                Some((reach, place)) => (reach, place, Some(CurveEnd::Bound)),
                None => (h, place, None),
            },
            // Beyond a bound there may be no equations: its point is found in it, from the tangent.
            Err(error) => match self.at_bound(here, &ahead)? {
                Some((reach, place)) => (reach, place, Some(CurveEnd::Bound)),
                None => return Err(error),
            },
        };
        let turned = dot(&place.tangent, &here.place.tangent).clamp(-1.0, 1.0).acos();
        let view = self.curve.view(&place)?;
        // At a corner it may turn as much as it likes, but not back.
        let corner = self.curve.bends(&here.view, &view);
        if turned > self.options.turn && !(corner && turned < 0.5 * PI) {
            return Err(Error::input(format!("the curve turns by {turned:.2} within the shortest step")));
        }
        // Beside a crossing Newton's method may end on the other curve, of orbits that repeat sooner.
        let hops = self.curve.repeats(&place, [&here.place; 2]);
        if (hops || self.curve.leaps(&here.view, &view)) && h / 2.0 >= self.options.least_step {
            return Err(Error::input("events may lie closer together than the shortest step"));
        }
        let Zeros { found, behind, after } = self.events(here, &place, &view, reach)?;
        if let Some((back, values)) = &self.behind {
            let finest = FINEST * self.options.most_step;
            if reach > finest && passes(values, *back, &behind.1, reach, &after) {
                return Err(Error::input("events may lie closer together than the shortest step"));
            }
            if *back > finest && passes(&after, reach, &behind.1, *back, values) {
                self.back = Some(back / 2.0);
            }
        }
        let mut events: Vec<(f64, Told, CurvePoint)> =
            found.into_iter().map(|(at, which, place)| (at, Told::Zero(which), place)).collect();
        if self.curve.differs(&here.view, &view) {
            self.changes(here, (&place, &view), reach, &mut events)?;
        }
        events.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Where both are one event it is the zero, which is known better.
        for i in 1..events.len() {
            let both = events[i].0 - events[i - 1].0 <= BESIDE * reach;
            if both && matches!((events[i - 1].1, events[i].1), (Told::Change(_), Told::Zero(_))) {
                events.swap(i - 1, i);
            }
        }
        let (mut steps, foot_end) = (Vec::new(), place.clone());
        let length = |place: &CurvePoint| here.length + norm(&difference(&place.u, &here.place.u));
        for index in 0..events.len() {
            let (at, event, place) = events[index].clone();
            let view = self.curve.view(&place)?;
            let settled = match event {
                Told::Zero(which) => self.curve.settle(which, place, view)?,
                Told::Change(event) => Some((event, place, view)),
            };
            if let Some((event, place, view)) = settled {
                let ends = self.curve.repeats(&place, [&here.place, &foot_end]);
                let step = Step { length: length(&place), place, view, event: Some(event) };
                // Two monitors may vanish together at one event.
                if !steps.iter().any(|known: &Step<C::View>| same(known, &step)) {
                    steps.push(step);
                }
                if ends {
                    return Ok((steps, h, Some(CurveEnd::Repeats)));
                }
            }
            // What holds after the event is asked halfway to the next.
            let beyond = events.get(index + 1).map_or(reach, |next| next.0);
            let part = (at + (beyond - at) / 2.0) / reach;
            let middle = self.between(&here.place, &foot_end, &here.place.tangent, part)?;
            if !self.options.beyond && !self.curve.holds(&self.curve.view(&middle)?) {
                return Ok((steps, h, Some(CurveEnd::Fails)));
            }
        }
        if !self.options.beyond && !self.curve.holds(&view) {
            if here.length == 0.0 && h / 2.0 < self.options.least_step {
                return Ok((vec![], h, Some(CurveEnd::Fails)));
            }
            return Err(Error::input("the curve ends, and no labelled event says why"));
        }
        // Four Newton steps are about right, and a turn of half of what is allowed.
        let wanted = 2f64.powf((4.0 - f64::from(place.steps)) / 2.0);
        let straight = 0.7 * self.options.turn / turned.max(1e-9);
        let next =
            (h * wanted.min(straight).clamp(0.3, 2.0)).clamp(self.options.least_step, self.options.most_step);
        steps.push(Step { length: length(&place), place, view, event: None });
        self.behind = Some(behind);
        Ok((steps, next, end))
    }

    /// The point of the curve at the first bound between a point inside and `ahead`, and how far along the
    /// tangent it is; none if there is no bound between.
    fn at_bound(&self, here: &Step<C::View>, ahead: &[f64]) -> Result<Option<(f64, CurvePoint)>> {
        let from = &here.place;
        let crossed = self.curve.bounds().into_iter().filter_map(|(unknown, low, high)| {
            let (before, after) = (from.u[unknown], ahead[unknown]);
            let bound = match () {
                () if after < low && low < before => low,
                () if after > high && high > before => high,
                () => return None,
            };
            Some(((bound - before) / (after - before), unknown, bound))
        });
        let Some((part, unknown, bound)) = crossed.min_by(|a, b| a.0.total_cmp(&b.0)) else {
            return Ok(None);
        };
        let mut guess: Vec<f64> = from.u.iter().zip(ahead).map(|(u, v)| u + part * (v - u)).collect();
        guess[unknown] = bound;
        let mut normal = vec![0.0; guess.len()];
        normal[unknown] = 1.0;
        let mut place = self.corrector.correct(self.curve, &guess, &normal)?;
        place.u[unknown] = bound;
        if dot(&place.tangent, &from.tangent) < 0.0 {
            place = place.reversed();
        }
        let reach = dot(&difference(&place.u, &from.u), &from.tangent);
        let whole = dot(&difference(ahead, &from.u), &from.tangent);
        if !(reach > 0.0 && reach <= 2.0 * whole) {
            return Err(Error::input("no point at the bound"));
        }
        Ok(Some((reach, place)))
    }

    /// The point at the fraction s of the way from a to b, along `normal`, guessed so near that Newton's
    /// method keeps to this curve where another crosses.
    fn between(&self, a: &CurvePoint, b: &CurvePoint, normal: &[f64], s: f64) -> Result<CurvePoint> {
        self.corrector.correct(self.curve, &cubic(a, b, normal, s), normal)
    }

    /// The zero of a function close to h, where the equations are so nearly singular that no point can be
    /// had: from the points on either side.
    fn across(
        &self,
        at: impl Fn(f64) -> Result<(Option<f64>, CurvePoint)>,
        h: f64,
        reach: f64,
    ) -> Result<(f64, CurvePoint)> {
        let aside = 1e-2 * reach;
        let ((Some(x), a), (Some(y), b)) = (at(h - aside)?, at(h + aside)?) else {
            return Err(Error::input("an event where it is not defined"));
        };
        let part = x / (x - y);
        let u = cubic(&a, &b, &a.tangent, part);
        let mut tangent: Vec<f64> =
            a.tangent.iter().zip(&b.tangent).map(|(a, b)| a + part * (b - a)).collect();
        let length = norm(&tangent);
        tangent.iter_mut().for_each(|t| *t /= length);
        let residual = self.curve.equations(&u)?.residual.iter().fold(0.0, |most: f64, f| most.max(f.abs()));
        Ok((h + aside * (2.0 * part - 1.0), CurvePoint { u, tangent, residual, steps: 0 }))
    }

    /// Where what differs at the ends of a step changes, by bisection.
    fn changes(
        &self,
        here: &Step<C::View>,
        (place, view): (&CurvePoint, &C::View),
        reach: f64,
        events: &mut Vec<(f64, Told, CurvePoint)>,
    ) -> Result<()> {
        let mut known = vec![(0.0, here.place.clone()), (reach, place.clone())];
        let (mut begin, mut first) = (0.0, None);
        for _ in 0..MOST_CHANGES {
            let before = first.as_ref().unwrap_or(&here.view);
            if !self.curve.differs(before, view) {
                return Ok(());
            }
            let (mut low, mut high) = (begin, reach);
            let (mut below, mut above) = (None, None);
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (low + high);
                if middle <= low || middle >= high {
                    break;
                }
                // So near a corner Newton's method may not end: the change is in between.
                let Ok(point) = self.near(&known, &here.place.tangent, middle) else { break };
                let Ok(seen) = self.curve.view(&point) else { break };
                known.insert(known.partition_point(|known| known.0 < middle), (middle, point.clone()));
                let side = Some((point, seen));
                if side.as_ref().is_some_and(|(_, seen)| self.curve.differs(before, seen)) {
                    (high, above) = (middle, side);
                } else {
                    (low, below) = (middle, side);
                }
            }
            let last =
                |side: &'_ Option<(CurvePoint, C::View)>| side.as_ref().map(|(point, _)| point.clone());
            let from = last(&below).or_else(|| known.first().map(|known| known.1.clone()));
            let to = last(&above).unwrap_or_else(|| place.clone());
            // A jump of the orbit is the end of its curve.
            let jump = from.map_or(0.0, |from| norm(&difference(&to.u, &from.u)));
            if jump > JUMP * (1.0 + norm(&to.u)) {
                return Err(Error::input(
                    "what sticks and slides changes here, and the orbit beyond is another one: the motion jumps",
                ));
            }
            let event = {
                let before = below.as_ref().map_or(before, |(_, seen)| seen);
                self.curve.changed(before, above.as_ref().map_or(view, |(_, seen)| seen))
            };
            // What changes at several places of an orbit at once is one event, by the name that says more.
            let one = |known: usize| known.max(event) == Bifurcation::FrictionChange as usize;
            match events.last_mut() {
                Some((at, Told::Change(known), _)) if high - *at <= BESIDE * reach && one(*known) => {
                    *known = event.min(*known);
                }
                _ => events.push((high, Told::Change(event), to)),
            }
            let Some((_, seen)) = above else { return Ok(()) };
            (begin, first) = (high, Some(seen));
        }
        Err(Error::input("what sticks and slides changes too often within the shortest step"))
    }

    /// The events within `reach` of a point.
    fn events(&self, here: &Step<C::View>, place: &CurvePoint, view: &C::View, reach: f64) -> Result<Zeros> {
        let after = self.curve.monitors(place, view);
        // The points of the step that are known, in order: the nearest two are guessed from.
        let known = RefCell::new(vec![(0.0, here.place.clone()), (reach, place.clone())]);
        let at = |which: usize, h: f64| -> Result<(Option<f64>, CurvePoint)> {
            let mut known = known.borrow_mut();
            let place = self.near(&known, &here.place.tangent, h)?;
            let next = known.partition_point(|known| known.0 < h);
            if known.get(next).is_some_and(|known| known.0 > h) && next > 0 {
                known.insert(next, (h, place.clone()));
            }
            Ok((self.curve.monitor(which, &place)?, place))
        };
        // A start may be an event itself, or where curves meet: then it is looked at from a little further
        // on, where the signs of what vanishes there are certain.
        let mut before = self.curve.monitors(&here.place, &here.view);
        let vanishes = |value: &Option<f64>| value.is_some_and(|value| value.abs() < 1e-7);
        let mut first = 0.0;
        if here.length == 0.0 && before.iter().any(vanishes) {
            first = 1e-2 * reach;
            let place = self.between(&here.place, place, &here.place.tangent, first / reach)?;
            before = self.curve.monitors(&place, &self.curve.view(&place)?);
        }
        let mut found: Vec<(f64, usize, CurvePoint)> = Vec::new();
        let search = |which: usize, a: (f64, Option<f64>), b: (f64, Option<f64>)| -> Result<Option<_>> {
            let ((low, Some(x)), (high, Some(y))) = (a, b) else { return Ok(None) };
            if !(x * y < 0.0 || y == 0.0 && x != 0.0) {
                return Ok(None);
            }
            Ok(Some(match root(|h| at(which, h), (low, x), (high, y)) {
                (h, Some(place)) => (h, which, place),
                (h, None) => {
                    let (h, place) = self.across(|h| at(which, h), h, reach)?;
                    (h, which, place)
                }
            }))
        };
        for which in 0..after.len() {
            found.extend(search(which, (first, before[which]), (reach, after[which]))?);
        }
        let seen: Vec<bool> =
            (0..after.len()).map(|which| found.iter().any(|event| event.1 == which)).collect();
        // What is defined at one end only, or has one sign at both, is looked at beside these events, too: an
        // event may end it, and a multiplier that comes back by one event may hide that it left by another.
        let mut places: Vec<f64> = found.iter().map(|event| event.0).collect();
        places.sort_by(f64::total_cmp);
        let mut parts = vec![(first, before)];
        for cluster in places.chunk_by(|a, b| b - a <= 4.0 * BESIDE * reach) {
            let (low, high) = (cluster[0], cluster[cluster.len() - 1]);
            for h in [low - BESIDE * (low - first), high + BESIDE * (reach - high)] {
                let place = self.near(&known.borrow(), &here.place.tangent, h);
                let values =
                    place.and_then(|place| Ok(self.curve.monitors(&place, &self.curve.view(&place)?)));
                parts.push((h, values.unwrap_or_else(|_| vec![None; after.len()])));
            }
        }
        parts.push((reach, after));
        for which in (0..seen.len()).filter(|which| !seen[*which]) {
            for [a, b] in parts.as_chunks::<2>().0 {
                found.extend(search(which, (a.0, a.1[which]), (b.0, b.1[which]))?);
            }
        }
        let (_, after) = parts.pop().unwrap_or_else(|| unreachable!("the end is there"));
        let (first, before) = parts.swap_remove(0);
        Ok(Zeros { found, behind: (reach - first, before), after })
    }

    /// The point h along `normal` from the first of some points of a step, guessed from the nearest two.
    fn near(&self, known: &[(f64, CurvePoint)], normal: &[f64], h: f64) -> Result<CurvePoint> {
        let next = known.partition_point(|known| known.0 < h).clamp(1, known.len() - 1);
        let (a, b) = (&known[next - 1], &known[next]);
        self.between(&a.1, &b.1, normal, (h - a.0) / (b.0 - a.0))
    }
}

/// Whether a function that has values before and here, so far apart, would be past 0 at that pace at the end
/// of the step after, where it has the sign that it has here.
fn passes(
    before: &[Option<f64>],
    back: f64,
    here: &[Option<f64>],
    reach: f64,
    after: &[Option<f64>],
) -> bool {
    let past = |i: usize| {
        let (x, y) = (here[i]?, after[i]?);
        Some(x * y > 0.0 && x * (x + (x - before[i]?) / back * reach) < 0.0)
    };
    (0..here.len()).any(|i| past(i) == Some(true))
}

/// What tells of an event: a monitor's zero, or what is known of points on both sides.
#[derive(Clone, Copy)]
enum Told {
    Zero(usize),
    Change(usize),
}

/// Steps longer than this part of the longest are shortened where a monitor may have two zeros within.
const FINEST: f64 = 1.0 / 16.0;

/// More changes than this within a step are too many.
const MOST_CHANGES: u32 = 8;

/// Of a step, to where a change is.
const BISECTIONS: u32 = 48;

/// Points on both sides of a change that are farther apart than this are on two curves.
const JUMP: f64 = 1e-6;

/// So close to an event, as a part of the way to the end of its step, other functions are looked at.
const BESIDE: f64 = 1e-6;

/// Whether two steps are the same event at the same point.
fn same<V>(a: &Step<V>, b: &Step<V>) -> bool {
    a.event == b.event && norm(&difference(&a.place.u, &b.place.u)) <= 1e-6 * (1.0 + norm(&a.place.u))
}

impl std::fmt::Display for CurveEnd {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            CurveEnd::Bound => "a parameter is at its bound",
            CurveEnd::Fails => "no such orbit from here on",
            CurveEnd::Closed => "the branch is closed",
            CurveEnd::Repeats => "a flip of the orbit of half the period: the same orbits follow, later",
            CurveEnd::Points => "as many points as were allowed",
            CurveEnd::Start => "the start",
            CurveEnd::Found => "what was looked for",
            CurveEnd::Reach => "as far as was asked for",
            CurveEnd::Fades(at) => {
                let at: Vec<String> = at.iter().map(f64::to_string).collect();
                return write!(f, "an impact loses its speed, about at {}", at.join(", "));
            }
            CurveEnd::Lost(why) => return write!(f, "lost: {why}"),
        })
    }
}
