"""What functions are given: exact numbers, periods, points, TOML sources; and files that are written whole.

Exact numbers are ``int``, ``fractions.Fraction``, ``decimal.Decimal``, or text as on the command line
(``"3/8"``, ``"0.375"``, ``"2^-10"``, ``"3/8+2^-200"``). Floats are refused there, since 0.2 is not 1/5; a parameter of a
scene takes them as a file does.
"""

from __future__ import annotations

import errno
import operator
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any, Union

import numpy as np

from ._errors import InputError, refused
from ._toml import to_toml

#: An exact number.
Exact = Union[int, Fraction, Decimal, str]
#: Periods: one, or a ``range`` (half-open, as always in Python), or text as on the command line: ``"3..=8"``.
Periods = Union[int, range, str]


def as_periods(periods: Periods) -> tuple[int, int]:
    """The first and the last period."""
    if isinstance(periods, str):
        first, dots, last = periods.partition("..=")
        try:
            ends = (int(first), int(last)) if dots else (int(first), int(first))
        except ValueError:
            raise InputError(f'periods = {periods!r}: write N, range(A, B + 1), or "A..=B"') from None
    elif isinstance(periods, range):
        if periods.step != 1 or not periods:
            raise InputError(f"periods = {periods!r}: a range with step 1 that is not empty")
        ends = periods[0], periods[-1]
    else:
        ends = periods, periods
    return natural("periods", ends[0]), natural("periods", ends[1])


def changes(given: Mapping[str, Exact | float] | None) -> list[tuple[str, Exact]]:
    """New values of a scene's parameters, a float by its shortest decimal, as it stands in a file: 0.8 is 4/5."""
    return [(name, _decimal(name, value)) for name, value in (given or {}).items()]


def _decimal(name: str, value: Any) -> Exact:
    if not isinstance(value, (float, np.floating)):
        return value  # type: ignore[no-any-return]
    if not np.isfinite(value):
        raise InputError(f"{name} = {value}: is not finite", key=name, value=str(value))
    return str(value)


def natural(name: str, value: Any) -> int:
    """A whole number that the compiled part takes."""
    number = -1 if isinstance(value, bool) else operator.index(value)
    if not 0 <= number < 2**63:
        raise InputError(f"{name} = {value!r}: a whole number from 0 up, below 2^63")
    return number


def point(a1: Any, a2: Any, r: Any, s: Any) -> tuple[Any, Any, bool]:
    """The pair that was given, and whether it is (r, s)."""
    given = [name for name, value in (("a1", a1), ("a2", a2), ("r", r), ("s", s)) if value is not None]
    if given == ["a1", "a2"]:
        return a1, a2, False
    if given == ["r", "s"]:
        return r, s, True
    raise TypeError(f"give a point by a1 and a2, or by r and s; given: {', '.join(given) or 'nothing'}")


def toml_source(
    source: str | os.PathLike[str] | Mapping[str, Any], defaults: Mapping[str, Any]
) -> tuple[str, str]:
    """Text and name of a TOML source: a path, a text with a line feed, or a dict."""
    if isinstance(source, Mapping):
        return to_toml({**defaults, **source}), "<dict>"
    if isinstance(source, str) and "\n" in source:
        return source, "<text>"
    path = os.fspath(source)
    try:
        return Path(path).read_text(encoding="utf-8"), path
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: is not UTF-8", file=path) from error
    except OSError as error:
        raise refused("open", path, error) from error


@contextmanager
def whole_file(path: str | os.PathLike[str] | None) -> Iterator[Callable[[str], None]]:
    """What writes the file, which appears only when complete; nothing, without a path. Whether it can be made is
    found out at once, before the work whose result it keeps."""
    if path is None:
        yield lambda text: None
        return
    target = Path(path)
    try:
        if target.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
    except OSError as error:
        raise refused("write", target, error) from error
    os.close(handle)

    def write(text: str) -> None:
        try:
            with open(name, "w", encoding="utf-8", newline="\n") as file:
                file.write(text)
                file.flush()
                os.fsync(file.fileno())
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(name, 0o666 & ~mask)
            os.replace(name, target)
        except OSError as error:
            raise refused("write", target, error) from error

    try:
        yield write
    finally:
        with suppress(FileNotFoundError):
            os.unlink(name)
