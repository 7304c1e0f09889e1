//! What the local theory predicts of impact speeds, from the numbers of a grazing's report; and what it says,
//! in words.

use grazing_scenes::{
    local::{Ladder, Plane, Point},
    number::parse_rational,
    word::{Extent, Word},
};
use serde_json::{Value, json};

/// The local map of a report, in its units.
#[derive(Debug, Clone, PartialEq)]
pub struct Local {
    /// A, by rows.
    pub a: Vec<Vec<f64>>,
    /// B.
    pub b: Vec<f64>,
    /// C.
    pub c: Vec<f64>,
    /// a_G.
    pub acceleration: f64,
    /// e.
    pub e: f64,
}

impl Local {
    /// The impact speeds of a pattern per unit of |µ − µ_G| to leading order: V = √(2a_G) |e (µ − µ_G)| |Y|,
    /// where X_{i+1} = A^{n_i} X_i + B Y_i and C X_i = −1 (32), on the side on which the Y are positive. The
    /// i-th is that of the impact before flight i, which ends the flight before it; `None` if the equations
    /// are singular, or if the Y have not one sign: then no orbit is born.
    pub fn speeds(&self, pattern: &[u64]) -> Option<Vec<f64>> {
        let (n, m) = (self.b.len(), pattern.len());
        // Unknowns: X_1, …, X_m, each of n entries, then Y_1, …, Y_m.
        let size = m * (n + 1);
        let mut rows = vec![vec![0.0; size + 1]; size];
        for (i, &period) in pattern.iter().enumerate() {
            let next = (i + 1) % m;
            let power = self.power(period);
            for row in 0..n {
                let equation = &mut rows[i * n + row];
                equation[next * n + row] += 1.0;
                for column in 0..n {
                    equation[i * n + column] -= power[row][column];
                }
                equation[m * n + i] -= self.b[row];
            }
            let equation = &mut rows[m * n + i];
            equation[i * n..(i + 1) * n].copy_from_slice(&self.c);
            equation[size] = -1.0;
        }
        let solution = solve(rows)?;
        let mut y = solution[m * n..].to_vec();
        y.rotate_right(1);
        let one_sign = y.iter().all(|y| *y > 0.0) || y.iter().all(|y| *y < 0.0);
        let scale = (2.0 * self.acceleration).sqrt() * self.e.abs();
        one_sign.then(|| y.iter().map(|y| scale * y.abs()).collect())
    }

    fn power(&self, n: u64) -> Vec<Vec<f64>> {
        let size = self.b.len();
        let unit: Vec<Vec<f64>> =
            (0..size).map(|i| (0..size).map(|j| f64::from(u8::from(i == j))).collect()).collect();
        (0..n).fold(unit, |power, _| {
            let entry = |i: usize, j: usize| (0..size).map(|k| self.a[i][k] * power[k][j]).sum();
            (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
        })
    }
}

/// Gauss's elimination with the largest pivot; each row ends with its right side.
fn solve(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let size = rows.len();
    for i in 0..size {
        let pivot = (i..size).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs()))?;
        rows.swap(i, pivot);
        if rows[i][i].abs() < 1e-300 || !rows[i][i].is_finite() {
            return None;
        }
        let above = rows[i].clone();
        for row in rows.iter_mut().skip(i + 1) {
            let factor = row[i] / above[i];
            row.iter_mut().zip(&above).for_each(|(x, y)| *x -= factor * y);
        }
    }
    let mut found = vec![0.0; size];
    for i in (0..size).rev() {
        let rest: f64 = (i + 1..size).map(|j| rows[i][j] * found[j]).sum();
        found[i] = (rows[i][size] - rest) / rows[i][i];
    }
    found.iter().all(|x| x.is_finite()).then_some(found)
}

/// A number to that many decimals, and however small to at least four digits: 10⁻²⁰ is not 0.
fn digits(x: f64, decimals: usize) -> String {
    let power = if x == 0.0 { 0.0 } else { x.abs().log10().floor() };
    if !(-4.0..9.0).contains(&power) {
        let text = format!("{x:.5e}");
        let (leading, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", leading.trim_end_matches('0').trim_end_matches('.'));
    }
    let text = format!("{x:.0$}", decimals.max((3.0 - power).max(0.0) as usize));
    let trimmed = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    trimmed.to_string()
}

/// What a grazing's report says of one side of the bifurcation.
fn side(row: &Value, born: &[Value], per: &str, most: u64, place: Option<[f64; 2]>) -> String {
    let text = |key: &str| row[key].as_str().unwrap_or_default().to_string();
    let sign = |key: &str| if row[key].as_i64() > Some(0) { '+' } else { '−' };
    let (side, case) = (text("side"), format!("({},{})", sign("sign_emu"), sign("sign_gamma")));
    let periods: Vec<String> = row["periods"]
        .as_array()
        .map_or_else(Vec::new, |all| all.iter().map(|period| period.to_string()).collect());
    let singles: Vec<&str> = born
        .iter()
        .filter(|row| row["side"] == side.as_str())
        .filter_map(|row| row["pattern"].as_str())
        .filter(|pattern| !pattern.contains(','))
        .collect();
    let all = row["all_periods"] == true;
    let born = match (all, singles.as_slice()) {
        (true, _) => "an orbit of every period with one impact".to_string(),
        (_, []) if periods.is_empty() => return format!("{side}, case {case}: no orbit is born."),
        (_, []) => format!("no orbit of a period up to {most} with one impact"),
        (_, [one]) => format!("the orbit of period {one} with one impact (of periods up to {most})"),
        (_, many) => {
            format!("the orbits of periods {} with one impact (of periods up to {most})", many.join(", "))
        }
    };
    let what = match (row["chaos"].as_bool(), row["entropy"].as_str()) {
        (Some(true), Some(entropy)) => {
            let at_least = if row["at_least"] == true { "at least " } else { "" };
            let short = entropy.parse().map_or_else(|_| entropy.to_string(), |rate| digits(rate, 6));
            let apart = if all { "any number of".to_string() } else { periods.join(", ") };
            format!(
                " and with them chaos, impacts being {apart} {per}s apart: entropy {at_least}{short} per {per}"
            )
        }
        (Some(_), _) => ", and no chaos: the patterns born there do not branch".to_string(),
        (None, _) => "; whether chaos is born is not decided".to_string(),
    };
    let word = place.and_then(|place| letters(place, row["sign_emu"].as_i64() > Some(0)));
    let word = word.map_or(String::new(), |word| format!(" The word there is {word}."));
    format!("{side}, case {case}: {born}{what}.{word}")
}

/// The most letters of a word that are shown.
const SHOWN: usize = 12;

/// The letters of the word at (a₁, a₂): the periods that can occur between impacts, from the first on.
fn letters([a1, a2]: [f64; 2], positive: bool) -> Option<String> {
    let exact = |x: f64| parse_rational(&format!("{x:?}")).ok();
    let plane = Plane::new(exact(a1)?, exact(a2)?).ok()?;
    if a2 > 1.0 {
        return None;
    }
    let word = Word::at(&Ladder::new(1024), &Point::Plane(plane), positive, SHOWN, &()).ok()?;
    let letters = word.letters();
    match word.extent() {
        Extent::All | Extent::Odd | Extent::Line => None,
        _ if letters.is_empty() => None,
        _ => Some(if word.is_whole() { letters } else { format!("{letters}…") }),
    }
}

/// What the local theory says of the report of a task of kind `grazing` with patterns up to the period
/// `most`, beside the report's own sentences; empty for one that found nothing.
pub fn sentences(report: &Value, most: u64) -> Vec<String> {
    if !report["parameter"].is_number() {
        return Vec::new();
    }
    let name = report["varied"].as_str().unwrap_or_default();
    let mut all = Vec::new();
    if let (Some(a1), Some(a2)) = (report["a1"].as_f64(), report["a2"].as_f64()) {
        let region = match report["region"].as_str() {
            Some("line") => ", on the line between two regions".to_string(),
            Some(region) => format!(", region {region}"),
            None => String::new(),
        };
        let gamma = report["gamma"]
            .as_f64()
            .map_or(String::new(), |gamma| format!(", γ {} 0", if gamma > 0.0 { '>' } else { '<' }));
        all.push(format!(
            "Over one period, its linear part has a₁ = {}, a₂ = {}{region}{gamma}.",
            digits(a1, 6),
            digits(a2, 6)
        ));
    }
    if let Some(open) = report["open"].as_str() {
        all.push(format!("The local theory is silent: {open}."));
        return all;
    }
    let per = if report["half"] == true { "half period" } else { "period" };
    let empty = Vec::new();
    let born = report["born"].as_array().unwrap_or(&empty);
    let place = report["a1"].as_f64().zip(report["a2"].as_f64()).map(|(a1, a2)| [a1, a2]);
    match report["chaos"].as_array() {
        Some(rows) => all.extend(rows.iter().map(|row| side(row, born, per, most, place))),
        None => {
            let sides: Vec<&Value> = born.iter().filter(|row| !row["coefficient"].is_null()).collect();
            for row in sides {
                let (pattern, side) = (row["pattern"].as_str(), row["side"].as_str());
                all.push(format!(
                    "{}: the orbit ({}) is born.",
                    side.unwrap_or_default(),
                    pattern.unwrap_or_default()
                ));
            }
            if let Some(reason) = report["chaos_open"].as_str() {
                all.push(format!("Chaos is not decided: {reason}."));
            }
        }
    }
    if born.iter().any(|row| !row["coefficient"].is_null()) {
        all.push(format!(
            "Stability: close to the grazing every one of them is unstable. The large multiplier of a pattern with m impacts \
             is L ({name} − its value at the touch)^(−m) to leading order, so it falls as the orbit leaves the grazing; it is a saddle \
             where this is positive, and turns over each round where it is negative."
        ));
    }
    let open = born.iter().filter(|row| row["coefficient"].is_null()).count();
    if open > 0 {
        all.push(format!("{open} of the patterns looked at are open: a sign is too close to zero."));
    }
    all
}

/// What the page links to in the plane: a₁ and a₂ as exact texts; none for machines of several degrees of
/// freedom.
pub fn place(report: &Value) -> Value {
    match (report["a1"].as_f64(), report["a2"].as_f64()) {
        (Some(a1), Some(a2)) => json!({ "a1": format!("{a1:?}"), "a2": format!("{a2:?}") }),
        _ => Value::Null,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_numbers_are_shown() {
        for (x, decimals, text) in [
            (0.0, 4, "0"),
            (1e-20, 9, "1e-20"),
            (-1.25e-7, 4, "-1.25e-7"),
            (0.00021, 4, "0.00021"),
            (-0.05, 9, "-0.05"),
            (0.4803477689, 6, "0.480348"),
            (0.517106781186, 9, "0.517106781"),
            (1200.0, 4, "1200"),
            (3e12, 6, "3e12"),
        ] {
            assert_eq!(digits(x, decimals), text);
        }
    }
}
