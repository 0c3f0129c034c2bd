# SPDX-License-Identifier: LGPL-2.1-or-later
# blfill: holes closed by patches.
source [file join [file dirname [info script]] claims.tcl]
test {
  box b 10 10 10
  explode b f
  sewing s 1e-6 b_1 b_2 b_3 b_4 b_5
  set answer [blfill r s G0]
  claim "an open box has one hole" [expr {[lindex $answer 0] == 1 && [llength $answer] == 2}]
  claim "it is closed" [expr {[dict exists [blinfo r] meetings open] == 0}]
  claim "and has the area of the box" [near [mass_of sprops r] 600]
  claim "a closed box has none" [string match "*b: no edge is open*" [message_of blfill r b G1]]
  claim "a continuity that is none is refused" [string match "*'G7' is none of*" [message_of blfill r s G7]]
}
