"""How work ends. An outcome is never a bool: ``if outcome:`` raises, as a "maybe" must not pass for a "yes"."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import _html


def same(one: Any, two: Any) -> bool:
    """Whether two values are equal; arrays entry by entry, where a NaN is as any other."""
    if isinstance(one, np.ndarray) and isinstance(two, np.ndarray):
        alike = one.dtype == two.dtype and one.shape == two.shape
        return alike and bool(np.array_equal(one, two, equal_nan=one.dtype.kind == "f"))
    if isinstance(one, np.ndarray) or isinstance(two, np.ndarray):
        return False
    if isinstance(one, list) and isinstance(two, list):
        return len(one) == len(two) and all(map(same, one, two))
    return bool(one == two)


class Record(Mapping[str, Any]):
    """Named values: ``record.name`` is ``record["name"]``, unless mappings have a method of that name, as
    ``values``. Records with the same names and equal values are equal, arrays entry by entry; a record that holds
    no list and no array can be hashed."""

    __slots__ = ("_values",)

    def __init__(self, values: Mapping[str, Any] | None = None) -> None:
        object.__setattr__(self, "_values", {k: _wrap(v) for k, v in (values or {}).items()})

    def __getitem__(self, name: str) -> Any:
        return self._values[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        try:
            return self._values[name]
        except KeyError:
            known = ", ".join(self._values) or "nothing"
            raise AttributeError(f"no {name!r} here; there is {known}") from None

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("a record is not changed")

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Mapping):
            return NotImplemented
        return self.keys() == other.keys() and all(same(value, other[name]) for name, value in self.items())

    def __hash__(self) -> int:
        return hash(frozenset(self._values.items()))

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._values]

    def __repr__(self) -> str:
        return "Record(" + ", ".join(f"{k}={_short(v)}" for k, v in self._values.items()) + ")"

    def __reduce__(self) -> tuple[Any, ...]:
        return (Record, (self._values,))


def _wrap(value: Any) -> Any:
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list):
        return [_wrap(entry) for entry in value]
    return value


def _short(value: Any) -> str:
    shape = getattr(value, "shape", None)
    if shape is not None and shape != ():
        return f"<{value.dtype} {shape}>"
    if isinstance(value, list) and len(value) > 6:
        return f"[{', '.join(map(_short, value[:3]))}, … {len(value)} in all]"
    return repr(value)


@dataclass(frozen=True)
class Outcome:
    """How a piece of work ended: one of the classes below. Use ``isinstance`` or ``match``."""

    #: What was to be proved or computed, in words.
    statement: str
    #: Counts and names that belong to it.
    details: Record = field(default_factory=Record, kw_only=True)

    def __bool__(self) -> bool:
        kind = type(self).__name__
        raise TypeError(
            f"an outcome is no bool, this one is {kind}: ask isinstance(outcome, grazing.Proved), since what is "
            "not proved may be refuted, undecided or not reached"
        )

    def why(self) -> str:
        """Why it is no better: witness, reason, budget, what is left, or the error; nothing for Proved and Done."""
        parts = (getattr(self, name, "") for name in ("witness", "reason", "budget", "left", "error"))
        return "; ".join(str(part) for part in parts if part)

    def _repr_html_(self) -> str:
        return _html.verdict(type(self).__name__, self.statement, self.why())


@dataclass(frozen=True)
class Proved(Outcome):
    """Proved, for all that the statement speaks of."""


@dataclass(frozen=True)
class Refuted(Outcome):
    """Certainly false; ``witness`` says where it fails."""

    witness: str = ""


@dataclass(frozen=True)
class Rejected(Outcome):
    """A certificate that proves nothing, as it is malformed or a claim in it fails; ``reason`` says where. Whether
    its statement holds is another question."""

    reason: str = ""


@dataclass(frozen=True)
class Undecided(Outcome):
    """Left open; ``budget`` says what was tried or spent."""

    budget: str = ""


@dataclass(frozen=True)
class Pending(Outcome):
    """Not reached, or not finished; ``left`` says what is left."""

    left: str = ""


@dataclass(frozen=True)
class Done(Outcome):
    """Computed. This is no proof."""


@dataclass(frozen=True)
class NothingFound(Outcome):
    """The search went through all that it was to go through, and there was nothing; ``reason`` says where."""

    reason: str = ""


@dataclass(frozen=True, eq=False)
class Failed(Outcome):
    """It could not be done; ``error`` says why."""

    error: Exception | None = None

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Failed):
            return NotImplemented
        kinds = type(self.error) is type(other.error)
        return kinds and str(self.error) == str(other.error) and super().__eq__(other)

    __hash__ = Outcome.__hash__
