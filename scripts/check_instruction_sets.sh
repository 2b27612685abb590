#!/usr/bin/env bash
# Results must not depend on the instruction set: solves the same problems on this machine and on
# emulated ones, without AVX and with AVX2 (qemu-user), and compares all results. What is compared,
# and what is allowed: tests/instruction_sets/instruction_sets.cpp. Argument: the build's folder,
# build/release if not given.
set -euo pipefail
cd "$(dirname "$0")/.."

program=${1:-build/release}/bin/instruction_sets
if [ "$(uname -m)" != x86_64 ]; then
  echo "instruction sets: only on x86_64"
  exit 0
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" record "$folder/native"
cpus=(Nehalem Haswell)
emulations=()
for cpu in "${cpus[@]}"; do
  qemu-x86_64 -cpu "$cpu" "$program" record "$folder/$cpu" 2>"$folder/$cpu.messages" &
  emulations+=($!)
done
failures=0
for i in "${!cpus[@]}"; do
  cpu=${cpus[$i]}
  if ! wait "${emulations[$i]}"; then
    echo "emulated $cpu: the program failed"
    grep -v 'TCG doesn.t support' "$folder/$cpu.messages" || true
    failures=1
    continue
  fi
  echo "this machine and an emulated $cpu:"
  "$program" compare "$folder/native" "$folder/$cpu" || {
    echo "results depend on the instruction set"
    failures=1
  }
done
exit "$failures"
