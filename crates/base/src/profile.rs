//! Where time goes: how much each method decided and how long it took. Kept only where it is asked for.

use std::{
    collections::BTreeMap,
    fmt::Display,
    sync::{Mutex, PoisonError},
    time::Duration,
};

use crate::processor::Stopwatch;

/// Cases and time by method, added up from any thread.
#[derive(Debug, Default)]
pub struct Profile(Mutex<BTreeMap<String, Spent>>);

/// What one method did.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Spent {
    /// What it decided: signs, periods, orbits.
    pub cases: u64,
    /// For how long it worked, tries of cheaper methods on the same cases included, on all threads together.
    pub time: Duration,
}

impl Profile {
    /// Adds what a method decided since `start`.
    pub fn since(&self, start: Stopwatch, method: impl Display, cases: u64) {
        self.add(method, cases, start.elapsed());
    }

    /// Adds cases and time.
    pub fn add(&self, method: impl Display, cases: u64, time: Duration) {
        let mut rows = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let row = rows.entry(method.to_string()).or_default();
        row.cases += cases;
        row.time += time;
    }

    /// Every method, by its name.
    pub fn rows(&self) -> Vec<(String, Spent)> {
        let rows = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        rows.iter().map(|(method, spent)| (method.clone(), *spent)).collect()
    }

    /// All of them together.
    pub fn total(&self) -> Spent {
        self.rows().iter().fold(Spent::default(), |sum, (_, row)| Spent {
            cases: sum.cases + row.cases,
            time: sum.time + row.time,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_add_up() {
        let profile = Profile::default();
        profile.add("b", 2, Duration::from_secs(1));
        profile.add("a", 1, Duration::from_secs(5));
        profile.add("b", 3, Duration::from_secs(2));
        let spent = |cases, seconds| Spent { cases, time: Duration::from_secs(seconds) };
        assert_eq!(profile.rows(), [("a".to_string(), spent(1, 5)), ("b".to_string(), spent(5, 3))]);
        assert_eq!(profile.total(), spent(6, 8));
    }
}
