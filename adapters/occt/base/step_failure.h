// SPDX-License-Identifier: LGPL-2.1-or-later
// A step of a job that may fail on the faces that it is given, without an end of the job.

#pragma once

#include <string>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"

namespace blossom::occt {

/// Why a step fails on what it is given; empty if it does not. What else it throws is not the
/// faces' fault and ends the job: that there is no memory, or what the caller's question throws.
///
/// doing   as of `guarded`
template <class Step>
std::string failure_of(const char* doing, const Step& step) {
  try {
    guarded(doing, step);
  } catch (const Failure& failure) {
    return failure.what();
  } catch (const BadModel& fault) {
    return fault.what();
  } catch (const InvalidInput& refusal) {  // of the core: numbers that make no geometry
    return refusal.what();
  }
  return {};
}

}  // namespace blossom::occt
