"""Arrays of numbers: each is taken as the exact number that it is said to be, or refused."""

import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import grazing

BOUNDARY = grazing.Case.BOUNDARY


def test_arrays_broadcast_and_are_not_copied():
    r, s = np.array([0.9, 0.99])[:, None], np.linspace(0.05, 0.45, 7)
    found = grazing.classify_many(r=r, s=s, max_n=4, floats="binary")
    assert found.shape == (2, 7, 4)
    assert (found[1, 3] == grazing.classify_many(r=0.99, s=s[3], max_n=4, floats="binary")).all()
    assert grazing.classify_many(r=np.empty(0), s=np.empty(0), floats="binary").shape == (0, 15)
    # The binary fraction 0.2 is not 1/5; 0.25 is 1/4, where u_2 = 0.
    binary = grazing.classify_many(r=1, s=[0.25, 0.2], max_n=5, floats="binary")
    assert binary[0, 1] == BOUNDARY and binary[1, 4] != BOUNDARY
    with pytest.raises(grazing.InputError, match="point 1"):
        grazing.classify_many(r=1, s=[0.25, math.nan], floats="binary")
    with pytest.raises(grazing.InputError, match="point 0"):
        grazing.classify_many(a1=1, a2=-1.0, floats="binary")


def test_exact_numbers_in_arrays_are_not_rounded():
    # u_5 = 0 at s = 1/5, and not at the float beside it; likewise u_3 at a1 = 1/3, a2 = 1/9.
    for fifth in [Fraction(1, 5), Decimal("0.2"), "1/5"]:
        for s in [fifth, [fifth], np.array([fifth], dtype=object)]:
            assert grazing.classify_many(r=1, s=s, max_n=5).reshape(-1)[4] == BOUNDARY
    assert grazing.classify_many(r=1, s=[Fraction(1, 5), 0.2], max_n=5, floats="binary")[:, 4].tolist()[0] == BOUNDARY
    assert grazing.classify_many(r=1, s=[Fraction(1, 5), 0.2], max_n=5, floats="binary")[1, 4] != BOUNDARY
    assert grazing.classify_many(r=1, s=np.array(["1/5", "1/3"]), max_n=5)[0, 4] == BOUNDARY
    assert grazing.classify_many(a1=Fraction(1, 3), a2=[Fraction(1, 9)], max_n=3)[0, 2] == BOUNDARY
    # The line a1 = a2 + 1 at 2^60: a float does not hold a1 = 2^60 + 1.
    big = 2**60
    for a1 in [big + 1, [big + 1], [big + 1, 0.5], np.array([big + 1, big])]:
        found = grazing.classify_many(a1=a1, a2=big, max_n=2, floats="binary").reshape(-1, 2)
        assert found[0].tolist() == [BOUNDARY, BOUNDARY]
    rng = np.random.default_rng(5)
    bit = {(1, 1): 1, (1, -1): 2, (-1, 1): 4, (-1, -1): 8}
    points = [(Fraction(int(p), 97), Fraction(int(q), 89)) for p, q in rng.integers([-250, 1], [250, 130], (60, 2))]
    points += [(-1 - a2, a2) for _, a2 in points[:10]] + [(Fraction(-7, 6), Fraction(1, 6))]
    many = grazing.classify_many(a1=[p for p, _ in points], a2=[q for _, q in points], max_n=8)
    for (a1, a2), row in zip(points, many):
        wanted = [
            sum(bit[case] for case in e.cases) if e.verdict == "orbit" else 16 * ("boundary" in e.verdict)
            for e in grazing.classify(a1=a1, a2=a2, max_n=8)
        ]
        assert wanted == row.tolist()
        # The same by the word: the periods that may follow themselves.
        found = grazing.word(a1=a1, a2=a2, max_period=8)
        for word in found.words:
            for case in word.cases:
                loops = {n for n in case.loops if n <= 8}
                # Period 1 has an orbit in two cases.
                single = {n for n in range(1, 9) if row[n - 1] < 16 and row[n - 1] & bit[case.case]}
                assert loops == single, (a1, a2, case.case)
    for wrong in [1j, True, [True], np.array([True]), [object()], [[0.1], Fraction(1, 5)]]:
        with pytest.raises(TypeError):
            grazing.classify_many(r=1, s=wrong, max_n=3, floats="binary")
    with pytest.raises(grazing.InputError):
        grazing.classify_many(r=1, s=["x"], max_n=3)
    if np.dtype(np.longdouble).itemsize > 8:
        for wrong in [np.longdouble("0.2"), [np.longdouble("0.2")], np.array(["0.2"], dtype=np.longdouble)]:
            with pytest.raises(TypeError, match="longdouble|float128|float96|64 bits"):
                grazing.classify_many(r=1, s=wrong, max_n=3, floats="binary")
    with pytest.raises(grazing.InputError, match="point 1"):
        grazing.classify_many(r=1, s=[Fraction(1, 4), math.inf], floats="binary")
    with pytest.raises(grazing.InputError, match="point 1"):
        grazing.classify_many(r=1, s=[Fraction(1, 4), Fraction(3, 4)])


@pytest.mark.parametrize("value", [0.2, [0.2], np.array([0.2]), np.float32(0.2), [Fraction(1, 5), 0.2], np.float64(0.2)])
def test_a_float_is_refused_where_it_is_not_said_what_it_means(value):
    with pytest.raises(TypeError, match="must be exact"):
        grazing.classify_many(r=1, s=value, max_n=5)
    with pytest.raises(grazing.InputError, match='"binary" or "decimal"'):
        grazing.classify_many(r=1, s=value, max_n=5, floats="yes")


def test_a_float_means_what_it_is_said_to_mean():
    # As a binary fraction 0.2 is above 1/5, and 0.4 above 2/5; as decimals both are where u_5 = 0.
    beside = grazing.classify(r=1, s=Fraction(0.2), max_n=5)[4]
    assert beside.verdict == "orbit"
    for s in [[0.2, 0.4], np.array([0.2, 0.4]), [0.2, Fraction(2, 5)], [np.float64(0.2), "2/5"]]:
        binary = grazing.classify_many(r=1, s=s, max_n=5, floats="binary")[:, 4]
        decimal = grazing.classify_many(r=1, s=s, max_n=5, floats="decimal")[:, 4]
        assert binary[0] == 1 << [(1, 1), (1, -1), (-1, 1), (-1, -1)].index(beside.cases[0])
        assert decimal.tolist() == [BOUNDARY, BOUNDARY]
    tiny = [1e-300, 2.5e-10, 0.1 + 0.2]
    exact = grazing.classify_many(r=1, s=[Decimal(repr(x)) for x in tiny])
    assert (grazing.classify_many(r=1, s=tiny, floats="decimal") == exact).all()
    # A float32 has another shortest decimal than the float64 of the same value.
    assert grazing.classify_many(r=1, s=np.float32([0.25]), floats="binary")[0, 1] == BOUNDARY
    for s in [np.float32([0.2]), [np.float32(0.2), "1/5"]]:
        with pytest.raises(TypeError, match="float32"):
            grazing.classify_many(r=1, s=s, floats="decimal")


def test_two_arrays_of_integers_are_fractions():
    numerators, denominators = np.array([1, 2, -3, 7]), np.array([5, 10, -15, 19])
    fractions = grazing.Fractions(numerators, denominators)
    assert list(fractions) == [Fraction(1, 5), Fraction(1, 5), Fraction(1, 5), Fraction(7, 19)]
    assert fractions[3] == Fraction(7, 19) and list(fractions[2:]) == list(fractions)[2:] and len(fractions) == 4
    found = grazing.classify_many(r=1, s=fractions, max_n=12)
    assert (found[:3, 4] == BOUNDARY).all()
    assert (found == grazing.classify_many(r=1, s=list(fractions), max_n=12)).all()
    # Broadcast, with r along the other axis, and integers as they are.
    grid = grazing.classify_many(r=grazing.Fractions([[9], [10]], 10), s=fractions, max_n=12)
    assert grid.shape == (2, 4, 12) and (grid[1] == found).all()
    assert grid[0, 3].tolist() == grazing.classify_many(r="9/10", s="7/19", max_n=12).tolist()
    ints = grazing.classify_many(a1=np.array([-3, 0, 3]), a2=np.uint8(1), max_n=4)
    assert (ints == grazing.classify_many(a1=["-3", "0", "3"], a2="1", max_n=4)).all()
    # All of 64 bits, and none more.
    least, most = -(2**63), 2**63 - 1
    big = grazing.classify_many(a1=grazing.Fractions([least, most], most), a2=1, max_n=6)
    assert (big == grazing.classify_many(a1=[Fraction(least, most), 1], a2=1, max_n=6)).all()
    wide = np.array([2**63 + 1], np.uint64)
    assert (grazing.classify_many(a1=wide, a2=wide - np.uint64(1)) == grazing.classify_many(a1=2**63 + 1, a2=2**63)).all()
    with pytest.raises(grazing.InputError, match="2\\^63"):
        grazing.Fractions(wide)
    with pytest.raises(TypeError, match="float64"):
        grazing.Fractions([0.5])
    with pytest.raises(grazing.InputError, match="point 1: 1/0"):
        grazing.classify_many(r=1, s=grazing.Fractions([1, 1], [5, 0]))


def test_the_ends_of_intervals_are_boundaries():
    table = grazing.intervals("3..=12")
    for ends in (table.left, table.right):
        inside = [place for place, end in enumerate(ends) if 0 < end < Fraction(1, 2)]
        found = grazing.classify_many(r=1, s=grazing.Fractions(ends.numerators[inside], ends.denominators[inside]))
        n = table.columns["n"][inside]
        assert (found[np.arange(len(n)), n - 1] & (15 | grazing.Case.UNDECIDED) == 0).all()
    assert list(table.left) == [row.left for row in table] and table.right[7] == table[7].right


@pytest.mark.parametrize("kind", ["floats", "objects", "fractions", "integers"])
def test_what_is_masked_is_not_looked_at_and_stays_masked(kind):
    hidden = np.array([False, True, False])
    column, whole = {
        "floats": (np.ma.MaskedArray([0.25, np.nan, 0.2], hidden), [0.25, 0.3, 0.2]),
        "objects": (np.ma.MaskedArray(np.array(["1/4", None, "1/5"], dtype=object), hidden), ["1/4", "1/3", "1/5"]),
        "fractions": (grazing.Fractions(np.ma.MaskedArray([1, 7, 1], hidden), [4, 0, 5]), ["1/4", "1/3", "1/5"]),
        "integers": (np.ma.MaskedArray([0, 7, 1], hidden), [0, 0, 1]),
    }[kind]
    at = (lambda x: {"a1": x, "a2": 1}) if kind == "integers" else (lambda x: {"r": 1, "s": x})  # noqa: E731
    found = grazing.classify_many(**at(column), max_n=5, floats="binary")
    assert isinstance(found, np.ma.MaskedArray) and found.shape == (3, 5)
    assert (found.mask == hidden[:, None]).all()
    plain = grazing.classify_many(**at(whole), max_n=5, floats="binary")
    assert not isinstance(plain, np.ma.MaskedArray)
    assert (found.data[~hidden] == plain[~hidden]).all() and found.mask.sum() == 5
    # A mask of the other coordinate counts, too; errors name places as without masks.
    other = np.ma.MaskedArray([1, 1, 1], [True, False, False])
    both = grazing.classify_many(**{**at(column), ("a2" if kind == "integers" else "r"): other}, max_n=5, floats="binary")
    assert both.mask[:, 0].tolist() == [True, True, False]


def test_points_beyond_a_mask_are_named_by_their_place():
    with pytest.raises(grazing.InputError, match="point 2"):
        grazing.classify_many(r=1, s=np.ma.MaskedArray([0.3, 7.0, 0.9], [False, True, False]), floats="binary")
    alone = grazing.classify_many(r=np.ma.MaskedArray(9, True), s=["1/5", "1/3"], max_n=3)
    assert alone.mask.all() and alone.shape == (2, 3)


def test_fractions_of_flint_are_exact():
    flint = pytest.importorskip("flint")
    fifth = flint.fmpq(1, 5)
    assert grazing.classify(r=flint.fmpz(1), s=fifth, max_n=5)[4].verdict == "singular boundary"
    points = [flint.fmpq(p, 2**70 + 1) for p in (1, 2**68, 2**69)] + [fifth]
    found = grazing.classify_many(r=1, s=np.array(points, dtype=object), max_n=5)
    assert (found == grazing.classify_many(r=1, s=[Fraction(int(x.p), int(x.q)) for x in points], max_n=5)).all()
    assert found[3, 4] == BOUNDARY
    with pytest.raises(TypeError):
        grazing.classify_many(r=1, s=[flint.arb("0.2")])


def test_fractions_go_by_either_pair_of_names():
    class Named:
        def __init__(self, p, q):
            self.p, self.q = p, q

    class Methods(Named):
        """As of a package whose names are functions."""

        def numerator(self):
            return None

        denominator = numerator

    for kind in (Named, Methods):
        assert grazing.classify_many(r=1, s=[kind(2, 10), kind(1, 3)], max_n=5)[0, 4] == BOUNDARY
    with pytest.raises(ZeroDivisionError):
        grazing.classify(r=1, s=Named(1, 0))
