// SPDX-License-Identifier: LGPL-2.1-or-later
// Filling the holes of a model, and what is told of it; see plugin/cli/schemas/blend-1.md.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/blending/hole.h"
#include "adapters/occt/shapes.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

struct FillWishes {
  std::vector<int> edges{};  ///< numbers; none: all that are open
  /// One, or one for each edge. The one for all is G0 at edges without a neighbour.
  std::vector<FillContinuity> continuity{FillContinuity::G1};
  occt::HoleOptions options{};
  std::optional<double> sew_gap{};  ///< as occt::open_borders has it
};

/// A hole and the reason why it was not filled, if there is one.
struct Hole {
  occt::HoleLoop loop;
  occt::FilledHole filled;
  std::string reason;  ///< a word of the report
  std::string message;
};

struct FillAnswer {
  std::vector<Hole> all;
  std::vector<occt::HoleLoop> sheets;  ///< outer borders, which are no holes
  double within = 0;                   ///< as occt::OpenBorders has it
  double seconds = 0;

  std::size_t filled() const {
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [](const Hole& hole) { return hole.reason.empty(); }));
  }
};

/// Fills what is meant: edges that were named have to be filled all; of all open ones those that
/// can be.
/// step     asked for every hole; ends the work by an exception
/// throws   occt::BadModel if nothing can be filled, or not all that was named
FillAnswer fill_holes(const Input& input, const FillWishes& wishes,
                      const std::function<void()>& step);

/// The filled holes as faces, alone in a part.
occt::Model fills_alone(const FillAnswer& answer, double tolerance);

/// The model with its names, looks and assembly, in which each patch is beside a neighbour, looks
/// like it and belongs to its part; what closes is a solid.
/// step     as of fill_holes
occt::Model filled_model(const Input& input, const FillAnswer& answer, double tolerance,
                         const std::function<void()>& step);

/// Whether all holes are filled as smoothly as was asked.
bool is_as_asked(const FillAnswer& answer);

/// Worst figures over sides and inner edges.
FillContact worst_of(const Fill& fill);

/// The whole object, schema "blossom.blend/1".
Json fill_report(const Input& input, const FillAnswer& answer);

}  // namespace blossom::reports
