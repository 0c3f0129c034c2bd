// SPDX-License-Identifier: LGPL-2.1-or-later
// The least distance between two sets of points, curves and surfaces, between proven bounds.
//
// The least distance of two sets is taken at a pair of points, each of which is a point of the set,
// the inside of a curve where the connecting line is across it, or the inside of a surface where it
// is normal to it. So pairs of cells are left out when they are too far from each other, or when no
// connecting line can be normal to both; the rest is halved, nearest pairs first. Newton's method
// gives upper bounds. Ends of curves and borders of surfaces belong to the set as points and curves
// of their own; then trims need no other care than a filter.

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/status.h"
#include "core/forms/curve.h"
#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom {

/// Whether a rectangle of a surface's own parameters lies inside of its trims.
enum class TrimSide { Inside, Outside, Mixed };
/// surface   index into DistanceOperand::surfaces
/// low, high the corners of the rectangle; equal for a point, of which Mixed means on a border
using TrimFilter = std::function<TrimSide(int surface, const Vec2& low, const Vec2& high)>;

/// Points, curves and surfaces, taken together. Positive weights; curves of degree 1..kMaxDegree.
struct DistanceOperand {
  std::vector<Vec3> points;
  std::vector<RationalBezierCurve> curves;
  std::vector<BezierSurface> surfaces;
  TrimFilter trims{};  ///< empty: all of the surfaces counts
};

/// Points near whose convex hull all of a part lies.
struct HullBound {
  std::vector<Vec3> points;  ///< model units; at least one
  double margin = 0;         ///< how far outside of it a coordinate may be
  /// How far the border that trims leave may be from the curves of the set that stand for it.
  double border_gap = 0;
  std::vector<Vec3> border_points{};  ///< these curves are in their box; empty: not known
};

/// Curves on the surfaces of a part along the border that its trims leave.
struct BorderCurves {
  std::vector<RationalBezierCurve> curves;
  double gap = 0;  ///< how far the border may be from them, model units
};

/// A set of which only hulls are there at first: a part is made when a question comes near it.
struct OperandParts {
  std::vector<Vec3> points;                       ///< need no making
  std::vector<HullBound> hulls;                   ///< one for each part
  std::function<DistanceOperand(int part)> make;  ///< once at most for each, from any thread
  TrimFilter trims{};  ///< takes the part for the surface; a part has one surface at most
  /// Asked where a border gap matters, once at most for each part; empty, or returns nothing, where
  /// the border is not known any better.
  std::function<std::optional<BorderCurves>(int part)> borders{};
};

/// A surface with its borders and corners.
DistanceOperand measured(const BezierSurface& surface);
/// A curve with its ends.
DistanceOperand measured(const RationalBezierCurve& curve);
/// A point.
DistanceOperand measured(const Vec3& point);

/// Where a distance is taken.
struct DistanceEnd {
  enum class Kind { Point, Curve, Surface };
  Kind kind = Kind::Point;
  int index = 0;  ///< of the point, curve or surface
  Vec2 uv;        ///< the surface's own parameters; (t, 0) with t in [0, 1] of a curve
  Vec3 point;     ///< model units
  int part = -1;  ///< that the index counts in; -1: in the set itself
};

struct DistanceResult {
  double lower = 0;  ///< the distance is at least this, proven
  double upper = 0;  ///< and at most this, taken at `a` and `b`
  DistanceEnd a, b;

  /// Complete: the bounds agree to kDistanceAccuracy, kDistanceResolution or what was asked for.
  /// Stopped: the budget, the time or the limit of halving was spent before.
  Status status = Status::Complete;
  long pairs = 0;  ///< of cells looked at
};

/// Relative to the distance.
inline constexpr double kDistanceAccuracy = 1e-10;
/// Relative to the sum of the largest coordinates of both sets: distances that are equal to this
/// all over a surface, as from the middle of a ball, need not be told apart.
inline constexpr double kDistanceResolution = 1e-10;
/// The same for roundings, which is what counts where a limit is asked for. Bounds of a cell have
/// some 20 units of them for each halving, in both sets and all directions some 2^14 at the
/// deepest.
inline constexpr double kDistanceRounding = 0x1p-39;

/// How far a set goes in a direction.
struct FarthestResult {
  double lower = 0;  ///< so far at least; reached by a point of the set, or known before
  double upper = 0;  ///< and no farther, proven

  /// Complete: the bounds agree to kDistanceRounding or what was asked for. Stopped: as above.
  Status status = Status::Complete;
  long cells = 0;  ///< looked at
};

struct DistanceOptions {
  /// Pairs of cells looked at before giving up.
  long budget = 400'000;
  /// Seconds before giving up; 0 means no limit.
  double time_limit = 0;
  /// Asked now and then; true gives up.
  std::function<bool()> cancelled{};
  /// Stops as soon as the distance is proven to be above this, or found to be below; model units.
  /// Then only the side is told: lower > enough, or upper <= enough.
  double enough = -1;
  /// Bounds that agree to this need not be made closer; model units.
  double resolution = 0;
};

class DistanceParts;

/// A set made ready for many questions. Any number of threads may ask it.
class PreparedSet {
 public:
  /// throws   InvalidInput if the set is empty or a form is not sound
  explicit PreparedSet(DistanceOperand set);
  explicit PreparedSet(OperandParts parts);
  ~PreparedSet();
  PreparedSet(PreparedSet&&) noexcept;
  PreparedSet& operator=(PreparedSet&&) noexcept;

  /// What is there from the beginning: everything, or the points of a set in parts.
  const DistanceOperand& set() const;
  /// What a part is made of; made if it is not yet. Only of a set in parts.
  const DistanceOperand& part(int number) const;

 private:
  friend DistanceResult least_distance(const PreparedSet& a, const PreparedSet& b,
                                       const DistanceOptions& options);
  friend FarthestResult farthest_along(const PreparedSet& set, int axis, bool backwards,
                                       double known, const DistanceOptions& options);
  friend bool proven_to_cross(const PreparedSet& a, int part_a, const PreparedSet& b, int part_b,
                              const Vec3& point, double within, double room);
  std::unique_ptr<DistanceParts> parts_;
};

/// The least distance of two sets.
DistanceResult least_distance(const PreparedSet& a, const PreparedSet& b,
                              const DistanceOptions& options = {});
/// throws   as PreparedSet
DistanceResult least_distance(const DistanceOperand& a, const DistanceOperand& b,
                              const DistanceOptions& options = {});

/// How far a set goes along an axis, or backwards: then the largest of -x, -y or -z. The curves of
/// the set count as the borders of its surfaces. Where they are farther off than what need not be
/// told apart, `OperandParts::borders` are looked at; without these some corners of cells are asked
/// for, and the upper bound allows for the gap.
///
/// known     what goes no farther than this is not looked at; minus infinity: everything is
/// options   `enough` does not count
FarthestResult farthest_along(const PreparedSet& set, int axis, bool backwards, double known,
                              const DistanceOptions& options = {});

/// Whether the surfaces of two parts of sets are proven to cross within their trims. Looked for
/// along their intersection, from a point that both come near to.
///
/// within    how near, model units
/// room      how far both surfaces go on within their trims round the crossing, model units
/// returns   false if no proof was found; always so of approximated surfaces
bool proven_to_cross(const PreparedSet& a, int part_a, const PreparedSet& b, int part_b,
                     const Vec3& point, double within, double room = 0);

}  // namespace blossom
