# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is selected in the window, as links."""

import FreeCADGui


def selected():
    """Pairs (object, name) through containers, in the order in which they were selected."""
    return [
        (each.Object, sub)
        for each in FreeCADGui.Selection.getSelectionEx("", 0)
        for sub in (each.SubElementNames or ("",))
    ]
