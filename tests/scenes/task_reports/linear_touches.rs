//! The touch of a linear machine is found from any start, against forms that know nothing of the search: the
//! equations solved in fractions, and zeros of a polynomial.

use grazing_base::random::Random;
use grazing_scenes::{
    run::{Findings, GrazingFindings, Surroundings, run},
    scene::Scene,
};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::{grazing_found, touches::driven};
use crate::samples::samples;

/// A harmonic of the force: k, and the amplitudes of cos and sin for F = 1.
type Wave = (u32, Vec<f64>, Vec<f64>);

/// M q″ + C q′ + K q = F Σ (cos, sin), of period 2π, before the stop w·q + room ≥ 0.
struct Linear {
    mass: Vec<Vec<f64>>,
    damping: Vec<Vec<f64>>,
    stiffness: Vec<Vec<f64>>,
    waves: Vec<Wave>,
    row: Vec<f64>,
    room: f64,
}

fn unit(random: &mut Random) -> f64 {
    (random.bits() >> 11) as f64 / (1u64 << 53) as f64
}

fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * unit(random)
}

impl Linear {
    /// Modes anywhere or beside a harmonic, with damping ratios from 10⁻⁴ to 1/2, in coordinates that mix
    /// them.
    fn random(random: &mut Random) -> Linear {
        let n = random.within(1, 4) as usize;
        let mut waves: Vec<Wave> = Vec::new();
        for _ in 0..random.within(1, 6) {
            let k = random.within(1, 7) as u32;
            if waves.iter().all(|known| known.0 != k) {
                let mut part = || (0..n).map(|_| between(random, -1.0, 1.0)).collect::<Vec<f64>>();
                waves.push((k, part(), part()));
            }
        }
        // T is 1 on the diagonal and small beside it: M = TᵀT, K = Tᵀ ω² T, C = Tᵀ 2ζω T.
        let mix: Vec<Vec<f64>> = (0..n)
            .map(|i| (0..n).map(|j| if i == j { 1.0 } else { between(random, -0.4, 0.4) }).collect())
            .collect();
        let modes: Vec<[f64; 2]> = (0..n)
            .map(|_| {
                let ratio = 10f64.powf(between(random, -4.0, -0.3));
                let near = f64::from(waves[random.below(waves.len() as u64) as usize].0);
                let at = if random.coin() {
                    near * (1.0 + ratio * between(random, -2.0, 2.0))
                } else {
                    between(random, 0.3, 8.0)
                };
                [at, ratio]
            })
            .collect();
        let of = |value: &dyn Fn([f64; 2]) -> f64| -> Vec<Vec<f64>> {
            let entry =
                |i: usize, j: usize| (0..n).map(|l| mix[l][i] * mix[l][j] * value(modes[l])).sum::<f64>();
            (0..n).map(|i| (0..n).map(|j| entry(i.min(j), i.max(j))).collect()).collect()
        };
        let row = (0..n).map(|_| between(random, -1.0, 1.0)).collect();
        Linear {
            mass: of(&|_| 1.0),
            damping: of(&|[at, ratio]| 2.0 * at * ratio),
            stiffness: of(&|[at, _]| at * at),
            waves,
            row,
            room: between(random, 0.1, 3.0),
        }
    }

    fn scene(&self, start: f64) -> String {
        let list = |all: &[f64]| format!("{all:?}");
        let table = |rows: &[Vec<f64>]| {
            format!("[{}]", rows.iter().map(|row| list(row)).collect::<Vec<_>>().join(", "))
        };
        let force = |all: &[f64]| {
            let each: Vec<String> = all.iter().map(|x| format!("\"{x:?}*F\"")).collect();
            format!("[{}]", each.join(", "))
        };
        let wave =
            |(k, cos, sin): &Wave| format!("{{ k = {k}, cos = {}, sin = {} }}", force(cos), force(sin));
        let waves: Vec<String> = self.waves.iter().map(wave).collect();
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = \"many\"\n[parameters]\nF = {start:?}\n[system]\n\
             period = \"2*pi\"\nmass = {}\ndamping = {}\nstiffness = {}\nforcing = [{}]\n[[stops]]\nname = \"stop\"\nrow = {}\n\
             offset = {:?}\nrestitution = 0.8\n[[tasks]]\nname = \"it\"\nkind = \"grazing\"\nparameter = \"F\"\nseen = false\n\
             max_period = 1\n",
            table(&self.mass),
            table(&self.damping),
            table(&self.stiffness),
            waves.join(", "),
            list(&self.row),
            -self.room
        )
    }

    /// The same with all but the mass in formulas.
    fn formulas(&self, start: f64) -> String {
        let n = self.row.len();
        let of = |i: usize| {
            let state = (0..n).map(|j| {
                let [c, k] = [self.damping[i][j], self.stiffness[i][j]];
                format!("-({c:?})*u{} - ({k:?})*q{}", j + 1, j + 1)
            });
            let wave =
                |(k, cos, sin): &Wave| format!("F*(({:?})*cos({k}*t) + ({:?})*sin({k}*t))", cos[i], sin[i]);
            format!("\"{}\"", state.chain(self.waves.iter().map(wave)).collect::<Vec<_>>().join(" + "))
        };
        let (head, tail) = (self.scene(start), (0..n).map(of).collect::<Vec<_>>().join(", "));
        let (head, (_, stops)) =
            (head.split_once("damping").unwrap().0, head.split_once("[[stops]]").unwrap());
        format!("{head}force = [{tail}]\n[[stops]]{stops}")
    }

    /// The same of one coordinate and mass 1 by the other engine.
    fn alone(&self, start: f64) -> String {
        let wave = |(k, cos, sin): &Wave| {
            format!("{{ k = {k}, cos = \"{:?}*F\", sin = \"{:?}*F\" }}", cos[0], sin[0])
        };
        let waves: Vec<String> = self.waves.iter().map(wave).collect();
        let side = if self.row[0] > 0.0 { "lower" } else { "upper" };
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = \"one\"\n[parameters]\nF = {start:?}\n[system]\n\
             damping = {:?}\nstiffness = {:?}\nforcing = [{}]\n[[stops]]\nname = \"stop\"\nside = \"{side}\"\noffset = {:?}\n\
             restitution = 0.8\n[[tasks]]\nname = \"it\"\nkind = \"grazing\"\nparameter = \"F\"\nseen = false\nmax_period = 1\n\
             range = false\n",
            self.damping[0][0],
            self.stiffness[0][0],
            waves.join(", "),
            -self.room * self.row[0].signum()
        )
    }

    /// The two F at which it touches: room/max −w·q and room/min, w·q the periodic motion for F = 1, its
    /// harmonics in fractions.
    fn touches(&self) -> [f64; 2] {
        let fraction = |x: f64| BigRational::from_float(x).unwrap();
        let n = self.row.len();
        let series: Vec<(f64, f64, f64)> = self
            .waves
            .iter()
            .map(|(k, cos, sin)| {
                // (D, E; −E, D)(a, b) = (cos, sin), D = K − k²M, E = kC, of a cos kt + b sin kt.
                let times = BigRational::from_integer((*k).into());
                let square = &times * &times;
                let mut rows: Vec<Vec<BigRational>> = vec![vec![BigRational::zero(); 2 * n + 1]; 2 * n];
                for i in 0..n {
                    for j in 0..n {
                        let d = fraction(self.stiffness[i][j]) - &square * fraction(self.mass[i][j]);
                        let e = &times * fraction(self.damping[i][j]);
                        rows[i][j] = d.clone();
                        rows[i + n][j + n] = d;
                        rows[i][j + n] = e.clone();
                        rows[i + n][j] = -e;
                    }
                    rows[i][2 * n] = fraction(cos[i]);
                    rows[i + n][2 * n] = fraction(sin[i]);
                }
                let z = solved(rows);
                let along = |from: usize| {
                    let terms = self.row.iter().enumerate().map(|(i, w)| fraction(*w) * &z[from + i]);
                    terms.fold(BigRational::zero(), |sum, term| sum + term).to_f64().unwrap()
                };
                (f64::from(*k), along(0), along(n))
            })
            .collect();
        let at = |t: f64| {
            series.iter().fold([0.0; 3], |[x, v, a], (k, cos, sin)| {
                let (s, c) = (k * t).sin_cos();
                let (here, slope) = (cos * c + sin * s, k * (sin * c - cos * s));
                [x + here, v + slope, a - k * k * here]
            })
        };
        [-1.0, 1.0].map(|sign: f64| {
            let count = 4000;
            let mut best = f64::NEG_INFINITY;
            for i in 0..count {
                let mut t = std::f64::consts::TAU * f64::from(i) / f64::from(count);
                if sign * at(t)[0] < best - 0.01 * best.abs() {
                    continue;
                }
                for _ in 0..8 {
                    let [_, v, a] = at(t);
                    t -= if sign * a < 0.0 { (v / a).clamp(-0.01, 0.01) } else { 0.0 };
                }
                best = best.max(sign * at(t)[0]);
            }
            -sign * self.room / best
        })
    }
}

/// The solution of linear equations, the right side being the last column, by Gauss in fractions.
fn solved(mut rows: Vec<Vec<BigRational>>) -> Vec<BigRational> {
    let n = rows.len();
    for i in 0..n {
        let pivot = (i..n).find(|&j| !rows[j][i].is_zero()).unwrap();
        rows.swap(i, pivot);
        let first = rows[i].clone();
        for (j, row) in rows.iter_mut().enumerate() {
            if j != i && !row[i].is_zero() {
                let factor = &row[i] / &first[i];
                row.iter_mut().zip(&first).for_each(|(x, own)| *x -= &factor * own);
            }
        }
    }
    (0..n).map(|i| &rows[i][n] / &rows[i][i]).collect()
}

#[test]
fn the_touch_of_a_random_linear_machine_is_found_from_any_start() {
    let mut random = Random(7);
    let mut worst = 0.0_f64;
    for number in 0..samples::<u64>(6) {
        let mut machine = Linear::random(&mut random);
        let is_one = machine.row.len() == 1 && number % 2 == 0;
        if is_one {
            (machine.mass[0][0], machine.row[0]) = (1.0, machine.row[0].signum());
        }
        let wanted = machine.touches();
        let size = wanted[0].abs().min(wanted[1].abs());
        for (place, start) in
            [0.0, 1e-300, 1e300, -1e-3 * size, 0.999 * wanted[0], 40.0 * wanted[1]].into_iter().enumerate()
        {
            let text = match place % 3 {
                _ if is_one => machine.alone(start),
                0 => machine.formulas(start),
                _ => machine.scene(start),
            };
            let (found, shown, _) = grazing_found(&text);
            let own = found.at.parameter;
            let near = if (wanted[0] - start).abs() < (wanted[1] - start).abs() { 0 } else { 1 };
            let off = wanted.map(|x| (own / x - 1.0).abs());
            let off =
                if start.abs() < 1e-200 || start.abs() > 1e200 { off[0].min(off[1]) } else { off[near] };
            worst = worst.max(off);
            assert!(
                off <= 1e-14,
                "machine {number} from {start:e}: {own:?}, not {wanted:?}: {off:e}\n{shown}\n{text}"
            );
        }
    }
    println!("worst {worst:e}");
}

/// q″ + c q′ + q = A cos t touches q = 1 at A = c: the motion is c times as large as its force.
#[test]
fn a_touch_at_resonance_is_found_by_event_and_grazing_however_little_damps() {
    let cases = [
        ("one", 0.1, 0.5),
        ("one", 0.01, 0.99),
        ("one", 1e-4, 0.5),
        ("many", 0.1, 0.99),
        ("many", 0.01, 0.5),
    ];
    for (engine, c, part) in cases {
        let scene = |task: &str| {
            format!(
                "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = {engine:?}\n[parameters]\nA = {:?}\n\
                         [system]\nperiod = \"2*pi\"\nmass = 1\ndamping = {c:?}\nstiffness = 1\n\
                         forcing = [{{ cos = \"A\" }}]\n[[stops]]\nrow = [-1]\noffset = -1\nrestitution = 0.8\n\
                         [[tasks]]\nname = \"it\"\n{task}",
                part * c
            )
        };
        let grazing = "kind = \"grazing\"\nparameter = \"A\"\nseen = false\nmax_period = 1\nrange = false\n";
        let at = grazing_found(&scene(grazing)).0.at.parameter;
        assert!((at / c - 1.0).abs() < 1e-14, "{engine} {c}: {at}");
        let found = |task: &str| {
            let scene = Scene::from_toml(&scene(task), "t.toml").unwrap();
            let report = run(&scene, Surroundings::default(), &mut ()).unwrap().remove(0);
            (report.to_string(), report.findings)
        };
        let event = "kind = \"event\"\nevent = \"grazing\"\nparameter = \"A\"\norbit = {}\n";
        let (shown, findings) = found(event);
        let Some(Findings::Event(events)) = findings else { panic!("{shown}") };
        let at = events.found.first().unwrap_or_else(|| panic!("{engine} {c}: {shown}")).parameter;
        assert!((at / c - 1.0).abs() < 1e-9, "{engine} {c}: {at}");
        let (shown, findings) = found("kind = \"orbit\"\norbit = {}\n");
        let Some(Findings::Orbit(orbits)) = findings else { panic!("{shown}") };
        let gap = orbits.orbits[0].orbit.least_gap.unwrap();
        assert!((gap - (1.0 - part)).abs() < 1e-9, "{engine} {c}: {shown}");
    }
}

/// A motion that turns in a fold before it touches, where its branch goes back: the touch, between the two,
/// is what SciPy finds of it (`fsolve` with DOP853).
#[test]
fn a_touch_behind_a_fold_is_found_from_far_below() {
    for engine in ["one", "many"] {
        // Formulas of several coordinates take their time.
        let starts = if engine == "one" {
            &[0.1, 0.3, 0.55][..]
        } else {
            &[0.3, 0.55][..samples::<usize>(1).min(2) - 1]
        };
        for start in starts {
            let text = format!(
                "format = \"grazing-scene 3\"\ntitle = \"t\"\nengine = {engine:?}\n[parameters]\nV = {start}\nc = 0.04\n\
                 w = 0.92\n[system]\nperiod = \"pi/w\"\nforce = \"V^2*(1 - cos(t))/2/(1 - q)^2 - c*u - q\"\n[[stops]]\n\
                 side = \"upper\"\noffset = 0.5\nrestitution = 0.8\n[[tasks]]\nname = \"it\"\nkind = \"grazing\"\n\
                 parameter = \"V\"\nmax_period = 1\n"
            );
            let (found, shown, _) = grazing_found(&text);
            let at = found.at.parameter;
            assert!((at - 0.5875162504154667).abs() < 1e-10, "{engine} from {start}: {at}");
            // The motion that is followed is known: a search for it takes half a million steps.
            let steps =
                shown.split_once("smooth ").and_then(|(_, rest)| rest.split(',').next()?.parse().ok());
            assert!(steps.is_some_and(|steps: u64| steps < 100_000), "{engine} from {start}: {shown}");
        }
    }
}

/// Where F = gap |k − m w² + i c w| in one of these, the others being given; only what is positive.
fn formula(name: &str, [force, m, c, k, w, gap]: [f64; 6]) -> Vec<f64> {
    let square = (force / gap).powi(2);
    let both = |middle: f64, square: f64| {
        if square >= 0.0 { vec![middle - square.sqrt(), middle + square.sqrt()] } else { Vec::new() }
    };
    let all = match name {
        "gap" => vec![force / (k - m * w * w).hypot(c * w)],
        "F" => vec![gap * (k - m * w * w).hypot(c * w)],
        "c" => vec![(square - (k - m * w * w).powi(2)).sqrt() / w],
        "k" => both(m * w * w, square - (c * w).powi(2)),
        "m" => both(k / (w * w), (square - (c * w).powi(2)) / (w * w).powi(2)),
        // m²x² + (c² − 2km)x + k² − (F/gap)² = 0 with x = w².
        _ => {
            let half = (k / m) - c * c / (2.0 * m * m);
            both(half, half * half - (k * k - square) / (m * m)).into_iter().map(f64::sqrt).collect()
        }
    };
    all.into_iter().filter(|x| *x > 0.0).collect()
}

/// The touches that a task lists, and what it shows.
fn listed(text: &str) -> (Vec<f64>, String) {
    let scene = Scene::from_toml(text, "t.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let report = run(&scene, Surroundings::default(), &mut ()).unwrap().remove(0);
    let shown = report.to_string();
    let Some(Findings::Grazing(found)) = report.findings else { panic!("{shown}") };
    let rows = match *found {
        GrazingFindings::Found(found) => found.touches.unwrap(),
        GrazingFindings::Nothing { .. } => Vec::new(),
    };
    (rows.iter().map(|row| row.parameter).collect(), shown)
}

#[test]
fn all_touches_in_any_parameter_are_the_zeros_of_its_formula() {
    // The last force reaches the stop beside the resonance alone, in a ten-thousandth of the parameter.
    for (damping, force) in [(0.3, 0.9), (1e-4, 5e-5)] {
        let values = [force, 2.0, damping, 0.6, 1.1, 0.7];
        let names = ["F", "m", "c", "k", "w", "gap"];
        for (engine, parts) in [("one", &[1.0, 30.0][..]), ("many", &[0.01][..])] {
            for (place, name) in names.into_iter().enumerate() {
                let mut wanted = formula(name, values);
                for start in parts.iter().map(|part| part * values[place]) {
                    let text = driven(
                        engine,
                        &format!("seen = false\nmax_period = 1\nset = {{ {name} = {start:?} }}\n"),
                    );
                    let text = text
                        .replace("c = 0.3", &format!("c = {damping:?}"))
                        .replace("F = 0.9", &format!("F = {force:?}"));
                    let text = text.replace("parameter = \"F\"", &format!("parameter = {name:?}"));
                    wanted.sort_by(|a, b| (a - start).abs().total_cmp(&(b - start).abs()));
                    let within = format!("{text}within = [{:?}, 1000.0]\n", 1e-7);
                    let (own, shown) = listed(&within);
                    let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
                    let same =
                        own.len() == wanted.len() && own.iter().zip(&wanted).all(|(a, b)| near(*a, *b));
                    assert!(same, "{engine} {name} from {start}: {own:?}, not {wanted:?}\n{shown}");
                    if let [nearest, ..] = wanted[..] {
                        let (found, ..) = grazing_found(&text);
                        let own = found.at.parameter;
                        assert!(near(own, nearest), "{engine} {name} from {start}: {own}, not {nearest}");
                    }
                }
            }
        }
    }
}

/// A mass that is not positive moves nothing: that part of what was asked for is named, in the exit code,
/// too.
#[test]
fn values_at_which_there_is_no_motion_are_told() {
    let of = |least: &str| {
        let text = driven("many", &format!("within = [{least}, 5]\nseen = false\nmax_period = 1\n"));
        text.replace("parameter = \"F\"", "parameter = \"m\"")
    };
    let (whole, shown, code) = grazing_found(&of("0.1"));
    assert_eq!((whole.touches_open, code), (None, 0), "{shown}");
    let (part, shown, code) = grazing_found(&of("-1"));
    let why = part.touches_open.unwrap_or_else(|| panic!("{shown}"));
    assert!(why.contains("from -1.0 to ") && why.contains("every motion must have inertia"), "{why}");
    assert_eq!((part.touches, code), (whole.touches, 3), "{shown}");
    assert!(
        shown.contains("touches_open     not looked for") && shown.contains("undecided: touches: "),
        "{shown}"
    );
    // Where nothing else is found it stands in the reason.
    let (none, shown) = listed(&of("-1").replace("F = 0.9", "F = 1e-5"));
    assert!(none.is_empty() && shown.contains("every motion must have inertia"), "{shown}");
}

#[test]
fn touches_within_are_of_a_linear_motion_without_impacts() {
    let refused = |text: &str| Scene::from_toml(text, "t.toml").unwrap_err().to_string();
    let turned = refused(&driven("one", "within = [2, 1]\n"));
    assert!(turned.contains("within") && turned.contains("the smaller first"), "{turned}");
    let reached = refused(&driven("many", "within = [0.1, 1]\nreach = 1\n"));
    assert!(reached.contains("goes without `reach`"), "{reached}");
    let bent =
        driven("one", "within = [0.1, 1]\n").replace("stiffness = \"k\"", "stiffness = \"k\"\ncubic = 1");
    let report =
        run(&Scene::from_toml(&bent, "t.toml").unwrap(), Surroundings::default(), &mut ()).unwrap().remove(0);
    assert!(
        report.to_string().contains("`within` is for a motion without impacts that is linear"),
        "{report}"
    );
    // None is there, and where they are is said.
    let (own, shown) = listed(&driven("one", "within = [5, 6]\nseen = false\n"));
    assert!(own.is_empty() && shown.contains("none is within [5.0, 6.0]"), "{shown}");
}
