#!/usr/bin/env python3
"""Writes elementary.csv: function, p, e, f(p 2^e) by FLINT, for the tests of exp, sin, cos and sqrt.

    python3 -m venv venv && venv/bin/pip install python-flint==0.9.0
    venv/bin/python crates/number/tests/data/make_elementary.py > crates/number/tests/data/elementary.csv

The first lines of each function to 1300 digits, the rest to 60; every digit but the last is right.
"""
import random

from flint import arb, ctx, fmpz

ctx.prec = 12000
random.seed(2)

PI = int((arb.pi() * arb(2) ** 200).floor().unique_fmpz())
BITS = 53
# p 2^e: ordinary, tiny, near a multiple of pi/2, large.
POINTS = [(1, 0), (-3, -1), (7, 5), (PI, -200), (3 * PI, -201), (12345, -900)]
for i in range(120):
    size = [4, 30, BITS][i % 3]
    POINTS.append((random.randrange(-(2**size), 2**size) or 1, random.randrange(-size - 10, 12 - size)))
for i in range(40):
    n = random.randrange(1, 2 ** random.randrange(1, 20))
    POINTS.append((n * PI >> random.randrange(100, 190), 0))
for i in range(40):
    shift = random.randrange(1, 147)
    POINTS.append((random.choice([-1, 1]) * (random.randrange(1, 50) * PI >> shift), shift - 201))

for name in ("exp", "sin", "cos", "sqrt"):
    for index, (p, e) in enumerate(POINTS):
        x = arb(fmpz(p)) * arb(2) ** e
        if (name == "sqrt" and p < 0) or (name == "exp" and abs(x) > 10000):
            continue
        value = getattr(x, name)()
        print(f"{name},{p},{e},{value.str(1300 if index < 6 else 60, radius=False)}")
