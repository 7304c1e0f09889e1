#!/usr/bin/env python3
"""A second reader of certificates of kinds chaos and chaos 2, for whoever would rather trust 430 lines of Python.

usage: chaos.py FILE…     prints "FILE: proved" or "FILE: rejected: reason"; exit code 1 if one is rejected.

Written from the format text (checker/src/chaos/mod.rs) and docs/chaos.md, on Python's whole numbers in units of 2^-64, every operation rounded
outwards. Slow: an evaluation of a leg takes about a millisecond.
"""
import re
import sys
from fractions import Fraction as F
from itertools import product
from math import gcd

UNIT = 1 << 64
STATEMENT = (
    "For all c, k, f, tau and nu > 0 in the listed ranges, and for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, the oscillator q'' = -c q' - k q + f above the wall sigma nu - 1 + g(t), sigma "
    "the listed side, with restitution tau: for every bi-infinite path of the listed graph of letters there is exactly one motion whose "
    "impacts, one between two letters, have phases within W of multiples of 2 pi, as many periods apart as the letters say, and velocities, "
    "divided by nu, after the first and before the last impact of each letter in its ranges. It has no other impacts, all are at positive "
    "speed, between them the gap is positive, and q/nu stays below the reach. Paths with different periods have different motions; on the "
    "set of all these motions the map from t = pi to t = 3 pi has a topological entropy between the logarithms of the growth rates. If the "
    "line complete has a strength S, every motion that meets the wall at arbitrarily early and arbitrarily late times, and only within W of "
    "multiples of 2 pi where |g'| <= nu S/2, is one of these; if c and k are positive, so is every bounded motion for all time that meets it "
    "only there.")
STATEMENT_2 = (
    "For all c, k, tau and nu > 0 in the listed ranges, and for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, the oscillator q'' = -c q' - k q between the lower wall w(t) = sigma nu - 1 + "
    "g(t), sigma the listed side, and the upper wall -w(t - pi), both with restitution tau: for every bi-infinite path of the listed "
    "graph of letters and every integer m there is exactly one motion whose impacts, one between two letters, have times within W of "
    "multiples of pi, at the lower wall of even and at the upper wall of odd multiples, as many half periods pi apart as the letters say, "
    "the impact before letter 0 within W of m pi, and velocities, divided by nu, with the other sign at the upper wall, after the first "
    "and before the last impact of each letter in its ranges. It has no other impacts, all are at positive speed, between them the gaps "
    "to both walls are positive, as at impacts is that to the other wall, and |q|/nu stays below the reach. Paths with different half "
    "periods have different motions; on the set of all these motions, for all m, the map F of (q, q') at t = pi/2 to (-q, -q') at t = 3 "
    "pi/2 has a topological entropy between the logarithms of the growth rates, and the map from t = pi/2 to t = 5 pi/2 is F applied "
    "twice, of twice that entropy. If the line complete has a strength S, every motion that meets the walls at arbitrarily early and "
    "arbitrarily late times, and only where the above do and |w'|, or at the upper wall |w'| half a period before, is at most nu S/2, is "
    "one of these; if c and k are positive, so is every bounded motion for all time that meets them only there.")


def need(condition, reason):
    if not condition:
        raise ValueError(reason)


class I:
    """The numbers from lo to hi, in units of 2^-64."""
    def __init__(self, lo, hi): self.lo, self.hi = lo, hi
    def __add__(x, y): return I(x.lo + y.lo, x.hi + y.hi)
    def __neg__(x): return I(-x.hi, -x.lo)
    def __sub__(x, y): return x + -y
    def __mul__(x, y):
        p = x.lo * y.lo, x.lo * y.hi, x.hi * y.lo, x.hi * y.hi
        return I(min(p) >> 64, -(-max(p) >> 64))
    def __truediv__(x, y):
        need(y.lo > 0 or y.hi < 0, "a divisor may be zero (H0)")
        if y.hi < 0:
            return -x / -y
        return I(min((x.lo << 64) // d for d in (y.lo, y.hi)), -min((-x.hi << 64) // d for d in (y.lo, y.hi)))
    def square(x):
        p = x * x
        return I(max(p.lo, 0), p.hi)
    def middle(x): return I((x.lo + x.hi) // 2, (x.lo + x.hi) // 2)
    def hull(x, y): return I(min(x.lo, y.lo), max(x.hi, y.hi))
    def meet(x, y): return I(max(x.lo, y.lo), min(x.hi, y.hi))
    def within(x, y): return y.lo <= x.lo and x.hi <= y.hi
    def size(x): return I(max(-x.lo, x.hi), max(-x.lo, x.hi))
    def part(x, i, n): return I(x.lo + (x.hi - x.lo) * i // n, x.lo - (-(x.hi - x.lo) * (i + 1)) // n)
    def over(x, n): return I(x.lo // n, -(-x.hi // n))
    def half(x): return x.over(2)


def num(x):
    x = F(x)
    return I((x.numerator << 64) // x.denominator, -((-x.numerator << 64) // x.denominator))


ZERO, ONE, TWO = num(0), num(1), num(2)
PI = I(0x3243F6A8885A308D3, 0x3243F6A8885A308D4)  # times 2^64: 3.243F6A88 85A308D3 13…


def series(t, c, k):
    """exp(tA) = a + bA, A^2 = -cA - k, by halving and squaring."""
    halvings = 0
    while (t.size().hi * max(UNIT, c.size().hi + k.size().hi)) >> (62 + halvings) > UNIT:
        halvings += 1
    t, a, b = t.over(1 << halvings), ONE, ZERO
    for n in range(17, 0, -1):
        f = t.over(n)
        a, b = ONE - f * k * b, f * (a - c * b)
    a, b = I(a.lo - 1, a.hi + 1), I(b.lo - 1, b.hi + 1)  # the rest is below 2·4^-18/18! < 2^-64
    for _ in range(halvings):
        a, b = a.square() - k * b.square(), TWO * (a * b) - c * b.square()
    return a, b


def times(x, y, c, k):
    return x[0] * y[0] - k * (x[1] * y[1]), x[0] * y[1] + x[1] * y[0] - c * (x[1] * y[1])


def exp(t, c, k):
    return times(series(t.middle(), c, k), series(t - t.middle(), c, k), c, k)


def circle(t): return exp(t, ZERO, ONE)


class Wall:
    """g(t), the sum of a cos jt + b sin jt with Σ a = 1 and Σ j b = 0, and the window ±W on which it is convex."""
    def __init__(self, harmonics, window, pieces):
        self.harmonics, self.window = harmonics, window
        self.plain = [(j, a.lo, a.hi, b.lo, b.hi) for j, a, b in harmonics] == [(1, UNIT, UNIT, 0, 0)]
        need(2 * window.hi < PI.lo, "the window is not below pi/2")
        least = min(self.at((-window).hull(window).part(i, pieces))[2].lo for i in range(pieces))
        need(least > 0, "the wall may not be convex on the window")
        self.bend, self.ends = I(least, least), (self.at(-window)[1], self.at(window)[1])

    def at(self, t):
        """1 - g, -g' and -g''."""
        drop, slope, bend = ZERO, ZERO, ZERO
        for j, a, b in self.harmonics:
            n = num(j)
            cos, sin = circle(n * t)
            drop = drop + a * (ONE - cos) - b * sin
            slope = slope + n * (a * sin + b * (ONE - cos))
            bend = bend + n * n * (a * cos + b * sin)
        return drop, slope, bend

    def phase(self, y):
        """Where -g' is y: by Newton's method; the error is at most |y + g'(t)| / min -g''."""
        need(self.ends[0].hi < y.lo and y.hi < self.ends[1].lo, "an impact outside the window (H0)")
        ends = []
        for y in (I(y.lo, y.lo), I(y.hi, y.hi)):
            t = ZERO
            for _ in range(7):
                _, slope, bend = self.at(t)
                t = (t + (y - slope) / bend).middle()
                t = I(*[min(max(t.lo, -self.window.lo), self.window.lo)] * 2)
            miss, around = y - self.at(t)[1], I(-UNIT, UNIT)
            for bend in (self.bend, None) if not self.plain else (self.bend,):
                bend = bend or self.at(around)[2]
                error = (miss / I(max(bend.lo, self.bend.lo), bend.hi)).size().hi
                around = I(t.lo - error, t.hi + error)
            ends.append(around)
        return ends[0].hull(ends[1])

    def bends(self, t):
        """-g'', and (1 - g)/g'^2 = 1/(-2 g'') somewhere between t and 0; 1/(1 + cos t) for the cosine."""
        if self.plain:
            cos = circle(t)[0].meet(I(-UNIT, UNIT))
            return cos, ONE / (ONE + cos)
        low = self.bend.lo
        here, all = self.at(t)[2], self.at(t.hull(ZERO))[2]
        return I(max(here.lo, low), here.hi), ONE / (TWO * I(max(all.lo, low), all.hi))


def integer(word, most):
    need(re.fullmatch(r"0|[1-9][0-9]{0,18}", word, re.ASCII) and int(word) <= most, f"a number up to {most}: {word}")
    return int(word)


def decimal(word, positive=False):
    need(re.fullmatch(r"-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?", word, re.ASCII) and word != "-0", f"a decimal: {word}")
    need(sum(map(str.isdigit, word)) <= 15 and abs(F(word)) < 2**15 and (F(word) > 0 or not positive), f"a decimal in range: {word}")
    return F(word)


def fraction(word):
    p, slash, q = word.partition("/")
    need(slash and "." not in word, f"a fraction: {word}")
    p, q = whole(p), whole(q)
    need(q > 0 and gcd(p, q) == 1 and abs(F(p, q)) < 2**15, f"a fraction in lowest terms: {word}")
    return F(p, q)


def whole(word):
    need(re.fullmatch(r"-?(0|[1-9][0-9]{0,14})", word, re.ASCII) and word != "-0", f"a whole number: {word}")
    return int(word)


def check(text):
    lines = iter(line.removesuffix("\r") for line in text.removesuffix("\n").split("\n"))

    def line(name, count=None):
        words = next(lines, "").split(" ")
        need(words[0] == name and count in (None, len(words) - 1), f"expected a line {name}")
        return words[1:]

    def spread(words, read=decimal, strict=True):
        lo, hi = map(read, words)
        need(lo < hi or lo == hi and not strict, "ends must increase")
        return lo, hi
    need(next(lines, "") == "grazing-certificate 1", "not a certificate")
    kind = next(lines, "")
    need(kind in ("kind chaos", "kind chaos 2"), "not a certificate of kind chaos")
    mirrored = kind == "kind chaos 2"  # two walls, periods in halves
    need(next(lines, "") == "statement " + (STATEMENT_2 if mirrored else STATEMENT), "another statement")
    ranges = [spread(line(name, 2), fraction, False) for name in ("damping", "stiffness", "force", "restitution", "depth")]
    (c, k, f, tau, nu) = ranges
    need(f == (0, 0) or not mirrored, "a force between two walls")
    need(tau[0] > 0 and nu[0] >= 0 and nu[1] > 0 and (f == (0, 0) or c == k == (0, 0) and nu[0] > 0), "ranges")
    (side,) = line("side", 1)
    need(side in ("1", "-1"), "a side")
    sigma = num(int(side))
    harmonics = []
    for _ in range(integer(line("harmonics", 1)[0], 100)):
        order, *rest = line("harmonic", 5)
        one, other = spread(rest[:2], fraction, False), spread(rest[2:], fraction, False)
        harmonics.append((integer(order, 100), *(num(lo).hull(num(hi)) for lo, hi in (one, other))))
        need(harmonics[-1][0] > max([0] + [before[0] for before in harmonics[:-1]]), "orders increase from 1")
    total = [sum((x[1] for x in harmonics), -ONE), sum((num(x[0]) * x[2] for x in harmonics), ZERO)]
    need(all(x.lo <= 0 <= x.hi for x in total), "the harmonics have not their top at 0")
    cells = [integer(word, 10000) for word in line("cells", 5)]
    window, pieces = num(decimal(line("window", 1)[0], True)), integer(line("pieces", 1)[0], 1000)
    letters = []
    for _ in range(integer(line("letters", 1)[0], 400)):
        n, a, b, p, q, alpha, beta, growth, parts = line("letter", 9)
        letters.append((integer(n, 1000), spread((a, b)), spread((p, q)), *(decimal(x, True) for x in (alpha, beta, growth)), integer(parts, 64)))
        need(letters[-1][0] > 0 and letters[-1][6] > 0, "periods and parts")
    follow = []
    for _ in letters:
        follow.append([integer(word, len(letters)) - 1 for word in line("next")])
        need(follow[-1] and follow[-1][0] >= 0 and all(x < y for x, y in zip(follow[-1], follow[-1][1:])), "successors")
    kappa, reach = num(decimal(line("contraction", 1)[0], True)), num(decimal(line("reach", 1)[0], True))
    rates = spread(line("growth", 2))
    complete = line("complete")
    if complete != ["no"]:
        need(len(complete) == 4 and side == "1" and f == (0, 0), "completeness")
        complete = decimal(complete[0], True), *(integer(x, most) for x, most in zip(complete[1:], (1000, 64, 100)))
        need(all(complete) and len({x[0] for x in letters}) == len(letters), "completeness needs letters of different periods")
    need(next(lines, None) is None, "the file goes on")
    need(kappa.hi < UNIT and rates[0] > 0 and letters and pieces > 0 and all(cells), "numbers must be positive, the contraction below 1")
    before = [[m for m in range(len(letters)) if n in follow[m]] for n in range(len(letters))]
    told = [all(len({letters[w][0] for w in one}) == len(one) for one in way) for way in (follow, before)]
    need(any(told), "paths are not told by their periods")
    need(any(all(sign * (sum(letters[w][5] / rate**letters[w][0] for w in way[v]) - letter[5]) >= 0
                 for v, letter in enumerate(letters) for rate, sign in zip(rates, (1, -1))) for way in (follow, before)), "growth")
    wall = Wall(harmonics, window, pieces)
    for choice in product(*map(range, cells)):
        cell([num(lo).hull(num(hi)).part(i, n) for (lo, hi), i, n in zip(ranges, choice, cells)], mirrored, sigma, wall, pieces, letters, follow, before, kappa, reach, complete)


def cell(box, mirrored, sigma, wall, pieces, letters, follow, before, kappa, reach, complete):
    c, k, f, tau, nu = box
    f = f / nu if f.lo or f.hi else f
    window = wall.window
    after, last = ([num(x[i][0]).hull(num(x[i][1])) for x in letters] for i in (1, 2))
    share = TWO / (ONE + tau)
    longest = max([x[0] for x in letters] + ([] if complete == ["no"] else [complete[1]]))

    def elapsed(n): return num(n if mirrored else 2 * n) * PI
    turns = [exp(elapsed(n), c, k) for n in range(longest + 1)]
    if mirrored:  # what happens at the upper wall is seen in the mirror
        turns = [(-a, -b) if n % 2 else (a, b) for n, (a, b) in enumerate(turns)]

    def strength(a, p): return share * (a + tau * p)

    def impact(s):
        t = wall.phase(-(nu * s).half())
        bend, ratio = wall.bends(t)
        drop = (nu * s.square() * ratio).over(4)
        if nu.lo > 0 and not wall.plain:
            drop = drop.meet(wall.at(t)[0] / nu)
        return s, t, bend, sigma - drop

    def both(s, i, n): return impact(s.part(i, n)), impact(s.part(i, n).middle())

    def move(e, time, q, u): return e[0] * q + e[1] * u + f * time.square().half(), (e[0] - c * e[1]) * u - k * (e[1] * q) + f * time

    def ends(n, x, y):
        e, time = times(turns[n], exp(y[1] - x[1], c, k), c, k), elapsed(n) + y[1] - x[1]
        a = (y[3] - e[0] * x[3] - f * time.square().half()) / e[1]
        return e, a, move(e, time, x[3], a)[1]

    def leg(periods, x, y):
        """The velocities of a leg and their derivatives."""
        (x, x0), (y, y0) = x, y
        (e, a, p), (_, a_mid, p_mid) = ends(periods, x, y), ends(periods, x0, y0)
        slopes = [-(nu / u[2]).half() for u in (x, y)]
        for _ in range(3):
            r = f - c * p - k * y[3]
            first, final = (p - e[0] * x[0].half()) / e[1], (y[0].half() - p) / e[1]
            da = slopes[0] * first, slopes[1] * final
            dp = slopes[0] * ((e[0] - c * e[1]) * first - k * (e[1] * x[0].half()) - r), slopes[1] * ((e[0] - c * e[1]) * final + r)
            a = a.meet(a_mid + da[0] * (x[0] - x0[0]) + da[1] * (y[0] - y0[0]))
            p = p.meet(p_mid + dp[0] * (x[0] - x0[0]) + dp[1] * (y[0] - y0[0]))
        return a, p, da, dp

    def fits(n, a, p):
        (a0, a1), (p0, p1) = letters[n][1:3]
        return num(a0).hi <= a.lo and a.hi <= num(a1).lo and num(p0).hi <= p.lo and p.hi <= num(p1).lo

    def contracts(m, n, z, x, y):
        a, p, da, dp = leg(letters[n][0], x, y)
        alpha, beta = letters[n][3:5]
        need(fits(n, a, p), "a box is left (H1)")
        u, v = strength(num(alpha), num(letters[m][4])), strength(num(letters[z][3]), num(beta))
        for d, weight in ((da, alpha), (dp, beta)):
            need((d[0].size() * u + d[1].size() * v).hi <= (kappa * num(weight)).lo, "no contraction (H2)")

    def gaps(n, periods, into, out):
        """H4 for a letter, between impacts of all strengths that it can have."""
        x, y = (impact(I(min(s.lo for s in all), max(s.hi for s in all))) for all in (into, out))

        def motion(j, t):
            q, u = move(times(turns[j], exp(t - x[1], c, k), c, k), elapsed(j) + t - x[1], x[3], after[n])
            need(q.hi < reach.lo and (not mirrored or -q.lo < reach.lo), "the reach")
            return q, u

        def opened(t, q): need((wall.at(t)[0] + nu * (q - sigma)).lo > 0, "a gap may close (H4)")
        for j in range(periods + 1):
            least, left, right = None, x[1] if j == 0 else -window, y[1] if j == periods else window
            # From here the same wall's gap stays open to its next window, or to the end of the leg at the other.
            rest = window.hull(PI + y[1] if mirrored and j == periods - 1 else TWO * PI - window)
            for i in range(pieces):
                t = left.hull(right).part(i, pieces)
                q, u = motion(j, t)
                here = (wall.at(t)[2] + nu * (f - c * u - k * q)).lo
                need(here > 0, "a gap may not be convex (H4)")
                least = here if least is None else min(least, here)
                if j < periods:
                    opened(rest.part(i, pieces), motion(j, rest.part(i, pieces))[0])
            if 0 < j < periods:
                q, u = motion(j, ZERO)
                need((q - sigma - nu * u.square() / I(2 * least, 2 * least)).lo > 0, "the wall may be met (H4)")

        for i in range(pieces if mirrored else 0):  # the other wall's, to its first window
            t = (PI + x[1]).hull(TWO * PI - window).part(i, pieces)
            opened(t, -motion(0, t - PI)[0])

    for n, letter in enumerate(letters):
        periods, parts = letter[0], letter[6]
        into, out = [strength(after[n], last[m]) for m in before[n]], [strength(after[z], last[n]) for z in follow[n]]
        for m, s in zip(before[n], into):
            need((after[n] - last[m]).lo > 0, "a speed may be 0 (H3)")
            for z, t in zip(follow[n], out):
                for i, j in product(range(parts), repeat=2):
                    contracts(m, n, z, both(s, i, parts), both(t, j, parts))
        if before[n]:
            gaps(n, periods, into, out)
    if complete == ["no"]:
        return
    bound, longest, parts, rounds = complete
    bound = num(bound)

    def once(x):
        """At most one contact in a window: |q'| <= most, |q''| <= bend."""
        width = x[1].size() + x[1].size()
        room = ONE - width * (c.size() + k.size() * width)
        need(room.lo > 0, "two contacts in a window (C)")
        most = (x[0].size().half() + width * (k.size() * x[3].size())) / room
        need((x[2] - nu * (c.size() * most + k.size() * (x[3].size() + width * most))).lo > 0, "two contacts in a window (C)")

    def short():
        """No leg of more than so many periods: the ratios of q a period apart do not stay positive."""
        e = turns[1]
        det = (e[0] * (e[0] - c * e[1]) + k * e[1].square()).lo
        trace = (e[0] + e[0] - c * e[1]).hi
        ratio = trace
        for _ in range(longest - 2):
            if ratio <= 0:
                break
            ratio = (I(trace, trace) - I(det, det) / I(ratio, ratio)).hi
        need(det > 0 and longest > 1 and ratio <= 0, "a leg may be longer (C)")

    everything = impact((-bound).hull(bound))
    once(everything)
    need(everything[3].lo > 0, "an impact may be below rest (C)")
    short()
    # The velocities of legs of each length; None where nothing is known; left out if there is no such leg.
    known = {n: None for n in range(1, longest + 1)}

    def between(m, n):
        if known[m] is None or known[n] is None:
            return (-bound).hull(bound)
        (a, _), (_, p) = known[n], known[m]
        s = strength(a, p)
        return s.meet((-bound).hull(bound)) if a.hi >= p.lo and s.hi >= -bound.hi and s.lo <= bound.hi else None

    def possible(m, n, z, x, y):
        """The velocities of such a leg between legs of m and z periods; None if there is none."""
        a, p, _, _ = leg(n, x, y)
        x, y = x[0], y[0]
        a, p = I(max(a.lo, x[0].half().lo), a.hi), I(p.lo, min(p.hi, y[0].half().hi))
        if known[n]:
            a, p = a.meet(known[n][0]), p.meet(known[n][1])
        if known[m]:
            a = a.meet(x[0] / share - tau * known[m][1])
        if known[z]:
            p = p.meet((y[0] / share - known[z][0]) / tau)
        fine = a.lo <= a.hi and p.lo <= p.hi
        for j in range(1, n):
            e = times(turns[j], exp(-x[1], c, k), c, k)
            fine = fine and (e[0] * x[3] + e[1] * a - sigma).hi >= 0
        return (a, p) if fine else None

    def done():
        place = {letter[0]: n for n, letter in enumerate(letters)}
        return all(n in place and known[n] and fits(place[n], *known[n]) for n in known) and all(
            place[n] in follow[place[m]] or between(m, n) is None for m, n in product(known, repeat=2))

    for turn in range(rounds):
        strengths = {pair: between(*pair) for pair in product(known, repeat=2)}
        impacts = {pair: [both(s, i, parts) for i in range(parts)] for pair, s in strengths.items() if s}
        found = {}
        for n in known:
            others = list(known)[:1] if turn == 0 else known
            for m, z in product(others, repeat=2):
                for x, y in product(impacts.get((m, n), []), impacts.get((n, z), [])):
                    one = possible(m, n, z, x, y)
                    if one:
                        found[n] = tuple(u.hull(v) for u, v in zip(found[n], one)) if n in found else one
        known = found
        if done():
            return
    need(False, "there may be other orbits near (C)")


if __name__ == "__main__":
    good = True
    for name in sys.argv[1:]:
        try:
            check(open(name, encoding="utf-8", newline="").read())
            print(f"{name}: proved")
        except ValueError as reason:
            good = False
            print(f"{name}: rejected: {reason}")
    sys.exit(not good)
