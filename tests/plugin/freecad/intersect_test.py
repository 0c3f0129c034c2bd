# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the example inside freecadcmd and checks what it found against FreeCAD's own Part."""

import os
import runpy
import sys
import traceback

import FreeCAD
import Part


def claim(what, holds):
    if not holds:
        raise AssertionError(what)
    print("holds:", what)


def distance(face, point):
    return Part.Vertex(FreeCAD.Vector(*point)).distToShape(face)[0]


def check(example):
    found, faces = example["found"], (example["face_a"], example["face_b"])
    claim("the answer is proven", found.status == "complete")
    claim("there are curves", len(found.curves) > 0)

    # The faces as their objects have them, the one in the part moved by hand.
    document = example["document"]
    sea, sail = document.Sea.Shape, document.Sail.Shape.copy()
    sail.Placement = document.Boat.Placement.multiply(sail.Placement)
    for curve in found.curves:
        every = max(1, len(curve.points) // 12)
        worst = max(distance(f, p) for f in (sea, sail) for p in curve.points[::every])
        claim("points lie on both faces, where the part has put them", worst < 1e-6)
        for face, uv in zip(faces, (curve.uv_a, curve.uv_b)):
            there = face.valueAt(*uv[0])
            claim(
                "parameters are the face's own",
                there.distanceToPoint(FreeCAD.Vector(*curve.points[0])) < 1e-6,
            )
        claim("face numbers start at 1", (curve.face_a, curve.face_b) == (1, 1))

    shape = example["document"].getObject("Curves").Shape
    claim("the shown shape is valid", shape.isValid())
    claim("it has an edge for each curve", len(shape.Edges) == len(found.curves))
    total = sum(curve.length for curve in found.curves)
    claim("of the same length", abs(shape.Length - total) < 1e-4 * total)

    theirs = sea.section(sail)
    claim("Part's section has that length, too", abs(theirs.Length - total) < 1e-3 * total)


code = 0
try:
    check(runpy.run_path(os.environ["BLOSSOM_EXAMPLE"]))
    print("ALL CLAIMS HOLD")
except BaseException:
    traceback.print_exc(file=sys.stdout)
    code = 1
# freecadcmd would run a failing script again and then exit with 0.
sys.stdout.flush()
sys.stderr.flush()
os._exit(code)
