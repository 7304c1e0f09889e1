//! What a motion tends to, on the stroboscopic section, and the multipliers of a periodic one.

use std::f64::consts::TAU;

use grazing_scenes::{
    Error, Result,
    motion::Contact,
    number::parse_rational,
    run::{AttractorRow, Findings, Model, SectionSet, run_task},
    scene::{Body, Scene},
};
use serde_json::{Value, json};

use super::{
    document::{self, Changeable, quoted},
    over_time::motion_keys,
    request::Request,
    series::{Seen, Series, Strike},
    task::{finished, job, run_one},
};

pub fn section_keys(request: &Request) -> Result<String> {
    let points = request.number("points", 1000, 3..=20_000)?;
    let mut keys = format!(
        "[[tasks]]\nname = \"section\"\nkind = \"section\"\nstarts = [{}]\n{}transient = {}\npoints = {points}\n",
        request.start(),
        request.look(),
        request.transient()?,
    );
    if request.0["grazing_curve"] == true {
        keys += "grazing_curve = true\n";
    }
    Ok(keys)
}

/// The states of a section, seen from its frame, as one list x₀, y₀, x₁, …
fn framed(points: &[[f64; 2]], [q0, u0]: [f64; 2]) -> Vec<f64> {
    points.iter().flat_map(|[q, u]| [q - q0, u - u0]).collect()
}

/// What is taken off (q, u) in the frame of a wall, for a system.
pub fn frame_of(request: &Request, model: &Model) -> Result<[f64; 2]> {
    let (Model::Oscillator(system), Some(frame)) = (model, request.0["frame"].as_str()) else {
        return Ok([0.0; 2]);
    };
    let phase = parse_rational(request.0["phase"].as_str().unwrap_or("0"))?;
    let phase = TAU * document::float(&(&phase - phase.floor())).unwrap_or(0.0);
    let walls = Contact::of(system)?;
    Ok(walls.iter().find(|wall| wall.side.name() == frame).map_or([0.0; 2], |wall| {
        let [q, u, _] = wall.position.at(phase);
        [q - wall.position.mean(), u]
    }))
}

pub fn section(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let values = request.values();
    let text = changeable.with(&values, &section_keys(request)?)?;
    let scene = Scene::from_toml(&text, &changeable.name)?;
    let job = job(&scene, 0, &[])?;
    let frame = frame_of(request, &job.model)?;
    let report = run_task(&job, &mut ());
    let json = finished(&report)?;
    let Some(Findings::Section(found)) = &report.findings else {
        return Err(Error::input("the section has no findings"));
    };
    let set = |(set, points): &(SectionSet, Vec<[f64; 2]>)| {
        let index = match set {
            SectionSet::Attractor(index) => Some(*index),
            _ => None,
        };
        json!({ "attractor": index, "xy": framed(points, frame) })
    };
    let curves: Vec<Value> = found
        .grazing_curve
        .iter()
        .map(|(wall, piece)| json!({ "wall": wall.side.name(), "xy": framed(piece, frame) }))
        .collect();
    let orbit = match found.attractors.first() {
        Some(row) => multipliers(request, &changeable, &values, row)?,
        None => Value::Null,
    };
    Ok(json!({
        "sets": found.points.iter().map(set).collect::<Vec<_>>(),
        "grazing_curve": curves,
        "report": json,
        "orbit": orbit,
    }))
}

/// The periodic orbit on which a motion ends, found again by Newton's method from its own impacts: its
/// multipliers. Null for a motion that is not periodic.
fn multipliers(
    request: &Request,
    changeable: &Changeable,
    values: &[(String, String)],
    row: &AttractorRow,
) -> Result<Value> {
    let Some(period) = row.period else { return Ok(Value::Null) };
    let periods = period as u64;
    let keys = motion_keys(request, request.transient()?, periods, 1);
    let (_, series) = run_one(changeable, values, &keys, |_| Ok(Series::new(Seen::Coordinate(0))))?;
    if series.strikes.iter().any(|strike| strike.kind == "stick") {
        return Ok(
            json!({ "reason": "the motion comes to rest on a stop, where it forgets its past: one multiplier is 0" }),
        );
    }
    let machine = matches!(changeable.scene.body, Body::Machine(_));
    let impacts: Vec<&Strike> = series.strikes.iter().filter(|strike| strike.kind == "impact").collect();
    if machine && series.strikes.iter().any(|strike| strike.kind == "touch") && impacts.is_empty() {
        return Ok(json!({ "reason": "the motion meets a stop that gives way: no impacts, and no pattern" }));
    }
    let m = impacts.len();
    let following = |i: usize| {
        let next = impacts[(i + 1) % m].time.period + if i + 1 == m { period as i64 } else { 0 };
        next - impacts[i].time.period
    };
    let pattern: Vec<String> = (0..m).map(|i| following(i).to_string()).collect();
    let start: Vec<String> = impacts
        .iter()
        .flat_map(|strike| {
            let time = document::time(&changeable.scene, strike.time.phase / TAU);
            [time, format!("{:?}", strike.speed.unwrap_or(0.0))]
        })
        .collect();
    let names: Vec<String> = impacts.iter().map(|strike| quoted(&strike.wall)).collect();
    let key = document::stops(&changeable.scene);
    let orbit = if m == 0 {
        let start: Vec<String> = series.last.iter().map(|x| format!("{x:?}")).collect();
        // A machine without impacts needs no start.
        let start = if machine { String::new() } else { format!(", start = [{}]", start.join(", ")) };
        format!("{{ period = {period}{start} }}")
    } else {
        let walls = format!("{key} = [{}]", names.join(", "));
        format!("{{ pattern = [{}], {walls}, start = [{}] }}", pattern.join(", "), start.join(", "))
    };
    let keys = format!("[[tasks]]\nname = \"orbit\"\nkind = \"orbit\"\norbit = {orbit}\n");
    let text = changeable.with(values, &keys)?;
    let scene = Scene::from_toml(&text, &changeable.name)?;
    let report = run_task(&job(&scene, 0, &[])?, &mut ());
    Ok(match finished(&report) {
        Ok(found) => json!({ "report": found, "task": keys }),
        Err(error) => json!({ "reason": error.to_string() }),
    })
}
