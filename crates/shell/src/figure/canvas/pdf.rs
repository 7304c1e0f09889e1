//! A picture as PDF: vectors, and text in an embedded face that can be searched.

use std::collections::BTreeMap;

use pdf_writer::{
    Content, Filter, Finish, Name, Pdf, Rect, Ref, Str, TextStr,
    types::{CidFontType, FontFlags, LineCapStyle, LineJoinStyle, SystemInfo, UnicodeCmap},
};

use super::{Anchor, At, Canvas, Colour, Paint, Shape, Words, face};

const SYSTEM: SystemInfo = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
const FACE: Name = Name(b"F");
const FACE_NAME: Name = Name(b"GRAZNG+DejaVuSansCondensed");

/// The picture as a file of one page, as large as the picture.
pub(super) fn write(canvas: &Canvas) -> Vec<u8> {
    let mut drawing = Drawing::new(canvas);
    canvas.shapes.iter().for_each(|shape| drawing.shape(shape));
    let (content, glyphs) = (drawing.content.finish(), drawing.glyphs);
    let [catalog, pages, page, contents, font, cid, descriptor, file, names, info] =
        [1, 2, 3, 4, 5, 6, 7, 8, 9, 10].map(Ref::new);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([page]).count(1);
    pdf.document_info(info).title(TextStr(&canvas.title)).subject(TextStr(&canvas.description));
    let mut one = pdf.page(page);
    one.media_box(Rect::new(0.0, 0.0, canvas.width as f32, canvas.height as f32))
        .parent(pages)
        .contents(contents);
    one.resources().fonts().pair(FACE, font);
    one.finish();
    let packed = miniz_oxide::deflate::compress_to_vec_zlib(&content, 9);
    pdf.stream(contents, &packed).filter(Filter::FlateDecode);
    let face = face::face();
    let units = 1000.0 / f32::from(face.units_per_em());
    let scaled = |x: i16| f32::from(x) * units;
    pdf.type0_font(font)
        .base_font(FACE_NAME)
        .encoding_predefined(Name(b"Identity-H"))
        .descendant_font(cid)
        .to_unicode(names);
    let mut cid_font = pdf.cid_font(cid);
    cid_font
        .subtype(CidFontType::Type2)
        .base_font(FACE_NAME)
        .system_info(SYSTEM)
        .font_descriptor(descriptor)
        .default_width(0.0)
        .cid_to_gid_map_predefined(Name(b"Identity"));
    let mut widths = cid_font.widths();
    for &glyph in glyphs.keys() {
        let width = 1000.0 * face::advance(&face, ttf_parser::GlyphId(glyph)) as f32;
        widths.consecutive(glyph, [width]);
    }
    widths.finish();
    cid_font.finish();
    let bounds = face.global_bounding_box();
    pdf.font_descriptor(descriptor)
        .name(FACE_NAME)
        .flags(FontFlags::SYMBOLIC)
        .bbox(Rect::new(
            scaled(bounds.x_min),
            scaled(bounds.y_min),
            scaled(bounds.x_max),
            scaled(bounds.y_max),
        ))
        .italic_angle(0.0)
        .ascent(scaled(face.ascender()))
        .descent(scaled(face.descender()))
        .cap_height(729.0)
        .stem_v(80.0)
        .font_file2(file);
    let packed = miniz_oxide::deflate::compress_to_vec_zlib(face::FILE, 9);
    let mut embedded = pdf.stream(file, &packed);
    embedded.filter(Filter::FlateDecode).pair(Name(b"Length1"), face::FILE.len() as i32);
    embedded.finish();
    let mut map = UnicodeCmap::new(Name(b"Grazing"), SYSTEM);
    for (&glyph, &c) in &glyphs {
        map.pair(glyph, c);
    }
    pdf.cmap(names, &map.finish());
    pdf.finish()
}

struct Drawing {
    content: Content,
    face: ttf_parser::Face<'static>,
    /// The glyphs used, and what they stand for.
    glyphs: BTreeMap<u16, char>,
}

impl Drawing {
    fn new(canvas: &Canvas) -> Drawing {
        let mut content = Content::new();
        // Downwards, as the picture is described.
        content.transform([1.0, 0.0, 0.0, -1.0, 0.0, canvas.height as f32]);
        content.set_line_join(LineJoinStyle::RoundJoin);
        Drawing { content, face: face::face(), glyphs: BTreeMap::new() }
    }

    fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Path { parts, closed, paint } => {
                self.prepare(paint);
                for part in parts {
                    for (index, &(x, y)) in part.iter().enumerate() {
                        if index == 0 {
                            self.content.move_to(near(x), near(y));
                        } else {
                            self.content.line_to(near(x), near(y));
                        }
                    }
                    if *closed {
                        self.content.close_path();
                    }
                }
                self.end(paint);
            }
            Shape::Discs { at, radius, paint } => {
                self.prepare(paint);
                at.iter().for_each(|&at| self.circle(at, *radius));
                self.end(paint);
            }
            Shape::Text { words, at, size, anchor, turned, ink } => {
                self.text(words, *at, *size, *anchor, *turned, *ink);
            }
            Shape::Clip([left, top, right, bottom]) => {
                self.content.save_state();
                self.content.rect(near(*left), near(*top), near(right - left), near(bottom - top));
                self.content.clip_nonzero().end_path();
            }
            Shape::Unclip => drop(self.content.restore_state()),
        }
    }

    /// Four arcs.
    fn circle(&mut self, (x, y): At, r: f64) {
        let k = 0.552_284_75 * r;
        self.content.move_to(near(x + r), near(y));
        for [(a, b), (c, d), (e, f)] in [
            [(r, k), (k, r), (0.0, r)],
            [(-k, r), (-r, k), (-r, 0.0)],
            [(-r, -k), (-k, -r), (0.0, -r)],
            [(k, -r), (r, -k), (r, 0.0)],
        ] {
            self.content.cubic_to(
                near(x + a),
                near(y + b),
                near(x + c),
                near(y + d),
                near(x + e),
                near(y + f),
            );
        }
        self.content.close_path();
    }

    fn prepare(&mut self, paint: &Paint) {
        if let Some(ink) = paint.fill {
            let [red, green, blue] = parts(ink);
            self.content.set_fill_rgb(red, green, blue);
        }
        if let Some(stroke) = paint.stroke {
            let [red, green, blue] = parts(stroke.ink);
            self.content.set_stroke_rgb(red, green, blue).set_line_width(near(stroke.width));
            self.content.set_line_cap(LineCapStyle::ButtCap);
            self.content.set_dash_pattern(stroke.dashes.into_iter().flatten().map(near), 0.0);
        }
    }

    fn end(&mut self, paint: &Paint) {
        match (paint.fill, paint.stroke) {
            (Some(_), Some(_)) => self.content.fill_nonzero_and_stroke(),
            (Some(_), None) => self.content.fill_nonzero(),
            (None, Some(_)) => self.content.stroke(),
            (None, None) => self.content.end_path(),
        };
    }

    fn text(&mut self, words: &Words, at: At, size: f64, anchor: Anchor, turned: bool, ink: Colour) {
        let [red, green, blue] = parts(ink);
        self.content.set_fill_rgb(red, green, blue).begin_text();
        let mut pen = -super::before(anchor) * super::width_in(&self.face, words, size);
        for run in &words.0 {
            let (scale, drop) = (size * run.level.scale(), size * run.level.drop());
            let slant = if run.italic { face::SLANT as f32 } else { 0.0 };
            let (x, y) = if turned { (at.0 + drop, at.1 - pen) } else { (at.0 + pen, at.1 + drop) };
            let [a, b, c, d] = if turned { [0.0, -1.0, -1.0, -slant] } else { [1.0, 0.0, slant, -1.0] };
            self.content.set_font(FACE, scale as f32).set_text_matrix([a, b, c, d, near(x), near(y)]);
            let mut bytes = Vec::new();
            for c in run.text.chars() {
                let glyph = face::glyph(&self.face, c);
                self.glyphs.insert(glyph.0, c);
                bytes.extend(glyph.0.to_be_bytes());
                pen += scale * face::advance(&self.face, glyph);
            }
            self.content.show(Str(&bytes));
        }
        self.content.end_text();
    }
}

/// A number for the file; what cannot be placed is put outside, as in SVG.
fn near(x: f64) -> f32 {
    if x.is_finite() { ((x * 100.0).round() / 100.0).clamp(-1e4, 1e4) as f32 } else { -1e4 }
}

fn parts(ink: Colour) -> [f32; 3] {
    [ink.0, ink.1, ink.2].map(|part| f32::from(part) / 255.0)
}
