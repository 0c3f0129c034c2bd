# SPDX-License-Identifier: LGPL-2.1-or-later
"""A model that stays loaded: known figures, and the reports of the command line."""

import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np
from support import FAR, FLOOR, NO_PART, Part, WALL, made_files
from support import told_by_program, without_times

import blossom

FILES = made_files()
BLOCK = FILES / "block.step"
DRILL = FILES / "drill.step"
HULL = FILES / "hull.step"
CUTTERS = FILES / "cutters.step"
DRILLED = 60 * 40 * 20 - np.pi * 8**2 * 20


class KnownFigures(unittest.TestCase):
    def setUp(self):
        self.block = blossom.read(BLOCK)

    def test_a_plane_through_a_box_cuts_a_rectangle(self):
        section = self.block.section((0, 0, 5), (0, 0, 2))
        self.assertEqual(section.status, "complete")
        self.assertEqual(len(section), 1)
        wire = section[0]
        self.assertTrue(wire.closed)
        self.assertAlmostEqual(wire.length, 200, places=9)
        np.testing.assert_allclose(wire.points[:, 2], 5, atol=1e-9)
        np.testing.assert_allclose(wire.points.min(axis=0), (0, 0, 5), atol=1e-9)
        np.testing.assert_allclose(wire.points.max(axis=0), (60, 40, 5), atol=1e-9)
        self.assertEqual(repr(section), "<blossom.Section: complete, 1 wire, 4 curves, 0 points>")

    def test_what_only_a_model_answers_is_refused_in_words(self):
        drilled = self.block.solid("cut", DRILL)
        with self.assertRaisesRegex(AttributeError, r"Solid .* has no solid; .*: answer\.model\.solid"):
            drilled.solid("cut", DRILL)
        with self.assertRaisesRegex(AttributeError, "no attribute 'nothing_such'"):
            drilled.nothing_such
        self.assertAlmostEqual(drilled.model.volume, DRILLED, places=6)

    def test_curves_of_a_section_are_splines(self):
        circle = blossom.read(DRILL).section((0, 0, 5), (0, 0, 1)).curves
        self.assertAlmostEqual(sum(curve.length for curve in circle), 16 * np.pi, places=6)
        for curve in circle:
            self.assertEqual(len(curve.poles), len(curve.weights))
            self.assertEqual(curve.multiplicities.sum(), len(curve.poles) + curve.degree + 1)
            np.testing.assert_allclose(curve.poles[0], curve.points[0], atol=1e-6)

    def test_many_planes_need_one_reading(self):
        lengths = [self.block.section((0, 0, z), (0, 0, 1))[0].length for z in range(1, 20)]
        np.testing.assert_allclose(lengths, 200)

    def test_a_ray_passes_two_faces(self):
        hits = self.block.ray((30, 20, 50), (0, 0, -3))
        self.assertEqual([round(hit.distance, 9) for hit in hits], [30, 50])
        np.testing.assert_allclose(hits[0].point, (30, 20, 20), atol=1e-9)
        np.testing.assert_allclose(hits[0].normal, (0, 0, 1), atol=1e-12)
        self.assertEqual(len(self.block.ray((30, 20, 50), (0, 0, -1), first=True)), 1)
        self.assertEqual(len(self.block.ray((30, 20, 10), (0, 0, 1))), 1)
        self.assertEqual(len(self.block.ray((30, 20, 10), (0, 0, 1), line=True)), 2)

    def test_distances(self):
        apart = self.block.distance(np.array(FAR) + (0, 0, 20))
        self.assertEqual(apart.relation, "disjoint")
        self.assertAlmostEqual(apart.distance, 5, places=9)
        self.assertAlmostEqual(float(apart), 5, places=9)
        self.assertAlmostEqual(apart.nearest_a[2], 20)
        drill = self.block.distance(DRILL)
        self.assertEqual((drill.relation, drill.distance), ("crossing", 0))
        self.assertEqual(self.block.does_intersect(DRILL).answer, "yes")
        self.assertEqual(self.block.does_intersect(np.array(FAR) + (0, 0, 20)).answer, "no")

    @unittest.skipIf(Part is None, NO_PART)
    def test_a_ball_in_a_box_meets_it(self):
        box, ball = Part.makeBox(4, 4, 4), Part.makeSphere(1)
        ball.Placement.Base = (2, 2, 2)
        found = blossom.distance(box, ball)
        self.assertEqual((found.relation, found.distance), ("b inside a", 0))
        self.assertEqual(blossom.does_intersect(box, ball).answer, "yes")
        self.assertEqual(len(blossom.intersect(box, ball)), 0)

    def test_points(self):
        found = self.block.foot_points((30, 20, 23))
        self.assertAlmostEqual(found.distance, 3)
        np.testing.assert_allclose(found.point, (30, 20, 20), atol=1e-9)
        self.assertEqual(found.on["kind"], "face")
        self.assertFalse(found.inside)
        self.assertGreater(len(found), 1)
        self.assertTrue(self.block.foot_points((30, 20, 10), all=False).inside)

    def test_masses(self):
        self.assertAlmostEqual(self.block.volume, 60 * 40 * 20, places=6)
        self.assertAlmostEqual(self.block.area, 2 * (60 * 40 + 60 * 20 + 40 * 20), places=6)
        found = self.block.mass()
        np.testing.assert_allclose(found.centre, (30, 20, 10), atol=1e-9)
        self.assertAlmostEqual(found.inertia[2, 2] / found.volume, (60**2 + 40**2) / 12, places=6)
        self.assertEqual([part.name for part in found], ["Block"])
        self.assertEqual(
            without_times(found.to_dict()), without_times(told_by_program("query", "mass", BLOCK))
        )
        face = self.block.face(1).mass()
        self.assertEqual((face.volume, face.centre, face.parts[0].solid), (0, None, None))
        self.assertGreater(face.area, 0)

    def test_answers_go_on_as_models(self):
        drilled = self.block.solid("cut", DRILL).model
        self.assertAlmostEqual(drilled.volume, DRILLED, places=6)
        self.assertAlmostEqual(drilled.solid("cut", planes=[((0, 0, 10), (0, 0, 1))]).volume, DRILLED / 2, 6)

    def test_sheets_split(self):
        wall = np.array([[(-9, -9, 5), (-9, 99, 5)], [(99, -9, 5), (99, 99, 5)]], float)
        halves = self.block.solid("split", wall)
        self.assertEqual(len(halves), 2)
        self.assertAlmostEqual(halves.volume, 60 * 40 * 20, places=6)
        with self.assertRaisesRegex(ValueError, "split divides it by one"):
            self.block.solid("cut", wall)

    def test_sheets_are_cut(self):
        wall = blossom.shape(np.array([[(-9, -9, 5), (-9, 99, 5)], [(99, -9, 5), (99, 99, 5)]], float))
        inside = wall.solid("common", self.block)
        self.assertAlmostEqual(inside.area, 60 * 40, places=6)
        self.assertEqual(inside.volume, 0)
        self.assertAlmostEqual(wall.solid("cut", self.block).area, 108 * 108 - 60 * 40, places=6)
        self.assertAlmostEqual(self.block.solid("common", wall).model.area, 60 * 40, places=6)

    def test_a_box_is_sound(self):
        found = self.block.check()
        self.assertTrue(found.sound)
        self.assertEqual(list(found), [])
        self.assertEqual(repr(found), "<blossom.Check: sound, 0 problems>")

    def test_a_box_does_not_meet_itself(self):
        self.assertEqual(self.block.self_intersect(faces=True).verdict, "none found")

    def test_solids_are_combined(self):
        cut = self.block.solid("cut", DRILL)
        self.assertEqual(cut.status, "complete")
        self.assertAlmostEqual(cut.volume, DRILLED, delta=1e-6 * DRILLED)
        common = self.block.solid("common", DRILL)
        self.assertAlmostEqual(cut.volume + common.volume, 48000, delta=1e-6 * 48000)
        halves = self.block.solid("split", planes=[((0, 0, 5), (0, 0, 1))])
        self.assertEqual(len(halves), 2)
        self.assertIn("split, complete, 2 solids", repr(halves))

    def test_tools_may_be_in_a_list(self):
        floor = ((0, 0, 5), (0, 0, 1))
        low = self.block.solid("cut", planes=[floor])
        beside = self.block.solid("cut", DRILL, low)
        for tools in ([DRILL, low], (DRILL, low)):
            self.assertEqual(self.block.solid("cut", tools).volume, beside.volume)
        self.assertEqual(self.block.solid("cut", [], planes=[floor]).volume, 60 * 40 * 5)
        with self.assertRaisesRegex(TypeError, "tool 2: .* is wanted, got int"):
            self.block.solid("cut", [DRILL, 7])
        with self.assertRaisesRegex(TypeError, "no option 'plane'; there are planes, fuzzy, tol"):
            self.block.solid("cut", plane=floor)
        with self.assertRaisesRegex(ValueError, "needs a tool"):
            self.block.trim([], keep="all")

    @unittest.skipIf(Part is None, NO_PART)
    def test_what_is_apart_by_less_than_fuzzy_is_one(self):
        left, right = Part.makeBox(2, 2, 2), Part.makeBox(2, 2, 2)
        right.Placement.Base = (2 + 1e-4, 0, 0)
        self.assertEqual(len(blossom.solid("fuse", left, right)), 2)
        self.assertEqual(len(blossom.solid("fuse", left, right, fuzzy=2e-4)), 1)
        with self.assertRaisesRegex(ValueError, "fuzzy: -1.0 is negative"):
            blossom.solid("fuse", left, right, fuzzy=-1)

    @unittest.skipIf(Part is None, NO_PART)
    def test_two_boxes_are_cut_as_part_has_them(self):
        big, small = Part.makeBox(2, 2, 2), Part.makeBox(2, 2, 2)
        small.Placement.Base = (1, 1, 1)
        cut = blossom.solid("cut", big, small)
        self.assertAlmostEqual(cut.volume, 7, places=9)
        shape = cut.to_part()
        self.assertTrue(shape.isValid())
        self.assertAlmostEqual(shape.Volume, 7, places=9)

    def test_a_made_shape_answers_questions(self):
        drilled = blossom.shape(self.block.solid("cut", DRILL))
        lengths = sorted(wire.length for wire in drilled.section((0, 0, 5), (0, 0, 1)))
        np.testing.assert_allclose(lengths, [16 * np.pi, 200], rtol=1e-9)

    def test_faces_are_trimmed(self):
        found = self.block.trim(keep="below", planes=[((0, 0, 5), (0, 0, 1))])
        self.assertEqual(found.status, "complete")
        kept = sum(piece["area"] for piece in found if piece["kept"])
        self.assertAlmostEqual(kept, 60 * 40 + 200 * 5, places=6)
        self.assertEqual(len(self.block), 6)  # is not changed

    def test_watertight_pieces_have_common_sides(self):
        found = blossom.watertight(self.block)
        self.assertEqual(found.status, "complete")
        self.assertGreaterEqual(len(found), 6)
        self.assertEqual(found[0]["points"].shape[-1], 3)


class Reports(unittest.TestCase):
    """`to_dict()` is what the command line writes."""

    def equal(self, ours, *arguments):
        self.maxDiff = 2000
        theirs = told_by_program(*arguments)
        ours = ours if isinstance(ours, dict) else ours.to_dict()
        self.assertEqual(without_times(ours), without_times(theirs))

    def test_info(self):
        self.equal(blossom.read(HULL).info(), "info", HULL)

    def test_check(self):
        self.equal(blossom.read(HULL).check(), "check", HULL)

    def test_intersect(self):
        self.equal(blossom.read(HULL).intersect(CUTTERS), "intersect", HULL, CUTTERS)

    def test_self_intersect(self):
        self.equal(blossom.read(HULL).self_intersect(True), "self-intersect", HULL, "--faces")

    def test_section(self):
        found = blossom.read(BLOCK).section((0, 0, 5), (0, 0, 1))
        self.equal(found, "query", "plane", BLOCK, "--point", "0,0,5", "--normal", "0,0,1")

    def test_ray(self):
        found = blossom.read(BLOCK).ray((30, 20, 50), (0, 0, -1))
        self.equal(found, "query", "ray", BLOCK, "--from", "30,20,50", "--direction", "0,0,-1")

    def test_distances(self):
        block, drill = blossom.read(BLOCK), blossom.read(DRILL)
        self.equal(block.distance(drill), "query", "distance", BLOCK, DRILL)
        self.equal(block.does_intersect(drill), "query", "does-intersect", BLOCK, DRILL)
        self.equal(block.foot_points((1, 2, 30)), "query", "point", BLOCK, "--at", "1,2,30", "--all")

    def test_trim(self):
        found = blossom.read(HULL).trim(blossom.read(CUTTERS, faces=[1]), keep="below")
        self.equal(found, "trim", HULL, f"{CUTTERS}#1", "--keep", "below")

    def test_solid(self):
        found = blossom.read(BLOCK).solid("cut", DRILL, planes=[((0, 0, 5), (0, 0, 1))])
        self.equal(found, "trim", BLOCK, DRILL, "--solid", "cut", "--plane", "0,0,5,0,0,1")

    def test_a_report_is_the_callers_own(self):
        found = blossom.read(BLOCK).section((0, 0, 5), (0, 0, 1))
        found.to_dict()["wires"].clear()
        self.assertEqual(len(found.to_dict()["wires"]), 1)


class Writing(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_shapes_and_their_names_go_to_files(self):
        blossom.read(BLOCK).solid("cut", DRILL).to_step(self.folder / "cut.step")
        again = blossom.read(self.folder / "cut.step")
        self.assertEqual(len(again), 7)
        self.assertIn("Block", again.part_paths[0])
        blossom.intersect(FLOOR, WALL).write(self.folder / "edges.brep")
        self.assertEqual(blossom.read(self.folder / "edges.brep").counts["edges"], 1)

    def test_edges_go_to_files(self):
        edge = blossom.read(BLOCK).part("Edge3")
        beside = blossom.read(BLOCK).part("Face1,Edge3,Edge12")
        for ending in ("step", "brep"):
            edge.write(self.folder / f"edge.{ending}")
            again = blossom.read(self.folder / f"edge.{ending}")
            self.assertEqual((again.counts["edges"], again.counts["faces"]), (1, 0))
            beside.write(self.folder / f"beside.{ending}")
            counts = blossom.read(self.folder / f"beside.{ending}").counts
            self.assertEqual((counts["edges"], counts["faces"]), (5, 1))

    def test_files_are_converted(self):
        blossom.convert(BLOCK, self.folder / "block.brep")
        self.assertEqual(len(blossom.read(self.folder / "block.brep")), 6)

    def test_what_cannot_be_written_is_told(self):
        model = blossom.read(BLOCK)
        with self.assertRaisesRegex(ValueError, "does not end with .step or .stp"):
            model.to_step(self.folder / "block.brep")
        with self.assertRaises(blossom.Error):
            model.write(self.folder / "none" / "block.step")
        with self.assertRaisesRegex(blossom.Error, "there is no shape in this answer"):
            model.check().to_brep()

    @unittest.skipUnless(Path("/dev/full").exists(), "there is no full disk here")
    def test_a_full_disk_is_told(self):
        (self.folder / "full.step").symlink_to("/dev/full")
        with self.assertRaises(blossom.Error):
            blossom.read(BLOCK).write(self.folder / "full.step")


class Pickles(unittest.TestCase):
    def test_answers_travel(self):
        block = blossom.read(BLOCK)
        for found in (
            block.section((0, 0, 5), (0, 0, 1)), block.intersect(DRILL), block.ray((1, 1, 50), (0, 0, -1)),
            block.distance(DRILL), block.foot_points((1, 2, 30)), block.check(), block.watertight(),
            block.solid("cut", DRILL), block.trim(DRILL, keep="all"), block.self_intersect(),
        ):  # fmt: skip
            with self.subTest(found):
                again = pickle.loads(pickle.dumps(found))
                self.assertEqual(repr(again), repr(found))
                self.assertEqual(again.to_dict(), found.to_dict())
                self.assertEqual(len(again), len(found))

    def test_curves_and_shapes_travel(self):
        found = blossom.intersect(FLOOR, WALL)
        again = pickle.loads(pickle.dumps(found))
        np.testing.assert_array_equal(again.curves[0].poles, found.curves[0].poles)
        self.assertIn(b"CASCADE Topology", again.to_brep())

    def test_models_travel_with_names_and_assembly(self):
        with tempfile.TemporaryDirectory() as folder:
            blossom.solid("split", BLOCK, DRILL).to_step(f"{folder}/rig.step")
            rig = blossom.read(f"{folder}/rig.step")
        part = rig.part(rig.part_paths[0])
        for model in (blossom.read(BLOCK), rig, part, blossom.shape(WALL)):
            again = pickle.loads(pickle.dumps(model))
            self.assertEqual(repr(again), repr(model))
            self.assertAlmostEqual(again.volume, model.volume, 9)
        again = pickle.loads(pickle.dumps(rig))
        self.assertEqual((again.part_paths, again.face_names), (rig.part_paths, rig.face_names))
        self.assertIsNone(again.file)
        for ours, theirs in zip(again.info(faces=True)["faces"], rig.info(faces=True)["faces"]):
            self.assertEqual(ours.get("colour"), theirs.get("colour"))
        self.assertEqual(set(pickle.loads(pickle.dumps(part)).part_paths), {rig.part_paths[0]})
        edge = pickle.loads(pickle.dumps(blossom.read(BLOCK).part("Edge3")))
        self.assertEqual((edge.counts["edges"], edge.counts["faces"]), (1, 0))
        made = pickle.loads(pickle.dumps(blossom.read(BLOCK).solid("cut", DRILL)))
        self.assertEqual(set(made.model.part_paths), {"Block"})


class WrongTypes(unittest.TestCase):
    def expect(self, error, words, call, *arguments, **options):
        with self.assertRaisesRegex(error, words):
            call(*arguments, **options)

    def test_they_are_named(self):
        model = blossom.read(BLOCK)
        self.expect(TypeError, "^point: three numbers are wanted, got int$", model.section, 1, (0, 0, 1))
        self.expect(ValueError, "^normal: three numbers are wanted, got 2$", model.section, (0, 0, 0), (0, 1))
        self.expect(TypeError, "^point: three numbers are wanted, got str$", model.section, "abc", (0, 0, 1))
        self.expect(ValueError, "^normal: the zero vector", model.section, (0, 0, 0), (0, 0, 0))
        self.expect(TypeError, "^first: True or False", model.ray, (0, 0, 0), (0, 0, 1), first="no")
        self.expect(TypeError, "^other: .* is wanted, got object$", model.distance, object())
        self.expect(TypeError, "^tool 2: .* is wanted, got NoneType$", model.solid, "cut", DRILL, None)
        self.expect(ValueError, "^operation: 'cat' is none of cut, ", model.solid, "cat", DRILL)
        self.expect(ValueError, "^solid needs a tool, or a plane$", model.solid, "cut")
        self.expect(ValueError, "^keep: above, .* got 'x'$", model.trim, DRILL, keep="x")
        self.expect(TypeError, "^keep: a word or a number", model.trim, DRILL, keep=None)
        self.expect(ValueError, "is no closed solid", model.solid, "cut", FLOOR)
        self.expect(TypeError, "there is no option 'tolerence'", model.check, tolerence=1)
        self.expect(TypeError, "^cancel: a blossom.Cancel is wanted", model.check, cancel=1)
        self.expect(TypeError, "^progress: a function", model.check, progress=1)
        self.expect(TypeError, "^threads: a whole number", model.check, threads=1.5)
        self.expect(TypeError, "^planes: a list of pairs", model.solid, "cut", planes=3)
        self.expect(TypeError, "^numbers: a list of face numbers", model.part, 3)
        self.expect(TypeError, "^models are made by", blossom.Model, 3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
