//! What was evaluated, counted: the proof that an effect which a scene does not have costs nothing.

use std::sync::{
    Arc,
    atomic::{AtomicU64, Ordering},
};

/// What is counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Effect {
    /// A piece of the trajectory was looked at for impacts.
    Piece,
    /// Forcing or a moving wall entered a piece.
    Drive,
    /// The cubic stiffness entered a piece.
    Cubic,
    /// Another smooth force entered a piece.
    Smooth,
    /// The gap to the lower wall was formed on a piece.
    LowerGap,
    /// The gap to the upper wall was formed on a piece.
    UpperGap,
    /// A gap came close enough to 0 on a piece to be searched for minima.
    Search,
    /// A place of release from a wall was looked for.
    Release,
    /// A gap of a machine was bounded on a cell or a stretch of cells.
    Gap,
    /// A force of contact of a machine that rests was bounded on a cell or a stretch of cells.
    Force,
    /// The impulses at stops hit at one instant were found together.
    Together,
}

impl Effect {
    /// Those of an oscillator of one degree of freedom.
    pub const ALL: [Effect; 8] = [
        Effect::Piece,
        Effect::Drive,
        Effect::Cubic,
        Effect::Smooth,
        Effect::LowerGap,
        Effect::UpperGap,
        Effect::Search,
        Effect::Release,
    ];

    /// Those of machines.
    pub const OF_MACHINES: [Effect; 6] =
        [Effect::Piece, Effect::Smooth, Effect::Gap, Effect::Force, Effect::Search, Effect::Together];

    /// How many there are.
    const COUNT: usize = 11;

    /// Its name in reports and tables.
    pub fn name(self) -> &'static str {
        match self {
            Effect::Piece => "piece",
            Effect::Drive => "drive",
            Effect::Cubic => "cubic",
            Effect::Smooth => "smooth",
            Effect::LowerGap => "lower_gap",
            Effect::UpperGap => "upper_gap",
            Effect::Search => "search",
            Effect::Release => "release",
            Effect::Gap => "gap",
            Effect::Force => "force",
            Effect::Together => "together",
        }
    }
}

/// Told of each evaluation; `()` counts nothing and costs nothing.
pub trait Counter: Send {
    /// One more.
    fn count(&mut self, effect: Effect);
}

impl Counter for () {
    fn count(&mut self, _: Effect) {}
}

/// The numbers of evaluations so far.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Counts([u64; Effect::COUNT]);

impl Counts {
    /// How often an effect was evaluated.
    pub fn of(&self, effect: Effect) -> u64 {
        self.0[effect as usize]
    }
}

impl Counter for Counts {
    fn count(&mut self, effect: Effect) {
        self.0[effect as usize] += 1;
    }
}

impl<C: Counter> Counter for &mut C {
    fn count(&mut self, effect: Effect) {
        (**self).count(effect);
    }
}

/// A sum of counts that many threads add to.
#[derive(Debug, Default)]
pub struct EffectTally([AtomicU64; Effect::COUNT]);

impl EffectTally {
    /// How often an effect was evaluated.
    pub fn of(&self, effect: Effect) -> u64 {
        self.0[effect as usize].load(Ordering::Relaxed)
    }

    /// One more.
    pub fn count(&self, effect: Effect) {
        self.add(effect, 1);
    }

    /// That many more.
    pub fn add(&self, effect: Effect, count: u64) {
        self.0[effect as usize].fetch_add(count, Ordering::Relaxed);
    }
}

/// The counts of one run; they go to the tally when it ends.
pub(crate) struct Share {
    counts: Counts,
    tally: Arc<EffectTally>,
}

impl Share {
    pub fn of(tally: &Arc<EffectTally>) -> Share {
        Share { counts: Counts::default(), tally: tally.clone() }
    }

    /// That many more.
    pub fn add(&mut self, effect: Effect, times: u64) {
        self.counts.0[effect as usize] += times;
    }
}

impl Counter for Share {
    fn count(&mut self, effect: Effect) {
        self.counts.count(effect);
    }
}

impl Drop for Share {
    fn drop(&mut self) {
        for (sum, count) in self.tally.0.iter().zip(self.counts.0) {
            sum.fetch_add(count, Ordering::Relaxed);
        }
    }
}
