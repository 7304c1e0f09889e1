#!/bin/sh
# Sends all parts, and their merge after them: `sh submit.sh` in this folder, on a file system that all nodes
# see.
set -eu
. ./campaign.sh
mkdir -p "$PARTS"
array=$(sbatch --parsable --array="1-$SHARDS" array.sbatch)
sbatch --dependency="afterany:$array" merge.sbatch
