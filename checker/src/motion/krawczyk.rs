//! Krawczyk's test.

use super::{Fault, Interval};
use crate::rejection::GoOn;

/// The box of `radii` about `centre`, one for each unknown.
pub(crate) fn around(centre: &[Interval], radii: &[Interval]) -> Vec<Interval> {
    centre.iter().zip(radii).map(|(y, &radius)| y.widened(radius)).collect()
}

/// K = y − C f(y) + (I − C f′(X))(X − y) for the box X of `radii` about the `centre` y: `inverse` is C,
/// `residual` f(y), `derivatives` f′(X). Every solution of f = 0 in X lies in K, and K in the interior of X
/// proves that there is exactly one and that f′ is regular there.
///
/// # Errors
/// A false claim, if K is not in the interior of X.
pub(crate) fn image(
    centre: &[Interval],
    inverse: &[Vec<Interval>],
    residual: &[Interval],
    derivatives: &[Vec<Interval>],
    radii: &[Interval],
    go_on: GoOn,
) -> Result<Vec<Interval>, Fault> {
    let region = around(centre, radii);
    let mut image = Vec::with_capacity(region.len());
    for (i, row) in inverse.iter().enumerate() {
        go_on()?;
        let mut value = centre[i];
        for (c, f) in row.iter().zip(residual) {
            value = value - *c * *f;
        }
        for (j, (x, y)) in region.iter().zip(centre).enumerate() {
            let product = row.iter().zip(derivatives).fold(Interval::ZERO, |sum, (c, d)| sum + *c * d[j]);
            let identity = if i == j { Interval::ONE } else { Interval::ZERO };
            value = value + (identity - product) * (*x - *y);
        }
        image.push(value);
    }
    let inside = |((k, y), r): ((&Interval, &Interval), &Interval)| k.is_within(*r, *y);
    match image.iter().zip(centre).zip(radii).position(|unknown| !inside(unknown)) {
        None => Ok(image),
        Some(i) => Err(Fault::False(format!(
            "Krawczyk's test does not map the box into itself in unknown {}",
            i + 1
        ))),
    }
}
