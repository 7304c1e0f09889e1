"""Outcomes are not bools, and say what they say."""

import errno
import os
import pickle
import re

import pytest

import grazing
from grazing import _grazing


@pytest.fixture
def certificate(tmp_path):
    path = tmp_path / "theorem2.txt"
    outcome = grazing.verify("3..=8", certificate=path)
    assert isinstance(outcome, grazing.Proved)
    return path


def test_no_outcome_is_a_bool(certificate):
    with pytest.raises(TypeError, match="Proved"):
        bool(grazing.check(certificate))
    for kind in [grazing.Refuted, grazing.Rejected, grazing.Undecided, grazing.Pending, grazing.Done, grazing.NothingFound]:
        with pytest.raises(TypeError, match=kind.__name__):
            if kind("something"):
                pass


def test_a_certificate_is_proved_again_as_file_text_and_bytes(certificate):
    import hashlib

    text = certificate.read_text()
    for source in [certificate, str(certificate), text, text.encode()]:
        outcome = grazing.check(source)
        assert isinstance(outcome, grazing.Proved)
        assert outcome.details.range == range(3, 9)
        assert outcome.details.kind == "theorem2"
        assert outcome.details.sha256 == hashlib.sha256(text.encode()).hexdigest()


def test_a_false_line_is_named(certificate):
    text = certificate.read_text()
    good = "orbit 1/16 1/8 + +"
    line = 1 + text[: text.index(good)].count("\n")
    outcome = grazing.check(text.replace(good, "orbit 1/16 1/8 + -"))
    assert isinstance(outcome, grazing.Rejected)
    assert outcome.reason.startswith(f"line {line}: false")
    # A damaged file says nothing about the theorem: it is not refuted.
    assert not isinstance(outcome, grazing.Refuted)
    # Cut anywhere it is malformed or false, and never proved.
    for at in range(0, len(text), 97):
        assert isinstance(grazing.check(text[:at].encode()), grazing.Rejected)


def test_chaos_has_letters_and_no_range(root):
    text = (root / "crates/checker/tests/data/chaos-123.txt").read_text()
    details = grazing.check(text).details
    assert (details.kind, details.title, details.range) == ("chaos", "chaos", None)
    assert "3: 3 periods, " in details.detail.letters
    # A version that was withdrawn says so, with what writes it anew.
    outcome = grazing.check(text.replace("kind chaos 3", "kind chaos"))
    assert isinstance(outcome, grazing.Rejected)
    assert "earlier version" in outcome.reason and "grazing run" in outcome.reason


def test_the_checker_notices_overflows():
    # A wheel whose checker wraps would return 0 here, and might prove what is false.
    with pytest.raises(grazing.InternalError, match="overflow"):
        _grazing.overflow()


def test_counts_are_those_of_the_intervals(certificate):
    outcome = grazing.verify(range(3, 41), method="both")
    assert isinstance(outcome, grazing.Proved)
    assert outcome.details.orbit_intervals == len(grazing.intervals(range(3, 41)))
    assert outcome.details.periods == 38


def test_nothing_half_written(tmp_path):
    told = []
    for path, number in [(tmp_path / "none" / "x.txt", errno.ENOENT), (tmp_path, errno.EISDIR)]:
        with pytest.raises(grazing.FileError) as raised:
            grazing.verify(5, certificate=path, progress=lambda *state: told.append(state))
        assert isinstance(raised.value, OSError) and raised.value.errno == number
    # It was said before the work.
    assert told == []

    def enough(*state):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        grazing.verify("3..=20000", certificate=tmp_path / "x.txt", progress=enough)
    assert list(tmp_path.iterdir()) == []


def test_an_error_of_a_file_is_one_line(tmp_path):
    path = tmp_path / "nowhere.txt"
    verify = lambda path: grazing.verify(5, certificate=path / "x")  # noqa: E731
    for work in [grazing.check, grazing.Scene, grazing.existence, verify]:
        with pytest.raises(grazing.FileError) as raised:
            work(path)
        error = raised.value
        assert re.match(rf"cannot (open|write) {re.escape(str(path))}(/x)?: No such file", str(error))
        assert error.errno == errno.ENOENT and error.strerror == os.strerror(errno.ENOENT)
        assert error.file == error.filename and error.file.startswith(str(path))


def test_outcomes_and_reports_can_be_pickled():
    outcome = grazing.verify("3..=5")
    again = pickle.loads(pickle.dumps(outcome))
    assert again == outcome and again.details.periods == 3
    word = grazing.word(r="0.4633", s="0.16327")
    assert pickle.loads(pickle.dumps(word)) == word


def test_ranges_of_periods():
    assert grazing.intervals("3..=5").columns["n"].tolist() == grazing.intervals(range(3, 6)).columns["n"].tolist()
    bad_ones = ["3-5", "", "-5", "3..=-5", range(5, 5), range(3, 9, 2), range(-3, 5), range(10**30), 0, -1, True]
    for bad in [*bad_ones, 10_000_001, 2**64]:
        with pytest.raises(grazing.InputError):
            grazing.intervals(bad)
    with pytest.raises(TypeError):
        grazing.intervals(3.0)
