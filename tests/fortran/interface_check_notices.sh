#!/usr/bin/env bash
# scripts/check_fortran_interface.sh fails on every kind of drift between header and Fortran.
# Usage: interface_check_notices.sh PROJECT
set -euo pipefail
project=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# notices WHAT FILE SED: after the edit of one of the copied files the check fails.
notices() {
  cp "$project"/c_api/include/wrcontact*.h "$project"/fortran_bindings/wrcontact* "$work"
  sed -i "$3" "$work/$2"
  if cmp -s "$work/$2" "$project/c_api/include/$2" || cmp -s "$work/$2" "$project/fortran_bindings/$2"; then
    echo "nothing was changed for: $1"
    failures=1
  elif "$project/scripts/check_fortran_interface.sh" "$work/wrcontact.h" "$work" >"$work/out" 2>&1; then
    echo "not noticed: $1"
    failures=1
  fi
}

cp "$project"/c_api/include/wrcontact*.h "$project"/fortran_bindings/wrcontact* "$work"
"$project/scripts/check_fortran_interface.sh" "$work/wrcontact.h" "$work"
notices 'a new function of the header' wrcontact.h 's|^#ifdef __cplusplus|WRC_API wrc_status wrc_new(double value);\n&|'
notices 'a function gone from the header' wrcontact.h '/wrc_version/d'
notices 'a function gone from the other header' wrcontact_grid.h '/wrc_rolling_advance/d'
notices 'another argument' wrcontact.h 's|wrc_scene_solve(wrc_scene\* scene)|wrc_scene_solve(wrc_scene* scene, int32_t threads)|'
notices 'another kind' wrcontact.h 's|results, int32_t threads|results, int64_t threads|'
notices 'another name of an argument' wrcontact.h 's|int32_t kind, int64_t index|int32_t sort, int64_t index|'
notices 'a value for a pointer' wrcontact.h 's|double\* length)|double length)|'
notices 'const' wrcontact.h 's|const double\* lateral|double* lateral|'
notices 'another result' wrcontact.h 's|int64_t wrc_scene_key_count|int32_t wrc_scene_key_count|'
notices 'a type never met' wrcontact.h 's|double\* length|float* length|'
notices 'another constant' wrcontact.h 's|WRC_BUSY 11|WRC_BUSY 12|'
notices 'a new constant' wrcontact.h 's|^#define WRC_OK 0|&\n#define WRC_NEW 99|'
notices 'a new member' wrcontact.h 's|  double scale;|  double scale; double offset;|'
notices 'members in another order' wrcontact_c.inc 's|:: strict|:: swap|; s|:: reserved|:: strict|; s|:: swap|:: reserved|'
notices 'a kind in the module' wrcontact_c.inc '0,/c_int64_t), value :: count/s//c_int32_t), value :: count/'
notices 'value lost in the module' wrcontact_c.inc '0,/real(c_double), value :: value/s//real(c_double), intent(in) :: value/'
notices 'a constant in the module' wrcontact.f90 's/wrc_no_contact = 5/wrc_no_contact = 6/'
notices 'a function never called' wrcontact_scene.inc 's/wrc_scene_solve(/wrc_scene_dissolve(/'
exit "$failures"
