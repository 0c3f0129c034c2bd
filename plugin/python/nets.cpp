// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/nets.h"

#include <sstream>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BinTools.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/base/errors.h"
#include "core/base/tolerances.h"

namespace py = pybind11;

namespace blossom::python {
namespace {

BezierSurface surface_of(const py::array_t<double>& net, const std::string& name) {
  if (net.ndim() != 3 || net.shape(0) < 1 || net.shape(1) < 1 ||
      (net.shape(2) != 3 && net.shape(2) != 4)) {
    std::string shape;
    for (py::ssize_t i = 0; i < net.ndim(); ++i)
      shape += (i == 0 ? "" : ", ") + std::to_string(net.shape(i));
    throw InvalidInput(name + ": a net has the shape (n + 1, m + 1, 3 or 4), got (" + shape + ")");
  }
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

}  // namespace

std::string brep_of_net(const py::array_t<double>& net, const std::string& name) {
  const BezierSurface surface = surface_of(net, name);
  return occt::guarded("making a face of the net " + name, [&] {
    BRepBuilderAPI_MakeFace maker(occt::to_occt(surface.patches(0, 0)), Tolerances{}.point);
    if (!maker.IsDone()) throw InvalidInput(name + ": the net spans no face");
    std::ostringstream out(std::ios::binary);
    BinTools::Write(maker.Face(), out);
    return out.str();
  });
}

}  // namespace blossom::python
