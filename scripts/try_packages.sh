#!/usr/bin/env bash
# Tries what scripts/debian_packages.sh and scripts/python_wheel.sh have made as a new user would: in an empty
# Debian 12 the commands that docs/build.md, python.md and octave.md show under "packages", the tutorials, and the wheel
# without any package of ours, and purges all packages again. Fails unless all print the same pmax to 17 digits, draw a
# picture, do what the tutorials say, and leave nothing behind.
# Needs root, debootstrap and the network: about ten minutes, 2 GB. Usage: scripts/try_packages.sh
set -euo pipefail
cd "$(dirname "$0")/.."

root=$(mktemp -d)
trap 'rm -rf --one-file-system "$root"' EXIT
debootstrap --variant=minbase bookworm "$root" >/dev/null
cp -r --parents build/packages/*.deb build/wheelhouse/*.whl docs/{first-scene,fortran,python}.md tests/readme/run_tutorial.py "$root"
for page in build python octave; do
  awk '/^<!-- packages -->$/ { marked = 1 }
    marked && /^```$/ { if (++fences == 2) exit; next }
    fences == 1' "docs/$page.md" >"$root/$page.sh"
done
cat >"$root/try.sh" <<'END'
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
echo 'APT::Get::Assume-Yes "true"; DPkg::Options:: "--force-unsafe-io";' >/etc/apt/apt.conf.d/try
apt-get update -qq
# The wheel first, while there is no FFTW.
apt-get install --no-install-recommends python3-numpy python3-cffi-backend >/dev/null
if ls /usr/lib/x86_64-linux-gnu/libfftw3* 2>/dev/null; then exit 1; fi
python3 -m zipfile -e /build/wheelhouse/*.whl /wheel
wheel=$(PYTHONPATH=/wheel python3 -B -W ignore -c "import wrcontact; print(wrcontact.solve(lateral=5).left.pmax)")
rm -r /wheel
for page in build python octave; do
  cat "/$page.sh"
  rm -f two_lobes.png
  HOME=/root bash -e "/$page.sh" >"/$page.out" 2>&1 || { tail -n 40 "/$page.out"; exit 1; }
  [ "$(stat -c %s two_lobes.png)" -gt 10000 ] # bytes: not an empty picture
done
pmax=$(grep -m 1 '^    "pmax"' /build.out | grep -oE '[0-9.]+')
[ "$wheel" = "$pmax" ] || { echo "the wheel prints $wheel instead of $pmax"; exit 1; }
for page in python octave; do
  awk -v pmax="$pmax" '$1 == pmax { found = 1 } END { exit !found }' "/$page.out" || {
    echo "$page does not print $pmax"
    tail -n 5 "/$page.out"
    exit 1
  }
done
apt-get install --no-install-recommends /build/packages/*.deb gfortran python3-matplotlib python3-xarray >/dev/null
for tutorial in /docs/{first-scene,fortran,python}.md; do
  (cd / && python3 /tests/readme/run_tutorial.py "$tutorial" /usr /try /usr/lib/python3/dist-packages)
done
rm -r /try
packages=$(dpkg-query -W -f '${Package}\n' | grep wrcontact)
files=$(dpkg -L $packages | grep -vx "/." | sort -u)
apt-get purge $packages >/dev/null
left=$(for file in $files; do [ ! -e "$file" ] || dpkg -S "$file" >/dev/null 2>&1 || echo "$file"; done
  find / -xdev \( -iname '*wrcontact*' -o -name 'wrc_*' \) ! -path '/build/*')
[ -z "$left" ] || { echo "left behind: $left"; exit 1; }
echo "pmax = $pmax MPa from C, Python, Octave and the wheel, pictures drawn, tutorials done, nothing left behind of" $packages
END
unshare --mount --pid --fork --kill-child bash -c \
  "mount -t proc proc $root/proc && mount --rbind /dev $root/dev && exec chroot $root bash /try.sh"
