//! What is true at one exact point: its words, which orbits exist and why, the record picture; and a
//! certificate.

use std::f64::consts::TAU;

use grazing_scenes::{
    Error, Result, certificate,
    existence::{Case, Existence, Resonance, large_eigenvalue_sign, up_to},
    local::{Forward, Ladder, Point, Region},
    num_rational::BigRational,
    number::parse_rational,
    search::{Certified, WordCertificate, WordPlace, certify_word},
    word::{Entropy, Extent, Word},
};
use serde_json::{Value as Json, json};

use super::chart::{Chart, float, integer, root, short, turn_of};

/// Letters of a word that are listed under the pointer.
const LETTERS: usize = 60;
/// Letters of a word that is certified, as on the command line.
const CERTIFIED: usize = 200;
/// Bits of an entropy.
const BITS: u32 = 40;

/// A point as it was given.
struct Given {
    place: Forward,
    /// The options of the command line that mean this point.
    options: String,
    /// λ = x + iy, in floats, for the picture; none where the eigenvalues are real.
    lambda: Option<[f64; 2]>,
    /// a₁ and a₂, or r and s, in floats.
    floats: [f64; 2],
}

fn given(request: &Json) -> Result<Given> {
    let coordinate = |key: &str| -> Result<Option<BigRational>> {
        match &request[key] {
            Json::Null => Ok(None),
            Json::String(text) => parse_rational(text).map(Some).map_err(Error::from),
            _ => Err(Error::input(format!("{key}: an exact number as text is wanted"))),
        }
    };
    let numbers = [coordinate("a1")?, coordinate("a2")?, coordinate("r")?, coordinate("s")?];
    let (chart, x, y, names) = match numbers {
        [Some(a1), Some(a2), None, None] => (Chart::Plane, a1, a2, ["a1", "a2"]),
        [None, None, Some(r), Some(s)] => (Chart::Strip, s, r, ["s", "r"]),
        _ => return Err(Error::input("a point is given by a1 and a2, or by r and s")),
    };
    let place = chart.point(&x, &y)?;
    let floats = [float(&x), float(&y)];
    let options = format!("--{} {x} --{} {y}", names[0], names[1]);
    let lambda = match &place.point {
        Point::Polar(polar) => {
            let (sin, cos) = (TAU * float(polar.s())).sin_cos();
            let r = float(polar.r());
            Some([r * cos, r * sin])
        }
        Point::Plane(plane) => {
            let [a1, a2] = [plane.a1(), plane.a2()];
            let square = a2 * integer(4) - a1 * a1;
            (place.region == Region::Three).then(|| [float(a1) / 2.0, float(&square).max(0.0).sqrt() / 2.0])
        }
    };
    Ok(Given { place, options, lambda, floats })
}

/// Where a word ends, and why, in words.
fn end(word: &Word) -> (&'static str, String) {
    match word.extent() {
        Extent::All => ("all", "every period occurs, with this letter".into()),
        Extent::Complete { next: Some(n) } => {
            ("complete", format!("no other period occurs: {n}, the next on the path, does not"))
        }
        Extent::Complete { next: None } => ("complete", "no other period occurs".into()),
        Extent::Boundary { next, deciding: Some(_) } => (
            "boundary",
            format!(
                "the point lies on the boundary of period {next}, where one b is 0 and Theorem 1 is silent"
            ),
        ),
        Extent::Boundary { next, deciding: None } => {
            ("singular", format!("u is 0 for n = {next}, where Theorem 1 is silent"))
        }
        Extent::Undecided { next, rung } => (
            "undecided",
            format!("undecided: whether period {next} occurs (highest precision tried: {rung})"),
        ),
        Extent::Cut => ("cut", "the word goes on: more letters than are listed".into()),
        Extent::Odd => (
            "odd",
            "every odd period occurs, with the letter D, and 2, whose c is 0; Theorem 1 is silent about the \
             other even ones"
                .into(),
        ),
        Extent::Line => ("line", "on this line every c and b is 0, and Theorem 1 is silent".into()),
        other => ("undecided", format!("undecided: {other:?}")),
    }
}

fn word(given: &Given, ladder: &Ladder, positive: bool) -> Result<Json> {
    let word = Word::at(ladder, &given.place.point, positive, LETTERS, &())?;
    let (kind, text) = end(&word);
    let mut rates = Vec::new();
    for gamma in [true, false] {
        let (entropy, at_least) = Entropy::of(&word, gamma, BITS)?;
        let bounds = entropy.bounds().map(|(low, high)| [float(&low), float(&high)]);
        rates.push(json!({
            "sign_gamma": if gamma { 1 } else { -1 },
            "rate": bounds,
            "at_least": at_least,
            "chaotic": matches!(entropy, Entropy::Positive { .. }),
        }));
    }
    Ok(json!({
        "sign_emu": if positive { 1 } else { -1 },
        "letters": word.letters(),
        "periods": word.vertices().iter().map(|vertex| vertex.period).collect::<Vec<_>>(),
        "fractions": word.vertices().iter().map(|v| format!("{}/{}", v.numerator, v.period)).collect::<Vec<_>>(),
        "end": { "kind": kind, "detail": text },
        "entropy": rates,
    }))
}

/// Why an orbit exists or not, by the signs that were found.
fn reason(place: &Forward, n: u64, existence: Existence) -> String {
    let index = |k: u64| place.index(n, k);
    match existence {
        Existence::Orbit(_) if n == 1 => "there is no b for n = 1; the sign of c".into(),
        Existence::Orbit(case) => {
            let b = if case.sign_emu() > 0 { '>' } else { '<' };
            let c = if case.sign_emu() == case.sign_gamma() { '>' } else { '<' };
            if n == 2 {
                format!("b_2,1 {b} 0, c_2 {c} 0")
            } else {
                format!("b_{n},1, …, b_{n},{} {b} 0, c_{n} {c} 0", n - 1)
            }
        }
        Existence::None { positive, negative } => {
            format!("b_{n},{} > 0 > b_{n},{}", index(positive), index(negative))
        }
        Existence::Singular => match Resonance::at(&place.point, n) {
            Some(resonance) => format!("u_{n} = 0, {} resonance: {resonance}", resonance.name()),
            None => format!("u_{n} = 0: Theorem 1 is silent"),
        },
        Existence::Iterate(k) => {
            let what = existence.in_words(place.region).unwrap_or("Theorem 1 is silent");
            format!("b_{n},{} = 0: {what}", index(k))
        }
        Existence::SignBoundary => format!("c_{n} = 0: Theorem 1 is silent"),
        Existence::Undecided => "undecided: the precision was not enough".into(),
    }
}

/// The answer for a request with `a1` and `a2`, or `r` and `s`, and `max_n`.
///
/// # Errors
/// An input error for a request that is not understood, or a point that is none.
pub fn point(request: &Json) -> Result<Json> {
    let given = given(request)?;
    let last = request["max_n"].as_u64().unwrap_or(12).clamp(1, 200);
    let ladder = Ladder::new(1024);
    let found = up_to(&ladder, &given.place.point, last, || Ok(()))?;
    let periods: Vec<Json> = (1u64..)
        .zip(&found)
        .map(|(n, &existence)| {
            let kind = match existence {
                Existence::Orbit(_) => "orbit",
                Existence::None { .. } => "none",
                Existence::Singular => "singular",
                Existence::Iterate(_) => "iterate",
                Existence::SignBoundary => "sign",
                Existence::Undecided => "undecided",
            };
            let cases: Vec<Json> = existence
                .cases(n)
                .iter()
                .map(|case| {
                    json!({ "case": case.to_string(), "large": large_eigenvalue_sign(given.place.region, n, *case) })
                })
                .collect();
            let why = reason(&given.place, n, existence);
            json!({ "n": n, "existence": kind, "cases": cases, "why": why })
        })
        .collect();
    let words = [true, false].map(|positive| word(&given, &ladder, positive));
    let [positive, negative] = words;
    Ok(json!({
        "region": given.place.region.to_string(),
        "reversed": given.place.reversed,
        "options": given.options,
        "place": given.floats,
        "periods": periods,
        "words": [positive?, negative?],
        "records": given.lambda.map(|lambda| records(lambda, &found)),
    }))
}

/// λ, λ², … for the record picture, in plain floats, and the case of each whose period exists.
fn records([x, y]: [f64; 2], found: &[Existence]) -> Json {
    let (mut re, mut im) = (1.0, 0.0);
    let mut powers = Vec::new();
    for (n, existence) in (1u64..).zip(found) {
        (re, im) = (re * x - im * y, re * y + im * x);
        let case = existence.cases(n).first().map(Case::to_string);
        powers.push(json!({ "n": n, "re": re, "im": im, "case": case }));
    }
    json!({ "re": x, "im": y, "powers": powers })
}

/// The certificate of the words at a point, as `grazing word … --certificate` writes it: by its own signs,
/// or, with `by_theorem`, by the word theorem.
///
/// # Errors
/// An input error for a point that is none, and where nothing can be certified.
pub fn certificate(request: &Json) -> Result<Json> {
    let given = given(request)?;
    if given.place.reversed {
        return Err(Error::input(
            "for a2 > 1 choose the time-reversed system, at a1/a2 and 1/a2 (or 1/r and s), which has a certificate",
        ));
    }
    let ladder = Ladder::default();
    let words = [true, false].map(|positive| Word::at(&ladder, &given.place.point, positive, CERTIFIED, &()));
    let [positive, negative] = words;
    let (positive, negative) = (positive?, negative?);
    let kind = match request["by_theorem"] == true {
        true => WordCertificate::ByTheorem,
        false => WordCertificate::BySigns { last: 12 },
    };
    Ok(
        match certify_word(WordPlace::Point(&given.place.point), &[&positive, &negative], kind, &mut || {
            false
        })? {
            Certified::Text(text) => {
                let lines = certificate::check(&mut text.as_bytes()).map_or(0, |checked| checked.lines);
                json!({ "certificate": text, "lines": lines })
            }
            Certified::Undecided(reason) => json!({ "undecided": reason }),
        },
    )
}

/// Where a point lies in a chart: exactly where it can, else within 2^−`bits`; with the point's other
/// coordinates in digits.
///
/// # Errors
/// An input error for a point that is none, or has no place in the chart.
pub fn place(request: &Json) -> Result<Json> {
    use grazing_scenes::number::{Angle, Ball, Circular, Precision, Real};
    let given = given(request)?;
    let bits = request["bits"].as_u64().unwrap_or(300).clamp(64, 20_000) as u32;
    let text = |key: &str| parse_rational(request[key].as_str().unwrap_or_default());
    let polar = request["r"].is_string();
    let middle = |ball: Ball| -> Result<BigRational> {
        let (low, high) = ball.exact_bounds().ok_or_else(|| Error::input("the place is not known"))?;
        Ok(short(&((low + high) / integer(2)), u64::from(bits)))
    };
    let context = Precision::new(bits + 32);
    let chart = request["chart"].as_str().unwrap_or("plane");
    let exact = |x: BigRational, y: BigRational, exact: bool| json!({ "x": x.to_string(), "y": y.to_string(), "exact": exact });
    if polar {
        let (r, s) = (text("r")?, text("s")?);
        let angle = Angle::new(&(&s * integer(2)));
        let ball = |x: &BigRational| Ball::ratio(x, &context);
        return match chart {
            "strip" => Ok(exact(s, r, true)),
            "disc" => {
                let x = middle(Ball::cos(&angle, &context) * &ball(&r))?;
                let y = middle(Ball::sin(&angle, &context) * &ball(&r))?;
                Ok(exact(x, y, false))
            }
            _ => {
                let x = middle(Ball::cos(&angle, &context) * &ball(&(&r * integer(2))))?;
                Ok(exact(x, &r * &r, false))
            }
        };
    }
    let (a1, a2) = (text("a1")?, text("a2")?);
    if chart == "plane" {
        return Ok(exact(a1, a2, true));
    }
    if given.place.region != Region::Three {
        return Err(Error::input("a point with real eigenvalues has its place in the (a1, a2) chart only"));
    }
    let (x, square) = (&a1 / integer(2), &a2 - &a1 * &a1 / integer(4));
    let y = root(&square, u64::from(bits));
    let is_exact = &y * &y == square;
    if chart == "disc" {
        return Ok(exact(x, y, is_exact));
    }
    let r = root(&a2, u64::from(bits));
    Ok(exact(short(&turn_of(&x, &y, bits), u64::from(bits)), r, false))
}
