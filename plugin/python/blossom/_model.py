# SPDX-License-Identifier: LGPL-2.1-or-later
"""A model that stays in memory, and the questions it answers."""

import os
from typing import Any, Dict, Iterator, List, Optional, Union

from . import _checks, _core, _results, _shapes
from ._bodies import Fillet, Solid, Trim, Watertight
from ._intersections import Intersection, SelfIntersection
from ._queries import Check, Distance, FootPoints, Meeting, RayHits, Section

FileName = Union[str, "os.PathLike[str]"]


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

    def face(self, number: int) -> "Model":
        """One face, by its number from 1 on, which it keeps."""
        return self.part([number])

    def part(self, numbers: Any) -> "Model":
        """Some faces, by their numbers; they share the model."""
        listed = _checks.face_numbers(numbers, "numbers")
        name = f"{self.name}#{','.join(map(str, listed))}"
        return Model(self._core.part(listed, name))

    def info(self, **options: Any) -> Dict[str, Any]:
        """What the model is made of, as `blossom info` reports it."""
        return _core.info(self._core, _checks.control(options)).report()

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
        cutters = _tools(tools)
        listed = _checks.planes(planes, "planes")
        if not cutters and not listed:
            raise ValueError("trim needs a tool, or a plane")
        return Trim(
            _core.trim(self._core, cutters, listed, str(keep), _checks.control(options))
        )

    def solid(self, operation: str, *tools: Any, planes: Any = (), **options: Any) -> Solid:
        """The closed solid combined with others.

        operation   "cut", "common", "fuse", or "split": cut and common side by side
        planes      pairs (point, normal); what is above cuts like a tool
        """
        wanted = _checks.word(operation, "operation", ("cut", "common", "fuse", "split"))
        cutters = _tools(tools)
        listed = _checks.planes(planes, "planes")
        if not cutters and not listed:
            raise ValueError("solid needs a tool, or a plane")
        return Solid(
            _core.solid(wanted, self._core, cutters, listed, _checks.control(options))
        )

    def fillet(
        self,
        edges: Any = (),
        *,
        radius: float,
        between: Any = None,
        partial: bool = False,
        **options: Any,
    ) -> Fillet:
        """Edges of solids rounded by a ball that rolls along them.

        edges     numbers, as in "Edge1", or "all", "convex" or "concave"
        between   two face numbers: the edges that they have in common
        partial   round the edges that can be, instead of all or none; see `refused`
        """
        numbers, kind = _checks.edges(edges, "edges")
        pair = None if between is None else _checks.face_pair(between, "between")
        if not numbers and not kind and pair is None:
            raise ValueError("fillet needs edges, or two faces that they are between")
        return Fillet(
            _core.fillet(
                self._core,
                numbers,
                kind,
                pair,
                _checks.positive(radius, "radius"),
                _checks.flag(partial, "partial"),
                _checks.control(options),
            )
        )

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


def _tools(shapes: Any) -> List[_core.Model]:
    return [_core_of(shape, f"tool {i}") for i, shape in enumerate(shapes, start=1)]


def model_of(shape: Any, name: str) -> Model:
    """Any shape as a model."""
    return shape if isinstance(shape, Model) else Model(_core_of(shape, name))
