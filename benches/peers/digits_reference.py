"""b_{n,k} to 1240 digits by python-flint at 16384 bits, four times the longest precision that is measured.

Usage: digits_reference.py POINTS >crates/study/src/digits_reference.csv, where `grazing accuracy --of digits --quick --points POINTS
-o DIR` wrote POINTS; needs python-flint 0.9.0. Formulas as the paper prints them: (B1) on r = 1, (62) for r < 1, powers of the
eigenvalues from (a1, a2). Fails if a ball is wider than the digits printed.
"""

import csv
import sys

from flint import arb, ctx, fmpq

ctx.prec = 16384
DIGITS = 1240


def fraction(text):
    p, q = text.split("/")
    return fmpq(int(p), int(q))


def polar(r, s, n, k):
    sine = lambda m: arb.sin_pi_fmpq(2 * m * s)
    if r == 1:
        half = lambda m: arb.sin_pi_fmpq(m * s)
        return -2 * half(k) * half(n - k) / arb.cos_pi_fmpq(n * s)
    r = arb(r)
    return (r ** (n - k) * sine(n) - r**n * sine(n - k) - sine(k)) / (r ** (n - k) * sine(n))


def plane(a1, a2, n, k):
    a1, a2 = arb(a1), arb(a2)
    d = a1 * a1 - 4 * a2
    if d > 0:
        l1, l2 = (a1 + d.sqrt()) / 2, (a1 - d.sqrt()) / 2
        u = lambda m: (l1**m - l2**m) / (l1 - l2)
    else:
        theta, root = arb.atan2((-d).sqrt(), a1), a2.sqrt()
        u = lambda m: root ** (m - 1) * (m * theta).sin() / theta.sin()
    return (u(n) - u(k) - a2**k * u(n - k)) / u(n)


csv.field_size_limit(10**7)
print("family,n,k,coordinates,x,y,value")
for row in csv.DictReader(open(sys.argv[1])):
    x, y, n, k = fraction(row["x"]), fraction(row["y"]), int(row["n"]), int(row["k"])
    b = (polar if row["coordinates"] == "rs" else plane)(x, y, n, k)
    value = b.mid().str(DIGITS, radius=False)
    assert b.rel_accuracy_bits() > DIGITS * 3.33 + 20, (row["family"], b.rel_accuracy_bits())
    print(",".join([row["family"], row["n"], row["k"], row["coordinates"], row["x"], row["y"], value]))
