// SPDX-License-Identifier: LGPL-2.1-or-later
// Real models: every face of every file becomes Bezier patches with the same points; and a surface
// that nothing made up is like.

#include <algorithm>
#include <filesystem>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <BRep_Tool.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/convert/surfaces_samples.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;
using testing::Random;
using testing::uniform;

/// The models of the folder that BLOSSOM_TEST_DATA names.
std::set<fs::path> models() {
  std::set<fs::path> found;
  const char* data = blossom::testing::test_data();
  if (data == nullptr) return found;
  const std::set<std::string> endings{".stp", ".step", ".brep", ".iges", ".igs"};
  for (const auto& entry : fs::directory_iterator(fs::path(data) / "models"))
    if (endings.contains(entry.path().extension().string())) found.insert(entry.path());
  return found;
}

double size_of(const BezierSurface& surface) {
  double size = 0;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values())
      size = std::max(size, max_norm(Vec3{p[0], p[1], p[2]} * (1 / p[3])));
  return size;
}

void compare(const TopoDS_Face& face, const std::string& what, Random& random) {
  const BezierSurface found = bezier_surface(face);
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const double allowed = found.error + 256 * 0x1p-53 * size_of(found);
  EXPECT_LE(found.error, 1e-7) << what;
  double largest = 0;
  for (int k = 0; k < 30; ++k) {
    const double u = uniform(random, found.u_knots.front(), found.u_knots.back());
    const double v = uniform(random, found.v_knots.front(), found.v_knots.back());
    const Vec3 p = point_at(found, {u, v});
    largest = std::max(largest, surface->Value(u, v).Distance(gp_Pnt(p[0], p[1], p[2])));
  }
  EXPECT_LE(largest, allowed) << what << " " << surface->DynamicType()->Name();
}

TEST(RealModels, HaveFacesThatBecomePatchesWithTheSamePoints) {
  const std::set<fs::path> files = models();
  if (files.empty()) GTEST_SKIP() << blossom::testing::kNoTestData;
  quiet_messages();
  Random random(1);
  for (const fs::path& file : files) {
    const Model model = testing::repaired_model(file);
    EXPECT_GT(model.face_count(), 0) << file;
    for (int i = 1; i <= model.face_count(); ++i) {
      const std::string what = file.filename().string() + " face " + std::to_string(i);
      EXPECT_NO_THROW(compare(model.face(i), what, random)) << what;
    }
  }
}

// Along its seam this face has a span of 1e-8, which folds back within the tolerance that the seam
// states. What it is there nobody can say, so the span counts as the seam, and that is counted.
TEST(RealModels, FoldNarrowerThanTheSeamIsExactBelongsToTheSeam) {
  const std::set<fs::path> files = models();
  const auto file = std::ranges::find(files, fs::path("elliptiplane.brep"), &fs::path::filename);
  if (file == files.end()) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no models/elliptiplane.brep";
  quiet_messages();
  IntersectionOptions options;
  options.budget = 200'000;
  const ShapeIntersection found =
      self_intersect({testing::repaired_model(*file).face(8)}, SelfScope::EachFace, options);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_GT(found.certificate.identified, 0);
  EXPECT_GT(found.certificate.identified_within, 1e-7);
  EXPECT_LT(found.certificate.identified_within, 1e-4);
}

}  // namespace
}  // namespace blossom::occt
