# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of solids cut off."""

import math

from .blended import LAST_CHOICES, EdgeBlend, facts_of, positive
from .feature import Choice

EQUAL, TWO, ANGLE = SIZES = ("equal distances", "two distances", "distance and angle")


class Chamfer(EdgeBlend):
    NAME = "Chamfer"
    TITLE = "Chamfer"
    TIP = "Cut edges of a solid off"
    DOING = "Cutting edges off"
    DONE = "CutOff"
    CHOICES = (
        Choice("Size", "word", EQUAL, "Size",
               "How far its borders are from the edge: alike, each its own, or by an angle", SIZES),
        Choice("Distance", "length", "1 mm", "Distance",
               "On the face of the smaller number, or on both"),
        Choice("SecondDistance", "length", "1 mm", "Second distance", "On the other face"),
        Choice("Angle", "angle", 45.0, "Angle", "Between the chamfer and the first face"),
        *LAST_CHOICES,
    )  # fmt: skip
    FACTS = facts_of("CutOff", "cut off")

    def unused(self, obj):
        return {EQUAL: {"SecondDistance", "Angle"}, TWO: {"Angle"}, ANGLE: {"SecondDistance"}}[obj.Size]

    def size(self, obj):
        first = positive(obj.Distance, "Distance")
        if obj.Size == TWO:
            return {"distance": (first, positive(obj.SecondDistance, "SecondDistance"))}
        if obj.Size == ANGLE:
            degrees = positive(obj.Angle, "Angle")
            if degrees >= 180:
                raise ValueError(f"Angle: less than 180 degrees are wanted, got {degrees:g}")
            return {"distance": first, "angle": math.radians(degrees)}
        return {"distance": first}

    def ask(self, entrance, inputs, options):
        return entrance.chamfer(inputs["Edges"], **options)
