#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Layout by clang-format and likely bugs by clang-tidy, over all sources of libraries and doors. Sources
# of a room are read together, as in a build from nothing: it takes a fifth of the time.
#
#   tests/tidy.sh [ROOM]    likely bugs of that room alone: core/curves
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/support/setup.sh"

step "packages"
install_packages "${build_packages[@]}" clang-format clang-tidy-16

step "layout"
cd "$root"
git ls-files -- '*.h' '*.cpp' | xargs clang-format --dry-run -Werror

step "likely bugs"
configure tidy >/dev/null
python3 "$root/tests/support/tidy_units.py" "$root/build/tidy/compile_commands.json" "${1-}" |
  xargs -P "$(build_jobs)" -n 2 clang-tidy-16 -p "$root/build/tidy" --quiet --extra-arg=-w
