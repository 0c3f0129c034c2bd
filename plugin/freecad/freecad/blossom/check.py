# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with an object: its faces coloured by that, and a table."""

from . import links
from .feature import Fact, Feature, Link

SOUND = (0.55, 0.78, 0.58)
BESIDE = (0.98, 0.75, 0.30)  # a face with an edge that has a problem
FAULTY = (0.86, 0.22, 0.20)


class Check(Feature):
    NAME = "Check"
    TITLE = "Check"
    TIP = "What is wrong with an object: validity, gaps beside stated tolerances, open edges"
    DOING = "Checking"
    HIDES = True
    TABLED = ("Problems", "Grades")
    LINKS = (Link("Part", "Object", "What is checked"),)
    FACTS = (
        Fact("Verdict", "word", "sound or not sound"),
        Fact("Problems", "words", "Each with the face or edge that has it"),
        Fact("Gap", "length", "The largest between curves and surfaces, mm"),
        Fact("StatedTolerance", "length", "The largest of edges and vertices, mm"),
        Fact("OpenEdges", "count", "Edges of one face only"),
        Fact("Grades", "counts", "Of each face: 0 sound, 1 beside a faulty edge, 2 faulty"),
    )

    def inputs(self, obj):
        return {"Part": links.faces(obj.Part, "Part")}

    def ask(self, entrance, inputs, options):
        return entrance.check(inputs["Part"])

    def facts(self, report):
        summary = report["summary"]
        return {
            "Verdict": report["verdict"],
            "Problems": [f"{element or 'all'}: {what}" for element, what in problems(report)],
            "Gap": summary["gap"],
            "StatedTolerance": summary["tolerance"],
            "OpenEdges": summary["free_edges"],
            "Grades": _grades(report),
        }

    def shape(self, obj, answer, inputs):
        return inputs["Part"]

    def colours(self, obj):
        return [(SOUND, BESIDE, FAULTY)[grade] for grade in obj.Grades]


def problems(report):
    """Pairs of what has it, "Face3", "Edge5" or "", and the problem in words."""
    found = [("", text) for text in report["problems"]]
    for kind in ("face", "edge"):
        for each in report[f"{kind}s"]:
            found += [(f"{kind.title()}{each['number']}", text) for text in each["problems"]]
    return found


def _grades(report):
    grades = {face["number"]: 2 if face["problems"] else 0 for face in report["faces"]}
    for edge in report["edges"]:
        if edge["problems"]:
            for face in edge["faces"]:
                grades[face] = max(grades[face], 1)
    return [grades[number] for number in sorted(grades)]
