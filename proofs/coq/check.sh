#!/bin/sh
# Compiles, lets the kernel check every compiled file again (coqchk), and compares
# the axioms of each main theorem with assumptions.txt; --pin writes that file.
set -eu
cd "$(dirname "$0")"
if grep -nE '^ *(Axioms?|Parameters?|Conjecture) |Admitted\.|\<admit\>' $(grep '\.v$' _CoqProject); then
  echo "check.sh: unproved or assumed statements above" >&2; exit 1
fi
sh build.sh -j "$(nproc 2>/dev/null || echo 1)"
found=$(mktemp)
trap 'rm -f "$found"' EXIT
for file in Main MainPlane MainOrbits MainWords; do coqc -Q . Grazing $file.v; done >"$found"
if [ "${1-}" = --pin ]; then cp "$found" assumptions.txt; fi
diff assumptions.txt "$found"
coqchk -silent -o -Q . Grazing Grazing.Main Grazing.MainPlane Grazing.MainOrbits Grazing.MainWords
