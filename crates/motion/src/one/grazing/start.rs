//! From the leading-order solution (32) of a pattern to a start for Newton's method on the true system.

use super::Grazing;
use crate::{
    continuation::{LeadingImpact, pattern_of},
    error::Result,
    motion::{Flow, State, algebra::apply},
    one::orbit::{Family, Itinerary, Leg, OrbitImpact, Strike, Unknowns},
};

impl Grazing {
    /// The pattern equations' unknowns for the pattern (n₁, …, n_m) of `impacts` at `parameter`, to leading
    /// order in its distance η/e from the bifurcation, and their itinerary: between two low-velocity impacts
    /// the grazing orbit is gone round n_i times, its own impacts displaced. Low-velocity impact i follows
    /// the n_{i−1} rounds, with speed √(2a_G) ηY_{i−1}, where z′ = −V on the parabola of curvature a_G that
    /// the motion follows there.
    ///
    /// # Errors
    /// Where the system is not defined.
    pub fn start(
        &self,
        family: &dyn Family,
        impacts: &[LeadingImpact],
        parameter: f64,
    ) -> Result<(Itinerary, Vec<f64>)> {
        let periods = pattern_of(impacts);
        let oscillator = family.at(self.parameter)?;
        let away = parameter - self.parameter;
        let (map, eta) = (&self.map, self.map.e * away);
        let (strikes, m) = (self.itinerary.strikes(), periods.len());
        let graze = oscillator.touch(strikes[0].place, self.z[0])?;
        let sign = graze.wall.side.sign();
        let drift = [map.e, map.rate_drift].map(|drift| sign * drift * away);
        let (mut all, mut z) = (Vec::<Strike>::new(), Vec::new());
        for (i, &n) in periods.iter().enumerate() {
            let (early, speed) = map.impact(&impacts[i], away);
            all.push(strikes[0]);
            z.extend([self.z[0] - early, speed]);
            let mut x = impacts[(i + 1) % m].x.clone();
            for round in 0..n {
                if round > 0
                    && let Some(last) = all.last_mut()
                {
                    last.periods += strikes[0].periods;
                }
                // The displacement at the phase of grazing in (q, u), then through the orbit's own impacts.
                let mut shift = [0, 1].map(|j| eta * x[j] + drift[j] + graze.slope[j] * away);
                for passage in Unknowns::new(&self.itinerary, &self.z)?.passages(&oscillator) {
                    let passage = passage?;
                    if passage.next == 0 {
                        break;
                    }
                    let Leg { matrix, slope, .. } = passage.fly();
                    let arrived = apply(&matrix, shift);
                    shift = [0, 1].map(|k| arrived[k] + slope[k] * away);
                    let OrbitImpact { side, phase, speed } = passage.arrival;
                    let there = &passage.there;
                    let [place, velocity] = [0, 1].map(|k| side.sign() * (shift[k] - there.slope[k] * away));
                    let delay = place / speed;
                    let arrival: State = there.leaving(phase, -speed);
                    let bend = side.sign() * (oscillator.flow().acceleration(arrival) - there.motion[2]);
                    all.push(strikes[passage.next]);
                    z.extend([phase + delay, speed - velocity - bend * delay]);
                    let (jump, slope) = passage.saltation();
                    let left = apply(&jump, shift);
                    shift = [0, 1].map(|k| left[k] + slope[k] * away);
                }
                x = map.round(&x);
            }
        }
        Ok((Itinerary::new(all)?, z))
    }
}
