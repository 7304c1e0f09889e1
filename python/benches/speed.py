"""What Python costs beside the command line, and many points and motions beside one at a time.

    python benches/speed.py path/to/grazing

Build the wheel and the command in the release profile, and let the machine be quiet. The times of a map and of
motions are the least of three, those of classifications are of one pass. Answers are compared: a wrong one ends
the bench. """

import csv
import subprocess
import sys
import tempfile
import time
from fractions import Fraction
from pathlib import Path

import numpy as np

import grazing

ROOT = Path(__file__).resolve().parents[2]
MAP = """
[[tasks]]
name = "map"
kind = "map"
parameter = "mu"
range = [-0.02, 0.02]
count = 120
second = "tau"
second_range = [0.5, 1]
second_count = 60
start = { phase = "1/2", q = 2.6 }
transient = 1000
points = 200
"""


def least(work, times=3):
    best, found = float("inf"), None
    for _ in range(times):
        start = time.perf_counter()
        found = work()
        best = min(best, time.perf_counter() - start)
    return best, found


def scene_text():
    text = (ROOT / "examples/scenes/nordmark-2001.toml").read_text()
    return text[: text.index("[[tasks]]")] + MAP


def batch(command):
    """The same map of attractors by the command line and by Scene.run."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(scene_text())
        line, _ = least(lambda: subprocess.run([command, "run", "-q", path, "-o", folder], check=True,
                                               stdout=subprocess.DEVNULL))
        python, report = least(lambda: grazing.Scene(path).run()[0])
        rows = list(csv.DictReader((Path(folder) / "map.csv").open()))
    periods = [int(row["period"] or 0) for row in rows]
    if [max(period, 0) for period in report.data.period.ravel().tolist()] != periods:
        raise SystemExit("the map differs from the command line's")
    print(f"map of {len(rows)} points: command line {line:.3f} s, Python {python:.3f} s, ratio {python / line:.3f}")


def classifications():
    """10⁶ points, periods 1 to 15 each."""
    rng = np.random.default_rng(1)
    count = 1_000_000
    r, s = np.sqrt(rng.uniform(0.1, 1, count)), rng.uniform(0.001, 0.499, count)
    seconds, found = least(lambda: grazing.classify_many(r=r, s=s, floats="binary"), 1)
    print(f"classify_many (r, s): {count} points, {seconds:.2f} s, {1e6 * seconds / count:.2f} µs per point")
    a1, a2 = rng.uniform(-2, 2, count), rng.uniform(0.01, 1, count)
    seconds, _ = least(lambda: grazing.classify_many(a1=a1, a2=a2, floats="binary"), 1)
    print(f"classify_many (a1, a2): {count} points, {seconds:.2f} s, {1e6 * seconds / count:.2f} µs per point")
    p = rng.integers(1, 499, count)
    seconds, exact = least(lambda: grazing.classify_many(r=grazing.Fractions(99, 100), s=grazing.Fractions(p, 1000)), 1)
    print(f"classify_many (r, s) of int64: {count} points, {seconds:.2f} s, {1e6 * seconds / count:.2f} µs per point")
    if (exact[:500] != grazing.classify_many(r="99/100", s=[Fraction(int(x), 1000) for x in p[:500]])).any():
        raise SystemExit("pairs of int64 and Fractions differ")
    few = 2000
    points = [(Fraction(x), Fraction(y)) for x, y in zip(r[:few], s[:few])]
    seconds, one = least(lambda: [grazing.classify(r=x, s=y) for x, y in points])
    print(f"classify one by one, 15 periods: {1e6 * seconds / few:.1f} µs per point")
    seconds, _ = least(lambda: [grazing.classify(r="0.95", s="3/8") for _ in points])
    print(f"classify one point of short decimals, 15 periods: {1e6 * seconds / few:.1f} µs")
    for row, many in zip(one, found):
        if [bool(e.cases) for e in row] != [0 < bits < 16 for bits in many.tolist()]:
            raise SystemExit("classify and classify_many differ")


def motions():
    """Many motions of the paper's oscillator, by one call and by calls of one."""
    scene = grazing.Scene(scene_text()).with_parameters(mu="0.003")
    starts = np.random.default_rng(1).uniform(-0.2, 0.2, (4096, 2)) + [0.5, 0.0]
    seconds, found = least(lambda: scene.simulate(starts, 0, transient=1000))
    lone = np.ascontiguousarray(starts[:16])
    alone, points = least(lambda: np.concatenate([scene.simulate(x, 0, transient=1000).points for x in lone]))
    if not np.array_equal(points, found.points[:16], equal_nan=True):
        raise SystemExit("motions together and alone differ")
    print(f"simulate: {1e9 * seconds / 4096e3:.0f} ns per motion and period together, {1e9 * alone / 16e3:.0f} alone")


def machines():
    """Many motions of two masses that hit each other, by one call and by calls of one."""
    text = (ROOT / "examples/machines/two-masses.toml").read_text()
    scene = grazing.Scene(text[: text.index("[[tasks]]")])
    starts = np.random.default_rng(1).uniform(0, 0.002, (256, 4))
    seconds, found = least(lambda: scene.simulate(starts, 0, transient=100))
    alone, points = least(lambda: np.concatenate([scene.simulate(x, 0, transient=100).points for x in starts[:16]]))
    if not np.array_equal(points, found.points[:16], equal_nan=True):
        raise SystemExit("motions of a machine together and alone differ")
    print(f"simulate, a machine of two coordinates: {1e6 * seconds / 25600:.1f} µs per motion and period together, "
          f"{1e6 * alone / 1600:.1f} alone")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    batch(sys.argv[1])
    classifications()
    motions()
    machines()
