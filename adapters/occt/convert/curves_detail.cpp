// SPDX-License-Identifier: LGPL-2.1-or-later
// Knots, homogeneous points and checks, shared by curves and surfaces.

#include "adapters/occt/convert/curves_detail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/limits.h"

namespace blossom::occt {
namespace {

double weighted(double x, double weight) {
  const double product = x * weight;
  if (product / weight == x) return product;
  for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
    const double neighbour = std::nextafter(product, towards);
    if (neighbour / weight == x) return neighbour;
  }
  return product;
}

}  // namespace

TColStd_Array1OfReal knot_array(const std::vector<double>& knots) {
  TColStd_Array1OfReal array(1, static_cast<int>(knots.size()));
  std::copy(knots.begin(), knots.end(), array.begin());
  return array;
}

Vec4 homogeneous(const gp_Pnt& point, double weight) {
  if (weight == 1) return with_weight(vec(point), 1);
  return {weighted(point.X(), weight), weighted(point.Y(), weight), weighted(point.Z(), weight),
          weight};
}

gp_Pnt euclidean(const Vec4& point) {
  const double w = point[3];
  return w == 1 ? gp_Pnt(point[0], point[1], point[2])
                : gp_Pnt(point[0] / w, point[1] / w, point[2] / w);
}

FlatKnots flat_knots(int degree, const TColStd_Array1OfReal& knots,
                     const TColStd_Array1OfInteger& multiplicities, bool periodic) {
  return {degree,
          {&knots.First(), static_cast<std::size_t>(knots.Length())},
          {&multiplicities.First(), static_cast<std::size_t>(multiplicities.Length())},
          periodic};
}

std::vector<FlatKnots::Span> spans_in(const FlatKnots& knots, const Interval& range) {
  std::vector<FlatKnots::Span> spans = knots.spans(range);
  if (spans.empty()) throw BadModel("the range lies outside of the knots");
  return spans;
}

Interval checked_range(const Interval& range, const Interval& natural, const std::string& what) {
  const auto text = [](const Interval& i) {
    return "[" + std::to_string(i.from) + ", " + std::to_string(i.to) + "]";
  };
  if (!std::isfinite(range.from) || !std::isfinite(range.to) ||
      std::abs(range.from) > kFarthestPlace || std::abs(range.to) > kFarthestPlace)
    throw BadModel(what + " is not finite");
  if (!(range.from < range.to)) throw BadModel(what + " is empty: " + text(range));
  const double slack = kRangeRounding * length(range);
  if (range.from < natural.from - slack || range.to > natural.to + slack)
    throw BadModel(what + ", " + text(range) + ", leaves the natural bounds " + text(natural));
  const Interval inside{std::max(range.from, natural.from), std::min(range.to, natural.to)};
  if (!(inside.from < inside.to)) throw BadModel(what + " is empty: " + text(range));
  return inside;
}

bool is_bounded(const gp_XYZ& point) {
  return std::abs(point.X()) < kFarthestPlace && std::abs(point.Y()) < kFarthestPlace &&
         std::abs(point.Z()) < kFarthestPlace;
}

void check_bounded(const gp_XYZ& point, const std::string& what) {
  if (!is_bounded(point)) throw BadModel(what + " is not finite");
}

bool is_finite(const gp_XYZ& point) {
  return std::isfinite(point.X()) && std::isfinite(point.Y()) && std::isfinite(point.Z());
}

void check_finite(const gp_XYZ& point, const std::string& what) {
  if (!is_finite(point)) throw BadModel(what + " is not finite");
}

void check_weight(double weight, const std::string& what) {
  if (!std::isfinite(weight) || weight <= 0)
    throw BadModel(what + " is " + std::to_string(weight) + ", weights must be positive");
}

void WeightRange::add(double weight) {
  least_ = std::min(least_, weight);
  most_ = std::max(most_, weight);
}

void WeightRange::check() const {
  if (!(std::numeric_limits<double>::epsilon() * most_ > least_)) return;
  std::ostringstream text;
  text << "its weights go from " << least_ << " to " << most_
       << ", and the lightest point is lost in roundings of the heaviest";
  throw BadModel(text.str());
}

}  // namespace blossom::occt
