# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench Blossom. Nothing here needs a window: freecadcmd imports it, too.

    from freecad.blossom import make
    curves = make.intersection(document, [(box, "Face1")], [(part, "Cylinder.Face1")])
    document.recompute()
"""

import os

import FreeCAD

ICONS = os.path.join(os.path.dirname(__file__), "resources", "icons")

FreeCAD.addExportType("Drawing of a section of Blossom (*.dxf *.svg)", "freecad.blossom.drawing")
