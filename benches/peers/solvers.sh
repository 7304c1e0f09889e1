#!/bin/sh
# How far z3, cvc5 and QEPCAD prove the sentences of `grazing formula N --sentence`, and in what time.
#
#     benches/peers/solvers.sh [SECONDS]
#
# SECONDS (default 60) is the limit for one sentence. For each tool that is installed and each family (region 4; the half-cells,
# one line for the slowest) n goes up from 3 until a sentence is not proved within the limit. Needs python3 with sympy for one more
# line: that sympy confirms the factors. Set GRAZING to use a binary that is already built.
set -eu
cd "$(dirname "$0")/../.."
limit=${1:-60}
if [ -z "${GRAZING:-}" ]; then
    cargo build --release --quiet --package grazing-shell
    GRAZING=${CARGO_TARGET_DIR:-target}/release/grazing
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

solve() { # tool: its answer to the sentence on standard input
    case $1 in
        qepcad) timeout "$limit" qepcad +N80000000 2>&1 | grep -qx 'TRUE' ;;
        z3) timeout "$limit" z3 -in 2>&1 | grep -qx 'unsat' ;;
        cvc5) timeout "$limit" cvc5 --lang=smt2 2>&1 | grep -qx 'unsat' ;;
    esac
}

areas() { # family n
    if [ "$1" = region4 ]; then
        echo region4
        return
    fi
    m=1
    while [ $((2 * m)) -lt "$2" ]; do
        a=$m b=$2
        while [ "$b" -ne 0 ]; do t=$((a % b)) a=$b b=$t; done
        [ "$a" -ne 1 ] || echo "$m+" "$m-"
        m=$((m + 1))
    done
}

echo "tool,family,n,sentences,slowest_seconds"
for tool in qepcad z3 cvc5; do
    command -v "$tool" >"$work/path" || { echo "$tool is not installed" >&2; continue; }
    format=smtlib
    [ "$tool" != qepcad ] || format=qepcad
    for family in region4 half-cells; do
        n=3 proved=yes
        while [ $proved = yes ]; do
            slowest=0 count=0
            for area in $(areas $family $n); do
                "$GRAZING" formula $n --sentence --area "$area" --format $format >"$work/sentence"
                start=$(date +%s%N)
                solve $tool <"$work/sentence" || { proved=no; break; }
                took=$((($(date +%s%N) - start) / 1000000)) count=$((count + 1))
                [ $took -le $slowest ] || slowest=$took
            done
            if [ $proved = yes ]; then
                echo "$tool,$family,$n,$count,$((slowest / 1000)).$(printf %03d $((slowest % 1000)))"
                n=$((n + 1))
            else
                echo "$tool,$family,$n,$area not proved within $limit s,"
            fi
        done
    done
done
if python3 -c 'import sympy' 2>"$work/error"; then
    for n in 2 3 4 5 6 7 8 9 10 11 12; do
        k=1
        while [ $k -lt $n ]; do
            "$GRAZING" formula $n $k --format sympy | python3 -
            k=$((k + 1))
        done
    done
    echo "sympy confirms every factorisation up to n = 12" >&2
else
    echo "sympy is not installed" >&2
fi
