//! What this chapter asks of a system: motions that can be followed from any start, states as a section sees
//! them, vectors that a motion's derivative carries along. Oscillators have it in `one::attractor`, machines
//! in `many::section`.

use std::fmt::Debug;

use serde::{Deserialize, Serialize, de::DeserializeOwned};

use crate::{
    error::{Error, Result},
    motion::{RunEnd, Time},
};

/// A state on a section.
pub trait SectionState: Clone + Debug + PartialEq + Send + Sync + Serialize + DeserializeOwned {
    /// The two numbers by which it is drawn, but for the unit of time.
    fn plane(&self) -> [f64; 2];

    /// All numbers by which states are told apart, of one unit.
    fn coordinates(&self) -> &[f64];

    /// Whether the other is this close in every coordinate.
    fn near(&self, other: &Self, tolerance: f64) -> bool {
        let (a, b) = (self.coordinates(), other.coordinates());
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
    }

    /// Whether all its numbers are finite.
    fn is_finite(&self) -> bool {
        self.plane().iter().chain(self.coordinates()).all(|x| x.is_finite())
    }
}

/// How far a motion goes, and how hard it hits.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Range {
    /// The least and the greatest of the first number that is drawn.
    pub extent: [f64; 2],
    /// The greatest speed at which a stop is met, if one is.
    pub speed: Option<f64>,
    /// The same per radian of the forcing, 0 if none is met: a length, as the extent.
    pub(crate) hit: f64,
}

impl Range {
    /// Of nothing yet.
    pub(crate) const NONE: Range =
        Range { extent: [f64::INFINITY, f64::NEG_INFINITY], speed: None, hit: 0.0 };

    /// Widened by a place.
    pub fn widen(&mut self, at: f64) {
        self.extent = [self.extent[0].min(at), self.extent[1].max(at)];
    }

    /// A stop is met at this speed per radian of the forcing, if one is; `rate` is radians in a unit of time.
    pub(crate) fn meet(&mut self, hit: Option<f64>, rate: f64) {
        self.speed = self.speed.into_iter().chain(hit.map(|hit| hit * rate)).reduce(f64::max);
        self.hit = hit.map_or(self.hit, |hit| self.hit.max(hit));
    }

    /// How differently two motions go: the largest difference of the ends of their extents and of their
    /// fastest impacts. Between two stops it is impacts alone that tell.
    pub(crate) fn moved(&self, other: &Range) -> f64 {
        let ends = [0, 1].map(|i| (self.extent[i] - other.extent[i]).abs());
        ends[0].max(ends[1]).max((self.hit - other.hit).abs())
    }

    /// The same relative to the larger of their widths: 0 for the same, 1 for a motion that moved by its own
    /// width.
    pub(crate) fn apart(&self, other: &Range) -> f64 {
        let width = |[low, high]: [f64; 2]| high - low;
        let moved = self.moved(other);
        if moved == 0.0 { 0.0 } else { moved / width(self.extent).max(width(other.extent)) }
    }
}

/// A motion under way.
pub trait Motion {
    /// Its state on a section.
    type Point: SectionState;

    /// Periods between two looks at whether to go on.
    const CHUNK: u64;

    /// Where it is in time.
    fn time(&self) -> Time;

    /// How many impacts there were.
    fn impacts(&self) -> u64;

    /// Its state now.
    fn point(&self) -> Self::Point;

    /// On to `until`.
    ///
    /// # Errors
    /// Where a motion cannot go on for another reason than a [`RunEnd`].
    fn pass(&mut self, until: Time) -> Result<RunEnd>;

    /// The same, `seen` widened by where it is at events and at the end, and by the speeds at which stops are
    /// met, in the units that are drawn.
    ///
    /// # Errors
    /// Those of [`pass`](Self::pass).
    fn pass_seen(&mut self, until: Time, seen: &mut Range) -> Result<RunEnd>;
}

/// A motion with vectors that its derivative carries along.
pub trait Tangents {
    /// Where the motion is in time.
    fn time(&self) -> Time;

    /// The motion's state, as [`SectionState::coordinates`].
    fn coordinates(&self) -> Vec<f64>;

    /// The vectors, in the same coordinates.
    fn vectors(&self) -> Vec<Vec<f64>>;

    /// How many impacts there were.
    fn impacts(&self) -> u64;

    /// On to `goal`. To `growth`, an entry for each vector, is added the logarithm of the growth of the
    /// first; of the second, beside the first; and so on: −∞ for one that vanishes. The vectors are
    /// orthonormal before and after; with no entries they are as they are carried.
    ///
    /// # Errors
    /// Those of [`Motion::pass`].
    fn grow(&mut self, goal: Time, growth: &mut [f64]) -> Result<RunEnd>;
}

/// A system whose motions can be followed.
pub trait Dynamics: Sync + Sized {
    /// The most motions that are worth following at once.
    const TOGETHER: usize = 1;

    /// A state with its phase, from which a motion can start.
    type Start: Clone + Send + Sync;
    /// A state on a section.
    type Point: SectionState;
    /// A motion.
    type Motion<'a>: Motion<Point = Self::Point>
    where
        Self: 'a;
    /// A motion with vectors.
    type Tangents<'a>: Tangents
    where
        Self: 'a;

    /// How many coordinates a state has.
    fn dimension(&self) -> usize;

    /// The motion from a start, at the forcing's period 0.
    ///
    /// # Errors
    /// A start behind a stop, or not finite.
    fn begin(&self, start: &Self::Start) -> Result<Self::Motion<'_>>;

    /// The start with these coordinates, as [`SectionState::coordinates`], at a phase.
    fn at(&self, coordinates: &[f64], phase: f64) -> Self::Start;

    /// The motion with a unit vector along each coordinate.
    fn along<'a>(&'a self, motion: Self::Motion<'a>) -> Self::Tangents<'a>;

    /// The eigenvalues, real and imaginary part, the largest modulus first, of a map's derivative in the same
    /// coordinates, by rows; none where it is not finite. Of two, the smaller follows from the modulus of the
    /// determinant, if that is known better than by cancellation.
    fn multipliers(slope: &[Vec<f64>], determinant: Option<f64>) -> Option<Vec<(f64, f64)>>;

    /// The start with these two numbers in the plane that is drawn, at a phase in [0, 2π).
    fn in_plane(&self, at: [f64; 2], phase: f64) -> Self::Start;

    /// The two numbers by which a state is drawn.
    fn drawn(&self, point: &Self::Point) -> [f64; 2] {
        point.plane()
    }

    /// How fast the coordinates of a motion change now, per radian; none where a drive moves the system, or
    /// it is not told.
    fn field(&self, _motion: &Self::Motion<'_>) -> Option<Vec<f64>> {
        None
    }

    /// How far each coordinate of the scene comes in so many radians from a start, along directions in which
    /// nothing holds the system; empty where all is held, or the motion ends.
    ///
    /// # Errors
    /// Those of [`Motion::pass`].
    fn drift(&self, _start: &Self::Start, _radians: f64) -> Result<Vec<f64>> {
        Ok(Vec::new())
    }

    /// Where a motion is, as a start.
    fn here(&self, motion: &Self::Motion<'_>) -> Self::Start;

    /// The motion with that many vectors, at least 1 and no more than the dimension.
    fn tangents<'a>(&'a self, motion: Self::Motion<'a>, count: usize) -> Self::Tangents<'a>;
}

/// Orthonormal vectors from these, in their order, with the logarithm of what is left of each beside those
/// before it. What is left of a vector that is at most `floor` times as long as it was counts as nothing.
pub(crate) fn orthonormalise<V: AsMut<[f64]> + AsRef<[f64]>>(
    frame: &mut [V],
    growth: &mut [f64],
    floor: f64,
) {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // By squares where these neither vanish nor overflow.
    let size = |v: &[f64]| match dot(v, v) {
        square @ 1e-280..1e280 => square.sqrt(),
        _ => v.iter().fold(0.0, |sum: f64, x| sum.hypot(*x)),
    };
    for (i, growth) in growth.iter_mut().enumerate().take(frame.len()) {
        let (before, rest) = frame.split_at_mut(i);
        let vector = rest[0].as_mut();
        let whole = size(vector);
        // Twice is enough.
        for _ in 0..if before.is_empty() { 0 } else { 2 } {
            for known in before.iter() {
                let part = dot(known.as_ref(), vector);
                vector.iter_mut().zip(known.as_ref()).for_each(|(x, y)| *x -= part * y);
            }
        }
        let mut left = size(vector);
        if left <= floor * whole {
            vector.fill(0.0);
            left = 0.0;
        }
        *growth += left.ln();
        if left > 0.0 {
            vector.iter_mut().for_each(|x| *x /= left);
        }
    }
}

/// An error for a number of vectors that a system does not have.
pub(crate) fn check_count(count: usize, dimension: usize) -> Result<()> {
    if (1..=dimension).contains(&count) {
        return Ok(());
    }
    Err(Error::input(format!("{count} exponents; there are 1 to {dimension}")))
}
