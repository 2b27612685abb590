#!/usr/bin/env bash
# scripts/skipped_tests.sh counts skipped tests by their reason. Usage: skipped_tests.sh PROJECT
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat >"$work/one.log" <<'END'
[ RUN      ] Wheels.AreRead
/project/tests/wheels_test.cpp:62: Skipped
no wheel here

[  SKIPPED ] Wheels.AreRead (0 ms)
[  SKIPPED ] Wheels.AreRead
[ RUN      ] Wheels.AreRound
/project/tests/wheels_test.cpp:70: Skipped

[  SKIPPED ] Wheels.AreRound (0 ms)
[       OK ] Rails.AreRead (0 ms)
END
cat >"$work/two.log" <<'END'
.s.s                                                                     [100%]
SKIPPED [2] test_pictures.py:66: could not import 'matplotlib'
2 passed, 2 skipped in 0.10s
Skipped: no browser here
Skipped: no browser here: a.png is not compared
12 of 13 pictures are as committed
/project/tests/rails_test.cpp:9: Skipped
no wheel here
END
cat >"$work/expected" <<'END'
7 tests skipped
  2: could not import 'matplotlib'
  2: no wheel here
  1: no browser here
  1: no browser here: a.png is not compared
  1: no reason given
END
"$1/scripts/skipped_tests.sh" "$work/one.log" "$work/two.log" >"$work/found"
diff "$work/expected" "$work/found"
echo "0 tests skipped" >"$work/expected"
"$1/scripts/skipped_tests.sh" /dev/null >"$work/found"
diff "$work/expected" "$work/found"
