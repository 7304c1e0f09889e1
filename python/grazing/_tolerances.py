"""What a task ``grazing`` tells of all machines that the tolerances of its parameters allow."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from . import _html
from ._frames import frame
from ._outcomes import Outcome, Proved, Record, Undecided


@dataclass(frozen=True)
class ToleranceSide:
    """What is born on one side of the touch."""

    #: ``"before"`` the touch, where the gap of the motion without impacts is open, or ``"beyond"`` it.
    side: str
    sign_emu: int
    #: What the words of all machines begin with, and its periods: each can occur between impacts, for all of them.
    word: str
    periods: tuple[int, ...]
    #: Whether it is the whole word of each; if not, ``word_ends`` says why it ends there.
    whole: bool
    word_ends: str
    #: Of how many machines chaos is born: ``"everywhere"``, ``"nowhere"``, ``"differs"`` (of some, and not of others)
    #: or ``"open"``.
    chaos: str
    #: Certain bounds of the share of the box in which it is, every part counting by its size.
    lower: Fraction
    upper: Fraction
    #: A machine of which it certainly is born, and one of which it certainly is not.
    at: Mapping[str, Fraction] | None = field(repr=False, hash=False)
    not_at: Mapping[str, Fraction] | None = field(repr=False, hash=False)


@dataclass(frozen=True)
class ToleranceRange:
    """What is proved of all machines on from a touch, of each from its own; of a task with ``range = true``."""

    side: str
    #: ``"proved"``, ``"nothing born"`` or ``"undecided"``.
    verdict: str
    #: Of what: ``"all"`` that is certain to be born there, ``"part"`` of it, or ``"orbit"``, of one impact.
    of: str
    #: The periods of which these motions are made.
    periods: tuple[int, ...]
    #: Values of the parameter between which every machine touches.
    touches: tuple[Fraction, Fraction] | None
    #: The last value of the parameter, from the nearer one of ``touches`` on, that is proved for all machines; ``None``
    #: where they have no such value in common: then each has its own, to ``depth``.
    end: Fraction | None
    #: How far from the touch every machine is proved: ν there is at most this.
    depth: Fraction | None
    #: Why it goes no further, or why nothing is proved.
    reason: str | None = field(repr=False)

    @property
    def common(self) -> tuple[Fraction, Fraction] | None:
        """The values of the parameter, lower end first, for which it is proved of all machines; ``None`` if there is
        none."""
        if self.touches is None or self.end is None:
            return None
        end = self.end
        near = min(self.touches, key=lambda touch: abs(touch - end))
        return min(near, end), max(near, end)


@dataclass(frozen=True)
class ToleranceResonance:
    """A line s = 1/(2n), u_n = 0, that machines within the tolerances have or may have on both sides."""

    #: n.
    period: int
    #: Certain bounds of the share of the box in which s < 1/(2n).
    lower: Fraction
    upper: Fraction
    #: A machine below the line, and one above it.
    below: Mapping[str, Fraction] | None = field(repr=False, hash=False)
    above: Mapping[str, Fraction] | None = field(repr=False, hash=False)


@dataclass(frozen=True)
class Tolerance:
    """What is certain of all machines within tolerances. Everything in it is proved, in exact arithmetic and intervals;
    there are certificates of the ranges in ``report.certificates``."""

    #: The least and the greatest value of each parameter with a tolerance.
    parameters: Mapping[str, tuple[Fraction, Fraction]] = field(hash=False)
    #: Those that damping or stiffness depend on, and so what is born.
    moves: tuple[str, ...]
    #: The sign of γ that all machines have; ``None`` if there is not one, or that is not certain.
    sign_gamma: int | None
    before: ToleranceSide
    beyond: ToleranceSide
    #: The lines of resonance among the machines, of n from 2 to 60.
    resonances: tuple[ToleranceResonance, ...]
    #: Without ``range = true`` there are none.
    ranges: tuple[ToleranceRange, ...]
    #: How many cells the box was cut into, and whether more might tell more.
    cells: int
    cut: bool
    #: At least the share of the box on which both words are certain.
    settled: Fraction
    #: What is open on the largest cell on which something is, and where that is.
    open: str | None

    @property
    def outcome(self) -> Outcome:
        """:class:`Proved` if it is known for either side of which share chaos is born, else :class:`Undecided`."""
        statement = "of how many machines within the tolerances chaos is born"
        sides = [side.side for side in (self.before, self.beyond) if side.chaos == "open"]
        if not sides:
            return Proved(statement)
        return Undecided(statement, budget=f"open {' and '.join(sides)} the touch after {self.cells} cells")

    def to_frame(self) -> Any:
        """A pandas frame, one row per side of the touch."""
        return frame((self.before, self.beyond))

    def _repr_html_(self) -> str:
        rows = (
            (side.side, side.word + ("" if side.whole else " …"), side.periods, side.chaos, float(side.lower),
             float(side.upper))
            for side in (self.before, self.beyond)
        )
        head = ("touch", "word of all", "periods", "chaos", "at least", "at most")
        return _html.table(f"all machines within tolerances, from {self.cells} cells", head, rows, 2)


def tolerance(findings: Record) -> Tolerance | None:
    """That of a report's findings, if it has one."""
    told = findings.get("tolerance")
    if told is None:
        return None
    before, beyond = map(_side, told.sides)
    return Tolerance(
        parameters={one.name: (Fraction(one.lower), Fraction(one.upper)) for one in told.parameters},
        moves=tuple(one.name for one in told.parameters if one.moves),
        sign_gamma=told.sign_gamma,
        before=before,
        beyond=beyond,
        resonances=tuple(map(_resonance, told.resonances)),
        # What is proved at the scene's own value alone is no range.
        ranges=tuple(_range(row) for row in findings.get("range") or () if not row.get("own_value")),
        cells=told.cells,
        cut=told.cut,
        settled=Fraction(told.settled),
        open=told.open,
    )


def _machine(point: Any) -> dict[str, Fraction] | None:
    return None if point is None else {one.name: Fraction(one.value) for one in point}


def _side(side: Any) -> ToleranceSide:
    lower, upper = map(Fraction, side.share)
    return ToleranceSide(
        side.side, side.sign_emu, side.word, tuple(side.periods), side.whole, side.word_ends, side.chaos, lower, upper,
        _machine(side["with"]), _machine(side.without),
    )


def _resonance(one: Any) -> ToleranceResonance:
    lower, upper = map(Fraction, one.share)
    return ToleranceResonance(one.period, lower, upper, _machine(one.below), _machine(one.above))


def _exact(text: str | None) -> Fraction | None:
    return None if text is None else Fraction(text)


def _range(row: Any) -> ToleranceRange:
    touches = row.touches and (Fraction(row.touches[0]), Fraction(row.touches[1]))
    return ToleranceRange(
        row.side, row.verdict, row.of, tuple(row.periods), touches, _exact(row.end), _exact(row.depth), row.reason
    )
