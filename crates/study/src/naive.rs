//! The paper's formulas as printed, in plain `f64` with the system's sine: what a first program would do.

use std::f64::consts::PI;

use num_traits::ToPrimitive;

use num_rational::BigRational;

use crate::local::{Plane, Point};

/// b_{n,k} by (62) or (B1) from (r, s), by powers of the eigenvalues from (a₁, a₂). No guarantee whatever.
pub fn naive_b(point: &Point, n: u64, k: u64) -> f64 {
    let (n, k) = (n as f64, k as f64);
    match point {
        Point::Polar(polar) => {
            let (r, s) = (float(polar.r()), float(polar.s()));
            if r == 1.0 {
                return -2.0 * (k * PI * s).sin() * ((n - k) * PI * s).sin() / (n * PI * s).cos();
            }
            let theta = 2.0 * PI * s;
            let sine = (n * theta).sin();
            let numerator = r.powf(n - k) * sine - r.powf(n) * ((n - k) * theta).sin() - (k * theta).sin();
            numerator / (r.powf(n - k) * sine)
        }
        Point::Plane(plane) => {
            let a2 = float(plane.a2());
            (u(plane, n) - u(plane, k) - a2.powf(k) * u(plane, n - k)) / u(plane, n)
        }
    }
}

/// c_n by (60). No guarantee whatever.
pub fn naive_c(plane: &Plane, n: u64) -> f64 {
    let (a1, a2, n) = (float(plane.a1()), float(plane.a2()), n as f64);
    let v = 2.0 * u(plane, n + 1.0) - a1 * u(plane, n);
    -(1.0 - v + a2.powf(n)) / u(plane, n)
}

/// u_k, by powers of the eigenvalues.
fn u(plane: &Plane, k: f64) -> f64 {
    let (a1, a2) = (float(plane.a1()), float(plane.a2()));
    let discriminant = a1 * a1 - 4.0 * a2;
    let root = discriminant.abs().sqrt();
    if discriminant > 0.0 {
        (((a1 + root) / 2.0).powi(k as i32) - ((a1 - root) / 2.0).powi(k as i32)) / root
    } else {
        let theta = root.atan2(a1);
        a2.sqrt().powf(k - 1.0) * (k * theta).sin() / theta.sin()
    }
}

fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}
