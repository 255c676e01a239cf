#!/bin/sh
# One share of a request file, as a task of a Slurm job array: of 8 shares, all or only the third:
#   sbatch --array=1-8 batch_array.sh requests.jsonl parts 8
#   sbatch --array=3 batch_array.sh requests.jsonl parts 8
#SBATCH --job-name=dbd
#SBATCH --cpus-per-task=2
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu
requests=$1 parts=$2 shares=$3
share=$SLURM_ARRAY_TASK_ID
mkdir -p "$parts"
# --resume: a task that was killed, requeued or submitted again answers what is left.
# exec: dbd itself gets the signals of scancel and of the time limit, and ends in good order.
exec dbd batch "$requests" --shard "$share/$shares" --out "$parts/part$share.jsonl" --resume \
  --threads "$SLURM_CPUS_PER_TASK"
