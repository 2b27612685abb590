#!/usr/bin/env bash
# A program of drivers/evidence prints its usage for --help, and refuses an argument that it cannot take
# by one line on stderr that begins with its name, and exit code 2, before it computes anything.
# Usage: usage_and_refusals.sh PROGRAM
set -euo pipefail
program=$1
name=$(basename "$program")
fail() {
  echo "$name: $*"
  exit 1
}

help=$("$program" --help) || fail "--help ends with $?"
[[ $help == "usage: $name "* ]] || fail "--help prints: $help"

refuses() {
  local code=0 error
  error=$(timeout 10 "$program" "$@" 2>&1 >/dev/null) || code=$?
  [ "$code" = 2 ] || fail "$* ends with $code, not 2: $error"
  [ "$(wc -l <<<"$error")" = 1 ] || fail "$* gives no single line: $error"
  [[ $error == "$name: "* ]] || fail "$* does not begin with the name: $error"
}
refuses many
refuses -1
refuses 1e3x
refuses 99999999999
refuses 1 2 3 4 5 6
