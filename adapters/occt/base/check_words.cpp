// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/base/check_words.h"

#include <algorithm>

#include <BRepCheck_ListOfStatus.hxx>

namespace blossom::occt {
namespace {

void add_words_of(const BRepCheck_ListOfStatus& statuses, TopAbs_ShapeEnum kind,
                  std::vector<std::string>& problems) {
  for (const BRepCheck_Status status : statuses) {
    const std::string said = words_of(status, kind);
    if (!said.empty() && std::ranges::find(problems, said) == problems.end())
      problems.push_back(said);
  }
}

}  // namespace

bool finds_nothing(const BRepCheck_ListOfStatus& statuses) {
  return std::all_of(statuses.begin(), statuses.end(),
                     [](BRepCheck_Status status) { return status == BRepCheck_NoError; });
}

std::string words_of(BRepCheck_Status status) {
  switch (status) {
    case BRepCheck_NoError: return "";
    // Of vertices.
    case BRepCheck_InvalidPointOnCurve: return "lies off the curve of its edge";
    case BRepCheck_InvalidPointOnCurveOnSurface:
      return "lies off the curve of its edge in the parameters of the face";
    case BRepCheck_InvalidPointOnSurface: return "lies off the surface";
    // Of edges.
    case BRepCheck_No3DCurve: return "has no curve in space";
    case BRepCheck_Multiple3DCurve: return "has more than one curve in space";
    case BRepCheck_Invalid3DCurve: return "has an invalid curve in space";
    case BRepCheck_NoCurveOnSurface: return "has no curve in the parameters of the face";
    case BRepCheck_InvalidCurveOnSurface:
      return "has curves in space and on the face that are apart by more than its tolerance";
    case BRepCheck_InvalidCurveOnClosedSurface:
      return "is a seam whose curves in space and on the face are apart by more than its tolerance";
    case BRepCheck_InvalidSameRangeFlag:
      return "claims that its curves have one range of parameters, and they have not";
    case BRepCheck_InvalidSameParameterFlag:
      return "claims that its curves agree at each parameter, and they do not";
    case BRepCheck_InvalidDegeneratedFlag: return "claims to be a point, and is none";
    case BRepCheck_InvalidRange: return "has an empty range of parameters, or one off its curve";
    case BRepCheck_InvalidPolygonOnTriangulation:
      return "has a polygon that does not fit the triangulation";
    // Of wires.
    case BRepCheck_EmptyWire: return "has no edges";
    case BRepCheck_RedundantEdge: return "has one edge several times";
    case BRepCheck_SelfIntersectingWire: return "meets itself";
    // Of faces.
    case BRepCheck_NoSurface: return "has no surface";
    case BRepCheck_InvalidWire: return "has an invalid wire";
    case BRepCheck_RedundantWire: return "has one wire several times";
    case BRepCheck_IntersectingWires: return "has wires that meet each other";
    case BRepCheck_InvalidImbricationOfWires:
      return "has wires that do not lie in each other as a border and its holes do";
    // Of shells and solids.
    case BRepCheck_FreeEdge: return "has an edge that one face alone uses";
    case BRepCheck_InvalidMultiConnexity: return "has an edge that more than two faces use";
    case BRepCheck_EmptyShell: return "has no faces";
    case BRepCheck_RedundantFace: return "has one face several times";
    case BRepCheck_InvalidImbricationOfShells:
      return "has shells that do not lie in each other as a body and its hollows do";
    case BRepCheck_EnclosedRegion: return "has a region that another one encloses";
    // Of any.
    case BRepCheck_UnorientableShape: return "has parts whose orientations contradict each other";
    case BRepCheck_NotClosed: return "is not closed";
    case BRepCheck_NotConnected: return "is not in one piece";
    case BRepCheck_SubshapeNotInShape: return "is asked about a part that it does not have";
    case BRepCheck_BadOrientation: return "is oriented the wrong way";
    case BRepCheck_BadOrientationOfSubshape: return "has a part that is oriented the wrong way";
    case BRepCheck_InvalidToleranceValue: return "has an invalid tolerance";
    case BRepCheck_CheckFail: break;
  }
  return "cannot be checked, Open CASCADE's check breaks off";
}

std::string words_of(BRepCheck_Status status, TopAbs_ShapeEnum kind) {
  const std::string said = words_of(status);
  if (said.empty()) return said;
  switch (kind) {
    case TopAbs_WIRE: return "a wire " + said;
    case TopAbs_EDGE: return "an edge " + said;
    case TopAbs_VERTEX: return "a vertex " + said;
    default: return said;
  }
}

void add_words_of(const Handle(BRepCheck_Result) & result, TopAbs_ShapeEnum kind,
                  std::vector<std::string>& problems) {
  if (result.IsNull()) return;
  add_words_of(result->Status(), kind, problems);
  for (result->InitContextIterator(); result->MoreShapeInContext(); result->NextShapeInContext())
    add_words_of(result->StatusOnShape(), kind, problems);
}

}  // namespace blossom::occt
