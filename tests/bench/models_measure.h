// SPDX-License-Identifier: LGPL-2.1-or-later
// Processor time of work that may not end.

#pragma once

#include <functional>

#include <TopoDS_Shape.hxx>

#include "core/base/status.h"
#include "tests/bench/apart.h"

namespace blossom::bench {

/// What one side found; plain values, so that it can be passed between processes.
struct Outcome {
  bool ended = true;    ///< false: it ran into the limit, and there is nothing but the seconds
  bool failed = false;  ///< it gave up, or its process died
  Status status = Status::Complete;
  double seconds = 0;  ///< processor time
  double length = 0;   ///< of all curves, model units
  long pairs = 0;      ///< pairs of faces, or faces, that were looked at
  long curves = 0;
  long places = 0;
  long open = 0;  ///< wires that are not closed
};

/// Does work in a process of its own, no longer than `limit` seconds of processor time.
Outcome measured(double limit, const std::function<Outcome()>& work);

/// Sum over the edges of a shape, model units.
double length_of(const TopoDS_Shape& shape);

}  // namespace blossom::bench
