// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/clipping/shallow_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/forms/spline.h"
#include "core/plane/planar_curves.h"
#include "core/topology/chart_projector.h"

namespace blossom {
namespace {

constexpr int kSteps = 16;          // Newton's method takes about five
constexpr double kSettled = 1e-12;  // of a step, relative to the parameters of a wire or a curve

// A wire of one face and the surface of the other, near a place where they cross.
struct Crossing {
  const FaceTrims* trimmed = nullptr;
  const Coedge* coedge = nullptr;
  double parameter = 0;  // of the wire
  double off = 0;        // how far the place is from the wire
  const FaceTrims* other = nullptr;
  Vec2 uv;  // of the other surface
};

struct WireJet {
  Vec3 point, along;  // per parameter of the edge
};

WireJet wire_at(const Crossing& of, double parameter) {
  const PlanarJet chart = jet_at(of.coedge->curve, parameter);
  const Vec2 scale = of.trimmed->scale;
  const SurfaceJet jet = of.trimmed->jet({chart.point[0] / scale[0], chart.point[1] / scale[1]});
  return {jet.point, chart.first[0] / scale[0] * jet.du + chart.first[1] / scale[1] * jet.dv};
}

// The place of the wire on the other surface.
std::optional<Vec3> settled(const Crossing& of) {
  const Interval domain = of.coedge->curve.domain();
  double parameter = of.parameter;
  Vec2 uv = of.uv;
  for (int step = 0; step < kSteps; ++step) {
    const WireJet wire = wire_at(of, parameter);
    const SurfaceJet surface = of.other->jet(uv);
    const Vec3 normal = cross(surface.du, surface.dv);
    const double rate = dot(wire.along, normal);
    if (rate == 0) return {};
    const double by = dot(surface.point - wire.point, normal) / rate;
    parameter += by;
    if (!(domain.from <= parameter && parameter <= domain.to)) return {};
    const Vec3 next = wire_at(of, parameter).point;
    if (std::abs(by) * norm(wire.along) <= kOnWire) return next;
    uv += chart_step(surface, next - surface.point);
  }
  return {};
}

// The nearest wire within `reach` of a place on a face; whole periods do not matter.
std::optional<Crossing> wire_near(const FaceTrims& trims, const Vec2& uv, double reach) {
  const Vec2 point{uv[0] * trims.scale[0], uv[1] * trims.scale[1]};
  std::optional<Crossing> found;
  for (const double u : {0.0, trims.period[0], -trims.period[0]})
    for (const double v : {0.0, trims.period[1], -trims.period[1]})
      for (const auto& loop : trims.loops)
        for (const Coedge& coedge : loop) {
          const PlanarFoot foot = nearest(coedge.curve, point + Vec2{u, v});
          if (foot.distance > reach + coedge.tolerance || (found && foot.distance >= found->off))
            continue;
          found = Crossing{&trims, &coedge, foot.parameter, foot.distance, nullptr, {}};
        }
  return found;
}

// Nothing where wires of both faces meet, or at a pole.
std::optional<Crossing> crossing_at(const FaceTrims& a, const FaceTrims& b, const Vec2& uv_a,
                                    const Vec2& uv_b, double reach) {
  const auto on_a = wire_near(a, uv_a, reach), on_b = wire_near(b, uv_b, reach);
  if (on_a.has_value() == on_b.has_value()) return {};
  Crossing of = on_a ? *on_a : *on_b;
  if (of.coedge->degenerated) return {};
  of.other = on_a ? &b : &a;
  of.uv = on_a ? uv_b : uv_a;
  return of;
}

// How far along the wire a curve ends that is off by `deviation`, at most; without end if they are
// parallel.
double displacement(const IntersectionCurve& curve, double t, const Crossing& of,
                    double deviation) {
  const Vec3 along = derivative_at(curve.curve, t), wire = wire_at(of, of.parameter).along;
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
  const double off = std::max({of->off, deviation.a, deviation.b, deviation.between});
  if (displacement(curve, t, *of, off) <= kOnWire) return t;
  const auto point = settled(*of);
  return point ? parameter_at(curve.curve, t, *point, edge_tolerance(deviation)).value_or(t) : t;
}

}  // namespace

void move_shallow_ends(const IntersectionCurve& curve, const FaceTrims& a, const FaceTrims* b,
                       double reach, std::vector<Interval>& parts) {
  if (b == nullptr) return;
  const Interval domain = curve.curve.domain();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Interval& part = parts[i];
    if (part.from == part.to) continue;
    const Interval room{i > 0 ? parts[i - 1].to : domain.from,
                        i + 1 < parts.size() ? parts[i + 1].from : domain.to};
    const auto moved = [&](double end) {
      return end == domain.from || end == domain.to ? end : settled_end(curve, end, a, *b, reach);
    };
    const Interval next{moved(part.from), moved(part.to)};
    if (room.from <= next.from && next.from < next.to && next.to <= room.to) part = next;
  }
}

}  // namespace blossom
