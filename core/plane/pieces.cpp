// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/pieces.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "core/base/disjoint_sets.h"

namespace blossom {
namespace {

// Which arcs hang together, over common vertices.
class Components {
 public:
  explicit Components(std::span<const ChartArc> arcs) {
    int count = 0;
    for (const ChartArc& arc : arcs) count = std::max({count, arc.from + 1, arc.to + 1});
    sets_ = DisjointSets(static_cast<std::size_t>(count));
    for (const ChartArc& arc : arcs) sets_.join(index(arc.from), index(arc.to));
  }
  std::size_t of(const ChartArc& arc) { return sets_.find(index(arc.from)); }

 private:
  static std::size_t index(int vertex) { return static_cast<std::size_t>(vertex); }
  DisjointSets sets_;
};

bool is_inside(std::span<const ChartArc> arcs, const Cycle& cycle) {
  return std::none_of(cycle.begin(), cycle.end(), [&](const HalfEdge& edge) {
    return edge.reversed && arcs[static_cast<std::size_t>(edge.arc)].border;
  });
}

// The cycle in parts that come to no vertex twice: where a hole touches the outer loop or another
// hole in a vertex, the walk round the piece goes through it once for each of them.
std::vector<Cycle> simple_parts(std::span<const ChartArc> arcs, const Cycle& cycle) {
  const auto vertex = [&](const HalfEdge& edge, bool start) {
    const ChartArc& arc = arcs[static_cast<std::size_t>(edge.arc)];
    return edge.reversed != start ? arc.from : arc.to;
  };
  std::vector<Cycle> parts;
  Cycle open;
  for (const HalfEdge& edge : cycle) {
    open.push_back(edge);
    const int end = vertex(edge, false);
    const auto last = std::find_if(open.rbegin(), open.rend(), [&](const HalfEdge& known) {
      return vertex(known, true) == end;
    });
    if (last == open.rend()) continue;
    parts.emplace_back(last.base() - 1, open.end());
    open.erase(last.base() - 1, open.end());
  }
  return parts;
}

struct Outer {
  std::size_t piece = 0;
  std::size_t component = 0;
  double area = 0;
  std::size_t touching = 0;  // its first holes, which touch its outer loop or each other
};

constexpr std::size_t kNoComponent = static_cast<std::size_t>(-1);

const ChartArc& first_arc(std::span<const ChartArc> arcs, const Cycle& cycle) {
  return arcs[static_cast<std::size_t>(cycle.front().arc)];
}

// Of the parts one goes round the others.
ChartPiece piece_of(std::span<const ChartArc> arcs, std::vector<Cycle> parts) {
  const auto outer = std::max_element(
      parts.begin(), parts.end(),
      [&](const Cycle& a, const Cycle& b) { return signed_area(arcs, a) < signed_area(arcs, b); });
  ChartPiece piece{std::move(*outer), {}, {}};
  parts.erase(outer);
  piece.holes = std::move(parts);
  return piece;
}

// Whether a piece goes round a point, and no loop in it that touches it does.
bool goes_round(std::span<const ChartArc> arcs, const ChartPiece& piece, std::size_t touching,
                const Vec2& point) {
  const auto holds = [&](const Cycle& loop) { return encloses(arcs, loop, point); };
  return holds(piece.outer) &&
         std::none_of(piece.holes.begin(),
                      piece.holes.begin() + static_cast<std::ptrdiff_t>(touching), holds);
}

// The smallest piece round an arc, but none that a part of the arrangement bounds.
ChartPiece* around(std::span<const ChartArc> arcs, const std::vector<Outer>& by_area,
                   const ChartArc& arc, std::size_t but, std::vector<ChartPiece>& pieces) {
  const Vec2 inside = middle_of(arc.path);
  const auto found = std::find_if(by_area.begin(), by_area.end(), [&](const Outer& outer) {
    return outer.component != but && goes_round(arcs, pieces[outer.piece], outer.touching, inside);
  });
  return found == by_area.end() ? nullptr : &pieces[found->piece];
}

}  // namespace

ChartPieces pieces(std::span<const ChartArc> arcs, double tolerance) {
  Cycles all = cycles(arcs, tolerance);
  std::vector<ChartArc> kept(arcs.begin(), arcs.end());
  for (const int arc : all.dangling)  // a cut that is left out connects nothing
    kept[static_cast<std::size_t>(arc)].to = kept[static_cast<std::size_t>(arc)].from;
  Components components(kept);

  ChartPieces result;
  result.dangling = std::move(all.dangling);
  std::vector<Outer> outers;
  std::vector<Cycle> holes;
  for (const Cycle& cycle : all.cycles) {
    if (!is_inside(arcs, cycle)) continue;
    const double area = signed_area(arcs, cycle);
    std::vector<Cycle> parts = simple_parts(arcs, cycle);
    if (area <= 0) {
      std::move(parts.begin(), parts.end(), std::back_inserter(holes));
      continue;
    }
    outers.push_back(
        {result.pieces.size(), components.of(first_arc(arcs, cycle)), area, parts.size() - 1});
    result.pieces.push_back(piece_of(arcs, std::move(parts)));
  }
  std::sort(outers.begin(), outers.end(),
            [](const Outer& a, const Outer& b) { return a.area < b.area; });
  for (Cycle& hole : holes) {
    const ChartArc& arc = first_arc(arcs, hole);
    ChartPiece* const piece = around(arcs, outers, arc, components.of(arc), result.pieces);
    if (piece == nullptr)
      result.consistent = false;
    else
      piece->holes.push_back(std::move(hole));
  }
  for (const int index : result.dangling) {
    const ChartArc& arc = arcs[static_cast<std::size_t>(index)];
    if (ChartPiece* const piece = around(arcs, outers, arc, kNoComponent, result.pieces))
      piece->inner.push_back(index);
  }
  return result;
}

}  // namespace blossom
