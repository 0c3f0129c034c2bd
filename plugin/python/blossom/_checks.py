# SPDX-License-Identifier: LGPL-2.1-or-later
"""Looks at what users pass, in one place: a wrong type is a TypeError, a wrong value a ValueError,
and both name the argument, what came and what is wanted."""

import math
import numbers
import os
import re
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from . import _core

Triple = Tuple[float, float, float]

FORMS = ("auto", "bezier", "monomial")
OPERATIONS = ("cut", "common", "fuse", "split")
SMOOTHNESS = ("G0", "G1", "G2")
LAYOUTS = ("auto", "star", "ring", "deep-ring")
TARGETS = ("bezier", "monomial", "triangles")
PATCHES = ("bezier", "triangles")
EDGE_WORDS = ("all", "convex", "concave")
SIDES = ("umax", "umin", "vmax", "vmin")
STRIP_ORDERS = ("G1", "G2", "G3")


def kind(value: object) -> str:
    """What messages call a value's type."""
    return type(value).__name__


def number(value: Any, name: str) -> float:
    """A finite number."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name}: a number is wanted, got {kind(value)}")
    made = float(value)
    if not math.isfinite(made):
        raise ValueError(f"{name}: {made} is not finite")
    return made


def positive(value: Any, name: str) -> float:
    """A finite number above 0."""
    made = number(value, name)
    if made <= 0:
        raise ValueError(f"{name}: {made} is not positive")
    return made


def not_negative(value: Any, name: str) -> float:
    """A finite number, 0 or more."""
    made = number(value, name)
    if made < 0:
        raise ValueError(f"{name}: {made} is negative")
    return made


def whole(value: Any, name: str, least: int) -> int:
    """A whole number that is not less than another one."""
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{name}: a whole number is wanted, got {kind(value)}")
    made = int(value)
    if made < least:
        raise ValueError(f"{name}: {made} is less than {least}")
    if made > 2**31 - 1:
        raise ValueError(f"{name}: {made} is too large")
    return made


def flag(value: Any, name: str) -> bool:
    """True or False."""
    if not isinstance(value, bool):
        raise TypeError(f"{name}: True or False is wanted, got {kind(value)}")
    return value


def word(value: Any, name: str, known: Sequence[str]) -> str:
    """One of some words."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: one of {', '.join(known)} is wanted, got {kind(value)}")
    if value not in known:
        raise ValueError(f"{name}: '{value}' is none of {', '.join(known)}")
    return value


def border(value: Any, name: str) -> str:
    """A border of a face: one of SIDES, the number of an edge, or None; as text, empty for None."""
    if value is None:
        return ""
    if isinstance(value, str) and _entity_number(value, "edge") is None:
        return word(value, name, SIDES)
    return str(entity(value, name, "edge"))


def text(value: Any, name: str) -> str:
    """A text that is not empty."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: a text is wanted, got {kind(value)}")
    if not value:
        raise ValueError(f"{name}: it is empty")
    return value


def path(value: Any, name: str) -> str:
    """A file's name."""
    if isinstance(value, (str, os.PathLike)):
        made = os.fspath(value)
        if isinstance(made, str):
            if "\0" in made:
                raise ValueError(f"{name}: a file's name has no null character")
            if not made:
                raise ValueError(f"{name}: the name of a file is empty")
            return made
    raise TypeError(f"{name}: a str or a Path is wanted, got {kind(value)}")


def members(value: Any, name: str, wanted: str) -> List[Any]:
    """What is in a list, or in what else has members."""
    try:
        return list(value)
    except TypeError:
        raise TypeError(f"{name}: {wanted} wanted, got {kind(value)}") from None


def vector(value: Any, name: str) -> Triple:
    """Three finite numbers: a sequence, an array, or FreeCAD's Vector."""
    parts = members(value, name, "three numbers are")
    if isinstance(value, (str, bytes)):
        raise TypeError(f"{name}: three numbers are wanted, got {kind(value)}")
    if len(parts) != 3:
        raise ValueError(f"{name}: three numbers are wanted, got {len(parts)}")
    x, y, z = (number(part, name) for part in parts)
    return (x, y, z)


def _rows(value: Any, name: str, wanted: str) -> List[List[Any]]:
    try:
        return [list(row) for row in value]
    except TypeError:
        raise TypeError(f"{name}: {wanted} wanted, got {kind(value)}") from None


def planes(value: Any, name: str) -> List[Tuple[Triple, Triple]]:
    """Pairs of a point and a normal."""
    listed = _rows(value, name, "a list of pairs (point, normal) is")
    for pair in listed:
        if len(pair) != 2:
            raise ValueError(f"{name}: a plane is a pair (point, normal), got {len(pair)} members")
    return [(vector(p, f"{name}, point"), vector(n, f"{name}, normal")) for p, n in listed]


_ENTITY = re.compile(r"(face|edge):?([1-9]\d{0,8})", re.IGNORECASE)


def _entity_number(word: str, noun: str) -> Optional[int]:
    found = _ENTITY.fullmatch(word)
    return int(found[2]) if found and found[1].lower() == noun else None


def entity(value: Any, name: str, noun: str) -> int:
    """The number of a face or an edge, or a word for it: "Face3", "edge:12"."""
    if not isinstance(value, (str, numbers.Integral)):
        raise TypeError(f"{name}: a number, or '{noun.capitalize()}3', is wanted, got {kind(value)}")
    if not isinstance(value, str):
        return whole(value, name, 1)
    number = _entity_number(value, noun)
    if number is None:
        raise ValueError(f"{name}: '{value}' is no {noun}, such as 3 or '{noun.capitalize()}3'")
    return number


def numbers_of(value: Any, name: str, noun: str) -> List[int]:
    """Numbers of faces or edges, each once, in increasing order."""
    try:
        listed = [entity(each, name, noun) for each in in_list(value)]
    except TypeError as error:
        if str(error).startswith(f"{name}:"):
            raise
        raise TypeError(f"{name}: a list of {noun} numbers is wanted, got {kind(value)}") from None
    return sorted(set(listed))


def in_list(value: Any) -> Any:
    """A word as a list of itself; all else as it is."""
    return [value] if isinstance(value, str) else value


MESH_FILES = (".stl", ".ply", ".obj", ".off")

# "5-9"
FACE_RANGE = re.compile(r"([1-9]\d{0,8})-([1-9]\d{0,8})")


def chosen_faces(text: str, name: str, count: int) -> List[int]:
    """Of "3,5-9,Face12", what an input of the command line has after its '#', of so many faces."""
    made: List[int] = []
    for entry in text.split(","):
        if found := FACE_RANGE.fullmatch(entry):
            first, last = int(found[1]), int(found[2])
        else:
            first = last = entity(int(entry) if entry.isdecimal() else entry, name, "face")
        if last > count:
            raise ValueError(f"{name}: there is no face {last} in it, it has {count}")
        made.extend(range(first, last + 1))
    return sorted(set(made))


def number_list(value: Any, name: str, count: int) -> List[float]:
    """So many finite numbers; none if there is no value."""
    if value is None:
        return []
    parts = members(value, name, f"{count} numbers are")
    if len(parts) != count:
        raise ValueError(f"{name}: {count} numbers are wanted, got {len(parts)}")
    return [number(part, name) for part in parts]


def corners(value: Any, name: str) -> List[float]:
    """Three pairs as six numbers; none if there is no value."""
    if value is None:
        return []
    pairs = _rows(value, name, "three pairs (u, v) are")
    if len(pairs) != 3:
        raise ValueError(f"{name}: three pairs (u, v) are wanted, got {len(pairs)}")
    return [part for pair in pairs for part in number_list(pair, name, 2)]


def face_numbers(value: Any, name: str) -> List[int]:
    """One or more numbers of faces, each once, in increasing order."""
    listed = numbers_of(value, name, "face")
    if not listed:
        raise ValueError(f"{name}: there is no face number in it")
    return listed


def face_pair(value: Any, name: str) -> Tuple[int, int]:
    """Two numbers of faces."""
    listed = numbers_of(value, name, "face")
    if len(listed) != 2:
        raise ValueError(f"{name}: two different face numbers are wanted, got {len(listed)}")
    return (listed[0], listed[1])


def angle(value: Any, name: str) -> float:
    """Above 0 and not above pi: what is more was meant as degrees."""
    made = positive(value, name)
    if made > math.pi:
        raise ValueError(f"{name}: {made} is above pi; radians are wanted")
    return made


NamedPlane = Tuple[Triple, Triple, str, Optional[float]]


def named_planes(value: Any, name: str) -> List[NamedPlane]:
    """Pairs of a point and a normal, or triples with a name behind them."""
    listed = _rows(value, name, "a list of pairs (point, normal) is")
    made: List[NamedPlane] = []
    for place, plane in enumerate(listed, start=1):
        if len(plane) not in (2, 3):
            raise ValueError(
                f"{name}: a plane is (point, normal) or (point, normal, name), "
                f"got {len(plane)} members"
            )
        title = text(plane[2], f"{name}, name") if len(plane) == 3 else f"plane {place}"
        point, normal = vector(plane[0], f"{name}, point"), vector(plane[1], f"{name}, normal")
        made.append((point, normal, title, None))
    return _some(made, name)


def planes_at(value: Any, name: str, point: Any, normal: Any) -> List[NamedPlane]:
    """Parallel planes at offsets from a point along the normal."""
    try:
        offsets = [number(each, name) for each in value]
    except TypeError as error:
        if str(error).startswith(f"{name}:"):
            raise
        raise TypeError(f"{name}: a list of numbers is wanted, got {kind(value)}") from None
    start, along = vector(point, "point"), vector(normal, "normal")
    length = math.hypot(*along)
    if length == 0:
        raise ValueError("normal: the zero vector has no direction")
    made: List[NamedPlane] = []
    for i, offset in enumerate(offsets, start=1):
        x, y, z = (s + offset * n / length for s, n in zip(start, along))
        made.append(((x, y, z), along, f"plane {i}, offset {offset:.6g}", offset))
    return _some(made, name)


def planes_of_sections(planes: Any, offsets: Any, point: Any, normal: Any) -> List[NamedPlane]:
    """Those that are given, or those at offsets; one of the two is."""
    if (planes is None) == (offsets is None):
        raise ValueError("sections needs planes, or offsets")
    if offsets is None:
        return named_planes(planes, "planes")
    return planes_at(offsets, "offsets", point, normal)


def _some(listed: List[NamedPlane], name: str) -> List[NamedPlane]:
    if not listed:
        raise ValueError(f"{name}: there is no plane in it")
    return listed


_OF_MODELS = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
_OF_TRIANGLES = (".stl", ".ply", ".obj", ".off", ".3mf", ".glb")
_OF_DRAWINGS = (".dxf", ".svg")
FACET_ANGLE = 0.5  # radians; FacetOptions in core/tessellation/facet_options.h


def shape_file(value: Any, name: str) -> str:
    """The name of a file that shapes are written to."""
    file = path(value, name)
    if is_of_drawings(file):
        raise ValueError(f"{name}: {file} is a drawing, which sections are written to alone")
    if not file.lower().endswith(_OF_MODELS + _OF_TRIANGLES):
        raise ValueError(f"{name}: {file} ends with none of {' '.join(_OF_MODELS + _OF_TRIANGLES)}")
    return file


def is_of_triangles(file: str) -> bool:
    """Whether a file, by its ending, has triangles and no surfaces."""
    return file.lower().endswith(_OF_TRIANGLES)


def is_of_drawings(file: str) -> bool:
    """Whether a file, by its ending, is a drawing."""
    return file.lower().endswith(_OF_DRAWINGS)


def view(value: Any, name: str) -> str:
    """Where a picture is seen from: a word, or the direction to the eye; empty for None."""
    if value is None or isinstance(value, str):
        return value or ""
    return ",".join(map(repr, vector(value, name)))


def size(value: Any, name: str) -> Tuple[int, int]:
    """Width and height in pixels."""
    parts = members(value, name, "a width and a height are")
    if len(parts) != 2:
        raise ValueError(f"{name}: a width and a height are wanted, got {len(parts)} numbers")
    return (whole(parts[0], name, 1), whole(parts[1], name, 1))


def facets(
    deviation: Any, turn: Any, edge_length: Any, aspect: Any
) -> Tuple[float, float, float, float]:
    """How fine triangles are; 0 is what is not given, and of a deviation a part of the size."""
    return (
        0.0 if deviation is None else positive(deviation, "deviation"),
        FACET_ANGLE if turn is None else angle(turn, "angle"),
        0.0 if edge_length is None else positive(edge_length, "edge_length"),
        0.0 if aspect is None else positive(aspect, "aspect"),
    )


def edges(value: Any, name: str) -> Tuple[List[int], str]:
    """Numbers of edges, or a word for them; what is not meant is empty."""
    if isinstance(value, str) and _entity_number(value, "edge") is None:
        return [], word(value, name, EDGE_WORDS)
    return numbers_of(value, name, "edge"), ""


_KNOWN_OPTIONS = (
    "tolerance", "form", "time_limit", "budget", "threads", "nice", "cancel", "progress",
)  # fmt: skip
_MOST_NICE = 19  # of the system's priorities

Progress = Callable[[float], object]


def control(
    options: Dict[str, Any], fuzzy: float = 0, own: Tuple[str, ...] = ()
) -> _core.Control:
    """The options that all questions have in common; see the package's help.

    fuzzy   goes on top of the tolerance
    own     the question's own options, to name them
    """
    known = own + _KNOWN_OPTIONS
    for name in options:
        if name not in _KNOWN_OPTIONS:
            raise TypeError(f"there is no option '{name}'; there are {', '.join(known)}")
    cancel: Optional[_core.Cancel] = options.get("cancel")
    if cancel is not None and not isinstance(cancel, _core.Cancel):
        raise TypeError(f"cancel: a blossom.Cancel is wanted, got {kind(cancel)}")
    progress: Union[Progress, None] = options.get("progress")
    if progress is not None and not callable(progress):
        raise TypeError(f"progress: a function of the seconds is wanted, got {kind(progress)}")
    budget = options.get("budget")
    return _core.Control(
        tolerance=positive(options.get("tolerance", 1e-7), "tolerance") + fuzzy,
        form=word(options.get("form", "auto"), "form", FORMS),
        time_limit=not_negative(options.get("time_limit", 0), "time_limit"),
        budget=None if budget is None else whole(budget, "budget", 1),
        threads=whole(options.get("threads", 0), "threads", 0),
        nice=_niceness(options.get("nice", 0)),
        cancel=cancel,
        progress=progress,
    )


def _niceness(value: Any) -> int:
    made = whole(value, "nice", 0)
    if made > _MOST_NICE:
        raise ValueError(f"nice: {made} is more than {_MOST_NICE}")
    return made
