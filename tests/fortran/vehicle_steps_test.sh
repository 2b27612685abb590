#!/usr/bin/env bash
# A few thousand vehicle steps by each program: the same results, and no growth of memory.
# Usage: vehicle_steps_test.sh PROGRAM...
set -euo pipefail
failures=0
reference=
for program in "$@"; do
  printed=$("$program" 4000)
  sum=$(awk '$1 == "sum" { print $2 }' <<<"$printed" | tr E e)
  growth=$(awk '$1 == "growth_kb" { print $2 }' <<<"$printed")
  # The first steps fill what is kept; pages that are touched later for the first time are a few. A
  # leak of a hundred bytes a step would be 300 kB.
  if [ -z "$growth" ] || [ "$growth" -gt 200 ]; then
    echo "$program grows: $printed"
    failures=1
  fi
  reference=${reference:-$sum}
  # Sine and cosine are those of the same library: the same poses, the same results, the same sums
  # but for the order of operations in 2 pi i/2000.
  awk -v one="$sum" -v other="$reference" 'BEGIN { d = one/other - 1; exit !(d < 1e-6 && d > -1e-6) }' || {
    echo "$program: sum $sum instead of $reference"
    failures=1
  }
done
exit "$failures"
