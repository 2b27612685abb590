#!/usr/bin/env bash
# The man page of a program on the path: its --help as it stands, with examples and tables.
# Usage: man_page.sh PROGRAM "what it does"
set -euo pipefail
program=$1 purpose=$2
version=$("$program" --version)
cat <<END
.TH ${program^^} 1 "" "$version" "User Commands"
.ad l
.nh
.SH NAME
$program \\- $purpose
.SH SYNOPSIS
.nf
$("$program" --help | sed -n 's/^Usage: //p')
.SH DESCRIPTION
END
"$program" --help | sed -e '/^Usage: /d' -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/" | cat -s
printf '.fi\n.SH SEE ALSO\nThe pages in /usr/share/doc/wrcontact\\-tools/docs, index.md first.\n'
