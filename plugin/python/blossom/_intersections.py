# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersections and their parts."""

from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple

from ._results import Array, FoundCurve, Record, Result, counted


@dataclass(eq=False, repr=False)
class Curve(FoundCurve):
    """A curve, from border or node to border or node, or closed.

    uv_a, uv_b       parameters of `points`, (n, 2) each
    deviation        bounds on distances: "a", "b" from the faces, "between" both images
    face_a, face_b   numbers from 1 on
    """

    uv_a: Array
    uv_b: Array
    least_angle: float
    deviation: Dict[str, float]
    face_a: int
    face_b: int


@dataclass(eq=False, repr=False)
class Chain(Record):
    """Curves that go on across the seams of a closed surface: places in `curves`, and whether each
    is walked from its first point to its last one."""

    curves: List[Tuple[int, bool]]
    closed: bool
    length: float
    face_a: int
    face_b: int


@dataclass(eq=False, repr=False)
class Contact(Record):
    """A point that both faces have. `on_a`, `on_b`: what it is on, as ("edge", 3); None of a
    node."""

    point: Array
    uv_a: Array
    uv_b: Array
    on_a: Optional[Tuple[str, int]]
    on_b: Optional[Tuple[str, int]]
    face_a: int
    face_b: int


@dataclass(eq=False, repr=False)
class Overlap(Record):
    """A common area. The boundary repeats its first point and has the area to its left, seen from
    the tip of a's normal."""

    boundary: Array
    uv_a: Array
    uv_b: Array
    face_a: int
    face_b: int


@dataclass(eq=False, repr=False)
class Place(Record):
    """A box in which the faces stay within tolerance, or which stayed open."""

    kind: str
    box: Tuple[Array, Array]
    gap: Tuple[float, float]
    face_a: int
    face_b: int


@dataclass(eq=False, repr=False)
class EdgePoint(Record):
    """A point that an edge, which is a shape by itself, has in common with the other shape.
    `on_a`, `on_b`: the edge and what it meets, as ("face", 3). `parameter`: of the edge."""

    point: Array
    on_a: Tuple[str, int]
    on_b: Tuple[str, int]
    parameter: float


@dataclass(eq=False, repr=False)
class EdgeStretch(Record):
    """A stretch of such an edge that lies on the other shape."""

    start: Array
    end: Array
    length: float
    on_a: Tuple[str, int]
    on_b: Tuple[str, int]
    parameters: Tuple[float, float]


class Intersection(Result):
    """All intersections of two models; a list of curves."""

    def _parts(self, name: str, record: Any) -> List[Any]:
        return self._once(name, lambda: [record.of_members(each) for each in self._made()[name]])

    @property
    def status(self) -> str:
        return str(self._made()["status"])

    @property
    def seconds(self) -> float:
        return float(self._made()["seconds"])

    @property
    def curves(self) -> List[Curve]:
        """Those of all pairs of faces; `to_part()` has each stretch once."""
        return self._parts("curves", Curve)

    @property
    def chains(self) -> List[Chain]:
        """Curves that are one across seams; the "curves" of the report."""
        return self._parts("chains", Chain)

    @property
    def points(self) -> List[Contact]:
        """Isolated contacts."""
        return self._parts("points", Contact)

    @property
    def nodes(self) -> List[Contact]:
        """Where branches cross."""
        return self._parts("nodes", Contact)

    @property
    def overlaps(self) -> List[Overlap]:
        return self._parts("overlaps", Overlap)

    @property
    def edge_points(self) -> List[EdgePoint]:
        """Points in which edges without faces meet the other shape."""
        return self._parts("edge_points", EdgePoint)

    @property
    def edge_stretches(self) -> List[EdgeStretch]:
        """What of such edges lies on the other shape."""
        return self._parts("edge_stretches", EdgeStretch)

    @property
    def places(self) -> List[Place]:
        """What is within tolerance, or stayed open."""
        return self._parts("places", Place)

    @property
    def certificate(self) -> Dict[str, Any]:
        return dict(self._made()["certificate"])

    @property
    def parts_a(self) -> Dict[str, List[int]]:
        """The parts of a that are met, with the numbers of their faces."""
        return dict(self._told()["parts_a"])

    @property
    def parts_b(self) -> Dict[str, List[int]]:
        return dict(self._told()["parts_b"])

    @property
    def wires(self) -> List[List[Array]]:
        """For each chain the points of its curves, each in the direction of the chain."""
        return [
            [self.curves[i].points if forward else self.curves[i].points[::-1]
             for i, forward in chain.curves]
            for chain in self.chains
        ]  # fmt: skip

    def _items(self) -> List[Any]:
        return self.curves

    def _summary(self) -> str:
        return (
            f"{self.status}, {counted(len(self.chains), 'curve')}, "
            f"{counted(len(self.points) + len(self.edge_points), 'point')}, "
            f"{counted(len(self.places), 'place')}"
        )


class SelfIntersection(Intersection):
    """Where faces of one model meet themselves or each other."""

    @property
    def verdict(self) -> str:
        """ "none found", "found" or "undecided"."""
        return str(self._told()["verdict"])

    @property
    def parts_a(self) -> Dict[str, List[int]]:
        return {}

    @property
    def parts_b(self) -> Dict[str, List[int]]:
        return {}

    def _summary(self) -> str:
        return f"{self.verdict}, {super()._summary()}"
