# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes of all kinds as the compiled part's models, and models as shapes of FreeCAD's Part."""

import functools
import importlib
import io
import os
import pathlib
import re
import sys
import tempfile
import warnings
from typing import Any, List, Optional, Sequence, Tuple

import numpy as np

from . import _checks, _core, _engine

_WANTED = (
    "a file's name, BRep text or bytes, a shape of FreeCAD's Part, an object that exports BRep, "
    "a numpy net or a Model is wanted"
)
# How the text that Open CASCADE writes begins, with or without DRAW's first line.
_BREP_TEXT = re.compile(r"\s*(DBRep_DrawableShape|CASCADE Topology V)")


def core_model(shape: Any, name: str) -> _core.Model:
    """The model of any accepted argument."""
    try:
        return _core_model(shape, name)
    except ReferenceError as gone:  # FreeCAD's word for what belonged to a closed document
        raise ValueError(f"{name}: the object is deleted, or its document closed") from gone


def _core_model(shape: Any, name: str) -> _core.Model:
    if isinstance(shape, _core.Model):
        return shape
    if isinstance(shape, (bytes, bytearray, memoryview)):
        return _core.read_bytes(bytes(shape), name, False)
    if isinstance(shape, str) and _BREP_TEXT.match(shape):
        return _core.read_bytes(shape.encode(), name, False)
    if isinstance(shape, (str, os.PathLike)):
        return core_of_file(_checks.path(shape, name), name, False, _checks.control({}))
    if isinstance(shape, np.ndarray) or hasattr(shape, "__array_interface__"):
        return net_model(shape, name)
    if hasattr(shape, "exportBinary") and hasattr(shape, "isNull"):
        return _part_model(shape, name)
    exported = _exported_brep(shape, name)
    if exported is not None:
        return _core.read_bytes(exported, name, True)
    # Which of its places is meant, only who gives it knows.
    held = "; its Shape is one, without the places of containers" if hasattr(shape, "Shape") else ""
    if isinstance(getattr(shape, "_core", None), _core.Triangles):
        held = "; a mesh answers itself, as mesh.check() or mesh.intersect(model)"
    raise TypeError(f"{name}: {_WANTED}, got {_checks.kind(shape)}{held}")


def warn(text: str) -> None:
    """Names the line that called the package, by whichever of its functions."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals["__name__"].partition(".")[0] == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(text, stacklevel=level)


def core_of_file(path: str, name: str, strict: bool, control: _core.Control) -> _core.Model:
    """The model of a file, or of what is named in it: "part.step#3,5-9", "part.step#Shaft"; a file
    that is called so wins."""
    file, words = file_and_words(path)
    model = _told_core(file, name, strict, control)
    return part_named(model, words, name, path) if words else model


def file_and_words(path: str) -> Tuple[str, str]:
    """The name of a file, and what is named in it behind a "#", if anything is."""
    file = path
    while "#" in file and not os.path.exists(file):  # names of parts may have the letter, too
        file = file.rpartition("#")[0]
    if not os.path.exists(file):
        return path, ""
    return file, path[len(file) + 1 :]


def _told_core(path: str, name: str, strict: bool, control: _core.Control) -> _core.Model:
    """Files of triangles are refused, and shapes that reading lost are warned of."""
    if path.lower().endswith(_checks.MESH_FILES) and os.path.exists(path):
        raise ValueError(f"{name}: {path} is of triangles, which from_mesh() takes")
    model = _core.read_file(path, strict, control)
    reading = model.reading
    if reading is not None and reading["grade"] == "shapes lost":
        lost = [
            f"{each['count']} x {each['what']}: {each['cause']}"
            for each in reading["losses"]
            if each["of_shape"]
        ]
        warn(f"{path}: shapes are missing or not as they are there: " + "; ".join(lost))
    return model


def part_named(model: _core.Model, words: str, name: str, called: str) -> _core.Model:
    """Of "3,5-9,Face12,Shaft", what an input of the command line has after its '#'. Names may have
    commas."""
    faces: List[int] = []
    names: List[str] = []
    for word in model.words_in(words):
        if any(letter.isalpha() for letter in word):
            names.append(word)
        else:
            faces += _checks.chosen_faces(word, name, model.face_count)
    return model.part(sorted(set(faces)), names, called)


def searched(model: _core.Model, control: _core.Control) -> _core.Model:
    """All of it but the faces of a file that nothing can be found on, of which it warns."""
    if not model.file:
        return model
    usable = model.usable_part(control)
    if usable is None:
        return model
    for what, numbers in usable.left_out.items():
        faces = ", ".join(map(str, numbers))
        warn(
            f"{model.name}: face{'s' * (len(numbers) > 1)} {faces} "
            f"ha{'ve' if len(numbers) > 1 else 's'} {what} and "
            f"{'are' if len(numbers) > 1 else 'is'} left out"
        )
    return usable


def write(
    model: _core.Model, file: str, control: _core.Control, called: Optional[str] = None
) -> None:
    """Warned of is what the file has not that was read, and what had to be written otherwise.

    called   the file in what is warned of
    """
    for note in model.write(file, control):
        warn(f"{called or file}: {note}")


Packed = Tuple[str, bytes]


def packed(model: _core.Model) -> Packed:
    """Bytes for another process: BRep, which is the same to the last bit but has no names, or STEP."""
    if not any(model.part_paths()) and not any(model.face_names()):
        return "brep", model.brep()
    with tempfile.TemporaryDirectory(prefix="blossom-") as folder:
        file = pathlib.Path(folder, "model.step")
        write(model, str(file), _checks.control({}), f"{model.name}, packed")
        return "step", file.read_bytes()


def unpacked(made: Packed, name: str) -> _core.Model:
    kind, data = made
    if kind == "brep":
        return _core.read_bytes(data, name, True)
    with tempfile.TemporaryDirectory(prefix="blossom-") as folder:
        file = pathlib.Path(folder, "model.step")
        file.write_bytes(data)
        return _core.read_passing(str(file), name)


def net_model(net: Any, name: str) -> _core.Model:
    """The face of a net with two directions, the edge of one with one direction."""
    array = _numbers(net, name)
    if array.ndim == 2:
        return _core.net_edge(array, None, name)
    return _core.net_face(array, None, None, name)


_NUMBERS = "a list of numbers is"


def _numbers(net: Any, name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    try:
        array = np.asarray(net)
    except ValueError:
        raise ValueError(f"{name}: the rows are not all of one length") from None
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{name}: a net holds numbers, got {array.dtype}")
    return np.ascontiguousarray(array, dtype=np.float64)


def spline_model(
    poles: Any, weights: Any, knots: Any, multiplicities: Any, degree: Any, directions: int
) -> _core.Model:
    """The model of a B-spline with poles, or of a Bezier form if there are no knots."""
    name = "poles"
    net = _numbers(poles, name)
    if weights is not None:
        listed = _numbers(weights, "weights")
        if net.ndim != directions + 1 or net.shape[-1] != 3 or listed.shape != net.shape[:-1]:
            raise ValueError(
                f"weights: one for each pole of three coordinates is wanted, got the shapes "
                f"{listed.shape} and {net.shape}"
            )
        net = np.concatenate([net, listed[..., np.newaxis]], axis=-1)
    if directions == 1:
        return _core.net_edge(net, _knot_vector(knots, multiplicities, degree, "knots"), name)
    if knots is None and multiplicities is None and degree is None:
        return _core.net_face(net, None, None, name)
    pairs = [_pair(knots, "knots"), _pair(multiplicities, "multiplicities"), _pair(degree, "degree")]
    u, v = (
        _knot_vector(pairs[0][k], pairs[1][k], pairs[2][k], f"knots, along {'uv'[k]}")
        for k in (0, 1)
    )
    return _core.net_face(net, u, v, name)


def _pair(value: Any, name: str) -> Sequence[Any]:
    try:
        pair = list(value)
    except TypeError:
        pair = []
    if len(pair) != 2:
        raise ValueError(f"{name}: a pair is wanted, along u and along v")
    return pair


def _knot_vector(
    knots: Any, multiplicities: Any, degree: Any, name: str
) -> Optional[_core.KnotVector]:
    if knots is None and multiplicities is None and degree is None:
        return None
    if knots is None or multiplicities is None or degree is None:
        raise ValueError(f"{name}: knots, multiplicities and degree go together")
    return _core.KnotVector(
        degree=_checks.whole(degree, "degree", 1),
        knots=[_checks.number(knot, name) for knot in _checks.members(knots, name, _NUMBERS)],
        multiplicities=[
            _checks.whole(each, "multiplicities", 1)
            for each in _checks.members(multiplicities, "multiplicities", _NUMBERS)
        ],
    )


def _part_model(shape: Any, name: str) -> _core.Model:
    """A shape of FreeCAD's Part: itself over SWIG's bridge, else a copy."""
    if shape.isNull():
        raise ValueError(f"{name}: the shape is null")
    part = sys.modules.get("Part")
    if part is not None and _has_bridge(part):
        model = _core.from_swig(part.__toPythonOCC__(shape), name)
        if model is not None:
            return model
    return _core.read_bytes(_part_brep(shape), name, True)


def _part_brep(shape: Any) -> bytes:
    """Binary, for it keeps every digit; Part writes it to files only."""
    with tempfile.TemporaryDirectory(prefix="blossom-") as folder:
        file = os.path.join(folder, "shape.bin")
        shape.exportBinary(file)
        with open(file, "rb") as stream:
            return stream.read()


@functools.lru_cache(maxsize=None)
def _has_bridge(part: Any) -> bool:
    """Whether Part's shapes are those of our Open CASCADE, and SWIG hands them over.

    Shapes of another copy of Open CASCADE have the same name and another layout: to take one of
    them for ours would crash.
    """
    if not _core.has_swig_bridge or not hasattr(part, "__toPythonOCC__"):
        return False
    if getattr(part, "OCC_VERSION", None) != _core.occt_version or len(_engine.loaded_kernels()) != 1:
        return False
    try:
        importlib.import_module("blossom.swig_shapes")
    except ImportError:
        return False
    return True


def _exported_brep(shape: Any, name: str) -> Optional[bytes]:
    """The BRep bytes of an object of CadQuery, build123d or pythonOCC; None if it is none."""
    for method in ("exportBrep", "export_brep"):
        export = getattr(shape, method, None)
        if callable(export):
            return _written_brep(export, name)
    value = getattr(shape, "val", None)  # CadQuery's Workplane
    if callable(value) and hasattr(shape, "objects"):
        return _exported_brep(value(), name)
    for inner in (shape, getattr(shape, "wrapped", None)):
        exporter = _breptools_of(inner)
        if exporter is not None:
            return _written_by_breptools(exporter, inner)
    return None


def _written_brep(export: Any, name: str) -> bytes:
    stream = io.BytesIO()
    try:
        export(stream)
        return stream.getvalue()
    except TypeError:  # it writes files only
        with tempfile.TemporaryDirectory(prefix="blossom-") as folder:
            file = os.path.join(folder, "shape.brep")
            export(file)
            if not os.path.exists(file):
                raise ValueError(f"{name}: its export wrote no file") from None
            with open(file, "rb") as written:
                return written.read()


# Where bindings of Open CASCADE keep what writes a shape.
_BREPTOOLS: Tuple[Tuple[str, str, str], ...] = (
    ("OCP.", "OCP.BRepTools", "BRepTools"),
    ("OCC.", "OCC.Core.BRepTools", "breptools"),
)


def _breptools_of(shape: Any) -> Any:
    module = type(shape).__module__ or ""
    if not type(shape).__name__.startswith("TopoDS_"):
        return None
    for prefix, tools, member in _BREPTOOLS:
        if module.startswith(prefix):
            return getattr(importlib.import_module(tools), member, None)
    return None


def _written_by_breptools(tools: Any, shape: Any) -> bytes:
    with tempfile.TemporaryDirectory(prefix="blossom-") as folder:
        file = os.path.join(folder, "shape.brep")
        write = getattr(tools, "Write_s", None) or tools.Write
        write(shape, file)
        with open(file, "rb") as written:
            return written.read()


def part_shape(model: _core.Model) -> Any:
    """A shape of FreeCAD's Part."""
    try:
        importlib.import_module("FreeCAD")  # without it, Part ends the process
        part = importlib.import_module("Part")
    except ImportError as missing:
        raise _core.Error(f"to_part: FreeCAD's Part cannot be imported: {missing}") from missing
    if _has_bridge(part):
        swig = model.swig()
        if swig is not None:
            return part.__fromPythonOCC__(swig)
    shape = part.Shape()
    shape.importBrepFromString(model.brep().decode("ascii"))
    return shape
