// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/border_fitting.h"

#include <algorithm>
#include <utility>

#include "core/forms/algebra/de_casteljau.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/interpolation.h"
#include "core/math/index.h"
#include "core/watertight/piece_sides.h"

namespace blossom {
namespace {

constexpr int kGapSamples = 6;  // of a side, for its distance from the surface
constexpr double kStep = 1e-3;  // of a side's parameter, for its direction

Vec3 across_of(const Vec3& way, const Vec3& along) {
  const double square = dot(along, along);
  return square > 0 ? way - dot(way, along) / square * along : way;
}

double largest_gap(const BezierCurve& a, const BezierCurve& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.points.size(); ++k)
    most = std::max(most, distance(a.points[k], b.points[k]));
  return most;
}

class Mover {
 public:
  Mover(WatertightPieces& pieces, const std::vector<bool>& uneven_edges)
      : pieces_(pieces), uneven_edges_(uneven_edges) {
    moves_.way.assign(pieces.sides.size(), 0);
    moves_.edge_gap.assign(pieces.sides.size(), 0);
  }

  SideMoves moved() {
    for (WatertightSide& side : pieces_.sides) {
      if (side.edge >= 0) continue;
      side.curve.points.front() = pieces_.vertices[index(side.from)];
      side.curve.points.back() = pieces_.vertices[index(side.to)];
    }
    for (WatertightPiece& piece : pieces_.pieces) move_piece(piece);
    return std::move(moves_);
  }

 private:
  void move_piece(WatertightPiece& piece) {
    for (std::size_t k = 0; k < piece.sides.size(); ++k)
      piece.along.push_back(runs_along(piece, k));
    double most = 0;
    for (std::size_t k = 0; k < piece.sides.size(); ++k) most = std::max(most, move_side(piece, k));
    piece.moved += most;
  }

  // The points that the piece is to have along its side k.
  BezierCurve wanted_along(const WatertightPiece& piece, std::size_t k,
                           const BezierCurve& own) const {
    const WatertightSide& side = pieces_.sides[index(piece.sides[k])];
    BezierCurve wanted = side.curve;
    if (wanted.points.empty())
      wanted.points.assign(own.points.size(), pieces_.vertices[index(side.from)]);
    else if (!piece.along[k])
      std::ranges::reverse(wanted.points);
    if (wanted.degree() < own.degree()) wanted = elevated(wanted, own.degree());
    if (wanted.degree() > own.degree()) wanted = own;
    wanted.points.front() = pieces_.vertices[index(piece.vertices[k])];
    wanted.points.back() = pieces_.vertices[index(piece.vertices[(k + 1) % piece.vertices.size()])];
    return wanted;
  }

  // Returns the largest way of a control point.
  double move_side(WatertightPiece& piece, std::size_t k) {
    const std::size_t number = index(piece.sides[k]);
    const int edge = pieces_.sides[number].edge;
    const BezierCurve own = side_curve(piece, static_cast<int>(k));
    const BezierCurve wanted = wanted_along(piece, k, own);
    const bool across = edge >= 0 && !uneven_edges_.empty() && uneven_edges_[index(edge)];
    for (const double t : extreme_points(kGapSamples - 1)) {
      Vec3 way = point_at(own, t) - point_at(wanted, t);
      if (across) way = across_of(way, point_at(wanted, t + kStep) - point_at(wanted, t - kStep));
      moves_.edge_gap[number] = std::max(moves_.edge_gap[number], norm(way));
    }
    const double gap = largest_gap(own, wanted);
    moves_.way[number] = std::max(moves_.way[number], gap);
    set_side_curve(piece, static_cast<int>(k), wanted);
    return gap;
  }

  // Whether the piece runs along the side as the side's curve does. A side between equal vertices
  // is told by the nearer end of the middle.
  bool runs_along(const WatertightPiece& piece, std::size_t k) const {
    const WatertightSide& side = pieces_.sides[index(piece.sides[k])];
    if (side.from != side.to || side.curve.points.empty()) return piece.vertices[k] == side.from;
    const Vec3 own = point_at(side_curve(piece, static_cast<int>(k)), 0.25);
    return distance(own, point_at(side.curve, 0.25)) <= distance(own, point_at(side.curve, 0.75));
  }

  WatertightPieces& pieces_;
  const std::vector<bool>& uneven_edges_;
  SideMoves moves_;
};

}  // namespace

SideMoves move_sides(WatertightPieces& pieces, const std::vector<bool>& uneven_edges) {
  return Mover(pieces, uneven_edges).moved();
}

}  // namespace blossom
