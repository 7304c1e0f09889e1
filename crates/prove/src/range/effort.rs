//! How much may be done for a proof: one number, of which the search, the checker and whoever else works for
//! it take what they do.

use std::cell::Cell;

/// Steps of a unit.
const STEPS: u64 = 3;

/// Work that may be done: legs that the search evaluates and steps of the checker, also those by which it
/// sees what is proved once more as a whole. Or a part of other work, which is done with it.
///
/// What is spent is counted, not timed: every computer comes as far. Three legs or steps are a unit, some
/// 30 µs.
#[derive(Debug)]
pub struct RangeEffort<'a> {
    /// Steps that may be done, and that are.
    most: u64,
    spent: Cell<u64>,
    whole: Option<&'a RangeEffort<'a>>,
}

impl Default for RangeEffort<'_> {
    fn default() -> Self {
        RangeEffort::new(RangeEffort::DEFAULT)
    }
}

impl RangeEffort<'_> {
    /// Units where nothing else is asked for.
    pub const DEFAULT: u64 = 100_000;

    /// So many units.
    pub const fn new(units: u64) -> Self {
        RangeEffort { most: units.saturating_mul(STEPS), spent: Cell::new(0), whole: None }
    }

    /// One in so many of the steps that are left.
    pub fn part(&self, share: u64) -> RangeEffort<'_> {
        RangeEffort { most: self.left() / share.max(1), spent: Cell::new(0), whole: Some(self) }
    }

    fn left(&self) -> u64 {
        let own = self.most.saturating_sub(self.spent.get());
        self.whole.map_or(own, |whole| own.min(whole.left()))
    }

    /// Whether none is left.
    pub fn is_spent(&self) -> bool {
        self.left() == 0
    }

    /// Spends steps, of the whole too; none if there were not so many: what is begun may have to be done.
    pub fn take(&self, steps: u64) -> Option<()> {
        self.spent.set(self.spent.get().saturating_add(steps));
        let of_whole = self.whole.map_or(Some(()), |whole| whole.take(steps));
        of_whole.filter(|()| self.spent.get() <= self.most)
    }

    /// Counts a step of a checker that asks whether to end; whether it should.
    pub(super) fn stops(&self) -> bool {
        self.take(1).is_none()
    }

    /// What the checker accepts is seen by it twice more: as a certificate, and in one of the machine's
    /// parameter. Takes as much as that is.
    pub(super) fn judged<T, E>(&self, judge: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        let before = self.spent.get();
        let found = judge();
        if found.is_ok() {
            let _ = self.take(2 * (self.spent.get() - before));
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_part_spends_is_spent_of_the_whole() {
        let whole = RangeEffort::new(10);
        assert_eq!(whole.left(), 30);
        let half = whole.part(2);
        let third = half.part(3);
        assert_eq!((half.left(), third.left()), (15, 5));
        assert!(third.take(5).is_some() && third.is_spent());
        assert_eq!((half.left(), whole.left()), (10, 25));
        // What has to be done is done, and counts.
        assert!(third.take(20).is_none());
        assert_eq!((third.left(), half.left(), whole.left()), (0, 0, 5));
        assert!(half.is_spent() && !whole.is_spent());
        // Another part of the whole has taken what this one was promised.
        let (first, second) = (whole.part(1), whole.part(1));
        assert!(first.take(4).is_some() && second.take(1).is_some());
        assert!(second.is_spent() && second.take(1).is_none());
        assert_eq!(RangeEffort::new(2).part(0).left(), 6);
        assert!(RangeEffort::new(u64::MAX).part(1).take(u64::MAX).is_some());
    }

    #[test]
    fn what_is_accepted_counts_three_times() {
        let effort = RangeEffort::new(10);
        let steps = |count: u64| (0..count).all(|_| !effort.stops());
        assert_eq!(effort.judged(|| if steps(4) { Err::<(), _>("false") } else { Ok(()) }), Err("false"));
        assert_eq!(effort.left(), 26);
        assert_eq!(effort.judged(|| if steps(5) { Ok::<_, &str>(()) } else { Err("ended") }), Ok(()));
        assert_eq!(effort.left(), 11);
    }
}
