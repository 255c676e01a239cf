#!/bin/sh
# Installs what is missing, builds the program, generates a landscape and plans a route across it.
set -eu
cd "$(dirname "$0")/.."

./scripts/install-dependencies.sh
cmake --preset release -DDBD_BUILD_TESTS=OFF -DDBD_BUILD_BENCHMARKS=OFF > /dev/null
cmake --build --preset release --target dbd

dbd=build/release/apps/dbd
$dbd terrain generate --seed 7 --out out/land
$dbd plan --dem out/land/dem.tif \
  --materials out/land/materials.tif --material-table out/land/materials.json \
  --obstacles out/land/obstacles.bt --obstacles-origin 500000,5200000 \
  --vehicle tomcar-tm27 --start 500066,5200034 --goal 500364,5200320 --out out/demo
echo
echo "The picture is out/demo/map.png; route.geojson opens in any GIS."
