# SPDX-License-Identifier: LGPL-2.1-or-later
"""All kinds of objects, in the order of the toolbar."""

from .chamfer import Chamfer
from .check import Check
from .clash import Clash
from .fill import Fill
from .fillet import Fillet
from .intersection import Intersection
from .mesh import Mesh
from .section import Section
from .solid import Solid
from .strip import Strip
from .subpatch import SubPatch
from .trim import Trim

KINDS = (
    Intersection, Section, Trim, Solid, Strip, Fillet, Chamfer, Fill, SubPatch, Mesh, Check, Clash,
)  # fmt: skip
