//! What is told of a grazing: the report of a task `grazing`, how it ended, and its lines.

use serde::Serialize;

use super::{
    AttractorProofs, BandRow, BornRow, CertificateFile, ChaosRow, GrazingMap, HitRow, InfluenceRow,
    Judgement, Lines, RangeRow, SeenRow, Sentence, Status, TouchRow, tolerance::ToleranceReport,
};

/// A grazing bifurcation, and the patterns that are born there.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GrazingReport {
    /// What happens, in sentences, each with a mark.
    pub sentences: Vec<Sentence>,
    /// The same without marks.
    pub in_words: String,
    /// The bifurcation.
    #[serde(flatten)]
    pub at: GrazingMap,
    /// Between which values of the parameter it is, of a linear motion without impacts: at one it is clear of
    /// every stop, at the other behind one. Exact, and rounded outwards.
    pub touch: Option<[String; 2]>,
    /// Why it is only located, as a root in floats.
    pub touch_open: Option<String>,
    /// All touches within the values that were asked for, the nearest first.
    pub touches: Option<Vec<TouchRow>>,
    /// Where it was not looked for touches, and why.
    pub touches_open: Option<String>,
    /// Whether chaos is born, on either side, by all patterns together; absent where no word decides.
    pub chaos: Option<Vec<ChaosRow>>,
    /// Why it is not decided whether chaos is born.
    pub chaos_open: Option<String>,
    /// The patterns that are born or open.
    pub born: Vec<BornRow>,
    /// What attracts beside the touch; absent if it was not looked for.
    pub seen: Option<Vec<SeenRow>>,
    /// Why it was not.
    pub seen_open: Option<&'static str>,
    /// What motions do over the parameter; absent if nothing was looked for, and where another orbit than the
    /// motion without impacts touches.
    pub bands: Option<Vec<BandRow>>,
    /// The same in a sentence, which is one of `in_words`.
    pub bands_in_words: Option<String>,
    /// How hard what is seen hits; absent if nothing was looked for.
    pub hits: Option<Vec<HitRow>>,
    /// By how much parameters move the touch; absent if it was not asked for.
    pub influence: Option<Vec<InfluenceRow>>,
    /// What is proved of it, if that was asked for.
    pub proofs: Option<AttractorProofs>,
    /// How far from the touch what is born is proved to go on; absent if it is not told.
    pub range: Option<Vec<RangeRow>>,
    /// Why no range was looked for, though it was asked for.
    pub range_open: Option<String>,
    /// Whether ranges are those that nobody asked for.
    #[serde(skip)]
    pub(super) main: bool,
    /// What is born of all machines that the task's tolerances allow; absent if it has none.
    pub tolerance: Option<ToleranceReport>,
    /// Why that is not told, though there are tolerances.
    pub tolerance_open: Option<String>,
    /// The certificates of ranges.
    #[serde(skip)]
    pub certificates: Vec<CertificateFile>,
    /// How many of them are open.
    #[serde(skip)]
    pub(super) undecided: usize,
}

/// What is said of a map of half a period.
const HALF: &str =
    "of half a period, then the mirror: a stop and its mirror are grazed; patterns count halves";

/// What is said of ranges for which little work was done.
const FARTHER: &str = "that far with little work: `range = true` goes farther, and tells of each orbit of one impact and \
                       of what else there is";

impl GrazingReport {
    /// How what was asked of ranges ended: undecided where something is born on a side, and no range is
    /// proved there, or of what attracts nothing is. What else was not proved there is told in its own row.
    fn range_status(&self) -> Status {
        let rows = self.range.as_deref().unwrap_or_default();
        let is_proved = |of: &RangeRow| rows.iter().any(|row| row.is_proved() && row.answers_with(of));
        let undecided = rows.iter().find(|row| row.is_undecided() && !is_proved(row)).filter(|_| !self.main);
        match (&self.range_open, undecided) {
            (Some(why), _) => Status::undecided(format!("no range is proved: {why}")),
            (None, Some(RangeRow { side, reason, .. })) => Status::undecided(format!(
                "{side} the touch no range is proved: {}",
                reason.as_deref().unwrap_or_default()
            )),
            (None, None) => Status::Done,
        }
    }

    /// How what was asked of tolerances ended.
    fn tolerance_status(&self) -> Status {
        match &self.tolerance_open {
            Some(why) => Status::undecided(format!("nothing is told of the tolerances: {why}")),
            None => self.tolerance.as_ref().map_or(Status::Done, ToleranceReport::status),
        }
    }

    /// How it ended to ask for all touches.
    fn touches_status(&self) -> Status {
        let open = self.touches_open.as_ref().filter(|_| self.touches.is_some());
        open.map_or(Status::Done, |why| Status::undecided(format!("touches: {why}")))
    }

    pub(super) fn status(&self) -> Status {
        match (&self.at.open, self.undecided) {
            (Some(reason), _) => Status::undecided(reason.clone()),
            (None, 0) if self.at.admissible == Judgement::No => {
                Status::undecided("the orbit that grazes is not one: what is born there is not decided")
            }
            (None, 0) => {
                let proofs = self.proofs.as_ref().map_or(Status::Done, AttractorProofs::status);
                let all = [proofs, self.range_status(), self.tolerance_status(), self.touches_status()];
                all.into_iter().find(|status| *status != Status::Done).unwrap_or(Status::Done)
            }
            (None, open) => Status::undecided(format!("{open} patterns are open; the table has the reasons")),
        }
    }

    pub(super) fn lines(&self, lines: &mut Lines) {
        let at = &self.at;
        Sentence::lines(&self.sentences, lines);
        lines.say("grazing", format!("{} = {}", at.varied, lines.told("parameter", at.parameter)));
        let said = match (&self.touch, &self.touch_open) {
            (Some(ends), _) => {
                let [from, to] = ends.each_ref().map(|end| lines.told("touch", end));
                format!("enclosed, between {from} and {to}")
            }
            (None, why) => format!("located, not enclosed: {}", why.as_deref().unwrap_or_default()),
        };
        lines.say("touch", said);
        lines.say_known("orbit", &at.orbit);
        lines.say("stop", at.stop.as_str());
        if at.half {
            lines.say("map", HALF);
        }
        lines.say("phase", format!("{} of the period", lines.set(at.phase)));
        lines.say("admissible", at.admissible);
        lines.say_known("open", &at.open);
        if let Some(rows) = &self.touches {
            lines.table("touches", rows);
        }
        if let Some(why) = &self.touches_open {
            lines.say("touches_open", why.as_str());
        }
        if let Some(rows) = &self.chaos {
            lines.say("chaos", ChaosRow::sentences(rows, at.half, lines));
        }
        if let Some(reason) = &self.chaos_open {
            lines.say("chaos", format!("not decided: {reason}"));
        }
        let mut rows = self.range.clone().unwrap_or_default();
        let with_little_work = |row: &&mut RangeRow| self.main && row.end.is_some();
        let main = rows.iter_mut().filter(with_little_work).map(|row| row.reason = None).count();
        for alike in rows.chunk_by(RangeRow::is_told_with) {
            RangeRow::lines(alike, (&at.varied, at.half), lines);
        }
        if main > 0 {
            lines.say("range", FARTHER);
        }
        if let Some(why) = &self.range_open {
            lines.say("range", format!("none: {why}"));
        }
        if let Some(tolerance) = &self.tolerance {
            tolerance.lines(lines);
        }
        if let Some(why) = &self.tolerance_open {
            lines.say("tolerance", format!("none: {why}"));
        }
        lines.table("born", &self.born);
        if let Some(rows) = &self.seen {
            lines.table("seen", rows);
        }
        if let Some(why) = self.seen_open {
            lines.say("seen", format!("not looked for: {why}"));
        }
        if let Some(rows) = &self.bands {
            lines.table("bands", rows);
        }
        if let Some(rows) = self.hits.as_ref().filter(|rows| !rows.is_empty()) {
            lines.table("hits", rows);
        }
        if let Some(rows) = &self.influence {
            lines.table("influence", rows);
        }
        if let Some(proofs) = &self.proofs {
            // Bounds in a proof have all their digits, and so what follows.
            at.map.lines(&at.varied, at.residual, lines);
            return proofs.lines(lines);
        }
        at.map.lines(&at.varied, at.residual, lines);
    }
}
