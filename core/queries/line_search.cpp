// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/queries/line_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/subdivision/cell_nets.h"

namespace blossom {
namespace {

constexpr double kRoundoff = 0x1p-53;
// Roots this little outside of a region belong to it, too; the neighbour finds the same root.
constexpr double kLeastSlack = 1e-9;
constexpr double kMostSlack = 0.25;
// Values must be this exact, in parameters of the region, for a root to be placed in it.
constexpr double kExact = 1e-3;
// Newton's method squares its error, so a step of this size ends at rounding.
constexpr double kLastStep = 1e-8;
constexpr int kNewtonSteps = 12;
// Off the middle: singular points like dyadic lines.
constexpr double kCut = 0.5 - 1.0 / 64;
// Nets in the stack; two more serve as scratch. 80 halvings in each direction.
constexpr int kPlaces = 160;
// A contact this many times longer than sqrt(tolerance * size) is no touch of curved surfaces.
constexpr double kTouchLength = 10;

struct Range {
  double low;
  double high;
};

Range range_of(const double* values, int count) {
  Range range{values[0], values[0]};
  for (int i = 1; i < count; ++i) {
    range.low = values[i] < range.low ? values[i] : range.low;
    range.high = values[i] > range.high ? values[i] : range.high;
  }
  return range;
}

double largest(const Range& range) { return std::max(std::abs(range.low), std::abs(range.high)); }

// Derivative by u or v: degree times the differences of neighbours.
Range slope_u(const double* net, int rows, int columns) {
  const double degree = rows - 1;
  Range range{net[columns] - net[0], net[columns] - net[0]};
  for (int i = 0; i < (rows - 1) * columns; ++i) {
    const double d = net[i + columns] - net[i];
    range.low = d < range.low ? d : range.low;
    range.high = d > range.high ? d : range.high;
  }
  return {degree * range.low, degree * range.high};
}

Range slope_v(const double* net, int rows, int columns) {
  const double degree = columns - 1;
  Range range{net[1] - net[0], net[1] - net[0]};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j) {
      const double d = net[i * columns + j + 1] - net[i * columns + j];
      range.low = d < range.low ? d : range.low;
      range.high = d > range.high ? d : range.high;
    }
  return {degree * range.low, degree * range.high};
}

double middle(const Range& range) { return 0.5 * (range.low + range.high); }
double radius(const Range& range) { return 0.5 * (range.high - range.low); }

// Bernstein polynomials of a degree at t.
void bernstein(int degree, double t, double* b) {
  b[0] = 1;
  for (int k = 1; k <= degree; ++k) {
    double carried = 0;
    for (int i = 0; i < k; ++i) {
      const double value = b[i];
      b[i] = carried + (1 - t) * value;
      carried = t * value;
    }
    b[k] = carried;
  }
}

Vec3 any_across(const Vec3& d) {
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(d[k]) < std::abs(d[least])) least = k;
  Vec3 axis;
  axis[least] = 1;
  return unit(cross(d, axis));
}

// (I - E)^-1 r for a contraction E: bounds the distance of a root from a point with value r.
Vec2 root_distance(const std::array<std::array<double, 2>, 2>& e, const Vec2& r) {
  const double a = 1 - e[0][0], d = 1 - e[1][1];
  const double determinant = a * d - e[0][1] * e[1][0];
  return Vec2{d * r[0] + e[0][1] * r[1], e[1][0] * r[0] + a * r[1]} * (1 / determinant);
}

// A root within rounding of the border belongs to the region, and one within tolerance.
double clamped_slack(double tolerance, double rounding) {
  return std::clamp(std::max(tolerance, 4 * rounding), kLeastSlack, kMostSlack);
}

}  // namespace

LineSearch::LineSearch(const FlatCells& cells, double tolerance)
    : cells_(cells), tolerance_(tolerance) {
  nets_.resize(static_cast<std::size_t>((kPlaces + 2) * 2 * cells.largest_net()));
  stack_.reserve(static_cast<std::size_t>(kPlaces));
}

void LineSearch::aim(const Ray& ray) {
  ray_ = ray;
  square_ = dot(ray.direction, ray.direction);
  direction_scale_ = max_norm(ray.direction);
}

void LineSearch::examine(const FlatCell& cell, std::vector<RayHit>& hits) {
  cell_ = &cell;
  if (cell.regular) {
    const Guess first = guess(cell);
    if (first.excluded) return;
    patch_ = placed().patch;
    anchor_ = point_at(ray_, dot(cell.centre - ray_.origin, ray_.direction) / square_);
    if (first.contracts) {
      const double per_normal = 1 / dot(cell.normal, ray_.direction);
      const auto value = [&](const Vec2& local) {
        const Vec3 r = jet_at(*patch_, local[0], local[1], 1).point - anchor_;
        const Vec3 q = r - (dot(cell.normal, r) * per_normal) * ray_.direction;
        return Vec2{dot(cell.dual[0], q), dot(cell.dual[1], q)};
      };
      if (settle(first.region, first.root, value, hits) != Verdict::Open) return;
    }
  }
  patch_ = placed().patch;
  anchor_ = point_at(ray_, dot(cell.centre - ray_.origin, ray_.direction) / square_);
  search(hits);
}

// Seen along the line, on the plane (centre, N), a point of the cell has the coordinates
//   G(x) = D (r - (N . r / N . d) d),   r = S(x) - origin,
// which differ from x - root by no more than spread + |D . d / N . d| tilt. A line in the plane of
// the cell gives infinite or no numbers; then nothing follows from them.
LineSearch::Guess LineSearch::guess(const FlatCell& cell) const {
  Guess result;
  result.region.u = cell.u;
  result.region.v = cell.v;
  const Vec3 r = cell.centre - ray_.origin;
  const double per_normal = 1 / dot(cell.normal, ray_.direction);
  const double t = dot(cell.normal, r) * per_normal;
  const Vec3 q = r - t * ray_.direction;
  const double error = cells_.evaluation_error() * cells_.scale() +
                       8 * kRoundoff * (max_norm(ray_.origin) + std::abs(t) * direction_scale_);
  const double reach = cells_.patches()[static_cast<std::size_t>(cell.patch)].reach;
  Vec2 value;
  bool exact = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const int k = static_cast<int>(i);
    const double lean = std::abs(dot(cell.dual[i], ray_.direction) * per_normal);
    for (std::size_t j = 0; j < 2; ++j)
      result.region.spread[i][j] = cell.spread[i][j] + lean * cell.tilt[j];
    value[k] = dot(cell.dual[i], q);
    result.region.rounding[k] = 4 * error * (cell.dual_length[i] + lean);
    result.region.slack[k] = clamped_slack(reach * cell.dual_length[i], result.region.rounding[k]);
    const double bound = 0.5 * (1 + result.region.spread[i][0] + result.region.spread[i][1]) +
                         result.region.rounding[k] + result.region.slack[k];
    result.excluded = result.excluded || std::abs(value[k]) > bound;
    exact = exact && result.region.rounding[k] < kExact;
  }
  result.root = {at(cell.u, 0.5 - value[0]), at(cell.v, 0.5 - value[1])};
  result.contracts = exact && is_contraction(result.region.spread);
  return result;
}

// The one root that a region can have: found by Newton's method, or proven not to be there.
template <class Value>
LineSearch::Verdict LineSearch::settle(const Region& region, const Vec2& start, Value value,
                                       std::vector<RayHit>& hits) {
  const Newton root = newton(region, start);
  const std::array<Interval, 2> sides{region.u, region.v};
  Vec2 nearest = root.converged ? root.local : start, outside;
  bool inside = root.converged;
  for (int k = 0; k < 2; ++k) {
    const Interval& side = sides[static_cast<std::size_t>(k)];
    const double x = (nearest[k] - side.from) / length(side) - 0.5;
    inside = inside && std::abs(x) <= 0.5 + region.slack[k];
    if (std::abs(x) < 0.5) continue;
    outside[k] = x < 0 ? -1 : 1;
    nearest[k] = x < 0 ? side.from : side.to;
  }
  if (inside) {
    add_hit(root, hits);
    return Verdict::Root;
  }
  // From the nearest point p a root x has x - p = -G(p) to within E |x - p|; that must not lead
  // out of the region.
  const Vec2 at_nearest = value(nearest);
  Vec2 size;
  for (int k = 0; k < 2; ++k) size[k] = std::abs(at_nearest[k]) + region.rounding[k];
  const Vec2 reach = root_distance(region.spread, size);
  for (std::size_t i = 0; i < 2; ++i) {
    const int k = static_cast<int>(i);
    const double drift = region.spread[i][0] * reach[0] + region.spread[i][1] * reach[1];
    if (-at_nearest[k] * outside[k] > (drift + region.rounding[k]) * (1 + 1e-9))
      return Verdict::Empty;
  }
  return Verdict::Open;
}

LineSearch::Newton LineSearch::newton(const Region& region, const Vec2& start) const {
  Newton result;
  result.local = start;
  const Vec2 size{length(region.u), length(region.v)};
  const Vec2 centre{at(region.u, 0.5), at(region.v, 0.5)};
  const Vec3& d = ray_.direction;
  for (int step = 0; step < kNewtonSteps; ++step) {
    for (int k = 0; k < 2; ++k)
      if (!(std::abs(result.local[k] - centre[k]) <= 1.5 * size[k])) return result;
    result.jet = jet_at(*patch_, result.local[0], result.local[1], 1);
    const PatchJet& jet = result.jet;
    const Vec3 r = anchor_ - jet.point;
    const double per_area = 1 / dot(cross(jet.u, jet.v), d);
    const Vec2 move{dot(r, cross(jet.v, d)) * per_area, dot(r, cross(d, jet.u)) * per_area};
    result.local += move;
    if (std::abs(move[0]) <= std::max(kLastStep, region.rounding[0]) * size[0] &&
        std::abs(move[1]) <= std::max(kLastStep, region.rounding[1]) * size[1]) {
      result.point = jet.point + move[0] * jet.u + move[1] * jet.v;
      result.converged = true;
      return result;
    }
  }
  return result;
}

// False if the neighbour answers for it.
bool LineSearch::add_hit(const Newton& root, std::vector<RayHit>& hits) const {
  RayHit hit;
  hit.patch = cell_->patch;
  hit.surface = placed().surface;
  hit.point = root.point;
  hit.local = root.local;
  hit.parameter = dot(root.point - ray_.origin, ray_.direction) / square_;
  hit.first = hit.last = hit.parameter;
  const Vec3 area = cross(root.jet.u, root.jet.v);
  hit.normal = unit(area);
  hit.grazing = std::abs(dot(area, ray_.direction)) <= kGrazing * norm(area) * std::sqrt(square_);
  const std::array<const Vec3*, 2> derivatives{&root.jet.u, &root.jet.v};
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    // A length along the surface; at a collapsed side all of it is one point.
    const double speed = norm(*derivatives[i]);
    const double from_border = std::min(hit.local[k], 1 - hit.local[k]);
    hit.border = hit.border || from_border <= kLeastSlack || from_border * speed <= tolerance_;
    if (from_border >= 0) continue;
    const bool ends = hit.local[k] < 0 ? placed().ends_low[i] : placed().ends_high[i];
    const double beyond = -from_border * speed;
    if (from_border < -kLeastSlack && beyond > (ends ? placed().reach : tolerance_)) return false;
    hit.beyond = std::max(hit.beyond, beyond);
    hit.local[k] = std::clamp(hit.local[k], 0.0, 1.0);
  }
  if (hit.beyond > 0) hit.point = jet_at(*patch_, hit.local[0], hit.local[1], 1).point;
  hit.uv = cells_.parameters(hit.patch, hit.local);
  hits.push_back(hit);
  return true;
}

void LineSearch::search(std::vector<RayHit>& hits) {
  rows_ = patch_->points.rows();
  columns_ = patch_->points.columns();
  net_size_ = 2 * rows_ * columns_;
  load_net();
  restrict_net();
  const NetShape shape{rows_, columns_, 2};
  stack_.clear();
  stack_.push_back({cell_->u, cell_->v, 0});
  for (int looked = 0; !stack_.empty(); ++looked) {
    const Piece piece = stack_.back();
    const int place = static_cast<int>(stack_.size()) - 1;
    stack_.pop_back();
    if (looked >= kPieceBudget) {
      add_contact(piece, Status::Stopped, hits);
      continue;
    }
    bool open = false;
    look_at(piece, net_at(place), hits, open);
    if (!open) continue;
    if (place + 2 > kPlaces) {
      add_contact(piece, Status::Stopped, hits);
      continue;
    }
    const bool along_u = split_along_u(net_at(place));
    double* const low = net_at(kPlaces);
    (along_u ? halve_bezier_u : halve_bezier_v)(shape, net_at(place), kCut, low, net_at(place + 1));
    std::copy(low, low + net_size_, net_at(place));
    Piece halves[2] = {piece, piece};
    Interval Piece::*side = along_u ? &Piece::u : &Piece::v;
    const double cut = at(piece.*side, kCut);
    (halves[0].*side).to = cut;
    (halves[1].*side).from = cut;
    for (Piece& half : halves) {
      ++half.depth;
      stack_.push_back(half);
    }
  }
}

// f and g over the whole patch, in the first place. g is the height over the tangent plane as far
// as the line allows, so that it is small where the line is nearly tangent.
void LineSearch::load_net() {
  const Vec3& d = ray_.direction;
  const PatchJet jet = jet_at(*patch_, at(cell_->u, 0.5), at(cell_->v, 0.5), 1);
  const Vec3 normal = unit(cross(jet.u, jet.v));
  const Vec3 height = normal - (dot(normal, d) / square_) * d;
  across_[1] = norm(height) > 1e-3 ? unit(height) : any_across(d);
  across_[0] = unit(cross(d, across_[1]));
  double* net = net_at(0);
  const int count = rows_ * columns_;
  double most = 0;
  const std::array<double, 2> shift{dot(across_[0], anchor_), dot(across_[1], anchor_)};
  for (int i = 0; i < count; ++i) {
    const Vec4& p = patch_->points.values()[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < 2; ++k) {
      const double value = dot(across_[k], Vec3{p[0], p[1], p[2]}) - p[3] * shift[k];
      net[static_cast<int>(k) * count + i] = value;
      most = std::max(most, std::abs(value));
    }
  }
  const int degree = std::max(rows_, columns_) - 1;
  const double numbers = cells_.scale() + max_norm(ray_.origin) + max_norm(anchor_);
  margin_ = 24 * kRoundoff * placed().largest_weight * numbers + halving_error(degree, 4) * most;
}

// From the patch to the cell.
void LineSearch::restrict_net() {
  const NetShape shape{rows_, columns_, 2};
  double* const net = net_at(0);
  double* const low = net_at(kPlaces);
  double* const high = net_at(kPlaces + 1);
  const auto keep = [&](const Interval& range, auto halve) {
    if (range.to < 1) {
      halve(shape, net, range.to, low, high);
      std::copy(low, low + net_size_, net);
    }
    if (range.from > 0) {
      halve(shape, net, range.from / range.to, low, high);
      std::copy(high, high + net_size_, net);
    }
  };
  keep(cell_->u, halve_bezier_u);
  keep(cell_->v, halve_bezier_v);
  net_scale_ = largest(range_of(net, net_size_));
}

void LineSearch::look_at(const Piece& piece, double* net, std::vector<RayHit>& hits, bool& open) {
  const int count = rows_ * columns_;
  const double* const g = net + count;
  const int degree = std::max(rows_, columns_) - 1;
  const double margin = margin_ + halving_error(degree, piece.depth) * net_scale_;
  const bool at_border =
      piece.u.from == 0 || piece.u.to == 1 || piece.v.from == 0 || piece.v.to == 1;
  const double reach = margin + (at_border ? placed().reach * placed().largest_weight : 0);
  const Range f_range = range_of(net, count), g_range = range_of(g, count);
  for (const Range& range : {f_range, g_range})
    if (range.low > reach || range.high < -reach) return;

  const Range slopes[2][2] = {{slope_u(net, rows_, columns_), slope_v(net, rows_, columns_)},
                              {slope_u(g, rows_, columns_), slope_v(g, rows_, columns_)}};
  const double m[2][2] = {{middle(slopes[0][0]), middle(slopes[0][1])},
                          {middle(slopes[1][0]), middle(slopes[1][1])}};
  const double per_area = 1 / (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
  const double c[2][2] = {{m[1][1] * per_area, -m[0][1] * per_area},
                          {-m[1][0] * per_area, m[0][0] * per_area}};
  Region region;
  region.u = piece.u;
  region.v = piece.v;
  const Vec2 size{length(piece.u), length(piece.v)};
  const Vec2 cell_size{length(cell_->u), length(cell_->v)};
  const Vec2 at_centre = value_at(net, 0.5, 0.5);
  Vec2 value;
  bool excluded = false, exact = std::isfinite(per_area);
  for (std::size_t i = 0; exact && i < 2; ++i) {
    const int k = static_cast<int>(i);
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t l = 0; l < 2; ++l)
        region.spread[i][j] += std::abs(c[i][l]) * (radius(slopes[l][j]) + 2 * degree * margin +
                                                    8 * kRoundoff * std::abs(m[l][j]));
    value[k] = c[i][0] * at_centre[0] + c[i][1] * at_centre[1];
    region.rounding[k] =
        2 * (std::abs(c[i][0]) + std::abs(c[i][1])) *
        (margin + (8 * degree + 8) * kRoundoff * std::max(largest(f_range), largest(g_range)));
    region.slack[k] = clamped_slack(placed().reach * cell_->dual_length[i] * cell_size[k] / size[k],
                                    region.rounding[k]);
    const double bound = 0.5 * (1 + region.spread[i][0] + region.spread[i][1]) +
                         region.rounding[k] + region.slack[k];
    excluded = excluded || std::abs(value[k]) > bound;
    exact = exact && region.rounding[k] < kExact;
  }
  if (excluded) return;
  if (exact && is_contraction(region.spread)) {
    const auto value_of = [&](const Vec2& local) {
      const Vec2 v =
          value_at(net, (local[0] - piece.u.from) / size[0], (local[1] - piece.v.from) / size[1]);
      return Vec2{c[0][0] * v[0] + c[0][1] * v[1], c[1][0] * v[0] + c[1][1] * v[1]};
    };
    const Vec2 start{at(piece.u, 0.5 - value[0]), at(piece.v, 0.5 - value[1])};
    if (settle(region, start, value_of, hits) != Verdict::Open) return;
  }
  const double steepest = std::max(std::max(largest(slopes[0][0]), largest(slopes[0][1])),
                                   std::max(largest(slopes[1][0]), largest(slopes[1][1])));
  if (extent(piece) <= tolerance_ || steepest <= 4 * degree * margin ||
      runs_along(piece, (largest(g_range) + margin) / placed().least_weight))
    add_contact(piece, Status::Tolerance, hits);
  else
    open = true;
}

bool LineSearch::split_along_u(const double* net) const {
  const double* const g = net + rows_ * columns_;
  return std::max(largest(slope_u(net, rows_, columns_)), largest(slope_u(g, rows_, columns_))) >=
         std::max(largest(slope_v(net, rows_, columns_)), largest(slope_v(g, rows_, columns_)));
}

// The piece is as good as flat, and the line lies in it: a stretch in common, not a point.
bool LineSearch::runs_along(const Piece& piece, double height) const {
  return height <= tolerance_ &&
         extent(piece) >=
             kTouchLength * std::sqrt(tolerance_ * (cell_->reach[0] + cell_->reach[1]));
}

double LineSearch::extent(const Piece& piece) const {
  return cell_->reach[0] * length(piece.u) / length(cell_->u) +
         cell_->reach[1] * length(piece.v) / length(cell_->v);
}

Vec2 LineSearch::value_at(const double* net, double s, double t) const {
  std::array<double, kMaxDegree + 1> in_u, in_v;
  bernstein(rows_ - 1, s, in_u.data());
  bernstein(columns_ - 1, t, in_v.data());
  Vec2 value;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < rows_; ++i) {
      double row = 0;
      for (int j = 0; j < columns_; ++j)
        row += in_v[static_cast<std::size_t>(j)] * net[(k * rows_ + i) * columns_ + j];
      value[k] += in_u[static_cast<std::size_t>(i)] * row;
    }
  return value;
}

// What the piece may have in common with the line.
void LineSearch::add_contact(const Piece& piece, Status status, std::vector<RayHit>& hits) const {
  const Stretch stretch = stretch_of(piece);
  const Region region{piece.u, piece.v, {}, {}, {}};
  Newton best = newton(region, {at(piece.u, 0.5), at(piece.v, 0.5)});
  if (!best.converged) {
    best.local = stretch.local;
    best.jet = jet_at(*patch_, best.local[0], best.local[1], 1);
    best.point = best.jet.point;
  }
  if (!add_hit(best, hits)) return;
  RayHit& hit = hits.back();
  hit.status = status;
  hit.first = std::min(hit.parameter, stretch.at.from);
  hit.last = std::max(hit.parameter, stretch.at.to);
  hit.grazing = hit.grazing || extent(piece) > tolerance_;
}

// The stretch of the line near a piece, and the parameters of its middle: by the piece's size, and
// by its tangent plane where there is one.
LineSearch::Stretch LineSearch::stretch_of(const Piece& piece) const {
  Stretch result;
  result.local = {at(piece.u, 0.5), at(piece.v, 0.5)};
  const PatchJet jet = jet_at(*patch_, result.local[0], result.local[1], 1);
  const double t = dot(jet.point - ray_.origin, ray_.direction) / square_;
  const double half = 0.5 * extent(piece) / std::sqrt(square_);
  result.at = {t - half, t + half};
  const Vec3 area = cross(jet.u, jet.v);
  const double per_square = 1 / dot(area, area);
  if (!std::isfinite(per_square) || extent(piece) <= tolerance_) return result;
  const std::array<Vec3, 2> dual{per_square * cross(jet.v, area), per_square * cross(area, jet.u)};
  const std::array<Interval, 2> sides{piece.u, piece.v};
  const auto local = [&](std::size_t i, double parameter) {
    return result.local[static_cast<int>(i)] + dot(dual[i], point_at(ray_, parameter) - jet.point);
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const double speed = dot(dual[i], ray_.direction), x = local(i, t);
    const double slack = tolerance_ * norm(dual[i]);
    const double a = (sides[i].from - slack - x) / speed + t;
    const double b = (sides[i].to + slack - x) / speed + t;
    const double from = std::max(result.at.from, std::min(a, b));
    const double to = std::min(result.at.to, std::max(a, b));
    if (from <= to) result.at = {from, to};
  }
  const double middle_parameter = at(result.at, 0.5);
  const Vec2 along{local(0, middle_parameter), local(1, middle_parameter)};
  for (int k = 0; k < 2; ++k) {
    const Interval& side = sides[static_cast<std::size_t>(k)];
    result.local[k] = std::clamp(along[k], side.from, side.to);
  }
  return result;
}

}  // namespace blossom
