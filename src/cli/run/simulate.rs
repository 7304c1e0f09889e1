//! Tasks of kind `simulate`: one motion, its impacts and a picture of it.

use std::f64::consts::TAU;

use super::{Job, Report, settings};
use crate::{
    cli::progress::Progress,
    error::Result,
    figure,
    monitor::Monitor,
    oscillator::{
        Time,
        simulate::{End, Event, Simulator},
    },
    output::{Cell, Column, TableFormat, TableWriter, write_file},
    scene::task::Simulate,
};

pub(super) fn run(task: &Simulate, job: &Job, report: &mut Report) -> Result<()> {
    let simulator = Simulator::new(&job.system, &settings(&job.scene))?;
    let start = job.scene.state(&task.start)?;
    let progress = Progress::new(job.interrupt, task.transient + u64::from(task.periods), "periods");
    let mut run = simulator.start(Time::new(0, start.t), start.q, start.u)?;
    let mut end = End::Reached;
    for period in 1..=task.transient {
        progress.advance(1)?;
        end = run.finish(Time::new(period as i64, start.t));
    }
    let first = task.transient as i64;
    let walls: Vec<_> = simulator.contacts().cloned().collect();
    let mut motion = figure::Motion {
        title: job.scene.title.clone(),
        points: Vec::new(),
        walls: vec![Vec::new(); walls.len()],
        impacts: Vec::new(),
    };
    let mut events = Vec::new();
    for sample in 0..=u64::from(task.periods) * u64::from(task.samples) {
        let (period, part) = (sample / u64::from(task.samples), sample % u64::from(task.samples));
        if part == 0 && sample > 0 {
            progress.advance(1)?;
        }
        let until = Time::new(first + period as i64, start.t + TAU * part as f64 / f64::from(task.samples));
        if end == End::Reached {
            end = run.record(until, |event| events.push(event));
        }
        if end != End::Reached {
            break;
        }
        let state = run.state();
        motion.points.push([periods(until), state.q, state.u]);
        for (wall, places) in walls.iter().zip(&mut motion.walls) {
            places.push(wall.position.at(until.phase)[0]);
        }
    }
    for event in &events {
        if let Event::Impact(impact) = event
            && let Some(wall) = walls.iter().find(|wall| wall.side == impact.side)
        {
            motion.impacts.push((periods(impact.time), wall.position.at(impact.time.phase)[0]));
        }
    }
    figure::motion(&motion, job.folder, &job.task.name)?;
    let file = format!("{}-events.csv", job.task.name);
    write_file(&job.folder.join(&file), |out| write_events(&events, out))?;

    let count = |wanted: fn(&Event) -> bool| events.iter().filter(|event| wanted(event)).count();
    report.say("periods", task.periods);
    report.say("impacts", count(|event| matches!(event, Event::Impact(_))));
    report.say("tangencies", count(|event| matches!(event, Event::Tangency(_))));
    report.say("rests", count(|event| matches!(event, Event::Stick(_))));
    if end != End::Reached {
        report.say("ended", super::ended(end));
        report.say("after_periods", periods(run.time()));
    }
    let state = run.state();
    report.say("q", state.q);
    report.say("u", state.u);
    report.say(
        "files",
        [".svg", ".csv"]
            .map(|end| format!("{}{end}", job.task.name))
            .into_iter()
            .chain([file])
            .collect::<Vec<_>>(),
    );
    Ok(())
}

/// Time in forcing periods.
fn periods(time: Time) -> f64 {
    time.period as f64 + time.phase / TAU
}

fn write_events(events: &[Event], out: &mut dyn std::io::Write) -> Result<()> {
    let names = ["event", "period", "phase", "side", "velocity", "radius", "gap", "rest"];
    let columns = names.map(|name| Column::new(name, name, 0));
    let mut table = TableWriter::new(out, TableFormat::Csv, "", columns.to_vec())?;
    for event in events {
        let (name, side, [velocity, radius, gap, rest]) = match event {
            Event::Impact(impact) => {
                ("impact", impact.side, [Some(impact.velocity), Some(impact.radius), None, None])
            }
            Event::Tangency(tangency) => ("tangency", tangency.side, [None, None, Some(tangency.gap), None]),
            Event::Stick(stick) => ("stick", stick.side, [None, None, None, Some(stick.rest)]),
            Event::Release(release) => ("release", release.side, [None; 4]),
            Event::End(_) => continue,
        };
        let Some(time) = event.time() else { continue };
        let phase = time.phase.to_string();
        let numbers = [velocity, radius, gap, rest].map(|x| x.map(|x| x.to_string()));
        let number = |i: usize| numbers[i].as_deref().map_or(Cell::Empty, Cell::Text);
        table.row(&[
            Cell::Text(name),
            Cell::Int(time.period),
            Cell::Text(&phase),
            Cell::Text(side.name()),
            number(0),
            number(1),
            number(2),
            number(3),
        ])?;
    }
    table.finish()
}
