//! Krawczyk's test.

use super::{Fault, Interval};

/// Asked now and then whether the work should go on.
pub(crate) type GoOn<'a> = &'a mut dyn FnMut() -> Result<(), Fault>;

/// The box of `radius` about `centre`.
pub(crate) fn around(centre: &[Interval], radius: Interval) -> Vec<Interval> {
    centre.iter().map(|y| y.widened(radius)).collect()
}

/// K = y − C f(y) + (I − C f′(X))(X − y) for the box X of `radius` about the `centre` y: `inverse` is C,
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
    radius: Interval,
    go_on: GoOn,
) -> Result<Vec<Interval>, Fault> {
    let region = around(centre, radius);
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
    match image.iter().zip(centre).position(|(k, y)| !k.is_within(radius, *y)) {
        None => Ok(image),
        Some(i) => Err(Fault::False(format!(
            "Krawczyk's test does not map the box into itself in unknown {}",
            i + 1
        ))),
    }
}
