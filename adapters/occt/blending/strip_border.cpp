// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strip_border.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/edge_borders.h"
#include "adapters/occt/blending/side_sampler.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/blending/strips/strip.h"
#include "core/forms/algebra/interpolation.h"

namespace blossom::occt {
namespace {

/// Places between the nodes of a fit at which it is measured, for each node.
constexpr int kChecksPerNode = 2;

/// Degrees of fits are tried up to this before a piece is halved.
constexpr int kMaxPieceDegree = 7;

/// Directions across an edge that differ by less at a knot, radians, belong to no corner: knots of
/// files join curves to 1e-7 and worse.
constexpr double kNoCorner = 1e-5;

Border empty_border() {
  Border border;
  border.name = "edge";
  border.range = {0, 1};
  border.depth = 1;
  return border;
}

/// Scales derivatives such that the length of the first one continues over the joints of spans.
/// throws   BadModel if it turns there
void join_spans(Border& border) {
  for (std::size_t i = 1; i < border.spans.size(); ++i) {
    const BorderRows& before = border.spans[i - 1];
    BorderRows& rows = border.spans[i];
    const Vec3 end = across_at(before[0], before[1], 1), start = across_at(rows[0], rows[1], 0);
    if (norm(cross(unit(end), unit(start))) > kNoCorner || dot(end, start) < 0)
      throw BadModel("the edge has a corner, or the face a crease there");
    const double ratio = norm(end) / norm(start);
    double factor = 1;
    for (Row& row : rows) {
      for (Vec4& p : row) p *= factor;
      factor *= ratio;
    }
  }
}

bool is_plane(const TopoDS_Face& face) {
  return !Handle(Geom_Plane)::DownCast(basis_of(BRep_Tool::Surface(face))).IsNull();
}

/// A plane continues straight: derivatives beyond the first are 0.
Border plane_rows(const BorderSpans& spans) {
  Border border = empty_border();
  border.breaks.push_back(0);
  for (const BorderSpan& span : spans) {
    border.breaks.push_back(span.place.to);
    const int degree = static_cast<int>(std::max(span.edge.size(), span.across.size())) - 1;
    Row outwards = raised(span.across, degree);
    for (Vec4& p : outwards) p *= -1.0;
    const Row none(static_cast<std::size_t>(degree) + 1);
    border.spans.push_back({raised(span.edge, degree), std::move(outwards), none, none});
    for (const Vec4& p : span.edge) border.rational |= p[3] != 1;
  }
  join_spans(border);
  return border;
}

/// What rows miss, or may miss.
struct Miss {
  double point = 0;  ///< model units
  double slope = 0;  ///< of derivatives across, as a part of half the edge's chord

  bool is_within(const Miss& most) const { return point <= most.point && slope <= most.slope; }
};

struct FittedPiece {
  BorderRows rows;
  Miss off;
};

Row homogeneous_row(const BezierCurve& curve, double weight) {
  Row row;
  for (const Vec3& p : curve.points) row.push_back({p[0], p[1], p[2], weight});
  return row;
}

/// Derivatives out of the face.
std::array<Vec3, 4> outward_at(const SideSampler& sampler, double x) {
  std::array<Vec3, 4> derivatives = sampler.at(x, kMaxStripOrder).derivatives;
  derivatives[1] = -derivatives[1];
  derivatives[3] = -derivatives[3];
  return derivatives;
}

FittedPiece fitted(const SideSampler& sampler, double reach, const Interval& x, int degree) {
  std::array<std::vector<Vec3>, 4> values;
  for (const double t : extreme_points(degree)) {
    const std::array<Vec3, 4> at_node = outward_at(sampler, at(x, t));
    for (std::size_t k = 0; k < 4; ++k) values[k].push_back(at_node[k]);
  }
  FittedPiece piece;
  for (std::size_t k = 0; k < 4; ++k)
    piece.rows.push_back(homogeneous_row(bezier_through(values[k]), k == 0 ? 1 : 0));
  const int checks = kChecksPerNode * (degree + 1);
  for (int i = 0; i < checks; ++i) {
    const double t = (i + 0.5) / checks;
    const std::array<Vec3, 4> exact = outward_at(sampler, at(x, t));
    piece.off.point = std::max(piece.off.point, distance(jet_at(piece.rows[0], t).point, exact[0]));
    for (std::size_t k = 1; k < 4; ++k)
      piece.off.slope = std::max(
          piece.off.slope, distance(across_at(piece.rows[0], piece.rows[k], t), exact[k]) / reach);
  }
  return piece;
}

/// The lowest degree that is near enough; nothing if there is none.
std::optional<FittedPiece> best_fit(const SideSampler& sampler, double reach, const Interval& x,
                                    const Miss& most) {
  for (int degree = 1; degree <= kMaxPieceDegree; ++degree)
    if (FittedPiece piece = fitted(sampler, reach, x, degree); piece.off.is_within(most))
      return piece;
  return std::nullopt;
}

/// kFitPoint and kFitSlope for an edge of half the chord `reach`.
Miss most_miss(const SideSampler& sampler, double reach) {
  const double coordinate = max_norm(sampler.at(0.5, 0).derivatives[0]) + reach;
  return {std::max(kFitPoint * reach, 0x1p-46 * coordinate), kFitSlope};
}

StripBorder fitted_border(const HoleEdge& edge, const std::vector<double>& breaks) {
  const double reach = half_chord(edge);
  const SideSampler sampler(edge, reach);
  const Miss most = most_miss(sampler, reach);
  StripBorder border{.rows = empty_border()};
  border.rows.breaks.push_back(0);
  std::vector<Interval> left;
  for (std::size_t i = breaks.size() - 1; i > 0; --i) left.push_back({breaks[i - 1], breaks[i]});
  while (!left.empty()) {
    const Interval x = left.back();
    left.pop_back();
    if (length(x) < kSliver) continue;
    if (const auto piece = best_fit(sampler, reach, x, most)) {
      border.rows.spans.push_back(piece->rows);
      border.rows.breaks.push_back(x.to);
      border.error = std::max(border.error, piece->off.point);
      continue;
    }
    if (border.rows.spans.size() + left.size() >= kMaxFitSpans)
      throw BadModel("the edge is not followed by " + std::to_string(kMaxFitSpans) +
                     " polynomials");
    left.push_back({at(x, 0.5), x.to});
    left.push_back({x.from, at(x, 0.5)});
  }
  border.rows.breaks.back() = 1;
  border.rows.error = border.error;
  join_spans(border.rows);
  return border;
}

StripBorder border_along(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  if (const auto collar = iso_collar(edge, face); collar && collar->off == 0) {
    StripBorder border{border_of(collar->surface, collar->side, kMaxStripOrder), true};
    border.rows.name = "edge";
    if (collar->backward) reverse(border.rows);
    return border;
  }
  const EdgeBorder beside = edge_border(edge, face);
  if (beside.spans && is_plane(face)) return {plane_rows(*beside.spans), true};
  return guarded("looking at a face beside an edge", [&] {
    return fitted_border({.number = 0, .edge = edge, .face = face}, beside.breaks);
  });
}

}  // namespace

StripBorder strip_border(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  StripBorder border = border_along(edge, face);
  border.rows.closed = TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge));
  return border;
}

}  // namespace blossom::occt
