"""The same scene by SciPy's DOP853 with an event function, timed. Usage: simulation.py [PERIODS]. Prints: impacts microseconds_per_period.
Impacts of low velocity fall between its steps: then the oscillator passes through the wall, and the count is too low."""

import math
import sys
import time

from scipy.integrate import solve_ivp

d, w, mu, tau = 0.6, 4.9, 0.003, 1.0
periods = int(sys.argv[1]) if len(sys.argv) > 1 else 1000


def field(t, y):
    return y[1], -2 * d / w * y[1] - y[0] / w**2


def gap(t, y):
    return y[0] + 1 - (1 + mu) * math.cos(t)


gap.terminal, gap.direction = True, -1
t, y, end, impacts = 1.0, [0.01, 0.0], 2 * math.pi * periods, 0
start = time.process_time()
while t < end:
    flight = solve_ivp(field, (t, end), y, "DOP853", events=gap, rtol=1e-10, atol=1e-12)
    t, y = flight.t[-1], list(flight.y[:, -1])
    if flight.status == 1:
        impacts += 1
        y[1] = -tau * y[1] - (1 + tau) * (1 + mu) * math.sin(t)
seconds = time.process_time() - start
print(impacts, f"{seconds * 1e6 / periods:.1f}")
