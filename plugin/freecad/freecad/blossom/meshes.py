# SPDX-License-Identifier: LGPL-2.1-or-later
"""Questions about FreeCAD's Mesh objects by a line of Python, and what they make, as objects.

    from freecad.blossom import meshes
    meshes.check(scan).sound                    # whether it is closed, turned one way, crosses itself
    whole = meshes.filled(document, scan)       # a Mesh object without holes
    cut = meshes.section(document, scan, point, normal)      # wires in a plane, a Part object
    curves = meshes.intersection(document, scan, part)       # where it meets a mesh or a shape
    meshes.distance(scan, part).bounds          # how far they are from each other at worst

Where a mesh is in a container, or behind a link, it counts where it is shown. It takes the package `blossom`, see
`door`; what is made does not follow its parents.
"""

import os
import tempfile

import Mesh

from . import door, links


def triangles(obj):
    """A Mesh object as the package has it, where it is shown. throws NoEngine, TypeError,
    ValueError"""
    chosen = door.choice()
    if chosen.kind != "module":
        raise door.NoEngine(f"questions of meshes take the package blossom: {chosen.reason}")
    import blossom

    if not links.has(obj, "Label"):
        raise TypeError(f"a Mesh object is wanted, got {type(obj).__name__}")
    if not hasattr(obj, "Mesh"):
        raise ValueError(f"{obj.Label} is no mesh")
    if obj.Mesh.CountFacets == 0:
        raise ValueError(f"{obj.Label} has no triangles")
    return blossom.from_mesh(obj)


def check(obj):
    """What is wrong with it, exactly: a `blossom.MeshCheck`."""
    return triangles(obj).check()


def filled(document, obj, name="Filled"):
    """A Mesh object with all holes filled."""
    links.require_document(document)
    made = triangles(obj).fill()
    with tempfile.TemporaryDirectory(prefix="blossom-") as folder:
        file = os.path.join(folder, "mesh.ply")  # which FreeCAD reads the fastest
        made.write(file)
        new = document.addObject("Mesh::Feature", name)
        new.Mesh = Mesh.Mesh(file)
    return new


def section(document, obj, point, normal, name="MeshSection"):
    """A Part object of the wires in which it meets a plane. throws ValueError if it does not"""
    links.require_document(document)
    return _wires(document, triangles(obj).section(tuple(point), tuple(normal)), name)


def intersection(document, obj, other, name="MeshIntersection"):
    """A Part object of the wires in which it meets another mesh, or an object that has a shape,
    within a ten-thousandth of the size. throws ValueError if it does not"""
    links.require_document(document)
    return _wires(document, triangles(obj).intersect(_other(other)), name)


def distance(obj, other, **options):
    """How far it is from another mesh or an object that has a shape, at worst and both ways: a
    `blossom.MeshDistance`."""
    return triangles(obj).distance(_other(other), **options)


def _other(other):
    if hasattr(other, "Mesh"):
        return triangles(other)
    shape = getattr(other, "Shape", other)
    if shape is other:
        return shape
    placed = shape.copy(False)
    container = other.getParentGeoFeatureGroup()
    if container is not None:
        placed.Placement = container.getGlobalPlacement().multiply(shape.Placement)
    return placed


def _wires(document, found, name):
    try:
        shape = found.to_part()
    except RuntimeError:
        raise ValueError(f"{name}: they do not meet") from None
    new = document.addObject("Part::Feature", name)
    new.Shape = shape
    return new
