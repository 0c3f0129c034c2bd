// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/branches/arcs_along_borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "core/forms/evaluation.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/pairs/exact_borders.h"
#include "core/surfaces/pairs/regular_contact.h"

namespace blossom {
namespace {

// Arcs leave their chords by less than this much of their extent or, if that is little, of a patch.
constexpr double kBesideChord = 0.5;
constexpr double kBesidePatch = 1e-6;
constexpr double kOnBorder = 2e-10;        // of the size: arcs so near a border run along it
constexpr double kNoise = 2 * kSamePoint;  // of ends
constexpr long kBuckets = 100'000;         // of a patch: lines in one are looked up together
// An arc is repeated if others have so much of it. What they leave out is a contact's on their
// side, or a branch ends there, which is told.
constexpr double kLargePart = 0.5;
// An arc along a border is no shorter than this part of a patch, and its ends are as near the
// border as this, of the arc's length and of a patch: one that touches the border there is not.
constexpr double kShortestAlong = 1e-4;
constexpr double kBesideBorder = 1e-6;
constexpr double kAtBorder = 1e-9;
constexpr double kFootReach = 0.5;  // of a patch

// Parameters over whole surfaces: index of the span plus the local parameter.
struct Chord {
  const FoundArc* arc;
  Point4 low, high;  // ends, by the parameter along the line
};

class ArcsOnLines {
 public:
  ArcsOnLines(const SurfaceCells& a, const SurfaceCells& b, double size)
      : a_(a),
        b_(b),
        on_border_(kOnBorder * size),
        spans_{a.surface().patches.rows(), a.surface().patches.columns(),
               b.surface().patches.rows(), b.surface().patches.columns()},
        closed_{a.surface().closed_u, a.surface().closed_v, b.surface().closed_u,
                b.surface().closed_v} {}

  // Under every line that an arc may run along.
  void add(const FoundArc& arc) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Chord chord = chord_of(arc, i);
      if (gap(chord.low[i], chord.high[i], i) > kBesidePatch) continue;
      Line& line = lines_[{i, bucket(chord.low[i], i)}];
      line.widest = std::max(line.widest, chord.high[i ^ 1] - chord.low[i ^ 1]);
      line.chords.emplace(chord.low[i ^ 1], chord);
    }
  }

  // Whether the arcs added pass along most of this one, on the border that it shares.
  bool cover(const FoundArc& arc) const {
    const auto i = static_cast<std::size_t>(arc.arc.shared_border);
    const Chord chord = chord_of(arc, i);
    Point4 on_border{};
    on_border[i] = arc.arc.upper ? arc.box[i].to : arc.box[i].from;
    const double line = over_surfaces(arc, on_border)[i];
    const Interval all{chord.low[i ^ 1], chord.high[i ^ 1]};
    std::vector<Interval> parts = parts_beside(chord, line, i);
    std::sort(parts.begin(), parts.end(),
              [](const Interval& p, const Interval& q) { return p.from < q.from; });
    double covered = 0, reached = all.from;
    for (const Interval& part : parts) {
      const double from = std::max(part.from, reached), to = std::min(part.to, all.to);
      if (from < to) {
        covered += to - from;
        reached = to;
      }
    }
    return covered >= kLargePart * length(all);
  }

  // Model units.
  double chord(const FoundArc& arc) const {
    const auto& patch = a_.surface().patches.values()[static_cast<std::size_t>(arc.patch_a)];
    return distance(point_at(patch, arc.arc.from[0], arc.arc.from[1]),
                    point_at(patch, arc.arc.to[0], arc.arc.to[1]));
  }

 private:
  struct Line {
    std::multimap<double, Chord> chords;  // by where they begin along it
    double widest = 0;
  };

  Point4 over_surfaces(const FoundArc& arc, const Point4& x) const {
    return {a_.span_u(arc.patch_a) + x[0], a_.span_v(arc.patch_a) + x[1],
            b_.span_u(arc.patch_b) + x[2], b_.span_v(arc.patch_b) + x[3]};
  }

  Chord chord_of(const FoundArc& arc, std::size_t i) const {
    Chord chord{&arc, over_surfaces(arc, arc.arc.from), over_surfaces(arc, arc.arc.to)};
    if (chord.low[i ^ 1] > chord.high[i ^ 1]) std::swap(chord.low, chord.high);
    return chord;
  }

  double gap(double x, double y, std::size_t i) const {
    const double plain = std::abs(x - y);
    return closed_[i] ? std::min(plain, std::abs(spans_[i] - plain)) : plain;
  }

  // The two sides of a seam are one line.
  long bucket(double x, std::size_t i, long step = 0) const {
    const long whole = spans_[i] * kBuckets, key = std::lround(x * kBuckets) + step;
    return closed_[i] ? (key % whole + whole) % whole : key;
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

  // What others take of the line beside a chord.
  std::vector<Interval> parts_beside(const Chord& chord, double line, std::size_t i) const {
    const std::size_t along = i ^ 1;
    std::vector<Interval> parts;
    for (const long step : {-1L, 0L, 1L}) {
      const auto found = lines_.find({i, bucket(line, i, step)});
      if (found == lines_.end()) continue;
      const Line& near = found->second;
      const auto last = near.chords.upper_bound(chord.high[along] + kNoise);
      for (auto it = near.chords.lower_bound(chord.low[along] - kNoise - near.widest); it != last;
           ++it) {
        const Chord& other = it->second;
        if (other.high[along] < chord.low[along] - kNoise || !is_beside(other, chord, i)) continue;
        if (std::max(off_line(*other.arc, other.arc->arc.from, line, i),
                     off_line(*other.arc, other.arc->arc.to, line, i)) <= on_border_)
          parts.push_back({other.low[along], other.high[along]});
      }
    }
    return parts;
  }

  // In the middle of what both take of the line; tells arcs apart that pass it in other sheets of
  // the other surface.
  bool is_beside(const Chord& other, const Chord& chord, std::size_t i) const {
    const std::size_t along = i ^ 1;
    const double at = 0.5 * (std::max(other.low[along], chord.low[along]) +
                             std::min(other.high[along], chord.high[along]));
    const auto place = [&](const Chord& of, std::size_t k) {
      const double width = of.high[along] - of.low[along];
      const double share = width > 0 ? (at - of.low[along]) / width : 0.5;
      return of.low[k] + share * (of.high[k] - of.low[k]);
    };
    for (std::size_t k = 0; k < 4; ++k) {
      const double extent =
          std::abs(chord.high[k] - chord.low[k]) + std::abs(other.high[k] - other.low[k]);
      if (gap(place(other, k), place(chord, k), k) > kBesideChord * extent + kBesidePatch)
        return false;
    }
    return true;
  }

  const SurfaceCells& a_;
  const SurfaceCells& b_;
  const double on_border_;
  std::array<int, 4> spans_;
  std::array<bool, 4> closed_;
  std::map<std::pair<std::size_t, long>, Line> lines_;  // by parameter and bucket
};

// True if a parameter of an arc is that of a border of its whole surface at both ends.
bool is_on_border(const FoundArc& arc, int k, const SurfaceCells& a, const SurfaceCells& b) {
  const auto i = static_cast<std::size_t>(k);
  const double border = arc.arc.from[i] < 0.5 ? 0 : 1;
  const SurfaceCells& cells = k < 2 ? a : b;
  const BezierSurface& surface = cells.surface();
  const int patch = k < 2 ? arc.patch_a : arc.patch_b;
  const int span = k % 2 == 0 ? cells.span_u(patch) : cells.span_v(patch);
  const int last = (k % 2 == 0 ? surface.patches.rows() : surface.patches.columns()) - 1;
  const double run = std::abs(arc.arc.to[i ^ 1] - arc.arc.from[i ^ 1]);
  const double most = std::min(kAtBorder, kBesideBorder * run);
  return !(k % 2 == 0 ? surface.closed_u : surface.closed_v) && span == (border == 0 ? 0 : last) &&
         run >= kShortestAlong && std::abs(arc.arc.from[i] - border) <= most &&
         std::abs(arc.arc.to[i] - border) <= most;
}

bool runs_on_border(const FoundArc& arc, int k, SurfaceCells& a, SurfaceCells& b, double rounding) {
  const auto &patch_a = a.tree(arc.patch_a).patch(), &patch_b = b.tree(arc.patch_b).patch();
  return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double t) {
    Point4 x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = (1 - t) * arc.arc.from[i] + t * arc.arc.to[i];
    const auto on = point_on_iso_line(patch_a, patch_b, x, k, kFootReach);
    return on && distance(point_at(patch_a, (*on)[0], (*on)[1]),
                          point_at(patch_b, (*on)[2], (*on)[3])) <= rounding;
  });
}

}  // namespace

void put_on_borders(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, double rounding) {
  for (FoundArc& arc : found.arcs)
    for (int k = 0; k < 4; ++k) {
      if (arc.arc.tangential || arc.arc.iso >= 0 || arc.to_pole || !is_on_border(arc, k, a, b))
        continue;
      const auto i = static_cast<std::size_t>(k);
      FoundArc on_border = arc;
      on_border.arc.from[i] = on_border.arc.to[i] = arc.arc.from[i] < 0.5 ? 0 : 1;
      if (!runs_on_border(on_border, k, a, b, rounding)) continue;
      on_border.arc.iso = k;
      arc = on_border;
    }
}

void drop_repeated_arcs(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, double size,
                        double shortest) {
  if (found.along_border) {
    ExactBorders exact(a.surface(), b.surface());
    found.along_border = std::ranges::any_of(found.arcs, [&](const FoundArc& arc) {
      return arc.arc.runs_along_border && !runs_regularly(arc, a, b) && !exact.hold(arc);
    });
  }
  const auto shares = [](const FoundArc& arc) { return arc.arc.shared_border >= 0; };
  if (std::none_of(found.arcs.begin(), found.arcs.end(), shares)) return;
  ArcsOnLines kept(a, b, size);
  for (const FoundArc& arc : found.arcs)
    if (!shares(arc)) kept.add(arc);
  for (const bool upper : {false, true})
    for (FoundArc& arc : found.arcs) {
      if (!shares(arc) || arc.arc.upper != upper) continue;
      arc.dropped = (upper && kept.chord(arc) <= shortest) || kept.cover(arc);
      if (!arc.dropped) kept.add(arc);
    }
  std::erase_if(found.arcs, [](const FoundArc& arc) { return arc.dropped; });
}

}  // namespace blossom
