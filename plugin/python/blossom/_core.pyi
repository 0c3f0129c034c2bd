# SPDX-License-Identifier: LGPL-2.1-or-later
# The compiled part; for the package's own modules.
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

Triple = Tuple[float, float, float]

__version__: str
occt_version: str
has_swig_bridge: bool

class Error(RuntimeError): ...
class Cancelled(Error): ...

class Cancel:
    def __init__(self) -> None: ...
    def cancel(self) -> None: ...
    @property
    def cancelled(self) -> bool: ...

class Control:
    def __init__(
        self,
        tolerance: float,
        form: str,
        time_limit: float,
        budget: Optional[int],
        threads: int,
        nice: int,
        cancel: Optional[Cancel],
        progress: Optional[Callable[[float], object]],
    ) -> None: ...

class Model:
    @property
    def name(self) -> str: ...
    @property
    def face_count(self) -> int: ...
    @property
    def counts(self) -> Dict[str, int]: ...
    @property
    def file(self) -> str: ...
    @property
    def file_unit(self) -> str: ...
    @property
    def reading(self) -> Optional[Dict[str, Any]]: ...
    def numbers(self) -> List[int]: ...
    def face_names(self) -> List[str]: ...
    def part_paths(self) -> List[str]: ...
    def repairs(self) -> Dict[str, Any]: ...
    def part(self, numbers: List[int], name: str) -> Model: ...
    def brep(self) -> bytes: ...
    def swig(self) -> Any: ...
    def write(self, path: str, control: Control) -> None: ...

class KnotVector:
    def __init__(
        self, degree: int, knots: Sequence[float], multiplicities: Sequence[int]
    ) -> None: ...

class Answer:
    def report(self, samples: bool) -> Dict[str, Any]: ...
    def model(self) -> Optional[Model]: ...
    def records(self) -> Dict[str, Any]: ...
    def draw(self, file: str, control: Control) -> None: ...

def read_file(path: str, strict: bool, control: Control) -> Model: ...
def read_bytes(brep: bytes, name: str) -> Model: ...
def from_swig(shape: Any, name: str) -> Optional[Model]: ...
def net_face(
    net: NDArray[np.float64], u: Optional[KnotVector], v: Optional[KnotVector], name: str
) -> Model: ...
def net_edge(net: NDArray[np.float64], knots: Optional[KnotVector], name: str) -> Model: ...
def intersect(a: Model, b: Model, control: Control) -> Answer: ...
def self_intersect(model: Model, all_faces: bool, control: Control) -> Answer: ...
def distance(a: Model, b: Model, control: Control) -> Answer: ...
def does_intersect(a: Model, b: Model, control: Control) -> Answer: ...
def check(model: Model, control: Control) -> Answer: ...
def info(model: Model, edges: bool, control: Control) -> Answer: ...
def continuity(
    model: Model, gap: float, angle: float, curvature: float, require: str, control: Control
) -> Answer: ...
def subdivide(
    model: Model,
    interval: List[float],
    rectangle: List[float],
    triangle: List[float],
    q: List[float],
    levels: int,
    control: Control,
) -> Answer: ...
def subdivide_whole(
    model: Model, interval: List[float], rectangle: List[float], control: Control
) -> Answer: ...
def convert(model: Model, to: str, control: Control) -> Answer: ...
def fill(
    model: Model,
    edges: List[int],
    continuity: List[str],
    layout: str,
    angle: float,
    sew: bool,
    control: Control,
) -> Answer: ...
def watertight(model: Model, control: Control) -> Answer: ...
def section(model: Model, point: Triple, normal: Triple, control: Control) -> Answer: ...
def sections(
    model: Model, planes: List[Tuple[Triple, Triple, str, Optional[float]]], control: Control
) -> Answer: ...
def clash(
    a: Model, b: Optional[Model], clearance: Optional[float], far: bool, control: Control
) -> Answer: ...
def mesh(
    model: Model, deviation: float, angle: float, edge_length: float, control: Control
) -> Answer: ...
def write_mesh(
    model: Model,
    deviation: float,
    angle: float,
    edge_length: float,
    path: str,
    text: bool,
    control: Control,
) -> None: ...
def write_triangles(
    vertices: NDArray[np.float64],
    triangles: NDArray[np.int32],
    groups: List[Tuple[str, int]],
    path: str,
    text: bool,
    control: Control,
) -> None: ...
def ray(
    model: Model, origin: Triple, direction: Triple, first: bool, line: bool, control: Control
) -> Answer: ...
def nearest(model: Model, at: Triple, all: bool, control: Control) -> Answer: ...
def trim(
    part: Model,
    tools: List[Model],
    planes: List[Tuple[Triple, Triple]],
    keep: str,
    control: Control,
) -> Answer: ...
def solid(
    operation: str,
    part: Model,
    tools: List[Model],
    planes: List[Tuple[Triple, Triple]],
    control: Control,
) -> Answer: ...
def strip(
    a: Model,
    b: Model,
    edge_a: str,
    edge_b: str,
    order: int,
    weight_a: float,
    weight_b: float,
    control: Control,
) -> Answer: ...
def fillet(
    part: Model,
    edges: List[int],
    kind: str,
    between: Optional[Tuple[int, int]],
    radius: float,
    law: str,
    section: str,
    partial: bool,
    control: Control,
) -> Answer: ...
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
) -> Answer: ...
