// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/detail.h"

#include <algorithm>

#include "adapters/occt/base/errors.h"

namespace blossom::occt {

void refuse(const std::string& cause, const ReadingReport& report) {
  const auto lost = std::ranges::find_if(report.losses, [](const Loss& l) { return l.of_shape; });
  if (lost == report.losses.end()) throw BadModel(cause);
  throw BadModel("holds no shape that can be used: " + lost->text());
}

void Reading::begin(const char* doing) {
  step = doing;
  if (!options.step) return;
  asking = true;
  options.step((step + " of " + file.string()).c_str());
  asking = false;
}

void Reading::lose_names(const std::string& cause) {
  // Before all else that touches no shape: it is what users miss first.
  report.losses.insert(report.losses.begin(), {"names, colours, dimensions and assembly", cause});
}

}  // namespace blossom::occt
