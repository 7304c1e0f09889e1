"""Natural frequency and damping ratio, with their deviations, from a free decay."""

from __future__ import annotations

import json
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from . import _grazing
from ._errors import InputError


@dataclass(frozen=True)
class Estimate:
    """A value of a fit, and its standard deviation."""

    value: float
    deviation: float


@dataclass(frozen=True)
class Decay:
    """What a record of a free decay says of a linear machine with one degree of freedom: a fit, without proof."""

    #: How many samples.
    samples: int
    #: The time from the first to the last, and how often it turns in that time.
    duration: float
    periods: float
    #: The undamped natural frequency ω/2π, per unit of time.
    frequency: Estimate
    #: ζ.
    damping_ratio: Estimate
    #: How the errors of these two go together, from −1 to 1.
    correlation: float
    #: Where it comes to rest.
    offset: Estimate
    #: How far it swings at the first sample.
    amplitude: float
    #: The root mean square of the residuals; their runs of one sign, as many as independent ones would have; and
    #: Durbin's and Watson's number, 2 of independent residuals.
    rms: float
    runs: int
    expected_runs: float
    durbin_watson: float


def _column(name: str, given: npt.ArrayLike) -> npt.NDArray[np.float64]:
    if np.ma.is_masked(given):
        raise InputError(f"{name} has masked entries: leave out those samples, times and displacements")
    try:
        column = np.asarray(given, np.float64)
    except (TypeError, ValueError) as failed:
        raise InputError(f"{name} is no array of numbers: {failed}") from None
    if column.ndim != 1:
        raise InputError(f"{name} has shape {column.shape}: one number per sample is needed")
    wrong = np.flatnonzero(~np.isfinite(column))
    if wrong.size:
        raise InputError(f"{name}[{wrong[0]}] is {column[wrong[0]]}: leave out samples that are not finite")
    return column


def decay(times: npt.ArrayLike, displacements: npt.ArrayLike) -> Decay:
    """A machine's natural frequency and damping ratio, with their deviations, from a free decay.

    x(t) = c + exp(−ζωt) (A cos wt + B sin wt), w = ω √(1 − ζ²), is fitted by least squares. A record that this
    does not fit is refused, an :class:`InputError` with the reason: it grows, is overdamped, has too few periods,
    or leaves residuals with a structure, as where damping depends on the amplitude.

    :param times: when the samples were taken, rising; slice both arrays to where the decay is free.
    :param displacements: or velocities, accelerations, strains.

    The frequency is per unit of ``times``: Hz, if that is seconds.
    """
    t, x = _column("times", times), _column("displacements", displacements)
    if t.size != x.size:
        raise InputError(f"there are {t.size} times and {x.size} displacements: one of each per sample is needed")
    late = np.flatnonzero(np.diff(t) <= 0)
    if late.size:
        i = int(late[0]) + 1
        raise InputError(f"times[{i}] = {t[i]} is not after times[{i - 1}] = {t[i - 1]}: sort the samples by time")
    found = json.loads(_grazing.decay(t, x))
    for name in ("frequency", "damping_ratio", "offset"):
        found[name] = Estimate(**found[name])
    return Decay(**found)
