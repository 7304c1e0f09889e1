//! Branches of periodic orbits over a parameter, with attractors behind them: stable solid, unstable broken,
//! what is proved on a band.

use std::collections::HashSet;

use super::{
    FigurePlace, View,
    canvas::{Anchor, At, BLACK, BLUE, COLUMN, Canvas, Colour, RED, SKY, Stroke, Words, line},
    frame::{Axis, PlotFrame, padded, symbol},
    labels::{DOT, Labels, SMALL, TextAt},
    legend::Legend,
    view::PlaneView,
};
use crate::{
    error::{Error, Result},
    run::Judgement,
};

/// A branch as it is drawn.
pub struct DrawnBranch {
    /// What it is, for the CSV.
    pub name: String,
    /// Parameter, displacement, what is said of the orbit.
    pub at: Vec<(f64, f64, Said)>,
    /// Labels: parameter, displacement, text.
    pub labels: Vec<(f64, f64, String)>,
}

/// What is said of an orbit; on a curve of bifurcations nothing.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Said {
    /// Whether it is stable.
    pub stable: Option<Judgement>,
    /// Over which values of the parameter it is proved, if it is.
    pub proved: Option<[f64; 2]>,
}

/// Points of attractors.
pub struct Scatter {
    /// What they are, for the CSV.
    pub name: String,
    /// Whether the parameter was swept up to them, if it was swept.
    pub up: Option<bool>,
    /// Parameter, displacement.
    pub at: Vec<(f64, f64)>,
}

impl Scatter {
    /// How its points are drawn: those of the way down over those of the way up, and seen beside them where
    /// both are on one attractor.
    fn dot(&self) -> (f64, Colour) {
        match self.up {
            None => (0.3, BLUE),
            Some(true) => (0.75, SKY),
            Some(false) => (0.35, RED),
        }
    }
}

/// Writes the picture and its data: a row per point, with the name of its curve, its stability
/// and its label.
///
/// # Errors
/// An I/O error.
pub fn branches(
    curves: &[DrawnBranch],
    scatter: &[Scatter],
    axes: [&str; 2],
    place: &FigurePlace,
) -> Result<()> {
    let mut rows = Vec::new();
    for curve in curves {
        for (x, y, said) in &curve.at {
            let label = curve.labels.iter().find(|label| (label.0, label.1) == (*x, *y));
            rows.push(vec![
                curve.name.clone(),
                x.to_string(),
                y.to_string(),
                stability(said.stable).to_string(),
                label.map_or(String::new(), |label| label.2.clone()),
                said.proved.map_or("", |_| "yes").to_string(),
            ]);
        }
    }
    for set in scatter {
        let row = |(x, y): &(f64, f64)| {
            let [none, nor] = [String::new(), String::new()];
            vec![set.name.clone(), x.to_string(), y.to_string(), "attracting".into(), none, nor]
        };
        rows.extend(set.at.iter().map(row));
    }
    let view = &place.view;
    let canvas = match view.is_whole() {
        true => draw(curves, scatter, axes, view),
        false => {
            let (curves, scatter) = seen(curves, scatter, &view.on(axes)?)?;
            draw(&curves, &scatter, axes, view)
        }
    };
    place.save(&canvas, &["set", "parameter", "q", "stability", "label", "proved"], &rows)
}

/// Writes the picture of orbits, in the plane of two numbers, and its data: a row per place.
///
/// # Errors
/// An I/O error.
pub fn orbits_of_branches(curves: &[DrawnBranch], axes: [&str; 2], place: &FigurePlace) -> Result<()> {
    let mut rows = Vec::new();
    for curve in curves {
        let row = |(q, u, said): &(f64, f64, Said)| {
            vec![curve.name.clone(), q.to_string(), u.to_string(), stability(said.stable).to_string()]
        };
        rows.extend(curve.at.iter().map(row));
    }
    place.save(&draw(curves, &[], axes, &View::default()), &["set", "q", "u", "stability"], &rows)
}

/// What of the curves and attractors a view shows; a curve in pieces has its name at each, but for pieces of
/// turns, of which the first has it.
fn seen(
    curves: &[DrawnBranch],
    scatter: &[Scatter],
    plane: &PlaneView,
) -> Result<(Vec<DrawnBranch>, Vec<Scatter>)> {
    let mut pieces = Vec::new();
    for curve in curves {
        let shown = |(x, y, text): &(f64, f64, String)| (plane.of((*x, *y)), text.clone());
        let labels = curve.labels.iter().map(shown).filter(|(at, _)| plane.holds(*at));
        let mut labels: Vec<_> = labels.map(|((x, y), text)| (x, y, text)).collect();
        let mut name = curve.name.clone();
        for at in plane.pieces(&curve.at) {
            let labels = std::mem::take(&mut labels);
            pieces.push(DrawnBranch { name: name.clone(), at, labels });
            if plane.turns() {
                name.clear();
            }
        }
    }
    let sets = scatter.iter().map(|set| {
        let Scatter { name, up, at } = set;
        Scatter { name: name.clone(), up: *up, at: plane.points(at) }
    });
    let sets: Vec<Scatter> = sets.filter(|set| !set.at.is_empty()).collect();
    if pieces.is_empty() && sets.is_empty() {
        return Err(Error::input("nothing is within the limits of the picture: choose others"));
    }
    Ok((pieces, sets))
}

fn stability(stable: Option<Judgement>) -> &'static str {
    match stable {
        Some(Judgement::Yes) => "stable",
        Some(Judgement::No) => "unstable",
        Some(Judgement::Marginal) => "marginal",
        None => "",
    }
}

impl DrawnBranch {
    /// Which points have a solid line: those that are not unstable. One that rounding decides goes with what
    /// follows it, or, at the end, with what comes before.
    fn solid(&self) -> Vec<bool> {
        let decided = |i: &usize| self.at[*i].2.stable != Some(Judgement::Marginal);
        let count = self.at.len();
        let near = |i: usize| (i..count).find(decided).or((0..i).rev().find(decided));
        (0..count).map(|i| near(i).is_some_and(|i| self.at[i].2.stable != Some(Judgement::No))).collect()
    }
}

impl DrawnBranch {
    /// What is proved of it on paper: between points of which one is proved as far as its proof goes.
    fn bands(&self, path: &Smooth, frame: &PlotFrame) -> Vec<Vec<At>> {
        let mut bands: Vec<Vec<At>> = Vec::new();
        for (i, pair) in self.at.windows(2).enumerate() {
            let [one, other] = [pair[0].2.proved, pair[1].2.proved];
            let Some(over) = one.or(other) else { continue };
            let [from, to] = over.map(|value| frame.at((value, pair[0].1)).0);
            let inside = |at: &At| (one.is_some() && other.is_some()) || (from..=to).contains(&at.0);
            let piece: Vec<At> = path.points(i, i + 1).into_iter().filter(inside).collect();
            match bands.last_mut().filter(|band| band.last() == piece.first()) {
                Some(band) => band.extend(&piece[1..]),
                None => bands.push(piece),
            }
        }
        bands.retain(|band| band.len() > 1);
        bands
    }
}

/// The band under what is proved: its width and colour.
const BAND: (f64, Colour) = (5.0, Colour(190, 222, 208));

/// Lengths of a dash and of the gap after it.
const DASHES: [f64; 2] = [4.0, 2.4];

/// The stroke of a stretch of this length: one that is not solid shows gaps, however short it is.
fn stroke(solid: bool, length: f64) -> Stroke {
    let part = (length / (3.0 * (DASHES[0] + DASHES[1]))).min(1.0);
    Stroke { dashes: (!solid).then_some(DASHES.map(|dash| dash * part)), ..line(BLACK, 0.8) }
}

fn length(path: &[At]) -> f64 {
    path.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1)).sum()
}

fn draw(curves: &[DrawnBranch], scatter: &[Scatter], axes: [&str; 2], view: &View) -> Canvas {
    let mut legend = Legend::default();
    let solid: Vec<Vec<bool>> = curves.iter().map(DrawnBranch::solid).collect();
    let any = |wanted| solid.iter().flatten().any(|&solid| solid == wanted);
    for (wanted, name) in [(true, "stable"), (false, "unstable")] {
        // All of one kind of line needs no name in a plane of two parameters.
        if any(wanted) && (any(!wanted) || !scatter.is_empty()) {
            legend.add(name, move |canvas: &mut Canvas, (x, y): At| {
                canvas.line(vec![(x - 9.0, y), (x + 9.0, y)], stroke(wanted, f64::INFINITY));
            });
        }
    }
    if curves.iter().flat_map(|curve| &curve.at).any(|at| at.2.proved.is_some()) {
        legend.add("proved", |canvas: &mut Canvas, (x, y): At| {
            canvas.line(vec![(x - 9.0, y), (x + 9.0, y)], line(BAND.1, BAND.0));
        });
    }
    for (up, name) in [(None, "attractors"), (Some(true), "swept up"), (Some(false), "swept down")] {
        let Some(set) = scatter.iter().find(|set| set.up == up && !set.at.is_empty()) else { continue };
        let (size, colour) = set.dot();
        legend.add(name, move |canvas: &mut Canvas, (x, y): At| {
            canvas.discs((-3..=3).map(|i| (x + 2.0 * f64::from(i), y)).collect(), size.max(0.4), colour);
        });
    }
    let high = legend.height(COLUMN - 8.0);
    let mut canvas = Canvas::new(
        COLUMN,
        190.0 + high,
        "Branches of periodic orbits over a parameter",
        &format!(
            "{} over {}: stable solid, unstable broken, what is proved on a band, attractors as dots.",
            axes[1], axes[0]
        ),
    );
    let all = || {
        let lines = curves.iter().flat_map(|curve| curve.at.iter().map(|at| (at.0, at.1)));
        lines.chain(scatter.iter().flat_map(|set| set.at.iter().copied()))
    };
    let framed = |beside: f64| {
        PlotFrame::new(
            [2.0, 2.0, COLUMN - 2.0 - beside, 188.0],
            Axis::linear(symbol(axes[0]), view.x.unwrap_or_else(|| padded(all().map(|at| at.0))), 5),
            Axis::linear(symbol(axes[1]), view.y.unwrap_or_else(|| padded(all().map(|at| at.1))), 6),
        )
    };
    let path = |curve: &DrawnBranch, frame: &PlotFrame| frame.path(curve.at.iter().map(|at| (at.0, at.1)));
    let paths_in = |frame: &PlotFrame| curves.iter().map(|curve| path(curve, frame)).collect::<Vec<_>>();
    // Beside it stand the names of curves that go on to the right.
    let (ends, _) = names(curves, &paths_in(&framed(0.0)));
    let wide = ends.iter().map(|(_, text)| 4.0 + Words::plain(text).width(SMALL)).fold(0.0, f64::max);
    let frame = framed(wide);
    for up in [None, Some(true), Some(false)] {
        let Some((size, colour)) = scatter.iter().find(|set| set.up == up).map(Scatter::dot) else {
            continue;
        };
        // One dot for those that would cover each other.
        let mut seen = HashSet::new();
        let sets = scatter.iter().filter(|set| set.up == up);
        let dots = sets.flat_map(|set| &set.at).map(|at| frame.at(*at));
        let fine = |(x, y): &At| seen.insert(((x * 8.0).round() as i64, (y * 8.0).round() as i64));
        canvas.discs(dots.filter(fine).collect(), size, colour);
    }
    let paths = paths_in(&frame);
    let smooth: Vec<Smooth> = paths.iter().map(|path| Smooth(path)).collect();
    let lines: Vec<Vec<At>> = smooth.iter().map(|curve| curve.points(0, usize::MAX)).collect();
    let bands = curves.iter().zip(&smooth).flat_map(|(curve, path)| curve.bands(path, &frame)).collect();
    canvas.lines(bands, line(BAND.1, BAND.0));
    let mut labels = Labels::new(&lines, frame.inside());
    let mut marked: Vec<TextAt> = Vec::new();
    for ((curve, path), solid) in curves.iter().zip(&smooth).zip(&solid) {
        let mut start = 0;
        for stretch in solid.chunk_by(|a, b| a == b) {
            let end = start + stretch.len();
            let points = path.points(start, end);
            let drawn = stroke(stretch[0], length(&points));
            canvas.line(points, drawn);
            start = end;
        }
        marked.extend(curve.labels.iter().map(|(x, y, text)| (frame.at((*x, *y)), text.clone())));
    }
    labels.dots = marked.iter().map(|(at, _)| *at).collect();
    canvas.discs(labels.dots.clone(), DOT, BLACK);
    labels.wanted = together(&marked);
    let (ends, beside) = names(curves, &paths);
    labels.wanted.extend(beside);
    for ((_, y), text) in ends {
        canvas.sized(Words::plain(&text), (frame.right + 3.0, y), Anchor::Start, SMALL);
    }
    labels.draw(&mut canvas);
    frame.draw(&mut canvas);
    legend.draw(&mut canvas, (4.0, 189.0), COLUMN - 8.0);
    canvas
}

/// Events whose dots are one on paper under one text: each kind once, with how many there are.
fn together(events: &[TextAt]) -> Vec<TextAt> {
    let mut groups: Vec<(At, Vec<(&str, usize)>)> = Vec::new();
    for (at, kind) in events {
        let near = |group: &&mut (At, Vec<(&str, usize)>)| (group.0.0 - at.0).hypot(group.0.1 - at.1) < DOT;
        match groups.iter_mut().find(near) {
            None => groups.push((*at, vec![(kind, 1)])),
            Some((_, kinds)) => match kinds.iter_mut().find(|known| known.0 == kind) {
                Some((_, count)) => *count += 1,
                None => kinds.push((kind, 1)),
            },
        }
    }
    let named = |(kind, count): (&str, usize)| match count {
        1 => kind.to_string(),
        many => format!("{kind} ×{many}"),
    };
    let text = |kinds: Vec<(&str, usize)>| kinds.into_iter().map(named).collect::<Vec<_>>().join(", ");
    groups.into_iter().map(|(at, kinds)| (at, text(kinds))).collect()
}

/// The names of curves. Those of curves that go on to the right stand at their ends, one for ends that are
/// close; the others beside the curve.
fn names(curves: &[DrawnBranch], paths: &[Vec<At>]) -> (Vec<TextAt>, Vec<TextAt>) {
    let (mut ends, mut beside): (Vec<TextAt>, Vec<TextAt>) = (Vec::new(), Vec::new());
    let far_right = paths.iter().flatten().map(|at| at.0).fold(f64::NEG_INFINITY, f64::max);
    for (curve, path) in curves.iter().zip(paths) {
        let end = path.iter().copied().max_by(|a, b| a.0.total_cmp(&b.0));
        let (Some(name), Some(end)) = (short(&curve.name), end) else { continue };
        if curves.len() == 1 || end.0 < far_right - 2.5 {
            beside.push((path[path.len() * 2 / 3], name));
        } else if let Some((_, names)) = ends.iter_mut().find(|(at, _)| (at.1 - end.1).abs() < 7.0) {
            *names += &format!(" {name}");
        } else {
            ends.push((end, name));
        }
    }
    (ends, beside)
}

/// A pattern of more characters than this is named by how many impacts it has.
const LONGEST_NAME: usize = 30;

/// A curve through points without corners: a centripetal Catmull–Rom spline, which makes no loops.
struct Smooth<'a>(&'a [At]);

impl Smooth<'_> {
    /// Close points of the curve from one of its points to another, or to its end.
    fn points(&self, from: usize, to: usize) -> Vec<At> {
        let to = to.min(self.0.len().saturating_sub(1));
        let mut all: Vec<At> = self.0.get(from).copied().into_iter().collect();
        for i in from..to {
            self.piece(i, &mut all);
        }
        all
    }

    /// The piece between two points, without its beginning.
    fn piece(&self, i: usize, all: &mut Vec<At>) {
        let (p, q) = (self.0[i], self.0[i + 1]);
        let length = (q.0 - p.0).hypot(q.1 - p.1);
        let steps = (length / 1.5).ceil().clamp(1.0, 200.0) as usize;
        // Beyond an end the curve goes straight on.
        let mirror = |a: At, b: At| (2.0 * a.0 - b.0, 2.0 * a.1 - b.1);
        let before = if i > 0 { self.0[i - 1] } else { mirror(p, q) };
        let after = self.0.get(i + 2).copied().unwrap_or(mirror(q, p));
        let gap = |a: At, b: At| (b.0 - a.0).hypot(b.1 - a.1).sqrt();
        let (d0, d1, d2) = (gap(before, p), gap(p, q), gap(q, after));
        if steps == 1 || d0 < 1e-6 || d2 < 1e-6 {
            all.push(q);
            return;
        }
        // The derivatives at both ends, times d1.
        let slope = |x0: f64, x1: f64, x2: f64, x3: f64| {
            let first = (x1 - x0) / d0 - (x2 - x0) / (d0 + d1) + (x2 - x1) / d1;
            let second = (x2 - x1) / d1 - (x3 - x1) / (d1 + d2) + (x3 - x2) / d2;
            (d1 * first, d1 * second)
        };
        let (mx, my) = (slope(before.0, p.0, q.0, after.0), slope(before.1, p.1, q.1, after.1));
        for step in 1..=steps {
            let t = step as f64 / steps as f64;
            let s = 1.0 - t;
            let at = |x: f64, y: f64, (m, n): (f64, f64)| {
                let (a, b) = ((1.0 + 2.0 * t) * s * s, t * t * (3.0 - 2.0 * t));
                a * x + t * s * s * m - t * t * s * n + b * y
            };
            all.push((at(p.0, q.0, mx), at(p.1, q.1, my)));
        }
    }
}

/// What stands at a curve: what bifurcates there, or the pattern at the end of its name, in words if it has
/// no impacts. None if the name has neither.
fn short(name: &str) -> Option<String> {
    if let Some((kind, _)) = name.split_once(" of the impact pattern") {
        return Some(kind.into());
    }
    let pattern = name.strip_suffix(')')?.rsplit_once('(')?.1;
    if pattern.len() > LONGEST_NAME {
        return Some(format!("{} impacts", pattern.split(',').count()));
    }
    Some(if pattern.starts_with("free") { "no impact".into() } else { format!("({pattern})") })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounding_decides_is_drawn_as_what_follows_it() {
        use Judgement::{Marginal, No, Yes};
        let solid = |all: &[Judgement]| {
            let said = |&one: &Judgement| (0.0, 0.0, Said { stable: Some(one), proved: None });
            let at = all.iter().map(said).collect();
            DrawnBranch { name: String::new(), at, labels: Vec::new() }.solid()
        };
        assert_eq!(solid(&[No, Marginal, Yes]), [false, true, true]);
        assert_eq!(solid(&[Yes, Marginal, Marginal, No, Marginal]), [true, false, false, false, false]);
        // Of an undamped oscillator: no orbit attracts.
        assert_eq!(solid(&[Marginal, Marginal]), [false, false]);
        assert!(solid(&[]).is_empty());
        let events =
            DrawnBranch { name: String::new(), at: vec![(0.0, 0.0, Said::default())], labels: Vec::new() };
        assert_eq!(events.solid(), [true]);
    }

    /// Points of a circle: between them the spline is within a thousandth of it.
    #[test]
    fn a_smooth_curve_keeps_its_points_and_has_no_corners() {
        let circle = |t: f64| (100.0 * t.cos(), 100.0 * t.sin());
        let points: Vec<At> = (0..9).map(|i| circle(f64::from(i) * 0.2)).collect();
        let curve = Smooth(&points).points(0, usize::MAX);
        assert!(points.iter().all(|p| curve.iter().any(|q| (p.0 - q.0).abs() + (p.1 - q.1).abs() < 1e-9)));
        // Away from the ends, where the curve has neighbours on both sides.
        let inner = Smooth(&points).points(1, 7);
        assert!(inner.iter().all(|p| (p.0.hypot(p.1) - 100.0).abs() < 0.1), "{inner:?}");
        let turn = |w: &[At]| {
            let angle = |a: At, b: At| (b.1 - a.1).atan2(b.0 - a.0);
            (angle(w[1], w[2]) - angle(w[0], w[1])).abs()
        };
        assert!(curve.windows(3).all(|w| turn(w) < 0.06));
        assert_eq!(Smooth(&points[..1]).points(0, 9), points[..1]);
        assert!(Smooth(&[]).points(0, 9).is_empty());
    }
}
