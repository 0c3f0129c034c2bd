# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of solids rounded by a rolling ball."""

from . import links
from .feature import TOLERANCE, Choice, Fact, Feature, Link


class Fillet(Feature):
    NAME = "Fillet"
    TITLE = "Fillet"
    TIP = "Round edges of a solid by a ball that rolls along them"
    DOING = "Rounding edges"
    HIDES = True
    LINKS = (
        Link("Edges", "Edges", "Edges of one solid, or faces for all of theirs, or the object for "
             "all that it has"),
    )  # fmt: skip
    CHOICES = (
        Choice("Radius", "length", "1 mm", "Radius", "Of the ball"),
        Choice("Partial", "flag", False, "Leave out what cannot be made",
               "Round the edges that can be rounded, instead of all or none"),
        TOLERANCE,
    )  # fmt: skip
    FACTS = (
        Fact("Status", "word", "complete, or stopped"),
        Fact("Rounded", "counts", "The numbers of the edges that are rounded"),
        Fact("Volume", "number", "Afterwards, cubic mm"),
        Fact("Refused", "words", "Edges that cannot be rounded, and why"),
        Fact("Notes", "words", "How strips end, where that is not what one would think"),
    )

    def inputs(self, obj):
        whole, _ = links.whole_with_edges(obj.Edges, "Edges")
        if not whole.Solids:
            raise ValueError("Edges: those of a solid are wanted, the object has no solid")
        return {"Edges": whole}

    def options(self, obj):
        _, numbers = links.whole_with_edges(obj.Edges, "Edges")
        if obj.Radius.Value <= 0:
            raise ValueError("Radius: it has to be positive")
        return {
            "edges": numbers or "all",
            "radius": obj.Radius.Value,
            "partial": obj.Partial,
            "tolerance": obj.Tolerance.Value,
        }

    def ask(self, entrance, inputs, options):
        return entrance.fillet(inputs["Edges"], **options)

    def facts(self, report):
        return {
            "Status": report["status"],
            "Rounded": report["edges"],
            "Volume": report["volume"]["after"] or 0.0,
            "Refused": [_refusal(each) for each in report["refused"]],
            "Notes": report["notes"],
        }

    def shape(self, obj, answer, inputs):
        if answer.shape is None:
            raise RuntimeError(obj.Refused[0] if obj.Refused else "nothing was rounded")
        return answer.shape


def _refusal(refused):
    where = f"Edge{refused['edge']}: " if refused["edge"] else ""
    largest = refused["largest_radius"]
    hint = f"; the largest radius is {largest:.6g} mm" if largest else ""
    return f"{where}{refused['cause']}{hint}"
