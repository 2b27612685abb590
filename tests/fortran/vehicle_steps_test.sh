#!/usr/bin/env bash
# Vehicle steps through the module and the F77 layer: the same results as from C++, and no more
# growth of memory.
# Usage: vehicle_steps_test.sh STEPS VEHICLE_STEPS_CXX PROGRAM...
set -euo pipefail
# The library keeps influence coefficients of grids it has met, up to a limit of its own, so memory
# grows from any language. A leak of 100 bytes a step would be 400 kB more in 5000 steps; pages touched for the
# first time differ by some tens.
steps=$1
most_kb=300

value() { awk -v name="$1" '$1 == name { print tolower($2) }' <<<"$2"; }

failures=0
reference=$("$2" "$steps")
shift 2
for program in "$@"; do
  printed=$("$program" "$steps")
  if [ $(($(value growth_kb "$printed") - $(value growth_kb "$reference"))) -gt $most_kb ]; then
    echo "$program grows: $printed"
    echo "C++: $reference"
    failures=1
  fi
  # The same poses, but for rounding in 2 pi i/2000.
  awk -v one="$(value sum "$printed")" -v other="$(value sum "$reference")" \
    'BEGIN { d = one/other - 1; exit !(d < 1e-6 && d > -1e-6) }' || {
    echo "$program: other results than $reference: $printed"
    failures=1
  }
done
exit "$failures"
