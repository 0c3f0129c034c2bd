# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stations of the tour: with mouse and keyboard, from edges that are clicked to the part reopened."""

import os

import FreeCAD
import FreeCADGui
from PySide2 import QtWidgets

from hands import (
    SETTLED, V, claim, click, found, look, new_document, press, said, widget, write,
)  # fmt: skip


def bracket(document):
    """Two plates at a right angle, the lower one with a hole."""
    for name, size in (("Base", (60, 40, 8)), ("Wall", (8, 40, 40))):
        plate = document.addObject("Part::Box", name)
        plate.Length, plate.Width, plate.Height = size
    angle = document.addObject("Part::Fuse", "Angle")
    angle.Base, angle.Tool, angle.Refine = document.Base, document.Wall, True
    hole = document.addObject("Part::Cylinder", "Hole")
    hole.Radius, hole.Height, hole.Placement.Base = 6, 30, V(38, 20, -5)
    cut = document.addObject("Part::Cut", "Bracket")
    cut.Base, cut.Tool = angle, hole
    document.recompute()
    return cut


def rounded_bracket():
    document = new_document("Bracket")
    part = bracket(document)
    look(document)
    yield SETTLED
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.runCommand("Blossom_Fillet")
    yield lambda: "Take selection" in said()
    click(document, V(60, 20, 8))
    click(document, V(8, 20, 40), also=True)
    widget(QtWidgets.QGroupBox, "BlossomEdges").findChild(QtWidgets.QPushButton).click()
    yield found
    fillet = document.Fillet
    claim("two edges are clicked", len(fillet.Rounded) == 2)
    write("BlossomRadius", "0.2 in")
    yield lambda: found() and fillet.Radius.Value == 5.08
    write("BlossomRadius", "45")
    yield lambda: "the largest radius is 7.99999 mm" in said()
    write("BlossomRadius", "4")
    yield lambda: found() and fillet.Radius.Value == 4
    press("Ok")
    claim("the part is hidden behind it", fillet.Visibility and not part.Visibility)
    document.undo()
    claim("one step takes it back", document.getObject("Fillet") is None and part.Visibility)
    document.redo()
    document.Base.Length = 80
    document.recompute()
    taken = part.Shape.Volume - document.Fillet.Volume
    claim("a longer part is rounded, too", abs(taken - 2 * 40 * (16 - 4 * 3.14159265)) < 1e-3)
    yield from edited_after_reopening(document, document.Fillet.Volume)


def edited_after_reopening(document, volume):
    file = os.path.join(os.environ["BLOSSOM_SHOTS"], "bracket.FCStd")
    document.saveAs(file)
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(file)
    yield SETTLED
    document.Fillet.touch()
    document.recompute()
    claim("reopened it is the same", abs(document.Fillet.Volume - volume) < 1e-9 * volume)
    document.removeObject("Bracket")
    document.recompute()
    FreeCADGui.getDocument(document.Name).setEdit("Fillet")
    yield lambda: "Bracket was deleted" in said()
    press("Cancel")
    claim("without its part it stays as it was", document.Fillet.Shape.Volume > 30000)
