# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed solids, or sheets, combined: cut, common, fuse, split."""

from . import links
from .feature import REASONS, TOLERANCE, Choice, Fact, Feature, Link, reasons_of


class Solid(Feature):
    NAME = "Solid"
    TITLE = "Combine solids"
    TIP = "Cut, common, fuse or split of closed solids and sheets; volumes or areas add up"
    DOING = "Combining solids"
    HIDES = True
    LINKS = (
        Link("Part", "Part", "A closed solid, or a sheet"),
        Link("Tools", "Tools", "Closed solids, or sheets"),
    )
    CHOICES = (
        Choice("Operation", "word", "cut", "Operation", "split: cut and common side by side",
               ("cut", "common", "fuse", "split")),
        TOLERANCE,
    )  # fmt: skip
    FACTS = (
        Fact("Status", "word", "That of the intersection"),
        REASONS,
        Fact("Solids", "count", "How many solids came out"),
        Fact("Volume", "volume", "Of what came out, cubic mm"),
        Fact("Area", "area", "Of the sheets that came out, square mm"),
        Fact("Notes", "words", "That nothing is cut, what counts as one, tolerances that were not true"),
        Fact("Obstacles", "words", "Why there is no result"),
    )

    def inputs(self, obj):
        tools = links.shapes(obj.Tools, "Tools", "a solid")
        return {"Part": links.shape(obj.Part, "Part", "a solid"), "Tools": tools}

    def options(self, obj):
        return {"operation": obj.Operation, "tolerance": obj.Tolerance.Value}

    def ask(self, entrance, inputs, options):
        return entrance.solid(
            options["operation"], inputs["Part"], inputs["Tools"], tolerance=options["tolerance"]
        )

    def facts(self, report):
        return {
            "Status": report["status"],
            "Reasons": reasons_of(report),
            "Solids": len(report["solids"]),
            "Volume": report["total"]["result"],
            "Area": report["areas"]["result"],
            "Notes": _cuts_nothing(report) + report["thin"] + report["tolerances"],
            "Obstacles": report["obstacles"],
        }

    def shape(self, obj, answer, inputs):
        if obj.Obstacles:  # what there is cannot be used
            raise RuntimeError(self.nothing(obj))
        return super().shape(obj, answer, inputs)

    def nothing(self, obj):
        return obj.Obstacles[0] if obj.Obstacles else f"the result of {obj.Operation} is empty"


def _cuts_nothing(report):
    """A line if a cut leaves the part as it was; of sheets there is no volume to tell it by."""
    steps = report["steps"]
    cuts = report["operation"] in ("cut", "split") and steps
    if cuts and all(step["tool"] > 0 and step["common"] == 0 for step in steps):
        return ["nothing is cut: part and tools have no volume in common"]
    return []
