# SPDX-License-Identifier: LGPL-2.1-or-later
# blinfo: a dictionary of what a shape is made of.
source [file join [file dirname [info script]] claims.tcl]
test {
  box b 1 2 3
  pcylinder c 1 2
  set facts [blinfo b]
  claim "a box has 6 faces, 12 edges, 8 vertices" \
      [expr {[dict get $facts faces] == 6 && [dict get $facts edges] == 12 && [dict get $facts vertices] == 8}]
  claim "all of them planes" [expr {[dict get $facts surfaces] eq "plane 6"}]
  claim "and its edges convex" [expr {[dict get $facts meetings] eq "convex 12"}]
  claim "a cylinder has its type and a seam" \
      [expr {[dict get $facts solids] == 1 && [dict get [blinfo c] surfaces cylinder] == 1
             && [dict get [blinfo c] meetings seam] == 1}]
  claim "a missing shape is named" [string match "*nosuch: there is no such shape*" [message_of blinfo nosuch]]
  claim "too few words show the usage" [string match "*usage: blinfo shape*" [message_of blinfo]]
}
