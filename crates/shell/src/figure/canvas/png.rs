//! A picture as PNG, 600 dots per inch: for what takes no vectors.

use tiny_skia::{
    Color, FillRule, LineJoin, Mask, Paint as Brush, Path, PathBuilder, Pixmap, Stroke as Line, StrokeDash,
    Transform,
};
use ttf_parser::OutlineBuilder;

use super::{Anchor, At, Canvas, Colour, Paint, Shape, Stroke, Words, face};

/// Pixels per point.
const ZOOM: f32 = 600.0 / 72.0;

/// The picture; `None` if it is too large for memory.
pub(super) fn write(canvas: &Canvas) -> Option<Vec<u8>> {
    let pixels = |x: f64| (x * f64::from(ZOOM)).ceil() as u32;
    let mut pixmap = Pixmap::new(pixels(canvas.width), pixels(canvas.height))?;
    pixmap.fill(Color::WHITE);
    let mut drawing = Drawing { pixmap, mask: None, face: face::face() };
    canvas.shapes.iter().for_each(|shape| drawing.shape(shape));
    drawing.pixmap.encode_png().ok()
}

struct Drawing {
    pixmap: Pixmap,
    mask: Option<Mask>,
    face: ttf_parser::Face<'static>,
}

fn zoom() -> Transform {
    Transform::from_scale(ZOOM, ZOOM)
}

/// What cannot be placed is put outside, as in SVG.
fn near(x: f64) -> f32 {
    if x.is_finite() { x.clamp(-1e4, 1e4) as f32 } else { -1e4 }
}

fn brush(ink: Colour) -> Brush<'static> {
    let mut brush = Brush { anti_alias: true, ..Brush::default() };
    brush.set_color_rgba8(ink.0, ink.1, ink.2, 255);
    brush
}

impl Drawing {
    fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Path { parts, closed, paint } => {
                let mut path = PathBuilder::new();
                for part in parts {
                    for (index, &(x, y)) in part.iter().enumerate() {
                        match index {
                            0 => path.move_to(near(x), near(y)),
                            _ => path.line_to(near(x), near(y)),
                        }
                    }
                    if *closed && !part.is_empty() {
                        path.close();
                    }
                }
                self.draw(path.finish(), paint);
            }
            Shape::Discs { at, radius, paint } => {
                let mut path = PathBuilder::new();
                at.iter().for_each(|&(x, y)| path.push_circle(near(x), near(y), near(*radius)));
                self.draw(path.finish(), paint);
            }
            Shape::Text { words, at, size, anchor, turned, ink } => {
                let path = self.text(words, *at, *size, *anchor, *turned);
                self.draw(path, &(*ink).into());
            }
            Shape::Clip([left, top, right, bottom]) => {
                let sides = [*left, *top, *right, *bottom].map(near);
                let rectangle = tiny_skia::Rect::from_ltrb(sides[0], sides[1], sides[2], sides[3]);
                self.mask = Mask::new(self.pixmap.width(), self.pixmap.height()).zip(rectangle).map(
                    |(mut mask, rectangle)| {
                        mask.fill_path(&PathBuilder::from_rect(rectangle), FillRule::Winding, true, zoom());
                        mask
                    },
                );
            }
            Shape::Unclip => self.mask = None,
        }
    }

    fn draw(&mut self, path: Option<Path>, paint: &Paint) {
        let Some(path) = path else { return };
        if let Some(ink) = paint.fill {
            self.pixmap.fill_path(&path, &brush(ink), FillRule::Winding, zoom(), self.mask.as_ref());
        }
        if let Some(Stroke { ink, width, dashes }) = paint.stroke {
            let dash = dashes.and_then(|dashes| StrokeDash::new(dashes.map(near).to_vec(), 0.0));
            let line = Line { width: near(width), line_join: LineJoin::Round, dash, ..Line::default() };
            self.pixmap.stroke_path(&path, &brush(ink), &line, zoom(), self.mask.as_ref());
        }
    }

    fn text(&self, words: &Words, at: At, size: f64, anchor: Anchor, turned: bool) -> Option<Path> {
        let mut path = PathBuilder::new();
        let mut pen = -super::before(anchor) * super::width_in(&self.face, words, size);
        for run in &words.0 {
            let (scale, drop) = (size * run.level.scale(), size * run.level.drop());
            let slant = if run.italic { face::SLANT } else { 0.0 };
            for c in run.text.chars() {
                let glyph = face::glyph(&self.face, c);
                let unit = scale / f64::from(self.face.units_per_em());
                let place = |x: f32, y: f32| {
                    let (x, y) = (f64::from(x) * unit, f64::from(y) * unit);
                    let (along, down) = (pen + x + slant * y, drop - y);
                    let (x, y) = if turned { (down, -along) } else { (along, down) };
                    (near(at.0 + x), near(at.1 + y))
                };
                self.face.outline_glyph(glyph, &mut Pen { path: &mut path, place });
                pen += scale * face::advance(&self.face, glyph);
            }
        }
        path.finish()
    }
}

/// Draws an outline of the face at its place.
struct Pen<'a, F> {
    path: &'a mut PathBuilder,
    place: F,
}

impl<F: Fn(f32, f32) -> (f32, f32)> OutlineBuilder for Pen<'_, F> {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = (self.place)(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = (self.place)(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = ((self.place)(x1, y1), (self.place)(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = ((self.place)(x1, y1), (self.place)(x2, y2), (self.place)(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}
