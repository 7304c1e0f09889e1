//! One case of Conjecture 1: a period and a point, with its line in a file.

use std::fmt;

use crate::{
    error::{Error, Result},
    local::{Plane, Point, Polar},
    number::parse_rational,
};

/// A period and a point, at which the conjecture claims something.
#[derive(Debug, Clone)]
pub struct Instance {
    /// The period.
    pub n: u64,
    /// The point.
    pub point: Point,
}

impl Instance {
    /// The command-line arguments of `grazing classify` that show this case.
    pub fn arguments(&self) -> String {
        match &self.point {
            Point::Polar(polar) => format!("--r {} --s {} --max-period {}", polar.r(), polar.s(), self.n),
            Point::Plane(plane) => format!("--a1 {} --a2 {} --max-period {}", plane.a1(), plane.a2(), self.n),
        }
    }
}

/// A case as a line of a regression file: `N polar R S` or `N plane A1 A2`.
impl fmt::Display for Instance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.point {
            Point::Polar(polar) => write!(f, "{} polar {} {}", self.n, polar.r(), polar.s()),
            Point::Plane(plane) => write!(f, "{} plane {} {}", self.n, plane.a1(), plane.a2()),
        }
    }
}

impl std::str::FromStr for Instance {
    type Err = Error;

    fn from_str(line: &str) -> Result<Self> {
        let fail = || Error::input(format!("{line:?} is not a case: write N polar R S or N plane A1 A2"));
        let words: Vec<&str> = line.split_whitespace().collect();
        let [n, kind, a, b] = words[..] else { return Err(fail()) };
        let (n, a, b) = (n.parse().map_err(|_| fail())?, parse_rational(a)?, parse_rational(b)?);
        let point = match kind {
            "polar" => Point::Polar(Polar::new(a, b)?),
            "plane" => Point::Plane(Plane::new(a, b)?),
            _ => return Err(fail()),
        };
        if n == 0 { Err(fail()) } else { Ok(Instance { n, point }) }
    }
}
