#!/usr/bin/env bash
# Makes what a release consists of, in build/release-VERSION, from the last commit:
#   wrcontact-VERSION.tar.gz        the sources
#   *.deb                           Debian packages (scripts/debian_packages.sh)
#   wrcontact-VERSION-*.whl         a Python wheel (scripts/python_wheel.sh)
#   spack/package.py, conda/meta.yaml   recipes that refer to the sources
#   NOTES.md                        what CHANGELOG.md says about this version
#   SHA256SUMS                      sums of all files
# and then makes the tag vVERSION, to be pushed by hand.
# Usage: scripts/release.sh VERSION [--dry-run] [--url URL]
# URL: where the archive of the sources will be; without it the recipes take the one made here. A dry run makes no tag,
# and does not mind files that are not committed or a version that CHANGELOG.md does not have yet.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  echo "scripts/release.sh: $1; usage: scripts/release.sh VERSION [--dry-run] [--url URL]" >&2
  exit 2
}
version='' dry=no url=''
while [ $# -gt 0 ]; do
  case $1 in
    --dry-run) dry=yes ;;
    --url) url=${2:?a URL} && shift ;;
    -*) usage "unknown option $1" ;;
    *) version=$1 ;;
  esac
  shift
done
[ -n "$version" ] || usage "a version is required"
built=$(sed -n 's/^project(wrcontact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ "$version" = "$built" ] || usage "the sources are version $built (scripts/set_version.sh $version changes that)"
heading="[$version]"
if ! grep -qF "## $heading" CHANGELOG.md; then
  [ "$dry" = yes ] || usage "CHANGELOG.md has no heading [$version]"
  heading="[Unreleased]"
fi
if [ "$dry" = no ]; then
  [ -z "$(git status --porcelain)" ] || usage "there are files that are not committed"
  ! git rev-parse -q --verify "refs/tags/v$version" >/dev/null || usage "the tag v$version is there already"
fi

folder=$PWD/build/release-$version
archive=$folder/wrcontact-$version.tar.gz
rm -rf "$folder"
mkdir -p "$folder/spack" "$folder/conda"
git archive --prefix="wrcontact-$version/" HEAD | gzip -n9 >"$archive"
sum=$(sha256sum "$archive" | cut -d' ' -f1)
# shellcheck disable=SC2001 # an ampersand in a replacement of bash means the match, too
address=$(sed 's/[&|\\]/\\&/g' <<<"${url:-file://$archive}")
for recipe in spack/package.py conda/meta.yaml; do
  sed -e "s|@VERSION@|$version|" -e "s|@SHA256@|$sum|" -e "s|@URL@|$address|" \
    "packaging/$recipe" >"$folder/$recipe"
done
awk -v heading="## $heading" '/^## / { inside = 0 } inside { print } index($0, heading) == 1 { inside = 1 }' CHANGELOG.md |
  sed '/./,$!d' >"$folder/NOTES.md"
[ -s "$folder/NOTES.md" ] || usage "CHANGELOG.md says nothing about $version"

# Recipes parse: as Python, and as YAML once what conda replaces is taken out.
/usr/bin/python3 - "$folder" "$version" <<'PYTHON'
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
PYTHON

echo "== Debian packages"
scripts/debian_packages.sh
cp build/packages/*.deb "$folder"
echo "== Python wheel"
scripts/python_wheel.sh
cp build/wheelhouse/*.whl "$folder"

sums=$(cd "$folder" && find . -type f -printf '%P\n' | sort | xargs sha256sum)
echo "$sums" >"$folder/SHA256SUMS"
if [ "$dry" = no ]; then
  git tag -a --cleanup=whitespace "v$version" -m "wrcontact $version" -m "$(cat "$folder/NOTES.md")"
  echo "== tag v$version is made; git push origin v$version publishes it"
fi
ls -sh "$folder"
