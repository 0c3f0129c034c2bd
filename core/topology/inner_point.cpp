// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/inner_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/math/interval.h"

namespace blossom {
namespace {

// So many lines first; while none tells, twice as many. The golden section spreads any number of
// them over the box, off symmetric places. A choice: the last ones are a 400th of the box apart.
constexpr int kFirstLines = 3, kMaxLines = 384;
constexpr double kGolden = 0.6180339887498949;
// Of a stretch: nearly its middle, atan(1 / 2). From the very middle of symmetric faces rays meet
// seams and edges of others, so that 1 % of random solids would be refused.
constexpr double kMiddle = 0.4636476090008061;
// Parts of the box's size: within so much it is told where a line meets a wire. The first is enough
// for all but thin faces; the others halve the digits that are left, down to roundings.
constexpr std::array kWidths{0x1p-10, 0x1p-24, 0.0};
constexpr double kRoundings = 8;  // of coordinates: no closer are points of a curve told apart

// How exactly the coordinates of wires are told, in each direction of the chart.
struct Exactness {
  Vec2 width;     // of a meeting, along a line
  Vec2 rounding;  // what is within it of a line across is on it
};

// A line of the chart along coordinate `along`.
struct ChartLine {
  int along = 0;
  double place = 0;  // the other coordinate

  Vec2 at(double t) const { return along == 0 ? Vec2{t, place} : Vec2{place, t}; }
};

// Where a line meets a curve, as stretches of it no longer than the width. What runs along the line
// is one meeting.
void add_meetings(const PlanarBezier& curve, const ChartLine& line, const Exactness& exact,
                  std::vector<Interval>& all) {
  const PlanarBox box = box_of(curve.points);
  const int k = line.along;
  if (line.place < box.low[1 - k] || line.place > box.high[1 - k]) return;
  if (box.high[k] - box.low[k] <= exact.width[k] ||
      box.high[1 - k] - box.low[1 - k] <= exact.rounding[1 - k]) {
    all.push_back({box.low[k], box.high[k]});
    return;
  }
  add_meetings(bezier_piece(curve, {0, 0.5}), line, exact, all);
  add_meetings(bezier_piece(curve, {0.5, 1}), line, exact, all);
}

// The stretches of a line between wires, in order.
std::vector<Interval> stretches(const FaceTrims& trims, const ChartLine& line,
                                const Exactness& exact) {
  std::vector<Interval> meetings, between;
  const auto add = [&](const Coedge& coedge) {
    for (const PlanarSpan& span : coedge.curve.spans)
      add_meetings(span.curve, line, exact, meetings);
  };
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      add(coedge);
      for (const auto& [from, to] : closing_chords(trims, coedge))
        if (from != to)
          add_meetings({{{from[0], from[1], 1}, {to[0], to[1], 1}}}, line, exact, meetings);
    }
  std::ranges::for_each(trims.inner, add);
  std::ranges::sort(meetings, {}, &Interval::from);
  double from = meetings.empty() ? 0 : meetings.front().to;
  for (const Interval& meeting : meetings) {
    if (meeting.from > from) between.push_back({from, meeting.from});
    from = std::max(from, meeting.to);
  }
  return between;
}

struct InnerPoint {
  Vec2 point;
  double clear = 0;  // the shorter one of the stretches through it
};

// Nearly the middle of the widest stretch of a line that is inside, moved to that of the stretch
// across.
InnerPoint on_line(const FaceTrims& trims, const ChartLine& line, const Exactness& exact) {
  std::vector<Interval> all = stretches(trims, line, exact);
  std::ranges::sort(all, std::greater{}, length);
  const auto inside = std::ranges::find_if(all, [&](const Interval& stretch) {
    return is_inside(trims, line.at(at(stretch, kMiddle)));
  });
  if (inside == all.end()) return {};
  const ChartLine across{1 - line.along, at(*inside, kMiddle)};
  for (const Interval& stretch : stretches(trims, across, exact))
    if (stretch.from <= line.place && line.place <= stretch.to)
      return {across.at(at(stretch, kMiddle)), std::min(length(*inside), length(stretch))};
  return {};
}

}  // namespace

std::optional<Vec2> inner_point(const FaceTrims& trims) {
  const Vec2 size = trims.box.high - trims.box.low;
  Exactness exact;
  for (int k = 0; k < 2; ++k) {
    exact.rounding[k] = kRoundings * std::numeric_limits<double>::epsilon() *
                        std::max(std::abs(trims.box.low[k]), std::abs(trims.box.high[k]));
    if (!(size[k] > exact.rounding[k])) return std::nullopt;
  }
  for (const double part : kWidths) {
    for (int k = 0; k < 2; ++k) exact.width[k] = std::max(part * size[k], exact.rounding[k]);
    InnerPoint best;
    int line = 0;
    for (int lines = kFirstLines; best.clear == 0 && lines <= kMaxLines; lines *= 2)
      for (; line < lines; ++line) {
        const double share = std::fmod((line + 0.5) * kGolden, 1.0);
        const InnerPoint found = on_line(trims, {0, trims.box.low[1] + share * size[1]}, exact);
        if (found.clear > best.clear && is_inside(trims, found.point)) best = found;
      }
    if (best.clear > 0) return best.point;
  }
  return std::nullopt;
}

}  // namespace blossom
