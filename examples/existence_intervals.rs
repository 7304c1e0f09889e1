//! Which single-impact orbits exist at a given s on r = 1? Theorem 2's intervals, period by period.
//!
//! Run with `cargo run --example existence_intervals`.

use grazing::{existence::intervals, num_rational::Ratio};

fn main() -> grazing::Result<()> {
    let s = Ratio::new(21, 100);
    println!("s = {s}, r = 1:");
    for n in 1..=20 {
        for interval in intervals(n)?.filter(|interval| interval.left < s && s < interval.right) {
            println!("period {n:2} in the case {} on ({}, {})", interval.case, interval.left, interval.right);
        }
    }
    Ok(())
}
