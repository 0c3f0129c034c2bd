# SPDX-License-Identifier: LGPL-2.1-or-later
# blsection: sections with planes.
source [file join [file dirname [info script]] claims.tcl]
test {
  psphere s 2
  set answer [blsection r s 0 0 1 0 0 1]
  claim "a ball's section is one closed wire" [expr {[lrange $answer 0 1] eq "1 complete" && [lindex $answer 2 0] eq "closed"}]
  claim "a circle of radius sqrt 3" [expr {[near [lindex $answer 2 1] [expr {6.283185307179586 * sqrt(3)}]] && [near [mass_of lprops r] [lindex $answer 2 1]]}]
  box b 1 2 3
  claim "a box's section is a rectangle" [near [lindex [blsection r b 0 0 1 0 0 1] 2 1] 6]
  claim "beside it there is nothing" [expr {[string trim [blsection r b 0 0 9 0 0 1]] eq "0 complete"}]
  vertex low 1 2 -3
  vertex high 1 2 7
  edge needle low high
  set answer [blsection r needle 0 0 1 0 0 1]
  claim "an edge is cut in a point" [expr {[lindex $answer 2 0] eq "point" && [near [lindex $answer 2 1 2] 1]}]
  claim "no normal is refused" [string match "*blsection:*" [message_of blsection r b 0 0 0 0 0 0]]
  claim "a word that is no number is refused" [string match "*'up' is no number*" [message_of blsection r b 0 0 0 0 0 up]]
}
