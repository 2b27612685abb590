# shellcheck shell=bash disable=SC2034
# The Debian packages the project needs, by purpose; sourced by the other scripts.
build_packages=(
  cmake ninja-build pkg-config g++ gfortran
  libfftw3-dev liblapack-dev
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libgtest-dev
  gnuplot-nox fonts-dejavu-core
  libnetcdf-dev libssl-dev libopenmpi-dev openmpi-bin
)
check_packages=(
  git clang libclang-rt-dev clang-format clang-tidy binutils qemu-user abigail-tools
  shellcheck codespell doxygen python3
  octave octave-dev fonts-freefont-otf
)
packaging_packages=(
  debhelper dh-python chrpath lintian git octave-dev
)
