#!/usr/bin/env bash
# Static analysis of the library by clang-tidy; the checks are those of .clang-tidy.
# Usage: scripts/check_static.sh [FILE...]
# Without a file the whole library, a room at a time: its sources are analysed as one text, since
# the headers that they share take more time than what they say. An #include of each would not do:
# the analyser follows the paths of functions in the main file only. So a name in an unnamed namespace
# stands once in a room. What has not changed since it was found to be in order is not analysed again.
set -euo pipefail
cd "$(dirname "$0")/.."

compiler_options=(-std=c++20 -fopenmp-simd -Icxx_core -Ic_api -Ic_api/include
  "-DWRC_VERSION_TEXT=\"0\"")
folder=build/static_analysis
mkdir -p "$folder"

# analyse NAME FILE...: the files as one text, findings with the file and line they are in.
analyse() {
  local unit=$folder/$1.cpp
  shift
  cat "$@" >"$unit"
  local kept state
  kept=${unit%.cpp}.in_order
  state=$({
    cat .clang-tidy scripts/check_static.sh
    clang++ "${compiler_options[@]}" -E -CC "$unit"
  } | sha1sum)
  [ "$state" != "$(cat "$kept" 2>/dev/null)" ] || return 0
  if clang-tidy --quiet "$unit" -- "${compiler_options[@]}" >"${unit%.cpp}.log" 2>&1; then
    echo "$state" >"$kept"
    return 0
  fi
  awk -v unit="${unit##*/}" '
    FILENAME != ARGV[ARGC - 1] { file[++lines] = FILENAME; line[lines] = FNR; next }
    /^[0-9]+ warnings?( and [0-9]+ errors?)? generated/ { next }
    match($0, "^[^ ]*" unit ":[0-9]+") {
      at = substr($0, 1, RLENGTH)
      sub(/.*:/, "", at)
      $0 = file[at] ":" line[at] substr($0, RLENGTH + 1)
    }
    { print }' "$@" "${unit%.cpp}.log"
  return 1
}

# Several at once, those that take longest first.
case "${1:-}" in
  --unit)
    shift
    analyse "$@"
    ;;
  "")
    for room in $(wc -l cxx_core/*/*.cpp c_api/*.cpp | sed -n 's|^ *\([0-9]*\) \(.*\)/[^/]*$|\1 \2|p' |
      awk '{ lines[$2] += $1 } END { for (room in lines) print lines[room], room }' |
      sort -rn | cut -d' ' -f2); do
      # Loops that are specialised stand before their use. What replaces POSIX would define it again.
      echo "--unit ${room//\//_}" "$(printf '%s\n' "$room"/*.cpp | grep -v '_windows.cpp$' |
        awk '{ print !/_loops.cpp$/, $0 }' | sort | cut -d' ' -f2 | paste -sd ' ')"
    done | xargs -P "$(nproc)" -L 1 scripts/check_static.sh
    ;;
  *)
    for file; do
      echo "--unit $(tr / _ <<<"${file%.*}") $file"
    done | xargs -P "$(nproc)" -L 1 scripts/check_static.sh
    ;;
esac
