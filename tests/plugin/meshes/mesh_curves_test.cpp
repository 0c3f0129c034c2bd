// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_curves.h"

#include <gtest/gtest.h>

namespace blossom::meshes {
namespace {

// Two meshes of one part meet in polylines with sides of rounding, and of no length at all.
TEST(MeshCurves, WithSidesOfRoundingAreCurvesThroughTheirOtherPoints) {
  MeshCurves found;
  found.curves.push_back(
      {{{0, 0, 0}, {1e-20, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1e-19}}, false, 2});
  found.curves.push_back({{{5, 0, 0}, {5, 0, 1e-19}}, false, 1e-19});
  const occt::PlaneSection section = section_of(found);
  ASSERT_EQ(section.curves.size(), 1u);
  EXPECT_EQ(section.curves[0].samples.size(), 3u);
  EXPECT_EQ(section.curves[0].samples.back(), (Vec3{1, 1, 1e-19}));
  EXPECT_NEAR(section.curves[0].range.to - section.curves[0].range.from, 2, 1e-12);
  ASSERT_EQ(section.points.size(), 1u);
  EXPECT_EQ(section.nodes[section.points[0]].point, (Vec3{5, 0, 0}));
}

}  // namespace
}  // namespace blossom::meshes
