# SPDX-License-Identifier: LGPL-2.1-or-later
"""How solids lie to each other: which penetrate, touch or hold each other, and how far others are."""

import Part

from . import links
from .feature import TOLERANCE, Choice, Fact, Feature, Link

PARTS, COMMON = SHOWN = ("parts", "common bodies")
CLASHES = ("penetrates", "contained", "equal")
CLEAR, NEAR, TOUCHES, IN_CONFLICT = range(4)  # grades of parts
COLOURS = ((0.70, 0.76, 0.80), (0.97, 0.86, 0.42), (0.96, 0.64, 0.25), (0.86, 0.22, 0.20))


class Clash(Feature):
    NAME = "Clash"
    TITLE = "Clash"
    TIP = "Solids that penetrate, touch or hold each other, and how far others are apart"
    DOING = "Looking for clashes"
    HIDES = True
    TABLED = ("Pairs", "Grades", "Solids")
    LINKS = (
        Link("A", "Objects", "Solids that are compared"),
        Link("B", "Other objects", "Solids that they are compared with; none: each other"),
    )
    CHOICES = (
        Choice("Clearance", "length", "0 mm", "Clearance",
               "Distances up to this are measured, and smaller ones shown; 0: only of pairs that "
               "are near each other"),
        Choice("Show", "word", PARTS, "Show", "All solids in colours, or what they have in common",
               SHOWN),
        TOLERANCE,
    )  # fmt: skip
    FACTS = (
        Fact("Status", "word", "The weakest of all pairs"),
        Fact("Clashes", "count", "Pairs that have an inside in common"),
        Fact("Touching", "count", "Pairs that touch"),
        Fact("TooNear", "count", "Pairs that are nearer than the clearance, and clear"),
        Fact("FarApart", "count", "Pairs that are not listed, as they are farther apart"),
        Fact("Volume", "volume", "Of all that pairs have in common, cubic mm"),
        Fact("Pairs", "words", "Each pair that was looked at, as a line"),
        Fact("Solids", "words", "What solids are called"),
        Fact("Grades", "counts", "Of each solid: 0 clear, 1 too near, 2 touches, 3 clashes"),
    )

    @classmethod
    def deal(cls, members):
        return [members, []]

    def inputs(self, obj):
        made = {"A": _compound(obj.A, "A")}
        if not obj.B and len(made["A"].Solids) == 1:
            (name, _), = _solids(obj.A, "A")
            raise ValueError(f"A: {name} is one solid alone; choose more, or others beside it")
        if obj.B:
            made["B"] = _compound(obj.B, "B")
        return made

    def options(self, obj):
        names = [name for name, _ in _solids(obj.A, "A") + _solids(obj.B, "B")]
        clearance = obj.Clearance.Value
        return {
            "names": names,
            "show": obj.Show,
            "clearance": clearance if clearance > 0 else None,
            "tolerance": obj.Tolerance.Value,
        }

    def ask(self, entrance, inputs, options):
        answer = entrance.clash(
            inputs["A"], inputs.get("B"), options["clearance"], tolerance=options["tolerance"]
        )
        for part, name in zip(answer.report["parts"], options["names"]):
            part["name"] = name
        return answer

    def facts(self, report):
        pairs = report["pairs"]
        near = [pair for pair in pairs if grade(pair, report) == NEAR]
        return {
            "Status": report["status"],
            "Clashes": sum(pair["relation"] in CLASHES for pair in pairs),
            "Touching": sum(pair["relation"] == "touches" for pair in pairs),
            "TooNear": len(near),
            "FarApart": sum(report["counts"].values()) - len(pairs),
            "Volume": sum(pair["common"]["volume"] for pair in pairs if pair.get("common")),
            "Pairs": [": ".join(row) for _, row in rows(report)],
            "Solids": [part["name"] for part in report["parts"]],
            "Grades": _grades(report),
        }

    def shape(self, obj, answer, inputs):
        if obj.Show == PARTS:
            return Part.makeCompound([solid for each in inputs.values() for solid in each.Solids])
        return super().shape(obj, answer, inputs)

    def nothing(self, obj):
        return "Show: no parts have a common body"

    def colours(self, obj):
        solids = obj.Shape.Solids
        if obj.Show == COMMON:
            return [COLOURS[IN_CONFLICT]] * len(obj.Shape.Faces)
        if len(solids) != len(obj.Grades):
            return None
        return [
            COLOURS[grade] for solid, grade in zip(solids, obj.Grades) for _ in solid.Faces
        ]


def faces_of_solids(obj):
    """By the places of solids the names of their faces in the object's shape; nothing if it shows
    something else."""
    if obj.Show != PARTS:
        return {}
    names, first = {}, 1
    for place, solid in enumerate(obj.Shape.Solids):
        end = first + len(solid.Faces)
        names[place] = [f"Face{number}" for number in range(first, end)]
        first = end
    return names


def grade(pair, report):
    """How bad a pair is."""
    if pair["relation"] in CLASHES:
        return IN_CONFLICT
    if pair["relation"] == "touches":
        return TOUCHES
    clearance, (lower, upper) = report["clearance"], pair.get("distance", (0, None))
    return NEAR if clearance and upper is not None and lower < clearance else CLEAR


def rows(report):
    """Pairs of places in the list of parts, with "A and B" and what they do; worst first."""
    parts = report["parts"]
    return [
        ((pair["a"], pair["b"]), (f"{parts[pair['a']]['name']} and {parts[pair['b']]['name']}",
                                  _told(pair, parts)))
        for pair in report["pairs"]
    ]  # fmt: skip


def _told(pair, parts):
    words = [pair["relation"]]
    if "inner" in pair:
        words.append(f"{parts[pair[pair['inner']]]['name']} is inside")
    if pair.get("common"):
        words.append(f"volume {pair['common']['volume']:.6g} mm³")
    if pair.get("common") and pair["relation"] != "equal":
        words.append(f"depth {pair['common']['depth'][1]:.6g} mm at most")
    if pair["relation"] == "touches" and pair.get("contacts"):
        words.append("in a " + pair["contacts"][0]["kind"])
    if pair["relation"] == "clear":
        lower, upper = pair["distance"]
        words.append(f"at least {lower:.6g} mm" if upper is None else f"distance {upper:.6g} mm")
    words += pair.get("obstacles", [])
    return ", ".join(words)


def _grades(report):
    grades = [CLEAR] * len(report["parts"])
    for pair in report["pairs"]:
        for side in ("a", "b"):
            grades[pair[side]] = max(grades[pair[side]], grade(pair, report))
    return grades


def _solids(link, name):
    """Pairs of a name and a closed solid, each solid once. throws ValueError"""
    found = []
    for target, sub in links.members(link):
        label = links.shown(target, sub)
        shape = links.solid_of(links.shape_of(target, sub, name), label)
        solids = shape.Solids
        if not solids or not all(solid.isClosed() for solid in solids):
            wrong = links.without_solid(shape, label)
            raise ValueError(f"{name}: closed solids are wanted, {wrong}")
        for number, solid in enumerate(solids, start=1):
            if not any(solid.isSame(other) for _, other in found):
                found.append((label if len(solids) == 1 else f"{label}, solid {number}", solid))
    return found


def _compound(link, name):
    solids = [solid for _, solid in _solids(link, name)]
    if not solids:
        raise ValueError(f"{name}: solids are wanted, and there are none")
    return Part.makeCompound(solids)
