#!/usr/bin/env bash
# Compares the bits of all results of random scenes between two builds of the library: loaded and posed
# ones, with creep forces, along curves, on varying rails and wheels. Prints the scenes that differ and
# fails if there are any. A change that is meant to change no number passes.
# Usage: scripts/compare_bits.sh OLD_BUILD NEW_BUILD [COUNT [SEED]]
# The builds are folders such as build/release; COUNT scenes of each of five kinds (200), by SEED (71).
# The program of the new build draws the scenes and is run with either library. A library that was built
# before this program existed will do, as long as it has the functions of the C interface. The checksums
# of an OLD_BUILD are kept in OLD_BUILD/scene_bits, so that they are computed once.
set -euo pipefail
cd "$(dirname "$0")/.."

[ $# -ge 2 ] || {
  echo "usage: scripts/compare_bits.sh OLD_BUILD NEW_BUILD [COUNT [SEED]]" >&2
  exit 2
}
old=$(realpath "$1") new=$(realpath "$2") count=${3:-200} seed=${4:-71}
kinds=(drawn loaded posed curved varying)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$old/scene_bits" "$work/new"

# bits BUILD KIND FILE: the checksums of one kind.
bits() {
  mkdir -p "$work/$2-$$"
  (cd "$work/$2-$$" && LD_LIBRARY_PATH=$1/lib "$new/bin/scene_bits" "$2" "$count" "$seed") >"$3.part"
  mv "$3.part" "$3"
}
failures=0
for kind in "${kinds[@]}"; do
  kept=$old/scene_bits/$kind-$count-$seed
  [ -s "$kept" ] || bits "$old" "$kind" "$kept" &
  bits "$new" "$kind" "$work/new/$kind" &
  wait
  differing=$(diff "$kept" "$work/new/$kind" | grep '^>' || true) # diff fails where there are any
  if [ -n "$differing" ]; then
    echo "$kind: $(wc -l <<<"$differing") of $count scenes differ:"
    head -n 20 <<<"${differing//> /  }"
    failures=1
  else
    echo "$kind: $count scenes with the same bits ($(grep -c ' ok ' "$kept" || true) solved)"
  fi
done
exit "$failures"
