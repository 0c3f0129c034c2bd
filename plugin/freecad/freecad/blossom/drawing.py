# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections as drawings, .dxf and .svg: lines, circles and arcs in the coordinates of their planes.

    from freecad.blossom import drawing
    drawing.write(document.Section, "cuts.dxf")

FreeCAD's File > Export calls `export`.
"""

from . import links, work
from .section import Section

DOING = "Drawing"


def export(objects, filename):
    """Writes the section that is among what is selected. throws ValueError, RuntimeError"""
    sections = [each for each in objects if is_section(each)]
    if len(sections) != 1:
        there = "there is none" if not sections else f"there are {len(sections)}"
        raise ValueError(f"a drawing is of one object Section of Blossom, and {there}")
    write(sections[0], filename)


def write(obj, file):
    """Writes what the object's choices say now. throws ValueError, RuntimeError"""
    if not is_section(obj):
        raise ValueError(f"{getattr(obj, 'Label', obj)}: is no Section of Blossom, which drawings are of")
    if not file.lower().endswith((".dxf", ".svg")):
        raise ValueError(f"{file}: does not end with .dxf or .svg")

    def draw(entrance, inputs, options):
        planes = obj.Proxy.planes(options)
        entrance.draw_sections(inputs["Part"], planes, file, tolerance=options["tolerance"])

    work.answer_of(obj.Proxy.question(obj).job(draw), DOING)


def is_section(obj):
    return links.has(obj, "Proxy") and isinstance(obj.Proxy, Section)
