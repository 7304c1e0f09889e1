//! Legends: samples of what is drawn with their names, in rows as long as the picture is wide.

use super::canvas::{Anchor, At, Canvas, TYPE, Words};

/// Draws a sample round a place, within 9 points to each side and 3 up and down.
pub type Sample<'a> = Box<dyn Fn(&mut Canvas, At) + 'a>;

/// The height of a row.
pub const ROW: f64 = 12.0;
const SAMPLE: f64 = 20.0;

/// Samples and their names.
#[derive(Default)]
pub struct Legend<'a> {
    entries: Vec<(Words, Sample<'a>)>,
}

impl<'a> Legend<'a> {
    /// Adds an entry, unless there is one of this name.
    pub fn add(&mut self, name: impl Into<Words>, sample: impl Fn(&mut Canvas, At) + 'a) {
        let name = name.into();
        if self.entries.iter().all(|(other, _)| *other != name) {
            self.entries.push((name, Box::new(sample)));
        }
    }

    /// The place of each entry in rows of a width: the middle of its sample from the left and from the top.
    fn places(&self, width: f64) -> Vec<At> {
        let (mut x, mut y) = (0.0, 0.0);
        let mut places = Vec::new();
        for (name, _) in &self.entries {
            let size = SAMPLE + 4.0 + name.width(TYPE);
            if x > 0.0 && x + size > width {
                (x, y) = (0.0, y + ROW);
            }
            places.push((x + SAMPLE / 2.0, y + ROW / 2.0));
            x += size + 10.0;
        }
        places
    }

    /// How high it is in rows of a width; 0 if there is nothing in it.
    pub fn height(&self, width: f64) -> f64 {
        self.places(width).last().map_or(0.0, |place| place.1 + ROW / 2.0)
    }

    /// Draws it in rows from a place on.
    pub fn draw(&self, canvas: &mut Canvas, (left, top): At, width: f64) {
        for ((name, sample), (x, y)) in self.entries.iter().zip(self.places(width)) {
            let at = (left + x, top + y);
            sample(canvas, at);
            canvas.text(name.clone(), (at.0 + SAMPLE / 2.0 + 4.0, at.1), Anchor::Start);
        }
    }
}
