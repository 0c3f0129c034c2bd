# SPDX-License-Identifier: LGPL-2.1-or-later
# blcheck: what is wrong, in words.
source [file join [file dirname [info script]] claims.tcl]
test {
  box b 1 2 3
  claim "a box is sound" [expr {[string trim [blcheck b]] eq "0"}]
  explode b f
  claim "and a face of it, too" [expr {[string trim [blcheck b_1]] eq "0"}]
  # A solid that lacks a face has open edges.
  sewing s 1e-6 b_1 b_2 b_3 b_4 b_5
  ssolid s open
  set answer [blcheck open]
  claim "an open solid is not" [expr {[lindex $answer 0] > 0 && [llength $answer] == 1 + [lindex $answer 0]}]
  claim "too many words show the usage" [string match "*usage: blcheck shape*" [message_of blcheck b b]]
}
