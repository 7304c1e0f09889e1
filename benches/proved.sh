#!/usr/bin/env bash
# What the proved reader takes beside the checker: the table in docs/trust.md. Needs Coq and OCaml; takes a minute
# (N, the last period of the certificates of Theorem 2, 200 if it is not given; with 500 seven minutes).
#
#     benches/proved.sh [N]
set -euo pipefail
cd "$(dirname "$0")/.."
last=${1:-200}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cargo build --quiet --release -p grazing-check -p grazing-shell
target=${CARGO_TARGET_DIR:-target}/release
sh proofs/coq/reader.sh "$work/reader"
seconds() {
    local start end
    start=$(date +%s.%N)
    "$@" >"$work/said"
    end=$(date +%s.%N)
    grep -qE '(^|: )proved' "$work/said" || { cat "$work/said" >&2; exit 1; }
    awk -v a="$start" -v b="$end" 'BEGIN { printf "%.3g", b - a }'
}
for n in 50 100 200 500 1000; do
    if [ "$n" -le "$last" ]; then "$target/grazing" verify "3..=$n" --certificate "$work/theorem2-$n.txt" >"$work/out"; fi
done
printf '| certificate | bytes | checker, s | proved reader, s |\n| --- | ---: | ---: | ---: |\n'
for file in $(ls -v "$work"/theorem2-*.txt) crates/checker/tests/data/{word-by-theorem,chaos-12,chaos-123,range-1,range-13,attractor}.txt; do
    printf '| `%s` | %s | %s | %s |\n' "$(basename "$file")" "$(wc -c <"$file")" \
        "$(seconds "$target/grazing-check" "$file")" "$(seconds "$work/reader/grazing-proved" "$file")"
done
