#!/usr/bin/env bash
# Runs the fuzzers (docs/fuzzing.md), each from its corpus in tests/fuzz/corpus for some seconds, in
# build/fuzz/<name>, where what they find stays too. Usage: scripts/fuzz.sh SECONDS [NAME ...]; the
# names are those of the folders in tests/fuzz/corpus, profile readers only if none is given.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:?usage: scripts/fuzz.sh SECONDS [NAME ...]}
shift
names=("$@")
if [ ${#names[@]} = 0 ]; then
  names=(columns simpack miniprof)
fi
mkdir -p build/fuzz
cmake --preset clang -B build/fuzz -DWRCONTACT_BUILD_FUZZERS=ON -DWRCONTACT_BUILD_FORTRAN=OFF \
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
  dictionary=()
  if [ -f "tests/fuzz/$name.dict" ]; then dictionary=("-dict=$PWD/tests/fuzz/$name.dict"); fi
  # Files that the calls write go into the folder, too.
  (cd "$folder" && "$program" found "$corpus" "${dictionary[@]}" -max_len=300 -timeout=20 \
    -max_total_time="$seconds" -print_final_stats=1 -detect_leaks=0 -reduce_inputs=0 -shrink=0 \
    >"$log" 2>&1) || {
    tail -n 40 "$log"
    echo "fuzz_$name failed; its input is in $folder" >&2
    exit 1
  }
  echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") executions"
done
