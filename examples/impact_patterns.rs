//! Which orbits does a grazing bifurcation give birth to? Impact patterns of a three-dimensional map.
//!
//! Run with `cargo run --example impact_patterns`.

use grazing::pattern::{Analysis, Map, Numbers, Patterns};

const MAP: &str = r#"
format = "grazing-map 1"
A = [[0.9, 1, 0], [-0.6, 0, 0.1], [0.05, 0, "1/3"]]
B = [0, 1, 0.25]
C = [1, 0, 0]
e = -1
"#;

fn main() -> grazing::Result<()> {
    let map = Map::from_toml(MAP, "the map above")?;
    let analysis = Analysis::new(&map, 5, Numbers::Enclosed);
    for pattern in (1..=5).flat_map(Patterns::of_period).filter(|pattern| pattern.is_primitive()) {
        let report = analysis.judge(pattern.periods());
        let Some((side, orbit)) = report.side().zip(report.orbit) else { continue };
        // e < 0: eµ > 0 is µ < 0.
        let sign = if side { '<' } else { '>' };
        let (_, speed) = orbit.margins(side);
        println!("({pattern}) exists for small µ {sign} 0; its slowest impact has y = {speed} |eµ|");
    }
    Ok(())
}
