#!/usr/bin/env python3
"""A second reader of certificates of kind theorem2, for whoever would rather trust 100 lines of Python.

usage: theorem2.py FILE…     prints "FILE: proved" or "FILE: rejected: line: reason"; exit code 1 if one is rejected.

Written from the format text alone (crates/checker/src/lib.rs and crates/checker/src/theorem2/mod.rs), by the plainest means: exact fractions, and every
sign by its definition. Slow: a line takes O(n) fractions.
"""
import re
import sys
from fractions import Fraction as F
from math import ceil, floor, gcd

HALF = F(1, 2)
STATEMENT = (
    "For r = 1, every period n in the range and every s in (0, 1/2): if s lies in an open interval of an orbit line then u_n is not 0 "
    "and (52) and (53) hold exactly for the listed signs of e*mu and gamma; if s is a listed singular point then u_n = 0, if a listed "
    "boundary point then some b_{n,k} = 0 and no two b_{n,k} have opposite signs; at every other s two b_{n,k} have strictly opposite "
    "signs or u_n = 0. The orbit lines of each n are exactly the intervals of Theorem 2 (for n = 1 and 2, of the summary by period). "
    "Nothing is claimed for r < 1.")


def need(condition, reason):
    if not condition:
        raise ValueError(reason)


def number(word, most):
    need(re.fullmatch(r"0|[1-9][0-9]*", word, re.ASCII) and len(word) <= 20 and int(word) <= most, f"a number up to {most}: {word}")
    return int(word)


def fraction(word, most):
    p, slash, q = word.partition("/")
    p, q = number(p, most), number(q, most)
    need(slash and 0 < q and p <= q and gcd(p, q) == 1, f"a fraction in lowest terms: {word}")
    return F(p, q)


def sine(j, s, inside):
    """The sign of sin(j pi s), just right of s if `inside`."""
    return 0 if not inside and (j * s).denominator == 1 else (-1) ** floor(j * s)


def b_sign(n, k, s, inside):
    """(B1), where u_n is not 0."""
    return -sine(k, s, inside) * sine(n - k, s, inside) * (-1) ** floor(n * s + HALF)


def c_sign(n, s):
    """(B2) on an interval; sin(2 pi s) > 0."""
    return -sine(n, s, True) * (-1) ** floor(n * s + HALF)


def free(j, left, right):
    """No integer strictly between j left and j right."""
    return floor(j * left) + 1 >= ceil(j * right)


def theorem(n):
    """Theorem 2's intervals."""
    if n == 1:
        return [(F(0), HALF, 1, -1), (F(0), HALF, -1, 1)]
    found = [(F(0), F(1, 2 * n), -1, 1)]
    for m in (m for m in range(1, n // 2 + 1) if gcd(m, n) == 1):
        n_plus = pow(m, -1, n)
        m_plus = (m * n_plus - 1) // n
        found.append((F(m_plus, n_plus) if m > 1 else F(1, 2 * n), F(m, n), 1, 1))
        if 2 * m < n:
            found.append((F(m, n), F(m - m_plus, n - n_plus), 1, -1))
    return found


def opposite(n, k, j, s, inside):
    need(b_sign(n, k, s, inside) == 1 and b_sign(n, j, s, inside) == -1, "not of opposite signs")


def claim(n, words, reached, point_next):
    """Proves a line; how far (0, 1/2) is tiled, whether a point comes next, and the interval of an orbit line."""
    index = lambda word: need(number(word, n - 1) > 0, "an index from 1") or int(word)
    signs = {"+": 1, "-": -1}
    if words[0] == "orbit" and len(words) == 5:
        left, right = (fraction(word, 2 * n) for word in words[1:3])
        need(words[3] in signs and words[4] in signs, "two signs")
        emu, gamma = signs[words[3]], signs[words[4]]
        need(n == 1 or not point_next and left == reached, "tiling")
        need(left < right <= HALF and free(2 * n, left, right), "u_n = 0 inside, or no interval")
        for k in range(1, n):
            need(free(k, left, right) and b_sign(n, k, left, True) == emu, f"b of {k}")
        need(c_sign(n, left) == emu * gamma, "c")
        return right, True, (left, right, emu, gamma)
    if words[0] == "stretch" and len(words) == 5:
        left, right = (fraction(word, 2 * n) for word in words[1:3])
        k, j = index(words[3]), index(words[4])
        need(n > 1 and not point_next and left == reached and left < right <= HALF, "tiling")
        need(all(free(i, left, right) for i in (2 * n, k, n - k, j, n - j)), "a zero inside")
        opposite(n, k, j, left, True)
        return right, True, None
    need(words[0] == "point" and len(words) > 2, "orbit, stretch or point")
    at, singular = fraction(words[1], 2 * n), False
    if words[2:] == ["singular"]:
        singular = True
    elif words[2] == "boundary" and len(words) == 4:
        k = index(words[3])
        all_signs = {b_sign(n, i, at, False) for i in range(1, n)}
        need(b_sign(n, k, at, False) == 0 and not {1, -1} <= all_signs, "no boundary")
    else:
        need(words[2] == "excluded" and len(words) == 5, "singular, boundary or excluded")
        opposite(n, index(words[3]), index(words[4]), at, False)
    need(n > 1 and point_next and at == reached and at < HALF, "tiling")
    need(singular == ((2 * n * at).denominator == 1), "whether u_n = 0")
    return at, False, None


def check(data):
    """Proves a certificate; an error names the line."""
    lines = data.split(b"\n")
    ended = [line.removesuffix(b"\r") for line in lines[:-1]] + [line for line in lines[-1:] if line]
    state = {"at": 0}

    def line():
        state["at"] += 1
        need(state["at"] <= len(ended), "the file ends")
        need(len(ended[state["at"] - 1]) <= 1000, "too long")
        return ended[state["at"] - 1].decode()

    def numbers(name, *most):
        words = line().split(" ")
        need(words[0] == name and len(words) == len(most) + 1, f"a line {name}")
        return [number(word, limit) for word, limit in zip(words[1:], most)]

    try:
        need(line() == "grazing-certificate 1" and line() == "kind theorem2", "the format and the kind")
        first, last = numbers("range", 200_000, 200_000)
        need(1 <= first <= last, "the range")
        claimed = line()
        need(line() == "statement " + STATEMENT, "the statement")
        for n in range(first, last + 1):
            period, count = numbers("n", 200_000, 10**7)
            need(period == n, "the period")
            reached, point_next, orbits = F(0), False, []
            for _ in range(count):
                reached, point_next, orbit = claim(n, line().split(" "), reached, point_next)
                orbits += [orbit] if orbit else []
            need(reached == HALF and point_next and orbits == theorem(n), "the whole of (0, 1/2), with Theorem 2's intervals")
        need(state["at"] == len(ended) and claimed == f"lines {len(ended) - 5}", "the number of lines")
    except (ValueError, IndexError) as error:
        return f"rejected: line {state['at']}: {error}"
    return "proved"


if __name__ == "__main__":
    answers = []
    for name in sys.argv[1:]:
        with open(name, "rb") as file:
            answers.append(check(file.read()))
        print(f"{name}: {answers[-1]}")
    sys.exit(any(answer != "proved" for answer in answers))
