# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the door to the engine gives, and what it is made with."""

import collections

import FreeCAD

# shape     Part's
# report    what the command line writes with --json
Answer = collections.namedtuple("Answer", "shape report")

LATER = 10  # how far work is behind the window, in the system's priorities


def niceness():
    """How far work gives way to this process's other threads: a window's goes before it. Only the
    engine's own threads do. One that gave way while it has Python's lock would keep the window
    waiting for as long as other programs keep it waiting."""
    return LATER if FreeCAD.GuiUp else 0


def with_segments(mesh, groups):
    """A mesh of FreeCAD with a segment for each face. (Its documents do not keep them; that is what
    FirstTriangles of `mesh.py` is for.)"""
    firsts = [first for _, first in groups] + [mesh.CountFacets]
    for first, end in zip(firsts, firsts[1:]):
        mesh.addSegment(list(range(first, end)))
    return mesh
