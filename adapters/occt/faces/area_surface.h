// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a face as its area is integrated: line by line.

#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/surfaces_detail.h"
#include "core/forms/iso_line.h"
#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom::occt {

// Some numbers that are integrated together, and what the rounding of each is relative to: more,
// where it is a difference.
template <int Count>
struct Sample {
  using Values = Vec<double, Count>;
  Values values;
  Values sizes;
};

// What is integrated over the chart: by point and normal S_u x S_v.
template <int Count>
using Integrand = std::function<Sample<Count>(const Vec3&, const Vec3&)>;

// Along v it is constant where that is a length along parallel straight lines; along u it is
// a + b cos u + c sin u where all turns about one axis with u: points and normals turn alike. On a
// plane it is one constant.
enum class Lines { Any, Even, Turning, Constant };

// The surface of a face, no farther than it goes. Splines, and what is swept from them, are taken
// in Bezier form, since to look up spans and expand them anew for every point takes many times
// longer.
class AreaSurface {
 public:
  AreaSurface(const TopoDS_Face& face, const ParameterBox& box);

  /// Where the surface is less than smooth along u or v, with the ends of the box.
  std::vector<double> knots(Along along) const;

  /// How the density of what is integrated, an area or the volume of a cone, runs along the
  /// surface's own lines.
  Lines lines() const;

 private:
  friend class AreaLine;
  static BezierSurface spans_of(const Handle(Geom_Surface) & surface, const ParameterBox& box);

  ParameterBox box_;
  GeomAdaptor_Surface adaptor_;
  BezierSurface spans_;  // none where the surface itself is as quick, or no exact form is known
};

// A line of the surface along x at a constant y, over the span round some x.
class AreaLine {
 public:
  AreaLine(const AreaSurface& surface, Along along, double y, double x)
      : surface_(surface), along_(along), y_(y) {
    const BezierSurface& spans = surface.spans_;
    if (spans.patches.empty()) return;
    const bool u = along == Along::U;
    const Span of_u(spans.u_knots, spans.u_law, u ? x : y);
    const Span of_v(spans.v_knots, spans.v_law, u ? y : x);
    const Span& across = u ? of_v : of_u;
    x_ = u ? of_u : of_v;
    y_rate_ = across.rate(across.local(y));
    line_.emplace(spans.patches(of_u.number, of_v.number), along, across.local(y));
  }

  template <int Count>
  Sample<Count> sample(const Integrand<Count>& integrand, double x) const {
    if (line_) {
      const double t = x_.local(x);
      const PatchJet jet = line_->jet(t);
      return integrand(jet.point, (x_.rate(t) * y_rate_) * cross(jet.u, jet.v));
    }
    gp_Pnt point;
    gp_Vec du, dv;
    const bool u = along_ == Along::U;
    surface_.adaptor_.D1(u ? x : y_, u ? y_ : x, point, du, dv);
    return integrand(vec(point), vec(du.Crossed(dv).XYZ()));
  }

 private:
  // A span of the knots; the nearest one, as it goes on, for a parameter outside of all.
  struct Span {
    Interval range;
    ParameterLaw law = ParameterLaw::Linear;
    int number = 0;

    Span() = default;
    Span(const std::vector<double>& knots, ParameterLaw of, double parameter) : law(of) {
      const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
      range = {*(after - 1), *after};
      number = static_cast<int>(after - knots.begin()) - 1;
    }
    double local(double parameter) const { return local_parameter(law, range, parameter); }
    // Of the local parameter by the surface's own one.
    double rate(double t) const { return 1 / parameter_derivative(law, range, t); }
  };

  const AreaSurface& surface_;
  Along along_;
  double y_;
  Span x_;
  double y_rate_ = 1;
  std::optional<IsoLine> line_;
};

}  // namespace blossom::occt
