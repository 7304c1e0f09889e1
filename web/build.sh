#!/usr/bin/env bash
# Builds the page, one file: dist/grazing.html. With --quick it is larger and slower, and sooner there. In one folder
# the same sources, compiler and packages give the same bytes.
set -euo pipefail
cd "$(dirname "$0")"

profile=release
limit=()
if [ "${1:-}" = --quick ]; then
    profile=quick
    limit=(--any-size)
elif [ "$#" -gt 0 ]; then
    echo "usage: web/build.sh [--quick]" >&2
    exit 2
fi
export CARGO_TARGET_DIR="$PWD/target"
# What a panic names is a file of the sources, not of this computer.
root=$(cd .. && pwd)
export RUSTFLAGS="--remap-path-prefix=$root=. --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=~/.cargo"

[ -d node_modules ] || npm ci --silent

wasm=(build --quiet --locked --profile "$profile" --target wasm32-unknown-unknown)
if [ -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown/lib" ]; then
    cargo "${wasm[@]}"
else
    # Debian's compiler has the sources of the standard library, and not the library for this target.
    RUSTC=/usr/bin/rustc CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld-19 RUSTC_BOOTSTRAP=1 \
        /usr/bin/cargo "${wasm[@]}" -Zbuild-std=std,panic_abort
fi
cargo run --quiet --locked --profile tool --package grazing-web-bindgen -- \
    "target/wasm32-unknown-unknown/$profile/grazing_web.wasm" target/bindgen
node bundle.mjs "${limit[@]}"
