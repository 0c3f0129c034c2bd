# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections with many planes, and clashes of parts: figures by hand, and the command line's reports."""

import math
import pickle
import tempfile
import unittest
from pathlib import Path

import blossom
import numpy as np
import support

FILES = support.made_files()
BLOCK = blossom.read(FILES / "block.step")
DRILL = FILES / "drill.step"  # of radius 8, from top to bottom and beyond
NOTHING = BLOCK.section((0, 0, 50), (0, 0, 1)).to_brep()  # an empty compound


class Sections(unittest.TestCase):
    def test_offsets_are_parallel_planes_along_the_normal(self):
        made = BLOCK.sections(offsets=(0, 5, 21), normal=(0, 0, 7))

        self.assertEqual([plane.offset for plane in made], [0, 5, 21])
        self.assertEqual([plane.length for plane in made], [200, 200, 0])
        self.assertEqual([len(plane.parts) for plane in made], [1, 1, 0])
        np.testing.assert_allclose([plane.area for plane in made], [2400, 2400, 0])
        self.assertEqual(made[1].name, "plane 2, offset 5")
        np.testing.assert_allclose(made[1].normal, (0, 0, 1))
        np.testing.assert_allclose(made[1].wires[0].points[:, 2], 5)
        self.assertEqual(repr(made), "<blossom.Sections: complete, 3 planes, 2 wires>")

    def test_listed_planes_have_names_and_curves_their_splines(self):
        planes = [((0, 0, 5), (0, 0, 1)), ((10, 0, 0), (1, 0, 0), "cut")]
        made = blossom.sections(DRILL, planes)

        self.assertEqual([plane.name for plane in made], ["plane 1", "cut"])
        part = made[0].parts[0]
        self.assertEqual((part.part, part.solid, part.status), ("Drill", True, "complete"))
        self.assertAlmostEqual(part.wires[0].length, 2 * math.pi * 8, 6)
        self.assertAlmostEqual(part.wires[0].area, math.pi * 64, 6)
        self.assertEqual(part.curves[0].degree, 2)
        self.assertEqual(part.curves[0].weights.shape, part.curves[0].poles.shape[:1])

    def test_those_that_meet_nothing_are_an_empty_compound(self):
        made = BLOCK.sections(offsets=(50, 60))

        self.assertEqual(made.to_brep(), NOTHING)
        with self.assertRaisesRegex(blossom.Error, "Sections: there is no shape in this answer"):
            made.write("nothing.step")

    def test_each_is_that_of_one_plane(self):
        one = BLOCK.section((0, 0, 5), (0, 0, 1))
        many = BLOCK.sections([((0, 0, 5), (0, 0, 1))])

        self.assertAlmostEqual(many[0].length, sum(wire.length for wire in one))
        self.assertEqual(len(many[0].parts[0].curves), len(one.curves))

    def test_the_report_is_that_of_the_command_line(self):
        told = support.told_by_program("query", "plane", FILES / "block.step", "--offsets", "0:20:3")
        mine = BLOCK.sections(offsets=(0, 10, 20)).to_dict()

        self.assertEqual(support.without_times(mine), support.without_times(told))

    def test_reports_may_leave_out_samples(self):
        made = BLOCK.sections(offsets=(5, 10))
        again = pickle.loads(pickle.dumps(made))
        full, short = made.to_dict(), made.to_dict(samples=False)

        self.assertEqual(short, again.to_dict(samples=False))
        curve = full["planes"][0]["parts"][0]["curves"][0]
        del curve["points"]
        self.assertEqual(curve, short["planes"][0]["parts"][0]["curves"][0])
        self.assertEqual(again.to_dict(), made.to_dict())
        found = BLOCK.intersect(DRILL).to_dict(samples=False)
        self.assertFalse({"points", "uv_a", "uv_b"} & set(found["curves"][0]))
        self.assertIn("points", found)

    def test_answers_pickle_with_curves_and_shape(self):
        made = pickle.loads(pickle.dumps(BLOCK.sections(offsets=(5, 10))))

        self.assertEqual(made[1].parts[0].curves[0].poles.shape, (2, 3))
        self.assertEqual(blossom.shape(made).counts["edges"], 8)

    def test_errors_are_words(self):
        for error, message, planes, options in (
            (ValueError, "^sections needs planes, or offsets", None, {}),
            (ValueError, "^sections needs planes, or offsets", [], {"offsets": [1]}),
            (TypeError, r"^planes: a list of pairs \(point, normal\) is wanted, got int", 3, {}),
            (ValueError, "^planes: there is no plane in it", [], {}),
            (ValueError, "^planes: a plane is .* got 1 members", [[(0, 0, 0)]], {}),
            (TypeError, "^offsets: a number is wanted, got str", None, {"offsets": "5"}),
            (TypeError, "^offsets: a list of numbers is wanted, got int", None, {"offsets": 5}),
            (ValueError, "^normal: the zero vector", None, {"offsets": [1], "normal": (0, 0, 0)}),
        ):
            with self.subTest(message), self.assertRaisesRegex(error, message):
                BLOCK.sections(planes, **options)


class Drawings(unittest.TestCase):
    def drawn(self, made, name):
        """The text of the file that an answer writes, and of the command line's."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / name
            made.write(file)
            return file.read_text()

    def by_program(self, model, name, *options):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / name
            support.told_by_program("query", "plane", model, *options, "-o", file)
            return file.read_text()

    def test_circles_are_such(self):
        lines = self.drawn(blossom.section(DRILL, (0, 0, 5), (0, 0, 1)), "cut.dxf").split("\n")
        circle = lines.index("CIRCLE")
        told = dict(zip(map(int, lines[circle - 1 : circle + 11 : 2]), lines[circle : circle + 12 : 2]))

        self.assertEqual(lines.count("CIRCLE"), 1)
        self.assertEqual((told[8], float(told[30])), ("PLANE_1", 5))
        self.assertAlmostEqual(float(told[40]), 8, 9)

    def test_drawings_are_those_of_the_command_line(self):
        block = FILES / "block.step"
        many, one = BLOCK.sections(offsets=(0, 10, 20)), BLOCK.section((5, 0, 0), (1, 0, 0))
        at = "--point", "5,0,0", "--normal", "1,0,0"

        for name in ("cut.dxf", "CUT.SVG"):
            with self.subTest(name):
                self.assertEqual(
                    self.drawn(many, name), self.by_program(block, name, "--offsets", "0:20:3")
                )
                self.assertEqual(self.drawn(one, name), self.by_program(block, name, *at))

    def test_wires_are_still_written_as_shapes(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "cut.step"
            BLOCK.section((0, 0, 5), (0, 0, 1)).write(file)
            self.assertEqual(blossom.read(file).counts["edges"], 4)

    def test_what_has_no_drawing_is_told(self):
        cut = BLOCK.section((0, 0, 5), (0, 0, 1))
        far = BLOCK.section((0, 0, 50), (0, 0, 1))
        cancelled = blossom.Cancel()
        cancelled.cancel()
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "cut.dxf"
            for error, message, made, options in (
                (blossom.Error, "nothing to draw, since no plane meets the model", far, {}),
                (blossom.Error, "answers that were not pickled", pickle.loads(pickle.dumps(cut)), {}),
                (ValueError, "is a drawing, which sections are written to alone", BLOCK, {}),
                (blossom.Cancelled, "cancelled", cut, {"cancel": cancelled}),
            ):
                with self.subTest(message), self.assertRaisesRegex(error, message):
                    made.write(file, **options)
            self.assertFalse(file.exists())


class Clashes(unittest.TestCase):
    def test_parts_that_penetrate_have_a_common_body(self):
        found = BLOCK.clash(DRILL)
        pair = found[0]

        self.assertEqual((found.status, found.parts), ("complete", ["Block", "Drill"]))
        self.assertEqual((pair.a, pair.b, pair.relation), ("Block", "Drill", "penetrates"))
        self.assertAlmostEqual(pair.volume, math.pi * 64 * 20, 4)
        self.assertLessEqual(pair.depth[0], pair.depth[1])
        self.assertIsNone(pair.distance)
        self.assertEqual(len(found.findings), 1)
        self.assertEqual(blossom.shape(found).counts["solids"], 1)
        self.assertEqual(repr(found), "<blossom.Clash: complete, 2 parts, 1 penetrates>")

    def test_a_clearance_makes_findings_of_near_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            far = Path(folder) / "far.brep"
            _moved_block(far)
            close, apart = (BLOCK.clash(far, clearance=c) for c in (6, 4))

        self.assertEqual([pair.relation for pair in close], ["clear"])
        self.assertAlmostEqual(close[0].distance[1], 5)
        self.assertEqual(close[0].nearest.shape, (2, 3))
        self.assertEqual((len(close.findings), len(apart.findings)), (1, 0))
        self.assertEqual(close.to_brep(), NOTHING)

    def test_the_report_is_that_of_the_command_line(self):
        files = FILES / "block.step", DRILL
        told = support.told_by_program("clash", *files, "--clearance", 1)
        mine = BLOCK.clash(DRILL, clearance=1).to_dict()

        self.assertEqual(support.without_times(mine), support.without_times(told))

    def test_answers_pickle(self):
        found = pickle.loads(pickle.dumps(blossom.clash(BLOCK, DRILL, far=True)))

        self.assertEqual(found.counts["penetrates"], 1)
        self.assertEqual(blossom.shape(found).counts["solids"], 1)

    def test_errors_are_words(self):
        with self.assertRaisesRegex(ValueError, "has one part alone; clash compares two or more"):
            BLOCK.clash()
        with self.assertRaisesRegex(ValueError, "^clearance: -1.0 is negative"):
            BLOCK.clash(DRILL, clearance=-1)
        with self.assertRaisesRegex(TypeError, "^far: True or False is wanted"):
            BLOCK.clash(DRILL, far=1)


def _moved_block(file):
    """A block 5 above the other one: what of a thick one is above z = 25."""
    tall = blossom.read(FILES / "drill.step").solid("cut", planes=[((0, 0, 25), (0, 0, -1))])
    blossom.write(tall, file)


if __name__ == "__main__":
    unittest.main(verbosity=2)
