//! Cells with weights, as a certificate that the checker accepts.

use num_rational::BigRational;

use super::{
    super::{
        constants::Constants,
        stop::Stop,
        write::{MOST_PIECES, PIECES, rounded, setting},
    },
    CellsProblem, CellsProof, float_of,
    weights::{Asked, Graph},
};
use crate::{
    Accepted,
    certificate::attractor::{
        Decimal, Shown,
        cells::{Cell, Certificate},
    },
    chaos::write::{decimal, fraction},
    error::Result,
    range::RangeEnd,
};

/// What is listed of a growth's logarithm, and less for each try.
const LISTED: f64 = 1.0 - 1e-4;
const LESS: f64 = 0.97;

/// All but the growth and the cells.
pub(super) fn head(problem: &CellsProblem, stop: &Stop, constants: &Constants) -> Result<Certificate> {
    let [least, greatest] = &problem.depths;
    let zero = decimal(0.0, 0)?;
    Ok(Certificate {
        setting: setting(&problem.ranges, &problem.harmonics, fraction(greatest)?, (stop, constants))?,
        least: fraction(least)?,
        start: rounded(constants.start * (1.0 - 1e-3), 3, false)?,
        growth: zero,
        rate: zero,
        last: 0,
        cells: Vec::new(),
    })
}

/// Puts the cells in.
pub(super) fn cells(certificate: &mut Certificate, graph: &Graph, weights: &[u64]) -> Result<()> {
    let last = graph.ends.len().saturating_sub(1);
    let cell = |(i, (&end, &weight)): (usize, (&f64, &u64))| -> Result<Cell> {
        let end = if i == last { certificate.setting.speed } else { decimal(end, 9)? };
        Ok(Cell { end, weight })
    };
    certificate.cells = graph.ends.iter().zip(weights).enumerate().map(cell).collect::<Result<_>>()?;
    certificate.last = graph.listed();
    Ok(())
}

/// The growth and the exponent as a certificate has them; none where nothing is left of them.
fn growths(Asked { impact, period }: Asked) -> Result<Option<[Decimal; 2]>> {
    let growth = decimal(((impact.exp() * 1e5).floor() / 1e5).max(0.0), 5)?;
    if float_of(growth) <= 1.0 || period < 1e-6 {
        return Ok(None);
    }
    Ok(Some([growth, rounded(period, 4, false)?]))
}

/// The proof, or why the checker refuses it.
pub(super) fn proof(
    mut certificate: Certificate,
    depths: [BigRational; 2],
    mut asked: Asked,
) -> Result<std::result::Result<CellsProof, RangeEnd>> {
    let least = certificate.setting.shown.map_or(1, |shown| shown.pieces);
    asked = Asked { impact: asked.impact * LISTED, period: asked.period * LISTED };
    let mut refused = String::new();
    for more in PIECES {
        let shown = certificate.setting.shown;
        certificate.setting.shown =
            shown.map(|shown| Shown { pieces: (least * more).min(MOST_PIECES), ..shown });
        let Some([growth, rate]) = growths(asked)? else { return Ok(Err(RangeEnd::Map)) };
        (certificate.growth, certificate.rate) = (growth, rate);
        match Accepted::new(certificate.to_string()) {
            Ok(accepted) => {
                let [growth, rate] = [growth, rate].map(float_of);
                return Ok(Ok(CellsProof { certificate, accepted, depths, growth, rate }));
            }
            Err(why) => refused = why.to_string(),
        }
        if !refused.contains("(A1)") {
            asked = Asked { impact: asked.impact * LESS, period: asked.period * LESS };
        }
    }
    Ok(Err(RangeEnd::Refused(refused)))
}
