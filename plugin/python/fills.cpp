// SPDX-License-Identifier: LGPL-2.1-or-later
// Filling holes.

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/pictures/results/blends.h"
#include "plugin/python/answers.h"
#include "plugin/reports/blends/fill.h"

namespace blossom::python {
namespace {

FillContinuity continuity_of(const std::string& word) {
  for (const FillContinuity known : {FillContinuity::G0, FillContinuity::G1, FillContinuity::G2})
    if (word == to_string(known)) return known;
  throw InvalidInput("continuity: '" + word + "' is none of G0, G1, G2");
}

std::optional<FillLayout> layout_of(const std::string& word) {
  static const std::map<std::string, FillLayout> layouts = {
      {"star", FillLayout::Star}, {"ring", FillLayout::Ring}, {"deep-ring", FillLayout::DeepRing}};
  const auto found = layouts.find(word);
  return found == layouts.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

Answer fill(const SharedModel& model, const FillWish& wish, const Control& control) {
  reports::FillWishes wishes{.edges = wish.edges, .continuity = {}};
  for (const std::string& word : wish.continuity) wishes.continuity.push_back(continuity_of(word));
  wishes.options.fill.tolerances.point = control.engine.tolerances.point;
  wishes.options.fill.angle = wish.angle;
  wishes.options.fill.layout = layout_of(wish.layout);
  return interruptible(control, [&](const Watch& watch) {
    if (model->is_part())
      throw occt::BadModel(model->name() + ": holes are filled in whole models, not in some faces");
    const LoadedModel::Turn turn = model->turn(watch);
    model->faces(watch);
    const reports::Input& input = model->repaired_input(watch);
    const auto step = [&watch] { watch.stop(); };
    const auto kept =
        std::make_shared<const reports::FillAnswer>(reports::fill_holes(input, wishes, step));
    const reports::FillAnswer& made = *kept;
    const double tolerance = control.engine.tolerances.point;
    occt::Model filled = wish.sew ? reports::filled_model(input, made, tolerance, step)
                                  : reports::fills_alone(made, tolerance);
    Answer answer = made_answer(
        with_reading(reports::fill_report(input, made), {model}),
        std::make_shared<LoadedModel>("fill", std::move(filled), reports::Repairing::None));
    answer.picture = in_turns(
        {model}, [kept, own = kept_input(input)] { return pictures::fill_picture(*own, *kept); });
    return answer;
  });
}

}  // namespace blossom::python
