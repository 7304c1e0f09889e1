#!/usr/bin/env bash
# Measures everything that docs/accuracy.md shows, on this computer, which should do nothing else: writes the tables and pictures of
# `grazing accuracy` and those of other programs into docs (or $1), then draws both together. Some minutes. Needs gcc, Arb's headers
# (Debian: apt-get install libflint-dev libflint-arb-dev), and python3 (or $PYTHON) with numpy and scipy. GRAZING is the program, by
# default the release build.
set -eu
folder=$(realpath "${1:-docs}")
cd "$(dirname "$0")/.."
. benches/common.sh
find_grazing
"$GRAZING" accuracy --of all --again -o "$folder" >/dev/null
benches/peers/digits.sh "$folder"
benches/peers/motions.sh "$folder"
for part in digits simulations; do "$GRAZING" accuracy --of "$part" -o "$folder"; done
