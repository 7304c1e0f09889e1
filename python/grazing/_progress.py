"""Progress of long work: a bar in a terminal or a notebook, or a callback of your own."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Union

#: Called with the units done, all units (0 if unknown) and their name, some times a second and once at the end.
Callback = Callable[[int, int, str], Any]
#: What the argument ``progress`` may be: ``None`` or ``False`` for nothing, ``True`` for a bar, or a callback.
Progress = Union[None, bool, Callback]


class Bar:
    """A bar on standard error, or in the output of a notebook's cell. It appears after half a second."""

    def __init__(self) -> None:
        self.start = time.monotonic()
        self.handle: Any = None
        self.width = 0

    def __call__(self, done: int, total: int, unit: str) -> None:
        if time.monotonic() - self.start < 0.5 and self.width == 0:
            return
        part = min(1.0, done / total) if total else 0.0
        count = f"{done} of {total} {unit}" if total else f"{done} {unit}"
        text = f"{'█' * int(20 * part):░<20} {count}, {time.monotonic() - self.start:.0f} s"
        if not self._in_notebook(text, part):
            sys.stderr.write("\r" + text.ljust(self.width))
            sys.stderr.flush()
        self.width = max(self.width, len(text))

    def _in_notebook(self, text: str, part: float) -> bool:
        shell = sys.modules.get("IPython")
        kernel = shell and shell.get_ipython()
        if kernel is None or not hasattr(kernel, "kernel"):
            return False
        from importlib import import_module

        shows: Any = import_module("IPython.display")
        shown = shows.HTML(f"<progress max='1' value='{part}'></progress> {text[21:]}")
        if self.handle is None:
            self.handle = shows.display(shown, display_id=True)
        else:
            self.handle.update(shown)
        return True

    def close(self) -> None:
        """Ends the line."""
        if self.width and self.handle is None:
            sys.stderr.write("\n")


@contextmanager
def shown(progress: Progress) -> Iterator[Callback | None]:
    """The callback for the argument ``progress``; the line of a bar is ended, however the work ends."""
    bar = _callback(progress)
    try:
        yield bar
    finally:
        if isinstance(bar, Bar):
            bar.close()


def _callback(progress: Progress) -> Callback | None:
    if progress is None or progress is False:
        return None
    if progress is True:
        return Bar()
    if not callable(progress):
        raise TypeError(f"progress = {progress!r}: True for a bar, or a function of (done, total, unit)")
    return progress
