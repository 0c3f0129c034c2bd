// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/contact_vertices.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopTools_MapOfShape.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edges_in_reach.h"
#include "adapters/occt/splitting/limits.h"

namespace blossom::occt {
namespace {

std::vector<TopoDS_Vertex> border_vertices(const TopoDS_Face& face, const EdgeSplits& splits) {
  std::vector<TopoDS_Vertex> all;
  TopTools_MapOfShape known;
  for (const TopoDS_Edge& edge : bounding_edges(face))
    for (int split = 0; split < splits.count(edge); ++split)
      if (const TopoDS_Vertex vertex = splits.vertex(edge, split); known.Add(vertex))
        all.push_back(vertex);
  return all;
}

// By parameter.
std::vector<int> ordered_splits(const TopoDS_Edge& edge, const EdgeSplits& splits) {
  std::vector<int> order(static_cast<std::size_t>(splits.count(edge)));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int split) { return splits.parameter(edge, split); });
  return order;
}

// Whether vertices that are one hold a point, at whichever of their places they are.
bool covers(const std::vector<TopoDS_Vertex>& one, const gp_Pnt& point) {
  return std::ranges::any_of(one, [&](const TopoDS_Vertex& at) {
    const gp_Pnt place = BRep_Tool::Pnt(at);
    double reach = 0;
    for (const TopoDS_Vertex& other : one)
      reach = std::max(reach, BRep_Tool::Tolerance(other) + place.Distance(BRep_Tool::Pnt(other)));
    return place.Distance(point) <= reach;
  });
}

// The longest way along which faces that touch keep within tolerance of each other: for a radius as
// long as the smaller one.
double longest_contact(const TopoDS_Face& a, const TopoDS_Face& b, double tolerance) {
  const auto size = [](const TopoDS_Face& face) {
    return std::sqrt(bounds_of(face).SquareExtent());
  };
  return std::sqrt(8 * tolerance * std::min(size(a), size(b)));
}

// A pair of faces that touch, and the vertices of their borders.
class Contacts {
 public:
  Contacts(const FaceIntersection& pair,
           const std::array<const std::vector<TopoDS_Face>*, 2>& faces,
           const std::vector<CutEnds>& ends, double tolerance, EdgeSplits& splits)
      : numbers_{static_cast<std::size_t>(pair.face_a), static_cast<std::size_t>(pair.face_b)},
        faces_{(*faces[0])[numbers_[0]], (*faces[1])[numbers_[1]]},
        tolerance_(tolerance),
        splits_(splits) {
    for (const CutEnds& cut : ends) add(cut);
  }

  // What ends in one contact becomes one vertex, with all that this vertex covers.
  void unite(const Vec3& contact) {
    std::vector<TopoDS_Vertex> one;
    for (const std::size_t side : {0u, 1u})
      for (const TopoDS_Vertex& of : border_vertices(faces_[side], splits_))
        if (ending_.Contains(of) && !own_.Contains(of) && leads_to(contact, of)) one.push_back(of);
    if (one.size() < 2) return;
    for (const TopoDS_Vertex& of : one) splits_.unite(one.front(), of);
    while (take_covered(one)) {  // what is covered makes it wider
    }
  }

 private:
  // Curves of the pair end in places of their own; those of one of the faces with a neighbour of
  // the other one end on the edge between these.
  void add(const CutEnds& cut) {
    const bool at_a = cut.faces[0] == numbers_[0], at_b = cut.faces[1] == numbers_[1];
    for (const std::size_t side : {0u, 1u})
      for (const TopoDS_Vertex& vertex : cut.vertices[side]) {
        if (at_a && at_b) own_.Add(vertex);
        if (at_a != at_b && at_a == (side == 1)) ending_.Add(vertex);
      }
  }

  // Takes the other end of an edge of which it covers the middle.
  bool take_covered(std::vector<TopoDS_Vertex>& one) {
    for (const TopoDS_Face& face : faces_)
      for (const TopoDS_Edge& edge : bounding_edges(face)) {
        const std::vector<int> order = ordered_splits(edge, splits_);
        for (std::size_t i = 0; i + 1 < order.size(); ++i) {
          const TopoDS_Vertex from = splits_.vertex(edge, order[i]);
          const TopoDS_Vertex to = splits_.vertex(edge, order[i + 1]);
          const bool holds_from = splits_.are_one(one.front(), from);
          if (holds_from == splits_.are_one(one.front(), to)) continue;
          const double middle =
              0.5 * (splits_.parameter(edge, order[i]) + splits_.parameter(edge, order[i + 1]));
          if (BRep_Tool::Degenerated(edge) || !covers(one, BRepAdaptor_Curve(edge).Value(middle)))
            continue;
          one.push_back(holds_from ? to : from);
          splits_.unite(one.front(), one.back());
          return true;
        }
      }
    return false;
  }

  // Whether both faces are one all the way to a contact.
  bool leads_to(const Vec3& contact, const TopoDS_Vertex& of) {
    const Vec3 place = vec(BRep_Tool::Pnt(of));
    if (!longest_) longest_ = longest_contact(faces_[0], faces_[1], tolerance_);
    if (distance(place, contact) > *longest_) return false;
    for (const std::size_t side : {0u, 1u}) {
      if (!feet_[side]) feet_[side].emplace(faces_[side], tolerance_);
      for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
        if (std::abs(feet_[side]->height(contact + part * (place - contact))) >
            kLiesReach * tolerance_)
          return false;
    }
    return true;
  }

  std::array<std::size_t, 2> numbers_;
  std::array<TopoDS_Face, 2> faces_;
  double tolerance_;
  EdgeSplits& splits_;
  std::array<std::optional<SurfaceProjector>, 2> feet_;
  std::optional<double> longest_;
  TopTools_MapOfShape ending_, own_;
};

}  // namespace

bool has_contact(const FaceIntersection& pair) {
  return std::ranges::count(pair.found.places, PlaceKind::Touch, &Place::kind) > 0;
}

void unite_in_contacts(const ShapeIntersection& found,
                       const std::array<const std::vector<TopoDS_Face>*, 2>& faces,
                       const std::vector<CutEnds>& ends, double tolerance, EdgeSplits& splits) {
  for (const FaceIntersection& pair : found.pairs) {
    if (!has_contact(pair)) continue;
    Contacts contacts(pair, faces, ends, tolerance, splits);
    for (const Place& place : pair.found.places)
      if (place.kind == PlaceKind::Touch) contacts.unite(0.5 * (place.box_low + place.box_high));
  }
}

}  // namespace blossom::occt
