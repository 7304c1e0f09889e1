//! The minimum test: what a gap does on one piece, its extrema first, its roots only on falling stretches.
//!
//! A gap on a piece is a polynomial z(x), |x| ≤ 1. Intervals are split until one of four things is certain of them, by Taylor's formula about the
//! middle with a bound on |z‴| that holds on all of [−1, 1]: z > δ; z convex; z concave; z monotone. In the last three cases the stretches on which z
//! falls are known, and an impact is a root on such a stretch whose end lies below −δ. Thus no minimum below −δ is passed over, however narrow;
//! the zero that an impact leaves behind is never met again, as z does not fall there; and minima within δ of 0 are tangencies. Intervals
//! too narrow to tell the cases apart hold z to better than δ and are taken as monotone between their ends.

/// What ends a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Hit {
    /// A root of z on a falling stretch that ends below −δ.
    Impact(f64),
    /// A minimum within δ of 0 after z was above δ.
    Tangency(f64),
    /// A maximum at which z has not risen above 0: the wall presses.
    Press(f64),
}

impl Hit {
    /// Where.
    pub fn place(self) -> f64 {
        match self {
            Hit::Impact(x) | Hit::Tangency(x) | Hit::Press(x) => x,
        }
    }
}

/// A gap on one piece.
#[derive(Debug)]
pub(super) struct Gap<'a> {
    coefficients: &'a [f64],
    /// Bounds |z‴| on the piece.
    third: f64,
    /// δ, or the rounding error of z where that is larger.
    depth: f64,
    /// Whether z was above δ since the last contact.
    pub open: bool,
}

/// Rounding: a sum of 24 terms by Horner errs by less than this times Σ |c_i|.
pub(super) const ROUNDING: f64 = 1e-14;

/// Σ |c_i|.
pub(super) fn norm(coefficients: &[f64]) -> f64 {
    coefficients.iter().map(|c| c.abs()).sum()
}

/// Whether the gap surely stays above `depth` and its rounding error on all of [−1, 1].
pub(super) fn clear(coefficients: &[f64], depth: f64) -> bool {
    let (start, slope, bend) = (coefficients[0], coefficients[1].abs(), coefficients[2]);
    let tail = norm(&coefficients[3..]);
    let low = if slope < 2.0 * bend { slope * slope / (4.0 * bend) } else { slope - bend };
    start - low - tail > depth + ROUNDING * (start + slope + bend.abs() + tail)
}

impl<'a> Gap<'a> {
    pub fn new(coefficients: &'a [f64], depth: f64, open: bool) -> Self {
        let third =
            (3..coefficients.len()).map(|i| (i * (i - 1) * (i - 2)) as f64 * coefficients[i].abs()).sum();
        Gap { coefficients, third, depth: depth.max(ROUNDING * norm(coefficients)), open }
    }

    /// z, z′, z″ at x.
    pub fn at(&self, x: f64) -> [f64; 3] {
        let [z, slope, half] = self
            .coefficients
            .iter()
            .rev()
            .fold([0.0; 3], |[z, slope, half], c| [z * x + c, slope * x + z, half * x + slope]);
        [z, slope, 2.0 * half]
    }

    /// The first hit in [l, r], or None: then z has no minimum below −δ there, and any fall below it is still to come.
    pub fn first(&mut self, l: f64, r: f64) -> Option<Hit> {
        let (centre, half) = ((l + r) / 2.0, (r - l) / 2.0);
        let [z, slope, bend] = self.at(centre);
        let (turn, tail) = (self.third * half, self.third * half * half * half / 6.0);
        let reach = bend * half;
        let low = if slope.abs() < reach {
            slope * slope / (2.0 * bend)
        } else {
            (slope.abs() - reach / 2.0) * half
        };
        if z - low - tail > self.depth {
            self.open = true;
            return None;
        }
        if bend > turn {
            let ([_, left, _], [_, right, _]) = (self.at(l), self.at(r));
            return match (left < 0.0, right > 0.0) {
                (false, _) => self.rise(r),
                (true, false) => self.fall(l, r, false),
                (true, true) => {
                    let bottom = self.extremum(l, r, centre - slope / bend);
                    self.fall(l, bottom, true).or_else(|| self.rise(r))
                }
            };
        }
        if bend < -turn {
            let ([_, left, _], [_, right, _]) = (self.at(l), self.at(r));
            return match (left > 0.0, right < 0.0) {
                (false, _) => self.fall(l, r, false),
                (true, false) => self.rise(r),
                (true, true) => {
                    let top = self.extremum(l, r, centre - slope / bend);
                    if self.at(top)[0] <= 0.0 {
                        return Some(Hit::Press(top));
                    }
                    self.rise(top).or_else(|| self.fall(top, r, false))
                }
            };
        }
        if slope.abs() > (bend.abs() + turn / 2.0) * half || tail < self.depth / 8.0 {
            return if slope > 0.0 { self.rise(r) } else { self.fall(l, r, false) };
        }
        self.first(l, centre).or_else(|| self.first(centre, r))
    }

    /// z rises up to r.
    fn rise(&mut self, r: f64) -> Option<Hit> {
        self.open |= self.at(r)[0] > self.depth;
        None
    }

    /// z falls from l to r, where it may have a minimum.
    fn fall(&mut self, l: f64, r: f64, minimum: bool) -> Option<Hit> {
        let ([above, ..], [below, _, bend]) = (self.at(l), self.at(r));
        self.open |= above > self.depth;
        if below < -self.depth {
            let guess = if minimum {
                r - (-2.0 * below / bend).sqrt()
            } else {
                l + (r - l) * above / (above - below)
            };
            Some(Hit::Impact(if above > 0.0 { self.root(l, r, guess) } else { l }))
        } else if minimum && below <= self.depth && self.open {
            self.open = false;
            Some(Hit::Tangency(r))
        } else {
            None
        }
    }

    /// The root of z′ between l and r, where it changes sign and z″ does not: Newton kept inside the bracket.
    fn extremum(&self, mut l: f64, mut r: f64, mut x: f64) -> f64 {
        let falling = self.at(l)[1] < 0.0;
        for _ in 0..100 {
            if !(l < x && x < r) {
                x = (l + r) / 2.0;
            }
            let [_, slope, bend] = self.at(x);
            if (slope < 0.0) == falling {
                l = x
            } else {
                r = x
            }
            let step = slope / bend;
            x -= step;
            // The next step would be of order step²: z changes by its square.
            if step.abs() < 1e-8 {
                break;
            }
        }
        x.clamp(l, r)
    }

    /// The root of z between l and r, z(l) > 0 > z(r), on a falling stretch: Newton kept inside the bracket, to rounding.
    fn root(&self, mut l: f64, mut r: f64, mut x: f64) -> f64 {
        for _ in 0..200 {
            if !(l < x && x < r) {
                x = (l + r) / 2.0;
            }
            let [z, slope, bend] = self.at(x);
            if z > 0.0 {
                l = x
            } else {
                r = x
            }
            let step = z / slope;
            x -= step;
            // What is left is about step² |z″ / 2z′|.
            if step * step * bend.abs() <= 1e-17 * slope.abs() || r - l <= 2e-16 {
                break;
            }
        }
        x.clamp(l, r)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (x − roots)… times a factor, as coefficients.
    fn with_roots(factor: f64, roots: &[f64]) -> Vec<f64> {
        roots.iter().fold(vec![factor], |p, root| {
            let mut q = vec![0.0; p.len() + 1];
            for (i, c) in p.iter().enumerate() {
                q[i + 1] += c;
                q[i] -= root * c;
            }
            q
        })
    }

    fn first(p: &[f64]) -> Option<Hit> {
        Gap::new(p, 1e-12, true).first(-1.0, 1.0)
    }

    #[test]
    fn dips_of_any_width_are_found_at_their_first_root() {
        for width in [0.3, 1e-2, 1e-4, 2e-6] {
            let (a, b) = (0.31, 0.31 + width);
            let p = with_roots(1.0, &[a, b, 3.0, 4.0]);
            let Some(Hit::Impact(x)) = first(&p) else { panic!("{width}: {:?}", first(&p)) };
            assert!((x - a).abs() < 1e-15 / width, "{width}: {x}");
            assert!(!clear(&p, 1e-12));
        }
    }

    #[test]
    fn a_shallow_minimum_is_a_tangency_of_either_sign_and_a_higher_one_is_nothing() {
        for (lift, expected) in [(0.0, true), (5e-13, true), (-5e-13, true), (2e-12, false)] {
            let mut p = with_roots(1.0, &[0.2, 0.2]);
            p[0] += lift;
            match first(&p) {
                Some(Hit::Tangency(x)) => assert!(expected && (x - 0.2).abs() < 1e-7),
                other => assert!(!expected && other.is_none(), "{lift}: {other:?}"),
            }
        }
    }

    #[test]
    fn the_zero_left_behind_by_an_impact_is_not_met_again() {
        // Away from the wall and back: only the second root counts.
        let p = with_roots(-1.0, &[-1.0, 0.6]);
        let Some(Hit::Impact(x)) = Gap::new(&p, 1e-12, false).first(-1.0, 1.0) else { panic!() };
        assert!((x - 0.6).abs() < 1e-15);
        // Away for good, the start being on either side of 0 by rounding.
        for start in [-1e-16, 0.0, 1e-16] {
            let p = [start + 0.5, 0.5, 0.1];
            assert_eq!(Gap::new(&p, 1e-12, false).first(-0.876894374382339, 1.0), None);
        }
        // Pressed from the start.
        assert_eq!(Gap::new(&[0.0, 0.0, -1.0, 0.1], 1e-12, false).first(0.0, 1.0), Some(Hit::Impact(0.0)));
    }

    #[test]
    fn flat_contacts_of_any_order_end() {
        let cubic = with_roots(1.0, &[0.1, 0.1, 0.1]);
        assert!(matches!(Gap::new(&cubic, 1e-12, true).first(-1.0, 1.0), None | Some(Hit::Impact(_))));
        let quartic = with_roots(1.0, &[0.1, 0.1, 0.1, 0.1]);
        assert!(matches!(first(&quartic), None | Some(Hit::Tangency(_))));
        let falling = with_roots(-1.0, &[0.1, 0.1, 0.1]);
        let Some(Hit::Impact(x)) = first(&falling) else { panic!() };
        assert!((x - 0.1).abs() < 2e-4);
    }
}
