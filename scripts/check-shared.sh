#!/bin/sh
# Builds dbd with shared libraries and does with them what check-install.sh does:
# check-shared.sh BUILD_DIRECTORY [CMAKE_OPTIONS...]
# Objects are those of static libraries: ccache, where it is installed, has them already.
set -eu
build=$1
source=$(cd "$(dirname "$0")/.." && pwd)
shift
cmake -S "$source" -B "$build" -G Ninja -DBUILD_SHARED_LIBS=ON -DDBD_BUILD_TESTS=OFF \
  -DDBD_BUILD_BENCHMARKS=OFF "$@" > /dev/null
cmake --build "$build"
"$source/scripts/check-install.sh" "$build"
