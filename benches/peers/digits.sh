#!/usr/bin/env bash
# Digits of b_{n,k} against time by Arb, on the inputs of `grazing accuracy --of digits`: writes DIR/digits-peers.csv, which that
# command draws beside its own rows. Usage: digits.sh DIR. Needs gcc and Arb's headers (Debian: apt-get install libflint-dev
# libflint-arb-dev). Fails if a ball does not hold the value that python-flint has found.
set -eu
folder=$(realpath "$1")
cd "$(dirname "$0")/../.."
. benches/common.sh
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
compile_with_arb "$build/digits" benches/peers/digits.c
tail -n +2 crates/study/src/digits_reference.csv | "$build/digits" >"$build/rows.csv"
python3 benches/peers/digits.py "$build/rows.csv" >"$build/peers.csv"
mv "$build/peers.csv" "$folder/digits-peers.csv"
