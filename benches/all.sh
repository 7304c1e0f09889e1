#!/usr/bin/env bash
# Writes the one table of docs/benchmarks.md: one computer, one run, with date, load and ratios. The computer should do nothing else.
# Usage: all.sh [--quick] [PAGE]. Without --quick it takes some 15 minutes once everything is built, a quarter of it the proofs in Coq;
# --quick does everything once with small numbers, in some minutes, and prints the table, which is no measurement. What a row needs and
# the computer has not is named in the table: gcc and FLINT's headers (Debian: libflint-dev libflint-arb-dev; FLINT=DIR, see
# benches/common.sh), auto-07p with gfortran, coqc, and python3 (or $PYTHON) with python-flint and scipy, which it installs for itself.
set -eu
quick=
[ "${1:-}" != --quick ] || { quick=1; shift; }
cd "$(dirname "$0")/.."
page=$(realpath "${1:-docs/benchmarks.md}")
grep -q "^<!-- table" "$page" || { echo "all.sh: $page has no table to be written anew" >&2; exit 1; }
. benches/common.sh
find_grazing
export GRAZING CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-target}"
names="theorem2 branches covers patterns simulation enclosures farey machines"
# shellcheck disable=SC2046
cargo bench --quiet --workspace --no-run $(printf ' --bench %s' $names)
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
if ! "${PYTHON:-python3}" -c "import flint, numpy, scipy" 2>/dev/null; then
    "${PYTHON:-python3}" -m venv "$build/venv"
    PYTHON=$build/venv/bin/python
    "$PYTHON" -m pip install --quiet python-flint==0.9.0 numpy scipy
    PATH=$build/venv/bin:$PATH
fi
export PYTHON="${PYTHON:-python3}"
cut -d' ' -f1 /proc/loadavg >"$build/load" 2>/dev/null || uptime | sed 's/.*average[s]*: *//; s/[, ].*//' >"$build/load"

# step NAME COMMAND...: the output into a file of that name; a step that fails is named, and the table says so.
step() {
    local name=$1 start=$SECONDS
    shift
    if "$@" >"$build/$name" 2>"$build/errors"; then
        echo "$name: $((SECONDS - start)) s" >&2
    else
        tail -n 2 "$build/errors" >&2
        echo "$name: failed" >&2
        mv "$build/$name" "$build/$name.failed"
    fi
}

# timed WHAT COMMAND: a line of seconds, on the clock and of the processor, the least of three. Codes 0 and 3 are answers; of a command
# that fails the line says so.
timed() {
    local what=$1 times=3 code clock user system
    shift
    [ -z "$quick" ] || times=1
    TIMEFORMAT="%R %U %S"
    : >"$build/times"
    for _ in $(seq "$times"); do
        # The time is what the braces say, and nothing else.
        { time sh -c "$*; echo \$? >$build/code" >"$build/out" 2>"$build/said"; } 2>>"$build/times"
        code=$(cat "$build/code")
        if [ "$code" -ne 0 ] && [ "$code" -ne 3 ]; then
            tail -n 1 "$build/said" >&2
            echo "$what|failed|||$*" | sed "s#$GRAZING#grazing#g; s#$build/##g"
            return
        fi
    done
    read -r clock user system < <(sort -n "$build/times")
    echo "$what|$clock|$user|$system|$*" | sed "s#$GRAZING#grazing#g; s#$build/##g"
}

commands() {
    local n=1000 c=128 i=10000 f=1e8 b=200
    [ -z "$quick" ] || { n=60 c=8 i=300 f=1e5 b=12; }
    timed "Theorem 2, decided for n = 3 to $n" "$GRAZING -q verify 3..=$n"
    timed "the same by enclosures" "$GRAZING -q verify 3..=$n --method interval"
    timed "the same with its certificate" "$GRAZING -q verify 3..=$n --certificate $build/theorem2.txt"
    timed "that certificate, checked" "$GRAZING check $build/theorem2.txt"
    timed "covers of Conjecture 1, n = 3 to $c" "$GRAZING -q cover 3..=$c --certificate $build/cover.txt"
    timed "their certificate, checked" "$GRAZING check $build/cover.txt"
    timed "all intervals of n = 3 to $i as CSV" "$GRAZING -q intervals 3..=$i --format csv"
    timed "lowest points of all areas, n = 3 to $b" "$GRAZING -q boundary 3..=$b --format csv"
    timed "fuzz, $f cases" "$GRAZING -q fuzz --cases $f --seed 7"
    timed "chaos of the paper's oscillator, eight proofs" \
        "$GRAZING -q run examples/scenes/nordmark-2001-chaos.toml -o $build/chaos"
    timed "section 4 of the paper" "$GRAZING -q run examples/scenes/nordmark-2001.toml --only section-4 -o $build/section"
}

# The benches' own numbers, which criterion keeps in files.
benches() {
    local options=
    [ -z "$quick" ] || options="--warm-up-time 0.1 --measurement-time 0.2 --sample-size 10"
    # shellcheck disable=SC2086
    cargo bench --quiet --bench theorem2 -- "decide one period/(500|8000)|Farey|inverses" $options
    # shellcheck disable=SC2086
    cargo bench --quiet -p grazing-scenes --bench branches -- "period 4" $options
    # shellcheck disable=SC2086
    cargo bench --quiet --bench covers -- "covers/.*/(64|128)" $options
    # shellcheck disable=SC2086
    cargo bench --quiet -p grazing-scenes --bench simulation -- "many motions" $options
}

coq() {
    [ -z "$quick" ] || { echo "not in --quick" >&2; return 1; }
    cp -r proofs/coq "$build/coq.sources"
    # Once: a second build has nothing to do.
    (cd "$build/coq.sources" && rm -f ./*.vo ./*.vok ./*.vos ./*.glob ./.*.aux && quick=1 && timed "proofs/coq from scratch" "sh build.sh")
}

rm -rf "$CARGO_TARGET_DIR/criterion"
step commands commands
step benches benches
step patterns cargo bench --quiet --bench patterns -- ${quick:+--warm-up-time 0.1 --measurement-time 0.2}
step effects "$GRAZING" -q accuracy --of effects ${quick:+--quick} -o "$build/effects.d"
step arb benches/peers/arb.sh
step operations benches/peers/operations.sh
step farey benches/peers/farey.sh
# shellcheck disable=SC2086
step theorem2 benches/peers/theorem2.sh ${quick:+100 200}
step simulation benches/peers/simulation.sh
step branch benches/peers/branch.sh
[ -n "$quick" ] || step machines cargo bench --quiet -p grazing-scenes --bench machines
step coq coq
"$PYTHON" benches/all.py "$build" "$CARGO_TARGET_DIR/criterion" ${quick:+-} "$page"
