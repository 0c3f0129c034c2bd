# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the README's lines in FreeCAD's window, on two selected faces of which one is in a part that
is placed elsewhere, and checks that the answer is where the faces are shown.

The window prints nothing, so claims go to BLOSSOM_CLAIMS; BLOSSOM_SHOT gets a picture of it.
"""

import os
import re
import runpy
import sys
import traceback

import FreeCAD
import FreeCADGui
import Part
from PySide2 import QtCore

claims = open(os.environ["BLOSSOM_CLAIMS"], "w", buffering=1)


def claim(what, holds):
    if not holds:
        raise AssertionError(what)
    print("holds:", what, file=claims)


def lines_of_readme():
    """All that it has in Python: of objects, of meshes, of what is selected."""
    with open(os.environ["BLOSSOM_README"]) as readme:
        blocks = re.findall(r"```python\n(.*?)```", readme.read(), re.DOTALL)
    selected = [i for i, block in enumerate(blocks) if "getSelectionEx" in block]
    claim("the README has lines for what is selected", selected == [2])
    claim("and for objects", "make" in blocks[0] and "meshes" in blocks[1])
    return blocks[0], blocks[1], "".join(blocks[2:])


def plane_in_a_moved_part(document):
    """The square [0, 10] x [-5, 5] at z = 0, in a part that lifts it by 3."""
    square = document.addObject("Part::Feature", "Square")
    square.Shape = Part.makePlane(10, 10, FreeCAD.Vector(0, -5, 0))
    part = document.addObject("App::Part", "Lifted")
    part.addObject(square)
    part.Placement.Base = FreeCAD.Vector(0, 0, 3)
    return part


def roof(document):
    """A face through the line y = 0, z = 3 that slopes by one in ten."""
    feature = document.addObject("Part::Feature", "Roof")
    corners = [(0, -5, 2.5), (10, -5, 2.5), (10, 5, 3.5), (0, 5, 3.5), (0, -5, 2.5)]
    feature.Shape = Part.Face(Part.makePolygon([FreeCAD.Vector(*c) for c in corners]))
    return feature


def check():
    document = FreeCAD.newDocument("Window")
    part, slope = plane_in_a_moved_part(document), roof(document)
    document.recompute()
    FreeCADGui.Selection.addSelection(document.Name, part.Name, "Square.Face1")
    FreeCADGui.Selection.addSelection(document.Name, slope.Name, "Face1")

    of_objects, of_meshes, of_selection = lines_of_readme()
    names = {}
    exec(of_selection, names)

    found = names["found"]
    package = os.environ["BLOSSOM_PACKAGE"]
    claim("the package is the add-on's", names["blossom"].__file__.startswith(package))
    claim("the answer is proven", found.status == "complete")
    claim("the planes meet in one curve", len(found.curves) == 1)
    points = found.curves[0].points
    claim("it is where the part has been put", max(abs(p[2] - 3) for p in points) < 1e-6)
    claim("and where the roof crosses it", max(abs(p[1]) for p in points) < 1e-6)
    claim("it is as long as both", abs(found.curves[0].length - 10) < 1e-6)
    claim("it is shown", document.Objects[-2].Shape.Edges[0].Length > 9.999)
    claim("and the strip, too", len(document.Objects[-1].Shape.Faces) == 1)
    check_objects(of_objects)
    check_meshes(of_meshes)


def check_meshes(lines):
    names = {}
    exec(lines, names)
    claim("a scan is cut", abs(sum(each.Length for each in names["cut"].Shape.Edges) - 40) < 1e-9)
    claim("and has no hole", names["whole"].Mesh.isSolid())
    FreeCAD.closeDocument(names["document"].Name)


def check_objects(lines):
    names = {}
    exec(lines, names)
    curves, bored, rounded = (names[name] for name in ("curves", "bored", "rounded"))
    claim(
        "curves",
        (curves.Status, curves.Curves) == ("complete", 2) and 25.13 < curves.Length < 25.14,
    )
    claim("a bore", 874.3 < bored.Volume < 874.4)
    claim("round edges", list(rounded.Rounded) == [1, 3])
    pairs, mesh = names["pairs"], names["mesh"]
    claim("a clash", pairs.Clashes == 1 and pairs.Pairs[0].startswith("Block and Rod: penetrates"))
    claim("all edges cut off", len(names["bevelled"].CutOff) == 12)
    claim("a mesh", mesh.Mesh.isSolid() and abs(mesh.Mesh.Volume - bored.Volume) < 10)
    claim("they have icons", all(each.ViewObject.Icon is not None for each in (curves, bored)))
    FreeCAD.closeDocument(names["document"].Name)


def check_example():
    FreeCAD.closeDocument("Window")
    example = runpy.run_path(os.environ["BLOSSOM_EXAMPLE"])
    claim("the example's answer is proven", example["found"].status == "complete")
    view = FreeCADGui.activeDocument().activeView()
    example["document"].Curves.ViewObject.LineColor = (0.8, 0.0, 0.2)
    example["document"].Curves.ViewObject.LineWidth = 4
    FreeCADGui.updateGui()
    view.viewIsometric()
    view.fitAll()


def finish():
    """From the event loop, once the window has been painted."""
    FreeCADGui.getMainWindow().screen().grabWindow(0).save(os.environ["BLOSSOM_SHOT"])
    claim("there is a picture of the window", os.path.getsize(os.environ["BLOSSOM_SHOT"]) > 10000)
    print("ALL CLAIMS HOLD", file=claims)


def guarded(work):
    try:
        work()
    except BaseException:
        traceback.print_exc(file=claims)
        os._exit(1)  # a dialog could hold the process


guarded(check)
guarded(check_example)
QtCore.QTimer.singleShot(1500, lambda: (guarded(finish), os._exit(0)))
