//! Ranges in a machine's parameter beside a wall that has several harmonics, as seen from the motion without
//! it: the orbits that Newton's method finds in the machine's own equations have the phases and the strengths
//! of the certificate, at both ends of its range and between. The wall's top is found by other formulas.

use crate::samples::{one_in, samples};
use std::f64::consts::TAU;

use grazing_scenes::{
    motion::Side,
    number::parse_rational,
    one::orbit::{Itinerary, Oscillator, Strike, find},
    run::{Findings, GrazingFindings, GrazingReport, Job, RangeRow, Surroundings, run_task},
    scene::Scene,
};
use num_traits::ToPrimitive;

/// A machine whose drive F, gap d, damping c and stiffness k are parameters, F times these waves: order,
/// cosine, sine.
#[derive(Clone)]
struct Machine {
    damping: f64,
    stiffness: f64,
    restitution: f64,
    waves: Vec<(f64, f64, f64)>,
    varied: &'static str,
}

impl Machine {
    fn scene(&self, keys: &str) -> Scene {
        let Machine { damping, stiffness, restitution, varied, .. } = self;
        let waves = self.waves.iter();
        let waves = waves.map(|(k, a, b)| format!("{{ k = {k}, cos = \"{a}*F\", sin = \"{b}*F\" }}"));
        let waves = waves.collect::<Vec<_>>().join(", ");
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 0.5\nd = 1\nc = \
             {damping}\nk = {stiffness}\n[system]\ndamping = \"c\"\nstiffness = \"k\"\nforcing = [{waves}]\n[[stops]]\nside = \"upper\"\noffset = \
             \"d\"\nrestitution = {restitution}\n[[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \
             \"{varied}\"\nmax_period = 1\nseen = false\n{keys}\n"
        );
        Scene::from_toml(&text, "harmonics.toml").unwrap_or_else(|error| panic!("{error}"))
    }

    fn found(&self, keys: &str) -> GrazingReport {
        let scene = self.scene(keys);
        let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
        match run_task(&job, &mut ()).findings {
            Some(Findings::Grazing(found)) => match *found {
                GrazingFindings::Found(found) => *found,
                nothing => panic!("{nothing:?}"),
            },
            other => panic!("{other:?}"),
        }
    }

    /// The motion without the stop, or a derivative of it, for F = 1.
    fn free(&self, t: f64, derivative: i32) -> f64 {
        let term = |(j, a, b): &(f64, f64, f64)| {
            let (d, e) = (self.stiffness - j * j, self.damping * j);
            let square = d * d + e * e;
            // (a - ib)/(d + ie) in front of i^n j^n e^{ijt}.
            let (re, im) = ((a * d - b * e) / square, -(b * d + a * e) / square);
            let turn = j * t + f64::from(derivative) * TAU / 4.0;
            j.powi(derivative) * (re * turn.cos() - im * turn.sin())
        };
        self.waves.iter().map(term).sum()
    }

    /// The phase of its highest place.
    fn top(&self) -> f64 {
        let phases = (0..100_000).map(|i| TAU * f64::from(i) / 1e5);
        let highest = phases.max_by(|s, t| self.free(*s, 0).total_cmp(&self.free(*t, 0))).unwrap();
        (0..20).fold(highest, |t, _| t - self.free(t, 1) / self.free(t, 2))
    }

    /// The machine at a value of the parameter, and F and d.
    fn values(&self, value: f64) -> (Machine, [f64; 2]) {
        let mut machine = self.clone();
        let mut drive = [0.5, 1.0];
        match self.varied {
            "F" => drive[0] = value,
            "d" => drive[1] = value,
            "c" => machine.damping = value,
            _ => machine.stiffness = value,
        }
        (machine, drive)
    }

    fn oscillator(&self, [force, gap]: [f64; 2]) -> Oscillator {
        let all = [("F", force), ("d", gap), ("c", self.damping), ("k", self.stiffness)];
        Oscillator::new(self.scene("").plain(&all).unwrap(), 1e-13).unwrap()
    }

    /// E₁₁, E₁₂, E₂₁, E₂₂.
    fn flow(&self, t: f64) -> [f64; 4] {
        let (c, k) = (self.damping, self.stiffness);
        let omega = (k - c * c / 4.0).sqrt();
        let decay = (-c * t / 2.0).exp();
        let b = decay * (omega * t).sin() / omega;
        let a = decay * (omega * t).cos() + c / 2.0 * b;
        [a, b, -k * b, a - c * b]
    }
}

/// A certificate's letters, edges and cells: depths, and the strengths of each edge.
struct Claim {
    periods: Vec<u64>,
    edges: Vec<[usize; 2]>,
    cells: Vec<(f64, Vec<[f64; 2]>)>,
    window: f64,
}

fn float(word: &str) -> f64 {
    parse_rational(word).unwrap().to_f64().unwrap()
}

impl Claim {
    fn of(text: &str) -> Claim {
        let named = |name: &str| -> Vec<Vec<f64>> {
            let rest = |line: &str| {
                Some(line.strip_prefix(name)?.strip_prefix(' ')?.split(' ').map(float).collect())
            };
            text.lines().filter_map(rest).collect()
        };
        let next = named("next");
        let of = |u: usize| next[u].iter().map(move |v| [u, *v as usize - 1]).collect::<Vec<_>>();
        let edges: Vec<[usize; 2]> = (0..next.len()).flat_map(of).collect();
        let strengths: Vec<[f64; 2]> = named("edge").iter().map(|line| [line[0], line[1]]).collect();
        let depths = named("cell").into_iter().map(|line| line[0]);
        Claim {
            periods: named("letter").iter().map(|line| line[0] as u64).collect(),
            cells: depths.zip(strengths.chunks(edges.len()).map(<[_]>::to_vec)).collect(),
            edges,
            window: named("window")[0][0],
        }
    }
}

/// The orbit of a word of letters at a value of the parameter lies in the certificate's ranges.
fn confirm(machine: &Machine, row: &RangeRow, claim: &Claim, value: f64, word: &[usize]) {
    let side = if row.side == "beyond" { 1.0 } else { -1.0 };
    let (machine, [force, gap]) = machine.values(value);
    let (top, m) = (machine.top(), word.len());
    let height = force * machine.free(top, 0);
    let depth = side * (1.0 - gap / height);
    let what = format!("{} {word:?} at {value}, depth {depth}", row.side);
    assert!(depth > 0.0 && depth <= float(row.depth.as_ref().unwrap()) * (1.0 + 1e-9), "{what}");
    let cell = claim.cells.iter().find(|(most, _)| depth <= most * (1.0 + 1e-9)).unwrap();
    let edge = |i: usize| {
        let ends = [word[(i + m - 1) % m], word[i]];
        cell.1[claim.edges.iter().position(|edge| *edge == ends).unwrap()]
    };
    // About where it is: phases from the strengths' middles, by g'' alone, and speeds from the legs.
    let bend = machine.free(top, 2) / machine.free(top, 0);
    let middle: Vec<f64> = (0..m).map(|i| edge(i).iter().sum::<f64>() / 2.0).collect();
    let phase: Vec<f64> = middle.iter().map(|s| depth * s / 2.0 / bend).collect();
    let place = |t: f64| side - (1.0 - force * machine.free(top + t, 0) / height) / depth;
    let arriving = |i: usize| {
        let before = (i + m - 1) % m;
        let time = TAU * claim.periods[word[before]] as f64 + phase[i] - phase[before];
        let [e11, e12, e21, e22] = machine.flow(time);
        let a = (place(phase[i]) - e11 * place(phase[before])) / e12;
        middle[i] / 2.0 - e21 * place(phase[before]) - e22 * a
    };
    let start = (0..m).flat_map(|i| [top + phase[i], depth * height * arriving(i)]).collect();
    let strike = |&v: &usize| Strike { place: Side::Upper, periods: claim.periods[v] as u32 };
    let oscillator = machine.oscillator([force, gap]);
    let orbit = find(&oscillator, &Itinerary::new(word.iter().map(strike).collect()).unwrap(), start)
        .unwrap_or_else(|error| panic!("{what}: {error}"));
    assert!(orbit.admissibility.is_admissible(), "{what}: {orbit:?}");
    for (i, z) in orbit.z.chunks(2).enumerate() {
        let t = (z[0] - top + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
        let s = 2.0 * force * machine.free(top + t, 1) / height / depth;
        let [lo, hi] = edge(i);
        let room = 1e-7 / depth.min(1.0);
        assert!(lo - room <= s && s <= hi + room && t.abs() < claim.window, "{what}: {s} not in {lo}, {hi}");
    }
}

/// The orbit of one impact at a value of the parameter is one, and stable where that is said, which is told:
/// its phase by the law of impact, its multipliers from the machine's own equations.
fn confirm_single(machine: &Machine, row: &RangeRow, value: f64) -> bool {
    let side = if row.side == "beyond" { 1.0 } else { -1.0 };
    let (machine, [force, gap]) = machine.values(value);
    let (top, n) = (machine.top(), row.periods[0]);
    let height = force * machine.free(top, 0);
    let depth = side * (1.0 - gap / height);
    let what = format!("{} {n} at {value}, depth {depth}", row.side);
    let [e11, e12, e21, e22] = machine.flow(TAU * n as f64);
    let after = (1.0 - e11) / e12;
    let before = e21 + e22 * after;
    let law = (1.0 + machine.restitution) / (after + machine.restitution * before);
    let g = |t: f64, derivative: i32| force * machine.free(top + t, derivative) / height;
    let at = |t: f64| side * (1.0 - g(t, 0) + law * g(t, 1)) - depth;
    let way = -side * law.signum();
    let [mut lo, mut hi] = [0.0, 1e-6];
    while at(way * hi) < 0.0 {
        (lo, hi) = (hi, 1.002 * hi);
        assert!(hi < 3.2, "{what}");
    }
    for _ in 0..80 {
        let middle = (lo + hi) / 2.0;
        if at(way * middle) < 0.0 { lo = middle } else { hi = middle }
    }
    let t = way * lo;
    let speed = height * g(t, 1) * (1.0 - before * law);
    let strike = Strike { place: Side::Upper, periods: n as u32 };
    let oscillator = machine.oscillator([force, gap]);
    let orbit = find(&oscillator, &Itinerary::new(vec![strike]).unwrap(), vec![top + t, speed])
        .unwrap_or_else(|error| panic!("{what}: {error}"));
    assert!(orbit.admissibility.is_admissible(), "{what}: {orbit:?}");
    let moved = (orbit.z[0] - top - t + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
    assert!(moved.abs() < 1e-6, "{what}: {moved}");
    let stable = orbit.multipliers.is_stable();
    let inside = |from: f64, to: f64| (from - value) * (to - value) <= 0.0;
    for part in &row.stability {
        let from = part.from.as_ref().or(row.touch.as_ref()).map(|text| float(text)).unwrap();
        if inside(from, float(&part.to)) {
            assert_eq!(part.word == "stable", stable, "{what}: {part:?}, {:?}", orbit.multipliers);
        }
    }
    stable
}

/// How many orbits of one and two impacts are confirmed of all ranges that are proved, in each of their
/// cells.
fn confirmed(machine: &Machine, found: &GrazingReport) -> usize {
    let mut count = 0;
    for row in found.range.iter().flatten().filter(|row| row.verdict == "proved") {
        let [touch, end] = [&row.touch, &row.end].map(|text| float(text.as_ref().unwrap()));
        // The gap is the top there.
        let (there, [force, gap]) = machine.values(touch);
        assert!((force * there.free(there.top(), 0) / gap - 1.0).abs() < 1e-12, "{row:?}");
        let mut cells: Vec<(f64, f64, &str, &str)> = Vec::new();
        for cell in &row.cells {
            let from = cell.from.as_ref().map_or(touch, |from| float(from));
            assert_eq!(from, cells.last().map_or(touch, |cell| cell.1), "a cell begins where one ends");
            cells.push((from, float(&cell.to), cell.certificate.as_ref().unwrap(), &cell.depth));
        }
        if cells.is_empty() {
            cells.push((touch, end, row.certificate.as_ref().unwrap(), row.depth.as_ref().unwrap()));
        }
        assert_eq!(cells.last().unwrap().1, end);
        for (from, to, file, depth) in cells {
            let text = found.certificates.iter().find(|one| one.file == *file).unwrap().accepted.text();
            // What the machine is stands around what its oscillator does.
            let (_, text) = text.rsplit_once("\nkind ").unwrap();
            let row = RangeRow { depth: Some(depth.into()), ..row.clone() };
            count += confirmed_cell(machine, &row, [from, to], text);
        }
    }
    count
}

/// The same of one certificate.
fn confirmed_cell(machine: &Machine, row: &RangeRow, [from, to]: [f64; 2], text: &str) -> usize {
    let mut count = 0;
    // The machines of the range are the certificate's, to what is rounded outwards.
    for at in [from, to] {
        let (there, _) = machine.values(at);
        for (name, value) in [("damping ", there.damping), ("stiffness ", there.stiffness)] {
            let line = text.lines().find_map(|line| line.strip_prefix(name)).unwrap();
            let [lo, hi] = [0, 1].map(|i| float(line.split(' ').nth(i).unwrap()));
            assert!(lo - 1e-15 <= value && value <= hi + 1e-15, "{name}{value}: {line}");
        }
    }
    if row.of == "orbit" {
        // Not next to a fold, which steps of the phase here would pass.
        for share in [0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99] {
            confirm_single(machine, row, from + share * (to - from));
            count += 1;
        }
        return count;
    }
    let claim = Claim::of(text);
    let follows = |u: usize, v: usize| claim.edges.contains(&[u, v]);
    let all = 0..claim.periods.len();
    let pairs = all.clone().flat_map(|u| all.clone().map(move |v| vec![u, v]));
    let words = pairs.map(|word| if word[0] == word[1] { vec![word[0]] } else { word });
    let words =
        words.filter(|word| follows(word[0], word[word.len() - 1]) && follows(word[word.len() - 1], word[0]));
    for word in words {
        for share in [0.01, 0.5, 1.0] {
            confirm(machine, row, &claim, from + share * (to - from), &word);
            count += 1;
        }
    }
    count
}

#[test]
fn orbits_beside_walls_of_several_harmonics_are_in_their_ranges() {
    let two = vec![(1.0, 1.0, 0.0), (2.0, 0.2, 0.1)];
    let three = vec![(1.0, 1.0, -0.3), (2.0, 0.5, 0.4), (3.0, -0.2, 0.3)];
    for (damping, stiffness, restitution, waves, varied, least) in [
        (0.1, 0.3, 0.8, &two, "F", 10),
        (0.1, 0.3, 0.8, &two, "d", 10),
        (0.1, 0.2, 0.8, &two, "F", 3),
        (0.3, 0.05, 0.9, &three, "F", 3),
    ]
    .into_iter()
    .step_by(one_in(4))
    {
        let machine = Machine { damping, stiffness, restitution, waves: waves.clone(), varied };
        let found = machine.found("reach = 3\nrange = { effort = 10000 }");
        assert_eq!(found.range_open, None);
        let count = confirmed(&machine, &found);
        println!("{damping} {stiffness} {varied}: {count} orbits");
        assert!(count >= least, "{count}: {:?}", found.range);
    }
}

/// A parameter that moves damping or stiffness: of each value another machine, all of which are the
/// certificate's.
#[test]
fn machines_that_change_with_the_parameter_have_ranges() {
    let all = [(1.0, 0.3, 0.55, "c", 40), (1.4, 0.1, 0.28, "k", 200)];
    for (force, damping, stiffness, varied, least) in all.into_iter().take(samples(1)) {
        let waves = vec![(1.0, force, 0.0)];
        let machine = Machine { damping, stiffness, restitution: 0.8, waves, varied };
        let found = machine.found("reach = 3\nrange = { effort = 30000 }");
        assert_eq!(found.range_open, None);
        let rows: Vec<_> = found.range.iter().flatten().collect();
        assert!(rows.iter().all(|row| row.verdict != "undecided"), "{rows:?}");
        let count = confirmed(&machine, &found);
        for row in &rows {
            let part = 100.0 * row.share.unwrap_or(0.0);
            println!(
                "{varied}: {}, {} {:?}, {part:.1} %, {} cells",
                row.side,
                row.of,
                row.periods,
                row.cells.len()
            );
            for cell in &row.cells {
                println!("    to {} (nu {}), {}", cell.to, cell.depth, row.reason.as_deref().unwrap_or(""));
            }
        }
        println!("{varied}: {count} orbits");
        assert!(count >= least, "{count}: {rows:?}");
        for row in rows {
            // Several certificates reach farther than one.
            let [touch, first, end] = [&row.touch, &row.cells.first().map(|cell| cell.to.clone()), &row.end]
                .map(|text| float(text.as_ref().unwrap()));
            assert!(row.cells.len() > 1 && (end - touch) / (first - touch) > 1.3, "{row:?}");
            // An orbit that is unstable in all cells is so in one part.
            assert_eq!(row.stability.len(), usize::from(row.of == "orbit"), "{row:?}");
        }
        let files =
            || found.range.iter().flatten().flat_map(|row| &row.cells).flat_map(|cell| &cell.certificate);
        let mut known: Vec<_> = files().collect();
        known.sort();
        known.dedup();
        assert_eq!(known.len(), files().count(), "two cells have one file");
    }
}

/// The orbit of two periods that is born beyond the touch flips where the range says, and is stable from
/// there.
#[test]
fn an_orbit_is_proved_past_its_flip() {
    let machine = Machine {
        damping: 0.1,
        stiffness: 1.15,
        restitution: 0.8,
        waves: vec![(1.0, 0.3, 0.0)],
        varied: "F",
    };
    let found = machine.found("reach = 3\nrange = { effort = 80000 }");
    let orbits = || found.range.iter().flatten().filter(|row| row.of == "orbit" && row.side == "beyond");
    let row = orbits().find(|row| row.periods == [2]).unwrap();
    let [first, second] = &row.stability[..] else { panic!("{row:?}") };
    assert_eq!((first.word, &first.from, second.word), ("unstable", &None, "stable"));
    let [to, from, end] = [&first.to, second.from.as_ref().unwrap(), &second.to].map(|text| float(text));
    let touch = float(row.touch.as_ref().unwrap());
    assert!(touch < to && to < from && from < end && from - to < 0.01 * (end - touch), "{row:?}");
    assert_eq!(end, float(row.end.as_ref().unwrap()));
    for (value, stable) in [(to, false), (from, true), (0.5 * (touch + to), false), (end, true)] {
        assert_eq!(confirm_single(&machine, row, value), stable, "{value}");
    }
    assert!(orbits().all(|row| row.verdict == "proved" && !row.stability.is_empty()));
    assert!(confirmed(&machine, &found) > 20);
}

/// A parameter that scales one of two harmonics moves the phase of the top: nothing is proved, and why is
/// said.
#[test]
fn a_parameter_that_changes_the_form_of_the_motion_has_no_range() {
    let text = "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 0.5\n[system]\ndamping = 0.1\n\
                stiffness = 0.3\nforcing = [{ cos = \"F\" }, { k = 2, sin = 0.1 }]\n[[stops]]\nside = \
                \"upper\"\noffset = 1\nrestitution = 0.8\n[[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter \
                = \"F\"\nmax_period = 1\nseen = false\nrange = true\n";
    let scene = Scene::from_toml(text, "form.toml").unwrap_or_else(|error| panic!("{error}"));
    let job = Job::new(&scene, &scene.tasks[0], Surroundings::default()).unwrap();
    let report = run_task(&job, &mut ());
    assert_eq!(report.status.outcome().code(), 3);
    let Some(Findings::Grazing(found)) = report.findings else { panic!("{report}") };
    let GrazingFindings::Found(found) = *found else { panic!("nothing") };
    let why = found.range_open.unwrap();
    assert!(found.range.is_none() && why.contains("the form of the wall's motion changes"), "{why}");
}
