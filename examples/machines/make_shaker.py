#!/usr/bin/env python3
"""Writes shaker.csv, the force of shaker-record.toml. It is synthetic: no shaker was measured.

A cycle of 20 ms, three of them, as a load cell on a shaker would see it: a fundamental, the second and third
harmonics that a shaker's suspension adds, a spike after each reversal, and noise of 0.1 N from a fixed seed.
Times are those of a logger whose clock jitters by 5 µs. Times in seconds, forces in newtons.
"""

import math
import pathlib
import random

random.seed(1)
rows = []
for i in range(300):
    time = i * 2e-4 + (random.uniform(-5e-6, 5e-6) if i else 0.0)
    phase = 2 * math.pi * time / 0.02
    force = 18 * math.cos(phase) + 2.5 * math.cos(2 * phase + 0.4) - 1.2 * math.sin(3 * phase)
    force += 1.5 * math.exp(-(((phase / (2 * math.pi)) % 1 - 0.3) / 0.03) ** 2)
    rows.append(f"{time:.6f},{force + random.gauss(0, 0.1):.3f}")
path = pathlib.Path(__file__).with_name("shaker.csv")
path.write_text("# synthetic, written by make_shaker.py: seconds, newtons\ntime,force\n" + "\n".join(rows) + "\n")
