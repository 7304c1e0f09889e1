//! Machines with one stop, each followed beside its touch and before it by a task `grazing`: what is seen,
//! for the picture that tells it from what is born.

use std::f64::consts::PI;

use crate::{
    error::{Error, Result},
    monitor::Monitor,
    run::{BandRow, Findings, GrazingFindings, GrazingReport, Surroundings, run},
    scene::Scene,
};

/// A machine beside its touch.
#[derive(Debug, Clone, PartialEq)]
pub struct TouchSample {
    /// The frequency of its free vibration, over that of the drive; below 1.
    pub ratio: f64,
    /// What is left of a free vibration after a period of the drive.
    pub remains: f64,
    /// What is seen just before the touch.
    pub before: Sight,
    /// Just beyond it.
    pub beyond: Sight,
    /// The drive, over that at the touch, below which no motion was found that hits for ever: 1 where none
    /// was found before the touch.
    pub free: f64,
    /// The drive, over it, from which on a motion begun at rest is seen to hit for ever.
    pub from_rest: Option<f64>,
}

/// What is seen beside a touch.
#[derive(Debug, Clone, PartialEq)]
pub struct Sight {
    /// What the motion does: it `stays`, `jumps` or is `lost`.
    pub what: String,
    /// What it comes to, in words; none if it leaves every bound.
    pub motion: Option<String>,
    /// The least and the greatest displacement there, the stop being at 1 and the free motion going to −1.
    pub extent: Option<[f64; 2]>,
}

/// Of every machine of the samples.
pub const RESTITUTION: f64 = 0.8;

/// The samples: 0.04, 0.14, …, 0.94 across, and 0.15, 0.35, 0.55, 0.88 up. Cost: some millions of periods.
///
/// # Errors
/// Those of a task `grazing`; the monitor's.
pub fn touch_samples(monitor: &dyn Monitor) -> Result<Vec<TouchSample>> {
    let mut all = Vec::new();
    for remains in [0.15, 0.35, 0.55, 0.88] {
        for column in 0..10 {
            all.push(sample(0.04 + 0.1 * f64::from(column), remains, monitor)?);
            monitor.advance(1)?;
        }
    }
    Ok(all)
}

/// q″ + cq′ + kq = F cos t below a stop at 1.
fn sample(ratio: f64, remains: f64, monitor: &dyn Monitor) -> Result<TouchSample> {
    let damping = -remains.ln() / PI;
    let stiffness = ratio * ratio + damping * damping / 4.0;
    let scene = format!(
        "format = \"grazing-scene 3\"\ntitle = \"a machine\"\n[parameters]\nF = 1\n[system]\ndamping = {damping:?}\n\
         stiffness = {stiffness:?}\nforcing = [{{ cos = \"F\" }}]\n[[stops]]\nname = \"stop\"\nside = \"upper\"\noffset = 1\n\
         restitution = {RESTITUTION:?}\n[[tasks]]\nname = \"touch\"\nkind = \"grazing\"\nparameter = \"F\"\nmax_period = 1\n\
         range = false\n"
    );
    let scene = Scene::from_toml(&scene, "machine.toml")?;
    let around = Surroundings { monitor, ..Surroundings::default() };
    let report = run(&scene, around, &mut ())?.pop();
    monitor.advance(0)?;
    let status = report.as_ref().map_or_else(String::new, |report| format!("{:?}", report.status));
    let found = match report.and_then(|report| report.findings) {
        Some(Findings::Grazing(found)) => match *found {
            GrazingFindings::Found(found) => Some(*found),
            GrazingFindings::Nothing { .. } => None,
        },
        _ => None,
    };
    let sample = found.and_then(|found| told(&found, [ratio, remains]));
    sample.ok_or_else(|| Error::input(format!("nothing is seen at ({ratio}, {remains}): {status}")))
}

fn told(found: &GrazingReport, [ratio, remains]: [f64; 2]) -> Option<TouchSample> {
    let (seen, bands) = (found.seen.as_ref()?, found.bands.as_ref()?);
    let sight = |place: &str| {
        let row = seen.iter().find(|row| row.place == place)?;
        let extent = row.extent.as_ref().and_then(|ends| Some([*ends.first()?, *ends.get(1)?]));
        Some(Sight { what: row.what.clone(), motion: row.motion.clone(), extent })
    };
    let band = |name: &str| bands.iter().find(|row| row.band == name);
    let from_rest = band("depends").and_then(|row: &BandRow| row.from_rest);
    Some(TouchSample {
        ratio,
        remains,
        before: sight("before")?,
        beyond: sight("beyond")?,
        free: band("free").map_or(Some(0.0), |row| row.most_part)?,
        from_rest: from_rest.map(|value| value / found.at.parameter),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// README's machine, whose numbers are tested with its scene.
    #[test]
    fn a_machine_jumps_and_a_strongly_damped_one_stays() {
        let TouchSample { before, beyond, free, from_rest, .. } =
            sample(0.297_5_f64.sqrt(), (-0.1 * PI).exp(), &()).unwrap();
        assert_eq!([before.what, beyond.what], ["stays", "jumps"]);
        let [low, high] = beyond.extent.unwrap();
        assert!((-6.63..-6.60).contains(&low) && (high - 1.0).abs() < 1e-9);
        assert!((free - 0.7402).abs() < 1e-4 && (from_rest.unwrap() - 0.8549).abs() < 1e-4);
        let damped = sample(0.05, 0.1, &()).unwrap();
        assert_eq!((damped.beyond.what.as_str(), damped.free, damped.from_rest), ("stays", 1.0, None));
    }
}
