#!/usr/bin/env bash
# The Fortran interfaces of the C functions are those of wrcontact.h and of wrcontact_grid.h beside
# it: every function of these headers is bound by the module, with the same names, number, kinds and
# passing of arguments, the same structures and the same constants; every function bound is called.
# The F77 layer includes the same file.
#
# Both sides are brought to lines like
#   function wrc_scene_number int32 scene:address name:letters value:real*
# and compared. What is not understood is a failure, so that nothing passes unread.
# Usage: check_fortran_interface.sh [HEADER [MODULE_FOLDER]]
set -euo pipefail
project="$(cd "$(dirname "$0")/.." && pwd)"
header=${1:-$project/c_api/include/wrcontact.h}
headers=("$header" "$(dirname "$header")/wrcontact_grid.h")
folder=${2:-$project/fortran_bindings}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

of_header() {
  # Comments away, then one declaration a line.
  sed -e 's|//.*||' "${headers[@]}" | tr '\n' ' ' | sed -e 's|/\*|\n&|g; s|\*/|&\n|g' | grep -v '^/\*' |
    tr '\n' ' ' | sed -e 's|typedef struct|\n&|g; s|WRC_API|\n&|g' | grep -E '^(WRC_API [a-z]|typedef struct wrc_[a-z_]+ \{)' |
    awk '
    function stop(what) { print "not understood in the header: " what > "/dev/stderr"; bad = 1 }
    function kind_of(type, returned) {
      gsub(/ *\* */, "*", type); gsub(/wrc_status/, "int32_t", type)
      sub(/^ +/, "", type); sub(/ +$/, "", type)
      if (type == "void" && returned) return "nothing"
      if (type == "int32_t") return "int32"
      if (type == "int64_t" || type == "uint64_t") return "int64"
      if (type == "double") return "real"
      if (type == "const char*") return returned ? "address" : "letters"
      if (type == "int32_t*") return "int32*"
      if (type == "int64_t*") return "int64*"
      if (type == "double*") return "real*"
      if (type == "const double*") return "const_real*"
      if (type == "const int32_t*") return "const_int32*"
      if (type == "const int64_t*") return "const_int64*"
      if (type == "const wrc_read_options*") return "const_options*"
      if (type == "const wrc_step_arguments*") return "const_arguments*"
      if (type == "const wrc_table_options*") return "const_table_options*"
      if (type == "wrc_table_facts*") return "table_facts*"
      if (type == "wrc_patch*") return "patch*"
      if (type ~ /^wrc_[a-z]+\*const\*$/) return "const_address*"
      if (type == "const char**" || type ~ /^wrc_[a-z]+\*\*$/) return "address*"
      if (type == "void*" || type ~ /^(const )?wrc_[a-z]+\*$/) return "address"
      stop("type " type); return "?"
    }
    function pair(text, returned,   name) {
      sub(/ +$/, "", text); name = text; sub(/.*[ *]/, "", name)
      return name ":" kind_of(substr(text, 1, length(text) - length(name)), returned)
    }
    /^typedef/ {
      line = $3; sub(/^wrc_(read_|step_|table_)?/, "", line)
      sub(/^[^{]*\{/, ""); sub(/\}.*/, ""); n = split($0, member, ";")
      for (i = 1; i <= n; ++i) if (member[i] ~ /[a-z]/) line = line " " pair(member[i], 1)
      gsub(/:(const_)?(real|int32|address)\*/, ":address", line) # an array that a member points to
      print line; next
    }
    {
      sub(/^WRC_API /, ""); sub(/;.*/, "")
      gsub(/void \(\*lock\)\(void\* context\)/, "@ lock"); gsub(/void \(\*unlock\)\(void\* context\)/, "@ unlock")
      gsub(/int32_t \(\*progress\)\(void\* context, double fraction\)/, "@ progress")
      open = index($0, "("); front = substr($0, 1, open - 1)
      inner = substr($0, open + 1); sub(/\) *$/, "", inner)
      name = front; sub(/.*[ *]/, "", name)
      line = "function " name " " kind_of(substr(front, 1, length(front) - length(name)), 1)
      n = split(inner, argument, ",")
      for (i = 1; i <= n; ++i) {
        sub(/^ +/, "", argument[i])
        if (argument[i] == "void") continue
        if (argument[i] ~ /^@/) { sub(/^@ /, "", argument[i]); line = line " " argument[i] ":procedure" }
        else line = line " " pair(argument[i], 0)
      }
      print line
    }
    END { exit bad }'
}

# of_fortran FILE: of its interface blocks.
of_fortran() {
  # Continued lines are joined, comments go.
  awk '
    /^ *!/ || /^ *$/ { next }
    open { sub(/^ +/, ""); line = line $0; open = sub(/& *$/, "", line); next }
    { if (line != "") print line; line = $0; open = sub(/& *$/, "", line) }
    END { print line }' "$1" |
    awk -v file="$(basename "$1")" '
    function stop(what) { print "not understood in " file ": " what > "/dev/stderr"; bad = 1 }
    function kind_of(type, array) {
      if (type == "integer(c_int32_t), value" || type == "integer(c_int32_t)") return "int32"
      if (type == "integer(c_int64_t), value" || type == "integer(c_int64_t)") return "int64"
      if (type == "real(c_double), value" || type == "real(c_double)") return "real"
      if (type == "integer(c_size_t)") return "size"
      if (type == "type(c_ptr), value" || type == "type(c_ptr)") return "address"
      if (type == "type(c_funptr), value") return "procedure"
      if (type == "character(kind=c_char), intent(in)" && array) return "letters"
      if (type ~ /^integer\(c_int32_t\), intent\(inout\)(, optional)?$/) return "int32*"
      if (type == "integer(c_int64_t), intent(inout)") return "int64*"
      if (type == "real(c_double), intent(inout)" || type == "real(c_double), intent(inout), optional") return "real*"
      if (type == "real(c_double), intent(in)" && array || type == "real(c_double), intent(in), optional") return "const_real*"
      if (type == "integer(c_int32_t), intent(in)" && array) return "const_int32*"
      if (type == "integer(c_int64_t), intent(in)" && array) return "const_int64*"
      if (type == "type(wrc_read_options), intent(in)") return "const_options*"
      if (type == "type(wrc_step_arguments), intent(in)") return "const_arguments*"
      if (type == "type(wrc_table_options), intent(in)") return "const_table_options*"
      if (type == "type(table_facts), intent(inout)") return "table_facts*"
      if (type == "type(contact_patch), intent(inout)") return "patch*"
      if (type == "type(c_ptr), intent(in)" && array) return "const_address*"
      if (type == "type(c_ptr), intent(inout)") return "address*"
      stop(type); return "?"
    }
    { gsub(/^ +| +$/, ""); $0 = tolower($0) }
    $0 == "interface" { within = 1; next }
    $0 == "end interface" { within = 0; next }
    /^type, bind\(c\)(, public)? :: / { within_type = 1; line = $NF; sub(/.*_/, "", line); next }
    within_type && /^end type/ { within_type = 0; print line; next }
    within_type { n = split($0, part, " :: "); sub(/ = (0|c_null_ptr)$/, "", part[2]); if (n != 2) stop($0); line = line " " part[2] ":" kind_of(part[1], 0); next }
    !within { next }
    /^import/ { next }
    /^(function|subroutine) / {
      returned = ""; delete kind
      if (match($0, /result\([a-z_0-9]+\)$/)) returned = substr($0, RSTART + 7, RLENGTH - 8)
      if ($0 !~ /bind\(c\)/) stop("no bind(c) in " $0)
      if ($0 ~ /^function/ && returned == "") stop("no result in " $0)
      open = index($0, "("); name = substr($0, 1, open - 1); sub(/.* /, "", name)
      inner = substr($0, open + 1); sub(/\).*/, "", inner); gsub(/ /, "", inner)
      count = split(inner, argument, ","); next
    }
    /^end (function|subroutine)/ {
      line = "function " name " " (returned == "" ? "nothing" : kind[returned])
      for (i = 1; i <= count; ++i) line = line " " argument[i] ":" kind[argument[i]]
      if (name != "strlen") print line
      next
    }
    {
      n = split($0, part, " :: "); if (n != 2) { stop($0); next }
      gsub(/ /, "", part[2]); m = split(part[2], entity, ",")
      for (i = 1; i <= m; ++i) { array = sub(/\(\*\)$/, "", entity[i]); kind[entity[i]] = kind_of(part[1], array) }
    }
    END { exit bad }'
}

failures=0
fail() { echo "$1"; failures=1; }

of_header | sort > "$work/header"
of_fortran "$folder/wrcontact_c.inc" | sort > "$work/module"
# A header that is read wrongly as a whole would compare equal to nothing.
[ "$(grep -c '^function' "$work/header")" -eq "$(cat "${headers[@]}" | grep -cE '^WRC_API [a-z]')" ] ||
  fail "not every declaration of the header was read"
diff -u --label wrcontact.h --label wrcontact_c.inc "$work/header" "$work/module" ||
  fail "the module's interfaces are not those of the header"

# Constants: WRC_OK 0 in the header, wrc_ok = 0 in the module.
grep -ohE '^#define WRC_[A-Z_]+ [0-9]+' "${headers[@]}" | tr '[:upper:]' '[:lower:]' | sed 's/#define //' | sort > "$work/defines"
grep -oE 'parameter, public :: wrc_[a-z_]+ = [0-9]+' "$folder/wrcontact.f90" |
  sed 's/.*:: //; s/ = / /' | sort > "$work/parameters"
diff -u --label wrcontact.h --label wrcontact.f90 "$work/defines" "$work/parameters" ||
  fail "the module's constants are not those of the header"

# Every function bound is called, except those that others of the same name with more arguments cover.
grep -ohE '[a-z_0-9]+\(' "$folder/wrcontact.f90" \
  "$folder"/wrcontact_{library,scene,solver,vehicle,history,table,normal,rolling,profile,namelist}.inc | tr -d '(' | sort -u >"$work/called"
never=$(awk '$1 == "function" { print $2 }' "$work/module" | sort | comm -23 - "$work/called" |
  grep -vxE 'wrc_solver_step|wrc_step_batch' || true)
[ -z "$never" ] || fail "the module binds and never calls: $never"
exit "$failures"
