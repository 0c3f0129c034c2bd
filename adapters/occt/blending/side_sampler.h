// SPDX-License-Identifier: LGPL-2.1-or-later
// Places along an edge with the derivatives of its face across it.

#pragma once

#include <array>
#include <memory>
#include <optional>

#include "adapters/occt/blending/hole_loop.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

class Geom2d_Curve;

namespace blossom::occt {

/// The edge in the parameters of its face, along the way round the hole.
class EdgeInChart {
 public:
  /// throws   BadModel if the edge has no curve in its face
  explicit EdgeInChart(const HoleEdge& edge);

  /// x in [0, 1] along the way.
  Vec2 at(double x) const;
  /// By x.
  Vec2 direction(double x) const;
  /// Whether the face, so the way out of the hole, lies left of the way.
  bool away_is_left() const { return away_is_left_; }

 private:
  double parameter(double x) const;

  opencascade::handle<Geom2d_Curve> pcurve_;
  Interval range_{};
  bool backwards_ = false;
  bool away_is_left_ = false;
};

/// One place of an edge: value, first to third derivative away from the hole, along a straight line
/// of the parameters that starts square to the edge; and the normal of the face. Without a face
/// there is only the value.
struct SideSample {
  std::array<Vec3, 4> derivatives{};
  Vec3 normal{};
};

class SideSampler {
 public:
  /// reach    length of the first derivative, model units; without it as long as half that of the
  ///          edge, so that it is a polynomial beside one in a plane
  explicit SideSampler(const HoleEdge& edge, std::optional<double> reach = std::nullopt);
  ~SideSampler();

  /// order   of the derivatives that are wanted, 0 to 3
  SideSample at(double x, int order) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The larger distance of a half's ends: what derivatives across an edge are scaled by.
double half_chord(const HoleEdge& edge);

}  // namespace blossom::occt
