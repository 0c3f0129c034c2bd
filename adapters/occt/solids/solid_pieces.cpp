// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/solid_pieces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/kept_tolerances.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/solids/contact_vertices.h"
#include "adapters/occt/solids/curve_edges.h"
#include "adapters/occt/solids/sheet_ends.h"
#include "adapters/occt/solids/solid_loose_ends.h"
#include "adapters/occt/solids/touching_curves.h"
#include "adapters/occt/splitting/common_edges.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/edges/edge_union.h"
#include "adapters/occt/splitting/face_division.h"
#include "core/base/work_limit.h"

namespace blossom::occt {
namespace {

// In tolerances of points or of the faces' edges: how long a piece of an intersection may be left
// out.
constexpr double kMaxRest = 10;

// One solid on its way through the work; one entry for each face.
struct Side {
  const char* name = "";
  const TrimTool* solid = nullptr;
  std::vector<FaceDivision> faces;
  std::vector<std::vector<int>> curves;  // number of the intersection curve of each cut

  Side(const char* word, const TrimTool& of)
      : name(word), solid(&of), faces(of.faces.begin(), of.faces.end()), curves(of.faces.size()) {}
  std::string face_name(std::size_t face) const {
    return occt::face_name(*solid, face, std::string("the ") + name);
  }
};

// Where an intersection curve lies among the cuts of both sides.
struct CurveUse {
  std::size_t face_a = 0, cut_a = 0;
  std::size_t face_b = 0, cut_b = 0;
  bool touch = false;      // the faces do not cross there
  double uncertainty = 0;  // how far beyond the vertices it ends in it may go on
  bool in_vertex = false;  // as a whole, so that it divides nothing
};

void add_curve(const FaceIntersection& pair, std::size_t place, Side& a, Side& b,
               std::vector<CurveUse>& uses) {
  const auto face_a = static_cast<std::size_t>(pair.face_a);
  const auto face_b = static_cast<std::size_t>(pair.face_b);
  const IntersectionCurve& curve = pair.found.curves[place];
  const int number = static_cast<int>(uses.size());
  FaceDivision &on_a = a.faces[face_a], &on_b = b.faces[face_b];
  uses.push_back({face_a, on_a.cuts().size(), face_b, on_b.cuts().size(), curve.tangential});
  on_a.add_cut(cut_of_a(pair, place), {0, on_b.face(), curve.chart_b, curve.tangential});
  on_b.add_cut(cut_of_b(pair, place), {0, on_a.face(), curve.chart_a, curve.tangential});
  a.curves[face_a].push_back(number);
  b.curves[face_b].push_back(number);
}

void add_once(const std::string& text, std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), text) == known.end()) known.push_back(text);
}

// What is told beside an obstacle.
struct Pending {
  std::vector<std::string> cusps;
  std::vector<CrossingCurve> curves;  // none but where faces are not divided alike
  std::array<std::vector<std::vector<TopoDS_Edge>>, 2> lying{};
};

// Where it is not known how faces meet nothing can be divided; but round a cusp, that is a point,
// all curves are known, and whether pieces fit together there is seen when they are put together.
void tell_places(const FaceIntersection& pair, const std::string& both, SolidPieces& result,
                 Pending& untold) {
  for (const Place& place : pair.found.places) {
    const char* const kind = place.kind == PlaceKind::Open ? "an unresolved region" : "a cusp";
    const std::string text = both + ": " + kind + ", where it is not known how they meet";
    if (place.kind == PlaceKind::Open) add_once(text, result.obstacles);
    if (place.kind == PlaceKind::Cusp) add_once(text, untold.cusps);
  }
}

void add_curves(const FaceIntersection& pair, const CommonEdges& common, double tolerance, Side& a,
                Side& b, std::vector<CurveUse>& uses, SolidPieces& result, Pending& untold) {
  const auto face_a = static_cast<std::size_t>(pair.face_a);
  const auto face_b = static_cast<std::size_t>(pair.face_b);
  const std::string both = a.face_name(face_a) + " and " + b.face_name(face_b);
  tell_places(pair, both, result, untold);
  const std::vector<std::size_t> along = common.curves_along(pair);
  for (std::size_t i = 0; i < pair.found.curves.size(); ++i) {
    if (is_one_place(pair, i) || std::ranges::find(along, i) != along.end()) continue;
    const IntersectionCurve& curve = pair.found.curves[i];
    add_curve(pair, i, a, b, uses);
    if (curve.tangential &&
        !only_touch(curve, a.solid->faces[face_a], b.solid->faces[face_b], tolerance))
      result.obstacles.push_back(both + " touch along a curve in which they may cross as well");
  }
}

using Telling = void (FaceSplitter::*)(int cut, const CutStop& stop);

void tell_borders(const FaceSplitter& from, int cut, FaceSplitter& to, int as, Telling tell) {
  for (const CutStop& stop : from.stops(cut))
    if (!stop.vertex.IsNull()) (to.*tell)(as, stop);
}

// At the first and the last stop of a cut.
double end_uncertainty(const std::vector<CutStop>& stops) {
  return stops.empty() ? 0 : std::max(stops.front().uncertainty, stops.back().uncertainty);
}

// Whether a cut is in one vertex: all its stops are one, and so near each other that it is not a
// loop through a vertex.
bool is_in_vertex(const Spline& cut, const std::vector<CutStop>& stops, const EdgeSplits& splits) {
  if (stops.size() == 1) return true;
  const auto is_first = [&](const CutStop& stop) {
    return !stop.vertex.IsNull() && splits.are_one(stop.vertex, stops.front().vertex);
  };
  if (stops.empty() || !std::ranges::all_of(stops, is_first)) return false;
  const Interval whole{stops.front().parameter, stops.back().parameter};
  const Vec3 from = point_at(cut, whole.from);
  return distance(from, point_at(cut, at(whole, 0.5))) <=
         std::max(distance(from, point_at(cut, whole.to)), end_uncertainty(stops));
}

// Every curve is divided at the same places on both sides.
void exchange_stops(Side& a, Side& b, std::vector<CurveUse>& uses, const EdgeSplits& splits) {
  for (const Telling tell : {&FaceSplitter::unite_borders, &FaceSplitter::meet})
    for (const CurveUse& use : uses) {
      FaceSplitter &on_a = *a.faces[use.face_a].splitter(), &on_b = *b.faces[use.face_b].splitter();
      const int cut_a = static_cast<int>(use.cut_a), cut_b = static_cast<int>(use.cut_b);
      tell_borders(on_a, cut_a, on_b, cut_b, tell);
      tell_borders(on_b, cut_b, on_a, cut_a, tell);
    }
  for (Side* side : {&a, &b})
    for (const FaceDivision& face : side->faces)
      if (face.splitter() != nullptr) face.splitter()->tidy();
  for (CurveUse& use : uses) {
    FaceSplitter &on_a = *a.faces[use.face_a].splitter(), &on_b = *b.faces[use.face_b].splitter();
    const int cut_a = static_cast<int>(use.cut_a), cut_b = static_cast<int>(use.cut_b);
    const std::vector<CutStop> of_a = on_a.stops(cut_a), of_b = on_b.stops(cut_b);
    for (const CutStop& stop : of_b) on_a.divide(cut_a, stop);
    for (const CutStop& stop : of_a) on_b.divide(cut_b, stop);
    use.uncertainty = std::max(end_uncertainty(of_a), end_uncertainty(of_b));
    const Spline& curve = a.faces[use.face_a].cuts()[use.cut_a].curve;
    use.in_vertex = is_in_vertex(curve, of_a, splits) && is_in_vertex(curve, of_b, splits);
  }
}

void add_coincident(const std::vector<std::vector<TopoDS_Edge>>& edges, const CommonEdges& common,
                    Side& side, const DivisionJob& job) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const TopoDS_Edge& edge : edges[i]) {
      side.faces[i].begin(job);
      side.faces[i].splitter()->add_coincident(edge, common.reach(edge),
                                               common.runs_along(edge, side.faces[i].face()));
    }
}

void meet_cuts(const std::vector<std::vector<TopoDS_Edge>>& edges, Side& side) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (FaceSplitter* const splitter = side.faces[i].splitter())
      for (const TopoDS_Edge& edge : edges[i]) splitter->meet_cuts(edge);
}

// The vertices of the face's border in which a cut is divided.
std::vector<TopoDS_Vertex> border_stops(const FaceDivision& face, std::size_t cut) {
  std::vector<TopoDS_Vertex> found;
  for (const CutStop& stop : face.splitter()->stops(static_cast<int>(cut)))
    if (!stop.vertex.IsNull()) found.push_back(stop.vertex);
  return found;
}

void unite_contacts(const ShapeIntersection& found, const Side& a, const Side& b,
                    const std::vector<CurveUse>& uses, const DivisionJob& job) {
  if (std::ranges::none_of(found.pairs, has_contact)) return;
  std::vector<CutEnds> ends;
  for (const CurveUse& use : uses)
    ends.push_back({{use.face_a, use.face_b},
                    {border_stops(a.faces[use.face_a], use.cut_a),
                     border_stops(b.faces[use.face_b], use.cut_b)}});
  unite_in_contacts(found, {&a.solid->faces, &b.solid->faces}, ends, job.tolerance, job.splits);
}

void split_both(const ShapeIntersection& found, Side& a, Side& b, std::vector<CurveUse>& uses,
                const CommonEdges& common, const DivisionJob& job) {
  common.split(job.splits);
  for (Side* side : {&a, &b})
    for (FaceDivision& face : side->faces)
      if (!face.cuts().empty()) face.begin(job);
  meet_cuts(common.in_a(), a);
  meet_cuts(common.in_b(), b);
  for (Side* side : {&a, &b})
    for (FaceDivision& face : side->faces) face.settle();
  unite_contacts(found, a, b, uses, job);
  exchange_stops(a, b, uses, job.splits);
  common.match(job.splits);
  add_coincident(common.in_a(), common, a, job);
  add_coincident(common.in_b(), common, b, job);
  for (Side* side : {&a, &b})
    for (FaceDivision& face : side->faces) face.finish(job);
}

// What the curves become on one side.
std::vector<CurveEdges> curve_edges(const Side& side, std::size_t count) {
  std::vector<CurveEdges> found(count);
  for (std::size_t i = 0; i < side.faces.size(); ++i) {
    const FaceSplit& split = side.faces[i].split();
    const auto add = [&](const CutUse& use) {
      found[static_cast<std::size_t>(side.curves[i][static_cast<std::size_t>(use.cut)])].add(use);
    };
    for (const FacePiece& piece : split.pieces) std::ranges::for_each(piece.cuts, add);
    std::ranges::for_each(split.repeats, add);
  }
  return found;
}

double largest_tolerance(const TopoDS_Face& face) {
  return std::max(BRep_Tool::Tolerance(face), largest_edge_tolerance(face));
}

void add_notes(const Side& side, std::size_t face, SolidPieces& result) {
  for (const std::string& note : side.faces[face].split().notes)
    result.obstacles.push_back(side.face_name(face) + ": " + note);
}

// Whether a sheet is divided as far as a curve goes. Its own border may end the curve in the middle
// of a face of the other input, which stays as it is there; and a sheet's in the middle of its own.
bool divides_sheet(const Side& sheet, const Side& other, const Spline& curve,
                   const CurveEdges& on_sheet, double allowed) {
  return !sheet.solid->is_solid() &&
         (!other.solid->is_solid() || longest_rest(curve, on_sheet, on_sheet) <= allowed);
}

// Whether faces of a solid may stay as they are where curves end in the middle of them. The pieces
// of the sheet beside these curves have a free edge then, and divide nothing.
bool ends_in_solid(const Side& solid, const Side& sheet, const std::vector<CurveEdges>& on_sheet) {
  if (!solid.solid->is_solid() || sheet.solid->is_solid()) return false;
  std::vector<TopoDS_Face> pieces;
  for (const FaceDivision& face : sheet.faces)
    for (const FacePiece& piece : face.split().pieces) pieces.push_back(piece.face);
  return end_with_sheet(pieces, on_sheet);
}

void join_edges(const Side& a, const Side& b, const std::vector<CurveUse>& uses,
                const CommonEdges& common, double tolerance, EdgeUnion& joined,
                SolidPieces& result) {
  const auto on_a = curve_edges(a, uses.size());
  const auto on_b = curve_edges(b, uses.size());
  const bool b_ends = ends_in_solid(a, b, on_b);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const CurveUse& use = uses[i];
    if (use.in_vertex) continue;
    const Spline& curve = a.faces[use.face_a].cuts()[use.cut_a].curve;
    // Ends that stick out over the border of a face by its edges' tolerances, or by what a vertex
    // is uncertain, are left out; more would be an intersection that is lost.
    const double allowed =
        std::max(kMaxRest * std::max({tolerance, largest_tolerance(a.solid->faces[use.face_a]),
                                      largest_tolerance(b.solid->faces[use.face_b])}),
                 use.uncertainty);
    const bool alike = match(on_a[i], on_b[i]);
    if (use.touch && !alike) continue;  // what only touches may divide one face alone
    const bool fits = alike && (use.touch || longest_rest(curve, on_a[i], on_b[i]) <= allowed);
    const bool left_out =
        b_ends && is_matched(on_a[i], on_b[i]) && divides_sheet(b, a, curve, on_b[i], allowed);
    if (!fits && !left_out && !divides_sheet(a, b, curve, on_a[i], allowed)) {
      result.obstacles.push_back(a.face_name(use.face_a) + " and " + b.face_name(use.face_b) +
                                 " are not divided alike along their intersection");
      add_notes(a, use.face_a, result);
      add_notes(b, use.face_b, result);
      continue;
    }
    if (left_out && !fits)
      add_once(b.face_name(use.face_b) + " ends inside of " + a.face_name(use.face_a) +
                   " and divides nothing there",
               result.merged);
    if (!join_matching(on_a[i], on_b[i], common, joined))
      result.obstacles.push_back(a.face_name(use.face_a) + " and " + b.face_name(use.face_b) +
                                 " meet along an edge together with others");
  }
}

// An edge that lies in a face may have been joined to one that it runs along as well.
void join_coincident(const Side& side, const CommonEdges& common, EdgeUnion& joined,
                     SolidPieces& result) {
  for (std::size_t i = 0; i < side.faces.size(); ++i)
    for (const CoincidentEdge& coincident : side.faces[i].split().coincident)
      if (!joined.join(coincident.piece, coincident.edge, coincident.edge, false) &&
          !join_along(coincident.piece, coincident.edge, common, joined))
        result.obstacles.push_back(side.face_name(i) +
                                   ": an edge of the other solid lies in two of its faces");
}

// What lies between cuts that repeat each other is in no piece.
void tell_repeats(const Side& side, std::vector<std::string>& merged) {
  for (std::size_t i = 0; i < side.faces.size(); ++i)
    if (!side.faces[i].split().repeats.empty())
      merged.push_back(side.face_name(i) +
                       ": cuts that keep within tolerance of each other count as one");
}

// What the cuts on its border say of a piece.
SolidSide side_by_cuts(const SidedPiece& piece) {
  bool above = false, below = false;
  for (const CutUse& use : piece.piece->cuts) {
    if (use.along || (*piece.sources)[static_cast<std::size_t>(use.cut)].tangential) continue;
    const ToolSide side = side_at_cut(piece, use);
    above = above || side == ToolSide::Above;
    below = below || side == ToolSide::Below;
  }
  if (above == below) return SolidSide::Unknown;
  return above ? SolidSide::Outside : SolidSide::Inside;
}

// lying   by face of the other solid: edges of this one that lie in it
SplitSolid split_solid(const Side& side, const std::vector<std::vector<TopoDS_Edge>>& lying,
                       EdgeSplits& splits, EdgeUnion& joined) {
  SplitSolid made{side.name, side.solid, {}, {}};
  for (std::size_t i = 0; i < side.faces.size(); ++i)
    for (const FacePiece& piece : side.faces[i].split().pieces) {
      const TopoDS_Face face = joined.rebuilt(piece.face);
      if (face.IsNull()) continue;
      made.pieces.push_back(
          {face, static_cast<int>(i),
           side_by_cuts({&piece, &side.faces[i].cuts(), &side.faces[i].sources()})});
      for (const CutUse& use : piece.cuts) made.crossed.Add(joined.united(use.edge));
    }
  for (const std::vector<TopoDS_Edge>& edges : lying)
    for (const TopoDS_Edge& edge : edges)
      for (const EdgePiece& piece : splits.pieces(edge))
        made.crossed.Add(joined.united(piece.edge));
  return made;
}

std::vector<std::pair<std::size_t, std::size_t>> overlaps_of(const ShapeIntersection& found) {
  std::vector<std::pair<std::size_t, std::size_t>> overlaps;
  for (const FaceIntersection& pair : found.pairs)
    if (std::ranges::count(pair.found.places, PlaceKind::Overlap, &Place::kind) > 0)
      overlaps.emplace_back(pair.face_a, pair.face_b);
  return overlaps;
}

void keep_curves(const ShapeIntersection& found, const CommonEdges& common, Pending& untold) {
  untold.lying = {common.in_a(), common.in_b()};
  for (const FaceIntersection& pair : found.pairs)
    for (const IntersectionCurve& curve : pair.found.curves)
      untold.curves.push_back(
          {{curve.samples.front().point, curve.samples.back().point},
           {static_cast<std::size_t>(pair.face_a), static_cast<std::size_t>(pair.face_b)}});
}

// Where curves break off, which comes first: what it leaves undivided is told of many faces then.
std::vector<std::string> told_loose_ends(const Pending& untold, const TrimTool& a,
                                         const TrimTool& b) try {
  if (untold.curves.empty()) return {};
  return guarded("telling where cuts break off", [&] {
    return loose_ends(untold.curves, {CrossedSolid{"part", &a, &untold.lying[0]},
                                      CrossedSolid{"tool", &b, &untold.lying[1]}});
  });
} catch (const Failure&) {
  return {};  // what is told without it stands
}

void tell(const Pending& untold, const TrimTool& a, const TrimTool& b, SolidPieces& result) {
  std::vector<std::string> all = told_loose_ends(untold, a, b);
  all.insert(all.end(), untold.cusps.begin(), untold.cusps.end());
  result.obstacles.insert(result.obstacles.begin(), all.begin(), all.end());
}

// Runs a step of the work; false, with the obstacle, if it fails.
template <class Step>
bool attempt(const char* what, const WorkLimit& limit, SolidPieces& result, const Step& step) {
  try {
    guarded(what, step);
    return true;
  } catch (const LimitFailure& error) {
    result.obstacles.emplace_back(error.what());
    result.status = Status::Stopped;
  } catch (const Failure& error) {
    result.obstacles.emplace_back(error.what());
    if (limit.reached_after_search() != nullptr) result.status = Status::Stopped;
  }
  return false;
}

void tell_merged(const CommonEdges& common, const EdgeUnion& joined,
                 std::vector<std::string>& merged) {
  if (joined.lost_wires() > 0)
    merged.emplace_back("what lies in one vertex as a whole is left out");
  if (common.loosest() == 0) return;
  std::ostringstream text;
  text << "edges lie in faces of the other solid within their own tolerances of up to "
       << common.loosest();
  merged.push_back(text.str());
}

// found   of the faces
SolidPieces divided_alike(const TrimTool& a, const TrimTool& b, const ShapeIntersection& found,
                          EdgesLie lying, const IntersectionOptions& options, Pending& untold) {
  SolidPieces result;
  const WorkLimit limit(options);
  Side side_a("part", a), side_b("tool", b);
  std::vector<CurveUse> uses;
  const double tolerance = options.tolerances.point;
  result.status = found.status;
  result.certificate = found.certificate;
  CommonEdges common(a.faces, b.faces, options, lying);
  const auto add_common_edges = [&] {
    if (a.is_solid() && b.is_solid()) common.know_equal(found);
    for (const FaceIntersection& pair : found.pairs) {
      common.add(pair);
      if (lying == EdgesLie::Nearby) common.add_touches(pair);
    }
    common.add_loose();
  };
  if (!attempt("looking for common edges", limit, result, add_common_edges)) return result;
  for (const FaceIntersection& pair : found.pairs)
    add_curves(pair, common, tolerance, side_a, side_b, uses, result, untold);
  if (result.status == Status::Stopped && result.obstacles.empty())
    result.obstacles.emplace_back("the intersection is not complete");
  if (!result.obstacles.empty()) return result;
  EdgeSplits splits(tolerance);
  if (!attempt("splitting the solids", limit, result, [&] {
        split_both(found, side_a, side_b, uses, common, {splits, tolerance, &limit});
      }))
    return result;
  EdgeUnion joined;
  if (const std::string cause = common.join(splits, joined); !cause.empty())
    result.obstacles.push_back(cause);
  attempt("joining the solids", limit, result, [&] {
    for (const Side* side : {&side_a, &side_b}) join_coincident(*side, common, joined, result);
    join_edges(side_a, side_b, uses, common, tolerance, joined, result);
  });
  if (!result.obstacles.empty()) {
    keep_curves(found, common, untold);
    return result;
  }
  SplitSolid split_a = split_solid(side_a, common.in_b(), splits, joined);
  SplitSolid split_b = split_solid(side_b, common.in_a(), splits, joined);
  if (joined.collapsed() > 0)
    result.obstacles.push_back(std::to_string(joined.collapsed()) +
                               " edges are shorter than the tolerance of their ends");
  if (joined.swallowed() > 0)
    result.obstacles.push_back(std::to_string(joined.swallowed()) +
                               " edges are half in a vertex that is uncertain by so much");
  attempt("finding sides", limit, result, [&] {
    SidesTold told = find_sides(split_a, split_b, overlaps_of(found), tolerance, &limit);
    result.obstacles.insert(result.obstacles.end(), told.obstacles.begin(), told.obstacles.end());
    std::ranges::move(told.merged, std::back_inserter(result.merged));
    result.between = told.between;
  });
  for (const Side* side : {&side_a, &side_b}) tell_repeats(*side, result.merged);
  tell_merged(common, joined, result.merged);
  if (!result.merged.empty()) result.status = weaker(result.status, Status::Tolerance);
  result.a = std::move(split_a.pieces);
  result.b = std::move(split_b.pieces);
  return result;
}

// What leads to nothing leaves the solids as they were.
SolidPieces pieces_of(const TrimTool& a, const TrimTool& b, const ShapeIntersection& found,
                      EdgesLie lying, const IntersectionOptions& options, Pending& untold) {
  KeptTolerances kept(a.faces);
  kept.remember(b.faces);
  SolidPieces result = divided_alike(a, b, found, lying, options, untold);
  if (result.obstacles.empty()) kept.leave();
  return result;
}

}  // namespace

SolidPieces solid_pieces(const TrimTool& a, const TrimTool& b, const ShapeIntersection& found,
                         EdgesLie lying, const IntersectionOptions& options, Causes causes) {
  const SharedLimit limit(options);
  Pending untold;
  SolidPieces result = pieces_of(a, b, found, lying, options, untold);
  if (result.obstacles.empty() || causes == Causes::Short) return result;
  // The search for where cuts break off has no limit of its own.
  if (limit.is_reached()) untold.curves.clear();
  tell(untold, a, b, result);
  return result;
}

}  // namespace blossom::occt
