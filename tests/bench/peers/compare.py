#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scores the answers of all tools and compares their times with Blossom's.

    compare.py CASES_FOLDER OUT_FOLDER [SET]

CASES_FOLDER has score.py and the folder SET (dev); OUT_FOLDER the .jsonl of occt_cases, sisl_cases.
Ratios are over the cases that the tool gets right: its seconds by Blossom's seconds.
"""
import json
import pathlib
import statistics
import subprocess
import sys


def lines(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def scored(cases, name, answers):
    out = answers.with_suffix(".scored")
    subprocess.run(
        ["/usr/bin/python3", cases / "score.py", cases / name, answers, "--out", out],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    return {row["case"]: row["topology_ok"] and row["accuracy_ok"] for row in lines(out)}


def compare(tool, right, theirs, ours):
    both = [case for case in theirs if right.get(case)]
    ratios = sorted(theirs[case]["seconds"] / ours[case]["seconds"] for case in both)
    slow = [c for c in both if ours[c]["seconds"] > 1.2 * theirs[c]["seconds"] + 2e-4]
    if not ratios:
        return f"{tool:14} {0:5}"
    quarter, last = ratios[len(ratios) // 4], ratios[0]
    listed = ", ".join(
        f"{c} {1e3 * ours[c]['seconds']:.1f}/{1e3 * theirs[c]['seconds']:.1f} ms" for c in slow
    )
    median = statistics.median(ratios)
    return f"{tool:14} {len(both):5} {median:8.1f} {quarter:8.1f} {last:8.2f} {len(slow):5}  {listed}"


def main():
    cases, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    name = sys.argv[3] if len(sys.argv) > 3 else "dev"
    ours = {row["case"]: row for row in lines(out / "blossom.jsonl")}
    seconds = [row["seconds"] for row in ours.values()]
    right = sum(scored(cases, name, out / "blossom.jsonl").values())
    print(
        f"blossom: {right} of {len(ours)} right, median {1e3 * statistics.median(seconds):.2f} ms, "
        f"longest {1e3 * max(seconds):.0f} ms, all {sum(seconds):.1f} s"
    )
    print("tool           right   median  quarter     last  slow  (ours/theirs)")
    for answers in sorted(out.glob("*.jsonl")):
        if answers.stem == "blossom":
            continue
        theirs = {row["case"]: row for row in lines(answers) if row["case"] in ours}
        print(compare(answers.stem, scored(cases, name, answers), theirs, ours))


if __name__ == "__main__":
    main()
