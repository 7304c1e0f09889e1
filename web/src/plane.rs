//! The Plane panel: which orbits a grazing bifurcation gives birth to, over the point (a₁, a₂) or (r, s).
//!
//! | function | request | answer |
//! | --- | --- | --- |
//! | [`view`] | `chart` (`plane`, `disc`, `strip`), the exact centre `x`, `y`, `width`, `height`, `pixels_x`, `pixels_y`; `max_n`, `sign` and `gamma` (`+`, `-`), `only` (one period), `words` (true: words and entropies), `limit` | the areas, in the order of painting, relative to `origin` |
//! | [`point`](fn@point) | `a1` and `a2`, or `r` and `s`; `max_n` | words, orbits and reasons, powers of λ |
//! | [`certificate`] | such a point; `by_theorem` | `certificate`, or `undecided` with the reason |
//! | [`shares`](fn@shares) | `a1` and `a2`, or `r` and `s`, each with both ends; `cells` | what holds for all of that box, and shares of it |
//! | [`place`] | such a point; `chart`, `bits` | its place `x`, `y` there, and whether that is `exact` |
//!
//! Requests and answers are JSON; numbers of a place are exact, as text. What is certain and what is drawn:
//! see `plane/shape.rs` and `plane/areas.rs`.

mod areas;
mod chart;
mod point;
mod shape;
mod shares;
#[cfg(test)]
mod tests;

use serde_json::Value as Json;

use crate::answer::requested;

fn answer(request: &str, give: fn(&Json) -> grazing_scenes::Result<Json>) -> String {
    requested(request, |request| Ok(give(&request)?))
}

/// The areas in a view.
pub fn view(request: &str) -> String {
    answer(request, areas::view)
}

/// What is true at a point.
pub fn point(request: &str) -> String {
    answer(request, point::point)
}

/// The certificate of a point's words.
pub fn certificate(request: &str) -> String {
    answer(request, point::certificate)
}

/// What holds for all of a box, and shares of it.
pub fn shares(request: &str) -> String {
    answer(request, shares::shares)
}

/// Where a point lies in a chart.
pub fn place(request: &str) -> String {
    answer(request, point::place)
}
