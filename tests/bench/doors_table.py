#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the doors themselves cost, beside the engine's work: Python, FreeCAD's shapes, the program.

    PYTHONPATH=build/release/plugin/python /usr/bin/python3 tests/bench/doors_table.py \
        build/release/plugin/cli/blossom

Prints the table in tests/bench/README.md. Pairs are medians of processor times; commands are processor times of the
program with reading and writing, the least of some runs.
"""

import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
    sys.path.append(folder)
import FreeCAD
import Import
import numpy as np
import Part

import blossom

V = FreeCAD.Vector
PAIRS = 1000  # of each kind
RUNS = 3
PROGRAM = sys.argv[1]


def milliseconds(ask):
    times = []
    for _ in range(PAIRS):
        start = time.process_time()
        ask()
        times.append(1000 * (time.process_time() - start))
    return f"{statistics.median(times):.2f} ms"


def rectangle(*corners):
    return Part.Face(Part.makePolygon([V(*c) for c in (*corners, corners[0])]))


def pairs():
    floor = rectangle((0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 0))
    wall = rectangle((5, -1, -5), (5, 10, -5), (5, 10, 5), (5, -1, 5))
    away = wall.translated(V(50, 0, 0))
    saddle = np.array([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]], float)
    flat = np.array([[(0, 0, 0.25), (0, 1, 0.25)], [(1, 0, 0.25), (1, 1, 0.25)]], float)
    yield "two plane faces of FreeCAD that cross", milliseconds(lambda: blossom.intersect(floor, wall))
    yield "with the edges as a shape of FreeCAD", milliseconds(
        lambda: blossom.intersect(floor, wall).to_part()
    )
    yield "two that are apart", milliseconds(lambda: blossom.intersect(floor, away))
    yield "a saddle and a plane as nets of numpy", milliseconds(lambda: blossom.intersect(saddle, flat))
    yield "two that are apart", milliseconds(lambda: blossom.intersect(saddle, flat + 5))


def seconds(*command):
    """Of the processor, in the system too."""

    def spent():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    times = []
    for _ in range(RUNS):
        before = spent()
        subprocess.run([PROGRAM, *map(str, command), "--quiet"], check=True)
        times.append(spent() - before)
    return min(times)


def planes(folder):
    file = folder / "bored.step"
    bores = [Part.makeCylinder(3, 40, V(8 + 11.5 * i, 8 + 11 * j, -5)) for i in range(21) for j in range(14)]
    block = Part.makeBox(260, 180, 30).cut(bores)
    block.exportStep(str(file))
    one = seconds("query", "plane", file, "--offsets", "15", "--json", folder / "one.json")
    many = seconds("query", "plane", file, "--offsets", "2:28:20", "--json", folder / "many.json")
    yield f"a plane through a STEP file of {len(block.Faces)} faces", f"{one:.2f} s"
    yield "twenty planes", f"{many:.2f} s, {many / one:.1f} times"


def clash(folder):
    document = FreeCAD.newDocument("Rig")
    ring = Part.makeCylinder(20, 15).cut(Part.makeCylinder(10, 15))
    for name, shape in (
        ("Bearing", ring),
        ("Shaft", Part.makeCylinder(10.05, 60, V(0, 0, -20))),
        ("Frame", Part.makeBox(100, 100, 10, V(50, 0, 0))),
        ("Foot", Part.makeBox(20, 20, 10, V(60, 10, 10))),
        ("Ball", Part.makeSphere(5, V(120, 60, 15))),
        ("Lid", Part.makeBox(100, 100, 3, V(50, 0, -5))),
        ("Box", Part.makeBox(30, 30, 30, V(200, 0, 0))),
        ("Inner", Part.makeSphere(5, V(215, 15, 15))),
    ):
        document.addObject("Part::Feature", name).Shape = shape
    file, table, page = folder / "rig.step", folder / "pairs.csv", folder / "rig.html"
    Import.export(document.Objects, str(file))
    took = seconds("clash", file, "--clearance", "3", "--table", table, "--html", page)
    row = next(line for line in table.read_text().splitlines() if line.startswith("Bearing,Shaft"))
    off = abs(float(row.split(",")[4]) / (math.pi * (10.05**2 - 10**2) * 15) - 1)
    yield "clashes of eight parts, with table and page", f"{took:.2f} s, volume off by {off:.0e}"
    yield "their page", f"{os.path.getsize(page) / 1000:.0f} kB"


print("| what | takes |\n|---|---|")
with tempfile.TemporaryDirectory() as name:
    for table in (pairs(), planes(Path(name)), clash(Path(name))):
        for what, took in table:
            print(f"| {what} | {took} |", flush=True)
