"""What can go wrong. Every error of the library is a :class:`Error`; Ctrl-C is Python's ``KeyboardInterrupt``."""

from __future__ import annotations

import os
import warnings
from typing import Any


class Error(Exception):
    """An error of the library.

    ``str(error)`` is one line that names the thing at fault, its value and, where there is one, the fix. The
    parts, where they are known, are attributes:

    ``file``: the file, as it was named; ``line``: counted from 1; ``key``: the key of the scene or map;
    ``value``: its value as text; ``problem``: what is wrong with it; ``fix``: what would do, if the message
    says so after a semicolon.
    """

    file: str | None
    line: int | None
    key: str | None
    value: str | None
    problem: str
    fix: str | None

    def __init__(
        self,
        message: str,
        *,
        file: str | None = None,
        line: int | None = None,
        key: str | None = None,
        value: str | None = None,
        problem: str | None = None,
    ) -> None:
        super().__init__(message)
        self.file, self.line, self.key, self.value = file, line, key, value
        self.problem = message if problem is None else problem
        before, semicolon, after = self.problem.rpartition("; ")
        self.fix = after if semicolon and before else None

    def __str__(self) -> str:
        # An OSError's own text has its number and its file once more.
        return str(self.args[0])

    def __reduce__(self) -> tuple[Any, ...]:
        parts = dict(self.__dict__)
        if isinstance(self, OSError):
            parts.update(errno=self.errno, filename=self.filename, strerror=self.strerror)
        return (_again, (type(self), str(self), parts))


def _again(kind: type[Error], message: str, parts: dict[str, Any]) -> Error:
    """The error that was pickled, all its parts with it."""
    error = kind(message)
    for name, value in parts.items():
        setattr(error, name, value)
    return error


class InputError(Error, ValueError):
    """A value that the caller gave is outside what the function is defined for."""


class NumberOverflowError(Error, OverflowError):
    """A result does not fit its integer type."""


class FileError(Error, OSError):
    """A file cannot be opened, read or written. ``errno`` is the system's number, where there is one."""


class InterruptedWork(Error):
    """The work was ended before it was done."""


class InternalError(Error, RuntimeError):
    """A fault of the library itself: please report it."""


class ForkedError(Error, RuntimeError):
    """This process was forked from one in which the library had threads, and has none of them: start processes
    with ``multiprocessing.get_context("spawn")``."""


class MissingPackageError(Error, ImportError):
    """An optional package is not installed; the message says which and how to get it."""


class GrazingWarning(UserWarning):
    """Something that a reader should know before trusting the numbers."""


_KINDS: dict[str, type[Error]] = {
    "input": InputError,
    "overflow": NumberOverflowError,
    "io": FileError,
    "interrupted": InterruptedWork,
    "internal": InternalError,
    "forked": ForkedError,
}


def exception(
    kind: str,
    message: str,
    file: str | None,
    line: int | None,
    key: str | None,
    value: str | None,
    problem: str | None,
    number: int | None,
) -> Error:
    """The exception for an error of the compiled part."""
    error = _KINDS[kind](message, file=file, line=line, key=key, value=value, problem=problem)
    if isinstance(error, OSError):
        error.errno, error.filename = number, file
        error.strerror = message if number is None else os.strerror(number)
    return error


def refused(action: str, path: str | os.PathLike[str], cause: OSError) -> FileError:
    """The system refused ``action`` (as in "write", "open") on ``path``."""
    file = os.fspath(path)
    error = FileError(f"cannot {action} {file}: {cause.strerror}", file=file)
    error.errno, error.filename, error.strerror = cause.errno, file, cause.strerror
    return error


def warn(message: str) -> None:
    """Shows a note of the compiled part."""
    warnings.warn(message, GrazingWarning, stacklevel=3)
