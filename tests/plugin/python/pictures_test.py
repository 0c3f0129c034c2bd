# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages, pictures and models to look at: the files of the command line, byte by byte."""

import os
import pickle
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

import blossom
import support

FILES = support.made_files()
BLOCK, DRILL = str(FILES / "block.step"), str(FILES / "drill.step")
HULL, CUTTERS = str(FILES / "hull.step"), str(FILES / "cutters.step")
PLANE = ((0, 0, 5), (0, 0, 1))

# What both are asked: a command with its arguments, and a question.
ASKED = {
    "info": (["info", BLOCK, "--faces"], lambda: blossom.read(BLOCK)),
    "intersect": (["intersect", HULL, CUTTERS], lambda: blossom.intersect(HULL, CUTTERS)),
    "self-intersect": (["self-intersect", HULL], lambda: blossom.self_intersect(HULL)),
    "plane": (["query", "plane", BLOCK, "--point=0,0,5", "--normal=0,0,1"],
              lambda: blossom.section(BLOCK, *PLANE)),
    "planes": (["query", "plane", BLOCK, "--offsets=5:10:2"],
               lambda: blossom.sections(BLOCK, offsets=(5, 10))),
    "clash": (["clash", BLOCK, DRILL], lambda: blossom.clash(BLOCK, DRILL)),
    "trim": (["trim", HULL, CUTTERS, "--keep=all"],
             lambda: blossom.trim(HULL, CUTTERS, keep="all")),
    "solid": (["trim", BLOCK, DRILL, "--solid=cut"], lambda: blossom.solid("cut", BLOCK, DRILL)),
    "fillet": (["blend", "fillet", BLOCK, "--edges=1,3", "--radius=2"],
               lambda: blossom.fillet(BLOCK, [1, 3], radius=2)),
    "chamfer": (["blend", "chamfer", BLOCK, "--edges=all", "--distance=2"],
                lambda: blossom.chamfer(BLOCK, "all", distance=2)),
    "check": (["check", HULL], lambda: blossom.read(HULL).check()),
    "continuity": (["check", "--continuity", HULL], lambda: blossom.read(HULL).continuity()),
    "subdivide": (["subdivide", f"{HULL}#1"], lambda: blossom.read(HULL).face(1).subdivide()),
    "whole": (["subdivide", f"{HULL}#1", "--whole"],
              lambda: blossom.read(HULL).face(1).subdivide(whole=True)),
}  # fmt: skip


class Pictures(unittest.TestCase):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = Path(made.name)

    def test_files_are_those_of_the_command_line(self):
        for name, (command, ask) in ASKED.items():
            with self.subTest(name):
                theirs = {form: self.folder / f"theirs.{form}" for form in ("png", "html", "glb")}
                subprocess.run(
                    [os.environ["BLOSSOM_PROGRAM"], *command, "-q", "--size=400x300",
                     "--picture", theirs["png"]], check=False,
                )  # fmt: skip
                subprocess.run(
                    [os.environ["BLOSSOM_PROGRAM"], *command, "-q",
                     "--html", theirs["html"], "--glb", theirs["glb"]], check=False,
                )  # fmt: skip
                answer = ask()
                answer.to_png(self.folder / "ours.png", size=(400, 300))
                answer.to_html(self.folder / "ours.html")
                answer.to_glb(self.folder / "ours.glb")
                for form, file in theirs.items():
                    ours = self.folder / f"ours.{form}"
                    self.assertTrue(ours.read_bytes() == file.read_bytes(), form)

    def test_sizes_and_views_are_those_that_are_asked_for(self):
        file = self.folder / "block.png"
        pictures = set()
        for view in ("top", "front", (1, 2, 3)):
            blossom.read(BLOCK).to_png(file, view=view, size=(300, 200))
            pictures.add(file.read_bytes())
            self.assertEqual(struct.unpack(">II", file.read_bytes()[16:24]), (300, 200))
        self.assertEqual(len(pictures), 3)
        smooth = blossom.read(HULL).continuity()
        smooth.to_png(file)
        plain = file.read_bytes()
        smooth.to_png(file, zebra=True)
        self.assertNotEqual(file.read_bytes(), plain)

    def test_what_has_no_picture_of_its_own_shows_its_shape(self):
        made = blossom.read(BLOCK).convert("triangles")
        made.to_glb(self.folder / "triangles.glb")
        self.assertEqual((self.folder / "triangles.glb").read_bytes()[:4], b"glTF")
        with self.assertRaisesRegex(blossom.Error, "Distance: there is no shape in this answer"):
            blossom.distance(BLOCK, DRILL).to_png(self.folder / "distance.png")

    def test_meshes_are_shown_too(self):
        mesh = blossom.from_mesh(blossom.read(BLOCK).mesh())
        other = blossom.read(DRILL)
        for name, shown in (("mesh", mesh), ("made", blossom.read(BLOCK).mesh()),
                            ("check", mesh.check()), ("met", mesh.intersect(other)),
                            ("cut", mesh.section(*PLANE))):  # fmt: skip
            with self.subTest(name):
                shown.to_html(self.folder / f"{name}.html")
                self.assertIn(b"triangle", (self.folder / f"{name}.html").read_bytes()[-20000:])

    def test_a_picture_stays_that_of_the_answer_when_the_model_is_sewn(self):
        loose = blossom.shape(blossom.read(BLOCK).part("1-6").to_brep())
        found = loose.intersect(DRILL)
        found.to_glb(self.folder / "before.glb")
        loose.sew()
        found.to_glb(self.folder / "after.glb")
        before, after = ((self.folder / f"{n}.glb").read_bytes() for n in ("before", "after"))
        self.assertEqual(len(before), len(after))

    def test_sections_have_drawings_by_name(self):
        cut = blossom.section(BLOCK, *PLANE)
        cut.to_dxf(self.folder / "cut.dxf")
        cut.to_svg(self.folder / "cut.svg")
        self.assertIn(b"<svg", (self.folder / "cut.svg").read_bytes())
        with self.assertRaisesRegex(ValueError, "path: .*cut.dxf does not end with .svg"):
            cut.to_svg(self.folder / "cut.dxf")

    def test_what_cannot_be_is_refused_in_words(self):
        block, file = blossom.read(BLOCK), self.folder / "a.png"
        for kind, words, ask in (
            (ValueError, "path: .*a.png does not end with .html", lambda: block.to_html(file)),
            (TypeError, "path: a str or a Path is wanted", lambda: block.to_png(3)),
            (ValueError, "view: iso, front.* is wanted, not 'up'", lambda: block.to_png(file, view="up")),
            (ValueError, "view: the zero vector", lambda: block.to_png(file, view=(0, 0, 0))),
            (TypeError, "view: three numbers are wanted", lambda: block.to_png(file, view=3)),
            (ValueError, "size: pixels from 100 to 8000", lambda: block.to_png(file, size=(50, 200))),
            (TypeError, "size: a whole number", lambda: block.to_png(file, size=(500.5, 200))),
            (ValueError, "size: a width and a height", lambda: block.to_png(file, size=(500,))),
            (TypeError, "there is no option 'sise'", lambda: block.to_png(file, sise=(500, 200))),
            (blossom.Error, "Fillet: there is no shape.*the largest that works",
             lambda: block.fillet([1], radius=100).to_png(file)),
            (blossom.Error, "folder '/nowhere' does not exist", lambda: block.to_png("/nowhere/a.png")),
            (blossom.Error, "that were not pickled",
             lambda: pickle.loads(pickle.dumps(block.check())).to_png(file)),
        ):  # fmt: skip
            with self.subTest(words), self.assertRaisesRegex(kind, words):
                ask()
        self.assertFalse(file.exists())

    def test_a_cancelled_picture_is_not_written(self):
        cancel = blossom.Cancel()
        cancel.cancel()
        with self.assertRaises(blossom.Cancelled):
            blossom.read(BLOCK).to_html(self.folder / "a.html", cancel=cancel)
        self.assertFalse((self.folder / "a.html").exists())

    @unittest.skipIf(support.Part is None, support.NO_PART)
    def test_shapes_of_freecad_are_shown_without_a_window(self):
        box = support.Part.makeBox(10, 20, 30)
        blossom.shape(box).to_html(self.folder / "box.html")
        blossom.intersect(box, support.Part.makeSphere(15)).to_png(self.folder / "box.png")
        self.assertGreater((self.folder / "box.png").stat().st_size, 1000)


if __name__ == "__main__":
    unittest.main()
