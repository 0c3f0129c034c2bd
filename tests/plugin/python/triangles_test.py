# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of triangles as they are: from files and arrays, what is asked of them, what is refused."""

import pickle
import tempfile
import unittest
from pathlib import Path

import blossom
import numpy as np
import support

FILES = support.made_files()
CORNERS = np.array([[x, y, z] for z in (0, 2) for y in (0, 2) for x in (0, 2)], float)
SIDES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def cube(at=0.0, without=()):
    kept = [side for k, side in enumerate(SIDES) if k not in without]
    triangles = [t for a, b, c, d in kept for t in ((a, b, c), (a, c, d))]
    return blossom.from_mesh(CORNERS + at, triangles)


class MeshQuestions(unittest.TestCase):
    def test_check_says_what_is_wrong(self):
        found = cube().check()
        self.assertTrue(found)
        self.assertAlmostEqual(found.volume, 8, 12)
        self.assertAlmostEqual(found.area, 24, 12)
        self.assertEqual(found.crossings, 0)
        broken = cube(without=(1,)).check()
        self.assertFalse(broken)
        self.assertEqual((broken.open_sides, broken.volume, broken.status), (4, None, "complete"))

    def test_two_meshes_meet_in_polylines(self):
        found = cube().intersect(cube(1.0))
        self.assertEqual((found.status, len(found), found.closed), ("complete", 1, [True]))
        np.testing.assert_array_equal(found[0][0], found[0][-1])
        self.assertAlmostEqual(found.length, 6)
        self.assertEqual(found.within, 0)

    def test_a_model_is_meshed_where_a_mesh_meets_it(self):
        ball = blossom.read(FILES / "drill.step")
        box = ball.mesh(0.1).vertices
        low, high = box.min(axis=0) - 1, box.max(axis=0) + 1
        middle = 0.5 * (low + high)
        slab = CORNERS / 2 * (high - low) * [1, 1, 0.5] + [low[0], low[1], middle[2]]
        found = blossom.from_mesh(slab, cube().triangles).intersect(ball)
        self.assertEqual((found.status, len(found)), ("tolerance", 1))
        self.assertAlmostEqual(found.length, 2 * np.pi * 8, delta=0.1)

    def test_sections_are_polylines_of_each_plane(self):
        found = cube().sections(offsets=[0.5, 1, 5])
        self.assertEqual([len(curves) for curves in found], [1, 1, 0])
        self.assertEqual(found[0][0][:, 2].tolist(), [0.5] * len(found[0][0]))
        self.assertEqual(len(cube().section((0, 0, 1), (1, 1, 1))[0]), 1)

    def test_distance_is_between_bounds(self):
        low, high = cube().distance(cube(0.5)).bounds
        self.assertLessEqual(low, high)
        self.assertAlmostEqual(high, np.sqrt(0.75), delta=0.09)
        drill = blossom.read(FILES / "drill.step")
        mesh = drill.mesh(0.05)
        low, high = blossom.from_mesh(mesh).distance(drill).bounds
        self.assertLessEqual(low, mesh.deviation)
        self.assertLess(high, 1.3 * mesh.deviation)

    def test_distance_is_decided_by_yes_or_no(self):
        drill = blossom.read(FILES / "drill.step")
        mesh = blossom.from_mesh(drill.mesh(0.05))
        self.assertIs(mesh.distance(drill, within=0.06).is_within, True)
        self.assertIs(mesh.distance(drill, within=0.01).is_within, False)
        self.assertIsNone(mesh.distance(drill).is_within)
        with self.assertRaisesRegex(ValueError, "^within: "):
            mesh.distance(drill, within=-1)

    def test_holes_are_filled(self):
        whole = cube(without=(1, 3)).fill()
        self.assertTrue(whole.check())
        self.assertEqual(whole.filling["closed"], True)
        self.assertEqual(len(whole.triangles[whole.groups["fill"]]), 4)

    def test_files_come_back_as_they_were_written(self):
        mesh = blossom.from_mesh(blossom.read(FILES / "drill.step").mesh(0.1))
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.ply", "a.obj", "a.off"):
                file = Path(folder) / name
                mesh.write(file)
                read = blossom.from_mesh(file)
                np.testing.assert_array_equal(read.vertices, mesh.vertices)
                np.testing.assert_array_equal(read.triangles, mesh.triangles)
                self.assertEqual(read.groups, mesh.groups)
        again = pickle.loads(pickle.dumps(mesh))
        np.testing.assert_array_equal(again.vertices, mesh.vertices)
        self.assertEqual(again.groups, mesh.groups)

    def test_groups_are_named_as_by_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "block.obj")
            blossom.read(FILES / "block.step").mesh(1).write(file)
            for name in ("Block/Face3", "Face3", "3"):
                part = blossom.from_mesh(f"{file}#{name}")
                self.assertEqual((len(part), list(part.groups)), (2, ["Block/Face3"]))
                self.assertEqual(part.name, f"{file}#{name}")
            whole = blossom.from_mesh(file)
            self.assertEqual(len(whole.part("Block")), len(whole))
            self.assertEqual(len(whole.part([1, "Face3"])), 4)
            self.assertEqual(len(blossom.from_mesh(f"{file}#2,4-6")), 8)
            with self.assertRaisesRegex(ValueError, "no group 'Roof'; there are 'Block/Face1'"):
                whole.part("Roof")
            with self.assertRaisesRegex(ValueError, "no group 7; it has 6"):
                whole.part([7])
            with self.assertRaisesRegex(TypeError, "^groups: groups are wanted, got int$"):
                whole.part(3)

    def test_info_is_that_of_the_command_line(self):
        told = cube().info()
        self.assertEqual(told["schema"], "blossom.mesh-info/1")
        self.assertEqual((told["triangles"], told["closed"]), (12, True))

    def test_reports_tell_what_reading_a_model_lost(self):
        for found in (cube().distance(FILES / "block.step"), cube().intersect(FILES / "drill.step")):
            self.assertEqual(found.to_dict()["reading"][0]["grade"], "whole")

    def test_triangles_become_curved_patches(self):
        ball = blossom.from_mesh(blossom.read(FILES / "drill.step").mesh(0.1))
        made = ball.convert()
        self.assertEqual((len(made), made.nets[0].degree), (3 * len(ball), (4, 4)))
        self.assertEqual(made.to_dict()["schema"], "blossom.mesh-patches/1")
        self.assertLess(made.largest_angle, 1e-6)
        self.assertAlmostEqual(made.model.area, ball.check().area, delta=0.01 * ball.check().area)
        sharp = cube().convert("triangles", crease=0.5)
        self.assertEqual((sharp.smooth_sides, sharp.sharp_sides, sharp.nets[0].kind), (6, 12, "triangle"))
        with self.assertRaisesRegex(ValueError, "^to: 'monomial' is none of bezier, triangles$"):
            cube().convert("monomial")

    def test_what_is_no_mesh_is_told_what_is(self):
        with self.assertRaisesRegex(TypeError, "a mesh is wanted, as a file .*; got Model$"):
            blossom.from_mesh(blossom.read(FILES / "block.step"))
        with self.assertRaisesRegex(TypeError, "got Triangles; a mesh answers itself, as mesh.check"):
            blossom.check(cube())

    def test_errors_are_words(self):
        bad = CORNERS.copy()
        bad[3, 1] = np.nan
        for error, message, call in (
            (ValueError, "vertices: row 3 is not finite", lambda: blossom.from_mesh(bad, [(0, 1, 2)])),
            (ValueError, "row 0 names a vertex", lambda: blossom.from_mesh(CORNERS, [(0, 1, 8)])),
            (ValueError, "whole", lambda: blossom.from_mesh(CORNERS, [(0, 1, 2.5)])),
            (ValueError, "no such file", lambda: blossom.from_mesh("missing.stl")),
            (TypeError, "a mesh is wanted", lambda: blossom.from_mesh(7)),
            (ValueError, "does not end with", lambda: cube().write("a.glb")),
        ):
            with self.subTest(message), self.assertRaisesRegex(error, message):
                call()


if __name__ == "__main__":
    unittest.main(verbosity=2)
