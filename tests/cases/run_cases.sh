#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs the certified intersection cases and checks the scores.
#
#   BLOSSOM_TEST_DATA=folder tests/cases/run_cases.sh    the folder holds cases/ with its programs
#
# All cases in the form that the error bound chooses, then once more from monomial form. There high
# degrees lose too many digits to end by themselves, and nothing is asked of them: a time limit.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cases=${BLOSSOM_TEST_DATA:?set it to the folder that holds cases/}/cases
program=${BLOSSOM_PROGRAM:-$root/build/release/plugin/cli/blossom}
results=$root/results/cases
python=/usr/bin/python3
mkdir -p "$results"

limits=(--time-limit 20)
for form in auto monomial; do
  echo "== certified cases, form $form"
  $python "$cases/run_suite.py" "$program" "$cases/dev" "$results/$form.jsonl" --limit 30 \
    -- --form "$form" "${limits[@]}"
  $python "$cases/score.py" "$cases/dev" "$results/$form.jsonl" --out "$results/$form.scored.jsonl" \
    --table
  limits=(--time-limit 6)
done
$python "$root/tests/cases/check_scores.py" "$cases/dev" "$results"
echo "Results: $results"
