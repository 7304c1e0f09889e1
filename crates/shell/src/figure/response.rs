//! A frequency response: for each coordinate its swing over the parameter, and its lag below.

use std::f64::consts::FRAC_1_SQRT_2;

use super::{
    FigurePlace,
    canvas::{BLACK, BLUE, COLUMN, Canvas, GREY, RED, Stroke, Words, line},
    frame::{Axis, PlotFrame, padded, symbol},
    legend::Legend,
};
use crate::{
    error::Result,
    run::{BackboneRow, PeakRow, ResponseRow},
};

/// The radius of a peak's mark.
const PEAK: f64 = 1.6;
/// Coordinates that are drawn; the data have all.
const MOST: usize = 4;
/// The height of a panel of swings, and of one of lags.
const HIGH: [f64; 2] = [120.0, 74.0];
/// The ways and their names: the linear one is broken, the way down is drawn over the way up.
const WAYS: [(&str, &str); 4] =
    [("linear", "linear, free"), ("up", "seen, up"), ("down", "seen, down"), ("unstable", "unstable")];
/// How many times as high as what is seen a linear response is shown.
const ABOVE: f64 = 3.0;
/// A lag that changes by more than this part of a turn between neighbours has gone once round.
const ROUND: f64 = 0.5;

/// Writes the picture; the data beside it are all swings, which whoever found them writes.
///
/// # Errors
/// An I/O error.
pub fn response(
    rows: &[ResponseRow],
    peaks: &[PeakRow],
    backbone: &[BackboneRow],
    parameter: &str,
    place: &FigurePlace,
) -> Result<()> {
    place.draw(&draw(rows, peaks, backbone, parameter))
}

fn stroke(way: usize) -> Stroke {
    match way {
        0 => Stroke { dashes: Some([4.0, 2.4]), ..line(GREY, 0.9) },
        1 => line(BLUE, 1.6),
        2 => line(RED, 0.7),
        _ => Stroke { dashes: Some([1.6, 1.2]), ..line(BLACK, 0.6) },
    }
}

fn draw(rows: &[ResponseRow], peaks: &[PeakRow], backbone: &[BackboneRow], parameter: &str) -> Canvas {
    let mut names: Vec<&str> = Vec::new();
    for row in rows {
        if !names.contains(&row.coordinate.as_str()) && !row.coordinate.starts_with("gap ") {
            names.push(&row.coordinate);
        }
    }
    // Without a drive there is but the backbone.
    for row in backbone {
        if !names.contains(&row.coordinate.as_str()) {
            names.push(&row.coordinate);
        }
    }
    names.truncate(MOST);
    let mut legend = Legend::default();
    for (i, (way, name)) in WAYS.iter().enumerate() {
        if rows.iter().any(|row| row.way == *way) {
            legend.add(*name, move |canvas: &mut Canvas, (x, y)| {
                canvas.line(vec![(x - 9.0, y), (x + 9.0, y)], stroke(i));
            });
        }
    }
    if peaks.iter().any(|peak| names.contains(&peak.coordinate.as_str()) && peak.amplitude.is_some()) {
        legend.add("linear peak, half power", |canvas: &mut Canvas, (x, y)| {
            canvas.line(vec![(x - 6.0, y), (x + 6.0, y)], line(BLACK, 0.6));
            canvas.disc((x, y), PEAK, BLACK);
        });
    }
    if !backbone.is_empty() {
        legend.add("backbone", |canvas: &mut Canvas, (x, y)| {
            canvas.discs((-3..=3).map(|i| (x + 3.0 * f64::from(i), y)).collect(), 0.6, BLACK);
        });
    }
    let each = HIGH[0] + HIGH[1];
    let high = each * names.len().max(1) as f64;
    let mut canvas = Canvas::new(
        COLUMN,
        high + 2.0 + legend.height(COLUMN - 8.0),
        "Frequency response",
        &format!(
            "Swing (half peak to peak) and lag (in degrees) of {} over {parameter}: the linear response broken, what is seen on the way up \
             and on the way down solid, unstable orbits thin and broken.",
            names.join(", ")
        ),
    );
    let frames: Vec<[PlotFrame; 2]> = names
        .iter()
        .enumerate()
        .map(|(i, name)| {
            let own = || rows.iter().filter(|row| row.coordinate == **name);
            let across = inside(rows.iter().map(|row| row.value).chain(backbone.iter().map(|row| row.value)));
            let free = backbone.iter().filter(|row| row.coordinate == **name);
            let free = free.map(|row| row.swing).fold(0.0, f64::max);
            let high = if rows.is_empty() { 1.06 * free } else { highest(own()) };
            let top = 2.0 + each * i as f64;
            let swings = PlotFrame::new(
                [2.0, top, COLUMN - 2.0, top + HIGH[0]],
                Axis::linear("", across, 6),
                Axis::linear(Words::plain(&format!("swing of {name}")), (0.0, high), 5),
            );
            let marks = [0, 90, 180, 270, 360].map(|x| (f64::from(x), Words::plain(&x.to_string())));
            let lags = PlotFrame::new(
                [2.0, top + HIGH[0], COLUMN - 2.0, top + each],
                Axis::linear(symbol(parameter), across, 6),
                Axis::marked("lag, °", (0.0, 360.0), false, marks.to_vec()),
            );
            [swings, lags]
        })
        .collect();
    let looked_at = rows.iter().filter(|row| row.stretch.is_none());
    let mut values: Vec<f64> = looked_at.map(|row| row.value).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    let width = values.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    let left = frames.iter().flatten().map(|frame| frame.left).fold(0.0, f64::max);
    for (name, pair) in names.iter().zip(frames) {
        let [swings, lags] = pair.map(|frame| frame.with_left(left));
        for (way, (word, _)) in WAYS.iter().enumerate() {
            let own: Vec<&ResponseRow> =
                rows.iter().filter(|row| row.coordinate == **name && row.way == *word).collect();
            for piece in pieces(&own, width) {
                let path = swings.path(piece.iter().map(|row| (row.value, row.swing)));
                canvas.inside(swings.inside(), |canvas| canvas.line(path, stroke(way)));
                for part in turns(piece) {
                    canvas.line(lags.path(part), stroke(way));
                }
            }
        }
        for peak in peaks.iter().filter(|peak| peak.coordinate == **name) {
            let Some(amplitude) = peak.amplitude else { continue };
            let half = amplitude * FRAC_1_SQRT_2;
            if let (Some(lower), Some(upper)) = (peak.lower, peak.upper) {
                let path = swings.path([(lower, half), (upper, half)]);
                canvas.inside(swings.inside(), |canvas| canvas.line(path, line(BLACK, 0.6)));
            }
            let at = swings.path([(peak.value, amplitude)]);
            canvas.discs(at.into_iter().filter(|at| swings.holds(*at)).collect(), PEAK, BLACK);
        }
        let own = backbone.iter().filter(|row| row.coordinate == **name);
        let dots = swings.path(own.map(|row| (row.value, row.swing)));
        canvas.discs(dots.into_iter().filter(|at| swings.holds(*at)).collect(), 0.6, BLACK);
        swings.draw(&mut canvas);
        lags.draw(&mut canvas);
    }
    legend.draw(&mut canvas, (4.0, high + 1.0), COLUMN - 8.0);
    canvas
}

/// How far up an axis goes: all that is seen is shown, and of a linear response beyond that a part.
fn highest<'r>(rows: impl Iterator<Item = &'r ResponseRow> + Clone) -> f64 {
    let most = |seen: bool| {
        rows.clone().filter(|row| (row.way != "linear") == seen).map(|row| row.swing).fold(0.0, f64::max)
    };
    let shown =
        if most(true) > 0.0 { most(false).min(ABOVE * most(true)).max(most(true)) } else { most(false) };
    if shown > 0.0 { 1.06 * shown } else { 1.0 }
}

/// The rows of a way at neighbouring values, which are `width` apart: between them some are lost. Those of
/// unstable orbits are a stretch each.
fn pieces<'s, 'r>(rows: &'s [&'r ResponseRow], width: f64) -> impl Iterator<Item = &'s [&'r ResponseRow]> {
    rows.chunk_by(move |a, b| match a.stretch {
        Some(_) => a.stretch == b.stretch,
        None => (a.value - b.value).abs() < 1.5 * width,
    })
}

/// The range of some values.
fn inside(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    if low < high { (low, high) } else { padded([low, high].into_iter()) }
}

/// Lags in degrees, cut where they are not known and where a turn ends.
fn turns(rows: &[&ResponseRow]) -> Vec<Vec<(f64, f64)>> {
    let mut pieces: Vec<Vec<(f64, f64)>> = vec![Vec::new()];
    let mut before: Option<f64> = None;
    for row in rows {
        if before.zip(row.lag).is_none_or(|(a, b)| (a - b).abs() > ROUND) {
            pieces.push(Vec::new());
        }
        if let (Some(lag), Some(piece)) = (row.lag, pieces.last_mut()) {
            piece.push((row.value, 360.0 * lag));
        }
        before = row.lag;
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lags_are_cut_where_a_turn_ends_and_where_there_are_none() {
        let row = |value: f64, lag: Option<f64>| ResponseRow {
            way: "linear",
            value,
            coordinate: "q".into(),
            swing: 1.0,
            amplitude: 1.0,
            lag,
            period: Some(1),
            impacts: Some(0),
            stop: None,
            stretch: None,
        };
        let lags = [Some(0.1), Some(0.4), None, Some(0.9), Some(0.05)];
        let rows: Vec<ResponseRow> = lags.iter().zip(0..).map(|(lag, i)| row(f64::from(i), *lag)).collect();
        let pieces = turns(&rows.iter().collect::<Vec<_>>());
        assert_eq!(pieces.iter().map(Vec::len).collect::<Vec<_>>(), [2, 1, 1]);
        assert_eq!(pieces[0], [(0.0, 36.0), (1.0, 144.0)]);
    }
}
