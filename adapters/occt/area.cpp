// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/area.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "adapters/occt/face_trims.h"
#include "core/math/quadrature.h"

namespace blossom::occt {
namespace {

// Of the rough integral; the integrals' error estimates exceed their errors by far.
constexpr double kRelativeTolerance = 1e-11;
constexpr double kCoordinateRounding = 1e-15;
// Of the size of values: the integral of noise cannot be had any better, and cells as small as a
// thousandth of the tolerance are not to see it.
constexpr double kValueRounding = 1e-12;

// A value, and what its rounding is relative to: more, where it is a difference.
struct Sample {
  double value = 0;
  double size = 0;
};

// What is integrated over the chart: by point and normal S_u x S_v.
using Integrand = std::function<Sample(const gp_Pnt&, const gp_Vec&)>;

// The surface over the box of the trims. The inner integral runs along the direction with fewer
// spans, called x; the other one is y.
class Density {
 public:
  Density(const FaceTrims& trims, Integrand integrand) : integrand_(std::move(integrand)) {
    for (int k = 0; k < 2; ++k) {
      low_[k] = trims.box.low[k] / trims.scale[k];
      high_[k] = trims.box.high[k] / trims.scale[k];
    }
    surface_.Load(BRep_Tool::Surface(trims.face), low_[0], high_[0], low_[1], high_[1]);
    const std::vector<double> u = knots(true), v = knots(false);
    inner_ = u.size() <= v.size() ? 0 : 1;
    x_knots_ = inner_ == 0 ? u : v;
    y_knots_ = inner_ == 0 ? v : u;
    double rough = 0, size = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const Sample sample = sample_at((i + 0.5) / 4, (j + 0.5) / 4);
        rough += std::abs(sample.value) / 16;
        size += sample.size / 16;
      }
    double rounding = kCoordinateRounding * rough;
    for (int k = 0; k < 2; ++k) {
      rough *= high_[k] - low_[k];
      size *= high_[k] - low_[k];
      rounding *= std::max(std::abs(low_[k]), std::abs(high_[k]));
    }
    tolerance_ = std::max({kRelativeTolerance * rough, kValueRounding * size, rounding});
  }

  int inner() const { return inner_; }
  /// For the whole integral: no sum can be better than the coordinates of the trims.
  double tolerance() const { return tolerance_; }
  const std::vector<double>& y_knots() const { return y_knots_; }
  double height() const { return high_[1 - inner_] - low_[1 - inner_]; }

  // F: the integral along x from the left end to `x`, at y. One of the strips that are added up
  // over `height` in y: the lower that is, the less exact it has to be. Where a surface has a span
  // of rounding's width its normals are noise, of which no accuracy can be had.
  double strip(double x, double y, double height, int cells) const {
    auto density = [&](double s) { return inner_ == 0 ? value(s, y) : value(y, s); };
    const double tolerance = tolerance_ / std::max(height, 1e-300);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < x_knots_.size(); ++i) {
      const double to = i + 2 == x_knots_.size() ? x : std::min(x_knots_[i + 1], x);
      if (i > 0 && x_knots_[i] >= x) break;
      for (int k = 0; k < cells; ++k) {
        const double from = x_knots_[i], step = (to - from) / cells;
        sum += integral(density, from + k * step, from + (k + 1) * step, tolerance).value;
      }
    }
    return sum;
  }

 private:
  // Where the surface is less than smooth along u or v.
  std::vector<double> knots(bool along_u) const {
    const int count =
        along_u ? surface_.NbUIntervals(GeomAbs_CN) : surface_.NbVIntervals(GeomAbs_CN);
    TColStd_Array1OfReal ends(1, count + 1);
    if (along_u)
      surface_.UIntervals(ends, GeomAbs_CN);
    else
      surface_.VIntervals(ends, GeomAbs_CN);
    return {ends.begin(), ends.end()};
  }
  Sample sample(double u, double v) const {
    gp_Pnt point;
    gp_Vec du, dv;
    surface_.D1(u, v, point, du, dv);
    return integrand_(point, du.Crossed(dv));
  }
  double value(double u, double v) const { return sample(u, v).value; }
  Sample sample_at(double s, double t) const {
    return sample(low_[0] + s * (high_[0] - low_[0]), low_[1] + t * (high_[1] - low_[1]));
  }

  Integrand integrand_;
  GeomAdaptor_Surface surface_;
  Vec2 low_, high_;
  std::vector<double> x_knots_, y_knots_;  // of the surface inside the box, the box's ends too
  int inner_ = 0;
  double tolerance_ = 0;
};

// What a straight way adds, forward along it: gaps that tolerances leave in the wires.
double across(const Vec2& from, const Vec2& to, const FaceTrims& trims, const Density& density) {
  const int x = density.inner(), y = 1 - x;
  const double dy = (to[y] - from[y]) / trims.scale[y];
  if (dy == 0) return 0;
  auto rate = [&](double t) {
    const Vec2 point = (1 - t) * from + t * to;
    return density.strip(point[x] / trims.scale[x], point[y] / trims.scale[y], std::abs(dy), 1) *
           dy;
  };
  return integral(rate, 0, 1, density.tolerance()).value;
}

// Local parameters of a span at which it crosses a knot line of the surface, with 0 and 1: there
// the integrand is less than smooth. Found between samples; a pair of crossings that none lies
// between is left to the halving of cells.
std::vector<double> breaks(const PlanarBezier& curve, int y, double scale,
                           const std::vector<double>& knots) {
  const int samples = 4 * curve.degree();
  const auto height = [&](double t) { return jet_at(curve, t).point[y] / scale; };
  std::vector<double> at{0, 1};
  for (int i = 0; i < samples; ++i) {
    const double from = static_cast<double>(i) / samples, to = (i + 1.0) / samples;
    const double at_from = height(from), at_to = height(to);
    for (const double knot : knots) {
      if ((at_from < knot) == (at_to < knot)) continue;
      double low = from, high = to;
      for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        ((height(middle) < knot) == (at_from < knot) ? low : high) = middle;
      }
      at.push_back(high);
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

// Along the coedge as the wire walks it, from corner to corner.
double along(const Coedge& coedge, const FaceTrims& trims, const Density& density, int cells) {
  const int x = density.inner(), y = 1 - x;
  const double tolerance = density.tolerance();
  double sum = 0;
  for (const PlanarSpan& span : coedge.curve.spans) {
    auto rate = [&](double t) {
      const PlanarJet jet = jet_at(span.curve, t);
      const double dy = jet.first[y] / trims.scale[y];
      if (dy == 0) return 0.0;
      return density.strip(jet.point[x] / trims.scale[x], jet.point[y] / trims.scale[y],
                           density.height(), cells) *
             dy;
    };
    const std::vector<double> ends = breaks(span.curve, y, trims.scale[y], density.y_knots());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      for (int k = 0; k < cells; ++k)
        sum += integral(rate, at({ends[i], ends[i + 1]}, static_cast<double>(k) / cells),
                        at({ends[i], ends[i + 1]}, (k + 1.0) / cells), tolerance)
                   .value;
  }
  const auto end = [&](bool last) {
    const Interval domain = coedge.curve.domain();
    return point_at(coedge.curve, last != coedge.reversed() ? domain.to : domain.from);
  };
  const auto corner = [&](int i) { return trims.corners[static_cast<std::size_t>(i)]; };
  const double gaps = across(corner(coedge.from), end(false), trims, density) +
                      across(end(true), corner(coedge.to), trims, density);
  // A region on the left of its border has the integral of F dv, but minus that of F du.
  return ((coedge.reversed() ? -sum : sum) + gaps) * (x == 0 ? 1 : -1);
}

double integral_over(const TopoDS_Face& face, const Integrand& integrand, int cells) {
  const FaceTrims trims = face_trims(face);
  const Density density(trims, integrand);
  double sum = 0;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) sum += along(coedge, trims, density, cells);
  return sum;
}

}  // namespace

double area(const TopoDS_Face& face, int cells) {
  return integral_over(
      face,
      [](const gp_Pnt&, const gp_Vec& normal) {
        return Sample{normal.Magnitude(), 0};
      },
      cells);
}

double cone_volume(const TopoDS_Face& face, const Vec3& apex) {
  const gp_Pnt origin(apex[0], apex[1], apex[2]);
  const double volume = integral_over(
      face,
      [&](const gp_Pnt& point, const gp_Vec& normal) {
        const double reach = point.XYZ().Modulus() + origin.XYZ().Modulus();
        return Sample{gp_Vec(origin, point).Dot(normal) / 3, reach * normal.Magnitude() / 3};
      },
      1);
  return face.Orientation() == TopAbs_REVERSED ? -volume : volume;
}

}  // namespace blossom::occt
