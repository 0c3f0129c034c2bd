// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/half_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Bnd_Box.hxx>
#include <ElSLib.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/hulls.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

// A plane with what of it and above it a part may reach.
struct CoveringPlane {
  gp_Pln plane;
  Interval u, v;      // of the rectangle, the plane's own parameters
  double height = 0;  // of the box on it
};

gp_Pln plane_of(const Plane& plane) {
  const double largest = max_norm(plane.normal);
  if (!is_finite(plane.point) || !is_finite(plane.normal) || largest == 0)
    throw BadModel("a plane needs a point and a normal that is not zero, of finite numbers");
  const Vec3 normal = plane.normal * (1 / largest);
  return {gp_Pnt(plane.point[0], plane.point[1], plane.point[2]),
          gp_Dir(normal[0], normal[1], normal[2])};
}

CoveringPlane covering(const Plane& plane, const TopoDS_Shape& part) {
  const Bnd_Box box = bounds_of(part);
  if (box.IsVoid() || box.IsOpen()) throw BadModel("the part has no finite extent");
  const double margin = std::sqrt(box.SquareExtent());
  CoveringPlane found{plane_of(plane), {}, {}, margin};
  const std::array<gp_Pnt, 2> ends{box.CornerMin(), box.CornerMax()};
  for (int i = 0; i < 8; ++i) {
    const gp_Pnt corner(ends[i & 1].X(), ends[i >> 1 & 1].Y(), ends[i >> 2].Z());
    double u = 0, v = 0;
    ElSLib::Parameters(found.plane, corner, u, v);
    const gp_Vec from_plane(found.plane.Location(), corner);
    found.u = {i == 0 ? u : std::min(found.u.from, u), i == 0 ? u : std::max(found.u.to, u)};
    found.v = {i == 0 ? v : std::min(found.v.from, v), i == 0 ? v : std::max(found.v.to, v)};
    found.height =
        std::max(found.height, margin + from_plane.Dot(gp_Vec(found.plane.Axis().Direction())));
  }
  found.u = {found.u.from - margin, found.u.to + margin};
  found.v = {found.v.from - margin, found.v.to + margin};
  return found;
}

TopoDS_Face rectangle(const CoveringPlane& of) {
  return BRepBuilderAPI_MakeFace(of.plane, of.u.from, of.u.to, of.v.from, of.v.to).Face();
}

}  // namespace

TrimTool plane_tool(const Plane& plane, const TopoDS_Shape& part, const std::string& name) {
  return guarded("making a plane", [&] {
    return TrimTool{{rectangle(covering(plane, part))}, {}, name};
  });
}

TrimTool half_space_tool(const Plane& plane, const TopoDS_Shape& part, const std::string& name) {
  return guarded("making a half-space", [&] {
    const CoveringPlane of = covering(plane, part);
    const gp_Vec up = gp_Vec(of.plane.Axis().Direction()) * of.height;
    BRepPrimAPI_MakePrism prism(rectangle(of), up);
    TrimTool tool = solid_tool({TopoDS::Solid(prism.Shape())});
    const auto base = std::ranges::find_if(
        tool.faces, [&](const TopoDS_Face& face) { return face.IsSame(prism.FirstShape()); });
    if (base == tool.faces.end()) throw Failure("a half-space has no face in its plane");
    std::iter_swap(base, tool.faces.begin());
    tool.name = name;
    return tool;
  });
}

}  // namespace blossom::occt
