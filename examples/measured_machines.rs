//! How much is certain of machines known to 1 % in frequency and 20 % in damping ratio.
//!
//! Draws 600 machines for each of three damping ratios, their natural over drive frequency log-uniform from
//! 0.1 to 3, and counts those of which the full list of impact patterns is the same over the whole tolerance,
//! and those of which it is the same whether chaos is born, for each side of the touch. Every answer is
//! certain; what is not decided by 1000 cells is counted as open.
//!
//! ```sh
//! cargo run --release --example measured_machines
//! ```

use grazing::Result;
use grazing::number::parse_rational;
use grazing::tolerance::{ParameterBox, Partition, Spread, Statement};
use num_rational::BigRational;

const MACHINES: usize = 600;
const CELLS: u64 = 1_000;

/// The same choices everywhere: a linear congruence, its upper half from 0 to 1.
struct Drawn(u64);

impl Drawn {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) as f64 / 4_294_967_296.0
    }
}

/// How often something is the same on a box, differs, or is open.
#[derive(Default)]
struct Count([usize; 3]);

impl Count {
    fn add(&mut self, same: bool, differs: bool) {
        self.0[if same {
            0
        } else if differs {
            1
        } else {
            2
        }] += 1;
    }

    fn row(&self) -> String {
        self.0.map(|count| format!("{:5.1} %", 100.0 * count as f64 / MACHINES as f64)).join("  ")
    }
}

fn main() -> Result<()> {
    println!("damping   full list: same, differs, open   chaos: same, differs, open");
    for damping in ["0.005", "0.02", "0.1"] {
        let (mut list, mut chaos) = (Count::default(), Count::default());
        let mut drawn = Drawn(37);
        for _ in 0..MACHINES {
            let ratio = parse_rational(&format!("{:.6}", 0.1 * 30f64.powf(drawn.next())))?;
            let around = |middle: &BigRational, percent: i64| {
                let by = middle * BigRational::new(percent.into(), 100.into());
                [middle - &by, middle + by]
            };
            let machine = ParameterBox::machine(around(&ratio, 1), around(&parse_rational(damping)?, 20))?;
            let partition = Partition::new(&machine, CELLS, &())?;
            let words = [true, false].map(|positive| partition.words(positive).len());
            let gamma = |sign| partition.leaves().iter().any(|leaf| leaf.gamma == Some(sign));
            let differs = words.iter().any(|&count| count > 1) || (gamma(true) && gamma(false));
            let whole = partition.leaves().iter().all(|leaf| leaf.is_settled());
            list.add(whole && !differs, differs);
            let verdicts =
                [true, false].map(|positive| partition.share(Statement::ChaosAt { positive }).spread());
            let same = |verdict| matches!(verdict, Spread::Everywhere | Spread::Nowhere);
            chaos.add(verdicts.into_iter().all(same), verdicts.contains(&Spread::Differs));
        }
        println!("{damping:<8}  {}   {}", list.row(), chaos.row());
    }
    Ok(())
}
