# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stations of the tour: a command each."""

import math

import FreeCAD
import FreeCADGui
import Part
from PySide2 import QtWidgets

from hands import (
    SETTLED, V, claim, found, look, new_document, picture, press, said, select, wave, widget,
)  # fmt: skip


def intersection():
    document = new_document("Intersection")
    wave(document, "Sea", lambda x, y: math.sin(0.6 * x) * math.cos(0.5 * y))
    sail = wave(document, "Sail", lambda x, y: 0.2 * (x - 5) + 0.3 * math.sin(y))
    document.Sea.ViewObject.ShapeColor = (0.55, 0.75, 0.95)
    sail.ViewObject.ShapeColor = (0.97, 0.87, 0.66)
    boat = document.addObject("App::Part", "Boat")
    boat.addObject(sail)
    boat.Placement = FreeCAD.Placement(V(0, 2.5, 0.5), FreeCAD.Rotation(V(0, 0, 1), 30))
    document.recompute()
    look(document)
    select(document, ("Sea", "Face1"), ("Boat", "Sail.Face1"))
    FreeCADGui.runCommand("Blossom_Intersection")
    yield found
    look(document, 0.6)  # containers have an origin with long axes
    yield SETTLED
    claim("the panel says that nothing is missing", "complete" in said())
    claim("and lengths with their unit", " mm" in said().split("Length")[1].split("Deviation")[0])
    picture("intersection")
    press("Ok")
    curves = document.Objects[-1]
    claim("there are curves", curves.Curves > 0 and "Invalid" not in curves.State)
    placed = sail.Shape.copy()
    placed.Placement = boat.Placement
    points = [point for edge in curves.Shape.Edges for point in edge.discretize(Number=9)]
    faces = (document.Sea.Shape, placed)
    off = max(Part.Vertex(point).distToShape(face)[0] for point in points for face in faces)
    claim("they are where the faces are shown", off < 1e-6)
    claim("one step can be undone", document.UndoNames[0] == "Intersection")
    document.undo()
    claim("and takes the object away", document.getObject("Intersection") is None)
    document.redo()
    boat.Placement.Base = V(0.5, 2, 0.25)
    length = document.Intersection.Length
    document.recompute()
    claim("curves follow the container", document.Intersection.Length != length)
    yield SETTLED


def trim():
    document = new_document("Trim")
    block = document.addObject("Part::Box", "Block")
    rod = document.addObject("Part::Cylinder", "Rod")
    block.Length, rod.Radius, rod.Height = 16, 3, 30
    rod.Placement = FreeCAD.Placement(V(4, 5, -8), FreeCAD.Rotation(V(0, 1, 0), 25))
    document.recompute()
    look(document)
    select(document, ("Block", ""), ("Rod", ""))
    FreeCADGui.runCommand("Blossom_Trim")
    yield found
    look(document)
    yield SETTLED
    trimmed = document.Objects[-1]
    claim("all pieces are shown", trimmed.Pieces == len(trimmed.Shape.Faces) == 8)
    claim("and have colours", len(set(trimmed.ViewObject.DiffuseColor)) > 2)
    claim("what is cut is hidden", not block.Visibility and not rod.Visibility)
    picture("trim")
    widget(QtWidgets.QPushButton, "BlossomPick").click()
    yield SETTLED
    yield found
    faces = sorted(range(8), key=lambda i: trimmed.Shape.Faces[i].CenterOfMass.z)
    for index in faces[-2:]:
        p = trimmed.Shape.Faces[index].CenterOfMass
        face = f"Face{index + 1}"
        FreeCADGui.Selection.addSelection(document.Name, trimmed.Name, face, p.x, p.y, p.z)
    widget(QtWidgets.QPushButton, "BlossomPick").click()
    yield lambda: found() and trimmed.Keep == "picked" and len(trimmed.Shape.Faces) == 2
    press("Ok")
    claim(
        "the clicked pieces are kept",
        len(trimmed.Shape.Faces) == 2 and trimmed.Shape.BoundBox.ZMin > 9,
    )
    document.undo()
    claim("undo shows what was cut", block.Visibility and rod.Visibility)
    yield SETTLED


def with_top_chosen(name):
    """A document with a block of 30 x 20 x 12 whose upper face is selected."""
    document = new_document(name)
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = 30, 20, 12
    document.recompute()
    look(document)
    select(document, ("Block", "Face6"))
    return document


def fillet():
    document = with_top_chosen("Fillet")
    FreeCADGui.runCommand("Blossom_Fillet")
    yield found
    look(document)
    panel_radius = widget(QtWidgets.QWidget, "BlossomRadius")
    panel_radius.setProperty("rawValue", 3)
    yield lambda: found() and document.Fillet.Volume < 30 * 20 * 12 - 100
    yield SETTLED
    picture("fillet")
    panel_radius.setProperty("rawValue", 300)
    yield lambda: "radius" in said()
    press("Ok")
    claim("what cannot be made keeps the panel open", FreeCADGui.Control.activeDialog())
    claim("and says why", "the largest radius is" in said())
    panel_radius.setProperty("rawValue", 3)
    yield found
    press("Ok")
    claim(
        "four edges are rounded",
        len(document.Fillet.Rounded) == 4 and not FreeCADGui.Control.activeDialog(),
    )
    claim("and it is a valid solid", document.Fillet.Shape.isValid())
    FreeCADGui.getDocument(document.Name).setEdit("Fillet")
    yield found
    widget(QtWidgets.QWidget, "BlossomRadius").setProperty("rawValue", 1)
    yield lambda: found() and document.Fillet.Volume > 30 * 20 * 12 - 100
    press("Cancel")
    claim(
        "Cancel takes an edit back",
        document.Fillet.Radius.Value == 3 and len(document.Objects) == 2,
    )
    yield SETTLED


def check():
    document = new_document("Check")
    shape = Part.makeShell(Part.makeBox(20, 20, 10).Faces[:5])
    corners = [(0, 0), (20, 20), (20, 0), (0, 20), (0, 0)]
    crossed = Part.makePolygon([V(x, y, 16) for x, y in corners])
    bow = Part.Face(Part.Plane(V(0, 0, 16), V(0, 0, 1)), crossed)
    document.addObject("Part::Feature", "Import").Shape = Part.makeCompound([shape, bow])
    document.recompute()
    look(document)
    select(document, ("Import", ""))
    FreeCADGui.runCommand("Blossom_Check")
    yield found
    look(document)
    yield SETTLED
    table = widget(QtWidgets.QTableWidget, "BlossomProblems")
    claim(
        "the table has a row for each problem",
        table.rowCount() == len(document.Check.Problems) > 0,
    )
    row = [table.item(i, 0).text() for i in range(table.rowCount())].index("Face6")
    table.selectRow(row)
    chosen = FreeCADGui.Selection.getSelectionEx()
    claim("a row selects its face", chosen[0].SubElementNames == ("Face6",))
    FreeCADGui.Selection.clearSelection()
    yield SETTLED
    picture("check")
    press("Ok")
    claim("a check is no error", not FreeCADGui.Control.activeDialog())


def chamfer():
    document = with_top_chosen("Chamfer")
    FreeCADGui.runCommand("Blossom_Chamfer")
    yield found
    claim("what does not count is grey", not widget(QtWidgets.QWidget, "BlossomAngle").isEnabled())
    widget(QtWidgets.QComboBox, "BlossomSize").setCurrentText("distance and angle")
    widget(QtWidgets.QWidget, "BlossomDistance").setProperty("rawValue", 4)
    widget(QtWidgets.QWidget, "BlossomAngle").setProperty("rawValue", 30)
    yield lambda: found() and document.Chamfer.Volume < 30 * 20 * 12 - 400
    look(document)
    yield SETTLED
    picture("chamfer")
    press("Ok")
    chamfer = document.Chamfer
    claim("four edges are cut off", len(chamfer.CutOff) == 4 and chamfer.Shape.isValid())
    claim("by the angle that was typed", abs(chamfer.Angle.Value - 30) < 1e-9)
    yield from in_inches(document)


def in_inches(document):
    usual = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("UserSchema", 0)
    FreeCAD.Units.setSchema(3)
    select(document, ("Block", "Edge1"))
    FreeCADGui.runCommand("Blossom_Chamfer")
    yield found
    shown = {
        name: widget(QtWidgets.QWidget, f"Blossom{name}").findChild(QtWidgets.QLineEdit).text()
        for name in ("Distance", "Tolerance")
    }
    claim("lengths are in the user's units", shown["Distance"].endswith(" in"))
    claim("and none looks like nothing", float(shown["Tolerance"].split()[0]) > 0)
    claim("so is the volume", " in³" in said() and f"{document.Chamfer001.Volume / 25.4**3:.4g}" in said())
    press("Cancel")
    FreeCAD.Units.setSchema(usual)


def clash():
    document = new_document("Clash")
    plate = document.addObject("Part::Box", "Plate")
    plate.Length, plate.Width, plate.Height = 60, 40, 10
    for name, x, z in (("Pin", 15, 2), ("Stud", 45, 10), ("Spacer", 30, 11)):
        rod = document.addObject("Part::Cylinder", name)
        rod.Radius, rod.Height, rod.Placement.Base = 5, 20, V(x, 20, z)
    document.recompute()
    look(document)
    select(document, *((name, "") for name in ("Plate", "Pin", "Stud", "Spacer")))
    FreeCADGui.runCommand("Blossom_Clash")
    yield found
    widget(QtWidgets.QWidget, "BlossomClearance").setProperty("rawValue", 2)
    yield lambda: found() and document.Clash.TooNear == 1
    look(document)
    yield SETTLED
    found_pairs = document.Clash
    claim("one pair clashes, one touches", (found_pairs.Clashes, found_pairs.Touching) == (1, 1))
    claim("parts have colours", len(set(found_pairs.ViewObject.DiffuseColor)) == 3)
    table = widget(QtWidgets.QTableWidget, "BlossomPairs")
    claim("the table begins with the worst", table.item(0, 0).text() == "Plate and Pin")
    rows = range(table.rowCount())
    claim("rows show all", all(table.rowHeight(i) >= table.sizeHintForRow(i) for i in rows))
    table.selectRow(0)
    chosen = FreeCADGui.Selection.getSelectionEx()
    claim("a row selects both solids", len(chosen[0].SubElementNames) == 6 + 3)
    FreeCADGui.Selection.clearSelection()
    yield SETTLED
    picture("clash")
    press("Ok")
    claim("a clash is no error", not FreeCADGui.Control.activeDialog())
    document.undo()
    claim("undo shows the parts again", plate.Visibility and document.getObject("Clash") is None)


def mesh():
    document = new_document("Mesh")
    block = document.addObject("Part::Box", "Block")
    rod = document.addObject("Part::Cylinder", "Rod")
    block.Length, block.Width, block.Height = 40, 30, 15
    rod.Radius, rod.Height, rod.Placement.Base = 8, 40, V(20, 15, -10)
    document.addObject("Part::Cut", "Bored").Base, document.Bored.Tool = block, rod
    document.recompute()
    look(document)
    select(document, ("Bored", ""))
    FreeCADGui.runCommand("Blossom_Mesh")
    yield found
    widget(QtWidgets.QWidget, "BlossomEdgeLength").setProperty("rawValue", 5)
    yield lambda: found() and document.Mesh.Triangles > 500
    look(document)
    yield SETTLED
    picture("mesh")
    press("Ok")
    claim("it is closed", document.Mesh.Closed == "yes" and document.Mesh.Mesh.isSolid())
    claim("what it is of is hidden", not document.Bored.Visibility)
