//! What is painted is what the theory says, by another route: at random points of views of every chart and
//! depth the innermost shape around the point is compared with the word, or the orbits, found at the exact
//! point.

use grazing_scenes::{
    existence::{Existence, by_definition},
    local::{Forward, Ladder},
    num_bigint::BigInt,
    num_rational::BigRational,
    number::parse_rational,
    word::{Extent, Word},
};
use serde_json::{Value as Json, json};

use super::chart::View;

/// The same numbers on every machine.
struct Random(u64);

impl Random {
    /// From −½ to ½, a multiple of 2⁻³².
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((self.0 >> 32) as u32) / 4_294_967_296.0 - 0.5
    }
}

fn points(list: &Json) -> Vec<[f64; 2]> {
    let numbers: Vec<f64> = list.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect()
}

fn contains(shape: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let mut inside = false;
    for (a, b) in shape.iter().zip(shape.iter().cycle().skip(1)) {
        if (a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) {
            inside = !inside;
        }
    }
    inside
}

/// Whether a place is within some pixels of a line.
fn near(line: &[[f64; 2]], place: [f64; 2], pixel: [f64; 2], distance: f64) -> bool {
    let scaled = |p: [f64; 2]| [p[0] / pixel[0], p[1] / pixel[1]];
    let [x, y] = scaled(place);
    line.windows(2).any(|pair| {
        let ([ax, ay], [bx, by]) = (scaled(pair[0]), scaled(pair[1]));
        let (dx, dy) = (bx - ax, by - ay);
        let length = dx * dx + dy * dy;
        let t = if length > 0.0 { (((x - ax) * dx + (y - ay) * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
        (x - ax - t * dx).hypot(y - ay - t * dy) < distance
    })
}

struct Seen {
    view: View,
    answer: Json,
    shapes: Vec<Vec<[f64; 2]>>,
    /// What a pixel beside which may have either colour: edges, and what bounds "more".
    lines: Vec<Vec<[f64; 2]>>,
}

fn seen(chart: &str, [x, y]: [&str; 2], [width, height]: [f64; 2], more: Json) -> Seen {
    let mut request = json!({
        "chart": chart, "x": x, "y": y, "width": width, "height": height, "pixels_x": 600, "pixels_y": 450,
        "max_n": 14, "words": true, "limit": 20000,
    });
    for (key, value) in more.as_object().unwrap() {
        request[key] = value.clone();
    }
    let answer: Json = serde_json::from_str(&super::view(&request.to_string())).unwrap();
    assert!(answer["error"].is_null(), "{answer}");
    assert_eq!(answer["open"], 0);
    let areas = answer["areas"].as_array().unwrap();
    let edges = areas.iter().flat_map(|area| area["edges"].as_array().unwrap());
    let outlines = areas.iter().filter(|area| area["kind"] == "more").map(|area| &area["shape"]);
    let lines = edges.chain(outlines).map(points).collect();
    let shapes = areas.iter().map(|area| points(&area["shape"])).collect();
    Seen { view: View::new(&request).unwrap(), answer, shapes, lines }
}

impl Seen {
    /// A random place that is a pixel and more from every edge, its exact point, and the innermost shape
    /// there.
    fn try_one(&self, random: &mut Random) -> Option<(grazing_scenes::local::Point, Option<&Json>)> {
        let View { chart, x, y, width, height, pixel, .. } = &self.view;
        let offset = [random.next() * width, random.next() * height];
        let exact = offset.map(|x| BigRational::from_float(x).unwrap());
        let Forward { point, reversed, .. } = chart.point(&(x + &exact[0]), &(y + &exact[1])).ok()?;
        if reversed {
            return None;
        }
        if self.lines.iter().any(|line| near(line, offset, *pixel, 1.5)) {
            return None;
        }
        let inside = self.shapes.iter().rposition(|shape| contains(shape, offset));
        let inside = inside.map(|index| &self.answer["areas"][index]);
        Some((point, inside))
    }
}

/// Views of all charts, some deep: near r = 1, at the ends of Farey intervals and elsewhere.
fn views(more: &Json) -> Vec<Seen> {
    let home = [
        seen("plane", ["0", "1/2"], [4.4, 1.1], more.clone()),
        seen("disc", ["0", "1/2"], [2.1, 1.08], more.clone()),
        seen("strip", ["1/4", "1/2"], [0.52, 1.06], more.clone()),
        seen("plane", ["-19/10", "9/10"], [0.3, 0.3], more.clone()),
        seen("plane", ["1/2", "99/100"], [0.1, 0.05], more.clone()),
    ];
    let deep = [
        seen("strip", ["1/3", "1"], [1e-12, 1e-12], more.clone()),
        seen("strip", ["3/8+2^-200", "1-2^-199"], [1e-60, 2e-60], more.clone()),
        // (a₁, a₂) at s = 1/3, r = 1, and λ at s = 1/4, r = 1.
        seen("plane", ["-1", "1"], [1e-12, 1e-12], more.clone()),
        seen("disc", ["0", "1"], [3e-13, 3e-13], more.clone()),
    ];
    home.into_iter().chain(deep).collect()
}

#[test]
fn colours_are_the_words_of_the_points() {
    let ladder = Ladder::default();
    let mut random = Random(7);
    for sign in ["+", "-"] {
        for (index, seen) in views(&json!({ "sign": sign })).iter().enumerate() {
            let (mut compared, mut more, mut finer) = (0, 0, 0);
            for _ in 0..60 {
                let Some((point, inside)) = seen.try_one(&mut random) else { continue };
                let word = Word::at(&ladder, &point, sign == "+", 300, &()).unwrap();
                if matches!(word.extent(), Extent::Boundary { .. } | Extent::Undecided { .. }) {
                    continue;
                }
                let place =
                    format!("view {index}, eµ {sign}, {point:?}: word {}, shape {inside:?}", word.letters());
                let area = inside.unwrap_or_else(|| panic!("{place}"));
                if area["kind"] == "more" {
                    more += 1;
                    assert!(word.vertices().iter().any(|vertex| vertex.period > 14), "{place}");
                } else {
                    let letters = area["letters"].as_str().unwrap_or_else(|| panic!("{place}"));
                    let periods =
                        json!(word.vertices().iter().map(|vertex| vertex.period).collect::<Vec<_>>());
                    if (letters, &periods) == (word.letters().as_str(), &area["periods"]) {
                        compared += 1;
                    } else {
                        // A later area, too small to be drawn.
                        assert!(word.letters().starts_with(letters), "{place}");
                        finer += 1;
                    }
                }
            }
            let least = if sign == "+" { 12 } else { 5 };
            assert!(compared + more > least, "view {index}: {compared} {more}");
            assert!(
                finer == 0 || finer <= seen.answer["finer"].as_u64().unwrap().min(3),
                "view {index}: {finer}"
            );
        }
    }
}

#[test]
fn colours_of_one_period_are_its_orbits() {
    let ladder = Ladder::default();
    let mut random = Random(3);
    for n in [1, 2, 5, 8] {
        let (mut orbits, mut none) = (0, 0);
        for (index, seen) in views(&json!({ "only": n })).iter().enumerate() {
            for _ in 0..40 {
                let Some((point, inside)) = seen.try_one(&mut random) else { continue };
                let found = by_definition(&ladder, &point, n);
                match inside {
                    Some(area) => {
                        assert_eq!(
                            area["case"],
                            found.cases(n)[0].to_string(),
                            "view {index}: {point:?} {found}"
                        );
                        orbits += 1;
                    }
                    None => {
                        assert!(
                            matches!(found, Existence::None { .. }),
                            "view {index}: {n} {point:?} {found}"
                        );
                        none += 1;
                    }
                }
            }
        }
        assert!(orbits > 50 && (none > 20 || n < 3), "{n}: {orbits} {none}");
    }
}

/// Where the tree is cut or N is reached, nothing is claimed: the innermost shape says that there is more.
#[test]
fn a_limit_leaves_hatched_what_it_leaves_out() {
    let ladder = Ladder::default();
    let mut random = Random(5);
    let seen = seen("strip", ["1/4", "9/10"], [0.5, 0.2], json!({ "max_n": 1000, "limit": 12 }));
    assert!(seen.answer["cut"].as_u64().unwrap() > 5);
    let mut more = 0;
    for _ in 0..300 {
        let Some((point, inside)) = seen.try_one(&mut random) else { continue };
        let word = Word::at(&ladder, &point, true, 300, &()).unwrap();
        let area = inside.unwrap();
        match area["kind"].as_str().unwrap() {
            "more" => {
                more += 1;
                let n = area["n"].as_u64().unwrap();
                assert!(
                    word.vertices().iter().any(|vertex| vertex.period >= n),
                    "{point:?} {}",
                    word.letters()
                );
            }
            _ => assert_eq!(area["letters"], word.letters(), "{point:?}"),
        }
    }
    assert!(more > 3, "{more}");
}

fn ask(give: fn(&str) -> String, request: Json) -> Json {
    serde_json::from_str(&give(&request.to_string())).unwrap()
}

#[test]
fn a_point_is_explained_and_certified() {
    let facts = ask(super::point, json!({ "r": "0.99", "s": "0.21", "max_n": 6 }));
    assert_eq!(facts["region"], "3");
    // As in the example of `by_records`: period 5 exists in (+,−), period 6 does not.
    assert_eq!(facts["periods"][4]["cases"][0]["case"], "(+,-)");
    assert_eq!(facts["periods"][4]["why"], "b_5,1, …, b_5,4 > 0, c_5 < 0");
    assert_eq!(facts["periods"][5]["existence"], "none");
    assert_eq!(facts["records"]["powers"].as_array().unwrap().len(), 6);
    let made = ask(super::certificate, json!({ "r": "0.99", "s": "0.21" }));
    let text = made["certificate"].as_str().unwrap();
    let checked = grazing_check::check(&mut text.as_bytes()).unwrap();
    assert_eq!(checked.kind, "word");
    assert_eq!(Some(checked.lines), made["lines"].as_u64());
    // Exact numbers of the command line, and a point that a float does not tell from a boundary.
    let deep = ask(super::point, json!({ "r": "1", "s": "3/8+2^-200", "max_n": 9 }));
    assert_eq!(deep["periods"][7]["existence"], "orbit");
    assert_eq!(deep["periods"][7]["cases"][0]["case"], "(+,-)");
    let on = ask(super::point, json!({ "r": "1", "s": "3/8", "max_n": 9 }));
    assert_eq!(on["periods"][7]["existence"], "singular");
    // Reversed time has the same orbits.
    let reversed = ask(super::point, json!({ "a1": "3/2", "a2": "2", "max_n": 6 }));
    let forward = ask(super::point, json!({ "a1": "3/4", "a2": "1/2", "max_n": 6 }));
    for n in 0..6 {
        assert_eq!(reversed["periods"][n]["cases"], forward["periods"][n]["cases"]);
    }
}

#[test]
fn wrong_requests_are_answered_with_what_is_wrong() {
    for (give, request) in [
        (super::point as fn(&str) -> String, json!({ "a1": "1/0", "a2": "1" })),
        (super::point, json!({ "a1": "1" })),
        (super::point, json!({ "a1": 1, "a2": "1" })),
        (super::point, json!({ "r": "1/2", "s": "1/2" })),
        (super::certificate, json!({ "a1": "3/2", "a2": "1/2" })),
        (super::certificate, json!({ "a1": "1/2", "a2": "3/2" })),
        (super::place, json!({ "a1": "3", "a2": "1", "chart": "disc" })),
        (super::shares, json!({ "a1": ["0", "1"] })),
        (super::shares, json!({ "r": ["0.9", "1.1"], "s": ["0.2", "0.3"] })),
        (super::shares, json!({ "r": ["0.9", "0.8"], "s": ["0.2", "0.3"] })),
        (super::shares, json!({ "r": ["0.8", "0.9"], "s": ["0.2", "0.3"], "cells": 0 })),
        (super::view, json!({})),
        (super::view, json!(7)),
    ] {
        let answer = ask(give, request.clone());
        assert!(!answer["error"]["message"].as_str().unwrap_or_default().is_empty(), "{request} {answer}");
    }
    assert!(super::view("{").contains("error"));
}

/// A point's places in the charts are those of one point.
#[test]
fn places_agree_between_charts() {
    let tiny = parse_rational("2^-250").unwrap();
    let close = |a: &BigRational, b: &BigRational| {
        let distance = a - b;
        distance < tiny && -distance < tiny
    };
    let at = |request: Json| {
        let answer = ask(super::place, request);
        ["x", "y"].map(|key| parse_rational(answer[key].as_str().unwrap()).unwrap())
    };
    for (r, s) in [("1", "1/3"), ("0.7", "3/8+2^-200"), ("1-2^-100", "1/7")] {
        let [a1, a2] = at(json!({ "r": r, "s": s, "chart": "plane" }));
        let [x, y] = at(json!({ "r": r, "s": s, "chart": "disc" }));
        assert!(close(&(&x * BigInt::from(2)), &a1) && close(&(&x * &x + &y * &y), &a2), "{r} {s}");
        let text = |x: &BigRational| x.to_string();
        let [back_s, back_r] = at(json!({ "a1": text(&a1), "a2": text(&a2), "chart": "strip" }));
        assert!(close(&back_s, &parse_rational(s).unwrap()), "{s} {back_s}");
        assert!(close(&back_r, &parse_rational(r).unwrap()), "{r} {back_r}");
        let [u, v] = at(json!({ "a1": text(&a1), "a2": text(&a2), "chart": "disc" }));
        assert!(close(&u, &x) && close(&v, &y), "{r} {s}");
    }
}

/// What is said to hold in all of a box, or nowhere, does so at its points, by their own words; and points
/// counted there lie in the bounds of every share.
#[test]
fn shares_of_a_box_are_those_of_its_points() {
    const POINTS: usize = 400;
    let mut random = Random(1);
    let ladder = Ladder::default();
    let text = |ends: &[BigRational; 2]| ends.each_ref().map(ToString::to_string);
    let q = |text: &str| parse_rational(text).unwrap();
    let mut told = 0;
    for (names, first, second) in [
        (["a1", "a2"], [q("-0.4"), q("0.3")], [q("0.4"), q("0.6")]),
        (["a1", "a2"], [q("-0.25"), q("-0.2")], [q("0.7"), q("0.71")]),
        (["r", "s"], [q("0.9"), q("0.98")], [q("0.2"), q("0.24")]),
        (["r", "s"], [q("0.7"), q("0.7")], [q("0.1"), q("0.3")]),
    ] {
        let answer = ask(super::shares, json!({ names[0]: text(&first), names[1]: text(&second) }));
        let mut counted = std::collections::HashMap::new();
        for _ in 0..POINTS {
            let mut at = |[lower, upper]: &[BigRational; 2]| {
                lower + (upper - lower) * (BigRational::from_float(random.next()).unwrap() + q("1/2"))
            };
            let (x, y) = (at(&first), at(&second));
            let place = if names[0] == "r" { Forward::polar(x, y) } else { Forward::plane(x, y) }.unwrap();
            for sign in [1, -1] {
                let word = Word::at(&ladder, &place.point, sign > 0, 60, &()).unwrap();
                let mut holds = vec![format!("word {sign} {} {:?}", word.letters(), periods(&word))];
                holds.extend(word.vertices().iter().map(|v| format!("period {sign} {}", v.period)));
                for gamma in [1, -1] {
                    let (entropy, _) = grazing_scenes::word::Entropy::of(&word, gamma > 0, 20).unwrap();
                    if matches!(entropy, grazing_scenes::word::Entropy::Positive { .. }) {
                        holds.push(format!("chaos {sign} {gamma}"));
                    }
                }
                holds.into_iter().for_each(|what| *counted.entry(what).or_insert(0) += 1);
            }
        }
        let all = |key: &str| answer[key].as_array().unwrap().clone();
        let named = |kind: &str, row: &Json| match kind {
            "chaos" => format!("chaos {} {}", row["sign_emu"], row["sign_gamma"]),
            "periods" => format!("period {} {}", row["sign_emu"], row["n"]),
            _ => {
                let periods: Vec<u64> =
                    row["periods"].as_array().unwrap().iter().flat_map(Json::as_u64).collect();
                format!("word {} {} {periods:?}", row["sign_emu"], row["letters"].as_str().unwrap())
            }
        };
        for kind in ["chaos", "periods", "words"] {
            for row in all(kind) {
                let name = named(kind, &row);
                let share = *counted.get(&name).unwrap_or(&0) as f64 / POINTS as f64;
                let [low, high] =
                    [0, 1].map(|i| row["percent"][i].as_str().unwrap().parse::<f64>().unwrap() / 100.0);
                // Five deviations of what is counted.
                let wide = |p: f64| 5.0 * (p * (1.0 - p) / POINTS as f64).sqrt();
                assert!(share >= low - wide(low) && share <= high + wide(high), "{name} {share} {row}");
                match row["verdict"].as_str().unwrap() {
                    "everywhere" => assert_eq!(share, 1.0, "{name}"),
                    "nowhere" => assert_eq!(share, 0.0, "{name}"),
                    _ => told += 1,
                }
            }
        }
    }
    assert!(told > 10, "{told}");
}

fn periods(word: &Word) -> Vec<u64> {
    word.vertices().iter().map(|vertex| vertex.period).collect()
}
