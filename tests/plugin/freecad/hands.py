# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's hands and eyes in FreeCAD's window, for the stations of tour.py, and what they show.

The window prints nothing, so claims go to BLOSSOM_CLAIMS; pictures go to the folder BLOSSOM_SHOTS.
"""

import os
import time

import FreeCAD
import FreeCADGui
import Part
from PySide2 import QtCore, QtGui, QtWidgets

V = FreeCAD.Vector
claims = open(os.environ["BLOSSOM_CLAIMS"], "w", buffering=1)
PICTURE_WIDTH = 760  # pixels
SETTLED = 600  # milliseconds until the window is painted


def claim(what, holds):
    if not holds:
        raise AssertionError(what)
    print("holds:", what, file=claims)


# ---- the user's hands and eyes


def window():
    return FreeCADGui.getMainWindow()


def select(document, *members):
    FreeCADGui.Selection.clearSelection()
    for name, sub in members:
        FreeCADGui.Selection.addSelection(document.Name, name, sub)


def press(word):
    """OK or Cancel of the task panel."""
    button = getattr(QtWidgets.QDialogButtonBox, word)
    for box in window().findChildren(QtWidgets.QDialogButtonBox):
        if box.isVisible() and box.button(button):
            # By its name: PySide may take the button for a widget of another kind that was there.
            QtCore.QMetaObject.invokeMethod(box.button(button), "click")
            return
    raise AssertionError(f"there is no button {word}")


def click(document, point, also=False):
    """With the mouse, on what the view shows at a point; `also` keeps what is selected."""
    area = window().findChild(QtWidgets.QMdiArea).activeSubWindow()
    view = area.findChild(QtWidgets.QGraphicsView).viewport()
    x, y = FreeCADGui.getDocument(document.Name).activeView().getPointOnScreen(point)
    ratio = view.devicePixelRatioF()
    at = QtCore.QPointF(int(x / ratio), int(view.height() - 1 - y / ratio))
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    keys = QtCore.Qt.ControlModifier if also else QtCore.Qt.NoModifier
    for kind, button, held in (
        (QtCore.QEvent.MouseMove, none, none),
        (QtCore.QEvent.MouseButtonPress, left, left),
        (QtCore.QEvent.MouseButtonRelease, left, none),
    ):
        event = QtGui.QMouseEvent(kind, at, view.mapToGlobal(at.toPoint()), button, held, keys)
        QtWidgets.QApplication.sendEvent(view, event)
        QtWidgets.QApplication.processEvents()


def write(name, text):
    """Into a field of the panel, by the keyboard."""
    line = widget(QtWidgets.QWidget, name).findChild(QtWidgets.QLineEdit)
    line.setFocus()
    line.selectAll()
    for key, letter in [*((0, each) for each in text), (QtCore.Qt.Key_Tab, "")]:
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            event = QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier, letter)
            QtWidgets.QApplication.sendEvent(line, event)


def widget(kind, name):
    found = [each for each in window().findChildren(kind, name) if each.isVisible()]
    return found[0] if found else None


def said():
    """What the panel says of the preview, without its table."""
    label = widget(QtWidgets.QLabel, "BlossomText")
    document = QtGui.QTextDocument()
    document.setHtml(label.text() if label else "")
    return document.toPlainText()


def found():
    """Whether a preview is there: its facts end with the time."""
    return "Time" in said()


def busy():
    """Whether a preview is at work."""
    return widget(QtWidgets.QPushButton, "BlossomStop") is not None


def gone():
    """Whether the panel is closed."""
    return not FreeCADGui.Control.activeDialog()


def look(document, part=1.0):
    """All of the document in the view, or the middle part."""
    view = FreeCADGui.getDocument(document.Name).activeView()
    view.setAnimationEnabled(False)
    view.viewIsometric()
    view.fitAll()
    height = view.getCameraNode().height
    height.setValue(part * height.getValue())


def picture(name):
    grabbed = window().screen().grabWindow(window().winId())
    scaled = grabbed.toImage().scaledToWidth(PICTURE_WIDTH, QtCore.Qt.SmoothTransformation)
    file = os.path.join(os.environ["BLOSSOM_SHOTS"], f"{name}.png")
    scaled.convertToFormat(QtGui.QImage.Format_RGB888).save(file)
    claim(f"there is a picture of {name}", os.path.getsize(file) > 10000)


# ---- what is shown


def new_document(name):
    document = FreeCAD.newDocument(name)
    document.UndoMode = 1
    return document


def wave(document, name, height):
    points = [[V(x, y, height(x, y)) for y in range(11)] for x in range(11)]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    feature = document.addObject("Part::Feature", name)
    feature.Shape = surface.toShape()
    return feature


def bumps(document, name, height):
    """A patch of degree 24 whose like are hard to tell apart."""
    surface = Part.BezierSurface()
    surface.increase(24, 24)
    for i in range(25):
        for j in range(25):
            surface.setPole(i + 1, j + 1, V(i / 2.4, j / 2.4, height * (-1) ** (i + j)))
    feature = document.addObject("Part::Feature", name)
    feature.Shape = surface.toShape()
    return feature


# ---- how the window answers


class Pulse(QtCore.QTimer):
    """Notes how long the window lets others wait."""

    def __init__(self):
        super().__init__()
        self.setInterval(10)
        self.timeout.connect(self.beat)
        self.beats, self.longest = 0, 0.0
        self.last = self.began = time.monotonic()
        self.worked = time.thread_time()
        self.start()

    def beat(self):
        now = time.monotonic()
        self.longest = max(self.longest, now - self.last)
        self.last, self.beats = now, self.beats + 1

    def told(self, what):
        self.stop()
        seconds = time.monotonic() - self.began
        share = time.thread_time() - self.worked
        print(f"{what}: in {seconds:.1f} s the window worked {share:.1f} s and answered "
              f"{self.beats} times, at the latest after {1000 * self.longest:.0f} ms",
              file=claims)  # fmt: skip
        return self.beats
