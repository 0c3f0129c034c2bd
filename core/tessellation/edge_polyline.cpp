// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/edge_polyline.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/forms/evaluation.h"
#include "core/math/segment.h"

namespace blossom {
namespace {

constexpr double kAimedPart = 0.85;  // of the deviation: the rest is for what bounds leave open
constexpr double kFinePart = 0.04;   // of the distance of chords, for the finer polyline
constexpr double kShortest = 1e-3;   // of the deviation: segments, but where an edge is no longer
constexpr int kDeepest = 14;         // halvings of a span
constexpr double kKink = 0.02;       // radians between spans: a corner, which gets a point
constexpr double kRounding = 1e-6;   // of a segment or the deviation: nothing more for that
constexpr int kMinClosed = 3;
constexpr double kMaxSides = 1e6;  // of an edge; a choice, a face between such edges fills memory

struct Piece {
  RationalBezierCurve curve;
  Interval part;
  int depth = 0;
};

double thickness_of(const RationalBezierCurve& curve) {
  const Vec3 a = projected(curve.points.front()), b = projected(curve.points.back());
  double most = 0;
  for (std::size_t i = 1; i + 1 < curve.points.size(); ++i)
    most = std::max(most, segment_gap(projected(curve.points[i]), a, b));
  return most;
}

// The halves, the second one in the place of the piece.
Piece low_half(Piece& piece) {
  Piece low = piece;
  std::vector<Vec4>& high = piece.curve.points;
  const std::size_t n = high.size() - 1;
  for (std::size_t level = 1; level <= n; ++level) {
    for (std::size_t i = 0; i <= n - level; ++i) high[i] = 0.5 * (high[i] + high[i + 1]);
    low.curve.points[level] = high[0];
  }
  low.part.to = piece.part.from = at(piece.part, 0.5);
  low.depth = ++piece.depth;
  return low;
}

}  // namespace

EdgePolyline::EdgePolyline(const CurveSpans& curve, bool closed, const FacetOptions& options)
    : curve_(curve), options_(options) {
  make(closed, kFinePart * options_.deviation);
  // Chords that the angle or the length ask for may be far nearer than the deviation. At twice the
  // thickness they are proven within 1.16 times their distance, which is near enough.
  const double chords = distance_ - 2 * thickness_ - curve_.error;
  const double fine = std::max(kFinePart * chords, kRounding * options_.deviation);
  if (thickness_ > 2 * fine) make(closed, fine);
}

void EdgePolyline::make(bool closed, double fine) {
  for (std::vector<double>* values : {&fine_parameters_, &sigma_, &parameters_}) values->clear();
  fine_points_.clear();
  points_.clear();
  kinks_.clear();
  thickness_ = 0;
  for (std::size_t k = 0; k < curve_.spans.size(); ++k) flatten(curve_.spans[k], k == 0, fine);
  kinks_.push_back(fine_points_.size() - 1);
  spread(closed);
  prove();
}

void EdgePolyline::flatten(const CurveSpan& span, bool first, double fine) {
  if (first) {
    fine_parameters_.push_back(span.place.from);
    fine_points_.push_back(projected(span.curve.points.front()));
    sigma_.push_back(0);
    kinks_.push_back(0);
  }
  std::vector<Piece> open{{span.curve, {0, 1}, 0}};
  while (!open.empty()) {
    const double thick = thickness_of(open.back().curve);
    if (thick > fine && open.back().depth < kDeepest) {
      Piece low = low_half(open.back());
      open.push_back(std::move(low));
      continue;
    }
    thickness_ = std::max(thickness_, thick);
    const Interval part = open.back().part;
    const CurveJet jet = jet_at(span.curve, at(part, 0.5));
    const Vec3 end = projected(open.back().curve.points.back());
    const double speed = norm(jet.first), chord = norm(end - fine_points_.back());
    const double k = speed > 0 ? norm(cross(jet.first, jet.second)) / (speed * speed * speed) : 0;
    const double ds = chord * (1 + k * k * chord * chord / 24);  // of the arc over it
    double density = std::sqrt(k / (8 * kAimedPart * options_.deviation));
    if (options_.angle > 0) density = std::max(density, k / options_.angle);
    if (options_.edge_length > 0) density = std::max(density, 1 / options_.edge_length);
    density = std::min(density, 1 / (kShortest * options_.deviation));
    sigma_.push_back(sigma_.back() + density * ds);
    fine_parameters_.push_back(parameter_at(span.law, span.place, part.to));
    fine_points_.push_back(end);
    open.pop_back();
  }
}

// Between two points of the finer polyline; the last of its points is left to what follows.
void EdgePolyline::breaks_between(std::size_t from, std::size_t to, int least) {
  const double all = sigma_[to] - sigma_[from];
  const int count = std::max(least, static_cast<int>(std::ceil(all - kRounding)));
  std::size_t i = from;
  for (int k = 0; k < count; ++k) {
    double t = fine_parameters_[from];
    if (k > 0 && all > 0) {
      const double wanted = sigma_[from] + all * k / count;
      while (sigma_[i + 1] < wanted && i + 1 < to) ++i;
      const double step = sigma_[i + 1] - sigma_[i];
      const double share = step > 0 ? std::clamp((wanted - sigma_[i]) / step, 0.0, 1.0) : 0.5;
      t = at({fine_parameters_[i], fine_parameters_[i + 1]}, share);
    } else if (k > 0) {
      t = at({fine_parameters_[from], fine_parameters_[to]}, static_cast<double>(k) / count);
    }
    if (parameters_.empty() || t > parameters_.back()) parameters_.push_back(t);
  }
}

// Where an edge turns within less than the shortest segment it is a curl, as rounding makes them at
// the ends of curves, and no corner.
void EdgePolyline::drop_close_kinks() {
  std::vector<double> length{0};  // up to each point
  for (std::size_t k = 1; k < fine_points_.size(); ++k)
    length.push_back(length.back() + norm(fine_points_[k] - fine_points_[k - 1]));
  const double least = kShortest * options_.deviation;
  std::vector<std::size_t> kept{kinks_.front()};
  for (const std::size_t k : kinks_)
    if (length[k] - length[kept.back()] >= least && length.back() - length[k] >= least)
      kept.push_back(k);
  kept.push_back(kinks_.back());
  kinks_ = std::move(kept);
}

void EdgePolyline::spread(bool closed) {
  for (std::size_t k = 0; k + 1 < curve_.spans.size(); ++k) {
    const Vec3 before = jet_at(curve_.spans[k].curve, 1).first;
    const Vec3 after = jet_at(curve_.spans[k + 1].curve, 0).first;
    if (norm(cross(unit(before), unit(after))) <= kKink && dot(before, after) >= 0) continue;
    const double at_knot = curve_.spans[k].place.to;
    const auto found = std::ranges::lower_bound(fine_parameters_, at_knot);
    kinks_.push_back(static_cast<std::size_t>(found - fine_parameters_.begin()));
  }
  if (!(sigma_.back() <= kMaxSides))
    throw InvalidInput(
        std::string("the deviation, the angle or the length of sides is too small: ") +
        "an edge would have " + std::to_string(std::llround(std::min(sigma_.back(), 1e18))) +
        " sides, and at most 1000000 are made");
  std::ranges::sort(kinks_);
  drop_close_kinks();
  const std::size_t parts = kinks_.size() - 1;
  const int least =
      closed ? (kMinClosed + static_cast<int>(parts) - 1) / static_cast<int>(parts) : 1;
  for (std::size_t k = 0; k < parts; ++k)
    if (kinks_[k] < kinks_[k + 1]) breaks_between(kinks_[k], kinks_[k + 1], least);
  parameters_.push_back(fine_parameters_.back());
  for (const double t : parameters_) points_.push_back(point_at(curve_, t));
}

// Of the finer polyline between them; the ends themselves are within its thickness.
double EdgePolyline::distance_of(double from, const Vec3& a, double to, const Vec3& b) const {
  double most = 0;
  auto i = static_cast<std::size_t>(std::ranges::upper_bound(fine_parameters_, from) -
                                    fine_parameters_.begin());
  for (; i < fine_parameters_.size() && fine_parameters_[i] < to; ++i)
    most = std::max(most, segment_gap(fine_points_[i], a, b));
  return most + 2 * thickness_ + curve_.error;
}

void EdgePolyline::prove() {
  const double limit = std::max(options_.deviation, 4 * thickness_ + 2 * curve_.error);
  for (int depth = 0; depth < kDeepest; ++depth) {
    std::vector<std::size_t> refused;
    distance_ = 0;
    for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
      const double gap =
          distance_of(parameters_[k], points_[k], parameters_[k + 1], points_[k + 1]);
      distance_ = std::max(distance_, gap);
      if (gap > limit) refused.push_back(k);
    }
    if (refused.empty()) return;
    halve(refused);
  }
}

// A chord over a half may be farther from its arc than that over the whole, where the curve swings
// to both sides.
void EdgePolyline::split(const std::vector<std::size_t>& segments) {
  halve(segments);
  prove();
}

void EdgePolyline::halve(const std::vector<std::size_t>& segments) {
  std::vector<double> parameters;
  std::vector<Vec3> points;
  auto next = segments.begin();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    parameters.push_back(parameters_[k]);
    points.push_back(points_[k]);
    if (next == segments.end() || *next != k || k + 1 == points_.size()) continue;
    ++next;
    const double middle = at({parameters_[k], parameters_[k + 1]}, 0.5);
    parameters.push_back(middle);
    points.push_back(point_at(curve_, middle));
  }
  parameters_ = std::move(parameters);
  points_ = std::move(points);
}

}  // namespace blossom
