# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects by a line of Python. A link is a list of pairs: [(box, "Face1"), (part, "Ball.Face1")].
Objects compute when the document does; choices are properties of the same names.

    from freecad.blossom import make
    curves = make.intersection(document, [(box, "Face1")], [(part, "Cylinder.Face1")])
    curves.Tolerance = "1e-6 mm"
    document.recompute()
    print(curves.Status, curves.Curves, curves.Length)
"""

import FreeCAD

from .chamfer import Chamfer
from .check import Check
from .clash import Clash
from .fill import Fill
from .fillet import Fillet
from .intersection import Intersection
from .links import require_document
from .mesh import Mesh
from .section import Section
from .solid import Solid
from .strip import Strip
from .subpatch import SubPatch
from .trim import Trim


def of_kind(kind, document, *given, **choices):
    """A new object with its links in order, and its choices by name. throws TypeError, ValueError;
    there is no object then"""
    require_document(document)
    members = {link.name: _link(link, each) for link, each in zip(kind.LINKS, given)}
    obj = document.addObject(kind.OBJECT, kind.NAME)
    try:
        kind(obj)
        for name, value in {**members, **choices}.items():
            _set(obj, kind, name, value)
    except BaseException:
        document.removeObject(obj.Name)
        raise
    if FreeCAD.GuiUp:
        from .view import ViewProvider

        ViewProvider(obj.ViewObject)
    return obj


def _link(link, given):
    """A link as FreeCAD takes it; a lone object or pair is a list of one. throws TypeError"""
    alone = _is_object(given) or (isinstance(given, tuple) and given and _is_object(given[0]))
    try:
        members = [given] if alone else list(given)
    except TypeError:
        members = [given]
    pairs = [(each, "") if _is_object(each) else each for each in members]
    for pair in pairs:
        if not (isinstance(pair, tuple) and len(pair) == 2 and _is_object(pair[0])):
            raise TypeError(
                f"{link.name}: objects of a document, or pairs of one and its elements, as "
                f'(box, "Face1"), are wanted, got {type(pair).__name__}'
            )
    return pairs


def _is_object(thing):
    return isinstance(thing, FreeCAD.DocumentObject)


def _set(obj, feature, name, value):
    """A property, with messages that users can read. throws TypeError, ValueError"""
    known = {choice.name: choice for choice in feature.CHOICES}
    if name not in obj.PropertiesList:
        raise TypeError(f"there is no choice {name}; there are {', '.join(known)}")
    if name in known and known[name].kind == "word" and value not in known[name].of:
        words = ", ".join(known[name].of)
        raise ValueError(f"{name}: one of {words} is wanted, got {value!r}")
    try:
        setattr(obj, name, value)
    except Exception as error:  # FreeCAD has kinds of its own, with dictionaries in them
        told = error.args[0] if error.args else ""
        words = told.get("sErrMsg", "") if isinstance(told, dict) else told
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{name}: {value!r} cannot be taken: {words}") from None


def intersection(document, a, b, **choices):
    """The curves in which faces meet others."""
    return of_kind(Intersection, document, a, b, **choices)


def section(document, part, plane=(), **choices):
    """Wires in planes: by a flat face or a placed object, or Point and Normal."""
    return of_kind(Section, document, part, plane, **choices)


def trim(document, part, tools, **choices):
    """Faces cut where they meet tools."""
    return of_kind(Trim, document, part, tools, **choices)


def solid(document, operation, part, tools, **choices):
    """Solids combined: "cut", "common", "fuse" or "split"."""
    return of_kind(Solid, document, part, tools, Operation=operation, **choices)


def blend_strip(document, a, b, **choices):
    """A strip between two faces."""
    return of_kind(Strip, document, a, b, **choices)


def fillet(document, edges, **choices):
    """Edges of a solid rounded."""
    return of_kind(Fillet, document, edges, **choices)


def chamfer(document, edges, **choices):
    """Edges of a solid cut off: Distance; with Size SecondDistance or Angle, too."""
    return of_kind(Chamfer, document, edges, **choices)


def fill(document, edges, **choices):
    """Holes closed: those with these edges, or all of an object."""
    return of_kind(Fill, document, edges, **choices)


def sub_patch(document, face, **choices):
    """A part of a face's surface: UFrom, UTo, VFrom, VTo between 0 and 1, Levels."""
    return of_kind(SubPatch, document, face, **choices)


def check(document, part, **choices):
    """What is wrong with an object."""
    return of_kind(Check, document, part, **choices)


def clash(document, a, b=(), **choices):
    """How solids lie to each other, or to others: Clearance."""
    return of_kind(Clash, document, a, b, **choices)


def mesh(document, part, **choices):
    """Triangles of faces: Deviation, Angle, EdgeLength."""
    return of_kind(Mesh, document, part, **choices)
