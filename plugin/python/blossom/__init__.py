# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersections of CAD surfaces, proven, and strips between them.

    import blossom
    found = blossom.intersect(face_a, face_b)
    found.status            # "complete": nothing is missing
    found.curves[0].points  # (n, 3) array
    found.chains[0].curves  # curves that go on across seams: places in found.curves
    Part.show(found.to_part())

Shapes are FreeCAD Part shapes, BRep bytes or text (Open CASCADE's text and binary, FreeCAD's
`exportBinary`), or numpy nets of one Bezier patch: (n + 1, m + 1, 3), or 4 with weights.
Lengths are in the model's units, angles in radians, face numbers start at 1 as in "Face1".
"""

import os
import tempfile
from dataclasses import dataclass

from . import _core
from ._core import Chain, Contact, Curve, Error, Intersection, Place, __version__

__all__ = [
    "Chain",
    "Contact",
    "Curve",
    "Error",
    "Intersection",
    "Place",
    "Strip",
    "__version__",
    "blend_strip",
    "intersect",
]


def intersect(a, b, tolerance=1e-7, form="auto", time_limit=0, budget=None, threads=0):
    """All intersections of every face of `a` with every face of `b`.

    tolerance   what counts as one point, model units
    form        "auto", "bezier" or "monomial": what the nets of cells are made from
    time_limit  seconds before giving up with the status "stopped"; 0 is no limit
    budget      pairs of cells examined before giving up; None is the engine's own
    threads     how many may work at the same time; 0 is one a core

    Returns an `Intersection`. An empty one whose status is "complete" is a proof of emptiness.
    Raises ValueError for bad arguments, blossom.Error when Open CASCADE fails, and
    KeyboardInterrupt when Ctrl-C ends the work.
    """
    return _core.intersect(
        _brep(a, "a"), _brep(b, "b"), tolerance, form, time_limit, budget, threads
    )


@dataclass(frozen=True)
class Strip:
    """A strip between two faces, and how well it continues them.

    edge_a, edge_b              the borders that were joined: "umin", "umax", "vmin" or "vmax"
    backward                    the border of b runs backwards along the strip
    continuity_a, continuity_b  `gap` in model units, `normal_angle` in radians, `scale`: how
                                many times the surface's own cross derivative the strip's is
    """

    brep: bytes
    edge_a: str
    edge_b: str
    backward: bool
    continuity_a: dict
    continuity_b: dict

    def to_brep(self):
        """The strip's face as BRep text."""
        return self.brep

    def to_part(self):
        """The strip's face as a shape of FreeCAD's Part."""
        return _part_from(self.brep)


def blend_strip(a, b, edge_a=None, edge_b=None, weight_a=1.0, weight_b=1.0):
    """The strip between two faces that continues both with their tangent planes, exactly.

    edge_a, edge_b      "umin", "umax", "vmin" or "vmax"; None takes the nearest borders
    weight_a, weight_b  how far the tangents reach into the strip; 1 is a third of its width

    Returns a `Strip`. Raises ValueError if a face has no such border or no strip is possible.
    """
    return Strip(
        **_core.blend_strip(
            _brep(a, "a"), _brep(b, "b"), edge_a, edge_b, weight_a, weight_b
        )
    )


def _to_part(self):
    """The edges, and vertices at isolated contacts, as a shape of FreeCAD's Part."""
    return _part_from(self.to_brep())


Intersection.to_part = _to_part


def _part_from(brep):
    try:
        import Part
    except ImportError as missing:
        raise Error(f"to_part: FreeCAD's Part cannot be imported: {missing}") from missing
    shape = Part.Shape()
    shape.importBrepFromString(brep.decode("ascii"))
    return shape


def _brep(shape, name):
    """BRep bytes of any accepted argument."""
    if isinstance(shape, (bytes, bytearray, memoryview)):
        return bytes(shape)
    if isinstance(shape, str):
        return shape.encode()
    if hasattr(shape, "exportBinary") and hasattr(shape, "isNull"):
        return _part_brep(shape, name)
    if hasattr(shape, "exportBrepToString"):
        return shape.exportBrepToString().encode()
    if hasattr(shape, "__array_interface__"):
        try:
            return _core.brep_of_net(shape, name)
        except TypeError:  # its text names pybind11's overloads, not the argument
            kind = getattr(shape, "dtype", type(shape).__name__)
            raise ValueError(f"{name}: a net holds numbers, got {kind}") from None
    raise ValueError(
        f"{name}: a Part shape, BRep bytes or text, or a numpy net is wanted, "
        f"got {type(shape).__name__}"
    )


def _part_brep(shape, name):
    """Binary, for it keeps every digit; Part writes it to files only."""
    if shape.isNull():
        raise ValueError(f"{name}: the shape is null")
    with tempfile.TemporaryDirectory(prefix="blossom-") as folder:
        file = os.path.join(folder, "shape.bin")
        shape.exportBinary(file)
        with open(file, "rb") as stream:
            return stream.read()
