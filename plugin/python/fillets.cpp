// SPDX-License-Identifier: LGPL-2.1-or-later
// Rounding edges of solids, and cutting them off.

#include <set>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/python/answers.h"
#include "plugin/reports/blends/fillet.h"

namespace blossom::python {
namespace {

// note   what else there is, if all edges are meant
std::vector<int> edges_asked(const EdgeWish& wish, const reports::Input& input, std::string& note) {
  std::set<int> edges(wish.edges.begin(), wish.edges.end());
  if (!wish.kind.empty() || wish.between) {
    const std::vector<occt::EdgeFacts> facts = occt::edge_facts(input.model.shape());
    if (wish.between) {
      const auto [face, other] = *wish.between;
      const std::vector<int> common = reports::edges_between(facts, face, other);
      if (common.empty())
        throw InvalidInput("between: faces " + std::to_string(face) + " and " +
                           std::to_string(other) + " have no edge in common");
      edges.insert(common.begin(), common.end());
    }
    if (wish.kind == "all") note = reports::left_out(facts);
    if (!wish.kind.empty())
      for (const int edge : reports::edges_to_round(facts, wish.kind)) edges.insert(edge);
  }
  if (edges.empty()) throw occt::BadModel(input.name + ": it has no edges that can be rounded");
  return {edges.begin(), edges.end()};
}

}  // namespace

Answer blend_edges(const SharedModel& part, const EdgeWish& wish, const occt::FilletOptions& of,
                   const Control& control) {
  const std::string kind = of.chamfer ? "chamfer" : "fillet";
  return interruptible(control, [&](const Watch& watch) {
    if (part->is_part())
      throw occt::BadModel(part->name() + ": " + kind +
                           "s are made in whole models, not in some faces");
    const LoadedModel::Turn turn = part->turn(watch);
    const reports::Input& input = part->repaired_input(watch);
    const double start = watch.seconds();
    std::string note;
    reports::FilletAnswer answer{.of = of, .asked = edges_asked(wish, input, note)};
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
    return made_answer(with_reading(reports::fillet_report(input, answer), {part}),
                       std::move(made));
  });
}

}  // namespace blossom::python
