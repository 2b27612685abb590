#!/usr/bin/env bash
# Every pattern of a GoogleTest filter, excluding ones too, matches a test of the program: one of a suite
# that has another name now would leave its tests out without a word.
# Usage: every_pattern_matches.sh PROGRAM PATTERNS, which colons or the minus of a filter separate
set -euo pipefail
set -f # patterns are not names of files
status=0
for pattern in ${2//[:-]/ }; do
  tests=$("$1" --gtest_filter="$pattern" --gtest_list_tests)
  if ! grep -q '^ ' <<<"$tests"; then
    echo "$1: no test matches $pattern"
    status=1
  fi
done
exit "$status"
