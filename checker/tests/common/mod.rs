//! What the tests share.

#![allow(dead_code)]

use grazing_check::{Checked, Rejection, check};

pub const THEOREM2: &str = include_str!("../data/theorem2.txt");
pub const COVER: &str = include_str!("../data/cover.txt");
pub const ORBIT_4: &str = include_str!("../data/orbit-4.txt");
pub const SADDLE_NODE: &str = include_str!("../data/event-sn.txt");
pub const FLIP: &str = include_str!("../data/event-pd.txt");
pub const GRAZING: &str = include_str!("../data/event-gr3.txt");
pub const ORBIT_6: &str = include_str!("../data/orbit-6.txt");
pub const CHAOS_12: &str = include_str!("../data/chaos-12.txt");
pub const CHAOS_123: &str = include_str!("../data/chaos-123.txt");
pub const CHAOS_MIRRORED: &str = include_str!("../data/chaos-mirrored.txt");
pub const CHAOS_MIRRORED_BEFORE: &str = include_str!("../data/chaos-mirrored-before.txt");
pub const RANGE_1: &str = include_str!("../data/range-1.txt");
pub const RANGE_12: &str = include_str!("../data/range-12.txt");
pub const RANGE_13: &str = include_str!("../data/range-13.txt");
pub const WORD: &str = include_str!("../data/word.txt");
pub const ENTROPY: &str = include_str!("../data/entropy.txt");
pub const WORD_BY_THEOREM: &str = include_str!("../data/word-by-theorem.txt");

pub fn answer(text: &str) -> Result<Checked, Rejection> {
    check(&mut text.as_bytes())
}

/// The rejection in words.
pub fn rejected(text: &str) -> String {
    answer(text).map_or_else(|rejection| rejection.to_string(), |checked| panic!("accepted: {checked}"))
}

/// The text with the first line that begins with `start` replaced by other lines, if any.
pub fn with(text: &str, start: &str, lines: &str) -> String {
    let at = text.lines().position(|line| line.starts_with(start)).expect("the line is there");
    let all = text.lines().enumerate().map(|(i, line)| if i == at { lines } else { line });
    all.filter(|line| !line.is_empty()).map(|line| format!("{line}\n")).collect()
}

/// The text with the digest that belongs to its system.
pub fn resealed(text: &str) -> String {
    let Err(rejection) = answer(text) else { return text.to_string() };
    match rejection.to_string().split_once("which is ") {
        Some((_, digest)) => with(text, "digest", &format!("digest {digest}")),
        None => text.to_string(),
    }
}
