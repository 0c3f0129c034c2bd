// SPDX-License-Identifier: LGPL-2.1-or-later
// Control nets of faces and edges: pieces of them, and other forms.

#include <memory>
#include <utility>

#include "core/base/errors.h"
#include "plugin/nets/conversion.h"
#include "plugin/nets/net_json.h"
#include "plugin/nets/net_models.h"
#include "plugin/nets/subdivision.h"
#include "plugin/pictures/results/subdivisions.h"
#include "plugin/python/answers.h"
#include "plugin/python/json.h"
#include "plugin/reports/models/repairs.h"

namespace py = pybind11;
using namespace py::literals;

namespace blossom::python {
namespace {

using reports::Json;
using SharedNets = std::shared_ptr<const std::vector<nets::Net>>;

Json repairs_of(const reports::Input& input) { return Json::array({reports::repairs_json(input)}); }

nets::Stop stop_of(const Watch& watch) {
  return [&watch] { watch.stop(); };
}

// What was made of a model's faces in their places; of edges as parts.
SharedModel shape_of(const SharedModel& of, const SharedNets& made, const std::string& name) {
  if (made->empty()) return nullptr;
  if (made->front().source.face == 0)
    return std::make_shared<LoadedModel>(name, nets::model_of_nets(*made),
                                         reports::Repairing::None);
  const LoadedModel::Turn turn = of->turn(Watch());
  occt::Model copy = of->model().copy();
  nets::put_nets(copy, *made);
  return std::make_shared<LoadedModel>(name, std::move(copy), reports::Repairing::None);
}

Answer nets_answer(const SharedModel& model, Json report, std::vector<nets::Net> nets,
                   const char* name) {
  const auto told = std::make_shared<const Json>(with_reading(std::move(report), {model}));
  const SharedNets made = std::make_shared<const std::vector<nets::Net>>(std::move(nets));
  return {.report = [told] { return *told; },
          .model = [model, made, name] { return shape_of(model, made, name); },
          .records = [made] { return net_records(*made); }};
}

}  // namespace

py::dict net_records(const std::vector<nets::Net>& made) {
  Json list = Json::array();
  for (const nets::Net& net : made) list.push_back(nets::to_json(net));
  return py::dict("nets"_a = to_python(list));
}

Answer subdivide(const SharedModel& model, const nets::Cut& wanted, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    const reports::Input& input = model->repaired_input(watch, reports::LooseFaces::Kept);
    nets::Cut cut = wanted;
    cut.stop = stop_of(watch);
    const bool edges = cut.interval || input.faces.empty();
    const std::vector<nets::Net> nets =
        edges ? nets::nets_of_edges(input, !model->is_part(), cut.stop)
              : nets::nets_of_faces(input, cut.stop);
    nets::Subdivision made = nets::subdivided(input.name, nets, cut);
    Json report = nets::subdivision_report(made, repairs_of(input));
    const auto kept = std::make_shared<const std::vector<nets::Net>>(made.pieces);
    Answer answer = nets_answer(model, std::move(report), std::move(made.pieces), "subdivision");
    answer.picture = [kept, name = input.name, count = nets.size()](const Watch& looking) {
      return pictures::subdivision_picture(name, *kept, count, stop_of(looking));
    };
    return answer;
  });
}

Answer subdivide_whole(const SharedModel& model, const nets::WholeCut& wanted,
                       const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    const reports::Input& input = model->repaired_input(watch, reports::LooseFaces::Kept);
    nets::WholeCut cut = wanted;
    cut.all_edges = !model->is_part();
    cut.stop = stop_of(watch);
    const double start = watch.seconds();
    const auto parts = nets::whole_parts(input, cut);
    const double seconds = watch.seconds() - start;
    const bool edges = parts.front().source.face == 0;
    occt::Model made = edges ? nets::model_of_whole_edges(parts) : input.model.copy();
    if (!edges) nets::put_whole_faces(made, parts);
    Answer answer = made_answer(
        with_reading(nets::whole_report(input, cut, parts, seconds), {model}),
        std::make_shared<LoadedModel>("subdivision", std::move(made), reports::Repairing::None));
    answer.picture = [parts, name = input.name](const Watch&) {
      return pictures::whole_picture(name, parts);
    };
    return answer;
  });
}

Answer convert(const SharedModel& model, const std::string& to, const Control& control) {
  const auto form = nets::target_form(to);
  if (!form) throw InvalidInput("to: '" + to + "' is none of bezier, monomial, triangles");
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    model->faces(watch);
    const reports::Input& input = model->repaired_input(watch);
    const nets::Stop stop = stop_of(watch);
    nets::Conversion made = nets::converted_faces(input, nets::nets_of_faces(input, stop), *form,
                                                  control.engine.tolerances.point, stop);
    Json report = nets::conversion_report(input.name, "", to, made, repairs_of(input));
    report["output"] = nullptr;
    Answer answer = nets_answer(model, std::move(report), std::move(made.nets), "conversion");
    if (*form == nets::TargetForm::Monomial) answer.model = {};  // models have no such form
    return answer;
  });
}

}  // namespace blossom::python
