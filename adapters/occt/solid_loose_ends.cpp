// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solid_loose_ends.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "core/base/tolerances.h"

namespace blossom::occt {
namespace {

constexpr double kOneEnd = 10;  // tolerances of points and edges: what is so near is one end

struct NearestEdge {
  TopoDS_Edge edge;
  double distance = std::numeric_limits<double>::infinity();
};

NearestEdge nearest_edge(const TopoDS_Face& face, const Vec3& point) {
  const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(point[0], point[1], point[2]));
  NearestEdge best;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepExtrema_DistShapeShape found(vertex, edge);
    if (found.IsDone() && found.Value() < best.distance) best = {edge, found.Value()};
  }
  return best;
}

double reach_of(const TopoDS_Edge& edge) {
  return kOneEnd * std::max(Tolerances{}.point, edge.IsNull() ? 0.0 : BRep_Tool::Tolerance(edge));
}

bool begins_at(const TopoDS_Edge& edge, const Vec3& point, double reach) {
  for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
    const gp_Pnt p = BRep_Tool::Pnt(vertex);
    if (distance({p.X(), p.Y(), p.Z()}, point) <= reach) return true;
  }
  return false;
}

class Search {
 public:
  Search(const std::vector<CrossingCurve>& curves, const std::array<CrossedSolid, 2>& solids)
      : curves_(curves), solids_(solids) {}

  std::vector<std::string> sentences() {
    for (std::size_t curve = 0; curve < curves_.size(); ++curve)
      for (const std::size_t end : {0u, 1u})
        for (const std::size_t side : {0u, 1u}) look(curve, end, side);
    return std::move(found_);
  }

 private:
  const TopoDS_Face& face(std::size_t curve, std::size_t side) const {
    return (*solids_[side].faces)[curves_[curve].faces[side]];
  }

  // Whether the curve goes on in the face of one side, where it leaves that of the other one.
  void look(std::size_t curve, std::size_t end, std::size_t side) {
    const Vec3& point = curves_[curve].ends[end];
    const NearestEdge left = nearest_edge(face(curve, 1 - side), point);
    const double reach = reach_of(left.edge);
    if (left.distance > reach || goes_on(curve, end, side, reach)) return;
    const NearestEdge own = nearest_edge(face(curve, side), point);
    if (own.distance <= reach_of(own.edge)) return;
    tell(curve, side, point, left.edge);
  }

  bool goes_on(std::size_t curve, std::size_t end, std::size_t side, double reach) const {
    const Vec3& point = curves_[curve].ends[end];
    const std::size_t in = curves_[curve].faces[side];
    for (std::size_t other = 0; other < curves_.size(); ++other)
      for (const std::size_t k : {0u, 1u})
        if (curves_[other].faces[side] == in && !(other == curve && k == end) &&
            distance(curves_[other].ends[k], point) <= reach)
          return true;
    const std::vector<TopoDS_Edge>& lying = (*solids_[side].lying)[in];
    return std::any_of(lying.begin(), lying.end(),
                       [&](const TopoDS_Edge& edge) { return begins_at(edge, point, reach); });
  }

  std::string name(std::size_t curve, std::size_t side) const {
    return "face " + std::to_string(curves_[curve].faces[side] + 1) + " of the " +
           solids_[side].name;
  }

  void tell(std::size_t curve, std::size_t side, const Vec3& point, const TopoDS_Edge& edge) {
    std::ostringstream text;
    text << name(curve, 1 - side) << ": its intersection with " << name(curve, side) << " ends at ("
         << point[0] << ", " << point[1] << ", " << point[2] << "), on an edge of tolerance "
         << BRep_Tool::Tolerance(edge) << ", and goes on in no other face";
    found_.push_back(text.str());
  }

  const std::vector<CrossingCurve>& curves_;
  const std::array<CrossedSolid, 2>& solids_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> loose_ends(const std::vector<CrossingCurve>& curves,
                                    const std::array<CrossedSolid, 2>& solids) {
  return Search(curves, solids).sentences();
}

}  // namespace blossom::occt
