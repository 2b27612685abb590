#!/usr/bin/env bash
# Builds build/site, the pages of the repository as a site for browsers: with search, pictures, notebooks and the
# reference of the interfaces. Start at build/site/index.html. On Debian 12, as root or with sudo.
# A link, anchor or page that is missing is an error, and so is a search that does not find its page.
# Where `cmake --build --preset release` has made the Python package, cells of notebooks are run and the reference
# has its pages too.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh
scripts/install_packages.sh "${site_packages[@]}"

source=build/site_source
rm -rf "$source" build/site
mkdir -p "$source/extra"
find . \( -path ./build -o -path './.?*' -o -path ./docs \) -prune -o \( -name '*.md' -o -name '*.ipynb' \) -print0 |
  tar -cf - --null -T - --add-file=docs --add-file=LICENSE --add-file=CITATION.cff | tar -xf - -C "$source"

# The reference: of the release build, or of a configuration that compiles nothing.
reference=build/release
package=
if [ -d build/release/python/wrcontact ]; then
  package=$PWD/build/release/python
else
  reference=build/site_reference
  cmake -S . -B "$reference" -DWRCONTACT_BUILD_PYTHON=OFF -DWRCONTACT_BUILD_DRIVERS=OFF -DWRCONTACT_BUILD_TESTS=OFF \
    -DWRCONTACT_BUILD_FORTRAN=OFF >"$source/reference.log"
fi
cmake --build "$reference" --target reference >>"$source/reference.log" || {
  tail -n 20 "$source/reference.log" >&2
  exit 1
}
cp -r "$reference/reference" "$source/extra/reference"

# Where notebooks find it as they do in an installation.
cp tests/reference/profiles/Car7216_0001r.txt "$source/python_bindings/measured_wheel.txt"
notebooks=$(cd "$source" && find . -name '*.ipynb' | sed 's|^\./||; s|\.ipynb$||' | sort)
sed "/^NOTEBOOKS$/{
  r /dev/stdin
  d
}" docs/site/contents.txt <<<"$notebooks" >>"$source/README.md"
{
  printf '# Reference of the interfaces\n\nMade from the sources by Doxygen and pydoc:\n\n'
  for page in 'C and C++=c/html/index' 'Fortran and FORTRAN 77=fortran/html/index' Python=python/wrcontact; do
    [ ! -f "$source/extra/reference/${page#*=}.html" ] || echo "* <a href=\"reference/${page#*=}.html\">${page%=*}</a>"
  done
  printf '\n[All keys](docs/keys.md), [results by name](docs/results.md) and [Fortran: all procedures](docs/fortran-calls.md) are pages.\n'
} >"$source/reference.md"

WRC_PYTHON=$package /usr/bin/python3 -B -m sphinx -q -n -W --keep-going -b html -c "$source/docs/site" \
  -d build/site_source/doctrees "$source" build/site
cp build/site/README.html build/site/index.html
/usr/bin/python3 scripts/check_site.py build/site
echo "== site: build/site/index.html, $(find build/site -name '*.html' | wc -l) pages"
