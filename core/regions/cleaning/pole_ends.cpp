// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/cleaning/pole_ends.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/forms/evaluation.h"
#include "core/math/index.h"

namespace blossom {
namespace {

constexpr int kPoleSamples = 8;    // of a span
constexpr double kMinPole = 0.25;  // of a pole's length in the chart: as much of it is left
// Of the surface's range of a parameter: no harm comes of corners that are swept over less of it.
constexpr double kMinSweep = 1e-2;

// Where a border and one that is a point meet.
struct PoleEnd {
  int border = 0;
  int pole = 0;
  bool at_first = false;  // of the border's parameters
  bool at_start = false;  // of the pole's walk
  int direction = 0;      // of the parameter that varies along the pole
};

// The last spans of a border that may keep one value of a parameter, and that value.
struct StraightEnd {
  int spans = 0;
  double value = 0;
};

// Two borders that meet at a corner, none of them a point.
struct Meeting {
  int arriving = 0;
  int leaving = 0;
};

class Straightener {
 public:
  Straightener(const BezierSurface& surface, TrimmedChart chart, double within)
      : surface_(surface), chart_(std::move(chart)), within_(within) {}

  TrimmedChart straightened() {
    const int corners = static_cast<int>(chart_.corners.size());
    for (int corner = 0; corner < corners; ++corner)
      if (const auto end = end_at(corner)) straighten(*end);
    for (int corner = 0; corner < corners; ++corner)
      if (const auto meeting = meeting_at(corner))
        for (int direction = 0; direction < 2; ++direction)
          if (spread(corner, *meeting, direction)) break;
    return std::move(chart_);
  }

 private:
  int corner_of(const PoleEnd& end) const {
    const RegionBorder& pole = chart_.borders[index(end.pole)];
    return end.at_start ? pole.from : pole.to;
  }

  // None unless just one border and one that is a point end at the corner.
  std::optional<PoleEnd> end_at(int corner) const {
    int ends = 0;
    PoleEnd end{-1, -1};
    for (std::size_t b = 0; b < chart_.borders.size(); ++b) {
      const RegionBorder& border = chart_.borders[b];
      if (border.from != corner && border.to != corner) continue;
      ends += (border.from == corner) + (border.to == corner);
      if (border.is_point) {
        end.pole = static_cast<int>(b);
        end.at_start = border.from == corner;
      } else {
        end.border = static_cast<int>(b);
        end.at_first = (border.from == corner) != border.reversed;
      }
    }
    if (ends != 2 || end.border < 0 || end.pole < 0) return std::nullopt;
    const RegionBorder& pole = chart_.borders[index(end.pole)];
    const Vec2 way = chart_.corners[index(pole.to)] - chart_.corners[index(pole.from)];
    end.direction = std::abs(way[0]) >= std::abs(way[1]) ? 0 : 1;
    return end;
  }

  Vec3 in_space(const Vec2& uv) const { return point_at(surface_, uv); }

  // Whether a span may have one value of the direction.
  bool may_keep(const PlanarSpan& span, int direction, double value) const {
    for (int k = 0; k <= kPoleSamples; ++k) {
      const Vec2 uv = jet_at(span.curve, static_cast<double>(k) / kPoleSamples).point;
      Vec2 moved = uv;
      moved[direction] = value;
      if (distance(in_space(uv), in_space(moved)) > within_) return false;
    }
    return true;
  }

  static PlanarSpan& span_from_end(RegionBorder& border, bool at_first, int k) {
    std::vector<PlanarSpan>& spans = border.curve.spans;
    return at_first ? spans[index(k)] : spans[spans.size() - 1 - index(k)];
  }

  // As many spans from the end as may have the value with which the last of them begins.
  StraightEnd straight_end(int number, bool at_first, int direction) {
    RegionBorder& border = chart_.borders[index(number)];
    StraightEnd straight;
    for (int many = 1; many <= static_cast<int>(border.curve.spans.size()); ++many) {
      const PlanarBezier& far = span_from_end(border, at_first, many - 1).curve;
      const double wanted = projected(at_first ? far.points.back() : far.points.front())[direction];
      for (int k = 0; k < many; ++k)
        if (!may_keep(span_from_end(border, at_first, k), direction, wanted)) return straight;
      straight = {many, wanted};
    }
    return straight;
  }

  void make_straight(int number, bool at_first, int direction, const StraightEnd& end) {
    for (int k = 0; k < end.spans; ++k)
      for (Vec3& p : span_from_end(chart_.borders[index(number)], at_first, k).curve.points)
        p[direction] = end.value * p[2];
  }

  void straighten(const PoleEnd& end) {
    const StraightEnd straight = straight_end(end.border, end.at_first, end.direction);
    if (straight.spans > 0 && take_pole_to(end, straight.value))
      make_straight(end.border, end.at_first, end.direction, straight);
  }

  const std::vector<double>& knots(int direction) const {
    return direction == 0 ? surface_.u_knots : surface_.v_knots;
  }

  double nearest_end(int direction, double parameter) const {
    const Interval range{knots(direction).front(), knots(direction).back()};
    return parameter - range.from < range.to - parameter ? range.from : range.to;
  }

  // Whether the pole is not turned about, or shortened much, when it ends at the value.
  bool take_pole_to(const PoleEnd& end, double value) {
    RegionBorder& pole = chart_.borders[index(end.pole)];
    Vec2& corner = chart_.corners[index(corner_of(end))];
    const Vec2& other = chart_.corners[index(end.at_start ? pole.to : pole.from)];
    const double before = corner[end.direction] - other[end.direction];
    const double after = value - other[end.direction];
    if (pole.from == pole.to || !(after / before >= kMinPole)) return false;
    corner[end.direction] = value;
    const int along = 1 - end.direction;
    const double last = nearest_end(along, corner[along]);
    Vec2 settled = corner;
    settled[along] = last;
    if (distance(in_space(corner), in_space(settled)) <= within_) corner = settled;
    Vec2 from = chart_.corners[index(pole.from)], to = chart_.corners[index(pole.to)];
    if (pole.reversed) std::swap(from, to);
    pole.curve = planar_line(from, to, pole.curve.domain());
    return true;
  }

  // ---- corners at poles without a border

  // None unless just two borders end at the corner, neither is a point, and both go elsewhere.
  std::optional<Meeting> meeting_at(int corner) const {
    Meeting meeting{-1, -1};
    int ends = 0;
    for (std::size_t b = 0; b < chart_.borders.size(); ++b) {
      const RegionBorder& border = chart_.borders[b];
      if (border.to == corner) meeting.arriving = static_cast<int>(b);
      if (border.from == corner) meeting.leaving = static_cast<int>(b);
      ends += (border.from == corner) + (border.to == corner);
      if (border.is_point && (border.from == corner || border.to == corner)) return std::nullopt;
    }
    if (ends != 2 || meeting.arriving < 0 || meeting.leaving < 0) return std::nullopt;
    if (stays_at(corner, meeting.arriving) || stays_at(corner, meeting.leaving))
      return std::nullopt;
    return meeting;
  }

  // Whether a border ends as near to a corner as it starts there.
  bool stays_at(int corner, int number) const {
    const RegionBorder& border = chart_.borders[index(number)];
    const Vec2& other = chart_.corners[index(border.from == corner ? border.to : border.from)];
    return distance(in_space(other), in_space(chart_.corners[index(corner)])) <= within_;
  }

  // Whether the line of the surface on which a point is, along a direction, is that point in space.
  bool is_on_pole(Vec2 uv, int direction, const Vec3& point) const {
    const Interval range{knots(direction).front(), knots(direction).back()};
    for (int k = 0; k <= kPoleSamples; ++k) {
      uv[direction] = at(range, static_cast<double>(k) / kPoleSamples);
      if (distance(in_space(uv), point) > within_) return false;
    }
    return true;
  }

  // The ways that both borders make beside a pole become one along it, if the region is on its
  // left.
  bool spread(int corner, const Meeting& meeting, int direction) {
    const Vec2 given = chart_.corners[index(corner)];
    const int along = 1 - direction;
    Vec2 from = given;
    from[along] = nearest_end(along, given[along]);
    if (!is_on_pole(from, direction, in_space(given))) return false;
    const bool to_first = chart_.borders[index(meeting.arriving)].reversed;
    const bool from_first = !chart_.borders[index(meeting.leaving)].reversed;
    const StraightEnd arriving = straight_end(meeting.arriving, to_first, direction);
    const StraightEnd leaving = straight_end(meeting.leaving, from_first, direction);
    Vec2 to = from;
    if (arriving.spans > 0) from[direction] = arriving.value;
    if (leaving.spans > 0) to[direction] = leaving.value;
    const bool runs_up = (from[along] == knots(along).front()) == (along == 1);
    const double way = (to[direction] - from[direction]) * (runs_up ? 1 : -1);
    if (!(way > kMinSweep * (knots(direction).back() - knots(direction).front()))) return false;
    make_straight(meeting.arriving, to_first, direction, arriving);
    make_straight(meeting.leaving, from_first, direction, leaving);
    add_pole(corner, meeting, from, to);
    return true;
  }

  void add_pole(int corner, const Meeting& meeting, const Vec2& from, const Vec2& to) {
    const int second = static_cast<int>(chart_.corners.size());
    chart_.corners[index(corner)] = from;
    chart_.corners.push_back(to);
    chart_.borders[index(meeting.leaving)].from = second;
    RegionBorder pole{planar_line(from, to, {0, 1}), false, corner, second, {}};
    pole.is_point = true;
    chart_.borders.push_back(std::move(pole));
  }

  const BezierSurface& surface_;
  TrimmedChart chart_;
  double within_;
};

}  // namespace

TrimmedChart with_straight_pole_ends(const BezierSurface& surface, TrimmedChart chart,
                                     double within) {
  return Straightener(surface, std::move(chart), within).straightened();
}

}  // namespace blossom
