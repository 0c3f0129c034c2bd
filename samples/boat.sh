#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# The skin of a boat, cut by its deck and by the tunnel of a bow thruster; every result is checked.
#
# usage: boat.sh BLOSSOM SAMPLES OUT   (the program, the folder of the built samples, results)
set -euo pipefail
blossom=$1 samples=$2 out=$3

mkdir -p "$out"
"$samples/make_parts" "$out"
cd "$out"
"$blossom" info hull.step

"$blossom" intersect hull.step cutters.step \
  -o intersection.step --json intersection.json --picture intersection.png

# Face 1 of the cutters is the deck, its normal points up; face 2 the tunnel, its normal points
# away from its axis.
"$blossom" trim hull.step cutters.step --keep all -o pieces.step
"$blossom" trim hull.step "cutters.step#1" --keep below -o below_deck.step
"$blossom" trim below_deck.step "cutters.step#2" --keep above -o boat.step

"$samples/check_result" "$out"
