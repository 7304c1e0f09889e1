"""Frequency and damping ratio from a record, against the command line and against what a record was made of."""

import dataclasses
import json
import subprocess

import numpy as np
import pytest

import grazing


def record(root):
    return np.loadtxt(root / "examples/decay.csv", delimiter=",", skiprows=1, unpack=True)


def flat(found):
    """All numbers by their names; a value and its deviation as two."""
    return {
        f"{name}.{key}": number
        for name, value in found.items()
        for key, number in (value.items() if isinstance(value, dict) else [("", value)])
    }


@pytest.mark.parametrize("until", [None, 1.5])
def test_a_record_gives_the_command_lines_numbers(root, program, until):
    options = [] if until is None else ["--until", str(until)]
    command = [program, "decay", root / "examples/decay.csv", "--format", "json", *options]
    wanted = json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout)
    for key in ("format", "unit", "options"):
        del wanted[key]
    wanted |= wanted.pop("residuals")
    times, displacements = record(root)
    kept = times <= (until or times[-1])
    found = grazing.decay(times[kept], displacements[kept].tolist())
    assert isinstance(found.frequency, grazing.Estimate)
    assert flat(dataclasses.asdict(found)) == pytest.approx(flat(wanted), rel=1e-9)


def test_a_record_that_was_made_gives_what_it_was_made_of():
    rng = np.random.default_rng(7)
    t = np.linspace(3, 8, 1200)
    omega, zeta = 2 * np.pi * 4, 0.02
    x = 0.3 + np.exp(-zeta * omega * (t - 3)) * np.cos(omega * np.sqrt(1 - zeta**2) * (t - 3))
    found = grazing.decay(t, x + rng.normal(0, 0.01, t.size))
    for estimate, true in [(found.frequency, 4), (found.damping_ratio, zeta), (found.offset, 0.3)]:
        assert 0 < estimate.deviation < 0.01
        assert abs(estimate.value - true) < 5 * estimate.deviation
    assert found.amplitude == pytest.approx(1, abs=0.01) and found.rms == pytest.approx(0.01, rel=0.1)
    # What lies between samples of an array, such as every other column's, is not read.
    both = np.stack([x, -x], axis=1)
    assert grazing.decay(t, both[:, 0]) == grazing.decay(t, x)


@pytest.mark.parametrize(
    "times, displacements, said",
    [
        ([0, 1, 1], [1, 2, 3], r"times\[2\] = 1.0 is not after times\[1\]"),
        ([0, 1, 2], [1, 2], "3 times and 2 displacements"),
        ([0, 1, 2], [1, float("nan"), 2], r"displacements\[1\] is nan"),
        ([[0, 1]], [1, 2], r"times has shape \(1, 2\)"),
        (["now"], [1], "times is no array of numbers"),
        (np.ma.masked_array([0, 1], [0, 1]), [1, 2], "times has masked entries"),
        (np.arange(400) / 40, np.exp(np.arange(400) / 100) * np.cos(np.arange(400) / 5), "it grows"),
        ([0, 1], [1, 2], "2 samples"),
    ],
)
def test_what_is_no_free_decay_is_refused_with_the_reason(times, displacements, said):
    with pytest.raises(grazing.InputError, match=said):
        grazing.decay(times, displacements)
