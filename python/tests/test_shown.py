"""What notebooks show: tables of HTML and pictures are read back, and say what the results say."""

import dataclasses
import sys
from fractions import Fraction
from html.parser import HTMLParser

import numpy as np
import pytest
from conftest import MACHINE

import grazing

COLOURS = {(1, 1): "#0072B2", (1, -1): "#D55E00", (-1, 1): "#009E73", (-1, -1): "#CC79A7"}
NAMES = {(1, 1): "eµ > 0, γ > 0", (1, -1): "eµ > 0, γ < 0", (-1, 1): "eµ < 0, γ > 0", (-1, -1): "eµ < 0, γ < 0"}


# HTML.


class Tables(HTMLParser):
    """The cells of tables, row by row, and all text."""

    def __init__(self, html):
        super().__init__()
        self.rows, self.text, self.cell, self.tags = [], "", None, []
        self.feed(html)
        assert not self.tags, self.tags

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.cell = ""

    def handle_endtag(self, tag):
        assert self.tags.pop() == tag
        if tag in ("td", "th"):
            self.rows[-1].append(self.cell)
            self.cell = None

    def handle_data(self, data):
        self.text += data
        if self.cell is not None:
            self.cell += data


def signs(case):
    return "(" + ", ".join({1: "+", -1: "−"}[sign] for sign in case) + ")"


def test_the_table_of_a_classification_has_its_rows():
    for place in [{"r": "0.95", "s": "3/8"}, {"r": 1, "s": "1/5"}, {"a1": "-1/3", "a2": "9/8"}]:
        found = grazing.classify(**place, max_n=12)
        shown = Tables(found._repr_html_())
        assert shown.text.startswith(f"region {found.region}{', time reversed' * found.reversed}")
        assert len(shown.rows) == 13
        for row, cells in zip(found, shown.rows[1:]):
            assert cells[:3] == [str(row.n), row.verdict, ", ".join(map(signs, row.cases))]
            if row.positive_k:
                assert cells[3] == f"b with k = {row.positive_k} > 0 > b with k = {row.negative_k}"
            elif row.resonance:
                assert cells[3] == f"{row.resonance} resonance"
            elif row.zero_k:
                assert cells[3] == f"b with k = {row.zero_k} is 0"
            else:
                assert cells[3] == ""


def test_long_tables_say_how_long_they_are():
    table = grazing.intervals("3..=30")
    shown = Tables(table._repr_html_())
    assert len(shown.rows) == 42 and shown.rows[-1] == [f"… {len(table)} rows in all"]
    for row, cells in zip(table, shown.rows[1:41]):
        assert cells == [str(row.n), str(row.m), signs(row.case), str(row.left), str(row.right), str(row.deciding or "")]
    assert len(Tables(grazing.intervals(5)._repr_html_()).rows) == 1 + len(grazing.intervals(5))


def test_the_table_of_words_has_its_cases():
    report = grazing.word(r="0.4633", s="0.16327")
    rows = Tables(report._repr_html_()).rows[1:]
    cases = [case for word in report.words for case in word.cases]
    assert [row[0] for row in rows] == [signs(case.case) for case in cases]
    for row, case in zip(rows, cases):
        assert row[3] == ", ".join(map(str, case.loops))
        assert row[5] == ("yes" if case.chaotic else "no")
        assert case.entropy is None or float(row[4]) == pytest.approx(case.entropy_float(), rel=1e-5)
    assert {row[5] for row in rows} == {"yes", "no"}


@pytest.mark.parametrize("outcome, said", [
    (grazing.Proved("x < y & z"), "Proved x < y & z"),
    (grazing.Refuted("x", witness="n = 5"), "Refuted x: n = 5"),
    (grazing.Rejected("x", reason="line <3>"), "Rejected x: line <3>"),
    (grazing.Undecided("x", budget="16 bits"), "Undecided x: 16 bits"),
    (grazing.Pending("x", left="3 periods"), "Pending x: 3 periods"),
    (grazing.NothingFound("x", reason="gone"), "NothingFound x: gone"),
    (grazing.Failed("x", error=grazing.InputError("<script>")), "Failed x: <script>"),
    (grazing.Done("x"), "Done x"),
])
def test_an_outcome_says_its_kind_and_why(outcome, said):
    html = outcome._repr_html_()
    assert Tables(html).text == said and "<script>" not in html
    assert f"<strong>{type(outcome).__name__}</strong>" in html


def test_a_run_lists_its_tasks_and_a_report_is_its_text():
    run = grazing.Scene(MACHINE).run()
    shown = Tables(run._repr_html_())
    assert shown.rows[1:] == [[r.task, r.kind, type(r.outcome).__name__, r.outcome.why()] for r in run]
    text = Tables(run[0]._repr_html_()).text
    assert text.startswith("Done ") and str(run[0]) in text


# Pictures.


@pytest.fixture
def pyplot():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    yield plt
    plt.close("all")


def hexadecimal(colour):
    from matplotlib.colors import to_hex

    return to_hex(colour).upper()


def legend(axes):
    """The colour of each entry of the legend that is shown."""
    handles, labels = axes.get_legend_handles_labels()
    assert [text.get_text() for text in axes.get_legend().get_texts()] == labels
    colours = {}
    for handle, label in zip(handles, labels):
        colour = handle.get_facecolor()[0] if hasattr(handle, "get_offsets") else \
            handle.patches[0].get_facecolor() if hasattr(handle, "patches") else handle.get_color()
        colours[label] = hexadecimal(colour)
    return colours


def test_squares_are_the_orbits_of_a_classification(pyplot):
    for place in [{"r": "0.95", "s": "3/8"}, {"r": 1, "s": "1/5"}, {"a1": 2, "a2": "1/2"}]:
        found = grazing.classify(**place, max_n=12)
        axes = found.plot()
        ticks = {tick.get_text(): y for tick, y in zip(axes.get_yticklabels(), axes.get_yticks())}
        shown = set()
        for points in axes.collections:
            label, at = points.get_label(), points.get_offsets().tolist()
            for case, name in NAMES.items():
                if label == name:
                    assert {y for _, y in at} == {ticks[name]}
                    assert hexadecimal(points.get_facecolor()[0]) == legend(axes)[name] == COLOURS[case]
                    shown |= {(int(n), case) for n, _ in at}
        assert shown == {(row.n, case) for row in found for case in row.cases}
        silent = [points for points in axes.collections if points.get_label().startswith("boundary")]
        wanted = {row.n for row in found if "boundary" in row.verdict}
        assert {int(n) for points in silent for n, _ in points.get_offsets()} == wanted
        low, high = axes.get_xlim()
        assert low < 1 and high > 12


def test_a_period_left_open_is_marked_in_every_row(pyplot):
    rows = (grazing.Existence(1, "orbit", ((1, 1), (-1, -1))), grazing.Existence(2, "undecided"))
    axes = grazing.Classification("3", False, rows).plot()
    open_, = [points for points in axes.collections if points.get_label() == "undecided"]
    assert open_.get_offsets().tolist() == [[2, y] for y in axes.get_yticks()]


def test_bars_are_the_intervals(pyplot):
    table = grazing.intervals("2..=9")
    axes = table.plot()
    shown = []
    for bars in axes.containers:
        case = {name: case for case, name in NAMES.items()}[bars.get_label()]
        for bar in bars:
            assert hexadecimal(bar.get_facecolor()) == legend(axes)[bars.get_label()] == COLOURS[case]
            shown.append((bar.get_y() + bar.get_height() / 2, case, bar.get_x(), bar.get_x() + bar.get_width()))
    wanted = [(row.n, row.case, float(row.left), float(row.right)) for row in table]
    for one, two in zip(sorted(shown), sorted(wanted)):
        assert one[1] == two[1] and one[0::2] == pytest.approx(two[0::2]) and one[3] == pytest.approx(two[3])
    assert len(shown) == len(wanted)


def test_arrows_are_the_edges_of_a_graph(pyplot):
    report = grazing.word(r="0.4633", s="0.16327")
    for sign_emu, sign_gamma in NAMES:
        case = report.case(sign_emu, sign_gamma)
        axes = case.plot()
        drawn = {item.get_gid() for item in (*axes.texts, *axes.collections)} - {None}
        assert drawn == {f"{i}-{j}" for i, j in case.edges}
        # Each from the one period's place to the other's.
        places = {text.get_text(): text.get_position() for text in axes.texts if text.get_text()}
        assert set(places) == {str(n) for edge in case.edges for n in edge}
        for arrow in axes.texts:
            if arrow.get_gid():
                i, j = arrow.get_gid().split("-")
                assert arrow.get_position() == places[i] and arrow.xy == places[j]
        assert NAMES[case.case] in axes.get_title()


def test_triangles_are_the_letters_of_the_words(pyplot):
    report = grazing.word(r="0.97", s="0.31")
    axes = report.plot()
    marks = {"^": "U", "v": "D"}
    for word, colour in zip(report.words, ("#0072B2", "#009E73")):
        shown = [
            (y, marks[line.get_marker()], x)
            for line in axes.lines if line.get_marker() in marks and hexadecimal(line.get_color()) == colour
            for x, y in zip(*line.get_data())
        ]
        wanted = list(zip(word.periods, word.letters, map(float, word.fractions)))
        assert sorted(shown) == sorted(wanted)
        assert f"eµ {'>' if word.sign_emu > 0 else '<'} 0, ends: {word.end}" in legend(axes)
    assert {letter for word in report.words for letter in word.letters} == {"U", "D"}


def pixel(axes, x, y):
    """The colour at a point of the axes' own coordinates."""
    axes.figure.canvas.draw()
    image = np.asarray(axes.figure.canvas.buffer_rgba())
    column, row = axes.transData.transform((x, y))
    return hexadecimal(image[image.shape[0] - 1 - int(row), int(column)] / 255)


def test_pixels_are_the_cells_of_basins_and_maps(pyplot, root):
    scene = grazing.Scene(root / "tests/data/kinds.toml")
    basins, map_ = scene.run(["basins", "map"])
    # Cells that no turn and no exchange leaves as they are.
    cells = np.array([[0, 0, 1], [1, 0, 0], [1, 1, 0]])
    basins = dataclasses.replace(basins, data=grazing.Record({**basins.data, "cells": cells}))
    map_ = dataclasses.replace(map_, data=grazing.Record({**map_.data, "period": np.array([[2, 0, 4], [-1, -2, 2]])}))
    axes = basins.plot()
    for j, u in enumerate(basins.data.u):
        for i, q in enumerate(basins.data.q):
            row = basins.findings.basins[basins.data.cells[j, i]]
            assert pixel(axes, q, u) == legend(axes)[f"period {row.period}" if row.period else row.end]
    axes = map_.plot()
    words = {0: "not periodic", -1: "ended", -2: "not settled"}
    for j, y in enumerate(map_.data.second):
        for i, x in enumerate(map_.data.first):
            period = int(map_.data.period[j, i])
            assert pixel(axes, x, y) == legend(axes)[words.get(period, f"period {period}")]


def test_pictures_of_tasks_are_their_arrays(pyplot, root):
    report = grazing.Scene(MACHINE).run("after")[0]
    axes = report.plot()
    curve, *marks = axes.lines
    assert (curve.get_ydata() == report.data.q).all() and (curve.get_xdata() == report.data.time).all()
    impacts = report.data.event_time[report.data.event_kind == 0]
    (shown,) = [line for line in marks if line.get_label() == "impact"]
    assert shown.get_xdata().tolist() == impacts.tolist() and "impact" in legend(axes)
    # Below the curve, along the axis of time.
    assert (shown.get_transform() == axes.get_xaxis_transform()) and set(shown.get_ydata()) == {0.02}
    assert axes.get_title() == "after: Done"
    for report in grazing.Scene(root / "tests/data/kinds.toml").run(["section", "diagram"]):
        axes = report.plot()
        drawn = sum(len(line.get_xdata()) for line in axes.lines)
        assert drawn == len(report.data.points)
    assert axes.lines[0].get_xdata().tolist() == report.data.value.tolist()
    # The main claims of a touch, on either side.
    assert len(grazing.Scene(MACHINE).run("first-touch")[0].plot().get_yticks()) == 2
    bare = {**MACHINE, "tasks": [{**MACHINE["tasks"][0], "range": False}]}
    with pytest.raises(grazing.InputError, match="simulate, section, diagram, basins, map, branch"):
        grazing.Scene(bare).run("first-touch")[0].plot()


def test_motions_are_drawn_on_the_axes_that_are_given(pyplot):
    motions = grazing.Scene(MACHINE).simulate([[0.0, 0.0], [0.5, 0.1]], 12)
    figure, axes = pyplot.subplots()
    assert motions.plot(axes) is axes
    shown = np.asarray(axes.collections[0].get_offsets())
    assert (shown == motions.points.reshape(-1, 2)).all()
    for thing in (grazing.intervals(5), grazing.classify(r=1, s="1/7"), grazing.word(r="0.97", s="0.31")):
        assert thing.plot(axes) is axes


def test_motions_of_a_machine_are_drawn_by_coordinate_and_over_a_parameter(pyplot, root):
    text = (root / "examples/machines/two-masses.toml").read_text()
    scene = grazing.Scene(text[: text.index("[[tasks]]")])
    motions = scene.simulate([0.0] * 4, 5, transient=9, parameters={"F0": [6.0, 12.0, 24.0]})
    for coordinate in (1, 2):
        axes = motions.plot(coordinate=coordinate)
        shown = np.asarray(axes.collections[0].get_offsets())
        assert (shown[:, 0] == motions.q[..., coordinate - 1].ravel()).all()
        assert (shown[:, 1] == motions.u[..., coordinate - 1].ravel()).all()
        assert (axes.get_xlabel(), axes.get_ylabel()) == (f"q{coordinate}", f"u{coordinate}")
    axes = motions.plot(coordinate=2, over="F0")
    shown = np.asarray(axes.collections[0].get_offsets())
    assert shown[:, 0].tolist() == np.repeat([6.0, 12.0, 24.0], 6).tolist()
    assert (shown[:, 1] == motions.q[..., 1].ravel()).all() and axes.get_xlabel() == "F0"
    with pytest.raises(grazing.InputError, match="from 1 to 2"):
        motions.plot(coordinate=3)
    with pytest.raises(grazing.InputError, match="that were varied are F0"):
        motions.plot(over="F")


def test_the_table_of_motions_counts_their_ends():
    motions = grazing.Scene(MACHINE).simulate([[0.0, 0.0], [2.0, 0.0], [0.5, 1.0]], 12)
    shown = Tables(motions._repr_html_())
    reached = motions.impacts[motions.ends == 0]
    assert shown.text.startswith("3 motions, 13 records")
    assert shown.rows[1:] == [["REACHED", "2", str(reached.min()), str(reached.max())], ["BEHIND_A_WALL", "1", "0", "0"]]
    assert reached.min() < reached.max()


def test_the_tables_of_a_scene_and_of_a_campaign():
    shown = Tables(grazing.Scene(MACHINE)._repr_html_())
    assert shown.text.startswith("a driven mass and a stop: F = 1/2")
    assert shown.rows[1:] == [["first-touch", "grazing", "", ""], ["after", "simulate", "motion", "F = 4/5"]]
    report = grazing.fuzz(2000, periods="1..=8")
    shown = Tables(report._repr_html_())
    assert shown.text.startswith("Done Conjecture 1") and ["swept", str(report.tally.swept)] in shown.rows


def test_bars_of_shares_are_full_up_to_the_lower_bound(pyplot):
    found = grazing.shares(r=("0.96", "0.98"), s=("1/5", "21/100"), cells=60)
    axes = found.plot()
    names = [tick.get_text() for tick in axes.get_yticklabels()]
    bars = [(bar.get_y() + bar.get_height() / 2, bar) for group in axes.containers for bar in group]
    for y, (row, name) in enumerate(zip(found.rows, names)):
        full, pale = (bar for place, bar in bars if place == y)
        assert (full.get_x(), full.get_width()) == (0, float(row.lower)) and full.get_alpha() is None
        assert pale.get_x() == float(row.lower) and pale.get_alpha() < 1
        assert pale.get_x() + pale.get_width() == pytest.approx(float(row.upper))
        assert name.startswith(f"eµ {'>' if row.sign_emu > 0 else '<'} 0") and name.endswith(row.verdict)
        assert f"{row.what} {row.letters or row.n}" in name or row.what == "chaos"
    assert len(names) == len(found.rows) and any(row.lower < row.upper for row in found.rows)
    # Of more rows than a picture holds it says so.
    long = dataclasses.replace(found, rows=found.rows * 20)
    assert long.plot().get_title().endswith(f"60 of {len(long.rows)} statements")


def test_branches_are_solid_where_they_are_stable(pyplot, root):
    report = grazing.Scene(root / "tests/data/kinds.toml").run("branch")[0]
    axes = report.plot()
    styles = {"-": True, "--": False, ":": "marginal"}
    shown = {}
    for line in axes.lines:
        if line.get_linestyle() in styles:
            # The last point of a run is the first one of the next.
            for place in list(zip(*line.get_data()))[:-1]:
                shown[place] = styles[line.get_linestyle()]
    wanted = {(row.parameters[0], row.speeds[0]): row.stable for row in report.rows}
    last = (report.rows[-1].parameters[0], report.rows[-1].speeds[0])
    assert {place: kind for place, kind in wanted.items() if place != last} == \
        {place: kind for place, kind in shown.items() if place != last}
    assert {True, False} <= set(wanted.values())
    marks = {text.get_text(): text.xy for text in axes.texts}
    assert marks == {row.label: (row.parameters[0], row.speeds[0]) for row in report.findings.labels}
    assert axes.get_xlabel() == "mu"


#: An orbit of the paper's oscillator, proved over a range through its flip.
RANGE = """[[tasks]]
name = "range"
kind = "validate"
set = { mu = 0.0054 }
orbit = { pattern = [3] }
parameter = "mu"
from = 0.0053
to = 0.0056
"""


def test_what_is_proved_over_a_range_is_drawn_part_by_part(pyplot, root):
    text = (root / "examples/scenes/nordmark-2001-branches.toml").read_text()
    (report,) = grazing.Scene(text[: text.index("[[tasks]]")] + RANGE).run()
    assert isinstance(report.outcome, grazing.Proved)
    (row,), axes = report.findings.proofs, report.plot()
    whole, *parts = axes.lines
    assert whole.get_xdata().tolist() == [float(row.lower), float(row.upper)] == [0.0053, 0.0056]
    assert [(line.get_label(), line.get_linestyle(), *line.get_xdata()) for line in parts] == [
        ("unstable", "--", 0.0053, float(row.stability[0].to)), ("stable", "-", float(row.stability[1]["from"]), 0.0056)]
    assert [tick.get_text() for tick in axes.get_yticklabels()] == [row.pattern] and "range: Proved" in axes.get_title()
    # Between the parts, where it flips, nothing is claimed.
    assert parts[0].get_xdata()[1] < parts[1].get_xdata()[0]
    for text in report.certificates.values():
        checked = grazing.check(text)
        assert isinstance(checked, grazing.Proved) and checked.details.kind == "branch"
    # The ends are exact, and floats where asked for.
    frame = report.frame("proofs")
    assert [frame.lower[0], frame.upper[0]] == [Fraction(53, 10000), Fraction(56, 10000)]
    assert report.frame("proofs", floats=True).lower[0] == 0.0053


def test_without_matplotlib_a_picture_says_how_to_get_it(monkeypatch):
    for name in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(grazing.MissingPackageError, match="pip install 'grazing\\[figures\\]'"):
        grazing.intervals(5).plot()


def test_nothing_optional_is_imported_before_it_is_used():
    import subprocess

    code = "import grazing, sys; print([m for m in ('matplotlib', 'pandas', 'flint', 'IPython') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "[]"
