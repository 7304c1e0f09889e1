#!/usr/bin/env python3
"""Writes orbits.toml: periodic orbits of the paper's oscillator (65)-(67) that are hard to compute, with references in 50 digits.

    pip install mpmath && python3 tests/data/make_orbits.py > tests/data/orbits.toml

Impact times and speeds are roots of the pattern equations by mpmath's own root finder, multipliers those of products of
flow and saltation matrices, minima of the gap roots of its derivative: nothing is shared with the crate.
"""
from mpmath import mp, mpf, matrix, cos, sin, exp, sqrt, pi, findroot, eye

mp.dps = 50

def flow(d, w, t):
    c, k = 2 * d / w, 1 / w**2
    square = k - c * c / 4
    omega = sqrt(square)
    C, S = (mpf(1), t) if square == 0 else (mp.re(mp.cos(omega * t)), mp.re(mp.sin(omega * t) / omega))
    return exp(-c * t / 2) * matrix([[C + c / 2 * S, S], [-k * S, C - c / 2 * S]])

# name, d, w, tau, mu, pattern, start (t, V, ...), tolerance
CASES = [
    ("period 3 of the paper", "0.6", "4.9", "1", "0.003", [3], [-0.03, 0.039], 1e-12),
    ("period 1 just after grazing", "0.6", "4.9", "1", "1e-12", [1], [-4e-14, 1.5e-13], 1e-12),
    ("near the fold, fast", "0.6", "4.9", "1", "-0.08433847", [4], [-0.4138, 0.3683], 1e-7),
    ("near the fold, slow", "0.6", "4.9", "1", "-0.08433847", [4], [-0.4134, 0.36798], 1e-7),
    ("near the flip", "0.6", "4.9", "1", "0.00547904", [3], [-0.0517, 0.064], 1e-12),
    ("two impacts", "0.6", "4.9", "1", "0.0058", [3, 3], [-0.0957, 0.0999, -0.008, 0.028], 1e-11),
    ("two impacts past their grazing", "0.6", "4.9", "1", "0.0062", [3, 3], [-0.117, 0.118, 0.011, 0.0115], 1e-11),
    ("period 4 past its grazing", "0.6", "4.9", "1", "0.003", [4], [-0.834, 0.743], 1e-12),
    ("inelastic", "0.6", "4.9", "0", "0.01", [2], [-0.01, 0.01], 1e-12),
    ("nearly inelastic", "0.6", "4.9", "1e-9", "0.01", [1], [-0.001, 0.01], 1e-12),
    ("gaining energy", "0.6", "4.9", "1.4", "0.004", [2], [-0.001, 0.002], 1e-12),
    ("overdamped", "2", "3", "0.8", "0.001", [1], [-0.001, 0.001], 1e-12),
    ("critically damped", "1", "4", "0.8", "0.001", [1], [-0.001, 0.001], 1e-12),
    ("weakly damped", "1e-6", "4.9", "1", "0.001", [2], [-0.001, 0.001], 1e-11),
    ("singular boundary", "0.6", "4.8", "1", "1e-14", [3], [-1.4e-7, 1.7e-7], 1e-11),
    ("many periods, an impact that does not come in", "0.01", "7.3", "0.9", "0.3", [20], [-0.5, 0.5], 1e-10),
]

def solve(d, w, tau, mu, pattern, start):
    m = len(pattern)
    def wall(t): return (1 + mu) * cos(t) - 1, -(1 + mu) * sin(t), -(1 + mu) * cos(t)
    def time(z, i): return 2 * pi * pattern[i] + z[2 * ((i + 1) % m)] - z[2 * i]
    def after(z, i):
        Q, v, _ = wall(z[2 * i])
        return matrix([Q, v + tau * z[2 * i + 1]])
    def equations(*z):
        out = []
        for i in range(m):
            j = (i + 1) % m
            end = flow(d, w, time(z, i)) * after(z, i)
            Q, v, _ = wall(z[2 * j])
            out += [end[0] - Q, end[1] - v + z[2 * j + 1]]
        return out
    z = list(findroot(equations, start, tol=mpf(10) ** -80, maxsteps=60))
    c, k = 2 * d / w, 1 / w**2
    product, minima = eye(2), []
    for i in range(m):
        j = (i + 1) % m
        T, x = time(z, i), after(z, i)
        E = flow(d, w, T)
        Q, v, a = wall(z[2 * j])
        V = z[2 * j + 1]
        before, behind = -c * (v - V) - k * Q, -c * (v + tau * V) - k * Q
        S = matrix([[-tau, 0], [(-tau * before + (1 + tau) * a - behind) / V, -tau]])
        product = S * E * product
        def gap(s):
            y, (Q, v, _) = flow(d, w, s) * x, wall(z[2 * i] + s)
            return y[0] - Q, y[1] - v
        steps = 60 * max(pattern[i], 1)
        speeds = [gap(T * (n + mpf(1) / 2) / steps)[1] for n in range(steps)]
        for n in range(steps - 1):
            if speeds[n] < 0 <= speeds[n + 1]:
                bracket = [T * (n + mpf(1) / 2) / steps, T * (n + mpf(3) / 2) / steps]
                s = findroot(lambda s: gap(s)[1], bracket, solver="anderson", tol=mpf(10) ** -60)
                minima.append(gap(s)[0])
    return z, product[0, 0] + product[1, 1], mp.det(product), min(minima, default=None)

def show(x): return mp.nstr(x, 22, min_fixed=-4, max_fixed=4)

print("# Written by make_orbits.py: periodic orbits of the paper's oscillator, references in 50 digits.")
for name, d, w, tau, mu, pattern, start, tolerance in CASES:
    z, trace, det, least = solve(mpf(d), mpf(w), mpf(tau), mpf(mu), pattern, start)
    ok = all(V > 0 for V in z[1::2]) and (least is None or least > 0)
    print(f"\n[[case]]\nname = \"{name}\"")
    print(f"d = {d}\nw = {w}\ntau = {tau}\nmu = {mu}\npattern = {pattern}")
    print(f"z = [{', '.join(show(x) for x in z)}]")
    print(f"trace = {show(trace)}\ndeterminant = {show(det)}")
    if least is not None:
        print(f"least = {show(least)}")
    print(f"admissible = {str(ok).lower()}\ntolerance = {tolerance}")
