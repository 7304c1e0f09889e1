#!/usr/bin/env bash
# Faults put into the Python package one by one: each must be noticed by its test.
#
#   python/mutants.sh [NAME ...]      those of python/mutants.py, all or these
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check numpy pandas xarray matplotlib pytest python-flint
"$work/venv/bin/python" "$here/mutants.py" "$@"
