"""Theorem 1 for a map of any dimension, and the search for counterexamples of Conjecture 1."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Union

from . import _grazing, _html
from ._arguments import Periods, as_periods, natural, toml_source
from ._errors import warn
from ._outcomes import Done, Outcome, Proved, Record, Refuted, Undecided
from ._progress import Progress, shown

# Maps of any dimension.

#: A number of a map: exact, or the two ends of a float interval that encloses it.
MapNumber = Union[Fraction, "tuple[float, float]"]


@dataclass(frozen=True)
class PatternReport:
    """What Theorem 1 says of one impact pattern."""

    #: The forcing periods from impact to impact.
    pattern: tuple[int, ...]
    primitive: bool
    #: For small eµ > 0: ``"orbit"``, ``"no orbit"`` or ``"open"``.
    plus: str
    #: For small eµ < 0.
    minus: str
    #: L of (36): the eigenvalue of largest modulus is L (eµ)^−m to leading order, m impacts.
    leading: MapNumber | None
    #: The sign of that eigenvalue, ``"+"`` or ``"-"``, if it is certain.
    sign_eigenvalue: str | None
    #: Why a side is open.
    reason: str | None
    #: The solution of (32): X_1, … and Y_1, ….
    X: tuple[tuple[MapNumber, ...], ...] | None = field(repr=False)
    Y: tuple[MapNumber, ...] | None = field(repr=False)

    @property
    def outcome(self) -> Outcome:
        """:class:`Proved` if both sides are decided, else :class:`Undecided`."""
        statement = f"on which sides of the grazing an orbit with pattern {self.pattern} exists"
        if "open" in (self.plus, self.minus):
            return Undecided(statement, budget=self.reason or "")
        return Proved(statement)


def _number(value: Any) -> Any:
    if value is None:
        return None
    return Fraction(value) if isinstance(value, str) else (float(value[0]), float(value[1]))


def existence(
    map: str | os.PathLike[str] | Mapping[str, Any], pattern: Sequence[int] | None = None, *, max_period: int = 6,
    existing: bool = False, exact: bool = False, progress: Progress = None,
) -> list[PatternReport]:
    """Theorem 1 for a local map of any dimension: which impact patterns give orbits.

    :param map: a TOML file of the format ``grazing-map 1`` (a path), its text, or a dict of its keys: ``A``,
        ``B``, ``C``, ``e`` with exact numbers, intervals as on the page docs/existence.md. Floats in a dict
        mean their shortest decimal, as in the file.
    :param pattern: the one pattern asked for, as ``[3, 4]``; else all of the periods 1 to ``max_period``,
        at most 400.
    :param existing: leave out patterns without an orbit on either side.
    :param exact: by fractions from the start.
    """
    text, name = toml_source(map, {"format": "grazing-map 1"})
    periods = None if pattern is None else [natural("a period", n) for n in pattern]
    with shown(progress) as bar:
        rows, notes = _grazing.existence(text, name, periods, natural("max_period", max_period), existing, exact, bar)
    for note in notes:
        warn(f"{name}: {note}")
    return [
        PatternReport(
            tuple(row["pattern"]), row["primitive"], row["plus"], row["minus"], _number(row["leading"]),
            row["sign_eigenvalue"], row["reason"],
            row["X"] and tuple(tuple(_number(x) for x in one) for one in row["X"]),
            row["Y"] and tuple(_number(y) for y in row["Y"]),
        )
        for row in json.loads(rows)
    ]


# Fuzzing.


@dataclass(frozen=True)
class FuzzReport:
    """What fuzzing came to."""

    #: :class:`Refuted` with the cases that disagree, :class:`Undecided`, or :class:`Done`: no proof.
    outcome: Outcome
    #: Cases decided both ways.
    decided: int
    #: How many were decided by what, and processor seconds: the tally of the command line.
    tally: Record = field(repr=False)

    def _repr_html_(self) -> str:
        rows = [(name, count) for name, count in self.tally.items() if not isinstance(count, (list, Record))]
        table = _html.table(f"{self.decided} cases decided", ("what", "count"), rows, len(rows))
        return self.outcome._repr_html_() + table


def fuzz(
    cases: int = 100_000, *, periods: Periods = "1..=64", seed: int = 1, definition_share: float = 0.01,
    progress: Progress = None,
) -> FuzzReport:
    """Look for counterexamples of Conjecture 1: definition and claim, decided apart, at random points.

    :param cases: at least this many: whole blocks are done.
    :param periods: up to 4096.
    :param seed: the same seed gives the same cases, whatever the number of cores.
    :param definition_share: the share of sweep points at which one period is also decided k by k.
    """
    first, last = as_periods(periods)
    with shown(progress) as bar:
        text = _grazing.fuzz(first, last, natural("cases", cases), natural("seed", seed), definition_share, bar)
    tally = json.loads(text)
    decided = sum(tally[name] for name in ("swept", "interval", "ball", "exact", "boundary"))
    statement = f"Conjecture 1 at {decided} random cases of period {first} to {last}"
    outcome: Outcome
    if tally["disagreements"] or tally["faults"]:
        outcome = Refuted(statement, witness="\n".join(tally["disagreements"] + tally["faults"]))
    elif tally["undecided"]:
        outcome = Undecided(statement, budget=f"{tally['undecided']} cases by balls of 16384 bits")
    else:
        outcome = Done(f"{statement}: no disagreement, which is no proof")
    return FuzzReport(outcome, decided, Record(tally))
