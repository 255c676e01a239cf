#!/bin/sh
# Fails where an object file for a wide instruction set defines a function with wide instructions
# that other translation units may define too: the linker keeps one copy for the whole program,
# and a processor without these instructions would run it. Functions over packs carry their
# translation unit's instruction set in their names and are in no other.
set -eu
for object in "$@"; do
  case "$object" in *lane_engine_avx*) ;; *) continue ;; esac
  shared=$(nm -C --defined-only "$object" | sed -n 's/^[0-9a-f]* [WVu] //p' | grep -vE 'Pack<[a-z]+, [0-9]+, (2|512)>' || true)
  wide=$(objdump -d -C --no-show-raw-insn "$object" |
    awk '/^[0-9a-f]+ <.*>:$/ {name = $0; sub(/^[0-9a-f]+ </, "", name); sub(/>:$/, "", name)}
         /%[yz]mm/ {print name}' | sort -u)
  both=$(printf '%s\n' "$shared" "$wide" | sort | uniq -d | grep . || true)
  if [ -n "$both" ]; then
    printf '%s defines for everybody, with wide instructions:\n%s\n' "$object" "$both" >&2
    exit 1
  fi
done
