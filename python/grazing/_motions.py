"""Many motions at once, on a stroboscopic section."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _grazing, _html, _plots
from ._arguments import natural
from ._errors import InputError
from ._frames import dataset, frame
from ._outcomes import Record, same
from ._progress import Progress, shown


class End(enum.IntEnum):
    """How a motion of :meth:`Scene.simulate` ended."""

    #: It was followed to the end.
    REACHED = 0
    IMPACT_LIMIT = 1
    #: It left every bound.
    ESCAPED = 2
    #: Its force is not smooth there.
    NOT_SMOOTH = 3
    #: Its start is behind a stop, so that it has no motion.
    BEHIND_A_WALL = 4
    #: Its force is too steep there: it changes in less than the shortest step.
    TOO_STEEP = 5


@dataclass(frozen=True, eq=False)
class Motions:
    """Many motions on a stroboscopic section. Equal are those with the same arrays, to the bit."""

    #: The state of motion i at record j: float64 of shape (N, records, 2), (q, u); of a machine with c coordinates
    #: of shape (N, records, 2 c), all displacements, then all velocities. NaN where a motion did not come.
    points: npt.NDArray[np.float64] = field(repr=False)
    #: Impacts of each after the transient: uint64 of shape (N,).
    impacts: npt.NDArray[np.uint64] = field(repr=False)
    #: How each ended, as :class:`End`: uint8 of shape (N,).
    ends: npt.NDArray[np.uint8] = field(repr=False)
    #: The forcing periods of the records, counted from the start: int64 of shape (records,).
    periods: npt.NDArray[np.int64] = field(repr=False)
    #: The values of the parameters that were varied, by name: float64 of shape (N,).
    parameters: Record = field(default_factory=Record, repr=False)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Motions):
            return NotImplemented
        return all(same(getattr(self, name), getattr(other, name)) for name in self.__dataclass_fields__)

    #: Arrays can be changed.
    __hash__ = None  # type: ignore[assignment]

    @property
    def coordinates(self) -> int:
        """How many displacements a state has."""
        return int(self.points.shape[2]) // 2

    @property
    def q(self) -> npt.NDArray[np.float64]:
        """The displacements: of shape (N, records), of several coordinates (N, records, c). No copy."""
        return self._part(slice(None, self.coordinates))

    @property
    def u(self) -> npt.NDArray[np.float64]:
        """The velocities, as :attr:`q`."""
        return self._part(slice(self.coordinates, None))

    def _part(self, which: slice) -> npt.NDArray[np.float64]:
        return self.points[..., which.start or 0] if self.coordinates == 1 else self.points[..., which]

    def to_frame(self) -> Any:
        """A pandas frame, one row per motion and record: motion, period, the parameters that were varied, and the
        state, q and u or q1, …, u1, …."""
        count, records = self.points.shape[:2]
        one = {"motion": np.repeat(np.arange(count), records), "period": np.tile(self.periods, count)}
        varied = {name: np.repeat(values, records) for name, values in self.parameters.items()}
        names = [f"{part}{i}" for part in "qu" for i in self._numbers()]
        state = {name: self.points[..., at].reshape(-1) for at, name in enumerate(names)}
        return frame({**one, **varied, **state})

    def _numbers(self) -> list[str]:
        """What tells coordinates apart in a name: nothing where there is one."""
        return [""] if self.coordinates == 1 else [str(i + 1) for i in range(self.coordinates)]

    def to_xarray(self) -> Any:
        """An ``xarray.Dataset`` with ``q`` and ``u`` over motion and period (and coordinate, from 1), ``impacts`` and
        ``ends`` over motion; the parameters that were varied are coordinates of the motions."""
        axes = ("motion", "period") if self.coordinates == 1 else ("motion", "period", "coordinate")
        labels: dict[str, Any] = {"period": self.periods}
        if self.coordinates > 1:
            labels["coordinate"] = np.arange(1, self.coordinates + 1)
        labels.update({name: ("motion", values) for name, values in self.parameters.items()})
        states = {"q": (axes, self.q), "u": (axes, self.u)}
        return dataset({**states, "impacts": ("motion", self.impacts), "ends": ("motion", self.ends)}, labels)

    def plot(self, axes: Any = None, *, coordinate: int = 1, over: str | None = None) -> Any:
        """The records on Matplotlib's ``axes`` or new ones, which are given back: (q, u) of a coordinate, counted from
        1, or its q over a parameter that was varied."""
        return _plots.motions(self, axes, coordinate, over)

    def __repr__(self) -> str:
        ended = {End(code).name: int(count) for code, count in zip(*np.unique(self.ends, return_counts=True))}
        return f"<Motions: {len(self.ends)} motions, {len(self.periods)} records, ends {ended}>"

    def _repr_html_(self) -> str:
        def row(code: int) -> tuple[Any, ...]:
            impacts = self.impacts[self.ends == code]
            return End(code).name, len(impacts), int(impacts.min()), int(impacts.max())

        codes = np.unique(self.ends).tolist()
        caption = f"{len(self.ends)} motions, {len(self.periods)} records"
        return _html.table(caption, ("end", "motions", "fewest impacts", "most impacts"), map(row, codes), len(codes))


def simulate(
    scene: _grazing.Scene, starts: npt.ArrayLike, periods: int, transient: int, every: int, phase: float,
    parameters: Mapping[str, npt.ArrayLike] | None, progress: Progress,
) -> Motions:
    """What ``Scene.simulate`` does: its arguments as arrays, and the motions."""
    every, transient = natural("every", every), natural("transient", transient)
    if every == 0:
        raise InputError("every = 0: from 1 up")
    if not np.isfinite(phase):
        raise InputError(f"phase = {phase}: a fraction of the forcing period")
    coordinates = scene.coordinates
    width = 2 * coordinates
    first = np.ascontiguousarray(starts, dtype=np.float64)
    if first.ndim == 1:
        first = first.reshape(1, -1)
    if first.ndim != 2 or first.shape[1] != width:
        state = "q and u" if coordinates == 1 else f"{coordinates} displacements, then {coordinates} velocities,"
        raise InputError(f"starts have the shape {np.shape(starts)}: (N, {width}), {state} of each motion")
    names = list(parameters or {})
    columns = [np.atleast_1d(np.asarray(value, np.float64)) for value in (parameters or {}).values()]
    lengths = [len(first), *map(len, columns)]
    count = max(lengths) if max(lengths) > 1 else min(lengths)
    for name, column in zip(["starts", *names], [first, *columns]):
        if len(column) not in (1, count) or (name != "starts" and column.ndim != 1):
            raise InputError(f"{name} has the shape {column.shape}: one entry, or {count} as the longest has")
        if name != "starts" and not np.isfinite(column).all():
            raise InputError(f"{name} has values that are not finite")
    if len(first) != count:
        first = np.repeat(first, count, axis=0)
    values = np.empty((count, len(names)))
    for at, column in enumerate(columns):
        values[:, at] = column
    records = natural("periods", periods) // every + 1
    points = np.empty((count, records, width))
    impacts, ends = np.empty(count, np.uint64), np.empty(count, np.uint8)
    with shown(progress) as bar:
        scene.simulate(first, names, values, float(phase), transient, every, points, impacts, ends, bar)
    varied = {name: values[:, at].copy() for at, name in enumerate(names)}
    return Motions(points, impacts, ends, transient + every * np.arange(records), Record(varied))
