// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/ball_strip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/blending/balls/chart_cell.h"
#include "core/blending/balls/detail/analytic_strip.h"
#include "core/blending/balls/detail/row_spline.h"
#include "core/blending/balls/detail/strip_section.h"
#include "core/blending/balls/limits.h"
#include "core/tracing/deviation.h"

namespace blossom {
namespace {

constexpr int kSamples = 8;  // of a span
constexpr std::array kChecks{0.03, 0.2, 0.4, 0.6, 0.8, 0.97};
constexpr std::array kSectionChecks{0.125, 0.25, 0.5, 0.75, 0.875};
constexpr double kShare = 0.7;  // of what is wanted, that checks may find
constexpr double kWide = -0.5;  // cosine of a section's angle, below: degree 4
// Halving a span divides what it is off by 2^5 to 2^6 in the end, and by less while it is long. A
// span that is off by more than two halvings can mend even so is halved twice at once.
constexpr double kTwice = 0x1p16;
constexpr double kUneven = 2.001;     // ratio of neighbouring spans, more is halved
constexpr double kSameBreak = 1e-9;   // of the range: a law's knot and a border of patches are one
constexpr double kSameRate = 1e-8;    // relative: no kink
constexpr double kFading = 0.4306;    // of errors beside a step, by span: the quintic cardinal root
constexpr double kBesideStep = 0.25;  // of the radius: spans beside a step are no shorter
constexpr double kNoWidth = 1e-9;     // of the radius: a section without a direction
constexpr double kRateStep = 1e-3;    // of the domain, for the derivative where a loop closes

struct Check {
  BallPoint ball;
  CharacteristicCircle circle;
  std::array<Vec4, kMaxRows> rows;
};

// A span with its samples; they are made once.
struct FitSpan {
  Interval place;
  std::vector<double> parameters, values;
  std::vector<Check> checks;
};

// The parameters of a contact in its support's surface: those of an edge are in v = 0.
Vec2 place_of(const BallSupport& support, const Vec2& chart) {
  return support.is_edge ? Vec2{chart[0], 0} : chart;
}

// By how much a ball jumps over a slight crease of a support: no whole strip comes nearer to both.
struct Jump {
  double parameter = 0, gap = 0, angle = 0, shortest = 0;  // the last of spans beside it
};

struct Measured {  // at the checks of a span
  std::array<double, 2> gap{}, angle{};
  double section = 0;
};

struct KnownSpans {
  std::vector<FitSpan> spans;
  bool wide = false;  // their sections are
};

class StripFitter {
 public:
  /// known   spans of another range of the track, for the same options
  StripFitter(const BallTrack& track, const Interval& range, const BallStripOptions& options,
              KnownSpans known);

  BallStrip strip();
  KnownSpans spans() && { return {std::move(spans_), form_.wide}; }

 private:
  std::size_t columns() const { return 4 * static_cast<std::size_t>(form_.rows()) + 4; }
  std::vector<double> values_at(double parameter, bool after) const;
  std::vector<double> closing_rate() const;
  FitSpan span_of(const Interval& place) const;
  void begin_between(const Interval& breaks, std::vector<FitSpan>& known);
  int multiplicity_at(double knot) const;
  void fit();
  Measured measured(std::size_t span) const;
  void add_jump(double parameter);
  double excess(std::size_t span) const;
  bool refine();
  void level();
  void split(std::size_t span, int times);
  void write_surface(BallStrip& strip) const;
  void write_contact(std::size_t k, BallStrip& strip) const;

  const BallTrack& track_;
  Interval range_;
  BallStripOptions options_;
  SectionForm form_;
  bool closed_ = false;
  std::vector<FitSpan> spans_;
  std::vector<Measured> found_;  // of each, by the last look at all
  std::vector<Jump> jumps_;
  RowSpline spline_;
};

StripFitter::StripFitter(const BallTrack& track, const Interval& range,
                         const BallStripOptions& options, KnownSpans known)
    : track_(track), range_(range), options_(options), form_{options.section, options.rho, false} {
  double least = 1;
  std::vector<double> breaks{range.from};
  for (const BallTrack::Node& node : track.nodes()) {
    if (node.parameter <= range.from || node.parameter >= range.to) continue;
    const double room = std::min(node.parameter - breaks.back(), range.to - node.parameter);
    if (node.is_break && room > kSameBreak * length(range)) {
      breaks.push_back(node.parameter);
      add_jump(node.parameter);
    }
    const CharacteristicCircle c = characteristic_circle(track.at(node.parameter));
    least = std::min(least, dot(c.to_contact[0], c.to_contact[1]));
  }
  breaks.push_back(range.to);
  for (const double end : {range.from, range.to}) {
    const CharacteristicCircle c = characteristic_circle(track.at(end));
    least = std::min(least, dot(c.to_contact[0], c.to_contact[1]));
  }
  form_.wide = options.section == SectionKind::Circle && least < kWide;
  const Interval domain = track.domain();
  closed_ = track.closed() && range.from == domain.from && range.to == domain.to;
  if (known.wide != form_.wide) known.spans.clear();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    begin_between({breaks[i], breaks[i + 1]}, known.spans);
  if (!known.spans.empty()) level();
}

// The known spans between two breaks, and one more at each end where they do not reach it. Known
// ones that would leave less than half of their length there are a part of that one.
void StripFitter::begin_between(const Interval& breaks, std::vector<FitSpan>& known) {
  const auto is_inside = [&](const FitSpan& span) {
    return span.place.from >= breaks.from && span.place.to <= breaks.to;
  };
  auto first = std::ranges::find_if(known, is_inside);
  auto last = std::find_if_not(first, known.end(), is_inside);
  const auto is_sliver = [](double gap, const FitSpan& beside) {
    return gap > 0 && gap < 0.5 * length(beside.place);
  };
  if (first != last && is_sliver(first->place.from - breaks.from, *first)) ++first;
  if (first != last && is_sliver(breaks.to - std::prev(last)->place.to, *std::prev(last))) --last;
  if (first == last) {
    spans_.push_back(span_of(breaks));
    return;
  }
  const Interval middle{first->place.from, std::prev(last)->place.to};
  if (breaks.from < middle.from) spans_.push_back(span_of({breaks.from, middle.from}));
  spans_.insert(spans_.end(), std::make_move_iterator(first), std::make_move_iterator(last));
  if (middle.to < breaks.to) spans_.push_back(span_of({middle.to, breaks.to}));
}

std::vector<double> StripFitter::values_at(double parameter, bool after) const {
  const BallPoint ball = track_.at(parameter, after);
  const auto rows = section_rows(track_, ball, form_);
  std::vector<double> values;
  values.reserve(columns());
  for (int r = 0; r < form_.rows(); ++r)
    for (int k = 0; k < 4; ++k) values.push_back(rows[static_cast<std::size_t>(r)][k]);
  for (const BallContact& contact : ball.contacts)
    for (int k = 0; k < 2; ++k) values.push_back(contact.chart[k]);
  return values;
}

// By the central difference of order four; charts go on by whole periods.
std::vector<double> StripFitter::closing_rate() const {
  const double h = kRateStep * length(range_);
  const std::vector<double> first = values_at(range_.from, true),
                            last = values_at(range_.to, false);
  std::vector<double> rate(columns(), 0);
  for (const auto& [step, weight] : {std::pair{1, 8.0}, std::pair{2, -1.0}}) {
    const std::vector<double> after = values_at(range_.from + step * h, true),
                              before = values_at(range_.to - step * h, false);
    for (std::size_t c = 0; c < rate.size(); ++c)
      rate[c] += weight * ((after[c] - first[c]) - (before[c] - last[c])) / (12 * h);
  }
  return rate;
}

FitSpan StripFitter::span_of(const Interval& place) const {
  FitSpan span{place, {}, {}, {}};
  for (int i = 0; i < kSamples; ++i) {
    const double t = 0.5 - 0.5 * std::cos((i + 0.5) * std::numbers::pi / kSamples);
    span.parameters.push_back(at(place, t));
    const std::vector<double> values = values_at(span.parameters.back(), true);
    span.values.insert(span.values.end(), values.begin(), values.end());
  }
  for (const double t : kChecks) {
    const BallPoint ball = track_.at(at(place, t));
    span.checks.push_back({ball, characteristic_circle(ball), section_rows(track_, ball, form_)});
  }
  return span;
}

// 1 inside of a smooth run, 4 where second derivatives jump, 5 at a kink.
int StripFitter::multiplicity_at(double knot) const {
  int most = 1;
  for (const BallTrack::Node& node : track_.nodes()) {
    if (!node.is_break || std::abs(node.parameter - knot) > kSameBreak * length(range_)) continue;
    const double size = std::max(max_norm(node.first[0]), max_norm(node.first[1]));
    most = std::max(most, max_norm(node.first[0] - node.first[1]) <= kSameRate * size ? 4 : 5);
  }
  return most;
}

void StripFitter::fit() {
  std::vector<double> knots{range_.from};
  std::vector<int> multiplicities{kRowDegree + 1};
  RowSamples samples;
  for (const FitSpan& span : spans_) {
    knots.push_back(span.place.to);
    multiplicities.push_back(multiplicity_at(span.place.to));
    samples.parameters.insert(samples.parameters.end(), span.parameters.begin(),
                              span.parameters.end());
    samples.values.insert(samples.values.end(), span.values.begin(), span.values.end());
  }
  multiplicities.back() = kRowDegree + 1;
  samples.ends = {values_at(range_.from, true), values_at(range_.to, false)};
  if (closed_) {
    // The end is the start, bit for bit but for the charts' periods.
    const auto rows = static_cast<std::ptrdiff_t>(columns() - 4);
    std::copy_n(samples.ends[0].begin(), rows, samples.ends[1].begin());
    const auto &first = track_.nodes().front(), &last = track_.nodes().back();
    const double size = max_norm(first.first[1]);
    if (!first.is_break && max_norm(first.first[1] - last.first[0]) <= kSameRate * size)
      samples.rates = {closing_rate(), closing_rate()};
  }
  spline_ = least_squares_rows(knots, multiplicities, samples);
}

Measured StripFitter::measured(std::size_t span) const {
  Measured m;
  std::vector<double> value(columns()), rate(columns());
  const auto row_count = static_cast<std::size_t>(form_.rows());
  for (const Check& check : spans_[span].checks) {
    evaluate(spline_, span, check.ball.parameter, value, rate);
    std::array<Vec4, kMaxRows> rows{};
    for (std::size_t r = 0; r < row_count; ++r) {
      for (int k = 0; k < 4; ++k) rows[r][k] = value[4 * r + static_cast<std::size_t>(k)];
      if (!form_.has_weight(static_cast<int>(r))) rows[r][3] = 1;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const BallSupport& support = track_.supports()[k];
      const BezierSurface& surface = *support.surface;
      const std::size_t row = k == 0 ? 0 : row_count - 1, next = k == 0 ? 1 : row_count - 2;
      const Vec2 chart =
          place_of(support, {value[4 * row_count + 2 * k], value[4 * row_count + 2 * k + 1]});
      const PatchJet s = chart_jet(surface, cell_at(surface, chart), chart, 1);
      const Vec3 point = projected(rows[row]), across = projected(rows[next]) - point;
      m.gap[k] = std::max(m.gap[k], distance(s.point, point));
      if (form_.kind == SectionKind::Chamfer || norm(across) <= kNoWidth * check.ball.radius)
        continue;
      const Vec3 along{rate[4 * row], rate[4 * row + 1], rate[4 * row + 2]};
      const Vec3 normal = cross(along, across),
                 wanted = support.is_edge ? check.ball.contacts[k].normal : cross(s.u, s.v);
      const double angle = std::atan2(norm(cross(normal, wanted)), std::abs(dot(normal, wanted)));
      m.angle[k] = std::max(m.angle[k], angle);
    }
    for (const double v : kSectionChecks) {
      const Vec3 point = section_point(rows, form_, v);
      const double off = form_.kind == SectionKind::Circle
                             ? std::abs(distance(point, check.circle.centre) - check.circle.radius)
                             : distance(point, section_point(check.rows, form_, v));
      m.section = std::max(m.section, off);
    }
  }
  return m;
}

void StripFitter::add_jump(double parameter) {
  const BallPoint before = track_.at(parameter, false), after = track_.at(parameter, true);
  Jump jump{parameter, distance(before.centre, after.centre), 0,
            kBesideStep * after.radius / norm(after.centre_rate)};
  for (std::size_t k = 0; k < 2; ++k) {
    const BallContact &a = before.contacts[k], &b = after.contacts[k];
    jump.gap = std::max(jump.gap, distance(a.point, b.point));
    jump.angle =
        std::max(jump.angle, std::atan2(norm(cross(a.normal, b.normal)), dot(a.normal, b.normal)));
  }
  const bool shows = jump.gap > kShare * options_.gap || jump.angle > kShare * options_.angle;
  if (shows) jumps_.push_back(jump);
}

// Of a span, what is found over what may be: at most 1 where it is good. Steps h turn it by h / l.
double StripFitter::excess(std::size_t span) const {
  const Interval& place = spans_[span].place;
  double gap = options_.gap, angle = options_.angle;
  for (const Jump& jump : jumps_) {
    const auto away = std::ranges::count_if(spans_, [&](const FitSpan& other) {
      return (other.place.from >= jump.parameter && other.place.to <= place.from) ||
             (other.place.from >= place.to && other.place.to <= jump.parameter);
    });
    const double share = length(place) <= jump.shortest ? std::pow(kFading, double(away)) : 0;
    gap += share * jump.gap;
    angle += share * (jump.angle + jump.gap / length(place));
  }
  const Measured& m = found_[span];
  const double off = std::max({m.gap[0], m.gap[1], m.section});
  return std::max(off / gap, std::max(m.angle[0], m.angle[1]) / angle) / kShare;
}

// Halved so many times.
void StripFitter::split(std::size_t span, int times) {
  const Interval whole = spans_[span].place;
  const int count = 1 << times;
  std::vector<FitSpan> parts;
  for (int i = 0; i < count; ++i) {
    const auto knot = [&](int k) {
      return k == count ? whole.to : at(whole, static_cast<double>(k) / count);
    };
    parts.push_back(span_of({knot(i), knot(i + 1)}));
  }
  const auto place = spans_.erase(spans_.begin() + static_cast<std::ptrdiff_t>(span));
  spans_.insert(place, std::make_move_iterator(parts.begin()),
                std::make_move_iterator(parts.end()));
}

// Neighbours differ in length by a factor of 2 at most, also at breaks, where they have values and
// mostly rates in common: the error of a coarse span spreads into fine ones, where it is divided by
// their length.
void StripFitter::level() {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i + 1 < spans_.size(); ++i) {
      const double ratio = length(spans_[i].place) / length(spans_[i + 1].place);
      if (ratio > kUneven || ratio < 1 / kUneven) {
        split(ratio > 1 ? i : i + 1, 1);
        changed = true;
      }
    }
  }
}

// Halves the spans that are not good enough; false if there is none.
bool StripFitter::refine() {
  std::vector<int> times(spans_.size());
  found_.clear();
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    found_.push_back(measured(i));
    const double excess = this->excess(i);
    if (excess <= 1) continue;
    times[i] = excess > kTwice ? 2 : 1;
  }
  bool changed = false;
  for (std::size_t i = spans_.size(); i-- > 0;)
    if (times[i] > 0) {
      split(i, times[i]);
      changed = true;
    }
  if (changed) level();
  return changed;
}

void StripFitter::write_surface(BallStrip& strip) const {
  const int rows = form_.rows(), degree = form_.degree();
  BezierSurface& surface = strip.surface;
  surface.u_knots = spline_.knots;
  surface.v_knots = {0, 1};
  surface.closed_u = closed_;
  surface.rational = form_.kind == SectionKind::Circle || form_.kind == SectionKind::Conic;
  const int spans = static_cast<int>(spline_.knots.size()) - 1;
  surface.patches = Grid<RationalBezierPatch>(
      spans, 1, RationalBezierPatch{Grid<Vec4>(kRowDegree + 1, degree + 1)});
  const auto point_of = [&](const std::vector<double>& from, std::size_t pole, int row) {
    Vec4 p;
    for (int k = 0; k < 4; ++k)
      p[k] = from[pole * columns() + static_cast<std::size_t>(4 * row + k)];
    if (!form_.has_weight(row)) p[3] = 1;
    return p;
  };
  for (int i = 0; i < spans; ++i) {
    const std::vector<double> bezier = bezier_points(spline_, static_cast<std::size_t>(i));
    for (int p = 0; p <= kRowDegree; ++p)
      for (int q = 0; q <= degree; ++q) {
        Grid<Vec4>& points = surface.patches(i, 0).points;
        points(p, q) = point_of(bezier, static_cast<std::size_t>(p), q);
        // Neighbours share their borders bit for bit.
        if (p == 0 && i > 0) points(p, q) = surface.patches(i - 1, 0).points(kRowDegree, q);
      }
  }
  strip.knots = spline_.knots;
  strip.multiplicities = spline_.multiplicities;
  const auto count = spline_.pole_count();
  strip.poles = Grid<Vec4>(static_cast<int>(count), rows);
  for (std::size_t i = 0; i < count; ++i)
    for (int r = 0; r < rows; ++r)
      strip.poles(static_cast<int>(i), r) = point_of(spline_.poles, i, r);
}

// The largest distance of a contact's row from its chart's image, proven if it may be: the curve
// has to be in one period of the surface.
void prove_gap(const BezierSurface& surface, StripContactCurve& contact) {
  IntersectionCurve curve;
  curve.curve = contact.row;
  curve.chart_a = contact.chart;
  for (int d = 0; d < 2; ++d) {
    const std::vector<double>& knots = d == 0 ? surface.u_knots : surface.v_knots;
    const double first = knots.front(), last = knots.back();
    double low = kUnbounded, high = -kUnbounded;
    for (const Vec2& p : contact.chart.points)
      low = std::min(low, p[d]), high = std::max(high, p[d]);
    if (d == 0 ? surface.closed_u : surface.closed_v) {
      const double period = last - first;
      const double shift = -period * std::floor((low - first) / period + kRangeSlack);
      for (Vec2& p : curve.chart_a.points) p[d] += shift;
      low += shift;
      high += shift;
    }
    const double slack = kRangeSlack * (last - first);
    contact.proven = low >= first - slack && high <= last + slack;
    if (!contact.proven) return;
  }
  curve.chart_b = curve.chart_a;
  const Deviation deviation = proven_deviation(curve, surface, surface);
  contact.proven = deviation.proven;
  contact.gap = std::max(contact.gap, deviation.a);
}

void StripFitter::write_contact(std::size_t k, BallStrip& strip) const {
  StripContactCurve& contact = strip.contacts[k];
  contact.chart.degree = contact.row.degree = kRowDegree;
  contact.chart.knots = contact.row.knots = spline_.knots;
  contact.chart.multiplicities = contact.row.multiplicities = spline_.multiplicities;
  const auto rows = static_cast<std::size_t>(form_.rows());
  const std::size_t row = k == 0 ? 0 : rows - 1;
  for (std::size_t i = 0; i < spline_.pole_count(); ++i) {
    const double* pole = spline_.poles.data() + i * columns();
    contact.row.points.push_back({pole[4 * row], pole[4 * row + 1], pole[4 * row + 2]});
    contact.chart.points.push_back(
        place_of(track_.supports()[k], {pole[4 * rows + 2 * k], pole[4 * rows + 2 * k + 1]}));
  }
  prove_gap(*track_.supports()[k].surface, contact);
}

BallStrip StripFitter::strip() {
  fit();
  bool is_good = false;
  while (!is_good && static_cast<int>(spans_.size()) <= options_.most_spans)
    if (is_good = !refine(); !is_good) fit();
  BallStrip strip;
  strip.closed = closed_;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Measured m = is_good ? found_[i] : measured(i);
    strip.section_error = std::max(strip.section_error, m.section);
    for (std::size_t k = 0; k < 2; ++k) {
      StripContactCurve& contact = strip.contacts[k];
      contact.gap = std::max(contact.gap, m.gap[k]);
      contact.normal_angle = std::max(contact.normal_angle, m.angle[k]);
    }
  }
  write_surface(strip);
  for (std::size_t k = 0; k < 2; ++k) write_contact(k, strip);
  if (form_.kind == SectionKind::Circle) strip.analytic = analytic_strip(track_, range_);
  return strip;
}

}  // namespace

struct StripMaker::Known {
  KnownSpans of;
};

StripMaker::StripMaker(const BallTrack& track, const BallStripOptions& options)
    : track_(track), options_(options), known_(std::make_unique<Known>()) {
  if (!(options.rho > 0 && options.rho < 1))
    throw InvalidInput("ball_strip: rho has to be in (0, 1), got " + std::to_string(options.rho));
  if (!(options.gap > 0) || !(options.angle > 0))
    throw InvalidInput("ball_strip: gap and angle have to be positive");
  if (takes_curvature(options.section) &&
      (track.supports()[0].is_edge || track.supports()[1].is_edge))
    throw InvalidInput("ball_strip: an edge has no curvature that a section could have");
}

StripMaker::~StripMaker() = default;

BallStrip StripMaker::strip(const Interval& range) {
  const Interval domain = track_.domain();
  if (!(length(range) > 0) || range.from < domain.from || range.to > domain.to)
    throw InvalidInput("ball_strip: the range is empty or leaves the track");
  StripFitter fitter(track_, range, options_, std::exchange(known_->of, {}));
  BallStrip made = fitter.strip();
  known_->of = std::move(fitter).spans();
  return made;
}

BallStrip ball_strip(const BallTrack& track, const Interval& range,
                     const BallStripOptions& options) {
  return StripMaker(track, options).strip(range);
}

}  // namespace blossom
