#!/bin/sh
# Installs a build into a fresh directory, builds the examples of docs/examples against it, with
# CMake and with pkg-config, and runs them: check-install.sh BUILD_DIRECTORY
# The same with the content of a package that cpack -G DEB made: check-install.sh PACKAGE.deb
# The same with what is installed already: check-install.sh PREFIX
set -eu
from=$(realpath "$1")
source=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

prefix=$scratch/dbd
if [ -f "$from" ]; then
  dpkg -x "$from" "$scratch/package"
  mv "$scratch/package/usr" "$prefix"
elif [ -f "$from/CMakeCache.txt" ]; then
  cmake --install "$from" --prefix "$prefix" > "$scratch/install.log"
else
  prefix=$from
fi

cmake -S "$source/docs/examples" -B "$scratch/examples" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_BUILD_TYPE=Release > "$scratch/configure.log"
cmake --build "$scratch/examples"

# Which is the case decides what pkg-config is asked.
static=--static
if [ -n "$(find "$prefix" -name 'libdbd_core.so')" ]; then static=""; fi
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name dbd.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046,SC2086
c++ -o "$scratch/plan_one_pc" "$source/docs/examples/plan_one.cpp" \
  $(pkg-config --cflags --libs $static dbd)

"$scratch/examples/drive_anything" tomcar-tm27
"$prefix/bin/dbd" --quiet terrain generate --seed 3 --size 160 --relief-m 6 --out "$scratch/land"
ends="500030 5200030 500060 5200030"
for program in examples/plan_one examples/plan_one_c plan_one_pc; do
  # The loader's path is for the last one, which nobody told where shared libraries are.
  # shellcheck disable=SC2086
  LD_LIBRARY_PATH=$(pkg-config --variable=libdir dbd) \
    "$scratch/$program" "$scratch/land/dem.tif" $ends
done
# shellcheck disable=SC2086
"$scratch/examples/plan_many" "$scratch/land/dem.tif" $ends 500050 5200040 1 2
test -s "$prefix/share/dbd/schemas/plan.schema.json"
