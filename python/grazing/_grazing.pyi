"""The compiled part. Users have the package's functions and classes."""

import os
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any, final

import numpy as np
import numpy.typing as npt

__all__ = [
    "Scene",
    "__version__",
    "boundary",
    "check_file",
    "check_text",
    "classify",
    "classify_many",
    "decay",
    "evaluate",
    "existence",
    "forced",
    "fuzz",
    "intervals",
    "overflow",
    "shares",
    "verify",
    "word",
    "word_in_box",
]

__version__: str
_Exact = int | Fraction | Decimal | str
_Progress = Callable[[int, int, str], Any] | None
_Bounds = tuple[Fraction, Fraction]
_Proved = tuple[str, str, str, tuple[int, int] | None, list[tuple[str, str]], int]
_Row = tuple[int, str, tuple[tuple[int, int], ...], tuple[int, ...], int | None, int | None, int | None]
_Ends = tuple[_Exact, _Exact]
_Column = tuple[str, Any]
_Verdict = tuple[str, _Proved | None, str | None, int | None, str | None]

def check_file(path: str | os.PathLike[str]) -> _Verdict: ...
def check_text(text: bytes) -> _Verdict: ...
def overflow() -> int: ...
def verify(
    first: int, last: int, method: str, certificate: bool, progress: _Progress
) -> tuple[str, str | None, dict[str, int], str | None]: ...
def intervals(first: int, last: int, progress: _Progress) -> dict[str, npt.NDArray[np.int64]]: ...
def boundary(
    first: int, last: int, m: int | None, at: list[_Exact] | None, digits: int, progress: _Progress
) -> list[tuple[int, int, int, int, int | None, str, _Bounds | None, _Bounds | None]]: ...
def classify(first: _Exact, second: _Exact, polar: bool, max_n: int) -> tuple[str, bool, list[_Row]]: ...
def classify_many(
    first: _Column,
    second: _Column,
    polar: bool,
    skipped: npt.NDArray[np.bool_] | None,
    found: npt.NDArray[np.uint8],
    progress: _Progress,
) -> None: ...
def word(
    first: _Exact, second: _Exact, polar: bool, max_period: int, letters: int, certificate: str | None
) -> tuple[str, str | None, str | None]: ...
def word_in_box(
    first: _Ends, second: _Ends, kind: str, max_period: int, letters: int, certificate: str | None
) -> tuple[str, str | None, str | None]: ...
def shares(
    first: _Ends, second: _Ends, kind: str, cells: int, last: int, progress: _Progress
) -> str: ...
def decay(times: npt.NDArray[np.float64], displacements: npt.NDArray[np.float64]) -> str: ...
def evaluate(
    first: _Exact, second: _Exact, polar: bool, n: int, k: int | None, bits: int
) -> list[tuple[int | None, str, str, str | None]]: ...
def existence(
    text: str,
    name: str,
    pattern: list[int] | None,
    max_period: int,
    existing: bool,
    exact: bool,
    progress: _Progress,
) -> tuple[str, list[str]]: ...
def forced(what: str) -> Any: ...
def fuzz(
    first: int, last: int, cases: int, seed: int, definition_share: float, progress: _Progress
) -> str: ...
_Answer = tuple[
    str, str, dict[str, npt.NDArray[Any]], str | None, list[tuple[str, str]], tuple[str, int | None, bool] | None
]

@final
class Scene:
    @staticmethod
    def from_toml(text: str, name: str) -> Scene: ...
    @staticmethod
    def from_words(words: str) -> Scene: ...
    @property
    def title(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def is_machine(self) -> bool: ...
    @property
    def coordinates(self) -> int: ...
    @property
    def parameters(self) -> list[tuple[str, Fraction]]: ...
    @property
    def tasks(self) -> list[tuple[str, str | None, str, list[tuple[str, Fraction]]]]: ...
    def is_same(self, other: Scene) -> bool: ...
    def with_parameters(self, changes: list[tuple[str, _Exact]]) -> Scene: ...
    def check(self, task: int, changes: list[tuple[str, _Exact]]) -> None: ...
    def run(
        self, task: int, changes: list[tuple[str, _Exact]], folder: str | os.PathLike[str] | None, progress: _Progress
    ) -> _Answer: ...
    def answer(
        self, changes: list[tuple[str, _Exact]], progress: _Progress
    ) -> tuple[str, list[tuple[str, str]], list[_Answer]]: ...
    def simulate(
        self,
        starts: npt.NDArray[np.float64],
        varied: list[str],
        values: npt.NDArray[np.float64],
        phase: float,
        transient: int,
        every: int,
        points: npt.NDArray[np.float64],
        impacts: npt.NDArray[np.uint64],
        ends: npt.NDArray[np.uint8],
        progress: _Progress,
    ) -> None: ...
