#!/usr/bin/env python3
"""Writes machine_normal_forms.csv: which way bifurcations of coupled machines go, by mpmath.

At each bifurcation of make_machine_bifurcations.py the Poincare map, from just after the impact to there at
fixed times, is taken by differences in 60 digits: a displaced state flies in closed form, the time of its
impact is a root, and the image is flown back to the orbit's own time. Along q, the critical eigenvector, with p
the left one, p q = 1, the normal forms are

    saddle-node     x -> x + a x^2,     flip     x -> -x + b x^3,     Neimark-Sacker     z -> e^{i theta} z (1 + d |z|^2)

on the centre manifold. The length of q is that of (delay, change of speed / speed) at the impact. The column
`side` of a saddle-node is the sign of -drift/a, drift = p dP/dF: both orbits exist for larger F where it is 1.
Nothing here is shared with the program.

    python3 make_machine_normal_forms.py > machine_normal_forms.csv
"""

from mpmath import mp, mpf, mpc, matrix, expm, eye, findroot, pi, exp, eig, hypot, lu_solve, sqrt

from make_machine_bifurcations import MACHINES, Machine, fold, flip, torus

mp.dps = 60
STEP = mpf(10) ** -12


class Map:
    def __init__(self, machine, V, tau):
        self.m, self.V, self.tau = machine, V, tau
        self.F, self.t, self.x, self.linear = machine.orbit(V, tau)
        n = machine.n
        self.kick = matrix(2 * n, 1)
        for i in range(n):
            self.kick[n + i] = (1 + tau) * machine.b[i] / machine.felt

    def flow(self, F, t, x, s):
        return self.m.forced(F, t + s) + expm(self.m.A * s) * (x - self.m.forced(F, t))

    def impact(self, displaced, F=None):
        """The image of a displacement, the delay of the impact and its speed."""
        F = self.F if F is None else F
        whole = 2 * pi * self.m.periods
        end = self.m.forced(F, self.t + whole) + self.m.E * (self.x + displaced - self.m.forced(F, self.t))
        gap = lambda s: self.m.seen(self.flow(F, self.t, end, s), 0) - self.m.offset
        speed = self.m.seen(end, 1)
        late = -gap(mpf(0)) / speed
        for _ in range(7):
            late -= gap(late) / self.m.seen(self.flow(F, self.t, end, late), 1)
        there = self.flow(F, self.t, end, late)
        V = -self.m.seen(there, 1)
        back = self.flow(F, self.t + late, there + self.kick * V, -late)
        return back - self.x, late, V

    def eigenvectors(self, near):
        values, left, right = eig(self.linear, left=True, right=True)
        k = min(range(len(values)), key=lambda i: abs(values[i] - near))
        q, p = right[:, k], left[k, :].T
        if abs(mpc(values[k]).imag) < mpf(10) ** -20:
            turn = max(q, key=abs)
            q, p = (q / turn).apply(lambda z: mpc(z).real), p
        parts = []
        for part in (lambda z: mpc(z).real, lambda z: mpc(z).imag):
            _, late, V = self.impact(q.apply(part) * STEP)
            _, early, W = self.impact(q.apply(part) * -STEP)
            parts.append(((late - early) / (2 * STEP), (V - W) / (2 * STEP) / self.V))
        q = q / sqrt(sum(x**2 for part in parts for x in part))
        p = p / sum(p[i] * q[i] for i in range(len(q)))
        return values[k], q, p


def along(p, x):
    return sum(p[i] * x[i] for i in range(len(x)))


def saddle_node(m):
    _, q, p = m.eigenvectors(1)
    image = lambda e: m.impact(q * e)[0]
    a = along(p, image(STEP) + image(-STEP)) / (2 * STEP**2)
    if m.impact(q * STEP)[1] < 0:
        a = -a
        p = -p
    zero = q * 0
    drift = along(p, m.impact(zero, m.F + STEP)[0] - m.impact(zero, m.F - STEP)[0]) / (2 * STEP)
    a, drift = mpc(a).real, mpc(drift).real
    return a, 1 if drift / a < 0 else -1


def flipped(m):
    _, q, p = m.eigenvectors(-1)
    image = lambda e, h: m.impact(q * e + h * (e**2 / 2))[0]
    zero = q * 0
    h = lu_solve(eye(len(q)) - m.linear, (image(STEP, zero) + image(-STEP, zero)) / STEP**2)
    odd = along(p, image(STEP, h) - image(-STEP, h)) / (2 * STEP)
    return mpc(odd + 1).real / STEP**2, 0


def circle(m):
    value = next(x for x in eig(m.linear, left=False, right=False) if abs(abs(x) - 1) < mpf(10) ** -20 and x.imag > 0)
    value, q, p = m.eigenvectors(value)
    zero, count = q * 0, 12

    def mean(order, h, g):
        total = zero
        for k in range(count):
            z = STEP * exp(mpc(0, 2) * pi * k / count)
            x = (q * (2 * z) + h * z**2).apply(lambda w: mpc(w).real) + g * abs(z) ** 2
            total = total + m.impact(x)[0] * (STEP / z) ** order
        return total / count

    h = lu_solve(eye(len(q)) * value**2 - m.linear, mean(2, zero, zero) * 2 / STEP**2)
    g = lu_solve(eye(len(q)) - m.linear, mean(0, zero, zero).apply(lambda w: mpc(w).real) / STEP**2)
    return ((along(p, mean(1, h, g)) / STEP / value - 1) / STEP**2).real, 0


if __name__ == "__main__":
    print("machine,event,coefficient,side")
    machines = {name: Machine(*given) for name, given in MACHINES.items()}
    for event, function, form, name, V, tau in [
        ("saddle-node", fold, saddle_node, "driven", "0.145", "0.9"),
        ("neimark-sacker", torus, circle, "driven", "0.1485", "0.9"),
        ("neimark-sacker", torus, circle, "stopped", "0.3285", "0.7"),
        ("flip", flip, flipped, "second", "0.448", "0.85"),
        ("neimark-sacker", torus, circle, "three", "0.235", "0.9"),
    ]:
        V = findroot(lambda v: function(machines[name], v, mpf(tau)), mpf(V))
        coefficient, side = form(Map(machines[name], V, mpf(tau)))
        print(",".join([name, event, mp.nstr(mpf(coefficient), 20), str(side)]), flush=True)
