#!/usr/bin/env bash
# The Python package as users get it: a wheel, installed in a fresh environment, and its tests and notebooks.
#
#   python/test.sh [PROFILE]      PROFILE of python/Cargo.toml: quick (default) or release
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# While the wheel is built, the packages arrive.
python3 -m venv "$work/venv"
python="$work/venv/bin/python"
"$python" -m pip install --quiet --disable-pip-version-check 'maturin>=1.9,<2'
"$python" -m pip install --quiet --disable-pip-version-check numpy pandas xarray matplotlib pytest python-flint &
packages=$!
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$here/target}
cargo fmt --manifest-path "$here/Cargo.toml" --check
"$work/venv/bin/maturin" build --quiet --locked --manifest-path "$here/Cargo.toml" --profile "${1:-quick}" \
    --interpreter "$python" --out "$work/dist"
wait "$packages"
"$python" -m pip install --quiet --disable-pip-version-check --no-index --no-deps "$work"/dist/*.whl

# From elsewhere, so that the installed package is what is tested.
cd "$work"
"$python" -m pytest --quiet -p no:cacheprovider "$here/tests"
