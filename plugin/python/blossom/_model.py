# SPDX-License-Identifier: LGPL-2.1-or-later
"""A model that stays in memory, and the questions it answers."""

import os
from typing import Any, Dict, Iterator, List, Literal, Mapping, Optional, Tuple, Union, overload

from . import _checks, _core, _results, _shapes
from ._bodies import Chamfer, Fill, Fillet, Solid, Trim, Watertight
from ._clashes import Clash
from ._forms import Conversion, Subdivision, Whole
from ._intersections import Intersection, SelfIntersection
from ._meshes import Mesh
from ._queries import Check, Continuity, Distance, FootPoints, Mass, Meeting, RayHits
from ._sections import Section, Sections

FileName = Union[str, "os.PathLike[str]"]
Radius = Union[float, Tuple[float, float]]
# Of all edges, or of edges by number, of those without by None; laws are mappings, too.
Radii = Union[Radius, Mapping[Union[int, str, None], Union[Radius, Mapping[str, Any]]]]


class Model(_results.MadeShape):
    """A model with what questions about it have made ready, so that the next one is quick.

    A model of a file is repaired when the first question needs that; shapes that are passed are
    never changed. Questions from several threads wait for each other.
    """

    def __init__(self, core: _core.Model) -> None:
        if not isinstance(core, _core.Model):
            raise TypeError("models are made by blossom.read, shape, surface and curve")
        self._core = core

    def _core_model(self) -> _core.Model:
        return self._core

    @property
    def name(self) -> str:
        """What reports call it: the file as it was given."""
        return self._core.name

    @property
    def file(self) -> Optional[str]:
        return self._core.file or None

    @property
    def file_unit(self) -> Optional[str]:
        """Of the file, "MM" or "INCH"; in memory all is millimetre."""
        return self._core.file_unit or None

    @property
    def face_count(self) -> int:
        return self._core.face_count

    @property
    def counts(self) -> Dict[str, int]:
        """How many solids, shells, faces, edges and vertices there are in the whole model."""
        return self._core.counts

    @property
    def face_numbers(self) -> List[int]:
        return self._core.numbers()

    @property
    def face_names(self) -> List[str]:
        """For each face of the whole model its name, or its part's; empty if neither has one."""
        return self._core.face_names()

    @property
    def part_paths(self) -> List[str]:
        """Likewise where the part is used, as "machine:2/bolt:1"."""
        return self._core.part_paths()

    @property
    def reading(self) -> Optional[Dict[str, Any]]:
        """What reading the file lost: `grade` and `losses`; None if it came from no file."""
        return self._core.reading

    @property
    def repairs(self) -> Dict[str, Any]:
        """What was changed so far to use it."""
        return self._core.repairs()

    def __len__(self) -> int:
        return self.face_count

    def __iter__(self) -> Iterator["Model"]:
        """Its faces, as models."""
        return (self.face(number) for number in self.face_numbers)

    def __bool__(self) -> bool:
        return True

    def __repr__(self) -> str:
        count = self.face_count
        return f"<blossom.Model: {self.name}, {count} face{'' if count == 1 else 's'}>"

    def __reduce__(self) -> Any:
        return (_from_brep, (self.name, self.to_brep()))

    def face(self, number: Union[int, str]) -> "Model":
        """One face, by its number from 1 on, which it keeps; or "Face3"."""
        return self.part([number])

    def part(self, numbers: Any) -> "Model":
        """Some faces, by their numbers, as "Face3", or those of a part, as "Shaft"; they share the
        model."""
        if isinstance(numbers, str):
            listed = _shapes.faces_named(self._core, numbers, "numbers")
            return Model(self._core.part(listed, f"{self.name}#{numbers}"))
        listed = _checks.face_numbers(numbers, "numbers")
        name = f"{self.name}#{','.join(map(str, listed))}"
        return Model(self._core.part(listed, name))

    def info(self, edges: bool = False, **options: Any) -> Dict[str, Any]:
        """What the model is made of, as `blossom info` reports it; with all its edges, too."""
        listed = _checks.flag(edges, "edges")
        return _core.info(self._core, listed, _checks.control(options)).report(True)

    def continuity(
        self,
        gap: float = 1e-3,
        angle: float = 1e-3,
        curvature: float = 1e-2,
        require: Optional[str] = None,
        **options: Any,
    ) -> Continuity:
        """How smoothly faces meet along every edge.

        gap        faces less apart meet (G0), model units
        angle      normals less turned are one (G1), radians
        curvature  curvatures that differ by less, relative to the larger, are one (G2)
        require    "G0", "G1" or "G2": what is less smooth is `failing`; G0 if None
        """
        return Continuity(
            _core.continuity(
                self._core,
                _checks.positive(gap, "gap"),
                _checks.angle(angle, "angle"),
                _checks.positive(curvature, "curvature"),
                "" if require is None else _checks.word(require, "require", _checks.SMOOTHNESS),
                _checks.control(options),
            )
        )

    def check(self, **options: Any) -> Check:
        """What is wrong with it, with gaps measured beside stated tolerances."""
        return Check(_core.check(self._core, _checks.control(options)))

    def intersect(self, other: Any, **options: Any) -> Intersection:
        """All intersections with another shape."""
        b = _core_of(other, "other")
        return Intersection(_core.intersect(self._core, b, _checks.control(options)))

    def self_intersect(self, faces: bool = False, **options: Any) -> SelfIntersection:
        """Where each face meets itself; with `faces`, also different faces each other."""
        return SelfIntersection(
            _core.self_intersect(
                self._core, _checks.flag(faces, "faces"), _checks.control(options)
            )
        )

    def section(self, point: Any, normal: Any, **options: Any) -> Section:
        """The section with the plane through a point; the normal may have any length."""
        return Section(
            _core.section(
                self._core,
                _checks.vector(point, "point"),
                _checks.vector(normal, "normal"),
                _checks.control(options),
            )
        )

    def sections(
        self,
        planes: Any = None,
        *,
        offsets: Any = None,
        point: Any = (0, 0, 0),
        normal: Any = (0, 0, 1),
        **options: Any,
    ) -> Sections:
        """The sections with many planes, for which it is made ready once.

        planes          pairs (point, normal), or triples with a name behind them
        offsets         instead: of parallel planes, from the point along the normal
        point, normal   of offsets
        """
        listed = _checks.planes_of_sections(planes, offsets, point, normal)
        return Sections(_core.sections(self._core, listed, _checks.control(options)))

    def clash(
        self,
        other: Any = None,
        *,
        clearance: Optional[float] = None,
        far: bool = False,
        **options: Any,
    ) -> Clash:
        """How its parts lie to each other, or to those of another model.

        clearance   distances up to this are measured; None: those of pairs whose boxes meet, and of
                    a part that meets no other that of the nearest
        far         list pairs of which only the boxes were looked at, too: the square of the parts
        """
        b = None if other is None else _core_of(other, "other")
        least = None if clearance is None else _checks.not_negative(clearance, "clearance")
        listed = _checks.flag(far, "far")
        return Clash(_core.clash(self._core, b, least, listed, _checks.control(options)))

    def mesh(
        self,
        deviation: Optional[float] = None,
        *,
        angle: Optional[float] = None,
        edge_length: Optional[float] = None,
        aspect: Optional[float] = None,
        **options: Any,
    ) -> Mesh:
        """Triangles of its faces, which meet in common points along edges.

        deviation     how far they may be from the faces, model units; a thousandth of the size
        angle         how far normals may turn along a side, about; 0.5 radians
        edge_length   how long sides may be, about; any
        aspect        how much longer than wide they may be where faces bend, about; 16
        """
        facets = _checks.facets(deviation, angle, edge_length, aspect)
        return Mesh(_core.mesh(self._core, *facets, _checks.control(options)))

    def ray(
        self, origin: Any, direction: Any, first: bool = False, line: bool = False, **options: Any
    ) -> RayHits:
        """What a ray hits, in order; with `first` no more than the first, with `line` both ways."""
        return RayHits(
            _core.ray(
                self._core,
                _checks.vector(origin, "origin"),
                _checks.vector(direction, "direction"),
                _checks.flag(first, "first"),
                _checks.flag(line, "line"),
                _checks.control(options),
            )
        )

    def distance(self, other: Any, **options: Any) -> Distance:
        """How far another shape is, 0 if one is inside of the other, and how they lie."""
        b = _core_of(other, "other")
        return Distance(_core.distance(self._core, b, _checks.control(options)))

    def does_intersect(self, other: Any, **options: Any) -> Meeting:
        """Whether there is a common point, as early as that is known."""
        b = _core_of(other, "other")
        return Meeting(_core.does_intersect(self._core, b, _checks.control(options)))

    def foot_points(self, at: Any, all: bool = True, **options: Any) -> FootPoints:
        """The nearest point to a point; with `all` every point where the distance is
        stationary."""
        return FootPoints(
            _core.nearest(
                self._core,
                _checks.vector(at, "at"),
                _checks.flag(all, "all"),
                _checks.control(options),
            )
        )

    def mass(self, **options: Any) -> Mass:
        """Volume, area, centre of gravity and inertia, of closed solids and of other faces."""
        return Mass(_core.mass(self._core, _checks.control(options)))

    @property
    def volume(self) -> float:
        """Of all closed solids, cubic millimetres; 0 if there is none. See `mass`."""
        return self.mass().volume

    @property
    def area(self) -> float:
        """Of all faces, square millimetres. See `mass`."""
        return self.mass().area

    def trim(
        self, *tools: Any, keep: Union[str, int], planes: Any = (), **options: Any
    ) -> Trim:
        """The faces cut along their intersections with tools.

        keep     "above" (where the tools' normals point), "below", "inside", "outside" (of solid
                 tools), "all", or the number of a piece
        planes   pairs (point, normal) that cut, too
        """
        if isinstance(keep, bool) or not isinstance(keep, (str, int)):
            raise TypeError(f"keep: a word or a number is wanted, got {_checks.kind(keep)}")
        cutters, listed = _cutters("trim", tools, planes)
        return Trim(
            _core.trim(self._core, cutters, listed, str(keep), _checks.control(options))
        )

    def solid(
        self,
        operation: str,
        *tools: Any,
        planes: Any = (),
        fuzzy: float = 0,
        **options: Any,
    ) -> Solid:
        """The closed solid or the sheet combined with others.

        operation   "cut", "common", "fuse", or "split": cut and common side by side. Sheets are cut
                    by solids, divided by sheets and fused with them, and they split solids
        planes      pairs (point, normal); what is above cuts like a tool
        fuzzy       what is up to so much farther apart than the tolerance counts as one
        """
        wanted = _checks.word(operation, "operation", _checks.OPERATIONS)
        cutters, listed = _cutters("solid", tools, planes)
        control = _checks.control(options, _checks.not_negative(fuzzy, "fuzzy"))
        return Solid(_core.solid(wanted, self._core, cutters, listed, control))

    def fillet(
        self,
        edges: Any = (),
        *,
        radius: Optional[Radii] = None,
        law: Optional[Mapping[str, Any]] = None,
        section: str = "circle",
        setback: Optional[float] = None,
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
                  the end tangents meet, between 0 (flat) and 1 (sharp); or "g2", which has the
                  curvatures of both faces
        setback   how far from a vertex of three and more edges their strips end
        between   two face numbers: the edges that they have in common
        partial   round the edges that can be, instead of all or none; see `refused`
        """
        if isinstance(radius, Mapping) and between is None and not isinstance(edges, str):
            edges = list(edges) or [edge for edge in radius if edge is not None]
        chosen = _checks.edge_wish("fillet", edges, between)
        size = _checks.fillet_size(radius, law, chosen)
        across = _checks.section(section, "section")
        back = None if setback is None else _checks.positive(setback, "setback")
        whole = _checks.flag(partial, "partial")
        return Fillet(
            _core.fillet(self._core, *chosen, *size, across, back, whole, _checks.control(options))
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
        chosen = _checks.edge_wish("chamfer", edges, between)
        size = _checks.chamfer_size(distance, angle)
        whole = _checks.flag(partial, "partial")
        return Chamfer(_core.chamfer(self._core, *chosen, *size, whole, _checks.control(options)))

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
        """Patches in holes of 3 to 12 sides that continue their neighbours.

        edges       round the holes, by number and in any order; all open ones if none is given
        continuity  "G0", "G1" or "G2": one for all edges, or one for each
        layout      "auto", "star", "ring" or "deep-ring"
        angle       between normals that counts as smooth, radians
        sew         the shape is the model with the patches, not the patches alone
        """
        numbers = _checks.numbers_of(edges, "edges", "edge")
        words = _checks.smoothness(continuity, "continuity", len(numbers))
        return Fill(
            _core.fill(
                self._core,
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
                _core.subdivide(self._core, run, area, over, basis, halvings, control)
            )
        if over or basis or halvings:
            raise ValueError("whole: it takes a rectangle or an interval alone")
        return Whole(_core.subdivide_whole(self._core, run, area, control))

    def convert(self, to: str, **options: Any) -> Conversion:
        """The faces in another form.

        to   "bezier" and "triangles" follow the trims, within `tolerance`; "monomial" leaves them
             out, and has no shape
        """
        wanted = _checks.word(to, "to", _checks.TARGETS)
        return Conversion(_core.convert(self._core, wanted, _checks.control(options)))

    def watertight(self, **options: Any) -> Watertight:
        """The faces as untrimmed patches and triangles that meet without gaps."""
        return Watertight(_core.watertight(self._core, _checks.control(options)))


def _from_brep(name: str, brep: bytes) -> Model:
    return Model(_core.read_bytes(brep, name))


def _core_of(shape: Any, name: str) -> _core.Model:
    if isinstance(shape, Model):
        return shape._core
    if isinstance(shape, _results.MadeShape):
        return shape._core_model()
    return _shapes.core_model(shape, name)


def _cutters(
    question: str, shapes: Any, planes: Any
) -> Tuple[List[_core.Model], List[Tuple[_checks.Triple, _checks.Triple]]]:
    """Tools and planes, of which there is at least one."""
    tools = [_core_of(shape, f"tool {i}") for i, shape in enumerate(shapes, start=1)]
    listed = _checks.planes(planes, "planes")
    if not tools and not listed:
        raise ValueError(f"{question} needs a tool, or a plane")
    return tools, listed


def model_of(shape: Any, name: str) -> Model:
    """Any shape as a model."""
    return shape if isinstance(shape, Model) else Model(_core_of(shape, name))
