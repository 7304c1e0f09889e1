#!/usr/bin/env python3
"""A second reader of certificates of kind branch, for whoever would rather trust Python.

usage: branch.py FILE…    prints "FILE: proved, N cells" or "FILE: rejected: reason"; exit code 1 if one is rejected.

Written from the form alone (the heads of crates/checker/src/branch, orbit and event, mod.rs). Numbers and the free motion are
those of chaos.py, a second reader too: nothing of the checker's. The derivative of the equations by phases and speeds
is by formulas, not by differentiating every step; only along the line of a cell, where the coefficients change as
well, are numbers carried with their slopes. Multipliers are those of the map
from phase and speed of an impact to those of the next. Of an oscillator with a constant force it needs a stiffness
that is certainly not 0. Slow: a cell takes about a second.
"""
import hashlib
import re
from fractions import Fraction
from math import isqrt

import chaos
from chaos import BITS, CIRCLE, ONE, PI, UNIT, ZERO, Flow, Range, exponential, need, number, roots, up

STATEMENT = (
    "For every choice of one number in each interval of the system of this digest and every value of its parameter "
    "from the first cell's LO to the last cell's HI, exactly one choice of phases and incoming relative speeds within "
    "R of the line of a cell that holds the value, the listed phases and speeds plus the listed rates times the distance "
    "from the cell's middle, solves the equations of the pattern, and it lies within W. This is a periodic orbit: every "
    "impact has positive speed, strictly between impacts every gap to a wall is positive, and no smaller number of "
    "periods than that of all listed strikes is a period. Where two cells meet both have the same orbit, and with the "
    "numbers of the intervals held its phases and speeds are continuously differentiable functions of the parameter in "
    "each cell, and continuous from the first LO to the last HI. In a cell whose claim is stable, both multipliers lie "
    "strictly inside the unit circle; if unstable, one lies strictly outside.")


def about(reach):
    """From −reach to reach."""
    return Range(-reach.hi, reach.hi)


def steep(x):
    """The derivative of sin √x/√x: of the middle by its series, and as far off as the second one, at most 1/60 on
    x ≥ 0 and cosh √|x| below, allows."""
    middle, apart = (x.lo + x.hi) // 2, (x.hi - x.lo) // 2 + 1
    size = isqrt((max(-x.lo, x.hi, 0) >> BITS) + 1) + 1
    need(size < 1000, "a time is too long for this reader")
    scale = UNIT << 2 * size + 40
    point, term, total, j = Fraction(-middle, UNIT), Fraction(1), 0, 0
    while True:
        # (−x)^j (j + 1)/(2j + 3)!, with the other sign.
        step = -term * (j + 1) / ((2 * j + 2) * (2 * j + 3))
        total += step.numerator * scale // step.denominator
        j += 1
        term = term * point / ((2 * j) * (2 * j + 1))
        term = Fraction(term.numerator * scale // term.denominator, scale)
        if j > size and abs(term) * scale <= 1:
            break
    total = total >> 2 * size + 40
    bend = up(apart * 2719**size if x.lo < 0 else apart, 1000**size if x.lo < 0 else 60)
    return Range(total - 2, total + 3).wide(bend)


class Moved:
    """A number, and how fast it changes with the parameter; that is None where it does not."""
    __slots__ = ("at", "rate")

    def __init__(self, at, rate=None):
        self.at, self.rate = at, rate

    def __add__(self, other): return Moved(self.at + other.at, added(self.rate, other.rate))
    def __neg__(self): return Moved(-self.at, self.rate and -self.rate)
    def __sub__(self, other): return self + -other

    def __mul__(self, other):
        return Moved(self.at * other.at, added(scaled(self.rate, other.at), scaled(other.rate, self.at)))

    def __truediv__(self, other):
        ratio = self.at / other.at
        rate = added(self.rate, scaled(other.rate, -ratio))
        return Moved(ratio, rate and rate / other.at)


def added(x, y):
    return y if x is None else x if y is None else x + y


def scaled(x, y):
    return None if x is None else x * y


def constant(x):
    return Moved(x if isinstance(x, Range) else number(x))


NOTHING = constant(ZERO)


def wave(t):
    """cos t and sin t."""
    wave, sine = (x.both(Range(-UNIT, UNIT)) for x in CIRCLE.exp(t.at))
    return Moved(wave, scaled(t.rate, -sine)), Moved(sine, scaled(t.rate, wave))


def series(terms, t):
    """Σ a cos nt + b sin nt with its first two derivatives by t."""
    value = slope = bend = NOTHING
    for n, a, b in terms:
        if n == 0:
            value += a
            continue
        cos, sin = wave(t * constant(n))
        here = a * cos + b * sin
        value, bend = value + here, bend - here * constant(n * n)
        slope += (b * cos - a * sin) * constant(n)
    return value, slope, bend


class Oscillator:
    """The system at values of the parameter."""
    def __init__(self, file, parameter):
        def at(quotient):
            above, below = (self.polynomial(list, parameter) for list in quotient)
            return above / below

        def waves(list): return [(n, at(a), at(b)) for n, a, b in list]
        self.c, self.k, self.force = map(at, (file.damping, file.stiffness, file.force))
        self.forcing = waves(file.forcing)
        self.response = []
        for n, a, b in self.forcing + ([] if file.no_force else [(0, self.force, NOTHING)]):
            off, drag = self.k - constant(n * n), self.c * constant(n)
            if n == 0:
                self.response.append((0, a / self.k, NOTHING))
                continue
            size = Moved(off.at.square() + drag.at.square(), added(scaled(off.rate, off.at + off.at),
                                                                     scaled(drag.rate, drag.at + drag.at)))
            self.response.append((n, (off * a - drag * b) / size, (off * b + drag * a) / size))
        self.walls = {side: (waves(list) + [(0, at(offset), NOTHING)], at(tau))
                      for side, (offset, tau, list) in file.walls.items()}
        self.flow = Flow(self.c.at, self.k.at)

    @staticmethod
    def polynomial(list, x):
        total = constant(list[-1])
        for one in reversed(list[:-1]):
            total = total * x + constant(one)
        return total

    def exp(self, t):
        """E over a time: of q'' = −c q' − k q, its four entries."""
        c, k = self.c, self.k
        first, second = (Moved(x) for x in self.flow.exp(t.at))
        if t.rate or c.rate or k.rate:
            # With x = (k − c²/4) t² the entries are e^{−ct/2}(C + ct/2 S) and e^{−ct/2} t S, C = cos √x.
            half, square = c.at.times(1, 2), t.at.square()
            x = (k.at - half.square()) * square
            (cosine, sine), bent = roots(x), steep(x)
            decay = exponential(-(half * t.at)) if c.at.size() else ONE
            by_k = -sine.times(1, 2) * square, bent * square
            by_c = sine.times(1, 2) * half * square, -(bent * half * square)
            inner = cosine + half * t.at * sine
            rates_k = decay * (by_k[0] + half * t.at * by_k[1]), decay * t.at * by_k[1]
            rates_c = (decay * (by_c[0] + half * t.at * by_c[1] + (t.at * (sine - inner)).times(1, 2)),
                       decay * t.at * (by_c[1] - (t.at * sine).times(1, 2)))
            rates_t = -(k.at * second.at), first.at - c.at * second.at
            first.rate, second.rate = (
                added(added(scaled(t.rate, rates_t[i]), scaled(c.rate, rates_c[i])), scaled(k.rate, rates_k[i]))
                for i in (0, 1))
        return first, second, -(k * second), first - c * second

    def acceleration(self, q, u, t):
        return series(self.forcing, t)[0] + self.force - self.c * u - self.k * q

    def leaves(self, side, t, speed):
        """The place and the velocity just after an impact, and how fast the speed turns into it."""
        terms, tau = self.walls[side]
        place, slope, bend = series(terms, t)
        thrown = tau * speed if side == "lower" else -(tau * speed)
        return place, slope + thrown, thrown, bend

    def free(self, t, side, speed):
        """What is left of a motion that begins at an impact when the response is taken away."""
        place, velocity, _, _ = self.leaves(side, t, speed)
        rest, drift, _ = series(self.response, t)
        return place - rest, velocity - drift

    def arrives(self, free, time, t, side):
        """The gap to a wall a time after an impact, at phase t, with its derivatives; and E."""
        e = self.exp(time)
        rest, drift, _ = series(self.response, t)
        q, u = rest + e[0] * free[0] + e[1] * free[1], drift + e[2] * free[0] + e[3] * free[1]
        place, slope, bend = series(self.walls[side][0], t)
        gap = q - place, u - slope, self.acceleration(q, u, t) - bend
        return (gap if side == "lower" else tuple(-x for x in gap)), e


class Cell:
    """A part of the range, and the line about which its orbit lies."""
    def __init__(self, file, low, high, claim):
        self.file, self.low, self.high, self.claim = file, low, high, claim

    def ready(self):
        self.middle, self.half = (self.low + self.high) / 2, number((self.high - self.low) / 2)
        self.reach = about(self.half)
        self.place = number(self.low, self.high)
        self.oscillator = Oscillator(self.file, Moved(self.place))

    def along(self, offsets):
        """Where the line takes these over the whole cell."""
        return [number(y) + number(rate) * self.reach + x for y, rate, x in zip(self.point, self.rates, offsets)]

    def at(self, end, offsets):
        """The same at one end, −1 or 1."""
        return [number(y) + (number(rate) * self.half).times(end) + x
                for y, rate, x in zip(self.point, self.rates, offsets)]

    def time(self, x, i):
        """How long flight i lasts."""
        m, turns = self.file.count, constant(PI.times(2 * self.file.strikes[i][1]))
        return turns if m == 1 else turns + x[(i + 1) % m] - x[i]

    def equations(self, oscillator, x):
        """The gap, and its rate beside −V, at the end of each flight."""
        m, strikes = self.file.count, self.file.strikes
        for i, (side, _) in enumerate(strikes):
            j = (i + 1) % m
            free = oscillator.free(x[i], side, x[m + i])
            (gap, slope, _), _ = oscillator.arrives(free, self.time(x, i), x[j], strikes[j][0])
            yield from (gap, slope + x[m + j])

    def derivative(self, x):
        """Of the equations by phases and speeds. The gap is E(D) f + h(t) up to its sign: D is the flight's time, f how
        the motion begins less the response, t the last phase, h the response less the wall."""
        m, strikes, oscillator = self.file.count, self.file.strikes, self.oscillator
        x, rows = [Moved(one) for one in x], [[ZERO] * (2 * m) for _ in range(2 * m)]
        for i, (side, _) in enumerate(strikes):
            j = (i + 1) % m
            e, free = oscillator.exp(self.time(x, i)), oscillator.free(x[i], side, x[m + i])
            _, slope, bend = series(oscillator.walls[side][0], x[i])
            _, drift, drag = series(oscillator.response, x[i])
            turned = slope - drift, bend - drag
            terms, sign = oscillator.walls[strikes[j][0]][0], 1 if strikes[j][0] == "lower" else -1
            _, slope, bend = series(terms, x[j])
            _, drift, drag = series(oscillator.response, x[j])
            tau = oscillator.walls[side][1]
            fast = tau if side == "lower" else -tau
            left = [e[0] * free[0] + e[1] * free[1], e[2] * free[0] + e[3] * free[1]]
            longer = left[1], -(oscillator.k * left[0]) - oscillator.c * left[1]
            for row, by_start, by_speed, by_end, by_time in (
                    (2 * i, e[0] * turned[0] + e[1] * turned[1], e[1] * fast, drift - slope, longer[0]),
                    (2 * i + 1, e[2] * turned[0] + e[3] * turned[1], e[3] * fast, drag - bend, longer[1])):
                # The time is the difference of the phases, or does not change.
                one, two = (by_start, by_end) if m == 1 else (by_start - by_time, by_end + by_time)
                for column, entry in ((i, one), (m + i, by_speed), (j, two)):
                    rows[row][column] += entry.at.times(sign)
            rows[2 * i + 1][m + j] += ONE
        return rows

    def image(self, residual, radius):
        """K: where the solutions within a radius of the line are, as offsets from it (B1)."""
        box, n = about(number(radius)), len(self.point)
        slopes, image = self.derivative(self.along([box] * n)), []
        for i, row in enumerate(self.inverse):
            total = ZERO
            for c, f in zip(row, residual):
                total -= c * f
            for j in range(n):
                rest = ONE if i == j else ZERO
                for c, line in zip(row, slopes):
                    rest -= c * line[j]
                total += rest * box
            need(total.size() < number(radius).lo, f"Krawczyk's test fails in unknown {i + 1} (B1)")
            image.append(total)
        return image

    def solution(self):
        m = self.file.count
        need(0 < self.within <= self.radius, "the radii are out of order")
        middle = Oscillator(self.file, Moved(number(self.middle)))
        there = [one.at for one in self.equations(middle, [constant(y) for y in self.point])]
        moved = Oscillator(self.file, Moved(self.place, ONE))
        line = [Moved(at, number(rate)) for at, rate in zip(self.along([ZERO] * (2 * m)), self.rates)]
        slopes = [one.rate for one in self.equations(moved, line)]
        residual = [value + slope * self.reach for value, slope in zip(there, slopes)]
        self.image(residual, self.radius)
        return self.image(residual, self.within)

    def holds(self, former):
        """Everything in it; the offsets of its orbit."""
        self.ready()
        offsets = self.solution()
        if former:
            radius = number(self.radius).lo
            for x, y in zip(former, self.at(-1, [ZERO] * len(self.point))):
                need((x - y).size() < radius, "its orbit may not be that of the cell before (B4)")
        x = self.along(offsets)
        for _, tau in self.oscillator.walls.values():
            need(tau.at.lo >= 0, "a restitution may be below 0 (B2)")
        need(all(speed.lo > 0 for speed in x[self.file.count:]), "a speed may not be positive (B2)")
        self.least(x)
        for i, ends in enumerate(self.flights):
            self.open(x, i, ends)
        self.stability(x)
        return self.at(1, offsets)

    def least(self, x):
        """No smaller number of periods is one."""
        m, strikes = self.file.count, self.file.strikes
        total = sum(n for _, n in strikes)
        for d in range(1, m):
            if m % d == 0 and total * d % m == 0:
                def back(i):
                    j = (i + d) % m
                    turns = sum(strikes[(i + l) % m][1] for l in range(d)) - total * d // m
                    late, faster = PI.times(2 * turns) + x[j] - x[i], x[m + j] - x[m + i]
                    return strikes[i][0] == strikes[j][0] and all(y.lo <= 0 <= y.hi for y in (late, faster))
                need(not all(map(back, range(m))), "the orbit may repeat itself (B2)")

    def open(self, x, i, ends):
        """Between impacts i and i + 1 every gap is positive, piece by piece."""
        m, strikes, oscillator = self.file.count, self.file.strikes, self.oscillator
        side, following = strikes[i][0], strikes[(i + 1) % m][0]
        lasts = self.time([Moved(one) for one in x], i).at
        need(lasts.lo > 0, "a flight may not last (B2)")
        need(lasts.hi <= number(ends[-1]).lo, "the pieces stop before a flight's end (B2)")
        free = oscillator.free(Moved(x[i]), side, Moved(x[m + i]))

        def gap(time, wall):
            z, _ = oscillator.arrives(free, Moved(time), Moved(x[i] + time), wall)
            return [one.at for one in z]

        start = Fraction(0)
        for at, end in enumerate(ends):
            need(start < end, "the pieces do not follow one another (B2)")
            around = about(number((end - start) / 2))
            for wall in oscillator.walls:
                z, slope, _ = gap(number((start + end) / 2), wall)
                bend = gap(number(start, end), wall)[2]
                rate = slope + bend * around
                if (z + slope * around + (bend * around.square()).times(1, 2)).lo > 0:
                    continue
                left, met = at == 0 and wall == side, at == len(ends) - 1 and wall == following
                need((left and max(rate.lo, bend.lo) > 0) or (met and (rate.hi < 0 or bend.lo > 0)),
                     f"the gap may not be positive on piece {at + 1} of flight {i + 1} (B2)")
            start = end

    def next(self, x, i):
        """The linearised map from phase and speed of impact i to those of the next."""
        m, strikes, oscillator = self.file.count, self.file.strikes, self.oscillator
        x, j, (side, _) = [Moved(one) for one in x], (i + 1) % m, strikes[i]
        e, (tau, lower) = oscillator.exp(self.time(x, i)), (oscillator.walls[side][1], strikes[j][0] == "lower")
        place, velocity, thrown, wall = oscillator.leaves(side, x[i], x[m + i])
        # Later by δ it starts at (w + δ w', w' + δ w''), where the old motion is at (w + δ u, u + δ q'').
        late = -thrown, wall - oscillator.acceleration(place, velocity, x[i])
        fast = tau if side == "lower" else -tau
        gap_t, gap_v, rate_t, rate_v = (
            one if lower else -one for one in (e[0] * late[0] + e[1] * late[1], e[1] * fast,
                                               e[2] * late[0] + e[3] * late[1], e[3] * fast))
        # It ends on the wall, at its speed.
        speed = x[m + j]
        place, slope, wall = series(oscillator.walls[strikes[j][0]][0], x[j])
        bend = oscillator.acceleration(place, slope - speed if lower else slope + speed, x[j]) - wall
        turn = (bend if lower else -bend) / speed
        return [one.at for one in (gap_t / speed, gap_v / speed, -(turn * gap_t) - rate_t, -(turn * gap_v) - rate_v)]

    def stability(self, x):
        """B3, by the maps from (T, V) of an impact to (T, V) of the next."""
        if self.claim == "open":
            return
        m, around = self.file.count, [ONE, ZERO, ZERO, ONE]
        determinant = exponential(-(self.oscillator.c.at * PI.times(2 * sum(n for _, n in self.file.strikes))))
        for i, (side, _) in enumerate(self.file.strikes):
            a, b, c, d = self.next(x, i)
            p, q, r, s = around
            around = [a * p + b * r, a * q + b * s, c * p + d * r, c * q + d * s]
            determinant = determinant * self.oscillator.walls[side][1].at.square()
        trace = around[0] + around[3]
        below, above = ONE + determinant - trace, ONE + determinant + trace
        stable = determinant.hi < UNIT and below.lo > 0 and above.lo > 0
        unstable = determinant.lo > UNIT or below.hi < 0 or above.hi < 0
        need(stable if self.claim == "stable" else unstable, f"the orbit is not certainly {self.claim} (B3)")


def decimal(word):
    need(re.fullmatch(r"-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?", word, re.ASCII) and word != "-0", f"not a decimal: {word}")
    value = Fraction(word)
    need(sum(map(str.isdigit, word)) <= 34 and abs(value) < 2**30, f"out of range: {word}")
    return value


def quotient(word):
    """Two lists of ranges."""
    above, slash, below = word.partition("/")
    need(slash, f"not a quotient: {word}")
    lists = []
    for text in (above, below):
        ends = [one.partition("..") for one in text.split(",")]
        need(len(ends) <= 17 and all(dots for _, dots, _ in ends), f"not a quotient of ranges: {word}")
        pairs = [(decimal(low), decimal(high)) for low, _, high in ends]
        need(all(low <= high for low, high in pairs), f"the ends are not in order: {word}")
        lists.append([number(*pair) for pair in pairs])
    return lists


class File(chaos.File):
    """A certificate, read and held to its form."""
    def __init__(self, text):
        self.head(text, {"branch": STATEMENT})
        need(all(len(line.encode()) <= 1000 for line in self.lines), "a line is too long")
        self.count = whole(self.words("branch", 1)[0], 1, 24)
        self.strikes = [self.read_strike() for _ in range(self.count)]
        need(any(periods for _, periods in self.strikes), "the periods sum to 0")
        cells, self.spent, self.cells = whole(self.words("cells", 1)[0], 1, 10_000), 0, []
        for _ in range(cells):
            self.cells.append(self.read_cell())
        need(not self.lines, "the file goes on")

    def head(self, text, statements):
        """The lines up to the parameter's name; of these kinds, each with its statement, which it is."""
        self.lines = [line.removesuffix("\r") for line in text.removesuffix("\n").split("\n")]
        need(self.take() == "grazing-certificate 1", "not a certificate")
        name, _, self.kind = self.take().partition(" ")
        need(name == "kind" and self.kind in statements, "not of kind " + " or ".join(statements))
        need(self.take() == "statement " + statements[self.kind], "another statement")
        digest, = self.words("digest", 1)
        system = list(self.lines)
        self.read_system()
        own = "".join(line + "\n" for line in system[:len(system) - len(self.lines)])
        need(hashlib.sha256(own.encode()).hexdigest() == digest, "another digest")
        need(re.fullmatch("[A-Za-z_][A-Za-z0-9_]{0,31}", self.words("parameter", 1)[0], re.ASCII), "not a name")

    def quotient(self, word): return quotient(word)

    def read_system(self):
        self.waves = 0
        # Nothing is computed in other units than the listed ones.
        if self.lines and self.lines[0].startswith("units "):
            units = [power(word) for word in self.words("units", 2)]
            need(any(units), "units that are all 1 are not listed")
        words = [self.words(name, 1)[0] for name in ("damping", "stiffness", "force")]
        self.damping, self.stiffness, self.force = map(self.quotient, words)
        self.no_force = all(x.lo == x.hi == 0 for x in self.force[0])
        self.forcing = self.read_waves(self.words("forcing", 1)[0])
        self.walls = {}
        for side in ("lower", "upper"):
            words = self.words(side)
            if words != ["none"]:
                need(len(words) == 3, "a wall has three words")
                offset, tau = map(self.quotient, words[:2])
                need(len(tau[0]) > 1 or len(tau[1]) > 1 or (tau[0][0] / tau[1][0]).hi >= 0, "a restitution is below 0")
                self.walls[side] = offset, tau, self.read_waves(words[2])

    def read_waves(self, count):
        terms = []
        for _ in range(whole(count, 0, 1000)):
            n, a, b = self.words("harmonic", 3)
            terms.append((whole(n, 0, 1000), self.quotient(a), self.quotient(b)))
        self.waves += len(terms)
        return terms

    def read_strike(self):
        side, periods = self.words("strike", 2)
        need(side in self.walls, "there is no such wall")
        return side, whole(periods, 0, 10_000)

    def read_cell(self):
        low, high, claim = self.words("cell", 3)
        cell = Cell(self, decimal(low), decimal(high), claim)
        need(cell.low < cell.high, "a cell ends before it begins")
        need(not self.cells or self.cells[-1].high == cell.low, "a cell does not begin where the one before ends")
        need(claim in ("stable", "unstable", "open"), "another claim")
        lines = [[decimal(x) for x in self.words("at", 4)] for _ in range(self.count)]
        cell.point = [line[i] for i in (0, 1) for line in lines]
        cell.rates = [line[i] for i in (2, 3) for line in lines]
        cell.radius, cell.within = (decimal(x) for x in self.words("radius", 2))
        size = 2 * self.count
        cell.inverse = [[number(decimal(x)) for x in self.words("row", size)] for _ in range(size)]
        cell.flights, pieces = [], 0
        for _ in range(self.count):
            count = whole(self.words("flight", 1)[0], 1, 8_000_000)
            pieces += count
            one = (1 + 2 * self.waves) * (4 * pieces + 6 * self.count * (8 * self.count + 11))
            need(self.spent + one <= 8_000_000, "too much work")
            cell.flights.append([decimal(self.words("until", 1)[0]) for _ in range(count)])
        self.spent += one
        return cell

    def check(self):
        former = None
        for number_, cell in enumerate(self.cells, 1):
            try:
                former = cell.holds(former)
            except ValueError as reason:
                raise ValueError(f"cell {number_}: {reason}") from None
        return f"{len(self.cells)} cells"


def whole(word, least, most):
    need(re.fullmatch("0|[1-9][0-9]{0,9}", word, re.ASCII), f"not a number: {word}")
    need(least <= int(word) <= most, f"a number from {least} to {most}: {word}")
    return int(word)


def power(word):
    """A power of ten in a unit."""
    need(word != "-0", "not a number: -0")
    size = whole(word.removeprefix("-"), 0, 99)
    return -size if word.startswith("-") else size


if __name__ == "__main__":
    chaos.main(File)
