"""Boxes of parameters: what is said of one holds at its points, and is what the command line says."""

import json
import random
import subprocess
from fractions import Fraction
from html import unescape

import pytest

import grazing
from grazing import _grazing

#: The machine of docs/measured.md: 12.3 Hz ± 1 % driven at 10 Hz, damping ratio 0.02 ± 20 %.
MACHINE = {"ratio": (Fraction("1.2177"), "1.2423"), "damping_ratio": ("0.016", Fraction(3, 125))}
BOXES = [
    (MACHINE, ["--frequency", "12.3Hz±1%", "--damping-ratio", "0.02±20%", "--drive", "10Hz"]),
    ({"r": ("0.96", "0.98"), "s": ("1/5", "21/100")}, ["--r", "0.96..=0.98", "--s", "1/5..=21/100"]),
    ({"a1": ("3/10", "301/1000"), "a2": "1/2"}, ["--a1", "0.3..=0.301", "--a2", "1/2"]),
    ({"a1": ("1.2", "1.6"), "a2": ("0.4", "0.5")}, ["--a1", "1.2..=1.6", "--a2", "0.4..=0.5"]),
]


def said(program, *arguments):
    done = subprocess.run([program, "word", *arguments, "--format", "json"], capture_output=True, text=True)
    assert done.returncode in (0, 3), done.stderr
    return json.loads(done.stdout), done.returncode


@pytest.mark.parametrize("place, arguments", BOXES, ids=lambda x: " ".join(x) if isinstance(x, list) else "")
def test_shares_are_those_of_the_command_line(program, place, arguments):
    told, code = said(program, *arguments, "--shares", "--cells", "300")
    found = grazing.shares(**place, cells=300)
    assert (found.cells, found.cut) == (told["cells"], told["cut"])
    assert isinstance(found.outcome, grazing.Proved if code == 0 else grazing.Undecided)
    for what, keys in [("chaos", ["sign_gamma"]), ("period", ["n"]), ("word", ["letters"])]:
        rows = [row for row in found.rows if row.what == what]
        theirs = told[{"chaos": "chaos", "period": "periods", "word": "words"}[what]]
        assert len(rows) == len(theirs)
        for row, one in zip(rows, theirs):
            assert [row.sign_emu, row.verdict] == [one["sign_emu"], one["verdict"]]
            assert [getattr(row, key) for key in keys] == [one[key] for key in keys]
            if what == "word":
                assert list(row.periods) == one["periods"]
            # Theirs are rounded outwards to six places.
            low, high = (Fraction(end) for end in one["share"])
            assert 0 <= row.lower - low < Fraction(1, 10**6) and 0 <= high - row.upper < Fraction(1, 10**6)
            assert [row.at and list(map(str, row.at)), row.not_at and list(map(str, row.not_at))] == [one["with"], one["without"]]
    assert len({row.verdict for row in found.rows}) > 1 or place is BOXES[2][0]


@pytest.mark.parametrize("place, arguments", BOXES, ids=lambda x: " ".join(x) if isinstance(x, list) else "")
def test_words_of_boxes_are_those_of_the_command_line(program, place, arguments):
    told, code = said(program, *arguments)
    found = grazing.word(**place)
    assert isinstance(found.outcome, grazing.Proved if code == 0 else grazing.Undecided)
    for word, one in zip(found.words, told["words"]):
        assert (word.letters, list(word.periods), word.end) == (one["letters"], one["periods"], one["end"]["kind"])


def test_what_is_said_of_a_box_holds_at_its_points():
    draw = random.Random(4)
    ends = {"r": (Fraction(9, 10), Fraction(97, 100)), "s": (Fraction(3, 10), Fraction(33, 100))}
    of, shares = grazing.word(**ends), grazing.shares(**ends, cells=500)
    assert of.region == "3"
    inside = dict.fromkeys((row.what, row.sign_emu, row.n) for row in shares.rows if row.what == "period")
    for _ in range(60):
        point = {name: low + (high - low) * Fraction(draw.randrange(1, 10**6), 10**6) for name, (low, high) in ends.items()}
        here = grazing.word(**point)
        for word, whole in zip(here.words, of.words):
            # The word of the box begins each point's.
            if whole.end in ("complete", "straddled"):
                assert word.periods[: len(whole.periods)] == whole.periods
            for row in shares.of("period", word.sign_emu):
                assert row.verdict != "everywhere" or row.n in word.periods
            known = {n for _, sign, n in inside if sign == word.sign_emu}
            assert {n for n in word.periods if n <= 12} <= known
    for row in shares.rows:
        assert 0 <= row.lower <= row.upper <= 1
        for place, holds in ((row.at, True), (row.not_at, False)):
            if place is None or row.what != "period":
                continue
            here = grazing.word(r=place[0], s=place[1])
            assert (row.n in here.words[0 if row.sign_emu > 0 else 1].periods) is holds


def test_a_box_of_one_point_is_the_point():
    for place in [{"a1": "11/10", "a2": "1/2"}, {"r": "9/10", "s": "7/24"}]:
        ends = {name: (value, value) for name, value in place.items()}
        assert grazing.word(**ends).words == grazing.word(**place).words


def test_certificates_of_rectangles_are_proved_again():
    report = grazing.word(a1=("3/10", "301/1000"), a2="1/2", certificate="theorem")
    assert isinstance(grazing.check(report.certificate), grazing.Proved)
    with pytest.raises(grazing.InputError, match="certificate"):
        grazing.word(**MACHINE, certificate="theorem")


def test_a_share_with_an_open_verdict_is_undecided(monkeypatch):
    found = grazing.shares(**MACHINE, cells=100)
    assert isinstance(found.outcome, grazing.Proved)
    told = json.loads(_grazing.shares(("1.2177", "1.2423"), ("0.016", "0.024"), "machine", 100, 12, None))
    for row in told["rows"]:
        if row["what"] == "period":
            row["verdict"] = "open"
    monkeypatch.setattr(_grazing, "shares", lambda *arguments: json.dumps(told))
    outcome = grazing.shares(**MACHINE, cells=100).outcome
    assert isinstance(outcome, grazing.Undecided) and "period 1" in outcome.budget


def test_the_table_of_shares_is_rounded_outwards():
    low, high = Fraction(538123, 10**6), Fraction(538177, 10**6)
    row = grazing.Share("chaos", 1, -1, None, None, None, "differs", low, high, None, None)
    html = unescape(grazing.Shares((row,), -1, 7, True, low)._repr_html_())
    assert "<td>53.81 %</td><td>53.82 %</td>" in html and "<td>chaos</td><td></td><td>+</td><td>−</td><td>differs</td>" in html
    frame = pytest.importorskip("pandas") and grazing.shares(**MACHINE, cells=50).to_frame()
    assert list(frame.columns)[:3] == ["what", "sign_emu", "sign_gamma"]


def test_boxes_are_given_by_one_pair_of_parameters():
    for given in [{}, {"a1": (0, 1)}, {"a1": (0, 1), "s": "1/5"}, {**MACHINE, "r": 1}, {"damping_ratio": (0, 1)}]:
        with pytest.raises(TypeError, match="a1 and a2, r and s, ratio and damping_ratio"):
            grazing.shares(**given)
    with pytest.raises(TypeError, match="two ends"):
        grazing.shares(r=(1, 1, 1), s="1/5")
    with pytest.raises(TypeError, match="exact"):
        grazing.shares(r=(0.5, "0.6"), s="1/5")
    for bad in [{"r": ("0.9", "0.8"), "s": "1/5"}, {"r": ("0.9", "1.1"), "s": "1/5"}, {"a1": (0, 1), "a2": (0, 1)}]:
        with pytest.raises(grazing.InputError):
            grazing.shares(**bad)
    for bad in [{"cells": 0}, {"cells": 10**7}, {"max_period": 0}, {"max_period": 401}]:
        with pytest.raises(grazing.InputError):
            grazing.shares(**MACHINE, **bad)
