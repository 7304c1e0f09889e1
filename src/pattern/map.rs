//! The data of a grazing bifurcation: A, B, C, e, exact or enclosed, and what must be true of them.

use std::fmt;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::{
    Matrix, Report, Scalar,
    matrix::{Failure, certainly_invertible},
};
use crate::{
    error::{Error, Result},
    existence::Resonance,
    local::{Plane, Point},
    number::{Ball, Precision, Real, Sign},
};

/// A real number given exactly, or by two exact bounds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    lo: BigRational,
    hi: BigRational,
}

impl Entry {
    /// The number between two bounds.
    ///
    /// # Errors
    /// An input error if `lo` > `hi`.
    pub fn between(lo: BigRational, hi: BigRational) -> Result<Entry> {
        if lo > hi {
            return Err(Error::input(format!("lo = {lo} is above hi = {hi}")));
        }
        Ok(Entry { lo, hi })
    }

    /// The number, if it is exact.
    pub fn exact(&self) -> Option<&BigRational> {
        (self.lo == self.hi).then_some(&self.lo)
    }

    /// The sign, if it is certain.
    pub fn sign(&self) -> Option<Sign> {
        let (lo, hi) = (Sign::of(&self.lo), Sign::of(&self.hi));
        (lo == hi).then_some(lo)
    }

    /// Its enclosure on a rung; `None` if the rung is exact and the entry is not.
    pub(crate) fn on<T: Scalar>(&self, context: &T::Context) -> Option<T> {
        T::between(&self.lo, &self.hi, context)
    }
}

impl From<BigRational> for Entry {
    fn from(value: BigRational) -> Entry {
        Entry { lo: value.clone(), hi: value }
    }
}

impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.exact() {
            Some(x) => write!(f, "{x}"),
            None => write!(f, "[{}, {}]", self.lo, self.hi),
        }
    }
}

/// The local map at a grazing bifurcation, (1), (2), (5), (26): every condition of [`Map::new`] holds.
#[derive(Debug, Clone)]
pub struct Map {
    a: Matrix<Entry>,
    b: Vec<Entry>,
    c: Vec<Entry>,
    e: Entry,
    section: Option<Matrix<Entry>>,
    notes: Vec<String>,
}

/// Bits that decide about entries given as intervals, whose own width matters far more.
const BITS: u32 = 256;

/// Which part of a map breaks a condition: the key of the input file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Key(pub(crate) &'static str);

impl Map {
    /// The map x ↦ g(f(x, µ), µ) with A = D_x f, B, C = D_x h and e of (26); `section` is P of (12)–(14), in
    /// whose coordinates P x results are given. Cost: O(N³) operations for each of I − A and P, on exact
    /// numbers or balls of 256 bits; memory: O(N²) numbers.
    ///
    /// # Errors
    /// An input error that names the key, the value and the condition unless: A is N × N, N ≥ 2; B and C have
    /// N entries and are certainly not zero; C B = 0, or its enclosure contains 0; det(I − A) ≠ 0 certainly;
    /// P is N × N and certainly invertible.
    pub fn new(
        a: Vec<Vec<Entry>>,
        b: Vec<Entry>,
        c: Vec<Entry>,
        e: Entry,
        section: Option<Vec<Vec<Entry>>>,
    ) -> Result<Map> {
        Self::checked(a, b, c, e, section)
            .map_err(|(Key(key), condition)| Error::input(format!("{key}: {condition}")))
    }

    pub(super) fn checked(
        a: Vec<Vec<Entry>>,
        b: Vec<Entry>,
        c: Vec<Entry>,
        e: Entry,
        section: Option<Vec<Vec<Entry>>>,
    ) -> std::result::Result<Map, (Key, String)> {
        let size = a.len();
        square(&a, size).map_err(|text| (Key("A"), text))?;
        if size == 1 {
            return Err((Key("A"), "N = 1 is too small: C B = 0 with B and C not 0 needs N ≥ 2".into()));
        }
        for (key, vector) in [("B", &b), ("C", &c)] {
            if vector.len() != size {
                let text = format!("{} entries, but A is {size} × {size}", vector.len());
                return Err((Key(key), text));
            }
        }
        let a = Matrix::from_rows(a);
        let mut notes = Vec::new();
        for (key, vector) in [("B", &b), ("C", &c)] {
            if vector.iter().all(|x| x.sign().is_none_or(|sign| sign == Sign::Zero)) {
                let exact = vector.iter().all(|x| x.exact().is_some());
                let fault = if exact { "is" } else { "may be" };
                return Err((Key(key), format!("{} {fault} zero; {key} ≠ 0 is needed (5)", list(vector))));
            }
        }
        // An enclosure cannot show that C B is 0, only that it is not: then it is taken for 0, and said.
        let product = product(&c, &b);
        if product.exact().is_none() {
            if product.sign().is_some() {
                return Err((
                    Key("B"),
                    format!("C B lies in {product}, which does not contain 0; C B = 0 is needed (5)"),
                ));
            }
            notes.push(format!("C B lies in {product}; taken to be 0"));
        } else if !product.lo.is_zero() {
            return Err((Key("B"), format!("C B = {product}; C B = 0 is needed (5)")));
        }
        // Coordinates in which C B = 0 is exact are made by dividing by these two.
        pivots(&b, &c).ok_or((
            Key("B"),
            "C B = 0 needs entries C_i and B_j, i ≠ j, and the intervals do not show a pair that is certainly not 0".into(),
        ))?;
        let minus = matrix_minus(&a);
        invertible(&minus).map_err(|failure| match failure {
            Failure::Singular => (Key("A"), "det(I − A) = 0; det(I − A) ≠ 0 is needed (23)".into()),
            Failure::Unknown => {
                (Key("A"), "the enclosure of det(I − A) contains 0; det(I − A) ≠ 0 is needed (23)".into())
            }
        })?;
        let section = section
            .map(|rows| {
                square(&rows, size).map_err(|text| (Key("P"), text))?;
                let p = Matrix::from_rows(rows);
                invertible(&p).map_err(|failure| match failure {
                    Failure::Singular => (Key("P"), "det P = 0; P must be invertible (12)".to_string()),
                    Failure::Unknown => {
                        (Key("P"), "the enclosure of det P contains 0; P must be invertible (12)".to_string())
                    }
                })?;
                Ok(p)
            })
            .transpose()?;
        match e.sign() {
            Some(Sign::Zero) => notes.push("e = 0; Theorem 1 needs e ≠ 0 (26), so nothing is claimed for either sign of µ".into()),
            None => notes.push(format!(
                "e lies in {e}, which contains 0; Theorem 1 needs e ≠ 0 (26), so nothing is claimed for either sign of µ"
            )),
            Some(_) => {}
        }
        Ok(Map { a, b, c, e, section, notes })
    }

    /// N.
    pub fn dimension(&self) -> usize {
        self.b.len()
    }

    /// A.
    pub fn a(&self) -> &Matrix<Entry> {
        &self.a
    }

    /// B.
    pub(crate) fn b(&self) -> &[Entry] {
        &self.b
    }

    /// C.
    pub(crate) fn c(&self) -> &[Entry] {
        &self.c
    }

    /// e of (26).
    pub fn e(&self) -> &Entry {
        &self.e
    }

    /// P of (12), if given.
    pub fn section(&self) -> Option<&Matrix<Entry>> {
        self.section.as_ref()
    }

    /// Whether A, B, C and P are exact, so that every sign can be decided.
    pub fn is_exact(&self) -> bool {
        let exact = |matrix: &Matrix<Entry>| {
            (0..matrix.rows()).all(|i| matrix.row(i).iter().all(|x| x.exact().is_some()))
        };
        exact(&self.a)
            && self.b.iter().chain(&self.c).all(|x| x.exact().is_some())
            && self.section.as_ref().is_none_or(exact)
    }

    /// What is born of one impact in n periods where u_n = 0, of an exact map of two dimensions with 0 < a₂ <
    /// 1; `None` of others. Cost: O(1) operations on the map's numbers.
    pub(super) fn at_resonance(&self, n: u64) -> Option<Report> {
        if self.dimension() != 2 {
            return None;
        }
        let a = |i: usize, j: usize| self.a.row(i)[j].exact();
        let (b, c) = (|i: usize| self.b[i].exact(), |i: usize| self.c[i].exact());
        let plane = Plane::new(a(0, 0)? + a(1, 1)?, a(0, 0)? * a(1, 1)? - a(0, 1)? * a(1, 0)?).ok()?;
        if *plane.a2() >= BigRational::one() {
            return None;
        }
        let resonance = Resonance::at(&Point::Plane(plane), n)?;
        // C A B, which has the sign of gamma.
        let row = |j: usize| Some(c(0)? * a(0, j)? + c(1)? * a(1, j)?);
        let gamma = row(0)? * b(0)? + row(1)? * b(1)?;
        Some(Report::at_resonance(resonance, Sign::of(&gamma), n, self.e.sign()))
    }

    /// What is born of one impact in n ≥ 2 periods for all maps of two dimensions within these bounds, u_n =
    /// 0 perhaps among them, with 0 < a₂ < 1; `None` where that is not known. With N_k = u_n − u_k − a₂ᵏ
    /// u_{n−k} and D = det(I − Aⁿ), b_{n,k} = N_k/u_n and c_n = −D/u_n: where two N_k have opposite signs,
    /// none, and a u_n = 0 is a higher resonance, as at the first all N_k = −(1 − ζ) u_k < 0. Where all are
    /// negative and D > 0, the orbit of γ > 0 is that of eµ u_n < 0, and γ < 0 has none. Cost: O(n)
    /// operations on balls.
    pub(super) fn near_resonance(&self, n: u64) -> Option<Report> {
        let bits = Precision::new(BITS);
        let (a, n) = (convert::<Ball>(&self.a, &bits)?, usize::try_from(n).ok()?);
        if self.dimension() != 2 || n < 2 {
            return None;
        }
        let one = Ball::integer(1, &bits);
        let a1 = a[(0, 0)].clone() + &a[(1, 1)];
        let a2 = a[(0, 0)].clone() * &a[(1, 1)] - &(a[(0, 1)].clone() * &a[(1, 0)]);
        if a2.sign()? != Sign::Positive || (one.clone() - &a2).sign()? != Sign::Positive {
            return None;
        }
        let (mut u, mut power) = (vec![Ball::integer(0, &bits), one.clone()], vec![one.clone()]);
        for k in 1..=n {
            u.push(a1.clone() * &u[k] - &(a2.clone() * &u[k - 1]));
            power.push(power[k - 1].clone() * &a2);
        }
        let numerator = |k: usize| u[n].clone() - &u[k] - &(power[k].clone() * &u[n - k]);
        let signs: Vec<Option<Sign>> = (1..n).map(|k| numerator(k).sign()).collect();
        let has = |sign| signs.contains(&Some(sign));
        let e = self.e.sign();
        if has(Sign::Positive) && has(Sign::Negative) {
            return Some(Report::near_resonance(Resonance::Higher, Sign::Positive, e));
        }
        let trace = u[n + 1].clone() - &(a2 * &u[n - 1]);
        let is_first = signs.iter().all(|sign| *sign == Some(Sign::Negative))
            && (one - &trace + &power[n]).sign()? == Sign::Positive;
        let on = |x: &Entry| x.on::<Ball>(&bits);
        let (b, c) = ([on(&self.b[0])?, on(&self.b[1])?], [on(&self.c[0])?, on(&self.c[1])?]);
        let row = |j: usize| c[0].clone() * &a[(0, j)] + &(c[1].clone() * &a[(1, j)]);
        let gamma = (row(0) * &b[0] + &(row(1) * &b[1])).sign()?;
        is_first.then(|| Report::near_resonance(Resonance::First, gamma, e))
    }

    /// What a user should know about this map, one sentence each.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Indices i ≠ j with C_i ≠ 0 and B_j ≠ 0 certainly.
    pub(super) fn pivots(&self) -> (usize, usize) {
        pivots(&self.b, &self.c).unwrap_or((0, 1))
    }
}

fn square(rows: &[Vec<Entry>], size: usize) -> std::result::Result<(), String> {
    if rows.is_empty() {
        return Err("has no rows".into());
    }
    if rows.len() != size {
        return Err(format!("{} rows, but A has {size}", rows.len()));
    }
    match rows.iter().position(|row| row.len() != size) {
        Some(i) => Err(format!(
            "row {} has {} entries, but there are {size} rows; it must be square",
            i + 1,
            rows[i].len()
        )),
        None => Ok(()),
    }
}

fn list(vector: &[Entry]) -> String {
    format!("[{}]", vector.iter().map(Entry::to_string).collect::<Vec<_>>().join(", "))
}

/// Indices i ≠ j with C_i ≠ 0 and B_j ≠ 0 certainly, each the best by how far the entry stays from 0.
fn pivots(b: &[Entry], c: &[Entry]) -> Option<(usize, usize)> {
    let least = |x: &Entry| x.sign().filter(|&s| s != Sign::Zero).map(|_| x.lo.abs().min(x.hi.abs()));
    let mut pairs = Vec::new();
    for (i, c) in c.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            if let (true, Some(c), Some(b)) = (i != j, least(c), least(b)) {
                pairs.push((c * b, i, j));
            }
        }
    }
    let best = pairs.into_iter().reduce(|best, next| if next.0 > best.0 { next } else { best })?;
    Some((best.1, best.2))
}

/// Bounds of a product of two vectors.
fn product(c: &[Entry], b: &[Entry]) -> Entry {
    let (mut lo, mut hi) = (BigRational::zero(), BigRational::zero());
    for (c, b) in c.iter().zip(b) {
        let ends = [&c.lo * &b.lo, &c.lo * &b.hi, &c.hi * &b.lo, &c.hi * &b.hi];
        lo += ends.iter().min().unwrap_or(&ends[0]);
        hi += ends.iter().max().unwrap_or(&ends[0]);
    }
    Entry { lo, hi }
}

fn matrix_minus(a: &Matrix<Entry>) -> Matrix<Entry> {
    let entry = |i, j| {
        let one = if i == j { BigRational::one() } else { BigRational::zero() };
        let x: &Entry = &a[(i, j)];
        Entry { lo: &one - &x.hi, hi: one - &x.lo }
    };
    Matrix::from_rows((0..a.rows()).map(|i| (0..a.rows()).map(|j| entry(i, j)).collect()).collect())
}

fn invertible(matrix: &Matrix<Entry>) -> std::result::Result<(), Failure> {
    match convert::<BigRational>(matrix, &()) {
        Some(exact) => certainly_invertible(&exact),
        None => {
            let bits = Precision::new(BITS);
            convert::<Ball>(matrix, &bits).map_or(Err(Failure::Unknown), |balls| certainly_invertible(&balls))
        }
    }
}

/// The matrix on a rung; `None` if the rung is exact and an entry is not.
pub(super) fn convert<T: Scalar>(matrix: &Matrix<Entry>, context: &T::Context) -> Option<Matrix<T>> {
    let row = |i| matrix.row(i).iter().map(|x| x.on(context)).collect::<Option<Vec<T>>>();
    Some(Matrix::from_rows((0..matrix.rows()).map(row).collect::<Option<_>>()?))
}
