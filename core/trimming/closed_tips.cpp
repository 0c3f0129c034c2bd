// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/trimming/closed_tips.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "core/blossom/triangle_composition.h"
#include "core/forms/de_casteljau.h"
#include "core/subdivision/curve_subdivision.h"
#include "core/subdivision/triangle_subdivision.h"

namespace blossom {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Barycentric coordinates of the corners of a triangle within itself.
constexpr std::array<Vec2, 3> kCorners{Vec2{1, 0}, Vec2{0, 1}, Vec2{0, 0}};

struct Tip {
  std::size_t piece = 0;
  std::size_t corner = 0;
};

class Divider {
 public:
  explicit Divider(WatertightPieces& pieces)
      : pieces_(pieces), at_(pieces.vertices.size()), along_(pieces.sides.size()) {
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) add(p);
  }

  // Dividing only adds tips to vertices, and what cannot be divided stays so: one pass will do.
  void divide_all() {
    for (std::size_t vertex = 0; vertex < at_.size(); ++vertex)
      if (is_closed(vertex) && !divide(at_[vertex][0])) divide(at_[vertex][1]);
  }

 private:
  bool on_edge(int side) const { return pieces_.sides[index(side)].edge >= 0; }

  int degree(std::size_t piece) const {
    return std::get<BezierTriangle>(pieces_.pieces[piece].form).degree;
  }

  void add(std::size_t p) {
    const WatertightPiece& piece = pieces_.pieces[p];
    for (std::size_t k = 0; k < piece.vertices.size(); ++k)
      at_[index(piece.vertices[k])].push_back({p, k});
    for (std::size_t k = 0; k < piece.sides.size(); ++k)
      along_[index(piece.sides[k])].push_back({p, k});
  }

  void remove(std::size_t p) {
    const auto is_own = [p](const Tip& tip) { return tip.piece == p; };
    for (const int vertex : pieces_.pieces[p].vertices) std::erase_if(at_[index(vertex)], is_own);
    for (const int side : pieces_.pieces[p].sides) std::erase_if(along_[index(side)], is_own);
  }

  // Whether only two pieces have the vertex, both between sides on edges.
  bool is_closed(std::size_t vertex) const {
    const std::vector<Tip>& tips = at_[vertex];
    return tips.size() == 2 && is_ear(tips[0]) && is_ear(tips[1]);
  }

  bool is_ear(const Tip& tip) const {
    const WatertightPiece& piece = pieces_.pieces[tip.piece];
    return piece.sides.size() == 3 && on_edge(piece.sides[tip.corner]) &&
           on_edge(piece.sides[(tip.corner + 2) % 3]);
  }

  // The corner of another triangle from which it walks a side; none if no triangle does.
  Tip behind(int side, std::size_t piece) const {
    for (const Tip& of : along_[index(side)])
      if (of.piece != piece && pieces_.pieces[of.piece].sides.size() == 3) return of;
    return {piece, 0};
  }

  // Whether that is possible.
  bool divide(const Tip tip) {
    const std::size_t opposite = (tip.corner + 1) % 3;
    const int side = pieces_.pieces[tip.piece].sides[opposite];
    const Tip other = behind(side, tip.piece);
    if (on_edge(side) || other.piece == tip.piece) return false;
    if (std::max(degree(tip.piece), degree(other.piece)) > kMaxDegree) return false;
    const int middle = static_cast<int>(pieces_.vertices.size());
    pieces_.vertices.push_back(point_at(pieces_.sides[index(side)].curve, 0.5));
    const int second = halve_side(side, middle);
    at_.emplace_back();
    halve({tip.piece, opposite}, middle, side, second);
    halve(other, middle, side, second);
    return true;
  }

  // The side keeps its first half; the number of the second is returned.
  int halve_side(int number, int middle) {
    const int second = static_cast<int>(pieces_.sides.size());
    const BezierCurve whole = pieces_.sides[index(number)].curve;
    const int last = std::exchange(pieces_.sides[index(number)].to, middle);
    pieces_.sides[index(number)].curve = sub_curve(whole, {0, 0.5});
    pieces_.sides.push_back({-1, middle, last, sub_curve(whole, {0.5, 1})});
    return second;
  }

  // Halves a triangle across the side that begins at its corner k: the piece becomes the half
  // before the middle of that side, a new one the half after it.
  void halve(const Tip& at, int middle, int first, int second) {
    const std::array<std::size_t, 3> k{at.corner, (at.corner + 1) % 3, (at.corner + 2) % 3};
    const WatertightPiece whole = pieces_.pieces[at.piece];
    remove(at.piece);
    const auto& triangle = std::get<BezierTriangle>(whole.form);
    const Vec2 half = 0.5 * (kCorners[k[0]] + kCorners[k[1]]);
    const bool forwards = pieces_.sides[index(first)].from == whole.vertices[k[0]];
    const int across = static_cast<int>(pieces_.sides.size());

    WatertightPiece &before = pieces_.pieces[at.piece], after = whole;
    before.form = sub_triangle(triangle, {kCorners[k[0]], half, kCorners[k[2]]});
    before.vertices = {whole.vertices[k[0]], middle, whole.vertices[k[2]]};
    before.sides = {forwards ? first : second, across, whole.sides[k[2]]};
    after.form = sub_triangle(triangle, {half, kCorners[k[1]], kCorners[k[2]]});
    after.vertices = {middle, whole.vertices[k[1]], whole.vertices[k[2]]};
    after.sides = {forwards ? second : first, whole.sides[k[1]], across};
    pieces_.sides.push_back(
        {-1, middle, whole.vertices[k[2]], side_of(std::get<BezierTriangle>(before.form), 1, 2)});
    pieces_.pieces.push_back(std::move(after));
    along_.resize(pieces_.sides.size());
    add(at.piece);
    add(pieces_.pieces.size() - 1);
  }

  WatertightPieces& pieces_;
  std::vector<std::vector<Tip>> at_;     // by vertex: pieces that have it
  std::vector<std::vector<Tip>> along_;  // by side: pieces that walk it
};

}  // namespace

void divide_closed_tips(WatertightPieces& pieces) { Divider(pieces).divide_all(); }

}  // namespace blossom
