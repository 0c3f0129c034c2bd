// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/scene/hatch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/unbounded.h"

namespace blossom::pictures {
namespace {

constexpr int kPointsOfCurve = 32;  // of an edge that is no straight line in the parameters
constexpr int kMaxLines = 200;      // of a hatch, whatever the spacing
constexpr int kPointsOfLine = 12;   // between two crossings of a line and the polygons

struct ParameterBounds {
  Vec2 low = {kInfinity, kInfinity};
  Vec2 high = -low;
};

ParameterBounds bounds_of(const std::vector<std::vector<Vec2>>& polygons) {
  ParameterBounds box;
  for (const std::vector<Vec2>& polygon : polygons)
    for (const Vec2& p : polygon)
      for (int k = 0; k < 2; ++k) {
        box.low[k] = std::min(box.low[k], p[k]);
        box.high[k] = std::max(box.high[k], p[k]);
      }
  return box;
}

// Lengths per parameter in the middle; where a surface has none there, the parameters' own.
Vec2 stretch_of(const BRepAdaptor_Surface& surface, const ParameterBounds& box) {
  gp_Pnt point;
  gp_Vec along_u, along_v;
  const Vec2 middle = 0.5 * (box.low + box.high);
  surface.D1(middle[0], middle[1], point, along_u, along_v);
  const double u = along_u.Magnitude(), v = along_v.Magnitude();
  return {u > 0 ? u : 1, v > 0 ? v : 1};
}

// Where the line a u + b v = level meets the sides, as b u - a v, in order.
std::vector<double> crossings(const std::vector<std::vector<Vec2>>& polygons, const Vec2& normal,
                              double level) {
  std::vector<double> at;
  for (const std::vector<Vec2>& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double from = dot(normal, p) - level, to = dot(normal, q) - level;
      if ((from < 0) == (to < 0)) continue;
      const Vec2 meet = p + (from / (from - to)) * (q - p);
      at.push_back(normal[1] * meet[0] - normal[0] * meet[1]);
    }
  std::ranges::sort(at);
  return at;
}

std::vector<std::vector<Vec3>> lines_of(const TopoDS_Face& face,
                                        const std::vector<std::vector<Vec2>>& polygons,
                                        double spacing) {
  std::vector<std::vector<Vec3>> lines;
  const ParameterBounds box = bounds_of(polygons);
  if (!(box.low[0] < box.high[0]) || !(box.low[1] < box.high[1])) return lines;
  const BRepAdaptor_Surface surface(face, Standard_False);
  // In lengths, the lines are x + y = level.
  const Vec2 normal = stretch_of(surface, box);
  const double first = dot(normal, box.low), last = dot(normal, box.high);
  const double step = std::max(spacing * std::sqrt(2.0), (last - first) / kMaxLines);
  const double square = dot(normal, normal);
  for (double level = first + step / 2; level < last; level += step) {
    const std::vector<double> at = crossings(polygons, normal, level);
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      if (!(at[i] < at[i + 1])) continue;
      lines.emplace_back();
      for (int k = 0; k <= kPointsOfLine; ++k) {
        const double t = at[i] + (at[i + 1] - at[i]) * k / kPointsOfLine;
        const gp_Pnt p = surface.Value((normal[0] * level + normal[1] * t) / square,
                                       (normal[1] * level - normal[0] * t) / square);
        lines.back().push_back({p.X(), p.Y(), p.Z()});
      }
    }
  }
  return lines;
}

std::vector<Vec2> polygon_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  std::vector<Vec2> polygon;
  for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next()) {
    double from = 0, to = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(it.Current(), face, from, to);
    if (curve.IsNull()) continue;
    if (it.Current().Orientation() == TopAbs_REVERSED) std::swap(from, to);
    const int count = Handle(Geom2d_Line)::DownCast(curve).IsNull() ? kPointsOfCurve : 1;
    for (int i = 0; i < count; ++i) {
      const gp_Pnt2d p = curve->Value(from + (to - from) * i / count);
      polygon.push_back({p.X(), p.Y()});
    }
  }
  return polygon;
}

}  // namespace

std::vector<std::vector<Vec3>> hatch_lines(const TopoDS_Face& face,
                                           const std::vector<std::vector<Vec2>>& polygons,
                                           double spacing) {
  return occt::guarded("hatching a face", [&] { return lines_of(face, polygons, spacing); });
}

std::vector<std::vector<Vec2>> wire_polygons(const TopoDS_Face& face) {
  return occt::guarded("hatching a face", [&] {
    std::vector<std::vector<Vec2>> polygons;
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer it(forward, TopAbs_WIRE); it.More(); it.Next())
      polygons.push_back(polygon_of(TopoDS::Wire(it.Current()), forward));
    return polygons;
  });
}

}  // namespace blossom::pictures
