// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections of solids that touch along faces and lines, named after Open CASCADE's own tests of
// them: each curve is told by several pairs of faces and counts once.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/curve_queries.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;
constexpr int kPieces = 256;  // of a curve

struct Piece {
  gp_Pnt middle;
  double length;
};

std::vector<Piece> pieces_of(const Handle(Geom_Curve) & curve) {
  std::vector<Piece> pieces;
  const double from = curve->FirstParameter(), to = curve->LastParameter();
  gp_Pnt last = curve->Value(from);
  for (int i = 1; i <= kPieces; ++i) {
    const gp_Pnt next = curve->Value(from + (to - from) * i / kPieces);
    const gp_Pnt middle = curve->Value(from + (to - from) * (i - 0.5) / kPieces);
    pieces.push_back({middle, last.Distance(middle) + middle.Distance(next)});
    last = next;
  }
  return pieces;
}

// The length of all curves together, what runs along an earlier one left out.
double union_length(const ShapeIntersection& found) {
  std::vector<std::vector<Piece>> known;
  double length = 0;
  for (const FaceIntersection& pair : found.pairs)
    for (const EdgeCurves& edge : pair.edges) {
      const std::vector<Piece> pieces = pieces_of(edge.curve);
      for (const Piece& piece : pieces) {
        bool is_new = true;
        for (const auto& other : known)
          for (const Piece& q : other)
            is_new = is_new && piece.middle.Distance(q.middle) > 0.5 * q.length + 1e-5;
        if (is_new) length += piece.length;
      }
      known.push_back(pieces);
    }
  return length;
}

int overlaps_in(const ShapeIntersection& found) {
  std::size_t count = 0;
  for (const FaceIntersection& pair : found.pairs) count += pair.found.overlaps.size();
  return static_cast<int>(count);
}

// The box stands in the half of the cylinder with x > 0: their bottoms share a half disk, three
// sides of the box touch the cylinder along lines or meet it in them.
TEST(StatedSolids, CylinderAndPrismOnOnePlane) {
  const auto cylinder = faces_of(BRepPrimAPI_MakeCylinder(1, 4).Shape());
  const auto prism = faces_of(BRepPrimAPI_MakeBox(gp_Pnt(0, -1, 0), gp_Pnt(1, 1, 2)).Shape());
  for (const bool turned : {false, true}) {
    const ShapeIntersection found =
        turned ? intersect(prism, cylinder) : intersect(cylinder, prism);
    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_EQ(overlaps_in(found), 1);
    // Half circles at z = 0 and 2, lines of 2 at (0, -1), (0, 1), (1, 0), and one at the bottom.
    EXPECT_NEAR(union_length(found), 2 * kPi + 8, 1e-3);
  }
}

TopoDS_Edge seam_of(const TopoDS_Shape& cylinder) {
  for (TopExp_Explorer edges(cylinder, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    if (bezier_spans(edge).spans.size() == 1) return edge;  // circles have several
  }
  return {};
}

// One cylinder half inside the other, on one axis: their sides coincide between two circles. Open
// CASCADE's section of 301.327 counts the line, too, that both seams have in common.
TEST(StatedSolids, CylindersOnOneAxisWithEqualSides) {
  const TopoDS_Shape low = BRepPrimAPI_MakeCylinder(20, 100).Shape();
  const TopoDS_Shape high =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 50), gp::DZ()), 20, 100).Shape();
  const ShapeIntersection found = intersect(faces_of(low), faces_of(high));
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_EQ(overlaps_in(found), 1);
  const CurveIntersection seams = intersect(seam_of(low), seam_of(high));
  ASSERT_EQ(seams.overlaps.size(), 1);
  const double on_seam = std::abs(length(seams.overlaps[0].a));
  EXPECT_NEAR(union_length(found) + on_seam, 301.327, 1e-2);
}

}  // namespace
}  // namespace blossom::occt
