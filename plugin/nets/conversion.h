// SPDX-License-Identifier: LGPL-2.1-or-later
// Nets and faces in other forms, and what is told of them; see plugin/cli/schemas/conversion-1.md.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plugin/nets/pieces.h"
#include "plugin/nets/trimmed_nets.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::nets {

enum class TargetForm { AsItIs, Bezier, Monomial, Triangles };

/// "bezier", "monomial" or "triangles"; nothing of any other word.
std::optional<TargetForm> target_form(const std::string& word);

struct Conversion {
  std::vector<Net> nets{};         ///< empty if a model was written as it is
  std::size_t faces = 0;           ///< of the model
  std::size_t trims_left_out = 0;  ///< faces that lost their trims
  std::vector<TrimmedNets>
      trimmed{};  ///< faces whose trims were to be followed, without their nets
  double seconds = 0;

  double largest_error() const;
};

/// Nets in a form.
Conversion converted(const std::vector<Net>& nets, TargetForm form, const Stop& stop);

/// The nets of a model's chosen faces in a form. Bezier and triangles follow the trims where these
/// can be followed, and have all of the surface elsewhere.
/// tolerance   how far borders may lie from trims, model units
Conversion converted_faces(const reports::Input& model, const std::vector<Net>& nets,
                           TargetForm form, double tolerance, const Stop& stop);

/// The whole object, schema "blossom.conversion/1".
/// to   the form's word; empty if forms stay
reports::Json conversion_report(const std::string& input, const std::string& output,
                                const std::string& to, const Conversion& made,
                                reports::Json repairs);

}  // namespace blossom::nets
