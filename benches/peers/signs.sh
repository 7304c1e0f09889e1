#!/usr/bin/env bash
# Signs near and at zeros here and by Arb, side by side, on the points of `grazing accuracy --of signs`. Usage: signs.sh [DIR]: writes
# DIR/signs-peers.csv, which that command draws beside its own rows, and draws both; measures what is not in DIR already. Needs gcc and
# Arb's headers (Debian: apt-get install libflint-dev libflint-arb-dev). Arb is called with 64, 128, ... bits until the sign is
# certain, 16384 at most; here the ladder decides. Prints median times in microseconds; fails if a sign differs. QUICK=1: fewer points.
set -eu
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
folder=$(realpath "${1:-$build}")
cd "$(dirname "$0")/../.."
. benches/common.sh
compile_with_arb "$build/signs" benches/peers/signs.c
find_grazing
quick=
[ -z "${QUICK:-}" ] || quick=--quick
"$GRAZING" accuracy --of signs $quick --points "$build/points.csv" -o "$folder" >/dev/null
tail -n +2 "$build/points.csv" | "$build/signs" >"$build/arb.csv"
python3 benches/peers/signs.py "$build/points.csv" "$build/arb.csv" "$folder/signs.csv" "$build/peers.csv"
mv "$build/peers.csv" "$folder/signs-peers.csv"
"$GRAZING" accuracy --of signs $quick -o "$folder" >/dev/null
