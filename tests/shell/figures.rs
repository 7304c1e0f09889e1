//! The figures' data against other routes, and their pictures for labels that overlap.

use std::{collections::HashMap, fs, path::Path, process::Command};

use grazing_scenes::{
    existence::{Case, by_definition, by_records, intervals},
    local::{Ladder, Point, Polar},
    number::parse_rational,
    word::Word,
};

/// Draws a figure; returns the rows of its CSV by column name, and its SVG.
pub(super) fn draw(arguments: &str, name: &str) -> (Vec<HashMap<String, String>>, String) {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(crate::PROGRAM);
    command.arg("figure").args(arguments.split_whitespace()).arg("-o").arg(folder.path());
    let output = command.output().unwrap();
    assert_eq!((output.status.code(), output.stderr), (Some(0), vec![]), "grazing figure {arguments}");
    let read = |extension| fs::read_to_string(folder.path().join(format!("{name}.{extension}"))).unwrap();
    (table(&read("csv")), read("svg"))
}

fn table(text: &str) -> Vec<HashMap<String, String>> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().map(Result::unwrap).collect()
}

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    row[column].parse().unwrap()
}

/// The text of an element as (letters, size of type), tag by tag: letters may be lowered or raised, and
/// small.
fn runs(element: &str, size: f64) -> Vec<(String, f64)> {
    let plain = |text: &str| {
        text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
    };
    let run = |piece: &str| match piece.split_once('>') {
        None => (plain(piece), size),
        Some((tag, rest)) if tag.contains("font-size=") => (plain(rest), attribute(tag, "font-size")),
        Some((_, rest)) => (plain(rest), size),
    };
    element.split('<').map(run).collect()
}

fn attribute<T: std::str::FromStr<Err: std::fmt::Debug>>(tag: &str, name: &str) -> T {
    let (_, rest) = tag.split_once(&format!(" {name}=\"")).unwrap_or_else(|| panic!("{name} in {tag}"));
    rest.split_once('"').unwrap().0.parse().unwrap()
}

/// (left, top, right, bottom) of every text in a picture, but for what hangs below the base line.
pub(super) fn labels(svg: &str) -> Vec<(String, [f64; 4])> {
    let label = |piece: &str| {
        let (tag, rest) = piece.split_once('>').unwrap();
        let size: f64 = attribute(tag, "font-size");
        let runs = runs(rest.split_once("</text>").unwrap().0, size);
        let width: f64 = runs.iter().map(|(text, size)| grazing_shell::text_width(text, *size)).sum();
        let [x, y]: [f64; 2] = ["x", "y"].map(|name| attribute(tag, name));
        let before = match attribute::<String>(tag, "text-anchor").as_str() {
            "start" => 0.0,
            "middle" => width / 2.0,
            _ => width,
        };
        // Digits and capitals stand on the base line. Turned, the text runs upwards.
        let high = 0.72 * size;
        let at = match tag.contains("transform") {
            true => [x - high, y + before - width, x, y + before],
            false => [x - before, y - high, x - before + width, y],
        };
        (runs.into_iter().map(|(text, _)| text).collect(), at)
    };
    svg.split("<text").skip(1).map(label).collect()
}

/// No text leaves the picture, nor covers another; the picture says in words what it shows. All grows with
/// the picture: what holds at one width holds at all.
pub(super) fn assert_no_overlap(svg: &str) {
    let all = labels(svg);
    assert!(all.len() >= 5);
    assert!(svg.contains("<title>") && svg.contains("<desc>"));
    let sides = svg.split_once("viewBox=\"0 0 ").unwrap().1.split_once('"').unwrap().0;
    let [width, height] = [0, 1].map(|i| sides.split(' ').nth(i).unwrap().parse::<f64>().unwrap());
    for (text, [left, top, right, bottom]) in &all {
        assert!(*left >= 0.0 && *top >= 0.0 && *right <= width && *bottom <= height, "{text} is cut");
    }
    let named: Vec<_> = all.iter().filter(|(text, _)| !text.is_empty()).collect();
    for (i, (text, a)) in named.iter().enumerate() {
        for (other, b) in &named[..i] {
            let apart = a[2] < b[0] || b[2] < a[0] || a[3] < b[1] || b[3] < a[1];
            assert!(apart, "{text} {a:?} covers {other} {b:?}");
        }
    }
}

#[test]
#[should_panic(expected = "a < b [5.0")]
fn a_text_that_covers_another_is_found() {
    let text = |x: u32, anchor: &str, body: &str| {
        format!("<text x=\"{x}\" y=\"10\" font-size=\"8\" text-anchor=\"{anchor}\">{body}</text>")
    };
    let others: String = (5..9).map(|x| text(10 * x, "start", "c")).collect();
    let svg = |x| {
        let small = text(5, "start", "a &lt; <tspan font-size=\"5\">b</tspan>");
        let middle = text(x, "middle", "c");
        format!("<svg viewBox=\"0 0 90 20\"><title></title><desc></desc>{middle}{others}{small}</svg>")
    };
    // Beside it all is well.
    assert_no_overlap(&svg(40));
    assert_no_overlap(&svg(12));
}

/// N_{n,k} by the recurrence, in floats.
fn numerator(n: usize, k: usize, a1: f64, a2: f64) -> f64 {
    let mut u = vec![0.0, 1.0];
    for i in 1..n {
        u.push(a1 * u[i] - a2 * u[i - 1]);
    }
    u[n] - u[k] - a2.powi(k as i32) * u[n - k]
}

#[test]
fn iterate_boundaries_are_zeros() {
    let (rows, svg) = draw("4", "figure4");
    let mut curves = std::collections::BTreeSet::new();
    for row in &rows {
        let (n, k) = (number(row, "n") as usize, number(row, "k") as usize);
        curves.insert((n, k));
        let (a1, a2) = (number(row, "a1"), number(row, "a2"));
        assert!(numerator(n, k, a1, a2).abs() < 1e-6, "{row:?}");
        if (n, k) == (3, 1) {
            assert!((a1 + 1.0).abs() < 1e-7, "{row:?}");
        }
    }
    // One active boundary for each k coprime to n: the sum of φ(n) from 3 to 15.
    assert_eq!(curves.len(), 70);
    assert_no_overlap(&svg);
    for label in ["3,1", "3,2", "4,1", "4,3", "5,1", "5,2", "5,3", "5,4"] {
        assert_eq!(labels(&svg).iter().filter(|(text, _)| text == label).count(), 1, "{label}");
    }
}

/// The times of a run against the map itself, followed from many points of the line, in floats.
#[test]
fn return_times_are_those_of_the_map() {
    let (rows, svg) = draw("returns", "returns");
    assert_no_overlap(&svg);
    let fraction = |text: &str| {
        let (p, q) = text.split_once('/').unwrap_or((text, "1"));
        p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap()
    };
    let mut followed = 0;
    for row in rows.iter().step_by(7) {
        let (r, s) = (fraction(&row["r"]), fraction(&row["first_s"]));
        let times: Vec<u32> = row["times"].split(' ').map(|n| n.parse().unwrap()).collect();
        // Elsewhere few points have the longest time.
        if r.ln().abs() * f64::from(times[times.len() - 1]) > 2.5 {
            continue;
        }
        followed += 1;
        // Re w = 1, w = 1 + i tan of an angle; a return is |λ|ⁿ cos(angle + 2πns) > cos(angle).
        let mut found = std::collections::BTreeSet::new();
        for step in 1..20_000 {
            let angle = (f64::from(step) / 20_000.0 - 0.5) * std::f64::consts::PI;
            let back = |n: &u32| {
                let turn = std::f64::consts::TAU * s * f64::from(*n);
                r.powi(*n as i32) * (angle + turn).cos() > angle.cos() * (1.0 + 1e-12)
            };
            found.extend((1..=times[times.len() - 1]).find(back));
        }
        // A time of few points may be missed; none is made up, and those of many points are there.
        assert!(found.iter().all(|n| times.contains(n)), "{row:?} {found:?}");
        assert!(found.len() + 1 >= times.len(), "{row:?} {found:?}");
    }
    assert!(followed > 50, "{followed}");
}

/// Bounds are bounds; the median of the exact curve is that of the cells, of which `tests/theory/measure.rs`
/// tells.
#[test]
fn coexisting_periods_are_counted() {
    let (rows, svg) = draw("coexistence --n 300", "coexistence");
    assert_no_overlap(&svg);
    let mut before: Option<&HashMap<String, String>> = None;
    for row in &rows {
        let [lower, upper, law] = ["lower", "upper", "law"].map(|name| number(row, name));
        assert!((0.0..=upper).contains(&lower) && upper <= 1.0 && (0.0..=1.0).contains(&law), "{row:?}");
        let same = |one: &&HashMap<String, String>| {
            one["one_minus_r"] == row["one_minus_r"] && one["order"] == row["order"]
        };
        if let Some(before) = before.filter(same) {
            assert!(number(before, "lower") <= lower && number(before, "law") <= law, "{row:?}");
        }
        before = Some(row);
        let exact = row["one_minus_r"] == "0" && number(row, "order") <= 300.0;
        let width = upper - lower;
        assert!(if exact {
            width < 1e-6
        } else {
            (0.03..0.08).contains(&width) || upper == 1.0 || lower == 0.0
        });
    }
}

#[test]
fn regions_are_bounded_by_unit_and_equal_eigenvalues() {
    let (rows, svg) = draw("2", "figure2");
    for row in &rows {
        let (a1, a2) = (number(row, "a1"), number(row, "a2"));
        let line = if row["line"].contains("sqrt") { a1 * a1 - 4.0 * a2 } else { a1.abs() - a2 - 1.0 };
        assert!(line.abs() < 1e-3, "{row:?}");
    }
    assert_no_overlap(&svg);
}

#[test]
fn records_are_those_of_the_record_form() {
    for (r, s, n) in [
        ("0.991", "0.205", 15),
        ("1", "0.381966", 40),
        ("0.99", "1/3+1e-3", 12),
        ("0.999", "0.01", 60),
        ("0.97", "0.49", 30),
    ] {
        let (rows, svg) = draw(&format!("records --r {r} --s {s} --n {n}"), "records");
        let point = Point::Polar(Polar::new(parse_rational(r).unwrap(), parse_rational(s).unwrap()).unwrap());
        let expected = by_records(&Ladder::default(), &point, n).unwrap();
        assert_eq!(rows.len(), n as usize);
        for (row, (existence, n)) in rows.iter().zip(expected.iter().zip(1..)) {
            let cases: Vec<String> = existence.cases(n).iter().map(|case| case.to_string()).collect();
            assert_eq!(row["cases"], cases.join(" "), "{r} {s} {n}");
        }
        assert_no_overlap(&svg);
    }
}

#[test]
fn areas_are_where_orbits_exist() {
    let (rows, svg) = draw("5 --n 7", "figure5");
    let middle = |row: &HashMap<String, String>, ends: [&str; 2]| {
        let [low, high] = ends.map(|end| parse_rational(&row[end]).unwrap());
        (low + high) / num_bigint::BigInt::from(2)
    };
    for row in &rows {
        let (r, s) = (middle(row, ["r_lower", "r_upper"]), middle(row, ["s_lower", "s_upper"]));
        let found = by_definition(&Ladder::default(), &Point::Polar(Polar::new(r, s).unwrap()), 7);
        let signs = |case: &Case| [case.sign_emu().to_string(), case.sign_gamma().to_string()];
        let drawn = [row["sign_emu"].clone(), row["sign_gamma"].clone()];
        match row["kind"].as_str() {
            "orbit" => assert_eq!(found.cases(7).iter().map(signs).collect::<Vec<_>>(), [drawn]),
            "none" => assert_eq!((found.cases(7), drawn), (vec![], [String::new(), String::new()])),
            kind => assert_eq!(kind, "edge"),
        }
    }
    assert_no_overlap(&svg);
}

#[test]
fn tips_have_bounds_near_the_law() {
    let (rows, svg) = draw("tips --n 16", "tips");
    // Two deciding indices, n − 1 and (n odd) n − 2, belong to areas that reach down to 0.
    let areas: usize = (4..=16).map(|n| intervals(n).unwrap().count() - 2 - (n % 2) as usize).sum();
    assert_eq!(rows.len(), areas);
    for row in &rows {
        assert!(number(row, "scaled_lower") <= number(row, "scaled_upper"));
        let (found, law, next) = (number(row, "scaled_lower"), number(row, "law"), number(row, "law_next"));
        let t = number(row, "k") / number(row, "n");
        assert!(t > 0.5 || (found - next).abs() < (found - law).abs(), "{row:?}");
    }
    assert_no_overlap(&svg);
}

/// Each strip crosses every band within its boxes; the attractor of figure 10 comes near the strip of
/// period 3.
#[test]
fn the_strips_of_the_shift_cross_its_bands() {
    let (rows, svg) = draw("chaos", "chaos");
    let at = |row: &HashMap<String, String>| (number(row, "before"), number(row, "after"));
    let of = |set: String| rows.iter().filter(move |row| row["set"] == set).map(at).collect::<Vec<_>>();
    let boxes: Vec<Vec<(f64, f64)>> = (1..=3).map(|n| of(format!("corner of box {n}"))).collect();
    for n in 1..=3 {
        let strip = of(format!("edge of strip {n}"));
        let [(least, _), (most, _)] = boxes[n - 1][..] else { panic!("{boxes:?}") };
        for (low, high) in boxes.iter().map(|corners| (corners[0].1, corners[1].1)) {
            let inside: Vec<f64> =
                strip.iter().filter(|(_, a)| low <= *a && *a <= high).map(|(p, _)| *p).collect();
            assert!(inside.len() >= 4, "strip {n} between {low} and {high}: {inside:?}");
            assert!(inside.iter().all(|p| least <= *p && *p <= most), "strip {n}: {inside:?}");
        }
    }
    assert!(of("attractor".into()).len() > 100);
    assert_no_overlap(&svg);
}

/// All impacts are in the trap, and next to one another on a branch they part as fast as is proved: by E
/// along the wall's motion, of which |V| is nearly the slope.
#[test]
fn impacts_beyond_a_touch_stay_in_the_trap() {
    let (rows, svg) = draw("attractor", "attractor");
    let of = |set: &str| rows.iter().filter(|row| row["set"] == set).collect::<Vec<_>>();
    let [trap] = of("trap")[..] else { panic!("one trap") };
    let (most, impacts) = (number(trap, "speed"), of("impact"));
    assert!(impacts.len() > 500 && (0.72..0.73).contains(&most), "{} {most}", impacts.len());
    let mut branches: HashMap<String, Vec<(f64, f64)>> = HashMap::new();
    for row in impacts {
        let (before, after) = (number(row, "speed"), number(row, "next"));
        assert!(0.0 < after && after <= most && before <= most, "{before} {after}");
        branches.entry(row["periods"].clone()).or_default().push((before, after));
    }
    assert!((4..20).contains(&branches.len()), "{}", branches.len());
    for (periods, mut all) in branches {
        all.sort_by(|one, other| one.0.total_cmp(&other.0));
        for two in all.windows(2) {
            let (apart, parted) = (two[1].0 - two[0].0, (two[1].1 - two[0].1).abs());
            let part = apart < 1e-5 || parted > 1.2 * apart;
            assert!(part, "{periods}: {two:?}");
        }
    }
    assert_no_overlap(&svg);
}

/// A window and the gap below it, to the next: nearly all of it is proved, stretch by stretch, and what is
/// seen is as is proved. Each is about λ₁² times the one before.
#[test]
fn windows_and_gaps_are_proved_where_they_are_seen() {
    let (rows, svg) = draw("gaps 1", "gaps");
    let (hits, stretches): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row["set"] == "impact");
    let ends = |row: &HashMap<String, String>| ["from", "to"].map(|end| number(row, end));
    let long = |row: &&&HashMap<String, String>| (ends(row)[1] / ends(row)[0]).ln();
    for two in stretches.windows(2) {
        let [above, below] = [ends(two[0])[0], ends(two[1])[1]];
        assert!((0.0..1e-9).contains(&(above - below)), "{two:?}");
    }
    let share =
        |what: &str| stretches.iter().filter(|row| row["set"] == what).map(|row| long(&row)).sum::<f64>();
    let [stable, chaos, open] = ["stable", "chaos", "open"].map(share);
    let lambda = (-std::f64::consts::TAU * (1.5 - 1.25f64.sqrt()) / 5.0).exp();
    assert!((stable + chaos + open + 2.0 * lambda.ln()).abs() < 0.05, "{stable} {chaos} {open}");
    assert!(stable > 0.3 && chaos > 0.45 && open < 0.06, "{stable} {chaos} {open}");
    for row in &stretches {
        let [from, to] = ends(row);
        let within = |mu: &f64| 1.15 * from < *mu && *mu < 0.95 * to;
        let mut inside: Vec<f64> = hits.iter().map(|hit| number(hit, "from")).filter(within).collect();
        let seen = inside.len();
        inside.dedup();
        match row["set"].as_str() {
            "stable" => assert!(seen > 8 && seen == inside.len() && row["value"] == "7", "{seen} {row:?}"),
            "chaos" => assert!(number(row, "value") > 1.0, "{row:?}"),
            _ => {}
        }
    }
    // Twenty values in the gap, each with more than a few impacts.
    let gap = hits.iter().filter(|hit| (0.017..0.027).contains(&number(hit, "from")));
    let mut values: HashMap<&str, usize> = HashMap::new();
    gap.for_each(|hit| *values.entry(&hit["from"]).or_default() += 1);
    assert!(values.len() > 15 && values.values().all(|many| *many > 8), "{values:?}");
    assert_no_overlap(&svg);
}

/// A picture for each kind of box; its cells cover the box, and their words are those of `word` at a point.
#[test]
fn tolerances_are_shown_with_their_words() {
    for (arguments, x, y, labelled) in [
        ("", ["ratio_lower", "ratio_upper"], ["damping_lower", "damping_upper"], ["DUU", "DU", "DD"]),
        // Across γ = 0, where the image folds, and much is open.
        (
            "--frequency 0.9..=1.1 --damping-ratio 0.01..=0.1 --drive 1",
            ["ratio_lower", "ratio_upper"],
            ["damping_lower", "damping_upper"],
            ["s", "r", "other words"],
        ),
        ("--r 0.97±1% --s 0.37", ["r_lower", "r_upper"], ["s_lower", "s_upper"], ["D", "s", "r"]),
        (
            "--a1 0.3..=1.9 --a2 0.6±10%",
            ["a1_lower", "a1_upper"],
            ["a2_lower", "a2_upper"],
            ["DUU (1, 3, 4)", "(1, …)", "open"],
        ),
        (
            "--frequency 0.3±10% --damping-ratio 0.9..=1.1 --drive 1",
            ["ratio_lower", "ratio_upper"],
            ["damping_lower", "damping_upper"],
            ["D (1, …)", "DDDD (1 to 4)", "open"],
        ),
    ] {
        let (rows, svg) = draw(&format!("tolerance {arguments}"), "tolerance");
        assert_no_overlap(&svg);
        let shown = labels(&svg);
        for text in labelled {
            assert!(shown.iter().any(|(label, _)| label.contains(text)), "{arguments}: {text} in {shown:?}");
        }
        let exact = |row: &HashMap<String, String>, column: &str| parse_rational(&row[column]).unwrap();
        let flat = exact(&rows[0], y[0]) == exact(&rows[0], y[1]);
        let area: f64 = rows.iter().map(|row| 0.5f64.powf(number(row, "halvings"))).sum();
        assert!((area - 1.0).abs() < 1e-12, "{arguments}: {area}");
        let is_polar = x[0].starts_with('r') && x[0] != "ratio_lower";
        for row in rows.iter().filter(|row| is_polar && !row["word_before"].is_empty()).take(20) {
            let middle = |[lower, upper]: [&str; 2]| {
                (exact(row, lower) + exact(row, upper)) / num_bigint::BigInt::from(2)
            };
            let point = Point::Polar(Polar::new(middle(x), middle(y)).unwrap());
            for (column, positive) in [("word_before", true), ("word_beyond", false)] {
                let word = Word::at(&Ladder::default(), &point, positive, 64, &()).unwrap();
                assert!(row[column].is_empty() || row[column] == word.letters(), "{row:?}");
            }
        }
        assert_eq!(flat, arguments.contains("--s 0.37"));
    }
}

/// Small charts: cells cover the box once, and both sides of the touch differ somewhere.
#[test]
fn the_design_chart_covers_its_box() {
    for (arguments, high) in [
        ("design --frequency 0.3..=0.45 --drive 1 --damping-ratio 0.1..=0.2", 0.1),
        ("design --frequency 36..=37Hz --drive 100Hz --damping-ratio 0.01..=0.1", 0.09),
    ] {
        let (rows, svg) = draw(arguments, "design");
        assert_no_overlap(&svg);
        let area = |row: &HashMap<String, String>| {
            (number(row, "ratio_upper") - number(row, "ratio_lower"))
                * (number(row, "damping_upper") - number(row, "damping_lower"))
        };
        let wide = if arguments.contains("Hz") { 0.01 } else { 0.15 };
        let whole: f64 = rows.iter().map(area).sum();
        assert!((whole / (wide * high) - 1.0).abs() < 1e-9, "{whole}");
        let open: f64 = rows.iter().filter(|row| row["chaos_before"] == "open").map(area).sum();
        assert!(open < 0.05 * whole, "{open}");
        let is = |column: &str, said: &str| rows.iter().any(|row| row[column] == said);
        assert!(is("chaos_before", "yes") && is("chaos_before", "no"), "{arguments}");
    }
}

/// Of every picture on the pages, those of measured tables among them.
#[test]
fn no_text_on_the_pages_covers_another() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let pictures: Vec<_> = files.filter(|file| file.extension().is_some_and(|end| end == "svg")).collect();
    assert!(pictures.len() > 20, "{}", pictures.len());
    for picture in pictures {
        println!("{}", picture.display());
        assert_no_overlap(&fs::read_to_string(picture).unwrap());
    }
}

#[test]
fn wrong_numbers_are_named() {
    let cases = [
        ("4 2", "N = 2: this figure shows periods 3 to N, with N from 3 to 40"),
        ("records 61", "N = 61: this figure shows periods 1 to N, with N from 1 to 60"),
        ("records --r 0.9 --s 1/2", "s = 1/2 is outside 0 < s < 1/2"),
        ("5 25", "N = 25: this figure shows one period N, with N from 3 to 24"),
        ("touch 1000", "N = 1000: this figure shows periods up to N, with N from 3 to 30"),
        ("gaps 10", "N = 10: this figure shows N windows, with N from 1 to 9"),
        ("tips 3", "N = 3: this figure shows periods 4 to N, with N from 4 to 400"),
        ("2 --r 0.9 --s 0.2", "a point or a box belongs to `grazing figure records`"),
        ("records --r 0.9±1% --s 0.2", "figure records shows one point"),
        ("records --a1 0.9 --a2 0.2", "figure records shows a point by --r and --s"),
        ("tolerance --r 0.9 --s 0.2", "figure tolerance shows a box"),
        ("design --r 0.9±1% --s 0.2", "two different ends"),
    ];
    for (arguments, expected) in cases {
        let mut command = Command::new(crate::PROGRAM);
        let output = command.arg("figure").args(arguments.split_whitespace()).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(expected), "grazing figure {arguments}: {message}");
    }
}

/// `-o` names a picture's file; what this program cannot write is refused before the work.
#[test]
fn the_output_may_be_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let figure = |arguments: &str| {
        let mut command = Command::new(crate::PROGRAM);
        let output = command.arg("figure").args(arguments.split(' ')).current_dir(&folder).output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    assert_eq!(figure("2 -o plane.svg"), (Some(0), String::new()));
    let svg = fs::read_to_string(folder.path().join("plane.svg")).unwrap();
    assert!(svg.starts_with("<svg ") && folder.path().join("plane.csv").exists());
    let (code, message) = figure("8 -o eight.svg");
    assert!(code == Some(2) && message.contains("figure8.svg"), "{message}");
    let (code, message) = figure("2 -o plane.jpg");
    assert!(code == Some(2) && message.contains("plane.jpg: pictures are .svg"), "{message}");
    assert!(!folder.path().join("plane.jpg").exists());
    fs::create_dir(folder.path().join("v1.2")).unwrap();
    assert_eq!(figure("2 -o v1.2"), (Some(0), String::new()));
    assert!(folder.path().join("v1.2/figure2.svg").exists());
    for (name, begin) in [("plane.pdf", &b"%PDF-"[..]), ("plane.png", b"\x89PNG\r\n")] {
        let (code, message) = figure(&format!("2 -o {name}"));
        if cfg!(feature = "print") {
            let bytes = fs::read(folder.path().join(name)).unwrap();
            assert!(code == Some(0) && bytes.starts_with(begin) && bytes.len() > 5000, "{message}");
        } else {
            assert!(code == Some(2) && message.contains("--features print"), "{message}");
            assert!(!folder.path().join(name).exists());
        }
    }
}

/// Figures of the paper's scene say what they wrote, and show the part of the plane that is asked for; the
/// data beside them are whole.
#[test]
fn a_part_of_a_figure_is_shown_and_what_is_written_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let figure = |arguments: &str, output: &str| {
        let mut command = Command::new(crate::PROGRAM);
        let all = format!("figure {arguments} -o {output}");
        let ran = command.args(all.split(' ')).current_dir(&folder).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (ran.status.code().unwrap(), text(ran.stdout), text(ran.stderr))
    };
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let (code, out, err) = figure("8", "whole");
    assert_eq!((code, out.as_str()), (0, "wrote whole/figure8.svg and whole/figure8.csv\n"), "{err}");
    let (code, _, err) = figure("8 --x-limits 0.9..=1.3 --y-limits -1/10..=0.1", "part");
    assert_eq!(code, 0, "{err}");
    assert_eq!(read("part/figure8.csv"), read("whole/figure8.csv"));
    let svg = read("part/figure8.svg");
    assert_no_overlap(&svg);
    // Its last marks are the ends.
    let marks: Vec<f64> =
        labels(&svg).iter().filter_map(|(text, _)| text.replace('−', "-").parse().ok()).collect();
    assert!(marks.contains(&1.3) && marks.contains(&-0.1), "{marks:?}");
    assert!(marks.iter().all(|mark| (-0.1..=1.3).contains(mark)), "{marks:?}");
    assert!(svg.len() < read("whole/figure8.svg").len());
    // All of it lies within a turn.
    assert_eq!(figure("8 --q-modulo-2pi", "turn").0, 0);
    assert_eq!(labels(&read("turn/figure8.svg")), labels(&read("whole/figure8.svg")));
    // Branches are cut at the edges.
    let (code, out, err) = figure("6 --x-limits -0.05..=0.001", "part");
    assert!(code == 0 && out.ends_with("and part/figure6-points.csv\n"), "{out}{err}");
    assert_no_overlap(&read("part/figure6.svg"));
    // Each of the two parts of the branch that turns back outside has its name.
    let named = labels(&read("part/figure6.svg")).iter().filter(|(text, _)| text == "(4)").count();
    assert_eq!(named, 2);
    for (arguments, said) in [
        ("8 --x-limits 1e6..=2e6", "nothing is within the limits"),
        ("intervals --x-limits 0..=1", "belong to the figures 6 to 10"),
        ("8 --y-limits 1", "two different ends"),
    ] {
        let (code, _, err) = figure(arguments, "wrong");
        assert!(code == 2 && err.contains(said), "{arguments}: {err}");
    }
}

/// The branches of figure 6 are still those in the documentation. At a saddle-node and a flip a multiplier is
/// on the unit circle, and rounding decides on which side.
#[test]
fn branches_are_marginal_where_a_multiplier_is_on_the_unit_circle() {
    let (rows, svg) = draw("6", "figure6");
    let kept =
        table(&fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/figure6.csv")).unwrap());
    assert_eq!(rows.len(), kept.len());
    let mut marginal = Vec::new();
    for (row, kept) in rows.iter().zip(&kept) {
        for column in ["parameter", "q"] {
            assert!((number(row, column) - number(kept, column)).abs() < 1e-9, "{row:?} {kept:?}");
        }
        for column in ["set", "stability", "label"] {
            assert_eq!(row[column], kept[column], "{row:?}");
        }
        match row["stability"].as_str() {
            "marginal" => marginal.push(row["label"].as_str()),
            other => assert!(["stable", "unstable"].contains(&other), "{row:?}"),
        }
    }
    assert_eq!(marginal, ["saddle-node", "flip"]);
    // In the picture each goes with what follows it.
    let drawn = |name| labels(&svg).iter().any(|(text, _)| text == name);
    assert!(drawn("stable") && drawn("unstable") && !drawn("marginal"));
}

/// The pictures in the documentation are those that the program draws today.
#[test]
fn checked_in_figures_are_current() {
    for (arguments, name) in [
        ("2", "figure2"),
        ("4", "figure4"),
        ("5", "figure5"),
        ("intervals", "intervals"),
        ("records", "records"),
        ("words --n 20", "words"),
    ] {
        let (rows, svg) = draw(arguments, name);
        let kept = |extension| {
            fs::read_to_string(
                Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs"))
                    .join(format!("{name}.{extension}")),
            )
            .unwrap()
        };
        assert!(
            kept("svg") == svg && table(&kept("csv")) == rows,
            "run `grazing figure {arguments} -o docs`"
        );
    }
}

/// What the page on accuracy says of its tables: no enclosure without the value, no motion of ours with an
/// impact too few, and the tables of other programs have the same columns.
#[test]
fn tables_of_accuracy_hold_what_the_page_says() {
    let read = |name: &str| {
        table(
            &fs::read_to_string(
                Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("docs").join(name),
            )
            .unwrap(),
        )
    };
    for row in read("digits.csv").iter().chain(&read("digits-peers.csv")) {
        assert_eq!(row["outside"], "0", "{row:?}");
        assert!(row["method"].starts_with("f64") || row["wrong"] == "0", "{row:?}");
        assert!(number(row, "q25") <= number(row, "time_ns") && number(row, "time_ns") <= number(row, "q75"));
    }
    for row in read("simulations.csv") {
        assert_eq!(row["missed"], "0", "{row:?}");
    }
    let columns = |row: &HashMap<String, String>| {
        let mut names: Vec<String> = row.keys().cloned().collect();
        names.sort();
        names
    };
    assert_eq!(columns(&read("simulations.csv")[0]), columns(&read("simulations-peers.csv")[0]));
    let ours = columns(&read("digits.csv")[0]);
    assert!(columns(&read("digits-peers.csv")[0]).iter().all(|name| ours.contains(name)));
}

/// What a narrow box, or a tiny parameter, is called in its picture tells its ends apart.
#[test]
fn a_box_is_called_by_its_ends() {
    let folder = tempfile::tempdir().unwrap();
    let place = "--frequency 1.2300000001..=1.2300000002 --damping-ratio 0.00000002±20% --drive 1";
    let (code, _, err) = crate::process::run(&format!("figure tolerance {place}"), folder.path());
    assert_eq!(code, 0, "{err}");
    let picture = fs::read_to_string(folder.path().join("tolerance.svg")).unwrap();
    for ends in ["1.2300000001 to 1.2300000002<", "0.000000016 to 0.000000024<"] {
        assert!(picture.contains(ends), "{ends}");
    }
}

/// A drive that is written in millinewtons in a scene of newtons: pictures are over millinewtons, with the
/// data drawn, and tables beside them in the scene's own unit.
#[test]
fn pictures_are_in_the_unit_in_which_a_parameter_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = \"500 mN\"\nc = \"0.1 N s/m\"\n\
                 k = \"0.3 N/m\"\n[system]\nperiod = \"2*pi s\"\nmass = \"1 kg\"\ndamping = \"c\"\nstiffness = \"k\"\n\
                 forcing = [{ cos = \"F\" }]\n[[stops]]\nside = \"upper\"\noffset = \"1 m\"\nrestitution = 0.8\n";
    let tasks = "[[tasks]]\nname = \"sweep\"\nkind = \"diagram\"\nparameter = \"F\"\nrange = [\"400 mN\", \"900 mN\"]\ncount = 6\n\
                 starts = [{ q = 0 }]\nsweep = \"both\"\n[[tasks]]\nname = \"follow\"\nkind = \"branch\"\nparameter = \"F\"\n\
                 range = [\"500 mN\", \"700 mN\"]\nstarts = [{ orbit = { pattern = [] } }]\n[[tasks]]\nname = \"swing\"\nkind = \"response\"\nparameter = \"F\"\n\
                 range = [\"100 mN\", \"600 mN\"]\ncount = 6\n[[tasks]]\nname = \"plane\"\nkind = \"map\"\nparameter = \"F\"\nrange = [\"400 mN\", \"900 mN\"]\n\
                 count = 2\nsecond = \"k\"\nsecond_range = [\"0.3 N/m\", \"0.4 N/m\"]\nsecond_count = 2\nstart = { q = 0 }\n";
    fs::write(folder.path().join("s.toml"), format!("{scene}{tasks}")).unwrap();
    let output = Command::new(crate::PROGRAM)
        .args(["run", "s.toml", "-o", "out"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    for name in ["sweep", "follow", "swing", "plane"] {
        let picture = read(&format!("{name}.svg"));
        assert!(picture.contains("(mN)") && !picture.contains("(N)"), "{name}");
    }
    for (name, column, [from, to]) in [
        ("sweep.csv", "parameter", [399.0, 901.0]),
        ("follow.csv", "parameter", [499.0, 701.0]),
        ("swing.csv", "value", [0.09, 0.61]),
        ("plane.csv", "first", [0.39, 0.91]),
    ] {
        let rows = table(&read(name));
        assert!(
            !rows.is_empty() && rows.iter().all(|row| (from..=to).contains(&number(row, column))),
            "{name}"
        );
    }
}
