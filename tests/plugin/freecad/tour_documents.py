# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stations of the tour: what becomes of documents, by deletions, files, and without the engine."""

import os

import FreeCAD
import FreeCADGui
from PySide2 import QtWidgets

from hands import (
    SETTLED, V, claim, found, gone, look, new_document, press, said, select, widget, window,
)  # fmt: skip


def first_steps():
    """What is said where nothing is chosen, and where a section begins."""
    document = new_document("Steps")
    block = document.addObject("Part::Box", "Block")
    block.Placement.Base = V(3, 4, 100)
    document.recompute()
    look(document)
    FreeCADGui.runCommand("Blossom_Intersection")
    yield lambda: "Take selection" in said()
    claim("a panel has its own words", said().startswith("Faces: a face or an edge is wanted"))
    press("Cancel")
    select(document, ("Block", ""))
    FreeCADGui.runCommand("Blossom_Section")
    yield found
    claim("a plane goes through the middle", document.Section.Point == V(8, 9, 105))
    claim("and cuts it", document.Section.Closed == 1)
    press("Cancel")
    select(document, ("Block", ""), ("Block", ""))
    FreeCADGui.runCommand("Blossom_Solid")
    yield lambda: "Take selection" in said()
    claim("what is missing has its label", said().startswith("Tools: a solid is wanted"))
    press("Cancel")


def deleted():
    document = new_document("Deleted")
    document.addObject("Part::Box", "Block")
    document.addObject("Part::Plane", "Knife").Placement.Base = V(-1, -1, 5)
    document.recompute()
    select(document, ("Block", ""), ("Knife", ""))
    FreeCADGui.runCommand("Blossom_Section")
    yield found
    cut = document.Section
    claim("a flat face is the plane", cut.Plane[0][0].Name == "Knife")
    claim("and cuts the other", cut.Shape.BoundBox.ZMin > 4.9 and cut.Closed == 1)
    document.removeObject("Section")
    widget(QtWidgets.QWidget, "BlossomOffset").setProperty("rawValue", 1)
    yield gone
    claim("an object may be deleted under its panel", gone())
    yield from deleted_from_a_container()


def deleted_from_a_container():
    """What the object was made of is hidden, and shown again by itself, not by its container."""
    document = FreeCAD.ActiveDocument
    holder = document.addObject("App::Part", "Holder")
    holder.addObject(document.Block)
    document.recompute()
    for end in ("Ok", "Cancel"):
        select(document, ("Holder", "Block.Edge1"))
        FreeCADGui.runCommand("Blossom_Fillet")
        yield found
        claim("what is rounded is hidden", not document.Block.Visibility)
        press(end)
        if end == "Ok":
            select(document, ("Fillet", ""))
            FreeCADGui.runCommand("Std_Delete")
        yield SETTLED
        claim(f"and shown again after {end}", document.Block.Visibility and holder.Visibility)
    document.addObject("Part::Box", "Other")
    document.recompute()
    select(document, ("Holder", "Block.Edge1"))
    FreeCADGui.runCommand("Blossom_Fillet")
    yield found
    select(document, ("Other", "Edge1"))
    widget(QtWidgets.QGroupBox, "BlossomEdges").findChild(QtWidgets.QPushButton).click()
    yield lambda: found() and not document.Other.Visibility
    claim("what is no longer rounded is shown", document.Block.Visibility)
    press("Cancel")
    copy = document.addObject("App::Link", "Copy")
    copy.LinkedObject, copy.Placement.Base = holder, V(20, 0, 0)
    document.recompute()
    select(document, ("Copy", "Block.Edge1"))
    FreeCADGui.runCommand("Blossom_Fillet")
    yield found
    claim("of a link the link is hidden, not the original", not copy.Visibility and document.Block.Visibility)
    claim("and it is where the link is", document.Objects[-1].Shape.BoundBox.XMin > 19.9)
    press("Cancel")


def reopened():
    from freecad.blossom import make

    document = new_document("Saved")
    block = document.addObject("Part::Box", "Block")
    rod = document.addObject("Part::Cylinder", "Rod")
    rod.Placement.Base = V(5, 5, 5)
    bored = make.solid(document, "cut", block, rod)
    make.check(document, block)
    document.recompute()
    volume, file = bored.Volume, os.path.join(os.environ["BLOSSOM_SHOTS"], "saved.FCStd")
    document.saveAs(file)
    FreeCAD.closeDocument(document.Name)
    yield SETTLED
    document = FreeCAD.openDocument(file)
    yield SETTLED
    bored, view = document.Solid, document.Solid.ViewObject
    claim("it is there again", bored.Volume == volume and len(bored.Shape.Solids) == 1)
    claim("its view knows it", view.Proxy.Object.Name == "Solid")
    claim("and has its icon", view.Proxy.getIcon().endswith("Solid.svg"))
    claim("and its parents", [each.Name for each in view.claimChildren()] == ["Block", "Rod"])
    claim("colours are kept", len(document.Check.ViewObject.DiffuseColor) == 6)
    FreeCADGui.getDocument(document.Name).setEdit("Solid")
    yield found
    widget(QtWidgets.QComboBox, "BlossomOperation").setCurrentText("fuse")
    yield lambda: found() and bored.Volume > 1000
    press("Ok")
    claim("it can be edited", bored.Operation == "fuse" and "Invalid" not in bored.State)


def without_engine():
    """The panel tells why nothing works, and promises no program that is not there."""
    from freecad.blossom import door

    document = new_document("NoEngine")
    document.addObject("Part::Box", "Block")
    document.recompute()
    usual, door.choice = door.choice, lambda: door.Choice("", "there is no package, no program", "")
    select(document, ("Block", ""))
    FreeCADGui.runCommand("Blossom_Check")
    yield lambda: "engine is not here" in said()
    words = [each.text() for each in window().findChildren(QtWidgets.QLabel) if each.isVisible()]
    claim("no program is promised", not any("works on files" in each for each in words))
    press("Cancel")
    door.choice = usual
