#!/usr/bin/env bash
# Compares the interface of the library in build/release with that of an earlier version, which is
# built from its tag: fails if a program linked with it would not run with the library of now.
# c_api/abi holds the interface that every build is compared with (tests/abi); this compares with what
# was released. Usage: scripts/check_abi.sh TAG
set -euo pipefail
cd "$(dirname "$0")/.."
tag=${1:?usage: scripts/check_abi.sh TAG}
source scripts/packages.sh
scripts/install_packages.sh "${build_packages[@]}" abigail-tools

folder=build/abi
rm -rf "$folder"
mkdir -p "$folder"
git archive "$tag" | tar -x -C "$folder"
cmake -S "$folder" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DWRCONTACT_BUILD_TESTS=OFF \
  -DWRCONTACT_BUILD_DRIVERS=OFF -DWRCONTACT_BUILD_FORTRAN=OFF -DWRCONTACT_BUILD_PYTHON=OFF \
  -DWRCONTACT_WARNINGS_AS_ERRORS=OFF \
  >"$folder/log"
cmake --build "$folder/build" --target wrcontact >>"$folder/log"
# Its status is a sum: 4 for changes, such as members at the end of a structure that says its size,
# which are to be read; 8 for those that break programs.
status=0
abidiff --no-added-syms --headers-dir1 "$folder/c_api/include" --headers-dir2 c_api/include \
  "$folder/build/lib/libwrcontact.so" build/release/lib/libwrcontact.so || status=$?
[ $((status & ~4)) -eq 0 ] || exit "$status"
echo "nothing that $tag had is gone"
