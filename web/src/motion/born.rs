//! The orbits born at a grazing bifurcation, and what the theory predicts of their impact speeds.

use grazing::{
    Result,
    motion::Contact,
    run::run_task,
    scene::{Body, Scene},
};
use serde_json::{Value, json};

use super::{
    attractor::value,
    document::quoted,
    request::Request,
    task::{finished, job},
    theory::{self, Local},
};

pub fn grazing_keys(request: &Request) -> Result<String> {
    let parameter = quoted(request.text("parameter")?);
    let most = request.number("max_period", 4, 1..=12)?;
    Ok(format!(
        "[[tasks]]\nname = \"born\"\nkind = \"grazing\"\nparameter = {parameter}\nmax_period = {most}\n"
    ))
}

pub fn born(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let most = request.number("max_period", 4, 1..=12)?;
    let parameter = request.text("parameter")?;
    let keys = grazing_keys(request)?;
    let search = |values: &[(String, String)]| -> Result<(Scene, Value)> {
        let text = changeable.with(values, &keys)?;
        let scene = Scene::from_toml(&text, &changeable.name)?;
        let json = finished(&run_task(&job(&scene, 0, &[])?, &mut ()))?;
        Ok((scene, json))
    };
    let mut found = search(&request.values());
    // Beyond the grazing there is no motion without impacts to begin with: others of the range may have one.
    if !matches!(&found, Ok((_, json)) if json["parameter"].is_number())
        && let (Ok(from), Ok(to)) = (request.exact("from"), request.exact("to"))
    {
        for i in [0, 8, 4, 2, 6, 1, 7, 3, 5] {
            let values = request.values_with(parameter, &value(&from, &to, i, 9).to_string());
            if let Ok((scene, json)) = search(&values)
                && json["parameter"].is_number()
            {
                found = Ok((scene, json));
                break;
            }
        }
    }
    let (scene, json) = found?;
    let local = local(&scene, &json, parameter)?;
    let predicted: Vec<Value> = json["born"]
        .as_array()
        .map_or(&[][..], Vec::as_slice)
        .iter()
        .map(|row| {
            let periods = row["pattern"].as_str().map(|text| text.split(',').map(str::parse).collect());
            let speeds = match periods {
                Some(Ok(periods)) if !row["coefficient"].is_null() => {
                    local.as_ref().and_then(|local| local.speeds(&Vec::<u64>::clone(&periods)))
                }
                _ => None,
            };
            json!(speeds)
        })
        .collect();
    Ok(json!({
        "sentences": theory::sentences(&json, most),
        "place": theory::place(&json),
        "slopes": predicted,
        "report": json,
    }))
}

/// The local map of a grazing's report.
fn local(scene: &Scene, report: &Value, parameter: &str) -> Result<Option<Local>> {
    let floats =
        |value: &Value| -> Option<Vec<f64>> { value.as_array()?.iter().map(Value::as_f64).collect() };
    let rows = |value: &Value| -> Option<Vec<Vec<f64>>> { value.as_array()?.iter().map(floats).collect() };
    let (Some(acceleration), Some(e), Some(at)) =
        (report["acceleration"].as_f64(), report["e"].as_f64(), report["parameter"].as_f64())
    else {
        return Ok(None);
    };
    if let Body::Machine(_) = scene.body {
        let parts = rows(&report["A"]).zip(floats(&report["B"])).zip(floats(&report["C"]));
        return Ok(parts.map(|((a, b), c)| Local { a, b, c, acceleration, e }));
    }
    let Some(a) = rows(&report["matrix"]) else { return Ok(None) };
    let walls = Contact::of(&scene.plain(&[(parameter, at)])?)?;
    let wall = walls.iter().find(|wall| Some(wall.side.name()) == report["wall"].as_str());
    Ok(wall.map(|wall| {
        let kick = (2.0 * acceleration).sqrt() * (1.0 + wall.restitution);
        Local { a, b: vec![0.0, kick], c: vec![1.0, 0.0], acceleration, e }
    }))
}
