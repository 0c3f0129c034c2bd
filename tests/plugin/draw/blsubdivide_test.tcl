# SPDX-License-Identifier: LGPL-2.1-or-later
# blsubdivide: pieces of surfaces that lie on them.
source [file join [file dirname [info script]] claims.tcl]
test {
  plane p 0 0 0 0 0 1
  mkface a p 0 4 0 4
  set answer [blsubdivide r a 1 2 1 3]
  claim "a plane's piece is bilinear" [expr {[string trim $answer] eq "1 1 1 1"}]
  claim "of area 2" [near [mass_of sprops r] 2]
  cylinder c 0 0 0 0 0 1 2
  mkface b c 0 3 0 5
  blsubdivide r b 0 1 0 2
  claim "a cylinder's piece has its area" [near [mass_of sprops r] 4]
  box s 1 1 1
  claim "one face is wanted" [string match "*s: has several faces*" [message_of blsubdivide r s 0 1 0 1]]
  claim "an empty rectangle is refused" [string match "*blsubdivide:*" [message_of blsubdivide r a 1 1 0 1]]
}
