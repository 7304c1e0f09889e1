//! Krawczyk's test.

use super::{Fault, Interval, text::Decimal};
use crate::rejection::{GoOn, claim};

/// As many equations as unknowns.
pub(crate) trait Equations {
    /// Their left sides at a point.
    fn residual(&self, x: &[Interval], go_on: GoOn) -> Result<Vec<Interval>, Fault>;

    /// Their derivatives over a box, by rows.
    fn derivatives(&self, x: &[Interval], go_on: GoOn) -> Result<Vec<Vec<Interval>>, Fault>;
}

/// Two boxes about a centre, as a certificate lists them, and the test's preconditioner.
pub(crate) struct Boxes {
    centre: Vec<Interval>,
    /// The unit of each unknown in which the radii are meant.
    pub units: Vec<Interval>,
    /// The larger and the smaller one.
    radii: [Interval; 2],
    inverse: Vec<Vec<Interval>>,
}

/// Decimals, enclosed.
pub(crate) fn enclosed(list: &[Decimal]) -> Vec<Interval> {
    list.iter().map(|x| x.enclosed()).collect()
}

impl Boxes {
    pub fn new(
        centre: Vec<Interval>,
        units: Vec<Interval>,
        radii: [Decimal; 2],
        inverse: &[Vec<Decimal>],
    ) -> Boxes {
        let inverse = inverse.iter().map(|row| enclosed(row)).collect();
        Boxes { centre, units, radii: radii.map(|radius| radius.enclosed()), inverse }
    }

    /// The only solution in the larger box, enclosed by the test in the smaller one.
    ///
    /// # Errors
    /// A false claim, where the radii are out of order or the test fails in one of the boxes.
    pub fn solution(&self, equations: &impl Equations, go_on: GoOn) -> Result<Vec<Interval>, Fault> {
        let [radius, within] = self.radii;
        let ordered = within.is_positive() && within.is_up_to(radius);
        claim(ordered, "the smaller radius must be positive and at most the larger")?;
        self.image(equations, radius, go_on)?;
        self.image(equations, within, go_on)
    }

    /// K = y − C f(y) + (I − C f′(X))(X − y) for the box X of this radius about the centre y: C is the
    /// preconditioner. Every solution of f = 0 in X lies in K, and K in the interior of X proves that there
    /// is exactly one and that f′ is regular there.
    ///
    /// # Errors
    /// A false claim, if K is not in the interior of X.
    fn image(
        &self,
        equations: &impl Equations,
        radius: Interval,
        go_on: GoOn,
    ) -> Result<Vec<Interval>, Fault> {
        let Boxes { centre, units, inverse, .. } = self;
        let radii: Vec<Interval> = units.iter().map(|&unit| radius * unit).collect();
        let region: Vec<Interval> = centre.iter().zip(&radii).map(|(y, &r)| y.widened(r)).collect();
        let residual = equations.residual(centre, go_on)?;
        let derivatives = equations.derivatives(&region, go_on)?;
        let mut image = Vec::with_capacity(region.len());
        for (i, row) in inverse.iter().enumerate() {
            go_on()?;
            let mut value = centre[i];
            for (c, f) in row.iter().zip(&residual) {
                value = value - *c * *f;
            }
            for (j, (x, y)) in region.iter().zip(centre).enumerate() {
                let product =
                    row.iter().zip(&derivatives).fold(Interval::ZERO, |sum, (c, d)| sum + *c * d[j]);
                let identity = if i == j { Interval::ONE } else { Interval::ZERO };
                value = value + (identity - product) * (*x - *y);
            }
            image.push(value);
        }
        for (i, k) in image.iter().enumerate() {
            let unknown = i + 1;
            let holds = k.is_within(radii[i], centre[i]);
            claim(
                holds,
                format_args!("Krawczyk's test does not map the box into itself in unknown {unknown}"),
            )?;
        }
        Ok(image)
    }
}
