# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a section is to be saved as a drawing, asked in the window."""

import os

import FreeCADGui
from PySide import QtGui

from . import drawing
from .feature import MENDABLE

FILTERS = "DXF (*.dxf);;SVG (*.svg)"


def save(obj):
    """Asks for a file and writes it; what goes wrong is told."""
    window = FreeCADGui.getMainWindow()
    file, kind = QtGui.QFileDialog.getSaveFileName(
        window, "Save as drawing", f"{obj.Label}.dxf", FILTERS
    )
    if not file:
        return
    if not os.path.splitext(file)[1]:
        file += ".svg" if kind.startswith("SVG") else ".dxf"
    try:
        drawing.write(obj, file)
    except MENDABLE as error:
        QtGui.QMessageBox.warning(window, "Save as drawing", str(error))
