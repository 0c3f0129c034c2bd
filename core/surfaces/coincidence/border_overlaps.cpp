// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/coincidence/border_overlaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/bounds/patch_boxes.h"
#include "core/forms/evaluation.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/gap/limits.h"

namespace blossom {
namespace {

constexpr int kSamples = 64;         // per span of a border
constexpr int kStarts = 8;           // intervals per direction of a patch where feet are sought
constexpr std::size_t kTried = 3;    // of the nearest of them
constexpr int kMaxMoves = 8;         // between patches, from one point to the next
constexpr double kSlack = 1e-9;      // fraction of a patch
constexpr double kBorderWidth = 10;  // tolerances: nearer to a border is on it
constexpr int kBisections = 48;
constexpr double kSnapReach = 1e-3;  // fraction of a span
constexpr double kChord = 5e-5;      // from the curve; fraction of the size
constexpr int kMaxRefinements = 8;
constexpr std::size_t kLinkPoints = 16;
constexpr double kBeside = 3;           // times sqrt(tolerance * size)
constexpr double kBoxRounding = 1e-14;  // of the size and the coordinates
constexpr double kOff = 0.05;           // beside a knot line, fraction of a patch

Vec3 derivative(const PatchJet& jet, int k) { return k == 0 ? jet.u : jet.v; }

}  // namespace

std::vector<BorderLine> border_lines(const BezierSurface& surface) {
  std::vector<BorderLine> lines;
  for (const int across : {0, 1}) {
    const int count = across == 0 ? surface.patches.rows() : surface.patches.columns();
    for (int span = 0; span < count; ++span)
      for (const bool upper : {false, true}) lines.push_back({across, span, upper});
  }
  return lines;
}

std::optional<int> span_beyond(const BezierSurface& surface, const BorderLine& line) {
  const int count = line.across == 0 ? surface.patches.rows() : surface.patches.columns();
  const int span = line.span + (line.upper ? 1 : -1);
  if (span >= 0 && span < count) return span;
  if (!(line.across == 0 ? surface.closed_u : surface.closed_v)) return std::nullopt;
  return (span + count) % count;
}

BorderFollower::BorderFollower(SurfaceCells& own, SurfaceCells& other,
                               std::vector<std::vector<int>> others, double tolerance, double size,
                               PolledLimit& limit)
    : own_(own),
      other_(other),
      others_(std::move(others)),
      starts_(static_cast<std::size_t>(other.patches())),
      tolerance_(tolerance),
      size_(size),
      near_other_(PatchBoxes(other.surface()).all()),
      limit_(limit) {
  near_other_ = widened({near_other_.low - other.origin(), near_other_.high - other.origin()},
                        2 * tolerance + kBoxRounding * (size + max_norm(other.origin())));
}

int BorderFollower::spans(const BorderLine& line) const {
  const auto& patches = own_.surface().patches;
  return line.across == 0 ? patches.columns() : patches.rows();
}

BorderProbe BorderFollower::placed(const BorderLine& line, double along, int span) const {
  const auto& patches = own_.surface().patches;
  BorderProbe at;
  at.along = along;
  at.patch = line.across == 0 ? line.span * patches.columns() + span
                              : span * patches.columns() + line.span;
  at.x[line.across] = line.upper ? 1 : 0;
  at.x[1 - line.across] = along - span;
  return at;
}

BorderProbe BorderFollower::placed(const BorderLine& line, double along) const {
  return placed(line, along, std::clamp(static_cast<int>(along), 0, spans(line) - 1));
}

Vec3 BorderFollower::point(const BorderProbe& probe) {
  return point_at(own_.tree(probe.patch).patch(), probe.x[0], probe.x[1]);
}

// Goes to the neighbouring patch if the foot lies in it. False if it stays.
bool BorderFollower::move_on(Foot& foot) const {
  const BezierSurface& surface = other_.surface();
  const int rows = surface.patches.rows(), columns = surface.patches.columns();
  for (int k = 0; k < 2; ++k) {
    const bool up = foot.raw[k] > 1 + kSlack;
    if (!up && foot.raw[k] >= -kSlack) continue;
    const int count = k == 0 ? rows : columns;
    int span = (k == 0 ? other_.span_u(foot.patch) : other_.span_v(foot.patch)) + (up ? 1 : -1);
    if (k == 0 ? surface.closed_u : surface.closed_v) span = (span + count) % count;
    if (span < 0 || span >= count) continue;
    foot.patch = k == 0 ? span * columns + other_.span_v(foot.patch)
                        : other_.span_u(foot.patch) * columns + span;
    foot.x[k] = up ? 0 : 1;
    return true;
  }
  return false;
}

bool BorderFollower::follow(BorderProbe& at, Foot near) {
  const auto& own = own_.tree(at.patch).patch();
  for (int move = 0; move <= kMaxMoves; ++move) {
    const auto solution = foot_point(own, other_.tree(near.patch).patch(),
                                     {at.x[0], at.x[1], near.x[0], near.x[1]}, kNewtonReach);
    if (!solution) return false;
    near.raw = {(*solution)[2], (*solution)[3]};
    for (int k = 0; k < 2; ++k) near.x[k] = std::clamp(near.raw[k], 0.0, 1.0);
    if (move == kMaxMoves || !move_on(near)) break;
  }
  near.gap = distance(point(at), point_at(other_.tree(near.patch).patch(), near.x[0], near.x[1]));
  at.foot = near;
  return true;
}

const std::vector<BorderFollower::Start>& BorderFollower::starts(int patch) {
  auto& grid = starts_[static_cast<std::size_t>(patch)];
  if (grid.empty())
    for (int i = 0; i <= kStarts; ++i)
      for (int j = 0; j <= kStarts; ++j) {
        const Vec2 x{static_cast<double>(i) / kStarts, static_cast<double>(j) / kStarts};
        grid.push_back({patch, x, point_at(other_.tree(patch).patch(), x[0], x[1])});
      }
  return grid;
}

// The best of the feet that Newton's method finds from the nearest points of a grid.
bool BorderFollower::search(BorderProbe& at) {
  const Vec3 p = point(at);
  std::vector<std::pair<double, const Start*>> nearest;
  for (const int patch : others_[static_cast<std::size_t>(at.patch)])
    for (const Start& start : starts(patch)) nearest.emplace_back(distance(p, start.point), &start);
  const std::size_t tried = std::min(kTried, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(tried),
                    nearest.end());
  std::optional<Foot> best;
  for (std::size_t i = 0; i < tried; ++i) {
    const Start& start = *nearest[i].second;
    if (follow(at, {start.patch, start.x, start.x, 0}) && (!best || at.foot.gap < best->gap))
      best = at.foot;
  }
  if (best) at.foot = *best;
  return best.has_value();
}

// The foot as far as it may be within the tolerance.
bool BorderFollower::probe(BorderProbe& at, const Foot* near) {
  if (limit_.reached()) return false;
  if (near && follow(at, *near) && at.foot.gap <= tolerance_) return true;
  const Vec3 p = point(at);
  return meet({p, p}, near_other_) && search(at);
}

// The borders of the other surface on which a foot lies.
std::vector<BorderLine> BorderFollower::borders_at(const Foot& foot, double width) const {
  const BezierSurface& surface = other_.surface();
  const PatchJet jet = jet_at(other_.tree(foot.patch).patch(), foot.x[0], foot.x[1], 1);
  std::vector<BorderLine> borders = border_lines(surface);
  std::erase_if(borders, [&](const BorderLine& line) {
    const int k = line.across;
    const int span = k == 0 ? other_.span_u(foot.patch) : other_.span_v(foot.patch);
    const double end = line.upper ? 1 : 0;
    return span != line.span ||
           std::abs(foot.x[k] - end) * norm(derivative(jet, k)) > width * tolerance_;
  });
  return borders;
}

bool BorderFollower::lies_on(const BorderProbe& at, bool found, StretchKind kind) const {
  return found && at.foot.gap <= tolerance_ &&
         (kind == StretchKind::Any || borders_at(at.foot, kBorderWidth).empty());
}

std::vector<BorderOverlap> BorderFollower::stretches(const BorderLine& line, StretchKind kind,
                                                     const std::vector<double>& junctions) {
  std::vector<double> places;
  for (int span = 0; span < spans(line); ++span) {
    if (others_[static_cast<std::size_t>(placed(line, span, span).patch)].empty() ||
        !is_crease(line, span))
      continue;
    for (int i = 0; i <= kSamples; ++i) places.push_back(span + static_cast<double>(i) / kSamples);
    for (const double junction : junctions)
      if (junction >= span && junction <= span + 1) places.push_back(junction);
  }
  std::sort(places.begin(), places.end());
  std::vector<double> between;  // a short stretch between two junctions needs a point inside
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    if (!junctions.empty() && places[i + 1] - places[i] < 1)
      between.push_back(0.5 * (places[i] + places[i + 1]));
  places.insert(places.end(), between.begin(), between.end());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  std::vector<BorderOverlap> found;
  bool open = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    BorderProbe at = placed(line, places[i]);
    if (others_[static_cast<std::size_t>(at.patch)].empty())  // a span's end
      at = placed(line, places[i], std::max(0, static_cast<int>(places[i]) - 1));
    const Foot* near = open ? &found.back().points.back().foot : nullptr;
    const bool on =
        !others_[static_cast<std::size_t>(at.patch)].empty() && lies_on(at, probe(at, near), kind);
    if (on && !open) {
      found.push_back({line, {}});
      if (i > 0 && places[i] - places[i - 1] <= 0.5)
        found.back().points.push_back(end_between(line, at, places[i - 1], kind));
    }
    if (on) found.back().points.push_back(at);
    if (!on && open) {
      auto& points = found.back().points;
      points.push_back(end_between(line, points.back(), places[i], kind));
    }
    open = on;
  }
  for (BorderOverlap& stretch : found) refine(stretch);
  std::erase_if(found, [](const BorderOverlap& s) { return s.points.size() < 2; });
  return found;
}

// The end of a stretch between a point on it and one outside, `in` and `out`.
BorderProbe BorderFollower::end_between(const BorderLine& line, BorderProbe in, double out,
                                        StretchKind kind) {
  const double inwards = in.along > out ? 1 : -1;
  for (int i = 0; i < kBisections; ++i) {
    BorderProbe middle = placed(line, 0.5 * (in.along + out));
    if (lies_on(middle, probe(middle, &in.foot), kind))
      in = middle;
    else
      out = middle.along;
  }
  for (const BorderLine& border : borders_at(in.foot, 2 * kBorderWidth))
    if (snap(line, in, inwards, border)) break;
  return in;
}

// Moves an end near a border of the other surface exactly onto it, by the secant method. False if
// the line does not cross that border there.
bool BorderFollower::snap(const BorderLine& line, BorderProbe& end, double inwards,
                          const BorderLine& border) {
  const int k = border.across;
  const double goal = border.upper ? 1 : 0;
  const auto miss = [&](double along) -> std::optional<BorderProbe> {
    BorderProbe at = placed(line, std::clamp(along, 0.0, static_cast<double>(spans(line))));
    if (!follow(at, end.foot) || at.foot.patch != end.foot.patch) return std::nullopt;
    return at;
  };
  auto p = miss(end.along + 0.01 * kSnapReach * inwards), q = miss(end.along);
  // A line that runs along this border has nothing to cross.
  if (!p || !q || std::abs(p->foot.raw[k] - q->foot.raw[k]) <= kSlack) return false;
  for (int i = 0; i < 8 && p && q; ++i) {
    const double f = p->foot.raw[k] - goal, g = q->foot.raw[k] - goal;
    if (std::abs(g) < 1e-14 || f == g) break;
    const double next = q->along - g * (q->along - p->along) / (g - f);
    if (std::abs(next - end.along) > kSnapReach) return false;
    p = q;
    q = miss(next);
  }
  if (!q || q->foot.gap > tolerance_ || std::abs(q->foot.raw[k] - goal) > kSlack) return false;
  end = *q;
  end.foot.x[k] = goal;
  return true;
}

void BorderFollower::refine(BorderOverlap& stretch) {
  auto& points = stretch.points;
  std::sort(points.begin(), points.end(),
            [](const BorderProbe& p, const BorderProbe& q) { return p.along < q.along; });
  const auto same = [](const BorderProbe& p, const BorderProbe& q) {
    return q.along - p.along <= kSlack;
  };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  for (int round = 0; round < kMaxRefinements; ++round) {
    std::vector<BorderProbe> finer;
    for (std::size_t i = 0; i < points.size(); ++i) {
      finer.push_back(points[i]);
      if (i + 1 == points.size()) break;
      BorderProbe middle = placed(stretch.line, 0.5 * (points[i].along + points[i + 1].along));
      const Vec3 chord = 0.5 * (point(points[i]) + point(points[i + 1]));
      if (distance(chord, point(middle)) > kChord * size_ && probe(middle, &points[i].foot))
        finer.push_back(middle);
    }
    if (finer.size() == points.size()) return;
    points = std::move(finer);
  }
}

std::vector<BorderJunction> BorderFollower::junctions(const BorderOverlap& stretch) const {
  std::vector<BorderJunction> result;
  for (const BorderProbe* end : {&stretch.points.front(), &stretch.points.back()}) {
    for (const BorderLine& border : borders_at(end->foot, kBorderWidth)) {
      const int k = border.across;
      const int span = k == 0 ? other_.span_v(end->foot.patch) : other_.span_u(end->foot.patch);
      result.push_back({border, span + end->foot.x[1 - k]});
    }
  }
  return result;
}

std::vector<BorderOverlap> BorderFollower::cut(const BorderOverlap& stretch,
                                               const std::vector<double>& places) {
  std::vector<BorderOverlap> parts{{stretch.line, {stretch.points.front()}}};
  for (std::size_t i = 0; i + 1 < stretch.points.size(); ++i) {
    const BorderProbe &p = stretch.points[i], &q = stretch.points[i + 1];
    for (const double place : places) {
      if (place - p.along <= kSlack || q.along - place < kSlack ||
          stretch.points.back().along - place <= kSlack)
        continue;
      BorderProbe at = placed(stretch.line, place);
      if (!probe(at, &p.foot)) continue;
      parts.back().points.push_back(at);
      parts.push_back({stretch.line, {at}});
    }
    parts.back().points.push_back(q);
  }
  return parts;
}

bool BorderFollower::coincide_inside(const BorderOverlap& stretch) {
  const double least = kBeside * std::sqrt(tolerance_ * size_);
  const int k = stretch.line.across;
  const double from = stretch.points.front().along, to = stretch.points.back().along;
  for (const double offset : {4 * least, 2 * least, least}) {
    int hits = 0;
    for (const double fraction : {0.25, 0.5, 0.75}) {
      BorderProbe at = placed(stretch.line, (1 - fraction) * from + fraction * to);
      const PatchJet jet = jet_at(own_.tree(at.patch).patch(), at.x[0], at.x[1], 1);
      const double step = std::min(offset / norm(derivative(jet, k)), 0.5);
      at.x[k] += stretch.line.upper ? -step : step;
      if (search(at) && at.foot.gap <= tolerance_) ++hits;
    }
    if (hits >= 2) return true;
  }
  return false;
}

// True if the surfaces coincide beside a border, in its own row of patches or in the one beyond.
// Close to it only where the other surface ends before kOff: surfaces may part slowly.
bool BorderFollower::coincides_off(const BorderLine& line, double along, bool beyond) {
  BorderProbe at = placed(line, along);
  const int k = line.across;
  bool below = line.upper;  // the point lies below the knot line
  if (beyond) {
    const auto& patches = own_.surface().patches;
    const int span = *span_beyond(own_.surface(), line);
    at.patch = k == 0 ? span * patches.columns() + own_.span_v(at.patch)
                      : own_.span_u(at.patch) * patches.columns() + span;
    below = !below;
  }
  at.x[k] = below ? 1 : 0;
  const PatchJet jet = jet_at(own_.tree(at.patch).patch(), at.x[0], at.x[1], 1);
  const double least = kBeside * std::sqrt(tolerance_ * size_) / norm(derivative(jet, k));
  for (const double offset : {kOff, 4 * least, 2 * least, least}) {
    const double off = std::min(offset, kOff);
    at.x[k] = below ? 1 - off : off;
    const bool found = search(at);
    if (found && at.foot.gap <= tolerance_) return true;
    if (found && !leaves(at.foot)) return false;
  }
  return false;
}

// True if a foot lies on the border of the other surface, which may end before the point.
bool BorderFollower::leaves(const Foot& foot) const {
  return std::ranges::any_of(borders_at(foot, 1), [&](const BorderLine& border) {
    return !span_beyond(other_.surface(), border);
  });
}

// True if the surface ends at the border, or the other one follows it on one side only.
bool BorderFollower::is_crease(const BorderLine& line, int span) {
  if (!span_beyond(own_.surface(), line)) return true;
  for (const double part : {0.1, 0.35, 0.65, 0.9})
    if (coincides_off(line, span + part, false) != coincides_off(line, span + part, true))
      return true;
  return false;
}

bool BorderFollower::bounds_coincidence(const BorderOverlap& stretch) {
  if (!coincide_inside(stretch)) return false;
  if (!span_beyond(own_.surface(), stretch.line)) return true;
  const double from = stretch.points.front().along, to = stretch.points.back().along;
  int beyond = 0;
  for (const double fraction : {0.25, 0.5, 0.75})
    if (coincides_off(stretch.line, (1 - fraction) * from + fraction * to, true)) ++beyond;
  return beyond < 2;
}

// Between two points of a stretch that lie in different pairs of patches.
std::vector<BorderProbe> BorderFollower::patch_change(const BorderLine& line, BorderProbe from,
                                                      const BorderProbe& to) {
  double last = to.along;
  if (from.patch != to.patch) {
    BorderProbe below =
        placed(line, std::floor(to.along), static_cast<int>(std::floor(to.along)) - 1);
    BorderProbe above = placed(line, std::floor(to.along), static_cast<int>(std::floor(to.along)));
    if (below.patch != from.patch || !follow(below, from.foot) || !follow(above, to.foot))
      return {};
    std::vector<BorderProbe> all = patch_change(line, from, below);
    all.push_back(below);
    all.push_back(above);
    const auto rest = patch_change(line, above, to);
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
  }
  if (from.foot.patch == to.foot.patch) return {};
  for (int i = 0; i < kBisections; ++i) {
    BorderProbe middle = placed(line, 0.5 * (from.along + last), static_cast<int>(from.along));
    if (!follow(middle, from.foot)) return {};
    if (middle.foot.patch == from.foot.patch)
      from = middle;
    else
      last = middle.along;
  }
  BorderProbe after = from;
  if (!follow(after, to.foot)) return {};
  after.foot = Foot{to.foot.patch, after.foot.x, after.foot.raw, after.foot.gap};
  for (int k = 0; k < 2; ++k)
    if (std::abs(from.foot.x[k] - after.foot.x[k]) > 0.5) {
      from.foot.x[k] = std::round(from.foot.x[k]);
      after.foot.x[k] = 1 - from.foot.x[k];
    }
  return {from, after};
}

std::vector<BorderProbe> BorderFollower::links(const BorderOverlap& stretch) {
  const auto& points = stretch.points;
  const std::size_t step = std::max<std::size_t>(1, points.size() / kLinkPoints);
  std::vector<BorderProbe> result{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const BorderProbe& p = points[i - 1];
    const BorderProbe& q = points[i];
    if (p.patch != q.patch || p.foot.patch != q.foot.patch) {
      if (result.back().along < p.along) result.push_back(p);
      const auto between = patch_change(stretch.line, p, q);
      result.insert(result.end(), between.begin(), between.end());
    }
    if (i % step == 0 || i + 1 == points.size()) result.push_back(q);
  }
  return result;
}

}  // namespace blossom
