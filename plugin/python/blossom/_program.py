# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the compiled part has, by the program `blossom`: models are files, answers are its reports.

It stands for `_core` where that must not be loaded; see `_engine`.
"""

import json
import math
import os
import shutil
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _built_with, _program_records
from ._process import Cancel, Cancelled, Control, Error, Folder
from ._program_files import Answer, Model, Triangles, Words, asked, nothing, of_bytes, refuse

__all__ = ["Cancel", "Cancelled", "Control", "Error", "Triangles", "nothing"]

__version__ = _built_with.VERSION
occt_version = _built_with.OCCT
has_swig_bridge = False

Triple = Tuple[float, float, float]
_USUAL_FACET_ANGLE = 0.5
_USUAL_FILL_ANGLE = 1e-6


def __getattr__(name: str) -> Any:
    """Questions that the program has no command for, or tells too little of, are refused in words."""
    if name.startswith("__"):
        raise AttributeError(name)
    return lambda *_: refuse(f"{name}()")


def _numbers(values: Sequence[float]) -> str:
    return ",".join(repr(float(value)) for value in values)


# Models


def read_file(path: str, strict: bool, control: Control) -> Model:
    folder = Folder()
    copy = folder.file(os.path.basename(path))
    try:
        shutil.copyfile(path, copy)  # a model stays, whatever becomes of its file
    except FileNotFoundError:
        raise ValueError(f"{path}: no such file") from None
    except OSError as error:
        raise ValueError(f"{path}: {error.strerror or error}") from None
    model = Model(copy, path, folder, path)
    options = ["--tree", *(["--strict"] if strict else [])]
    model.know(asked(["info"], [model], control, options, ""))
    return model


def read_passing(path: str, name: str) -> Model:
    with open(path, "rb") as stream:
        return of_bytes(stream.read(), name, os.path.splitext(path)[1])


def read_bytes(brep: bytes, name: str, trusted: bool) -> Model:
    model = of_bytes(brep, name, ".brep")
    if not trusted:  # nothing of it may be missing
        model.know(asked(["info"], [model], None, ["--tree", "--strict"], ""))
    return model


class KnotVector:
    """The program takes Bezier nets alone."""

    def __init__(self, **_: Any) -> None:
        refuse("a B-spline of arrays")


def net_face(net: Any, u: Any, v: Any, name: str) -> Model:
    if net.ndim != 3 or net.shape[2] not in (3, 4) or min(net.shape) < 2:
        raise ValueError(f"{name}: a net (n + 1, m + 1, 3 or 4) is wanted, got {net.shape}")
    return _of_net("patch", [net.shape[0] - 1, net.shape[1] - 1], net, name)


def net_edge(net: Any, knots: Any, name: str) -> Model:
    if net.ndim != 2 or net.shape[1] not in (3, 4) or net.shape[0] < 2:
        raise ValueError(f"{name}: a net (n + 1, 3 or 4) is wanted, got {net.shape}")
    return _of_net("curve", net.shape[0] - 1, net, name)


def _of_net(kind: str, degree: Union[int, List[int]], net: Any, name: str) -> Model:
    if not np.isfinite(net).all():
        raise ValueError(f"{name}: a point is not finite")
    rational = net.shape[-1] == 4
    if rational:  # files have points that are multiplied by their weights
        net = np.concatenate([net[..., :3] * net[..., 3:], net[..., 3:]], axis=-1)
    told = {"kind": kind, "form": "bezier", "degree": degree, "rational": rational}
    nets = {"schema": "blossom.net/1", "nets": [{**told, "points": net.tolist()}]}
    data = json.dumps(nets).encode()
    brep = asked(["convert"], [of_bytes(data, name, ".json")], None, shape="brep", name=name)
    made = brep.model()
    assert made is not None
    return made


# Questions


def intersect(a: Model, b: Model, control: Control) -> Answer:
    return asked(["intersect"], [a, b], control, ["--joined"], name="intersection")


def self_intersect(model: Model, all_faces: bool, control: Control) -> Answer:
    options = ["--joined", *(["--faces"] if all_faces else [])]
    return asked(["self-intersect"], [model], control, options, name="intersection")


def distance(a: Model, b: Model, control: Control) -> Answer:
    return asked(["query", "distance"], [a, b], control, shape="")


def does_intersect(a: Model, b: Model, control: Control) -> Answer:
    return asked(["query", "does-intersect"], [a, b], control, shape="")


def check(model: Model, control: Control) -> Answer:
    return asked(["check"], [model], control, shape="")


def info(model: Model, edges: bool, faces: bool, control: Control) -> Answer:
    options = [word for word, wanted in (("--edges", edges), ("--faces", faces)) if wanted]
    return asked(["info"], [model], control, options, "")


def continuity(
    model: Model, gap: float, angle: float, curvature: float, require: str, control: Control
) -> Answer:
    options = ["--continuity", f"--gap={gap!r}", f"--curvature={curvature!r}"]
    options += [] if angle == 1e-3 else [f"--angle={math.degrees(angle)!r}"]
    options += [f"--require={require}"] if require else []
    return asked(["check"], [model], control, options, "")


def ray(
    model: Model, origin: Triple, direction: Triple, first: bool, line: bool, control: Control
) -> Answer:
    options = [f"--from={_numbers(origin)}", f"--direction={_numbers(direction)}"]
    options += [word for word, wanted in (("--first", first), ("--line", line)) if wanted]
    return asked(["query", "ray"], [model], control, options, "")


def nearest(model: Model, at: Triple, all: bool, control: Control) -> Answer:
    options = [f"--at={_numbers(at)}", *(["--all"] if all else [])]
    return asked(["query", "point"], [model], control, options, "")


def mass(model: Model, control: Control) -> Answer:
    return asked(["query", "mass"], [model], control, shape="")


def section(model: Model, point: Triple, normal: Triple, control: Control) -> Answer:
    options = [f"--point={_numbers(point)}", f"--normal={_numbers(normal)}"]
    return asked(["query", "plane"], [model], control, options, name="section")


def sections(
    model: Model, planes: List[Tuple[Triple, Triple, str, Optional[float]]], control: Control
) -> Answer:
    folder = Folder()
    listed = folder.file("planes.txt")
    with open(listed, "w", encoding="utf-8") as stream:
        for point, normal, name, offset in planes:
            own = "" if offset is not None else f" {name}"
            stream.write(f"{_numbers(point)},{_numbers(normal)}{own}\n")

    def with_offsets(report: Dict[str, Any]) -> None:
        for told, (_, _, name, offset) in zip(report["planes"], planes):
            told.update(name=name, offset=offset)

    options = ["--planes", listed]
    return asked(
        ["query", "plane"], [model], control, options, None, "sections", with_offsets, folder
    )


def clash(
    a: Model, b: Optional[Model], clearance: Optional[float], far: bool, control: Control
) -> Answer:
    options = [] if clearance is None else [f"--clearance={clearance!r}"]
    options += ["--far"] if far else []
    return asked(["clash"], [a] if b is None else [a, b], control, options)


# Shapes


def trim(
    part: Model, tools: List[Model], planes: List[Tuple[Triple, Triple]], keep: str, control: Control
) -> Answer:
    options = [f"--keep={keep}", *_planes(planes)]
    return asked(["trim"], [part, *tools], control, options)


def solid(
    operation: str,
    part: Model,
    tools: List[Model],
    planes: List[Tuple[Triple, Triple]],
    control: Control,
) -> Answer:
    options = [f"--solid={operation}", *_planes(planes)]
    return asked(["trim"], [part, *tools], control, options, name=operation)


def _planes(planes: List[Tuple[Triple, Triple]]) -> Words:
    return [f"--plane={_numbers([*point, *normal])}" for point, normal in planes]


def strip(
    a: Model,
    b: Model,
    edge_a: str,
    edge_b: str,
    order: int,
    weight_a: float,
    weight_b: float,
    control: Control,
) -> Answer:
    options = [f"--continuity=G{order}", f"--weight-a={weight_a!r}", f"--weight-b={weight_b!r}"]
    options += [f"--edge-a={edge_a}"] if edge_a else []
    options += [f"--edge-b={edge_b}"] if edge_b else []
    return asked(["blend", "strip"], [a, b], control, options)


def _chosen(edges: List[int], kind: str, between: Optional[Tuple[int, int]], partial: bool) -> Words:
    made = [f"--edges={kind}"] if kind else []
    made += [f"--edges={','.join(map(str, edges))}"] if edges else []
    made += [f"--between={between[0]},{between[1]}"] if between else []
    return made + (["--partial"] if partial else [])


def fillet(
    part: Model,
    edges: List[int],
    kind: str,
    between: Optional[Tuple[int, int]],
    radius: float,
    law: str,
    own: List[Tuple[int, float, str]],
    section: str,
    setback: Optional[float],
    full_round: bool,
    partial: bool,
    control: Control,
) -> Answer:
    for edge, *_ in own:
        if edges and edge not in edges:
            raise ValueError(f"edge {edge} has a radius, but is not among the edges")
    folder = Folder()
    options = [*_chosen(edges, kind, between, partial), f"--section={section}"]
    options += [] if setback is None else [f"--setback={setback!r}"]
    options += [f"--edge={edge}:{_size(size, each)}" for edge, size, each in own]
    if full_round:
        options.append("--full-round")
    elif law:
        file = folder.file("law.json")
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(law)
        options.append(f"--law={file}")
    else:
        options.append(f"--radius={radius!r}")
    return asked(["blend", "fillet"], [part], control, options, needed=folder)


def _size(radius: float, law: str) -> str:
    """A radius, or two of them: what an edge of its own may have."""
    if not law:
        return repr(radius)
    told_law = json.loads(law)
    if told_law["law"] != "linear":
        refuse("an edge's own law")
    return "..".join(repr(float(each)) for each in told_law["radii"])


def chamfer(
    part: Model,
    edges: List[int],
    kind: str,
    between: Optional[Tuple[int, int]],
    distance: float,
    second: Optional[float],
    angle: Optional[float],
    partial: bool,
    control: Control,
) -> Answer:
    size = repr(distance) + ("" if second is None else f",{second!r}")
    size += "" if angle is None else f":{math.degrees(angle)!r}"
    options = [*_chosen(edges, kind, between, partial), f"--distance={size}"]
    return asked(["blend", "chamfer"], [part], control, options)


def fill(
    model: Model,
    edges: List[int],
    continuity: List[str],
    layout: str,
    angle: float,
    sew: bool,
    control: Control,
) -> Answer:
    options = [f"--continuity={','.join(continuity)}", f"--layout={layout}"]
    options += [f"--edges={','.join(map(str, edges))}"] if edges else []
    options += [] if angle == _USUAL_FILL_ANGLE else [f"--angle={math.degrees(angle)!r}"]
    return asked(["blend", "fill"], [model], control, options + (["--sew"] if sew else []))


def sew(model: Model, control: Control) -> None:
    """A conversion sews; the model is its file from then on."""
    if model.words:
        refuse("sew() of a part")
    made = asked(["convert"], [model], control, name=os.path.splitext(model.name)[0]).model()
    assert made is not None
    model.path, model.folder, model.file, model._known = made.path, made.folder, "", None


# Forms and triangles


def subdivide(
    model: Model,
    interval: List[float],
    rectangle: List[float],
    triangle: List[float],
    q: List[float],
    levels: int,
    control: Control,
) -> Answer:
    options = [f"--levels={levels}"] if levels else []
    places = {"interval": interval, "rectangle": rectangle, "triangle": triangle, "q": q}
    return asked(["subdivide"], [model], control, options + _lists(places), name="subdivision")


def _lists(values: Dict[str, List[float]]) -> Words:
    return [each for word, of in values.items() if of for each in (f"--{word}", *map(repr, of))]


def subdivide_whole(
    model: Model, interval: List[float], rectangle: List[float], control: Control
) -> Answer:
    options = ["--whole", *_lists({"interval": interval, "rectangle": rectangle})]
    return asked(["subdivide"], [model], control, options, name="subdivision")


def convert(model: Model, to: str, control: Control) -> Answer:
    shape = "json" if to == "monomial" else None  # models have no such form
    return asked(["convert"], [model], control, [f"--to={to}"], shape, "conversion")


def _facets(deviation: float, angle: float, edge_length: float, aspect: float) -> Words:
    made = [f"--deviation={deviation!r}"] if deviation else []
    made += [] if angle == _USUAL_FACET_ANGLE else [f"--angle={math.degrees(angle)!r}"]
    made += [f"--edge-length={edge_length!r}"] if edge_length else []
    return made + ([f"--aspect={aspect!r}"] if aspect else [])


def mesh(
    model: Model, deviation: float, angle: float, edge_length: float, aspect: float, control: Control
) -> Answer:
    options = _facets(deviation, angle, edge_length, aspect)
    return asked(["convert"], [model], control, options, "obj", "mesh")


def write_mesh(
    model: Model,
    deviation: float,
    angle: float,
    edge_length: float,
    aspect: float,
    path: str,
    text: bool,
    control: Control,
) -> None:
    options = _facets(deviation, angle, edge_length, aspect) + (["--text"] if text else [])
    asked(["convert"], [model], control, options, os.path.abspath(path))


def mesh_of_arrays(name: str, vertices: Any, triangles: Any, groups: List[Any]) -> Triangles:
    return Triangles(vertices, triangles, groups)


def write_triangles(mesh: Triangles, path: str, text: bool, control: Control) -> None:
    data = _program_records.obj_of(mesh.vertices, mesh.triangles, mesh.groups).encode()
    options = ["--text"] if text else []
    asked(["convert"], [of_bytes(data, "mesh", ".obj")], control, options, os.path.abspath(path))
