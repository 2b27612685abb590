#!/usr/bin/env bash
# scripts/write_fortran_interface.py --check fails on every kind of drift between headers and Fortran.
# Usage: interface_check_notices.sh PROJECT PYTHON
set -euo pipefail
project=$1
python=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

check() { "$python" -B "$project/scripts/write_fortran_interface.py" --check "$work" "$work"; }
fresh() { cp "$project"/c_api/include/wrcontact*.h "$project"/fortran_bindings/wrcontact* "$work"; }
# notices WHAT FILE SED TEXT: after the edit of one of the copied files the check fails and prints TEXT.
notices() {
  fresh
  cp "$work/$2" "$work/before"
  sed -i "$3" "$work/$2"
  if cmp -s "$work/$2" "$work/before"; then
    echo "nothing was changed for: $1"
    failures=1
  elif check >"$work/out" 2>&1 || ! grep -qF "$4" "$work/out"; then
    echo "not noticed: $1"
    cat "$work/out"
    failures=1
  fi
}

fresh
check
stale='is not that of the headers'
notices 'a new function of the header' wrcontact.h 's|^WRC_API const char\* wrc_version|WRC_API wrc_status wrc_new(double value);\n&|' 'wrc_new: the module never'
notices 'a function gone from the other header' wrcontact_grid.h '/wrc_rolling_advance/d' "$stale"
notices 'another kind' wrcontact.h 's|results, int32_t threads|results, int64_t threads|' "$stale"
notices 'another name of an argument' wrcontact.h 's|int32_t kind, int64_t index|int32_t sort, int64_t index|' "$stale"
notices 'a value for a pointer' wrcontact.h 's|double\* length)|double length)|' "$stale"
notices 'const' wrcontact.h 's|const double\* lateral|double* lateral|' "$stale"
notices 'another result' wrcontact.h 's|const char\* wrc_version|int64_t wrc_version|' "$stale"
notices 'a type never met' wrcontact.h 's|double\* length|float* length|' 'no Fortran for the type of length, float*'
notices 'a result never met' wrcontact.h 's|int64_t wrc_scene_key_count|double wrc_scene_key_count|' 'no Fortran for its result, double'
notices 'another constant' wrcontact.h 's|WRC_BUSY 11|WRC_BUSY 12|' 'wrc_busy = 12'
notices 'a new constant' wrcontact.h 's|^#define WRC_OK 0|&\n#define WRC_NEW 99|' 'wrc_new = 99'
notices 'a new member' wrcontact.h 's|  double scale;|  double scale; double offset;|' "$stale"
notices 'an edit of the bindings' wrcontact_c.inc '0,/value :: value/s//intent(in) :: value/' "$stale"
notices 'a constant in the module' wrcontact.f90 's/wrc_no_contact = 5/wrc_no_contact = 6/' 'wrc_no_contact = 6'
notices 'a function never called' wrcontact_scene.inc 's/wrc_scene_solve(/wrc_scene_dissolve(/' 'wrc_scene_solve: the module never'
exit "$failures"
