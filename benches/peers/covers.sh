#!/bin/sh
# How far QEPCAD, z3, cvc5 and codac's SIVIA get with what `grazing cover` proves, and in what time: a markdown table.
#
#     benches/peers/covers.sh [SECONDS] [N...]
#
# SECONDS (default 60) is the limit for one tool and one n; N... (default 3 4 5 6 8 10 12 16) the periods. The columns:
#
# - cover, check: `grazing cover N` finds and `grazing check` proves Conjecture 1 for r <= 1 - 1/n^3, one thread;
# - QEPCAD, z3, cvc5: all sentences of `grazing formula N --sentence` (region 4; that one b_{n,k} decides in each half-cell
#   next to an m/n in lowest terms, 0 < r <= 1), the sum of their times;
# - SIVIA: that no orbit exists in the strips which are no interval of Theorem 2, 0 <= r <= 1 - 1/n^3: the boxes in which it cannot exclude
#   that all T_k have one sign, at the widths 1/100 and 1/1000; "proved" if there are none.
#
# A tool is given up at the first n that it does not finish. Needs what is measured, and for SIVIA python3 with codac. Set
# GRAZING to use a binary that is already built.
set -eu
cd "$(dirname "$0")/../.."
limit=${1:-60}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- 3 4 5 6 8 10 12 16
if [ -z "${GRAZING:-}" ]; then
    cargo build --release --quiet --package grazing-shell
    GRAZING=${CARGO_TARGET_DIR:-target}/release/grazing
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

now() { date +%s%N; }

seconds() { # since a time: with three digits
    took=$((($(now) - $1) / 1000000))
    echo "$((took / 1000)).$(printf %03d $((took % 1000)))"
}

solve() { # tool, seconds: its answer to the sentence on standard input
    case $1 in
        qepcad) timeout "$2" qepcad +N80000000 2>&1 | grep -qx 'TRUE' ;;
        z3) timeout "$2" z3 -in 2>&1 | grep -qx 'unsat' ;;
        cvc5) timeout "$2" cvc5 --lang=smt2 2>&1 | grep -qx 'unsat' ;;
    esac
}

sentences() { # tool, n: proves them all within the limit, or says which one is not
    format=smtlib
    [ "$1" != qepcad ] || format=qepcad
    areas=region4 m=1
    while [ $((2 * m)) -lt "$2" ]; do
        a=$m b=$2
        while [ "$b" -ne 0 ]; do t=$((a % b)) a=$b b=$t; done
        [ "$a" -ne 1 ] || areas="$areas $m+ $m-"
        m=$((m + 1))
    done
    began=$(now)
    for area in $areas; do
        left=$((limit - ($(now) - began) / 1000000000))
        "$GRAZING" formula "$2" --sentence --area "$area" --format $format >"$work/sentence"
        if [ $left -le 0 ] || ! solve "$1" $left <"$work/sentence"; then
            echo "$area not in $limit s"
            return
        fi
    done
    seconds "$began"
}

cat >"$work/sivia.py" <<'PYTHON'
import sys, time
from fractions import Fraction
from math import gcd, pi
from codac import AnalyticFunction, Interval, IntervalVector, PavingInOut, VectorVar, cos, oo, sin, sivia

n, began = int(sys.argv[1]), time.time()
intervals = {(Fraction(0), Fraction(1, 2 * n))}
for m in (m for m in range(1, n) if 2 * m < n and gcd(m, n) == 1):
    plus = pow(m, -1, n)
    left = Fraction(1, 2 * n) if m == 1 else Fraction((m * plus - 1) // n, plus)
    intervals |= {(left, Fraction(m, n)), (Fraction(m, n), Fraction(m - (m * plus - 1) // n, n - plus))}
cuts = sorted({Fraction(j, 2 * n) for j in range(n + 1)} | {end for pair in intervals for end in pair})
x = VectorVar(2)
theta = 2 * pi * x[1]


def wave(q, last):  # sin q theta, in the last strip divided by sin theta, which is 0 at s = 1/2
    if not last:
        return sin(q * theta)
    terms = [cos((q - 1 - 2 * i) * theta) for i in range(q)]
    total = terms[0]
    for term in terms[1:]:
        total = total + term
    return total


answers = []
for width in (1e-2, 1e-3):
    open_boxes = boxes = 0
    for left, right in zip(cuts, cuts[1:]):
        if (left, right) in intervals:
            continue
        last = right == Fraction(1, 2)
        t = [x[0] ** (n - k) * wave(n, last) - x[0] ** n * wave(n - k, last) - wave(k, last) for k in range(1, n)]
        box = IntervalVector([[0, 1 - 1 / n**3], [float(left), float(right)]])
        for sign in ([0, oo], [-oo, 0]):
            paving = sivia(box, AnalyticFunction([x], t), IntervalVector([Interval(*sign)] * (n - 1)), width)
            boxes += paving.size()
            open_boxes += len(paving.boxes(PavingInOut.bound)) + len(paving.boxes(PavingInOut.inner))
    answers.append(f"{'proved' if open_boxes == 0 else f'{open_boxes} boxes open'} in {time.time() - began:.2f}")
    began = time.time()
    if open_boxes == 0:
        break
print("; ".join(answers))
PYTHON

echo "| n | cover, s | check, s | QEPCAD, s | z3, s | cvc5, s | SIVIA, s |"
echo "| ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
given_up=
for n; do
    began=$(now)
    "$GRAZING" cover "$n" --jobs 1 --certificate "$work/cover" >"$work/log"
    row="| $n | $(seconds "$began")"
    began=$(now)
    "$GRAZING" check "$work/cover" >"$work/log"
    row="$row | $(seconds "$began")"
    for tool in qepcad z3 cvc5 sivia; do
        case " $given_up " in
            *" $tool "*) row="$row | " && continue ;;
        esac
        if [ $tool = sivia ]; then
            if ! python3 -c 'import codac' 2>"$work/error"; then
                answer="not installed"
            else
                answer=$(timeout "$limit" python3 "$work/sivia.py" "$n" 2>"$work/error") || answer="not in $limit s"
            fi
        elif command -v $tool >"$work/path"; then
            answer=$(sentences $tool "$n")
        else
            answer="not installed"
        fi
        case $answer in
            *"not in"*) given_up="$given_up $tool" ;;
        esac
        row="$row | $answer"
    done
    echo "$row |"
done
