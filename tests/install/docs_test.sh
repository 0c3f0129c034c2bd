#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Manual pages and completion know what the program's own help shows, of every command.
#
# usage: docs_test.sh BLOSSOM DOCS
set -euo pipefail
blossom=$1 docs=$2
source "$(dirname "${BASH_SOURCE[0]}")/../support/claims.sh"
source "$docs/bash/blossom"

# completed WORD...: what the completion offers for the last of the words.
completed() {
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
  _blossom
  printf '%s\n' "${COMPREPLY[@]}"
}
offers() {
  local wanted=$1
  shift
  completed "$@" | grep -xF -e "$wanted" >/dev/null
}
manual() { zcat "$docs/man/$(IFS=-; echo "$*").1.gz"; }
manual_names() {
  local wanted=${1//-/\\-}
  shift
  manual "$@" | grep -F -e "$wanted" >/dev/null
}

# The lines of a section of a command's help: the first word of each.
section() {
  local title=$1
  shift
  "$blossom" "$@" --help | sed -n "/^$title:/,/^\$/ s/^  \([^ ]*\).*/\1/p"
}

commands=0 options=0
check_command() {
  commands=$((commands + 1))
  local option below
  for option in $(section Options "$@" | tr , ' '); do
    options=$((options + 1))
    claim "completion of '$*' offers $option" offers "$option" blossom "$@" -
    claim "the manual of '$*' names $option" manual_names "$option" blossom "$@"
  done
  for below in $(section Subcommands "$@"); do
    claim "completion of '$*' offers $below" offers "$below" blossom "$@" ""
    check_command "$@" "$below"
  done
}
check_command >/dev/null
claim "all $options options are there" test "$options" -gt 100
claim "there are pages of all $commands commands" \
  test "$commands" -gt 10 -a "$(ls "$docs/man" | wc -l)" -eq "$commands"

claim "an option's own words are offered" offers findings blossom check a.step --fail-on f
nothing() { [ -z "$(completed "$@")" ]; }
claim "and no others" nothing blossom check a.step --fail-on x
claim "a file's name is left to bash" nothing blossom intersect hull

if command -v man >/dev/null; then
  well_formed() { ! man --warnings -l "$1" 2>&1 >/dev/null | grep .; }
  for page in "$docs"/man/*; do claim "$(basename "$page") is well-formed" well_formed "$page"; done
fi
