// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/fillet_attempt.h"

#include <exception>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

// What went wrong where no edge is known to be at fault.
FilletRefusal not_put_together(const std::exception& error) {
  return {FilletFault::Result,
          0,
          std::string("the strips cannot be put into the solid together: ") + error.what(),
          {},
          {},
          {}};
}

FilletAttempt attempt(Filleting& work, const FilletEdges& all, double radius) {
  try {
    FilletAttempt made{guarded(kFilleting, [&] { return work.made(all, radius); }), {}, {}, {}};
    made.notes = work.notes();
    made.gone_on = work.gone_on();
    made.is_tolerant = work.is_tolerant();
    return made;
  } catch (const FilletRefused& refusal) {
    return {{}, {}, {}, refusal.why()};
  } catch (const LimitFailure&) {
    throw;
  } catch (const Failure& failure) {
    return {{}, {}, {}, not_put_together(failure)};
  } catch (const BadModel& error) {
    return {{}, {}, {}, not_put_together(error)};
  } catch (const InvalidInput& error) {  // of the core: numbers that make no geometry
    return {{}, {}, {}, not_put_together(error)};
  }
}

// The chains with edges in which they go on with a bend: all that were not among them.
FilletEdges with_bends(const BodyEdges& body, const std::vector<FilletEdges>& chains,
                       const FilletEdges& all) try {
  FilletEdges grown = all;
  for (const FilletEdges& chain : chains)
    for (const auto& each : bent_chain(body, chain)) grown.insert(each);
  return grown;
} catch (const FilletRefused&) {
  return all;
}

std::string bends_note(const FilletEdges& all, const FilletEdges& grown) {
  std::string edges;
  int count = 0;
  for (const auto& [edge, concave] : grown) {
    if (all.count(edge) > 0) continue;
    edges += (count++ == 0 ? "" : ", ") + std::to_string(edge);
  }
  return std::string("the fillet goes on over slight bends in ") +
         (count == 1 ? "edge " : "edges ") + edges +
         ": before them it could not end, or not where its edges do";
}

}  // namespace

FilletAttempt fillet_attempt(Filleting& work, const std::vector<FilletEdges>& chains,
                             double radius) {
  FilletEdges all;
  for (const FilletEdges& chain : chains) all.insert(chain.begin(), chain.end());
  FilletAttempt made = attempt(work, all, radius);
  const bool is_whole = !made.why && !made.is_tolerant;
  if (is_whole || (made.why && made.why->fault == FilletFault::Edge) || !work.own().empty())
    return made;
  const FilletEdges grown = with_bends(work.body(), chains, all);
  if (grown.size() == all.size()) return made;
  FilletAttempt further = attempt(work, grown, radius);
  if (further.why || (!made.why && further.is_tolerant)) return made;
  for (const auto& [edge, concave] : grown)
    if (all.count(edge) == 0) further.gone_on.insert(edge);
  further.notes.push_back(bends_note(all, grown));
  return further;
}

std::optional<FilletRefusal> roll_attempt(Filleting& work, const std::vector<FilletEdges>& chains,
                                          double radius) {
  FilletEdges all;
  for (const FilletEdges& chain : chains) all.insert(chain.begin(), chain.end());
  try {
    guarded(kFilleting, [&] {
      work.roll(all, radius);
      return 0;
    });
    return std::nullopt;
  } catch (const FilletRefused& refusal) {
    return refusal.why();
  } catch (const LimitFailure&) {
    throw;
  } catch (const Failure& failure) {
    return not_put_together(failure);
  } catch (const BadModel& error) {
    return not_put_together(error);
  } catch (const InvalidInput& error) {
    return not_put_together(error);
  }
}

bool is_own_fault(FilletFault fault) {
  return fault == FilletFault::Edge || fault == FilletFault::NoBall ||
         fault == FilletFault::Pinch || fault == FilletFault::LeavesFace;
}

}  // namespace blossom::occt
