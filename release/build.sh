#!/usr/bin/env bash
# Makes a release of the commit that is checked out: static programs, the wheel, the page, certificates and tables, the
# sources, a citation, and their SHA-256.
#
#     release/build.sh [FOLDER]        FOLDER, target/release-VERSION if it is not given, must not be there yet
#
# Needs what README.md and web/README.md name, Python with venv and pip, and readelf. Half an hour on two cores. What only a
# person can add is listed in release/README.md; nothing of it is made up here.
set -euo pipefail
cd "$(dirname "$0")/.."

version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
folder=$(realpath -m "${1:-target/release-$version}")
[ ! -e "$folder" ] || { echo "$folder is there already: name another folder, or remove it" >&2; exit 2; }
[ -z "$(git status --porcelain)" ] || { echo "there are changes that are not committed: a release is of a commit" >&2; exit 2; }
commit=$(git rev-parse HEAD)
day=$(git log -1 --format=%cs)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Made aside, and moved when all of it is there.
made=$work/made
mkdir "$made"

# An archive whose bytes depend on the files in it alone.
packed() {
    tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" -C "$work" -cf - "$1" | gzip -9n >"$made/$1.tar.gz"
}

echo "== sources and citation of $commit"
git archive --format=tar --prefix="grazing-$version/" HEAD | gzip -9n >"$made/grazing-$version-source.tar.gz"

sed "s/^version: .*/&\ndate-released: $day\ncommit: $commit/" CITATION.cff >"$made/CITATION.cff"

echo "== static programs"
target=$(rustc -vV | sed -n 's/^host: //p')
name=grazing-$version-$target
# What a panic names is a file of the sources, not of this computer.
paths="--remap-path-prefix=$PWD=. --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=~/.cargo"
RUSTFLAGS="-C target-feature=+crt-static $paths" cargo build --quiet --locked --release --target "$target" \
    -p grazing-shell -p grazing-check --bins --features grazing-shell/print
mkdir "$work/$name"
for program in grazing grazing-check; do
    built=${CARGO_TARGET_DIR:-target}/$target/release/$program
    if readelf --program-headers --wide "$built" | grep -q INTERP; then
        echo "$program asks for a dynamic linker" >&2
        exit 1
    fi
    cp "$built" "$work/$name"
done
strip "$work/$name"/grazing*
cp README.md LICENSE-MIT LICENSE-APACHE "$made/CITATION.cff" "$work/$name"
packed "$name"
grazing=$work/$name/grazing
check=$work/$name/grazing-check

echo "== certificates and tables"
name=grazing-$version-certificates
mkdir "$work/$name"
(
    cd "$work/$name"
    "$grazing" -q verify 3..=500 --certificate theorem2.txt >/dev/null
    "$grazing" -q verify --entropy --certificate entropy.txt >/dev/null
    "$grazing" -q cover 3..=64 --certificate cover.txt >/dev/null
    "$grazing" -q run "$OLDPWD/examples/scenes/nordmark-2001-chaos.toml" -o chaos >/dev/null
    "$grazing" -q run "$OLDPWD/examples/scenes/nordmark-2001-branches.toml" -o branches >/dev/null
    # By the checker alone, each of them.
    find . -name '*.txt' -o -name '*.certificate' | LC_ALL=C sort | xargs "$check" >"$work/verdicts"
    for kind in csv latex; do "$grazing" -q intervals 3..=50 --format "$kind" >"intervals.$kind"; done
    for kind in csv latex; do "$grazing" -q boundary 3..=50 --format "$kind" >"boundary.$kind"; done
    mv "$work/verdicts" verdicts
)
packed "$name"

echo "== the wheel"
GRAZING=$grazing python/wheels.sh release "$made"

echo "== the page"
web/build.sh
cp web/dist/grazing.html "$made/grazing-$version.html"

(cd "$made" && sha256sum -- * >"$work/sums" && mv "$work/sums" SHA256SUMS && sha256sum --quiet --check SHA256SUMS)
mkdir -p "$(dirname "$folder")"
mv "$made" "$folder"
echo "== $folder"
(cd "$folder" && wc -c -- *)
