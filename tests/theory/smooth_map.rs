//! Theorem 1 against the thing itself: a smooth map g∘f, iterated at small µ. Predicted orbits are found by
//! Newton's method and by iteration, with multipliers that tend to (36); where none is predicted, none is
//! found.

use grazing::pattern::{Analysis, Entry, Map, Numbers, Patterns, Value, predicted_orbit};
use num_rational::BigRational;

type Vector = Vec<f64>;
type Matrix = Vec<Vector>;

/// f = A x + D µ + F (x∘x), h = C x + δ µ + H·(x∘x), b = B + E x + G y.
struct Smooth {
    a: Matrix,
    d: Vector,
    f: Matrix,
    c: Vector,
    delta: f64,
    h: Vector,
    b: Vector,
    e: Matrix,
    g: Vector,
}

/// Small numbers p/16 from a seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 40) % 33) as f64 / 16.0 - 1.0
    }

    fn vector(&mut self, n: usize) -> Vector {
        (0..n).map(|_| self.next()).collect()
    }

    fn matrix(&mut self, n: usize) -> Matrix {
        (0..n).map(|_| self.vector(n)).collect()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn apply(m: &Matrix, v: &[f64]) -> Vector {
    m.iter().map(|row| dot(row, v)).collect()
}

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let column = |j: usize| b.iter().map(|row| row[j]).collect::<Vector>();
    a.iter().map(|row| (0..b[0].len()).map(|j| dot(row, &column(j))).collect()).collect()
}

fn identity(n: usize) -> Matrix {
    (0..n).map(|i| (0..n).map(|j| f64::from(i == j)).collect()).collect()
}

/// Solves a dense system; the last column is the right side.
fn gauss(mut rows: Matrix) -> Vector {
    let n = rows.len();
    for c in 0..n {
        let p = (c..n).max_by(|&i, &j| rows[i][c].abs().total_cmp(&rows[j][c].abs())).unwrap();
        rows.swap(c, p);
        let pivot = rows[c].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != c {
                let factor = row[c] / pivot[c];
                row.iter_mut().zip(&pivot).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

impl Smooth {
    /// Entries are multiples of 1/16, so that the exact map has the very same A, B, C; C B = 0.
    fn random(size: usize, seed: u64) -> Smooth {
        let mut random = Random(seed);
        let mut c = random.vector(size);
        c[0] = 1.0;
        let mut b = random.vector(size);
        b[1] = 1.0;
        b[0] = -dot(&b[1..], &c[1..]);
        Smooth {
            a: random
                .matrix(size)
                .into_iter()
                .map(|row| row.into_iter().map(|x| x * 0.75).collect())
                .collect(),
            d: random.vector(size),
            f: random.matrix(size),
            c,
            delta: random.next(),
            h: random.vector(size),
            b,
            e: random.matrix(size),
            g: random.vector(size),
        }
    }

    fn size(&self) -> usize {
        self.b.len()
    }

    fn f(&self, x: &[f64], mu: f64) -> Vector {
        let squares: Vector = x.iter().map(|x| x * x).collect();
        (0..x.len()).map(|i| dot(&self.a[i], x) + self.d[i] * mu + dot(&self.f[i], &squares)).collect()
    }

    fn df(&self, x: &[f64]) -> Matrix {
        let entry = |i: usize, j: usize| self.a[i][j] + 2.0 * self.f[i][j] * x[j];
        (0..x.len()).map(|i| (0..x.len()).map(|j| entry(i, j)).collect()).collect()
    }

    fn h(&self, x: &[f64], mu: f64) -> f64 {
        let squares: Vector = x.iter().map(|x| x * x).collect();
        dot(&self.c, x) + self.delta * mu + dot(&self.h, &squares)
    }

    fn dh(&self, x: &[f64]) -> Vector {
        (0..x.len()).map(|j| self.c[j] + 2.0 * self.h[j] * x[j]).collect()
    }

    fn b(&self, x: &[f64], y: f64) -> Vector {
        (0..x.len()).map(|i| self.b[i] + dot(&self.e[i], x) + self.g[i] * y).collect()
    }

    /// e = C (I − A)⁻¹ D + δ, (26), and the fixed point's slope.
    fn e(&self) -> (f64, Vector) {
        let rows = (0..self.size())
            .map(|i| (0..self.size()).map(|j| f64::from(i == j) - self.a[i][j]).chain([self.d[i]]).collect())
            .collect();
        let slope = gauss(rows);
        (dot(&self.c, &slope) + self.delta, slope)
    }

    fn exact(&self) -> Option<Map> {
        let number = |x: &f64| Entry::from(BigRational::from_float(*x).unwrap());
        let list = |v: &Vector| v.iter().map(number).collect::<Vec<_>>();
        let e = self.e().0;
        Map::new(self.a.iter().map(list).collect(), list(&self.b), list(&self.c), number(&e), None).ok()
    }

    /// fⁿ(x) and its derivative.
    fn power(&self, x: &[f64], mu: f64, n: u64) -> (Vector, Matrix) {
        (0..n).fold((x.to_vec(), identity(x.len())), |(x, m), _| (self.f(&x, mu), times(&self.df(&x), &m)))
    }

    /// Newton's method on (19) from x_i, y_i; `None` if it does not converge.
    fn newton(&self, periods: &[u64], mu: f64, mut z: Vec<(Vector, f64)>) -> Option<Vec<(Vector, f64)>> {
        let (n, m) = (self.size(), periods.len());
        let width = m * (n + 1);
        for _ in 0..40 {
            let mut rows = vec![vec![0.0; width + 1]; width];
            for i in 0..m {
                let (x, y) = (&z[i].0, z[i].1);
                let (own, next) = (i * (n + 1), (i + 1) % m * (n + 1));
                let (w, dw) = self.power(x, mu, periods[i]);
                let b = self.b(&w, y);
                let dg = times(&self.e, &dw);
                for r in 0..n {
                    rows[own + r][next + r] += 1.0;
                    for k in 0..n {
                        rows[own + r][own + k] -= dw[r][k] + dg[r][k] * y;
                    }
                    rows[own + r][own + n] -= b[r] + self.g[r] * y;
                    rows[own + r][width] = -(z[(i + 1) % m].0[r] - b[r] * y - w[r]);
                }
                let dh = self.dh(&w);
                for k in 0..n {
                    rows[own + n][own + k] = (0..n).map(|r| dh[r] * dw[r][k]).sum();
                }
                rows[own + n][own + n] = 2.0 * y;
                rows[own + n][width] = -(self.h(&w, mu) + y * y);
            }
            let step = gauss(rows);
            let mut size: f64 = 0.0;
            for (i, (x, y)) in z.iter_mut().enumerate() {
                x.iter_mut().zip(&step[i * (n + 1)..]).for_each(|(x, s)| *x += s);
                *y += step[i * (n + 1) + n];
                size = step[i * (n + 1)..][..=n].iter().fold(size, |m, s| m.max(s.abs()));
            }
            if size.is_nan() || size >= 1.0 {
                return None;
            }
            // Steps shrink quadratically until round-off, which h ≈ −y² ends some digits early.
            let scale = z.iter().flat_map(|(x, y)| x.iter().chain([y])).fold(0.0f64, |m, v| m.max(v.abs()));
            if size < 1e-7 * scale {
                return Some(z);
            }
        }
        None
    }

    /// (20) and (21).
    fn is_admissible(&self, periods: &[u64], mu: f64, z: &[(Vector, f64)]) -> bool {
        z.iter()
            .zip(periods)
            .all(|((x, y), &n)| *y > 0.0 && (1..n).all(|k| self.h(&self.power(x, mu, k).0, mu) > 0.0))
    }

    /// The map g∘f and whether it impacted.
    fn step(&self, x: &[f64], mu: f64) -> (Vector, bool) {
        let w = self.f(x, mu);
        let h = self.h(&w, mu);
        if h >= 0.0 {
            return (w, false);
        }
        let y = (-h).sqrt();
        let b = self.b(&w, y);
        (w.iter().zip(b).map(|(w, b)| w + b * y).collect(), true)
    }

    /// The eigenvalue of largest modulus of (22), by powers.
    fn multiplier(&self, periods: &[u64], mu: f64, z: &[(Vector, f64)]) -> f64 {
        let n = self.size();
        let mut v: Vector = (0..n).map(|i| 1.0 + i as f64 / 7.0).collect();
        let mut value = 0.0;
        for _ in 0..60 {
            for ((x, y), &k) in z.iter().zip(periods) {
                let (w, dw) = self.power(x, mu, k);
                let through = apply(&dw, &v);
                let b = self.b(&w, *y);
                let push = dot(&self.dh(&w), &through) / 2.0;
                let shear = apply(&self.e, &through);
                v = (0..n).map(|i| through[i] - (b[i] / y + self.g[i]) * push + shear[i] * y).collect();
            }
            let (index, _) = v.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap();
            value = v[index];
            v.iter_mut().for_each(|x| *x /= value);
        }
        value
    }
}

fn middle(value: &Value) -> f64 {
    let x = value.enclosure();
    (x.lo() + x.hi()) / 2.0
}

#[test]
fn predicted_orbits_are_there_and_no_others() {
    let (mut orbits, mut absent, mut found, mut strays) = (0, 0, 0, 0);
    for seed in 0..24 {
        let size = 2 + seed as usize % 3;
        let smooth = Smooth::random(size, seed);
        let (e, slope) = smooth.e();
        let Some(map) = smooth.exact().filter(|_| e.abs() > 0.05) else { continue };
        let analysis = Analysis::new(&map, 4, Numbers::Enclosed);
        let mut random = Random(seed + 1000);
        for pattern in (1..=4).flat_map(Patterns::of_period).filter(|p| p.is_primitive()) {
            let periods = pattern.periods();
            let report = analysis.judge(periods);
            let Some(orbit) = &report.orbit else { continue };
            // Small µ means small beside the margins: leave out what is close to a boundary, or large.
            let numbers = orbit.x.iter().flatten().chain(&orbit.y).map(|v| middle(v).abs());
            let values =
                orbit.gaps.iter().flatten().chain(&orbit.impacts).chain(&orbit.y).map(|v| middle(v).abs());
            if report.is_open() || numbers.fold(0.0, f64::max) > 20.0 || values.fold(1.0, f64::min) < 0.02 {
                continue;
            }
            for positive in [true, false] {
                let expected = report.side() == Some(positive);
                let mut ratios = Vec::new();
                for size_emu in [1e-5, 1e-6] {
                    let emu = if positive { size_emu } else { -size_emu };
                    let mu = emu / e;
                    let start: Vec<(Vector, f64)> = orbit
                        .x
                        .iter()
                        .zip(&orbit.y)
                        .map(|(x, y)| {
                            (
                                x.iter().zip(&slope).map(|(x, s)| s * mu + emu * middle(x)).collect(),
                                emu * middle(y),
                            )
                        })
                        .collect();
                    // The smooth continuation of the leading-order solution always solves (19); is it an
                    // orbit?
                    let z = smooth
                        .newton(periods, mu, start.clone())
                        .unwrap_or_else(|| panic!("seed {seed} ({pattern}): a regular solution continues"));
                    assert_eq!(
                        smooth.is_admissible(periods, mu, &z),
                        expected,
                        "seed {seed} ({pattern}) {positive}"
                    );
                    let scale = |v: f64| v / size_emu;
                    for ((x, y), (x0, y0)) in z.iter().zip(&start) {
                        let far = x
                            .iter()
                            .zip(x0)
                            .map(|(a, b)| scale(a - b).abs())
                            .fold(scale(y - y0).abs(), f64::max);
                        assert!(far < 3e6 * size_emu, "seed {seed} ({pattern}): {far} away");
                    }
                    if expected {
                        // By iteration, from impact to impact (over a period the multiplier would swamp every
                        // digit): impacts come just where the pattern has them, and lead to the next point.
                        for (i, &n) in periods.iter().enumerate() {
                            let mut x = z[i].0.clone();
                            for k in 1..=n {
                                let (next, impact) = smooth.step(&x, mu);
                                assert_eq!(impact, k == n, "seed {seed} ({pattern}) impact {i}, iterate {k}");
                                x = next;
                            }
                            let next = &z[(i + 1) % z.len()].0;
                            assert!(
                                x.iter().zip(next).all(|(a, b)| scale(a - b).abs() < 1e-4),
                                "seed {seed} ({pattern})"
                            );
                        }
                        let leading = middle(orbit.leading.as_ref().unwrap());
                        let predicted = leading / emu.powi(periods.len() as i32);
                        assert_eq!(
                            orbit.eigenvalue_sign(positive).map(|s| s == grazing::number::Sign::Positive),
                            Some(predicted > 0.0)
                        );
                        if leading.abs() > 1e-3 {
                            ratios.push((smooth.multiplier(periods, mu, &z) / predicted - 1.0).abs());
                        }
                        orbits += 1;
                    } else {
                        absent += 1;
                    }
                }
                if let [far, near] = ratios[..] {
                    assert!(near < 0.1 && near < 0.3 * far + 1e-3, "seed {seed} ({pattern}): {ratios:?}");
                    found += 1;
                }
                // Newton from anywhere near: the one solution, or none that is an orbit.
                let emu = if positive { 1e-5 } else { -1e-5 };
                let mu = emu / e;
                for _ in 0..8 {
                    let start = periods
                        .iter()
                        .map(|_| {
                            (
                                random.vector(size).iter().map(|x| x * 2e-5).collect(),
                                (random.next() + 1.1) * 1e-5,
                            )
                        })
                        .collect();
                    let Some(z) = smooth.newton(periods, mu, start) else { continue };
                    let near = z.iter().all(|(x, y)| x.iter().chain([y]).all(|v| v.abs() < 1e-3));
                    if near && smooth.is_admissible(periods, mu, &z) {
                        assert!(
                            expected,
                            "seed {seed} ({pattern}) {positive}: an orbit that was not predicted"
                        );
                        strays += 1;
                    }
                }
            }
        }
    }
    assert!(orbits > 50 && absent > 200 && found > 20 && strays > 50, "{orbits} {absent} {found} {strays}");
}

/// The points drawn are those of the orbit, to first order in µ.
#[test]
fn drawn_orbits_are_those_of_the_map() {
    let smooth = (0..40).map(|seed| Smooth::random(3, seed)).find_map(|smooth| {
        let map = smooth.exact()?;
        let side = Analysis::new(&map, 3, Numbers::Enclosed).judge(&[1, 2]).side()?;
        Some((smooth, map, side))
    });
    let (smooth, map, side) = smooth.unwrap();
    let (e, slope) = smooth.e();
    let size_emu: f64 = 1e-7;
    let mu = if side { size_emu / e } else { -size_emu / e };
    let points = predicted_orbit(&map, &[1, 2], side).unwrap();
    let place = |x: &[Value]| -> Vector {
        x.iter().zip(&slope).map(|(x, s)| s * mu + size_emu * middle(x)).collect()
    };
    for pair in points.windows(2).filter(|pair| pair[1].k > 0) {
        let image = smooth.f(&place(&pair[0].x), mu);
        let far = image.iter().zip(place(&pair[1].x)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(far < 1e-4 * size_emu);
        let gap = smooth.h(&place(&pair[1].x), mu) / size_emu;
        assert!((gap - middle(&pair[1].gap)).abs() < 1e-4);
    }
}
