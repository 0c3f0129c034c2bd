# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench, when there is a window. FreeCAD imports it by its name."""

import os

import FreeCADGui

from . import ICONS

FreeCADGui.addIconPath(ICONS)


class BlossomWorkbench(FreeCADGui.Workbench):
    MenuText = "Blossom"
    ToolTip = "Intersections, sections, trims, solids, blends and checks, with proofs"
    Icon = os.path.join(ICONS, "Blossom.svg")

    def GetClassName(self):  # noqa: N802 - FreeCAD's name
        return "Gui::PythonWorkbench"

    def Initialize(self):  # noqa: N802 - FreeCAD's name
        from . import commands

        names = commands.register()
        self.appendToolbar("Blossom", names)
        self.appendMenu("Blossom", names)


FreeCADGui.addWorkbench(BlossomWorkbench())
