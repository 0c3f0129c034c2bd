// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_list.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <BRep_Builder.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Face.hxx>
#include <gp.hxx>

#include "adapters/occt/base/errors.h"

namespace blossom::occt {
namespace {

// A meridian that lies on its own axis, of which Open CASCADE makes a surface, but no more.
TopoDS_Face turned_axis() {
  TColgp_Array1OfPnt ends(1, 2);
  ends(1) = gp_Pnt(0, 0, 0);
  ends(2) = gp_Pnt(0, 0, 1);
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_SurfaceOfRevolution(new Geom_BezierCurve(ends), gp::OZ()),
                          Precision::Confusion());
  return face;
}

TEST(FaceList, NamesTheFaceThatOpenCascadeCannotUse) {
  const std::vector<TopoDS_Face> faces{turned_axis()};
  try {
    FaceList list(faces, "the part", 1e-7, Extent::Trims);
    list.convert(std::vector<char>{1});
    FAIL() << "it was converted";
  } catch (const BadModel& error) {
    EXPECT_NE(std::string(error.what()).find("face 1 of the part"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace blossom::occt
