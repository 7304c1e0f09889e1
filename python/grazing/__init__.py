"""Proofs and computations for periodic orbits in grazing bifurcations of impact oscillators.

The functions are those of the command line ``grazing``: :func:`check`, :func:`verify`, :func:`intervals`,
:func:`classify` (:func:`classify_many` for arrays), :func:`word`, :func:`evaluate`, :func:`boundary`,
:func:`existence`, :func:`decay`, :func:`fuzz`; :class:`Scene` for oscillators and machines, and :func:`machine` for
one that is typed in a line. Numbers are exact: ``int``, ``Fraction``, ``Decimal``, or text such as ``"3/8+2^-200"``.
Work that ends in a proof, or not, gives an :class:`Outcome`, which is never a bool.

>>> import grazing
>>> [str(i.left) for i in grazing.intervals(5)]
['0', '1/10', '1/5', '1/3', '2/5']
>>> grazing.classify(r="0.95", s="3/8")[4].verdict
'orbit'
"""

from pathlib import Path as _Path

from ._arrays import Fractions
from ._boxes import Share, Shares, shares
from ._decay import Decay, Estimate, decay
from ._errors import (
    Error,
    FileError,
    ForkedError,
    GrazingWarning,
    InputError,
    InternalError,
    InterruptedWork,
    MissingPackageError,
    NumberOverflowError,
)
from ._frames import frame
from ._grazing import __version__
from ._motions import End, Motions
from ._outcomes import Done, Failed, NothingFound, Outcome, Pending, Proved, Record, Refuted, Rejected, Undecided
from ._places import (
    Case,
    Classification,
    Existence,
    Value,
    Word,
    WordCase,
    WordReport,
    classify,
    classify_many,
    evaluate,
    word,
)
from ._proofs import Edge, Interval, Intervals, boundary, check, intervals, verify
from ._scene import EVENT_KINDS, Answer, Run, Scene, Task, TaskReport, machine, simulate
from ._theory import FuzzReport, PatternReport, existence, fuzz
from ._tolerances import Tolerance, ToleranceRange, ToleranceResonance, ToleranceSide

#: The style of the project's figures: ``matplotlib.pyplot.style.use(grazing.STYLE)``.
STYLE = str(_Path(__file__).with_name("grazing.mplstyle"))

__all__ = [
    "Answer", "Case", "Classification", "Decay", "Done", "EVENT_KINDS", "Edge", "End", "Error", "Estimate",
    "Existence", "Failed", "FileError", "ForkedError", "Fractions", "FuzzReport", "GrazingWarning", "InputError",
    "InternalError", "InterruptedWork", "Interval", "Intervals", "MissingPackageError", "Motions",
    "NothingFound", "NumberOverflowError", "Outcome", "PatternReport", "Pending", "Proved", "Record",
    "Refuted", "Rejected", "Run", "STYLE", "Scene", "Share", "Shares", "Task", "TaskReport", "Tolerance",
    "ToleranceRange", "ToleranceResonance", "ToleranceSide", "Undecided", "Value", "Word", "WordCase",
    "WordReport", "__version__", "boundary", "check", "classify", "classify_many", "decay", "evaluate",
    "existence", "frame", "fuzz", "intervals", "machine", "shares", "simulate", "verify", "word",
]
