# SPDX-License-Identifier: LGPL-2.1-or-later
# What tests of commands have in common. DRAW always exits with 0, so what is printed decides.

proc claim {what holds} {
  if {!$holds} { error "does not hold: $what" }
  puts "holds: $what"
}

# A command that has to fail; gives back its message.
proc message_of {args} {
  if {![catch {uplevel #0 $args} message]} { error "no error from: $args" }
  return $message
}

# DRAW's shapes are variables, so a procedure sees them only from the top level.
proc count_of {shape kind} {
  regexp "$kind *: *(\\d+)" [uplevel #0 [list nbshapes $shape]] whole count
  return $count
}

# Of lprops, sprops or vprops.
proc mass_of {properties shape} {
  regexp {Mass *: *([-0-9.e+]+)} [uplevel #0 [list $properties $shape]] whole mass
  return $mass
}

proc near {a b {within 1e-6}} { expr {abs($a - $b) <= $within * (1 + abs($b))} }

# Runs claims at the top level with the plugin loaded, and says how it ended.
proc test {claims} {
  if {[catch {
    uplevel #0 {pload MODELING}
    uplevel #0 {pload -BlossomPlugin BLOSSOM}
    uplevel #0 $claims
  } problem]} {
    puts "FAILED: $problem"
    exit 1
  }
  puts "\nALL CLAIMS HOLD"
  exit 0
}
