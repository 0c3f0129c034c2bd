// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/arrays.h"

namespace py = pybind11;

namespace blossom::python {

py::dict spline_record(const Handle(Geom_BSplineCurve) & curve) {
  using namespace py::literals;
  std::vector<Vec3> poles;
  std::vector<double> weights, knots;
  std::vector<int> multiplicities;
  for (int i = 1; i <= curve->NbPoles(); ++i) {
    const gp_Pnt pole = curve->Pole(i);
    poles.push_back({pole.X(), pole.Y(), pole.Z()});
    weights.push_back(curve->Weight(i));
  }
  for (int i = 1; i <= curve->NbKnots(); ++i) {
    knots.push_back(curve->Knot(i));
    multiplicities.push_back(curve->Multiplicity(i));
  }
  return py::dict(
      "degree"_a = curve->Degree(), "poles"_a = points_array(std::span<const Vec3>(poles)),
      "weights"_a = curve->IsRational() ? py::object(numbers_array(weights)) : py::none(),
      "knots"_a = numbers_array(knots), "multiplicities"_a = numbers_array(multiplicities));
}

}  // namespace blossom::python
