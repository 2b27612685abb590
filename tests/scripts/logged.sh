#!/usr/bin/env bash
# `logged` of scripts/test.sh says why a command has failed, and names its log. Usage: logged.sh PROJECT
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
eval "$(sed -n '/^logged() {/,/^}/p' "$1/scripts/test.sh")"

printed=$(logged "$work/log" error echo quiet)
[ -z "$printed" ]
for word in error reason; do # with and without a line that matches
  status=0
  printed=$(logged "$work/log" error sh -c "echo before; echo $word; exit 3" 2>&1) || status=$?
  if [ "$status" -ne 1 ] || [[ "$printed" != *"$word"*"$work/log"* ]]; then
    echo "a command that fails after \"$word\" ends with status $status and prints: $printed"
    exit 1
  fi
done
