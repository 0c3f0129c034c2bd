// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/solid_validity.h"

#include <algorithm>

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepCheck_Solid.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/solids/faces_to_check.h"
#include "adapters/occt/solids/polygon_faces.h"

namespace blossom::occt {
namespace {

bool has_none(const BRepCheck_ListOfStatus& problems) {
  return std::all_of(problems.begin(), problems.end(),
                     [](BRepCheck_Status status) { return status == BRepCheck_NoError; });
}

bool new_faces_are_valid(const TopoDS_Shape& shape, const TopTools_MapOfShape& known) {
  FacesToCheck faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (!known.Contains(it.Current()) && !is_sound_polygon(TopoDS::Face(it.Current())))
      faces.add(TopoDS::Face(it.Current()));
  return faces.all().NbChildren() == 0 || BRepCheck_Analyzer(faces.all()).IsValid();
}

bool shells_are_valid(const TopoDS_Solid& solid) {
  for (TopoDS_Iterator it(solid); it.More(); it.Next()) {
    if (it.Value().ShapeType() != TopAbs_SHELL) continue;
    const Handle(BRepCheck_Shell) shell = new BRepCheck_Shell(TopoDS::Shell(it.Value()));
    shell->InContext(solid);
    if (!has_none(shell->Status()) || !has_none(shell->StatusOnShape(solid))) return false;
  }
  return true;
}

}  // namespace

bool is_valid(const TopoDS_Solid& solid, const TopTools_MapOfShape& known) {
  const Handle(BRepCheck_Solid) whole = new BRepCheck_Solid(solid);
  return has_none(whole->Status()) && shells_are_valid(solid) && new_faces_are_valid(solid, known);
}

bool are_valid(const std::vector<TopoDS_Solid>& solids, const TopTools_MapOfShape& known,
               const WorkLimit& limit) {
  return guarded("checking solids", [&] {
    return std::ranges::all_of(solids, [&](const TopoDS_Solid& solid) {
      check_limit(&limit, "checking solids");
      return is_valid(solid, known);
    });
  });
}

bool are_valid(const std::vector<SolidFace>& faces, const TopTools_MapOfShape& known) {
  return guarded("checking faces", [&] {
    return std::ranges::all_of(
        faces, [&](const SolidFace& of) { return new_faces_are_valid(of.face, known); });
  });
}

}  // namespace blossom::occt
