#!/usr/bin/env bash
# Dependencies point one way: fortran_bindings, octave_bindings -> c_api -> cxx_core; drivers see only
# the public interface; in the core the folders follow the way of the data. Files within a folder have
# an order as well: no header, with the source of its name, includes one that needs it in turn. Read
# from the include lines.
set -euo pipefail
cd "$(dirname "$0")/.."

failures=0

# check FOLDER ALLOWED: every quoted include in FOLDER starts with one of the ALLOWED prefixes.
check() {
  local folder=$1 allowed=$2 bad
  # shellcheck disable=SC2086 # what to leave out is a second word
  bad=$(git ls-files $folder | grep -E '\.(c|h|cpp|hpp)$' |
    xargs -r grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]+"' |
    grep -vE "\"($allowed)" || true)
  if [ -n "$bad" ]; then
    echo "$folder may only include $allowed:"
    echo "$bad"
    failures=1
  fi
}

# room NAME ROOMS_BELOW...: a room of the core includes itself and these, each of them somewhere.
room() {
  local name=$1 below
  shift
  check "cxx_core/$name" "$(printf '%s/|' "$@")$name/"
  for below; do
    if ! grep -q "^#include \"$below/" "cxx_core/$name"/*.?pp; then
      echo "cxx_core/$name may include $below/, but does not: take it from the list, and from docs/architecture.md"
      failures=1
    fi
  done
}
room base
room profile base
room measured base profile
room half_space base
room pressure base
room damage base half_space
room geometry base profile
room patches base geometry
room remesh base geometry patches
room mechanics base half_space pressure
room rolling base half_space mechanics
room models base geometry patches
room accuracy base patches remesh mechanics pressure
room records base half_space damage geometry patches remesh mechanics rolling accuracy
room results base half_space pressure damage geometry remesh mechanics models accuracy records
room creep base half_space pressure damage geometry patches remesh mechanics rolling accuracy records
room wheel base geometry patches remesh mechanics models accuracy records
room derivatives base half_space geometry patches remesh mechanics records creep
room keys base profile measured half_space geometry mechanics rolling records
room scene base profile measured pressure geometry records results creep wheel derivatives keys
room table base geometry rolling records results keys scene
check c_api 'base/|profile/|measured/|half_space/|pressure/|mechanics/|rolling/|results/|keys/|scene/|table/|(batch|handles|handle_table|grid_contact|floating_point)\.hpp|wrcontact(_grid|_table)?\.h'
check octave_bindings 'wrc_mex\.h'
# Evidence about the core sees the core, and draws its cases as the tests of the core do.
check drivers/evidence/core 'arguments\.hpp|base/|profile/|measured/|damage/|mechanics/|rolling/|results/|derivatives/|keys/|scene/|core/|reports/conicity\.hpp|support/(conformal_disc|energy_pairs|no_slip_samples|patch_problem|random_wheels|state_differences|toml)\.hpp'
check 'drivers :!drivers/evidence/core' 'reports/|support/|wrc_[a-z]+/|benchmark_commit\.hpp|wrcontact\.h'
check tests/c_api 'extent\.hpp|call_arguments\.hpp|call_sequences\.hpp|all_results\.hpp|owned_handles\.hpp|failing_allocator\.hpp|host_transform\.hpp|wrcontact\.h'
check tests/fuzz 'base/error\.hpp|measured/(readers|slices)\.hpp|scene/(solve_scene|vehicle_step)\.hpp|table/table_(file|step|text)\.hpp|call_sequences\.hpp|support/|wrcontact\.h'
check tests/properties '(draw|drawn_scene|outcome|rolling_scene|varying_scene|scene_properties|smoothness|steps)\.hpp|support/(parallel|random_scenes)\.hpp|wrcontact\.h'
check tests/instruction_sets 'wrcontact\.h'
check tests/drivers 'extent\.hpp|run_driver\.hpp|reports/conicity\.hpp|support/(csv_table|gnuplot|html|refined_map)\.hpp'

# No circles between files. A header and the source of its name count as one; the two public headers,
# which include each other for old callers, are left out.
mapfile -t sources < <(git ls-files cxx_core c_api octave_bindings drivers | grep -E '\.(c|h|cpp|hpp)$' |
  grep -vE '^c_api/(include|abi)/')
arrows=$(awk '
  BEGIN { for (i = 1; i < ARGC; i++) { known[ARGV[i]] = 1 } }
  /^[[:space:]]*#[[:space:]]*include[[:space:]]+"/ {
    split($0, quoted, "\"")
    folder = FILENAME
    sub(/[^\/]*$/, "", folder)
    count = split("cxx_core/ c_api/ octave_bindings/ drivers/ drivers/evidence/ " folder, roots, " ")
    for (i = 1; i <= count; i++) {
      to = roots[i] quoted[2]
      if (to in known) {
        from = FILENAME
        sub(/\.[a-z]+$/, "", from)
        sub(/\.[a-z]+$/, "", to)
        if (from != to) { print from, to }
        break
      }
    }
  }' "${sources[@]}" | sort -u)
circles=$(tsort <<<"$arrows" 2>&1 >/dev/null || true)
if [ -n "$circles" ]; then
  echo "files that include each other in a circle:"
  sed -n 's/^tsort: \(-: \)\?//p' <<<"$circles"
  failures=1
fi

# One file of the library sees FFTW. Beside it one of the tests, which plays a host program, and the
# benchmark's yardstick: what solutions are compared with is not to be measured by the library itself.
fftw=$(git ls-files '*.cpp' '*.hpp' '*.h' '*.c' | xargs grep -lE 'include[[:space:]]*<fftw3' |
  grep -vxE 'tests/c_api/(host_transform.cpp|fftw_threads_host.c)|drivers/wrc_benchmark/transform.cpp' || true)
if [ "$fftw" != cxx_core/half_space/fft.cpp ]; then
  echo "only cxx_core/half_space/fft.cpp may include fftw3.h, but there is: $fftw"
  failures=1
fi

# One file of the programs sees CLI11, which takes seconds to compile.
options=$(git ls-files '*.cpp' '*.hpp' | xargs grep -lE 'include[[:space:]]*<CLI/' || true)
if [ "$options" != drivers/support/program.cpp ]; then
  echo "only drivers/support/program.cpp may include CLI11, but there is: $options"
  failures=1
fi

# The core does not know what is above it.
above=$(git ls-files cxx_core | xargs grep -nE 'wrcontact\.h|c_api|WRC_[A-Z]|wrc_[a-z]+\(' |
  grep -v 'WRC_VECTOR_' || true)
if [ -n "$above" ]; then
  echo "the core names the C interface:"
  echo "$above"
  failures=1
fi

# Above geometry nobody asks whether a body varies: surfaces answer by what they are asked for, and
# is_prismatic_along(direction) where a shortcut depends on it. What a scene permits is asked of the scene
# in keys/scene.hpp, before there are surfaces, by the files below (docs/architecture.md).
scene_askers='keys/scene\.[ch]pp|scene/(surface_cache|vehicle_step)\.cpp|table/table_nodes\.cpp'
asked='\b([a-z_]*(varying|varies|vary)|(is|are|has|have)_(prismatic|round|sliced)(_(?!along\b)[a-z]+)*)\(|\bslices_\b'
varying=$(git ls-files cxx_core c_api | grep -E '\.(c|h|cpp|hpp)$' | grep -v '^cxx_core/geometry/' |
  xargs grep -nP "$asked" |
  grep -vE "^cxx_core/($scene_askers):.*\b(is_sliced|has_prismatic_rails|has_round_wheels|is_prismatic)\(" || true)
if [ -n "$varying" ]; then
  echo "above cxx_core/geometry only is_prismatic_along(direction) may be asked; see docs/architecture.md:"
  echo "$varying"
  failures=1
fi

# Fortran reaches the library through its own module's C bindings only; programs in Fortran use the
# module or the F77 layer as their users do, beside modules of their own.
own=$(git ls-files drivers/fortran | xargs -r grep -hoiE '^module [a-z_]+$' | cut -d' ' -f2 | tr '\n' '|')
fortran=$(git ls-files fortran_bindings drivers/fortran | xargs -r grep -niE '^[[:space:]]*use[ ,]' |
  grep -viE "iso_c_binding|iso_fortran_env|${own}wrcontact" || true)
if [ -n "$fortran" ]; then
  echo "Fortran uses more than the C interface and its module:"
  echo "$fortran"
  failures=1
fi
bindings=$(git ls-files drivers/fortran | xargs -r grep -niE 'bind\(c' || true)
if [ -n "$bindings" ]; then
  echo "drivers in Fortran bind C functions themselves:"
  echo "$bindings"
  failures=1
fi

# Python reaches the library through the declarations of the headers only, which one module opens.
python=$(git ls-files 'python_bindings/wrcontact/*.py' | grep -v '/_library\.py$' |
  xargs -r grep -nE 'dlopen|ctypes|subprocess|cdef\(' || true)
if [ -n "$python" ]; then
  echo "only python_bindings/wrcontact/_library.py may open a library:"
  echo "$python"
  failures=1
fi
exit "$failures"
