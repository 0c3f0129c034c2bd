// SPDX-License-Identifier: LGPL-2.1-or-later
// An edge that two faces share, as each of them has it: the image of its curve in the face's chart.

#pragma once

#include <array>
#include <vector>

#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/topology/face_trims.h"
#include "core/topology/shared.h"

namespace blossom {

/// Where a face has an edge. Keeps references.
class EdgeOnFace {
 public:
  EdgeOnFace(const FaceTrims& trims, const Coedge& coedge) : trims_(trims), coedge_(coedge) {}

  Vec3 point(double t) const;
  Vec3 tangent(double t) const;

 private:
  const FaceTrims& trims_;
  const Coedge& coedge_;
};

/// A common edge where the first face has it: that is where paths lead along it.
class NeighbourEdge {
 public:
  /// a, b   the uses of the edge by the two faces; references are kept
  NeighbourEdge(const FaceTrims& trims_a, const FaceTrims& trims_b, const SharedEdge& shared,
                const Coedge& a, const Coedge& b);

  /// Of the pieces between samples that meet a range.
  std::vector<Vec3> directions(const Interval& range) const;

  /// The largest distance of the two faces' images at samples in pieces that meet a range, model
  /// units. The images are those of the chart curves themselves: what is fitted to them is off by
  /// up to the edge's tolerance.
  double gap(const Interval& range) const;
  double tolerance() const { return shared_.tolerance; }
  Vec3 point(double t) const { return image_.point(t); }

  /// Whether all points of a convex hull lie within a distance of the edge: the hull keeps near a
  /// chord of it, and the edge between the chord's ends keeps near the chord.
  ///
  /// foot     parameter of the edge near the hull
  /// hull     three planes of `count` coordinates, from `origin` on
  /// reach    model units
  bool is_near(double foot, const double* hull, int count, const Vec3& origin, double reach) const;

  const Coedge& on_a;
  const Coedge& on_b;

 private:
  const SharedEdge& shared_;
  EdgeOnFace image_;
  template <class Work>
  void for_pieces(const Interval& range, Work work) const;

  std::vector<double> gaps_;  // of the pieces between samples
  std::vector<std::array<Vec3, 3>> directions_;
};

}  // namespace blossom
