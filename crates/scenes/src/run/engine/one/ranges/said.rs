//! What is proved over depths, said in the scene's parameter: certificates of kind `parameter`.

use num_rational::BigRational;

use super::{
    super::proofs::system_at,
    Near, Of,
    cells::{Deep, Machines},
};
use crate::{
    error::{Error, Result},
    number::{Precision, parse_rational},
    search::{
        Accepted,
        orbit::{Jet, Quotient},
        range::Said,
    },
};

/// Of the balls by which units are chosen.
const BITS: u32 = 128;

impl Near<'_> {
    /// The certificate around one of a proof, which is said from a value of the parameter, or from the touch,
    /// to an end.
    ///
    /// # Errors
    /// Why there is none; an interruption.
    pub(super) fn said<T: Deep>(
        &self,
        behind: bool,
        (proof, machines): &(T, Machines),
        ends: Option<(Option<&str>, &str)>,
    ) -> Result<Accepted> {
        let Some((from, to)) = ends else { return Err(Error::input("no value has such a depth for all")) };
        let from = from.map(parse_rational).transpose()?;
        let mut depths: Vec<[BigRational; 2]> = Vec::new();
        let mut add = |depth: &BigRational, end: &str| -> Result<()> {
            let end = parse_rational(end)?;
            let start = depths.last().map(|[_, end]| end).or(from.as_ref()).unwrap_or(&self.start[0]);
            // What is before the start is in another cell; the last is the whole.
            if end != *start && (end > *start) == (parse_rational(to)? > self.start[0]) {
                depths.push([depth.clone(), end]);
            }
            Ok(())
        };
        for depth in proof.marks().iter().filter(|depth| *depth < proof.depth()) {
            if let Some(end) = self.over(behind, depth, machines, String::new())?.end {
                add(depth, &end)?;
            }
        }
        add(proof.depth(), to)?;
        let touch = match &self.of {
            Of::One(_) => self.parameters(behind, proof.depth())?.map(|range| range.touch),
            Of::All(all) => {
                let [at, unit] = &self.start;
                all.range([at, unit], proof.depth(), behind)?.map(|range| range.touches)
            }
        };
        let touch = touch.ok_or_else(|| Error::input("the touch is not known"))?;
        self.around(proof.accepted().text(), touch, from, &depths)
    }

    /// The same, the touch and the depths with their values being known.
    pub(super) fn around(
        &self,
        text: &str,
        touch: [BigRational; 2],
        from: Option<BigRational>,
        depths: &[[BigRational; 2]],
    ) -> Result<Accepted> {
        let (job, task) = (self.point.job, self.point.task);
        let precision = Precision::new(BITS);
        let system = match &self.of {
            Of::One(_) => system_at(job, &task.parameter, &Quotient::parameter(), &())?,
            Of::All(all) => all.functions()?,
        };
        // Of one harmonic it is known without.
        let several = self.harmonics.len() > 1;
        let said = Said {
            family: &|parameter: &Jet| system_at(job, &task.parameter, parameter, &precision),
            system: &system,
            name: &task.parameter,
            touch,
            from,
            top: several.then(|| self.point.event.phase()),
            depths,
        };
        said.around(text)
    }
}
