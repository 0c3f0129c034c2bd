# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench: one for each kind."""

import FreeCAD
import FreeCADGui

from . import make, selection
from .kinds import KINDS
from .view import icon_of


class Command:
    """Makes an object of what is selected, and opens its panel."""

    def __init__(self, kind):
        self._kind = kind

    def GetResources(self):  # noqa: N802 - these names are FreeCAD's
        return {
            "Pixmap": icon_of(self._kind.NAME),
            "MenuText": self._kind.TITLE,
            "ToolTip": self._kind.TIP,
        }

    def IsActive(self):  # noqa: N802
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self):  # noqa: N802
        document = FreeCAD.ActiveDocument
        members = self._kind.deal(selection.selected())
        FreeCADGui.Selection.clearSelection()
        document.openTransaction(self._kind.TITLE)
        try:
            obj = make.of_kind(self._kind, document, *members)
            obj.Label = self._kind.TITLE
            obj.Proxy.begin(obj)
            FreeCADGui.getDocument(document.Name).setEdit(obj.Name)
        except Exception:
            document.abortTransaction()
            raise


def register():
    """All commands, and their names."""
    names = []
    for kind in KINDS:
        names.append(f"Blossom_{kind.NAME}")
        FreeCADGui.addCommand(names[-1], Command(kind))
    return names
