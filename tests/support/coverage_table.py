#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints gcovr's summary by folder. coverage_table.py SUMMARY.json LEAST_PERCENT"""
import json
import os
import sys


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        files = json.load(file)["files"]
    least = float(sys.argv[2])
    rooms = {}
    for entry in files:
        room = os.path.dirname(entry["filename"]).removesuffix("/detail")
        covered, lines = rooms.get(room, (0, 0))
        rooms[room] = (covered + entry["line_covered"], lines + entry["line_total"])
    total = [sum(column) for column in zip(*rooms.values())]
    for room, (covered, lines) in sorted(rooms.items()) + [("all of core", tuple(total))]:
        if lines:
            print(f"{100 * covered / lines:6.1f} %  {covered:6d} of {lines:6d}  {room}")
    return 0 if total and 100 * total[0] >= least * total[1] else 1


if __name__ == "__main__":
    sys.exit(main())
