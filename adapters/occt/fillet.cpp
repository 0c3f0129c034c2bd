// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/fillet.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/ball_walk.h"
#include "adapters/occt/blending/blend_sheet.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/fillet_limit.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/rolled_strip.h"
#include "adapters/occt/blending/sheet_trim.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/solids/solid_shells.h"
#include "adapters/occt/solids/solid_validity.h"
#include "adapters/occt/soundness.h"
#include "core/base/errors.h"
#include "core/base/work_limit.h"

namespace blossom::occt {
namespace {

constexpr const char* kFilleting = "rounding edges";

// The faces of one solid of a shape.
struct SolidPart {
  TopoDS_Solid solid;  // of the shape that was given
  std::set<int> faces;
  double volume = 0;
};

// A shape with what is needed to fillet it again and again.
class Filleting {
 public:
  Filleting(const TopoDS_Shape& shape, const FilletOptions& options)
      : body_(BRepBuilderAPI_Copy(shape, Standard_False).Shape()),
        options_(options),
        limit_(options_.intersection) {
    find_parts(shape);
  }

  const BodyEdges& body() const { return body_; }
  const std::vector<SolidPart>& parts() const { return parts_; }

  /// All these edges, or a refusal.
  std::vector<FilletedSolid> made(const FilletEdges& edges);
  /// Of what was made last.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void find_parts(const TopoDS_Shape& shape);
  const SolidPart& part_of(int edge) const;
  FilletedSolid closed(const SolidPart& part, const std::vector<TrimmedFace>& faces,
                       const FilletEdges& edges) const;
  void check(const SolidPart& part, const FilletedSolid& made, const FilletEdges& edges) const;
  void check_apart(const FilletedSolid& made) const;

  BodyEdges body_;
  FilletOptions options_;
  WorkLimit limit_;
  std::vector<SolidPart> parts_;
  std::vector<std::string> notes_;
  Vec3 apex_;
};

void Filleting::find_parts(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces, solids;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  if (body_.edge_count() > 0) {
    const gp_Pnt p = BRep_Tool::Pnt(body_.vertex({1, true}));
    apex_ = {p.X(), p.Y(), p.Z()};
  }
  for (int i = 1; i <= solids.Extent(); ++i) {
    SolidPart part;
    part.solid = TopoDS::Solid(solids(i));
    for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next()) {
      const int number = faces.FindIndex(it.Current());
      part.faces.insert(number);
      part.volume += cone_volume(TopoDS::Face(it.Current()), apex_);
    }
    parts_.push_back(std::move(part));
  }
}

const SolidPart& Filleting::part_of(int edge) const {
  const int face = body_.use(edge, true).face;
  const auto found = std::ranges::find_if(
      parts_, [face](const SolidPart& part) { return part.faces.count(face) > 0; });
  if (found == parts_.end())
    throw FilletRefused({FilletFault::Edge, edge, "it belongs to no solid", {}, {}, {}});
  if (found->volume <= 0)
    throw FilletRefused({FilletFault::Edge, edge, "its solid is turned inside out", {}, {}, {}});
  return *found;
}

// The first fault of a face that is new or was cut, if the face that it is left of had none.
std::optional<Problem> new_fault(const BodyEdges& body, const FilletedSolid& made,
                                 const TopTools_MapOfShape& known) {
  TopTools_IndexedMapOfShape numbers;
  TopExp::MapShapes(made.solid, TopAbs_FACE, numbers);
  std::vector<int> wanted;
  std::map<int, int> from;  // of each of them: the face that it is left of, or 0
  for (const FilletFace& face : made.faces) {
    if (known.Contains(face.face)) continue;
    wanted.push_back(numbers.FindIndex(face.face));
    from[wanted.back()] = face.from;
  }
  for (const FaceSoundness& face : soundness(made.solid, wanted).faces) {
    if (face.problems.empty()) continue;
    const int before = from[face.number];
    if (before > 0 && !soundness(body.face(before)).faces.front().problems.empty()) continue;
    return face.problems.front();
  }
  return std::nullopt;
}

// What is wrong with a solid that was put together; nothing is given out then.
void Filleting::check(const SolidPart& part, const FilletedSolid& made,
                      const FilletEdges& edges) const {
  const int first = edges.begin()->first;
  TopTools_MapOfShape known;
  for (const FilletFace& face : made.faces)
    if (face.from > 0 && face.face.IsSame(body_.face(face.from))) known.Add(face.face);
  const bool valid = is_valid(made.solid, known) && (BRepCheck_Analyzer(made.solid).IsValid() ||
                                                     !BRepCheck_Analyzer(part.solid).IsValid());
  if (!valid)
    throw FilletRefused({FilletFault::Result,
                         first,
                         "the solid that comes out is not valid by BRepCheck",
                         {},
                         {},
                         {}});
  if (const auto fault = new_fault(body_, made, known))
    throw FilletRefused({FilletFault::Result,
                         first,
                         "a face that comes out is not sound: " + fault->what,
                         {},
                         fault->place,
                         {}});
  const bool any_concave = std::ranges::any_of(edges, [](const auto& e) { return e.second; });
  const bool any_convex = std::ranges::any_of(edges, [](const auto& e) { return !e.second; });
  const double change = made.volume - part.volume;
  if ((!any_concave && change >= 0) || (!any_convex && change <= 0))
    throw FilletRefused({FilletFault::Result,
                         first,
                         std::string("the volume does not get ") +
                             (any_convex ? "smaller" : "larger") + " as it should",
                         {},
                         {},
                         {}});
}

// The faces that a face has no vertex in common with although their boxes meet.
std::vector<TopoDS_Face> strangers(const FilletedSolid& made, const TopoDS_Face& face) {
  const auto box_of = [](const TopoDS_Face& of) {
    Bnd_Box box;
    BRepBndLib::Add(of, box, Standard_False);
    return box;
  };
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(face, TopAbs_VERTEX, own);
  const Bnd_Box box = box_of(face);
  std::vector<TopoDS_Face> found;
  for (const FilletFace& other : made.faces) {
    bool known = false;
    for (TopExp_Explorer it(other.face, TopAbs_VERTEX); it.More() && !known; it.Next())
      known = own.Contains(it.Current());
    if (!known && !box.IsOut(box_of(other.face))) found.push_back(other.face);
  }
  return found;
}

// The ball must not have run into faces that it was not known to roll on or end in.
void Filleting::check_apart(const FilletedSolid& made) const {
  for (const FilletFace& blend : made.faces) {
    if (blend.from > 0) continue;
    check_limit(&limit_, kFilleting);
    const std::vector<TopoDS_Face> others = strangers(made, blend.face);
    if (others.empty()) continue;
    const ShapeIntersection found = intersect({blend.face}, others, options_.intersection);
    for (const FaceIntersection& pair : found.pairs) {
      if (pair.found.curves.empty()) continue;
      const TopoDS_Face& met = others[static_cast<std::size_t>(pair.face_b)];
      const auto of = std::ranges::find_if(
          made.faces, [&](const FilletFace& face) { return face.face.IsSame(met); });
      throw FilletRefused({FilletFault::Interference,
                           blend.edge,
                           of->from > 0 ? "its strip runs into face " + std::to_string(of->from)
                                        : "its strip runs into another one",
                           {},
                           pair.found.curves.front().samples.front().point,
                           {}});
    }
  }
}

FilletedSolid Filleting::closed(const SolidPart& part, const std::vector<TrimmedFace>& faces,
                                const FilletEdges& edges) const {
  FilletedSolid made;
  std::vector<BoundingFace> bounding;
  for (const TrimmedFace& each : faces) {
    if (each.from > 0 && part.faces.count(each.from) == 0) continue;
    bounding.push_back({each.face, cone_volume(each.face, apex_)});
    made.volume += bounding.back().volume;
    made.faces.push_back({each.face, each.from, each.edge});
  }
  std::string obstacle;
  const std::vector<TopoDS_Solid> solids = solids_of(bounding, obstacle);
  if (!obstacle.empty() || solids.size() != 1)
    throw FilletRefused({FilletFault::Result,
                         edges.begin()->first,
                         obstacle.empty() ? "the solid would fall apart" : obstacle,
                         {},
                         {},
                         {}});
  made.solid = solids.front();
  return made;
}

std::vector<FilletedSolid> Filleting::made(const FilletEdges& edges) {
  std::vector<FilletedSolid> all;
  notes_.clear();
  for (const SolidPart& part : parts_) {
    FilletEdges own;
    for (const auto& [edge, concave] : edges)
      if (&part_of(edge) == &part) own.emplace(edge, concave);
    if (own.empty()) {
      FilletedSolid kept{part.solid, {}, part.volume};
      for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next())
        kept.faces.push_back({TopoDS::Face(it.Current()), 0, 0});
      std::size_t next = 0;
      for (const int number : part.faces) kept.faces[next++].from = number;
      all.push_back(std::move(kept));
      continue;
    }
    WalkOptions walking{options_.radius, options_.intersection.tolerances.point, {}, [this] {
                          check_limit(&limit_, kFilleting);
                        }};
    for (const auto& [edge, concave] : own) walking.filleted.insert(edge);
    BlendSheet sheet(body_, options_.intersection.tolerances.point);
    for (const EdgeRun& run : edge_runs(body_, own)) sheet.add(ball_walk(body_, run, walking));
    check_limit(&limit_, kFilleting);
    sheet.build();
    check_limit(&limit_, kFilleting);
    std::vector<TrimmedFace> faces =
        trimmed_by_sheet(body_, sheet, options_.intersection.tolerances.point);
    notes_.insert(notes_.end(), sheet.notes().begin(), sheet.notes().end());
    all.push_back(closed(part, faces, own));
    check(part, all.back(), own);
    check_apart(all.back());
  }
  return all;
}

void check_request(const BodyEdges& body, const std::vector<int>& edges,
                   const FilletOptions& options) {
  if (!(options.radius > 0) || !std::isfinite(options.radius))
    throw InvalidInput("fillet: the radius has to be positive and finite");
  if (edges.empty()) throw InvalidInput("fillet: no edge is named");
  for (const int edge : edges)
    if (edge < 1 || edge > body.edge_count())
      throw InvalidInput("fillet: there is no edge " + std::to_string(edge) + ", only 1 to " +
                         std::to_string(body.edge_count()));
}

// The chains of the edges that can have fillets; the others are refused.
std::vector<FilletEdges> chains_of(const BodyEdges& body, const std::vector<int>& edges,
                                   std::vector<FilletRefusal>& refused) {
  std::vector<FilletEdges> chains;
  for (const int edge : edges) {
    if (std::ranges::any_of(chains, [&](const auto& chain) { return chain.count(edge) > 0; }))
      continue;
    try {
      chains.push_back(smooth_chain(body, edge));
    } catch (const FilletRefused& refusal) {
      refused.push_back(refusal.why());
    }
  }
  return chains;
}

// The largest radius of the edge at fault, where it is the radius that does not fit.
void add_limit(const BodyEdges& body, const std::vector<FilletEdges>& chains, double radius,
               FilletRefusal& why) {
  const bool of_radius = why.fault == FilletFault::NoBall || why.fault == FilletFault::Pinch ||
                         why.fault == FilletFault::LeavesFace;
  if (!of_radius || why.largest) return;
  for (const FilletEdges& chain : chains) {
    const auto edge = chain.find(why.edge);
    if (edge == chain.end()) continue;
    if (const auto limit = fillet_limit(body, edge->first, edge->second, radius)) {
      why.largest = limit->radius;
      why.cause += "; larger balls are stopped by " + limit->cause;
    }
  }
}

// What went wrong where no edge is known to be at fault.
FilletRefusal not_put_together(const std::exception& error) {
  return {FilletFault::Result,
          0,
          std::string("the strips cannot be put into the solid together: ") + error.what(),
          {},
          {},
          {}};
}

}  // namespace

FilletResult fillet(const TopoDS_Shape& shape, const std::vector<int>& edges,
                    const FilletOptions& options) {
  if (shape.IsNull()) throw InvalidInput("fillet: there is no shape");
  FilletResult result;
  Filleting work(shape, options);
  check_request(work.body(), edges, options);
  for (const SolidPart& part : work.parts()) result.volume_before += part.volume;
  std::vector<FilletEdges> chains = chains_of(work.body(), edges, result.refused);
  const auto refuse = [&](const FilletRefusal& why) {
    result.refused.push_back(why);
    add_limit(work.body(), chains, options.radius, result.refused.back());
    const auto at_fault =
        std::ranges::find_if(chains, [&](const auto& chain) { return chain.count(why.edge) > 0; });
    chains.erase(at_fault == chains.end() ? chains.end() - 1 : at_fault);
  };
  while (!chains.empty() && (options.partial || result.refused.empty())) {
    FilletEdges all;
    for (const FilletEdges& chain : chains) all.insert(chain.begin(), chain.end());
    try {
      result.solids = guarded(kFilleting, [&] { return work.made(all); });
      for (const auto& [edge, concave] : all) result.edges.push_back(edge);
      result.notes = work.notes();
      return result;
    } catch (const FilletRefused& refusal) {
      refuse(refusal.why());
    } catch (const LimitFailure& reached) {
      result.refused.push_back({FilletFault::Result, 0, reached.what(), {}, {}, {}});
      result.status = Status::Stopped;
      return result;
    } catch (const Failure& failure) {
      refuse(not_put_together(failure));
    } catch (const BadModel& error) {
      refuse(not_put_together(error));
    }
  }
  return result;
}

}  // namespace blossom::occt
