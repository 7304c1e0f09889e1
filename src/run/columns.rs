//! The columns of reports: the one place that tells the engines apart.
//!
//! What a task finds has the same fields, words and meaning whichever engine found it. Which of them a report
//! shows, in which order and under which names, is here: for oscillators (the engine `one`) and for
//! machines (`many`). A column is a field's name, or
//! `name = field`, or `name = list.i`.

use super::{Job, Model};

/// The columns of a table or the entries of an object.
pub(super) struct Columns {
    /// Of oscillators.
    pub one: &'static str,
    /// Of machines.
    pub many: &'static str,
}

impl Columns {
    /// Those of the job's scene.
    pub fn of(&self, job: &Job) -> &'static str {
        match job.model {
            Model::Oscillator(_) => self.one,
            Model::Machine(_) => self.many,
        }
    }
}

/// One motion.
pub(super) const SIMULATED: Columns = Columns {
    one: "periods, impacts, tangencies, rests, first_impact, end, ended_at, q = q.0, u = u.0, extent, minimum_depth",
    many: "periods, period, method, condition, modes, oscillating, stops, order_matters, first_impact, end, \
           ended_at, q, u, minimum_depth, measured",
};

/// Its lines in text.
pub(super) const SIMULATED_LINES: Columns = Columns {
    one: "periods, impacts, tangencies, rests, first_impact, ended, q, u, extent",
    many: "method, condition, modes, more_modes, period, periods, stops, first_impact, ended, measured, q, u",
};

/// Orbits of a pattern.
pub(super) const ORBITS: Columns = Columns {
    one: "value, pattern, phases, speeds, lambda1 = multipliers.0, lambda2 = multipliers.1, stable, \
          admissible, reason, least_gap, residual",
    many: "value, pattern, phases, speeds, multipliers, stable, admissible, reason, residual",
};

/// Points of branches.
pub(super) const POINTS: Columns = Columns {
    one: "branch, label, parameters, pattern, phases, speeds, lambda1 = multipliers.0, \
          lambda2 = multipliers.1, stable, admissible, reason, coefficient, criticality, least_gap, \
          residual, newton_steps, length",
    many: "branch, label, parameters, pattern, phases, speeds, multipliers, stable, admissible, reason, \
          coefficient, criticality, nearest_stop, least_gap, residual, newton_steps, length",
};

/// Bifurcations.
pub(super) const EVENTS: Columns = Columns {
    one: "parameter, pattern, phases, speeds, lambda1 = multipliers.0, lambda2 = multipliers.1, stable, \
          admissible, coefficient, criticality, length, residual",
    many: "parameter, pattern, phases, speeds, multipliers, stable, admissible, coefficient, \
          criticality, stop, phase, acceleration, length, residual",
};

/// Patterns born at a grazing.
pub(super) const BORN: Columns = Columns {
    one: "pattern, side, coefficient, found_at, phases, speeds, lambda1 = multipliers.0, \
          lambda2 = multipliers.1, admissible, reason",
    many: "pattern, side, coefficient, found_at, phases, speeds, multipliers, admissible, reason",
};

/// A grazing bifurcation.
pub(super) const GRAZING: Columns = Columns {
    one: "varied, parameter, orbit, wall = stop, phase, acceleration, matrix = a, a1, a2, \
          lambda1 = eigenvalues.0, lambda2 = eigenvalues.1, region, gamma, e, admissible, residual, \
          half, open, chaos, born, seen",
    many: "varied, parameter, stop, phase, acceleration, A = a, B = b, C = c, e, eigenvalues, a1, a2, \
          gamma, region, residual, half, open, chaos, chaos_open, born, seen",
};

/// Its lines in text.
pub(super) const GRAZING_LINES: Columns = Columns {
    one: "orbit, wall = stop, map, t_G = phase, a_G = acceleration, A = a, a1, a2, \
          lambda1 = eigenvalues.0, lambda2 = eigenvalues.1, region, gamma, e, admissible, residual, \
          open, chaos, chaos = chaos_open",
    many: "stop, map, t_G = phase, a_G = acceleration, A = rows, B = b, C = c, e, eigenvalues, a1, a2, \
          region, gamma, residual, open, chaos, chaos = chaos_open",
};

#[cfg(test)]
mod tests {
    use super::{super::table::columns_of, *};
    use crate::run::{BornRow, BranchRow, EventRow, GrazingMap, Moved, OrbitRow, Row};

    /// A column of no field would be empty, and nobody would notice.
    #[test]
    fn every_column_shows_a_field() {
        let tables = [
            (SIMULATED, Moved::fields(), &["modes", "stops", "measured"][..]),
            (SIMULATED_LINES, Moved::fields(), &["modes", "more_modes", "stops", "ended", "measured"]),
            (ORBITS, OrbitRow::fields(), &[]),
            (POINTS, BranchRow::fields(), &[]),
            (EVENTS, EventRow::fields(), &[]),
            (BORN, BornRow::fields(), &[]),
            (GRAZING, GrazingMap::fields(), &["chaos", "born", "seen"]),
            (GRAZING_LINES, GrazingMap::fields(), &["chaos", "map", "rows"]),
        ];
        for (columns, fields, further) in tables {
            for (_, field, _) in [columns.one, columns.many].into_iter().flat_map(columns_of) {
                assert!(fields.contains(&field) || further.contains(&field), "{field}: {fields:?}");
            }
        }
    }
}
