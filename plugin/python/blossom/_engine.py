# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the engine works: in this process, or the program `blossom` in one of its own.

Two copies of Open CASCADE in a process have the same symbols and other layouts: which of them a call
reaches is up to the order in which they were loaded. Where another one than ours is loaded already,
as by an AppImage of FreeCAD, OCP or pythonOCC, the compiled part is left alone, and `_program`, which
asks the program over files, takes its place.
"""

import functools
import importlib
import os
import re
import shutil
import sys
from typing import List

from . import _built_with

_KERNEL = re.compile(r"(lib)?TKernel\b[^/]*")


def loaded_kernels() -> List[str]:
    """The copies of Open CASCADE in this process, by their innermost library."""
    try:
        with open("/proc/self/maps", encoding="utf-8", errors="surrogateescape") as maps:
            fields = [line.rstrip("\n").split(maxsplit=5) for line in maps]
    except OSError:
        return []
    files = {each[5] for each in fields if len(each) == 6}
    return sorted(file for file in files if _KERNEL.fullmatch(os.path.basename(file)))


def other_kernels() -> List[str]:
    """Those that are not the one that the compiled part is linked with."""
    return [file for file in loaded_kernels() if not _is_ours(file)]


def _is_ours(kernel: str) -> bool:
    if os.path.exists(_built_with.KERNEL):
        return os.path.realpath(kernel) == os.path.realpath(_built_with.KERNEL)
    return os.path.basename(kernel).endswith(f".so.{_built_with.OCCT}")


@functools.lru_cache(maxsize=None)
def why_elsewhere() -> str:
    """Why the engine does not work in this process, but the program `blossom` in one of its own; empty
    if it does. It is looked at once, when the package is imported."""
    others = [] if _compiled() in sys.modules else other_kernels()
    if others:
        return f"this process has loaded another Open CASCADE than Blossom's, {others[0]}"
    version = getattr(sys.modules.get("Part"), "OCC_VERSION", _built_with.OCCT)
    if version != _built_with.OCCT:  # also where a system does not tell what is loaded
        return f"FreeCAD uses Open CASCADE {version}, Blossom is built with {_built_with.OCCT}"
    try:
        importlib.import_module(_compiled())
    except ImportError as error:
        return f"the engine cannot be loaded into this process ({error})"
    return ""


def program() -> str:
    """The program that works instead; empty if there is none."""
    return os.environ.get("BLOSSOM_PROGRAM") or shutil.which("blossom") or ""


def choose() -> None:
    """Gives the package the part that is to be asked, under the name of the compiled one."""
    if why_elsewhere():
        stand_in = importlib.import_module(f"{__package__}._program")
        sys.modules[_compiled()] = stand_in
        setattr(sys.modules[str(__package__)], "_core", stand_in)


def _compiled() -> str:
    return f"{__package__}._core"
