"""The theory's functions, each against another route to the same numbers."""

import json
import math
import subprocess
from fractions import Fraction

import numpy as np
import pytest

import grazing


def phi(n):
    return sum(math.gcd(m, n) == 1 for m in range(1, n + 1))


def test_intervals_by_modular_inverses_are_farey_neighbours():
    table = grazing.intervals("2..=60")
    for n in range(3, 61):
        rows = [row for row in table if row.n == n]
        assert len(rows) == phi(n) + 1
        # Beside m/n stand its two Farey neighbours, each with determinant 1; m = 0 ends at 1/(2n).
        assert rows[0].left == 0 and rows[0].right == Fraction(1, 2 * n)
        for row in rows:
            if row.m:
                other = row.left if row.case == (1, 1) else row.right
                m_n = Fraction(row.m, n)
                if other.denominator < n:
                    assert abs(m_n.numerator * other.denominator - other.numerator * n) == 1
            middle = (row.left + row.right) / 2
            assert middle in row and row.left not in row
            assert row.case in grazing.classify(r=1, s=middle, max_n=n)[n - 1].cases
    assert table[3:5][1] == table[4]
    assert isinstance(table[0].left, Fraction)


def test_many_points_are_classified_as_one_by_one():
    rng = np.random.default_rng(1)
    a1, a2 = rng.uniform(-3, 3, 300), rng.uniform(0.05, 1.5, 300)
    many = grazing.classify_many(a1=a1, a2=a2, max_n=9, floats="binary")
    assert many.shape == (300, 9) and many.dtype == np.uint8
    bit = {(1, 1): 1, (1, -1): 2, (-1, 1): 4, (-1, -1): 8}
    for x, y, row in zip(a1, a2, many):
        one = grazing.classify(a1=Fraction(x), a2=Fraction(y), max_n=9)
        wanted = [
            sum(bit[case] for case in e.cases) if e.verdict == "orbit" else 16 * ("boundary" in e.verdict)
            for e in one
        ]
        assert wanted == row.tolist()
    assert len(np.unique(many)) > 4


def test_values_are_those_of_the_formulas():
    s = Fraction(1, 7)
    found = {value.k: value for value in grazing.evaluate(5, s=s)}
    # (B1): sign b = −sign(sin kπs · sin (n−k)πs · cos nπs); here also u, by (B1)'s own sines in floats.
    for k in range(1, 5):
        sine = math.sin(k * math.pi / 7) * math.sin((5 - k) * math.pi / 7) * math.cos(5 * math.pi / 7)
        assert found[k].sign == ("-" if sine > 0 else "+")
    assert [value.k for value in grazing.evaluate(5, 2, s=s)] == [2, None]
    assert grazing.evaluate(4, s="1/8")[-1].sign == "singular"
    many = grazing.evaluate(1_000_000, 7, s="3/8+2^-200", bits=512)
    assert len(many[0].digits) > 100
    for bad in [{"n": 0}, {"n": 5, "k": 5}, {"n": 5, "k": 0}, {"n": 5, "bits": 15}, {"n": 200_000}]:
        with pytest.raises(grazing.InputError):
            grazing.evaluate(**bad, s=s)


def test_word_and_classification_agree():
    report = grazing.word(r="0.4633", s="0.16327", certificate="theorem")
    assert isinstance(report.outcome, grazing.Proved)
    assert isinstance(grazing.check(report.certificate), grazing.Proved)
    for sign_emu in (1, -1):
        for sign_gamma in (1, -1):
            case = report.case(sign_emu, sign_gamma)
            single = [
                e.n
                for e in grazing.classify(r="0.4633", s="0.16327", max_n=30)
                if (sign_emu, sign_gamma) in e.cases
            ]
            assert sorted(case.loops) == single
            # Chaos is where two single-impact periods coexist; the counts are closed walks, by a second route.
            assert case.chaotic == (len(single) > 1)
            assert list(case.patterns[:8]) == [count_patterns(case.edges, n) for n in range(1, 9)]
            if case.chaotic:
                low, high = case.entropy
                assert 0 < high - low < Fraction(1, 10**12)
                assert abs(case.entropy_float() - math.log(1 / root(case))) < 1e-9


#: Regions 1 to 5, the lines between them, r = 1 and beside it, and a₂ > 1: as no float tells.
PLACES = [
    {"r": "1", "s": "1/5+2^-200"},
    {"r": "1", "s": "3/7"},
    {"r": "1-2^-60", "s": "2/9"},
    {"r": "9/10", "s": "1/4-10^-40"},
    {"r": "0.4633", "s": "0.16327"},
    {"a1": "2", "a2": "1/2"},
    {"a1": "7/5", "a2": "49/100"},
    {"a1": "-7/5", "a2": "49/100"},
    {"a1": "-3/2", "a2": "1/2"},
    {"a1": "-2", "a2": "1/2+2^-100"},
    {"a1": "-1/3", "a2": "9/8"},
]


@pytest.mark.parametrize("place", PLACES, ids=str)
def test_points_are_those_of_the_command_line(program, place):
    def said(command, *more):
        at = [f"--{name}={value}" for name, value in place.items()]
        done = subprocess.run([program, command, *at, *more, "--format", "json"], capture_output=True, text=True)
        # 3: something is undecided, which is an answer.
        assert done.returncode in (0, 3), done.stderr
        return json.loads(done.stdout)

    rows = []
    for found in grazing.classify(**place, max_n=8):
        own = {name: getattr(found, name) for name in ("n", "positive_k", "negative_k", "zero_k", "resonance")}
        cases = [(*case, large) for case, large in zip(found.cases, found.large_eigenvalue)] or [(None, None, None)]
        for emu, gamma, large in cases:
            signs = {"sign_emu": emu, "sign_gamma": gamma, "large_eigenvalue": large}
            rows.append({**own, "existence": found.verdict, **signs})
    assert rows == said("classify", "--max-n", "8")["rows"]
    report = grazing.word(**place)
    found = said("word")
    assert report.resonances == tuple((row["period"], row["resonance"]) for row in found["resonances"])
    for word in found["words"]:
        for case in word["cases"]:
            one = report.case(word["sign_emu"], case["sign_gamma"])
            assert {e for e in one.edges if max(e) <= 8} == {tuple(e) for e in case["edges"] if max(e) <= 8}
            assert {n for n in one.loops if n <= 8} == {n for n in case["loops"] if n <= 8}


def count_patterns(edges, period):
    """Closed walks of this period, up to rotation, one by one."""
    follows = {}
    for i, j in edges:
        follows.setdefault(i, []).append(j)
    found = set()

    def walk(path, left):
        if left == 0:
            if path[0] in follows.get(path[-1], []):
                found.add(min(tuple(path[k:] + path[:k]) for k in range(len(path))))
            return
        for j in follows.get(path[-1], []) if path else {i for edge in edges for i in edge}:
            if j <= left:
                walk([*path, j], left - j)

    walk([], period)
    return len(found)


def root(case):
    """The least z with det(I − M(z)) = 0, M_ij = z^j, by bisection of the spectral radius."""
    periods = sorted({i for edge in case.edges for i in edge})
    low, high = 0.0, 1.0
    for _ in range(60):
        z = (low + high) / 2
        matrix = np.array([[z**j if (i, j) in case.edges else 0.0 for j in periods] for i in periods])
        radius = max(abs(np.linalg.eigvals(matrix)))
        low, high = (z, high) if radius < 1 else (low, z)
    return low


def test_edges_of_areas_are_where_orbits_end():
    rows = grazing.boundary("3..=6", digits=10)
    assert len(rows) == len(grazing.intervals("3..=6"))
    tips = [row for row in rows if row.kind == "tip"]
    assert tips
    for row in tips:
        low, high = row.r
        assert 0 < high - low <= Fraction(1, 10**9)
        assert row.a2 == (low**2, high**2)
        s = sum(row.s) / 2
        # R(s) is near r there: just above there is the orbit, just below not.
        (edge,) = [one for one in grazing.boundary(row.n, m=row.m, at=[s], digits=10) if one.case == row.case]
        bottom, top = edge.r
        assert isinstance(edge.outcome, grazing.Proved)
        above = grazing.classify(r=top + Fraction(1, 10**6), s=s, max_n=row.n)[row.n - 1]
        below = grazing.classify(r=bottom - Fraction(1, 10**6), s=s, max_n=row.n)[row.n - 1]
        assert row.case in above.cases and row.case not in below.cases
    with pytest.raises(grazing.InputError, match="m = 2"):
        grazing.boundary(4, m=2)
    with pytest.raises(TypeError, match="a list"):
        grazing.boundary(4, at="1")


def test_maps_from_dict_text_and_file(root):
    path = root / "examples/maps/focus.toml"
    focus = {"A": [[0.9, 1], [Fraction(-3, 5), 0]], "B": [0, 1], "C": [1, 0], "e": 1}
    found = [grazing.existence(source, max_period=5) for source in (path, path.read_text(), focus)]
    assert found[0] == found[1] == found[2]
    # In two dimensions single impacts are those of (a₁, a₂); γ = CAB = 1 > 0.
    single = {row.pattern[0]: row for row in found[0] if len(row.pattern) == 1}
    for one in grazing.classify(a1="0.9", a2="0.6", max_n=5):
        assert (single[one.n].plus == "orbit") == ((1, 1) in one.cases)
        assert (single[one.n].minus == "orbit") == ((-1, 1) in one.cases)
    (row,) = grazing.existence(focus, [1, 2], exact=True)
    assert all(isinstance(y, Fraction) for y in row.Y)
    with pytest.raises(grazing.InputError) as raised:
        grazing.existence({**focus, "B": [0, "x"]})
    assert raised.value.line and raised.value.file == "<dict>"


def test_fuzzing_is_the_same_for_a_seed():
    one, two = (grazing.fuzz(5000, periods="1..=12", seed=3) for _ in range(2))
    assert isinstance(one.outcome, grazing.Done)
    assert one.decided >= 5000
    counts = [{k: v for k, v in r.tally.items() if "seconds" not in k} for r in (one, two)]
    assert counts[0] == counts[1]
    for bad in [{"cases": 0}, {"periods": "1..=5000"}, {"definition_share": 2.0}, {"periods": "1..=2"}]:
        with pytest.raises(grazing.InputError):
            grazing.fuzz(**bad)


def test_a_classification_is_printed_by_its_orbits():
    lines = str(grazing.classify(r=1, s="1/4", max_n=6)).splitlines()
    assert lines == [
        "region 3, periods 1 to 6",
        "  period 1: an orbit, case (+, −), (−, +)",
        "  period 3: an orbit, case (+, +)",
        "  singular boundary: 2, 4, 6",
        "  iterate boundary: 5",
    ]
