# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersections, sections, trims and solids of CAD models, with proofs.

    import blossom
    model = blossom.read("bracket.step")
    model.section((0, 0, 5), (0, 0, 1)).wires    # many questions, one reading
    found = blossom.intersect(face_a, face_b)
    found.status                                 # "complete": nothing is missing
    found.curves[0].points                       # (n, 3) array
    Part.show(found.to_part())
    found.to_html("found.html")                  # also to_png, to_glb; of models and meshes, too

Shapes are
    names of files             str or Path
    BRep                       bytes, or its text
    shapes of FreeCAD's Part   themselves, not copies, where Part's Open CASCADE is ours
    other objects              that export BRep: CadQuery's, build123d's, pythonOCC's
    numpy nets                 of one Bezier patch (n + 1, m + 1, 3), or 4 with weights, or of a
                               curve (n + 1, 3 or 4); B-splines by `surface` and `curve`
    models and results         of this package

Where another Open CASCADE than Blossom's is loaded before the package, the program `blossom` works on
files in a process of its own, with the same answers; `why_elsewhere()` says so.

Every question takes these options:
    tolerance    what counts as one point, model units; 1e-7
    time_limit   seconds before giving up with the status "stopped"; 0 is no limit
    budget       pairs of cells examined before giving up; None is the engine's own
    threads      how many may work at the same time; 0 is one a core
    nice         0 to 19: how far the work gives way to the calling thread, as to that of a window;
                 0 is not at all (Linux)
    form         "auto", "bezier" or "monomial": what the nets of cells are made from
    cancel       a `Cancel`; its cancel(), from any thread, ends the work with `Cancelled`
    progress     a function that is called with the seconds since the start, some 50 times a
                 second; what it raises ends the work

Lengths are in millimetres for files, else in the model's units; angles in radians; face numbers
start at 1 as in "Face1". Wrong types are TypeErrors, wrong values and models that cannot be used
ValueErrors, failures of Open CASCADE `blossom.Error`. Ctrl-C ends all work.
"""

import os
from typing import Any, Dict, Literal, Optional, Union, overload

from . import _engine

_engine.choose()  # what _core is, before anything asks for it

from . import _checks, _core
from ._bodies import Chamfer, EdgeBlend, Fill, Fillet, Solid, Strip, Trim, Watertight
from ._clashes import Clash, ClashPair
from ._core import Cancel, Cancelled, Error, __version__
from ._engine import why_elsewhere
from ._forms import Conversion, Net, Spline, Subdivision, Whole
from ._intersections import (
    Chain,
    Contact,
    Curve,
    EdgePoint,
    EdgeStretch,
    Intersection,
    Overlap,
    Place,
    SelfIntersection,
)
from ._meshes import Mesh
from ._model import FileName, Model, model_of
from ._operations import Radii, Radius
from ._queries import (
    Check,
    Continuity,
    Distance,
    FootPoints,
    Hit,
    Mass,
    Meeting,
    PartMass,
    RayHits,
)
from ._results import Result
from ._sections import PartSection, PlaneSection, Section, SectionCurve, Sections, Wire
from ._shapes import core_of_file, spline_model
from ._triangles import (
    MeshCheck,
    MeshDistance,
    MeshIntersection,
    MeshPatches,
    MeshSections,
    Triangles,
    from_mesh,
)

__all__ = [
    "Cancel",
    "Cancelled",
    "Chain",
    "Chamfer",
    "Check",
    "Clash",
    "ClashPair",
    "Contact",
    "Continuity",
    "Conversion",
    "Curve",
    "Distance",
    "EdgeBlend",
    "EdgePoint",
    "EdgeStretch",
    "Error",
    "Fill",
    "Fillet",
    "FootPoints",
    "Hit",
    "Intersection",
    "Mass",
    "Meeting",
    "Mesh",
    "MeshCheck",
    "MeshDistance",
    "MeshIntersection",
    "MeshPatches",
    "MeshSections",
    "Model",
    "Net",
    "Overlap",
    "PartMass",
    "PartSection",
    "Place",
    "PlaneSection",
    "RayHits",
    "Result",
    "Section",
    "SectionCurve",
    "Sections",
    "SelfIntersection",
    "Solid",
    "Spline",
    "Strip",
    "Subdivision",
    "Triangles",
    "Trim",
    "Watertight",
    "Whole",
    "Wire",
    "__version__",
    "blend_strip",
    "chamfer",
    "check",
    "clash",
    "continuity",
    "convert",
    "curve",
    "distance",
    "does_intersect",
    "fill",
    "fillet",
    "foot_points",
    "from_mesh",
    "info",
    "intersect",
    "mass",
    "mesh",
    "ray",
    "read",
    "section",
    "sections",
    "self_intersect",
    "shape",
    "solid",
    "subdivide",
    "surface",
    "trim",
    "watertight",
    "why_elsewhere",
    "write",
]


def read(path: FileName, faces: Any = None, strict: bool = False, **options: Any) -> Model:
    """Reads a STEP, IGES or BREP file, told by its content.

    Shapes that are missing in what was read are warned of; `reading` has all that is.

    path     perhaps with faces or parts of it: "part.step#3,5-9", "part.step#Face3", "part.step#Lid"
    faces    the same: numbers of the faces that count, "Face3", or "Lid"; None is all
    strict   a file of which shapes are missing is refused
    """
    if not isinstance(path, (str, os.PathLike)):
        raise TypeError(
            f"path: a str or a Path is wanted, got {_checks.kind(path)}; shape() takes shapes"
        )
    file = _checks.path(path, "path")
    read_as = _checks.flag(strict, "strict"), _checks.control(options)
    model = Model(core_of_file(file, "path", *read_as))
    return model if faces is None else model.part(faces)


def shape(shape: Any, name: str = "shape") -> Model:
    """Any shape as a model, to ask it many questions.

    name   what messages and reports call it
    """
    return model_of(shape, _checks.text(name, "name"))


def surface(
    poles: Any, weights: Any = None, knots: Any = None, multiplicities: Any = None, degree: Any = None
) -> Model:
    """A face on a B-spline surface, or on a Bezier patch without knots.

    poles            (n + 1, m + 1, 3), rows along u; or 4 with weights
    weights          (n + 1, m + 1)
    knots            two lists that increase, along u and v
    multiplicities   likewise, one for each knot
    degree           a pair
    """
    return Model(spline_model(poles, weights, knots, multiplicities, degree, 2))


def curve(
    poles: Any, weights: Any = None, knots: Any = None, multiplicities: Any = None, degree: Any = None
) -> Model:
    """An edge on a B-spline curve, or on a Bezier curve without knots; as `surface`, with (n + 1, 3)
    poles and one list of each."""
    return Model(spline_model(poles, weights, knots, multiplicities, degree, 1))


def write(shape: Any, path: FileName, **options: Any) -> None:
    """Writes a shape to a file: .step, .iges or .brep, or of triangles; see `Model.write`."""
    model_of(shape, "shape").write(path, **options)


def convert(source: Any, target: Optional[FileName] = None, *, to: Optional[str] = None,
            **options: Any) -> Optional[Conversion]:
    """A shape in another form, a file in another format, or both.

    target   the file to write: .step, .iges or .brep, or of triangles, see `Model.write`; names,
             colours and assembly are kept where both have them
    to       "bezier", "monomial" or "triangles"; see `Model.convert`. None keeps the forms
    """  # fmt: skip
    if target is None and to is None:
        raise ValueError("convert needs a target, or a form to convert to")
    model = model_of(source, "source")
    made = None if to is None else model.convert(to, **options)
    if target is not None:
        (model if made is None else made).write(target, **options)
    return made


@overload
def subdivide(
    shape: Any, rectangle: Any = None, *, whole: Literal[False] = False, **options: Any
) -> Subdivision: ...
@overload
def subdivide(
    shape: Any, rectangle: Any = None, *, whole: Literal[True], **options: Any
) -> Whole: ...
def subdivide(
    shape: Any, rectangle: Any = None, *, whole: bool = False, **options: Any
) -> Union[Subdivision, Whole]:
    """Sub-patches of faces, sub-curves of edges; see `Model.subdivide`."""
    model = model_of(shape, "shape")
    if _checks.flag(whole, "whole"):
        return model.subdivide(rectangle, whole=True, **options)
    pieces: Subdivision = model.subdivide(rectangle, **options)
    return pieces


def info(shape: Any, edges: bool = False, **options: Any) -> Dict[str, Any]:
    """What a model is made of, as `blossom info` reports it."""
    return model_of(shape, "shape").info(edges, **options)


def continuity(shape: Any, **options: Any) -> Continuity:
    """How smoothly faces meet along every edge; see `Model.continuity`."""
    return model_of(shape, "shape").continuity(**options)


def check(shape: Any, **options: Any) -> Check:
    """What is wrong with a model."""
    return model_of(shape, "shape").check(**options)


def intersect(a: Any, b: Any, **options: Any) -> Intersection:
    """All intersections of every face of `a` with every face of `b`, or of the edges of a shape
    without faces, as blossom.read("wire.step") or block.part("edge:3").

    An empty answer whose status is "complete" is a proof of emptiness.
    """
    return model_of(a, "a").intersect(model_of(b, "b"), **options)


def self_intersect(shape: Any, faces: bool = False, **options: Any) -> SelfIntersection:
    """Where each face meets itself; with `faces`, also different faces each other."""
    return model_of(shape, "shape").self_intersect(faces, **options)


def section(shape: Any, point: Any, normal: Any, **options: Any) -> Section:
    """The section with the plane through a point."""
    return model_of(shape, "shape").section(point, normal, **options)


def sections(shape: Any, planes: Any = None, **options: Any) -> Sections:
    """The sections with many planes, part by part; see `Model.sections`."""
    return model_of(shape, "shape").sections(planes, **options)


def clash(a: Any, b: Any = None, **options: Any) -> Clash:
    """How the parts of a model lie to each other, or to those of another; see `Model.clash`."""
    return model_of(a, "a").clash(None if b is None else model_of(b, "b"), **options)


def mesh(shape: Any, deviation: Optional[float] = None, **options: Any) -> Mesh:
    """Triangles within a proven distance; see `Model.mesh`."""
    return model_of(shape, "shape").mesh(deviation, **options)


def ray(
    shape: Any, origin: Any, direction: Any, first: bool = False, line: bool = False, **options: Any
) -> RayHits:
    """What a ray hits, in order."""
    return model_of(shape, "shape").ray(origin, direction, first, line, **options)


def distance(a: Any, b: Any, **options: Any) -> Distance:
    """How far two shapes are apart."""
    return model_of(a, "a").distance(model_of(b, "b"), **options)


def does_intersect(a: Any, b: Any, **options: Any) -> Meeting:
    """Whether two shapes have a point in common."""
    return model_of(a, "a").does_intersect(model_of(b, "b"), **options)


def foot_points(shape: Any, at: Any, all: bool = True, **options: Any) -> FootPoints:
    """The nearest point of a shape to a point, and every point where the distance is stationary."""
    return model_of(shape, "shape").foot_points(at, all, **options)


def mass(shape: Any, **options: Any) -> Mass:
    """Volume, area, centre of gravity and inertia."""
    return model_of(shape, "shape").mass(**options)


def trim(
    part: Any, *tools: Any, keep: Union[str, int], planes: Any = (), **options: Any
) -> Trim:
    """A part cut along its intersections with tools; see `Model.trim`."""
    return model_of(part, "part").trim(*tools, keep=keep, planes=planes, **options)


def solid(
    operation: str, part: Any, *tools: Any, planes: Any = (), fuzzy: float = 0, **options: Any
) -> Solid:
    """Closed solids combined: "cut", "common", "fuse" or "split"; see `Model.solid`."""
    _checks.word(operation, "operation", _checks.OPERATIONS)  # before a file of that name is missed
    return model_of(part, "part").solid(operation, *tools, planes=planes, fuzzy=fuzzy, **options)


def fillet(
    shape: Any,
    edges: Any = (),
    *,
    radius: Optional[Radii] = None,
    between: Any = None,
    **options: Any,
) -> Fillet:
    """Edges of solids rounded by a rolling ball; see `Model.fillet`."""
    return model_of(shape, "shape").fillet(edges, radius=radius, between=between, **options)


def chamfer(
    shape: Any, edges: Any = (), *, distance: Radius, between: Any = None, **options: Any
) -> Chamfer:
    """Edges of solids cut off; see `Model.chamfer`."""
    return model_of(shape, "shape").chamfer(edges, distance=distance, between=between, **options)


def fill(shape: Any, edges: Any = (), **options: Any) -> Fill:
    """Patches in holes that continue their neighbours; see `Model.fill`."""
    return model_of(shape, "shape").fill(edges, **options)


def watertight(shape: Any, **options: Any) -> Watertight:
    """The faces as untrimmed patches and triangles that meet without gaps."""
    return model_of(shape, "shape").watertight(**options)


def blend_strip(
    a: Any,
    b: Any,
    edge_a: Union[str, int, None] = None,
    edge_b: Union[str, int, None] = None,
    continuity: str = "G1",
    weight_a: float = 1.0,
    weight_b: float = 1.0,
    **options: Any,
) -> Strip:
    """The strip between two faces that continues both, exactly or as near as it says.

    edge_a, edge_b      "umin", "umax", "vmin", "vmax", or the number of an edge of the model, from
                        1; None takes the nearest borders
    continuity          "G1" continues tangent planes, "G2" curvatures, "G3" their derivatives too
    weight_a, weight_b  how far the tangents reach into the strip; 1 is the width over its degree
    """
    start_a, start_b = _checks.border(edge_a, "edge_a"), _checks.border(edge_b, "edge_b")
    smoothness = _checks.word(continuity, "continuity", _checks.STRIP_ORDERS)
    order = 1 + _checks.STRIP_ORDERS.index(smoothness)
    reach_a, reach_b = _checks.number(weight_a, "weight_a"), _checks.number(weight_b, "weight_b")
    core_a, core_b = model_of(a, "a")._core, model_of(b, "b")._core
    return Strip(
        _core.strip(
            core_a, core_b, start_a, start_b, order, reach_a, reach_b, _checks.control(options)
        )
    )
