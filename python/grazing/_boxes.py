"""Boxes of parameters: what holds at all of their points, and in which share of them it does."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Union

from . import _grazing, _html, _plots
from ._arguments import Exact, natural
from ._frames import frame
from ._outcomes import Outcome, Proved, Undecided
from ._progress import Progress, shown

#: A parameter of a box: one exact number, or its two ends, the lower one first.
Ends = Union[Exact, "tuple[Exact, Exact]"]

_KINDS = {"plane": ("a1", "a2"), "polar": ("r", "s"), "machine": ("ratio", "damping_ratio")}


def box(given: dict[str, Ends | None]) -> tuple[tuple[Exact, Exact], tuple[Exact, Exact], str]:
    """The ends of both parameters, and what they are."""
    names = tuple(name for name, value in given.items() if value is not None)
    for kind, known in _KINDS.items():
        if names == known:
            first, second = (_ends(name, given[name]) for name in known)
            return first, second, kind
    ways = ", ".join(" and ".join(known) for known in _KINDS.values())
    raise TypeError(f"give a box by one of {ways}; given: {', '.join(names) or 'nothing'}")


def is_box(*values: Any) -> bool:
    """Whether one of them has two ends."""
    return any(isinstance(value, (tuple, list)) for value in values)


def _ends(name: str, value: Any) -> tuple[Exact, Exact]:
    if not isinstance(value, (tuple, list)):
        return value, value
    if len(value) != 2:
        raise TypeError(f"{name} = {value!r}: a number, or its two ends")
    return value[0], value[1]


@dataclass(frozen=True)
class Share:
    """In which share of a box something holds."""

    #: ``"chaos"``: chaos is born; ``"period"``: flights of ``n`` periods occur; ``"word"``: the word is ``letters``.
    what: str
    sign_emu: int
    #: Of chaos: the sign of γ; of a machine's box its own, ``None`` where that is not the same everywhere.
    sign_gamma: int | None
    n: int | None
    letters: str | None
    #: The word's periods.
    periods: tuple[int, ...] | None
    #: ``"everywhere"``, ``"nowhere"``, ``"differs"`` (at some points, and not at others) or ``"open"``.
    verdict: str
    #: Certain bounds of the share, every part of the box counting by its size.
    lower: Fraction
    upper: Fraction
    #: A point where it certainly holds, and one where it certainly does not.
    at: tuple[Fraction, Fraction] | None = field(repr=False)
    not_at: tuple[Fraction, Fraction] | None = field(repr=False)


@dataclass(frozen=True)
class Shares:
    """What holds in which share of a box."""

    rows: tuple[Share, ...] = field(repr=False)
    #: The sign of γ, where it is a function of the parameters and the same at all points.
    sign_gamma: int | None
    #: How many cells were looked at, and whether more might tell more.
    cells: int
    cut: bool
    #: The share on which both words are certain.
    settled: Fraction

    @property
    def outcome(self) -> Outcome:
        """:class:`Proved` if no verdict on chaos and on periods is open, else :class:`Undecided`."""
        statement = "where in the box chaos is born and which periods occur"
        open_ = [row for row in self.rows if row.what != "word" and row.verdict == "open"]
        if not open_:
            return Proved(statement)
        first = open_[0]
        what = "chaos" if first.n is None else f"period {first.n}"
        return Undecided(statement, budget=f"{len(open_)} verdicts open after {self.cells} cells, the first of {what}")

    def of(self, what: str, sign_emu: int) -> tuple[Share, ...]:
        """The rows of one kind for one sign of eµ."""
        return tuple(row for row in self.rows if row.what == what and row.sign_emu == sign_emu)

    def to_frame(self) -> Any:
        """A pandas frame, one row per statement."""
        return frame(self.rows)

    def plot(self, axes: Any = None) -> Any:
        """A bar for each statement on Matplotlib's ``axes`` or new ones, which are given back: full up to where the
        share is certain, pale where it may end."""
        return _plots.shares(self, axes)

    def _repr_html_(self) -> str:
        rows = (
            (row.what, row.letters or row.n, "+" if row.sign_emu > 0 else "−",
             {1: "+", -1: "−", None: ""}[row.sign_gamma], row.verdict, _below(row.lower), _above(row.upper))
            for row in self.rows
        )
        head = ("what", "which", "eµ", "γ", "holds", "at least", "at most")
        return _html.table(f"shares of the box, from {self.cells} cells", head, rows, len(self.rows))


def _below(share: Fraction) -> str:
    """The share in percent, rounded down."""
    return f"{share * 10**4 // 1 / 100:.2f} %"


def _above(share: Fraction) -> str:
    """The same, rounded up."""
    return f"{-(-share * 10**4 // 1) / 100:.2f} %"


def shares(
    *, a1: Ends | None = None, a2: Ends | None = None, r: Ends | None = None, s: Ends | None = None,
    ratio: Ends | None = None, damping_ratio: Ends | None = None, cells: int = 2000, max_period: int = 12,
    progress: Progress = None,
) -> Shares:
    """In which share of a box chaos is born, each period and each word occurs: certain bounds.

    The box: ends of trace and determinant ``a1``, ``a2``, of modulus and angle ``r``, ``s``, or of a machine as
    measured, ``ratio`` (its undamped natural frequency over the drive's) and ``damping_ratio``. Each is a number
    or a pair of numbers, exact as everywhere.

    :param cells: how many cells of the box are looked at, at most 1,000,000: more give narrower bounds.
    :param max_period: the largest period that is listed, at most 400.
    """
    given = {"a1": a1, "a2": a2, "r": r, "s": s, "ratio": ratio, "damping_ratio": damping_ratio}
    first, second, kind = box(given)
    with shown(progress) as bar:
        text = _grazing.shares(first, second, kind, natural("cells", cells), natural("max_period", max_period), bar)
    told = json.loads(text)
    rows = tuple(_share(row) for row in told["rows"])
    return Shares(rows, told["sign_gamma"], told["cells"], told["cut"], Fraction(told["settled"]))


def _share(row: dict[str, Any]) -> Share:
    def point(name: str) -> tuple[Fraction, Fraction] | None:
        return row[name] and (Fraction(row[name][0]), Fraction(row[name][1]))

    periods = row.get("periods")
    return Share(
        row["what"], row["sign_emu"], row.get("sign_gamma"), row.get("n"), row.get("letters"),
        None if periods is None else tuple(periods), row["verdict"], Fraction(row["lower"]), Fraction(row["upper"]),
        point("with"), point("without"),
    )
