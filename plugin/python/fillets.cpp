// SPDX-License-Identifier: LGPL-2.1-or-later
// Rounding edges of solids, and cutting them off.

#include <memory>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "plugin/pictures/results/blends.h"
#include "plugin/python/answers.h"
#include "plugin/reports/blends/fillet.h"
#include "plugin/reports/models/selection.h"

namespace blossom::python {

Answer blend_edges(const SharedModel& part, const reports::EdgeWish& wish,
                   const occt::FilletOptions& of, bool full_round, const Control& control) {
  const std::string kind = of.chamfer ? "chamfer" : "fillet";
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = part->turn(watch);
    const reports::Input& input = part->repaired_input(watch);
    if (!reports::is_of_solids(input))
      throw occt::BadModel(part->name() + ": " + kind +
                           "s are made in whole models and parts, not in some faces");
    const double start = watch.seconds();
    std::string note;
    reports::FilletAnswer answer{.of = of, .asked = reports::edges_asked(wish, input, note)};
    if (full_round) answer.of.own = reports::full_round_of(input, answer.asked);
    answer.of.intersection = watch.engine();
    answer.made = occt::fillet(input.model.shape(), answer.asked, answer.of);
    if (!note.empty()) answer.made.notes.push_back(note);
    answer.seconds = watch.seconds() - start;
    watch.stop();
    SharedModel made;
    if (!answer.made.solids.empty() || reports::is_unchanged(answer.made)) {
      occt::Model copy = input.model.copy();
      reports::put_fillets(copy, answer);
      made = std::make_shared<LoadedModel>(kind, std::move(copy), reports::Repairing::None);
    }
    const bool any = made != nullptr;
    Answer told =
        made_answer(with_reading(reports::fillet_report(input, answer), {part}), std::move(made));
    const auto kept = std::make_shared<const reports::FilletAnswer>(std::move(answer));
    if (any)
      told.picture = in_turns({part}, [kept, own = kept_input(input)] {
        return pictures::fillet_picture(*own, *kept);
      });
    return told;
  });
}

}  // namespace blossom::python
