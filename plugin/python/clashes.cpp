// SPDX-License-Identifier: LGPL-2.1-or-later
// How pairs of parts lie to each other.

#include <memory>
#include <utility>
#include <vector>

#include "plugin/pictures/results/clash.h"
#include "plugin/python/answers.h"
#include "plugin/reports/queries/clash.h"

namespace blossom::python {
namespace {

// An answer refers to its inputs.
struct KeptClash {
  std::vector<std::shared_ptr<const reports::Input>> inputs;
  reports::ClashAnswer answer;
};

}  // namespace

Answer clash(const SharedModel& a, const SharedModel& b, std::optional<double> clearance, bool far,
             const Control& control) {
  std::vector<SharedModel> models{a};
  if (b) models.push_back(b);
  return interruptible(control, [&](const Watch& watch) {
    const BothTurns turns(*a, b ? *b : *a, watch);
    const auto kept = std::make_shared<KeptClash>();
    reports::ClashAnswer& answer = kept->answer;
    answer.tolerance = control.engine.tolerances.point;
    answer.clearance = clearance;
    answer.lists_far = far;
    for (const SharedModel& model : models) {
      model->faces(watch);
      kept->inputs.push_back(kept_input(model->repaired_input(watch)));
      reports::add_input(answer, *kept->inputs.back());
    }
    reports::look_for_clashes(answer, watch.engine());
    watch.stop();
    occt::Model common = reports::common_bodies(answer);
    Answer made = made_answer(
        with_reading(reports::clash_report(answer), models),
        common.shape().IsNull()
            ? nullptr
            : std::make_shared<LoadedModel>("clash", std::move(common), reports::Repairing::None));
    made.picture = in_turns(models, [kept] { return pictures::clash_picture(kept->answer); });
    return made;
  });
}

}  // namespace blossom::python
