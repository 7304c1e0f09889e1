//! Periodic orbits among dry friction: closed forms, long simulations, differences.

use crate::samples::samples;
use grazing_scenes::{
    Error,
    continuation::{FollowedOrbit, PatternFamily},
    many::{
        Family,
        branch::Patterns,
        orbit::{Admissibility, Itinerary, Orbit, Strike, find, find_from},
    },
};

use super::*;

/// The product of 2 × 2 matrices.
fn times(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

/// Sum and product of an orbit's two multipliers.
fn invariants(orbit: &Orbit) -> [f64; 2] {
    let [a, b] = [orbit.multipliers[0], orbit.multipliers[1]];
    [a.0 + b.0, a.0 * b.0 - a.1 * b.1]
}

fn state_at(simulator: &Simulator, orbit: &Orbit, t: f64) -> State {
    let state = &orbit.state;
    let mut run = simulator.start(at(0.0), state.q(), state.u()).unwrap();
    assert_eq!(run.finish(at(t)), RunEnd::Reached);
    run.state()
}

/// Den Hartog's motion without stops as an orbit: x = F/k + A cos(t + φ) − (F/k)(cos ω₀t + tan(ω₀π/2) sin
/// ω₀t) going back from X = A cos φ, with A = P/(k − 1), sin φ = −(F ω₀/(k A)) tan(ω₀π/2). After half a
/// period it turns at −X. Where it turns, a displacement's velocity is multiplied by a⁺/a⁻, a being the
/// accelerations after and before: Shaw's multipliers, whatever the static coefficient is as long as the
/// motion does not stick.
#[test]
fn orbits_without_stops_have_the_multipliers_of_shaw() {
    for (k, force, more) in [(2.6f64, 0.3, 1.0), (1.5, 0.1, 1.5), (0.5, 0.1, 1.0), (0.2, 0.2, 1.2)] {
        let (omega, a) = (k.sqrt(), 1.0 / (k - 1.0));
        let sine = -force * omega / (k * a) * (omega * PI / 2.0).tan();
        // Of the two phases that at which it turns: there the force pulls it back.
        let mut rough = machine(&[&[1.0]], &[&[0.0]], &[&[k]]);
        rough.forcing = vec![Load { k: 1, cos: vec![1.0], sin: vec![0.0] }];
        rough.friction = vec![friction(&[1.0], force, [1.0, more])];
        let simulator = Simulator::suited(&rough, None, &[]).unwrap();
        for phi in [sine.asin(), PI - sine.asin()] {
            let amplitude = a * phi.cos();
            if amplitude <= 0.0 {
                continue;
            }
            let t = phi.rem_euclid(TAU);
            let mut run = simulator.start(at(t), &[amplitude], &[-1e-300]).unwrap();
            run.finish(Time::new(1, 0.0));
            let orbit = find_from(&simulator, &Itinerary::free(1).unwrap(), &[], Some(&run.state())).unwrap();
            let turn = state_at(&simulator, &orbit, t);
            assert!((turn.q()[0] - amplitude).abs() < 1e-12 * (1.0 + amplitude), "{turn:?} {amplitude}");
            assert!(turn.u()[0].abs() < 1e-11, "{turn:?}");
            assert_eq!(orbit.admissibility, Admissibility::Admissible);
            let (s, c) = (omega * PI).sin_cos();
            let pull = phi.cos() - k * amplitude;
            let ratio = (pull + force) / (pull - force);
            let half = times([[1.0, 0.0], [0.0, ratio]], [[c, s / omega], [-omega * s, c]]);
            let all = times(half, half);
            let wanted = [all[0][0] + all[1][1], all[0][0] * all[1][1] - all[0][1] * all[1][0]];
            let found = invariants(&orbit);
            assert!(apart(&found, &wanted) < 1e-11, "{k} {force}: {found:?} {wanted:?}");
            // From the linear motion it is found, too.
            let again = find(&simulator, &Itinerary::free(1).unwrap(), &[]).unwrap();
            assert!(apart(&invariants(&again), &wanted) < 1e-10, "{k} {force}: {again:?}");
        }
    }
}

/// A motion that sticks twice a period: from x, where it sticks, the spring and P cos t pull it off with F_s
/// at t₀; it slides as the linear oscillator does under F_k, and sticks at −x. One multiplier is 0, the other
/// (dx⁺/dx)², by the chain rule; x by bisection.
#[test]
fn orbits_with_two_stops_have_a_multiplier_0_and_one_by_the_chain_rule() {
    for (k, sliding, holding) in [(3.0f64, 0.6, 0.6), (4.0, 0.5, 0.7), (0.3, 0.8, 0.8), (0.2, 0.8, 0.9)] {
        let omega = k.sqrt();
        let a = 1.0 / (k - 1.0);
        // It sticks at x > 0 and is pulled off backwards: cos t₀ = kx − F_s, rising towards −1.
        let slip = |x: f64| {
            let t0 = (k * x - holding).acos();
            // q = F/k + a cos t + b cos ω(t − t₀) + c sin ω(t − t₀).
            let b = x - sliding / k - a * t0.cos();
            let c = a * t0.sin() / omega;
            let place = |t: f64| {
                let (s, co) = (omega * (t - t0)).sin_cos();
                sliding / k + a * t.cos() + b * co + c * s
            };
            let rate = |t: f64| {
                let (s, co) = (omega * (t - t0)).sin_cos();
                -a * t.sin() + omega * (c * co - b * s)
            };
            // The first zero of the rate.
            let (mut low, step) = (t0 + 1e-3, 1e-3);
            while rate(low + step) < 0.0 {
                low += step;
            }
            let mut high = low + step;
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if rate(middle) < 0.0 { low = middle } else { high = middle }
            }
            (t0, low, place(low))
        };
        let off = |x: f64| slip(x).2 + x;
        let places = (1..).map(|i| f64::from(i) * 1e-2).take_while(|x| k * x - holding < 1.0);
        let mut high = places.clone().find(|x| off(0.01) * off(*x) <= 0.0).expect("a motion");
        let mut low = high - 1e-2;
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if off(low) * off(middle) <= 0.0 { high = middle } else { low = middle }
        }
        let x = low;
        let (t0, t1, _) = slip(x);
        assert!(t1 < t0 + PI, "it does not stick: {t0} {t1}");
        // dq(t₁)/dx at fixed t₀ is cos ω(t₁ − t₀); later by δ it starts with another acceleration by which
        // the velocity at t₀ differs by −q″⁺δ.
        let (s, c) = (omega * (t1 - t0)).sin_cos();
        let later = k / -t0.sin();
        let start = t0.cos() - k * x + sliding;
        let slope = c - start * later * s / omega;
        let mut rough = machine(&[&[1.0]], &[&[0.0]], &[&[k]]);
        rough.forcing = vec![Load { k: 1, cos: vec![1.0], sin: vec![0.0] }];
        rough.friction = vec![friction(&[1.0], 1.0, [sliding, holding])];
        let simulator = Simulator::suited(&rough, None, &[]).unwrap();
        let found = attractor(&simulator, &[0.0], &[0.0]).expect("an orbit");
        let orbit = found.find(&simulator);
        let before = 0.5 * (t1 - PI + t0);
        let stuck = state_at(&simulator, &orbit, before.rem_euclid(TAU));
        assert!((stuck.q()[0] - x).abs() < 1e-12 && stuck.u()[0].abs() < 1e-14, "{stuck:?} {x}");
        let [first, second] = [orbit.multipliers[0], orbit.multipliers[1]];
        assert!((first.0 - slope * slope).abs() < 1e-10, "{k}: {first:?} {}", slope * slope);
        assert_eq!(second, (0.0, 0.0));
    }
}

/// A periodic motion that a long simulation ends in.
struct Attractor {
    pattern: Itinerary,
    start: Vec<f64>,
    state: State,
    /// A state of it at phase 0.
    seen: State,
}

impl Attractor {
    fn find(&self, simulator: &Simulator) -> Orbit {
        find_from(simulator, &self.pattern, &self.start, Some(&self.state)).unwrap()
    }
}

const LATE: i64 = 500;

fn attractor(simulator: &Simulator, q: &[f64], u: &[f64]) -> Option<Attractor> {
    let stops = simulator.contacts().all().len();
    let mut run = simulator.start(at(0.0), q, u).unwrap();
    if run.finish(Time::new(LATE, 0.0)) != RunEnd::Reached {
        return None;
    }
    let first = run.state();
    let size = first.q().iter().chain(first.u()).fold(0.0f64, |most, x| most.max(x.abs()));
    let (mut hits, mut rests) = (Vec::new(), false);
    for n in 1..=6i64 {
        run.record(Time::new(LATE + n, 0.0), |event| match event {
            Event::Impact(hit) => hits.push((hit.place, hit.time, -hit.velocity)),
            Event::Stick(stick) => rests |= stick.place < stops,
            _ => {}
        });
        let state = run.state();
        if apart(state.q(), first.q()).max(apart(state.u(), first.u())) > 1e-9 * size {
            continue;
        }
        if rests {
            return None;
        }
        if hits.is_empty() {
            let pattern = Itinerary::free(n as u32).unwrap();
            let none = vec![];
            return Some(Attractor { pattern, start: none, state, seen: first });
        }
        let period = |i: usize| hits[i % hits.len()].1.period + if i < hits.len() { 0 } else { n };
        let strikes = (0..hits.len())
            .map(|i| Strike { place: hits[i].0, periods: (period(i + 1) - period(i)) as u32 })
            .collect();
        let pattern = Itinerary::new(strikes).ok()?;
        let start = hits.iter().flat_map(|hit| [hit.1.phase, hit.2]).collect();
        let mut run = simulator.start(at(0.0), first.q(), first.u()).unwrap();
        while !matches!(run.next(Time::new(7, 0.0)), Event::Impact(_)) {}
        return Some(Attractor { pattern, start, state: run.state(), seen: first });
    }
    None
}

/// A machine every coefficient of which changes with the parameter.
struct Changing {
    base: Machine<f64>,
    slope: Machine<f64>,
}

impl Family for Changing {
    fn at(&self, p: f64) -> Result<(Machine<f64>, Machine<f64>), Error> {
        let mut slopes = Vec::new();
        self.slope.try_map(|x| {
            slopes.push(*x);
            Ok::<_, Error>(*x)
        })?;
        let mut slopes = slopes.into_iter();
        let machine = self.base.try_map(|x| Ok::<_, Error>(x + p * slopes.next().unwrap()))?;
        Ok((machine, self.slope.clone()))
    }
}

/// One to three coordinates, one or two rough rows, belts, vibrating surfaces, static friction, stops; how
/// all of it changes; a start.
fn random_rough(trial: u64) -> (Changing, Vec<f64>, Vec<f64>) {
    let mut between = numbers(0x9E37_79B9_7F4A_7C15 ^ (trial + 1).wrapping_mul(0xBF58_476D_1CE4_E5B9));
    for _ in 0..20 {
        between(0.0, 1.0);
    }
    let n = 1 + trial as usize % 3;
    let mut rough = machine(&[], &[], &[]);
    (rough.size, rough.period) = (n, between(5.0, 7.0));
    for i in 0..n {
        for j in 0..n {
            let near = i.abs_diff(j) == 1;
            rough.mass.push((i, j, if i == j { between(0.7, 1.5) } else { 0.0 }));
            let k = if i == j { between(2.5, 6.0) } else { 0.0 } - if near { 1.2 } else { 0.0 };
            rough.stiffness.push((i, j, k));
            let c = if i == j { between(0.1, 0.3) } else { 0.0 } - if near { 0.03 } else { 0.0 };
            rough.damping.push((i, j, c));
        }
    }
    let amplitude = between(1.0, 2.5);
    rough.force = (0..n).map(|_| between(-0.2, 0.2)).collect();
    rough.forcing = vec![Load {
        k: 1,
        cos: (0..n).map(|i| if i == 0 { amplitude } else { 0.1 }).collect(),
        sin: (0..n).map(|_| between(-0.3, 0.3)).collect(),
    }];
    for j in 0..1 + usize::from(n > 1 && trial / 3 % 2 == 1) {
        let row: Vec<f64> =
            (0..n).map(|i| if j == 0 { f64::from(u8::from(i == 0)) } else { [-1.0, 1.0, 0.3][i] }).collect();
        let (coefficient, more) = (between(0.2, 0.9), between(0.0, 0.3));
        let kind = trial / 6;
        rough.friction.push(Friction {
            speed: if kind % 3 == 1 { between(-0.4, 0.4) } else { 0.0 },
            harmonics: match kind % 3 {
                2 => vec![Harmonic { k: 2, cos: between(-0.2, 0.2), sin: between(-0.2, 0.2) }],
                _ => vec![],
            },
            ..friction(
                &row,
                between(0.5, 1.5),
                [coefficient, coefficient + if kind.is_multiple_of(2) { 0.0 } else { more }],
            )
        });
    }
    if trial % 4 == 3 {
        let row: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i + 1 == n))).collect();
        rough.stops = vec![stop(&row, -between(0.1, 0.4), 0.7)];
    }
    let mut slope = rough.try_map(|_| Ok::<_, Error>(between(-0.3, 0.3))).unwrap();
    for (rub, change) in rough.friction.iter().zip(&mut slope.friction) {
        if rub.static_coefficient == rub.coefficient {
            change.static_coefficient = change.coefficient;
        }
    }
    // The mass stays symmetric.
    slope.mass.iter_mut().for_each(|entry| entry.2 = if entry.0 == entry.1 { 0.1 } else { 0.05 });
    let q = (0..n).map(|_| between(-0.05, 0.05)).collect();
    let u = (0..n).map(|_| between(-0.5, 0.5)).collect();
    (Changing { base: rough, slope }, q, u)
}

/// How fast it slides at each rough row, of velocities per radian.
fn sliding(machine: &Machine<f64>, state: &State, t: f64) -> f64 {
    let one = |rub: &Friction<f64>| {
        let own: f64 = rub.row.iter().zip(state.u()).map(|(w, u)| w * u).sum();
        let surface = rub.harmonics.iter().fold(rub.speed / machine.rate(), |sum, h| {
            let (s, c) = (f64::from(h.k) * t).sin_cos();
            sum + f64::from(h.k) * (h.sin * c - h.cos * s)
        });
        (own - surface).abs()
    };
    machine.friction.iter().map(one).fold(f64::INFINITY, f64::min)
}

/// tr A and tr A².
fn traces(a: &[Vec<f64>]) -> [f64; 2] {
    let n = a.len();
    let square = (0..n).map(|i| (0..n).map(|j| a[i][j] * a[j][i]).sum::<f64>()).sum();
    [(0..n).map(|i| a[i][i]).sum(), square]
}

/// How many machines were looked at, and by how much they were off at most.
#[derive(Debug, Default)]
pub(super) struct Agreement {
    pub orbits: u32,
    struck: u32,
    sticking: u32,
    checked: u32,
    worst: [f64; 4],
}

impl Agreement {
    /// The orbit that a long simulation ends in is a root of the equations; its multipliers are those of
    /// differences of the period map, where at some phase nothing sticks; the equations change with the
    /// unknowns and with the parameter, at 0, as differences say.
    pub fn look(&mut self, trial: u64, family: &dyn Family, q: &[f64], u: &[f64]) {
        let rough = &family.at(0.0).unwrap().0;
        let simulator = Simulator::suited(rough, None, &[]).unwrap();
        let Some(found) = attractor(&simulator, q, u) else { return };
        let orbit = found.find(&simulator);
        self.orbits += 1;
        self.struck += u32::from(!orbit.impacts.is_empty());
        // What is lost where it sticks is 0, and not what rounding leaves of it.
        let sizes: Vec<f64> = orbit.multipliers.iter().map(|one| one.0.hypot(one.1)).collect();
        assert!(sizes.iter().all(|size| *size == 0.0 || *size > 1e-14), "{trial}: {sizes:?}");
        self.sticking += u32::from(sizes.contains(&0.0));
        assert_eq!(orbit.admissibility, Admissibility::Admissible, "{trial}");
        let size =
            1.0 + orbit.state.q().iter().chain(orbit.state.u()).fold(0.0f64, |most, x| most.max(x.abs()));
        let state = &orbit.state;
        let off = apart(state.q(), found.state.q()).max(apart(state.u(), found.state.u())) / size;
        self.worst[0] = self.worst[0].max(off);
        assert!(off < 1e-8, "{trial}: {off:e}");
        self.map(trial, (rough, &simulator), &found, &orbit);
        self.equations(trial, family, &orbit);
    }

    /// The period map at the phase at which it slides the fastest.
    fn map(
        &mut self,
        trial: u64,
        (rough, simulator): (&Machine<f64>, &Simulator),
        found: &Attractor,
        orbit: &Orbit,
    ) {
        let n = orbit.itinerary.periods() as i64;
        let mut run = simulator.start(at(0.0), found.seen.q(), found.seen.u()).unwrap();
        let mut best = (0.0, 0.0, found.seen.clone());
        for i in 1..40 {
            let t = TAU * f64::from(i) / 40.0;
            run.finish(at(t));
            let state = run.state();
            let speed = sliding(rough, &state, t);
            if speed > best.0 {
                best = (speed, t, state);
            }
        }
        let (speed, t, state) = best;
        if speed > 1e-2 {
            self.checked += 1;
            let x: Vec<f64> = state.q().iter().chain(state.u()).copied().collect();
            let half = x.len() / 2;
            let map = |x: &[f64]| {
                let mut run = simulator.start(at(t), &x[..half], &x[half..]).unwrap();
                run.finish(Time::new(n, t));
                let state = run.state();
                state.q().iter().chain(state.u()).copied().collect::<Vec<f64>>()
            };
            let differences = |h: f64| -> Vec<Vec<f64>> {
                let column = |j: usize| {
                    let moved = |h: f64| {
                        let mut x = x.clone();
                        x[j] += h;
                        map(&x)
                    };
                    moved(h).iter().zip(moved(-h)).map(|(a, b)| (a - b) / (2.0 * h)).collect()
                };
                (0..x.len()).map(column).collect()
            };
            let sum = orbit
                .multipliers
                .iter()
                .fold([0.0; 2], |sum, (re, im)| [sum[0] + re, sum[1] + re * re - im * im]);
            // Near a sliding bifurcation a step may lead beyond it: then a shorter one.
            let off = [3e-6, 3e-7].map(|h| apart(&sum, &traces(&differences(h))));
            self.worst[1] = self.worst[1].max(off[0].min(off[1]));
            assert!(off[0].min(off[1]) < 1e-5, "{trial}: {sum:?} {off:?}");
        }
    }

    /// The equations' derivatives.
    fn equations(&mut self, trial: u64, family: &dyn Family, orbit: &Orbit) {
        let patterns = Patterns::new(family, 0.0, None).unwrap();
        let pattern = &orbit.itinerary;
        let z: Vec<f64> =
            (0..orbit.z.len()).map(|i| orbit.z[i] * orbit.unit(i) / patterns.unit(pattern, i)).collect();
        let at = |p: f64, z: &[f64]| patterns.equations(p, pattern, z).unwrap();
        let exact = at(0.0, &z);
        let largest = exact.residual.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        assert!(largest < 1e-9, "{trial}: {largest:e}");
        let steps = [1e-6, 1e-7];
        let nearest = |exact: f64, slope: &dyn Fn(f64) -> f64| {
            let all = steps.map(slope).map(|slope| ((slope - exact).abs() / (1.0 + slope.abs()), slope));
            if all[0].0 < all[1].0 { all[0] } else { all[1] }
        };
        let beside = steps.map(|h| [at(h, &z), at(-h, &z)]);
        for i in 0..z.len() {
            let by = |h: f64| {
                let [more, less] = &beside[usize::from(h < 1e-6)];
                (more.residual[i] - less.residual[i]) / (2.0 * h)
            };
            let (off, slope) = nearest(exact.slope[i], &by);
            self.worst[2] = self.worst[2].max(off);
            assert!(off < 1e-5, "{trial}, {i}: {slope} {}", exact.slope[i]);
            for j in 0..z.len() {
                let moved = |h: f64| {
                    let mut z = z.clone();
                    z[j] += h;
                    at(0.0, &z).residual[i]
                };
                let by = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
                let (off, slope) = nearest(exact.jacobian[i][j], &by);
                self.worst[3] = self.worst[3].max(off);
                assert!(off < 1e-5, "{trial}, {i} {j}: {slope} {}", exact.jacobian[i][j]);
            }
        }
    }
}

/// Of random machines, in every coefficient at once.
#[test]
fn random_orbits_agree_with_simulations_and_their_derivatives_with_differences() {
    let trials: u64 = samples(4);
    let mut all = Agreement::default();
    for trial in 0..trials {
        let (family, q, u) = random_rough(trial);
        all.look(trial, &family, &q, &u);
    }
    println!("{trials}: {all:?}");
    let Agreement { orbits, struck, sticking, checked, .. } = all;
    assert!(
        u64::from(orbits) > trials * 2 / 3
            && struck > trials as u32 / 12
            && (trials < 16 || sticking > trials as u32 / 4)
            && checked > trials as u32 / 3
    );
}
