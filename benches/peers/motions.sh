#!/usr/bin/env bash
# The motions of `grazing accuracy --of simulations` by a plain loop in C and by SciPy: writes DIR/simulations-peers.csv, which that
# command draws beside its own rows. Usage: motions.sh DIR. Needs gcc; SciPy's rows need python3 (or $PYTHON) with scipy and are
# left out without. QUICK=1: each run timed once.
set -eu
folder=$(realpath "$1")
cd "$(dirname "$0")/../.."
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
gcc -O2 -o "$build/motions" benches/peers/motions.c -lm
"${PYTHON:-python3}" benches/peers/motions_peers.py "$build/motions" crates/study/src/simulations_reference.csv ${QUICK:+1} >"$build/peers.csv"
mv "$build/peers.csv" "$folder/simulations-peers.csv"
