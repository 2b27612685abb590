#!/usr/bin/env bash
# Sets up a Debian machine, builds and runs all tests: layers, format, gcc, clang, sanitizers,
# threads, static analysis, instruction sets. With --quick only the layers and the release build.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh

quick=no
case "${1:-}" in
  "") ;;
  --quick) quick=yes ;;
  *)
    echo "scripts/test.sh $1: allowed is --quick or nothing" >&2
    exit 2
    ;;
esac

# build_and_test PRESET [TARGET TESTS]: everything, or one target and the tests named by a pattern.
build_and_test() {
  local start=$SECONDS
  echo "== $1: build"
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" ${2:+--target "$2"} >"build/$1/build.log" 2>&1 || {
    grep -E -A5 'error|FAILED' "build/$1/build.log" | head -n 60
    exit 1
  }
  echo "== $1: tests"
  ctest --preset "$1" -j "$(nproc)" ${3:+-R "$3"} >"build/$1/test.log" 2>&1 || {
    grep -vE '^ *Start|Passed' "build/$1/test.log" | tail -n 100
    exit 1
  }
  tail -n 3 "build/$1/test.log"
  grep 'Skipped' "build/$1/test.log" || true
  echo "== $1: $((SECONDS - start)) s"
}

scripts/install_packages.sh "${build_packages[@]}"
echo "== layers"
scripts/check_layers.sh
if [ "$quick" = no ]; then
  scripts/install_packages.sh "${check_packages[@]}"
  echo "== format"
  git ls-files '*.cpp' '*.hpp' '*.h' '*.c' | xargs clang-format --dry-run --Werror
  build_and_test asan
  build_and_test tsan threads_test "^(Batch|Threads)\\."
  build_and_test clang
  echo "== static analysis"
  git ls-files 'cxx_core/*.cpp' 'c_api/*.cpp' |
    xargs -P "$(nproc)" -n 1 clang-tidy --quiet -p build/clang >build/clang/tidy.log 2>/dev/null || {
    grep -E 'error|warning' build/clang/tidy.log | sort -u | head -n 40
    exit 1
  }
fi
build_and_test release
if [ "$quick" = no ]; then
  echo "== instruction sets"
  scripts/check_instruction_sets.sh
fi
