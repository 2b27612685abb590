#!/usr/bin/env bash
# Makes what a release consists of in build/archive, from the last commit: the archive of the sources,
# its SHA-256 sum, and the recipes for Spack and conda that refer to it. The version is that of
# CMakeLists.txt. Usage: scripts/release.sh [URL]
# URL: where the archive will be; without it the recipes take the one made here. With a version that
# CHANGELOG.md does not have, or files that are not committed, nothing is made for a URL.
set -euo pipefail
cd "$(dirname "$0")/.."

version=$(sed -n 's/^project(wrcontact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
folder=build/archive
archive=$folder/wrcontact-$version.tar.gz
url=${1:-file://$PWD/$archive}
if [ $# -gt 0 ]; then
  grep -q "^## \[$version\]" CHANGELOG.md || {
    echo "scripts/release.sh: CHANGELOG.md has no heading [$version]" >&2
    exit 1
  }
  [ -z "$(git status --porcelain)" ] || {
    echo "scripts/release.sh: there are files that are not committed" >&2
    exit 1
  }
fi
rm -rf "$folder"
mkdir -p "$folder/spack" "$folder/conda"
git archive --prefix="wrcontact-$version/" HEAD | gzip -n9 >"$archive"
sum=$(sha256sum "$archive" | cut -d' ' -f1)
echo "$sum  ${archive##*/}" >"$archive.sha256"
for recipe in spack/package.py conda/meta.yaml; do
  sed -e "s|@VERSION@|$version|" -e "s|@SHA256@|$sum|" -e "s|@URL@|$url|" \
    "packaging/$recipe" >"$folder/$recipe"
done
# They parse: as Python, and as YAML once what conda replaces is taken out.
python3 - "$folder" "$version" <<'END'
import ast
import re
import sys
import tomllib
from pathlib import Path

folder, version = Path(sys.argv[1]), sys.argv[2]
ast.parse((folder / "spack/package.py").read_text())
text = re.sub(r"\{\{.*?\}\}", "replaced", (folder / "conda/meta.yaml").read_text())
try:
    import yaml
    recipe = yaml.safe_load(text)
    assert recipe["package"]["version"] == version and recipe["build"]["script"], recipe
except ImportError:
    print("conda/meta.yaml is not looked at: python3-yaml is missing")
assert tomllib.loads(Path("fpm.toml").read_text())["version"] == version, "fpm.toml: version"
END
ls -l "$archive"
