#!/usr/bin/env bash
# Sets the version: in CMakeLists.txt, where everything that is built takes it from, and in the three files that must
# repeat it. Usage: scripts/set_version.sh MAJOR.MINOR.PATCH
set -euo pipefail
cd "$(dirname "$0")/.."
[[ $# = 1 && $1 =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || {
  echo "scripts/set_version.sh $*: a version such as 0.4.0 is required" >&2
  exit 2
}
sed -i "s/^project(wrcontact VERSION [0-9.]*/project(wrcontact VERSION $1/" CMakeLists.txt
sed -i "s/^version: .*/version: $1/" CITATION.cff
sed -i "s/^version = .*/version = \"$1\"/" fpm.toml
sed -i "s/^Version [0-9.]*,/Version $1,/" README.md
