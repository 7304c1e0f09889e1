//! Whether flights contract, letter after letter: then one bound serves the linear problem of every word.
//!
//! For periods n with C Aⁿ B ≠ 0 let T_n x = Aⁿ (x − (C Aⁿ x/C Aⁿ B) B), a flight of n iterates after the
//! kick along B that makes C x = 0 at its end. If L flights halve every vector, whatever their periods, the
//! linear problem (28) has one bound for all words over these periods, and Theorem 1 one δ and one µ₀
//! (`proofs/theorem1.md`, chapter 9, proved in Coq).
//!
//! T_n B = 0, and T_n ends in the plane C x = 0: of the coordinates in which C reads off the first and B
//! pushes along the last, N − 2 remain. Words are run as a tree, each until its product halves every vector;
//! if the tree is finite some L serves, since a long word is a row of such words and a rest that is bounded.
//! That it is not so is seen by a word with |trace| > N − 2: it has an eigenvalue beyond 1.

use super::{Coordinates, Map, Matrix};
use crate::{
    error::{Error, Result},
    monitor::Monitor,
    number::{FloatInterval, Real, Sign},
};

/// What is known of the flights of a map.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Flights {
    /// The periods that are asked about.
    pub periods: Vec<u64>,
    /// Those left out, because C Aⁿ B is 0 or may be.
    pub without: Vec<u64>,
    /// What they do together.
    pub together: Together,
}

/// What flights do, one after the other.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Together {
    /// They contract: after at most so many every vector of the plane C x = 0 is halved, by its largest entry
    /// in coordinates in which C reads off the first and B pushes along the last. One bound serves all words.
    Contract(usize),
    /// They do not: this word, flown again and again, has an eigenvalue beyond 1.
    Grow(Vec<u64>),
    /// Neither was shown within [`Flights::WORK`] products, or the numbers are too wide.
    Open,
}

/// The longest word whose eigenvalues are looked at, and the most times that it is squared.
const LOOKED_AT: usize = 3;
const SQUARES: usize = 6;
/// The longest words.
const DEPTH: usize = 64;

impl Flights {
    /// The most products.
    pub const WORK: usize = 100_000;

    /// Those of the periods 1 to `last`. Cost: O(`last`·N³), and up to [`Flights::WORK`] products of N³
    /// operations, on `f64` intervals.
    ///
    /// # Errors
    /// An interruption.
    pub fn new(map: &Map, last: u64, monitor: &dyn Monitor) -> Result<Flights> {
        let mut flights = Flights { periods: Vec::new(), without: Vec::new(), together: Together::Open };
        let Some(map) = Coordinates::<FloatInterval>::new(map, last, ()) else {
            flights.without = (1..=last).collect();
            return Ok(flights);
        };
        let mut all = Vec::new();
        for n in 1..=last {
            match flight(&map, n) {
                Some(flight) => {
                    flights.periods.push(n);
                    all.push(flight);
                }
                None => flights.without.push(n),
            }
        }
        if !all.is_empty() {
            let mut tree = Tree { flights: &all, left: Flights::WORK, deepest: 0, monitor };
            let alone = all.iter().position(grows).map(|letter| vec![letter]);
            let found =
                alone.map_or_else(|| tree.halves(&mut Vec::new(), None), |word| Err(Stop::Grows(word)));
            flights.together = match found {
                Ok(()) => Together::Contract(tree.deepest),
                Err(Stop::Grows(word)) => {
                    Together::Grow(word.into_iter().map(|letter| flights.periods[letter]).collect())
                }
                Err(Stop::Work) => Together::Open,
                Err(Stop::Asked(error)) => return Err(error),
            };
        }
        Ok(flights)
    }
}

/// T_n on the N − 2 coordinates between the first and the last, and, as a last row, what it adds along B.
/// `None` if C Aⁿ B may be 0.
fn flight(map: &Coordinates<FloatInterval>, n: u64) -> Option<Matrix<FloatInterval>> {
    let (power, response, size) = (map.power(n), *map.response(n), map.dimension());
    response.sign().filter(|&sign| sign != Sign::Zero)?;
    // The kick, with the sign turned.
    let kick = |j: usize| power[(0, j)] / &response;
    let entry = |i: usize, j: usize| power[(i, j)] - &(power[(i, size - 1)] * &kick(j));
    let row = |i: usize| (1..size - 1).map(|j| entry(i, j)).collect();
    Some(Matrix::from_rows((1..size).map(row).collect()))
}

/// Words, letter by letter, as far as no product halves every vector.
struct Tree<'a> {
    flights: &'a [Matrix<FloatInterval>],
    left: usize,
    deepest: usize,
    monitor: &'a dyn Monitor,
}

/// Why the tree is left before its end.
enum Stop {
    /// A word has an eigenvalue beyond 1.
    Grows(Vec<usize>),
    /// No more is run.
    Work,
    /// It was interrupted.
    Asked(Error),
}

impl Tree<'_> {
    /// That every word that begins so comes to halve every vector, or why that is not shown.
    fn halves(
        &mut self,
        word: &mut Vec<usize>,
        product: Option<&Matrix<FloatInterval>>,
    ) -> std::result::Result<(), Stop> {
        if word.len() >= DEPTH {
            return Err(Stop::Work);
        }
        for (letter, flight) in self.flights.iter().enumerate() {
            self.left = self.left.checked_sub(1).ok_or(Stop::Work)?;
            self.monitor.advance(0).map_err(Stop::Asked)?;
            let next = product.map_or_else(|| flight.clone(), |product| flight.times(&square(product), &()));
            word.push(letter);
            self.deepest = self.deepest.max(word.len());
            if word.len() <= LOOKED_AT && grows(&next) {
                return Err(Stop::Grows(word.clone()));
            }
            if norm(&next) > 0.5 {
                self.halves(word, Some(&next))?;
            }
            word.pop();
        }
        Ok(())
    }
}

/// A product without its last row: what flies on.
fn square(product: &Matrix<FloatInterval>) -> Matrix<FloatInterval> {
    Matrix::from_rows((0..product.columns()).map(|i| product.row(i).to_vec()).collect())
}

/// An upper bound of the maximum norm; infinite if nothing is known.
fn norm(matrix: &Matrix<FloatInterval>) -> f64 {
    let size = |x: &FloatInterval| FloatInterval::from_bounds(0.0, x.lo().abs().max(x.hi().abs()));
    let row = |i: usize| {
        let sum = matrix.row(i).iter().fold(FloatInterval::integer(0, &()), |sum, x| sum + &size(x)).hi();
        if sum.is_nan() { f64::INFINITY } else { sum }
    };
    (0..matrix.rows()).map(row).fold(0.0, f64::max)
}

/// Whether an eigenvalue is certainly beyond 1: the trace of a power says so.
fn grows(product: &Matrix<FloatInterval>) -> bool {
    let size = product.columns();
    let mut power = square(product);
    for _ in 0..=SQUARES {
        let trace = (0..size).fold(FloatInterval::integer(0, &()), |sum, i| sum + &power[(i, i)]);
        if trace.lo() > size as f64 || trace.hi() < -(size as f64) {
            return true;
        }
        power = power.times(&power, &());
    }
    false
}

#[cfg(test)]
mod tests {
    use super::{Flights, Together};
    use crate::pattern::{Entry, Map};

    /// A in coordinates with C = (1, 0, …), B = (…, 0, 1).
    fn flights(a: &[&[&str]], last: u64) -> Flights {
        let entry = |x: &&str| {
            let x = crate::number::parse_rational(x).unwrap();
            Entry::between(x.clone(), x).unwrap()
        };
        let size = a.len();
        let unit = |k: usize| (0..size).map(|i| entry(&if i == k { "1" } else { "0" })).collect();
        let rows = a.iter().map(|row| row.iter().map(entry).collect()).collect();
        let map = Map::new(rows, unit(size - 1), unit(0), entry(&"1"), None).unwrap();
        Flights::new(&map, last, &()).unwrap()
    }

    /// In the plane nothing is left after two flights. Beside it a coordinate that no kick moves contracts or
    /// grows by itself, whatever the word.
    #[test]
    fn a_coordinate_by_itself_decides() {
        let plane = flights(&[&["9/10", "1"], &["-3/5", "0"]], 6);
        assert!(matches!(plane.together, Together::Contract(_)), "{plane:?}");
        let beside = |x: &str| flights(&[&["9/10", "0", "1"], &["0", x, "0"], &["-3/5", "0", "0"]], 4);
        assert_eq!(beside("1/3").together, Together::Contract(1));
        assert_eq!(beside("9/10").together, Together::Contract(7));
        assert_eq!(beside("-11/10").together, Together::Grow(vec![1]));
        // det(I − A) ≠ 0 wants no eigenvalue 1; nearly 1 takes longer words than are run.
        assert_eq!(beside("9999999/10000000").together, Together::Open);
    }
}
