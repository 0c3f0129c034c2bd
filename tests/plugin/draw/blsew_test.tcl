# SPDX-License-Identifier: LGPL-2.1-or-later
# blsew, and that the other commands sew loose faces by themselves.
source [file join [file dirname [info script]] claims.tcl]
test {
  box block 1 2 3
  explode block f
  for {set i 1} {$i <= 6} {incr i} { tcopy block_$i face_$i }
  compound face_1 face_2 face_3 face_4 face_5 face_6 loose
  claim "six loose faces are one solid" [expr {[lrange [blsew sewn loose] 0 1] == {1 6}}]
  claim "with the edges of a box" [expr {[count_of sewn EDGE] == 12 && [count_of sewn SOLID] == 1}]
  claim "the shape itself stays as it is" [expr {[count_of loose SOLID] == 0}]
  claim "a mass is one of the solid" [near [lindex [blmass loose] 0] 6]
  claim "and so are the answers to others" [expr {[dict get [blinfo loose] solids] == 1 && [lindex [blcheck loose] 0] == 0}]
  box drill 0.2 0.2 -1 0.5 0.5 9
  claim "they are cut as a solid" [near [lindex [blsolid cut cut loose drill] 2] [expr {6 - 0.75}]]
  explode block sh
  claim "a closed shell is cut as a sheet" [near [lindex [blsolid cut cut block_1 drill] 2] [expr {22 - 2 * 0.25}]]
  blsew solid block_1
  claim "and as a solid once it is sewn" [near [lindex [blsolid cut cut solid drill] 2] [expr {6 - 0.75}]]
  claim "and rounded" [expr {[lindex [blfillet rounded loose 0.1 all] 0] == 12}]

  compound face_1 face_2 face_3 face_4 face_5 open
  claim "five of them close nothing, and four edges are open" [expr {[blsew five open] == {0 0 0 4}}]
  claim "which is no failure of others" [near [lindex [blmass open] 0] 0]
  ttranslate face_6 0 0 0.01
  compound face_1 face_2 face_3 face_4 face_5 face_6 apart
  set before [blsew narrow apart 0.001]
  set after [blsew wide apart 0.1]
  claim "a wider gap is joined if it is told" [expr {[lindex $before 0] == 0 && [lindex $after 0] == 1}]
  claim "a missing shape is named" [string match "*nosuch: there is no such shape*" [message_of blsew x nosuch]]
  claim "a gap is positive" [string match "*'0' is no positive number*" [message_of blsew x loose 0]]
}
