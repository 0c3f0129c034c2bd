# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections with one plane or many parallel ones, as wires."""

import FreeCAD
import Part

from . import links
from .feature import REASONS, TOLERANCE, Choice, Fact, Feature, Link, reasons_of

MOST_PLANES = 10000
DIGITS = 4  # after the point, of a middle: as many as fields show


class Section(Feature):
    NAME = "Section"
    TITLE = "Section"
    TIP = "Wires in which parallel planes cut objects"
    DOING = "Cutting with planes"
    LINKS = (
        Link("Part", "Objects", "What is cut: objects or faces"),
        Link("Plane", "Plane", "A flat face, or an object whose placement says where the plane "
             "is; none: Point and Normal say it"),
    )  # fmt: skip
    CHOICES = (
        Choice("Point", "vector", FreeCAD.Vector(0, 0, 0), "Point", "A point of the plane, mm"),
        Choice("Normal", "vector", FreeCAD.Vector(0, 0, 1), "Normal", "Its normal, of any length"),
        Choice("Offset", "distance", "0 mm", "Offset", "Of the first plane, along the normal"),
        Choice("Count", "count", 1, "Planes", "How many there are", (1, MOST_PLANES)),
        Choice("Spacing", "distance", "1 mm", "Spacing", "From each plane to the next"),
        TOLERANCE,
    )
    FACTS = (
        Fact("Status", "word", "The weakest of all planes"),
        REASONS,
        Fact("Wires", "count", "How many wires there are"),
        Fact("Closed", "count", "How many of them are closed"),
        Fact("Length", "length", "Of all wires, mm"),
        Fact("Area", "area", "Inside of the wires, without holes, square mm; 0 if one is open"),
        Fact("WiresOfPlanes", "counts", "How many wires each plane makes"),
    )

    def inputs(self, obj):
        return {"Part": links.faces(obj.Part, "Part")}

    def options(self, obj):
        point, normal = _plane_of(obj)
        if not 1 <= obj.Count <= MOST_PLANES:
            raise ValueError(f"Count: 1 to {MOST_PLANES} planes are wanted, got {obj.Count}")
        offsets = [obj.Offset.Value + i * obj.Spacing.Value for i in range(obj.Count)]
        return {
            "points": [tuple(point + normal * offset) for offset in offsets],
            "normal": tuple(normal),
            "tolerance": obj.Tolerance.Value,
        }

    def begin(self, obj):
        """The plane goes through the middle of what is cut; the panel tells what cannot be."""
        if not obj.Part or obj.Plane:
            return
        try:
            middle = links.shape(obj.Part, "Part").BoundBox.Center
        except ValueError:
            return
        obj.Point = FreeCAD.Vector(*(round(each, DIGITS) for each in middle))

    def unused(self, obj):
        of_plane = {"Point", "Normal"} if obj.Plane else set()
        return of_plane | ({"Spacing"} if obj.Count == 1 else set())

    def ask(self, entrance, inputs, options):
        planes = self.planes(options)
        return entrance.sections(inputs["Part"], planes, tolerance=options["tolerance"])

    @staticmethod
    def planes(options):
        return [(point, options["normal"]) for point in options["points"]]

    def shape(self, obj, answer, inputs):
        return answer.shape or Part.makeCompound([])  # no plane meets anything: an answer, too

    @classmethod
    def deal(cls, members):
        planes = [each for each in members if _is_plane(*each)]
        others = [each for each in members if each not in planes]
        return [others, planes] if others and len(planes) == 1 else [members, []]

    def facts(self, report):
        planes = [
            [wire for part in plane["parts"] for wire in part["wires"]]
            for plane in report["planes"]
        ]
        wires = [wire for plane in planes for wire in plane]
        areas = [part["area"] for plane in report["planes"] for part in plane["parts"]]
        return {
            "Status": report["status"],
            "Reasons": reasons_of(report),
            "Wires": len(wires),
            "Closed": sum(wire["closed"] for wire in wires),
            "Length": sum(wire["length"] for wire in wires),
            "Area": 0.0 if None in areas else float(sum(areas)),
            "WiresOfPlanes": [len(plane) for plane in planes],
        }


def _plane_of(obj):
    """A point and the unit normal. throws ValueError"""
    if obj.Plane:
        return _plane_of_link(obj.Plane)
    if obj.Normal.Length == 0:
        raise ValueError("Normal: the zero vector has no direction")
    return obj.Point, FreeCAD.Vector(obj.Normal).normalize()


def _is_plane(target, sub):
    """Whether a member is more likely the plane than what it cuts."""
    leaf = links.leaf_of(target, sub)
    if leaf is not None and leaf.TypeId in ("App::Plane", "PartDesign::Plane"):
        return True
    faces = Part.getShape(target, sub, needSubElement=True).Faces
    return len(faces) == 1 and faces[0].Surface.isPlanar()


def _plane_of_link(link):
    target, sub = links.members(link)[0]
    if links.element_of(sub).startswith("Face"):
        face = links.shape_of(target, sub, "Plane")
        surface = face.findPlane() if face.Surface.isPlanar() else None
        if surface is None:
            raise ValueError(f"Plane: {links.shown(target, sub)} is not flat")
        return surface.Position, FreeCAD.Vector(surface.Axis).normalize()
    placement = links.place_of(target, sub)
    if placement is None:
        raise ValueError(f"Plane: {links.shown(target, sub)} has no place")
    return placement.Base, placement.Rotation.multVec(FreeCAD.Vector(0, 0, 1))

