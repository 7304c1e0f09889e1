//! Whether flights contract (`existence --uniform`), against products of flights as they are defined, in
//! floats and in the map's own coordinates.

use grazing::pattern::{Entry, Flights, Map, Together};
use num_rational::BigRational;
use proptest::{prelude::*, strategy::ValueTree, test_runner::TestRunner};

use crate::samples::samples;

type Vector = Vec<f64>;

/// A x = [x], C and B with C B = 0, in tenths.
#[derive(Debug, Clone)]
struct Tenths {
    a: Vec<Vec<i64>>,
    b: Vec<i64>,
    c: Vec<i64>,
}

fn tenths() -> impl Strategy<Value = Tenths> {
    let numbers = |count: usize, most: i64| prop::collection::vec(-most..=most, count);
    (3usize..=4, 2i64..=9).prop_flat_map(move |(size, most)| {
        let rows = prop::collection::vec(numbers(size, most), size);
        (rows, numbers(size - 1, 9), numbers(size - 1, 9)).prop_map(|(a, b, c)| {
            // C begins with 1, and B with what makes C B = 0.
            let first: i64 = -b.iter().zip(&c).map(|(b, c)| b * c).sum::<i64>();
            let b = [first].into_iter().chain(b.iter().map(|b| 10 * b)).collect();
            Tenths { a, b, c: [10].into_iter().chain(c).collect() }
        })
    })
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Tenths {
    fn map(&self) -> Option<Map> {
        let entry = |&x: &i64| Entry::from(BigRational::new(x.into(), 10.into()));
        let vector = |all: &[i64]| all.iter().map(entry).collect::<Vec<_>>();
        let a = self.a.iter().map(|row| vector(row)).collect();
        Map::new(a, vector(&self.b), vector(&self.c), BigRational::from_integer(1.into()).into(), None).ok()
    }

    /// Aⁿ x.
    fn power(&self, n: u64, x: &[f64]) -> Vector {
        let row = |row: &Vec<i64>, x: &[f64]| row.iter().zip(x).map(|(&a, x)| a as f64 / 10.0 * x).sum();
        (0..n).fold(x.to_vec(), |x, _| self.a.iter().map(|line| row(line, &x)).collect())
    }

    /// T_n x = Aⁿ (x − (C Aⁿ x/C Aⁿ B) B).
    fn flight(&self, n: u64, x: &[f64]) -> Vector {
        let [b, c] = [&self.b, &self.c].map(|all| all.iter().map(|&x| x as f64 / 10.0).collect::<Vector>());
        let kick = dot(&c, &self.power(n, x)) / dot(&c, &self.power(n, &b));
        let kicked: Vector = x.iter().zip(&b).map(|(x, b)| x - kick * b).collect();
        self.power(n, &kicked)
    }

    /// log |P x| − log |x| for the product P of a word's flights, x being made small again after each. Of
    /// several letters the one is flown after which the vector is longest.
    fn growth<'w>(&self, word: impl IntoIterator<Item = &'w [u64]>, start: &[f64]) -> f64 {
        let size = |x: &[f64]| dot(x, x).sqrt();
        let (mut x, mut all) = (start.to_vec(), 0.0);
        for letters in word {
            let next = letters.iter().map(|&n| self.flight(n, &x));
            let next = next.max_by(|x, y| size(x).total_cmp(&size(y))).unwrap();
            let now = size(&next);
            if now == 0.0 {
                return f64::NEG_INFINITY;
            }
            all += now.ln();
            x = next.iter().map(|x| x / now).collect();
        }
        all - size(start).ln()
    }
}

/// What contracts does so whichever letter comes next, at the rate that is said; what grows does by the word
/// that is said.
#[test]
fn flights_do_together_what_is_said() {
    let mut runner = TestRunner::deterministic();
    let [mut contract, mut grow, mut open] = [0; 3];
    for _ in 0..samples::<u32>(60) {
        let drawn = tenths().new_tree(&mut runner).unwrap().current();
        let Some(map) = drawn.map() else { continue };
        let found = Flights::new(&map, 4, &()).unwrap();
        let start = |i: usize| (0..drawn.b.len()).map(|j| ((3 * i + 5 * j) as f64 + 0.7).sin()).collect();
        let starts: Vec<Vector> = (0..3).map(start).collect();
        let growths = |word: &[&[u64]]| {
            let word = || word.iter().copied();
            starts.iter().map(|x| drawn.growth(word(), x)).fold(f64::NEG_INFINITY, f64::max)
        };
        match &found.together {
            Together::Contract(flights) => {
                contract += 1;
                // Halved 20 times, but for how far coordinates and the end of a word may stretch.
                let growth = growths(&vec![&found.periods[..]; 20 * flights]);
                assert!(growth < -15.0 * 2f64.ln(), "{drawn:?} {found:?}: {growth}");
            }
            Together::Grow(word) => {
                grow += 1;
                let letters: Vec<&[u64]> = word.iter().map(std::slice::from_ref).collect();
                let growth = growths(&letters.repeat(400));
                assert!(growth > -10.0, "{drawn:?} {found:?}: {growth}");
            }
            _ => open += 1,
        }
    }
    println!("{contract} contract, {grow} grow, {open} are open");
    assert!(contract > 10 && grow > 10, "{contract} contract, {grow} grow, {open} are open");
}
