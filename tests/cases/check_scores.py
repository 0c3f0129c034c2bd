#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the certified cases have to show.

usage: check_scores.py CASES RESULTS
CASES holds cases.jsonl, RESULTS auto.scored.jsonl and monomial.scored.jsonl. Ends with 1, and a
line for each broken claim, if one does not hold.
"""
import json
import os
import sys

PROVEN = ("levels", "bspline", "rational", "freeform")
SHARE = 0.95
SHARE_OF_ALL = 0.98


def lines(path):
    with open(path) as file:
        return [json.loads(line) for line in file]


def right(score):
    return score["topology_ok"] and score["accuracy_ok"]


def polynomial_degree(path):
    """The largest degree of a face in BREP text, or None if it is rational."""
    words = open(path).read().split()
    start = words.index("Surfaces") + 2
    bezier = words[start] == "8"
    rational_u, rational_v = words[start + 1:start + 3]
    degrees = words[start + 3:start + 5] if bezier else words[start + 5:start + 7]
    return None if "1" in (rational_u, rational_v) else max(int(word) for word in degrees)


def deep_loop(case):
    return (case["family"] == "small_loops" and case["expected"]["closed"] > 0
            and case.get("depth") is not None and case["depth"] > case["tolerance"])


def check_family(name, scores, broken):
    good = [score for score in scores if right(score)]
    proven = [score for score in good if score.get("claim") == "complete"]
    print(f"{name}: {len(good)} right of {len(scores)}, {len(proven)} of them proven complete")
    if len(good) < SHARE * len(scores):
        broken.append(f"{name}: fewer than {SHARE:.0%} right")
    if len(proven) < SHARE * len(good):
        broken.append(f"{name}: fewer than {SHARE:.0%} of the right ones proven complete")


def main():
    folder, results = sys.argv[1:3]
    cases = {case["name"]: case for case in lines(os.path.join(folder, "cases.jsonl"))}
    scores = lines(os.path.join(results, "auto.scored.jsonl"))
    monomial = {s["case"]: s for s in lines(os.path.join(results, "monomial.scored.jsonl"))}
    broken = []

    for family in PROVEN:
        check_family(family, [s for s in scores if s["family"] == family], broken)
    check_family("loops deeper than the tolerance",
                 [s for s in scores if deep_loop(cases[s["case"]])], broken)
    good = sum(right(score) for score in scores)
    print(f"all: {good} right of {len(scores)}")
    if good < SHARE_OF_ALL * len(scores):
        broken.append(f"all: fewer than {SHARE_OF_ALL:.0%} right")
    for score in scores + list(monomial.values()):
        if score.get("false_complete"):
            broken.append(f"{score['case']}: called complete and is not")
        if score["status"] not in ("ok", "stopped"):
            broken.append(f"{score['case']}: {score['status']}")

    compared = 0
    for score in scores:
        case = cases[score["case"]]
        degrees = [polynomial_degree(os.path.join(folder, case[side])) for side in "ab"]
        if None in degrees or max(degrees) > 5 or not right(score):
            continue
        compared += 1
        if not right(monomial[score["case"]]):
            broken.append(f"{score['case']}: right, but not from monomial form")
    print(f"from monomial form: {compared} polynomial cases up to degree 5 compared")

    for line in broken:
        print("BROKEN", line)
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()
