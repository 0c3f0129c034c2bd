#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs a script in FreeCAD's window on a screen of its own, with a profile of its own and an
# otherwise empty environment.
#
# usage: run_window.sh SCRIPT FOLDER ADDON README EXAMPLE
#   SCRIPT    beside this one: window_test.py, tour.py
#   FOLDER    made anew: profile, claims, pictures
#   ADDON     the add-on's folder, which the profile gets a link to; - if FreeCAD finds it itself
set -euo pipefail
script=$1 folder=$2 addon=$3 readme=$4 example=$5
test=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/$script

rm -rf "$folder"
mkdir -p "$folder/profile/Mod"
package=/usr/share/freecad/Mod/Blossom
if [ "$addon" != - ]; then
  package=$folder/profile/Mod/Blossom
  ln -s "$addon" "$package"
fi
# Without a start page: it is a web browser, which as root ends FreeCAD.
cat >"$folder/profile/user.cfg" <<'XML'
<?xml version="1.0" encoding="UTF-8"?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">BlossomWorkbench</FCText></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
XML

# The server itself chooses a number that is free, also when several begin at once.
exec {numbers}< <(exec Xvfb -displayfd 1 -screen 0 1280x1024x24 -nolisten tcp 2>"$folder/screen")
server=$!
trap 'kill "$server" 2>/dev/null || true' EXIT
if ! read -r -t 60 -u "$numbers" display; then
  cat "$folder/screen"
  exit 1
fi

code=0
env -i PATH=/usr/bin:/bin HOME="$folder" FREECAD_USER_HOME="$folder/profile" \
  DISPLAY=":$display" LIBGL_ALWAYS_SOFTWARE=1 \
  BLOSSOM_PACKAGE="$package" BLOSSOM_README="$readme" BLOSSOM_EXAMPLE="$example" \
  BLOSSOM_CLAIMS="$folder/claims" BLOSSOM_SHOT="$folder/window.png" BLOSSOM_SHOTS="$folder" \
  timeout 600 freecad "$test" \
  >"$folder/output" 2>&1 </dev/null || code=$?
cat "$folder/claims" || cat "$folder/output"
exit "$code"
