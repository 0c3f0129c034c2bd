# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program `blossom`, each in a process and with files of its own."""

import functools
import os
import re
import shutil
import subprocess
import tempfile
import time
import weakref
from dataclasses import dataclass
from typing import Callable, Dict, List, Optional, Sequence

from . import _engine

_DONE = (0, 3)  # complete, within tolerance
_ANSWERED = (*_DONE, 4, 5)  # stopped, findings
# What reading lost is warned of when a model is read, and is in `Model.reading`.
_OF_READING = re.compile(r": (SHAPES ARE MISSING OR WRONG in|read without) \d+ ")
_PAUSE = 0.02  # seconds between looks whether the work is cancelled


class Error(RuntimeError):
    """A failure of the engine."""


class Cancelled(Error):
    """The work was ended by a `Cancel`."""


class Cancel:
    """Ends work, from any thread."""

    def __init__(self) -> None:
        self.cancelled = False

    def cancel(self) -> None:
        self.cancelled = True


@dataclass
class Control:
    """The options that all questions have in common."""

    tolerance: float
    form: str
    time_limit: float
    budget: Optional[int]
    threads: int
    nice: int
    cancel: Optional[Cancel]
    progress: Optional[Callable[[float], object]]


class Folder:
    """A folder that goes away with what holds it."""

    def __init__(self) -> None:
        self.path = tempfile.mkdtemp(prefix="blossom-")
        weakref.finalize(self, shutil.rmtree, self.path, True)

    def names(self) -> Dict[str, str]:
        """What its files are called: as the arguments that they are made of."""
        return {self.file(each): os.path.splitext(each)[0] for each in os.listdir(self.path)}

    def file(self, name: str) -> str:
        return os.path.join(self.path, name.replace(os.sep, "_").replace("\0", "_")[-200:])


def told(
    command: Sequence[str], names: Dict[str, str], folder: Folder, control: Optional[Control]
) -> str:
    """The report of a command, as JSON.

    names   what files of ours are called in messages
    folder  where the report may lie, and what else we alone want written
    """
    program = _program()
    report, errors = folder.file("report.json"), folder.file("errors.txt")
    if os.path.exists(report):
        os.remove(report)
    with open(errors, "w", encoding="utf-8") as stream:
        with subprocess.Popen(
            [program, *command, "--json", report],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=stream, env=_environment(),
        ) as process:  # fmt: skip
            code = _ended(process, control)
    text = _text_of(report) if os.path.exists(report) else ""
    said = _notes(_text_of(errors), names)
    if not text and code not in _ANSWERED:
        words = said[-1] if said else f"{program} {command[0]} ended with {code}"
        raise ValueError(words) if code == 2 else Error(words)
    if code in _DONE:
        for note in said:
            if not note.startswith(folder.path) and not _OF_READING.search(note):
                _warn(note)
    return text


def _text_of(file: str) -> str:
    with open(file, encoding="utf-8", errors="replace") as stream:
        return stream.read()


def _warn(text: str) -> None:
    from ._shapes import warn  # which asks this module

    warn(text)


def _program() -> str:
    program = _engine.program()
    if not program:
        raise Error(f"{_engine.why_elsewhere()}, and there is no program 'blossom' on the PATH")
    _say_once(program)
    return program


@functools.lru_cache(maxsize=None)
def _say_once(program: str) -> None:
    _warn(f"{_engine.why_elsewhere()}: {program} answers, in processes of its own and over files")


def _environment() -> Dict[str, str]:
    """Ours, without the folders in which the program would find the other Open CASCADE."""
    made = dict(os.environ)
    others = {os.path.realpath(os.path.dirname(file)) for file in _engine.other_kernels()}
    listed = made.pop("LD_LIBRARY_PATH", "").split(os.pathsep)
    kept = [folder for folder in listed if folder and os.path.realpath(folder) not in others]
    return {**made, "LD_LIBRARY_PATH": os.pathsep.join(kept)} if kept else made


def _ended(process: "subprocess.Popen[bytes]", control: Optional[Control]) -> int:
    start = time.monotonic()
    _give_way(process.pid, control.nice if control else 0)
    try:
        while True:
            try:
                return process.wait(_PAUSE)
            except subprocess.TimeoutExpired:
                if control and control.cancel and control.cancel.cancelled:
                    raise Cancelled("the work was cancelled") from None
                if control and control.progress:
                    control.progress(time.monotonic() - start)
    except BaseException:
        process.terminate()
        process.wait()
        raise


def _give_way(pid: int, nice: int) -> None:
    """(Where a system has priorities; it is no harm if that is not to be had.)"""
    try:
        if nice:
            os.setpriority(os.PRIO_PROCESS, pid, os.getpriority(os.PRIO_PROCESS, 0) + nice)
    except (AttributeError, OSError):
        pass


def _notes(said: str, names: Dict[str, str]) -> List[str]:
    """What the program says on stderr, as if it were about shapes and arguments."""
    for file, name in names.items():
        said = said.replace(file, name)
    said = re.sub(r"(?<!\S)--([a-z][a-z-]*)", lambda option: option[1].replace("-", "_"), said)
    lines = [line for line in said.splitlines() if not line.startswith("see 'blossom ")]
    notes = re.split(r"^blossom: ", "\n".join(lines), flags=re.MULTILINE)
    return [note.strip() for note in notes if note.strip()]
