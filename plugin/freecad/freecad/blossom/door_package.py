# SPDX-License-Identifier: LGPL-2.1-or-later
"""Questions to the package `blossom`, wherever its engine works."""

import os
import tempfile

import blossom
import Mesh

from .answers import Answer, niceness, with_segments


class PackageDoor:
    """Questions that `cancel` ends with `blossom.Cancelled`. What is held may be asked about in any
    thread."""

    Cancelled = blossom.Cancelled

    def __init__(self):
        self._cancel = blossom.Cancel()
        self._way = {"cancel": self._cancel, "nice": niceness()}

    def cancel(self):
        self._cancel.cancel()

    def hold(self, shape, name):
        """A shape of Part, ready to be asked about; messages call it by the name."""
        return blossom.shape(shape, name)

    def sewn(self, shape, name):
        """The shape with its loose faces as the solids that they close."""
        return blossom.shape(shape, name).sew(**self._way).to_part()

    def intersect(self, a, b, **options):
        return self._answer(a.intersect(b, **options, **self._way))

    def sections(self, part, planes, **options):
        made = part.sections(planes, **options, **self._way)
        return self._answer(
            made,
            lambda report: any(
                section["wires"] or section["points"]
                for plane in report["planes"]
                for section in plane["parts"]
            ),
        )

    def draw_sections(self, part, planes, file, **options):
        """Writes a drawing, .dxf or .svg."""
        part.sections(planes, **options, **self._way).write(file, **self._way)

    def trim(self, part, tools, keep, **options):
        made = part.trim(*tools, keep=keep, **options, **self._way)
        return self._answer(made, lambda report: any(each["kept"] for each in report["pieces"]))

    def solid(self, operation, part, tools, **options):
        made = part.solid(operation, *tools, **options, **self._way)
        return self._answer(made, lambda report: report["solids"] or report["sheets"])

    def check(self, part):
        return Answer(None, part.check(**self._way).to_dict(samples=False))

    def strip(self, a, b, edge_a, edge_b, continuity, weight_a, weight_b):
        return self._answer(
            blossom.blend_strip(
                a, b, edge_a, edge_b, continuity, weight_a, weight_b, **self._way
            )
        )

    def fillet(self, part, edges, **options):
        made = part.fillet(edges, **options, **self._way)
        return self._answer(made, lambda report: report["edges"])

    def chamfer(self, part, edges, **options):
        made = part.chamfer(edges, **options, **self._way)
        return self._answer(made, lambda report: report["edges"])

    def clash(self, a, b, clearance, **options):
        found = a.clash(b, clearance=clearance, **options, **self._way)
        return self._answer(found, lambda report: any("common" in each for each in report["pairs"]))

    def mesh(self, part, **options):
        made = part.mesh(**options, **self._way)
        groups = [(number, rows.start) for number, rows in made.groups.items()]
        with tempfile.TemporaryDirectory(prefix="blossom-") as folder:
            file = os.path.join(folder, "mesh.ply")  # which FreeCAD reads the fastest
            made.write(file, **self._way)
            triangles = Mesh.Mesh(file)
        return Answer(with_segments(triangles, groups), {**made.to_dict(samples=False), "groups": groups})

    def subdivide(self, part, rectangle, levels):
        return self._answer(part.subdivide(rectangle, levels=levels, **self._way))

    def fill(self, part, edges, continuity, sew, **options):
        made = part.fill(edges, continuity=continuity, sew=sew, **options, **self._way)
        return self._answer(made)

    @staticmethod
    def _answer(result, has_shape=lambda report: True):
        """The report is without the samples of curves: as lists of Python these would keep the
        window waiting, when they are made and whenever garbage is looked for."""
        report = result.to_dict(samples=False)
        return Answer(result.to_part() if has_shape(report) else None, report)
