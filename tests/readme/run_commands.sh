#!/usr/bin/env bash
# Runs what a page shows, in an empty folder: scene files by wrc_case, those that are named in their
# first line by the commands, and commands of wrc_case, wrc_profile and wrc_sweep; each must succeed
# and write the files it names. Usage: run_commands.sh BIN PROJECT PAGE FOLDER
set -euo pipefail
bin=$1 project=$2 page=$3 folder=$4
rm -rf "$folder"
mkdir -p "$folder/build/release"
cd "$folder"
ln -s "$bin" build/release/bin
ln -s "$project/drivers" drivers
export PATH=$bin:$PATH

# Measured profiles, as users have them: worn or not, they are files.
wrc_profile 54E1 --convert worn.prr >/dev/null
wrc_profile S1002 --convert my_wheel.prw >/dev/null
wrc_profile S1002 --convert measured_wheel.csv >/dev/null
awk '/^#/ { next } { print $1 + 70, $2 }' measured_wheel.csv >wheel.csv # counted from the flange back

# One line for each command, continued lines joined; a scene file becomes a file and a command.
awk '
  /^```/ {
    if (inside && language == "toml") {
      close(file)
      if (!named) print "wrc_case " file
    }
    inside = !inside
    language = substr($0, 4)
    file = ""
    next
  }
  !inside { next }
  language == "toml" {
    if (file == "") {
      named = match($0, /^# [a-z_]+\.toml$/)
      file = named ? substr($0, 3) : "scene" NR ".toml"
    }
    print > file
  }
  language == "" && (continued || /^(build\/release\/bin\/)?wrc_(case|profile|sweep) /) {
    continued = sub(/\\$/, "")
    printf "%s%s", $0, continued ? "" : "\n"
  }' "$project/$page" >commands
[ -s commands ]
while read -r command; do
  echo "$page: $command"
  bash -c "$command" </dev/null >output 2>&1 || { tail -n 20 output; exit 1; }
  grep -oE -- '--(plot|page|stress|out) [^ ]+' <<<"$command" | while read -r _ file; do
    [ -s "$file" ] || { echo "there is no $file"; exit 1; }
  done || [ "${PIPESTATUS[1]}" -eq 0 ]
done <commands
