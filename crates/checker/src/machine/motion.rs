//! The motion of a machine between impacts and its stops, over intervals, time being the forcing's phase.
//!
//! With a = T/2π, Ω = 1/a: q″ = −K̂ q − Ĉ q′ + f̂(t), K̂ = a² M⁻¹K, Ĉ = a M⁻¹C, f̂ = a² M⁻¹f. A motion is
//! p(t) + Φ(τ) y, τ the time since its start: p the periodic response to the harmonics, Φ the exponential of
//!
//! ```text
//! [  0   I   0 ]
//! [ −K̂  −Ĉ  f̂₀ ]      on (q, q′, 1), which takes the constant force along, so that K need not be
//!                       invertible.
//! [  0   0   0 ]
//! ```

use super::{
    super::motion::{Interval, exponential::Ring},
    Fault,
    linear::{self, Matrix, Solved, Vector, apply, difference, dot, scaled, sum},
    text::{Machine, Stop},
};
use crate::rejection::{GoOn, claim};

/// A sum of harmonics with vectors: k, the coefficients of the cosine and of the sine.
type Waves = Vec<(Interval, Vector, Vector)>;

/// A stop over intervals.
pub(super) struct Contact {
    pub row: Vector,
    offset: Interval,
    waves: Vec<(Interval, Interval, Interval)>,
    /// (1 + τ) M⁻¹wᵀ/(w M⁻¹wᵀ): what an impact at the speed 1 adds to the velocities.
    pub kick: Vector,
}

/// A machine over intervals.
pub(super) struct Motion {
    pub size: usize,
    /// The matrix whose exponential the flow is.
    matrix: Matrix,
    stiffness: Matrix,
    damping: Matrix,
    constant: Vector,
    forcing: Waves,
    response: Waves,
    pub contacts: Vec<Contact>,
}

/// cos kt and sin kt.
fn circle(k: Interval, t: Interval) -> (Interval, Interval) {
    let e = Ring::<Interval>::CIRCLE.exp(k * t);
    (e.a.within_unit(), e.b.within_unit())
}

/// The columns of a list of rows, and back.
fn transposed(a: &[Vector]) -> Matrix {
    (0..a.first().map_or(0, Vec::len)).map(|j| a.iter().map(|row| row[j]).collect()).collect()
}

impl Motion {
    /// Encloses the coefficients.
    ///
    /// # Errors
    /// Says what the method cannot do with them.
    pub fn new(machine: &Machine, go_on: GoOn) -> Result<Self, Fault> {
        let n = machine.size();
        let list = |list: &[super::Range]| -> Vector { list.iter().map(|x| x.interval()).collect() };
        let rows = |rows: &[Vec<super::Range>]| -> Matrix { rows.iter().map(|row| list(row)).collect() };
        let lower = rows(&machine.mass);
        let mass: Matrix = (0..n).map(|i| (0..n).map(|j| lower[i.max(j)][i.min(j)]).collect()).collect();
        // Without exchanges the pivots are quotients of leading minors.
        let inverse = match linear::solve(&mass, &linear::identity(n), false) {
            Some(Solved { solution, positive: true, .. }) => solution,
            _ => return Err(Fault::False("the mass matrix is not certainly positive definite".into())),
        };
        let period = machine.period.interval();
        claim(period.is_positive(), "the period is not certainly positive")?;
        let unit = period.over(Interval::PI + Interval::PI);
        // One factor a at each side, so that neither product is needlessly large.
        let slow: Matrix = inverse.iter().map(|row| scaled(unit, row)).collect();
        let accelerated = |force: &[Interval]| apply(&slow, &scaled(unit, force));
        let stiffness: Matrix = rows(&machine.stiffness).iter().map(|row| scaled(unit, row)).collect();
        let stiffness = linear::times(&slow, &stiffness);
        let damping = linear::times(&slow, &rows(&machine.damping));
        let constant = accelerated(&list(&machine.force));
        let mut matrix = vec![vec![Interval::ZERO; 2 * n + 1]; 2 * n + 1];
        for i in 0..n {
            matrix[i][n + i] = Interval::ONE;
            for j in 0..n {
                (matrix[n + i][j], matrix[n + i][n + j]) = (-stiffness[i][j], -damping[i][j]);
            }
            matrix[n + i][2 * n] = constant[i];
        }
        let (mut forcing, mut response) = (Vec::new(), Vec::new());
        for load in &machine.forcing {
            go_on()?;
            let k = Interval::integer(load.k);
            let [cos, sin] = [&load.cos, &load.sin].map(|force| accelerated(&list(force)));
            let resonant =
                || Fault::False(format!("harmonic {} of the forcing may be in undamped resonance", load.k));
            let (alpha, beta) = answer(&stiffness, &damping, k, &cos, &sin).ok_or_else(resonant)?;
            forcing.push((k, cos, sin));
            response.push((k, alpha, beta));
        }
        let contact = |(number, stop): (usize, &Stop)| {
            let row = list(&stop.row);
            let push = apply(&inverse, &row);
            let mobility = dot(&row, &push);
            claim(mobility.is_positive(), format_args!("the row of stop {number} may be zero"))?;
            let restitution = stop.restitution.interval();
            let waves = stop.harmonics.iter();
            Ok(Contact {
                row,
                offset: stop.offset.interval(),
                waves: waves.map(|h| (Interval::integer(h.k), h.cos.interval(), h.sin.interval())).collect(),
                kick: scaled((Interval::ONE + restitution).over(mobility), &push),
            })
        };
        let contacts = (1..).zip(&machine.stops).map(contact).collect::<Result<_, Fault>>()?;
        Ok(Motion { size: n, matrix, stiffness, damping, constant, forcing, response, contacts })
    }

    /// exp of the matrix times τ.
    pub fn flow(&self, tau: Interval) -> Matrix {
        linear::exp(&self.matrix, tau)
    }

    /// (q, q′) of the response to the harmonics.
    fn steady(&self, t: Interval) -> Vector {
        let mut state = vec![Interval::ZERO; 2 * self.size];
        for (k, alpha, beta) in &self.response {
            let (cos, sin) = circle(*k, t);
            let q = sum(&scaled(cos, alpha), &scaled(sin, beta));
            let u = scaled(*k, &difference(&scaled(cos, beta), &scaled(sin, alpha)));
            state = sum(&state, &[q, u].concat());
        }
        state
    }

    /// What the flow acts on: the state at phase t minus the response, and 1.
    pub fn depart(&self, state: &[Interval], t: Interval) -> Vector {
        let mut start = difference(state, &self.steady(t));
        start.push(Interval::ONE);
        start
    }

    /// The state to which a flow has brought a start, at phase t.
    pub fn arrive(&self, flow: &Matrix, start: &[Interval], t: Interval) -> Vector {
        sum(&apply(flow, start)[..2 * self.size], &self.steady(t))
    }

    /// The displacements at rest under the constant force, K̂⁻¹f̂₀; `None` where K may be singular.
    pub fn rest(&self) -> Option<Vector> {
        let force = transposed(std::slice::from_ref(&self.constant));
        let solved = linear::solve(&self.stiffness, &force, true)?;
        Some(transposed(&solved.solution).swap_remove(0))
    }

    /// The gap to a stop with its first two derivatives, of the motion without impacts about these
    /// displacements: the response to the harmonics, which is a sum of harmonics itself.
    pub fn free_gap(&self, stop: usize, rest: &[Interval], t: Interval) -> [Interval; 3] {
        let contact = &self.contacts[stop];
        let [place, speed, bend] = contact.place(t).map(|x| -x);
        let still = [dot(&contact.row, rest) + place, speed, bend];
        self.response.iter().fold(still, |[value, slope, bend], (k, alpha, beta)| {
            let (cos, sin) = circle(*k, t);
            let [a, b] = [alpha, beta].map(|x| dot(&contact.row, x));
            let here = a * cos + b * sin;
            [value + here, slope + *k * (b * cos - a * sin), bend - *k * *k * here]
        })
    }

    /// q″.
    fn acceleration(&self, state: &[Interval], t: Interval) -> Vector {
        let (q, u) = state.split_at(self.size);
        let held = sum(&apply(&self.stiffness, q), &apply(&self.damping, u));
        let mut all = difference(&self.constant, &held);
        for (k, cosine, sine) in &self.forcing {
            let (cos, sin) = circle(*k, t);
            all = sum(&all, &sum(&scaled(cos, cosine), &scaled(sin, sine)));
        }
        all
    }

    /// (q′, q″).
    pub fn field(&self, state: &[Interval], t: Interval) -> Vector {
        [&state[self.size..], &self.acceleration(state, t)].concat()
    }

    /// The gap to a stop with its first two derivatives.
    pub fn gap(&self, stop: usize, state: &[Interval], t: Interval) -> [Interval; 3] {
        let (contact, (q, u)) = (&self.contacts[stop], state.split_at(self.size));
        let [place, speed, bend] = contact.place(t);
        [dot(&contact.row, q) - place, dot(&contact.row, u) - speed, self.bend(stop, state, t) - bend]
    }

    /// w·q″.
    fn bend(&self, stop: usize, state: &[Interval], t: Interval) -> Interval {
        dot(&self.contacts[stop].row, &self.acceleration(state, t))
    }
}

impl Contact {
    /// Q, Q′, Q″.
    pub fn place(&self, t: Interval) -> [Interval; 3] {
        let still = [self.offset, Interval::ZERO, Interval::ZERO];
        self.waves.iter().fold(still, |[value, slope, bend], &(k, a, b)| {
            let (cos, sin) = circle(k, t);
            let here = a * cos + b * sin;
            [value + here, slope + k * (b * cos - a * sin), bend - k * k * here]
        })
    }
}

/// α, β with α cos kt + β sin kt the response to a cos kt + b sin kt: (K̂ − k²) α + k Ĉ β = a, (K̂ − k²)
/// β − k Ĉ α = b.
fn answer(
    stiffness: &Matrix,
    damping: &Matrix,
    k: Interval,
    cos: &[Interval],
    sin: &[Interval],
) -> Option<(Vector, Vector)> {
    let n = stiffness.len();
    let mut left = vec![vec![Interval::ZERO; 2 * n]; 2 * n];
    for i in 0..n {
        for j in 0..n {
            let detuned = stiffness[i][j] - if i == j { k * k } else { Interval::ZERO };
            let turned = k * damping[i][j];
            (left[i][j], left[n + i][n + j]) = (detuned, detuned);
            (left[i][n + j], left[n + i][j]) = (turned, -turned);
        }
    }
    let right = transposed(&[[cos, sin].concat()]);
    let solution = linear::solve(&left, &right, true)?.solution;
    let mut all = transposed(&solution).swap_remove(0);
    let beta = all.split_off(n);
    Some((all, beta))
}
