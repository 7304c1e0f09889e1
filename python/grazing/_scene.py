"""Scenes: an oscillator or a machine, what to do with it, and what came of it."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, overload

import numpy as np
import numpy.typing as npt

from . import _grazing, _html, _motions, _plots
from ._arguments import Exact, changes, toml_source
from ._errors import FileError, InputError, refused
from ._frames import dataset, frame
from ._motions import Motions
from ._outcomes import Done, Failed, NothingFound, Outcome, Pending, Proved, Record, Refuted, Undecided
from ._progress import Progress, shown
from ._tolerances import Tolerance, tolerance

#: The axes of arrays on a grid, by kind of task.
_GRIDS = {"basins": ("q", "u"), "map": ("first", "second")}

#: What the numbers of ``data.event_kind`` mean.
EVENT_KINDS = ("impact", "tangency", "stick", "release", "touch", "reversal", "kink", "upcrossing", "downcrossing")


@dataclass(frozen=True)
class Task:
    """A task of a scene."""

    name: str
    #: What it does: ``"simulate"``, ``"section"``, ``"grazing"``, …: see docs/scenes.md.
    kind: str
    #: The name it shares with others, for ``only``.
    group: str | None
    #: The parameter values that it has in place of the scene's.
    set: Mapping[str, Fraction]


@dataclass(frozen=True)
class TaskReport:
    """What a task came to. ``print(report)`` shows what the command line prints."""

    task: str
    kind: str
    #: What computed its motions: ``name``, ``"one"`` or ``"many"``, and ``reason`` (docs/scenes.md).
    engine: Record
    #: Never a bool. :class:`Done` is floating point; only tasks of kind ``validate`` and ``chaos`` prove.
    outcome: Outcome
    #: The parameters' values, exactly.
    parameters: Mapping[str, Fraction]
    #: What the numbers of ``findings`` are in, by their names, as ``units["fastest"]``; empty without units.
    units: Mapping[str, str] = field(repr=False)
    #: Named numbers and tables, as in the command line's JSON (docs/formats.md).
    findings: Record = field(repr=False)
    #: Arrays, by kind of task; times are in forcing periods. simulate: ``time``, ``q``, ``u`` (T,), of
    #: several displacements (T, N); ``event_time``, ``event_kind`` (see EVENT_KINDS), ``event_place`` (the stop,
    #: in the scene's order, from 0; dry friction comes after all stops), ``event_value`` (velocity before the
    #: impact; gap; time left out), in the scene's units.
    #: section: ``points`` (P, 2), ``attractor`` (P,), from 0; of orbits −1, −2, …. basins: ``q``, ``u``,
    #: ``cells`` (rows, columns), places in ``findings.basins``. diagram: ``value``, ``points`` (P, 2),
    #: ``motion``, ``period`` (0: not periodic, −2: not settled). map: ``first``, ``second``, ``period`` (the
    #: same; −1: ended), ``impacts``, ``exponent`` (NaN: none), each (rows, columns). response, a row of each
    #: per way, value and coordinate or gap: ``way`` (0 linear, 1 up, 2 down, 3 unstable), ``value``, ``coordinate``, from 0,
    #: the gaps after all coordinates, ``swing``, ``amplitude``, ``lag`` (NaN: none), ``period`` (0: not periodic).
    data: Record = field(repr=False)
    #: Certificates by file name: ``grazing.check(text)`` proves them again.
    certificates: Mapping[str, str] = field(repr=False)
    #: What each proves, in the checker's words, by file name: ``kind``, ``title``, ``range``, ``detail``.
    claims: Mapping[str, Record] = field(repr=False)
    #: All points of branches, of tasks of kind branch.
    rows: Sequence[Record] = field(repr=False)
    #: What a reader should know before trusting the numbers.
    warnings: tuple[str, ...]
    #: How often what was computed: docs/formats.md.
    effects: Mapping[str, int] = field(repr=False)
    #: The report as text.
    text: str = field(repr=False)

    def __str__(self) -> str:
        return self.text.rstrip("\n")

    def __hash__(self) -> int:
        return hash((self.task, self.kind, self.text))

    @property
    def tolerance(self) -> Tolerance | None:
        """What a task ``grazing`` with ``tolerance`` tells of all machines that it allows; ``None`` of others, and where
        nothing is told: ``findings.tolerance_open`` says why."""
        return tolerance(self.findings)

    def frame(self, name: str | None = None, *, floats: bool = False) -> Any:
        """A pandas frame of a table of the findings, as ``report.frame("orbits")``; of all points of branches
        without a name. What the findings have exactly, as the ends of a proved range, are Fractions; with ``floats``
        they are rounded to floats, and are no bounds any more."""
        if name is None:
            return frame(self.rows, floats)
        tables = [key for key, value in self.findings.items() if isinstance(value, list)]
        if name not in tables:
            raise InputError(f"task {self.task} has no table {name!r}; there is {', '.join(tables) or 'none'}")
        return frame(self.findings[name], floats)

    def to_xarray(self) -> Any:
        """An ``xarray.Dataset`` of the arrays on a grid, of tasks of kind basins and map, by the names of their
        axes."""
        axes = _GRIDS.get(self.kind)
        if axes is None or not self.data:
            kinds = ", ".join(_GRIDS)
            what = f"task {self.task} of kind {self.kind}"
            raise InputError(f"{what} has no arrays on a grid; those of kind {kinds} have")
        values = {name: (axes[::-1], array) for name, array in self.data.items() if name not in axes}
        return dataset(values, {axis: self.data[axis] for axis in axes})

    def plot(self, axes: Any = None) -> Any:
        """A picture of what the task found, on Matplotlib's ``axes`` or new ones, which are given back: of the arrays
        of tasks that simulate, section, diagram, basins and map; of branches, of what ``validate`` encloses over a
        parameter, and of the ranges of ``grazing``."""
        return _plots.report(self, axes)

    def _repr_html_(self) -> str:
        return self.outcome._repr_html_() + _html.preformatted(str(self))


class Run(Sequence[TaskReport]):
    """The reports of a scene's tasks, by place and by name."""

    def __init__(self, reports: Iterable[TaskReport]) -> None:
        self._reports = tuple(reports)

    def __len__(self) -> int:
        return len(self._reports)

    @overload
    def __getitem__(self, index: int | str) -> TaskReport: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[TaskReport, ...]: ...
    def __getitem__(self, index: int | str | slice) -> TaskReport | tuple[TaskReport, ...]:
        if not isinstance(index, str):
            return self._reports[index]
        for report in self._reports:
            if report.task == index:
                return report
        raise KeyError(f"{index!r}; there is {', '.join(report.task for report in self._reports)}")

    def __repr__(self) -> str:
        lines = [f"  {r.task} ({r.kind}): {type(r.outcome).__name__}" for r in self._reports]
        return "\n".join([f"<Run: {len(self)} tasks>", *lines])

    def __str__(self) -> str:
        return "\n".join(map(str, self._reports))

    def __eq__(self, other: object) -> bool:
        return self._reports == other._reports if isinstance(other, Run) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._reports)

    def _repr_html_(self) -> str:
        rows = ((r.task, r.kind, type(r.outcome).__name__, r.outcome.why()) for r in self._reports)
        return _html.table(f"{len(self)} tasks", ("task", "kind", "outcome", "why"), rows, len(self))

    @property
    def outcome(self) -> Outcome:
        """The worst of all: refuted, failed, pending, undecided, nothing found, done, proved."""
        order = (Refuted, Failed, Pending, Undecided, NothingFound, Done, Proved)
        outcomes = [report.outcome for report in self._reports]
        return min(outcomes, key=lambda outcome: order.index(type(outcome)), default=Done("no task"))


@dataclass(frozen=True)
class Answer:
    """What a machine does as its drive is turned up: ``print(answer)`` shows the page that the command line prints."""

    #: The sentences: ``mark``, ``"proved"``, ``"located"`` or ``"seen"`` (docs/marks.md), and ``text``.
    sentences: Sequence[Record]
    #: The report of the touch, a task of kind ``grazing``.
    touch: TaskReport
    #: How far the machine swings about it, of kind ``response``; ``None`` where no touch was found, or at 0.
    swing: TaskReport | None = field(repr=False)
    #: The page as text.
    text: str = field(repr=False)

    def __str__(self) -> str:
        return self.text.rstrip("\n")

    def __hash__(self) -> int:
        return hash(self.text)

    def _repr_html_(self) -> str:
        return _html.preformatted(str(self))


class Scene:
    """An oscillator or a machine, and tasks. It is pickled with its source, its name and its values; scenes are equal
    where these are.

    ``Scene(source)`` takes a path to a TOML file, TOML text (with a line feed in it), or a dict of the same
    keys (docs/scenes.md, docs/machines.md). In a dict a float means its shortest decimal, as in a file: 0.8 is
    exactly 4/5; Fractions and Decimals are exact too. Where the dict has no ``format`` or ``title``, they are
    ``"grazing-scene 1"`` and ``"a scene"``.

    :raises InputError: with ``file``, ``line``, ``key``, ``value`` and the fix. Of a dict the line is that of
        :attr:`text`, the TOML it stands for.
    """

    def __init__(self, source: str | os.PathLike[str] | Mapping[str, Any]) -> None:
        text, name = toml_source(source, {"format": "grazing-scene 1", "title": "a scene"})
        self._scene = _grazing.Scene.from_toml(text, name)

    @classmethod
    def _of(cls, scene: _grazing.Scene) -> Scene:
        self = cls.__new__(cls)
        self._scene = scene
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, (self._scene.text, self._scene.name, tuple(self._scene.parameters)))

    def __eq__(self, other: object) -> bool:
        """Whether nothing tells them apart: source and its name, and the parameters' values."""
        return self._scene.is_same(other._scene) if isinstance(other, Scene) else NotImplemented

    def __hash__(self) -> int:
        return hash((self._scene.text, self._scene.name, tuple(self._scene.parameters)))

    @property
    def title(self) -> str:
        return self._scene.title

    @property
    def text(self) -> str:
        """The TOML text that it was read from."""
        return self._scene.text

    @property
    def parameters(self) -> dict[str, Fraction]:
        """The parameters' values, exactly."""
        return dict(self._scene.parameters)

    @property
    def tasks(self) -> tuple[Task, ...]:
        return tuple(Task(name, kind, group, dict(set_)) for name, group, kind, set_ in self._scene.tasks)

    def __repr__(self) -> str:
        kind = "machine" if self._scene.is_machine else "oscillator"
        values = ", ".join(f"{name} = {value}" for name, value in self.parameters.items())
        tasks = ", ".join(task.name for task in self.tasks)
        return f"<Scene {self.title!r}: {kind}; {values or 'no parameters'}; tasks: {tasks or 'none'}>"

    def with_parameters(self, **values: Exact | float) -> Scene:
        """The same scene with other values of some parameters; a float is its shortest decimal."""
        return Scene._of(self._scene.with_parameters(changes(values)))

    def run(
        self, only: str | Iterable[str] | None = None, *, set: Mapping[str, Exact | float] | None = None,
        folder: str | os.PathLike[str] | None = None, progress: Progress = None,
    ) -> Run:
        """Run the tasks, all or those named (or of a group that is named), in their order.

        All are checked before the first begins. A task that fails does not end the rest: see its outcome. What
        ``set`` gives is the parameters' values in every task, a float by its shortest decimal. In ``folder`` long tasks keep checkpoints, from
        which the same call goes on after an interruption; nothing else is written.

        :raises KeyboardInterrupt: on Ctrl-C, within a second; its attribute ``reports`` has the reports of
            the tasks that were done.
        """
        done: list[TaskReport] = []
        try:
            for report in self.each(only, set=set, folder=folder, progress=progress):
                done.append(report)
        except KeyboardInterrupt as interrupt:
            interrupt.reports = tuple(done)  # type: ignore[attr-defined]
            raise
        return Run(done)

    def each(
        self, only: str | Iterable[str] | None = None, *, set: Mapping[str, Exact | float] | None = None,
        folder: str | os.PathLike[str] | None = None, progress: Progress = None,
    ) -> Iterator[TaskReport]:
        """As :meth:`run`, each report as soon as its task is done."""
        chosen = self._chosen(only)
        changed = changes(set)
        where = None if folder is None else os.fspath(folder)
        if where is not None:
            try:
                os.makedirs(where, exist_ok=True)
            except OSError as error:
                raise refused("make the folder", where, error) from error
        for index in chosen:
            self._scene.check(index, changed)
        for index in chosen:
            with shown(progress) as bar:
                answer = self._scene.run(index, changed, where, bar)
            yield _report(*answer)

    def answer(self, *, set: Mapping[str, Exact | float] | None = None, progress: Progress = None) -> Answer:
        """What the machine does as the parameter of its first task of kind ``grazing`` is turned up, on a page.

        :raises InputError: where the scene has no such task.
        """
        with shown(progress) as bar:
            text, sentences, reports = self._scene.answer(changes(set), bar)
        said = tuple(Record({"mark": mark, "text": sentence}) for mark, sentence in sentences)
        touch, *rest = (_report(*report) for report in reports)
        return Answer(said, touch, rest[0] if rest else None, text)

    def _chosen(self, only: str | Iterable[str] | None) -> list[int]:
        tasks = self.tasks
        if not tasks:
            raise InputError(f"{self._scene.name} has no [[tasks]]: nothing to do")
        if only is None:
            return list(range(len(tasks)))
        names = [only] if isinstance(only, str) else list(only)
        for name in names:
            if not any(name in (task.name, task.group) for task in tasks):
                known = ", ".join(task.name for task in tasks)
                raise InputError(f"only = {name!r}: {self._scene.name} has the tasks {known}")
        return [i for i, task in enumerate(tasks) if task.name in names or task.group in names]

    def simulate(
        self, starts: npt.ArrayLike, periods: int, *, transient: int = 0, every: int = 1, phase: float = 0.0,
        parameters: Mapping[str, npt.ArrayLike] | None = None, progress: Progress = None,
    ) -> Motions:
        """Follow many motions at once, on all cores; of a linear oscillator, eight in a vector.

        :param starts: (q, u) of each: an array of shape (N, 2), read where it is if it is contiguous float64; of a
            machine with c coordinates of shape (N, 2 c), all displacements, then all velocities. One state is
            followed from for every value of ``parameters``.
        :param periods: forcing periods that are recorded, after the transient: the points of periods 0,
            ``every``, 2 ``every``, … are kept.
        :param transient: forcing periods before the first record.
        :param phase: where motions start and are looked at, as a fraction of the forcing period.
        :param parameters: for some parameters an array of N values (or one value for all): each motion then has a
            system of its own. These are floats; the scene's others stay exact until they are rounded.

        Each motion is, to the bit, that of the command line's simulation of one, and is floating point: no
        proof.
        """
        return _motions.simulate(self._scene, starts, periods, transient, every, phase, parameters, progress)

    def _repr_html_(self) -> str:
        values = ", ".join(f"{name} = {value}" for name, value in self.parameters.items()) or "no parameters"
        rows = ((one.name, one.kind, one.group, tuple(f"{k} = {v}" for k, v in one.set.items())) for one in self.tasks)
        head = ("task", "kind", "group", "with")
        return _html.table(f"{self.title}: {values}", head, rows, len(self.tasks))


def simulate(
    M: npt.ArrayLike = 1.0, C: npt.ArrayLike = 0.0, K: npt.ArrayLike = 0.0, *, stops: Sequence[Mapping[str, Any]] = (),
    force: npt.ArrayLike = 0.0, load: npt.ArrayLike = 0.0, frequency: float | None = None, q: npt.ArrayLike = 0.0,
    u: npt.ArrayLike = 0.0, periods: int = 10, transient: int = 0, samples: int = 64, progress: Progress = None,
) -> TaskReport:
    """One motion of M q″ + C q′ + K q = ``load`` + Re(``force`` e^{iωt}) between stops, without a scene.

    :param M, C, K: numbers, or arrays of shape (n, n); floats mean their shortest decimals.
    :param stops: for each its keys as in a scene: ``offset``, ``restitution``, and ``side`` of one coordinate, or
        ``row``, n numbers: the gap is row · q − offset.
    :param force: n amplitudes, complex for a phase of their own; ``load`` a constant force.
    :param frequency: of the drive, in cycles per unit of time; without it ω = 1.
    :param q, u: the start, n displacements and velocities.
    :param periods: of the drive that are recorded, after ``transient``; ``samples`` times in each.

    ``data.time`` (in periods), ``data.q`` and ``data.u`` are the motion, ``data.event_time`` and the like its impacts,
    ``findings`` what it amounts to.

    :raises InputError: of what makes no machine, by the scene's key.
    """
    amplitudes = np.atleast_1d(np.asarray(force, dtype=complex))
    numbers = {"mass": M, "damping": C, "stiffness": K, "force": load}
    system: dict[str, Any] = {key: np.asarray(value, dtype=float).tolist() for key, value in numbers.items()}
    size = np.atleast_1d(np.asarray(M)).shape[0]
    if system["force"] == 0.0:
        del system["force"]
    if amplitudes.any():
        parts = {"cos": amplitudes.real, "sin": -amplitudes.imag}
        system["forcing"] = [{key: _one(part, size) for key, part in parts.items()}]
    if frequency is not None:
        system["frequency"] = float(frequency)
    start = {"q": _one(np.asarray(q, dtype=float), size), "u": _one(np.asarray(u, dtype=float), size)}
    task = {"name": "motion", "kind": "simulate", "start": start, "periods": periods, "transient": transient,
            "samples": samples}
    tree = {"format": "grazing-scene 3", "title": "a motion", "system": system, "stops": list(stops), "tasks": [task]}
    report = Scene({key: value for key, value in tree.items() if value != []}).run(progress=progress)[0]
    if isinstance(report.outcome, Failed) and isinstance(report.outcome.error, Exception):
        raise report.outcome.error
    return report


def _one(values: npt.NDArray[np.float64], size: int) -> Any:
    """A list of numbers, a number for all; of one coordinate the number."""
    if values.ndim > 1 or values.size not in (1, size):
        raise InputError(f"{values.tolist()!r}: a number for each of {size} coordinates, or one for all")
    whole = np.broadcast_to(values, (size,)).tolist()
    return whole[0] if size == 1 else whole


def machine(words: str) -> Scene:
    """The scene of a driven mass beside a stop, from its numbers, in any units, SI units without one.

    >>> grazing.machine("m = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 10 mm, e = 0.6").parameters["gap"]
    Fraction(1, 100)

    The damping is c, or the damping ratio ζ (also ``zeta``); without the amplitude F of the drive it is nine tenths of
    what touches, without the restitution e this is 0.8. :meth:`Scene.answer` says what it does.

    :raises InputError: with what is missing, or what is none of a machine's numbers.
    """
    return Scene._of(_grazing.Scene.from_words(words))


def _again(text: str, name: str, parameters: tuple[tuple[str, Fraction], ...]) -> Scene:
    """The scene that was pickled; files that it names are read again."""
    return Scene._of(_grazing.Scene.from_toml(text, name).with_parameters(list(parameters)))


#: In a report's JSON, what does not belong to the findings.
_COMMON = tuple("task kind status reason io engine place parameters units certificates warnings effects files".split())

_PROOFS = ("validate", "chaos")


def _report(
    text: str,
    shown: str,
    arrays: dict[str, Any],
    rows: str | None,
    certificates: list[tuple[str, str]],
    failed: tuple[str, int | None, bool] | None,
) -> TaskReport:
    report = json.loads(text)
    findings = Record({name: value for name, value in report.items() if name not in _COMMON})
    return TaskReport(
        task=report["task"],
        kind=report["kind"],
        engine=Record(report["engine"]),
        outcome=_outcome(report, failed),
        parameters={name: Fraction(value) for name, value in report["parameters"].items()},
        units=report["units"],
        findings=findings,
        data=Record(arrays),
        certificates=dict(certificates),
        claims={one["file"]: Record(one) for one in report.get("certificates", ())},
        rows=tuple(map(Record, json.loads(rows))) if rows else (),
        warnings=tuple(report["warnings"]),
        effects=report["effects"],
        text=shown,
    )


def _outcome(report: dict[str, Any], failed: tuple[str, int | None, bool] | None) -> Outcome:
    statement = f"task {report['task']} of kind {report['kind']}"
    reason = report.get("reason") or ""
    status = report["status"]
    if failed is not None:
        message, line, io = failed
        kind = FileError if io else InputError
        return Failed(statement, error=kind(message, file=report["place"]["file"], line=line))
    if status == "done":
        return Proved(statement) if report["kind"] in _PROOFS else Done(statement)
    if status == "nothing-found":
        return NothingFound(statement, reason=reason)
    if status == "refuted":
        return Refuted(statement, witness=reason)
    if status == "undecided":
        return Undecided(statement, budget=reason)
    return Pending(statement, left=reason)
