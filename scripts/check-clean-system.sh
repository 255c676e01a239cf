#!/bin/sh
# Installs the Debian package of dbd in a clean system, and does there what check-install.sh does:
# check-clean-system.sh PACKAGE.deb [HIDDEN_DIRECTORY...]
# The clean system is a layer in memory over this one, with no network and no processes but its own:
# bare Debian, the package, what it depends on, and compiler, CMake, Ninja and pkg-config. The hidden
# directories (source and build trees) are empty in it. Nothing outside of the layer changes.
# Needs root, apt and a kernel that allows such layers; without, it says so and ends with code 77.
set -eu
skip() {
  echo "skipped: $1"
  exit 77
}

if [ -z "${DBD_LAYER:-}" ]; then
  command -v apt-get > /dev/null || skip "this is no Debian system"
  [ "$(id -u)" -eq 0 ] || skip "only root can install packages"
  unshare --mount --pid --net --fork true 2> /dev/null || skip "no namespaces are allowed here"
  DBD_LAYER=$(mktemp -d)
  export DBD_LAYER
  trap 'rmdir "$DBD_LAYER"' EXIT
  status=0
  unshare --mount --pid --net --kill-child "$0" "$@" || status=$?
  exit "$status"
fi

package=$(realpath "$1")
source=$(cd "$(dirname "$0")/.." && pwd)
shift

# The layer, with file systems of its own where a clean system has nothing of ours.
mount -t tmpfs tmpfs "$DBD_LAYER" || skip "no file system may be mounted here"
mkdir "$DBD_LAYER/changes" "$DBD_LAYER/work" "$DBD_LAYER/system"
system=$DBD_LAYER/system
mount -t overlay overlay "$system" \
  -o "lowerdir=/,upperdir=$DBD_LAYER/changes,workdir=$DBD_LAYER/work" || skip "no overlay file system"
mount -t proc proc "$system/proc" || skip "no file system for processes"
mount --rbind /dev "$system/dev"
for directory in /root /home /tmp /run /opt /usr/local "$@"; do
  if [ -d "$system$directory" ]; then mount -t tmpfs tmpfs "$system$directory"; fi
done

# What goes in: the package, the outside programs, and the script that builds them.
mkdir -p "$system/root/outside/docs" "$system/root/outside/scripts"
cp "$package" "$system/root/dbd.deb"
cp -r "$source/docs/examples" "$system/root/outside/docs"
cp "$source/scripts/check-install.sh" "$system/root/outside/scripts"

export DEBIAN_FRONTEND=noninteractive HOME=/root
inside() {
  chroot "$system" "$@"
}
quiet_apt() {
  inside apt-get -qq -y -o DPkg::Options::=--force-unsafe-io \
    -o APT::AutoRemove::RecommendsImportant=false -o APT::AutoRemove::SuggestsImportant=false \
    "$@" > "$DBD_LAYER/log" 2>&1 || { cat "$DBD_LAYER/log"; exit 1; }
}
quiet_apt install /root/dbd.deb
# shellcheck disable=SC2046
inside apt-mark auto $(inside apt-mark showmanual) > "$DBD_LAYER/log"
inside apt-mark manual dbd g++ cmake ninja-build pkg-config > "$DBD_LAYER/log"
# What packages run when they are removed is for systems that live on, and takes most of the time.
rm -f "$system"/var/lib/dpkg/info/*.prerm "$system"/var/lib/dpkg/info/*.postrm
quiet_apt autoremove
echo "in a clean system of $(inside dpkg-query -W | wc -l) packages:"
for directory in "$@"; do inside sh -c "! ls -A '$directory' 2> /dev/null | grep -q ."; done
inside /root/outside/scripts/check-install.sh /usr
