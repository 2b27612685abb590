#!/usr/bin/env bash
# Each header of the core is included by a test of its room, tests/core/ROOM. Left out are headers of
# constants and those below, which hold nothing that could be wrong by itself.
set -euo pipefail
cd "$(dirname "$0")/.."

declarations=(
  accuracy/accuracy_of.hpp # an enumeration
  base/by_motion.hpp       # four members
  base/stopwatch.hpp       # no test is timed
  base/vector_clones.hpp   # macros
  records/creep_choice.hpp # plain values, as all of this room
  records/friction_law.hpp
  records/module.hpp
  records/motion.hpp
  records/rates.hpp
  records/slip_geometry.hpp
  records/wheel_solution.hpp
)
failures=0
included=$(git ls-files -co --exclude-standard 'tests/core/*.cpp' 'tests/core/*.hpp' |
  grep -v '^tests/core/evidence/' | xargs grep -hoE '^#include "[a-z_/]+\.hpp"' | cut -d'"' -f2 | sort -u)
while read -r header; do
  name=${header#cxx_core/}
  if [ "${name##*/}" = constants.hpp ] || [[ " ${declarations[*]} " == *" $name "* ]]; then
    continue
  fi
  if ! grep -qx "$name" <<<"$included"; then
    echo "$header: included by no test in tests/core; add tests/core/${name%.hpp}_test.cpp"
    failures=1
  fi
done < <(git ls-files 'cxx_core/*.hpp')
exit "$failures"
