#!/usr/bin/env python3
"""A second reader of certificates of kind nothing, for whoever would rather trust Python.

usage: nothing.py FILE…   prints "FILE: proved, nothing born" or "FILE: rejected: reason"; exit code 1 if one is rejected.

Written from the form (the head of crates/checker/src/nothing/mod.rs) and from proofs/ranges.md alone. Numbers, the free motion,
the wall and C1 to C3 are those of chaos.py, the second reader of kind chaos: nothing of the checker's.
"""
from fractions import Fraction

import chaos
from chaos import ONE, ZERO, Cell, Others, Wall, decimal, fraction, need, number, whole

STATEMENT = (
    "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the last cell's, consider the "
    "motions of the oscillator q'' = -c q' - k q above the wall nu - 1 + g(t) with restitution tau: q is never below "
    "the wall, free where it is above, and where it meets the wall it leaves at tau times the speed at which it comes, "
    "or rests on the wall while that does not pull. With the listed longest N and rounds R, and S that of a cell of "
    "nu, every motion, in whatever state it begins, meets the wall within (2 R + 2)(N + 1) periods 2 pi, and so again "
    "and again, at a phase that is not within W of a multiple of 2 pi or at which |g'| > nu S/2. And for nu -> 0 "
    "nothing is born, whatever S: let a_n and p_n be the first and the last velocity of q'' = -c q' - k q from q = 1 "
    "to q = 1 in n periods, for those n up to N for which q is at least 1 after each whole period between; there is "
    "no infinite sequence of such n in which a_n >= p_m whenever n follows m. Every n is up to N.")

STATEMENT_2 = (
    "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b in "
    "their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the last cell's, consider the "
    "motions of the oscillator q'' = -c q' - k q between the lower wall w(t) = nu - 1 + g(t) and the upper wall -w(t "
    "- pi), both with restitution tau: q is never below the lower nor above the upper wall, free where it is between, "
    "and where it meets a wall it leaves at tau times the speed at which it comes, or rests on the wall while that "
    "does not pull. With the listed longest N and rounds R, and S that of a cell of nu, every motion, in whatever "
    "state it begins, within (2 R + 2)(N + 1) half periods pi, and so again and again, meets the lower wall at a "
    "phase that is not within W of a multiple of 2 pi or at which |w'| > nu S/2, or the upper wall where half a "
    "period before there is such a phase. And for nu -> 0 nothing is born, whatever S: let a_n be the first velocity "
    "of q'' = -c q' - k q from q = 1 to q = (-1)^n in n half periods, and p_n the last, times (-1)^n, for those n up "
    "to N for which (-1)^k q is at least 1 after k half periods, for each whole k between; there is no infinite "
    "sequence of such n in which a_n >= p_m whenever n follows m. Every n is up to N.")


class File(chaos.File):
    """A certificate, read and held to its form."""
    def __init__(self, text):
        self.mirrored = self.start(text, {"nothing": STATEMENT, "nothing 2": STATEMENT_2}) == "nothing 2"
        self.side, self.letters = 1, []
        self.read_wall()
        self.window = number(decimal(self.words("window", 1)[0], True))
        self.pieces, self.most, self.rounds = (whole(self.words(name, 1)[0], 1, most) for name, most in
                                               (("pieces", 1000), ("longest", 100), ("rounds", 100)))
        self.cells = []
        for _ in range(whole(self.words("cells", 1)[0], 1, 10_000)):
            depth, bound, parts = self.words("cell", 3)
            self.cells.append((fraction(depth), decimal(bound, True), whole(parts, 1, 64)))
        depths = [Fraction(0)] + [cell[0] for cell in self.cells]
        need(all(x < y for x, y in zip(depths, depths[1:])), "depths increase, from 0")
        need(not self.lines, "the file goes on")
        need(self.price() <= 6_000_000, "the check would cost too much")

    def longest(self): return self.most

    def price(self):
        """In exponentials, as the form says."""
        h, n, r = len(self.harmonics), self.most, self.rounds
        cells = (n + 1 + 23 * h + r * n**2 * k * 36 * h + (n + (r - 1) * n**3) * k**2 * (n + 5)
                 for _, _, k in self.cells)
        return (self.pieces + 2) * h + n + 1 + n**2 + sum(cells)

    def check(self):
        """Proves everything; the title."""
        self.wall = Wall(self.harmonics, self.window, self.pieces)
        c, k, tau = (number(*ends) for ends in self.ranges)
        least = Fraction(0)
        for depth, bound, parts in self.cells:
            cell = Cell(self, (c, k, ZERO, tau, number(least, depth)))
            if least == 0:
                self.born(cell)
            self.complete = bound, self.most, parts, self.rounds
            Others(cell).none()
            least = depth
        return "nothing born"

    def born(self, cell):
        """T: what has no successor goes, until nothing is left."""
        flow, legs = cell.flow, {}
        for n in range(1, self.most + 1):
            e = cell.turns[n]
            a = (ONE - e[0]) / e[1]
            if all(flow.move(cell.turns[k], ONE, a)[0].hi >= ONE.lo for k in range(1, n)):
                legs[n] = a, flow.move(e, ONE, a)[1]
        while legs:
            followed = {n: leg for n, leg in legs.items() if any(a.hi >= leg[1].lo for a, _ in legs.values())}
            need(len(followed) < len(legs), "something may be born (T)")
            legs = followed


if __name__ == "__main__":
    chaos.main(File)
