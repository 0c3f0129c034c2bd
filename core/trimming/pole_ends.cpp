// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/trimming/pole_ends.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr int kSamples = 8;          // of a span
constexpr double kLeastPole = 0.25;  // of a pole's length in the chart: as much of it is left

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Where a border and one that is a point meet.
struct PoleEnd {
  int border = 0;
  int pole = 0;
  bool at_first = false;  // of the border's parameters
  bool at_start = false;  // of the pole's walk
  int direction = 0;      // of the parameter that varies along the pole
};

class Straightener {
 public:
  Straightener(const BezierSurface& surface, TrimmedChart chart, double within)
      : surface_(surface), chart_(std::move(chart)), within_(within) {}

  TrimmedChart straightened() {
    for (std::size_t corner = 0; corner < chart_.corners.size(); ++corner)
      if (const auto end = end_at(static_cast<int>(corner))) straighten(*end);
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
    for (int k = 0; k <= kSamples; ++k) {
      const Vec2 uv = jet_at(span.curve, static_cast<double>(k) / kSamples).point;
      Vec2 moved = uv;
      moved[direction] = value;
      if (distance(in_space(uv), in_space(moved)) > within_) return false;
    }
    return true;
  }

  // As many spans from the end as may have the value with which the last of them begins.
  void straighten(const PoleEnd& end) {
    std::vector<PlanarSpan>& spans = chart_.borders[index(end.border)].curve.spans;
    const int count = static_cast<int>(spans.size());
    const auto span = [&](int k) -> PlanarSpan& {
      return spans[index(end.at_first ? k : count - 1 - k)];
    };
    int straight = 0;
    double value = 0;
    for (int many = 1; many <= count; ++many) {
      const PlanarBezier& far = span(many - 1).curve;
      const double wanted =
          projected(end.at_first ? far.points.back() : far.points.front())[end.direction];
      int k = 0;
      while (k < many && may_keep(span(k), end.direction, wanted)) ++k;
      if (k < many) break;
      straight = many;
      value = wanted;
    }
    if (straight == 0 || !take_pole_to(end, value)) return;
    for (int k = 0; k < straight; ++k)
      for (Vec3& p : span(k).curve.points) p[end.direction] = value * p[2];
  }

  double nearest_end(int direction, double parameter) const {
    const std::vector<double>& knots = direction == 0 ? surface_.u_knots : surface_.v_knots;
    const bool first = parameter - knots.front() < knots.back() - parameter;
    return first ? knots.front() : knots.back();
  }

  // Whether the pole is not turned about, or shortened much, when it ends at the value.
  bool take_pole_to(const PoleEnd& end, double value) {
    RegionBorder& pole = chart_.borders[index(end.pole)];
    Vec2& corner = chart_.corners[index(corner_of(end))];
    const Vec2& other = chart_.corners[index(end.at_start ? pole.to : pole.from)];
    const double before = corner[end.direction] - other[end.direction];
    const double after = value - other[end.direction];
    if (pole.from == pole.to || !(after / before >= kLeastPole)) return false;
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
