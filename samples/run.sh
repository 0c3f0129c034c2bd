#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs what is missing, builds the program and the samples, runs them and says where results are.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../tests/support/setup.sh"

step "packages"
install_packages "${build_packages[@]}"

step "configure"
configure release

step "build"
cmake --build "$build" -j "$(build_jobs)" --target blossom samples

step "sample: evaluate by blossom"
"$build/samples/01_evaluate_by_blossom"

step "sample: pictures of the papers"
results=$root/build/samples
"$build/samples/03_pictures_of_the_papers" "$results"

step "sample: a boat"
bash "$root/samples/boat.sh" "$build/plugin/cli/blossom" "$build/samples" "$results"

step "sample: an aircraft"
bash "$root/samples/aircraft.sh" "$build/plugin/cli/blossom" "$build/samples" "$results"

printf '\nAll samples ran. Program: %s\nResults: %s\n' "$build/plugin/cli/blossom" "$results"
ls -1 "$results"
