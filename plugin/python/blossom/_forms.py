# SPDX-License-Identifier: LGPL-2.1-or-later
"""Answers that are control nets: pieces of curves and surfaces, and other forms of them."""

from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from ._results import Array, Indices, Record, Result, counted


@dataclass(eq=False, repr=False)
class Net(Record):
    """A net of control points, or of coefficients.

    kind      "curve", "patch" or "triangle"
    form      "bezier", "monomial" or "q-bezier"
    degree    one number; of a patch a pair
    rational  points have a weight as their fourth number, and are multiplied by it
    points    (n + 1, 3 or 4); of a patch (n + 1, m + 1, 3 or 4); of a triangle a list of rows, of
              which the last one is its corner c
    u, v      the source's parameters where it begins and ends; a curve has u alone
    corners   of a triangle in the source's parameters
    face, edge  numbers of what it comes from; None of the other
    error     how far it may be from that, model units
    """

    kind: str
    form: str
    degree: Union[int, Tuple[int, int]]
    rational: bool
    points: Union[Array, List[Array]]
    u: Optional[Tuple[float, float]]
    v: Optional[Tuple[float, float]]
    corners: Optional[Array]
    face: Optional[int]
    edge: Optional[int]
    error: float
    told: Dict[str, Any]

    @classmethod
    def of(cls, told: Dict[str, Any]) -> "Net":
        """From what files of nets have."""
        ragged = told["kind"] == "triangle"
        points = told["points"]
        u = told.get("u", told.get("interval"))
        v, degree, corners = told.get("v"), told["degree"], told.get("corners")
        return cls(
            kind=told["kind"],
            form=told["form"],
            degree=degree if isinstance(degree, int) else (degree[0], degree[1]),
            rational=told["rational"],
            points=(
                [np.array(row, float) for row in points] if ragged else np.array(points, float)
            ),
            u=None if u is None else (u[0], u[1]),
            v=None if v is None else (v[0], v[1]),
            corners=None if corners is None else np.array(corners, float),
            face=told.get("face"),
            edge=told.get("edge"),
            error=float(told.get("error", 0.0)),
            told=told,
        )


class NetResult(Result):
    """A list of nets. Its shape has untrimmed faces in the places of those that they come from."""

    @property
    def nets(self) -> List[Net]:
        return self._once("nets", lambda: [Net.of(each) for each in self._made()["nets"]])

    @property
    def status(self) -> str:
        return "complete"

    def _items(self) -> List[Any]:
        return self.nets


class Subdivision(NetResult):
    """Pieces by blossoms, row by row of each face's grid."""

    def _summary(self) -> str:
        return counted(len(self), "piece")


@dataclass(eq=False, repr=False)
class Spline(Record):
    """A B-spline in place of a face or an edge.

    kind            "surface" or "curve"
    degree          one number; of a surface a pair
    poles           (n + 1, 3); of a surface (n + 1, m + 1, 3), rows along u
    weights         likewise without the 3; None where all are 1
    knots           of a surface a pair of arrays, as multiplicities
    face, edge      number of what it is a part of; None of the other
    """

    kind: str
    degree: Union[int, Tuple[int, int]]
    poles: Array
    weights: Optional[Array]
    knots: Union[Array, Tuple[Array, Array]]
    multiplicities: Union[Indices, Tuple[Indices, Indices]]
    face: Optional[int]
    edge: Optional[int]

    @classmethod
    def of(cls, told: Dict[str, Any]) -> "Spline":
        """From a report's words."""
        surface, degree, weights = told["kind"] == "surface", told["degree"], told.get("weights")

        def listed(word: str, number: Any) -> Any:
            if not surface:
                return np.array(told[word], number)
            return tuple(np.array(told[f"{along}_{word}"], number) for along in "uv")

        return cls(
            kind=told["kind"],
            degree=(degree[0], degree[1]) if surface else int(degree),
            poles=np.array(told["poles"], float),
            weights=None if weights is None else np.array(weights, float),
            knots=listed("knots", float),
            multiplicities=listed("multiplicities", np.int32),
            face=told.get("face"),
            edge=told.get("edge"),
        )


class Whole(Result):
    """Faces or edges as one B-spline each; a list of these."""

    @property
    def splines(self) -> List[Spline]:
        return self._once(
            "splines", lambda: [Spline.of(each) for each in self._told()["splines"]]
        )

    @property
    def status(self) -> str:
        return "complete"

    def _items(self) -> List[Any]:
        return self.splines

    def _summary(self) -> str:
        return counted(int(self._told()["pieces"]), "B-spline")


class Conversion(NetResult):
    """Faces in another form."""

    @property
    def trims_left_out(self) -> int:
        """How many faces lost their trims."""
        return int(self._told()["trims_left_out"])

    @property
    def error(self) -> float:
        """How far nets are from what they stand for, at most."""
        return float(self._told()["error"])

    @property
    def trimmed(self) -> List[Dict[str, Any]]:
        """Faces whose trims were followed: how many pieces are exact, how many fitted, how well."""
        return list(self._told()["trimmed"])

    def _summary(self) -> str:
        told = self._told()
        return f"{told['to']}, {counted(len(self), 'net')} of {counted(told['faces'], 'face')}"
