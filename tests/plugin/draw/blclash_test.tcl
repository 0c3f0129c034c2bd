# SPDX-License-Identifier: LGPL-2.1-or-later
# blclash: how parts lie to each other, what they have in common, and distances.
source [file join [file dirname [info script]] claims.tcl]
test {
  box block 10 10 10
  box post 4 4 5 2 2 10
  box lid 0 0 10 10 10 1
  box near 12 0 0 1 1 1
  box far 50 0 0 1 1 1
  set answer [blclash common 3 block post lid near far]
  set pairs [dict get $answer pairs]
  set words {}
  foreach pair $pairs { dict set words [lrange $pair 0 1] [lrange $pair 2 3] }
  claim "it lists what meets or is near" [expr {[lsort [dict keys $words]] eq \
    {{block lid} {block near} {block post} {post lid}}}]
  claim "and counts what is not" [expr {[dict get $answer clear] == 6}]
  claim "the post is in the block" [expr {[lindex $pairs 0 2] eq "penetrates"}]
  claim "by its volume" [near [lindex [dict get $words "block post"] 1] 20]
  claim "the lid touches" [expr {[lindex [dict get $words "block lid"] 0] eq "touches"}]
  claim "what is near is clear" [expr {[lindex [dict get $words "block near"] 0] eq "clear"}]
  claim "and measured" [near [lindex [dict get $words "block near"] 1] 2]
  claim "parts that are apart are no pair" [expr {[blclash common 0 near far] eq "pairs {} clear 1"}]
  claim "the common bodies are a shape" [near [mass_of vprops common] 24]
  claim "a clearance is no word" [string match "*blclash:*" [message_of blclash common near block post]]
}
