# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the objects are shown in the window and in its tree."""

import os

from . import ICONS, links
from .kinds import KINDS

CURVE_COLOUR = (0.80, 0.05, 0.25)
FACE_COLOUR = (0.68, 0.77, 0.90)
_OF_CURVES = ("Intersection", "Section")


class ViewProvider:
    """Of all kinds."""

    def __init__(self, view):
        view.Proxy = self
        if _kind_name(view.Object) in _OF_CURVES:
            view.LineColor = view.PointColor = CURVE_COLOUR
            view.LineWidth = 3
            view.PointSize = 5
        else:
            view.ShapeColor = FACE_COLOUR
        if _kind_name(view.Object) == "Mesh":
            view.DisplayMode = "Flat Lines"

    def attach(self, view):
        self.Object = view.Object

    def getIcon(self):  # noqa: N802 - these names are FreeCAD's
        return icon_of(_kind_name(self.Object))

    def updateData(self, obj, prop):  # noqa: N802
        if prop == "Shape" and obj.ViewObject is not None:
            paint(obj)

    def setEdit(self, view, mode=0):  # noqa: N802
        from .panel import show_panel

        return show_panel(view.Object)

    def unsetEdit(self, view, mode=0):  # noqa: N802
        return True

    def doubleClicked(self, view):  # noqa: N802
        view.Document.setEdit(view.Object.Name)
        return True

    def setupContextMenu(self, view, menu):  # noqa: N802
        if _kind_name(view.Object) == "Section":
            from .drawing_dialog import save

            action = menu.addAction("Save as drawing (DXF, SVG)...")
            action.triggered.connect(lambda *_: save(view.Object))

    def claimChildren(self):  # noqa: N802
        obj = self.Object
        if not obj.Proxy.HIDES:
            return []
        return [
            target
            for link in obj.Proxy.LINKS
            for target, _ in getattr(obj, link.name)
            if not target.hasExtension("App::GeoFeatureGroupExtension")
        ]

    def onDelete(self, view, names):  # noqa: N802
        if self.Object.Proxy.HIDES:
            for parent in shown_parents(self.Object):
                parent.Visibility = True
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def shown_parents(obj):
    """The objects that show what it is made of."""
    parents = [
        links.shown_by(*member)
        for link in obj.Proxy.LINKS
        for member in links.members(getattr(obj, link.name))
    ]
    return [parent for parent in parents if parent is not None]


def icon_of(name):
    return os.path.join(ICONS, f"{name}.svg")


def paint(obj):
    """The colours of faces, by what was found; one for all where that says nothing."""
    view = obj.ViewObject
    if not hasattr(obj, "Shape"):  # a mesh has one colour
        return
    colours = obj.Proxy.colours(obj)
    if colours and len(colours) == len(obj.Shape.Faces):
        view.DiffuseColor = [(*colour, 0.0) for colour in colours]
    elif len(view.DiffuseColor) > 1:
        view.DiffuseColor = [view.ShapeColor]


def _kind_name(obj):
    return next(kind.NAME for kind in KINDS if isinstance(obj.Proxy, kind))
