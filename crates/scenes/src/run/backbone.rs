//! The backbone curve of a task `response`: how far the free machine swings at each value's frequency, and
//! where that curve ends. It is of the machine without damping, drive and friction, whatever these are.

use super::{Job, row};
use crate::{
    error::{Error, Result},
    many::Machine,
    motion::{AmplitudeEnd, Vibrations},
    rounding::PLACE,
    scene::response::ResponseTask,
};

row! {
    /// A point of the backbone curve.
    pub struct BackboneRow {
        /// The parameter's value.
        pub value: f64,
        /// Half of the way from the least to the greatest displacement of the free vibration.
        pub swing: f64,
        /// The coordinate.
        pub coordinate: String,
        /// The mode that the vibration grows from, counted from 1.
        pub mode: usize,
        /// What it has above the machine at rest; absent of one coordinate.
        pub energy: Option<f64>,
    }
}

row! {
    /// Where the backbone curve ends.
    pub struct BackboneEndRow {
        /// The parameter's value.
        pub value: f64,
        /// What the swing tends to there; absent where it grows without end.
        pub swing: Option<f64>,
        /// `range`: at a bound of the range; `natural frequency`: as slow or fast as vibrations of no swing
        /// are, or of all up to this one; `hill`: beyond it forces do not lead back; `largest swings`: as
        /// slow or fast as those become; `turns back`: two swings become one. Of several coordinates also
        /// `stop`: a rigid one is met; `linear`: all swings have this frequency; `points`, `lost`: it was
        /// followed no farther.
        pub why: &'static str,
        /// The coordinate.
        pub coordinate: String,
        /// The mode.
        pub mode: usize,
    }
}

/// The curve, its ends, and why it has no points.
#[derive(Default)]
pub(super) struct Backbone {
    pub rows: Option<Vec<BackboneRow>>,
    pub ends: Option<Vec<BackboneEndRow>>,
    pub why: Option<String>,
}

/// A machine at a value, and the coefficient of what is cubic beside it.
type AtValue<'a> = &'a dyn Fn(f64) -> Result<(Machine<f64>, f64)>;

/// How often the step between two values is halved in which the curve ends.
const HALVINGS: u32 = 45;

impl BackboneRow {
    /// Of the only coordinate.
    fn new(value: f64, swing: f64) -> BackboneRow {
        BackboneRow { value, swing, coordinate: "q".into(), mode: 1, energy: None }
    }
}

impl BackboneEndRow {
    fn new(value: f64, swing: Option<f64>, why: &'static str) -> BackboneEndRow {
        BackboneEndRow { value, swing, why, coordinate: "q".into(), mode: 1 }
    }
}

/// The curve over the values, which ascend. Cost: some hundred vibrations for each value, fifty times that
/// for each end.
///
/// # Errors
/// Those of the machine at a value; an input error where all forces lead away from q = 0; an interruption.
pub(super) fn backbone(task: &ResponseTask, job: &Job, values: &[f64], at: AtValue) -> Result<Backbone> {
    let look = |value: f64, located: bool| -> Result<Option<Vibrations>> {
        job.check()?;
        let (machine, cubic) = at(value)?;
        let (free, factor) = machine.conservative(cubic)?;
        if free.leads_away() {
            return Err(Error::input(format!(
                "backbone = true: at {} = {value} all forces lead away from q = 0, and a backbone is of vibrations about a \
                 place of rest there: leave it out",
                task.parameter
            )));
        }
        let scaled = |mut found: Vibrations| {
            found.swings.iter_mut().for_each(|swing| *swing *= factor);
            found.ends.iter_mut().filter_map(|end| end.swing.as_mut()).for_each(|swing| *swing *= factor);
            found
        };
        Ok(free.vibrations(task.harmonic, located).map(scaled))
    };
    let count = |found: &Option<Vibrations>| found.as_ref().map_or(0, |found| found.swings.len());
    let all = values.iter().map(|value| look(*value, true)).collect::<Result<Vec<_>>>()?;
    let swings = |i: usize| all[i].iter().flat_map(|found| found.swings.iter().copied());
    let rows: Vec<BackboneRow> = (0..values.len())
        .flat_map(|i| swings(i).map(move |swing| BackboneRow::new(values[i], swing)))
        .collect();
    let bound = |i: usize| swings(i).map(move |swing| BackboneEndRow::new(values[i], Some(swing), "range"));
    let mut ends: Vec<BackboneEndRow> = bound(0).collect();
    for i in 1..values.len() {
        let [mut low, mut high] = [(values[i - 1], all[i - 1].clone()), (values[i], all[i].clone())];
        let before = count(&low.1);
        if before == count(&high.1) {
            continue;
        }
        for _ in 0..HALVINGS {
            let middle = low.0 + (high.0 - low.0) / 2.0;
            let here = look(middle, false)?;
            let end = if count(&here) == before { &mut low } else { &mut high };
            *end = (middle, here);
        }
        let (more, less) = if before > count(&high.1) { (low, high) } else { (high, low) };
        ends.extend(look(more.0, true)?.and_then(|found| end(more.0, &found, less.1.as_ref())));
    }
    ends.extend(bound(values.len() - 1));
    let why = rows.is_empty().then(|| no_points(&all));
    Ok(Backbone { rows: Some(rows), ends: Some(ends), why })
}

/// The end of the curve beside a value, from what there is on either side of it: `more` swings than at
/// another.
fn end(value: f64, more: &Vibrations, less: Option<&Vibrations>) -> Option<BackboneEndRow> {
    let passed = less.and_then(|less| {
        let other = |why| less.ends.iter().filter(move |end| end.why == why);
        let before = |i: usize, why| more.ends[..i].iter().filter(|end| end.why == why).count();
        let all = more.ends.iter().enumerate();
        let passes = |(i, end): &(usize, &AmplitudeEnd)| {
            other(end.why).nth(before(*i, end.why)).is_some_and(|other| other.faster != end.faster)
        };
        all.filter(passes).map(|(_, end)| end).next()
    });
    let swings = more.swings.iter().copied();
    let (why, swing) = match passed {
        // A swing that is next to nothing is on its way to that.
        Some(end) if end.why == "natural frequency" => {
            let linear = swings.clone().next().filter(|_| end.swing > Some(0.0));
            (end.why, Some(linear.unwrap_or(0.0)))
        }
        Some(end) => (end.why, end.swing),
        None => {
            let apart = |pair: &&[f64]| pair[1] - pair[0];
            let two = more.swings.windows(2).min_by(|a, b| apart(a).total_cmp(&apart(b)));
            ("turns back", Some(two.map_or(swings.clone().next()?, |two| two[0] + (two[1] - two[0]) / 2.0)))
        }
    };
    Some(BackboneEndRow::new(value, swing, why))
}

/// Why there is no vibration at any value.
fn no_points(all: &[Option<Vibrations>]) -> String {
    let Some(known) = all.iter().flatten().next() else {
        return "there is no place of rest to swing about".into();
    };
    let same = |[least, most]: [f64; 2]| most - least <= PLACE * most;
    let rates = || all.iter().flatten().map(|found| found.rates);
    let word = match () {
        () if rates().all(same) => {
            "free vibrations of all swings have one frequency, as those of a linear spring"
        }
        () if rates().all(|rates| rates[0] > 1.0) => "free vibrations are faster at every value",
        () if rates().all(|rates| rates[1] < 1.0) => "free vibrations are slower at every value",
        () => "no free vibration has that frequency at any of the values",
    };
    let [least, most] = known.rates;
    format!("{word}: at the first from {least:.6} to {most:.6} times what is asked for")
}
