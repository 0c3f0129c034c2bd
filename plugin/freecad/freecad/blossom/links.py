# SPDX-License-Identifier: LGPL-2.1-or-later
"""What objects link to, as shapes where they are shown.

A link is a list of pairs (object, names). A name is "Face3", "" for all of the object, or a path
through a container: (part, ["Box.Face3"]) is the face of the box where the part has put it, which
the box alone does not know.
"""

import collections

import Part

from . import door


def has(thing, name):
    """Whether it has an attribute. throws ValueError if it is deleted, where FreeCAD has an
    exception of its own"""
    try:
        return hasattr(thing, name)
    except ReferenceError:
        raise ValueError("the object is deleted, or its document closed") from None


def require_document(document):
    """throws TypeError if it is none, ValueError if it is closed"""
    if not has(document, "addObject"):
        raise TypeError(f"a document is wanted, got {type(document).__name__}")


def told(link):
    """The members of a link as ["Box.Face3", ...]; they are compared and stored."""
    return [f"{target.Name}.{sub}" for target, sub in members(link)]


def members(link):
    """Pairs of an object and one name."""
    return [(target, sub) for target, subs in link or [] for sub in (subs or ("",))]


def shown(target, sub):
    """A member as messages and lists call it, with the labels that users gave."""
    leaf = leaf_of(target, sub)
    label = target.Label if leaf is None else leaf.Label
    element = element_of(sub)
    return f"{label}.{element}" if element else label


def element_of(sub):
    """ "Face3" of "Box.Face3", "" of "Box."."""
    return sub.rsplit(".", 1)[-1]


def path_of(sub):
    """ "Box." of "Box.Face3", "" of "Face3"."""
    return sub[: len(sub) - len(element_of(sub))]


def leaf_of(target, sub):
    """The object that has the shape itself, below all containers; None if it is gone."""
    if not path_of(sub):
        return target
    return target.getSubObject(path_of(sub), retType=1)


def shown_by(target, sub):
    """The object that shows a member, and nothing else where a link is on the way: the first link,
    else the leaf; None if it is gone."""
    here, way = target, ""
    for name in path_of(sub).split(".")[:-1]:
        if here is None or here.hasExtension("App::LinkBaseExtension"):
            break
        way += f"{name}."
        here = target.getSubObject(way, retType=1)
    return here


def place_of(target, sub):
    """Where a member is shown: below all containers, and by the links on the way to it; None if it
    has no place."""
    leaf = leaf_of(target, sub)
    if not hasattr(leaf, "Placement"):
        return None
    place = target.getSubObject(path_of(sub), retType=3)  # with the target's own placement
    if hasattr(target, "getGlobalPlacement"):  # links have none
        container = target.getGlobalPlacement().multiply(target.Placement.inverse())
        place = container.multiply(place)
    while leaf.hasExtension("App::LinkBaseExtension") and leaf.LinkTransform:
        leaf = leaf.LinkedObject  # whose own placement the link keeps
        place = place.multiply(leaf.Placement)
    return place


def shape_of(target, sub, name):
    """The placed shape of a member. throws ValueError, with the property's name"""
    shape = Part.getShape(target, sub, needSubElement=True)
    if shape.isNull():
        if hasattr(leaf_of(target, sub), "Mesh"):
            raise ValueError(
                f"{name}: {shown(target, sub)} is a mesh, not a shape; "
                "in Python freecad.blossom.meshes takes it"
            )
        if not sub:
            raise ValueError(f"{name}: {target.Label} has no shape")
        raise ValueError(f"{name}: {sub} of {target.Label} is gone, or it has no shape")
    return shape


def shape(link, name, wanted="a shape"):
    """All members of a link as one shape. throws ValueError"""
    made = shapes(link, name, wanted)
    return made[0] if len(made) == 1 else Part.makeCompound(made)


def faces(link, name):
    """All members of a link, which have faces, as one shape. throws ValueError"""
    made = shape(link, name, "a face")
    if not made.Faces:
        raise ValueError(f"{name}: faces are wanted, {shown(*members(link)[0])} has none")
    return made


def faces_or_edges(link, name):
    """All members of a link as one shape; those that have no face have edges. throws ValueError"""
    made = shape(link, name, "a face or an edge")
    if not made.Edges:
        raise ValueError(
            f"{name}: faces or edges are wanted, {shown(*members(link)[0])} has none"
        )
    return made


def shapes(link, name, wanted):
    """The shapes of all members, of which one at least is wanted. throws ValueError"""
    made = [shape_of(target, sub, name) for target, sub in members(link)]
    if not made:
        raise ValueError(f"{name}: {wanted} is wanted, and there is none")
    return made


def one_face(link, name):
    """The face of a link that has one. throws ValueError"""
    made = faces(link, name)
    if len(made.Faces) != 1:
        raise ValueError(f"{name}: one face is wanted, there are {len(made.Faces)}")
    return made.Faces[0]


def face_with_edge(link, name):
    """The face of a link that has one, and the number within the face of the edge that the link
    names beside it, or None. throws ValueError"""
    listed = members(link)
    edges = [each for each in listed if element_of(each[1]).startswith("Edge")]
    face = one_face([(target, (sub,)) for target, sub in listed if (target, sub) not in edges], name)
    if not edges:
        return face, None
    if len(edges) != 1:
        raise ValueError(f"{name}: one edge at most is wanted, there are {len(edges)}")
    whole, numbers = whole_with_edges([(target, (sub,)) for target, sub in edges], name)
    edge = whole.Edges[numbers[0] - 1]
    # Of a whole shape faces and edges are the same ones; those taken alone are not.
    for own in whole.Faces:
        if own.isPartner(face):
            for number, each in enumerate(own.Edges, start=1):
                if each.isSame(edge):
                    return face, number
    raise ValueError(f"{name}: {shown(*edges[0])} is no edge of the face")


_sewn = collections.deque(maxlen=8)  # pairs of shapes of loose faces and what they close


def solid_of(shape, label):
    """A shape, or if it has faces alone, as surface models have them, the solid that they close; it
    stays as it is where they close none."""
    if shape.Solids or len(shape.Faces) < 2:
        return shape
    for given, made in _sewn:
        if given.isSame(shape):
            return made
    made = door.opened().sewn(shape, label)
    made = made if made.Solids else shape
    _sewn.append((shape, made))
    return made


def without_solid(shape, label):
    """That an object has no closed solid."""
    return f"{label} has none" + (", and its faces close none" if len(shape.Faces) > 1 else "")


def finder_within(solid):
    """What tells the numbers of the edges of a solid of which an edge of the faces that it is made
    of, or a part of that edge, has become one. Tolerances of edges that were sewn are as wide as
    the gaps that they close."""
    own = [
        (number, each, _reach(each))
        for number, each in enumerate(solid.Edges, start=1)
        if not each.Degenerated
    ]

    def find(edge):
        if edge.Degenerated:
            return []
        near = _reach(edge)
        return [number for number, each, box in own if near.intersect(box) and _lies_on(each, edge)]

    return find


def _reach(edge):
    """Its box, with its tolerance."""
    box = edge.BoundBox
    box.enlarge(edge.Tolerance)
    return box


def _lies_on(edge, other):
    apart = edge.Tolerance + other.Tolerance
    first, last = edge.FirstParameter, edge.LastParameter
    return all(
        other.distToShape(Part.Vertex(edge.valueAt(first + share * (last - first))))[0] <= apart
        for share in (0.5, 0, 0.25, 1)
    )


def whole_with_edges(link, name):
    """The whole placed shape of one object, and the numbers of the edges that the link names; of
    faces their edges; none if it names only the object. throws ValueError"""
    listed = members(link)
    if not listed:
        raise ValueError(f"{name}: edges or an object are wanted, and none is chosen")
    wholes = {(target, path_of(sub)) for target, sub in listed}
    if len(wholes) != 1:
        raise ValueError(f"{name}: edges of one object are wanted, these are of {len(wholes)}")
    target, path = wholes.pop()
    whole = shape_of(target, path, name)
    faces, edges = whole.Faces, whole.Edges  # FreeCAD makes the lists anew each time
    numbers = set()
    for _, sub in listed:
        numbers.update(_edge_numbers(faces, edges, element_of(sub), name))
    return whole, sorted(numbers)


def _edge_numbers(faces, edges, element, name):
    if not element:
        return []
    if element.startswith("Edge"):
        return [_number_within(element, "Edge", len(edges), name)]
    if element.startswith("Face"):
        own = {}
        for edge in faces[_number_within(element, "Face", len(faces), name) - 1].Edges:
            own.setdefault(edge.hashCode(), []).append(edge)
        return [
            number
            for number, edge in enumerate(edges, start=1)
            if any(map(edge.isSame, own.get(edge.hashCode(), ())))
        ]
    raise ValueError(f"{name}: edges or faces are wanted, got {element}")


def _number_within(element, word, count, name):
    digits = element[len(word) :]
    number = int(digits) if digits.isdigit() else 0
    if not 1 <= number <= count:
        raise ValueError(f"{name}: there is no {element}, there are {count}")
    return number


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
    return target, path_of(sub)
