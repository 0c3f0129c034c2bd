#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Measures subdivision on one core and writes the table in core/blossom/README.md anew.
#
# usage: blossom_table.sh [BUILD]   (a folder for the build, build/bench below the project)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/bench}

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBLOSSOM_BUILD_BENCH=ON
cmake --build "$build" --parallel "${JOBS:-2}" --target bench_subdivision

rows='^(printed_9|closed_form|de_casteljau_plain|de_casteljau_lanes|eigen|occt_copy|occt_copy_and_segment)/'
rows+='|^(single|pieces_matrices|pieces_pyramid|pieces_within|grid8|triangles_t4|triangles_t1|triangle_printed_14)/'
taskset -c 0 "$build/tests/bench/bench_subdivision" --benchmark_filter="$rows" \
  --benchmark_min_time=0.02 --benchmark_repetitions=9 \
  --benchmark_enable_random_interleaving=true \
  --benchmark_out="$build/subdivision.json" --benchmark_out_format=json
python3 "$root/tests/bench/blossom_table.py" "$build/subdivision.json" "$root/core/blossom/README.md"
