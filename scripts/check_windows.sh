#!/usr/bin/env bash
# Compiles library, C interface and Fortran module for Windows with Debian's mingw-w64 cross compilers, and archives them
# in build/windows/lib. Nothing is linked or run: Debian has no FFTW for Windows, so only its header is used.
# Needs build/release, whose tables of the built-in profiles are used. Usage: scripts/check_windows.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh
scripts/install_packages.sh "${windows_packages[@]}"

folder=build/windows
table=build/release/profiles/standard_table.cpp
[ -f "$table" ] || cmake --build build/release --target wrcontact_profile_table
mkdir -p "$folder/include"
cp /usr/include/fftw3.h "$folder/include"
{
  cmake -S . -B "$folder" -G Ninja -DCMAKE_TOOLCHAIN_FILE=packaging/mingw-w64.cmake -DCMAKE_BUILD_TYPE=Release \
    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG" \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 "-DFFTW3_INCLUDE_DIR=$PWD/$folder/include" \
    "-DWRCONTACT_PROFILE_TABLE=$PWD/$table" -DWRCONTACT_BUILD_DRIVERS=OFF \
    -DWRCONTACT_BUILD_TESTS=OFF -DWRCONTACT_BUILD_PYTHON=OFF
  cmake --build "$folder" --target wrcontact_static wrcontact_fortran wrcontact_f77 -- -k 0
} >"$folder/log" 2>&1 || {
  grep -E -A5 'error|FAILED|Error' "$folder/log" | head -n 60
  exit 1
}
# What a program has to bring along: FFTW and LAPACK, and nothing of ours.
missing=$(x86_64-w64-mingw32-nm -A --undefined-only "$folder/lib/libwrcontact.a" | awk '{ print $NF }' | sort -u)
defined=$(x86_64-w64-mingw32-nm --defined-only "$folder/lib/libwrcontact.a" | awk '{ print $NF }' | sort -u)
left=$(comm -23 <(echo "$missing") <(echo "$defined") | grep -E '_ZN?K?3wrc|^wrc_' || true)
[ -z "$left" ] || {
  echo "nowhere defined: $left"
  exit 1
}
echo "compiled for Windows: $(grep -c '^wrc_' <<<"$defined") functions of the C interface, the Fortran module, the F77 layer;" \
  "a program brings $(grep -cE '^fftwf?_' <<<"$missing") functions of FFTW, $(grep -cE '^d[a-z]+_$' <<<"$missing") of LAPACK"
