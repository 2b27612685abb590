#!/usr/bin/env bash
# Makes a Python wheel for Linux on x86-64 from the release build, in build/wheelhouse, and tries it in an empty
# folder. It works with every Python from 3.9 on that has numpy and cffi: the library is inside, and so are FFTW, LAPACK
# and the run-time libraries of Fortran, under names of their own, so that they meet no others of the program. Beside
# them are their licences and Debian's versions of them. Nothing is downloaded, except Debian packages that are missing.
# Usage: scripts/python_wheel.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh
scripts/install_packages.sh "${build_packages[@]}" "${packaging_packages[@]}"
python=/usr/bin/python3 # Debian's, which has what the packages above install

version=$(sed -n 's/^project(wrcontact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
house=$PWD/build/wheelhouse
rm -rf "$house"
mkdir -p "$house"
[ -f build/release/CMakeCache.txt ] || cmake --preset release >"$house/log"
cmake --build build/release --target wrcontact_python wrc_case >>"$house/log"
WRCONTACT_BUILD_FOLDER=build/release "$python" -m pip wheel --quiet --no-index --no-build-isolation --no-deps \
  --wheel-dir "$house/plain" ./python_bindings
(cd "$house" && "$python" -m wheel unpack --dest unpacked plain/wrcontact-*.whl >/dev/null)
tree=$house/unpacked/wrcontact-$version
package=$tree/wrcontact
info=$tree/wrcontact-$version.dist-info
library=$(echo "$package"/libwrcontact.so.*)

# The libraries it needs, except those of the system that every Python needs itself.
mkdir -p "$package/libraries" "$info/licenses"
cp LICENSE "$info/licenses/wrcontact"
cp packaging/debian/copyright "$info/licenses/copyright"
cp /usr/share/common-licenses/{Apache-2.0,GPL-2,GPL-3,LGPL-2.1} "$info/licenses"
declare -A renamed=()
while read -r name _ path _; do
  [[ $path = /* && ! $name =~ ^(libc|libm|libgcc_s|libstdc\+\+|libpthread|libdl)\.so ]] || continue
  renamed[$name]=wrcontact_$name
  cp "$path" "$package/libraries/wrcontact_$name"
  path=$(readlink -f "$path")
  owner=$({ dpkg -S "$path" "${path#/usr}" 2>/dev/null || true; } | cut -d: -f1 | head -n 1)
  dpkg-query -W -f '${source:Package} ${source:Version} of Debian\n' "$owner" >>"$package/libraries/SOURCES"
  cp "/usr/share/doc/$owner/copyright" "$info/licenses/$owner"
done < <(ldd "$library")
sort -u -o "$package/libraries/SOURCES" "$package/libraries/SOURCES"
for file in "$library" "$package"/libraries/*.so.*; do
  folder=\$ORIGIN
  [ "$file" != "$library" ] || folder=\$ORIGIN/libraries
  patchelf --force-rpath --set-rpath "$folder" "$file"
  [ "$file" = "$library" ] || patchelf --set-soname "${file##*/}" "$file"
  for name in "${!renamed[@]}"; do
    patchelf --replace-needed "$name" "${renamed[$name]}" "$file"
  done
done
sed -i 's/^License: MIT$/License: MIT; with FFTW inside, which is GPL-2.0-or-later, the wheel as a whole is GPL/' "$info/METADATA"
examples=$tree/wrcontact-$version.data/data/share/wrcontact/examples
mkdir -p "$examples/python"
cp python_bindings/examples/*.{py,ipynb} "$examples/python"
cp tests/reference/profiles/Car7216_0001r.txt "$examples/measured_wheel.txt"
(cd "$house" && "$python" -m wheel pack --dest-dir . "unpacked/wrcontact-$version" >/dev/null)
wheel=$(ls "$house"/wrcontact-*.whl)
[ "${wheel##*/}" = "wrcontact-$version-py3-none-linux_x86_64.whl" ]
rm -rf "$house/plain" "$house/unpacked"

# In an empty folder, without the library's folders of the system: the same 17 digits, from these libraries alone.
"$python" -m zipfile -e "$wheel" "$house/try"
expected=$(build/release/bin/wrc_case --set pose.lateral=3 --json |
  "$python" -c 'import json, sys; print(repr(json.load(sys.stdin)["left"]["pmax"]))')
(cd "$house/try" && env -i PATH=/usr/bin:/bin PYTHONPATH="$house/try" "$python" -B - "$expected" <<'PYTHON'
import sys

import wrcontact

pmax = wrcontact.solve(lateral=3).left.pmax
with open("/proc/self/maps", encoding="utf-8") as maps:
    loaded = {line.split()[-1] for line in maps if ".so" in line}
ours = sorted(path for path in loaded if "/wrcontact/" in path)
others = sorted(path for path in loaded if ("fftw" in path or "libwrcontact" in path) and path not in ours)
assert repr(pmax) == sys.argv[1], (pmax, sys.argv[1])
assert not others and any("fftw3f" in path for path in ours), (ours, others)
print(f"pmax = {pmax!r} MPa, from {len(ours)} libraries of the wheel")
PYTHON
)
rm -rf "$house/try"
ls -sh "$wheel"
