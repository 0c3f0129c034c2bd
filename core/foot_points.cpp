// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/foot_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/errors.h"
#include "core/bounds/patch_boxes.h"
#include "core/cells/limits.h"
#include "core/cells/surface_cells.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/derivatives.h"
#include "core/forms/algebra/products.h"
#include "core/forms/evaluation.h"
#include "core/math/roundoff.h"
#include "core/rays/limits.h"
#include "core/rays/two_forms.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {
namespace {

constexpr int kSteps = 60;            // of a contraction that halves what is left, up to roundings
constexpr int kPieceBudget = 20'000;  // a choice: so many pieces are looked at, and the rest open
// Second derivatives whose determinant is this small, as a part of their size, tell nothing.
constexpr double kFlat = 1e-9;
// A derivative this small beside the other one is that of a collapsed side.
constexpr double kCollapsed = 1e-9;

BezierPatch difference(const BezierPatch& a, const BezierPatch& b) {
  BezierPatch result = a;
  for (std::size_t i = 0; i < a.points.values().size(); ++i)
    result.points.values()[i] -= b.points.values()[i];
  return result;
}

// The two equations over a patch as one net of two planes, and a bound on its error.
struct Equations {
  NetShape shape;
  std::vector<double> net;
  double margin = 0;
};

// (S - p) . S_u times a power of w: X . X_u if w = 1, else X . (w X_u - w_u X), X = w (S - p).
BezierFunction2 equation(const BezierPatch& x, const BezierFunction2& w, bool rational, bool by_u) {
  const BezierPatch slope = derivative(x, by_u ? 1 : 0, by_u ? 0 : 1);
  if (!rational) return dot_product(x, slope);
  const BezierFunction2 w_slope = derivative(w, by_u ? 1 : 0, by_u ? 0 : 1);
  return dot_product(x, difference(product(w, slope), product(w_slope, x)));
}

Equations equations(const RationalBezierPatch& patch, const Vec3& p, bool rational, bool is_curve) {
  BezierPatch x{Grid<Vec3>(patch.points.rows(), patch.points.columns())};
  BezierFunction2 w{Grid<double>(patch.points.rows(), patch.points.columns())};
  double size = 0, numbers = 0, weight = 0;
  for (std::size_t i = 0; i < patch.points.values().size(); ++i) {
    const Vec4& q = patch.points.values()[i];
    x.points.values()[i] = Vec3{q[0], q[1], q[2]} - q[3] * p;
    w.points.values()[i] = q[3];
    size = std::max(size, max_norm(x.points.values()[i]));
    numbers = std::max(numbers, max_norm(q) + q[3] * max_norm(p));
    weight = std::max(weight, q[3]);
  }
  const int times = rational ? 3 : 2;
  const int n = times * patch.degree_u(), m = times * patch.degree_v();
  const BezierFunction2 f = elevated(equation(x, w, rational, true), n, m);
  BezierFunction2 g{Grid<double>(n + 1, m + 1)};
  if (is_curve) {  // a curve has no width: v = 1/2
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= m; ++j) g.points(i, j) = size * size * (j / double(m) - 0.5);
  } else {
    g = elevated(equation(x, w, rational, false), n, m);
  }
  Equations result{{n + 1, m + 1, 2}, {}, 0};
  result.net.assign(f.points.values().begin(), f.points.values().end());
  result.net.insert(result.net.end(), g.points.values().begin(), g.points.values().end());
  // A form X of size s with errors of 4 roundings of the numbers that it came from, a derivative
  // of size 2 d s, and products with (n + 1)(m + 1) + 13 roundings each, of three coordinates.
  const int degree = std::max(patch.degree_u(), patch.degree_v());
  const double growth = 2.0 * degree * size * (rational ? 2 * weight : 1);
  const double roundings = 3.0 * times * ((n + 1) * (m + 1) + 29);
  result.margin = 3 * growth * (roundings * size + 8 * numbers) * kUnitRoundoff;
  return result;
}

Extremum extremum_of(const PatchJet& jet, const Vec3& p, bool is_curve) {
  const Vec3 r = jet.point - p;
  const double uu = dot(jet.u, jet.u) + dot(r, jet.uu);
  if (is_curve) {
    if (std::abs(uu) <= kFlat * dot(jet.u, jet.u)) return Extremum::Unknown;
    return uu > 0 ? Extremum::Minimum : Extremum::Maximum;
  }
  const double vv = dot(jet.v, jet.v) + dot(r, jet.vv), uv = dot(jet.u, jet.v) + dot(r, jet.uv);
  const double determinant = uu * vv - uv * uv;
  if (std::abs(determinant) <= kFlat * (std::abs(uu * vv) + uv * uv)) return Extremum::Unknown;
  if (determinant < 0) return Extremum::Saddle;
  return uu > 0 ? Extremum::Minimum : Extremum::Maximum;
}

struct Piece {
  Interval u{0, 1}, v{0, 1};
  int depth = 0;
  std::vector<double> net;
};

// The feet on one patch, or on a curve as a patch without width.
class PatchFeet {
 public:
  PatchFeet(const RationalBezierPatch& patch, bool is_curve, const Vec3& point, double tolerance)
      : patch_(patch), is_curve_(is_curve), point_(point), tolerance_(tolerance) {}

  std::vector<FootPoint> feet;
  std::vector<Vec2> locals;  // of the feet

  void run(bool rational) {
    const int highest = (rational ? 3 : 2) * std::max(patch_.degree_u(), patch_.degree_v());
    if (highest > kMaxProductDegree) {
      add({}, {0.5, 0.5}, Status::Stopped);
      return;
    }
    Equations made = equations(patch_, point_, rational, is_curve_);
    shape_ = made.shape;
    margin_ = made.margin;
    net_scale_ = largest_of(range_of(made.net.data(), shape_.size()));
    std::vector<Piece> open{{{0, 1}, {0, 1}, 0, std::move(made.net)}};
    for (int looked = 0; !open.empty(); ++looked) {
      Piece piece = std::move(open.back());
      open.pop_back();
      if (looked >= kPieceBudget)
        add(piece, {at(piece.u, 0.5), at(piece.v, 0.5)}, Status::Stopped);
      else
        look_at(piece, open);
    }
  }

 private:
  void look_at(const Piece& piece, std::vector<Piece>& open) {
    const int degree = std::max(shape_.rows, shape_.columns) - 1;
    const double margin = margin_ + halving_error(degree, piece.depth) * net_scale_;
    const TwoForms forms = two_forms(shape_, piece.net.data(), margin);
    for (const ValueRange& range : {forms.f, forms.g})
      if (range.low > margin || range.high < -margin) return;
    if (forms.regular && settles(piece, forms)) return;
    const auto& s = forms.slopes;
    const double along_u = std::max(largest_of(s[0][0]), largest_of(s[1][0]));
    const double along_v = std::max(largest_of(s[0][1]), largest_of(s[1][1]));
    if (extent(piece) <= tolerance_ || std::max(along_u, along_v) <= 4 * degree * margin)
      add(piece, {at(piece.u, 0.5), at(piece.v, 0.5)}, Status::Tolerance);
    else
      halve(piece, along_u >= along_v, open);
  }

  // Finds the one foot that a piece can have, or proves that there is none.
  bool settles(const Piece& piece, const TwoForms& forms) {
    const Vec2 centre = offset(piece, forms, {0.5, 0.5});
    Vec2 slack;
    bool exact = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const int k = static_cast<int>(i);
      slack[k] = std::max(kRootSlack, 4 * forms.rounding[k]);
      const double bound = 0.5 * (1 + forms.spread[i][0] + forms.spread[i][1]) + slack[k];
      if (std::abs(centre[k]) > bound + forms.rounding[k]) return true;
      exact = exact && forms.rounding[k] < kPlaceable;
    }
    if (!exact || !is_contraction(forms.spread)) return false;
    Vec2 x = Vec2{0.5, 0.5} - centre;
    constexpr double kBestStep = 1e-15, kWorstStep = 1e-10;  // part of the piece
    const double last_step = std::clamp(max_norm(forms.rounding), kBestStep, kWorstStep);
    double step = 1;
    for (int k = 0; k < kSteps && step > last_step && max_norm(x) <= 2; ++k) {
      const Vec2 move = offset(piece, forms, x);
      x -= move;
      step = max_norm(move);
    }
    if (step > last_step && max_norm(x) <= 2) return false;  // halves contract faster
    Vec2 nearest = x, outside;
    bool inside = true;
    for (int k = 0; k < 2; ++k) {
      inside = inside && x[k] >= -slack[k] && x[k] <= 1 + slack[k];
      nearest[k] = std::clamp(x[k], 0.0, 1.0);
      outside[k] = x[k] <= 0 ? -1 : x[k] >= 1 ? 1 : 0;
    }
    if (inside) add(piece, {at(piece.u, nearest[0]), at(piece.v, nearest[1])}, Status::Complete);
    return inside ||
           leads_outside(forms.spread, offset(piece, forms, nearest), forms.rounding, outside);
  }

  Vec2 offset(const Piece& piece, const TwoForms& forms, const Vec2& x) const {
    return product(forms.inverse, values_at(shape_, piece.net.data(), x[0], x[1]));
  }

  void halve(const Piece& piece, bool along_u, std::vector<Piece>& open) const {
    Piece low = piece, high = piece;
    (along_u ? halve_bezier_u : halve_bezier_v)(shape_, piece.net.data(), kOffMiddle,
                                                low.net.data(), high.net.data());
    Interval Piece::*side = along_u ? &Piece::u : &Piece::v;
    (low.*side).to = (high.*side).from = at(piece.*side, kOffMiddle);
    ++low.depth;
    ++high.depth;
    open.push_back(std::move(low));
    open.push_back(std::move(high));
  }

  Vec3 point_of(double u, double v) const { return jet_at(patch_, u, v, 1).point; }

  // About how large a piece is: only tells when to stop halving.
  double extent(const Piece& piece) const {
    return distance(point_of(piece.u.from, piece.v.from), point_of(piece.u.to, piece.v.to)) +
           distance(point_of(piece.u.from, piece.v.to), point_of(piece.u.to, piece.v.from));
  }

  void add(const Piece& piece, const Vec2& local, Status status) {
    const PatchJet jet = jet_at(patch_, local[0], local[1], 2);
    // Where a side is collapsed one equation holds by itself. A foot there has the other one hold
    // all along the side; so a single root is none.
    const double least = std::min(norm(jet.u), norm(jet.v));
    const double most = std::max(norm(jet.u), norm(jet.v));
    if (status == Status::Complete && !is_curve_ && least <= kCollapsed * most) return;
    FootPoint foot;
    foot.at.point = jet.point;
    foot.distance = distance(jet.point, point_);
    foot.status = status;
    foot.size = status == Status::Complete ? 0 : extent(piece);
    foot.extremum = extremum_of(jet, point_, is_curve_);
    feet.push_back(foot);
    locals.push_back(local);
  }

  const RationalBezierPatch& patch_;
  bool is_curve_;
  Vec3 point_;
  double tolerance_;
  NetShape shape_;
  double margin_ = 0;
  double net_scale_ = 0;
};

bool is_rational(const RationalBezierPatch& patch) {
  return std::any_of(patch.points.values().begin(), patch.points.values().end(),
                     [](const Vec4& p) { return p[3] != 1; });
}

// Feet that two pieces or two patches of one curve or surface have found are one.
void join(std::vector<FootPoint>& feet, double tolerance) {
  std::stable_sort(feet.begin(), feet.end(),
                   [](const FootPoint& a, const FootPoint& b) { return a.distance < b.distance; });
  std::vector<FootPoint> kept;
  for (const FootPoint& foot : feet) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const FootPoint& known) {
      const double near = known.status == Status::Complete && foot.status == Status::Complete
                              ? tolerance
                              : 2 * (known.size + foot.size + tolerance);
      return known.at.kind == foot.at.kind && known.at.index == foot.at.index &&
             distance(known.at.point, foot.at.point) <= near;
    });
    if (same == kept.end()) {
      kept.push_back(foot);
    } else {
      same->status = weaker(same->status, foot.status);
      same->size = std::max(same->size, foot.size);
    }
  }
  feet = std::move(kept);
}

// Of one patch, within the trims.
void add_patch(const DistanceOperand& set, int surface, int row, int column, const Vec3& point,
               double tolerance, std::vector<FootPoint>& feet) {
  const BezierSurface& s = set.surfaces[static_cast<std::size_t>(surface)];
  PatchFeet found(s.patches(row, column), false, point, tolerance);
  found.run(is_rational(s.patches(row, column)));
  const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
  for (std::size_t k = 0; k < found.feet.size(); ++k) {
    FootPoint& foot = found.feet[k];
    foot.at.kind = DistanceEnd::Kind::Surface;
    foot.at.index = surface;
    foot.at.uv = {parameter_at(s.u_law, {s.u_knots[i], s.u_knots[i + 1]}, found.locals[k][0]),
                  parameter_at(s.v_law, {s.v_knots[j], s.v_knots[j + 1]}, found.locals[k][1])};
    if (!set.trims || set.trims(surface, foot.at.uv, foot.at.uv) != TrimSide::Outside)
      feet.push_back(foot);
  }
}

void add_curve(const DistanceOperand& set, int curve, const Vec3& point, double tolerance,
               std::vector<FootPoint>& feet) {
  const std::vector<Vec4>& points = set.curves[static_cast<std::size_t>(curve)].points;
  const int count = static_cast<int>(points.size());
  RationalBezierPatch patch{Grid<Vec4>(count, 2)};
  for (int i = 0; i < count; ++i)
    patch.points(i, 0) = patch.points(i, 1) = points[static_cast<std::size_t>(i)];
  PatchFeet found(patch, true, point, tolerance);
  found.run(is_rational(patch));
  for (std::size_t k = 0; k < found.feet.size(); ++k) {
    found.feet[k].at.kind = DistanceEnd::Kind::Curve;
    found.feet[k].at.index = curve;
    found.feet[k].at.uv = {found.locals[k][0], 0};
    feet.push_back(found.feet[k]);
  }
}

// A foot may be anywhere on a surface.
FootPoint open_surface(const BezierSurface& surface, int number, const Vec3& point) {
  FootPoint foot;
  foot.at.kind = DistanceEnd::Kind::Surface;
  foot.at.index = number;
  foot.at.uv = {0.5 * (surface.u_knots.front() + surface.u_knots.back()),
                0.5 * (surface.v_knots.front() + surface.v_knots.back())};
  foot.at.point = point_at(surface, foot.at.uv);
  foot.distance = distance(foot.at.point, point);
  foot.status = Status::Stopped;
  foot.size = diagonal(PatchBoxes(surface).all());
  return foot;
}

void add_surface(const DistanceOperand& set, int number, const Vec3& point, double tolerance,
                 const WorkLimit* limit, std::vector<FootPoint>& feet) {
  const BezierSurface& surface = set.surfaces[static_cast<std::size_t>(number)];
  for (int row = 0; row < surface.patches.rows(); ++row) {
    if (limit != nullptr && limit->reached() != nullptr) {
      feet.push_back(open_surface(surface, number, point));
      return;
    }
    for (int column = 0; column < surface.patches.columns(); ++column)
      add_patch(set, number, row, column, point, tolerance, feet);
  }
}

}  // namespace

const char* to_string(Extremum extremum) {
  switch (extremum) {
    case Extremum::Minimum: return "minimum";
    case Extremum::Maximum: return "maximum";
    case Extremum::Saddle: return "saddle";
    case Extremum::Unknown: break;
  }
  return "unknown";
}

std::vector<FootPoint> foot_points(const DistanceOperand& set, const Vec3& point, double tolerance,
                                   const WorkLimit* limit) {
  if (!(tolerance > 0)) throw InvalidInput("foot_points: the tolerance must be positive");
  if (!std::isfinite(dot(point, point))) throw InvalidInput("foot_points: the point is not finite");
  std::vector<FootPoint> feet;
  for (int i = 0; i < static_cast<int>(set.curves.size()); ++i)
    add_curve(set, i, point, tolerance, feet);
  for (int i = 0; i < static_cast<int>(set.surfaces.size()); ++i) {
    validate(set.surfaces[static_cast<std::size_t>(i)], "to find feet on");
    add_surface(set, i, point, tolerance, limit, feet);
  }
  join(feet, tolerance);
  return feet;
}

}  // namespace blossom
