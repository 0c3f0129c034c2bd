// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/adapters/occt/ordinary_solids.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>

namespace blossom::occt::testing {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

int count(Random& random, int from, int to) {
  return std::uniform_int_distribution<int>(from, to)(random);
}

TopTools_IndexedMapOfShape parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map;
}

TopoDS_Shape box(Random& random) {
  return BRepPrimAPI_MakeBox(uniform(random, 8, 20), uniform(random, 8, 20), uniform(random, 8, 20))
      .Shape();
}

gp_Ax2 upright(double x, double y, double z) { return {gp_Pnt(x, y, z), gp::DZ()}; }

TopoDS_Wire polygon(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& p : points) polygon.Add(p);
  polygon.Close();
  return polygon.Wire();
}

// Corners on an ellipse, turned by a random angle.
TopoDS_Wire rounded_polygon(Random& random, int corners, double z) {
  const double a = uniform(random, 5, 10), b = uniform(random, 5, 10);
  const double turn = uniform(random, 0, 0.3);
  std::vector<gp_Pnt> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / corners;
    points.emplace_back(a * std::cos(angle), b * std::sin(angle), z);
  }
  return polygon(points);
}

// --- families

OrdinarySolid filleted_box(Random& random) {
  const TopoDS_Shape shape = box(random);
  const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
  BRepFilletAPI_MakeFillet fillet(shape);
  const double radius = uniform(random, 0.5, 2);
  const int every = count(random, 1, 4);
  for (int i = 1; i <= edges.Extent(); i += every) fillet.Add(radius, TopoDS::Edge(edges(i)));
  return {"a box with fillets", fillet.Shape()};
}

OrdinarySolid chamfered_box(Random& random) {
  const TopoDS_Shape shape = box(random);
  const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
  BRepFilletAPI_MakeChamfer chamfer(shape);
  const double width = uniform(random, 0.5, 2);
  const int every = count(random, 1, 4);
  for (int i = 1; i <= edges.Extent(); i += every) chamfer.Add(width, TopoDS::Edge(edges(i)));
  return {"a box with chamfers", chamfer.Shape()};
}

OrdinarySolid loft(Random& random) {
  const int corners = count(random, 3, 6), sections = count(random, 3, 5);
  BRepOffsetAPI_ThruSections loft(true, false);
  double z = 0;
  for (int i = 0; i < sections; ++i) {
    loft.AddWire(rounded_polygon(random, corners, z));
    z += uniform(random, 5, 15);
  }
  loft.Build();
  return {"a loft", loft.Shape()};
}

OrdinarySolid bored_ball(Random& random) {
  const double radius = uniform(random, 5, 10);
  TopoDS_Shape shape = BRepPrimAPI_MakeSphere(radius).Shape();
  const int holes = count(random, 1, 3);
  const std::array axes{gp::DZ(), gp::DX(), gp::DY()};
  for (int i = 0; i < holes; ++i) {
    const gp_Dir along = axes[static_cast<std::size_t>(i)];
    const gp_Ax2 axis(gp_Pnt(0, 0, 0).Translated(gp_Vec(along) * (-2 * radius)), along);
    const double bore = uniform(random, 0.15, 0.6) * radius;
    shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCylinder(axis, bore, 4 * radius).Shape());
  }
  return {"a bored ball", shape};
}

OrdinarySolid hollow_box(Random& random) {
  TopoDS_Shape shape = box(random);
  if (count(random, 0, 1) == 1) {
    BRepFilletAPI_MakeFillet fillet(shape);
    const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
    for (int i = 1; i <= 4; ++i) fillet.Add(uniform(random, 1.5, 2.5), TopoDS::Edge(edges(i)));
    shape = fillet.Shape();
  }
  TopTools_ListOfShape open;
  open.Append(parts(shape, TopAbs_FACE)(count(random, 1, 6)));
  BRepOffsetAPI_MakeThickSolid thick;
  thick.MakeThickSolidByJoin(shape, open, -uniform(random, 0.4, 1), 1e-4);
  return {"a hollow box", thick.Shape()};
}

OrdinarySolid plate_with_holes(Random& random) {
  const int rows = count(random, 2, 5), columns = count(random, 2, 5);
  const double pitch = uniform(random, 4, 6), bore = uniform(random, 0.5, 1.5);
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(pitch * (columns + 1), pitch * (rows + 1), 3).Shape();
  const bool stepped = count(random, 0, 1) == 1;
  for (int i = 1; i <= columns; ++i)
    for (int j = 1; j <= rows; ++j) {
      const auto drill = [&](double radius, double from) {
        const gp_Ax2 axis = upright(pitch * i, pitch * j, from);
        shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCylinder(axis, radius, 10).Shape());
      };
      drill(bore, -1);
      if (stepped) drill(1.3 * bore, 2);
    }
  return {"a plate with holes", shape};
}

OrdinarySolid pipe(Random& random) {
  TColgp_Array1OfPnt points(1, 5);
  for (int i = 1; i <= 5; ++i)
    points(i) = gp_Pnt(10.0 * i, uniform(random, -4, 4), uniform(random, -4, 4));
  const Handle(Geom_BSplineCurve) spine = GeomAPI_PointsToBSpline(points).Curve();
  const TopoDS_Wire path = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spine).Edge()).Wire();
  gp_Pnt start;
  gp_Vec along;
  spine->D1(spine->FirstParameter(), start, along);
  const gp_Ax2 axis(start, along);
  TopoDS_Wire profile;
  if (count(random, 0, 1) == 1) {
    const gp_Circ circle(axis, uniform(random, 0.5, 2));
    profile = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire();
  } else {
    const gp_Vec x = gp_Vec(axis.XDirection()) * uniform(random, 0.5, 2);
    const gp_Vec y = gp_Vec(axis.YDirection()) * uniform(random, 0.5, 2);
    profile = polygon({start.Translated(x + y), start.Translated(y - x), start.Translated(-x - y),
                       start.Translated(x - y)});
  }
  return {"a sweep", BRepOffsetAPI_MakePipe(path, BRepBuilderAPI_MakeFace(profile).Face()).Shape()};
}

OrdinarySolid turned_part(Random& random) {
  const double r0 = uniform(random, 0, 1) < 0.5 ? 0 : uniform(random, 1, 3);
  const double r1 = r0 + uniform(random, 2, 4), r2 = r1 + uniform(random, 1, 3);
  const double h = uniform(random, 3, 6);
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](const gp_Pnt& p, const gp_Pnt& q) {
    wire.Add(BRepBuilderAPI_MakeEdge(p, q).Edge());
  };
  const gp_Pnt a(r0, 0, 0), b(r2, 0, 0), c(r2, 0, h), d(r1, 0, h + 2), e(r1, 0, 2 * h + 2),
      f(r0, 0, 2 * h + 2);
  const gp_Pnt bend(0.7 * r2 + 0.3 * r1, 0, h + 1.2);
  line(a, b);
  line(b, c);
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(c, bend, d).Value()).Edge());
  line(d, e);
  line(e, f);
  line(f, a);
  const double angle = count(random, 0, 2) == 0 ? uniform(random, 1, 5) : 2 * std::numbers::pi;
  return {
      "a turned part",
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp::OZ(), angle).Shape()};
}

OrdinarySolid joined_tubes(Random& random) {
  const double r = uniform(random, 2, 4), s = uniform(random, 0.4, 0.95) * r;
  const gp_Ax2 across(gp_Pnt(0, 0, 0), gp_Dir(1, uniform(random, -0.3, 0.3), 0));
  const TopoDS_Shape outer =
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(upright(0, 0, -10), r, 20).Shape(),
                       BRepPrimAPI_MakeCylinder(across, s, 12).Shape());
  const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(upright(0, 0, -11), 0.7 * r, 22).Shape();
  const TopoDS_Shape side = BRepPrimAPI_MakeCylinder(across, 0.6 * s, 13).Shape();
  return {"joined tubes", BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(outer, bore), side)};
}

OrdinarySolid boss(Random& random) {
  const TopoDS_Shape base = BRepPrimAPI_MakeBox(20, 20, uniform(random, 3, 6)).Shape();
  const double radius = uniform(random, 2, 5);
  const TopoDS_Shape stud =
      count(random, 0, 1) == 1
          ? BRepPrimAPI_MakeCylinder(upright(10, 10, 1), radius, 15).Shape()
          : BRepPrimAPI_MakeCone(upright(10, 10, 1), radius, 0.5 * radius, 15).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Fuse(base, stud);
  BRepFilletAPI_MakeFillet fillet(shape);
  const double round = uniform(random, 0.4, 1.2);
  const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) {
    TopoDS_Vertex first, last;
    TopExp::Vertices(TopoDS::Edge(edges(i)), first, last);
    if (first.IsSame(last)) fillet.Add(round, TopoDS::Edge(edges(i)));
  }
  return {"a boss with fillets", fillet.Shape()};
}

OrdinarySolid ring_and_ball(Random& random) {
  const double r = uniform(random, 6, 10), s = uniform(random, 1, 2.5);
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(r, s).Shape();
  const TopoDS_Shape ball =
      BRepPrimAPI_MakeSphere(gp_Pnt(r, uniform(random, -1, 1), 0.3), 1.4 * s).Shape();
  const TopoDS_Shape half = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -20), gp_Pnt(20, 20, 0.4)).Shape();
  const TopoDS_Shape both = BRepAlgoAPI_Fuse(ring, ball);
  if (count(random, 0, 1) == 0) return {"a ring and a ball", both};
  return {"half a ring and a ball", BRepAlgoAPI_Common(both, half)};
}

OrdinarySolid rib(Random& random) {
  const double w = uniform(random, 1, 3), h = uniform(random, 4, 8);
  std::vector<gp_Pnt> outline{{0, 0, 0}, {15, 0, 0}, {15, 0, w}, {w, 0, w}, {w, 0, h}, {0, 0, h}};
  TopoDS_Shape shape = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon(outline)).Face(),
                                             gp_Vec(uniform(random, -2, 2), 10, 0))
                           .Shape();
  const gp_Ax2 axis = upright(uniform(random, 7, 10), 5, -1);
  shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCylinder(axis, uniform(random, 1, 2), 20).Shape());
  BRepFilletAPI_MakeFillet fillet(shape);
  const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
  const double round = uniform(random, 0.2, 0.8) * std::min(w, 1.0);
  fillet.Add(round, TopoDS::Edge(edges(count(random, 1, edges.Extent()))));
  return {"a bracket", fillet.Shape()};
}

constexpr std::array<OrdinarySolid (*)(Random&), kOrdinaryFamilies> kFamilies{
    filleted_box, chamfered_box, loft,         bored_ball, hollow_box,    plate_with_holes,
    pipe,         turned_part,   joined_tubes, boss,       ring_and_ball, rib};

}  // namespace

OrdinarySolid ordinary_solid(int seed) {
  Random random(static_cast<unsigned>(seed) + 1);
  const auto family = static_cast<std::size_t>(seed % kOrdinaryFamilies);
  try {
    return kFamilies[family](random);
  } catch (const Standard_Failure&) {
    return {"refused by Open CASCADE", {}};
  }
}

}  // namespace blossom::occt::testing
