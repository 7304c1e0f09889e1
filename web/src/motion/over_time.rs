//! One motion over time, and the speeds of its impacts.

use grazing_scenes::{
    Error, Result,
    scene::{Body, Scene},
};
use serde_json::{Value, json};

use super::{
    request::Request,
    series::{Seen, Series},
    task::{finished, run_one},
};

/// What of a machine is drawn, by its name: `q2`, or `gap NAME`.
fn seen(request: &Request, scene: &Scene) -> Result<Seen> {
    let Body::Machine(_) = scene.body else { return Ok(Seen::Coordinate(0)) };
    let name = request.0["seen"].as_str().unwrap_or("q1");
    let machine = scene.machine(&[])?;
    let stop =
        name.strip_prefix("gap ").and_then(|name| machine.stops.iter().position(|stop| stop.name == name));
    let coordinate = name.strip_prefix('q').and_then(|digits| digits.parse::<usize>().ok());
    match (stop, coordinate) {
        (Some(stop), _) => Ok(Seen::Gap(stop)),
        (None, Some(i)) if (1..=machine.points()).contains(&i) => Ok(Seen::Coordinate(i - 1)),
        _ => Err(Error::input(format!("the machine has no {name:?} to be drawn"))),
    }
}

/// The task of the views over time.
pub fn motion_keys(request: &Request, transient: u64, periods: u64, samples: u64) -> String {
    format!(
        "[[tasks]]\nname = \"motion\"\nkind = \"simulate\"\nstart = {}\ntransient = {transient}\nperiods = {periods}\nsamples = \
         {samples}\n",
        request.start()
    )
}

pub fn motion(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let (periods, samples) =
        (request.number("periods", 12, 1..=2000)?, request.number("samples", 128, 1..=1024)?);
    let keys = motion_keys(request, request.transient()?, periods, samples);
    let seen = seen(request, &changeable.scene)?;
    let (report, series) = run_one(&changeable, &request.values(), &keys, |_| Ok(Series::new(seen)))?;
    let mut found = series.json();
    found["report"] = finished(&report)?;
    Ok(found)
}

pub fn strikes(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let periods = request.number("periods", 40, 1..=2000)?;
    let values = request.values_with(request.text("parameter")?, request.text("value")?);
    let keys = motion_keys(request, request.transient()?, periods, 1);
    let (report, series) = run_one(&changeable, &values, &keys, |_| Ok(Series::new(Seen::Coordinate(0))))?;
    finished(&report)?;
    let speeds: Vec<Option<f64>> = series.impacts().map(|strike| strike.speed).collect();
    Ok(json!({ "speeds": speeds }))
}
