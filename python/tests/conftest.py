"""What the tests share."""

import os
import signal
from pathlib import Path

import pytest

# What a shell starts in the background ignores Ctrl-C, and so would these tests.
signal.signal(signal.SIGINT, signal.default_int_handler)

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def root() -> Path:
    """The repository."""
    return ROOT


@pytest.fixture
def program(root):
    """The command line, beside which answers are read."""
    built = [root / "target" / profile / "grazing" for profile in ("debug", "release")]
    command = os.environ.get("GRAZING") or next((path for path in built if path.exists()), None)
    if command is None:
        pytest.skip("the command line is not built: run cargo build, or set GRAZING to the program")
    return command


#: A driven mass with a stop, as a dict.
MACHINE = {
    "title": "a driven mass and a stop",
    "parameters": {"F": 0.5},
    "system": {"damping": "1/10", "stiffness": "3/10", "forcing": [{"cos": "F"}]},
    "walls": [{"side": "upper", "offset": 1, "restitution": 0.8}],
    "tasks": [
        {"name": "first-touch", "kind": "grazing", "parameter": "F"},
        {"name": "after", "kind": "simulate", "group": "motion", "set": {"F": 0.8}, "start": {"q": 0}, "periods": 40},
    ],
}
