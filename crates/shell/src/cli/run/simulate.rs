//! The files of tasks of kind `simulate`, written as the motion goes on: memory does not grow with its
//! length.

use std::{f64::consts::TAU, io::Write};

use super::Job;
use crate::{
    error::{Error, Result},
    figure::{self, FigurePlace, MotionPicture},
    printable::csv_field,
    run::{Findings, Keeper, SeriesOf, SeriesPoint, SeriesStop, StopEvent, TaskReport, run_task},
};

/// Most stops for each of which there is a picture.
const PICTURES: usize = 8;

pub(super) fn run(job: &Job) -> TaskReport {
    let mut report = None;
    let name = |end: &str| format!("{}{end}", job.task.name);
    // What fails or is interrupted leaves no files: they are whole or absent.
    let written = job.write(&name(".csv"), |series| {
        job.write(&name("-events.csv"), |events| {
            let found = run_task(job.job, &mut Series::new(job, series, events));
            let whole = found.findings.is_some();
            report = Some(found);
            if whole { Ok(()) } else { Err(Error::input("the task failed")) }
        })
    });
    match (report, written) {
        (Some(report), Ok(())) => report,
        (Some(report), Err(_)) if report.findings.is_none() => report,
        (_, Err(error)) => TaskReport::failed(job.job, &error),
        (None, Ok(())) => TaskReport::failed(job.job, &Error::input("the task was not run")),
    }
}

/// The series and the events as CSV, and pictures of both: of a motion with one displacement that between its
/// stops, else the gap to each stop.
struct Series<'a> {
    job: &'a Job<'a>,
    /// The period, in the scene's unit of time.
    period: f64,
    stops: Vec<SeriesStop>,
    /// The names of all places where something happens.
    places: Vec<String>,
    drawn: Drawn,
    series: &'a mut dyn Write,
    events: &'a mut dyn Write,
}

/// What is drawn.
enum Drawn {
    Displacement(MotionPicture),
    Gaps(Vec<MotionPicture>),
}

impl<'a> Series<'a> {
    fn new(job: &'a Job<'a>, series: &'a mut dyn Write, events: &'a mut dyn Write) -> Self {
        let (stops, places, drawn) = (Vec::new(), Vec::new(), Drawn::Gaps(Vec::new()));
        Series { job, period: f64::NAN, stops, places, drawn, series, events }
    }
}

impl Drawn {
    fn new(of: &SeriesOf, title: &str) -> Drawn {
        let picture = |title: &str, walls| MotionPicture::new(title, of.begin, of.span, walls);
        if of.points == 1 && of.stops.iter().all(|stop| stop.along.is_some()) {
            return Drawn::Displacement(picture(title, of.stops.len()));
        }
        let gap = |stop: &SeriesStop| picture(&format!("{title}: “{}”", stop.name), 1).of("gap");
        Drawn::Gaps(of.stops.iter().take(PICTURES).map(gap).collect())
    }

    fn pictures(&self) -> &[MotionPicture] {
        match self {
            Drawn::Displacement(picture) => std::slice::from_ref(picture),
            Drawn::Gaps(pictures) => pictures,
        }
    }
}

/// The names of so many columns: with numbers, if there are several.
fn names(letter: &str, count: usize) -> String {
    match count {
        1 => format!(",{letter}"),
        _ => (1..=count).map(|i| format!(",{letter}{i}")).collect(),
    }
}

impl Keeper for Series<'_> {
    fn begin(&mut self, of: &SeriesOf) -> Result<()> {
        let [q, u] = ["q", "u"].map(|letter| names(letter, of.points));
        writeln!(self.series, "time,periods{q}{u}{}", names("gap", of.stops.len()))?;
        let columns = "event,time,period,phase,stop,velocity,impulse,radius,gap,rest,together,order_matters,duration,force,energy";
        writeln!(self.events, "{columns}")?;
        (self.period, self.stops, self.places) = (of.period, of.stops.clone(), of.places());
        self.drawn = Drawn::new(of, &self.job.scene.title);
        Ok(())
    }

    fn sample(&mut self, sample: &SeriesPoint) -> Result<()> {
        let at = sample.time.periods();
        let gaps = sample.gaps.iter().map(|[gap, _]| *gap);
        write!(self.series, "{},{at}", at * self.period)?;
        for x in sample.q.iter().chain(sample.u).copied().chain(gaps.clone()) {
            write!(self.series, ",{x}")?;
        }
        match &mut self.drawn {
            Drawn::Displacement(picture) => {
                let q = sample.q[0];
                let place = |(gap, stop): (f64, &SeriesStop)| q - gap / stop.along.unwrap_or(1.0);
                picture.point(at, q, &gaps.zip(&self.stops).map(place).collect::<Vec<_>>());
            }
            Drawn::Gaps(pictures) => {
                for (picture, gap) in pictures.iter_mut().zip(gaps) {
                    picture.point(at, gap, &[0.0]);
                }
            }
        }
        Ok(writeln!(self.series)?)
    }

    fn event(&mut self, event: &StopEvent) -> Result<()> {
        let periods = event.time.periods();
        if event.velocity.is_some() {
            match &mut self.drawn {
                Drawn::Displacement(picture) => {
                    event.place.iter().for_each(|[place, _]| picture.impact(periods, *place));
                }
                Drawn::Gaps(pictures) => {
                    pictures.get_mut(event.stop).into_iter().for_each(|one| one.impact(periods, 0.0));
                }
            }
        }
        let shown = |x: Option<f64>| x.map_or(String::new(), |x| x.to_string());
        let (word, time, period) = (event.event, periods * self.period, event.time.period);
        let (phase, name) = (event.time.phase / TAU, csv_field(&self.places[event.stop]));
        write!(self.events, "{word},{time},{period},{phase},{name}")?;
        for x in [event.velocity, event.impulse, event.radius, event.gap, event.rest] {
            write!(self.events, ",{}", shown(x))?;
        }
        let together = event.together.map_or(String::new(), |count| count.to_string());
        let order = event.order_matters.map_or("", |matters| if matters { "yes" } else { "no" });
        let [duration, force, energy] = [event.duration, event.force, event.energy].map(shown);
        Ok(writeln!(self.events, ",{together},{order},{duration},{force},{energy}")?)
    }

    fn keep(&mut self, _: &crate::run::Job, _: &Findings) -> Result<Vec<String>> {
        let name = &self.job.task.name;
        let mut files = [".csv", "-events.csv"].map(|end| format!("{name}{end}")).to_vec();
        for (i, picture) in (1..).zip(self.drawn.pictures()) {
            let name = if i == 1 { name.clone() } else { format!("{name}-{i}") };
            figure::motion(picture, &FigurePlace { name: &name, ..self.job.place() })?;
            files.push(format!("{name}.{}", self.job.format.ending()));
        }
        Ok(files)
    }
}
