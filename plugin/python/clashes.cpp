// SPDX-License-Identifier: LGPL-2.1-or-later
// How pairs of parts lie to each other.

#include <utility>
#include <vector>

#include "plugin/python/answers.h"
#include "plugin/reports/queries/clash.h"

namespace blossom::python {

Answer clash(const SharedModel& a, const SharedModel& b, std::optional<double> clearance, bool far,
             const Control& control) {
  std::vector<SharedModel> models{a};
  if (b) models.push_back(b);
  return interruptible(control, [&](const Watch& watch) {
    const BothTurns turns(*a, b ? *b : *a, watch);
    reports::ClashAnswer answer;
    answer.tolerance = control.engine.tolerances.point;
    answer.clearance = clearance;
    answer.lists_far = far;
    for (const SharedModel& model : models) {
      model->faces(watch);
      reports::add_input(answer, model->repaired_input(watch));
    }
    reports::look_for_clashes(answer, watch.engine());
    watch.stop();
    occt::Model common = reports::common_bodies(answer);
    return made_answer(
        with_reading(reports::clash_report(answer), models),
        common.shape().IsNull()
            ? nullptr
            : std::make_shared<LoadedModel>("clash", std::move(common), reports::Repairing::None));
  });
}

}  // namespace blossom::python
