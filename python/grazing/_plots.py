"""Pictures of results by Matplotlib, which is imported here when one is drawn. Each function draws on the axes that
it is given, or on new ones, and gives them back."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import InputError, MissingPackageError

if TYPE_CHECKING:
    from ._places import Classification, WordCase, WordReport
    from ._boxes import Share, Shares
    from ._motions import Motions
    from ._proofs import Intervals
    from ._scene import TaskReport

#: The cases (sign eµ, sign γ), each with its colour of Okabe and Ito's set, as in the figures here.
CASES = {(1, 1): "#0072B2", (1, -1): "#D55E00", (-1, 1): "#009E73", (-1, -1): "#CC79A7"}
GREY = "#999999"

#: Rows of bars that a picture has; of how many they are is said.
MOST_ROWS = 60


def on(axes: Any) -> Any:
    """The axes, or new ones."""
    try:
        import matplotlib.pyplot as plt  # type: ignore[import-untyped, unused-ignore]
    except ImportError:
        raise MissingPackageError(
            "pictures need the package matplotlib, which is not installed; pip install 'grazing[figures]'"
        ) from None
    return plt.subplots()[1] if axes is None else axes


def name(case: tuple[int, int]) -> str:
    """A case in a legend."""
    emu, gamma = ("> 0" if sign > 0 else "< 0" for sign in case)
    return f"eµ {emu}, γ {gamma}"


def _legend(axes: Any) -> None:
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="upper left", bbox_to_anchor=(1, 1), fontsize="small")


def classification(found: Classification, axes: Any) -> Any:
    """A square for each orbit, by period and case; where it is not known, a mark in every case's row."""
    axes = on(axes)
    rows = {case: 3 - place for place, case in enumerate(CASES)}
    for case, colour in CASES.items():
        periods = [row.n for row in found if case in row.cases]
        if periods:
            axes.scatter(periods, [rows[case]] * len(periods), s=60, marker="s", color=colour, label=name(case))
    for label, marker, verdicts in (
        ("boundary: Theorem 1 is silent", "|", ("singular boundary", "iterate boundary", "sign boundary")),
        ("undecided", "x", ("undecided",)),
    ):
        periods = [row.n for row in found if row.verdict in verdicts]
        if periods:
            at = [(n, y) for n in periods for y in rows.values()]
            axes.scatter(*zip(*at), s=60, marker=marker, color=GREY, label=label)
    axes.set_yticks(list(rows.values()), [name(case) for case in rows])
    axes.set(xlabel="period n", xlim=(0.5, len(found) + 0.5), ylim=(-0.5, 3.5), title="Orbits with one impact")
    _legend(axes)
    return axes


def word(report: WordReport, axes: Any) -> Any:
    """The periods of both words at their places m/n: upwards triangles for U, downwards for D, joined in path
    order."""
    axes = on(axes)
    for one, colour in zip(report.words, (CASES[1, 1], CASES[-1, 1])):
        sign = ">" if one.sign_emu > 0 else "<"
        places = [float(place) for place in one.fractions]
        axes.plot(places, one.periods, color=colour, linewidth=0.8, label=f"eµ {sign} 0, ends: {one.end}")
        for letter, marker in (("U", "^"), ("D", "v"), ("?", "o")):
            chosen = [(x, n) for x, n, own in zip(places, one.periods, one.letters) if own == letter]
            if chosen:
                axes.plot(*zip(*chosen), marker, color=colour, markersize=7)
    axes.set(xlabel="m/n", ylabel="period n", title="Periods between impacts")
    _legend(axes)
    return axes


def graph(case: WordCase, axes: Any) -> Any:
    """The pattern graph: an arrow from i to j where a flight of j periods may follow one of i, dashed where that is
    open; a ring around a period that may follow itself."""
    axes = on(axes)
    periods = sorted({n for edge in (*case.edges, *case.open) for n in edge} | set(case.loops))
    turn = {n: 2 * math.pi * place / max(1, len(periods)) for place, n in enumerate(periods)}
    at = {n: (math.sin(angle), math.cos(angle)) for n, angle in turn.items()}
    for edges, style in ((case.edges, "solid"), (case.open, "dashed")):
        for i, j in edges:
            if i == j:
                ring = axes.scatter(*at[i], s=700, facecolors="none", edgecolors=CASES[case.case], linestyles=style)
                ring.set_gid(f"{i}-{j}")
                continue
            arrow = axes.annotate("", at[j], at[i], arrowprops={
                "arrowstyle": "-|>", "color": CASES[case.case], "linestyle": style, "shrinkA": 14, "shrinkB": 14,
                "connectionstyle": "arc3,rad=0.12",
            })
            arrow.set_gid(f"{i}-{j}")
    for n, place in at.items():
        axes.text(*place, str(n), ha="center", va="center")
    axes.set(xlim=(-1.4, 1.4), ylim=(-1.4, 1.4), aspect="equal", title=f"What may follow what: {name(case.case)}")
    axes.axis("off")
    return axes


def intervals(table: Intervals, axes: Any) -> Any:
    """A bar from end to end for each interval, on a row for each period."""
    axes = on(axes)
    columns = table.columns
    left, right = (columns[f"{end}_numerator"] / columns[f"{end}_denominator"] for end in ("left", "right"))
    for case, colour in CASES.items():
        own = (columns["sign_emu"] == case[0]) & (columns["sign_gamma"] == case[1])
        if own.any():
            axes.barh(columns["n"][own], (right - left)[own], 0.7, left[own], color=colour, label=name(case))
    axes.set(xlabel="s", ylabel="period n", xlim=(0, 0.5), title="Where orbits with one impact exist on r = 1")
    _legend(axes)
    return axes


def shares(found: Shares, axes: Any) -> Any:
    """A bar for each statement: full up to the lower bound of its share, pale from there to the upper one."""
    axes = on(axes)
    rows = found.rows[:MOST_ROWS]
    for y, row in enumerate(rows):
        lower, upper = float(row.lower), float(row.upper)
        colour = CASES[row.sign_emu, 1]
        axes.barh(y, lower, 0.7, color=colour)
        axes.barh(y, upper - lower, 0.7, lower, color=colour, alpha=0.3)
    axes.set_yticks(range(len(rows)), [_share(row) for row in rows])
    axes.invert_yaxis()
    more = f", {len(rows)} of {len(found.rows)} statements" if len(rows) < len(found.rows) else ""
    axes.set(xlabel="share of the box", xlim=(0, 1), title=f"from {found.cells} cells{more}")
    return axes


def _share(row: Share) -> str:
    """What a row is of, and its verdict."""
    side = f"eµ {'>' if row.sign_emu > 0 else '<'} 0"
    if row.what == "chaos":
        gamma = {1: ", γ > 0", -1: ", γ < 0"}.get(row.sign_gamma or 0, "")
        return f"{side}{gamma}: chaos, {row.verdict}"
    return f"{side}: {row.what} {row.letters if row.n is None else row.n}, {row.verdict}"


def motions(found: Motions, axes: Any, coordinate: int, over: str | None) -> Any:
    """The records of the motions, each in one colour: u over q, or q over a parameter."""
    if not 1 <= coordinate <= found.coordinates:
        raise InputError(f"coordinate = {coordinate}: from 1 to {found.coordinates}")
    if over is not None and over not in found.parameters:
        known = ", ".join(found.parameters) or "none"
        raise InputError(f"over = {over!r}: parameters that were varied are {known}")
    axes = on(axes)
    q, u = (found.points[..., part * found.coordinates + coordinate - 1] for part in (0, 1))
    q_name, u_name = (part if found.coordinates == 1 else f"{part}{coordinate}" for part in "qu")
    number = np.broadcast_to(np.arange(len(q))[:, None], q.shape)
    if over is None:
        axes.scatter(q, u, s=2, c=number)
        axes.set(xlabel=q_name, ylabel=u_name)
    else:
        axes.scatter(np.broadcast_to(found.parameters[over][:, None], q.shape), q, s=2, c=number)
        axes.set(xlabel=over, ylabel=q_name)
    axes.set_title(f"{len(found.ends)} motions, once a period")
    return axes


def report(found: TaskReport, axes: Any) -> Any:
    """What a task's arrays show."""
    draw, has = _KINDS.get(found.kind, (None, lambda found: False))
    if draw is None or not has(found):
        raise InputError(
            f"task {found.task} of kind {found.kind} has nothing to draw; those of kind {', '.join(_KINDS)} may have: "
            "arrays, branches, or what is proved over a parameter"
        )
    axes = on(axes)
    draw(found, axes)
    axes.set_title(f"{found.task}: {type(found.outcome).__name__}")
    _legend(axes)
    return axes


#: Marks of events, by the numbers of EVENT_KINDS.
_EVENTS = (
    ("impact", "o"), ("tangency", "*"), ("stick", "s"), ("release", "^"), ("touch", "d"), ("reversal", "v"), ("kink", "+"),
    ("upcrossing", "2"), ("downcrossing", "1"),
)


def _simulate(found: TaskReport, axes: Any) -> None:
    data = found.data
    axes.plot(data.time, data.q, linewidth=1)
    # Along the axis of time: where a stop is then, the arrays do not say.
    for number, (label, marker) in enumerate(_EVENTS):
        times = data.event_time[data.event_kind == number]
        if len(times):
            at = [0.02] * len(times)
            axes.plot(times, at, marker, transform=axes.get_xaxis_transform(), label=label, markersize=4)
    axes.set(xlabel="time, in forcing periods", ylabel="q")


def _section(found: TaskReport, axes: Any) -> None:
    for number in np.unique(found.data.attractor):
        points = found.data.points[found.data.attractor == number]
        label = f"attractor {number + 1}" if number >= 0 else f"orbit {-number}"
        axes.plot(points[:, 0], points[:, 1], "." if number >= 0 else "x", label=label, markersize=4)
    axes.set(xlabel="q", ylabel="u")


def _diagram(found: TaskReport, axes: Any) -> None:
    axes.plot(found.data.value, found.data.points[:, 0], ".", markersize=2)
    axes.set(xlabel=found.findings.get("parameter", "parameter"), ylabel="q")


def _response(found: TaskReport, axes: Any) -> None:
    """The swing of each coordinate and gap by its number: the linear response dashed, what is seen solid, unstable orbits as dots."""
    data = found.data
    for coordinate in np.unique(data.coordinate):
        for way, word, style in ((0, "linear", "--"), (1, "up", "-"), (2, "down", "-"), (3, "unstable", ":")):
            mine = (data.way == way) & (data.coordinate == coordinate)
            if mine.any():
                axes.plot(data.value[mine], data.swing[mine], style, label=f"{coordinate + 1}, {word}")
    axes.set(xlabel=found.findings.get("parameter", "parameter"), ylabel="swing")


def _grid(axes: Any, x: Any, y: Any, cells: Any, words: list[str]) -> None:
    """Cells by their numbers, of which each that there is has a word in the legend."""
    import matplotlib.pyplot as plt
    from matplotlib.colors import BoundaryNorm, ListedColormap

    colours = [plt.get_cmap("tab20")(place % 20) for place in range(len(words))]
    norm = BoundaryNorm(np.arange(len(words) + 1) - 0.5, len(words)) if len(words) > 1 else None
    axes.pcolormesh(x, y, cells, cmap=ListedColormap(colours), norm=norm, shading="nearest")
    for colour, words_ in zip(colours, words):
        axes.plot([], [], "s", color=colour, label=words_)


def _basins(found: TaskReport, axes: Any) -> None:
    words = [f"period {row.period}" if row.period else row.end for row in found.findings.basins]
    _grid(axes, found.data.q, found.data.u, found.data.cells, words)
    axes.set(xlabel="q", ylabel="u")


def _map(found: TaskReport, axes: Any) -> None:
    words = {0: "not periodic", -1: "ended", -2: "not settled"}
    kinds, cells = np.unique(found.data.period, return_inverse=True)
    labels = [words.get(int(kind), f"period {kind}") for kind in kinds]
    _grid(axes, found.data.first, found.data.second, cells.reshape(found.data.period.shape), labels)
    axes.set(xlabel=found.findings.get("parameter", "first"), ylabel=found.findings.get("second", "second"))


#: How what is known of stability is drawn, and its word.
_STABLE = {True: ("solid", "stable"), False: ("dashed", "unstable"), "marginal": ("dotted", "marginal")}


def _branch(found: TaskReport, axes: Any) -> None:
    """Of one parameter the speed of the first impact over it, of two the curve in their plane; pale where it is no
    orbit. Between points of two kinds the line is as at the former."""
    varied, said = found.findings.varied, set()
    for number in sorted({row.branch for row in found.rows}):
        rows = [row for row in found.rows if row.branch == number]
        places = [_place(row, len(varied)) for row in rows]
        colour = f"C{(number - 1) % 10}"
        for first, last in _runs([(row.stable, row.admissible) for row in rows]):
            style, word = _STABLE[rows[first].stable]
            label = None if word in said else word
            said.add(word)
            axes.plot(*zip(*places[first:last + 2]), color=colour, linestyle=style, label=label,
                      alpha=0.3 if rows[first].admissible is False else 1)
        for row, place in zip(rows, places):
            if row.label:
                axes.plot(*place, "o", color=colour, markersize=4)
                axes.annotate(row.label, place, textcoords="offset points", xytext=(4, 4), fontsize="small")
    names = [*varied, "speed of the first impact"]
    axes.set(xlabel=names[0], ylabel=names[1])


def _place(row: Any, count: int) -> tuple[float, float]:
    """Where a point of a branch is drawn; of motions without impacts at speed 0."""
    return tuple(row.parameters) if count == 2 else (row.parameters[0], row.speeds[0] if row.speeds else 0.0)


def _runs(kinds: list[Any]) -> list[tuple[int, int]]:
    """First and last place of each run of what is alike."""
    ends = [i for i in range(len(kinds)) if i + 1 == len(kinds) or kinds[i] != kinds[i + 1]]
    return list(zip([0, *(end + 1 for end in ends)], ends))


def _proofs(found: TaskReport, axes: Any) -> None:
    """A line for each orbit over the values of the parameter for which it is proved, broad where it is proved to be
    stable or unstable; of events the values between which the parameter certainly is."""
    _ranges(axes, [(row.pattern, row.lower, row.upper, row.stability) for row in found.findings.proofs if row.lower])
    axes.set(xlabel="parameter", ylabel="pattern")


def _touch(found: TaskReport, axes: Any) -> None:
    """The same of what is born at a touch, from there to the end of its range; of all machines within tolerances, for
    the values of the parameter that they have in common."""
    drawn = [(row, begin) for row in found.findings.range if (begin := _begin(row)) and row.end]
    rows = [(f"{row.side}: {row.of} {', '.join(map(str, row.periods))}", begin, row.end, row.stability)
            for row, begin in drawn]
    _ranges(axes, rows)
    # Of all machines within tolerances: where they touch, each somewhere there.
    spread = [(y, row.touches) for y, (row, _) in enumerate(drawn)
              if row.get("touches") and row.touches[0] != row.touches[1]]
    for i, (y, ends) in enumerate(spread):
        axes.plot([_float(end) for end in ends], [y, y], ":", color=GREY, linewidth=3,
                  label=None if i else "touches of all machines")
    far = sorted(abs(_float(end)) for _, _, end, _ in rows if _float(end))
    if far[-1] > 100 * far[0] > 0:
        axes.set_xscale("symlog", linthresh=far[0])
    axes.set(xlabel="parameter", ylabel="side")


def _begin(row: Any) -> str | None:
    """Where a range from a touch begins: there, or at that touch of all machines that is nearest to its end."""
    if row.get("touches") and row.end:
        touches: list[str] = row.touches
        return min(touches, key=lambda touch: abs(Fraction(touch) - Fraction(row.end)))
    begin: str | None = row.touch
    return begin


def _ranges(axes: Any, rows: list[tuple[str, str, str, Any]]) -> None:
    said = set()
    for y, (_, lower, upper, stability) in enumerate(rows):
        axes.plot([_float(lower), _float(upper)], [y, y], "-|", color=GREY, linewidth=1, label=None if y else "proved")
        for part in stability:
            style, word = _STABLE[part.word == "stable"]
            ends = [_float(lower if part["from"] is None else part["from"]), _float(part.to)]
            colour = CASES[1, 1] if word == "stable" else CASES[1, -1]
            axes.plot(ends, [y, y], color=colour, linewidth=5, linestyle=style, solid_capstyle="butt",
                      dash_capstyle="butt", label=None if word in said else word)
            said.add(word)
    axes.set_yticks(range(len(rows)), [row[0] for row in rows])
    axes.set_ylim(-0.5, len(rows) - 0.5)
    axes.locator_params("x", nbins=5)


def _float(text: str) -> float:
    return float(Fraction(text))


def _arrays(found: TaskReport) -> bool:
    return bool(found.data)


#: For each kind of task what draws it, and whether there is something to draw.
_KINDS: dict[str, tuple[Any, Any]] = {
    "simulate": (_simulate, _arrays), "section": (_section, _arrays), "diagram": (_diagram, _arrays),
    "basins": (_basins, _arrays), "map": (_map, _arrays), "branch": (_branch, lambda found: found.rows),
    "validate": (_proofs, lambda found: any(row.lower for row in found.findings.get("proofs", ()))),
    "response": (_response, _arrays),
    "grazing": (_touch, lambda found: any(_begin(row) and row.end for row in found.findings.get("range") or ())),
}
