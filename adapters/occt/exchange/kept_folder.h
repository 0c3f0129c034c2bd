// SPDX-License-Identifier: LGPL-2.1-or-later
// The folder of kept models, as read_model uses it; see kept_models.h. For this folder only.

#pragma once

#include <string>

#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

/// The entry of a file in the folder of models.
class KeptModel {
 public:
  /// Of the content and the options of a reading; none if this process keeps no models, or if what
  /// they do not have is asked for.
  explicit KeptModel(const Reading& reading);

  /// Takes the contents and the report. Whether they are there.
  bool take(Reading& reading, StatedTolerances& stated) const;

  /// Puts them there, if they are the same when they are taken. What goes wrong with that is no
  /// fault of the reading, and only costs the next one time.
  void keep(const Reading& reading, StatedTolerances stated) const;

 private:
  std::filesystem::path file_;  // empty for none
};

}  // namespace blossom::occt
