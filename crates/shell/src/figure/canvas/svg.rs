//! A picture as SVG: paths, circles and text, and nothing that a program for print would not know.

use std::fmt::Write;

use super::{Anchor, At, Canvas, Colour, Paint, Shape, Stroke, Words, thin::thinned, words::Level};
use crate::printable::is_printable;

/// Pixels per point where a page does not set the width.
const ZOOM: f64 = 3.0;
/// Close to one another in width, and found on most machines; the last is always there.
const FACES: &str = "'DejaVu Sans Condensed','Helvetica Neue',Helvetica,Arial,sans-serif";

pub(super) fn write(canvas: &Canvas) -> String {
    let (width, height) = (canvas.width, canvas.height);
    let mut all = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" \
         font-family=\"{FACES}\" stroke-linejoin=\"round\" xml:space=\"preserve\">\n\
         <title>{}</title>\n<desc>{}</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        Short(ZOOM * width),
        Short(ZOOM * height),
        Short(width),
        Short(height),
        escaped(&canvas.title),
        escaped(&canvas.description),
    );
    let mut clips = 0;
    for shape in &canvas.shapes {
        match shape {
            Shape::Path { parts, closed, paint } => {
                all.push_str("<path d=\"");
                for part in parts {
                    outline(&mut all, part, *closed);
                }
                all.push('"');
                painted(&mut all, paint);
                all.push_str("/>\n");
            }
            Shape::Discs { at, radius, paint } => discs(&mut all, at, *radius, paint),
            Shape::Text { words, at, size, anchor, turned, ink } => {
                text_begun(&mut all, *at, *size, *anchor, *turned, *ink);
                spans(&mut all, words, *size);
                all.push_str("</text>\n");
            }
            Shape::Clip([left, top, right, bottom]) => {
                clips += 1;
                let _ = write!(
                    all,
                    "<clipPath id=\"c{clips}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n\
                     <g clip-path=\"url(#c{clips})\">\n",
                    Short(*left),
                    Short(*top),
                    Short(right - left),
                    Short(bottom - top)
                );
            }
            Shape::Unclip => all.push_str("</g>\n"),
        }
    }
    all.push_str("</svg>\n");
    all
}

/// Discs of one size. Many that are filled and have no edge are one path.
fn discs(all: &mut String, centres: &[At], radius: f64, paint: &Paint) {
    match paint {
        Paint { fill: Some(fill), stroke: None } if centres.len() > 3 => {
            // Lines of no length with round ends.
            all.push_str("<path stroke-linecap=\"round\" d=\"");
            for &at in centres {
                let _ = write!(all, "M{}h0", Pair(at));
            }
            all.push('"');
            let stroke = Stroke { ink: *fill, width: 2.0 * radius, dashes: None };
            painted(all, &stroke.into());
            all.push_str("/>\n");
        }
        paint => {
            for &(x, y) in centres {
                let _ =
                    write!(all, "<circle cx=\"{}\" cy=\"{}\" r=\"{}\"", Short(x), Short(y), Short(radius));
                painted(all, paint);
                all.push_str("/>\n");
            }
        }
    }
}

/// The opening of a text's element.
fn text_begun(all: &mut String, (x, y): At, size: f64, anchor: Anchor, turned: bool, ink: Colour) {
    let anchor = match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let _ = write!(
        all,
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{anchor}\"",
        Short(x),
        Short(y),
        Short(size)
    );
    if turned {
        let _ = write!(all, " transform=\"rotate(-90 {} {})\"", Short(x), Short(y));
    }
    if ink != super::BLACK {
        let _ = write!(all, " fill=\"{}\"", Hex(ink));
    }
    all.push('>');
}

/// A line, or a polygon: after the first corner by steps. Corners that nobody sees are left out.
fn outline(all: &mut String, part: &[At], closed: bool) {
    let corners = thinned(part);
    let Some(&first) = corners.first() else { return };
    let _ = write!(all, "M{}", Pair(first));
    let mut here = hundredths(first);
    for (index, &at) in corners[1..].iter().enumerate() {
        // Between rounded places, so that nothing adds up.
        let there = hundredths(at);
        for (i, step) in [there.0 - here.0, there.1 - here.1].into_iter().enumerate() {
            // One letter for all steps, and a minus parts numbers.
            match (index, i) {
                (0, 0) => all.push('l'),
                _ if step >= 0 => all.push(' '),
                _ => {}
            }
            let _ = write!(all, "{}", Hundredths(step));
        }
        here = there;
    }
    if closed {
        all.push('Z');
    }
}

fn hundredths((x, y): At) -> (i64, i64) {
    // What cannot be placed is put outside rather than written as something that is not SVG.
    let one = |x: f64| if x.is_finite() { (x.clamp(-1e5, 1e5) * 100.0).round() as i64 } else { -10_000_000 };
    (one(x), one(y))
}

fn painted(all: &mut String, paint: &Paint) {
    match paint.fill {
        Some(ink) => drop(write!(all, " fill=\"{}\"", Hex(ink))),
        None => all.push_str(" fill=\"none\""),
    }
    if let Some(Stroke { ink, width, dashes }) = paint.stroke {
        let _ = write!(all, " stroke=\"{}\" stroke-width=\"{}\"", Hex(ink), Short(width));
        if let Some([dash, gap]) = dashes {
            let _ = write!(all, " stroke-dasharray=\"{} {}\"", Short(dash), Short(gap));
        }
    }
}

/// The runs of a text; a lowered or raised one says how far, and the next how far back.
fn spans(all: &mut String, words: &Words, size: f64) {
    let mut level = Level::Base;
    for run in &words.0 {
        let mut attributes = String::new();
        if run.level != level {
            let _ = write!(attributes, " dy=\"{}\"", Short(size * (run.level.drop() - level.drop())));
            level = run.level;
        }
        if level != Level::Base {
            let _ = write!(attributes, " font-size=\"{}\"", Short(size * level.scale()));
        }
        if run.italic {
            attributes.push_str(" font-style=\"italic\"");
        }
        let text = escaped(&run.text);
        match attributes.as_str() {
            "" => all.push_str(&text),
            _ => drop(write!(all, "<tspan{attributes}>{text}</tspan>")),
        }
    }
}

fn escaped(text: &str) -> String {
    let mut all = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => all.push_str("&amp;"),
            '<' => all.push_str("&lt;"),
            '>' => all.push_str("&gt;"),
            '"' => all.push_str("&quot;"),
            // XML has not all of the others, and no reader of a picture shows them.
            '\t' | '\n' | '\r' => all.push(' '),
            c if !is_printable(c) => all.push('\u{fffd}'),
            c => all.push(c),
        }
    }
    all
}

/// Two decimals, without zeros at the end: a hundredth of a point is less than four micrometres.
struct Short(f64);

impl std::fmt::Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", Hundredths(hundredths((self.0, 0.0)).0))
    }
}

struct Hundredths(i64);

impl std::fmt::Display for Hundredths {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.0 < 0 {
            f.write_str("-")?;
        }
        let (whole, part) = (self.0.abs() / 100, self.0.abs() % 100);
        match part {
            0 => return write!(f, "{whole}"),
            _ if whole > 0 => write!(f, "{whole}")?,
            _ => {}
        }
        match part {
            part if part % 10 == 0 => write!(f, ".{}", part / 10),
            part => write!(f, ".{part:02}"),
        }
    }
}

struct Pair(At);

impl std::fmt::Display for Pair {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", Short(self.0.0), Short(self.0.1))
    }
}

struct Hex(Colour);

impl std::fmt::Display for Hex {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Colour(red, green, blue) = self.0;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_always_numbers() {
        for (x, text) in [
            (0.0, "0"),
            (-0.001, "0"),
            (1.5, "1.5"),
            (-2.05, "-2.05"),
            (12.346, "12.35"),
            (f64::NAN, "-100000"),
            (f64::INFINITY, "-100000"),
            (1e300, "100000"),
        ] {
            assert_eq!(Short(x).to_string(), text);
        }
    }

    #[test]
    fn steps_lead_from_one_rounded_corner_to_the_next() {
        let mut canvas = Canvas::new(10.0, 10.0, "", "");
        canvas.polygon(vec![(1.0, 2.0), (1.004, 2.504), (0.504, 2.496), (7.0, 0.0)], super::super::BLACK);
        assert!(canvas.svg().contains("d=\"M1 2l0 .5-.5 0 6.5-2.5Z\""), "{}", canvas.svg());
    }

    #[test]
    fn what_a_reader_names_cannot_end_the_text() {
        let mut canvas = Canvas::new(10.0, 10.0, "a < b", "\"&\"");
        canvas.text(Words::plain("</text>\u{0}"), (1.0, 1.0), Anchor::Start);
        let svg = canvas.svg();
        assert!(svg.contains("&lt;/text&gt;\u{fffd}</text>"), "{svg}");
        assert!(svg.contains("<title>a &lt; b</title>\n<desc>&quot;&amp;&quot;</desc>"), "{svg}");
    }
}
