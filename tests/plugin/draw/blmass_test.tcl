# SPDX-License-Identifier: LGPL-2.1-or-later
# blmass: volume, area and centre of gravity.
source [file join [file dirname [info script]] claims.tcl]
test {
  box a 1 2 3 2 3 4
  set answer [blmass a]
  claim "the volume of a box" [near [lindex $answer 0] 24]
  claim "its area" [near [lindex $answer 1] 52]
  claim "its centre" [expr {[near [lindex $answer 2 0] 2] && [near [lindex $answer 2 1] 3.5] && [near [lindex $answer 2 2] 5]}]
  explode a f
  claim "a face has an area and no volume" [expr {[near [lindex [blmass a_1] 0] 0] && [near [lindex [blmass a_1] 1] 12]}]
  claim "a missing shape is named" [string match "*nosuch: there is no such shape*" [message_of blmass nosuch]]
}
