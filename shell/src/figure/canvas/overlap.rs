//! A test only: no text of a picture on the pages covers another, or leaves the picture. Sizes of type grow
//! with the picture, so what holds at one width holds at all.

use std::{fs, path::Path};

use super::Words;

/// Left, top, right, bottom of a text, and what it says.
type Placed = ([f64; 4], String);

/// The value of an attribute of a tag.
fn value<'t>(tag: &'t str, name: &str) -> Option<&'t str> {
    let (_, rest) = tag.split_once(&format!(" {name}=\""))?;
    Some(rest.split_once('"')?.0)
}

fn number(tag: &str, name: &str) -> Option<f64> {
    value(tag, name)?.parse().ok()
}

/// A text's element, from after `<text`, as the writer writes it.
fn placed(element: &str) -> Option<Placed> {
    let (tag, body) = element.split_once('>')?;
    let tag = &format!("{tag} ");
    let (x, y, size) = (number(tag, "x")?, number(tag, "y")?, number(tag, "font-size")?);
    let (mut text, mut width) = (String::new(), 0.0);
    let mut own = size;
    for (i, part) in body.split('<').enumerate() {
        // After the first each part begins with a tag.
        let letters = match part.split_once('>') {
            Some((tag, letters)) if i > 0 => {
                own = if tag.starts_with('/') { size } else { number(tag, "font-size").unwrap_or(size) };
                letters
            }
            _ => part,
        };
        let letters = ["&lt;", "&gt;", "&quot;", "&amp;"]
            .iter()
            .zip(["<", ">", "\"", "&"])
            .fold(letters.to_string(), |text, (code, letter)| text.replace(code, letter));
        width += Words::plain(&letters).width(own);
        text += &letters;
    }
    let before = match value(tag, "text-anchor")? {
        "start" => 0.0,
        "middle" => width / 2.0,
        _ => width,
    };
    // Capitals are 0.73 high; below the line letters reach further, but say little there.
    let (high, low) = (0.73 * size, 0.1 * size);
    let at = match tag.contains("rotate(-90") {
        true => [x - high, y - width + before, x + low, y + before],
        false => [x - before, y - high, x - before + width, y + low],
    };
    Some((at, text))
}

/// By how much two meet across and down, if they do.
fn meet(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    let side = |i: usize| a[i + 2].min(b[i + 2]) - a[i].max(b[i]);
    side(0).min(side(1))
}

fn faults(svg: &str) -> (usize, Vec<String>) {
    let whole = value(svg, "viewBox").unwrap();
    let size: Vec<f64> = whole.split(' ').map(|x| x.parse().unwrap()).collect();
    let elements = svg.split("<text").skip(1).map(|part| part.split_once("</text>").unwrap().0);
    let texts: Vec<Placed> = elements.map(|element| placed(element).unwrap()).collect();
    let mut found = Vec::new();
    for (i, (at, text)) in texts.iter().enumerate() {
        if meet(at, &[0.0, 0.0, size[2], size[3]]) < (at[2] - at[0]).min(at[3] - at[1]) - 0.5 {
            found.push(format!("{text:?} leaves the picture"));
        }
        let others = texts[..i].iter().filter(|(other, _)| meet(at, other) > 0.3);
        found.extend(others.map(|(_, other)| format!("{text:?} covers {other:?}")));
    }
    (texts.len(), found)
}

#[test]
fn no_text_of_a_picture_covers_another() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let mut pictures = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "svg") {
            let (texts, found) = faults(&fs::read_to_string(&path).unwrap());
            assert!(texts > 5 && found.is_empty(), "{}: {texts} texts, {found:?}", path.display());
            pictures += 1;
        }
    }
    assert!(pictures > 20, "{pictures}");
}

#[test]
fn a_text_that_covers_another_is_found() {
    let svg = |x: u32| {
        format!(
            "<svg viewBox=\"0 0 50 20\"><text x=\"5\" y=\"10\" font-size=\"8\" text-anchor=\"start\">a &lt; <tspan font-size=\"5\">b</tspan></text>\
             <text x=\"{x}\" y=\"12\" font-size=\"8\" text-anchor=\"middle\">c</text></svg>"
        )
    };
    assert_eq!(faults(&svg(40)).1, [""; 0]);
    assert_eq!(faults(&svg(12)).1, ["\"c\" covers \"a < b\""]);
    assert_eq!(faults(&svg(50)).1, ["\"c\" leaves the picture"]);
}
