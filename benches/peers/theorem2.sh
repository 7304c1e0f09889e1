#!/usr/bin/env bash
# Theorem 2 decided for n = 3 to N here and by plain C, in turns: seconds of processor time, the least of three, and ratios; then the
# exponent in N of each. C has two ways (benches/peers/theorem2.c): the same walk, and the theorem's intervals alone, without what lies
# between. Needs gcc. Fails if the numbers of pieces differ.
# Usage: theorem2.sh [N...], by default 500 1000 2000 4000, a minute; GRAZING, the program that is measured, see benches/common.sh.
set -eu
cd "$(dirname "$0")/../.."
. benches/common.sh
find_grazing
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
gcc -O2 -o "$build/theorem2" benches/peers/theorem2.c
[ $# -gt 0 ] || set -- 500 1000 2000 4000
python3 - "$GRAZING" "$build/theorem2" "$@" <<'PY'
import math, re, resource, subprocess, sys
grazing, plain, *lasts = sys.argv[1:]

def timed(command):
    """Seconds of processor time, and the numbers of pieces."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    numbers = re.findall(r"^ *(\d+)  ", text, re.M) or text.split()
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, numbers

rows = []
print(f"{'N':>6} {'grazing':>9} {'C, walk':>9} {'ratio':>6} {'C, intervals':>13} {'ratio':>6}")
for last in lasts:
    commands = [[grazing, "-q", "verify", f"3..={last}"], [plain, "walk", last], [plain, "intervals", last]]
    runs = [[timed(command) for command in commands] for _ in range(3)]
    (_, here), (_, walk), (_, intervals) = runs[0]
    if here != walk or here[0] != intervals[0]:
        sys.exit(f"the pieces differ for 3..={last}: {here}, {walk}, {intervals}")
    here, walk, intervals = (min(run[i][0] for run in runs) for i in range(3))
    rows.append((int(last), here, walk, intervals))
    print(f"{last:>6} {here:9.3f} {walk:9.3f} {walk / here:6.2f} {intervals:13.3f} {intervals / here:6.2f}")
if len(rows) > 1:
    (first, *low), (last, *high) = rows[0], rows[-1]
    exponents = (f"{math.log(b / a) / math.log(last / first):.2f}" for a, b in zip(low, high))
    print("exponent in N from", first, "to", last, "of grazing, C, walk, C, intervals:", *exponents)
PY
