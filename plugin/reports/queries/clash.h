// SPDX-License-Identifier: LGPL-2.1-or-later
// How pairs of parts lie to each other; see plugin/cli/schemas/clash-1.md.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/clash.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/models/parts.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

struct ClashAnswer {
  std::vector<const Input*> inputs;  ///< one, or two of which pairs have one part each
  std::vector<NamedPart> parts;      ///< of all inputs
  std::size_t first_of_b = 0;        ///< place of the second input's first part; 0: there is none
  std::optional<double> clearance;
  double tolerance = 0;
  /// Reports have pairs of which only the boxes were looked at, too: the square of the parts.
  bool lists_far = false;
  occt::Clashes found;
  double seconds = 0;
};

/// Adds the parts of a model; with a second one, pairs have one part of each.
void add_input(ClashAnswer& answer, const Input& input);

/// Compares the parts, `found`.
/// throws   BadModel if there are fewer than two, or one cannot be measured
void look_for_clashes(ClashAnswer& answer, const IntersectionOptions& engine);

/// A pair that is told: one that was looked at, or one of which only the boxes were.
struct ClashRow {
  std::size_t a = 0, b = 0;
  const occt::Clash* clash = nullptr;  ///< null: apart, as the boxes are
  double lower = 0;                    ///< bound on the distance, model units
};

/// The name of a part in words: of two models a solid without one has the name of its file.
std::string displayed_name(const ClashAnswer& answer, std::size_t part);

/// How many pairs there are.
std::size_t pair_count(const ClashAnswer& answer);

enum class ClashRows {
  Near,  ///< that were looked at: about as many as there are parts
  All,
};

/// Pairs of the question in order: those that penetrate or hold each other, then those that touch,
/// then those that are clear with a measured distance, then all others.
std::vector<ClashRow> rows_of(const ClashAnswer& answer, ClashRows wanted);

/// "penetrates", "contained", "equal", "touches", "clear", "unknown".
const char* clash_word(const ClashRow& row);

Status status_of(const ClashAnswer& answer);

/// Whether parts have an inside in common, or are nearer to each other than the clearance.
bool is_finding(const ClashRow& row, const std::optional<double>& clearance);

/// The common bodies, each with the names of the parts that have it; no shape if there are none.
occt::Model common_bodies(const ClashAnswer& answer);

/// The whole object, schema "blossom.clash/1".
Json clash_report(const ClashAnswer& answer);

/// The table, with a line of titles.
std::string clash_csv(const ClashAnswer& answer);

/// "6 parts, 15 pairs, 2 penetrates, 13 clear".
std::string counted_pairs(const ClashAnswer& answer);

}  // namespace blossom::reports
