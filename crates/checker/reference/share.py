#!/usr/bin/env python3
"""A second reader of certificates of kind share, for whoever would rather trust Python.

usage: share.py FILE…     prints "FILE: proved, share P/Q to P/Q" or "FILE: rejected: reason"; exit code 1 if one is
                          rejected.

Written from the form and the rules (the head of crates/checker/src/share) and from proofs/words.md alone. a1 is 2 exp(-zt)
cos sqrt((1 - z^2) t^2), t = 2 pi w, by functions that are entire, so that z = 1 is no case of its own. Signs of u and N
are exact: about the middle of a rectangle both are polynomials with whole coefficients, whose constant term exceeds all
others together. A part on which that does not decide is cut into four, up to eight times: what a checker with narrower
enclosures decides of the whole part is found so. Slow: some milliseconds a part.
"""
from fractions import Fraction

import chaos
from chaos import BITS, ONE, PI, TWO, exponential, need, number, roots, up, whole

STATEMENT = (
    "The listed box is one of parameters (w, z), (r, s) or (a1, a2). To (w, z), for machine, belong the trace a1 "
    "and the determinant a2 of exp(2 pi w A), A the matrix with the rows (0, 1) and (-1, -2 z), and the sign of "
    "gamma, that of the entry of exp(2 pi w A) on the upper right; to (r, s), for polar, a1 = 2 r cos 2 pi s and "
    "a2 = r^2. Let u_0 = 0, u_1 = 1, u_{k+1} = a1 u_k - a2 u_{k-1}, b_{n,k} = (u_n - u_k - a2^k u_{n-k})/u_n, p_n "
    "= (u_{n+1} - 1)/u_n and q_n = (a2^n + a2 u_{n-1})/u_n. A period n occurs, for a sign of e mu, if u_n is not "
    "0 and every b_{n,k} with 0 < k < n has strictly that sign; then its letter is U if p_n > q_n and D if p_n < "
    "q_n. In at least the first and at most the second listed share of the box, by its area, or by length or "
    "number where it has none, what is listed holds. period: it occurs for the listed sign of e mu. word: of the "
    "periods from 1 to the first number those listed occur, with these letters, and no others. chaos: two periods "
    "occur with the letter U if the listed sign of e mu is that of gamma, the listed sign or for machine its own, "
    "and with D if not. Of chaos the second share holds if the word theorem does, as stated and proved in the "
    "folder proofs of the project and not here.")

DEEPEST, MOST = 40, 64
# Points of the plane are whole numbers of 1/SCALE and 1/SCALE^2.
SCALE = 1 << 40
POSITIVE, NEGATIVE = 1, -1


class Polynomials:
    """u_n and N_{n,k} about the middle of a rectangle of (a1, a2), in x SCALE and y SCALE^2, times powers of SCALE."""
    def __init__(self, a1, a2):
        ends = [(a1.lo >> BITS - 40, up(a1.hi, 1 << BITS - 40)), (a2.lo << 80 - BITS, a2.hi << 80 - BITS)]
        self.ends = [ends[0], (max(ends[1][0], 0), min(ends[1][1], SCALE**2))]
        self.middle = [(lo + hi) // 2 for lo, hi in self.ends]
        self.half = [max(hi - m, m - lo) for m, (lo, hi) in zip(self.middle, self.ends)]
        self.u = [{}, {(0, 0): 1}]
        self.known, self.turns, self.known_region = {}, self, None

    def by(self, axis, polynomial):
        """Times a1 or a2."""
        total = {}
        for (i, j), c in polynomial.items():
            other = (i + 1, j) if axis == 0 else (i, j + 1)
            total[i, j] = total.get((i, j), 0) + self.middle[axis] * c
            total[other] = total.get(other, 0) + c
        return total

    def reach(self, n):
        while len(self.u) <= n:
            first, second = self.by(0, self.u[-1]), self.by(1, self.u[-2])
            self.u.append({ij: first.get(ij, 0) - second.get(ij, 0) for ij in first | second})
        return self.u[n]

    def sign(self, polynomial):
        rest = sum(abs(c) * self.half[0]**i * self.half[1]**j for (i, j), c in polynomial.items() if i or j)
        value = polynomial.get((0, 0), 0)
        return POSITIVE if value > rest else NEGATIVE if value < -rest else None

    def of_u(self, n):
        if (n, 0) not in self.known:
            self.known[n, 0] = self.sign(self.reach(n)) if self.turns is self else self.turns.of_u(n)
        return self.known[n, 0]

    def of_n(self, n, k):
        if (n, k) not in self.known:
            self.reach(n)
            third = self.u[n - k]
            for _ in range(k):
                third = self.by(1, third)
            parts = ((self.u[n], SCALE**k), (self.u[k], -SCALE**n), (third, -1))
            total = {}
            for polynomial, factor in parts:
                for ij, c in polynomial.items():
                    total[ij] = total.get(ij, 0) + factor * c
            self.known[n, k] = self.sign(total)
        return self.known[n, k]

    def region(self):
        """The one that all of it is in, or None."""
        if self.known_region:
            return self.known_region
        (lo, hi), (low, high) = self.ends
        one = SCALE**2
        square = [0 if lo <= 0 <= hi else min(lo * lo, hi * hi), max(lo * lo, hi * hi)]
        if square[1] < 4 * low:
            return 3
        if lo * SCALE > one + high:
            return 1
        if hi * SCALE < -(one + high):
            return 5
        return 2 if lo > 0 and square[0] >= 4 * high and hi * SCALE < one + low else None


class File(chaos.File):
    """A certificate, read and held to its form."""
    def __init__(self, text):
        self.lines = [line.removesuffix("\r") for line in text.removesuffix("\n").split("\n")]
        for line in ("grazing-certificate 1", "kind share", "statement " + STATEMENT):
            need(self.take() == line, "another head")
        need(all(len(line.encode()) <= 1000 for line in self.lines), "a line is too long")
        self.kind, *ends = self.words("box", 5)
        need(self.kind in ("machine", "polar", "plane"), "a box of machine, polar or plane")
        (a, b), (c, d) = self.box = self.ordered(ends[:2], chaos.fraction), self.ordered(ends[2:], chaos.fraction)
        need({"machine": a > 0 and b <= 1000 and 0 <= c and d <= 1000, "polar": 0 < a and b <= 1 and 0 < c and 2 * d < 1,
              "plane": 0 < c and d <= 1}[self.kind], "the box is too large")
        self.read_claim(self.words("holds"))
        self.shares = [self.part_of_one(word) for word in self.words("share", 2)]

    def part_of_one(self, word):
        value = chaos.fraction(word)
        need(0 <= value <= 1 and value.denominator <= 1 << DEEPEST, f"no share: {word}")
        return value

    def sign_of(self, word):
        need(word in ("+", "-"), f"no sign: {word}")
        return POSITIVE if word == "+" else NEGATIVE

    def read_claim(self, words):
        need(len(words) >= 2, "no claim")
        self.what, self.side, rest = words[0], self.sign_of(words[1]), words[2:]
        if self.what == "chaos":
            need(len(rest) == (self.kind != "machine"), "a sign of gamma where it is free")
            self.gamma = self.sign_of(rest[0]) if rest else None
            return
        need(self.what in ("period", "word") and rest, "period, word or chaos")
        self.last, self.letters = whole(rest[0], 1, MOST), {}
        need(self.what == "word" or len(rest) == 1, "one period")
        for word in rest[1:]:
            need(word[-1:] in ("U", "D"), f"no letter: {word}")
            n = whole(word[:-1], 1, self.last)
            need(n > max(self.letters, default=0), "periods increase")
            self.letters[n] = word[-1]

    def check(self):
        """Proves everything; the shares."""
        sums, parts = [Fraction(0), Fraction(1)], [(self.box, 0)]
        while parts:
            box, depth = parts.pop()
            line = self.take()
            if line in ("1", "2"):
                need(depth < DEEPEST, "too many halvings")
                parts += [(half, depth + 1) for half in reversed(halves(box, int(line) - 1))]
            elif line in ("+", "-"):
                need(self.everywhere(box, line == "+", 8), "it does not certainly hold in a part")
                sums[line == "-"] += Fraction(1 if line == "+" else -1, 1 << depth)
            else:
                need(line == "?", f"no part: {line}")
        need(not self.lines, "the file goes on")
        need(sums == self.shares, "the shares are others")
        return f"share {self.shares[0]} to {self.shares[1]}"

    def everywhere(self, box, wanted, cuts):
        """Whether the claim holds at all points of a part, or at none."""
        found = self.at(box)
        if found is not None or not cuts:
            return found is wanted
        quarters = [quarter for half in halves(box, 0) for quarter in halves(half, 1)]
        return all(self.everywhere(quarter, wanted, cuts - 1) for quarter in quarters)

    def at(self, box):
        x, y = (number(*ends) for ends in box)
        gamma, region = self.gamma if self.what == "chaos" else None, None
        if self.kind == "machine":
            t = PI.times(2) * x
            cos, sine = roots((ONE - y.square()) * t.square())
            turn, a2 = TWO * cos, exponential(-(y * t).times(2))
            a1, region = turn * exponential(-(y * t)), 3 if y.hi < ONE.lo and sine.lo * sine.hi > 0 else None
            region = 2 if y.lo > ONE.hi else region
            gamma = POSITIVE if sine.lo > 0 else NEGATIVE if sine.hi < 0 else None
        elif self.kind == "polar":
            turn, a2, region = TWO * roots((PI.times(2) * y).square())[0], x.square(), 3
            a1 = turn * x
        else:
            a1, a2 = x, y
        p = Polynomials(a1, a2)
        # u has the sign that it has at (a1/sqrt a2, 1).
        p.turns = p if self.kind == "plane" else Polynomials(turn, ONE)
        p.known_region = region
        if self.what == "period":
            return self.occurs(p, self.last)
        return self.is_word(p) if self.what == "word" else self.is_chaotic(p, gamma)

    def occurs(self, p, n):
        found, u = [p.of_n(n, k) for k in range(1, n)], p.of_u(n)
        if u is None:
            return False if POSITIVE in found and NEGATIVE in found else None
        signs = [None if sign is None else sign * u * self.side for sign in found]
        return False if NEGATIVE in signs else None if None in signs else True

    def letter(self, p, n):
        return {POSITIVE: "U", NEGATIVE: "D", None: None}[p.of_n(2 * n, n)]

    def is_word(self, p):
        certain = True
        for n in range(1, self.last + 1):
            found, listed = self.occurs(p, n), self.letters.get(n)
            if found and listed:
                letter = self.letter(p, n)
                if letter and letter != listed:
                    return False
                certain &= letter is not None
            elif found is None:
                certain = False
            elif found != bool(listed):
                return False
        return certain or None

    def is_chaotic(self, p, gamma):
        if gamma is None:
            return None
        letter, region = "U" if gamma == self.side else "D", p.region()
        if self.side == NEGATIVE:
            none = gamma == NEGATIVE or region == 1 or p.of_u(2) == NEGATIVE
        else:
            none = (region == 2 or region == 1 and letter == "D" or region == 5 and letter == "U"
                    or region == 3 and self.no_second(p, letter))
        if none:
            return False
        seen = 0
        # Two are among the first if they are at all, but for some near a border.
        for n in range(1, 14):
            seen += bool(self.occurs(p, n)) and self.letter(p, n) == letter
            if seen == 2:
                return True
        return None

    def no_second(self, p, letter):
        """In region 3, for e mu > 0: the first period that may be the second with this letter does not occur."""
        over_half = changes(p, range(1, MOST), POSITIVE)
        if letter == "D":
            over_one = over_half and changes(p, range(over_half[-1], MOST), NEGATIVE)
            return bool(over_one) and all(p.of_n(n, 1) == NEGATIVE for n in over_one)
        if p.of_u(2) is None:
            return False
        if p.of_u(2) == POSITIVE:
            return bool(over_half) and all(p.of_n(k + 1, k) == POSITIVE for k in over_half)
        odd = changes(p, range(1, MOST, 2), POSITIVE)
        return bool(odd) and all(p.of_n(n, 2) == POSITIVE for n in odd)


def changes(p, walk, sign):
    """Where u may first have another sign: one place of the walk or two, or nothing."""
    for at, n in enumerate(walk):
        if p.of_u(n) == sign:
            continue
        if p.of_u(n) == -sign:
            return [n]
        return [n, walk[at + 1]] if at + 1 < len(walk) and p.of_u(walk[at + 1]) == -sign else []
    return []


def halves(box, axis):
    lo, hi = box[axis]
    parts = ((lo, (lo + hi) / 2), ((lo + hi) / 2, hi))
    return [(part, box[1]) if axis == 0 else (box[0], part) for part in parts]


if __name__ == "__main__":
    chaos.main(File)
