//! How far from a grazing what is born there is proved to go on: rows of the task `grazing`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Signed, ToPrimitive};
use serde::Serialize;

use super::{Lines, Shown, row};
use crate::{
    number::parse_rational,
    output::decimal_or_fraction,
    search::{
        Accepted,
        range::{RangeEnd, ToleratedRange},
    },
};

row! {
    /// One side of a touch.
    pub struct RangeRow {
        /// `before` the touch, where the gap of the orbit that grazes is open, or `beyond` it.
        pub side: &'static str,
        /// "proved", "nothing born" or "undecided".
        pub verdict: &'static str,
        /// Of what: "all" that is certain to be born there; "part", all but one letter, and what needs it,
        /// where that goes farther; "orbit", of one impact; "attractor", that chaos attracts there.
        pub of: &'static str,
        /// The periods of the graph whose paths are motions; with `half` in the report half periods.
        pub periods: Vec<u64>,
        /// Whether this is the whole graph that is born there.
        pub whole: bool,
        /// Certain digits of the parameter at the touch, where the range begins; it is not in it.
        pub touch: Option<String>,
        /// Of all machines that the task's tolerances allow: every one touches between these values of the
        /// parameter, rounded outwards but where the range begins. That is the nearer of the two to its end,
        /// and in it, unless both are one number.
        pub touches: Option<[String; 2]>,
        /// The last value of the parameter, exactly: rounded inwards. Of all machines absent where no value
        /// has such a depth for all of them: what is proved is of each from its own touch on, to that depth.
        pub end: Option<String>,
        /// The width of the range as a part of the parameter at the touch; absent where that is 0.
        pub share: Option<f64>,
        /// ν there is at most this, exactly.
        pub depth: Option<String>,
        /// Between which times, in radians of the forcing after the phase of the touch, with two stops of
        /// either stop's, the impacts are that make a motion the only one of its path; absent where cells
        /// differ.
        pub window: Option<[String; 2]>,
        /// Up to where there are no other motions near, exactly: rounded inwards.
        pub alone: Option<String>,
        /// Which motions are none, up to there: in the words of the certificate and its units, t from the
        /// touch.
        pub others: Option<String>,
        /// Where nothing is born: within so many periods of the forcing every motion, in whatever state it
        /// begins, meets the stop farther from the touch than `zone`.
        pub leaves: Option<u64>,
        /// How far, in fractions of the period, from ν = 1/100 on; less below it.
        pub zone: Option<f64>,
        /// Of an attractor: displacements grow at least so many times from one impact to the next.
        pub growth: Option<f64>,
        /// Of an attractor at the scene's own value of the parameter, by a certificate with cells: that
        /// value, exactly; there `growth` is of displacements times weights.
        pub own_value: Option<String>,
        /// Next to it all values between these are proved.
        pub near: Option<[String; 2]>,
        /// In each period displacements grow by e to the power of this at least.
        pub rate: Option<f64>,
        /// Of an attractor: between which the larger eigenvalue of the local map is, certainly, and what that
        /// says: `chaos`, above 2/3, where it attracts at every small depth; `windows`, between 1/4 and 2/3,
        /// with a stable orbit in each, and gaps; `overlap`, below 1/4, of windows. Absent next to these.
        pub eigenvalue: Option<[f64; 2]>,
        /// The case.
        pub case: Option<&'static str>,
        /// Of windows the next ones, to leading order.
        pub windows: Vec<StableRow>,
        /// Why it goes no further, or why nothing is proved.
        pub reason: Option<String>,
        /// Of an orbit of one impact where it is stable, part by part from the touch.
        pub stability: Vec<StabilityRow>,
        /// Why a certificate speaks of ν alone, and that the parameter has its depths is left to the program;
        /// absent where it speaks of the parameter.
        pub left: Option<String>,
        /// The file of its certificate; where that has several cells, of the first.
        pub certificate: Option<String>,
        /// Where damping, stiffness or restitution change with the parameter and one certificate does not
        /// reach to the end: the parts of the range, from the touch on, each with a certificate; else none.
        pub cells: Vec<CellRow>,
    }
}

/// A part of a range with a certificate of its own, of the machines there; it begins at their touch.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct CellRow {
    /// The value of the parameter where it begins: the end of the part before; absent at a touch.
    pub from: Option<String>,
    /// The value of the parameter where it ends, exactly: rounded inwards.
    pub to: String,
    /// ν there is at most this, exactly.
    pub depth: String,
    /// The file of its certificate.
    pub certificate: Option<String>,
}

impl Shown for CellRow {
    fn set(&self, _: Option<usize>) -> String {
        let file = self.certificate.as_deref().unwrap_or("no certificate");
        format!("{} from {} to {}", file, self.from.as_deref().unwrap_or("the touch"), self.to)
    }
}

/// A window of the parameter, to leading order near the touch: the orbit of one impact in so many periods is
/// stable there.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct StableRow {
    /// From one impact to the next.
    pub periods: u64,
    /// Its end next to the touch, where the orbit flips.
    pub from: String,
    /// Its end farther from it, where the orbit touches the stop once more.
    pub to: String,
}

impl Shown for StableRow {
    fn set(&self, _: Option<usize>) -> String {
        format!("period {} from {} to {}", self.periods, self.from, self.to)
    }
}

/// A part of a range, and what is proved of an orbit's multipliers there.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct StabilityRow {
    /// "stable" or "unstable"; between parts it is neither proved to be one nor the other.
    pub word: &'static str,
    /// The value of the parameter where it begins, rounded inwards; absent at a touch, which is not in it.
    pub from: Option<String>,
    /// The value of the parameter where it ends, rounded inwards.
    pub to: String,
}

impl Shown for StabilityRow {
    fn set(&self, _: Option<usize>) -> String {
        format!("{} from {} to {}", self.word, self.from.as_deref().unwrap_or("the touch"), self.to)
    }
}

/// One of the sides.
const BEYOND: &str = "beyond";

/// The verdicts.
pub(crate) const PROVED: &str = "proved";
pub(crate) const NOTHING: &str = "nothing born";
pub(crate) const UNDECIDED: &str = "undecided";

/// What a row is of.
pub(crate) const ALL: &str = "all";
pub(crate) const PART: &str = "part";
pub(crate) const ORBIT: &str = "orbit";
pub(crate) const ATTRACTOR: &str = "attractor";

/// What is to be proved.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WantedProofs {
    /// How far what is born goes on, with so much work a side.
    pub range: Option<u64>,
    /// Of all that is born alone.
    pub main: bool,
    /// That chaos attracts beyond the touch.
    pub attractor: bool,
}

impl WantedProofs {
    /// Whether nothing is.
    pub(crate) fn is_nothing(self) -> bool {
        self.range.is_none() && !self.attractor
    }
}

/// What is proved of one side.
pub(crate) struct SideRange {
    /// What is said of it, but for the certificate's file.
    pub row: RangeRow,
    /// The certificates: one, or of several cells each; none if nothing is proved.
    pub proofs: Vec<Accepted>,
}

impl RangeRow {
    /// Of a side on which nothing is proved.
    pub(crate) fn open(behind: bool, verdict: &'static str, reason: Option<String>) -> RangeRow {
        RangeRow {
            side: if behind { BEYOND } else { "before" },
            verdict,
            of: ALL,
            periods: Vec::new(),
            whole: false,
            touch: None,
            touches: None,
            end: None,
            share: None,
            depth: None,
            window: None,
            alone: None,
            others: None,
            leaves: None,
            zone: None,
            growth: None,
            own_value: None,
            near: None,
            rate: None,
            eigenvalue: None,
            case: None,
            windows: Vec::new(),
            reason,
            stability: Vec::new(),
            left: None,
            certificate: None,
            cells: Vec::new(),
        }
    }

    /// Whether it is proved, and to more than another one of the same side is.
    pub(crate) fn goes_farther_than(&self, other: &RangeRow) -> bool {
        let number = |text: &Option<String>| text.as_ref().and_then(|text| parse_rational(text).ok());
        match (number(&self.end), number(&other.end)) {
            (Some(end), Some(whole)) => end != whole && (end > whole) == self.ends_above(),
            (end, _) => end.is_some(),
        }
    }

    /// Of all machines within tolerances, proved to a depth.
    pub(crate) fn of_all(
        behind: bool,
        range: &ToleratedRange,
        depth: &BigRational,
        unit: &BigRational,
        reason: String,
    ) -> RangeRow {
        const DIGITS: i32 = 12;
        let ToleratedRange { touches: [lower, upper], end } = range;
        let above = end.as_ref().is_none_or(|end| end > upper);
        let ends = |near: &BigRational, far: &BigRational, way: BigRational| {
            let inner = end.clone().unwrap_or_else(|| near + &way);
            [inwards(near, &inner, DIGITS), inwards(far, &(far - &way), DIGITS)]
        };
        let touches = if lower == upper {
            [decimal_or_fraction(lower), decimal_or_fraction(lower)]
        } else if above {
            let [near, far] = ends(upper, lower, unit.clone());
            [far, near]
        } else {
            ends(lower, upper, -unit)
        };
        let near = if above { upper } else { lower };
        let width = end.as_ref().map(|end| (end - near) / near.abs().max(unit.clone()));
        let share = width.and_then(|width| width.abs().to_f64()).filter(|_| near.abs() > *unit);
        RangeRow {
            touches: Some(touches),
            end: end.as_ref().map(|end| inwards(end, near, DIGITS)),
            share,
            depth: Some(depth.to_string()),
            ..RangeRow::open(behind, PROVED, Some(reason))
        }
    }

    /// What its certificate's name ends with.
    pub(super) fn ending(&self) -> String {
        match (self.of, &self.periods[..]) {
            (ORBIT, [n]) => format!("{}-{n}", self.side),
            (PART, _) => format!("{}-part", self.side),
            (ATTRACTOR, _) if self.own_value.is_some() => format!("{}-attractor-at", self.side),
            (ATTRACTOR, _) => format!("{}-attractor", self.side),
            _ => self.side.to_string(),
        }
    }

    /// That nothing is proved at the scene's own value, too.
    pub(super) fn lacks(&mut self, varied: &str, why: &str) {
        if self.is_undecided() {
            let reason = self.reason.take().unwrap_or_default();
            self.reason = Some(format!("{reason}; at the scene's own {varied} neither: {why}"));
        }
    }

    pub(super) fn is_beyond(&self) -> bool {
        self.side == BEYOND
    }

    pub(super) fn is_undecided(&self) -> bool {
        self.verdict == "undecided"
    }

    pub(super) fn is_proved(&self) -> bool {
        self.verdict == "proved"
    }

    /// Whether both are of one question: of what is born on a side, or of what attracts there.
    pub(super) fn answers_with(&self, other: &RangeRow) -> bool {
        self.side == other.side && (self.of == ATTRACTOR) == (other.of == ATTRACTOR)
    }

    /// Whether the next row is told in one line with this: of orbits none of which is proved, for one reason.
    pub(super) fn is_told_with(&self, next: &RangeRow) -> bool {
        let open = |row: &RangeRow| row.of == ORBIT && row.is_undecided();
        open(self) && open(next) && (self.side, &self.reason) == (next.side, &next.reason)
    }

    /// Tells rows that [are told](Self::is_told_with) together, which are at least one; with `half` periods
    /// are half periods.
    pub(super) fn lines(rows: &[RangeRow], (varied, half): (&str, bool), lines: &mut Lines) {
        if let [row] = rows {
            row.own_lines((varied, half), lines);
            return row.case_lines(lines);
        }
        let Some(RangeRow { side, reason, .. }) = rows.first() else { return };
        let periods: Vec<String> = rows.iter().flat_map(|row| &row.periods).map(u64::to_string).collect();
        let reason = reason.as_deref().unwrap_or_default();
        let what = format!(
            "{side} the touch, none proved of the orbits of one impact in {} {}periods",
            periods.join(", "),
            if half { "half " } else { "" }
        );
        lines.say("range", format!("{what}: {reason}"));
    }

    /// Of an attractor, which case it is.
    fn case_lines(&self, lines: &mut Lines) {
        let Some([least, greatest]) = self.eigenvalue else { return };
        // Outwards, to six places.
        let [from, to] = [(1e6 * least).floor(), (1e6 * greatest).ceil()].map(|x| x / 1e6);
        let value = match to - from < 1.5e-6 {
            true => format!("lambda_1 = {from:.6}…"),
            false => format!("lambda_1 is between {from:.6} and {to:.6}"),
        };
        let what = match self.case {
            Some("chaos") => "above 2/3: chaos attracts at every small depth".into(),
            Some("windows") => format!(
                "between 1/4 and 2/3: windows with a stable orbit and gaps without alternate to the touch, each {} times the \
                 one before",
                format_args!("{:.4}", 0.25 * (least + greatest).powi(2))
            ),
            Some("overlap") => "below 1/4: windows with a stable orbit overlap up to the touch".into(),
            _ => "which may be 1/4 or 2/3: what attracts is not decided".into(),
        };
        lines.say("case", format!("{value}, {what}"));
        if !self.windows.is_empty() {
            let all: Vec<String> = self.windows.iter().map(|one| one.set(None)).collect();
            lines.say("windows", format!("{}; to leading order", all.join("; ")));
        }
    }

    fn own_lines(&self, (varied, half): (&str, bool), lines: &mut Lines) {
        let (side, reason) = (self.side, self.reason.as_deref().unwrap_or_default());
        if let Some(at) = &self.own_value {
            let all = self.touches.as_ref().map_or("", |_| ", for every machine within the tolerances");
            let said = format!(
                "{side} the touch, at {varied} = {}{all}: {}",
                lines.told("end", at),
                self.attracting_at()
            );
            lines.say(PROVED, said);
            return self.certificate_lines(varied, lines);
        }
        if let (Some(touches), Some(depth)) = (&self.touches, &self.depth) {
            return self.lines_of_all(touches, depth, varied, lines);
        }
        let (Some(touch), Some(end)) = (&self.touch, &self.end) else {
            let of = match self.of {
                ORBIT => format!(" of {}", self.what(half)),
                ATTRACTOR => " to be chaos that attracts".into(),
                _ => String::new(),
            };
            let why = match self.verdict {
                "undecided" => format!("none proved{of}: {reason}"),
                _ if reason.is_empty() => "nothing is born".into(),
                _ => format!("nothing is born; that no motion stays near is not proved: {reason}"),
            };
            return lines.say("range", format!("{side} the touch, {why}"));
        };
        let [touch, end] = [touch, end].map(|value| lines.told("end", value));
        let above = if self.ends_above() {
            format!("{touch} < {varied} <= {end}")
        } else {
            format!("{end} <= {varied} < {touch}")
        };
        let part = self.share.map_or(String::new(), |share| format!(" ({:.2} %)", 100.0 * share));
        if let Some(leaving) = self.leaving(half) {
            lines.say(PROVED, format!("{side} the touch, for {above}{part}: nothing is born; {leaving}"));
            lines.say_known("range_ends", &self.reason);
            return self.certificate_lines(varied, lines);
        }
        if let Some(attracting) = self.attracting() {
            lines.say(PROVED, format!("{side} the touch, for {above}{part}: {attracting}"));
            return self.further_lines(varied, lines);
        }
        let what = self.what(half);
        let near = self.near(half);
        lines.say(PROVED, format!("{side} the touch, for {above}{part}: {what} is exactly one motion{near}"));
        self.further_lines(varied, lines);
    }

    /// Where no motion stays near, in which sense.
    fn leaving(&self, half: bool) -> Option<String> {
        let (periods, zone) = (self.leaves?, self.zone?);
        let [half, stop] = if half { ["half ", "a stop"] } else { ["", "the stop"] };
        Some(format!(
            "within {periods} {half}periods every motion meets {stop} more than {zone} periods from the phase of the touch \
             (less for nu < 1/100)"
        ))
    }

    /// In which sense chaos attracts.
    fn attracting(&self) -> Option<String> {
        let growth = self.growth?;
        Some(format!(
            "chaos attracts: motions are trapped where none that is periodic is stable, grazing or not, and displacements grow \
             {growth}-fold at least at every impact (that there is one attractor is not said)"
        ))
    }

    /// In which sense it does at one value.
    fn attracting_at(&self) -> String {
        let [growth, rate] = [self.growth, self.rate].map(Option::unwrap_or_default);
        format!(
            "chaos attracts: motions are trapped where none that is periodic is stable, grazing or not, and displacements, by \
             weights, grow {growth}-fold at least at every impact and e^{rate}-fold in a period (that there is one attractor \
             is not said)"
        )
    }

    /// What is exactly one motion.
    fn what(&self, half: bool) -> String {
        let half = if half { "half " } else { "" };
        let periods: Vec<String> = self.periods.iter().map(u64::to_string).collect();
        let periods = periods.join(", ");
        let which = match self.of {
            ORBIT if self.periods == [1] => return format!("the orbit of one impact a {half}period"),
            ORBIT => return format!("the orbit of one impact in {periods} {half}periods"),
            _ if self.whole => "",
            PART => ", the part that goes farther,",
            _ => ", a part of those that are born,",
        };
        format!("every path of the graph of the {half}periods {periods}{which}")
    }

    /// Where its impacts are.
    fn near(&self, half: bool) -> String {
        let phase = if half { "the phase of a touch" } else { "the phase of the touch" };
        match self.window.as_ref().map(|[from, to]| [from.as_str(), to]) {
            None => ", with its impacts where the certificates say".into(),
            Some(["0", to]) => format!(", with its impacts within {to} radians after {phase}"),
            Some([from, "0"]) => {
                format!(", with its impacts within {} radians before {phase}", from.trim_start_matches('-'))
            }
            Some([_, to]) => format!(", with its impacts within {to} radians of {phase}"),
        }
    }

    /// Of all machines within tolerances.
    fn lines_of_all(&self, touches: &[String; 2], depth: &str, varied: &str, lines: &mut Lines) {
        let (side, [lower, upper]) = (self.side, touches.each_ref().map(|touch| lines.told("end", touch)));
        let part = self.share.map_or(String::new(), |share| format!(" ({:.2} %)", 100.0 * share));
        let (at, sign) = match lower == upper {
            true => (format!("{varied} = {lower}"), "<"),
            false => (format!("{lower} <= {varied} <= {upper}"), "<="),
        };
        let common = match self.end.as_ref().map(|end| lines.told("end", end)) {
            Some(end) if self.ends_above() => {
                format!("and so of all of them for {upper} {sign} {varied} <= {end}{part}")
            }
            Some(end) => format!("and so of all of them for {end} <= {varied} {sign} {lower}{part}"),
            None => format!("which no {varied} has for all of them"),
        };
        let depth =
            parse_rational(depth).map_or_else(|_| depth.to_string(), |depth| decimal_or_fraction(&depth));
        let what = match (self.leaving(false), self.attracting()) {
            (Some(leaving), _) => format!("nothing is born, and {leaving}"),
            (None, Some(attracting)) => attracting,
            (None, None) => format!("{} is exactly one motion{}", self.what(false), self.near(false)),
        };
        lines.say(
            PROVED,
            format!(
                "{side} the touch, for every machine within the tolerances, from its own touch, which is at {at}, \
                 to the depth nu = {depth}, {common}: {what}"
            ),
        );
        self.further_lines(varied, lines);
    }

    /// What else is proved, and why it ends.
    fn further_lines(&self, varied: &str, lines: &mut Lines) {
        if let (Some(alone), Some(others)) = (&self.alone, &self.others) {
            let alone = lines.told("end", alone);
            let way = if self.ends_above() { "<=" } else { ">=" };
            lines.say("alone", format!("for {varied} {way} {alone}: {others}"));
        }
        if !self.stability.is_empty() {
            lines.say("stability", self.stability_in_words(varied, lines));
        }
        lines.say_known("range_ends", &self.reason);
        self.certificate_lines(varied, lines);
    }

    /// Its certificate, or whose which cell is.
    fn certificate_lines(&self, varied: &str, lines: &mut Lines) {
        if let Some(why) = &self.left {
            lines.say(
                "left",
                format!("the certificate is of nu, that {varied} has its depths is not in it: {why}"),
            );
        }
        if self.cells.is_empty() {
            return lines.say_known("certificate", &self.certificate);
        }
        let way = if self.ends_above() { "<=" } else { ">=" };
        let to = |cell: &CellRow| lines.told("end", &cell.to);
        let cell =
            |cell: &CellRow| Some(format!("{} to {varied} {way} {}", cell.certificate.as_ref()?, to(cell)));
        let all: Vec<String> = self.cells.iter().filter_map(cell).collect();
        if !all.is_empty() {
            lines.say("certificates", all.join("; "));
        }
    }

    /// Where the orbit is stable, as inequalities, from the touch on.
    fn stability_in_words(&self, varied: &str, lines: &Lines) -> String {
        let above = self.ends_above();
        let told = |value: &String| lines.told("end", value);
        let part =
            |StabilityRow { word, from, to }: &StabilityRow| match (from.as_ref().map(told), told(to), above)
            {
                (None, to, true) => format!("{word} for {varied} <= {to}"),
                (None, to, false) => format!("{word} for {varied} >= {to}"),
                (Some(from), to, true) => format!("{word} for {from} <= {varied} <= {to}"),
                (Some(from), to, false) => format!("{word} for {to} <= {varied} <= {from}"),
            };
        self.stability.iter().map(part).collect::<Vec<_>>().join("; ")
    }

    /// Whether the range is that of greater values.
    fn ends_above(&self) -> bool {
        let number = |text: &Option<String>| text.as_ref().and_then(|text| parse_rational(text).ok());
        let near = self.touches.as_ref().map(|[lower, _]| lower.clone());
        number(&self.end) > number(&near.or_else(|| self.touch.clone()))
    }
}

/// What a decimal that is small begins with.
const SMALL: &str = "00000";

/// A positive number downwards, to four digits.
pub(crate) fn downwards(x: f64) -> f64 {
    let scale = 10f64.powi(3 - x.log10().floor() as i32);
    // Below what rounding made of it.
    (x * (1.0 - 1e-12) * scale).floor() / scale
}

/// Why a range ends, in words.
pub(crate) fn why(end: &RangeEnd, effort: u64) -> String {
    match end {
        RangeEnd::Asked => "no more is looked at".into(),
        RangeEnd::Map => "next to it no ranges of strengths are found that the map keeps: this ends the proof, not the motions".into(),
        RangeEnd::Refused(why) => format!("next to it the checker refuses: {why}"),
        RangeEnd::Work => format!("its part of the work allowed on this side, {effort}, is done: raise `effort`"),
        RangeEnd::Wide => "farther away damping, stiffness or restitution change too much for the proofs that are tried: this ends the proof, not the motions".into(),
        RangeEnd::Unbounded => "no bound is found for how long motions near stay off the stop".into(),
    }
}

/// Why the range of an orbit of one impact ends, in words.
pub(crate) fn why_single(end: &RangeEnd, effort: u64) -> String {
    match end {
        RangeEnd::Refused(why) if why.contains("(S1)") => "next to it the orbit folds (the checker cannot tell that nu increases)".into(),
        RangeEnd::Refused(why) if why.contains("(S3)") => {
            "next to it the orbit touches the stop once more (the checker cannot tell that the gap is positive)".into()
        }
        end => why(end, effort),
    }
}

/// Why the range of an attractor ends, in words.
pub(crate) fn why_attractor(end: &RangeEnd, effort: u64) -> String {
    match end {
        RangeEnd::Map => {
            "farther away displacements need not grow at every impact: this ends the proof, not the chaos"
                .into()
        }
        RangeEnd::Refused(why) => why.clone(),
        end => why(end, effort),
    }
}

/// A number of so many digits from an end of a range towards its inner side, as a decimal; of more digits
/// where that would leave the range, and the end itself, as a fraction, where so many are not enough.
pub(crate) fn inwards(end: &BigRational, inner: &BigRational, digits: i32) -> String {
    const MOST: i32 = 40;
    let size = end.abs().to_f64().filter(|size| *size > 0.0 && size.is_finite()).map_or(0.0, f64::log10);
    let ten = |power: i32| BigRational::from(BigInt::from(10).pow(power.unsigned_abs()));
    for digits in (digits..=MOST.max(digits)).step_by(4) {
        let places = digits - 1 - size.floor() as i32;
        let scaled = if places >= 0 { end * ten(places) } else { end / ten(places) };
        let whole = if inner > end { scaled.ceil() } else { scaled.floor() };
        let value = if places >= 0 { &whole / ten(places) } else { &whole * ten(places) };
        let within = if inner > end { value < *inner } else { value > *inner };
        if within {
            return decimal(&value, places);
        }
    }
    end.to_string()
}

/// A number of at most so many places after the point; a small one by its exponent.
fn decimal(value: &BigRational, places: i32) -> String {
    let places = places.max(0) as usize;
    let scaled = (value.abs() * BigRational::from(BigInt::from(10).pow(places as u32))).to_integer();
    let digits = format!("{scaled:0>width$}", width = places + 1);
    let (whole, part) = digits.split_at(digits.len() - places);
    let part = part.trim_end_matches('0');
    let sign = if value.is_negative() { "-" } else { "" };
    if whole == "0" && part.starts_with(SMALL) {
        let digits = part.trim_start_matches('0');
        let (first, rest) = digits.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        return format!("{sign}{first}{point}{rest}e-{}", part.len() - digits.len() + 1);
    }
    if part.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") }
}

#[cfg(test)]
mod tests {
    use super::{decimal, downwards, inwards};
    use crate::number::parse_rational;

    #[test]
    fn an_end_is_rounded_towards_the_touch() {
        let at = |text: &str| parse_rational(text).unwrap();
        for (end, inner, shown) in [
            ("2/3", "1", "0.667"),
            ("2/3", "1/2", "0.666"),
            ("-2/3", "0", "-0.666"),
            ("-2/3", "-1", "-0.667"),
            ("1/300", "0", "0.00333"),
            ("200000/3", "0", "66600"),
            ("1/8", "1", "0.125"),
            // What is left between the two has more digits.
            ("2/3", "2001/3001", "0.6666667"),
            (
                "2/3",
                "200000000000000000000000000000000000000000001/300000000000000000000000000000000000000000001",
                "2/3",
            ),
            ("2/3", "2/3", "2/3"),
            ("0", "1", "0"),
            ("1/3000000", "1", "3.34e-7"),
            ("-1/3000000", "1", "-3.33e-7"),
            ("1/40000000000000000000000", "0", "2.5e-23"),
            ("1/50000", "0", "0.00002"),
        ] {
            assert_eq!(inwards(&at(end), &at(inner), 3), shown, "{end} {inner}");
        }
        assert_eq!(decimal(&at("-3/2500"), 4), "-0.0012");
        for (x, shown) in [(0.009_187_9, 0.009_187), (0.3, 0.2999), (1.0, 0.999), (2.5e-9, 2.499e-9)] {
            assert!(downwards(x) < x && (downwards(x) / shown - 1.0).abs() < 1e-12, "{x}");
        }
    }
}
