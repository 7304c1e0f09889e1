//! A picture as a list of shapes, in points (1/72 inch): what the figures draw on, and what is written as SVG
//! and, with the feature `print`, as PDF and PNG.
//!
//! Lengths grow to the right and downwards. Nothing here knows of axes ([`frame`](super::frame)) or of data.

#[cfg(any(test, feature = "print"))]
mod face;
#[cfg(feature = "print")]
mod pdf;
#[cfg(feature = "print")]
mod png;
mod svg;
mod thin;
mod words;

pub use words::Words;

/// A place: to the right, and down.
pub type At = (f64, f64);

/// Red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Colour(pub u8, pub u8, pub u8);

pub const BLACK: Colour = Colour(0, 0, 0);
pub const WHITE: Colour = Colour(255, 255, 255);
pub const GREY: Colour = Colour(150, 150, 150);
// The palette of Okabe and Ito, which colour-blind readers can tell apart.
pub const BLUE: Colour = Colour(0, 114, 178);
pub const SKY: Colour = Colour(86, 180, 233);
pub const GREEN: Colour = Colour(0, 158, 115);
pub const ORANGE: Colour = Colour(230, 159, 0);
pub const RED: Colour = Colour(213, 94, 0);
pub const PINK: Colour = Colour(204, 121, 167);
pub const YELLOW: Colour = Colour(240, 228, 66);

impl Colour {
    /// A tint: this share of it, the rest white.
    pub fn tint(self, share: f64) -> Colour {
        let mix = |part: u8| (255.0 - share * (255.0 - f64::from(part))).round() as u8;
        Colour(mix(self.0), mix(self.1), mix(self.2))
    }
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    pub ink: Colour,
    pub width: f64,
    /// The length of the dashes and of the gaps between them; without, the line is solid.
    pub dashes: Option<[f64; 2]>,
}

/// A solid line.
pub fn line(ink: Colour, width: f64) -> Stroke {
    Stroke { ink, width, dashes: None }
}

/// How the inside and the outline of a shape are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paint {
    pub fill: Option<Colour>,
    pub stroke: Option<Stroke>,
}

impl From<Colour> for Paint {
    fn from(ink: Colour) -> Paint {
        Paint { fill: Some(ink), stroke: None }
    }
}

impl From<Stroke> for Paint {
    fn from(stroke: Stroke) -> Paint {
        Paint { fill: None, stroke: Some(stroke) }
    }
}

/// Where a text stands beside its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// One thing drawn.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    /// Lines through points, each part for itself; closed ones are polygons, together filled where an odd
    /// number of windings is not zero in sum.
    Path { parts: Vec<Vec<At>>, closed: bool, paint: Paint },
    /// Discs or rings of one radius.
    Discs { at: Vec<At>, radius: f64, paint: Paint },
    /// A line of text; `at` is on its base line. Turned, it runs upwards.
    Text { words: Words, at: At, size: f64, anchor: Anchor, turned: bool, ink: Colour },
    /// What follows is drawn only inside this rectangle: left, top, right, bottom.
    Clip([f64; 4]),
    /// It no longer is.
    Unclip,
}

/// The size of type, in points.
pub const TYPE: f64 = 8.0;
/// The width of a journal's column, 86 mm.
pub const COLUMN: f64 = 244.0;

/// A picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Canvas {
    pub width: f64,
    pub height: f64,
    title: String,
    description: String,
    pub(super) shapes: Vec<Shape>,
}

impl Canvas {
    /// A white picture; title and description are for readers who do not see it.
    pub fn new(width: f64, height: f64, title: &str, description: &str) -> Canvas {
        let (title, description) = (title.to_string(), description.to_string());
        Canvas { width, height, title, description, shapes: Vec::new() }
    }

    /// A line through points.
    pub fn line(&mut self, points: Vec<At>, stroke: Stroke) {
        self.lines(vec![points], stroke);
    }

    /// Lines of one kind.
    pub fn lines(&mut self, parts: Vec<Vec<At>>, stroke: Stroke) {
        self.shapes.push(Shape::Path { parts, closed: false, paint: stroke.into() });
    }

    /// A polygon.
    pub fn polygon(&mut self, points: Vec<At>, paint: impl Into<Paint>) {
        self.polygons(vec![points], paint);
    }

    /// Polygons of one kind. Those that share a side show no seam: they are one shape.
    pub fn polygons(&mut self, parts: Vec<Vec<At>>, paint: impl Into<Paint>) {
        self.shapes.push(Shape::Path { parts, closed: true, paint: paint.into() });
    }

    /// A rectangle: left, top, right, bottom.
    pub fn rectangle(&mut self, [left, top, right, bottom]: [f64; 4], paint: impl Into<Paint>) {
        self.polygon(vec![(left, top), (right, top), (right, bottom), (left, bottom)], paint);
    }

    /// A disc or ring.
    pub fn disc(&mut self, at: At, radius: f64, paint: impl Into<Paint>) {
        self.discs(vec![at], radius, paint);
    }

    /// Discs or rings of one kind.
    pub fn discs(&mut self, at: Vec<At>, radius: f64, paint: impl Into<Paint>) {
        self.shapes.push(Shape::Discs { at, radius, paint: paint.into() });
    }

    /// Text half-way up beside a place.
    pub fn text(&mut self, words: impl Into<Words>, at: At, anchor: Anchor) {
        self.sized(words, at, anchor, TYPE);
    }

    /// The same of another size.
    pub fn sized(&mut self, words: impl Into<Words>, at: At, anchor: Anchor, size: f64) {
        self.inked(words, at, anchor, size, BLACK);
    }

    /// The same in a colour.
    pub fn inked(&mut self, words: impl Into<Words>, at: At, anchor: Anchor, size: f64, ink: Colour) {
        // Half the height of capitals and digits below the middle.
        let at = (at.0, at.1 + 0.36 * size);
        let words = words.into();
        self.shapes.push(Shape::Text { words, at, size, anchor, turned: false, ink });
    }

    /// Text that runs upwards, half-way across a place.
    pub fn turned(&mut self, words: impl Into<Words>, at: At) {
        let at = (at.0 + 0.36 * TYPE, at.1);
        let (words, anchor) = (words.into(), Anchor::Middle);
        self.shapes.push(Shape::Text { words, at, size: TYPE, anchor, turned: true, ink: BLACK });
    }

    /// Draws what `draw` draws inside a rectangle only.
    pub fn inside(&mut self, rectangle: [f64; 4], draw: impl FnOnce(&mut Canvas)) {
        self.shapes.push(Shape::Clip(rectangle));
        draw(self);
        self.shapes.push(Shape::Unclip);
    }

    /// The picture as PDF, 86 mm wide.
    #[cfg(feature = "print")]
    pub fn pdf(&self) -> Vec<u8> {
        pdf::write(self)
    }

    /// The picture as PNG, 600 dots per inch; `None` if it is too large for memory.
    #[cfg(feature = "print")]
    pub fn png(&self) -> Option<Vec<u8>> {
        png::write(self)
    }

    /// The picture as SVG.
    pub fn svg(&self) -> String {
        svg::write(self)
    }
}

/// How much of a text is before its place.
#[cfg(feature = "print")]
fn before(anchor: Anchor) -> f64 {
    match anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5,
        Anchor::End => 1.0,
    }
}

/// The width of a text in the face that print has.
#[cfg(feature = "print")]
fn width_in(face: &ttf_parser::Face, words: &Words, size: f64) -> f64 {
    let letter = |c: char| face::advance(face, face::glyph(face, c));
    let run = |run: &words::LetterRun| run.level.scale() * run.text.chars().map(letter).sum::<f64>();
    size * words.0.iter().map(run).sum::<f64>()
}
