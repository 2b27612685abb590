#!/usr/bin/env bash
# Completion for bash of programs on the path, from what their --help says: options, and the keys of a
# scene behind --set. Usage: bash_completion.sh PROGRAM...
set -euo pipefail
for program; do
  help=$("$program" --help)
  words=$({
    grep -oE '(^|[ ,])--[a-z][a-z-]+' <<<"$help" | tr -d ' ,'
    sed -nE 's/^ +([a-z_]+(\.[a-z_]+)+) .*/\1=/p' <<<"$help"
  } | sort -u | paste -sd ' ')
  echo "complete -o default -o nospace -W '$words' $program"
done
