# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes made of a model: trimmed, combined, blended, and in other forms."""

from typing import Any, List, Literal, Mapping, Optional, Tuple, Union, overload

from . import _blend_checks, _checks, _core, _results, _shapes
from ._bodies import Chamfer, Fill, Fillet, Solid, Trim, Watertight
from ._forms import Conversion, Subdivision, Whole

Radius = Union[float, Tuple[float, float]]
# Of all edges, or of edges by number, of those without by None; laws are mappings, too.
Radii = Union[Radius, Mapping[Union[int, str, None], Union[Radius, Mapping[str, Any]]]]


def core_of(shape: Any, name: str) -> _core.Model:
    """What the core takes for a shape."""
    if isinstance(shape, _results.MadeShape):
        return shape._core_model()
    return _shapes.core_model(shape, name)


def cutters_of(
    question: str, shapes: Any, planes: Any
) -> Tuple[List[_core.Model], List[Tuple[_checks.Triple, _checks.Triple]]]:
    """Tools and planes, of which there is at least one. Tools may be in lists, as Part takes them."""
    listed: List[Any] = []
    for shape in shapes:
        listed += shape if isinstance(shape, (list, tuple)) else [shape]
    tools = [core_of(shape, f"tool {i}") for i, shape in enumerate(listed, start=1)]
    given = _checks.planes(planes, "planes")
    if not tools and not given:
        raise ValueError(f"{question} needs a tool, or a plane")
    return tools, given


class Operations(_results.MadeShape):
    """What makes new shapes of a model."""

    def trim(
        self, *tools: Any, keep: Union[str, int], planes: Any = (), **options: Any
    ) -> Trim:
        """The faces cut along their intersections with tools.

        tools    one by one, or in a list
        keep     "above" (where the tools' normals point), "below", "inside", "outside" (of solid
                 tools), "all", or the number of a piece
        planes   pairs (point, normal) that cut, too
        """
        if isinstance(keep, bool) or not isinstance(keep, (str, int)):
            raise TypeError(f"keep: a word or a number is wanted, got {_checks.kind(keep)}")
        control = _checks.control(options, own=("keep", "planes"))
        cutters, listed = cutters_of("trim", tools, planes)
        return Trim(_core.trim(self._core_model(), cutters, listed, str(keep), control))

    def solid(
        self,
        operation: str,
        *tools: Any,
        planes: Any = (),
        fuzzy: float = 0,
        **options: Any,
    ) -> Solid:
        """The closed solid or the sheet combined with others.

        tools       one by one, or in a list
        operation   "cut", "common", "fuse", or "split": cut and common side by side. Sheets are cut
                    by solids, divided by sheets and fused with them, and they split solids;
                    edges without faces are cut by all of these
        planes      pairs (point, normal); what is above cuts like a tool
        fuzzy       what is up to so much farther apart than the tolerance counts as one
        """
        wanted = _checks.word(operation, "operation", _checks.OPERATIONS)
        more = _checks.not_negative(fuzzy, "fuzzy")
        control = _checks.control(options, more, own=("planes", "fuzzy"))
        cutters, listed = cutters_of("solid", tools, planes)
        return Solid(_core.solid(wanted, self._core_model(), cutters, listed, control))

    def fillet(
        self,
        edges: Any = (),
        *,
        radius: Optional[Radii] = None,
        law: Optional[Mapping[str, Any]] = None,
        section: str = "circle",
        setback: Optional[float] = None,
        full_round: bool = False,
        between: Any = None,
        partial: bool = False,
        **options: Any,
    ) -> Fillet:
        """Edges of solids rounded by a ball that rolls along them.

        edges     numbers, as in "Edge1", or "all", "convex" or "concave"
        radius    a number; or a pair, from the start to the end of each run of edges; or a mapping
                  of edges to their own, of None to that of all others: {12: 5, 14: (2, 4), None: 1}
        law       instead of it {"law": "smooth", "radii": [2, 5]}, or "linear", or "table" with
                  shares of the run's length, as {"law": "table", "at": [0, 0.3, 1], "radii": ...}
        section   "circle"; "conic:0.4": how far the shoulder is on the way from the chord to where
                  the end tangents meet, between 0 (flat) and 1 (sharp); "g2", which has the
                  curvatures of both faces; or "g3", also with the rates at which these change
        setback   how far from a vertex of three and more edges their strips end
        full_round  in place of a radius: those with which two straight edges of one plane face leave
                  nothing of it, also where they are not parallel
        between   two face numbers: the edges that they have in common
        partial   round the edges that can be, instead of all or none; see `refused`
        """
        if isinstance(radius, Mapping) and between is None and not isinstance(edges, str):
            edges = list(edges) or [edge for edge in radius if edge is not None]
        chosen = _blend_checks.edge_wish("fillet", edges, between)
        fully = _checks.flag(full_round, "full_round")
        size = _blend_checks.fillet_size(radius, law, fully, chosen)
        across = _blend_checks.section(section, "section")
        back = None if setback is None else _checks.positive(setback, "setback")
        whole = _checks.flag(partial, "partial")
        control = _checks.control(options)
        return Fillet(
            _core.fillet(self._core_model(), *chosen, *size, across, back, fully, whole, control)
        )

    def chamfer(
        self,
        edges: Any = (),
        *,
        distance: Radius,
        angle: Optional[float] = None,
        between: Any = None,
        partial: bool = False,
        **options: Any,
    ) -> Chamfer:
        """Edges of solids cut off.

        edges      as of `fillet`, with `between` and `partial`
        distance   of its borders from the edge: one, or a pair, on the face of the smaller number
                   and on the other
        angle      instead of the second one: between the chamfer and the first face, radians
        """
        chosen = _blend_checks.edge_wish("chamfer", edges, between)
        size = _blend_checks.chamfer_size(distance, angle)
        whole = _checks.flag(partial, "partial")
        return Chamfer(_core.chamfer(self._core_model(), *chosen, *size, whole, _checks.control(options)))

    def fill(
        self,
        edges: Any = (),
        *,
        continuity: Any = "G1",
        layout: str = "auto",
        angle: float = 1e-6,
        sew: bool = False,
        **options: Any,
    ) -> Fill:
        """Patches in holes of 3 to 12 sides that continue their neighbours; flat faces in round holes.

        edges       round the holes, by number and in any order; all open ones if none is given
        continuity  "G0", "G1" or "G2": one for all edges, or one for each
        layout      "auto", "star", "ring" or "deep-ring"
        angle       between normals that counts as smooth, radians
        sew         the shape is the model with the patches, not the patches alone
        """
        numbers = _checks.numbers_of(edges, "edges", "edge")
        words = _blend_checks.smoothness(continuity, "continuity", len(numbers))
        return Fill(
            _core.fill(
                self._core_model(),
                numbers,
                words,
                _checks.word(layout, "layout", _checks.LAYOUTS),
                _checks.angle(angle, "angle"),
                _checks.flag(sew, "sew"),
                _checks.control(options),
            )
        )

    @overload
    def subdivide(
        self,
        rectangle: Any = None,
        *,
        interval: Any = None,
        triangle: Any = None,
        levels: int = 0,
        q: Any = None,
        whole: Literal[False] = False,
        **options: Any,
    ) -> Subdivision: ...

    @overload
    def subdivide(
        self, rectangle: Any = None, *, interval: Any = None, whole: Literal[True], **options: Any
    ) -> Whole: ...

    def subdivide(
        self,
        rectangle: Any = None,
        *,
        interval: Any = None,
        triangle: Any = None,
        levels: int = 0,
        q: Any = None,
        whole: bool = False,
        **options: Any,
    ) -> Union[Subdivision, Whole]:
        """Sub-patches of the faces, or sub-curves of the edges, by blossoms.

        rectangle  (u0, u1, v0, v1): this part of faces
        interval   (a, b): this part of edges
        triangle   three pairs (u, v): the triangular patch over them
        levels     halve so often in each direction
        q          (q1, q2): pieces by their (q1, q2)-Bezier points
        whole      each face, or edge, as one B-spline; takes a rectangle or an interval alone

        Without a place all of it: of the faces, or of the edges if there is no face.
        """
        places = [interval, rectangle, triangle]
        if sum(place is not None for place in places) > 1:
            raise ValueError("one of rectangle, interval and triangle is wanted, not several")
        run = _checks.number_list(interval, "interval", 2)
        area = _checks.number_list(rectangle, "rectangle", 4)
        over = _checks.corners(triangle, "triangle")
        basis = _checks.number_list(q, "q", 2)
        halvings = _checks.whole(levels, "levels", 0)
        control = _checks.control(options)
        if not _checks.flag(whole, "whole"):
            return Subdivision(
                _core.subdivide(self._core_model(), run, area, over, basis, halvings, control)
            )
        if over or basis or halvings:
            raise ValueError("whole: it takes a rectangle or an interval alone")
        return Whole(_core.subdivide_whole(self._core_model(), run, area, control))

    def convert(self, to: str, **options: Any) -> Conversion:
        """The faces in another form.

        to   "bezier" and "triangles" follow the trims, within `tolerance`; "monomial" leaves them
             out, and has no shape
        """
        wanted = _checks.word(to, "to", _checks.TARGETS)
        return Conversion(_core.convert(self._core_model(), wanted, _checks.control(options)))

    def watertight(self, **options: Any) -> Watertight:
        """The faces as untrimmed patches and triangles that meet without gaps."""
        return Watertight(_core.watertight(self._core_model(), _checks.control(options)))
