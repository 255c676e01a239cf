#!/bin/sh
# Makes the Debian package of a build, and does with it what check-install.sh does with an installed
# build, in a clean system; with --unpacked, with its content unpacked into a directory instead:
# check-package.sh BUILD_DIRECTORY [--unpacked]
# Needs dpkg-dev; without it, it says so and ends with code 77.
set -eu
build=$(realpath "$1")
source=$(cd "$(dirname "$0")/.." && pwd)
if ! command -v dpkg-shlibdeps > /dev/null; then
  echo "skipped: dpkg-shlibdeps is not installed (package dpkg-dev)"
  exit 77
fi
packages=$(mktemp -d)
trap 'rm -rf "$packages"' EXIT
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$packages" > "$packages/log"
dpkg --info "$packages"/*.deb
if [ "${2:-}" = --unpacked ]; then
  "$source/scripts/check-install.sh" "$packages"/*.deb
else
  "$source/scripts/check-clean-system.sh" "$packages"/*.deb "$source" "$build"
fi
