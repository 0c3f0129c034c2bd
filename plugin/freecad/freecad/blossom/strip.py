# SPDX-License-Identifier: LGPL-2.1-or-later
"""A strip between two faces that continues both with their tangent planes."""

from . import links
from .feature import Choice, Fact, Feature, Link

NEAREST = "nearest"
BORDERS = (NEAREST, "umin", "umax", "vmin", "vmax")


class Strip(Feature):
    NAME = "BlendStrip"
    TITLE = "Blend strip"
    TIP = "A surface between the borders of two faces that continues both with their tangent planes"
    DOING = "Blending"
    LINKS = (
        Link("A", "Face", "The face on one side"),
        Link("B", "Other face", "The face on the other side"),
    )
    CHOICES = (
        Choice("BorderA", "word", NEAREST, "Border of the face", "Where the strip begins", BORDERS),
        Choice("BorderB", "word", NEAREST, "Border of the other", "Where the strip ends", BORDERS),
        Choice("WeightA", "number", 1.0, "Weight of the face",
               "How far its tangents reach into the strip; 1 is a third of the width", (0.01, 10)),
        Choice("WeightB", "number", 1.0, "Weight of the other",
               "How far its tangents reach into the strip; 1 is a third of the width", (0.01, 10)),
    )  # fmt: skip
    FACTS = (
        Fact("Joined", "word", "The borders that were joined"),
        Fact("Gap", "number", "From the faces, at most, mm"),
        Fact("Angle", "number", "Between the normals, at most, radians"),
    )

    def inputs(self, obj):
        return {"A": links.one_face(obj.A, "A"), "B": links.one_face(obj.B, "B")}

    def options(self, obj):
        borders = [None if word == NEAREST else word for word in (obj.BorderA, obj.BorderB)]
        return {"borders": borders, "weights": [obj.WeightA, obj.WeightB]}

    def ask(self, entrance, inputs, options):
        return entrance.strip(inputs["A"], inputs["B"], *options["borders"], *options["weights"])

    def facts(self, report):
        continuity = report["continuity"]
        return {
            "Joined": f"{report['a']['edge']} to {report['b']['edge']}",
            "Gap": continuity["gap"],
            "Angle": continuity["normal_angle"],
        }
