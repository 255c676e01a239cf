#!/bin/sh
# Runs the tests of what threads share under the thread sanitizer, the one of eight clients that
# submit and cancel at random many times: check-tsan.sh [REPEATS], default 20.
# TBB and OMPL are built under the sanitizer too, from Debian's sources of the installed versions:
# it does not see the atomic counters of other code, and takes what they guard for races.
# Its trees, build/tsan and build/tsan-libraries, are used again by the next run.
set -eu
repeats=${1:-20}
cd "$(dirname "$0")/.."
libraries=$PWD/build/tsan-libraries
mkdir -p "$libraries/lists/partial"
./scripts/install-dependencies.sh libboost-serialization-dev libboost-filesystem-dev \
  libboost-system-dev libboost-program-options-dev

# Sources come by a list of their own: the system's stays as it is.
source_apt() {
  apt-get -qq -o Dir::Etc::SourceList="$libraries/sources.list" -o Dir::Etc::SourceParts=- \
    -o Dir::State::Lists="$libraries/lists" "$@"
}

fetch_source() {  # SOURCE_PACKAGE PACKAGE_OF_IT_THAT_IS_INSTALLED
  if [ -d "$libraries/$1-source" ]; then return; fi
  . /etc/os-release
  echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" > "$libraries/sources.list"
  source_apt update
  (cd "$libraries" &&
    source_apt source "$1=$(dpkg-query -W -f='${source:Version}' "$2")" && mv "$1"-*/ "$1-source")
}

build_library() {  # SOURCE_PACKAGE TARGET CMAKE_OPTIONS...
  name=$1 target=$2
  shift 2
  cmake -S "$libraries/$name-source" -B "$libraries/$name" -G Ninja \
    -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1 -DNDEBUG -fsanitize=thread" \
    "$@" > "$libraries/$name.log" 2>&1
  cmake --build "$libraries/$name" --target "$target"
}

fetch_source onetbb libtbb-dev
build_library onetbb tbb -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF
cmake --install "$libraries/onetbb" --prefix "$libraries/installed" > "$libraries/onetbb.log"
fetch_source ompl libompl-dev
build_library ompl ompl -DOMPL_BUILD_TESTS=OFF -DOMPL_BUILD_DEMOS=OFF -DOMPL_REGISTRATION=OFF \
  -DOMPL_BUILD_PYBINDINGS=OFF -DOMPL_BUILD_PYTESTS=OFF

cmake --preset tsan -DCMAKE_PREFIX_PATH="$libraries/installed" -DDBD_BUILD_APPS=OFF \
  -DDBD_OMPL_LIBRARY="$libraries/ompl/lib/libompl.so" > "$libraries/dbd.log"
cmake --build --preset tsan --target planner_tests
export TSAN_OPTIONS="second_deadlock_stack=1"
build/tsan/tests/planner_tests --gtest_filter='*Service.*:LayerCache.*'
build/tsan/tests/planner_tests --gtest_filter='*ManyClients*' --gtest_repeat="$repeats"
