//! How a machine's equations change with a parameter: the exact derivatives of every coefficient, no
//! differences.

use std::sync::Arc;

use super::{
    LinearEquations, Machine, NormalForce, Periodic, RealMatrix, RealVector, StopLaw,
    contact::{Contacts, SoftContact},
    modes,
    stribeck::SlidingLaw,
};
use crate::{
    error::{Error, Result},
    motion::{EffectTally, Series},
};

/// Machines over a parameter.
pub trait Family {
    /// The machine at a value of the parameter, and the derivative of each of its coefficients.
    ///
    /// # Errors
    /// Where the machine is not defined.
    fn at(&self, parameter: f64) -> Result<(Machine<f64>, Machine<f64>)>;

    /// Where the work on its machines is added up, if anywhere.
    fn tally(&self) -> Option<&Arc<EffectTally>> {
        None
    }
}

/// The derivatives in a parameter of what [`LinearEquations`] and the stops are made of, the forcing's phase
/// being time.
#[derive(Debug, Clone)]
pub struct Slope {
    /// Of M.
    pub mass: RealMatrix,
    /// Of C.
    pub damping: RealMatrix,
    /// Of K.
    pub stiffness: RealMatrix,
    /// Of f.
    pub force: Periodic,
    /// Of each stop's row and place.
    pub stops: Vec<(RealVector, Series)>,
    /// Of each soft stop's stiffness and damping.
    pub soft: Vec<Option<SoftContact>>,
    /// Of the friction.
    pub rubs: Vec<RubSlope>,
}

/// How friction changes with a parameter.
#[derive(Debug, Clone)]
pub struct RubSlope {
    /// Of its row.
    pub row: RealVector,
    /// Of the surface's velocity.
    pub velocity: Series,
    /// Of F_k; of a law, but for how that changes at rest, which counts with the rest of it.
    pub sliding: f64,
    /// Of F_s.
    pub holding: f64,
}

impl Slope {
    /// The derivatives, `slope` being those of the coefficients of `machine` as they are written.
    ///
    /// # Errors
    /// Those of [`Machine::equations`]; damping ratios by mode where two modes that the parameter mixes have
    /// one frequency, or where a mode without stiffness gets some: the damping has no derivative there.
    pub fn new(machine: &Machine<f64>, slope: &Machine<f64>) -> Result<Slope> {
        // Ω = 2π/T.
        let (rate, faster) = (machine.rate(), -machine.rate() * slope.period / machine.period);
        let (mass, mass_slope) = (machine.matrix("mass", &machine.mass)?, slope.matrix("mass", &slope.mass)?);
        let damping = machine.matrix("damping", &machine.damping)?;
        let mut damping_slope = slope.matrix("damping", &slope.damping)? * rate + damping * faster;
        // (MΩ²)′ = M′Ω² + 2MΩΩ′.
        let mass_slope = mass_slope * (rate * rate) + &mass * (2.0 * rate * faster);
        let mass = mass * (rate * rate);
        let stiffness_slope = slope.matrix("stiffness", &slope.stiffness)?;
        if !machine.damping_ratio.is_empty() {
            let stiffness = machine.matrix("stiffness", &machine.stiffness)?;
            damping_slope += of_ratios(
                (&mass, &stiffness, &machine.damping_ratio),
                (&mass_slope, &stiffness_slope, &slope.damping_ratio),
            )?;
        }
        // Φᵀf has the derivative Φ′ᵀf + Φᵀf′.
        let turned =
            (!machine.shapes.is_empty()).then(|| Machine { shapes: slope.shapes.clone(), ..machine.clone() });
        let changed = Machine { shapes: machine.shapes.clone(), ..slope.clone() };
        let vector = |name: &str, of: &[f64], of_slope: &[f64]| -> Result<RealVector> {
            let own = changed.vector(name, of_slope)?;
            Ok(turned
                .as_ref()
                .map(|turned| turned.vector(name, of))
                .transpose()?
                .map_or(own.clone(), |by| own + by))
        };
        let mut force = Periodic::constant(vector("force", &machine.force, &slope.force)?);
        for (load, change) in machine.forcing.iter().zip(&slope.forcing) {
            let cos = vector("forcing: cos", &load.cos, &change.cos)?;
            force.add(load.k, &cos, &vector("forcing: sin", &load.sin, &change.sin)?);
        }
        let stops = machine.stops.iter().zip(&slope.stops).map(|(stop, change)| {
            let place = Series::new(change.wall.offset, &change.wall.harmonics)?;
            Ok((vector("row", &stop.row, &change.row)?, place))
        });
        let stops = stops.collect::<Result<_>>()?;
        let soft = machine.stops.iter().zip(&slope.stops).map(|pair| match (&pair.0.law, &pair.1.law) {
            (StopLaw::Soft { damping, .. }, StopLaw::Soft { stiffness, damping: change }) => {
                Some(SoftContact { stiffness: *stiffness, damping: change * rate + damping * faster })
            }
            _ => None,
        });
        let rubs = machine.friction.iter().zip(&slope.friction).map(|(friction, change)| {
            let speed = change.speed / rate - friction.speed * faster / (rate * rate);
            let motion = Series::new(0.0, &change.harmonics)?.derivative();
            let (normal, more) = match (&friction.normal, &change.normal) {
                (NormalForce::Given(force), NormalForce::Given(change)) => (*force, *change),
                _ => (1.0, 0.0),
            };
            let force = |coefficient: f64, by: f64| by * normal + coefficient * more;
            let (kinetic, own) = match (&friction.law, &change.law) {
                (Some(law), Some(own)) => {
                    let known = SlidingLaw::new(law, normal, rate)?;
                    (Some(known.at_rest()), known.slope_at_rest(law, own))
                }
                _ => (None, change.coefficient),
            };
            let holding = match kinetic {
                Some(rest) if friction.static_coefficient == 0.0 => force(rest, own),
                _ => force(friction.static_coefficient, change.static_coefficient),
            };
            // How a law changes at rest counts with the rest of it.
            let own = if kinetic.is_some() { 0.0 } else { own };
            Ok(RubSlope {
                row: vector("row", &friction.row, &change.row)?,
                velocity: Series::combination(&[(1.0, &Series::constant(speed)), (1.0, &motion)]),
                sliding: force(kinetic.unwrap_or(friction.coefficient), own),
                holding,
            })
        });
        Ok(Slope {
            rubs: rubs.collect::<Result<_>>()?,
            soft: soft.collect(),
            mass: mass_slope,
            damping: damping_slope,
            stiffness: stiffness_slope,
            force,
            stops,
        })
    }
}

impl Slope {
    /// The same while these soft stops push: the derivatives of K + Σ k wᵀw and so on
    /// ([`LinearEquations::pushed`]).
    #[must_use]
    pub(crate) fn pushed(&self, contacts: &Contacts, pushing: &[usize]) -> Slope {
        let mut all = self.clone();
        for &stop in pushing {
            let (contact, (row_slope, place_slope)) = (&contacts.all()[stop], &self.stops[stop]);
            let (Some(soft), Some(slope)) = (contact.soft, self.soft[stop]) else { continue };
            let row = &contact.row;
            for (matrix, value, change) in [
                (&mut all.stiffness, soft.stiffness, slope.stiffness),
                (&mut all.damping, soft.damping, slope.damping),
            ] {
                matrix.ger(change, row, row, 1.0);
                matrix.ger(value, row, row_slope, 1.0);
                matrix.ger(value, row_slope, row, 1.0);
            }
            let (place, speed) = (&contact.position, contact.position.derivative());
            let given = Series::combination(&[(soft.stiffness, place), (soft.damping, &speed)]);
            let changed = Series::combination(&[
                (slope.stiffness, place),
                (soft.stiffness, place_slope),
                (slope.damping, &speed),
                (soft.damping, &place_slope.derivative()),
            ]);
            all.force.add_series(row_slope, &given);
            all.force.add_series(row, &changed);
        }
        all
    }

    /// The same where it slides, each row with the sign of its velocity ([`LinearEquations::dragged`]).
    #[must_use]
    pub(crate) fn dragged(mut self, contacts: &Contacts, signs: impl Iterator<Item = f64>) -> Slope {
        for ((rub, slope), sign) in contacts.rubs().iter().zip(&self.rubs).zip(signs) {
            self.force.mean.axpy(-sign * slope.sliding, &rub.row, 1.0);
            self.force.mean.axpy(-sign * rub.sliding, &slope.row, 1.0);
        }
        self
    }
}

/// Eigenvalues nearer than this, relative to the largest, are one.
const SAME: f64 = 1e-10;

/// The derivative of C = L X Lᵀ, X = U diag(2ζ_i √s_i) Uᵀ, with S = L⁻¹ K L⁻ᵀ = U diag(s) Uᵀ and M = L Lᵀ.
///
/// L′ = L B with B the lower triangle of L⁻¹ M′ L⁻ᵀ, its diagonal halved; S′ = L⁻¹ K′ L⁻ᵀ − B S − S Bᵀ; and
/// by first-order perturbation of eigenvectors (UᵀX′U)_ij = (f_i − f_j)/(s_i − s_j) (UᵀS′U)_ij for f_i = 2ζ_i
/// √s_i, on the diagonal f_i′.
fn of_ratios(
    (mass, stiffness, ratios): (&RealMatrix, &RealMatrix, &[f64]),
    (mass_slope, stiffness_slope, ratio_slopes): (&RealMatrix, &RealMatrix, &[f64]),
) -> Result<RealMatrix> {
    let n = mass.nrows();
    let (zero, still) = (RealMatrix::zeros(n, n), Periodic::constant(RealVector::zeros(n)));
    let equations = LinearEquations::new(mass.clone(), zero, stiffness.clone(), still)?;
    let s = equations.per_mass(stiffness);
    let (values, u) = modes::eigen(&s)?;
    let of = |all: &[f64], i: usize| all[if all.len() == 1 { 0 } else { i }];
    let root = |i: usize| values[i].max(0.0).sqrt();
    let f = |i: usize| 2.0 * of(ratios, i) * root(i);
    let mut b = equations.per_mass(mass_slope);
    for i in 0..n {
        b[(i, i)] *= 0.5;
        for j in i + 1..n {
            b[(i, j)] = 0.0;
        }
    }
    let s_slope = equations.per_mass(stiffness_slope) - &b * &s - &s * b.transpose();
    let seen = u.transpose() * s_slope * &u;
    let (most, floor) = (values.iter().fold(0.0, |most: f64, x| most.max(x.abs())), 1e-13 * seen.norm());
    let mut inner = RealMatrix::zeros(n, n);
    for i in 0..n {
        for j in 0..n {
            let change = seen[(i, j)];
            // Where two eigenvalues are one the quotient is f's derivative, if f is one function of both.
            let quotient = if i != j && (values[i] - values[j]).abs() > SAME * most {
                (f(i) - f(j)) / (values[i] - values[j])
            } else if change.abs() <= floor {
                0.0
            } else if root(i) > 0.0 && of(ratios, i) == of(ratios, j) {
                of(ratios, i) / root(i)
            } else {
                return Err(Error::input(
                    "damping_ratio: the damping has no derivative in the parameter, which changes modes of one frequency and several \
                     ratios, or a mode without stiffness: write `damping` as a matrix",
                ));
            };
            inner[(i, j)] = quotient * change;
        }
        inner[(i, i)] += 2.0 * of(ratio_slopes, i) * root(i);
    }
    let x = &u * RealMatrix::from_diagonal(&RealVector::from_fn(n, |i, _| f(i))) * u.transpose();
    let x_slope = &u * inner * u.transpose();
    let root = equations.root();
    Ok(root * (&b * &x + x_slope + x * b.transpose()) * root.transpose())
}
