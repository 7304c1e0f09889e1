#!/usr/bin/env python3
"""Writes sines.csv: P/Q, sin(pi P/Q) by FLINT, for the tests of the enclosures.

    python3 -m venv venv && venv/bin/pip install python-flint==0.9.0
    venv/bin/python crates/number/tests/data/make_sines.py > crates/number/tests/data/sines.csv

The first lines to 1300 digits, the rest to 60; every digit but the last is right.
"""
import random

from flint import arb, ctx, fmpq

ctx.prec = 6000
random.seed(1)


def line(x, digits):
    print(f"{x.p}/{x.q},{arb.sin_pi_fmpq(x).str(digits, radius=False)}")


for p, q in [(1, 7), (5, 11), (2**70 + 1, 3**60), (1, 10**40), (10**9 - 1, 2 * 10**9), (355, 113)]:
    line(fmpq(p, q), 1300)
for i in range(400):
    q = random.randrange(2, [100, 10**6, 2**61, 10**30][i % 4])
    p = random.randrange(-3 * q, 3 * q)
    line(fmpq(p, q), 60)
for bits in (30, 60, 100, 200):
    for base in (fmpq(1, 4), fmpq(1, 2), fmpq(1, 6), fmpq(1), fmpq(3, 2), fmpq(0)):
        for side in (1, -1):
            line(base + side * fmpq(1, 2**bits), 60)
