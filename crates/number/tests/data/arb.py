"""Compares enclosures with Arb: reads what tests/functions.rs writes, one case per line.

    i FUNCTION A B [C D] LOW HIGH         an interval of floats, or two, and the result, as the bits of floats in hex
    b FUNCTION BITS X [Y] RESULT          balls as python-flint writes them, or `whole`

Every result must contain Arb's values at the ends, in the middle and, of sin, cos and cosh, at the turning points of
the argument, to four times the bits; from points it must be narrow: of intervals three floats at most (normal ones), of balls
three units of the last bit, as the package promises; and the interval of an interval may reach no more than three floats
beyond the true range, unless it has a pole. Prints how many cases there were of each function.
"""
import math
import struct
import sys
from collections import Counter

from flint import arb, ctx


def real(text):
    return struct.unpack(">d", bytes.fromhex(text))[0]


def value(name, x, y=None, far=None):
    if name == "pow":
        if x == 0:
            return arb(0)
        power = y * x.log()
        return arb(math.copysign(far, power.mid())).exp() if far and abs(power) > far else power.exp()
    if name in ("sin", "cos", "tan") and abs(x) > 1:
        # As many bits as the argument has before its point.
        old, ctx.prec = ctx.prec, ctx.prec + 1100
        result = getattr(x, name)()
        ctx.prec = old
        return result
    return getattr(x, name)()


def near(low, high, steps):
    """Whether `high` is at most that many floats above `low`."""
    for _ in range(steps):
        low = math.nextafter(low, math.inf)
    return high <= low


def turns(a, b, at):
    """Whether at + 2 pi k lies between a and b for a whole k."""
    k = ((b - at) / (2 * arb.pi())).floor().unique_fmpz() - ((a - at) / (2 * arb.pi())).floor().unique_fmpz()
    return k > 0


def nearest(v):
    return math.inf if v > arb(2) ** 1024 else -math.inf if v < -arb(2) ** 1024 else float(v.mid())


def interval(line):
    name, *ends = line
    *arguments, low, high = [real(end) for end in ends]
    ctx.prec = 250
    a, b = arguments[:2]
    # Beyond 2000 values of exp and its like are beyond the floats, and beyond Arb in the end.
    far = 2000.0 if name in ("exp", "expm1", "sinh", "cosh") else math.inf
    xs = [arb(max(-far, min(far, x))) for x in {a, b, a + (b - a) / 2}]
    if name == "pow":
        c, d = arguments[2:]
        values = [value(name, x, arb(y), 2000) for x in xs for y in {c, d}]
    else:
        values = [value(name, x) for x in xs]
    if name == "cosh" and a < 0 < b:
        values.append(arb(1))
    pole = False
    if name in ("sin", "cos"):
        ctx.prec = 1400
        for at, top in ((arb.pi() / 2, 1), (-arb.pi() / 2, -1)) if name == "sin" else ((arb(0), 1), (arb.pi(), -1)):
            if a < b and turns(arb(a), arb(b), at):
                values.append(arb(top))
    if name == "tan" and a < b:
        ctx.prec = 1400
        pole = ((arb(b) / arb.pi() + 0.5).floor() != (arb(a) / arb.pi() + 0.5).floor())
    ctx.prec = 250
    for v in values:
        assert not (v < arb(low)) and not (v > arb(high)), f"{v} is outside {low} to {high}"
    if pole:
        assert low == -math.inf and high == math.inf, "a pole"
        return
    least, most = (f(map(nearest, values)) for f in (min, max))
    assert near(low, least, 3) and near(most, high, 3), f"{low} to {high} is wider than {least} to {most}"


def pair(text):
    """Midpoint and radius as points: Arb keeps 30 bits of a radius, the package 32."""
    mid, radius = eval(text, {"arb": lambda mid, radius: (mid, radius)})
    return arb(mid), arb(radius)


def ball(line):
    name, bits, *texts, result = line
    bits = int(bits)
    ctx.prec = 4 * bits + 400
    samples = [[m] if r == 0 else [m - r, m, m + r] for m, r in map(pair, texts)]
    values = [value(name, x, *y) for x in samples[0] for y in ([[y] for y in samples[1]] if len(samples) > 1 else [[]])]
    if result == "whole":
        # Where Arb knows no more, where there is no value, or a pole.
        if len(values) == 1:
            v = values[0]
            assert not v.is_finite() or v.contains(0) or abs(int(v.mid().man_exp()[1])) > 1 << 60, f"{v}, not the whole line"
        return "whole"
    mid, radius = pair(result)
    for v in values:
        if v.is_finite():
            assert not (v < mid - radius) and not (v > mid + radius), f"{v} is outside {mid} +/- {radius}"
    if len(values) == 1 and v.is_finite() and v != 0:
        m, e = v.mid().man_exp()
        top = int(e) + abs(int(m)).bit_length()
        unit = arb(2) ** (top - bits)
        assert abs(top) > 1 << 61 or 200 * radius <= 301 * unit, f"{mid} +/- {radius} is too wide for {bits} bits"


counts = Counter()
for line in sys.stdin:
    kind, *words = line.rstrip("\n").split("\t")
    try:
        said = (interval if kind == "i" else ball)(words)
    except Exception as error:
        sys.exit(f"{line}{type(error).__name__}: {error}")
    counts[f"{kind} {words[0]}{' whole' if said else ''}"] += 1
print(sum(counts.values()), dict(counts))
