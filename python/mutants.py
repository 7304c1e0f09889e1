"""Faults that users would see, each put into a copy of the package: the test named beside it must fail.

    python/mutants.sh [NAME ...]              all, or these
    python/mutants.sh --tests FILE ... --     all, each against these files of tests instead of its own test

Of a mutant in Rust the compiled part is built again. Exit code 1 if one survives, changes nothing or does not
build; the list is at the end. Not a test itself: `tests/test_package.py` holds the list against the sources.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent


@dataclass(frozen=True)
class Mutant:
    """One text of a file of `python/` in place of another, which stands there once."""

    name: str
    file: str
    old: str
    new: str
    #: A test of `python/tests`, FILE::NAME, that fails.
    test: str


def main(arguments: list[str]) -> int:
    tests: list[str] = []
    if arguments[:1] == ["--tests"]:
        end = arguments.index("--")
        tests, arguments = arguments[1:end], arguments[end + 1:]
    unknown = set(arguments) - {mutant.name for mutant in MUTANTS}
    if unknown:
        raise SystemExit(f"no mutant {', '.join(sorted(unknown))}")
    chosen = [mutant for mutant in MUTANTS if not arguments or mutant.name in arguments]
    copy = Copy()
    if copy.run(tests or sorted({mutant.test for mutant in chosen})) != 0:
        raise SystemExit("the tests fail without a mutant")
    survived = [mutant.name for mutant in chosen if not copy.kills(mutant, tests or [mutant.test])]
    print(f"{len(chosen) - len(survived)} of {len(chosen)} mutants were killed")
    if survived:
        print("survived:", ", ".join(survived))
    return bool(survived)


class Copy:
    """The package, its tests and beside it the rest of the repository, in a folder that may be spoiled: always the
    same, so that Cargo builds again what differs."""

    def __init__(self) -> None:
        self.target = Path(os.environ.get("CARGO_TARGET_DIR", HERE / "target"))
        folder = self.target / "mutants"
        shutil.rmtree(folder, ignore_errors=True)
        self.python = folder / "python"
        self.python.mkdir(parents=True)
        for name in ("grazing", "src", "tests", "Cargo.toml", "Cargo.lock", "mutants.py"):
            source, target = HERE / name, self.python / name
            shutil.copytree(source, target) if source.is_dir() else shutil.copy2(source, target)
        for name in ("checker", "docs", "examples", "tests"):
            (folder / name).symlink_to(ROOT / name)
        manifest = self.python / "Cargo.toml"
        manifest.write_text(manifest.read_text().replace('path = ".."', f'path = "{ROOT}"'))
        self.compiled = self.python / "grazing" / "_grazing.abi3.so"
        self.build()
        self.sound = self.compiled.read_bytes()

    def build(self) -> None:
        """The compiled part, beside the Python files."""
        environment = {**os.environ, "CARGO_TARGET_DIR": str(self.target), "PYO3_BUILD_EXTENSION_MODULE": "1",
                       "PYO3_PYTHON": sys.executable}
        subprocess.run(["cargo", "build", "--quiet", "--locked", "--profile", "quick"], cwd=self.python,
                       env=environment, check=True)
        self.compiled.unlink(missing_ok=True)
        shutil.copy(self.target / "quick" / "lib_grazing.so", self.compiled)

    def run(self, tests: list[str]) -> int:
        """What pytest says: 0 if all pass, 1 if some fail."""
        command = [sys.executable, "-m", "pytest", "--quiet", "-x", "-p", "no:cacheprovider", "--no-header", "--tb=line"]
        environment = {**os.environ, "PYTHONPATH": str(self.python), "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run([*command, *(str(self.python / "tests" / test) for test in tests)], env=environment,
                              cwd=self.python / "tests", capture_output=True, text=True)
        if done.returncode not in (0, 1):
            print(done.stdout[-2000:], done.stderr[-2000:])
        return done.returncode

    def kills(self, mutant: Mutant, tests: list[str]) -> bool:
        """Whether a test fails where the mutant is in the package; then it is taken out again."""
        start = time.monotonic()
        path = self.python / mutant.file
        text = path.read_text()
        if text.count(mutant.old) != 1:
            raise SystemExit(f"{mutant.name}: its text stands {text.count(mutant.old)} times in {mutant.file}")
        compiled = path.suffix == ".rs"
        path.write_text(text.replace(mutant.old, mutant.new))
        try:
            if compiled:
                self.build()
            code = self.run(tests)
        finally:
            path.write_text(text)
            if compiled:
                self.compiled.unlink()
                self.compiled.write_bytes(self.sound)
        end = {0: "SURVIVED", 1: "killed"}.get(code, "BROKEN")
        print(f"{end:8} {mutant.name:28} {' '.join(tests)} ({time.monotonic() - start:.0f} s)", flush=True)
        return code == 1


PROOFS, PLACES, SCENE, THEORY, TOLERANCES = (
    f"grazing/_{name}.py" for name in ("proofs", "places", "scene", "theory", "tolerances"))
FORCED, ARRAYS, BOXES, PROCESSES, SHOWN, MACHINES = (
    f"test_{name}.py::" for name in ("forced", "arrays", "boxes", "processes", "shown", "machines"))

MUTANTS = [
    # What is not proved would be.
    Mutant("disagreement-proved", "src/proofs.rs",
           'Proof { contradiction: Some(n), .. } => {', 'Proof { contradiction: Some(n), periods: 0, .. } => {',
           FORCED + "test_a_proof_that_fails_is_not_proved_and_writes_no_certificate"),
    Mutant("refuted-proved", "src/proofs.rs",
           'Proof { refuted: Some(decision), .. } => {', 'Proof { refuted: Some(decision), periods: 0, .. } => {',
           FORCED + "test_a_proof_that_fails_is_not_proved_and_writes_no_certificate"),
    Mutant("undecided-proved", "src/proofs.rs",
           'Proof { pending: 0, undecided: 0, .. } => ("proved", None)', 'Proof { pending: 0, .. } => ("proved", None)',
           FORCED + "test_a_proof_that_fails_is_not_proved_and_writes_no_certificate"),
    Mutant("certificate-of-a-refutation", "src/proofs.rs",
           '!whole || proof.refuted.is_some() || proof.contradiction.is_some()', '!whole',
           FORCED + "test_a_proof_that_fails_is_not_proved_and_writes_no_certificate"),
    Mutant("pending-undecided", PROOFS, 'if verdict == "pending":', 'if verdict == "left":',
           FORCED + "test_a_proof_that_fails_is_not_proved_and_writes_no_certificate"),
    Mutant("refuted-undecided", PROOFS, 'if verdict == "refuted":', 'if verdict == "false":',
           FORCED + "test_a_proof_that_fails_is_not_proved_and_writes_no_certificate"),
    Mutant("open-certificate-false", "src/proofs.rs",
           '("undecided", None, None, Some(line), Some(reason))', '("false", None, None, Some(line), Some(reason))',
           FORCED + "test_a_certificate_that_proves_nothing_is_not_proved"),
    Mutant("open-certificate-proved", PROOFS, 'return Undecided("the certificate\'s statement", budget',
           'return Proved("the certificate\'s statement") if line else Undecided("", budget',
           FORCED + "test_a_certificate_that_proves_nothing_is_not_proved"),
    Mutant("rejected-refuted", PROOFS, 'return Rejected("the certificate\'s statement", reason',
           'return Refuted("the certificate\'s statement", witness',
           FORCED + "test_a_rejected_file_is_named_with_its_line"),
    Mutant("undecided-no-orbit", "src/classify.rs", 'Existence::Undecided => 32', 'Existence::Undecided => 0',
           FORCED + "test_a_period_that_is_left_open_is_none_without_an_orbit"),
    Mutant("boundary-no-orbit", "src/classify.rs", 'Existence::SignBoundary => 16', 'Existence::SignBoundary => 0',
           FORCED + "test_a_period_that_is_left_open_is_none_without_an_orbit"),
    Mutant("open-point-proved", PLACES, 'if open_:', 'if open_ and len(open_) == len(self):',
           FORCED + "test_a_period_that_is_left_open_is_none_without_an_orbit"),
    Mutant("cut-word-proved", PLACES, 'if w.end not in ("all", "complete")]', 'if w.end not in ("all", "complete", "cut")]',
           FORCED + "test_a_word_with_any_other_end_is_not_whole"),
    Mutant("undecided-word-proved", PLACES, 'if w.end not in ("all", "complete")]', 'if w.end in ("cut", "boundary")]',
           FORCED + "test_a_word_with_any_other_end_is_not_whole"),
    Mutant("open-edge-proved", PLACES, 'for w in self.words for c in w.cases if c.open]',
           'for w in self.words for c in w.cases if c.open and c.lower_bound]',
           FORCED + "test_a_word_with_an_open_edge_is_not_whole"),
    Mutant("chaos-from-0", PLACES, 'self.entropy[0] > 0', 'self.entropy[1] > 0',
           FORCED + "test_chaos_is_what_has_an_entropy_that_is_certainly_above_0"),
    Mutant("edge-without-bounds-proved", PROOFS, 'if self.r is not None else Undecided', 'if self.kind else Undecided',
           FORCED + "test_an_edge_without_bounds_is_undecided"),
    Mutant("open-pattern-proved", THEORY, 'if "open" in (self.plus, self.minus):', 'if self.plus == self.minus == "open":',
           FORCED + "test_a_pattern_with_an_open_side_is_undecided"),
    Mutant("disagreement-done", THEORY, 'if tally["disagreements"] or tally["faults"]:',
           'if tally["disagreements"] and tally["faults"]:', FORCED + "test_a_campaign_says_what_it_met"),
    Mutant("undecided-cases-done", THEORY, 'elif tally["undecided"]:', 'elif tally["undecided"] > decided:',
           FORCED + "test_a_campaign_says_what_it_met"),
    Mutant("floats-prove", SCENE, '_PROOFS = ("validate", "chaos")', '_PROOFS = ("validate", "chaos", "grazing")',
           FORCED + "test_only_proofs_are_proved"),
    Mutant("undecided-task-done", SCENE, 'return Undecided(statement, budget=reason)', 'return Done(statement)',
           FORCED + "test_a_task_ends_as_it_says"),
    Mutant("refuted-task-open", SCENE, 'return Refuted(statement, witness=reason)',
           'return Undecided(statement, budget=reason)', FORCED + "test_a_task_ends_as_it_says"),
    Mutant("new-status-proved", SCENE, 'if status == "done":', 'if status not in ("nothing-found", "refuted", "undecided", '
           '"interrupted", "pending"):', FORCED + "test_a_status_that_is_not_known_is_not_proved"),
    Mutant("best-task", SCENE, 'return min(outcomes,', 'return max(outcomes,', FORCED + "test_a_run_is_as_its_worst_task"),
    Mutant("outcome-is-true", "grazing/_outcomes.py", '        kind = type(self).__name__\n        raise TypeError(',
           '        kind = type(self).__name__\n        return True\n        raise TypeError(',
           "test_outcomes.py::test_no_outcome_is_a_bool"),
    # Another number than the one that was given.
    Mutant("float-taken", "src/exact.rs", 'if object.cast::<PyFloat>().is_ok() ||', 'if false &&',
           "test_numbers.py::test_a_float_is_refused_with_both_ways_out"),
    Mutant("floats-taken", "grazing/_arrays.py", 'if floats is None:\n        raise TypeError(',
           'floats = floats or "binary"\n    if floats is None:\n        raise TypeError(',
           ARRAYS + "test_a_float_is_refused_where_it_is_not_said_what_it_means"),
    Mutant("decimal-as-binary", "src/columns.rs", '"decimal" => Column::Decimal(', '"decimal" => Column::Binary(',
           ARRAYS + "test_a_float_means_what_it_is_said_to_mean"),
    Mutant("binary-as-decimal", "grazing/_arrays.py", 'if floats == "binary" else Fraction(repr(float(x)))',
           'if floats == "decimal" else Fraction(repr(float(x)))', ARRAYS + "test_a_float_means_what_it_is_said_to_mean"),
    Mutant("fractions-upside-down", "src/columns.rs", 'Column::Pairs(numerators, denominators)\n            }\n            "exact"',
           'Column::Pairs(denominators, numerators)\n            }\n            "exact"',
           ARRAYS + "test_two_arrays_of_integers_are_fractions"),
    Mutant("mask-dropped", "grazing/_arrays.py",
           'hidden = np.ma.getmaskarray(array) if isinstance(array, np.ma.MaskedArray) else None', 'hidden = None',
           ARRAYS + "test_what_is_masked_is_not_looked_at_and_stays_masked"),
    Mutant("periods-half-open", "grazing/_arguments.py", 'ends = periods[0], periods[-1]', 'ends = periods[0], periods.stop',
           "test_outcomes.py::test_ranges_of_periods"),
    # Another answer.
    Mutant("cases-exchanged", "src/classify.rs", '(1, _) => 2,\n        (_, 1) => 4,', '(1, _) => 4,\n        (_, 1) => 2,',
           "test_theory.py::test_many_points_are_classified_as_one_by_one"),
    Mutant("witnesses-exchanged", "src/classify.rs", '(n, existence.name(), cases, large, positive, negative, zero, resonance)',
           '(n, existence.name(), cases, large, negative, positive, zero, resonance)',
           "test_theory.py::test_points_are_those_of_the_command_line"),
    Mutant("closed-intervals", PROOFS, 'return self.left < s < self.right', 'return self.left <= s <= self.right',
           "test_theory.py::test_intervals_by_modular_inverses_are_farey_neighbours"),
    Mutant("ends-exchanged", "src/batch.rs", 'const BEHIND_A_WALL: u8 = 4;', 'const BEHIND_A_WALL: u8 = 2;',
           "test_scenes.py::test_ends_of_motions_and_bad_arrays"),
    Mutant("not-settled-not-periodic", "src/arrays.rs", 'if one.undecided { -2 } else { 0 }', 'if one.undecided { 0 } else { 0 }',
           "test_scenes.py::test_what_is_not_settled_has_no_period"),
    Mutant("certificates-dropped", "src/arrays.rs",
           'let certificates = findings.certificates().into_iter();',
           'let certificates = findings.certificates().into_iter().take(0);',
           "test_scenes.py::test_proofs_beside_what_is_seen_come_with_certificates"),
    Mutant("ends-of-a-share-exchanged", "src/boxes.rs", '"lower": share.lower.to_string()', '"lower": share.upper.to_string()',
           BOXES + "test_shares_are_those_of_the_command_line"),
    Mutant("open-share-proved", "grazing/_boxes.py", 'row.what != "word" and row.verdict == "open"',
           'row.what == "word" and row.verdict == "open"', BOXES + "test_a_share_with_an_open_verdict_is_undecided"),
    Mutant("share-rounded-inwards", "grazing/_boxes.py", 'return f"{-(-share * 10**4 // 1) / 100:.2f} %"',
           'return f"{share * 10**4 // 1 / 100:.2f} %"', BOXES + "test_the_table_of_shares_is_rounded_outwards"),
    Mutant("a-depth-for-all", "src/machines.rs", 'Ok((depth != self.simulator.minimum_depth()).then(',
           'Ok((depth < 0.0).then(', MACHINES + "test_a_motion_has_the_depth_that_its_own_start_asks_for"),
    Mutant("velocities-per-radian", "src/machines.rs", '*to = u * rate', '*to = u',
           MACHINES + "test_each_motion_of_a_machine_is_that_of_its_task"),
    Mutant("transient-counted", "src/machines.rs", 'Ok((impacts - before, code(end)))', 'Ok((impacts, code(end)))',
           MACHINES + "test_each_motion_of_a_machine_is_that_of_its_task"),
    Mutant("one-machine-for-all", "src/machines.rs", 'Solved::new(plan, &plan.changes(motion))', 'Solved::new(plan, &plan.changes(0))',
           MACHINES + "test_a_machine_is_followed_over_a_parameter"),
    Mutant("behind-a-stop-in-motion", "src/machines.rs", 'return Ok((0, BEHIND_A_WALL));', 'return Ok((0, code(RunEnd::Reached)));',
           MACHINES + "test_a_start_behind_a_stop_has_no_motion"),
    Mutant("displacements-as-velocities", "grazing/_motions.py", 'return self._part(slice(self.coordinates, None))',
           'return self._part(slice(None, self.coordinates))', MACHINES + "test_each_motion_of_a_machine_is_that_of_its_task"),
    Mutant("fractions-rounded", "grazing/_frames.py", 'if floats and table[name].dtype == object:',
           'if table[name].dtype == object:', "test_package.py::test_frames_of_lists_keep_whole_numbers_and_fractions"),
    Mutant("ends-as-text", "grazing/_frames.py", '_EXACT = ("lower", "upper",', '_EXACT = ("lower",',
           SHOWN + "test_what_is_proved_over_a_range_is_drawn_part_by_part"),
    Mutant("grid-upside-down", SCENE, 'values = {name: (axes[::-1], array)', 'values = {name: (axes[::-1], array[::-1])',
           "test_package.py::test_grids_are_datasets"),
    # What is shown.
    Mutant("cells-upside-down", "grazing/_plots.py", 'axes.pcolormesh(x, y, cells,', 'axes.pcolormesh(x, y, cells[::-1],',
           SHOWN + "test_pixels_are_the_cells_of_basins_and_maps"),
    Mutant("legend-shifted", "grazing/_plots.py", 'for colour, words_ in zip(colours, words):',
           'for colour, words_ in zip(colours, words[1:] + words[:1]):',
           SHOWN + "test_pixels_are_the_cells_of_basins_and_maps"),
    Mutant("cases-mislabelled", "grazing/_plots.py", '("> 0" if sign > 0 else "< 0"', '("> 0" if sign < 0 else "< 0"',
           SHOWN + "test_squares_are_the_orbits_of_a_classification"),
    Mutant("arrows-turned", "grazing/_plots.py", 'axes.annotate("", at[j], at[i],', 'axes.annotate("", at[i], at[j],',
           SHOWN + "test_arrows_are_the_edges_of_a_graph"),
    Mutant("signs-reversed", "grazing/_html.py", '"+" if sign > 0 else', '"+" if sign < 0 else',
           SHOWN + "test_the_table_of_a_classification_has_its_rows"),
    Mutant("share-full-to-its-upper-end", "grazing/_plots.py", 'axes.barh(y, lower, 0.7, color=colour)',
           'axes.barh(y, upper, 0.7, color=colour)', SHOWN + "test_bars_of_shares_are_full_up_to_the_lower_bound"),
    Mutant("stable-unstable", "grazing/_plots.py", 'True: ("solid", "stable"), False: ("dashed", "unstable")',
           'False: ("solid", "stable"), True: ("dashed", "unstable")', SHOWN + "test_branches_are_solid_where_they_are_stable"),
    Mutant("flip-covered", "grazing/_plots.py", 'else part["from"]), _float(part.to)]', 'else lower), _float(part.to)]',
           SHOWN + "test_what_is_proved_over_a_range_is_drawn_part_by_part"),
    Mutant("other-coordinate", "grazing/_plots.py", 'part * found.coordinates + coordinate - 1]', 'part * found.coordinates]',
           SHOWN + "test_motions_of_a_machine_are_drawn_by_coordinate_and_over_a_parameter"),
    Mutant("rejected-shown-proved", "grazing/_outcomes.py", '_html.verdict(type(self).__name__,', '_html.verdict("Proved",',
           SHOWN + "test_an_outcome_says_its_kind_and_why"),
    Mutant("not-escaped", "grazing/_html.py", 'more = f": {escape(why)}"', 'more = f": {why}"',
           SHOWN + "test_an_outcome_says_its_kind_and_why"),
    # What does not come back, or never ends.
    Mutant("pickled-without-values", SCENE, '(self._scene.text, self._scene.name, tuple(self._scene.parameters)))\n\n    def __eq__',
           '(self._scene.text, self._scene.name, ()))\n\n    def __eq__',
           PROCESSES + "test_a_scene_is_pickled_with_its_values"),
    Mutant("errno-lost", "grazing/_errors.py", 'if isinstance(self, OSError):\n            parts', 'if False:\n            parts',
           PROCESSES + "test_errors_are_pickled_with_all_their_parts"),
    Mutant("equal-but-for-values", "src/scene.rs", 'self.inner == other.inner && self.text == other.text', 'self.text == other.text',
           PROCESSES + "test_scenes_are_equal_where_nothing_tells_them_apart"),
    Mutant("tolerance-points-exchanged", TOLERANCES, '_machine(side["with"]), _machine(side.without)',
           '_machine(side.without), _machine(side["with"])',
           "test_tolerances.py::test_shares_of_machines_are_bounds_of_those_counted_one_by_one"),
    Mutant("range-from-the-farther-touch", TOLERANCES, 'near = min(self.touches', 'near = max(self.touches',
           "test_tolerances.py::test_ranges_over_tolerances_are_typed_and_drawn"),
    Mutant("open-is-proved", TOLERANCES, 'if side.chaos == "open"', 'if side.chaos == "unknown"',
           "test_tolerances.py::test_what_is_open_or_not_told_is_no_proof"),
]


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
