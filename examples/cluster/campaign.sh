# What the campaign is. The other scripts read this file; it is the one to change.

# The number of parts, each of which should take minutes.
SHARDS=16
# A folder that all nodes see. It holds the parts and the logs.
PARTS=parts
# What is wanted in the end.
RESULT=theorem2.txt
# How often missing parts are sent again.
RETRIES=3

# Does part $1, on as many cores as the job has.
shard() {
    grazing verify 3..=500 --jobs "${SLURM_CPUS_PER_TASK:-1}" --quiet \
        --shard "$1/$SHARDS" --certificate "$PARTS/part-$1"
}

# Other campaigns. `--resume` lets a part that was killed go on from where it was. That of `fuzz` writes four
# times a second: where hundreds of parts run at a time, keep its state on the node's own disk.
#
#   grazing fuzz --words --cases 1e12 --shard "$1/$SHARDS" --resume "$PARTS/state-$1" -o "$PARTS/part-$1"
#   grazing cover 3..=64 --shard "$1/$SHARDS" --resume "$PARTS/state-$1" --certificate "$PARTS/part-$1"
#   grazing run machine.toml --only basins --shard "$1/$SHARDS" -o "$PARTS/part-$1"
