//! Where a theory is asked: at a point, or on a box of parameters, as the arguments of `classify` and `word`
//! say.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::pow;
use serde_json::{Map, Value as Json, json};

use super::range::{Measure, Span, Unit};
use crate::{
    error::{Error, Result},
    local::Forward,
    output::{decimal_near, decimal_or_fraction},
    tolerance::{NormalParameters, ParameterBox},
};

/// A point or a box.
#[derive(Debug, clap::Args)]
pub struct Place {
    /// Trace a1, or an interval: 0.3, 0.3..=0.301, 0.3±1%.
    #[arg(long, requires = "a2", allow_hyphen_values = true, value_name = "X|A..=B")]
    a1: Option<Span>,
    /// Determinant a2 > 0, or an interval.
    #[arg(long, requires = "a1", allow_hyphen_values = true, value_name = "Y|A..=B")]
    a2: Option<Span>,
    /// Modulus r > 0, or an interval.
    #[arg(long, requires = "s", allow_hyphen_values = true, value_name = "R|A..=B")]
    r: Option<Span>,
    /// Angle over a turn, 0 < s < 1/2, or an interval.
    #[arg(long, requires = "r", allow_hyphen_values = true, value_name = "S|A..=B")]
    s: Option<Span>,
    /// A machine's undamped natural frequency: 12.3Hz±1%, 738rpm.
    #[arg(long, requires_all = ["damping_ratio", "drive"], allow_hyphen_values = true, value_name = "F")]
    frequency: Option<Measure>,
    /// Its damping ratio: 0.02±20%.
    #[arg(long, requires = "frequency", allow_hyphen_values = true, value_name = "Z")]
    damping_ratio: Option<Span>,
    /// The frequency of its drive.
    #[arg(long, requires = "frequency", allow_hyphen_values = true, value_name = "F")]
    drive: Option<Measure>,
}

/// The names of two parameters and their bounds.
pub type Bounds = [(&'static str, [BigRational; 2]); 2];

/// What was asked about.
pub enum Asked {
    Point(AskedPoint),
    /// All points of a box.
    Box(Box<(ParameterBox, Bounds)>),
}

/// A point in the coordinates that it was given in.
pub enum AskedPoint {
    Plane(BigRational, BigRational),
    Polar(BigRational, BigRational),
}

/// A box, a point of it, and the parameters as they were given.
pub struct Given {
    pub of: ParameterBox,
    pub bounds: Bounds,
    /// Where the parameters have their middle.
    pub from: [BigRational; 2],
    pub parameters: Vec<Parameter>,
}

/// A parameter as it was given.
pub struct Parameter {
    pub name: &'static str,
    /// In the first unit of its kind.
    pub bounds: [BigRational; 2],
    pub unit: Option<Unit>,
    as_given: AsGiven,
}

/// What makes a parameter of a coordinate of the box.
enum AsGiven {
    /// It is one.
    Is(usize),
    /// The first one times this.
    Times(BigRational),
    /// This over the first one.
    Under(BigRational),
}

impl Parameter {
    fn plain(name: &'static str, axis: usize, bounds: &[BigRational; 2]) -> Parameter {
        Parameter { name, bounds: bounds.clone(), unit: None, as_given: AsGiven::Is(axis) }
    }

    /// The coordinate that it moves, and whether that rises with it.
    pub fn moves(&self) -> (usize, bool) {
        match self.as_given {
            AsGiven::Is(axis) => (axis, true),
            AsGiven::Times(_) => (0, true),
            AsGiven::Under(_) => (0, false),
        }
    }

    /// Its value in its own unit where that coordinate is `x`.
    pub fn shown(&self, x: &BigRational) -> BigRational {
        self.in_unit(&self.value(x))
    }

    /// Its bounds in its own unit.
    pub fn tolerance(&self) -> [BigRational; 2] {
        self.bounds.each_ref().map(|end| self.in_unit(end))
    }

    fn in_unit(&self, value: &BigRational) -> BigRational {
        self.unit.as_ref().map_or_else(|| value.clone(), |unit| unit.of(value))
    }

    /// Its value in the first unit of its kind where that coordinate is `x`.
    pub fn value(&self, x: &BigRational) -> BigRational {
        match &self.as_given {
            AsGiven::Is(_) => x.clone(),
            AsGiven::Times(drive) => x * drive,
            AsGiven::Under(natural) => natural / x,
        }
    }
}

/// What is said of a point with a₂ > 1.
pub(super) const REVERSED: &str = ", after reversing time (a2 > 1): patterns are read backwards";

impl AskedPoint {
    /// The point with a₂ ≤ 1.
    pub fn forward(&self) -> Result<Forward> {
        match self {
            AskedPoint::Plane(a1, a2) => Forward::plane(a1.clone(), a2.clone()),
            AskedPoint::Polar(r, s) => Forward::polar(r.clone(), s.clone()),
        }
    }

    /// The box with this point alone.
    fn as_box(&self) -> Result<(ParameterBox, Bounds)> {
        let one = |x: &BigRational| [x.clone(), x.clone()];
        Ok(match self {
            AskedPoint::Plane(a1, a2) => {
                (ParameterBox::plane(one(a1), one(a2))?, [("a1", one(a1)), ("a2", one(a2))])
            }
            AskedPoint::Polar(r, s) => (ParameterBox::polar(one(r), one(s))?, [("r", one(r)), ("s", one(s))]),
        })
    }

    /// The coordinates in LaTeX.
    pub fn coordinates(&self) -> String {
        match self {
            AskedPoint::Plane(a1, a2) => coordinates(Some((a1, a2)), None),
            AskedPoint::Polar(r, s) => coordinates(None, Some((r, s))),
        }
    }
}

impl Place {
    pub fn asked(&self) -> Result<Asked> {
        if let (Some(frequency), Some(damping), Some(drive)) =
            (&self.frequency, &self.damping_ratio, &self.drive)
        {
            let ratio = ratio(frequency, drive)?;
            let of = ParameterBox::machine(ratio.clone(), damping.0.clone())
                .map_err(|error| Error::input(format!("--frequency, --damping-ratio: {error}")))?;
            let bounds = [("ratio", ratio), ("damping_ratio", damping.0.clone())];
            return Ok(Asked::Box(Box::new((of, bounds))));
        }
        let (names, [first, second]) = match (&self.a1, &self.a2, &self.r, &self.s) {
            (Some(a1), Some(a2), _, _) => (["a1", "a2"], [a1, a2]),
            (_, _, Some(r), Some(s)) => (["r", "s"], [r, s]),
            _ => return Err(Error::input("give a point by --a1 and --a2, or by --r and --s")),
        };
        let is_plane = names[0] == "a1";
        if !first.is_interval() && !second.is_interval() {
            let point = if is_plane { AskedPoint::Plane } else { AskedPoint::Polar };
            return Ok(Asked::Point(point(first.0[0].clone(), second.0[0].clone())));
        }
        let make = if is_plane { ParameterBox::plane } else { ParameterBox::polar };
        let of = make(first.0.clone(), second.0.clone()).map_err(|error| {
            let one = |name: &str, Span([lower, upper], _): &Span| format!("{name} = {lower}..={upper}");
            Error::input(format!("{}, {}: {error}", one(names[0], first), one(names[1], second)))
        })?;
        let bounds = [(names[0], first.0.clone()), (names[1], second.0.clone())];
        Ok(Asked::Box(Box::new((of, bounds))))
    }

    /// The parameters as they were given, and the box and its middle, also of a point.
    pub fn given(&self) -> Result<Given> {
        let middle =
            |[lower, upper]: &[BigRational; 2]| (lower + upper) / BigRational::from_integer(2.into());
        let asked = self.asked()?;
        if let (Some(frequency), Some(damping), Some(drive), Asked::Box(of)) =
            (&self.frequency, &self.damping_ratio, &self.drive, &asked)
        {
            let [natural, driven] = [frequency, drive].map(|measure| middle(&measure.span.0));
            let is = |name, measure: &Measure, as_given| Parameter {
                name,
                bounds: measure.span.0.clone(),
                unit: measure.unit.clone(),
                as_given,
            };
            let from = [&natural / &driven, middle(&damping.0)];
            let parameters = vec![
                is("frequency", frequency, AsGiven::Times(driven)),
                Parameter::plain("damping_ratio", 1, &damping.0),
                is("drive", drive, AsGiven::Under(natural)),
            ];
            return Ok(Given { of: of.0.clone(), bounds: of.1.clone(), from, parameters });
        }
        let (of, bounds) = match asked {
            Asked::Box(of) => *of,
            Asked::Point(point) => point.as_box()?,
        };
        let from = bounds.each_ref().map(|(_, ends)| middle(ends));
        let parameters = [0, 1].map(|axis| Parameter::plain(bounds[axis].0, axis, &bounds[axis].1)).into();
        Ok(Given { of, bounds, from, parameters })
    }

    /// Whether anything is given.
    pub fn is_given(&self) -> bool {
        self.a1.is_some() || self.r.is_some() || self.frequency.is_some()
    }

    /// Whether that is a box.
    pub fn is_box(&self) -> bool {
        let spans = [&self.a1, &self.a2, &self.r, &self.s];
        self.frequency.is_some() || spans.into_iter().flatten().any(Span::is_interval)
    }

    /// The parameters as middles and deviations: the distribution, and the box that its cells cover.
    ///
    /// # Errors
    /// An input error for what is not written `X±Y`, or not a number.
    pub fn normal(
        &self,
        of: &ParameterBox,
        bounds: &Bounds,
    ) -> Result<(NormalParameters, ParameterBox, Bounds)> {
        let spans = [&self.a1, &self.a2, &self.r, &self.s, &self.damping_ratio].into_iter().flatten();
        let mut all = spans.chain(self.frequency.as_ref().map(|frequency| &frequency.span));
        if all.any(|span| span.is_interval() && !span.1) {
            return Err(Error::input(
                "--normal: write a parameter as X±Y, where Y is its deviation, not A..=B",
            ));
        }
        let (normal, wide) = of.normal()?;
        let names = bounds.each_ref().map(|(name, _)| *name);
        let [first, second] = wide.bounds().clone();
        Ok((normal, wide, [(names[0], first), (names[1], second)]))
    }

    /// Whether the drive is known only up to a tolerance, so that not all natural over drive frequencies of
    /// the box count alike.
    pub fn drive_varies(&self) -> bool {
        self.drive.as_ref().is_some_and(|drive| drive.span.is_interval())
    }
}

/// Natural over drive frequency.
fn ratio(frequency: &Measure, drive: &Measure) -> Result<[BigRational; 2]> {
    let kind = |measure: &Measure| measure.unit.as_ref().map(|unit| unit.kind);
    if kind(frequency) != kind(drive) {
        let name = |measure: &Measure| kind(measure).unwrap_or("none");
        return Err(Error::input(format!(
            "--frequency and --drive need units of one kind, not {} and {}",
            name(frequency),
            name(drive)
        )));
    }
    let ([natural, natural_most], [drive, drive_most]) = (&frequency.span.0, &drive.span.0);
    if *drive <= BigRational::from_integer(0.into()) {
        return Err(Error::input(format!("--drive from {drive} to {drive_most}: above 0")));
    }
    Ok([natural / drive_most, natural_most / drive])
}

/// The coordinates of a point in LaTeX; one that was not given is left out.
pub(super) fn coordinates(
    plane: Option<(&BigRational, &BigRational)>,
    polar: Option<(&BigRational, &BigRational)>,
) -> String {
    let plane = plane.map(|(a1, a2)| format!("$a_1 = {a1}$, $a_2 = {a2}$"));
    plane.or_else(|| polar.map(|(r, s)| format!("$r = {r}$, $s = {s}$"))).unwrap_or_default()
}

/// As `97/100 <= r <= 49/50, 1/5 <= s <= 21/100`.
pub fn shown(bounds: &Bounds) -> String {
    let one =
        |(name, [lower, upper]): &(&str, [BigRational; 2])| format!("{lower} <= {} <= {upper}", spoken(name));
    format!("{}, {}", one(&bounds[0]), one(&bounds[1]))
}

/// As `natural/drive 1.2276..=1.2288, damping ratio 0.02..=0.021`, exactly.
pub(super) fn within(bounds: &Bounds) -> String {
    let one = |(name, [lower, upper]): &(&str, [BigRational; 2])| {
        format!("{} {}..={}", spoken(name), decimal_or_fraction(lower), decimal_or_fraction(upper))
    };
    format!("{}, {}", one(&bounds[0]), one(&bounds[1]))
}

/// A number as a decimal, if it is a short one, or else rounded.
pub(super) fn short(x: &BigRational) -> String {
    let is_whole = |places: &u32| (x * pow(BigInt::from(10), *places as usize)).is_integer();
    let places = (0..=12).find(is_whole);
    places.map_or_else(|| format!("about {}", decimal_near(x, 12)), |places| decimal_near(x, places))
}

/// A parameter in text.
pub(super) fn spoken(name: &str) -> &str {
    match name {
        "ratio" => "natural/drive",
        "damping_ratio" => "damping ratio",
        name => name,
    }
}

/// A parameter in LaTeX's maths mode.
fn in_maths(name: &str) -> &str {
    match name {
        "a1" => "a_1",
        "a2" => "a_2",
        "ratio" => "\\omega_0/\\Omega",
        "damping_ratio" => "\\zeta",
        name => name,
    }
}

/// The bounds in LaTeX.
pub(super) fn in_latex(bounds: &Bounds) -> String {
    let one = |(name, [lower, upper]): &(&str, [BigRational; 2])| {
        format!("${lower} \\le {} \\le {upper}$", in_maths(name))
    };
    format!("{}, {}", one(&bounds[0]), one(&bounds[1]))
}

/// As ` of natural/drive = 1.23±0.0123, damping ratio = 0.02±0.004, independent and normal`.
pub(super) fn distributed(bounds: &Bounds, parameters: &[[BigRational; 2]; 2]) -> String {
    let one = |i: usize| {
        let [middle, deviation] = parameters[i].each_ref().map(decimal_or_fraction);
        format!("{} = {middle}±{deviation}", spoken(bounds[i].0))
    };
    format!(" of {}, {}, independent and normal", one(0), one(1))
}

/// Middle and deviation of each parameter as JSON.
pub(super) fn json_normal(bounds: &Bounds, parameters: &[[BigRational; 2]; 2]) -> Json {
    let pairs = bounds.iter().zip(parameters);
    pairs
        .map(|((name, _), pair)| ((*name).to_string(), json!(pair.each_ref().map(ToString::to_string))))
        .collect()
}

/// The bounds as JSON, with the sign of γ of a machine's box: null where there is not one.
pub(super) fn json(bounds: &Bounds, gamma: Option<Option<bool>>) -> Json {
    let mut all = Map::new();
    for (name, ends) in bounds {
        all.insert((*name).into(), json!(ends.each_ref().map(ToString::to_string)));
    }
    if let Some(gamma) = gamma {
        all.insert("sign_gamma".into(), json!(gamma.map(|positive| if positive { 1 } else { -1 })));
    }
    Json::Object(all)
}
