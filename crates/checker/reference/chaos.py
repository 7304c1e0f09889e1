#!/usr/bin/env python3
"""A second reader of certificates of kinds chaos 3 and chaos 4, for whoever would rather trust Python.

usage: chaos.py FILE…     prints "FILE: proved, chaos", "FILE: proved, orbits" or "FILE: rejected: reason";
                          exit code 1 if one is rejected.

Written from the form (the head of crates/checker/src/chaos/mod.rs) and from proofs/chaos.md alone. Numbers are Python's
whole numbers in units of 2^-72, every operation rounded outwards. The free motion is in closed form, by the
functions cos √x and sin √x/√x, which are entire, so that no damping is a case of its own; phases of impacts are
bracketed by signs of the wall's slope. Slow: a leg takes about a millisecond.
"""
import re
import sys
from fractions import Fraction
from itertools import product
from math import cos, gcd, isqrt, lcm, sin

BITS = 72
UNIT = 1 << BITS
FAR = 1 << BITS + 60

HEAD = (
    "For all c, k, {0}tau and nu > 0 in the listed ranges, and for g(t) the sum of the listed harmonics a cos jt + "
    "b sin jt, a and b in their ranges, all a together 1 and all j b together 0, the oscillator q'' = -c q' - k q "
)
STATEMENT_3 = HEAD.format("f, ") + (
    "+ f above the wall sigma nu - 1 + g(t), sigma the listed side, with restitution tau: for every bi-infinite path "
    "of the listed graph of letters and every integer m there is exactly one motion whose impacts, one between two "
    "letters, have times within W of multiples of 2 pi, as many periods 2 pi apart as the letters say, the impact "
    "before letter 0 within W of 2 pi m, and velocities, divided by nu, after the first and before the last impact of "
    "each letter in its ranges. It has no other impacts, all are at positive speed, between them the gap is positive, "
    "and q/nu stays below the reach. With the same m, paths whose periods differ somewhere have different motions; on "
    "the set of the states (q, q') at t = pi of all these motions, for all m, the map to t = 3 pi has a topological "
    "entropy between the logarithms of the growth rates. If the line complete has a strength S, every motion that "
    "meets the wall at arbitrarily early and arbitrarily late times, and only within W of multiples of 2 pi where |g'| "
    "<= nu S/2, is one of these; if c and k are positive, so is every bounded motion for all time that meets it only "
    "there.")
STATEMENT_4 = HEAD.format("") + (
    "between the lower wall w(t) = sigma nu - 1 + g(t), sigma the listed side, and the upper wall -w(t - pi), both "
    "with restitution tau: for every bi-infinite path of the listed graph of letters and every integer m there is "
    "exactly one motion whose impacts, one between two letters, have times within W of multiples of pi, at the lower "
    "wall of even and at the upper wall of odd multiples, as many half periods pi apart as the letters say, the impact "
    "before letter 0 within W of m pi, and velocities, divided by nu, with the other sign at the upper wall, after the "
    "first and before the last impact of each letter in its ranges. It has no other impacts, all are at positive "
    "speed, between them the gaps to both walls are positive, as at impacts is that to the other wall, and |q|/nu "
    "stays below the reach. With the same m, paths whose half periods differ somewhere have different motions; on the "
    "set of the states (q, q') at t = pi/2 of all these motions, for all m, the map F to (-q, -q') at t = 3 pi/2 has a "
    "topological entropy between the logarithms of the growth rates, and the map to t = 5 pi/2 is F applied twice, of "
    "twice that entropy. If the line complete has a strength S, every motion that meets the walls at arbitrarily early "
    "and arbitrarily late times, and only where the above do and |w'|, or at the upper wall |w'| half a period before, "
    "is at most nu S/2, is one of these; if c and k are positive, so is every bounded motion for all time that meets "
    "them only there.")


def need(condition, reason):
    if not condition:
        raise ValueError(reason)


def up(x, y):
    return -(-x // y)


class Range:
    """All numbers from lo to hi, in units."""
    __slots__ = ("lo", "hi")

    def __init__(self, lo, hi=None):
        self.lo, self.hi = lo, lo if hi is None else hi

    def __add__(self, other): return Range(self.lo + other.lo, self.hi + other.hi)
    def __sub__(self, other): return Range(self.lo - other.hi, self.hi - other.lo)
    def __neg__(self): return Range(-self.hi, -self.lo)

    def __mul__(self, other):
        ends = [x * y for x in (self.lo, self.hi) for y in (other.lo, other.hi)]
        return Range(min(ends) >> BITS, up(max(ends), UNIT))

    def __truediv__(self, other):
        need(other.lo > 0 or other.hi < 0, "a divisor may be zero (H0)")
        pairs = [(x << BITS, y) for x in (self.lo, self.hi) for y in (other.lo, other.hi)]
        return Range(min(x // y for x, y in pairs), max(up(x, y) for x, y in pairs))

    def square(self):
        low = 0 if self.lo <= 0 <= self.hi else min(abs(self.lo), abs(self.hi))
        return Range(low * low >> BITS, up(self.size() ** 2, UNIT))

    def times(self, p, q=1):
        """Times p/q, for whole numbers p and q > 0."""
        ends = sorted((self.lo * p, self.hi * p))
        return Range(ends[0] // q, up(ends[1], q))

    def size(self): return max(-self.lo, self.hi)
    def middle(self): return Range((self.lo + self.hi) // 2)
    def both(self, other): return Range(max(self.lo, other.lo), min(self.hi, other.hi))
    def hull(self, other): return Range(min(self.lo, other.lo), max(self.hi, other.hi))
    def empty(self): return self.lo > self.hi
    def inside(self, low, high): return low.hi <= self.lo and self.hi <= high.lo
    def wide(self, error): return Range(self.lo - error, self.hi + error)

    def cut(self, parts):
        width = self.hi - self.lo
        return [Range(self.lo + width * i // parts, self.lo + up(width * (i + 1), parts)) for i in range(parts)]


def number(x, y=None):
    """The range from one fraction to another."""
    low, high = Fraction(x), Fraction(x if y is None else y)
    return Range((low.numerator << BITS) // low.denominator, up(high.numerator << BITS, high.denominator))


ZERO, ONE, TWO = number(0), number(1), number(2)
EVERYTHING = Range(-FAR, FAR)


def machin(scale):
    """π·scale by π = 16 arctan 1/5 − 4 arctan 1/239, within 1 unit of scale if that is large."""
    def arctan(inverse):
        power, total, n = (scale << 40) // inverse, 0, 1
        while power:
            total += power // n if n % 4 == 1 else -(power // n)
            power, n = power // inverse**2, n + 2
        return total
    return (16 * arctan(5) - 4 * arctan(239)) >> 40


PI = Range(machin(UNIT) - 1, machin(UNIT) + 1)


def roots(x):
    """cos √x and sin √x/√x: their Taylor polynomials of degree 1 about the middle m, and bounds of f″."""
    middle = (x.lo + x.hi) // 2
    apart = max(x.hi - middle, middle - x.lo)
    need(abs(middle) + apart < 10**6 * UNIT, "a time is too long for this reader")
    # The terms |m|^j/(2j)! are at most exp √|m|, and of either sign if m > 0.
    guard = 2 * isqrt((abs(middle) >> BITS) + 1) + 30
    one, size, sign = UNIT << guard, abs(middle) << guard, -1 if middle > 0 else 1
    low = high = one
    j, way = 0, 1
    sums = [[0, 0] for _ in range(3)]  # Σ (−m)^j/(2j)!, Σ (−m)^j/(2j+1)!, and the derivative of the latter
    while True:
        for total, factor, divisor, turn in ((sums[0], 1, 1, way), (sums[1], 1, 2 * j + 1, way),
                                             (sums[2], j + 1, (2 * j + 1) * (2 * j + 2) * (2 * j + 3), -way)):
            ends = low * factor // divisor, up(high * factor, divisor)
            total[0] += ends[0] if turn > 0 else -ends[1]
            total[1] += ends[1] if turn > 0 else -ends[0]
        j, way = j + 1, way * sign
        scale = (2 * j - 1) * 2 * j * one
        low, high = low * size // scale, up(high * size, scale)
        if high <= 2 and (2 * j + 1) * (2 * j + 2) * one > 2 * size:
            break
    c, s, slope = (Range((lo - 8) >> guard, up(hi + 8, 1 << guard)) for lo, hi in sums)
    # |f″| for x ≥ 0 is largest at 0, where it is 1/12 and 1/60; below, at most so many times cosh √|x|.
    n = isqrt((max(-x.lo, 0) >> BITS) + 1) + 1 if x.lo < 0 else 0
    bend = up(apart * apart * 2719**n, UNIT * 1000**n)
    d = x - Range(middle)
    return (c - s * d.times(1, 2)).wide(up(bend, 24)), (s + slope * d).wide(up(bend, 120))


def root(units):
    """The square root of so many units."""
    least = isqrt(units << BITS)
    return Range(least, least + 1)


def exponential(x):
    """exp x at both ends."""
    def point(v):
        halvings = max((abs(v) >> BITS).bit_length(), 0) + 1
        need(halvings < 20, "an exponential is out of range")
        guard = 40 + 2 * halvings + 2 * (abs(v) >> BITS)
        one = UNIT << guard
        v = Range(*((abs(v) << guard) // 2**halvings + i for i in (0, 1)))
        low = high = total = most = one
        n = 0
        while high > 2:
            n += 1
            low, high = low * v.lo // (n * one), up(high * v.hi, n * one)
            total, most = total + low, most + high
        most += 4
        for _ in range(halvings):
            total, most = total * total // one, up(most * most, one)
        return total, most, one, guard
    ends = []
    for v in (x.lo, x.hi):
        low, high, one, guard = point(v)
        low, high = (low, high) if v >= 0 else (one * one // high, up(one * one, low))
        ends.append((low >> guard, up(high, 1 << guard)))
    return Range(ends[0][0], ends[1][1])


class Flow:
    """q″ = −c q′ − k q. E(t) is given by E₁₁ and E₁₂; E₂₁ = −k E₁₂ and E₂₂ = E₁₁ − c E₁₂."""
    def __init__(self, c, k):
        self.c, self.k, self.half = c, k, c.times(1, 2)
        self.discriminant = k - self.half.square()
        self.norm = max(UNIT, c.size() + k.size())

    def closed(self, t):
        wave, sine = roots(self.discriminant * t.square())
        decay = exponential(-(self.half * t)) if self.c.size() else ONE
        return decay * (wave + self.half * t * sine), decay * t * sine

    def product(self, x, y):
        b = x[1] * y[1]
        return x[0] * y[0] - self.k * b, x[0] * y[1] + x[1] * y[0] - self.c * b

    def near(self, t):
        """E near time 0, by Taylor's series of q″ = −c q′ − k q, whose first terms are exact."""
        size = up(self.norm * t.size(), UNIT)
        if size > UNIT // 4:
            a, b = self.near(t.times(1, 2))
            return a.square() - self.k * b.square(), (a * b).times(2) - self.c * b.square()
        entries = []
        for terms in ([ONE, ZERO], [ZERO, ONE]):
            for n in range(14):
                next = self.c.times(n + 1) * terms[-1] + self.k * terms[-2]
                terms.append(next.times(-1, (n + 1) * (n + 2)))
            total = terms[-1]
            for term in reversed(terms[:-1]):
                total = total * t + term
            entries.append(total.wide(4))  # what is left out is below 2·4^-16/16! < 2^-74
        return tuple(entries)

    def exp(self, t):
        start = self.closed(t.middle())
        return start if t.lo == t.hi else self.product(start, self.near(t - t.middle()))

    def last(self, e): return e[0] - self.c * e[1]
    def move(self, e, q, u): return e[0] * q + e[1] * u, self.last(e) * u - self.k * (e[1] * q)


CIRCLE = Flow(ZERO, ONE)


class Wall:
    """g, by its harmonics, on the window ±W."""
    def __init__(self, harmonics, window, pieces):
        self.harmonics, self.window = harmonics, window
        self.plain = [(j, *a, *b) for j, a, b in harmonics] == [(1, 1, 1, 0, 0)]
        self.terms = [(j, number(*a), number(*b)) for j, a, b in harmonics]
        self.floats = [(j, float(sum(a)) / 2, float(sum(b)) / 2) for j, a, b in harmonics]
        need(window.times(2).hi < PI.lo, "the window is not below pi/2")
        whole = (-window).hull(window)
        self.least = min(self.shape(part)[2].lo for part in whole.cut(pieces))
        need(self.least > 0, "the wall may not be convex on the window")
        self.ends = self.shape(-window)[1].hi, self.shape(window)[1].lo

    def shape(self, t):
        """1 − g, −g′, −g″ with Σ a = 1 and Σ j b = 0 put in."""
        drop = slope = bend = ZERO
        for j, a, b in self.terms:
            wave, sine = CIRCLE.exp(t.times(j))
            drop += a * (ONE - wave) - b * sine
            slope += (a * sine + b * (ONE - wave)).times(j)
            bend += (a * wave + b * sine).times(j * j)
        return drop, slope, bend

    def bracket(self, y, way):
        """A time in the window where −g′, which increases, is certainly at most y (way −1), at least y (1)."""
        edge, goal, t = self.window.lo / UNIT, y / UNIT, 0.0
        for _ in range(40):
            slope = sum(j * (a * sin(j * t) + b * (1 - cos(j * t))) for j, a, b in self.floats)
            bend = sum(j * j * (a * cos(j * t) + b * sin(j * t)) for j, a, b in self.floats)
            t = min(max(t + (goal - slope) / max(bend, self.least / UNIT / 2), -edge), edge)
        start, step = int(t * UNIT), UNIT >> 46

        def passed(u):
            slope = self.shape(Range(u))[1]
            return slope.hi <= y if way < 0 else slope.lo >= y
        while True:
            if abs(start + way * step) >= self.window.lo:
                return self.window.hi * way  # y is taken within the window
            if passed(start + way * step):
                break
            step *= 2
        good, bad = step, 0 if step == UNIT >> 46 else step // 2
        for _ in range(5):
            half = (good + bad) // 2
            good, bad = (half, bad) if passed(start + way * half) else (good, half)
        return start + way * good

    def phase(self, y):
        need(self.ends[0] < y.lo and y.hi < self.ends[1], "an impact may be outside the window (H0)")
        return Range(self.bracket(y.lo, -1), self.bracket(y.hi, 1))

    def bends(self, t):
        """−g″, and (1 − g)/g′²: 1/(1 + cos t) of the cosine, else 1/−2g″ somewhere between 0 and t."""
        if self.plain:
            wave = CIRCLE.exp(t)[0].both(Range(-UNIT, UNIT))
            return wave, ONE / (ONE + wave)
        here, between = self.shape(t)[2], self.shape(t.hull(ZERO))[2]
        between.lo = max(between.lo, self.least)
        return Range(max(here.lo, self.least), here.hi), ONE / between.times(2)


class Cell:
    """All conditions for a box of parameters."""
    def __init__(self, file, box):
        self.file, self.mirrored, self.wall = file, file.mirrored, file.wall
        c, k, f, self.tau, self.nu = box
        self.flow, self.sigma = Flow(c, k), ONE if file.side == 1 else -ONE
        self.force = f / self.nu if f.size() else ZERO
        self.boxes = [(number(*x.after), number(*x.before)) for x in file.letters]
        self.turns = [self.turn(n) for n in range(file.longest() + 1)]

    def time(self, n): return PI.times(n if self.mirrored else 2 * n)

    def turn(self, n):
        """E over n periods, or half periods: at the upper wall all is seen in a mirror."""
        a, b = self.flow.closed(self.time(n))
        return (-a, -b) if self.mirrored and n % 2 else (a, b)

    def strength(self, a, p): return (a + self.tau * p).times(2) / (ONE + self.tau)

    def impact(self, s):
        t = self.wall.phase((self.nu * s).times(-1, 2))
        bend, ratio = self.wall.bends(t)
        drop = (self.nu * s.square() * ratio).times(1, 4)
        if self.nu.lo > 0:
            other = self.wall.shape(t)[0] / self.nu
            drop = drop if drop.both(other).empty() else drop.both(other)
        return s, t, bend, self.sigma - drop

    def impacts(self, s, parts): return [(self.impact(x), self.impact(x.middle())) for x in s.cut(parts)]

    def fall(self, time): return (self.force * time.square()).times(1, 2), self.force * time
    def acceleration(self, q, u): return self.force - self.flow.c * u - self.flow.k * q

    def ends(self, n, first, last):
        """E of a leg of n periods, and its first and last velocity."""
        e = self.flow.product(self.turns[n], self.flow.exp(last[1] - first[1]))
        fallen, speed = self.fall(self.time(n) + last[1] - first[1])
        a = (last[3] - e[0] * first[3] - fallen) / e[1]
        return e, a, self.flow.move(e, first[3], a)[1] + speed

    def leg(self, n, first, last):
        """Its velocities a, p and their derivatives by s and s′, from Q′ = q(T) by differentiation:
        E₁₁ Q_s + E₁₂ a_s − p t_s = 0 with Q_s = t_s s/2 and t_s = −ν/(−2g″), and so on."""
        (x, x_mid), (y, y_mid) = first, last
        e, a, p = self.ends(n, x, y)
        _, a_mid, p_mid = self.ends(n, x_mid, y_mid)
        t_x, t_y = ((self.nu / z[2]).times(-1, 2) for z in (x, y))
        half_x, half_y = x[0].times(1, 2), y[0].times(1, 2)
        dx, dy = x[0] - x_mid[0], y[0] - y_mid[0]
        final = self.flow.last(e)
        for _ in range(3):
            r = self.acceleration(y[3], p)
            one, other = (p - e[0] * half_x) / e[1], (half_y - p) / e[1]
            slopes_a = t_x * one, t_y * other
            slopes_p = t_x * (final * one - self.flow.k * (e[1] * half_x) - r), t_y * (final * other + r)
            a = a.both(a_mid + slopes_a[0] * dx + slopes_a[1] * dy)
            p = p.both(p_mid + slopes_p[0] * dx + slopes_p[1] * dy)
        return a, p, slopes_a, slopes_p

    def fits(self, v, a, p):
        letter = self.file.letters[v]
        return a.inside(*map(number, letter.after)) and p.inside(*map(number, letter.before))

    def holds(self):
        letters = self.file.letters
        for v, letter in enumerate(letters):
            (after, before) = self.boxes[v]
            into = {u: self.strength(after, self.boxes[u][1]) for u in letter.previous}
            out = {x: self.strength(self.boxes[x][0], before) for x in letter.next}
            starts = {u: self.impacts(s, letter.parts) for u, s in into.items()}
            stops = {x: self.impacts(s, letter.parts) for x, s in out.items()}
            for u, x in product(into, out):
                need(self.boxes[u][1].hi < after.lo, "a speed may be 0 (H3)")
                for first, last in product(starts[u], stops[x]):
                    self.contracts(letters[u], v, letters[x], first, last)
            self.gaps(v, *(Range(min(s.lo for s in all.values()), max(s.hi for s in all.values()))
                           for all in (into, out)))
        if self.file.complete:
            Others(self).none()

    def contracts(self, previous, v, following, first, last):
        """H1 and H2."""
        letter = self.file.letters[v]
        a, p, slopes_a, slopes_p = self.leg(letter.periods, first, last)
        need(self.fits(v, a, p), "a box may be left (H1)")
        early = number(letter.alpha) + self.tau * number(previous.beta)
        late = number(following.alpha) + self.tau * number(letter.beta)
        for (d, e), weight in ((slopes_a, letter.alpha), (slopes_p, letter.beta)):
            sum = Range(d.size()) * early + Range(e.size()) * late
            most = self.file.contraction * (ONE + self.tau) * number(weight / 2)
            need(sum.hi <= most.lo, "the map may not contract (H2)")

    def gaps(self, v, into, out):
        """H4."""
        letter, wall, window = self.file.letters[v], self.wall, self.file.window
        n, pieces = letter.periods, self.file.pieces
        start, stop = self.impact(into), self.impact(out)

        def motion(k, t):
            since = t - start[1]
            e = self.flow.product(self.turns[k], self.flow.exp(since))
            q, u = self.flow.move(e, start[3], self.boxes[v][0])
            fallen, speed = self.fall(self.time(k) + since)
            q, u = q + fallen, u + speed
            need(max(q.hi, -q.lo if self.mirrored else q.hi) < self.file.reach.lo, "the reach may be passed")
            return q, u

        def open(span, place):
            for t in span.cut(pieces):
                gap = wall.shape(t)[0] + self.nu * (place(t) - self.sigma)
                need(gap.lo > 0, "a gap between windows may not be positive (H4)")

        for k in range(n + 1):
            span = (start[1] if k == 0 else -window).hull(stop[1] if k == n else window)
            least = None
            for t in span.cut(pieces):
                curvature = (wall.shape(t)[2] + self.nu * self.acceleration(*motion(k, t))).lo
                need(curvature > 0, "a gap may not be convex (H4)")
                least = curvature if least is None else min(least, curvature)
            if 0 < k < n:
                q, u = motion(k, ZERO)
                dip = self.nu * u.square() / Range(2 * least)
                need((q - self.sigma - dip).lo > 0, "the wall may be met between impacts (H4)")
        full = TWO * PI - window
        for k in range(n):
            end = PI + stop[1] if self.mirrored and k == n - 1 else full
            open(window.hull(end), lambda t: motion(k, t)[0])
        if self.mirrored:
            open((PI + start[1]).hull(full), lambda t: -motion(0, t - PI)[0])


class Others:
    """C1 to C3: that there are no other motions near."""
    def __init__(self, cell):
        self.cell, file = cell, cell.file
        self.bound, self.longest, self.parts, self.rounds = file.complete
        self.strengths = number(-self.bound, self.bound)
        self.place = {letter.periods: v for v, letter in enumerate(file.letters)}

    def none(self):
        cell, flow = self.cell, self.cell.flow
        _, t, bend, place = cell.impact(self.strengths)
        # C1
        width, deep = Range(2 * t.size()), Range(place.size())
        c, k = Range(flow.c.size()), Range(flow.k.size())
        room = ONE - width * (c + k * width)
        need(room.lo > 0, "there may be two contacts in a window (C1)")
        most = (number(self.bound / 2) + width * k * deep) / room
        acceleration = c * most + k * (deep + width * most)
        need(bend.lo > (cell.nu * acceleration).hi, "there may be two contacts in a window (C1)")
        # C3
        known = self.legs(t, place)
        for turn in range(self.rounds):
            known = self.narrowed(known, turn == 0)
            if self.done(known):
                return
        need(False, "there may be other legs (C3)")

    def legs(self, t, place):
        """C2, by the ratios' upper bounds r_1, r_2, …; nothing is known of legs then but how long they are."""
        e = self.cell.turns[1]
        final = self.cell.flow.last(e)
        trace, determinant = (e[0] + final).hi, (e[0] * final + self.cell.flow.k * e[1].square()).lo
        need(place.lo > 0 and determinant > 0, "a leg may be longer (C2)")
        ratio, j = trace, 1
        while ratio > 0 and j < self.longest:
            ratio = (Range(trace) - Range(determinant) / Range(ratio)).hi
            j += 1
        need(ratio <= 0 and j < self.longest, "a leg may be longer (C2)")
        return {n: (EVERYTHING, EVERYTHING) for n in range(1, self.longest + 1)}

    def counted(self, count):
        """So many impacts or legs are looked at."""

    def between(self, known, m, n):
        """The strengths of impacts after a leg of m periods and before one of n; None if there can be none."""
        (a, _), (_, p) = known[n], known[m]
        if a.hi < p.lo:
            return None
        s = self.cell.strength(a, p).both(self.strengths)
        return None if s.empty() else s

    def narrowed(self, known, first):
        cell, impacts, found = self.cell, {}, {}
        others = [1] if first else list(known)  # at first all are alike
        for m, n in product(known, repeat=2):
            s = self.between(known, m, n) if m in others or n in others else None
            if s:
                self.counted(self.parts)
                impacts[m, n] = cell.impacts(s, self.parts)
        for n, m, x in product(known, others, others):
            for start, stop in product(impacts.get((m, n), ()), impacts.get((n, x), ())):
                self.counted(1)
                one = self.possible(known, m, n, x, start, stop)
                if one:
                    found[n] = tuple(y.hull(z) for y, z in zip(one, found.get(n, one)))
        return found

    def possible(self, known, m, n, x, start, stop):
        cell, tau = self.cell, self.cell.tau
        (s, t, _, place), (s_last, t_last, _, place_last) = start[0], stop[0]
        e = cell.flow.product(cell.turns[n], cell.flow.exp(t_last - t))
        a, p = known[n]
        if e[1].lo <= 0 <= e[1].hi:
            # Not known from the places: where does what is known of a lead?
            q, u = cell.flow.move(e, place, a)
            if q.both(place_last).empty():
                return None
            p = p.both(u)
        else:
            own = cell.leg(n, start, stop)
            a, p = a.both(own[0]), p.both(own[1])
        a, p = a.both(Range(s.times(1, 2).lo, FAR)), p.both(Range(-FAR, s_last.times(1, 2).hi))
        # s = 2(a + τp)/(1 + τ) with the neighbours' velocities.
        a = a.both((s * (ONE + tau)).times(1, 2) - tau * known[m][1])
        p = p.both(((s_last * (ONE + tau)).times(1, 2) - known[x][0]) / tau)
        if a.empty() or p.empty():
            return None
        back = cell.flow.exp(-t)
        for k in range(1, n):
            q, _ = cell.flow.move(cell.flow.product(cell.turns[k], back), place, a)
            if q.hi < cell.sigma.lo:
                return None
        return a, p

    def done(self, known):
        if not all(n in self.place and self.cell.fits(self.place[n], *known[n]) for n in known):
            return False
        letters = self.cell.file.letters
        return all(self.place[n] in letters[self.place[m]].next or self.between(known, m, n) is None
                   for m, n in product(known, repeat=2))


class Letter:
    """A line letter, with the letters that may follow and precede it, from 0."""


class File:
    """A certificate, read and held to its form."""
    def __init__(self, text):
        names = ("damping", "stiffness", "force", "restitution", "depth")
        self.mirrored = self.start(text, {"chaos 3": STATEMENT_3, "chaos 4": STATEMENT_4}, names) == "chaos 4"
        c, k, f, _, nu = self.ranges
        need(nu[0] >= 0 and nu[1] > 0, "the depth must be positive")
        need(f == (0, 0) or (c == k == (0, 0) and nu[0] > 0 and not self.mirrored), "this force is not allowed")
        self.side = {"1": 1, "-1": -1}.get(self.words("side", 1)[0])
        need(self.side, "a side is 1 or -1")
        self.read_wall()
        self.cells = [whole(word, 0, 10000) for word in self.words("cells", 5)]
        total = 1
        for cells in self.cells:
            total *= cells
        need(1 <= total <= 10000, "1 to 10000 cells")
        self.window = number(decimal(self.words("window", 1)[0], True))
        self.pieces = whole(self.words("pieces", 1)[0], 1, 1000)
        self.read_letters()
        contraction = decimal(self.words("contraction", 1)[0], True)
        need(contraction < 1, "the contraction must be below 1")
        self.contraction, self.reach = number(contraction), number(decimal(self.words("reach", 1)[0], True))
        self.rates = self.increasing(self.words("growth", 2))
        need(self.rates[0] >= 1, "a growth rate is at least 1")
        self.read_complete()
        need(not self.lines, "the file goes on")
        need(self.cost(total) <= 6_000_000, "the check would cost too much")

    def start(self, text, statements, names=("damping", "stiffness", "restitution")):
        """The lines up to the ranges of these names; of these kinds, each with its statement, which it is."""
        self.lines = [line.removesuffix("\r") for line in text.removesuffix("\n").split("\n")]
        need(self.take() == "grazing-certificate 1", "not a certificate")
        name, _, kind = self.take().partition(" ")
        need(name == "kind" and kind in statements, "not of kind " + " or ".join(statements))
        need(self.take() == "statement " + statements[kind], "another statement")
        need(all(len(line.encode()) <= 2000 for line in self.lines), "a line is too long")
        self.ranges = [self.ordered(self.words(name, 2), fraction) for name in names]
        need(self.ranges[names.index("restitution")][0] > 0, "restitution must be positive")
        return kind

    def take(self): return self.lines.pop(0) if self.lines else ""

    def words(self, name, count=None):
        head, *rest = self.take().split(" ")
        need(head == name and count in (None, len(rest)), f"a line {name} is missing")
        return rest

    def ordered(self, words, read):
        low, high = map(read, words)
        need(low <= high, "a range's ends must not decrease")
        return low, high

    def increasing(self, words):
        low, high = map(decimal, words)
        need(low < high, "a range's ends must increase")
        return low, high

    def read_wall(self):
        self.harmonics = []
        for _ in range(whole(self.words("harmonics", 1)[0], 0, 100)):
            order, *ends = self.words("harmonic", 5)
            order = whole(order, 1, 100)
            need(not self.harmonics or self.harmonics[-1][0] < order, "orders increase")
            self.harmonics.append((order, self.ordered(ends[:2], fraction), self.ordered(ends[2:], fraction)))
        ends = [[(x[1][i], 1) for x in self.harmonics] for i in (0, 1)]
        ends += [[(x[2][i], x[0]) for x in self.harmonics] for i in (0, 1)]
        for terms in ends:
            need(lcm(*(x.denominator for x, _ in terms)) <= 10**30, "no common denominator")
        sums = [sum(x * j for x, j in terms) for terms in ends]
        need(sums[0] <= 1 <= sums[1] and sums[2] <= 0 <= sums[3], "the top of the wall is not at 0")

    def read_letters(self):
        self.letters = []
        count = whole(self.words("letters", 1)[0], 1, 400)
        for _ in range(count):
            periods, a, b, p, q, alpha, beta, gamma, parts = self.words("letter", 9)
            letter = Letter()
            letter.periods, letter.parts = whole(periods, 1, 1000), whole(parts, 1, 64)
            letter.after, letter.before = self.increasing((a, b)), self.increasing((p, q))
            letter.alpha, letter.beta, letter.gamma = (decimal(x, True) for x in (alpha, beta, gamma))
            self.letters.append(letter)
        self.read_next()

    def read_next(self):
        count = len(self.letters)
        for letter in self.letters:
            letter.next = [whole(word, 1, count) - 1 for word in self.words("next")]
            need(letter.next, "a letter has a successor")
            need(letter.next == sorted(set(letter.next)), "the numbers of letters increase")
        for v, letter in enumerate(self.letters):
            letter.previous = [u for u, other in enumerate(self.letters) if v in other.next]
            need(letter.previous, "a letter has a predecessor")

    def read_complete(self):
        words = self.words("complete")
        self.complete = None
        if words != ["no"]:
            need(len(words) == 4, "complete no, or four numbers")
            self.complete = (decimal(words[0], True), *(whole(x, 1, m) for x, m in zip(words[1:], (1000, 64, 100))))
            need(self.side == 1 and self.ranges[2] == (0, 0), "completeness is for side 1 and no force")

    def longest(self):
        return max([x.periods for x in self.letters] + ([self.complete[1]] if self.complete else []))

    def cost(self, cells):
        """In exponentials, as the form says."""
        h, j = len(self.harmonics), self.pieces
        cell = self.longest() + 1
        for x in self.letters:
            p, f = len(x.previous), len(x.next)
            cell += (p + f) * x.parts * 36 * h + 4 * p * f * x.parts**2
            cell += 46 * h + (2 * x.periods + 1 + self.mirrored) * j * (1 + h) + x.periods
        if self.complete:
            _, m, k, r = self.complete
            cell += 23 * h + r * m**2 * k * 36 * h + (m + (r - 1) * m**3) * k**2 * (5 + m)
        return (j + 2) * h + cells * cell

    def check(self):
        """Proves everything; "chaos", or "orbits" where no growth above 1 is claimed."""
        self.told()
        letters = self.letters
        if self.complete:
            need(len({x.periods for x in letters}) == len(letters), "completeness needs different periods")
        self.wall = Wall(self.harmonics, self.window, self.pieces)
        cuts = [number(*ends).cut(parts) for ends, parts in zip(self.ranges, self.cells)]
        for box in product(*cuts):
            Cell(self, box).holds()
        return "chaos" if self.rates[0] > 1 else "orbits"

    def told(self):
        """Paths are told apart by their periods, and grow at the rates."""
        letters = self.letters
        ways = [[x.next for x in letters], [x.previous for x in letters]]
        told = (all(len({letters[w].periods for w in list}) == len(list) for list in way) for way in ways)
        need(any(told), "paths are not told apart by their periods")
        need(any(self.grows(way) for way in ways), "the growth vector does not prove the rates")

    def grows(self, way):
        """Exactly, in fractions."""
        for rate, sign in zip(self.rates, (1, -1)):
            terms = [x.gamma / rate**x.periods for x in self.letters]
            if any(sign * (sum(terms[w] for w in list) - x.gamma) < 0 for x, list in zip(self.letters, way)):
                return False
        return True


def whole(word, least, most):
    need(re.fullmatch("0|[1-9][0-9]{0,9}", word, re.ASCII), f"not a number: {word}")
    need(least <= int(word) <= most, f"a number from {least} to {most}: {word}")
    return int(word)


def decimal(word, positive=False):
    need(re.fullmatch(r"-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?", word, re.ASCII) and word != "-0", f"not a decimal: {word}")
    need(sum(map(str.isdigit, word)) <= 15, f"too many digits: {word}")
    value = Fraction(word)
    need(abs(value) < 2**15 and (value > 0 or not positive), f"out of range: {word}")
    return value


def fraction(word):
    need(re.fullmatch("-?(0|[1-9][0-9]{0,14})/[1-9][0-9]{0,14}", word, re.ASCII), f"not a fraction: {word}")
    p, q = map(int, word.split("/"))
    need(gcd(p, q) == 1 and not word.startswith("-0") and abs(p) < 2**15 * q, f"not in lowest terms: {word}")
    return Fraction(p, q)


def main(kind):
    """Prints the verdict on each file named, read as this kind of file; the exit code says if one is rejected."""
    good = True
    for name in sys.argv[1:]:
        try:
            with open(name, encoding="utf-8", newline="") as stream:
                print(f"{name}: proved, {kind(stream.read()).check()}")
        except ValueError as reason:
            good = False
            print(f"{name}: rejected: {reason}")
    sys.exit(not good)


if __name__ == "__main__":
    main(File)
