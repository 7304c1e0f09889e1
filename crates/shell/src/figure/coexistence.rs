//! How many periods coexist at a random s: without damping by exact cells, with damping by samples, beside
//! the limit law.

use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, pow};
use rayon::prelude::*;

use super::{
    FigurePlace,
    canvas::{Anchor, At, BLUE, COLUMN, Canvas, Colour, GREEN, ORANGE, PINK, Stroke, line},
    frame::{Axis, PlotFrame, power},
    legend::Legend,
};
use crate::{
    error::{Error, Result},
    existence::{Coexistence, Coexisting, MAX_COEXISTENCE, coexisting, landau, landau_scaled},
    local::{Ladder, Point, Polar},
    monitor::Monitor,
    random::Random,
    word::{Extent, Word},
};

/// 1 − r = 10^−this for the samples.
const DAMPING: [usize; 4] = [2, 4, 8, 16];
/// Samples of s for each of them.
const SAMPLES: u64 = 2000;
/// Periods of a sample are counted up to here, with damping and without.
const LETTERS: usize = 1000;
const COUNTED: usize = 10_000;
/// ln N of the samples without damping.
const LONG: [f64; 2] = [30.0, 100.0];
/// Where the random numbers begin.
const SEED: u64 = 1;

/// A distribution function at 1, 2, …: bounds of it, and the limit law.
struct Curve {
    name: String,
    /// 1 − r, and the N that the law is taken at.
    damping: String,
    order: f64,
    values: Vec<[f64; 2]>,
}

/// Writes the picture and its data: the distribution of the number of periods that exist for eµ > 0 at a
/// random s. At r = 1 by exact cells, the periods up to `last`/100 and `last`; the periods up to e³⁰ and
/// e¹⁰⁰ at 2000 random s, and at r < 1 all periods at 2000 random s. Bounds by samples hold with a
/// probability of 99 % for each curve (Dvoretzky, Kiefer and Wolfowitz, with Massart's constant).
///
/// # Errors
/// An input error unless 300 ≤ `last` ≤ [`MAX_COEXISTENCE`]; an I/O error; the monitor's interruption.
pub fn coexistence(last: u64, place: &FigurePlace, monitor: &dyn Monitor) -> Result<()> {
    if !(300..=MAX_COEXISTENCE).contains(&last) {
        return Err(Error::input(format!(
            "N = {last}: this figure counts periods up to N, with N from 300 to {MAX_COEXISTENCE}"
        )));
    }
    let mut exact = Vec::new();
    for order in [last / 100, last] {
        exact.push(of_cells(order, monitor)?);
    }
    for logarithm in LONG {
        exact.push(of_quotients(logarithm)?);
    }
    let mut sampled = Vec::new();
    for exponent in DAMPING {
        sampled.push(of_samples(exponent, monitor)?);
    }
    let rows: Vec<Vec<String>> = exact.iter().chain(&sampled).flat_map(Curve::rows).collect();
    let columns = ["one_minus_r", "order", "periods", "lower", "upper", "law"];
    place.save(&draw(last, &exact, &sampled), &columns, &rows)
}

/// r = 1.
fn of_cells(order: u64, monitor: &dyn Monitor) -> Result<Curve> {
    let bounds = Coexistence::new(order, Coexisting::Positive, monitor)?.bounds();
    let one = (1u128 << 100) as f64;
    let (mut low, mut high) = (0u128, 0u128);
    let sums = bounds.iter().skip(1).map(|&(lower, upper)| {
        low += lower;
        high += upper;
        [low as f64 / one, (high as f64 / one).min(1.0)]
    });
    let values = sums.take(COUNTED).collect();
    Ok(Curve { name: format!("N = {order}"), damping: "0".into(), order: order as f64, values })
}

/// 1 − r = 10^−`exponent`, the law taken at N = (1 − r)^(−1/3).
fn of_samples(exponent: usize, monitor: &dyn Monitor) -> Result<Curve> {
    let small = BigRational::new(BigInt::one(), pow(BigInt::from(10), exponent));
    let r = BigRational::one() - small;
    let ladder = Ladder::default();
    // The number of periods, and whether there may be more.
    let counts = (0..SAMPLES).into_par_iter().map(|unit| {
        let bits = Random::of_unit(SEED, unit).bits() | 1;
        let s = BigRational::new(bits.into(), BigInt::one() << 65);
        let word = Word::at(&ladder, &Point::Polar(Polar::new(r.clone(), s)?), true, LETTERS, &())?;
        monitor.advance(0)?;
        Ok((word.vertices().len(), !matches!(word.extent(), Extent::Complete { .. })))
    });
    let counts: Vec<(usize, bool)> = counts.collect::<Result<_>>()?;
    let order = 10f64.powf(exponent as f64 / 3.0);
    Ok(Curve {
        name: String::new(),
        damping: format!("1e-{exponent}"),
        order,
        values: bands(&counts, LETTERS),
    })
}

/// r = 1, ln N = `logarithm`, at random s of 640 bits.
fn of_quotients(logarithm: f64) -> Result<Curve> {
    let bits = (logarithm / std::f64::consts::LN_2).round() as u32;
    let order = BigUint::one() << bits;
    let counts = (0..SAMPLES).into_par_iter().map(|unit| {
        let mut random = Random::of_unit(SEED, unit);
        let digits = (0..10).fold(BigInt::one(), |all, _| (all << 64u32) + random.bits());
        let s =
            BigRational::new((digits % (BigInt::one() << 640u32)) | BigInt::one(), BigInt::one() << 641u32);
        let count = coexisting(&s, &order, Coexisting::Positive)?;
        Ok((count.to_usize().unwrap_or(usize::MAX), false))
    });
    let counts: Vec<(usize, bool)> = counts.collect::<Result<_>>()?;
    let name = format!("N = e^{{{logarithm}}}");
    Ok(Curve { name, damping: "0".into(), order: 2f64.powi(bits as i32), values: bands(&counts, COUNTED) })
}

/// Bounds of the distribution function at 1, 2, … below `end` from samples: a number, and whether there may
/// be more.
fn bands(counts: &[(usize, bool)], end: usize) -> Vec<[f64; 2]> {
    // |F_M − F| ≤ √(ln(2/0.01)/(2M)) with a probability of 99 %.
    let many = counts.len() as f64;
    let band = (200f64.ln() / (2.0 * many)).sqrt();
    // How many have at most n, certainly and possibly.
    let (mut certain, mut possible) = (vec![0u32; end], vec![0u32; end]);
    for &(count, more) in counts.iter().filter(|one| one.0 < end) {
        possible[count] += 1;
        certain[count] += u32::from(!more);
    }
    let (mut low, mut high) = (certain[0], possible[0]);
    (1..end)
        .map(|n| {
            low += certain[n];
            high += possible[n];
            [(f64::from(low) / many - band).max(0.0), (f64::from(high) / many + band).min(1.0)]
        })
        .collect()
}

impl Curve {
    /// The law between n and n + 1.
    fn law(&self, n: f64) -> f64 {
        landau(landau_scaled(n + 0.5, self.order))
    }

    fn rows(&self) -> Vec<Vec<String>> {
        // Up to where all is nearly told.
        let told = self.values.iter().position(|[low, _]| *low > 0.95).map_or(self.values.len(), |n| n + 1);
        let row = |(n, [lower, upper]): (usize, &[f64; 2])| {
            let numbers = [*lower, *upper, self.law(n as f64)].map(|x| format!("{x:.6}"));
            let order = format!("{:.6e}", self.order);
            [vec![self.damping.clone(), order, n.to_string()], numbers.to_vec()].concat()
        };
        // Every number up to 20, then some per octave.
        let shown = |n: &(usize, &[f64; 2])| n.0 <= 20 || n.0.is_multiple_of(1 << (n.0.ilog2() - 3));
        (1..).zip(&self.values).take(told).filter(shown).map(row).collect()
    }
}

const INKS: [Colour; 4] = [PINK, ORANGE, GREEN, BLUE];
const PANEL: f64 = 132.0;
const LEFT: f64 = 36.0;

fn dashed(ink: Colour) -> Stroke {
    Stroke { ink, width: 0.7, dashes: Some([3.0, 2.0]) }
}

/// A panel of distribution functions: bands, and the law dashed.
fn panel(
    canvas: &mut Canvas,
    top: f64,
    title: &str,
    curves: &[Curve],
    names: Vec<super::canvas::Words>,
    last: bool,
) {
    let mut legend = Legend::default();
    for (name, ink) in names.into_iter().zip(INKS) {
        legend.add(name, move |canvas: &mut Canvas, (x, y): At| {
            canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], line(ink, 1.2));
        });
    }
    legend.add("law", |canvas: &mut Canvas, (x, y): At| {
        canvas.line(vec![(x - 8.0, y), (x + 8.0, y)], dashed(super::canvas::BLACK));
    });
    canvas.text(title, (LEFT, top + 5.0), Anchor::Start);
    let high = legend.height(COLUMN - LEFT - 6.0);
    legend.draw(canvas, (LEFT, top + 10.0), COLUMN - LEFT - 6.0);
    let name = if last { "number of periods" } else { "" };
    let frame = PlotFrame::new(
        [2.0, top + 12.0 + high, COLUMN - 4.0, top + PANEL + high + if last { 11.0 } else { 0.0 }],
        Axis::decades(name, [0, 4], 1),
        Axis::linear("share of s", (0.0, 1.0), 5),
    )
    .with_left(LEFT);
    canvas.inside(frame.inside(), |canvas| {
        for (curve, ink) in curves.iter().zip(INKS) {
            let steps = |bound: usize| {
                let mut path = vec![(1.0, 0.0)];
                // On a logarithmic axis one step in 32 per octave is all that is seen.
                for (n, value) in (1u32..).zip(&curve.values) {
                    let width = 1 << n.ilog2().saturating_sub(5);
                    if n.is_multiple_of(width) {
                        path.extend([n, n + width].map(|n| (f64::from(n), value[bound])));
                    }
                }
                path
            };
            let mut band = steps(0);
            band.extend(steps(1).into_iter().rev());
            canvas.polygon(frame.path(band), ink.tint(0.35));
            canvas.line(frame.path(steps(0)), line(ink, 0.5));
            canvas.line(frame.path(steps(1)), line(ink, 0.5));
        }
        for (curve, ink) in curves.iter().zip(INKS) {
            let at = (0..=160).map(|i| 10f64.powf(f64::from(i) / 40.0));
            canvas.line(frame.path(at.map(|n| (n, landau(landau_scaled(n, curve.order))))), dashed(ink));
        }
    });
    frame.draw(canvas);
}

fn draw(last: u64, exact: &[Curve], sampled: &[Curve]) -> Canvas {
    let mut canvas = Canvas::new(
        COLUMN,
        2.0 * PANEL + 78.0,
        &format!("How many periods coexist at a random s, without damping up to {last}"),
        "Two panels of distribution functions over the number of periods, logarithmic, for e mu > 0. Above: r = 1, \
         periods up to N, by exact cells; for N = e^30 and e^100 by samples. Below: r < 1, all periods, bands of 99 per cent from 2000 random s. Dashed: \
         the Landau law; below, a conjecture with N = (1 - r)^(-1/3).",
    );
    let names = exact.iter().map(|curve| curve.name.as_str().into()).collect();
    panel(&mut canvas, 2.0, "r = 1: with at most this many periods ≤ N", exact, names, false);
    let names = DAMPING.into_iter().map(|e| power(-(e as i32))).collect();
    panel(&mut canvas, PANEL + 38.0, "r < 1, by 1 − r: all periods; 99 % bands", sampled, names, true);
    canvas
}
