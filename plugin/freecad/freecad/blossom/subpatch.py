# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part of a face's surface as untrimmed faces, exactly, by blossoms."""

from . import links
from .feature import Choice, Fact, Feature, Link

MOST_LEVELS = 8


def _part(name, value, label, tip):
    return Choice(name, "number", value, label, tip, (0.0, 1.0))


class SubPatch(Feature):
    NAME = "SubPatch"
    TITLE = "Sub-patch"
    TIP = "A part of a face's surface as Bezier faces without trims, exactly"
    DOING = "Subdividing"
    LINKS = (Link("Face", "Face", "The face whose surface is divided"),)
    CHOICES = (
        _part("UFrom", 0.0, "u from", "Where the part begins along u: 0 is the face's least u"),
        _part("UTo", 1.0, "u to", "Where the part ends along u: 1 is the face's largest u"),
        _part("VFrom", 0.0, "v from", "Where the part begins along v: 0 is the face's least v"),
        _part("VTo", 1.0, "v to", "Where the part ends along v: 1 is the face's largest v"),
        Choice("Levels", "count", 0, "Halvings", "How often each direction is halved",
               (0, MOST_LEVELS)),
    )  # fmt: skip
    FACTS = (
        Fact("Pieces", "count", "How many faces there are"),
        Fact("Degrees", "words", "Of the pieces, along u and v"),
        Fact("Deviation", "length", "How far they are from the face's surface, at most, mm"),
    )

    def inputs(self, obj):
        return {"Face": links.one_face(obj.Face, "Face")}

    def options(self, obj):
        if not 0 <= obj.Levels <= MOST_LEVELS:
            raise ValueError(f"Levels: 0 to {MOST_LEVELS} are wanted, got {obj.Levels}")
        u0, u1, v0, v1 = links.one_face(obj.Face, "Face").ParameterRange
        u = [u0 + part * (u1 - u0) for part in _range(obj.UFrom, obj.UTo, "UFrom, UTo")]
        v = [v0 + part * (v1 - v0) for part in _range(obj.VFrom, obj.VTo, "VFrom, VTo")]
        return {"rectangle": (*u, *v), "levels": obj.Levels}

    def ask(self, entrance, inputs, options):
        return entrance.subdivide(inputs["Face"], **options)

    def facts(self, report):
        nets = report["nets"]
        return {
            "Pieces": len(nets),
            "Degrees": sorted({"{} x {}".format(*net["degree"]) for net in nets}),
            "Deviation": max(net.get("error", 0.0) for net in nets),
        }


def _range(begin, end, name):
    if not 0 <= begin < end <= 1:
        raise ValueError(f"{name}: 0 <= from < to <= 1 is wanted, got {begin:g} and {end:g}")
    return begin, end
