// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/solid_loose_ends.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/convert/hulls.h"
#include "core/base/tolerances.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

constexpr double kOneEnd = 10;  // tolerances of points and edges: what is so near is one end

struct NearestEdge {
  TopoDS_Edge edge;
  double distance = kInfinity;
};

double reach_of(const TopoDS_Edge& edge) {
  return kOneEnd * std::max(Tolerances{}.point, edge.IsNull() ? 0.0 : BRep_Tool::Tolerance(edge));
}

struct BoxedEdge {
  TopoDS_Edge edge;
  Bnd_Box reach;  // what is outside is farther off than one end
};

std::vector<BoxedEdge> boxed_edges(const TopoDS_Face& face) {
  std::vector<BoxedEdge> all;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    Bnd_Box box = bounds_of(edge);
    box.Enlarge(reach_of(edge));
    all.push_back({edge, box});
  }
  return all;
}

// Of those that may be within their reach.
NearestEdge nearest_edge(const std::vector<BoxedEdge>& edges, const Vec3& point) {
  const gp_Pnt at(point[0], point[1], point[2]);
  const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(at);
  NearestEdge best;
  for (const BoxedEdge& each : edges) {
    if (each.reach.IsOut(at)) continue;
    const BRepExtrema_DistShapeShape found(vertex, each.edge);
    if (found.IsDone() && found.Value() < best.distance) best = {each.edge, found.Value()};
  }
  return best;
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
      : curves_(curves), solids_(solids) {
    for (const std::size_t side : {0u, 1u}) {
      edges_[side].resize(solids[side].solid->faces.size());
      ends_[side].resize(solids[side].solid->faces.size());
      for (std::size_t curve = 0; curve < curves.size(); ++curve)
        for (const std::size_t end : {0u, 1u})
          ends_[side][curves[curve].faces[side]].push_back({curve, end});
    }
  }

  std::vector<std::string> sentences() {
    for (std::size_t curve = 0; curve < curves_.size(); ++curve)
      for (const std::size_t end : {0u, 1u})
        for (const std::size_t side : {0u, 1u}) look(curve, end, side);
    return std::move(found_);
  }

 private:
  struct End {
    std::size_t curve = 0, end = 0;
  };

  const std::vector<BoxedEdge>& edges(std::size_t curve, std::size_t side) {
    const std::size_t face = curves_[curve].faces[side];
    auto& known = edges_[side][face];
    if (!known) known = boxed_edges(solids_[side].solid->faces[face]);
    return *known;
  }

  // Whether the curve goes on in the face of one side, where it leaves that of the other one.
  void look(std::size_t curve, std::size_t end, std::size_t side) {
    const Vec3& point = curves_[curve].ends[end];
    const NearestEdge left = nearest_edge(edges(curve, 1 - side), point);
    const double reach = reach_of(left.edge);
    if (left.distance > reach || goes_on(curve, end, side, reach)) return;
    const NearestEdge own = nearest_edge(edges(curve, side), point);
    if (own.distance <= reach_of(own.edge)) return;
    tell(curve, side, point, left.edge);
  }

  bool goes_on(std::size_t curve, std::size_t end, std::size_t side, double reach) const {
    const Vec3& point = curves_[curve].ends[end];
    const std::size_t in = curves_[curve].faces[side];
    for (const End& other : ends_[side][in])
      if (!(other.curve == curve && other.end == end) &&
          distance(curves_[other.curve].ends[other.end], point) <= reach)
        return true;
    const std::vector<TopoDS_Edge>& lying = (*solids_[side].lying)[in];
    return std::any_of(lying.begin(), lying.end(),
                       [&](const TopoDS_Edge& edge) { return begins_at(edge, point, reach); });
  }

  std::string name(std::size_t curve, std::size_t side) const {
    const CrossedSolid& of = solids_[side];
    return face_name(*of.solid, curves_[curve].faces[side], "the " + of.name);
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
  // Of both solids, by face: edges, made when asked for, and ends of curves that lie in it.
  std::array<std::vector<std::optional<std::vector<BoxedEdge>>>, 2> edges_;
  std::array<std::vector<std::vector<End>>, 2> ends_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> loose_ends(const std::vector<CrossingCurve>& curves,
                                    const std::array<CrossedSolid, 2>& solids) {
  return Search(curves, solids).sentences();
}

}  // namespace blossom::occt
