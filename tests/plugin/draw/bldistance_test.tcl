# SPDX-License-Identifier: LGPL-2.1-or-later
# bldistance: proven bounds and the nearest points.
source [file join [file dirname [info script]] claims.tcl]
test {
  box a 1 1 1
  box b 0 0 3 1 1 1
  set answer [bldistance a b]
  claim "two boxes are 2 apart" [expr {[near [lindex $answer 0] 2] && [near [lindex $answer 1] 2]}]
  claim "the lower bound is none above" [expr {[lindex $answer 0] <= [lindex $answer 1]}]
  claim "the points are on both" [expr {[near [lindex $answer 2 2] 1] && [near [lindex $answer 3 2] 3]}]
  vertex v 5 0.5 0.5
  claim "a vertex will do" [near [lindex [bldistance a v] 1] 4]
  claim "a missing shape is named" [string match "*nosuch: there is no such shape*" [message_of bldistance a nosuch]]
}
