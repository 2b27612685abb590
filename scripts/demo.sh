#!/usr/bin/env bash
# Sets up a Debian machine, builds, solves the paper's Table 1 scene and draws it.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh

scripts/install_packages.sh "${build_packages[@]}"
echo "== building"
cmake --preset release >/dev/null
cmake --build --preset release --target wrc_case | tail -n 1

mkdir -p build/demo
picture=build/demo/table1.png
echo "== S1002 on 60E1, 1:40, 80 kN a wheel, displaced by 3 mm to the left"
build/release/bin/wrc_case --set pose.lateral=3 --plot "$picture"
echo "== picture: $picture"
