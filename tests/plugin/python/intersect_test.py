# SPDX-License-Identifier: LGPL-2.1-or-later
"""blossom.intersect: arguments of all kinds, views, errors in words, Ctrl-C."""

import gc
import signal
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import blossom

for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
    sys.path.append(folder)
try:
    import FreeCAD  # noqa: F401
    import Part
except ImportError:
    Part = None


def plane(origin, u, v):
    """The net of a parallelogram."""
    o, u, v = (np.array(x, float) for x in (origin, u, v))
    return np.array([[o, o + v], [o + u, o + u + v]])


FLOOR = plane((-1, -1, 0), (2, 0, 0), (0, 2, 0))
WALL = plane((0, -1, -1), (0, 2, 0), (0, 0, 2))
FAR = plane((-1, -1, 5), (2, 0, 0), (0, 2, 0))


def paraboloid(depth):
    """z = x^2 + y^2 - depth over [-1, 1]^2."""
    square = [1.0, -1.0, 1.0]  # Bernstein coefficients of x^2 for x = 2u - 1
    return np.array(
        [
            [(i - 1.0, j - 1.0, square[i] + square[j] - depth) for j in range(3)]
            for i in range(3)
        ]
    )


def waves(degree, height, phase):
    """A patch of many bumps; two of them that are near each other are hard to tell apart."""
    n = degree + 1
    i, j = np.meshgrid(range(n), range(n), indexing="ij")
    z = height * (-1.0) ** (i + j) + phase
    return np.stack([i / degree, j / degree, z], axis=2)


def box_and_sphere():
    """Part shapes that cross in three arcs."""
    box = Part.makeBox(2, 2, 2)
    box.Placement.Base = FreeCAD.Vector(0.1, 0.2, 0.3)
    return box, Part.makeSphere(1)


class Answers(unittest.TestCase):
    def test_two_planes_cross_in_one_segment(self):
        found = blossom.intersect(FLOOR, WALL)

        self.assertEqual(found.status, "complete")
        self.assertEqual(len(found.curves), 1)
        curve = found.curves[0]
        self.assertFalse(curve.closed)
        self.assertFalse(curve.tangential)
        self.assertAlmostEqual(curve.length, 2, places=9)
        self.assertEqual((curve.face_a, curve.face_b), (1, 1))
        self.assertLess(np.abs(curve.points[:, [0, 2]]).max(), 1e-9)
        self.assertLess(max(curve.deviation.values()), 1e-7)

    def test_parameters_belong_to_the_points(self):
        curve = blossom.intersect(FLOOR, WALL).curves[0]

        n = len(curve.points)
        self.assertGreaterEqual(n, 2)
        self.assertEqual(curve.points.shape, (n, 3))
        self.assertEqual(curve.uv_a.shape, (n, 2))
        self.assertEqual(curve.uv_b.shape, (n, 2))
        on_floor = np.array([-1, -1, 0]) + np.column_stack([2 * curve.uv_a, np.zeros(n)])
        on_wall = np.array([0, -1, -1]) + np.column_stack([np.zeros(n), 2 * curve.uv_b])
        np.testing.assert_allclose(curve.points, on_floor, atol=1e-9)
        np.testing.assert_allclose(curve.points, on_wall, atol=1e-9)

    def test_a_loop_is_one_closed_curve(self):
        found = blossom.intersect(paraboloid(0.25), FLOOR)

        self.assertEqual(found.status, "complete")
        self.assertEqual([c.closed for c in found.curves], [True])
        radius = np.hypot(*found.curves[0].points[:, :2].T)
        np.testing.assert_allclose(radius, 0.5, atol=1e-7)
        self.assertAlmostEqual(found.curves[0].length, np.pi, places=4)

    def test_nothing_is_proven_empty(self):
        found = blossom.intersect(FLOOR, FAR)

        self.assertEqual(found.status, "complete")
        self.assertEqual((found.curves, found.points, found.places), ([], [], []))
        self.assertIn("excluded", found.certificate)

    def test_a_touch_is_told(self):
        found = blossom.intersect(paraboloid(0), FLOOR)

        self.assertNotEqual(found.status, "stopped")
        self.assertEqual(found.curves, [])
        self.assertTrue(found.points or found.places)
        for contact in found.points:
            self.assertLess(np.linalg.norm(contact.point), 1e-3)
        for place in found.places:
            self.assertIn("touch", place.kind)
            low, high = np.array(place.box)
            self.assertTrue((low <= 1e-9).all() and (high >= -1e-9).all())
            self.assertLessEqual(*place.gap)

    def test_contacts_tell_what_they_are_on(self):
        touch = blossom.intersect(FLOOR, paraboloid(0)).points[0]
        self.assertEqual((touch.on_a, touch.on_b), (("face", 1), ("face", 1)))

        tip = plane((0, 0, 0), (0.5, 0, 1), (0, 0.5, 1))  # stands on a corner
        found = blossom.intersect(tip, FLOOR)
        self.assertEqual(len(found.points), 1)
        kind, number = found.points[0].on_a
        self.assertEqual(kind, "vertex")
        self.assertIn(number, range(1, 5))
        self.assertEqual(found.points[0].on_b, ("face", 1))

    def test_a_curve_between_borders_is_a_chain_by_itself(self):
        chain = blossom.intersect(FLOOR, WALL).chains[0]

        self.assertEqual(chain.curves, [(0, True)])
        self.assertFalse(chain.closed)
        self.assertAlmostEqual(chain.length, 2, places=9)
        self.assertEqual((chain.face_a, chain.face_b), (1, 1))

    @unittest.skipIf(Part is None, "FreeCAD's Part cannot be imported")
    def test_pieces_between_seams_are_one_chain(self):
        # A small circle about the axis x, which the sphere's seam cuts in two places.
        wall = plane((0.8, -2, -2), (0, 4, 0), (0, 0, 4))
        found = blossom.intersect(Part.makeSphere(1), wall)

        self.assertEqual(len(found.chains), 1)
        chain = found.chains[0]
        self.assertTrue(chain.closed)
        self.assertEqual(sorted(place for place, _ in chain.curves), list(range(len(found.curves))))
        self.assertAlmostEqual(chain.length, 1.2 * np.pi, places=9)
        (wire,) = found.wires
        for piece, after in zip(wire, wire[1:] + wire[:1]):
            np.testing.assert_allclose(piece[-1], after[0], atol=1e-9)

    def test_weights_make_a_cylinder(self):
        w = np.sqrt(0.5)
        arc = [(1, 0, 1), (1, 1, w), (0, 1, 1)]
        cylinder = np.array([[(x, y, z, k) for z in (-1.0, 1.0)] for x, y, k in arc])

        found = blossom.intersect(cylinder, plane((-2, -2, 0), (4, 0, 0), (0, 4, 0)))

        self.assertEqual(len(found.curves), 1)
        radius = np.hypot(*found.curves[0].points[:, :2].T)
        np.testing.assert_allclose(radius, 1, atol=1e-9)
        self.assertAlmostEqual(found.curves[0].length, np.pi / 2, places=6)


class Views(unittest.TestCase):
    def test_they_outlive_the_answer(self):
        points = blossom.intersect(FLOOR, WALL).curves[0].points
        gc.collect()
        self.assertLess(np.abs(points[:, 0]).max(), 1e-9)

    def test_they_cannot_be_written_to(self):
        points = blossom.intersect(FLOOR, WALL).curves[0].points
        with self.assertRaises(ValueError):
            points[0, 0] = 1


class Arguments(unittest.TestCase):
    def test_brep_text_and_bytes_are_understood(self):
        strip = blossom.blend_strip(
            plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), plane((3, 0, 0), (1, 0, 0), (0, 1, 0))
        )
        wall = plane((2, -1, -1), (0, 4, 0), (0, 0, 2))
        for text in (strip.to_brep(), strip.to_brep().decode(), bytearray(strip.to_brep())):
            found = blossom.intersect(text, wall)
            self.assertEqual(len(found.curves), 1)
            self.assertAlmostEqual(found.curves[0].length, 1, places=7)

    def test_edges_come_back_as_brep(self):
        brep = blossom.intersect(FLOOR, WALL).to_brep()
        self.assertIsInstance(brep, bytes)
        self.assertIn(b"CASCADE Topology V", brep)
        with self.assertRaisesRegex(ValueError, r"there is no face in it; intersect\(\), section\(\), solid\(\) and"):
            blossom.shape(brep).ray((0, 0, 0), (1, 0, 0))

    def test_a_line_is_cut_by_faces(self):
        line = blossom.curve([(0, 1, 1), (4, 1, 1)])
        wall = plane((1, 0, 0), (0, 3, 0), (0, 0, 3))
        for operation, edges in (("cut", 2), ("common", 0), ("split", 2)):
            made = line.solid(operation, wall)
            self.assertEqual(made.obstacles, [])
            self.assertEqual(sum(item["edges"] for item in made), edges)
            self.assertAlmostEqual(made.lengths["result"], 2.0 * edges, places=7)
            self.assertIn(f", {edges} edges", repr(made))
            self.assertEqual(made.to_brep().count(b"\nEd"), edges)
        with self.assertRaisesRegex(ValueError, "wires take nothing off faces and solids"):
            blossom.solid("cut", wall, line)

    def test_forms_agree(self):
        lengths = [
            sum(c.length for c in blossom.intersect(paraboloid(0.25), WALL, form=form).curves)
            for form in ("auto", "bezier", "monomial")
        ]
        np.testing.assert_allclose(lengths, lengths[0], rtol=1e-6)

    @unittest.skipIf(Part is None, "FreeCAD's Part cannot be imported")
    def test_part_shapes_go_in_and_come_out(self):
        box, sphere = box_and_sphere()

        found = blossom.intersect(box, sphere)

        self.assertEqual(found.status, "complete")
        self.assertEqual(len(found.curves), 3)
        shape = found.to_part()
        self.assertTrue(shape.isValid())
        self.assertEqual(len(shape.Edges), 3)
        theirs = box.Shells[0].section(sphere.Faces[0])
        self.assertAlmostEqual(shape.Length, theirs.Length, places=5)
        for curve in found.curves:
            for face, uv in ((box.Faces[curve.face_a - 1], curve.uv_a),
                             (sphere.Faces[curve.face_b - 1], curve.uv_b)):
                for k in (0, len(uv) // 2, -1):
                    there = np.array(face.valueAt(*uv[k]))
                    self.assertLess(np.linalg.norm(there - curve.points[k]), 1e-6)

    @unittest.skipIf(Part is None, "FreeCAD's Part cannot be imported")
    def test_brep_text_of_part_is_the_same_as_its_binary(self):
        box, sphere = box_and_sphere()

        shapes = blossom.intersect(box, sphere)
        texts = blossom.intersect(box.exportBrepToString(), sphere.exportBrepToString())

        self.assertEqual(len(shapes.curves), len(texts.curves))
        for ours, theirs in zip(shapes.curves, texts.curves):
            self.assertAlmostEqual(ours.length, theirs.length, places=9)


class Errors(unittest.TestCase):
    def expect(self, error, words, *arguments, **options):
        with self.assertRaisesRegex(error, words):
            blossom.intersect(*arguments, **options)

    def test_an_array_that_holds_no_numbers_is_named(self):
        self.expect(ValueError, "^b: a net holds numbers, got <U1$", FLOOR, np.array(["x"]))

    def test_bytes_that_are_no_brep_are_named(self):
        self.expect(ValueError, "^b: these 11 bytes hold no BRep shape$", FLOOR, b"hello world")
        self.expect(ValueError, "^a: there are no bytes$", b"", FLOOR)

    def test_truncated_brep_is_refused(self):
        text = blossom.blend_strip(FLOOR, plane((3, -1, 0), (1, 0, 0), (0, 2, 0))).to_brep()
        for size in (40, len(text) // 4, len(text) // 2, len(text) * 9 // 10):
            with self.subTest(size=size), self.assertRaisesRegex(ValueError, "^a: .*is cut off"):
                blossom.intersect(text[:size], WALL)

    @unittest.skipIf(Part is None, "FreeCAD's Part cannot be imported")
    def test_truncated_binary_is_refused(self):
        with tempfile.NamedTemporaryFile() as file:
            Part.makeSphere(1).exportBinary(file.name)
            whole = file.read()
        for size in range(30, len(whole), 37):
            with self.subTest(size=size), self.assertRaisesRegex(ValueError, "^a: "):
                blossom.intersect(whole[:size], WALL)

    @unittest.skipIf(Part is None, "FreeCAD's Part cannot be imported")
    def test_a_null_shape_is_named(self):
        self.expect(ValueError, "^b: the shape is null$", FLOOR, Part.Shape())

    def test_other_types_are_named(self):
        self.expect(TypeError, "^a: a file's name, .* is wanted, got int$", 7, FLOOR)

    def test_bad_nets_are_refused(self):
        self.expect(ValueError, r"^b: .*got \(2, 2, 5\)$", FLOOR, np.zeros((2, 2, 5)))
        self.expect(ValueError, "surface a: .*not finite", FLOOR * np.nan, WALL)
        weights = np.concatenate([FLOOR, -np.ones((2, 2, 1))], axis=2)
        self.expect(ValueError, "surface a: a weight is not positive", weights, WALL)

    def test_bad_options_are_refused(self):
        self.expect(ValueError, "^tolerance: -1.0 is not positive$", FLOOR, WALL, tolerance=-1)
        self.expect(ValueError, "^tolerance: ", FLOOR, WALL, tolerance=float("nan"))
        self.expect(ValueError, "^form: 'x' is none of auto, bezier, monomial$", FLOOR, WALL,
                    form="x")
        self.expect(ValueError, "^time_limit: ", FLOOR, WALL, time_limit=-1)
        self.expect(ValueError, "^budget: 0 is less than 1$", FLOOR, WALL, budget=0)

    def test_error_is_a_runtime_error(self):
        self.assertTrue(issubclass(blossom.Error, RuntimeError))

    @unittest.skipIf(Part is not None, "FreeCAD's Part can be imported")
    def test_a_missing_part_is_told(self):
        with self.assertRaisesRegex(blossom.Error, "^to_part: FreeCAD's Part cannot be imported"):
            blossom.intersect(FLOOR, WALL).to_part()


@unittest.skipIf(Part is None, "FreeCAD's Part cannot be imported")
class Edges(unittest.TestCase):
    """A line through the box [0, 4]^3, and one along its top."""

    def setUp(self):
        self.box = Part.makeBox(4, 4, 4)
        self.line = Part.makeLine((1, 2, -3), (1, 2, 7))

    def test_an_edge_meets_faces_in_points(self):
        found = blossom.intersect(self.line, self.box)

        self.assertEqual(found.status, "complete")
        points, parameters = zip(*((p.point, p.parameter) for p in found.edge_points))
        np.testing.assert_allclose(points, [(1, 2, 0), (1, 2, 4)], atol=1e-12)
        np.testing.assert_allclose(parameters, [3, 7])
        self.assertEqual(found.edge_points[0].on_a, ("edge", 1))
        self.assertEqual(found.edge_points[0].on_b[0], "face")
        self.assertEqual(found.to_part().ShapeType, "Compound")
        self.assertEqual(len(found.to_part().Vertexes), 2)
        self.assertIn("2 points", repr(found))

    def test_what_lies_on_a_face_is_a_stretch(self):
        found = blossom.intersect(self.box, Part.makeLine((-1, 2, 4), (9, 2, 4)))

        self.assertEqual(found.edge_points, [])
        (stretch,) = found.edge_stretches
        self.assertAlmostEqual(stretch.length, 4)
        np.testing.assert_allclose((stretch.start, stretch.end), [(0, 2, 4), (4, 2, 4)], atol=1e-9)
        self.assertEqual(len(found.to_part().Edges), 1)

    def test_edges_of_a_model_are_named(self):
        block = blossom.shape(self.box)
        edge = block.part("edge:1")

        self.assertEqual(blossom.intersect(edge, self.line).edge_points, [])
        self.assertEqual(len(blossom.intersect(edge, edge).edge_stretches), 1)

    def test_a_plane_cuts_an_edge_in_a_point(self):
        cut = blossom.section(self.line, (0, 0, 1), (0, 0, 1))

        self.assertEqual(cut.status, "complete")
        np.testing.assert_allclose(cut.points, [(1, 2, 1)], atol=1e-9)
        (plane,) = blossom.shape(self.line).sections(offsets=(1,))
        self.assertEqual([part.part for part in plane.parts], ["edges"])


class LongWork(unittest.TestCase):
    """Two patches of degree 24 that come ever nearer to each other towards the middle."""

    HARD = (waves(24, 0.5, 0), waves(24, 0.25, 0))
    OPTIONS = {"tolerance": 1e-10, "budget": 10**9}

    def test_a_time_limit_stops_it(self):
        found = blossom.intersect(*self.HARD, time_limit=0.2, **self.OPTIONS)
        self.assertEqual(found.status, "stopped")
        self.assertTrue(found.places)

    def test_it_tells_why_it_is_not_complete(self):
        touching = blossom.intersect(FLOOR, paraboloid(0))
        self.assertEqual(touching.status, "tolerance")
        self.assertTrue(any("touch" in reason for reason in touching.reasons), touching.reasons)
        self.assertRegex(repr(touching.places[0]), r"box=\(\[-.*\], \[.*\]\), gap=")
        cut = blossom.shape(paraboloid(0)).section((0, 0, 0), (0, 0, 1))
        self.assertEqual(cut.reasons, touching.reasons)
        self.assertEqual(blossom.intersect(FLOOR, WALL).reasons, [])

    def test_a_budget_stops_it(self):
        found = blossom.intersect(*self.HARD, tolerance=1e-10, budget=50)
        self.assertEqual(found.status, "stopped")

    def test_other_threads_run_meanwhile(self):
        turns, done = [0], threading.Event()

        def count():
            while not done.is_set():
                turns[0] += 1
                time.sleep(0.001)

        counter = threading.Thread(target=count)
        counter.start()
        try:
            blossom.intersect(*self.HARD, time_limit=0.3, **self.OPTIONS)
        finally:
            done.set()
            counter.join()
        self.assertGreater(turns[0], 5)

    def test_ctrl_c_ends_it(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)
        threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT)).start()
        start = time.process_time()
        with self.assertRaises(KeyboardInterrupt):
            blossom.intersect(*self.HARD, time_limit=20, **self.OPTIONS)
        self.assertLess(time.process_time() - start, 5)


class Package(unittest.TestCase):
    def test_it_has_a_version(self):
        self.assertRegex(blossom.__version__, r"^\d+\.\d+\.\d+$")

    def test_an_answer_describes_itself(self):
        self.assertEqual(
            repr(blossom.intersect(FLOOR, WALL)),
            "<blossom.Intersection: complete, 1 curve, 0 points, 0 places>",
        )


if __name__ == "__main__":
    unittest.main(verbosity=2)
