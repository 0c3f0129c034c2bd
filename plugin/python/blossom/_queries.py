# SPDX-License-Identifier: LGPL-2.1-or-later
"""Answers to questions about rays, points and distances, and about models as they are."""

from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from . import _checks, _pictures
from ._results import Array, Record, Report, Result, counted


@dataclass(eq=False, repr=False)
class Hit(Record):
    """Where a ray meets a face. `first` and `last` differ where it runs in the face."""

    distance: float
    first: float
    last: float
    point: Array
    face: int
    uv: Array
    normal: Array
    on: Dict[str, Any]
    grazing: bool
    status: str


def _hit(told: Report) -> Hit:
    arrays = ("point", "uv", "normal")
    return Hit(**{k: np.array(v, float) if k in arrays else v for k, v in told.items()})


class RayHits(Result):
    """What a ray hits, in order; a list of hits."""

    @property
    def hits(self) -> List[Hit]:
        return self._once("hits", lambda: [_hit(told) for told in self._told()["hits"]])

    def _items(self) -> List[Any]:
        return self.hits

    def _summary(self) -> str:
        return f"{self.status}, {counted(len(self._told()['hits']), 'hit')}"


class Measured(Result):
    """An answer that is a distance."""

    @property
    def distance(self) -> float:
        """0 where there are points in common."""
        return float(self._told()["distance"][1])

    @property
    def bounds(self) -> Tuple[float, float]:
        """The distance is proven to lie between these."""
        low, high = self._told()["distance"]
        return (low, high)

    def __float__(self) -> float:
        return self.distance


class Distance(Measured):
    """How far two models are apart, and how they lie to each other; a list of pairs of bodies that
    are not disjoint."""

    @property
    def relation(self) -> str:
        """ "disjoint", "touching", "crossing", "a inside b", "b inside a", "equal", "unknown"."""
        return str(self._told()["relation"])

    @property
    def nearest_a(self) -> Array:
        """The point of a's boundary that is nearest to b's."""
        return np.array(self._told()["nearest_a"]["point"], float)

    @property
    def nearest_b(self) -> Array:
        return np.array(self._told()["nearest_b"]["point"], float)

    def _items(self) -> List[Any]:
        return list(self._told()["pairs"])

    def _summary(self) -> str:
        return f"{self.status}, {self.relation}, distance {self.distance:g}"


class Meeting(Distance):
    """Whether two models have a point in common."""

    @property
    def answer(self) -> str:
        """ "yes", "touching", "no" or "unknown"."""
        return str(self._told()["answer"])

    def _summary(self) -> str:
        return f"{self.status}, {self.answer}, {self.relation}"


class FootPoints(Measured):
    """What of a model is nearest to a point; a list of feet, where the distance is stationary."""

    @property
    def point(self) -> Array:
        """The nearest point."""
        return np.array(self._told()["nearest"]["point"], float)

    @property
    def on(self) -> Dict[str, Any]:
        """What the nearest point is on: {"kind": "face", "number": 3}."""
        return dict(self._told()["nearest"]["on"])

    @property
    def feet(self) -> List[Dict[str, Any]]:
        return list(self._told().get("feet", []))

    @property
    def inside(self) -> Optional[bool]:
        """Whether the point is inside of a solid; None if that is not known, or it is on a
        boundary."""
        places = [solid["place"] for solid in self._told()["solids"]]
        if "inside" in places:
            return True
        return None if "unknown" in places or "on the boundary" in places else False

    def _items(self) -> List[Any]:
        return self.feet

    def _summary(self) -> str:
        return f"{self.status}, distance {self.distance:g}, {counted(len(self.feet), 'foot point')}"


@dataclass(eq=False, repr=False)
class PartMass(Record):
    """A closed solid, or the faces of a part that bound none (`solid` is None). The inertia is that
    about the part's centre; a surface has none, and the volume 0."""

    name: str
    part: str
    solid: Optional[int]
    faces: int
    area: float
    volume: float
    centre: Array
    inertia: Optional[Array]


def _part_mass(told: Report) -> PartMass:
    inertia = told.get("inertia")
    return PartMass(
        name=told["name"],
        part=told["part"],
        solid=told["solid"],
        faces=told["faces"],
        area=told["area"],
        volume=told.get("volume", 0.0),
        centre=np.array(told["centre"], float),
        inertia=None if inertia is None else np.array(inertia, float),
    )


class Mass(Result):
    """Volume, area, centre of gravity and inertia, for density 1; a list of parts. Millimetres."""

    @property
    def parts(self) -> List[PartMass]:
        return self._once("parts", lambda: [_part_mass(told) for told in self._told()["parts"]])

    @property
    def area(self) -> float:
        """Of all faces."""
        return float(sum(part.area for part in self.parts))

    @property
    def volume(self) -> float:
        """Of all closed solids; 0 if there is none."""
        total = self._told()["total"]
        return 0.0 if total is None else float(total["volume"])

    @property
    def centre(self) -> Optional[Array]:
        """Of all closed solids; None if there is none."""
        total = self._told()["total"]
        return None if total is None else np.array(total["centre"], float)

    @property
    def inertia(self) -> Optional[Array]:
        """(3, 3), of all closed solids about their centre; None if there is none."""
        total = self._told()["total"]
        return None if total is None else np.array(total["inertia"], float)

    def _items(self) -> List[Any]:
        return self.parts

    def _summary(self) -> str:
        return f"{self.status}, volume {self.volume:g}, area {self.area:g}"


class Untimed(Result):
    """An answer that tells no time."""

    @property
    def seconds(self) -> float:
        raise AttributeError(f"{type(self).__name__} tells no time")


class Continuity(Untimed):
    """How smoothly faces meet; a list of edges, each with `number`, `faces`, `kind`, `class`
    ("apart", "G0", "G1", "G2"; None of an open one), and figures with their bounds."""

    @property
    def edges(self) -> List[Dict[str, Any]]:
        return list(self._told()["edges"])

    @property
    def counts(self) -> Dict[str, int]:
        """Of each class, `proven` ones, and those that could not be measured."""
        return dict(self._told()["summary"])

    @property
    def failing(self) -> List[int]:
        """Edges that are less smooth than required, or not known to be."""
        return list(self._told()["less_than_required"])

    @property
    def status(self) -> str:
        return "complete" if self.counts["unmeasured"] == 0 else "stopped"

    def _items(self) -> List[Any]:
        return self.edges

    def _summary(self) -> str:
        counts = self.counts
        classes = [f"{counts[word]} {word}" for word in ("apart", "G0", "G1", "G2") if counts[word]]
        return f"{counted(len(self), 'edge')}: {', '.join(classes) or 'none between faces'}"


    def to_html(
        self,
        path: _pictures.FileName,
        *,
        view: _pictures.View = None,
        zebra: bool = False,
        **options: Any,
    ) -> None:
        """As of all answers; see `to_png`."""
        stripes = _checks.flag(zebra, "zebra")
        self._show(path, (".html", ".htm"), view, _pictures.SIZE, stripes, options)

    def to_png(
        self,
        path: _pictures.FileName,
        *,
        view: _pictures.View = None,
        size: Tuple[int, int] = _pictures.SIZE,
        zebra: bool = False,
        **options: Any,
    ) -> None:
        """As of all answers.

        zebra   with stripes on the faces, as they would reflect rows of lamps; they break off, bend
                or go on where faces are G0, G1 or G2
        """
        self._show(path, (".png",), view, size, _checks.flag(zebra, "zebra"), options)


class Check(Untimed):
    """What is wrong with a model; a list of problems."""

    @property
    def sound(self) -> bool:
        return bool(self._told()["sound"])

    @property
    def problems(self) -> List[str]:
        """Of the whole, of faces and of edges, in words."""
        told = self._told()
        found = [str(problem) for problem in told["problems"]]
        for kind in ("face", "edge"):
            for each in told[f"{kind}s"]:
                found += [f"{kind} {each['number']}: {text}" for text in each["problems"]]
        return found

    @property
    def status(self) -> str:
        """ "sound" or "not sound"."""
        return str(self._told()["verdict"])

    def _items(self) -> List[Any]:
        return self.problems

    def _summary(self) -> str:
        return f"{self.status}, {counted(int(self._told()['problem_count']), 'problem')}"
