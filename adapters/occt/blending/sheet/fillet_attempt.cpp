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

}  // namespace

FilletAttempt fillet_attempt(Filleting& work, const std::vector<FilletEdges>& chains,
                             double radius) {
  FilletEdges all;
  for (const FilletEdges& chain : chains) all.insert(chain.begin(), chain.end());
  try {
    FilletAttempt made{guarded(kFilleting, [&] { return work.made(all, radius); }), {}, {}, {}};
    made.notes = work.notes();
    made.gone_on = work.gone_on();
    return made;
  } catch (const FilletRefused& refusal) {
    return {{}, {}, {}, refusal.why()};
  } catch (const LimitFailure&) {
    throw;
  } catch (const Failure& failure) {
    return {{}, {}, {}, not_put_together(failure)};
  } catch (const BadModel& error) {
    return {{}, {}, {}, not_put_together(error)};
  }
}

bool is_own_fault(FilletFault fault) {
  return fault == FilletFault::Edge || fault == FilletFault::NoBall ||
         fault == FilletFault::Pinch || fault == FilletFault::LeavesFace;
}

}  // namespace blossom::occt
