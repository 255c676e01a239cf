#!/bin/sh
# Installs a build into a fresh directory, builds the examples of docs/examples against it, with
# CMake and with pkg-config, and runs them: check-install.sh BUILD_DIRECTORY
set -eu
build=$(cd "$1" && pwd)
source=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

cmake --install "$build" --prefix "$scratch/dbd" > "$scratch/install.log"
cmake -S "$source/docs/examples" -B "$scratch/examples" -DCMAKE_PREFIX_PATH="$scratch/dbd" \
  -DCMAKE_BUILD_TYPE=Release > "$scratch/configure.log"
cmake --build "$scratch/examples"

"$scratch/examples/drive_anything" tomcar-tm27
"$scratch/dbd/bin/dbd" --quiet terrain generate --seed 3 --size 160 --relief-m 6 --out "$scratch/land"
ends="500030 5200030 500060 5200030"
# shellcheck disable=SC2086
"$scratch/examples/plan_one" "$scratch/land/dem.tif" $ends
# shellcheck disable=SC2086
"$scratch/examples/plan_many" "$scratch/land/dem.tif" $ends 500050 5200040 1 2
