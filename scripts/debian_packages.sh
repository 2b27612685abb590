#!/usr/bin/env bash
# Makes the Debian packages of packaging/debian in build/packages from the release build, which it configures with
# Octave and brings up to date, and looks at them with lintian: an error fails.
# Usage: scripts/debian_packages.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh
scripts/install_packages.sh "${build_packages[@]}" "${packaging_packages[@]}"

folder=build/packages
version=$(sed -n 's/^project(wrcontact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
tree=$PWD/build/release
multiarch=lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
rm -rf "$folder"
mkdir -p "$folder"
{
  cmake --preset release -DWRCONTACT_BUILD_OCTAVE=ON
  cmake --build --preset release
} >"$folder/build.log" 2>&1 || {
  tail -n 40 "$folder/build.log"
  exit 1
}
source=$folder/wrcontact-$version
mkdir -p "$source"
git archive HEAD | tar -x -C "$source"
mv "$source/packaging/debian" "$source/debian"
cat >"$source/debian/changelog" <<END
wrcontact ($version) unstable; urgency=medium

  * Release $version; CHANGELOG.md says what has changed.

 -- The wrcontact developers <wrcontact@wrcontact.invalid>  $(git log -1 --format=%cD)
END
if [ ! -d python_bindings ]; then # the package would be empty
  sed -i '/^Package: python3-wrcontact$/,$d' "$source/debian/control"
fi

# The tree is configured for the folders of Debian, and then again as it was.
libraries=$(sed -n 's/^CMAKE_INSTALL_LIBDIR:[A-Z]*=//p' "$tree/CMakeCache.txt")
prefix=$(sed -n 's/^CMAKE_INSTALL_PREFIX:[A-Z]*=//p' "$tree/CMakeCache.txt")
trap 'cmake -S . -B "$tree" "-DCMAKE_INSTALL_LIBDIR=$libraries" "-DCMAKE_INSTALL_PREFIX=$prefix" \
  -DCMAKE_SKIP_INSTALL_RPATH=OFF >/dev/null' EXIT
cmake -S . -B "$tree" -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_SKIP_INSTALL_RPATH=ON \
  "-DCMAKE_INSTALL_LIBDIR=$multiarch" >/dev/null
(cd "$source" && WRCONTACT_BUILD=$tree DEB_BUILD_OPTIONS=noautodbgsym dpkg-buildpackage -b -us -uc -d) \
  >"$folder/log" 2>&1 || {
  tail -n 40 "$folder/log"
  exit 1
}
rm -rf "$source"
lintian --allow-root --fail-on error --profile debian --tag-display-limit 0 "$folder"/*.changes

# A program of a user against what they hold, unpacked.
for package in "$folder"/*.deb; do
  dpkg-deb -x "$package" "$folder/unpacked"
done
cmake -DWAY=pkg-config -DUNPACKED=ON -DLANGUAGE=c "-DPREFIX=$PWD/$folder/unpacked/usr" -DC_COMPILER=cc \
  "-DLIBDIR=$multiarch" "-DSOURCES=$PWD/tests/consumers/project" "-DFOLDER=$PWD/$folder/consumer" \
  "-DCASE=$tree/bin/wrc_case" -P tests/consumers/run_consumer.cmake
ls -sh "$folder"/*.deb
