"""pandas frames of results, where pandas is installed."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping
from typing import Any

from ._errors import MissingPackageError


def frame(rows: Iterable[Any] | Mapping[str, Any]) -> Any:
    """A ``pandas.DataFrame`` of rows (dataclasses or mappings), or of columns by name."""
    try:
        import pandas  # type: ignore[import-untyped, unused-ignore]
    except ImportError:
        raise MissingPackageError(
            "frames need the package pandas, which is not installed; pip install 'grazing[frames]', or use the "
            "rows themselves"
        ) from None
    if isinstance(rows, Mapping):
        return pandas.DataFrame(dict(rows))
    return pandas.DataFrame([_plain(row) for row in rows])


def _plain(row: Any) -> dict[str, Any]:
    if dataclasses.is_dataclass(row):
        return {field.name: getattr(row, field.name) for field in dataclasses.fields(row)}
    return row._asdict() if hasattr(row, "_asdict") else dict(row)
