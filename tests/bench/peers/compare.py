#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scores the answers of all tools and compares their times with Blossom's.

    compare.py CASES_FOLDER OUT_FOLDER [SET]
    compare.py --each OUT_FOLDER

CASES_FOLDER has score.py and the folder SET (dev); OUT_FOLDER the .jsonl of occt_cases, sisl_cases.
Ratios are over the cases that the tool gets right: its seconds by Blossom's seconds. With --each
nothing is scored: a line for every case, with the milliseconds and numbers of curves of all tools.
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


def summary(row):
    if row is None:
        return "not run"
    if row["status"] != "ok":
        return row["status"]
    return f"{1e3 * row['seconds']:.2f} ({len(row['curves'])})"


def each(out):
    tools = {f.stem: {r["case"]: r for r in lines(f)} for f in sorted(out.glob("*.jsonl"))}
    print(f"{'ms (curves)':24}" + "".join(f"{tool:>20}" for tool in tools))
    for case in tools["blossom"]:
        told = [summary(rows.get(case)) for rows in tools.values()]
        print(f"{case:24}" + "".join(f"{text:>20}" for text in told))


def main():
    if sys.argv[1] == "--each":
        return each(pathlib.Path(sys.argv[2]))
    cases, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    name = sys.argv[3] if len(sys.argv) > 3 else "dev"
    peers = [file for file in sorted(out.glob("*.jsonl")) if not file.stem.startswith("blossom")]
    right = {file: scored(cases, name, file) for file in peers}
    for file in sorted(out.glob("blossom*.jsonl")):
        ours = {row["case"]: row for row in lines(file)}
        seconds = [row["seconds"] for row in ours.values()]
        print(
            f"{file.stem}: {sum(scored(cases, name, file).values())} of {len(ours)} right, "
            f"median {1e3 * statistics.median(seconds):.2f} ms, "
            f"longest {1e3 * max(seconds):.0f} ms, all {sum(seconds):.1f} s"
        )
        print("tool           right   median  quarter     last  slow  (ours/theirs)")
        for peer in peers:
            theirs = {row["case"]: row for row in lines(peer) if row["case"] in ours}
            print(compare(peer.stem, right[peer], theirs, ours))


if __name__ == "__main__":
    main()
