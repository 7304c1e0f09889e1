//! Orbits of the true system: exact formulas, Newton's method, saltation matrices, admissibility.

use grazing::oscillator::{Harmonic, Side, System, Wall, orbit::*};

/// The paper's oscillator, (65)–(67).
fn nordmark(d: f64, w: f64, tau: f64, mu: f64) -> System<f64> {
    System {
        damping: 2.0 * d / w,
        stiffness: 1.0 / (w * w),
        cubic: 0.0,
        force: 0.0,
        forcing: Vec::new(),
        lower: Some(Wall {
            offset: -1.0,
            harmonics: vec![Harmonic { k: 1, cos: 1.0 + mu, sin: 0.0 }],
            restitution: tau,
        }),
        upper: None,
    }
}

#[test]
fn p() {
    for n in 1..=4 {
        let s = SingleImpact::new(&nordmark(0.6, 4.9, 1.0, 0.0), Side::Lower, n).unwrap();
        let f = s.flip().map(|v| (v, s.amplitude_at(v) - 1.0));
        let g = s.fold().map(|v| (v, s.amplitude_at(v) - 1.0));
        println!("{n} flip {f:?} fold {g:?}");
        for mu in [-0.08, -0.05, 0.003] {
            let sys = nordmark(0.6, 4.9, 1.0, mu);
            let s = SingleImpact::new(&sys, Side::Lower, n).unwrap();
            let o = Oscillator::new(sys).unwrap();
            for v in s.speeds() {
                println!("  {mu} V={v} t={} {:?}", s.phase(v), s.multipliers(v));
                let it = Itinerary::at(Side::Lower, &[n]).unwrap();
                match find(&o, &it, vec![s.phase(v), v]) {
                    Ok(f) => println!("     {f:?}"),
                    Err(e) => println!("     {e}"),
                }
            }
        }
    }
}
