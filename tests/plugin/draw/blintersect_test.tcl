# SPDX-License-Identifier: LGPL-2.1-or-later
# blintersect: results, the Tcl answer, and errors in words.

source [file join [file dirname [info script]] claims.tcl]

test {
  # A second time changes nothing.
  pload -BlossomPlugin BLOSSOM

  # Two planes that cross in the segment x = 0, z = 0, |y| <= 5.
  plane p 0 0 0 0 0 1
  mkface a p -5 5 -5 5
  plane q 0 0 0 1 0 0
  mkface b q -5 5 -5 5
  set answer [blintersect r a b]
  claim "two planes cross in one proven curve" [expr {[string trim $answer] eq "1 complete"}]
  claim "the result is one edge" [expr {[count_of r EDGE] == 1}]
  regexp {Mass *: *([0-9.e+-]+)} [lprops r] whole length
  claim "of length 10" [expr {abs($length - 10) < 1e-6}]
  set answer [blintersect r a b 1e-5]
  claim "a tolerance may be given" [expr {[lindex $answer 0] == 1}]

  plane q 0 0 7 0 0 1
  mkface far q -5 5 -5 5
  set answer [blintersect r a far]
  claim "nothing is proven empty" [expr {[string trim $answer] eq "0 complete"}]
  claim "and the result is an empty compound" [expr {[count_of r EDGE] == 0}]

  # A small circle that the sphere's seam cuts in two is one curve of two edges.
  psphere s 1
  plane q 0.8 0 0 1 0 0
  mkface wall q -2 2 -2 2
  set answer [blintersect r s wall]
  claim "one across a seam counts once" [expr {[string trim $answer] eq "1 complete"}]
  claim "and has two edges" [expr {[count_of r EDGE] == 2}]

  # A face that stands on its corner: the contact says where it is and what it is on.
  plane q 0 0 0 -2 -2 2 1 0 1
  mkface corner q 0 3 0 3
  set answer [blintersect r corner a]
  set contact [lindex $answer 2]
  claim "a contact is no curve" [expr {[lindex $answer 0] == 0 && [llength $answer] == 3}]
  claim "it is told where it is" [expr {[llength [lindex $contact 0]] == 3}]
  claim "and what it is on" \
      [expr {[lindex $contact 1 0] eq "vertex" && [lindex $contact 2] eq "face 1"}]
  claim "also where the result takes the place of a shape" \
      [expr {[lindex [blintersect corner corner a] 2 1] eq [lindex $contact 1]}]

  # An edge through a box, and along one of its faces.
  box block 4 4 4
  vertex below 1 2 -3
  vertex above 1 2 7
  edge needle below above
  set answer [blintersect r needle block]
  claim "an edge has points in common with faces" [expr {[lrange $answer 0 1] eq "0 complete" && [llength $answer] == 4}]
  claim "they are told with the edge and the face" [expr {[lindex $answer 2 1] eq "edge 1" && [lindex $answer 2 2 0] eq "face"}]
  claim "and are vertices of the result" [expr {[count_of r VERTEX] == 2}]
  claim "either may be the edge" [expr {[lindex [blintersect r block needle] 2 2] eq "edge 1"}]
  vertex left -2 1 4
  vertex right 6 1 4
  edge rod left right
  claim "what lies on a face is a wire" [expr {[lindex [blintersect r rod block] 0] == 1 && [count_of r EDGE] == 1}]

  claim "a missing shape is named" \
      [string match "*nosuch: there is no such shape*" [message_of blintersect r a nosuch]]
  vertex v 1 2 3
  claim "a shape without faces is named" \
      [string match "*v: there is no face and no edge in it*" [message_of blintersect r v a]]
  claim "a bad tolerance is refused" \
      [string match "*'-1' is no positive number*" [message_of blintersect r a b -1]]
  plane flat 0 0 0 0 0 1
  claim "how a surface becomes a face" \
      [string match "*flat is no shape; mkface makes one*" [message_of blintersect r a flat]]
  claim "too few words show the usage" \
      [string match "*usage: blintersect result*" [message_of blintersect r a]]
}
