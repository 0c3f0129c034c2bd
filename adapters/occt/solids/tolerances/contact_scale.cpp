// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/tolerances/contact_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/curve_queries.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/limits.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

constexpr double kOneWithGap = 1.1;  // of a gap: what is so much farther counts as one with it

constexpr std::array kLooks{0.0, 0.25, 0.5, 0.75, 1.0};  // at a run

Bnd_Box box_of(const TopoDS_Shape& shape, double margin) {
  Bnd_Box box = bounds_of(shape);
  box.Enlarge(margin);
  return box;
}

// Vertices, edges and faces of one solid, each once, with boxes.
struct Parts {
  struct Part {
    TopoDS_Shape shape;
    Bnd_Box box;
  };
  std::vector<Part> vertices, edges, faces;

  Parts(const TrimTool& solid, double margin) {
    const auto gather = [&](TopAbs_ShapeEnum kind, std::vector<Part>& into) {
      TopTools_IndexedMapOfShape map;
      for (const TopoDS_Face& face : solid.faces) TopExp::MapShapes(face, kind, map);
      for (int i = 1; i <= map.Extent(); ++i)
        if (kind != TopAbs_EDGE || !BRep_Tool::Degenerated(TopoDS::Edge(map(i))))
          into.push_back({map(i), box_of(map(i), margin)});
    };
    gather(TopAbs_VERTEX, vertices);
    gather(TopAbs_EDGE, edges);
    gather(TopAbs_FACE, faces);
  }
};

// The nearest point of an edge but its ends: these are vertices.
std::optional<double> distance_from(const gp_Pnt& point, const TopoDS_Edge& edge) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) return std::nullopt;
  const GeomAPI_ProjectPointOnCurve feet(point, curve, range.from, range.to);
  if (feet.NbPoints() == 0) return std::nullopt;
  return feet.LowerDistance();
}

gp_Pnt point_of(const TopoDS_Edge& edge, double t) {
  double first = 0, last = 0;
  return BRep_Tool::Curve(edge, first, last)->Value(t);
}

class Gaps {
 public:
  Gaps(double reach, const SharedLimit& limit) : reach_(reach), limit_(limit) {}

  void measure(const Parts& a, const Parts& b) {
    for (const auto& [of, others] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
      for (const Parts::Part& vertex : of->vertices) from_vertex(vertex, *others);
      for (const Parts::Part& edge : of->edges)
        for (const Parts::Part& face : others->faces)
          if (!edge.box.IsOut(face.box))
            between(TopoDS::Edge(edge.shape), TopoDS::Face(face.shape));
    }
    for (const Parts::Part& x : a.edges)
      for (const Parts::Part& y : b.edges)
        if (!x.box.IsOut(y.box)) between(TopoDS::Edge(x.shape), TopoDS::Edge(y.shape));
  }

  std::vector<double> found() {
    std::ranges::sort(found_);
    return std::move(found_);
  }

 private:
  void add(double gap) {
    if (gap <= reach_) found_.push_back(gap);
  }

  IntersectionOptions options() const {
    IntersectionOptions made = limit_.remaining();
    made.tolerances.point = reach_;
    return made;
  }

  void from_vertex(const Parts::Part& vertex, const Parts& others) {
    const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(vertex.shape));
    for (const Parts::Part& other : others.vertices)
      add(point.Distance(BRep_Tool::Pnt(TopoDS::Vertex(other.shape))));
    for (const Parts::Part& edge : others.edges)
      if (!edge.box.IsOut(vertex.box))
        if (const auto gap = distance_from(point, TopoDS::Edge(edge.shape))) add(*gap);
    for (const Parts::Part& face : others.faces)
      if (!face.box.IsOut(vertex.box)) {
        const SurfaceProjector feet(TopoDS::Face(face.shape), reach_);
        add(feet.gap(vec(point), feet.foot(vec(point), {})));
      }
  }

  // Crossings have no gap; contacts have that of their points, and runs that at some of theirs:
  // bounds that are proven for them may be far above it.
  void between(const TopoDS_Edge& a, const TopoDS_Edge& b) {
    const CurveIntersection common = intersect(a, b, options());
    const auto add_at = [&](double t) {
      if (const auto gap = distance_from(point_of(a, t), b)) add(*gap);
    };
    for (const CurvePoint& point : common.points) add_at(point.a);
    for (const CurveOverlap& run : common.overlaps)
      for (const double part : kLooks) add_at(at(run.a, part));
  }

  void between(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    const CurveSurfaceIntersection common = intersect(edge, face, options());
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    for (const CurveSurfacePoint& point : common.points)
      add(point_of(edge, point.t).Distance(surface->Value(point.uv[0], point.uv[1])));
    const SurfaceProjector feet(face, reach_);
    for (const CurveSurfaceOverlap& run : common.overlaps)
      for (const double part : kLooks) {
        const Vec3 point = vec(point_of(edge, at(run.t, part)));
        add(feet.gap(point, feet.foot(point, {})));
      }
  }

  const double reach_;
  const SharedLimit& limit_;
  std::vector<double> found_;
};

}  // namespace

std::vector<double> contact_gaps(const TrimTool& a, const TrimTool& b, double reach,
                                 const SharedLimit& limit) {
  return guarded("measuring gaps", [&] {
    Gaps gaps(reach, limit);
    gaps.measure(Parts(a, reach), Parts(b, reach));
    return gaps.found();
  });
}

double contact_scale(const std::vector<double>& gaps, double tolerance) {
  const double reach = kLooseReach * kLooseReach * tolerance;
  double below = tolerance;
  Interval widest{tolerance, tolerance};
  const auto end_range = [&](double above) {
    if (above * widest.from > widest.to * below) widest = {below, above};
  };
  for (const double gap : gaps) {
    if (gap > kOneWithGap * kLooseReach * tolerance) {
      end_range(std::min(gap, reach));
      break;
    }
    if (gap > below) end_range(gap);
    below = std::max(below, kOneWithGap * gap);
  }
  if (gaps.empty() || gaps.back() <= kOneWithGap * kLooseReach * tolerance)
    end_range(kOneWithGap * kOneWithGap * reach);  // it is wider than what was looked at
  return std::min(std::sqrt(widest.from * widest.to),
                  std::max(kLooseReach * tolerance, widest.from));
}

}  // namespace blossom::occt
