# SPDX-License-Identifier: LGPL-2.1-or-later
"""All kinds of objects, in the order of the toolbar."""

from .check import Check
from .fill import Fill
from .fillet import Fillet
from .intersection import Intersection
from .section import Section
from .solid import Solid
from .strip import Strip
from .subpatch import SubPatch
from .trim import Trim

KINDS = (Intersection, Section, Trim, Solid, Strip, Fillet, Fill, SubPatch, Check)
