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
        solid, _, _ = _chosen(obj)
        if not solid.Solids:
            wrong = links.without_solid(solid, _label(obj))
            raise ValueError(f"Edges: those of a solid are wanted, {wrong}")
        return {"Edges": solid}

    def options(self, obj):
        _, numbers, become = _chosen(obj)
        size = self.size(obj)
        if become and isinstance(size.get("radius"), dict):
            size["radius"] = {
                each: radius
                for edge, radius in size["radius"].items()
                for each in ([edge] if edge is None else become(edge))
            }
        return {
            "edges": numbers or "all",
            "partial": obj.Partial,
            "tolerance": obj.Tolerance.Value,
            **size,
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

    def take(self, obj, question, answer):
        solid, _, become = _chosen(obj)
        if become is not None:
            answer = answer._replace(report=_renumbered(answer.report, solid, obj))
        super().take(obj, question, answer)

    def nothing(self, obj):
        return obj.Refused[0] if obj.Refused else "no edge was changed"


def _label(obj):
    return links.shown(links.members(obj.Edges)[0][0], "")


def _chosen(obj):
    """The solid, the numbers of its edges that are meant, and if it is made of loose faces what
    tells which of its edges one of theirs has become. throws ValueError"""
    whole, numbers = links.whole_with_edges(obj.Edges, "Edges")
    solid = links.solid_of(whole, _label(obj))
    if solid is whole:
        return whole, numbers, None
    edges, find = whole.Edges, links.finder_within(solid)

    def become(number):
        if not 1 <= number <= len(edges):
            raise ValueError(f"Edges: there is no Edge{number}, there are {len(edges)}")
        if not (found := find(edges[number - 1])):
            raise ValueError(f"Edges: Edge{number} is none of the solid that the faces close")
        return found

    # Edges that are points, as faces have them, have no counterpart.
    real = [number for number in numbers if not edges[number - 1].Degenerated]
    if numbers and not real:
        raise ValueError("Edges: none of these is an edge of the solid that the faces close")
    return solid, sorted({each for number in real for each in become(number)}), become


def _renumbered(report, solid, obj):
    """The report with the numbers that edges have in the object, of two that are one now the lesser
    one."""
    whole, _ = links.whole_with_edges(obj.Edges, "Edges")
    own, find = {}, links.finder_within(solid)
    for number, edge in enumerate(whole.Edges, start=1):
        for each in find(edge):
            own.setdefault(each, number)
    return {
        **report,
        "edges": sorted({own.get(each, each) for each in report["edges"]}),
        "refused": [
            {**each, "edge": own.get(each["edge"], each["edge"])} for each in report["refused"]
        ],
    }


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
