//! What motions tend to over a parameter.

use grazing_scenes::{
    Error, Result,
    attractor::diagram::Slice,
    num_rational::BigRational,
    run::{Findings, Model, run_task},
    scene::Scene,
};
use serde_json::{Value, json};

use super::{
    document::quoted,
    request::Request,
    section::frame_of,
    task::{finished, job},
};

/// The i-th of `count` evenly spaced values.
pub fn value(from: &BigRational, to: &BigRational, i: u64, count: u64) -> BigRational {
    let part = BigRational::new(i.into(), (count - 1).into());
    from + (to - from) * part
}

pub fn diagram_keys(request: &Request, range: [&BigRational; 2], count: u64) -> Result<String> {
    let points = request.number("points", 200, 1..=20_000)?;
    Ok(format!(
        "[[tasks]]\nname = \"attractor\"\nkind = \"diagram\"\nparameter = {}\nrange = [\"{}\", \"{}\"]\ncount = {count}\nstarts = \
         [{}]\n{}transient = {}\npoints = {points}\n",
        quoted(request.text("parameter")?),
        range[0],
        range[1],
        request.start(),
        request.look(),
        request.transient()?,
    ))
}

pub fn attractor(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let count = request.number("count", 200, 2..=100_000)?;
    let last = request.number("last", count - 1, 0..=count - 1)?;
    let first = request.number("first", 0, 0..=last)?;
    let (from, to) = (request.exact("from")?, request.exact("to")?);
    if from == to {
        return Err(Error::input(format!("from {from} to {to}: the ends are one value")));
    }
    // A task has two values at least.
    let begin = if first == last { first.saturating_sub(1) } else { first };
    let end = if begin == last { last + 1 } else { last };
    let range = [value(&from, &to, begin, count), value(&from, &to, end, count)];
    let keys = diagram_keys(request, [&range[0], &range[1]], end - begin + 1)?;
    let text = changeable.with(&request.values(), &keys)?;
    let scene = Scene::from_toml(&text, &changeable.name)?;
    let job = job(&scene, 0, &[])?;
    let report = run_task(&job, &mut ());
    let json = finished(&report)?;
    let Some(Findings::Diagram(found)) = &report.findings else {
        return Err(Error::input("the diagram has no findings"));
    };
    let name = request.text("parameter")?;
    let slices = found.slices.iter().skip((first - begin) as usize).take((last - first + 1) as usize);
    let slice = |slice: &Slice| -> Result<Value> {
        let frame = match &job.model {
            Model::Oscillator(_) => {
                frame_of(request, &Model::Oscillator(job.scene.plain(&[(name, slice.value)])?))?
            }
            _ => [0.0; 2],
        };
        let motions: Vec<Value> = slice
            .motions
            .iter()
            .map(|motion| {
                let places: Vec<f64> = motion.points.iter().map(|[q, _]| q - frame[0]).collect();
                json!({
                    "period": motion.period,
                    "undecided": motion.undecided,
                    "impacts": motion.impacts,
                    "places": places,
                })
            })
            .collect();
        Ok(json!({ "value": slice.value, "lost": slice.lost, "motions": motions }))
    };
    Ok(json!({ "slices": slices.map(slice).collect::<Result<Vec<_>>>()?, "report": json }))
}
