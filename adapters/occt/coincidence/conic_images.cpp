// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/coincidence/conic_images.h"

#include <algorithm>
#include <cmath>

#include <Geom_Surface.hxx>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/splitting/edge_images.h"
#include "core/base/unbounded.h"
#include "core/math/periods.h"
#include "core/results/hermite_curves.h"
#include "core/tracing/spline_fit.h"

namespace blossom::occt {
namespace {

constexpr int kSamples = 64;      // of a form, to see where it passes seams
constexpr double kAside = 0.3;    // of a step: keeps samples off symmetric places, where seams are
constexpr int kHalvings = 60;     // of the interval between two samples
constexpr double kBeside = 1e-7;  // of a part: how far from its ends charts are looked at
constexpr double kSame = 1e-9;    // of a part: cuts so near are one
constexpr double kFit = 2e-2;     // of the slack: what a spline may be off
constexpr int kMinPieces = 4, kMaxPieces = 512;

std::array<Vec3, 3> jet_of(const ClosedForm& form, double t) {
  if (const auto* crossing = std::get_if<PipeCrossing>(&form)) return jet_at(*crossing, t);
  const auto& conic = std::get<Conic>(form);
  return {point_at(conic, t), derivative_at(conic, t), second_derivative_at(conic, t)};
}

// Which period of each chart's parameters a point lies in.
using Windows = std::array<int, 4>;

std::vector<Interval> parts_of(const Interval& range, const std::vector<double>& cuts) {
  std::vector<Interval> parts;
  double from = range.from;
  for (const double cut : cuts) {
    parts.push_back({from, cut});
    from = cut;
  }
  parts.push_back({from, range.to});
  return parts;
}

class FormImages {
 public:
  FormImages(const ClosedForm& form, const std::array<const ChartSheet*, 2>& sheets, double slack)
      : form_(form), sheets_(sheets), slack_(slack) {}

  std::vector<double> cuts(const Interval& range, const std::vector<double>& nodes) const;
  bool is_pole(double t) const { return is_pole(0, t) || is_pole(1, t); }
  std::optional<IntersectionCurve> curve_on(const Interval& part) const;

 private:
  struct Chart {
    bool straight = false;
    Vec2 start, step;  // of a straight one: uv at the part's start, and over all of it
    Vec2 shift;        // by whole periods
  };
  using Places = std::array<Vec2, 2>;  // in both charts

  Vec2 uv(std::size_t k, double t, const std::optional<Vec2>& near) const {
    return sheets_[k]->feet.foot(jet_of(form_, t)[0], near);
  }
  bool is_pole(std::size_t k, double t) const {
    return sheets_[k]->feet.pole_at(jet_of(form_, t)[0]) != nullptr;
  }
  // Where windows are looked for, which a chart without periods has none of.
  Vec2 place(std::size_t k, double t, const std::optional<Vec2>& near) const {
    if (sheets_[k]->period == Vec2{}) return {};
    return sheets_[k]->leaps ? past_seam(k, t, near) : uv(k, t, near);
  }
  Vec2 past_seam(std::size_t k, double t, const std::optional<Vec2>& near) const;
  Places both(double t, const Places& near) const {
    return {place(0, t, near[0]), place(1, t, near[1])};
  }
  Windows windows(const Places& at, const Windows& before, double slack = kSame) const;
  void add_changes(const Interval& run, std::vector<double>& found) const;
  void add_between(std::vector<double>& all, std::vector<Places>& places, double least) const;
  std::vector<double> lookouts(const Interval& run) const;
  double change(Interval around, Places near, const Windows& before) const;
  Chart chart_of(std::size_t k, const Interval& part) const;
  std::array<Vec2, 3> chart_jet(std::size_t k, const Chart& chart, const Interval& part, double t,
                                double beside, std::optional<Vec2>& near) const;
  std::array<Vec2, 3> bent_jet(std::size_t k, double t, std::optional<Vec2>& near) const;
  std::array<Vec2, 3> pole_jet(std::size_t k, double pole, double beside,
                               std::optional<Vec2>& near) const;
  IntersectionCurve fitted(const std::array<Chart, 2>& charts,
                           const std::vector<double>& knots) const;
  Deviation sampled(const IntersectionCurve& curve, double t) const;

  ClosedForm form_;
  std::array<const ChartSheet*, 2> sheets_;
  double slack_;
};

// Feet on a surface that closes without a period stay on its seam a little longer than the curve,
// and then leap to the other end; these go on.
Vec2 FormImages::past_seam(std::size_t k, double t, const std::optional<Vec2>& near) const {
  const ChartSheet& sheet = *sheets_[k];
  Vec2 at = uv(k, t, near);
  const SurfaceJet frame = frame_at(sheet.feet.surface(), at);
  at += chart_step(frame, jet_of(form_, t)[0] - frame.point);
  return near ? unwrapped(at, *near, sheet.period) : at;
}

// A point on a seam, to rounding, stays in the window it was in: a curve may run along the seam.
Windows FormImages::windows(const Places& at, const Windows& before, double slack) const {
  Windows found{};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ChartSheet& sheet = *sheets_[i / 2];
    const int d = static_cast<int>(i % 2);
    if (sheet.period[d] == 0) continue;
    const double turns = (at[i / 2][d] - sheet.middle[d]) / sheet.period[d] + 0.5;
    const bool stays = turns >= before[i] - slack && turns <= before[i] + 1 + slack;
    found[i] = stays ? before[i] : static_cast<int>(std::floor(turns));
  }
  return found;
}

// Where windows change between two parameters: on the seam itself, but for a curve along it.
double FormImages::change(Interval around, Places near, const Windows& before) const {
  const double slack = windows(near, before, -kSame) == before ? 0 : kSame;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = at(around, 0.5);
    const Places there = both(middle, near);
    if (windows(there, before, slack) == before) {
      around.from = middle;
      near = there;
    } else {
      around.to = middle;
    }
  }
  return at(around, 0.5);
}

// Steps are halved in which a parameter goes so far that it may have gone round the other way, as
// where the conic passes a pole.
void FormImages::add_between(std::vector<double>& all, std::vector<Places>& places,
                             double least) const {
  for (std::size_t i = 1; i < all.size();) {
    places[i] = both(all[i], places[i - 1]);
    bool goes_far = false;
    for (std::size_t k = 0; k < 2; ++k)
      for (int d = 0; d < 2; ++d)
        goes_far = goes_far ||
                   (sheets_[k]->period[d] > 0 &&
                    std::abs(places[i][k][d] - places[i - 1][k][d]) > 0.25 * sheets_[k]->period[d]);
    if (goes_far && all[i] - all[i - 1] > least) {
      const auto offset = static_cast<std::ptrdiff_t>(i);
      all.insert(all.begin() + offset, 0.5 * (all[i - 1] + all[i]));
      places.insert(places.begin() + offset, places[i - 1]);
    } else {
      ++i;
    }
  }
}

// Steps of a run, and where a parameter of a chart turns back between them: it may pass a seam
// there and come back.
std::vector<double> FormImages::lookouts(const Interval& run) const {
  std::vector<double> all;
  std::vector<Places> places;
  for (int i = 0; i <= kSamples + 1; ++i) {
    const double part = (i - kAside) / kSamples;
    all.push_back(at(run, std::clamp(part, kBeside, 1 - kBeside)));
    places.push_back(i == 0 ? Places{place(0, all[0], {}), place(1, all[0], {})}
                            : both(all.back(), places.back()));
  }
  add_between(all, places, kSame * length(run));
  for (std::size_t i = 1; i + 1 < places.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const int d = static_cast<int>(k % 2);
      const auto value = [&](const Places& of) { return of[k / 2][d]; };
      const double here = value(places[i]), sign = here >= value(places[i - 1]) ? 1 : -1;
      if (sheets_[k / 2]->period[d] == 0 || sign * (here - value(places[i + 1])) <= 0) continue;
      Interval around{all[i - 1], all[i + 1]};
      for (int step = 0; step < kHalvings / 2; ++step) {
        const double low = at(around, 0.4), high = at(around, 0.6);
        const bool up = sign * value(both(low, places[i])) < sign * value(both(high, places[i]));
        (up ? around.from : around.to) = up ? low : high;
      }
      all.push_back(at(around, 0.5));
    }
  std::ranges::sort(all);
  return all;
}

// The changes of windows on a run without poles. Between two lookouts there may be several.
void FormImages::add_changes(const Interval& run, std::vector<double>& found) const {
  const std::vector<double> all = lookouts(run);
  Places here{place(0, all[0], {}), place(1, all[0], {})};
  Windows known = windows(here, {});
  double t = all[0];
  for (std::size_t i = 1; i < all.size();) {
    const Places there = both(all[i], here);
    if (windows(there, known) == known) {
      t = all[i++];
      here = there;
      continue;
    }
    const double at_change = change({t, all[i]}, here, known);
    found.push_back(at_change);
    t = std::min(all[i], at_change + 2 * kSame * length(run));
    here = both(t, here);
    const Windows past = windows(here, known);
    known = past == known ? windows(there, known) : past;
  }
}

// Poles, seams and nodes, in increasing order; without the ends.
std::vector<double> FormImages::cuts(const Interval& range,
                                     const std::vector<double>& nodes) const {
  std::vector<double> found;
  for (const double node : nodes)
    for (double t = node + kTurn * std::ceil((range.from - node) / kTurn); t < range.to; t += kTurn)
      if (t > range.from) found.push_back(t);
  if (const Conic* conic = std::get_if<Conic>(&form_)) {  // pipes have no poles
    const Handle(Geom_Curve) curve = to_occt(*conic);
    for (const ChartSheet* sheet : sheets_)
      for (const Interval& part : CurveBeside(curve, range, sheet->feet).between_poles(range))
        if (part.from > range.from) found.push_back(part.from);
  }
  std::ranges::sort(found);
  for (const Interval& run : parts_of(range, found)) add_changes(run, found);
  std::ranges::sort(found);
  const double least = 4 * kSame * length(range);
  const auto repeated =
      std::unique(found.begin(), found.end(), [&](double x, double y) { return y - x <= least; });
  found.erase(repeated, found.end());
  std::erase_if(found, [&](double t) { return t - range.from <= least || range.to - t <= least; });
  return found;
}

// Whether the image is straight is told by points inside, so that poles at the ends do not matter.
FormImages::Chart FormImages::chart_of(std::size_t k, const Interval& part) const {
  const ChartSheet& sheet = *sheets_[k];
  const Vec2 middle = uv(k, at(part, 0.5), std::nullopt);
  const Vec2 low = uv(k, at(part, 0.25), middle), high = uv(k, at(part, 0.75), middle);
  // A part may touch the seam in its middle, but has a mean beside it.
  const Vec2 mean = 0.25 * low + 0.5 * middle + 0.25 * high;
  Chart chart{false, {}, {}, in_sheet(sheet, mean) - mean};
  chart.step = 2 * (high - low);
  chart.start = middle - 0.5 * chart.step + chart.shift;
  // What passes a pole within the slack goes through it.
  const double allowed = (is_pole(k, part.from) || is_pole(k, part.to) ? 1 : kFit) * slack_;
  chart.straight = true;
  for (const double t : {kBeside, 0.1, 0.25, 0.4, 0.65, 0.9, 1 - kBeside}) {
    const Vec2 on_line = chart.start + t * chart.step;
    const Vec3 point = jet_of(form_, at(part, t))[0];
    chart.straight =
        chart.straight && sheet.feet.gap(point, on_line) <=
                              sheet.feet.gap(point, uv(k, at(part, t), on_line)) + allowed;
  }
  return chart;
}

// Of an image that is no straight line, away from poles, not shifted.
std::array<Vec2, 3> FormImages::bent_jet(std::size_t k, double t, std::optional<Vec2>& near) const {
  const Vec2 at = uv(k, t, near);
  near = at;
  const Handle(Geom_Surface)& surface = sheets_[k]->feet.surface();
  const SurfaceJet frame = frame_at(surface, at);
  const SurfaceBend bend = bend_at(surface, at);
  const std::array<Vec3, 3> jet = jet_of(form_, t);
  const Vec2 first = chart_step(frame, jet[1]);
  const Vec3 left = jet[2] - first[0] * first[0] * bend.uu - 2 * first[0] * first[1] * bend.uv -
                    first[1] * first[1] * bend.vv;
  return {at, first, chart_step(frame, left)};
}

// In a pole, as a circle of a ball has that is no meridian: its image comes there with a direction,
// and its second derivative is that of the piece of degree 4 from the pole to a place beside it. By
// Taylor from the pole, with x from there to that place, where the image is q, q' and q'':
//   p'' = 12 (q - p - p' x) / x^2 - 6 (q' - p') / x + q''
std::array<Vec2, 3> FormImages::pole_jet(std::size_t k, double pole, double beside,
                                         std::optional<Vec2>& near) const {
  std::optional<Vec2> aside = near;
  const double x = beside - pole;
  const std::array<Vec2, 3> q = bent_jet(k, beside, aside);
  const CurveBeside curve(to_occt(std::get<Conic>(form_)), {pole, beside}, sheets_[k]->feet);
  const CurveOnSurfaceJet p = curve.end_jet(pole, beside, aside);
  near = p.uv;
  return {p.uv, p.uv_rate,
          (12 / (x * x)) * (q[0] - p.uv - x * p.uv_rate) - (6 / x) * (q[1] - p.uv_rate) + q[2]};
}

std::array<Vec2, 3> FormImages::chart_jet(std::size_t k, const Chart& chart, const Interval& part,
                                          double t, double beside,
                                          std::optional<Vec2>& near) const {
  const double share = (t - part.from) / length(part);
  if (chart.straight)
    return {on_seam(*sheets_[k], chart.start + share * chart.step), (1 / length(part)) * chart.step,
            Vec2{}};
  std::array<Vec2, 3> jet = is_pole(k, t) ? pole_jet(k, t, beside, near) : bent_jet(k, t, near);
  jet[0] = on_seam(*sheets_[k], jet[0] + chart.shift);
  return jet;
}

// Hermite pieces of degree 5.
IntersectionCurve FormImages::fitted(const std::array<Chart, 2>& charts,
                                     const std::vector<double>& knots) const {
  IntersectionCurve curve;
  if (const Conic* conic = std::get_if<Conic>(&form_)) curve.conic = *conic;
  const Interval part{knots.front(), knots.back()};
  const double half_way = at(part, 0.5);
  std::array<std::optional<Vec2>, 2> near;
  for (std::size_t k = 0; k < 2; ++k) near[k] = uv(k, half_way, std::nullopt);
  // From the middle, where periods are known, back beside the start, which may be a pole.
  for (std::size_t i = knots.size() - 1; i > 0; --i)
    for (std::size_t k = 0; k < 2; ++k)
      if (!charts[k].straight && knots[i] < half_way) near[k] = uv(k, knots[i], near[k]);
  std::array<Vec3, 3> space{};
  std::array<std::array<Vec2, 3>, 2> chart{};
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double t = knots[i], beside = i == 0 ? knots[1] : knots[i - 1];
    const std::array<Vec3, 3> now = jet_of(form_, t);
    const std::array<std::array<Vec2, 3>, 2> charts_now{
        chart_jet(0, charts[0], part, t, beside, near[0]),
        chart_jet(1, charts[1], part, t, beside, near[1])};
    if (i > 0) {
      const int first = i == 1 ? 0 : 1;
      const auto add = [&](const auto& from, const auto& to, auto& points) {
        const auto bezier = hermite_points(from, to, t - beside);
        points.insert(points.end(), bezier.begin() + first, bezier.end());
      };
      add(space, now, curve.curve.points);
      add(chart[0], charts_now[0], curve.chart_a.points);
      add(chart[1], charts_now[1], curve.chart_b.points);
    }
    space = now;
    chart = charts_now;
    const bool is_end = i == 0 || i + 1 == knots.size();
    curve.curve.multiplicities.push_back(is_end ? kFitDegree + 1 : kFitDegree);
    curve.samples.push_back({now[0], charts_now[0][0], charts_now[1][0]});
  }
  curve.curve.knots = curve.sample_parameters = knots;
  curve.curve.degree = curve.chart_a.degree = curve.chart_b.degree = kFitDegree;
  curve.chart_a.knots = curve.chart_b.knots = knots;
  curve.chart_a.multiplicities = curve.chart_b.multiplicities = curve.curve.multiplicities;
  return curve;
}

Deviation FormImages::sampled(const IntersectionCurve& curve, double t) const {
  const Vec3 point = jet_of(form_, t)[0];
  const Vec2 uv_a = point_at(curve.chart_a, t), uv_b = point_at(curve.chart_b, t);
  return {sheets_[0]->feet.gap(point, uv_a), sheets_[1]->feet.gap(point, uv_b),
          distance(frame_at(sheets_[0]->feet.surface(), uv_a).point,
                   frame_at(sheets_[1]->feet.surface(), uv_b).point),
          false, distance(point, point_at(curve.curve, t))};
}

// The parameter becomes arc length on average, and the spline is all there is of the curve in
// space.
void take_for_length(IntersectionCurve& curve) {
  const double from = curve.curve.knots.front(), rate = curve.length / length(curve.curve.domain());
  for (std::vector<double>* parameters :
       {&curve.curve.knots, &curve.chart_a.knots, &curve.chart_b.knots, &curve.sample_parameters})
    for (double& t : *parameters) t = rate * (t - from);
  curve.deviation.conic = 0;
}

// Pieces are halved where they are off, as beside a pole, until that does not help any more.
std::optional<IntersectionCurve> FormImages::curve_on(const Interval& part) const {
  const std::array charts{chart_of(0, part), chart_of(1, part)};
  const Conic* conic = std::get_if<Conic>(&form_);
  const bool is_line = conic != nullptr && conic->kind == ConicKind::Line;
  const bool straight = charts[0].straight && charts[1].straight && is_line;
  const double sixth = conic != nullptr ? sixth_derivative_bound(*conic, part) : 0;
  const double width = sixth > 0 ? std::pow(46080 * kFit * slack_ / sixth, 1.0 / 6) : length(part);
  const double wanted = straight ? 0 : length(part) / width;
  if (!(wanted < kMaxPieces)) return {};
  const int pieces = straight ? 1 : std::max(kMinPieces, static_cast<int>(wanted) + 1);
  std::vector<double> knots;
  for (int i = 0; i <= pieces; ++i) knots.push_back(at(part, static_cast<double>(i) / pieces));
  IntersectionCurve curve;
  double off = 0, before = kInfinity;
  for (; static_cast<int>(knots.size()) <= kMaxPieces + 1; before = off) {
    curve = fitted(charts, knots);
    curve.deviation = {0, 0, 0, false, 0};
    std::vector<double> finer{part.from};
    bool is_off = false;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const double middle = 0.5 * (knots[i] + knots[i + 1]);
      const Deviation here = sampled(curve, middle);
      raise(curve.deviation, here);
      curve.deviation.conic = std::max(curve.deviation.conic, here.conic);
      const double most = std::max({here.a, here.b, here.conic});
      const bool here_off = most > kFit * slack_;
      is_off = is_off || here_off;
      if (here_off) finer.push_back(middle);
      finer.push_back(knots[i + 1]);
    }
    off = std::max({curve.deviation.a, curve.deviation.b, curve.deviation.conic});
    if (straight || !is_off || (off > 0.5 * before && off <= slack_)) break;
    knots = std::move(finer);
  }
  if (!(off <= kImageOff * slack_)) return {};
  curve.length = std::visit([&](const auto& form) { return arc_length(form, part); }, form_);
  if (conic == nullptr) take_for_length(curve);
  return curve;
}

// Turned about its axis to begin where it is cut.
Conic turned_to(const Conic& circle, double t) {
  Conic made = circle;
  made.x = std::cos(t) * circle.x + std::sin(t) * circle.y;
  made.y = std::cos(t) * circle.y - std::sin(t) * circle.x;
  return made;
}

// Ends a closed curve at its first point to the last digit, in space and in each chart where it
// does not go round a period.
void close(const std::array<const ChartSheet*, 2>& sheets, IntersectionCurve& curve) {
  SurfacePoint& last = curve.samples.back();
  const SurfacePoint& first = curve.samples.front();
  curve.curve.points.back() = last.point = first.point;
  const auto close_chart = [](const Vec2& period, const Vec2& start, Vec2& end, auto& chart) {
    for (int d = 0; d < 2; ++d)
      if (period[d] > 0 && std::abs(end[d] - start[d]) > 0.5 * period[d]) return;
    chart.points.back() = end = start;
  };
  close_chart(sheets[0]->period, first.uv_a, last.uv_a, curve.chart_a);
  close_chart(sheets[1]->period, first.uv_b, last.uv_b, curve.chart_b);
}

}  // namespace

std::optional<std::vector<IntersectionCurve>> curves_on_sheets(
    const ClosedForm& form, const Interval& range, const std::vector<double>& nodes,
    const std::array<const ChartSheet*, 2>& sheets, double slack) {
  const Conic* conic = std::get_if<Conic>(&form);
  const bool is_whole = (conic == nullptr || conic->is_closed()) && length(range) >= kTurn;
  Interval whole = range;
  FormImages all(form, sheets, slack);
  std::vector<double> from_nodes = nodes, cuts = all.cuts(whole, nodes);
  if (is_whole && !cuts.empty()) {
    // Begun there, it may turn out to be cut where it began before.
    // Rounded so that the whole is as long as a turn to the last digit.
    const double start = (cuts.front() + length(range)) - length(range);
    if (conic != nullptr && conic->kind == ConicKind::Circle) {
      all = FormImages(turned_to(*conic, start), sheets, slack);
      for (double& node : from_nodes) node -= start;
    } else {
      whole = {start, start + length(range)};
    }
    cuts = all.cuts(whole, from_nodes);
  }
  // Through a pole it comes to another place of the chart than it goes from.
  const bool closed = is_whole && cuts.empty() && !all.is_pole(whole.from);
  std::vector<IntersectionCurve> curves;
  for (Interval part : parts_of(whole, cuts)) {
    if (is_whole && part.from >= range.to)
      part = {part.from - length(range), part.to - length(range)};
    auto curve = all.curve_on(part);
    if (!curve) return {};
    curve->closed = closed;
    curve->ends.fill(closed ? CurveEnd::Closed : CurveEnd::BorderA);
    if (closed) close(sheets, *curve);
    curves.push_back(*std::move(curve));
  }
  return curves;
}

}  // namespace blossom::occt
