"""References for tests/motion/simulation.rs: impacts of linear oscillators, to 30 digits. Prints tests/data/impacts.toml; needs mpmath.

Another route than the crate's: the forcing joins the state, whose matrix exponential (mpmath) steps a fine grid; minima of the gap are
roots of its derivative between samples of opposite sign, impacts are roots before a minimum or between samples of opposite sign."""

from mpmath import mp, mpf, matrix, expm, findroot, cos, sin, sqrt, pi

mp.dps = 40
STEP = mpf(1) / 64


def system(damping=0, stiffness=0, force=0, forcing=(), lower=None, upper=None):
    return dict(damping=damping, stiffness=stiffness, force=force, forcing=list(forcing), lower=lower, upper=upper)


def wall(offset, restitution, harmonics=()):
    return dict(offset=offset, restitution=restitution, harmonics=list(harmonics))


class Motion:
    """q, u, 1, then cos kt, sin kt for each k."""

    def __init__(self, s):
        self.s = s
        harmonics = list(s["forcing"])
        walls = [w for w in (s["lower"], s["upper"]) if w]
        self.ks = sorted({h[0] for h in harmonics} | {h[0] for w in walls for h in w["harmonics"]})
        n = 3 + 2 * len(self.ks)
        a = matrix(n, n)
        a[0, 1], a[1, 0], a[1, 1], a[1, 2] = 1, -mpf(s["stiffness"]), -mpf(s["damping"]), mpf(s["force"])
        for i, k in enumerate(self.ks):
            c = 3 + 2 * i
            a[c, c + 1], a[c + 1, c] = -k, k
            for kk, x, y in harmonics:
                if kk == k:
                    a[1, c] += mpf(x)
                    a[1, c + 1] += mpf(y)
        self.a, self.step = a, expm(a * STEP, method="taylor")

    def start(self, t, q, u):
        x = matrix(3 + 2 * len(self.ks), 1)
        x[0], x[1], x[2] = mpf(q), mpf(u), 1
        for i, k in enumerate(self.ks):
            x[3 + 2 * i], x[4 + 2 * i] = cos(k * mpf(t)), sin(k * mpf(t))
        return x

    def after(self, x, dt):
        return expm(self.a * dt, method="taylor") * x

    def row(self, side):
        w, sign = self.s[side], 1 if side == "lower" else -1
        row = matrix(1, 3 + 2 * len(self.ks))
        row[0], row[2] = sign, -sign * mpf(w["offset"])
        for k, x, y in w["harmonics"]:
            i = 3 + 2 * self.ks.index(k)
            row[i] -= sign * mpf(x)
            row[i + 1] -= sign * mpf(y)
        return row


def bisect(f, low, high):
    """f(low) > 0 >= f(high), or the other way round."""
    rising = f(low) < f(high)
    for _ in range(25):
        middle = (low + high) / 2
        if (f(middle) > 0) == rising:
            high = middle
        else:
            low = middle
    return findroot(f, (low, high), solver="anderson", tol=mpf(10) ** -60, verify=False)


def impacts(s, t, q, u, until):
    m = Motion(s)
    rows = {side: (m.row(side), m.row(side) * m.a) for side in ("lower", "upper") if s[side]}
    t, x, found = mpf(t), m.start(t, q, u), []
    while t < until:
        nearest = None
        nxt = m.step * x
        for side, (z, v) in rows.items():
            gap = lambda dt: (z * m.after(x, dt))[0]
            speed = lambda dt: (v * m.after(x, dt))[0]
            ends, slopes = ((z * x)[0], (z * nxt)[0]), ((v * x)[0], (v * nxt)[0])
            low, high = mpf(0), STEP
            if abs(ends[0]) < mpf(10) ** -30:
                if slopes[0] < 0:
                    nearest = (mpf(0), side, slopes[0])
                    break
                # Just left the wall: look from its top on.
                if slopes[1] >= 0:
                    continue
                low = bisect(speed, low, high)
            if ends[1] < 0:
                at = bisect(gap, low, high)
            elif slopes[0] < 0 < slopes[1]:
                bottom = bisect(speed, low, high)
                if gap(bottom) >= 0:
                    continue
                at = bisect(gap, low, bottom)
            else:
                continue
            if nearest is None or at < nearest[0]:
                nearest = (at, side, speed(at))
        if nearest is None:
            t, x = t + STEP, nxt
            continue
        at, side, velocity = nearest
        if t + at > until:
            break
        found.append((t + at, side, velocity))
        sign = 1 if side == "lower" else -1
        t, x = t + at, m.after(x, at)
        x[1] -= sign * (1 + mpf(s[side]["restitution"])) * velocity
        # Exactly on the wall again, up to the precision of the root.
        x[0] -= sign * (rows[side][0] * x)[0]
    return found


def paper(d, w, mu, tau):
    return system(2 * d / w, 1 / (w * w), lower=wall(-1.0, tau, [(1, 1 + mu, 0.0)]))


W = 4.9
CASES = [
    ("paper's scene, chaotic", paper(0.6, W, 0.003, 1.0), (1.0, 0.01, 0.0), 60, 1e-8),
    ("grazing, depth 2e-12", paper(0.6, W, 2e-12, 1.0), (1.0, 0.0, 0.0), 8, 1e-8),
    ("grazing, depth 1e-9", paper(0.6, W, 1e-9, 0.5), (1.0, 0.0, 0.0), 8, 1e-9),
    ("no damping at all", paper(0.0, W, 0.1, 1.0), (1.0, 0.3, 0.0), 40, 1e-9),
    ("critical damping", paper(1.0, W, 0.1, 0.9), (1.0, 0.3, 0.0), 60, 1e-10),
    ("near critical damping", system(2.0, 1.0 + 1e-9, 0, [(1, 1.0, 0.0)], wall(-0.1, 0.7)), (0.0, 1.0, 0.0), 40, 1e-10),
    ("overdamped", system(9.0, 1.0, 0, [(2, 3.0, 1.0)], wall(-0.05, 0.9)), (0.0, 0.5, 0.0), 30, 1e-9),
    ("resonance", system(0.0, 1.0, 0, [(1, 0.1, 0.0)], wall(-1.5, 0.8)), (0.0, 0.1, 0.0), 60, 1e-9),
    ("near resonance", system(0.0, 1.0 + 1e-7, 0, [(1, 0.1, 0.0)], wall(-1.5, 0.8)), (0.0, 0.1, 0.0), 60, 1e-9),
    ("near resonance, damped", system(0.01, 4.01, 0, [(2, 0.1, 0.2)], wall(-0.5, 0.8)), (0.5, 0.1, 0.0), 60, 1e-9),
    ("ball on a moving table", system(force=-1.0, lower=wall(0.0, 0.8, [(1, 0.0, 1.5)])), (0.0, 2.0, 0.0), 40, 1e-8),
    ("gravity and drag", system(0.3, 0.0, -1.0, [], wall(0.0, 0.9, [(2, 0.5, 0.0)])), (0.0, 2.0, 0.0), 20, 1e-9),
    ("two walls", system(0.1, 1.0, 0, [(1, 1.0, 0.0), (3, 0.0, 0.4)], wall(-0.5, 0.7), wall(0.6, 0.9)), (0.3, 0.1, 0.0), 40, 1e-8),
    ("two moving walls, no spring", system(0, 0, 0, [], wall(-1, 1.0, [(1, 0.1, 0.0)]), wall(1, 1.0, [(2, 0.0, 0.1)])), (0.0, 0.0, 1.0), 40, 1e-8),
    ("negative stiffness between walls", system(0.2, -0.5, 0, [(1, 0.5, 0.0)], wall(-1, 0.8), wall(1, 0.8)), (0.0, 0.1, 0.0), 40, 1e-8),
    ("upper wall alone, fast harmonic", system(0.05, 2.0, 0.3, [(1, 0.5, 0.0), (9, 2.0, 1.0)], None, wall(0.3, 0.9, [(4, 0.02, 0.0)])), (0.0, 0.0, 0.0), 15, 1e-8),
    ("an impact at the initial time", paper(0.6, W, 0.1, 0.8), (0.0, 0.1, -1.0), 30, 1e-9),
    ("a stiff spring", system(1.0, 400.0, 0, [(1, 3.0, 0.0)], wall(-0.001, 0.9)), (0.0, 0.05, 0.0), 2, 1e-9),
]

print("# Written by make_impacts.py; do not edit. Harmonics are [k, cos, sin]; an impact is [time, wall, z' on arrival].")
for name, s, (t, q, u), until, tolerance in CASES:
    print(f"\n[[case]]\nname = \"{name}\"\ntolerance = {tolerance}")
    harmonics = lambda hs: "[" + ", ".join(f"[{k}, {float(x)!r}, {float(y)!r}]" for k, x, y in hs) + "]"
    for key in ("damping", "stiffness", "force"):
        print(f"{key} = {float(s[key])!r}")
    print(f"forcing = {harmonics(s['forcing'])}")
    for side in ("lower", "upper"):
        if w := s[side]:
            print(f"{side} = {{ offset = {float(w['offset'])!r}, restitution = {float(w['restitution'])!r}, harmonics = {harmonics(w['harmonics'])} }}")
    print(f"start = [{t!r}, {q!r}, {u!r}]\nuntil = {float(until)!r}\nimpacts = [")
    for time, side, velocity in impacts(s, t, q, u, until):
        print(f"    [{float(time)!r}, \"{side}\", {float(velocity)!r}],")
    print("]")
