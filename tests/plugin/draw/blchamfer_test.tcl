# SPDX-License-Identifier: LGPL-2.1-or-later
# blchamfer: edges cut off, volumes, and refusals in words; blfillet with two radii.
source [file join [file dirname [info script]] claims.tcl]
test {
  box b 10 10 10
  set answer [blchamfer r b 2 1]
  claim "one edge is cut off" [expr {[lindex $answer 0] == 1 && [near [lindex $answer 1] 1000]}]
  claim "by the volume of a prism" [expr {[near [lindex $answer 2] 980] && [near [mass_of vprops r] 980]}]
  claim "the result is sound" [expr {[string trim [blcheck r]] eq "0"}]
  claim "two distances" [near [lindex [blchamfer r b 2,1 1] 2] 990]
  claim "an angle" [near [lindex [blchamfer r b 2:45 1] 2] 980]
  claim "all edges may be cut off" [expr {[lindex [blchamfer r b 1 all] 0] == 12}]
  claim "a word is no distance" [string match "*blchamfer: *is no positive number*" [message_of blchamfer r b two 1]]
  claim "a flat angle is none" [string match "*below 180 degrees*" [message_of blchamfer r b 2:180 1]]
  claim "too large a distance is refused, with the edge" [string match "*edge 1*" [message_of blchamfer r b 20 1]]
  claim "radii may change" [expr {abs([lindex [blfillet r b 1..3 1] 2] - (1000 - 10 * 13 / 3. * (1 - 3.14159265 / 4))) < 0.3}]
}
