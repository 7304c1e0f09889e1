//! The orbits born at a grazing bifurcation, and what the theory predicts of their impact speeds.

use grazing_scenes::{Result, run::run_task, scene::Scene};
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
    // A page of answer has what is proved and what moves the touch, which takes a moment.
    let how = if request.is_set("answer") { "sensitivity = true" } else { "range = false" };
    Ok(format!(
        "[[tasks]]\nname = \"born\"\nkind = \"grazing\"\nparameter = {parameter}\nmax_period = {most}\n{how}\n"
    ))
}

pub fn born(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let most = request.number("max_period", 4, 1..=12)?;
    let parameter = request.text("parameter")?;
    let keys = grazing_keys(request)?;
    let search = |values: &[(String, String)]| -> Result<Value> {
        let text = changeable.with(values, &keys)?;
        let scene = Scene::from_toml(&text, &changeable.name)?;
        finished(&run_task(&job(&scene, 0, &[])?, &mut ()))
    };
    let mut found = search(&request.values());
    // Beyond the grazing there is no motion without impacts to begin with: others of the range may have one.
    if !matches!(&found, Ok(json) if json["parameter"].is_number())
        && let (Ok(from), Ok(to)) = (request.exact("from"), request.exact("to"))
    {
        for i in [0, 8, 4, 2, 6, 1, 7, 3, 5] {
            let values = request.values_with(parameter, &value(&from, &to, i, 9).to_string());
            if let Ok(json) = search(&values)
                && json["parameter"].is_number()
            {
                found = Ok(json);
                break;
            }
        }
    }
    let json = found?;
    let local = local(&json);
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
        "answer": said(&json),
        "sentences": theory::sentences(&json, most),
        "place": theory::place(&json),
        "slopes": predicted,
        "report": json,
    }))
}

/// The sentences of a page of answer, each with its mark.
fn said(report: &Value) -> Vec<&Value> {
    let all = report["sentences"].as_array().map_or(&[][..], Vec::as_slice);
    all.iter().filter(|sentence| sentence["detail"] == false).collect()
}

/// The local map of a grazing's report.
fn local(report: &Value) -> Option<Local> {
    let floats =
        |value: &Value| -> Option<Vec<f64>> { value.as_array()?.iter().map(Value::as_f64).collect() };
    let rows = |value: &Value| -> Option<Vec<Vec<f64>>> { value.as_array()?.iter().map(floats).collect() };
    let (a, b, c) = (rows(&report["A"])?, floats(&report["B"])?, floats(&report["C"])?);
    Some(Local { a, b, c, acceleration: report["acceleration"].as_f64()?, e: report["e"].as_f64()? })
}
