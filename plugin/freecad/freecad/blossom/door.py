# SPDX-License-Identifier: LGPL-2.1-or-later
"""The door to the engine, and where this works.

The Python package `blossom` shares memory with FreeCAD's Part, so both have to use the same Open
CASCADE. Where FreeCAD brings another one (AppImage, conda), the package asks the program `blossom`,
which works on files, with the same questions and reports.
"""

import collections
import functools

import FreeCAD
import Part  # noqa: F401 - its Open CASCADE is there before the package looks for one

# kind      "module", "program", or "" if there is neither
# reason    why not the module; or why nothing
Choice = collections.namedtuple("Choice", "kind reason program")


class NoEngine(RuntimeError):
    """Neither the package nor the program `blossom` can be used."""


@functools.lru_cache(maxsize=None)
def choice():
    """Where the engine works; it is looked for once."""
    try:
        import blossom
        from blossom import _engine
    except ImportError as error:
        return Choice("", f"the package blossom cannot be imported: {error}", "")
    reason, program = blossom.why_elsewhere(), _engine.program()
    if not reason:
        return Choice("module", "", "")
    if program:
        return Choice("program", reason, program)
    return Choice("", f"{reason}; and there is no program 'blossom' on the PATH", "")


def opened():
    """A door for one question, that can be cancelled."""
    chosen = choice()
    if not chosen.kind:
        raise NoEngine(f"Blossom's engine is not here: {chosen.reason}")
    if chosen.kind == "program":
        _say_once(chosen)
    from .door_package import PackageDoor

    return PackageDoor()


@functools.lru_cache(maxsize=None)
def _say_once(chosen):
    FreeCAD.Console.PrintWarning(
        f"Blossom: {chosen.reason}; so the program {chosen.program} works on files, "
        "which is slower\n"
    )
