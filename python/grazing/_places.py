"""What holds at points (a₁, a₂) or (r, s): single orbits, values, words."""

from __future__ import annotations

import enum
import json
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, NamedTuple, overload

import numpy as np
import numpy.typing as npt

from . import _grazing, _html, _plots
from ._arguments import Exact, natural, point
from ._arrays import Numbers, column, mask
from ._boxes import Ends, box, is_box
from ._errors import InputError
from ._frames import frame
from ._outcomes import Outcome, Proved, Undecided
from ._progress import Progress, shown

# Single orbits.


class Case(enum.IntFlag):
    """The bits of :func:`classify_many`: the cases (sign eµ, sign γ) with an orbit, or why it is not known."""

    PLUS_PLUS = 1
    PLUS_MINUS = 2
    MINUS_PLUS = 4
    MINUS_MINUS = 8
    #: On a boundary, where Theorem 1 is silent.
    BOUNDARY = 16
    #: The precision was not enough.
    UNDECIDED = 32


class Existence(NamedTuple):
    """What is known of the single-impact orbits of period ``n`` at a point."""

    n: int
    #: ``"orbit"``, ``"none"``, ``"singular boundary"`` (u_n = 0), ``"iterate boundary"`` (some b_{n,k} = 0),
    #: ``"sign boundary"`` (c_n = 0) or ``"undecided"``.
    verdict: str
    #: The cases (sign eµ, sign γ) with an orbit: one, or two for n = 1.
    cases: tuple[tuple[int, int], ...] = ()
    #: For each of them the sign of its large eigenvalue.
    large_eigenvalue: tuple[int, ...] = ()
    #: Two k with b_{n,k} of opposite sign, which forbid an orbit.
    positive_k: int | None = None
    negative_k: int | None = None
    #: A k with b_{n,k} = 0.
    zero_k: int | None = None
    #: On a singular boundary with r ≠ 1, where n theta = m pi: ``"first"`` (m = 1; for γ > 0 one orbit is born, its
    #: speed like √|µ|, for γ < 0 none) or ``"higher"`` (none is born).
    resonance: str | None = None


@dataclass(frozen=True)
class Classification(Sequence[Existence]):
    """Period 1, 2, … at a point: ``found[0]`` is period 1."""

    #: The region of the paper's figure 2, ``"1"`` to ``"5"``, or ``"line"``.
    region: str
    #: Whether a₂ > 1, so that the time-reversed system was classified, which has the same orbits.
    reversed: bool
    found: tuple[Existence, ...] = field(repr=False)

    def __len__(self) -> int:
        return len(self.found)

    @overload
    def __getitem__(self, index: int) -> Existence: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Existence, ...]: ...
    def __getitem__(self, index: int | slice) -> Existence | tuple[Existence, ...]:
        return self.found[index]

    @property
    def outcome(self) -> Outcome:
        """:class:`Proved` if every verdict is certain (that of a boundary is), else :class:`Undecided`."""
        statement = f"for each period 1 to {len(self)}: a single-impact orbit, none, or a boundary at the point"
        open_ = [row.n for row in self.found if row.verdict == "undecided"]
        if open_:
            return Undecided(statement, budget=f"balls of 16384 bits do not decide n = {open_}")
        return Proved(statement)

    def orbits(self) -> tuple[Existence, ...]:
        """The periods with an orbit."""
        return tuple(row for row in self.found if row.verdict == "orbit")

    def to_frame(self) -> Any:
        """A pandas frame, one row per period."""
        return frame(self.found)

    def plot(self, axes: Any = None) -> Any:
        """A picture of the periods with an orbit, by case, on Matplotlib's ``axes`` or new ones, which are given
        back."""
        return _plots.classification(self, axes)

    def __str__(self) -> str:
        """The region and the orbits, a line each, then the other verdicts."""
        turned = ", time reversed" if self.reversed else ""
        lines = [f"region {self.region}{turned}, periods 1 to {len(self)}"]
        lines += [f"  period {row.n}: an orbit, case {', '.join(map(_html.case, row.cases))}" for row in self.orbits()]
        for verdict in dict.fromkeys(row.verdict for row in self.found if row.verdict != "orbit"):
            periods = ", ".join(str(row.n) for row in self.found if row.verdict == verdict)
            lines.append(f"  {verdict}: {periods}")
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        head = ("n", "verdict", "cases (sign eµ, sign γ)", "because")
        rows = ((row.n, row.verdict, tuple(map(_html.case, row.cases)), _because(row)) for row in self)
        turned = ", time reversed" if self.reversed else ""
        return _html.table(f"region {self.region}{turned}", head, rows, len(self))


def _because(row: Existence) -> str:
    """What forbids an orbit, or what is 0."""
    if row.resonance is not None:
        return f"{row.resonance} resonance"
    if row.positive_k is not None:
        return f"b with k = {row.positive_k} > 0 > b with k = {row.negative_k}"
    return "" if row.zero_k is None else f"b with k = {row.zero_k} is 0"


def classify(
    *, a1: Exact | None = None, a2: Exact | None = None, r: Exact | None = None, s: Exact | None = None,
    max_n: int = 15,
) -> Classification:
    """Which single-impact orbits exist at one point, for the periods 1 to ``max_n`` (at most 100,000).

    The point: trace and determinant ``a1``, ``a2`` > 0 of the linear map over one forcing period, or modulus
    ``r`` > 0 and angle ``s`` (of a turn, 0 < s < 1/2) of its complex eigenvalues. Every sign is certain.

    Cost: some microseconds. Up to 64 periods at a point with numbers of up to 256 bits are decided at once, all
    else on a thread, where Ctrl-C is heard.
    """
    first, second, polar = point(a1, a2, r, s)
    region, reversed_, rows = _grazing.classify(first, second, polar, natural("max_n", max_n))
    return Classification(region, reversed_, tuple(map(Existence._make, rows)))


def classify_many(
    *,
    a1: Numbers | None = None,
    a2: Numbers | None = None,
    r: Numbers | None = None,
    s: Numbers | None = None,
    max_n: int = 15,
    floats: str | None = None,
    progress: Progress = None,
) -> npt.NDArray[np.uint8]:
    """The same at many points, on all cores: an array of the bits of :class:`Case`.

    The arrays are broadcast against each other to one shape S. Their numbers are exact: integers, Fractions,
    Decimals, text, fractions of other packages (``flint.fmpq``, ``sympy.Rational``), alone or as lists and
    arrays of any shape; or :class:`Fractions`, two arrays of integers. Nothing is rounded. Contiguous arrays of
    int64 and of float64 are read where they are.

    :param floats: what a float means; without it floats are refused. ``"binary"``: the binary fraction that it is,
        so that a grid may miss a boundary that passes through the decimal (s = 0.2 lies beside 1/5).
        ``"decimal"``: its shortest decimal, as in a scene: 0.2 is 1/5.
    :return: uint8 of shape S + (max_n,); entry ``[..., n - 1]`` is 0 where no orbit of period n exists. Masked
        arrays give a masked array: a point is not looked at where one of its numbers is masked.
    :raises InputError: for a point outside the theory, named by its place in the flattened arrays.
    :raises TypeError: for floats without ``floats``, for floats of more than 64 bits, and for what is no number.
    """
    first, second, polar = point(a1, a2, r, s)
    last = natural("max_n", max_n)
    if not 1 <= last <= 100_000:  # The array would be made before the compiled part looks.
        raise InputError(f"max_n = {last}: a whole number from 1 to 100000")
    one, two = column(first, floats), column(second, floats)
    shape = np.broadcast_shapes(one.shape, two.shape)
    hidden = mask(shape, one, two)
    found = np.zeros((math.prod(shape), last), np.uint8)
    with shown(progress) as bar:
        _grazing.classify_many(
            one.flat(shape, hidden), two.flat(shape, hidden), polar,
            None if hidden is None else hidden.reshape(-1), found, bar,
        )
    shaped = found.reshape(shape + (last,))
    if hidden is None:
        return shaped
    return np.ma.MaskedArray(shaped, np.repeat(hidden[..., None], last, axis=-1))


# Values.


@dataclass(frozen=True)
class Value:
    """b_{n,k} or c_n at a point."""

    n: int
    #: The index of b_{n,k}; ``None`` for c_n.
    k: int | None
    #: ``"+"``, ``"-"``, ``"0"``, ``"singular"`` (u_n = 0: not defined) or ``"undecided"``.
    sign: str
    #: What decided the sign: ``"f64 interval"``, ``"256 bits"``, ``"exact"``.
    decided_by: str
    #: Certain digits, off by less than one unit of the last; ``None`` where none are.
    digits: str | None


def evaluate(
    n: int,
    k: int | None = None,
    *,
    a1: Exact | None = None,
    a2: Exact | None = None,
    r: Exact | None = None,
    s: Exact | None = None,
    bits: int = 128,
) -> list[Value]:
    """b_{n,k} and c_n at a point (as for :func:`classify`, r ≤ 1): sign, what decided it, certain digits.

    Without ``k`` all b_{n,k} are listed, for n ≤ 100,000; c_n comes last. ``bits``: the precision of the
    digits, from 16 to 65536.
    """
    first, second, polar = point(a1, a2, 1 if r is None and s is not None else r, s)
    k = None if k is None else natural("k", k)
    rows = _grazing.evaluate(first, second, polar, natural("n", n), k, natural("bits", bits))
    return [Value(n, *row) for row in rows]


# Words.


@dataclass(frozen=True)
class WordCase:
    """The pattern graph of one case (sign eµ, sign γ). Impact patterns are its closed walks."""

    case: tuple[int, int]
    #: Pairs (i, j): a flight of j forcing periods may follow one of i.
    edges: tuple[tuple[int, int], ...] = field(repr=False)
    #: Pairs of which it is not known, or where Theorem 1 is silent.
    open: tuple[tuple[int, int], ...]
    #: Periods that may follow themselves: the single-impact orbits.
    loops: tuple[int, ...]
    #: The number of patterns of period 1, 2, …, up to rotation; of those that repeat no shorter one.
    patterns: tuple[int, ...] = field(repr=False)
    primitive: tuple[int, ...] = field(repr=False)
    #: The topological entropy per forcing period, enclosed exactly; ``None`` if no pattern exists.
    entropy: tuple[Fraction, Fraction] | None = field(repr=False)
    #: Whether counts and entropy are only lower bounds.
    lower_bound: bool

    @property
    def chaotic(self) -> bool:
        """Whether the entropy is certainly above 0. ``False`` with ``lower_bound`` leaves it open."""
        return self.entropy is not None and self.entropy[0] > 0

    def entropy_float(self) -> float | None:
        """The middle of the enclosure, rounded."""
        return None if self.entropy is None else float(sum(self.entropy) / 2)

    def plot(self, axes: Any = None) -> Any:
        """The graph: an arrow to each period that may follow, dashed where that is open."""
        return _plots.graph(self, axes)


@dataclass(frozen=True)
class Word:
    """The periods that can occur between impacts for one sign of eµ, in path order."""

    sign_emu: int
    #: For each period U (c_n > 0) or D (c_n < 0); in a box ? where c_n has not one sign.
    letters: str
    periods: tuple[int, ...]
    #: Their places m/n on the Stern–Brocot path to s.
    fractions: tuple[Fraction, ...] = field(repr=False)
    #: Why the word ends: ``"all"`` (every period occurs), ``"complete"``, ``"boundary"``, ``"singular"``,
    #: ``"undecided"``, ``"straddled"`` (points of a box may differ), ``"cut"`` (the limit on letters), ``"odd"`` (on a₁ = −(a₂ + 1): every odd period, and 2)
    #: or ``"line"`` (on a₁ = a₂ + 1: period 1, without a letter).
    end: str
    #: The first period on the path that does not occur, or is not decided.
    next: int | None
    #: For γ > 0 and for γ < 0.
    cases: tuple[WordCase, WordCase]


@dataclass(frozen=True)
class WordReport:
    """Both words at a point, or what the words of all points of a box have in common."""

    #: As of a classification; empty of a box that meets several, and of machines as measured.
    region: str
    reversed: bool
    #: For eµ > 0 and for eµ < 0.
    words: tuple[Word, Word]
    #: The certificate's text, if one was asked for and found.
    certificate: str | None = field(default=None, repr=False)
    #: Why there is none.
    no_certificate: str | None = None
    #: The periods n up to ``max_period`` with u_n = 0, of which the words are not, each with its resonance: ``"first"``,
    #: ``"higher"``, or ``None`` for a₂ = 1. Of a box the n whose s = 1/(2n) may be in it, where the word for eµ < 0 ends.
    resonances: tuple[tuple[int, str | None], ...] = ()
    #: What is born there, in words.
    born_there: tuple[str, ...] = field(default=(), repr=False)

    def case(self, sign_emu: int, sign_gamma: int) -> WordCase:
        """One of the four cases."""
        word = self.words[0 if sign_emu > 0 else 1]
        return word.cases[0 if sign_gamma > 0 else 1]

    @property
    def outcome(self) -> Outcome:
        """:class:`Proved` if words and graphs are whole, else :class:`Undecided`."""
        statement = "every impact pattern at the point, for all periods"
        why = [f"the word for eµ {'>' if w.sign_emu > 0 else '<'} 0: {w.end}" for w in self.words
               if w.end not in ("all", "complete")]
        why += [f"edges of case {c.case}" for w in self.words for c in w.cases if c.open]
        if self.resonances:
            why.append(f"patterns with a period n of which u_n = 0: {', '.join(str(n) for n, _ in self.resonances)}")
        return Undecided(statement, budget="; ".join(why)) if why else Proved(statement)

    def to_frame(self) -> Any:
        """A pandas frame, one row per case: its word, the single orbits, and the bounds of the entropy."""
        return frame([
            {"sign_emu": case.case[0], "sign_gamma": case.case[1], "letters": word.letters, "ends": word.end,
             "next": word.next, "loops": case.loops, "edges": len(case.edges), "open": len(case.open),
             "entropy_lower": case.entropy and case.entropy[0], "entropy_upper": case.entropy and case.entropy[1],
             "lower_bound": case.lower_bound}
            for word in self.words for case in word.cases
        ])

    def plot(self, axes: Any = None) -> Any:
        """The periods of both words at their places m/n."""
        return _plots.word(self, axes)

    def _repr_html_(self) -> str:
        head = ("case (sign eµ, sign γ)", "letters", "ends", "single orbits", "entropy", "chaotic")
        rows = (
            (_html.case(case.case), word.letters, word.end, case.loops, _rate(case), "yes" if case.chaotic else
             "not shown" if case.lower_bound else "no")
            for word in self.words for case in word.cases
        )
        turned = ", time reversed" if self.reversed else ""
        return _html.table(f"region {self.region}{turned}", head, rows, 4)


def _rate(case: WordCase) -> str | None:
    rate = case.entropy_float()
    return None if rate is None else f"{'≥ ' if case.lower_bound else ''}{rate:.6g}"


def word(
    *, a1: Ends | None = None, a2: Ends | None = None, r: Ends | None = None, s: Ends | None = None,
    ratio: Ends | None = None, damping_ratio: Ends | None = None,
    max_period: int = 12, letters: int = 200, certificate: str | None = None,
) -> WordReport:
    """Every impact pattern at one point (as for :func:`classify`): which periods occur between impacts, which
    may follow which, how many patterns there are, and their entropy. Where a coordinate is a pair of numbers, or for
    a machine as measured, by ``ratio`` and ``damping_ratio`` (see :func:`shares`), what is said holds for all points
    of the box, and the word ends where two of them may differ.

    :param max_period: patterns are counted up to this period, at most 400.
    :param letters: the words end after this many letters, at most 2000.
    :param certificate: ``"signs"`` or ``"theorem"`` for a certificate in ``report.certificate``, which
        :func:`check` proves again; ``"theorem"`` lets it rest on the word theorem.
    """
    limits = natural("max_period", max_period), natural("letters", letters), certificate
    if is_box(a1, a2, r, s) or ratio is not None or damping_ratio is not None:
        given = {"a1": a1, "a2": a2, "r": r, "s": s, "ratio": ratio, "damping_ratio": damping_ratio}
        text, written, why = _grazing.word_in_box(*box(given), *limits)
    else:
        text, written, why = _grazing.word(*point(a1, a2, r, s), *limits)
    report = json.loads(text)
    words = tuple(_word(side) for side in report["words"])
    resonances = tuple((n, kind) for n, kind in report["resonances"])
    return WordReport(
        report["region"] or "", report["reversed"], (words[0], words[1]), written, why, resonances,
        tuple(report["born_there"]),
    )


def _word(side: dict[str, Any]) -> Word:
    periods = tuple(side["periods"])
    cases = tuple(_word_case(side["sign_emu"], case) for case in side["cases"])
    places = tuple(Fraction(m, n) for m, n in zip(side["numerators"], periods))
    return Word(
        side["sign_emu"], side["letters"], periods, places, side["end"], side["next"], (cases[0], cases[1])
    )


def _word_case(sign_emu: int, case: dict[str, Any]) -> WordCase:
    pairs = {name: tuple((i, j) for i, j in case[name]) for name in ("edges", "open")}
    rate = case["rate"]
    return WordCase(
        (sign_emu, case["sign_gamma"]),
        pairs["edges"],
        pairs["open"],
        tuple(case["loops"]),
        tuple(map(int, case["all"])),
        tuple(map(int, case["primitive"])),
        rate and (Fraction(rate[0]), Fraction(rate[1])),
        case["lower_bound"],
    )
