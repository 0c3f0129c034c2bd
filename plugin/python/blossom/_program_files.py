# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models that are files, and answers that are reports and files, of the program `blossom`."""

import json
import os
import re
import shutil
import tempfile
from typing import Any, Callable, Dict, List, NoReturn, Optional, Sequence, Tuple

from . import _engine, _program_records
from ._process import Control, Error, Folder, told

Words = List[str]
Change = Callable[[Dict[str, Any]], None]
_USUAL_TOLERANCE = 1e-7
_BREP_TEXT = re.compile(rb"\s*(DBRep_DrawableShape|CASCADE Topology V)")  # not binary
_NOTHING = b"""
CASCADE Topology V3, (c) Open Cascade
Locations 0
Curve2ds 0
Curves 0
Polygon3D 0
PolygonOnTriangulations 0
Surfaces 0
Triangulations 0

TShapes 1
Co

1100000
*

+1 0 """


def refuse(what: str) -> NoReturn:
    raise Error(f"{what} is not to be had of the program `blossom`, and {_engine.why_elsewhere()}")


class Model:
    """A file of ours, or what is named in it.

    name    what reports call it
    folder  stays while a model needs its file
    file    of the user's, which it is a copy of; empty of others
    words   what is named in it; empty for all of it
    """

    def __init__(self, path: str, name: str, folder: Folder, file: str = "", words: str = ""):
        self.path = path
        self.name = name
        self.folder = folder
        self.file = file
        self.words = words
        self._whole = self
        self.left_out: Dict[str, List[int]] = {}
        self._known: Optional[Dict[str, Any]] = None

    @property
    def input(self) -> str:
        return f"{self.path}#{self.words}" if self.words else self.path

    @property
    def names(self) -> Dict[str, str]:
        """What its input and its file are called."""
        return {self.input: self.name, self.path: self._whole.name}

    def _info(self) -> Dict[str, Any]:
        if self._known is None:
            self.know(asked(["info"], [self], None, ["--tree"], shape=""))
        assert self._known is not None
        return self._known

    def know(self, info: "Answer") -> None:
        """What the program tells of it."""
        self._known = info.report(True)

    @property
    def face_count(self) -> int:
        return len(self.numbers())

    @property
    def counts(self) -> Dict[str, int]:
        return dict(self._info()["counts"])

    @property
    def file_unit(self) -> str:
        return str(self._info()["file_unit"]) if self.file else ""

    @property
    def reading(self) -> Optional[Dict[str, Any]]:
        readings = self._info().get("reading")
        return dict(readings[0]) if readings else None

    def numbers(self) -> List[int]:
        return [int(face["number"]) for face in self._info()["faces"]]

    def face_names(self) -> List[str]:
        return [str(face["name"]) for face in self._whole._info()["faces"]]

    def part_paths(self) -> List[str]:
        paths = [""] * len(self.face_names())
        parts = list(self._whole._info().get("tree", []))
        while parts:
            part = parts.pop()
            parts += part["parts"]
            for face in part["faces"]:
                paths[face - 1] = str(part["path"])
        return paths

    def repairs(self) -> Dict[str, Any]:
        report = asked(["query", "mass"], [self], None, shape="").report(True)
        return dict(report["repairs"][0])

    def part(self, numbers: List[int], words: List[str], name: str) -> "Model":
        count = self._whole.counts["faces"]
        if numbers and max(numbers) > count:
            raise ValueError(f"{name}: there is no face {max(numbers)} in it, it has {count}")
        chosen = ",".join([*map(str, numbers), *words])
        made = Model(self.path, name, self.folder, self.file, chosen)
        made._whole = self._whole
        if words:
            made._info()  # which tells whether they name anything
        return made

    def words_in(self, listed: str) -> List[str]:
        return listed.split(",")

    def usable_part(self, control: Control) -> Optional["Model"]:
        return None  # the program leaves out by itself what is of no use

    def brep(self) -> bytes:
        if not self.words and not self.file:
            data = _bytes_of(self.path)
            if _BREP_TEXT.match(data):
                return data
        folder = Folder()
        made = folder.file("model.brep")
        asked(["convert"], [self], None, ["--sew-gap=0"], made)
        return _bytes_of(made)

    def swig(self) -> None:
        return None

    def write(self, path: str, control: Control) -> List[str]:
        asked(["convert"], [self], control, shape=os.path.abspath(path))
        return []


def _bytes_of(path: str) -> bytes:
    with open(path, "rb") as stream:
        return stream.read()


class Triangles:
    """A mesh: what can be done with it here is to write it."""

    def __init__(self, vertices: Any, triangles: Any, groups: List[Any]) -> None:
        self.vertices, self.triangles, self.groups = vertices, triangles, groups


class Answer:
    """A report, and files that are made when they are asked for, if they are not there yet."""

    def __init__(
        self,
        command: Words,
        models: Sequence[Model],
        control: Optional[Control],
        needed: Optional[Folder],
    ) -> None:
        self._command = command
        self._models = list(models)
        self._control = control
        self._needed = needed
        self._folder = Folder()
        self._name = ""
        self._report = ""
        self._files: Dict[str, str] = {}
        self._change: Change = lambda report: None

    def ask(self, shape: str, name: str, change: Optional[Change]) -> None:
        """shape   the ending of a file to be made, or a whole name; empty for none"""
        self._name = name
        self._change = change or self._change
        self._report = self._run(shape)

    def _run(self, shape: str, more: Sequence[str] = ()) -> str:
        output = list(more)
        if shape:
            made = shape if os.sep in shape else self._folder.file(f"{self._name}.{shape}")
            self._files[shape] = made
            output += ["-o", made]
        names = {file: name for model in self._models for file, name in model.names.items()}
        names.update(self._needed.names() if self._needed else {})
        text = told([*self._command, *output], names, self._folder, self._control)
        for file, called in names.items():
            text = text.replace(json.dumps(file)[1:-1], json.dumps(called)[1:-1])
        return text

    def made(self, ending: str) -> str:
        """The file with this ending; empty if there is none."""
        if ending not in self._files:
            self._run(ending)
        file = self._files[ending]
        return file if os.path.exists(file) else ""

    def report(self, samples: bool) -> Dict[str, Any]:
        from ._results import drop_samples

        report: Dict[str, Any] = json.loads(self._report)
        if "written" in report:
            report["written"] = False  # in a file of the user's
        if "output" in report:
            report["output"] = None
            report.update({"lost": []} if "lost" in report else {})  # in that file
        if "reading" in report:
            read = {each["file"]: each for each in report.pop("reading")}
            files = dict.fromkeys(model.file for model in self._models)  # each once, in order
            kept = [read[file] for file in files if file in read]
            report.update({"reading": kept} if kept else {})
        self._change(report)
        if not samples:
            drop_samples(report)
        return report

    def model(self) -> Optional[Model]:
        for ending in ("brep", "step"):
            if ending in self._files:
                file = self.made(ending)
                if file:
                    return Model(file, self._name, self._folder)
                return nothing() if self._name in ("intersection", "section") else None
        return None

    def records(self) -> Dict[str, Any]:
        return _program_records.of(self._command, self.report(True), self.made)

    @property
    def has_picture(self) -> bool:
        return self._command[0] in _DRAWN or self._command[:2] == ["query", "plane"]

    def show(
        self,
        file: str,
        form: str,
        view: str,
        size: Tuple[int, int],
        zebra: bool,
        control: Control,
    ) -> List[str]:
        """By the same command once more. What is to be said of the picture is a warning by then."""
        made = self._folder.file(f"seen.{form}")
        if os.path.exists(made):
            os.remove(made)
        option = "--picture" if form == "png" else f"--{form}"
        options = [option, made, f"--size={size[0]}x{size[1]}"]
        options += [f"--view={view}"] if view else []
        self._control = control
        self._run("", options + (["--zebra"] if zebra else []))
        if not os.path.exists(made):
            raise Error(f"{file}: there is nothing to see in this answer")
        _put(made, file)
        return []

    def draw(self, file: str, control: Control) -> None:
        self._control = control
        made = self.made(os.path.splitext(file)[1].lower().lstrip("."))
        if not made:
            raise Error(f"{file}: there is nothing to draw, since no plane meets the model")
        _put(made, file)


def _put(made: str, file: str) -> None:
    """Copies it, whole or not at all."""
    folder = os.path.dirname(os.path.abspath(file))
    try:
        with tempfile.TemporaryDirectory(dir=folder, prefix=".blossom-") as beside:
            copy = shutil.copyfile(made, os.path.join(beside, "copy"))
            os.replace(copy, file)
    except FileNotFoundError:
        raise Error(f"{file}: the folder '{folder}' does not exist, or takes no file") from None
    except OSError as error:
        raise Error(f"{file}: cannot be written: {error.strerror or error}") from None


# Commands whose answers are shown.
_DRAWN = ("intersect", "self-intersect", "trim", "subdivide", "info", "check", "clash", "blend")
# What commands take of the options that all questions have in common.
_ALL = ("tolerance", "budget", "threads")
_TAKEN = {
    "intersect": _ALL, "self-intersect": _ALL, "trim": _ALL, "clash": _ALL, "query plane": _ALL,
    "blend fillet": _ALL, "blend chamfer": _ALL, "convert": ("tolerance",),
    "query ray": ("tolerance",), "query point": ("tolerance", "budget"),
    "query distance": ("tolerance", "budget"), "query does-intersect": ("tolerance", "budget"),
    "blend fill": ("tolerance",),
}  # fmt: skip


def _limits(command: Words, control: Optional[Control]) -> Words:
    if control is None:
        return []
    if control.form != "auto":
        refuse(f"form '{control.form}'")
    taken = _TAKEN.get(" ".join(command[:2]), _TAKEN.get(command[0], ()))
    made = [f"--time-limit={control.time_limit!r}"] if control.time_limit else []
    if control.tolerance != _USUAL_TOLERANCE and "tolerance" in taken:
        made.append(f"--tolerance={control.tolerance!r}")
    if control.budget is not None and "budget" in taken:
        made.append(f"--budget={control.budget}")
    if control.threads and "threads" in taken:
        made.append(f"--threads={control.threads}")
    return made


def asked(
    command: Words,
    models: Sequence[Model],
    control: Optional[Control],
    options: Sequence[str] = (),
    shape: Optional[str] = None,
    name: str = "",
    change: Optional[Change] = None,
    needed: Optional[Folder] = None,
) -> Answer:
    """shape   as of `Answer.ask`; None is BREP, or STEP where there are names to keep
    needed  has files that options name
    """
    if shape is None:
        named = any(not model.path.endswith(".brep") for model in models)
        shape = "step" if named else "brep"
    inputs = [model.input for model in models]
    answer = Answer([*command, *inputs, *options, *_limits(command, control)], models, control, needed)
    answer.ask(shape, name or command[-1], change)
    return answer


def of_bytes(data: bytes, name: str, ending: str) -> Model:
    folder = Folder()
    file = folder.file(f"{name}{ending}")
    try:
        with open(file, "wb") as stream:
            stream.write(data)
    except OSError as error:
        room = os.path.dirname(folder.path)
        raise OSError(f"{name}: the folder of temporary files, {room}: {error.strerror}") from None
    return Model(file, name, folder)


def nothing() -> Model:
    return of_bytes(_NOTHING, "nothing", ".brep")
