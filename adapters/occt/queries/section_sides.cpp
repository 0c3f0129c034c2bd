// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/section_sides.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeListOfInteger.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBeside = 1e-3;  // of a curve's length: where a face's position beside it is asked

// From a curve to a point of a face beside it, and the face's normal out of the solid.
struct Beside {
  Vec3 step, normal;
};

// left   whether the point lies to the left of the chart curve, as the face has it turned forward
// null where the chart has no direction there
std::optional<Beside> point_beside(const TopoDS_Face& face, const Geom2d_Curve& pcurve, double at,
                                   bool left, double length) {
  const BRepAdaptor_Surface surface(face, false);
  gp_Pnt2d uv;
  gp_Vec2d along;
  pcurve.D1(at, uv, along);
  gp_Pnt point;
  gp_Vec u, v;
  surface.D1(uv.X(), uv.Y(), point, u, v);
  const double turn = left ? 1 : -1;
  const gp_Vec2d across(-turn * along.Y(), turn * along.X());
  const double speed = (u * across.X() + v * across.Y()).Magnitude();
  if (!(speed > 0)) return {};
  const gp_Vec2d moved = across * (kBeside * length / speed);
  const gp_Pnt beside = surface.Value(uv.X() + moved.X(), uv.Y() + moved.Y());
  const double outwards = face.Orientation() == TopAbs_REVERSED ? -1 : 1;
  return Beside{vec(beside) - vec(point), vec(u.Crossed(v)) * outwards};
}

// A face beside an edge in the plane, seen along the edge.
struct FaceBeside {
  double angle = 0;    // from the plane's one side of the edge towards its normal, in (-pi, pi]
  bool ahead = false;  // whether the solid's inside is what comes with greater angles
  bool in_plane = false;
};

class EdgeSides {
 public:
  EdgeSides(const SectionCurve& curve, const Vec3& normal) : curve_(curve), up_(normal) {
    gp_Pnt point;
    gp_Vec along;
    curve.curve->D1(middle(), point, along);
    side_ = unit(cross(up_, vec(along)));
  }

  // The edge counts as often as the face has it: a seam twice.
  void add(const TopoDS_Face& face, bool in_plane) {
    TopExp_Explorer edges(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE);
    for (; edges.More(); edges.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
      if (!edge.IsSame(curve_.edge)) continue;
      double from = 0, to = 0;
      const Handle(Geom2d_Curve) pcurve =
          BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face.Oriented(TopAbs_FORWARD)), from, to);
      if (pcurve.IsNull()) continue;
      const auto found = point_beside(face, *pcurve, middle(),
                                      edge.Orientation() != TopAbs_REVERSED, curve_.length);
      if (found) faces_.push_back(face_of(*found, in_plane));
    }
  }

  bool bounding() const { return faces_.size() < 2 || belongs(0) != belongs(kPi); }

 private:
  double middle() const { return 0.5 * (curve_.range.from + curve_.range.to); }

  FaceBeside face_of(const Beside& found, bool in_plane) const {
    const double along = dot(found.step, side_), rise = dot(found.step, up_);
    const double turned = along * dot(found.normal, up_) - rise * dot(found.normal, side_);
    return {in_plane ? (along > 0 ? 0 : kPi) : std::atan2(rise, along), turned < 0, in_plane};
  }

  // Whether the plane's side at an angle of 0 or pi is part of what plane and solid have in common:
  // the next face at greater angles has the solid's inside before it.
  bool belongs(double angle) const {
    const auto turn_to = [&](const FaceBeside& face) {
      const double turn = face.angle - angle;
      return turn < 0 ? turn + 2 * kPi : turn;
    };
    const auto next = std::ranges::min_element(faces_, {}, turn_to);
    const bool lies_there = std::ranges::any_of(
        faces_, [&](const FaceBeside& face) { return face.in_plane && face.angle == angle; });
    return lies_there || !next->ahead;
  }

  const SectionCurve& curve_;
  Vec3 up_, side_;
  std::vector<FaceBeside> faces_;
};

// Whether a face passes from one side of the plane to the other over a curve along which it is
// tangent to it.
bool crosses(const TopoDS_Face& face, const SectionCurve& curve, const Vec3& normal) {
  const double middle = 0.5 * (curve.range.from + curve.range.to);
  const auto left = point_beside(face, *curve.pcurve, middle, true, curve.length);
  const auto right = point_beside(face, *curve.pcurve, middle, false, curve.length);
  return !left || !right || dot(left->step, normal) * dot(right->step, normal) < 0;
}

}  // namespace

void find_bounding_curves(const FaceList& faces, const std::vector<char>& near,
                          const std::vector<char>& in_plane, const Vec3& normal,
                          PlaneSection& section) {
  TopTools_DataMapOfShapeListOfInteger faces_of_edge;
  for (const SectionCurve& curve : section.curves)
    if (!curve.edge.IsNull() && !faces_of_edge.IsBound(curve.edge))
      faces_of_edge.Bind(curve.edge, {});
  for (std::size_t i = 0; i < faces.size() && !faces_of_edge.IsEmpty(); ++i)
    for (TopExp_Explorer edges(faces.face(i), TopAbs_EDGE); near[i] && edges.More(); edges.Next()) {
      TColStd_ListOfInteger* owners = faces_of_edge.ChangeSeek(edges.Current());
      const int face = static_cast<int>(i);
      if (owners != nullptr && (owners->IsEmpty() || owners->Last() != face)) owners->Append(face);
    }
  for (SectionCurve& curve : section.curves) {
    if (curve.edge.IsNull()) {
      if (curve.tangential)
        curve.bounding = crosses(faces.face(static_cast<std::size_t>(curve.face)), curve, normal);
      continue;
    }
    if (curve.face < 0) continue;
    EdgeSides sides(curve, normal);
    for (const int face : faces_of_edge.Find(curve.edge)) {
      const auto i = static_cast<std::size_t>(face);
      sides.add(faces.face(i), in_plane[i] != 0);
    }
    curve.bounding = sides.bounding();
  }
}

}  // namespace blossom::occt
