# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets out of models: sub-patches, other forms, fills, continuity, lists of edges."""

import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

import blossom
import support

FILES = support.made_files()
BLOCK = blossom.read(FILES / "block.step")
HULL = blossom.read(FILES / "hull.step")
# x = u, y = v, z = u^2 v, so that every value can be told by hand.
CUBIC = np.array([[(i / 2, j, j * (i == 2)) for j in (0, 1)] for i in range(3)], float)


def at(net, s, t):
    """A Bezier patch at (s, t), by de Casteljau's algorithm."""
    for x in (s, t):
        while len(net) > 1:
            net = (1 - x) * net[:-1] + x * net[1:]
        net = net[0]
    return net


def open_box():
    """A block without its top."""
    return blossom.shape(BLOCK.part([n for n in BLOCK.face_numbers if n != 6]).to_brep())


class Subdivisions(unittest.TestCase):
    def test_a_sub_patch_is_the_patch_there(self):
        made = blossom.subdivide(CUBIC, (0.25, 0.75, 0.5, 1.0))

        (piece,) = made
        self.assertEqual((piece.kind, piece.form, piece.degree), ("patch", "bezier", (2, 1)))
        self.assertEqual((piece.u, piece.v, piece.face), ((0.25, 0.75), (0.5, 1.0), 1))
        for s, t in ((0, 0), (0.5, 0.5), (1, 1), (0.3, 0.8)):
            u, v = 0.25 + 0.5 * s, 0.5 + 0.5 * t
            np.testing.assert_allclose(at(piece.points, s, t), (u, v, u * u * v), atol=1e-15)
        self.assertEqual(blossom.shape(made).face_count, 1)

    def test_levels_make_grids(self):
        made = blossom.subdivide(CUBIC, levels=2)

        self.assertEqual(len(made), 16)
        self.assertEqual(made[0].u, (0.0, 0.25))
        self.assertEqual(repr(made), "<blossom.Subdivision: 16 pieces>")

    def test_whole_faces_and_edges_are_one_b_spline_each(self):
        (face,) = blossom.subdivide(CUBIC, (0.25, 0.75, 0.5, 1.0), whole=True)
        edges = BLOCK.subdivide(interval=(0, 1), whole=True)

        self.assertEqual((face.kind, face.degree, face.face, face.edge), ("surface", (2, 1), 1, None))
        np.testing.assert_allclose(face.knots[0], (0.25, 0.75))
        np.testing.assert_array_equal(face.multiplicities[1], (2, 2))
        np.testing.assert_allclose(face.poles[-1, -1], (0.75, 1, 0.75**2))
        self.assertEqual(len(edges), 12)
        self.assertEqual(edges[0].poles.shape, (2, 3))
        self.assertEqual(repr(pickle.loads(pickle.dumps(edges))), "<blossom.Whole: 12 B-splines>")
        self.assertEqual(blossom.shape(edges).counts["edges"], 12)
        with self.assertRaisesRegex(ValueError, "^whole: it takes a rectangle or an interval alone"):
            blossom.subdivide(CUBIC, whole=True, levels=1)

    def test_the_whole_report_is_that_of_the_command_line(self):
        options = ("--rectangle", 0, 5, -5, 0, "--whole")
        told = support.told_by_program("subdivide", f"{FILES / 'block.step'}#1", *options)
        face = blossom.read(FILES / "block.step").face(1)
        mine = face.subdivide((0, 5, -5, 0), whole=True).to_dict()

        self.assertEqual(support.without_times(mine), support.without_times(told))

    def test_a_triangle_has_rows(self):
        (piece,) = blossom.subdivide(CUBIC, triangle=((0, 0), (1, 0), (0, 1)))

        self.assertEqual((piece.kind, piece.degree), ("triangle", 3))
        self.assertEqual([len(row) for row in piece.points], [4, 3, 2, 1])
        np.testing.assert_array_equal(piece.corners, [(0, 0), (1, 0), (0, 1)])

    def test_an_interval_is_of_edges(self):
        line = blossom.curve(np.array([(0, 0, 0), (4, 0, 0)], float))

        (piece,) = line.subdivide(interval=(0.25, 0.5))
        np.testing.assert_allclose(piece.points, [(1, 0, 0), (2, 0, 0)])
        self.assertEqual((piece.kind, piece.edge, piece.face), ("curve", 1, None))
        self.assertEqual(len(BLOCK.subdivide(interval=(0, 1))), 12)

    def test_q_pieces_have_other_points(self):
        (piece,) = blossom.subdivide(CUBIC, q=(0.5, 0.6))

        self.assertEqual(piece.form, "q-bezier")
        self.assertEqual(piece.told["q"], [0.5, 0.6])

    def test_the_report_is_that_of_the_command_line(self):
        options = ("--rectangle", 0, 5, -5, 0)
        told = support.told_by_program("subdivide", f"{FILES / 'block.step'}#1", *options)
        mine = blossom.read(FILES / "block.step").face(1).subdivide((0, 5, -5, 0)).to_dict()

        told["file"] = mine["file"]
        self.assertEqual(support.without_times(mine), support.without_times(told))

    def test_errors_are_words(self):
        for error, message, options in (
            (ValueError, "^rectangle: 4 numbers are wanted, got 3", {"rectangle": (0, 1, 0)}),
            (TypeError, "^interval: 2 numbers are wanted, got int", {"interval": 1}),
            (TypeError, "^rectangle: a number is wanted, got str", {"rectangle": "0101"}),
            (ValueError, "^triangle: three pairs .* are wanted, got 2", {"triangle": [(0, 0)] * 2}),
            (ValueError, "one of rectangle, ", {"interval": (0, 1), "rectangle": (0, 1, 0, 1)}),
            (ValueError, "lies outside of the parameters", {"rectangle": (5, 6, 5, 6)}),
            (ValueError, "more than a million pieces", {"levels": 15}),
            (ValueError, "there is no edge|takes? an interval|outside", {"interval": (7, 8)}),
        ):
            with self.subTest(options), self.assertRaisesRegex(error, message):
                blossom.subdivide(CUBIC, **options)


class Conversions(unittest.TestCase):
    def test_trims_are_followed(self):
        bored = BLOCK.solid("cut", FILES / "drill.step")
        made = blossom.convert(bored, to="triangles")

        self.assertEqual(made.trims_left_out, 0)
        self.assertLess(made.error, 1e-6)
        self.assertTrue(all(net.kind == "triangle" for net in made))
        self.assertEqual({net.face for net in made}, set(blossom.shape(bored).face_numbers))

    def test_bezier_faces_have_names(self):
        made = HULL.convert("bezier")

        self.assertEqual(made.to_dict()["to"], "bezier")
        self.assertGreaterEqual(blossom.shape(made).face_count, HULL.face_count)
        self.assertEqual(len(pickle.loads(pickle.dumps(made))), len(made))

    def test_monomial_nets_have_no_shape(self):
        made = blossom.convert(CUBIC, to="monomial")

        self.assertEqual(made[0].form, "monomial")
        with self.assertRaisesRegex(blossom.Error, "there is no shape in this answer"):
            made.to_brep()

    def test_files_are_written_in_other_formats_and_forms(self):
        with tempfile.TemporaryDirectory() as folder:
            target = Path(folder) / "hull.brep"
            self.assertIsNone(blossom.convert(FILES / "hull.step", target))
            self.assertEqual(blossom.read(target).face_count, HULL.face_count)
            blossom.convert(FILES / "hull.step", target, to="bezier")
            self.assertGreaterEqual(blossom.read(target).face_count, HULL.face_count)
        with self.assertRaisesRegex(ValueError, "^to: 'nurbs' is none of bezier, monomial, tri"):
            blossom.convert(CUBIC, to="nurbs")
        with self.assertRaisesRegex(ValueError, "convert needs a target, or a form"):
            blossom.convert(CUBIC)


class Fills(unittest.TestCase):
    def test_a_hole_is_filled_and_sewn(self):
        made = open_box().fill(continuity="G0", sew=True)

        self.assertEqual((made.status, len(made), made.refused), ("complete", 1, []))
        self.assertEqual(len(made[0]["edges"]), 4)
        closed = blossom.shape(made)
        self.assertEqual(closed.face_count, 5 + made[0]["patches"])
        self.assertEqual(closed.check().to_dict()["summary"]["free_edges"], 0)
        self.assertEqual(closed.counts["solids"], 1)
        alone = blossom.fill(open_box(), continuity="G0")
        self.assertEqual(blossom.shape(alone).face_count, made[0]["patches"])

    def test_errors_are_words(self):
        for message, options in (
            ("^continuity: 'G3' is none of G0, G1, G2", {"continuity": "G3"}),
            ("^continuity: one word, or one for each", {"continuity": ["G0", "G1"]}),
            ("^layout: 'spiral' is none of auto, star", {"layout": "spiral"}),
            ("no edge is open, so there is no hole", {}),
        ):
            with self.subTest(options), self.assertRaisesRegex(ValueError, message):
                BLOCK.fill(**options)
        with self.assertRaisesRegex(TypeError, "^continuity: one of G0, .* is wanted, got int$"):
            BLOCK.fill(continuity=1)
        with self.assertRaisesRegex(ValueError, "holes are filled in whole models"):
            BLOCK.face(1).fill()


class Edges(unittest.TestCase):
    def test_info_lists_edges_if_it_is_asked(self):
        edges = blossom.info(BLOCK, edges=True)["edges"]

        self.assertEqual([edge["kind"] for edge in edges], ["convex"] * 12)
        self.assertEqual(sorted({round(edge["length"]) for edge in edges}), [20, 40, 60])
        self.assertNotIn("edges", BLOCK.info())
        told = support.told_by_program("info", "--edges", FILES / "block.step")
        self.assertEqual(edges, told["edges"])
        told = support.told_by_program("info", "--faces", FILES / "block.step")
        self.assertEqual(blossom.read(FILES / "block.step").info(faces=True)["faces"], told["faces"])
        self.assertNotIn("area", BLOCK.info()["faces"][0])

    def test_continuity_names_every_edge(self):
        made = BLOCK.continuity()

        self.assertEqual(made.counts["G0"], 12)
        self.assertEqual(made.failing, [])
        self.assertEqual(BLOCK.continuity(require="G1").failing, list(range(1, 13)))
        self.assertEqual(repr(made), "<blossom.Continuity: 12 edges: 12 G0>")
        told = support.told_by_program("check", "--continuity", FILES / "block.step")
        self.assertEqual(made.to_dict(), told)

    def test_rounded_edges_are_smooth(self):
        made = blossom.continuity(BLOCK.fillet([1], radius=2))

        self.assertEqual(made.counts["G1"] + made.counts["G2"], 2)
        with self.assertRaisesRegex(ValueError, "^require: 'G9' is none of G0, G1, G2"):
            BLOCK.continuity(require="G9")


def two_parts():
    """A block and a bolt beside it, as an assembly that FreeCAD writes."""
    import Import

    document = support.FreeCAD.newDocument("Parts")
    machine = document.addObject("App::Part", "Machine")
    for name, kind, x in (("Block", "Part::Box", 0), ("Bolt", "Part::Cylinder", 20)):
        part = document.addObject(kind, name)
        part.Placement.Base.x = x
        machine.addObject(part)
    document.recompute()
    file = FILES / "machine.step"
    Import.export([machine], str(file))
    support.FreeCAD.closeDocument(document.Name)
    return blossom.read(file)


class Assemblies(unittest.TestCase):
    @unittest.skipIf(support.FreeCAD is None, support.NO_PART)
    def test_all_parts_stay_parts_in_files(self):
        machine = two_parts()
        plane = ((0, 0, 8), (0, 0, 1))

        for made in (
            machine.trim(planes=[plane], keep="below"),
            machine.solid("cut", planes=[plane]),
            machine.fillet([1], radius=1),
            machine.convert("bezier"),
        ):
            file = FILES / "made.step"
            made.to_step(file)
            self.assertEqual(set(blossom.read(file).part_paths), {"Block", "Bolt"}, repr(made))

    def test_trims_keep_the_tree_and_the_names(self):
        made = blossom.shape(BLOCK.trim(planes=[((0, 0, 10), (0, 0, 1))], keep="below"))

        self.assertEqual(set(made.part_paths), set(BLOCK.part_paths))

    def test_solids_keep_the_tree_and_the_names(self):
        made = blossom.shape(BLOCK.solid("cut", FILES / "drill.step"))

        self.assertEqual(made.part_paths[0], BLOCK.part_paths[0])
        self.assertTrue(set(BLOCK.face_names) <= set(made.face_names))


if __name__ == "__main__":
    unittest.main(verbosity=2)
