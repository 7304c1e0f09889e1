//! A motion between its walls: displacement over time.

use super::{
    FigurePlace,
    canvas::{Anchor, BLUE, COLUMN, Canvas, GREY, RED, TYPE, Words, line},
    frame::{Axis, PlotFrame, padded},
};
use crate::error::Result;

/// A picture's columns; more could not be told apart.
const COLUMNS: usize = 4000;

/// A motion as it is drawn: as many points as a screen shows, however many there were.
pub struct MotionPicture {
    title: String,
    label: String,
    begin: f64,
    periods: f64,
    columns: Vec<Column>,
    impacts: u64,
}

/// What falls into one column: time and height of the first, lowest, highest and last point; the walls at the
/// first; the lowest and the highest impact.
#[derive(Clone, Default)]
struct Column {
    points: Option<[[f64; 2]; 4]>,
    walls: Vec<f64>,
    impacts: Option<[[f64; 2]; 2]>,
}

impl MotionPicture {
    /// An empty picture of the time from `begin` on, in forcing periods, with that many walls.
    pub fn new(title: &str, begin: f64, periods: f64, walls: usize) -> Self {
        let column = Column { walls: Vec::with_capacity(walls), ..Column::default() };
        let (title, label) = (title.into(), "q".into());
        MotionPicture { title, label, begin, periods, columns: vec![column; COLUMNS], impacts: 0 }
    }

    /// The same, what is drawn being called so.
    pub fn of(self, label: &str) -> Self {
        MotionPicture { label: label.into(), ..self }
    }

    fn column(&mut self, time: f64) -> &mut Column {
        let part = (time - self.begin) / self.periods.max(f64::MIN_POSITIVE);
        &mut self.columns[((part * COLUMNS as f64) as usize).min(COLUMNS - 1)]
    }

    /// A point of the motion, later than those before, and where the walls are then.
    pub fn point(&mut self, time: f64, q: f64, walls: &[f64]) {
        let (column, at) = (self.column(time), [time, q]);
        let Some([first, low, high, _]) = column.points else {
            column.points = Some([at; 4]);
            column.walls = walls.to_vec();
            return;
        };
        let (low, high) = (if q < low[1] { at } else { low }, if q > high[1] { at } else { high });
        column.points = Some([first, low, high, at]);
    }

    /// An impact.
    pub fn impact(&mut self, time: f64, q: f64) {
        self.impacts += 1;
        let (column, at) = (self.column(time), [time, q]);
        let [low, high] = column.impacts.unwrap_or([at; 2]);
        column.impacts = Some([if q < low[1] { at } else { low }, if q > high[1] { at } else { high }]);
    }

    /// The motion's line, in the order of time.
    fn line(&self) -> Vec<(f64, f64)> {
        let mut line = Vec::new();
        for column in &self.columns {
            line.extend(column.points.iter().flatten().map(|at| (at[0], at[1])));
        }
        line.extend(self.impacts());
        line.sort_by(|a, b| a.0.total_cmp(&b.0));
        line.dedup();
        line
    }

    /// The impacts shown.
    fn impacts(&self) -> impl Iterator<Item = (f64, f64)> {
        self.columns.iter().flat_map(|column| column.impacts.iter().flatten()).map(|at| (at[0], at[1]))
    }

    /// Each wall's line.
    fn walls(&self) -> Vec<Vec<(f64, f64)>> {
        let count = self.columns.iter().map(|column| column.walls.len()).max().unwrap_or(0);
        let at = |i: usize| {
            let one = move |column: &Column| Some((column.points?[0][0], *column.walls.get(i)?));
            let end =
                self.columns.iter().rev().find_map(|column| Some((column.points?[3][0], column.walls[i])));
            self.columns.iter().filter_map(one).chain(end).collect()
        };
        (0..count).map(at).collect()
    }
}

/// Writes the picture; the data beside it is the whole series, which whoever follows the motion writes.
///
/// # Errors
/// An I/O error.
pub fn motion(motion: &MotionPicture, place: &FigurePlace) -> Result<()> {
    place.draw(&draw(motion))
}

fn draw(motion: &MotionPicture) -> Canvas {
    let (path, walls) = (motion.line(), motion.walls());
    let count = motion.impacts;
    let note = match count {
        0 => "no impacts".to_string(),
        1 => "1 impact".to_string(),
        _ => format!("{count} impacts"),
    };
    let mut canvas = Canvas::new(
        COLUMN,
        136.0,
        &motion.title,
        &format!("{} over time in forcing periods, {note}; stops are grey, impacts red.", motion.label),
    );
    let heights = || path.iter().chain(walls.iter().flatten()).map(|at| at.1);
    let times = (path.first().map_or(0.0, |p| p.0), path.last().map_or(1.0, |p| p.0));
    let times = (times.0, times.1.max(times.0 + 1e-9 * (1.0 + times.0.abs())));
    let frame = PlotFrame::new(
        [2.0, 14.0, COLUMN - 2.0, 134.0],
        Axis::linear("forcing periods", times, 8),
        Axis::linear(motion.label.as_str(), padded(heights()), 5),
    );
    canvas.inside(frame.inside(), |canvas| {
        for wall in walls {
            canvas.line(frame.path(wall), line(GREY, 1.2));
        }
        canvas.line(frame.path(path), line(BLUE, 0.6));
    });
    // Where they are many, smaller, so that they stay apart.
    let radius = if count > 300 { 0.8 } else { 1.5 };
    canvas.discs(motion.impacts().map(|at| frame.at(at)).collect(), radius, RED);
    frame.draw(&mut canvas);
    canvas.text(Words::plain(&shortened(&motion.title, COLUMN - 66.0)), (4.0, 8.0), Anchor::Start);
    if count > 0 {
        // The count is the legend of the points.
        canvas.disc((COLUMN - 7.0 - Words::plain(&note).width(TYPE), 5.6), 1.5, RED);
    }
    canvas.text(note, (COLUMN - 4.0, 8.0), Anchor::End);
    canvas
}

/// The beginning of a title that is too long for its line.
fn shortened(title: &str, room: f64) -> String {
    let mut text = title.to_string();
    while Words::plain(&text).width(TYPE) > room && text.pop().is_some() {}
    if text.len() < title.len() { text.trim_end().to_string() + "…" } else { text }
}
