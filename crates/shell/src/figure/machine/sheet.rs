//! The places of all that is drawn. Every text has a room of its own, as wide as it needs: between two boxes
//! a lane for each thing, below the boxes one for what reaches further.

use super::{
    super::canvas::{Anchor, BLACK, BLUE, COLUMN, Canvas, Colour, GREY, RED, TYPE, Words, line},
    plan::{Ends, Item, Mark, MassBox, Plan},
    symbols::{self, Level, PEN},
};

/// Around all.
const MARGIN: f64 = 6.0;
/// What a lane takes: a text, and a symbol below it.
const LANE: f64 = 23.0;
/// How far below the top of a lane its symbol is.
const SYMBOL: f64 = 16.5;
/// How much more under a wall that moves.
const MOVING: f64 = 4.0;
/// A line of text.
const LINE: f64 = 10.5;
/// The shortest lane.
const SHORT: f64 = 46.0;
/// How far the arrow of a force is from its text.
const ARROW: f64 = 16.0;
/// What friction on the ground takes below a box.
const RUB: f64 = 19.0;

fn width(text: &str) -> f64 {
    Words::plain(text).width(TYPE)
}

fn height(item: &Item) -> f64 {
    let moving = matches!(item.mark, Mark::Stop { moving: true, .. });
    LANE + if moving { MOVING } else { 0.0 }
}

/// Where the boxes are, and how far each area between them reaches.
struct Places {
    /// Left and right of each box.
    boxes: Vec<[f64; 2]>,
    top: f64,
    bottom: f64,
    right: f64,
}

impl Places {
    /// Left and right of the area before box i, or after the last.
    fn area(&self, i: usize) -> [f64; 2] {
        let left = i.checked_sub(1).map_or(MARGIN, |before| self.boxes[before][1]);
        [left, self.boxes.get(i).map_or(self.right, |one| one[0])]
    }

    /// Where the leg of a box goes down.
    fn leg(&self, i: usize) -> f64 {
        self.boxes[i][1] - 5.0
    }
}

/// The area in which something stands; without one it is below.
fn area(item: &Item) -> Option<usize> {
    match &item.ends {
        Ends::Ground { at, left } => Some(at + usize::from(!left)),
        Ends::Pair(i, j) if j - i == 1 => Some(*j),
        _ => None,
    }
}

/// The coordinates of what stands below.
fn reach(ends: &Ends) -> Vec<usize> {
    match ends {
        Ends::Ground { at, .. } => vec![*at],
        Ends::Pair(i, j) => vec![*i, *j],
        Ends::Many(all) => all.clone(),
    }
}

fn box_width(one: &MassBox) -> f64 {
    let lines = one.lines.iter().map(|text| width(text) + 12.0);
    let below = one.below.iter().map(|(text, _)| width(text) + 30.0);
    lines.chain(below).fold(40.0, f64::max)
}

/// How far the forces over a box reach beyond it on either side.
fn beyond(one: &MassBox) -> f64 {
    let above = one.above.iter().map(|(_, text)| width(text) + ARROW + 6.0);
    (above.fold(0.0, f64::max) - box_width(one)).max(0.0) / 2.0
}

fn places(plan: &Plan, below: &[&Item], top: f64) -> Places {
    let count = plan.boxes.len();
    let mut widths = vec![0.0f64; count + 1];
    let mut heights = vec![0.0; count + 1];
    for (item, i) in plan.items.iter().filter_map(|item| Some((item, area(item)?))) {
        widths[i] = widths[i].max(width(&item.label) + 10.0).max(SHORT);
        heights[i] += height(item);
    }
    for between in widths.iter_mut().take(count).skip(1) {
        *between = between.max(14.0);
    }
    let boxes: Vec<f64> = plan.boxes.iter().map(box_width).collect();
    let over: Vec<f64> = plan.boxes.iter().map(beyond).collect();
    for (i, room) in widths.iter_mut().enumerate() {
        let before = i.checked_sub(1).map_or(0.0, |before| over[before]);
        *room = room.max(before + over.get(i).copied().unwrap_or(0.0));
    }
    for item in below {
        let first = reach(&item.ends)[0];
        let next = boxes.get(first + 1).copied().unwrap_or(0.0);
        widths[first + 1] = widths[first + 1].max(width(&item.label) + 10.0 - next);
    }
    // What is narrower than a column stands in its middle.
    let whole = 2.0 * MARGIN + widths.iter().chain(&boxes).sum::<f64>();
    let mut at = MARGIN + (COLUMN - whole).max(0.0) / 2.0;
    let spare = at - MARGIN;
    let mut found = Vec::new();
    for (room, own) in widths.iter().zip(&boxes) {
        at += room;
        found.push([at, at + own]);
        at += own;
    }
    let lines = plan.boxes.iter().map(|one| one.lines.len() as f64 * LINE + 10.0).fold(30.0, f64::max);
    let high = heights.iter().copied().fold(lines, |most, own| most.max(own + 6.0));
    let mut places = Places { boxes: found, top, bottom: top + high, right: at + widths[count] };
    if spare > 0.0 {
        places.right = places.right.max(COLUMN - MARGIN - spare);
    }
    places
}

/// A text broken at blanks, and where it must be inside a word, into lines of this width.
fn broken(text: &str, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut open = String::new();
    for word in text.split(' ') {
        let longer = if open.is_empty() { word.to_string() } else { format!("{open} {word}") };
        if width(&longer) <= room {
            open = longer;
            continue;
        }
        if !open.is_empty() {
            lines.push(std::mem::take(&mut open));
        }
        for c in word.chars() {
            if width(&format!("{open}{c}")) > room {
                lines.push(std::mem::take(&mut open));
            }
            open.push(c);
        }
    }
    lines.push(open);
    lines
}

/// The picture.
pub(super) fn draw(title: &str, plan: &Plan, lines: &[String], remarks: &[String]) -> Canvas {
    let below: Vec<&Item> = plan.items.iter().filter(|item| area(item).is_none()).collect();
    let above = plan.boxes.iter().map(|one| one.above.len()).max().unwrap_or(0);
    let rubs = plan.boxes.iter().map(|one| one.below.len()).max().unwrap_or(0);
    let first = places(plan, &below, 0.0);
    let wide = (first.right + MARGIN).max(COLUMN);
    let room = wide - 2.0 * MARGIN;
    let titles = broken(title, room);
    let top = MARGIN + titles.len() as f64 * LINE + above as f64 * LINE + 12.0;
    let places = Places { top, bottom: top + first.bottom, ..first };
    let lanes = places.bottom + rubs as f64 * RUB + 4.0;
    let said = |all: &[String]| -> Vec<String> {
        let indented = |text: &String| {
            let mut lines = broken(text, room - 8.0);
            lines.iter_mut().skip(1).for_each(|line| line.insert_str(0, "   "));
            lines
        };
        all.iter().flat_map(indented).collect()
    };
    let (lines, remarks) = (said(lines), said(remarks));
    let text_top = lanes + below.iter().map(|item| height(item)).sum::<f64>() + 6.0;
    let rows = (lines.len() + remarks.len()) as f64;
    let extra = if remarks.is_empty() { 0.0 } else { 4.0 };
    let high = text_top + rows * LINE + extra + MARGIN;
    let description = format!(
        "The machine of a scene: {} in a row, {} things between them and to the ground, gaps not to scale; red \
         is what may be a wrong sign.",
        if plan.boxes.len() == 1 { "one mass".to_string() } else { format!("{} masses", plan.boxes.len()) },
        plan.items.len()
    );
    let mut canvas = Canvas::new(wide, high, title, &description);
    for (i, text) in titles.iter().enumerate() {
        let y = MARGIN + (i as f64 + 0.5) * LINE;
        canvas.text(Words::plain(text), (MARGIN, y), Anchor::Start);
    }
    for i in 0..=plan.boxes.len() {
        draw_area(&mut canvas, plan, &places, i);
    }
    draw_below(&mut canvas, &below, &places, lanes);
    for (one, at) in plan.boxes.iter().zip(&places.boxes) {
        draw_box(&mut canvas, one, *at, &places);
    }
    let mut y = text_top + LINE / 2.0;
    for (text, ink) in lines.iter().map(|text| (text, BLACK)).chain(remarks.iter().map(|text| (text, RED))) {
        if ink == RED && y < text_top + lines.len() as f64 * LINE + extra {
            y = text_top + lines.len() as f64 * LINE + extra + LINE / 2.0;
        }
        let indent = if text.starts_with("   ") { 8.0 } else { 0.0 };
        canvas.inked(Words::plain(text.trim_start()), (MARGIN + indent, y), Anchor::Start, TYPE, ink);
        y += LINE;
    }
    canvas
}

fn ink(item: &Item) -> Colour {
    if item.wrong { RED } else { BLACK }
}

/// A lane's text and symbol; its top is `y`.
fn lane(
    canvas: &mut Canvas,
    item: &Item,
    [left, right]: [f64; 2],
    y: f64,
    middle: f64,
    ground: Option<bool>,
) {
    canvas.inked(Words::plain(&item.label), (middle, y + 5.0), Anchor::Middle, TYPE, ink(item));
    symbols::draw(canvas, item.mark, Level { left, right, y: y + SYMBOL }, item.wrong, ground);
}

/// What stands in area i, below one another about the middle of the boxes.
fn draw_area(canvas: &mut Canvas, plan: &Plan, places: &Places, i: usize) {
    let items: Vec<&Item> = plan.items.iter().filter(|item| area(item) == Some(i)).collect();
    let whole: f64 = items.iter().map(|item| height(item)).sum();
    let mut y = (places.top + places.bottom - whole) / 2.0;
    let [left, right] = places.area(i);
    for item in items {
        let widest = (right - left).min(width(&item.label).max(SHORT) + 10.0);
        let (ends, middle, ground) = match item.ends {
            Ends::Ground { left: true, .. } => {
                let wall = right - widest + 6.0;
                symbols::hatched(canvas, (wall, y + SYMBOL - 5.0), (wall, y + SYMBOL + 5.0));
                ([wall, right], right - widest / 2.0, Some(true))
            }
            Ends::Ground { left: false, .. } => {
                let wall = left + widest - 6.0;
                symbols::hatched(canvas, (wall, y + SYMBOL + 5.0), (wall, y + SYMBOL - 5.0));
                ([left, wall], left + widest / 2.0, Some(false))
            }
            _ => ([left, right], (left + right) / 2.0, None),
        };
        lane(canvas, item, ends, y, middle, ground);
        y += height(item);
    }
}

/// What reaches further than to the next box, each on a lane of its own between legs of the boxes.
fn draw_below(canvas: &mut Canvas, items: &[&Item], places: &Places, top: f64) {
    let mut y = top;
    let mut lowest = std::collections::BTreeMap::new();
    for item in items {
        for at in reach(&item.ends) {
            lowest.insert(at, y + SYMBOL);
        }
        y += height(item);
    }
    for (at, end) in &lowest {
        let x = places.leg(*at);
        canvas.line(vec![(x, places.bottom), (x, *end)], line(GREY, PEN));
    }
    let mut y = top;
    for item in items {
        let all = reach(&item.ends);
        let [first, last] = [all[0], all[all.len() - 1]].map(|at| places.leg(at));
        let next = places.boxes.get(all[0] + 1).map_or(last, |_| places.leg(all[0] + 1));
        lane(canvas, item, [first, next], y, (first + next) / 2.0, None);
        if last > next {
            canvas.line(vec![(next, y + SYMBOL), (last, y + SYMBOL)], line(ink(item), PEN));
        }
        for at in all {
            // A leg that is passed has no disc.
            canvas.disc((places.leg(at), y + SYMBOL), 1.6, ink(item));
        }
        y += height(item);
    }
}

fn draw_box(canvas: &mut Canvas, one: &MassBox, [left, right]: [f64; 2], places: &Places) {
    let (top, bottom) = (places.top, places.bottom);
    canvas.rectangle([left, top, right, bottom], BLUE.tint(0.12));
    canvas.rectangle([left, top, right, bottom], line(BLUE, 1.2));
    let middle = (left + right) / 2.0;
    let from = (top + bottom - one.lines.len() as f64 * LINE) / 2.0;
    for (i, text) in one.lines.iter().enumerate() {
        canvas.text(Words::plain(text), (middle, from + (i as f64 + 0.5) * LINE), Anchor::Middle);
    }
    // Forces, the last one next to the box.
    for (i, (way, text)) in one.above.iter().rev().enumerate() {
        let y = top - 10.0 - i as f64 * LINE;
        let begin = middle - (width(text) + ARROW) / 2.0;
        symbols::arrow(canvas, Level { left: begin, right: begin + 13.0, y }, *way, BLUE);
        canvas.text(Words::plain(text), (begin + ARROW, y), Anchor::Start);
    }
    if !one.above.is_empty() {
        canvas.line(vec![(middle, top - 4.0), (middle, top)], line(BLUE, PEN));
    }
    let mut y = bottom;
    for (text, way) in &one.below {
        let level = Level { left: left + 1.0, right: right - 10.0, y: y + 2.5 };
        symbols::rough(canvas, level);
        symbols::hatched(canvas, (level.left, y + 5.0), (level.right, y + 5.0));
        let begin = if *way == 0 { level.left } else { level.left + 14.0 };
        if *way != 0 {
            symbols::arrow(
                canvas,
                Level { left: level.left, right: level.left + 11.0, y: y + 13.5 },
                *way,
                BLUE,
            );
        }
        canvas.text(Words::plain(text), (begin, y + 13.5), Anchor::Start);
        y += RUB;
    }
}
