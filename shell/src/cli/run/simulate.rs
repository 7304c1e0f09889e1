//! The files of tasks of kind `simulate`, written as the motion goes on: memory does not grow with its
//! length.

use std::io::Write;

use super::{Job, machine::MachineSeries};
use crate::{
    error::{Error, Result},
    figure::{self, MotionPicture},
    motion::{Contact, State, Time},
    one::simulate::Event,
    run::{Findings, Keeper, Model, TaskReport, run_task},
    scene::simulate::SimulateTask,
};

pub(super) fn run(task: &SimulateTask, job: &Job) -> TaskReport {
    let mut report = None;
    let name = |end: &str| format!("{}{end}", job.task.name);
    // What fails or is interrupted leaves no files: they are whole or absent.
    let written = job.write(&name(".csv"), |series| {
        job.write(&name("-events.csv"), |events| {
            let found = match &job.model {
                Model::Oscillator(_) => run_task(job.job, &mut Series::new(task, job, series, events)?),
                Model::Machine(machine) => {
                    run_task(job.job, &mut MachineSeries::new(task, job, machine, series, events)?)
                }
            };
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

/// The series and the events as CSV, and the picture of both.
struct Series<'a> {
    job: &'a Job<'a>,
    walls: Vec<Contact>,
    picture: MotionPicture,
    series: &'a mut dyn Write,
    events: &'a mut dyn Write,
}

impl<'a> Series<'a> {
    fn new(
        task: &SimulateTask,
        job: &'a Job<'a>,
        series: &'a mut dyn Write,
        events: &'a mut dyn Write,
    ) -> Result<Self> {
        let walls = Contact::of(job.system()?)?;
        writeln!(series, "periods,q,u")?;
        writeln!(events, "event,period,phase,side,velocity,radius,gap,rest")?;
        let first = job.scene.state(&task.start)?.t;
        let begin = Time::new(task.transient as i64, first).periods();
        let picture = MotionPicture::new(&job.scene.title, begin, f64::from(task.periods), walls.len());
        Ok(Series { job, walls, picture, series, events })
    }
}

impl Keeper for Series<'_> {
    fn sample(&mut self, time: Time, state: State) -> Result<()> {
        let walls: Vec<f64> = self.walls.iter().map(|wall| wall.position.at(time.phase)[0]).collect();
        let at = time.periods();
        self.picture.point(at, state.q, &walls);
        Ok(writeln!(self.series, "{at},{},{}", state.q, state.u)?)
    }

    fn event(&mut self, event: &Event) -> Result<()> {
        let Some((Time { period, phase }, side)) = event.at() else { return Ok(()) };
        if let (Event::Impact(impact), Some(wall)) = (event, self.walls.iter().find(|wall| wall.side == side))
        {
            self.picture.impact(impact.time.periods(), wall.position.at(phase)[0]);
        }
        let (side, phase) = (side.name(), phase / std::f64::consts::TAU);
        let out = &mut self.events;
        match event {
            Event::Impact(impact) => {
                writeln!(out, "impact,{period},{phase},{side},{},{},,", impact.velocity, impact.radius)
            }
            Event::Tangency(tangency) => {
                writeln!(out, "tangency,{period},{phase},{side},,,{},", tangency.gap)
            }
            Event::Stick(stick) => writeln!(out, "stick,{period},{phase},{side},,,,{}", stick.rest),
            Event::Release(_) => writeln!(out, "release,{period},{phase},{side},,,,"),
            Event::Touch(_) | Event::End(_) => Ok(()),
        }?;
        Ok(())
    }

    fn keep(&mut self, _: &crate::run::Job, _: &Findings) -> Result<Vec<String>> {
        let name = &self.job.task.name;
        figure::motion(&self.picture, &self.job.place())?;
        let mut files = self.job.figure();
        files.push(format!("{name}-events.csv"));
        Ok(files)
    }
}
