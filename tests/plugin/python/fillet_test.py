# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rounded edges: which are meant, what comes out, what is refused and how that is said."""

import math
import pickle
import tempfile
import unittest

import blossom
import support

FILES = support.made_files()
BLOCK = blossom.read(FILES / "block.step")
VOLUME = 60 * 40 * 20
CORNER = 4 - math.pi  # what a fillet of radius 2 takes off an edge, for each unit of its length


class Fillets(unittest.TestCase):
    def test_an_edge_by_number_is_rounded_exactly(self):
        made = BLOCK.fillet([1], radius=2)

        self.assertEqual((made.status, list(made), made.refused), ("complete", [1], []))
        self.assertAlmostEqual(made.volume_before, VOLUME, 6)
        taken = VOLUME - made.volume
        self.assertTrue(any(abs(taken - CORNER * length) < 1e-6 for length in (60, 40, 20)), taken)
        self.assertEqual(blossom.shape(made).face_count, 7)

    def test_a_word_and_a_pair_of_faces_mean_edges(self):
        everywhere = BLOCK.fillet("convex", radius=2)
        one = blossom.fillet(BLOCK, between=(3, 1), radius=2)

        self.assertEqual(everywhere.edges, list(range(1, 13)))
        self.assertEqual(everywhere.edges, BLOCK.fillet("all", radius=2).edges)
        self.assertEqual(len(one), 1)

    def test_a_full_round_leaves_nothing_of_the_face_between_two_edges(self):
        made = BLOCK.fillet([9, 10], full_round=True)  # of a face as wide as the block is high

        self.assertEqual((made.status, made.edges, made.refused), ("complete", [9, 10], []))
        self.assertEqual(blossom.shape(made).face_count, 7)  # one is gone, two strips are there
        self.assertAlmostEqual(VOLUME - made.volume, 60 * (2 - math.pi / 2) * 10**2, 6)

    def test_a_full_round_that_cannot_be_names_edges_that_can(self):
        with self.assertRaisesRegex(ValueError, "no face in common; edges .* would do"):
            BLOCK.fillet([1, 7], full_round=True)
        with self.assertRaisesRegex(ValueError, "a full round takes two edges, not 1"):
            BLOCK.fillet([1], full_round=True)
        with self.assertRaisesRegex(TypeError, "full_round goes without radius and law"):
            BLOCK.fillet([1, 2], radius=1, full_round=True)

    def test_the_report_is_that_of_the_command_line(self):
        options = ("--edge", 1, "--radius", 2)
        told = support.told_by_program("blend", "fillet", FILES / "block.step", *options)
        mine = BLOCK.fillet([1], radius=2).to_dict()

        self.assertEqual(support.without_times(mine), support.without_times(told))

    def test_answers_pickle_with_their_shape(self):
        made = pickle.loads(pickle.dumps(BLOCK.fillet([1], radius=2)))

        self.assertEqual(blossom.shape(made).face_count, 7)
        self.assertEqual(repr(made), "<blossom.Fillet: complete, 1 edge rounded>")

    def test_what_is_too_large_is_refused_with_the_largest_radius(self):
        made = BLOCK.fillet([1], radius=200)

        self.assertEqual((made.edges, made.volume), ([], None))
        self.assertEqual((made.status, bool(made)), ("refused", False))
        self.assertTrue(repr(made).startswith("<blossom.Fillet: nothing rounded, 1 refused: edge 1:"))
        self.assertEqual(made.refused[0]["fault"], "leaves face")
        self.assertIn("beyond the border of face", made.refused[0]["cause"])
        with self.assertRaisesRegex(
            blossom.Error, "Fillet: there is no shape in this answer .*1 refused: edge 1: .*the largest that works is 40"
        ):
            made.to_brep()

    def test_radii_may_change_along_an_edge_and_sections_be_conics(self):
        changed = BLOCK.fillet([1], radius=(2, 5))
        parabola = BLOCK.fillet([1], radius=2, section="conic:0.5")
        circle = BLOCK.fillet([1], radius=2, section="circle")

        # Radii run linearly from 2 to 5 along the 20 of the edge: the mean square is 13. The ball
        # touches a little farther back, so the sections are no circles across the edge.
        self.assertAlmostEqual(VOLUME - changed.volume, (1 - math.pi / 4) * 13 * 20, delta=0.5)
        # Between the parabola and its tangents is a third of the triangle with legs of 2.
        self.assertAlmostEqual(VOLUME - parabola.volume, 20 * 2 / 3, 4)
        self.assertAlmostEqual(VOLUME - circle.volume, CORNER * 20, 4)
        told = support.told_by_program(
            "blend", "fillet", FILES / "block.step", "--edge", 1, "--radius", "2..5", "--section", "conic:0.4"
        )
        mine = BLOCK.fillet([1], radius=(2, 5), section="conic:0.4").to_dict()
        self.assertEqual(support.without_times(mine), support.without_times(told))

    def test_radii_may_go_by_a_law_and_sections_have_curvatures(self):
        law = {"law": "table", "at": [0, 0.5, 1], "radii": [2, 3, 2]}
        made = BLOCK.fillet([1], law=law, section="g2")

        self.assertEqual(made.to_dict()["law"], law)
        self.assertEqual(made.to_dict()["section"], "g2")
        self.assertGreater(VOLUME, made.volume)
        for wrong in ({"law": "steep", "radii": [1, 2]}, {"law": "smooth"}, {"law": object()}):
            with self.assertRaisesRegex(ValueError, "law"):
                BLOCK.fillet([1], law=wrong)
        with self.assertRaisesRegex(TypeError, "a radius or a law is wanted"):
            BLOCK.fillet([1])

    def test_edges_may_have_radii_of_their_own(self):
        # Edges 1 and 7 are 20 long and apart from each other.
        own = BLOCK.fillet(radius={1: 2, 7: 4})
        others = BLOCK.fillet([1, 3], radius={1: 2, None: 4})
        changed = BLOCK.fillet(radius={1: 2, 7: {"law": "linear", "radii": [2, 4]}})
        pair = BLOCK.fillet(radius={1: 2, 7: (2, 4)})

        self.assertEqual(own.edges, [1, 7])
        self.assertAlmostEqual(VOLUME - own.volume, CORNER * 20 * (1 + 4), 6)
        self.assertAlmostEqual(VOLUME - others.volume, CORNER * 20 * (1 + 4), 6)
        self.assertEqual(changed.volume, pair.volume)
        told = support.told_by_program("blend", "fillet", FILES / "block.step", "--edge", "1:2,7:2..4")
        self.assertEqual(support.without_times(pair.to_dict()), support.without_times(told))
        for message, arguments in (
            ("^radius: edge 3 has none; that of all others is wanted", {"edges": [1, 3]}),
            ("^radius: some edges have none", {"edges": "all"}),
            ("edge 1 has a radius, but is not among the edges", {"edges": [3], "radius": {1: 2, None: 1}}),
            ("^radius: edge 1: -2.0 is not positive", {"radius": {1: -2}}),
            ("^edges: 0 is less than 1", {"radius": {0: 2}}),
            ("^fillet needs edges", {"radius": {}}),
        ):
            with self.subTest(message), self.assertRaisesRegex(ValueError, message):
                BLOCK.fillet(**{"radius": {1: 2}, **arguments})

    def test_of_a_part_its_own_edges_are_rounded(self):
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/two.step"  # where no part has faces in common with the other
            BLOCK.solid("split", planes=[((0, 0, 5), (0, 0, 1))]).to_step(file)
            two = blossom.read(file)
        part = two.part(two.part_paths[-1])
        made = part.fillet("all", radius=1)

        self.assertEqual(made.edges, [each["number"] for each in part.info(edges=True)["edges"]])
        self.assertEqual(len(made.edges), 12)
        self.assertEqual(made.model.counts["solids"], 2)
        self.assertLess(made.model.volume, VOLUME)
        other = next(n for n in range(1, 25) if n not in made.edges)
        with self.assertRaisesRegex(ValueError, f"edge {other} is of another part"):
            part.fillet([other], radius=1)
        with self.assertRaisesRegex(ValueError, "whole models and parts, not in some faces"):
            two.part([1]).fillet("all", radius=1)

    def test_errors_are_words(self):
        for error, message, arguments in (
            (ValueError, "^setback: 0.0 is not positive", {"edges": [1], "setback": 0}),
            (ValueError, "^edges: 'sharp' is none of all, convex, concave", {"edges": "sharp"}),
            (TypeError, "^edges: a list of edge numbers is wanted, got int", {"edges": 3}),
            (ValueError, "^edges: 0 is less than 1", {"edges": [0]}),
            (ValueError, "there is no edge 99, only 1 to 12", {"edges": [99]}),
            (ValueError, "^radius: -1.0 is not positive", {"edges": [1], "radius": -1}),
            (TypeError, "^radius: a number is wanted, got str", {"edges": [1], "radius": "2"}),
            (ValueError, "^radius: 2 numbers are wanted, got 3", {"edges": [1], "radius": (1, 2, 3)}),
            (ValueError, "^section: 'circle', 'conic:RHO' with", {"edges": [1], "section": "conic:1"}),
            (TypeError, "^partial: True or False is wanted", {"edges": [1], "partial": 1}),
            (ValueError, "^between: two different face numbers are wanted", {"between": [2]}),
            (ValueError, "faces 1 and 2 have no edge in common", {"between": [2, 1]}),
            (ValueError, "^fillet needs edges, or two faces", {}),
        ):
            with self.subTest(arguments), self.assertRaisesRegex(error, message):
                BLOCK.fillet(**{"radius": 2, **arguments})
        with self.assertRaisesRegex(ValueError, "fillets are made in whole models"):
            BLOCK.face(1).fillet([1], radius=2)


class Chamfers(unittest.TestCase):
    def test_an_edge_is_cut_off_by_a_distance_two_or_an_angle(self):
        # Edge 1 is 20 long.
        for taken, options in (
            (20 * 2 * 2 / 2, {"distance": 2}),
            (20 * 2 * 1 / 2, {"distance": (2, 1)}),
            (20 * 2 * 2 * math.tan(math.radians(30)) / 2,
             {"distance": 2, "angle": math.radians(30)}),
        ):  # fmt: skip
            with self.subTest(options):
                made = blossom.chamfer(BLOCK, [1], **options)
                self.assertEqual((made.status, list(made), made.refused), ("complete", [1], []))
                self.assertAlmostEqual(VOLUME - made.volume, taken, 6)

    def test_all_edges_meet_in_planes(self):
        made = pickle.loads(pickle.dumps(BLOCK.chamfer("all", distance=2)))

        self.assertEqual(repr(made), "<blossom.Chamfer: complete, 12 edges cut off>")
        self.assertEqual(len(BLOCK.chamfer(between=(1, 3), distance=1)), 1)
        self.assertGreater(blossom.shape(made).face_count, 18)
        self.assertTrue(blossom.check(made).sound)

    def test_refusals_speak_of_the_chamfer(self):
        refused = BLOCK.chamfer("all", distance=100, partial=True).refused

        self.assertEqual(refused[0]["fault"], "leaves face")
        self.assertIn("the chamfer's border lies beyond the border of face", refused[0]["cause"])
        for each in refused:
            self.assertNotRegex(each["cause"], "ball|radius|fillet")

    def test_the_report_is_that_of_the_command_line(self):
        options = ("--edge", 1, "--distance", "2,1")
        told = support.told_by_program("blend", "chamfer", FILES / "block.step", *options)
        mine = BLOCK.chamfer([1], distance=(2, 1)).to_dict()

        self.assertEqual(support.without_times(mine), support.without_times(told))

    def test_errors_are_words(self):
        for error, message, arguments in (
            (ValueError, "^chamfer needs edges, or two faces", {}),
            (ValueError, "^distance: 0.0 is not positive", {"edges": [1], "distance": 0}),
            (ValueError, "^angle: a second distance, or an angle",
             {"edges": [1], "distance": (1, 2), "angle": 1}),
            (ValueError, "^angle: 4.0 is above pi; radians are wanted", {"edges": [1], "angle": 4}),
        ):  # fmt: skip
            with self.subTest(arguments), self.assertRaisesRegex(error, message):
                BLOCK.chamfer(**{"distance": 2, **arguments})
        with self.assertRaisesRegex(ValueError, "chamfers are made in whole models"):
            BLOCK.face(1).chamfer([1], distance=2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
