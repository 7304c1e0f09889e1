//! Unstable orbits of responses: against periodic Green's functions, and branches followed by themselves.

use std::f64::consts::{PI, TAU};

use grazing_scenes::run::{Findings, ResponseRow};
use nalgebra::Complex;

use super::responses::{found, reports, task};
use crate::tasks::{near, number};

type C = Complex<f64>;

const DAMPING: f64 = 0.1;
const STIFFNESS: f64 = 0.3;
const RESTITUTION: f64 = 0.8;

fn machine(engine: &str, more: &str) -> String {
    format!(
        "engine = \"{engine}\"\n[parameters]\nF = 0.8\n[system]\ndamping = {DAMPING}\nstiffness = {STIFFNESS}\n\
         forcing = [{{ cos = \"F\" }}]\n[[stops]]\nside = \"upper\"\noffset = 1\nrestitution = {RESTITUTION}\n{more}"
    )
}

fn unstable(rows: &[ResponseRow]) -> Vec<&ResponseRow> {
    rows.iter().filter(|row| row.way == "unstable" && row.coordinate == "q").collect()
}

/// One impact of speed V per period: the linear response F/(s − 1 + ic), and −(1 + e)V times the periodic
/// Green's function Im e^{λt}/(ω(1 − e^{2πλ})). Its first harmonic is that of the impulse, from which V and
/// the phase follow; there the displacement is the stop's, and the velocity V. It ends at the touch, where
/// the linear response is 1.
#[test]
fn an_orbit_with_one_impact_goes_from_its_fold_to_the_touch() {
    let own = C::new(STIFFNESS - 1.0, DAMPING);
    let touch = own.norm();
    let rate = C::new(-DAMPING / 2.0, (STIFFNESS - DAMPING * DAMPING / 4.0).sqrt());
    let green = |t: f64| (rate * t).exp() / (C::new(1.0, 0.0) - (rate * TAU).exp()) / rate.im;
    for engine in ["one", "many"] {
        let found = found(&machine(engine, &task("F", [0.4, 0.9], 11, "")));
        let [stretch] = &found.unstable.as_ref().unwrap()[..] else { panic!("{:?}", found.unstable) };
        let fold =
            found.sweep.as_ref().unwrap().jumps.iter().find(|jump| jump.ends == "saddle-node").unwrap();
        assert_eq!((stretch.begins.as_str(), stretch.ends.as_str()), ("saddle-node", "fade"));
        near(stretch.from, fold.stays, 1e-9);
        near(stretch.to, touch, 1e-9);
        let rows = unstable(&found.rows);
        assert_eq!((rows.len(), stretch.orbits), (stretch.orbits, rows.len()));
        assert!(rows.len() > 8);
        for row in rows {
            assert_eq!((row.period, row.impacts, row.stretch), (Some(1), Some(1), Some(1)));
            let z = C::from_polar(row.amplitude, -TAU * row.lag.unwrap());
            let impulse = (z * own - row.value) * PI;
            // It is −(1 + e)V e^{−it}.
            let (kick, t) = (impulse.norm(), -(-impulse).arg());
            let speed = kick / (1.0 + RESTITUTION);
            // At the end there is no impact any more.
            if speed < 1e-6 {
                continue;
            }
            let linear = C::from_polar(1.0, t) * row.value / own;
            // Just before the impact the last one is a period ago.
            let [place, slope] = [green(TAU).im, (rate * green(TAU)).im];
            near(linear.re - kick * place, 1.0, 1e-8);
            near(-linear.im - kick * slope, speed, 1e-8);
        }
        // On the way up nothing is left but at the touch; down it is the fold.
        assert!(found.open.is_empty(), "{:?}", found.open);
        let without = self::found(&machine(engine, &task("F", [0.4, 0.9], 11, "unstable = false")));
        assert!(without.unstable.is_none() && unstable(&without.rows).is_empty());
    }
}

/// A flip is no jump, and yet the orbit of half the period goes on: from the flip of the branch to the next.
#[test]
fn beyond_a_flip_the_orbit_goes_on() {
    for engine in ["one", "many"] {
        let system = "[parameters]\nw = 2.4\n[system]\nperiod = \"2*pi/w\"\ndamping = 0.1\nstiffness = 1\nforcing = [{ cos = 1 }]\n\
                      [[stops]]\nside = \"upper\"\noffset = 0.1\nrestitution = 0.8\n";
        let branch = "[[tasks]]\nname = \"branch\"\nkind = \"branch\"\nparameter = \"w\"\nrange = [2.3, 2.6]\n\
                      starts = [{ at = 2.4, attractor = { q = 0 } }]\n";
        let text =
            format!("engine = \"{engine}\"\n{system}{}{branch}", task("w", [2.3, 2.6], 7, "sweep = \"up\""));
        let all = reports(&text).unwrap();
        let Some(Findings::Response(found)) = &all[0].findings else { panic!("{}", all[0]) };
        let branch = serde_json::to_value(&all[1]).unwrap();
        let flip = branch["labels"].as_array().unwrap().iter().find(|row| row["label"] == "flip 1").unwrap();
        let stretch = &found.unstable.as_ref().unwrap()[0];
        assert_eq!((stretch.begins.as_str(), stretch.pattern.as_str(), stretch.to), ("flip", "1", 2.6));
        assert_eq!(stretch.ends, "a parameter is at its bound");
        near(stretch.from, number(&flip["parameters"][0]), 1e-9);
        // Where it begins the swing is that of what is seen.
        let first = unstable(&found.rows)[0];
        let seen = |row: &&ResponseRow| row.way == "up" && row.coordinate == "q" && row.value < first.value;
        let last = found.rows.iter().rfind(seen).unwrap();
        assert!((first.swing - last.swing).abs() < 0.05, "{first:?} {last:?}");
    }
}

/// Of a linear response the largest swing is its peak, between the values that are looked at.
#[test]
fn the_largest_swing_is_found_between_values() {
    for engine in ["one", "many"] {
        let scene = format!(
            "engine = \"{engine}\"\n[parameters]\nw = 1\n[system]\nperiod = \"2*pi/w\"\ndamping = 0.2\nstiffness = 1\n\
             forcing = [{{ cos = 1 }}]\n{}",
            task("w", [0.6, 1.4], 10, "seen = true")
        );
        let found = found(&scene);
        let highest = found.highest.as_ref().unwrap();
        assert_eq!(highest.len(), 2);
        for row in highest {
            near(row.value, (1.0f64 - 0.02).sqrt(), 1e-4);
            near(row.swing, 1.0 / (0.2 * (1.0f64 - 0.01).sqrt()), 1e-8);
            near(row.amplitude, row.swing, 1e-7);
        }
    }
}
