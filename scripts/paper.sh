#!/usr/bin/env bash
# Computes the figures of the paper again, and a page that says which of its statements hold:
# build/paper/report.md. Argument: another folder for it.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh
out=${1:-build/paper}

scripts/install_packages.sh "${build_packages[@]}"
echo "== building"
cmake --preset release >/dev/null
cmake --build --preset release --target wrc_sweep wrc_paper wrc_benchmark | tail -n 1

sweep() {
  build/release/bin/wrc_sweep "drivers/studies/$1.toml" --out "$out/$2" --restart \
    --threads "$(nproc)" --quiet --digits 17 "${@:3}"
}

echo "== S1002 on 60E1"
for study in fig05 connections; do
  sweep "$study" S1002
done
sweep conicity S1002 --rails 60E1 UIC60-Manchester --set 'pose.roll=["en15302", "solve"]'
for wheel in LM LMA; do
  echo "== $wheel on CHN60"
  radius=420
  [ "$wheel" = LM ] || radius=430
  for study in fig06_07 fig08 fig09_10 fig11 fig12 fig13; do
    sweep "$study" "$wheel" --set "wheelset.wheel=$wheel" --set "wheelset.radius=$radius"
  done
done
echo "== times"
build/release/bin/wrc_benchmark --case table1 --grid 256x128 --json >"$out/timing.json" 2>/dev/null
echo "== report"
build/release/bin/wrc_paper "$out"
