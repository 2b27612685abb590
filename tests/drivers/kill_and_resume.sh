#!/usr/bin/env bash
# Kills runs of wrc_sweep at any moment, every second one while NetCDF is written, and resumes each at
# once: that must succeed, give the files of a run that was not killed, and leave no others.
# Usage: kill_and_resume.sh WRC_SWEEP COUNT [SEED]
set -euo pipefail

sweep=$(realpath "$1")
count=$2
RANDOM=${3:-1}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

cat >s.toml <<'END'
[pose]
lateral = {from = -2, to = 2, count = 4}
[solve]
grid = [256, 256]
[study]
fields = ["x", "y", "z", "pressure"]
END
begin=$(date +%s%N)
"$sweep" s.toml --out whole >/dev/null
whole=$((($(date +%s%N) - begin) / 1000000)) # ms

# pause MS
pause() {
  sleep "$(printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)))"
}

killed=0
late=0
writing=0
failed=0
for ((i = 0; i < count; ++i)); do
  rm -rf o
  "$sweep" s.toml --out o >/dev/null 2>&1 &
  run=$!
  disown # the shell would tell of each
  if ((i % 2 == 0)); then
    pause $((RANDOM % (whole + whole / 20)))
  else
    while [ ! -e "o/s.nc.part$run.nc" ] && kill -0 $run 2>/dev/null; do :; done
    pause $((RANDOM % 8))
  fi
  [ ! -e "o/s.nc.part$run.nc" ] || writing=$((writing + 1))
  if kill -9 $run 2>/dev/null; then killed=$((killed + 1)); else late=$((late + 1)); fi
  # Not waited for: it is resumed at once.
  "$sweep" s.toml --out o --resume >out 2>error || cat error >&2
  if ! cmp -s o/s.csv whole/s.csv || ! cmp -s o/s.nc whole/s.nc ||
    [ "$(ls o)" != "$(ls whole)" ]; then
    failed=$((failed + 1))
    ls o >&2
  fi
done
echo "$killed killed ($writing while NetCDF was written), $late had ended; $failed did not resume"
[ $failed = 0 ]
