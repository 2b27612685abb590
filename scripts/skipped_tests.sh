#!/usr/bin/env bash
# Says how many tests of a run were skipped and why, one line for each reason, from the logs that ctest
# writes. Usage: scripts/skipped_tests.sh build/release/Testing/Temporary/LastTest.log ...
set -euo pipefail

# GoogleTest prints the reason in the line after "FILE:LINE: Skipped", also where one ctest runs all
# tests of a program; pytest prints "SKIPPED [COUNT] FILE:LINE: REASON"; our own tests "Skipped: REASON",
# also those that compare the rest.
awk '
  function skip(number, reason) {
    sub(/\r$/, "", reason)
    count[reason == "" ? "no reason given" : reason] += number
    total += number
  }
  reason_follows { reason_follows = 0; skip(1, $0); next }
  /^[^ ]+:[0-9]+: Skipped\r?$/ { reason_follows = 1; next }
  /^SKIPPED \[[0-9]+\] / {
    number = substr($2, 2) + 0
    sub(/^SKIPPED \[[0-9]+\] ([^ ]+:[0-9]+: )?/, "")
    skip(number, $0)
  }
  sub(/^Skipped: /, "") { skip(1, $0) }
  END {
    printf "%d %s skipped\n", total, total == 1 ? "test" : "tests"
    for (reason in count)
      printf "  %d: %s\n", count[reason], reason | "sort -k 1,1nr -k 2"
  }' "$@"
