// SPDX-License-Identifier: LGPL-2.1-or-later
// Points as arrays of numpy.

#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <Geom_BSplineCurve.hxx>

#include "core/math/vec.h"

namespace blossom::python {

/// Nobody writes into an answer.
inline pybind11::array read_only(pybind11::array array) {
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

template <class Point, int Dim>
pybind11::array points_array(const std::vector<Point>& list, Vec<double, Dim> Point::*member) {
  pybind11::array_t<double> made(
      {static_cast<pybind11::ssize_t>(list.size()), static_cast<pybind11::ssize_t>(Dim)});
  double* to = made.mutable_data();
  for (const Point& point : list) to = std::copy_n((point.*member).coordinates.begin(), Dim, to);
  return read_only(std::move(made));
}

template <int Dim>
pybind11::array points_array(std::span<const Vec<double, Dim>> list) {
  pybind11::array_t<double> made(
      {static_cast<pybind11::ssize_t>(list.size()), static_cast<pybind11::ssize_t>(Dim)});
  double* to = made.mutable_data();
  for (const Vec<double, Dim>& point : list) to = std::copy_n(point.coordinates.begin(), Dim, to);
  return read_only(std::move(made));
}

template <int Dim>
pybind11::array point_array(const Vec<double, Dim>& point) {
  pybind11::array_t<double> made(Dim);
  std::copy_n(point.coordinates.begin(), Dim, made.mutable_data());
  return read_only(std::move(made));
}

template <class Number>
pybind11::array numbers_array(const std::vector<Number>& list) {
  return read_only(
      pybind11::array_t<Number>(static_cast<pybind11::ssize_t>(list.size()), list.data()));
}

/// "degree", "poles" (n + 1, 3), "weights" or None, "knots", "multiplicities".
pybind11::dict spline_record(const Handle(Geom_BSplineCurve) & curve);

}  // namespace blossom::python
