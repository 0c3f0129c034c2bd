# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files and bytes become a model, whole or in parts, and none ends the program."""

import os
import pickle
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from support import FLOOR, NO_PART, Part, made_files, told_by_program

import blossom

FILES = made_files()
BLOCK = FILES / "block.step"
DRILL = FILES / "drill.step"
HULL = FILES / "hull.step"


class Reading(unittest.TestCase):
    def test_a_file_becomes_a_model(self):
        for name in (BLOCK, str(BLOCK)):
            model = blossom.read(name)
            self.assertEqual(len(model), 6)
            self.assertEqual(model.file, str(BLOCK))
            self.assertEqual(model.file_unit, "MM")
            self.assertEqual(model.counts["solids"], 1)
            self.assertEqual(set(model.part_paths), {"Block"})
            self.assertEqual(model.reading["grade"], "whole")
            self.assertEqual(repr(model), f"<blossom.Model: {BLOCK}, 6 faces>")

    def test_parts_have_names(self):
        rig = blossom.solid("split", BLOCK, DRILL).model
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "rig.step")
            rig.write(path)
            whole = blossom.read(path)
            name = whole.part_paths[0]
            told = [n for n, each in enumerate(whole.part_paths, start=1) if each == name]
            self.assertEqual(whole.part(name).face_numbers, told)
            self.assertEqual(blossom.read(f"{path}#{name}").face_numbers, told)
            self.assertEqual(blossom.read(path, f"{name},Face2").face_numbers, sorted({2, *told}))
        with self.assertRaisesRegex(ValueError, "no part and no face 'Nowhere' in it; .* 'Block'"):
            blossom.read(BLOCK).part("Nowhere")

    def test_parts_have_an_inside_and_faces_have_none(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "two.step")
            blossom.solid("split", BLOCK, planes=[((0, 0, 5), (0, 0, 1))]).to_step(path)
            two = blossom.read(path)
            low, high = sorted((two.part(name) for name in sorted(set(two.part_paths))),
                               key=lambda part: part.volume)  # fmt: skip
            self.assertAlmostEqual(low.volume, 60 * 40 * 5, 6)
            self.assertEqual(low.counts["solids"], 1)
            self.assertEqual(len(low.info(edges=True)["edges"]), 12)
            self.assertAlmostEqual(low.solid("fuse", high).volume, 60 * 40 * 20, 6)
            drilled = low.solid("cut", DRILL)
            self.assertAlmostEqual(drilled.volume, 60 * 40 * 5 - np.pi * 8**2 * 5, 6)
            self.assertEqual(two.part("solid:2").volume, blossom.read(f"{path}#solid:2").volume)
            faces = two.part(low.face_numbers)
            self.assertEqual(faces.volume, 0)
            # All faces of a solid are combined as that solid, some of them as a sheet.
            self.assertAlmostEqual(faces.solid("cut", DRILL).volume, drilled.volume, 6)
            sheet = two.part(low.face_numbers[:5]).solid("common", DRILL)
            self.assertEqual((sheet.volume, len(sheet.to_dict()["solids"])), (0, 0))

            low.write(os.path.join(folder, "low#1.step"))
            again = blossom.read(os.path.join(folder, "low#1.step"))
            self.assertEqual(set(again.part_paths), {two.part_paths[low.face_numbers[0] - 1]})
            name = again.part_paths[0]
            self.assertEqual(len(blossom.read(f"{folder}/low#1.step#{name}/Face2")), 1)

    def test_words_are_of_the_model_with_its_loose_faces_sewn(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "two.step")
            blossom.solid("split", BLOCK, planes=[((0, 0, 5), (0, 0, 1))]).to_step(path)
            whole, text = blossom.read(path), Path(path).read_text("ascii")
            volumes = {name: whole.part(name).volume for name in set(whole.part_paths)}
            # The faces of the first solid become loose ones, with another solid after them.
            shell = re.search(r"MANIFOLD_SOLID_BREP\(('[^']*'),(#\d+)\)", text)
            text = text.replace(shell[0], f"SHELL_BASED_SURFACE_MODEL({shell[1]},({shell[2]}))")
            Path(path).write_text(text.replace("CLOSED_SHELL", "OPEN_SHELL", 1), "ascii")
            self.assertEqual(blossom.read(path).counts["solids"], 1)
            for name, volume in volumes.items():
                part = blossom.read(path).part(name)
                self.assertAlmostEqual(part.volume, volume, 6)
                self.assertEqual(part.counts["solids"], 1)
                self.assertEqual(part.repairs["sewn"]["faces"], 6)
            second = blossom.read(path).part("solid:2")
            self.assertEqual(second.face_numbers, list(range(7, 13)))

    def test_files_of_triangles_are_told_what_takes_them(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "block.stl")
            blossom.read(BLOCK).write(path)
            with self.assertRaisesRegex(ValueError, r"is of triangles, which from_mesh\(\) takes"):
                blossom.read(path)

    def test_lost_shapes_are_warned_of(self):
        text = BLOCK.read_text().replace("ADVANCED_FACE", "ADVANCED_FARCE", 1)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "broken.step")
            path.write_text(text)
            with self.assertWarnsRegex(UserWarning, "shapes are missing or not as they are"):
                model = blossom.read(path)
        self.assertEqual(model.reading["grade"], "shapes lost")

    def test_what_a_written_file_lacks_is_warned_of(self):
        text = BLOCK.read_text()
        at = text.index("ENDSEC;", text.index("DATA;"))
        approved = "#9001=APPROVAL_STATUS('yes');\n#9002=APPROVAL(#9001,'');\n"
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "approved.step")
            path.write_text(text[:at] + approved + text[at:])
            out = Path(folder, "out.step")
            model = blossom.read(path)
            ways = (
                lambda: model.write(out),
                lambda: model.to_step(out),
                lambda: blossom.write(path, out),
                lambda: blossom.convert(path, out),
                lambda: pickle.dumps(model),
            )
            for way in ways:
                with self.assertWarnsRegex(UserWarning, "written without 1 approval of") as told:
                    way()
                self.assertEqual(told.filename, __file__)

    def test_no_file_ends_the_program(self):
        text = BLOCK.read_text()
        nested = "#1=POINT(" + "(" * 200_000 + ")" * 200_000 + ");\nENDSEC;\nEND-ISO-10303-21;\n"
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "deep.step")
            path.write_text(text[: text.index("DATA;") + 6] + nested)
            with self.assertRaisesRegex(ValueError, "crashes while reading the entities"):
                blossom.read(path)

    @unittest.skipUnless(sys.platform == "linux", "only there memory is bounded like that")
    def test_want_of_memory_does_not_end_the_program(self):
        lines = """if True:
            import resource, sys
            import blossom
            pages = int(open("/proc/self/statm").read().split()[0])
            most = pages * resource.getpagesize() + int(sys.argv[1]) * 2**20
            resource.setrlimit(resource.RLIMIT_AS, (most, most))
            try:
                blossom.read(sys.argv[2])
            except (MemoryError, ValueError, blossom.Error):
                pass
        """
        for megabytes in (4, 8, 16, 24, 32, 64):
            ran = subprocess.run(
                [sys.executable, "-c", lines, str(megabytes), str(HULL)],
                env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
                capture_output=True,
                text=True,
            )
            self.assertEqual(ran.returncode, 0, f"{megabytes} MB: {ran.stderr}")

    def test_no_bytes_end_the_program(self):
        text = blossom.shape(FLOOR).to_brep().decode()
        at = re.search(r"\nCurves \d+\n", text).end()
        # A trimmed curve of a trimmed curve, and so on.
        with self.assertRaisesRegex(ValueError, "crashes while reading the shapes"):
            blossom.check(text[:at] + "8 0 1 " * 300_000 + text[at:])

    def test_faces_of_damaged_entities_are_those_of_the_program(self):
        text = re.sub(r"(EDGE_CURVE\('[^']*',#\d+,#\d+),#\d+", r"\1,$", BLOCK.read_text(), count=1)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "broken.step")
            path.write_text(text)
            with self.assertWarnsRegex(UserWarning, "shapes are missing or not as they are"):
                model = blossom.read(path)
            self.assertEqual(model.counts, told_by_program("info", str(path))["counts"])
            self.assertEqual(model.counts["faces"], 6)

    @unittest.skipIf(Part is None, NO_PART)
    def test_faces_of_no_width_are_left_out_and_warned_of(self):
        there, back = Part.makeLine((5, 0, 0), (9, 0, 0)), Part.makeLine((9, 0, 0), (5, 0, 0))
        line = Part.Face(Part.Plane(), Part.Wire([there, back]))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "line.brep")
            Part.makeCompound([line, *Part.makeBox(1, 2, 3).Faces[:3]]).exportBrep(str(path))
            model = blossom.read(path)
            for ask in (
                lambda: model.self_intersect(faces=True),
                lambda: model.ray((0.5, 9, 1), (0, -1, 0)),
                lambda: model.section((0, 0, 1), (0, 0, 1)),
                lambda: model.intersect(path),
            ):
                with self.assertWarnsRegex(UserWarning, "face 1 has no width and is left out"):
                    self.assertEqual(ask().status, "tolerance")
            with self.assertRaisesRegex(ValueError, "parameter box in v is empty"):
                model.part([1]).self_intersect()

    @unittest.skipIf(Part is None, NO_PART)
    def test_solids_keep_their_inside_beside_a_face_that_is_left_out(self):
        there, back = Part.makeLine((5, 0, 0), (9, 0, 0)), Part.makeLine((9, 0, 0), (5, 0, 0))
        line = Part.Face(Part.Plane(), Part.Wire([there, back]))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "stray.brep")
            Part.makeCompound([line, Part.makeBox(10, 10, 10)]).exportBrep(str(path))
            model = blossom.read(path)
        cube = Part.makeBox(1, 1, 1)
        cube.translate((4, 4, 4))
        with self.assertWarnsRegex(UserWarning, "face 1 has no width and is left out"):
            self.assertAlmostEqual(model.mass().volume, 1000, 6)
        with self.assertWarnsRegex(UserWarning, "face 1 has no width and is left out"):
            self.assertEqual(model.distance(cube).relation, "b inside a")

    def test_reading_ends_at_a_time_limit_and_by_a_handle(self):
        with self.assertRaisesRegex(blossom.Error, "the time limit of 1e-9 s was reached"):
            blossom.read(BLOCK, time_limit=1e-9)
        cancel = blossom.Cancel()
        cancel.cancel()
        with self.assertRaises(blossom.Cancelled):
            blossom.read(BLOCK, cancel=cancel)

    def test_results_outlive_the_models_that_they_are_of(self):
        drilled = blossom.read(BLOCK).solid("cut", DRILL)
        again = blossom.shape(drilled).solid("cut", planes=[((0, 0, 10), (0, 0, 1))])

        self.assertAlmostEqual(again.volume, drilled.volume / 2, 4)
        self.assertEqual(set(blossom.shape(again).part_paths), {"Block"})

    def test_faces_keep_their_numbers(self):
        part = blossom.read(BLOCK, faces=[5, 3, 3])
        self.assertEqual(part.face_numbers, [3, 5])
        self.assertEqual(part.name, f"{BLOCK}#3,5")
        self.assertEqual([face.face_numbers for face in part], [[3], [5]])
        found = part.section((0, 0, 10), (0, 0, 1)).to_dict()
        self.assertLessEqual({curve["on"]["number"] for curve in found["curves"]}, {3, 5})

    def test_faces_and_edges_are_named_as_other_programs_do(self):
        for named in (f"{BLOCK}#Face3,5", f"{BLOCK}#face:3,Face5", f"{BLOCK}#5,3-3"):
            self.assertEqual(blossom.read(named).face_numbers, [3, 5])
        self.assertEqual(blossom.read(BLOCK, faces="Face3").face_numbers, [3])
        self.assertEqual(blossom.read(BLOCK, faces=["Face3", 4]).face_numbers, [3, 4])
        self.assertEqual(blossom.read(BLOCK).face("Face3").name, f"{BLOCK}#3")
        self.assertAlmostEqual(blossom.distance(f"{BLOCK}#Face1", f"{BLOCK}#Face2").distance, 60)
        block = blossom.read(BLOCK)
        for edges in ("Edge3", ["Edge3"], ["edge:3"]):
            self.assertEqual(block.fillet(edges, radius=2).volume, block.fillet([3], radius=2).volume)
        self.assertEqual(block.fillet(radius={"Edge3": 2}).volume, block.fillet([3], radius=2).volume)
        with self.assertRaisesRegex(ValueError, "block.step: there is no part and no face 'Shaft' in it; there is 'Block'$"):
            blossom.read(f"{BLOCK}#Shaft")
        with self.assertRaisesRegex(ValueError, "^path: there is no face 999999999 in it, it has 6$"):
            blossom.read(f"{BLOCK}#1-999999999")
        with self.assertRaisesRegex(ValueError, "^numbers: 'Edge3' is no face"):
            block.part(["Edge3"])

    def test_what_cannot_be_read_is_told(self):
        with self.assertRaisesRegex(ValueError, "none.step"):
            blossom.read(FILES / "none.step")
        with self.assertRaisesRegex(ValueError, "there is no face 9"):
            blossom.read(BLOCK, faces=[9])
        with self.assertRaisesRegex(TypeError, "^path: a str or a Path is wanted, got int; shape.. takes shapes$"):
            blossom.read(7)
        with self.assertRaisesRegex(TypeError, "^strict: True or False is wanted, got int$"):
            blossom.read(BLOCK, strict=1)

    def test_files_go_where_files_go(self):
        self.assertAlmostEqual(blossom.distance(str(BLOCK), DRILL).distance, 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
