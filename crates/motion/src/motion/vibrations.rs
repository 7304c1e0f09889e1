//! Free vibrations of one coordinate over all amplitudes: which swing at a frequency, and what frequencies
//! tend to at the ends of all amplitudes: there a *backbone* ends.

use super::backbone::{Conservative, SAME, between};

use crate::rounding::SUM;

/// Vibrations at one frequency, of all that there are.
#[derive(Debug, Clone, PartialEq)]
pub struct Vibrations {
    /// How far they swing, by amplitude.
    pub swings: Vec<f64>,
    /// The least and the largest frequency that any vibration has, over that asked for.
    pub rates: [f64; 2],
    /// What vibrations tend to at the ends of all amplitudes.
    pub ends: Vec<AmplitudeEnd>,
}

/// The end of a range of amplitudes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AmplitudeEnd {
    /// `natural frequency`: the amplitude tends to 0; `hill`: beyond it forces do not lead back; `largest
    /// swings`: it grows without end.
    pub why: &'static str,
    /// The swing there; near that up to which all vibrations have the natural frequency; none where it grows
    /// without end.
    pub swing: Option<f64>,
    /// Whether the vibration there is faster than what is asked for.
    pub faster: bool,
}

/// Neighbouring amplitudes at which a frequency is looked at, one over the other.
const RATIO: f64 = 2.0;
/// The largest amplitude over the longest of the lengths at which forces change, and the shortest over the
/// least.
const SPAN: f64 = 1e6;
/// By so much a frequency differs from the natural one; and this is no rounding, where amplitudes are a
/// sixteenth as large: it changes smoothly.
const DEPARTS: f64 = 1e-4;
/// So close to the edge of a hill energies are one to rounding: there it is not looked.
const BESIDE: f64 = 1e-6;
/// Steps of the search for the place where a frequency comes closest to what is asked for.
const SECTIONS: u32 = 50;

impl Conservative {
    /// The vibrations at k times the drive's frequency; none where there is no place of rest. Amplitudes are
    /// looked at over all lengths at which forces change, and 10⁶ times beyond; between three at which the
    /// frequency comes closest to k in the middle it is looked whether it comes to k. Swings are to rounding
    /// if they are to be `located`, else to a factor of two.
    pub fn vibrations(&self, k: u32, located: bool) -> Option<Vibrations> {
        let rest = self.rest()?;
        let [least, most] = self.amplitudes(rest);
        let sign = if self.stops[1] > rest { 1.0 } else { -1.0 };
        let look = |amplitude: f64| {
            let [rate, swing] = self.at(rest, rest + sign * amplitude)?;
            let rate = rate / f64::from(k);
            (rate.is_finite() && swing.is_finite()).then_some(Look { amplitude, rate, swing })
        };
        let led = |amplitude: f64| look(amplitude).is_some();
        let mut pieces: Vec<Vec<Look>> = Vec::new();
        let (mut open, mut here) = (false, least);
        while here <= most {
            let now = look(here);
            if now.is_none() && open {
                let (last, _) = edge(here / RATIO, here, led);
                pieces.last_mut()?.extend(look(last * (1.0 - BESIDE)));
            } else if now.is_some() && !open {
                let (_, first) = edge(here / RATIO, here, |amplitude| !led(amplitude));
                pieces.push(
                    look(first * (1.0 + BESIDE)).filter(|look| look.amplitude < here).into_iter().collect(),
                );
            }
            open = now.is_some();
            if let (Some(now), Some(piece)) = (now, pieces.last_mut()) {
                piece.push(now);
            }
            here *= RATIO;
        }
        pieces.retain(|piece| piece.len() > 1);
        let mut linear = 0.0;
        if let Some(piece) = pieces.first_mut().filter(|piece| piece[0].amplitude <= least) {
            let natural = piece[0].rate;
            let same = piece.iter().take_while(|look| (look.rate / natural - 1.0).abs() <= SUM).count();
            // As long as rounding alone tells frequencies apart, they are one; at the natural frequency the
            // swing is 0 then, and no vibration.
            piece[..same].iter_mut().for_each(|look| look.rate = natural);
            linear = alike(piece);
            if linear == 0.0 && (natural - 1.0).abs() <= SUM && same < piece.len() {
                let beside = piece[same].rate;
                piece[..same].iter_mut().for_each(|look| look.rate = beside);
            }
        }
        let all = pieces.iter().flatten();
        let rates = all.fold([f64::INFINITY, 0.0], |[a, b], look| [look.rate.min(a), look.rate.max(b)]);
        let bounded = self.stops.iter().all(|stop| stop.is_finite());
        let (mut ends, mut swings) = (Vec::new(), Vec::new());
        for piece in &pieces {
            for end in [0, piece.len() - 1] {
                let Look { amplitude, rate, swing } = piece[end];
                let (why, swing) = match () {
                    () if end == 0 && amplitude <= least => ("natural frequency", Some(linear)),
                    () if end > 0 && amplitude * RATIO > most => ("largest swings", bounded.then_some(swing)),
                    () => ("hill", Some(swing)),
                };
                ends.push(AmplitudeEnd { why, swing, faster: is_faster(rate) });
            }
            swings.extend(passes(piece, located, &look));
        }
        Some(Vibrations { swings, rates, ends })
    }

    /// The least and the largest amplitude to be looked at.
    pub(super) fn amplitudes(&self, rest: f64) -> [f64; 2] {
        let places = self.springs.iter().map(|spring| spring[0]).chain(self.stops);
        let mut lengths: Vec<f64> = places.map(|place| (place - rest).abs()).collect();
        lengths.extend([rest.abs(), (self.stiffness / self.cubic).abs().sqrt()]);
        lengths.retain(|length| *length > 0.0 && length.is_finite());
        if lengths.is_empty() || self.own.is_some() {
            // A formula does not say at which lengths it changes.
            lengths.extend([1e-3, 1e3]);
        }
        let [least, most] = lengths.iter().fold([f64::INFINITY, 0.0], |[a, b], x| [x.min(a), x.max(b)]);
        [(least / SPAN).max(rest.abs() / SPAN), most * SPAN]
    }
}

/// A vibration: the frequency, over that asked for, and the swing.
#[derive(Debug, Clone, Copy)]
struct Look {
    amplitude: f64,
    rate: f64,
    swing: f64,
}

fn is_faster(rate: f64) -> bool {
    rate > 1.0 + SAME
}

/// The swing up to which vibrations have the natural frequency, about.
fn alike(piece: &[Look]) -> f64 {
    let off = |look: &Look| (look.rate / piece[0].rate - 1.0).abs();
    let Some(first) = piece.iter().position(|look| off(look) > DEPARTS) else { return f64::INFINITY };
    if off(&piece[first.saturating_sub(4)]) > 0.0 { 0.0 } else { piece[first].swing }
}

/// The swings at which a frequency passes that asked for.
fn passes(piece: &[Look], located: bool, look: &dyn Fn(f64) -> Option<Look>) -> Vec<f64> {
    let mut all = piece.to_vec();
    for three in piece.windows(3) {
        let faster = is_faster(three[1].rate);
        let off = |look: &Look| if faster { look.rate } else { -look.rate };
        if three.iter().all(|look| is_faster(look.rate) == faster)
            && off(&three[1]) < off(&three[0]).min(off(&three[2])) * (1.0 - off(&three[1]).signum() * SAME)
        {
            all.extend(closest([three[0].amplitude, three[2].amplitude], faster, &off, look));
        }
    }
    all.sort_by(|a, b| a.amplitude.total_cmp(&b.amplitude));
    let mut swings = Vec::new();
    for pair in all.windows(2) {
        let [before, after] = [pair[0], pair[1]].map(|look| is_faster(look.rate));
        if before != after && !located {
            swings.push(pair[1].swing);
        } else if before != after {
            // To rounding, where rounding does not decide.
            let sure = pair.iter().all(|look| is_faster(look.rate) == (look.rate > 1.0));
            let faster = |rate: f64| if sure { rate > 1.0 } else { is_faster(rate) };
            let same = |amplitude| look(amplitude).is_some_and(|look| faster(look.rate) == before);
            let (_, high) = between(pair[0].amplitude, pair[1].amplitude, same);
            swings.extend(look(high).map(|look| look.swing));
        }
    }
    swings
}

/// Between two amplitudes one at which the frequency is on the other side of that asked for, by the golden
/// section, if there is one.
fn closest(
    [mut low, mut high]: [f64; 2],
    faster: bool,
    off: &dyn Fn(&Look) -> f64,
    look: &dyn Fn(f64) -> Option<Look>,
) -> Option<Look> {
    let golden = (5f64.sqrt() - 1.0) / 2.0;
    let [mut a, mut b] = [look(high - golden * (high - low))?, look(low + golden * (high - low))?];
    for _ in 0..SECTIONS {
        if let Some(other) = [a, b].into_iter().find(|look| is_faster(look.rate) != faster) {
            return Some(other);
        }
        if off(&a) < off(&b) {
            (high, b) = (b.amplitude, a);
            a = look(high - golden * (high - low))?;
        } else {
            (low, a) = (a.amplitude, b);
            b = look(low + golden * (high - low))?;
        }
    }
    None
}

/// As [`between`], to a part of [`BESIDE`].
fn edge(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> (f64, f64) {
    while high - low > 1e-3 * BESIDE * high {
        let middle = low + (high - low) / 2.0;
        *(if holds(middle) { &mut low } else { &mut high }) = middle;
    }
    (low, high)
}
