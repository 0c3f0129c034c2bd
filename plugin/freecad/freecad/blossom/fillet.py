# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of solids rounded by a rolling ball."""

from .blended import LAST_CHOICES, EdgeBlend, facts_of, positive
from .feature import Choice

CIRCLE = 0.0  # as Rho


class Fillet(EdgeBlend):
    NAME = "Fillet"
    TITLE = "Fillet"
    TIP = "Round edges of a solid by a ball that rolls along them"
    DOING = "Rounding edges"
    DONE = "Rounded"
    CHOICES = (
        Choice("Radius", "length", "1 mm", "Radius", "Of the ball"),
        Choice("LastRadius", "length", "0 mm", "Radius at the end",
               "Where a run of edges ends, if it is another than at its start; 0: it is not"),
        Choice("Rho", "number", CIRCLE, "Sharpness",
               "0: sections are circles; else conics, 0.5 a parabola, near 1 sharp", (0.0, 0.99)),
        *LAST_CHOICES,
    )  # fmt: skip
    FACTS = facts_of("Rounded", "rounded")

    def size(self, obj):
        first = positive(obj.Radius, "Radius")
        if not 0 <= obj.Rho < 1:
            raise ValueError(f"Rho: 0, or a number below 1 is wanted, got {obj.Rho:g}")
        return {
            "radius": (first, obj.LastRadius.Value) if obj.LastRadius.Value > 0 else first,
            "section": "circle" if obj.Rho == CIRCLE else f"conic:{obj.Rho!r}",
        }

    def ask(self, entrance, inputs, options):
        return entrance.fillet(inputs["Edges"], **options)
