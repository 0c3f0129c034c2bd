// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/picture/view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace blossom::cli {
namespace {

constexpr double kMargin = 0.05;      // of the frame, on each side
constexpr double kLineShare = 0.6;    // what lines count beside the covered area
constexpr double kTinyExtent = 1e-9;  // keeps the scale finite for a scene that is one point

View direction(double azimuth_degrees, double elevation_degrees) {
  const double a = azimuth_degrees * std::numbers::pi / 180;
  const double e = elevation_degrees * std::numbers::pi / 180;
  View view;
  view.right = {-std::sin(a), std::cos(a), 0};
  view.forward = {-std::cos(a) * std::cos(e), -std::sin(a) * std::cos(e), -std::sin(e)};
  view.up = cross(view.right, view.forward);
  return view;
}

// Scale and place of the frame's middle over the middle of the points.
void fit(View& view, const std::vector<Vec3>& points, int width, int height) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double low[2] = {kFar, kFar}, high[2] = {-kFar, -kFar};
  for (const Vec3& point : points) {
    const double at[2] = {dot(point, view.right), dot(point, view.up)};
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  const double room = 1 - 2 * kMargin;
  view.scale = std::min(room * width / std::max(high[0] - low[0], kTinyExtent),
                        room * height / std::max(high[1] - low[1], kTinyExtent));
  view.x = width / 2.0 - view.scale * (low[0] + high[0]) / 2;
  view.y = height / 2.0 + view.scale * (low[1] + high[1]) / 2;
}

// Share of the frame that the triangles cover, overlaps counted once at most.
double covered(const View& view, const std::vector<Vec3>& corners, double frame) {
  double area = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    area += std::abs(dot(cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]),
                         view.forward)) /
            2;
  return std::min(1.0, area * view.scale * view.scale / frame);
}

// Seen length of the lines over their true length.
double seen(const View& view, const std::vector<std::vector<Vec3>>& lines) {
  double length = 0, flat = 0;
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec3 step = line[i] - line[i - 1];
      length += norm(step);
      flat += std::hypot(dot(step, view.right), dot(step, view.up));
    }
  return length > 0 ? flat / length : 0;
}

}  // namespace

View chosen_view(const std::vector<Vec3>& corners, const std::vector<std::vector<Vec3>>& lines,
                 int width, int height) {
  std::vector<Vec3> points = corners;
  for (const auto& line : lines) points.insert(points.end(), line.begin(), line.end());

  View best;
  double best_score = -1;
  for (const double elevation : {20.0, 30.0, 45.0})
    for (int azimuth = -165; azimuth < 180; azimuth += 15) {
      if (azimuth % 90 == 0) continue;  // along an axis, things hide each other
      View view = direction(azimuth, elevation);
      fit(view, points, width, height);
      const double score =
          covered(view, corners, double(width) * height) + kLineShare * seen(view, lines);
      if (score > best_score + 1e-9) {  // the first of equals, whatever the rounding
        best_score = score;
        best = view;
      }
    }
  return best;
}

}  // namespace blossom::cli
