#!/usr/bin/env python3
"""Writes machine_bifurcations.csv: bifurcations of coupled machines with one impact every n periods, by mpmath.

A linear machine M q'' + C q' + K q = F f cos t meets one stop w q >= offset once every n periods of 2 pi. With
x_p the forced response, E the exponential of its matrix over n periods and k = (0, (1 + tau) b / (w b)),
b = M^-1 w, the state just after the impact is x_p(t) + P V, P = (I - E)^-1 k, V the incoming speed. The gap
and its rate at the impact give F and t of every V in closed form:

    F |r| cos(t + arg r) = offset - (P V)_gap,    F |r| sin(t + arg r) = V + ((P - k) V)_rate,    r = w z,

z the complex response to F = 1. So the branch over F is explicit in V, and a bifurcation is a root in V of one
function of the monodromy matrix S E, S the saltation matrix at the impact: det(I - S E), det(I + S E), or
1 - l1 l2 for its two complex eigenvalues l1, l2; of a minimum of a gap for grazing. Points of codimension two
are roots in V and tau. Nothing here is shared with the program: no Newton's method on impacts, no continuation.

    python3 make_machine_bifurcations.py > machine_bifurcations.csv
"""

from mpmath import mp, mpf, matrix, expm, eye, det, findroot, pi, cos, sin, exp, mpc, atan2, hypot, arg, eig, lu_solve

mp.dps = 40


class Machine:
    def __init__(self, mass, damping, stiffness, force, row, offset, periods):
        self.n = len(mass)
        self.M, self.C, self.K = matrix(mass), matrix(damping), matrix(stiffness)
        self.f, self.w, self.offset, self.periods = matrix(force), matrix(row), mpf(offset), periods
        n = self.n
        inverse = self.M ** -1
        self.A = matrix(2 * n, 2 * n)
        mk, mc = inverse * self.K, inverse * self.C
        for i in range(n):
            self.A[i, n + i] = 1
            for j in range(n):
                self.A[n + i, j], self.A[n + i, n + j] = -mk[i, j], -mc[i, j]
        self.pushed = inverse * self.f
        self.b = inverse * self.w
        self.felt = sum(self.w[i] * self.b[i] for i in range(n))
        self.z = lu_solve(self.K - self.M + mpc(0, 1) * self.C, self.f)
        self.E = expm(self.A * (2 * pi * periods))

    def seen(self, x, part, row=None):
        row = self.w if row is None else row
        return sum(row[i] * x[part * self.n + i] for i in range(self.n))

    def forced(self, F, t):
        n, turn = self.n, exp(mpc(0, 1) * t)
        x = matrix(2 * n, 1)
        for i in range(n):
            x[i], x[n + i] = (F * self.z[i] * turn).real, (mpc(0, 1) * F * self.z[i] * turn).real
        return x

    def field(self, F, t, x):
        y = self.A * x
        for i in range(self.n):
            y[self.n + i] += F * self.pushed[i] * cos(t)
        return y

    def orbit(self, V, tau):
        """F, t, the state just after the impact, the monodromy matrix."""
        n = self.n
        k = matrix(2 * n, 1)
        for i in range(n):
            k[n + i] = (1 + tau) * self.b[i] / self.felt
        P = lu_solve(eye(2 * n) - self.E, k)
        r = sum(self.w[i] * self.z[i] for i in range(n))
        even = self.offset - self.seen(P, 0) * V
        odd = V + self.seen(P - k, 1) * V
        F = hypot(even, odd) / abs(r)
        t = atan2(odd, even) - arg(r)
        after = self.forced(F, t) + P * V
        before = after - k * V
        fast, slow = self.field(F, t, before), self.field(F, t, after)
        bend = self.seen(fast, 1)
        S = eye(2 * n)
        for i in range(2 * n):
            for j in range(n):
                S[i, j] += (fast[i] - k[i] * bend - slow[i]) / V * self.w[j]
                S[i, n + j] -= k[i] * self.w[j]
        return F, t, after, S * self.E

    def after(self, F, t, x, s):
        """The state a time s later, without impact."""
        return self.forced(F, t + s) + expm(self.A * s) * (x - self.forced(F, t))


def roots(m):
    return eig(m, left=False, right=False)


def fold(m, V, tau):
    return det(eye(2 * m.n) - m.orbit(V, tau)[3])


def flip(m, V, tau):
    return det(eye(2 * m.n) + m.orbit(V, tau)[3])


def torus(m, V, tau):
    pairs = [x for x in roots(m.orbit(V, tau)[3]) if x.imag > mpf(10) ** -20]
    return min((1 - abs(x) ** 2 for x in pairs), key=abs)


def slope(m, V, tau, sign):
    """Sum over the multipliers of the products of 1 + sign l of all others."""
    values = roots(m.orbit(V, tau)[3])
    total = 0
    for i in range(len(values)):
        product = 1
        for j, x in enumerate(values):
            if j != i:
                product *= 1 + sign * x
        total += product
    return mpc(total).real


def chain(n, ground, springs, dampers, masses):
    """Masses in a row, the first held to the ground."""
    K, C, M = matrix(n, n), matrix(n, n), matrix(n, n)
    for i in range(n):
        M[i, i] = mpf(masses[i])
    K[0, 0] += mpf(ground[0])
    C[0, 0] += mpf(ground[1])
    for i in range(n - 1):
        for (a, b, s) in ((i, i, 1), (i + 1, i + 1, 1), (i, i + 1, -1), (i + 1, i, -1)):
            K[a, b] += s * mpf(springs[i])
            C[a, b] += s * mpf(dampers[i])
    return M, C, K


MACHINES = {
    # the stop at the first mass, the force on the second
    "driven": (*chain(2, ("1.6", "0.05"), ["5.5"], ["0.09"], [1, 3]), [0, 1], [1, 0], -1, 1),
    "stopped": (*chain(2, ("2.9", "0.2"), ["2.7"], ["0.07"], [1, 1]), [1, 0], [1, 0], -1, 1),
    "second": (*chain(2, ("0.9", "0.2"), ["1.6"], ["0.14"], [1, 3]), [0, 1], [0, 1], -1, 2),
    "slow": (*chain(2, ("1.91", "0.05"), ["0.22"], ["0.02"], [1, 1]), [1, 0], [1, 0], -1, 1),
    "stiff": (*chain(2, ("0.48", "0.06"), ["3.87"], ["0.04"], [1, "0.5"]), [0, 1], [1, 0], -1, 1),
    "three": (*chain(3, ("1.6", "0.05"), ["5.5", "3"], ["0.09", "0.05"], [1, 3, "0.5"]), [0, 1, 0], [1, 0, 0], -1, 1),
}


def grazing(m, V, s, tau):
    F, t, x, _ = m.orbit(V, tau)
    y = m.after(F, t, x, s)
    return [m.seen(y, 0) - m.offset, m.seen(y, 1)]


def show(name, event, m, V, tau):
    F, t, _, matrix_ = m.orbit(V, tau)
    values = sorted(roots(matrix_), key=lambda x: -abs(x))
    phase = (t / (2 * pi)) % 1
    first = values[0]
    row = [F, tau, V, phase, first.real, abs(first.imag)]
    print(",".join([name, event] + [mp.nstr(mpf(x), 25) for x in row]), flush=True)


if __name__ == "__main__":
    print("machine,event,F,tau,V,phase,re,im")
    m = {name: Machine(*given) for name, given in MACHINES.items()}
    for event, function, name, V, tau in [
        ("saddle-node", fold, "driven", "0.145", "0.9"),
        ("neimark-sacker", torus, "driven", "0.1485", "0.9"),
        ("neimark-sacker", torus, "stopped", "0.3285", "0.7"),
        ("flip", flip, "second", "0.448", "0.85"),
        ("neimark-sacker", torus, "three", "0.235", "0.9"),
    ]:
        V = findroot(lambda v: function(m[name], v, mpf(tau)), mpf(V))
        show(name, event, m[name], V, mpf(tau))
    for event, first, second, name, V, tau in [
        ("1:1-resonance", fold, lambda *at: slope(*at, -1), "driven", "0.1444", "0.973"),
        ("1:2-resonance", flip, lambda *at: slope(*at, 1), "slow", "0.0795", "0.78"),
        ("fold-flip", fold, flip, "stiff", "2.5", "0.8"),
    ]:
        both = lambda v, t: [first(m[name], v, t), second(m[name], v, t)]
        V, tau = findroot(both, (mpf(V), mpf(tau)))
        show(name, event, m[name], V, tau)
    V, s = findroot(lambda v, s: grazing(m["three"], v, s, mpf("0.9")), (mpf("0.287"), mpf(1)))
    show("three", "grazing", m["three"], V, mpf("0.9"))
