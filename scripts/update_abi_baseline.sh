#!/usr/bin/env bash
# Takes the interface as it is now as the one that later libraries must keep: its symbols, its types
# and its headers, in c_api/abi. To be run when a version is released, or when a function has been
# added; a change of an old one is a new major version, before 1.0 a new minor one. Needs the release build.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh
scripts/install_packages.sh "${check_packages[@]}"

library=build/release/lib/libwrcontact.so
nm -D --defined-only "$library" | awk '{print $3}' | LC_ALL=C sort >c_api/abi/symbols.txt
abidw --exported-interfaces-only --headers-dir c_api/include --drop-private-types \
  --no-comp-dir-path --no-corpus-path --no-show-locs --no-elf-needed "$library" |
  sed "s#path='[^']*/c_api/#path='c_api/#" >c_api/abi/types.abi
cp c_api/include/wrcontact.h c_api/include/wrcontact_grid.h c_api/abi
git diff --stat -- c_api/abi
