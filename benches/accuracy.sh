#!/usr/bin/env bash
# Measures everything that docs/accuracy.md shows, on this computer, which should do nothing else: writes the tables and pictures of
# `grazing accuracy` and those of other programs into docs (or DIR), draws both together, and prints speed and bits lost beside Arb and
# where time goes. Usage: accuracy.sh [--quick] [DIR]. Three minutes once the programs are
# built; --quick: fewer points, one. What this build has measured into DIR before is kept; AGAIN=1 measures it anew. Needs gcc, Arb's
# headers (Debian: apt-get install libflint-dev libflint-arb-dev), and python3 (or $PYTHON) with numpy, scipy and python-flint, which it
# installs for itself if they are missing. GRAZING is the program, by default the release build.
set -eu
quick=
[ "${1:-}" != --quick ] || { quick=--quick; shift; }
folder=${1:-$(dirname "$0")/../docs}
mkdir -p "$folder"
folder=$(realpath "$folder")
cd "$(dirname "$0")/.."
. benches/common.sh
find_grazing
cargo bench --quiet --no-run --bench enclosures --bench widths
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
if ! "${PYTHON:-python3}" -c "import flint, numpy, scipy" 2>/dev/null; then
    "${PYTHON:-python3}" -m venv "$build/venv"
    PYTHON=$build/venv/bin/python
    "$PYTHON" -m pip install --quiet python-flint==0.9.0 numpy scipy
fi
export GRAZING PYTHON="${PYTHON:-python3}" QUICK="${quick:+1}"

# step NAME COMMAND...: says what runs and how long it took.
step() {
    local name=$1 start=$SECONDS
    shift
    "$@" || { echo "$name: failed" >&2; exit 1; }
    echo "$name: $((SECONDS - start)) s" >&2
}
step "grazing accuracy" "$GRAZING" accuracy --of all $quick ${AGAIN:+--again} -o "$folder" >"$build/tables"
step "signs by Arb" benches/peers/signs.sh "$folder"
step "digits by Arb" benches/peers/digits.sh "$folder"
step "motions by C and SciPy" benches/peers/motions.sh "$folder"
# Draws what other programs have written since; the measurements are kept.
step "pictures" "$GRAZING" accuracy --of all $quick -o "$folder" >"$build/tables"
step "speed beside Arb" benches/peers/arb.sh
step "bits lost beside Arb" benches/peers/widths.sh
step "where time goes" benches/profiles.sh
