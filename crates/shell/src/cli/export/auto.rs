//! Files of AUTO-07p: a bifurcation diagram `b.NAME`, and a motion `NAME.dat` to start from.
//!
//! Of `b.NAME` each branch is a header, of lines that begin with 0, and a line per point: the number of the
//! branch, that of the point (negative where it is stable), the type of the label and its number, and columns
//! of numbers as wide as one another. The orbits themselves, AUTO's `s.NAME`, are not written: they are not
//! smooth at impacts, where AUTO has a collocation polynomial.

use std::fmt::Write;

use super::table::{Column, Table, Values};
use crate::error::{Error, Result};

/// How wide a number is.
const WIDE: usize = 25;

/// AUTO's number for what happens at a label: a user's point for what it does not know.
fn kind(label: &str) -> i32 {
    match label.rsplit_once(' ').map_or(label, |(kind, _)| kind) {
        "saddle-node" => 5,
        "crossing" => 6,
        "flip" => 7,
        "neimark-sacker" => 8,
        "1:1-resonance" => -5,
        "1:2-resonance" => -6,
        "1:3-resonance" => -7,
        "1:4-resonance" => -8,
        "fold-flip" => 28,
        "fold-neimark-sacker" => 23,
        "flip-neimark-sacker" => 77,
        "double-neimark-sacker" => 88,
        _ => -4,
    }
}

/// A beginning or an end of a branch.
const END: i32 = 9;

/// A number as Fortran sets it.
fn fortran(x: f64) -> String {
    let text = format!("{x:.16E}");
    let Some((digits, exponent)) = text.split_once('E') else { return format!("{x:>WIDE$}") };
    let (sign, power) = exponent.strip_prefix('-').map_or(('+', exponent), |power| ('-', power));
    format!("{:>WIDE$}", format!("{digits}E{sign}{power:0>2}"))
}

/// Columns of numbers: the name in AUTO, the column, which of its numbers, and whether its imaginary part.
type Numbers<'a> = Vec<(String, &'a Column, usize, bool)>;

fn numbers<'a>(table: &'a Table, name: &str, shown: impl Fn(usize) -> String) -> Numbers<'a> {
    let Some(column) = table.column(name) else { return Vec::new() };
    let Values::Numbers { width, .. } = column.values else { return Vec::new() };
    let one = |i: usize| {
        let im = column.is_complex().then(|| (format!("Im {}", shown(i + 1)), column, i, true));
        [Some((shown(i + 1), column, i, false)), im]
    };
    (0..width).flat_map(one).flatten().collect()
}

fn value(column: &Column, row: usize, at: usize, imaginary: bool) -> f64 {
    let Values::Numbers { rows, .. } = &column.values else { return f64::NAN };
    let (re, im) = rows[row][at];
    if imaginary { im } else { re }
}

/// The points of branches as a bifurcation diagram.
///
/// # Errors
/// An input error for a table that is none of points of branches.
pub(super) fn branches(table: &Table) -> Result<Vec<u8>> {
    let no_points =
        || Error::input("no points of branches: b.NAME is written from NAME-points.csv of a task `branch`");
    let [branch, label, stable] = ["branch", "label", "stable"].map(|name| table.column(name));
    let (Some(branch), Some(label), Some(stable)) = (branch, label, stable) else { return Err(no_points()) };
    let mut columns = numbers(table, "parameters", |i| format!("PAR({i})"));
    if columns.is_empty() {
        return Err(no_points());
    }
    columns.extend(numbers(table, "speeds", |i| format!("V({i})")));
    columns.extend(numbers(table, "phases", |i| format!("T({i})")));
    columns.extend(numbers(table, "multipliers", |i| format!("MULT({i})")));
    columns.extend(numbers(table, "length", |_| "LENGTH".into()));
    let mut text = String::new();
    let of = |row: &usize| value(branch, *row, 0, false);
    let rows: Vec<usize> = (0..table.rows).collect();
    let mut labels = 0;
    for part in rows.chunk_by(|one, other| of(one) == of(other)) {
        let parameter = |row: usize| value(columns[0].1, row, 0, false);
        let [low, high] = [f64::min, f64::max]
            .map(|pick| part.iter().map(|&row| parameter(row)).fold(parameter(part[0]), pick));
        let _ = writeln!(text, "   0{}{}{}{}", fortran(low), fortran(high), fortran(0.0), fortran(0.0));
        let names: String = columns.iter().map(|(name, ..)| format!("{name:<WIDE$}")).collect();
        let _ = writeln!(text, "   0    PT  TY  LAB {}", names.trim_end());
        for (&row, number) in part.iter().zip(1i64..) {
            let ends = row == part[0] || row == part[part.len() - 1];
            let what = match label.text(row) {
                "" if ends => END,
                "" => 0,
                label => kind(label),
            };
            labels += i64::from(what != 0);
            let (lab, sign) =
                (if what == 0 { 0 } else { labels }, if stable.text(row) == "yes" { -1 } else { 1 });
            // AUTO counts points up to 9999 and begins anew.
            let point = sign * ((number - 1) % 9999 + 1);
            let _ = write!(text, "{:>4}{point:>6}{what:>4}{lab:>5}", of(&row));
            columns.iter().for_each(|&(_, column, at, imaginary)| {
                text.push_str(&fortran(value(column, row, at, imaginary)));
            });
            text.push('\n');
        }
    }
    Ok(text.into_bytes())
}

/// Time, displacements and velocities of a motion.
///
/// # Errors
/// An input error for a table that is none of a motion.
pub(super) fn motion(table: &Table) -> Result<Vec<u8>> {
    let coordinate = |name: &str, letter: char| {
        name.strip_prefix(letter).is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let state = |letter| table.columns.iter().filter(move |column| coordinate(&column.name, letter));
    let columns: Vec<&Column> =
        table.column("time").into_iter().chain(state('q')).chain(state('u')).collect();
    if columns.len() < 3 || table.column("time").is_none() {
        return Err(Error::input("no motion: NAME.dat is written from NAME.csv of a task `simulate`"));
    }
    let mut text = String::new();
    for row in 0..table.rows {
        columns.iter().for_each(|column| text.push_str(&fortran(value(column, row, 0, false))));
        text.push('\n');
    }
    Ok(text.into_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_fortrans() {
        for (x, text) in [
            (0.0, "0.0000000000000000E+00"),
            (-1.5e-3, "-1.5000000000000000E-03"),
            (1e100, "1.0000000000000000E+100"),
        ] {
            assert_eq!(fortran(x).trim(), text);
            assert_eq!(fortran(x).len(), WIDE);
        }
    }

    /// The columns stand where AUTO's reader looks for them: numbers of one width after 19 characters, names
    /// after 20; stable points are negative, and labels have AUTO's numbers.
    #[test]
    fn a_branch_is_a_header_and_its_points() {
        let text = "branch,label,parameters,speeds,multipliers,stable\n\
            1,,0.1,1.0,\"0.5, 0.25\",yes\n1,flip 1,0.2,1.0,\"-1.0, 0.25\",marginal\n1,,0.3,1.0,\"-2.0, 0.25\",no\n\
            2,grazing 1,0.3,,\"0.5 + 1.0i, 0.5 - 1.0i\",no\n";
        let text = String::from_utf8(branches(&Table::read(text, "x.csv").unwrap()).unwrap()).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 8, "{text}");
        let names: Vec<&str> = lines[1].split_whitespace().skip(4).collect();
        assert_eq!(names, ["PAR(1)", "V(1)", "MULT(1)", "Im", "MULT(1)", "MULT(2)", "Im", "MULT(2)"]);
        for (line, head) in [
            (2, "   1    -1   9    1"),
            (3, "   1     2   7    2"),
            (4, "   1     3   9    3"),
            (7, "   2     1  -4    4"),
        ] {
            assert_eq!(&lines[line][..19], head, "{text}");
            assert_eq!(lines[line].len(), 19 + 6 * WIDE);
        }
        assert_eq!(&lines[1][20 + WIDE..24 + WIDE], "V(1)");
        assert_eq!(lines[7][19 + WIDE..19 + 2 * WIDE].trim(), "NaN");
        assert!(branches(&Table::read("a\n1\n", "x.csv").unwrap()).is_err());
    }

    #[test]
    fn a_motion_is_time_and_state() {
        let table = Table::read("time,periods,q1,q2,u1,u2,gap\n0,0,1,2,3,4,5\n", "x.csv").unwrap();
        let text = String::from_utf8(motion(&table).unwrap()).unwrap();
        let numbers: Vec<f64> = text.split_whitespace().map(|x| x.parse().unwrap()).collect();
        assert_eq!(numbers, [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert!(motion(&Table::read("q,u\n1,2\n", "x.csv").unwrap()).is_err());
    }
}
