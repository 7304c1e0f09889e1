//! Where on a stroboscopic section the next period's motion just touches a wall.

use std::f64::consts::TAU;

use crate::motion::{Contact, Flow, State, flow::Free};

/// Times of touching tried, and times on the way to each at which the gap to every wall is looked at.
const TIMES: u32 = 400;
const LOOKS: u32 = 100;

/// The states at `phase` whose motion grazes `wall` within the next period before any impact, as pieces of a
/// curve: each found from its grazing contact by going back in time. To be drawn: that no wall is in the way
/// is looked at, not proved.
pub fn touching(flow: &Free, walls: &[Contact], wall: &Contact, phase: f64) -> Vec<Vec<State>> {
    let mut pieces = vec![Vec::new()];
    for i in 0..=TIMES {
        let duration = TAU * f64::from(i) / f64::from(TIMES);
        let t = phase + duration;
        let [q, u, _] = wall.position.at(t);
        let contact = State { t, q, u };
        let free = (1..=LOOKS).all(|j| {
            let at = flow.advance(contact, -duration * f64::from(j) / f64::from(LOOKS));
            walls.iter().all(|other| other.gap(at)[0] > 0.0)
        });
        if free && wall.acceleration(flow, contact) > 0.0 {
            let last = pieces.last_mut().expect("never empty");
            last.push(State { t: phase, ..flow.advance(contact, -duration) });
        } else if pieces.last().is_some_and(|last| !last.is_empty()) {
            pieces.push(Vec::new());
        }
    }
    pieces.retain(|piece| piece.len() > 1);
    pieces
}
