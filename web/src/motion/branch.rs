//! The branch of an orbit that is born at a grazing, and how far the prediction holds along it.

use grazing_scenes::{
    Error, Result,
    run::{Findings, run_task},
    scene::Scene,
};
use serde_json::{Value, json};

use super::{
    document::{self, quoted},
    request::Request,
    task::{finished, job},
};

pub fn branch(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let (from, to) = (request.exact("from")?, request.exact("to")?);
    let (low, high) = if from < to { (from, to) } else { (to, from) };
    let pattern = request.text("pattern")?;
    let (phases, speeds) = (request.floats("phases"), request.floats("speeds"));
    if phases.len() != speeds.len() || phases.is_empty() {
        return Err(Error::input(format!(
            "pattern {pattern}: the orbit's phases and speeds do not fit together"
        )));
    }
    let at =
        request.floats("at").first().copied().ok_or_else(|| Error::input("a branch starts at a value"))?;
    let names: Vec<String> =
        phases.iter().map(|_| request.text("wall").map(quoted)).collect::<Result<_>>()?;
    let start: Vec<String> = phases
        .iter()
        .zip(&speeds)
        .map(|(t, v)| format!("{}, {v:?}", document::time(&changeable.scene, *t)))
        .collect();
    let float =
        |x| document::float(x).ok_or_else(|| Error::input("the ends of the range are finite numbers"));
    let keys = format!(
        "[[tasks]]\nname = \"branch\"\nkind = \"branch\"\nparameter = {}\nrange = [{:?}, {:?}]\nstarts = [{{ at = {at:?}, orbit = \
         {{ pattern = [{pattern}], {} = [{}], start = [{}] }} }}]\n",
        quoted(request.text("parameter")?),
        float(&low)?,
        float(&high)?,
        document::stops(&changeable.scene),
        names.join(", "),
        start.join(", "),
    );
    let text = changeable.with(&request.values(), &keys)?;
    let scene = Scene::from_toml(&text, &changeable.name)?;
    let report = run_task(&job(&scene, 0, &[])?, &mut ());
    let json = finished(&report)?;
    let rows = match &report.findings {
        Some(Findings::Branch(found)) => serde_json::to_value(&found.rows),
        _ => return Err(Error::input("the branch has no findings")),
    }
    .map_err(std::io::Error::other)?;
    let rows = rows.as_array().cloned().unwrap_or_default();
    let slopes = request.floats("slopes");
    let grazing = request.floats("grazing").first().copied();
    let points: Vec<Value> = rows
        .iter()
        .map(|row| {
            json!({
                "parameter": row["parameters"][0],
                "speeds": row["speeds"],
                "stable": row["stable"],
                "admissible": row["admissible"],
                "label": row["label"],
                "multiplier": row["multipliers"][0],
            })
        })
        .collect();
    let valid = grazing.and_then(|grazing| valid_up_to(&points, grazing, at, &slopes));
    Ok(json!({ "points": points, "within_tenth": valid, "report": json, "task": keys }))
}

/// The largest |µ − µ_G| up to which all points of a branch are orbits whose speeds are within a tenth of the
/// predicted ones; from the grazing outwards, on the side on which `at` is. A branch may begin with another
/// impact than the prediction. None without a prediction, or where the nearest point is off.
fn valid_up_to(points: &[Value], grazing: f64, at: f64, slopes: &[f64]) -> Option<f64> {
    let mut near: Vec<(f64, &Value)> = points
        .iter()
        .filter_map(|point| Some(((point["parameter"].as_f64()? - grazing) * (at - grazing).signum(), point)))
        // At the grazing itself there is nothing to compare.
        .filter(|(away, _)| *away > 1e-3 * (at - grazing).abs())
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    let fits = |turn: usize, away: f64, point: &Value| {
        let speeds = point["speeds"].as_array().map_or(&[][..], Vec::as_slice);
        let predicted = slopes.iter().cycle().skip(turn).map(|slope| slope * away);
        let close = |(speed, predicted): (&Value, f64)| {
            speed.as_f64().is_some_and(|speed| (speed - predicted).abs() <= 0.1 * speed.abs())
        };
        point["admissible"] == true && speeds.len() == slopes.len() && speeds.iter().zip(predicted).all(close)
    };
    let reach = |turn: usize| {
        let fitting = near.iter().take_while(|(away, point)| fits(turn, *away, point));
        fitting.last().map(|(away, _)| *away)
    };
    (0..slopes.len()).filter_map(reach).max_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Speeds 3x and 5x at x = ±0.1, ±0.2, …, ±0.5, but for the first at ±0.4, which is a quarter more.
    fn points(sign: f64) -> Vec<Value> {
        let point = |i: u32| {
            let x = f64::from(i) / 10.0;
            let off = if i == 4 { 1.25 } else { 1.0 };
            json!({ "parameter": 7.0 + sign * x, "speeds": [3.0 * x * off, 5.0 * x], "admissible": true })
        };
        (1..=5).rev().map(point).collect()
    }

    #[test]
    fn the_prediction_holds_up_to_the_last_point_before_one_that_is_off() {
        for sign in [1.0, -1.0] {
            let (points, at) = (points(sign), 7.0 + sign * 0.01);
            let up_to = |slopes: &[f64]| valid_up_to(&points, 7.0, at, slopes);
            // In the order of the branch, or beginning with the other impact.
            for slopes in [[3.0, 5.0], [5.0, 3.0]] {
                assert!((up_to(&slopes).unwrap() - 0.3).abs() < 1e-12);
            }
            assert!((up_to(&[3.2, 5.2]).unwrap() - 0.3).abs() < 1e-12);
            for slopes in [&[3.0, 6.0][..], &[3.0], &[3.0, 5.0, 3.0], &[]] {
                assert_eq!(up_to(slopes), None, "{slopes:?}");
            }
            // On the other side of the grazing there is no point.
            assert_eq!(valid_up_to(&points, 7.0, 7.0 - sign * 0.01, &[3.0, 5.0]), None);
        }
    }

    #[test]
    fn a_point_that_is_no_orbit_ends_it() {
        let mut points = points(1.0);
        points[3]["admissible"] = json!(false);
        assert!((valid_up_to(&points, 7.0, 7.01, &[3.0, 5.0]).unwrap() - 0.1).abs() < 1e-12);
        points[4]["admissible"] = json!("marginal");
        assert_eq!(valid_up_to(&points, 7.0, 7.01, &[3.0, 5.0]), None);
    }
}
