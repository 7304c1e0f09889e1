//! A machine taken apart into what an engineer draws: masses, springs and dampers, so that a wrong sign is
//! seen.
//!
//! Of a matrix A the symmetric part S = (A + Aᵀ)/2 is made of springs: −S_ij between the coordinates i and j,
//! and the sum of row i of S from i to the ground. What is left, G = (A − Aᵀ)/2, is no spring: of the damping
//! it does no work (gyroscopic), of the stiffness it does (circulatory). A mass is M_ii, and M_ij an inertia
//! that two coordinates share. Sums are exact, of numbers as they are written: a spring that is not there is
//! 0, and not what rounding leaves of it. [`Couplings::entries`] is the way back, to the same numbers.
//!
//! Not here: stops, friction and forces, which a machine has one by one; and pictures.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{Machine, RealMatrix};

use crate::rounding::SUM;

/// A coefficient at the parameters' values.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluated {
    /// The value.
    pub value: BigRational,
    /// Whether it is exact; else it is a float, of a formula that is not rational.
    pub exact: bool,
}

impl Evaluated {
    /// The nearest float.
    pub fn float(&self) -> f64 {
        nearest(&self.value)
    }
}

/// The nearest float, where there is one.
fn nearest(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}

/// What stands between two coordinates, or between one and the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Coupling {
    /// The first coordinate.
    pub first: usize,
    /// The second one, of a greater number; without it the ground.
    pub second: Option<usize>,
    /// Its value, of either sign.
    pub value: BigRational,
    /// Whether the value may be no more than what is left of sums of rounded floats.
    pub rounding: bool,
}

/// A matrix as what stands between coordinates; zeros are left out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Couplings {
    /// The springs, or dampers.
    pub links: Vec<Coupling>,
    /// G_ij for i < j: what the entry at (i, j) is above that at (j, i), halved.
    pub skew: Vec<Coupling>,
}

/// A sum of coefficients.
#[derive(Debug, Clone)]
struct Sum {
    value: BigRational,
    exact: bool,
    size: f64,
}

impl Sum {
    fn zero() -> Sum {
        Sum { value: BigRational::zero(), exact: true, size: 0.0 }
    }

    fn add(&mut self, value: &BigRational, exact: bool) {
        self.value += value;
        self.exact &= exact;
        self.size += nearest(value).abs();
    }

    fn coupling(self, first: usize, second: Option<usize>) -> Option<Coupling> {
        // A formula has a few roundings of its own.
        let rounding = !self.exact && nearest(&self.value).abs() <= 16.0 * f64::EPSILON * self.size;
        let Sum { value, .. } = self;
        (!value.is_zero()).then_some(Coupling { first, second, value, rounding })
    }
}

impl Couplings {
    /// Those of a matrix, given by its entries, of which several at one place count together.
    pub fn of(entries: &[(usize, usize, Evaluated)]) -> Couplings {
        let mut places: BTreeMap<(usize, usize), [Sum; 2]> = BTreeMap::new();
        let mut rows: BTreeMap<usize, Sum> = BTreeMap::new();
        let two = BigRational::from_integer(2.into());
        for (i, j, Evaluated { value, exact }) in entries {
            if i == j {
                rows.entry(*i).or_insert_with(Sum::zero).add(value, *exact);
                continue;
            }
            let half = value / &two;
            let [link, skew] =
                places.entry((*i.min(j), *i.max(j))).or_insert_with(|| [Sum::zero(), Sum::zero()]);
            link.add(&-&half, *exact);
            skew.add(&if i < j { half.clone() } else { -&half }, *exact);
            for row in [i, j] {
                rows.entry(*row).or_insert_with(Sum::zero).add(&half, *exact);
            }
        }
        let mut all = Couplings::default();
        for (i, row) in rows {
            all.links.extend(row.coupling(i, None));
        }
        for ((i, j), [link, skew]) in places {
            all.links.extend(link.coupling(i, Some(j)));
            all.skew.extend(skew.coupling(i, Some(j)));
        }
        all
    }

    /// The entries of the matrix again, those that are not 0, by row and column.
    pub fn entries(&self) -> BTreeMap<(usize, usize), BigRational> {
        let mut all: BTreeMap<(usize, usize), BigRational> = BTreeMap::new();
        let mut add = |i, j, value: BigRational| {
            *all.entry((i, j)).or_insert_with(BigRational::zero) += value;
        };
        for Coupling { first, second, value, .. } in &self.links {
            add(*first, *first, value.clone());
            if let Some(second) = second {
                add(*second, *second, value.clone());
                add(*first, *second, -value);
                add(*second, *first, -value);
            }
        }
        for Coupling { first, second, value, .. } in &self.skew {
            let second = second.unwrap_or(*first);
            add(*first, second, value.clone());
            add(second, *first, -value);
        }
        all.retain(|_, value| !value.is_zero());
        all
    }
}

/// The matrices of a machine as masses, springs and dampers. Where shapes are given their coordinates are the
/// modes' amplitudes.
#[derive(Debug, Clone, PartialEq)]
pub struct Elements {
    /// M_ii where there is no second coordinate, else M_ij, an inertia that two coordinates share.
    pub masses: Vec<Coupling>,
    /// Those of K.
    pub springs: Couplings,
    /// Those of C, without what damping ratios add.
    pub dampers: Couplings,
}

/// Most coordinates of which the signs of the matrices are looked at.
const MOST: usize = 300;
impl Elements {
    /// Those of a machine.
    pub fn of(machine: &Machine<Evaluated>) -> Elements {
        let mut places: BTreeMap<(usize, usize), Sum> = BTreeMap::new();
        for (i, j, Evaluated { value, exact }) in machine.mass.iter().filter(|(i, j, _)| i <= j) {
            places.entry((*i, *j)).or_insert_with(Sum::zero).add(value, *exact);
        }
        let one = |((i, j), sum): ((usize, usize), Sum)| sum.coupling(i, (i != j).then_some(j));
        Elements {
            masses: places.into_iter().filter_map(one).collect(),
            springs: Couplings::of(&machine.stiffness),
            dampers: Couplings::of(&machine.damping),
        }
    }

    /// What is wrong or unusual in the matrices, in words; `name` says what a coordinate of theirs is called,
    /// `size` how many there are.
    pub fn remarks(&self, size: usize, name: &dyn Fn(usize) -> String) -> Vec<String> {
        let mut all = Vec::new();
        let float = |value: &BigRational| Short(nearest(value)).to_string();
        let springs = [(&self.springs, "spring", "stiffness"), (&self.dampers, "damper", "damping")];
        for (couplings, what, matrix) in springs {
            let negative = |one: &&Coupling| one.value.is_negative() && !one.rounding;
            for Coupling { first, second, value, .. } in couplings.links.iter().filter(negative) {
                let value = float(value);
                all.push(match second {
                    None => format!(
                        "negative {what} {value} from {} to the ground: row {} of `{matrix}` sums to {value}",
                        name(*first),
                        first + 1
                    ),
                    Some(second) => format!(
                        "negative {what} {value} between {} and {}: `{matrix}` has {} at row {}, column {}",
                        name(*first),
                        name(*second),
                        value.trim_start_matches('-'),
                        first + 1,
                        second + 1
                    ),
                });
            }
            for Coupling { first, second, value, .. } in couplings.skew.iter().filter(|one| !one.rounding) {
                let (i, j) = (*first, second.unwrap_or(*first));
                let does = match matrix {
                    "damping" => "gyroscopic: it does no work",
                    _ => "circulatory: going round, it feeds energy in or takes it out",
                };
                all.push(format!(
                    "`{matrix}` is not symmetric: row {}, column {} is {} above row {}, column {}; half of that is {does}",
                    i + 1,
                    j + 1,
                    float(&(value + value)),
                    j + 1,
                    i + 1
                ));
            }
        }
        if size > MOST {
            all.push(format!(
                "whether the matrices are positive is not looked at: there are {size} coordinates, more than {MOST}"
            ));
            return all;
        }
        all.extend(self.signs(size, name));
        all
    }

    /// Whether the mass is positive, and whether springs or dampers feed a motion.
    fn signs(&self, size: usize, name: &dyn Fn(usize) -> String) -> Vec<String> {
        let matrix = |entries: BTreeMap<(usize, usize), BigRational>| {
            let mut all = RealMatrix::zeros(size, size);
            for ((i, j), value) in entries {
                all[(i, j)] += nearest(&value) / 2.0;
                all[(j, i)] += nearest(&value) / 2.0;
            }
            all
        };
        let mut mass = RealMatrix::zeros(size, size);
        for Coupling { first, second, value, .. } in &self.masses {
            let (i, j) = (*first, second.unwrap_or(*first));
            mass[(i, j)] = nearest(value);
            mass[(j, i)] = nearest(value);
        }
        let Some(root) = mass.cholesky().map(|found| found.l()) else {
            return vec!["the mass is not positive definite: some motion has no kinetic energy".to_string()];
        };
        let said = [
            (&self.springs, "the stiffness is not positive semidefinite: it pushes away from rest along"),
            (&self.dampers, "the damping feeds energy into motions along"),
        ];
        let mut all = Vec::new();
        for (couplings, what) in said {
            // The rates of the motions in coordinates of mass 1: L⁻¹ S L⁻ᵀ.
            let Some(left) = root.solve_lower_triangular(&matrix(couplings.entries())) else { continue };
            let Some(both) = root.solve_lower_triangular(&left.transpose()) else { continue };
            let found = ((&both + both.transpose()) * 0.5).symmetric_eigen();
            let (place, least) = found.eigenvalues.argmin();
            if least >= -SUM * found.eigenvalues.amax() {
                continue;
            }
            let along = root.transpose().solve_upper_triangular(&found.eigenvectors.column(place));
            let Some(along) = along else { continue };
            let most = along[along.iamax()];
            let shares = along.iter().enumerate().map(|(i, x)| (i, x / most)).filter(|(_, x)| x.abs() > 1e-3);
            let shares: Vec<String> =
                shares.map(|(i, x)| format!("{} = {}", name(i), Short((x * 1e3).round() / 1e3))).collect();
            all.push(format!("{what} {}", shares.join(", ")));
        }
        all
    }
}

/// A number with at most six significant digits, as it would be written in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Short(pub f64);

impl std::fmt::Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let text = format!("{:.5e}", self.0);
        let Some((digits, exponent)) = text.split_once('e') else { return f.write_str(&text) };
        let exponent: i32 = exponent.parse().unwrap_or(0);
        if self.0 != 0.0 && !(-4..6).contains(&exponent) {
            let digits = digits.trim_end_matches('0').trim_end_matches('.');
            return write!(f, "{digits}e{exponent}");
        }
        let places = (5 - exponent).max(0) as usize;
        let text = format!("{:.places$}", self.0);
        let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn exact(value: BigRational) -> Evaluated {
        Evaluated { value, exact: true }
    }

    fn float(x: f64) -> Evaluated {
        exact(BigRational::from_float(x).unwrap())
    }

    fn entries(size: usize, all: &[f64]) -> Vec<(usize, usize, Evaluated)> {
        all.iter().enumerate().map(|(at, x)| (at / size, at % size, float(*x))).collect()
    }

    fn name(i: usize) -> String {
        format!("q{}", i + 1)
    }

    /// Springs to the ground and between, as they were put in.
    fn machine(ground: [f64; 2], between: f64, mass: [f64; 3]) -> Elements {
        let k = [ground[0] + between, -between, -between, ground[1] + between];
        let m = [mass[0], mass[2], mass[2], mass[1]];
        let masses = Couplings::of(&[]);
        let machine =
            Elements { masses: Vec::new(), springs: Couplings::of(&entries(2, &k)), dampers: masses };
        let mass = |(i, j, value): &(usize, usize, Evaluated)| Coupling {
            first: *i,
            second: (i != j).then_some(*j),
            value: value.value.clone(),
            rounding: false,
        };
        let masses = entries(2, &m).iter().filter(|(i, j, _)| i <= j).map(mass).collect();
        Elements { masses, ..machine }
    }

    proptest! {
        /// The matrix that springs are taken from is the one that they make, whatever it is.
        #[test]
        fn springs_make_the_matrix_that_they_are_taken_from(
            (size, all) in (1usize..6).prop_flat_map(|size| {
                (Just(size), proptest::collection::vec(prop_oneof![Just(0.0), -1e9..1e9], size * size))
            })
        ) {
            let given = entries(size, &all);
            let rebuilt = Couplings::of(&given).entries();
            for (i, j, value) in given {
                let own = rebuilt.get(&(i, j)).cloned().unwrap_or_else(BigRational::zero);
                prop_assert_eq!(own, value.value);
            }
        }
    }

    #[test]
    fn a_chain_has_the_springs_that_it_was_made_of() {
        let found = machine([3000.0, 0.0], 200.0, [2.0, 0.5, 0.0]);
        let seen: Vec<_> = found.springs.links.iter().map(|one| (one.first, one.second)).collect();
        assert_eq!(seen, [(0, None), (0, Some(1))], "no spring of 0 from the second mass to the ground");
        assert!(found.springs.skew.is_empty() && found.remarks(2, &name).is_empty());
    }

    /// A sum of floats that should be 0 is said to be rounding's; a sum of exact numbers is 0.
    #[test]
    fn what_rounding_leaves_is_told_from_a_spring() {
        let third = Evaluated { value: BigRational::from_float(1.0 / 3.0).unwrap(), exact: false };
        let all = Evaluated { value: BigRational::from_float(-1.0 / 3.0 + 5e-17).unwrap(), exact: false };
        let found = Couplings::of(&[(0, 0, third.clone()), (0, 1, all.clone()), (1, 0, all), (1, 1, third)]);
        assert!(found.links[0].rounding && found.links[1].rounding && !found.links[2].rounding, "{found:?}");
    }

    #[test]
    fn wrong_signs_are_said() {
        let all = |ground, between, mass| machine(ground, between, mass).remarks(2, &name).join("\n");
        let coupled = all([3000.0, 0.0], -200.0, [2.0, 0.5, 0.0]);
        assert!(coupled.contains("negative spring -200 between q1 and q2"), "{coupled}");
        assert!(coupled.contains("`stiffness` has 200 at row 1, column 2"), "{coupled}");
        assert!(coupled.contains("pushes away from rest along q1 = "), "{coupled}");
        // A negative spring that others hold leaves the whole positive.
        let held = all([3000.0, 3000.0], -200.0, [2.0, 0.5, 0.0]);
        assert!(held.contains("negative spring") && !held.contains("pushes away"), "{held}");
        let ground = all([-1.0, 0.0], 0.0, [1.0, 1.0, 0.0]);
        assert!(ground.contains("negative spring -1 from q1 to the ground: row 1"), "{ground}");
        assert!(ground.ends_with("along q1 = 1"), "{ground}");
        let mass = all([1.0, 1.0], 0.0, [1.0, 1.0, 2.0]);
        assert!(mass.contains("the mass is not positive definite"), "{mass}");
    }

    #[test]
    fn what_is_not_symmetric_is_no_spring_and_is_said() {
        let skew = Couplings::of(&entries(2, &[1.0, 3.0, -3.0, 1.0]));
        assert_eq!(skew.links.len(), 2, "two dampers to the ground: {skew:?}");
        assert_eq!(skew.skew[0].value, BigRational::from_integer(3.into()));
        let mut found = machine([1.0, 1.0], 0.0, [1.0, 1.0, 0.0]);
        found.dampers = skew.clone();
        let said = found.remarks(2, &name).join("\n");
        assert!(said.contains("`damping` is not symmetric: row 1, column 2 is 6 above row 2, column 1"));
        assert!(said.contains("gyroscopic") && !said.contains("feeds energy"), "{said}");
        found.springs = skew;
        assert!(found.remarks(2, &name).join("\n").contains("circulatory"));
        found.dampers = Couplings::of(&entries(2, &[-1.0, 0.0, 0.0, 1.0]));
        assert!(found.remarks(2, &name).join("\n").contains("feeds energy into motions along q1 = 1"));
    }

    #[test]
    fn numbers_are_short() {
        let cases = [(3200.0, "3200"), (0.004, "0.004"), (8e6, "8e6"), (-0.0, "0"), (1.0 / 3.0, "0.333333")];
        for (x, text) in cases.into_iter().chain([(999_999.7, "1e6"), (2e-5, "2e-5"), (246740.0, "246740")]) {
            assert_eq!(Short(x).to_string(), text);
        }
    }
}
