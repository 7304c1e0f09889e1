//! Regions 2 and 4, all of them, by identities between integer polynomials.
//!
//! The eigenvalues are x and ρx, 0 < ρ ≤ 1, with 0 < x < 1 in region 2 and x = −µ, 0 < µ < 1, in region 4
//! (there a₁ = x(1 + ρ), a₂ = ρx², and
//! |a₁| < a₂ + 1 reads (1 − |x|)(1 − ρ|x|) > 0). With [k] = 1 + ρ + … + ρ^{k−1}, u_k = x^{k−1}[k], so that
//!
//! ```text
//! N_{n,k} = u_n − u_k − a₂^k u_{n−k} = x^{k−1} p_k,   p_k = x^{n−k}[n] − [k] − xⁿρ^k[n−k],
//! ```
//!
//! and c_n has the sign of −u_n, since 1 − v_n + a₂ⁿ = (1 − xⁿ)(1 − ρⁿxⁿ) > 0.
//!
//! **Region 2.** p_k = −(1−x) Σ_{i<k, j<n−k} ρ^i x^j (1 − ρ^{k+j−i} x^{n−k+i−j}), every term positive: all
//! N_{n,k} < 0. As u_n > 0, all b_{n,k} < 0 and c_n < 0: there is an orbit, in the case (−,+), everywhere.
//!
//! **Region 4, n even, n ≥ 4.** −N_{n,1} = µ^{n−1}[n] + µⁿρ[n−1] + 1 > 0, and
//! N_{n,2} = µ(1−µ²)(1+ρ) Σ_{i<(n−2)/2} (µ^{2i} − ρ^{2+2i} µ^{n−2}) > 0, as 2i < n − 2: no orbit, anywhere.
//!
//! **Region 4, n odd, d = n − 2.** u_n > 0. For even k, −p_k = µ^{n−k}[n] + [k] − µⁿρ^k[n−k] ≥ [k] + µⁿ([n] −
//! ρ^k[n−k]) > 0 and x^{k−1} < 0: N_{n,k} > 0. For odd k < d and h = (n−k)/2,
//!
//! ```text
//! ρ^{d−k}[2] p_k − [n−k] p_d = (1−µ²)[n][2] Σ_{i<h} (ρ^{2i} − ρ^{2h−2} µ^{2i}) ≥ 0,
//! ```
//!
//! so p_d > 0 makes every N_{n,k} > 0; where p_d ≤ 0, N_{n,2} > 0 ≥ N_{n,d}. So there is an orbit exactly
//! where p_d > 0, in the case (+,−): all b > 0 and c_n < 0. This set is connected, and so is its part ρ = 1:
//! p_d = µ²[n] − [n−2] + µⁿρ^{n−2}[2] grows with µ and is 2ρ^{n−2}(1+ρ) > 0 at µ = 1, so that it holds for
//! µ*(ρ) < µ < 1 with a continuous µ* < 1.

/// An integer polynomial in ρ (degree < `width`) and x or µ.
struct Polynomial {
    width: usize,
    coefficients: Vec<i64>,
}

impl Polynomial {
    /// 0, with room for ρ^i x^j, i < 2n and j ≤ n.
    fn zero(n: usize) -> Self {
        Polynomial { width: 2 * n, coefficients: vec![0; 2 * n * (n + 1)] }
    }

    /// Adds c ρ^i x^j.
    fn add(&mut self, c: i64, i: usize, j: usize) {
        self.coefficients[j * self.width + i] += c;
    }

    /// Adds c ρ^i x^j [k].
    fn add_bracket(&mut self, c: i64, i: usize, j: usize, k: usize) {
        let start = j * self.width + i;
        self.coefficients[start..start + k].iter_mut().for_each(|value| *value += c);
    }

    fn is_zero(&self) -> bool {
        self.coefficients.iter().all(|&c| c == 0)
    }

    /// Adds c ρ^i p_k, the variable being x (`sign` 1) or µ with x = −µ (`sign` −1).
    fn add_p(&mut self, c: i64, i: usize, n: usize, k: usize, sign: i64) {
        let power = |j: usize| sign.pow(j as u32);
        self.add_bracket(c * power(n - k), i, n - k, n);
        self.add_bracket(-c, i, 0, k);
        self.add_bracket(-c * power(n), i + k, n, n - k);
    }
}

/// Whether region 2's identity holds for every k, n ≥ 2. Cost: O(n³) additions of integers.
pub(super) fn region2(n: u64) -> bool {
    let n = n as usize;
    (1..n).all(|k| {
        let mut difference = Polynomial::zero(n);
        difference.add_p(1, 0, n, k, 1);
        for (i, j) in (0..k).flat_map(|i| (0..n - k).map(move |j| (i, j))) {
            for (c, x) in [(1, 0), (-1, 1)] {
                difference.add(c, i, j + x);
                difference.add(-c, k + j, n - k + i + x);
            }
        }
        difference.is_zero()
    })
}

/// Whether region 4's identities hold, n ≥ 3. Cost: O(n³) additions of integers.
pub(super) fn region4(n: u64) -> bool {
    let n = n as usize;
    if n.is_multiple_of(2) {
        region4_even(n)
    } else {
        (1..n).step_by(2).all(|k| region4_odd(n, k)) && region4_rest(n)
    }
}

fn region4_even(n: usize) -> bool {
    let mut first = Polynomial::zero(n);
    first.add_p(1, 0, n, 1, -1);
    first.add_bracket(1, 0, n - 1, n);
    first.add_bracket(1, 1, n, n - 1);
    first.add(1, 0, 0);
    // N_{n,2} = −µ p_2.
    let mut second = Polynomial::zero(n);
    second.add_p(-1, 0, n, 2, -1);
    for i in 0..(n - 2) / 2 {
        for (c, mu) in [(1, 0), (-1, 2)] {
            second.add_bracket(-c, 0, 2 * i + mu, 2);
            second.add_bracket(c, 2 + 2 * i, n - 2 + mu, 2);
        }
    }
    first.is_zero() && second.is_zero()
}

/// The identity for odd n and k.
fn region4_odd(n: usize, k: usize) -> bool {
    let (d, h) = (n - 2, (n - k) / 2);
    let mut difference = Polynomial::zero(n);
    if k == d {
        return true;
    }
    for i in 0..2 {
        difference.add_p(1, d - k + i, n, k, -1);
    }
    for i in 0..n - k {
        difference.add_p(-1, i, n, d, -1);
    }
    for i in 0..h {
        for (c, mu) in [(1, 0), (-1, 2)] {
            for two in 0..2 {
                difference.add_bracket(-c, 2 * i + two, mu, n);
                difference.add_bracket(c, 2 * h - 2 + two, 2 * i + mu, n);
            }
        }
    }
    difference.is_zero()
}

/// For odd n: the forms of p_k, k even, and of p_d that the text reads signs from.
fn region4_rest(n: usize) -> bool {
    let even = (2..n).step_by(2).all(|k| {
        let mut difference = Polynomial::zero(n);
        difference.add_p(1, 0, n, k, -1);
        difference.add_bracket(1, 0, n - k, n);
        difference.add_bracket(1, 0, 0, k);
        difference.add_bracket(-1, k, n, n - k);
        difference.is_zero()
    });
    let mut decider = Polynomial::zero(n);
    decider.add_p(1, 0, n, n - 2, -1);
    decider.add_bracket(-1, 0, 2, n);
    decider.add_bracket(1, 0, 0, n - 2);
    decider.add_bracket(-1, n - 2, n, 2);
    even && decider.is_zero()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_identities_hold() {
        for n in 3..=60 {
            assert!(region2(n) && region4(n), "n = {n}");
        }
    }
}
