#!/usr/bin/env bash
# Fails unless programs and libraries are hardened: all relocations read-only once loaded, no stack
# or memory both writable and executable, position-independent, stack protector, checked calls of
# the C library (programs), a landing pad at every function exported (library, x86-64), libraries from
# stated folders alone.
# Usage: check_hardening.sh FILE ...
set -euo pipefail

faults=0
refuse() {
  echo "$1" >&2
  faults=1
}

for file in "$@"; do
  headers=$(readelf -lW "$file")
  dynamic=$(readelf -dW "$file")
  symbols=$(readelf -sW --dyn-syms "$file")
  grep -q GNU_RELRO <<<"$headers" || refuse "$file: no RELRO"
  grep -qE 'BIND_NOW|FLAGS_1.*NOW' <<<"$dynamic" || refuse "$file: RELRO is not full"
  if grep -E '^ *(LOAD|GNU_STACK)' <<<"$headers" | grep -q ' RWE '; then
    refuse "$file: memory both writable and executable"
  fi
  grep -q GNU_STACK <<<"$headers" || refuse "$file: executable stack"
  readelf -hW "$file" | grep -q 'Type: *DYN' || refuse "$file: not position-independent"
  if grep -q TEXTREL <<<"$dynamic"; then
    refuse "$file: relocations in code"
  fi
  # An empty entry, like a relative one, is a folder of the user's data.
  path=$(sed -nE 's/.*R(UN)?PATH.*\[(.*)\]$/\2/p' <<<"$dynamic")
  # shellcheck disable=SC2016 # the linker's word
  if [ -n "$path" ] && grep -qvE '^(/|\$ORIGIN(/|$))' < <(tr : '\n' <<<"$path"); then
    refuse "$file: libraries from the current folder: RUNPATH $path"
  fi
  grep -q __stack_chk_fail <<<"$symbols" || refuse "$file: no stack protector"
  case $file in
    *.so*)
      [ "$(uname -m)" = x86_64 ] || continue
      bare=$(objdump -d --no-show-raw-insn "$file" | awk '
        /^[0-9a-f]+ <wrc_[a-z_]*>:$/ { name = $2; next }
        name != "" { if ($2 != "endbr64") print name; name = "" }')
      [ -z "$bare" ] || refuse "$file: no landing pad at $bare"
      ;;
    *) grep -qE '__[a-z]+_chk@' <<<"${symbols//__stack_chk_fail/}" ||
      refuse "$file: no checked calls (FORTIFY)" ;;
  esac
done
exit $faults
