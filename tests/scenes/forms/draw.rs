//! Scenes drawn at random: every kind of system and of stop, with tasks of every kind, near a grazing.
//!
//! All numbers are multiples of 1/64, so that powers of two and signs change them exactly. The parameter F
//! multiplies the forcing or the stop's motion. The stop is where nine tenths of the response at F = 1 just
//! reach, so that F = 1 has impacts and the grazing is near F = 9/10, exactly so for a linear system.

mod effects;

use std::f64::consts::TAU;

pub use effects::with_effects;

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A multiple of 1/64 from `low` to `high`.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        let steps = ((high - low) * 64.0) as u64 + 1;
        low + (self.next() % steps) as f64 / 64.0
    }

    /// A part from -4 to 4, not 0.
    pub fn signed_part(&mut self) -> i32 {
        self.next();
        let part = (self.next() % 4) as i32 + 1;
        if self.next().is_multiple_of(2) { part } else { -part }
    }

    /// From 0 to 1.
    pub fn part(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    fn chance(&mut self, percent: u64) -> bool {
        self.below(100) < percent
    }
}

/// Steady-state response of M q″ + C q′ + K q = F cos kt, per coordinate, at one phase.
struct Response {
    /// For each harmonic: k, cosine and sine of every coordinate.
    terms: Vec<(f64, Vec<[f64; 2]>)>,
}

impl Response {
    fn add(&mut self, (mass, damping, stiffness): (&Matrix, &Matrix, &Matrix), k: f64, force: &[[f64; 2]]) {
        let n = mass.len();
        // (K − k²M) a + k C b = c, (K − k²M) b − k C a = s, by elimination with pivots.
        let mut rows = vec![vec![0.0; 2 * n + 1]; 2 * n];
        for i in 0..n {
            for j in 0..n {
                let (even, odd) = (stiffness[i][j] - k * k * mass[i][j], k * damping[i][j]);
                (rows[i][j], rows[i][n + j]) = (even, odd);
                (rows[n + i][j], rows[n + i][n + j]) = (-odd, even);
            }
            (rows[i][2 * n], rows[n + i][2 * n]) = (force[i][0], force[i][1]);
        }
        for column in 0..2 * n {
            let pivot =
                (column..2 * n).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()));
            rows.swap(column, pivot.expect("a row"));
            let top = rows[column].clone();
            for (i, row) in rows.iter_mut().enumerate() {
                if i != column {
                    let factor = row[column] / top[column];
                    row.iter_mut().zip(&top).for_each(|(x, y)| *x -= factor * y);
                }
            }
        }
        let solution = |i: usize| rows[i][2 * n] / rows[i][i];
        self.terms.push((k, (0..n).map(|i| [solution(i), solution(n + i)]).collect()));
    }

    /// The greatest value of row · q over a period.
    fn greatest(&self, row: &[f64]) -> f64 {
        let at = |t: f64| -> f64 {
            let term = |(k, all): &(f64, Vec<[f64; 2]>)| -> f64 {
                let (sin, cos) = (k * t).sin_cos();
                all.iter().zip(row).map(|([a, b], weight)| weight * (a * cos + b * sin)).sum()
            };
            self.terms.iter().map(term).sum()
        };
        (0..4096).map(|i| at(TAU * f64::from(i) / 4096.0)).fold(f64::NEG_INFINITY, f64::max)
    }
}

type Matrix = Vec<Vec<f64>>;

/// What kind of system a scene has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum System {
    Linear,
    Cubic,
    Formula,
    MovingWall,
    Chain,
    ChainFormula,
}

/// To a multiple of 1/256, towards the motion.
fn placed(x: f64) -> f64 {
    (x * 256.0).floor() / 256.0
}

/// The scene that is drawn with a seed.
pub fn drawn(seed: u64) -> String {
    let mut random = Random(seed);
    // The first number tells seeds apart poorly in its last bits.
    random.next();
    let system = match random.below(10) {
        0..=2 => System::Linear,
        3 => System::Cubic,
        4 => System::Formula,
        5 => System::MovingWall,
        6..=8 => System::Chain,
        _ => System::ChainFormula,
    };
    let text = match system {
        System::Chain | System::ChainFormula => machine(&mut random, system == System::ChainFormula),
        _ => oscillator(&mut random, system),
    };
    format!("title = \"drawn with seed {seed}, {system:?}\"\n{text}")
}

fn oscillator(random: &mut Random, system: System) -> String {
    // Sometimes a transient lasts.
    let light = system == System::Linear && random.chance(15);
    let damping = if light { 1.0 / 2048.0 } else { random.number(0.05, 0.5) };
    let stiffness = random.number(0.25, 6.0);
    let second = if random.chance(30) { random.number(-0.25, 0.25) } else { 0.0 };
    let mut response = Response { terms: Vec::new() };
    let one = |x: f64| vec![vec![x]];
    let matrices = (one(1.0), one(damping), one(stiffness));
    let matrices = (&matrices.0, &matrices.1, &matrices.2);
    let moving = system == System::MovingWall;
    if moving {
        response.terms = vec![(1.0, vec![[1.0, 0.0]])];
    } else {
        response.add(matrices, 1.0, &[[1.0, 0.0]]);
        response.add(matrices, 2.0, &[[0.0, second]]);
    }
    let (lower, both) = (random.chance(50), random.chance(30));
    let sign = if lower { -1.0 } else { 1.0 };
    // A wall that moves by F cos t, away from 0 at first, is met by what rests there.
    let reach = placed(0.9 * response.greatest(&[if moving { 1.0 } else { sign }]));
    let size = reach.abs().max(0.125);
    let forcing = match (moving, second) {
        (true, _) => String::new(),
        (false, 0.0) => "forcing = [{ cos = \"F\" }]\n".to_string(),
        _ => format!("forcing = [{{ cos = \"F\" }}, {{ k = 2, sin = \"{second}*F\" }}]\n"),
    };
    let harmonics = if moving { format!("harmonics = [{{ cos = \"{sign}*F\" }}]\n") } else { String::new() };
    let extra = match system {
        System::Cubic => format!("cubic = {}\n", random.number(0.0625, 0.25) / (4.0 * size * size)),
        System::Formula => {
            let strength = random.number(0.0625, 0.5) / 4.0;
            let formula = match random.below(4) {
                0 => format!("-{strength}*sin(2*q)"),
                // Sometimes steep.
                1 => format!("-{strength}*tanh({}*u)", if random.chance(50) { 4 } else { 128 }),
                2 => format!("-{strength}*q*u^2"),
                _ => format!("{strength}*exp(-q^2)*cos(t + 1)*F"),
            };
            format!("force = \"{formula}\"\n")
        }
        _ => String::new(),
    };
    let restitution = if light { 1.0 } else { random.number(0.3125, 1.0) };
    let wall = |side: &str, offset: f64| {
        format!("[[walls]]\nside = \"{side}\"\noffset = {offset}\nrestitution = {restitution}\n{harmonics}")
    };
    let linear = matches!(system, System::Linear | System::MovingWall);
    let (near, far) = if lower { ("lower", "upper") } else { ("upper", "lower") };
    let other =
        if both { wall(far, -sign * (reach.abs() + random.number(0.125, 0.5))) } else { String::new() };
    format!(
        "format = \"grazing-scene 1\"\n[parameters]\nF = 1\n[system]\ndamping = {damping}\nstiffness = {stiffness}\n\
         {extra}{forcing}{}{other}{}",
        wall(near, sign * reach),
        tasks(random, &Plan { size, walls: both.then_some(["walls", near, far]), linear, ..Plan::default() })
    )
}

/// What tasks depend on.
#[derive(Default)]
struct Plan<'a> {
    size: f64,
    /// The key of an orbit's walls, and the names of two.
    walls: Option<[&'a str; 3]>,
    coordinates: usize,
    soft: bool,
    linear: bool,
    /// Whether there is no stop.
    free: bool,
    /// Whether its response over the parameter w is asked for.
    response: bool,
}

fn machine(random: &mut Random, formula: bool) -> String {
    let n = if formula { 1 + random.below(2) } else { 1 + random.below(4) } as usize;
    let mut masses = vec![0.0; n];
    let (mut damping, mut stiffness) = (vec![vec![0.0; n]; n], vec![vec![0.0; n]; n]);
    for i in 0..n {
        masses[i] = random.number(0.5, 2.0);
        let (c, k) = (random.number(0.0625, 0.375), random.number(0.5, 4.0));
        damping[i][i] += c;
        stiffness[i][i] += k;
        if i > 0 {
            damping[i - 1][i - 1] += c;
            stiffness[i - 1][i - 1] += k;
            (damping[i][i - 1], damping[i - 1][i]) = (-c, -c);
            (stiffness[i][i - 1], stiffness[i - 1][i]) = (-k, -k);
        }
    }
    let mass: Matrix =
        (0..n).map(|i| (0..n).map(|j| if i == j { masses[i] } else { 0.0 }).collect()).collect();
    let mut response = Response { terms: Vec::new() };
    let force: Vec<[f64; 2]> = (0..n).map(|i| [if i == 0 { 1.0 } else { 0.0 }, 0.0]).collect();
    response.add((&mass, &damping, &stiffness), 1.0, &force);
    let mut row = vec![0.0; n];
    row[n - 1] = -1.0;
    if n > 1 && random.chance(40) {
        row[n - 2] = 1.0;
    }
    let reach = placed(0.9 * response.greatest(&row.iter().map(|x| -x).collect::<Vec<_>>()));
    let size = reach.abs().max(0.125);
    let soft = random.chance(35);
    let law = match (soft, random.below(4)) {
        (true, _) => {
            format!("stiffness = {}\ndamping = {}\n", random.number(8.0, 64.0), random.number(0.0, 0.5))
        }
        (_, 0) if !formula => "restitution = \"0.75/(1 + v/2)\"\n".to_string(),
        _ => format!("restitution = {}\n", random.number(0.3125, 1.0)),
    };
    let forces: Vec<String> = (0..n)
        .map(
            |i| if i == 0 { format!("\"-{}*q1^3\"", random.number(0.0625, 0.25) / size) } else { "0".into() },
        )
        .collect();
    let force = if formula { format!("force = [{}]\n", forces.join(", ")) } else { String::new() };
    let cosines: Vec<&str> = (0..n).map(|i| if i == 0 { "\"F\"" } else { "0" }).collect();
    format!(
        "format = \"grazing-scene 2\"\n[parameters]\nF = 1\n[system]\nperiod = \"2*pi\"\nmass = {mass:?}\n\
         damping = {damping:?}\nstiffness = {stiffness:?}\n{force}forcing = [{{ cos = [{}] }}]\n\
         [[walls]]\nname = \"stop\"\nrow = {row:?}\noffset = {}\n{law}{}",
        cosines.join(", "),
        -reach,
        tasks(
            random,
            &Plan { size, coordinates: n, soft, linear: !formula && !law.contains("v"), ..Plan::default() }
        )
    )
}

fn tasks(random: &mut Random, plan: &Plan) -> String {
    let Plan { size, walls, coordinates, soft, linear, free, response } = *plan;
    let machine = coordinates > 0;
    let place = |x: f64| match machine {
        true => format!("[{}]", (0..coordinates).map(|_| format!("{x:?}")).collect::<Vec<_>>().join(", ")),
        false => format!("{x:?}"),
    };
    let plane = if machine { "plane = [\"q1\", \"u1\"]\n" } else { "" };
    let rest = format!("{{ q = {}, u = {} }}", place(0.0), place(0.0));
    let off =
        format!("{{ q = {}, u = {} }}", place(size / 8.0), place(random.number(-1.0, 1.0) * size / 4.0));
    // Where motions are integrated, a search takes long: with the first orbit found, all else begins there.
    let starts = if linear { 200 } else { 24 };
    let orbit = |pattern: &str, which: [usize; 2]| {
        let count = if pattern.contains(',') { 2 } else { 1 };
        let walls = walls.map_or(String::new(), |names| {
            let of: Vec<String> = which[..count].iter().map(|i| format!("\"{}\"", names[1 + i])).collect();
            format!(", {} = [{}]", names[0], of.join(", "))
        });
        format!("{{ pattern = [{pattern}]{walls}, speed = {:?}, starts = {starts} }}", 4.0 * size)
    };
    let (one, two) = (orbit("1", [0, 0]), orbit("2", [0, 0]));
    let [one, two] =
        if soft { [1, 2].map(|period| format!("{{ period = {period}, starts = 8 }}")) } else { [one, two] };
    let [one, two] = if free {
        [1, 2].map(|period| format!("{{ pattern = [], period = {period}, starts = 8 }}"))
    } else {
        [one, two]
    };
    let round = match walls {
        Some(_) if !soft => {
            format!("[[tasks]]\nname = \"round\"\nkind = \"orbit\"\norbit = {}\n", orbit("0, 1", [0, 1]))
        }
        _ => String::new(),
    };
    // Only where a search is cheap.
    let two = format!("[[tasks]]\nname = \"two\"\nkind = \"orbit\"\norbit = {two}\n");
    let several = if linear { two + &round } else { String::new() };
    let response = match response {
        true => format!(
            "[[tasks]]\nname = \"response\"\nkind = \"response\"\nparameter = \"w\"\nrange = [0.75, 1.25]\ncount = 5\n\
             start = {rest}\ntransient = 60\npoints = 30\nlongest = 8\n"
        ),
        false => String::new(),
    };
    // Without a stop there is nothing to touch.
    let touches = match free {
        true => String::new(),
        false => touches(size, &one),
    };
    let [low, high] = [-size / 4.0, size / 2.0];
    format!(
        "[[tasks]]\nname = \"sim\"\nkind = \"simulate\"\nstart = {off}\nperiods = 6\nsamples = 4\n\
         [[tasks]]\nname = \"sec\"\nkind = \"section\"\nstarts = [{rest}, {off}]\n{plane}points = 60\ntransient = 200\nexponents = 2\n\
         [[tasks]]\nname = \"free\"\nkind = \"orbit\"\norbit = {{ pattern = [], period = 1, starts = 8 }}\n\
         [[tasks]]\nname = \"one\"\nkind = \"orbit\"\nparameter = \"F\"\nvalues = [0.96875, 1, 1.03125]\norbit = {one}\n\
         {several}\
         [[tasks]]\nname = \"attractor\"\nkind = \"branch\"\nparameter = \"F\"\nrange = [0.75, 1.5]\nstarts = [{{ attractor = {rest} }}]\n\
         [[tasks]]\nname = \"branch\"\nkind = \"branch\"\nparameter = \"F\"\nrange = [0.75, 1.5]\nstarts = [{{ orbit = {one} }}]\n\
         {touches}\
         [[tasks]]\nname = \"flip\"\nkind = \"event\"\nevent = \"flip\"\nparameter = \"F\"\nreach = 1.0\norbit = {one}\n\
         [[tasks]]\nname = \"fold\"\nkind = \"event\"\nevent = \"saddle-node\"\nparameter = \"F\"\nreach = 1.0\norbit = {one}\n\
         [[tasks]]\nname = \"diagram\"\nkind = \"diagram\"\nparameter = \"F\"\nrange = [0.75, 1.25]\ncount = 5\nstarts = [{rest}]\n{plane}points = 60\ntransient = 200\nlongest = 16\n\
         [[tasks]]\nname = \"basins\"\nkind = \"basins\"\n{plane}q = {{ from = {low:?}, to = {high:?}, count = 3 }}\nu = {{ from = {:?}, to = {:?}, count = 3 }}\ntransient = 200\n{response}{}",
        -size,
        size,
        if soft || !linear {
            String::new()
        } else {
            format!("[[tasks]]\nname = \"proof\"\nkind = \"validate\"\norbit = {one}\n")
        }
    )
}

/// Where the motion without impacts grazes, and orbits of impacts begin or fade.
fn touches(size: f64, one: &str) -> String {
    format!(
        "[[tasks]]\nname = \"grazing\"\nkind = \"grazing\"\nparameter = \"F\"\nmax_period = 3\nrange = false\nreach = 2.0\ndistance = {:?}\nseen = false\nset = {{ F = 0.8 }}\n\
         [[tasks]]\nname = \"touch\"\nkind = \"event\"\nevent = \"grazing\"\nparameter = \"F\"\nreach = 1.0\nset = {{ F = 0.8 }}\norbit = {{ pattern = [], starts = 8 }}\n\
         [[tasks]]\nname = \"fade\"\nkind = \"event\"\nevent = \"fade\"\nparameter = \"F\"\nreach = 1.0\norbit = {one}\n",
        size / 1_048_576.0
    )
}
