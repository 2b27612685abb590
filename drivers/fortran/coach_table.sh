#!/usr/bin/env bash
# What the coach costs with each integrator, creep law and accuracy, and how far its wheel forces are from those of
# the full theory at 1e-3: a table for docs/coach.md. One thread, 4 s through a curve of 1000 m radius.
# Usage: coach_table.sh COACH [SECONDS [TABLE...]], with tables by wrc_table as further models
set -euo pipefail
coach=$1
seconds=${2:-4}
tables=("${@:3}")
files=$(mktemp -d)
trap 'rm -r "$files"' EXIT
line=(--threads 1 --speed 40 --radius 1000 --cant 0.12 --start 20 --transition 50 --circle 40 --seconds "$seconds")
models=("fastsim 1e-1" "fastsim 1e-2" "full 3e-2" "full 1e-2")
methods=("explicit" "implicit 1" "implicit 20")

# run FILE CREEP ACCURACY METHOD [KEEP]; forces from $table if that is not empty.
table=
run() {
  "$coach" "${line[@]}" --creep "$2" --accuracy "$3" --method "$4" --keep "${5:-20}" ${table:+--table "$table"} >"$1"
}

# value FILE NAME: what follows the name, where it first is.
value() { awk -v name="$2" 'index($0, name) == 1 { print substr($0, length(name) + 1); exit }' "$1"; }

# name_of METHOD
name_of() {
  case $1 in
  explicit) echo "explicit" ;;
  "implicit 1") echo "implicit" ;;
  *) echo "implicit, Jacobian kept" ;;
  esac
}

run "$files/reference" full 1e-3 implicit 20
reference=$(value "$files/reference" "all wheels")
echo "| creep forces, accuracy | integrator | evaluations a step | time over simulated time | rms Q | 99.85 % Q | rms Y | 99.85 % Y |"
echo "|---|---|---|---|---|---|---|---|"
row() {
  local name=$1 method=$2 steps evaluations ratio
  steps=$(value "$files/run" "steps  ")
  evaluations=$(value "$files/run" "evaluations")
  ratio=$(value "$files/run" "processor over simulated time")
  # mean Q, rms of Q less its mean, 99.85 %, least Q, rms Y, 99.85 % of |Y|
  value "$files/run" "all wheels" | awk -v reference="$reference" -v head="| $name | $method" -v n="$steps" \
    -v e="$evaluations" -v r="$ratio" '{
      split(reference, known)
      printf "%s | %.2f | %.2f", head, e/n, r
      split("2 3 5 6", columns)
      for (i = 1; i <= 4; ++i) printf " | %+.2f %%", 100*($columns[i]/known[columns[i]] - 1)
      print " |"
    }'
}
for model in "${models[@]}"; do
  for method in "${methods[@]}"; do
    # shellcheck disable=SC2086
    run "$files/run" $model $method
    row "\`${model% *}\`, ${model#* }" "$(name_of "$method")"
  done
done
for table in ${tables[@]+"${tables[@]}"}; do
  for method in "${methods[@]}"; do
    # shellcheck disable=SC2086
    run "$files/run" full 1e-2 $method
    row "table \`${table##*/}\`" "$(name_of "$method")"
  done
done
cp "$files/reference" "$files/run"
row "\`full\`, 1e-3: reference" "implicit, Jacobian kept"
echo
echo "Reference, kN: rms Q - mean, 99.85 % Q, rms Y, 99.85 % Y: $(awk '{ print $2, $3, $5, $6 }' <<<"$reference")"
