"""Results as pandas frames and xarray datasets, where these packages are installed. Numbers stay exact: what is a
Fraction is one in a frame, too, unless floats are asked for."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from ._errors import MissingPackageError

#: What findings have exactly, as text: the ends of ranges that are proved.
_EXACT = ("lower", "upper", "from", "to", "end", "depth", "alone")
_NUMBER = re.compile(r"-?\d+(\.\d+|/\d+)?\Z", re.ASCII)


def frame(rows: Any, floats: bool = False) -> Any:
    """A ``pandas.DataFrame`` of a list of results (as of :func:`evaluate`, :func:`boundary`, :func:`existence`), a row
    for each; or of one that has a ``to_frame``.

    :param floats: Fractions rounded to the nearest floats. Bounds are none any more then.
    :raises MissingPackageError: without pandas.
    """
    try:
        import pandas  # type: ignore[import-untyped, unused-ignore]
    except ImportError:
        raise MissingPackageError(
            "frames need the package pandas, which is not installed; pip install 'grazing[frames]', or use the "
            "rows themselves"
        ) from None
    if hasattr(rows, "to_frame"):
        table = rows.to_frame()
    elif isinstance(rows, Mapping):
        table = pandas.DataFrame(dict(rows))
    else:
        plain = [_plain(row) for row in rows]
        names = dict.fromkeys(name for row in plain for name in row)
        table = pandas.DataFrame({name: _column(pandas, [row.get(name) for row in plain]) for name in names})
    for name in table.columns:
        if name in _EXACT and all(value is None or _is_exact(value) for value in table[name]):
            table[name] = _column(pandas, [value and Fraction(value) for value in table[name]])
        if floats and table[name].dtype == object:
            table[name] = [_rounded(value) for value in table[name]]
    return table


def dataset(values: Mapping[str, Any], labels: Mapping[str, Any]) -> Any:
    """An ``xarray.Dataset`` of arrays with the names of their axes, and of the values along these."""
    try:
        import xarray  # type: ignore[import-not-found, unused-ignore]
    except ImportError:
        raise MissingPackageError(
            "labelled arrays need the package xarray, which is not installed; pip install 'grazing[labels]', or use "
            "the arrays themselves"
        ) from None
    return xarray.Dataset(dict(values), coords=dict(labels))


def _column(pandas: Any, values: list[Any]) -> Any:
    """A column; pandas would make floats of whole numbers, and NaN of what is not there."""
    kinds = {type(value) for value in values if value is not None}
    missing = any(value is None for value in values)
    if kinds == {int} and missing and all(abs(value or 0) < 2**63 for value in values):
        return pandas.Series(values, dtype="Int64")
    return pandas.Series(values, dtype=object if missing or not kinds <= {int, float, str, bool} else None)


def _is_exact(value: Any) -> bool:
    return isinstance(value, str) and _NUMBER.match(value) is not None


def _rounded(value: Any) -> Any:
    """The same with floats for Fractions, in pairs and lists too."""
    if isinstance(value, Fraction):
        return float(value)
    return tuple(map(_rounded, value)) if isinstance(value, tuple) and type(value) is tuple else value


def _plain(row: Any) -> dict[str, Any]:
    if dataclasses.is_dataclass(row):
        return {field.name: getattr(row, field.name) for field in dataclasses.fields(row)}
    return row._asdict() if hasattr(row, "_asdict") else dict(row)
