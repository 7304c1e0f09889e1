#!/bin/sh
# The paper's scene (d = 0.6, w = 4.9, tau = 1, mu = 0.003) here, by a plain C loop and by SciPy, side by side: microseconds a forcing period.
# Needs gcc; SciPy's row needs python3 with scipy and is left out without. Counts differ a little as the motion is chaotic.
set -eu
cd "$(dirname "$0")/../.."
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
gcc -O2 -o "$build/simulation" benches/peers/simulation.c -lm
echo "program,periods,impacts,microseconds_per_period"
echo "C,1000000,$("$build/simulation" 1000000 | tr ' ' ',')"
if python3 -c 'import scipy' 2>"$build/error"; then
    echo "SciPy DOP853,1000,$(python3 benches/peers/simulation.py 1000 | tr ' ' ',')"
else
    echo "scipy is not installed" >&2
fi
cargo bench --quiet -p grazing-scenes --bench simulation -- "paper" >"$build/bench" 2>"$build/error" || { cat "$build/error" >&2; exit 1; }
python3 - "${CARGO_TARGET_DIR:-target}" "$build/bench" <<'PY'
import json, re, sys
path = sys.argv[1] + "/criterion/paper's scene/10⁶ periods/new/estimates.json"
ns = json.load(open(path))["median"]["point_estimate"]
impacts = re.search(r"periods: (\d+)", open(sys.argv[2]).read()).group(1)
print(f"grazing,1000000,{impacts},{ns / 1e9:.4f}")
PY
