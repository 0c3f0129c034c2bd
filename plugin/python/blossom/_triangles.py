# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of triangles as they are, from files, arrays and other programs."""

import math
import os
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from . import _checks, _core, _pictures, _shapes
from ._forms import NetResult
from ._results import Array, Indices, Result, counted

Colour = Tuple[int, int, int]

CREASE = math.radians(40)  # kUsualCrease in plugin/pictures/results/meshes.h


class MeshCheck(Result):
    """What is wrong with triangles; true if nothing is. A list of pairs of triangles that cross,
    the first 1000."""

    @property
    def sound(self) -> bool:
        """Closed, turned outwards, without crossings and triangles of no area."""
        return bool(self._told()["verdict"] == "sound")

    @property
    def status(self) -> str:
        """All is decided exactly."""
        return "complete"

    @property
    def closed(self) -> bool:
        return bool(self._told()["closed"])

    @property
    def volume(self) -> Optional[float]:
        """None unless it is closed; negative if it is turned inside out."""
        volume: Optional[float] = self._told()["volume"]
        return volume

    @property
    def area(self) -> float:
        return float(self._told()["area"])

    @property
    def open_sides(self) -> int:
        """Sides of one triangle."""
        return int(self._told()["open_sides"])

    @property
    def non_manifold_sides(self) -> int:
        """Sides of more than two triangles."""
        return int(self._told()["non_manifold_sides"])

    @property
    def turned_sides(self) -> int:
        """Sides whose triangles are turned against each other."""
        return int(self._told()["turned_sides"])

    @property
    def degenerate(self) -> int:
        """Triangles of no area."""
        return int(self._told()["degenerate"])

    @property
    def crossings(self) -> int:
        """Pairs of triangles that meet beyond what they share."""
        return int(self._told()["crossings"])

    def __bool__(self) -> bool:
        return self.sound

    def _items(self) -> List[Any]:
        return [tuple(pair) for pair in self._told()["crossing_triangles"]]

    def _summary(self) -> str:
        told = self._told()
        closed = "closed" if self.closed else "not closed"
        return f"{told['verdict']}, {counted(told['triangles'], 'triangle')}, {closed}"


class MeshIntersection(Result):
    """Where triangles meet triangles; a list of polylines, (n, 3), of which closed ones have their
    first point again at the end."""

    @property
    def curves(self) -> List[Array]:
        return list(self._made()["curves"][0])

    @property
    def closed(self) -> List[bool]:
        """Of each polyline."""
        return [bool(curve["closed"]) for curve in self._told()["curves"]]

    @property
    def points(self) -> Array:
        """Where they meet in a point alone, (n, 3)."""
        points: Array = self._made()["points"][0]
        return points

    @property
    def length(self) -> float:
        return float(sum(curve["length"] for curve in self._told()["curves"]))

    @property
    def within(self) -> float:
        """How far the triangles of a model may be from it; 0 of two meshes."""
        return float(self._told()["within"])

    def _items(self) -> List[Any]:
        return self.curves

    def _summary(self) -> str:
        return f"{self.status}, {counted(len(self.curves), 'polyline')}"


class MeshSections(Result):
    """The sections of a mesh with planes; for each plane the list of its polylines, (n, 3)."""

    @property
    def planes(self) -> List[Dict[str, Any]]:
        """The words of the report, plane by plane."""
        return list(self._told()["planes"])

    @property
    def points(self) -> List[Array]:
        """Of each plane, where the mesh only touches it."""
        return list(self._made()["points"])

    def _items(self) -> List[Any]:
        return [list(curves) for curves in self._made()["curves"]]

    def _summary(self) -> str:
        return f"{self.status}, {counted(len(self._told()['planes']), 'plane')}"


class MeshDistance(Result):
    """How far a mesh and another one, or a model, are from each other at worst; a list of the two
    ways, each a dict of `lower`, `upper` and `at`."""

    @property
    def bounds(self) -> Tuple[float, float]:
        """The largest distance of points of one from the other, both ways, is between these."""
        told = self._told()
        return (float(told["lower"]), float(told["upper"]))

    @property
    def is_within(self) -> Optional[bool]:
        """Whether it is at most `within`; None: not asked, or not decided."""
        answer: Optional[bool] = self._told()["is_within"]
        return answer

    def _items(self) -> List[Any]:
        return [self._told()["a_to_b"], self._told()["b_to_a"]]

    def _summary(self) -> str:
        low, high = self.bounds
        return f"{self.status}, between {low:.6g} and {high:.6g}"


class MeshPatches(NetResult):
    """Curved patches over triangles, of degree 4: a list of nets, three for each triangle."""

    @property
    def smooth_sides(self) -> int:
        """Sides between two triangles over which patches have one tangent plane."""
        return int(self._told()["smooth_sides"])

    @property
    def sharp_sides(self) -> int:
        """Sides between two others: creases, and sides at the end of one."""
        return int(self._told()["sharp_sides"])

    @property
    def largest_angle(self) -> float:
        """Between normals of both patches over smooth sides, where they were measured, radians."""
        return float(self._told()["largest_angle"])

    def _summary(self) -> str:
        return f"{len(self)} patches of {counted(self._told()['triangles'], 'triangle')}"


class Triangles(_pictures.Shown):
    """A mesh of triangles; made by `blossom.from_mesh`."""

    def __init__(self, core: _core.Triangles, report: Optional[Dict[str, Any]] = None) -> None:
        if not isinstance(core, _core.Triangles):
            raise TypeError("meshes are made by blossom.from_mesh")
        self._core = core
        self._report = report

    @property
    def name(self) -> str:
        """What reports call it: the file as it was given."""
        return self._core.name

    @property
    def vertices(self) -> Array:
        """(n, 3)"""
        return self._core.vertices

    @property
    def triangles(self) -> Indices:
        """Rows of `vertices`, counter-clockwise from outside, (m, 3)."""
        return self._core.triangles

    @property
    def groups(self) -> Dict[str, slice]:
        """By the name of a group where its triangles are; of equal names the last."""
        groups = self._core.groups
        ends = [first for _, first, *_ in groups[1:]] + [len(self.triangles)]
        return {name: slice(first, end) for (name, first, *_), end in zip(groups, ends)}

    @property
    def colours(self) -> Dict[str, Colour]:
        """Of groups that have one: red, green, blue, from 0 to 255."""
        return {
            name: (colour[0], colour[1], colour[2])
            for name, _, colour, _ in self._core.groups
            if colour is not None
        }

    @property
    def notes(self) -> List[str]:
        """What of its file is not in it, and what was changed."""
        return list(self._core.notes)

    @property
    def filling(self) -> Optional[Dict[str, Any]]:
        """The report of `fill`, of a mesh that it made."""
        return self._report

    def _seen(self, control: _core.Control) -> _core.Answer:
        return _core.info_mesh(self._core, control)

    def __len__(self) -> int:
        return len(self.triangles)

    def __repr__(self) -> str:
        counts = f"{counted(len(self.triangles), 'triangle')}, {counted(len(self.vertices), 'vertex')}"
        return f"<blossom.Triangles: {self.name}, {counts.replace('vertexs', 'vertices')}>"

    def __getstate__(self) -> Dict[str, Any]:
        core = self._core
        return {
            "name": core.name,
            "vertices": np.array(core.vertices),
            "triangles": np.array(core.triangles),
            "groups": core.groups,
            "report": self._report,
        }

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self._report = state["report"]
        self._core = _core.mesh_of_arrays(
            state["name"], state["vertices"], state["triangles"], state["groups"]
        )

    def part(self, groups: Any) -> "Triangles":
        """Some groups, by their numbers from 1 on or by names: "Shaft/Face3"; "Shaft" is all of a
        part, and "Face3" will do where one group alone ends so. Also as "Shaft,5-9"."""
        numbers, names = _chosen_groups(groups, "groups", len(self._core.groups))
        words = groups if isinstance(groups, str) else ",".join(map(str, [*numbers, *names]))
        return Triangles(_core.mesh_part(self._core, numbers, names, f"{self.name}#{words}"))

    def info(self, **options: Any) -> Dict[str, Any]:
        """What it is, as `blossom info` reports it: counts, parts, groups, volume, area, box."""
        return _core.info_mesh(self._core, _checks.control(options)).report(True)

    def convert(self, to: str = "bezier", *, crease: float = CREASE, **options: Any) -> MeshPatches:
        """Curved patches through its corners, which meet smoothly but where it has creases.

        to       "bezier": patches of four sides, one of which is a point; or "triangles"
        crease   sides at which neighbours turn by so much stay sharp; radians
        """
        form, sharp = _checks.word(to, "to", _checks.PATCHES), _checks.angle(crease, "crease")
        return MeshPatches(_core.curve_mesh(self._core, form, sharp, _checks.control(options)))

    def check(self, **options: Any) -> MeshCheck:
        """Whether it is closed, turned one way, crosses itself, and what it encloses: exactly."""
        return MeshCheck(_core.check_mesh(self._core, _checks.control(options)))

    def intersect(self, other: Any, **options: Any) -> MeshIntersection:
        """The polylines in which it meets another mesh, or a model, which is meshed for that."""
        b = _other(other)
        return MeshIntersection(_core.intersect_mesh(self._core, b, _checks.control(options)))

    def section(self, point: Any, normal: Any, **options: Any) -> MeshSections:
        """The polylines in which it meets a plane; a list of one list."""
        return self.sections([(point, normal)], **options)

    def sections(
        self,
        planes: Any = None,
        *,
        offsets: Any = None,
        point: Any = (0, 0, 0),
        normal: Any = (0, 0, 1),
        **options: Any,
    ) -> MeshSections:
        """Likewise with many planes; see `Model.sections`."""
        listed = _checks.planes_of_sections(planes, offsets, point, normal)
        return MeshSections(_core.section_mesh(self._core, listed, _checks.control(options)))

    def distance(self, other: Any, *, within: Any = None, **options: Any) -> MeshDistance:
        """How far it is from another mesh or a model at worst, both ways, between bounds.

        within      a distance: the answer's `is_within` tells whether it is at most that, and no
                    more is done than tells it
        tolerance   how near the bounds are to be, else a tenth of the distance; 1e-7
        """
        b = _other(other)
        asked = None if within is None else _checks.not_negative(within, "within")
        least = _checks.positive(options.get("tolerance", 1e-7), "tolerance")
        return MeshDistance(
            _core.mesh_distance(self._core, b, least, asked, _checks.control(options))
        )

    def fill(self, **options: Any) -> "Triangles":
        """The mesh with all its holes filled, by a group "fill"; `filling` tells of each."""
        made, answer = _core.fill_mesh(self._core, _checks.control(options))
        return Triangles(made, answer.report(True))

    def write(
        self, path: Union[str, "os.PathLike[str]"], text: bool = False, **options: Any
    ) -> None:
        """Writes it to a file: .stl, .ply, .obj, .off, .3mf, with groups and colours as far as the
        format has them.

        text   .stl and .ply are not binary
        """
        file = _checks.path(path, "path")
        if not _checks.is_of_triangles(file) or file.lower().endswith(".glb"):
            raise ValueError(f"path: {file} does not end with .stl, .ply, .obj, .off or .3mf")
        as_text = _checks.flag(text, "text")
        _core.write_triangles(self._core, file, as_text, _checks.control(options))


def _chosen_groups(value: Any, name: str, count: int) -> Tuple[List[int], List[str]]:
    """Numbers and names of a mesh's groups, which has so many: of "Shaft/Face3,5-9", or a list."""
    try:
        listed = value.split(",") if isinstance(value, str) else list(value)
    except TypeError:
        raise TypeError(f"{name}: groups are wanted, got {_checks.kind(value)}") from None
    made: List[int] = []
    names: List[str] = []
    for each in listed:
        found = _checks.FACE_RANGE.fullmatch(each) if isinstance(each, str) else None
        if found:
            made.extend(range(int(found[1]), min(int(found[2]), count + 1) + 1))
        elif isinstance(each, str) and not each.isdecimal():
            names.append(_checks.text(each, name))
        else:
            made.append(_checks.whole(int(each) if isinstance(each, str) else each, name, 1))
    if not made and not names:
        raise ValueError(f"{name}: there is no group in it")
    return made, names


def _rows(value: Any, name: str, kind: Any) -> Any:
    try:
        rows = np.asarray(value)
        made = rows.astype(kind)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: rows of three numbers are wanted") from None
    if made.ndim != 2 or made.shape[1] != 3:
        raise ValueError(f"{name}: rows of three numbers are wanted, got the shape {made.shape}")
    if kind is np.int32 and not np.array_equal(rows, made):
        raise ValueError(f"{name}: numbers of vertices are whole")
    return made


def _is_file(source: Any) -> bool:
    return isinstance(source, (str, os.PathLike))


def from_mesh(source: Any, triangles: Any = None, **options: Any) -> Triangles:
    """A mesh of triangles.

    source      a file .stl, .ply, .obj or .off, perhaps with groups of it: "a.obj#Shaft/Face3"; an
                array of vertices, (n, 3), with `triangles`; an answer of `mesh`; a mesh of FreeCAD,
                or its object, which counts where its containers show it; or an object with
                `vertices` and `faces`, as trimesh has them
    triangles   rows of vertices, counter-clockwise from outside, (m, 3)
    """
    control = _checks.control(options)
    if triangles is not None:
        rows, corners = _rows(source, "source", np.float64), _rows(triangles, "triangles", np.int32)
        return Triangles(_core.mesh_of_arrays("mesh", rows, corners, []))
    if isinstance(source, Triangles):
        return source
    if _is_file(source):
        file, words = _shapes.file_and_words(_checks.path(source, "source"))
        read = Triangles(_core.read_mesh(file, control))
        return read.part(words) if words else read
    try:
        made = _of_object(source)
    except ReferenceError as gone:  # FreeCAD's word for what belonged to a closed document
        raise ValueError("source: the object is deleted, or its document closed") from gone
    if made is None:
        raise TypeError(f"source: {_WANTED}; got {_checks.kind(source)}")
    return made


_WANTED = (
    "a mesh is wanted, as a file of triangles, vertices with triangles, an answer of mesh(), or a "
    "mesh of FreeCAD or trimesh"
)


def _of_object(source: Any) -> Optional[Triangles]:
    """Of other programs, and of answers; None if it has no triangles."""
    label = str(getattr(source, "Label", "mesh"))
    mesh = getattr(source, "Mesh", source)  # an object of FreeCAD has one
    if hasattr(mesh, "Topology"):
        points, facets = mesh.Topology
        vertices = np.array([(p.x, p.y, p.z) for p in points], float).reshape(-1, 3)
        corners = _rows(np.array(facets).reshape(-1, 3), "source", np.int32)
        shown = vertices if mesh is source else _where_shown(vertices, mesh, source)
        return Triangles(_core.mesh_of_arrays(label, shown, corners, []))
    if hasattr(source, "names") and hasattr(source, "vertices"):  # an answer of `mesh`
        corners = np.array(source.triangles)
        return Triangles(
            _core.mesh_of_arrays(label, np.array(source.vertices), corners, source._groups())
        )
    if hasattr(source, "vertices") and hasattr(source, "faces"):
        return from_mesh(source.vertices, source.faces)
    return None


def _where_shown(vertices: Array, mesh: Any, shown: Any) -> Array:
    """Vertices that a mesh of FreeCAD has, where an object with it, or a link to that, shows them,
    and its containers."""
    place, container = _own_place(shown), shown.getParentGeoFeatureGroup()
    if container is not None:
        place = container.getGlobalPlacement().multiply(place)
    matrix = np.array(place.multiply(mesh.Placement.inverse()).toMatrix().A, float).reshape(4, 4)
    placed: Array = vertices @ matrix[:3, :3].T + matrix[:3, 3]
    return placed


def _own_place(shown: Any) -> Any:
    """The placement of an object of FreeCAD; of a link its own, before that of what it links to if
    it wants that."""
    if shown.hasExtension("App::LinkBaseExtension") and shown.LinkTransform:
        return shown.Placement.multiply(_own_place(shown.LinkedObject))
    return shown.Placement


def _is_mesh(other: Any) -> bool:
    if isinstance(other, Triangles) or hasattr(other, "Topology"):
        return True
    if _is_file(other):
        return _checks.is_of_triangles(str(os.fspath(other)))
    return hasattr(getattr(other, "Mesh", None), "Topology")


def _other(other: Any) -> Union[_core.Triangles, _core.Model]:
    if _is_mesh(other):
        return from_mesh(other)._core
    from ._model import model_of  # which knows of meshes itself

    return model_of(other, "other")._core_model()
