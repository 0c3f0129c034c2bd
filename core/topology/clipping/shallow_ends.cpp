// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/clipping/shallow_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/forms/spline.h"
#include "core/plane/planar_curves.h"
#include "core/topology/chart_projector.h"

namespace blossom {
namespace {

constexpr int kSteps = 16;  // Newton's method takes about five
// Of a step along a curve, relative to its parameters: about as near as it can be told.
constexpr double kSettled = 1e-12;
// Relative to coordinates: a height over a surface is known so well. 16 roundings, a choice.
constexpr double kHeightNoise = 0x1p-49;
// How much farther off a place may be than the angle at the end says, as both curves bend.
constexpr double kBending = 2;

// A wire of one face and the surface of the other, near a place where they cross.
struct Crossing {
  const FaceTrims* trimmed = nullptr;
  WirePlace wire;
  const FaceTrims* other = nullptr;
  Vec2 uv;  // of the other surface
};

struct WireJet {
  Vec3 point, along;  // per parameter of the edge
};

WireJet wire_at(const Crossing& of, double parameter) {
  const PlanarJet chart = jet_at(of.wire.coedge->curve, parameter);
  const Vec2 scale = of.trimmed->scale;
  const SurfaceJet jet = of.trimmed->jet({chart.point[0] / scale[0], chart.point[1] / scale[1]});
  return {jet.point, chart.first[0] / scale[0] * jet.du + chart.first[1] / scale[1] * jet.dv};
}

// A wire of one edge goes on from its end at its start.
std::optional<double> in_domain(const Coedge& coedge, double parameter) {
  const Interval domain = coedge.curve.domain();
  if (coedge.from == coedge.to && parameter < domain.from) parameter += length(domain);
  if (coedge.from == coedge.to && parameter > domain.to) parameter -= length(domain);
  if (!(domain.from <= parameter && parameter <= domain.to)) return {};
  return parameter;
}

// The parameter that a step of Newton's method leads to; nothing where the wire runs along the
// surface, so that roundings of its height lead farther than kOnWire.
std::optional<double> next_parameter(const WireJet& wire, const SurfaceJet& surface,
                                     double parameter) {
  const Vec3 normal = cross(surface.du, surface.dv), &p = wire.point;
  const double rate = dot(wire.along, normal), size = norm(wire.along) * norm(normal);
  const double noise =
      kHeightNoise * std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) / kOnWire;
  if (!(std::abs(rate) > noise * size)) return {};
  return parameter + dot(surface.point - p, normal) / rate;
}

// The place of the wire on the other surface.
std::optional<Vec3> settled(const Crossing& of) {
  double parameter = of.wire.parameter;
  Vec2 uv = of.uv;
  for (int step = 0; step < kSteps; ++step) {
    const WireJet wire = wire_at(of, parameter);
    const SurfaceJet surface = of.other->jet(uv);
    const auto next = next_parameter(wire, surface, parameter);
    if (!next) return {};
    const double by = std::abs(*next - parameter);
    const auto inside = in_domain(*of.wire.coedge, *next);
    if (!inside) return {};
    parameter = *inside;
    const Vec3 point = wire_at(of, parameter).point;
    if (by * norm(wire.along) <= kOnWire) return point;
    uv += chart_step(surface, point - surface.point);
  }
  return {};
}

// Nothing where wires of both faces meet, or at a pole.
std::optional<Crossing> crossing_at(const FaceTrims& a, const FaceTrims& b, const Vec2& uv_a,
                                    const Vec2& uv_b, double reach) {
  const auto on_a = wire_near(a, uv_a, reach), on_b = wire_near(b, uv_b, reach);
  if (on_a.has_value() == on_b.has_value()) return {};
  const Crossing of = on_a ? Crossing{&a, *on_a, &b, uv_b} : Crossing{&b, *on_b, &a, uv_a};
  if (of.wire.coedge->degenerated) return {};
  return of;
}

// How far along the wire a curve ends that is off by `deviation`; without end if they are parallel.
double displacement(const IntersectionCurve& curve, double t, const Crossing& of,
                    double deviation) {
  const Vec3 along = derivative_at(curve.curve, t), wire = wire_at(of, of.wire.parameter).along;
  return deviation * norm(along) * norm(wire) / norm(cross(along, wire));
}

// The parameter of a curve at its nearest place to a point, from one near it; nothing where the
// curve keeps farther off than `reach`.
std::optional<double> parameter_at(const Spline& curve, double t, const Vec3& point, double reach) {
  const Interval domain = curve.domain();
  for (int step = 0; step < kSteps; ++step) {
    const Vec3 along = derivative_at(curve, t);
    const double by = dot(point - point_at(curve, t), along) / dot(along, along);
    t = std::clamp(t + by, domain.from, domain.to);
    if (std::abs(by) <= kSettled * length(domain)) break;
  }
  if (!(distance(point, point_at(curve, t)) <= reach)) return {};
  return t;
}

// Where a curve that ends on a wire at t ends by wire and surface; t itself if that is known well,
// or is not to be told better.
double settled_end(const IntersectionCurve& curve, double t, const FaceTrims& a, const FaceTrims& b,
                   double reach) {
  const auto of = crossing_at(a, b, point_at(curve.chart_a, t), point_at(curve.chart_b, t), reach);
  if (!of) return t;
  const Deviation& deviation = curve.deviation;
  const double most = displacement(
      curve, t, *of, std::max({of->wire.distance, deviation.a, deviation.b, deviation.between}));
  if (most <= kOnWire) return t;
  const auto point = settled(*of);
  if (!point || !(distance(*point, point_at(curve.curve, t)) <= kBending * most)) return t;
  return parameter_at(curve.curve, t, *point, edge_tolerance(deviation)).value_or(t);
}

// What the other parts of a curve leave of it.
Interval room_of(const Interval& part, const std::vector<Interval>& parts, Interval room) {
  for (const Interval& other : parts) {
    if (other.to <= part.from) room.from = std::max(room.from, other.to);
    if (other.from >= part.to) room.to = std::min(room.to, other.from);
  }
  return room;
}

}  // namespace

void move_shallow_ends(const IntersectionCurve& curve, const FaceTrims& a, const FaceTrims* b,
                       double reach, std::vector<Interval>& parts) {
  if (b == nullptr) return;
  const Interval domain = curve.curve.domain();
  for (Interval& part : parts) {
    if (part.from == part.to) continue;
    const Interval room = room_of(part, parts, domain);
    const auto moved = [&](double end) {
      return end == domain.from || end == domain.to ? end : settled_end(curve, end, a, *b, reach);
    };
    if (const double from = moved(part.from); room.from < from && from < part.to) part.from = from;
    if (const double to = moved(part.to); part.from < to && to < room.to) part.to = to;
  }
}

}  // namespace blossom
