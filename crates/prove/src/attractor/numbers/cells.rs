//! How many gaps and values are proved by cells. Run with `GRAZING_SAMPLES=20 cargo test -p grazing-prove
//! --lib attractor::numbers -- --nocapture` for 20 gaps, 20 windows and twice 40 machines.

use grazing_base::processor::thread_seconds;
use num_rational::BigRational;

use super::{
    super::{
        AttractorProblem,
        cells::{CellsProblem, CellsProof, prove_cells},
        windows,
    },
    Random, machine, samples,
    seen::Seen,
    stable_there,
};

/// A depth, and those next to it.
fn about(depth: f64) -> [BigRational; 2] {
    [depth * (1.0 - 1e-6), depth * (1.0 + 1e-6)].map(|x| {
        let scale = 10i64.pow(14);
        BigRational::new(((x * scale as f64).round() as i64).into(), scale.into())
    })
}

/// What cells prove of a machine at a depth, and in how many seconds of a processor.
fn proved(problem: &AttractorProblem, depth: f64) -> (CellsProblem, Option<CellsProof>, f64) {
    let AttractorProblem { ranges, harmonics, .. } = problem.clone();
    let cells = CellsProblem { ranges, harmonics, depths: about(depth) };
    let start = thread_seconds();
    let proof = prove_cells(&cells, &()).unwrap().ok();
    (cells, proof, thread_seconds() - start)
}

/// The longest certificate, the longest time, and proved growths over those seen.
#[derive(Default)]
struct Measured {
    proved: usize,
    size: usize,
    seconds: f64,
    parts: Vec<f64>,
}

impl Measured {
    fn add(&mut self, problem: &AttractorProblem, depth: f64) -> bool {
        let (cells, proof, seconds) = proved(problem, depth);
        self.seconds = self.seconds.max(seconds);
        let Some(proof) = proof else { return false };
        self.proved += 1;
        self.size = self.size.max(proof.accepted.text().len());
        let seen = Seen::new(&cells, &proof).least_growth(4, 150);
        assert!(proof.growth < seen * (1.0 + 1e-6), "{} proved, {seen} seen", proof.growth);
        self.parts.push(proof.growth / seen);
        true
    }

    fn median(&self) -> f64 {
        let mut parts = self.parts.clone();
        parts.sort_by(f64::total_cmp);
        parts.get(parts.len() / 2).copied().unwrap_or(f64::NAN)
    }
}

/// In the gaps between the windows that are told weights are found, and in the windows, where the orbit is
/// proved stable, none.
#[test]
fn gaps_are_proved_and_windows_are_not() {
    let (wanted, mut random, mut gaps) = (samples::<usize>(1), Random(23), Measured::default());
    let (mut told, mut stable, mut tried) = (0, 0, 0);
    while (gaps.proved < wanted || stable < wanted) && tried < 20 * wanted {
        tried += 1;
        let problem = machine(&mut random, [0.26, 0.66]);
        let found = windows(&problem);
        let [_, outer, inner] = &found[..] else { continue };
        let gap = [inner.depths[1], outer.depths[0]];
        if gap[0] < gap[1] && gaps.proved < wanted {
            told += 1;
            let depth = (gap[0] * gap[1]).sqrt();
            if gaps.add(&problem, depth) {
                assert!(!stable_there(&problem, outer, depth) && !stable_there(&problem, inner, depth));
            }
        }
        let depth = (outer.depths[0] * outer.depths[1]).sqrt();
        if stable < wanted && stable_there(&problem, outer, depth) {
            let (_, proof, seconds) = proved(&problem, depth);
            assert!(proof.is_none(), "both are proved at {depth} of {problem:?}");
            gaps.seconds = gaps.seconds.max(seconds);
            stable += 1;
        }
    }
    println!(
        "of {told} gaps {} are proved, of {stable} windows with a proved orbit none; {} bytes, {:.2} s; median of proved \
         growth over seen {:.3}",
        gaps.proved,
        gaps.size,
        gaps.seconds,
        gaps.median()
    );
    assert!(
        gaps.proved == wanted && stable == wanted && gaps.proved * 2 >= told,
        "{} of {told}",
        gaps.proved
    );
}

/// At 1.01 of the value at the touch, by cells.
#[test]
fn most_values_above_two_thirds_are_proved() {
    for (lambdas, least) in [([0.667, 0.7], 0.6), ([0.7, 0.95], 0.97)] {
        let (mut random, mut all) = (Random(7), Measured::default());
        let number = samples::<usize>(2);
        for _ in 0..number {
            let problem = machine(&mut random, lambdas);
            all.add(&problem, 1.0 - 1.0 / 1.01);
        }
        let share = all.proved as f64 / number as f64;
        println!(
            "lambda_1 {lambdas:?}: of {number} machines {:.1} % at 1.01 of the touch by cells; {} bytes, {:.2} s; median \
             of proved growth over seen {:.3}",
            100.0 * share,
            all.size,
            all.seconds,
            all.median()
        );
        assert!(share >= least - 1.0 / number as f64, "{lambdas:?}: {share}");
    }
}
