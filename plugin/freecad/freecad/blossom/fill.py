# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holes closed by patches that continue their neighbours."""

from . import links
from .feature import Choice, Fact, Feature, Link


class Fill(Feature):
    NAME = "Fill"
    TITLE = "Fill holes"
    TIP = "Patches in holes of 3 to 12 sides that continue their neighbours; flat faces in round ones"
    DOING = "Filling holes"
    LINKS = (
        Link("Edges", "Edges", "Edges round a hole, in any order, or the object for all open ones"),
    )
    CHOICES = (
        Choice("Continuity", "word", "G1", "Continuity",
               "G0: position, G1: tangent planes, G2: curvatures", ("G0", "G1", "G2")),
        Choice("Sewn", "flag", False, "With the object", "The object with its holes closed"),
        Choice("Tolerance", "length", "1e-7 mm", "Tolerance",
               "How far corners that join may be apart, and neighbours that have to be fitted"),
    )  # fmt: skip
    FACTS = (
        Fact("Holes", "count", "How many holes are filled"),
        Fact("Patches", "count", "With how many faces"),
        Fact("Reached", "words", "The continuity of each hole"),
        Fact("Gap", "length", "From neighbours, at most, mm"),
        Fact("Angle", "angle", "Between the normals, at most, radians"),
        Fact("Refused", "words", "Holes that stay, and why"),
    )

    def inputs(self, obj):
        whole, _ = links.whole_with_edges(obj.Edges, "Edges")
        if not whole.Faces:
            raise ValueError("Edges: those of faces are wanted, the object has no face")
        return {"Edges": whole}

    def options(self, obj):
        _, numbers = links.whole_with_edges(obj.Edges, "Edges")
        return {
            "edges": numbers,
            "continuity": obj.Continuity,
            "sew": obj.Sewn,
            "tolerance": obj.Tolerance.Value,
        }

    def ask(self, entrance, inputs, options):
        return entrance.fill(inputs["Edges"], **options)

    def facts(self, report):
        holes = report["holes"]
        sides = [side for hole in holes for side in hole["sides"]]
        return {
            "Holes": len(holes),
            "Patches": sum(hole["patches"] for hole in holes),
            "Reached": [hole["reached"] for hole in holes],
            "Gap": max((side["gap"] for side in sides), default=0.0),
            "Angle": max((side["normal_angle"] for side in sides), default=0.0),
            "Refused": [each["message"] for each in report["refused"]],
        }
