# SPDX-License-Identifier: LGPL-2.1-or-later
"""blossom.blend_strip: what goes in, what comes out."""

import unittest

import numpy as np

import blossom


def square(x):
    """[x, x + 1] x [0, 1] at z = 0, u along x."""
    return np.array([[(x + i, float(j), 0.0) for j in (0, 1)] for i in (0, 1)])


class Strips(unittest.TestCase):
    def test_the_nearest_borders_are_joined_exactly(self):
        strip = blossom.blend_strip(square(0.0), square(3.0))

        self.assertEqual((strip.edge_a, strip.edge_b), ("umax", "umin"))
        self.assertFalse(strip.backward)
        for continuity in (strip.continuity_a, strip.continuity_b):
            self.assertLess(continuity["gap"], 1e-14)
            self.assertLess(continuity["normal_angle"], 1e-14)
            self.assertAlmostEqual(continuity["scale"], 2)
        self.assertIn(b"CASCADE Topology V", strip.to_brep())

    def test_borders_and_weights_may_be_named(self):
        strip = blossom.blend_strip(
            square(0.0), square(3.0), edge_a="umin", edge_b="umax", weight_a=2
        )

        self.assertEqual((strip.edge_a, strip.edge_b), ("umin", "umax"))
        self.assertAlmostEqual(strip.continuity_a["scale"], 2 * strip.continuity_b["scale"])

    def test_edges_may_be_numbers_and_curvatures_continue(self):
        strip = blossom.blend_strip(square(0.0), square(3.0), edge_a=1, continuity="G2")

        self.assertEqual(strip.edge_a, 1)
        self.assertIn("from edge 1 of a", repr(strip))
        self.assertEqual(strip.to_dict()["degree"], [1, 5])
        self.assertLess(strip.continuity_a["curvature_difference"], 1e-9)

    def test_errors_are_words(self):
        with self.assertRaisesRegex(ValueError, "^edge_a: 'left' is none of umax, umin, "):
            blossom.blend_strip(square(0.0), square(3.0), edge_a="left")
        with self.assertRaisesRegex(ValueError, "edge 7 is none of the face, which has 1, 2, 3, 4"):
            blossom.blend_strip(square(0.0), square(3.0), edge_b=7)
        with self.assertRaisesRegex(ValueError, "^continuity: 'G4' is none of G1, G2, G3"):
            blossom.blend_strip(square(0.0), square(3.0), continuity="G4")
        with self.assertRaisesRegex(ValueError, "the borders coincide"):
            blossom.blend_strip(square(0.0), square(1.0))
        with self.assertRaisesRegex(ValueError, "weight_b has to be positive"):
            blossom.blend_strip(square(0.0), square(3.0), weight_b=0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
