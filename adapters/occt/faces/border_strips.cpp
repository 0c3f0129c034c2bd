// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/border_strips.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curve_breaks.h"
#include "core/base/unbounded.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

struct Node {
  double at, weight;
};

// Gauss's rules over [0, 1].
constexpr std::array kAlong{
    Node{0.046910077030668004, 0.11846344252809454}, Node{0.23076534494715845, 0.23931433524968324},
    Node{0.5, 0.28444444444444444}, Node{0.76923465505284155, 0.23931433524968324},
    Node{0.953089922969332, 0.11846344252809454}};
constexpr std::array kAcross{Node{0.1127016653792583, 5.0 / 18}, Node{0.5, 8.0 / 18},
                             Node{0.8872983346207417, 5.0 / 18}};

constexpr Interval kEverywhere{-kInfinity, kInfinity};

// An edge of the forward face: its curve and its image on the surface, at the same parameters.
class Strip {
 public:
  /// part   of the edge; none: all of it
  Strip(const TopoDS_Edge& edge, const TopoDS_Face& face, const GeomAdaptor_Surface& surface,
        const std::optional<Interval>& part = std::nullopt)
      : surface_(surface), reversed_(edge.Orientation() == TopAbs_REVERSED) {
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range_.from, range_.to);
    if (part) range_ = *part;
    Interval of_image;
    const Handle(Geom2d_Curve) image =
        BRep_Tool::CurveOnSurface(edge, face, of_image.from, of_image.to);
    if (image.IsNull()) throw BadModel("an edge has no parameter curve on its face");
    if (curve.IsNull() || !(range_.from < range_.to)) return;
    curve_.Load(curve, range_.from, range_.to);
    image_.Load(image, range_.from, range_.to);
    has_curve_ = true;
  }

  void integrate(const std::function<void(const Vec3&, const Vec3&)>& add) const {
    if (!has_curve_) return;
    const std::vector<double> ends = smooth_ends();
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      for (const Node& node : kAlong)
        add_line(at(Interval{ends[i], ends[i + 1]}, node.at), node.weight * (ends[i + 1] - ends[i]),
                 add);
  }

 private:
  std::vector<double> smooth_ends() const {
    std::vector<double> ends{range_.from, range_.to};
    for (const auto& breaks :
         {breaks_of(curve_.Curve(), range_), breaks_of(image_.Curve(), range_)})
      ends.insert(ends.end(), breaks.begin(), breaks.end());
    std::ranges::sort(ends);
    return ends;
  }

  // The line from the surface to the edge at a parameter. The face lies on the left of its border,
  // the strip on the right: its normal is (across) x (along).
  void add_line(double t, double width,
                const std::function<void(const Vec3&, const Vec3&)>& add) const {
    gp_Pnt2d uv;
    gp_Vec2d along_image;
    image_.D1(t, uv, along_image);
    keep_on_surface(uv, along_image);
    gp_Pnt on_surface, on_edge;
    gp_Vec along_u, along_v, along_edge;
    surface_.D1(uv.X(), uv.Y(), on_surface, along_u, along_v);
    curve_.D1(t, on_edge, along_edge);
    const Vec3 start = vec(on_surface.XYZ()), across = vec(on_edge.XYZ()) - start;
    const Vec3 first = vec((along_u * along_image.X() + along_v * along_image.Y()).XYZ());
    const Vec3 last = vec(along_edge.XYZ());
    for (const Node& node : kAcross) {
      const Vec3 along = first + node.at * (last - first);
      add(start + node.at * across,
          (reversed_ ? -width : width) * node.weight * cross(across, along));
    }
  }

  // Trims may stray over the surface's border, beyond which nothing is measured.
  void keep_on_surface(gp_Pnt2d& uv, gp_Vec2d& along) const {
    const std::array sides{
        surface_.IsUPeriodic() ? kEverywhere
                               : Interval{surface_.FirstUParameter(), surface_.LastUParameter()},
        surface_.IsVPeriodic() ? kEverywhere
                               : Interval{surface_.FirstVParameter(), surface_.LastVParameter()}};
    for (int k = 0; k < 2; ++k) {
      const Interval& side = sides[static_cast<std::size_t>(k)];
      const double kept = std::clamp(uv.Coord(k + 1), side.from, side.to);
      if (kept == uv.Coord(k + 1)) continue;
      uv.SetCoord(k + 1, kept);
      along.SetCoord(k + 1, 0);
    }
  }

  const GeomAdaptor_Surface& surface_;
  GeomAdaptor_Curve curve_;
  Geom2dAdaptor_Curve image_;
  Interval range_;
  bool reversed_ = false;
  bool has_curve_ = false;
};

}  // namespace

void over_border_strips(const TopoDS_Face& face,
                        const std::function<void(const Vec3& point, const Vec3& normal)>& add) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const GeomAdaptor_Surface surface(BRep_Tool::Surface(forward));
  for (TopExp_Explorer it(forward, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    const bool bounds =
        edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
    if (!bounds || BRep_Tool::Degenerated(edge)) continue;
    if (BRep_Tool::Tolerance(edge) > Precision::Confusion())
      Strip(edge, forward, surface).integrate(add);
  }
}

void over_border_strip(const TopoDS_Edge& edge, const TopoDS_Face& face, const Interval& part,
                       const std::function<void(const Vec3& point, const Vec3& normal)>& add) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const GeomAdaptor_Surface surface(BRep_Tool::Surface(forward));
  Strip(edge, forward, surface, part).integrate(add);
}

}  // namespace blossom::occt
