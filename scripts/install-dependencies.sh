#!/bin/sh
# Installs the Debian packages that dbd is built with, unless all are there already. Further
# packages may be named: libsimbody-dev and libmujoco-dev add the comparisons with Simbody and MuJoCo.
set -eu

packages="g++ cmake ninja-build pkg-config git ca-certificates ccache dpkg-dev
  libeigen3-dev libompl-dev libtbb-dev liboctomap-dev libspdlog-dev
  libgdal-dev libassimp-dev libcairo2-dev libssl-dev libjs-chart.js fonts-dejavu-core gnuplot-nox
  libcli11-dev nlohmann-json3-dev libgtest-dev libgmock-dev libvalijson-dev
  libbenchmark-dev $*"

missing=""
for package in $packages; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=""
if [ "$(id -u)" -ne 0 ]; then as_root="sudo"; fi
echo "Installing:$missing"
$as_root apt-get update -qq
# One command for all: libgdal-dev and libproj-dev want different curl packages otherwise.
# shellcheck disable=SC2086
DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing
