// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/hole.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <sstream>
#include <utility>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/flat_fill.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/intersection_edges.h"
#include "core/blending/fills/fill_layout.h"

namespace blossom::occt {
namespace {

/// What counts as one point: the user's wish, or what the model itself says of its vertices.
double point_tolerance(const HoleLoop& loop, double wish) {
  double tolerance = wish;
  for (const HoleEdge& edge : loop) {
    TopoDS_Vertex first, last;
    TopExp::Vertices(edge.edge, first, last);
    for (const TopoDS_Vertex& vertex : {first, last})
      if (!vertex.IsNull()) tolerance = std::max(tolerance, 2 * BRep_Tool::Tolerance(vertex));
  }
  return tolerance;
}

/// Whether the way round the hole is that of the neighbour's own border; then the fill's faces,
/// which lie left of the way, have to be turned over.
bool runs_with_neighbour(const HoleLoop& loop) {
  for (const HoleEdge& edge : loop)
    if (!edge.face.IsNull()) return edge.backwards == (edge.edge.Orientation() == TopAbs_REVERSED);
  return false;
}

TopoDS_Face face_on(const RationalBezierPatch& patch, bool turned) {
  BRepBuilderAPI_MakeFace maker(Handle(Geom_Surface)(to_occt(patch)), Tolerances{}.point);
  if (!maker.IsDone()) throw Failure("a patch of the fill gives no face");
  TopoDS_Face face = maker.Face();
  if (!BRepCheck_Analyzer(face).IsValid())
    throw Failure("a patch of the fill gives an invalid face: does it cross itself?");
  if (turned) face.Reverse();
  return face;
}

/// The same message with edges by their numbers in place of sides and corners.
std::string in_edges(const Fill& fill, const HoleLoop& loop) {
  std::string text = fill.message;
  const auto replace = [&text](const std::string& words, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(words, at)) != std::string::npos; at += by.size())
      text.replace(at, words.size(), by);
  };
  if (fill.place < 0) return text;
  const auto k = static_cast<std::size_t>(fill.place);
  const std::string number = std::to_string(k);
  const std::string after = "edge " + std::to_string(loop[k].number);
  const std::string before =
      "edge " + std::to_string(loop[(k + loop.size() - 1) % loop.size()].number);
  const std::string corner = "the corner of " + before + " and " + after;
  replace("the side before corner " + number, before);
  replace("side " + number, after);
  replace("the sides at corner " + number, before + " and " + after);
  replace("corner " + number, corner);
  return text;
}

// Whether all sides that ask for it have it.
bool is_reached(const FilledHole& hole, FillContinuity wish, auto&& has) {
  bool asked = false;
  for (std::size_t k = 0; k < hole.sides.size(); ++k) {
    if (hole.sides[k].continuity < wish) continue;
    asked = true;
    if (!has(hole.fill.figures.sides[k])) return false;
  }
  return asked;
}

// A common tangent plane that is asked for is there or not, since the plane cannot bend.
void judge_flat(const HoleOptions& options, FilledHole& hole) {
  Fill& fill = hole.fill;
  for (std::size_t k = 0; k < hole.sides.size(); ++k) {
    const double angle = fill.figures.sides[k].normal_angle;
    if (hole.sides[k].continuity == FillContinuity::G0 || angle <= options.fill.angle) continue;
    std::ostringstream text;
    text
        << "the hole has no corners for patches, and a flat face in it meets the neighbour at edge "
        << hole.sides[k].edge.number << " at an angle of " << angle * 180 / std::numbers::pi
        << " degrees; G0 asks for no tangent planes";
    fill.problem = FillProblem::TangentPlanes;
    fill.message = text.str();
    hole.faces.clear();
    return;
  }
  const double bend = options.fill.curvature * fill.figures.largest_curvature;
  const auto is_smooth = [](const FillContact&) { return true; };  // else it was refused
  const auto bends_alike = [&](const FillContact& side) {
    return side.curvature_difference <= bend;
  };
  if (is_reached(hole, FillContinuity::G1, is_smooth)) fill.reached = FillContinuity::G1;
  if (is_reached(hole, FillContinuity::G2, bends_alike)) fill.reached = FillContinuity::G2;
}

// By the plane that the loop lies in, if there is one.
std::optional<FilledHole> flat_hole(const HoleLoop& loop,
                                    const std::vector<FillContinuity>& continuity,
                                    const HoleOptions& options) {
  const double tolerance =
      std::max(options.within, point_tolerance(loop, options.fill.tolerances.point));
  std::optional<FlatFill> made = flat_fill(loop, tolerance);
  if (!made) return std::nullopt;
  FilledHole hole{.fill = {}, .sides = {}, .faces = {made->face}, .flat = true};
  for (std::size_t k = 0; k < loop.size(); ++k)
    hole.sides.push_back({.edge = loop[k], .continuity = continuity[k], .exact = true});
  hole.fill.degree = 1;
  hole.fill.figures.sides = std::move(made->sides);
  hole.fill.figures.largest_curvature = made->largest_curvature;
  judge_flat(options, hole);
  return hole;
}

}  // namespace

FilledHole filled_hole(const HoleLoop& loop, const std::vector<FillContinuity>& continuity,
                       const HoleOptions& options) {
  const auto count = static_cast<int>(loop.size());
  if (count < kMinFillSides || count > kMaxFillSides) {
    if (const auto flat = flat_hole(loop, continuity, options)) return *flat;
    throw BadModel("a hole of " + std::to_string(kMinFillSides) + " to " +
                   std::to_string(kMaxFillSides) +
                   " edges with corners between them, or in a plane, is wanted, that at edge " +
                   std::to_string(loop.front().number) + " has " + std::to_string(count));
  }
  FilledHole result;
  std::vector<FillSide> sides;
  FillOptions wish = options.fill;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    HoleSide side =
        hole_side(loop[k], continuity[k], {.point = wish.tolerances.point, .angle = wish.angle});
    result.sides.push_back({loop[k], continuity[k], side.exact, side.error, side.angle_error});
    sides.push_back(std::move(side.side));
  }
  wish.tolerances.point = std::max(options.within, point_tolerance(loop, wish.tolerances.point));
  result.fill = fill(sides, wish);
  if (result.fill.problem == FillProblem::FlatCorner)
    if (auto flat = flat_hole(loop, continuity, options)) return std::move(*flat);
  if (result.fill.problem != FillProblem::None) {
    result.fill.message = in_edges(result.fill, loop);
    if (result.fill.problem == FillProblem::TangentPlanes)
      result.fill.message += "; G0 asks for no tangent planes";
    return result;
  }
  const bool turned = runs_with_neighbour(loop);
  guarded("making the fill's faces", [&] {
    for (const RationalBezierPatch& patch : result.fill.patches)
      result.faces.push_back(face_on(patch, turned));
  });
  return result;
}

SewnHoles sewn_holes(const std::vector<FilledHole>& holes, const TopoDS_Shape& model,
                     double tolerance) {
  return guarded("sewing the fill", [&] {
    BRepBuilderAPI_Sewing sewing(tolerance);
    if (!model.IsNull()) sewing.Add(model);
    for (const FilledHole& hole : holes)
      for (const TopoDS_Face& face : hole.faces) sewing.Add(face);
    sewing.Perform();
    SewnHoles result{.shape = sewing.SewedShape(), .faces = {}, .patches = {}};
    if (result.shape.IsNull() || !BRepCheck_Analyzer(result.shape).IsValid())
      throw Failure("the fill cannot be sewn: the result is not valid");
    // Sewing turns faces of a shell alike, whichever way those round it are turned.
    const auto sewn = [&](const TopoDS_Face& face) {
      return TopoDS::Face(sewing.ModifiedSubShape(face).Oriented(face.Orientation()));
    };
    if (!model.IsNull())
      for (const TopoDS_Face& face : faces_of(model)) result.faces.push_back(sewn(face));
    for (const FilledHole& hole : holes) {
      std::vector<TopoDS_Face>& patches = result.patches.emplace_back();
      for (const TopoDS_Face& face : hole.faces) patches.push_back(sewn(face));
    }
    return result;
  });
}

}  // namespace blossom::occt
