# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections with one plane and with many."""

import os
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _checks, _core
from ._results import Array, FoundCurve, Record, Report, Result, counted


@dataclass(eq=False, repr=False)
class SectionCurve(FoundCurve):
    """A curve of a section.

    on          what it lies on: {"kind": "face", "number": 3}, or an edge in the plane
    nodes       places in the section's nodes; -1 of a loop
    deviation   a bound on its distance from the face and the plane
    """

    on: Dict[str, Any]
    nodes: List[int]
    deviation: float


@dataclass(eq=False, repr=False)
class Wire(Record):
    """Curves that follow each other: places in the section's curves, and whether each is walked
    forward. One that does not bound lies inside of what plane and solid have in common, or the
    solid only touches the plane there.

    area   what a closed one encloses, holes not taken off; None of an open one
    """

    curves: List[Tuple[int, bool]]
    closed: bool
    length: float
    points: Array
    bounding: bool
    area: Optional[float]


def _curves(told: Report, splines: Sequence[Dict[str, Any]]) -> List[SectionCurve]:
    """The curves of a section, in a report's words, with their splines."""
    curves = []
    for curve, spline in zip(told["curves"], splines):
        members: Dict[str, Any] = {**curve, **spline}
        members["points"] = np.array(curve["points"], float)
        curves.append(SectionCurve.of_members(members))
    return curves


def _wires(told: Report) -> List[Wire]:
    points = [np.array(curve["points"], float).reshape(-1, 3) for curve in told["curves"]]
    wires = []
    for wire in told["wires"]:
        uses = [(use["curve"], use["forward"]) for use in wire["curves"]]
        pieces = [points[i] if forward else points[i][::-1] for i, forward in uses]
        line = np.concatenate(pieces)
        wires.append(
            Wire(uses, wire["closed"], wire["length"], line, wire["bounding"], wire["area"])
        )
    return wires


def _points(told: Report) -> Array:
    found = [told["nodes"][node]["point"] for node in told["points"]]
    return np.array(found, float).reshape(-1, 3)


class Drawable(Result):
    """Sections, which are written to drawings, too."""

    def write(self, path: Union[str, "os.PathLike[str]"], **options: Any) -> None:
        """Writes the wires to a file: .step, .iges, .brep; or as a drawing: .dxf, .svg, part by
        part. Lines, circles and arcs are such, other curves are polylines within 1e-5 of the size
        of all sections. The file is there whole or not at all.
        """
        file = _checks.path(path, "path")
        if not _checks.is_of_drawings(file):
            super().write(file, **options)
            return
        control = _checks.control(options)
        if self._answer is None:
            raise _core.Error(f"path: {file}: drawings are made of answers that were not pickled")
        self._answer.draw(file, control)


    def to_dxf(self, path: Union[str, "os.PathLike[str]"], **options: Any) -> None:
        """Writes the wires to a drawing; see `write`."""
        self._draw(path, ".dxf", options)

    def to_svg(self, path: Union[str, "os.PathLike[str]"], **options: Any) -> None:
        """Writes the wires to a drawing, in which solids are hatched; see `write`."""
        self._draw(path, ".svg", options)

    def _draw(self, path: Any, ending: str, options: Dict[str, Any]) -> None:
        file = _checks.path(path, "path")
        if not file.lower().endswith(ending):
            raise ValueError(f"path: {file} does not end with {ending}")
        self.write(file, **options)


class Section(Drawable):
    """The section of a model with a plane; a list of wires."""

    @property
    def curves(self) -> List[SectionCurve]:
        return self._once("curves", lambda: _curves(self._told(), self._made()["splines"]))

    @property
    def wires(self) -> List[Wire]:
        return self._once("wires", lambda: _wires(self._told()))

    @property
    def points(self) -> Array:
        """Where the model only touches the plane, (n, 3)."""
        return _points(self._told())

    @property
    def faces_in_plane(self) -> List[int]:
        return list(self._told()["faces_in_plane"])

    def _items(self) -> List[Any]:
        return self.wires

    def _summary(self) -> str:
        told = self._told()
        return (
            f"{self.status}, {counted(len(told['wires']), 'wire')}, "
            f"{counted(len(told['curves']), 'curve')}, {counted(len(told['points']), 'point')}"
        )


@dataclass(eq=False, repr=False)
class PartSection(Record):
    """What a plane makes of one part of a model.

    part     its name
    solid    whether it is a closed solid
    area     what its bounding wires enclose, without holes; None if one of them is open
    points   where it only touches the plane, (n, 3)
    """

    part: str
    solid: bool
    status: str
    area: Optional[float]
    wires: List[Wire]
    curves: List[SectionCurve]
    points: Array
    faces_in_plane: List[int]


@dataclass(eq=False, repr=False)
class PlaneSection(Record):
    """What one of many planes makes of a model: the parts that it meets.

    normal   of the length 1
    offset   along the normal from the point that was given; None of planes that were listed
    """

    name: str
    point: Array
    normal: Array
    offset: Optional[float]
    parts: List[PartSection]

    @property
    def wires(self) -> List[Wire]:
        """Of all parts. Seen from the tip of the normal closed ones run counter-clockwise, those of
        holes clockwise."""
        return [wire for part in self.parts for wire in part.wires]

    @property
    def length(self) -> float:
        """Of all wires."""
        return sum(wire.length for wire in self.wires)

    @property
    def area(self) -> Optional[float]:
        """Of all parts; None if that of one is."""
        areas = [part.area for part in self.parts if part.area is not None]
        return sum(areas) if len(areas) == len(self.parts) else None


class Sections(Drawable):
    """The sections of a model with many planes, part by part; a list of planes. Its shape has a
    compound for each plane, in it one for each part."""

    @property
    def planes(self) -> List[PlaneSection]:
        return self._once("planes", self._all_planes)

    def _all_planes(self) -> List[PlaneSection]:
        splines = iter(self._made()["splines"])
        planes = []
        for plane in self._told()["planes"]:
            parts = []
            for part in plane["parts"]:
                own = [next(splines) for _ in part["curves"]]
                parts.append(
                    PartSection(
                        part=part["part"],
                        solid=part["solid"],
                        status=part["status"],
                        area=part["area"],
                        wires=_wires(part),
                        curves=_curves(part, own),
                        points=_points(part),
                        faces_in_plane=list(part["faces_in_plane"]),
                    )
                )
            planes.append(
                PlaneSection(
                    name=plane["name"],
                    point=np.array(plane["point"], float),
                    normal=np.array(plane["normal"], float),
                    offset=plane["offset"],
                    parts=parts,
                )
            )
        return planes

    def _has_found_nothing(self) -> bool:
        return self.status != "stopped"

    def _items(self) -> List[Any]:
        return self.planes

    def _summary(self) -> str:
        planes = self._told()["planes"]
        wires = sum(len(part["wires"]) for plane in planes for part in plane["parts"])
        return f"{self.status}, {counted(len(planes), 'plane')}, {counted(wires, 'wire')}"
