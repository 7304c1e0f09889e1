//! Axes: those of the (a₁, a₂) plane, and those that name what is measured.

use plotters::{coord::types::RangedCoordf64, prelude::*};

use super::FONT;

/// A chart of two real numbers.
pub(super) type Panel<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

type Drawn<'a> = std::result::Result<(), Box<dyn std::error::Error + 'a>>;

/// Draws the axes of the (a₁, a₂) plane, with about `marks` marks on the first and `digits` decimals on the
/// second.
pub(super) fn plane_axes<'a>(chart: &mut Panel<'a, '_>, marks: usize, digits: usize) -> Drawn<'a> {
    let first = |x: &f64| format!("{x:.0}").replace('-', "−");
    draw(chart, marks, ["a₁", "a₂"], &first, &|y| format!("{y:.digits$}"))
}

/// Draws axes with their names and about `marks` marks on the first.
pub(super) fn labelled_axes<'a>(chart: &mut Panel<'a, '_>, marks: usize, names: [&str; 2]) -> Drawn<'a> {
    draw(chart, marks, names, &|x| tidy(*x), &|y| tidy(*y))
}

fn draw<'a>(
    chart: &mut Panel<'a, '_>,
    marks: usize,
    names: [&str; 2],
    first: &dyn Fn(&f64) -> String,
    second: &dyn Fn(&f64) -> String,
) -> Drawn<'a> {
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(marks)
        .y_labels(6)
        .x_label_formatter(first)
        .y_label_formatter(second)
        .x_desc(symbol(names[0]))
        .y_desc(symbol(names[1]))
        .label_style(("sans-serif", FONT))
        .axis_desc_style(("sans-serif", FONT + 6))
        .axis_style(BLACK.stroke_width(3))
        .set_all_tick_mark_size(16)
        .draw()
        .map_err(|error| error.to_string().into())
}

/// The letter that a parameter's name spells, as in `mu`, or the name.
fn symbol(name: &str) -> &str {
    const LETTERS: [(&str, &str); 14] = [
        ("alpha", "α"),
        ("beta", "β"),
        ("gamma", "γ"),
        ("delta", "δ"),
        ("epsilon", "ε"),
        ("zeta", "ζ"),
        ("lambda", "λ"),
        ("mu", "µ"),
        ("nu", "ν"),
        ("rho", "ρ"),
        ("sigma", "σ"),
        ("tau", "τ"),
        ("phi", "φ"),
        ("omega", "ω"),
    ];
    LETTERS.iter().find(|(word, _)| *word == name).map_or(name, |(_, letter)| letter)
}

/// The range of some numbers with a margin, never empty.
pub(super) fn padded(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return (-1.0, 1.0);
    }
    // One value, to rounding, is shown by its own size.
    let alone = high - low <= 1e-9 * high.abs();
    let margin = if alone { 0.1 * high.abs() } else { 0.06 * (high - low) } + 1e-6 * (1.0 + high.abs());
    (low - margin, high + margin)
}

/// A number of an axis, without the digits that rounding adds.
fn tidy(x: f64) -> String {
    let text = format!("{x:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.replace('-', "−") }
}
