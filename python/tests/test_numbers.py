"""Numbers go in and out exactly, and what is not exact is refused."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import grazing


def test_every_exact_form_of_a_number_means_the_same():
    forms = [Fraction(3, 8), "3/8", "0.375", Decimal("0.375"), "1/2-2^-3"]
    found = [grazing.classify(r=Fraction(19, 20), s=s, max_n=8) for s in forms]
    assert all(one == found[0] for one in found)
    assert found[0].orbits() != ()
    ints = [1, np.int64(1), np.uint8(1), "1"]
    assert len({grazing.classify(a1=0, a2=one, max_n=5) for one in ints}) == 1


def test_fractions_of_any_size_pass_unrounded():
    tiny = Fraction(1, 2**1000)
    # 1/10 is an end of an interval of period 5 on r = 1; beside it, however near, an orbit exists.
    at = grazing.classify(r=1, s=Fraction(1, 10), max_n=5)[4]
    below = grazing.classify(r=1, s=Fraction(1, 10) - tiny, max_n=5)[4]
    above = grazing.classify(r=1, s=Fraction(1, 10) + tiny, max_n=5)[4]
    assert at.verdict == "singular boundary" and at.resonance is None
    report = grazing.word(r="9/10", s="1/6", max_period=7)
    assert report.resonances == ((3, "first"), (6, "higher")) and len(report.born_there) == 2
    assert report.born_there[0].startswith("n = 3, u_n = 0, first resonance: for gamma > 0 one orbit")
    assert isinstance(report.outcome, grazing.Undecided) and "u_n = 0: 3, 6" in report.outcome.budget
    wide = grazing.word(r="9/10", s=("16/100", "17/100"))
    assert wide.resonances == ((3, "first"),) and "s = 1/6 may be among them" in wide.born_there[0]
    assert grazing.word(r="9/10", s=("16/100", "165/1000")).resonances == ()
    damped = [grazing.classify(r="9/10", s=s, max_n=5)[4].resonance for s in ("1/10", "1/5", "1/7")]
    assert damped == ["first", "higher", None]
    assert below.cases == ((-1, 1),)
    assert above.cases == ((1, 1),)


@pytest.mark.parametrize("value", [0.2, np.float64(0.2), np.float32(0.25)])
def test_a_float_is_refused_with_both_ways_out(value):
    with pytest.raises(TypeError, match=r'write "0\.2.*" for the decimal, or Fraction\('):
        grazing.classify(r=1, s=value)


@pytest.mark.parametrize("value", [True, None, [1], 1j, float("nan"), object()])
def test_what_is_no_number_is_refused(value):
    with pytest.raises(TypeError):
        grazing.evaluate(5, a1=value, a2=1)


def test_edges_of_numbers():
    with pytest.raises(grazing.InputError, match="32768 bits"):
        grazing.classify(r=1, s=Fraction(1, 2**40000))
    with pytest.raises(grazing.InputError):
        grazing.classify(r=1, s="1/0")
    with pytest.raises((grazing.InputError, ValueError, OverflowError)):
        grazing.classify(r=1, s=Decimal("Infinity"))
    for huge in [Decimal("1e999999999"), Decimal("1e-999999999"), "1e999999999"]:
        with pytest.raises(grazing.InputError):
            grazing.classify(a1=huge, a2=1)
    for r, s in [(0, "1/5"), (-1, "1/5"), (1, 0), (1, "1/2"), (1, 2)]:
        with pytest.raises(grazing.InputError):
            grazing.classify(r=r, s=s)
    for max_n in [0, 100_001, -1]:
        with pytest.raises(grazing.InputError, match="max_n"):
            grazing.classify(r=1, s="1/5", max_n=max_n)
    # Of many points before an array is made for the answers.
    for max_n in [0, 100_001, 2**60, -1]:
        with pytest.raises(grazing.InputError, match="max_n"):
            grazing.classify_many(r=1, s=[0.2], max_n=max_n, floats="binary")


def test_a_point_is_given_by_one_pair():
    for given in [{}, {"a1": 1}, {"a1": 1, "s": 1}, {"a1": 1, "a2": 1, "r": 1, "s": "1/5"}]:
        with pytest.raises(TypeError, match="a1 and a2, or by r and s"):
            grazing.classify(**given)
