#!/usr/bin/env bash
# The scripts of examples/cluster under a real SLURM on this machine: an array of 16 shards, of which three
# are killed, one is damaged, one is of another version and one is false; each fault is named, what is
# missing or false is sent again, and the result is that of one run.
#
#     tests/cluster/slurm.sh target/release/grazing
#
# Needs root, and slurmctld, slurmd, slurm-client and munge, which are installed if they are missing. Starts
# daemons of its own, on ports of its own, and ends them. A daemon that does not start is a failure.
set -euo pipefail
binary=$(realpath "${1:?the program grazing}")
here=$(realpath "$(dirname "$0")")
[ "$(id -u)" = 0 ] || { echo "slurm.sh: must be run as root" >&2; exit 2; }

missing=()
command -v slurmctld >/dev/null || missing+=(slurmctld)
command -v slurmd >/dev/null || missing+=(slurmd)
command -v sbatch >/dev/null || missing+=(slurm-client)
command -v munged >/dev/null || missing+=(munge)
if [ "${#missing[@]}" -gt 0 ]; then
    apt-get update --quiet=2
    DEBIAN_FRONTEND=noninteractive apt-get install --quiet=2 --yes --no-install-recommends "${missing[@]}" >/dev/null
fi

work=$(mktemp -d /tmp/grazing-slurm.XXXXXX)
daemons=()
fail() {
    echo "slurm.sh: $*" >&2
    for log in "$work"/*.log "$work"/campaign/parts/{faults,merge-*}; do
        [ -f "$log" ] && { echo "-- $log" >&2; tail -n 20 "$log" >&2; }
    done
    exit 1
}
finish() {
    scancel --user=root >/dev/null 2>&1 || true
    # The last started first: slurmd, slurmctld, munged.
    for ((i = ${#daemons[@]} - 1; i >= 0; i--)); do kill "${daemons[i]}" 2>/dev/null || true; done
    for _ in {1..50}; do
        kill -0 "${daemons[@]}" 2>/dev/null || break
        sleep 0.1
    done
    kill -KILL "${daemons[@]}" 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT

# -- The daemons.
host=$(hostname -s)
mkdir -p "$work"/{state,spool,munge}
chmod 700 "$work"/munge
head -c 1024 /dev/urandom >"$work/munge/key"
chmod 400 "$work/munge/key"
port=$((20000 + RANDOM % 20000))
cat >"$work/slurm.conf" <<EOF
ClusterName=grazing
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=10000
SwitchType=switch/none
ReturnToService=2
KillWait=1
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool/%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmdParameters=config_overrides
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=2 State=UNKNOWN
PartitionName=all Nodes=n1 Default=YES State=UP MaxTime=UNLIMITED
EOF
export SLURM_CONF=$work/slurm.conf
start() { # name, command: in the foreground, so that it is our child
    local name=$1
    shift
    "$@" >"$work/$name.log" 2>&1 &
    daemons+=($!)
}
start munged munged --foreground --force --socket="$work/munge/socket" --key-file="$work/munge/key" \
    --pid-file="$work/munge/pid" --seed-file="$work/munge/seed" --log-file="$work/munge/log"
for _ in $(seq 100); do [ -S "$work/munge/socket" ] && break || sleep 0.1; done
[ -S "$work/munge/socket" ] || fail "munged does not start"
start slurmctld slurmctld -D -c
start slurmd slurmd -D -N n1
for _ in $(seq 150); do
    [ "$(sinfo --noheader --format=%T 2>/dev/null)" = idle ] && break || sleep 0.2
done
[ "$(sinfo --noheader --format=%T)" = idle ] || fail "the node does not come up: $(sinfo 2>&1)"
echo "SLURM $(sinfo --version | cut -d' ' -f2) is up after $SECONDS s"

# -- The campaign, as users have it.
cp -r "$here/../../examples/cluster" "$work/campaign"
mkdir "$work/campaign/parts" "$work/bin" "$work/marks"
cd "$work/campaign"
# In its first array the parts 3, 8 and 13 are killed by SLURM before they have done anything: the program is too quick to be met
# in the midst of its work here; kills.sh does that. SLURM may not know yet that a job runs, so it is asked until it does.
cat >"$work/bin/grazing" <<EOF
#!/bin/bash
task=\$SLURM_ARRAY_TASK_ID
case "\$1 \$task" in
"verify 3" | "verify 8" | "verify 13")
    if [ ! -e "$work/marks/\$task" ]; then
        touch "$work/marks/\$task"
        for _ in {1..100}; do
            scancel --full --signal=KILL "\${SLURM_ARRAY_JOB_ID}_\$task"
            sleep 0.2
        done
        exit 1
    fi ;;
esac
exec "$binary" "\$@"
EOF
chmod +x "$work/bin/grazing"
export PATH=$work/bin:$PATH
settled() { # waits until no job is left
    for _ in $(seq 300); do
        [ -z "$(squeue --noheader 2>/dev/null)" ] && return || sleep 0.2
    done
    fail "jobs do not end: $(squeue)"
}
array=$(sbatch --parsable array.sbatch)
settled
echo "array $array is over after $SECONDS s"
for part in 3 8 13; do
    [ -e "$work/marks/$part" ] || fail "part $part was not killed"
    [ ! -e "parts/part-$part" ] || fail "part $part was killed after it was done"
done
[ "$(find parts -name 'part-*' | wc -l)" = 13 ] || fail "13 parts should be there: $(ls parts)"

# One file is damaged, one is of another version, with the checksums that such a file has.
sed -i '0,/orbit/s//orbis/' parts/part-5
python3 - parts/part-11 <<'EOF'
import re, sys

def fnv(text):
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return value

path = sys.argv[1]
text = open(path).read()
command = re.search("^command (.*)$", text, re.M)[1]
task = f"program 0.0.0 task {fnv('0.0.0 ' + command):016x}"
body = re.sub("^program .*$", task, text[: text.rindex("end ")], flags=re.M)
records = sum(line.startswith("item ") for line in body.splitlines())
open(path, "w").write(f"{body}end {records} {fnv(body):016x}\n")
EOF
if grazing merge parts/part-* -o early.txt 2>faults; then fail "merge takes what is not whole"; else code=$?; fi
[ "$code" = 2 ] || fail "merge ends with $code, not 2"
[ ! -e early.txt ] || fail "merge writes what is not whole"
for wanted in "part-5: it is damaged: its checksum does not match" "part-11: it is by version 0.0.0, the others are by" \
    "5 of 16 shards are missing: --array=3,5,8,11,13"; do
    grep -qF -- "$wanted" faults || fail "merge does not say: $wanted; it says: $(cat faults)"
done

# One lies, with the checksum that such a file has.
python3 - parts/part-14 <<'EOF'
import sys

path = sys.argv[1]
text = open(path).read()
body = text[: text.rindex("end ")]
assert " + -" in body
body = body.replace(" + -", " - -", 1)
value = 0xCBF29CE484222325
for byte in body.encode():
    value = (value ^ byte) * 0x100000001B3 % 2**64
open(path, "w").write(f"{body}end {body.count(chr(10) + 'item ')} {value:016x}\n")
EOF

# The merge job finds the same, sends them again and, after them, itself.
sbatch merge.sbatch >/dev/null
settled
[ -f theorem2.txt ] || fail "the last merge wrote nothing"
grep -qs "part-14: rejected: " parts/merge-* || fail "no merge names the part that lies"
grazing verify 3..=500 --certificate one-run.txt --quiet >/dev/null
cmp theorem2.txt one-run.txt || fail "the merged certificate is not that of one run"
[ "$(find parts -name '.grazing-*' | wc -l)" = 0 ] || fail "temporary files of killed parts are left: $(ls -A parts)"
echo "16 shards, 3 killed, 1 damaged, 1 of another version, 1 false: named, sent again, and the result is that of one run ($SECONDS s)"
