"""Sums up what operations.c and operations/src/main.rs print: for each operation and length the fastest of each library in nanoseconds,
and the others' times over ours.

Usage: operations.py LINES. Fails if two enclosures of one result do not meet.
"""

import sys
from fractions import Fraction

from computer import arb, gcc, load, machine

times, ends = {}, {}
for line in open(sys.argv[1]):
    library, operation, bits, ns, low, high = line.split()
    key = library, operation, int(bits)
    times[key] = min(times.get(key, float("inf")), float(ns))
    low, high = Fraction(low), Fraction(high)
    assert low <= high, line
    bounds = ends.setdefault(operation, [low, high])
    bounds[:] = max(bounds[0], low), min(bounds[1], high)
    assert bounds[0] <= bounds[1], f"{operation}: enclosures that do not meet: {line}"
print(f"{arb()}, {gcc()}; {machine()}; load {load()}")


def table(title, ours, others, lengths, operations):
    print(f"\n{title}\n{'':10} {'bits':>5} {'here ns':>10}" + "".join(f" {other + ' ns':>13} {'ratio':>6}" for other in others))
    for operation in operations:
        for bits in lengths:
            here = times[ours, operation, bits]
            row = f"{operation:10} {bits:5} {here:10.1f}"
            for other in others:
                ns = times.get((other, operation, bits))
                row += f" {ns:13.1f} {ns / here:6.2f}" if ns else f" {'':13} {'':6}"
            print(row)


OPERATIONS = ["sum", "product", "quotient", "sinpi", "exp", "log", "sin", "tan", "atan", "sinh", "pow"]
table("f64 intervals", "grazing-number-interval", ["inari", "arb", "nfloat"], [53], OPERATIONS)
table("balls", "grazing-number", ["arb", "nfloat", "malachite"], [53, 128, 256, 1024, 4096], OPERATIONS)
