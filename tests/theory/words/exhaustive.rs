//! The word against the general solver of Theorem 1, pattern by pattern: the solver knows nothing of two
//! dimensions, of p and q, or of words.
//!
//! `GRAZING_SAMPLES=84 cargo test --release --test theory words::exhaustive -- --nocapture` judges as
//! many and prints the counts.

use crate::samples::samples;

use grazing::local::{Ladder, Plane, Point};
use grazing::pattern::{Analysis, Map, Numbers, Pattern, Patterns};
use grazing::word::{Edge, Relation, Word};
use num_rational::BigRational;

use super::q;

/// The largest period of a pattern: 789 patterns up to rotation.
const PERIOD: u64 = 12;

/// A map with this trace and determinant and this sign of γ = C A B.
pub fn map(a1: &BigRational, a2: &BigRational, gamma: bool) -> Map {
    let sign = |negative: bool| if negative { "-" } else { "" };
    let text = format!(
        "format = \"grazing-map 1\"\nA = [[\"{a1}\", \"{}1\"], [\"{}{a2}\", \"0\"]]\nB = [0, 1]\nC = [1, 0]\ne = 1\n",
        sign(!gamma),
        sign(gamma),
    );
    Map::from_toml(&text, "map").unwrap()
}

#[test]
fn words_agree_with_the_solver_of_every_pattern() {
    let wanted: usize = samples(12_000);
    let patterns: Vec<Pattern> = (1..=PERIOD).flat_map(Patterns::of_period).collect();
    let ladder = Ladder::default();
    let (mut judged, mut born, mut open, mut seed) = (0, 0, 0, 0u64);
    while judged < wanted {
        // Every region, near r = 1 more often than not; a lattice without pattern.
        seed += 1;
        let a2 = q(1 + (seed * 389 % 1000) as i64, 1000);
        let a1 = q(-2200 + (seed * 1597 % 4400) as i64, 1000);
        let a2 = if seed.is_multiple_of(2) { (a2 + q(9, 1)) / q(10, 1) } else { a2 };
        let point = Point::Plane(Plane::new(a1.clone(), a2.clone()).unwrap());
        let words = [true, false].map(|positive| Word::at(&ladder, &point, positive, 200, &()).unwrap());
        for gamma in [true, false] {
            let map = map(&a1, &a2, gamma);
            let analysis = Analysis::new(&map, PERIOD, Numbers::Enclosed);
            let relations = words.each_ref().map(|word| Relation::new(word, gamma, false, PERIOD).unwrap());
            for pattern in &patterns {
                let report = analysis.judge(pattern.periods());
                let edges = relations.each_ref().map(|relation| relation.pattern(pattern.periods()));
                judged += 1;
                if report.is_open() {
                    assert!(
                        edges.contains(&Edge::Open),
                        "{a1} {a2} {pattern}: the solver is open, the word is not"
                    );
                    open += 1;
                    continue;
                }
                let claimed = match edges {
                    [Edge::Yes, Edge::No] => Some(true),
                    [Edge::No, Edge::Yes] => Some(false),
                    [Edge::No, Edge::No] => None,
                    _ => panic!("{a1} {a2} {pattern}: {edges:?} where the solver is not open"),
                };
                assert_eq!(report.side(), claimed, "{a1} {a2} gamma > 0: {gamma} {pattern}");
                born += usize::from(claimed.is_some());
            }
        }
    }
    println!(
        "{judged} patterns at {seed} points, both signs of gamma: {born} born, {open} open, none different"
    );
    assert!(born > judged / 50 && judged - born > judged / 50);
}
