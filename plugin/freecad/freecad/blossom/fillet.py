# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of solids rounded by a rolling ball."""

import FreeCAD

from .blended import LAST_CHOICES, EdgeBlend, facts_of, positive
from .feature import Choice

SECTIONS = ("circle", "conic", "g2", "g3")


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
        Choice("Radii", "lines", [], "Radii of edges",
               "Of edges that have their own: Edge3: 2 mm, or Edge3: 2 mm..4 mm where it changes",
               "Edge3: 2 mm; Edge5: 2 mm..4 mm"),
        Choice("FullRound", "flag", False, "Full round",
               "In place of a radius: those with which two straight edges of one plane face leave "
               "nothing of it, also where they are not parallel"),
        Choice("Setback", "length", "0 mm", "Setback",
               "How far from a vertex of three and more edges their strips end; 0: as near as can be"),
        Choice("Section", "word", "circle", "Section",
               "Circles, conics, or curves that have the curvatures of both faces (g2), and the rates "
               "at which these change (g3)", SECTIONS),
        Choice("Rho", "number", 0.5, "Sharpness",
               "Of conics: near 0 flat, 0.5 a parabola, near 1 sharp", (0.01, 0.99)),
        *LAST_CHOICES,
    )  # fmt: skip
    FACTS = facts_of("Rounded", "rounded")

    def unused(self, obj):
        unused = set() if obj.Section == "conic" else {"Rho"}
        return unused | ({"Radius", "LastRadius", "Radii"} if obj.FullRound else set())

    def size(self, obj):
        if not 0 < obj.Rho < 1:
            raise ValueError(f"Rho: a number between 0 and 1 is wanted, got {obj.Rho:g}")
        return {
            **({"full_round": True} if obj.FullRound else {"radius": _radii(obj)}),
            **({"setback": obj.Setback.Value} if obj.Setback.Value > 0 else {}),
            "section": f"conic:{obj.Rho!r}" if obj.Section == "conic" else obj.Section,
        }

    def ask(self, entrance, inputs, options):
        return entrance.fillet(inputs["Edges"], **options)


def _radii(obj):
    """A radius, a pair of them, or what edges have. throws ValueError"""
    first = positive(obj.Radius, "Radius")
    common = (first, obj.LastRadius.Value) if obj.LastRadius.Value > 0 else first
    own = dict(map(_own_radius, obj.Radii))
    return {None: common, **own} if own else common


def _own_radius(line):
    """The number of an edge and its radius, or a pair of them. throws ValueError"""
    name, _, words = line.partition(":")
    name, sizes = name.strip(), words.split("..")
    number = name[4:] if name.startswith("Edge") else ""
    try:
        if not number.isdecimal() or len(sizes) > 2 or not all(map(str.strip, sizes)):
            raise ValueError
        lengths = [FreeCAD.Units.Quantity(size) for size in sizes]
        if any(each.Unit not in (FreeCAD.Units.Length, FreeCAD.Units.Unit()) for each in lengths):
            raise ValueError
    except Exception:  # FreeCAD has kinds of its own
        raise ValueError(f"Radii: Edge3: 2 mm, or Edge3: 2 mm..4 mm is wanted, got {line!r}") from None
    radii = [positive(each, f"Radii: {name}") for each in lengths]
    return int(number), radii[0] if len(radii) == 1 else tuple(radii)
