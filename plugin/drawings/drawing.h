// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections as drawings: lines, circles, arcs and polygons in the coordinates of their planes.

#pragma once

#include <string>
#include <vector>

#include "adapters/occt/plane_section.h"
#include "core/base/unbounded.h"
#include "core/math/vec.h"

namespace blossom::drawings {

enum class StrokeKind { Line, Arc, Circle, Polyline };

/// A curve of a drawing, walked from its first point.
struct Stroke {
  StrokeKind kind = StrokeKind::Line;
  Vec2 from{}, to{};  ///< of all but circles
  Vec2 centre{};      ///< of arcs and circles
  double radius = 0;
  bool counter_clockwise = true;  ///< of arcs and circles
  double sweep = 0;               ///< of arcs: the angle that they go round, radians
  std::vector<Vec2> points{};     ///< of a polyline, its ends included
};

struct DrawnWire {
  std::vector<Stroke> strokes;
  bool closed = false;
  bool bounding = true;  ///< false: it lies inside, or the plane only touches there
};

struct DrawnPart {
  std::string name;
  bool solid = false;  ///< its closed bounding wires bound material
  std::vector<DrawnWire> wires{};
  std::vector<Vec2> points{};  ///< where it only touches the plane
};

struct DrawnPlane {
  std::string name;
  std::string layer;     ///< what the user calls it, else "plane 1" and so on
  double elevation = 0;  ///< along the normal, model units
  std::vector<DrawnPart> parts{};
};

/// Coordinates in a plane: up is z as far as the plane has it, else y; seen from the tip of the
/// normal x goes to the right. They begin at the plane's point next to the origin of the model, so
/// that parallel planes lie over each other, and those across z have the model's x and y.
struct DrawingFrame {
  explicit DrawingFrame(const occt::Plane& plane);
  Vec2 of(const Vec3& point) const { return {dot(point - origin, x), dot(point - origin, y)}; }

  Vec3 origin, x, y, normal;
};

/// deviation   of polylines from curves that are no line, circle or arc, model units
DrawnPart drawn(const occt::PlaneSection& section, const DrawingFrame& frame, double deviation);

/// The rectangle round all of it; low above high if there is nothing.
struct DrawingBox {
  Vec2 low{kUnbounded, kUnbounded}, high{-kUnbounded, -kUnbounded};
  bool is_empty() const { return low[0] > high[0]; }
  void add(const Vec2& point);
  void add(const DrawnPlane& plane);
  void add_arc(const Stroke& arc);
};

}  // namespace blossom::drawings
