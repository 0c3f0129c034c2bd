# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces cut along their intersections with others; pieces are kept by side, or by a click."""

import FreeCAD
import Part

from . import links
from .answers import Answer
from .feature import REASONS, TOLERANCE, Choice, Fact, Feature, Link, reasons_of

PICKED = "picked"
# By turns, so that neighbours can be told apart.
PIECE_COLOURS = (
    (0.40, 0.62, 0.90), (0.98, 0.76, 0.36), (0.52, 0.80, 0.55), (0.90, 0.52, 0.48),
    (0.72, 0.60, 0.88), (0.50, 0.82, 0.84), (0.93, 0.66, 0.80),
)  # fmt: skip


class Trim(Feature):
    NAME = "Trim"
    TITLE = "Trim"
    TIP = "Cut faces where they meet others, and keep the pieces that are wanted"
    DOING = "Trimming"
    HIDES = True
    LINKS = (
        Link("Part", "Part", "An object, or some of its faces, to be cut"),
        Link("Tools", "Tools", "Objects or faces that cut it"),
    )
    CHOICES = (
        Choice("Keep", "word", "all", "Keep",
               "above: where the tools' normals point; inside: in solid tools; picked: the "
               "pieces that were clicked", ("all", "above", "below", "inside", "outside", PICKED)),
        Choice("Picked", "points", [], "Picked", "A point of each piece that is kept, mm"),
        TOLERANCE,
    )  # fmt: skip
    FACTS = (
        Fact("Status", "word", "That of the intersection"),
        REASONS,
        Fact("Pieces", "count", "In how many pieces the faces fall"),
        Fact("Area", "area", "Of what is kept, square mm"),
        Fact("Notes", "words", "What was left out, and why"),
    )

    def inputs(self, obj):
        tools = links.shapes(obj.Tools, "Tools", "something that cuts")
        return {"Part": links.faces(obj.Part, "Part"), "Tools": tools}

    def options(self, obj):
        picked = [tuple(point) for point in obj.Picked] if obj.Keep == PICKED else []
        if obj.Keep == PICKED and not picked:
            raise ValueError("Picked: click a piece, or keep pieces by their side")
        return {"keep": obj.Keep, "picked": picked, "tolerance": obj.Tolerance.Value}

    def ask(self, entrance, inputs, options):
        keep = "all" if options["keep"] == PICKED else options["keep"]
        answer = entrance.trim(
            inputs["Part"], inputs["Tools"], keep, tolerance=options["tolerance"]
        )
        if options["keep"] != PICKED:
            return answer
        return Answer(_faces_at(answer.shape, options["picked"]), answer.report)

    def facts(self, report):
        return {
            "Status": report["status"],
            "Reasons": reasons_of(report),
            "Pieces": len(report["pieces"]),
            "Notes": report["notes"],
        }

    def shape(self, obj, answer, inputs):
        kept = super().shape(obj, answer, inputs)
        obj.Area = kept.Area
        return kept

    def nothing(self, obj):
        return f"Keep: nothing is {obj.Keep}"

    def colours(self, obj):
        if obj.Keep != "all":
            return None
        return [PIECE_COLOURS[i % len(PIECE_COLOURS)] for i in range(len(obj.Shape.Faces))]


def _faces_at(shape, points):
    """The faces that are nearest to points, as a shell if they hang together."""
    chosen = []
    for point in points:
        vertex = Part.Vertex(FreeCAD.Vector(*point))
        nearest = min(shape.Faces, key=lambda face: face.distToShape(vertex)[0])
        if not any(nearest.isSame(face) for face in chosen):
            chosen.append(nearest)
    return chosen[0] if len(chosen) == 1 else Part.makeCompound(chosen)
