#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs what is missing, builds everything and runs the tests.
#
#   tests/run.sh           the quick tests
#   tests/run.sh --full    all tests, layout and likely bugs (tests/tidy.sh), the quick tests once more
#                          under the sanitizers, and those with threads under ThreadSanitizer
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/support/setup.sh"

full=no
case "${1-}" in
  "") ;;
  --full) full=yes ;;
  *) echo "usage: tests/run.sh [--full]" >&2; exit 2 ;;
esac

# Of core's tests those that have several threads.
in_threads=Threads.*:*AreTheSameForAnyNumberOfThreads*:ShapeFacets.DoNotDependOnTheNumberOfThreads
in_threads+=:FillOperator.IsOneForThreadsThatAskAtTheSameTime

step "packages"
install_packages "${build_packages[@]}" "${test_packages[@]}"

step "configure"
configure release

step "build"
cmake --build "$build" -j "$(build_jobs)"

step "test"
if [ -z "${BLOSSOM_TEST_DATA-}" ]; then
  echo "BLOSSOM_TEST_DATA is not set: the tests on real models are skipped"
fi
labels=(-L quick)
if [ "$full" = yes ]; then labels=(); fi
ctest --test-dir "$build" "${labels[@]}" -j "$(nproc)" --output-on-failure --no-tests=error \
  --output-junit "$build/tests.xml"

if [ "$full" = yes ]; then
  step "layout and likely bugs"
  bash "$root/tests/tidy.sh"
  step "build with sanitizers"
  configure asan
  cmake --build "$root/build/asan" -j "$(build_jobs)"
  step "test with sanitizers"
  (cd "$root" && ctest --preset asan -j "$(nproc)")
  step "what works in parallel, with ThreadSanitizer"
  configure tsan
  cmake --build "$root/build/tsan" -j "$(build_jobs)" --target test_core
  "$root/build/tsan/tests/test_core" --gtest_brief=1 --gtest_filter="$in_threads"
fi

printf '\nAll passed. Program: %s\nTest report: %s\n' "$build/plugin/cli/blossom" "$build/tests.xml"
