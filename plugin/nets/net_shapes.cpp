// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/net_shapes.h"

#include <utility>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/base/tolerances.h"
#include "plugin/nets/pieces.h"

namespace blossom::nets {
namespace {

TopoDS_Shape face_on(const RationalBezierPatch& patch) {
  BRepBuilderAPI_MakeFace maker(occt::to_occt(patch), Tolerances{}.point);
  if (!maker.IsDone()) throw occt::BadModel("the patch gives no face");
  return maker.Shape();
}

TopoDS_Shape edge_on(const RationalBezierCurve& curve) {
  BRepBuilderAPI_MakeEdge maker(occt::to_occt(curve));
  if (!maker.IsDone()) throw occt::BadModel("the curve gives no edge: is it a point?");
  return maker.Shape();
}

using Line = std::vector<Vec3>;

void add_lines(const RationalBezierPatch& patch, std::vector<Line>& lines) {
  const Grid<Vec4>& points = patch.points;
  for (int i = 0; i < points.rows(); ++i) {
    lines.emplace_back();
    for (int j = 0; j < points.columns(); ++j) lines.back().push_back(projected(points(i, j)));
  }
  for (int j = 0; j < points.columns(); ++j) {
    lines.emplace_back();
    for (int i = 0; i < points.rows(); ++i) lines.back().push_back(projected(points(i, j)));
  }
}

void add_lines(const RationalBezierTriangle& triangle, std::vector<Line>& lines) {
  const int n = triangle.degree;
  for (int fixed = 0; fixed < n; ++fixed) {
    Line nu, mu, lambda;
    for (int k = 0; k <= n - fixed; ++k) {
      nu.push_back(projected(triangle(fixed, k)));
      mu.push_back(projected(triangle(k, fixed)));
      lambda.push_back(projected(triangle(k, n - fixed - k)));
    }
    lines.insert(lines.end(), {nu, mu, lambda});
  }
}

void add_lines(const QPatch& patch, std::vector<Line>& lines) {
  add_lines(RationalBezierPatch{patch.points}, lines);
}

}  // namespace

std::vector<Net> face_nets(const TopoDS_Face& face, const NetSource& source) {
  return named(source, [&] {
    const BezierSurface surface = occt::bezier_surface(face);
    std::vector<Net> nets;
    for (int i = 0; i < surface.patches.rows(); ++i)
      for (int j = 0; j < surface.patches.columns(); ++j) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        Net net;
        net.value = surface.patches(i, j);
        net.rational = surface.rational;
        net.u = {surface.u_knots[a], surface.u_knots[a + 1]};
        net.v = {surface.v_knots[b], surface.v_knots[b + 1]};
        net.u_law = surface.u_law;
        net.v_law = surface.v_law;
        net.source = source;
        net.source.error = surface.error;
        nets.push_back(std::move(net));
      }
    return nets;
  });
}

std::vector<Net> edge_nets(const TopoDS_Edge& edge, const NetSource& source) {
  return named(source, [&] {
    std::vector<Net> nets;
    Interval range;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
    if (curve.IsNull()) return nets;
    const CurveSpans spans = occt::profile_spans(curve, range);
    for (const CurveSpan& span : spans.spans) {
      Net net;
      net.value = span.curve;
      net.rational = spans.rational;
      net.u = span.place;
      net.u_law = span.law;
      net.source = source;
      net.source.error = spans.error;
      nets.push_back(std::move(net));
    }
    return nets;
  });
}

TopoDS_Shape net_shape(const Net& net) {
  const Net made = is_triangle(net) ? collapsed_net(net) : bezier_net(net);
  return named(net.source, [&] {
    return is_curve(made) ? edge_on(std::get<RationalBezierCurve>(made.value))
                          : face_on(std::get<RationalBezierPatch>(made.value));
  });
}

std::vector<std::vector<Vec3>> net_lines(const Net& net) {
  std::vector<Line> lines;
  if (const auto* patch = std::get_if<RationalBezierPatch>(&net.value)) add_lines(*patch, lines);
  if (const auto* patch = std::get_if<QPatch>(&net.value)) add_lines(*patch, lines);
  if (const auto* triangle = std::get_if<RationalBezierTriangle>(&net.value))
    add_lines(*triangle, lines);
  const auto* curve = std::get_if<RationalBezierCurve>(&net.value);
  const auto* q_curve = std::get_if<QCurve>(&net.value);
  if (!curve && !q_curve) return lines;
  lines.emplace_back();
  for (const Vec4& p : curve ? curve->points : q_curve->points)
    lines.back().push_back(projected(p));
  return lines;
}

}  // namespace blossom::nets
