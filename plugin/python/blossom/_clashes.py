# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the parts of models lie to each other."""

from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._results import Array, Record, Report, Result, counted

Bounds = Tuple[float, float]


@dataclass(eq=False, repr=False)
class ClashPair(Record):
    """Two parts, by their names.

    relation   "penetrates", "contained", "equal", "touches", "clear" or "unknown"
    inner      of parts that are contained: which one is inside of the other
    distance   bounds, of parts without common points; the upper one is None where only the lower
               is known
    nearest    points at which the upper one is taken, (2, 3)
    volume     of what solids have in common
    depth      bounds on how far the boundary of either reaches into the other
    deepest    where the lower one is taken
    contacts   of parts that touch: `kind` ("face", "curve", "point"), `face_a`, `face_b`, `point`,
               `box`
    obstacles  why a volume or a relation is missing
    """

    a: str
    b: str
    relation: str
    status: str
    inner: Optional[str]
    distance: Optional[Tuple[float, Optional[float]]]
    nearest: Optional[Array]
    volume: Optional[float]
    depth: Optional[Bounds]
    deepest: Optional[Array]
    contacts: List[Dict[str, Any]]
    obstacles: List[str]


class Clash(Result):
    """Pairs of parts that were looked at; a list of them. What has points in common comes first, then what touches,
    what is not known, and what is clear. Its shape is the common bodies."""

    @property
    def parts(self) -> List[str]:
        """The names of all parts, those of the second model behind those of the first."""
        return [str(part["name"]) for part in self._told()["parts"]]

    @property
    def counts(self) -> Dict[str, int]:
        """All pairs by their relation, also those that are not listed."""
        return dict(self._told()["counts"])

    @property
    def clearance(self) -> Optional[float]:
        wanted = self._told()["clearance"]
        return None if wanted is None else float(wanted)

    @property
    def pairs(self) -> List[ClashPair]:
        parts = self._told()["parts"]
        return self._once("pairs", lambda: [_pair(each, parts) for each in self._told()["pairs"]])

    @property
    def findings(self) -> List[ClashPair]:
        """Parts that have an inside in common, or are nearer to each other than the clearance."""
        least = self.clearance
        return [pair for pair in self.pairs if _is_finding(pair, least)]

    def _has_found_nothing(self) -> bool:
        return self.status != "stopped"

    def _items(self) -> List[Any]:
        return self.pairs

    def _summary(self) -> str:
        told = [f"{count} {word}" for word, count in self.counts.items() if count]
        parts = counted(len(self._told()["parts"]), "part")
        return f"{self.status}, {parts}, {', '.join(told)}"


def _is_finding(pair: ClashPair, clearance: Optional[float]) -> bool:
    if pair.relation in ("penetrates", "contained", "equal"):
        return True
    if clearance is None or pair.distance is None or pair.distance[1] is None:
        return False
    return pair.distance[0] < clearance


def _pair(told: Report, parts: List[Report]) -> ClashPair:
    a, b, inner = (told["a"], told["b"], told.get("inner"))
    common = told.get("common")
    distance, nearest = told.get("distance"), told.get("nearest")
    return ClashPair(
        a=parts[a]["name"],
        b=parts[b]["name"],
        relation=told["relation"],
        status=told["status"],
        inner=None if inner is None else parts[{"a": a, "b": b}[inner]]["name"],
        distance=None if distance is None else (distance[0], distance[1]),
        nearest=None if nearest is None else np.array(nearest, float),
        volume=None if common is None else float(common["volume"]),
        depth=None if common is None else (common["depth"][0], common["depth"][1]),
        deepest=None if common is None else np.array(common["deepest"], float),
        contacts=list(told.get("contacts", [])),
        obstacles=list(told.get("obstacles", [])),
    )
