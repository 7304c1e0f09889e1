#!/usr/bin/env bash
# The package grazing-number beside inari, malachite, Arb and nfloat: nanoseconds and ratios of single operations, in one run. Needs gcc
# and FLINT's headers (Debian: apt-get install libflint-dev libflint-arb-dev; another FLINT: see benches/common.sh; nfloat is in it
# from 3.4 on), python3, and crates.io for inari and malachite, which are dependencies of operations/ alone. Everything here is compiled
# for the processor Haswell, as inari asks for. The two programs take turns three times, and the fastest of each counts. Fails if two
# enclosures of the same number are apart.
set -eu
cd "$(dirname "$0")/../.."
. benches/common.sh
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
compile_with_arb "$build/flint" benches/peers/operations.c
target=${CARGO_TARGET_DIR:-target}/peers
RUSTFLAGS="-C target-cpu=haswell" CARGO_TARGET_DIR=$target cargo build --quiet --release --manifest-path benches/peers/operations/Cargo.toml
for _ in 1 2 3; do
    "$target/release/operations" >>"$build/lines"
    "$build/flint" >>"$build/lines"
done
python3 benches/peers/operations.py "$build/lines"
