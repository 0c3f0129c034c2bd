# SPDX-License-Identifier: LGPL-2.1-or-later
# blblend: the strip between two faces, its borders and how it meets them.
source [file join [file dirname [info script]] claims.tcl]
test {
  plane p 0 0 0 0 0 1
  mkface a p 0 10 0 10
  mkface b p 20 30 0 10
  set answer [blblend s a b]
  claim "the nearest borders are joined" [expr {[lrange $answer 0 1] eq "umax umin"}]
  claim "exactly" [expr {[lindex $answer 2] < 1e-12 && [lindex $answer 3] < 1e-12}]
  claim "by one face that fills the gap" [expr {[count_of s FACE] == 1 && [near [mass_of sprops s] 100]}]
  claim "borders may be named, and weights" [expr {[lrange [blblend s a b umax umin 2 1] 0 1] eq "umax umin"}]
  claim "there is no border left" [string match "*blblend: a border is umin, umax, vmin, vmax*not 'left'*" [message_of blblend s a b left umin]]
  explode a E
  claim "or edges, by shape or number" [expr {[lrange [blblend s a b a_2 4] 0 1] eq [lrange [blblend t a b 2 4] 0 1]}]
  claim "curvatures continue if asked" [expr {[lindex [blblend s a b umax umin G2] 3] < 1e-12}]
  claim "there is no G4" [string match "*'G4' is none of G1, G2 and G3*" [message_of blblend s a b G4]]
  box c 1 1 1
  claim "a box is no face" [string match "*c: one face is wanted, got 6*" [message_of blblend s a c]]
}
