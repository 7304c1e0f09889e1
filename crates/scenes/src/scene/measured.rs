//! A measured force: a CSV file of times and forces, as harmonics of the forcing, or as it is, once; and a
//! measured motion of a stop, as harmonics.
//!
//! The harmonics are fitted by least squares, all whole periods of the record on top of one another, each
//! sample weighted by the time that it stands for: of m periods, by that between the m-th samples before and
//! after it. So samples need not be even, and a record of several periods is averaged, also where samples of
//! all of them fall on one phase. What the fit leaves is bounded at the samples by the largest residual; and
//! between them, with the record taken as straight from sample to sample, by that and an eighth of the
//! longest step squared times a bound on the second derivative of the harmonics.
//!
//! A record that is taken once is straight between its samples, which must be even, and no force is left out.
//! What a smooth force was between the samples differs from that by about an eighth of the second
//! differences.

use std::f64::consts::TAU;

use super::{
    expression::Expression,
    keys::{Entry, keys},
    matrix::CoordinateList,
};
use crate::{
    error::Result,
    many::{Load, RealMatrix, RealVector, Record},
    number::Plain,
    output::{SampleColumns, SampleLine, WrongLine, samples},
};

keys! {
    /// A [record of the force](#measured-forces) in a CSV file beside the scene.
    pub struct MeasuredKeys {
        /// its first line names the columns
        file: String,
        /// how many are fitted besides the mean, 1 to 100; this or `once`
        harmonics: Option<u32>,
        /// the record itself, straight between samples, for one `simulate`
        once: bool = "false",
        /// the record's, if not the forcing's: the same force faster or slower
        period: Option<Expression>,
        /// what a force of 1 is on each coordinate
        direction: CoordinateList = "1",
    }
}

keys! {
    /// A [record of a stop's motion](#measured-forces) in a CSV file beside the scene.
    pub struct MeasuredMotionKeys {
        /// its first line names the columns
        file: String,
        /// how many are fitted besides the mean, 1 to 100
        harmonics: u32,
        /// the record's, if not the forcing's: the same motion faster or slower
        period: Option<Expression>,
    }
}

/// A measured force, or a stop's motion, as the scene uses it.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredForce {
    /// The file.
    pub(crate) file: String,
    /// The samples used.
    pub(crate) samples: usize,
    /// The samples beyond the last whole period, which are left out.
    pub(crate) left_out: usize,
    /// Whole periods in the record.
    pub(crate) periods: usize,
    /// The mean, then (cos kt, sin kt) for k = 1, 2, ….
    pub(crate) mean: f64,
    /// The coefficients.
    pub(crate) harmonics: Vec<[f64; 2]>,
    /// The largest difference from a sample.
    pub(crate) residual: f64,
    /// No difference from the record, taken as straight between samples, is larger; of a record taken once,
    /// an eighth of the largest second difference.
    pub(crate) bound: f64,
    /// The record itself, if it is taken once, the step in the scene's unit of time.
    pub(crate) once: Option<Record>,
    /// What a force of 1 is on each coordinate.
    pub(crate) direction: Vec<Expression>,
}

/// Most harmonics.
const HARMONICS: u32 = 100;
/// The longest file, in bytes.
const LONGEST: u64 = 64 << 20;

impl MeasuredForce {
    /// Reads a record that is taken once.
    pub(super) fn once(file: &Entry, keys: &MeasuredKeys) -> Result<Self> {
        let at = |key: &str| file.at(&format!("system.measured.{key}"));
        for (key, given) in [("harmonics", keys.harmonics.is_some()), ("period", keys.period.is_some())] {
            if given {
                return Err(
                    at(key).fail("stands beside `once`: the record is taken as it is, and not periodic")
                );
            }
        }
        let place = at("file");
        let (beside, text) = place.beside(&keys.file, LONGEST)?;
        let wrong =
            |(line, message): WrongLine| place.fail(&format!("{}:{line}: {message}", beside.display()));
        let samples = record(&text, "force").map_err(wrong)?;
        let step = even(&samples).map_err(wrong)?;
        let values: Vec<f64> = samples.iter().map(|sample| sample.2).collect();
        let bend = values.windows(3).map(|three| (three[0] - 2.0 * three[1] + three[2]).abs());
        Ok(MeasuredForce {
            file: keys.file.clone(),
            samples: values.len(),
            left_out: 0,
            periods: 0,
            mean: 0.0,
            harmonics: Vec::new(),
            residual: 0.0,
            bound: bend.fold(0.0, f64::max) / 8.0,
            once: Some(Record::new(step, values)?),
            direction: Vec::new(),
        })
    }

    /// What a force of 1 is on each of so many coordinates.
    pub(super) fn directed(file: &Entry, keys: CoordinateList, points: usize) -> Result<Vec<Expression>> {
        let place = file.at("system.measured.direction");
        let direction = keys.fit(&place, points)?;
        if direction.is_empty() {
            return Err(place.fail("is zero: the force would act on nothing"));
        }
        Ok(direction)
    }

    /// Reads and fits a record; `period` is the forcing's, `points` the number of coordinates.
    pub(super) fn new(file: &Entry, keys: MeasuredKeys, period: &Expression, points: usize) -> Result<Self> {
        let direction = MeasuredForce::directed(file, keys.direction, points)?;
        let Some(harmonics) = keys.harmonics else {
            let message = "has neither `harmonics` nor once = true: give one of them";
            return Err(file.at("system.measured").fail(message));
        };
        let own = keys.period.as_ref();
        let fitted = fitted(file, "system.measured", (&keys.file, "force"), harmonics, (own, period))?;
        Ok(MeasuredForce { direction, ..fitted })
    }

    /// The mean and the harmonics on all coordinates.
    pub(super) fn loads(&self, names: &[String]) -> Result<(Vec<Expression>, Vec<Load<Expression>>)> {
        let times = |factor: f64| {
            let one = |direction: &Expression| {
                let mut all = Expression::parse(&format!("({direction})*({factor:e})"), names)?;
                all.key.clone_from(&direction.key);
                Ok(all)
            };
            self.direction.iter().map(one).collect::<Result<Vec<_>>>()
        };
        let load = |(k, [cos, sin]): (u32, &[f64; 2])| Ok(Load { k, cos: times(*cos)?, sin: times(*sin)? });
        Ok((times(self.mean)?, (1..).zip(&self.harmonics).map(load).collect::<Result<_>>()?))
    }
}

/// Reads a record from a column of a file and fits it; the period is its own, or the forcing's.
pub(super) fn fitted(
    file: &Entry,
    path: &str,
    (name, column): (&str, &str),
    harmonics: u32,
    (own, forcing): (Option<&Expression>, &Expression),
) -> Result<MeasuredForce> {
    let at = |key: &str| file.at(&format!("{path}.{key}"));
    let given = own.unwrap_or(forcing);
    if given.mentions(&|_| true) {
        let place = if own.is_some() { at("period") } else { at("file") };
        return Err(place.fail(
            "has a period that depends on parameters: give `period`, a number, the period of the record",
        ));
    }
    let period = given.evaluate(&[], &()).map(|Plain(period)| period);
    let period = period.map_err(|error| at("period").fail(&error.to_string()))?;
    if !(period > 0.0 && period.is_finite()) {
        return Err(at("period").fail("must be positive"));
    }
    if !(1..=HARMONICS).contains(&harmonics) {
        return Err(at("harmonics").fail(&format!("is outside 1 to {HARMONICS}")));
    }
    let place = at("file");
    let (beside, text) = place.beside(name, LONGEST)?;
    let wrong = |(line, message): WrongLine| place.fail(&format!("{}:{line}: {message}", beside.display()));
    let record = record(&text, column).map_err(wrong)?;
    let fitted = fit(&record, period, harmonics as usize).map_err(wrong)?;
    Ok(MeasuredForce { file: name.to_string(), ..fitted })
}

/// What steps of an even record may differ by, relative to a step.
const EVEN: f64 = 1e-3;

/// The step of an even record.
fn even(record: &[SampleLine]) -> std::result::Result<f64, WrongLine> {
    let mut steps: Vec<f64> = record.windows(2).map(|pair| pair[1].1 - pair[0].1).collect();
    steps.sort_by(f64::total_cmp);
    let usual = steps[steps.len() / 2];
    for pair in record.windows(2) {
        let own = pair[1].1 - pair[0].1;
        if (own - usual).abs() > EVEN * usual {
            let message = format!(
                "comes {own} after the sample before, where the record's step is {usual}: a record that is taken once has even \
                 samples and no gap; resample it"
            );
            return Err((pair[1].0, message));
        }
    }
    Ok((record[record.len() - 1].1 - record[0].1) / (record.len() - 1) as f64)
}

/// The samples of a column of a file, by time.
fn record(text: &str, value: &str) -> std::result::Result<Vec<SampleLine>, WrongLine> {
    samples(text, &|names| {
        let column = |name: &str| {
            let found = names.iter().position(|known| known == name);
            found.ok_or_else(|| {
                let here = names.join(", ");
                format!("has no column {name:?}: the first line names the columns, as in time,{value}; here are {here}")
            })
        };
        Ok(SampleColumns { time: column("time")?, value: column(value)?, named: true })
    })
}

/// Harmonics that leave more than this share of the record's variation do not stand for it: more than half of
/// the power is elsewhere.
const UNTOLD: f64 = 0.5;

/// The share of a record's variation, the mean square in time about its mean, that a model leaves: of all of
/// the record, what lies beyond its whole periods too. 0 for a record that is constant, up to rounding.
fn untold(record: &[SampleLine], model: impl Fn(f64) -> f64) -> f64 {
    let time = |i: usize| record[i.min(record.len() - 1)].1;
    let weight = |i: usize| (time(i + 1) - time(i.saturating_sub(1))) / 2.0;
    let over = |value: &dyn Fn(f64, f64) -> f64| {
        let all = (0..record.len()).map(|i| weight(i) * value(record[i].1, record[i].2));
        all.sum::<f64>() / (0..record.len()).map(weight).sum::<f64>()
    };
    let mean = over(&|_, force| force);
    let variation = over(&|_, force| (force - mean).powi(2));
    let rounding = 4.0 * f64::EPSILON * record.iter().fold(0.0, |most: f64, sample| most.max(sample.2.abs()));
    if variation <= rounding * rounding {
        return 0.0;
    }
    over(&|t, force| (force - model(t)).powi(2)) / variation
}

/// 1, cos t, sin t, cos 2t, …
fn terms(phase: f64, count: usize) -> Vec<f64> {
    let mut row = vec![1.0];
    for k in 1..=count {
        let (sin, cos) = (k as f64 * phase).sin_cos();
        row.extend([cos, sin]);
    }
    row
}

/// The mean and the coefficients of the harmonics that suit samples best, which are ordered by phase; each
/// counts for its share of the period. Of several periods the next sample of the same one is, about, as many
/// samples on: phases that are one up to rounding share their time.
fn least_squares(folded: &[(f64, f64, usize)], count: usize, periods: usize) -> Option<RealVector> {
    let (n, size) = (folded.len(), 2 * count + 1);
    let (mut matrix, mut right) = (RealMatrix::zeros(size, size), RealVector::zeros(size));
    let turned = |i: usize| folded[i % n].0 + TAU * (i / n) as f64;
    for (i, &(phase, force, _)) in folded.iter().enumerate() {
        let weight = (turned(n + i + periods) - turned(n + i - periods)) / (2 * periods) as f64;
        let row = terms(phase, count);
        for (a, x) in row.iter().enumerate() {
            right[a] += weight * x * force;
            for (b, y) in row[..=a].iter().enumerate() {
                matrix[(a, b)] += weight * x * y;
            }
        }
    }
    let solved = matrix.cholesky()?.solve(&right);
    solved.iter().all(|x| x.is_finite()).then_some(solved)
}

/// The harmonics of a record with this period.
fn fit(record: &[SampleLine], period: f64, count: usize) -> std::result::Result<MeasuredForce, WrongLine> {
    let (first, last) = (record[0].1, record[record.len() - 1].1);
    let mut steps: Vec<f64> = record.windows(2).map(|pair| pair[1].1 - pair[0].1).collect();
    steps.sort_by(f64::total_cmp);
    let step = steps[steps.len() / 2];
    // A last sample one step before the end of a period ends it, give or take half a step.
    let periods = ((last - first + 1.5 * step) / period + 1e-9).floor();
    if periods < 1.0 {
        let share = (last - first + step) / period;
        let message = format!(
            "the record covers {share:.4} of the period {period}: it must cover a whole one; check the unit of time"
        );
        return Err((record[record.len() - 1].0, message));
    }
    let end = first + periods * period - 1e-6 * step;
    let used = &record[..record.partition_point(|sample| sample.1 < end)];
    // Phases of all periods on top of one another, with the line before each gap.
    let phase = |t: f64| (t / period).rem_euclid(1.0) * TAU;
    let mut folded: Vec<(f64, f64, usize)> = used.iter().map(|&(line, t, f)| (phase(t), f, line)).collect();
    folded.sort_by(|a, b| a.0.total_cmp(&b.0));
    let n = folded.len();
    let gap = |i: usize| {
        let next = if i + 1 == n { folded[0].0 + TAU } else { folded[i + 1].0 };
        next - folded[i].0
    };
    let widest = (0..n).max_by(|&i, &j| gap(i).total_cmp(&gap(j))).unwrap_or(0);
    // Two samples in every period of the highest harmonic, at the least.
    if count as f64 * gap(widest) >= TAU / 2.0 * (1.0 - 1e-9) {
        let most = ((TAU / 2.0 * (1.0 - 1e-9)) / gap(widest)).ceil() - 1.0;
        let message = format!(
            "after this line {:.4} of the period has no sample, so that {most} harmonics can be told and not {count}: \
             fill the gap or lower `harmonics`",
            gap(widest) / TAU
        );
        return Err((folded[widest].2, message));
    }
    let solved = least_squares(&folded, count, periods.min(n as f64) as usize).ok_or_else(|| {
        (folded[widest].2, format!("{count} harmonics cannot be told from these samples: lower `harmonics`"))
    })?;
    let harmonics: Vec<[f64; 2]> = (0..count).map(|k| [solved[2 * k + 1], solved[2 * k + 2]]).collect();
    let model = |phase: f64| terms(phase, count).iter().zip(solved.iter()).map(|(x, c)| x * c).sum::<f64>();
    let residual = folded.iter().map(|&(phase, force, _)| (force - model(phase)).abs()).fold(0.0, f64::max);
    let untold = untold(record, |t| model(phase(t)));
    if untold > UNTOLD {
        let most = record.iter().map(|sample| (sample.2 - solved[0]).abs()).fold(0.0, f64::max);
        let message = format!(
            "{count} harmonics of the period {period} leave {:.0} % of the record's variation: up to {residual:.4} of {most:.4}. \
             Either {period} is not the period of the record (give `period`), or more `harmonics` are needed",
            100.0 * untold
        );
        return Err((used[0].0, message));
    }
    // Straight lines over the longest step of the record.
    let longest = used.windows(2).map(|pair| pair[1].1 - pair[0].1).fold(0.0, f64::max) * TAU / period;
    let bend: f64 = (1..).zip(&harmonics).map(|(k, [cos, sin])| f64::from(k * k) * cos.hypot(*sin)).sum();
    Ok(MeasuredForce {
        file: String::new(),
        samples: used.len(),
        left_out: record.len() - used.len(),
        periods: periods as usize,
        mean: solved[0],
        harmonics,
        residual,
        bound: residual + longest * longest / 8.0 * bend,
        once: None,
        direction: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(phase: f64) -> f64 {
        0.5 + 2.0 * phase.cos() - phase.sin() + 0.25 * (3.0 * phase).sin()
    }

    /// Samples of it at these times, with period 0.02.
    fn samples(times: impl Iterator<Item = f64>) -> Vec<SampleLine> {
        times.enumerate().map(|(i, t)| (i + 2, t, force(TAU * t / 0.02))).collect()
    }

    fn assert_known(fitted: &MeasuredForce) {
        let expected = [[2.0, -1.0], [0.0, 0.0], [0.0, 0.25]];
        assert!((fitted.mean - 0.5).abs() < 1e-12, "{fitted:?}");
        for (found, known) in fitted.harmonics.iter().zip(expected) {
            assert!((found[0] - known[0]).abs().max((found[1] - known[1]).abs()) < 1e-12, "{fitted:?}");
        }
        assert!(fitted.residual < 1e-12 && fitted.bound > fitted.residual);
    }

    /// Even, uneven, over several periods, with the end of the period or without it, from any phase on.
    #[test]
    fn harmonics_are_found_however_they_are_sampled() {
        let even = samples((0..40).map(|i| 0.0005 * f64::from(i)));
        let fitted = fit(&even, 0.02, 3).unwrap();
        assert_eq!((fitted.samples, fitted.left_out, fitted.periods), (40, 0, 1));
        assert_known(&fitted);
        let closed = fit(&samples((0..=40).map(|i| 0.0005 * f64::from(i))), 0.02, 3).unwrap();
        assert_eq!((closed.samples, closed.left_out), (40, 1));
        assert_known(&closed);
        let uneven = samples((0..70).map(|i| 0.013 + 0.0007 * f64::from(i) + 0.0003 * f64::from(i).sin()));
        let fitted = fit(&uneven, 0.02, 3).unwrap();
        assert_eq!(fitted.periods, 2);
        assert!(fitted.left_out > 10, "{fitted:?}");
        assert_known(&fitted);
    }

    /// Also where samples of all of them have one phase up to rounding. Each period is off by its own
    /// constant; the sum of these is 0.
    #[test]
    fn periods_on_top_of_one_another_are_averaged() {
        let off = [3.0, -1.0, -4.0, 1.0, 5.0, -9.0, 2.0, 3.0];
        for per_period in [40, 231] {
            let record: Vec<SampleLine> = (0..8 * per_period)
                .map(|i| {
                    let t = 0.02 * i as f64 / per_period as f64;
                    (i + 2, t, force(TAU * t / 0.02) + off[i / per_period] / 8.0)
                })
                .collect();
            let fitted = fit(&record, 0.02, 3).unwrap();
            assert_known(&MeasuredForce { residual: 0.0, ..fitted.clone() });
            assert!((fitted.residual - 1.125).abs() < 1e-9, "{fitted:?}");
        }
    }

    /// Between samples the harmonics are within the bound of the straight lines.
    #[test]
    fn the_bound_holds_between_samples() {
        let rough: Vec<SampleLine> = (0..60)
            .map(|i| (i, 0.02 * i as f64 / 60.0, force(TAU * i as f64 / 60.0) + 0.1 * (i as f64 * 7.7).sin()))
            .collect();
        let fitted = fit(&rough, 0.02, 4).unwrap();
        assert!(fitted.residual > 0.05, "{fitted:?}");
        let model = |phase: f64| {
            let harmonic = |(k, [cos, sin]): (u32, &[f64; 2])| {
                let angle = f64::from(k) * phase;
                cos * angle.cos() + sin * angle.sin()
            };
            fitted.mean + (1..).zip(&fitted.harmonics).map(harmonic).sum::<f64>()
        };
        let mut worst = 0.0f64;
        for pair in rough.windows(2) {
            for part in 0..=10 {
                let x = f64::from(part) / 10.0;
                let line = pair[0].2 * (1.0 - x) + pair[1].2 * x;
                let t = pair[0].1 * (1.0 - x) + pair[1].1 * x;
                worst = worst.max((line - model(TAU * t / 0.02)).abs());
            }
        }
        assert!(worst >= fitted.residual * (1.0 - 1e-9) && worst <= fitted.bound, "{worst} {fitted:?}");
    }

    /// A force of 80 N, whatever its mean and unit, is told from one folded at a period that is not its own.
    #[test]
    fn a_record_folded_at_a_wrong_period_is_refused() {
        let record = |own: f64, mean: f64, unit: f64| -> Vec<SampleLine> {
            let force =
                |t: f64| unit * (mean + 80.0 * (TAU * t / own).cos() + 8.0 * (2.0 * TAU * t / own).sin());
            (0..2000).map(|i| (i + 2, 1e-4 * i as f64, force(1e-4 * i as f64))).collect()
        };
        for (mean, unit) in [(0.0, 1.0), (1e4, 1.0), (0.0, 2f64.powi(-60)), (-3.0, 2f64.powi(60))] {
            assert!(
                fit(&record(0.02, mean, unit), 0.02, 3).unwrap().residual < 1e-9 * unit * (1.0 + mean.abs())
            );
            // Twice the period is a period; there are harmonics of it.
            assert!(fit(&record(0.02, mean, unit), 0.04, 4).is_ok());
            for wrong in [0.013, 0.0231, 0.017, 0.01, 0.028] {
                let (line, message) = fit(&record(0.02, mean, unit), wrong, 3).unwrap_err();
                assert!(
                    line == 2 && message.contains("is not the period of the record"),
                    "{wrong}: {message}"
                );
            }
        }
        // What lies beyond the whole periods tells, too: of one period there are no two to compare.
        let short = &record(0.02, 0.0, 1.0)[..200];
        assert!(fit(short, 0.02, 3).is_ok());
        let (_, message) = fit(short, 0.013, 3).unwrap_err();
        assert!(message.contains("is not the period of the record"), "{message}");
        // A constant force has no variation, and harmonics that are 0.
        let flat: Vec<SampleLine> = (0..50).map(|i| (i + 2, 0.001 * i as f64, 0.1)).collect();
        assert!(fit(&flat, 0.02, 3).unwrap().residual < 1e-14);
    }

    #[test]
    fn a_record_taken_once_is_even() {
        let even_step = |steps: &[f64]| {
            let mut t = 0.3;
            let mut all = vec![(2, t, 0.0)];
            for (i, step) in steps.iter().enumerate() {
                t += step;
                all.push((i + 3, t, 1.0));
            }
            even(&all)
        };
        assert!((even_step(&[0.1, 0.100_01, 0.099_99, 0.1]).unwrap() - 0.1).abs() < 1e-12);
        for (steps, line) in [(&[0.1, 0.1, 0.2, 0.1], 5), (&[0.1, 0.1, 0.1, 0.1003], 6)] {
            let (found, message) = even_step(steps).unwrap_err();
            assert!(found == line && message.contains("resample it"), "{found}: {message}");
        }
    }

    #[test]
    fn what_is_wrong_with_a_record_is_said() {
        let rows = |n: usize, step: f64| -> String {
            (0..n).map(|i| format!("{},{}\n", step * i as f64, (i as f64).sin())).collect()
        };
        for (text, expected) in [
            (String::new(), "holds no samples"),
            ("t,force\n0,1\n".into(), "has no column \"time\""),
            ("time;kraft\n0;1\n".into(), "has no column \"force\""),
            ("time,force\n0,1\n".into(), "has 1 samples"),
            ("time,force\n0,1\n0.1,2\n0.1,3\n".into(), "stands in line 3, too"),
            ("time,force\n0,1\n0.2,2\n0.1,3\n".into(), "sort the lines by time"),
            ("time,force\n0,1\n0.1,NaN\n".into(), "is not a finite number"),
            ("time,force\n0,1\n0.1\n".into(), "has 1 cells"),
            ("time;force\n0;1,5\n".into(), "written with a point"),
            (format!("time,force\n{}", rows(30, 0.0005)), "covers 0.7500 of the period"),
            (format!("time,force\n{}", rows(8, 0.0025)), "3 harmonics can be told and not 6"),
            (format!("time,force\n{}", rows(4000, 0.00051)), "is not the period of the record"),
        ] {
            let found = record(&text, "force").and_then(|record| fit(&record, 0.02, 6)).unwrap_err();
            assert!(found.1.contains(expected), "{text:?}: {found:?}");
        }
        // Other separators, another order, other columns, comments.
        for text in [
            "# a shaker\ntime\tforce\n0\t1\n1\t2\n2\t3\n",
            "Force; Note; Time\n1; a; 0\n2; b; 1\n3; c; 2\n",
            "\u{feff}time force\r\n0 1\r\n1 2\r\n2 3\r\n",
        ] {
            let found: Vec<(f64, f64)> =
                record(text, "force").unwrap().iter().map(|row| (row.1, row.2)).collect();
            assert_eq!(found, [(0.0, 1.0), (1.0, 2.0), (2.0, 3.0)], "{text:?}");
        }
    }
}
