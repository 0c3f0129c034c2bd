// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/with_surfaces/curve_surface_assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/unbounded.h"
#include "core/curves/contact_length.h"
#include "core/curves/overlap_place.h"
#include "core/math/functions/bisection.h"

namespace blossom {
namespace {

constexpr int kSamples = 33;          // of the gap along a run: a choice
constexpr int kThirds = 60;           // of a run, that are taken off: 3e-11 of it is left
constexpr int kHalvings = 60;         // of a run, beyond the roundings of its parameters
constexpr double kTangential = 1e-6;  // sine below which a contact counts as tangential
constexpr double kBorder = 1e-9;     // of a patch; places this near its border may be a neighbour's
constexpr double kCloser = 1. / 16;  // the tolerances of closer looks fall by this
constexpr double kMinCloser = 32;    // times the rounding: below, a closer look tells no more
constexpr double kAtEnd = 1e-6;      // of a run
constexpr double kSafeGap = 0.9;     // of the gap found, which is proven to be there

// Of two runs that meet.
CurveSurfaceOverlap joined(const CurveSurfaceOverlap& a, const CurveSurfaceOverlap& b) {
  const CurveSurfaceOverlap &first = a.t.from <= b.t.from ? a : b, &last = a.t.to >= b.t.to ? a : b;
  return {{first.t.from, last.t.to},
          first.uv_from,
          last.uv_to,
          std::max(a.gap_high, b.gap_high),
          a.proven && b.proven};
}

}  // namespace

CurveSurfaceAssembly::CurveSurfaceAssembly(const CurveTree& curve, const BezierSurface& surface,
                                           const SurfaceTrees& trees, double tolerance)
    : curve_(curve),
      surface_(surface),
      trees_(trees),
      tolerance_(tolerance),
      margin_(2 * (curve.evaluation_margin() + trees.evaluation_margin())),
      touch_length_(curve_touch_length(tolerance, curve.size())) {}

CurveSurfaceAssembly::Candidate CurveSurfaceAssembly::candidate(const SpanPoint& t, int patch,
                                                                const Vec2& uv) const {
  Candidate result;
  result.t = t;
  result.parameter = curve_.parameter(t);
  result.box = {result.parameter, result.parameter};
  result.patch = patch;
  result.uv = uv;
  result.on_curve = curve_.jet(t);
  result.on_surface = jet_at(trees_[patch].patch(), uv[0], uv[1], 1);
  const Vec3 normal = unit(cross(result.on_surface.u, result.on_surface.v));
  const Vec3 gap = result.on_curve.point - result.on_surface.point;
  result.gap = {std::max(0.0, norm(gap) - margin_), norm(gap) + margin_};
  result.signed_gap = dot(normal, gap) < 0 ? -norm(gap) : norm(gap);
  result.sine = std::abs(dot(normal, unit(result.on_curve.first)));
  return result;
}

// The pair of cells had a regular Jacobian, so the solution is the only one in them. It exists if
// all that rounding may move it lies on curve and surface: by Markov's inequality the derivatives
// change by next to nothing over that distance, even beyond the cells.
void CurveSurfaceAssembly::prove(Candidate& point, const Vec3& reach) const {
  const double low = point.t.t - reach[0], high = point.t.t + reach[0];
  point.box = {curve_.parameter({point.t.span, std::max(0.0, low)}),
               curve_.parameter({point.t.span, std::min(1.0, high)})};
  bool interior = low > 0 && high < 1;
  for (int k = 0; k < 2; ++k)
    interior = interior && point.uv[k] - reach[k + 1] > 0 && point.uv[k] + reach[k + 1] < 1;
  point.proven = interior || passes_joins(point, reach);
}

// Where spans or patches join, all directions of the curve pass all normals the same way.
bool CurveSurfaceAssembly::passes_joins(const Candidate& point, const Vec3& reach) const {
  std::vector<Vec3> directions{point.on_curve.first};
  std::vector<Vec3> normals{cross(point.on_surface.u, point.on_surface.v)};
  SpanPoint end = point.t;
  if (end.t - reach[0] <= 0) end.t = 0;
  if (end.t + reach[0] >= 1) end.t = 1;
  if (end.t == 0 || end.t == 1) {
    if (curve_.is_free_end(end)) return false;
    directions.push_back(curve_.jet(curve_.across_join(end)).first);
  }
  for (int axis = 0; axis < 2; ++axis)
    for (const bool high : {false, true}) {
      const double at_border = high ? 1 - point.uv[axis] : point.uv[axis];
      if (at_border > reach[axis + 1]) continue;
      if (is_free_border(point.patch, axis, high)) return false;
      Vec2 uv = point.uv;
      uv[axis] = high ? 0 : 1;
      const PatchJet jet =
          jet_at(trees_[neighbour(point.patch, axis, high)].patch(), uv[0], uv[1], 1);
      normals.push_back(cross(jet.u, jet.v));
    }
  const double side = dot(directions[0], normals[0]);
  for (const Vec3& d : directions)
    for (const Vec3& n : normals)
      if (!(dot(d, n) * side > 0)) return false;
  return true;
}

bool CurveSurfaceAssembly::is_free_border(int patch, int axis, bool high) const {
  const int i = patch / surface_.patches.columns(), j = patch % surface_.patches.columns();
  const int place = axis == 0 ? i : j;
  const int last = (axis == 0 ? surface_.patches.rows() : surface_.patches.columns()) - 1;
  return place == (high ? last : 0) && !(axis == 0 ? surface_.closed_u : surface_.closed_v);
}

int CurveSurfaceAssembly::neighbour(int patch, int axis, bool high) const {
  const int rows = surface_.patches.rows(), columns = surface_.patches.columns();
  int i = patch / columns, j = patch % columns;
  const int step = high ? 1 : -1;
  if (axis == 0)
    i = (i + step + rows) % rows;
  else
    j = (j + step + columns) % columns;
  return i * columns + j;
}

// One place of the curve, and one sheet of the surface: near on one patch, or on a border.
bool CurveSurfaceAssembly::same(const Candidate& p, const Candidate& q) const {
  if (!curve_.stays_near(p.parameter, q.parameter, tolerance_)) return false;
  const auto on_border = [](const Candidate& x) {
    for (int k = 0; k < 2; ++k)
      if (x.uv[k] <= kBorder || x.uv[k] >= 1 - kBorder) return true;
    return false;
  };
  if (p.patch != q.patch || on_border(p) || on_border(q)) return true;
  const Vec2 middle = (p.uv + q.uv) * 0.5;
  const Vec3 between = jet_at(trees_[p.patch].patch(), middle[0], middle[1], 1).point;
  return distance(between, p.on_surface.point) <= 4 * tolerance_;
}

void CurveSurfaceAssembly::add(const Candidate& point) {
  if (on_overlap(point)) return;
  for (Candidate& known : points_) {
    if (!same(known, point)) continue;
    if (point.proven && !known.proven) known = point;
    return;
  }
  points_.push_back(point);
}

void CurveSurfaceAssembly::add_points(const std::vector<FoundCurveSurfacePoint>& points) {
  for (const FoundCurveSurfacePoint& known : points) {
    Candidate point = candidate(known.t, known.patch, known.uv);
    if (known.exact) prove(point, known.reach);
    add(point);
  }
}

// Least gaps of valleys, which neighbouring pairs may tell of both.
void CurveSurfaceAssembly::add_touches(const std::vector<CurveSurfaceTouch>& touches) {
  for (const CurveSurfaceTouch& found : touches) {
    Candidate touch = candidate(found.t, found.patch, found.uv);
    if (on_overlap(touch)) continue;
    touch.touch = true;
    touch.half_length = found.half_length;
    touch.gap.low = found.gap_low;
    touch.box = {curve_.parameter({found.t.span, found.run.from}),
                 curve_.parameter({found.t.span, found.run.to})};
    const auto known = std::find_if(points_.begin(), points_.end(), [&](const Candidate& other) {
      return other.touch || found.at_end ? in_one_run(other, touch) : same(other, touch);
    });
    if (known == points_.end())
      points_.push_back(touch);
    else if (known->touch && touch.gap.high < known->gap.high)
      *known = touch;
  }
}

// True for touches on one sheet of the surface if their runs meet, and for points in such a run.
bool CurveSurfaceAssembly::in_one_run(const Candidate& p, const Candidate& q) const {
  const bool meet = p.box.from <= q.box.to && q.box.from <= p.box.to;
  return (meet && p.patch == q.patch &&
          distance(p.on_surface.point, q.on_surface.point) <= p.half_length + q.half_length) ||
         same(p, q);
}

void CurveSurfaceAssembly::add_inside(const std::vector<CurveInSurface>& inside) {
  for (const CurveInSurface& piece : inside) {
    const Interval t{curve_.parameter({piece.piece.span, piece.piece.t.from}),
                     curve_.parameter({piece.piece.span, piece.piece.t.to})};
    const Vec2 from = trees_.parameters(piece.piece.patch, piece.uv_from);
    const Vec2 to = trees_.parameters(piece.piece.patch, piece.uv_to);
    if (!overlaps_.empty() && overlaps_.back().t.to == t.from) {
      CurveSurfaceOverlap& last = overlaps_.back();
      last.t.to = t.to;
      last.uv_to = to;
      last.gap_high = std::max(last.gap_high, piece.gap);
    } else {
      overlaps_.push_back({t, from, to, piece.gap, true});
    }
  }
}

bool CurveSurfaceAssembly::on_overlap(const Candidate& point) const {
  return std::any_of(overlaps_.begin(), overlaps_.end(), [&](const CurveSurfaceOverlap& run) {
    const bool inside = point.parameter >= run.t.from && point.parameter <= run.t.to;
    return (inside && !point.proven) ||
           curve_.stays_near(point.parameter, run.t.from, tolerance_) ||
           curve_.stays_near(point.parameter, run.t.to, tolerance_);
  });
}

// Pieces of the curve that follow each other are one contact: where two sheets of the surface are
// within tolerance of one point, they are within tolerance of each other.
void CurveSurfaceAssembly::add_contacts(const std::vector<CurveSurfaceContact>& contacts) {
  const auto range = [&](const CurveSurfaceContact& c) {
    return Interval{curve_.parameter({c.span, c.t.from}), curve_.parameter({c.span, c.t.to})};
  };
  std::vector<CurveSurfaceContact> sorted = contacts;
  std::sort(sorted.begin(), sorted.end(),
            [&](const CurveSurfaceContact& x, const CurveSurfaceContact& y) {
              return range(x).from < range(y).from;
            });
  for (std::size_t i = 0; i < sorted.size();) {
    Interval run = range(sorted[i]);
    std::size_t k = i + 1;
    for (; k < sorted.size() && range(sorted[k]).from <= run.to; ++k)
      run.to = std::max(run.to, range(sorted[k]).to);
    add_run(run, {sorted.begin() + static_cast<std::ptrdiff_t>(i),
                  sorted.begin() + static_cast<std::ptrdiff_t>(k)});
    i = k;
  }
}

CurveSurfaceAssembly::Candidate CurveSurfaceAssembly::nearest(
    double parameter, const std::vector<CurveSurfaceContact>& pieces) const {
  const SpanPoint t = curve_.place(parameter);
  const Vec3 point = curve_.jet(t).point;
  SurfaceFoot best{0, {}, kInfinity};
  for (const CurveSurfaceContact& piece : pieces) {
    if (piece.span != t.span || t.t < piece.t.from || t.t > piece.t.to) continue;
    const Vec2 start{at(piece.u, 0.5), at(piece.v, 0.5)};
    const SurfaceFoot foot = foot_on(trees_, piece.patch, start, point);
    if (foot.distance < best.distance) best = foot;
  }
  if (std::isinf(best.distance)) best.patch = pieces.front().patch;
  return candidate(t, best.patch, best.uv);
}

void CurveSurfaceAssembly::add_run(const Interval& run,
                                   const std::vector<CurveSurfaceContact>& pieces) {
  std::array<double, kSamples> gaps{};
  double run_length = 0;
  Candidate first, last;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const Candidate sample = nearest(at(run, static_cast<double>(i) / (kSamples - 1)), pieces);
    gaps[i] = norm(sample.on_curve.point - sample.on_surface.point);
    if (i > 0) run_length += distance(last.on_curve.point, sample.on_curve.point);
    if (i == 0) first = sample;
    last = sample;
  }
  const CurveSurfaceOverlap made{run, trees_.parameters(first.patch, first.uv),
                                 trees_.parameters(last.patch, last.uv),
                                 *std::max_element(gaps.begin(), gaps.end()) + margin_, false};
  const bool is_run = run_length > touch_length_ && is_common_run(gaps, tolerance_, margin_);
  const auto meets = [&](const CurveSurfaceOverlap& known) {
    return known.t.from <= run.to && run.from <= known.t.to;
  };
  const bool is_short = run_length <= touch_length_;
  if (!is_run && !(is_short && std::ranges::any_of(overlaps_, meets)))
    return add_touch(run, pieces, run_length);
  // What is short tells nothing of the runs beside it, as they are said to be.
  std::optional<CurveSurfaceOverlap> whole;
  for (const CurveSurfaceOverlap& known : overlaps_)
    if (meets(known)) whole = whole ? joined(*whole, known) : known;
  std::erase_if(overlaps_, meets);
  if (!whole) return overlaps_.push_back(made);
  CurveSurfaceOverlap all = joined(*whole, made);
  if (is_short) {
    all.gap_high = whole->gap_high;
    all.proven = whole->proven;
  }
  overlaps_.push_back(all);
}

double CurveSurfaceAssembly::root_between(double from, double to,
                                          const std::vector<CurveSurfaceContact>& pieces) const {
  const bool rising = nearest(from, pieces).signed_gap < 0;
  const Interval end = bisected({from, to}, kHalvings, [&](double t) {
    return (nearest(t, pieces).signed_gap < 0) == rising;
  });
  return 0.5 * (end.from + end.to);
}

// What a closer look tells of a contact.
CurveSurfaceAssembly::CloserLook CurveSurfaceAssembly::look_closer(
    const std::vector<CurveSurfaceContact>& pieces) {
  for (double closer = kCloser * tolerance_; closer > kMinCloser * margin_; closer *= kCloser) {
    const CurveSurfaceFindings found = closer_(pieces, closer);
    if (found.stopped) return CloserLook::Undecided;
    if (!found.contacts.empty()) continue;
    add_points(found.points);
    add_touches(found.touches);
    return found.points.empty() && found.touches.empty() ? CloserLook::Empty : CloserLook::Points;
  }
  return CloserLook::Undecided;
}

// A contact as a point; with proven points in it, as a place in which there may be more.
void CurveSurfaceAssembly::add_touch(const Interval& run,
                                     const std::vector<CurveSurfaceContact>& pieces,
                                     double run_length) {
  const CloserLook look = look_closer(pieces);
  if (look == CloserLook::Points) return;
  Candidate whole = nearest(at(run, 0.5), pieces);
  whole.touch = true;
  whole.half_length = 0.5 * run_length;
  whole.box = run;
  bool proven = false;
  for (const Candidate& known : points_) {
    if (known.box.to < run.from || known.box.from > run.to) continue;
    const bool all = curve_.stays_near(known.parameter, run.from, tolerance_) &&
                     curve_.stays_near(known.parameter, run.to, tolerance_);
    if (!known.proven || all) return;
    proven = true;
  }
  if (look == CloserLook::Empty || !proven) return add_least(run, whole, pieces, look);
  whole.gap = {0, tolerance_};
  places_.push_back(place_of(whole));
}

void CurveSurfaceAssembly::add_contact(double parameter, bool crosses, const Candidate& run,
                                       const std::vector<CurveSurfaceContact>& pieces) {
  Candidate point = nearest(parameter, pieces);
  if (point.gap.low > tolerance_ || on_overlap(point)) return;
  const auto is_known = [&](const Candidate& known) { return known.proven && same(known, point); };
  if (crosses && std::any_of(points_.begin(), points_.end(), is_known)) return;
  point.touch = true;
  point.crosses = crosses;
  point.half_length = run.half_length;
  point.box = run.box;
  if (crosses) {
    point.gap = {0, tolerance_};
  } else {
    // A search with a smaller tolerance that finds nothing proves the gap; others may be 0.
    const double gap = kSafeGap * point.gap.low;
    bool proven = gap > kMinCloser * margin_;
    if (proven) {
      const CurveSurfaceFindings found = closer_(pieces, gap);
      proven =
          !found.stopped && found.contacts.empty() && found.points.empty() && found.touches.empty();
    }
    point.gap.low = proven ? gap : 0;
  }
  points_.push_back(point);
}

void CurveSurfaceAssembly::add_least(const Interval& run, const Candidate& whole,
                                     const std::vector<CurveSurfaceContact>& pieces,
                                     CloserLook look) {
  const double at_from = nearest(run.from, pieces).signed_gap;
  const double at_to = nearest(run.to, pieces).signed_gap;
  if (at_from * at_to < 0)
    return add_contact(root_between(run.from, run.to, pieces), true, whole, pieces);
  const double side = at_from + at_to < 0 ? -1 : 1;
  const auto gap = [&](double parameter) { return side * nearest(parameter, pieces).signed_gap; };
  double low = run.from, high = run.to;
  for (int k = 0; k < kThirds; ++k) {
    const double third = (high - low) / 3;
    (gap(low + third) < gap(high - third) ? high -= third : low += third);
  }
  const double middle = 0.5 * (low + high);
  // Without a common point, and nearer beyond the run: the slope beside a point that is known.
  const auto falls_beyond = [&](double end) {
    return std::abs(middle - end) < kAtEnd * length(run) && !curve_.is_free_end(curve_.place(end));
  };
  if (look == CloserLook::Empty && (falls_beyond(run.from) || falls_beyond(run.to))) return;
  if (gap(middle) >= -margin_ || std::min(gap(run.from), gap(run.to)) < 0)
    return add_contact(middle, false, whole, pieces);
  const double first = root_between(run.from, middle, pieces);
  const double second = root_between(middle, run.to, pieces);
  if (curve_.stays_near(first, second, 0.5 * tolerance_))
    return add_contact(middle, false, whole, pieces);
  add_contact(first, true, whole, pieces);
  add_contact(second, true, whole, pieces);
}

CurvePlace CurveSurfaceAssembly::place_of(const Candidate& point) const {
  CurvePlace place{point.crosses ? PlaceKind::Tangential : PlaceKind::Touch,
                   point.on_curve.point,
                   point.on_curve.point,
                   point.gap.low,
                   point.gap.high,
                   point.box,
                   {0, 0}};
  const Vec3 along = unit(point.on_curve.first) * point.half_length;
  for (int k = 0; k < 3; ++k) {
    const double reach = std::abs(along[k]) + point.gap.high;
    place.box_low[k] -= reach;
    place.box_high[k] += reach;
  }
  return place;
}

void CurveSurfaceAssembly::write(CurveSurfaceIntersection& result) const {
  double least = kInfinity;
  for (const Candidate& point : points_) {
    result.points.push_back(
        {point.on_curve.point, point.parameter, trees_.parameters(point.patch, point.uv),
         point.touch && point.sine < std::max(kTangential, std::sqrt(tolerance_)), point.proven,
         point.box});
    if (point.proven) {
      least = std::min(least, std::asin(std::min(1.0, point.sine)));
      continue;
    }
    result.places.push_back(place_of(point));
  }
  if (std::isfinite(least)) result.certificate.least_angle = least;
  std::sort(result.points.begin(), result.points.end(),
            [](const CurveSurfacePoint& x, const CurveSurfacePoint& y) { return x.t < y.t; });
  result.places.insert(result.places.end(), places_.begin(), places_.end());
  result.overlaps = overlaps_;
  for (const CurveSurfaceOverlap& run : overlaps_)
    result.places.push_back(overlap_place(curve_, run.t, run.gap_high));
}

CurveSurfaceIntersection CurveSurfaceAssembly::finish(const std::vector<CurveInSurface>& inside,
                                                      const CurveSurfaceFindings& found,
                                                      CloserSearch closer) {
  closer_ = std::move(closer);
  add_inside(inside);
  add_points(found.points);
  add_touches(found.touches);
  add_contacts(found.contacts);
  CurveSurfaceIntersection result;
  write(result);
  return result;
}

}  // namespace blossom
