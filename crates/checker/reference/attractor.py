#!/usr/bin/env python3
"""A second reader of certificates of kinds attractor and attractor 2, for whoever would rather trust Python.

usage: attractor.py FILE…   prints "FILE: proved, chaos that attracts" or "FILE: rejected: reason"; exit code 1 if one is
                            rejected.

Written from the forms (the heads of crates/checker/src/attractor/mod.rs and of cells/mod.rs beside it) and from proofs/attractor.md alone. Numbers are
those of chaos.py, the second reader of kind chaos. Of the trap nothing is divided by the depth or its root, as the
checker's numbers are: these are the constants (1) to (10) of the page. The rates are of the two corners of c and k; the motion
is e^-aT times what 1 - e^-(b - a)T gives; a growth is compared with its own power of e^R. Of cells the exponentials are
taken at each time anew, and where a return leads is compared with fractions.
"""
from fractions import Fraction
from math import isqrt

import chaos
from chaos import BITS, CIRCLE, ONE, PI, UNIT, Range, decimal, exponential, fraction, need, number, whole

STATEMENT = (
    "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the listed depth, consider the "
    "motions of the oscillator q'' = -c q' - k q above the wall Q(t) = nu - 1 + g(t) with restitution tau: q is never "
    "below the wall, free where it is above, and where it meets the wall it leaves at tau times the speed at which it "
    "comes. Let a < b be the roots of z^2 - c z + k, which are real and positive, and V = q' - Q' before a contact, "
    "which is a graze if V = 0. With the listed speed S, slip Z, growth E and start X let D be the contacts at which Q "
    ">= 0, -S sqrt(nu) <= V <= 0 and 0 <= a Q + Q' + V <= Z nu. Then after a contact in D the motion is free for a "
    "time, until a next contact, which is in D. Every motion that begins at a time at which Q <= 0, with q >= 0 and 0 "
    "<= a q + q' <= X, is in D from its third contact on. Small displacements of q and q' at a fixed time, just before "
    "a contact in D that is no graze, for which neither that of q nor that of a q + q' is below 0, become, but for "
    "their sign, such displacements just before the next contact, and that of q grows E-fold at least. No periodic "
    "motion whose contacts are in D, grazing or not, is stable in Lyapunov's sense. Every motion whose contacts are in "
    "D and no grazes has a positive Lyapunov exponent; where an exponent R is listed with a nu, from that nu on it is "
    "at least R in each period 2 pi. Of the motions that begin as said almost all never graze. It is not said that "
    "there is one attractor, that a motion comes near all of it, or how long it is where.")

STATEMENT_2 = (
    "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, and for every nu between the listed depths, these "
    "included, consider the motions of the oscillator q'' = -c q' - k q above the wall Q(t) = nu - 1 + g(t) with "
    "restitution tau: q is never below the wall, free where it is above, and where it meets the wall it leaves at tau "
    "times the speed at which it comes. Let a < b be the roots of z^2 - c z + k, which are real and positive, and V = "
    "q' - Q' before a contact, which is a graze if V = 0. With the listed speed S, slip Z and start X let D be the "
    "contacts at which Q >= 0, -S sqrt(nu) <= V <= 0 and 0 <= a Q + Q' + V <= Z nu. Then after a contact in D the "
    "motion is free for a time, until a next contact, which is in D and comes n passages of the wall later, with n "
    "from 1 to the listed L. Every motion that begins at a time at which Q <= 0, with q >= 0 and 0 <= a q + q' <= X, "
    "is in D from its third contact on. The listed cells cut the numbers from 0 to S, and a contact in D has the "
    "weight of a cell that holds -V / sqrt(nu). Small displacements of q and q' at a fixed time, just before a "
    "contact in D that is no graze, for which neither that of q nor that of a q + q' is below 0, become, but for "
    "their sign, such displacements just before the next contact, and that of q times the weight of its contact grows "
    "at least G-fold and e^(R n)-fold, for the listed G > 1 and R > 0. No periodic motion whose contacts are in D, "
    "grazing or not, is stable in Lyapunov's sense. Every motion whose contacts are in D and no grazes has a Lyapunov "
    "exponent of at least R in each period 2 pi. Of the motions that begin as said almost all never graze. It is not "
    "said that there is one attractor, that a motion comes near all of it, or how long it is where.")

TURN = PI.times(2)
ROUNDS = 3


def root(x):
    """The square roots."""
    need(x.lo >= 0, "a root of less than 0 (A1)")
    return Range(isqrt(x.lo << BITS), isqrt(x.hi << BITS) + 1)


def decay(x):
    """e^-x, x >= 0; of long times from 0."""
    least = exponential(-Range(min(x.hi, 70 * UNIT))).lo if x.hi < 70 * UNIT else 0
    return Range(least, exponential(-Range(min(x.lo, 70 * UNIT))).hi)


def up_to(x, y): return x.hi <= y.lo


class File(chaos.File):
    """A certificate, read and held to its form."""
    mirrored, side = False, 1

    def __init__(self, text):
        kind = self.start(text, {"attractor": STATEMENT, "attractor 2": STATEMENT_2})
        self.read_wall()
        self.weighted = kind == "attractor 2"
        words = self.words("depths", 2) if self.weighted else self.words("depth", 1)
        self.least, self.depth = fraction(words[0]), fraction(words[-1])
        need(0 < self.least <= self.depth, "a depth is above 0")
        # `parameter.py` asks for the last cell's depth.
        self.cells = [(self.depth,)]
        self.window, self.bends = self.two("window"), self.two("bends")
        self.cosine = self.harmonics == [(1, (1, 1), (0, 0))]
        if not self.cosine:
            self.concave = self.two("concave")
            self.pieces = whole(self.words("pieces", 1)[0], 1, 1000)
        self.speed, self.slip = (decimal(self.words(name, 1)[0], True) for name in ("speed", "slip"))
        if self.weighted:
            self.read_cells()
        else:
            self.read_growth()
        need(not self.lines, "the file goes on")

    def read_cells(self):
        self.begin = decimal(self.words("start", 1)[0], True)
        grown, rate, last = self.words("growth", 3)
        self.growth, self.rate, self.last = decimal(grown, True), decimal(rate, True), whole(last, 1, 200)
        need(self.growth > 1, "a growth is above 1")
        self.parts, start = [], Fraction(0)
        cells = whole(self.words("cells", 1)[0], 1, 2000)
        need(cells * self.last <= 40000, "the check would take too long")
        for _ in range(cells):
            end, weight = self.words("cell", 2)
            self.parts.append((start, decimal(end, True), whole(weight, 1, 10**6)))
            need(start < self.parts[-1][1], "the ends of cells increase")
            start = self.parts[-1][1]
        need(start == self.speed, "the last cell ends at the speed")

    def read_growth(self):
        grown, last = self.words("growth", 2)
        self.growth, self.last = decimal(grown, True), whole(last, 1, 1000)
        need(self.growth > 1, "a growth is above 1")
        self.begin = decimal(self.words("start", 1)[0], True)
        words = self.words("exponent")
        self.exponent = None
        if words != ["none"]:
            need(len(words) == 3, "a line exponent")
            self.exponent = fraction(words[0]), decimal(words[1], True), whole(words[2], 1, 2000)
            need(0 < self.exponent[0] <= self.depth, "the depth of an exponent")

    def two(self, name): return [decimal(word, True) for word in self.words(name, 2)]

    def check(self):
        """Proves everything; the title."""
        self.wall()
        self.trap()
        if self.weighted:
            self.starts()
            self.weighs()
            return "chaos that attracts"
        grown = {}

        def growths(n):
            if n not in grown:
                grown[n] = self.growths(n)
            return grown[n]
        least = number(self.growth)
        for n in range(1, self.last + 1):
            need(up_to(least, growths(n)[1]) or n < self.last and up_to(least, growths(n)[0]), f"growth over {n} (A5)")
        self.starts()
        if self.exponent:
            least, rate, last = self.exponent
            self.returns(number(least), last)
            step = power = exponential(number(rate))
            for n in range(1, last + 1):
                need(any(up_to(power, x) for x in growths(n)), f"the exponent over {n} (A7)")
                power = power * step
        return "chaos that attracts"

    def shape(self, t):
        """1 - g and -g'' at times t."""
        drop = bend = Range(0)
        for j, a, b in self.harmonics:
            (wave, sine), a, b = CIRCLE.exp(t.times(j)), number(*a), number(*b)
            drop += a * (ONE - wave) - b * sine
            bend += (a * wave + b * sine).times(j * j)
        return drop, bend

    def wall(self):
        """A1 of the wall."""
        depth = number(self.depth)
        ends = [-number(self.window[0]), number(self.window[1])]
        need((ends[1] - ends[0]).hi < TURN.lo, "the window is longer than a period (A1)")
        if self.cosine:
            # cos falls up to pi; its square root of half: sin(t/2)² = (1 - cos t)/2.
            for end in ends:
                sine = CIRCLE.exp(end.times(1, 2))[1]
                need(end.size() < PI.lo and up_to(depth, sine.square().times(2)), "outside the window (A1)")
            need(self.depth < 1 and self.bends[0] <= 1 - self.depth and self.bends[1] >= 1, "the bends (A1)")
            return
        first, last = -number(self.concave[0]), number(self.concave[1])
        need(up_to(first, ends[0]) and up_to(ends[1], last) and (last - first).hi < TURN.lo, "the window (A1)")
        low, high = map(number, self.bends)
        need(all(up_to(depth, self.shape(end)[0]) for end in ends), "outside the window (A1)")
        for t in first.hull(last).cut(self.pieces):
            need(self.shape(t)[1].lo > 0, "concave (A1)")
        for t in last.hull(first + TURN).cut(self.pieces):
            need(self.shape(t)[0].lo > depth.hi, "outside the window (A1)")
        for t in ends[0].hull(ends[1]).cut(self.pieces):
            bend = self.shape(t)[1]
            need(up_to(low, bend) and up_to(bend, high), "the bends (A1)")

    def trap(self):
        """A1 of the machine, A2 to A4: (1) to (8) of the page, the speed and the slip being those listed."""
        (c0, c1), (k0, k1), tau = self.ranges
        need(c0 > 0 and k0 > 0 and c0 * c0 > 4 * k1, "overdamped (A1)")
        # Of each rate the corners: c least and k greatest, and the other way round.
        corners = [(number(c), root(number(c * c - 4 * k))) for c, k in ((c0, k1), (c1, k0))]
        (a1, b0), (a0, b1) = [((c - d).times(1, 2), (c + d).times(1, 2)) for c, d in corners]
        self.slow, self.fast, self.apart = (a0, b0), (a1, b1), corners[0][1].hull(corners[1][1])
        a, b, apart = a0.hull(a1), b0.hull(b1), self.apart
        self.tau, mu = number(*tau), number(self.depth)
        self.mu, self.wide = mu, number(sum(self.window))
        alpha, most = map(number, self.bends)
        self.zeta, self.v = number(self.slip) * mu, number(self.speed) * root(mu)
        short = TURN - self.wide
        d = Range(apart.lo)
        need(d.lo > 0, "overdamped (A1)")
        need(up_to(mu * d / (ONE / decay(d * short) - ONE), self.zeta), "the slip (A2)")
        first = mu / ((ONE + self.tau) * self.reach(1))
        early = alpha - b.square() * exponential(b * self.wide) * (self.zeta + (ONE + self.tau) * first) / apart
        need(early.lo > 0, "convex before (A3)")
        most += a.square() * (mu + self.zeta / apart)
        share = decay(a * TURN)
        deep = (ONE - share) * mu + share * (self.tau * first).square() / early.times(2)
        need(up_to((most * deep).times(2), number(self.speed**2 * self.depth)), "the speed (A3)")
        late = alpha - b.square() * (self.zeta + (ONE + self.tau) * self.v) / apart
        need(late.lo > 0, "convex after (A4)")
        self.sigma = self.tau * (alpha - b.square() * self.zeta / apart) + late
        steep = max((self.v + self.zeta).hi, (a * mu).hi)
        self.low = mu - Range(steep).square() / alpha.times(2)
        self.rates = a, b, alpha, number(self.bends[1])

    def corner(self, rates, time):
        """E11 and E12 of two rates."""
        a, b = rates
        slow, lost = decay(a * time), ONE - decay((b - a) * time)
        part = lost / (b - a)
        return slow * (ONE + a * part), slow * part

    def reach(self, n):
        """l(n), from below."""
        ends = (self.corner(self.fast, TURN.times(n) + end)[1].lo for end in (-self.wide, self.wide))
        return Range(max(min(ends), 0))

    def growths(self, n):
        """(9) and (10)."""
        rest = Range(self.corner(self.slow, TURN.times(n) - self.wide)[0].hi)
        way = ((ONE + self.tau) * self.v + self.zeta) * self.v
        return self.sigma * self.reach(n) / self.v, self.sigma * (self.low - rest * self.mu) / way

    def starts(self):
        """A6."""
        begin, (a, b, alpha, most) = number(self.begin), self.rates
        need(up_to(self.zeta, begin), "the start is less than what is trapped (A6)")
        fast = root(((most + a.square() * (self.mu + begin / self.apart)) * self.mu).times(2))
        need((b.square() * (begin + (ONE + self.tau) * fast) / self.apart).hi < alpha.lo, "the start (A6)")

    def returns(self, least, last):
        """A7: by n = L all are back."""
        time = TURN.times(last) - self.wide
        kick = (ONE + self.tau) * number(self.speed) * root(least) + number(self.slip) * least
        rest = Range(self.corner(self.slow, time)[0].hi) * least
        need((rest + decay(self.rates[0] * time) * kick / self.apart).hi < least.lo, "returns (A7)")


    def weighs(self):
        """B1 to B3, at all depths at once."""
        self.mu = number(self.least, self.depth)
        self.unit = root(self.mu)
        self.bend = number(self.bends[0], self.bends[1])
        self.slips, self.speeds = Range(0, number(self.slip).hi), Range(0, number(self.speed).hi)
        step = exponential(number(self.rate))
        for start, end, weight in self.parts:
            contacts = self.contacts(number(start, end))
            n, power = 0, ONE
            while contacts:
                n, power = n + 1, power * step
                need(n <= self.last, "returns may be later (B2)")
                self.grows(contacts, n, power, weight)
                contacts = self.clear(contacts, n)

    def contacts(self, speed):
        """B1: s, y, t, h of contacts and Sigma; or none."""
        a, b, alpha, _ = self.rates
        place, steep = Range(0, UNIT), speed
        for _ in range(ROUNDS):
            steep = speed + self.unit * (self.slips - a * place)
            place = (ONE - steep.square() / self.bend.times(2)).both(place)
            if place.empty():
                return None
        left = (ONE + self.tau) * speed + self.unit * self.slips
        pull = (a + b) * (self.tau * self.mu * self.slips + self.unit * left)
        sigma = (ONE + self.tau) * (alpha + a.square() * self.mu * place) - pull
        return speed, place, -(self.unit * steep / self.bend), left / self.unit, Range(sigma.lo)

    def flight(self, time):
        """What of place and zeta the place comes from, and what is left of zeta."""
        kept, lost = decay(self.rates[0] * time), decay(self.apart * time)
        return kept, kept * (ONE - lost) / self.apart, kept * lost

    def grows(self, contacts, n, power, weight):
        """B2 and B3: a return after n periods, if there is one."""
        speed, place, begin, left, sigma = contacts
        a = self.rates[0]
        fastest = (number(self.speed) + self.unit * self.slips).hi
        time = -(self.unit * Range(-(a * self.unit).hi, fastest) / self.bend)
        height = Range(0, UNIT)
        for _ in range(ROUNDS):
            kept, reach, rest = self.flight(TURN.times(n) + time - begin)
            height = (kept * place + reach * left).both(height)
            slip = (rest * left).both(self.slips)
            if height.empty() or slip.empty():
                return
            drift = self.unit * (a * height - slip)
            below = ONE - height
            steep = root(Range(max(below.lo, 0), max(below.hi, 0)) * self.bend.times(2))
            found = [((steep + drift).both(self.speeds), -steep)]
            falls = steep.both(Range(0, max(drift.hi, 0)))
            if not falls.empty():
                found.append(((drift - falls).both(self.speeds), falls))
            found = [pair for pair in found if not pair[0].empty()]
            if not found:
                return
            after, moved = found[0]
            for other in found[1:]:
                after, moved = after.hull(other[0]), moved.hull(other[1])
            # The growth of this round, before the time is narrowed again.
            stretch = Range((sigma * reach / (self.unit * Range(speed.hi)) + self.tau * kept).lo)
            time = (self.unit * moved / self.bend).both(time)
            if time.empty():
                return
        low, high = (Fraction(x, UNIT) for x in (after.lo, after.hi))
        lightest = min(w for start, end, w in self.parts if start <= high and low <= end)
        need(all(up_to(x.times(weight, lightest), stretch) for x in (number(self.growth), power)),
             f"the growth over {n} (B3)")

    def clear(self, contacts, n):
        """Those that are above the top of pass n; or none."""
        speed, place, begin, left, sigma = contacts
        kept, reach, _ = self.flight(TURN.times(n) - begin)
        least = ((ONE - kept * place) / reach).lo
        if least > left.hi:
            return None
        return speed, place, begin, Range(max(left.lo, least), left.hi), sigma


if __name__ == "__main__":
    chaos.main(File)
