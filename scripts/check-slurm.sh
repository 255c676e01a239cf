#!/bin/sh
# Runs docs/examples/batch_array.sh on a Slurm of one node that it starts itself, requeues a task in
# the middle, merges, and compares with one run: check-slurm.sh PROGRAM
# Needs the packages slurm-wlm and munge; without them it says so and ends with code 77.
set -eu
program=$(realpath "$1")
source=$(cd "$(dirname "$0")/.." && pwd)
PATH=/usr/sbin:/sbin:$PATH
for tool in munged slurmctld slurmd sbatch; do
  if ! command -v "$tool" > /dev/null; then
    echo "skipped: $tool is not installed (packages slurm-wlm and munge)"
    exit 77
  fi
done

scratch=$(mktemp -d)
chmod 755 "$scratch"
daemons=""
finish() {
  for pid in $daemons; do kill "$pid" 2> /dev/null || true; done
  for pid in $daemons; do wait "$pid" 2> /dev/null || true; done
  rm -rf "$scratch"
}
trap finish EXIT

# Waits at most two minutes for a command to succeed.
await() {
  tries=600
  until "$@" > /dev/null 2>&1; do
    tries=$((tries - 1))
    if [ "$tries" -eq 0 ]; then
      echo "no success: $*" >&2
      tail -n 5 "$scratch"/*.log >&2
      exit 1
    fi
    sleep 0.2
  done
}

start_slurm() {
  user=$(id -un) host=$(hostname -s) port=$((20000 + $$ % 20000))
  mkdir "$scratch/state" "$scratch/spool" "$scratch/munge"
  (umask 077 && head -c 1024 /dev/urandom > "$scratch/munge/key")
  munged --foreground --force --socket="$scratch/munge/socket" --key-file="$scratch/munge/key" \
    --pid-file="$scratch/munge/pid" --log-file="$scratch/munge.log" \
    --seed-file="$scratch/munge/seed" > "$scratch/munged.log" 2>&1 &
  daemons="$!"
  cat > "$scratch/slurm.conf" <<END
ClusterName=dbd
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$scratch/munge/socket,cred_expire=5
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
TopologyParam=NoInAddrAny,NoCtldInAddrAny
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
  export SLURM_CONF="$scratch/slurm.conf"
  await test -S "$scratch/munge/socket"
  slurmctld -D > "$scratch/slurmctld.log" 2>&1 &
  daemons="$daemons $!"
  slurmd -D > "$scratch/slurmd.log" 2>&1 &
  daemons="$daemons $!"
  await sh -c 'sinfo -h -o %T | grep -q idle'
}

write_requests() {
  "$program" --quiet terrain generate --seed 3 --size 160 --relief-m 6 --out "$scratch/land" \
    > land.log
  for i in 1 2 3 4 5 6 7 8 9 10 11; do
    printf '{"dem": "%s", "vehicle": "tomcar-tm27", "candidates": 4, "seed": %s, ' \
      "$scratch/land/dem.tif" "$i"
    printf '"start": [500030, 5200030], "goal": [500060, 5200030]}\n'
  done > "$scratch/requests.jsonl"
  echo "no JSON" >> "$scratch/requests.jsonl"
}

# Exit code 2: one request is wrong on purpose.
expect_code_2() {
  code=0
  "$@" || code=$?
  [ "$code" -eq 2 ]
}

cd "$scratch"
write_requests
expect_code_2 "$program" --quiet batch requests.jsonl --out alone.jsonl > alone.log
sort alone.jsonl > expected

start_slurm
mkdir bin && ln -s "$program" bin/dbd
PATH="$scratch/bin:$PATH"
begin=$(date +%s)
array=$(sbatch --parsable --array=1-3 --cpus-per-task=1 "$source/docs/examples/batch_array.sh" \
  requests.jsonl parts 3)
merge=$(sbatch --parsable --dependency=afterany:"$array" --wrap \
  'dbd batch --merge parts/part*.jsonl --out results.jsonl')
await test -s parts/part1.jsonl
scontrol requeue "${array}_1"
echo "requeued task 1 after $(wc -l < parts/part1.jsonl) of its results"
tries=600
while [ -n "$(squeue -h -j "$merge" 2> /dev/null)" ] && [ "$tries" -gt 0 ]; do
  tries=$((tries - 1))
  sleep 0.5
done
cat slurm-*.out
sort results.jsonl | diff expected -
echo "$(wc -l < results.jsonl) results of 3 tasks and a merge in $(($(date +%s) - begin)) s," \
  "the same as of one run"
