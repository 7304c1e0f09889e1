"""Certificates, Theorem 2, its intervals, and the edges of the areas below them."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, overload

import numpy as np
import numpy.typing as npt

from . import _grazing, _html, _plots
from ._arguments import Exact, Periods, as_periods, natural, whole_file
from ._arrays import Fractions
from ._frames import frame
from ._outcomes import Outcome, Pending, Proved, Record, Refuted, Rejected, Undecided, same
from ._progress import Progress, shown


def check(certificate: str | bytes | os.PathLike[str]) -> Outcome:
    """Prove a certificate again, without search, by the trusted checker.

    ``certificate`` is a path, or its text: a ``str`` with a line feed in it, or ``bytes``.

    :return: :class:`Proved` with ``details.kind``, ``.title`` (what is proved, in a word: the kind, or ``orbits``
        of a certificate of kind ``chaos`` that proves no chaos), ``.range`` (the periods; ``None`` of kind
        ``chaos``, whose letters are in ``.detail``), ``.detail``, ``.lines`` and ``.sha256``; :class:`Rejected`,
        its ``reason`` with the line, if it is malformed or a claim in it is false: then it proves nothing, and
        its statement may hold or not; :class:`Undecided` if it leaves something open.
    :raises FileError: if the file cannot be read.

    Cost: one reading. The interpreter's lock is released, and Ctrl-C is heard between the lines.
    """
    if isinstance(certificate, bytes):
        verdict = _grazing.check_text(certificate)
    elif isinstance(certificate, str) and "\n" in certificate:
        verdict = _grazing.check_text(certificate.encode())
    else:
        verdict = _grazing.check_file(os.fspath(certificate))
    word, proved, sha256, line, reason = verdict
    if proved is not None:
        kind, title, statement, ends, detail, lines = proved
        periods = None if ends is None else range(ends[0], ends[1] + 1)
        details = {"kind": kind, "title": title, "range": periods, "detail": dict(detail), "lines": lines}
        return Proved(statement, details=Record({**details, "sha256": sha256}))
    details = {"verdict": word, "line": line}
    if word == "undecided":
        return Undecided("the certificate's statement", budget=f"line {line}: {reason}", details=Record(details))
    return Rejected("the certificate's statement", reason=f"line {line}: {word}: {reason}", details=Record(details))


def verify(
    periods: Periods = "3..=500",
    *,
    method: str = "exact",
    certificate: str | os.PathLike[str] | None = None,
    progress: Progress = None,
) -> Outcome:
    """Prove Theorem 2 for every period in a range.

    :param periods: from 1 to 200,000.
    :param method: ``"exact"`` decides every sign by integers, ``"interval"`` by enclosures over whole
        stretches, ``"both"`` by both, which must agree.
    :param certificate: a file for a certificate, which :func:`check` proves again. It appears only if all is
        proved, and only when complete; if it cannot be made, that is said before the work.
    :return: :class:`Proved`, with the counts of intervals, stretches and points in ``details``;
        :class:`Refuted` with the n and the interval, or the n for which two methods disagree;
        :class:`Undecided` if enclosures leave periods open; :class:`Pending` if periods were not reached.

    Cost: O(n²) for each period n, on all cores.
    """
    first, last = as_periods(periods)
    with whole_file(certificate) as write:
        with shown(progress) as bar:
            verdict, witness, counts, text = _grazing.verify(first, last, method, certificate is not None, bar)
        if text is not None:
            write(text)
    statement = f"Theorem 2 for n = {first}..={last}"
    details = Record({"range": range(first, last + 1), "method": method, **counts})
    if verdict == "proved":
        return Proved(statement, details=details)
    if verdict == "refuted":
        return Refuted(statement, witness=witness or "", details=details)
    if verdict == "pending":
        return Pending(statement, left=f"{counts['pending']} periods", details=details)
    return Undecided(statement, budget=f"enclosures leave {counts['undecided']} periods open", details=details)


@dataclass(frozen=True)
class Interval:
    """An open interval of s on r = 1 where exactly one single-impact orbit of period n exists."""

    #: The period, the number of forcing periods from impact to impact.
    n: int
    #: The integer nearest to n s throughout the interval.
    m: int
    #: The case (sign eµ, sign γ), each −1 or 1.
    case: tuple[int, int]
    #: The left end, exactly.
    left: Fraction
    #: The right end, exactly.
    right: Fraction
    #: The k whose b_{n,k} alone decides existence for r < 1; ``None`` for m = 0.
    deciding: int | None

    def __contains__(self, s: Fraction | int) -> bool:
        return self.left < s < self.right


class Intervals(Sequence[Interval]):
    """A table of intervals: a sequence of :class:`Interval`, made from ``columns`` as they are asked for."""

    def __init__(self, columns: Mapping[str, npt.NDArray[np.int64]]) -> None:
        #: int64 arrays of equal length: ``n``, ``m``, ``sign_emu``, ``sign_gamma``, ``left_numerator``,
        #: ``left_denominator``, ``right_numerator``, ``right_denominator``, and ``deciding``, 0 where there is none.
        self.columns = dict(columns)

    def __len__(self) -> int:
        return len(self.columns["n"])

    @overload
    def __getitem__(self, index: int) -> Interval: ...
    @overload
    def __getitem__(self, index: slice) -> Intervals: ...
    def __getitem__(self, index: int | slice) -> Interval | Intervals:
        if isinstance(index, slice):
            return Intervals({name: column[index] for name, column in self.columns.items()})
        row = {name: int(column[index]) for name, column in self.columns.items()}
        return Interval(
            row["n"],
            row["m"],
            (row["sign_emu"], row["sign_gamma"]),
            Fraction(row["left_numerator"], row["left_denominator"]),
            Fraction(row["right_numerator"], row["right_denominator"]),
            row["deciding"] or None,
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Intervals):
            return NotImplemented
        return all(same(column, other.columns[name]) for name, column in self.columns.items())

    #: Arrays can be changed.
    __hash__ = None  # type: ignore[assignment]

    @property
    def left(self) -> Fractions:
        """The left ends, exactly, as an array for :func:`classify_many`."""
        return Fractions(self.columns["left_numerator"], self.columns["left_denominator"])

    @property
    def right(self) -> Fractions:
        """The right ends."""
        return Fractions(self.columns["right_numerator"], self.columns["right_denominator"])

    def __repr__(self) -> str:
        return f"<Intervals: {len(self)} rows>" if len(self) > 8 else f"Intervals({list(self)!r})"

    def to_frame(self) -> Any:
        """A pandas frame with the columns n, m, sign_emu, sign_gamma, left, right (Fractions), deciding."""
        whole = {name: self.columns[name] for name in ("n", "m", "sign_emu", "sign_gamma")}
        ends = {"left": [row.left for row in self], "right": [row.right for row in self]}
        table = frame({**whole, **ends, "deciding": [row.deciding for row in self]})
        return table.astype({"deciding": "Int64"})

    def plot(self, axes: Any = None) -> Any:
        """A bar for each interval on Matplotlib's ``axes`` or new ones, which are given back."""
        return _plots.intervals(self, axes)

    def _repr_html_(self) -> str:
        rows = ((row.n, row.m, _html.case(row.case), row.left, row.right, row.deciding) for row in self)
        return _html.table("intervals of s on r = 1", ("n", "m", "case (sign eµ, sign γ)", "left", "right", "deciding k"),
                           rows, len(self))


def intervals(periods: Periods, *, progress: Progress = None) -> Intervals:
    """Theorem 2's intervals of s: where on r = 1 single-impact orbits of period n exist.

    :param periods: from 1 to 10,000,000.

    Cost: O(n log n) and φ(n) + 1 rows for each period n; 72 bytes per row.
    """
    with shown(progress) as bar:
        found = Intervals(_grazing.intervals(*as_periods(periods), bar))
    return found


@dataclass(frozen=True)
class Edge:
    """The lower edge r = R(s) of an area of Conjecture 1: its lowest point, or its value at one s."""

    n: int
    m: int
    #: The case (sign eµ, sign γ) of the area.
    case: tuple[int, int]
    deciding: int | None
    #: ``"tip"``, ``"interval"`` or ``"region4"`` (the infimum is 0), ``"edge"``, or ``"not certified"``.
    kind: str
    #: Certain bounds of the s of the lowest point; or s itself, twice.
    s: tuple[Fraction, Fraction] | None
    #: Certain bounds of r.
    r: tuple[Fraction, Fraction] | None

    @property
    def a2(self) -> tuple[Fraction, Fraction] | None:
        """Certain bounds of a₂ = r², the determinant below which the orbit cannot exist."""
        return None if self.r is None else (self.r[0] ** 2, self.r[1] ** 2)

    @property
    def outcome(self) -> Outcome:
        """:class:`Proved`, or :class:`Undecided` if no bounds could be certified."""
        statement = f"bounds of the lower edge of an area of period {self.n} next to {self.m}/{self.n}"
        return Proved(statement) if self.r is not None else Undecided(statement, budget="the digits asked for")


def boundary(
    periods: Periods, *, m: int | None = None, at: Sequence[Exact] | None = None, digits: int = 12,
    progress: Progress = None,
) -> list[Edge]:
    """The lower edges of the areas of Conjecture 1: how much damping an orbit survives.

    :param periods: from 2 to 100,000.
    :param m: only the areas next to m/n.
    :param at: R(s) at these s, one row for each that lies inside an area's interval; without it the lowest
        point of each area.
    :param digits: the bounds are about 10^−digits apart, 1 to 1000.
    """
    m = None if m is None else natural("m", m)
    if isinstance(at, str):
        raise TypeError(f"at = {at!r}: a list of numbers")
    places = None if at is None else list(at)
    with shown(progress) as bar:
        rows = _grazing.boundary(*as_periods(periods), m, places, natural("digits", digits), bar)
    return [Edge(n, place, (emu, gamma), k, kind, s, r) for n, place, emu, gamma, k, kind, s, r in rows]
