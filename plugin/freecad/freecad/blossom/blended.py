# SPDX-License-Identifier: LGPL-2.1-or-later
"""What fillets and chamfers have in common: edges of one solid, and what became of them."""

from . import links
from .feature import TOLERANCE, Choice, Fact, Feature, Link

EDGES = Link(
    "Edges", "Edges", "Edges of one solid, or faces for all of theirs, or the object for all that "
    "it has"
)  # fmt: skip
LAST_CHOICES = (
    Choice("Partial", "flag", False, "Leave out what cannot be made",
           "Make it at the edges where it can be made, instead of all or none"),
    TOLERANCE,
)  # fmt: skip


def facts_of(done, doing):
    """Facts; `done` is the name of the one with the edges' numbers."""
    return (
        Fact("Status", "word", "complete, tolerance: some edges are left out, refused, or stopped"),
        Fact(done, "edges", f"The numbers of the edges that are {doing}"),
        Fact("Volume", "volume", "Afterwards, cubic mm"),
        Fact("Refused", "words", f"Edges that cannot be {doing}, and why"),
        Fact("Notes", "words", "How strips end, where that is not what one would think"),
    )


class EdgeBlend(Feature):
    """Edges of solids that become faces."""

    HIDES = True
    LINKS = (EDGES,)
    DONE = ""  # the fact with the numbers of edges

    def inputs(self, obj):
        whole, _ = links.whole_with_edges(obj.Edges, "Edges")
        if not whole.Solids:
            wrong = links.without_solid(whole, links.shown(links.members(obj.Edges)[0][0], ""))
            raise ValueError(f"Edges: those of a solid are wanted, {wrong}")
        return {"Edges": whole}

    def options(self, obj):
        _, numbers = links.whole_with_edges(obj.Edges, "Edges")
        return {
            "edges": numbers or "all",
            "partial": obj.Partial,
            "tolerance": obj.Tolerance.Value,
            **self.size(obj),
        }

    def size(self, obj):
        """What the blend is like across its edge. throws ValueError"""
        raise NotImplementedError

    def facts(self, report):
        return {
            "Status": report["status"],
            self.DONE: report["edges"],
            "Volume": report["volume"]["after"] or 0.0,
            "Refused": [_refusal(each, report["kind"]) for each in report["refused"]],
            "Notes": report["notes"],
        }

    def nothing(self, obj):
        return obj.Refused[0] if obj.Refused else "no edge was changed"


def positive(length, name):
    """A length's value. throws ValueError"""
    if length.Value <= 0:
        raise ValueError(f"{name}: it has to be positive")
    return length.Value


def _refusal(refused, kind):
    where = f"Edge{refused['edge']}: " if refused["edge"] else ""
    largest = refused["largest_radius"]
    size = "distance" if kind == "chamfer" else "radius"
    hint = f"; the largest {size} is {largest:.6g} mm" if largest else ""
    return f"{where}{refused['cause']}{hint}"
