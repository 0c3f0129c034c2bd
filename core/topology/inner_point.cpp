// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/inner_point.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/math/interval.h"

namespace blossom {
namespace {

// Lines at these parts of the box's height, and where they have nothing, twice as many as often:
// the golden section keeps them off symmetric places.
constexpr int kFirstLines = 3, kMaxLines = 384;
constexpr double kGolden = 0.6180339887498949;
// Of a stretch: nearly its middle, in which symmetric faces have what is special of others.
constexpr double kMiddle = 0.4636476090008061;
// Parts of the box's size: within so much it is told where a line meets a wire. What is thinner is
// looked for with the next one.
constexpr double kWidths[] = {0x1p-10, 0x1p-24, 0x1p-40};

// A line of the chart along coordinate `along`, and how exactly it is told where it meets wires.
struct ChartLine {
  int along = 0;
  double place = 0;  // the other coordinate
  double width = 0;

  Vec2 at(double t) const { return along == 0 ? Vec2{t, place} : Vec2{place, t}; }
};

// Where a line meets a curve, as stretches of it no longer than its width.
void add_meetings(const PlanarBezier& curve, const ChartLine& line, std::vector<Interval>& all) {
  const PlanarBox box = box_of(curve.points);
  const int k = line.along;
  if (line.place < box.low[1 - k] || line.place > box.high[1 - k]) return;
  if (box.high[k] - box.low[k] <= line.width) {
    all.push_back({box.low[k], box.high[k]});
    return;
  }
  add_meetings(bezier_piece(curve, {0, 0.5}), line, all);
  add_meetings(bezier_piece(curve, {0.5, 1}), line, all);
}

// The stretches of a line between wires, in order.
std::vector<Interval> stretches(const FaceTrims& trims, const ChartLine& line) {
  std::vector<Interval> meetings, between;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop)
      for (const PlanarSpan& span : coedge.curve.spans) add_meetings(span.curve, line, meetings);
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
InnerPoint on_line(const FaceTrims& trims, const ChartLine& line, double across_width) {
  std::vector<Interval> all = stretches(trims, line);
  std::ranges::sort(all, std::greater{}, length);
  const auto inside = std::ranges::find_if(all, [&](const Interval& stretch) {
    return is_inside(trims, line.at(at(stretch, kMiddle)));
  });
  if (inside == all.end()) return {};
  const ChartLine across{1 - line.along, at(*inside, kMiddle), across_width};
  for (const Interval& stretch : stretches(trims, across))
    if (stretch.from <= line.place && line.place <= stretch.to)
      return {across.at(at(stretch, kMiddle)), std::min(length(*inside), length(stretch))};
  return {};
}

}  // namespace

std::optional<Vec2> inner_point(const FaceTrims& trims) {
  const Vec2 size = trims.box.high - trims.box.low;
  for (const double part : kWidths) {
    InnerPoint best;
    int line = 0;
    for (int lines = kFirstLines; best.clear == 0 && lines <= kMaxLines; lines *= 2)
      for (; line < lines; ++line) {
        const double share = std::fmod((line + 0.5) * kGolden, 1.0);
        const InnerPoint found =
            on_line(trims, {0, trims.box.low[1] + share * size[1], part * size[0]}, part * size[1]);
        if (found.clear > best.clear && is_inside(trims, found.point)) best = found;
      }
    if (best.clear > 0) return best.point;
  }
  return std::nullopt;
}

}  // namespace blossom
