#!/usr/bin/env bash
# The largest files of the code, functions and classes of that in C++ and C, and a failure if one is
# too large: 500 lines of a file, 80 of a function, 400 of a class. Tables of constants do not count
# for functions. Reads the code as clang-format writes it: what stands at the left margin ends there.
set -euo pipefail
cd "$(dirname "$0")/.."

declare -A limits=([file]=500 [function]=80 [class]=400)
# Tables: of keys, and of C functions, which programs include as one header, and their interfaces.
tables=(fortran_bindings/wrcontact_c.inc
  c_api/include/wrcontact.h c_api/abi/wrcontact.h)

# KIND LINES FILE:LINE NAME
# shellcheck disable=SC2016
all=$(git ls-files '*.cpp' '*.hpp' '*.h' '*.c' | xargs awk '
  function tell(kind, from, name) {
    sub(/^ +/, "", name)
    print kind, FNR - from + 1, FILENAME ":" from, substr(name, 1, 60)
  }
  FNR == 1 {
    if (NR > 1) { print "file", last, file }
    start = member = 0
    block = ""
    file = FILENAME
  }
  { last = FNR }
  /^ *(namespace|extern "C" \{|#|\/\/|} \/\/)/ { next }
  block == "" && /^($|.*;$)/ { start = 0; next }
  block == "" && !start && /^[^ }]/ { start = FNR; name = $0 }
  block == "" && start == FNR - 1 && name ~ /^template <.*>$/ { name = $0 }
  block == "" && start && /\{$/ {
    if ((name " " $0) ~ /(^|> |^template.* )(class|struct|union) /) { block = "class" }
    else if ($0 ~ /(=|\{) *\{$/ || name ~ /^enum/) { block = "table" }
    else { block = "function" }
    next
  }
  block == "class" && !member && /^  [^ }].*[^;]$/ { member = FNR; member_name = $0 }
  block == "class" && member && /^(  };|  [^ ].*;|   .*; *)$/ && !in_body { member = 0 }
  block == "class" && member && /\{$/ { in_body = 1 }
  block == "class" && /^  }/ {
    if (member && /^  }$/) { tell("function", member, member_name) }
    member = in_body = 0
  }
  block != "" && /^}/ {
    if (block != "table") { tell(block, start, name) }
    start = member = in_body = 0
    block = ""
  }
  END { print "file", last, file }')
all+=$'\n'$(git ls-files '*.f90' '*.f' '*.inc' '*.py' '*.sh' '*.m' | xargs wc -l |
  awk '$2 != "total" { print "file", $1, $2 }')
failures=0
for kind in "${!limits[@]}"; do
  limit=${limits[$kind]}
  echo "largest $kind: at most $limit lines"
  sorted=$(grep "^$kind " <<<"$all" | sort -k2,2nr)
  head -n 5 <<<"$sorted" | cut -d' ' -f2-
  while read -r _ lines place name; do
    [ "$lines" -gt "$limit" ] || break
    if [[ " ${tables[*]} " == *" ${place%%:*} "* ]]; then
      echo "excepted: $place: $kind of $lines lines"
    else
      echo "$place: $kind of $lines lines, at most $limit: $name"
      failures=1
    fi
  done <<<"$sorted"
done
exit "$failures"
