#!/usr/bin/env bash
# Shards under GNU parallel, some killed at random times; what is missing is done again until `merge` has all,
# and the table is that of one run.
#
#     tests/cluster/kills.sh target/release/grazing [SHARDS [PERCENT]]
#
# PERCENT of the shards are killed in each round, 25 if it is not said. Says how long the last merge took.
set -euo pipefail
binary=$(realpath "${1:?the program grazing}")
shards=${2:-1000}
percent=${3:-25}
# Parts of some size, however few there are.
last=$((shards > 1000 ? shards + 2 : 1002))
if ! command -v parallel >/dev/null; then
    apt-get update --quiet=2
    DEBIAN_FRONTEND=noninteractive apt-get install --quiet=2 --yes --no-install-recommends parallel >/dev/null
fi
work=$(mktemp -d /tmp/grazing-kills.XXXXXX)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir parts
# Part $3 of $2 of the table up to $5, killed with a probability of $4 % within $6 microseconds: twice what a part takes.
cat >part.sh <<'EOF'
# What the shell says of killed processes is not wanted; what the program says is kept.
exec 2>/dev/null
"$1" intervals "3..=$5" --format csv --shard "$3/$2" -o "parts/part-$3" 2>>said &
if [ $((RANDOM % 100)) -lt "$4" ]; then
    printf -v pause '0.%06d' $((RANDOM * $6 / 32768))
    sleep "$pause"
    kill -KILL $! && echo "$3" >>killed
fi
wait $!
EOF
begun=$EPOCHREALTIME
"$binary" intervals "3..=$last" --format csv --shard "$shards/$shards" -o longest
ended=$EPOCHREALTIME
span=$((2 * (${ended/[^0-9]/} - ${begun/[^0-9]/})))
touch killed
todo=$(seq "$shards")
rounds=0
while [ -n "$todo" ]; do
    rounds=$((rounds + 1))
    [ "$rounds" -le 50 ] || { echo "kills.sh: parts are missing after 50 rounds" >&2; tail said >&2; exit 1; }
    echo "$todo" | parallel --will-cite bash part.sh "$binary" "$shards" {} "$percent" "$last" "$((span < 900000 ? span : 900000))" || true
    begun=$EPOCHREALTIME
    if find parts -name 'part-*' | "$binary" merge --files-from - -o merged.csv 2>faults; then break; fi
    array=$(sed -n 's/^error: .* shards are missing: --array=//p' faults)
    [ -n "$array" ] || { cat faults >&2; exit 1; }
    # A killed part leaves no file of its name: nothing is there that merge finds fault with.
    [ "$(wc -l <faults)" = 1 ] || { cat faults >&2; exit 1; }
    todo=$(echo "$array" | tr ',' '\n' | while IFS=- read -r from to; do seq "$from" "${to:-$from}"; done)
done
ended=$EPOCHREALTIME
"$binary" intervals "3..=$last" --format csv -o one-run.csv
cmp merged.csv one-run.csv
[ "$(find parts -name '.*' -type f | wc -l)" = 0 ] || { ls -A parts | head >&2; exit 1; }
[ -s killed ] || { echo "kills.sh: every part was done before it could be killed" >&2; exit 1; }
took=$(((${ended/[^0-9]/} - ${begun/[^0-9]/}) / 1000))
bytes=$(find parts -name 'part-*' -printf '%s\n' | awk '{ sum += $1 } END { print sum }')
echo "$shards shards ($bytes bytes), $(wc -l <killed) kills, $rounds rounds: the table is that of one run" \
    "(merged in $took ms, $SECONDS s in all)"
