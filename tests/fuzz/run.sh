#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Builds a fuzzing target, or all of them, and lets it run:
#
#   tests/fuzz/run.sh TARGET|all SECONDS [options of libFuzzer]      seconds of each target
#
# Inputs that reach something new are kept in build/fuzz/found/TARGET, from where the next run goes on.
# One that ends a run is kept in build/fuzz/findings/TARGET, as are those that take long; the exit code
# is then 1, after the other targets have had their time.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/setup.sh"

known=$(sed -n 's/^foreach(name \(surfaces .*\))$/\1/p' "$root/tests/fuzz/CMakeLists.txt")
if [ $# -lt 2 ] || [[ " $known all " != *" $1 "* ]] || ! [[ $2 =~ ^[0-9]+$ ]]; then
  echo "usage: tests/fuzz/run.sh TARGET SECONDS [options of libFuzzer]; targets: $known; or all" >&2
  trap - EXIT
  exit 2
fi
read -ra targets <<<"$known"
if [ "$1" != all ]; then targets=("$1"); fi
seconds=$2
shift 2

step "packages"
install_packages "${build_packages[@]}" clang-16 libclang-rt-16-dev llvm-16
step "build"
configure fuzz
fuzz=$root/build/fuzz
cmake --build "$fuzz" -j "$(build_jobs)" --target "${targets[@]/#/fuzz_}"

# Processor time is limited by the target; the limit on time is for what waits. Children have no leaks
# that count: they end.
export ASAN_SYMBOLIZER_PATH=${ASAN_SYMBOLIZER_PATH-$(command -v llvm-symbolizer-16)}
run_target() {
  local target=$1 options=()
  shift
  local found=$fuzz/found/$target findings=$fuzz/findings/$target words=$root/tests/fuzz/words/$target.dict
  mkdir -p "$found" "$findings"
  if [ -f "$words" ]; then options+=("-dict=$words"); fi
  "$fuzz/tests/fuzz/fuzz_$target" "$found" "$root/tests/fuzz/seeds/$target" "${options[@]}" \
    -max_total_time="$seconds" -timeout=300 -rss_limit_mb=3000 -max_len=65536 -print_final_stats=1 \
    -artifact_prefix="$findings/" "$@"
}
ended=()
for target in "${targets[@]}"; do
  step "fuzz $target"
  run_target "$target" "$@" || ended+=("$target")
done
if [ "${#ended[@]}" -gt 0 ]; then
  step "findings of ${ended[*]}, in build/fuzz/findings"
  exit 1
fi
