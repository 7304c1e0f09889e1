//! The files of tasks on machines.

use std::io::Write;

use super::Job;
use crate::{
    error::Result,
    figure::{self, FigurePlace, MotionPicture},
    many::{Machine, MachineState, contact::StopContact, simulate::Event},
    motion::Time,
    printable::csv_field,
    run::{Findings, Keeper},
    scene::simulate::SimulateTask,
};

/// Most stops for each of which there is a picture.
const PICTURES: usize = 8;

/// The series and the events of a machine as CSV, and a picture of each gap.
pub(super) struct MachineSeries<'a> {
    job: &'a Job<'a>,
    machine: &'a Machine<f64>,
    contacts: Vec<StopContact>,
    pictures: Vec<MotionPicture>,
    series: &'a mut dyn Write,
    events: &'a mut dyn Write,
}

impl<'a> MachineSeries<'a> {
    pub fn new(
        task: &SimulateTask,
        job: &'a Job<'a>,
        machine: &'a Machine<f64>,
        series: &'a mut dyn Write,
        events: &'a mut dyn Write,
    ) -> Result<Self> {
        let contacts = machine.contacts()?;
        let names =
            |letter: &str, count: usize| -> String { (1..=count).map(|i| format!(",{letter}{i}")).collect() };
        let points = machine.points();
        writeln!(
            series,
            "time,periods{}{}{}",
            names("q", points),
            names("u", points),
            names("gap", contacts.len())
        )?;
        writeln!(
            events,
            "event,time,period,phase,stop,velocity,impulse,radius,gap,rest,together,order_matters"
        )?;
        let begin = job.scene.machine_state(&task.start, machine, "start")?.t / std::f64::consts::TAU;
        let begin = begin + task.transient as f64;
        let picture = |contact: &StopContact| {
            let title = format!("{}: “{}”", job.scene.title, contact.name);
            MotionPicture::new(&title, begin, f64::from(task.periods), 1).of("gap")
        };
        let pictures = contacts.iter().take(PICTURES).map(picture).collect();
        Ok(MachineSeries { job, machine, contacts, pictures, series, events })
    }

    /// The names of the pictures, without their ending.
    fn names(&self) -> Vec<String> {
        let name = &self.job.task.name;
        let one = |i: usize| if i == 1 { name.clone() } else { format!("{name}-{i}") };
        (1..=self.pictures.len()).map(one).collect()
    }
}

impl Keeper for MachineSeries<'_> {
    fn machine_sample(&mut self, time: Time, state: &MachineState) -> Result<()> {
        let (at, rate) = (time.periods(), self.machine.rate());
        write!(self.series, "{},{at}", at * self.machine.period)?;
        for q in &self.machine.seen(&state.q) {
            write!(self.series, ",{q}")?;
        }
        for u in &self.machine.seen(&state.u) {
            write!(self.series, ",{}", u * rate)?;
        }
        let state = MachineState { t: time.phase, ..state.clone() };
        for (i, contact) in self.contacts.iter().enumerate() {
            let [gap, _] = contact.gap(&state);
            write!(self.series, ",{gap}")?;
            if let Some(picture) = self.pictures.get_mut(i) {
                picture.point(at, gap, &[0.0]);
            }
        }
        Ok(writeln!(self.series)?)
    }

    fn machine_event(&mut self, event: &Event) -> Result<()> {
        let Some((time, stop)) = event.at() else { return Ok(()) };
        let (rate, periods) = (self.machine.rate(), time.periods());
        if let (Event::Impact(_) | Event::Touch(_), Some(picture)) = (event, self.pictures.get_mut(stop)) {
            picture.impact(periods, 0.0);
        }
        let (period, phase) = (time.period, time.phase / std::f64::consts::TAU);
        let name = &self.contacts[stop].name;
        let name = csv_field(name);
        let head = |word: &str| format!("{word},{},{period},{phase},{name}", periods * self.machine.period);
        let out = &mut self.events;
        match event {
            Event::Impact(impact) => writeln!(
                out,
                "{},{},{},{},,,{},{}",
                head("impact"),
                impact.velocity * rate,
                impact.shock.impulse / rate,
                impact.radius / rate,
                impact.shock.together,
                if impact.shock.order_matters { "yes" } else { "no" }
            ),
            Event::Touch(touch) => {
                let (velocity, radius) = (touch.velocity * rate, touch.radius / rate);
                writeln!(out, "{},{velocity},,{radius},,,,", head("touch"))
            }
            Event::Tangency(tangency) => writeln!(out, "{},,,,{},,,", head("tangency"), tangency.gap),
            Event::Stick(stick) => writeln!(out, "{},,,,,{},,", head("stick"), stick.rest / rate),
            Event::Release(_) => writeln!(out, "{},,,,,,,", head("release")),
            Event::End(_) => Ok(()),
        }?;
        Ok(())
    }

    fn keep(&mut self, _: &crate::run::Job, _: &Findings) -> Result<Vec<String>> {
        let name = &self.job.task.name;
        let mut files = [".csv", "-events.csv"].map(|end| format!("{name}{end}")).to_vec();
        for (picture, name) in self.pictures.iter().zip(self.names()) {
            figure::motion(picture, &FigurePlace { name: &name, ..self.job.place() })?;
            files.push(format!("{name}.{}", self.job.format.ending()));
        }
        Ok(files)
    }
}
