# SPDX-License-Identifier: LGPL-2.1-or-later
# blfillet: rounded edges, volumes, and refusals in words.
source [file join [file dirname [info script]] claims.tcl]
test {
  box b 10 10 10
  set answer [blfillet r b 1 1]
  claim "one edge is rounded" [expr {[lindex $answer 0] == 1 && [near [lindex $answer 1] 1000]}]
  # A square of side 1 less a quarter of a disc, along 10.
  set volume [expr {1000 - 10 * (1 - 3.141592653589793 / 4)}]
  claim "by the volume between square and disc" \
      [expr {[near [lindex $answer 2] $volume] && [near [mass_of vprops r] $volume]}]
  claim "the result is sound" [expr {[string trim [blcheck r]] eq "0"}]
  claim "all edges may be rounded" [expr {[lindex [blfillet r b 1 all] 0] == 12 && [count_of r FACE] == 26}]
  blfillet r b 1 1:2 3
  set both [expr {1000 - 10 * (4 + 1) * (1 - 3.141592653589793 / 4)}]
  claim "an edge may have its own radius" [near [mass_of vprops r] $both]
  claim "but not two" [string match "*edge 1 has two radii*" [message_of blfillet r b 1 1:2 1:3]]
  pcylinder c 5 10
  claim "a seam is left out, and told" [string match "2 * * 2" [blfillet r c 1 1 2 3]]
  claim "a seam alone is an error" [string match "*seam*" [message_of blfillet r c 1 2]]
  claim "too large a radius is refused, with the edge" [string match "*edge*" [message_of blfillet r b 20 1]]
  claim "there is no edge 99" [string match "*blfillet:*99*" [message_of blfillet r b 1 99]]
  claim "a box has no concave edge" [string match "*there is no such edge*" [message_of blfillet r b 1 concave]]
}
