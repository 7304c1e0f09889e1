#!/usr/bin/env python3
"""Checks the cylinders of the article's theorem on the suprema of the entropy, in exact fractions.

Usage: python3 suprema.py      (standard library only; exit code 1 if a bound fails)

For a prefix of words, all continuations are bounded by one matrix M(z) at a rational z just above the root z* of the
case: the pattern graph of the prefix, its last pair joined both ways, and one more vertex for all later periods. A
positive rational v with M v < v proves that the spectral radius is below 1. Floats only guess v.
"""
from fractions import Fraction
from math import ceil
import sys

STEP = Fraction(1, 10**8)


def root(f):
    """The least multiple of STEP where f, which increases from f(0) < 0, is positive."""
    low, high = 0, 10**8
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if f(middle * STEP) > 0 else (middle, high)
    return high * STEP


def graph(first_upper, word):
    """The periods with their letters; which member of a pair of a lower and an upper one is renewed first; the last pair."""
    periods = [(1, "D"), (first_upper, "U")]
    lower, upper = 0, 1
    renewed = []
    for letter in word:
        periods.append((periods[lower][0] + periods[upper][0], letter))
        if letter == "D":
            renewed.append(lower)
            lower = len(periods) - 1
        else:
            renewed.append(upper)
            upper = len(periods) - 1
    return periods, renewed, (lower, upper)


def edge(letters, renewed, gamma, x, y):
    """Whether y may follow x, for the sign gamma; None for pairs of which none is renewed: the last one."""
    if letters[x] == letters[y]:
        return (letters[x] == "U") == (gamma > 0)
    first = next((z for z in renewed if z in (x, y)), None)
    return None if first is None else (letters[first] == "U") == (gamma > 0)


def matrix(first_upper, word, gamma, z, finite):
    periods, renewed, (lower, upper) = graph(first_upper, word)
    n, letters = len(periods), [letter for _, letter in periods]
    weights = [z**period for period, _ in periods]
    if not finite:
        a, b = periods[lower][0], periods[upper][0]
        weights.append(z ** (a + b) / (1 - z ** min(a, b)))
    rows = []
    for x in range(len(weights)):
        row = []
        for y, weight in enumerate(weights):
            joined = True if max(x, y) == n else edge(letters, renewed, gamma, x, y)
            if joined is None:  # the last pair of a word that ends has one edge, from the side without loops
                joined = letters[x] == ("D" if gamma > 0 else "U") if finite else True
            row.append(weight if joined else Fraction(0))
        rows.append(row)
    return rows


def below_one(rows):
    """Whether a witness shows that the spectral radius is below 1; an upper bound of it, in millionths."""
    n, floats = len(rows), [[float(x) for x in row] for row in rows]
    v = [1.0] * n
    for _ in range(2000):
        w = [sum(a * x for a, x in zip(row, v)) for row in floats]
        v = [x / max(w) + 1e-9 for x in w]
    v = [Fraction(x).limit_denominator(10**9) for x in v]
    bound = max(sum(a * x for a, x in zip(row, v)) / y for row, y in zip(rows, v))
    return bound < 1, ceil(bound * 10**6)


CASES = [
    ("(+,-)", -1, lambda z: z + z**2 + z**3 - 1,
     [(2, "U"), (2, "DU"), (2, "DDU"), (2, "DDDU"), (2, "DDDDU"), (2, "DDDDDU"), (3, "")], []),
    ("(+,+)", 1, lambda z: (1 + z**4) * (z**3 / (1 - z**4) + z**2 / (1 - z**3)) - 1 if z < 1 else Fraction(1),
     [(2, "D"), (2, "UDD"), (2, "UDUD"), (2, "UDUUD"), (2, "UDUUUD"), (3, "UD"), (3, "UUD"), (4, "")],
     [(2, ""), (2, "U"), (2, "UD"), (3, ""), (3, "U"), (3, "UU")]),
]

failed = False
for case, gamma, equation, cylinders, words in CASES:
    z = root(equation)
    print(f"case {case}: z = {z}, above the root by less than {STEP}")
    for finite, list_of in ((False, cylinders), (True, words)):
        for first_upper, word in list_of:
            good, bound = below_one(matrix(first_upper, word, gamma, z, finite))
            failed = failed or not good
            what = "word" if finite else "cylinder"
            more = " and every larger K" if not finite and (case, first_upper) in (("(+,-)", 3), ("(+,+)", 4)) else ""
            verdict = "proved" if good else "NOT proved"
            name = word or ("without letters" if finite else "of all words")
            print(f"  K = {first_upper}{more}, {what} {name}: radius at most {bound} / 10^6, {verdict}")
sys.exit(failed)
