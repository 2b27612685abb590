#!/usr/bin/env bash
# Installs what is missing on a Debian machine, builds and tests. Usage: scripts/test.sh [--all|--release]
#   (nothing)  release build of library and programs, and all tests but those with the label "long"
#   --all      what CI runs: that; layers, text, static analysis; a small run under the address sanitizer;
#              the tests with threads under the thread sanitizer
#   --release  everything: --all with all tests, the evidence programs, Octave, a browser, the numerics
#              under the address sanitizer, reference pages, the site, a cross build for Windows, packages, the
#              outputs that pages show, emulated instruction sets
# Each step prints its wall time and the processor time of all its processes. tests/README.md says what is
# checked in which run.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh

mode=fast
case "$#:${1:-}" in
  0:) ;;
  1:--all) mode=all ;;
  1:--release) mode=release ;;
  *)
    echo "scripts/test.sh $*: the argument must be --all, --release or nothing" >&2
    exit 2
    ;;
esac

costs=()
skipped=()
times_file=$(mktemp)
trap 'rm -f "$times_file"' EXIT
# read_cpu: sets `cpu` to the user and system time of all processes that have ended, in seconds.
read_cpu() {
  times >"$times_file" # not in a subshell, which has times of its own
  cpu=$(awk 'NR == 2 {
    for (i = 1; i <= 2; i++) { split($i, part, /[ms]/); sum += 60 * part[1] + part[2] }
    print int(sum) }' "$times_file")
}
# step NAME COMMAND...: runs it and prints what it cost.
step() {
  local name=$1 start=$SECONDS before cpu
  read_cpu
  before=$cpu
  shift
  echo "== $name"
  "$@"
  read_cpu
  costs+=("$name: $((SECONDS - start)) s, $((cpu - before)) CPU s")
  echo "== ${costs[-1]}"
}

# logged LOG PATTERN COMMAND...: its output goes into LOG; if it fails, lines of PATTERN are shown, or the
# last ones where none has it.
logged() {
  local log=$1 pattern=$2
  shift 2
  mkdir -p "$(dirname "$log")"
  "$@" >"$log" 2>&1 || {
    { grep -E -A5 "$pattern" "$log" || cat "$log"; } | tail -n 100
    echo "failed: $*; all of its output is in $log"
    exit 1
  }
}
# build PRESET OPTIONS TARGET...
build() {
  local preset=$1 options=$2 folder=build/$1
  shift 2
  # shellcheck disable=SC2086 # several options
  logged "$folder/configure.log" . cmake --preset "$preset" -DWRCONTACT_WARNINGS_AS_ERRORS=ON $options
  logged "$folder/build.log" 'error|FAILED' cmake --build --preset "$preset" --target "$@"
}
# run_tests PRESET OPTIONS...: options of ctest choose the tests.
run_tests() {
  local preset=$1 folder=build/$1
  shift
  ctest --preset "$preset" --no-tests=error -j "$(nproc)" "$@" >"$folder/test.log" 2>&1 || {
    { grep -vE '^ *Start|Passed' "$folder/test.log" || true; } | tail -n 100
    echo "failed: all of the output is in $folder/test.log"
    exit 1
  }
  grep -E 'tests passed|^Total Test time' "$folder/test.log"
  skipped+=("$preset: $(scripts/skipped_tests.sh "$folder/Testing/Temporary/LastTest.log")")
}

reference() {
  logged build/release/reference.log '[Ww]arning|[Ee]rror' cmake --build --preset release --target reference
  # Doxygen leaves out what it takes for private, without a warning.
  local page
  for page in c/html/classwrcontact_1_1Scene c/html/structwrc__patch c/html/wrcontact_8h \
    fortran/html/structwrcontact_1_1contact__scene fortran/html/wrcontact__f77_8f90 \
    python/wrcontact index; do
    [ -f "build/release/reference/$page.html" ]
  done
}

step "packages to build" scripts/install_packages.sh "${build_packages[@]}"
[ "$mode" = fast ] || step "packages to check" scripts/install_packages.sh "${check_packages[@]}"
[ "$mode" != release ] || step "packages for a release" scripts/install_packages.sh "${release_packages[@]}"

if [ "$mode" != fast ]; then
  step "layers" scripts/check_layers.sh
  step "a test for each header" scripts/check_tested.sh
  step "text" scripts/check_text.sh
  step "constants" logged build/constants.log . scripts/list_constants.sh
  step "sizes" logged build/sizes.log . scripts/check_sizes.sh
  step "static analysis" scripts/check_static.sh
fi
if [ "$mode" = release ]; then
  step "release: build" build release -DWRCONTACT_BUILD_OCTAVE=ON all evidence
  step "release: all tests" run_tests release
else
  step "release: build" build release "" all
  step "release: tests" run_tests release -LE '^long$'
fi
case $mode in
  all)
    step "address sanitizer: build" build asan "" sanitized
    step "address sanitizer: a case of each room" run_tests asan -L '^sanitized$'
    ;;
  release)
    step "address sanitizer: build" build asan "" all
    step "address sanitizer: all tests" run_tests asan
    ;;
esac
if [ "$mode" != fast ]; then
  step "thread sanitizer: build" build tsan "" threads_test
  step "thread sanitizer: tests with threads" run_tests tsan -L '^threads_test$'
fi
if [ "$mode" = release ]; then
  step "reference of the interfaces" reference
  step "site of the pages" logged build/site.log . scripts/site.sh
  step "Windows: compiled by cross compilers" scripts/check_windows.sh
  step "packages, wheel" \
    scripts/release.sh "$(sed -n 's/^project(wrcontact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)" --dry-run
  step "outputs shown in the docs" scripts/check_outputs.py
  step "instruction sets" scripts/check_instruction_sets.sh
fi
echo "== skipped tests"
printf '%s\n' "${skipped[@]}"
echo "== cost of each step"
printf '%s\n' "${costs[@]}"
read_cpu
echo "all: $SECONDS s, $cpu CPU s"
