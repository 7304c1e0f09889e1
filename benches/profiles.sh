#!/usr/bin/env bash
# Where the time of commands goes, by the method that decided: from `--profile`. GRAZING is the program,
# by default the release build.
set -eu
cd "$(dirname "$0")/.."
. benches/common.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
find_grazing
echo "| command | method | cases | of the cases | of the time |"
echo "| --- | --- | ---: | ---: | ---: |"
while read -r arguments; do
    # Undecided proofs are an answer, too: 3.
    # shellcheck disable=SC2086
    "$GRAZING" -q $arguments --profile "$folder/profile.csv" >/dev/null 2>"$folder/errors" || [ $? -eq 3 ] ||
        { cat "$folder/errors"; exit 1; }
    shown=${arguments%% -o *}
    tail -n +2 "$folder/profile.csv" | while IFS=, read -r method cases _ of_cases of_time; do
        awk -v c="$shown" -v m="$method" -v n="$cases" -v a="$of_cases" -v t="$of_time" \
            'BEGIN { printf "| `%s` | %s | %d | %.1f %% | %.1f %% |\n", c, m, n, 100 * a, 100 * t }'
    done
done <<COMMANDS
verify 2..=200
verify 2..=200 --method interval
classify --max-period 1000 --r 0.999 --s 21/100
classify --max-period 1000 --a1 5/4 --a2 9/10
classify --max-period 300 --r 1-1e-30 --s 1/3+1e-30
classify --max-period 300 --a1 1+1e-30 --a2 1/2
fuzz 3..=200 --cases 20000 --seed 1
fuzz 3..=200 --cases 2000 --seed 1 --definition-share 1
cover 3..=6
boundary 20
boundary 20 --digits 100
run examples/scenes/nordmark-2001.toml --only proofs -o $folder/run
COMMANDS
