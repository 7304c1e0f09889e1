"""Motions of linear machines to 50 digits: tests/data/machines.toml.

Each case is M q'' + C q' + K q = f0 + sum (cos_k cos kt + sin_k sin kt), period 2 pi, a state at phase t0 and the states after some durations,
from the exponential of the matrix of (q, q', 1, cos kt, sin kt) in 60-digit arithmetic. Needs mpmath.
"""

import random
from mpmath import mp, matrix, expm, mpf, eye, zeros, cos, sin, nstr

mp.dps = 60


def states(mass, damping, stiffness, force, loads, t0, q0, u0, durations):
    n = len(mass)
    inverse = matrix(mass) ** -1
    size = 2 * n + 1 + 2 * len(loads)
    a = zeros(size)
    mk, mc = inverse * matrix(stiffness), inverse * matrix(damping)
    def put(row_vector, column):
        felt = inverse * matrix(row_vector)
        for i in range(n):
            a[n + i, column] = felt[i]
    for i in range(n):
        a[i, n + i] = 1
        for j in range(n):
            a[n + i, j] = -mk[i, j]
            a[n + i, n + j] = -mc[i, j]
    put(force, 2 * n)
    x = [mpf(v) for v in q0] + [mpf(v) for v in u0] + [mpf(1)]
    for index, (k, c, s) in enumerate(loads):
        at = 2 * n + 1 + 2 * index
        put(c, at)
        put(s, at + 1)
        a[at, at + 1] = -k
        a[at + 1, at] = k
        x += [cos(k * mpf(t0)), sin(k * mpf(t0))]
    for duration in durations:
        end = expm(a * mpf(duration)) * matrix(x)
        yield [nstr(end[i], 50, strip_zeros=False) for i in range(2 * n)]


def diagonal(values):
    return [[v if i == j else 0 for j in range(len(values))] for i, v in enumerate(values)]


random.seed(3)
dense = [[random.randint(-3, 3) / 4 for _ in range(5)] for _ in range(5)]
spd = [[sum(dense[i][k] * dense[j][k] for k in range(5)) + (2 if i == j else 0) for j in range(5)] for i in range(5)]
skew = [[(i - j) / 8 for j in range(5)] for i in range(5)]
some = [[(i * 3 + j * 5) % 7 / 16 for j in range(5)] for i in range(5)]
wave = [(1, 1), (2, -0.5)]

CASES = {
    # name: mass, damping, stiffness, force, loads
    "repeated": (diagonal([1, 1, 2]), diagonal([0.25, 0.5, 0.5]), diagonal([4, 4, 8]), [1, 0, 0], [(1, [1, 0.5, 0], [0, 0, 1])]),
    "repeated rotated": ([[2, 1], [1, 2]], [[0.5, 0.25], [0.25, 0.5]], [[8, 4], [4, 8]], [0, 1], [(3, [1, 0], [0, 1])]),
    "overdamped": (diagonal([1, 2]), [[30, -10], [-10, 30]], [[5, -1], [-1, 5]], [1, 1], [(1, [0, 1], [2, 0])]),
    "critical": ([[1]], [[4]], [[4]], [0.5], [(2, [1], [0])]),
    "defective": (diagonal([1, 1]), [[2, 1], [0, 2]], diagonal([1, 1]), [1, 0], [(1, [1, 1], [0, 0])]),
    "nearly defective": (diagonal([1, 1]), [[2, 1], [1e-9, 2]], diagonal([1, 1]), [1, 0], [(1, [1, 1], [0, 0])]),
    "rigid body": ([[1, 0], [0, 3]], [[0, 0], [0, 0]], [[2, -2], [-2, 2]], [1, -0.5], [(1, [1, 0], [0, 1])]),
    "rigid body, damped apart": (diagonal([1, 2, 1]), diagonal([0.5, 0, 0]), [[2, -2, 0], [-2, 4, -2], [0, -2, 2]], [0, 0, 1], [(1, [1, 0, 0], [0, 0, 0])]),
    "rigid body, defective": (diagonal([1, 1, 1]), [[0, 0, 0], [0, 1, -1], [0, -1, 1]], [[1, -1, 0], [-1, 2, -1], [0, -1, 1]], [1, 0, 0], [(2, [1, 0, 0], [0, 0, 0])]),
    "free mass": ([[2]], [[0]], [[0]], [-3], [(1, [1], [0])]),
    "gyroscopic": (diagonal([1, 1]), [[0.125, -3], [3, 0.125]], diagonal([4, 6]), [0, 0], [(1, [1, 0], [0, 1])]),
    "circulatory": (diagonal([1, 1]), diagonal([0.25, 0.5]), [[4, 1], [-1, 4]], [0, 0], [(1, [1, 0], [0, 1])]),
    "resonant, not classical": (diagonal([1, 1, 1]), [[0, 0, 0], [0, 0.5, -0.25], [0, -0.25, 1]], [[4, 0, 0], [0, 9, 2], [0, 2, 5]], [0, 0, 0], [(2, [1, 0, 0], [0, 0, 0]), (3, [0, 0, 1], [0, 0, 0])]),
    "negative stiffness": (diagonal([1, 1]), [[0.5, -0.25], [-0.25, 0.25]], [[-0.5, 0.25], [0.25, 2]], [0, 0], [(1, [1, 0], [0, 0])]),
    "fast and slow": (diagonal([1, 1, 1]), diagonal([0.125, 2, 8]), diagonal([1.5, 900, 90000]), [1, 0, 0], [(1, [1, 1, 1], [0, 0, 0])]),
    "five, not classical": (spd, some, [[4 * v for v in row] for row in spd], [0] * 5, [(1, [1, 0, 0, 0, 0], [0, 0, 1, 0, 0]), (4, [0, 1, 0, 0, 0], [0] * 5)]),
    "five, gyroscopic": (spd, skew, [[(3 if i == j else 0) + some[i][j] for j in range(5)] for i in range(5)], [0, 1, 0, 0, 0], [(1, [1, 0, 0, 0, 0], [0] * 5)]),
}
CASES |= {
    # One eigenvector for six equal eigenvalues; for two pairs of equal complex ones, undamped and damped; nearly so.
    "defective, threefold": (diagonal([1, 1, 1]), [[2, 1, 0], [0, 2, 1], [0, 0, 2]], diagonal([1, 1, 1]), [1, 0, 0], [(1, [1, 1, 1], [0, 0, 0])]),
    "defective, oscillating": (diagonal([1, 1]), diagonal([0, 0]), [[5, 1], [-1, 3]], [0, 1], [(1, [1, 0], [0, 0])]),
    "defective, damped": (diagonal([1, 1]), diagonal([0.5, 0.5]), [[5, 1], [-1, 3]], [0, 1], [(1, [1, 0], [0, 1])]),
    "defective, other mass": ([[2, 1], [1, 2]], [[4, 3], [2, 6]], [[2, 1], [1, 2]], [0, 1], [(2, [1, 0], [0, 1])]),
    "flutter": (diagonal([1, 1]), diagonal([0.5, 0.25]), [[5, 1], [-1.25, 3]], [0, 1], [(1, [1, 0], [0, 1])]),
    "three, oscillating and overdamped": (diagonal([1, 2, 0.5]), [[6, -2, 0], [-2, 2.5, -0.5], [0, -0.5, 0.5]], [[4, -1, 0], [-1, 8, -2], [0, -2, 3]], [0, 0, 1], [(1, [1, 0, 0], [0, 1, 0]), (5, [0, 0, 1], [0, 0, 0])]),
    "two spirals at resonance": (diagonal([1, 1]), [[0.03125, 0.0625], [-0.0625, 0.015625]], diagonal([4, 9]), [0, 0], [(2, [1, 0], [0, 1]), (3, [0, 1], [1, 0])]),
}
# Modes of mass 1 seen at points of a machine: forces act and motions are looked at there. Fewer points than modes, as many, more.
SHAPES = {
    "shapes, two points of three modes": ([2, 3.5, 11], [0.125, 0.25, 1.5], [[1, 0.5, -0.25], [0.75, -1, 0.5]]),
    "shapes, three points of three modes": ([0.5, 0.5, 4], [0.125, 0, 0.0625], [[1, 0.5, -0.25], [0.75, -1, 0.5], [0.25, 0.25, 1]]),
    "shapes, four points of two modes": ([1, 6], [0.5, 12], [[1, 0.5], [0.75, -1], [-0.5, 0.25], [2, 1]]),
}
for name, (frequencies, damping, shapes) in SHAPES.items():
    n, points = len(frequencies), len(shapes)
    at = [[1 if i == 0 else 0 for i in range(points)], [0.5 if i == points - 1 else 0 for i in range(points)]]
    CASES[name] = (diagonal([1] * n), diagonal(damping), diagonal([w * w for w in frequencies]), [0] * points, [(1, at[0], at[1]), (2, at[1], at[0])], shapes)
DURATIONS = [0.0078125, 0.5, 3, 6.25, 20]

lines = ['# Written by make_machines.py: motions of linear machines to 50 digits.', f"durations = {DURATIONS}"]
for name, (mass, damping, stiffness, force, loads, *given) in CASES.items():
    n = len(mass)
    shapes = given[0] if given else [[int(i == j) for j in range(n)] for i in range(n)]
    q0 = [0.5 - 0.25 * i for i in range(n)]
    u0 = [(-1) ** i * 0.75 for i in range(n)]
    lines += ["", "[[cases]]", f'name = "{name}"']
    for key, value in [("mass", mass), ("damping", damping), ("stiffness", stiffness)]:
        lines.append(f"{key} = {[[float(x) for x in row] for row in value]}")
    if given:
        lines.append(f"shapes = {[[float(x) for x in row] for row in shapes]}")
    lines.append(f"force = {[float(x) for x in force]}")
    lines.append("loads = [" + ", ".join(f"{{ k = {k}, cos = {[float(x) for x in c]}, sin = {[float(x) for x in s]} }}" for k, c, s in loads) + "]")
    lines += ["t0 = 0.75", f"q = {[float(x) for x in q0]}", f"u = {[float(x) for x in u0]}", "states = ["]
    felt = lambda v: [sum(mpf(shapes[i][j]) * mpf(v[i]) for i in range(len(shapes))) for j in range(n)]
    loads = [(k, felt(c), felt(s)) for k, c, s in loads]
    for state in states(mass, damping, stiffness, felt(force), loads, 0.75, q0, u0, DURATIONS):
        seen = lambda part: [sum(mpf(row[j]) * mpf(state[part * n + j]) for j in range(n)) for row in shapes]
        state = [nstr(x, 50, strip_zeros=False) for x in seen(0) + seen(1)] if given else state
        lines.append("  [" + ", ".join(f'"{x}"' for x in state) + "],")
    lines.append("]")
open("machines.toml", "w").write("\n".join(lines) + "\n")
