#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Layout by clang-format and likely bugs by clang-tidy, over all sources of libraries and doors.
#
#   tests/tidy.sh [PATTERN]    only files whose path matches the pattern
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/support/setup.sh"

step "packages"
install_packages "${build_packages[@]}" clang-format clang-tidy

step "layout"
cd "$root"
git ls-files -- '*.h' '*.cpp' | xargs clang-format --dry-run -Werror

step "likely bugs"
configure tidy >/dev/null
git ls-files -- 'core/*.cpp' 'adapters/*.cpp' 'plugin/*.cpp' | grep -v /gpl/ | grep -E "${1-.}" |
  xargs -P "$(build_jobs)" -n 4 clang-tidy -p "$root/build/tidy" --quiet --extra-arg=-w
