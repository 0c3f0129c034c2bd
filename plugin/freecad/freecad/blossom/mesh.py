# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of faces within a proven distance, as an object of FreeCAD's Mesh."""

import math

from . import links
from .feature import Choice, Fact, Feature, Link, container_of

HALF_A_RADIAN = math.degrees(0.5)  # as all doors have it


class Mesh(Feature):
    NAME = "Mesh"
    TITLE = "Mesh"
    TIP = "Triangles of faces, within a proven distance, that meet in common points along edges"
    DOING = "Meshing"
    OBJECT = "Mesh::FeaturePython"
    HIDES = True
    TABLED = ("FaceNumbers", "FirstTriangles")
    LINKS = (Link("Part", "Object", "An object, or some of its faces"),)
    CHOICES = (
        Choice("Deviation", "length", "0 mm", "Deviation",
               "How far triangles may be from faces; 0: a thousandth of the size"),
        Choice("Angle", "angle", HALF_A_RADIAN, "Angle",
               "How far normals may turn along a side, about"),
        Choice("EdgeLength", "length", "0 mm", "Edge length",
               "How long sides may be, about; 0: any"),
    )  # fmt: skip
    FACTS = (
        Fact("Triangles", "count", "How many there are"),
        Fact("Points", "count", "How many points they have"),
        Fact("Within", "length", "How far faces and triangles are apart, at most, mm: proven"),
        Fact("Closed", "word", "yes: each edge has two faces, and none is left out"),
        Fact("Refused", "words", "Faces that are left out, and why"),
        Fact("FaceNumbers", "counts", "The faces that have triangles"),
        Fact("FirstTriangles", "counts", "Where the triangles of each of these begin, from 0"),
    )

    def inputs(self, obj):
        return {"Part": links.faces(obj.Part, "Part")}

    def options(self, obj):
        if not 0 < obj.Angle.Value <= 180:
            raise ValueError("Angle: more than 0 and at most 180 degrees are wanted")
        sizes = {"deviation": obj.Deviation.Value, "edge_length": obj.EdgeLength.Value}
        given = {name: value for name, value in sizes.items() if value > 0}
        return {**given, "angle": math.radians(obj.Angle.Value)}

    def ask(self, entrance, inputs, options):
        return entrance.mesh(inputs["Part"], **options)

    def facts(self, report):
        return {
            "Triangles": report["triangles"],
            "Points": report["points"],
            "Within": report["distance"],
            "Closed": "yes" if report["closed"] else "no",
            "Refused": [f"Face{each['face']}: {each['why']}" for each in report["refused"]],
            "FaceNumbers": [number for number, _ in report["groups"]],
            "FirstTriangles": [first for _, first in report["groups"]],
        }

    def give(self, obj, answer, inputs):
        """As shapes are given: the triangles are where they are in space, the object may be in a
        container, and moved by hand itself."""
        made, placement = answer.shape.copy(), obj.Placement
        made.transform(container_of(obj).inverse().toMatrix())
        obj.Mesh = made
        obj.Placement = placement  # a mesh brings its own
