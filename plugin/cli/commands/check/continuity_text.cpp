// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/check/continuity_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

#include "plugin/cli/arguments/values.h"
#include "plugin/cli/arguments/vectors.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/verbosity.h"

namespace blossom::cli {
namespace {

using occt::EdgeContinuity;
using occt::EdgeRole;

/// Edges named one by one in a summary; more are counted, and all of them in the report.
constexpr std::size_t kNamed = 12;

/// A turn by more than this is a face that lies on the other or is turned over; 170 degrees.
constexpr double kFold = 170 * std::numbers::pi / 180;

bool is_smooth(const EdgeContinuity& edge) {
  return edge.found && edge.smoothness >= Smoothness::G1;
}

bool has_normals(const EdgeContinuity& edge) { return edge.found->singular < edge.found->samples; }

bool is_sharp(const EdgeContinuity& edge) {
  return edge.found && edge.smoothness == Smoothness::G0 && has_normals(edge);
}

bool folds_back(const EdgeContinuity& edge) {
  return is_sharp(edge) && edge.found->angle.value > kFold;
}

/// Three digits, as 0.00123 or 1.23e-08.
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

std::string place_text(const EdgeContinuity& edge, const LargestFound& found) {
  const Vec3& p = found.point;
  return edge_text(edge) + " at " + vector_text({rounded(p[0]), rounded(p[1]), rounded(p[2])});
}

/// How much is known: the bound, or how many places were looked at.
std::string certainty_text(const EdgeContinuity& edge, double ContinuityBounds::*member) {
  if (edge.bounds && std::isfinite((*edge.bounds).*member))
    return "at most " + short_text((*edge.bounds).*member);
  return "found at " + std::to_string(edge.found->samples) + " samples and their largest refined";
}

/// A figure of edges and the edge that has most of it, or least.
struct Extreme {
  const EdgeContinuity* edge = nullptr;
  double value = 0;
};

template <class Take, class Value>
Extreme largest_of(const ContinuityReport& report, const Take& take, const Value& value) {
  Extreme most;
  for (const EdgeContinuity& edge : report.edges)
    if (take(edge) && (most.edge == nullptr || value(edge) > most.value))
      most = {&edge, value(edge)};
  return most;
}

void add_gap(const ContinuityReport& report, std::ostringstream& text) {
  const Extreme gap = largest_of(
      report, [](const EdgeContinuity& e) { return e.found.has_value(); },
      [](const EdgeContinuity& e) { return e.found->gap.value; });
  if (gap.edge == nullptr) return;
  text << "  largest gap " << short_text(gap.value) << " mm ("
       << certainty_text(*gap.edge, &ContinuityBounds::gap)
       << "): " << place_text(*gap.edge, gap.edge->found->gap) << "\n";
}

void add_angles(const ContinuityReport& report, std::ostringstream& text) {
  const auto angle = [](const EdgeContinuity& e) { return e.found->angle.value; };
  if (const Extreme most = largest_of(report, is_smooth, angle); most.edge != nullptr)
    text << "  largest angle of G1 and G2 edges " << angle_text(most.value) << " ("
         << certainty_text(*most.edge, &ContinuityBounds::angle)
         << "): " << place_text(*most.edge, most.edge->found->angle) << "\n";
  const Extreme least =
      largest_of(report, is_sharp, [&](const EdgeContinuity& e) { return -angle(e); });
  if (least.edge == nullptr) return;
  const Extreme most = largest_of(report, is_sharp, angle);
  text << "  sharp edges turn by " << angle_text(-least.value);
  if (most.edge == least.edge) {
    text << ": " << place_text(*least.edge, least.edge->found->angle) << "\n";
    return;
  }
  text << " at least: " << place_text(*least.edge, least.edge->found->angle) << "\n    and by "
       << angle_text(most.value) << " at most: " << place_text(*most.edge, most.edge->found->angle)
       << "\n";
}

std::string numbers_text(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), kNamed); ++i)
    text += " " + std::to_string(numbers[i]);
  return text + (numbers.size() > kNamed ? " ... (--json lists all)" : "");
}

void add_folds(const ContinuityReport& report, std::ostringstream& text) {
  std::vector<int> numbers;
  for (const EdgeContinuity& edge : report.edges)
    if (folds_back(edge)) numbers.push_back(edge.number);
  if (!numbers.empty())
    text << "  " << counted(numbers.size(), "edge")
         << " where a face folds back on the other or is turned over:" << numbers_text(numbers)
         << "\n";
}

void add_curvatures(const ContinuityReport& report, std::ostringstream& text) {
  const auto value = [](const EdgeContinuity& e) { return e.found->curvature.value; };
  for (const Smoothness of : {Smoothness::G1, Smoothness::G2}) {
    const Extreme most = largest_of(
        report, [&](const EdgeContinuity& e) { return e.found && e.smoothness == of; }, value);
    if (most.edge == nullptr) continue;
    text << "  largest difference of curvature of " << to_string(of) << " edges "
         << short_text(100 * most.value) << " % (" << short_text(most.edge->found->difference.value)
         << " / mm; " << certainty_text(*most.edge, &ContinuityBounds::curvature)
         << "): " << place_text(*most.edge, most.edge->found->curvature) << "\n";
  }
}

/// "3 open edges, 1 non-manifold edge"; empty if there are none.
std::string others_text(const ContinuityReport& report) {
  std::string text;
  for (const EdgeRole kind :
       {EdgeRole::Open, EdgeRole::NonManifold, EdgeRole::Degenerate, EdgeRole::Inner})
    if (const std::size_t count = report.count(kind); count > 0)
      text += (text.empty() ? "" : ", ") + counted(count, std::string(to_string(kind)) + " edge");
  return text;
}

void add_exceptions(const ContinuityReport& report, std::ostringstream& text) {
  if (const std::string others = others_text(report); !others.empty())
    text << "  not compared: " << others << "\n";
  const auto unmeasured = report.unmeasured();
  for (std::size_t i = 0; i < std::min(unmeasured.size(), kNamed); ++i)
    text << "  " << edge_text(*unmeasured[i]) << " cannot be measured: " << unmeasured[i]->problem
         << "\n";
  if (unmeasured.size() > kNamed)
    text << "  and " << counted(unmeasured.size() - kNamed, "edge") << " more; --json lists all\n";
  const std::vector<int> failing = report.failing();
  const std::string& require = report.require;
  if (!require.empty() && failing.empty())
    text << "  no edge is less than " << require << "\n";
  else if (!failing.empty())
    text << "  less than " << (require.empty() ? "G0" : require) << ": "
         << counted(failing.size(), "edge") << "," << numbers_text(failing) << "\n";
}

std::string class_text(const EdgeContinuity& edge) {
  if (edge.smoothness == Smoothness::None) return "apart";
  if (edge.smoothness != Smoothness::G0) return to_string(edge.smoothness);
  if (!has_normals(edge)) return "G0 (no normals)";
  return (folds_back(edge) ? "G0 (folds back, " : "G0 (sharp, ") +
         angle_text(edge.found->angle.value) + ")";
}

/// "gap 1e-9 (at most 2e-9)".
std::string figure_text(const char* name, double value, const EdgeContinuity& edge,
                        double ContinuityBounds::*member) {
  std::string text = std::string(name) + " " + short_text(value);
  if (edge.bounds && std::isfinite((*edge.bounds).*member))
    text += " (<= " + short_text((*edge.bounds).*member) + ")";
  return text;
}

std::string table_line(const EdgeContinuity& edge) {
  std::string text = "  " + edge_text(edge) + ": ";
  if (!edge.problem.empty()) return text + "cannot be measured: " + edge.problem + "\n";
  if (!edge.found) return text + to_string(edge.kind) + "\n";
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
  return text + "\n";
}

std::string head_text(const std::string& name, const ContinuityReport& report) {
  const std::size_t all = report.count(EdgeRole::Shared) + report.count(EdgeRole::Seam);
  std::ostringstream text;
  text << name << ": " << counted(all, "edge") << " between faces";
  if (const std::size_t seams = report.count(EdgeRole::Seam); seams > 0)
    text << " (" << counted(seams, "seam") << " among them)";
  const char* separator = ": ";
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count == 0) return;
    text << separator << count << " " << what;
    separator = ", ";
  };
  add(report.count("apart"), "apart");
  add(report.count("G0"), "sharp (G0)");
  add(report.count("G1"), "G1");
  add(report.count("G2"), "G2");
  add(report.unmeasured().size(), "not measured");
  text << "\n";
  if (all == 0) {
    text << "  no two faces share an edge: there is nothing to compare\n";
    return text.str();
  }
  const ContinuityTolerances& within = report.tolerances;
  text << "  within gap " << short_text(within.gap) << " mm, angle " << angle_text(within.angle)
       << ", curvature " << short_text(100 * within.curvature) << " %; proven for "
       << report.proven() << " of " << all << "\n";
  return text.str();
}

}  // namespace

std::string edge_line(const EdgeContinuity& edge) {
  const std::string line = table_line(edge);
  return line.substr(2, line.size() - 3);  // without indent and end of line
}

std::string continuity_text(const std::string& name, const ContinuityReport& report,
                            bool has_picture) {
  std::ostringstream text;
  text << head_text(name, report);
  add_gap(report, text);
  add_angles(report, text);
  add_folds(report, text);
  add_curvatures(report, text);
  add_exceptions(report, text);
  if (has_picture)
    text << "  colours: sharp black, G1 orange, G2 green, apart purple, not compared red\n";
  if (report.table || verbosity() == Verbosity::Verbose)
    for (const EdgeContinuity& edge : report.edges) text << table_line(edge);
  return text.str();
}

}  // namespace blossom::cli
