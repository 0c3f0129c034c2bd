// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/arcs_along_borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/forms/evaluation.h"

namespace blossom {
namespace {

// Arcs leave their chords by less than this much of their extent or, if that is little, of a patch.
constexpr double kBesideChord = 0.5;
constexpr double kBesidePatch = 1e-6;
constexpr double kOnBorder = 2e-10;  // of the size: arcs so near a border run along it

class Borders {
 public:
  Borders(const SurfaceCells& a, const SurfaceCells& b, double size)
      : spans_{a.surface().patches.rows(), a.surface().patches.columns(),
               b.surface().patches.rows(), b.surface().patches.columns()},
        closed_{a.surface().closed_u, a.surface().closed_v, b.surface().closed_u,
                b.surface().closed_v},
        a_(a),
        b_(b),
        on_border_(kOnBorder * size) {}

  // Model units.
  double chord(const FoundArc& arc) const {
    const auto& patch = a_.surface().patches.values()[static_cast<std::size_t>(arc.patch_a)];
    return distance(point_at(patch, arc.arc.from[0], arc.arc.from[1]),
                    point_at(patch, arc.arc.to[0], arc.arc.to[1]));
  }

  // Whether others pass all along an arc that runs along a border of parameter i.
  bool cover(const std::vector<const FoundArc*>& others, const FoundArc& arc, std::size_t i) const {
    for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9})
      if (std::none_of(others.begin(), others.end(),
                       [&](const FoundArc* other) { return passes(*other, arc, i, part); }))
        return false;
    return true;
  }

 private:
  // Index of the span plus the local parameter.
  Point4 over_surfaces(const FoundArc& arc, const Point4& x) const {
    return {a_.span_u(arc.patch_a) + x[0], a_.span_v(arc.patch_a) + x[1],
            b_.span_u(arc.patch_b) + x[2], b_.span_v(arc.patch_b) + x[3]};
  }

  double gap(double x, double y, std::size_t i) const {
    const double plain = std::abs(x - y);
    return closed_[i] ? std::min(plain, std::abs(spans_[i] - plain)) : plain;
  }

  // How far a place is from the line x_i = `line`, model units.
  double off_line(const FoundArc& arc, const Point4& x, double line, std::size_t i) const {
    const SurfaceCells& of = i < 2 ? a_ : b_;
    const int patch = i < 2 ? arc.patch_a : arc.patch_b;
    const std::size_t u = i < 2 ? 0 : 2;
    const PatchJet jet =
        jet_at(of.surface().patches.values()[static_cast<std::size_t>(patch)], x[u], x[u + 1], 1);
    return gap(over_surfaces(arc, x)[i], line, i) * norm(i == u ? jet.u : jet.v);
  }

  // By the parameter along the border the place of the other arc at a part of the arc is known; the
  // rest tells arcs apart that pass the border in other sheets of the other surface.
  bool passes(const FoundArc& other, const FoundArc& arc, std::size_t i, double part) const {
    const Point4 from = over_surfaces(arc, arc.arc.from), to = over_surfaces(arc, arc.arc.to);
    Point4 low = over_surfaces(other, other.arc.from), high = over_surfaces(other, other.arc.to);
    const double line = std::round(from[i]);
    if (std::max(gap(low[i], line, i), gap(high[i], line, i)) > kBesidePatch ||
        std::max(off_line(other, other.arc.from, line, i), off_line(other, other.arc.to, line, i)) >
            on_border_)
      return false;
    const std::size_t along = i ^ 1;
    if (low[along] > high[along]) std::swap(low, high);
    const double at = from[along] + part * (to[along] - from[along]);
    const double width = high[along] - low[along];
    if (!(width > 0) || at < low[along] - kSamePoint || at > high[along] + kSamePoint) return false;
    const double share = (at - low[along]) / width;
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = from[k] + part * (to[k] - from[k]);
      const double y = low[k] + share * (high[k] - low[k]);
      const double extent = std::abs(to[k] - from[k]) + std::abs(high[k] - low[k]);
      if (gap(x, y, k) > kBesideChord * extent + kBesidePatch) return false;
    }
    return true;
  }

  std::array<int, 4> spans_;
  std::array<bool, 4> closed_;
  const SurfaceCells& a_;
  const SurfaceCells& b_;
  const double on_border_;
};

}  // namespace

void drop_repeated_arcs(PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b,
                        double size, double shortest) {
  const auto shares = [](const FoundArc& arc) { return arc.arc.shared_border >= 0; };
  if (std::none_of(found.arcs.begin(), found.arcs.end(), shares)) return;
  const Borders borders(a, b, size);
  std::vector<const FoundArc*> kept;
  for (const FoundArc& arc : found.arcs)
    if (!shares(arc)) kept.push_back(&arc);
  std::vector<char> dropped(found.arcs.size());
  for (const bool upper : {false, true})
    for (std::size_t n = 0; n < found.arcs.size(); ++n) {
      const FoundArc& arc = found.arcs[n];
      if (!shares(arc) || arc.arc.upper != upper) continue;
      dropped[n] = (upper && borders.chord(arc) <= shortest) ||
                   borders.cover(kept, arc, static_cast<std::size_t>(arc.arc.shared_border));
      if (dropped[n] == 0) kept.push_back(&arc);
    }
  std::vector<FoundArc> left;
  for (std::size_t n = 0; n < found.arcs.size(); ++n)
    if (dropped[n] == 0) left.push_back(found.arcs[n]);
  found.arcs = std::move(left);
}

}  // namespace blossom
