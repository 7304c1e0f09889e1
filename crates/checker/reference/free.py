#!/usr/bin/env python3
"""A second reader of certificates of kinds orbit 3 and machine-orbit 2, for whoever would rather trust Python.

usage: free.py FILE…     prints "FILE: proved" or "FILE: rejected: reason"; exit code 1 if one is rejected.

Written from the form alone (the heads of crates/checker/src/orbit/mod.rs and crates/checker/src/machine/mod.rs). An oscillator is read as a
machine of one coordinate. Numbers are Python's whole numbers in units of 2^-200, every operation rounded outwards,
and the method is another one: the response is solved for in complex numbers, in the machine's own time; stability is
asked of the characteristic polynomial det(λ²M + λC + K), by Routh's array, not of the flow over a period; and 1 is no
multiplier if no ikΩ is a root, k a whole number: for a stable motion that is so, else each k up to a bound is tried.
"""
import hashlib
import re
import sys
from fractions import Fraction

BITS = 200
UNIT = 1 << BITS
MOST = Fraction(2**30)

STATEMENTS = {
    "orbit 3": (
        "Each coefficient of the system of this digest is an interval. Every oscillator whose coefficients lie in "
        "these intervals has exactly one motion without impacts that comes back after one period of the forcing: its "
        "equation of motion has exactly one solution of period 2 pi, and at all times every gap of that solution to a "
        "wall is positive. If the claim is stable, both multipliers of that motion lie strictly inside the unit "
        "circle; if unstable, one lies strictly outside."),
    "machine-orbit 2": (
        "For every choice of one number in each interval, the machine of this digest, M q'' + C q' + K q = f(t) with "
        "rigid stops, has a positive definite M and exactly one motion without impacts that comes back after one "
        "period of the forcing: its equation of motion has exactly one solution of that period, and at all times "
        "every gap of that solution to a stop is positive. If the claim is stable, all multipliers of that motion lie "
        "strictly inside the unit circle; if unstable, one lies strictly outside.")}


def need(condition, reason):
    if not condition:
        raise ValueError(reason)


class Range:
    """All numbers from lo to hi, in units."""
    __slots__ = ("lo", "hi")

    def __init__(self, lo, hi):
        self.lo, self.hi = lo, hi

    def __add__(self, other): return Range(self.lo + other.lo, self.hi + other.hi)
    def __sub__(self, other): return Range(self.lo - other.hi, self.hi - other.lo)
    def __neg__(self): return Range(-self.hi, -self.lo)

    def __mul__(self, other):
        ends = [x * y for x in (self.lo, self.hi) for y in (other.lo, other.hi)]
        return Range(min(ends) >> BITS, -(-max(ends) >> BITS))

    def __truediv__(self, other):
        need(other.positive() or other.negative(), "a divisor may be zero")
        pairs = [(x << BITS, y) for x in (self.lo, self.hi) for y in (other.lo, other.hi)]
        return Range(min(x // y for x, y in pairs), max(-(-x // y) for x, y in pairs))

    def square(self):
        low = 0 if self.lo <= 0 <= self.hi else min(self.lo**2, self.hi**2)
        return Range(low >> BITS, -(-max(self.lo**2, self.hi**2) >> BITS))

    def positive(self): return self.lo > 0
    def negative(self): return self.hi < 0
    def most(self): return Range(0, max(-self.lo, self.hi))


def number(x, y=None):
    """The range from one fraction to another."""
    low, high = Fraction(x), Fraction(x if y is None else y)
    return Range((low.numerator << BITS) // low.denominator, -((-high.numerator << BITS) // high.denominator))


ZERO, ONE, TWO = number(0), number(1), number(2)


class Complex:
    __slots__ = ("re", "im")

    def __init__(self, re, im):
        self.re, self.im = re, im

    def __add__(self, z): return Complex(self.re + z.re, self.im + z.im)
    def __sub__(self, z): return Complex(self.re - z.re, self.im - z.im)
    def __mul__(self, z): return Complex(self.re * z.re - self.im * z.im, self.re * z.im + self.im * z.re)

    def __truediv__(self, z):
        size, w = z.size(), self * Complex(z.re, -z.im)
        return Complex(w.re / size, w.im / size)

    def size(self): return self.re.square() + self.im.square()
    def certain(self): return self.size().positive()


def solved(rows, right):
    """x with rows x = right, by elimination; None where that may be singular."""
    n = len(rows)
    rows = [[*row, b] for row, b in zip(rows, right)]
    for j in range(n):
        best = max(range(j, n), key=lambda i: rows[i][j].size().lo)
        if not rows[best][j].certain():
            return None
        rows[j], rows[best] = rows[best], rows[j]
        rows[j] = [x / rows[j][j] for x in rows[j]]
        for i in range(n):
            if i != j:
                rows[i] = [x - rows[i][j] * y for x, y in zip(rows[i], rows[j])]
    return [row[n] for row in rows]


def arctan(n):
    """arctan 1/n, by its series."""
    total, term, k = 0, UNIT // n, 0
    while term:
        total += (-term if k % 2 else term) // (2 * k + 1)
        term, k = term // (n * n), k + 1
    return Range(total - 2 * k, total + 2 * k)


PI = number(16) * arctan(5) - number(4) * arctan(239)
TURN = TWO * PI


def circle(t):
    """cos t and sin t over a range: of its middle by their series, and no farther off than t is."""
    turns = (t.lo + t.hi) // (2 * TURN.lo)
    t = t - number(turns) * TURN
    middle, apart = Range((t.lo + t.hi) // 2, (t.lo + t.hi) // 2), (t.hi - t.lo) // 2 + 1
    sums, term, k = [ZERO, ZERO], ONE, 0
    while term.most().hi > 4 or k < 20:
        sums[k % 2] = sums[k % 2] + (-term if k % 4 > 1 else term)
        k += 1
        term = term * middle / number(k)
    # The terms alternate from here on and shrink.
    return [Range(max(x.lo - 8 - apart, -UNIT), min(x.hi + 8 + apart, UNIT)) for x in sums]


def whole(word, least, most):
    need(re.fullmatch("0|[1-9][0-9]{0,17}", word, re.ASCII), f"not a number: {word}")
    need(least <= int(word) <= most, f"a number from {least} to {most}: {word}")
    return int(word)


def power(word):
    """A power of ten in a unit."""
    need(word != "-0", "not a number: -0")
    size = whole(word.removeprefix("-"), 0, 99)
    return -size if word.startswith("-") else size


def decimal(word):
    need(re.fullmatch(r"-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?", word, re.ASCII) and word != "-0", f"not a decimal: {word}")
    value = Fraction(word)
    need(len(word.lstrip("-0.").replace(".", "")) <= 34 and len(word.partition(".")[2]) <= 34, f"too long: {word}")
    need(abs(value) < MOST, f"out of range: {word}")
    return value


def interval(word):
    low, dots, high = word.partition("..")
    need(dots, f"not an interval: {word}")
    low, high = decimal(low), decimal(high)
    need(low <= high, f"the ends are not in order: {word}")
    return low, high


class File:
    """A certificate, read line by line."""

    def __init__(self, text):
        self.lines = text.split("\n")
        need(self.lines.pop() == "" or not text.endswith("\n"), "an end")
        self.lines = text.removesuffix("\n").split("\n")
        self.at = 0
        need(self.line() == "grazing-certificate 1", "another format")
        kind = self.line()
        need(kind.startswith("kind ") and kind[5:] in STATEMENTS, "another kind")
        need(self.line() == "statement " + STATEMENTS[kind[5:]], "another statement")
        digest, = self.words("digest", 1)
        first = self.at
        self.read_oscillator() if kind == "kind orbit 3" else self.read_machine()
        own = "".join(line.removesuffix("\r") + "\n" for line in self.lines[first:self.at])
        need(hashlib.sha256(own.encode()).hexdigest() == digest, "another digest")
        impacts, self.claim = self.words("orbit", 2)
        whole(impacts, 0, 0)
        need(self.claim in ("stable", "unstable", "open"), "another claim")
        n = len(self.mass)
        if kind != "kind orbit 3":
            need(all(decimal(x) > 0 for x in self.words("scales", 2 * n, 4000)), "scales are above 0")
        count = whole(self.words("flight", 1)[0], 1, 1_000_000)
        waves = 1 + 2 * self.waves
        one = -(-(2 * n + 1)**3 // 4)
        work = waves * 4 * count if kind == "kind orbit 3" else (
            one * (8 * count + 20) + waves * (4 * count + 12))
        need(work <= 1_000_000, "too much work")
        self.pieces = [decimal(self.words("until", 1)[0]) for _ in range(count)]
        need(self.at == len(self.lines), "the file goes on")

    def line(self, most=1000):
        need(self.at < len(self.lines), "the file ends")
        line = self.lines[self.at].removesuffix("\r")
        need(len(line.encode()) <= most, "a line is too long")
        self.at += 1
        return line

    def words(self, name, count=None, most=1000):
        # A statement is a line of its own.
        first, *rest = self.line(most).split(" ")
        need(first == name, f"expected {name}, not {first}")
        need(all(rest) and (count is None or len(rest) == count), f"{name} has other words")
        return rest

    def one(self, name):
        return interval(self.words(name, 1)[0])

    def row(self, name, count):
        return [interval(x) for x in self.words(name, count, 4000)]

    def wave(self, n, least, most=1000):
        """k, and the coefficients of the cosine and of the sine."""
        k, *rest = self.words("harmonic", 1 + 2 * n, most)
        rest = [number(*interval(x)) for x in rest]
        self.waves += 1
        return whole(k, least, 1000), rest[:n], rest[n:]

    def stop(self, offset, restitution, count, least):
        need(interval(restitution)[0] >= 0, "a restitution is at least 0")
        return number(*interval(offset)), whole(count, 0, 1000), least

    def read_oscillator(self):
        self.waves, self.period = 0, TURN
        # Nothing is computed in other units than the listed ones.
        if self.at < len(self.lines) and self.lines[self.at].startswith("units "):
            length, parameter = (power(word) for word in self.words("units", 2))
            need(length and not parameter, "a unit of length that is 1, or one of no parameter")
        self.mass = [[ONE]]
        self.damping, self.stiffness = ([[number(*self.one(name))]] for name in ("damping", "stiffness"))
        self.force = [number(*self.one("force"))]
        self.forcing = [self.wave(1, 0) for _ in range(whole(self.words("forcing", 1)[0], 0, 1000))]
        self.stops = []
        for name, row in (("lower", ONE), ("upper", -ONE)):
            words = self.words(name)
            if words == ["none"]:
                continue
            need(len(words) == 3, f"{name} has other words")
            offset, count, _ = self.stop(*words, 0)
            waves = [self.wave(1, 0) for _ in range(count)]
            self.stops.append(([row], row * offset, [(k, row * a[0], row * b[0]) for k, a, b in waves]))

    def read_machine(self):
        self.waves, n = 0, whole(self.words("coordinates", 1)[0], 1, 8)
        self.period = number(*self.one("period"))
        power(*self.words("unit", 1))
        lower = [self.row("mass", i + 1) for i in range(n)]
        self.mass = [[number(*lower[max(i, j)][min(i, j)]) for j in range(n)] for i in range(n)]
        self.damping, self.stiffness = ([[number(*x) for x in self.row(name, n)] for _ in range(n)]
                                        for name in ("damping", "stiffness"))
        self.force = [number(*x) for x in self.row("force", n)]
        self.forcing = [self.wave(n, 1, 4000) for _ in range(whole(self.words("forcing", 1)[0], 0, 1000))]
        self.stops = []
        for _ in range(whole(self.words("stops", 1)[0], 0, 16)):
            offset, count, _ = self.stop(*self.words("stop", 3), 1)
            row = [number(*x) for x in self.row("direction", n)]
            waves = [self.wave(1, 1) for _ in range(count)]
            self.stops.append((row, offset, [(k, a[0], b[0]) for k, a, b in waves]))

    def check(self):
        need(self.period.positive(), "the period may not be positive")
        self.definite()
        self.omega = TURN / self.period
        gaps = self.gaps()
        roots = self.roots()
        need(roots == "stable" or self.alone(), "1 may be a multiplier")
        need(self.claim in (roots, "open"), f"the motion is not certainly {self.claim}")
        start = Fraction(0)
        need(number(self.pieces[-1]).lo >= TURN.hi, "the pieces stop before the period's end")
        for end in self.pieces:
            need(start < end, "the pieces do not follow one another")
            middle, half = number((start + end) / 2), number((end - start) / 2)
            around, whole = Range(-half.hi, half.hi), number(start, end)
            for terms in gaps:
                gap, slope, _ = self.sums(terms, middle)
                bend = self.sums(terms, whole)[2] * Range(0, half.square().hi) / TWO
                need((gap + slope * around + bend).positive(), f"a gap may not be positive before {float(end)}")
            start = end

    def definite(self):
        """M by its pivots; each row of a stop is not 0, M⁻¹ being definite, too."""
        rows, n = [list(row) for row in self.mass], len(self.mass)
        for j in range(n):
            need(rows[j][j].positive(), "the mass may not be positive definite")
            for i in range(j + 1, n):
                factor = rows[i][j] / rows[j][j]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[j])]
        for row, _, _ in self.stops:
            need(any(x.positive() or x.negative() for x in row), "a stop's row may be zero")

    def dynamic(self, k):
        """K − (kΩ)² M + i kΩ C."""
        w, n = number(k) * self.omega, len(self.mass)
        return [[Complex(self.stiffness[i][j] - w.square() * self.mass[i][j], w * self.damping[i][j])
                 for j in range(n)] for i in range(n)]

    def gaps(self):
        """For each stop its gap as k, a, b with a cos kθ + b sin kθ, θ the phase; k = 0 first."""
        answers = []
        for k, cos, sin in [(0, self.force, [ZERO] * len(self.force)), *self.forcing]:
            # a cos θ + b sin θ is the real part of (a − ib) e^iθ.
            load = [Complex(a, -b) for a, b in zip(cos, sin)] if k else [Complex(a, ZERO) for a in cos]
            answer = solved(self.dynamic(k), load)
            need(answer is not None, f"harmonic {k} may be in resonance")
            answers.append((k, answer))
        all = []
        for row, offset, waves in self.stops:
            terms = [(0, -offset, ZERO)] + [(k, -a, -b) for k, a, b in waves]
            for k, answer in answers:
                a = b = ZERO
                for w, z in zip(row, answer):
                    a, b = a + w * z.re, b - w * z.im
                terms.append((k, a, b))
            all.append(terms)
        return all

    @staticmethod
    def sums(terms, t):
        value, slope, bend = ZERO, ZERO, ZERO
        for k, a, b in terms:
            cos, sin = circle(number(k) * t)
            here = a * cos + b * sin
            value, slope = value + here, slope + number(k) * (b * cos - a * sin)
            bend = bend - number(k * k) * here
        return value, slope, bend

    def companion(self):
        """Of −M⁻¹K and −M⁻¹C, the matrix of (q, q′)."""
        n = len(self.mass)
        real = [[Complex(x, ZERO) for x in row] for row in self.mass]
        columns = []
        for matrix in (self.stiffness, self.damping):
            columns += [solved(real, [Complex(-row[j], ZERO) for row in matrix]) for j in range(n)]
        top = [[ONE if j == n + i else ZERO for j in range(2 * n)] for i in range(n)]
        return top + [[columns[j][i].re for j in range(2 * n)] for i in range(n)]

    def roots(self):
        """Where the roots of the characteristic polynomial are, by Routh's array; "open" where that is not certain."""
        a = self.companion()
        n = len(a)
        # Faddeev and LeVerrier.
        polynomial, power = [ONE], [[ZERO] * n for _ in range(n)]
        for k in range(1, n + 1):
            for i in range(n):
                power[i][i] = power[i][i] + polynomial[-1]
            power = [[sum((a[i][l] * power[l][j] for l in range(n)), ZERO) for j in range(n)] for i in range(n)]
            polynomial.append(-sum((power[i][i] for i in range(n)), ZERO) / number(k))
        above, below = polynomial[0::2], polynomial[1::2]
        first = [above[0]]
        while below:
            if not (below[0].positive() or below[0].negative()):
                # All roots in the left half plane need positive coefficients.
                return "unstable" if any(x.negative() for x in polynomial) else "open"
            first.append(below[0])
            factor = above[0] / below[0]
            padded = below[1:] + [ZERO] * (len(above) - len(below))
            above, below = below, [x - factor * y for x, y in zip(above[1:], padded)]
        return "stable" if all(x.positive() for x in first) else "unstable"

    def alone(self):
        """No ikΩ is a root: tried up to where (kΩ)² M outweighs the rest."""
        a, n = self.companion(), len(self.mass)
        stiffness, damping = (max(sum((x.most() for x in row[i:i + n]), ZERO).hi for row in a[n:]) for i in (0, n))
        k = 0
        while True:
            w = number(k) * self.omega
            if w.lo > 0 and (w.square() - w * Range(0, damping)).lo > stiffness:
                return True
            need(k < 10_000, "too many harmonics")
            if solved(self.dynamic(k), [Complex(ONE, ZERO)] * n) is None:
                return False
            k += 1


if __name__ == "__main__":
    good = True
    for name in sys.argv[1:]:
        try:
            with open(name, encoding="utf-8", newline="") as stream:
                File(stream.read()).check()
                print(f"{name}: proved")
        except ValueError as reason:
            good = False
            print(f"{name}: rejected: {reason}")
    sys.exit(not good)
