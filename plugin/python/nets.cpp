// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/nets.h"

#include <cmath>
#include <numeric>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/base/errors.h"
#include "core/base/tolerances.h"

namespace py = pybind11;

namespace blossom::python {
namespace {

std::string shape_text(const Net& net) {
  std::string shape;
  for (py::ssize_t i = 0; i < net.ndim(); ++i)
    shape += (i == 0 ? "" : ", ") + std::to_string(net.shape(i));
  return "(" + shape + (net.ndim() == 1 ? ",)" : ")");
}

// That it has so many directions of at least one point, and three or four numbers a point.
void check_shape(const Net& net, py::ssize_t directions, const char* wanted,
                 const std::string& name) {
  bool good = net.ndim() == directions + 1;
  for (py::ssize_t i = 0; good && i < directions; ++i) good = net.shape(i) >= 1;
  if (!good || (net.shape(directions) != 3 && net.shape(directions) != 4))
    throw InvalidInput(name + ": a net has the shape " + wanted + ", got " + shape_text(net));
}

bool has_weights(const Net& net) { return net.shape(net.ndim() - 1) == 4; }

void check_numbers(const double* numbers, py::ssize_t count, const std::string& name) {
  for (py::ssize_t i = 0; i < count; ++i)
    if (!std::isfinite(numbers[i])) throw InvalidInput(name + ": a number is not finite");
}

double checked_weight(double weight, const std::string& name) {
  if (!(weight > 0)) throw InvalidInput(name + ": a weight is not positive");
  return weight;
}

// That knots and degree ask for as many points as there are.
void check_knots(const KnotVector& v, py::ssize_t points, const std::string& name) {
  if (v.degree < 1 || v.degree > Geom_BSplineCurve::MaxDegree())
    throw InvalidInput(name + ": the degree is 1 to " +
                       std::to_string(Geom_BSplineCurve::MaxDegree()) + ", got " +
                       std::to_string(v.degree));
  check_numbers(v.knots.data(), static_cast<py::ssize_t>(v.knots.size()), name);
  if (v.knots.size() < 2 || v.knots.size() != v.multiplicities.size())
    throw InvalidInput(name + ": there are " + std::to_string(v.knots.size()) + " knots and " +
                       std::to_string(v.multiplicities.size()) +
                       " multiplicities; two or more of both are wanted, as many of one as of the "
                       "other");
  for (std::size_t i = 0; i < v.knots.size(); ++i) {
    const bool end = i == 0 || i + 1 == v.knots.size();
    if (i > 0 && !(v.knots[i - 1] < v.knots[i]))
      throw InvalidInput(name + ": knots do not increase");
    if (v.multiplicities[i] < 1 || v.multiplicities[i] > v.degree + (end ? 1 : 0))
      throw InvalidInput(name + ": a multiplicity is 1 to the degree, at the ends one more; got " +
                         std::to_string(v.multiplicities[i]));
  }
  const int sum = std::accumulate(v.multiplicities.begin(), v.multiplicities.end(), 0);
  if (sum != points + v.degree + 1)
    throw InvalidInput(name + ": the multiplicities sum up to " + std::to_string(sum) + ", " +
                       std::to_string(points) + " points of degree " + std::to_string(v.degree) +
                       " take " + std::to_string(points + v.degree + 1));
}

struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;

  explicit Knots(const KnotVector& v)
      : values(1, static_cast<int>(v.knots.size())),
        multiplicities(1, static_cast<int>(v.knots.size())) {
    for (int i = 1; i <= values.Upper(); ++i) {
      values(i) = v.knots[static_cast<std::size_t>(i) - 1];
      multiplicities(i) = v.multiplicities[static_cast<std::size_t>(i) - 1];
    }
  }
};

BezierSurface surface_of(const Net& net, const std::string& name) {
  const auto read = net.unchecked<3>();
  BezierSurface surface;
  surface.u_knots = surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4>& points = surface.patches(0, 0).points;
  points = Grid<Vec4>(static_cast<int>(net.shape(0)), static_cast<int>(net.shape(1)));
  for (py::ssize_t i = 0; i < net.shape(0); ++i)
    for (py::ssize_t j = 0; j < net.shape(1); ++j) {
      const double w = net.shape(2) == 4 ? read(i, j, 3) : 1;
      points(static_cast<int>(i), static_cast<int>(j)) = {w * read(i, j, 0), w * read(i, j, 1),
                                                          w * read(i, j, 2), w};
      surface.rational |= w != 1;
    }
  validate(surface, name.c_str());
  return surface;
}

TopoDS_Face face_on(const Handle(Geom_Surface) & surface, const std::string& name) {
  return occt::guarded("making a face of the net " + name, [&] {
    BRepBuilderAPI_MakeFace maker(surface, Tolerances{}.point);
    if (!maker.IsDone()) throw InvalidInput(name + ": the net spans no face");
    return maker.Face();
  });
}

}  // namespace

TopoDS_Face bezier_face(const Net& net, const std::string& name) {
  check_shape(net, 2, "(n + 1, m + 1, 3 or 4)", name);
  const BezierSurface surface = surface_of(net, name);
  return face_on(occt::to_occt(surface.patches(0, 0)), name);
}

TopoDS_Face spline_face(const Net& net, const KnotVector& u, const KnotVector& v,
                        const std::string& name) {
  check_shape(net, 2, "(n + 1, m + 1, 3 or 4)", name);
  check_knots(u, net.shape(0), name + ", along u");
  check_knots(v, net.shape(1), name + ", along v");
  const auto read = net.unchecked<3>();
  const int rows = static_cast<int>(net.shape(0)), columns = static_cast<int>(net.shape(1));
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      check_numbers(&read(i, j, 0), net.shape(2), name);
      poles(i + 1, j + 1) = {read(i, j, 0), read(i, j, 1), read(i, j, 2)};
      weights(i + 1, j + 1) = has_weights(net) ? checked_weight(read(i, j, 3), name) : 1;
    }
  const Knots along_u(u), along_v(v);
  const Handle(Geom_BSplineSurface) surface = occt::guarded("making the surface " + name, [&] {
    return Handle(Geom_BSplineSurface)(new Geom_BSplineSurface(
        poles, weights, along_u.values, along_v.values, along_u.multiplicities,
        along_v.multiplicities, u.degree, v.degree));
  });
  return face_on(surface, name);
}

TopoDS_Edge spline_edge(const Net& net, const KnotVector& knots, const std::string& name) {
  check_shape(net, 1, "(n + 1, 3 or 4)", name);
  check_knots(knots, net.shape(0), name);
  const auto read = net.unchecked<2>();
  const int count = static_cast<int>(net.shape(0));
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int i = 0; i < count; ++i) {
    check_numbers(&read(i, 0), net.shape(1), name);
    poles(i + 1) = {read(i, 0), read(i, 1), read(i, 2)};
    weights(i + 1) = has_weights(net) ? checked_weight(read(i, 3), name) : 1;
  }
  const Knots along(knots);
  return occt::guarded("making an edge of the net " + name, [&] {
    const Handle(Geom_BSplineCurve) curve =
        new Geom_BSplineCurve(poles, weights, along.values, along.multiplicities, knots.degree);
    BRepBuilderAPI_MakeEdge maker(curve);
    if (!maker.IsDone()) throw InvalidInput(name + ": the net is a point, not a curve");
    return maker.Edge();
  });
}

TopoDS_Edge bezier_edge(const Net& net, const std::string& name) {
  check_shape(net, 1, "(n + 1, 3 or 4)", name);
  const int degree = static_cast<int>(net.shape(0)) - 1;
  return spline_edge(net, {degree, {0, 1}, {degree + 1, degree + 1}}, name);
}

}  // namespace blossom::python
