# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two doors to the engine, and which of them is open here.

The Python package `blossom` shares memory with FreeCAD's Part, so both have to use the same Open
CASCADE. Where FreeCAD brings another one (AppImage, conda), that package must not be loaded, not
even to ask it; the program `blossom` works on files then, with the same questions and reports.
"""

import collections
import functools
import shutil

import FreeCAD
import Part

from . import built_with

# kind      "module", "program", or "" if there is neither
# reason    why not the module; or why nothing
Choice = collections.namedtuple("Choice", "kind reason program")


class NoEngine(RuntimeError):
    """Neither the package nor the program `blossom` can be used."""


@functools.lru_cache(maxsize=None)
def choice():
    """The door to use; it is looked for once."""
    reason = _why_no_module()
    if not reason:
        return Choice("module", "", "")
    program = shutil.which("blossom") or ""
    if program:
        return Choice("program", reason, program)
    return Choice("", f"{reason}; and there is no program 'blossom' on the PATH", "")


def _why_no_module():
    if built_with.OCCT and Part.OCC_VERSION != built_with.OCCT:
        return (
            f"FreeCAD uses Open CASCADE {Part.OCC_VERSION}, "
            f"the package blossom was built with {built_with.OCCT}"
        )
    try:
        import blossom  # noqa: F401
    except ImportError as error:
        return f"the package blossom cannot be imported: {error}"
    return ""


def opened():
    """A door for one question, that can be cancelled."""
    chosen = choice()
    if chosen.kind == "module":
        from .door_module import ModuleDoor

        return ModuleDoor()
    if chosen.kind == "program":
        _say_once(chosen)
        from .door_program import ProgramDoor

        return ProgramDoor(chosen.program)
    raise NoEngine(f"Blossom's engine is not here: {chosen.reason}")


@functools.lru_cache(maxsize=None)
def _say_once(chosen):
    FreeCAD.Console.PrintWarning(
        f"Blossom: {chosen.reason}; so the program {chosen.program} works on files, "
        "which is slower\n"
    )
