#!/usr/bin/env bash
# Compares the bits of all results of random scenes between two builds of the library: loaded and posed
# ones, with creep forces, along curves, on varying rails and wheels. Prints the scenes that differ and
# fails if there are any, or if a program does not come to the last scene. A change that is meant to
# change no number passes.
# Usage: scripts/compare_bits.sh OLD_BUILD NEW_BUILD [COUNT [SEED]]
# The builds are folders such as build/release; COUNT scenes of each of five kinds (200), by SEED (71).
# The program of the new build draws the scenes and is run with either library. A library that was built
# before this program existed will do, as long as it has the functions of the C interface. A library of
# another version refuses that program: then the old build's own one runs with it. The checksums
# of an OLD_BUILD are kept in OLD_BUILD/scene_bits, so that they are computed once for each library and
# program.
set -euo pipefail

[ $# -ge 2 ] || {
  echo "usage: scripts/compare_bits.sh OLD_BUILD NEW_BUILD [COUNT [SEED]]" >&2
  exit 2
}
old=$(realpath "$1") new=$(realpath "$2") count=${3:-200} seed=${4:-71}
kinds=(drawn loaded posed curved varying)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
program=$new/bin/scene_bits
old_program=$program
if [ "$(objdump -p "$old/lib/libwrcontact.so" | grep SONAME)" != "$(objdump -p "$new/lib/libwrcontact.so" | grep SONAME)" ]; then
  old_program=$old/bin/scene_bits
fi
key=$(cat "$old/lib/libwrcontact.so" "$old_program" | sha256sum | cut -c1-16)
mkdir -p "$old/scene_bits"

# bits BUILD KIND FILE PROGRAM: the checksums of one kind; fails unless there is one for each scene.
bits() {
  local build=$1 kind=$2 file=$3 program=$4 folder status=0 lines
  folder=$(mktemp -d -p "$work")
  (cd "$folder" && LD_LIBRARY_PATH=$build/lib "$program" "$kind" "$count" "$seed") >"$folder.bits" ||
    status=$?
  lines=$(wc -l <"$folder.bits")
  if [ "$status" -ne 0 ] || [ "$lines" -ne "$count" ]; then
    echo "$kind: with $build/lib the program ended with status $status after $lines of $count scenes"
    return 1
  fi
  mv "$folder.bits" "$file"
}
failures=0
for kind in "${kinds[@]}"; do
  kept=$old/scene_bits/$kind-$count-$seed-$key
  [ -s "$kept" ] || bits "$old" "$kind" "$kept" "$old_program" &
  old_job=$!
  bits "$new" "$kind" "$work/$kind" "$program" &
  new_job=$!
  ended=yes
  wait "$old_job" || ended=no
  wait "$new_job" || ended=no
  if [ "$ended" = no ]; then
    failures=1
  elif cmp -s "$kept" "$work/$kind"; then
    echo "$kind: $count scenes with the same bits ($(grep -c ' ok ' "$kept" || true) solved)"
  else
    diff "$kept" "$work/$kind" | sed -n 's/^> /  /p' >"$work/differing" || true # diff fails where there are any
    echo "$kind: $(wc -l <"$work/differing") of $count scenes differ:"
    head -n 20 "$work/differing"
    failures=1
  fi
done
exit "$failures"
