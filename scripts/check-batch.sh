#!/bin/sh
# Kills a batch 20 times with SIGKILL at random moments, fills its disk, takes away its output, and
# holds that after --resume every request is answered once, as in a run that nobody disturbed:
# check-batch.sh PROGRAM
# The full disk is a tmpfs of 16 kB; who may not mount one gets that part skipped.
set -eu
program=$(realpath "$1")
scratch=$(mktemp -d)
disk=$scratch/disk
finish() {
  umount "$disk" 2> /dev/null || true
  rm -rf "$scratch"
}
trap finish EXIT
cd "$scratch"

fail() {
  echo "$*" >&2
  exit 1
}

write_requests() {
  "$program" --quiet terrain generate --seed 3 --size 160 --relief-m 6 --out land > land.log
  i=0
  while [ $((i += 1)) -le 120 ]; do
    printf '{"id": "r%s", "dem": "%s/land/dem.tif", "vehicle": "tomcar-tm27", "candidates": 4, ' \
      "$i" "$scratch"
    printf '"seed": %s, "start": [500030, 5200030], "goal": [500080, 5200060]}\n' "$i"
  done > requests.jsonl
}

# run OUT: answers what is left.
run() {
  "$program" --quiet batch requests.jsonl --out "$1" --resume > log 2> errors
}

# expect_complete OUT: line by line what the undisturbed run gave.
expect_complete() {
  sort "$1" | diff expected - > difference || fail "$1 differs: $(head -c 300 difference)"
}

# A random number of milliseconds up to $1, as seconds.
moment() {
  od -An -N2 -tu2 /dev/urandom | awk -v most="$1" '{printf "%.3f", $1 / 65536 * most / 1000}'
}

write_requests
begin=$(date +%s%N)
run alone.jsonl
longest=$((($(date +%s%N) - begin) / 8000000))
sort alone.jsonl > expected
[ "$(wc -l < expected)" -eq 120 ] || fail "not 120 results: $(cat errors)"

kills=0
while [ "$kills" -lt 20 ]; do
  "$program" --quiet batch requests.jsonl --out killed.jsonl --resume > log 2> errors &
  pid=$!
  sleep "$(moment "$longest")"
  kill -9 "$pid" 2> /dev/null || break
  wait "$pid" 2> /dev/null || true
  kills=$((kills + 1))
done
run killed.jsonl
expect_complete killed.jsonl
echo "killed $kills times: 120 results, the same as of one run"

mkdir "$disk"
if mount -t tmpfs -o size=16k tmpfs "$disk" 2> /dev/null; then
  code=0
  run "$disk/full.jsonl" || code=$?
  [ "$code" -ne 0 ] || fail "a full disk was not noticed"
  [ "$(wc -l < errors)" -eq 1 ] || fail "not one line: $(cat errors)"
  echo "disk full: exit code $code, $(cat errors)"
  kept=$(wc -l < "$disk/full.jsonl")
  cp "$disk/full.jsonl" freed.jsonl
  run freed.jsonl
  expect_complete freed.jsonl
  echo "$kept results were kept; with room again: 120, the same as of one run"
else
  echo "no tmpfs may be mounted here: the full disk is skipped"
fi

code=0
run /proc/results.jsonl || code=$?
[ "$code" -eq 2 ] || fail "an output that cannot be written gave exit code $code"
echo "output that cannot be written: $(cat errors)"
