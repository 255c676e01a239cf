#!/bin/sh
# Installs what is missing, builds everything with warnings as errors and runs all tests.
set -eu
cd "$(dirname "$0")/.."

./scripts/install-dependencies.sh
preset="${1:-ci}"
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
