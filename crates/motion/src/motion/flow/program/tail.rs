//! How long a step may be so that the force along its polynomial is not far from what its series says, all
//! along the step: steps cannot leap over a layer, a bump or a pole, however smooth all is where they begin.
//!
//! A step's polynomial p has the order n in x. Along it the force F(x) = f(t, p, p′) has the coefficients of
//! p″ below n − 1, so that p″ − F, the defect, is the rest of F's series. If F, without what is linear in q
//! and q′ or a harmonic of the time, stays within M of F(0) for all complex |x| ≤ ρ, its coefficient k is at
//! most M ρ^{−k} by Cauchy's estimate, and on 0 ≤ x ≤ y ≤ ρ/3.2
//!
//! ```text
//! |p″ − F| ≤ y^{n−1} (M ρ^{1−n} / (1 − 1/3.2) + L),
//! ```
//!
//! L being the rest of the linear terms and of the harmonics, whose series are known. M comes from one pass
//! over the operations: each row lies in a disc round its value at x = 0, which is known, and only the radius
//! is computed. For q, q′ and t that is the sum of |a_k| ρ^k over k ≥ 1. A disc that reaches a pole, or the
//! branch point of a root, a power or a logarithm, makes M infinite; so near to that of a power that it is a
//! straight line there, it must stay near. Several ρ are tried: a larger one takes more of
//! the force's surroundings in, a smaller one makes less of its smoothness.
//!
//! Bounds are computed in floats and not rounded outwards. Derivatives that numbers carry along are not
//! bounded: the length of their steps is told by their last terms and by the values.

use super::{super::TERMS, Op, Output, Program, Rows, SHORTEST_RAISED, Sum, straight};
use crate::motion::flow::Scalar;

/// ρ over the longest step that it allows, at least.
const LEAST: f64 = 3.2;

/// Radii that are tried first, over the step that the last terms suggest.
const FIRST: [f64; 3] = [LEAST, 5.0, 8.0];

/// The same near a branch point of a power, where what is not smooth is small.
const NEAR: [f64; 3] = [1.5, 1.9, 2.4];

/// Each radius after these is that part of the one before.
const NEXT: f64 = 0.7;

/// The longest step of at most `far` for a polynomial of order `order` in units of a trial step: `bounds`
/// tells M for a radius, in `all`, `known` is L, and `fits` finds the longest step of at most another length
/// on which a defect of y^{n−1} K is small enough. Steps below `least` count as 0.
pub(crate) fn suited(
    order: usize,
    [far, least]: [f64; 2],
    known: (&[f64], &mut [f64]),
    bounds: impl FnMut(f64, &mut [f64]),
    fits: impl Fn(&[f64], f64) -> f64,
) -> f64 {
    suited_by(order, [far, least], FIRST, known, bounds, fits)
}

/// The same with other radii: the first of them is ρ over the longest step that it allows.
fn suited_by(
    order: usize,
    [far, least]: [f64; 2],
    first: [f64; 3],
    (known, all): (&[f64], &mut [f64]),
    mut bounds: impl FnMut(f64, &mut [f64]),
    fits: impl Fn(&[f64], f64) -> f64,
) -> f64 {
    let ratio = first[0];
    let mut best = 0.0f64;
    let power = 1 - order as i32;
    let mut allowed = |radius: f64| {
        bounds(radius, all);
        let factor = radius.powi(power) / (1.0 - 1.0 / ratio);
        for (bound, known) in all.iter_mut().zip(known) {
            let sum = *bound * factor + known;
            *bound = if sum.is_nan() { f64::INFINITY } else { sum };
        }
        fits(all, far.min(radius / ratio))
    };
    for radius in first {
        let here = allowed(radius * far);
        if here >= far {
            return far;
        }
        // Where M is a series in ρ without negative terms, log M ρ^{1−n} is convex in log ρ: once it grows,
        // it goes on. (Where the better of two bounds is taken, a longer step may be missed.)
        if here <= best {
            break;
        }
        best = here;
    }
    let mut radius = ratio * far;
    loop {
        radius *= NEXT;
        let most = radius / ratio;
        if most <= best {
            return best;
        }
        if most < least || most.is_nan() {
            return 0.0;
        }
        best = best.max(allowed(radius));
    }
}

/// Σ_{k≥1} |a_k| ρ^k and Σ_{k≥2} k |a_k| ρ^{k−1}.
pub(crate) fn radii(row: impl DoubleEndedIterator<Item = f64> + ExactSizeIterator, radius: f64) -> [f64; 2] {
    let (mut place, mut slope, mut k) = (0.0, 0.0, row.len());
    for a in row.rev() {
        k -= 1;
        if k == 0 {
            break;
        }
        place = (place + a.abs()) * radius;
        if k > 1 {
            slope = (slope + k as f64 * a.abs()) * radius;
        }
    }
    [place, slope]
}

/// Steps by powers shorter than this, in units of the trial step, are given as 0.
const LEAST_RAISED: f64 = SHORTEST_RAISED / 10.0;

/// 1/k!.
const INVERSE_FACTORIALS: [f64; TERMS] = {
    let (mut all, mut k) = ([1.0; TERMS], 1);
    while k < TERMS {
        all[k] = all[k - 1] / k as f64;
        k += 1;
    }
    all
};

/// The rest of an amplitude's series from order n − 1 on, over x^{n−1}: a harmonic that turns by `angle` in
/// the trial step and by at most n/2 in x.
pub(crate) fn harmonic(amplitude: f64, angle: f64, order: usize) -> f64 {
    2.0 * amplitude.abs() * angle.powi(order as i32 - 1) * INVERSE_FACTORIALS[order - 1]
}

/// The rest of a linear force, over x^{n−1}, by q and by q′, for steps of at most `far`.
pub(crate) fn linear(last: [f64; 2], far: f64, trial: f64, order: usize) -> [f64; 2] {
    [last[0].abs() + last[1].abs() * far, order as f64 * last[1].abs() / trial]
}

impl<S: Scalar> Program<S> {
    /// The longest step of at most `far`, in units of the trial step of `rows`, on which the outputs along
    /// the step's polynomial are near their series all along: `fits` is told K with |defect| ≤ K x^{n−1} for
    /// each output and finds the longest step, of at most another length, that suits it, n being the order of
    /// the polynomial. Steps of less than `least` are given as 0. Cost: O(operations) for each radius that is
    /// tried, mostly one.
    pub fn suited(&self, rows: &Rows<S>, far: f64, least: f64, fits: impl Fn(&[f64], f64) -> f64) -> f64 {
        let (order, trial) = (rows.count - 1, rows.trial.abs());
        let drives = self.outputs.iter().flat_map(|output| &output.drive);
        let fastest = drives.fold(0.0, |most: f64, drive| most.max(drive.k * trial));
        let far = if fastest > 0.0 { far.min(order as f64 / (2.0 * fastest)) } else { far };
        let outputs = self.outputs.len();
        let mut room = vec![0.0; 2 * (outputs + self.inputs() + self.ops.len())];
        let (known, room) = room.split_at_mut(outputs);
        let (all, room) = room.split_at_mut(outputs);
        let (discs, nearest) = room.split_at_mut(self.inputs() + self.ops.len());
        known.iter_mut().enumerate().for_each(|(k, known)| *known = self.rest(rows, k, far));
        let mut bounds = |radius: f64, all: &mut [f64]| {
            self.discs(rows, radius, discs, nearest);
            for (bound, output) in all.iter_mut().zip(&self.outputs) {
                let formulas = output.sum.terms.iter().filter(|term| term.1 >= self.inputs());
                *bound = formulas.fold(0.0, |sum, (factor, row)| sum + factor.part(0).abs() * discs[*row]);
            }
        };
        if !self.raised {
            return suited(order, [far, least], (known, all), bounds, fits);
        }
        let reached = |first, all: &mut [f64], bounds: &mut dyn FnMut(f64, &mut [f64])| {
            suited_by(order, [far, least.min(LEAST_RAISED)], first, (known, all), bounds, &fits)
        };
        reached(FIRST, all, &mut bounds).max(reached(NEAR, all, &mut bounds))
    }

    /// The sum of the moduli of what an output was added up from.
    pub fn size(&self, rows: &Rows<S>, output: usize) -> f64 {
        let Output { sum, drive } = &self.outputs[output];
        let terms =
            sum.terms.iter().map(|(factor, row)| (*factor * rows.data[rows.count * row]).part(0).abs());
        let harmonics = drive.iter().map(|drive| drive.cos.part(0).hypot(drive.sin.part(0)));
        sum.constant.part(0).abs() + terms.sum::<f64>() + harmonics.sum::<f64>()
    }

    /// L of an output.
    fn rest(&self, rows: &Rows<S>, output: usize, far: f64) -> f64 {
        let (n, order, trial) = (self.size, rows.count - 1, rows.trial.abs());
        let Output { sum, drive } = &self.outputs[output];
        let linear = |(factor, row): &(S, usize)| {
            let last = |j: usize| [rows.place(j)[order - 1].part(0), rows.place(j)[order].part(0)];
            let rest = match *row {
                row if row < n => linear(last(row), far, trial, order)[0],
                row if row < 2 * n => linear(last(row - n), far, trial, order)[1],
                _ => 0.0,
            };
            if rest == 0.0 { 0.0 } else { factor.part(0).abs() * rest }
        };
        let harmonics = drive
            .iter()
            .map(|drive| harmonic(drive.cos.part(0).hypot(drive.sin.part(0)), drive.k * trial, order));
        sum.terms.iter().map(linear).sum::<f64>() + harmonics.sum::<f64>()
    }

    /// The factor, the constant and the row of a row that is factor · row² + constant.
    fn parabola(&self, row: usize) -> Option<(f64, f64, usize)> {
        let op = |row: usize| row.checked_sub(self.inputs()).map(|k| &self.ops[k]);
        match op(row)? {
            Op::Square(a) => Some((1.0, 0.0, *a)),
            Op::Sum(Sum { constant, terms }) => match (terms.as_slice(), op(terms.first()?.1)?) {
                ([(factor, _)], Op::Square(a)) => Some((factor.part(0), constant.part(0), *a)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The radius of each row's disc on |x| ≤ `radius`, and how near to 0 it comes.
    fn discs(&self, rows: &Rows<S>, radius: f64, discs: &mut [f64], nearest: &mut [f64]) {
        let (n, inputs, trial) = (self.size, self.inputs(), rows.trial.abs());
        let value = |row: usize| rows.data[rows.count * row].part(0);
        for j in 0..n {
            let [place, slope] = radii(rows.place(j).iter().map(|a| a.part(0)), radius);
            (discs[j], discs[n + j]) = (place, slope / trial);
        }
        discs[2 * n] = radius * trial;
        for row in 0..inputs {
            nearest[row] = value(row).abs() - discs[row];
        }
        for (k, op) in self.ops.iter().enumerate() {
            let own = inputs + k;
            let thin = rows.thin.get(k).copied().unwrap_or(0.0);
            discs[own] = op.disc(own, (discs, nearest), value, radius * trial, thin);
            let mut other = 0.0;
            match op {
                Op::Square(a) if nearest[*a] > 0.0 => other = nearest[*a] * nearest[*a],
                Op::Sum(_) => {
                    if let Some((factor, c, a)) = self.parabola(own) {
                        other = factor.abs() * beside_zeros(c / factor, value(a), discs[a]);
                    }
                }
                Op::Exp(row) => {
                    if let Some((factor, _, a)) = self.parabola(*row)
                        && factor < 0.0
                    {
                        let most = value(*row) - factor * lift(value(a), discs[a]);
                        discs[own] = discs[own].min(most.exp() + value(own));
                    }
                }
                _ => {}
            }
            nearest[own] = (value(own).abs() - discs[own]).max(other);
        }
    }
}

/// How far the real part of −z² rises above −x² where z is no farther from x than r: by r² + x²/2, in
/// the middle between 0 and x, or, for r < |x|/2, at the end towards 0.
fn lift(x: f64, r: f64) -> f64 {
    if x.abs() < 2.0 * r { r * r + x * x / 2.0 } else { r * (2.0 * x.abs() - r) }
}

/// How near to 0 z² + c comes where z is no farther from `x` than `radius`, or less: both its zeros, ±i√c,
/// are √(x² + c) from `x`. 0 where c is not positive.
fn beside_zeros(c: f64, x: f64, radius: f64) -> f64 {
    let apart = (x * x + c).sqrt() - radius;
    if c > 0.0 && apart > 0.0 { apart * apart } else { 0.0 }
}

impl<S: Scalar> Op<S> {
    /// How far its values are from that at x = 0 where those of the rows before are this far, and the time;
    /// `nearest` says how near to 0 those come, `thin` where a power is a straight line.
    fn disc(
        &self,
        own: usize,
        (discs, nearest): (&[f64], &[f64]),
        value: impl Fn(usize) -> f64,
        time: f64,
        thin: f64,
    ) -> f64 {
        // What is not smooth in all of a disc is anything there; so is what is no number.
        let inside =
            |smooth: bool, radius: f64| if smooth && !radius.is_nan() { radius } else { f64::INFINITY };
        match self {
            Op::Sum(Sum { terms, .. }) => {
                terms.iter().fold(0.0, |sum, (factor, row)| sum + factor.part(0).abs() * discs[*row])
            }
            Op::Product(a, b) => {
                let (x, y, r, s) = (value(*a).abs(), value(*b).abs(), discs[*a], discs[*b]);
                inside(true, x * s + y * r + r * s)
            }
            Op::Square(a) => inside(true, (2.0 * value(*a).abs() + discs[*a]) * discs[*a]),
            // a/b − A/B = ((a − A) + A/B (B − b))/b.
            Op::Quotient(a, b) => {
                let apart = nearest[*b];
                inside(apart > 0.0, (discs[*a] + value(own).abs() * discs[*b]) / apart)
            }
            Op::Inverse(a) => {
                let apart = nearest[*a];
                inside(apart > 0.0, discs[*a] / (value(*a).abs() * apart))
            }
            Op::Sqrt(a) => {
                let (x, r) = (value(*a), discs[*a]);
                inside(r < x, r / (x.sqrt() + (x - r).sqrt()))
            }
            // e^{a+r} − e^a, e^a perhaps below all floats.
            Op::Exp(a) => inside(true, -(value(*a) + discs[*a]).exp() * (-discs[*a]).exp_m1()),
            Op::Log(a) => {
                let (x, r) = (value(*a), discs[*a]);
                inside(r < x, -(-r / x).ln_1p())
            }
            // |sin(a + z) − sin a| ≤ |cos z − 1| + |sin z| ≤ cosh r − 1 + sinh r.
            Op::Sin(a) | Op::Cos(a) => inside(true, discs[*a].exp_m1()),
            Op::TurnSin(k, _) | Op::TurnCos(k, _) => (k.abs() * time).exp_m1(),
            Op::Tanh(a) => tanh(value(*a), discs[*a]),
            Op::SquaredSech(a) => {
                let (y, r) = (value(own - 1).abs(), tanh(value(*a), discs[*a]));
                inside(true, (2.0 * y + r) * r)
            }
            Op::Raised(a, p) => {
                let (x, r) = (value(*a), discs[*a]);
                if x <= thin {
                    return inside(x.abs() + r <= (1.1 * thin).max(2.0 * x.abs()), straight(thin, *p) * r);
                }
                // |(x + z)^p − x^p| ≤ |z| p (x + |z|)^{p−1}.
                inside(r < x, p * r * (x + r).powf(p - 1.0))
            }
        }
    }
}

/// How far tanh is from its value at a where its argument is no farther from a than r.
///
/// tanh z is the sum of 1/(z − p) over its poles p = ±i(k + ½)π, so that it changes by at most the sum of
/// r/(d (d − r)), d being the distance of a from p. Of the two nearest poles that is 2r/(d (d − r)); for k ≥
/// 1, d_k² = d² + k(k + 1)π² gives d_k (d_k − r) ≥ k(k + 1)π²/2, in all at most r · 4/π². Where |Re z| = x,
/// it is at most 2/(e^{2x} − 1) from ±1.
fn tanh(a: f64, r: f64) -> f64 {
    use std::f64::consts::{FRAC_PI_2, PI};
    let a = a.abs();
    let d = a.hypot(FRAC_PI_2);
    let near = if r < d { r * (2.0 / (d * (d - r)) + 4.0 / (PI * PI)) } else { f64::INFINITY };
    let far =
        if r < a { 2.0 / (2.0 * (a - r)).exp_m1() + 2.0 / ((2.0 * a).exp() + 1.0) } else { f64::INFINITY };
    let radius = near.min(far);
    if radius.is_nan() { f64::INFINITY } else { radius }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of the circle round x and of smaller ones, real and imaginary part.
    fn disc(x: f64, radius: f64) -> impl Iterator<Item = [f64; 2]> {
        (0..=8).flat_map(move |ring| {
            let r = radius * f64::from(ring) / 8.0;
            (0..720).map(move |i| {
                let (sin, cos) = (f64::from(i).to_radians() / 2.0).sin_cos();
                [x + r * cos, r * sin]
            })
        })
    }

    #[test]
    fn squares_in_discs_are_as_far_from_zero_and_rise_as_high_as_is_said() {
        for (x, radius) in [(0.0, 0.5), (0.3, 0.7), (-2.0, 0.4), (1.0, 1.0), (4.0, 1.9), (0.5, 3.0)] {
            let most = disc(x, radius).map(|[a, b]| b * b - a * a + x * x).fold(0.0, f64::max);
            let known = lift(x, radius);
            assert!(most <= known + 1e-12 && known <= most + 1e-3, "{x}, {radius}: {most} and {known}");
            for c in [0.1, 1.0, 25.0, -1.0] {
                let size = |[a, b]: [f64; 2]| (a * a - b * b + c).hypot(2.0 * a * b);
                let least = disc(x, radius).map(size).fold(f64::INFINITY, f64::min);
                let known = beside_zeros(c, x, radius);
                assert!(known <= least + 1e-12, "{x}, {radius}, {c}: {least} and {known}");
            }
        }
        assert_eq!(beside_zeros(9.0, 4.0, 1.0), 16.0);
        assert_eq!([beside_zeros(9.0, 4.0, 5.0), beside_zeros(-1.0, 4.0, 1.0)], [0.0; 2]);
    }

    #[test]
    fn tanh_in_discs_goes_no_farther_than_is_said() {
        for (x, radius) in [(0.0f64, 0.5f64), (0.7, 1.2), (-3.0, 1.0), (20.0, 15.0), (0.1, 1.5)] {
            let known = tanh(x, radius);
            for [a, b] in disc(x, radius) {
                // tanh(a + bi) = (sinh 2a + i sin 2b)/(cosh 2a + cos 2b).
                let below = (2.0 * a).cosh() + (2.0 * b).cos();
                let apart = ((2.0 * a).sinh() / below - x.tanh()).hypot((2.0 * b).sin() / below);
                assert!(apart <= known + 1e-12, "{x}, {radius}: {apart} and {known}");
            }
        }
        assert_eq!(tanh(0.0, 1.6), f64::INFINITY);
    }
}
