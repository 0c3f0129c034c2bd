// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/blends/fill.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::reports {
namespace {

/// What is asked of an edge: its own word, else the one for all, which an edge without a neighbour
/// takes as G0.
FillContinuity asked_of(const FillWishes& wishes, const occt::HoleEdge& edge) {
  if (wishes.continuity.size() == 1)
    return edge.face.IsNull() ? FillContinuity::G0 : wishes.continuity.front();
  const auto at = std::find(wishes.edges.begin(), wishes.edges.end(), edge.number);
  return wishes.continuity[static_cast<std::size_t>(at - wishes.edges.begin())];
}

Hole filled(const FillWishes& wishes, double within, occt::HoleLoop loop) {
  Hole hole{.loop = std::move(loop), .filled = {}, .reason = {}, .message = {}};
  std::vector<FillContinuity> continuity;
  for (const occt::HoleEdge& edge : hole.loop) continuity.push_back(asked_of(wishes, edge));
  occt::HoleOptions options = wishes.options;
  options.within = within;
  try {
    hole.filled = occt::filled_hole(hole.loop, continuity, options);
    if (hole.filled.fill.problem != FillProblem::None) {
      hole.reason = to_string(hole.filled.fill.problem);
      hole.message = hole.filled.fill.message;
    }
  } catch (const occt::BadModel& error) {
    hole.reason = "edges";
    hole.message = error.what();
  }
  return hole;
}

occt::SewnHoles sewn(const FillAnswer& answer, const TopoDS_Shape& model, double tolerance) {
  std::vector<occt::FilledHole> filled;
  for (const Hole& hole : answer.all)
    if (hole.reason.empty()) filled.push_back(hole.filled);
  return occt::sewn_holes(filled, model, std::max({tolerance, Tolerances{}.point, answer.within}));
}

Json contact_json(const FillContact& contact) {
  return {{"gap", contact.gap},
          {"normal_angle", contact.normal_angle},
          {"curvature_difference", contact.curvature_difference}};
}

Json edges_json(const occt::HoleLoop& loop) {
  Json edges = Json::array();
  for (const occt::HoleEdge& edge : loop) edges.push_back(edge.number);
  return edges;
}

Json hole_json(const Hole& hole) {
  const Fill& fill = hole.filled.fill;
  Json sides = Json::array();
  for (std::size_t k = 0; k < hole.filled.sides.size(); ++k) {
    const occt::FilledSide& side = hole.filled.sides[k];
    Json json{{"edge", side.edge.number},
              {"asked", to_string(side.continuity)},
              {"exact", side.exact},
              {"fit_error", side.error},
              {"fit_angle", side.angle_error}};
    json.update(contact_json(fill.figures.sides[k]));
    sides.push_back(std::move(json));
  }
  return {{"edges", edges_json(hole.loop)},
          {"layout", hole.filled.flat ? "flat" : to_string(fill.layout)},
          {"patches", hole.filled.faces.size()},
          {"degree", fill.degree},
          {"rational", fill.rational},
          {"reached", to_string(fill.reached)},
          {"largest_curvature", fill.figures.largest_curvature},
          {"residual", fill.residual},
          {"least_weight", fill.least_weight},
          {"inside", contact_json(fill.figures.inside)},
          {"sides", std::move(sides)}};
}

/// Why no hole is filled.
std::string why_nothing(const FillAnswer& holes) {
  if (!holes.all.empty()) return holes.all.front().message;
  if (holes.sheets.empty()) return "no edge is open, so there is no hole";
  std::string edges;
  for (const occt::HoleEdge& edge : holes.sheets.front())
    edges += (edges.empty() ? "" : ",") + std::to_string(edge.number);
  return "there is no hole: its open edges " + edges +
         " are the outer border of a sheet; name them to close it";
}

}  // namespace

FillAnswer fill_holes(const Input& input, const FillWishes& wishes,
                      const std::function<void()>& step) {
  const auto start = std::chrono::steady_clock::now();
  const TopoDS_Shape& model = input.model.shape();
  const bool named = !wishes.edges.empty();
  const occt::OpenBorders borders = occt::open_borders(model, wishes.sew_gap);
  const occt::OpenLoops found =
      named ? occt::OpenLoops{occt::hole_loops(model, wishes.edges, borders.within), {}, {}}
            : occt::open_loops(model, borders);
  FillAnswer holes{.all = {}, .sheets = found.sheets, .within = borders.within};
  for (const occt::HoleLoop& loop : found.holes) {
    step();
    holes.all.push_back(filled(wishes, borders.within, loop));
    if (named && !holes.all.back().reason.empty())
      throw occt::BadModel(input.name + ": " + holes.all.back().message);
  }
  for (const std::string& message : found.left_out)
    holes.all.push_back({.loop = {}, .filled = {}, .reason = "edges", .message = message});
  if (holes.filled() == 0) throw occt::BadModel(input.name + ": " + why_nothing(holes));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  holes.seconds = took.count();
  return holes;
}

occt::Model fills_alone(const FillAnswer& answer, double tolerance) {
  occt::Model alone;
  alone.add(sewn(answer, {}, tolerance).shape, "fill");
  return alone;
}

occt::Model filled_model(const Input& input, const FillAnswer& answer, double tolerance,
                         const std::function<void()>& step) {
  const occt::SewnHoles joined = sewn(answer, input.model.shape(), tolerance);
  step();
  std::map<int, std::vector<TopoDS_Face>> pieces;
  for (std::size_t i = 0; i < joined.faces.size(); ++i)
    if (!joined.faces[i].IsSame(input.model.face(static_cast<int>(i) + 1)))
      pieces[static_cast<int>(i) + 1] = {joined.faces[i]};
  occt::Model model = input.model.copy();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(input.model.shape(), TopAbs_FACE, faces);
  auto patches = joined.patches.begin();
  for (const Hole& hole : answer.all) {
    if (!hole.reason.empty()) continue;
    const auto beside = std::ranges::find_if(
        hole.loop, [](const occt::HoleEdge& edge) { return !edge.face.IsNull(); });
    if (beside == hole.loop.end()) {
      model.add(occt::compound_of(*patches), "fill");
    } else {
      std::vector<TopoDS_Face>& all = pieces[faces.FindIndex(beside->face)];
      if (all.empty()) all.push_back(beside->face);
      all.insert(all.end(), patches->begin(), patches->end());
    }
    ++patches;
  }
  model.replace_faces(pieces);
  model.sew({}, step);
  return model;
}

bool is_as_asked(const FillAnswer& answer) {
  return std::ranges::all_of(answer.all, [](const Hole& hole) {
    return hole.reason.empty() &&
           std::ranges::all_of(hole.filled.sides, [&](const occt::FilledSide& side) {
             return side.continuity <= hole.filled.fill.reached;
           });
  });
}

FillContact worst_of(const Fill& fill) {
  FillContact worst = fill.figures.inside;
  for (const FillContact& side : fill.figures.sides) {
    worst.gap = std::max(worst.gap, side.gap);
    worst.normal_angle = std::max(worst.normal_angle, side.normal_angle);
    worst.curvature_difference = std::max(worst.curvature_difference, side.curvature_difference);
  }
  return worst;
}

Json fill_report(const Input& input, const FillAnswer& holes) {
  Json filled = Json::array(), refused = Json::array(), sheets = Json::array();
  for (const occt::HoleLoop& loop : holes.sheets) sheets.push_back(edges_json(loop));
  for (const Hole& hole : holes.all)
    if (hole.reason.empty())
      filled.push_back(hole_json(hole));
    else
      refused.push_back(
          {{"edges", edges_json(hole.loop)}, {"reason", hole.reason}, {"message", hole.message}});
  return {{"schema", "blossom.blend/1"},
          {"kind", "fill"},
          {"file", input.name},
          {"holes", std::move(filled)},
          {"refused", std::move(refused)},
          {"outer_borders", std::move(sheets)},
          {"seconds", holes.seconds},
          {"repairs", Json::array({repairs_json(input)})}};
}

}  // namespace blossom::reports
