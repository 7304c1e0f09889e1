#!/usr/bin/env bash
# Seconds for maps of many motions of the paper's oscillator: basins of SIZE x SIZE starts (default 400) where two attractors are
# left and where all is chaotic, with one thread; a map of MAP x MAP points over mu and tau (default 1000; transient 1,000, 200
# looked at, with exponents) with all. GRAZING is the program, by default the release build; BEFORE is another one that makes the
# basins too. Some minutes.
set -eu
cd "$(dirname "$0")/.."
. benches/common.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
find_grazing
size=${SIZE:-400} map=${MAP:-1000}
sed '/^\[\[tasks\]\]/,$d' examples/scenes/nordmark-2001.toml >"$folder/basins.toml"
cp "$folder/basins.toml" "$folder/map.toml"
while read -r name mu; do
    cat >>"$folder/basins.toml" <<TASK
[[tasks]]
name = "$name"
kind = "basins"
set = { mu = $mu }
q = { from = -0.04, to = 3, count = $size }
u = { from = -2, to = 2, count = $size }

TASK
done <<VALUES
attractors -0.05
chaos 0.003
VALUES
cat >>"$folder/map.toml" <<TASK
[[tasks]]
name = "map"
kind = "map"
parameter = "mu"
range = [-0.05, 0.01]
count = $map
second = "tau"
second_range = [0.8, 1]
second_count = $map
start = { q = 0, u = 0 }
TASK
run() {
    program=$1 what=$2
    shift 2
    rm -rf "$folder/out"
    TIMEFORMAT="$what,%R,%U"
    time "$program" -q run "$@" -o "$folder/out" >/dev/null
}
echo "what,elapsed_s,processor_s"
for task in attractors chaos; do
    [ -z "${BEFORE:-}" ] || run "$BEFORE" "basins $size x $size, $task, before" "$folder/basins.toml" --only "$task" --jobs 1
    run "$GRAZING" "basins $size x $size, $task" "$folder/basins.toml" --only "$task" --jobs 1
done
run "$GRAZING" "map $map x $map" "$folder/map.toml"
