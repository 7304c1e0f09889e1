#!/usr/bin/env bash
# Signs near and at zeros here and by Arb, side by side, on the points of `grazing accuracy --of signs`. Needs gcc and Arb's headers
# (Debian: apt-get install libflint-dev libflint-arb-dev). Arb is called with 64, 128, ... bits until the sign is certain, 16384 at
# most; here the ladder decides. Median times in microseconds; fails if a sign differs. FULL=1: all distances, not the quick ones.
set -eu
cd "$(dirname "$0")/../.."
. benches/common.sh
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
compile_with_arb "$build/signs" benches/peers/signs.c
find_grazing
quick=--quick
[ -z "${FULL:-}" ] || quick=
"$GRAZING" accuracy --of signs $quick --points "$build/points.csv" -o "$build" >"$build/table"
tail -n +2 "$build/points.csv" | "$build/signs" >"$build/arb.csv"
python3 - "$build" <<'PY'
import collections, csv, statistics, sys
build = sys.argv[1]
csv.field_size_limit(10**7)
points = list(csv.DictReader(open(build + "/points.csv")))
arb = [line.rstrip("\n").rsplit(",", 4) for line in open(build + "/arb.csv")]
assert len(points) == len(arb), (len(points), len(arb))
ladder = {(row["family"], row["distance"]): (int(row["time_ns"]), row["rung"])
          for row in csv.DictReader(open(build + "/signs.csv")) if row["method"] == "ladder"}
groups = collections.OrderedDict()
for point, (family, distance, sign, bits, ns) in zip(points, arb):
    assert (family, distance) == (point["family"], point["distance"])
    # (B1) has a limit where u_n = 0; the quantity has no value there.
    assert sign in ("?", point["sign"]) or point["sign"] == "singular", point
    groups.setdefault((family, distance), []).append((float(ns), int(bits), sign != "?"))
print(f"{'':24} {'distance':>9} {'here us':>10} {'decided by':>13} {'Arb us':>10} {'Arb bits':>9} {'ratio':>7}")
for (family, distance), rows in groups.items():
    here, rung = ladder[family, distance]
    ns = statistics.median(row[0] for row in rows)
    bits = max(row[1] for row in rows) if all(row[2] for row in rows) else "open"
    print(f"{family:24} {distance:>9} {here / 1000:10.2f} {rung:>13} {ns / 1000:10.2f} {bits:>9} {ns / here:7.2f}")
PY
