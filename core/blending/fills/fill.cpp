// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/errors.h"
#include "core/blending/fills/fill_data.h"
#include "core/blending/fills/fill_operator.h"

namespace blossom {
namespace {

/// Conditions that fail by no more, relative to the size of the hole, fail by rounding: sums of a
/// few hundred products of factors up to about 100.
constexpr double kRounding = 1e-11;

/// Two sides whose directions at a corner differ by less from one line, radians, give derivatives
/// across them that are a hundred times as large as theirs.
constexpr double kFlat = 0.01;

/// Degrees below which general data have no solution, by the rank of a layout's conditions.
int least_degree(FillLayout layout, FillGoal goal) {
  if (goal != FillGoal::First) return 7;
  return layout == FillLayout::Star ? 5 : 4;
}

/// Thrown inside of this file only.
struct Refusal {
  FillProblem problem;
  int place;
  std::string message;
};

template <class... Parts>
[[noreturn]] void refuse(FillProblem problem, std::size_t place, const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw Refusal{problem, static_cast<int>(place), text.str()};
}

bool is_finite(const Row& row) {
  return std::all_of(row.begin(), row.end(), [](const Vec4& p) {
    return std::all_of(p.coordinates.begin(), p.coordinates.end(),
                       [](double x) { return std::isfinite(x); });
  });
}

void validate(const std::vector<FillSide>& sides) {
  const auto wrong = [](std::size_t side, const std::string& what) {
    throw InvalidInput("fill: side " + std::to_string(side) + " " + what);
  };
  const auto n = static_cast<int>(sides.size());
  if (n < kMinFillSides || n > kMaxFillSides)
    throw InvalidInput("fill: " + std::to_string(kMinFillSides) + " to " +
                       std::to_string(kMaxFillSides) + " sides are wanted, got " +
                       std::to_string(n));
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const FillSide& side = sides[k];
    if (side.edge.size() < 2) wrong(k, "has no curve: at least 2 points are wanted");
    if (!is_finite(side.edge) || !is_finite(side.across) || !is_finite(side.bend))
      wrong(k, "is not finite");
    for (const Vec4& p : side.edge)
      if (!(p[3] > 0)) wrong(k, "has a weight that is not positive");
    if (side.across.empty() && !side.bend.empty()) wrong(k, "has second derivatives but no first");
    if (side.continuity != FillContinuity::G0 && side.across.empty())
      wrong(k, "asks for G1 or G2 but has no neighbour");
    if (side.continuity == FillContinuity::G2 && side.bend.empty())
      wrong(k, "asks for G2 but has no second derivatives");
    if (std::max({side.edge.size(), side.across.size(), side.bend.size()}) > kMaxFillDegree + 1)
      wrong(k, "has a degree above " + std::to_string(kMaxFillDegree));
  }
}

/// What is not asked for is not looked at.
std::vector<FillSide> wanted(std::vector<FillSide> sides) {
  for (FillSide& side : sides) {
    if (side.continuity == FillContinuity::G0) side.across.clear();
    if (side.continuity != FillContinuity::G2) side.bend.clear();
  }
  return sides;
}

/// Tangents of a side at its ends, of a prepared side: weights are 1 there.
struct EndTangents {
  Vec3 along;
  Vec3 across;  ///< zero without a neighbour
};

Vec3 space_vector(const Vec4& vector, const Vec4& value) {
  return {vector[0] - vector[3] * value[0], vector[1] - vector[3] * value[1],
          vector[2] - vector[3] * value[2]};
}

EndTangents tangents(const FillSide& side, int end) {
  const Row& edge = side.edge;
  const auto degree = static_cast<double>(edge.size() - 1);
  const std::size_t last = edge.size() - 1;
  EndTangents result;
  result.along = end == 0 ? degree * space_vector(edge[1], edge[0])
                          : -degree * space_vector(edge[last - 1], edge[last]);
  if (!side.across.empty())
    result.across = end == 0 ? space_vector(side.across.front(), edge.front())
                             : space_vector(side.across.back(), edge.back());
  return result;
}

/// The tangents at the corner that begins side k.
struct Corner {
  std::size_t k;
  EndTangents before, after;
};

void check_tangents(const FillSide& side, std::size_t k, double tolerance) {
  double extent = 0;
  for (const Vec4& p : side.edge)
    extent = std::max(extent, distance(projected(p), projected(side.edge.front())));
  if (extent <= tolerance) refuse(FillProblem::DegenerateSide, k, "side ", k, " has no length");
  for (const int end : {0, 1}) {
    const EndTangents at = tangents(side, end);
    if (norm(at.along) <= tolerance)
      refuse(FillProblem::DegenerateSide, k, "side ", k, " has no tangent at its ",
             end == 0 ? "start" : "end");
    if (side.across.empty()) continue;
    const double sine = norm(cross(unit(at.along), unit(at.across)));
    if (norm(at.across) <= tolerance || sine <= kFlat)
      refuse(FillProblem::DegenerateSide, k, "the neighbour of side ", k,
             " has no tangent plane at the side's ", end == 0 ? "start" : "end");
  }
}

void check_corner(const Corner& corner, bool smooth_before, bool smooth_after, double tolerance) {
  const auto& [k, before, after] = corner;
  const double turn = angle_between(before.along, after.along);
  if (std::sin(turn) <= kFlat)
    refuse(FillProblem::FlatCorner, k, "the sides at corner ", k,
           turn < 1 ? " run on in one direction" : " run back along each other", ": they turn by ",
           turn, " rad");
  double apart = 0;
  if (smooth_before && smooth_after) {
    const Vec3 a = cross(before.along, before.across), b = cross(after.along, after.across);
    apart = std::min(angle_between(a, b), angle_between(a, -b));
  } else if (smooth_before || smooth_after) {
    const EndTangents& plane = smooth_before ? before : after;
    const Vec3 normal = unit(cross(plane.along, plane.across));
    apart = std::asin(
        std::min(1.0, std::abs(dot(normal, unit((smooth_before ? after : before).along)))));
  }
  if (apart > tolerance)
    refuse(FillProblem::TangentPlanes, k, "the tangent planes at corner ", k, " differ by ", apart,
           " rad, more than ", tolerance);
  // Side `before` comes in, `after` leads out; each neighbour has to lie beyond the other side:
  // in the tangent plane, across = (other side's direction away from the hole) + part of its own.
  const auto outward = [](const EndTangents& of, const Vec3& away) {
    const Vec3 inner = of.across - (dot(of.across, of.along) / dot(of.along, of.along)) * of.along;
    return dot(inner, away) > 0;
  };
  if (smooth_after && !outward(after, before.along))
    refuse(FillProblem::ReflexCorner, k, "the neighbour of side ", k,
           " lies on the hole's side of it at corner ", k);
  if (smooth_before && !outward(before, -after.along))
    refuse(FillProblem::ReflexCorner, k, "the neighbour of the side before corner ", k,
           " lies on the hole's side of it there");
}

void check(const PreparedSides& all, const FillOptions& options) {
  const std::vector<FillSide>& sides = all.sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t before = (k + sides.size() - 1) % sides.size();
    const double gap = distance(projected(all.in_place[before].edge.back()),
                                projected(all.in_place[k].edge.front()));
    if (gap > options.tolerances.point)
      refuse(FillProblem::Gap, k, "the sides at corner ", k, " are ", gap, " apart, more than ",
             options.tolerances.point);
  }
  const double tolerance = options.tolerances.point / all.size;
  for (std::size_t k = 0; k < sides.size(); ++k) check_tangents(sides[k], k, tolerance);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const FillSide& before = sides[(k + sides.size() - 1) % sides.size()];
    check_corner({k, tangents(before, 1), tangents(sides[k], 0)}, !before.across.empty(),
                 !sides[k].across.empty(), options.angle);
  }
}

/// A solution in the unit of the prepared sides.
struct Solution {
  FillLayout layout = FillLayout::Star;
  FillGoal goal = FillGoal::First;
  std::shared_ptr<const FillOperator> made;
  std::vector<Vec4> points;
  double residual = 0;

  bool exact() const { return made && residual <= kRounding; }
};

Solution solved(FillLayout layout, FillGoal goal, const std::vector<SideFunctions>& functions) {
  Solution result{.layout = layout, .goal = goal, .made = nullptr, .points = {}, .residual = 0};
  int degree = least_degree(layout, goal);
  for (const SideFunctions& side : functions) degree = std::max(degree, side.degree());
  if (degree > kMaxFillDegree)
    refuse(FillProblem::Degree, 0, "the sides ask for patches of degree ", degree, ", at most ",
           kMaxFillDegree, " is possible");
  result.made = fill_operator(layout, static_cast<int>(functions.size()), degree, goal);
  const std::vector<Vec4> data = operator_data(functions, *result.made);
  result.points = result.made->control_points(data);
  result.residual = result.made->residual(result.points, data);
  return result;
}

bool allows(const FillOptions& options, FillLayout layout) {
  return !options.layout || *options.layout == layout;
}

Solution first_order(const std::vector<FillSide>& sides, const FillOptions& options) {
  if (allows(options, FillLayout::Star)) {
    const PolygonFunctions twists = polygon_functions(sides, CornerDemand::Twists);
    const bool agree = twists.mismatch <= kSameSeconds;
    Solution star;
    if (agree) star = solved(FillLayout::Star, FillGoal::First, twists.sides);
    if (star.exact()) return star;
    if (options.layout)
      refuse(FillProblem::Conditions, 0,
             "the star cannot meet these sides: their twists differ by ", twists.mismatch,
             " of their size at a corner, conditions fail by ", star.residual);
  }
  const FillLayout layout = options.layout.value_or(FillLayout::Ring);
  return solved(layout, FillGoal::First,
                polygon_functions(sides, CornerDemand::TangentPlanes).sides);
}

Solution second_order(const std::vector<FillSide>& sides, const FillOptions& options) {
  const PolygonFunctions jets = polygon_functions(sides, CornerDemand::SecondJets);
  if (jets.mismatch <= kSameSeconds)
    for (const FillLayout layout : {FillLayout::Star, FillLayout::DeepRing}) {
      if (!allows(options, layout)) continue;
      Solution made = solved(layout, FillGoal::Second, jets.sides);
      if (made.exact()) return made;
    }
  const FillLayout layout = options.layout.value_or(FillLayout::DeepRing);
  return solved(layout, FillGoal::FirstNearSecond,
                polygon_functions(sides, CornerDemand::None).sides);
}

void add_patches(Fill& result, const Solution& solution, const PreparedSides& sides) {
  const FillPoints& points = solution.made->points();
  const int d = points.degree, n = static_cast<int>(sides.sides.size());
  for (int sector = 0; sector < n; ++sector)
    for (int quad = 0; quad < points.quads; ++quad) {
      RationalBezierPatch patch{Grid<Vec4>(d + 1, d + 1)};
      for (int i = 0; i <= d; ++i)
        for (int j = 0; j <= d; ++j) {
          const FillPoint& at = points.at(quad, i, j);
          Vec4 p = solution.points[static_cast<std::size_t>(
              (sector + at.sector + n) % n * points.count + at.number)];
          if (!result.rational) p[3] = 1;
          result.least_weight = std::min(result.least_weight, p[3]);
          for (int x = 0; x < 3; ++x) p[x] = p[x] * sides.size + sides.origin[x] * p[3];
          patch.points(i, j) = p;
        }
      result.patches.push_back(std::move(patch));
    }
}

/// What the figures say of the continuity.
FillContinuity reached(const Fill& fill, const FillOptions& options) {
  FillContact worst = fill.figures.inside;
  for (const FillContact& side : fill.figures.sides) {
    worst.normal_angle = std::max(worst.normal_angle, side.normal_angle);
    worst.curvature_difference = std::max(worst.curvature_difference, side.curvature_difference);
  }
  if (worst.normal_angle > options.angle) return FillContinuity::G0;
  return worst.curvature_difference > options.curvature * fill.figures.largest_curvature
             ? FillContinuity::G1
             : FillContinuity::G2;
}

Fill filled(const std::vector<FillSide>& given, const FillOptions& options) {
  const PreparedSides sides = prepared(wanted(given));
  check(sides, options);
  const bool second = std::any_of(given.begin(), given.end(), [](const FillSide& side) {
    return side.continuity == FillContinuity::G2;
  });
  const Solution solution =
      second ? second_order(sides.sides, options) : first_order(sides.sides, options);
  Fill result;
  result.layout = solution.layout;
  result.degree = solution.made->points().degree;
  result.residual = solution.residual;
  result.rational = is_rational(sides.sides);
  add_patches(result, solution, sides);
  if (!(result.least_weight > 0))
    refuse(FillProblem::Weights, 0, "the fill has a weight of ", result.least_weight,
           ": its sides' weights vary too much");
  result.figures = fill_figures(result.patches, sides.in_place, solution.made->layout());
  result.reached = reached(result, options);
  if (!second) result.reached = std::min(result.reached, FillContinuity::G1);
  if (!solution.exact() || result.reached == FillContinuity::G0) {
    double angle = result.figures.inside.normal_angle;
    for (const FillContact& side : result.figures.sides) angle = std::max(angle, side.normal_angle);
    refuse(FillProblem::Conditions, 0, "the ", to_string(result.layout),
           " cannot meet these sides: conditions fail by ", result.residual, ", normals by ", angle,
           " rad");
  }
  return result;
}

}  // namespace

const char* to_string(FillProblem problem) {
  switch (problem) {
    case FillProblem::None: return "none";
    case FillProblem::Gap: return "gap";
    case FillProblem::DegenerateSide: return "degenerate-side";
    case FillProblem::FlatCorner: return "flat-corner";
    case FillProblem::ReflexCorner: return "reflex-corner";
    case FillProblem::TangentPlanes: return "tangent-planes";
    case FillProblem::Degree: return "degree";
    case FillProblem::Weights: return "weights";
    case FillProblem::Conditions: break;
  }
  return "conditions";
}

Fill fill(const std::vector<FillSide>& sides, const FillOptions& options) {
  validate(sides);
  try {
    return filled(sides, options);
  } catch (const Refusal& refusal) {
    Fill result;
    result.problem = refusal.problem;
    result.place = refusal.place;
    result.message = refusal.message;
    return result;
  }
}

}  // namespace blossom
