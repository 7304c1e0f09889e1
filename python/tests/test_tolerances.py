"""What a task grazing tells of all machines within tolerances, as the command line tells it."""

import random
from fractions import Fraction

import pytest

import grazing

SCENE = """format = "grazing-scene 3"
title = "A driven mass and a stop"
[parameters]
F = 0.5
s = 0.3
d = 0.1
[system]
damping = "d"
stiffness = "s"
forcing = [{ cos = "F" }]
[[stops]]
side = "upper"
offset = 1
restitution = 0.8
[[tasks]]
name = "touch"
kind = "grazing"
parameter = "F"
seen = false
TOLERANCE
"""


def found(tolerance, text=SCENE):
    (report,) = grazing.Scene(text.replace("TOLERANCE", tolerance)).run()
    return report


def test_a_resonance_among_the_machines_is_told_with_machines_on_both_sides():
    text = SCENE.replace("s = 0.3", 's = "25/576"').replace("d = 0.1", "d = 0.25")
    (line,) = found('tolerance = { s = "1%" }', text).tolerance.resonances
    # s = 1/6 where the free motion turns by 2π/6 a period: k = c²/4 + 1/36.
    assert isinstance(line, grazing.ToleranceResonance) and line.period == 3
    assert line.below["s"] < Fraction(25, 576) < line.above["s"]
    assert line.lower <= Fraction(1, 2) <= line.upper and line.upper - line.lower < Fraction(1, 50)
    assert found('tolerance = { s = "1%" }').tolerance.resonances == ()


def test_shares_of_machines_are_bounds_of_those_counted_one_by_one():
    text = SCENE.replace("F = 0.5", "F = 0.4").replace("s = 0.3", "s = 1.5").replace("d = 0.1", "d = 0.05")
    report = found('tolerance = { s = [1.48, 1.54], d = [0.04, 0.06], F = "1%" }', text)
    told = report.tolerance
    assert isinstance(told, grazing.Tolerance) and isinstance(told.outcome, grazing.Proved)
    assert [told.parameters[name] for name in told.moves] == [
        (Fraction(148, 100), Fraction(154, 100)), (Fraction(4, 100), Fraction(6, 100))]
    assert told.moves == ("s", "d") and set(told.parameters) == {"F", "s", "d"} and told.ranges == ()
    before, beyond = told.before, told.beyond
    assert (before.side, before.sign_emu, beyond.side, beyond.sign_emu) == ("before", 1, "beyond", -1)
    assert (before.chaos, beyond.chaos, beyond.lower, beyond.upper) == ("differs", "everywhere", 1, 1)
    assert 0 < before.lower < before.upper < 1 and before.upper - before.lower < Fraction(1, 50)
    assert beyond.not_at is None and set(beyond.at) == {"s", "d"}
    # Machines by themselves: the two that are named, and some at random.
    draw = random.Random(1)
    points = [before.at, before.not_at]
    for _ in range(24):
        ends = [(name, told.parameters[name]) for name in told.moves]
        points.append({name: low + (high - low) * Fraction(draw.randrange(1000), 1000) for name, (low, high) in ends})
    born = []
    for point in points:
        scene = grazing.Scene(text.replace("TOLERANCE", "")).with_parameters(**point)
        born.append(next(row.chaos for row in scene.run()[0].findings.chaos if row.sign_emu == 1))
    assert born[:2] == [True, False]
    share = sum(born[2:]) / 24
    assert float(before.lower) - 0.3 < share < float(before.upper) + 0.3


def test_ranges_over_tolerances_are_typed_and_drawn():
    report = found('tolerance = { s = "1%", d = "1%" }\nrange = true')
    told = report.tolerance
    assert told.before.chaos == "everywhere" and told.before.lower == told.before.upper == 1
    assert told.sign_gamma in (1, -1)
    assert told.before.whole and told.before.periods == (1, 2, 3) and len(told.before.word) == 3
    assert told.ranges and {one.side for one in told.ranges} == {"before", "beyond"}
    drawn = [one for one in told.ranges if one.common]
    assert drawn
    for one in told.ranges:
        assert one.verdict in ("proved", "nothing born", "undecided")
        if one.common:
            low, high = one.common
            assert low < high and one.end in (low, high) and set(one.common) & set(one.touches)
            # Every machine touches on the other side of it, or at its beginning.
            assert all(touch <= low for touch in one.touches) or all(touch >= high for touch in one.touches)
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = report.plot()
    grey = [line for line in axes.lines if line.get_marker() == "|"]
    assert [sorted(line.get_xdata()) for line in grey] == [[float(end) for end in one.common] for one in drawn]
    touches = [line for line in axes.lines if line.get_linestyle() == ":"]
    assert [list(line.get_xdata()) for line in touches] == [[float(end) for end in one.touches] for one in drawn]
    assert [text.get_text() for text in axes.get_legend().get_texts()].count("touches of all machines") == 1


def test_what_is_open_or_not_told_is_no_proof():
    told = found('tolerance = { s = "20%", d = 0.05 }').tolerance
    assert isinstance(told.outcome, grazing.Undecided) and "open beyond the touch" in told.outcome.why()
    assert told.sign_gamma is None and told.beyond.chaos == "open" and told.beyond.lower == 0 < told.beyond.upper
    assert found("").tolerance is None
    # Another orbit touches than the motion without impacts.
    report = found('orbit = { pattern = [2] }\nset = { F = 1 }\ntolerance = { s = "1%" }')
    assert report.tolerance is None


def test_both_sides_are_a_table():
    told = found('tolerance = { s = "2%", d = 0.02 }').tolerance
    shown = told._repr_html_()
    assert "everywhere" in shown and "nowhere" in shown
    frame = pytest.importorskip("pandas") and told.to_frame()
    assert list(frame.side) == ["before", "beyond"] and list(frame.lower) == [1, 0]
