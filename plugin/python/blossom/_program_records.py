# SPDX-License-Identifier: LGPL-2.1-or-later
"""What answers hand out as arrays, of the program's reports and files.

Splines of curves are not in them: records have no such members, and say so.
"""

import json
from typing import Any, Callable, Dict, Iterable, List, Sequence

import numpy as np

Told = Dict[str, Any]


def of(command: Sequence[str], report: Told, made: Callable[[str], str]) -> Told:
    """The records of an answer to a command.

    made   the name of a file of the answer, by its ending
    """
    schema = report.get("schema", "")
    if schema.startswith(("blossom.intersection/", "blossom.self-intersection/")):
        return _intersection(report)
    if command[:2] == ["query", "plane"]:
        listed = report.get("planes", [{"parts": [report]}])
        curves = [each for plane in listed for part in plane["parts"] for each in part["curves"]]
        return {"splines": [{} for _ in curves]}
    if schema.startswith("blossom.mesh/"):
        return _mesh(made("obj"))
    if schema.startswith(("blossom.conversion/", "blossom.subdivision/")) and "--whole" not in command:
        with open(made("json"), encoding="utf-8") as stream:
            return {"nets": json.load(stream)["nets"]}
    return {}


def _array(told: Any, kind: Any = float) -> Any:
    """Not to be written to, as what the compiled part gives."""
    made = np.array(told, kind)
    made.setflags(write=False)
    return made


_ARRAYS = ("points", "point", "uv_a", "uv_b", "boundary")


def _record(told: Told, names: Iterable[str]) -> Told:
    record = {name: told[name] for name in names if name in told}
    for name in _ARRAYS:
        if name in record:
            record[name] = _array(record[name])
    for name in ("on_a", "on_b"):
        on = record.get(name)
        if isinstance(on, dict):
            record[name] = (on["kind"], on["number"])
    return record


_FACES = ("face_a", "face_b")
_OF_CURVES = (
    "points", "uv_a", "uv_b", "closed", "tangential", "length", "least_angle", "deviation",
    "deviation_proven", "conic", "degree",
)  # fmt: skip
_OF_CONTACTS = ("point", "uv_a", "uv_b", "on_a", "on_b")
_ON = ("on_a", "on_b")


def _intersection(report: Told) -> Told:
    """Curves are those of the report: they go on across seams, each is a chain."""
    curves = report["curves"]
    return {
        "status": report["status"],
        "seconds": report["seconds"],
        "certificate": report["certificate"],
        "curves": [_record(each, (*_OF_CURVES, *_FACES)) for each in curves],
        "chains": [
            {"curves": [(place, True)], **_record(each, ("closed", "length", *_FACES))}
            for place, each in enumerate(curves)
        ],
        "points": [_record(each, (*_OF_CONTACTS, *_FACES)) for each in report["points"]],
        "nodes": [
            {"on_a": None, "on_b": None, **_record(each, ("point", "uv_a", "uv_b", *_FACES))}
            for each in report["nodes"]
        ],
        "overlaps": [
            _record(each, ("boundary", "uv_a", "uv_b", *_FACES)) for each in report["overlaps"]
        ],
        "places": [
            {
                "box": tuple(_array(corner) for corner in each["box"]),
                "gap": tuple(each["gap"]),
                **_record(each, ("kind", *_FACES)),
            }
            for each in report["places"]
        ],
        "edge_points": [
            _record(each, ("point", *_ON, "parameter")) for each in report.get("edge_points", [])
        ],
        "edge_stretches": [
            {
                "start": _array(each["from"]),
                "end": _array(each["to"]),
                "parameters": tuple(each["parameters"]),
                **_record(each, ("length", *_ON)),
            }
            for each in report.get("edge_stretches", [])
        ],
    }


def _mesh(file: str) -> Told:
    vertices: List[List[float]] = []
    triangles: List[List[int]] = []
    faces: List[int] = []
    groups: List[Any] = []
    with open(file, encoding="utf-8") as stream:
        for line in stream:
            word, _, rest = line.rstrip("\n").partition(" ")
            if word == "v":
                vertices.append([float(x) for x in rest.split()[:3]])
            elif word == "g":
                groups.append((rest, len(triangles), None, 0))  # at most the name tells the part
            elif word == "f":
                triangles.append([int(corner.split("/")[0]) - 1 for corner in rest.split()])
                faces.append(int(groups[-1][0].rsplit("Face", 1)[1]))
    return {
        "vertices": _array(vertices).reshape(-1, 3),
        "triangles": _array(triangles, np.int32).reshape(-1, 3),
        "faces": _array(faces, np.int32),
        "groups": groups,
    }


def obj_of(vertices: Any, triangles: Any, groups: Sequence[Any]) -> str:
    """Triangles as the text of an .obj file."""
    starts = {first: name for name, first, *_ in groups}
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    for place, (a, b, c) in enumerate((triangles + 1).tolist()):
        lines += [f"g {starts[place]}"] if place in starts else []
        lines.append(f"f {a} {b} {c}")
    return "\n".join(lines) + "\n"
