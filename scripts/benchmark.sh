#!/bin/sh
# Runs the benchmarks of a build, one after the other, and prints their tables as Markdown:
#   scripts/benchmark.sh [BUILD_DIRECTORY [REPETITIONS]]
# The machine should do nothing else meanwhile; the spread in the tables tells whether it did.
set -eu
build=$(cd "${1:-$(dirname "$0")/../build/release}" && pwd)
repetitions="${2:-3}"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

for name in simulation lane mujoco roofline body_parallel terrain load; do
  [ -x "$build/benchmarks/${name}_benchmark" ] || continue  # an optional one
  echo "$name ..." >&2
  "$build/benchmarks/${name}_benchmark" --benchmark_repetitions="$repetitions" \
    --benchmark_out="$scratch/$name.json" --benchmark_out_format=json > /dev/null
done

echo "# Benchmarks of $(date -u +%F)"
echo
grep -m1 "model name" /proc/cpuinfo | sed 's/.*: //'
"$build/benchmarks/markdown_table" "$scratch"/*.json
