#!/usr/bin/env bash
# The man page of a program: its --help as it stands, with examples and tables.
# Usage: man_page.sh PROGRAM "what it does"
set -euo pipefail
path=$1 purpose=$2
program=$(basename "$path")
version=$("$path" --version)
cat <<END
.TH ${program^^} 1 "" "$version" "User Commands"
.ad l
.nh
.SH NAME
$program \\- $purpose
.SH SYNOPSIS
.nf
$("$path" --help | sed -n 's/^Usage: //p')
.SH DESCRIPTION
END
"$path" --help | sed -e '/^Usage: /d' -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/" | cat -s
printf '.fi\n.SH SEE ALSO\nThe pages of the documentation, index.md first; from Debian packages in /usr/share/doc/wrcontact\\-tools/docs.\n'
