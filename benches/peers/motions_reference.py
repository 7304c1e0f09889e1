"""Where the motions of motions.py are after their periods, to 30 digits and more, by Taylor series in mpmath.

Usage: motions_reference.py, with mpmath 1.4.1; writes CSV to standard output: motion, impacts, agreement, state. `state` is
q_1 ... q_n u_1 ... u_n with 40 digits. Each motion is followed twice, with 60 and 75 digits, other orders and other steps;
`agreement` is the largest difference of the two.

Between impacts the solution is a Taylor polynomial per step, the gap another one. Its first root is bracketed on a grid that
is fine near the start (where a bounce may be short) and, where the gap falls and rises again between two points, at the
minimum. Steps are shorter where a tanh has a pole near its argument. After an impact the gap starts at exactly 0, so that bounces may shrink to any size without loss. A rebound slower
than 1e-36 onto a wall that presses is rest, until the force of contact is 0.
"""

import sys

from mpmath import cos, hypot, mp, mpf, pi, sin, tanh

from motions import MOTIONS, PERIODS

AT_REST = mpf(10) ** -36


class Follower:
    def __init__(self, m, order, step):
        self.m, self.order, self.step = m, order, mpf(step)
        self.t, self.impacts = mpf(0), 0
        self.q, self.u = [mpf(x) for x in m["start"]], [mpf(0)] * m["modes"]
        self.touching = 0  # how many of the first Taylor coefficients of the gap are exactly 0
        self.resting = False

    def cosine(self):
        """Taylor coefficients of cos at t."""
        c, s, out, factorial = cos(self.t), sin(self.t), [], mpf(1)
        for j in range(self.order + 1):
            out.append([c, -s, -c, s][j % 4] / factorial)
            factorial *= j + 1
        return out

    def series(self, drive):
        m, n = self.m, self.order
        q = []
        for i in range(m["modes"]):
            x = [self.q[i], self.u[i]]
            square, cube, rubbing, bend = [], [], [], []
            for j in range(n - 1):
                if m["cubic"]:
                    square.append(sum(x[a] * x[j - a] for a in range(j + 1)))
                    cube.append(sum(square[a] * x[j - a] for a in range(j + 1)))
                a = -m["damping"][i] * (j + 1) * x[j + 1] - m["stiffness"][i] * x[j] + m["amplitude"][i] * drive[j]
                if m["cubic"]:
                    a -= m["cubic"] * cube[j]
                if m["friction"]:
                    # y = tanh(u/w): y' = (1 - y^2) u'/w.
                    w = mpf(m["width"])
                    rubbing.append(
                        tanh(x[1] / w) if j == 0 else sum(bend[a] * (j - a) * (j - a + 1) * x[j - a + 1] for a in range(j)) / (j * w)
                    )
                    bend.append((1 if j == 0 else 0) - sum(rubbing[a] * rubbing[j - a] for a in range(j + 1)))
                    a -= m["friction"] * rubbing[j]
                if j == 0:
                    a += m["force"]
                x.append(a / ((j + 1) * (j + 2)))
            q.append(x)
        return q

    def gap(self, q, drive):
        m = self.m
        z = [sum(w * x[j] for w, x in zip(m["row"], q)) - m["wall"] * drive[j] for j in range(self.order + 1)]
        z[0] -= m["offset"]
        return [mpf(0)] * self.touching + z[self.touching:]

    def go(self, dt, q):
        self.q = [value(x, dt) for x in q]
        self.u = [value(derivative(x), dt) for x in q]
        self.t += dt

    def advance(self, end):
        m = self.m
        drive = self.cosine()
        dt = min(self.step, end - self.t)
        if m["friction"]:
            # A part of the way to the nearest pole of the force, at less than 3 for an acceleration.
            dt = min(dt, self.step / 6 * hypot(self.u[0], pi / 2 * m["width"]))
        if self.resting:
            # One mode: the wall takes it along until its own acceleration would be greater than the wall's.
            def lift(t):
                wall = m["wall"]
                q, u, a = m["offset"] + wall * cos(t), -wall * sin(t), -wall * cos(t)
                return -m["damping"][0] * u - m["stiffness"][0] * q + m["force"] + m["amplitude"][0] * cos(t) - a
            t, last = self.t, None
            while lift(t) <= 0 and t < end:
                last, t = t, min(t + self.step / 8, end)
            if lift(t) > 0:
                low, high = last, t
                for _ in range(int(mp.prec) + 10):
                    middle = (low + high) / 2
                    low, high = (middle, high) if lift(middle) <= 0 else (low, middle)
                t, self.resting, self.touching = high, False, 3
            self.t = t
            self.q, self.u = [m["offset"] + m["wall"] * cos(t)], [-m["wall"] * sin(t)]
            return
        q = self.series(drive)
        z = self.gap(q, drive)
        root = first_root(z, dt, self.touching)
        self.touching = 0
        if root is None:
            self.go(dt, q)
            return
        rate = value(derivative(z), root)
        self.go(root, q)
        mobility = sum(w * w for w in m["row"])
        e = mpf(m["restitution"])
        self.u = [u - (1 + e) * rate * w / mobility for u, w in zip(self.u, m["row"])]
        self.touching = 1
        if -rate > m["slowest"]:
            self.impacts += 1
        if -e * rate < AT_REST:
            assert m["modes"] == 1
            self.resting = True

    def follow(self):
        end = 2 * pi * PERIODS
        while self.t < end:
            self.advance(end)
        return self.q + self.u


def value(x, t):
    total = mpf(0)
    for c in reversed(x):
        total = total * t + c
    return total


def derivative(x):
    return [j * c for j, c in enumerate(x)][1:]


def first_root(z, dt, touching):
    """The first t in (0, dt] where the gap falls through 0."""
    p = z[touching:]  # the root at the start is none
    slope = derivative(p)
    grid = [dt * j / 16 for j in range(1, 17)]
    if touching:
        # Down to a tenth of where the tangent at the start has its root.
        start, shortest = dt / 16, abs(p[0] / p[1]) / 10
        while start > shortest:
            start /= 2
            grid.insert(0, start)
    left, low = mpf(0), p_sign(slope, mpf(0))
    for right in grid:
        if p_sign(p, right) < 0:
            return bisect(p, left, right)
        high = p_sign(slope, right)
        if low < 0 < high:
            bottom = bisect([-c for c in slope], left, right)
            if value(p, bottom) < 0:
                return bisect(p, left, bottom)
        left, low = right, high
    return None


def p_sign(p, t):
    """A number of the sign of p(t): in floats where they are certain of it."""
    x, total, size = float(t), 0.0, 0.0
    for c in reversed(p):
        total = total * x + float(c)
        size = size * x + abs(float(c))
    return total if abs(total) > 1e-12 * size else value(p, t)


def bisect(p, low, high):
    """Where p falls through 0: bisection, then Newton's method."""
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if value(p, middle) > 0 else (low, middle)
    x, slope = (low + high) / 2, derivative(p)
    for _ in range(8):
        step = value(p, x) / value(slope, x)
        x -= step
        if abs(step) < abs(x) * mpf(10) ** (-mp.dps + 5):
            break
    return x


def main():
    print("motion,impacts,agreement,state")
    for m in MOTIONS:
        found = []
        for digits, order, step in [(60, 44, "0.125"), (75, 56, "0.1")]:
            mp.dps = digits
            follower = Follower(m, order, step)
            found.append((follower.follow(), follower.impacts))
        (a, impacts), (b, again) = found
        assert impacts == again, m["name"]
        agreement = max(abs(x - y) for x, y in zip(a, b))
        assert agreement < mpf(10) ** -30, (m["name"], agreement)
        state = " ".join(mp.nstr(x, 40) for x in b)
        print(f'{m["name"]},{impacts},{mp.nstr(agreement, 2)},{state}', flush=True)
        print(m["name"], impacts, mp.nstr(agreement, 2), file=sys.stderr)


if __name__ == "__main__":
    main()
