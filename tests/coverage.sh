#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Prints which share of core's lines its own tests run, by room; fails below 90 % of all.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/support/setup.sh"

step "packages"
install_packages "${build_packages[@]}" gcovr

step "build"
configure coverage
cmake --build "$root/build/coverage" -j "$(build_jobs)" --target test_core

step "test"
find "$root/build/coverage" -name '*.gcda' -delete
"$root/build/coverage/tests/test_core" --gtest_brief=1

step "lines of core that its tests run"
gcovr --root "$root" --object-directory "$root/build/coverage" --filter "$root/core/" \
  --json-summary "$root/build/coverage/summary.json" >/dev/null
python3 "$root/tests/support/coverage_table.py" "$root/build/coverage/summary.json" 90
