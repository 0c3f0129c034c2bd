# SPDX-License-Identifier: LGPL-2.1-or-later
"""Looks at what users pass to fillets, chamfers and fills, as `_checks` does at all else."""

import json
import math
import numbers
from typing import Any, List, Mapping, Optional, Tuple

from . import _checks


def smoothness(value: Any, name: str, edges: int) -> List[str]:
    """One word for all edges, or one for each."""
    wanted = "one of G0, G1, G2, or a list of them is"
    words = _checks.members(_checks.in_list(value), name, wanted)
    made = [_checks.word(each, name, _checks.SMOOTHNESS) for each in words]
    if len(made) != 1 and len(made) != edges:
        raise ValueError(f"{name}: one word, or one for each edge is wanted, got {len(made)}")
    return made


def radii(value: Any, name: str) -> Tuple[float, Optional[float]]:
    """A positive number, or a pair of them: at the start and the end."""
    if isinstance(value, numbers.Real) or isinstance(value, (str, bytes)):
        return _checks.positive(value, name), None
    first, last = (_checks.positive(each, name) for each in _checks.number_list(value, name, 2))
    return first, last


def section(value: Any, name: str) -> str:
    """ "circle", "conic:0.4", "g2" or "g3"."""
    told = _checks.text(value, name)
    head, _, tail = told.partition(":")
    try:
        rho = float(tail)
    except ValueError:
        rho = math.nan
    if told not in ("circle", "g2", "g3") and not (head == "conic" and 0 < rho < 1):
        raise ValueError(
            f"{name}: 'circle', 'conic:RHO' with RHO between 0 and 1, 'g2' or 'g3' is wanted, "
            f"got '{told}'"
        )
    return told


def chamfer_size(
    distance: Any, turn: Any
) -> Tuple[float, Optional[float], Optional[float]]:
    """The first distance, and the second one or an angle, if there is one."""
    first, second = radii(distance, "distance")
    if turn is None:
        return first, second, None
    if second is not None:
        raise ValueError("angle: a second distance, or an angle is wanted, not both")
    return first, None, _checks.angle(turn, "angle")


EdgeWish = Tuple[List[int], str, Optional[Tuple[int, int]]]


def edge_wish(question: str, chosen: Any, between: Any) -> EdgeWish:
    """Numbers of edges, a word for them, and two faces that they are between; one at least."""
    listed, word_of = _checks.edges(chosen, "edges")
    pair = None if between is None else _checks.face_pair(between, "between")
    if not listed and not word_of and pair is None:
        raise ValueError(f"{question} needs edges, or two faces that they are between")
    return listed, word_of, pair


OwnRadii = List[Tuple[int, float, str]]


def fillet_size(
    radius: Any, law: Any, full_round: bool, wish: EdgeWish
) -> Tuple[float, str, OwnRadii]:
    """The radius, or a law as JSON, and what edges have in place of these: their numbers with one
    or the other. A full round has its own."""
    if full_round:
        if radius is not None or law is not None:
            raise TypeError("fillet: full_round goes without radius and law")
        return 1.0, "", []
    if (radius is None) == (law is None):
        raise TypeError("fillet: a radius or a law is wanted, and just one of them")
    if law is not None:
        return (*_radius_or_law(law, "law"), [])
    if not isinstance(radius, Mapping):
        return (*_radius_or_law(radius, "radius"), [])
    own = []
    for edge, each in radius.items():
        if edge is not None:
            (number,) = _checks.numbers_of([edge], "radius", "edge")
            own.append((number, *_radius_or_law(each, f"radius: edge {number}")))
    listed, word, between = wish
    if None in radius:
        return (*_radius_or_law(radius[None], "radius: None"), own)
    without = sorted({*listed} - {edge for edge, _, _ in own})
    if word or between or without:
        which = f"edge {without[0]} has" if without else "some edges have"
        raise ValueError(f"radius: {which} none; that of all others is wanted, as {{None: 2}}")
    return 1.0, "", own


def _radius_or_law(value: Any, name: str) -> Tuple[float, str]:
    """A radius, or a law as JSON; a pair of radii is a law, too."""
    if isinstance(value, Mapping):
        try:
            return 1.0, json.dumps(dict(value))
        except (TypeError, ValueError) as error:
            raise ValueError(f"{name}: {error}") from None
    if name == "law":
        raise TypeError(f"law: a mapping is wanted, got {_checks.kind(value)}")
    first, last = radii(value, name)
    return first, "" if last is None else json.dumps({"law": "linear", "radii": [first, last]})
