#!/usr/bin/env python3
"""Writes hard_cases.toml: inputs picked here, references by FLINT's ball arithmetic or Python's fractions.

    python3 -m venv venv && venv/bin/pip install python-flint==0.9.0
    venv/bin/python tests/data/make_hard_cases.py > tests/data/hard_cases.toml

From (r, s): equation (62), literally, in FLINT balls of 20000 bits. From (a1, a2): the recurrence for u_k and
equations (59), (60), in fractions. Neither shares a formula or a line of code with the crate.
"""
import re
from fractions import Fraction

import flint
from flint import arb, fmpq

flint.ctx.prec = 20000


def number(text):
    """12, 3/8, 2^-200, 10^9 and sums of such."""
    total = Fraction(0)
    for sign, term in re.findall(r"([+-]?)((?:\d+(?:\^-?\d+)?)(?:/\d+(?:\^\d+)?)?)", text.replace(" ", "")):
        value = Fraction(1)
        for i, part in enumerate(term.split("/")):
            base, _, exponent = part.partition("^")
            power = Fraction(int(base)) ** int(exponent or 1)
            value = value / power if i else value * power
        total += -value if sign == "-" else value
    return total


def rational(x):
    return arb(fmpq(x.numerator, x.denominator))


def by_polar(r, s, n, k):
    if (2 * n * s).denominator == 1:
        return "singular", None
    sine = lambda j: arb.sin_pi_fmpq(fmpq((2 * j * s).numerator, (2 * j * s).denominator))
    if k is None:
        cosine = arb.cos_pi_fmpq(fmpq((2 * n * s).numerator, (2 * n * s).denominator))
        power = rational(r) ** n
        value = -(rational(r) ** (1 - n)) * sine(1) * (1 - 2 * power * cosine + power * power) / sine(n)
    else:
        j = n - k
        exact_zero = r == 1 and ((k * s).denominator == 1 or (j * s).denominator == 1)
        if exact_zero:
            return "0", "0"
        rj = rational(r) ** j
        value = (rj * sine(n) - sine(k) - rational(r) ** n * sine(j)) / (rj * sine(n))
    assert value > 0 or value < 0, (r, s, n, k)
    return ("+" if value > 0 else "-"), value.str(40, radius=False)


def by_plane(a1, a2, n, k):
    u = [Fraction(0), Fraction(1)]
    while len(u) <= n + 1:
        u.append(a1 * u[-1] - a2 * u[-2])
    if u[n] == 0:
        return "singular", None
    if k is None:
        value = -(1 - u[n + 1] + a2 * u[n - 1] + a2**n) / u[n]
    else:
        value = (u[n] - u[k] - a2**k * u[n - k]) / u[n]
    if value == 0:
        return "0", "0"
    return ("+" if value > 0 else "-"), rational(value).str(40, radius=False)


CASES = []


def polar(name, r, s, n, *ks):
    for k in ks:
        expected, value = by_polar(number(r), number(s), n, k)
        CASES.append((name, [("r", r), ("s", s)], n, k, expected, value, "FLINT, 20000 bits, (62)"))


def plane(name, a1, a2, n, *ks):
    for k in ks:
        expected, value = by_plane(number(a1), number(a2), n, k)
        CASES.append((name, [("a1", a1), ("a2", a2)], n, k, expected, value, "fractions, (59) and (60)"))


for side in "+-":
    polar("near m/n, coprime", "1", f"2/7 {side} 2^-200", 7, 1, 3, 6, None)
    polar("near m/n, not coprime: a double zero", "1", f"1/3 {side} 2^-200", 6, 3)
    polar("near m/n, not coprime", "1", f"2/6 {side} 2^-200", 6, 1, 5, None)
    polar("near an odd multiple of 1/(2n): a pole", "1", f"3/14 {side} 2^-200", 7, 1, 3, 6, None)
    polar("near an odd multiple of 1/(2n): a finite limit", "1", f"3/18 {side} 2^-200", 9, 3, 6)
    polar("near m+/n+ for 3/8", "1", f"1/3 {side} 2^-200", 8, 3, 4, 7)
    polar("near m-/n- for 3/8", "1", f"2/5 {side} 2^-200", 8, 3, 5)
    polar("huge n near m/n", "1", f"123456789/1000000000 {side} 2^-200", 10**9, 1, 5 * 10**8, 10**9 - 1, None)
    polar("r < 1, near m/n", "1 - 2^-100", f"2/7 {side} 2^-200", 7, 1, 3, 6, None)
    polar("r < 1, near a double zero", "1 - 2^-100", f"1/3 {side} 2^-200", 6, 3)
    polar("r < 1, near a double zero", "9/10", f"1/3 {side} 2^-200", 6, 3, 1)
    polar("r near 1, beside m/n", "1 - 2^-100", f"3/8 {side} 2^-98", 8, 3, 4, 5)
    polar("r tiny, near m/k", "2^-30", f"1/4 {side} 2^-200", 9, 4, 8)
    plane("a1^2 - 4 a2 = +-2^-100", "1", f"1/4 {side} 2^-102", 9, 1, 7, None)
    plane("a1^2 - 4 a2 = +-2^-100", "-1", f"1/4 {side} 2^-102", 9, 1, 7, None)
    plane("close to a1 = a2 + 1", f"3/2 {side} 2^-100", "1/2", 10, 1, 5, None)
    plane("close to a1 = -(a2 + 1)", f"-3/2 {side} 2^-100", "1/2", 10, 1, 2, None)
    plane("close to a1 = -(a2 + 1)", f"-3/2 {side} 2^-100", "1/2", 9, 7, 2)
    plane("close to an iterate boundary", f"-1 {side} 2^-120", "9/10", 3, 1)
    plane("close to a singular boundary", f"-9/10 {side} 2^-120", "81/100", 6, 1, 2, None)
polar("generic", "1", "3/10", 7, 1, 3, None)
polar("generic", "9/10", "3/10", 7, 1, 3, None)
polar("huge n, r = 1", "1", "314159265358979/1000000000000000", 10**9, 1, 5 * 10**8, None)
polar("huge n, r near 1", "1 - 2^-30", "314159265358979/1000000000000000", 10**9, 1, 5 * 10**8, 10**9 - 1, None)
polar("huge n, r = 1 - 2^-100", "1 - 2^-100", "314159265358979/1000000000000000", 10**9, 1, 5 * 10**8, 10**9 - 1, None)
polar("huge n, r tiny", "2^-30", "314159265358979/1000000000000000", 10**9, 1, 10**9 - 1, None)
polar("r tiny", "2^-30", "3/10", 7, 1, 3, 6, None)
polar("s tiny", "1", "2^-200", 7, 1, 3, None)
polar("s tiny, r near 1", "1 - 2^-100", "2^-200", 7, 1, 3, None)
polar("exact zero at m/k", "1", "1/3", 7, 3, 4)
polar("exact zero at m/(n-k)", "1", "2/5", 7, 2, 5)
polar("singular: m/n", "1", "2/7", 7, 1, None)
polar("singular: odd multiple of 1/(2n)", "9/10", "3/14", 7, 1, None)
plane("a1^2 = 4 a2", "1", "1/4", 9, 1, 7, None)
plane("a1^2 = 4 a2", "-1", "1/4", 9, 1, 7, None)
plane("a1^2 = 4 a2 = 4", "2", "1", 5, 1, None)
plane("a1 = a2 + 1", "3/2", "1/2", 10, 1, 5, None)
plane("a1 = -(a2 + 1)", "-3/2", "1/2", 10, 1, 2, None)
plane("a1 = -(a2 + 1)", "-3/2", "1/2", 9, 1, 2, None)
plane("exact zero: a1 = -1", "-1", "9/10", 3, 1)
plane("exact zero: a1 = -a2", "-9/10", "9/10", 3, 2)
plane("singular: a1 = 0", "0", "1/2", 4, 1, None)
plane("singular: a1^2 = a2", "-9/10", "81/100", 6, 1, None)
plane("region 3, many steps", "19/10", "99/100", 400, 1, 200, 399, None)
plane("region 1", "3", "1/2", 40, 1, 20, 39, None)
plane("region 5", "-3", "1/2", 41, 1, 20, 39, None)

print("# Written by make_hard_cases.py; do not edit. expected: + - 0 singular; no k: c_n.")
for name, point, n, k, expected, value, source in CASES:
    print("\n[[case]]")
    print(f'name = "{name}"')
    for key, text in point:
        print(f'{key} = "{text}"')
    print(f"n = {n}")
    if k is not None:
        print(f"k = {k}")
    print(f'expected = "{expected}"')
    if value is not None:
        print(f'value = "{value}"')
        print(f'source = "{source}"')
