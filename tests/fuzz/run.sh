#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Builds a fuzzing target and lets it run:  tests/fuzz/run.sh TARGET SECONDS [options of libFuzzer]
#
# Inputs that reach something new are kept in build/fuzz/found/TARGET, from where the next run goes on.
# One that ends a run is kept in build/fuzz/findings/TARGET, as are those that take long; the exit code
# is then that of libFuzzer.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/setup.sh"

targets=$(sed -n 's/^foreach(name \(surfaces .*\))$/\1/p' "$root/tests/fuzz/CMakeLists.txt")
if [ $# -lt 2 ] || [[ " $targets " != *" $1 "* ]]; then
  echo "usage: tests/fuzz/run.sh TARGET SECONDS [options of libFuzzer]; targets: $targets" >&2
  exit 2
fi
target=$1 seconds=$2
shift 2

step "packages"
install_packages "${build_packages[@]}" clang-16 libclang-rt-16-dev llvm-16
step "build"
configure fuzz
cmake --build "$root/build/fuzz" -j "$(build_jobs)" --target "fuzz_$target"

step "fuzz $target"
fuzz=$root/build/fuzz
found=$fuzz/found/$target findings=$fuzz/findings/$target
mkdir -p "$found" "$findings"
options=()
words=$root/tests/fuzz/words/$target.dict
if [ -f "$words" ]; then options+=("-dict=$words"); fi
# Processor time is limited by the target; the limit on time is for what waits. Children have no leaks
# that count: they end.
export ASAN_SYMBOLIZER_PATH=${ASAN_SYMBOLIZER_PATH-$(command -v llvm-symbolizer-16)}
exec "$fuzz/tests/fuzz/fuzz_$target" "$found" "$root/tests/fuzz/seeds/$target" "${options[@]}" \
  -max_total_time="$seconds" -timeout=300 -rss_limit_mb=3000 -max_len=65536 -print_final_stats=1 \
  -artifact_prefix="$findings/" "$@"
