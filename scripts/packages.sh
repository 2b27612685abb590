# shellcheck shell=bash disable=SC2034
# The Debian packages the project needs, by purpose; sourced by the other scripts.
build_packages=(
  cmake ninja-build pkg-config g++ gfortran
  libfftw3-dev liblapack-dev
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libgtest-dev
  gnuplot-nox fonts-dejavu-core
  libnetcdf-dev libssl-dev libopenmpi-dev openmpi-bin
  python3-numpy python3-scipy python3-cffi python3-pycparser
  python3-xarray python3-matplotlib python3-pytest python3-pip python3-setuptools python3-wheel python3-venv
)
# Beyond that, for what CI checks.
check_packages=(
  git clang libclang-rt-dev clang-format clang-tidy binutils abigail-tools
  shellcheck codespell python3 mypy
)
# Beyond that, for scripts/test.sh --release; scripts that need more install it.
release_packages=(
  qemu-user doxygen octave octave-dev fonts-freefont-otf flang-19 calculix-ccx chromium
)
# For scripts/site.sh alone: the pages as a site, and a browser in which its search is tried.
site_packages=(
  cmake ninja-build pkg-config g++ gfortran libfftw3-dev liblapack-dev
  doxygen python3-sphinx python3-myst-parser furo chromium
)
windows_packages=(g++-mingw-w64-x86-64-posix gfortran-mingw-w64-x86-64-posix)
packaging_packages=(
  debhelper dh-python chrpath lintian git octave octave-dev patchelf
)
