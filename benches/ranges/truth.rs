//! The truth, followed in floats by other formulas than the library's: periodic words, from the touch to
//! where they are no motions or no longer alone.

use grazing_scenes::search::chaos::LetterGraph;

/// The most impacts of a word, and how many words are followed.
const IMPACTS: usize = 6;
const WORDS: usize = 100;

/// The oscillator in floats: q'' = -c q' - k q above the wall σν - 1 + cos t, underdamped.
pub struct Floats {
    pub c: f64,
    pub k: f64,
    pub tau: f64,
    pub side: f64,
}

impl Floats {
    /// E(T), by rows.
    pub fn flow(&self, time: f64) -> [f64; 4] {
        let (half, rate) = (self.c / 2.0, (self.k - self.c * self.c / 4.0).sqrt());
        let (left, (sin, cos)) = ((-half * time).exp(), (rate * time).sin_cos());
        let b = left * sin / rate;
        [left * cos + half * b, b, -self.k * b, left * cos - half * b]
    }

    fn phase(&self, depth: f64, s: f64) -> f64 {
        -(depth * s / 2.0).asin()
    }

    /// The wall over ν at a phase.
    fn place(&self, depth: f64, t: f64) -> f64 {
        self.side - 2.0 * (t / 2.0).sin().powi(2) / depth
    }

    /// The first and the last velocity of a leg, over ν.
    fn leg(&self, depth: f64, n: u64, from: f64, to: f64) -> [f64; 2] {
        let [t, u] = [from, to].map(|s| self.phase(depth, s));
        let [e11, e12, e21, e22] = self.flow(std::f64::consts::TAU * n as f64 + u - t);
        let a = (self.place(depth, u) - e11 * self.place(depth, t)) / e12;
        [a, e21 * self.place(depth, t) + e22 * a]
    }

    /// s - 2 (a + τ p)/(1 + τ), around a word.
    fn law(&self, depth: f64, word: &[u64], s: &[f64]) -> Vec<f64> {
        let m = word.len();
        let legs: Vec<[f64; 2]> = (0..m).map(|i| self.leg(depth, word[i], s[i], s[(i + 1) % m])).collect();
        let strength = |i: usize| 2.0 * (legs[i][0] + self.tau * legs[(i + m - 1) % m][1]) / (1.0 + self.tau);
        (0..m).map(|i| s[i] - strength(i)).collect()
    }

    /// Newton's method; with the determinant's sign at the end.
    fn solve(&self, depth: f64, word: &[u64], start: &[f64]) -> Option<(Vec<f64>, f64)> {
        let mut s = start.to_vec();
        for _ in 0..12 {
            let law = self.law(depth, word, &s);
            let mut rows: Vec<Vec<f64>> = vec![Vec::new(); s.len()];
            for j in 0..s.len() {
                let step = 1e-6 * (1.0 + s[j].abs());
                let at = |by: f64| {
                    let mut moved = s.clone();
                    moved[j] += by;
                    self.law(depth, word, &moved)
                };
                let (above, below) = (at(step), at(-step));
                rows.iter_mut()
                    .enumerate()
                    .for_each(|(i, row)| row.push((above[i] - below[i]) / (2.0 * step)));
            }
            let (change, sign) = eliminate(rows, law)?;
            s.iter_mut().zip(&change).for_each(|(s, by)| *s -= by);
            let size = s.iter().fold(1.0, |most: f64, s| most.max(s.abs()));
            if s.iter().any(|s| !s.is_finite()) {
                return None;
            }
            if change.iter().all(|by| by.abs() < 1e-9 * size) {
                return Some((s, sign));
            }
        }
        None
    }

    /// What is wrong with a solution, if it is no motion.
    fn fault(&self, depth: f64, word: &[u64], s: &[f64]) -> Option<&'static str> {
        let m = word.len();
        for i in 0..m {
            let (from, to) = (s[i], s[(i + 1) % m]);
            let [a, p] = self.leg(depth, word[i], from, to);
            if a <= from / 2.0 || p >= to / 2.0 {
                return Some("speed 0");
            }
            let [t, u] = [from, to].map(|s| self.phase(depth, s));
            let time = std::f64::consts::TAU * word[i] as f64 + u - t;
            let steps = 24 * word[i];
            let open = (1..steps).all(|j| {
                let after = time * j as f64 / steps as f64;
                let [e11, e12, ..] = self.flow(after);
                let q = e11 * self.place(depth, t) + e12 * a;
                q > self.place(depth, t + after)
            });
            if !open {
                return Some("touch");
            }
        }
        None
    }

    /// To which depth a word is a motion, alone, and what ends it.
    pub fn end(&self, word: &[u64], deepest: f64) -> (f64, &'static str) {
        let zeros = vec![0.0; word.len()];
        let (mut depth, mut step) = (1e-10, 1.1);
        let start: Vec<f64> = self.law(depth, word, &zeros).iter().map(|x| -x).collect();
        let Some((mut s, first)) = self.solve(depth, word, &start) else { return (0.0, "fold") };
        if let Some(fault) = self.fault(depth, word, &s) {
            return (0.0, fault);
        }
        let mut reason = "fold";
        while step > 1.00003 {
            if depth >= deepest {
                return (deepest, "asked");
            }
            let next = (depth * step).min(deepest);
            let found = match self.solve(next, word, &s) {
                None => Err("fold"),
                Some((there, _))
                    if there.iter().zip(&s).any(|(a, b)| (a - b).abs() > 0.3 * (1.0 + b.abs())) =>
                {
                    Err("fold")
                }
                Some((_, sign)) if sign != first => Err("fold or flip"),
                Some((there, _)) => self.fault(next, word, &there).map_or(Ok(there), Err),
            };
            match found {
                Ok(there) => (s, depth) = (there, next),
                Err(why) => {
                    reason = why;
                    step = step.sqrt();
                }
            }
        }
        (depth, reason)
    }
}

/// The solution of a linear system, and the sign of its determinant.
fn eliminate(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<(Vec<f64>, f64)> {
    let n = right.len();
    let mut sign = 1.0;
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs()))?;
        if rows[pivot][i] == 0.0 || !rows[pivot][i].is_finite() {
            return None;
        }
        if pivot != i {
            rows.swap(pivot, i);
            right.swap(pivot, i);
            sign = -sign;
        }
        sign *= rows[i][i].signum();
        for j in i + 1..n {
            let factor = rows[j][i] / rows[i][i];
            let (above, below) = rows.split_at_mut(j);
            below[0][i..].iter_mut().zip(&above[i][i..]).for_each(|(x, y)| *x -= factor * y);
            right[j] -= factor * right[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| rows[i][j] * right[j]).sum();
        right[i] = (right[i] - known) / rows[i][i];
    }
    Some((right, sign))
}

/// Closed paths of up to so many letters, each once, and the periods along them.
pub fn words(graph: &LetterGraph) -> Vec<Vec<u64>> {
    let mut all = Vec::new();
    let mut paths: Vec<Vec<usize>> = (0..graph.letters.len()).map(|v| vec![v]).collect();
    for _ in 0..IMPACTS {
        for path in &paths {
            let turned = (1..path.len()).map(|i| [&path[i..], &path[..i]].concat());
            if graph.next[path[path.len() - 1]].contains(&path[0])
                && turned.min().is_none_or(|least| *path <= least)
            {
                all.push(path.iter().map(|&v| graph.letters[v]).collect());
            }
        }
        if all.len() >= WORDS {
            break;
        }
        let longer = |path: &Vec<usize>| {
            let next = &graph.next[path[path.len() - 1]];
            next.iter().map(|&v| [path.clone(), vec![v]].concat()).collect::<Vec<_>>()
        };
        paths = paths.iter().flat_map(longer).collect();
    }
    all.truncate(WORDS);
    all
}
