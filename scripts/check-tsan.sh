#!/bin/sh
# Runs the tests of threads under the thread sanitizer, the one with eight clients many times:
# check-tsan.sh [REPEATS]. Its trees are build/tsan and build/tsan-libraries; later runs reuse them.
# TBB and OMPL are built under the sanitizer too, from Debian's sources of the installed versions:
# it does not see the atomic counters of other code, and takes what they protect for races.
set -eu
repeats=${1:-20}
cd "$(dirname "$0")/.."
libraries=$PWD/build/tsan-libraries
mkdir -p "$libraries/lists/partial"

# Sources are fetched with a list of their own, so that the system's stays as it is.
apt_sources() {
  apt-get -qq -o Dir::Etc::SourceList="$libraries/sources.list" -o Dir::Etc::SourceParts=- \
    -o Dir::State::Lists="$libraries/lists" -o APT::Sandbox::User=root "$@"
}

# build_library SOURCE_PACKAGE LIBRARY INSTALLED_PACKAGE CMAKE_OPTIONS...: LIBRARY under the sanitizer.
build_library() {
  name=$1 library=$2 installed=$3
  shift 3
  if [ -d "$libraries/$name" ] && [ -n "$(find "$libraries/$name" -name "$library")" ]; then return; fi
  version=$(dpkg-query -W -f='${source:Version}' "$installed")
  (cd "$libraries" && rm -rf "$name" "$name"-*/ && apt_sources source "$name=$version" && mv "$name"-*/ source-"$name")
  cmake -S "$libraries/source-$name" -B "$libraries/$name" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1 -DNDEBUG -fsanitize=thread" "$@" > "$libraries/$name.log"
}
