#!/usr/bin/env bash
# Installs what is missing on a Debian machine, builds and tests. Usage: scripts/test.sh [--all]
# Without argument the release build and its tests; with --all what CI runs: layers, text,
# constants, sizes, static analysis, address sanitizer (by clang), thread sanitizer, release with
# Octave, the reference by Doxygen, a cross build for Windows, a release in a dry run, the outputs that pages show, instruction sets.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh

all=no
case "$#:${1:-}" in
  0:) ;;
  1:--all) all=yes ;;
  *)
    echo "scripts/test.sh $*: allowed is --all or nothing" >&2
    exit 2
    ;;
esac

octave=OFF
skipped=()
# build_and_test PRESET [PROGRAM]: one program of tests, whose label is its name, or everything.
build_and_test() {
  local preset=$1 target=${2:-all} start=$SECONDS built
  local folder=build/$preset select=()
  [ "$target" = all ] || select=(-L "^$target\$")
  echo "== $preset: build"
  mkdir -p "$folder"
  cmake --preset "$preset" -DWRCONTACT_WARNINGS_AS_ERRORS=ON "-DWRCONTACT_BUILD_OCTAVE=$octave" \
    >"$folder/configure.log" 2>&1 || {
    tail -n 40 "$folder/configure.log"
    exit 1
  }
  cmake --build --preset "$preset" --target "$target" >"$folder/build.log" 2>&1 || {
    grep -E -A5 'error|FAILED' "$folder/build.log" | head -n 60
    exit 1
  }
  built=$SECONDS
  echo "== $preset: tests"
  ctest --preset "$preset" -j "$(nproc)" "${select[@]}" >"$folder/test.log" 2>&1 || {
    grep -vE '^ *Start|Passed' "$folder/test.log" | tail -n 100
    exit 1
  }
  tail -n 3 "$folder/test.log"
  skipped+=("$preset: $(scripts/skipped_tests.sh "$folder/Testing/Temporary/LastTest.log")")
  echo "== $preset: $((built - start)) s to build, $((SECONDS - built)) s to test"
}

scripts/install_packages.sh "${build_packages[@]}"
if [ "$all" = yes ]; then
  scripts/install_packages.sh "${check_packages[@]}"
  echo "== layers"
  scripts/check_layers.sh
  scripts/check_tested.sh
  echo "== text"
  scripts/check_text.sh
  scripts/list_constants.sh >/dev/null
  scripts/check_sizes.sh >/dev/null
  echo "== static analysis"
  scripts/check_static.sh
  build_and_test asan
  build_and_test tsan threads_test
  octave=ON
fi
build_and_test release
if [ "$all" = yes ]; then
  echo "== reference of the interfaces"
  cmake --build --preset release --target reference >build/release/reference.log 2>&1 || {
    grep -iE 'warning|error' build/release/reference.log | head -n 40
    exit 1
  }
  # Doxygen leaves out what it takes for private, without a warning.
  for page in c/html/classwrcontact_1_1Scene c/html/structwrc__patch c/html/wrcontact_8h \
    fortran/html/structwrcontact_1_1contact__scene fortran/html/wrcontact__f77_8f90 \
    python/wrcontact index; do
    [ -f "build/release/reference/$page.html" ]
  done
  echo "== Windows: compiled by cross compilers"
  scripts/check_windows.sh
  echo "== release: packages, wheel"
  scripts/release.sh "$(sed -n 's/^project(wrcontact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)" --dry-run
  echo "== outputs shown in the docs"
  scripts/check_outputs.py
  echo "== instruction sets"
  scripts/check_instruction_sets.sh
fi
echo "== skipped tests"
printf '%s\n' "${skipped[@]}"
