//! A branch over a range and over a part of it: where both are, the same happens at the same parameters. In
//! another range steps are others, too, and so are the points next to an event.

use grazing_scenes::run::{Findings, Surroundings, run};
use grazing_scenes::scene::Scene;

use super::{draw::Random, scenes::NAME};
use crate::samples::samples;

/// Parameters of one event in two ranges differ by less than this, and what is so near to an end of the
/// shorter one need not be in both.
const NEAR: f64 = 1e-6;

/// What happens along a branch from its start on, both ways, as far as it stays within a range: names, in
/// order, and parameters.
fn events(
    head: &str,
    start: (f64, &str),
    range: [f64; 2],
    within: [f64; 2],
) -> Result<Vec<(String, f64)>, String> {
    let [low, high] = range;
    let (at, from) = start;
    let text = format!(
        "{head}[[tasks]]\nname = \"b\"\nkind = \"branch\"\nparameter = \"p\"\nrange = [{low:?}, {high:?}]\n\
         starts = [{{ at = {at:?}, {from} }}]\n"
    );
    let scene = Scene::from_toml(&text, NAME).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let reports = run(&scene, Surroundings::default(), &mut ()).map_err(|error| error.to_string())?;
    let Some(Findings::Branch(found)) = &reports[0].findings else {
        return Err(reports[0].status.to_string());
    };
    let rows: Vec<_> = found.rows.iter().filter(|row| row.branch == 1).collect();
    let begin =
        rows.iter().position(|row| (row.parameters[0] - at).abs() < 1e-12).ok_or("the start is no point")?;
    let inside = |row: &&&_| (within[0]..=within[1]).contains(&parameter(row));
    let back = rows[..begin].iter().rev().take_while(inside).collect::<Vec<_>>();
    let all = back.into_iter().rev().chain(rows[begin..].iter().take_while(inside));
    let told = all.filter_map(|row| {
        let (name, _) = row.label.as_ref()?.rsplit_once(' ')?;
        let at = row.parameters[0];
        (at > within[0] + NEAR && at < within[1] - NEAR).then(|| (name.to_string(), at))
    });
    Ok(told.collect())
}

fn parameter(row: &grazing_scenes::run::MonitoredRow) -> f64 {
    row.parameters[0]
}

/// Compares a range with a part of it, and says how many events both have.
fn compared(head: &str, start: (f64, &str), range: [f64; 2], part: [f64; 2]) -> usize {
    let (long, short) = (events(head, start, range, part), events(head, start, part, part));
    let (long, short) = match (long, short) {
        (Ok(long), Ok(short)) => (long, short),
        (long, short) => {
            assert_eq!(long.is_err(), short.is_err(), "{long:?}\n{short:?}\n{head}");
            return 0;
        }
    };
    let same = |((a, x), (b, y)): (&(String, f64), &(String, f64))| {
        a == b && (x - y).abs() <= NEAR * (1.0 + x.abs())
    };
    assert!(
        long.len() == short.len() && long.iter().zip(&short).all(same),
        "from {start:?} over {range:?} and over {part:?}:\n{long:?}\n{short:?}\n{head}"
    );
    for pair in long.windows(2) {
        assert!((pair[1].1 - pair[0].1).abs() > 1e-8, "two labels of one event: {pair:?}\n{head}");
    }
    long.len()
}

/// An oscillator of period 2π/p with a spring stop at rest.
fn bilinear(damping: f64, stiffness: f64, offset: f64) -> String {
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"bilinear\"\n[parameters]\np = 1\n[system]\nperiod = \"2*pi/p\"\n\
         damping = {damping:?}\nstiffness = 1\nforcing = [{{ cos = 1 }}]\n\
         [[stops]]\nside = \"upper\"\noffset = {offset:?}\nstiffness = {stiffness:?}\n"
    )
}

/// Den Hartog's oscillator, the friction being the parameter.
fn rubbing(frequency: f64) -> String {
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"dry friction\"\n[parameters]\np = 0.2\n[system]\n\
         period = \"2*pi/{frequency:?}\"\nstiffness = 1\nforcing = [{{ cos = 1 }}]\n\
         [[friction]]\nnormal = 1\ncoefficient = \"p\"\n"
    )
}

#[test]
fn a_longer_range_has_the_same_events_on_its_part() {
    let mut random = Random(11);
    let mut between = |low: f64, high: f64| low + (high - low) * random.part();
    // Doubled orbits end at a flip, where they turn back as they cross the orbit of half the period.
    let doubled = (2.6, "attractor = { q = 0 }");
    let mut count = compared(&bilinear(0.05, 3.0, 0.0), doubled, [0.5, 4.0], [2.0, 4.0]);
    for _ in 0..samples(2) {
        let scene = bilinear(between(0.05, 0.3), between(1.0, 8.0), between(-0.3, 0.3));
        let start = (between(1.2, 3.0), "orbit = { pattern = [], starts = 4 }");
        count += compared(&scene, start, [0.6, 4.0], [between(0.8, 1.1), between(3.2, 3.8)]);
    }
    assert!(count > 1, "{count} events");
}

/// What a symmetric motion does twice in a period it does at one parameter: one event with one name.
#[test]
fn what_friction_changes_at_one_parameter_is_one_event() {
    let mut random = Random(12);
    let mut frequency = 1.1057;
    for _ in 0..samples(1) {
        // Where the range ends decides where steps are, and so what lies between the two changes.
        let (range, free) = ([0.1742, 0.819_160_959_050_872_5], "orbit = { pattern = [] }");
        let events = compared(&rubbing(frequency), (0.1742, free), range, [0.1742, 0.78]);
        assert!(events > 0 || frequency != 1.1057);
        frequency = 0.6 + random.part();
    }
}
