#!/usr/bin/env bash
# Runs the fuzzers (docs/evidence/limits.md), each from its corpus in tests/fuzz/corpus for some seconds, in
# build/fuzz/<name>, where what they find stays too. Usage: scripts/fuzz.sh SECONDS [NAME ...]; the
# names are those of the folders in tests/fuzz/corpus, profile readers only if none is given.
# With REAL=FOLDER the profile files of a folder (.prr .prw .ban .whl), thinned to some 40 points,
# are in the corpus of the profile readers too, and inputs may be as long as they are.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:?usage: scripts/fuzz.sh SECONDS [NAME ...]}
shift
names=("$@")
if [ ${#names[@]} = 0 ]; then
  names=(columns simpack miniprof)
fi
mkdir -p build/fuzz

# The files of one format, each once as it is and once for strict reading: the first byte says so,
# and whether it is a rail (tests/fuzz/profile_reader.cpp).
thin_real_files() {
  local name=$1 folder=$2 extensions kind byte file
  case $name in
    simpack) extensions='prr prw' ;;
    miniprof) extensions='ban whl' ;;
    columns) extensions='prr prw ban whl' ;;
    *) return 0 ;;
  esac
  mkdir -p "$folder"
  for kind in $extensions; do
    find "$REAL" -iname "*.$kind" -size -1000k | while read -r file; do
      for byte in 0 8; do
        case $kind in prr | ban) byte=$((byte + 16)) ;; esac
        {
          printf '%b' "\\0$(printf %o "$byte")"
          awk -v columns="$([ "$name" = columns ] && echo 1)" '
            { row = $0 ~ /^[ \t]*[-+0-9.][-+0-9.eE]*[ \t,]+[-+0-9.eE]+/ }
            row { rows[++n] = $0; next }
            columns { next }
            n { after = after $0 "\n"; next }
            { print }
            END { step = int(n / 40) + 1; for (i = 1; i <= n; i += step) print rows[i]
                  printf "%s", after }' "$file"
        } >"$folder/$(basename "$file").$byte"
      done
    done
  done
}
cmake --preset clang -B build/fuzz -DCMAKE_UNITY_BUILD=ON -DWRCONTACT_BUILD_FUZZERS=ON -DWRCONTACT_BUILD_FORTRAN=OFF \
  -DWRCONTACT_SANITIZE=address,undefined,fuzzer-no-link >/dev/null
cmake --build build/fuzz --target "${names[@]/#/fuzz_}" >build/fuzz/build.log 2>&1 || {
  grep -E -A5 'error|FAILED' build/fuzz/build.log | head -n 60
  exit 1
}
# Without records of where memory came from and with a short quarantine they run twice as fast.
export ASAN_OPTIONS=malloc_context_size=0:quarantine_size_mb=4
for name in "${names[@]}"; do
  folder=build/fuzz/$name
  mkdir -p "$folder/found"
  log=$PWD/$folder/log
  corpus=$PWD/tests/fuzz/corpus/$name
  program=$PWD/build/fuzz/bin/fuzz_$name
  seeds=()
  longest=300
  if [ -n "${REAL:-}" ]; then
    thin_real_files "$name" "$folder/real"
    if [ -d "$folder/real" ]; then
      seeds=("$PWD/$folder/real")
      longest=$(find "$folder/real" -type f -printf '%s\n' | sort -n | tail -n 1)
    fi
  fi
  dictionary=()
  if [ -f "tests/fuzz/$name.dict" ]; then dictionary=("-dict=$PWD/tests/fuzz/$name.dict"); fi
  # Files that the calls write go into the folder, too.
  (cd "$folder" && "$program" found "$corpus" "${seeds[@]}" "${dictionary[@]}" -max_len="$longest" -timeout=20 \
    -max_total_time="$seconds" -print_final_stats=1 -detect_leaks=0 -reduce_inputs=0 -shrink=0 \
    >"$log" 2>&1) || {
    tail -n 40 "$log"
    echo "fuzz_$name failed; its input is in $folder" >&2
    exit 1
  }
  echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") executions"
done
