//! The minimum test: what a gap does on one piece, its extrema first, its roots only on falling stretches.
//!
//! A gap on a piece is a polynomial z(x), |x| ≤ 1. Intervals are split until one of four things is certain of
//! them, by Taylor's formula about the middle with a bound on |z‴| that holds on all of [−1, 1]: z > δ; z
//! convex; z concave; z monotone. In the last three cases the stretches on which z falls are known, and an
//! impact is a root on such a stretch whose end lies below −δ. Thus no minimum below −δ is passed over,
//! however narrow; the zero that an impact leaves behind is never met again, as z does not fall there; and
//! minima within δ of 0 are tangencies. Intervals too narrow to tell the cases apart hold z to better than δ
//! and are taken as monotone between their ends.

/// Gaps within this of their motion's size are contact without impact, unless a depth is given.
pub(crate) const RELATIVE_DEPTH: f64 = 1e-12;

/// What rounding may move the place of an event by.
pub(crate) const NUDGE: f64 = 1e-12;

/// What ends a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Hit {
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

/// A gap on one piece, an even number of coefficients.
#[derive(Debug)]
pub(crate) struct Gap<'a> {
    coefficients: &'a [f64],
    /// Bounds |z‴| on the piece.
    third: f64,
    /// δ, or the rounding error of z where that is larger.
    depth: f64,
    /// Whether z was above δ since the last contact.
    pub open: bool,
}

/// Rounding: a sum of 24 terms by Horner errs by less than this times Σ |c_i|.
pub(crate) const ROUNDING: f64 = 1e-14;

/// Σ |c_i|.
pub(crate) fn norm(coefficients: &[f64]) -> f64 {
    coefficients.iter().map(|c| c.abs()).sum()
}

/// A polynomial as far as [`clear`] needs it: c₀, c₁, c₂ and a bound on Σ |c_i|, i ≥ 3.
pub(crate) type Head = [f64; 4];

pub(crate) fn head(coefficients: &[f64]) -> Head {
    [coefficients[0], coefficients[1], coefficients[2], norm(&coefficients[3..])]
}

/// Whether the gap surely stays above `depth` and its rounding error on all of [−1, 1].
#[inline]
pub(crate) fn clear([start, slope, bend, tail]: Head, depth: f64) -> bool {
    let slope = slope.abs();
    let low = if slope < 2.0 * bend { slope * slope / (4.0 * bend) } else { slope - bend };
    start - low - tail > depth + ROUNDING * (start + slope + bend.abs() + tail)
}

impl<'a> Gap<'a> {
    pub fn new(coefficients: &'a [f64], depth: f64, open: bool) -> Self {
        let third =
            (3..coefficients.len()).map(|i| (i * (i - 1) * (i - 2)) as f64 * coefficients[i].abs()).sum();
        Gap { coefficients, third, depth: depth.max(ROUNDING * norm(coefficients)), open }
    }

    /// z, z′, z″ at x: Horner in x² for the even and the odd terms side by side.
    pub fn at(&self, x: f64) -> [f64; 3] {
        let s = x * x;
        let (mut p, mut first, mut half) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        for pair in self.coefficients.chunks_exact(2).rev() {
            for i in 0..2 {
                half[i] = half[i] * s + first[i];
                first[i] = first[i] * s + p[i];
                p[i] = p[i] * s + pair[i];
            }
        }
        let ([e, o], [e1, o1], [e2, o2]) = (p, first, half);
        let bend = 2.0 * e1 + 8.0 * s * e2 + x * (6.0 * o1 + 8.0 * s * o2);
        [e + x * o, o + 2.0 * (x * e1 + s * o1), bend]
    }

    /// The first hit in [l, r], or None: then z has no minimum below −δ there, and any fall below it is still
    /// to come.
    pub fn first(&mut self, l: f64, r: f64) -> Option<Hit> {
        let (centre, half) = ((l + r) / 2.0, (r - l) / 2.0);
        let [z, slope, bend] = self.at(centre);
        let (turn, tail) = (self.third * half, self.third * half * half * half / 6.0);
        // Taylor's formula; where z is surely convex also z″ ≥ bend − turn.
        let steep = slope.abs();
        let low = if steep < bend * half {
            steep * steep / (2.0 * bend)
        } else {
            (steep - bend * half / 2.0) * half
        };
        if z - low - tail > self.depth
            || bend > turn && z - steep * steep / (2.0 * (bend - turn)) > self.depth
        {
            self.open = true;
            return None;
        }
        let monotone = steep > (bend.abs() + turn / 2.0) * half || tail < self.depth / 8.0;
        if !monotone && bend.abs() <= turn {
            return self.first(l, centre).or_else(|| self.first(centre, r));
        }
        let (left, right) = (self.at(l), self.at(r));
        let turns = bend.abs() > turn && left[1] * bend < 0.0 && right[1] * bend > 0.0;
        if !turns {
            // A slope of 0 at an end: the other end tells.
            return if left[1] + right[1] > 0.0 {
                self.rise(l, left[0], right[0])
            } else {
                self.fall(l, left[0], r, right[0])
            };
        }
        let x = centre - slope / bend;
        if bend > 0.0 {
            return self.valley((l, left[0]), (r, right[0]), x, bend - turn);
        }
        let top = self.top(l, r, x);
        let height = self.at(top)[0];
        if height <= 0.0 {
            return Some(Hit::Press(top));
        }
        self.rise(l, left[0], height).or_else(|| self.fall(top, height, r, right[0]))
    }

    /// z rises from `low` at l to `high`; a minimum between two pieces is met here.
    fn rise(&mut self, l: f64, low: f64, high: f64) -> Option<Hit> {
        if self.open && low <= self.depth {
            self.open = false;
            return Some(Hit::Tangency(l));
        }
        self.open |= high > self.depth;
        None
    }

    /// z falls from `high` at l to `low` at r.
    fn fall(&mut self, l: f64, high: f64, r: f64, low: f64) -> Option<Hit> {
        self.open |= high > self.depth;
        let guess = l + (r - l) * high / (high - low);
        (low < -self.depth).then(|| self.impact(l, high, r, guess))
    }

    /// z is convex and has its minimum between l and r: Newton for z′ kept inside the bracket, until z is
    /// seen below −δ, or surely never is as z″ ≥ `least`, or the minimum is known.
    fn valley(
        &mut self,
        (mut l, high): (f64, f64),
        (mut r, end): (f64, f64),
        mut x: f64,
        least: f64,
    ) -> Option<Hit> {
        let start = l;
        self.open |= high > self.depth;
        for _ in 0..100 {
            if !(l < x && x < r) {
                x = (l + r) / 2.0;
            }
            let [z, slope, bend] = self.at(x);
            if z < -self.depth {
                let guess = x - (slope + (slope * slope - 2.0 * bend * z).sqrt()) / bend;
                return Some(self.impact(start, high, x, guess));
            }
            if z - slope * slope / (2.0 * least) > self.depth {
                break;
            }
            if slope < 0.0 {
                l = x
            } else {
                r = x
            }
            let step = slope / bend;
            x -= step;
            // The next step would be of order step², and z changes by its square.
            if step.abs() < 1e-8 || r - l < 1e-15 {
                x = x.clamp(l, r);
                if self.open && self.at(x)[0] <= self.depth {
                    self.open = false;
                    return Some(Hit::Tangency(x));
                }
                break;
            }
        }
        self.open |= end > self.depth;
        None
    }

    /// The maximum of the concave z between l and r: Newton for z′ kept inside the bracket.
    fn top(&self, mut l: f64, mut r: f64, mut x: f64) -> f64 {
        for _ in 0..100 {
            if !(l < x && x < r) {
                x = (l + r) / 2.0;
            }
            let [_, slope, bend] = self.at(x);
            if slope > 0.0 {
                l = x
            } else {
                r = x
            }
            let step = slope / bend;
            x -= step;
            if step.abs() < 1e-8 || r - l < 1e-15 {
                break;
            }
        }
        x.clamp(l, r)
    }

    /// The impact between l, where z = `high`, and r, where z < −δ; where z is not above 0 at l and rises,
    /// by less than tells monotone from not, the wall presses at its maximum.
    fn impact(&self, l: f64, high: f64, r: f64, guess: f64) -> Hit {
        if high > 0.0 {
            return Hit::Impact(self.root(l, r, guess));
        }
        if self.at(l)[1] <= 0.0 {
            return Hit::Impact(l);
        }
        let top = self.top(l, r, l);
        if self.at(top)[0] > 0.0 { Hit::Impact(self.root(top, r, guess)) } else { Hit::Press(top) }
    }

    /// The root of z between l and r, z(l) > 0 > z(r): there is one only, as z falls or is convex. Newton
    /// kept inside the bracket, to rounding.
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

    /// (x − roots)… times a factor, as coefficients, an even number of them.
    fn with_roots(factor: f64, roots: &[f64]) -> Vec<f64> {
        let mut start = vec![0.0; (roots.len() / 2 + 1) * 2];
        start[0] = factor;
        roots.iter().fold(start, |p, root| {
            let mut q = vec![0.0; p.len()];
            for (i, c) in p.iter().enumerate().take(p.len() - 1) {
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
            assert!(!clear(head(&p), 1e-12));
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
        const ROOT: f64 = -1.381966011250105;
        for start in [-1e-16, 0.0, 1e-16] {
            let p = [start + 0.5, 0.5, 0.1, 0.0];
            assert_eq!(Gap::new(&p, 1e-12, false).first(ROOT, 1.0), None);
        }
        // Pressed from the start.
        assert_eq!(Gap::new(&[0.0, 0.0, -1.0, 0.1], 1e-12, false).first(0.0, 1.0), Some(Hit::Impact(0.0)));
    }

    /// A gap within δ below 0 that rises, not to 0, and falls, on an interval too narrow to tell convex from
    /// concave: an impact at once it would be for ever. At its maximum the wall presses.
    #[test]
    fn what_rises_within_the_depth_is_pressed_at_its_maximum() {
        for (start, slope) in [(-9e-13, 5e-13), (-9e-13, 1e-13), (-5e-13, 2e-13)] {
            let cubic = 9e-13;
            let hit = Gap::new(&[start, slope, 0.0, -cubic], 1e-12, false).first(0.0, 1.0);
            let top = (slope / (3.0 * cubic)).sqrt();
            assert!(matches!(hit, Some(Hit::Press(x)) if (x - top).abs() < 1e-7), "{hit:?} {top}");
        }
    }

    #[test]
    fn flat_contacts_of_any_order_end() {
        let cubic = with_roots(1.0, &[0.1, 0.1, 0.1]);
        assert_eq!(Gap::new(&cubic, 1e-12, false).first(0.1, 1.0), None);
        let quartic = with_roots(1.0, &[0.1, 0.1, 0.1, 0.1]);
        assert!(matches!(first(&quartic), None | Some(Hit::Tangency(_))));
        let falling = with_roots(-1.0, &[0.1, 0.1, 0.1]);
        let Some(Hit::Impact(x)) = first(&falling) else { panic!() };
        assert!((x - 0.1).abs() < 2e-4);
    }
}
