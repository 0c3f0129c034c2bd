# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stations of the tour: the window while work goes on, and its end."""

import gc
import math
import time

import FreeCAD
import FreeCADGui
from PySide2 import QtCore, QtGui, QtWidgets

from freecad.blossom.panel import Panel
from hands import (
    SETTLED, Pulse, V, bumps, busy, claim, found, gone, look, new_document, picture, press, said, select,
    wave, widget, window,
)  # fmt: skip

LEAST_ANSWERS = 5  # of a window that goes on, on whatever machine; one that waits answers once
MOST_WORK = 3  # seconds of work while the window is watched


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
    panels = [each for each in gc.get_objects() if isinstance(each, Panel)]
    panel = next(each for each in panels if each._document == document.Name)
    press("Cancel")
    claim(
        "Cancel leaves the document as it was",
        [o.Name for o in document.Objects] == ["Low", "High"],
    )
    panel._look()  # as by the clock while a cancelled recompute of others pumps events
    claim("a look that comes late finds no one", panel.reject())

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
