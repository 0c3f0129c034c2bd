# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all answers have in common."""

import copy
import os
from dataclasses import dataclass, fields
from typing import (
    TYPE_CHECKING,
    Any,
    Callable,
    Dict,
    Iterator,
    List,
    Optional,
    Tuple,
    Type,
    TypeVar,
    Union,
)

import numpy as np
from numpy.typing import NDArray

from . import _checks, _core, _engine, _pictures, _shapes

if TYPE_CHECKING:
    from ._model import Model

Array = NDArray[np.float64]
Indices = NDArray[np.int32]
Report = Dict[str, Any]


class MadeShape(_pictures.Shown):
    """Something that has a shape to give away."""

    def _core_model(self) -> _core.Model:
        raise NotImplementedError

    @property
    def model(self) -> "Model":
        """The shape as a model, to go on asking: `drilled.model.fillet(...)`."""
        from ._model import Model  # which knows all answers

        return Model(self._core_model())

    def _passed_model(self) -> _core.Model:
        """What goes to other programs in memory."""
        return self._core_model()

    def _seen(self, control: _core.Control) -> _core.Answer:
        return _core.info(self._core_model(), False, True, control)

    def to_brep(self) -> bytes:
        """The shape as BRep text; where nothing was found, that of an empty compound."""
        return self._passed_model().brep()

    def to_part(self) -> Any:
        """The shape as one of FreeCAD's Part; where nothing was found, an empty compound."""
        return _shapes.part_shape(self._passed_model())

    def to_step(self, path: Union[str, "os.PathLike[str]"], **options: Any) -> None:
        """Writes the shape to a STEP file, with the names and colours that it has."""
        file = _checks.path(path, "path")
        if not file.lower().endswith((".step", ".stp")):
            raise ValueError(f"path: {file} does not end with .step or .stp; write() takes others")
        self.write(file, **options)

    def write(
        self,
        path: Union[str, "os.PathLike[str]"],
        *,
        deviation: Optional[float] = None,
        angle: Optional[float] = None,
        edge_length: Optional[float] = None,
        aspect: Optional[float] = None,
        text: bool = False,
        **options: Any,
    ) -> None:
        """Writes the shape to a file: .step, .iges, .brep; or its triangles: .stl, .ply, .obj, .off,
        .3mf, .glb. The file is there whole or not at all.

        deviation, angle, edge_length, aspect   of triangles, see `Model.mesh`
        text                                    .stl and .ply are not binary
        """
        file, control = _checks.shape_file(path, "path"), _checks.control(options)
        facets = _checks.facets(deviation, angle, edge_length, aspect)
        as_text = _checks.flag(text, "text")
        if _checks.is_of_triangles(file):
            _core.write_mesh(self._core_model(), *facets, file, as_text, control)
        elif as_text or any(each is not None for each in (deviation, angle, edge_length, aspect)):
            raise ValueError(f"path: {file} has no triangles, which these options are of")
        else:
            _shapes.write(self._core_model(), file, control)


class Result(MadeShape):
    """An answer. `to_dict()` is the report of the command line, `blossom ... --json`."""

    def __init__(self, answer: _core.Answer) -> None:
        self._answer: Optional[_core.Answer] = answer
        self._report: Optional[Report] = None
        self._records: Optional[Dict[str, Any]] = None
        self._model: Optional[_core.Model] = None
        self._lists: Dict[str, List[Any]] = {}

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            """Questions that only models answer are refused in words."""
            from ._model import Model

            kind = type(self).__name__
            if not name.startswith("_") and hasattr(Model, name):
                raise AttributeError(
                    f"{kind} is an answer and has no {name}; its shape has: answer.model.{name}"
                )
            raise AttributeError(f"'{kind}' object has no attribute '{name}'")

    def _told(self) -> Report:
        if self._report is None:
            assert self._answer is not None
            self._report = self._answer.report(True)
        return self._report

    def _made(self) -> Dict[str, Any]:
        if self._records is None:
            assert self._answer is not None
            self._records = self._answer.records()
        return self._records

    def _once(self, name: str, make: Callable[[], List[Any]]) -> List[Any]:
        """A list that is made when it is first asked for."""
        if name not in self._lists:
            self._lists[name] = make()
        return self._lists[name]

    def _model_or_none(self) -> Optional[_core.Model]:
        if self._model is None and self._answer is not None:
            self._model = self._answer.model()
        return self._model

    def _core_model(self) -> _core.Model:
        model = self._model_or_none()
        if model is None:
            raise _core.Error(
                f"{type(self).__name__}: there is no shape in this answer ({self._summary()})"
            )
        return model

    def _seen(self, control: _core.Control) -> _core.Answer:
        """The answer itself; its shape, of answers that say nothing more by a picture."""
        if self._answer is None:
            raise _core.Error("pictures are made of answers that were not pickled")
        return self._answer if self._answer.has_picture else super()._seen(control)

    def _has_found_nothing(self) -> bool:
        """Whether it is the answer, and not the lack of one, that there is no shape."""
        return False

    def _passed_model(self) -> _core.Model:
        if self._model_or_none() is None and self._has_found_nothing():
            return _core.nothing()
        return self._core_model()

    def to_dict(self, samples: bool = True) -> Report:
        """The report, as the command line writes it; yours to change.

        samples   with the points of curves, which are most of it
        """
        wanted = _checks.flag(samples, "samples")
        if self._answer is not None:
            return self._answer.report(wanted)
        told = copy.deepcopy(self._told())
        if not wanted:
            drop_samples(told)
        return told

    @property
    def status(self) -> str:
        """ "complete", "tolerance" or "stopped"."""
        return str(self._told()["status"])

    @property
    def reasons(self) -> List[str]:
        """Why the status is not "complete", in words, as far as they are known."""
        if self.status == "complete":
            return []
        found: Dict[str, None] = {}  # each once, in order
        _add_reasons(self._told(), found)
        return list(found)

    @property
    def seconds(self) -> float:
        """From the model in memory to the answer."""
        return float(self._told()["seconds"])

    def __getstate__(self) -> Dict[str, Any]:
        model = self._model_or_none()
        return {
            "report": self._told(),
            "records": self._made(),
            "model": None if model is None else _shapes.packed(model),
        }

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self._answer = None
        self._lists = {}
        self._report = state["report"]
        self._records = state["records"]
        made = state["model"]
        self._model = None if made is None else _shapes.unpacked(made, "unpickled")

    def _items(self) -> List[Any]:
        """What the answer is a list of."""
        raise NotImplementedError

    def __len__(self) -> int:
        return len(self._items())

    def __iter__(self) -> Iterator[Any]:
        return iter(self._items())

    def __getitem__(self, index: int) -> Any:
        return self._items()[index]

    def __bool__(self) -> bool:
        return True  # an empty answer is an answer

    def _summary(self) -> str:
        return self.status

    def __repr__(self) -> str:
        return f"<blossom.{type(self).__name__}: {self._summary()}>"


class Selective(Result):
    """An answer that may leave out some of what was asked for."""

    @property
    def refused(self) -> List[Dict[str, Any]]:
        """What is left out, and why."""
        return list(self._told()["refused"])

    @property
    def status(self) -> str:
        """ "complete", or "tolerance" if something is left out."""
        return "tolerance" if self.refused else "complete"


def _add_reasons(told: Any, found: Dict[str, None]) -> None:
    """What a report lists as left out, and all its certificates: one for each plane and part."""
    if isinstance(told, dict):
        found.update(dict.fromkeys((told.get("certificate") or {}).get("reasons", [])))
        found.update(dict.fromkeys(told.get("left_out", [])))
        for value in told.values():
            _add_reasons(value, found)
    elif isinstance(told, list) and told and isinstance(told[0], dict):
        for each in told:
            _add_reasons(each, found)


def drop_samples(told: Any) -> None:
    """As the compiled part does it."""
    if isinstance(told, dict):
        for curve in told.get("curves", []):
            for name in ("points", "uv_a", "uv_b"):
                curve.pop(name, None)
    for each in told.values() if isinstance(told, dict) else told:
        if isinstance(each, (dict, list)):
            drop_samples(each)


def counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


_Record = TypeVar("_Record", bound="Record")


class Record:
    """A part of an answer; its fields are compared by identity, since some are arrays."""

    @classmethod
    def of_members(cls: Type[_Record], members: Dict[str, Any]) -> _Record:
        """With those fields that are known: reports of the program lack some."""
        made = cls.__new__(cls)
        vars(made).update(members)
        return made

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            kind = type(self).__name__
            if name in (field.name for field in fields(self)):
                raise _core.Error(
                    f"{kind}.{name} is not in the program's report, and {_engine.why_elsewhere()}"
                )
            raise AttributeError(f"'{kind}' object has no attribute '{name}'")

    def __repr__(self) -> str:
        known = vars(self)
        told = [f"{each.name}={_shown(known[each.name])}" for each in fields(self) if each.name in known]
        return f"{type(self).__name__}({', '.join(told)})"


def _shown(value: Any) -> str:
    """Points with their numbers, longer arrays by their shape."""
    if isinstance(value, np.ndarray):
        is_point = value.ndim == 1 and 0 < len(value) <= 3
        return f"[{', '.join(f'{each:g}' for each in value)}]" if is_point else f"array{value.shape}"
    if isinstance(value, tuple) and any(isinstance(each, np.ndarray) for each in value):
        return f"({', '.join(map(_shown, value))})"
    return repr(value)


@dataclass(eq=False, repr=False)
class FoundCurve(Record):
    """A curve that was found.

    points            samples in order, (n, 3)
    conic             a dict if it is a line or a conic, as in the report
    degree, poles, weights, knots, multiplicities
                      the curve as a B-spline; weights are None where all are 1
    """

    points: Array
    closed: bool
    tangential: bool
    length: float
    conic: Optional[Dict[str, Any]]
    deviation_proven: bool
    degree: int
    poles: Array
    weights: Optional[Array]
    knots: Array
    multiplicities: Indices
