"""Arrays of exact numbers: what :func:`classify_many` takes, and how the compiled part gets it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from ._arguments import Exact
from ._errors import InputError


class Fractions:
    """An array of fractions, as two arrays of whole numbers of at most 64 bits: ``numerators`` over
    ``denominators``, which are broadcast against each other. They need not be in lowest terms.

    >>> import grazing, numpy
    >>> twelfths = grazing.Fractions(numpy.arange(1, 6), 12)
    >>> print(*twelfths)
    1/12 1/6 1/4 1/3 5/12
    """

    def __init__(self, numerators: npt.ArrayLike, denominators: npt.ArrayLike = 1) -> None:
        parts = [_whole(name, part) for name, part in (("numerators", numerators), ("denominators", denominators))]
        #: int64 arrays of one shape.
        self.numerators, self.denominators = np.broadcast_arrays(*map(np.ma.getdata, parts))
        masks = [np.ma.getmaskarray(part) for part in parts if isinstance(part, np.ma.MaskedArray)]
        self._mask = _together(self.shape, masks)

    @property
    def shape(self) -> tuple[int, ...]:
        return self.numerators.shape

    def __len__(self) -> int:
        return len(self.numerators)

    def __getitem__(self, place: Any) -> Any:
        """One of them as a Fraction (or ``numpy.ma.masked``), or some."""
        above, below = self.numerators[place], self.denominators[place]
        hidden = None if self._mask is None else self._mask[place]
        if np.ndim(above) > 0:
            return Fractions(above if hidden is None else np.ma.MaskedArray(above, hidden), below)
        return np.ma.masked if hidden else Fraction(int(above), int(below))

    def __iter__(self) -> Iterator[Any]:
        return (self[place] for place in range(len(self)))

    def __repr__(self) -> str:
        few = ", ".join(f"{p}/{q}" for p, q in zip(self.numerators.flat[:6], self.denominators.flat[:6]))
        return f"<Fractions {self.shape}: {few}{', …' if self.numerators.size > 6 else ''}>"


def _together(shape: tuple[int, ...], masks: list[npt.NDArray[np.bool_]]) -> npt.NDArray[np.bool_] | None:
    """What is masked in one of them; ``None`` of none."""
    return np.logical_or.reduce([np.broadcast_to(one, shape) for one in masks]) if masks else None


def _whole(name: str, part: npt.ArrayLike) -> npt.NDArray[np.int64]:
    array = np.asanyarray(part)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: an array of {array.dtype} is none of whole numbers of at most 64 bits")
    if array.dtype.kind == "u" and array.size and array.max() >= 2**63:
        raise InputError(f"{name}: {array.max()} is not below 2^63; give a list of fractions")
    return array.astype(np.int64, copy=False)


#: Numbers of many points: exact ones, alone or in lists and arrays; floats where ``floats`` says what they mean.
Numbers = Union[Exact, Fractions, npt.ArrayLike]


@dataclass(frozen=True)
class Column:
    """Numbers of one kind, as :mod:`_grazing` knows them."""

    kind: str
    parts: tuple[npt.NDArray[Any], ...]
    mask: npt.NDArray[np.bool_] | None

    @property
    def shape(self) -> tuple[int, ...]:
        return self.parts[0].shape

    def flat(self, shape: tuple[int, ...], hidden: npt.NDArray[np.bool_] | None) -> tuple[str, Any]:
        """One number for each place of an array of this shape, row by row, or one for all; anything where they are
        hidden."""
        if all(part.size == 1 for part in self.parts):
            shape, hidden = self.shape, self.mask
        parts = [np.ascontiguousarray(np.broadcast_to(part, shape)).reshape(-1) for part in self.parts]
        if self.kind == "pairs":
            return self.kind, tuple(parts)
        if self.kind == "exact":
            numbers = parts[0].tolist()
            if hidden is not None:
                numbers = [0 if skip else x for x, skip in zip(numbers, hidden.flat)]
            return self.kind, numbers
        return self.kind, parts[0]


def mask(shape: tuple[int, ...], *columns: Column) -> npt.NDArray[np.bool_] | None:
    """Where one of the columns is masked; ``None`` if none of them is a masked array."""
    return _together(shape, [column.mask for column in columns if column.mask is not None])


def column(values: Numbers, floats: str | None) -> Column:
    """The numbers as they are, floats by what they are said to mean."""
    if floats not in (None, "binary", "decimal"):
        raise InputError(f'floats = {floats!r}: "binary" or "decimal"')
    if isinstance(values, Fractions):
        return Column("pairs", (values.numerators, values.denominators), values._mask)
    # NumPy would make floats of a list of integers and floats, and of what has a float's method.
    array = np.asanyarray(values) if hasattr(values, "__array__") else np.array(values, dtype=object)
    hidden = np.ma.getmaskarray(array) if isinstance(array, np.ma.MaskedArray) else None
    array = np.ma.getdata(array)
    if array.dtype.kind == "f":
        return _floats(array, hidden, floats)
    if array.dtype.kind == "i" or array.dtype.kind == "u" and array.dtype.itemsize < 8:
        whole = array.astype(np.int64, copy=False)
        return Column("pairs", (whole, np.ones((), np.int64)), hidden)
    if array.dtype.kind not in "uOU":
        raise TypeError(f"an array of {array.dtype} holds no real numbers")
    held = array.astype(object)
    shown = held if hidden is None else held[~hidden]
    if shown.size and all(type(x) is float for x in shown.flat):
        filled = held if hidden is None else np.where(hidden, 0.0, held)
        return _floats(filled.astype(np.float64), hidden, floats)
    if floats is not None and shown.size:
        for place, x in enumerate(held.flat):
            if isinstance(x, (float, np.floating)) and not (hidden is not None and hidden.flat[place]):
                held.flat[place] = _meant(place, x, floats)
    return Column("exact", (held,), hidden)


def _floats(array: npt.NDArray[Any], hidden: npt.NDArray[np.bool_] | None, floats: str | None) -> Column:
    if floats is None:
        raise TypeError(
            f'an array of {array.dtype}, and its numbers must be exact: say what a float means, floats="binary" for '
            'the fraction that it is or floats="decimal" for its shortest decimal, or give Fractions'
        )
    if array.dtype.itemsize > 8 or array.dtype.itemsize < 8 and floats == "decimal":
        raise TypeError(f"an array of {array.dtype}: give float64, or exact numbers")
    return Column(floats, (array.astype(np.float64, copy=False),), hidden)


def _meant(place: int, x: Any, floats: str) -> Fraction:
    """What a float among other numbers is said to mean."""
    if isinstance(x, np.floating) and (x.itemsize > 8 or x.itemsize < 8 and floats == "decimal"):
        raise TypeError(f"point {place}: {x!r} is no float of 64 bits: give an exact number")
    if not math.isfinite(x):
        raise InputError(f"point {place}: {x} is not finite")
    return Fraction(float(x)) if floats == "binary" else Fraction(repr(float(x)))
