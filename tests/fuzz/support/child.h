// SPDX-License-Identifier: LGPL-2.1-or-later
// Work in a process of its own, as the program reads models: Open CASCADE's readers crash on some
// damaged files, which is no finding, and no reason to end.

#pragma once

#include <functional>

namespace blossom::fuzz {

/// What may call `may_crash` when a crash from then on is Open CASCADE's, and may not.
class Parts {
 public:
  virtual ~Parts() = default;
  virtual void reading() = 0;  ///< Open CASCADE reads; it may crash, or not come to an end
  virtual void ours() = 0;     ///< what follows is ours
};

/// Does the work in a child. A signal in `reading`, or more time than an input may take, is let
/// pass; every other end but the ordinary one ends this process by SIGABRT. What libFuzzer counts
/// in the child, it sees.
void in_child(const std::function<void(Parts&)>& work);

}  // namespace blossom::fuzz
