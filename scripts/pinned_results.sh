#!/usr/bin/env bash
# Prints a checksum of the bits of a pinned set of results: 50 scenes, and a run of 200 steps with
# fields. The same before and after a change that is meant to change no number (on one machine).
# Usage: scripts/pinned_results.sh [BIN], where BIN holds the drivers (build/release/bin).
set -euo pipefail
bin=$(realpath "${1:-$(dirname "$0")/../build/release/bin}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

wheels=(S1002 S1002 LMA)
rails=(60E1 56E1 CHN60)
scene() {
  "$bin/wrc_case" --json "${@/#/--set=}" | sed '/"time_ms"/,/}/d'
}
for i in $(seq 0 49); do
  options=(pose.lateral="$((i * 7 % 13 - 6)).$((i % 10))" pose.yaw="0.00$((i % 9))"
    load.left="$((5000 + i * i * 60))" solve.accuracy="$([ $((i % 3)) = 0 ] && echo 1e-3 || echo 1e-2)"
    solve.accuracy_of="$([ $((i % 2)) = 0 ] && echo forces || echo pressures)"
    wheelset.wheel="${wheels[i % 3]}" track.rail="${rails[i % 3]}")
  case $((i % 10)) in
    7) options+=(solve.model=hertz) ;;
    8) options+=(solve.model=kik-piotrowski) ;;
    9) options+=(solve.grid=[32,64]) ;;
  esac
  echo "$i"
  scene "${options[@]}" 2>&1 || true
done >scenes.txt

cat >run.toml <<'TOML'
[pose]
lateral = {from = -6.5, to = 6.5, count = 200}
yaw = 0.004
[solve]
accuracy_of = "forces"
[study]
results = ["left.lateral_force", "right.vertical_force", "left.pressure_moment.x", "left.depth", "roll", "left.pmax", "left.sensitivities.pressure_force.z.vertical", "right.residuals.complementarity"]
TOML
"$bin/wrc_sweep" run.toml --quiet --no-pictures --digits 17
cat run.csv >>scenes.txt
sha256sum scenes.txt | cut -d' ' -f1
[ -z "${KEEP:-}" ] || cp scenes.txt "$KEEP"
