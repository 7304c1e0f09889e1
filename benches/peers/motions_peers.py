"""The motions of motions.py by a plain loop in C and by SciPy, as CSV with the columns of simulations.csv.

Usage: motions_peers.py C_PROGRAM REFERENCE [RUNS]: motions.c compiled, crates/study/src/simulations_reference.csv, and how many runs are
timed (5). SciPy's rows need numpy and scipy and are left out without. Each call of solve_ivp ends at an impact, found by its
event function; rebounds slower than 1e-9 onto a wall that presses are rest, until it presses no more. Impacts that are over
within a step fall between its steps: then the motion passes through the wall, and its count is too low.
"""

import csv
import math
import platform
import subprocess
import sys
import time

from computer import gcc, load, machine, quartiles
from motions import MOTIONS, PERIODS

AT_REST = 1e-9
MANY = 2000  # impacts: a motion with more of them is given up


def follow(m, method, tolerance):
    modes, row = m["modes"], np.array(m["row"])
    damping, stiffness, amplitude = (np.array(m[key]) for key in ("damping", "stiffness", "amplitude"))
    cubic, force, offset, wall, friction, width = (m[key] for key in ("cubic", "force", "offset", "wall", "friction", "width"))

    def field(t, y):
        q, u = y[:modes], y[modes:]
        rubbing = friction * np.tanh(u / width) if friction else 0.0
        return np.concatenate([u, -damping * u - stiffness * q - cubic * q**3 - rubbing + force + amplitude * math.cos(t)])

    def gap(t, y):
        return row @ y[:modes] - offset - wall * math.cos(t)

    def push(t, y):
        return row @ field(t, y)[modes:] + wall * math.cos(t)

    def on_wall(t):
        return np.array([offset + wall * math.cos(t), -wall * math.sin(t)])

    gap.terminal, gap.direction = True, -1
    t, end, y = 0.0, 2 * math.pi * PERIODS, np.array(m["start"] + [0.0] * modes)
    impacts = every = 0
    while t < end:
        flight = solve_ivp(field, (t, end), y, method, events=gap, rtol=tolerance, atol=tolerance / 100)
        t, y = flight.t[-1], flight.y[:, -1].copy()
        if flight.status != 1:
            break
        every += 1
        if every > MANY:
            return impacts, y
        rate = row @ y[modes:] + wall * math.sin(t)
        impacts += -rate > m["slowest"]
        y[modes:] -= (1 + m["restitution"]) * rate * row / (row @ row)
        if modes == 1 and -m["restitution"] * rate < AT_REST and push(t, y) < 0:
            late = t
            while late < end and push(late, on_wall(late)) <= 0:
                t, late = late, min(late + 0.05, end)
            t = brentq(lambda x: push(x, on_wall(x)), t, late, xtol=1e-14) if late < end else end
            y = on_wall(t)
            # At the release itself the wall still presses, by rounding.
            t += 1e-12
    return impacts, y


def rows_of_c(program, runs):
    lines = "".join(line for line in lines_for_c())
    done = subprocess.run([program, str(PERIODS), str(runs)], input=lines, capture_output=True, text=True, check=True)
    for line in done.stdout.splitlines():
        name, steps, impacts, times, state = line.split("|")
        yield name, "C, RK4", f"{steps} steps", int(impacts), [float(x) for x in state.split()], [float(x) for x in times.split()]


def lines_for_c():
    done = subprocess.run([sys.executable, __file__.replace("motions_peers", "motions")], capture_output=True, text=True, check=True)
    return done.stdout.splitlines(keepends=True)


def rows_of_scipy(runs):
    for m in MOTIONS:
        for method, tolerances in [("DOP853", (1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13)), ("Radau", (1e-3, 1e-5, 1e-7, 1e-9))]:
            for tolerance in tolerances:
                times = []
                for _ in range(runs):
                    start = time.perf_counter()
                    impacts, y = follow(m, method, tolerance)
                    times.append((time.perf_counter() - start) * 1e9 / PERIODS)
                    # Slow ones need fewer runs.
                    if sum(times) * PERIODS > 2e9:
                        break
                yield m["name"], f"SciPy {method}", f"{tolerance:.0e}".replace("e-0", "e-"), impacts, list(y), times


program, reference = sys.argv[1:3]
runs = int(sys.argv[3]) if len(sys.argv) > 3 else 5
known = {row["motion"]: (int(row["impacts"]), [float(x) for x in row["state"].split()]) for row in csv.DictReader(open(reference))}
out = csv.writer(sys.stdout, lineterminator="\n")
out.writerow("motion,method,setting,error,impacts,missed,time_ns,q25,q75,load,by,machine".split(","))
sources = [(rows_of_c(program, runs), f"{gcc()} -O2")]
try:
    import numpy as np
    import scipy
    from scipy.integrate import solve_ivp
    from scipy.optimize import brentq

    sources.append((rows_of_scipy(runs), f"SciPy {scipy.__version__}, Python {platform.python_version()}"))
except ImportError:
    print("scipy is not installed: its rows are left out", file=sys.stderr)
for rows, by in sources:
    for name, method, setting, impacts, state, times in rows:
        wanted, end = known[name]
        error = max(abs(x - y) for x, y in zip(state, end))
        out.writerow([name, method, setting, f"{error:.1e}", impacts, wanted - impacts, *quartiles(times), load(), by, machine()])
        sys.stdout.flush()
