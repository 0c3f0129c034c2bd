// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/two_triangle_vertices.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "core/blossom/triangle_composition.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/math/index.h"
#include "core/subdivision/curve_subdivision.h"
#include "core/subdivision/triangle_subdivision.h"

namespace blossom {
namespace {

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

  // A side inside of a face between two triangles; whether that is possible. Halves of a triangle
  // at a pole would have two sides with the same ends again; one on both sides has no halves.
  bool divide_side(int side) {
    const std::vector<Tip>& beside = along_[index(side)];
    const auto is_whole = [this](const Tip& at) {
      const WatertightPiece& piece = pieces_.pieces[at.piece];
      return piece.sides.size() == 3 && std::ranges::none_of(piece.sides, [this](int k) {
               return pieces_.sides[index(k)].curve.points.empty();
             });
    };
    return beside.size() == 2 && beside[0].piece != beside[1].piece &&
           std::ranges::all_of(beside, is_whole) && divide_across(beside[0], beside[1], side);
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
    return divide_across({tip.piece, opposite}, other, side);
  }

  // Two triangles across the side that both walk from the given corners.
  bool divide_across(const Tip one, const Tip other, int side) {
    if (std::max(degree(one.piece), degree(other.piece)) > kMaxDegree) return false;
    const int middle = static_cast<int>(pieces_.vertices.size());
    pieces_.vertices.push_back(point_at(pieces_.sides[index(side)].curve, 0.5));
    const int second = halve_side(side, middle);
    at_.emplace_back();
    halve(one, middle, side, second);
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

// Chords over edges that two faces have in common.
class FacingChords {
 public:
  explicit FacingChords(const WatertightPieces& pieces) : pieces_(pieces) {
    find_borders();
    for (const auto& [faces, neighbours] : borders_) add_chains(faces, neighbours);
    add_chords();
  }

  // Those to divide, increasing.
  std::set<int> found() const {
    std::set<int> result;
    for (const Chain& chain : chains_) {
      const std::vector<Chord> first = over(chain, 0), second = over(chain, 1);
      const std::vector<Chord>& more = total_bow(first) > total_bow(second) ? first : second;
      for (const Chord& chord : more) result.insert(chord.side);
    }
    return result;
  }

 private:
  using Faces = std::pair<int, int>;
  using Neighbours = std::map<int, std::vector<int>>;  // of vertices, along common edges

  struct Chord {
    int side = 0;
    std::size_t from = 0;  // places in the chain, increasing
    std::size_t to = 0;
    double bow = 0;  // how far its middle is from that of its ends
  };

  // Vertices one after the other along edges of the same two faces.
  struct Chain {
    Faces faces;
    std::size_t size = 0;
    bool closed = false;
    std::array<std::vector<Chord>, 2> chords = {};  // of each face
  };

  struct Place {
    std::size_t chain = 0;
    std::size_t at = 0;
  };

  // Edges within one face, as its seam, are left out.
  void find_borders() {
    std::vector<std::vector<int>> faces(pieces_.sides.size());
    for (const WatertightPiece& piece : pieces_.pieces)
      for (const int side : piece.sides) faces[index(side)].push_back(piece.face);
    for (std::size_t s = 0; s < faces.size(); ++s) {
      const WatertightSide& side = pieces_.sides[s];
      if (side.edge < 0 || faces[s].size() != 2 || faces[s][0] == faces[s][1]) continue;
      if (side.from == side.to) continue;
      Neighbours& neighbours = borders_[std::minmax(faces[s][0], faces[s][1])];
      neighbours[side.from].push_back(side.to);
      neighbours[side.to].push_back(side.from);
    }
  }

  // Chains end where edges do or more than two meet; what is left then is closed.
  void add_chains(const Faces& faces, const Neighbours& neighbours) {
    std::set<Faces> walked;  // steps between vertices
    for (const bool closed : {false, true})
      for (const auto& [vertex, next] : neighbours)
        for (const int towards : next)
          if ((closed || next.size() != 2) && !walked.contains(std::minmax(vertex, towards)))
            walk(faces, neighbours, vertex, towards, walked);
  }

  void walk(const Faces& faces, const Neighbours& neighbours, int from, int towards,
            std::set<Faces>& walked) {
    const int start = from;
    Chain chain{faces};
    places_[start].push_back({chains_.size(), chain.size++});
    while (walked.insert(std::minmax(from, towards)).second) {
      if (towards == start) {
        chain.closed = true;
        break;
      }
      places_[towards].push_back({chains_.size(), chain.size++});
      const std::vector<int>& next = neighbours.at(towards);
      if (next.size() != 2) break;
      from = std::exchange(towards, next[0] == from ? next[1] : next[0]);
    }
    chains_.push_back(std::move(chain));
  }

  void add_chords() {
    std::vector<bool> added(pieces_.sides.size(), false);
    for (const WatertightPiece& piece : pieces_.pieces)
      for (const int side : piece.sides) {
        if (added[index(side)] || pieces_.sides[index(side)].edge >= 0) continue;
        added[index(side)] = true;
        add_chord(piece.face, side);
      }
  }

  void add_chord(int face, int number) {
    const WatertightSide& side = pieces_.sides[index(number)];
    const auto from = places_.find(side.from), to = places_.find(side.to);
    if (from == places_.end() || to == places_.end() || side.curve.points.empty()) return;
    const double bow = distance(point_at(side.curve, 0.5),
                                0.5 * (side.curve.points.front() + side.curve.points.back()));
    for (const Place& a : from->second)
      for (const Place& b : to->second) {
        Chain& chain = chains_[a.chain];
        if (a.chain != b.chain || (chain.faces.first != face && chain.faces.second != face))
          continue;
        chain.chords[chain.faces.first == face ? 0 : 1].push_back(
            {number, std::min(a.at, b.at), std::max(a.at, b.at), bow});
      }
  }

  // Chords of one face over stretches that some of the other one are over, too. Round a closed
  // chain they may be over either part of it.
  static std::vector<Chord> over(const Chain& chain, std::size_t face) {
    const std::vector<Chord>& others = chain.chords[1 - face];
    std::vector<int> count(chain.size + 1, 0);  // of others that begin less those that end
    for (const Chord& other : others) {
      ++count[other.from];
      --count[other.to];
    }
    std::vector<std::size_t> covered(chain.size + 1, 0);  // steps before each place
    int open = 0;
    for (std::size_t k = 0; k < chain.size; ++k) {
      open += count[k];
      covered[k + 1] = covered[k] + (open > 0 ? 1 : 0);
    }
    std::vector<Chord> result;
    for (const Chord& chord : chain.chords[face])
      if (chain.closed ? !others.empty() : covered[chord.to] > covered[chord.from])
        result.push_back(chord);
    return result;
  }

  static double total_bow(const std::vector<Chord>& chords) {
    double total = 0;
    for (const Chord& chord : chords) total += chord.bow;
    return total;
  }

  const WatertightPieces& pieces_;
  std::map<Faces, Neighbours> borders_;
  std::vector<Chain> chains_;
  std::map<int, std::vector<Place>> places_;  // of vertices
};

}  // namespace

void divide_two_triangle_vertices(WatertightPieces& pieces) { Divider(pieces).divide_all(); }

void divide_facing_chords(WatertightPieces& pieces) {
  const std::set<int> chords = FacingChords(pieces).found();
  Divider divider(pieces);
  for (const int side : chords) divider.divide_side(side);
}

}  // namespace blossom
