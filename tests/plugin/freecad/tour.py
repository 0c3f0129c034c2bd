# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tour of the workbench in FreeCAD's window, as a user goes: selects, calls a command, waits for
the preview, clicks OK. It takes pictures, of which README.md shows some.

The window prints nothing, so claims go to BLOSSOM_CLAIMS; pictures go to the folder BLOSSOM_SHOTS.
"""

import math
import os
import sys
import time
import traceback

import FreeCAD
import FreeCADGui
import Part
from PySide2 import QtCore, QtGui, QtWidgets

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from hands import (  # noqa: E402
    Pulse, V, bumps, claim, claims, found, look, new_document, picture, press, said, select, wave,
    widget, window,
)  # fmt: skip

LEAST_ANSWERS = 5  # of a window that goes on, on whatever machine; one that waits answers once
SETTLED = 600  # milliseconds until the window is painted
PATIENCE = 120  # seconds for a condition
MOST_WORK = 3  # seconds of work while the window is watched


# ---- the stations; each yields what it waits for: milliseconds or a condition


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


def fillet():
    document = new_document("Fillet")
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = 30, 20, 12
    document.recompute()
    look(document)
    select(document, ("Block", "Face6"))
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
    claim("and says why", "the radius is too large" in said())
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
    document = new_document("Chamfer")
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = 30, 20, 12
    document.recompute()
    look(document)
    select(document, ("Block", "Face6"))
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


def busy():
    """Whether a preview is at work."""
    return widget(QtWidgets.QPushButton, "BlossomStop") is not None


def gone():
    """Whether the panel is closed."""
    return not FreeCADGui.Control.activeDialog()


def asked_for_ever(kind):
    """The kind's work begins anew until it is ended, however quick the machine is. Returns what
    takes that back."""
    kept = kind.ask

    def ask(self, entrance, inputs, options):
        while True:
            kept(self, entrance, inputs, options)

    kind.ask = ask
    return lambda: setattr(kind, "ask", kept)


def work():
    """Hard work in a preview, and in a recompute, that the user ends."""
    document = new_document("Work")
    bumps(document, "Low", 5), bumps(document, "High", 2.5)
    document.recompute()
    look(document)
    yield SETTLED
    pulse = Pulse()
    yield 1000 * MOST_WORK
    pulse.told("nothing to do")  # what the machine can do, to compare with
    select(document, ("Low", "Face1"), ("High", "Face1"))
    FreeCADGui.runCommand("Blossom_Intersection")
    ends_again = asked_for_ever(type(document.Intersection.Proxy))
    yield busy
    pulse = Pulse()
    yield lambda: time.monotonic() - pulse.began > MOST_WORK
    claim(f"it is still at work: {said()}", busy())
    claim("the window answers during a preview", pulse.told("preview") > LEAST_ANSWERS)
    widget(QtWidgets.QPushButton, "BlossomStop").click()
    yield lambda: "stopped" in said()

    def give_up():
        if widget(QtWidgets.QFrame, "BlossomWaiting") is None:
            QtCore.QTimer.singleShot(100, give_up)
            return
        if time.monotonic() - pulse.began < MOST_WORK:
            QtCore.QTimer.singleShot(100, give_up)
            return
        picture("waiting")
        pulse.last = time.monotonic()  # to take it took long
        button = widget(QtWidgets.QFrame, "BlossomWaiting").button
        at = QtCore.QPointF(5, 5)
        for kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
            left = QtCore.Qt.LeftButton
            event = QtGui.QMouseEvent(kind, at, left, left, QtCore.Qt.NoModifier)
            QtWidgets.QApplication.postEvent(button, event)

    pulse = Pulse()
    QtCore.QTimer.singleShot(100, give_up)
    press("Ok")
    claim("the window answers during a recompute", pulse.told("recompute") > LEAST_ANSWERS)
    claim("the button ends it", "cancelled" in said())
    press("Cancel")
    claim(
        "Cancel leaves the document as it was",
        [o.Name for o in document.Objects] == ["Low", "High"],
    )

    select(document, ("Low", "Face1"), ("High", "Face1"))
    FreeCADGui.runCommand("Blossom_Intersection")
    yield busy
    FreeCAD.closeDocument(document.Name)
    yield gone
    claim("a document may be closed meanwhile", gone())
    ends_again()


def many():
    """Answers with thousands of points, which kept the window waiting when they were lists."""
    document = new_document("Many")
    wave(document, "Sea", lambda x, y: 2 * math.sin(0.6 * x) * math.cos(0.5 * y))
    document.recompute()
    look(document)
    select(document, ("Sea", ""))
    FreeCADGui.runCommand("Blossom_Section")
    cut = document.Section
    cut.Point, cut.Spacing = V(0, 0, -1.5), "0.07 mm"
    yield lambda: widget(QtWidgets.QSpinBox, "BlossomCount")
    pulse = Pulse()
    widget(QtWidgets.QSpinBox, "BlossomCount").setValue(40)  # the preview begins anew
    yield lambda: found() and len(cut.WiresOfPlanes) == 40
    pulse.told("40 sections")
    claim("all planes cut it", min(cut.WiresOfPlanes) > 0)
    menu = QtWidgets.QMenu()
    cut.ViewObject.Proxy.setupContextMenu(cut.ViewObject, menu)
    claim("its menu saves drawings", [each.text() for each in menu.actions()][-1].startswith("Save as"))
    report = cut.Proxy.question(cut).job()
    report.start()
    yield lambda: report.done
    curve = report.answer().report["planes"][0]["parts"][0]["curves"][0]
    claim("reports come without samples", "points" not in curve and "length" in curve)
    press("Ok")


def first_steps():
    """What is said where nothing is chosen, and where a section begins."""
    document = new_document("Steps")
    block = document.addObject("Part::Box", "Block")
    block.Placement.Base = V(3, 4, 100)
    document.recompute()
    look(document)
    FreeCADGui.runCommand("Blossom_Intersection")
    yield lambda: "Take selection" in said()
    claim("a panel has its own words", said().startswith("Faces: a face is wanted"))
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


def tour():
    FreeCADGui.activateWorkbench("BlossomWorkbench")
    claim("the workbench is there", FreeCADGui.activeWorkbench().name() == "BlossomWorkbench")
    window().resize(1000, 720)
    colours = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    colours.SetBool("Simple", True)
    colours.SetBool("Gradient", False)
    colours.SetUnsigned("BackgroundColor", 0xF4F6F8FF)
    for dock in window().findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Python console", "Report view"):
            dock.hide()
        if dock.objectName() == "Combo View":
            window().resizeDocks([dock], [330], QtCore.Qt.Horizontal)
    stations = (
        intersection, trim, fillet, chamfer, check, clash, mesh, work, many, first_steps, deleted,
        reopened, without_engine,
    )  # fmt: skip
    for station in stations:
        print(f"-- {station.__name__}", file=claims)
        yield from station()
    print("ALL CLAIMS HOLD", file=claims)


class Guide:
    """Goes on with the tour from the event loop when what it waits for has come."""

    def __init__(self, steps):
        self._steps = steps
        self._busy = False
        self._wanted, self._since = (lambda: True), time.monotonic()
        self._timer = QtCore.QTimer()
        self._timer.setInterval(30)
        self._timer.timeout.connect(self._look)
        self._timer.start()

    def _look(self):
        if self._busy:  # a step runs an event loop of its own
            return
        try:
            if not self._wanted():
                if time.monotonic() - self._since > PATIENCE:
                    self._steps.throw(TimeoutError(f"nothing came; the panel says: {said()}"))
                return
            self._busy = True
            wanted = next(self._steps)
        except StopIteration:
            os._exit(0)
        except BaseException:
            traceback.print_exc(file=claims)
            os._exit(1)  # a dialog could hold the process
        finally:
            self._busy = False
        self._since = time.monotonic()
        ready = self._since + (0 if callable(wanted) else wanted / 1000)
        self._wanted = wanted if callable(wanted) else lambda: time.monotonic() > ready


QtCore.QTimer.singleShot(1000, lambda: setattr(sys, "blossom_guide", Guide(tour())))
