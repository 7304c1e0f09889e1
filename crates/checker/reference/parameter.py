#!/usr/bin/env python3
"""A second reader of certificates of kind parameter, for whoever would rather trust Python.

usage: parameter.py FILE…     prints "FILE: proved, TITLE" with the title of the certificate that is in it, or "FILE:
                              rejected: reason"; exit code 1 if one is rejected.

Written from the form alone (the head of crates/checker/src/parameter/mod.rs). The certificate that follows is read by
range.py, single.py, nothing.py or attractor.py. All else is in fractions: coefficients lie between two of them, and so do derivatives,
by the rules of calculus. Of one harmonic no root is taken: (M/H)² is compared with (1 ± nu)². The range is cut in
halves until a sign is known, whatever the pieces are that the file lists.
"""
import importlib
import re
from fractions import Fraction

import branch
import chaos
from branch import decimal, whole
from chaos import BITS, CIRCLE, ONE, ZERO, fraction, need, number

HEADS = (
    "For every p between the touch and the last listed P, P included, or, where no touch is listed, from the value that "
    "stands for it on, consider, with its coefficients the listed quotients of polynomials in p, ",
    "For every choice of one number in each interval of the system of this digest and every p between the touch and the "
    "last listed P, P included, or, where no touch is listed, from the value that stands for it on, consider ")
SEEN = (
    "the oscillator q'' = -c q' - k q + F + f(t) above its lower wall or below its upper one or between both, with "
    "restitution tau. Let h be its motion without walls, the sum of harmonics that answers to F and f, d(t) how far h is "
    "from the wall, inside being positive, the lower wall if there are two; M the mean of d, T a time at which d' = 0 and "
    "d'' > 0, in the listed top if there is one, and H = M - d(T) > 0. Then x(t) = (q - h)/H at the time T + t, or its "
    "negative if the wall is an upper one, moves as the oscillator of the certificate that follows at the depth nu with "
    "sigma nu = 1 - M/H, for g(t) = (M - d(T + t))/H: c, k, tau and the coefficients of g lie in its ranges, and nu, "
    "which increases with the distance from the touch, is > 0 and at most the listed NU up to each listed P. Exactly one "
    "p of the listed touch has d(T) = 0. So what the certificate states of its oscillator, it states of this one at each "
    "of these p.")
DEPTH = 14


class Span:
    """All numbers from one fraction to another."""
    def __init__(self, lo, hi=None):
        self.lo, self.hi = Fraction(lo), Fraction(lo if hi is None else hi)

    def __add__(self, other): return Span(self.lo + other.lo, self.hi + other.hi)
    def __neg__(self): return Span(-self.hi, -self.lo)
    def __sub__(self, other): return self + -other

    def __mul__(self, other):
        all = [x * y for x in (self.lo, self.hi) for y in (other.lo, other.hi)]
        return Span(min(all), max(all))

    def __truediv__(self, other):
        need(other.lo > 0 or other.hi < 0, "a divisor may be 0")
        return self * Span(1 / other.hi, 1 / other.lo)

    def is_zero(self): return self.lo == self.hi == 0


class Slope:
    """A number with its derivative by p."""
    def __init__(self, at, by=Span(0)): self.at, self.by = at, by
    def __add__(self, other): return Slope(self.at + other.at, self.by + other.by)
    def __neg__(self): return Slope(-self.at, -self.by)
    def __sub__(self, other): return self + -other
    def __mul__(self, other): return Slope(self.at * other.at, self.by * other.at + self.at * other.by)

    def __truediv__(self, other):
        at = self.at / other.at
        return Slope(at, (self.by - at * other.by) / other.at)


def constant(x): return Slope(Span(x))


class File(branch.File):
    """A certificate, read and held to its form."""
    def __init__(self, text):
        self.head(text, {"parameter": HEADS[0] + SEEN, "parameter 2": HEADS[1] + SEEN})
        need(self.waves <= 1000, "too many harmonics")
        whole_text = text.removesuffix("\n").split("\n")
        self.read_range()
        end = len(whole_text) - len(self.lines)
        need(all(len(line.encode()) <= 1000 for line in whole_text[3:end]), "a line is too long")
        name = self.lines[0].removeprefix("kind ").split(" ")[0] if self.lines else ""
        need(name in ("range", "single", "nothing", "attractor"), "no certificate follows")
        inner = "\n".join([whole_text[0], *whole_text[end:]]) + ("\n" if text.endswith("\n") else "")
        self.inner = importlib.import_module(name).File(inner)
        self.deepest = (self.inner.parts if name == "single" else self.inner.cells)[-1]
        self.deepest = self.deepest[0] if isinstance(self.deepest, tuple) else self.deepest.depth

    def quotient(self, word):
        """Lists of spans, the denominator's last."""
        above, slash, below = word.partition("/")
        need(slash, f"not a quotient: {word}")
        lists = [text.split(",") for text in (above, below)]
        need(all(len(one) <= 17 for one in lists), f"a quotient of too high powers: {word}")
        if self.kind == "parameter 2":
            ends = [[one.partition("..") for one in all] for all in lists]
            need(all(dots for all in ends for _, dots, _ in all), f"not a quotient of ranges: {word}")
            lists = [[Span(decimal(low), decimal(high)) for low, _, high in all] for all in ends]
            need(all(x.lo <= x.hi for all in lists for x in all), f"the ends are not in order: {word}")
            return lists
        need(all(re.fullmatch("0|-?[1-9][0-9]{0,33}", x, re.ASCII) for all in lists for x in all), f"not a quotient: {word}")
        above, below = ([int(x) for x in all] for all in lists)
        divisor = chaos.gcd(*above, *below)
        need((len(above) == 1 or above[-1] != 0) and below[-1] > 0 and divisor == 1, f"not in lowest terms: {word}")
        scale = max(map(abs, below))
        need(all(abs(x) < 2**30 * scale for x in above + below), f"out of range: {word}")
        return [[Span(x) for x in all] for all in (above, below)]

    def read_range(self):
        pair = lambda words: tuple(map(decimal, words))
        if self.lines and self.lines[0].startswith("from "):
            self.touch, self.start = None, decimal(self.words("from", 1)[0])
        else:
            self.touch = pair(self.words("touch", 2))
            need(self.touch[0] < self.touch[1], "the ends of the touch")
        top = self.words("top")
        self.top = None if top == ["none"] else pair(top)
        need(self.top is None or len(self.top) == 2 and self.top[0] < self.top[1], "the ends of the top")
        whole(self.words("pieces", 1)[0], 1, 1000)
        self.depths = []
        for _ in range(whole(self.words("depths", 1)[0], 1, 100)):
            nu, p = self.words("depth", 2)
            self.depths.append((fraction(nu), decimal(p)))
        first = self.depths[0][1]
        self.above = (self.touch[0] if self.touch else self.start) < first
        self.outer, self.inner_end = (self.touch if self.above else self.touch[::-1]) if self.touch else (self.start,) * 2
        last = Fraction(0), self.inner_end
        for nu, p in self.depths:
            need(nu > last[0] and (p > last[1] if self.above else p < last[1]), "depths go away from the touch")
            last = nu, p

    def side(self):
        """The wall that is looked at, and whether it is the lower one."""
        if self.inner.mirrored:
            need(len(self.walls) == 2, "two walls are mirror images")
            (low, law, still), (high, other, too) = self.walls["lower"], self.walls["upper"]
            numbers = [exact(x) for x in (low, law, high, other)]
            need(None not in numbers and numbers[0] == -numbers[2] and numbers[1] == numbers[3], "places and restitutions")
            odd = all(n % 2 == 1 for n, _, _ in self.forcing)
            need(odd and all(x.is_zero() for x in self.force[0]) and not still + too, "walls that are mirror images")
            return self.walls["lower"], True
        need(len(self.walls) == 1, "one wall")
        side, = self.walls
        return self.walls[side], side == "lower"

    def seen(self, p, wall, lower):
        """M, and by order the coefficients of d, c, k and τ, at p."""
        def value(quotient):
            lists = []
            for list in quotient:
                total = constant(0)
                for x in reversed(list):
                    total = total * p + Slope(x)
                lists.append(total)
            return lists[0] / lists[1]
        c, k, tau = value(self.damping), value(self.stiffness), value(wall[1])
        mean, waves = -value(wall[0]), {}
        if not all(x.is_zero() for x in self.force[0]):
            mean = mean + value(self.force) / k

        def add(n, a, b):
            nonlocal mean
            if n == 0:
                mean = mean + a
                return
            x, y = waves.get(n, (constant(0), constant(0)))
            waves[n] = x + a, y + b
        for n, a, b in self.forcing:
            a, b = value(a), value(b)
            if n == 0:
                add(0, a / k, b)
                continue
            off, drag = k - constant(n * n), c * constant(n)
            size = off * off + drag * drag
            # The square of a number is not below 0, which Span does not know.
            size.at = Span(max(size.at.lo, 0), size.at.hi)
            add(n, (off * a - drag * b) / size, (off * b + drag * a) / size)
        for n, a, b in wall[2]:
            add(n, -value(a), -value(b))
        if not lower:
            mean, waves = -mean, {n: (-a, -b) for n, (a, b) in waves.items()}
        return mean, waves, (c, k, tau)

    def check(self):
        title = self.inner.check()
        wall, lower = self.side()
        ways = dict(self.inner.__dict__).get("side", 1)
        sigma = ways if ways in (1, -1) else 1
        height = self.one(wall) if self.top is None else self.several(wall, lower)

        def ratio(lo, hi=None):
            """M/H with its derivative, or with one harmonic its square, and c, k, τ."""
            p = Slope(Span(min(lo, hi), max(lo, hi)) if hi is not None else Span(lo), Span(1))
            mean, waves, rest = self.seen(p, wall, lower)
            if height is None:
                a, b = waves[1]
                size = a * a + b * b
                size.at = Span(max(size.at.lo, 0), size.at.hi)
                need(size.at.lo > 0, "the wall may not move (P2)")
                return mean * mean / size, mean, rest
            scale = constant(1)
            for _ in range(height[1]):
                scale = scale * p
            size = Slope(height[0]) * scale
            need(size.at.lo > 0, "the wall may not move (P2)")
            return mean / size, mean, rest
        squared = height is None
        bound = lambda nu: (1 - sigma * nu) ** 2 if squared else 1 - sigma * nu

        def away(lo, hi, depth):
            try:
                found, mean, rest = ratio(lo, hi)
                ranges = zip(rest, self.inner.ranges)
                inside = all(ends[0] <= value.at.lo and value.at.hi <= ends[1] for value, ends in ranges)
                need(inside, "c, k or tau (P2)")
                # Of a square the sign of the derivative is that of M/H while M > 0.
                need(mean.at.lo > 0, "the sign of the mean (P2)")
                by = found.by if self.above else -found.by
                by = -by if sigma > 0 else by
                need(by.lo > 0, "nu may not increase (P2)")
            except ValueError:
                if depth == 0:
                    raise
                middle = (lo + hi) / 2
                away(lo, middle, depth - 1)
                away(middle, hi, depth - 1)
        end = self.depths[-1][1]
        away(self.outer, end, DEPTH)
        past = lambda x, nu: x.hi < bound(nu) if sigma > 0 else x.lo > bound(nu)
        short = lambda x, nu: x.lo >= bound(nu) if sigma > 0 else x.hi <= bound(nu)
        if self.touch:
            found = ratio(self.outer)[0].at
            need(found.lo > 1 if sigma > 0 else found.hi < 1, "nu before the touch (P3)")
        need(past(ratio(self.inner_end)[0].at, 0), "nu after the touch (P3)")
        if getattr(self.inner, "weighted", False):
            least, first = self.inner.least, ratio(self.inner_end)[0].at
            need(not self.touch, "no depths next to the touch (P3)")
            need(first.hi <= bound(least) if sigma > 0 else first.lo >= bound(least), "nu is less than the least (P3)")
        for nu, p in self.depths:
            need(short(ratio(p)[0].at, nu), "nu is greater (P4)")
        need(self.depths[-1][0] <= self.deepest, "the certificate does not go so deep (P4)")
        return title

    def one(self, wall):
        need(all(n <= 1 for n, _, _ in self.forcing + wall[2]), "several harmonics (P1)")
        need(any(n == 1 for n, _, _ in self.forcing + wall[2]), "no harmonic (P1)")
        need(self.inner.harmonics == [(1, (1, 1), (0, 0))], "not of one harmonic (P1)")

    def several(self, wall, lower):
        """H₁ and m."""
        parts = [x for n, a, b in self.forcing + wall[2] if n > 0 for x in (a, b) if not all(y.is_zero() for y in x[0])]
        powers = set()
        for above, below in parts:
            terms = [i for i, x in enumerate(above) if not x.is_zero()]
            need(len(terms) == 1 and len(below) == 1, "not a power (P1)")
            powers.add(terms[0])
        fixed = all(len(x[1]) == 1 and all(y.is_zero() for y in x[0][1:]) for x in (self.damping, self.stiffness))
        need(len(powers) == 1 and fixed, "the form of the wall's motion changes (P1)")
        m, = powers
        _, waves, _ = self.seen(constant(1), wall, lower)

        def turned(t):
            """Cosines and sines from the times t on, of d."""
            found = {}
            for n, (a, b) in waves.items():
                cos, sin = (Span(Fraction(x.lo, 1 << BITS), Fraction(x.hi, 1 << BITS)) for x in CIRCLE.exp(t.times(n)))
                found[n] = a.at * cos + b.at * sin, b.at * cos - a.at * sin
            return found
        rise = lambda t: sum((b * Span(n) for n, (_, b) in turned(number(t)).items()), Span(0))
        need(rise(self.top[0]).hi < 0 < rise(self.top[1]).lo, "no top (P1)")
        found = turned(number(*self.top))
        need(sum((-a * Span(n * n) for n, (a, _) in found.items()), Span(0)).lo > 0, "no top (P1)")
        height = sum((-a for a, _ in found.values()), Span(0))
        need(height.lo > 0, "no height (P1)")
        listed = {n: ends for n, *ends in self.inner.harmonics}
        for n in set(found) | set(listed):
            own = found.get(n, (Span(0), Span(0)))
            if n not in listed:
                need(all(x.is_zero() for x in own), f"harmonic {n} (P1)")
                continue
            for x, (lo, hi) in zip(own, listed[n]):
                x = -x / height
                need(lo <= x.lo and x.hi <= hi, f"harmonic {n} (P1)")
        return height, m


def exact(quotient):
    """The number that a quotient is, whatever p is."""
    above, below = quotient
    if len(above) == len(below) == 1 and above[0].lo == above[0].hi and below[0].lo == below[0].hi:
        return above[0].lo / below[0].lo
    return None


if __name__ == "__main__":
    chaos.main(File)
