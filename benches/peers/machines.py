"""The machines of benches/machines.rs by SciPy's solve_ivp with an event function: DOP853, rtol 1e-10.

Usage: machines.py [LARGEST]. Prints a CSV table: modes, ratio, impacts per period, nanoseconds per mode and quarter
period of the fastest mode. Machines whose modes times ratio exceed LARGEST (3000) are left out; those that chatter to
rest are only named, after a thousand impacts. Impacts of low velocity fall between its steps: then the machine passes
through the stop.
"""

import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

TAU, RESTITUTION = 2 * np.pi, 0.7
largest = float(sys.argv[1]) if len(sys.argv) > 1 else 3000


def measure(modes, ratio):
    part = np.ones(1) if modes == 1 else np.arange(modes) / (modes - 1)
    frequency = 1.3 * (ratio / 1.3) ** part
    row = np.where(np.arange(modes) % 2 == 0, 1.0, -1.0)
    offset = -0.4 / frequency[0] ** 2
    stiffness, damping = frequency**2, 0.04 * frequency

    def field(t, y):
        q, u = y[:modes], y[modes:]
        return np.concatenate([u, row * np.cos(t) - damping * u - stiffness * q])

    def gap(t, y):
        return row @ y[:modes] - offset

    gap.terminal, gap.direction = True, -1

    def follow(t, y, end):
        impacts = 0
        while t < end:
            flight = solve_ivp(field, (t, end), y, "DOP853", events=gap, rtol=1e-10, atol=1e-12)
            t, y = flight.t[-1], flight.y[:, -1].copy()
            if flight.status == 1:
                impacts += 1
                # The mass is 1 and the mobility of the stop is the number of modes.
                y[modes:] -= (1 + RESTITUTION) * (row @ y[modes:]) / modes * row
                if impacts > 1000:
                    # It chatters to rest, of which there is no end.
                    return t, y, None
        return t, y, impacts

    periods = 4
    t, y, first = follow(0.0, np.zeros(2 * modes), 2 * TAU)
    if first is None:
        return None
    clock = time.process_time()
    _, _, impacts = follow(t, y, (2 + periods) * TAU)
    spent = time.process_time() - clock
    if impacts is None:
        return None
    return impacts / periods, spent * 1e9 / (4 * ratio * periods * modes)


print("modes,ratio,impacts_per_period,ns_per_mode_quarter")
for modes in [1, 2, 10, 100, 200]:
    for ratio in [3.0, 30.0, 300.0]:
        if modes * ratio <= largest:
            found = measure(modes, ratio)
            shown = "chatters," if found is None else "{:.2f},{:.0f}".format(*found)
            print(f"{modes},{ratio:.0f},{shown}", flush=True)
