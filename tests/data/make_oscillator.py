#!/usr/bin/env python3
"""Writes oscillator.csv: orbits and events of the paper's example (d = 0.6, w = 4.9, tau = 1) to 40 digits, by mpmath.

    python3 -m venv venv && venv/bin/pip install mpmath==1.4.1
    venv/bin/python tests/data/make_oscillator.py > tests/data/oscillator.csv

Single-impact orbits, saddle-node and flip by formulas in closed form; grazings by Newton's method with finite differences
on flights by matrix exponentials. Lines: orbit,n,mu,t,V,trace,det and
event,name,mu,time of the tangency after the impact before it.
"""
from mpmath import mp, mpf, matrix, expm, eye, sqrt, atan2, pi, cos, sin, findroot, lu_solve

mp.dps = 60
d, w, tau = mpf(6) / 10, mpf(49) / 10, mpf(1)
A = matrix([[0, 1], [-1 / w**2, -2 * d / w]])


def flight(t):
    return expm(A * t)


def p_of(n):
    e = flight(2 * pi * n)
    return e, lu_solve(eye(2) - e, e * matrix([0, 1 + tau]))


def speeds(n, mu):
    """(1 + mu)^2 = (1 + p1 V)^2 + (1 + p2)^2 V^2."""
    _, p = p_of(n)
    a, b, c = p[0] ** 2 + (1 + p[1]) ** 2, p[0], 1 - (1 + mu) ** 2
    root = sqrt(b * b - a * c)
    return [v for v in ((-b + root) / a, (-b - root) / a) if v > 0]


def phase(n, v):
    _, p = p_of(n)
    return atan2(-(1 + p[1]) * v, 1 + p[0] * v)


def trace_det(n, v):
    e, p = p_of(n)
    kappa = p[0] * (1 - 1 / w**2) - (2 * d / w) * (1 + p[1])
    det = tau**2 * mp.exp(-2 * d / w * 2 * pi * n)
    return -tau * (e[0, 0] + e[1, 1]) - (1 + tau) * (1 / v + kappa) * e[0, 1], det


def gap(mu, t, v, s):
    """The gap and its derivative a time s after an impact at t with incoming speed v."""
    x = flight(s) * matrix([(1 + mu) * cos(t) - 1, -(1 + mu) * sin(t) + tau * v])
    return x[0] - (1 + mu) * cos(t + s) + 1, x[1] + (1 + mu) * sin(t + s)


def show(*words):
    print(",".join(word if isinstance(word, str) else mp.nstr(word, 40) for word in words))


for n, mu in [(1, "0.003"), (2, "0.003"), (3, "0.003"), (3, "0.0058"), (4, "-0.05"), (4, "-0.01")]:
    for v in speeds(n, mpf(mu)):
        show("orbit", str(n), mu, phase(n, v), v, *trace_det(n, v))

_, p = p_of(4)
show("event", "sn", abs(1 + p[1]) / sqrt(p[0] ** 2 + (1 + p[1]) ** 2) - 1)
v = findroot(lambda v: trace_det(3, v)[0] + 1 + trace_det(3, v)[1], mpf("0.0632"))
_, p = p_of(3)
show("event", "pd", sqrt((1 + p[0] * v) ** 2 + ((1 + p[1]) * v) ** 2) - 1)


def grazing4(v, s):
    _, p = p_of(4)
    mu = sqrt((1 + p[0] * v) ** 2 + ((1 + p[1]) * v) ** 2) - 1
    return gap(mu, phase(4, v), v, s)


def lowest(mu, t, v, length):
    """About where the gap is lowest away from the two impacts."""
    times = [length * k / 2000 for k in range(40, 1960)]
    return min(times, key=lambda s: gap(mu, t, v, s)[0])


guess = mpf("-0.0244")
v = speeds(4, guess)[0]
v, s = findroot(grazing4, (v, lowest(guess, phase(4, v), v, 8 * pi)))
_, p = p_of(4)
show("event", "gr4", sqrt((1 + p[0] * v) ** 2 + ((1 + p[1]) * v) ** 2) - 1, s)


def grazing3(mu, t1, t2, v1, v2, s):
    z1, y1 = gap(mu, t1, v1, 6 * pi + t2 - t1)
    z2, y2 = gap(mu, t2, v2, 6 * pi + t1 - t2)
    return [z1, y1 + v2, z2, y2 + v1, *gap(mu, t1, v1, s)]


# The double-impact orbit that the flip gives birth to, from a search in floats at mu = 0.006.
t1, t2, v1, v2 = mpf("0.0039"), mpf("-0.1078"), mpf("0.0182"), mpf("0.1098")
s = lowest(mpf("0.006"), t1, v1, 6 * pi)
solution = findroot(grazing3, (mpf("0.006"), t1, t2, v1, v2, s))
show("event", "gr3", solution[0], solution[5])
