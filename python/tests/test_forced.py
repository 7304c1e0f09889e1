"""Ends that never come, or seldom: forced, and seen as a user sees them.

`grazing._grazing.forced` makes up the library's finding (a refutation, two methods that disagree, a sign left
open), which then takes the way of every finding. What the compiled part tells as text is changed here.
"""

import json

import pytest
from conftest import MACHINE

import grazing
from grazing import _grazing


def forced(monkeypatch, what, name="verify"):
    """From now on the compiled function of this name comes to the made-up finding."""
    answer = _grazing.forced(what)
    monkeypatch.setattr(_grazing, name, lambda *arguments: answer)


# Theorem 2.


@pytest.mark.parametrize("what, kind, said", [
    ("refuted", grazing.Refuted, "decided n = 5: (0, 1/10) in case (-,+), claimed no further interval"),
    ("contradiction", grazing.Refuted, "the exact method and enclosures find different orbits for n = 5"),
    ("undecided", grazing.Undecided, "enclosures leave 1 periods open"),
    ("pending", grazing.Pending, "1 periods"),
])
def test_a_proof_that_fails_is_not_proved_and_writes_no_certificate(monkeypatch, tmp_path, what, kind, said):
    path = tmp_path / "theorem2.txt"
    assert isinstance(grazing.verify(5, certificate=path), grazing.Proved) and path.exists()
    path.unlink()
    forced(monkeypatch, what)
    outcome = grazing.verify(5, method="both", certificate=path)
    assert type(outcome) is kind
    assert said in repr(outcome) and "Proved" not in repr(outcome)
    assert list(tmp_path.iterdir()) == []
    assert outcome.details.undecided == (what == "undecided") and outcome.details.pending == (what == "pending")


# Certificates.


@pytest.mark.parametrize("what, kind, said", [
    ("malformed", grazing.Rejected, "line 7: malformed: as forced"),
    ("false", grazing.Rejected, "line 7: false: as forced"),
    ("open", grazing.Undecided, "line 7: as forced"),
])
def test_a_certificate_that_proves_nothing_is_not_proved(monkeypatch, tmp_path, what, kind, said):
    text = tmp_path / "certificate.txt"
    grazing.verify(5, certificate=text)
    for source, name in [(text, "check_file"), (text.read_text(), "check_text"), (text.read_bytes(), "check_text")]:
        assert type(grazing.check(source)) is grazing.Proved
        with monkeypatch.context() as patch:
            forced(patch, what, name)
            outcome = grazing.check(source)
        assert type(outcome) is kind
        assert said in repr(outcome) and outcome.details.line == 7
        # No hash, which would let it be cited.
        assert "sha256" not in outcome.details


def test_a_rejected_file_is_named_with_its_line(tmp_path):
    path = tmp_path / "theorem2.txt"
    grazing.verify("3..=6", certificate=path)
    lines = path.read_text().splitlines()
    place = next(i for i, line in enumerate(lines) if line.startswith("orbit"))
    lines[place] = lines[place][:-1] + {"+": "-", "-": "+"}[lines[place][-1]]
    path.write_text("\n".join(lines) + "\n")
    outcome = grazing.check(path)
    assert type(outcome) is grazing.Rejected and outcome.reason.startswith(f"line {place + 1}: false")
    path.write_text("")
    assert type(grazing.check(path)) is grazing.Rejected
    path.write_bytes(b"\xff\x00grazing")
    assert type(grazing.check(path)) is grazing.Rejected


# Points.


KINDS = ["none", "singular boundary", "iterate boundary", "sign boundary", "undecided"]


def test_a_period_that_is_left_open_is_none_without_an_orbit(monkeypatch):
    (region, turned, rows), bits = _grazing.forced("existence")
    assert list(bits) == [0, 16, 16, 16, 32]
    assert grazing.Case.UNDECIDED == 32 and grazing.Case.BOUNDARY == 16
    monkeypatch.setattr(_grazing, "classify", lambda *arguments: (region, turned, rows))
    found = grazing.classify(r=1, s="1/7", max_n=5)
    assert [row.verdict for row in found] == KINDS
    assert found.orbits() == () and all(row.cases == () for row in found)
    outcome = found.outcome
    assert type(outcome) is grazing.Undecided and "[5]" in outcome.budget
    assert type(grazing.Classification(region, turned, found[:4]).outcome) is grazing.Proved


#: The word at this point has 3 letters and is whole.
WHOLE = {"r": "0.4633", "s": "0.16327"}


@pytest.mark.parametrize("end", ["boundary", "singular", "undecided", "straddled", "cut", "odd", "line"])
def test_a_word_with_any_other_end_is_not_whole(monkeypatch, end):
    text, *rest = _grazing.word("0.4633", "0.16327", True, 12, 200, None)
    report = json.loads(text)
    assert type(grazing.word(**WHOLE).outcome) is grazing.Proved
    report["words"][1]["end"] = end
    monkeypatch.setattr(_grazing, "word", lambda *arguments: (json.dumps(report), *rest))
    outcome = grazing.word(**WHOLE).outcome
    assert type(outcome) is grazing.Undecided and f"eµ < 0: {end}" in outcome.budget


def test_a_word_with_an_open_edge_is_not_whole(monkeypatch):
    text, *rest = _grazing.word("0.4633", "0.16327", True, 12, 200, None)
    report = json.loads(text)
    report["words"][0]["cases"][1]["open"] = [[2, 3]]
    monkeypatch.setattr(_grazing, "word", lambda *arguments: (json.dumps(report), *rest))
    found = grazing.word(**WHOLE)
    assert type(found.outcome) is grazing.Undecided and "(1, -1)" in found.outcome.budget


def test_words_that_end_so_by_themselves():
    for place, end in [
        ({"r": 1, "s": "1/5"}, "singular"),
        ({"a1": 2, "a2": 1}, "line"),
        ({"a1": "-3/2", "a2": "1/2"}, "odd"),
    ]:
        found = grazing.word(**place)
        assert end in [word.end for word in found.words]
        assert type(found.outcome) is grazing.Undecided
    short = grazing.word(r="0.999", s="0.30901", letters=2)
    assert "cut" in [word.end for word in short.words] and type(short.outcome) is grazing.Undecided


@pytest.mark.parametrize("rate, chaotic", [(["0", "0"], False), (["0", "1/2"], False), (["1/4", "1/2"], True), (None, False)])
def test_chaos_is_what_has_an_entropy_that_is_certainly_above_0(monkeypatch, rate, chaotic):
    text, *rest = _grazing.word("0.4633", "0.16327", True, 12, 200, None)
    report = json.loads(text)
    report["words"][0]["cases"][0]["rate"] = rate
    monkeypatch.setattr(_grazing, "word", lambda *arguments: (json.dumps(report), *rest))
    assert grazing.word(**WHOLE).case(1, 1).chaotic is chaotic


def test_an_edge_without_bounds_is_undecided(monkeypatch):
    (edge, *_) = grazing.boundary(5, m=1)
    assert type(edge.outcome) is grazing.Proved
    monkeypatch.setattr(_grazing, "boundary", lambda *arguments: [(5, 1, 1, 1, 2, "not certified", None, None)])
    (edge,) = grazing.boundary(5, m=1)
    assert type(edge.outcome) is grazing.Undecided and edge.a2 is None and edge.kind == "not certified"


# Maps and fuzzing.


@pytest.mark.parametrize("plus, minus", [("open", "no orbit"), ("orbit", "open"), ("open", "open")])
def test_a_pattern_with_an_open_side_is_undecided(monkeypatch, plus, minus):
    focus = {"A": [["9/10", 1], ["-3/5", 0]], "B": [0, 1], "C": [1, 0], "e": 1}
    (row,) = grazing.existence(focus, [1, 2])
    assert type(row.outcome) is grazing.Proved
    text, notes = _grazing.existence(grazing._arguments.toml_source(focus, {"format": "grazing-map 1"})[0], "x", [1, 2],
                                     6, False, False, None)
    told = json.loads(text)
    told[0].update(plus=plus, minus=minus, reason="as forced")
    monkeypatch.setattr(_grazing, "existence", lambda *arguments: (json.dumps(told), ["a note"]))
    with pytest.warns(grazing.GrazingWarning, match="a note"):
        (row,) = grazing.existence(focus, [1, 2])
    assert type(row.outcome) is grazing.Undecided and row.outcome.budget == "as forced"


@pytest.mark.parametrize("change, kind, said", [
    ({"disagreements": ["n 5 s 1/7"]}, grazing.Refuted, "n 5 s 1/7"),
    ({"faults": ["two routes"]}, grazing.Refuted, "two routes"),
    ({"undecided": 3}, grazing.Undecided, "3 cases"),
    ({"undecided": 3, "disagreements": ["n 5 s 1/7"]}, grazing.Refuted, "n 5 s 1/7"),
    ({}, grazing.Done, "no proof"),
])
def test_a_campaign_says_what_it_met(monkeypatch, change, kind, said):
    tally = json.loads(_grazing.fuzz(1, 12, 2000, 1, 0.01, None))
    assert not (set(change) - set(tally))
    monkeypatch.setattr(_grazing, "fuzz", lambda *arguments: json.dumps({**tally, **change}))
    outcome = grazing.fuzz(2000, periods="1..=12").outcome
    assert type(outcome) is kind and said in repr(outcome)


# Tasks.


class Forced:
    """A scene whose tasks end as they are told to."""

    def __init__(self, scene, status, kind=None, failed=None):
        self.scene, self.status, self.kind, self.failed = scene, status, kind, failed

    def __getattr__(self, name):
        return getattr(self.scene, name)

    def run(self, *arguments):
        text, *middle, _ = self.scene.run(*arguments)
        report = json.loads(text)
        report.update(self.status, kind=self.kind or report["kind"])
        return (json.dumps(report), *middle, self.failed)


def ended(status, kind=None, failed=None):
    scene = grazing.Scene(MACHINE)
    scene._scene = Forced(scene._scene, status, kind, failed)
    return scene.run("after")


@pytest.mark.parametrize("status, kind", [
    ("nothing-found", grazing.NothingFound),
    ("refuted", grazing.Refuted),
    ("undecided", grazing.Undecided),
    ("interrupted", grazing.Pending),
    ("pending", grazing.Pending),
])
@pytest.mark.parametrize("task", ["simulate", "validate", "chaos"])
def test_a_task_ends_as_it_says(status, kind, task):
    run = ended({"status": status, "reason": "as forced"}, task)
    assert type(run[0].outcome) is kind and type(run.outcome) is kind
    assert "as forced" in repr(run[0].outcome) and kind.__name__ in repr(run)


@pytest.mark.parametrize("task", sorted(
    "simulate section basins orbit event grazing branch diagram map crisis rest validate chaos".split()))
def test_only_proofs_are_proved(task):
    outcome = ended({"status": "done"}, task)[0].outcome
    assert type(outcome) is (grazing.Proved if task in ("validate", "chaos") else grazing.Done)


def test_a_status_that_is_not_known_is_not_proved():
    assert type(ended({"status": "something new"}, "validate")[0].outcome) is grazing.Pending


@pytest.mark.parametrize("io, kind", [(True, grazing.FileError), (False, grazing.InputError)])
def test_a_task_that_fails_has_its_error(io, kind):
    run = ended({"status": "failed", "reason": "no room"}, failed=("no room", 12, io))
    error = run[0].outcome.error
    assert type(run[0].outcome) is grazing.Failed and type(error) is kind
    assert (str(error), error.line) == ("no room", 12)


def test_a_run_is_as_its_worst_task():
    report = grazing.Scene(MACHINE).run("after")[0]
    order = [grazing.Refuted("x"), grazing.Failed("x"), grazing.Pending("x"), grazing.Undecided("x"),
             grazing.NothingFound("x"), grazing.Done("x"), grazing.Proved("x")]
    reports = [grazing.TaskReport(**{**vars(report), "outcome": outcome}) for outcome in order]
    for place, outcome in enumerate(order):
        for run in (grazing.Run(reports[place:]), grazing.Run(reports[place:][::-1])):
            assert type(run.outcome) is type(outcome)
    assert type(grazing.Run([]).outcome) is grazing.Done
