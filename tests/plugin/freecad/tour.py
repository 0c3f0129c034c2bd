# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tour of the workbench in FreeCAD's window, as a user goes: selects, calls a command, waits for
the preview, clicks OK. It takes pictures, of which README.md shows some. Stations yield what they
wait for: milliseconds or a condition.

The window prints nothing, so claims go to BLOSSOM_CLAIMS; pictures go to the folder BLOSSOM_SHOTS.
"""

import os
import sys
import time
import traceback

import FreeCAD
import FreeCADGui
from PySide2 import QtCore, QtWidgets

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from hands import claim, claims, said, window  # noqa: E402
from tour_commands import chamfer, check, clash, fillet, intersection, mesh, trim  # noqa: E402
from tour_documents import deleted, first_steps, reopened, without_engine  # noqa: E402
from tour_hands import rounded_bracket  # noqa: E402
from tour_work import many, work  # noqa: E402

PATIENCE = 120  # seconds for a condition


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
        reopened, without_engine, rounded_bracket,
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
