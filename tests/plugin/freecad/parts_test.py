# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chamfers, clashes and meshes without a window: figures by hand, containers, and what is refused."""

import math
import os
import sys

import FreeCAD
import Mesh
import Part

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import blossom  # noqa: E402
from claims import claim, near, run, says, valid  # noqa: E402
from freecad.blossom import clash, drawing, make, meshes  # noqa: E402

V = FreeCAD.Vector


def box(document, name="Box", size=(10, 10, 10), at=(0, 0, 0)):
    obj = document.addObject("Part::Feature", name)
    obj.Shape = Part.makeBox(*size, V(*at))
    return obj


def chamfer_cuts_edges_off(document):
    block = box(document)
    cut = make.chamfer(document, [(block, ("Edge1", "Edge3"))], Distance="2 mm")
    document.recompute()
    claim("two edges are cut off", list(cut.CutOff) == [1, 3] and near(cut.Volume, 1000 - 2 * 20))
    claim("it is a valid solid", cut.Shape.isValid() and near(cut.Shape.Volume, cut.Volume))
    cut.Edges, cut.Size, cut.SecondDistance = [(block, "Edge1")], "two distances", "1 mm"
    document.recompute()
    claim("two distances", near(cut.Volume, 1000 - 10))
    cut.Size, cut.Angle = "distance and angle", 30
    document.recompute()
    claim("an angle", near(cut.Volume, 1000 - 10 * 2 * 2 * math.tan(math.radians(30)) / 2))
    cut.Angle = 180
    document.recompute()
    claim("a flat angle is none", says(cut, "Angle: less than 180 degrees are wanted"))
    cut.Size, cut.Distance = "equal distances", "0 mm"
    document.recompute()
    claim("nor is a distance of 0", says(cut, "Distance: it has to be positive"))
    cut.Distance, cut.Edges = "20 mm", [(block, "Edge1")]
    document.recompute()
    claim("what is too large says where", says(cut, "Edge1: "))
    cut.Distance, cut.Edges = "1 mm", [(block, "")]
    document.recompute()
    claim("an object means all its edges", valid(cut) and len(cut.CutOff) == 12)


def fillets_may_change_and_be_conics(document):
    block = box(document)
    rounded = make.fillet(document, [(block, "Edge1")], Radius="2 mm", Section="conic")
    document.recompute()
    claim("a parabola leaves a third", near(rounded.Volume, 1000 - 10 * 2 / 3, 1e-4))
    rounded.Section, rounded.LastRadius = "circle", "4 mm"
    document.recompute()
    mean = (4 + 8 + 16) / 3
    claim("radii from 2 to 4", abs(1000 - rounded.Volume - (1 - math.pi / 4) * mean * 10) < 0.5)
    rounded.LastRadius, rounded.Radii = "0 mm", ["Edge3: 3 mm", "Edge7:1..2 mm"]
    rounded.Edges = [(block, ("Edge1", "Edge3", "Edge7"))]
    document.recompute()
    taken = (1 - math.pi / 4) * 10 * (4 + 9 + 7 / 3)
    claim("edges have radii of their own", abs(1000 - rounded.Volume - taken) < 0.1)
    for wrong in ("Edge3", "3: 2 mm", "Edge3: 2 kg", "Edge3: 1 mm..2 mm..3 mm", "Edge3: wide"):
        rounded.Radii = [wrong]
        document.recompute()
        claim(f"{wrong} is no radius of an edge", says(rounded, "Radii: Edge3: 2 mm, or Edge3: 2 mm..4 mm"))
    rounded.Radii = ["Edge3: -2 mm"]
    document.recompute()
    claim("nor is what is not positive", says(rounded, "Radii: Edge3: it has to be positive"))
    rounded.Radii = []
    rounded.Rho = 1.5
    document.recompute()
    claim("sharper than sharp is none", says(rounded, "Rho: a number between 0 and 1 is wanted"))


def clash_tells_how_solids_lie(document):
    block, post = box(document, "Block"), box(document, "Post", (2, 2, 10), (4, 4, 5))
    lid = box(document, "Lid", (10, 10, 1), (0, 0, 10))
    far = box(document, "Far", (1, 1, 1), (12, 0, 0))
    found = make.clash(document, [block, post, far], Clearance="3 mm")
    document.recompute()
    claim("two of three clash", (found.Clashes, found.Touching, found.TooNear) == (1, 0, 1))
    claim("in a volume", near(found.Volume, 2 * 2 * 5))
    claim("names are those of the tree", list(found.Solids) == ["Block", "Post", "Far"])
    claim("the worst comes first", found.Pairs[0].startswith("Block and Post: penetrates, volume 20"))
    claim("grades are of solids", list(found.Grades) == [3, 3, 1])
    colours = found.Proxy.colours(found)
    claim("each face has its colour", len(colours) == len(found.Shape.Faces) == 18)
    claim("red and yellow", colours[0] == colours[6] == clash.COLOURS[3] != colours[12])
    claim("the first solid's faces", clash.faces_of_solids(found)[1][0] == "Face7")
    found.Show = "common bodies"
    document.recompute()
    claim("the common body", near(found.Shape.Volume, 20) and len(found.Shape.Solids) == 1)
    found.A, found.B, found.Show = [(block, ""), (far, "")], [(lid, "")], "parts"
    document.recompute()
    claim("pairs have one of each", found.Touching == 1 and list(found.Grades)[0] == 2)
    claim("that touch in a face", "Block and Lid: touches, in a face" in found.Pairs)
    found.Show = "common bodies"
    document.recompute()
    claim("none is an error that says so", says(found, "Show: no parts have a common body"))


def loose(document, faces, name="Loose"):
    """Faces without common edges, as surface models have them."""
    obj = document.addObject("Part::Feature", name)
    obj.Shape = Part.makeCompound([face.copy() for face in faces])
    return obj


def _twins(obj, number):
    """The numbers of the edges where an edge is."""
    middle = obj.Shape.Edges[number - 1].CenterOfMass
    return [n for n, edge in enumerate(obj.Shape.Edges, start=1) if edge.CenterOfMass.isEqual(middle, 1e-9)]


def loose_faces_are_sewn(document):
    faces = Part.makeBox(10, 10, 10).Faces
    block, post = loose(document, faces), box(document, "Post", (2, 2, 10), (4, 4, 5))
    claim("they are no solid", not block.Shape.Solids)
    cut = make.solid(document, "cut", (block, ""), [(post, "")])
    kept = make.solid(document, "common", (post, ""), [(block, "")])
    document.recompute()
    claim("they are cut as a solid", valid(cut) and near(cut.Shape.Volume, 1000 - 20))
    claim("and cut as one", valid(kept) and near(kept.Shape.Volume, 20))
    claim("the object stays as it is", not block.Shape.Solids)
    number = next(n for n, edge in enumerate(block.Shape.Edges, start=1)
                  if edge.CenterOfMass.isEqual(V(10, 10, 5), 1e-9))  # fmt: skip
    one = make.fillet(document, [(block, (f"Edge{number}",))], Radius="1 mm")
    own = make.fillet(document, block, Radius="1 mm", Radii=[f"Edge{number}: 2 mm"])
    bevelled = make.chamfer(document, [(block, ("Face1",))], Distance="1 mm")
    found = make.clash(document, [(block, ""), (box(document, "Pin", (1, 1, 10), (4, 4, 5)), "")])
    document.recompute()
    taken = 10 * (1 - math.pi / 4)
    claim("an edge that two faces have is rounded", near(one.Shape.Volume, 1000 - taken))
    claim("under the lesser of its numbers", one.Rounded == [min(_twins(block, number))])
    claim("with a radius of its own", valid(own) and own.Shape.Volume < 972)
    claim("all twelve are", len(own.Rounded) == 12)
    claim("a face's edges are cut off", valid(bevelled) and len(bevelled.CutOff) == 4)
    claim("they clash as a solid", (found.Clashes, found.Solids) == (1, ["Loose", "Pin"]))
    claim("and stay as they are", not block.Shape.Solids and len(block.Shape.Edges) == 24)
    block.Shape = Part.makeCompound([face.copy() for face in faces[:5]])
    document.recompute()
    claim("what closes nothing is cut as a sheet", valid(cut) and not cut.Shape.Solids and near(cut.Area, 500))
    rounded, found = make.fillet(document, block), make.clash(document, [(block, ""), (post, "")])
    document.recompute()
    for made in (rounded, found):
        claim(f"{made.Name} says that they close none", says(made, "and its faces close none"))


def edges_are_found_across_gaps(document):
    faces = [face.copy() for face in Part.makeBox(10, 10, 10).Faces]
    side = next(face for face in faces if near(face.CenterOfMass.x, 10))
    side.translate(V(1e-3, 0, 0))
    block = loose(document, faces, "Apart")
    edges = block.Shape.Edges
    along = [n for n, edge in enumerate(edges, start=1)
             if (edge.CenterOfMass - V(10, 10, 5)).Length < 0.01]  # fmt: skip
    claim("two edges are apart", len(along) == 2)
    for number in along:
        rounded = make.fillet(document, [(block, (f"Edge{number}",))], Radius="1 mm")
        document.recompute()
        claim(f"Edge{number} is rounded", valid(rounded) and rounded.Rounded == [min(along)])


def clash_follows_containers_and_refuses_faces(document):
    block, post = box(document, "Block"), box(document, "Post", (2, 2, 10), (4, 4, 5))
    holder = document.addObject("App::Part", "Holder")
    holder.addObject(post)
    found = make.clash(document, [(block, ""), (holder, "Post.")])
    document.recompute()
    claim("they clash", found.Clashes == 1 and near(found.Volume, 20))
    holder.Placement.Base = V(0, 0, 3)
    document.recompute()
    claim("less where the container has put it", near(found.Volume, 8))
    holder.Placement.Base = V(0, 0, 50)
    document.recompute()
    claim("and not at all far away", valid(found) and (found.Clashes, found.Volume) == (0, 0))
    others = [box(document, f"Far{i}", at=(100 * i, 0, 0)) for i in (1, 2)]
    found.A = [(block, ""), *((each, "") for each in others)]
    document.recompute()
    claim("pairs that are not listed are counted", found.FarApart == 1 and len(found.Pairs) == 2)
    sheet = document.addObject("Part::Plane", "Sheet")
    found.A = [(block, ""), (sheet, "")]
    document.recompute()
    claim("a face is no solid", says(found, "A: closed solids are wanted, Sheet has none"))
    found.A = [(block, "")]
    document.recompute()
    claim("one alone has no pair", says(found, "Block is one solid alone"))
    found.A = []
    document.recompute()
    claim("nothing is too little", says(found, "A: solids are wanted, and there are none"))


def mesh_is_of_freecads_kind(document):
    rod = document.addObject("Part::Cylinder", "Rod")
    rod.Radius, rod.Height = 5, 20
    holder = document.addObject("App::Part", "Holder")
    holder.addObject(rod)
    holder.Placement = FreeCAD.Placement(V(0, 0, 7), FreeCAD.Rotation(V(1, 0, 0), 90))
    mesh = make.mesh(document, (holder, "Rod."), Deviation="0.05 mm")
    document.recompute()
    exact = math.pi * 25 * 20
    claim("it is a mesh", mesh.isDerivedFrom("Mesh::Feature") and mesh.Mesh.isSolid())
    claim("closed, as is said", (mesh.Closed, mesh.Mesh.CountFacets) == ("yes", mesh.Triangles))
    claim("as near as is proven", 0 < mesh.Within <= 0.05 and 0.98 * exact < mesh.Mesh.Volume < exact)
    bounds = mesh.Mesh.BoundBox
    claim("where the container is", near(bounds.YMin, -20, 1e-4) and near(bounds.ZMin, 2, 0.06))
    claim("a segment for each face", mesh.Mesh.countSegments() == 3)
    claim("which begin there", list(mesh.FaceNumbers) == [1, 2, 3] and mesh.FirstTriangles[0] == 0)
    mesh.Placement.Base = V(100, 0, 0)
    mesh.touch()
    document.recompute()
    claim("a move of its own is kept", near(mesh.Mesh.BoundBox.XMin, bounds.XMin + 100, 1e-4))
    coarse = mesh.Triangles
    mesh.Deviation, mesh.EdgeLength = "0.5 mm", "1 mm"
    document.recompute()
    claim("short sides are many", mesh.Triangles > coarse)
    mesh.Part, mesh.EdgeLength = [(rod, "Face1")], "0 mm"
    document.recompute()
    claim("a face alone is open", (mesh.Closed, list(mesh.FaceNumbers)) == ("no", [1]))
    mesh.Part = []
    document.recompute()
    claim("nothing is an error", says(mesh, "Part: a face is wanted, and there is none"))


def a_full_round_leaves_nothing_of_a_face(document):
    block = box(document)
    rounded = make.fillet(document, [(block, ("Edge1", "Edge3"))], FullRound=True)
    document.recompute()
    claim("two edges are rounded to the middle",
          valid(rounded) and near(rounded.Volume, 1000 - 10 * (2 - math.pi / 2) * 25, 1e-4))
    claim("nothing is left between them", len(rounded.Shape.Faces) == 7)
    rounded.Edges = [(block, ("Edge1", "Edge7"))]
    document.recompute()
    claim("edges that would do are named", says(rounded, "have no face in common; edges 1 and 3"))


def message_of(call):
    try:
        call()
    except (TypeError, ValueError) as error:
        return f"{type(error).__name__}: {error}"
    return "no error"


def wrong_lines_are_told_and_leave_nothing(document):
    block = box(document)
    count = len(document.Objects)
    for said, call in {
        "ValueError: Operation: one of cut, common, fuse, split is wanted, got 'minus'":
            lambda: make.solid(document, "minus", block, block),
        "TypeError: there is no choice Radus; there are Radius, LastRadius, Radii, FullRound, Setback, Section, Rho, "
        "Partial, Tolerance":
            lambda: make.fillet(document, block, Radus=3),
        "TypeError: A: objects of a document, or pairs of one and its elements, "
        'as (box, "Face1"), are wanted, got int': lambda: make.intersection(document, 3, block),
        "TypeError: Part: objects of a document, or pairs of one and its elements, "
        'as (box, "Face1"), are wanted, got Solid': lambda: make.section(document, block.Shape.Solids),
        "TypeError: a document is wanted, got NoneType": lambda: make.check(None, block),
    }.items():  # fmt: skip
        told = message_of(call)
        claim(told, told == said)
    told = message_of(lambda: make.fillet(document, block, Radius="wide"))
    claim(told, told.startswith("ValueError: Radius: 'wide' cannot be taken"))
    told = message_of(lambda: drawing.write(block, "block.dxf"))
    claim(told, told == "ValueError: Box: is no Section of Blossom, which drawings are of")
    claim("no object is left half made", len(document.Objects) == count)


def mesh_objects_answer_to_questions(document):
    scan = document.addObject("Mesh::Feature", "Scan")
    scan.Mesh = Mesh.createBox(10, 10, 10)
    holder = document.addObject("App::Part", "ScanHolder")
    holder.addObject(scan)
    holder.Placement.Base = V(100, 0, 0)
    document.recompute()
    claim("a box is sound", (meshes.check(scan).sound, round(meshes.check(scan).volume)) == (True, 1000))
    cut = meshes.section(document, scan, (0, 0, 1), (0, 0, 1))
    claim("a plane cuts it in a square", near(cut.Shape.Length, 40, 1e-9))
    claim("where its container is", near(cut.Shape.BoundBox.Center.x, 100, 1e-6))
    box = document.addObject("Part::Box", "Beside")
    box.Placement.Base = V(97, -3, 0)
    document.recompute()
    low, high = meshes.distance(scan, box).bounds
    claim("as far from a box as they are", low <= math.sqrt(33) <= high + 1e-9 and high < 6.4)
    curves = meshes.intersection(document, scan, box)
    claim("they meet", curves.Shape.Edges)
    opened = Mesh.Mesh([facet.Points for facet in scan.Mesh.Facets][2:])
    torn = document.addObject("Mesh::Feature", "Torn")
    torn.Mesh = opened
    whole = meshes.filled(document, torn)
    claim("its holes are filled", whole.Mesh.isSolid() and near(whole.Mesh.Volume, 1000, 1e-6))
    try:
        meshes.section(document, scan, (0, 0, 50), (0, 0, 1))
        said = ""
    except ValueError as error:
        said = str(error)
    claim("what is not there is an error", "they do not meet" in said)


def turned_meshes_in_turned_containers_are_where_they_are_shown(document):
    scan = document.addObject("Mesh::Feature", "Scan")
    scan.Mesh = Mesh.createBox(10, 10, 10)
    scan.Placement = FreeCAD.Placement(V(100, 0, 0), FreeCAD.Rotation(V(0, 0, 1), 30))
    holder = document.addObject("App::Part", "Holder")
    holder.addObject(scan)
    holder.Placement = FreeCAD.Placement(V(0, 2.5, 0.5), FreeCAD.Rotation(V(1, 0, 0), 20))
    document.recompute()
    shown = scan.getGlobalPlacement()
    corners = [shown.multVec(V(x, y, z)) for x in (-5, 5) for y in (-5, 5) for z in (-5, 5)]
    for each in (meshes.triangles(scan), blossom.from_mesh(scan)):
        off = max(min(corner.distanceToPoint(V(*v)) for corner in corners) for v in each.vertices)
        claim("corners are where they are shown", len(each.vertices) == 8 and off < 1e-5)
    same = document.addObject("Part::Box", "Same")
    same.Length = same.Width = same.Height = 10
    same.Placement = FreeCAD.Placement(V(100, 0, 0), FreeCAD.Rotation(V(0, 0, 1), 30)).multiply(
        FreeCAD.Placement(V(-5, -5, -5), FreeCAD.Rotation())
    )
    holder.addObject(same)
    document.recompute()
    claim("a box in the same place is as far as rounding", meshes.distance(scan, same).bounds[1] < 1e-5)


def links_count_where_they_are(document):
    scan = document.addObject("Mesh::Feature", "Scan")
    scan.Mesh = Mesh.createBox(10, 10, 10)
    scan.Placement = FreeCAD.Placement(V(7, 0, 0), FreeCAD.Rotation(V(0, 0, 1), 90))
    holder = document.addObject("App::Part", "Holder")
    holder.Placement = FreeCAD.Placement(V(0, 50, 0), FreeCAD.Rotation(V(1, 0, 0), 30))
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = scan
    link.Placement.Base = V(100, 0, 0)
    box = document.addObject("Part::Box", "Block")
    box.Length = box.Width = box.Height = 10
    other = document.addObject("App::Link", "Other")
    other.LinkedObject = box
    other.Placement.Base = V(95, -5, -5)
    for transform in (False, True):
        link.LinkTransform = transform
        document.recompute()
        middle = V(107, 0, 0) if transform else V(100, 0, 0)
        for each in (meshes.triangles(link), blossom.from_mesh(link)):
            claim("a link is where it is shown", V(*each.vertices.mean(0)).distanceToPoint(middle) < 1e-5)
        away = 7 if transform else 0
        claim("as is a link to a shape", abs(meshes.distance(link, other).bounds[1] - away) < 1e-3)
    holder.addObject(link)
    document.recompute()
    middle = holder.Placement.multVec(V(107, 0, 0))
    claim(
        "also in a container",
        V(*meshes.triangles(link).vertices.mean(0)).distanceToPoint(middle) < 1e-5,
    )


def planes_by_links_are_where_they_are_shown(document):
    block = box(document)
    line = document.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine(V(0, 0, 0), V(1, 0, 0))
    line.Placement.Base = V(0, 0, 3)
    holder = document.addObject("App::Part", "Holder")
    holder.Placement.Base = V(0, 0, 1)
    for transform, height in ((False, 2), (True, 5)):
        link = document.addObject("App::Link", "Link")
        link.LinkedObject, link.LinkTransform = line, transform
        link.Placement.Base = V(0, 0, 2)
        document.recompute()
        cut = make.section(document, block, link)
        document.recompute()
        claim("the plane is where the link is", near(cut.Shape.BoundBox.ZMax, height))
        holder.addObject(link)
        cut = make.section(document, block, (holder, f"{link.Name}."))
        document.recompute()
        claim("also in a container", near(cut.Shape.BoundBox.ZMax, height + 1))


def what_no_question_of_meshes_can_take_is_told(document):
    box = document.addObject("Part::Box", "Block")
    scan = document.addObject("Mesh::Feature", "Scan")
    document.recompute()
    for ask, words in (
        (lambda: meshes.check(3), "a Mesh object is wanted, got int"),
        (lambda: meshes.check(box), "Block is no mesh"),
        (lambda: meshes.check(scan), "Scan has no triangles"),
        (lambda: meshes.section(None, scan, (0, 0, 0), (0, 0, 1)), "a document is wanted, got NoneType"),
    ):
        claim(f"it says: {words}", told(ask) == words)
    scan.Mesh = Mesh.createBox(10, 10, 10)
    cut = make.section(document, scan)
    cut.Proxy.begin(cut)  # as the command does before its panel, which says the same
    document.recompute()
    words = "Scan is a mesh, not a shape; in Python freecad.blossom.meshes takes it"
    claim("shapes are not made of meshes", says(cut, words))
    FreeCAD.closeDocument(document.Name)
    closed = "the object is deleted, or its document closed"
    for ask in (
        lambda: meshes.check(scan),
        lambda: make.section(document, box),
        lambda: drawing.write(cut, "cut.dxf"),
    ):
        claim("a closed document is told", told(ask) == closed)


def told(ask):
    """What a TypeError or a ValueError says."""
    try:
        ask()
    except (TypeError, ValueError) as error:
        return str(error)
    return ""


run(
    chamfer_cuts_edges_off,
    fillets_may_change_and_be_conics,
    a_full_round_leaves_nothing_of_a_face,
    clash_tells_how_solids_lie,
    loose_faces_are_sewn,
    edges_are_found_across_gaps,
    clash_follows_containers_and_refuses_faces,
    mesh_is_of_freecads_kind,
    wrong_lines_are_told_and_leave_nothing,
    mesh_objects_answer_to_questions,
    turned_meshes_in_turned_containers_are_where_they_are_shown,
    links_count_where_they_are,
    planes_by_links_are_where_they_are_shown,
    what_no_question_of_meshes_can_take_is_told,
)
