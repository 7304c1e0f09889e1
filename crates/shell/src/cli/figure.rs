//! `grazing figure`: the project's figures, each with its data beside it.

use std::{
    collections::HashMap,
    f64::consts::PI,
    path::{Path, PathBuf},
};

use clap::{Parser, ValueEnum};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::{
    Outcome,
    place::{self, Asked, AskedPoint, Place},
    run::{paper, scene_with, setting},
    view::ViewArgs,
};
use crate::{
    certificate,
    cli::progress::{Interrupt, Progress},
    error::{Error, Result},
    figure::{self, FigurePlace, MachinePicture, PictureFormat},
    motion::{Contact, Time},
    number::{parse_integer, parse_rational},
    one::simulate::{Event, Settings, Simulator},
    output::{Destination, FileRegistry, FileUse, make_folder, say_to},
    scene::{Kind, Scene},
    search::{
        attractor::{AttractorProblem, prove_attractor},
        chaos::{Problem, prove},
        cover::{Cover, CoverOptions, certificate as assemble, cover},
    },
    study,
    tolerance::ParameterBox,
};

/// Draw a figure as SVG, with its data as CSV beside it.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written; 3: interrupted.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing figure intervals 9 -o figures
  grazing figure records --r 0.993 --s 0.205 -o figures
  grazing figure machine examples/machines/two-masses.toml -o figures
  grazing figure tolerance --frequency 12.3Hz±1% --damping-ratio 0.02±20% --drive 10Hz -o figures")]
pub(super) struct Args {
    /// Which figure.
    #[arg(value_enum)]
    figure: Figure,
    /// The largest period shown, for 5 the only one; by default 15, for entropy 40, for tips 200, for 5 8,
    /// for coexistence 10000. For gaps how many windows, by default 5. For machine the scene.
    #[arg(value_name = "N|SCENE")]
    n: Option<String>,
    /// As it was written once.
    #[arg(long = "n", hide = true, conflicts_with = "n", value_name = "N", value_parser = parse_integer::<u64>)]
    long_n: Option<u64>,
    /// For machine, give a parameter of the scene another value; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting)]
    set: Vec<(String, String)>,
    #[command(flatten)]
    place: Place,
    #[command(flatten)]
    view: ViewArgs,
    /// The folder for the files, or the picture's file: NAME.svg, NAME.pdf or NAME.png, its data in NAME.csv.
    ///
    /// PDF and PNG need a program built with the feature `print`.
    #[arg(short, long, value_name = "DIR|FILE", default_value = ".")]
    output: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Figure {
    /// The five regions of the (a1, a2) plane.
    #[value(name = "2")]
    Regions,
    /// Single-impact orbits of period 15 in regions 1, 2 and 5.
    #[value(name = "3")]
    Orbits,
    /// The iterate boundaries b_{n,k} = 0 that bound areas, n = 3 to N.
    #[value(name = "4")]
    Iterate,
    /// The areas where orbits of period N exist, from a proved cover.
    #[value(name = "5")]
    Areas,
    /// Branches of the non-impacting and the single-impact orbits of section 4.2 over mu.
    #[value(name = "6")]
    Branches,
    /// The attractor of section 4.2 between mu_gr4 and mu_cr, with the branch of period 4.
    #[value(name = "7")]
    Diagram,
    /// Attractors before the grazing bifurcation of section 4.2, mu = -0.05.
    #[value(name = "8")]
    Before,
    /// Attractors near it, mu = -0.024.
    #[value(name = "9")]
    Near,
    /// The attractor after it, mu = 0.003.
    #[value(name = "10")]
    After,
    /// The boxes of the shift that is proved at mu = 0.003, where legs take them, and the attractor after it.
    Chaos,
    /// Impacts beyond the touch of the paper's oscillator with d = 3/2, w = 8 at mu = 0.01, each with the
    /// next, in the trap that is proved.
    Attractor,
    /// N windows with a stable orbit, and the gaps with chaos between them, proved beyond the touch of that
    /// oscillator with w = 5, over mu.
    Gaps,
    /// Theorem 2's intervals for n = 3 to N.
    Intervals,
    /// The powers of an eigenvalue seen from 1: their records are the periods that exist; by default with
    /// --r 0.993 --s 0.205.
    Records,
    /// The words of the (a1, a2) plane and their entropy, areas of period up to N: where chaos is born.
    Words,
    /// What is born and what is seen beyond a touch and before it: README's picture.
    Touch,
    /// The entropy on r = 1 over s, periods up to N, by default 40.
    Entropy,
    /// How many periods coexist at a random s: at r = 1 up to N by exact cells, at r < 1 by samples.
    Coexistence,
    /// How many first-return times a line has, over s and r up to 3.
    Returns,
    /// The lowest points of all areas beside their law for large n, n = 4 to N.
    Tips,
    /// All machines that tolerances allow, by their words; by default --frequency 12.3Hz±1% --damping-ratio
    /// 0.02±20% --drive 10Hz, and any box that `word` takes.
    Tolerance,
    /// Where a touch gives birth to chaos, over natural / drive frequency and damping ratio; by default
    /// --frequency 0.1..=2.1 --drive 1 --damping-ratio 0.00390625..=0.5.
    Design,
    /// The machine of a scene: masses, springs, dampers, stops, friction, forces; what may be a wrong sign is
    /// red.
    Machine,
}

/// For how many periods the attractor is followed, and how many it is given to settle.
const ATTRACTOR: i64 = 6000;
const SETTLED: i64 = 500;

impl Figure {
    fn name(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_string())
    }

    /// The name of its files, without ending.
    fn file(self) -> String {
        let name = self.name();
        if name.starts_with(|c: char| c.is_ascii_digit()) { format!("figure{name}") } else { name }
    }

    /// Whether N says what it shows.
    fn has_periods(self) -> bool {
        use Figure::*;
        !matches!(
            self,
            Regions
                | Orbits
                | Branches
                | Diagram
                | Before
                | Near
                | After
                | Chaos
                | Attractor
                | Returns
                | Tolerance
                | Design
                | Machine
        )
    }

    fn is_of_a_scene(self) -> bool {
        use Figure::*;
        matches!(self, Branches | Diagram | Before | Near | After)
    }
}

impl Args {
    /// The box that the figure shows, and the names of its parameters; `default` if none is given.
    fn boxed(&self, default: [[&str; 2]; 2]) -> Result<(ParameterBox, [&'static str; 2])> {
        if !self.place.is_given() {
            let ends = |[lower, upper]: [&str; 2]| -> Result<[BigRational; 2]> {
                Ok([parse_rational(lower)?, parse_rational(upper)?])
            };
            let [ratio, damping] = default;
            let of = ParameterBox::machine(ends(ratio)?, ends(damping)?)?;
            return Ok((of, ["ratio", "damping_ratio"]));
        }
        match self.place.asked()? {
            Asked::Box(asked) => Ok((asked.0, asked.1.map(|(name, _)| name))),
            Asked::Point(_) => Err(self.wants("a box: give at least one parameter as an interval")),
        }
    }

    /// r and s of the point that the figure shows.
    fn point(&self) -> Result<[BigRational; 2]> {
        if !self.place.is_given() {
            return Ok([parse_rational("0.993")?, parse_rational("0.205")?]);
        }
        match self.place.asked()? {
            Asked::Point(AskedPoint::Polar(r, s)) => Ok([r, s]),
            Asked::Box(asked) => {
                Err(self.wants(&format!("one point, not {}: give --r and --s", place::shown(&asked.1))))
            }
            Asked::Point(_) => Err(self.wants("a point by --r and --s")),
        }
    }

    /// N, if it is given.
    fn periods(&self) -> Result<Option<u64>> {
        let given = match (&self.n, self.long_n) {
            (Some(_), _) if self.figure == Figure::Machine => return Ok(None),
            (Some(text), _) => Some(parse_integer(text).map_err(|error| Error::from(error).context("N"))?),
            (None, n) => n,
        };
        if given.is_some() && !self.figure.has_periods() {
            return Err(Error::input(format!("figure {} takes no N", self.figure.name())));
        }
        Ok(given)
    }

    /// The scene that the figure shows.
    fn machine(&self, files: &FileRegistry) -> Result<MachinePicture> {
        let scene = self.n.as_ref().ok_or_else(|| self.wants("a scene: give its file"))?;
        MachinePicture::of(&scene_with(Path::new(scene), &self.set, files)?)
    }

    fn wants(&self, what: &str) -> Error {
        Error::input(format!("figure {} shows {what}", self.figure.name()))
    }

    /// Where the files go: `name` is that of the figure, if the output names none.
    fn place<'a>(&'a self, name: &'a str) -> Result<FigurePlace<'a>> {
        if self.output.is_dir() || self.output.extension().is_none() {
            return Ok(FigurePlace { view: self.view.view()?, ..FigurePlace::svg(&self.output, name) });
        }
        let format = PictureFormat::of(&self.output).ok_or_else(|| {
            Error::input(format!(
                "-o {}: pictures are .svg, .pdf or .png; a folder whose name has an ending must be there before",
                self.output.display()
            ))
        })?;
        format.check()?;
        let stem = self.output.file_stem().and_then(|stem| stem.to_str());
        let stem = stem.ok_or_else(|| Error::input(format!("{}: no name", self.output.display())))?;
        if self.figure.is_of_a_scene() && stem != name {
            return Err(Error::input(format!(
                "-o {}: this figure has several files, named after it: write {name}.{}, or a folder",
                self.output.display(),
                format.ending()
            )));
        }
        let folder = self.output.parent().filter(|folder| !folder.as_os_str().is_empty());
        let view = self.view.view()?;
        Ok(FigurePlace { folder: folder.unwrap_or(Path::new(".")), name: stem, format, view })
    }
}

/// A cover of period n up to r = 1 − 2⁻¹⁴, fine enough to be drawn, and proved by the checker.
fn proved_cover(n: u64, progress: &Progress) -> Result<Cover> {
    if !(3..=24).contains(&n) {
        return Err(Error::input(format!("N = {n}: this figure shows one period N, with N from 3 to 24")));
    }
    let r_max = BigRational::one() - BigRational::new(BigInt::one(), BigInt::from(1 << 14));
    let options =
        CoverOptions { r_max: Some(r_max), finest: Some(figure::FINEST), ..CoverOptions::new(n..=n) };
    let found = cover(&options, HashMap::new(), progress, &|_, _| Ok(()))?.pop();
    let interrupted = || Error::interrupted("interrupted before the work was done");
    let found = found.ok_or_else(interrupted)?;
    let block = found.block().ok_or_else(interrupted)?;
    certificate::check(&mut assemble(&options.periods, &[block]).as_bytes())
        .map_err(|rejection| Error::input(format!("the cover of period {n} is not proved: {rejection}")))?;
    Ok(found)
}

/// The shift over {1, 2, 3} of the paper's oscillator for 0 < µ ≤ 0.003, proved, with the impacts of its
/// attractor at µ = 0.003.
fn chaos(place: &FigurePlace, interrupt: &Interrupt) -> Result<()> {
    let scene = Scene::from_toml(study::CHAOS, "nordmark-2001-chaos.toml")?;
    let task = scene.tasks.iter().find_map(|task| match &task.kind {
        Kind::ChaosTask(chaos) if task.name == "figure10" => Some(chaos),
        _ => None,
    });
    let task = task.ok_or_else(|| Error::input("the paper's scene of chaos has no task figure10"))?;
    let normal = task.normal(&scene)?;
    let problem = Problem {
        mirrored: normal.mirrored,
        ranges: normal.ranges,
        behind: normal.behind,
        harmonics: normal.harmonics,
        letters: vec![1, 2, 3],
        next: vec![vec![0, 1, 2]; 3],
    };
    let progress = Progress::new(interrupt, 0, "attempts");
    let proof = prove(&problem, &progress)?
        .map_err(|reasons| Error::input(format!("figure chaos: not proved: {}", reasons.join("; "))))?;
    let system = scene.plain(&[])?;
    let simulator = Simulator::new(&system, &Settings::default())?;
    let mut run = simulator.start(Time::new(0, 0.0), 1.0, 0.0)?;
    let mut impacts = Vec::new();
    let walls = Contact::of(&system)?;
    let wall = walls.first().ok_or_else(|| Error::input("figure chaos: the scene has no wall"))?;
    // The unit of velocities is how far the wall comes beyond the place of rest.
    let [unit, ..] = wall.position.at(0.0);
    while let Event::Impact(impact) = run.next(Time::new(ATTRACTOR, 0.0)) {
        let (t, arriving) = (impact.time.phase, impact.velocity);
        let [_, moving, _] = wall.position.at(t);
        if impact.time.period > SETTLED && t.cos() > 0.0 {
            impacts.push(((moving + arriving) / unit, (moving - wall.restitution * arriving) / unit));
        }
    }
    figure::shift(&problem, &proof, &impacts, place)
}

/// The paper's oscillator with d = 3/2, w = 8 and τ = 4/5 at µ = 1/100.
const OVERDAMPED: &str = "format = \"grazing-scene 3\"\ntitle = \"overdamped\"\n[system]\ndamping = \"3/8\"\n\
                          stiffness = \"1/64\"\n[[stops]]\nside = \"lower\"\noffset = -1\n\
                          harmonics = [{ cos = \"101/100\" }]\nrestitution = \"4/5\"\n";
/// For how many periods its motion is followed.
const TRAPPED: i64 = 10_000;

/// The trap of the overdamped oscillator up to µ = 0.01, proved, with the impacts of a motion there.
fn attractor(place: &FigurePlace, interrupt: &Interrupt) -> Result<()> {
    let exact = |text: &str| parse_rational(text).map(|x| [x.clone(), x]);
    // µ = ν/(1 − ν).
    let depth = 1.0 / 101.0;
    let problem = AttractorProblem {
        ranges: [exact("3/8")?, exact("1/64")?, exact("4/5")?],
        harmonics: vec![(1, [exact("1")?, exact("0")?])],
        deepest: depth,
    };
    let proof = prove_attractor(&problem, &Progress::new(interrupt, 0, "attempts"))?
        .map_err(|why| Error::input(format!("figure attractor: not proved: {why:?}")))?;
    let scene = Scene::from_toml(OVERDAMPED, "overdamped.toml")?;
    let system = scene.plain(&[])?;
    let simulator = Simulator::new(&system, &Settings::default())?;
    let mut run = simulator.start(Time::new(0, 0.0), 1.0, 0.0)?;
    let (mut returns, mut last) = (Vec::new(), None);
    while let Event::Impact(impact) = run.next(Time::new(TRAPPED, 0.0)) {
        // In units of how high the wall's top is above its mean.
        let speed = impact.velocity.abs() / 1.01 / depth.sqrt();
        let period = impact.time.period + i64::from(impact.time.phase > PI);
        if let Some((before, since)) = last.replace((speed, period))
            && since > SETTLED
        {
            returns.push(([before, speed], (period - since).unsigned_abs()));
        }
    }
    figure::trapped(&proof, &returns, place)
}

pub(super) fn run(args: &Args, files: &FileRegistry, interrupt: &Interrupt) -> Result<Outcome> {
    if args.place.is_given() && !matches!(args.figure, Figure::Records | Figure::Tolerance | Figure::Design) {
        return Err(Error::input(
            "a point or a box belongs to `grazing figure records`, `tolerance` and `design`",
        ));
    }
    if !args.figure.is_of_a_scene() && !args.view.is_whole() {
        return Err(Error::input("--x-limits, --y-limits and --q-modulo-2pi belong to the figures 6 to 10"));
    }
    let given = args.periods()?;
    if !args.set.is_empty() && args.figure != Figure::Machine {
        return Err(Error::input("--set belongs to `grazing figure machine`"));
    }
    let file = args.figure.file();
    let place = args.place(&file)?;
    if !args.figure.is_of_a_scene() {
        files.claim("the picture", &place.picture(), FileUse::Write)?;
        files.claim("the picture's data", &place.data(), FileUse::Write)?;
    }
    make_folder(place.folder)?;
    let n = given.unwrap_or(match args.figure {
        Figure::Areas => 8,
        Figure::Tips => 200,
        Figure::Gaps => 5,
        Figure::Entropy => 40,
        Figure::Coexistence => 10_000,
        _ => 15,
    });
    let mut written = vec![place.picture(), place.data()];
    let mut drawn = |task: &str| -> Result<()> {
        written = paper(task, &place, files, interrupt)?;
        Ok(())
    };
    match args.figure {
        Figure::Regions => figure::regions(&place)?,
        Figure::Iterate => figure::iterate_boundaries(n, &place)?,
        Figure::Areas => {
            let cover = proved_cover(n, &Progress::new(interrupt, n + 1, "strips"))?;
            figure::areas(n, &cover, &place)?;
        }
        Figure::Intervals => figure::intervals(n, &place)?,
        Figure::Records => {
            let [r, s] = args.point()?;
            figure::records(&r, &s, n, &place)?;
        }
        Figure::Tolerance => {
            let (of, names) = args.boxed([["1.2177", "1.2423"], ["0.016", "0.024"]])?;
            figure::tolerance(&of, names, &place, &Progress::new(interrupt, 0, "cells"))?;
        }
        Figure::Design => {
            let (of, _) = args.boxed([["0.1", "2.1"], ["0.00390625", "0.5"]])?;
            figure::design(&of, &place, &Progress::new(interrupt, 0, "parts"))?;
        }
        Figure::Words => figure::words(n, &place, &Progress::new(interrupt, n.saturating_sub(2), "periods"))?,
        Figure::Touch => {
            let progress = Progress::new(interrupt, n.saturating_sub(2) + 40, "periods and machines");
            figure::touch(n, &study::touch_samples(&progress)?, &place, &progress)?;
        }
        Figure::Returns => figure::returns(&place, &Progress::new(interrupt, 120, "rows"))?,
        Figure::Coexistence => figure::coexistence(n, &place, &Progress::new(interrupt, 0, "samples"))?,
        Figure::Entropy => figure::entropy(n, &place, &Progress::new(interrupt, 0, "intervals"))?,
        Figure::Tips => figure::tips(n, &place, &Progress::new(interrupt, n.saturating_sub(3), "periods"))?,
        Figure::Branches => drawn("figure6")?,
        Figure::Diagram => drawn("figure7")?,
        Figure::Before => drawn("figure8")?,
        Figure::Near => drawn("figure9")?,
        Figure::After => drawn("figure10")?,
        Figure::Chaos => chaos(&place, interrupt)?,
        Figure::Attractor => attractor(&place, interrupt)?,
        Figure::Gaps => {
            let (stretches, hits) = study::gaps(n, &Progress::new(interrupt, 0, "stretches"))?;
            figure::gaps(study::eigenvalue(), &stretches, &hits, &place)?;
        }
        Figure::Orbits => figure::orbits(&place)?,
        Figure::Machine => figure::machine(&args.machine(files)?, &place)?,
    }
    let written: Vec<String> = written.iter().map(|file| file.display().to_string()).collect();
    let (last, others) = written.split_last().unwrap_or_else(|| unreachable!("a figure has files"));
    Destination::Stdout.write(|out| say_to(out, format_args!("wrote {} and {last}", others.join(", "))))?;
    Ok(Outcome::Done)
}
