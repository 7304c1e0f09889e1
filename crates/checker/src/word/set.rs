//! The set of (a₁, a₂) that a certificate speaks of, and the signs of u_n and N_{n,k} on all of it.
//!
//! In units of 2^−P the set lies in a rectangle with the middle c = (c₁, c₂) and half-widths h = (h₁, h₂),
//! all whole numbers. Let ρ be 1 if the rectangle lies in |a₁| ≤ 1 + a₂, 0 ≤ a₂ ≤ 1, else a power of 2
//! with |a₁| ≤ ρ on it, 0 ≤ a₂ ≤ 1. The eigenvalues are then at most ρ ≥ 1 in modulus, and u_n, the sum of
//! λ^i µ^{n−1−i}, at most n ρⁿ. With generating functions, Σ u_n zⁿ = U = z/(1 − a₁z + a₂z²): ∂U/∂a₁ = U²,
//! ∂U/∂a₂ = −zU². So
//!
//! ```text
//! ∂u_n/∂a₁ = d_n = Σ u_j u_{n−j},   ∂u_n/∂a₂ = −d_{n−1},   |d_n| ≤ n³ρⁿ/6,   second derivatives ≤ n⁵ρⁿ/60,
//! N_{n,k} = u_n − u_k − a₂ᵏ u_{n−k},
//! ∂N/∂a₁ = d_n − d_k − a₂ᵏ d_{n−k},   ∂N/∂a₂ = −d_{n−1} + d_{k−1} + a₂ᵏ d_{n−k−1} − k a₂^{k−1} u_{n−k},
//! ```
//!
//! and the second derivatives of N are at most (n⁵/30 + k(n−k)³/3 + k²(n−k)) ρⁿ ≤ n⁵ρⁿ/10. (n³, n⁵ are
//! superadditive; k(n−k)³ ≤ 27n⁴/256, k²(n−k) ≤ 4n³/27, n ≥ 2.) By Taylor's formula about c, |N − N(c)|
//! ≤ |∂₁N(c)| h₁ + |∂₂N(c)| h₂ + (h₁ + h₂)² n⁵ρⁿ/20 on the rectangle; likewise u.
//!
//! *Rounding.* u at c is computed by its recurrence, each step off by less than a unit: the errors add up to
//! Σ |u_{n−j}| ≤ n²ρⁿ/2 units. d_{n+1} = c₁d_n − c₂d_{n−1} + u_n is off by at most n⁴ρⁿ. The powers of c₂ ≤ 1
//! are rounded down, c₂ᵏ by less than k units. So N(c) is off by less than 4n²ρⁿ units, the two derivatives
//! by less than 10n⁴ρⁿ. Where the rectangle is a few units wide the derivatives at c are not needed: they are
//! at most (n³/3 + k(n−k)) ρⁿ ≤ n³ρⁿ/2 on the rectangle, so that |N − N(c)| ≤ n³ρⁿ (h₁ + h₂).

use std::cmp::Ordering;

use super::{
    integer::Integer,
    number::{Rational, trace},
};
use crate::rejection::ensure;

/// A set of (a₁, a₂), 0 < a₂ ≤ 1, as it is written.
#[derive(Debug, Clone)]
pub(crate) enum Place {
    /// The point.
    Plane(Rational, Rational),
    /// a₁ = 2r cos 2πs, a₂ = r².
    Polar(Rational, Rational),
    /// lower and upper end of a₁, then of a₂.
    Box([Rational; 4]),
}

impl Place {
    /// The ends of a₂.
    pub fn a2(&self) -> [Rational; 2] {
        match self {
            Place::Plane(_, a2) => [a2.clone(), a2.clone()],
            Place::Polar(r, _) => [r.times(r), r.times(r)],
            Place::Box([.., lower, upper]) => [lower.clone(), upper.clone()],
        }
    }

    /// The ends of a₁, if they are exact.
    fn a1(&self) -> Option<[&Rational; 2]> {
        match self {
            Place::Plane(a1, _) => Some([a1, a1]),
            Place::Polar(..) => None,
            Place::Box([lower, upper, ..]) => Some([lower, upper]),
        }
    }

    /// The paper's region that all of the set certainly lies in.
    pub fn region(&self) -> Option<u64> {
        let Some([lower, upper]) = self.a1() else { return Some(3) };
        let [below, above] = self.a2();
        let (four, less) = (Rational::whole(4), Ordering::Less);
        let [square_below, square_above] = [lower.times(lower), upper.times(upper)];
        // 1 + a₂ at its least and greatest.
        let [line_below, line_above] = [&below, &above].map(|a2| a2.plus(&Rational::whole(1)));
        let real = |least_square: &Rational| least_square.compared(&four.times(&above)) != less;
        let complex = |square: &Rational| square.compared(&four.times(&below)) == less;
        if complex(&square_below) && complex(&square_above) {
            Some(3)
        } else if lower.is_positive() && lower.compared(&line_above) == Ordering::Greater {
            Some(1)
        } else if lower.is_positive() && upper.compared(&line_below) == less && real(&square_below) {
            Some(2)
        } else if upper.p.sign() == less
            && real(&square_above)
            && lower.negated().compared(&line_below) == less
        {
            Some(4)
        } else if upper.p.sign() == less && upper.negated().compared(&line_above) == Ordering::Greater {
            Some(5)
        } else {
            None
        }
    }
}

impl Place {
    /// Whether −(a₂+1) < a₁ < 2√a₂ certainly holds on all of the set.
    pub fn is_in_three_or_four(&self) -> bool {
        let Some([lower, upper]) = self.a1() else { return true };
        let [below, _] = self.a2();
        let less = Ordering::Less;
        let right = lower.negated().compared(&below.plus(&Rational::whole(1))) == less;
        // a₂ > 0, so that a₁ = 0 is to the left of 2√a₂.
        let left =
            upper.p.sign() == less || upper.times(upper).compared(&Rational::whole(4).times(&below)) == less;
        right && left
    }
}

/// What is known of u_n and N_{n,k} on a set, in units of 2^−P.
pub(crate) struct Signs {
    place: Place,
    bits: usize,
    center: [Integer; 2],
    half: [Integer; 2],
    /// ρ = 2^`rho`.
    rho: usize,
    /// u_0, … and d_0, … and c₂⁰, … at c.
    u: Vec<Integer>,
    d: Vec<Integer>,
    power: Vec<Integer>,
    /// W_0, W_1, …, the whole numbers D^{n−1} u_n at a point (a₁, a₂), as far as they were asked for.
    exact: Vec<Integer>,
}

impl Signs {
    /// With P = `bits`; nothing is computed yet.
    pub fn new(place: Place, bits: usize) -> Result<Signs, String> {
        let one = Integer::power_of_two(bits);
        let [below, above] = place.a2();
        let second = (below.floor(bits), above.ceiling(bits));
        let first = match (&place, place.a1()) {
            (_, Some([lower, upper])) => (lower.floor(bits), upper.ceiling(bits)),
            (Place::Polar(r, s), None) => {
                let (middle, unit) = (trace(r, s, bits), Integer::from(1));
                (&middle - &unit, &middle + &unit)
            }
            _ => return Err("a1 is not known".into()),
        };
        // The upper end is kept as it is, so that a₂ ≤ 1 stays true.
        let middle = |(lower, upper): (Integer, Integer)| {
            let center = (&lower + &upper).shifted_down(1);
            let half = &upper - &center;
            (center, half)
        };
        let ((c1, h1), (c2, h2)) = (middle(first), middle(second));
        let least = &c2 - &h2;
        ensure(least.sign() != Ordering::Less, format_args!("{bits} bits do not tell that a2 > 0"))?;
        let greatest = &c1.magnitude() + &h1;
        let inside = greatest.compared(&(&one + &least)) != Ordering::Greater;
        // |a₁| < 2^(its bits − P).
        let rho = if inside { 0 } else { greatest.bits().saturating_sub(bits).max(1) };
        let (u, d) = (vec![Integer::zero(), one.clone()], vec![Integer::zero(); 2]);
        let exact = vec![Integer::zero(), Integer::from(1)];
        Ok(Signs { place, bits, center: [c1, c2], half: [h1, h2], rho, u, d, power: vec![one], exact })
    }

    /// Makes u_n and N_{n,k} known up to n = `last`. Memory: O(`last` (P + `last` log ρ)) bits.
    pub fn reach(&mut self, last: usize) {
        let [c1, c2] = &self.center;
        let step = |x: &Integer, y: &Integer| (&(c1 * x) - &(c2 * y)).shifted_down(self.bits);
        for n in self.u.len() - 1..last {
            let (u, d) = (step(&self.u[n], &self.u[n - 1]), step(&self.d[n], &self.d[n - 1]));
            self.d.push(&d + &self.u[n]);
            self.u.push(u);
        }
        for n in self.power.len()..=last {
            self.power.push((&self.power[n - 1] * c2).shifted_down(self.bits));
        }
    }

    /// The products of two 32-bit digits that [`reach`](Signs::reach) takes, about.
    pub fn reach_cost(&self, last: usize) -> u64 {
        5 * last as u64 * self.sign_cost(last) / 8
    }

    /// Those of one sign of index n, about.
    pub fn sign_cost(&self, n: usize) -> u64 {
        8 * (self.bits as u64 / 32 + 1) * ((self.bits + self.rho * n) as u64 / 32 + 1)
    }

    /// Those of [`u_vanishes`](Signs::u_vanishes), about.
    pub fn exact_cost(&self, n: usize) -> u64 {
        let Place::Plane(a1, a2) = &self.place else { return 1000 };
        let digits = (a1.q.bits().max(a1.p.bits()) + a2.q.bits().max(a2.p.bits())) as u64 / 32 + 1;
        3 * digits * digits * (n as u64).pow(2)
    }

    /// The sign of u_n on all of the set, if it is certain and not 0.
    pub fn u(&self, n: usize) -> Option<Ordering> {
        let gradient = || [self.d[n].clone(), -&self.d[n - 1]];
        self.certain(n, &self.u[n], gradient)
    }

    /// The sign of N_{n,k} = u_n − u_k − a₂ᵏ u_{n−k}, 0 < k < n, on all of the set, if it is certain and
    /// not 0.
    pub fn numerator(&self, n: usize, k: usize) -> Option<Ordering> {
        let weighted = |x: &Integer| (&self.power[k] * x).shifted_down(self.bits);
        let (u, d) = (&self.u, &self.d);
        let value = &(&u[n] - &u[k]) - &weighted(&u[n - k]);
        let gradient = || {
            let first = &(&d[n] - &d[k]) - &weighted(&d[n - k]);
            let slope = &Integer::from(k as u64) * &(&self.power[k - 1] * &u[n - k]).shifted_down(self.bits);
            let second = &(&(&d[k - 1] - &d[n - 1]) + &weighted(&d[n - k - 1])) - &slope;
            [first, second]
        };
        self.certain(n, &value, gradient)
    }

    /// The sign of a quantity of index n on all of the set, from its value and its derivatives at c.
    fn certain(&self, n: usize, value: &Integer, gradient: impl Fn() -> [Integer; 2]) -> Option<Ordering> {
        let n = n as u64;
        let size = |factor: u64| Integer::from(factor).shifted_up(self.rho * n as usize);
        let [h1, h2] = &self.half;
        let width = h1 + h2;
        let rounding = size(4 * n * n);
        let beyond = |bound: &Integer| value.magnitude().compared(bound) == Ordering::Greater;
        if beyond(&(&rounding + &(&size(n * n * n) * &width))) {
            return Some(value.sign());
        }
        let error = size(10 * n * n * n * n);
        let [first, second] = gradient().map(|slope| &slope.magnitude() + &error);
        let linear = (&(&first * h1) + &(&second * h2)).shifted_down(self.bits);
        let square = (&(&width * &width) * &size(n.pow(5) / 20 + 1)).shifted_down(self.bits);
        // Two units for the two roundings down.
        let bound = &(&(&rounding + &linear) + &square) + &Integer::from(2);
        beyond(&bound).then(|| value.sign())
    }

    /// Whether u_n = 0 exactly; a set with more than one point, or one given by (r, s) with 2ns not whole,
    /// answers no.
    pub fn u_vanishes(&mut self, n: usize) -> bool {
        match &self.place {
            Place::Polar(_, s) => (&Integer::from(2 * n as u64) * &s.p).divided(&s.q).1.is_zero(),
            Place::Plane(a1, a2) => {
                // W_n = D^{n−1} u_n with D = q₁q₂: W_{n+1} = A W_n − B W_{n−1}, A = D a₁, B = D² a₂.
                let a = &a1.p * &a2.q;
                let b = &(&(&a1.q * &a1.q) * &a2.q) * &a2.p;
                while self.exact.len() <= n {
                    let k = self.exact.len();
                    let next = &(&a * &self.exact[k - 1]) - &(&b * &self.exact[k - 2]);
                    self.exact.push(next);
                }
                self.exact[n].is_zero()
            }
            Place::Box(_) => false,
        }
    }

    pub fn place(&self) -> &Place {
        &self.place
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rational(text: &str) -> Rational {
        Rational::read(text).unwrap()
    }

    fn signs(place: Place, bits: usize, last: usize) -> Signs {
        let mut signs = Signs::new(place, bits).unwrap();
        signs.reach(last);
        signs
    }

    /// u_n and N_{n,k} in whole numbers: D^{n−1} u_n, and N times a power of D.
    fn exact(a: i128, b: i128, d: i128, last: usize) -> Vec<i128> {
        let mut w = vec![0, 1];
        for k in 1..last {
            w.push(a * w[k] - b * d * w[k - 1]);
        }
        w
    }

    fn sign_of_numerator(b: i128, d: i128, w: &[i128], n: usize, k: usize) -> Ordering {
        let power = |x: i128, e: usize| (0..e).fold(1i128, |y, _| y * x);
        // a₂ = b/d, u_j = w_j/d^{j−1}: times d^{n−1}.
        let value = w[n] - power(d, n - k) * w[k] - power(b, k) * w[n - k];
        value.cmp(&0)
    }

    /// Every sign told is right, and at generic points all are told; boxes about them hold every corner's
    /// sign.
    #[test]
    fn signs_are_those_of_whole_numbers() {
        let (last, mut told, mut untold) = (9, 0, 0);
        for d in [5i128, 7, 11] {
            for b in 1..=d {
                for a in -3 * d..=3 * d {
                    let text = |p: i128, q: i128| {
                        let mut g = (p.abs(), q);
                        while g.1 > 0 {
                            g = (g.1, g.0 % g.1);
                        }
                        rational(&format!("{}/{}", p / g.0, q / g.0))
                    };
                    let (a1, a2) = (text(a, d), text(b, d));
                    let point = signs(Place::Plane(a1, a2), 96, last);
                    let corners =
                        [(a, b), (10 * a + 1, 10 * b), (10 * a, 10 * b - 1), (10 * a + 1, 10 * b - 1)];
                    let ends =
                        [(10 * a, 10 * d), (10 * a + 1, 10 * d), (10 * b - 1, 10 * d), (10 * b, 10 * d)];
                    let wide = signs(Place::Box(ends.map(|(p, q)| text(p, q))), 96, last);
                    let tables = corners.map(|(a, b)| {
                        let d = if a.abs() > 3 * d || b > d || (a, b) != corners[0] { 10 * d } else { d };
                        (b, d, exact(a, b, d, last))
                    });
                    for n in 2..=last {
                        for k in 1..n {
                            let (b, d, w) = &tables[0];
                            let truth = sign_of_numerator(*b, *d, w, n, k);
                            match point.numerator(n, k) {
                                Some(sign) => assert_eq!(sign, truth, "{a} {b} {d} {n} {k}"),
                                None => assert_eq!(truth, Ordering::Equal),
                            }
                            let Some(sign) = wide.numerator(n, k) else {
                                untold += 1;
                                continue;
                            };
                            told += 1;
                            for (b, d, w) in &tables {
                                assert_eq!(sign, sign_of_numerator(*b, *d, w, n, k), "{b} {d} {n} {k}");
                            }
                        }
                    }
                }
            }
        }
        assert!(told > untold && untold > 100, "{told} told, {untold} not");
    }

    #[test]
    fn zeros_are_exact() {
        let mut point = Signs::new(Place::Plane(rational("1/2"), rational("1/4")), 64).unwrap();
        // λ = e^{iπ/3}/2: u_3 = u_6 = 0.
        let zeros: Vec<usize> = (1..=12).filter(|&n| point.u_vanishes(n)).collect();
        assert_eq!(zeros, [3, 6, 9, 12]);
        let mut point = Signs::new(Place::Polar(rational("1/2"), rational("1/10")), 64).unwrap();
        let zeros: Vec<usize> = (1..=12).filter(|&n| point.u_vanishes(n)).collect();
        assert_eq!(zeros, [5, 10]);
    }

    #[test]
    fn regions_are_those_of_the_whole_set() {
        let of = |text: &str| {
            let ends: Vec<Rational> = text.split(' ').map(rational).collect();
            Place::Box(ends.try_into().unwrap()).region()
        };
        assert_eq!(of("-1/1 1/1 1/2 3/4"), Some(3));
        assert_eq!(of("-1/1 1/1 1/4 3/4"), None);
        assert_eq!(of("1/1 1/1 1/4 1/4"), Some(2));
        assert_eq!(of("1/1 5/4 1/4 1/4"), None);
        assert_eq!(of("11/8 3/2 1/4 1/3"), Some(1));
        assert_eq!(of("-11/10 -1/1 1/8 1/4"), Some(4));
        assert_eq!(of("-11/10 -1/1 1/10 1/4"), None);
        assert_eq!(of("-3/2 -11/8 1/4 1/3"), Some(5));
        // Regions 3 and 4 together: across a₁ = −2√a₂, but neither across 2√a₂ nor to a₁ = −(a₂ + 1).
        let together = |text: &str| {
            let ends: Vec<Rational> = text.split(' ').map(rational).collect();
            Place::Box(ends.try_into().unwrap()).is_in_three_or_four()
        };
        for inside in
            ["-21/20 -1/1 1/10 1/4", "-11/10 -9/10 1/4 1/4", "-11/10 9/10 1/4 1/4", "0/1 0/1 1/9 1/9"]
        {
            assert!(together(inside), "{inside}");
        }
        for outside in ["-11/10 1/1 1/4 1/4", "-5/4 -1/1 1/4 1/4", "-3/2 -11/8 1/4 1/3", "1/1 1/1 1/4 1/3"] {
            assert!(!together(outside), "{outside}");
        }
    }
}
