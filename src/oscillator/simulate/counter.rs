//! What a simulation evaluated, counted: the proof that an effect which a scene does not have costs nothing.

/// What is counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effect {
    /// A piece of the trajectory was looked at for impacts.
    Piece,
    /// Forcing or a moving wall entered a piece.
    Drive,
    /// The cubic stiffness entered a piece.
    Cubic,
    /// The gap to the lower wall was formed on a piece.
    LowerGap,
    /// The gap to the upper wall was formed on a piece.
    UpperGap,
    /// A gap came close enough to 0 on a piece to be searched for minima.
    Search,
    /// A place of release from a wall was looked for.
    Release,
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
pub struct Counts([u64; 7]);

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
