#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blossom beside FreeCAD's own tools, on the same shapes in one run: Section, slice, Cut, Fillet.

    PYTHONPATH=build/release/plugin/python /usr/bin/python3 tests/bench/freecad_table.py

Prints the table in plugin/freecad/README.md. Times are medians of processor times, of all threads
together, from shapes of Part to shapes of Part. Errors: of curves, the largest distance from the faces; of solids, the part
of the volume by which one is off what follows by hand.
"""

import math
import statistics
import sys
import time

for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
    sys.path.append(folder)
import FreeCAD
import Part

import blossom

V = FreeCAD.Vector
RUNS = 7
PLACES = 200  # on each edge
FEW_PLACES = 9  # where to measure takes long


def timed(work):
    """The result and the median of its processor times in milliseconds; the first counts."""
    times = []
    for _ in range(RUNS):
        start = time.process_time()
        made = work()
        times.append(1000 * (time.process_time() - start))
    return made, statistics.median(times)


def wave(height):
    points = [[V(x, y, height(x, y)) for y in range(11)] for x in range(11)]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface.toShape()


def curve_error(curves, faces):
    points = [p for edge in curves.Edges for p in edge.discretize(Number=PLACES)]
    surfaces = [face.Surface for face in faces]
    return max(
        (p.distanceToPoint(s.value(*s.parameter(p))) for p in points for s in surfaces), default=0.0
    )


def sections():
    sea = wave(lambda x, y: math.sin(0.6 * x) * math.cos(0.5 * y))
    sail = wave(lambda x, y: 0.2 * (x - 5) + 0.3 * math.sin(y))
    faces = (sea, sail)
    for name, work in (
        ("Section", lambda: sea.section(sail)),
        ("Blossom", lambda: blossom.intersect(sea, sail).to_part()),
    ):
        made, took = timed(work)
        yield "two waves, B-splines", name, took, len(made.Edges), f"{curve_error(made, faces):.1e}"


def slices():
    body = wave(lambda x, y: 3 + math.sin(0.9 * x) * math.cos(0.8 * y)).extrude(V(0, 0, -8))
    skin = Part.makeShell(body.Faces)
    heights = [-4.5 + 0.35 * i for i in range(20)]

    def theirs():
        return Part.makeCompound([w for z in heights for w in body.slice(V(0, 0, 1), z)])

    def ours():
        model = blossom.shape(body)
        return Part.makeCompound([model.section((0, 0, z), (0, 0, 1)).to_part() for z in heights])

    for name, work in (("slice", theirs), ("Blossom", ours)):
        made, took = timed(work)
        points = [p for edge in made.Edges for p in edge.discretize(Number=FEW_PLACES)]
        off = max(Part.Vertex(p).distToShape(skin)[0] for p in points)
        yield "20 planes through a wavy body", name, took, len(made.Edges), f"{off:.1e}"


def cuts():
    count, radius = 8, 1.0
    block = Part.makeBox(40, 40, 10)
    bores = [
        Part.makeCylinder(radius, 20, V(5 * i + 2.5, 5 * j + 2.5, -5))
        for i in range(count)
        for j in range(count)
    ]
    right = 40 * 40 * 10 - len(bores) * math.pi * radius**2 * 10
    for name, work in (
        ("Cut", lambda: block.cut(bores)),
        ("Blossom", lambda: blossom.solid("cut", block, *bores).to_part()),
    ):
        made, took = timed(work)
        error = abs(made.Volume / right - 1)
        yield f"{len(bores)} bores in a block", name, took, len(made.Faces), f"{error:.1e}"


def fillets():
    block = Part.makeBox(40, 40, 10)
    edges = list(range(1, 13))
    radius = 2.0
    # The rounded box: inner box, slabs, quarters of cylinders along edges, eighths of a ball.
    a, b, c = (side - 2 * radius for side in (40, 40, 10))
    right = (
        a * b * c + 2 * radius * (a * b + b * c + c * a)
        + math.pi * radius**2 * (a + b + c) + 4 / 3 * math.pi * radius**3
    )  # fmt: skip
    for name, work in (
        ("makeFillet", lambda: block.makeFillet(radius, block.Edges)),
        ("Blossom", lambda: blossom.fillet(block, edges, radius=radius).to_part()),
    ):
        made, took = timed(work)
        yield "12 edges rounded", name, took, len(made.Faces), f"{abs(made.Volume / right - 1):.1e}"


print("| task | by | ms | edges or faces | error |\n|---|---|---|---|---|")
for table in (sections, slices, cuts, fillets):
    for task, name, took, count, error in table():
        print(f"| {task} | {name} | {took:.1f} | {count} | {error} |")
