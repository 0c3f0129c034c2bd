// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenMesh tells the terminal what goes wrong; what matters is in exceptions.

#pragma once

#include <OpenMesh/Core/System/omstream.hh>

namespace blossom::openmesh {

/// No word of OpenMesh as long as it lives.
class Silence {
 public:
  Silence() : log_(omlog().is_enabled()), errors_(omerr().is_enabled()) {
    omlog().disable();
    omerr().disable();
  }
  ~Silence() {
    if (log_) omlog().enable();
    if (errors_) omerr().enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  bool log_;
  bool errors_;
};

}  // namespace blossom::openmesh
