//! What is proved, as rows: of all that is born, of a part, of an orbit, of nothing, each over the parameter.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{
    super::super::super::range::{
        ATTRACTOR, CellRow, NOTHING, ORBIT, PROVED, RangeRow, SideRange, StabilityRow, StableRow, UNDECIDED,
        downwards, inwards, why, why_attractor, why_single,
    },
    DIGITS, ENCLOSED, Known, Near, Of, STEPS, TOUCH,
    cells::{Cells, Deep, Machines, Reached},
    functions,
};
use crate::{
    certificate::{range::Among, single::Word},
    error::{Error, Result},
    number::parse_rational,
    search::{
        attractor::{AttractorProblem, Case, Window, case, eigenvalue, prove_attractor, windows},
        chaos::{LetterGraph, RationalFunction},
        range::{
            NothingProblem, ParameterRange, RangeEffort, RangeEnd, RangeProof, SingleProblem, SingleProof,
            TouchSide, is_as_deep, prove_nothing, prove_single,
        },
    },
};

/// Digits of what is known to leading order.
const LEADING: i32 = 4;

/// The floats below and above.
fn beyond([least, greatest]: &[BigRational; 2]) -> [f64; 2] {
    // A conversion is wrong by less than this.
    const NEAR: f64 = 1e-15;
    let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
    [float(least) * (1.0 - NEAR), float(greatest) * (1.0 + NEAR)]
}

impl Near<'_> {
    /// The orbit of one impact, along its curve.
    pub(super) fn single(&self, problem: &SingleProblem, effort: &RangeEffort) -> Result<SideRange> {
        let behind = problem.behind;
        let found = self.cells(behind, effort, &|ranges, deepest, effort| {
            prove_single(
                &SingleProblem { ranges, deepest, ..problem.clone() },
                effort,
                self.point.job.monitor,
            )
        })?;
        let (mut side, cells) = self.side_of(behind, found, &|end| why_single(end, self.most))?;
        for (i, (proof, machines)) in cells.iter().enumerate() {
            let begin = i.checked_sub(1).and_then(|i| side.row.cells.get(i)).map(|cell| cell.to.clone());
            for part in self.stability(behind, proof, machines, begin)? {
                match side.row.stability.last_mut() {
                    // It goes on into the next cell.
                    Some(last) if last.word == part.word && part.from.as_ref() == Some(&last.to) => {
                        last.to = part.to;
                    }
                    _ => side.row.stability.push(part),
                }
            }
        }
        (side.row.of, side.row.periods) = (ORBIT, vec![problem.periods]);
        Ok(side)
    }

    /// Where it is stable, over the parameter from `start`, or from the touch: parts that are shown to be in
    /// the proof's.
    fn stability(
        &self,
        behind: bool,
        proof: &SingleProof,
        machines: &Machines,
        start: Option<String>,
    ) -> Result<Vec<StabilityRow>> {
        let mut all = Vec::new();
        let mut from: Option<&BigRational> = None;
        for (depth, word) in &proof.parts {
            let begin = from.replace(depth);
            let word = match word {
                Word::Stable => "stable",
                Word::Unstable => "unstable",
                Word::Open => continue,
            };
            let Some(to) = self.over(behind, depth, machines, String::new())?.end else { continue };
            let end = parse_rational(&to)?;
            // What is before the start is in the cells before this one.
            let start =
                start.as_ref().map(|text| Ok::<_, Error>((text, parse_rational(text)?))).transpose()?;
            let is_past = |value: &BigRational| {
                let start = start.as_ref().map(|(_, start)| start);
                start.is_none_or(|start| value != start && (value > start) == (*start > self.start[0]))
            };
            if !is_past(&end) {
                continue;
            }
            if let Some((text, start)) = &start
                && begin.map_or(Ok(true), |begin| self.is_as_deep(start, begin, behind))?
            {
                all.push(StabilityRow { word, from: Some(text.to_string()), to });
                continue;
            }
            let Some(begin) = begin else {
                all.push(StabilityRow { word, from: None, to });
                continue;
            };
            // Beyond the greatest parameter up to the depth where it begins, by less and less.
            let Some(last) = self.last(behind, begin, &end)? else { continue };
            let mut step = &last * BigRational::new(1.into(), 10u64.pow(DIGITS as u32).into());
            for _ in 0..STEPS {
                let value = if end > last { &last + step.abs() } else { &last - step.abs() };
                let text = inwards(&value, &end, DIGITS);
                let value = parse_rational(&text)?;
                let inside = if end > last { value < end } else { value > end };
                if inside && is_past(&value) && self.is_as_deep(&value, begin, behind)? {
                    all.push(StabilityRow { word, from: Some(text), to });
                    break;
                }
                step *= BigRational::from_integer(10.into());
            }
        }
        Ok(all)
    }

    /// About the last value of the parameter with depths up to one; of all machines the first from which each
    /// is as deep, up to `end`.
    fn last(&self, behind: bool, depth: &BigRational, end: &BigRational) -> Result<Option<BigRational>> {
        match &self.of {
            Of::One(_) => Ok(self.parameters(behind, depth)?.map(|range| range.end)),
            Of::All(all) => Ok(all.deep_from(end, depth, behind)),
        }
    }

    fn is_as_deep(&self, parameter: &BigRational, depth: &BigRational, behind: bool) -> Result<bool> {
        let system = |at: &RationalFunction| functions(self.point, at);
        match &self.of {
            Of::One(_) => is_as_deep(&system, None, parameter, depth, behind),
            Of::All(all) => Ok(all.are_as_deep(parameter, depth, behind)),
        }
    }

    /// Beyond the touch, where nothing is born: that no motion stays near.
    pub(super) fn nothing(&self) -> Result<SideRange> {
        let harmonics = &self.harmonics;
        let found = self.cells(true, self.effort(true), &|ranges, deepest, effort| {
            let problem =
                NothingProblem { mirrored: self.mirrored, ranges, harmonics: harmonics.clone(), deepest };
            prove_nothing(&problem, effort, self.point.job.monitor)
        })?;
        let (mut side, cells) = self.side_of(true, found, &|end| why(end, self.most))?;
        side.row.leaves = cells.iter().map(|(proof, _)| proof.periods).max();
        let zone = cells.iter().map(|(proof, _)| proof.zone() / TAU).min_by(f64::total_cmp);
        side.row.zone = zone.map(downwards);
        (side.row.verdict, side.row.whole) = (NOTHING, true);
        Ok(side)
    }

    /// Beyond the touch: that chaos attracts.
    pub(super) fn attractor(&self) -> Result<SideRange> {
        let open = |why: &str| {
            let row = RangeRow::open(true, UNDECIDED, Some(why.into()));
            SideRange { row: RangeRow { of: ATTRACTOR, ..row }, proofs: Vec::new() }
        };
        if self.mirrored {
            return Ok(open("it is proved beside one stop"));
        }
        let harmonics = &self.harmonics;
        // It takes milliseconds, and does not wait for what ranges leave.
        let found = self.cells(true, &RangeEffort::default(), &|ranges, deepest, _| {
            let problem = AttractorProblem { ranges, harmonics: harmonics.clone(), deepest };
            prove_attractor(&problem, self.point.job.monitor)
        })?;
        let (mut side, cells) = self.side_of(true, found, &|end| why_attractor(end, self.most))?;
        side.row.growth = cells.iter().map(|(proof, _)| proof.growth).min_by(f64::total_cmp);
        side.row.of = ATTRACTOR;
        if let Some(ends) = eigenvalue(&self.about) {
            let case = case(&ends);
            side.row.eigenvalue = Some(beyond(&ends));
            side.row.case = case.map(|case| match case {
                Case::Chaos => "chaos",
                Case::Windows => "windows",
                Case::Overlap => "overlap",
            });
            if case == Some(Case::Windows) {
                side.row.windows = self.windows()?;
            }
        }
        Ok(side)
    }

    /// The next windows, over the parameter.
    fn windows(&self) -> Result<Vec<StableRow>> {
        let harmonics = self.harmonics.clone();
        let problem = AttractorProblem { ranges: self.about.clone(), harmonics, deepest: 1.0 };
        let mut all = Vec::new();
        for Window { periods, depths } in windows(&problem) {
            let end = |depth: f64| -> Result<Option<String>> {
                let Some(depth) = BigRational::from_float(depth) else { return Ok(None) };
                Ok(self.over(true, &depth, &self.fixed(), String::new())?.end)
            };
            let told = |text: String| -> Result<String> {
                let value = parse_rational(&text)?;
                Ok(inwards(&value, &self.start[0], LEADING))
            };
            if let (Some(from), Some(to)) = (end(depths[0])?, end(depths[1])?) {
                all.push(StableRow { periods, from: told(from)?, to: told(to)? });
            }
        }
        Ok(all)
    }

    /// What is found of a graph.
    pub(super) fn judged(
        &self,
        behind: bool,
        (of, graph, whole): (&'static str, &LetterGraph, bool),
        found: Reached<Cells<RangeProof>>,
    ) -> Result<SideRange> {
        let (mut side, cells) = self.side_of(behind, found, &|end| why(end, self.most))?;
        let mut others: Option<Among> = None;
        for (i, (proof, machines)) in cells.iter().enumerate() {
            let (Some(depth), Some((_, among))) = (&proof.alone, proof.certificate.among()) else { break };
            let alone = self.over(behind, depth, machines, String::new())?.end;
            let whole = side.row.cells.get(i).map(|cell| &cell.to);
            let is_all = whole.is_some() && alone.as_ref() == whole;
            if i > 0 && !self.goes_on(alone.as_ref(), side.row.cells.get(i - 1))? {
                break;
            }
            side.row.alone = alone;
            others = Some(others.map_or(among, |others| others.and(among)));
            if !is_all {
                break;
            }
        }
        side.row.others = others.map(|others| others.to_string());
        (side.row.of, side.row.periods, side.row.whole) = (of, graph.letters.clone(), whole);
        Ok(side)
    }

    /// Whether a value of the parameter is farther from the touch than a cell's end.
    fn goes_on(&self, value: Option<&String>, cell: Option<&CellRow>) -> Result<bool> {
        let (Some(value), Some(cell)) = (value, cell) else { return Ok(false) };
        let (value, end) = (parse_rational(value)?, parse_rational(&cell.to)?);
        Ok(value != end && (value > end) == (end > self.start[0]))
    }

    /// Proofs over depths as one row over the parameter, and those of them that are in it.
    fn side_of<T: Deep>(
        &self,
        behind: bool,
        found: Reached<Cells<T>>,
        why: &dyn Fn(&RangeEnd) -> String,
    ) -> Result<(SideRange, Cells<T>)> {
        let open = |row| SideRange { row, proofs: Vec::new() };
        let mut cells = match found {
            Err(end) => return Ok((open(RangeRow::open(behind, "undecided", Some(why(&end)))), Vec::new())),
            Ok(cells) => cells,
        };
        let mut row: Option<RangeRow> = None;
        let mut ends = Vec::new();
        for (proof, machines) in &cells {
            let next = self.over(behind, proof.depth(), machines, why(proof.end()))?;
            match (&row, next.verdict == PROVED) {
                (None, false) => return Ok((open(next), Vec::new())),
                // What is proved before it stands.
                (Some(_), false) => break,
                (_, true) => {}
            }
            let from = ends.last().map(|cell: &CellRow| cell.to.clone());
            if let (Some(to), Some(depth)) = (next.end.clone(), next.depth.clone()) {
                ends.push(CellRow { from, to, depth, certificate: None });
            }
            row = Some(next);
        }
        cells.truncate(ends.len().max(1));
        let mut row = row.unwrap_or_else(|| RangeRow::open(behind, "undecided", None));
        if ends.len() > 1 {
            row.cells = ends;
        }
        let windows: Vec<_> = cells.iter().map(|(proof, _)| proof.window()).collect();
        row.window =
            windows.first().cloned().flatten().filter(|_| windows.windows(2).all(|two| two[0] == two[1]));
        let mut proofs = Vec::new();
        for (i, cell) in cells.iter().enumerate() {
            let own = row.cells.get(i).map(|own| (own.from.as_deref(), own.to.as_str()));
            let ends = own.or_else(|| row.end.as_deref().map(|end| (None, end)));
            match self.said(behind, cell, ends) {
                Ok(said) => proofs.push(said),
                Err(error) if error.is_interrupted() => return Err(error),
                Err(why) => {
                    row.left = Some(why.to_string());
                    proofs.push(cell.0.accepted().clone());
                }
            }
        }
        Ok((SideRange { row, proofs }, cells))
    }

    /// The values of the parameter with depths up to one, exactly.
    pub(super) fn parameters(&self, behind: bool, depth: &BigRational) -> Result<Option<ParameterRange>> {
        let Known { touch, ranges } = &self.known[usize::from(behind)];
        if let Some((_, range)) = ranges.borrow().iter().find(|(known, _)| known == depth) {
            return Ok(range.clone());
        }
        let system = |at: &RationalFunction| functions(self.point, at);
        // What is proved is said, whatever it costs. The number of values that are tried goes
        // with the parameter's unit, and is not counted.
        let _ = self.effort(behind).take(ENCLOSED);
        if touch.get().is_none() {
            let _ = touch.set(TouchSide::of(&system, None, self.start.each_ref(), behind)?);
        }
        let touch = touch.get().and_then(Option::as_ref);
        let range = touch.map_or(Ok(None), |touch| touch.range(&system, depth))?;
        ranges.borrow_mut().push((depth.clone(), range.clone()));
        Ok(range)
    }

    /// The values of the parameter with depths up to one, of machines of a proof.
    pub(super) fn over(
        &self,
        behind: bool,
        depth: &BigRational,
        machines: &Machines,
        reason: String,
    ) -> Result<RangeRow> {
        let [at, unit] = &self.start;
        let open = |why: String| RangeRow::open(behind, "undecided", Some(why));
        if let Of::All(all) = &self.of {
            return match all.range([at, unit], depth, behind) {
                Err(error) if error.is_interrupted() => Err(error),
                Err(error) => Ok(open(error.to_string())),
                Ok(None) => Ok(open("it is not shown where all machines within the tolerances touch".into())),
                Ok(Some(range)) => Ok(RangeRow::of_all(behind, &range, depth, unit, reason)),
            };
        }
        let known = |range: ParameterRange| match &machines.until {
            Some(until) if (*until > range.touch[1]) == (range.end > *until) => {
                ParameterRange { end: until.clone(), ..range }
            }
            _ => range,
        };
        Ok(match self.parameters(behind, depth).map(|range| range.map(known)) {
            Err(error) if error.is_interrupted() => return Err(error),
            Err(error) => open(error.to_string()),
            Ok(None) => {
                open("the depth is not shown to increase with the parameter from the touch on".into())
            }
            Ok(Some(range)) if range.touch[0].is_positive() != range.touch[1].is_positive() => {
                open("the touch is not told from 0".into())
            }
            Ok(Some(range)) => {
                let [lo, hi] = &range.touch;
                let inner = if range.end > *hi { hi } else { lo };
                let width = (&range.end - inner) / inner.abs().max(unit.clone());
                RangeRow {
                    touch: Some(inwards(inner, &range.end, TOUCH)),
                    end: Some(inwards(&range.end, inner, DIGITS)),
                    share: width.abs().to_f64().filter(|_| inner.abs() > *unit),
                    depth: Some(depth.to_string()),
                    ..RangeRow::open(behind, PROVED, Some(reason))
                }
            }
        })
    }
}
