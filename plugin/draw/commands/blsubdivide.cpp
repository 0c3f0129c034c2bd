// SPDX-License-Identifier: LGPL-2.1-or-later
// blsubdivide result face u1 u2 v1 v2

#include <string>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <DBRep.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

std::string answer_to_blsubdivide(const Words& words) {
  require(words.size() == 6);
  const TopoDS_Shape shape = shape_named(words[1]);
  const std::vector<TopoDS_Face> faces = faces_in(shape, words[1]);
  if (faces.size() > 1) throw occt::BadModel(words[1] + ": has several faces; explode it");
  const occt::ParameterBox box{{number_from(words[2]), number_from(words[3])},
                               {number_from(words[4]), number_from(words[5])}};
  const Handle(Geom_BSplineSurface) piece =
      occt::to_occt(occt::bezier_surface(BRep_Tool::Surface(faces.front()), box));
  DBRep::Set(words[0].c_str(), BRepBuilderAPI_MakeFace(piece, Precision::Confusion()).Shape());
  return std::to_string(piece->UDegree()) + " " + std::to_string(piece->VDegree()) + " " +
         std::to_string(piece->NbUKnots() - 1) + " " + std::to_string(piece->NbVKnots() - 1);
}

}  // namespace

const Command kBlsubdivide{
    "blsubdivide", "result face u1 u2 v1 v2",
    "\n\t\t: the piece of the surface of a face on a rectangle of its parameters, as a face on one"
    "\n\t\t: B-spline surface. The answer is its degrees and spans in both directions: 3 3 1 1.",
    answer_to_blsubdivide};

}  // namespace blossom::draw
