// SPDX-License-Identifier: LGPL-2.1-or-later
// Answers about distances and how models lie to each other, and their JSON reports; see
// plugin/cli/schemas/query-1.md.

#pragma once

#include <functional>
#include <vector>

#include "adapters/occt/bodies.h"
#include "core/base/tolerances.h"
#include "plugin/reports/models/measured_input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// Model units; the lower one is proven.
struct DistanceBounds {
  double lower = 0, upper = 0;
};

/// What is left to the next step of a question: asked before each.
using DistanceLimits = std::function<DistanceOptions()>;

/// How two models lie to each other, and how far apart they are.
struct DistanceAnswer {
  double tolerance = Tolerances{}.point;
  DistanceBounds bounds{};      ///< 0 where they have points in common
  DistanceBounds boundaries{};  ///< of the faces, edges and vertices
  occt::ShapePoint a{}, b{};    ///< the nearest points of the boundaries
  occt::Meeting meeting = occt::Meeting::Unknown;
  occt::ModelRelation relation{};
  Status status = Status::Complete;
  double seconds = 0;
};

/// The least distance of two prepared inputs.
DistanceAnswer distance_between(MeasuredInput& a, MeasuredInput& b, double tolerance,
                                const DistanceLimits& limits);

/// Whether two prepared inputs have a point in common, as early as that is known.
DistanceAnswer meeting_of(MeasuredInput& a, MeasuredInput& b, double tolerance,
                          const DistanceLimits& limits);

/// "yes", "touching", "no" or "unknown".
const char* meeting_word(occt::Relation relation);

/// Schema "blossom.query/1", kinds "distance" and "does-intersect".
Json distance_report(const MeasuredInput& a, const MeasuredInput& b, const DistanceAnswer& answer);
Json meeting_report(const MeasuredInput& a, const MeasuredInput& b, const DistanceAnswer& answer);

/// What of a model is nearest to a point.
struct PointAnswer {
  double tolerance = Tolerances{}.point;
  Vec3 at;
  occt::ShapeDistance nearest{};
  std::vector<occt::PointPlace> places{};  ///< of the point to each body
  bool all = false;                        ///< feet were asked for
  std::vector<occt::ShapeFoot> feet{};
  Status status = Status::Complete;
  double seconds = 0;
};

/// all   all points where the distance is stationary, too
PointAnswer nearest_to(MeasuredInput& side, const Vec3& point, bool all, double tolerance,
                       const DistanceLimits& limits);

/// Schema "blossom.query/1", kind "point".
Json point_report(const MeasuredInput& side, const PointAnswer& answer);

}  // namespace blossom::reports
