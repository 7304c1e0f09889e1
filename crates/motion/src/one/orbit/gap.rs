//! The gap to a wall along a linear motion, cell by cell: one product with a matrix, and no sine.
//!
//! The gap is z = σ x + d(t), x the homogeneous motion and d = σ (p − Q) the particular solution less the
//! wall, both times the wall's sign σ. At the ends of cells of equal width x comes from one matrix, and each
//! harmonic of d is turned by its own angle; every [`ANEW`] cells it starts from its sine and cosine again.
//! Not here: which cells have a minimum (`admissible`).

use crate::motion::{
    Contact, Series, State,
    algebra::{Matrix2, apply},
    flow::{Free, Linear},
};

/// Cells between two evaluations of the sines: turning errs by some 2 units in the last place a cell.
const ANEW: u32 = 16;

/// The gap to one wall along the motions of a linear oscillator.
pub(super) struct LinearGap<'f> {
    flow: &'f Linear,
    particular: Series,
    /// d.
    rest: Series,
    sign: f64,
}

impl<'f> LinearGap<'f> {
    /// The gap, if the motion has a closed form whose particular solution is periodic.
    pub fn new(flow: &'f Free, wall: &Contact) -> Option<Self> {
        let Free::Linear(flow) = flow else { return None };
        let (particular, sign) = (flow.periodic()?, wall.side.sign());
        let rest = Series::combination(&[(sign, &particular), (-sign, &wall.position)]);
        Some(LinearGap { flow, particular, rest, sign })
    }

    /// The homogeneous motion at a state.
    pub fn homogeneous(&self, at: State) -> [f64; 2] {
        let [p, slope, _] = self.particular.at(at.t);
        [at.q - p, at.u - slope]
    }

    /// z, z′, z″ where the homogeneous motion is x and d with its derivatives is `rest`.
    fn gap(&self, [x, v]: [f64; 2], rest: [f64; 3]) -> [f64; 3] {
        let equation = self.flow.equation();
        let bend = -equation.damping * v - equation.stiffness * x;
        [self.sign * x + rest[0], self.sign * v + rest[1], self.sign * bend + rest[2]]
    }

    /// z, z′, z″ a time `after` t, where the homogeneous motion was x at t.
    pub fn after(&self, x: [f64; 2], t: f64, after: f64) -> [f64; 3] {
        self.gap(apply(&self.flow.matrix(after), x), self.rest.at(t + after))
    }

    /// The cells of a width that follow each other from t, where the homogeneous motion is x.
    pub fn cells<'g>(&'g self, x: [f64; 2], t: f64, width: f64) -> Cells<'g, 'f> {
        let turns = self.rest.harmonics().iter().map(|harmonic| {
            let (sin, cos) = (f64::from(harmonic.k) * width).sin_cos();
            Turn { k: f64::from(harmonic.k), sin, cos, here: [0.0; 2] }
        });
        let turns = turns.collect();
        let matrix = self.flow.matrix(width);
        let mut cells = Cells { gap: self, matrix, width, start: t, x, begun: 0.0, count: 0, turns };
        cells.anew();
        cells
    }
}

/// One harmonic of d: the sine and cosine of its angle over a cell, its value and slope / k where it is.
struct Turn {
    k: f64,
    sin: f64,
    cos: f64,
    here: [f64; 2],
}

/// Cells one after another.
pub(super) struct Cells<'g, 'f> {
    gap: &'g LinearGap<'f>,
    matrix: Matrix2,
    width: f64,
    start: f64,
    /// The homogeneous motion where the next cell begins.
    pub x: [f64; 2],
    /// How long after the first cell it begins.
    pub begun: f64,
    count: u32,
    turns: Vec<Turn>,
}

impl Cells<'_, '_> {
    /// When the next cell begins.
    pub fn time(&self) -> f64 {
        self.start + self.begun
    }

    fn anew(&mut self) {
        let t = self.time();
        for (turn, harmonic) in self.turns.iter_mut().zip(self.gap.rest.harmonics()) {
            let (sin, cos) = (turn.k * t).sin_cos();
            turn.here = [harmonic.cos * cos + harmonic.sin * sin, harmonic.sin * cos - harmonic.cos * sin];
        }
    }

    /// z, z′, z″ where the next cell begins.
    pub fn gap(&self) -> [f64; 3] {
        let mut rest = [self.gap.rest.mean(), 0.0, 0.0];
        for Turn { k, here: [value, slope], .. } in &self.turns {
            rest = [rest[0] + value, rest[1] + k * slope, rest[2] - k * k * value];
        }
        self.gap.gap(self.x, rest)
    }

    /// On to the end of the cell.
    pub fn step(&mut self) {
        (self.x, self.count) = (apply(&self.matrix, self.x), self.count + 1);
        self.begun = f64::from(self.count) * self.width;
        if self.count.is_multiple_of(ANEW) {
            return self.anew();
        }
        for turn in &mut self.turns {
            let ([value, slope], Turn { sin, cos, .. }) = (turn.here, &*turn);
            turn.here = [value * cos + slope * sin, slope * cos - value * sin];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        motion::{Flow, Harmonic, System, Wall},
        one::orbit::Oscillator,
    };

    /// Many cells, several harmonics, both walls: as the flow and the wall say.
    #[test]
    fn the_gap_is_that_of_flow_and_wall() {
        let h = |k, cos, sin| Harmonic { k, cos, sin };
        let wall = |offset| {
            Some(Wall { offset, harmonics: vec![h(1, 0.3, -0.2), h(4, 0.0, 0.1)], restitution: 0.8 })
        };
        for (damping, stiffness) in [(0.2, 0.3), (0.0, 7.3), (3.0, 0.5), (0.1, -0.02)] {
            let system = System {
                rate: None,
                damping,
                stiffness,
                forcing: vec![h(1, 0.5, 0.25), h(2, -0.1, 0.0)],
                lower: wall(-1.0),
                upper: wall(2.0),
                ..System::default()
            };
            let oscillator = Oscillator::new(system, 1e-12).unwrap();
            let from = State { t: 0.7, q: 0.4, u: -0.3 };
            for wall in oscillator.walls() {
                let gap = LinearGap::new(oscillator.flow(), wall).unwrap();
                let mut cells = gap.cells(gap.homogeneous(from), from.t, 0.17);
                for cell in 0..100 {
                    let state = oscillator.flow().advance(from, 0.17 * f64::from(cell));
                    let expected = wall.motion(oscillator.flow(), state);
                    let again = gap.after(gap.homogeneous(from), from.t, 0.17 * f64::from(cell));
                    for i in 0..3 {
                        let size = 1.0 + 10.0 * (state.q.abs() + state.u.abs());
                        let tolerance = 1e-13 * size;
                        assert!((cells.gap()[i] - expected[i]).abs() < tolerance, "{cell} {i} {damping}");
                        assert!((again[i] - expected[i]).abs() < tolerance, "{cell} {i} {damping}");
                    }
                    cells.step();
                }
            }
        }
    }

    /// Where the particular solution grows there is no such gap.
    #[test]
    fn resonance_has_no_periodic_part() {
        let system = System {
            rate: None,
            stiffness: 1.0,
            forcing: vec![Harmonic { k: 1, cos: 1.0, sin: 0.0 }],
            lower: Some(Wall { offset: -1.0, harmonics: Vec::new(), restitution: 1.0 }),
            ..System::default()
        };
        let oscillator = Oscillator::new(system, 1e-12).unwrap();
        assert!(LinearGap::new(oscillator.flow(), &oscillator.walls()[0]).is_none());
    }
}
