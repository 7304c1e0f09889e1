//! How the motion of a machine, its gaps and its impacts change with a parameter.

use crate::{
    error::Result,
    many::{
        LinearEquations, LinearFlow, Machine, Periodic, RealMatrix, RealVector, Slope, SpeedLaw, State,
        StopLaw,
        algebra::stacked,
        contact::{Contacts, StopContact},
        simulate::Stage,
        smooth::Smooth,
    },
    motion::{
        Series,
        flow::{GAUSS, Gradient, Program},
    },
};

/// What a parameter changes of a machine, ready for legs of motion.
///
/// A motion q(t) from a given state changes by s(t) with M s″ + C s′ + K s = r(t), s = s′ = 0 at first,
///
///   r = f′ − M′q″ − C′q′ − K′q = (f′ − M′M⁻¹f) + (M′M⁻¹C − C′) q′ + (M′M⁻¹K − K′) q,
///
/// where f′ and so on are derivatives in the parameter. If only the force changes, s is a motion of the same
/// machine under the force f′ and known in closed form. Else it is Duhamel's integral, by Gauss's rule on
/// panels short against every motion, exact to rounding.
#[derive(Debug, Clone)]
pub(crate) struct Change {
    /// f′ − M′M⁻¹f.
    force: Periodic,
    /// By q and by q′; none where M, C and K stay.
    state: Option<[RealMatrix; 2]>,
    /// The machine under f′ alone, if that is all; none if nothing changes.
    alone: Option<LinearFlow>,
    /// Of the machine's coefficients.
    pub(super) slope: Slope,
    /// Of each stop.
    stops: Vec<StopChange>,
    /// The formulas of forces, and what they change by.
    smooth: Option<(Smooth, Smooth)>,
}

/// How a stop changes.
#[derive(Debug, Clone)]
struct StopChange {
    row: RealVector,
    place: Series,
    /// M⁻¹wᵀ, its derivative, w M⁻¹wᵀ and its derivative.
    push: RealVector,
    pushed: RealVector,
    mobility: f64,
    moved: f64,
    contact: StopContact,
    /// Of a constant τ.
    restitution: f64,
    /// τ as a function of the speed, and what it changes by.
    law: Option<(SpeedLaw<f64>, SpeedLaw<f64>)>,
}

impl Change {
    /// The change of a machine whose coefficients change at the rates `slope`.
    ///
    /// # Errors
    /// Those of [`Slope::new`].
    pub fn new(
        machine: &Machine<f64>,
        slope: &Machine<f64>,
        flow: &LinearFlow,
        contacts: &Contacts,
    ) -> Result<Change> {
        let equations = flow.equations();
        let change = Slope::new(machine, slope)?;
        let (force, state, alone) = moving(equations, &change)?;
        let (rate, faster) = (machine.rate(), -machine.rate() * slope.period / machine.period);
        let stops = change.stops.iter().zip(&slope.stops).enumerate().map(|(stop, ((row, place), own))| {
            let (push, mobility) = (contacts.push(stop), contacts.mobility(stop));
            let law = match (&machine.stops[stop].law, &own.law) {
                (StopLaw::Speed(law), StopLaw::Speed(slope)) => {
                    Some((law.scaled(rate), law.scaled_slope(slope, rate, faster)))
                }
                _ => None,
            };
            StopChange {
                row: row.clone(),
                place: place.clone(),
                // (M⁻¹wᵀ)′ = M⁻¹(w′ᵀ − M′M⁻¹wᵀ), (w M⁻¹wᵀ)′ = 2w′M⁻¹wᵀ − (M⁻¹wᵀ)ᵀM′M⁻¹wᵀ.
                pushed: equations.accelerate(&(row - &change.mass * push)),
                moved: 2.0 * row.dot(push) - push.dot(&(&change.mass * push)),
                push: push.clone(),
                mobility,
                contact: contacts.all()[stop].clone(),
                restitution: own.wall.restitution,
                law,
            }
        });
        let stops = stops.collect();
        let smooth = match Smooth::new(machine)? {
            Some(smooth) => {
                let own = smooth.slope(machine, slope)?;
                Some((smooth, own))
            }
            None => None,
        };
        Ok(Change { force, state, alone, slope: change, stops, smooth })
    }

    /// The change while soft stops push, `flow` being that of the machine then.
    ///
    /// # Errors
    /// Those of [`LinearFlow::new`].
    pub fn pushed(&self, flow: &LinearFlow, contacts: &Contacts, pushing: &[usize]) -> Result<Change> {
        if pushing.is_empty() {
            return Ok(self.clone());
        }
        let slope = self.slope.pushed(contacts, pushing);
        let (force, state, alone) = moving(flow.equations(), &slope)?;
        let (stops, smooth) = (self.stops.clone(), self.smooth.clone());
        Ok(Change { force, state, alone, slope, stops, smooth })
    }

    /// The motion of a stage by formulas with its derivative in the parameter, of which `slope` is what it
    /// changes of the rest; none without formulas.
    ///
    /// # Errors
    /// Those of [`Smooth::changing`].
    pub(super) fn changing(&self, stage: &Stage, slope: &Slope) -> Result<Option<Program<Gradient<2>>>> {
        let Some((formulas, own)) = self.smooth.as_ref().filter(|_| stage.smooth.is_some()) else {
            return Ok(None);
        };
        let program = match formulas.switches() {
            [] => formulas.changing(&stage.equations, (slope, own)),
            _ => formulas
                .in_mode(&stage.holds.below, &stage.holds.grips)
                .changing(&stage.equations, (slope, own)),
        };
        program.map(Some)
    }

    /// How a switch of the formulas changes at a state.
    pub(super) fn switch(&self, switch: usize, at: &State) -> f64 {
        self.smooth.as_ref().map_or(0.0, |(formulas, own)| formulas.switch_slope(switch, at, own))
    }

    /// As [`leg`](Self::leg) where forces are formulas: by the derivative of the Taylor series in the
    /// parameter.
    ///
    /// # Errors
    /// A motion that cannot be followed.
    pub fn smooth_leg(
        &self,
        stage: &Stage,
        contacts: &Contacts,
        from: &State,
        duration: f64,
    ) -> Result<RealVector> {
        let slope = self.slope.pushed(contacts, &stage.holds.soft.pushing);
        match (&stage.smooth, self.changing(stage, &slope)?) {
            (Some(smooth), Some(program)) => smooth.changed(&program, from, duration),
            _ => Ok(RealVector::zeros(2 * from.q.len())),
        }
    }

    /// (q, q′) after `duration` from a state, as it changes with the parameter, the state being fixed. Cost:
    /// O(n²), or O(n²) for each of 8 points per radian of the fastest motion where M, C or K change.
    pub fn leg(&self, flow: &LinearFlow, from: &State, duration: f64) -> RealVector {
        let n = flow.equations().size();
        if let Some(alone) = &self.alone {
            let (zero, t) = (RealVector::zeros(n), from.t);
            let end = alone.after(&State { t, q: zero.clone(), u: zero }, duration);
            return stacked(&end.q, &end.u);
        }
        let Some([by_place, by_rate]) = &self.state else { return RealVector::zeros(2 * n) };
        let order = flow.equations().force.order().max(self.force.order()).max(1);
        let rate = flow.rates().into_iter().fold(f64::from(order), f64::max);
        let panels = (duration * rate).ceil().max(1.0);
        let width = duration / panels;
        let (mut here, mut sum, mut at) = (from.clone(), RealVector::zeros(2 * n), 0.0);
        let mut go = |to: f64, weight: f64| {
            if to > at {
                here = flow.after(&here, to - at);
                flow.advance(&mut sum, to - at);
                at = to;
            }
            if weight > 0.0 {
                let r = self.force.at(here.t) + by_place * &here.q + by_rate * &here.u;
                sum.axpy(weight, &flow.kick(&flow.equations().accelerate(&r)), 1.0);
            }
        };
        for panel in 0..panels as u64 {
            for (node, weight) in GAUSS {
                go(width * (panel as f64 + node), width * weight);
            }
        }
        go(duration, 0.0);
        flow.outward(&sum)
    }

    /// How the gap to a stop and its rate change at a state.
    pub fn gap(&self, stop: usize, at: &State) -> [f64; 2] {
        let StopChange { row, place, .. } = &self.stops[stop];
        let [place, speed, _] = place.at(at.t);
        [row.dot(&at.q) - place, row.dot(&at.u) - speed]
    }

    /// How the kick of a stop, (1 + τ) M⁻¹wᵀ/(w M⁻¹wᵀ), changes at an impact of speed V.
    pub fn kick(&self, stop: usize, speed: f64) -> RealVector {
        let own = &self.stops[stop];
        let factor = (1.0 + own.contact.restitution_at(speed)) / own.mobility;
        let slope = own.law.as_ref().map_or(own.restitution, |(law, slope)| law.slope(slope, speed.max(0.0)));
        &own.pushed * factor + &own.push * (slope / own.mobility - factor * own.moved / own.mobility)
    }
}

/// What a parameter does to motion between events: f′ − M′M⁻¹f, the matrices by q and q′, and the machine
/// under f′ alone.
type Moving = (Periodic, Option<[RealMatrix; 2]>, Option<LinearFlow>);

fn moving(equations: &LinearEquations, change: &Slope) -> Result<Moving> {
    let still = [&change.mass, &change.damping, &change.stiffness].iter().all(|x| x.amax() == 0.0);
    let mut force = change.force.clone();
    // M′M⁻¹ = (M⁻¹M′)ᵀ, both being symmetric.
    let ratio = solved(equations, &change.mass).transpose();
    if change.mass.amax() != 0.0 {
        let lost = equations.force.mapped(&ratio);
        force.mean -= &lost.mean;
        for (k, a, b) in &lost.harmonics {
            force.add(*k, &-a, &-b);
        }
    }
    let state = (!still).then(|| {
        [&ratio * &equations.stiffness - &change.stiffness, &ratio * &equations.damping - &change.damping]
    });
    let pushed = force.mean.amax() != 0.0 || !force.harmonics.is_empty();
    let alone = (still && pushed).then(|| {
        let LinearEquations { mass, damping, stiffness, .. } = equations.clone();
        LinearFlow::new(LinearEquations::new(mass, damping, stiffness, force.clone())?)
    });
    Ok((force, state, alone.transpose()?))
}

/// M⁻¹X.
fn solved(equations: &LinearEquations, x: &RealMatrix) -> RealMatrix {
    let columns: Vec<RealVector> =
        x.column_iter().map(|column| equations.accelerate(&column.into_owned())).collect();
    RealMatrix::from_columns(&columns)
}
