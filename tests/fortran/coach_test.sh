#!/usr/bin/env bash
# What the coach is to prove, by the numbers that it prints.
# Usage: coach_test.sh COACH runs|mirror|energy|figures|costs|by_table|critical|extremes
set -euo pipefail
coach=$(realpath "$1")
table_of_costs=$(realpath "$(dirname "$0")/../../drivers/fortran/coach_table.sh")
files=$(mktemp -d)
trap '[ $? = 0 ] || tail -n 25 "$files"/*.txt; rm -r "$files"' EXIT
cd "$files"

# value FILE NAME [COLUMN]: a word behind the name in the line that begins with it, the last one by default.
value() {
  awk -v name="$2" -v column="${3:-0}" 'index($0, name) == 1 {
    n = split(substr($0, length(name) + 1), words)
    print words[column ? column : n]
    exit
  }' "$1"
}
expect() {
  awk "BEGIN { exit !($1) }" || {
    echo "not so: $2: $1"
    exit 1
  }
}
# near VALUE KNOWN SHARE WHAT
near() { expect "$1/$2 - 1 <= $3 && 1 - $1/$2 <= $3" "$4"; }
same_state() {
  [ "$(grep '^state' "$1")" = "$(grep '^state' "$2")" ] || {
    echo "other bits: $3"
    exit 1
  }
}

curve=(--radius 1000 --cant 0.12 --start 5 --transition 30 --circle 100)

runs() {
  "$coach" "${curve[@]}" --seconds 0.3 --threads 2 >whole.txt
  "$coach" "${curve[@]}" --seconds 0.09 --threads 1 --save state >first.txt
  "$coach" "${curve[@]}" --seconds 0.21 --threads 1 --restart state --data table >second.txt
  "$coach" "${curve[@]}" --seconds 0.09 --jacobian differences >differences.txt
  "$coach" "${curve[@]}" --seconds 0.09 --keep 1 >fresh.txt
  expect "$(value whole.txt 'steps halved') == 0" "no step has failed"
  expect "$(wc -l <table) == 211" "a line for each step"
  # After 90 steps the matrix has served 10, with a rate that has been measured.
  same_state whole.txt second.txt "a run that is stopped and restarted, on one thread"
  expect "$(value whole.txt 'largest error of steady creep forces') > 0" "forces change in a transition curve"
  expect "$(value first.txt evaluations) <= 0.7*$(value differences.txt evaluations)" \
    "a Jacobian by the library saves ten evaluations"
  expect "$(value first.txt 'Newton iterations') <= 1.1*$(value fresh.txt 'Newton iterations')" \
    "a Jacobian that is kept takes as many iterations"
  # All solve the same equations to the tolerance of Newton's iteration: 1e-8 m and 1e-5 m/s.
  local other
  for other in differences fresh; do
    paste <(grep '^state' first.txt | tr ' ' '\n' | grep E) \
      <(grep '^state' "$other.txt" | tr ' ' '\n' | grep E) |
      awk '{ d = $1 - $2; limit = NR <= 42 ? 2e-8 : 2e-5; if (d > limit || d < -limit) bad = 1 }
        END { exit bad || NR != 84 }' || {
      echo "other results: $other"
      exit 1
    }
  done
  expect "$(value whole.txt 'lateral force when centred') == 0 && $(value whole.txt 'moment about') == 0" \
    "a centred wheelset has no forces"
  local drag power
  drag=$(value whole.txt 'power of its drag') power=$(value whole.txt 'power of its friction')
  # Its own accuracy is 1e-2; the approach of the bodies moves the place of friction by less.
  expect "$power > 100" "friction of the spin"
  near "$drag" "$power" 1e-3 "power balance"
}

# Y, roll and yaw change their sign, and no bit else.
same_but_mirrored() {
  paste <(grep '^state' "$1" | tr ' ' '\n' | grep E) <(grep '^state' "$2" | tr ' ' '\n' | grep E) |
    awk 'NR % 2 == 1 && $1 != $2 || NR % 2 == 0 && $1 != -$2 { bad = 1 } END { exit bad || NR != 84 }' || {
    echo "other bits on mirrored track: $3"
    exit 1
  }
}
mirror() {
  local method
  for method in implicit explicit; do
    "$coach" "${curve[@]}" --seconds 0.2 --method $method --lateral-speed 0.05 >track.txt
    "$coach" "${curve[@]}" --seconds 0.2 --method $method --lateral-speed 0.05 --mirror yes >mirrored.txt
    same_but_mirrored track.txt mirrored.txt "$method"
  done
}

# In the frames the balance closes for any track; what is missing comes from the sum over steps, here 0.3 to 0.9 % of what
# dampers take, depending on where the coach starts. On even track contacts
# take what the library says that friction dissipates, to 1e-5 here.
energy() {
  "$coach" --energy yes --seconds 0.4 >irregular.txt
  local missing taken friction
  missing=$(value irregular.txt 'energy that is missing, J') taken=$(value irregular.txt 'work that dampers take, J')
  expect "$taken > 1" "dampers work: $taken"
  expect "$missing < 0.01 * $taken && -($missing) < 0.01 * $taken" "the balance closes"
  "$coach" --energy yes --irregularity 0 --lateral-speed 0.1 --seconds 0.3 >even.txt
  taken=$(value even.txt 'work that contacts take, J') friction=$(value even.txt 'work of friction by the library, J')
  expect "$friction > 100" "friction works: $friction"
  near "$taken" "$friction" 2e-4 "contacts take what friction dissipates"
}

# Into a curve on irregular track. Known: at accuracies of 1e-3 (fastsim) and 3e-3 (full); the explicit method agrees.
figures() {
  "$coach" "${curve[@]}" --seconds 1 >fastsim.txt
  "$coach" "${curve[@]}" --seconds 1 --creep full >full.txt
  "$coach" "${curve[@]}" --seconds 1 --method explicit >explicit.txt
  local run
  for run in fastsim full explicit; do
    expect "$(value $run.txt 'steps halved') <= 1" "at most one step of a thousand has failed: $run"
    near "$(value $run.txt 'first right' 1)" 74.19 1e-3 "mean load of the outer wheel: $run"
    near "$(value $run.txt 'first right' 2)" 11.74 5e-3 "rms of its changes: $run"
  done
  near "$(value fastsim.txt 'all wheels' 5)" 3.480 5e-3 "rms Y, fastsim"
  near "$(value fastsim.txt 'all wheels' 6)" 12.11 2e-2 "99.85 % of Y, fastsim"
  near "$(value explicit.txt 'all wheels' 5)" 3.480 5e-3 "rms Y, explicit"
  near "$(value full.txt 'all wheels' 5)" 3.496 5e-3 "rms Y, full theory"
  near "$(value full.txt 'all wheels' 6)" 11.48 1e-2 "99.85 % of Y, full theory"
}

# A row for each integrator with each of four models, then the reference, which differs by 0 from itself.
costs() {
  "$table_of_costs" "$coach" 0.02 >costs.txt
  expect "$(grep -c '^| `' costs.txt) == 13" "thirteen rows"
  expect "$(grep -c 'explicit | 4.00 ' costs.txt) == 4" "four evaluations in an explicit step"
  expect "$(tail -n 3 costs.txt | grep -c ' +0.00 % | +0.00 % | +0.00 % | +0.00 % |') == 1" "the reference"
}

# Forces from a coarse table (its error: 0.7 % median, 12 % at 99 %), alone and with the exact solution where it errs
# by more than 15 %: the loads of the full theory, and of itself on mirrored track.
by_table() {
  local wrc_table
  wrc_table=$(dirname "$coach")/wrc_table
  "$wrc_table" coarse.table --fineness 0.4 --lateral 8 --tolerance 0.1 --threads 2 >made.txt 2>&1
  "$coach" "${curve[@]}" --seconds 1 --creep full >full.txt
  "$coach" "${curve[@]}" --seconds 1 --table coarse.table >table.txt
  "$coach" "${curve[@]}" --seconds 0.2 --method explicit --table coarse.table --lateral-speed 0.05 >track.txt
  "$coach" "${curve[@]}" --seconds 0.2 --method explicit --table coarse.table --lateral-speed 0.05 --mirror yes >mirrored.txt
  same_but_mirrored track.txt mirrored.txt "by the table"
  expect "$(value table.txt 'steps halved') == 0" "no step has failed"
  near "$(value table.txt 'all wheels' 2)" "$(value full.txt 'all wheels' 2)" 5e-3 "rms of Q"
  near "$(value table.txt 'all wheels' 3)" "$(value full.txt 'all wheels' 3)" 5e-3 "99.85 % of Q"
  near "$(value table.txt 'all wheels' 5)" "$(value full.txt 'all wheels' 5)" 3e-2 "rms of Y"
  near "$(value table.txt 'all wheels' 6)" "$(value full.txt 'all wheels' 6)" 5e-2 "99.85 % of Y"
  expect "$(value table.txt 'wheels solved exactly, share') > 0" "the exact solution answers where the table errs"
  ! "$coach" --table made.txt >refused.txt 2>&1 || expect 0 "a file that is no table is refused"
}

# By eigenvalues of the library's Jacobian and in time: here 0.6 % apart.
critical() {
  "$coach" --critical yes --seconds 0.2 --step 2e-3 >found.txt
  local by_eigenvalues in_time
  by_eigenvalues=$(value found.txt 'critical speed by eigenvalues, m/s')
  in_time=$(value found.txt 'critical speed in time, m/s')
  expect "$by_eigenvalues > 65 && $by_eigenvalues < 85" "of a coach without yaw dampers"
  near "$in_time" "$by_eigenvalues" 0.02 "the same"
  awk 'NR == 2 && !($4 < 0) || NR == 3 && !($4 > 0) { exit 1 }' found.txt
}

# Through standstill to rolling backwards; braking to rest and starting; a push at rest; a wheel that comes down; flange contact.
extremes() {
  "$coach" --speed 0.02 --acceleration -1 --step 2e-4 --seconds 0.03 >backwards.txt
  "$coach" --speed 0.1 --acceleration -1 --acceleration-time 0.1 --seconds 0.2 >rest.txt
  "$coach" --speed 0 --acceleration 0.5 --seconds 0.2 >start.txt
  "$coach" --speed 0 --lateral-speed 0.01 --standstill-speed 0.1 --seconds 0.1 >pushed.txt
  "$coach" --roll 0.005 --seconds 0.1 --data lifted >wheel.txt
  "$coach" --speed 60 --lateral-speed 1.5 --seconds 0.05 --data flange >jolt.txt
  expect "$(value rest.txt 'steps halved') + $(value start.txt 'steps halved') == 0" "no step has failed"
  # The lateral velocity of the first wheelset: 10 mm/s at first, then friction holds it.
  grep '^state' pushed.txt | awk '{ exit !($63 < 2e-3 && $63 > -2e-3) }' || expect 0 "friction stops a pushed wheelset"
  awk '!/^#/ && $11 == 0 { up = 1 } !/^#/ && up && $11 > 1e4 { down = 1 } END { exit !down }' lifted ||
    expect 0 "the left wheel comes down"
  # Forces on a flange are many times those on the tread.
  awk '!/^#/ && ($15 > 6e4 || $15 < -6e4 || $16 > 6e4 || $16 < -6e4) { touched = 1 } END { exit !touched }' \
    flange || expect 0 "a flange touches"
}

"$2"
