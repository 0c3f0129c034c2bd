# SPDX-License-Identifier: LGPL-2.1-or-later
"""A model that stays in memory, and the questions it answers."""

import os
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

from . import _checks, _core, _shapes
from ._clashes import Clash
from ._intersections import Intersection, SelfIntersection
from ._meshes import Mesh
from ._operations import Operations, core_of
from ._queries import Check, Continuity, Distance, FootPoints, Mass, Meeting, RayHits
from ._sections import Section, Sections

FileName = Union[str, "os.PathLike[str]"]


class Model(Operations):
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
        return (_unpacked, (_shapes.packed(self._core), self.name))

    def face(self, number: Union[int, str]) -> "Model":
        """One face, by its number from 1 on, which it keeps; or "Face3"."""
        return self.part([number])

    def part(self, numbers: Any) -> "Model":
        """Some faces, by their numbers or as "Face3", or a part, "Shaft", and what else inputs of the
        command line may name, as "solid:2" or "Shaft/Face3"; they share the model. Parts and
        solids have an inside, faces have none."""
        if isinstance(numbers, str):
            called = f"{self.name}#{numbers}"
            return Model(_shapes.part_named(self._core, numbers, "numbers", called))
        listed = _checks.face_numbers(numbers, "numbers")
        name = f"{self.name}#{','.join(map(str, listed))}"
        return Model(self._core.part(listed, [], name))

    def sew(self, **options: Any) -> "Model":
        """Sews loose faces into the solids that they close, in this model itself, and returns it.
        Other questions but `intersect`, `subdivide` and `info` do so first; see `repairs`."""
        _core.sew(self._core, _checks.control(options))
        return self

    def info(self, edges: bool = False, faces: bool = False, **options: Any) -> Dict[str, Any]:
        """What the model is made of, as `blossom info` reports it; with all its edges, and of faces
        areas and colours, too."""
        listed, measured = _checks.flag(edges, "edges"), _checks.flag(faces, "faces")
        return _core.info(self._core, listed, measured, _checks.control(options)).report(True)

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

    def _searched(self, options: Dict[str, Any]) -> Tuple[_core.Model, _core.Control]:
        """What a question looks at, and how."""
        control = _checks.control(options)
        return _shapes.searched(self._core, control), control

    def _searched_both(
        self, other: Any, options: Dict[str, Any]
    ) -> Tuple[_core.Model, _core.Model, _core.Control]:
        b = core_of(other, "other")
        control = _checks.control(options)
        return _shapes.searched(self._core, control), _shapes.searched(b, control), control

    def check(self, **options: Any) -> Check:
        """What is wrong with it, with gaps measured beside stated tolerances."""
        return Check(_core.check(self._core, _checks.control(options)))

    def intersect(self, other: Any, **options: Any) -> Intersection:
        """All intersections with another shape."""
        return Intersection(_core.intersect(*self._searched_both(other, options)))

    def self_intersect(self, faces: bool = False, **options: Any) -> SelfIntersection:
        """Where each face meets itself; with `faces`, also different faces each other."""
        model, control = self._searched(options)
        return SelfIntersection(
            _core.self_intersect(model, _checks.flag(faces, "faces"), control)
        )

    def section(self, point: Any, normal: Any, **options: Any) -> Section:
        """The section with the plane through a point; the normal may have any length."""
        at, along = _checks.vector(point, "point"), _checks.vector(normal, "normal")
        model, control = self._searched(options)
        return Section(_core.section(model, at, along, control))

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
        model, control = self._searched(options)
        return Sections(_core.sections(model, listed, control))

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
        b = None if other is None else core_of(other, "other")
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
        start, along = _checks.vector(origin, "origin"), _checks.vector(direction, "direction")
        first, line = _checks.flag(first, "first"), _checks.flag(line, "line")
        model, control = self._searched(options)
        return RayHits(_core.ray(model, start, along, first, line, control))

    def distance(self, other: Any, **options: Any) -> Distance:
        """How far another shape is, 0 if one is inside of the other, and how they lie."""
        return Distance(_core.distance(*self._searched_both(other, options)))

    def does_intersect(self, other: Any, **options: Any) -> Meeting:
        """Whether there is a common point, as early as that is known."""
        return Meeting(_core.does_intersect(*self._searched_both(other, options)))

    def foot_points(self, at: Any, all: bool = True, **options: Any) -> FootPoints:
        """The nearest point to a point; with `all` every point where the distance is
        stationary."""
        point, every = _checks.vector(at, "at"), _checks.flag(all, "all")
        model, control = self._searched(options)
        return FootPoints(_core.nearest(model, point, every, control))

    def mass(self, **options: Any) -> Mass:
        """Volume, area, centre of gravity and inertia, of closed solids and of other faces."""
        return Mass(_core.mass(*self._searched(options)))

    @property
    def volume(self) -> float:
        """Of all closed solids, cubic millimetres; 0 if there is none. See `mass`."""
        return self.mass().volume

    @property
    def area(self) -> float:
        """Of all faces, square millimetres. See `mass`."""
        return self.mass().area


def _unpacked(packed: _shapes.Packed, name: str) -> Model:
    return Model(_shapes.unpacked(packed, name))


def model_of(shape: Any, name: str) -> Model:
    """Any shape as a model."""
    return shape if isinstance(shape, Model) else Model(core_of(shape, name))
