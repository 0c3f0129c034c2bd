// SPDX-License-Identifier: LGPL-2.1-or-later
// The borders of untrimmed faces of real models are as near to the trims as they say.
#include "adapters/occt/faces/untrimmed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/shapes.h"
#include "core/forms/evaluation.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

constexpr int kPoints = 7;           // of an arc
constexpr int kSamples = 64;         // of the trim under it, of which the nearest is improved
constexpr double kRounding = 1e-10;  // model units: sizes up to 1e3, and the golden section's end

// Distance of a point from the image of a piece of a trim, by Open CASCADE's evaluation.
class TrimImage {
 public:
  TrimImage(Handle(Geom_Surface) surface, const PlanarCurve& curve, const Interval& place)
      : surface_(std::move(surface)), curve_(curve), place_(place) {}

  // Not smaller than it is; searched for only if the point there, from 0 to 1, is not near enough.
  double distance_from(const Vec3& p, double there, double enough) const {
    if (const double way_there = way(p, kSamples * there); way_there <= enough) return way_there;
    int nearest = 0;
    for (int k = 1; k <= kSamples; ++k)
      if (way(p, k) < way(p, nearest)) nearest = k;
    double from = std::max(nearest - 1, 0), to = std::min(nearest + 1, kSamples);
    for (int step = 0; step < 50; ++step) {
      const double low = from + 0.382 * (to - from), high = to - 0.382 * (to - from);
      (way(p, low) < way(p, high) ? to : from) = way(p, low) < way(p, high) ? high : low;
    }
    return std::min(way(p, from), way(p, nearest));
  }

 private:
  double way(const Vec3& p, double sample) const {
    const Vec2 uv = point_at(curve_, at(place_, sample / kSamples));
    const gp_Pnt q = surface_->Value(uv[0], uv[1]);
    return distance(p, {q.X(), q.Y(), q.Z()});
  }

  Handle(Geom_Surface) surface_;
  const PlanarCurve& curve_;
  Interval place_;
};

// Returns the number of arcs.
int expect_within_bounds(const TopoDS_Face& face) {
  const TrimmedChart chart = trimmed_chart(face_trims(face));
  const UntrimmedFace made = untrimmed(face);
  for (const RegionArc& arc : made.region.arcs) {
    const TrimImage trim(BRep_Tool::Surface(face),
                         chart.borders[static_cast<std::size_t>(arc.border)].curve, arc.place);
    const RationalBezierPatch& patch = made.surface.patches(arc.patch_u, arc.patch_v);
    const double bound = arc.error + made.surface.error + kRounding;
    for (int k = 0; k < kPoints; ++k) {
      const double t = static_cast<double>(k) / (kPoints - 1);
      const Vec2 uv = jet_at(arc.curve, t).point;
      EXPECT_LE(trim.distance_from(point_at(patch, uv[0], uv[1]), t, bound), bound);
    }
  }
  return static_cast<int>(made.region.arcs.size());
}

// Trims of the first two pass the ranges of their surfaces; in the second, corners of wires are
// 3e-3 apart.
TEST(Untrimmed, BordersAreWithinTheirBounds) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  for (const char* name : {"bearing.iges", "s1_mainbody_back.stp", "elliptiplane.brep"}) {
    SCOPED_TRACE(name);
    const Model model = testing::repaired_model(std::string(folder) + "/models/" + name);
    int arcs = 0;
    for (int number = 1; number <= model.face_count(); ++number)
      arcs += expect_within_bounds(model.face(number));
    EXPECT_GT(arcs, 1000);
  }
}

}  // namespace
}  // namespace blossom::occt
