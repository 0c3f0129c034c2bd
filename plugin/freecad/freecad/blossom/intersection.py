# SPDX-License-Identifier: LGPL-2.1-or-later
"""All intersections of faces with other faces, as edges."""

from . import links
from .feature import TOLERANCE, Fact, Feature, Link


class Intersection(Feature):
    NAME = "Intersection"
    TITLE = "Intersection"
    TIP = (
        "All curves in which faces meet other faces, or points in which edges meet faces and edges, "
        "with a proof that none is missing"
    )
    DOING = "Intersecting faces"
    LINKS = (
        Link("A", "Faces", "Faces, objects with faces, or edges and wires"),
        Link("B", "Other faces", "Faces, objects with faces, or edges and wires, that they meet"),
    )
    CHOICES = (TOLERANCE,)
    FACTS = (
        Fact("Status", "word", "complete: no curve is missing; tolerance, stopped: see Reasons"),
        Fact("Curves", "count", "How many curves there are"),
        Fact("Points", "count", "In how many points faces only touch, or edges meet"),
        Fact("Overlaps", "count", "How many common areas there are"),
        Fact("Length", "length", "Of all edges, each stretch once, mm"),
        Fact("Deviation", "length", "How far curves are from both faces at most, mm"),
        Fact("Reasons", "words", "What could not be decided"),
    )

    def inputs(self, obj):
        return {name: links.faces_or_edges(getattr(obj, name), name) for name in ("A", "B")}

    def options(self, obj):
        return {"tolerance": obj.Tolerance.Value}

    def ask(self, entrance, inputs, options):
        return entrance.intersect(inputs["A"], inputs["B"], **options)

    def facts(self, report):
        curves = report["curves"]
        deviations = [curve["deviation"][side] for curve in curves for side in ("a", "b")]
        return {
            "Status": report["status"],
            "Curves": len(curves),
            "Points": len(report["points"]) + len(report["edge_points"]),
            "Overlaps": len(report["overlaps"]),
            "Length": report["joined"]["length"],
            "Deviation": max(deviations, default=0.0),
            "Reasons": report["certificate"]["reasons"],
        }
