#!/usr/bin/env python3
"""A second reader of certificates of kind single, for whoever would rather trust Python.

usage: single.py FILE…    prints "FILE: proved, orbit of one impact" or "FILE: rejected: reason"; exit code 1 if one is
                          rejected.

Written from the form (the head of crates/checker/src/single/mod.rs) and from proofs/ranges.md alone. Numbers and the free
motion are those of chaos.py, and how gaps are carried is that of range.py, second readers too: nothing of the
checker's. What a motion is between two impacts is found from the linear equations of its ends, by Cramer's rule, and
multipliers from the product of matrices.
"""
from fractions import Fraction
from math import isqrt

import chaos
from chaos import CIRCLE, ONE, PI, ZERO, Flow, Range, decimal, fraction, need, number, whole
from range import carried

STATEMENT = (
    "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the last part's, the oscillator "
    "q'' = -c q' - k q above the wall sigma nu - 1 + g(t), sigma the listed side, with restitution tau, has exactly one "
    "motion that repeats itself after the listed n periods 2 pi and has one impact in them, at a time t, and so at all "
    "t + 2 pi n m, for which D t lies between 0 and the last cell's T, D being the listed direction. The impact is at "
    "positive speed, and the gap between impacts is positive. With c, k, tau and g held fixed t is a continuous "
    "function of nu, from where the motion is born with t = 0 at nu = 0, and D t increases with nu. For nu in a part "
    "that is called stable the motion is asymptotically stable, both multipliers being inside the unit circle; in one "
    "called unstable it is unstable, one of them being outside.")

STATEMENT_2 = (
    "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the last part's, the "
    "oscillator q'' = -c q' - k q between the lower wall w(t) = sigma nu - 1 + g(t), sigma the listed side, and the "
    "upper wall -w(t - pi), both with restitution tau, has exactly one motion that the listed n half periods pi later "
    "is itself, q(t + pi n) = q(t), if n is even, or its mirror image, q(t + pi n) = -q(t), if n is odd, and that has "
    "one impact in such a time, counting both walls: with the lower wall at a time t, and so at all t + pi n m, with "
    "the upper one where n m is odd, for which D t lies between 0 and the last cell's T, D being the listed "
    "direction. The impact is at positive speed, and between impacts the gaps to both walls are positive, as at "
    "impacts is that to the other wall. With c, k, tau and g held fixed t is a continuous function of nu, from where "
    "the motion is born with t = 0 at nu = 0, and D t increases with nu. For nu in a part that is called stable the "
    "motion is asymptotically stable, both multipliers of n half periods being inside the unit circle; in one called "
    "unstable it is unstable, one of them being outside.")


def matrix(x, y):
    """The product of 2 by 2 matrices, by rows."""
    return [[x[i][0] * y[0][j] + x[i][1] * y[1][j] for j in (0, 1)] for i in (0, 1)]


def circle(t):
    """All cosines and sines: those of the ends, and what lies at multiples of pi/2 between."""
    (wave, sine), (other, last) = CIRCLE.closed(Range(t.lo)), CIRCLE.closed(Range(t.hi))
    wave, sine = wave.hull(other), sine.hull(last)
    first = 2 * t.lo // PI.lo - 2
    for k in range(first, 2 * t.hi // PI.lo + 3):
        at = PI.times(k, 2)
        if at.hi >= t.lo and at.lo <= t.hi:
            top = (ONE, ONE, -ONE, -ONE)[k % 4]
            wave, sine = (wave.hull(top), sine) if k % 2 == 0 else (wave, sine.hull(top))
    return wave, sine


class File(chaos.File):
    """A certificate, read and held to its form."""
    def __init__(self, text):
        self.mirrored = self.start(text, {"single": STATEMENT, "single 2": STATEMENT_2}) == "single 2"
        self.side = self.sign("side")
        self.read_wall()
        self.n = whole(self.words("periods", 1)[0], 1, 1000)
        self.way = self.sign("direction")
        self.pieces = whole(self.words("pieces", 1)[0], 1, 1000)
        need(self.n * self.pieces <= 100_000, "too many pieces")
        self.parts = []
        for _ in range(whole(self.words("parts", 1)[0], 1, 100)):
            depth, word = self.words("part", 2)
            need(word in ("stable", "unstable", "open"), "a part is stable, unstable or open")
            self.parts.append((fraction(depth), word))
        cells = whole(self.words("cells", 1)[0], 1, 10_000)
        self.cells = [decimal(self.words("cell", 1)[0], True) for _ in range(cells)]
        for all_ends in ([x for x, _ in self.parts], self.cells):
            ends = [Fraction(0)] + all_ends
            need(all(x < y for x, y in zip(ends, ends[1:])), "ends increase, from 0")
        need(self.cells[-1] <= Fraction("3.141"), "a phase is at most 3.141")
        need(not self.lines, "the file goes on")
        h, j, n = len(self.harmonics), self.pieces, self.n
        cell = 2 * h * (j + 2) + n * j * (2 + h)
        cost = 2 * j + n + 1 + n * j + cells * cell * (1 + self.mirrored)
        need(cost <= 50_000_000, "the check would cost too much")

    def sign(self, name):
        value = {"1": 1, "-1": -1}.get(self.words(name, 1)[0])
        need(value, f"a {name} is 1 or -1")
        return value

    def check(self):
        """Proves everything; the title."""
        self.terms = [(j, number(*a), number(*b)) for j, a, b in self.harmonics]
        self.solve()
        self.free()
        self.found, last = [], Fraction(0)
        for phase in self.cells:
            self.cell(last, phase)
            last = phase
        self.told()
        return "orbit of one impact"

    def solve(self):
        """x and x′ just after an impact, over g′: E x = x but for a jump of velocity, a + τp = 1 + τ."""
        self.c, self.k, self.tau = (number(*ends) for ends in self.ranges)
        self.flow = Flow(self.c, self.k)
        self.turns = [self.turn(n) for n in range(self.n + 1)]
        self.resonant = self.meets()
        if self.resonant:
            self.turns[-1] = self.turns[-1][0], ZERO
        e = self.full(self.turns[-1])
        one = ONE + self.tau
        # Rows (E₁₁ − 1, E₁₂ | 0) and (τE₂₁, 1 + τE₂₂ | 1 + τ); the determinant with e^(−cT) put in.
        decay = chaos.exponential(-(self.c * self.time(self.n)))
        whole_det = e[0][0] - ONE + self.tau * (decay - e[1][1])
        need(whole_det.lo > 0 or whole_det.hi < 0, "the motion is not determined (S2)")
        self.start = -(e[0][1] * one) / whole_det, (e[0][0] - ONE) * one / whole_det
        # V/(−g′) = 1 − a, of which what cancels is left out.
        fast = (self.tau * (ONE - e[0][0] - e[1][1] + decay) / whole_det).times(self.way)
        need(fast.lo > 0, "the speed may not be positive (S2)")
        self.fast, self.e, self.decay = fast.times(self.way), e, decay

    def meets(self):
        """Whether sin of the angle of all the periods is 0: it is a whole number of half turns."""
        (c, k), more = (ends[0] for ends in self.ranges[:2]), (ends[1] for ends in self.ranges[:2])
        square = (k - c * c / 4) * (self.n if self.mirrored else 2 * self.n) ** 2
        whole_turns = square > 0 and square.denominator == 1 and isqrt(square.numerator) ** 2 == square
        return whole_turns and (c, k) == tuple(more)

    def time(self, n): return PI.times(n if self.mirrored else 2 * n)

    def turn(self, n):
        """E over n periods, or half periods: at the upper wall all is seen in a mirror."""
        a, b = self.flow.closed(self.time(n))
        return (-a, -b) if self.mirrored and n % 2 else (a, b)

    def full(self, e): return [[e[0], e[1]], [-(self.k * e[1]), self.flow.last(e)]]

    def wall(self, t):
        """1 − g, −g′, −g″ with Σ a = 1 and Σ j b = 0 put in."""
        drop = slope = bend = ZERO
        for j, a, b in self.terms:
            wave, sine = circle(t.times(j))
            drop += a * (ONE - wave) - b * sine
            slope += (a * sine + b * (ONE - wave)).times(j)
            bend += (a * wave + b * sine).times(j * j)
        return drop, slope, bend

    def free(self):
        """The motion over g′ on all pieces, and in their middles."""
        self.times = ZERO.hull(self.time(1)).cut(self.pieces)
        self.motion = []
        for turn in self.turns[:-1]:
            for t in self.times:
                self.motion.append([self.at(turn, u) for u in (t, t.middle())])

    def at(self, turn, t):
        x, v = self.flow.move(self.flow.product(turn, self.flow.exp(t)), *self.start)
        return x, v, -(self.c * v + self.k * x)

    def depth(self, t):
        drop, slope, _ = self.wall(t)
        return (drop - self.start[0] * slope).times(self.side)

    def cell(self, last, phase):
        ends = [number(x).times(self.way) for x in (last, phase)]
        t = ends[0].hull(ends[1])
        drop, slope, bend = here = self.wall(t)
        leaves = bend if last == 0 else slope.times(self.way)
        rate = (slope - self.start[0] * bend).times(self.side * self.way)
        # At a resonance the rate is that of 1 - g alone, and 0 at the touch.
        rate = leaves.times(self.side) if self.resonant else rate
        need(rate.lo > 0, "nu may not increase (S1)")
        need(leaves.lo > 0, "the speed may not be positive (S2)")
        need(self.clear(t, here), "the gap may not be positive (S3)")
        first = ZERO if last == 0 else self.depth(ends[0])
        self.found.append((first.lo, self.depth(ends[1]), self.word(slope.times(self.way), bend)))

    def word(self, w, bend):
        """By trace and determinant of E times an impact's derivative, times w = |g′|."""
        c, k, tau = self.c, self.k, self.tau
        # At a resonance all terms are multiples of w.
        w = ONE if self.resonant else w
        # The velocity before the impact is −fast/τ times −g′; accelerations are relative to the wall.
        kick = (ONE + tau) * (bend.times(self.way) + (c + k * self.start[0]) * w)
        below = -(tau * kick) / self.fast
        jump = [[-(tau * w), ZERO], [below, -(tau * w)]]
        product = matrix(self.e, jump)
        trace, det = product[0][0] + product[1][1], tau.square() * self.decay
        flip, fold = (ONE + det) * w + trace, (ONE + det) * w - trace
        if flip.hi < 0 or fold.hi < 0:
            return "unstable"
        return "stable" if det.hi < ONE.lo and flip.lo > 0 and fold.lo > 0 else "open"

    def clear(self, t, here):
        """S3, of each wall."""
        if not self.mirrored:
            return self.clear_of(t, here, lambda i: (1, 0), (True, True))
        # In a half period that begins between its windows a wall is half a period on, and the motion has the other sign.
        far = lambda first: lambda i: (-1, 1) if (first + i) % 2 else (1, 0)
        odd = self.n % 2 == 1
        return self.clear_of(t, here, far(0), (True, not odd)) and self.clear_of(t, here, far(1), (False, odd))

    def clear_of(self, t, here, side, contacts):
        """Z > 0 by pieces that are open, convex, rising or falling; `side` has for each period, or half period, the sign
        of the motion, and by how many half periods the wall is on."""
        mid, count = t.middle(), self.pieces
        centre, away = self.wall(mid), t - mid
        late = [PI.times(n) for n in ((0, 1) if self.mirrored else (0,))]
        walls = [[(self.wall(t + u + more), self.wall(mid + u.middle() + more), u - u.middle()) for u in self.times]
                 for more in late]

        def gap(shape, there, x):
            return there[0] - shape[0] - shape[1] * (x[0] - self.start[0]), there[1] - shape[1] * x[1]

        def drift(there, x):
            return there[1] - here[1] - here[2] * (x[0] - self.start[0]), there[2] - here[2] * x[1]

        def both(x, y):
            return y if x.both(y).empty() else x.both(y)
        signs, flat = [], []
        for i, (x, x_mid) in enumerate(self.motion):
            sign, on = side(i // count)
            x, x_mid = ([y.times(sign) for y in z] for z in (x, x_mid))
            there, there_mid, along = walls[on][i % count]
            z, slope = gap(here, there, x)
            z_mid, slope_mid = gap(centre, there_mid, x_mid)
            by = drift(there, x)
            bend = there[2] - here[1] * x[2]
            slope = both(slope, slope_mid + by[1] * away + bend * along)
            height = z_mid + by[0] * away + slope * along
            signs.append([z.lo > 0 or height.lo > 0, (slope.lo > 0) - (slope.hi < 0), bend.lo > 0])
            flat.append((bend.lo, slope_mid))

        def dips(first, last):
            """Whether Z > 0 on convex pieces, by its value and slope at one time."""
            least = Range(min(bend for bend, _ in flat[first:last + 1]))
            for n in range(1, self.n):
                if side(n)[1] == 0 and first <= n * count <= last + 1:
                    x, v, _ = self.at(self.turns[n], ZERO)
                    low = (self.start[0] - x).times(self.way)
                    if (low - here[1].times(self.way) * (ONE - v).square() / least.times(2)).lo > 0:
                        return True
            i = min(range(first, last + 1), key=lambda i: flat[i][1].size())
            u, (bend, slope) = self.times[i % count], flat[i]
            time = (u.middle() - slope / Range(bend)).middle()
            time = Range(min(max(time.lo, u.lo), u.hi))
            sign, on = side(i // count)
            x = [y.times(sign) for y in self.at(self.turns[i // count], time)]
            time = time + late[on]
            z, slope = gap(centre, self.wall(mid + time), x)
            by = drift(self.wall(t + time), x)
            z, slope = z + by[0] * away, slope + by[1] * away
            return (z - slope.square() / least.times(2)).lo > 0
        end, i = len(signs), 0
        while i < end:
            j = i
            while j < end and signs[j][2]:
                j += 1
            closed = [n for n in range(i, j) if not signs[n][0]]
            if closed and 0 < i and j < end and dips(closed[0], closed[-1]):
                for n in closed:
                    signs[n][0] = True
            i = max(j, i + 1)
        return carried(signs, *contacts)

    def told(self):
        """What is said in the parts."""
        first = Fraction(0)
        for depth, word in self.parts:
            for least, most, known in self.found:
                apart = most.hi <= number(first).lo or number(depth).hi <= least
                need(word in ("open", known) or apart, f"the orbit may not be {word}")
            first = depth
        need(number(first).hi <= self.found[-1][1].lo, "the cells may not reach the last depth")


if __name__ == "__main__":
    chaos.main(File)
