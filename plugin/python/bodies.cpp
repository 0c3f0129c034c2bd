// SPDX-License-Identifier: LGPL-2.1-or-later
// Questions that make shapes: trims, solids, watertight pieces, strips.

#include <list>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include <TopExp_Explorer.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/half_space.h"
#include "adapters/occt/watertight.h"
#include "core/base/errors.h"
#include "core/base/work_limit.h"
#include "plugin/pictures/results/blends.h"
#include "plugin/pictures/results/trim.h"
#include "plugin/python/answers.h"
#include "plugin/python/arrays.h"
#include "plugin/python/json.h"
#include "plugin/reports/blends/strip.h"
#include "plugin/reports/cuts/solids.h"
#include "plugin/reports/cuts/trim.h"
#include "plugin/reports/cuts/watertight.h"
#include "plugin/reports/models/repairs.h"
#include "plugin/reports/models/selection.h"

namespace py = pybind11;
using namespace py::literals;

namespace blossom::python {
namespace {

std::vector<SharedModel> with_part(const SharedModel& part, std::vector<SharedModel> tools) {
  tools.insert(tools.begin(), part);
  return tools;
}

// What was made, which may be edges or a vertex alone; null if nothing was.
SharedModel made_model(const std::string& name, occt::Model model) {
  if (!TopExp_Explorer(model.shape(), TopAbs_VERTEX).More()) return nullptr;
  return std::make_shared<LoadedModel>(name, std::move(model), reports::Repairing::None);
}

}  // namespace

Answer made_answer(reports::Json report, SharedModel model) {
  auto shared = std::make_shared<const reports::Json>(std::move(report));
  return {.report = [shared] { return *shared; },
          .model = [model = std::move(model)] { return model; },
          .records = {}};
}

namespace {

auto trim_picture(const std::vector<SharedModel>& models, const reports::Input& part,
                  const std::vector<const reports::Input*>& tools, occt::TrimResult made) {
  std::vector<std::shared_ptr<const reports::Input>> kept;
  for (const reports::Input* const tool : tools) kept.push_back(kept_input(*tool));
  return in_turns(models, [models, kept, own = kept_input(part),
                           shown = std::make_shared<const occt::TrimResult>(std::move(made))] {
    std::vector<const reports::Input*> others;
    for (const auto& tool : kept) others.push_back(tool.get());
    return pictures::trim_picture(*own, others, *shown, stated_status(shown->status, models));
  });
}

}  // namespace

Answer trim(const SharedModel& part, const std::vector<SharedModel>& tools,
            const std::vector<occt::Plane>& planes, const std::string& keep,
            const Control& control) {
  const std::optional<occt::TrimOptions> wanted = reports::trim_options(keep);
  if (!wanted)
    throw InvalidInput(
        "keep: above, below, inside, outside, all or the number of a piece is "
        "wanted, got '" +
        keep + "'");
  return interruptible(control, [&](const Watch& watch) {
    const std::vector<SharedModel> models = with_part(part, tools);
    const Turns turns = turns_of(models, watch);
    part->faces(watch);
    const reports::Input& input = part->repaired_input(watch);
    std::vector<const reports::Input*> others;
    std::vector<occt::TrimTool> cutters;
    for (const SharedModel& tool : tools) {
      tool->faces(watch);
      others.push_back(&tool->repaired_input(watch));
      cutters.push_back(reports::tool_of(*others.back()));
    }
    for (std::size_t i = 0; i < planes.size(); ++i)
      cutters.push_back(occt::plane_tool(planes[i], input.model.shape(), reports::plane_name(i)));
    const double start = watch.seconds();
    occt::TrimOptions options = *wanted;
    options.intersection = watch.engine();
    reports::TrimAnswer answer{.planes = planes, .keep = keep};
    answer.made = occt::trim(reports::part_faces(input), cutters, options);
    answer.seconds = watch.seconds() - start;
    for (const reports::Input* tool : others) reports::note_invalid_faces(*tool, answer.made);
    watch.stop();
    occt::Model made = input.model.copy();
    made.replace_faces(answer.made.replacements);
    Answer told = made_answer(with_reading(reports::trim_report(input, others, answer), models),
                              made_model("trim", std::move(made)));
    told.picture = trim_picture(models, input, others, std::move(answer.made));
    return told;
  });
}

namespace {

occt::TrimTool named_tool(const occt::Model& model, const std::string& name) {
  occt::TrimTool tool = occt::trim_tool(model.shape());
  tool.name = name;
  return tool;
}

// The model of an input, or of the parts that it names alone.
const occt::Model& named_of(const reports::Input& input, std::list<occt::Model>& alone) {
  std::optional<occt::Model> named = reports::alone_for_solids(input);
  return named ? alone.emplace_back(std::move(*named)) : input.model;
}

// What gives the faces of a cut along a plane their name: the plane as a part.
occt::Model plane_model(const occt::Plane& plane, const TopoDS_Shape& part,
                        const std::string& name) {
  occt::Model model;
  model.add(occt::plane_tool(plane, part, name).faces.front(), name);
  return model;
}

// The part with what was made in the place of its solids.
occt::Model combined_model(const occt::SolidTrimResult& made, const occt::Model& part,
                           const std::vector<const occt::Model*>& tools) {
  if (made.of_wires) return reports::wires_model(made, part);
  if (!made.sheets.empty()) return reports::sheets_model(made, part, tools);
  occt::Model model = part.copy();
  std::vector<occt::CombinedSolid> solids;
  for (const TopoDS_Solid& solid : made.solids)
    solids.push_back({solid, reports::origins_of(solid, made, model, tools)});
  model.replace_solids(solids, occt::CommonFaces::Keep);
  return model;
}

}  // namespace

Answer combine_solids(const std::string& operation, const SharedModel& part,
                      const std::vector<SharedModel>& tools, const std::vector<occt::Plane>& planes,
                      const Control& control) {
  const std::optional<occt::SolidOperation> wanted = reports::solid_operation(operation);
  if (!wanted)
    throw InvalidInput("operation: '" + operation + "' is none of cut, common, fuse, split");
  if (*wanted == occt::SolidOperation::Fuse && !planes.empty())
    throw InvalidInput("planes: fuse takes none, what is above a plane has no end");
  return interruptible(control, [&](const Watch& watch) {
    const std::vector<SharedModel> models = with_part(part, tools);
    const Turns turns = turns_of(models, watch);
    const reports::Input& input = part->repaired_input(watch, reports::LooseFaces::OpenSewn);
    reports::SolidAnswer answer{.part = input.name, .planes = planes, .operation = operation};
    answer.repairs.push_back(reports::repairs_json(input));
    std::vector<occt::TrimTool> cutters;
    std::vector<const occt::Model*> origins;
    std::list<occt::Model> alone;
    const occt::Model& own = named_of(input, alone);
    for (const SharedModel& tool : tools) {
      const reports::Input& other = tool->repaired_input(watch, reports::LooseFaces::OpenSewn);
      answer.tools.push_back(other.name);
      answer.repairs.push_back(reports::repairs_json(other));
      origins.push_back(&named_of(other, alone));
      cutters.push_back(named_tool(*origins.back(), other.name));
    }
    std::list<occt::Model> plane_models;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      cutters.push_back(occt::half_space_tool(planes[i], own.shape(), reports::plane_name(i)));
      plane_models.push_back(plane_model(planes[i], own.shape(), reports::plane_name(i)));
      origins.push_back(&plane_models.back());
    }
    const occt::TrimTool whole = named_tool(own, input.name);
    if (const std::string cause = occt::misplaced_sheet(whole, cutters, *wanted); !cause.empty())
      throw occt::BadModel(cause);
    const double start = watch.seconds();
    answer.made = occt::trim_solids(whole, cutters, *wanted, watch.engine());
    answer.seconds = watch.seconds() - start;
    reports::note_faces(answer);
    watch.stop();
    SharedModel made = made_model(operation, combined_model(answer.made, own, origins));
    const bool any = made != nullptr;
    Answer told = made_answer(with_reading(reports::solid_report(answer), models), std::move(made));
    const auto kept = std::make_shared<const reports::SolidAnswer>(std::move(answer));
    if (any) told.picture = in_turns(models, [kept] { return pictures::solids_picture(*kept); });
    return told;
  });
}

namespace {

py::dict piece_record(const WatertightPiece& piece) {
  py::dict record("face"_a = piece.face + 1);
  if (const auto* triangle = std::get_if<BezierTriangle>(&piece.form)) {
    record["kind"] = "triangle";
    record["degree"] = triangle->degree;
    record["points"] = points_array(std::span<const Vec3>(triangle->points));
    return record;
  }
  const Grid<Vec3>& net = std::get<BezierPatch>(piece.form).points;
  record["kind"] = "patch";
  record["degree"] = py::make_tuple(net.rows() - 1, net.columns() - 1);
  record["points"] = points_array(std::span<const Vec3>(net.values()))
                         .attr("reshape")(net.rows(), net.columns(), 3);
  return record;
}

}  // namespace

Answer watertight(const SharedModel& model, const Control& control) {
  auto made =
      std::make_shared<occt::WatertightShape>(interruptible(control, [&](const Watch& watch) {
        const LoadedModel::Turn turn = model->turn(watch);
        model->faces(watch);
        const reports::Input& input = model->repaired_input(watch);
        const IntersectionOptions left = watch.engine();
        const WorkLimit limit(left);
        WatertightOptions options;
        options.tolerance = occt::kWatertightFactor * control.engine.tolerances.point;
        options.ask = [&limit] { return limit.reached() == nullptr; };
        return occt::watertight(reports::chosen_shape(input), options);
      }));
  if (!made->pieces.obstacle.empty() && made->pieces.open.empty())
    throw occt::BadModel(model->name() +
                         ": the faces cannot be made watertight: " + made->pieces.obstacle);
  return {.report =
              [made, model] {
                reports::Json report = reports::to_json(made->pieces);
                report["status"] = to_string(!made->pieces.open.empty()     ? Status::Stopped
                                             : !made->pieces.turned.empty() ? Status::Tolerance
                                                                            : Status::Complete);
                return with_reading(std::move(report), {model});
              },
          .model =
              [made] {
                return made->shape.IsNull()
                           ? nullptr
                           : std::make_shared<LoadedModel>("watertight", made->shape);
              },
          .records =
              [made] {
                py::list pieces;
                for (const WatertightPiece& piece : made->pieces.pieces)
                  pieces.append(piece_record(piece));
                return py::dict("pieces"_a = pieces);
              }};
}

Answer strip_between(const SharedModel& a, const SharedModel& b, const reports::StripWishes& wishes,
                     const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const BothTurns turns(*a, *b, watch);
    for (const SharedModel& model : {a, b})
      if (const std::size_t count = model->faces(watch).size(); count > 1)
        throw occt::BadModel(model->name() + ": one face is wanted, got " + std::to_string(count));
    const reports::Input &from = a->repaired_input(watch), &to = b->repaired_input(watch);
    const double start = watch.seconds();
    const occt::FaceStrip strip = reports::strip_between(from, to, wishes);
    const double seconds = watch.seconds() - start;
    reports::Json report = reports::strip_report(from, to, wishes, strip, seconds);
    Answer told = made_answer(with_reading(std::move(report), {a, b}),
                              std::make_shared<LoadedModel>("strip", strip.face));
    told.picture = in_turns({a, b}, [strip, own = kept_input(from), other = kept_input(to)] {
      return pictures::strip_picture(*own, *other, strip);
    });
    return told;
  });
}

}  // namespace blossom::python
