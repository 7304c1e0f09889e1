"""What the tests share."""

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
