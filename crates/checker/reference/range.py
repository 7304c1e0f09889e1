#!/usr/bin/env python3
"""A second reader of certificates of kind range, for whoever would rather trust Python.

usage: range.py FILE…     prints "FILE: proved, range of chaos", "FILE: proved, range of orbits" or "FILE: rejected:
                          reason"; exit code 1 if one is rejected.

Written from the form (the head of crates/checker/src/range/mod.rs) and from proofs/ranges.md alone. Numbers, the free motion
and the wall are those of chaos.py, the second reader of kind chaos: nothing of the checker's.
"""
from fractions import Fraction
from itertools import product
from types import SimpleNamespace

import chaos
from chaos import ONE, PI, TWO, ZERO, Flow, Range, Wall, decimal, exponential, fraction, need, number, root, whole

STATEMENT = (
    "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the last cell's, the oscillator "
    "q'' = -c q' - k q above the wall sigma nu - 1 + g(t), sigma the listed side, with restitution tau: for every "
    "bi-infinite path of the listed graph of letters and every integer m there is exactly one motion whose impacts, "
    "one between two letters, have times within W of multiples of 2 pi, as many periods 2 pi apart as the letters say, "
    "the impact before letter 0 within W of 2 pi m, each at a phase where g' = nu s/2 with s in the range that the "
    "cell of nu has for the edge between its letters. It has no other impacts, all are at positive speed, and between "
    "them the gap is positive. Where nu is in two cells both have the same motion, and with c, k, tau, g, the path and "
    "m held fixed the times and velocities of its impacts depend continuously on nu, from where it is born at nu = 0. "
    "With the same m, paths whose periods differ somewhere have different motions; on the set of the states (q, q') at "
    "t = pi of all these motions, for all m, the map to t = 3 pi has a topological entropy between the logarithms of "
    "the growth rates.")
STATEMENT_2 = STATEMENT + (
    " If a cell has a line others with a strength S, then for its nu every motion that meets the wall at arbitrarily "
    "early and late times, only within W of multiples of 2 pi where |g'| <= nu S/2, and is bounded if sigma is -1, is "
    "one of these. If c and k are positive, every bounded motion that meets the wall, and only there, is one of these "
    "or, if sigma is -1, has a last impact. S is above |s| in the ranges of all its edges.")

STATEMENT_3 = (
    "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the last cell's, the "
    "oscillator q'' = -c q' - k q between the lower wall w(t) = sigma nu - 1 + g(t), sigma the listed side, and the "
    "upper wall -w(t - pi), both with restitution tau: for every bi-infinite path of the listed graph of letters and "
    "every integer m there is exactly one motion whose impacts, one between two letters, have times within W of "
    "multiples of pi, at the lower wall of even and at the upper wall of odd multiples, as many half periods pi apart "
    "as the letters say, the impact before letter 0 within W of m pi, each at a phase where w', at the upper wall w' "
    "half a period before, is nu s/2 with s in the range that the cell of nu has for the edge between its letters. It "
    "has no other impacts, all are at positive speed, between them the gaps to both walls are positive, as at impacts "
    "is that to the other wall. Where nu is in two cells both have the same motion, and with c, k, tau, g, the path "
    "and m held fixed the times and velocities of its impacts depend continuously on nu, from where it is born at nu "
    "= 0. With the same m, paths whose half periods differ somewhere have different motions; on the set of the states "
    "(q, q') at t = pi/2 of all these motions, for all m, the map F to (-q, -q') at t = 3 pi/2 has a topological "
    "entropy between the logarithms of the growth rates, and the map to t = 5 pi/2 is F applied twice, of twice that "
    "entropy.")
STATEMENT_4 = STATEMENT_3 + (
    " If a cell has a line others with a strength S, then for its nu every motion that meets the walls at arbitrarily "
    "early and late times, only where the above do and |w'|, or at the upper wall |w'| half a period before, is at "
    "most nu S/2, and is bounded if sigma is -1, is one of these. If c and k are positive, every bounded motion that "
    "meets a wall, and only there, is one of these or, if sigma is -1, has a last impact. S is above |s| in the "
    "ranges of all its edges.")


class Sum:
    """A value x and its derivatives by this impact's s, a neighbour's s and nu: x moves by them."""
    def __init__(self, whole, middle, own, other, depth):
        self.whole, self.middle, self.own, self.other, self.depth = whole, middle, own, other, depth


class Cell:
    """A cell of depths, or one depth, with the strengths of all edges cut into parts."""
    def __init__(self, file, nu, strengths, parts):
        self.file, self.wall = file, file.wall
        c, k, self.tau = (number(*ends) for ends in file.ranges)
        self.flow, self.sigma = Flow(c, k), ONE if file.side == 1 else -ONE
        self.nu = nu
        self.mid = self.nu.middle()
        self.early, self.late = TWO / (ONE + self.tau), TWO * self.tau / (ONE + self.tau)
        self.turns = [self.turn(n) for n in range(max(x.periods for x in file.letters) + 1)]
        self.parts = [[(self.impact(self.nu, x), self.impact(self.mid, x.middle())) for x in s.cut(parts)]
                      for s in strengths]
        self.legs = {}
        for d, e in file.pairs:
            for i, first in enumerate(self.parts[d]):
                for j, last in enumerate(self.parts[e]):
                    self.legs[d, i, e, j] = self.leg(file.letters[file.edges[d][1]].periods, first, last)

    def turn(self, n):
        """E over n periods, or half periods: at the upper wall all is seen in a mirror."""
        a, b = self.flow.closed(self.file.time(n))
        return (-a, -b) if self.file.mirrored and n % 2 else (a, b)

    def impact(self, nu, s):
        """s, t, −g″, Q, the derivative of t by s, and those of t and Q by nu; Q moves with t by s/2."""
        t = self.wall.phase((nu * s).times(-1, 2))
        bend, ratio = self.wall.bends(t)
        drop = (nu * s.square() * ratio).times(1, 4)
        if nu.lo > 0:
            other = self.wall.shape(t)[0] / nu
            drop = drop if drop.both(other).empty() else drop.both(other)
        once = ONE / bend
        return s, t, bend, self.sigma - drop, (nu * once).times(-1, 2), (
            (s * once).times(-1, 2), (s.square() * (ratio - once)).times(1, 4))

    def ends(self, n, first, last):
        e = self.flow.product(self.turns[n], self.flow.exp(last[1] - first[1]))
        a = (last[3] - e[0] * first[3]) / e[1]
        return e, a, self.flow.move(e, first[3], a)[1]

    def leg(self, n, first, last):
        """For both velocities their range, middle and derivatives by s, s′, nu: of E(T)(Q, a) = (Q′, p)."""
        (x, x_mid), (y, y_mid) = first, last
        e, a, p = self.ends(n, x, y)
        _, a_mid, p_mid = self.ends(n, x_mid, y_mid)
        moves = x[0] - x_mid[0], y[0] - y_mid[0], self.nu - self.mid
        # (dT, dQ, dQ′) by the first phase, by the last and by nu; the phases' own derivatives.
        changes = ((-ONE, x[0].times(1, 2), ZERO), (ONE, ZERO, y[0].times(1, 2)),
                   (y[5][0] - x[5][0], x[5][1], y[5][1]))
        phases = (x[4], y[4], ONE)
        for _ in range(3):
            force = -(self.flow.c * p + self.flow.k * y[3])
            slopes_a = [(last_q - e[0] * first_q - p * time) / e[1] for time, first_q, last_q in changes]
            slopes_p = [self.flow.last(e) * d - self.flow.k * (e[1] * first_q) + force * time
                        for d, (time, first_q, _) in zip(slopes_a, changes)]
            slopes_a, slopes_p = ([d * phase for d, phase in zip(slopes, phases)] for slopes in (slopes_a, slopes_p))
            a, p = (value.both(self.sum(middle, slopes, moves))
                    for value, middle, slopes in ((a, a_mid, slopes_a), (p, p_mid, slopes_p)))
        return (a, a_mid, slopes_a), (p, p_mid, slopes_p)

    @staticmethod
    def sum(middle, slopes, moves):
        for slope, move in zip(slopes, moves):
            middle = middle + slope * move
        return middle

    def around(self, e, i):
        """At part i of edge e: the a of all legs that follow and the p of all that come, with the neighbour."""
        after, before = [], []
        for (d, j, f, k), ((a, a_mid, by_a), (p, p_mid, by_p)) in self.legs.items():
            if (d, j) == (e, i):
                after.append((Sum(a, a_mid, by_a[0], by_a[1], by_a[2]), self.away(f, k), f))
            if (f, k) == (e, i):
                before.append((Sum(p, p_mid, by_p[1], by_p[0], by_p[2]), self.away(d, j), d))
        return after, before

    def away(self, e, i):
        part, middle = self.parts[e][i]
        return part[0] - middle[0]

    def images(self, e, i, lines):
        """F over all neighbours, with what E2 has on the left."""
        deeper, apart, own = self.nu - self.mid, self.away(e, i), lines[e]
        after, before = self.around(e, i)
        for x, x_apart, f in after:
            for y, y_apart, d in before:
                slope = ONE - own.m + own.m * (self.early * x.own + self.late * y.own)
                far = own.m * (self.early * x.other * x_apart + self.late * y.other * y_apart)
                deep = own.m * (self.early * x.depth + self.late * y.depth) * deeper
                middle = (ONE - own.m) * self.parts[e][i][1][0]
                middle = middle + own.m * (self.early * x.middle + self.late * y.middle)
                size = lambda z, w: Range(z.size()) * w
                left = size(slope, own.w) + size(own.m * self.early * x.other, lines[f].w)
                left = left + size(own.m * self.late * y.other, lines[d].w)
                yield middle + slope * apart + far + deep, left

    def holds(self, lines):
        """E1 to E3."""
        for e, own in enumerate(lines):
            for i in range(len(self.parts[e])):
                for image, left in self.images(e, i, lines):
                    need(image.inside(number(own.low), number(own.high)), "a range may be left (E1)")
                    need(left.hi <= (self.file.contraction * own.w).lo, "the map may not contract (E2)")
                self.fast(e, i)

    def fast(self, e, i):
        """E3: of a − s/2, s/2 − p and a − p one is positive throughout."""
        after, before = self.around(e, i)
        deeper, apart = self.nu - self.mid, self.away(e, i)
        s, middle = self.parts[e][i][0][0].times(1, 2), self.parts[e][i][1][0].times(1, 2)
        half = ONE.times(1, 2)

        def least(x, x_apart, y_middle, y_slope, y):
            """Of x − y, the greater of two lower bounds."""
            near = x.middle - y_middle + (x.own - y_slope) * apart + x.other * x_apart + x.depth * deeper
            return max((x.whole - y).lo, near.lo)
        if all(least(x, d, middle, half, s) > 0 for x, d, _ in after):
            return
        if all(least(Sum(-y.whole, -y.middle, -y.own, -y.other, -y.depth), d, -middle, -half, -s) > 0
               for y, d, _ in before):
            return
        for x, x_apart, _ in after:
            for y, y_apart, _ in before:
                near = x.middle - y.middle + (x.own - y.own) * apart + (x.depth - y.depth) * deeper
                near = near + x.other * x_apart - y.other * y_apart
                need(max(near.lo, (x.whole - y.whole).lo) > 0, "a speed may be 0 (E3)")

    def gaps(self, strengths):
        """H4."""
        impacts = [self.impact(self.nu, s) for s in strengths]
        for d, e in self.file.pairs:
            letter = self.file.letters[self.file.edges[d][1]]
            a = None
            for (x, _, y, _), (after, _) in self.legs.items():
                if (x, y) == (d, e):
                    a = after[0] if a is None else a.hull(after[0])
            need(self.clear(letter.periods, impacts[d], impacts[e], a), "the gap may not be positive (H4)")

    def gap(self, n, start, a, t):
        """Z, Z′, Z″ at a time t after the middle of window n; q̂ and q̂′."""
        e = self.flow.product(self.turns[n], self.flow.exp(t - start[1]))
        q, u = self.flow.move(e, start[3], a)
        drop, slope, bend = self.wall.shape(t)
        curve = bend - self.nu * (self.flow.c * u + self.flow.k * q)
        return (drop + self.nu * (q - self.sigma), slope + self.nu * u, curve), (q, u)

    def clear(self, n, start, stop, a):
        """Of each wall: of the one where the leg begins, and of the other."""
        if not self.file.mirrored:
            return carried(self.all_signs(range(n + 1), n, start, stop, a))
        one, other = (self.all_signs(range(first, n + 1, 2), n, start, stop, a) for first in (0, 1))
        return carried(one, True, n % 2 == 0) and carried(other, False, n % 2 == 1)

    def all_signs(self, windows, n, start, stop, a):
        """Of the wall with these windows."""
        window, pieces = self.file.window, self.file.pieces
        all_signs = []
        if windows[0] == 1:
            all_signs += [self.signs(1, start, a, t) for t in (start[1] - PI).hull(-window).cut(pieces)]
        for k in windows:
            span = (start[1] if k == 0 else -window).hull(stop[1] if k == n else window)
            signs = [self.signs(k, start, a, t) for t in span.cut(pieces)]
            least = min(sign[3] for sign in signs)
            if 0 < k < n and least > 0:
                _, (q, u) = self.gap(k, start, a, ZERO)
                if (q - self.sigma - self.nu * u.square() / Range(2 * least)).lo > 0:
                    signs = [(True, *sign[1:]) for sign in signs]
            all_signs += signs
            if k < n:
                end = PI + stop[1] if k == windows[-1] else TWO * PI - window
                all_signs += [self.signs(k, start, a, t) for t in window.hull(end).cut(pieces)]
        return all_signs

    def signs(self, k, start, a, t):
        """On a piece: whether Z > 0; the sign of Z′ or 0; whether Z″ > 0; the least Z″."""
        (z, slope, bend), _ = self.gap(k, start, a, t)
        (z_mid, slope_mid, _), _ = self.gap(k, start, a, t.middle())
        away = t - t.middle()
        better = slope_mid + bend * away
        slope = slope if slope.both(better).empty() else slope.both(better)
        open = z.lo > 0 or (z_mid + slope * away).lo > 0
        return open, (slope.lo > 0) - (slope.hi < 0), bend.lo > 0, bend.lo


def carried(signs, first=True, last=True):
    """Whether Z > 0 is carried over all pieces from both ends, where it moves away from 0 if they are contacts; of each
    piece whether Z > 0, the sign of Z′ or 0, and whether Z″ > 0."""
    def reach(way, sign, contact):
        positive, known, far = contact, contact, 0
        for open, slope, convex, *_ in way:
            if positive and (slope == sign or (known and convex)):
                known = True
            elif open:
                positive, known = True, False
            else:
                return far
            far += 1
        return far
    return reach(signs, 1, first) + reach(reversed(signs), -1, last) >= len(signs)


class Edge:
    """A line edge."""


class Alone(chaos.Others):
    """That no other motions are near: C1 to C3, whatever the letters, and then F."""
    def __init__(self, file, nu, bound, parts, lines):
        c, k, tau = (number(*ends) for ends in file.ranges)
        near = SimpleNamespace(mirrored=file.mirrored, wall=file.wall, side=file.side, letters=[], longest=lambda: file.most,
                               complete=(bound, file.most, parts, file.rounds))
        super().__init__(chaos.Cell(near, (c, k, ZERO, tau, nu)))
        self.file, self.nu, self.lines = file, nu, lines

    def none(self):
        periods = [letter.periods for letter in self.file.letters]
        need(len(set(periods)) == len(periods), "letters of one period (C)")
        need(all(max(abs(x.low), abs(x.high)) < self.bound for x in self.lines), "a strength is not below S (C)")
        self.letter = {n: v for v, n in enumerate(periods)}
        super().none()

    def legs(self, t, place):
        """For sigma = -1: what is known of the legs of bounded motions, instead of C2."""
        if self.file.side == 1:
            return super().legs(t, place)
        c, k, tau = (number(*ends) for ends in self.file.ranges)
        least, spread = Range(c.lo), Range((k - c.square().times(1, 4)).lo)
        need(least.lo > 0 and spread.lo > 0, "V does not decay (C)")
        c, k, tau, deep = (Range(x.size()) for x in (c, k, tau, place))
        half = number(self.bound / 2)
        still = k * deep.square()
        slow = half.square() + c * half * deep + still

        def decay(n):
            """e to −cT, T as short as a leg of n periods can be."""
            return exponential(-(least * (self.file.time(n) - Range(2 * t.size()))))

        def last(n, speed):
            """√R − c/2 from above; None if R < 0."""
            fast = speed.square() - least * speed + still
            left = (decay(n) * Range(max(fast.hi, slow.hi)) - spread).hi
            return None if left < 0 else (root(left) - least.times(1, 2)).hi
        factor = tau * root(decay(1).hi)
        need((ONE - factor).lo > 0, "no bound of velocities (C)")
        speed = Range(((half * (ONE + tau) + factor * root(slow.hi)) / (ONE - factor)).hi)
        for _ in range(200):
            speed = Range(min(speed.hi, (half * (ONE + tau) + tau * Range(max(last(1, speed) or 0, 0))).hi))
        need(last(self.longest + 1, speed) is None, "a leg may be longer (C)")
        known = {}
        for n in range(1, self.longest + 1):
            slowest = last(n, speed)
            if slowest is not None and -slowest <= half.hi:
                known[n] = Range(-half.hi, speed.hi), Range(-slowest, half.hi)
        return known

    def counted(self, count):
        self.file.room -= count * max(self.longest + 5, 36 * len(self.file.harmonics))
        need(self.file.room >= 0, "that there are no others costs too much (C)")

    def done(self, known):
        edges, sets = self.file.edges, [number(x.low, x.high) for x in self.lines]
        for m, n in product(known, repeat=2):
            s = self.between(known, m, n)
            if s:
                edge = self.letter.get(m), self.letter.get(n)
                if edge not in edges:
                    return False
                sets[edges.index(edge)] = s
        for _ in range(self.rounds):
            if self.inside(sets):
                return True
            count, pairs = len(edges), len(self.file.pairs)
            self.counted(max(letter.periods for letter in self.file.letters) + 1 + self.parts * count)
            self.counted(2 * pairs * self.parts**2 + self.parts * count)
            work = Cell(self.file, self.nu, sets, self.parts)
            for e in range(len(sets)):
                image = None
                for i in range(self.parts):
                    for one, _ in work.images(e, i, self.lines):
                        image = one if image is None else image.hull(one)
                sets[e] = sets[e].both(image) if not sets[e].both(image).empty() else sets[e]
        return self.inside(sets)

    def inside(self, sets):
        return all(s.inside(number(x.low), number(x.high)) for s, x in zip(sets, self.lines))


class File(chaos.File):
    """A certificate, read and held to its form."""
    def __init__(self, text):
        kinds = {"range": STATEMENT, "range 2": STATEMENT_2, "range 3": STATEMENT_3, "range 4": STATEMENT_4}
        kind = self.start(text, kinds)
        self.mirrored, self.second = kind in ("range 3", "range 4"), kind in ("range 2", "range 4")
        self.side = {"1": 1, "-1": -1}.get(self.words("side", 1)[0])
        need(self.side, "a side is 1 or -1")
        self.read_wall()
        self.window = number(decimal(self.words("window", 1)[0], True))
        self.pieces = whole(self.words("pieces", 1)[0], 1, 1000)
        self.read_letters()
        self.rates = self.increasing(self.words("growth", 2))
        need(self.rates[0] >= 1, "a growth rate is at least 1")
        contraction = decimal(self.words("contraction", 1)[0], True)
        need(contraction < 1, "the contraction must be below 1")
        self.contraction = number(contraction)
        if self.second:
            self.most, self.rounds = (whole(self.words(name, 1)[0], 1, most)
                                      for name, most in (("longest", 1000), ("rounds", 100)))
        self.edges = [(u, v) for u, letter in enumerate(self.letters) for v in letter.next]
        self.pairs = [(d, e) for d, (_, u) in enumerate(self.edges) for e, (v, _) in enumerate(self.edges) if u == v]
        self.read_cells()
        need(not self.lines, "the file goes on")
        need(len(self.pairs) * max(cell[1] for cell in self.cells)**2 <= 100_000, "a cell has too many legs")
        need(self.cost() <= 50_000_000, "the check would cost too much")

    def time(self, n): return PI.times(n if self.mirrored else 2 * n)

    def read_letters(self):
        count = whole(self.words("letters", 1)[0], 1, 400)
        self.letters = []
        for _ in range(count):
            periods, gamma = self.words("letter", 2)
            letter = chaos.Letter()
            letter.periods, letter.gamma = whole(periods, 1, 1000), decimal(gamma, True)
            self.letters.append(letter)
        self.read_next()

    def read_cells(self):
        count = whole(self.words("cells", 1)[0], 1, 10_000)
        need(count * len(self.edges) <= 100_000, "too many edges")
        self.cells, last = [], Fraction(0)
        for index in range(count):
            depth, parts, steps = self.words("cell", 3)
            depth, parts, steps = fraction(depth), whole(parts, 1, 64), whole(steps, 0, 1000)
            need(last < depth, "depths increase")
            need(index > 0 or steps == 0, "the first cell has no steps")
            others = self.read_others() if self.second else None
            lines = []
            for _ in self.edges:
                low, high, m, w = self.words("edge", 4)
                edge = Edge()
                edge.low, edge.high = self.increasing((low, high))
                edge.m, edge.w = number(decimal(m)), number(decimal(w, True))
                lines.append(edge)
            self.cells.append((depth, parts, steps, lines, others))
            last = depth

    def read_others(self):
        words = self.words("others")
        if words == ["no"]:
            return None
        need(len(words) == 3, "others no, or three numbers")
        bound, parts, slices = decimal(words[0], True), whole(words[1], 1, 64), whole(words[2], 1, 1000)
        need(parts**2 * slices <= 1000, "too many parts")
        return bound, parts, slices

    def cost(self):
        """In exponentials, as the form says."""
        h, j, letters = len(self.harmonics), self.pieces, self.letters
        count, pairs = len(self.edges), len(self.pairs)
        legs = [letters[self.edges[d][1]].periods for d, _ in self.pairs]
        gaps = sum((2 * n + 1 + self.mirrored) * j * (2 + 2 * h) + n for n in legs)
        triples = sum(len(letters[u].previous) * len(letters[v].next) for u, v in self.edges)
        longest = max(letter.periods for letter in letters)

        def map(s):
            return longest + 1 + 36 * h * s * count + 5 * pairs * s**2 + triples * s**3
        total, before = (j + 2) * h, self.cells[0]
        for cell in self.cells:
            total += map(cell[1]) + 23 * h * count + gaps + cell[2] * map(before[1])
            if cell[4]:
                total += cell[4][2] * (2 * self.most + 3 + 23 * h)
            before = cell
        return total

    def check(self):
        """Proves everything; the title."""
        self.told()
        self.wall = Wall(self.harmonics, self.window, self.pieces)
        self.room = 50_000_000  # what that there are no others may cost
        least, former = Fraction(0), None
        for cell in self.cells:
            depth, parts, steps, lines, others = cell
            if former:
                self.linked(least, former, lines, steps)
            strengths = [number(x.low, x.high) for x in lines]
            work = Cell(self, number(least, depth), strengths, parts)
            work.holds(lines)
            work.gaps(strengths)
            if others:
                bound, cut, slices = others
                for nu in number(least, depth).cut(slices):
                    Alone(self, nu, bound, cut, lines).none()
            least, former = depth, cell
        return "range of chaos" if self.rates[0] > 1 else "range of orbits"

    def linked(self, depth, former, lines, steps):
        _, parts, _, old, _ = former
        sets = [number(x.low, x.high) for x in old]

        def inside():
            return all(s.inside(number(x.low), number(x.high)) for s, x in zip(sets, lines))
        for _ in range(steps):
            if inside():
                return
            work = Cell(self, number(depth), sets, parts)
            for e in range(len(sets)):
                image = None
                for i in range(parts):
                    for one, _ in work.images(e, i, old):
                        image = one if image is None else image.hull(one)
                sets[e] = sets[e].both(image)
                need(not sets[e].empty(), "no motion is left (link)")
        need(inside(), "the motions may be others than before (link)")


if __name__ == "__main__":
    chaos.main(File)
