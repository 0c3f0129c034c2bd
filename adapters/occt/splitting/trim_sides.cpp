// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/trim_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/distance.h"
#include "adapters/occt/faces/face_groups.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/queries/solid_rays.h"
#include "adapters/occt/splitting/edge_images.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

// Below this cosine between the way into the piece and the tool's normal, a side is not decided.
constexpr double kMinCosine = 1e-4;
// Of cells, for a nearest point. More are needed only where many points are all but equally near,
// as from about the middle of a sphere.
constexpr long kMaxPairs = 500;
// Of the distance. When the pairs are spent and its bounds are nearer than this to each other, the
// point is one of those that are all but equally near, and any of them will do.
constexpr double kEquallyNear = 1e-3;
// Places on a cut, as fractions, where the side is looked at.
constexpr std::array kLooks{0.5, 0.23, 0.77};

gp_Vec oriented_normal(const TopoDS_Face& face, const Vec2& uv) {
  gp_Pnt point;
  gp_Vec du, dv;
  BRep_Tool::Surface(face)->D1(uv[0], uv[1], point, du, dv);
  const gp_Vec normal = du.Crossed(dv);
  return face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

double cosine(const gp_Vec& a, const gp_Vec& b) {
  const double size = a.Magnitude() * b.Magnitude();
  return size > 0 ? a.Dot(b) / size : 0;
}

ToolSide side_from(double cosine) {
  if (std::abs(cosine) < kMinCosine) return ToolSide::Unknown;
  return cosine > 0 ? ToolSide::Above : ToolSide::Below;
}

// The pieces that hang together over edges that the tool does not cut.
std::vector<FaceGroup> groups_of(const std::vector<SidedPiece>& pieces, int tool) {
  TopTools_MapOfShape cut_edges;
  std::vector<TopoDS_Shape> faces;
  for (const SidedPiece& piece : pieces) {
    faces.push_back(piece.piece->face);
    for (const CutUse& use : piece.piece->cuts)
      if ((*piece.sources)[static_cast<std::size_t>(use.cut)].tool == tool) cut_edges.Add(use.edge);
  }
  return groups_over_edges(faces,
                           [&](const TopoDS_Shape& edge) { return cut_edges.Contains(edge); });
}

// What the cuts on a piece's border say, all together.
struct Votes {
  bool above = false;
  bool below = false;
  ToolSide side() const {
    return above == below ? ToolSide::Unknown : above ? ToolSide::Above : ToolSide::Below;
  }
};

Votes votes_of(const SidedPiece& piece, int tool) {
  Votes votes;
  for (const CutUse& use : piece.piece->cuts) {
    const CutSource& source = (*piece.sources)[static_cast<std::size_t>(use.cut)];
    if (source.tool != tool || source.tangential) continue;
    const ToolSide side = side_at_cut(piece, use);
    votes.above = votes.above || side == ToolSide::Above;
    votes.below = votes.below || side == ToolSide::Below;
  }
  return votes;
}

// The solids of a tool, made ready for rays when the first point is asked for.
class SolidClassifier {
 public:
  explicit SolidClassifier(const std::vector<TopoDS_Solid>& solids) : solids_(solids) {}

  /// Below is inside of one of them; unknown if no ray tells.
  ToolSide side(const gp_Pnt& point) {
    if (rays_.empty())
      for (const TopoDS_Solid& solid : solids_)
        rays_.emplace_back(faces_of(solid), Precision::Confusion());
    ToolSide side = ToolSide::Above;
    for (SolidRays& rays : rays_) {
      const std::optional<bool> inside = rays.is_inside({point.X(), point.Y(), point.Z()});
      if (!inside) side = ToolSide::Unknown;
      if (inside.value_or(false)) return ToolSide::Below;
    }
    return side;
  }

 private:
  const std::vector<TopoDS_Solid>& solids_;
  std::vector<SolidRays> rays_;
};

std::optional<ShapeDistance> nearest_on(const TopoDS_Face& face, const gp_Pnt& point) {
  try {
    return nearest_point(MeasuredShape(face), {point.X(), point.Y(), point.Z()},
                         {.budget = kMaxPairs});
  } catch (const std::runtime_error&) {
    return std::nullopt;  // such a face decides nothing
  }
}

bool is_settled(const ShapeDistance& found) {
  return found.status != Status::Stopped || found.upper - found.lower <= kEquallyNear * found.upper;
}

// Between the way from the nearest point and the face's normal there.
double cosine_at(const TopoDS_Face& face, const ShapePoint& nearest, const gp_Pnt& point) {
  const gp_Pnt foot(nearest.point[0], nearest.point[1], nearest.point[2]);
  Vec2 uv = nearest.uv;
  if (nearest.on.IsNull() || nearest.on.ShapeType() != TopAbs_FACE) {
    const gp_Pnt2d on_face =
        ShapeAnalysis_Surface(BRep_Tool::Surface(face)).ValueOfUV(foot, Precision::Confusion());
    uv = {on_face.X(), on_face.Y()};
  }
  return cosine(gp_Vec(foot, point), oriented_normal(face, uv));
}

// By the nearest point; where faces are equally near (at their common edge) by the one whose
// normal is the most decided. Unknown if a face whose distance is not settled may be nearer.
ToolSide side_of_faces(const std::vector<TopoDS_Face>& faces, const gp_Pnt& point) {
  double least = kInfinity, decided = 0, least_open = kInfinity;
  for (const TopoDS_Face& face : faces) {
    const auto found = nearest_on(face, point);
    if (found && !is_settled(*found)) least_open = std::min(least_open, found->lower);
    if (!found || !is_settled(*found) || found->upper > least + Precision::Confusion()) continue;
    const double side = cosine_at(face, found->b, point);
    const bool nearer = found->upper < least - Precision::Confusion();
    if (nearer || std::abs(side) > std::abs(decided)) decided = side;
    least = std::min(least, found->upper);
  }
  return least_open > least + Precision::Confusion() ? side_from(decided) : ToolSide::Unknown;
}

// A sheet need not part space: what reaches past its border may lie on both sides of it, and is on
// none then.
ToolSide side_of_sheet(const TopoDS_Face& piece, const gp_Pnt& inside, const TrimTool& sheet) {
  const ToolSide side = side_of_faces(sheet.faces, inside);
  for (TopExp_Explorer it(piece, TopAbs_VERTEX); it.More() && side != ToolSide::Unknown;
       it.Next()) {
    const gp_Pnt corner = BRep_Tool::Pnt(TopoDS::Vertex(it.Current()));
    const ToolSide there = side_of_faces(sheet.faces, corner);
    if (there != side && there != ToolSide::Unknown) return ToolSide::Unknown;
  }
  return side;
}

ToolSide side_by_point(const TopoDS_Face& piece, const TrimTool& tool, SolidClassifier& solids) {
  const std::optional<gp_Pnt> point = point_inside(piece);
  if (!point) return ToolSide::Unknown;
  return tool.is_solid() ? solids.side(*point) : side_of_sheet(piece, *point, tool);
}

}  // namespace

bool lies_on(const TopoDS_Face& piece, const TopoDS_Face& face, double reach) {
  const std::optional<gp_Pnt> point = point_inside(piece);
  if (!point) return false;
  const Vec3 p{point->X(), point->Y(), point->Z()};
  const SurfaceProjector feet(face, Precision::Confusion());
  const Vec2 uv = feet.foot(p, {});
  if (feet.gap(p, uv) > reach) return false;
  return is_inside_by_periods(face_trims(face), uv);
}

ToolSide side_at_cut(const SidedPiece& piece, const CutUse& use) {
  const auto index = static_cast<std::size_t>(use.cut);
  const FaceCut& cut = (*piece.cuts)[index];
  const CutSource& source = (*piece.sources)[index];
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(piece.piece->face);
  const double direction = use.at.to > use.at.from ? 1 : -1;
  Votes votes;
  for (const double look : kLooks) {
    const double s = at(use.at, look);
    const Vec2 uv = point_at(cut.chart, s);
    const Vec2 along = direction * derivative_at(cut.chart, s);
    gp_Pnt point;
    gp_Vec du, dv;
    surface->D1(uv[0], uv[1], point, du, dv);
    const gp_Vec inwards = du * -along[1] + dv * along[0];
    const ToolSide side = side_from(
        cosine(inwards, oriented_normal(source.tool_face, point_at(source.tool_chart, s))));
    votes.above = votes.above || side == ToolSide::Above;
    votes.below = votes.below || side == ToolSide::Below;
  }
  return votes.side();
}

std::vector<ToolSide> sides_of(const std::vector<SidedPiece>& pieces, const TrimTool& tool,
                               int number, const WorkLimit* limit) {
  std::vector<ToolSide> sides(pieces.size(), ToolSide::Unknown);
  SolidClassifier solids(tool.solids);
  for (const FaceGroup& group : groups_of(pieces, number)) {
    if (limit != nullptr && limit->reached_after_search() != nullptr) break;
    std::vector<Votes> own;
    Votes common;
    for (const std::size_t i : group) {
      own.push_back(votes_of(pieces[i], number));
      common.above = common.above || own.back().above;
      common.below = common.below || own.back().below;
    }
    const bool torn = common.above && common.below;
    const ToolSide side = common.above || common.below
                              ? common.side()
                              : side_by_point(pieces[group.front()].piece->face, tool, solids);
    for (std::size_t k = 0; k < group.size(); ++k) sides[group[k]] = torn ? own[k].side() : side;
  }
  return sides;
}

}  // namespace blossom::occt
