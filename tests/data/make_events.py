"""References for tests/motion/references.rs: impacts of 250 random and 120 nearly grazing scenes. Prints tests/data/events.csv; needs mpmath.

Another route than the crate's. Motions are Taylor series of the equation of motion in fixed point with 120 bits, restarted every quarter of a unit of
time and at every impact; a gap is such a series, too. On each step it is looked at in 33 places, in floats; between neighbours with slopes of
opposite sign its minimum is found in 120 bits, and an impact is the root before the first minimum, or place, that is negative.

What a reference is good for is measured: each motion is run again from q + 1e-22, and the tolerance of an impact is what a
perturbation of 1e-15 would have moved it by then, a hundred times, and no less than 1e-12. A motion is followed until its impacts
would be uncertain by 1e-6, become slower than 1e-3 (but for the grazing ones), or 10 have happened."""

import random
import sys
from mpmath import mp, mpf, sin, cos

mp.dps = 40
P = 120
ONE = 1 << P
STEP = ONE // 4
TERMS = 34
PLACES = 32
SLOW = ONE // 1000
# No minimum of a gap is left within this of 0 unless it is meant to be.
CLEAR = ONE // 10**8


def fixed(x):
    """A number as a whole multiple of 2^-P; sums, products and series are of these."""
    return int(mpf(x) * ONE)


def times(a, b):
    return a * b >> P


def harmonics_series(mean, harmonics, t):
    """Taylor coefficients of mean + sum(cos kt, sin kt) about t."""
    out = [0] * TERMS
    out[0] = fixed(mean)
    for k, a, b in harmonics:
        angle = k * mpf(t) / ONE
        s, c = sin(angle), cos(angle)
        even, odd = fixed(a * c + b * s), fixed(b * c - a * s)
        for i in range(TERMS):
            out[i] += even
            even, odd = odd * k // (i + 1), -even * k // (i + 1)
    return out


def motion_series(s, t, q, u):
    force = harmonics_series(s["force"], s["forcing"], t)
    damping, stiffness, cubic = fixed(s["damping"]), fixed(s["stiffness"]), fixed(s["cubic"])
    x = [q, u] + [0] * (TERMS - 2)
    square = []
    for k in range(TERMS - 2):
        total = force[k] - times(damping * (k + 1), x[k + 1]) - times(stiffness, x[k])
        if cubic:
            square.append(sum(x[i] * x[k - i] for i in range(k + 1)) >> P)
            total -= times(cubic, sum(square[i] * x[k - i] for i in range(k + 1)) >> P)
        x[k + 2] = total // ((k + 1) * (k + 2))
    return x


def value(series, x):
    total = 0
    for c in reversed(series):
        total = (total * x >> P) + c
    return total


def looked_at(series, h):
    """Its values in the places of a step, as floats."""
    floats, h, out = [c / ONE for c in reversed(series)], h / ONE, []
    for i in range(PLACES + 1):
        x, total = h * i / PLACES, 0.0
        for c in floats:
            total = total * x + c
        out.append(total)
    return out


def slope(series):
    return [k * c for k, c in enumerate(series)][1:] + [0]


def root(series, low, high):
    """A root between places of opposite sign: Newton's method, kept inside by bisection."""
    d, rising = slope(series), value(series, high) > 0
    x = (low + high) // 2
    for _ in range(300):
        v = value(series, x)
        if v == 0 or high - low < 16:
            return x
        if (v > 0) == rising:
            high = x
        else:
            low = x
        g = value(d, x)
        step = x - (v << P) // g if g else low
        if not (low < step < high):
            step = (low + high) // 2
        if abs(step - x) < 16:
            return step
        x = step
    return x


class Uncertain(Exception):
    pass


def events(s, start, until, most, meant=None):
    """(time, side, velocity) of each impact up to `until`, and the time up to which they are complete."""
    t, q, u = start
    walls = [(side, w) for side, w in (("lower", s["lower"]), ("upper", s["upper"])) if w]
    found, held = [], None
    while t < until:
        h = min(STEP, until - t)
        x = motion_series(s, t, q, u)
        first = None
        for side, w in walls:
            sign = 1 if side == "lower" else -1
            place = harmonics_series(w["offset"], w["harmonics"], t)
            gap = [sign * (a - b) for a, b in zip(x, place)]
            if held == side:
                gap[0] = 0
            speed = slope(gap)
            grid = [h * i // PLACES for i in range(PLACES + 1)]
            gaps, speeds = looked_at(gap, h), looked_at(speed, h)
            # The last place known to be above the wall; just after an impact that is any place soon after.
            above = 0
            for i in range(PLACES):
                if i == 0 and held == side:
                    if speeds[0] <= 0:
                        raise Uncertain("held")
                    if speeds[1] <= 0 or gaps[1] <= 0:
                        raise Uncertain("falls back at once")
                    above = grid[1]
                    continue
                lowest = None
                if speeds[i] < 0 < speeds[i + 1]:
                    bottom = root(speed, grid[i], grid[i + 1])
                    depth = value(gap, bottom)
                    if abs(depth) < (CLEAR if meant is None else meant // 10):
                        raise Uncertain("grazes")
                    lowest = (bottom, depth)
                at = None
                if lowest and lowest[1] < 0:
                    at = root(gap, above, lowest[0])
                elif gaps[i + 1] < 0:
                    at = root(gap, above, grid[i + 1])
                if at is not None:
                    if first is None or at < first[0]:
                        first = (at, side, value(speed, at))
                    break
                above = grid[i + 1]
        if first is None:
            q, u, t, held = value(x, h), value(slope(x), h), t + h, None
            continue
        at, side, velocity = first
        found.append((t + at, side, velocity))
        if len(found) == most:
            return found, t + at
        w, sign = s[side], 1 if side == "lower" else -1
        q, u = value(x, at), value(slope(x), at) - sign * times(ONE + fixed(w["restitution"]), velocity)
        t, held = t + at, side
    return found, until


def rounded(r, low, high, digits=3):
    return round(r.uniform(low, high), digits)


def some_harmonics(r, most, size):
    ks = r.sample([1, 1, 2, 3, 5], r.randint(0, most))
    return [(k, rounded(r, -size, size), rounded(r, 0.3, size)) for k in sorted(set(ks))]


def some_system(r):
    return dict(
        damping=r.choice([0.0, rounded(r, 0, 0.3), rounded(r, 0, 1)]),
        stiffness=r.choice([0.0, rounded(r, 0, 1), rounded(r, 0, 9), rounded(r, -0.3, 0)]),
        cubic=r.choice([0.0, 0.0, 0.0, 0.0, rounded(r, 0, 1)]),
        force=r.choice([0.0, rounded(r, -1, 1)]),
        forcing=some_harmonics(r, 2, 1.0) or [(1, 1.0, 0.0)],
        lower=None,
        upper=None,
    )


def some_wall(r, offset):
    moving = [(k, round(a / 5, 4), round(b / 5, 4)) for k, a, b in some_harmonics(r, 1, 1.0)]
    return dict(offset=offset, restitution=r.choice([1.0, rounded(r, 0.4, 1), rounded(r, 0.7, 1)]), harmonics=moving)


def place_of(w, t):
    return harmonics_series(w["offset"], w["harmonics"], t)[0]


def random_scene(r):
    s = some_system(r)
    side = r.choice(["lower", "upper", "both", "both"])
    if side != "upper":
        s["lower"] = some_wall(r, rounded(r, -0.5, 0.2))
    if side != "lower":
        s["upper"] = some_wall(r, rounded(r, 0.7, 1.2))
    start = (rounded(r, 0, 6.2), rounded(r, 0.25, 0.6), rounded(r, -1, 1))
    return s, start, None


def grazing_scene(r):
    """A wall so that a minimum of the free motion's distance from it is 10^-3 to 10^-10 deep, or short of it."""
    s = some_system(r)
    side = r.choice(["lower", "upper"])
    sign = 1 if side == "lower" else -1
    start = (rounded(r, 0, 6.2), rounded(r, -0.5, 0.5), rounded(r, -1, 1))
    w = some_wall(r, 0.0)
    w["restitution"] = r.choice([1.0, rounded(r, 0.3, 1), rounded(r, 0.7, 1)])
    t, q, u = (fixed(x) for x in start)
    minima, end = [], t + 14 * ONE
    while t < end:
        x = motion_series(s, t, q, u)
        gap = [sign * (a - b) for a, b in zip(x, harmonics_series(0, w["harmonics"], t))]
        speed = slope(gap)
        grid = [STEP * i // PLACES for i in range(PLACES + 1)]
        speeds = looked_at(speed, STEP)
        for i in range(PLACES):
            if speeds[i] < 0 < speeds[i + 1]:
                bottom = root(speed, grid[i], grid[i + 1])
                minima.append(value(gap, bottom))
        q, u, t = value(x, STEP), value(slope(x), STEP), t + STEP
    if not minima:
        raise Uncertain("no minimum")
    # One that is lower than all before it: the motion reaches it without an impact.
    records = [m for i, m in enumerate(minima) if all(m < other for other in minima[:i])]
    depth = fixed(mpf(10) ** -r.uniform(3, 10)) * r.choice([1, -1])
    w["offset"] = (sign * (r.choice(records) + depth)) / ONE
    s[side] = w
    return s, start, abs(depth)


def line(kind, s, start, meant):
    begin = place_of
    for side in ("lower", "upper"):
        w, sign = s[side], 1 if side == "lower" else -1
        if w and sign * (fixed(start[1]) - begin(w, fixed(start[0]))) < ONE // 100:
            raise Uncertain("starts at a wall")
    t, q, u = (fixed(x) for x in start)
    until = t + 20 * ONE
    found, whole = events(s, (t, q, u), until, 10, meant)
    if meant is None and len(found) < 3:
        raise Uncertain("too little happens")
    nudge = ONE // 10**22
    other, _ = events(s, (t, q + nudge, u), until, 10, meant)
    kept, end = [], whole
    for i, (time, side, velocity) in enumerate(found):
        if i >= len(other) or other[i][1] != side:
            end = found[i][0] - ONE // 1000
            break
        moved = max(abs(other[i][0] - time), abs(other[i][2] - velocity)) / nudge * 1e-15
        tolerance = max(100 * moved, 1e-12)
        slow = abs(velocity) < SLOW and not (meant and i == 0)
        if tolerance > 1e-6 or slow:
            end = time - ONE // 1000
            break
        kept.append((time, side, velocity, tolerance))
    if len(kept) == len(found) == 10:
        end = kept[-1][0] + ONE // 10000
    if kept and end < kept[-1][0]:
        raise Uncertain("too near each other")
    if meant is None and len(kept) < 2 or end < t + ONE:
        raise Uncertain("too little happens")
    number = lambda x: repr(x if isinstance(x, float) else x / ONE)
    series = lambda hs: " ".join(f"{k}:{a!r}:{b!r}" for k, a, b in hs)
    wall = lambda w: f"{w['offset']!r}/{w['restitution']!r}/{series(w['harmonics'])}" if w else ""
    impacts = " ".join(f"{side[0]}:{number(t)}:{number(v)}:{tol:.0e}" for t, side, v, tol in kept)
    print(
        ",".join(
            [kind, number(s["damping"]), number(s["stiffness"]), number(s["cubic"]), number(s["force"]), series(s["forcing"])]
            + [wall(s["lower"]), wall(s["upper"])]
            + [number(x) for x in start]
            + [number(end), f"{(meant or 0) / ONE:.1e}", impacts]
        ),
        flush=True,
    )


if __name__ == "__main__":
    print("# Written by make_events.py; do not edit. Harmonics are k:cos:sin, walls offset/restitution/harmonics,")
    print("# impacts wall:time:velocity of the gap on arrival:tolerance of both.")
    print("kind,damping,stiffness,cubic,force,forcing,lower,upper,t,q,u,until,depth,impacts")
    kinds = (("random", random_scene, 250), ("grazing", grazing_scene, 120))
    # A word on the command line: scenes of that kind only.
    for kind, make, wanted in (kind for kind in kinds if kind[0] in (sys.argv[1:] or kind[0])):
        r, done = random.Random(kind), 0
        while done < wanted:
            try:
                line(kind, *make(r))
                done += 1
            except Uncertain:
                pass
