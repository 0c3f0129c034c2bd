# SPDX-License-Identifier: LGPL-2.1-or-later
# blsolid: closed solids combined, with volumes that add up.
source [file join [file dirname [info script]] claims.tcl]
test {
  box a 10 10 10
  box b 5 5 5 10 10 10
  foreach {operation volume} {cut 875 common 125 fuse 1875} {
    set answer [blsolid r $operation a b]
    claim "$operation gives one solid" [expr {[lrange $answer 0 1] eq "1 complete"}]
    claim "of volume $volume" [expr {[near [lindex $answer 2] $volume] && [near [mass_of vprops r] $volume]}]
  }
  claim "split gives two" [expr {[lindex [blsolid r split a b] 0] == 2 && [count_of r SOLID] == 2}]
  plane p 0 0 5 0 0 1
  mkface sheet p -5 15 -5 15
  set answer [blsolid r common sheet a]
  claim "a sheet is cut by a solid" [expr {[lrange $answer 0 1] eq "1 complete" && [near [lindex $answer 2] 100]}]
  claim "a sheet is no solid" [string match "*sheet is no closed solid*" [message_of blsolid r cut a sheet]]
  polyline wire -5 5 5 5 5 5 5 15 5
  set answer [blsolid r cut wire a]
  claim "a wire is cut by a solid" [expr {[lrange $answer 0 1] eq "2 complete" && [near [lindex $answer 2] 10]}]
  claim "and takes nothing off it" [string match "*wires take nothing off*" [message_of blsolid r cut a wire]]
  claim "an operation that is none is refused" \
      [string match "*'minus' is none of cut*" [message_of blsolid r minus a b]]
}
