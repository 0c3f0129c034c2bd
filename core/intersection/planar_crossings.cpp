// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/planar_crossings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/errors.h"

namespace blossom {
namespace {

// Local parameters this little outside a piece still belong to it; its neighbour finds the same
// root, and roots that are the same are merged.
constexpr double kSlack = 1e-9;
constexpr int kNewtonSteps = 20;
// A contact shorter than this many times sqrt(tolerance * size) is a touch of curved pieces.
constexpr double kTouchLength = 10;

struct Piece {
  const PlanarSpan* span = nullptr;
  Interval local;  ///< of the span
  PlanarBezier curve;
  PlanarBox box;
  Vec2 chord;            ///< from the first to the last point
  double half_cone = 0;  ///< largest angle of a leg of the control polygon to the chord, radians
};

// Source for rational pieces: their tangents, too, are positive combinations of the legs
// (Floater 1992).
double half_cone(const PlanarBezier& curve, const Vec2& chord) {
  double widest = 0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const Vec2 leg = projected(curve.points[i + 1]) - projected(curve.points[i]);
    if (leg == Vec2{}) continue;
    widest = std::max(widest, std::abs(std::atan2(cross(chord, leg), dot(chord, leg))));
  }
  return widest;
}

Piece make_piece(const PlanarSpan& span, const Interval& local, PlanarBezier curve) {
  Piece piece{&span, local, std::move(curve), {}, {}, 0};
  piece.box = box_of(piece.curve.points);
  piece.chord = projected(piece.curve.points.back()) - projected(piece.curve.points.front());
  piece.half_cone = half_cone(piece.curve, piece.chord);
  return piece;
}

double size(const Piece& piece) { return max_norm(piece.box.high - piece.box.low); }

std::pair<Piece, Piece> halves(const Piece& piece) {
  const double middle = at(piece.local, 0.5);
  return {make_piece(*piece.span, {piece.local.from, middle}, bezier_piece(piece.curve, {0, 0.5})),
          make_piece(*piece.span, {middle, piece.local.to}, bezier_piece(piece.curve, {0.5, 1}))};
}

bool apart(const PlanarBox& a, const PlanarBox& b, double tolerance) {
  for (int k = 0; k < 2; ++k)
    if (a.low[k] > b.high[k] + tolerance || b.low[k] > a.high[k] + tolerance) return true;
  return false;
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Range range_along(const PlanarBezier& curve, const Vec2& origin, const Vec2& direction) {
  Range range;
  for (const Vec3& point : curve.points) {
    const double value = dot(projected(point) - origin, direction);
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

// The width of `curve` across the chord of `fat`, and whether a line parallel to the chord
// separates the two.
struct FatLine {
  bool separates = false;
  double width = 0;
};

FatLine fat_line(const Piece& fat, const PlanarBezier& curve, double tolerance) {
  if (fat.chord == Vec2{}) return {false, std::numeric_limits<double>::infinity()};
  const Vec2 normal = unit(Vec2{-fat.chord[1], fat.chord[0]});
  const Vec2 origin = projected(fat.curve.points.front());
  const Range own = range_along(fat.curve, origin, normal);
  const Range other = range_along(curve, origin, normal);
  return {other.low > own.high + tolerance || other.high < own.low - tolerance,
          std::max(own.high, other.high) - std::min(own.low, other.low)};
}

bool is_transversal(const Piece& a, const Piece& b) {
  if (a.chord == Vec2{} || b.chord == Vec2{}) return false;
  const double angle = std::abs(std::atan2(cross(a.chord, b.chord), dot(a.chord, b.chord)));
  const double between = std::min(angle, std::numbers::pi - angle);
  return a.half_cone + b.half_cone < between;
}

struct Root {
  double s = 0;
  double t = 0;
};

std::optional<Root> newton(const PlanarBezier& a, const PlanarBezier& b) {
  Root root{0.5, 0.5};
  for (int k = 0; k < kNewtonSteps; ++k) {
    const PlanarJet at_a = jet_at(a, root.s);
    const PlanarJet at_b = jet_at(b, root.t);
    const double det = cross(at_a.first, at_b.first);
    if (det == 0) return std::nullopt;
    const Vec2 gap = at_b.point - at_a.point;
    const Root step{cross(gap, at_b.first) / det, cross(gap, at_a.first) / det};
    root = {root.s + step.s, root.t + step.t};
    if (std::max(std::abs(root.s - 0.5), std::abs(root.t - 0.5)) > 4) return std::nullopt;
    if (std::max(std::abs(step.s), std::abs(step.t)) < 1e-14) return root;
  }
  return std::nullopt;
}

double parameter_of(const Piece& piece, double t) {
  return parameter_at(piece.span->law, piece.span->place, std::clamp(at(piece.local, t), 0.0, 1.0));
}

class Search {
 public:
  Search(double tolerance, long budget) : tolerance_(tolerance), budget_(budget) {}

  void add(Piece a, Piece b) { pairs_.emplace_back(std::move(a), std::move(b)); }

  void run() {
    while (!pairs_.empty() && complete_) {
      auto [a, b] = std::move(pairs_.back());
      pairs_.pop_back();
      complete_ = budget_-- > 0;
      examine(a, b);
    }
  }

  std::vector<PlanarCrossing> points;
  std::vector<PlanarOverlap> contacts;
  bool complete() const { return complete_; }

 private:
  void examine(const Piece& a, const Piece& b) {
    if (apart(a.box, b.box, tolerance_)) return;
    const FatLine along_a = fat_line(a, b.curve, tolerance_);
    const FatLine along_b = fat_line(b, a.curve, tolerance_);
    if (along_a.separates || along_b.separates) return;
    if (is_transversal(a, b) && settle(a, b)) return;
    const bool close = std::max(along_a.width, along_b.width) <= tolerance_;
    if (close || std::max(size(a), size(b)) <= tolerance_) {
      add_contact(a, b);
    } else if (size(a) >= size(b)) {
      auto [low, high] = halves(a);
      add(std::move(low), b);
      add(std::move(high), b);
    } else {
      auto [low, high] = halves(b);
      add(a, std::move(low));
      add(a, std::move(high));
    }
  }

  // The one root that transversal pieces can have. False if it was not found.
  bool settle(const Piece& a, const Piece& b) {
    const std::optional<Root> root = newton(a.curve, b.curve);
    if (!root) return false;
    const auto inside = [](double t) { return t >= -kSlack && t <= 1 + kSlack; };
    if (!inside(root->s) || !inside(root->t)) return true;
    points.push_back({parameter_of(a, root->s), parameter_of(b, root->t),
                      jet_at(a.curve, std::clamp(root->s, 0.0, 1.0)).point, false});
    return true;
  }

  // Both pieces lie along one line: what they share of it.
  void add_contact(const Piece& a, const Piece& b) {
    const Vec2 direction = unit(size(a) >= size(b) ? a.chord : b.chord);
    const Vec2 origin = projected(a.curve.points.front());
    const auto place = [&](const Piece& piece, double t) {
      return dot(jet_at(piece.curve, t).point - origin, direction);
    };
    const Range on_a{std::min(place(a, 0), place(a, 1)), std::max(place(a, 0), place(a, 1))};
    const Range on_b{std::min(place(b, 0), place(b, 1)), std::max(place(b, 0), place(b, 1))};
    const double low = std::max(on_a.low, on_b.low);
    const double high = std::min(on_a.high, on_b.high);
    if (low > high + tolerance_) return;
    const auto fraction = [&](const Piece& piece, double value) {
      const double span = place(piece, 1) - place(piece, 0);
      return span == 0 ? 0.5 : std::clamp((value - place(piece, 0)) / span, 0.0, 1.0);
    };
    double first = low, last = high;
    if (place(a, 0) > place(a, 1)) std::swap(first, last);
    contacts.push_back({{parameter_of(a, fraction(a, first)), parameter_of(a, fraction(a, last))},
                        {parameter_of(b, fraction(b, first)), parameter_of(b, fraction(b, last))}});
  }

  double tolerance_;
  long budget_;
  bool complete_ = true;
  std::vector<std::pair<Piece, Piece>> pairs_;
};

std::vector<Piece> pieces_of(const PlanarCurve& curve) {
  std::vector<Piece> pieces;
  for (const PlanarSpan& span : curve.spans) pieces.push_back(make_piece(span, {0, 1}, span.curve));
  return pieces;
}

// Everything found, cleaned: contacts joined to runs, the same point once.
class Harvest {
 public:
  Harvest(const PlanarCurve& a, const PlanarCurve& b, double tolerance)
      : a_(a), b_(b), tolerance_(tolerance) {
    const PlanarBox box = united(box_of(a), box_of(b));
    touch_length_ = kTouchLength * std::sqrt(tolerance * norm(box.high - box.low));
  }

  // An end of one curve within tolerance of the other.
  void add_ends() {
    const Interval on_a = a_.domain(), on_b = b_.domain();
    for (const double end : {on_a.from, on_a.to}) {
      const Vec2 point = point_at(a_, end);
      const PlanarFoot foot = nearest(b_, point);
      if (foot.distance <= tolerance_) add({end, foot.parameter, point, false});
    }
    for (const double end : {on_b.from, on_b.to}) {
      const Vec2 point = point_at(b_, end);
      const PlanarFoot foot = nearest(a_, point);
      if (foot.distance <= tolerance_) add({foot.parameter, end, point, false});
    }
  }

  void add(const PlanarCrossing& crossing) {
    for (PlanarCrossing& known : found.points)
      if (same(a_, known.a, crossing.a) && same(b_, known.b, crossing.b)) {
        keep_ends(known, crossing);
        return;
      }
    found.points.push_back(crossing);
  }

  void add_contacts(std::vector<PlanarOverlap> contacts) {
    std::sort(contacts.begin(), contacts.end(),
              [](const auto& x, const auto& y) { return x.a.from < y.a.from; });
    std::vector<PlanarOverlap> runs;
    for (const PlanarOverlap& contact : contacts) {
      const auto run = std::find_if(runs.begin(), runs.end(), [&](const PlanarOverlap& known) {
        return continues(known, contact);
      });
      if (run == runs.end()) {
        runs.push_back(contact);
      } else if (contact.a.to > run->a.to) {
        run->a.to = contact.a.to;
        run->b.to = contact.b.to;
      }
    }
    for (const PlanarOverlap& run : runs) add_run(run);
  }

  PlanarCrossings found;

 private:
  // The curve stays near between the two parameters, so they are one point.
  bool same(const PlanarCurve& curve, double s, double t) const {
    const Vec2 point = point_at(curve, s);
    return distance(point, point_at(curve, t)) <= 2 * tolerance_ &&
           distance(point, point_at(curve, 0.5 * (s + t))) <= 2 * tolerance_;
  }

  void keep_ends(PlanarCrossing& known, const PlanarCrossing& crossing) const {
    const auto is_end = [](const PlanarCurve& curve, double t) {
      return t == curve.domain().from || t == curve.domain().to;
    };
    if (is_end(a_, crossing.a)) known.a = crossing.a;
    if (is_end(b_, crossing.b)) known.b = crossing.b;
    known.tangential = known.tangential && crossing.tangential;
  }

  bool continues(const PlanarOverlap& run, const PlanarOverlap& contact) const {
    const auto near = [&](const PlanarCurve& curve, double s, double t) {
      return distance(point_at(curve, s), point_at(curve, t)) <= 4 * tolerance_;
    };
    const bool follows = contact.a.from <= run.a.to || near(a_, run.a.to, contact.a.from);
    const double low = std::min(run.b.from, run.b.to), high = std::max(run.b.from, run.b.to);
    const double first = std::min(contact.b.from, contact.b.to);
    const double last = std::max(contact.b.from, contact.b.to);
    return follows && (first <= high || near(b_, first, high)) &&
           (last >= low || near(b_, last, low));
  }

  void add_run(const PlanarOverlap& run) {
    if (distance(point_at(a_, run.a.from), point_at(a_, run.a.to)) > touch_length_) {
      found.overlaps.push_back(run);
      return;
    }
    for (const PlanarCrossing& known : found.points)
      if (known.a >= run.a.from && known.a <= run.a.to) return;
    add(closest(run));
  }

  // The point of a short run where the curves come closest, by thirds.
  PlanarCrossing closest(const PlanarOverlap& run) const {
    const auto gap = [&](double s) { return nearest(b_, point_at(a_, s)).distance; };
    double low = run.a.from, high = run.a.to;
    for (int k = 0; k < 60 && high > low; ++k) {
      const double third = (high - low) / 3;
      if (gap(low + third) < gap(high - third))
        high -= third;
      else
        low += third;
    }
    const double s = 0.5 * (low + high);
    const Vec2 point = point_at(a_, s);
    return {s, nearest(b_, point).parameter, point, true};
  }

  const PlanarCurve& a_;
  const PlanarCurve& b_;
  double tolerance_;
  double touch_length_ = 0;
};

}  // namespace

PlanarCrossings crossings(const PlanarCurve& a, const PlanarCurve& b, double tolerance,
                          long budget) {
  if (!(tolerance > 0)) throw InvalidInput("crossings: the tolerance must be positive");
  if (a.spans.empty() || b.spans.empty()) throw InvalidInput("crossings: a curve has no span");
  if (apart(box_of(a), box_of(b), tolerance)) return {};
  Search search(tolerance, budget);
  const std::vector<Piece> of_b = pieces_of(b);
  for (const Piece& piece : pieces_of(a))
    for (const Piece& other : of_b)
      if (!apart(piece.box, other.box, tolerance)) search.add(piece, other);
  search.run();
  Harvest harvest(a, b, tolerance);
  harvest.add_ends();
  for (const PlanarCrossing& point : search.points) harvest.add(point);
  harvest.add_contacts(std::move(search.contacts));
  harvest.found.complete = search.complete();
  std::sort(harvest.found.points.begin(), harvest.found.points.end(),
            [](const PlanarCrossing& x, const PlanarCrossing& y) { return x.a < y.a; });
  return harvest.found;
}

}  // namespace blossom
