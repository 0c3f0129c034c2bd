# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is selected in the window, as links."""

import FreeCADGui

from . import links


def selected():
    """Pairs (object, name) through containers, in the order in which they were selected."""
    return [
        (each.Object, sub)
        for each in FreeCADGui.Selection.getSelectionEx("", 0)
        for sub in (each.SubElementNames or ("",))
    ]


def as_link(members):
    """Pairs as FreeCAD takes them."""
    return [(target, sub) for target, sub in members]


def dealt(members, count):
    """Members for so many links: what is of the first object goes to the first link and all other
    to the second; of one object alone, its first element."""
    if count == 1 or not members:
        return [members] + [[]] * (count - 1)
    first = _owner(members[0])
    own = [each for each in members if _owner(each) == first]
    others = [each for each in members if _owner(each) != first]
    if not others:
        own, others = own[:1], own[1:]
    return [own, others] + [[]] * (count - 2)


def _owner(member):
    target, sub = member
    return target, links.path_of(sub)
