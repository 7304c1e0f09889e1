#!/usr/bin/env bash
# One wheel for all Pythons and all systems with a glibc of 2.17 or later, abi3 and manylinux2014, built from these
# sources; in a clean environment of every Python that the machine has, and the tests in each.
#
#   python/wheels.sh [PROFILE [FOLDER]]      PROFILE of python/Cargo.toml: release (default) or quick; the wheel
#                                            stays in FOLDER, if it is given
#
# The Pythons are those on PATH and pyenv's; one that is too old for the package is named. With WHEEL=FILE nothing
# is built. Zig links, as it knows every glibc's functions. GRAZING is the command line that the tests compare with.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if [ -z "${WHEEL:-}" ]; then
    python3 -m venv "$work/build"
    "$work/build/bin/python" -m pip install --quiet --disable-pip-version-check 'maturin>=1.9,<2' 'ziglang<1'
    export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$here/target}
    # maturin asks the first python3 on PATH for Zig.
    PATH="$work/build/bin:$PATH" maturin build --quiet --locked --zig --compatibility manylinux2014 \
        --manifest-path "$here/Cargo.toml" --profile "${1:-release}" --out "$work/dist"
    WHEEL=$(echo "$work"/dist/*.whl)
fi
# What pip goes by: any Python from 3.10 on, and any glibc from 2.17 on.
case $(basename "$WHEEL") in
    grazing-*-cp310-abi3-*manylinux_2_17_*.whl) echo "$(basename "$WHEEL"): $(wc -c <"$WHEEL") bytes" ;;
    *) echo "$WHEEL is no abi3 wheel for manylinux_2_17 (manylinux2014)"; exit 1 ;;
esac
# The name holds if the dynamic linker is asked for no later version; a library without any was not read.
python3 -m zipfile -e "$WHEEL" "$work/wheel"
versions=$(LC_ALL=C readelf --wide --version-info "$work"/wheel/grazing/_grazing*.so \
    | sed -n 's/.*Name: GLIBC_\([0-9.]*\) .*/\1/p' | sort -uV)
newest=$(tail -n 1 <<<"$versions")
if [ -z "$newest" ] || [ "$(printf '%s\n' 2.17 "$newest" | sort -V | tail -n 1)" != 2.17 ]; then
    echo "$WHEEL asks for glibc ${newest:-of no version}, which is not 2.17 or older"
    exit 1
fi
echo "it asks for functions of glibc up to $newest"
if [ -n "${2:-}" ]; then
    mkdir -p "$2"
    cp "$WHEEL" "$2"
fi

# Each Python once, whatever links lead to it: a shim of pyenv is no Python, but what it starts.
about='import os, platform, sys
name = f"{platform.python_implementation()} {platform.python_version()}"
print(os.path.realpath(sys.executable), name, "new" if sys.version_info >= (3, 10) else "old", sep="\t")'
found=$(
    IFS=:
    for folder in $PATH "${PYENV_ROOT:-$HOME/.pyenv}"/versions/*/bin; do
        for python in "$folder"/python3 "$folder"/python3.[0-9] "$folder"/python3.[0-9][0-9]; do
            if [ -x "$python" ]; then
                "$python" -c "$about" 2>/dev/null || true
            fi
        done
    done | sort -u
)
tried=0
while IFS=$'\t' read -r python name age; do
    if [ "$age" = old ]; then
        echo "NOT tried: $name ($python), which is older than 3.10"
        continue
    fi
    printf '== %s (%s)\n' "$name" "$python"
    venv=$work/venv-$tried
    "$python" -m venv "$venv"
    "$venv/bin/python" -m pip install --quiet --disable-pip-version-check "$WHEEL[frames,labels,figures]" pytest \
        python-flint
    # From elsewhere, so that the installed package is what is tested.
    (cd "$work" && "$venv/bin/python" -m pytest --quiet -p no:cacheprovider "$here/tests" </dev/null)
    rm -r "$venv"
    tried=$((tried + 1))
done <<<"$found"
[ "$tried" -gt 0 ] || { echo "there is no Python 3.10 or later"; exit 1; }
echo "the wheel passes on $tried Pythons"
