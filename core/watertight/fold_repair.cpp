// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/fold_repair.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <variant>

#include "core/blossom/curve_blossom.h"
#include "core/blossom/triangle_composition.h"
#include "core/forms/algebra/degree.h"
#include "core/math/index.h"
#include "core/watertight/border_fitting.h"
#include "core/watertight/equal_degrees.h"
#include "core/watertight/orientation_check.h"
#include "core/watertight/piece_sides.h"

namespace blossom {
namespace {

constexpr int kMaxPasses = 4;
constexpr std::size_t kAskEvery = 64;  // pieces

template <class Form>
int degree_of(const Form& form) {
  if constexpr (requires { form.degree(); })
    return form.degree();
  else
    return form.degree;
}

// Of two curves or two triangles.
template <class Form>
Form sum(const Form& a, const Form& b) {
  const int degree = std::max(degree_of(a), degree_of(b));
  Form result = elevated(a, degree);
  const Form other = elevated(b, degree);
  for (std::size_t k = 0; k < result.points.size(); ++k) result.points[k] += other.points[k];
  return result;
}

// The curve at a parameter that is linear over a triangle, given at its corners.
BezierTriangle over_triangle(const BezierCurve& curve, const std::array<double, 3>& places) {
  const int n = curve.degree();
  BezierTriangle result{n, {}};
  for (int nu = 0; nu <= n; ++nu)
    for (int mu = 0; nu + mu <= n; ++mu) {
      std::vector<double> arguments(index(nu), places[0]);
      arguments.insert(arguments.end(), index(mu), places[1]);
      arguments.insert(arguments.end(), index(n - nu - mu), places[2]);
      result.points.push_back(blossom_at(curve, arguments));
    }
  return result;
}

// Changes pieces before their sides are moved, by what these sides were moved without that.
class Carrier {
 public:
  explicit Carrier(WatertightPieces& pieces) : pieces_(pieces), beside_(pieces.sides.size()) {
    on_edge_.assign(pieces.vertices.size(), false);
    for (const WatertightSide& side : pieces.sides)
      if (side.edge >= 0) on_edge_[index(side.from)] = on_edge_[index(side.to)] = true;
    for (std::size_t p = 0; p < pieces.pieces.size(); ++p)
      for (const int side : pieces.pieces[p].sides) beside_[index(side)].push_back(p);
  }

  // Carries those of the moved pieces that may turn; whether any could be.
  bool carry(const WatertightPieces& moved) {
    moved_ = &moved;
    const std::set<int> before = carried_;
    bool changed = false;
    for (const int piece : moved.turned) changed = carry(index(piece), before) || changed;
    return changed;
  }

 private:
  // As one or two of its sides go that are on edges or were carried before.
  bool carry(std::size_t piece, const std::set<int>& before) {
    if (pieces_.pieces[piece].sides.size() != 3) return false;
    std::vector<std::size_t> with;
    for (std::size_t k = 0; k < 3; ++k) {
      const int side = pieces_.pieces[piece].sides[k];
      if (pieces_.sides[index(side)].edge >= 0 || before.contains(side)) with.push_back(k);
    }
    if (with.empty() || with.size() == 3) return false;
    const BezierTriangle way =
        with.size() == 1 ? way_with(piece, with[0]) : way_between(piece, with[0], with[1]);
    if (std::ranges::all_of(way.points, [](const Vec3& p) { return p == Vec3{}; })) return false;
    move(piece, way);
    for (std::size_t k = 0; k < 3; ++k)
      carry_side(piece, k, side_of(way, static_cast<int>(k), static_cast<int>((k + 1) % 3)));
    return true;
  }

  Vec3 corner(std::size_t piece, std::size_t k) const {
    return pieces_.vertices[index(pieces_.pieces[piece].vertices[k % 3])];
  }

  // How the piece's side k was moved, from vertex k on.
  BezierCurve way_of(std::size_t piece, std::size_t k) const {
    BezierCurve from = side_curve(pieces_.pieces[piece], static_cast<int>(k));
    for (Vec3& p : from.points) p = -p;
    return sum(side_curve(moved_->pieces[piece], static_cast<int>(k)), from);
  }

  // As side k goes: the corner across as the place there that divides it as the other two sides
  // do.
  BezierTriangle way_with(std::size_t piece, std::size_t k) const {
    const std::size_t to = (k + 1) % 3, across = (k + 2) % 3;
    const double first = distance(corner(piece, k), corner(piece, across));
    const double second = distance(corner(piece, across), corner(piece, to));
    std::array<double, 3> places;
    places[k] = 0;
    places[to] = 1;
    places[across] = first + second > 0 ? first / (first + second) : 0.5;
    return over_triangle(way_of(piece, k), places);
  }

  // As two sides go, which have a corner in common: the sum of their ways, each at its end along
  // the other, less that of the corner.
  BezierTriangle way_between(std::size_t piece, std::size_t k, std::size_t l) const {
    if ((l + 1) % 3 == k) std::swap(k, l);
    const std::size_t from = k, tip = l, to = (l + 1) % 3;
    std::array<double, 3> in_first, in_second;
    in_first[from] = in_second[from] = in_second[tip] = 0;
    in_first[tip] = in_first[to] = in_second[to] = 1;
    const BezierCurve first = way_of(piece, k), second = way_of(piece, l);
    BezierTriangle way = sum(over_triangle(first, in_first), over_triangle(second, in_second));
    for (Vec3& p : way.points) p -= second.points.front();
    return way;
  }

  void move(std::size_t piece, const BezierTriangle& way) {
    auto& triangle = std::get<BezierTriangle>(pieces_.pieces[piece].form);
    triangle = sum(triangle, way);
    double longest = 0;
    for (const Vec3& p : way.points) longest = std::max(longest, norm(p));
    pieces_.pieces[piece].moved += longest;
  }

  // One inside of the face, and its corners if they are; other corners stay.
  void carry_side(std::size_t piece, std::size_t k, BezierCurve way) {
    const int number = pieces_.pieces[piece].sides[k];
    WatertightSide& side = pieces_.sides[index(number)];
    if (side.edge >= 0 || side.curve.points.empty() || !carried_.insert(number).second) return;
    if (!moved_->pieces[piece].along[k]) std::ranges::reverse(way.points);
    carry_vertex(side.from, way.points.front());
    carry_vertex(side.to, way.points.back());
    way.points.front() = way.points.back() = Vec3{};
    const int most = most_degree(number);
    if (way.degree() > most) way = reduced(way, most).form;
    side.curve = sum(side.curve, way);
    for (const std::size_t beside : beside_[index(number)])
      if (auto* triangle = std::get_if<BezierTriangle>(&pieces_.pieces[beside].form))
        if (triangle->degree < side.curve.degree())
          *triangle = elevated(*triangle, side.curve.degree());
  }

  void carry_vertex(int vertex, const Vec3& way) {
    if (!on_edge_[index(vertex)] && carried_vertices_.insert(vertex).second)
      pieces_.vertices[index(vertex)] += way;
  }

  // Of a side's curve, which a rectangle beside it takes.
  int most_degree(int side) const {
    int most = kMaxDegree;
    for (const std::size_t beside : beside_[index(side)])
      if (std::holds_alternative<BezierPatch>(pieces_.pieces[beside].form))
        most = std::min(most, pieces_.sides[index(side)].curve.degree());
    return most;
  }

  WatertightPieces& pieces_;
  const WatertightPieces* moved_ = nullptr;
  std::vector<std::vector<std::size_t>> beside_;  // by side: pieces that walk it
  std::vector<bool> on_edge_;                     // by vertex
  std::set<int> carried_, carried_vertices_;
};

std::vector<int> turned_pieces(const WatertightPieces& unmoved, const WatertightPieces& moved,
                               double within, const std::function<void()>& ask) {
  std::vector<int> turned;
  const auto turns = [&](const WatertightPiece& given, const WatertightPiece& made) {
    if (const auto* triangle = std::get_if<BezierTriangle>(&given.form))
      return !turns_nowhere(*triangle, std::get<BezierTriangle>(made.form), within);
    const auto &patch = std::get<BezierPatch>(given.form), &now = std::get<BezierPatch>(made.form);
    return patch != now && !turns_nowhere(patch, now, within);
  };
  for (std::size_t p = 0; p < moved.pieces.size(); ++p) {
    if (p % kAskEvery == 0) ask();
    if (turns(unmoved.pieces[p], moved.pieces[p])) turned.push_back(static_cast<int>(p));
  }
  return turned;
}

}  // namespace

void spare_turns(WatertightPieces unmoved, WatertightPieces& moved, double within,
                 const std::function<void()>& ask) {
  moved.turned = turned_pieces(unmoved, moved, within, ask);
  if (moved.turned.empty()) return;
  Carrier carrier(unmoved);
  WatertightPieces last = moved;
  for (int pass = 0; pass < kMaxPasses && carrier.carry(last); ++pass) {
    last = unmoved;
    raise_degrees(last);
    move_sides(last);
    last.turned = turned_pieces(unmoved, last, within, ask);
    if (last.turned.size() < moved.turned.size()) moved = last;
  }
}

}  // namespace blossom
