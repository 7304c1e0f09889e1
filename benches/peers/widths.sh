#!/usr/bin/env bash
# How many bits enclosures of b_{n,k} and c_n lose, here and by Arb, on the points of `grazing accuracy --of signs`, at 53 (here: f64
# intervals) to 4096 bits. Needs gcc and Arb's headers (Debian: apt-get install libflint-dev libflint-arb-dev). Lines: family, distance,
# and per precision the median bits lost here and by Arb; then what a close evaluation to 256 bits loses, which takes longer balls
# where it must, and log2 of the condition number. FULL=1: all distances, not the quick ones.
set -eu
cd "$(dirname "$0")/../.."
. benches/common.sh
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
compile_with_arb "$build/signs" benches/peers/signs.c
find_grazing
quick=--quick
[ -z "${FULL:-}" ] || quick=
"$GRAZING" accuracy --of signs $quick --points "$build/points.csv" -o "$build" >/dev/null
# A zero itself has no bits to lose.
grep -v ',singular$' "$build/points.csv" | grep -v ',0,[bc],' | tail -n +2 >"$build/points"
"$build/signs" widths <"$build/points" >"$build/arb.csv"
cargo bench --quiet --bench widths -- "$build/points" >"$build/here.csv"
python3 - "$build" <<'PY'
import collections, csv, statistics, sys
build = sys.argv[1]
groups = collections.OrderedDict()
for side in ("here", "arb"):
    for family, distance, bits, lost in csv.reader(open(f"{build}/{side}.csv")):
        group = groups.setdefault((family, distance), collections.defaultdict(list))
        group[side, bits].append(float(lost))
precisions = ("53", "128", "256", "1024", "4096")
print(f"{'':28} {'distance':>8} " + " ".join(f"{bits:>11}" for bits in precisions) + f" {'closely':>8} {'condition':>9}")
for (family, distance), group in groups.items():
    median = lambda key: statistics.median(group[key])
    cells = [f"{median(('here', bits)):5.0f} {median(('arb', bits)):5.0f}" for bits in precisions]
    close = max(group["here", "closely"])
    print(f"{family:28} {distance:>8} " + " ".join(cells) + f" {close:8.0f} " + (f"{median(('here', 'condition')):9.0f}" if ("here", "condition") in group else f"{'':>9}"))
PY
