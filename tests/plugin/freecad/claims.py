# SPDX-License-Identifier: LGPL-2.1-or-later
"""Claims about FreeCAD's objects, for scripts that freecadcmd runs."""

import os
import sys
import traceback

import FreeCAD
import Part


def claim(what, holds):
    if not holds:
        raise AssertionError(what)
    print("holds:", what)


def near(a, b, within=1e-6):
    return abs(a - b) <= within


def valid(obj):
    return "Invalid" not in obj.State


def says(obj, text):
    """Whether the object shows an error with this text."""
    return not valid(obj) and text in obj.getStatusString()


def distance(shape, point):
    return Part.Vertex(FreeCAD.Vector(*point)).distToShape(shape)[0]


def samples(shape, count=7):
    """Points on all edges of a shape."""
    return [point for edge in shape.Edges for point in edge.discretize(Number=count)]


def run(*tests):
    """Each in a document of its own. freecadcmd would run a failing script again and exit with 0,
    so this ends the process."""
    code = 0
    for test in tests:
        print(f"-- {test.__name__}")
        document = FreeCAD.newDocument("Claims")
        document.UndoMode = 1
        try:
            test(document)
        except BaseException:
            traceback.print_exc(file=sys.stdout)
            code = 1
        if "Claims" in FreeCAD.listDocuments():
            FreeCAD.closeDocument("Claims")
    if code == 0:
        print("ALL CLAIMS HOLD")
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)
