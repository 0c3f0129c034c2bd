# SPDX-License-Identifier: LGPL-2.1-or-later
# bltrim: pieces of faces on one side of tools.
source [file join [file dirname [info script]] claims.tcl]
test {
  plane p 0 0 0 0 0 1
  mkface part p -5 5 -5 5
  plane q 1 0 0 1 0 0
  mkface tool q -9 9 -9 9
  set answer [bltrim r part above tool]
  claim "one piece of two is kept" [expr {[lrange $answer 0 1] eq "1 complete" && [llength $answer] == 4}]
  claim "it is 4 wide" [near [mass_of sprops r] 40]
  bltrim r part below tool
  claim "the other side is 6 wide" [near [mass_of sprops r] 60]
  bltrim r part all tool
  claim "all of it are two faces" [expr {[count_of r FACE] == 2}]
  set answer [bltrim r part 1 tool]
  claim "a piece may be named by its number" [near [mass_of sprops r] [lindex $answer 2 2]]
  psphere s 2
  set answer [bltrim r part inside s]
  claim "inside of a ball is a disc" [near [mass_of sprops r] 12.566370614359172 1e-5]
  claim "a side that is none is refused" \
      [string match "*'beside' is none of above*" [message_of bltrim r part beside tool]]
  claim "inside needs a solid" [string match "*bltrim:*" [message_of bltrim r part inside tool]]
  claim "too few words show the usage" [string match "*usage: bltrim*" [message_of bltrim r part above]]
}
