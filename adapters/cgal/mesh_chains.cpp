// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/cgal/mesh_chains.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/index.h"

namespace blossom::cgal {
namespace {

// The pieces at each node: those of node n are from starts[n] to starts[n + 1].
struct PiecesAtNodes {
  explicit PiecesAtNodes(const MeshNodes& nodes) : starts(nodes.keys.size() + 1) {
    for (const auto& piece : nodes.pieces)
      for (const int node : piece) ++starts[index(node) + 1];
    for (std::size_t n = 1; n < starts.size(); ++n) starts[n] += starts[n - 1];
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    of.resize(2 * nodes.pieces.size());
    for (std::size_t p = 0; p < nodes.pieces.size(); ++p)
      for (const int node : nodes.pieces[p]) of[next[index(node)]++] = p;
  }
  std::size_t count(int node) const { return starts[index(node) + 1] - starts[index(node)]; }

  std::vector<std::size_t> starts, of;
};

class Chaining {
 public:
  Chaining(const MeshNodes& nodes, const std::vector<Vec3>& places, MeshMeeting& found)
      : nodes_(nodes), places_(places), at_(nodes), used_(nodes.pieces.size()), found_(found) {}

  void run() {
    for (std::size_t p = 0; p < used_.size(); ++p)  // open ones first, from their ends
      for (const int node : nodes_.pieces[p])
        if (!used_[p] && at_.count(node) != 2) follow(p, node);
    for (std::size_t p = 0; p < used_.size(); ++p)
      if (!used_[p]) follow(p, nodes_.pieces[p][0]);
  }

 private:
  void follow(std::size_t piece, int first) {
    std::vector<Vec3> points{places_[index(first)]};
    int node = first;
    while (true) {
      used_[piece] = true;
      const auto& ends = nodes_.pieces[piece];
      node = ends[0] == node ? ends[1] : ends[0];
      if (places_[index(node)] != points.back()) points.push_back(places_[index(node)]);
      if (node == first || at_.count(node) != 2) break;
      const std::size_t* const both = &at_.of[at_.starts[index(node)]];
      piece = both[0] == piece ? both[1] : both[0];
      if (used_[piece]) break;
    }
    add(std::move(points), node == first && at_.count(first) == 2);
  }

  void add(std::vector<Vec3> points, bool closed) {
    if (points.size() < 2) {
      found_.points.push_back(points.front());
      return;
    }
    MeshCurve curve{.points = std::move(points), .closed = closed};
    for (std::size_t k = 1; k < curve.points.size(); ++k)
      curve.length += norm(curve.points[k] - curve.points[k - 1]);
    found_.curves.push_back(std::move(curve));
  }

  const MeshNodes& nodes_;
  const std::vector<Vec3>& places_;
  PiecesAtNodes at_;
  std::vector<char> used_;
  MeshMeeting& found_;
};

// Curves by their sums, which do not depend on the order or on where corners are added.
struct Moments {
  explicit Moments(const MeshMeeting& of) {
    for (const MeshCurve& curve : of.curves) {
      ++(curve.closed ? closed : open);
      for (std::size_t k = 1; k < curve.points.size(); ++k)
        add_side(curve.points[k - 1], curve.points[k]);
    }
  }
  void add_side(const Vec3& p, const Vec3& q) {
    const double side = norm(q - p);
    length += side;
    first += side * 0.5 * (p + q);
    second += side / 3 * (dot(p, p) + dot(p, q) + dot(q, q));
    reach = std::max({reach, norm(p), norm(q)});
  }

  int closed = 0, open = 0;
  double length = 0, second = 0, reach = 0;  // of x^2 along them; the farthest point's distance
  Vec3 first{};                              // of x along them
};

}  // namespace

MeshNodes numbered(const std::vector<MeshPiece>& pieces) {
  MeshNodes nodes;
  for (const MeshPiece& piece : pieces) nodes.keys.insert(nodes.keys.end(), {piece.from, piece.to});
  std::ranges::sort(nodes.keys);
  nodes.keys.erase(std::unique(nodes.keys.begin(), nodes.keys.end()), nodes.keys.end());
  const auto place = [&](const NodeKey& key) {
    return static_cast<int>(std::ranges::lower_bound(nodes.keys, key) - nodes.keys.begin());
  };
  for (const MeshPiece& piece : pieces)
    nodes.pieces.push_back({place(piece.from), place(piece.to)});
  return nodes;
}

void chain(const MeshNodes& nodes, const std::vector<Vec3>& places, MeshMeeting& found) {
  Chaining(nodes, places, found).run();
}

bool have_equal_curves(const MeshMeeting& a, const MeshMeeting& b) {
  constexpr double kSame = 1e-9;  // relative: sums of roundings
  const Moments of_a(a), of_b(b);
  const double length = std::max(of_a.length, of_b.length),
               reach = std::max(of_a.reach, of_b.reach);
  return of_a.closed == of_b.closed && of_a.open == of_b.open &&
         std::abs(of_a.length - of_b.length) <= kSame * length &&
         max_norm(of_a.first - of_b.first) <= kSame * length * reach &&
         std::abs(of_a.second - of_b.second) <= kSame * length * reach * reach;
}

}  // namespace blossom::cgal
