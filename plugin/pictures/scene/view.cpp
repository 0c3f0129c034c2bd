// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/scene/view.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "plugin/reports/text/vectors.h"
#include "plugin/reports/text/words.h"

namespace blossom::pictures {
namespace {

constexpr double kMargin = 0.04;      // of the frame, on each side
constexpr double kTinyExtent = 1e-9;  // keeps the scale finite for a scene that is one point
// Of what the best direction sees of the triangles: faces that iso sees less of are almost edge-on.
constexpr double kEdgeOn = 0.2;
constexpr double kAlongZ = 1e-6;  // sine of the angle to z below which y is upwards

const std::vector<std::pair<std::string, Vec3>>& named_directions() {
  static const std::vector<std::pair<std::string, Vec3>> all = {
      {"iso", {1, -1, 1}},  {"front", {0, -1, 0}}, {"back", {0, 1, 0}},   {"left", {-1, 0, 0}},
      {"right", {1, 0, 0}}, {"top", {0, 0, 1}},    {"bottom", {0, 0, -1}}};
  return all;
}

// Area of the triangles as seen from a direction, those behind others counted, too.
double seen_area(const std::vector<Vec3>& corners, const Vec3& direction) {
  double area = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    area += std::abs(
        dot(cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]), unit(direction)));
  return area / 2;
}

}  // namespace

const std::vector<std::string>& view_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all;
    for (const auto& [word, direction] : named_directions()) all.push_back(word);
    return all;
  }();
  return words;
}

Vec3 view_direction(const std::string& text) {
  for (const auto& [word, direction] : named_directions())
    if (word == text) return direction;
  const std::optional<std::vector<double>> numbers = reports::finite_numbers(text);
  if (!numbers || numbers->size() != 3)
    throw InvalidInput("view: " + reports::listed(view_words()) + ", or X,Y,Z is wanted, not '" +
                       text + "'");
  const Vec3 direction = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  if (max_norm(direction) == 0) throw InvalidInput("view: the zero vector has no direction");
  return direction * (1 / max_norm(direction));
}

Vec3 default_direction(const std::vector<Vec3>& corners) {
  const Vec3 iso = named_directions().front().second;
  const double from_iso = seen_area(corners, iso);
  Vec3 best = iso;
  double most = from_iso;
  for (const Vec3& other : {Vec3{-1, -1, 1}, Vec3{1, 1, 1}, Vec3{-1, 1, 1}, Vec3{0, 0, 1}}) {
    const double area = seen_area(corners, other);
    if (area <= most * (1 + 1e-9)) continue;  // the first of equals, whatever the rounding
    most = area;
    best = other;
  }
  return from_iso < kEdgeOn * most ? best : iso;
}

View view_from(const Vec3& to_eye, const std::vector<Vec3>& points, const Frame& frame) {
  View view;
  view.forward = -unit(to_eye);
  const Vec3 z = {0, 0, 1};
  const Vec3 sideways = cross(view.forward, z);
  view.right = norm(sideways) > kAlongZ ? unit(sideways) : Vec3{1, 0, 0};
  view.up = unit(cross(view.right, view.forward));

  Vec2 low = {kInfinity, kInfinity}, high = {-kInfinity, -kInfinity};
  for (const Vec3& point : points) {
    const Vec2 at = {dot(point, view.right), dot(point, view.up)};
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  if (points.empty()) low = high = {0, 0};
  const double room = 1 - 2 * kMargin;
  view.scale = std::min(room * frame.width / std::max(high[0] - low[0], kTinyExtent),
                        room * frame.height / std::max(high[1] - low[1], kTinyExtent));
  view.x = frame.left + frame.width / 2 - view.scale * (low[0] + high[0]) / 2;
  view.y = frame.top + frame.height / 2 + view.scale * (low[1] + high[1]) / 2;
  return view;
}

}  // namespace blossom::pictures
