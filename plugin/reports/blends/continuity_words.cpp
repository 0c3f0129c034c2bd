// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/blends/continuity_words.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "plugin/reports/text/json.h"

namespace blossom::reports {

using occt::EdgeContinuity;
using occt::EdgeRole;

namespace {

// A turn by more than this is a face that lies on the other or is turned over; 170 degrees.
constexpr double kFold = 170 * std::numbers::pi / 180;

bool has_normals(const EdgeContinuity& edge) { return edge.found->singular < edge.found->samples; }

}  // namespace

bool is_smooth(const EdgeContinuity& edge) {
  return edge.found && edge.smoothness >= Smoothness::G1;
}

bool is_sharp(const EdgeContinuity& edge) {
  return edge.found && edge.smoothness == Smoothness::G0 && has_normals(edge);
}

bool folds_back(const EdgeContinuity& edge) {
  return is_sharp(edge) && edge.found->angle.value > kFold;
}

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string angle_text(double radians) {
  std::string text = short_text(radians) + " rad";
  if (radians >= 1e-3) text += " (" + short_text(radians * 180 / std::numbers::pi) + " degrees)";
  return text;
}

std::string edge_text(const EdgeContinuity& edge) {
  std::string text = "edge " + std::to_string(edge.number);
  if (edge.kind == EdgeRole::Seam)
    return text + " (seam of face " + std::to_string(edge.faces.front()) + ")";
  text += " (faces";
  for (const int face : edge.faces) text += " " + std::to_string(face);
  return text + ")";
}

namespace {

std::string class_text(const EdgeContinuity& edge) {
  if (edge.smoothness == Smoothness::None) return "apart";
  if (edge.smoothness != Smoothness::G0) return to_string(edge.smoothness);
  if (!has_normals(edge)) return "G0 (no normals)";
  return (folds_back(edge) ? "G0 (folds back, " : "G0 (sharp, ") +
         angle_text(edge.found->angle.value) + ")";
}

// "gap 1e-9 (at most 2e-9)".
std::string figure_text(const char* name, double value, const EdgeContinuity& edge,
                        double ContinuityBounds::*member) {
  std::string text = std::string(name) + " " + short_text(value);
  if (edge.bounds && std::isfinite((*edge.bounds).*member))
    text += " (<= " + short_text((*edge.bounds).*member) + ")";
  return text;
}

}  // namespace

std::string edge_line(const EdgeContinuity& edge) {
  std::string text = edge_text(edge) + ": ";
  if (!edge.problem.empty()) return text + "cannot be measured: " + edge.problem;
  if (!edge.found) return text + to_string(edge.kind);
  const MeasuredContinuity& found = *edge.found;
  text += class_text(edge) + (edge.proven ? ", proven" : "");
  text += ", " + figure_text("gap", found.gap.value, edge, &ContinuityBounds::gap);
  if (is_smooth(edge)) {
    text += ", " + figure_text("angle", found.angle.value, edge, &ContinuityBounds::angle);
    text +=
        ", " + figure_text("curvature", found.curvature.value, edge, &ContinuityBounds::curvature);
  }
  if (!edge.bounds) text += "; " + std::to_string(found.samples) + " samples: " + edge.no_bounds;
  if (found.singular > 0)
    text += "; no tangent plane at " + counted(static_cast<std::size_t>(found.singular), "sample");
  return text;
}

}  // namespace blossom::reports
