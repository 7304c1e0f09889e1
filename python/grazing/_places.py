"""What holds at points (a₁, a₂) or (r, s): single orbits, values, words."""

from __future__ import annotations

import enum
import json
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, overload

import numpy as np
import numpy.typing as npt

from . import _grazing
from ._arguments import Exact, natural, point
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


@dataclass(frozen=True)
class Existence:
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


def classify(
    *, a1: Exact | None = None, a2: Exact | None = None, r: Exact | None = None, s: Exact | None = None,
    max_n: int = 15,
) -> Classification:
    """Which single-impact orbits exist at one point, for the periods 1 to ``max_n`` (at most 100,000).

    The point: trace and determinant ``a1``, ``a2`` > 0 of the linear map over one forcing period, or modulus
    ``r`` > 0 and angle ``s`` (of a turn, 0 < s < 1/2) of its complex eigenvalues. Every sign is certain.
    """
    first, second, polar = point(a1, a2, r, s)
    region, reversed_, rows = _grazing.classify(first, second, polar, natural("max_n", max_n))
    found = tuple(
        Existence(n, verdict, tuple((e, g) for e, g, _ in cases), tuple(x for *_, x in cases), plus, minus, zero)
        for n, verdict, cases, plus, minus, zero in rows
    )
    return Classification(region, reversed_, found)


def classify_many(
    *,
    a1: npt.ArrayLike | None = None,
    a2: npt.ArrayLike | None = None,
    r: npt.ArrayLike | None = None,
    s: npt.ArrayLike | None = None,
    max_n: int = 15,
    progress: Progress = None,
) -> npt.NDArray[np.uint8]:
    """The same at many points, on all cores: an array of the bits of :class:`Case`.

    The arrays are broadcast against each other to one shape S; contiguous float64 arrays of that shape are read
    where they are. Each float is taken as the binary fraction that it is: a grid of floats has no other
    meaning, and it may miss a boundary that passes through the decimal (s = 0.2 lies beside 1/5). Nothing is
    rounded: fractions, decimals, integers of any size and exact text are taken as they are, alone or among
    floats.

    :return: uint8 of shape S + (max_n,); entry ``[..., n - 1]`` is 0 where no orbit of period n exists.
    :raises InputError: for a point outside the theory, named by its place in the flattened arrays.
    :raises TypeError: for what is no number, and for floats of more than 64 bits.
    """
    first, second, polar = point(a1, a2, r, s)
    last = natural("max_n", max_n)
    if not 1 <= last <= 100_000:  # The array would be made before the compiled part looks.
        raise InputError(f"max_n = {last}: a whole number from 1 to 100000")
    one, two = np.broadcast_arrays(_numbers(first), _numbers(second))
    found = np.zeros((one.size, last), np.uint8)
    with shown(progress) as bar:
        if one.dtype == two.dtype == np.float64:
            flat = (np.ascontiguousarray(one).reshape(-1), np.ascontiguousarray(two).reshape(-1))
            _grazing.classify_many(*flat, polar, found, bar)
        else:
            _grazing.classify_exactly(_exactly(one), _exactly(two), polar, found, bar)
    return found.reshape(one.shape + (last,))


def _numbers(values: npt.ArrayLike) -> npt.NDArray[Any]:
    """A float64 array of the same numbers, or an array of objects if floats do not hold them all."""
    # NumPy would make floats of a list of integers and floats.
    array = np.asarray(values) if hasattr(values, "__array__") else np.array(values, dtype=object)
    if array.dtype.kind == "f" and array.dtype.itemsize <= 8:
        return array.astype(np.float64, copy=False)
    if array.dtype.kind == "f":
        raise TypeError(f"an array of {array.dtype}: give float64, or exact numbers")
    if array.dtype.kind not in "iuUO":
        raise TypeError(f"an array of {array.dtype} holds no real numbers")
    held = array.astype(object)
    if all(_is_held(x) for x in held.flat):
        return held.astype(np.float64)
    return held


def _is_held(x: object) -> bool:
    """Whether this is a float of at most 64 bits, or an integer that one holds."""
    if isinstance(x, (bool, np.bool_)):
        return False
    if isinstance(x, (int, np.integer)):
        return abs(int(x)) <= 2**53
    return isinstance(x, float) or isinstance(x, np.floating) and x.itemsize <= 8


def _exactly(array: npt.NDArray[Any]) -> list[Exact]:
    """The numbers, floats as the fractions that they are."""
    def exact(place: int, x: Any) -> Exact:
        if isinstance(x, np.floating) and x.itemsize > 8:
            raise TypeError(f"point {place}: {x!r} has more than 64 bits: give an exact number")
        if not isinstance(x, (float, np.floating)):
            return x  # type: ignore[no-any-return]
        if not math.isfinite(x):
            raise InputError(f"point {place}: {x} is not finite")
        return Fraction(float(x))

    return [exact(place, x) for place, x in enumerate(array.flat)]


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


@dataclass(frozen=True)
class Word:
    """The periods that can occur between impacts for one sign of eµ, in path order."""

    sign_emu: int
    #: For each period U (c_n > 0) or D (c_n < 0).
    letters: str
    periods: tuple[int, ...]
    #: Their places m/n on the Stern–Brocot path to s.
    fractions: tuple[Fraction, ...] = field(repr=False)
    #: Why the word ends: ``"all"`` (every period occurs), ``"complete"``, ``"boundary"``, ``"singular"``,
    #: ``"undecided"``, ``"cut"`` (the limit on letters), ``"odd"`` (on a₁ = −(a₂ + 1): every odd period, and 2)
    #: or ``"line"`` (on a₁ = a₂ + 1: period 1, without a letter).
    end: str
    #: The first period on the path that does not occur, or is not decided.
    next: int | None
    #: For γ > 0 and for γ < 0.
    cases: tuple[WordCase, WordCase]


@dataclass(frozen=True)
class WordReport:
    """Both words at a point."""

    region: str
    reversed: bool
    #: For eµ > 0 and for eµ < 0.
    words: tuple[Word, Word]
    #: The certificate's text, if one was asked for and found.
    certificate: str | None = field(default=None, repr=False)
    #: Why there is none.
    no_certificate: str | None = None

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
        return Undecided(statement, budget="; ".join(why)) if why else Proved(statement)


def word(
    *, a1: Exact | None = None, a2: Exact | None = None, r: Exact | None = None, s: Exact | None = None,
    max_period: int = 12, letters: int = 200, certificate: str | None = None,
) -> WordReport:
    """Every impact pattern at one point (as for :func:`classify`): which periods occur between impacts, which
    may follow which, how many patterns there are, and their entropy.

    :param max_period: patterns are counted up to this period, at most 400.
    :param letters: the words end after this many letters, at most 2000.
    :param certificate: ``"signs"`` or ``"theorem"`` for a certificate in ``report.certificate``, which
        :func:`check` proves again; ``"theorem"`` lets it rest on the word theorem.
    """
    first, second, polar = point(a1, a2, r, s)
    text, written, why = _grazing.word(
        first, second, polar, natural("max_period", max_period), natural("letters", letters), certificate
    )
    report = json.loads(text)
    words = tuple(_word(side) for side in report["words"])
    return WordReport(report["region"], report["reversed"], (words[0], words[1]), written, why)


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
