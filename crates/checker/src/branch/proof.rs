//! The rules, cell by cell.

use std::ops::Range;

use super::{
    Fault,
    text::{Cell, Certificate},
};
use crate::{
    motion::{
        Interval,
        cycle::Cycle,
        krawczyk::{Boxes, Equations},
        number::{Dual, Number},
        text::Impact,
    },
    rejection::{GoOn, claim},
};

/// Proves everything in some cells, the first of them being linked to the one before it.
pub(super) fn cells(certificate: &Certificate, which: Range<usize>, go_on: GoOn) -> Result<(), Fault> {
    let impacts = certificate.impacts();
    let mut before: Option<Vec<Interval>> = None;
    for index in which {
        let mut prove = || {
            let line = Line::new(certificate, &impacts, &certificate.cells[index]);
            if before.is_none() && index > 0 {
                let former = Line::new(certificate, &impacts, &certificate.cells[index - 1]);
                before = Some(former.at_end(&former.boxes.solution(&former, go_on)?));
            }
            let solution = line.boxes.solution(&line, go_on)?;
            if let Some(before) = &before {
                let holds = line.starts_near(before);
                claim(holds, "its orbit may not be that of the cell before (B4)")?;
            }
            line.holds(&solution, go_on)?;
            before = Some(line.at_end(&solution));
            Ok(())
        };
        let place = format!("cell {} of {}", index + 1, certificate.cells.len());
        prove().map_err(|fault: Fault| fault.at(place))?;
    }
    Ok(())
}

/// A cell, with the line about which its orbits are.
struct Line<'a> {
    certificate: &'a Certificate,
    impacts: &'a [Impact],
    cell: &'a Cell,
    /// The parameter, p₀, d, and δ from −d to d.
    parameter: Interval,
    middle: Interval,
    half: Interval,
    reach: Interval,
    /// y and y′.
    point: Vec<Interval>,
    rates: Vec<Interval>,
    boxes: Boxes,
}

impl<'a> Line<'a> {
    fn new(certificate: &'a Certificate, impacts: &'a [Impact], cell: &'a Cell) -> Line<'a> {
        let [from, to] = cell.parameter.map(|end| end.enclosed());
        let (parameter, middle, half) = (from.until(to), (from + to).half(), (to - from).half());
        let of = |value: fn(&super::Line) -> [super::Decimal; 2]| {
            let all: Vec<[Interval; 2]> =
                cell.lines.iter().map(|line| value(line).map(|x| x.enclosed())).collect();
            all.iter().map(|x| x[0]).chain(all.iter().map(|x| x[1])).collect::<Vec<_>>()
        };
        let (point, rates) = (of(|line| [line.phase, line.velocity]), of(|line| line.rates));
        let units = vec![Interval::ONE; point.len()];
        let boxes = Boxes::new(point.clone(), units, [cell.radius, cell.within], &cell.inverse);
        let reach = (-half).until(half);
        Line { certificate, impacts, cell, parameter, middle, half, reach, point, rates, boxes }
    }

    /// Where the line takes these numbers over the whole cell.
    fn along(&self, x: &[Interval]) -> Vec<Interval> {
        x.iter().zip(&self.rates).map(|(&x, &rate)| x + rate * self.reach).collect()
    }

    /// The solution at the cell's last value.
    fn at_end(&self, solution: &[Interval]) -> Vec<Interval> {
        solution.iter().zip(&self.rates).map(|(&x, &rate)| x + rate * self.half).collect()
    }

    /// B4: whether a solution at the cell's first value is within R of the line.
    fn starts_near(&self, solution: &[Interval]) -> bool {
        let radius = self.cell.radius.enclosed();
        let line = self.point.iter().zip(&self.rates).map(|(&y, &rate)| y - rate * self.half);
        solution.iter().zip(line).all(|(x, y)| x.is_within(radius, y))
    }

    /// The pattern at values of the parameter.
    fn cycle<N: Number>(&self, parameter: N) -> Result<Cycle<'a, N>, Fault> {
        Cycle::new(&self.certificate.system, self.impacts, parameter).map_err(Fault::False)
    }

    /// The equations over the cell with their derivative in a direction, in which the unknowns and the
    /// parameter have these slopes.
    fn directed(
        &self,
        x: &[Interval],
        slopes: &[Interval],
        slope: Interval,
        go_on: GoOn,
    ) -> Result<Vec<Dual>, Fault> {
        let cycle = self.cycle(Dual { value: self.parameter, slope })?;
        let x = x.iter().zip(slopes).map(|(&value, &slope)| Dual { value, slope });
        cycle.residual(&x.collect::<Vec<_>>(), go_on)
    }

    /// B2 and B3, the solutions at all values of the cell being enclosed but for their way along the line.
    fn holds(&self, solution: &[Interval], go_on: GoOn) -> Result<(), Fault> {
        let all = self.along(solution);
        let cycle = self.cycle(self.parameter)?;
        claim(
            cycle.oscillator.restitutions_are_nonnegative(),
            "a restitution is not certainly at least 0 (B2)",
        )?;
        cycle.is_orbit(&all, &self.cell.flights, None, go_on)?;
        self.cell.claim.holds(cycle.multipliers(&all, go_on)?)
    }
}

impl Equations for Line<'_> {
    /// At the line itself, over the whole cell.
    fn residual(&self, x: &[Interval], go_on: GoOn) -> Result<Vec<Interval>, Fault> {
        let there = self.cycle(self.middle)?.residual(x, go_on)?;
        let along = self.directed(&self.along(x), &self.rates, Interval::ONE, go_on)?;
        Ok(there.iter().zip(&along).map(|(&value, along)| value + along.slope * self.reach).collect())
    }

    /// By each unknown in turn, over the whole cell.
    fn derivatives(&self, region: &[Interval], go_on: GoOn) -> Result<Vec<Vec<Interval>>, Fault> {
        let (all, count) = (self.along(region), region.len());
        let mut rows = vec![Vec::with_capacity(count); count];
        for j in 0..count {
            let slopes: Vec<Interval> =
                (0..count).map(|i| if i == j { Interval::ONE } else { Interval::ZERO }).collect();
            for (row, value) in rows.iter_mut().zip(self.directed(&all, &slopes, Interval::ZERO, go_on)?) {
                row.push(value.slope);
            }
        }
        Ok(rows)
    }
}
