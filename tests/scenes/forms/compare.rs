//! Whether two answers agree: words exactly, numbers to a tolerance that follows from their condition.
//!
//! A form is another way to the same numbers, whose rounding (or whose integrator) acts as a small change of
//! the scene's coefficients would. How far such a change moves each number is computed, not guessed: the
//! scene is run again with all coefficients changed at random by a part δ. A number may differ from the
//! scene's by [`MARGIN`] times what the largest of these changes made of it, and by δ of the size of such
//! numbers. What such a change turns over (a word, a count, the rows of a table) is not decided to δ: it is
//! counted as such, and not compared. Where the other way is exact, δ is 0 and there is no tolerance.
//!
//! One thing no change of coefficients does: rounding moves a body at each impact by itself. A place that is
//! off by δS, S being the size of the motion, is an impact of speed v that is δS/v early, and so slower by
//! δV V/v, V being the speed that the motion's forces give a body over S. In a chatter, whose impacts all
//! changes move alike, that is all that moves them. So of the times and speeds of a motion's events δ is V/v
//! times as large, until it rests ([`slowness`]), and of what is added up over them as large as it ever is.

use std::collections::BTreeMap;

use super::{
    report::{Answer, Cell, Impact, Row},
    scene::Unit,
};

/// How much more than the largest of some random changes a change of the same size may move a number.
const MARGIN: f64 = 8.0;

/// Beside the size of such numbers: what is allowed to differ by more says nothing.
const VOID: f64 = 1e-3;

/// A column that differs.
#[derive(Debug, Clone)]
pub struct Difference {
    pub task: String,
    pub column: String,
    pub what: String,
}

/// What was compared.
#[derive(Debug, Clone, Copy, Default)]
pub struct Count {
    /// Numbers and words that were compared.
    pub compared: usize,
    /// Those that changes by δ turn over.
    pub undecided: usize,
    /// Rows of a motion that is settled on one side only: the scene does not tell how long a transient is.
    pub open: usize,
    /// Tasks that are not compared as their search found another number of orbits.
    pub searches: usize,
    /// Tasks that were asked again with more changes, as they differed by more than a few made of them.
    pub again: usize,
}

impl Count {
    pub fn add(&mut self, other: Count) {
        self.compared += other.compared;
        self.undecided += other.undecided;
        self.open += other.open;
        self.searches += other.searches;
        self.again += other.again;
    }
}

/// How well the numbers of a task are determined.
pub struct Condition<'a> {
    pub answer: &'a Answer,
    /// With coefficients changed by parts up to `delta`.
    pub changed: Vec<&'a Answer>,
    pub delta: f64,
    /// Whether only columns are compared that both have.
    pub common: bool,
    /// The size of numbers by their units.
    pub sizes: &'a BTreeMap<Unit, f64>,
}

/// The size of numbers of each unit in some answers.
pub fn sizes<'a>(answers: impl Iterator<Item = &'a Answer>) -> BTreeMap<Unit, f64> {
    let mut sizes = BTreeMap::new();
    for cell in answers.flat_map(Answer::values).flatten().flat_map(Row::values) {
        if let Cell::Number(x, unit) = cell
            && x.is_finite()
        {
            let size: &mut f64 = sizes.entry(*unit).or_insert(0.0);
            *size = size.max(x.abs());
        }
    }
    sizes
}

/// How far apart two cells are: none for other words; numbers in what they are made of.
fn apart(a: &Cell, b: &Cell) -> Option<Vec<f64>> {
    match (a, b) {
        (Cell::Number(a, _), Cell::Number(b, _)) if a == b => Some(vec![0.0]),
        (Cell::Number(a, _), Cell::Number(b, _)) => Some(vec![(a - b).abs()]).filter(|_| !(a - b).is_nan()),
        (Cell::Phase(a), Cell::Phase(b)) => Some(vec![circular(*a, *b)]),
        (Cell::Word(a), Cell::Word(b)) => (a == b).then(Vec::new),
        (Cell::Multipliers(a), Cell::Multipliers(b)) => multipliers(a, b),
        (Cell::Impacts(a), Cell::Impacts(b)) => impacts(a, b),
        _ => None,
    }
}

fn circular(a: f64, b: f64) -> f64 {
    let x = (a - b).rem_euclid(1.0);
    x.min(1.0 - x)
}

/// Of two their sum and product, which are smooth where they are double; of more each from its nearest.
fn multipliers(a: &[[f64; 2]], b: &[[f64; 2]]) -> Option<Vec<f64>> {
    if let ([a, c], [b, d]) = (a, b) {
        let sum = ((a[0] + c[0]) - (b[0] + d[0])).abs();
        let product = |x: &[f64; 2], y: &[f64; 2]| x[0] * y[0] - x[1] * y[1];
        return Some(vec![sum, (product(a, c) - product(b, d)).abs()]);
    }
    let mut left = b.to_vec();
    let mut all = Vec::new();
    for x in a.iter().take(b.len()) {
        let far = |y: &[f64; 2]| (x[0] - y[0]).hypot(x[1] - y[1]);
        let i = (0..left.len()).min_by(|&i, &j| far(&left[i]).total_cmp(&far(&left[j])))?;
        all.push(far(&left.remove(i)));
    }
    Some(all)
}

/// From the impact of b that fits the first of a best.
fn impacts(a: &[Impact], b: &[Impact]) -> Option<Vec<f64>> {
    if a.len() != b.len() {
        return None;
    }
    let turned = |by: usize| -> Option<Vec<f64>> {
        let mut all = Vec::new();
        for (i, x) in a.iter().enumerate() {
            let y = &b[(i + by) % b.len()];
            if x.wall != y.wall {
                return None;
            }
            all.extend([circular(x.phase, y.phase), (x.flight - y.flight).abs(), (x.speed - y.speed).abs()]);
        }
        Some(all)
    };
    let turns: Vec<Vec<f64>> = (0..a.len().max(1)).filter_map(turned).collect();
    turns.into_iter().min_by(|x, y| x.iter().sum::<f64>().total_cmp(&y.iter().sum()))
}

/// The size of what a cell is made of, beside which rounding is δ.
fn size(cell: &Cell, sizes: &BTreeMap<Unit, f64>) -> f64 {
    match cell {
        Cell::Number(x, unit) => x.abs().max(sizes.get(unit).copied().unwrap_or(0.0)),
        Cell::Multipliers(all) => all.iter().fold(1.0, |most, [x, y]| f64::max(most, x.hypot(*y))),
        Cell::Impacts(all) => all.iter().fold(1.0, |most, impact| f64::max(most, impact.speed)),
        Cell::Phase(_) | Cell::Word(_) => 1.0,
    }
}

/// How much two rows are unlike: for telling which rows are one.
fn unlike(a: &Row, b: &Row) -> f64 {
    let cells = a.iter().map(|(name, a)| match b.get(name).and_then(|b| apart(a, b)) {
        None => 10.0,
        Some(all) => {
            let far = all.iter().copied().fold(0.0, f64::max);
            (far / (size(a, &BTreeMap::new()) + far)).min(1.0)
        }
    });
    cells.map(|x| if x.is_nan() { 0.0 } else { x }).sum()
}

/// For each row of a the row of b that is it: the most alike pairs first.
fn matched(a: &[Row], b: &[Row]) -> Vec<Option<usize>> {
    let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
    // Samples and events are in the order of time.
    let in_order = a.first().is_some_and(|row| row.contains_key("time"));
    if a.len() == b.len() && (a.len() == 1 || a.len() > 200 || in_order) {
        return (0..a.len()).map(Some).collect();
    }
    for (i, x) in a.iter().enumerate() {
        pairs.extend(b.iter().enumerate().map(|(j, y)| (unlike(x, y), i, j)));
    }
    pairs.sort_by(|x, y| x.partial_cmp(y).expect("no NaN"));
    let (mut found, mut taken) = (vec![None; a.len()], vec![false; b.len()]);
    for (_, i, j) in pairs {
        if found[i].is_none() && !taken[j] {
            (found[i], taken[j]) = (Some(j), true);
        }
    }
    found
}

impl Condition<'_> {
    /// What of a form's answer differs.
    pub fn differences(&self, task: &str, form: &Answer, count: &mut Count) -> Vec<Difference> {
        let mut all = Vec::new();
        let mut say = |column: String, what: String| {
            all.push(Difference { task: task.to_string(), column, what });
        };
        let events = self.answer.get("events").map_or(&[][..], Vec::as_slice);
        let slowest = slowness("events", events, self.sizes).into_iter().fold(1.0, f64::max);
        for (table, rows) in self.answer {
            let changed: Vec<&[Row]> =
                self.changed.iter().map(|answer| answer.get(table).map_or(&[][..], Vec::as_slice)).collect();
            let Some(others) = form.get(table) else {
                // A table without rows is one that is not there.
                if !self.common && !rows.is_empty() && changed.iter().all(|all| all.len() == rows.len()) {
                    say(table.clone(), "is not there".into());
                }
                continue;
            };
            if changed.iter().any(|all| all.len() != rows.len()) {
                count.undecided += 1;
                continue;
            }
            if rows.len() != others.len() {
                say(table.clone(), format!("{} rows for {}", others.len(), rows.len()));
                continue;
            }
            let (places, slowness) = (matched(rows, others), slowness(table, rows, self.sizes));
            let changed: Vec<(&[Row], Vec<Option<usize>>)> =
                changed.into_iter().map(|all| (all, matched(rows, all))).collect();
            for (i, row) in rows.iter().enumerate() {
                let Some(other) = places[i].map(|j| &others[j]) else { continue };
                if is_open(row) != is_open(other) {
                    count.open += 1;
                    continue;
                }
                let like: Vec<&Row> =
                    changed.iter().filter_map(|(all, places)| Some(&all[places[i]?])).collect();
                for (name, cell) in row.iter().filter(|(name, _)| {
                    !self.common || !is_null(other.get(*name)) && other.contains_key(*name)
                }) {
                    let column = format!("{table}[{i}].{name}");
                    let added_up = ["stops", "friction", "wear"].contains(&&**table);
                    let floor = self.delta * if added_up { slowest } else { slowness[i] };
                    match self.cell(cell, other.get(name), &like, (name, floor)) {
                        Judged::Same => count.compared += 1,
                        Judged::Undecided => count.undecided += 1,
                        Judged::Other(what) => say(column, what),
                    }
                }
                for name in other.keys().filter(|name| !self.common && !row.contains_key(*name)) {
                    if like.iter().all(|row| !row.contains_key(name)) && !is_null(other.get(name)) {
                        say(format!("{table}[{i}].{name}"), format!("{:?} for nothing", other[name]));
                    }
                }
            }
        }
        all
    }

    fn cell(&self, cell: &Cell, other: Option<&Cell>, like: &[&Row], (name, delta): (&str, f64)) -> Judged {
        // How far changes move it, each part apart.
        let mut moved: Vec<f64> = Vec::new();
        for changed in like {
            match changed.get(name).and_then(|changed| apart(cell, changed)) {
                None => return Judged::Undecided,
                Some(all) => {
                    moved.resize(all.len().max(moved.len()), 0.0);
                    moved.iter_mut().zip(all).for_each(|(most, x)| *most = most.max(x));
                }
            }
        }
        let other = match other {
            Some(other) => other,
            None if is_null(Some(cell)) => return Judged::Same,
            None => return Judged::Other(format!("nothing for {cell:?}")),
        };
        let Some(far) = apart(cell, other) else { return Judged::Other(format!("{other:?} for {cell:?}")) };
        let size = size(cell, self.sizes);
        // At a fade a multiplier is the inverse of a speed that is 0 to rounding.
        if matches!(cell, Cell::Multipliers(_)) && self.delta * size > 1.0 {
            return Judged::Undecided;
        }
        for (i, x) in far.into_iter().enumerate() {
            // An eigenvalue is known to δ of the largest, and so a product to δ of its square.
            let product = matches!(cell, Cell::Multipliers(all) if all.len() == 2) && i == 1;
            let floor = delta * size * if product { size } else { 1.0 };
            let allowed = MARGIN * moved.get(i).copied().unwrap_or(0.0) + floor;
            if allowed > VOID * size * if product { size } else { 1.0 } {
                return Judged::Undecided;
            }
            let allowed = if self.delta == 0.0 { 0.0 } else { allowed };
            if x > allowed {
                return Judged::Other(format!("{other:?} for {cell:?}: by {x:.2e}, allowed {allowed:.2e}"));
            }
        }
        Judged::Same
    }
}

/// For each event of a motion, how many times slower than the fastest the slowest impact is since the body
/// rested: it forgets when it came to rest. 1 of anything else.
fn slowness(table: &str, rows: &[Row], sizes: &BTreeMap<Unit, f64>) -> Vec<f64> {
    let mut slow = 1.0;
    let one = |row: &Row| {
        if let ("events", Some(Cell::Number(speed, unit))) = (table, row.get("speed")) {
            let most = sizes.get(unit).copied().unwrap_or(0.0);
            slow = if *speed == 0.0 { slow } else { f64::max(slow, most / speed.abs()) };
        }
        let here = slow;
        if matches!(row.get("event"), Some(Cell::Word(word)) if word.starts_with("stick wall")) {
            slow = 1.0;
        }
        here
    };
    rows.iter().map(one).collect()
}

/// Whether a row is of a motion that is not settled.
fn is_open(row: &Row) -> bool {
    row.iter().any(|(name, cell)| {
        matches!(cell, Cell::Word(word) if word.starts_with("not-settled") || name == "periodic" && word == "null")
    })
}

enum Judged {
    Same,
    Undecided,
    Other(String),
}

/// A column that one format does not have and the other leaves empty.
fn is_null(cell: Option<&Cell>) -> bool {
    matches!(cell, Some(Cell::Word(word)) if word == "null")
}
