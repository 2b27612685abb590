#!/usr/bin/env bash
# scripts/compare_bits.sh calls scenes the same only if both programs have solved all of them. Builds here
# are stubs: the library is the script that the program runs. Usage: compare_bits.sh PROJECT
# shellcheck disable=SC2016 # what is quoted are scripts
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# build NAME COMMANDS: of a program that is called with a kind of scenes, their number and a seed.
build() {
  mkdir -p "$work/$1/lib" "$work/$1/bin"
  echo "$2" >"$work/$1/lib/libwrcontact.so"
  printf '%s\n' '#!/bin/sh' '. "$LD_LIBRARY_PATH/libwrcontact.so"' >"$work/$1/bin/scene_bits"
  chmod +x "$work/$1/bin/scene_bits"
}
scenes='for i in $(seq "$2"); do echo "$i ok 1$1"; done'
build old "$scenes"
build equal "$scenes # another file"
build different 'for i in $(seq "$2"); do echo "$i ok $(((i == 3) + 1))$1"; done'
build dies 'echo "1 ok 1$1"; kill -SEGV $$'
build fails "$scenes; exit 1"
build short 'echo "1 ok 1$1"'
build silent ':'
build programless ''
rm "$work/programless/bin/scene_bits"

# expect STATUS TEXT OLD NEW: the script ends so, and prints a line with TEXT for each of five kinds.
expect() {
  local status=0
  "$project/scripts/compare_bits.sh" "$3" "$4" 5 >"$work/printed" 2>&1 || status=$?
  if [ "$status" -ne "$1" ] || [ "$(grep -c -- "$2" "$work/printed")" -ne 5 ]; then
    echo "$3 and $4: status $status, expected $1 and five lines with: $2"
    cat "$work/printed"
    exit 1
  fi
}
project=$(realpath "$1")
cd "$work" # folders may be relative
expect 0 ': 5 scenes with the same bits (5 solved)' old equal
expect 0 ': 5 scenes with the same bits (5 solved)' old old # what is kept
expect 1 ': 1 of 5 scenes differ:' old different
expect 1 'dies/lib the program ended with status 139 after 1 of 5 scenes' old dies
expect 1 'dies/lib the program ended with status 139 after 1 of 5 scenes' dies equal
expect 1 'fails/lib the program ended with status 1 after 5 of 5 scenes' old fails
expect 1 'short/lib the program ended with status 0 after 1 of 5 scenes' old short
expect 1 'silent/lib the program ended with status 0 after 0 of 5 scenes' silent equal

# A library that was built again is not judged by what its predecessor's sums were.
cp "$work/different/lib/libwrcontact.so" "$work/old/lib"
expect 1 ': 1 of 5 scenes differ:' old equal
if "$project/scripts/compare_bits.sh" old programless 5 >printed 2>&1; then
  echo "a build without the program passes:"
  cat printed
  exit 1
fi
