//! What was evaluated, counted: the proof that an effect which a scene does not have costs nothing.

use std::{
    collections::BTreeMap,
    sync::{
        Arc,
        atomic::{AtomicU64, Ordering},
    },
};

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

/// What is counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Effect {
    /// A piece of a motion was looked at for impacts, or for minima of a gap.
    Piece,
    /// Forcing or a moving wall entered a piece or a step of the integrator.
    Drive,
    /// The cubic stiffness entered a step of the integrator.
    Cubic,
    /// Another smooth force entered a step of the integrator.
    Smooth,
    /// The gap to the lower wall was formed on a piece.
    LowerGap,
    /// The gap to the upper wall was formed on a piece.
    UpperGap,
    /// A gap was searched for a minimum on a piece, on which it came close enough to 0, or fell and rose.
    Search,
    /// A place of release from a wall was looked for.
    Release,
    /// A gap of a machine was bounded on a cell or a stretch of cells.
    Gap,
    /// A force of contact of a machine that rests was bounded on a cell or a stretch of cells.
    Force,
    /// A velocity where there is dry friction, or what sticks could hold more, was bounded on a cell or a
    /// stretch of cells.
    Friction,
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
    pub const OF_MACHINES: [Effect; 7] = [
        Effect::Piece,
        Effect::Smooth,
        Effect::Gap,
        Effect::Force,
        Effect::Friction,
        Effect::Search,
        Effect::Together,
    ];

    /// All.
    const EVERY: [Effect; Effect::COUNT] = [
        Effect::Piece,
        Effect::Drive,
        Effect::Cubic,
        Effect::Smooth,
        Effect::LowerGap,
        Effect::UpperGap,
        Effect::Search,
        Effect::Release,
        Effect::Gap,
        Effect::Force,
        Effect::Friction,
        Effect::Together,
    ];

    /// How many there are.
    const COUNT: usize = 12;

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
            Effect::Friction => "friction",
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

    /// What was counted since an earlier state of the same counts.
    #[must_use]
    pub(crate) fn since(&self, earlier: &Counts) -> Counts {
        Counts(std::array::from_fn(|i| self.0[i].saturating_sub(earlier.0[i])))
    }
}

/// A map from the names of those that are not 0.
impl Serialize for Counts {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let all = Effect::EVERY.into_iter().map(|effect| (effect.name(), self.of(effect)));
        all.filter(|(_, count)| *count > 0).collect::<BTreeMap<_, _>>().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Counts {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Counts, D::Error> {
        let mut counts = Counts::default();
        for (name, count) in BTreeMap::<String, u64>::deserialize(deserializer)? {
            let effect = Effect::EVERY.into_iter().find(|effect| effect.name() == name);
            let effect = effect.ok_or_else(|| D::Error::custom(format!("no effect {name:?}")))?;
            counts.0[effect as usize] = count;
        }
        Ok(counts)
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

    /// That many more.
    pub fn add(&self, effect: Effect, count: u64) {
        self.0[effect as usize].fetch_add(count, Ordering::Relaxed);
    }

    /// All that was counted elsewhere.
    pub(crate) fn add_all(&self, counts: &Counts) {
        for (sum, count) in self.0.iter().zip(counts.0) {
            sum.fetch_add(count, Ordering::Relaxed);
        }
    }

    /// What is counted so far.
    pub(crate) fn counts(&self) -> Counts {
        Counts(self.0.each_ref().map(|count| count.load(Ordering::Relaxed)))
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
        self.tally.add_all(&self.counts);
    }
}
