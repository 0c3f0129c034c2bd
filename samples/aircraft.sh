#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# An aircraft whose wing roots are rounded; every result is checked.
#
# usage: aircraft.sh BLOSSOM SAMPLES OUT   (the program, the folder of the built samples, results)
set -euo pipefail
blossom=$1 samples=$2 out=$3

mkdir -p "$out"
"$samples/make_parts" "$out"
cd "$out"

"$blossom" trim fuselage.step wings.step --solid fuse -o aircraft.step

# The only concave edges are those between the wings and the fuselage.
"$blossom" info aircraft.step --edges
"$blossom" blend fillet aircraft.step --edges concave --radius 120 -o faired.step \
  --picture faired.png --view=1,-1,1.2
"$blossom" check faired.step --continuity --require G0 --zebra --picture zebra.png --view=1,-1,1.2

"$samples/check_result" "$out" aircraft
