# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every kind of object of the workbench, without a window: what it computes, against figures that
follow by hand or from FreeCAD's own Part."""

import math
import os
import sys
import tempfile

import FreeCAD
import Part

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from claims import claim, distance, near, run, samples, says, valid  # noqa: E402
from freecad.blossom import drawing, make  # noqa: E402

V = FreeCAD.Vector


def shaped(document, name, shape):
    obj = document.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj


def box(document, name="Box", size=(10, 10, 10), at=(0, 0, 0)):
    return shaped(document, name, Part.makeBox(*size, V(*at)))


def wavy(document, name, height):
    """A B-spline face through points of a wave, 0 <= x, y <= 10."""
    points = [[V(x, y, height(x, y)) for y in range(11)] for x in range(11)]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return shaped(document, name, surface.toShape())


def intersection_of_edges_has_their_points(document):
    block = box(document)
    line = shaped(document, "Line", Part.makeLine(V(5, 5, -5), V(5, 5, 20)))
    crossing = make.intersection(document, line, block)
    along = make.intersection(document, (block, "Edge1"), (block, "Face1"))
    document.recompute()
    claim("a line crosses a box in two points", (crossing.Status, crossing.Points) == ("complete", 2))
    claim(
        "which are its vertices",
        sorted(tuple(v.Point) for v in crossing.Shape.Vertexes) == [(5, 5, 0), (5, 5, 10)],
    )
    claim("an edge of a face lies on it", valid(along) and near(along.Length, 10))


def intersection_is_where_containers_have_put_the_faces(document):
    sea = wavy(document, "Sea", lambda x, y: math.sin(0.6 * x) * math.cos(0.5 * y))
    sail = wavy(document, "Sail", lambda x, y: 0.2 * (x - 5) + 0.3 * math.sin(y))
    boat = document.addObject("App::Part", "Boat")
    boat.addObject(sail)
    boat.Placement = FreeCAD.Placement(V(0, 2.5, 0.5), FreeCAD.Rotation(V(0, 0, 1), 30))
    curves = make.intersection(document, (sea, "Face1"), (boat, "Sail.Face1"))
    document.recompute()

    def placed_right():
        placed = sail.Shape.copy()
        placed.Placement = boat.Placement.multiply(placed.Placement)
        points = samples(curves.Shape)
        return points and all(
            distance(face, point) < 1e-6 for face in (sea.Shape, placed) for point in points
        )

    claim(
        "there are curves, and none is missing",
        (valid(curves), curves.Status) == (True, "complete"),
    )
    claim("they lie on both faces, where these are shown", placed_right())
    claim(
        "facts are those of the shape",
        curves.Curves >= 1 and near(curves.Length, curves.Shape.Length, 1e-4),
    )
    claim("the deviation is told", 0 < curves.Deviation < 1e-6)
    before = curves.Length
    boat.Placement.Base = V(0.5, 2, 0.25)
    document.recompute()
    claim("a move of the container moves them", curves.Length != before and placed_right())
    bounds = curves.Shape.BoundBox
    curves.Placement.Base = V(0, 0, 100)
    document.recompute()
    claim(
        "a move of their own is kept, too",
        near(curves.Shape.BoundBox.ZMin, bounds.ZMin + 100, 1e-4),
    )
    wet = document.addObject("App::Part", "Wet")
    wet.Placement.Base = V(0, 50, 0)
    curves.Placement.Base = V(0, 0, 0)
    wet.addObject(curves)
    curves.touch()
    document.recompute()
    shown = Part.getShape(wet, "Intersection.")
    low = shown.BoundBox.YMin, curves.Shape.BoundBox.YMin + 50
    claim(
        "in a container of their own they stay there",
        all(near(y, bounds.YMin, 1e-4) for y in low),
    )


def intersection_that_is_empty_is_an_answer(document):
    curves = make.intersection(document, box(document), box(document, "Far", at=(50, 0, 0)))
    document.recompute()
    claim(
        "nothing is found, for certain",
        (valid(curves), curves.Status, curves.Curves) == (True, "complete", 0),
    )
    claim("it has no shape that a window would complain of", curves.Shape.isNull())
    curves.B[0][0].Shape = Part.makeBox(10, 10, 10, V(5, 5, 5))
    document.recompute()
    claim("it gets one", valid(curves) and len(curves.Shape.Edges) == curves.Curves > 0)


def section_has_closed_wires(document):
    tube = Part.makeCylinder(4, 20).cut(Part.makeCylinder(3, 20))
    tube = shaped(document, "Tube", tube)
    cut = make.section(document, tube, Point=V(0, 0, 5), Count=4, Spacing="2.5 mm")
    document.recompute()
    claim("each plane cuts two circles", list(cut.WiresOfPlanes) == [2, 2, 2, 2])
    claim(
        "which are closed wires",
        cut.Closed == 8 and [wire.isClosed() for wire in cut.Shape.Wires] == [True] * 8,
    )
    claim(
        "as long as by hand",
        near(cut.Length, 4 * 2 * math.pi * 7) and near(cut.Shape.Length, cut.Length),
    )
    claim("enclosing as much as by hand", near(cut.Area, 4 * math.pi * 7))
    claim(
        "at their heights",
        sorted({round(v.Z, 9) for v in cut.Shape.Vertexes}) == [5, 7.5, 10, 12.5],
    )
    cut.Count = 0
    document.recompute()
    claim("no plane is an error", says(cut, "Count: 1 to 10000 planes are wanted, got 0"))
    cut.Count, cut.Normal = 1, V(0, 0, 0)
    document.recompute()
    claim("no normal is an error", says(cut, "Normal: the zero vector has no direction"))


def sections_are_exported_as_drawings(document):
    tube = Part.makeCylinder(4, 20).cut(Part.makeCylinder(3, 20))
    cut = make.section(document, shaped(document, "Tube", tube), Point=V(0, 0, 5), Count=2)
    document.recompute()
    claim("FreeCAD knows the kind of file", "freecad.blossom.drawing" in FreeCAD.getExportType("dxf"))
    with tempfile.TemporaryDirectory() as folder:
        for name, words in (("cut.dxf", "CIRCLE\n"), ("cut.svg", "url(#hatch-1)")):
            file = os.path.join(folder, name)
            drawing.export([cut], file)
            with open(file, encoding="utf-8") as text:
                claim(f"{name} has both planes", text.read().count(words) in (4, 2))
        cut.Point = V(0, 0, 50)
        for objects, file, message in (
            ([document.Tube], "x.dxf", "one object Section of Blossom, and there is none"),
            ([cut, cut], "x.dxf", "there are 2"),
            ([cut], "x.txt", "x.txt: does not end with .dxf or .svg"),
            ([cut], os.path.join(folder, "far.dxf"), "nothing to draw, since no plane meets"),
        ):
            try:
                drawing.export(objects, file)
                claim(f"{file} was written", False)
            except (ValueError, RuntimeError) as error:
                claim(f"it is said: {error}", message in str(error))


def section_follows_a_plane(document):
    block, knife = box(document), document.addObject("Part::Plane", "Knife")
    knife.Placement.Base = V(0, 0, 3)
    holder = document.addObject("App::Part", "Holder")
    holder.addObject(knife)
    cut = make.section(document, block, (holder, "Knife.Face1"))
    document.recompute()
    claim(
        "it is in the plane of the face",
        near(cut.Shape.BoundBox.ZMax, 3) and near(cut.Length, 40),
    )
    holder.Placement.Base = V(0, 0, 2)
    document.recompute()
    claim("and follows it in its container", near(cut.Shape.BoundBox.ZMin, 5))
    cut.Plane = [(holder, "")]
    document.recompute()
    claim("an object's own plane serves, too", near(cut.Shape.BoundBox.ZMin, 2))
    copy = document.addObject("App::Link", "Copy")
    copy.LinkedObject, copy.Placement.Base = holder, V(0, 0, 4)
    for member, height in (("Knife.", 7), ("Knife.Face1", 7), ("", 4)):
        cut.Plane = [(copy, member)]
        document.recompute()
        claim(f"and where a link shows it: {member}", near(cut.Shape.BoundBox.ZMin, height))
    ball = shaped(document, "Ball", Part.makeSphere(3))
    cut.Plane = [(ball, "Face1")]
    document.recompute()
    claim("a face that is not flat is none", says(cut, "Plane: Ball.Face1 is not flat"))


def trim_keeps_sides_and_picked_pieces(document):
    sheet = shaped(document, "Sheet", Part.makePlane(10, 10, V(-5, -5, 0)))
    rod = shaped(document, "Rod", Part.makeCylinder(2, 10, V(0, 0, -5)))
    trimmed = make.trim(document, (sheet, "Face1"), rod)
    document.recompute()
    claim(
        "all pieces are there",
        (trimmed.Pieces, len(trimmed.Shape.Faces), trimmed.Status) == (2, 2, "complete"),
    )
    trimmed.Keep = "inside"
    document.recompute()
    claim(
        "the disc is inside",
        near(trimmed.Area, math.pi * 4) and near(trimmed.Shape.Area, trimmed.Area),
    )
    trimmed.Keep = "picked"
    document.recompute()
    claim("nothing picked is an error", says(trimmed, "Picked: click a piece"))
    trimmed.Picked = [V(4, 4, 0)]
    document.recompute()
    claim("the piece round the hole was picked", near(trimmed.Area, 100 - math.pi * 4))
    sheet.Shape = Part.makePlane(20, 10, V(-5, -5, 0))
    document.recompute()
    claim("it stays that piece when the sheet changes", near(trimmed.Area, 200 - math.pi * 4))
    trimmed.Picked = [V(4, 4, 0), V(0, 0, 0)]
    document.recompute()
    claim("two pieces can be picked", near(trimmed.Area, 200))
    trimmed.Tools = []
    document.recompute()
    claim("no tool is an error", says(trimmed, "Tools: something that cuts is wanted"))


def solids_add_up(document):
    block, rod = box(document), shaped(document, "Rod", Part.makeCylinder(2, 20, V(5, 5, -5)))
    made = make.solid(document, "cut", block, rod)
    document.recompute()
    bore = math.pi * 4 * 10
    claim("cut", (made.Solids, made.Status) == (1, "complete") and near(made.Volume, 1000 - bore))
    claim("it is a valid solid", made.Shape.isValid() and near(made.Shape.Volume, made.Volume))
    for operation, volume in (("common", bore), ("fuse", 1000 + bore), ("split", 1000)):
        made.Operation = operation
        document.recompute()
        claim(operation, valid(made) and near(made.Volume, volume))
    claim("of what is cut nothing is noted", list(made.Notes) == [])
    rod.Placement.Base = V(100, 0, 0)
    made.Operation = "cut"
    document.recompute()
    claim("that nothing is cut is noted", valid(made) and "nothing is cut" in made.Notes[0])
    made.Operation = "common"
    document.recompute()
    claim("nothing in common is an error that says so", says(made, "the result of common is empty"))
    rod.Placement.Base = V()
    made.Part, made.Operation = [(block, "Face6")], "cut"
    document.recompute()
    claim("a face is cut as a sheet", near(made.Area, 100 - math.pi * 4) and made.Volume == 0)
    made.Operation = "fuse"
    document.recompute()
    claim("a face is no solid to be fused with", says(made, "is no closed solid"))


def check_colours_what_is_wrong(document):
    faces = Part.makeBox(10, 10, 10).Faces[:5]
    checked = make.check(document, box(document))
    opened = make.check(document, shaped(document, "Open", Part.makeShell(faces)))
    document.recompute()
    claim("a box is sound", (checked.Verdict, list(checked.Problems)) == ("sound", []))
    claim("all faces have the colour of sound ones", len(set(checked.Proxy.colours(checked))) == 1)
    claim("four edges are open", opened.OpenEdges == 4)
    crossed = Part.makePolygon([V(0, 0, 0), V(10, 10, 0), V(10, 0, 0), V(0, 10, 0), V(0, 0, 0)])
    faulty = make.check(document, shaped(document, "Bow", Part.Face(Part.Plane(), crossed)))
    document.recompute()
    claim("a face whose border crosses itself is not sound", faulty.Verdict == "not sound")
    claim("the table names the face", any(each.startswith("Face1: ") for each in faulty.Problems))
    claim("and it is graded so", list(faulty.Grades) == [2])


def strip_joins_faces(document):
    near_one = shaped(document, "Near", Part.makePlane(10, 10))
    far_one = shaped(document, "Far", Part.makePlane(10, 10, V(20, 0, 5)))
    strip = make.blend_strip(document, (near_one, "Face1"), (far_one, "Face1"))
    document.recompute()
    claim("the nearest borders are joined", strip.Joined == "umax to umin")
    claim("exactly", strip.Gap < 1e-12 and strip.Angle < 1e-12)
    claim(
        "it fills the gap",
        near(strip.Shape.BoundBox.XMin, 10) and near(strip.Shape.BoundBox.XMax, 20),
    )
    area = strip.Shape.Area
    strip.WeightA, strip.BorderB = 2.0, "umin"
    document.recompute()
    claim("weights change it", valid(strip) and strip.Shape.Area != area)
    strip.A, strip.Continuity = [(near_one, ("Face1", "Edge1"))], "G2"
    document.recompute()
    claim("an edge may be picked", strip.Joined.startswith("edge 1 to "))
    strip.A = [(near_one, ("Face1",)), (far_one, ("Edge1",))]
    document.recompute()
    claim("it has to be one of the face", says(strip, "is no edge of the face"))
    strip.A = [(box(document), "")]
    document.recompute()
    claim("six faces are not one", says(strip, "A: one face is wanted, there are 6"))


def sub_patch_is_the_surface_there(document):
    hill = wavy(document, "Hill", lambda x, y: math.sin(0.6 * x) * math.cos(0.5 * y))
    patch = make.sub_patch(document, (hill, "Face1"), UFrom=0.25, UTo=0.5, VTo=0.75)
    document.recompute()
    surface = hill.Shape.Faces[0].Surface
    u0, u1, v0, v1 = hill.Shape.Faces[0].ParameterRange
    wanted = surface.value(u0 + 0.25 * (u1 - u0), v0 + 0.75 * (v1 - v0))
    claim("a corner is where it was wanted", distance(patch.Shape, wanted) < 1e-9)
    off = max(distance(hill.Shape, point) for point in samples(patch.Shape, 3))
    claim("all of it is on the face", off < 1e-9)
    claim("pieces are bicubic", list(patch.Degrees) == ["3 x 3"] and patch.Deviation == 0)
    count = patch.Pieces
    patch.Levels = 1
    document.recompute()
    claim("halving makes four of each", patch.Pieces == 4 * count == len(patch.Shape.Faces))
    patch.UTo = 0.1
    document.recompute()
    claim("an empty part is an error", says(patch, "UFrom, UTo: 0 <= from < to <= 1 is wanted"))


def fill_closes_holes(document):
    faces = Part.makeBox(10, 10, 10).Faces[:5]
    cup = shaped(document, "Cup", Part.makeShell(faces))
    filled = make.fill(document, cup, Continuity="G0")
    document.recompute()
    claim("one hole is filled", valid(filled) and filled.Holes == 1)
    claim("with patches", len(filled.Shape.Faces) == filled.Patches > 0)
    claim("flat, as its edges are", near(filled.Shape.Area, 100) and filled.Gap < 1e-9)
    filled.Sewn = True
    document.recompute()
    claim("with the cup it is closed", filled.Shape.isClosed() and near(filled.Shape.Area, 600))
    filled.Edges = [(box(document), "")]
    document.recompute()
    claim("without a hole it is an error", says(filled, "Edges: no edge is open, so there is no hole"))


def fillet_rounds_edges(document):
    block = box(document)
    rounded = make.fillet(document, [(block, ("Edge1", "Edge3"))], Radius="2 mm")
    document.recompute()
    off = (4 - math.pi) * 10
    claim(
        "two edges are rounded",
        list(rounded.Rounded) == [1, 3] and near(rounded.Volume, 1000 - 2 * off),
    )
    claim(
        "it is a valid solid",
        rounded.Shape.isValid() and near(rounded.Shape.Volume, rounded.Volume),
    )
    claim(
        "as FreeCAD makes it",
        near(block.Shape.makeFillet(2, block.Shape.Edges[0:3:2]).Volume, rounded.Volume),
    )
    rounded.Edges = [(block, "Face6")]
    document.recompute()
    claim("a face means its edges", len(rounded.Rounded) == 4)
    other = box(document, "Other")
    rounded.Edges = [(block, "Edge1"), (other, "Edge1")]
    document.recompute()
    claim("edges of two objects are an error", says(rounded, "of one object are wanted, these are of 2"))
    rounded.Edges = [(block, "")]
    document.recompute()
    claim("an object all that it has", len(rounded.Rounded) == 12)
    rounded.Radius, rounded.Edges = "20 mm", [(block, "Edge1")]
    document.recompute()
    claim("what is too large is an error that says why", says(rounded, "the largest radius is"))
    claim("and how large it may be", "the largest radius is 10 mm" in rounded.Refused[0])
    rounded.Edges = [(block, "Edge99")]
    document.recompute()
    claim(
        "an edge that is not there is an error",
        says(rounded, "Edges: there is no Edge99, there are 12"),
    )


def answers_tell_why_they_are_not_complete(document):
    bowl = Part.BezierSurface()  # z = x^2 + y^2 over [-1, 1]^2
    bowl.increase(2, 2)
    square = (1, -1, 1)
    for i in range(3):
        for j in range(3):
            bowl.setPole(i + 1, j + 1, V(i - 1, j - 1, square[i] + square[j]))
    face = shaped(document, "Bowl", bowl.toShape())
    cut = make.section(document, face, Point=V(0, 0, 0.25))
    document.recompute()
    claim("what is complete has no reasons", (cut.Status, cut.Reasons) == ("complete", []))
    cut.Point = V(0, 0, 0)
    document.recompute()
    why = ["the surfaces touch, or nearly, in places"]
    claim("what is not tells why", (cut.Status, cut.Reasons) == ("tolerance", why))


run(
    intersection_of_edges_has_their_points,
    intersection_is_where_containers_have_put_the_faces,
    intersection_that_is_empty_is_an_answer,
    section_has_closed_wires,
    sections_are_exported_as_drawings,
    section_follows_a_plane,
    answers_tell_why_they_are_not_complete,
    trim_keeps_sides_and_picked_pieces,
    solids_add_up,
    check_colours_what_is_wrong,
    strip_joins_faces,
    fillet_rounds_edges,
    sub_patch_is_the_surface_there,
    fill_closes_holes,
)
