// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/nets/net.h"

namespace blossom::nets {

template <class Work>
auto named(const NetSource& source, Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const InvalidInput& error) {
    throw occt::BadModel(text_of(source) + ": " + error.what());
  } catch (const occt::BadModel& error) {
    throw occt::BadModel(text_of(source) + ": " + error.what());
  }
}

}  // namespace blossom::nets
