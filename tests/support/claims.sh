# SPDX-License-Identifier: LGPL-2.1-or-later
# Claims of tests in shell scripts. Sourced by bash.

# claim WHAT COMMAND...: the command has to succeed.
claim() {
  local what=$1
  shift
  if ! "$@"; then
    printf 'does not hold: %s\n  %s\n' "$what" "$*" >&2
    exit 1
  fi
  printf 'holds: %s\n' "$what"
}
