#!/usr/bin/env bash
# The walk of F_10000 here and by FLINT, side by side, with ratios. Needs gcc and FLINT's headers
# (Debian: apt-get install libflint-dev). Prints nanoseconds a term; fails if the walks differ.
set -eu
cd "$(dirname "$0")/../.."
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
gcc -O2 -o "$build/farey" benches/peers/farey.c -lflint -lgmp
read -r terms mix flint < <("$build/farey" 10000)
[ "$terms $mix" = "30397487 195206882690" ] || { echo "FLINT lists other terms: $terms $mix" >&2; exit 1; }
# The bench checks its own walks against the same count and checksum.
cargo bench --quiet --bench farey -- 'walk F_10000' >/dev/null
python3 - "$flint" "${CARGO_TARGET_DIR:-target}" <<'PY'
import glob, json, sys
flint, target = float(sys.argv[1]), sys.argv[2]
rows = {"FLINT fmpq_farey_neighbors": flint}
for path in glob.glob(target + "/criterion/walk F_10000/*/new/estimates.json"):
    name = json.load(open(path.replace("estimates", "benchmark")))["function_id"]
    rows[name] = json.load(open(path))["median"]["point_estimate"] / 30397487
plain = rows["plain recurrence"]
print(f"{'walk of F_10000':28} {'ns/term':>8} {'/ plain':>8} {'FLINT /':>8}")
for name, ns in sorted(rows.items(), key=lambda row: -row[1]):
    print(f"{name:28} {ns:8.2f} {ns / plain:8.2f} {flint / ns:8.1f}")
PY
