//! How many gaps and values are proved by cells. Run with `GRAZING_SAMPLES=250 cargo test -p grazing-prove
//! --lib attractor::numbers::cells::most -- --nocapture` for three times 500 machines, and with 20 and
//! `cells::gaps` for 20 gaps and 20 windows.

use num_rational::BigRational;

use super::{
    super::{
        AttractorProblem,
        cells::{CellsProblem, CellsProof, prove_cells},
        prove_attractor, windows,
    },
    Measured, Random, enough, machine, reaches, samples,
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

impl Measured {
    /// Whether cells prove a machine at a depth.
    fn cells(&mut self, problem: &AttractorProblem, depth: f64) -> bool {
        let AttractorProblem { ranges, harmonics, .. } = problem.clone();
        let cells = CellsProblem { ranges, harmonics, depths: about(depth) };
        let Ok(CellsProof { certificate, accepted, growth, .. }) =
            self.timed(|| prove_cells(&cells, &()).unwrap())
        else {
            return false;
        };
        self.add(accepted.text(), growth, &Seen::new(problem, &certificate.setting, &certificate.cells));
        true
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
            if gaps.cells(&problem, depth) {
                assert!(!stable_there(&problem, outer, depth) && !stable_there(&problem, inner, depth));
            }
        }
        let depth = (outer.depths[0] * outer.depths[1]).sqrt();
        if stable < wanted && stable_there(&problem, outer, depth) {
            assert!(!gaps.cells(&problem, depth), "both are proved at {depth} of {problem:?}");
            stable += 1;
        }
    }
    println!(
        "of {told} gaps {} are proved, of {stable} windows with a proved orbit none: {gaps}",
        gaps.proved
    );
    assert!(
        gaps.proved == wanted && stable == wanted && enough(gaps.proved, told, 0.8),
        "{} of {told}",
        gaps.proved
    );
}

/// At 1.01 and 1.001 of the value at the touch, by formulas or cells.
#[test]
fn most_values_above_two_thirds_are_proved() {
    for (lambdas, far, least) in
        [([0.667, 0.7], 1.01, 0.7), ([0.7, 0.95], 1.01, 0.97), ([0.7, 0.95], 1.001, 0.99)]
    {
        let (mut random, mut cells) = (Random(7), Measured::default());
        let (number, mut formulas, mut either) = (samples::<usize>(2), 0, 0);
        for _ in 0..number {
            let problem = AttractorProblem { deepest: 1.0 - 1.0 / far, ..machine(&mut random, lambdas) };
            let whole = prove_attractor(&problem, &()).unwrap().is_ok_and(|proof| reaches(&proof, &problem));
            formulas += usize::from(whole);
            either += usize::from(cells.cells(&problem, problem.deepest) || whole);
        }
        let share = |count: usize| 100.0 * count as f64 / number as f64;
        println!(
            "lambda_1 {lambdas:?}: of {number} machines at {far} of the touch {:.1} % by formulas, {:.1} % by cells, {:.1} % \
             by either; cells: {cells}",
            share(formulas),
            share(cells.proved),
            share(either)
        );
        assert!(enough(either, number, least), "{lambdas:?}: {either} of {number}");
    }
}
