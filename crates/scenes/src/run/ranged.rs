//! How far what is born at a touch is proved to go on, in a sentence for each row: the end of few digits,
//! rounded towards the touch. The lines of the report have it exactly, and what else is proved.

use super::{
    Mark, RangeRow, Sentence,
    range::{ALL, ATTRACTOR, inwards},
};
use crate::{number::parse_rational, output::decimal_or_fraction, scene::WrittenUnit};

/// Digits of an end.
const DIGITS: i32 = 4;

impl RangeRow {
    /// What is proved of one machine in the parameter's own unit, of all that is born or attracts on a side;
    /// none of a part, and where nothing is proved; located where the certificate is of ν alone. With `half`
    /// periods are half periods.
    pub(super) fn sentence(
        &self,
        (varied, half): (&str, bool),
        unit: Option<&WrittenUnit>,
    ) -> Option<Sentence> {
        if self.touches.is_some() || ![ALL, ATTRACTOR].contains(&self.of) {
            return None;
        }
        let number = |text: &Option<String>| {
            let exact = parse_rational(text.as_ref()?).ok()?;
            Some(unit.map_or(exact.clone(), |unit| exact / &unit.size))
        };
        let name = unit.map_or(String::new(), |unit| format!(" {}", unit.text));
        let name = name.trim_end();
        let side = self.side;
        let half = if half { "half " } else { "" };
        let attracts = "chaos attracts: motions are trapped where none that is periodic is stable";
        if let Some(at) = number(&self.own_value) {
            let at = decimal_or_fraction(&at);
            return Some(Mark::Proved.of(format!("At {varied} = {at}{name} {attracts}.")));
        }
        let (touch, end) = (number(&self.touch)?, number(&self.end)?);
        let end = format!("{varied} = {}{name}", inwards(&end, &touch, DIGITS));
        let what = match (self.leaves, self.growth, &self.periods[..]) {
            (Some(periods), ..) => format!(
                "From the touch to {end} no motion stays near it: within {periods} {half}periods each meets the stop at \
                 another phase."
            ),
            (None, Some(_), _) => format!("From the touch to {end} {attracts}."),
            (.., periods) => {
                let what = match periods {
                    [1] => format!("the orbit of one impact in each {half}period"),
                    [n] => format!("the orbit of one impact in {n} {half}periods"),
                    _ => {
                        let periods: Vec<String> = periods.iter().map(u64::to_string).collect();
                        format!("every path of the graph of the {half}periods {}", periods.join(", "))
                    }
                };
                format!(
                    "{} is born {side} the touch goes on to {end}: {what} is exactly one motion with its impacts near the \
                     phase of the touch.",
                    if self.whole { "What" } else { "A part of what" },
                )
            }
        };
        Some(match self.left {
            None => Mark::Proved.of(what),
            // The weaker of both is what the sentence rests on.
            Some(_) => Mark::Located.of(format!(
                "{what} That is proved of the depth behind the stop; that {varied} has these depths is located."
            )),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::range::PROVED;

    /// An end is rounded towards the touch, on either side of it, and a certificate that is of ν alone proves
    /// no value of the parameter.
    #[test]
    fn a_sentence_says_no_more_than_its_row() {
        let row = |touch: &str, end: &str| RangeRow {
            touch: Some(touch.into()),
            end: Some(end.into()),
            periods: vec![1],
            whole: true,
            ..RangeRow::open(false, PROVED, None)
        };
        for (touch, end, told) in [
            ("0.70710678", "0.66669317", "F = 0.6667:"),
            ("0.70710678", "0.76664", "F = 0.7666:"),
            ("-1", "-1.000066", "F = -1.000066:"),
            ("1e-9", "1.23456e-9", "F = 1.234e-9:"),
        ] {
            let said = row(touch, end).sentence(("F", false), None).unwrap();
            assert!(said.mark == Mark::Proved && said.text.contains(told), "{said:?}");
        }
        let left = RangeRow { left: Some("why".into()), ..row("1", "2") };
        let said = left.sentence(("F", false), None).unwrap();
        assert!(said.mark == Mark::Located && said.text.ends_with("is located."), "{said:?}");
        assert_eq!(RangeRow { end: None, ..row("1", "2") }.sentence(("F", false), None), None);
    }
}
