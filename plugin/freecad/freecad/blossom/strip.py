# SPDX-License-Identifier: LGPL-2.1-or-later
"""A strip between two faces that continues both."""

from . import links
from .feature import Choice, Fact, Feature, Link

NEAREST = "nearest"
BORDERS = (NEAREST, "umin", "umax", "vmin", "vmax")


class Strip(Feature):
    NAME = "BlendStrip"
    TITLE = "Blend strip"
    TIP = "A surface between the edges of two faces that continues both smoothly"
    DOING = "Blending"
    LINKS = (
        Link("A", "Face", "The face on one side, and an edge of it if not the nearest is meant"),
        Link("B", "Other face", "The face on the other side, likewise"),
    )
    CHOICES = (
        Choice("BorderA", "word", NEAREST, "Border of the face", "Where the strip begins, if no edge is picked", BORDERS),
        Choice("BorderB", "word", NEAREST, "Border of the other", "Where the strip ends, if no edge is picked", BORDERS),
        Choice("Continuity", "word", "G1", "Continuity",
               "Of tangent planes (G1), curvatures (G2), or their derivatives too (G3)",
               ("G1", "G2", "G3")),
        Choice("WeightA", "number", 1.0, "Weight of the face",
               "How far its tangents reach into the strip; 1 is the width over the strip's degree", (0.01, 10)),
        Choice("WeightB", "number", 1.0, "Weight of the other",
               "How far its tangents reach into the strip; 1 is the width over the strip's degree", (0.01, 10)),
    )  # fmt: skip
    FACTS = (
        Fact("Joined", "word", "The borders that were joined"),
        Fact("Gap", "length", "From the faces, at most, mm"),
        Fact("Angle", "angle", "Between the normals, at most, radians"),
    )

    def inputs(self, obj):
        return {name: links.face_with_edge(getattr(obj, name), name)[0] for name in ("A", "B")}

    def options(self, obj):
        return {
            "borders": [_start(obj.A, "A", obj.BorderA), _start(obj.B, "B", obj.BorderB)],
            "continuity": obj.Continuity,
            "weights": [obj.WeightA, obj.WeightB],
        }

    def ask(self, entrance, inputs, options):
        return entrance.strip(
            inputs["A"],
            inputs["B"],
            *options["borders"],
            options["continuity"],
            *options["weights"],
        )

    def facts(self, report):
        continuity = report["continuity"]
        return {
            "Joined": f"{_border(report['a'])} to {_border(report['b'])}",
            "Gap": continuity["gap"],
            "Angle": continuity["normal_angle"],
        }


def _start(link, name, border):
    """The edge that a link names, by its number in the face; else the border's word, or None."""
    _, edge = links.face_with_edge(link, name)
    return edge or (None if border == NEAREST else border)


def _border(end):
    """ "umin", or "edge 3"."""
    return end["edge"] if isinstance(end["edge"], str) else f"edge {end['edge']}"
