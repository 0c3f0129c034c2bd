// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/fuzz/support/solids.h"

#include <numbers>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <Standard_Failure.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "core/base/errors.h"

namespace blossom::fuzz {
namespace {

// A multiple of a half, or nearly one.
double length(Choices& choices) {
  const double whole = 0.5 * choices.within(1, 8);
  if (choices.within(0, 3) < 3) return whole;
  return whole + choices.within(-1, 1) * choices.magnitude(-9, -1);
}

double place(Choices& choices) {
  const double whole = 0.5 * choices.within(-4, 4);
  if (choices.within(0, 3) < 3) return whole;
  return whole + choices.within(-1, 1) * choices.magnitude(-9, -1);
}

TopoDS_Shape primitive(Choices& choices) {
  switch (choices.within(0, 5)) {
    case 1: return BRepPrimAPI_MakeCylinder(length(choices), length(choices)).Shape();
    case 2: {
      const double low = length(choices), high = choices.within(0, 3) * 0.5;
      return BRepPrimAPI_MakeCone(low, high, length(choices)).Shape();
    }
    case 3: return BRepPrimAPI_MakeSphere(length(choices)).Shape();
    case 4: return BRepPrimAPI_MakeTorus(length(choices) + 1, 0.25 * choices.within(1, 4)).Shape();
    case 5: {
      const double x = length(choices), y = length(choices), z = length(choices);
      return BRepPrimAPI_MakeWedge(x, y, z, 0.5 * choices.within(0, 4)).Shape();
    }
    default: {
      const double x = length(choices), y = length(choices), z = length(choices);
      return BRepPrimAPI_MakeBox(x, y, z).Shape();
    }
  }
}

}  // namespace

TopoDS_Shape solid_of(Choices& choices) try {
  TopoDS_Shape shape = primitive(choices);
  const double x = place(choices), y = place(choices), z = place(choices);
  gp_Trsf move, turn, scale;
  move.SetTranslation(gp_Vec(x, y, z));
  const int turned = choices.within(0, 6);
  if (turned > 0) {
    constexpr double kAngles[] = {std::numbers::pi / 2, std::numbers::pi / 4, 1e-6};
    const gp_Dir axis = turned % 2 == 1 ? gp::DX() : gp_Dir(1, 1, 1);
    turn.SetRotation(gp_Ax1(gp::Origin(), axis), kAngles[(turned - 1) / 2]);
  }
  if (choices.within(0, 7) == 7) scale.SetScale(gp::Origin(), choices.magnitude(-4, 4));
  return BRepBuilderAPI_Transform(shape, scale * move * turn, true).Shape();
} catch (const Standard_Failure&) {
  throw InvalidInput("there is no such solid");
}

}  // namespace blossom::fuzz
