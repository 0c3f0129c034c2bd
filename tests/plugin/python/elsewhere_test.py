# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where another Open CASCADE is loaded before ours, the program answers, and says the same."""

import ctypes
import json
import os
import pickle
import subprocess
import sys
import tempfile
import threading
import unittest
import warnings
from pathlib import Path

OTHER = os.environ["BLOSSOM_OTHER_KERNEL"]
IS_CHILD = os.environ.get("BLOSSOM_TEST_ELSEWHERE") == "yes"
if IS_CHILD:
    ctypes.CDLL(OTHER)

with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    import blossom

import support  # noqa: E402

PLANE = ((0, 0, 5), (0, 0, 1))


def questions(block, drill):
    """Answers by what they are called; some are made when they are asked for."""
    return {
        "intersect": lambda: block.intersect(drill),
        "intersect, nothing": lambda: block.face(6).intersect(block.face(5), tolerance=1e-6),
        "intersect, an edge": lambda: block.part("edge:1").intersect(drill),
        "self_intersect": lambda: block.self_intersect(faces=True),
        "section": lambda: block.section(*PLANE),
        "sections": lambda: block.sections(offsets=(5, 10), point=(-1, 0, 0)),
        "sections, planes": lambda: block.sections(planes=[(*PLANE, "middle")]),
        "trim": lambda: block.trim(drill, keep="outside"),
        "trim, planes": lambda: block.trim(planes=[PLANE], keep="below"),
        "cut": lambda: block.solid("cut", drill),
        "split": lambda: block.solid("split", planes=[PLANE]),
        "fillet": lambda: block.fillet([1, 3], radius=2),
        "fillet, law": lambda: block.fillet([1], radius=(2, 5), section="conic:0.4"),
        "fillet, own": lambda: block.fillet(radius={1: 2, 3: (2, 4), None: 1}),
        "fillet, refused": lambda: block.fillet("all", radius=100),
        "full round": lambda: block.fillet([9, 10], full_round=True),
        "chamfer": lambda: block.chamfer("convex", distance=(2, 1)),
        "clash": lambda: block.clash(drill, clearance=1),
        "check": lambda: block.check(),
        "continuity": lambda: block.continuity(require="G1"),
        "distance": lambda: block.distance(drill),
        "does_intersect": lambda: block.does_intersect(drill),
        "foot_points": lambda: block.foot_points((30, 20, 23)),
        "ray": lambda: block.ray((30, 10, 50), (0, 0, -1), line=True),
        "mass": lambda: block.mass(),
        "mesh": lambda: drill.mesh(0.05),
        "bezier": lambda: block.convert("bezier"),
        "monomial": lambda: block.convert("monomial"),
        "subdivide": lambda: block.face(1).subdivide((0, 10, -10, 0)),
        "whole": lambda: block.face(1).subdivide(whole=True),
        "strip": lambda: blossom.blend_strip(block.face(1), block.face(2), continuity="G2"),
        "fill": lambda: blossom.fill(block.part("1-5").to_brep(), continuity="G0"),
    }


def answers(folder):
    """Reports of all questions, about files and about bytes."""
    os.chdir(folder)
    block, drill = blossom.read("block.step"), blossom.read("drill.step")
    told = {"info": block.info(edges=True, faces=True)}
    for model in (blossom.read("cutters.step"), block.part("Block")):
        told[model.name] = [model.counts, model.face_names, model.part_paths, model.face_numbers]
        told[model.name] += [model.file, model.file_unit, model.reading]
    told["repairs"] = block.repairs
    for name, ask in questions(block, drill).items():
        told[name] = ask().to_dict()
    by_bytes = [blossom.shape(each.to_brep(), name) for each, name in ((block, "a"), (drill, "b"))]
    for name in ("intersect", "section", "trim", "cut", "fillet", "check"):
        told[f"{name}, bytes"] = questions(*by_bytes)[name]().to_dict()
    return told


def without_times(report):
    """A report without what differs from run to run."""
    if isinstance(report, list):
        return [without_times(each) for each in report]
    if isinstance(report, dict):
        return {k: without_times(v) for k, v in report.items() if not k.startswith("seconds")}
    return report


class Elsewhere(unittest.TestCase):
    maxDiff = 2000
    """In a process of its own."""

    @classmethod
    def setUpClass(cls):
        cls.folder = support.made_files()

    def test_answers_are_those_in_process(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "answers.json")
            child = {**os.environ, "BLOSSOM_TEST_ELSEWHERE": "yes", "BLOSSOM_TEST_FOLDER": str(self.folder)}
            done = subprocess.run(
                [sys.executable, "-B", __file__, str(file)],
                env=child, capture_output=True, text=True, check=False,
            )  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            elsewhere = json.loads(file.read_text())
        here = json.loads(json.dumps(answers(self.folder)))
        self.assertEqual(here.keys(), elsewhere.keys())
        for name, report in here.items():
            with self.subTest(name):
                self.assertEqual(without_times(elsewhere[name]), without_times(report))


def claim(words, holds):
    """In the child."""
    if not holds:
        raise AssertionError(words)


def refused(kind, words, ask):
    try:
        ask()
    except kind as error:
        claim(f"{words} is in: {error}", words in str(error))
    else:
        claim(f"{words}: nothing is refused", False)


def claims_elsewhere(folder):
    """What a process with another Open CASCADE sees beside reports."""
    claim("our engine is not loaded", not any("_core." in line for line in open("/proc/self/maps")))
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        block, drill = (blossom.read(folder / f"{name}.step") for name in ("block", "drill"))
    claim(f"it is said once: {heard}", [OTHER in str(each.message) for each in heard] == [True])
    claim("with the line that asked", heard[0].filename == __file__)
    os.chdir("/")
    made = block.solid("cut", drill)
    claim("an answer goes on", round(made.model.volume, 3) == 43978.761)
    claim("with its names", set(made.model.face_names) == {"Block"})
    claim("by pickle too", pickle.loads(pickle.dumps(made)).model.face_count == 7)
    found = block.intersect(drill)
    claim("curves are arrays", [curve.points.shape for curve in found] == [(43, 3), (43, 3)])
    claim("not to be written to", not found.curves[0].points.flags.writeable)
    claim("with parameters", found.curves[0].uv_b.shape == (43, 2) and repr(found.curves[0]))
    claim("and chains", [len(wire) for wire in found.wires] == [1, 1])
    refused(blossom.Error, "Curve.poles is not in the program's report", lambda: found.curves[0].poles)
    claim("nothing is an empty shape", b"TShapes 1" in block.face(5).intersect(block.face(6)).to_brep())
    wires = block.section(*PLANE)
    claim("sections have wires", [wire.length for wire in wires] == [200])
    wires.write(folder / "elsewhere.dxf")
    claim("and drawings", (folder / "elsewhere.dxf").stat().st_size > 0)
    for name, shown in (("section", wires), ("model", block), ("curves", found), ("solid", made)):
        for show, ending in ((shown.to_html, "html"), (shown.to_png, "png"), (shown.to_glb, "glb")):
            show(folder / f"{name}.{ending}")
            claim(f"a .{ending} of {name} is there", (folder / f"{name}.{ending}").stat().st_size > 1000)
    refused(ValueError, "view: iso, front", lambda: block.to_png(folder / "a.png", view="up"))
    refused(ValueError, "size takes WIDTHxHEIGHT", lambda: block.to_png(folder / "a.png", size=(1, 1)))
    refused(blossom.Error, "there is no shape in this answer", lambda: block.distance(drill).to_png(folder / "a.png"))
    mesh = drill.mesh(0.05)
    claim("triangles are arrays", len(mesh.triangles) == len(mesh.faces) and set(mesh.groups) == {1, 2, 3})
    mesh.write(folder / "elsewhere.stl")
    os.chdir(folder)
    blossom.write(made, "elsewhere.step")
    claim("files have all", blossom.read(folder / "elsewhere.step").face_count == 7)
    loose = blossom.shape(block.part("1-5").to_brep())
    claim("loose faces stay loose", blossom.shape(loose.to_brep()).counts["solids"] == 0)
    claim("nets are arrays", block.face(1).subdivide()[0].points.shape == (2, 2, 3))
    claim("and inputs", blossom.intersect(support.FLOOR, support.WALL).curves[0].length == 2)


def a_file_may_change(folder):
    """What was read stays, and what a copy lacks is warned of."""
    text = (folder / "block.step").read_text()
    at = text.index("ENDSEC;", text.index("DATA;"))
    approved = "#9001=APPROVAL_STATUS('yes');\n#9002=APPROVAL(#9001,'');\n"
    file = folder / "approved.step"
    file.write_text(text[:at] + approved + text[at:])
    model = blossom.read(file)
    file.unlink()
    claim("a part counts its own", model.face(1).counts["faces"] == 1)
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        model.write(folder / "copy.step")
    claim(f"it is warned: {heard}", ["without 1 approval" in str(each.message) for each in heard] == [True])


def refusals(block, folder):
    """What cannot be had is said."""
    refused(ValueError, "no such file", lambda: blossom.read("none.step"))
    refused(ValueError, "shape: is no BREP file", lambda: blossom.shape(b"junk"))
    refused(ValueError, "shape", lambda: blossom.shape(block.to_brep()[:-900]))
    refused(ValueError, "not finite", lambda: blossom.intersect(support.FLOOR * float("nan"), block))
    refused(ValueError, "planes, line 1: the normal of", lambda: block.sections([((0, 0, 1), (0, 0, 0))]))
    refused(blossom.Error, "/nowhere/a.png: the folder '/nowhere'", lambda: block.to_png("/nowhere/a.png"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # no file of the package's own is one that the user wants
        block.face(6).intersect(block.face(5))
        nothing = block.section((0, 0, 50), (0, 0, 1))
        refused(blossom.Error, "there is nothing to draw", lambda: nothing.write(folder / "a.dxf"))
    refused(ValueError, "no face 99", lambda: block.face(99))
    refused(ValueError, "Shaft", lambda: block.part("Shaft"))
    refused(ValueError, "edge 99", lambda: block.fillet([99], radius=1))
    refused(blossom.Error, "watertight() is not to be had of the program", block.watertight)
    refused(blossom.Error, "another Open CASCADE", lambda: blossom.from_mesh(str(folder / "elsewhere.stl")))
    cancel = blossom.Cancel()
    threading.Timer(0.2, cancel.cancel).start()
    hard = [blossom.shape(net) for net in support.HARD]
    refused(blossom.Cancelled, "cancelled",
            lambda: hard[0].intersect(hard[1], cancel=cancel, **support.HARD_OPTIONS))  # fmt: skip
    seen = []
    stopped = hard[0].intersect(hard[1], time_limit=0.3, progress=seen.append, **support.HARD_OPTIONS)
    claim("limits and progress are known", stopped.status == "stopped" and len(seen) > 3)
    os.environ["BLOSSOM_PROGRAM"], os.environ["PATH"] = "", ""
    refused(blossom.Error, "there is no program 'blossom' on the PATH", block.check)


if __name__ == "__main__":
    if IS_CHILD:
        folder = Path(os.environ["BLOSSOM_TEST_FOLDER"])
        claim("an import says nothing", not said)
        claims_elsewhere(folder)
        a_file_may_change(folder)
        with open(sys.argv[1], "w", encoding="utf-8") as stream:
            json.dump(answers(folder), stream)
        refusals(blossom.read("block.step"), folder)
    else:
        unittest.main()
